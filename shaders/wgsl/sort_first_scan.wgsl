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
var<storage, read_write> global_1: type_8;
var<workgroup> global_2: array<u32, 128>;
var<workgroup> global_3: array<u32, 256>;
@group(0) @binding(2) 
var<storage, read_write> global_4: type_17;
var<private> global_5: vec3<u32>;
var<private> global_6: vec3<u32>;

fn function_() {
    var phi_498_: u32;
    var phi_497_: u32;
    var phi_510_: u32;
    var phi_507_: u32;
    var phi_513_: u32;
    var phi_508_: u32;
    var local: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_502_: u32;
    var phi_499_: u32;
    var phi_500_: u32;
    var local_4: u32;
    var local_5: u32;
    var local_6: u32;
    var phi_503_: u32;
    var phi_506_: u32;
    var phi_504_: u32;
    var local_7: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e29 = global.member_4;
            let _e31 = ((_e29 * 256u) + 784u);
            let _e33 = global_5[0u];
            let _e35 = global_6[0u];
            let _e37 = global.member_7;
            let _e39 = global.member_5;
            let _e43 = max(((min(_e37, _e39) + 4095u) / 4096u), 1u);
            let _e45 = ((_e43 + 63u) / 64u);
            if (_e35 >= _e45) {
                break;
            }
            phi_498_ = 0u;
            phi_497_ = 0u;
            loop {
                let _e48 = phi_498_;
                let _e50 = phi_497_;
                local_3 = _e48;
                local_6 = _e48;
                if (_e50 < 2u) {
                    let _e53 = ((_e33 * 2u) + _e50);
                    phi_510_ = 0u;
                    phi_507_ = 0u;
                    loop {
                        let _e55 = phi_510_;
                        let _e57 = phi_507_;
                        local = _e55;
                        local_1 = _e55;
                        if (_e57 < _e35) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e64 = global_4.member[((_e31 + (_e57 * 256u)) + _e53)];
                            phi_510_ = (_e55 + _e64);
                            phi_507_ = (_e57 + bitcast<u32>(1i));
                        }
                    }
                    phi_513_ = 0u;
                    phi_508_ = _e35;
                    loop {
                        let _e69 = phi_513_;
                        let _e71 = phi_508_;
                        local_2 = _e69;
                        if (_e71 < _e45) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e78 = global_4.member[((_e31 + (_e71 * 256u)) + _e53)];
                            phi_513_ = (_e69 + _e78);
                            phi_508_ = (_e71 + bitcast<u32>(1i));
                        }
                    }
                    let _e83 = local;
                    global_3[_e53] = (_e83 + _e48);
                    let _e87 = local_1;
                    let _e89 = local_2;
                    local_7 = (_e48 + (_e87 + _e89));
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e159 = local_7;
                    phi_498_ = _e159;
                    phi_497_ = (_e50 + bitcast<u32>(1i));
                }
            }
            let _e96 = local_3;
            global_2[_e33] = _e96;
            workgroupBarrier();
            phi_502_ = 0u;
            phi_499_ = 0u;
            loop {
                let _e98 = phi_502_;
                let _e100 = phi_499_;
                local_4 = _e98;
                local_5 = _e98;
                if (_e100 < _e33) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e103 = global_2[_e100];
                    phi_502_ = (_e98 + _e103);
                    phi_499_ = (_e100 + bitcast<u32>(1i));
                }
            }
            phi_500_ = 0u;
            loop {
                let _e108 = phi_500_;
                if (_e108 < 2u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e113 = global_3[((_e33 * 2u) + _e108)];
                    let _e115 = local_4;
                    global_3[((_e33 * 2u) + _e108)] = (_e113 + _e115);
                    phi_500_ = (_e108 + bitcast<u32>(1i));
                }
            }
            workgroupBarrier();
            let _e120 = local_5;
            let _e122 = local_6;
            let _e123 = (_e120 + _e122);
            if ((true && (_e35 == 0u)) && (_e33 == 127u)) {
                global_1.member.member_6 = _e123;
                global_1.member.member_1 = ((_e123 + 127u) / 128u);
            }
            phi_503_ = _e33;
            loop {
                let _e135 = phi_503_;
                if (_e135 < 256u) {
                    let _e138 = global_3[_e135];
                    phi_506_ = _e138;
                    phi_504_ = (_e35 * 64u);
                    loop {
                        let _e141 = phi_506_;
                        let _e143 = phi_504_;
                        if (_e143 < min(_e43, ((_e35 + 1u) * 64u))) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e152 = global_4.member[((_e143 * 256u) + _e135)];
                            global_4.member[((_e143 * 256u) + _e135)] = _e141;
                            phi_506_ = (_e141 + _e152);
                            phi_504_ = (_e143 + bitcast<u32>(1i));
                        }
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_503_ = (_e135 + 128u);
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
