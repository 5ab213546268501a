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
    var phi_1117_: u32;
    var phi_1116_: u32;
    var phi_1131_: u32;
    var phi_1128_: u32;
    var phi_1136_: u32;
    var phi_1129_: u32;
    var local: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_1121_: u32;
    var phi_1118_: u32;
    var phi_1119_: u32;
    var local_4: u32;
    var phi_1115_: u32;
    var phi_1122_: u32;
    var phi_1127_: u32;
    var phi_1125_: u32;
    var phi_1123_: u32;
    var local_5: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e26 = global.member_4;
            let _e32 = (((_e26 * 256u) + 784u) + (((_e26 + 63u) / 64u) * 256u));
            let _e34 = bitcast<u32>(param_1[0u]);
            let _e36 = bitcast<u32>(param[0u]);
            let _e39 = global_1.member.member_6;
            let _e41 = global.member_5;
            let _e42 = min(_e39, _e41);
            let _e45 = max(((_e42 + 4095u) / 4096u), 1u);
            if (_e36 >= _e45) {
                break;
            }
            let _e48 = min(32u, (_e42 | 32u));
            switch bitcast<i32>(0u) {
                default: {
                    let _e53 = global.member_6;
                    if !((_e53 != 0u)) {
                        phi_1117_ = 0u;
                        phi_1116_ = 0u;
                        loop {
                            let _e57 = phi_1117_;
                            let _e59 = phi_1116_;
                            local_3 = _e57;
                            if (_e59 < _e48) {
                                let _e61 = (_e34 * 32u);
                                let _e62 = (_e61 + _e59);
                                phi_1131_ = 0u;
                                phi_1128_ = 0u;
                                loop {
                                    let _e64 = phi_1131_;
                                    let _e66 = phi_1128_;
                                    local = _e64;
                                    local_1 = _e64;
                                    if (_e66 < _e36) {
                                        continue;
                                    } else {
                                        break;
                                    }
                                    continuing {
                                        let _e72 = global_4.member[((_e66 * 256u) + _e62)];
                                        phi_1131_ = (_e64 + _e72);
                                        phi_1128_ = (_e66 + bitcast<u32>(1i));
                                    }
                                }
                                phi_1136_ = 0u;
                                phi_1129_ = _e36;
                                loop {
                                    let _e77 = phi_1136_;
                                    let _e79 = phi_1129_;
                                    local_2 = _e77;
                                    if (_e79 < _e45) {
                                        continue;
                                    } else {
                                        break;
                                    }
                                    continuing {
                                        let _e85 = global_4.member[((_e79 * 256u) + _e62)];
                                        phi_1136_ = (_e77 + _e85);
                                        phi_1129_ = (_e79 + bitcast<u32>(1i));
                                    }
                                }
                                let _e90 = local;
                                global_4.member[((((_e32 + (_e36 * 2304u)) + 2048u) + _e61) + _e59)] = (_e90 + _e57);
                                let _e100 = local_1;
                                let _e102 = local_2;
                                local_5 = (_e57 + (_e100 + _e102));
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e214 = local_5;
                                phi_1117_ = _e214;
                                phi_1116_ = (_e59 + bitcast<u32>(1i));
                            }
                        }
                        let _e109 = local_3;
                        global_5[_e34] = _e109;
                        workgroupBarrier();
                        phi_1121_ = 0u;
                        phi_1118_ = 0u;
                        loop {
                            let _e111 = phi_1121_;
                            let _e113 = phi_1118_;
                            local_4 = _e111;
                            if (_e113 < _e34) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e116 = global_5[_e113];
                                phi_1121_ = (_e111 + _e116);
                                phi_1118_ = (_e113 + bitcast<u32>(1i));
                            }
                        }
                        phi_1119_ = 0u;
                        loop {
                            let _e121 = phi_1119_;
                            if (_e121 < _e48) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e131 = global_4.member[((((_e32 + (_e36 * 2304u)) + 2048u) + (_e34 * 32u)) + _e121)];
                                let _e133 = local_4;
                                global_4.member[((((_e32 + (_e36 * 2304u)) + 2048u) + (_e34 * 32u)) + _e121)] = (_e131 + _e133);
                                phi_1119_ = (_e121 + bitcast<u32>(1i));
                            }
                        }
                        workgroupBarrier();
                        break;
                    }
                    phi_1115_ = 0u;
                    loop {
                        let _e138 = phi_1115_;
                        if (_e138 < _e48) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e141 = (_e34 * 32u);
                            let _e146 = global_4.member[(((_e36 * 256u) + _e141) + _e138)];
                            global_4.member[((((_e32 + (_e36 * 2304u)) + 2048u) + _e141) + _e138)] = _e146;
                            phi_1115_ = (_e138 + bitcast<u32>(1i));
                        }
                    }
                    workgroupBarrier();
                    break;
                }
            }
            storageBarrier();
            workgroupBarrier();
            phi_1122_ = 0u;
            loop {
                let _e157 = phi_1122_;
                if (_e157 < _e48) {
                    let _e160 = (_e32 + (_e36 * 2304u));
                    let _e162 = (_e34 * 32u);
                    let _e167 = global_4.member[(((_e160 + 2048u) + _e162) + _e157)];
                    phi_1127_ = _e167;
                    phi_1125_ = 0u;
                    loop {
                        let _e169 = phi_1127_;
                        let _e171 = phi_1125_;
                        if (_e171 < min(8u, (_e42 | 8u))) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e179 = global_4.member[((_e160 + ((_e162 + _e157) * 8u)) + _e171)];
                            global_4.member[((_e160 + ((_e162 + _e157) * 8u)) + _e171)] = _e169;
                            phi_1127_ = (_e169 + _e179);
                            phi_1125_ = (_e171 + bitcast<u32>(1i));
                        }
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_1122_ = (_e157 + bitcast<u32>(1i));
                }
            }
            storageBarrier();
            workgroupBarrier();
            let _e187 = ((_e36 * 4096u) + (_e34 * 512u));
            phi_1123_ = _e187;
            loop {
                let _e189 = phi_1123_;
                if (_e189 < min(_e42, (_e187 + 512u))) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e195 = global_2.member[_e189];
                    let _e205 = global_4.member[(((_e32 + (_e36 * 2304u)) + ((_e195 >> bitcast<u32>(24u)) * 8u)) + _e34)];
                    global_4.member[(((_e32 + (_e36 * 2304u)) + ((_e195 >> bitcast<u32>(24u)) * 8u)) + _e34)] = (_e205 + 1u);
                    global_3.member[_e205] = (_e195 & 16777215u);
                    phi_1123_ = (_e189 + bitcast<u32>(1i));
                }
            }
            break;
        }
    }
    return;
}
