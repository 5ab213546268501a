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
var<storage, read_write> global_1: type_8;
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
            let _e40 = global_7[0u];
            let _e42 = global_8[0u];
            let _e44 = global.member_7;
            let _e46 = global.member_5;
            let _e47 = min(_e44, _e46);
            let _e50 = max(((_e47 + 4095u) / 4096u), 1u);
            if (_e42 >= _e50) {
                break;
            }
            phi_887_ = _e40;
            loop {
                let _e53 = phi_887_;
                if (_e53 < 2048u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    atomicStore((&global_9[_e53]), 0u);
                    phi_887_ = (_e53 + 128u);
                }
            }
            switch bitcast<i32>(0u) {
                default: {
                    let _e59 = global.member_6;
                    if !((_e59 != 0u)) {
                        phi_890_ = 0u;
                        phi_889_ = 0u;
                        loop {
                            let _e63 = phi_890_;
                            let _e65 = phi_889_;
                            local_3 = _e63;
                            local_6 = _e63;
                            if (_e65 < 2u) {
                                let _e68 = ((_e40 * 2u) + _e65);
                                phi_940_ = 0u;
                                phi_937_ = 0u;
                                loop {
                                    let _e70 = phi_940_;
                                    let _e72 = phi_937_;
                                    local = _e70;
                                    local_1 = _e70;
                                    if (_e72 < _e42) {
                                        continue;
                                    } else {
                                        break;
                                    }
                                    continuing {
                                        let _e78 = global_6.member[((_e72 * 256u) + _e68)];
                                        phi_940_ = (_e70 + _e78);
                                        phi_937_ = (_e72 + bitcast<u32>(1i));
                                    }
                                }
                                phi_943_ = 0u;
                                phi_938_ = _e42;
                                loop {
                                    let _e83 = phi_943_;
                                    let _e85 = phi_938_;
                                    local_2 = _e83;
                                    if (_e85 < _e50) {
                                        continue;
                                    } else {
                                        break;
                                    }
                                    continuing {
                                        let _e91 = global_6.member[((_e85 * 256u) + _e68)];
                                        phi_943_ = (_e83 + _e91);
                                        phi_938_ = (_e85 + bitcast<u32>(1i));
                                    }
                                }
                                let _e96 = local;
                                global_5[_e68] = (_e96 + _e63);
                                let _e100 = local_1;
                                let _e102 = local_2;
                                local_8 = (_e63 + (_e100 + _e102));
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e264 = local_8;
                                phi_890_ = _e264;
                                phi_889_ = (_e65 + bitcast<u32>(1i));
                            }
                        }
                        let _e109 = local_3;
                        global_4[_e40] = _e109;
                        workgroupBarrier();
                        phi_894_ = 0u;
                        phi_891_ = 0u;
                        loop {
                            let _e111 = phi_894_;
                            let _e113 = phi_891_;
                            local_4 = _e111;
                            local_5 = _e111;
                            if (_e113 < _e40) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e116 = global_4[_e113];
                                phi_894_ = (_e111 + _e116);
                                phi_891_ = (_e113 + bitcast<u32>(1i));
                            }
                        }
                        phi_892_ = 0u;
                        loop {
                            let _e121 = phi_892_;
                            if (_e121 < 2u) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e126 = global_5[((_e40 * 2u) + _e121)];
                                let _e128 = local_4;
                                global_5[((_e40 * 2u) + _e121)] = (_e126 + _e128);
                                phi_892_ = (_e121 + bitcast<u32>(1i));
                            }
                        }
                        workgroupBarrier();
                        let _e133 = local_5;
                        let _e135 = local_6;
                        let _e136 = (_e133 + _e135);
                        if ((true && (_e42 == 0u)) && (_e40 == 127u)) {
                            global_1.member.member_6 = _e136;
                            global_1.member.member_1 = ((_e136 + 127u) / 128u);
                        }
                        break;
                    }
                    phi_888_ = _e40;
                    loop {
                        let _e148 = phi_888_;
                        if (_e148 < 256u) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e154 = global_6.member[((_e42 * 256u) + _e148)];
                            global_5[_e148] = _e154;
                            phi_888_ = (_e148 + 128u);
                        }
                    }
                    workgroupBarrier();
                    break;
                }
            }
            let _e157 = (_e40 / 32u);
            let _e160 = (1u << bitcast<u32>((_e40 & 31u)));
            let _e164 = min(_e47, ((_e42 + 1u) * 4096u));
            phi_896_ = 0u;
            phi_895_ = (_e42 * 4096u);
            loop {
                let _e167 = phi_896_;
                let _e169 = phi_895_;
                if (_e169 < _e164) {
                    let _e171 = (_e169 + _e40);
                    let _e173 = ((_e167 & 1u) * 1024u);
                    let _e174 = (_e171 < _e164);
                    phi_908_ = 0u;
                    phi_898_ = 0u;
                    phi_897_ = _e174;
                    if _e174 {
                        let _e178 = global_2.member[(_e171 / 2u)];
                        let _e183 = ((_e178 >> bitcast<u32>((16u * (_e171 & 1u)))) & 65535u);
                        let _e185 = select(_e183, 4294967295u, (_e183 == 65535u));
                        phi_908_ = _e185;
                        phi_898_ = (_e185 & 255u);
                        phi_897_ = (false || (_e185 != 4294967295u));
                    }
                    let _e190 = phi_908_;
                    let _e192 = phi_898_;
                    let _e194 = phi_897_;
                    if _e194 {
                        let _e199 = atomicOr((&global_9[((_e173 + (_e157 * 256u)) + _e192)]), _e160);
                    }
                    workgroupBarrier();
                    phi_913_ = 0u;
                    phi_911_ = 0u;
                    if _e194 {
                        phi_916_ = 0u;
                        phi_903_ = 0u;
                        phi_900_ = 0u;
                        loop {
                            let _e201 = phi_916_;
                            let _e203 = phi_903_;
                            let _e205 = phi_900_;
                            local_7 = _e203;
                            local_11 = _e201;
                            local_12 = _e203;
                            if (_e205 < 4u) {
                                let _e211 = atomicLoad((&global_9[((_e173 + (_e205 * 256u)) + _e192)]));
                                let _e213 = bitcast<u32>(countOneBits(_e211));
                                local_9 = (_e201 + _e213);
                                if (_e205 < _e157) {
                                    phi_932_ = _e213;
                                } else {
                                    if (_e205 == _e157) {
                                        phi_931_ = bitcast<u32>(countOneBits((_e211 & (_e160 - 1u))));
                                    } else {
                                        phi_931_ = 0u;
                                    }
                                    let _e221 = phi_931_;
                                    phi_932_ = _e221;
                                }
                                let _e223 = phi_932_;
                                local_10 = (_e203 + _e223);
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e288 = local_9;
                                phi_916_ = _e288;
                                let _e291 = local_10;
                                phi_903_ = _e291;
                                phi_900_ = (_e205 + bitcast<u32>(1i));
                            }
                        }
                        let _e228 = global_5[_e192];
                        let _e230 = local_7;
                        global_3.member[(_e228 + _e230)] = ((((_e190 >> bitcast<u32>(8u)) & 255u) << bitcast<u32>(24u)) | _e171);
                        let _e298 = local_11;
                        phi_913_ = _e298;
                        let _e301 = local_12;
                        phi_911_ = _e301;
                    }
                    let _e241 = phi_913_;
                    let _e243 = phi_911_;
                    workgroupBarrier();
                    if (_e194 && (_e243 == 0u)) {
                        let _e247 = global_5[_e192];
                        global_5[_e192] = (_e247 + _e241);
                        phi_917_ = 0u;
                        loop {
                            let _e250 = phi_917_;
                            if (_e250 < 4u) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                atomicStore((&global_9[((_e173 + (_e250 * 256u)) + _e192)]), 0u);
                                phi_917_ = (_e250 + bitcast<u32>(1i));
                            }
                        }
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_896_ = (_e167 + bitcast<u32>(1i));
                    phi_895_ = (_e169 + 128u);
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
