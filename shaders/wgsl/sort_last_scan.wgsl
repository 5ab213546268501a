struct type_2 {
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
}

struct type_7 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: i32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
}

struct type_8 {
    member: type_7,
}

struct type_17 {
    member: array<u32>,
}

@group(0) @binding(7) 
var<uniform> global: type_2;
@group(0) @binding(3) 
var<storage> global_1: type_8;
var<workgroup> global_2: array<u32, 128>;
var<workgroup> global_3: array<u32, 256>;
@group(0) @binding(2) 
var<storage, read_write> global_4: type_17;
var<private> global_5: vec3<u32>;
var<private> global_6: vec3<u32>;

fn function_() {
    var phi_499_: u32;
    var phi_498_: u32;
    var phi_511_: u32;
    var phi_508_: u32;
    var phi_514_: u32;
    var phi_509_: u32;
    var local: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_503_: u32;
    var phi_500_: u32;
    var phi_501_: u32;
    var local_4: u32;
    var phi_504_: u32;
    var phi_507_: u32;
    var phi_505_: u32;
    var local_5: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e26 = global.member_4;
            let _e28 = ((_e26 * 256u) + 784u);
            let _e30 = global_5[0u];
            let _e32 = global_6[0u];
            let _e35 = global_1.member.member_6;
            let _e37 = global.member_5;
            let _e41 = max(((min(_e35, _e37) + 4095u) / 4096u), 1u);
            let _e43 = ((_e41 + 63u) / 64u);
            if (_e32 >= _e43) {
                break;
            }
            phi_499_ = 0u;
            phi_498_ = 0u;
            loop {
                let _e46 = phi_499_;
                let _e48 = phi_498_;
                local_3 = _e46;
                if (_e48 < 2u) {
                    let _e51 = ((_e30 * 2u) + _e48);
                    phi_511_ = 0u;
                    phi_508_ = 0u;
                    loop {
                        let _e53 = phi_511_;
                        let _e55 = phi_508_;
                        local = _e53;
                        local_1 = _e53;
                        if (_e55 < _e32) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e62 = global_4.member[((_e28 + (_e55 * 256u)) + _e51)];
                            phi_511_ = (_e53 + _e62);
                            phi_508_ = (_e55 + bitcast<u32>(1i));
                        }
                    }
                    phi_514_ = 0u;
                    phi_509_ = _e32;
                    loop {
                        let _e67 = phi_514_;
                        let _e69 = phi_509_;
                        local_2 = _e67;
                        if (_e69 < _e43) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e76 = global_4.member[((_e28 + (_e69 * 256u)) + _e51)];
                            phi_514_ = (_e67 + _e76);
                            phi_509_ = (_e69 + bitcast<u32>(1i));
                        }
                    }
                    let _e81 = local;
                    global_3[_e51] = (_e81 + _e46);
                    let _e85 = local_1;
                    let _e87 = local_2;
                    local_5 = (_e46 + (_e85 + _e87));
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e142 = local_5;
                    phi_499_ = _e142;
                    phi_498_ = (_e48 + bitcast<u32>(1i));
                }
            }
            let _e94 = local_3;
            global_2[_e30] = _e94;
            workgroupBarrier();
            phi_503_ = 0u;
            phi_500_ = 0u;
            loop {
                let _e96 = phi_503_;
                let _e98 = phi_500_;
                local_4 = _e96;
                if (_e98 < _e30) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e101 = global_2[_e98];
                    phi_503_ = (_e96 + _e101);
                    phi_500_ = (_e98 + bitcast<u32>(1i));
                }
            }
            phi_501_ = 0u;
            loop {
                let _e106 = phi_501_;
                if (_e106 < 2u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e111 = global_3[((_e30 * 2u) + _e106)];
                    let _e113 = local_4;
                    global_3[((_e30 * 2u) + _e106)] = (_e111 + _e113);
                    phi_501_ = (_e106 + bitcast<u32>(1i));
                }
            }
            workgroupBarrier();
            phi_504_ = _e30;
            loop {
                let _e118 = phi_504_;
                if (_e118 < 256u) {
                    let _e121 = global_3[_e118];
                    phi_507_ = _e121;
                    phi_505_ = (_e32 * 64u);
                    loop {
                        let _e124 = phi_507_;
                        let _e126 = phi_505_;
                        if (_e126 < min(_e41, ((_e32 + 1u) * 64u))) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e135 = global_4.member[((_e126 * 256u) + _e118)];
                            global_4.member[((_e126 * 256u) + _e118)] = _e124;
                            phi_507_ = (_e124 + _e135);
                            phi_505_ = (_e126 + bitcast<u32>(1i));
                        }
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_504_ = (_e118 + 128u);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn main(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>) {
    global_5 = param;
    global_6 = param_1;
    function_();
}
