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

struct type_24 {
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

struct type_26 {
    member: array<u32, LENGTH_1_4>,
}

struct type_28 {
    member: array<vec4<u32>, LENGTH_2_16>,
}

struct type_30 {
    member: array<u32, LENGTH_4_4>,
}

struct type_32 {
    member: array<u32, LENGTH_5_4>,
}

@group(0) @binding(0) 
var<uniform> global: type_13;
@group(0) @binding(1) 
var<storage> global_1: type_26;
@group(0) @binding(3) 
var<storage> global_2: type_18;
@group(0) @binding(2) 
var<storage> global_3: type_28;
var<workgroup> global_4: array<u32, 256>;
var<workgroup> global_5: array<u32, 256>;
var<workgroup> global_6: array<u32, 256>;
var<workgroup> global_7: array<u32, 256>;
@group(0) @binding(4) 
var<storage, read_write> global_8: type_30;
@group(0) @binding(7) 
var<uniform> global_9: type_24;
@group(0) @binding(5) 
var<storage, read_write> global_10: type_32;

@compute @workgroup_size(128, 1, 1) 
fn main(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>) {
    var local: array<u32, 2>;
    var phi_1271_: u32;
    var phi_819_: bool;
    var phi_1298_: u32;
    var phi_1302_: u32;
    var phi_1272_: u32;
    var phi_1292_: u32;
    var phi_1296_: u32;
    var phi_1293_: u32;
    var phi_1273_: u32;
    var phi_1275_: u32;
    var phi_1274_: u32;
    var local_1: u32;
    var local_2: u32;
    var phi_1276_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1279_: u32;
    var phi_1278_: u32;
    var phi_1284_: u32;
    var phi_1283_: u32;
    var local_6: u32;
    var local_7: u32;
    var phi_1285_: u32;
    var local_8: u32;
    var local_9: u32;
    var local_10: u32;
    var phi_1288_: u32;
    var phi_1287_: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e36 = bitcast<u32>(param[0u]);
            let _e38 = bitcast<u32>(param_1[0u]);
            let _e39 = (_e38 * 256u);
            let _e42 = global_2.member.member_6;
            if (_e39 >= _e42) {
                break;
            }
            let _e46 = global_8.member[8i];
            phi_1271_ = _e36;
            loop {
                let _e48 = phi_1271_;
                if (_e48 < 256u) {
                    let _e50 = (_e39 + _e48);
                    global_5[_e48] = 1u;
                    phi_1302_ = 0u;
                    if (_e50 < _e42) {
                        let _e57 = global_1.member[((_e42 - 1u) - _e50)];
                        let _e60 = global_3.member[_e57];
                        let _e65 = global.member_10;
                        let _e69 = global.member_5;
                        let _e78 = (((vec2<f32>((_e60.xy & vec2<u32>(1048575u, 1048575u))) / vec2(_e65)) - vec2(_e69)) * bitcast<f32>((((_e60.y >> bitcast<u32>(30u)) * 50331648u) + 1065353216u)));
                        let _e80 = unpack2x16float(_e60.z);
                        let _e89 = global.member_30;
                        let _e92 = global.member_29;
                        let _e100 = (unpack2x16float(_e60.w).x * inverseSqrt(dot(_e80, _e80)));
                        let _e103 = _e80.yx;
                        let _e108 = (sqrt(((_e80 * _e80) + ((_e103 * (_e100 * _e100)) * _e103))) * sqrt((2f * log(max((max(f32(((_e60.w >> bitcast<u32>(16u)) & 255u)), _e89) / _e92), 1f)))));
                        let _e109 = (_e78 - _e108);
                        let _e110 = (_e78 + _e108);
                        let _e112 = global.member_46;
                        let _e114 = global.member_4;
                        let _e116 = vec2(_e112);
                        let _e121 = vec2<f32>(((((vec2<u32>(_e114) + _e116) - vec2<u32>(1u, 1u)) / _e116) - vec2<u32>(1u, 1u)));
                        let _e123 = vec2(f32(_e112));
                        let _e129 = vec2<u32>(clamp((_e110 / _e123), vec2<f32>(0f, 0f), _e121));
                        let _e131 = all((_e109 < _e114));
                        phi_819_ = _e131;
                        if _e131 {
                            phi_819_ = all((_e110 > vec2<f32>(0f, 0f)));
                        }
                        let _e135 = phi_819_;
                        let _e137 = vec2(_e46);
                        let _e141 = (vec2<u32>(clamp((_e109 / _e123), vec2<f32>(0f, 0f), _e121)) >> bitcast<vec2<u32>>(_e137));
                        let _e143 = (((_e129 >> bitcast<vec2<u32>>(_e137)) - _e141) + vec2<u32>(1u, 1u));
                        if !(_e135) {
                            phi_1298_ = 0u;
                        } else {
                            phi_1298_ = (_e143.x * _e143.y);
                        }
                        let _e148 = phi_1298_;
                        global_7[_e48] = _e57;
                        global_6[_e48] = (_e141.x | (_e141.y << bitcast<u32>(16u)));
                        global_5[_e48] = (((_e129.x >> bitcast<u32>(_e46)) - _e141.x) + 1u);
                        phi_1302_ = _e148;
                    }
                    let _e162 = phi_1302_;
                    global_4[_e48] = _e162;
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_1271_ = (_e48 + 128u);
                }
            }
            workgroupBarrier();
            phi_1272_ = 1u;
            loop {
                let _e166 = phi_1272_;
                if (_e166 < 256u) {
                    phi_1292_ = 0u;
                    loop {
                        let _e169 = phi_1292_;
                        if (_e169 < 2u) {
                            let _e172 = ((_e169 * 128u) + _e36);
                            if (_e172 >= _e166) {
                                let _e176 = global_4[(_e172 - _e166)];
                                phi_1296_ = _e176;
                            } else {
                                phi_1296_ = 0u;
                            }
                            let _e178 = phi_1296_;
                            local[_e169] = _e178;
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            phi_1292_ = (_e169 + bitcast<u32>(1i));
                        }
                    }
                    workgroupBarrier();
                    phi_1293_ = 0u;
                    loop {
                        let _e183 = phi_1293_;
                        if (_e183 < 2u) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e188 = local[_e183];
                            let _e190 = global_4[((_e183 * 128u) + _e36)];
                            global_4[((_e183 * 128u) + _e36)] = (_e190 + _e188);
                            phi_1293_ = (_e183 + bitcast<u32>(1i));
                        }
                    }
                    workgroupBarrier();
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_1272_ = (_e166 * 2u);
                }
            }
            let _e196 = global.member_46;
            let _e200 = global.member_4;
            let _e202 = vec2((_e196 << bitcast<u32>(_e46)));
            let _e208 = global_9.member_11;
            let _e213 = global_8.member[(_e208 + (_e38 * 10u))];
            let _e215 = global_4[255i];
            phi_1273_ = (2u * _e36);
            loop {
                let _e220 = phi_1273_;
                if (_e220 < (_e215 + (_e215 & 1u))) {
                    switch bitcast<i32>(0u) {
                        default: {
                            let _e223 = global_4[255i];
                            if (_e220 >= _e223) {
                                phi_1279_ = 65535u;
                                phi_1278_ = 0u;
                                break;
                            }
                            phi_1275_ = 0u;
                            phi_1274_ = 128u;
                            loop {
                                let _e226 = phi_1275_;
                                let _e228 = phi_1274_;
                                local_1 = _e226;
                                local_2 = _e226;
                                local_3 = _e226;
                                local_4 = _e226;
                                local_5 = _e226;
                                if (_e228 > 0u) {
                                    continue;
                                } else {
                                    break;
                                }
                                continuing {
                                    let _e233 = global_4[((_e226 + _e228) - 1u)];
                                    phi_1275_ = (_e226 + select(0u, _e228, (_e233 <= _e220)));
                                    phi_1274_ = (_e228 / 2u);
                                }
                            }
                            let _e239 = local_1;
                            if (_e239 > 0u) {
                                let _e242 = local_2;
                                let _e245 = global_4[(_e242 - 1u)];
                                phi_1276_ = _e245;
                            } else {
                                phi_1276_ = 0u;
                            }
                            let _e247 = phi_1276_;
                            let _e248 = (_e220 - _e247);
                            let _e250 = local_3;
                            let _e252 = global_5[_e250];
                            let _e253 = (_e248 / _e252);
                            let _e255 = local_4;
                            let _e257 = global_6[_e255];
                            let _e260 = global_5[_e250];
                            let _e263 = global_6[_e255];
                            let _e270 = local_5;
                            let _e272 = global_7[_e270];
                            phi_1279_ = ((((_e263 >> bitcast<u32>(16u)) + _e253) * (((vec2<u32>(_e200) + _e202) - vec2<u32>(1u, 1u)) / _e202).x) + (((_e257 & 65535u) + _e248) - (_e253 * _e260)));
                            phi_1278_ = _e272;
                            break;
                        }
                    }
                    let _e274 = phi_1279_;
                    let _e276 = phi_1278_;
                    let _e277 = (_e220 + 1u);
                    switch bitcast<i32>(0u) {
                        default: {
                            let _e279 = global_4[255i];
                            if (_e277 >= _e279) {
                                phi_1288_ = 65535u;
                                phi_1287_ = 0u;
                                break;
                            }
                            phi_1284_ = 0u;
                            phi_1283_ = 128u;
                            loop {
                                let _e282 = phi_1284_;
                                let _e284 = phi_1283_;
                                local_6 = _e282;
                                local_7 = _e282;
                                local_8 = _e282;
                                local_9 = _e282;
                                local_10 = _e282;
                                if (_e284 > 0u) {
                                    continue;
                                } else {
                                    break;
                                }
                                continuing {
                                    let _e289 = global_4[((_e282 + _e284) - 1u)];
                                    phi_1284_ = (_e282 + select(0u, _e284, (_e289 <= _e277)));
                                    phi_1283_ = (_e284 / 2u);
                                }
                            }
                            let _e295 = local_6;
                            if (_e295 > 0u) {
                                let _e298 = local_7;
                                let _e301 = global_4[(_e298 - 1u)];
                                phi_1285_ = _e301;
                            } else {
                                phi_1285_ = 0u;
                            }
                            let _e303 = phi_1285_;
                            let _e304 = (_e277 - _e303);
                            let _e306 = local_8;
                            let _e308 = global_5[_e306];
                            let _e309 = (_e304 / _e308);
                            let _e311 = local_9;
                            let _e313 = global_6[_e311];
                            let _e316 = global_5[_e306];
                            let _e319 = global_6[_e311];
                            let _e326 = local_10;
                            let _e328 = global_7[_e326];
                            phi_1288_ = ((((_e319 >> bitcast<u32>(16u)) + _e309) * (((vec2<u32>(_e200) + _e202) - vec2<u32>(1u, 1u)) / _e202).x) + (((_e313 & 65535u) + _e304) - (_e309 * _e316)));
                            phi_1287_ = _e328;
                            break;
                        }
                    }
                    let _e330 = phi_1288_;
                    let _e332 = phi_1287_;
                    let _e334 = global_9.member_13;
                    let _e336 = ((_e334 + _e213) + _e220);
                    global_8.member[_e336] = _e276;
                    global_8.member[(_e336 + 1u)] = _e332;
                    global_10.member[((_e213 + _e220) / 2u)] = (_e274 | (_e330 << bitcast<u32>(16u)));
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_1273_ = (_e220 + 256u);
                }
            }
            break;
        }
    }
    return;
}
