struct type_9 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_13 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
    member_3: vec2<f32>,
    member_4: vec2<f32>,
    member_5: f32,
    member_6: f32,
    member_7: f32,
    member_8: f32,
    member_9: u32,
    member_10: f32,
    member_11: vec4<f32>,
    member_12: vec4<f32>,
    member_13: vec4<f32>,
    member_14: u32,
    member_15: u32,
    member_16: u32,
    member_17: u32,
    member_18: u32,
    member_19: u32,
    member_20: u32,
    member_21: u32,
    member_22: u32,
    member_23: u32,
    member_24: u32,
    member_25: f32,
    member_26: u32,
    member_27: u32,
    member_28: u32,
    member_29: f32,
    member_30: f32,
    member_31: u32,
    member_32: f32,
    member_33: f32,
    member_34: u32,
    member_35: u32,
    member_36: u32,
    member_37: u32,
    member_38: u32,
    member_39: f32,
    member_40: u32,
    member_41: u32,
    member_42: f32,
    member_43: u32,
    member_44: u32,
    member_45: f32,
    member_46: u32,
    member_47: f32,
    member_48: f32,
    member_49: f32,
    member_50: vec4<f32>,
    member_51: vec4<f32>,
    member_52: vec4<f32>,
    member_53: array<vec4<f32>, 3>,
    member_54: array<vec4<u32>, 8>,
    member_55: array<vec4<u32>, 8>,
    member_56: array<type_9, 8>,
    member_57: array<vec4<f32>, 128>,
    member_58: array<vec4<f32>, 768>,
}

struct type_16 {
    member: array<u32>,
}

struct type_17 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: i32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
}

struct type_18 {
    member: type_17,
}

struct type_20 {
    member: array<vec4<u32>>,
}

struct type_24 {
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
}

struct type_26 {
    member: array<u32, LENGTH_1_4>,
}

struct type_28 {
    member: array<vec4<u32>, LENGTH_2_16>,
}

struct type_30 {
    member: array<u32, LENGTH_4_4>,
}

struct type_32 {
    member: array<u32, LENGTH_5_4>,
}

@group(0) @binding(0) 
var<uniform> global: type_13;
@group(0) @binding(1) 
var<storage> global_1: type_26;
@group(0) @binding(3) 
var<storage> global_2: type_18;
@group(0) @binding(2) 
var<storage> global_3: type_28;
var<workgroup> global_4: array<u32, 256>;
var<workgroup> global_5: array<u32, 256>;
var<workgroup> global_6: array<u32, 256>;
var<workgroup> global_7: array<u32, 256>;
@group(0) @binding(4) 
var<storage, read_write> global_8: type_30;
@group(0) @binding(7) 
var<uniform> global_9: type_24;
@group(0) @binding(5) 
var<storage, read_write> global_10: type_32;

