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
    var phi_118_: vec4<f32>;

    let _e21 = global_1;
    let _e25 = textureLoad(global, (vec2<i32>(_e21.xy) / vec2<i32>(2i, 2i)), 0i);
    global_2 = (f32((_e25.x >> bitcast<u32>(16u))) * 0.000015259022f);
    if (_e25.x < 4294901760u) {
        let _e39 = (vec3<f32>((vec3<u32>((_e25.x >> bitcast<u32>(11u)), (_e25.x >> bitcast<u32>(5u)), _e25.x) & vec3<u32>(31u, 63u, 31u))) * vec3<f32>(0.032258064f, 0.015873017f, 0.032258064f));
        phi_118_ = vec4<f32>(_e39.x, _e39.y, _e39.z, 1f);
    } else {
        phi_118_ = vec4<f32>(0f, 0f, 0f, 0f);
    }
    let _e45 = phi_118_;
    global_3 = _e45;
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
