struct type_4 {
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

struct type_6 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: i32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
}

struct type_7 {
    member: type_6,
}

struct type_9 {
    member: array<u32>,
}

struct type_18 {
    member: array<u32, LENGTH_1_4>,
}

struct type_20 {
    member: array<u32, LENGTH_4_4>,
}

struct type_22 {
    member: array<u32, LENGTH_2_4>,
}

@group(0) @binding(7) 
var<uniform> global: type_4;
@group(0) @binding(3) 
var<storage, read_write> global_1: type_7;
@group(0) @binding(1) 
var<storage> global_2: type_18;
@group(0) @binding(4) 
var<storage, read_write> global_3: type_20;
var<workgroup> global_4: array<u32, 256>;
var<workgroup> global_5: array<u32, 128>;
var<workgroup> global_6: array<u32, 8>;
@group(0) @binding(2) 
var<storage> global_7: type_22;
var<workgroup> global_8: array<atomic<u32>, 2048>;

@compute @workgroup_size(128, 1, 1) 
fn main(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>) {
    var local: array<u32, 4>;
    var phi_1237_: u32;
    var phi_1240_: u32;
    var phi_1239_: u32;
    var phi_1289_: u32;
    var phi_1286_: u32;
    var phi_1285_: u32;
    var phi_1290_: u32;
    var phi_1306_: u32;
    var phi_1303_: u32;
    var phi_1296_: u32;
    var phi_1291_: u32;
    var phi_1294_: u32;
    var phi_1300_: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1242_: u32;
    var phi_1241_: u32;
    var local_5: u32;
    var phi_1248_: u32;
    var phi_1243_: u32;
    var local_6: u32;
    var phi_1247_: u32;
    var phi_1244_: u32;
    var phi_1245_: u32;
    var local_7: u32;
    var local_8: u32;
    var local_9: u32;
    var phi_1238_: u32;
    var phi_1249_: u32;
    var phi_1252_: u32;
    var phi_1251_: u32;
    var phi_1250_: u32;
    var phi_687_: bool;
    var phi_1311_: u32;
    var phi_1263_: u32;
    var phi_1254_: u32;
    var phi_1253_: u32;
    var phi_1279_: u32;
    var phi_1280_: u32;
    var local_10: u32;
    var phi_1259_: u32;
    var phi_1258_: u32;
    var phi_1264_: u32;
    var local_11: u32;
    var local_12: u32;
    var local_13: u32;
    var local_14: u32;
    var local_15: u32;
    var local_16: u32;
    var local_17: u32;
    var local_18: u32;
    var local_19: u32;
    var local_20: u32;
    var local_21: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e36 = bitcast<u32>(param[0u]);
            let _e38 = bitcast<u32>(param_1[0u]);
            let _e40 = global.member_7;
            let _e42 = global.member_5;
            let _e43 = min(_e40, _e42);
            let _e46 = max(((_e43 + 4095u) / 4096u), 1u);
            if (_e38 >= _e46) {
                break;
            }
            phi_1237_ = _e36;
            loop {
                let _e49 = phi_1237_;
                if (_e49 < 2048u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    atomicStore((&global_8[_e49]), 0u);
                    phi_1237_ = (_e49 + 128u);
                }
            }
            switch bitcast<i32>(0u) {
                default: {
                    let _e55 = global.member_6;
                    if !((_e55 != 0u)) {
                        phi_1240_ = 0u;
                        phi_1239_ = 0u;
                        loop {
                            let _e59 = phi_1240_;
                            let _e61 = phi_1239_;
                            local_4 = _e59;
                            local_9 = _e59;
                            if (_e61 < 2u) {
                                let _e64 = ((_e36 * 2u) + _e61);
                                phi_1289_ = 0u;
                                phi_1286_ = 0u;
                                phi_1285_ = 0u;
                                loop {
                                    let _e66 = phi_1289_;
                                    let _e68 = phi_1286_;
                                    let _e70 = phi_1285_;
                                    local_1 = _e68;
                                    local_2 = _e68;
                                    local_3 = _e66;
                                    if (_e70 < _e46) {
                                        phi_1290_ = 0u;
                                        loop {
                                            let _e73 = phi_1290_;
                                            if (_e73 < 4u) {
                                                let _e75 = (_e70 + _e73);
                                                if (_e75 < _e46) {
                                                    let _e81 = global_7.member[((_e75 * 256u) + _e64)];
                                                    phi_1306_ = _e81;
                                                } else {
                                                    phi_1306_ = 0u;
                                                }
                                                let _e83 = phi_1306_;
                                                local[_e73] = _e83;
                                                continue;
                                            } else {
                                                break;
                                            }
                                            continuing {
                                                phi_1290_ = (_e73 + bitcast<u32>(1i));
                                            }
                                        }
                                        phi_1303_ = _e66;
                                        phi_1296_ = _e68;
                                        phi_1291_ = 0u;
                                        loop {
                                            let _e88 = phi_1303_;
                                            let _e90 = phi_1296_;
                                            let _e92 = phi_1291_;
                                            local_12 = _e88;
                                            local_13 = _e90;
                                            if (_e92 < 4u) {
                                                let _e95 = ((_e70 + _e92) < _e38);
                                                if _e95 {
                                                    let _e97 = local[_e92];
                                                    phi_1294_ = _e97;
                                                } else {
                                                    phi_1294_ = 0u;
                                                }
                                                let _e99 = phi_1294_;
                                                local_15 = (_e90 + _e99);
                                                if _e95 {
                                                    phi_1300_ = 0u;
                                                } else {
                                                    let _e102 = local[_e92];
                                                    phi_1300_ = _e102;
                                                }
                                                let _e104 = phi_1300_;
                                                local_14 = (_e88 + _e104);
                                                continue;
                                            } else {
                                                break;
                                            }
                                            continuing {
                                                let _e347 = local_14;
                                                phi_1303_ = _e347;
                                                let _e350 = local_15;
                                                phi_1296_ = _e350;
                                                phi_1291_ = (_e92 + bitcast<u32>(1i));
                                            }
                                        }
                                        continue;
                                    } else {
                                        break;
                                    }
                                    continuing {
                                        let _e338 = local_12;
                                        phi_1289_ = _e338;
                                        let _e341 = local_13;
                                        phi_1286_ = _e341;
                                        phi_1285_ = (_e70 + 4u);
                                    }
                                }
                                let _e110 = local_1;
                                global_4[_e64] = (_e110 + _e59);
                                let _e114 = local_2;
                                let _e116 = local_3;
                                local_11 = (_e59 + (_e114 + _e116));
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e334 = local_11;
                                phi_1240_ = _e334;
                                phi_1239_ = (_e61 + bitcast<u32>(1i));
                            }
                        }
                        let _e123 = local_4;
                        global_5[_e36] = _e123;
                        workgroupBarrier();
                        if (_e36 < 8u) {
                            phi_1242_ = 0u;
                            phi_1241_ = 0u;
                            loop {
                                let _e126 = phi_1242_;
                                let _e128 = phi_1241_;
                                local_5 = _e126;
                                if (_e128 < 16u) {
                                    continue;
                                } else {
                                    break;
                                }
                                continuing {
                                    let _e133 = global_5[((_e36 * 16u) + _e128)];
                                    phi_1242_ = (_e126 + _e133);
                                    phi_1241_ = (_e128 + bitcast<u32>(1i));
                                }
                            }
                            let _e139 = local_5;
                            global_6[_e36] = _e139;
                        }
                        workgroupBarrier();
                        phi_1248_ = 0u;
                        phi_1243_ = 0u;
                        loop {
                            let _e141 = phi_1248_;
                            let _e143 = phi_1243_;
                            let _e144 = (_e36 / 16u);
                            local_6 = _e144;
                            local_16 = _e141;
                            if (_e143 < _e144) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e147 = global_6[_e143];
                                phi_1248_ = (_e141 + _e147);
                                phi_1243_ = (_e143 + bitcast<u32>(1i));
                            }
                        }
                        let _e152 = local_6;
                        let _e366 = local_16;
                        phi_1247_ = _e366;
                        phi_1244_ = (_e152 * 16u);
                        loop {
                            let _e155 = phi_1247_;
                            let _e157 = phi_1244_;
                            local_7 = _e155;
                            local_8 = _e155;
                            if (_e157 < _e36) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e160 = global_5[_e157];
                                phi_1247_ = (_e155 + _e160);
                                phi_1244_ = (_e157 + bitcast<u32>(1i));
                            }
                        }
                        phi_1245_ = 0u;
                        loop {
                            let _e165 = phi_1245_;
                            if (_e165 < 2u) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e170 = global_4[((_e36 * 2u) + _e165)];
                                let _e172 = local_7;
                                global_4[((_e36 * 2u) + _e165)] = (_e170 + _e172);
                                phi_1245_ = (_e165 + bitcast<u32>(1i));
                            }
                        }
                        workgroupBarrier();
                        let _e177 = local_8;
                        let _e179 = local_9;
                        let _e180 = (_e177 + _e179);
                        if ((true && (_e38 == 0u)) && (_e36 == 127u)) {
                            global_1.member.member_6 = _e180;
                            global_1.member.member_1 = ((_e180 + 127u) / 128u);
                        }
                        break;
                    }
                    phi_1238_ = 0u;
                    loop {
                        let _e192 = phi_1238_;
                        if (_e192 < 2u) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e195 = (_e36 * 2u);
                            let _e200 = global_7.member[(((_e38 * 256u) + _e195) + _e192)];
                            global_4[(_e195 + _e192)] = _e200;
                            phi_1238_ = (_e192 + bitcast<u32>(1i));
                        }
                    }
                    workgroupBarrier();
                    break;
                }
            }
            let _e205 = (_e36 / 32u);
            let _e208 = (1u << bitcast<u32>((_e36 & 31u)));
            let _e212 = min(_e43, ((_e38 + 1u) * 4096u));
            let _e213 = (_e38 * 4096u);
            let _e214 = (_e213 + _e36);
            if (_e214 < _e212) {
                let _e220 = global_2.member[(_e214 >> bitcast<u32>(1u))];
                let _e225 = ((_e220 >> bitcast<u32>((16u * (_e214 & 1u)))) & 65535u);
                phi_1249_ = select(_e225, 4294967295u, (_e225 == 65535u));
            } else {
                phi_1249_ = 0u;
            }
            let _e229 = phi_1249_;
            phi_1252_ = _e229;
            phi_1251_ = 0u;
            phi_1250_ = _e213;
            loop {
                let _e231 = phi_1252_;
                let _e233 = phi_1251_;
                let _e235 = phi_1250_;
                if (_e235 < _e212) {
                    let _e237 = (_e235 + _e36);
                    let _e239 = ((_e233 & 1u) * 1024u);
                    let _e240 = (_e231 & 255u);
                    let _e241 = (_e237 < _e212);
                    phi_687_ = _e241;
                    if _e241 {
                        phi_687_ = (false || (_e231 != 4294967295u));
                    }
                    let _e245 = phi_687_;
                    let _e246 = (_e237 + 128u);
                    phi_1311_ = _e231;
                    if (_e246 < _e212) {
                        let _e252 = global_2.member[(_e246 >> bitcast<u32>(1u))];
                        let _e257 = ((_e252 >> bitcast<u32>((16u * (_e246 & 1u)))) & 65535u);
                        phi_1311_ = select(_e257, 4294967295u, (_e257 == 65535u));
                    }
                    let _e261 = phi_1311_;
                    local_17 = _e261;
                    if _e245 {
                        let _e266 = atomicOr((&global_8[((_e239 + (_e205 * 256u)) + _e240)]), _e208);
                    }
                    workgroupBarrier();
                    phi_1259_ = 0u;
                    phi_1258_ = 0u;
                    if _e245 {
                        phi_1263_ = 0u;
                        phi_1254_ = 0u;
                        phi_1253_ = 0u;
                        loop {
                            let _e268 = phi_1263_;
                            let _e270 = phi_1254_;
                            let _e272 = phi_1253_;
                            local_10 = _e270;
                            local_20 = _e268;
                            local_21 = _e270;
                            if (_e272 < 4u) {
                                let _e278 = atomicLoad((&global_8[((_e239 + (_e272 * 256u)) + _e240)]));
                                let _e280 = bitcast<u32>(countOneBits(_e278));
                                local_18 = (_e268 + _e280);
                                if (_e272 < _e205) {
                                    phi_1280_ = _e280;
                                } else {
                                    if (_e272 == _e205) {
                                        phi_1279_ = bitcast<u32>(countOneBits((_e278 & (_e208 - 1u))));
                                    } else {
                                        phi_1279_ = 0u;
                                    }
                                    let _e288 = phi_1279_;
                                    phi_1280_ = _e288;
                                }
                                let _e290 = phi_1280_;
                                local_19 = (_e270 + _e290);
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e383 = local_18;
                                phi_1263_ = _e383;
                                let _e386 = local_19;
                                phi_1254_ = _e386;
                                phi_1253_ = (_e272 + bitcast<u32>(1i));
                            }
                        }
                        let _e295 = global_4[_e240];
                        let _e297 = local_10;
                        global_3.member[(_e295 + _e297)] = (((((_e231 >> bitcast<u32>(8u)) << bitcast<u32>(24u)) >> bitcast<u32>(24u)) << bitcast<u32>(24u)) | _e237);
                        let _e393 = local_20;
                        phi_1259_ = _e393;
                        let _e396 = local_21;
                        phi_1258_ = _e396;
                    }
                    let _e311 = phi_1259_;
                    let _e313 = phi_1258_;
                    workgroupBarrier();
                    if (_e245 && (_e313 == 0u)) {
                        let _e317 = global_4[_e240];
                        global_4[_e240] = (_e317 + _e311);
                        phi_1264_ = 0u;
                        loop {
                            let _e320 = phi_1264_;
                            if (_e320 < 4u) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                atomicStore((&global_8[((_e239 + (_e320 * 256u)) + _e240)]), 0u);
                                phi_1264_ = (_e320 + bitcast<u32>(1i));
                            }
                        }
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e376 = local_17;
                    phi_1252_ = _e376;
                    phi_1251_ = (_e233 + bitcast<u32>(1i));
                    phi_1250_ = (_e235 + 128u);
                }
            }
            break;
        }
    }
    return;
}
