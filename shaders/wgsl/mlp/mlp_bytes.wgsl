struct type_4 {
    member: array<u32>,
}

struct type_13 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_17 {
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
    member_56: array<type_13, 8>,
    member_57: array<vec4<f32>, 128>,
    member_58: array<vec4<f32>, 768>,
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

struct type_25 {
    member: array<u32, LENGTH_4_4>,
}

@group(0) @binding(1) 
var<storage> global: type_19;
var<workgroup> global_1: array<f32, 256>;
@group(0) @binding(3) 
var<storage> global_2: type_21;
@group(0) @binding(0) 
var<uniform> global_3: type_17;
@group(0) @binding(2) 
var<storage> global_4: type_23;
@group(0) @binding(4) 
var<storage, read_write> global_5: type_25;

@compute @workgroup_size(64, 1, 1) 
fn main(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>) {
    var local: vec3<f32>;
    var phi_734_: u32;
    var phi_735_: u32;
    var phi_742_: u32;
    var phi_748_: f32;
    var phi_745_: u32;
    var phi_754_: vec4<f32>;
    var local_1: f32;
    var local_2: u32;
    var phi_736_: u32;
    var phi_737_: u32;
    var phi_739_: u32;
    var local_3: u32;
    var local_4: f32;

    switch bitcast<i32>(0u) {
        default: {
            let _e30 = bitcast<u32>(param_1[0u]);
            let _e39 = global_3.member_54[(_e30 >> bitcast<u32>(7u))][((_e30 >> bitcast<u32>(5u)) & 3u)];
            if (((_e39 >> bitcast<u32>((_e30 & 31u))) & 1u) != 0u) {
                break;
            }
            let _e46 = global_3.member_27;
            let _e47 = (_e30 * _e46);
            let _e49 = global_3.member_17;
            let _e50 = (_e30 < _e49);
            if _e50 {
                let _e55 = global_3.member_56[0i].member;
                phi_734_ = _e55;
            } else {
                let _e57 = global_3.member_31;
                phi_734_ = _e57;
            }
            let _e59 = phi_734_;
            phi_735_ = 0u;
            loop {
                let _e61 = phi_735_;
                let _e63 = global_3.member_26;
                local_2 = _e63;
                if (_e61 < _e63) {
                    let _e67 = global_3.member_56[_e61];
                    let _e73 = ((_e61 & 1u) * 128u);
                    let _e74 = (128u - _e73);
                    phi_742_ = bitcast<u32>(param[0u]);
                    loop {
                        let _e80 = phi_742_;
                        if (_e80 < _e67.member_1) {
                            let _e84 = (_e61 == 0u);
                            phi_748_ = 0f;
                            phi_745_ = 0u;
                            loop {
                                let _e87 = phi_748_;
                                let _e89 = phi_745_;
                                local_1 = _e87;
                                if (_e89 < select(_e67.member, _e59, _e84)) {
                                    if _e84 {
                                        let _e94 = global_3.member_57[(select(64u, 0u, _e50) + _e89)];
                                        phi_754_ = _e94;
                                    } else {
                                        let _e96 = (_e73 + (4u * _e89));
                                        let _e98 = global_1[_e96];
                                        let _e101 = global_1[(_e96 + 1u)];
                                        let _e104 = global_1[(_e96 + 2u)];
                                        let _e107 = global_1[(_e96 + 3u)];
                                        phi_754_ = vec4<f32>(_e98, _e101, _e104, _e107);
                                    }
                                    let _e110 = phi_754_;
                                    let _e115 = global.member[(((_e47 + _e67.member_2) + _e80) + (_e89 * _e67.member_1))];
                                    local_4 = (_e87 + dot(unpack4x8snorm(_e115), _e110));
                                    continue;
                                } else {
                                    break;
                                }
                                continuing {
                                    let _e266 = local_4;
                                    phi_748_ = _e266;
                                    phi_745_ = (_e89 + bitcast<u32>(1i));
                                }
                            }
                            let _e125 = global.member[((_e47 + _e67.member_3) + _e80)];
                            let _e126 = unpack2x16float(_e125);
                            let _e131 = local_1;
                            let _e134 = clamp((_e126.x + ((127f * _e126.y) * _e131)), -65504f, 65504f);
                            if ((_e61 + 1u) == _e63) {
                                let _e136 = global_3.member_40;
                                let _e138 = global_3.member_19;
                                global_5.member[((4u * (_e136 + (_e30 * _e138))) + _e80)] = bitcast<u32>(_e134);
                                global_1[(_e74 + _e80)] = _e134;
                            } else {
                                let _e150 = global_3.member_25;
                                global_1[(_e74 + _e80)] = max(_e134, (_e150 * _e134));
                            }
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            phi_742_ = (_e80 + 64u);
                        }
                    }
                    workgroupBarrier();
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_735_ = (_e61 + bitcast<u32>(1i));
                }
            }
            let _e158 = local_2;
            let _e162 = global_3.member_20;
            let _e167 = global_2.member[_e30];
            phi_736_ = (_e167 + bitcast<u32>(param[0u]));
            loop {
                let _e172 = phi_736_;
                let _e176 = global_2.member[(_e30 + 1u)];
                if (_e172 < _e176) {
                    local = vec3<f32>(0f, 0f, 0f);
                    phi_737_ = 0u;
                    loop {
                        let _e179 = phi_737_;
                        let _e181 = global_3.member_18;
                        local_3 = _e181;
                        if (_e179 < _e181) {
                            let _e184 = ((((_e158 & 1u) * 128u) + (4u * _e162)) + (4u * _e179));
                            let _e186 = global_1[_e184];
                            let _e189 = global_1[(_e184 + 1u)];
                            let _e192 = global_1[(_e184 + 2u)];
                            let _e195 = global_1[(_e184 + 3u)];
                            phi_739_ = 0u;
                            loop {
                                let _e198 = phi_739_;
                                if (_e198 < 3u) {
                                    continue;
                                } else {
                                    break;
                                }
                                continuing {
                                    let _e203 = global_3.member_15;
                                    let _e208 = global_4.member[((((_e198 * _e181) + _e179) * _e203) + _e172)];
                                    let _e212 = local[_e198];
                                    local[_e198] = (_e212 + dot(unpack4x8snorm(_e208), vec4<f32>(_e186, _e189, _e192, _e195)));
                                    phi_739_ = (_e198 + bitcast<u32>(1i));
                                }
                            }
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            phi_737_ = (_e179 + bitcast<u32>(1i));
                        }
                    }
                    let _e219 = local_3;
                    let _e222 = global_3.member_15;
                    let _e224 = (2u * _e172);
                    let _e225 = (((3u * _e219) * _e222) + _e224);
                    let _e229 = global_4.member[(_e225 + 1u)];
                    let _e230 = unpack2x16float(_e229);
                    let _e233 = global_4.member[_e225];
                    let _e234 = unpack2x16float(_e233);
                    let _e241 = local;
                    let _e244 = clamp((vec3<f32>(_e234.x, _e234.y, _e230.x) + (_e241 * (127f * _e230.y))), vec3<f32>(-65504f, -65504f, -65504f), vec3<f32>(65504f, 65504f, 65504f));
                    local = _e244;
                    let _e246 = global_3.member_21;
                    let _e248 = ((4u * _e246) + _e224);
                    global_5.member[_e248] = pack2x16float(_e244.xy);
                    let _e255 = local[2u];
                    global_5.member[(_e248 + 1u)] = pack2x16float(vec2<f32>(_e255, 0f));
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_736_ = (_e172 + 64u);
                }
            }
            break;
        }
    }
    return;
}
