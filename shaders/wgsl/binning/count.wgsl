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

struct type_23 {
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

struct type_27 {
    member: array<u32, LENGTH_1_4>,
}

struct type_29 {
    member: array<vec4<u32>, LENGTH_2_16>,
}

struct type_31 {
    member: array<u32, LENGTH_4_4>,
}

@group(0) @binding(0) 
var<uniform> global: type_13;
@group(0) @binding(1) 
var<storage> global_1: type_27;
@group(0) @binding(3) 
var<storage> global_2: type_18;
@group(0) @binding(2) 
var<storage> global_3: type_29;
var<workgroup> global_4: array<atomic<u32>, 10>;
@group(0) @binding(4) 
var<storage, read_write> global_5: type_31;
@group(0) @binding(7) 
var<uniform> global_6: type_23;

@compute @workgroup_size(128, 1, 1) 
fn main(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>) {
    var local: array<u32, 10>;
    var phi_854_: u32;
    var phi_855_: u32;
    var phi_856_: u32;
    var phi_622_: bool;
    var phi_859_: u32;
    var phi_862_: u32;
    var phi_857_: u32;
    var phi_858_: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e28 = bitcast<u32>(param[0u]);
            let _e30 = bitcast<u32>(param_1[0u]);
            let _e31 = (_e30 * 256u);
            let _e34 = global_2.member.member_6;
            if (_e31 >= _e34) {
                break;
            }
            phi_854_ = _e28;
            loop {
                let _e37 = phi_854_;
                if (_e37 < 10u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    atomicStore((&global_4[_e37]), 0u);
                    phi_854_ = (_e37 + 128u);
                }
            }
            workgroupBarrier();
            phi_855_ = 0u;
            loop {
                let _e45 = phi_855_;
                if (_e45 < 10u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    local[_e45] = 0u;
                    phi_855_ = (_e45 + bitcast<u32>(1i));
                }
            }
            phi_856_ = (_e31 + _e28);
            loop {
                let _e52 = phi_856_;
                if (_e52 < min(((_e30 + 1u) * 256u), _e34)) {
                    let _e58 = global_1.member[((_e34 - 1u) - _e52)];
                    let _e61 = global_3.member[_e58];
                    let _e66 = global.member_10;
                    let _e70 = global.member_5;
                    let _e79 = (((vec2<f32>((_e61.xy & vec2<u32>(1048575u, 1048575u))) / vec2(_e66)) - vec2(_e70)) * bitcast<f32>((((_e61.y >> bitcast<u32>(30u)) * 50331648u) + 1065353216u)));
                    let _e81 = unpack2x16float(_e61.z);
                    let _e90 = global.member_30;
                    let _e93 = global.member_29;
                    let _e101 = (unpack2x16float(_e61.w).x * inverseSqrt(dot(_e81, _e81)));
                    let _e104 = _e81.yx;
                    let _e109 = (sqrt(((_e81 * _e81) + ((_e104 * (_e101 * _e101)) * _e104))) * sqrt((2f * log(max((max(f32(((_e61.w >> bitcast<u32>(16u)) & 255u)), _e90) / _e93), 1f)))));
                    let _e110 = (_e79 - _e109);
                    let _e111 = (_e79 + _e109);
                    let _e113 = global.member_46;
                    let _e115 = global.member_4;
                    let _e117 = vec2(_e113);
                    let _e122 = vec2<f32>(((((vec2<u32>(_e115) + _e117) - vec2<u32>(1u, 1u)) / _e117) - vec2<u32>(1u, 1u)));
                    let _e124 = vec2(f32(_e113));
                    let _e132 = all((_e110 < _e115));
                    phi_622_ = _e132;
                    if _e132 {
                        phi_622_ = all((_e111 > vec2<f32>(0f, 0f)));
                    }
                    let _e136 = phi_622_;
                    phi_859_ = 0u;
                    loop {
                        let _e139 = phi_859_;
                        if (_e139 < 10u) {
                            let _e141 = vec2(_e139);
                            let _e147 = (((vec2<u32>(clamp((_e111 / _e124), vec2<f32>(0f, 0f), _e122)) >> bitcast<vec2<u32>>(_e141)) - (vec2<u32>(clamp((_e110 / _e124), vec2<f32>(0f, 0f), _e122)) >> bitcast<vec2<u32>>(_e141))) + vec2<u32>(1u, 1u));
                            if !(_e136) {
                                phi_862_ = 0u;
                            } else {
                                phi_862_ = (_e147.x * _e147.y);
                            }
                            let _e152 = phi_862_;
                            let _e154 = local[_e139];
                            local[_e139] = (_e154 + _e152);
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            phi_859_ = (_e139 + bitcast<u32>(1i));
                        }
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_856_ = (_e52 + 128u);
                }
            }
            phi_857_ = 0u;
            loop {
                let _e160 = phi_857_;
                if (_e160 < 10u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e164 = local[_e160];
                    let _e165 = atomicAdd((&global_4[_e160]), _e164);
                    phi_857_ = (_e160 + bitcast<u32>(1i));
                }
            }
            workgroupBarrier();
            phi_858_ = _e28;
            loop {
                let _e169 = phi_858_;
                if (_e169 < 10u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e172 = global_6.member_11;
                    let _e177 = atomicLoad((&global_4[_e169]));
                    global_5.member[((_e172 + (_e30 * 10u)) + _e169)] = (_e177 + (_e177 & 1u));
                    phi_858_ = (_e169 + 128u);
                }
            }
            break;
        }
    }
    return;
}
