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
    var phi_1702_: bool;
    var phi_2711_: f32;
    var phi_2712_: f32;
    var phi_2716_: u32;
    var phi_2722_: u32;
    var phi_2721_: f32;
    var phi_2719_: u32;
    var local: f32;
    var phi_2726_: bool;
    var phi_1751_: bool;
    var phi_2737_: f32;
    var phi_2728_: vec2<f32>;
    var phi_2727_: bool;
    var phi_2230_: bool;
    var phi_2236_: bool;
    var phi_2751_: f32;
    var phi_2750_: u32;
    var local_1: f32;
    var phi_2759_: u32;
    var phi_2314_: bool;
    var phi_2763_: vec2<f32>;
    var phi_2764_: vec2<f32>;
    var phi_2765_: u32;
    var phi_2766_: u32;
    var phi_2767_: u32;

    let _e66 = bitcast<u32>(param_1[0u]);
    let _e68 = global.member_48;
    let _e69 = (_e66 < _e68);
    if _e69 {
        switch bitcast<i32>(0u) {
            default: {
                let _e72 = global.member_42;
                let _e74 = (_e72 + (3u * _e66));
                let _e77 = global_4.member[_e74];
                let _e81 = global_4.member[(_e74 + 1u)];
                let _e85 = global_4.member[(_e74 + 2u)];
                let _e103 = global.member_55;
                let _e106 = global.member_56;
                let _e109 = (vec3<f32>(((vec3<u32>((_e77 & 65535u), (_e77 >> bitcast<u32>(16u)), (_e81 & 65535u)) << bitcast<vec3<u32>>(vec3<u32>(8u, 8u, 8u))) | (vec3<u32>(_e85, (_e85 >> bitcast<u32>(8u)), (_e85 >> bitcast<u32>(16u))) & vec3<u32>(255u, 255u, 255u)))) * vec3<f32>(0.00000005960465f, 0.00000005960465f, 0.00000005960465f));
                let _e123 = (_e103.xyz + (_e106.xyz * select(select(((_e109 - vec3<f32>(0.015625f, 0.015625f, 0.015625f)) * vec3<f32>(1.032258f, 1.032258f, 1.032258f)), (vec3<f32>(1f, 1f, 1f) - (vec3<f32>(0.015625f, 0.015625f, 0.015625f) / max(_e109, vec3<f32>(0.000000029802326f, 0.000000029802326f, 0.000000029802326f)))), (_e109 < vec3<f32>(0.015625f, 0.015625f, 0.015625f))), (vec3<f32>(0.015625f, 0.015625f, 0.015625f) / max((vec3<f32>(1f, 1f, 1f) - _e109), vec3<f32>(0.000000029802326f, 0.000000029802326f, 0.000000029802326f))), (_e109 > vec3<f32>(0.984375f, 0.984375f, 0.984375f)))));
                let _e127 = vec4<f32>(_e123.x, _e123.y, _e123.z, 1f);
                let _e130 = global.member_57[0i];
                let _e134 = global.member_57[1i];
                let _e138 = global.member_57[2i];
                let _e139 = dot(_e138, _e127);
                let _e140 = vec3<f32>(dot(_e130, _e127), dot(_e134, _e127), _e139);
                let _e142 = global.member_43;
                let _e150 = (_e142 * exp2(((f32(((_e81 >> bitcast<u32>(16u)) & 255u)) * 0.125f) - 19f)));
                switch bitcast<i32>(0u) {
                    default: {
                        let _e153 = global.member_6;
                        if !((_e139 >= _e153)) {
                            let _e157 = global_2.member_9;
                            if (_e157 != 0u) {
                                let _e161 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_2737_ = 0f;
                            phi_2728_ = vec2<f32>(0f, 0f);
                            phi_2727_ = false;
                            break;
                        }
                        let _e163 = global.member;
                        let _e164 = _e140.xy;
                        let _e166 = vec2(_e139);
                        let _e169 = global.member_1;
                        let _e170 = (((_e163 * _e164) / _e166) + _e169);
                        let _e172 = global.member_5;
                        let _e176 = all((_e170 >= vec2(-(_e172))));
                        phi_1702_ = _e176;
                        if _e176 {
                            let _e178 = global.member_4;
                            phi_1702_ = all((_e170 <= (_e178 + vec2(_e172))));
                        }
                        let _e184 = phi_1702_;
                        if !(_e184) {
                            let _e187 = global_2.member_9;
                            if (_e187 != 0u) {
                                let _e191 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_2737_ = 0f;
                            phi_2728_ = _e170;
                            phi_2727_ = false;
                            break;
                        }
                        let _e193 = global.member_7;
                        let _e196 = global.member_8;
                        let _e197 = ((_e193 - _e139) * _e196);
                        if (_e197 < 0f) {
                            phi_2712_ = (0.015625f / (1f - _e197));
                        } else {
                            if (_e197 > 1f) {
                                phi_2711_ = (1f - (0.015625f / _e197));
                            } else {
                                phi_2711_ = (0.015625f + (0.96875f * clamp(_e197, 0f, 1f)));
                            }
                            let _e208 = phi_2711_;
                            phi_2712_ = _e208;
                        }
                        let _e210 = phi_2712_;
                        let _e211 = (_e164 / _e166);
                        let _e219 = global.member[0u];
                        let _e222 = global.member[1u];
                        let _e227 = global.member_31;
                        let _e228 = (_e227 > 0u);
                        phi_1751_ = _e228;
                        if _e228 {
                            let _e230 = global.member_34;
                            let _e233 = global.member_29;
                            let _e240 = global.member_49;
                            let _e244 = global.member_51;
                            switch bitcast<i32>(0u) {
                                default: {
                                    let _e250 = vec2(((sqrt((2f * log(max((max(255f, _e230) / _e233), 1f)))) * sqrt(_e240)) * ((((_e150 * length(vec3<f32>(_e211.x, _e211.y, 1f))) * max(_e219, _e222)) / _e139) + sqrt(_e244))));
                                    let _e253 = global.member_32;
                                    let _e256 = global.member_33;
                                    let _e264 = vec2<u32>(clamp(((((_e170 - _e250) - _e253) * _e256) - vec2<f32>(0.5f, 0.5f)), vec2<f32>(0f, 0f), vec2<f32>(191f, 191f)));
                                    let _e266 = vec2<u32>(clamp(((((_e170 + _e250) - _e253) * _e256) + vec2<f32>(0.5f, 0.5f)), vec2<f32>(0f, 0f), vec2<f32>(191f, 191f)));
                                    let _e273 = max((_e266.x - _e264.x), (_e266.y - _e264.y));
                                    if (_e273 <= 3u) {
                                        phi_2716_ = 0u;
                                    } else {
                                        phi_2716_ = (bitcast<u32>(firstLeadingBit((_e273 - 1u))) - 1u);
                                    }
                                    let _e280 = phi_2716_;
                                    if !((_e280 < 4u)) {
                                        phi_2726_ = false;
                                        break;
                                    }
                                    let _e290 = vec2(_e280);
                                    let _e292 = (_e264 >> bitcast<vec2<u32>>(_e290));
                                    let _e294 = (_e266 >> bitcast<vec2<u32>>(_e290));
                                    let _e296 = (_e292.x & 4294967292u);
                                    phi_2722_ = _e296;
                                    phi_2721_ = 0f;
                                    phi_2719_ = _e292.y;
                                    loop {
                                        let _e299 = phi_2722_;
                                        let _e301 = phi_2721_;
                                        let _e303 = phi_2719_;
                                        local = _e301;
                                        if (_e303 <= _e294.y) {
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e308 = (vec4(f32(_e299)) + vec4<f32>(0f, 1f, 2f, 3f));
                                            let _e326 = global_3.member[((_e227 >> bitcast<u32>(1u)) + ((((4u * (12288u - (12288u >> bitcast<u32>((2u * _e280))))) + (_e303 * (192u >> bitcast<u32>(_e280)))) + _e299) >> bitcast<u32>(2u)))];
                                            let _e328 = unpack2x16unorm(_e326.x);
                                            let _e330 = unpack2x16unorm(_e326.y);
                                            let _e337 = select(select(vec4<f32>(_e328.x, _e328.y, _e330.x, _e330.y), vec4<f32>(0f, 0f, 0f, 0f), (_e308 < vec4(f32(_e292.x)))), vec4<f32>(0f, 0f, 0f, 0f), (_e308 > vec4(f32(_e294.x))));
                                            let _e346 = (_e299 + 4u);
                                            let _e347 = (_e346 > _e294.x);
                                            phi_2722_ = select(_e346, _e296, _e347);
                                            phi_2721_ = max(_e301, max(max(_e337.x, _e337.y), max(_e337.z, _e337.w)));
                                            phi_2719_ = (_e303 + select(0u, 1u, _e347));
                                        }
                                    }
                                    let _e352 = local;
                                    phi_2726_ = ((1f - _e210) > _e352);
                                    break;
                                }
                            }
                            let _e355 = phi_2726_;
                            phi_1751_ = _e355;
                        }
                        let _e357 = phi_1751_;
                        if _e357 {
                            let _e359 = global_2.member_9;
                            if (_e359 != 0u) {
                                let _e363 = atomicAdd((&global_1.member[1u]), 1u);
                            }
                            phi_2737_ = _e210;
                            phi_2728_ = _e170;
                            phi_2727_ = false;
                            break;
                        }
                        phi_2737_ = _e210;
                        phi_2728_ = _e170;
                        phi_2727_ = true;
                        break;
                    }
                }
                let _e365 = phi_2737_;
                let _e367 = phi_2728_;
                let _e369 = phi_2727_;
                if !(_e369) {
                    phi_2766_ = 4294967295u;
                    break;
                }
                let _e371 = f32((_e81 >> bitcast<u32>(24u)));
                let _e373 = global.member_29;
                if (_e371 <= _e373) {
                    let _e376 = global_2.member_9;
                    if (_e376 != 0u) {
                        let _e380 = atomicAdd((&global_1.member[2u]), 1u);
                    }
                    phi_2766_ = 4294967295u;
                    break;
                }
                let _e383 = (_e72 + (3u * (_e68 + _e66)));
                let _e386 = global_4.member[_e383];
                let _e390 = global_4.member[(_e383 + 1u)];
                let _e394 = global_4.member[(_e383 + 2u)];
                let _e395 = vec3<u32>(_e386, _e390, _e394);
                let _e407 = vec3<f32>(_e138.x, _e138.y, _e138.z);
                let _e408 = (_e150 * 0.0009775171f);
                let _e412 = ((vec3<f32>((_e395 & vec3<u32>(2047u, 2047u, 2047u))) - vec3<f32>(1023f, 1023f, 1023f)) * _e408);
                let _e418 = ((vec3<f32>(((_e395 >> bitcast<vec3<u32>>(vec3<u32>(11u, 11u, 11u))) & vec3<u32>(2047u, 2047u, 2047u))) - vec3<f32>(1023f, 1023f, 1023f)) * _e408);
                let _e428 = mat3x3<f32>(vec3<f32>(_e412.x, _e418.x, _e418.y), vec3<f32>(0f, _e412.y, _e412.z), vec3<f32>(0f, 0f, _e418.z));
                switch bitcast<i32>(0u) {
                    default: {
                        let _e438 = global.member_2;
                        let _e440 = global.member_3;
                        let _e441 = clamp((_e140.xy / vec2(_e139)), _e438, _e440);
                        let _e444 = global.member[0u];
                        let _e450 = (((vec3<f32>(_e130.x, _e130.y, _e130.z) - (_e407 * _e441.x)) * (_e444 / _e139)) * _e428);
                        let _e453 = global.member[1u];
                        let _e459 = (((vec3<f32>(_e134.x, _e134.y, _e134.z) - (_e407 * _e441.y)) * (_e453 / _e139)) * _e428);
                        let _e461 = global.member_51;
                        let _e463 = (dot(_e450, _e450) + _e461);
                        let _e466 = (dot(_e459, _e459) + _e461);
                        let _e468 = cross(_e450, _e459);
                        let _e469 = dot(_e468, _e468);
                        let _e473 = (_e469 + (_e461 * ((_e463 + _e466) - _e461)));
                        let _e474 = (_e473 > 0f);
                        phi_2230_ = _e474;
                        if _e474 {
                            phi_2230_ = (_e463 <= 1000000000000000000f);
                        }
                        let _e477 = phi_2230_;
                        phi_2236_ = _e477;
                        if _e477 {
                            phi_2236_ = (_e466 <= 1000000000000000000f);
                        }
                        let _e480 = phi_2236_;
                        if !(_e480) {
                            let _e483 = global_2.member_9;
                            if (_e483 != 0u) {
                                let _e487 = atomicAdd((&global_1.member[3u]), 1u);
                            }
                            phi_2765_ = 4294967295u;
                            break;
                        }
                        phi_2751_ = (1f - (_e371 * 0.003921569f));
                        phi_2750_ = 0u;
                        loop {
                            let _e491 = phi_2751_;
                            let _e493 = phi_2750_;
                            let _e495 = global.member_47;
                            local_1 = _e491;
                            if (_e493 < _e495) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                phi_2751_ = (_e491 * _e491);
                                phi_2750_ = (_e493 + bitcast<u32>(1i));
                            }
                        }
                        let _e501 = local_1;
                        let _e505 = u32(round((255f * (1f - _e501))));
                        let _e507 = global.member_52;
                        phi_2759_ = _e505;
                        if (_e507 > 0f) {
                            let _e517 = u32(round((f32(_e505) * ((1f - _e507) + (_e507 * sqrt((_e469 / _e473)))))));
                            if (f32(_e517) <= _e373) {
                                let _e521 = global_2.member_9;
                                if (_e521 != 0u) {
                                    let _e525 = atomicAdd((&global_1.member[2u]), 1u);
                                }
                                phi_2765_ = 4294967295u;
                                break;
                            }
                            phi_2759_ = _e517;
                        }
                        let _e527 = phi_2759_;
                        let _e529 = global.member_49;
                        let _e530 = (vec3<f32>(_e463, dot(_e450, _e459), _e466) * _e529);
                        let _e543 = global.member_53;
                        let _e544 = ((sqrt(_e530.xz) * sqrt((2f * log(max((f32(_e527) / _e373), 1f))))) * _e543);
                        let _e547 = global.member_54;
                        let _e550 = all(((_e367 + _e544) > _e547.xy));
                        phi_2314_ = _e550;
                        if _e550 {
                            phi_2314_ = all(((_e367 - _e544) < _e547.zw));
                        }
                        let _e556 = phi_2314_;
                        if !(_e556) {
                            let _e559 = global_2.member_9;
                            if (_e559 != 0u) {
                                let _e563 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_2765_ = 4294967295u;
                            break;
                        }
                        let _e568 = (0.5f * (_e530.x - _e530.z));
                        let _e573 = sqrt(((_e568 * _e568) + (_e530.y * _e530.y)));
                        let _e576 = ((0.5f * (_e530.x + _e530.z)) + _e573);
                        if (_e568 >= 0f) {
                            phi_2763_ = vec2<f32>((_e568 + _e573), _e530.y);
                        } else {
                            phi_2763_ = vec2<f32>(_e530.y, (_e573 - _e568));
                        }
                        let _e583 = phi_2763_;
                        let _e584 = length(_e583);
                        if (_e584 > 0f) {
                            phi_2764_ = (_e583 / vec2(_e584));
                        } else {
                            phi_2764_ = vec2<f32>(1f, 0f);
                        }
                        let _e589 = phi_2764_;
                        let _e596 = global.member_5;
                        let _e600 = global.member_10;
                        let _e604 = vec2<u32>(clamp(round(((_e367 + vec2(_e596)) * _e600)), vec2<f32>(0f, 0f), vec2<f32>(1048575f, 1048575f)));
                        let _e607 = vec3<u32>(round((clamp((vec3<f32>((_e395 >> bitcast<vec3<u32>>(vec3<u32>(22u, 22u, 22u)))) * vec3<f32>(0.0009775171f, 0.0009775171f, 0.0009775171f)), vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 1023f)));
                        let _e635 = global.member_45;
                        let _e637 = (4u * (_e635 + _e66));
                        global_4.member[_e637] = ((_e604.x | (_e607.x << bitcast<u32>(20u))) | (_e607.z << bitcast<u32>(30u)));
                        global_4.member[(_e637 + 1u)] = (_e604.y | (_e607.y << bitcast<u32>(20u)));
                        global_4.member[(_e637 + 2u)] = pack2x16float((_e589 * min(sqrt(_e576), 65504f)));
                        global_4.member[(_e637 + 3u)] = ((pack2x16float(vec2<f32>(min(sqrt(((_e473 * (_e529 * _e529)) / _e576)), 65504f), 0f)) | (_e527 << bitcast<u32>(16u))) | ((_e607.z >> bitcast<u32>(2u)) << bitcast<u32>(24u)));
                        let _e650 = global.member_9;
                        phi_2765_ = min(u32((_e365 * f32(_e650))), _e650);
                        break;
                    }
                }
                let _e656 = phi_2765_;
                phi_2766_ = _e656;
                break;
            }
        }
        let _e658 = phi_2766_;
        phi_2767_ = _e658;
    } else {
        phi_2767_ = 4294967295u;
    }
    let _e660 = phi_2767_;
    switch bitcast<i32>(0u) {
        default: {
            let _e663 = bitcast<u32>(param[0u]);
            let _e665 = global.member_45;
            let _e666 = (_e665 + _e66);
            if (_e660 != 4294967295u) {
                let _e669 = global.member_41;
                let _e673 = global.member_40;
                let _e679 = atomicAdd((&global_1.member[((_e673 + ((_e666 / _e669) * 256u)) + (_e660 & 255u))]), 1u);
            }
            let _e681 = global.member_39;
            if (_e681 == 0u) {
                if (_e66 < (_e68 + (_e68 & 1u))) {
                    let _e687 = global.member_28;
                    global_4.member[(_e687 + _e666)] = _e660;
                }
                break;
            }
            global_5[_e663] = _e660;
            workgroupBarrier();
            let _e693 = ((_e663 & 1u) == 0u);
            if select(_e693, _e69, _e693) {
                let _e696 = global.member_28;
                let _e703 = global_5[(_e663 + 1u)];
                global_4.member[(_e696 + (_e666 >> bitcast<u32>(1u)))] = ((_e660 & 65535u) | (_e703 << bitcast<u32>(16u)));
            }
            break;
        }
    }
    return;
}
