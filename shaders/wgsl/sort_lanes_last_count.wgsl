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

struct type_12 {
    member: array<u32, LENGTH_1_4>,
}

struct type_14 {
    member: array<u32, LENGTH_2_4>,
}

@group(0) @binding(7) 
var<uniform> global: type_3;
@group(0) @binding(3) 
var<storage> global_1: type_6;
@group(0) @binding(1) 
var<storage> global_2: type_12;
var<workgroup> global_3: array<u32, 2048>;
@group(0) @binding(2) 
var<storage, read_write> global_4: type_14;

@compute @workgroup_size(8, 1, 1) 
fn main(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>) {
    var phi_422_: u32;
    var phi_423_: u32;
    var phi_424_: u32;
    var phi_427_: u32;
    var phi_425_: u32;
    var local: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e18 = bitcast<u32>(param[0u]);
            let _e20 = bitcast<u32>(param_1[0u]);
            let _e23 = global_1.member.member_6;
            let _e25 = global.member_5;
            let _e26 = min(_e23, _e25);
            if (_e20 >= max(((_e26 + 4095u) / 4096u), 1u)) {
                break;
            }
            phi_422_ = 0u;
            loop {
                let _e32 = phi_422_;
                if (_e32 < 256u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    global_3[((_e32 * 8u) + _e18)] = 0u;
                    phi_422_ = (_e32 + bitcast<u32>(1i));
                }
            }
            let _e41 = ((_e20 * 4096u) + (_e18 * 512u));
            phi_423_ = _e41;
            loop {
                let _e43 = phi_423_;
                if (_e43 < min(_e26, (_e41 + 512u))) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e49 = global_2.member[_e43];
                    let _e55 = global_3[(((_e49 >> bitcast<u32>(24u)) * 8u) + _e18)];
                    global_3[(((_e49 >> bitcast<u32>(24u)) * 8u) + _e18)] = (_e55 + 1u);
                    phi_423_ = (_e43 + bitcast<u32>(1i));
                }
            }
            workgroupBarrier();
            phi_424_ = _e18;
            loop {
                let _e60 = phi_424_;
                if (_e60 < 256u) {
                    phi_427_ = 0u;
                    phi_425_ = 0u;
                    loop {
                        let _e63 = phi_427_;
                        let _e65 = phi_425_;
                        local = _e63;
                        if (_e65 < 8u) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e70 = global_3[((_e60 * 8u) + _e65)];
                            phi_427_ = (_e63 + _e70);
                            phi_425_ = (_e65 + bitcast<u32>(1i));
                        }
                    }
                    let _e79 = local;
                    global_4.member[((_e20 * 256u) + _e60)] = _e79;
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_424_ = (_e60 + 8u);
                }
            }
            break;
        }
    }
    return;
}
