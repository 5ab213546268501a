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

struct type_16 {
    member: array<u32, LENGTH_1_4>,
}

struct type_18 {
    member: array<u32, LENGTH_4_4>,
}

struct type_20 {
    member: array<u32, LENGTH_2_4>,
}

@group(0) @binding(7) 
var<uniform> global: type_4;
@group(0) @binding(3) 
var<storage, read_write> global_1: type_7;
@group(0) @binding(1) 
var<storage> global_2: type_16;
@group(0) @binding(4) 
var<storage, read_write> global_3: type_18;
var<workgroup> global_4: array<u32, 256>;
var<workgroup> global_5: array<u32, 128>;
@group(0) @binding(2) 
var<storage> global_6: type_20;
var<workgroup> global_7: array<atomic<u32>, 2048>;

@compute @workgroup_size(128, 1, 1) 
fn main(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>) {
    var phi_1015_: u32;
    var phi_1018_: u32;
    var phi_1017_: u32;
    var phi_1068_: u32;
    var phi_1065_: u32;
    var phi_1073_: u32;
    var phi_1066_: u32;
    var local: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_1022_: u32;
    var phi_1019_: u32;
    var phi_1020_: u32;
    var local_4: u32;
    var local_5: u32;
    var local_6: u32;
    var phi_1016_: u32;
    var phi_1024_: u32;
    var phi_1023_: u32;
    var phi_1036_: u32;
    var phi_1026_: u32;
    var phi_1025_: bool;
    var phi_1044_: u32;
    var phi_1031_: u32;
    var phi_1028_: u32;
    var phi_1059_: u32;
    var phi_1060_: u32;
    var local_7: u32;
    var phi_1041_: u32;
    var phi_1039_: u32;
    var phi_1045_: u32;
    var local_8: u32;
    var local_9: u32;
    var local_10: u32;
    var local_11: u32;
    var local_12: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e34 = bitcast<u32>(param[0u]);
            let _e36 = bitcast<u32>(param_1[0u]);
            let _e38 = global.member_7;
            let _e40 = global.member_5;
            let _e41 = min(_e38, _e40);
            let _e44 = max(((_e41 + 4095u) / 4096u), 1u);
            if (_e36 >= _e44) {
                break;
            }
            phi_1015_ = _e34;
            loop {
                let _e47 = phi_1015_;
                if (_e47 < 2048u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    atomicStore((&global_7[_e47]), 0u);
                    phi_1015_ = (_e47 + 128u);
                }
            }
            switch bitcast<i32>(0u) {
                default: {
                    let _e53 = global.member_6;
                    if !((_e53 != 0u)) {
                        phi_1018_ = 0u;
                        phi_1017_ = 0u;
                        loop {
                            let _e57 = phi_1018_;
                            let _e59 = phi_1017_;
                            local_3 = _e57;
                            local_6 = _e57;
                            if (_e59 < 2u) {
                                let _e62 = ((_e34 * 2u) + _e59);
                                phi_1068_ = 0u;
                                phi_1065_ = 0u;
                                loop {
                                    let _e64 = phi_1068_;
                                    let _e66 = phi_1065_;
                                    local = _e64;
                                    local_1 = _e64;
                                    if (_e66 < _e36) {
                                        continue;
                                    } else {
                                        break;
                                    }
                                    continuing {
                                        let _e72 = global_6.member[((_e66 * 256u) + _e62)];
                                        phi_1068_ = (_e64 + _e72);
                                        phi_1065_ = (_e66 + bitcast<u32>(1i));
                                    }
                                }
                                phi_1073_ = 0u;
                                phi_1066_ = _e36;
                                loop {
                                    let _e77 = phi_1073_;
                                    let _e79 = phi_1066_;
                                    local_2 = _e77;
                                    if (_e79 < _e44) {
                                        continue;
                                    } else {
                                        break;
                                    }
                                    continuing {
                                        let _e85 = global_6.member[((_e79 * 256u) + _e62)];
                                        phi_1073_ = (_e77 + _e85);
                                        phi_1066_ = (_e79 + bitcast<u32>(1i));
                                    }
                                }
                                let _e90 = local;
                                global_4[_e62] = (_e90 + _e57);
                                let _e94 = local_1;
                                let _e96 = local_2;
                                local_8 = (_e57 + (_e94 + _e96));
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e266 = local_8;
                                phi_1018_ = _e266;
                                phi_1017_ = (_e59 + bitcast<u32>(1i));
                            }
                        }
                        let _e103 = local_3;
                        global_5[_e34] = _e103;
                        workgroupBarrier();
                        phi_1022_ = 0u;
                        phi_1019_ = 0u;
                        loop {
                            let _e105 = phi_1022_;
                            let _e107 = phi_1019_;
                            local_4 = _e105;
                            local_5 = _e105;
                            if (_e107 < _e34) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e110 = global_5[_e107];
                                phi_1022_ = (_e105 + _e110);
                                phi_1019_ = (_e107 + bitcast<u32>(1i));
                            }
                        }
                        phi_1020_ = 0u;
                        loop {
                            let _e115 = phi_1020_;
                            if (_e115 < 2u) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e120 = global_4[((_e34 * 2u) + _e115)];
                                let _e122 = local_4;
                                global_4[((_e34 * 2u) + _e115)] = (_e120 + _e122);
                                phi_1020_ = (_e115 + bitcast<u32>(1i));
                            }
                        }
                        workgroupBarrier();
                        let _e127 = local_5;
                        let _e129 = local_6;
                        let _e130 = (_e127 + _e129);
                        if ((true && (_e36 == 0u)) && (_e34 == 127u)) {
                            global_1.member.member_6 = _e130;
                            global_1.member.member_1 = ((_e130 + 127u) / 128u);
                        }
                        break;
                    }
                    phi_1016_ = 0u;
                    loop {
                        let _e142 = phi_1016_;
                        if (_e142 < 2u) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e145 = (_e34 * 2u);
                            let _e150 = global_6.member[(((_e36 * 256u) + _e145) + _e142)];
                            global_4[(_e145 + _e142)] = _e150;
                            phi_1016_ = (_e142 + bitcast<u32>(1i));
                        }
                    }
                    workgroupBarrier();
                    break;
                }
            }
            let _e155 = (_e34 / 32u);
            let _e158 = (1u << bitcast<u32>((_e34 & 31u)));
            let _e162 = min(_e41, ((_e36 + 1u) * 4096u));
            phi_1024_ = 0u;
            phi_1023_ = (_e36 * 4096u);
            loop {
                let _e165 = phi_1024_;
                let _e167 = phi_1023_;
                if (_e167 < _e162) {
                    let _e169 = (_e167 + _e34);
                    let _e171 = ((_e165 & 1u) * 1024u);
                    let _e172 = (_e169 < _e162);
                    phi_1036_ = 0u;
                    phi_1026_ = 0u;
                    phi_1025_ = _e172;
                    if _e172 {
                        let _e177 = global_2.member[(_e169 >> bitcast<u32>(1u))];
                        let _e182 = ((_e177 >> bitcast<u32>((16u * (_e169 & 1u)))) & 65535u);
                        let _e184 = select(_e182, 4294967295u, (_e182 == 65535u));
                        phi_1036_ = _e184;
                        phi_1026_ = (_e184 & 255u);
                        phi_1025_ = (false || (_e184 != 4294967295u));
                    }
                    let _e189 = phi_1036_;
                    let _e191 = phi_1026_;
                    let _e193 = phi_1025_;
                    if _e193 {
                        let _e198 = atomicOr((&global_7[((_e171 + (_e155 * 256u)) + _e191)]), _e158);
                    }
                    workgroupBarrier();
                    phi_1041_ = 0u;
                    phi_1039_ = 0u;
                    if _e193 {
                        phi_1044_ = 0u;
                        phi_1031_ = 0u;
                        phi_1028_ = 0u;
                        loop {
                            let _e200 = phi_1044_;
                            let _e202 = phi_1031_;
                            let _e204 = phi_1028_;
                            local_7 = _e202;
                            local_11 = _e200;
                            local_12 = _e202;
                            if (_e204 < 4u) {
                                let _e210 = atomicLoad((&global_7[((_e171 + (_e204 * 256u)) + _e191)]));
                                let _e212 = bitcast<u32>(countOneBits(_e210));
                                local_9 = (_e200 + _e212);
                                if (_e204 < _e155) {
                                    phi_1060_ = _e212;
                                } else {
                                    if (_e204 == _e155) {
                                        phi_1059_ = bitcast<u32>(countOneBits((_e210 & (_e158 - 1u))));
                                    } else {
                                        phi_1059_ = 0u;
                                    }
                                    let _e220 = phi_1059_;
                                    phi_1060_ = _e220;
                                }
                                let _e222 = phi_1060_;
                                local_10 = (_e202 + _e222);
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e290 = local_9;
                                phi_1044_ = _e290;
                                let _e293 = local_10;
                                phi_1031_ = _e293;
                                phi_1028_ = (_e204 + bitcast<u32>(1i));
                            }
                        }
                        let _e227 = global_4[_e191];
                        let _e229 = local_7;
                        global_3.member[(_e227 + _e229)] = (((((_e189 >> bitcast<u32>(8u)) << bitcast<u32>(24u)) >> bitcast<u32>(24u)) << bitcast<u32>(24u)) | _e169);
                        let _e300 = local_11;
                        phi_1041_ = _e300;
                        let _e303 = local_12;
                        phi_1039_ = _e303;
                    }
                    let _e243 = phi_1041_;
                    let _e245 = phi_1039_;
                    workgroupBarrier();
                    if (_e193 && (_e245 == 0u)) {
                        let _e249 = global_4[_e191];
                        global_4[_e191] = (_e249 + _e243);
                        phi_1045_ = 0u;
                        loop {
                            let _e252 = phi_1045_;
                            if (_e252 < 4u) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                atomicStore((&global_7[((_e171 + (_e252 * 256u)) + _e191)]), 0u);
                                phi_1045_ = (_e252 + bitcast<u32>(1i));
                            }
                        }
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_1024_ = (_e165 + bitcast<u32>(1i));
                    phi_1023_ = (_e167 + 128u);
                }
            }
            break;
        }
    }
    return;
}
