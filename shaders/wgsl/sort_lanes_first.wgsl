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
var<workgroup> global_4: array<u32, 8>;
var<workgroup> global_5: array<u32, 256>;
@group(0) @binding(2) 
var<storage> global_6: type_19;
var<workgroup> global_7: array<u32, 1024>;

@compute @workgroup_size(8, 1, 1) 
fn main(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>) {
    var phi_1041_: u32;
    var phi_1042_: u32;
    var phi_1045_: u32;
    var phi_1044_: u32;
    var phi_1059_: u32;
    var phi_1056_: u32;
    var phi_1062_: u32;
    var phi_1057_: u32;
    var local: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_1049_: u32;
    var phi_1046_: u32;
    var phi_1047_: u32;
    var local_4: u32;
    var local_5: u32;
    var local_6: u32;
    var phi_1043_: u32;
    var phi_1050_: u32;
    var phi_1055_: u32;
    var phi_1053_: u32;
    var phi_1051_: u32;
    var local_7: u32;
    var local_8: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e31 = bitcast<u32>(param[0u]);
            let _e33 = bitcast<u32>(param_1[0u]);
            let _e35 = global.member_7;
            let _e37 = global.member_5;
            let _e38 = min(_e35, _e37);
            let _e41 = max(((_e38 + 4095u) / 4096u), 1u);
            if (_e33 >= _e41) {
                break;
            }
            phi_1041_ = 0u;
            loop {
                let _e44 = phi_1041_;
                if (_e44 < 128u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    global_7[((_e44 * 8u) + _e31)] = 0u;
                    phi_1041_ = (_e44 + bitcast<u32>(1i));
                }
            }
            let _e53 = ((_e33 * 4096u) + (_e31 * 512u));
            phi_1042_ = _e53;
            loop {
                let _e55 = phi_1042_;
                let _e57 = min(_e38, (_e53 + 512u));
                local_7 = _e57;
                if (_e55 < _e57) {
                    let _e63 = global_2.member[(_e55 >> bitcast<u32>(1u))];
                    let _e68 = ((_e63 >> bitcast<u32>((16u * (_e55 & 1u)))) & 65535u);
                    let _e70 = select(_e68, 4294967295u, (_e68 == 65535u));
                    if (false || (_e70 != 4294967295u)) {
                        let _e73 = (_e70 & 255u);
                        let _e83 = global_7[(((_e73 >> bitcast<u32>(1u)) * 8u) + _e31)];
                        global_7[(((_e73 >> bitcast<u32>(1u)) * 8u) + _e31)] = (_e83 + (1u << bitcast<u32>((16u * (_e73 & 1u)))));
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_1042_ = (_e55 + bitcast<u32>(1i));
                }
            }
            switch bitcast<i32>(0u) {
                default: {
                    let _e89 = global.member_6;
                    if !((_e89 != 0u)) {
                        phi_1045_ = 0u;
                        phi_1044_ = 0u;
                        loop {
                            let _e93 = phi_1045_;
                            let _e95 = phi_1044_;
                            local_3 = _e93;
                            local_6 = _e93;
                            if (_e95 < 32u) {
                                let _e98 = ((_e31 * 32u) + _e95);
                                phi_1059_ = 0u;
                                phi_1056_ = 0u;
                                loop {
                                    let _e100 = phi_1059_;
                                    let _e102 = phi_1056_;
                                    local = _e100;
                                    local_1 = _e100;
                                    if (_e102 < _e33) {
                                        continue;
                                    } else {
                                        break;
                                    }
                                    continuing {
                                        let _e108 = global_6.member[((_e102 * 256u) + _e98)];
                                        phi_1059_ = (_e100 + _e108);
                                        phi_1056_ = (_e102 + bitcast<u32>(1i));
                                    }
                                }
                                phi_1062_ = 0u;
                                phi_1057_ = _e33;
                                loop {
                                    let _e113 = phi_1062_;
                                    let _e115 = phi_1057_;
                                    local_2 = _e113;
                                    if (_e115 < _e41) {
                                        continue;
                                    } else {
                                        break;
                                    }
                                    continuing {
                                        let _e121 = global_6.member[((_e115 * 256u) + _e98)];
                                        phi_1062_ = (_e113 + _e121);
                                        phi_1057_ = (_e115 + bitcast<u32>(1i));
                                    }
                                }
                                let _e126 = local;
                                global_5[_e98] = (_e126 + _e93);
                                let _e130 = local_1;
                                let _e132 = local_2;
                                local_8 = (_e93 + (_e130 + _e132));
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e254 = local_8;
                                phi_1045_ = _e254;
                                phi_1044_ = (_e95 + bitcast<u32>(1i));
                            }
                        }
                        let _e139 = local_3;
                        global_4[_e31] = _e139;
                        workgroupBarrier();
                        phi_1049_ = 0u;
                        phi_1046_ = 0u;
                        loop {
                            let _e141 = phi_1049_;
                            let _e143 = phi_1046_;
                            local_4 = _e141;
                            local_5 = _e141;
                            if (_e143 < _e31) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e146 = global_4[_e143];
                                phi_1049_ = (_e141 + _e146);
                                phi_1046_ = (_e143 + bitcast<u32>(1i));
                            }
                        }
                        phi_1047_ = 0u;
                        loop {
                            let _e151 = phi_1047_;
                            if (_e151 < 32u) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e156 = global_5[((_e31 * 32u) + _e151)];
                                let _e158 = local_4;
                                global_5[((_e31 * 32u) + _e151)] = (_e156 + _e158);
                                phi_1047_ = (_e151 + bitcast<u32>(1i));
                            }
                        }
                        workgroupBarrier();
                        let _e163 = local_5;
                        let _e165 = local_6;
                        let _e166 = (_e163 + _e165);
                        if ((true && (_e33 == 0u)) && (_e31 == 7u)) {
                            global_1.member.member_6 = _e166;
                            global_1.member.member_1 = ((_e166 + 127u) / 128u);
                        }
                        break;
                    }
                    phi_1043_ = _e31;
                    loop {
                        let _e178 = phi_1043_;
                        if (_e178 < 256u) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e184 = global_6.member[((_e33 * 256u) + _e178)];
                            global_5[_e178] = _e184;
                            phi_1043_ = (_e178 + 8u);
                        }
                    }
                    workgroupBarrier();
                    break;
                }
            }
            phi_1050_ = _e31;
            loop {
                let _e188 = phi_1050_;
                if (_e188 < 128u) {
                    phi_1055_ = 0u;
                    phi_1053_ = 0u;
                    loop {
                        let _e191 = phi_1055_;
                        let _e193 = phi_1053_;
                        if (_e193 < 8u) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e198 = global_7[((_e188 * 8u) + _e193)];
                            global_7[((_e188 * 8u) + _e193)] = _e191;
                            phi_1055_ = (_e191 + _e198);
                            phi_1053_ = (_e193 + bitcast<u32>(1i));
                        }
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_1050_ = (_e188 + 8u);
                }
            }
            workgroupBarrier();
            phi_1051_ = _e53;
            loop {
                let _e204 = phi_1051_;
                let _e206 = local_7;
                if (_e204 < _e206) {
                    let _e212 = global_2.member[(_e204 >> bitcast<u32>(1u))];
                    let _e217 = ((_e212 >> bitcast<u32>((16u * (_e204 & 1u)))) & 65535u);
                    let _e219 = select(_e217, 4294967295u, (_e217 == 65535u));
                    if (false || (_e219 != 4294967295u)) {
                        let _e222 = (_e219 & 255u);
                        let _e228 = global_7[(((_e222 >> bitcast<u32>(1u)) * 8u) + _e31)];
                        let _e230 = (16u * (_e222 & 1u));
                        global_7[(((_e222 >> bitcast<u32>(1u)) * 8u) + _e31)] = (_e228 + (1u << bitcast<u32>(_e230)));
                        let _e235 = global_5[_e222];
                        global_3.member[(_e235 + ((_e228 >> bitcast<u32>(_e230)) & 65535u))] = ((((_e219 >> bitcast<u32>(8u)) & 255u) << bitcast<u32>(24u)) | _e204);
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_1051_ = (_e204 + bitcast<u32>(1i));
                }
            }
            break;
        }
    }
    return;
}
