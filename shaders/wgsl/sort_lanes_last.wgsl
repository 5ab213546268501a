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

struct type_14 {
    member: array<u32, LENGTH_1_4>,
}

struct type_16 {
    member: array<u32, LENGTH_4_4>,
}

struct type_18 {
    member: array<u32, LENGTH_2_4>,
}

@group(0) @binding(7) 
var<uniform> global: type_3;
@group(0) @binding(3) 
var<storage> global_1: type_6;
@group(0) @binding(1) 
var<storage> global_2: type_14;
@group(0) @binding(4) 
var<storage, read_write> global_3: type_16;
var<workgroup> global_4: array<u32, 8>;
var<workgroup> global_5: array<u32, 256>;
@group(0) @binding(2) 
var<storage> global_6: type_18;
var<workgroup> global_7: array<u32, 1024>;

@compute @workgroup_size(8, 1, 1) 
fn main(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>) {
    var phi_1022_: u32;
    var phi_1023_: u32;
    var phi_1026_: u32;
    var phi_1025_: u32;
    var phi_1040_: u32;
    var phi_1037_: u32;
    var phi_1043_: u32;
    var phi_1038_: u32;
    var local: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_1030_: u32;
    var phi_1027_: u32;
    var phi_1028_: u32;
    var local_4: u32;
    var phi_1024_: u32;
    var phi_1031_: u32;
    var phi_1036_: u32;
    var phi_1034_: u32;
    var phi_1032_: u32;
    var local_5: u32;
    var local_6: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e26 = bitcast<u32>(param[0u]);
            let _e28 = bitcast<u32>(param_1[0u]);
            let _e31 = global_1.member.member_6;
            let _e33 = global.member_5;
            let _e34 = min(_e31, _e33);
            let _e37 = max(((_e34 + 4095u) / 4096u), 1u);
            if (_e28 >= _e37) {
                break;
            }
            phi_1022_ = 0u;
            loop {
                let _e40 = phi_1022_;
                if (_e40 < 128u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    global_7[((_e40 * 8u) + _e26)] = 0u;
                    phi_1022_ = (_e40 + bitcast<u32>(1i));
                }
            }
            let _e49 = ((_e28 * 4096u) + (_e26 * 512u));
            phi_1023_ = _e49;
            loop {
                let _e51 = phi_1023_;
                let _e53 = min(_e34, (_e49 + 512u));
                local_5 = _e53;
                if (_e51 < _e53) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e57 = global_2.member[_e51];
                    let _e59 = (_e57 >> bitcast<u32>(24u));
                    let _e69 = global_7[(((_e59 >> bitcast<u32>(1u)) * 8u) + _e26)];
                    global_7[(((_e59 >> bitcast<u32>(1u)) * 8u) + _e26)] = (_e69 + (1u << bitcast<u32>((16u * (_e59 & 1u)))));
                    phi_1023_ = (_e51 + bitcast<u32>(1i));
                }
            }
            switch bitcast<i32>(0u) {
                default: {
                    let _e75 = global.member_6;
                    if !((_e75 != 0u)) {
                        phi_1026_ = 0u;
                        phi_1025_ = 0u;
                        loop {
                            let _e79 = phi_1026_;
                            let _e81 = phi_1025_;
                            local_3 = _e79;
                            if (_e81 < 32u) {
                                let _e84 = ((_e26 * 32u) + _e81);
                                phi_1040_ = 0u;
                                phi_1037_ = 0u;
                                loop {
                                    let _e86 = phi_1040_;
                                    let _e88 = phi_1037_;
                                    local = _e86;
                                    local_1 = _e86;
                                    if (_e88 < _e28) {
                                        continue;
                                    } else {
                                        break;
                                    }
                                    continuing {
                                        let _e94 = global_6.member[((_e88 * 256u) + _e84)];
                                        phi_1040_ = (_e86 + _e94);
                                        phi_1037_ = (_e88 + bitcast<u32>(1i));
                                    }
                                }
                                phi_1043_ = 0u;
                                phi_1038_ = _e28;
                                loop {
                                    let _e99 = phi_1043_;
                                    let _e101 = phi_1038_;
                                    local_2 = _e99;
                                    if (_e101 < _e37) {
                                        continue;
                                    } else {
                                        break;
                                    }
                                    continuing {
                                        let _e107 = global_6.member[((_e101 * 256u) + _e84)];
                                        phi_1043_ = (_e99 + _e107);
                                        phi_1038_ = (_e101 + bitcast<u32>(1i));
                                    }
                                }
                                let _e112 = local;
                                global_5[_e84] = (_e112 + _e79);
                                let _e116 = local_1;
                                let _e118 = local_2;
                                local_6 = (_e79 + (_e116 + _e118));
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e210 = local_6;
                                phi_1026_ = _e210;
                                phi_1025_ = (_e81 + bitcast<u32>(1i));
                            }
                        }
                        let _e125 = local_3;
                        global_4[_e26] = _e125;
                        workgroupBarrier();
                        phi_1030_ = 0u;
                        phi_1027_ = 0u;
                        loop {
                            let _e127 = phi_1030_;
                            let _e129 = phi_1027_;
                            local_4 = _e127;
                            if (_e129 < _e26) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e132 = global_4[_e129];
                                phi_1030_ = (_e127 + _e132);
                                phi_1027_ = (_e129 + bitcast<u32>(1i));
                            }
                        }
                        phi_1028_ = 0u;
                        loop {
                            let _e137 = phi_1028_;
                            if (_e137 < 32u) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e142 = global_5[((_e26 * 32u) + _e137)];
                                let _e144 = local_4;
                                global_5[((_e26 * 32u) + _e137)] = (_e142 + _e144);
                                phi_1028_ = (_e137 + bitcast<u32>(1i));
                            }
                        }
                        workgroupBarrier();
                        break;
                    }
                    phi_1024_ = _e26;
                    loop {
                        let _e149 = phi_1024_;
                        if (_e149 < 256u) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e155 = global_6.member[((_e28 * 256u) + _e149)];
                            global_5[_e149] = _e155;
                            phi_1024_ = (_e149 + 8u);
                        }
                    }
                    workgroupBarrier();
                    break;
                }
            }
            phi_1031_ = _e26;
            loop {
                let _e159 = phi_1031_;
                if (_e159 < 128u) {
                    phi_1036_ = 0u;
                    phi_1034_ = 0u;
                    loop {
                        let _e162 = phi_1036_;
                        let _e164 = phi_1034_;
                        if (_e164 < 8u) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e169 = global_7[((_e159 * 8u) + _e164)];
                            global_7[((_e159 * 8u) + _e164)] = _e162;
                            phi_1036_ = (_e162 + _e169);
                            phi_1034_ = (_e164 + bitcast<u32>(1i));
                        }
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_1031_ = (_e159 + 8u);
                }
            }
            workgroupBarrier();
            phi_1032_ = _e49;
            loop {
                let _e175 = phi_1032_;
                let _e177 = local_5;
                if (_e175 < _e177) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e181 = global_2.member[_e175];
                    let _e183 = (_e181 >> bitcast<u32>(24u));
                    let _e189 = global_7[(((_e183 >> bitcast<u32>(1u)) * 8u) + _e26)];
                    let _e191 = (16u * (_e183 & 1u));
                    global_7[(((_e183 >> bitcast<u32>(1u)) * 8u) + _e26)] = (_e189 + (1u << bitcast<u32>(_e191)));
                    let _e196 = global_5[_e183];
                    global_3.member[(_e196 + ((_e189 >> bitcast<u32>(_e191)) & 65535u))] = (_e181 & 16777215u);
                    phi_1032_ = (_e175 + bitcast<u32>(1i));
                }
            }
            break;
        }
    }
    return;
}
