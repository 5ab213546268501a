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

struct type_8 {
    member: array<u32>,
}

struct type_10 {
    member: array<u32, LENGTH_2_4>,
}

@group(0) @binding(7) 
var<uniform> global: type_3;
@group(0) @binding(2) 
var<storage, read_write> global_1: type_10;

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

    let _e16 = global.member_4;
    let _e20 = bitcast<u32>(param[0u]);
    let _e22 = global.member_7;
    let _e24 = global.member_5;
    phi_221_ = bitcast<u32>(param_1[0u]);
    loop {
        let _e32 = phi_221_;
        if (_e32 < 256u) {
            let _e36 = min(max(((min(_e22, _e24) + 4095u) / 4096u), 1u), ((_e20 + 1u) * 32u));
            phi_224_ = 0u;
            phi_222_ = (_e20 * 32u);
            loop {
                let _e39 = phi_224_;
                let _e41 = phi_222_;
                local_1 = _e39;
                if (_e41 < _e36) {
                    phi_225_ = 0u;
                    loop {
                        let _e44 = phi_225_;
                        if (_e44 < 8u) {
                            let _e46 = (_e41 + _e44);
                            if (_e46 < _e36) {
                                let _e52 = global_1.member[((_e46 * 256u) + _e32)];
                                phi_232_ = _e52;
                            } else {
                                phi_232_ = 0u;
                            }
                            let _e54 = phi_232_;
                            local[_e44] = _e54;
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            phi_225_ = (_e44 + bitcast<u32>(1i));
                        }
                    }
                    phi_229_ = _e39;
                    phi_226_ = 0u;
                    loop {
                        let _e59 = phi_229_;
                        let _e61 = phi_226_;
                        local_2 = _e59;
                        if (_e61 < 8u) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e64 = local[_e61];
                            phi_229_ = (_e59 + _e64);
                            phi_226_ = (_e61 + bitcast<u32>(1i));
                        }
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e80 = local_2;
                    phi_224_ = _e80;
                    phi_222_ = (_e41 + 8u);
                }
            }
            let _e75 = local_1;
            global_1.member[((((_e16 * 256u) + 784u) + (_e20 * 256u)) + _e32)] = _e75;
            continue;
        } else {
            break;
        }
        continuing {
            phi_221_ = (_e32 + 128u);
        }
    }
    return;
}
