struct type_7 {
    member: array<u32>,
}

struct type_20 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_24 {
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
    member_32: vec2<f32>,
    member_33: vec2<f32>,
    member_34: f32,
    member_35: u32,
    member_36: f32,
    member_37: f32,
    member_38: u32,
    member_39: u32,
    member_40: u32,
    member_41: u32,
    member_42: u32,
    member_43: f32,
    member_44: u32,
    member_45: u32,
    member_46: f32,
    member_47: vec4<f32>,
    member_48: vec4<f32>,
    member_49: array<vec4<f32>, 3>,
    member_50: array<vec4<u32>, 8>,
    member_51: array<vec4<u32>, 8>,
    member_52: array<type_20, 8>,
    member_53: array<vec4<f32>, 128>,
    member_54: array<vec4<f32>, 768>,
}

struct type_33 {
    member: array<vec2<u32>>,
}

@group(0) @binding(3) 
var<storage> global: type_7;
var<private> global_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_2: type_24;
var<workgroup> global_3: array<f32, 256>;
@group(0) @binding(2) 
var<storage> global_4: type_7;
@group(0) @binding(4) 
var<storage, read_write> global_5: type_7;
var<private> global_6: vec3<u32>;
@group(0) @binding(1) 
var<storage> global_7: type_33;

