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

struct type_15 {
    member: array<u32, LENGTH_1_4>,
}

struct type_17 {
    member: array<u32, LENGTH_4_4>,
}

struct type_19 {
    member: array<u32, LENGTH_2_4>,
}

@group(0) @binding(7) 
var<uniform> global: type_3;
@group(0) @binding(3) 
var<storage, read_write> global_1: type_6;
@group(0) @binding(1) 
var<storage> global_2: type_15;
@group(0) @binding(4) 
var<storage, read_write> global_3: type_17;
var<workgroup> global_4: array<u32, 128>;
var<workgroup> global_5: array<u32, 256>;
@group(0) @binding(2) 
var<storage> global_6: type_19;
var<workgroup> global_7: array<atomic<u32>, 2048>;

@compute @workgroup_size(128, 1, 1) 
fn main(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>) {
    var phi_887_: u32;
    var phi_890_: u32;
    var phi_889_: u32;
    var phi_940_: u32;
    var phi_937_: u32;
    var phi_943_: u32;
    var phi_938_: u32;
    var local: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_894_: u32;
    var phi_891_: u32;
    var phi_892_: u32;
    var local_4: u32;
    var local_5: u32;
    var local_6: u32;
    var phi_888_: u32;
    var phi_896_: u32;
    var phi_895_: u32;
    var phi_908_: u32;
    var phi_898_: u32;
    var phi_897_: bool;
    var phi_916_: u32;
    var phi_903_: u32;
    var phi_900_: u32;
    var phi_931_: u32;
    var phi_932_: u32;
    var local_7: u32;
    var phi_913_: u32;
    var phi_911_: u32;
    var phi_917_: u32;
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
            phi_887_ = _e34;
            loop {
                let _e47 = phi_887_;
                if (_e47 < 2048u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    atomicStore((&global_7[_e47]), 0u);
                    phi_887_ = (_e47 + 128u);
                }
            }
            switch bitcast<i32>(0u) {
                default: {
                    let _e53 = global.member_6;
                    if !((_e53 != 0u)) {
                        phi_890_ = 0u;
                        phi_889_ = 0u;
                        loop {
                            let _e57 = phi_890_;
                            let _e59 = phi_889_;
                            local_3 = _e57;
                            local_6 = _e57;
                            if (_e59 < 2u) {
                                let _e62 = ((_e34 * 2u) + _e59);
                                phi_940_ = 0u;
                                phi_937_ = 0u;
                                loop {
                                    let _e64 = phi_940_;
                                    let _e66 = phi_937_;
                                    local = _e64;
                                    local_1 = _e64;
                                    if (_e66 < _e36) {
                                        continue;
                                    } else {
                                        break;
                                    }
                                    continuing {
                                        let _e72 = global_6.member[((_e66 * 256u) + _e62)];
                                        phi_940_ = (_e64 + _e72);
                                        phi_937_ = (_e66 + bitcast<u32>(1i));
                                    }
                                }
                                phi_943_ = 0u;
                                phi_938_ = _e36;
                                loop {
                                    let _e77 = phi_943_;
                                    let _e79 = phi_938_;
                                    local_2 = _e77;
                                    if (_e79 < _e44) {
                                        continue;
                                    } else {
                                        break;
                                    }
                                    continuing {
                                        let _e85 = global_6.member[((_e79 * 256u) + _e62)];
                                        phi_943_ = (_e77 + _e85);
                                        phi_938_ = (_e79 + bitcast<u32>(1i));
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
                                phi_890_ = _e259;
                                phi_889_ = (_e59 + bitcast<u32>(1i));
                            }
                        }
                        let _e103 = local_3;
                        global_4[_e34] = _e103;
                        workgroupBarrier();
                        phi_894_ = 0u;
                        phi_891_ = 0u;
                        loop {
                            let _e105 = phi_894_;
                            let _e107 = phi_891_;
                            local_4 = _e105;
                            local_5 = _e105;
                            if (_e107 < _e34) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e110 = global_4[_e107];
                                phi_894_ = (_e105 + _e110);
                                phi_891_ = (_e107 + bitcast<u32>(1i));
                            }
                        }
                        phi_892_ = 0u;
                        loop {
                            let _e115 = phi_892_;
                            if (_e115 < 2u) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e120 = global_5[((_e34 * 2u) + _e115)];
                                let _e122 = local_4;
                                global_5[((_e34 * 2u) + _e115)] = (_e120 + _e122);
                                phi_892_ = (_e115 + bitcast<u32>(1i));
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
                    phi_888_ = _e34;
                    loop {
                        let _e142 = phi_888_;
                        if (_e142 < 256u) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e148 = global_6.member[((_e36 * 256u) + _e142)];
                            global_5[_e142] = _e148;
                            phi_888_ = (_e142 + 128u);
                        }
                    }
                    workgroupBarrier();
                    break;
                }
            }
            let _e151 = (_e34 / 32u);
            let _e154 = (1u << bitcast<u32>((_e34 & 31u)));
            let _e158 = min(_e41, ((_e36 + 1u) * 4096u));
            phi_896_ = 0u;
            phi_895_ = (_e36 * 4096u);
            loop {
                let _e161 = phi_896_;
                let _e163 = phi_895_;
                if (_e163 < _e158) {
                    let _e165 = (_e163 + _e34);
                    let _e167 = ((_e161 & 1u) * 1024u);
                    let _e168 = (_e165 < _e158);
                    phi_908_ = 0u;
                    phi_898_ = 0u;
                    phi_897_ = _e168;
                    if _e168 {
                        let _e173 = global_2.member[(_e165 >> bitcast<u32>(1u))];
                        let _e178 = ((_e173 >> bitcast<u32>((16u * (_e165 & 1u)))) & 65535u);
                        let _e180 = select(_e178, 4294967295u, (_e178 == 65535u));
                        phi_908_ = _e180;
                        phi_898_ = (_e180 & 255u);
                        phi_897_ = (false || (_e180 != 4294967295u));
                    }
                    let _e185 = phi_908_;
                    let _e187 = phi_898_;
                    let _e189 = phi_897_;
                    if _e189 {
                        let _e194 = atomicOr((&global_7[((_e167 + (_e151 * 256u)) + _e187)]), _e154);
                    }
                    workgroupBarrier();
                    phi_913_ = 0u;
                    phi_911_ = 0u;
                    if _e189 {
                        phi_916_ = 0u;
                        phi_903_ = 0u;
                        phi_900_ = 0u;
                        loop {
                            let _e196 = phi_916_;
                            let _e198 = phi_903_;
                            let _e200 = phi_900_;
                            local_7 = _e198;
                            local_11 = _e196;
                            local_12 = _e198;
                            if (_e200 < 4u) {
                                let _e206 = atomicLoad((&global_7[((_e167 + (_e200 * 256u)) + _e187)]));
                                let _e208 = bitcast<u32>(countOneBits(_e206));
                                local_9 = (_e196 + _e208);
                                if (_e200 < _e151) {
                                    phi_932_ = _e208;
                                } else {
                                    if (_e200 == _e151) {
                                        phi_931_ = bitcast<u32>(countOneBits((_e206 & (_e154 - 1u))));
                                    } else {
                                        phi_931_ = 0u;
                                    }
                                    let _e216 = phi_931_;
                                    phi_932_ = _e216;
                                }
                                let _e218 = phi_932_;
                                local_10 = (_e198 + _e218);
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e283 = local_9;
                                phi_916_ = _e283;
                                let _e286 = local_10;
                                phi_903_ = _e286;
                                phi_900_ = (_e200 + bitcast<u32>(1i));
                            }
                        }
                        let _e223 = global_5[_e187];
                        let _e225 = local_7;
                        global_3.member[(_e223 + _e225)] = ((((_e185 >> bitcast<u32>(8u)) & 255u) << bitcast<u32>(24u)) | _e165);
                        let _e293 = local_11;
                        phi_913_ = _e293;
                        let _e296 = local_12;
                        phi_911_ = _e296;
                    }
                    let _e236 = phi_913_;
                    let _e238 = phi_911_;
                    workgroupBarrier();
                    if (_e189 && (_e238 == 0u)) {
                        let _e242 = global_5[_e187];
                        global_5[_e187] = (_e242 + _e236);
                        phi_917_ = 0u;
                        loop {
                            let _e245 = phi_917_;
                            if (_e245 < 4u) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                atomicStore((&global_7[((_e167 + (_e245 * 256u)) + _e187)]), 0u);
                                phi_917_ = (_e245 + bitcast<u32>(1i));
                            }
                        }
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_896_ = (_e161 + bitcast<u32>(1i));
                    phi_895_ = (_e163 + 128u);
                }
            }
            break;
        }
    }
    return;
}
