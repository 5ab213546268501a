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
    member_32: vec2<f32>,
    member_33: vec2<f32>,
    member_34: f32,
    member_35: u32,
    member_36: f32,
    member_37: f32,
    member_38: u32,
    member_39: u32,
    member_40: u32,
    member_41: u32,
    member_42: u32,
    member_43: f32,
    member_44: u32,
    member_45: u32,
    member_46: f32,
    member_47: u32,
    member_48: u32,
    member_49: f32,
    member_50: u32,
    member_51: f32,
    member_52: f32,
    member_53: f32,
    member_54: vec4<f32>,
    member_55: vec4<f32>,
    member_56: vec4<f32>,
    member_57: array<vec4<f32>, 3>,
    member_58: array<vec4<u32>, 8>,
    member_59: array<vec4<u32>, 8>,
    member_60: array<type_11, 8>,
    member_61: array<vec4<f32>, 128>,
    member_62: array<vec4<f32>, 768>,
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
    member_15: f32,
}

struct type_22 {
    member: array<vec2<u32>>,
}

struct type_26 {
    member: array<atomic<u32>>,
}

struct type_28 {
    member: array<atomic<u32>, LENGTH_6_4>,
}

struct type_30 {
    member: array<vec2<u32>, LENGTH_1_8>,
}

struct type_32 {
    member: array<u32, LENGTH_2_4>,
}

@group(0) @binding(0) 
var<uniform> global: type_15;
@group(0) @binding(6) 
var<storage, read_write> global_1: type_28;
@group(0) @binding(7) 
var<uniform> global_2: type_20;
@group(0) @binding(1) 
var<storage> global_3: type_30;
@group(0) @binding(2) 
var<storage, read_write> global_4: type_32;
var<workgroup> global_5: array<u32, 64>;

