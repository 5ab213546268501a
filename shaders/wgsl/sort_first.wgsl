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
var<storage, read_write> global_1: type_7;
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
    var phi_888_: u32;
    var phi_891_: u32;
    var phi_890_: u32;
    var phi_941_: u32;
    var phi_938_: u32;
    var phi_944_: u32;
    var phi_939_: u32;
    var local: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_895_: u32;
    var phi_892_: u32;
    var phi_893_: u32;
    var local_4: u32;
    var local_5: u32;
    var local_6: u32;
    var phi_889_: u32;
    var phi_897_: u32;
    var phi_896_: u32;
    var phi_909_: u32;
    var phi_899_: u32;
    var phi_898_: bool;
    var phi_917_: u32;
    var phi_904_: u32;
    var phi_901_: u32;
    var phi_932_: u32;
    var phi_933_: u32;
    var local_7: u32;
    var phi_914_: u32;
    var phi_912_: u32;
    var phi_918_: u32;
    var local_8: u32;
    var local_9: u32;
    var local_10: u32;
    var local_11: u32;
    var local_12: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e34 = bitcast<u32>(param[0u]);
            let _e36 = bitcast<u32>(param_1[0u]);
            let _e38 = global.member_7;
            let _e40 = global.member_5;
            let _e41 = min(_e38, _e40);
            let _e44 = max(((_e41 + 4095u) / 4096u), 1u);
            if (_e36 >= _e44) {
                break;
            }
            phi_888_ = _e34;
            loop {
                let _e47 = phi_888_;
                if (_e47 < 2048u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    atomicStore((&global_7[_e47]), 0u);
                    phi_888_ = (_e47 + 128u);
                }
            }
            switch bitcast<i32>(0u) {
                default: {
                    let _e53 = global.member_6;
                    if !((_e53 != 0u)) {
                        phi_891_ = 0u;
                        phi_890_ = 0u;
                        loop {
                            let _e57 = phi_891_;
                            let _e59 = phi_890_;
                            local_3 = _e57;
                            local_6 = _e57;
                            if (_e59 < 2u) {
                                let _e62 = ((_e34 * 2u) + _e59);
                                phi_941_ = 0u;
                                phi_938_ = 0u;
                                loop {
                                    let _e64 = phi_941_;
                                    let _e66 = phi_938_;
                                    local = _e64;
                                    local_1 = _e64;
                                    if (_e66 < _e36) {
                                        continue;
                                    } else {
                                        break;
                                    }
                                    continuing {
                                        let _e72 = global_6.member[((_e66 * 256u) + _e62)];
                                        phi_941_ = (_e64 + _e72);
                                        phi_938_ = (_e66 + bitcast<u32>(1i));
                                    }
                                }
                                phi_944_ = 0u;
                                phi_939_ = _e36;
                                loop {
                                    let _e77 = phi_944_;
                                    let _e79 = phi_939_;
                                    local_2 = _e77;
                                    if (_e79 < _e44) {
                                        continue;
                                    } else {
                                        break;
                                    }
                                    continuing {
                                        let _e85 = global_6.member[((_e79 * 256u) + _e62)];
                                        phi_944_ = (_e77 + _e85);
                                        phi_939_ = (_e79 + bitcast<u32>(1i));
                                    }
                                }
                                let _e90 = local;
                                global_5[_e62] = (_e90 + _e57);
                                let _e94 = local_1;
                                let _e96 = local_2;
                                local_8 = (_e57 + (_e94 + _e96));
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e259 = local_8;
                                phi_891_ = _e259;
                                phi_890_ = (_e59 + bitcast<u32>(1i));
                            }
                        }
                        let _e103 = local_3;
                        global_4[_e34] = _e103;
                        workgroupBarrier();
                        phi_895_ = 0u;
                        phi_892_ = 0u;
                        loop {
                            let _e105 = phi_895_;
                            let _e107 = phi_892_;
                            local_4 = _e105;
                            local_5 = _e105;
                            if (_e107 < _e34) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e110 = global_4[_e107];
                                phi_895_ = (_e105 + _e110);
                                phi_892_ = (_e107 + bitcast<u32>(1i));
                            }
                        }
                        phi_893_ = 0u;
                        loop {
                            let _e115 = phi_893_;
                            if (_e115 < 2u) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e120 = global_5[((_e34 * 2u) + _e115)];
                                let _e122 = local_4;
                                global_5[((_e34 * 2u) + _e115)] = (_e120 + _e122);
                                phi_893_ = (_e115 + bitcast<u32>(1i));
                            }
                        }
                        workgroupBarrier();
                        let _e127 = local_5;
                        let _e129 = local_6;
                        let _e130 = (_e127 + _e129);
                        if ((true && (_e36 == 0u)) && (_e34 == 127u)) {
                            global_1.member.member_6 = _e130;
                            global_1.member.member_1 = ((_e130 + 127u) / 128u);
                        }
                        break;
                    }
                    phi_889_ = _e34;
                    loop {
                        let _e142 = phi_889_;
                        if (_e142 < 256u) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e148 = global_6.member[((_e36 * 256u) + _e142)];
                            global_5[_e142] = _e148;
                            phi_889_ = (_e142 + 128u);
                        }
                    }
                    workgroupBarrier();
                    break;
                }
            }
            let _e151 = (_e34 / 32u);
            let _e154 = (1u << bitcast<u32>((_e34 & 31u)));
            let _e158 = min(_e41, ((_e36 + 1u) * 4096u));
            phi_897_ = 0u;
            phi_896_ = (_e36 * 4096u);
            loop {
                let _e161 = phi_897_;
                let _e163 = phi_896_;
                if (_e163 < _e158) {
                    let _e165 = (_e163 + _e34);
                    let _e167 = ((_e161 & 1u) * 1024u);
                    let _e168 = (_e165 < _e158);
                    phi_909_ = 0u;
                    phi_899_ = 0u;
                    phi_898_ = _e168;
                    if _e168 {
                        let _e173 = global_2.member[(_e165 >> bitcast<u32>(1u))];
                        let _e178 = ((_e173 >> bitcast<u32>((16u * (_e165 & 1u)))) & 65535u);
                        let _e180 = select(_e178, 4294967295u, (_e178 == 65535u));
                        phi_909_ = _e180;
                        phi_899_ = (_e180 & 255u);
                        phi_898_ = (false || (_e180 != 4294967295u));
                    }
                    let _e185 = phi_909_;
                    let _e187 = phi_899_;
                    let _e189 = phi_898_;
                    if _e189 {
                        let _e194 = atomicOr((&global_7[((_e167 + (_e151 * 256u)) + _e187)]), _e154);
                    }
                    workgroupBarrier();
                    phi_914_ = 0u;
                    phi_912_ = 0u;
                    if _e189 {
                        phi_917_ = 0u;
                        phi_904_ = 0u;
                        phi_901_ = 0u;
                        loop {
                            let _e196 = phi_917_;
                            let _e198 = phi_904_;
                            let _e200 = phi_901_;
                            local_7 = _e198;
                            local_11 = _e196;
                            local_12 = _e198;
                            if (_e200 < 4u) {
                                let _e206 = atomicLoad((&global_7[((_e167 + (_e200 * 256u)) + _e187)]));
                                let _e208 = bitcast<u32>(countOneBits(_e206));
                                local_9 = (_e196 + _e208);
                                if (_e200 < _e151) {
                                    phi_933_ = _e208;
                                } else {
                                    if (_e200 == _e151) {
                                        phi_932_ = bitcast<u32>(countOneBits((_e206 & (_e154 - 1u))));
                                    } else {
                                        phi_932_ = 0u;
                                    }
                                    let _e216 = phi_932_;
                                    phi_933_ = _e216;
                                }
                                let _e218 = phi_933_;
                                local_10 = (_e198 + _e218);
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e283 = local_9;
                                phi_917_ = _e283;
                                let _e286 = local_10;
                                phi_904_ = _e286;
                                phi_901_ = (_e200 + bitcast<u32>(1i));
                            }
                        }
                        let _e223 = global_5[_e187];
                        let _e225 = local_7;
                        global_3.member[(_e223 + _e225)] = ((((_e185 >> bitcast<u32>(8u)) & 255u) << bitcast<u32>(24u)) | _e165);
                        let _e293 = local_11;
                        phi_914_ = _e293;
                        let _e296 = local_12;
                        phi_912_ = _e296;
                    }
                    let _e236 = phi_914_;
                    let _e238 = phi_912_;
                    workgroupBarrier();
                    if (_e189 && (_e238 == 0u)) {
                        let _e242 = global_5[_e187];
                        global_5[_e187] = (_e242 + _e236);
                        phi_918_ = 0u;
                        loop {
                            let _e245 = phi_918_;
                            if (_e245 < 4u) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                atomicStore((&global_7[((_e167 + (_e245 * 256u)) + _e187)]), 0u);
                                phi_918_ = (_e245 + bitcast<u32>(1i));
                            }
                        }
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_897_ = (_e161 + bitcast<u32>(1i));
                    phi_896_ = (_e163 + 128u);
                }
            }
            break;
        }
    }
    return;
}
