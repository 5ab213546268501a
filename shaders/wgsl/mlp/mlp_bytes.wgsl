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
    var phi_775_: u32;
    var phi_776_: u32;
    var phi_783_: u32;
    var phi_789_: f32;
    var phi_786_: u32;
    var phi_795_: vec4<f32>;
    var local_1: f32;
    var phi_777_: u32;
    var phi_778_: u32;
    var phi_780_: u32;
    var local_2: u32;
    var local_3: f32;

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
                phi_775_ = _e55;
            } else {
                let _e57 = global_3.member_31;
                phi_775_ = _e57;
            }
            let _e59 = phi_775_;
            let _e61 = global_3.member_26;
            let _e64 = global_2.member[_e30];
            let _e66 = min(_e61, (_e64 | _e61));
            phi_776_ = 0u;
            loop {
                let _e68 = phi_776_;
                if (_e68 < _e66) {
                    let _e72 = global_3.member_56[_e68];
                    let _e78 = ((_e68 & 1u) * 128u);
                    let _e79 = (128u - _e78);
                    phi_783_ = bitcast<u32>(param[0u]);
                    loop {
                        let _e85 = phi_783_;
                        if (_e85 < _e72.member_1) {
                            let _e89 = (_e68 == 0u);
                            phi_789_ = 0f;
                            phi_786_ = 0u;
                            loop {
                                let _e92 = phi_789_;
                                let _e94 = phi_786_;
                                local_1 = _e92;
                                if (_e94 < select(_e72.member, _e59, _e89)) {
                                    if _e89 {
                                        let _e99 = global_3.member_57[(select(64u, 0u, _e50) + _e94)];
                                        phi_795_ = _e99;
                                    } else {
                                        let _e101 = (_e78 + (4u * _e94));
                                        let _e103 = global_1[_e101];
                                        let _e106 = global_1[(_e101 + 1u)];
                                        let _e109 = global_1[(_e101 + 2u)];
                                        let _e112 = global_1[(_e101 + 3u)];
                                        phi_795_ = vec4<f32>(_e103, _e106, _e109, _e112);
                                    }
                                    let _e115 = phi_795_;
                                    let _e120 = global.member[(((_e47 + _e72.member_2) + _e85) + (_e94 * _e72.member_1))];
                                    local_3 = (_e92 + dot(unpack4x8snorm(_e120), _e115));
                                    continue;
                                } else {
                                    break;
                                }
                                continuing {
                                    let _e268 = local_3;
                                    phi_789_ = _e268;
                                    phi_786_ = (_e94 + bitcast<u32>(1i));
                                }
                            }
                            let _e130 = global.member[((_e47 + _e72.member_3) + _e85)];
                            let _e131 = unpack2x16float(_e130);
                            let _e136 = local_1;
                            let _e139 = clamp((_e131.x + ((127f * _e131.y) * _e136)), -65504f, 65504f);
                            if ((_e68 + 1u) == _e66) {
                                let _e141 = global_3.member_40;
                                let _e143 = global_3.member_19;
                                global_5.member[((4u * (_e141 + (_e30 * _e143))) + _e85)] = bitcast<u32>(_e139);
                                global_1[(_e79 + _e85)] = _e139;
                            } else {
                                let _e155 = global_3.member_25;
                                global_1[(_e79 + _e85)] = max(_e139, (_e155 * _e139));
                            }
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            phi_783_ = (_e85 + 64u);
                        }
                    }
                    workgroupBarrier();
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_776_ = (_e68 + bitcast<u32>(1i));
                }
            }
            let _e165 = global_3.member_20;
            let _e170 = (_e64 + bitcast<u32>(param[0u]));
            phi_777_ = _e170;
            loop {
                let _e172 = phi_777_;
                let _e176 = global_2.member[(_e30 + 1u)];
                if (_e172 < _e176) {
                    local = vec3<f32>(0f, 0f, 0f);
                    phi_778_ = 0u;
                    loop {
                        let _e179 = phi_778_;
                        let _e181 = global_3.member_18;
                        local_2 = _e181;
                        if (_e179 < min(_e181, (_e170 | _e181))) {
                            let _e186 = ((((_e61 & 1u) * 128u) + (4u * _e165)) + (4u * _e179));
                            let _e188 = global_1[_e186];
                            let _e191 = global_1[(_e186 + 1u)];
                            let _e194 = global_1[(_e186 + 2u)];
                            let _e197 = global_1[(_e186 + 3u)];
                            phi_780_ = 0u;
                            loop {
                                let _e200 = phi_780_;
                                if (_e200 < 3u) {
                                    continue;
                                } else {
                                    break;
                                }
                                continuing {
                                    let _e205 = global_3.member_15;
                                    let _e210 = global_4.member[((((_e200 * _e181) + _e179) * _e205) + _e172)];
                                    let _e214 = local[_e200];
                                    local[_e200] = (_e214 + dot(unpack4x8snorm(_e210), vec4<f32>(_e188, _e191, _e194, _e197)));
                                    phi_780_ = (_e200 + bitcast<u32>(1i));
                                }
                            }
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            phi_778_ = (_e179 + bitcast<u32>(1i));
                        }
                    }
                    let _e221 = local_2;
                    let _e224 = global_3.member_15;
                    let _e226 = (2u * _e172);
                    let _e227 = (((3u * _e221) * _e224) + _e226);
                    let _e231 = global_4.member[(_e227 + 1u)];
                    let _e232 = unpack2x16float(_e231);
                    let _e235 = global_4.member[_e227];
                    let _e236 = unpack2x16float(_e235);
                    let _e243 = local;
                    let _e246 = clamp((vec3<f32>(_e236.x, _e236.y, _e232.x) + (_e243 * (127f * _e232.y))), vec3<f32>(-65504f, -65504f, -65504f), vec3<f32>(65504f, 65504f, 65504f));
                    local = _e246;
                    let _e248 = global_3.member_21;
                    let _e250 = ((4u * _e248) + _e226);
                    global_5.member[_e250] = pack2x16float(_e246.xy);
                    let _e257 = local[2u];
                    global_5.member[(_e250 + 1u)] = pack2x16float(vec2<f32>(_e257, 0f));
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_777_ = (_e172 + 64u);
                }
            }
            break;
        }
    }
    return;
}
