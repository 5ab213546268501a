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
var<workgroup> global_3: array<u32, 1024>;
@group(0) @binding(2) 
var<storage, read_write> global_4: type_14;

@compute @workgroup_size(8, 1, 1) 
fn main(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>) {
    var phi_480_: u32;
    var phi_481_: u32;
    var phi_482_: u32;
    var phi_485_: u32;
    var phi_483_: u32;
    var local: u32;
    var local_1: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e22 = bitcast<u32>(param[0u]);
            let _e24 = bitcast<u32>(param_1[0u]);
            let _e27 = global_1.member.member_6;
            let _e29 = global.member_5;
            let _e30 = min(_e27, _e29);
            if (_e24 >= max(((_e30 + 4095u) / 4096u), 1u)) {
                break;
            }
            phi_480_ = 0u;
            loop {
                let _e36 = phi_480_;
                if (_e36 < 128u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    global_3[((_e36 * 8u) + _e22)] = 0u;
                    phi_480_ = (_e36 + bitcast<u32>(1i));
                }
            }
            let _e45 = ((_e24 * 4096u) + (_e22 * 512u));
            phi_481_ = _e45;
            loop {
                let _e47 = phi_481_;
                if (_e47 < min(_e30, (_e45 + 512u))) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e53 = global_2.member[_e47];
                    let _e55 = (_e53 >> bitcast<u32>(24u));
                    let _e65 = global_3[(((_e55 >> bitcast<u32>(1u)) * 8u) + _e22)];
                    global_3[(((_e55 >> bitcast<u32>(1u)) * 8u) + _e22)] = (_e65 + (1u << bitcast<u32>((16u * (_e55 & 1u)))));
                    phi_481_ = (_e47 + bitcast<u32>(1i));
                }
            }
            workgroupBarrier();
            phi_482_ = _e22;
            loop {
                let _e70 = phi_482_;
                if (_e70 < 128u) {
                    phi_485_ = 0u;
                    phi_483_ = 0u;
                    loop {
                        let _e73 = phi_485_;
                        let _e75 = phi_483_;
                        local = _e73;
                        local_1 = _e73;
                        if (_e75 < 8u) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e80 = global_3[((_e70 * 8u) + _e75)];
                            phi_485_ = (_e73 + _e80);
                            phi_483_ = (_e75 + bitcast<u32>(1i));
                        }
                    }
                    let _e86 = ((_e24 * 256u) + (2u * _e70));
                    let _e88 = local;
                    global_4.member[_e86] = (_e88 & 65535u);
                    let _e94 = local_1;
                    global_4.member[(_e86 + 1u)] = (_e94 >> bitcast<u32>(16u));
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_482_ = (_e70 + 8u);
                }
            }
            break;
        }
    }
    return;
}
