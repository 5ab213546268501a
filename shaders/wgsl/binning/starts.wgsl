struct type_8 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_12 {
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
    member_56: array<type_8, 8>,
    member_57: array<vec4<f32>, 128>,
    member_58: array<vec4<f32>, 768>,
}

struct type_15 {
    member: array<u32>,
}

struct type_17 {
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
    member_15: f32,
}

struct type_19 {
    member: array<u32, LENGTH_1_4>,
}

struct type_21 {
    member: array<u32, LENGTH_3_4>,
}

struct type_23 {
    member: array<u32, LENGTH_2_4>,
}

@group(0) @binding(0) 
var<uniform> global: type_12;
@group(0) @binding(1) 
var<storage> global_1: type_19;
@group(0) @binding(3) 
var<storage> global_2: type_21;
@group(0) @binding(2) 
var<storage, read_write> global_3: type_23;
@group(0) @binding(7) 
var<uniform> global_4: type_17;

@compute @workgroup_size(128, 1, 1) 
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
    var phi_209_: u32;
    var phi_208_: u32;
    var phi_210_: u32;
    var local: u32;
    var local_1: u32;
    var local_2: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e16 = bitcast<u32>(param[0u]);
            let _e19 = global_3.member[8i];
            let _e21 = global.member_46;
            let _e25 = global.member_4;
            let _e27 = vec2((_e21 << bitcast<u32>(_e19)));
            let _e30 = (((vec2<u32>(_e25) + _e27) - vec2<u32>(1u, 1u)) / _e27);
            if (_e16 > (_e30.x * _e30.y)) {
                break;
            }
            let _e37 = global_3.member[6i];
            phi_209_ = _e37;
            phi_208_ = 0u;
            loop {
                let _e39 = phi_209_;
                let _e41 = phi_208_;
                local = _e41;
                if (_e41 < _e39) {
                    let _e44 = ((_e41 + _e39) / 2u);
                    let _e47 = global_1.member[_e44];
                    let _e52 = global_2.member[(_e47 >> bitcast<u32>(1u))];
                    let _e58 = (((_e52 >> bitcast<u32>((16u * (_e47 & 1u)))) & 65535u) < _e16);
                    if _e58 {
                        phi_210_ = (_e44 + 1u);
                    } else {
                        phi_210_ = _e41;
                    }
                    let _e61 = phi_210_;
                    local_1 = select(_e44, _e39, _e58);
                    local_2 = _e61;
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e72 = local_1;
                    phi_209_ = _e72;
                    let _e75 = local_2;
                    phi_208_ = _e75;
                }
            }
            let _e64 = global_4.member_12;
            let _e69 = local;
            global_3.member[(_e64 + _e16)] = _e69;
            break;
        }
    }
    return;
}
