struct type_11 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_15 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
    member_3: vec2<f32>,
    member_4: vec2<f32>,
    member_5: f32,
    member_6: f32,
    member_7: f32,
    member_8: f32,
    member_9: u32,
    member_10: f32,
    member_11: vec4<f32>,
    member_12: vec4<f32>,
    member_13: vec4<f32>,
    member_14: u32,
    member_15: u32,
    member_16: u32,
    member_17: u32,
    member_18: u32,
    member_19: u32,
    member_20: u32,
    member_21: u32,
    member_22: u32,
    member_23: u32,
    member_24: u32,
    member_25: f32,
    member_26: u32,
    member_27: u32,
    member_28: u32,
    member_29: f32,
    member_30: f32,
    member_31: u32,
    member_32: f32,
    member_33: f32,
    member_34: u32,
    member_35: u32,
    member_36: u32,
    member_37: u32,
    member_38: u32,
    member_39: f32,
    member_40: u32,
    member_41: u32,
    member_42: f32,
    member_43: u32,
    member_44: u32,
    member_45: f32,
    member_46: u32,
    member_47: f32,
    member_48: f32,
    member_49: f32,
    member_50: vec4<f32>,
    member_51: vec4<f32>,
    member_52: vec4<f32>,
    member_53: array<vec4<f32>, 3>,
    member_54: array<vec4<u32>, 8>,
    member_55: array<vec4<u32>, 8>,
    member_56: array<type_11, 8>,
    member_57: array<vec4<f32>, 128>,
    member_58: array<vec4<f32>, 768>,
}

struct type_19 {
    member: array<vec4<u32>>,
}

struct type_24 {
    @builtin(position) member: vec4<f32>,
    member_1: f32,
    member_2: array<f32, 1>,
    member_3: array<f32, 1>,
}

struct type_27 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: i32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
}

struct type_28 {
    member: type_27,
}

struct type_31 {
    member: array<u32>,
}

struct type_34 {
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

struct VertexOutput {
    @builtin(position) member: vec4<f32>,
    @location(0) member_1: vec2<f32>,
    @location(1) @interpolate(flat) member_2: vec2<u32>,
}

struct type_41 {
    member: array<vec4<u32>, LENGTH_2_16>,
}

struct type_43 {
    member: array<u32, LENGTH_1_4>,
}

@group(0) @binding(0) 
var<uniform> global: type_15;
@group(0) @binding(2) 
var<storage> global_1: type_41;
var<private> global_2: i32;
var<private> global_3: i32;
var<private> global_4: type_24 = type_24(vec4<f32>(0f, 0f, 0f, 1f), 1f, array<f32, 1>(), array<f32, 1>());
@group(0) @binding(3) 
var<storage> global_5: type_28;
@group(0) @binding(1) 
var<storage> global_6: type_43;
@group(0) @binding(7) 
var<uniform> global_7: type_34;
var<private> global_8: vec2<f32>;
var<private> global_9: vec2<u32>;

fn function_() {
    var phi_550_: f32;
    var phi_551_: f32;

    switch bitcast<i32>(0u) {
        default: {
            let _e45 = global_2;
            let _e48 = global_3;
            let _e51 = ((bitcast<u32>(_e45) * 128u) + (bitcast<u32>(_e48) / 4u));
            global_4.member = vec4<f32>(-2f, -2f, 0f, 1f);
            let _e55 = global_5.member.member_6;
            if (_e51 >= _e55) {
                break;
            }
            let _e59 = global_6.member[_e51];
            let _e62 = global_1.member[_e59];
            let _e73 = unpack2x16float(_e62.z);
            let _e101 = log2((f32(((_e62.w >> bitcast<u32>(16u)) & 255u)) * 0.003921569f));
            let _e103 = global_7.member_1;
            let _e106 = global_7.member;
            let _e108 = sqrt((max(_e101, _e103) - _e106));
            if ((_e48 & 1i) == 0i) {
                phi_550_ = -(_e108);
            } else {
                phi_550_ = _e108;
            }
            let _e113 = phi_550_;
            if ((_e48 & 2i) == 0i) {
                phi_551_ = -(_e108);
            } else {
                phi_551_ = _e108;
            }
            let _e118 = phi_551_;
            global_8 = vec2<f32>(_e113, _e118);
            let _e130 = global.member_13[2u];
            let _e136 = global.member_13[3u];
            let _e138 = global_8[0u];
            let _e141 = global_8[1u];
            let _e147 = global.member_13;
            let _e150 = (((((vec2<f32>((_e62.xy & vec2<u32>(1048575u, 1048575u))) - vec2(_e130)) * bitcast<f32>((((_e62.y >> bitcast<u32>(30u)) * 50331648u) + 1065353216u))) + (((_e73 * _e138) + ((vec2<f32>(-(_e73.y), _e73.x) * (inverseSqrt(dot(_e73, _e73)) * unpack2x16float(_e62.w).x)) * _e141)) * _e136)) * _e147.xy) - vec2<f32>(1f, 1f));
            global_4.member[0u] = _e150.x;
            global_4.member[1u] = _e150.y;
            let _e159 = (round(((vec3<f32>(f32(((_e62.x >> bitcast<u32>(20u)) & 1023u)), f32(((_e62.y >> bitcast<u32>(20u)) & 1023u)), f32((((_e62.w >> bitcast<u32>(24u)) << bitcast<u32>(2u)) | (_e62.x >> bitcast<u32>(30u))))) * vec3<f32>(0.0009775171f, 0.0009775171f, 0.0009775171f)) * 2048f)) * vec3<f32>(0.00048828125f, 0.00048828125f, 0.00048828125f));
            global_9 = vec2<u32>(pack2x16float(_e159.xy), pack2x16float(vec2<f32>(_e159.z, _e101)));
            break;
        }
    }
    return;
}

@vertex 
fn main(@builtin(instance_index) param: u32, @builtin(vertex_index) param_1: u32) -> VertexOutput {
    global_2 = i32(param);
    global_3 = i32(param_1);
    function_();
    let _e11 = global_4.member.y;
    global_4.member.y = -(_e11);
    let _e13 = global_4.member;
    let _e14 = global_8;
    let _e15 = global_9;
    return VertexOutput(_e13, _e14, _e15);
}
