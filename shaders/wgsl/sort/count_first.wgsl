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
}

struct type_7 {
    member: array<u32>,
}

struct type_13 {
    member: array<u32, LENGTH_1_4>,
}

struct type_15 {
    member: array<u32, LENGTH_2_4>,
}

@group(0) @binding(7) 
var<uniform> global: type_4;
@group(0) @binding(1) 
var<storage> global_1: type_13;
var<workgroup> global_2: array<atomic<u32>, 256>;
@group(0) @binding(2) 
var<storage, read_write> global_3: type_15;

@compute @workgroup_size(128, 1, 1) 
fn main(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>) {
    var local: array<u32, 8>;
    var phi_396_: u32;
    var phi_397_: u32;
    var phi_398_: u32;
    var phi_400_: u32;
    var phi_406_: u32;
    var phi_401_: u32;
    var phi_300_: bool;
    var phi_399_: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e25 = global.member_4;
            let _e28 = bitcast<u32>(param[0u]);
            let _e30 = bitcast<u32>(param_1[0u]);
            let _e32 = global.member_7;
            let _e34 = global.member_5;
            let _e35 = min(_e32, _e34);
            if (_e30 >= max(((_e35 + 4095u) / 4096u), 1u)) {
                break;
            }
            phi_396_ = _e28;
            loop {
                let _e41 = phi_396_;
                if (_e41 < 256u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    atomicStore((&global_2[_e41]), 0u);
                    phi_396_ = (_e41 + 128u);
                }
            }
            if (true && (_e30 == 0u)) {
                phi_397_ = _e28;
                loop {
                    let _e48 = phi_397_;
                    if (_e48 < 784u) {
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        global_3.member[((_e25 * 256u) + _e48)] = 0u;
                        phi_397_ = (_e48 + 128u);
                    }
                }
            }
            workgroupBarrier();
            let _e56 = min(_e35, ((_e30 + 1u) * 4096u));
            phi_398_ = ((_e30 * 4096u) + _e28);
            loop {
                let _e60 = phi_398_;
                if (_e60 < _e56) {
                    phi_400_ = 0u;
                    loop {
                        let _e63 = phi_400_;
                        if (_e63 < 8u) {
                            let _e66 = (_e60 + (_e63 * 128u));
                            if (_e66 < _e56) {
                                let _e72 = global_1.member[(_e66 >> bitcast<u32>(1u))];
                                let _e77 = ((_e72 >> bitcast<u32>((16u * (_e66 & 1u)))) & 65535u);
                                phi_406_ = select(_e77, 4294967295u, (_e77 == 65535u));
                            } else {
                                phi_406_ = 0u;
                            }
                            let _e81 = phi_406_;
                            local[_e63] = _e81;
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            phi_400_ = (_e63 + bitcast<u32>(1i));
                        }
                    }
                    phi_401_ = 0u;
                    loop {
                        let _e86 = phi_401_;
                        if (_e86 < 8u) {
                            let _e90 = ((_e60 + (_e86 * 128u)) < _e56);
                            phi_300_ = _e90;
                            if _e90 {
                                let _e92 = local[_e86];
                                phi_300_ = (false || (_e92 != 4294967295u));
                            }
                            let _e96 = phi_300_;
                            if _e96 {
                                let _e98 = local[_e86];
                                let _e101 = atomicAdd((&global_2[(_e98 & 255u)]), 1u);
                            }
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            phi_401_ = (_e86 + bitcast<u32>(1i));
                        }
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_398_ = (_e60 + 1024u);
                }
            }
            workgroupBarrier();
            phi_399_ = _e28;
            loop {
                let _e106 = phi_399_;
                if (_e106 < 256u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e111 = atomicLoad((&global_2[_e106]));
                    global_3.member[((_e30 * 256u) + _e106)] = _e111;
                    phi_399_ = (_e106 + 128u);
                }
            }
            break;
        }
    }
    return;
}
