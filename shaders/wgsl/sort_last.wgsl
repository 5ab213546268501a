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
var<workgroup> global_4: array<u32, 128>;
var<workgroup> global_5: array<u32, 256>;
@group(0) @binding(2) 
var<storage> global_6: type_20;
var<workgroup> global_7: array<atomic<u32>, 2048>;

@compute @workgroup_size(128, 1, 1) 
fn main(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>) {
    var phi_877_: u32;
    var phi_880_: u32;
    var phi_879_: u32;
    var phi_930_: u32;
    var phi_927_: u32;
    var phi_933_: u32;
    var phi_928_: u32;
    var local: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_884_: u32;
    var phi_881_: u32;
    var phi_882_: u32;
    var local_4: u32;
    var phi_878_: u32;
    var phi_886_: u32;
    var phi_885_: u32;
    var phi_898_: u32;
    var phi_888_: u32;
    var phi_906_: u32;
    var phi_893_: u32;
    var phi_890_: u32;
    var phi_921_: u32;
    var phi_922_: u32;
    var local_5: u32;
    var phi_903_: u32;
    var phi_901_: u32;
    var phi_907_: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var local_9: u32;
    var local_10: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e28 = bitcast<u32>(param[0u]);
            let _e30 = bitcast<u32>(param_1[0u]);
            let _e33 = global_1.member.member_6;
            let _e35 = global.member_5;
            let _e36 = min(_e33, _e35);
            let _e39 = max(((_e36 + 4095u) / 4096u), 1u);
            if (_e30 >= _e39) {
                break;
            }
            phi_877_ = _e28;
            loop {
                let _e42 = phi_877_;
                if (_e42 < 2048u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    atomicStore((&global_7[_e42]), 0u);
                    phi_877_ = (_e42 + 128u);
                }
            }
            switch bitcast<i32>(0u) {
                default: {
                    let _e48 = global.member_6;
                    if !((_e48 != 0u)) {
                        phi_880_ = 0u;
                        phi_879_ = 0u;
                        loop {
                            let _e52 = phi_880_;
                            let _e54 = phi_879_;
                            local_3 = _e52;
                            if (_e54 < 2u) {
                                let _e57 = ((_e28 * 2u) + _e54);
                                phi_930_ = 0u;
                                phi_927_ = 0u;
                                loop {
                                    let _e59 = phi_930_;
                                    let _e61 = phi_927_;
                                    local = _e59;
                                    local_1 = _e59;
                                    if (_e61 < _e30) {
                                        continue;
                                    } else {
                                        break;
                                    }
                                    continuing {
                                        let _e67 = global_6.member[((_e61 * 256u) + _e57)];
                                        phi_930_ = (_e59 + _e67);
                                        phi_927_ = (_e61 + bitcast<u32>(1i));
                                    }
                                }
                                phi_933_ = 0u;
                                phi_928_ = _e30;
                                loop {
                                    let _e72 = phi_933_;
                                    let _e74 = phi_928_;
                                    local_2 = _e72;
                                    if (_e74 < _e39) {
                                        continue;
                                    } else {
                                        break;
                                    }
                                    continuing {
                                        let _e80 = global_6.member[((_e74 * 256u) + _e57)];
                                        phi_933_ = (_e72 + _e80);
                                        phi_928_ = (_e74 + bitcast<u32>(1i));
                                    }
                                }
                                let _e85 = local;
                                global_5[_e57] = (_e85 + _e52);
                                let _e89 = local_1;
                                let _e91 = local_2;
                                local_6 = (_e52 + (_e89 + _e91));
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e223 = local_6;
                                phi_880_ = _e223;
                                phi_879_ = (_e54 + bitcast<u32>(1i));
                            }
                        }
                        let _e98 = local_3;
                        global_4[_e28] = _e98;
                        workgroupBarrier();
                        phi_884_ = 0u;
                        phi_881_ = 0u;
                        loop {
                            let _e100 = phi_884_;
                            let _e102 = phi_881_;
                            local_4 = _e100;
                            if (_e102 < _e28) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e105 = global_4[_e102];
                                phi_884_ = (_e100 + _e105);
                                phi_881_ = (_e102 + bitcast<u32>(1i));
                            }
                        }
                        phi_882_ = 0u;
                        loop {
                            let _e110 = phi_882_;
                            if (_e110 < 2u) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e115 = global_5[((_e28 * 2u) + _e110)];
                                let _e117 = local_4;
                                global_5[((_e28 * 2u) + _e110)] = (_e115 + _e117);
                                phi_882_ = (_e110 + bitcast<u32>(1i));
                            }
                        }
                        workgroupBarrier();
                        break;
                    }
                    phi_878_ = _e28;
                    loop {
                        let _e122 = phi_878_;
                        if (_e122 < 256u) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e128 = global_6.member[((_e30 * 256u) + _e122)];
                            global_5[_e122] = _e128;
                            phi_878_ = (_e122 + 128u);
                        }
                    }
                    workgroupBarrier();
                    break;
                }
            }
            let _e131 = (_e28 / 32u);
            let _e134 = (1u << bitcast<u32>((_e28 & 31u)));
            let _e138 = min(_e36, ((_e30 + 1u) * 4096u));
            phi_886_ = 0u;
            phi_885_ = (_e30 * 4096u);
            loop {
                let _e141 = phi_886_;
                let _e143 = phi_885_;
                if (_e143 < _e138) {
                    let _e145 = (_e143 + _e28);
                    let _e147 = ((_e141 & 1u) * 1024u);
                    let _e148 = (_e145 < _e138);
                    phi_898_ = 0u;
                    phi_888_ = 0u;
                    if _e148 {
                        let _e151 = global_2.member[_e145];
                        phi_898_ = _e151;
                        phi_888_ = (_e151 >> bitcast<u32>(24u));
                    }
                    let _e155 = phi_898_;
                    let _e157 = phi_888_;
                    let _e158 = select(_e148, true, _e148);
                    if _e158 {
                        let _e163 = atomicOr((&global_7[((_e147 + (_e131 * 256u)) + _e157)]), _e134);
                    }
                    workgroupBarrier();
                    phi_903_ = 0u;
                    phi_901_ = 0u;
                    if _e158 {
                        phi_906_ = 0u;
                        phi_893_ = 0u;
                        phi_890_ = 0u;
                        loop {
                            let _e165 = phi_906_;
                            let _e167 = phi_893_;
                            let _e169 = phi_890_;
                            local_5 = _e167;
                            local_9 = _e165;
                            local_10 = _e167;
                            if (_e169 < 4u) {
                                let _e175 = atomicLoad((&global_7[((_e147 + (_e169 * 256u)) + _e157)]));
                                let _e177 = bitcast<u32>(countOneBits(_e175));
                                local_7 = (_e165 + _e177);
                                if (_e169 < _e131) {
                                    phi_922_ = _e177;
                                } else {
                                    if (_e169 == _e131) {
                                        phi_921_ = bitcast<u32>(countOneBits((_e175 & (_e134 - 1u))));
                                    } else {
                                        phi_921_ = 0u;
                                    }
                                    let _e185 = phi_921_;
                                    phi_922_ = _e185;
                                }
                                let _e187 = phi_922_;
                                local_8 = (_e167 + _e187);
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e244 = local_7;
                                phi_906_ = _e244;
                                let _e247 = local_8;
                                phi_893_ = _e247;
                                phi_890_ = (_e169 + bitcast<u32>(1i));
                            }
                        }
                        let _e192 = global_5[_e157];
                        let _e194 = local_5;
                        global_3.member[(_e192 + _e194)] = (_e155 & 16777215u);
                        let _e254 = local_9;
                        phi_903_ = _e254;
                        let _e257 = local_10;
                        phi_901_ = _e257;
                    }
                    let _e200 = phi_903_;
                    let _e202 = phi_901_;
                    workgroupBarrier();
                    if (_e158 && (_e202 == 0u)) {
                        let _e206 = global_5[_e157];
                        global_5[_e157] = (_e206 + _e200);
                        phi_907_ = 0u;
                        loop {
                            let _e209 = phi_907_;
                            if (_e209 < 4u) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                atomicStore((&global_7[((_e147 + (_e209 * 256u)) + _e157)]), 0u);
                                phi_907_ = (_e209 + bitcast<u32>(1i));
                            }
                        }
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_886_ = (_e141 + bitcast<u32>(1i));
                    phi_885_ = (_e143 + 128u);
                }
            }
            break;
        }
    }
    return;
}
