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
var<workgroup> global_4: array<u32, 8>;
var<workgroup> global_5: array<u32, 256>;
@group(0) @binding(2) 
var<storage> global_6: type_18;
var<workgroup> global_7: array<u32, 2048>;

@compute @workgroup_size(8, 1, 1) 
fn main(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>) {
    var phi_947_: u32;
    var phi_948_: u32;
    var phi_951_: u32;
    var phi_950_: u32;
    var phi_965_: u32;
    var phi_962_: u32;
    var phi_968_: u32;
    var phi_963_: u32;
    var local: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_955_: u32;
    var phi_952_: u32;
    var phi_953_: u32;
    var local_4: u32;
    var phi_949_: u32;
    var phi_956_: u32;
    var phi_961_: u32;
    var phi_959_: u32;
    var phi_957_: u32;
    var local_5: u32;
    var local_6: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e23 = bitcast<u32>(param[0u]);
            let _e25 = bitcast<u32>(param_1[0u]);
            let _e28 = global_1.member.member_6;
            let _e30 = global.member_5;
            let _e31 = min(_e28, _e30);
            let _e34 = max(((_e31 + 4095u) / 4096u), 1u);
            if (_e25 >= _e34) {
                break;
            }
            phi_947_ = 0u;
            loop {
                let _e37 = phi_947_;
                if (_e37 < 256u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    global_7[((_e37 * 8u) + _e23)] = 0u;
                    phi_947_ = (_e37 + bitcast<u32>(1i));
                }
            }
            let _e46 = ((_e25 * 4096u) + (_e23 * 512u));
            phi_948_ = _e46;
            loop {
                let _e48 = phi_948_;
                let _e50 = min(_e31, (_e46 + 512u));
                local_5 = _e50;
                if (_e48 < _e50) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e54 = global_2.member[_e48];
                    let _e60 = global_7[(((_e54 >> bitcast<u32>(24u)) * 8u) + _e23)];
                    global_7[(((_e54 >> bitcast<u32>(24u)) * 8u) + _e23)] = (_e60 + 1u);
                    phi_948_ = (_e48 + bitcast<u32>(1i));
                }
            }
            switch bitcast<i32>(0u) {
                default: {
                    let _e66 = global.member_6;
                    if !((_e66 != 0u)) {
                        phi_951_ = 0u;
                        phi_950_ = 0u;
                        loop {
                            let _e70 = phi_951_;
                            let _e72 = phi_950_;
                            local_3 = _e70;
                            if (_e72 < 32u) {
                                let _e75 = ((_e23 * 32u) + _e72);
                                phi_965_ = 0u;
                                phi_962_ = 0u;
                                loop {
                                    let _e77 = phi_965_;
                                    let _e79 = phi_962_;
                                    local = _e77;
                                    local_1 = _e77;
                                    if (_e79 < _e25) {
                                        continue;
                                    } else {
                                        break;
                                    }
                                    continuing {
                                        let _e85 = global_6.member[((_e79 * 256u) + _e75)];
                                        phi_965_ = (_e77 + _e85);
                                        phi_962_ = (_e79 + bitcast<u32>(1i));
                                    }
                                }
                                phi_968_ = 0u;
                                phi_963_ = _e25;
                                loop {
                                    let _e90 = phi_968_;
                                    let _e92 = phi_963_;
                                    local_2 = _e90;
                                    if (_e92 < _e34) {
                                        continue;
                                    } else {
                                        break;
                                    }
                                    continuing {
                                        let _e98 = global_6.member[((_e92 * 256u) + _e75)];
                                        phi_968_ = (_e90 + _e98);
                                        phi_963_ = (_e92 + bitcast<u32>(1i));
                                    }
                                }
                                let _e103 = local;
                                global_5[_e75] = (_e103 + _e70);
                                let _e107 = local_1;
                                let _e109 = local_2;
                                local_6 = (_e70 + (_e107 + _e109));
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e191 = local_6;
                                phi_951_ = _e191;
                                phi_950_ = (_e72 + bitcast<u32>(1i));
                            }
                        }
                        let _e116 = local_3;
                        global_4[_e23] = _e116;
                        workgroupBarrier();
                        phi_955_ = 0u;
                        phi_952_ = 0u;
                        loop {
                            let _e118 = phi_955_;
                            let _e120 = phi_952_;
                            local_4 = _e118;
                            if (_e120 < _e23) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e123 = global_4[_e120];
                                phi_955_ = (_e118 + _e123);
                                phi_952_ = (_e120 + bitcast<u32>(1i));
                            }
                        }
                        phi_953_ = 0u;
                        loop {
                            let _e128 = phi_953_;
                            if (_e128 < 32u) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e133 = global_5[((_e23 * 32u) + _e128)];
                                let _e135 = local_4;
                                global_5[((_e23 * 32u) + _e128)] = (_e133 + _e135);
                                phi_953_ = (_e128 + bitcast<u32>(1i));
                            }
                        }
                        workgroupBarrier();
                        break;
                    }
                    phi_949_ = _e23;
                    loop {
                        let _e140 = phi_949_;
                        if (_e140 < 256u) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e146 = global_6.member[((_e25 * 256u) + _e140)];
                            global_5[_e140] = _e146;
                            phi_949_ = (_e140 + 8u);
                        }
                    }
                    workgroupBarrier();
                    break;
                }
            }
            phi_956_ = _e23;
            loop {
                let _e150 = phi_956_;
                if (_e150 < 256u) {
                    let _e153 = global_5[_e150];
                    phi_961_ = _e153;
                    phi_959_ = 0u;
                    loop {
                        let _e155 = phi_961_;
                        let _e157 = phi_959_;
                        if (_e157 < 8u) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e162 = global_7[((_e150 * 8u) + _e157)];
                            global_7[((_e150 * 8u) + _e157)] = _e155;
                            phi_961_ = (_e155 + _e162);
                            phi_959_ = (_e157 + bitcast<u32>(1i));
                        }
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_956_ = (_e150 + 8u);
                }
            }
            workgroupBarrier();
            phi_957_ = _e46;
            loop {
                let _e168 = phi_957_;
                let _e170 = local_5;
                if (_e168 < _e170) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e174 = global_2.member[_e168];
                    let _e180 = global_7[(((_e174 >> bitcast<u32>(24u)) * 8u) + _e23)];
                    global_7[(((_e174 >> bitcast<u32>(24u)) * 8u) + _e23)] = (_e180 + 1u);
                    global_3.member[_e180] = (_e174 & 16777215u);
                    phi_957_ = (_e168 + bitcast<u32>(1i));
                }
            }
            break;
        }
    }
    return;
}
