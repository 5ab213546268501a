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
var<workgroup> global_2: array<u32, 128>;
var<workgroup> global_3: array<u32, 256>;
@group(0) @binding(2) 
var<storage, read_write> global_4: type_13;

@compute @workgroup_size(128, 1, 1) 
fn main(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>) {
    var phi_513_: u32;
    var phi_512_: u32;
    var phi_527_: u32;
    var phi_522_: u32;
    var phi_530_: u32;
    var phi_523_: u32;
    var local: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_517_: u32;
    var phi_514_: u32;
    var phi_515_: u32;
    var local_4: u32;
    var phi_518_: u32;
    var phi_521_: u32;
    var phi_519_: u32;
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
            phi_513_ = 0u;
            phi_512_ = 0u;
            loop {
                let _e40 = phi_513_;
                let _e42 = phi_512_;
                local_3 = _e40;
                if (_e42 < 2u) {
                    let _e45 = ((_e24 * 2u) + _e42);
                    phi_527_ = 0u;
                    phi_522_ = 0u;
                    loop {
                        let _e47 = phi_527_;
                        let _e49 = phi_522_;
                        local = _e47;
                        local_1 = _e47;
                        if (_e49 < _e26) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e56 = global_4.member[((_e22 + (_e49 * 256u)) + _e45)];
                            phi_527_ = (_e47 + _e56);
                            phi_522_ = (_e49 + bitcast<u32>(1i));
                        }
                    }
                    phi_530_ = 0u;
                    phi_523_ = _e26;
                    loop {
                        let _e61 = phi_530_;
                        let _e63 = phi_523_;
                        local_2 = _e61;
                        if (_e63 < _e37) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e70 = global_4.member[((_e22 + (_e63 * 256u)) + _e45)];
                            phi_530_ = (_e61 + _e70);
                            phi_523_ = (_e63 + bitcast<u32>(1i));
                        }
                    }
                    let _e75 = local;
                    global_3[_e45] = (_e75 + _e40);
                    let _e79 = local_1;
                    let _e81 = local_2;
                    local_5 = (_e40 + (_e79 + _e81));
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e136 = local_5;
                    phi_513_ = _e136;
                    phi_512_ = (_e42 + bitcast<u32>(1i));
                }
            }
            let _e88 = local_3;
            global_2[_e24] = _e88;
            workgroupBarrier();
            phi_517_ = 0u;
            phi_514_ = 0u;
            loop {
                let _e90 = phi_517_;
                let _e92 = phi_514_;
                local_4 = _e90;
                if (_e92 < _e24) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e95 = global_2[_e92];
                    phi_517_ = (_e90 + _e95);
                    phi_514_ = (_e92 + bitcast<u32>(1i));
                }
            }
            phi_515_ = 0u;
            loop {
                let _e100 = phi_515_;
                if (_e100 < 2u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e105 = global_3[((_e24 * 2u) + _e100)];
                    let _e107 = local_4;
                    global_3[((_e24 * 2u) + _e100)] = (_e105 + _e107);
                    phi_515_ = (_e100 + bitcast<u32>(1i));
                }
            }
            workgroupBarrier();
            phi_518_ = _e24;
            loop {
                let _e112 = phi_518_;
                if (_e112 < 256u) {
                    let _e115 = global_3[_e112];
                    phi_521_ = _e115;
                    phi_519_ = (_e26 * 64u);
                    loop {
                        let _e118 = phi_521_;
                        let _e120 = phi_519_;
                        if (_e120 < min(_e35, ((_e26 + 1u) * 64u))) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e129 = global_4.member[((_e120 * 256u) + _e112)];
                            global_4.member[((_e120 * 256u) + _e112)] = _e118;
                            phi_521_ = (_e118 + _e129);
                            phi_519_ = (_e120 + bitcast<u32>(1i));
                        }
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_518_ = (_e112 + 128u);
                }
            }
            break;
        }
    }
    return;
}
