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
    member_50: vec4<f32>,
    member_51: vec4<f32>,
    member_52: array<vec4<f32>, 3>,
    member_53: array<vec4<u32>, 8>,
    member_54: array<vec4<u32>, 8>,
    member_55: array<type_12, 8>,
    member_56: array<vec4<f32>, 128>,
    member_57: array<vec4<f32>, 768>,
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
    member: array<vec2<u32>, LENGTH_3_8>,
}

struct type_32 {
    member: array<u32, LENGTH_4_4>,
}

struct type_34 {
    member: array<u32, LENGTH_2_4>,
}

struct type_36 {
    member: array<vec2<u32>, LENGTH_1_8>,
}

@group(0) @binding(0) 
var<uniform> global: type_16;
@group(0) @binding(6) 
var<storage, read_write> global_1: type_28;
@group(0) @binding(7) 
var<uniform> global_2: type_20;
@group(0) @binding(3) 
var<storage> global_3: type_30;
@group(0) @binding(4) 
var<storage, read_write> global_4: type_32;
var<workgroup> global_5: array<u32, 64>;
@group(0) @binding(2) 
var<storage> global_6: type_34;
@group(0) @binding(1) 
var<storage> global_7: type_36;

@compute @workgroup_size(64, 1, 1) 
fn main(@builtin(local_invocation_id) param: vec3<u32>, @builtin(global_invocation_id) param_1: vec3<u32>) {
    var phi_5041_: u32;
    var phi_3083_: bool;
    var local: bool;
    var phi_3475_: bool;
    var phi_5043_: f32;
    var phi_5044_: f32;
    var phi_5048_: u32;
    var phi_5055_: f32;
    var phi_5054_: u32;
    var phi_5051_: u32;
    var local_1: f32;
    var phi_5060_: bool;
    var phi_3521_: bool;
    var phi_5071_: f32;
    var phi_5062_: vec2<f32>;
    var phi_5061_: bool;
    var phi_5081_: vec4<f32>;
    var phi_5082_: vec4<f32>;
    var phi_5083_: vec4<f32>;
    var phi_5101_: vec3<f32>;
    var phi_5103_: vec4<f32>;
    var phi_5102_: u32;
    var local_2: vec4<f32>;
    var phi_5118_: vec4<f32>;
    var phi_5106_: vec3<f32>;
    var phi_5105_: u32;
    var local_3: vec3<f32>;
    var phi_5122_: vec3<f32>;
    var phi_5115_: vec3<f32>;
    var phi_5114_: u32;
    var local_4: vec3<f32>;
    var phi_5124_: vec3<f32>;
    var phi_4549_: bool;
    var phi_4555_: bool;
    var phi_5132_: f32;
    var phi_5131_: u32;
    var local_5: f32;
    var phi_4593_: bool;
    var phi_5138_: vec2<f32>;
    var phi_5139_: vec2<f32>;
    var phi_5140_: u32;
    var phi_5141_: u32;
    var phi_5142_: u32;

    let _e72 = bitcast<u32>(param_1[0u]);
    let _e74 = global.member_48;
    let _e75 = (_e72 < _e74);
    if _e75 {
        switch bitcast<i32>(0u) {
            default: {
                let _e78 = global.member_14;
                let _e80 = global.member_47;
                let _e82 = (_e72 << bitcast<u32>(_e80));
                let _e86 = (4u * (_e78 + (_e82 >> bitcast<u32>(5u))));
                let _e91 = global_7.member[(_e86 + 3u)][0u];
                phi_5041_ = (_e91 & 65535u);
                loop {
                    let _e94 = phi_5041_;
                    let _e103 = global.member_54[(_e94 >> bitcast<u32>(7u))][((_e94 >> bitcast<u32>(5u)) & 3u)];
                    let _e108 = (((_e103 >> bitcast<u32>((_e94 & 31u))) & 1u) != 0u);
                    let _e110 = (_e94 + bitcast<u32>(1i));
                    local = _e108;
                    continue;
                    continuing {
                        phi_3083_ = _e108;
                        if _e108 {
                            phi_3083_ = (_e110 <= (_e91 >> bitcast<u32>(16u)));
                        }
                        let _e115 = phi_3083_;
                        phi_5041_ = _e110;
                        break if !(_e115);
                    }
                }
                let _e118 = local;
                if _e118 {
                    let _e120 = global_2.member_9;
                    if (_e120 != 0u) {
                        let _e124 = atomicAdd((&global_1.member[0u]), 1u);
                    }
                    phi_5141_ = 4294967295u;
                    break;
                }
                let _e125 = (2u * _e82);
                let _e128 = global_7.member[_e125];
                let _e132 = global_7.member[(_e125 + 1u)];
                let _e137 = global_7.member[((2u * _e78) + _e82)];
                let _e148 = (vec2<f32>(f32(((_e137.y >> bitcast<u32>(16u)) & 31u)), f32(((_e137.y >> bitcast<u32>(21u)) & 31u))) * vec2<f32>(0.032258064f, 0.032258064f));
                let _e152 = ((1f + (2f * _e148.x)) * 0.33333334f);
                let _e153 = (1f - _e152);
                let _e157 = (_e153 * (0.5f + (0.5f * _e148.y)));
                let _e175 = global.member_11;
                let _e178 = global.member_12;
                let _e183 = global.member_21;
                let _e184 = (2u * _e183);
                let _e188 = global_3.member[(_e184 + (_e137.x & 65535u))];
                let _e190 = unpack2x16float(_e188.x);
                let _e202 = global_3.member[(_e184 + (_e137.x >> bitcast<u32>(16u)))];
                let _e204 = unpack2x16float(_e202.x);
                let _e216 = global_3.member[(_e184 + (_e137.y & 65535u))];
                let _e218 = unpack2x16float(_e216.x);
                let _e226 = ((((_e175.xyz + (_e178.xyz * vec3<f32>(f32((_e128.x & 65535u)), f32((_e128.x >> bitcast<u32>(16u))), f32((_e128.y & 65535u))))) + (vec3<f32>(_e190.x, _e190.y, unpack2x16float(_e188.y).x) * _e152)) + (vec3<f32>(_e204.x, _e204.y, unpack2x16float(_e202.y).x) * _e157)) + (vec3<f32>(_e218.x, _e218.y, unpack2x16float(_e216.y).x) * (_e153 - _e157)));
                let _e230 = vec4<f32>(_e226.x, _e226.y, _e226.z, 1f);
                let _e243 = (((_e128.y >> bitcast<u32>(16u)) | ((_e132.y >> bitcast<u32>(24u)) << bitcast<u32>(16u))) | ((_e137.y >> bitcast<u32>(26u)) << bitcast<u32>(24u)));
                let _e255 = global.member_36;
                let _e257 = global.member_37;
                let _e260 = (vec3(_e255) + (vec3<f32>(f32((_e243 & 1023u)), f32(((_e243 >> bitcast<u32>(10u)) & 1023u)), f32((_e243 >> bitcast<u32>(20u)))) * _e257));
                let _e269 = (vec4<u32>(_e132.x, (_e132.x >> bitcast<u32>(8u)), (_e132.x >> bitcast<u32>(16u)), (_e132.x >> bitcast<u32>(24u))) & vec4<u32>(255u, 255u, 255u, 255u));
                let _e275 = (vec3<u32>(_e132.y, (_e132.y >> bitcast<u32>(8u)), (_e132.y >> bitcast<u32>(16u))) & vec3<u32>(255u, 255u, 255u));
                let _e276 = vec3<f32>(_e275);
                let _e288 = (vec4<f32>(_e276.x, _e276.y, _e276.z, f32((((255u - _e275.x) - _e275.y) - _e275.z))) * vec4<f32>(0.003921569f, 0.003921569f, 0.003921569f, 0.003921569f));
                let _e291 = (3u * _e269.x);
                let _e294 = global.member_57[_e291];
                let _e299 = global.member_57[(_e291 + 1u)];
                let _e304 = global.member_57[(_e291 + 2u)];
                let _e308 = (3u * _e269.y);
                let _e311 = global.member_57[_e308];
                let _e317 = global.member_57[(_e308 + 1u)];
                let _e323 = global.member_57[(_e308 + 2u)];
                let _e328 = (3u * _e269.z);
                let _e331 = global.member_57[_e328];
                let _e337 = global.member_57[(_e328 + 1u)];
                let _e343 = global.member_57[(_e328 + 2u)];
                let _e348 = (3u * _e269.w);
                let _e351 = global.member_57[_e348];
                let _e353 = ((((_e294 * _e288.x) + (_e311 * _e288.y)) + (_e331 * _e288.z)) + (_e351 * _e288.w));
                let _e357 = global.member_57[(_e348 + 1u)];
                let _e359 = ((((_e299 * _e288.x) + (_e317 * _e288.y)) + (_e337 * _e288.z)) + (_e357 * _e288.w));
                let _e363 = global.member_57[(_e348 + 2u)];
                let _e365 = ((((_e304 * _e288.x) + (_e323 * _e288.y)) + (_e343 * _e288.z)) + (_e363 * _e288.w));
                let _e368 = dot(_e365, _e230);
                let _e369 = vec3<f32>(dot(_e353, _e230), dot(_e359, _e230), _e368);
                let _e370 = _e353.xyz;
                let _e371 = _e359.xyz;
                let _e372 = _e365.xyz;
                let _e384 = vec3<f32>(_e365.x, _e365.y, _e365.z);
                switch bitcast<i32>(0u) {
                    default: {
                        let _e402 = global.member_6;
                        if !((_e368 >= _e402)) {
                            let _e406 = global_2.member_9;
                            if (_e406 != 0u) {
                                let _e410 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_5071_ = 0f;
                            phi_5062_ = vec2<f32>(0f, 0f);
                            phi_5061_ = false;
                            break;
                        }
                        let _e412 = global.member;
                        let _e413 = _e369.xy;
                        let _e415 = vec2(_e368);
                        let _e418 = global.member_1;
                        let _e419 = (((_e412 * _e413) / _e415) + _e418);
                        let _e421 = global.member_5;
                        let _e425 = all((_e419 >= vec2(-(_e421))));
                        phi_3475_ = _e425;
                        if _e425 {
                            let _e427 = global.member_4;
                            phi_3475_ = all((_e419 <= (_e427 + vec2(_e421))));
                        }
                        let _e433 = phi_3475_;
                        if !(_e433) {
                            let _e436 = global_2.member_9;
                            if (_e436 != 0u) {
                                let _e440 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_5071_ = 0f;
                            phi_5062_ = _e419;
                            phi_5061_ = false;
                            break;
                        }
                        let _e442 = global.member_7;
                        let _e445 = global.member_8;
                        let _e446 = ((_e442 - _e368) * _e445);
                        if (_e446 < 0f) {
                            phi_5044_ = (0.015625f / (1f - _e446));
                        } else {
                            if (_e446 > 1f) {
                                phi_5043_ = (1f - (0.015625f / _e446));
                            } else {
                                phi_5043_ = (0.015625f + (0.96875f * clamp(_e446, 0f, 1f)));
                            }
                            let _e455 = phi_5043_;
                            phi_5044_ = _e455;
                        }
                        let _e459 = phi_5044_;
                        let _e460 = (_e413 / _e415);
                        let _e468 = global.member[0u];
                        let _e471 = global.member[1u];
                        let _e476 = global.member_31;
                        let _e477 = (_e476 > 0u);
                        phi_3521_ = _e477;
                        if _e477 {
                            let _e479 = global.member_34;
                            let _e482 = global.member_29;
                            let _e489 = global.member_49;
                            switch bitcast<i32>(0u) {
                                default: {
                                    let _e496 = vec2(((sqrt((2f * log(max((max(255f, _e479) / _e482), 1f)))) * sqrt(_e489)) * ((((((1.2f * exp(min(max(max(_e260.x, _e260.y), _e260.z), 9f))) * sqrt(max(max(dot(_e370, _e370), dot(_e371, _e371)), dot(_e372, _e372)))) * length(vec3<f32>(_e460.x, _e460.y, 1f))) * max(_e468, _e471)) / _e368) + 0.5477226f)));
                                    let _e499 = global.member_32;
                                    let _e502 = global.member_33;
                                    let _e510 = vec2<u32>(clamp(((((_e419 - _e496) - _e499) * _e502) - vec2<f32>(0.5f, 0.5f)), vec2<f32>(0f, 0f), vec2<f32>(191f, 191f)));
                                    let _e512 = vec2<u32>(clamp(((((_e419 + _e496) - _e499) * _e502) + vec2<f32>(0.5f, 0.5f)), vec2<f32>(0f, 0f), vec2<f32>(191f, 191f)));
                                    let _e519 = max((_e512.x - _e510.x), (_e512.y - _e510.y));
                                    if (_e519 <= 3u) {
                                        phi_5048_ = 0u;
                                    } else {
                                        phi_5048_ = (bitcast<u32>(firstLeadingBit((_e519 - 1u))) - 1u);
                                    }
                                    let _e526 = phi_5048_;
                                    if !((_e526 < 4u)) {
                                        phi_5060_ = false;
                                        break;
                                    }
                                    let _e536 = vec2(_e526);
                                    let _e538 = (_e510 >> bitcast<vec2<u32>>(_e536));
                                    let _e540 = (_e512 >> bitcast<vec2<u32>>(_e536));
                                    let _e542 = (_e538.x & 4294967292u);
                                    phi_5055_ = 0f;
                                    phi_5054_ = _e538.y;
                                    phi_5051_ = _e542;
                                    loop {
                                        let _e545 = phi_5055_;
                                        let _e547 = phi_5054_;
                                        let _e549 = phi_5051_;
                                        let _e552 = (vec4(f32(_e549)) + vec4<f32>(0f, 1f, 2f, 3f));
                                        let _e570 = global_3.member[((_e476 >> bitcast<u32>(1u)) + ((((4u * (12288u - (12288u >> bitcast<u32>((2u * _e526))))) + (_e547 * (192u >> bitcast<u32>(_e526)))) + _e549) >> bitcast<u32>(2u)))];
                                        let _e572 = unpack2x16unorm(_e570.x);
                                        let _e574 = unpack2x16unorm(_e570.y);
                                        let _e581 = select(select(vec4<f32>(_e572.x, _e572.y, _e574.x, _e574.y), vec4<f32>(0f, 0f, 0f, 0f), (_e552 < vec4(f32(_e538.x)))), vec4<f32>(0f, 0f, 0f, 0f), (_e552 > vec4(f32(_e540.x))));
                                        let _e589 = max(_e545, max(max(_e581.x, _e581.y), max(_e581.z, _e581.w)));
                                        let _e590 = (_e549 + 4u);
                                        let _e591 = (_e590 > _e540.x);
                                        let _e594 = (_e547 + select(0u, 1u, _e591));
                                        phi_5055_ = _e589;
                                        phi_5054_ = _e594;
                                        phi_5051_ = select(_e590, _e542, _e591);
                                        local_1 = _e589;
                                        if (_e594 <= _e540.y) {
                                            continue;
                                        } else {
                                            break;
                                        }
                                    }
                                    let _e598 = local_1;
                                    phi_5060_ = ((1f - _e459) > _e598);
                                    break;
                                }
                            }
                            let _e601 = phi_5060_;
                            phi_3521_ = _e601;
                        }
                        let _e603 = phi_3521_;
                        if _e603 {
                            let _e605 = global_2.member_9;
                            if (_e605 != 0u) {
                                let _e609 = atomicAdd((&global_1.member[1u]), 1u);
                            }
                            phi_5071_ = _e459;
                            phi_5062_ = _e419;
                            phi_5061_ = false;
                            break;
                        }
                        phi_5071_ = _e459;
                        phi_5062_ = _e419;
                        phi_5061_ = true;
                        break;
                    }
                }
                let _e611 = phi_5071_;
                let _e613 = phi_5062_;
                let _e615 = phi_5061_;
                if (true && !(_e615)) {
                    phi_5141_ = 4294967295u;
                    break;
                }
                let _e622 = global_7.member[((3u * _e78) + _e82)];
                let _e626 = f32((_e622.y >> bitcast<u32>(24u)));
                let _e628 = global.member_29;
                if (_e626 <= _e628) {
                    let _e631 = global_2.member_9;
                    if (_e631 != 0u) {
                        let _e635 = atomicAdd((&global_1.member[2u]), 1u);
                    }
                    phi_5141_ = 4294967295u;
                    break;
                }
                let _e649 = ((vec3<f32>(f32((_e622.x & 1023u)), f32(((_e622.x >> bitcast<u32>(10u)) & 1023u)), f32(((_e622.x >> bitcast<u32>(20u)) & 1023u))) - vec3<f32>(512f, 512f, 512f)) * vec3<f32>(0.0013888889f, 0.0013888889f, 0.0013888889f));
                let _e653 = sqrt(max((1f - dot(_e649, _e649)), 0f));
                let _e655 = (_e622.x >> bitcast<u32>(30u));
                if (_e655 == 0u) {
                    phi_5083_ = vec4<f32>(_e653, _e649.x, _e649.y, _e649.z);
                } else {
                    if (_e655 == 1u) {
                        phi_5082_ = vec4<f32>(_e649.x, _e653, _e649.y, _e649.z);
                    } else {
                        if (_e655 == 2u) {
                            phi_5081_ = vec4<f32>(_e649.x, _e649.y, _e653, _e649.z);
                        } else {
                            phi_5081_ = vec4<f32>(_e649.x, _e649.y, _e649.z, _e653);
                        }
                        let _e668 = phi_5081_;
                        phi_5082_ = _e668;
                    }
                    let _e674 = phi_5082_;
                    phi_5083_ = _e674;
                }
                let _e680 = phi_5083_;
                let _e684 = global.member_38;
                let _e685 = (_e684 > 0u);
                phi_5101_ = unpack4x8unorm(_e622.y).xyz;
                if _e685 {
                    let _e689 = global_7.member[(_e684 + _e82)];
                    let _e691 = unpack2x16float(_e689.x);
                    phi_5101_ = vec3<f32>(_e691.x, _e691.y, unpack2x16float(_e689.y).x);
                }
                let _e699 = phi_5101_;
                let _e702 = (1u << bitcast<u32>((_e82 & 31u)));
                let _e705 = global_7.member[_e86];
                let _e709 = global_7.member[(_e86 + 1u)];
                let _e713 = global_7.member[(_e86 + 2u)];
                phi_5118_ = _e680;
                if ((_e705.x & _e702) != 0u) {
                    let _e724 = global.member_22;
                    let _e726 = global.member_18;
                    let _e730 = (_e724 + ((_e709.y + bitcast<u32>(countOneBits((_e705.x & (_e702 - 1u))))) * (1u + (4u * _e726))));
                    let _e731 = (_e730 + 1u);
                    let _e734 = global_6.member[_e730];
                    let _e736 = global.member_44;
                    let _e740 = global.member_19;
                    phi_5103_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_5102_ = 0u;
                    loop {
                        let _e744 = phi_5103_;
                        let _e746 = phi_5102_;
                        let _e748 = (2u * ((_e736 + ((_e734 >> bitcast<u32>(16u)) * _e740)) + _e746));
                        let _e751 = global_3.member[_e748];
                        let _e755 = global_3.member[(_e748 + 1u)];
                        let _e761 = bitcast<vec4<f32>>(vec4<u32>(_e751.x, _e751.y, _e755.x, _e755.y));
                        let _e765 = global_6.member[(_e731 + _e746)];
                        let _e772 = global_6.member[((_e731 + _e726) + _e746)];
                        let _e780 = global_6.member[((_e731 + (2u * _e726)) + _e746)];
                        let _e788 = global_6.member[((_e731 + (3u * _e726)) + _e746)];
                        let _e792 = (_e744 + vec4<f32>(dot(unpack4x8snorm(_e765), _e761), dot(unpack4x8snorm(_e772), _e761), dot(unpack4x8snorm(_e780), _e761), dot(unpack4x8snorm(_e788), _e761)));
                        let _e794 = (_e746 + bitcast<u32>(1i));
                        phi_5103_ = _e792;
                        phi_5102_ = _e794;
                        local_2 = _e792;
                        if (_e794 < _e726) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e800 = local_2;
                    let _e802 = (_e680 + (_e800 * (127f * unpack2x16float(_e734).x)));
                    phi_5118_ = select(_e680, _e802, vec4((length(_e802) >= 0.001f)));
                }
                let _e808 = phi_5118_;
                phi_5122_ = _e260;
                if ((_e705.y & _e702) != 0u) {
                    let _e819 = global.member_23;
                    let _e821 = global.member_18;
                    let _e825 = (_e819 + ((_e713.x + bitcast<u32>(countOneBits((_e705.y & (_e702 - 1u))))) * (1u + (3u * _e821))));
                    let _e826 = (_e825 + 1u);
                    let _e829 = global_6.member[_e825];
                    let _e831 = global.member_44;
                    let _e835 = global.member_19;
                    phi_5106_ = vec3<f32>(0f, 0f, 0f);
                    phi_5105_ = 0u;
                    loop {
                        let _e839 = phi_5106_;
                        let _e841 = phi_5105_;
                        let _e843 = (2u * ((_e831 + ((_e829 >> bitcast<u32>(16u)) * _e835)) + _e841));
                        let _e846 = global_3.member[_e843];
                        let _e850 = global_3.member[(_e843 + 1u)];
                        let _e856 = bitcast<vec4<f32>>(vec4<u32>(_e846.x, _e846.y, _e850.x, _e850.y));
                        let _e860 = global_6.member[(_e826 + _e841)];
                        let _e867 = global_6.member[((_e826 + _e821) + _e841)];
                        let _e875 = global_6.member[((_e826 + (2u * _e821)) + _e841)];
                        let _e879 = (_e839 + vec3<f32>(dot(unpack4x8snorm(_e860), _e856), dot(unpack4x8snorm(_e867), _e856), dot(unpack4x8snorm(_e875), _e856)));
                        let _e881 = (_e841 + bitcast<u32>(1i));
                        phi_5106_ = _e879;
                        phi_5105_ = _e881;
                        local_3 = _e879;
                        if (_e881 < _e821) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e887 = local_3;
                    phi_5122_ = (_e260 + (_e887 * (127f * unpack2x16float(_e829).x)));
                }
                let _e891 = phi_5122_;
                phi_5124_ = _e699;
                if ((_e709.x & _e702) != 0u) {
                    let _e902 = global.member_24;
                    let _e904 = global.member_18;
                    let _e908 = (_e902 + ((_e713.y + bitcast<u32>(countOneBits((_e709.x & (_e702 - 1u))))) * (3u + (3u * _e904))));
                    let _e912 = global_6.member[(_e908 + 1u)];
                    let _e913 = unpack2x16float(_e912);
                    let _e917 = global_6.member[(_e908 + 2u)];
                    let _e925 = (_e908 + 3u);
                    let _e928 = global_6.member[_e908];
                    let _e930 = global.member_44;
                    let _e934 = global.member_19;
                    phi_5115_ = vec3<f32>(0f, 0f, 0f);
                    phi_5114_ = 0u;
                    loop {
                        let _e938 = phi_5115_;
                        let _e940 = phi_5114_;
                        let _e942 = (2u * ((_e930 + ((_e928 >> bitcast<u32>(16u)) * _e934)) + _e940));
                        let _e945 = global_3.member[_e942];
                        let _e949 = global_3.member[(_e942 + 1u)];
                        let _e955 = bitcast<vec4<f32>>(vec4<u32>(_e945.x, _e945.y, _e949.x, _e949.y));
                        let _e959 = global_6.member[(_e925 + _e940)];
                        let _e966 = global_6.member[((_e925 + _e904) + _e940)];
                        let _e974 = global_6.member[((_e925 + (2u * _e904)) + _e940)];
                        let _e978 = (_e938 + vec3<f32>(dot(unpack4x8snorm(_e959), _e955), dot(unpack4x8snorm(_e966), _e955), dot(unpack4x8snorm(_e974), _e955)));
                        let _e980 = (_e940 + bitcast<u32>(1i));
                        phi_5115_ = _e978;
                        phi_5114_ = _e980;
                        local_4 = _e978;
                        if (_e980 < _e904) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e986 = local_4;
                    phi_5124_ = (select(vec3<f32>(_e913.x, _e913.y, unpack2x16float(_e917).x), _e699, vec3(_e685)) + (_e986 * (127f * unpack2x16float(_e928).x)));
                }
                let _e990 = phi_5124_;
                let _e991 = normalize(_e808);
                let _e996 = (_e991.z * _e991.z);
                let _e997 = (_e991.w * _e991.w);
                let _e1001 = (_e991.y * _e991.z);
                let _e1002 = (_e991.x * _e991.w);
                let _e1005 = (_e991.y * _e991.w);
                let _e1006 = (_e991.x * _e991.z);
                let _e1011 = (_e991.y * _e991.y);
                let _e1015 = (_e991.z * _e991.w);
                let _e1016 = (_e991.x * _e991.y);
                let _e1030 = exp(min(_e891, vec3<f32>(9f, 9f, 9f)));
                let _e1037 = mat3x3<f32>((vec3<f32>((1f - (2f * (_e996 + _e997))), (2f * (_e1001 + _e1002)), (2f * (_e1005 - _e1006))) * _e1030.x), (vec3<f32>((2f * (_e1001 - _e1002)), (1f - (2f * (_e1011 + _e997))), (2f * (_e1015 + _e1016))) * _e1030.y), (vec3<f32>((2f * (_e1005 + _e1006)), (2f * (_e1015 - _e1016)), (1f - (2f * (_e1011 + _e996)))) * _e1030.z));
                switch bitcast<i32>(0u) {
                    default: {
                        let _e1043 = global.member_2;
                        let _e1045 = global.member_3;
                        let _e1046 = clamp((_e369.xy / vec2(_e368)), _e1043, _e1045);
                        let _e1049 = global.member[0u];
                        let _e1055 = (((vec3<f32>(_e353.x, _e353.y, _e353.z) - (_e384 * _e1046.x)) * (_e1049 / _e368)) * _e1037);
                        let _e1058 = global.member[1u];
                        let _e1064 = (((vec3<f32>(_e359.x, _e359.y, _e359.z) - (_e384 * _e1046.y)) * (_e1058 / _e368)) * _e1037);
                        let _e1066 = (dot(_e1055, _e1055) + 0.3f);
                        let _e1069 = (dot(_e1064, _e1064) + 0.3f);
                        let _e1071 = cross(_e1055, _e1064);
                        let _e1076 = (dot(_e1071, _e1071) + (0.3f * ((_e1066 + _e1069) - 0.3f)));
                        let _e1077 = (_e1076 > 0f);
                        phi_4549_ = _e1077;
                        if _e1077 {
                            phi_4549_ = (_e1066 <= 1000000000000000000f);
                        }
                        let _e1080 = phi_4549_;
                        phi_4555_ = _e1080;
                        if _e1080 {
                            phi_4555_ = (_e1069 <= 1000000000000000000f);
                        }
                        let _e1083 = phi_4555_;
                        if !(_e1083) {
                            let _e1086 = global_2.member_9;
                            if (_e1086 != 0u) {
                                let _e1090 = atomicAdd((&global_1.member[3u]), 1u);
                            }
                            phi_5140_ = 4294967295u;
                            break;
                        }
                        let _e1092 = global.member_49;
                        let _e1093 = (vec3<f32>(_e1066, dot(_e1055, _e1064), _e1069) * _e1092);
                        phi_5132_ = (1f - (_e626 * 0.003921569f));
                        phi_5131_ = 0u;
                        loop {
                            let _e1099 = phi_5132_;
                            let _e1101 = phi_5131_;
                            local_5 = _e1099;
                            if (_e1101 < _e80) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                phi_5132_ = (_e1099 * _e1099);
                                phi_5131_ = (_e1101 + bitcast<u32>(1i));
                            }
                        }
                        let _e1107 = local_5;
                        let _e1111 = u32(round((255f * (1f - _e1107))));
                        let _e1114 = global.member_34;
                        let _e1123 = (sqrt(_e1093.xz) * sqrt((2f * log(max((max(f32(_e1111), _e1114) / _e628), 1f)))));
                        let _e1126 = all(((_e613 + _e1123) > vec2<f32>(0f, 0f)));
                        phi_4593_ = _e1126;
                        if _e1126 {
                            let _e1129 = global.member_4;
                            phi_4593_ = all(((_e613 - _e1123) < _e1129));
                        }
                        let _e1133 = phi_4593_;
                        if !(_e1133) {
                            let _e1136 = global_2.member_9;
                            if (_e1136 != 0u) {
                                let _e1140 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_5140_ = 4294967295u;
                            break;
                        }
                        let _e1145 = (0.5f * (_e1093.x - _e1093.z));
                        let _e1150 = sqrt(((_e1145 * _e1145) + (_e1093.y * _e1093.y)));
                        let _e1153 = ((0.5f * (_e1093.x + _e1093.z)) + _e1150);
                        if (_e1145 >= 0f) {
                            phi_5138_ = vec2<f32>((_e1145 + _e1150), _e1093.y);
                        } else {
                            phi_5138_ = vec2<f32>(_e1093.y, (_e1150 - _e1145));
                        }
                        let _e1160 = phi_5138_;
                        let _e1161 = length(_e1160);
                        if (_e1161 > 0f) {
                            phi_5139_ = (_e1160 / vec2(_e1161));
                        } else {
                            phi_5139_ = vec2<f32>(1f, 0f);
                        }
                        let _e1166 = phi_5139_;
                        let _e1173 = global.member_5;
                        let _e1177 = global.member_10;
                        let _e1181 = vec2<u32>(clamp(round(((_e613 + vec2(_e1173)) * _e1177)), vec2<f32>(0f, 0f), vec2<f32>(1048575f, 1048575f)));
                        let _e1184 = vec3<u32>(round((clamp(_e990, vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 1023f)));
                        let _e1212 = global.member_45;
                        let _e1214 = (4u * (_e1212 + _e72));
                        global_4.member[_e1214] = ((_e1181.x | (_e1184.x << bitcast<u32>(20u))) | (_e1184.z << bitcast<u32>(30u)));
                        global_4.member[(_e1214 + 1u)] = (_e1181.y | (_e1184.y << bitcast<u32>(20u)));
                        global_4.member[(_e1214 + 2u)] = pack2x16float((_e1166 * min(sqrt(_e1153), 65504f)));
                        global_4.member[(_e1214 + 3u)] = ((pack2x16float(vec2<f32>(min(sqrt(((_e1076 * (_e1092 * _e1092)) / _e1153)), 65504f), 0f)) | (_e1111 << bitcast<u32>(16u))) | ((_e1184.z >> bitcast<u32>(2u)) << bitcast<u32>(24u)));
                        let _e1227 = global.member_9;
                        phi_5140_ = min(u32((_e611 * f32(_e1227))), _e1227);
                        break;
                    }
                }
                let _e1233 = phi_5140_;
                phi_5141_ = _e1233;
                break;
            }
        }
        let _e1235 = phi_5141_;
        phi_5142_ = _e1235;
    } else {
        phi_5142_ = 4294967295u;
    }
    let _e1237 = phi_5142_;
    switch bitcast<i32>(0u) {
        default: {
            let _e1240 = bitcast<u32>(param[0u]);
            let _e1242 = global.member_45;
            let _e1243 = (_e1242 + _e72);
            if (_e1237 != 4294967295u) {
                let _e1246 = global.member_41;
                let _e1250 = global.member_40;
                let _e1256 = atomicAdd((&global_1.member[((_e1250 + ((_e1243 / _e1246) * 256u)) + (_e1237 & 255u))]), 1u);
            }
            let _e1258 = global.member_39;
            if (_e1258 == 0u) {
                if (_e72 < (_e74 + (_e74 & 1u))) {
                    let _e1264 = global.member_28;
                    global_4.member[(_e1264 + _e1243)] = _e1237;
                }
                break;
            }
            global_5[_e1240] = _e1237;
            workgroupBarrier();
            let _e1270 = ((_e1240 & 1u) == 0u);
            if select(_e1270, _e75, _e1270) {
                let _e1273 = global.member_28;
                let _e1280 = global_5[(_e1240 + 1u)];
                global_4.member[(_e1273 + (_e1243 >> bitcast<u32>(1u)))] = ((_e1237 & 65535u) | (_e1280 << bitcast<u32>(16u)));
            }
            break;
        }
    }
    return;
}
