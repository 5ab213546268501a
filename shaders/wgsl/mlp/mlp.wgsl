struct type_6 {
    member: array<vec2<u32>>,
}

struct type_10 {
    member: array<u32>,
}

struct type_16 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_20 {
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
    member_56: array<type_16, 8>,
    member_57: array<vec4<f32>, 128>,
    member_58: array<vec4<f32>, 768>,
}

struct type_22 {
    member: array<vec2<u32>, LENGTH_1_8>,
}

struct type_24 {
    member: array<u32, LENGTH_3_4>,
}

struct type_26 {
    member: array<u32, LENGTH_2_4>,
}

struct type_28 {
    member: array<u32, LENGTH_4_4>,
}

@group(0) @binding(1) 
var<storage> global: type_22;
var<workgroup> global_1: array<f32, 256>;
@group(0) @binding(3) 
var<storage> global_2: type_24;
@group(0) @binding(0) 
var<uniform> global_3: type_20;
@group(0) @binding(2) 
var<storage> global_4: type_26;
@group(0) @binding(4) 
var<storage, read_write> global_5: type_28;

@compute @workgroup_size(64, 1, 1) 
fn main(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>) {
    var local: vec3<f32>;
    var local_1: vec4<f32>;
    var phi_823_: u32;
    var phi_824_: u32;
    var phi_831_: u32;
    var phi_835_: f32;
    var phi_834_: u32;
    var phi_843_: vec4<f32>;
    var local_2: f32;
    var phi_825_: u32;
    var phi_826_: u32;
    var phi_828_: u32;
    var local_3: u32;
    var local_4: f32;

    switch bitcast<i32>(0u) {
        default: {
            let _e31 = bitcast<u32>(param_1[0u]);
            let _e40 = global_3.member_54[(_e31 >> bitcast<u32>(7u))][((_e31 >> bitcast<u32>(5u)) & 3u)];
            if (((_e40 >> bitcast<u32>((_e31 & 31u))) & 1u) != 0u) {
                break;
            }
            let _e47 = global_3.member_27;
            let _e48 = (_e31 * _e47);
            let _e50 = global_3.member_17;
            let _e51 = (_e31 < _e50);
            if _e51 {
                let _e56 = global_3.member_56[0i].member;
                phi_823_ = _e56;
            } else {
                let _e58 = global_3.member_31;
                phi_823_ = _e58;
            }
            let _e60 = phi_823_;
            let _e62 = global_3.member_26;
            let _e65 = global_2.member[_e31];
            let _e67 = min(_e62, (_e65 | _e62));
            phi_824_ = 0u;
            loop {
                let _e69 = phi_824_;
                if (_e69 < _e67) {
                    let _e73 = global_3.member_56[_e69];
                    let _e79 = ((_e69 & 1u) * 128u);
                    let _e80 = (128u - _e79);
                    phi_831_ = bitcast<u32>(param[0u]);
                    loop {
                        let _e86 = phi_831_;
                        if (_e86 < _e73.member_1) {
                            let _e94 = global.member[((_e48 + _e73.member_3) + (_e86 >> bitcast<u32>(2u)))];
                            let _e96 = unpack2x16float(_e94.x);
                            let _e98 = unpack2x16float(_e94.y);
                            local_1 = vec4<f32>(_e96.x, _e96.y, _e98.x, _e98.y);
                            let _e106 = local_1[(_e86 & 3u)];
                            let _e109 = (_e69 == 0u);
                            phi_835_ = _e106;
                            phi_834_ = 0u;
                            loop {
                                let _e112 = phi_835_;
                                let _e114 = phi_834_;
                                local_2 = _e112;
                                if (_e114 < select(_e73.member, _e60, _e109)) {
                                    if _e109 {
                                        let _e119 = global_3.member_57[(select(64u, 0u, _e51) + _e114)];
                                        phi_843_ = _e119;
                                    } else {
                                        let _e121 = (_e79 + (4u * _e114));
                                        let _e123 = global_1[_e121];
                                        let _e126 = global_1[(_e121 + 1u)];
                                        let _e129 = global_1[(_e121 + 2u)];
                                        let _e132 = global_1[(_e121 + 3u)];
                                        phi_843_ = vec4<f32>(_e123, _e126, _e129, _e132);
                                    }
                                    let _e135 = phi_843_;
                                    let _e140 = global.member[(((_e48 + _e73.member_2) + _e86) + (_e114 * _e73.member_1))];
                                    let _e142 = unpack2x16float(_e140.x);
                                    let _e144 = unpack2x16float(_e140.y);
                                    local_4 = (_e112 + dot(vec4<f32>(_e142.x, _e142.y, _e144.x, _e144.y), _e135));
                                    continue;
                                } else {
                                    break;
                                }
                                continuing {
                                    let _e285 = local_4;
                                    phi_835_ = _e285;
                                    phi_834_ = (_e114 + bitcast<u32>(1i));
                                }
                            }
                            let _e155 = local_2;
                            let _e156 = clamp(_e155, -65504f, 65504f);
                            if ((_e69 + 1u) == _e67) {
                                let _e158 = global_3.member_40;
                                let _e160 = global_3.member_19;
                                global_5.member[((4u * (_e158 + (_e31 * _e160))) + _e86)] = bitcast<u32>(_e156);
                                global_1[(_e80 + _e86)] = _e156;
                            } else {
                                let _e172 = global_3.member_25;
                                global_1[(_e80 + _e86)] = max(_e156, (_e172 * _e156));
                            }
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            phi_831_ = (_e86 + 64u);
                        }
                    }
                    workgroupBarrier();
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_824_ = (_e69 + bitcast<u32>(1i));
                }
            }
            let _e182 = global_3.member_20;
            let _e187 = (_e65 + bitcast<u32>(param[0u]));
            phi_825_ = _e187;
            loop {
                let _e189 = phi_825_;
                let _e193 = global_2.member[(_e31 + 1u)];
                if (_e189 < _e193) {
                    local = vec3<f32>(0f, 0f, 0f);
                    phi_826_ = 0u;
                    loop {
                        let _e196 = phi_826_;
                        let _e198 = global_3.member_18;
                        local_3 = _e198;
                        if (_e196 < min(_e198, (_e187 | _e198))) {
                            let _e203 = ((((_e62 & 1u) * 128u) + (4u * _e182)) + (4u * _e196));
                            let _e205 = global_1[_e203];
                            let _e208 = global_1[(_e203 + 1u)];
                            let _e211 = global_1[(_e203 + 2u)];
                            let _e214 = global_1[(_e203 + 3u)];
                            phi_828_ = 0u;
                            loop {
                                let _e217 = phi_828_;
                                if (_e217 < 3u) {
                                    continue;
                                } else {
                                    break;
                                }
                                continuing {
                                    let _e222 = global_3.member_15;
                                    let _e227 = global_4.member[((((_e217 * _e198) + _e196) * _e222) + _e189)];
                                    let _e231 = local[_e217];
                                    local[_e217] = (_e231 + dot(unpack4x8snorm(_e227), vec4<f32>(_e205, _e208, _e211, _e214)));
                                    phi_828_ = (_e217 + bitcast<u32>(1i));
                                }
                            }
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            phi_826_ = (_e196 + bitcast<u32>(1i));
                        }
                    }
                    let _e238 = local_3;
                    let _e241 = global_3.member_15;
                    let _e243 = (2u * _e189);
                    let _e244 = (((3u * _e238) * _e241) + _e243);
                    let _e248 = global_4.member[(_e244 + 1u)];
                    let _e249 = unpack2x16float(_e248);
                    let _e252 = global_4.member[_e244];
                    let _e253 = unpack2x16float(_e252);
                    let _e260 = local;
                    let _e263 = clamp((vec3<f32>(_e253.x, _e253.y, _e249.x) + (_e260 * (127f * _e249.y))), vec3<f32>(-65504f, -65504f, -65504f), vec3<f32>(65504f, 65504f, 65504f));
                    local = _e263;
                    let _e265 = global_3.member_21;
                    let _e267 = ((4u * _e265) + _e243);
                    global_5.member[_e267] = pack2x16float(_e263.xy);
                    let _e274 = local[2u];
                    global_5.member[(_e267 + 1u)] = pack2x16float(vec2<f32>(_e274, 0f));
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_825_ = (_e189 + 64u);
                }
            }
            break;
        }
    }
    return;
}
