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

struct type_12 {
    member: array<u32>,
}

struct type_14 {
    member: array<u32, LENGTH_2_4>,
}

@group(0) @binding(7) 
var<uniform> global: type_3;
@group(0) @binding(3) 
var<storage, read_write> global_1: type_7;
var<workgroup> global_2: array<u32, 256>;
var<workgroup> global_3: array<u32, 128>;
@group(0) @binding(2) 
var<storage, read_write> global_4: type_14;

@compute @workgroup_size(128, 1, 1) 
fn main(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>) {
    var phi_556_: u32;
    var phi_555_: u32;
    var phi_568_: u32;
    var phi_565_: u32;
    var phi_573_: u32;
    var phi_566_: u32;
    var local: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_560_: u32;
    var phi_557_: u32;
    var phi_558_: u32;
    var local_4: u32;
    var local_5: u32;
    var local_6: u32;
    var phi_561_: u32;
    var phi_564_: u32;
    var phi_562_: u32;
    var local_7: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e22 = global.member_4;
            let _e24 = ((_e22 * 256u) + 784u);
            let _e26 = bitcast<u32>(param[0u]);
            let _e28 = bitcast<u32>(param_1[0u]);
            let _e30 = global.member_7;
            let _e32 = global.member_5;
            let _e36 = max(((min(_e30, _e32) + 4095u) / 4096u), 1u);
            let _e38 = ((_e36 + 63u) / 64u);
            if (_e28 >= _e38) {
                break;
            }
            phi_556_ = 0u;
            phi_555_ = 0u;
            loop {
                let _e41 = phi_556_;
                let _e43 = phi_555_;
                local_3 = _e41;
                local_6 = _e41;
                if (_e43 < 2u) {
                    let _e46 = ((_e26 * 2u) + _e43);
                    phi_568_ = 0u;
                    phi_565_ = 0u;
                    loop {
                        let _e48 = phi_568_;
                        let _e50 = phi_565_;
                        local = _e48;
                        local_1 = _e48;
                        if (_e50 < _e28) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e57 = global_4.member[((_e24 + (_e50 * 256u)) + _e46)];
                            phi_568_ = (_e48 + _e57);
                            phi_565_ = (_e50 + bitcast<u32>(1i));
                        }
                    }
                    phi_573_ = 0u;
                    phi_566_ = _e28;
                    loop {
                        let _e62 = phi_573_;
                        let _e64 = phi_566_;
                        local_2 = _e62;
                        if (_e64 < _e38) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e71 = global_4.member[((_e24 + (_e64 * 256u)) + _e46)];
                            phi_573_ = (_e62 + _e71);
                            phi_566_ = (_e64 + bitcast<u32>(1i));
                        }
                    }
                    let _e76 = local;
                    global_2[_e46] = (_e76 + _e41);
                    let _e80 = local_1;
                    let _e82 = local_2;
                    local_7 = (_e41 + (_e80 + _e82));
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e152 = local_7;
                    phi_556_ = _e152;
                    phi_555_ = (_e43 + bitcast<u32>(1i));
                }
            }
            let _e89 = local_3;
            global_3[_e26] = _e89;
            workgroupBarrier();
            phi_560_ = 0u;
            phi_557_ = 0u;
            loop {
                let _e91 = phi_560_;
                let _e93 = phi_557_;
                local_4 = _e91;
                local_5 = _e91;
                if (_e93 < _e26) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e96 = global_3[_e93];
                    phi_560_ = (_e91 + _e96);
                    phi_557_ = (_e93 + bitcast<u32>(1i));
                }
            }
            phi_558_ = 0u;
            loop {
                let _e101 = phi_558_;
                if (_e101 < 2u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e106 = global_2[((_e26 * 2u) + _e101)];
                    let _e108 = local_4;
                    global_2[((_e26 * 2u) + _e101)] = (_e106 + _e108);
                    phi_558_ = (_e101 + bitcast<u32>(1i));
                }
            }
            workgroupBarrier();
            let _e113 = local_5;
            let _e115 = local_6;
            let _e116 = (_e113 + _e115);
            if ((true && (_e28 == 0u)) && (_e26 == 127u)) {
                global_1.member.member_6 = _e116;
                global_1.member.member_1 = ((_e116 + 127u) / 128u);
            }
            phi_561_ = _e26;
            loop {
                let _e128 = phi_561_;
                if (_e128 < 256u) {
                    let _e131 = global_2[_e128];
                    phi_564_ = _e131;
                    phi_562_ = (_e28 * 64u);
                    loop {
                        let _e134 = phi_564_;
                        let _e136 = phi_562_;
                        if (_e136 < min(_e36, ((_e28 + 1u) * 64u))) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e145 = global_4.member[((_e136 * 256u) + _e128)];
                            global_4.member[((_e136 * 256u) + _e128)] = _e134;
                            phi_564_ = (_e134 + _e145);
                            phi_562_ = (_e136 + bitcast<u32>(1i));
                        }
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_561_ = (_e128 + 128u);
                }
            }
            break;
        }
    }
    return;
}
