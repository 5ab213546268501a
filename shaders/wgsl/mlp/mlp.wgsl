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
    var phi_782_: u32;
    var phi_783_: u32;
    var phi_790_: u32;
    var phi_794_: f32;
    var phi_793_: u32;
    var phi_802_: vec4<f32>;
    var local_2: f32;
    var local_3: u32;
    var phi_784_: u32;
    var phi_785_: u32;
    var phi_787_: u32;
    var local_4: u32;
    var local_5: f32;

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
                phi_782_ = _e56;
            } else {
                let _e58 = global_3.member_31;
                phi_782_ = _e58;
            }
            let _e60 = phi_782_;
            phi_783_ = 0u;
            loop {
                let _e62 = phi_783_;
                let _e64 = global_3.member_26;
                local_3 = _e64;
                if (_e62 < _e64) {
                    let _e68 = global_3.member_56[_e62];
                    let _e74 = ((_e62 & 1u) * 128u);
                    let _e75 = (128u - _e74);
                    phi_790_ = bitcast<u32>(param[0u]);
                    loop {
                        let _e81 = phi_790_;
                        if (_e81 < _e68.member_1) {
                            let _e89 = global.member[((_e48 + _e68.member_3) + (_e81 >> bitcast<u32>(2u)))];
                            let _e91 = unpack2x16float(_e89.x);
                            let _e93 = unpack2x16float(_e89.y);
                            local_1 = vec4<f32>(_e91.x, _e91.y, _e93.x, _e93.y);
                            let _e101 = local_1[(_e81 & 3u)];
                            let _e104 = (_e62 == 0u);
                            phi_794_ = _e101;
                            phi_793_ = 0u;
                            loop {
                                let _e107 = phi_794_;
                                let _e109 = phi_793_;
                                local_2 = _e107;
                                if (_e109 < select(_e68.member, _e60, _e104)) {
                                    if _e104 {
                                        let _e114 = global_3.member_57[(select(64u, 0u, _e51) + _e109)];
                                        phi_802_ = _e114;
                                    } else {
                                        let _e116 = (_e74 + (4u * _e109));
                                        let _e118 = global_1[_e116];
                                        let _e121 = global_1[(_e116 + 1u)];
                                        let _e124 = global_1[(_e116 + 2u)];
                                        let _e127 = global_1[(_e116 + 3u)];
                                        phi_802_ = vec4<f32>(_e118, _e121, _e124, _e127);
                                    }
                                    let _e130 = phi_802_;
                                    let _e135 = global.member[(((_e48 + _e68.member_2) + _e81) + (_e109 * _e68.member_1))];
                                    let _e137 = unpack2x16float(_e135.x);
                                    let _e139 = unpack2x16float(_e135.y);
                                    local_5 = (_e107 + dot(vec4<f32>(_e137.x, _e137.y, _e139.x, _e139.y), _e130));
                                    continue;
                                } else {
                                    break;
                                }
                                continuing {
                                    let _e283 = local_5;
                                    phi_794_ = _e283;
                                    phi_793_ = (_e109 + bitcast<u32>(1i));
                                }
                            }
                            let _e150 = local_2;
                            let _e151 = clamp(_e150, -65504f, 65504f);
                            if ((_e62 + 1u) == _e64) {
                                let _e153 = global_3.member_40;
                                let _e155 = global_3.member_19;
                                global_5.member[((4u * (_e153 + (_e31 * _e155))) + _e81)] = bitcast<u32>(_e151);
                                global_1[(_e75 + _e81)] = _e151;
                            } else {
                                let _e167 = global_3.member_25;
                                global_1[(_e75 + _e81)] = max(_e151, (_e167 * _e151));
                            }
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            phi_790_ = (_e81 + 64u);
                        }
                    }
                    workgroupBarrier();
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_783_ = (_e62 + bitcast<u32>(1i));
                }
            }
            let _e175 = local_3;
            let _e179 = global_3.member_20;
            let _e184 = global_2.member[_e31];
            phi_784_ = (_e184 + bitcast<u32>(param[0u]));
            loop {
                let _e189 = phi_784_;
                let _e193 = global_2.member[(_e31 + 1u)];
                if (_e189 < _e193) {
                    local = vec3<f32>(0f, 0f, 0f);
                    phi_785_ = 0u;
                    loop {
                        let _e196 = phi_785_;
                        let _e198 = global_3.member_18;
                        local_4 = _e198;
                        if (_e196 < _e198) {
                            let _e201 = ((((_e175 & 1u) * 128u) + (4u * _e179)) + (4u * _e196));
                            let _e203 = global_1[_e201];
                            let _e206 = global_1[(_e201 + 1u)];
                            let _e209 = global_1[(_e201 + 2u)];
                            let _e212 = global_1[(_e201 + 3u)];
                            phi_787_ = 0u;
                            loop {
                                let _e215 = phi_787_;
                                if (_e215 < 3u) {
                                    continue;
                                } else {
                                    break;
                                }
                                continuing {
                                    let _e220 = global_3.member_15;
                                    let _e225 = global_4.member[((((_e215 * _e198) + _e196) * _e220) + _e189)];
                                    let _e229 = local[_e215];
                                    local[_e215] = (_e229 + dot(unpack4x8snorm(_e225), vec4<f32>(_e203, _e206, _e209, _e212)));
                                    phi_787_ = (_e215 + bitcast<u32>(1i));
                                }
                            }
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            phi_785_ = (_e196 + bitcast<u32>(1i));
                        }
                    }
                    let _e236 = local_4;
                    let _e239 = global_3.member_15;
                    let _e241 = (2u * _e189);
                    let _e242 = (((3u * _e236) * _e239) + _e241);
                    let _e246 = global_4.member[(_e242 + 1u)];
                    let _e247 = unpack2x16float(_e246);
                    let _e250 = global_4.member[_e242];
                    let _e251 = unpack2x16float(_e250);
                    let _e258 = local;
                    let _e261 = clamp((vec3<f32>(_e251.x, _e251.y, _e247.x) + (_e258 * (127f * _e247.y))), vec3<f32>(-65504f, -65504f, -65504f), vec3<f32>(65504f, 65504f, 65504f));
                    local = _e261;
                    let _e263 = global_3.member_21;
                    let _e265 = ((4u * _e263) + _e241);
                    global_5.member[_e265] = pack2x16float(_e261.xy);
                    let _e272 = local[2u];
                    global_5.member[(_e265 + 1u)] = pack2x16float(vec2<f32>(_e272, 0f));
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_784_ = (_e189 + 64u);
                }
            }
            break;
        }
    }
    return;
}
