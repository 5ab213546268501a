struct type_11 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_15 {
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
    member_56: array<type_11, 8>,
    member_57: array<vec4<f32>, 128>,
    member_58: array<vec4<f32>, 768>,
}

struct type_19 {
    member: array<u32>,
}

struct type_20 {
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

struct type_24 {
    member: array<atomic<u32>>,
}

struct type_26 {
    member: array<atomic<u32>, LENGTH_6_4>,
}

struct type_28 {
    member: array<u32, LENGTH_1_4>,
}

@group(0) @binding(0) 
var<uniform> global: type_15;
@group(0) @binding(6) 
var<storage, read_write> global_1: type_26;
@group(0) @binding(7) 
var<uniform> global_2: type_20;
@group(0) @binding(1) 
var<storage, read_write> global_3: type_28;
var<workgroup> global_4: array<u32, 64>;

@compute @workgroup_size(64, 1, 1) 
fn main(@builtin(local_invocation_id) param: vec3<u32>, @builtin(global_invocation_id) param_1: vec3<u32>) {
    var phi_2394_: f32;
    var phi_2395_: f32;
    var phi_2401_: f32;
    var phi_2397_: vec2<f32>;
    var phi_2396_: bool;
    var phi_2403_: bool;
    var phi_1373_: bool;
    var phi_1903_: bool;
    var phi_1909_: bool;
    var phi_2408_: f32;
    var phi_2407_: u32;
    var local: f32;
    var phi_1982_: bool;
    var phi_2417_: vec2<f32>;
    var phi_2418_: vec2<f32>;
    var phi_2421_: u32;
    var phi_2422_: u32;
    var phi_2423_: u32;

    let _e65 = bitcast<u32>(param_1[0u]);
    let _e67 = global.member_44;
    let _e68 = (_e65 < _e67);
    if _e68 {
        switch bitcast<i32>(0u) {
            default: {
                let _e71 = global.member_38;
                let _e73 = (_e71 + (3u * _e65));
                let _e76 = global_3.member[_e73];
                let _e80 = global_3.member[(_e73 + 1u)];
                let _e84 = global_3.member[(_e73 + 2u)];
                let _e102 = global.member_51;
                let _e105 = global.member_52;
                let _e108 = (vec3<f32>(((vec3<u32>((_e76 & 65535u), (_e76 >> bitcast<u32>(16u)), (_e80 & 65535u)) << bitcast<vec3<u32>>(vec3<u32>(8u, 8u, 8u))) | (vec3<u32>(_e84, (_e84 >> bitcast<u32>(8u)), (_e84 >> bitcast<u32>(16u))) & vec3<u32>(255u, 255u, 255u)))) * vec3<f32>(0.00000005960465f, 0.00000005960465f, 0.00000005960465f));
                let _e122 = (_e102.xyz + (_e105.xyz * select(select(((_e108 - vec3<f32>(0.015625f, 0.015625f, 0.015625f)) * vec3<f32>(1.032258f, 1.032258f, 1.032258f)), (vec3<f32>(1f, 1f, 1f) - (vec3<f32>(0.015625f, 0.015625f, 0.015625f) / max(_e108, vec3<f32>(0.000000029802326f, 0.000000029802326f, 0.000000029802326f)))), (_e108 < vec3<f32>(0.015625f, 0.015625f, 0.015625f))), (vec3<f32>(0.015625f, 0.015625f, 0.015625f) / max((vec3<f32>(1f, 1f, 1f) - _e108), vec3<f32>(0.000000029802326f, 0.000000029802326f, 0.000000029802326f))), (_e108 > vec3<f32>(0.984375f, 0.984375f, 0.984375f)))));
                let _e126 = vec4<f32>(_e122.x, _e122.y, _e122.z, 1f);
                let _e129 = global.member_53[0i];
                let _e133 = global.member_53[1i];
                let _e137 = global.member_53[2i];
                let _e138 = dot(_e137, _e126);
                let _e139 = vec3<f32>(dot(_e129, _e126), dot(_e133, _e126), _e138);
                let _e149 = vec3<f32>(_e129.x, _e129.y, _e129.z);
                let _e150 = vec3<f32>(_e133.x, _e133.y, _e133.z);
                let _e151 = vec3<f32>(_e137.x, _e137.y, _e137.z);
                switch bitcast<i32>(0u) {
                    default: {
                        let _e154 = global.member_6;
                        if !((_e138 >= _e154)) {
                            let _e158 = global_2.member_8;
                            if (_e158 != 0u) {
                                let _e162 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_2401_ = 0f;
                            phi_2397_ = vec2<f32>(0f, 0f);
                            phi_2396_ = false;
                            break;
                        }
                        let _e164 = global.member;
                        let _e170 = global.member_1;
                        let _e173 = global.member_7;
                        let _e176 = global.member_8;
                        let _e177 = ((_e173 - _e138) * _e176);
                        if (_e177 < 0f) {
                            phi_2395_ = (0.015625f / (1f - _e177));
                        } else {
                            if (_e177 > 1f) {
                                phi_2394_ = (1f - (0.015625f / _e177));
                            } else {
                                phi_2394_ = (0.015625f + (0.96875f * clamp(_e177, 0f, 1f)));
                            }
                            let _e186 = phi_2394_;
                            phi_2395_ = _e186;
                        }
                        let _e190 = phi_2395_;
                        phi_2401_ = _e190;
                        phi_2397_ = (((_e164 * _e139.xy) / vec2(_e138)) + _e170);
                        phi_2396_ = true;
                        break;
                    }
                }
                let _e192 = phi_2401_;
                let _e194 = phi_2397_;
                let _e196 = phi_2396_;
                let _e197 = !(_e196);
                phi_1373_ = _e197;
                if !(_e197) {
                    let _e200 = global.member_39;
                    switch bitcast<i32>(0u) {
                        default: {
                            let _e212 = global.member_50;
                            let _e217 = max((_e212.xy - _e194), (_e194 - _e212.zw));
                            if !((max(_e217.x, _e217.y) > 0f)) {
                                phi_2403_ = false;
                                break;
                            }
                            let _e231 = global.member_2;
                            let _e234 = global.member_3;
                            let _e238 = global.member;
                            let _e246 = global.member_47;
                            let _e251 = global.member_29;
                            let _e258 = global.member_45;
                            let _e263 = global.member_49;
                            let _e268 = any((_e217 > ((((((abs(_e238) / vec2(_e138)) * (vec2<f32>(1f, 1f) + max(abs(_e231), abs(_e234)))) * (sqrt(max(max(dot(_e149, _e149), dot(_e150, _e150)), dot(_e151, _e151))) * (1.7320508f * (_e200 * exp2(((f32(((_e80 >> bitcast<u32>(16u)) & 255u)) * 0.125f) - 19f)))))) + vec2(sqrt(_e246))) * (sqrt((2f * log(max((255f / _e251), 1f)))) * sqrt(_e258))) * (1.01f * max(_e263, 0f)))));
                            if _e268 {
                                let _e270 = global_2.member_8;
                                if (_e270 != 0u) {
                                    let _e274 = atomicAdd((&global_1.member[0u]), 1u);
                                }
                            }
                            phi_2403_ = _e268;
                            break;
                        }
                    }
                    let _e276 = phi_2403_;
                    phi_1373_ = _e276;
                }
                let _e278 = phi_1373_;
                if _e278 {
                    phi_2422_ = 4294967295u;
                    break;
                }
                let _e279 = f32((_e80 >> bitcast<u32>(24u)));
                let _e281 = global.member_29;
                if (_e279 <= _e281) {
                    let _e284 = global_2.member_8;
                    if (_e284 != 0u) {
                        let _e288 = atomicAdd((&global_1.member[1u]), 1u);
                    }
                    phi_2422_ = 4294967295u;
                    break;
                }
                let _e291 = (_e71 + (3u * (_e67 + _e65)));
                let _e294 = global_3.member[_e291];
                let _e298 = global_3.member[(_e291 + 1u)];
                let _e302 = global_3.member[(_e291 + 2u)];
                let _e303 = vec3<u32>(_e294, _e298, _e302);
                let _e305 = global.member_39;
                let _e314 = ((_e305 * exp2(((f32(((_e80 >> bitcast<u32>(16u)) & 255u)) * 0.125f) - 19f))) * 0.0009775171f);
                let _e318 = ((vec3<f32>((_e303 & vec3<u32>(2047u, 2047u, 2047u))) - vec3<f32>(1023f, 1023f, 1023f)) * _e314);
                let _e324 = ((vec3<f32>(((_e303 >> bitcast<vec3<u32>>(vec3<u32>(11u, 11u, 11u))) & vec3<u32>(2047u, 2047u, 2047u))) - vec3<f32>(1023f, 1023f, 1023f)) * _e314);
                let _e334 = mat3x3<f32>(vec3<f32>(_e318.x, _e324.x, _e324.y), vec3<f32>(0f, _e318.y, _e318.z), vec3<f32>(0f, 0f, _e324.z));
                switch bitcast<i32>(0u) {
                    default: {
                        let _e344 = global.member_2;
                        let _e346 = global.member_3;
                        let _e347 = clamp((_e139.xy / vec2(_e138)), _e344, _e346);
                        let _e350 = global.member[0u];
                        let _e356 = (((_e149 - (_e151 * _e347.x)) * (_e350 / _e138)) * _e334);
                        let _e359 = global.member[1u];
                        let _e365 = (((_e150 - (_e151 * _e347.y)) * (_e359 / _e138)) * _e334);
                        let _e367 = global.member_47;
                        let _e369 = (dot(_e356, _e356) + _e367);
                        let _e372 = (dot(_e365, _e365) + _e367);
                        let _e374 = cross(_e356, _e365);
                        let _e375 = dot(_e374, _e374);
                        let _e379 = (_e375 + (_e367 * ((_e369 + _e372) - _e367)));
                        let _e380 = (_e379 > 0f);
                        phi_1903_ = _e380;
                        if _e380 {
                            phi_1903_ = (_e369 <= 1000000000000000000f);
                        }
                        let _e383 = phi_1903_;
                        phi_1909_ = _e383;
                        if _e383 {
                            phi_1909_ = (_e372 <= 1000000000000000000f);
                        }
                        let _e386 = phi_1909_;
                        if !(_e386) {
                            let _e389 = global_2.member_8;
                            if (_e389 != 0u) {
                                let _e393 = atomicAdd((&global_1.member[2u]), 1u);
                            }
                            phi_2421_ = 4294967295u;
                            break;
                        }
                        phi_2408_ = (1f - (_e279 * 0.003921569f));
                        phi_2407_ = 0u;
                        loop {
                            let _e397 = phi_2408_;
                            let _e399 = phi_2407_;
                            local = _e397;
                            if (_e399 < 3u) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e403 = global.member_43;
                                phi_2408_ = select(_e397, (_e397 * _e397), (_e399 < _e403));
                                phi_2407_ = (_e399 + bitcast<u32>(1i));
                            }
                        }
                        let _e409 = local;
                        let _e417 = global.member_48;
                        let _e424 = u32(round((f32(u32(round((255f * (1f - _e409))))) * ((1f - _e417) + (_e417 * sqrt((_e375 / _e379)))))));
                        let _e425 = f32(_e424);
                        if (_e425 <= _e281) {
                            let _e428 = global_2.member_8;
                            if (_e428 != 0u) {
                                let _e432 = atomicAdd((&global_1.member[1u]), 1u);
                            }
                            phi_2421_ = 4294967295u;
                            break;
                        }
                        let _e434 = global.member_45;
                        let _e435 = (vec3<f32>(_e369, dot(_e356, _e365), _e372) * _e434);
                        let _e447 = global.member_49;
                        let _e448 = ((sqrt(_e435.xz) * sqrt((2f * log(max((_e425 / _e281), 1f))))) * _e447);
                        let _e451 = global.member_50;
                        let _e454 = all(((_e194 + _e448) > _e451.xy));
                        phi_1982_ = _e454;
                        if _e454 {
                            phi_1982_ = all(((_e194 - _e448) < _e451.zw));
                        }
                        let _e460 = phi_1982_;
                        if !(_e460) {
                            let _e463 = global_2.member_8;
                            if (_e463 != 0u) {
                                let _e467 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_2421_ = 4294967295u;
                            break;
                        }
                        let _e472 = (0.5f * (_e435.x - _e435.z));
                        let _e477 = sqrt(((_e472 * _e472) + (_e435.y * _e435.y)));
                        let _e480 = ((0.5f * (_e435.x + _e435.z)) + _e477);
                        if (_e472 >= 0f) {
                            phi_2417_ = vec2<f32>((_e472 + _e477), _e435.y);
                        } else {
                            phi_2417_ = vec2<f32>(_e435.y, (_e477 - _e472));
                        }
                        let _e487 = phi_2417_;
                        if (_e477 > (0.00000001f * _e480)) {
                            phi_2418_ = normalize(_e487);
                        } else {
                            phi_2418_ = vec2<f32>(1f, 0f);
                        }
                        let _e492 = phi_2418_;
                        let _e500 = max(-(_e194), (_e194 * 0.5f));
                        let _e505 = global.member_5;
                        let _e506 = (max(_e500.x, _e500.y) / _e505);
                        let _e514 = ((select(0u, 1u, (_e506 > 1f)) + select(0u, 1u, (_e506 > 64f))) + select(0u, 1u, (_e506 > 4096f)));
                        let _e523 = global.member_10;
                        let _e527 = vec2<u32>(clamp(round((((_e194 * exp2(-(f32((_e514 * 6u))))) + vec2(_e505)) * _e523)), vec2<f32>(0f, 0f), vec2<f32>(1048575f, 1048575f)));
                        let _e530 = vec3<u32>(round((clamp((vec3<f32>((_e303 >> bitcast<vec3<u32>>(vec3<u32>(22u, 22u, 22u)))) * vec3<f32>(0.0009775171f, 0.0009775171f, 0.0009775171f)), vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 1023f)));
                        let _e561 = global.member_41;
                        let _e563 = (4u * (_e561 + _e65));
                        global_3.member[_e563] = ((_e527.x | (_e530.x << bitcast<u32>(20u))) | (_e530.z << bitcast<u32>(30u)));
                        global_3.member[(_e563 + 1u)] = ((_e527.y | (_e530.y << bitcast<u32>(20u))) | (_e514 << bitcast<u32>(30u)));
                        global_3.member[(_e563 + 2u)] = pack2x16float((_e492 * min(sqrt(_e480), 65504f)));
                        global_3.member[(_e563 + 3u)] = ((pack2x16float(vec2<f32>(min(sqrt(((_e379 * (_e434 * _e434)) / _e480)), 65504f), 0f)) | (_e424 << bitcast<u32>(16u))) | ((_e530.z >> bitcast<u32>(2u)) << bitcast<u32>(24u)));
                        let _e576 = global.member_9;
                        phi_2421_ = min(u32((_e192 * f32(_e576))), _e576);
                        break;
                    }
                }
                let _e582 = phi_2421_;
                phi_2422_ = _e582;
                break;
            }
        }
        let _e584 = phi_2422_;
        phi_2423_ = _e584;
    } else {
        phi_2423_ = 4294967295u;
    }
    let _e586 = phi_2423_;
    let _e588 = bitcast<u32>(param[0u]);
    let _e590 = global.member_41;
    let _e591 = (_e590 + _e65);
    if (_e586 != 4294967295u) {
        let _e594 = global.member_37;
        let _e598 = global.member_36;
        let _e604 = atomicAdd((&global_1.member[((_e598 + ((_e591 / _e594) * 256u)) + (_e586 & 255u))]), 1u);
    }
    global_4[_e588] = _e586;
    workgroupBarrier();
    let _e607 = ((_e588 & 1u) == 0u);
    if select(_e607, _e68, _e607) {
        let _e610 = global.member_28;
        let _e617 = global_4[(_e588 + 1u)];
        global_3.member[(_e610 + (_e591 >> bitcast<u32>(1u)))] = ((_e586 & 65535u) | (_e617 << bitcast<u32>(16u)));
    }
    return;
}
