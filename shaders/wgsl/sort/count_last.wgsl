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
    member: array<u32, LENGTH_2_4>,
}

@group(0) @binding(7) 
var<uniform> global: type_4;
@group(0) @binding(3) 
var<storage> global_1: type_7;
@group(0) @binding(1) 
var<storage> global_2: type_15;
var<workgroup> global_3: array<atomic<u32>, 256>;
@group(0) @binding(2) 
var<storage, read_write> global_4: type_17;

@compute @workgroup_size(128, 1, 1) 
fn main(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>) {
    var local: array<u32, 8>;
    var phi_389_: u32;
    var phi_391_: u32;
    var phi_393_: u32;
    var phi_399_: u32;
    var phi_394_: u32;
    var phi_392_: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e22 = bitcast<u32>(param[0u]);
            let _e24 = bitcast<u32>(param_1[0u]);
            let _e27 = global_1.member.member_6;
            let _e29 = global.member_5;
            let _e30 = min(_e27, _e29);
            if (_e24 >= max(((_e30 + 4095u) / 4096u), 1u)) {
                break;
            }
            phi_389_ = _e22;
            loop {
                let _e36 = phi_389_;
                if (_e36 < 256u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    atomicStore((&global_3[_e36]), 0u);
                    phi_389_ = (_e36 + 128u);
                }
            }
            workgroupBarrier();
            let _e42 = min(_e30, ((_e24 + 1u) * 4096u));
            phi_391_ = ((_e24 * 4096u) + _e22);
            loop {
                let _e46 = phi_391_;
                if (_e46 < _e42) {
                    phi_393_ = 0u;
                    loop {
                        let _e49 = phi_393_;
                        if (_e49 < 8u) {
                            let _e52 = (_e46 + (_e49 * 128u));
                            if (_e52 < _e42) {
                                let _e56 = global_2.member[_e52];
                                phi_399_ = _e56;
                            } else {
                                phi_399_ = 0u;
                            }
                            let _e58 = phi_399_;
                            local[_e49] = _e58;
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            phi_393_ = (_e49 + bitcast<u32>(1i));
                        }
                    }
                    phi_394_ = 0u;
                    loop {
                        let _e63 = phi_394_;
                        if (_e63 < 8u) {
                            let _e67 = ((_e46 + (_e63 * 128u)) < _e42);
                            if select(_e67, true, _e67) {
                                let _e70 = local[_e63];
                                let _e75 = atomicAdd((&global_3[((_e70 >> bitcast<u32>(24u)) & 255u)]), 1u);
                            }
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            phi_394_ = (_e63 + bitcast<u32>(1i));
                        }
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_391_ = (_e46 + 1024u);
                }
            }
            workgroupBarrier();
            phi_392_ = _e22;
            loop {
                let _e80 = phi_392_;
                if (_e80 < 256u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e85 = atomicLoad((&global_3[_e80]));
                    global_4.member[((_e24 * 256u) + _e80)] = _e85;
                    phi_392_ = (_e80 + 128u);
                }
            }
            break;
        }
    }
    return;
}
