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
    var phi_822_: u32;
    var phi_823_: u32;
    var phi_824_: u32;
    var phi_604_: bool;
    var phi_827_: u32;
    var phi_830_: u32;
    var phi_825_: u32;
    var phi_826_: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e25 = bitcast<u32>(param[0u]);
            let _e27 = bitcast<u32>(param_1[0u]);
            let _e28 = (_e27 * 256u);
            let _e31 = global_2.member.member_6;
            if (_e28 >= _e31) {
                break;
            }
            phi_822_ = _e25;
            loop {
                let _e34 = phi_822_;
                if (_e34 < 10u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    atomicStore((&global_4[_e34]), 0u);
                    phi_822_ = (_e34 + 128u);
                }
            }
            workgroupBarrier();
            phi_823_ = 0u;
            loop {
                let _e42 = phi_823_;
                if (_e42 < 10u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    local[_e42] = 0u;
                    phi_823_ = (_e42 + bitcast<u32>(1i));
                }
            }
            phi_824_ = (_e28 + _e25);
            loop {
                let _e49 = phi_824_;
                if (_e49 < min(((_e27 + 1u) * 256u), _e31)) {
                    let _e55 = global_1.member[((_e31 - 1u) - _e49)];
                    let _e58 = global_3.member[_e55];
                    let _e63 = global.member_10;
                    let _e67 = global.member_5;
                    let _e69 = ((vec2<f32>((_e58.xy & vec2<u32>(1048575u, 1048575u))) / vec2(_e63)) - vec2(_e67));
                    let _e71 = unpack2x16float(_e58.z);
                    let _e80 = global.member_30;
                    let _e83 = global.member_29;
                    let _e91 = (unpack2x16float(_e58.w).x * inverseSqrt(dot(_e71, _e71)));
                    let _e94 = _e71.yx;
                    let _e99 = (sqrt(((_e71 * _e71) + ((_e94 * (_e91 * _e91)) * _e94))) * sqrt((2f * log(max((max(f32(((_e58.w >> bitcast<u32>(16u)) & 255u)), _e80) / _e83), 1f)))));
                    let _e100 = (_e69 - _e99);
                    let _e101 = (_e69 + _e99);
                    let _e103 = global.member_46;
                    let _e105 = global.member_4;
                    let _e107 = vec2(_e103);
                    let _e112 = vec2<f32>(((((vec2<u32>(_e105) + _e107) - vec2<u32>(1u, 1u)) / _e107) - vec2<u32>(1u, 1u)));
                    let _e114 = vec2(f32(_e103));
                    let _e122 = all((_e100 < _e105));
                    phi_604_ = _e122;
                    if _e122 {
                        phi_604_ = all((_e101 > vec2<f32>(0f, 0f)));
                    }
                    let _e126 = phi_604_;
                    phi_827_ = 0u;
                    loop {
                        let _e129 = phi_827_;
                        if (_e129 < 10u) {
                            let _e131 = vec2(_e129);
                            let _e137 = (((vec2<u32>(clamp((_e101 / _e114), vec2<f32>(0f, 0f), _e112)) >> bitcast<vec2<u32>>(_e131)) - (vec2<u32>(clamp((_e100 / _e114), vec2<f32>(0f, 0f), _e112)) >> bitcast<vec2<u32>>(_e131))) + vec2<u32>(1u, 1u));
                            if !(_e126) {
                                phi_830_ = 0u;
                            } else {
                                phi_830_ = (_e137.x * _e137.y);
                            }
                            let _e142 = phi_830_;
                            let _e144 = local[_e129];
                            local[_e129] = (_e144 + _e142);
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            phi_827_ = (_e129 + bitcast<u32>(1i));
                        }
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_824_ = (_e49 + 128u);
                }
            }
            phi_825_ = 0u;
            loop {
                let _e150 = phi_825_;
                if (_e150 < 10u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e154 = local[_e150];
                    let _e155 = atomicAdd((&global_4[_e150]), _e154);
                    phi_825_ = (_e150 + bitcast<u32>(1i));
                }
            }
            workgroupBarrier();
            phi_826_ = _e25;
            loop {
                let _e159 = phi_826_;
                if (_e159 < 10u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e162 = global_6.member_11;
                    let _e167 = atomicLoad((&global_4[_e159]));
                    global_5.member[((_e162 + (_e27 * 10u)) + _e159)] = (_e167 + (_e167 & 1u));
                    phi_826_ = (_e159 + 128u);
                }
            }
            break;
        }
    }
    return;
}
