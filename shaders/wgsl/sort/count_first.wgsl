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
    member: array<u32>,
}

struct type_11 {
    member: array<u32, LENGTH_1_4>,
}

struct type_13 {
    member: array<u32, LENGTH_2_4>,
}

@group(0) @binding(7) 
var<uniform> global: type_4;
@group(0) @binding(1) 
var<storage> global_1: type_11;
var<workgroup> global_2: array<atomic<u32>, 256>;
@group(0) @binding(2) 
var<storage, read_write> global_3: type_13;

@compute @workgroup_size(128, 1, 1) 
fn main(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>) {
    var phi_341_: u32;
    var phi_342_: u32;
    var phi_343_: u32;
    var phi_344_: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e21 = global.member_4;
            let _e24 = bitcast<u32>(param[0u]);
            let _e26 = bitcast<u32>(param_1[0u]);
            let _e28 = global.member_7;
            let _e30 = global.member_5;
            let _e31 = min(_e28, _e30);
            if (_e26 >= max(((_e31 + 4095u) / 4096u), 1u)) {
                break;
            }
            phi_341_ = _e24;
            loop {
                let _e37 = phi_341_;
                if (_e37 < 256u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    atomicStore((&global_2[_e37]), 0u);
                    phi_341_ = (_e37 + 128u);
                }
            }
            if (true && (_e26 == 0u)) {
                phi_342_ = _e24;
                loop {
                    let _e44 = phi_342_;
                    if (_e44 < 784u) {
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        global_3.member[((_e21 * 256u) + _e44)] = 0u;
                        phi_342_ = (_e44 + 128u);
                    }
                }
            }
            workgroupBarrier();
            phi_343_ = ((_e26 * 4096u) + _e24);
            loop {
                let _e53 = phi_343_;
                if (_e53 < min(_e31, ((_e26 + 1u) * 4096u))) {
                    let _e62 = global_1.member[(_e53 >> bitcast<u32>(1u))];
                    let _e67 = ((_e62 >> bitcast<u32>((16u * (_e53 & 1u)))) & 65535u);
                    let _e69 = select(_e67, 4294967295u, (_e67 == 65535u));
                    if (false || (_e69 != 4294967295u)) {
                        let _e74 = atomicAdd((&global_2[(_e69 & 255u)]), 1u);
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_343_ = (_e53 + 128u);
                }
            }
            workgroupBarrier();
            phi_344_ = _e24;
            loop {
                let _e77 = phi_344_;
                if (_e77 < 256u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e82 = atomicLoad((&global_2[_e77]));
                    global_3.member[((_e26 * 256u) + _e77)] = _e82;
                    phi_344_ = (_e77 + 128u);
                }
            }
            break;
        }
    }
    return;
}
