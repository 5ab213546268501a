struct type_3 {
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

struct type_5 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: i32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
}

struct type_6 {
    member: type_5,
}

struct type_8 {
    member: array<u32>,
}

struct type_14 {
    member: array<u32, LENGTH_1_4>,
}

struct type_16 {
    member: array<u32, LENGTH_4_4>,
}

struct type_18 {
    member: array<u32, LENGTH_2_4>,
}

@group(0) @binding(7) 
var<uniform> global: type_3;
@group(0) @binding(3) 
var<storage> global_1: type_6;
@group(0) @binding(1) 
var<storage> global_2: type_14;
@group(0) @binding(4) 
var<storage, read_write> global_3: type_16;
@group(0) @binding(2) 
var<storage, read_write> global_4: type_18;
var<workgroup> global_5: array<u32, 8>;
var<workgroup> global_6: array<u32, 1>;

@compute @workgroup_size(8, 1, 1) 
fn main(@builtin(workgroup_id) param: vec3<u32>, @builtin(local_invocation_id) param_1: vec3<u32>) {
    var local: array<u32, 4>;
    var phi_1332_: u32;
    var phi_1331_: u32;
    var phi_1351_: u32;
    var phi_1348_: u32;
    var phi_1347_: u32;
    var phi_1352_: u32;
    var phi_1368_: u32;
    var phi_1365_: u32;
    var phi_1358_: u32;
    var phi_1353_: u32;
    var phi_1356_: u32;
    var phi_1362_: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1334_: u32;
    var phi_1333_: u32;
    var local_5: u32;
    var phi_1340_: u32;
    var phi_1335_: u32;
    var local_6: u32;
    var phi_1339_: u32;
    var phi_1336_: u32;
    var phi_1337_: u32;
    var local_7: u32;
    var phi_1330_: u32;
    var phi_1341_: u32;
    var phi_1346_: u32;
    var phi_1344_: u32;
    var phi_1342_: u32;
    var local_8: u32;
    var local_9: u32;
    var local_10: u32;
    var local_11: u32;
    var local_12: u32;
    var local_13: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e29 = global.member_4;
            let _e35 = (((_e29 * 256u) + 784u) + (((_e29 + 31u) / 32u) * 256u));
            let _e37 = bitcast<u32>(param_1[0u]);
            let _e39 = bitcast<u32>(param[0u]);
            let _e42 = global_1.member.member_6;
            let _e44 = global.member_5;
            let _e45 = min(_e42, _e44);
            let _e48 = max(((_e45 + 4095u) / 4096u), 1u);
            if (_e39 >= _e48) {
                break;
            }
            let _e51 = min(32u, (_e45 | 32u));
            switch bitcast<i32>(0u) {
                default: {
                    let _e56 = global.member_6;
                    if !((_e56 != 0u)) {
                        phi_1332_ = 0u;
                        phi_1331_ = 0u;
                        loop {
                            let _e60 = phi_1332_;
                            let _e62 = phi_1331_;
                            local_4 = _e60;
                            if (_e62 < _e51) {
                                let _e64 = (_e37 * 32u);
                                phi_1351_ = 0u;
                                phi_1348_ = 0u;
                                phi_1347_ = 0u;
                                loop {
                                    let _e67 = phi_1351_;
                                    let _e69 = phi_1348_;
                                    let _e71 = phi_1347_;
                                    local_1 = _e69;
                                    local_2 = _e69;
                                    local_3 = _e67;
                                    if (_e71 < _e48) {
                                        phi_1352_ = 0u;
                                        loop {
                                            let _e74 = phi_1352_;
                                            if (_e74 < 4u) {
                                                let _e76 = (_e71 + _e74);
                                                if (_e76 < _e48) {
                                                    let _e82 = global_4.member[((_e76 * 256u) + (_e64 + _e62))];
                                                    phi_1368_ = _e82;
                                                } else {
                                                    phi_1368_ = 0u;
                                                }
                                                let _e84 = phi_1368_;
                                                local[_e74] = _e84;
                                                continue;
                                            } else {
                                                break;
                                            }
                                            continuing {
                                                phi_1352_ = (_e74 + bitcast<u32>(1i));
                                            }
                                        }
                                        phi_1365_ = _e67;
                                        phi_1358_ = _e69;
                                        phi_1353_ = 0u;
                                        loop {
                                            let _e89 = phi_1365_;
                                            let _e91 = phi_1358_;
                                            let _e93 = phi_1353_;
                                            local_9 = _e89;
                                            local_10 = _e91;
                                            if (_e93 < 4u) {
                                                let _e96 = ((_e71 + _e93) < _e39);
                                                if _e96 {
                                                    let _e98 = local[_e93];
                                                    phi_1356_ = _e98;
                                                } else {
                                                    phi_1356_ = 0u;
                                                }
                                                let _e100 = phi_1356_;
                                                local_12 = (_e91 + _e100);
                                                if _e96 {
                                                    phi_1362_ = 0u;
                                                } else {
                                                    let _e103 = local[_e93];
                                                    phi_1362_ = _e103;
                                                }
                                                let _e105 = phi_1362_;
                                                local_11 = (_e89 + _e105);
                                                continue;
                                            } else {
                                                break;
                                            }
                                            continuing {
                                                let _e279 = local_11;
                                                phi_1365_ = _e279;
                                                let _e282 = local_12;
                                                phi_1358_ = _e282;
                                                phi_1353_ = (_e93 + bitcast<u32>(1i));
                                            }
                                        }
                                        continue;
                                    } else {
                                        break;
                                    }
                                    continuing {
                                        let _e270 = local_9;
                                        phi_1351_ = _e270;
                                        let _e273 = local_10;
                                        phi_1348_ = _e273;
                                        phi_1347_ = (_e71 + 4u);
                                    }
                                }
                                let _e111 = local_1;
                                global_4.member[((((_e35 + (_e39 * 2304u)) + 2048u) + _e64) + _e62)] = (_e111 + _e60);
                                let _e121 = local_2;
                                let _e123 = local_3;
                                local_8 = (_e60 + (_e121 + _e123));
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e266 = local_8;
                                phi_1332_ = _e266;
                                phi_1331_ = (_e62 + bitcast<u32>(1i));
                            }
                        }
                        let _e130 = local_4;
                        global_5[_e37] = _e130;
                        workgroupBarrier();
                        if (_e37 < 1u) {
                            phi_1334_ = 0u;
                            phi_1333_ = 0u;
                            loop {
                                let _e133 = phi_1334_;
                                let _e135 = phi_1333_;
                                local_5 = _e133;
                                if (_e135 < 8u) {
                                    continue;
                                } else {
                                    break;
                                }
                                continuing {
                                    let _e140 = global_5[((_e37 * 8u) + _e135)];
                                    phi_1334_ = (_e133 + _e140);
                                    phi_1333_ = (_e135 + bitcast<u32>(1i));
                                }
                            }
                            let _e146 = local_5;
                            global_6[_e37] = _e146;
                        }
                        workgroupBarrier();
                        phi_1340_ = 0u;
                        phi_1335_ = 0u;
                        loop {
                            let _e148 = phi_1340_;
                            let _e150 = phi_1335_;
                            let _e151 = (_e37 / 8u);
                            local_6 = _e151;
                            local_13 = _e148;
                            if (_e150 < _e151) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e154 = global_6[_e150];
                                phi_1340_ = (_e148 + _e154);
                                phi_1335_ = (_e150 + bitcast<u32>(1i));
                            }
                        }
                        let _e159 = local_6;
                        let _e298 = local_13;
                        phi_1339_ = _e298;
                        phi_1336_ = (_e159 * 8u);
                        loop {
                            let _e162 = phi_1339_;
                            let _e164 = phi_1336_;
                            local_7 = _e162;
                            if (_e164 < _e37) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e167 = global_5[_e164];
                                phi_1339_ = (_e162 + _e167);
                                phi_1336_ = (_e164 + bitcast<u32>(1i));
                            }
                        }
                        phi_1337_ = 0u;
                        loop {
                            let _e172 = phi_1337_;
                            if (_e172 < _e51) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e182 = global_4.member[((((_e35 + (_e39 * 2304u)) + 2048u) + (_e37 * 32u)) + _e172)];
                                let _e184 = local_7;
                                global_4.member[((((_e35 + (_e39 * 2304u)) + 2048u) + (_e37 * 32u)) + _e172)] = (_e182 + _e184);
                                phi_1337_ = (_e172 + bitcast<u32>(1i));
                            }
                        }
                        workgroupBarrier();
                        break;
                    }
                    phi_1330_ = 0u;
                    loop {
                        let _e189 = phi_1330_;
                        if (_e189 < _e51) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e192 = (_e37 * 32u);
                            let _e197 = global_4.member[(((_e39 * 256u) + _e192) + _e189)];
                            global_4.member[((((_e35 + (_e39 * 2304u)) + 2048u) + _e192) + _e189)] = _e197;
                            phi_1330_ = (_e189 + bitcast<u32>(1i));
                        }
                    }
                    workgroupBarrier();
                    break;
                }
            }
            storageBarrier();
            workgroupBarrier();
            phi_1341_ = 0u;
            loop {
                let _e208 = phi_1341_;
                if (_e208 < _e51) {
                    let _e211 = (_e35 + (_e39 * 2304u));
                    let _e213 = (_e37 * 32u);
                    let _e218 = global_4.member[(((_e211 + 2048u) + _e213) + _e208)];
                    phi_1346_ = _e218;
                    phi_1344_ = 0u;
                    loop {
                        let _e220 = phi_1346_;
                        let _e222 = phi_1344_;
                        if (_e222 < min(8u, (_e45 | 8u))) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e230 = global_4.member[((_e211 + ((_e213 + _e208) * 8u)) + _e222)];
                            global_4.member[((_e211 + ((_e213 + _e208) * 8u)) + _e222)] = _e220;
                            phi_1346_ = (_e220 + _e230);
                            phi_1344_ = (_e222 + bitcast<u32>(1i));
                        }
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_1341_ = (_e208 + bitcast<u32>(1i));
                }
            }
            storageBarrier();
            workgroupBarrier();
            let _e238 = ((_e39 * 4096u) + (_e37 * 512u));
            phi_1342_ = _e238;
            loop {
                let _e240 = phi_1342_;
                if (_e240 < min(_e45, (_e238 + 512u))) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e246 = global_2.member[_e240];
                    let _e257 = global_4.member[(((_e35 + (_e39 * 2304u)) + (((_e246 >> bitcast<u32>(24u)) & 255u) * 8u)) + _e37)];
                    global_4.member[(((_e35 + (_e39 * 2304u)) + (((_e246 >> bitcast<u32>(24u)) & 255u) * 8u)) + _e37)] = (_e257 + 1u);
                    global_3.member[_e257] = (_e246 & 16777215u);
                    phi_1342_ = (_e240 + bitcast<u32>(1i));
                }
            }
            break;
        }
    }
    return;
}
