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

struct type_20 {
    member: array<vec4<u32>>,
}

struct type_24 {
    member: array<u32>,
}

struct type_28 {
    @builtin(position) member: vec4<f32>,
    member_1: f32,
    member_2: array<f32, 1>,
    member_3: array<f32, 1>,
}

struct type_31 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: i32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
}

struct type_32 {
    member: type_31,
}

struct type_35 {
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

struct type_42 {
    member: array<vec4<u32>, LENGTH_2_16>,
}

struct type_44 {
    member: array<u32, LENGTH_4_4>,
}

struct type_46 {
    member: array<u32, LENGTH_1_4>,
}

@group(0) @binding(0) 
var<uniform> global: type_15;
@group(0) @binding(2) 
var<storage> global_1: type_42;
@group(0) @binding(4) 
var<storage> global_2: type_44;
var<private> global_3: i32;
var<private> global_4: i32;
var<private> global_5: type_28 = type_28(vec4<f32>(0f, 0f, 0f, 1f), 1f, array<f32, 1>(), array<f32, 1>());
@group(0) @binding(3) 
var<storage> global_6: type_32;
@group(0) @binding(1) 
var<storage> global_7: type_46;
@group(0) @binding(7) 
var<uniform> global_8: type_35;
var<private> global_9: vec2<f32>;
var<private> global_10: vec2<u32>;

fn function_() {
    var phi_600_: f32;
    var phi_601_: f32;
    var phi_602_: u32;
    var phi_603_: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e52 = global_3;
            let _e55 = global_4;
            let _e58 = ((bitcast<u32>(_e52) * 128u) + (bitcast<u32>(_e55) / 4u));
            global_5.member = vec4<f32>(-2f, -2f, 0f, 1f);
            let _e62 = global_6.member.member_6;
            if (_e58 >= _e62) {
                break;
            }
            let _e66 = global_7.member[_e58];
            let _e71 = global_2.member[(_e66 >> bitcast<u32>(5u))];
            if !((((_e71 >> bitcast<u32>((_e66 & 31u))) & 1u) != 0u)) {
                break;
            }
            let _e80 = global_1.member[_e66];
            let _e91 = unpack2x16float(_e80.z);
            let _e119 = log2((f32(((_e80.w >> bitcast<u32>(16u)) & 255u)) * 0.003921569f));
            let _e121 = global_8.member_1;
            let _e124 = global_8.member;
            let _e126 = sqrt((max(_e119, _e121) - _e124));
            if ((_e55 & 1i) == 0i) {
                phi_600_ = -(_e126);
            } else {
                phi_600_ = _e126;
            }
            let _e131 = phi_600_;
            if ((_e55 & 2i) == 0i) {
                phi_601_ = -(_e126);
            } else {
                phi_601_ = _e126;
            }
            let _e136 = phi_601_;
            global_9 = vec2<f32>(_e131, _e136);
            let _e148 = global.member_13[2u];
            let _e154 = global.member_13[3u];
            let _e156 = global_9[0u];
            let _e159 = global_9[1u];
            let _e165 = global.member_13;
            let _e168 = (((((vec2<f32>((_e80.xy & vec2<u32>(1048575u, 1048575u))) - vec2(_e148)) * bitcast<f32>((((_e80.y >> bitcast<u32>(30u)) * 50331648u) + 1065353216u))) + (((_e91 * _e156) + ((vec2<f32>(-(_e91.y), _e91.x) * (inverseSqrt(dot(_e91, _e91)) * unpack2x16float(_e80.w).x)) * _e159)) * _e154)) * _e165.xy) - vec2<f32>(1f, 1f));
            global_5.member[0u] = _e168.x;
            global_5.member[1u] = _e168.y;
            let _e176 = global.member_28;
            let _e178 = global.member_35;
            let _e179 = (_e178 != 0u);
            if _e179 {
                phi_602_ = (_e66 >> bitcast<u32>(1u));
            } else {
                phi_602_ = _e66;
            }
            let _e183 = phi_602_;
            let _e184 = (_e176 + _e183);
            let _e191 = global_1.member[(_e184 >> bitcast<u32>(2u))][(_e184 & 3u)];
            if _e179 {
                phi_603_ = ((_e191 >> bitcast<u32>((16u * (_e66 & 1u)))) & 65535u);
            } else {
                phi_603_ = _e191;
            }
            let _e198 = phi_603_;
            let _e201 = global.member_9;
            global_5.member[2u] = (1f - (f32(_e198) / f32(_e201)));
            let _e209 = (round(((vec3<f32>(f32(((_e80.x >> bitcast<u32>(20u)) & 1023u)), f32(((_e80.y >> bitcast<u32>(20u)) & 1023u)), f32((((_e80.w >> bitcast<u32>(24u)) << bitcast<u32>(2u)) | (_e80.x >> bitcast<u32>(30u))))) * vec3<f32>(0.0009775171f, 0.0009775171f, 0.0009775171f)) * 2048f)) * vec3<f32>(0.00048828125f, 0.00048828125f, 0.00048828125f));
            global_10 = vec2<u32>(pack2x16float(_e209.xy), pack2x16float(vec2<f32>(_e209.z, _e119)));
            break;
        }
    }
    return;
}

@vertex 
fn main(@builtin(instance_index) param: u32, @builtin(vertex_index) param_1: u32) -> VertexOutput {
    global_3 = i32(param);
    global_4 = i32(param_1);
    function_();
    let _e11 = global_5.member.y;
    global_5.member.y = -(_e11);
    let _e13 = global_5.member;
    let _e14 = global_9;
    let _e15 = global_10;
    return VertexOutput(_e13, _e14, _e15);
}