@compute @workgroup_size(64, 1, 1) 
fn main(@builtin(local_invocation_id) param: vec3<u32>, @builtin(global_invocation_id) param_1: vec3<u32>) {
    var phi_1700_: bool;
    var phi_2706_: f32;
    var phi_2707_: f32;
    var phi_2711_: u32;
    var phi_2717_: u32;
    var phi_2716_: f32;
    var phi_2714_: u32;
    var local: f32;
    var phi_2721_: bool;
    var phi_1749_: bool;
    var phi_2732_: f32;
    var phi_2723_: vec2<f32>;
    var phi_2722_: bool;
    var phi_2228_: bool;
    var phi_2234_: bool;
    var phi_2746_: f32;
    var phi_2745_: u32;
    var local_1: f32;
    var phi_2754_: u32;
    var phi_2312_: bool;
    var phi_2758_: vec2<f32>;
    var phi_2759_: vec2<f32>;
    var phi_2760_: u32;
    var phi_2761_: u32;
    var phi_2762_: u32;

    let _e67 = bitcast<u32>(param_1[0u]);
    let _e69 = global.member_48;
    let _e70 = (_e67 < _e69);
    if _e70 {
        switch bitcast<i32>(0u) {
            default: {
                let _e73 = global.member_42;
                let _e75 = (_e73 + (3u * _e67));
                let _e78 = global_4.member[_e75];
                let _e82 = global_4.member[(_e75 + 1u)];
                let _e86 = global_4.member[(_e75 + 2u)];
                let _e104 = global.member_55;
                let _e107 = global.member_56;
                let _e110 = (vec3<f32>(((vec3<u32>((_e78 & 65535u), (_e78 >> bitcast<u32>(16u)), (_e82 & 65535u)) << bitcast<vec3<u32>>(vec3<u32>(8u, 8u, 8u))) | (vec3<u32>(_e86, (_e86 >> bitcast<u32>(8u)), (_e86 >> bitcast<u32>(16u))) & vec3<u32>(255u, 255u, 255u)))) * vec3<f32>(0.00000005960465f, 0.00000005960465f, 0.00000005960465f));
                let _e124 = (_e104.xyz + (_e107.xyz * select(select(((_e110 - vec3<f32>(0.015625f, 0.015625f, 0.015625f)) * vec3<f32>(1.032258f, 1.032258f, 1.032258f)), (vec3<f32>(1f, 1f, 1f) - (vec3<f32>(0.015625f, 0.015625f, 0.015625f) / max(_e110, vec3<f32>(0.000000029802326f, 0.000000029802326f, 0.000000029802326f)))), (_e110 < vec3<f32>(0.015625f, 0.015625f, 0.015625f))), (vec3<f32>(0.015625f, 0.015625f, 0.015625f) / max((vec3<f32>(1f, 1f, 1f) - _e110), vec3<f32>(0.000000029802326f, 0.000000029802326f, 0.000000029802326f))), (_e110 > vec3<f32>(0.984375f, 0.984375f, 0.984375f)))));
                let _e128 = vec4<f32>(_e124.x, _e124.y, _e124.z, 1f);
                let _e131 = global.member_57[0i];
                let _e135 = global.member_57[1i];
                let _e139 = global.member_57[2i];
                let _e140 = dot(_e139, _e128);
                let _e141 = vec3<f32>(dot(_e131, _e128), dot(_e135, _e128), _e140);
                let _e143 = global.member_43;
                let _e151 = (_e143 * exp2(((f32(((_e82 >> bitcast<u32>(16u)) & 255u)) * 0.125f) - 19f)));
                switch bitcast<i32>(0u) {
                    default: {
                        let _e154 = global.member_6;
                        if !((_e140 >= _e154)) {
                            let _e158 = global_2.member_9;
                            if (_e158 != 0u) {
                                let _e162 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_2732_ = 0f;
                            phi_2723_ = vec2<f32>(0f, 0f);
                            phi_2722_ = false;
                            break;
                        }
                        let _e164 = global.member;
                        let _e165 = _e141.xy;
                        let _e167 = vec2(_e140);
                        let _e170 = global.member_1;
                        let _e171 = (((_e164 * _e165) / _e167) + _e170);
                        let _e173 = global.member_5;
                        let _e177 = all((_e171 >= vec2(-(_e173))));
                        phi_1700_ = _e177;
                        if _e177 {
                            let _e179 = global.member_4;
                            phi_1700_ = all((_e171 <= (_e179 + vec2(_e173))));
                        }
                        let _e185 = phi_1700_;
                        if !(_e185) {
                            let _e188 = global_2.member_9;
                            if (_e188 != 0u) {
                                let _e192 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_2732_ = 0f;
                            phi_2723_ = _e171;
                            phi_2722_ = false;
                            break;
                        }
                        let _e194 = global.member_7;
                        let _e197 = global.member_8;
                        let _e198 = ((_e194 - _e140) * _e197);
                        if (_e198 < 0f) {
                            phi_2707_ = (0.015625f / (1f - _e198));
                        } else {
                            if (_e198 > 1f) {
                                phi_2706_ = (1f - (0.015625f / _e198));
                            } else {
                                phi_2706_ = (0.015625f + (0.96875f * clamp(_e198, 0f, 1f)));
                            }
                            let _e209 = phi_2706_;
                            phi_2707_ = _e209;
                        }
                        let _e211 = phi_2707_;
                        let _e212 = (_e165 / _e167);
                        let _e220 = global.member[0u];
                        let _e223 = global.member[1u];
                        let _e228 = global.member_31;
                        let _e229 = (_e228 > 0u);
                        phi_1749_ = _e229;
                        if _e229 {
                            let _e231 = global.member_34;
                            let _e234 = global.member_29;
                            let _e241 = global.member_49;
                            let _e245 = global.member_51;
                            switch bitcast<i32>(0u) {
                                default: {
                                    let _e251 = vec2(((sqrt((2f * log(max((max(255f, _e231) / _e234), 1f)))) * sqrt(_e241)) * ((((_e151 * length(vec3<f32>(_e212.x, _e212.y, 1f))) * max(_e220, _e223)) / _e140) + sqrt(_e245))));
                                    let _e254 = global.member_32;
                                    let _e257 = global.member_33;
                                    let _e265 = vec2<u32>(clamp(((((_e171 - _e251) - _e254) * _e257) - vec2<f32>(0.5f, 0.5f)), vec2<f32>(0f, 0f), vec2<f32>(191f, 191f)));
                                    let _e267 = vec2<u32>(clamp(((((_e171 + _e251) - _e254) * _e257) + vec2<f32>(0.5f, 0.5f)), vec2<f32>(0f, 0f), vec2<f32>(191f, 191f)));
                                    let _e274 = max((_e267.x - _e265.x), (_e267.y - _e265.y));
                                    if (_e274 <= 3u) {
                                        phi_2711_ = 0u;
                                    } else {
                                        phi_2711_ = (bitcast<u32>(firstLeadingBit((_e274 - 1u))) - 1u);
                                    }
                                    let _e281 = phi_2711_;
                                    if !((_e281 < 4u)) {
                                        phi_2721_ = false;
                                        break;
                                    }
                                    let _e291 = vec2(_e281);
                                    let _e293 = (_e265 >> bitcast<vec2<u32>>(_e291));
                                    let _e295 = (_e267 >> bitcast<vec2<u32>>(_e291));
                                    let _e297 = (_e293.x & 4294967292u);
                                    phi_2717_ = _e297;
                                    phi_2716_ = 0f;
                                    phi_2714_ = _e293.y;
                                    loop {
                                        let _e300 = phi_2717_;
                                        let _e302 = phi_2716_;
                                        let _e304 = phi_2714_;
                                        local = _e302;
                                        if (_e304 <= _e295.y) {
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e309 = (vec4(f32(_e300)) + vec4<f32>(0f, 1f, 2f, 3f));
                                            let _e327 = global_3.member[((_e228 >> bitcast<u32>(1u)) + ((((4u * (12288u - (12288u >> bitcast<u32>((2u * _e281))))) + (_e304 * (192u >> bitcast<u32>(_e281)))) + _e300) >> bitcast<u32>(2u)))];
                                            let _e329 = unpack2x16unorm(_e327.x);
                                            let _e331 = unpack2x16unorm(_e327.y);
                                            let _e338 = select(select(vec4<f32>(_e329.x, _e329.y, _e331.x, _e331.y), vec4<f32>(0f, 0f, 0f, 0f), (_e309 < vec4(f32(_e293.x)))), vec4<f32>(0f, 0f, 0f, 0f), (_e309 > vec4(f32(_e295.x))));
                                            let _e347 = (_e300 + 4u);
                                            let _e348 = (_e347 > _e295.x);
                                            phi_2717_ = select(_e347, _e297, _e348);
                                            phi_2716_ = max(_e302, max(max(_e338.x, _e338.y), max(_e338.z, _e338.w)));
                                            phi_2714_ = (_e304 + select(0u, 1u, _e348));
                                        }
                                    }
                                    let _e353 = local;
                                    phi_2721_ = ((1f - _e211) > _e353);
                                    break;
                                }
                            }
                            let _e356 = phi_2721_;
                            phi_1749_ = _e356;
                        }
                        let _e358 = phi_1749_;
                        if _e358 {
                            let _e360 = global_2.member_9;
                            if (_e360 != 0u) {
                                let _e364 = atomicAdd((&global_1.member[1u]), 1u);
                            }
                            phi_2732_ = _e211;
                            phi_2723_ = _e171;
                            phi_2722_ = false;
                            break;
                        }
                        phi_2732_ = _e211;
                        phi_2723_ = _e171;
                        phi_2722_ = true;
                        break;
                    }
                }
                let _e366 = phi_2732_;
                let _e368 = phi_2723_;
                let _e370 = phi_2722_;
                if !(_e370) {
                    phi_2761_ = 4294967295u;
                    break;
                }
                let _e372 = f32((_e82 >> bitcast<u32>(24u)));
                let _e374 = global.member_29;
                if (_e372 <= _e374) {
                    let _e377 = global_2.member_9;
                    if (_e377 != 0u) {
                        let _e381 = atomicAdd((&global_1.member[2u]), 1u);
                    }
                    phi_2761_ = 4294967295u;
                    break;
                }
                let _e384 = (_e73 + (3u * (_e69 + _e67)));
                let _e387 = global_4.member[_e384];
                let _e391 = global_4.member[(_e384 + 1u)];
                let _e395 = global_4.member[(_e384 + 2u)];
                let _e396 = vec3<u32>(_e387, _e391, _e395);
                let _e408 = vec3<f32>(_e139.x, _e139.y, _e139.z);
                let _e409 = (_e151 * 0.0009775171f);
                let _e413 = ((vec3<f32>((_e396 & vec3<u32>(2047u, 2047u, 2047u))) - vec3<f32>(1023f, 1023f, 1023f)) * _e409);
                let _e419 = ((vec3<f32>(((_e396 >> bitcast<vec3<u32>>(vec3<u32>(11u, 11u, 11u))) & vec3<u32>(2047u, 2047u, 2047u))) - vec3<f32>(1023f, 1023f, 1023f)) * _e409);
                let _e429 = mat3x3<f32>(vec3<f32>(_e413.x, _e419.x, _e419.y), vec3<f32>(0f, _e413.y, _e413.z), vec3<f32>(0f, 0f, _e419.z));
                switch bitcast<i32>(0u) {
                    default: {
                        let _e439 = global.member_2;
                        let _e441 = global.member_3;
                        let _e442 = clamp((_e141.xy / vec2(_e140)), _e439, _e441);
                        let _e445 = global.member[0u];
                        let _e451 = (((vec3<f32>(_e131.x, _e131.y, _e131.z) - (_e408 * _e442.x)) * (_e445 / _e140)) * _e429);
                        let _e454 = global.member[1u];
                        let _e460 = (((vec3<f32>(_e135.x, _e135.y, _e135.z) - (_e408 * _e442.y)) * (_e454 / _e140)) * _e429);
                        let _e462 = global.member_51;
                        let _e464 = (dot(_e451, _e451) + _e462);
                        let _e467 = (dot(_e460, _e460) + _e462);
                        let _e469 = cross(_e451, _e460);
                        let _e470 = dot(_e469, _e469);
                        let _e474 = (_e470 + (_e462 * ((_e464 + _e467) - _e462)));
                        let _e475 = (_e474 > 0f);
                        phi_2228_ = _e475;
                        if _e475 {
                            phi_2228_ = (_e464 <= 1000000000000000000f);
                        }
                        let _e478 = phi_2228_;
                        phi_2234_ = _e478;
                        if _e478 {
                            phi_2234_ = (_e467 <= 1000000000000000000f);
                        }
                        let _e481 = phi_2234_;
                        if !(_e481) {
                            let _e484 = global_2.member_9;
                            if (_e484 != 0u) {
                                let _e488 = atomicAdd((&global_1.member[3u]), 1u);
                            }
                            phi_2760_ = 4294967295u;
                            break;
                        }
                        phi_2746_ = (1f - (_e372 * 0.003921569f));
                        phi_2745_ = 0u;
                        loop {
                            let _e492 = phi_2746_;
                            let _e494 = phi_2745_;
                            let _e496 = global.member_47;
                            local_1 = _e492;
                            if (_e494 < _e496) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                phi_2746_ = (_e492 * _e492);
                                phi_2745_ = (_e494 + bitcast<u32>(1i));
                            }
                        }
                        let _e502 = local_1;
                        let _e506 = u32(round((255f * (1f - _e502))));
                        let _e508 = global.member_52;
                        phi_2754_ = _e506;
                        if (_e508 > 0f) {
                            let _e518 = u32(round((f32(_e506) * ((1f - _e508) + (_e508 * sqrt((_e470 / _e474)))))));
                            if (f32(_e518) <= _e374) {
                                let _e522 = global_2.member_9;
                                if (_e522 != 0u) {
                                    let _e526 = atomicAdd((&global_1.member[2u]), 1u);
                                }
                                phi_2760_ = 4294967295u;
                                break;
                            }
                            phi_2754_ = _e518;
                        }
                        let _e528 = phi_2754_;
                        let _e530 = global.member_49;
                        let _e531 = (vec3<f32>(_e464, dot(_e451, _e460), _e467) * _e530);
                        let _e544 = global.member_53;
                        let _e545 = ((sqrt(_e531.xz) * sqrt((2f * log(max((f32(_e528) / _e374), 1f))))) * _e544);
                        let _e548 = global.member_54;
                        let _e551 = all(((_e368 + _e545) > _e548.xy));
                        phi_2312_ = _e551;
                        if _e551 {
                            phi_2312_ = all(((_e368 - _e545) < _e548.zw));
                        }
                        let _e557 = phi_2312_;
                        if !(_e557) {
                            let _e560 = global_2.member_9;
                            if (_e560 != 0u) {
                                let _e564 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_2760_ = 4294967295u;
                            break;
                        }
                        let _e569 = (0.5f * (_e531.x - _e531.z));
                        let _e574 = sqrt(((_e569 * _e569) + (_e531.y * _e531.y)));
                        let _e577 = ((0.5f * (_e531.x + _e531.z)) + _e574);
                        if (_e569 >= 0f) {
                            phi_2758_ = vec2<f32>((_e569 + _e574), _e531.y);
                        } else {
                            phi_2758_ = vec2<f32>(_e531.y, (_e574 - _e569));
                        }
                        let _e584 = phi_2758_;
                        if (_e574 > (0.00000001f * _e577)) {
                            phi_2759_ = normalize(_e584);
                        } else {
                            phi_2759_ = vec2<f32>(1f, 0f);
                        }
                        let _e589 = phi_2759_;
                        let _e596 = global.member_5;
                        let _e600 = global.member_10;
                        let _e604 = vec2<u32>(clamp(round(((_e368 + vec2(_e596)) * _e600)), vec2<f32>(0f, 0f), vec2<f32>(1048575f, 1048575f)));
                        let _e607 = vec3<u32>(round((clamp((vec3<f32>((_e396 >> bitcast<vec3<u32>>(vec3<u32>(22u, 22u, 22u)))) * vec3<f32>(0.0009775171f, 0.0009775171f, 0.0009775171f)), vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 1023f)));
                        let _e635 = global.member_45;
                        let _e637 = (4u * (_e635 + _e67));
                        global_4.member[_e637] = ((_e604.x | (_e607.x << bitcast<u32>(20u))) | (_e607.z << bitcast<u32>(30u)));
                        global_4.member[(_e637 + 1u)] = (_e604.y | (_e607.y << bitcast<u32>(20u)));
                        global_4.member[(_e637 + 2u)] = pack2x16float((_e589 * min(sqrt(_e577), 65504f)));
                        global_4.member[(_e637 + 3u)] = ((pack2x16float(vec2<f32>(min(sqrt(((_e474 * (_e530 * _e530)) / _e577)), 65504f), 0f)) | (_e528 << bitcast<u32>(16u))) | ((_e607.z >> bitcast<u32>(2u)) << bitcast<u32>(24u)));
                        let _e650 = global.member_9;
                        phi_2760_ = min(u32((_e366 * f32(_e650))), _e650);
                        break;
                    }
                }
                let _e656 = phi_2760_;
                phi_2761_ = _e656;
                break;
            }
        }
        let _e658 = phi_2761_;
        phi_2762_ = _e658;
    } else {
        phi_2762_ = 4294967295u;
    }
    let _e660 = phi_2762_;
    switch bitcast<i32>(0u) {
        default: {
            let _e663 = bitcast<u32>(param[0u]);
            let _e665 = global.member_45;
            let _e666 = (_e665 + _e67);
            if (_e660 != 4294967295u) {
                let _e669 = global.member_41;
                let _e673 = global.member_40;
                let _e679 = atomicAdd((&global_1.member[((_e673 + ((_e666 / _e669) * 256u)) + (_e660 & 255u))]), 1u);
            }
            let _e681 = global.member_39;
            if (_e681 == 0u) {
                if (_e67 < (_e69 + (_e69 & 1u))) {
                    let _e687 = global.member_28;
                    global_4.member[(_e687 + _e666)] = _e660;
                }
                break;
            }
            global_5[_e663] = _e660;
            workgroupBarrier();
            let _e693 = ((_e663 & 1u) == 0u);
            if select(_e693, _e70, _e693) {
                let _e696 = global.member_28;
                let _e703 = global_5[(_e663 + 1u)];
                global_4.member[(_e696 + (_e666 >> bitcast<u32>(1u)))] = ((_e660 & 65535u) | (_e703 << bitcast<u32>(16u)));
            }
            break;
        }
    }
    return;
}
