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

struct type_13 {
    member: array<u32>,
}

struct type_15 {
    member: array<u32, LENGTH_2_4>,
}

@group(0) @binding(7) 
var<uniform> global: type_3;
@group(0) @binding(3) 
var<storage> global_1: type_6;
var<workgroup> global_2: array<u32, 256>;
var<workgroup> global_3: array<u32, 128>;
var<workgroup> global_4: array<u32, 8>;
@group(0) @binding(2) 
var<storage, read_write> global_5: type_15;

@compute @workgroup_size(128, 1, 1) 
fn main(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>) {
    var local: array<u32, 4>;
    var local_1: array<u32, 8>;
    var phi_784_: u32;
    var phi_783_: u32;
    var phi_813_: u32;
    var phi_810_: u32;
    var phi_809_: u32;
    var phi_814_: u32;
    var phi_830_: u32;
    var phi_827_: u32;
    var phi_820_: u32;
    var phi_815_: u32;
    var phi_818_: u32;
    var phi_824_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_786_: u32;
    var phi_785_: u32;
    var local_6: u32;
    var phi_792_: u32;
    var phi_787_: u32;
    var local_7: u32;
    var phi_791_: u32;
    var phi_788_: u32;
    var phi_789_: u32;
    var local_8: u32;
    var phi_793_: u32;
    var phi_794_: u32;
    var phi_804_: u32;
    var phi_796_: u32;
    var phi_807_: u32;
    var phi_802_: u32;
    var phi_797_: u32;
    var local_9: u32;
    var local_10: u32;
    var local_11: u32;
    var local_12: u32;
    var local_13: u32;
    var local_14: u32;
    var local_15: u32;
    var local_16: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e26 = global.member_4;
            let _e30 = bitcast<u32>(param[0u]);
            let _e32 = bitcast<u32>(param_1[0u]);
            let _e35 = global_1.member.member_6;
            let _e37 = global.member_5;
            let _e41 = max(((min(_e35, _e37) + 4095u) / 4096u), 1u);
            let _e43 = ((_e41 + 31u) / 32u);
            if (_e32 >= _e43) {
                break;
            }
            phi_784_ = 0u;
            phi_783_ = 0u;
            loop {
                let _e46 = phi_784_;
                let _e48 = phi_783_;
                local_5 = _e46;
                if (_e48 < 2u) {
                    let _e51 = ((_e30 * 2u) + _e48);
                    phi_813_ = 0u;
                    phi_810_ = 0u;
                    phi_809_ = 0u;
                    loop {
                        let _e53 = phi_813_;
                        let _e55 = phi_810_;
                        let _e57 = phi_809_;
                        local_2 = _e55;
                        local_3 = _e55;
                        local_4 = _e53;
                        if (_e57 < _e43) {
                            phi_814_ = 0u;
                            loop {
                                let _e60 = phi_814_;
                                if (_e60 < 4u) {
                                    let _e62 = (_e57 + _e60);
                                    if (_e62 < _e43) {
                                        let _e69 = global_5.member[((((_e26 * 256u) + 784u) + (_e62 * 256u)) + _e51)];
                                        phi_830_ = _e69;
                                    } else {
                                        phi_830_ = 0u;
                                    }
                                    let _e71 = phi_830_;
                                    local[_e60] = _e71;
                                    continue;
                                } else {
                                    break;
                                }
                                continuing {
                                    phi_814_ = (_e60 + bitcast<u32>(1i));
                                }
                            }
                            phi_827_ = _e53;
                            phi_820_ = _e55;
                            phi_815_ = 0u;
                            loop {
                                let _e76 = phi_827_;
                                let _e78 = phi_820_;
                                let _e80 = phi_815_;
                                local_10 = _e76;
                                local_11 = _e78;
                                if (_e80 < 4u) {
                                    let _e83 = ((_e57 + _e80) < _e32);
                                    if _e83 {
                                        let _e85 = local[_e80];
                                        phi_818_ = _e85;
                                    } else {
                                        phi_818_ = 0u;
                                    }
                                    let _e87 = phi_818_;
                                    local_13 = (_e78 + _e87);
                                    if _e83 {
                                        phi_824_ = 0u;
                                    } else {
                                        let _e90 = local[_e80];
                                        phi_824_ = _e90;
                                    }
                                    let _e92 = phi_824_;
                                    local_12 = (_e76 + _e92);
                                    continue;
                                } else {
                                    break;
                                }
                                continuing {
                                    let _e226 = local_12;
                                    phi_827_ = _e226;
                                    let _e229 = local_13;
                                    phi_820_ = _e229;
                                    phi_815_ = (_e80 + bitcast<u32>(1i));
                                }
                            }
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e217 = local_10;
                            phi_813_ = _e217;
                            let _e220 = local_11;
                            phi_810_ = _e220;
                            phi_809_ = (_e57 + 4u);
                        }
                    }
                    let _e98 = local_2;
                    global_2[_e51] = (_e98 + _e46);
                    let _e102 = local_3;
                    let _e104 = local_4;
                    local_9 = (_e46 + (_e102 + _e104));
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e213 = local_9;
                    phi_784_ = _e213;
                    phi_783_ = (_e48 + bitcast<u32>(1i));
                }
            }
            let _e111 = local_5;
            global_3[_e30] = _e111;
            workgroupBarrier();
            if (_e30 < 8u) {
                phi_786_ = 0u;
                phi_785_ = 0u;
                loop {
                    let _e114 = phi_786_;
                    let _e116 = phi_785_;
                    local_6 = _e114;
                    if (_e116 < 16u) {
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e121 = global_3[((_e30 * 16u) + _e116)];
                        phi_786_ = (_e114 + _e121);
                        phi_785_ = (_e116 + bitcast<u32>(1i));
                    }
                }
                let _e127 = local_6;
                global_4[_e30] = _e127;
            }
            workgroupBarrier();
            phi_792_ = 0u;
            phi_787_ = 0u;
            loop {
                let _e129 = phi_792_;
                let _e131 = phi_787_;
                let _e132 = (_e30 / 16u);
                local_7 = _e132;
                local_14 = _e129;
                if (_e131 < _e132) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e135 = global_4[_e131];
                    phi_792_ = (_e129 + _e135);
                    phi_787_ = (_e131 + bitcast<u32>(1i));
                }
            }
            let _e140 = local_7;
            let _e245 = local_14;
            phi_791_ = _e245;
            phi_788_ = (_e140 * 16u);
            loop {
                let _e143 = phi_791_;
                let _e145 = phi_788_;
                local_8 = _e143;
                if (_e145 < _e30) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e148 = global_3[_e145];
                    phi_791_ = (_e143 + _e148);
                    phi_788_ = (_e145 + bitcast<u32>(1i));
                }
            }
            phi_789_ = 0u;
            loop {
                let _e153 = phi_789_;
                if (_e153 < 2u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e158 = global_2[((_e30 * 2u) + _e153)];
                    let _e160 = local_8;
                    global_2[((_e30 * 2u) + _e153)] = (_e158 + _e160);
                    phi_789_ = (_e153 + bitcast<u32>(1i));
                }
            }
            workgroupBarrier();
            phi_793_ = _e30;
            loop {
                let _e165 = phi_793_;
                if (_e165 < 256u) {
                    let _e168 = global_2[_e165];
                    let _e171 = min(_e41, ((_e32 + 1u) * 32u));
                    phi_794_ = (_e32 * 32u);
                    phi_804_ = _e168;
                    loop {
                        let _e174 = phi_794_;
                        let _e176 = phi_804_;
                        if (_e174 < _e171) {
                            phi_796_ = 0u;
                            loop {
                                let _e179 = phi_796_;
                                if (_e179 < 8u) {
                                    let _e181 = (_e174 + _e179);
                                    if (_e181 < _e171) {
                                        let _e187 = global_5.member[((_e181 * 256u) + _e165)];
                                        phi_807_ = _e187;
                                    } else {
                                        phi_807_ = 0u;
                                    }
                                    let _e189 = phi_807_;
                                    local_1[_e179] = _e189;
                                    continue;
                                } else {
                                    break;
                                }
                                continuing {
                                    phi_796_ = (_e179 + bitcast<u32>(1i));
                                }
                            }
                            phi_802_ = _e176;
                            phi_797_ = 0u;
                            loop {
                                let _e194 = phi_802_;
                                let _e196 = phi_797_;
                                local_15 = _e194;
                                if (_e196 < 8u) {
                                    let _e198 = (_e174 + _e196);
                                    if (_e198 < _e171) {
                                        global_5.member[((_e198 * 256u) + _e165)] = _e194;
                                    }
                                    let _e205 = local_1[_e196];
                                    local_16 = (_e194 + _e205);
                                    continue;
                                } else {
                                    break;
                                }
                                continuing {
                                    let _e258 = local_16;
                                    phi_802_ = _e258;
                                    phi_797_ = (_e196 + bitcast<u32>(1i));
                                }
                            }
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            phi_794_ = (_e174 + 8u);
                            let _e253 = local_15;
                            phi_804_ = _e253;
                        }
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_793_ = (_e165 + 128u);
                }
            }
            break;
        }
    }
    return;
}
