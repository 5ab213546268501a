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
    var phi_518_: u32;
    var phi_519_: u32;
    var phi_520_: u32;
    var phi_523_: u32;
    var phi_521_: u32;
    var local: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e22 = global.member_4;
            let _e28 = (((_e22 * 256u) + 784u) + (((_e22 + 31u) / 32u) * 256u));
            let _e30 = bitcast<u32>(param_1[0u]);
            let _e32 = bitcast<u32>(param[0u]);
            let _e35 = global_1.member.member_6;
            let _e37 = global.member_5;
            let _e38 = min(_e35, _e37);
            if (_e32 >= max(((_e38 + 4095u) / 4096u), 1u)) {
                break;
            }
            phi_518_ = 0u;
            loop {
                let _e44 = phi_518_;
                if (_e44 < 256u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    global_3.member[(((_e28 + (_e32 * 2304u)) + (_e44 * 8u)) + _e30)] = 0u;
                    phi_518_ = (_e44 + bitcast<u32>(1i));
                }
            }
            let _e57 = ((_e32 * 4096u) + (_e30 * 512u));
            phi_519_ = _e57;
            loop {
                let _e59 = phi_519_;
                if (_e59 < min(_e38, (_e57 + 512u))) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e65 = global_2.member[_e59];
                    let _e76 = global_3.member[(((_e28 + (_e32 * 2304u)) + (((_e65 >> bitcast<u32>(24u)) & 255u) * 8u)) + _e30)];
                    global_3.member[(((_e28 + (_e32 * 2304u)) + (((_e65 >> bitcast<u32>(24u)) & 255u) * 8u)) + _e30)] = (_e76 + 1u);
                    phi_519_ = (_e59 + bitcast<u32>(1i));
                }
            }
            storageBarrier();
            workgroupBarrier();
            phi_520_ = _e30;
            loop {
                let _e83 = phi_520_;
                if (_e83 < 256u) {
                    phi_523_ = 0u;
                    phi_521_ = 0u;
                    loop {
                        let _e86 = phi_523_;
                        let _e88 = phi_521_;
                        local = _e86;
                        if (_e88 < min(8u, (_e38 | 8u))) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e97 = global_3.member[(((_e28 + (_e32 * 2304u)) + (_e83 * 8u)) + _e88)];
                            phi_523_ = (_e86 + _e97);
                            phi_521_ = (_e88 + bitcast<u32>(1i));
                        }
                    }
                    let _e106 = local;
                    global_3.member[((_e32 * 256u) + _e83)] = _e106;
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_520_ = (_e83 + 8u);
                }
            }
            break;
        }
    }
    return;
}
