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
    var phi_184_: vec4<f32>;

    let _e24 = textureDimensions(global, 0i);
    let _e27 = global_1;
    let _e31 = ((vec2<i32>(_e27.xy) + vec2<i32>(1i, 1i)) / vec2<i32>(2i, 2i));
    let _e33 = max((_e31 - vec2<i32>(1i, 1i)), vec2<i32>(0i, 0i));
    let _e34 = min(_e31, (vec2<i32>(_e24) - vec2<i32>(1i, 1i)));
    let _e35 = textureLoad(global, _e33, 0i);
    let _e40 = textureLoad(global, vec2<i32>(_e34.x, _e33.y), 0i);
    let _e45 = textureLoad(global, vec2<i32>(_e33.x, _e34.y), 0i);
    let _e47 = textureLoad(global, _e34, 0i);
    let _e51 = max(max(_e35.x, _e40.x), max(_e45.x, _e47.x));
    global_2 = (f32((_e51 >> bitcast<u32>(16u))) * 0.000015259022f);
    if (_e51 < 4294901760u) {
        let _e64 = (vec3<f32>((vec3<u32>((_e51 >> bitcast<u32>(11u)), (_e51 >> bitcast<u32>(5u)), _e51) & vec3<u32>(31u, 63u, 31u))) * vec3<f32>(0.032258064f, 0.015873017f, 0.032258064f));
        phi_184_ = vec4<f32>(_e64.x, _e64.y, _e64.z, 1f);
    } else {
        phi_184_ = vec4<f32>(0f, 0f, 0f, 0f);
    }
    let _e70 = phi_184_;
    global_3 = _e70;
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
