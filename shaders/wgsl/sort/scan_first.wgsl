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

struct type_14 {
    member: array<u32>,
}

struct type_16 {
    member: array<u32, LENGTH_2_4>,
}

@group(0) @binding(7) 
var<uniform> global: type_3;
@group(0) @binding(3) 
var<storage, read_write> global_1: type_7;
var<workgroup> global_2: array<u32, 256>;
var<workgroup> global_3: array<u32, 128>;
var<workgroup> global_4: array<u32, 8>;
@group(0) @binding(2) 
var<storage, read_write> global_5: type_16;

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
    var local_9: u32;
    var local_10: u32;
    var phi_793_: u32;
    var phi_794_: u32;
    var phi_804_: u32;
    var phi_796_: u32;
    var phi_807_: u32;
    var phi_802_: u32;
    var phi_797_: u32;
    var local_11: u32;
    var local_12: u32;
    var local_13: u32;
    var local_14: u32;
    var local_15: u32;
    var local_16: u32;
    var local_17: u32;
    var local_18: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e28 = global.member_4;
            let _e32 = bitcast<u32>(param[0u]);
            let _e34 = bitcast<u32>(param_1[0u]);
            let _e36 = global.member_7;
            let _e38 = global.member_5;
            let _e42 = max(((min(_e36, _e38) + 4095u) / 4096u), 1u);
            let _e44 = ((_e42 + 31u) / 32u);
            if (_e34 >= _e44) {
                break;
            }
            phi_784_ = 0u;
            phi_783_ = 0u;
            loop {
                let _e47 = phi_784_;
                let _e49 = phi_783_;
                local_5 = _e47;
                local_10 = _e47;
                if (_e49 < 2u) {
                    let _e52 = ((_e32 * 2u) + _e49);
                    phi_813_ = 0u;
                    phi_810_ = 0u;
                    phi_809_ = 0u;
                    loop {
                        let _e54 = phi_813_;
                        let _e56 = phi_810_;
                        let _e58 = phi_809_;
                        local_2 = _e56;
                        local_3 = _e56;
                        local_4 = _e54;
                        if (_e58 < _e44) {
                            phi_814_ = 0u;
                            loop {
                                let _e61 = phi_814_;
                                if (_e61 < 4u) {
                                    let _e63 = (_e58 + _e61);
                                    if (_e63 < _e44) {
                                        let _e70 = global_5.member[((((_e28 * 256u) + 784u) + (_e63 * 256u)) + _e52)];
                                        phi_830_ = _e70;
                                    } else {
                                        phi_830_ = 0u;
                                    }
                                    let _e72 = phi_830_;
                                    local[_e61] = _e72;
                                    continue;
                                } else {
                                    break;
                                }
                                continuing {
                                    phi_814_ = (_e61 + bitcast<u32>(1i));
                                }
                            }
                            phi_827_ = _e54;
                            phi_820_ = _e56;
                            phi_815_ = 0u;
                            loop {
                                let _e77 = phi_827_;
                                let _e79 = phi_820_;
                                let _e81 = phi_815_;
                                local_12 = _e77;
                                local_13 = _e79;
                                if (_e81 < 4u) {
                                    let _e84 = ((_e58 + _e81) < _e34);
                                    if _e84 {
                                        let _e86 = local[_e81];
                                        phi_818_ = _e86;
                                    } else {
                                        phi_818_ = 0u;
                                    }
                                    let _e88 = phi_818_;
                                    local_15 = (_e79 + _e88);
                                    if _e84 {
                                        phi_824_ = 0u;
                                    } else {
                                        let _e91 = local[_e81];
                                        phi_824_ = _e91;
                                    }
                                    let _e93 = phi_824_;
                                    local_14 = (_e77 + _e93);
                                    continue;
                                } else {
                                    break;
                                }
                                continuing {
                                    let _e242 = local_14;
                                    phi_827_ = _e242;
                                    let _e245 = local_15;
                                    phi_820_ = _e245;
                                    phi_815_ = (_e81 + bitcast<u32>(1i));
                                }
                            }
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e233 = local_12;
                            phi_813_ = _e233;
                            let _e236 = local_13;
                            phi_810_ = _e236;
                            phi_809_ = (_e58 + 4u);
                        }
                    }
                    let _e99 = local_2;
                    global_2[_e52] = (_e99 + _e47);
                    let _e103 = local_3;
                    let _e105 = local_4;
                    local_11 = (_e47 + (_e103 + _e105));
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e229 = local_11;
                    phi_784_ = _e229;
                    phi_783_ = (_e49 + bitcast<u32>(1i));
                }
            }
            let _e112 = local_5;
            global_3[_e32] = _e112;
            workgroupBarrier();
            if (_e32 < 8u) {
                phi_786_ = 0u;
                phi_785_ = 0u;
                loop {
                    let _e115 = phi_786_;
                    let _e117 = phi_785_;
                    local_6 = _e115;
                    if (_e117 < 16u) {
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e122 = global_3[((_e32 * 16u) + _e117)];
                        phi_786_ = (_e115 + _e122);
                        phi_785_ = (_e117 + bitcast<u32>(1i));
                    }
                }
                let _e128 = local_6;
                global_4[_e32] = _e128;
            }
            workgroupBarrier();
            phi_792_ = 0u;
            phi_787_ = 0u;
            loop {
                let _e130 = phi_792_;
                let _e132 = phi_787_;
                let _e133 = (_e32 / 16u);
                local_7 = _e133;
                local_16 = _e130;
                if (_e132 < _e133) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e136 = global_4[_e132];
                    phi_792_ = (_e130 + _e136);
                    phi_787_ = (_e132 + bitcast<u32>(1i));
                }
            }
            let _e141 = local_7;
            let _e261 = local_16;
            phi_791_ = _e261;
            phi_788_ = (_e141 * 16u);
            loop {
                let _e144 = phi_791_;
                let _e146 = phi_788_;
                local_8 = _e144;
                local_9 = _e144;
                if (_e146 < _e32) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e149 = global_3[_e146];
                    phi_791_ = (_e144 + _e149);
                    phi_788_ = (_e146 + bitcast<u32>(1i));
                }
            }
            phi_789_ = 0u;
            loop {
                let _e154 = phi_789_;
                if (_e154 < 2u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e159 = global_2[((_e32 * 2u) + _e154)];
                    let _e161 = local_8;
                    global_2[((_e32 * 2u) + _e154)] = (_e159 + _e161);
                    phi_789_ = (_e154 + bitcast<u32>(1i));
                }
            }
            workgroupBarrier();
            let _e166 = local_9;
            let _e168 = local_10;
            let _e169 = (_e166 + _e168);
            if ((true && (_e34 == 0u)) && (_e32 == 127u)) {
                global_1.member.member_6 = _e169;
                global_1.member.member_1 = ((_e169 + 127u) / 128u);
            }
            phi_793_ = _e32;
            loop {
                let _e181 = phi_793_;
                if (_e181 < 256u) {
                    let _e184 = global_2[_e181];
                    let _e187 = min(_e42, ((_e34 + 1u) * 32u));
                    phi_794_ = (_e34 * 32u);
                    phi_804_ = _e184;
                    loop {
                        let _e190 = phi_794_;
                        let _e192 = phi_804_;
                        if (_e190 < _e187) {
                            phi_796_ = 0u;
                            loop {
                                let _e195 = phi_796_;
                                if (_e195 < 8u) {
                                    let _e197 = (_e190 + _e195);
                                    if (_e197 < _e187) {
                                        let _e203 = global_5.member[((_e197 * 256u) + _e181)];
                                        phi_807_ = _e203;
                                    } else {
                                        phi_807_ = 0u;
                                    }
                                    let _e205 = phi_807_;
                                    local_1[_e195] = _e205;
                                    continue;
                                } else {
                                    break;
                                }
                                continuing {
                                    phi_796_ = (_e195 + bitcast<u32>(1i));
                                }
                            }
                            phi_802_ = _e192;
                            phi_797_ = 0u;
                            loop {
                                let _e210 = phi_802_;
                                let _e212 = phi_797_;
                                local_17 = _e210;
                                if (_e212 < 8u) {
                                    let _e214 = (_e190 + _e212);
                                    if (_e214 < _e187) {
                                        global_5.member[((_e214 * 256u) + _e181)] = _e210;
                                    }
                                    let _e221 = local_1[_e212];
                                    local_18 = (_e210 + _e221);
                                    continue;
                                } else {
                                    break;
                                }
                                continuing {
                                    let _e276 = local_18;
                                    phi_802_ = _e276;
                                    phi_797_ = (_e212 + bitcast<u32>(1i));
                                }
                            }
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            phi_794_ = (_e190 + 8u);
                            let _e271 = local_17;
                            phi_804_ = _e271;
                        }
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_793_ = (_e181 + 128u);
                }
            }
            break;
        }
    }
    return;
}
