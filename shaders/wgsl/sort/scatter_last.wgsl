struct type_4 {
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

struct type_9 {
    member: array<u32>,
}

struct type_16 {
    member: array<u32, LENGTH_1_4>,
}

struct type_18 {
    member: array<u32, LENGTH_4_4>,
}

struct type_20 {
    member: array<u32, LENGTH_2_4>,
}

@group(0) @binding(7) 
var<uniform> global: type_4;
@group(0) @binding(3) 
var<storage> global_1: type_7;
@group(0) @binding(1) 
var<storage> global_2: type_16;
@group(0) @binding(4) 
var<storage, read_write> global_3: type_18;
var<workgroup> global_4: array<u32, 256>;
var<workgroup> global_5: array<u32, 128>;
@group(0) @binding(2) 
var<storage> global_6: type_20;
var<workgroup> global_7: array<atomic<u32>, 2048>;

@compute @workgroup_size(128, 1, 1) 
fn main(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>) {
    var phi_985_: u32;
    var phi_988_: u32;
    var phi_987_: u32;
    var phi_1038_: u32;
    var phi_1035_: u32;
    var phi_1043_: u32;
    var phi_1036_: u32;
    var local: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_992_: u32;
    var phi_989_: u32;
    var phi_990_: u32;
    var local_4: u32;
    var phi_986_: u32;
    var phi_994_: u32;
    var phi_993_: u32;
    var phi_1006_: u32;
    var phi_996_: u32;
    var phi_1014_: u32;
    var phi_1001_: u32;
    var phi_998_: u32;
    var phi_1029_: u32;
    var phi_1030_: u32;
    var local_5: u32;
    var phi_1011_: u32;
    var phi_1009_: u32;
    var phi_1015_: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var local_9: u32;
    var local_10: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e29 = bitcast<u32>(param[0u]);
            let _e31 = bitcast<u32>(param_1[0u]);
            let _e34 = global_1.member.member_6;
            let _e36 = global.member_5;
            let _e37 = min(_e34, _e36);
            let _e40 = max(((_e37 + 4095u) / 4096u), 1u);
            if (_e31 >= _e40) {
                break;
            }
            phi_985_ = _e29;
            loop {
                let _e43 = phi_985_;
                if (_e43 < 2048u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    atomicStore((&global_7[_e43]), 0u);
                    phi_985_ = (_e43 + 128u);
                }
            }
            switch bitcast<i32>(0u) {
                default: {
                    let _e49 = global.member_6;
                    if !((_e49 != 0u)) {
                        phi_988_ = 0u;
                        phi_987_ = 0u;
                        loop {
                            let _e53 = phi_988_;
                            let _e55 = phi_987_;
                            local_3 = _e53;
                            if (_e55 < 2u) {
                                let _e58 = ((_e29 * 2u) + _e55);
                                phi_1038_ = 0u;
                                phi_1035_ = 0u;
                                loop {
                                    let _e60 = phi_1038_;
                                    let _e62 = phi_1035_;
                                    local = _e60;
                                    local_1 = _e60;
                                    if (_e62 < _e31) {
                                        continue;
                                    } else {
                                        break;
                                    }
                                    continuing {
                                        let _e68 = global_6.member[((_e62 * 256u) + _e58)];
                                        phi_1038_ = (_e60 + _e68);
                                        phi_1035_ = (_e62 + bitcast<u32>(1i));
                                    }
                                }
                                phi_1043_ = 0u;
                                phi_1036_ = _e31;
                                loop {
                                    let _e73 = phi_1043_;
                                    let _e75 = phi_1036_;
                                    local_2 = _e73;
                                    if (_e75 < _e40) {
                                        continue;
                                    } else {
                                        break;
                                    }
                                    continuing {
                                        let _e81 = global_6.member[((_e75 * 256u) + _e58)];
                                        phi_1043_ = (_e73 + _e81);
                                        phi_1036_ = (_e75 + bitcast<u32>(1i));
                                    }
                                }
                                let _e86 = local;
                                global_4[_e58] = (_e86 + _e53);
                                let _e90 = local_1;
                                let _e92 = local_2;
                                local_6 = (_e53 + (_e90 + _e92));
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e229 = local_6;
                                phi_988_ = _e229;
                                phi_987_ = (_e55 + bitcast<u32>(1i));
                            }
                        }
                        let _e99 = local_3;
                        global_5[_e29] = _e99;
                        workgroupBarrier();
                        phi_992_ = 0u;
                        phi_989_ = 0u;
                        loop {
                            let _e101 = phi_992_;
                            let _e103 = phi_989_;
                            local_4 = _e101;
                            if (_e103 < _e29) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e106 = global_5[_e103];
                                phi_992_ = (_e101 + _e106);
                                phi_989_ = (_e103 + bitcast<u32>(1i));
                            }
                        }
                        phi_990_ = 0u;
                        loop {
                            let _e111 = phi_990_;
                            if (_e111 < 2u) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e116 = global_4[((_e29 * 2u) + _e111)];
                                let _e118 = local_4;
                                global_4[((_e29 * 2u) + _e111)] = (_e116 + _e118);
                                phi_990_ = (_e111 + bitcast<u32>(1i));
                            }
                        }
                        workgroupBarrier();
                        break;
                    }
                    phi_986_ = 0u;
                    loop {
                        let _e123 = phi_986_;
                        if (_e123 < 2u) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e126 = (_e29 * 2u);
                            let _e131 = global_6.member[(((_e31 * 256u) + _e126) + _e123)];
                            global_4[(_e126 + _e123)] = _e131;
                            phi_986_ = (_e123 + bitcast<u32>(1i));
                        }
                    }
                    workgroupBarrier();
                    break;
                }
            }
            let _e136 = (_e29 / 32u);
            let _e139 = (1u << bitcast<u32>((_e29 & 31u)));
            let _e143 = min(_e37, ((_e31 + 1u) * 4096u));
            phi_994_ = 0u;
            phi_993_ = (_e31 * 4096u);
            loop {
                let _e146 = phi_994_;
                let _e148 = phi_993_;
                if (_e148 < _e143) {
                    let _e150 = (_e148 + _e29);
                    let _e152 = ((_e146 & 1u) * 1024u);
                    let _e153 = (_e150 < _e143);
                    phi_1006_ = 0u;
                    phi_996_ = 0u;
                    if _e153 {
                        let _e156 = global_2.member[_e150];
                        phi_1006_ = _e156;
                        phi_996_ = ((_e156 >> bitcast<u32>(24u)) & 255u);
                    }
                    let _e161 = phi_1006_;
                    let _e163 = phi_996_;
                    let _e164 = select(_e153, true, _e153);
                    if _e164 {
                        let _e169 = atomicOr((&global_7[((_e152 + (_e136 * 256u)) + _e163)]), _e139);
                    }
                    workgroupBarrier();
                    phi_1011_ = 0u;
                    phi_1009_ = 0u;
                    if _e164 {
                        phi_1014_ = 0u;
                        phi_1001_ = 0u;
                        phi_998_ = 0u;
                        loop {
                            let _e171 = phi_1014_;
                            let _e173 = phi_1001_;
                            let _e175 = phi_998_;
                            local_5 = _e173;
                            local_9 = _e171;
                            local_10 = _e173;
                            if (_e175 < 4u) {
                                let _e181 = atomicLoad((&global_7[((_e152 + (_e175 * 256u)) + _e163)]));
                                let _e183 = bitcast<u32>(countOneBits(_e181));
                                local_7 = (_e171 + _e183);
                                if (_e175 < _e136) {
                                    phi_1030_ = _e183;
                                } else {
                                    if (_e175 == _e136) {
                                        phi_1029_ = bitcast<u32>(countOneBits((_e181 & (_e139 - 1u))));
                                    } else {
                                        phi_1029_ = 0u;
                                    }
                                    let _e191 = phi_1029_;
                                    phi_1030_ = _e191;
                                }
                                let _e193 = phi_1030_;
                                local_8 = (_e173 + _e193);
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e250 = local_7;
                                phi_1014_ = _e250;
                                let _e253 = local_8;
                                phi_1001_ = _e253;
                                phi_998_ = (_e175 + bitcast<u32>(1i));
                            }
                        }
                        let _e198 = global_4[_e163];
                        let _e200 = local_5;
                        global_3.member[(_e198 + _e200)] = (_e161 & 16777215u);
                        let _e260 = local_9;
                        phi_1011_ = _e260;
                        let _e263 = local_10;
                        phi_1009_ = _e263;
                    }
                    let _e206 = phi_1011_;
                    let _e208 = phi_1009_;
                    workgroupBarrier();
                    if (_e164 && (_e208 == 0u)) {
                        let _e212 = global_4[_e163];
                        global_4[_e163] = (_e212 + _e206);
                        phi_1015_ = 0u;
                        loop {
                            let _e215 = phi_1015_;
                            if (_e215 < 4u) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                atomicStore((&global_7[((_e152 + (_e215 * 256u)) + _e163)]), 0u);
                                phi_1015_ = (_e215 + bitcast<u32>(1i));
                            }
                        }
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_994_ = (_e146 + bitcast<u32>(1i));
                    phi_993_ = (_e148 + 128u);
                }
            }
            break;
        }
    }
    return;
}
