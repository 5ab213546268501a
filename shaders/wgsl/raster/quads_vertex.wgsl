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
    var phi_504_: f32;
    var phi_505_: f32;

    switch bitcast<i32>(0u) {
        default: {
            let _e43 = global_2;
            let _e46 = global_3;
            let _e49 = ((bitcast<u32>(_e43) * 128u) + (bitcast<u32>(_e46) / 4u));
            global_4.member = vec4<f32>(-2f, -2f, 0f, 1f);
            let _e53 = global_5.member.member_6;
            if (_e49 >= _e53) {
                break;
            }
            let _e57 = global_6.member[_e49];
            let _e60 = global_1.member[_e57];
            let _e65 = unpack2x16float(_e60.z);
            let _e94 = log2((f32(((_e60.w >> bitcast<u32>(16u)) & 255u)) * 0.003921569f));
            let _e96 = global_7.member_1;
            let _e99 = global_7.member;
            let _e101 = sqrt((max(_e94, _e96) - _e99));
            if ((_e46 & 1i) == 0i) {
                phi_504_ = -(_e101);
            } else {
                phi_504_ = _e101;
            }
            let _e106 = phi_504_;
            if ((_e46 & 2i) == 0i) {
                phi_505_ = -(_e101);
            } else {
                phi_505_ = _e101;
            }
            let _e111 = phi_505_;
            global_8 = vec2<f32>(_e106, _e111);
            let _e123 = global.member_13[2u];
            let _e128 = global.member_13[3u];
            let _e130 = global_8[0u];
            let _e133 = global_8[1u];
            let _e139 = global.member_13;
            let _e142 = ((((vec2<f32>((_e60.xy & vec2<u32>(1048575u, 1048575u))) - vec2(_e123)) + (((_e65 * _e130) + ((vec2<f32>(-(_e65.y), _e65.x) * (inverseSqrt(dot(_e65, _e65)) * unpack2x16float(_e60.w).x)) * _e133)) * _e128)) * _e139.xy) - vec2<f32>(1f, 1f));
            global_4.member[0u] = _e142.x;
            global_4.member[1u] = _e142.y;
            let _e151 = (round(((vec3<f32>(f32(((_e60.x >> bitcast<u32>(20u)) & 1023u)), f32(((_e60.y >> bitcast<u32>(20u)) & 1023u)), f32((((_e60.w >> bitcast<u32>(24u)) << bitcast<u32>(2u)) | (_e60.x >> bitcast<u32>(30u))))) * vec3<f32>(0.0009775171f, 0.0009775171f, 0.0009775171f)) * 2048f)) * vec3<f32>(0.00048828125f, 0.00048828125f, 0.00048828125f));
            global_9 = vec2<u32>(pack2x16float(_e151.xy), pack2x16float(vec2<f32>(_e151.z, _e94)));
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
