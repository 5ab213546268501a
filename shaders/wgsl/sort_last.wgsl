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

struct type_12 {
    member: array<u32>,
}

@group(0) @binding(7) 
var<uniform> global: type_3;
@group(0) @binding(3) 
var<storage> global_1: type_8;
@group(0) @binding(1) 
var<storage> global_2: type_12;
@group(0) @binding(4) 
var<storage, read_write> global_3: type_12;
var<workgroup> global_4: array<u32, 128>;
var<workgroup> global_5: array<u32, 256>;
@group(0) @binding(2) 
var<storage> global_6: type_12;
var<private> global_7: vec3<u32>;
var<private> global_8: vec3<u32>;
var<workgroup> global_9: array<atomic<u32>, 2048>;

fn function_() {
    var phi_876_: u32;
    var phi_879_: u32;
    var phi_878_: u32;
    var phi_929_: u32;
    var phi_926_: u32;
    var phi_932_: u32;
    var phi_927_: u32;
    var local: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_883_: u32;
    var phi_880_: u32;
    var phi_881_: u32;
    var local_4: u32;
    var phi_877_: u32;
    var phi_885_: u32;
    var phi_884_: u32;
    var phi_897_: u32;
    var phi_887_: u32;
    var phi_905_: u32;
    var phi_892_: u32;
    var phi_889_: u32;
    var phi_920_: u32;
    var phi_921_: u32;
    var local_5: u32;
    var phi_902_: u32;
    var phi_900_: u32;
    var phi_906_: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var local_9: u32;
    var local_10: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e33 = global_7[0u];
            let _e35 = global_8[0u];
            let _e38 = global_1.member.member_6;
            let _e40 = global.member_5;
            let _e41 = min(_e38, _e40);
            let _e44 = max(((_e41 + 4095u) / 4096u), 1u);
            if (_e35 >= _e44) {
                break;
            }
            phi_876_ = _e33;
            loop {
                let _e47 = phi_876_;
                if (_e47 < 2048u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    atomicStore((&global_9[_e47]), 0u);
                    phi_876_ = (_e47 + 128u);
                }
            }
            switch bitcast<i32>(0u) {
                default: {
                    let _e53 = global.member_6;
                    if !((_e53 != 0u)) {
                        phi_879_ = 0u;
                        phi_878_ = 0u;
                        loop {
                            let _e57 = phi_879_;
                            let _e59 = phi_878_;
                            local_3 = _e57;
                            if (_e59 < 2u) {
                                let _e62 = ((_e33 * 2u) + _e59);
                                phi_929_ = 0u;
                                phi_926_ = 0u;
                                loop {
                                    let _e64 = phi_929_;
                                    let _e66 = phi_926_;
                                    local = _e64;
                                    local_1 = _e64;
                                    if (_e66 < _e35) {
                                        continue;
                                    } else {
                                        break;
                                    }
                                    continuing {
                                        let _e72 = global_6.member[((_e66 * 256u) + _e62)];
                                        phi_929_ = (_e64 + _e72);
                                        phi_926_ = (_e66 + bitcast<u32>(1i));
                                    }
                                }
                                phi_932_ = 0u;
                                phi_927_ = _e35;
                                loop {
                                    let _e77 = phi_932_;
                                    let _e79 = phi_927_;
                                    local_2 = _e77;
                                    if (_e79 < _e44) {
                                        continue;
                                    } else {
                                        break;
                                    }
                                    continuing {
                                        let _e85 = global_6.member[((_e79 * 256u) + _e62)];
                                        phi_932_ = (_e77 + _e85);
                                        phi_927_ = (_e79 + bitcast<u32>(1i));
                                    }
                                }
                                let _e90 = local;
                                global_5[_e62] = (_e90 + _e57);
                                let _e94 = local_1;
                                let _e96 = local_2;
                                local_6 = (_e57 + (_e94 + _e96));
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e228 = local_6;
                                phi_879_ = _e228;
                                phi_878_ = (_e59 + bitcast<u32>(1i));
                            }
                        }
                        let _e103 = local_3;
                        global_4[_e33] = _e103;
                        workgroupBarrier();
                        phi_883_ = 0u;
                        phi_880_ = 0u;
                        loop {
                            let _e105 = phi_883_;
                            let _e107 = phi_880_;
                            local_4 = _e105;
                            if (_e107 < _e33) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e110 = global_4[_e107];
                                phi_883_ = (_e105 + _e110);
                                phi_880_ = (_e107 + bitcast<u32>(1i));
                            }
                        }
                        phi_881_ = 0u;
                        loop {
                            let _e115 = phi_881_;
                            if (_e115 < 2u) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e120 = global_5[((_e33 * 2u) + _e115)];
                                let _e122 = local_4;
                                global_5[((_e33 * 2u) + _e115)] = (_e120 + _e122);
                                phi_881_ = (_e115 + bitcast<u32>(1i));
                            }
                        }
                        workgroupBarrier();
                        break;
                    }
                    phi_877_ = _e33;
                    loop {
                        let _e127 = phi_877_;
                        if (_e127 < 256u) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e133 = global_6.member[((_e35 * 256u) + _e127)];
                            global_5[_e127] = _e133;
                            phi_877_ = (_e127 + 128u);
                        }
                    }
                    workgroupBarrier();
                    break;
                }
            }
            let _e136 = (_e33 / 32u);
            let _e139 = (1u << bitcast<u32>((_e33 & 31u)));
            let _e143 = min(_e41, ((_e35 + 1u) * 4096u));
            phi_885_ = 0u;
            phi_884_ = (_e35 * 4096u);
            loop {
                let _e146 = phi_885_;
                let _e148 = phi_884_;
                if (_e148 < _e143) {
                    let _e150 = (_e148 + _e33);
                    let _e152 = ((_e146 & 1u) * 1024u);
                    let _e153 = (_e150 < _e143);
                    phi_897_ = 0u;
                    phi_887_ = 0u;
                    if _e153 {
                        let _e156 = global_2.member[_e150];
                        phi_897_ = _e156;
                        phi_887_ = (_e156 >> bitcast<u32>(24u));
                    }
                    let _e160 = phi_897_;
                    let _e162 = phi_887_;
                    let _e163 = select(_e153, true, _e153);
                    if _e163 {
                        let _e168 = atomicOr((&global_9[((_e152 + (_e136 * 256u)) + _e162)]), _e139);
                    }
                    workgroupBarrier();
                    phi_902_ = 0u;
                    phi_900_ = 0u;
                    if _e163 {
                        phi_905_ = 0u;
                        phi_892_ = 0u;
                        phi_889_ = 0u;
                        loop {
                            let _e170 = phi_905_;
                            let _e172 = phi_892_;
                            let _e174 = phi_889_;
                            local_5 = _e172;
                            local_9 = _e170;
                            local_10 = _e172;
                            if (_e174 < 4u) {
                                let _e180 = atomicLoad((&global_9[((_e152 + (_e174 * 256u)) + _e162)]));
                                let _e182 = bitcast<u32>(countOneBits(_e180));
                                local_7 = (_e170 + _e182);
                                if (_e174 < _e136) {
                                    phi_921_ = _e182;
                                } else {
                                    if (_e174 == _e136) {
                                        phi_920_ = bitcast<u32>(countOneBits((_e180 & (_e139 - 1u))));
                                    } else {
                                        phi_920_ = 0u;
                                    }
                                    let _e190 = phi_920_;
                                    phi_921_ = _e190;
                                }
                                let _e192 = phi_921_;
                                local_8 = (_e172 + _e192);
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e249 = local_7;
                                phi_905_ = _e249;
                                let _e252 = local_8;
                                phi_892_ = _e252;
                                phi_889_ = (_e174 + bitcast<u32>(1i));
                            }
                        }
                        let _e197 = global_5[_e162];
                        let _e199 = local_5;
                        global_3.member[(_e197 + _e199)] = (_e160 & 16777215u);
                        let _e259 = local_9;
                        phi_902_ = _e259;
                        let _e262 = local_10;
                        phi_900_ = _e262;
                    }
                    let _e205 = phi_902_;
                    let _e207 = phi_900_;
                    workgroupBarrier();
                    if (_e163 && (_e207 == 0u)) {
                        let _e211 = global_5[_e162];
                        global_5[_e162] = (_e211 + _e205);
                        phi_906_ = 0u;
                        loop {
                            let _e214 = phi_906_;
                            if (_e214 < 4u) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                atomicStore((&global_9[((_e152 + (_e214 * 256u)) + _e162)]), 0u);
                                phi_906_ = (_e214 + bitcast<u32>(1i));
                            }
                        }
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_885_ = (_e146 + bitcast<u32>(1i));
                    phi_884_ = (_e148 + 128u);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn main(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>) {
    global_7 = param;
    global_8 = param_1;
    function_();
}