fn function_() {
    var local: vec3<f32>;
    var local_1: vec4<f32>;
    var phi_691_: u32;
    var phi_692_: u32;
    var phi_699_: u32;
    var phi_703_: f32;
    var phi_702_: u32;
    var phi_711_: vec4<f32>;
    var local_2: f32;
    var local_3: u32;
    var phi_693_: u32;
    var phi_694_: u32;
    var phi_696_: u32;
    var local_4: u32;
    var local_5: f32;

    switch bitcast<i32>(0u) {
        default: {
            let _e49 = global_6[0u];
            let _e56 = global_2.member_50[(_e49 / 128u)][((_e49 / 32u) & 3u)];
            if (((_e56 >> bitcast<u32>((_e49 & 31u))) & 1u) != 0u) {
                break;
            }
            let _e63 = global_2.member_27;
            let _e64 = (_e49 * _e63);
            let _e66 = global_2.member_17;
            let _e67 = (_e49 < _e66);
            if _e67 {
                let _e72 = global_2.member_52[0i].member;
                phi_691_ = _e72;
            } else {
                let _e74 = global_2.member_35;
                phi_691_ = _e74;
            }
            let _e76 = phi_691_;
            phi_692_ = 0u;
            loop {
                let _e78 = phi_692_;
                let _e80 = global_2.member_26;
                local_3 = _e80;
                if (_e78 < _e80) {
                    let _e84 = global_2.member_52[_e78];
                    let _e90 = ((_e78 & 1u) * 128u);
                    let _e91 = (128u - _e90);
                    let _e95 = global_1[0u];
                    phi_699_ = _e95;
                    loop {
                        let _e97 = phi_699_;
                        if (_e97 < _e84.member_1) {
                            let _e104 = global_7.member[((_e64 + _e84.member_3) + (_e97 / 4u))];
                            let _e106 = unpack2x16float(_e104.x);
                            let _e108 = unpack2x16float(_e104.y);
                            local_1 = vec4<f32>(_e106.x, _e106.y, _e108.x, _e108.y);
                            let _e116 = local_1[(_e97 & 3u)];
                            let _e119 = (_e78 == 0u);
                            phi_703_ = _e116;
                            phi_702_ = 0u;
                            loop {
                                let _e122 = phi_703_;
                                let _e124 = phi_702_;
                                local_2 = _e122;
                                if (_e124 < select(_e84.member, _e76, _e119)) {
                                    if _e119 {
                                        let _e129 = global_2.member_53[(select(64u, 0u, _e67) + _e124)];
                                        phi_711_ = _e129;
                                    } else {
                                        let _e131 = (_e90 + (4u * _e124));
                                        let _e133 = global_3[_e131];
                                        let _e136 = global_3[(_e131 + 1u)];
                                        let _e139 = global_3[(_e131 + 2u)];
                                        let _e142 = global_3[(_e131 + 3u)];
                                        phi_711_ = vec4<f32>(_e133, _e136, _e139, _e142);
                                    }
                                    let _e145 = phi_711_;
                                    let _e150 = global_7.member[(((_e64 + _e84.member_2) + _e97) + (_e124 * _e84.member_1))];
                                    let _e152 = unpack2x16float(_e150.x);
                                    let _e154 = unpack2x16float(_e150.y);
                                    local_5 = (_e122 + dot(vec4<f32>(_e152.x, _e152.y, _e154.x, _e154.y), _e145));
                                    continue;
                                } else {
                                    break;
                                }
                                continuing {
                                    let _e298 = local_5;
                                    phi_703_ = _e298;
                                    phi_702_ = (_e124 + bitcast<u32>(1i));
                                }
                            }
                            let _e165 = local_2;
                            let _e166 = clamp(_e165, -65504f, 65504f);
                            if ((_e78 + 1u) == _e80) {
                                let _e168 = global_2.member_44;
                                let _e170 = global_2.member_19;
                                global_5.member[((4u * (_e168 + (_e49 * _e170))) + _e97)] = bitcast<u32>(_e166);
                                global_3[(_e91 + _e97)] = _e166;
                            } else {
                                let _e182 = global_2.member_25;
                                global_3[(_e91 + _e97)] = max(_e166, (_e182 * _e166));
                            }
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            phi_699_ = (_e97 + 64u);
                        }
                    }
                    workgroupBarrier();
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_692_ = (_e78 + bitcast<u32>(1i));
                }
            }
            let _e190 = local_3;
            let _e194 = global_2.member_20;
            let _e199 = global.member[_e49];
            let _e201 = global_1[0u];
            phi_693_ = (_e199 + _e201);
            loop {
                let _e204 = phi_693_;
                let _e208 = global.member[(_e49 + 1u)];
                if (_e204 < _e208) {
                    local = vec3<f32>(0f, 0f, 0f);
                    phi_694_ = 0u;
                    loop {
                        let _e211 = phi_694_;
                        let _e213 = global_2.member_18;
                        local_4 = _e213;
                        if (_e211 < _e213) {
                            let _e216 = ((((_e190 & 1u) * 128u) + (4u * _e194)) + (4u * _e211));
                            let _e218 = global_3[_e216];
                            let _e221 = global_3[(_e216 + 1u)];
                            let _e224 = global_3[(_e216 + 2u)];
                            let _e227 = global_3[(_e216 + 3u)];
                            phi_696_ = 0u;
                            loop {
                                let _e230 = phi_696_;
                                if (_e230 < 3u) {
                                    continue;
                                } else {
                                    break;
                                }
                                continuing {
                                    let _e235 = global_2.member_15;
                                    let _e240 = global_4.member[((((_e230 * _e213) + _e211) * _e235) + _e204)];
                                    let _e244 = local[_e230];
                                    local[_e230] = (_e244 + dot(unpack4x8snorm(_e240), vec4<f32>(_e218, _e221, _e224, _e227)));
                                    phi_696_ = (_e230 + bitcast<u32>(1i));
                                }
                            }
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            phi_694_ = (_e211 + bitcast<u32>(1i));
                        }
                    }
                    let _e251 = local_4;
                    let _e254 = global_2.member_15;
                    let _e256 = (2u * _e204);
                    let _e257 = (((3u * _e251) * _e254) + _e256);
                    let _e261 = global_4.member[(_e257 + 1u)];
                    let _e262 = unpack2x16float(_e261);
                    let _e265 = global_4.member[_e257];
                    let _e266 = unpack2x16float(_e265);
                    let _e273 = local;
                    let _e276 = clamp((vec3<f32>(_e266.x, _e266.y, _e262.x) + (_e273 * (127f * _e262.y))), vec3<f32>(-65504f, -65504f, -65504f), vec3<f32>(65504f, 65504f, 65504f));
                    local = _e276;
                    let _e278 = global_2.member_21;
                    let _e280 = ((4u * _e278) + _e256);
                    global_5.member[_e280] = pack2x16float(_e276.xy);
                    let _e287 = local[2u];
                    global_5.member[(_e280 + 1u)] = pack2x16float(vec2<f32>(_e287, 0f));
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_693_ = (_e204 + 64u);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn main(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>) {
    global_1 = param;
    global_6 = param_1;
    function_();
}
