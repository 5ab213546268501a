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
var<workgroup> global_7: array<u32, 2048>;

@compute @workgroup_size(8, 1, 1) 
fn main(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>) {
    var phi_966_: u32;
    var phi_967_: u32;
    var phi_970_: u32;
    var phi_969_: u32;
    var phi_984_: u32;
    var phi_981_: u32;
    var phi_987_: u32;
    var phi_982_: u32;
    var local: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_974_: u32;
    var phi_971_: u32;
    var phi_972_: u32;
    var local_4: u32;
    var local_5: u32;
    var local_6: u32;
    var phi_968_: u32;
    var phi_975_: u32;
    var phi_980_: u32;
    var phi_978_: u32;
    var phi_976_: u32;
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
            phi_966_ = 0u;
            loop {
                let _e44 = phi_966_;
                if (_e44 < 256u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    global_7[((_e44 * 8u) + _e31)] = 0u;
                    phi_966_ = (_e44 + bitcast<u32>(1i));
                }
            }
            let _e53 = ((_e33 * 4096u) + (_e31 * 512u));
            phi_967_ = _e53;
            loop {
                let _e55 = phi_967_;
                let _e57 = min(_e38, (_e53 + 512u));
                local_7 = _e57;
                if (_e55 < _e57) {
                    let _e63 = global_2.member[(_e55 >> bitcast<u32>(1u))];
                    let _e68 = ((_e63 >> bitcast<u32>((16u * (_e55 & 1u)))) & 65535u);
                    let _e70 = select(_e68, 4294967295u, (_e68 == 65535u));
                    if (false || (_e70 != 4294967295u)) {
                        let _e77 = global_7[(((_e70 & 255u) * 8u) + _e31)];
                        global_7[(((_e70 & 255u) * 8u) + _e31)] = (_e77 + 1u);
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_967_ = (_e55 + bitcast<u32>(1i));
                }
            }
            switch bitcast<i32>(0u) {
                default: {
                    let _e83 = global.member_6;
                    if !((_e83 != 0u)) {
                        phi_970_ = 0u;
                        phi_969_ = 0u;
                        loop {
                            let _e87 = phi_970_;
                            let _e89 = phi_969_;
                            local_3 = _e87;
                            local_6 = _e87;
                            if (_e89 < 32u) {
                                let _e92 = ((_e31 * 32u) + _e89);
                                phi_984_ = 0u;
                                phi_981_ = 0u;
                                loop {
                                    let _e94 = phi_984_;
                                    let _e96 = phi_981_;
                                    local = _e94;
                                    local_1 = _e94;
                                    if (_e96 < _e33) {
                                        continue;
                                    } else {
                                        break;
                                    }
                                    continuing {
                                        let _e102 = global_6.member[((_e96 * 256u) + _e92)];
                                        phi_984_ = (_e94 + _e102);
                                        phi_981_ = (_e96 + bitcast<u32>(1i));
                                    }
                                }
                                phi_987_ = 0u;
                                phi_982_ = _e33;
                                loop {
                                    let _e107 = phi_987_;
                                    let _e109 = phi_982_;
                                    local_2 = _e107;
                                    if (_e109 < _e41) {
                                        continue;
                                    } else {
                                        break;
                                    }
                                    continuing {
                                        let _e115 = global_6.member[((_e109 * 256u) + _e92)];
                                        phi_987_ = (_e107 + _e115);
                                        phi_982_ = (_e109 + bitcast<u32>(1i));
                                    }
                                }
                                let _e120 = local;
                                global_5[_e92] = (_e120 + _e87);
                                let _e124 = local_1;
                                let _e126 = local_2;
                                local_8 = (_e87 + (_e124 + _e126));
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e238 = local_8;
                                phi_970_ = _e238;
                                phi_969_ = (_e89 + bitcast<u32>(1i));
                            }
                        }
                        let _e133 = local_3;
                        global_4[_e31] = _e133;
                        workgroupBarrier();
                        phi_974_ = 0u;
                        phi_971_ = 0u;
                        loop {
                            let _e135 = phi_974_;
                            let _e137 = phi_971_;
                            local_4 = _e135;
                            local_5 = _e135;
                            if (_e137 < _e31) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e140 = global_4[_e137];
                                phi_974_ = (_e135 + _e140);
                                phi_971_ = (_e137 + bitcast<u32>(1i));
                            }
                        }
                        phi_972_ = 0u;
                        loop {
                            let _e145 = phi_972_;
                            if (_e145 < 32u) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e150 = global_5[((_e31 * 32u) + _e145)];
                                let _e152 = local_4;
                                global_5[((_e31 * 32u) + _e145)] = (_e150 + _e152);
                                phi_972_ = (_e145 + bitcast<u32>(1i));
                            }
                        }
                        workgroupBarrier();
                        let _e157 = local_5;
                        let _e159 = local_6;
                        let _e160 = (_e157 + _e159);
                        if ((true && (_e33 == 0u)) && (_e31 == 7u)) {
                            global_1.member.member_6 = _e160;
                            global_1.member.member_1 = ((_e160 + 127u) / 128u);
                        }
                        break;
                    }
                    phi_968_ = _e31;
                    loop {
                        let _e172 = phi_968_;
                        if (_e172 < 256u) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e178 = global_6.member[((_e33 * 256u) + _e172)];
                            global_5[_e172] = _e178;
                            phi_968_ = (_e172 + 8u);
                        }
                    }
                    workgroupBarrier();
                    break;
                }
            }
            phi_975_ = _e31;
            loop {
                let _e182 = phi_975_;
                if (_e182 < 256u) {
                    let _e185 = global_5[_e182];
                    phi_980_ = _e185;
                    phi_978_ = 0u;
                    loop {
                        let _e187 = phi_980_;
                        let _e189 = phi_978_;
                        if (_e189 < 8u) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e194 = global_7[((_e182 * 8u) + _e189)];
                            global_7[((_e182 * 8u) + _e189)] = _e187;
                            phi_980_ = (_e187 + _e194);
                            phi_978_ = (_e189 + bitcast<u32>(1i));
                        }
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_975_ = (_e182 + 8u);
                }
            }
            workgroupBarrier();
            phi_976_ = _e53;
            loop {
                let _e200 = phi_976_;
                let _e202 = local_7;
                if (_e200 < _e202) {
                    let _e208 = global_2.member[(_e200 >> bitcast<u32>(1u))];
                    let _e213 = ((_e208 >> bitcast<u32>((16u * (_e200 & 1u)))) & 65535u);
                    let _e215 = select(_e213, 4294967295u, (_e213 == 65535u));
                    if (false || (_e215 != 4294967295u)) {
                        let _e222 = global_7[(((_e215 & 255u) * 8u) + _e31)];
                        global_7[(((_e215 & 255u) * 8u) + _e31)] = (_e222 + 1u);
                        global_3.member[_e222] = ((((_e215 >> bitcast<u32>(8u)) & 255u) << bitcast<u32>(24u)) | _e200);
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_976_ = (_e200 + bitcast<u32>(1i));
                }
            }
            break;
        }
    }
    return;
}
