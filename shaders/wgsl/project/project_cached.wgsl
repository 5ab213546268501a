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
    var phi_1693_: bool;
    var phi_2700_: f32;
    var phi_2701_: f32;
    var phi_2705_: u32;
    var phi_2711_: u32;
    var phi_2710_: f32;
    var phi_2708_: u32;
    var local: f32;
    var phi_2715_: bool;
    var phi_1742_: bool;
    var phi_2726_: f32;
    var phi_2717_: vec2<f32>;
    var phi_2716_: bool;
    var phi_2216_: bool;
    var phi_2222_: bool;
    var phi_2740_: f32;
    var phi_2739_: u32;
    var local_1: f32;
    var phi_2748_: u32;
    var phi_2299_: bool;
    var phi_2752_: vec2<f32>;
    var phi_2753_: vec2<f32>;
    var phi_2754_: u32;
    var phi_2755_: u32;
    var phi_2756_: u32;

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
                            phi_2726_ = 0f;
                            phi_2717_ = vec2<f32>(0f, 0f);
                            phi_2716_ = false;
                            break;
                        }
                        let _e163 = global.member;
                        let _e164 = _e140.xy;
                        let _e166 = vec2(_e139);
                        let _e169 = global.member_1;
                        let _e170 = (((_e163 * _e164) / _e166) + _e169);
                        let _e172 = global.member_5;
                        let _e176 = all((_e170 >= vec2(-(_e172))));
                        phi_1693_ = _e176;
                        if _e176 {
                            let _e178 = global.member_4;
                            phi_1693_ = all((_e170 <= (_e178 + vec2(_e172))));
                        }
                        let _e184 = phi_1693_;
                        if !(_e184) {
                            let _e187 = global_2.member_9;
                            if (_e187 != 0u) {
                                let _e191 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_2726_ = 0f;
                            phi_2717_ = _e170;
                            phi_2716_ = false;
                            break;
                        }
                        let _e193 = global.member_7;
                        let _e196 = global.member_8;
                        let _e197 = ((_e193 - _e139) * _e196);
                        if (_e197 < 0f) {
                            phi_2701_ = (0.015625f / (1f - _e197));
                        } else {
                            if (_e197 > 1f) {
                                phi_2700_ = (1f - (0.015625f / _e197));
                            } else {
                                phi_2700_ = (0.015625f + (0.96875f * clamp(_e197, 0f, 1f)));
                            }
                            let _e208 = phi_2700_;
                            phi_2701_ = _e208;
                        }
                        let _e210 = phi_2701_;
                        let _e211 = (_e164 / _e166);
                        let _e219 = global.member[0u];
                        let _e222 = global.member[1u];
                        let _e227 = global.member_31;
                        let _e228 = (_e227 > 0u);
                        phi_1742_ = _e228;
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
                                        phi_2705_ = 0u;
                                    } else {
                                        phi_2705_ = (bitcast<u32>(firstLeadingBit((_e273 - 1u))) - 1u);
                                    }
                                    let _e280 = phi_2705_;
                                    if !((_e280 < 4u)) {
                                        phi_2715_ = false;
                                        break;
                                    }
                                    let _e290 = vec2(_e280);
                                    let _e292 = (_e264 >> bitcast<vec2<u32>>(_e290));
                                    let _e294 = (_e266 >> bitcast<vec2<u32>>(_e290));
                                    let _e296 = (_e292.x & 4294967292u);
                                    phi_2711_ = _e296;
                                    phi_2710_ = 0f;
                                    phi_2708_ = _e292.y;
                                    loop {
                                        let _e299 = phi_2711_;
                                        let _e301 = phi_2710_;
                                        let _e303 = phi_2708_;
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
                                            phi_2711_ = select(_e346, _e296, _e347);
                                            phi_2710_ = max(_e301, max(max(_e337.x, _e337.y), max(_e337.z, _e337.w)));
                                            phi_2708_ = (_e303 + select(0u, 1u, _e347));
                                        }
                                    }
                                    let _e352 = local;
                                    phi_2715_ = ((1f - _e210) > _e352);
                                    break;
                                }
                            }
                            let _e355 = phi_2715_;
                            phi_1742_ = _e355;
                        }
                        let _e357 = phi_1742_;
                        if _e357 {
                            let _e359 = global_2.member_9;
                            if (_e359 != 0u) {
                                let _e363 = atomicAdd((&global_1.member[1u]), 1u);
                            }
                            phi_2726_ = _e210;
                            phi_2717_ = _e170;
                            phi_2716_ = false;
                            break;
                        }
                        phi_2726_ = _e210;
                        phi_2717_ = _e170;
                        phi_2716_ = true;
                        break;
                    }
                }
                let _e365 = phi_2726_;
                let _e367 = phi_2717_;
                let _e369 = phi_2716_;
                if !(_e369) {
                    phi_2755_ = 4294967295u;
                    break;
                }
                let _e371 = f32((_e81 >> bitcast<u32>(24u)));
                let _e373 = global.member_29;
                if (_e371 <= _e373) {
                    let _e376 = global_2.member_9;
                    if (_e376 != 0u) {
                        let _e380 = atomicAdd((&global_1.member[2u]), 1u);
                    }
                    phi_2755_ = 4294967295u;
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
                        phi_2216_ = _e474;
                        if _e474 {
                            phi_2216_ = (_e463 <= 1000000000000000000f);
                        }
                        let _e477 = phi_2216_;
                        phi_2222_ = _e477;
                        if _e477 {
                            phi_2222_ = (_e466 <= 1000000000000000000f);
                        }
                        let _e480 = phi_2222_;
                        if !(_e480) {
                            let _e483 = global_2.member_9;
                            if (_e483 != 0u) {
                                let _e487 = atomicAdd((&global_1.member[3u]), 1u);
                            }
                            phi_2754_ = 4294967295u;
                            break;
                        }
                        phi_2740_ = (1f - (_e371 * 0.003921569f));
                        phi_2739_ = 0u;
                        loop {
                            let _e491 = phi_2740_;
                            let _e493 = phi_2739_;
                            let _e495 = global.member_47;
                            local_1 = _e491;
                            if (_e493 < _e495) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                phi_2740_ = (_e491 * _e491);
                                phi_2739_ = (_e493 + bitcast<u32>(1i));
                            }
                        }
                        let _e501 = local_1;
                        let _e505 = u32(round((255f * (1f - _e501))));
                        let _e507 = global.member_52;
                        phi_2748_ = _e505;
                        if (_e507 > 0f) {
                            let _e517 = u32(round((f32(_e505) * ((1f - _e507) + (_e507 * sqrt((_e469 / _e473)))))));
                            if (f32(_e517) <= _e373) {
                                let _e521 = global_2.member_9;
                                if (_e521 != 0u) {
                                    let _e525 = atomicAdd((&global_1.member[2u]), 1u);
                                }
                                phi_2754_ = 4294967295u;
                                break;
                            }
                            phi_2748_ = _e517;
                        }
                        let _e527 = phi_2748_;
                        let _e529 = global.member_49;
                        let _e530 = (vec3<f32>(_e463, dot(_e450, _e459), _e466) * _e529);
                        let _e535 = global.member_34;
                        let _e546 = global.member_53;
                        let _e547 = ((sqrt(_e530.xz) * sqrt((2f * log(max((max(f32(_e527), _e535) / _e373), 1f))))) * _e546);
                        let _e550 = global.member_54;
                        let _e553 = all(((_e367 + _e547) > _e550.xy));
                        phi_2299_ = _e553;
                        if _e553 {
                            phi_2299_ = all(((_e367 - _e547) < _e550.zw));
                        }
                        let _e559 = phi_2299_;
                        if !(_e559) {
                            let _e562 = global_2.member_9;
                            if (_e562 != 0u) {
                                let _e566 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_2754_ = 4294967295u;
                            break;
                        }
                        let _e571 = (0.5f * (_e530.x - _e530.z));
                        let _e576 = sqrt(((_e571 * _e571) + (_e530.y * _e530.y)));
                        let _e579 = ((0.5f * (_e530.x + _e530.z)) + _e576);
                        if (_e571 >= 0f) {
                            phi_2752_ = vec2<f32>((_e571 + _e576), _e530.y);
                        } else {
                            phi_2752_ = vec2<f32>(_e530.y, (_e576 - _e571));
                        }
                        let _e586 = phi_2752_;
                        let _e587 = length(_e586);
                        if (_e587 > 0f) {
                            phi_2753_ = (_e586 / vec2(_e587));
                        } else {
                            phi_2753_ = vec2<f32>(1f, 0f);
                        }
                        let _e592 = phi_2753_;
                        let _e599 = global.member_5;
                        let _e603 = global.member_10;
                        let _e607 = vec2<u32>(clamp(round(((_e367 + vec2(_e599)) * _e603)), vec2<f32>(0f, 0f), vec2<f32>(1048575f, 1048575f)));
                        let _e610 = vec3<u32>(round((clamp((vec3<f32>((_e395 >> bitcast<vec3<u32>>(vec3<u32>(22u, 22u, 22u)))) * vec3<f32>(0.0009775171f, 0.0009775171f, 0.0009775171f)), vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 1023f)));
                        let _e638 = global.member_45;
                        let _e640 = (4u * (_e638 + _e66));
                        global_4.member[_e640] = ((_e607.x | (_e610.x << bitcast<u32>(20u))) | (_e610.z << bitcast<u32>(30u)));
                        global_4.member[(_e640 + 1u)] = (_e607.y | (_e610.y << bitcast<u32>(20u)));
                        global_4.member[(_e640 + 2u)] = pack2x16float((_e592 * min(sqrt(_e579), 65504f)));
                        global_4.member[(_e640 + 3u)] = ((pack2x16float(vec2<f32>(min(sqrt(((_e473 * (_e529 * _e529)) / _e579)), 65504f), 0f)) | (_e527 << bitcast<u32>(16u))) | ((_e610.z >> bitcast<u32>(2u)) << bitcast<u32>(24u)));
                        let _e653 = global.member_9;
                        phi_2754_ = min(u32((_e365 * f32(_e653))), _e653);
                        break;
                    }
                }
                let _e659 = phi_2754_;
                phi_2755_ = _e659;
                break;
            }
        }
        let _e661 = phi_2755_;
        phi_2756_ = _e661;
    } else {
        phi_2756_ = 4294967295u;
    }
    let _e663 = phi_2756_;
    switch bitcast<i32>(0u) {
        default: {
            let _e666 = bitcast<u32>(param[0u]);
            let _e668 = global.member_45;
            let _e669 = (_e668 + _e66);
            if (_e663 != 4294967295u) {
                let _e672 = global.member_41;
                let _e676 = global.member_40;
                let _e682 = atomicAdd((&global_1.member[((_e676 + ((_e669 / _e672) * 256u)) + (_e663 & 255u))]), 1u);
            }
            let _e684 = global.member_39;
            if (_e684 == 0u) {
                if (_e66 < (_e68 + (_e68 & 1u))) {
                    let _e690 = global.member_28;
                    global_4.member[(_e690 + _e669)] = _e663;
                }
                break;
            }
            global_5[_e666] = _e663;
            workgroupBarrier();
            let _e696 = ((_e666 & 1u) == 0u);
            if select(_e696, _e69, _e696) {
                let _e699 = global.member_28;
                let _e706 = global_5[(_e666 + 1u)];
                global_4.member[(_e699 + (_e669 >> bitcast<u32>(1u)))] = ((_e663 & 65535u) | (_e706 << bitcast<u32>(16u)));
            }
            break;
        }
    }
    return;
}
