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
    member_15: f32,
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

struct type_11 {
    member: array<u32, LENGTH_1_4>,
}

struct type_13 {
    member: array<u32, LENGTH_2_4>,
}

@group(0) @binding(7) 
var<uniform> global: type_3;
@group(0) @binding(3) 
var<storage> global_1: type_6;
@group(0) @binding(1) 
var<storage> global_2: type_11;
@group(0) @binding(2) 
var<storage, read_write> global_3: type_13;

@compute @workgroup_size(8, 1, 1) 
fn main(@builtin(workgroup_id) param: vec3<u32>, @builtin(local_invocation_id) param_1: vec3<u32>) {
    var phi_503_: u32;
    var phi_504_: u32;
    var phi_505_: u32;
    var phi_508_: u32;
    var phi_506_: u32;
    var local: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e21 = global.member_4;
            let _e27 = (((_e21 * 256u) + 784u) + (((_e21 + 63u) / 64u) * 256u));
            let _e29 = bitcast<u32>(param_1[0u]);
            let _e31 = bitcast<u32>(param[0u]);
            let _e34 = global_1.member.member_6;
            let _e36 = global.member_5;
            let _e37 = min(_e34, _e36);
            if (_e31 >= max(((_e37 + 4095u) / 4096u), 1u)) {
                break;
            }
            phi_503_ = 0u;
            loop {
                let _e43 = phi_503_;
                if (_e43 < 256u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    global_3.member[(((_e27 + (_e31 * 2304u)) + (_e43 * 8u)) + _e29)] = 0u;
                    phi_503_ = (_e43 + bitcast<u32>(1i));
                }
            }
            let _e56 = ((_e31 * 4096u) + (_e29 * 512u));
            phi_504_ = _e56;
            loop {
                let _e58 = phi_504_;
                if (_e58 < min(_e37, (_e56 + 512u))) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e64 = global_2.member[_e58];
                    let _e74 = global_3.member[(((_e27 + (_e31 * 2304u)) + ((_e64 >> bitcast<u32>(24u)) * 8u)) + _e29)];
                    global_3.member[(((_e27 + (_e31 * 2304u)) + ((_e64 >> bitcast<u32>(24u)) * 8u)) + _e29)] = (_e74 + 1u);
                    phi_504_ = (_e58 + bitcast<u32>(1i));
                }
            }
            storageBarrier();
            workgroupBarrier();
            phi_505_ = _e29;
            loop {
                let _e81 = phi_505_;
                if (_e81 < 256u) {
                    phi_508_ = 0u;
                    phi_506_ = 0u;
                    loop {
                        let _e84 = phi_508_;
                        let _e86 = phi_506_;
                        local = _e84;
                        if (_e86 < min(8u, (_e37 | 8u))) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e95 = global_3.member[(((_e27 + (_e31 * 2304u)) + (_e81 * 8u)) + _e86)];
                            phi_508_ = (_e84 + _e95);
                            phi_506_ = (_e86 + bitcast<u32>(1i));
                        }
                    }
                    let _e104 = local;
                    global_3.member[((_e31 * 256u) + _e81)] = _e104;
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_505_ = (_e81 + 8u);
                }
            }
            break;
        }
    }
    return;
}
