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

struct type_15 {
    member: array<u32, LENGTH_1_4>,
}

struct type_17 {
    member: array<u32, LENGTH_4_4>,
}

struct type_19 {
    member: array<u32, LENGTH_2_4>,
}

@group(0) @binding(7) 
var<uniform> global: type_4;
@group(0) @binding(3) 
var<storage, read_write> global_1: type_7;
@group(0) @binding(1) 
var<storage> global_2: type_15;
@group(0) @binding(4) 
var<storage, read_write> global_3: type_17;
@group(0) @binding(2) 
var<storage, read_write> global_4: type_19;
var<workgroup> global_5: array<u32, 8>;
var<workgroup> global_6: array<u32, 1>;

@compute @workgroup_size(8, 1, 1) 
fn main(@builtin(workgroup_id) param: vec3<u32>, @builtin(local_invocation_id) param_1: vec3<u32>) {
    var local: array<u32, 4>;
    var phi_1482_: u32;
    var phi_1483_: u32;
    var phi_1486_: u32;
    var phi_1485_: u32;
    var phi_1505_: u32;
    var phi_1502_: u32;
    var phi_1501_: u32;
    var phi_1506_: u32;
    var phi_1522_: u32;
    var phi_1519_: u32;
    var phi_1512_: u32;
    var phi_1507_: u32;
    var phi_1510_: u32;
    var phi_1516_: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1488_: u32;
    var phi_1487_: u32;
    var local_5: u32;
    var phi_1494_: u32;
    var phi_1489_: u32;
    var local_6: u32;
    var phi_1493_: u32;
    var phi_1490_: u32;
    var phi_1491_: u32;
    var local_7: u32;
    var local_8: u32;
    var local_9: u32;
    var phi_1484_: u32;
    var phi_1495_: u32;
    var phi_1500_: u32;
    var phi_1498_: u32;
    var phi_1496_: u32;
    var local_10: u32;
    var local_11: u32;
    var local_12: u32;
    var local_13: u32;
    var local_14: u32;
    var local_15: u32;
    var local_16: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e36 = global.member_4;
            let _e42 = (((_e36 * 256u) + 784u) + (((_e36 + 31u) / 32u) * 256u));
            let _e44 = bitcast<u32>(param_1[0u]);
            let _e46 = bitcast<u32>(param[0u]);
            let _e48 = global.member_7;
            let _e50 = global.member_5;
            let _e51 = min(_e48, _e50);
            let _e54 = max(((_e51 + 4095u) / 4096u), 1u);
            if (_e46 >= _e54) {
                break;
            }
            let _e57 = min(32u, (_e51 | 32u));
            phi_1482_ = 0u;
            loop {
                let _e61 = phi_1482_;
                if (_e61 < 256u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    global_4.member[(((_e42 + (_e46 * 2304u)) + (_e61 * 8u)) + _e44)] = 0u;
                    phi_1482_ = (_e61 + bitcast<u32>(1i));
                }
            }
            let _e74 = ((_e46 * 4096u) + (_e44 * 512u));
            phi_1483_ = _e74;
            loop {
                let _e76 = phi_1483_;
                let _e78 = min(_e51, (_e74 + 512u));
                local_10 = _e78;
                if (_e76 < _e78) {
                    let _e84 = global_2.member[(_e76 >> bitcast<u32>(1u))];
                    let _e89 = ((_e84 >> bitcast<u32>((16u * (_e76 & 1u)))) & 65535u);
                    let _e91 = select(_e89, 4294967295u, (_e89 == 65535u));
                    if (false || (_e91 != 4294967295u)) {
                        let _e102 = global_4.member[(((_e42 + (_e46 * 2304u)) + ((_e91 & 255u) * 8u)) + _e44)];
                        global_4.member[(((_e42 + (_e46 * 2304u)) + ((_e91 & 255u) * 8u)) + _e44)] = (_e102 + 1u);
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_1483_ = (_e76 + bitcast<u32>(1i));
                }
            }
            switch bitcast<i32>(0u) {
                default: {
                    let _e108 = global.member_6;
                    if !((_e108 != 0u)) {
                        phi_1486_ = 0u;
                        phi_1485_ = 0u;
                        loop {
                            let _e112 = phi_1486_;
                            let _e114 = phi_1485_;
                            local_4 = _e112;
                            local_9 = _e112;
                            if (_e114 < _e57) {
                                let _e116 = (_e44 * 32u);
                                phi_1505_ = 0u;
                                phi_1502_ = 0u;
                                phi_1501_ = 0u;
                                loop {
                                    let _e119 = phi_1505_;
                                    let _e121 = phi_1502_;
                                    let _e123 = phi_1501_;
                                    local_1 = _e121;
                                    local_2 = _e121;
                                    local_3 = _e119;
                                    if (_e123 < _e54) {
                                        phi_1506_ = 0u;
                                        loop {
                                            let _e126 = phi_1506_;
                                            if (_e126 < 4u) {
                                                let _e128 = (_e123 + _e126);
                                                if (_e128 < _e54) {
                                                    let _e134 = global_4.member[((_e128 * 256u) + (_e116 + _e114))];
                                                    phi_1522_ = _e134;
                                                } else {
                                                    phi_1522_ = 0u;
                                                }
                                                let _e136 = phi_1522_;
                                                local[_e126] = _e136;
                                                continue;
                                            } else {
                                                break;
                                            }
                                            continuing {
                                                phi_1506_ = (_e126 + bitcast<u32>(1i));
                                            }
                                        }
                                        phi_1519_ = _e119;
                                        phi_1512_ = _e121;
                                        phi_1507_ = 0u;
                                        loop {
                                            let _e141 = phi_1519_;
                                            let _e143 = phi_1512_;
                                            let _e145 = phi_1507_;
                                            local_12 = _e141;
                                            local_13 = _e143;
                                            if (_e145 < 4u) {
                                                let _e148 = ((_e123 + _e145) < _e46);
                                                if _e148 {
                                                    let _e150 = local[_e145];
                                                    phi_1510_ = _e150;
                                                } else {
                                                    phi_1510_ = 0u;
                                                }
                                                let _e152 = phi_1510_;
                                                local_15 = (_e143 + _e152);
                                                if _e148 {
                                                    phi_1516_ = 0u;
                                                } else {
                                                    let _e155 = local[_e145];
                                                    phi_1516_ = _e155;
                                                }
                                                let _e157 = phi_1516_;
                                                local_14 = (_e141 + _e157);
                                                continue;
                                            } else {
                                                break;
                                            }
                                            continuing {
                                                let _e362 = local_14;
                                                phi_1519_ = _e362;
                                                let _e365 = local_15;
                                                phi_1512_ = _e365;
                                                phi_1507_ = (_e145 + bitcast<u32>(1i));
                                            }
                                        }
                                        continue;
                                    } else {
                                        break;
                                    }
                                    continuing {
                                        let _e353 = local_12;
                                        phi_1505_ = _e353;
                                        let _e356 = local_13;
                                        phi_1502_ = _e356;
                                        phi_1501_ = (_e123 + 4u);
                                    }
                                }
                                let _e163 = local_1;
                                global_4.member[((((_e42 + (_e46 * 2304u)) + 2048u) + _e116) + _e114)] = (_e163 + _e112);
                                let _e173 = local_2;
                                let _e175 = local_3;
                                local_11 = (_e112 + (_e173 + _e175));
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e349 = local_11;
                                phi_1486_ = _e349;
                                phi_1485_ = (_e114 + bitcast<u32>(1i));
                            }
                        }
                        let _e182 = local_4;
                        global_5[_e44] = _e182;
                        workgroupBarrier();
                        if (_e44 < 1u) {
                            phi_1488_ = 0u;
                            phi_1487_ = 0u;
                            loop {
                                let _e185 = phi_1488_;
                                let _e187 = phi_1487_;
                                local_5 = _e185;
                                if (_e187 < 8u) {
                                    continue;
                                } else {
                                    break;
                                }
                                continuing {
                                    let _e192 = global_5[((_e44 * 8u) + _e187)];
                                    phi_1488_ = (_e185 + _e192);
                                    phi_1487_ = (_e187 + bitcast<u32>(1i));
                                }
                            }
                            let _e198 = local_5;
                            global_6[_e44] = _e198;
                        }
                        workgroupBarrier();
                        phi_1494_ = 0u;
                        phi_1489_ = 0u;
                        loop {
                            let _e200 = phi_1494_;
                            let _e202 = phi_1489_;
                            let _e203 = (_e44 / 8u);
                            local_6 = _e203;
                            local_16 = _e200;
                            if (_e202 < _e203) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e206 = global_6[_e202];
                                phi_1494_ = (_e200 + _e206);
                                phi_1489_ = (_e202 + bitcast<u32>(1i));
                            }
                        }
                        let _e211 = local_6;
                        let _e381 = local_16;
                        phi_1493_ = _e381;
                        phi_1490_ = (_e211 * 8u);
                        loop {
                            let _e214 = phi_1493_;
                            let _e216 = phi_1490_;
                            local_7 = _e214;
                            local_8 = _e214;
                            if (_e216 < _e44) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e219 = global_5[_e216];
                                phi_1493_ = (_e214 + _e219);
                                phi_1490_ = (_e216 + bitcast<u32>(1i));
                            }
                        }
                        phi_1491_ = 0u;
                        loop {
                            let _e224 = phi_1491_;
                            if (_e224 < _e57) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e234 = global_4.member[((((_e42 + (_e46 * 2304u)) + 2048u) + (_e44 * 32u)) + _e224)];
                                let _e236 = local_7;
                                global_4.member[((((_e42 + (_e46 * 2304u)) + 2048u) + (_e44 * 32u)) + _e224)] = (_e234 + _e236);
                                phi_1491_ = (_e224 + bitcast<u32>(1i));
                            }
                        }
                        workgroupBarrier();
                        let _e241 = local_8;
                        let _e243 = local_9;
                        let _e244 = (_e241 + _e243);
                        if ((true && (_e46 == 0u)) && (_e44 == 7u)) {
                            global_1.member.member_6 = _e244;
                            global_1.member.member_1 = ((_e244 + 127u) / 128u);
                        }
                        break;
                    }
                    phi_1484_ = 0u;
                    loop {
                        let _e256 = phi_1484_;
                        if (_e256 < _e57) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e259 = (_e44 * 32u);
                            let _e264 = global_4.member[(((_e46 * 256u) + _e259) + _e256)];
                            global_4.member[((((_e42 + (_e46 * 2304u)) + 2048u) + _e259) + _e256)] = _e264;
                            phi_1484_ = (_e256 + bitcast<u32>(1i));
                        }
                    }
                    workgroupBarrier();
                    break;
                }
            }
            storageBarrier();
            workgroupBarrier();
            phi_1495_ = 0u;
            loop {
                let _e275 = phi_1495_;
                if (_e275 < _e57) {
                    let _e278 = (_e42 + (_e46 * 2304u));
                    let _e280 = (_e44 * 32u);
                    let _e285 = global_4.member[(((_e278 + 2048u) + _e280) + _e275)];
                    phi_1500_ = _e285;
                    phi_1498_ = 0u;
                    loop {
                        let _e287 = phi_1500_;
                        let _e289 = phi_1498_;
                        if (_e289 < min(8u, (_e51 | 8u))) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e297 = global_4.member[((_e278 + ((_e280 + _e275) * 8u)) + _e289)];
                            global_4.member[((_e278 + ((_e280 + _e275) * 8u)) + _e289)] = _e287;
                            phi_1500_ = (_e287 + _e297);
                            phi_1498_ = (_e289 + bitcast<u32>(1i));
                        }
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_1495_ = (_e275 + bitcast<u32>(1i));
                }
            }
            storageBarrier();
            workgroupBarrier();
            phi_1496_ = _e74;
            loop {
                let _e304 = phi_1496_;
                let _e306 = local_10;
                if (_e304 < _e306) {
                    let _e312 = global_2.member[(_e304 >> bitcast<u32>(1u))];
                    let _e317 = ((_e312 >> bitcast<u32>((16u * (_e304 & 1u)))) & 65535u);
                    let _e319 = select(_e317, 4294967295u, (_e317 == 65535u));
                    if (false || (_e319 != 4294967295u)) {
                        let _e330 = global_4.member[(((_e42 + (_e46 * 2304u)) + ((_e319 & 255u) * 8u)) + _e44)];
                        global_4.member[(((_e42 + (_e46 * 2304u)) + ((_e319 & 255u) * 8u)) + _e44)] = (_e330 + 1u);
                        global_3.member[_e330] = (((((_e319 >> bitcast<u32>(8u)) << bitcast<u32>(24u)) >> bitcast<u32>(24u)) << bitcast<u32>(24u)) | _e304);
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_1496_ = (_e304 + bitcast<u32>(1i));
                }
            }
            break;
        }
    }
    return;
}
