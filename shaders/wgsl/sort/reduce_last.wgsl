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

struct type_10 {
    member: array<u32>,
}

struct type_12 {
    member: array<u32, LENGTH_2_4>,
}

@group(0) @binding(7) 
var<uniform> global: type_3;
@group(0) @binding(3) 
var<storage> global_1: type_6;
@group(0) @binding(2) 
var<storage, read_write> global_2: type_12;

@compute @workgroup_size(128, 1, 1) 
fn main(@builtin(workgroup_id) param: vec3<u32>, @builtin(local_invocation_id) param_1: vec3<u32>) {
    var local: array<u32, 8>;
    var phi_221_: u32;
    var phi_224_: u32;
    var phi_222_: u32;
    var phi_225_: u32;
    var phi_232_: u32;
    var phi_229_: u32;
    var phi_226_: u32;
    var local_1: u32;
    var local_2: u32;

    let _e17 = global.member_4;
    let _e21 = bitcast<u32>(param[0u]);
    let _e24 = global_1.member.member_6;
    let _e26 = global.member_5;
    phi_221_ = bitcast<u32>(param_1[0u]);
    loop {
        let _e34 = phi_221_;
        if (_e34 < 256u) {
            let _e38 = min(max(((min(_e24, _e26) + 4095u) / 4096u), 1u), ((_e21 + 1u) * 32u));
            phi_224_ = 0u;
            phi_222_ = (_e21 * 32u);
            loop {
                let _e41 = phi_224_;
                let _e43 = phi_222_;
                local_1 = _e41;
                if (_e43 < _e38) {
                    phi_225_ = 0u;
                    loop {
                        let _e46 = phi_225_;
                        if (_e46 < 8u) {
                            let _e48 = (_e43 + _e46);
                            if (_e48 < _e38) {
                                let _e54 = global_2.member[((_e48 * 256u) + _e34)];
                                phi_232_ = _e54;
                            } else {
                                phi_232_ = 0u;
                            }
                            let _e56 = phi_232_;
                            local[_e46] = _e56;
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            phi_225_ = (_e46 + bitcast<u32>(1i));
                        }
                    }
                    phi_229_ = _e41;
                    phi_226_ = 0u;
                    loop {
                        let _e61 = phi_229_;
                        let _e63 = phi_226_;
                        local_2 = _e61;
                        if (_e63 < 8u) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e66 = local[_e63];
                            phi_229_ = (_e61 + _e66);
                            phi_226_ = (_e63 + bitcast<u32>(1i));
                        }
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e82 = local_2;
                    phi_224_ = _e82;
                    phi_222_ = (_e43 + 8u);
                }
            }
            let _e77 = local_1;
            global_2.member[((((_e17 * 256u) + 784u) + (_e21 * 256u)) + _e34)] = _e77;
            continue;
        } else {
            break;
        }
        continuing {
            phi_221_ = (_e34 + 128u);
        }
    }
    return;
}
