struct type_8 {
    member: vec4<f32>,
}

@group(0) @binding(0) 
var global: texture_2d<f32>;
var<private> global_1: vec4<f32>;
@group(0) @binding(1) 
var<uniform> global_2: type_8;
var<private> global_3: vec4<f32>;

fn function_() {
    let _e6 = global_1;
    let _e9 = textureLoad(global, vec2<i32>(_e6.xy), 0i);
    let _e14 = global_2.member;
    let _e17 = (_e9.xyz + (_e14.xyz * (1f - _e9.w)));
    global_3 = vec4<f32>(_e17.x, _e17.y, _e17.z, 1f);
    return;
}

@fragment 
fn main(@builtin(position) param: vec4<f32>) -> @location(0) vec4<f32> {
    global_1 = param;
    function_();
    let _e3 = global_3;
    return _e3;
}