@compute @workgroup_size(128, 1, 1) 
fn main(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>) {
    var local: array<u32, 2>;
    var phi_1239_: u32;
    var phi_801_: bool;
    var phi_1266_: u32;
    var phi_1270_: u32;
    var phi_1240_: u32;
    var phi_1260_: u32;
    var phi_1264_: u32;
    var phi_1261_: u32;
    var phi_1241_: u32;
    var phi_1243_: u32;
    var phi_1242_: u32;
    var local_1: u32;
    var local_2: u32;
    var phi_1244_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1247_: u32;
    var phi_1246_: u32;
    var phi_1252_: u32;
    var phi_1251_: u32;
    var local_6: u32;
    var local_7: u32;
    var phi_1253_: u32;
    var local_8: u32;
    var local_9: u32;
    var local_10: u32;
    var phi_1256_: u32;
    var phi_1255_: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e33 = bitcast<u32>(param[0u]);
            let _e35 = bitcast<u32>(param_1[0u]);
            let _e36 = (_e35 * 256u);
            let _e39 = global_2.member.member_6;
            if (_e36 >= _e39) {
                break;
            }
            let _e43 = global_8.member[8i];
            phi_1239_ = _e33;
            loop {
                let _e45 = phi_1239_;
                if (_e45 < 256u) {
                    let _e47 = (_e36 + _e45);
                    global_5[_e45] = 1u;
                    phi_1270_ = 0u;
                    if (_e47 < _e39) {
                        let _e54 = global_1.member[((_e39 - 1u) - _e47)];
                        let _e57 = global_3.member[_e54];
                        let _e62 = global.member_10;
                        let _e66 = global.member_5;
                        let _e68 = ((vec2<f32>((_e57.xy & vec2<u32>(1048575u, 1048575u))) / vec2(_e62)) - vec2(_e66));
                        let _e70 = unpack2x16float(_e57.z);
                        let _e79 = global.member_30;
                        let _e82 = global.member_29;
                        let _e90 = (unpack2x16float(_e57.w).x * inverseSqrt(dot(_e70, _e70)));
                        let _e93 = _e70.yx;
                        let _e98 = (sqrt(((_e70 * _e70) + ((_e93 * (_e90 * _e90)) * _e93))) * sqrt((2f * log(max((max(f32(((_e57.w >> bitcast<u32>(16u)) & 255u)), _e79) / _e82), 1f)))));
                        let _e99 = (_e68 - _e98);
                        let _e100 = (_e68 + _e98);
                        let _e102 = global.member_46;
                        let _e104 = global.member_4;
                        let _e106 = vec2(_e102);
                        let _e111 = vec2<f32>(((((vec2<u32>(_e104) + _e106) - vec2<u32>(1u, 1u)) / _e106) - vec2<u32>(1u, 1u)));
                        let _e113 = vec2(f32(_e102));
                        let _e119 = vec2<u32>(clamp((_e100 / _e113), vec2<f32>(0f, 0f), _e111));
                        let _e121 = all((_e99 < _e104));
                        phi_801_ = _e121;
                        if _e121 {
                            phi_801_ = all((_e100 > vec2<f32>(0f, 0f)));
                        }
                        let _e125 = phi_801_;
                        let _e127 = vec2(_e43);
                        let _e131 = (vec2<u32>(clamp((_e99 / _e113), vec2<f32>(0f, 0f), _e111)) >> bitcast<vec2<u32>>(_e127));
                        let _e133 = (((_e119 >> bitcast<vec2<u32>>(_e127)) - _e131) + vec2<u32>(1u, 1u));
                        if !(_e125) {
                            phi_1266_ = 0u;
                        } else {
                            phi_1266_ = (_e133.x * _e133.y);
                        }
                        let _e138 = phi_1266_;
                        global_7[_e45] = _e54;
                        global_6[_e45] = (_e131.x | (_e131.y << bitcast<u32>(16u)));
                        global_5[_e45] = (((_e119.x >> bitcast<u32>(_e43)) - _e131.x) + 1u);
                        phi_1270_ = _e138;
                    }
                    let _e152 = phi_1270_;
                    global_4[_e45] = _e152;
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_1239_ = (_e45 + 128u);
                }
            }
            workgroupBarrier();
            phi_1240_ = 1u;
            loop {
                let _e156 = phi_1240_;
                if (_e156 < 256u) {
                    phi_1260_ = 0u;
                    loop {
                        let _e159 = phi_1260_;
                        if (_e159 < 2u) {
                            let _e162 = ((_e159 * 128u) + _e33);
                            if (_e162 >= _e156) {
                                let _e166 = global_4[(_e162 - _e156)];
                                phi_1264_ = _e166;
                            } else {
                                phi_1264_ = 0u;
                            }
                            let _e168 = phi_1264_;
                            local[_e159] = _e168;
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            phi_1260_ = (_e159 + bitcast<u32>(1i));
                        }
                    }
                    workgroupBarrier();
                    phi_1261_ = 0u;
                    loop {
                        let _e173 = phi_1261_;
                        if (_e173 < 2u) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e178 = local[_e173];
                            let _e180 = global_4[((_e173 * 128u) + _e33)];
                            global_4[((_e173 * 128u) + _e33)] = (_e180 + _e178);
                            phi_1261_ = (_e173 + bitcast<u32>(1i));
                        }
                    }
                    workgroupBarrier();
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_1240_ = (_e156 * 2u);
                }
            }
            let _e186 = global.member_46;
            let _e190 = global.member_4;
            let _e192 = vec2((_e186 << bitcast<u32>(_e43)));
            let _e198 = global_9.member_11;
            let _e203 = global_8.member[(_e198 + (_e35 * 10u))];
            let _e205 = global_4[255i];
            phi_1241_ = (2u * _e33);
            loop {
                let _e210 = phi_1241_;
                if (_e210 < (_e205 + (_e205 & 1u))) {
                    switch bitcast<i32>(0u) {
                        default: {
                            let _e213 = global_4[255i];
                            if (_e210 >= _e213) {
                                phi_1247_ = 65535u;
                                phi_1246_ = 0u;
                                break;
                            }
                            phi_1243_ = 0u;
                            phi_1242_ = 128u;
                            loop {
                                let _e216 = phi_1243_;
                                let _e218 = phi_1242_;
                                local_1 = _e216;
                                local_2 = _e216;
                                local_3 = _e216;
                                local_4 = _e216;
                                local_5 = _e216;
                                if (_e218 > 0u) {
                                    continue;
                                } else {
                                    break;
                                }
                                continuing {
                                    let _e223 = global_4[((_e216 + _e218) - 1u)];
                                    phi_1243_ = (_e216 + select(0u, _e218, (_e223 <= _e210)));
                                    phi_1242_ = (_e218 / 2u);
                                }
                            }
                            let _e229 = local_1;
                            if (_e229 > 0u) {
                                let _e232 = local_2;
                                let _e235 = global_4[(_e232 - 1u)];
                                phi_1244_ = _e235;
                            } else {
                                phi_1244_ = 0u;
                            }
                            let _e237 = phi_1244_;
                            let _e238 = (_e210 - _e237);
                            let _e240 = local_3;
                            let _e242 = global_5[_e240];
                            let _e243 = (_e238 / _e242);
                            let _e245 = local_4;
                            let _e247 = global_6[_e245];
                            let _e250 = global_5[_e240];
                            let _e253 = global_6[_e245];
                            let _e260 = local_5;
                            let _e262 = global_7[_e260];
                            phi_1247_ = ((((_e253 >> bitcast<u32>(16u)) + _e243) * (((vec2<u32>(_e190) + _e192) - vec2<u32>(1u, 1u)) / _e192).x) + (((_e247 & 65535u) + _e238) - (_e243 * _e250)));
                            phi_1246_ = _e262;
                            break;
                        }
                    }
                    let _e264 = phi_1247_;
                    let _e266 = phi_1246_;
                    let _e267 = (_e210 + 1u);
                    switch bitcast<i32>(0u) {
                        default: {
                            let _e269 = global_4[255i];
                            if (_e267 >= _e269) {
                                phi_1256_ = 65535u;
                                phi_1255_ = 0u;
                                break;
                            }
                            phi_1252_ = 0u;
                            phi_1251_ = 128u;
                            loop {
                                let _e272 = phi_1252_;
                                let _e274 = phi_1251_;
                                local_6 = _e272;
                                local_7 = _e272;
                                local_8 = _e272;
                                local_9 = _e272;
                                local_10 = _e272;
                                if (_e274 > 0u) {
                                    continue;
                                } else {
                                    break;
                                }
                                continuing {
                                    let _e279 = global_4[((_e272 + _e274) - 1u)];
                                    phi_1252_ = (_e272 + select(0u, _e274, (_e279 <= _e267)));
                                    phi_1251_ = (_e274 / 2u);
                                }
                            }
                            let _e285 = local_6;
                            if (_e285 > 0u) {
                                let _e288 = local_7;
                                let _e291 = global_4[(_e288 - 1u)];
                                phi_1253_ = _e291;
                            } else {
                                phi_1253_ = 0u;
                            }
                            let _e293 = phi_1253_;
                            let _e294 = (_e267 - _e293);
                            let _e296 = local_8;
                            let _e298 = global_5[_e296];
                            let _e299 = (_e294 / _e298);
                            let _e301 = local_9;
                            let _e303 = global_6[_e301];
                            let _e306 = global_5[_e296];
                            let _e309 = global_6[_e301];
                            let _e316 = local_10;
                            let _e318 = global_7[_e316];
                            phi_1256_ = ((((_e309 >> bitcast<u32>(16u)) + _e299) * (((vec2<u32>(_e190) + _e192) - vec2<u32>(1u, 1u)) / _e192).x) + (((_e303 & 65535u) + _e294) - (_e299 * _e306)));
                            phi_1255_ = _e318;
                            break;
                        }
                    }
                    let _e320 = phi_1256_;
                    let _e322 = phi_1255_;
                    let _e324 = global_9.member_13;
                    let _e326 = ((_e324 + _e203) + _e210);
                    global_8.member[_e326] = _e266;
                    global_8.member[(_e326 + 1u)] = _e322;
                    global_10.member[((_e203 + _e210) / 2u)] = (_e264 | (_e320 << bitcast<u32>(16u)));
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_1241_ = (_e210 + 256u);
                }
            }
            break;
        }
    }
    return;
}
