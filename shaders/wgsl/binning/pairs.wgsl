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

struct type_21 {
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
@group(0) @binding(7) 
var<uniform> global_4: type_21;
var<workgroup> global_5: array<u32, 256>;
var<workgroup> global_6: array<u32, 256>;
var<workgroup> global_7: array<u32, 256>;
var<workgroup> global_8: array<u32, 256>;
@group(0) @binding(4) 
var<storage, read_write> global_9: type_30;
@group(0) @binding(5) 
var<storage, read_write> global_10: type_32;

@compute @workgroup_size(128, 1, 1) 
fn main(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>) {
    var local: array<u32, 2>;
    var phi_1248_: u32;
    var phi_810_: bool;
    var phi_1275_: u32;
    var phi_1279_: u32;
    var phi_1249_: u32;
    var phi_1269_: u32;
    var phi_1273_: u32;
    var phi_1270_: u32;
    var phi_1250_: u32;
    var phi_1252_: u32;
    var phi_1251_: u32;
    var local_1: u32;
    var local_2: u32;
    var phi_1253_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1256_: u32;
    var phi_1255_: u32;
    var phi_1261_: u32;
    var phi_1260_: u32;
    var local_6: u32;
    var local_7: u32;
    var phi_1262_: u32;
    var local_8: u32;
    var local_9: u32;
    var local_10: u32;
    var phi_1265_: u32;
    var phi_1264_: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e33 = bitcast<u32>(param[0u]);
            let _e35 = bitcast<u32>(param_1[0u]);
            let _e36 = (_e35 * 256u);
            let _e39 = global_2.member.member_6;
            if (_e36 >= _e39) {
                break;
            }
            let _e43 = global_9.member[8i];
            phi_1248_ = _e33;
            loop {
                let _e45 = phi_1248_;
                if (_e45 < 256u) {
                    let _e47 = (_e36 + _e45);
                    global_6[_e45] = 1u;
                    phi_1279_ = 0u;
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
                        let _e100 = global_4.member_15;
                        let _e102 = ((sqrt(((_e70 * _e70) + ((_e93 * (_e90 * _e90)) * _e93))) * sqrt((2f * log(max((max(f32(((_e57.w >> bitcast<u32>(16u)) & 255u)), _e79) / _e82), 1f))))) + vec2(_e100));
                        let _e103 = (_e68 - _e102);
                        let _e104 = (_e68 + _e102);
                        let _e106 = global.member_46;
                        let _e108 = global.member_4;
                        let _e110 = vec2(_e106);
                        let _e115 = vec2<f32>(((((vec2<u32>(_e108) + _e110) - vec2<u32>(1u, 1u)) / _e110) - vec2<u32>(1u, 1u)));
                        let _e117 = vec2(f32(_e106));
                        let _e123 = vec2<u32>(clamp((_e104 / _e117), vec2<f32>(0f, 0f), _e115));
                        let _e125 = all((_e103 < _e108));
                        phi_810_ = _e125;
                        if _e125 {
                            phi_810_ = all((_e104 > vec2<f32>(0f, 0f)));
                        }
                        let _e129 = phi_810_;
                        let _e131 = vec2(_e43);
                        let _e135 = (vec2<u32>(clamp((_e103 / _e117), vec2<f32>(0f, 0f), _e115)) >> bitcast<vec2<u32>>(_e131));
                        let _e137 = (((_e123 >> bitcast<vec2<u32>>(_e131)) - _e135) + vec2<u32>(1u, 1u));
                        if !(_e129) {
                            phi_1275_ = 0u;
                        } else {
                            phi_1275_ = (_e137.x * _e137.y);
                        }
                        let _e142 = phi_1275_;
                        global_8[_e45] = _e54;
                        global_7[_e45] = (_e135.x | (_e135.y << bitcast<u32>(16u)));
                        global_6[_e45] = (((_e123.x >> bitcast<u32>(_e43)) - _e135.x) + 1u);
                        phi_1279_ = _e142;
                    }
                    let _e156 = phi_1279_;
                    global_5[_e45] = _e156;
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_1248_ = (_e45 + 128u);
                }
            }
            workgroupBarrier();
            phi_1249_ = 1u;
            loop {
                let _e160 = phi_1249_;
                if (_e160 < 256u) {
                    phi_1269_ = 0u;
                    loop {
                        let _e163 = phi_1269_;
                        if (_e163 < 2u) {
                            let _e166 = ((_e163 * 128u) + _e33);
                            if (_e166 >= _e160) {
                                let _e170 = global_5[(_e166 - _e160)];
                                phi_1273_ = _e170;
                            } else {
                                phi_1273_ = 0u;
                            }
                            let _e172 = phi_1273_;
                            local[_e163] = _e172;
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            phi_1269_ = (_e163 + bitcast<u32>(1i));
                        }
                    }
                    workgroupBarrier();
                    phi_1270_ = 0u;
                    loop {
                        let _e177 = phi_1270_;
                        if (_e177 < 2u) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e182 = local[_e177];
                            let _e184 = global_5[((_e177 * 128u) + _e33)];
                            global_5[((_e177 * 128u) + _e33)] = (_e184 + _e182);
                            phi_1270_ = (_e177 + bitcast<u32>(1i));
                        }
                    }
                    workgroupBarrier();
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_1249_ = (_e160 * 2u);
                }
            }
            let _e190 = global.member_46;
            let _e194 = global.member_4;
            let _e196 = vec2((_e190 << bitcast<u32>(_e43)));
            let _e202 = global_4.member_11;
            let _e207 = global_9.member[(_e202 + (_e35 * 10u))];
            let _e209 = global_5[255i];
            phi_1250_ = (2u * _e33);
            loop {
                let _e214 = phi_1250_;
                if (_e214 < (_e209 + (_e209 & 1u))) {
                    switch bitcast<i32>(0u) {
                        default: {
                            let _e217 = global_5[255i];
                            if (_e214 >= _e217) {
                                phi_1256_ = 65535u;
                                phi_1255_ = 0u;
                                break;
                            }
                            phi_1252_ = 0u;
                            phi_1251_ = 128u;
                            loop {
                                let _e220 = phi_1252_;
                                let _e222 = phi_1251_;
                                local_1 = _e220;
                                local_2 = _e220;
                                local_3 = _e220;
                                local_4 = _e220;
                                local_5 = _e220;
                                if (_e222 > 0u) {
                                    continue;
                                } else {
                                    break;
                                }
                                continuing {
                                    let _e227 = global_5[((_e220 + _e222) - 1u)];
                                    phi_1252_ = (_e220 + select(0u, _e222, (_e227 <= _e214)));
                                    phi_1251_ = (_e222 / 2u);
                                }
                            }
                            let _e233 = local_1;
                            if (_e233 > 0u) {
                                let _e236 = local_2;
                                let _e239 = global_5[(_e236 - 1u)];
                                phi_1253_ = _e239;
                            } else {
                                phi_1253_ = 0u;
                            }
                            let _e241 = phi_1253_;
                            let _e242 = (_e214 - _e241);
                            let _e244 = local_3;
                            let _e246 = global_6[_e244];
                            let _e247 = (_e242 / _e246);
                            let _e249 = local_4;
                            let _e251 = global_7[_e249];
                            let _e254 = global_6[_e244];
                            let _e257 = global_7[_e249];
                            let _e264 = local_5;
                            let _e266 = global_8[_e264];
                            phi_1256_ = ((((_e257 >> bitcast<u32>(16u)) + _e247) * (((vec2<u32>(_e194) + _e196) - vec2<u32>(1u, 1u)) / _e196).x) + (((_e251 & 65535u) + _e242) - (_e247 * _e254)));
                            phi_1255_ = _e266;
                            break;
                        }
                    }
                    let _e268 = phi_1256_;
                    let _e270 = phi_1255_;
                    let _e271 = (_e214 + 1u);
                    switch bitcast<i32>(0u) {
                        default: {
                            let _e273 = global_5[255i];
                            if (_e271 >= _e273) {
                                phi_1265_ = 65535u;
                                phi_1264_ = 0u;
                                break;
                            }
                            phi_1261_ = 0u;
                            phi_1260_ = 128u;
                            loop {
                                let _e276 = phi_1261_;
                                let _e278 = phi_1260_;
                                local_6 = _e276;
                                local_7 = _e276;
                                local_8 = _e276;
                                local_9 = _e276;
                                local_10 = _e276;
                                if (_e278 > 0u) {
                                    continue;
                                } else {
                                    break;
                                }
                                continuing {
                                    let _e283 = global_5[((_e276 + _e278) - 1u)];
                                    phi_1261_ = (_e276 + select(0u, _e278, (_e283 <= _e271)));
                                    phi_1260_ = (_e278 / 2u);
                                }
                            }
                            let _e289 = local_6;
                            if (_e289 > 0u) {
                                let _e292 = local_7;
                                let _e295 = global_5[(_e292 - 1u)];
                                phi_1262_ = _e295;
                            } else {
                                phi_1262_ = 0u;
                            }
                            let _e297 = phi_1262_;
                            let _e298 = (_e271 - _e297);
                            let _e300 = local_8;
                            let _e302 = global_6[_e300];
                            let _e303 = (_e298 / _e302);
                            let _e305 = local_9;
                            let _e307 = global_7[_e305];
                            let _e310 = global_6[_e300];
                            let _e313 = global_7[_e305];
                            let _e320 = local_10;
                            let _e322 = global_8[_e320];
                            phi_1265_ = ((((_e313 >> bitcast<u32>(16u)) + _e303) * (((vec2<u32>(_e194) + _e196) - vec2<u32>(1u, 1u)) / _e196).x) + (((_e307 & 65535u) + _e298) - (_e303 * _e310)));
                            phi_1264_ = _e322;
                            break;
                        }
                    }
                    let _e324 = phi_1265_;
                    let _e326 = phi_1264_;
                    let _e328 = global_4.member_13;
                    let _e330 = ((_e328 + _e207) + _e214);
                    global_9.member[_e330] = _e270;
                    global_9.member[(_e330 + 1u)] = _e326;
                    global_10.member[((_e207 + _e214) / 2u)] = (_e268 | (_e324 << bitcast<u32>(16u)));
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_1250_ = (_e214 + 256u);
                }
            }
            break;
        }
    }
    return;
}
