struct type_9 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_13 {
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
    member_56: array<type_9, 8>,
    member_57: array<vec4<f32>, 128>,
    member_58: array<vec4<f32>, 768>,
}

struct type_16 {
    member: array<u32>,
}

struct type_17 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: i32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
}

struct type_18 {
    member: type_17,
}

struct type_20 {
    member: array<vec4<u32>>,
}

struct type_21 {
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

struct type_26 {
    member: array<u32, LENGTH_1_4>,
}

struct type_28 {
    member: array<vec4<u32>, LENGTH_2_16>,
}

struct type_30 {
    member: array<u32, LENGTH_4_4>,
}

@group(0) @binding(0) 
var<uniform> global: type_13;
@group(0) @binding(1) 
var<storage> global_1: type_26;
@group(0) @binding(3) 
var<storage> global_2: type_18;
@group(0) @binding(2) 
var<storage> global_3: type_28;
@group(0) @binding(7) 
var<uniform> global_4: type_21;
var<workgroup> global_5: array<atomic<u32>, 10>;
@group(0) @binding(4) 
var<storage, read_write> global_6: type_30;

@compute @workgroup_size(128, 1, 1) 
fn main(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>) {
    var phi_799_: u32;
    var phi_800_: u32;
    var phi_581_: bool;
    var phi_802_: u32;
    var phi_805_: u32;
    var phi_801_: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e24 = bitcast<u32>(param[0u]);
            let _e26 = bitcast<u32>(param_1[0u]);
            let _e27 = (_e26 * 256u);
            let _e30 = global_2.member.member_6;
            if (_e27 >= _e30) {
                break;
            }
            phi_799_ = _e24;
            loop {
                let _e33 = phi_799_;
                if (_e33 < 10u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    atomicStore((&global_5[_e33]), 0u);
                    phi_799_ = (_e33 + 128u);
                }
            }
            workgroupBarrier();
            phi_800_ = (_e27 + _e24);
            loop {
                let _e42 = phi_800_;
                if (_e42 < min(((_e26 + 1u) * 256u), _e30)) {
                    let _e48 = global_1.member[((_e30 - 1u) - _e42)];
                    let _e51 = global_3.member[_e48];
                    let _e56 = global.member_10;
                    let _e60 = global.member_5;
                    let _e62 = ((vec2<f32>((_e51.xy & vec2<u32>(1048575u, 1048575u))) / vec2(_e56)) - vec2(_e60));
                    let _e64 = unpack2x16float(_e51.z);
                    let _e73 = global.member_30;
                    let _e76 = global.member_29;
                    let _e84 = (unpack2x16float(_e51.w).x * inverseSqrt(dot(_e64, _e64)));
                    let _e87 = _e64.yx;
                    let _e94 = global_4.member_15;
                    let _e96 = ((sqrt(((_e64 * _e64) + ((_e87 * (_e84 * _e84)) * _e87))) * sqrt((2f * log(max((max(f32(((_e51.w >> bitcast<u32>(16u)) & 255u)), _e73) / _e76), 1f))))) + vec2(_e94));
                    let _e97 = (_e62 - _e96);
                    let _e98 = (_e62 + _e96);
                    let _e100 = global.member_46;
                    let _e102 = global.member_4;
                    let _e104 = vec2(_e100);
                    let _e109 = vec2<f32>(((((vec2<u32>(_e102) + _e104) - vec2<u32>(1u, 1u)) / _e104) - vec2<u32>(1u, 1u)));
                    let _e111 = vec2(f32(_e100));
                    let _e119 = all((_e97 < _e102));
                    phi_581_ = _e119;
                    if _e119 {
                        phi_581_ = all((_e98 > vec2<f32>(0f, 0f)));
                    }
                    let _e123 = phi_581_;
                    phi_802_ = 0u;
                    loop {
                        let _e126 = phi_802_;
                        if (_e126 < 10u) {
                            let _e129 = vec2(_e126);
                            let _e135 = (((vec2<u32>(clamp((_e98 / _e111), vec2<f32>(0f, 0f), _e109)) >> bitcast<vec2<u32>>(_e129)) - (vec2<u32>(clamp((_e97 / _e111), vec2<f32>(0f, 0f), _e109)) >> bitcast<vec2<u32>>(_e129))) + vec2<u32>(1u, 1u));
                            if !(_e123) {
                                phi_805_ = 0u;
                            } else {
                                phi_805_ = (_e135.x * _e135.y);
                            }
                            let _e140 = phi_805_;
                            let _e141 = atomicAdd((&global_5[_e126]), _e140);
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            phi_802_ = (_e126 + bitcast<u32>(1i));
                        }
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_800_ = (_e42 + 128u);
                }
            }
            workgroupBarrier();
            phi_801_ = _e24;
            loop {
                let _e146 = phi_801_;
                if (_e146 < 10u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e149 = global_4.member_11;
                    let _e154 = atomicLoad((&global_5[_e146]));
                    global_6.member[((_e149 + (_e26 * 10u)) + _e146)] = (_e154 + (_e154 & 1u));
                    phi_801_ = (_e146 + 128u);
                }
            }
            break;
        }
    }
    return;
}
