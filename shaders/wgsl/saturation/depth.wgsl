struct FragmentOutput {
    @builtin(frag_depth) member: f32,
    @location(0) member_1: vec4<f32>,
}

@group(0) @binding(1) 
var global: texture_2d<u32>;
var<private> global_1: vec4<f32>;
var<private> global_2: f32 = 0f;
var<private> global_3: vec4<f32>;

fn function_() {
    var phi_190_: vec4<f32>;

    let _e23 = textureDimensions(global, 0i);
    let _e26 = global_1;
    let _e30 = ((vec2<i32>(_e26.xy) + vec2<i32>(1i, 1i)) / vec2<i32>(2i, 2i));
    let _e32 = max((_e30 - vec2<i32>(1i, 1i)), vec2<i32>(0i, 0i));
    let _e33 = min(_e30, (vec2<i32>(_e23) - vec2<i32>(1i, 1i)));
    let _e34 = textureLoad(global, _e32, 0i);
    let _e39 = textureLoad(global, vec2<i32>(_e33.x, _e32.y), 0i);
    let _e44 = textureLoad(global, vec2<i32>(_e32.x, _e33.y), 0i);
    let _e46 = textureLoad(global, _e33, 0i);
    let _e50 = max(max(_e34.x, _e39.x), max(_e44.x, _e46.x));
    global_2 = (f32((_e50 >> bitcast<u32>(16u))) * 0.000015259022f);
    if (_e50 < 4294901760u) {
        let _e67 = (vec3<f32>(f32(((_e50 >> bitcast<u32>(11u)) & 31u)), f32(((_e50 >> bitcast<u32>(5u)) & 63u)), f32((_e50 & 31u))) * vec3<f32>(0.032258064f, 0.015873017f, 0.032258064f));
        phi_190_ = vec4<f32>(_e67.x, _e67.y, _e67.z, 1f);
    } else {
        phi_190_ = vec4<f32>(0f, 0f, 0f, 0f);
    }
    let _e73 = phi_190_;
    global_3 = _e73;
    return;
}

@fragment 
fn main(@builtin(position) param: vec4<f32>) -> FragmentOutput {
    global_1 = param;
    function_();
    let _e4 = global_2;
    let _e5 = global_3;
    return FragmentOutput(_e4, _e5);
}
