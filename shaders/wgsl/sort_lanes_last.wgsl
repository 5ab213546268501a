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
var<workgroup> global_4: array<u32, 8>;
@group(0) @binding(2) 
var<storage, read_write> global_5: type_16;

@compute @workgroup_size(8, 1, 1) 
fn main(@builtin(workgroup_id) param: vec3<u32>, @builtin(local_invocation_id) param_1: vec3<u32>) {
    var phi_1029_: u32;
    var phi_1028_: u32;
    var phi_1045_: u32;
    var phi_1040_: u32;
    var phi_1048_: u32;
    var phi_1041_: u32;
    var local: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_1033_: u32;
    var phi_1030_: u32;
    var phi_1031_: u32;
    var local_4: u32;
    var phi_1027_: u32;
    var phi_1034_: u32;
    var phi_1039_: u32;
    var phi_1037_: u32;
    var phi_1035_: u32;
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
                        phi_1029_ = 0u;
                        phi_1028_ = 0u;
                        loop {
                            let _e57 = phi_1029_;
                            let _e59 = phi_1028_;
                            local_3 = _e57;
                            if (_e59 < _e48) {
                                let _e61 = (_e34 * 32u);
                                let _e62 = (_e61 + _e59);
                                phi_1045_ = 0u;
                                phi_1040_ = 0u;
                                loop {
                                    let _e64 = phi_1045_;
                                    let _e66 = phi_1040_;
                                    local = _e64;
                                    local_1 = _e64;
                                    if (_e66 < _e36) {
                                        continue;
                                    } else {
                                        break;
                                    }
                                    continuing {
                                        let _e72 = global_5.member[((_e66 * 256u) + _e62)];
                                        phi_1045_ = (_e64 + _e72);
                                        phi_1040_ = (_e66 + bitcast<u32>(1i));
                                    }
                                }
                                phi_1048_ = 0u;
                                phi_1041_ = _e36;
                                loop {
                                    let _e77 = phi_1048_;
                                    let _e79 = phi_1041_;
                                    local_2 = _e77;
                                    if (_e79 < _e45) {
                                        continue;
                                    } else {
                                        break;
                                    }
                                    continuing {
                                        let _e85 = global_5.member[((_e79 * 256u) + _e62)];
                                        phi_1048_ = (_e77 + _e85);
                                        phi_1041_ = (_e79 + bitcast<u32>(1i));
                                    }
                                }
                                let _e95 = local;
                                global_5.member[((((_e32 + (_e36 * 2304u)) + 2048u) + _e61) + _e59)] = (_e95 + _e57);
                                let _e100 = local_1;
                                let _e102 = local_2;
                                local_5 = (_e57 + (_e100 + _e102));
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e214 = local_5;
                                phi_1029_ = _e214;
                                phi_1028_ = (_e59 + bitcast<u32>(1i));
                            }
                        }
                        let _e109 = local_3;
                        global_4[_e34] = _e109;
                        workgroupBarrier();
                        phi_1033_ = 0u;
                        phi_1030_ = 0u;
                        loop {
                            let _e111 = phi_1033_;
                            let _e113 = phi_1030_;
                            local_4 = _e111;
                            if (_e113 < _e34) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e116 = global_4[_e113];
                                phi_1033_ = (_e111 + _e116);
                                phi_1030_ = (_e113 + bitcast<u32>(1i));
                            }
                        }
                        phi_1031_ = 0u;
                        loop {
                            let _e121 = phi_1031_;
                            if (_e121 < _e48) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e131 = global_5.member[((((_e32 + (_e36 * 2304u)) + 2048u) + (_e34 * 32u)) + _e121)];
                                let _e133 = local_4;
                                global_5.member[((((_e32 + (_e36 * 2304u)) + 2048u) + (_e34 * 32u)) + _e121)] = (_e131 + _e133);
                                phi_1031_ = (_e121 + bitcast<u32>(1i));
                            }
                        }
                        workgroupBarrier();
                        break;
                    }
                    phi_1027_ = 0u;
                    loop {
                        let _e138 = phi_1027_;
                        if (_e138 < _e48) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e143 = (_e34 * 32u);
                            let _e151 = global_5.member[(((_e36 * 256u) + _e143) + _e138)];
                            global_5.member[((((_e32 + (_e36 * 2304u)) + 2048u) + _e143) + _e138)] = _e151;
                            phi_1027_ = (_e138 + bitcast<u32>(1i));
                        }
                    }
                    workgroupBarrier();
                    break;
                }
            }
            storageBarrier();
            workgroupBarrier();
            phi_1034_ = 0u;
            loop {
                let _e157 = phi_1034_;
                if (_e157 < _e48) {
                    let _e160 = (_e32 + (_e36 * 2304u));
                    let _e162 = (_e34 * 32u);
                    let _e167 = global_5.member[(((_e160 + 2048u) + _e162) + _e157)];
                    phi_1039_ = _e167;
                    phi_1037_ = 0u;
                    loop {
                        let _e169 = phi_1039_;
                        let _e171 = phi_1037_;
                        if (_e171 < min(8u, (_e42 | 8u))) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e179 = global_5.member[((_e160 + ((_e162 + _e157) * 8u)) + _e171)];
                            global_5.member[((_e160 + ((_e162 + _e157) * 8u)) + _e171)] = _e169;
                            phi_1039_ = (_e169 + _e179);
                            phi_1037_ = (_e171 + bitcast<u32>(1i));
                        }
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_1034_ = (_e157 + bitcast<u32>(1i));
                }
            }
            storageBarrier();
            workgroupBarrier();
            let _e187 = ((_e36 * 4096u) + (_e34 * 512u));
            phi_1035_ = _e187;
            loop {
                let _e189 = phi_1035_;
                if (_e189 < min(_e42, (_e187 + 512u))) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e195 = global_2.member[_e189];
                    let _e205 = global_5.member[(((_e32 + (_e36 * 2304u)) + ((_e195 >> bitcast<u32>(24u)) * 8u)) + _e34)];
                    global_5.member[(((_e32 + (_e36 * 2304u)) + ((_e195 >> bitcast<u32>(24u)) * 8u)) + _e34)] = (_e205 + 1u);
                    global_3.member[_e205] = (_e195 & 16777215u);
                    phi_1035_ = (_e189 + bitcast<u32>(1i));
                }
            }
            break;
        }
    }
    return;
}
