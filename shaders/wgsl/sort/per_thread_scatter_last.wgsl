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
    member_15: f32,
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

struct type_12 {
    member: array<u32, LENGTH_1_4>,
}

struct type_14 {
    member: array<u32, LENGTH_4_4>,
}

struct type_16 {
    member: array<u32, LENGTH_2_4>,
}

@group(0) @binding(7) 
var<uniform> global: type_3;
@group(0) @binding(3) 
var<storage> global_1: type_6;
@group(0) @binding(1) 
var<storage> global_2: type_12;
@group(0) @binding(4) 
var<storage, read_write> global_3: type_14;
@group(0) @binding(2) 
var<storage, read_write> global_4: type_16;
var<workgroup> global_5: array<u32, 8>;

@compute @workgroup_size(8, 1, 1) 
fn main(@builtin(workgroup_id) param: vec3<u32>, @builtin(local_invocation_id) param_1: vec3<u32>) {
    var phi_1154_: u32;
    var phi_1153_: u32;
    var phi_1168_: u32;
    var phi_1165_: u32;
    var phi_1173_: u32;
    var phi_1166_: u32;
    var local: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_1158_: u32;
    var phi_1155_: u32;
    var phi_1156_: u32;
    var local_4: u32;
    var phi_1152_: u32;
    var phi_1159_: u32;
    var phi_1164_: u32;
    var phi_1162_: u32;
    var phi_1160_: u32;
    var local_5: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e27 = global.member_4;
            let _e33 = (((_e27 * 256u) + 784u) + (((_e27 + 63u) / 64u) * 256u));
            let _e35 = bitcast<u32>(param_1[0u]);
            let _e37 = bitcast<u32>(param[0u]);
            let _e40 = global_1.member.member_6;
            let _e42 = global.member_5;
            let _e43 = min(_e40, _e42);
            let _e46 = max(((_e43 + 4095u) / 4096u), 1u);
            if (_e37 >= _e46) {
                break;
            }
            let _e49 = min(32u, (_e43 | 32u));
            switch bitcast<i32>(0u) {
                default: {
                    let _e54 = global.member_6;
                    if !((_e54 != 0u)) {
                        phi_1154_ = 0u;
                        phi_1153_ = 0u;
                        loop {
                            let _e58 = phi_1154_;
                            let _e60 = phi_1153_;
                            local_3 = _e58;
                            if (_e60 < _e49) {
                                let _e62 = (_e35 * 32u);
                                let _e63 = (_e62 + _e60);
                                phi_1168_ = 0u;
                                phi_1165_ = 0u;
                                loop {
                                    let _e65 = phi_1168_;
                                    let _e67 = phi_1165_;
                                    local = _e65;
                                    local_1 = _e65;
                                    if (_e67 < _e37) {
                                        continue;
                                    } else {
                                        break;
                                    }
                                    continuing {
                                        let _e73 = global_4.member[((_e67 * 256u) + _e63)];
                                        phi_1168_ = (_e65 + _e73);
                                        phi_1165_ = (_e67 + bitcast<u32>(1i));
                                    }
                                }
                                phi_1173_ = 0u;
                                phi_1166_ = _e37;
                                loop {
                                    let _e78 = phi_1173_;
                                    let _e80 = phi_1166_;
                                    local_2 = _e78;
                                    if (_e80 < _e46) {
                                        continue;
                                    } else {
                                        break;
                                    }
                                    continuing {
                                        let _e86 = global_4.member[((_e80 * 256u) + _e63)];
                                        phi_1173_ = (_e78 + _e86);
                                        phi_1166_ = (_e80 + bitcast<u32>(1i));
                                    }
                                }
                                let _e91 = local;
                                global_4.member[((((_e33 + (_e37 * 2304u)) + 2048u) + _e62) + _e60)] = (_e91 + _e58);
                                let _e101 = local_1;
                                let _e103 = local_2;
                                local_5 = (_e58 + (_e101 + _e103));
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e216 = local_5;
                                phi_1154_ = _e216;
                                phi_1153_ = (_e60 + bitcast<u32>(1i));
                            }
                        }
                        let _e110 = local_3;
                        global_5[_e35] = _e110;
                        workgroupBarrier();
                        phi_1158_ = 0u;
                        phi_1155_ = 0u;
                        loop {
                            let _e112 = phi_1158_;
                            let _e114 = phi_1155_;
                            local_4 = _e112;
                            if (_e114 < _e35) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e117 = global_5[_e114];
                                phi_1158_ = (_e112 + _e117);
                                phi_1155_ = (_e114 + bitcast<u32>(1i));
                            }
                        }
                        phi_1156_ = 0u;
                        loop {
                            let _e122 = phi_1156_;
                            if (_e122 < _e49) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e132 = global_4.member[((((_e33 + (_e37 * 2304u)) + 2048u) + (_e35 * 32u)) + _e122)];
                                let _e134 = local_4;
                                global_4.member[((((_e33 + (_e37 * 2304u)) + 2048u) + (_e35 * 32u)) + _e122)] = (_e132 + _e134);
                                phi_1156_ = (_e122 + bitcast<u32>(1i));
                            }
                        }
                        workgroupBarrier();
                        break;
                    }
                    phi_1152_ = 0u;
                    loop {
                        let _e139 = phi_1152_;
                        if (_e139 < _e49) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e142 = (_e35 * 32u);
                            let _e147 = global_4.member[(((_e37 * 256u) + _e142) + _e139)];
                            global_4.member[((((_e33 + (_e37 * 2304u)) + 2048u) + _e142) + _e139)] = _e147;
                            phi_1152_ = (_e139 + bitcast<u32>(1i));
                        }
                    }
                    workgroupBarrier();
                    break;
                }
            }
            storageBarrier();
            workgroupBarrier();
            phi_1159_ = 0u;
            loop {
                let _e158 = phi_1159_;
                if (_e158 < _e49) {
                    let _e161 = (_e33 + (_e37 * 2304u));
                    let _e163 = (_e35 * 32u);
                    let _e168 = global_4.member[(((_e161 + 2048u) + _e163) + _e158)];
                    phi_1164_ = _e168;
                    phi_1162_ = 0u;
                    loop {
                        let _e170 = phi_1164_;
                        let _e172 = phi_1162_;
                        if (_e172 < min(8u, (_e43 | 8u))) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e180 = global_4.member[((_e161 + ((_e163 + _e158) * 8u)) + _e172)];
                            global_4.member[((_e161 + ((_e163 + _e158) * 8u)) + _e172)] = _e170;
                            phi_1164_ = (_e170 + _e180);
                            phi_1162_ = (_e172 + bitcast<u32>(1i));
                        }
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_1159_ = (_e158 + bitcast<u32>(1i));
                }
            }
            storageBarrier();
            workgroupBarrier();
            let _e188 = ((_e37 * 4096u) + (_e35 * 512u));
            phi_1160_ = _e188;
            loop {
                let _e190 = phi_1160_;
                if (_e190 < min(_e43, (_e188 + 512u))) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e196 = global_2.member[_e190];
                    let _e207 = global_4.member[(((_e33 + (_e37 * 2304u)) + (((_e196 >> bitcast<u32>(24u)) & 255u) * 8u)) + _e35)];
                    global_4.member[(((_e33 + (_e37 * 2304u)) + (((_e196 >> bitcast<u32>(24u)) & 255u) * 8u)) + _e35)] = (_e207 + 1u);
                    global_3.member[_e207] = (_e196 & 16777215u);
                    phi_1160_ = (_e190 + bitcast<u32>(1i));
                }
            }
            break;
        }
    }
    return;
}
