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
var<storage> global_1: type_7;
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
    var phi_1200_: u32;
    var phi_1203_: u32;
    var phi_1202_: u32;
    var phi_1252_: u32;
    var phi_1249_: u32;
    var phi_1248_: u32;
    var phi_1253_: u32;
    var phi_1269_: u32;
    var phi_1266_: u32;
    var phi_1259_: u32;
    var phi_1254_: u32;
    var phi_1257_: u32;
    var phi_1263_: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1205_: u32;
    var phi_1204_: u32;
    var local_5: u32;
    var phi_1211_: u32;
    var phi_1206_: u32;
    var local_6: u32;
    var phi_1210_: u32;
    var phi_1207_: u32;
    var phi_1208_: u32;
    var local_7: u32;
    var phi_1201_: u32;
    var phi_1212_: u32;
    var phi_1215_: u32;
    var phi_1214_: u32;
    var phi_1213_: u32;
    var phi_1274_: u32;
    var phi_1226_: u32;
    var phi_1217_: u32;
    var phi_1216_: u32;
    var phi_1242_: u32;
    var phi_1243_: u32;
    var local_8: u32;
    var phi_1222_: u32;
    var phi_1221_: u32;
    var phi_1227_: u32;
    var local_9: u32;
    var local_10: u32;
    var local_11: u32;
    var local_12: u32;
    var local_13: u32;
    var local_14: u32;
    var local_15: u32;
    var local_16: u32;
    var local_17: u32;
    var local_18: u32;
    var local_19: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e33 = bitcast<u32>(param[0u]);
            let _e35 = bitcast<u32>(param_1[0u]);
            let _e38 = global_1.member.member_6;
            let _e40 = global.member_5;
            let _e41 = min(_e38, _e40);
            let _e44 = max(((_e41 + 4095u) / 4096u), 1u);
            if (_e35 >= _e44) {
                break;
            }
            phi_1200_ = _e33;
            loop {
                let _e47 = phi_1200_;
                if (_e47 < 2048u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    atomicStore((&global_8[_e47]), 0u);
                    phi_1200_ = (_e47 + 128u);
                }
            }
            switch bitcast<i32>(0u) {
                default: {
                    let _e53 = global.member_6;
                    if !((_e53 != 0u)) {
                        phi_1203_ = 0u;
                        phi_1202_ = 0u;
                        loop {
                            let _e57 = phi_1203_;
                            let _e59 = phi_1202_;
                            local_4 = _e57;
                            if (_e59 < 2u) {
                                let _e62 = ((_e33 * 2u) + _e59);
                                phi_1252_ = 0u;
                                phi_1249_ = 0u;
                                phi_1248_ = 0u;
                                loop {
                                    let _e64 = phi_1252_;
                                    let _e66 = phi_1249_;
                                    let _e68 = phi_1248_;
                                    local_1 = _e66;
                                    local_2 = _e66;
                                    local_3 = _e64;
                                    if (_e68 < _e44) {
                                        phi_1253_ = 0u;
                                        loop {
                                            let _e71 = phi_1253_;
                                            if (_e71 < 4u) {
                                                let _e73 = (_e68 + _e71);
                                                if (_e73 < _e44) {
                                                    let _e79 = global_7.member[((_e73 * 256u) + _e62)];
                                                    phi_1269_ = _e79;
                                                } else {
                                                    phi_1269_ = 0u;
                                                }
                                                let _e81 = phi_1269_;
                                                local[_e71] = _e81;
                                                continue;
                                            } else {
                                                break;
                                            }
                                            continuing {
                                                phi_1253_ = (_e71 + bitcast<u32>(1i));
                                            }
                                        }
                                        phi_1266_ = _e64;
                                        phi_1259_ = _e66;
                                        phi_1254_ = 0u;
                                        loop {
                                            let _e86 = phi_1266_;
                                            let _e88 = phi_1259_;
                                            let _e90 = phi_1254_;
                                            local_10 = _e86;
                                            local_11 = _e88;
                                            if (_e90 < 4u) {
                                                let _e93 = ((_e68 + _e90) < _e35);
                                                if _e93 {
                                                    let _e95 = local[_e90];
                                                    phi_1257_ = _e95;
                                                } else {
                                                    phi_1257_ = 0u;
                                                }
                                                let _e97 = phi_1257_;
                                                local_13 = (_e88 + _e97);
                                                if _e93 {
                                                    phi_1263_ = 0u;
                                                } else {
                                                    let _e100 = local[_e90];
                                                    phi_1263_ = _e100;
                                                }
                                                let _e102 = phi_1263_;
                                                local_12 = (_e86 + _e102);
                                                continue;
                                            } else {
                                                break;
                                            }
                                            continuing {
                                                let _e303 = local_12;
                                                phi_1266_ = _e303;
                                                let _e306 = local_13;
                                                phi_1259_ = _e306;
                                                phi_1254_ = (_e90 + bitcast<u32>(1i));
                                            }
                                        }
                                        continue;
                                    } else {
                                        break;
                                    }
                                    continuing {
                                        let _e294 = local_10;
                                        phi_1252_ = _e294;
                                        let _e297 = local_11;
                                        phi_1249_ = _e297;
                                        phi_1248_ = (_e68 + 4u);
                                    }
                                }
                                let _e108 = local_1;
                                global_4[_e62] = (_e108 + _e57);
                                let _e112 = local_2;
                                let _e114 = local_3;
                                local_9 = (_e57 + (_e112 + _e114));
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e290 = local_9;
                                phi_1203_ = _e290;
                                phi_1202_ = (_e59 + bitcast<u32>(1i));
                            }
                        }
                        let _e121 = local_4;
                        global_5[_e33] = _e121;
                        workgroupBarrier();
                        if (_e33 < 8u) {
                            phi_1205_ = 0u;
                            phi_1204_ = 0u;
                            loop {
                                let _e124 = phi_1205_;
                                let _e126 = phi_1204_;
                                local_5 = _e124;
                                if (_e126 < 16u) {
                                    continue;
                                } else {
                                    break;
                                }
                                continuing {
                                    let _e131 = global_5[((_e33 * 16u) + _e126)];
                                    phi_1205_ = (_e124 + _e131);
                                    phi_1204_ = (_e126 + bitcast<u32>(1i));
                                }
                            }
                            let _e137 = local_5;
                            global_6[_e33] = _e137;
                        }
                        workgroupBarrier();
                        phi_1211_ = 0u;
                        phi_1206_ = 0u;
                        loop {
                            let _e139 = phi_1211_;
                            let _e141 = phi_1206_;
                            let _e142 = (_e33 / 16u);
                            local_6 = _e142;
                            local_14 = _e139;
                            if (_e141 < _e142) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e145 = global_6[_e141];
                                phi_1211_ = (_e139 + _e145);
                                phi_1206_ = (_e141 + bitcast<u32>(1i));
                            }
                        }
                        let _e150 = local_6;
                        let _e322 = local_14;
                        phi_1210_ = _e322;
                        phi_1207_ = (_e150 * 16u);
                        loop {
                            let _e153 = phi_1210_;
                            let _e155 = phi_1207_;
                            local_7 = _e153;
                            if (_e155 < _e33) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e158 = global_5[_e155];
                                phi_1210_ = (_e153 + _e158);
                                phi_1207_ = (_e155 + bitcast<u32>(1i));
                            }
                        }
                        phi_1208_ = 0u;
                        loop {
                            let _e163 = phi_1208_;
                            if (_e163 < 2u) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e168 = global_4[((_e33 * 2u) + _e163)];
                                let _e170 = local_7;
                                global_4[((_e33 * 2u) + _e163)] = (_e168 + _e170);
                                phi_1208_ = (_e163 + bitcast<u32>(1i));
                            }
                        }
                        workgroupBarrier();
                        break;
                    }
                    phi_1201_ = 0u;
                    loop {
                        let _e175 = phi_1201_;
                        if (_e175 < 2u) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e178 = (_e33 * 2u);
                            let _e183 = global_7.member[(((_e35 * 256u) + _e178) + _e175)];
                            global_4[(_e178 + _e175)] = _e183;
                            phi_1201_ = (_e175 + bitcast<u32>(1i));
                        }
                    }
                    workgroupBarrier();
                    break;
                }
            }
            let _e188 = (_e33 / 32u);
            let _e191 = (1u << bitcast<u32>((_e33 & 31u)));
            let _e195 = min(_e41, ((_e35 + 1u) * 4096u));
            let _e196 = (_e35 * 4096u);
            let _e197 = (_e196 + _e33);
            if (_e197 < _e195) {
                let _e201 = global_2.member[_e197];
                phi_1212_ = _e201;
            } else {
                phi_1212_ = 0u;
            }
            let _e203 = phi_1212_;
            phi_1215_ = _e203;
            phi_1214_ = 0u;
            phi_1213_ = _e196;
            loop {
                let _e205 = phi_1215_;
                let _e207 = phi_1214_;
                let _e209 = phi_1213_;
                if (_e209 < _e195) {
                    let _e211 = (_e209 + _e33);
                    let _e213 = ((_e207 & 1u) * 1024u);
                    let _e216 = ((_e205 >> bitcast<u32>(24u)) & 255u);
                    let _e217 = (_e211 < _e195);
                    let _e218 = select(_e217, true, _e217);
                    let _e219 = (_e211 + 128u);
                    phi_1274_ = _e205;
                    if (_e219 < _e195) {
                        let _e223 = global_2.member[_e219];
                        phi_1274_ = _e223;
                    }
                    let _e225 = phi_1274_;
                    local_15 = _e225;
                    if _e218 {
                        let _e230 = atomicOr((&global_8[((_e213 + (_e188 * 256u)) + _e216)]), _e191);
                    }
                    workgroupBarrier();
                    phi_1222_ = 0u;
                    phi_1221_ = 0u;
                    if _e218 {
                        phi_1226_ = 0u;
                        phi_1217_ = 0u;
                        phi_1216_ = 0u;
                        loop {
                            let _e232 = phi_1226_;
                            let _e234 = phi_1217_;
                            let _e236 = phi_1216_;
                            local_8 = _e234;
                            local_18 = _e232;
                            local_19 = _e234;
                            if (_e236 < 4u) {
                                let _e242 = atomicLoad((&global_8[((_e213 + (_e236 * 256u)) + _e216)]));
                                let _e244 = bitcast<u32>(countOneBits(_e242));
                                local_16 = (_e232 + _e244);
                                if (_e236 < _e188) {
                                    phi_1243_ = _e244;
                                } else {
                                    if (_e236 == _e188) {
                                        phi_1242_ = bitcast<u32>(countOneBits((_e242 & (_e191 - 1u))));
                                    } else {
                                        phi_1242_ = 0u;
                                    }
                                    let _e252 = phi_1242_;
                                    phi_1243_ = _e252;
                                }
                                let _e254 = phi_1243_;
                                local_17 = (_e234 + _e254);
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e336 = local_16;
                                phi_1226_ = _e336;
                                let _e339 = local_17;
                                phi_1217_ = _e339;
                                phi_1216_ = (_e236 + bitcast<u32>(1i));
                            }
                        }
                        let _e259 = global_4[_e216];
                        let _e261 = local_8;
                        global_3.member[(_e259 + _e261)] = (_e205 & 16777215u);
                        let _e346 = local_18;
                        phi_1222_ = _e346;
                        let _e349 = local_19;
                        phi_1221_ = _e349;
                    }
                    let _e267 = phi_1222_;
                    let _e269 = phi_1221_;
                    workgroupBarrier();
                    if (_e218 && (_e269 == 0u)) {
                        let _e273 = global_4[_e216];
                        global_4[_e216] = (_e273 + _e267);
                        phi_1227_ = 0u;
                        loop {
                            let _e276 = phi_1227_;
                            if (_e276 < 4u) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                atomicStore((&global_8[((_e213 + (_e276 * 256u)) + _e216)]), 0u);
                                phi_1227_ = (_e276 + bitcast<u32>(1i));
                            }
                        }
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e330 = local_15;
                    phi_1215_ = _e330;
                    phi_1214_ = (_e207 + bitcast<u32>(1i));
                    phi_1213_ = (_e209 + 128u);
                }
            }
            break;
        }
    }
    return;
}
