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
var<storage> global_1: type_7;
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
    var phi_948_: u32;
    var phi_951_: u32;
    var phi_950_: u32;
    var phi_1001_: u32;
    var phi_998_: u32;
    var phi_1006_: u32;
    var phi_999_: u32;
    var local: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_955_: u32;
    var phi_952_: u32;
    var phi_953_: u32;
    var local_4: u32;
    var phi_949_: u32;
    var phi_957_: u32;
    var phi_956_: u32;
    var phi_969_: u32;
    var phi_959_: u32;
    var phi_977_: u32;
    var phi_964_: u32;
    var phi_961_: u32;
    var phi_992_: u32;
    var phi_993_: u32;
    var local_5: u32;
    var phi_974_: u32;
    var phi_972_: u32;
    var phi_978_: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var local_9: u32;
    var local_10: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e28 = bitcast<u32>(param[0u]);
            let _e30 = bitcast<u32>(param_1[0u]);
            let _e33 = global_1.member.member_6;
            let _e35 = global.member_5;
            let _e36 = min(_e33, _e35);
            let _e39 = max(((_e36 + 4095u) / 4096u), 1u);
            if (_e30 >= _e39) {
                break;
            }
            phi_948_ = _e28;
            loop {
                let _e42 = phi_948_;
                if (_e42 < 2048u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    atomicStore((&global_7[_e42]), 0u);
                    phi_948_ = (_e42 + 128u);
                }
            }
            switch bitcast<i32>(0u) {
                default: {
                    let _e48 = global.member_6;
                    if !((_e48 != 0u)) {
                        phi_951_ = 0u;
                        phi_950_ = 0u;
                        loop {
                            let _e52 = phi_951_;
                            let _e54 = phi_950_;
                            local_3 = _e52;
                            if (_e54 < 2u) {
                                let _e57 = ((_e28 * 2u) + _e54);
                                phi_1001_ = 0u;
                                phi_998_ = 0u;
                                loop {
                                    let _e59 = phi_1001_;
                                    let _e61 = phi_998_;
                                    local = _e59;
                                    local_1 = _e59;
                                    if (_e61 < _e30) {
                                        continue;
                                    } else {
                                        break;
                                    }
                                    continuing {
                                        let _e67 = global_6.member[((_e61 * 256u) + _e57)];
                                        phi_1001_ = (_e59 + _e67);
                                        phi_998_ = (_e61 + bitcast<u32>(1i));
                                    }
                                }
                                phi_1006_ = 0u;
                                phi_999_ = _e30;
                                loop {
                                    let _e72 = phi_1006_;
                                    let _e74 = phi_999_;
                                    local_2 = _e72;
                                    if (_e74 < _e39) {
                                        continue;
                                    } else {
                                        break;
                                    }
                                    continuing {
                                        let _e80 = global_6.member[((_e74 * 256u) + _e57)];
                                        phi_1006_ = (_e72 + _e80);
                                        phi_999_ = (_e74 + bitcast<u32>(1i));
                                    }
                                }
                                let _e85 = local;
                                global_4[_e57] = (_e85 + _e52);
                                let _e89 = local_1;
                                let _e91 = local_2;
                                local_6 = (_e52 + (_e89 + _e91));
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e227 = local_6;
                                phi_951_ = _e227;
                                phi_950_ = (_e54 + bitcast<u32>(1i));
                            }
                        }
                        let _e98 = local_3;
                        global_5[_e28] = _e98;
                        workgroupBarrier();
                        phi_955_ = 0u;
                        phi_952_ = 0u;
                        loop {
                            let _e100 = phi_955_;
                            let _e102 = phi_952_;
                            local_4 = _e100;
                            if (_e102 < _e28) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e105 = global_5[_e102];
                                phi_955_ = (_e100 + _e105);
                                phi_952_ = (_e102 + bitcast<u32>(1i));
                            }
                        }
                        phi_953_ = 0u;
                        loop {
                            let _e110 = phi_953_;
                            if (_e110 < 2u) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e115 = global_4[((_e28 * 2u) + _e110)];
                                let _e117 = local_4;
                                global_4[((_e28 * 2u) + _e110)] = (_e115 + _e117);
                                phi_953_ = (_e110 + bitcast<u32>(1i));
                            }
                        }
                        workgroupBarrier();
                        break;
                    }
                    phi_949_ = 0u;
                    loop {
                        let _e122 = phi_949_;
                        if (_e122 < 2u) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e125 = (_e28 * 2u);
                            let _e130 = global_6.member[(((_e30 * 256u) + _e125) + _e122)];
                            global_4[(_e125 + _e122)] = _e130;
                            phi_949_ = (_e122 + bitcast<u32>(1i));
                        }
                    }
                    workgroupBarrier();
                    break;
                }
            }
            let _e135 = (_e28 / 32u);
            let _e138 = (1u << bitcast<u32>((_e28 & 31u)));
            let _e142 = min(_e36, ((_e30 + 1u) * 4096u));
            phi_957_ = 0u;
            phi_956_ = (_e30 * 4096u);
            loop {
                let _e145 = phi_957_;
                let _e147 = phi_956_;
                if (_e147 < _e142) {
                    let _e149 = (_e147 + _e28);
                    let _e151 = ((_e145 & 1u) * 1024u);
                    let _e152 = (_e149 < _e142);
                    phi_969_ = 0u;
                    phi_959_ = 0u;
                    if _e152 {
                        let _e155 = global_2.member[_e149];
                        phi_969_ = _e155;
                        phi_959_ = (_e155 >> bitcast<u32>(24u));
                    }
                    let _e159 = phi_969_;
                    let _e161 = phi_959_;
                    let _e162 = select(_e152, true, _e152);
                    if _e162 {
                        let _e167 = atomicOr((&global_7[((_e151 + (_e135 * 256u)) + _e161)]), _e138);
                    }
                    workgroupBarrier();
                    phi_974_ = 0u;
                    phi_972_ = 0u;
                    if _e162 {
                        phi_977_ = 0u;
                        phi_964_ = 0u;
                        phi_961_ = 0u;
                        loop {
                            let _e169 = phi_977_;
                            let _e171 = phi_964_;
                            let _e173 = phi_961_;
                            local_5 = _e171;
                            local_9 = _e169;
                            local_10 = _e171;
                            if (_e173 < 4u) {
                                let _e179 = atomicLoad((&global_7[((_e151 + (_e173 * 256u)) + _e161)]));
                                let _e181 = bitcast<u32>(countOneBits(_e179));
                                local_7 = (_e169 + _e181);
                                if (_e173 < _e135) {
                                    phi_993_ = _e181;
                                } else {
                                    if (_e173 == _e135) {
                                        phi_992_ = bitcast<u32>(countOneBits((_e179 & (_e138 - 1u))));
                                    } else {
                                        phi_992_ = 0u;
                                    }
                                    let _e189 = phi_992_;
                                    phi_993_ = _e189;
                                }
                                let _e191 = phi_993_;
                                local_8 = (_e171 + _e191);
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e248 = local_7;
                                phi_977_ = _e248;
                                let _e251 = local_8;
                                phi_964_ = _e251;
                                phi_961_ = (_e173 + bitcast<u32>(1i));
                            }
                        }
                        let _e196 = global_4[_e161];
                        let _e198 = local_5;
                        global_3.member[(_e196 + _e198)] = (_e159 & 16777215u);
                        let _e258 = local_9;
                        phi_974_ = _e258;
                        let _e261 = local_10;
                        phi_972_ = _e261;
                    }
                    let _e204 = phi_974_;
                    let _e206 = phi_972_;
                    workgroupBarrier();
                    if (_e162 && (_e206 == 0u)) {
                        let _e210 = global_4[_e161];
                        global_4[_e161] = (_e210 + _e204);
                        phi_978_ = 0u;
                        loop {
                            let _e213 = phi_978_;
                            if (_e213 < 4u) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                atomicStore((&global_7[((_e151 + (_e213 * 256u)) + _e161)]), 0u);
                                phi_978_ = (_e213 + bitcast<u32>(1i));
                            }
                        }
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_957_ = (_e145 + bitcast<u32>(1i));
                    phi_956_ = (_e147 + 128u);
                }
            }
            break;
        }
    }
    return;
}
