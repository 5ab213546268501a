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
    member_15: f32,
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

struct type_13 {
    member: array<u32, LENGTH_1_4>,
}

struct type_15 {
    member: array<u32, LENGTH_4_4>,
}

struct type_17 {
    member: array<u32, LENGTH_2_4>,
}

@group(0) @binding(7) 
var<uniform> global: type_4;
@group(0) @binding(3) 
var<storage, read_write> global_1: type_7;
@group(0) @binding(1) 
var<storage> global_2: type_13;
@group(0) @binding(4) 
var<storage, read_write> global_3: type_15;
@group(0) @binding(2) 
var<storage, read_write> global_4: type_17;
var<workgroup> global_5: array<u32, 8>;

@compute @workgroup_size(8, 1, 1) 
fn main(@builtin(workgroup_id) param: vec3<u32>, @builtin(local_invocation_id) param_1: vec3<u32>) {
    var phi_1304_: u32;
    var phi_1305_: u32;
    var phi_1308_: u32;
    var phi_1307_: u32;
    var phi_1322_: u32;
    var phi_1319_: u32;
    var phi_1327_: u32;
    var phi_1320_: u32;
    var local: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_1312_: u32;
    var phi_1309_: u32;
    var phi_1310_: u32;
    var local_4: u32;
    var local_5: u32;
    var local_6: u32;
    var phi_1306_: u32;
    var phi_1313_: u32;
    var phi_1318_: u32;
    var phi_1316_: u32;
    var phi_1314_: u32;
    var local_7: u32;
    var local_8: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e34 = global.member_4;
            let _e40 = (((_e34 * 256u) + 784u) + (((_e34 + 63u) / 64u) * 256u));
            let _e42 = bitcast<u32>(param_1[0u]);
            let _e44 = bitcast<u32>(param[0u]);
            let _e46 = global.member_7;
            let _e48 = global.member_5;
            let _e49 = min(_e46, _e48);
            let _e52 = max(((_e49 + 4095u) / 4096u), 1u);
            if (_e44 >= _e52) {
                break;
            }
            let _e55 = min(32u, (_e49 | 32u));
            phi_1304_ = 0u;
            loop {
                let _e59 = phi_1304_;
                if (_e59 < 256u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    global_4.member[(((_e40 + (_e44 * 2304u)) + (_e59 * 8u)) + _e42)] = 0u;
                    phi_1304_ = (_e59 + bitcast<u32>(1i));
                }
            }
            let _e72 = ((_e44 * 4096u) + (_e42 * 512u));
            phi_1305_ = _e72;
            loop {
                let _e74 = phi_1305_;
                let _e76 = min(_e49, (_e72 + 512u));
                local_7 = _e76;
                if (_e74 < _e76) {
                    let _e82 = global_2.member[(_e74 >> bitcast<u32>(1u))];
                    let _e87 = ((_e82 >> bitcast<u32>((16u * (_e74 & 1u)))) & 65535u);
                    let _e89 = select(_e87, 4294967295u, (_e87 == 65535u));
                    if (false || (_e89 != 4294967295u)) {
                        let _e100 = global_4.member[(((_e40 + (_e44 * 2304u)) + ((_e89 & 255u) * 8u)) + _e42)];
                        global_4.member[(((_e40 + (_e44 * 2304u)) + ((_e89 & 255u) * 8u)) + _e42)] = (_e100 + 1u);
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_1305_ = (_e74 + bitcast<u32>(1i));
                }
            }
            switch bitcast<i32>(0u) {
                default: {
                    let _e106 = global.member_6;
                    if !((_e106 != 0u)) {
                        phi_1308_ = 0u;
                        phi_1307_ = 0u;
                        loop {
                            let _e110 = phi_1308_;
                            let _e112 = phi_1307_;
                            local_3 = _e110;
                            local_6 = _e110;
                            if (_e112 < _e55) {
                                let _e114 = (_e42 * 32u);
                                let _e115 = (_e114 + _e112);
                                phi_1322_ = 0u;
                                phi_1319_ = 0u;
                                loop {
                                    let _e117 = phi_1322_;
                                    let _e119 = phi_1319_;
                                    local = _e117;
                                    local_1 = _e117;
                                    if (_e119 < _e44) {
                                        continue;
                                    } else {
                                        break;
                                    }
                                    continuing {
                                        let _e125 = global_4.member[((_e119 * 256u) + _e115)];
                                        phi_1322_ = (_e117 + _e125);
                                        phi_1319_ = (_e119 + bitcast<u32>(1i));
                                    }
                                }
                                phi_1327_ = 0u;
                                phi_1320_ = _e44;
                                loop {
                                    let _e130 = phi_1327_;
                                    let _e132 = phi_1320_;
                                    local_2 = _e130;
                                    if (_e132 < _e52) {
                                        continue;
                                    } else {
                                        break;
                                    }
                                    continuing {
                                        let _e138 = global_4.member[((_e132 * 256u) + _e115)];
                                        phi_1327_ = (_e130 + _e138);
                                        phi_1320_ = (_e132 + bitcast<u32>(1i));
                                    }
                                }
                                let _e143 = local;
                                global_4.member[((((_e40 + (_e44 * 2304u)) + 2048u) + _e114) + _e112)] = (_e143 + _e110);
                                let _e153 = local_1;
                                let _e155 = local_2;
                                local_8 = (_e110 + (_e153 + _e155));
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e299 = local_8;
                                phi_1308_ = _e299;
                                phi_1307_ = (_e112 + bitcast<u32>(1i));
                            }
                        }
                        let _e162 = local_3;
                        global_5[_e42] = _e162;
                        workgroupBarrier();
                        phi_1312_ = 0u;
                        phi_1309_ = 0u;
                        loop {
                            let _e164 = phi_1312_;
                            let _e166 = phi_1309_;
                            local_4 = _e164;
                            local_5 = _e164;
                            if (_e166 < _e42) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e169 = global_5[_e166];
                                phi_1312_ = (_e164 + _e169);
                                phi_1309_ = (_e166 + bitcast<u32>(1i));
                            }
                        }
                        phi_1310_ = 0u;
                        loop {
                            let _e174 = phi_1310_;
                            if (_e174 < _e55) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e184 = global_4.member[((((_e40 + (_e44 * 2304u)) + 2048u) + (_e42 * 32u)) + _e174)];
                                let _e186 = local_4;
                                global_4.member[((((_e40 + (_e44 * 2304u)) + 2048u) + (_e42 * 32u)) + _e174)] = (_e184 + _e186);
                                phi_1310_ = (_e174 + bitcast<u32>(1i));
                            }
                        }
                        workgroupBarrier();
                        let _e191 = local_5;
                        let _e193 = local_6;
                        let _e194 = (_e191 + _e193);
                        if ((true && (_e44 == 0u)) && (_e42 == 7u)) {
                            global_1.member.member_6 = _e194;
                            global_1.member.member_1 = ((_e194 + 127u) / 128u);
                        }
                        break;
                    }
                    phi_1306_ = 0u;
                    loop {
                        let _e206 = phi_1306_;
                        if (_e206 < _e55) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e209 = (_e42 * 32u);
                            let _e214 = global_4.member[(((_e44 * 256u) + _e209) + _e206)];
                            global_4.member[((((_e40 + (_e44 * 2304u)) + 2048u) + _e209) + _e206)] = _e214;
                            phi_1306_ = (_e206 + bitcast<u32>(1i));
                        }
                    }
                    workgroupBarrier();
                    break;
                }
            }
            storageBarrier();
            workgroupBarrier();
            phi_1313_ = 0u;
            loop {
                let _e225 = phi_1313_;
                if (_e225 < _e55) {
                    let _e228 = (_e40 + (_e44 * 2304u));
                    let _e230 = (_e42 * 32u);
                    let _e235 = global_4.member[(((_e228 + 2048u) + _e230) + _e225)];
                    phi_1318_ = _e235;
                    phi_1316_ = 0u;
                    loop {
                        let _e237 = phi_1318_;
                        let _e239 = phi_1316_;
                        if (_e239 < min(8u, (_e49 | 8u))) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e247 = global_4.member[((_e228 + ((_e230 + _e225) * 8u)) + _e239)];
                            global_4.member[((_e228 + ((_e230 + _e225) * 8u)) + _e239)] = _e237;
                            phi_1318_ = (_e237 + _e247);
                            phi_1316_ = (_e239 + bitcast<u32>(1i));
                        }
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_1313_ = (_e225 + bitcast<u32>(1i));
                }
            }
            storageBarrier();
            workgroupBarrier();
            phi_1314_ = _e72;
            loop {
                let _e254 = phi_1314_;
                let _e256 = local_7;
                if (_e254 < _e256) {
                    let _e262 = global_2.member[(_e254 >> bitcast<u32>(1u))];
                    let _e267 = ((_e262 >> bitcast<u32>((16u * (_e254 & 1u)))) & 65535u);
                    let _e269 = select(_e267, 4294967295u, (_e267 == 65535u));
                    if (false || (_e269 != 4294967295u)) {
                        let _e280 = global_4.member[(((_e40 + (_e44 * 2304u)) + ((_e269 & 255u) * 8u)) + _e42)];
                        global_4.member[(((_e40 + (_e44 * 2304u)) + ((_e269 & 255u) * 8u)) + _e42)] = (_e280 + 1u);
                        global_3.member[_e280] = (((((_e269 >> bitcast<u32>(8u)) << bitcast<u32>(24u)) >> bitcast<u32>(24u)) << bitcast<u32>(24u)) | _e254);
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_1314_ = (_e254 + bitcast<u32>(1i));
                }
            }
            break;
        }
    }
    return;
}
