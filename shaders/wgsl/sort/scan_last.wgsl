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

struct type_11 {
    member: array<u32>,
}

struct type_13 {
    member: array<u32, LENGTH_2_4>,
}

@group(0) @binding(7) 
var<uniform> global: type_3;
@group(0) @binding(3) 
var<storage> global_1: type_6;
var<workgroup> global_2: array<u32, 256>;
var<workgroup> global_3: array<u32, 128>;
@group(0) @binding(2) 
var<storage, read_write> global_4: type_13;

@compute @workgroup_size(128, 1, 1) 
fn main(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>) {
    var phi_557_: u32;
    var phi_556_: u32;
    var phi_569_: u32;
    var phi_566_: u32;
    var phi_574_: u32;
    var phi_567_: u32;
    var local: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_561_: u32;
    var phi_558_: u32;
    var phi_559_: u32;
    var local_4: u32;
    var phi_562_: u32;
    var phi_565_: u32;
    var phi_563_: u32;
    var local_5: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e20 = global.member_4;
            let _e22 = ((_e20 * 256u) + 784u);
            let _e24 = bitcast<u32>(param[0u]);
            let _e26 = bitcast<u32>(param_1[0u]);
            let _e29 = global_1.member.member_6;
            let _e31 = global.member_5;
            let _e35 = max(((min(_e29, _e31) + 4095u) / 4096u), 1u);
            let _e37 = ((_e35 + 63u) / 64u);
            if (_e26 >= _e37) {
                break;
            }
            phi_557_ = 0u;
            phi_556_ = 0u;
            loop {
                let _e40 = phi_557_;
                let _e42 = phi_556_;
                local_3 = _e40;
                if (_e42 < 2u) {
                    let _e45 = ((_e24 * 2u) + _e42);
                    phi_569_ = 0u;
                    phi_566_ = 0u;
                    loop {
                        let _e47 = phi_569_;
                        let _e49 = phi_566_;
                        local = _e47;
                        local_1 = _e47;
                        if (_e49 < _e26) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e56 = global_4.member[((_e22 + (_e49 * 256u)) + _e45)];
                            phi_569_ = (_e47 + _e56);
                            phi_566_ = (_e49 + bitcast<u32>(1i));
                        }
                    }
                    phi_574_ = 0u;
                    phi_567_ = _e26;
                    loop {
                        let _e61 = phi_574_;
                        let _e63 = phi_567_;
                        local_2 = _e61;
                        if (_e63 < _e37) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e70 = global_4.member[((_e22 + (_e63 * 256u)) + _e45)];
                            phi_574_ = (_e61 + _e70);
                            phi_567_ = (_e63 + bitcast<u32>(1i));
                        }
                    }
                    let _e75 = local;
                    global_2[_e45] = (_e75 + _e40);
                    let _e79 = local_1;
                    let _e81 = local_2;
                    local_5 = (_e40 + (_e79 + _e81));
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e136 = local_5;
                    phi_557_ = _e136;
                    phi_556_ = (_e42 + bitcast<u32>(1i));
                }
            }
            let _e88 = local_3;
            global_3[_e24] = _e88;
            workgroupBarrier();
            phi_561_ = 0u;
            phi_558_ = 0u;
            loop {
                let _e90 = phi_561_;
                let _e92 = phi_558_;
                local_4 = _e90;
                if (_e92 < _e24) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e95 = global_3[_e92];
                    phi_561_ = (_e90 + _e95);
                    phi_558_ = (_e92 + bitcast<u32>(1i));
                }
            }
            phi_559_ = 0u;
            loop {
                let _e100 = phi_559_;
                if (_e100 < 2u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e105 = global_2[((_e24 * 2u) + _e100)];
                    let _e107 = local_4;
                    global_2[((_e24 * 2u) + _e100)] = (_e105 + _e107);
                    phi_559_ = (_e100 + bitcast<u32>(1i));
                }
            }
            workgroupBarrier();
            phi_562_ = _e24;
            loop {
                let _e112 = phi_562_;
                if (_e112 < 256u) {
                    let _e115 = global_2[_e112];
                    phi_565_ = _e115;
                    phi_563_ = (_e26 * 64u);
                    loop {
                        let _e118 = phi_565_;
                        let _e120 = phi_563_;
                        if (_e120 < min(_e35, ((_e26 + 1u) * 64u))) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e129 = global_4.member[((_e120 * 256u) + _e112)];
                            global_4.member[((_e120 * 256u) + _e112)] = _e118;
                            phi_565_ = (_e118 + _e129);
                            phi_563_ = (_e120 + bitcast<u32>(1i));
                        }
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_562_ = (_e112 + 128u);
                }
            }
            break;
        }
    }
    return;
}
