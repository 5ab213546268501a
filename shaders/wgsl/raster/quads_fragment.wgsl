struct type_7 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: f32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
    member_8: u32,
    member_9: u32,
    member_10: vec2<u32>,
    member_11: u32,
    member_12: u32,
    member_13: u32,
    member_14: u32,
}

var<private> global: vec2<u32>;
var<private> global_1: vec2<f32>;
@group(0) @binding(7) 
var<uniform> global_2: type_7;
var<private> global_3: vec4<f32>;

fn function_() {
    let _e9 = global[0u];
    let _e10 = unpack2x16float(_e9);
    let _e12 = global[1u];
    let _e13 = unpack2x16float(_e12);
    let _e15 = global_1;
    let _e17 = (_e13.y - dot(_e15, _e15));
    let _e19 = global_2.member;
    if (_e17 < _e19) {
        discard;
    }
    global_3 = vec4<f32>(_e10.x, _e10.y, _e13.x, min(0.99f, exp2(_e17)));
    return;
}

@fragment 
fn main(@location(1) @interpolate(flat) param: vec2<u32>, @location(0) param_1: vec2<f32>) -> @location(0) vec4<f32> {
    global = param;
    global_1 = param_1;
    function_();
    let _e5 = global_3;
    return _e5;
}
