struct type_12 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_16 {
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
    member_51: vec4<f32>,
    member_52: vec4<f32>,
    member_53: array<vec4<f32>, 3>,
    member_54: array<vec4<u32>, 8>,
    member_55: array<vec4<u32>, 8>,
    member_56: array<type_12, 8>,
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
var<uniform> global: type_16;
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
    var phi_1600_: bool;
    var phi_2540_: f32;
    var phi_2541_: f32;
    var phi_2545_: u32;
    var phi_2551_: u32;
    var phi_2550_: f32;
    var phi_2548_: u32;
    var local: f32;
    var phi_2555_: bool;
    var phi_1646_: bool;
    var phi_2566_: f32;
    var phi_2557_: vec2<f32>;
    var phi_2556_: bool;
    var phi_2108_: bool;
    var phi_2114_: bool;
    var phi_2583_: f32;
    var phi_2582_: u32;
    var local_1: f32;
    var phi_2152_: bool;
    var phi_2589_: vec2<f32>;
    var phi_2590_: vec2<f32>;
    var phi_2591_: u32;
    var phi_2592_: u32;
    var phi_2593_: u32;

    let _e65 = bitcast<u32>(param_1[0u]);
    let _e67 = global.member_48;
    let _e68 = (_e65 < _e67);
    if _e68 {
        switch bitcast<i32>(0u) {
            default: {
                let _e71 = global.member_42;
                let _e73 = (_e71 + (2u * _e65));
                let _e76 = global_4.member[_e73];
                let _e80 = global_4.member[(_e73 + 1u)];
                let _e89 = global.member_51;
                let _e92 = global.member_52;
                let _e95 = (vec3<f32>(vec3<u32>((_e76 & 65535u), (_e76 >> bitcast<u32>(16u)), (_e80 & 65535u))) * vec3<f32>(0.000015259022f, 0.000015259022f, 0.000015259022f));
                let _e109 = (_e89.xyz + (_e92.xyz * select(select(((_e95 - vec3<f32>(0.015625f, 0.015625f, 0.015625f)) * vec3<f32>(1.032258f, 1.032258f, 1.032258f)), (vec3<f32>(1f, 1f, 1f) - (vec3<f32>(0.015625f, 0.015625f, 0.015625f) / max(_e95, vec3<f32>(0.000007629511f, 0.000007629511f, 0.000007629511f)))), (_e95 < vec3<f32>(0.015625f, 0.015625f, 0.015625f))), (vec3<f32>(0.015625f, 0.015625f, 0.015625f) / max((vec3<f32>(1f, 1f, 1f) - _e95), vec3<f32>(0.000007629511f, 0.000007629511f, 0.000007629511f))), (_e95 > vec3<f32>(0.984375f, 0.984375f, 0.984375f)))));
                let _e113 = vec4<f32>(_e109.x, _e109.y, _e109.z, 1f);
                let _e116 = global.member_53[0i];
                let _e120 = global.member_53[1i];
                let _e124 = global.member_53[2i];
                let _e125 = dot(_e124, _e113);
                let _e126 = vec3<f32>(dot(_e116, _e113), dot(_e120, _e113), _e125);
                let _e128 = global.member_43;
                let _e136 = (_e128 * exp2(((f32(((_e80 >> bitcast<u32>(16u)) & 255u)) * 0.125f) - 19f)));
                switch bitcast<i32>(0u) {
                    default: {
                        let _e139 = global.member_6;
                        if !((_e125 >= _e139)) {
                            let _e143 = global_2.member_9;
                            if (_e143 != 0u) {
                                let _e147 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_2566_ = 0f;
                            phi_2557_ = vec2<f32>(0f, 0f);
                            phi_2556_ = false;
                            break;
                        }
                        let _e149 = global.member;
                        let _e150 = _e126.xy;
                        let _e152 = vec2(_e125);
                        let _e155 = global.member_1;
                        let _e156 = (((_e149 * _e150) / _e152) + _e155);
                        let _e158 = global.member_5;
                        let _e162 = all((_e156 >= vec2(-(_e158))));
                        phi_1600_ = _e162;
                        if _e162 {
                            let _e164 = global.member_4;
                            phi_1600_ = all((_e156 <= (_e164 + vec2(_e158))));
                        }
                        let _e170 = phi_1600_;
                        if !(_e170) {
                            let _e173 = global_2.member_9;
                            if (_e173 != 0u) {
                                let _e177 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_2566_ = 0f;
                            phi_2557_ = _e156;
                            phi_2556_ = false;
                            break;
                        }
                        let _e179 = global.member_7;
                        let _e182 = global.member_8;
                        let _e183 = ((_e179 - _e125) * _e182);
                        if (_e183 < 0f) {
                            phi_2541_ = (0.015625f / (1f - _e183));
                        } else {
                            if (_e183 > 1f) {
                                phi_2540_ = (1f - (0.015625f / _e183));
                            } else {
                                phi_2540_ = (0.015625f + (0.96875f * clamp(_e183, 0f, 1f)));
                            }
                            let _e194 = phi_2540_;
                            phi_2541_ = _e194;
                        }
                        let _e196 = phi_2541_;
                        let _e197 = (_e150 / _e152);
                        let _e205 = global.member[0u];
                        let _e208 = global.member[1u];
                        let _e213 = global.member_31;
                        let _e214 = (_e213 > 0u);
                        phi_1646_ = _e214;
                        if _e214 {
                            let _e216 = global.member_34;
                            let _e219 = global.member_29;
                            let _e226 = global.member_49;
                            switch bitcast<i32>(0u) {
                                default: {
                                    let _e233 = vec2(((sqrt((2f * log(max((max(255f, _e216) / _e219), 1f)))) * sqrt(_e226)) * ((((_e136 * length(vec3<f32>(_e197.x, _e197.y, 1f))) * max(_e205, _e208)) / _e125) + 0.5477226f)));
                                    let _e236 = global.member_32;
                                    let _e239 = global.member_33;
                                    let _e247 = vec2<u32>(clamp(((((_e156 - _e233) - _e236) * _e239) - vec2<f32>(0.5f, 0.5f)), vec2<f32>(0f, 0f), vec2<f32>(191f, 191f)));
                                    let _e249 = vec2<u32>(clamp(((((_e156 + _e233) - _e236) * _e239) + vec2<f32>(0.5f, 0.5f)), vec2<f32>(0f, 0f), vec2<f32>(191f, 191f)));
                                    let _e256 = max((_e249.x - _e247.x), (_e249.y - _e247.y));
                                    if (_e256 <= 3u) {
                                        phi_2545_ = 0u;
                                    } else {
                                        phi_2545_ = (bitcast<u32>(firstLeadingBit((_e256 - 1u))) - 1u);
                                    }
                                    let _e263 = phi_2545_;
                                    if !((_e263 < 4u)) {
                                        phi_2555_ = false;
                                        break;
                                    }
                                    let _e273 = vec2(_e263);
                                    let _e275 = (_e247 >> bitcast<vec2<u32>>(_e273));
                                    let _e277 = (_e249 >> bitcast<vec2<u32>>(_e273));
                                    let _e279 = (_e275.x & 4294967292u);
                                    phi_2551_ = _e279;
                                    phi_2550_ = 0f;
                                    phi_2548_ = _e275.y;
                                    loop {
                                        let _e282 = phi_2551_;
                                        let _e284 = phi_2550_;
                                        let _e286 = phi_2548_;
                                        local = _e284;
                                        if (_e286 <= _e277.y) {
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e291 = (vec4(f32(_e282)) + vec4<f32>(0f, 1f, 2f, 3f));
                                            let _e309 = global_3.member[((_e213 >> bitcast<u32>(1u)) + ((((4u * (12288u - (12288u >> bitcast<u32>((2u * _e263))))) + (_e286 * (192u >> bitcast<u32>(_e263)))) + _e282) >> bitcast<u32>(2u)))];
                                            let _e311 = unpack2x16unorm(_e309.x);
                                            let _e313 = unpack2x16unorm(_e309.y);
                                            let _e320 = select(select(vec4<f32>(_e311.x, _e311.y, _e313.x, _e313.y), vec4<f32>(0f, 0f, 0f, 0f), (_e291 < vec4(f32(_e275.x)))), vec4<f32>(0f, 0f, 0f, 0f), (_e291 > vec4(f32(_e277.x))));
                                            let _e329 = (_e282 + 4u);
                                            let _e330 = (_e329 > _e277.x);
                                            phi_2551_ = select(_e329, _e279, _e330);
                                            phi_2550_ = max(_e284, max(max(_e320.x, _e320.y), max(_e320.z, _e320.w)));
                                            phi_2548_ = (_e286 + select(0u, 1u, _e330));
                                        }
                                    }
                                    let _e335 = local;
                                    phi_2555_ = ((1f - _e196) > _e335);
                                    break;
                                }
                            }
                            let _e338 = phi_2555_;
                            phi_1646_ = _e338;
                        }
                        let _e340 = phi_1646_;
                        if _e340 {
                            let _e342 = global_2.member_9;
                            if (_e342 != 0u) {
                                let _e346 = atomicAdd((&global_1.member[1u]), 1u);
                            }
                            phi_2566_ = _e196;
                            phi_2557_ = _e156;
                            phi_2556_ = false;
                            break;
                        }
                        phi_2566_ = _e196;
                        phi_2557_ = _e156;
                        phi_2556_ = true;
                        break;
                    }
                }
                let _e348 = phi_2566_;
                let _e350 = phi_2557_;
                let _e352 = phi_2556_;
                if !(_e352) {
                    phi_2592_ = 4294967295u;
                    break;
                }
                let _e354 = f32((_e80 >> bitcast<u32>(24u)));
                let _e356 = global.member_29;
                if (_e354 <= _e356) {
                    let _e359 = global_2.member_9;
                    if (_e359 != 0u) {
                        let _e363 = atomicAdd((&global_1.member[2u]), 1u);
                    }
                    phi_2592_ = 4294967295u;
                    break;
                }
                let _e365 = global.member_14;
                let _e369 = ((_e71 + (2u * _e365)) + (3u * _e65));
                let _e372 = global_4.member[_e369];
                let _e376 = global_4.member[(_e369 + 1u)];
                let _e380 = global_4.member[(_e369 + 2u)];
                let _e381 = vec3<u32>(_e372, _e376, _e380);
                let _e393 = vec3<f32>(_e124.x, _e124.y, _e124.z);
                let _e394 = (_e136 * 0.0009775171f);
                let _e398 = ((vec3<f32>((_e381 & vec3<u32>(2047u, 2047u, 2047u))) - vec3<f32>(1023f, 1023f, 1023f)) * _e394);
                let _e404 = ((vec3<f32>(((_e381 >> bitcast<vec3<u32>>(vec3<u32>(11u, 11u, 11u))) & vec3<u32>(2047u, 2047u, 2047u))) - vec3<f32>(1023f, 1023f, 1023f)) * _e394);
                let _e414 = mat3x3<f32>(vec3<f32>(_e398.x, _e404.x, _e404.y), vec3<f32>(0f, _e398.y, _e398.z), vec3<f32>(0f, 0f, _e404.z));
                switch bitcast<i32>(0u) {
                    default: {
                        let _e424 = global.member_2;
                        let _e426 = global.member_3;
                        let _e427 = clamp((_e126.xy / vec2(_e125)), _e424, _e426);
                        let _e430 = global.member[0u];
                        let _e436 = (((vec3<f32>(_e116.x, _e116.y, _e116.z) - (_e393 * _e427.x)) * (_e430 / _e125)) * _e414);
                        let _e439 = global.member[1u];
                        let _e445 = (((vec3<f32>(_e120.x, _e120.y, _e120.z) - (_e393 * _e427.y)) * (_e439 / _e125)) * _e414);
                        let _e447 = (dot(_e436, _e436) + 0.3f);
                        let _e450 = (dot(_e445, _e445) + 0.3f);
                        let _e452 = cross(_e436, _e445);
                        let _e457 = (dot(_e452, _e452) + (0.3f * ((_e447 + _e450) - 0.3f)));
                        let _e458 = (_e457 > 0f);
                        phi_2108_ = _e458;
                        if _e458 {
                            phi_2108_ = (_e447 <= 1000000000000000000f);
                        }
                        let _e461 = phi_2108_;
                        phi_2114_ = _e461;
                        if _e461 {
                            phi_2114_ = (_e450 <= 1000000000000000000f);
                        }
                        let _e464 = phi_2114_;
                        if !(_e464) {
                            let _e467 = global_2.member_9;
                            if (_e467 != 0u) {
                                let _e471 = atomicAdd((&global_1.member[3u]), 1u);
                            }
                            phi_2591_ = 4294967295u;
                            break;
                        }
                        let _e473 = global.member_49;
                        let _e474 = (vec3<f32>(_e447, dot(_e436, _e445), _e450) * _e473);
                        phi_2583_ = (1f - (_e354 * 0.003921569f));
                        phi_2582_ = 0u;
                        loop {
                            let _e480 = phi_2583_;
                            let _e482 = phi_2582_;
                            let _e484 = global.member_47;
                            local_1 = _e480;
                            if (_e482 < _e484) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                phi_2583_ = (_e480 * _e480);
                                phi_2582_ = (_e482 + bitcast<u32>(1i));
                            }
                        }
                        let _e490 = local_1;
                        let _e494 = u32(round((255f * (1f - _e490))));
                        let _e497 = global.member_34;
                        let _e506 = (sqrt(_e474.xz) * sqrt((2f * log(max((max(f32(_e494), _e497) / _e356), 1f)))));
                        let _e509 = all(((_e350 + _e506) > vec2<f32>(0f, 0f)));
                        phi_2152_ = _e509;
                        if _e509 {
                            let _e512 = global.member_4;
                            phi_2152_ = all(((_e350 - _e506) < _e512));
                        }
                        let _e516 = phi_2152_;
                        if !(_e516) {
                            let _e519 = global_2.member_9;
                            if (_e519 != 0u) {
                                let _e523 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_2591_ = 4294967295u;
                            break;
                        }
                        let _e528 = (0.5f * (_e474.x - _e474.z));
                        let _e533 = sqrt(((_e528 * _e528) + (_e474.y * _e474.y)));
                        let _e536 = ((0.5f * (_e474.x + _e474.z)) + _e533);
                        if (_e528 >= 0f) {
                            phi_2589_ = vec2<f32>((_e528 + _e533), _e474.y);
                        } else {
                            phi_2589_ = vec2<f32>(_e474.y, (_e533 - _e528));
                        }
                        let _e543 = phi_2589_;
                        let _e544 = length(_e543);
                        if (_e544 > 0f) {
                            phi_2590_ = (_e543 / vec2(_e544));
                        } else {
                            phi_2590_ = vec2<f32>(1f, 0f);
                        }
                        let _e549 = phi_2590_;
                        let _e556 = global.member_5;
                        let _e560 = global.member_10;
                        let _e564 = vec2<u32>(clamp(round(((_e350 + vec2(_e556)) * _e560)), vec2<f32>(0f, 0f), vec2<f32>(1048575f, 1048575f)));
                        let _e567 = vec3<u32>(round((clamp((vec3<f32>((_e381 >> bitcast<vec3<u32>>(vec3<u32>(22u, 22u, 22u)))) * vec3<f32>(0.0009775171f, 0.0009775171f, 0.0009775171f)), vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 1023f)));
                        let _e595 = global.member_45;
                        let _e597 = (4u * (_e595 + _e65));
                        global_4.member[_e597] = ((_e564.x | (_e567.x << bitcast<u32>(20u))) | (_e567.z << bitcast<u32>(30u)));
                        global_4.member[(_e597 + 1u)] = (_e564.y | (_e567.y << bitcast<u32>(20u)));
                        global_4.member[(_e597 + 2u)] = pack2x16float((_e549 * min(sqrt(_e536), 65504f)));
                        global_4.member[(_e597 + 3u)] = ((pack2x16float(vec2<f32>(min(sqrt(((_e457 * (_e473 * _e473)) / _e536)), 65504f), 0f)) | (_e494 << bitcast<u32>(16u))) | ((_e567.z >> bitcast<u32>(2u)) << bitcast<u32>(24u)));
                        let _e610 = global.member_9;
                        phi_2591_ = min(u32((_e348 * f32(_e610))), _e610);
                        break;
                    }
                }
                let _e616 = phi_2591_;
                phi_2592_ = _e616;
                break;
            }
        }
        let _e618 = phi_2592_;
        phi_2593_ = _e618;
    } else {
        phi_2593_ = 4294967295u;
    }
    let _e620 = phi_2593_;
    switch bitcast<i32>(0u) {
        default: {
            let _e623 = bitcast<u32>(param[0u]);
            let _e625 = global.member_45;
            let _e626 = (_e625 + _e65);
            if (_e620 != 4294967295u) {
                let _e629 = global.member_41;
                let _e633 = global.member_40;
                let _e639 = atomicAdd((&global_1.member[((_e633 + ((_e626 / _e629) * 256u)) + (_e620 & 255u))]), 1u);
            }
            let _e641 = global.member_39;
            if (_e641 == 0u) {
                if (_e65 < (_e67 + (_e67 & 1u))) {
                    let _e647 = global.member_28;
                    global_4.member[(_e647 + _e626)] = _e620;
                }
                break;
            }
            global_5[_e623] = _e620;
            workgroupBarrier();
            let _e653 = ((_e623 & 1u) == 0u);
            if select(_e653, _e68, _e653) {
                let _e656 = global.member_28;
                let _e663 = global_5[(_e623 + 1u)];
                global_4.member[(_e656 + (_e626 >> bitcast<u32>(1u)))] = ((_e620 & 65535u) | (_e663 << bitcast<u32>(16u)));
            }
            break;
        }
    }
    return;
}
