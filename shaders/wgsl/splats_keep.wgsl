struct type_15 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_19 {
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
    member_47: vec4<f32>,
    member_48: vec4<f32>,
    member_49: array<vec4<f32>, 3>,
    member_50: array<vec4<u32>, 8>,
    member_51: array<vec4<u32>, 8>,
    member_52: array<type_15, 8>,
    member_53: array<vec4<f32>, 128>,
    member_54: array<vec4<f32>, 768>,
}

struct type_26 {
    member: array<u32>,
}

struct type_30 {
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

struct type_33 {
    member: array<vec2<u32>>,
}

struct type_47 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<uniform> global: type_19;
@group(0) @binding(6) 
var<storage, read_write> global_1: type_47;
@group(0) @binding(7) 
var<uniform> global_2: type_30;
@group(0) @binding(3) 
var<storage> global_3: type_33;
@group(0) @binding(4) 
var<storage, read_write> global_4: type_26;
var<private> global_5: vec3<u32>;
var<workgroup> global_6: array<u32, 64>;
@group(0) @binding(2) 
var<storage> global_7: type_26;
@group(0) @binding(1) 
var<storage> global_8: type_33;
var<private> global_9: vec3<u32>;

fn function_() {
    var local: vec4<u32>;
    var local_1: vec4<u32>;
    var local_2: vec4<f32>;
    var phi_5239_: vec4<f32>;
    var phi_5238_: vec4<f32>;
    var phi_5237_: vec4<f32>;
    var phi_5236_: u32;
    var local_3: vec4<f32>;
    var local_4: vec4<f32>;
    var local_5: vec4<f32>;
    var local_6: vec4<f32>;
    var local_7: vec4<f32>;
    var local_8: vec4<f32>;
    var local_9: vec4<f32>;
    var local_10: vec4<f32>;
    var local_11: vec4<f32>;
    var local_12: vec4<f32>;
    var local_13: vec4<f32>;
    var local_14: vec4<f32>;
    var local_15: vec4<f32>;
    var local_16: vec4<f32>;
    var local_17: vec4<f32>;
    var local_18: vec4<f32>;
    var local_19: vec4<f32>;
    var local_20: vec4<f32>;
    var phi_3138_: bool;
    var phi_5241_: f32;
    var phi_5242_: f32;
    var phi_5246_: u32;
    var phi_5251_: f32;
    var phi_5249_: u32;
    var phi_5256_: f32;
    var phi_5253_: u32;
    var local_21: f32;
    var phi_5257_: bool;
    var phi_3180_: bool;
    var phi_5268_: f32;
    var phi_5259_: vec2<f32>;
    var phi_5258_: bool;
    var phi_5278_: vec4<f32>;
    var phi_5279_: vec4<f32>;
    var phi_5280_: vec4<f32>;
    var phi_5298_: vec3<f32>;
    var phi_5300_: f32;
    var phi_5299_: u32;
    var phi_5302_: f32;
    var phi_5301_: u32;
    var phi_5304_: f32;
    var phi_5303_: u32;
    var local_22: f32;
    var local_23: f32;
    var local_24: f32;
    var phi_5306_: f32;
    var phi_5305_: u32;
    var local_25: f32;
    var phi_5342_: vec4<f32>;
    var phi_5312_: f32;
    var phi_5311_: u32;
    var phi_5314_: f32;
    var phi_5313_: u32;
    var phi_5316_: f32;
    var phi_5315_: u32;
    var local_26: f32;
    var local_27: f32;
    var local_28: f32;
    var phi_5350_: vec3<f32>;
    var phi_5335_: f32;
    var phi_5334_: u32;
    var phi_5337_: f32;
    var phi_5336_: u32;
    var phi_5339_: f32;
    var phi_5338_: u32;
    var local_29: f32;
    var local_30: f32;
    var local_31: f32;
    var phi_5354_: vec3<f32>;
    var phi_5355_: vec3<f32>;
    var phi_5357_: vec3<f32>;
    var phi_5359_: vec3<f32>;
    var phi_2832_: bool;
    var phi_2846_: bool;
    var phi_4787_: bool;
    var phi_4793_: bool;
    var phi_4818_: bool;
    var phi_5370_: vec2<f32>;
    var phi_5371_: vec2<f32>;
    var phi_5372_: u32;
    var phi_5373_: u32;
    var phi_5374_: u32;
    var phi_5375_: u32;
    var local_32: f32;

    let _e138 = global_9[0u];
    let _e140 = global.member_14;
    let _e141 = (_e138 < _e140);
    if _e141 {
        switch bitcast<i32>(0u) {
            default: {
                let _e145 = (4u * (_e140 + (_e138 / 32u)));
                let _e146 = (2u * _e138);
                let _e149 = global_8.member[_e146];
                let _e153 = global_8.member[(_e146 + 1u)];
                let _e154 = (2u * _e140);
                let _e158 = global_8.member[(_e154 + _e138)];
                let _e169 = (vec2<f32>(f32(((_e158.y >> bitcast<u32>(16u)) & 31u)), f32(((_e158.y >> bitcast<u32>(21u)) & 31u))) * vec2<f32>(0.032258064f, 0.032258064f));
                let _e173 = ((1f + (2f * _e169.x)) * 0.33333334f);
                let _e174 = (1f - _e173);
                let _e178 = (_e174 * (0.5f + (0.5f * _e169.y)));
                let _e186 = global.member_11;
                let _e189 = global.member_12;
                let _e204 = global.member_21;
                let _e205 = (2u * _e204);
                let _e209 = global_3.member[(_e205 + (_e158.x & 65535u))];
                let _e211 = unpack2x16float(_e209.x);
                let _e223 = global_3.member[(_e205 + (_e158.x >> bitcast<u32>(16u)))];
                let _e225 = unpack2x16float(_e223.x);
                let _e237 = global_3.member[(_e205 + (_e158.y & 65535u))];
                let _e239 = unpack2x16float(_e237.x);
                let _e247 = ((((_e186.xyz + (_e189.xyz * vec3<f32>(f32((_e149.x & 65535u)), f32((_e149.x >> bitcast<u32>(16u))), f32((_e149.y & 65535u))))) + (vec3<f32>(_e211.x, _e211.y, unpack2x16float(_e209.y).x) * _e173)) + (vec3<f32>(_e225.x, _e225.y, unpack2x16float(_e223.y).x) * _e178)) + (vec3<f32>(_e239.x, _e239.y, unpack2x16float(_e237.y).x) * (_e174 - _e178)));
                let _e251 = vec4<f32>(_e247.x, _e247.y, _e247.z, 1f);
                let _e264 = (((_e149.y >> bitcast<u32>(16u)) | ((_e153.y >> bitcast<u32>(24u)) << bitcast<u32>(16u))) | ((_e158.y >> bitcast<u32>(26u)) << bitcast<u32>(24u)));
                let _e266 = global.member_36;
                let _e268 = global.member_37;
                let _e281 = (vec3(_e266) + (vec3<f32>(f32((_e264 & 1023u)), f32(((_e264 >> bitcast<u32>(10u)) & 1023u)), f32((_e264 >> bitcast<u32>(20u)))) * _e268));
                local_1 = (vec4<u32>(_e153.x, (_e153.x >> bitcast<u32>(8u)), (_e153.x >> bitcast<u32>(16u)), (_e153.x >> bitcast<u32>(24u))) & vec4<u32>(255u, 255u, 255u, 255u));
                let _e296 = (vec3<u32>(_e153.y, (_e153.y >> bitcast<u32>(8u)), (_e153.y >> bitcast<u32>(16u))) & vec3<u32>(255u, 255u, 255u));
                let _e297 = vec3<f32>(_e296);
                local_2 = (vec4<f32>(_e297.x, _e297.y, _e297.z, f32((((255u - _e296.x) - _e296.y) - _e296.z))) * vec4<f32>(0.003921569f, 0.003921569f, 0.003921569f, 0.003921569f));
                phi_5239_ = vec4<f32>(0f, 0f, 0f, 0f);
                phi_5238_ = vec4<f32>(0f, 0f, 0f, 0f);
                phi_5237_ = vec4<f32>(0f, 0f, 0f, 0f);
                phi_5236_ = 0u;
                loop {
                    let _e311 = phi_5239_;
                    let _e313 = phi_5238_;
                    let _e315 = phi_5237_;
                    let _e317 = phi_5236_;
                    local_3 = _e315;
                    local_4 = _e313;
                    local_5 = _e311;
                    local_6 = _e315;
                    local_7 = _e315;
                    local_8 = _e313;
                    local_9 = _e313;
                    local_10 = _e311;
                    local_11 = _e311;
                    local_12 = _e315;
                    local_13 = _e315;
                    local_14 = _e315;
                    local_15 = _e313;
                    local_16 = _e313;
                    local_17 = _e313;
                    local_18 = _e311;
                    local_19 = _e311;
                    local_20 = _e311;
                    if (_e317 < 4u) {
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e320 = local_1[_e317];
                        let _e321 = (3u * _e320);
                        let _e323 = local_2[_e317];
                        let _e326 = global.member_54[_e321];
                        let _e329 = local_2[_e317];
                        let _e333 = global.member_54[(_e321 + 1u)];
                        let _e336 = local_2[_e317];
                        let _e340 = global.member_54[(_e321 + 2u)];
                        phi_5239_ = (_e311 + (_e340 * _e336));
                        phi_5238_ = (_e313 + (_e333 * _e329));
                        phi_5237_ = (_e315 + (_e326 * _e323));
                        phi_5236_ = (_e317 + bitcast<u32>(1i));
                    }
                }
                let _e346 = local_3;
                let _e349 = local_4;
                let _e352 = local_5;
                let _e353 = dot(_e352, _e251);
                let _e354 = vec3<f32>(dot(_e346, _e251), dot(_e349, _e251), _e353);
                let _e356 = local_6;
                let _e359 = _e356.xyz;
                let _e361 = local_8;
                let _e364 = _e361.xyz;
                let _e366 = local_10;
                let _e369 = _e366.xyz;
                let _e371 = local_12;
                let _e374 = local_13;
                let _e377 = local_14;
                let _e380 = local_15;
                let _e383 = local_16;
                let _e386 = local_17;
                let _e389 = local_18;
                let _e392 = local_19;
                let _e395 = local_20;
                let _e397 = vec3<f32>(_e371.x, _e374.y, _e377.z);
                let _e398 = vec3<f32>(_e380.x, _e383.y, _e386.z);
                let _e399 = vec3<f32>(_e389.x, _e392.y, _e395.z);
                let _e415 = ((1.2f * exp(min(max(max(_e281.x, _e281.y), _e281.z), 9f))) * sqrt(max(max(dot(_e359, _e359), dot(_e364, _e364)), dot(_e369, _e369))));
                switch bitcast<i32>(0u) {
                    default: {
                        let _e418 = global.member_6;
                        if !((_e353 >= _e418)) {
                            let _e422 = global_2.member_9;
                            if (_e422 != 0u) {
                                let _e426 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_5268_ = 0f;
                            phi_5259_ = vec2<f32>(0f, 0f);
                            phi_5258_ = false;
                            break;
                        }
                        let _e428 = global.member;
                        let _e429 = _e354.xy;
                        let _e431 = vec2(_e353);
                        let _e434 = global.member_1;
                        let _e435 = (((_e428 * _e429) / _e431) + _e434);
                        let _e437 = global.member_5;
                        let _e441 = all((_e435 >= vec2(-(_e437))));
                        phi_3138_ = _e441;
                        if _e441 {
                            let _e443 = global.member_4;
                            phi_3138_ = all((_e435 <= (_e443 + vec2(_e437))));
                        }
                        let _e449 = phi_3138_;
                        if !(_e449) {
                            let _e452 = global_2.member_9;
                            if (_e452 != 0u) {
                                let _e456 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_5268_ = 0f;
                            phi_5259_ = _e435;
                            phi_5258_ = false;
                            break;
                        }
                        let _e458 = global.member_7;
                        let _e461 = global.member_8;
                        let _e462 = ((_e458 - _e353) * _e461);
                        if (_e462 < 0f) {
                            phi_5242_ = (0.015625f / (1f - _e462));
                        } else {
                            if (_e462 > 1f) {
                                phi_5241_ = (1f - (0.015625f / _e462));
                            } else {
                                phi_5241_ = (0.015625f + (0.96875f * clamp(_e462, 0f, 1f)));
                            }
                            let _e471 = phi_5241_;
                            phi_5242_ = _e471;
                        }
                        let _e475 = phi_5242_;
                        let _e476 = (_e429 / _e431);
                        let _e484 = global.member[0u];
                        let _e487 = global.member[1u];
                        let _e492 = global.member_31;
                        let _e493 = (_e492 > 0u);
                        phi_3180_ = _e493;
                        if _e493 {
                            let _e495 = global.member_34;
                            let _e498 = global.member_29;
                            switch bitcast<i32>(0u) {
                                default: {
                                    let _e508 = vec2((sqrt((2f * log(max((max(255f, _e495) / _e498), 1f)))) * ((((_e415 * length(vec3<f32>(_e476.x, _e476.y, 1f))) * max(_e484, _e487)) / _e353) + 0.5477226f)));
                                    let _e511 = global.member_32;
                                    let _e514 = global.member_33;
                                    let _e518 = vec2<u32>(clamp(((((_e435 - _e508) - _e511) * _e514) - vec2<f32>(0.5f, 0.5f)), vec2<f32>(0f, 0f), vec2<f32>(191f, 191f)));
                                    let _e524 = vec2<u32>(clamp(((((_e435 + _e508) - _e511) * _e514) + vec2<f32>(0.5f, 0.5f)), vec2<f32>(0f, 0f), vec2<f32>(191f, 191f)));
                                    let _e531 = max((_e524.x - _e518.x), (_e524.y - _e518.y));
                                    if (_e531 <= 3u) {
                                        phi_5246_ = 0u;
                                    } else {
                                        phi_5246_ = (bitcast<u32>(firstLeadingBit((_e531 - 1u))) - 1u);
                                    }
                                    let _e538 = phi_5246_;
                                    if !((_e538 < 4u)) {
                                        phi_5257_ = false;
                                        break;
                                    }
                                    let _e547 = vec2(_e538);
                                    let _e549 = (_e518 >> bitcast<vec2<u32>>(_e547));
                                    let _e551 = (_e524 >> bitcast<vec2<u32>>(_e547));
                                    phi_5251_ = 0f;
                                    phi_5249_ = _e549.y;
                                    loop {
                                        let _e554 = phi_5251_;
                                        let _e556 = phi_5249_;
                                        local_21 = _e554;
                                        if (_e556 <= _e551.y) {
                                            phi_5256_ = _e554;
                                            phi_5253_ = _e549.x;
                                            loop {
                                                let _e561 = phi_5256_;
                                                let _e563 = phi_5253_;
                                                local_32 = _e561;
                                                if (_e563 <= _e551.x) {
                                                    continue;
                                                } else {
                                                    break;
                                                }
                                                continuing {
                                                    let _e570 = (((49152u - (((36864u >> bitcast<u32>((2u * _e538))) / 3u) * 4u)) + (_e556 * (192u >> bitcast<u32>(_e538)))) + _e563);
                                                    let _e572 = (_e492 + (_e570 / 2u));
                                                    let _e578 = global_3.member[(_e572 / 2u)][(_e572 & 1u)];
                                                    phi_5256_ = max(_e561, (f32(((_e578 >> bitcast<u32>((16u * (_e570 & 1u)))) & 65535u)) * 0.000015259022f));
                                                    phi_5253_ = (_e563 + bitcast<u32>(1i));
                                                }
                                            }
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e1633 = local_32;
                                            phi_5251_ = _e1633;
                                            phi_5249_ = (_e556 + bitcast<u32>(1i));
                                        }
                                    }
                                    let _e592 = local_21;
                                    phi_5257_ = ((1f - _e475) > _e592);
                                    break;
                                }
                            }
                            let _e595 = phi_5257_;
                            phi_3180_ = _e595;
                        }
                        let _e597 = phi_3180_;
                        if _e597 {
                            let _e599 = global_2.member_9;
                            if (_e599 != 0u) {
                                let _e603 = atomicAdd((&global_1.member[1u]), 1u);
                            }
                            phi_5268_ = _e475;
                            phi_5259_ = _e435;
                            phi_5258_ = false;
                            break;
                        }
                        phi_5268_ = _e475;
                        phi_5259_ = _e435;
                        phi_5258_ = true;
                        break;
                    }
                }
                let _e605 = phi_5268_;
                let _e607 = phi_5259_;
                let _e609 = phi_5258_;
                let _e614 = global_8.member[((3u * _e140) + _e138)];
                let _e617 = (_e614.y >> bitcast<u32>(24u));
                let _e631 = ((vec3<f32>(f32((_e614.x & 1023u)), f32(((_e614.x >> bitcast<u32>(10u)) & 1023u)), f32(((_e614.x >> bitcast<u32>(20u)) & 1023u))) - vec3<f32>(512f, 512f, 512f)) * vec3<f32>(0.0013888889f, 0.0013888889f, 0.0013888889f));
                let _e635 = sqrt(max((1f - dot(_e631, _e631)), 0f));
                let _e637 = (_e614.x >> bitcast<u32>(30u));
                if (_e637 == 0u) {
                    phi_5280_ = vec4<f32>(_e635, _e631.x, _e631.y, _e631.z);
                } else {
                    if (_e637 == 1u) {
                        phi_5279_ = vec4<f32>(_e631.x, _e635, _e631.y, _e631.z);
                    } else {
                        if (_e637 == 2u) {
                            phi_5278_ = vec4<f32>(_e631.x, _e631.y, _e635, _e631.z);
                        } else {
                            phi_5278_ = vec4<f32>(_e631.x, _e631.y, _e631.z, _e635);
                        }
                        let _e650 = phi_5278_;
                        phi_5279_ = _e650;
                    }
                    let _e656 = phi_5279_;
                    phi_5280_ = _e656;
                }
                let _e662 = phi_5280_;
                let _e666 = global.member_38;
                let _e667 = (_e666 > 0u);
                phi_5298_ = unpack4x8unorm(_e614.y).xyz;
                if _e667 {
                    let _e671 = global_8.member[(_e666 + _e138)];
                    let _e673 = unpack2x16float(_e671.x);
                    phi_5298_ = vec3<f32>(_e673.x, _e673.y, unpack2x16float(_e671.y).x);
                }
                let _e681 = phi_5298_;
                let _e684 = (1u << bitcast<u32>((_e138 & 31u)));
                let _e687 = global_8.member[_e145];
                let _e691 = global_8.member[(_e145 + 1u)];
                let _e695 = global_8.member[(_e145 + 2u)];
                phi_5342_ = _e662;
                if ((_e687.x & _e684) != 0u) {
                    let _e700 = global.member_22;
                    let _e708 = global.member_18;
                    let _e712 = (_e700 + ((_e691.y + bitcast<u32>(countOneBits((_e687.x & (_e684 - 1u))))) * (1u + (4u * _e708))));
                    let _e713 = (_e712 + 1u);
                    let _e716 = global_7.member[_e712];
                    let _e718 = global.member_44;
                    let _e722 = global.member_19;
                    let _e724 = (_e718 + ((_e716 >> bitcast<u32>(16u)) * _e722));
                    let _e727 = (127f * unpack2x16float(_e716).x);
                    phi_5300_ = 0f;
                    phi_5299_ = 0u;
                    loop {
                        let _e729 = phi_5300_;
                        let _e731 = phi_5299_;
                        local_22 = _e729;
                        if (_e731 < _e708) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e736 = global_7.member[(_e713 + _e731)];
                            let _e739 = (2u * (_e724 + _e731));
                            let _e742 = global_3.member[_e739];
                            let _e746 = global_3.member[(_e739 + 1u)];
                            phi_5300_ = (_e729 + dot(unpack4x8snorm(_e736), bitcast<vec4<f32>>(vec4<u32>(_e742.x, _e742.y, _e746.x, _e746.y))));
                            phi_5299_ = (_e731 + bitcast<u32>(1i));
                        }
                    }
                    phi_5302_ = 0f;
                    phi_5301_ = 0u;
                    loop {
                        let _e759 = phi_5302_;
                        let _e761 = phi_5301_;
                        local_23 = _e759;
                        if (_e761 < _e708) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e766 = global_7.member[((_e713 + _e708) + _e761)];
                            let _e769 = (2u * (_e724 + _e761));
                            let _e772 = global_3.member[_e769];
                            let _e776 = global_3.member[(_e769 + 1u)];
                            phi_5302_ = (_e759 + dot(unpack4x8snorm(_e766), bitcast<vec4<f32>>(vec4<u32>(_e772.x, _e772.y, _e776.x, _e776.y))));
                            phi_5301_ = (_e761 + bitcast<u32>(1i));
                        }
                    }
                    phi_5304_ = 0f;
                    phi_5303_ = 0u;
                    loop {
                        let _e790 = phi_5304_;
                        let _e792 = phi_5303_;
                        local_24 = _e790;
                        if (_e792 < _e708) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e797 = global_7.member[((_e713 + (2u * _e708)) + _e792)];
                            let _e800 = (2u * (_e724 + _e792));
                            let _e803 = global_3.member[_e800];
                            let _e807 = global_3.member[(_e800 + 1u)];
                            phi_5304_ = (_e790 + dot(unpack4x8snorm(_e797), bitcast<vec4<f32>>(vec4<u32>(_e803.x, _e803.y, _e807.x, _e807.y))));
                            phi_5303_ = (_e792 + bitcast<u32>(1i));
                        }
                    }
                    let _e819 = local_22;
                    let _e821 = local_23;
                    let _e823 = local_24;
                    let _e825 = (vec3<f32>(_e819, _e821, _e823) * _e727);
                    phi_5306_ = 0f;
                    phi_5305_ = 0u;
                    loop {
                        let _e829 = phi_5306_;
                        let _e831 = phi_5305_;
                        local_25 = _e829;
                        if (_e831 < _e708) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e836 = global_7.member[((_e713 + (3u * _e708)) + _e831)];
                            let _e839 = (2u * (_e724 + _e831));
                            let _e842 = global_3.member[_e839];
                            let _e846 = global_3.member[(_e839 + 1u)];
                            phi_5306_ = (_e829 + dot(unpack4x8snorm(_e836), bitcast<vec4<f32>>(vec4<u32>(_e842.x, _e842.y, _e846.x, _e846.y))));
                            phi_5305_ = (_e831 + bitcast<u32>(1i));
                        }
                    }
                    let _e858 = local_25;
                    let _e864 = (_e662 + vec4<f32>(_e825.x, _e825.y, _e825.z, (_e727 * _e858)));
                    phi_5342_ = select(_e662, _e864, vec4((length(_e864) >= 0.001f)));
                }
                let _e870 = phi_5342_;
                phi_5350_ = _e281;
                if ((_e687.y & _e684) != 0u) {
                    let _e875 = global.member_23;
                    let _e883 = global.member_18;
                    let _e887 = (_e875 + ((_e695.x + bitcast<u32>(countOneBits((_e687.y & (_e684 - 1u))))) * (1u + (3u * _e883))));
                    let _e888 = (_e887 + 1u);
                    let _e891 = global_7.member[_e887];
                    let _e893 = global.member_44;
                    let _e897 = global.member_19;
                    let _e899 = (_e893 + ((_e891 >> bitcast<u32>(16u)) * _e897));
                    phi_5312_ = 0f;
                    phi_5311_ = 0u;
                    loop {
                        let _e904 = phi_5312_;
                        let _e906 = phi_5311_;
                        local_26 = _e904;
                        if (_e906 < _e883) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e911 = global_7.member[(_e888 + _e906)];
                            let _e914 = (2u * (_e899 + _e906));
                            let _e917 = global_3.member[_e914];
                            let _e921 = global_3.member[(_e914 + 1u)];
                            phi_5312_ = (_e904 + dot(unpack4x8snorm(_e911), bitcast<vec4<f32>>(vec4<u32>(_e917.x, _e917.y, _e921.x, _e921.y))));
                            phi_5311_ = (_e906 + bitcast<u32>(1i));
                        }
                    }
                    phi_5314_ = 0f;
                    phi_5313_ = 0u;
                    loop {
                        let _e934 = phi_5314_;
                        let _e936 = phi_5313_;
                        local_27 = _e934;
                        if (_e936 < _e883) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e941 = global_7.member[((_e888 + _e883) + _e936)];
                            let _e944 = (2u * (_e899 + _e936));
                            let _e947 = global_3.member[_e944];
                            let _e951 = global_3.member[(_e944 + 1u)];
                            phi_5314_ = (_e934 + dot(unpack4x8snorm(_e941), bitcast<vec4<f32>>(vec4<u32>(_e947.x, _e947.y, _e951.x, _e951.y))));
                            phi_5313_ = (_e936 + bitcast<u32>(1i));
                        }
                    }
                    phi_5316_ = 0f;
                    phi_5315_ = 0u;
                    loop {
                        let _e965 = phi_5316_;
                        let _e967 = phi_5315_;
                        local_28 = _e965;
                        if (_e967 < _e883) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e972 = global_7.member[((_e888 + (2u * _e883)) + _e967)];
                            let _e975 = (2u * (_e899 + _e967));
                            let _e978 = global_3.member[_e975];
                            let _e982 = global_3.member[(_e975 + 1u)];
                            phi_5316_ = (_e965 + dot(unpack4x8snorm(_e972), bitcast<vec4<f32>>(vec4<u32>(_e978.x, _e978.y, _e982.x, _e982.y))));
                            phi_5315_ = (_e967 + bitcast<u32>(1i));
                        }
                    }
                    let _e994 = local_26;
                    let _e996 = local_27;
                    let _e998 = local_28;
                    phi_5350_ = (_e281 + (vec3<f32>(_e994, _e996, _e998) * (127f * unpack2x16float(_e891).x)));
                }
                let _e1003 = phi_5350_;
                phi_5354_ = _e681;
                if ((_e691.x & _e684) != 0u) {
                    let _e1008 = global.member_24;
                    let _e1016 = global.member_18;
                    let _e1020 = (_e1008 + ((_e695.y + bitcast<u32>(countOneBits((_e691.x & (_e684 - 1u))))) * (3u + (3u * _e1016))));
                    let _e1024 = global_7.member[(_e1020 + 1u)];
                    let _e1025 = unpack2x16float(_e1024);
                    let _e1029 = global_7.member[(_e1020 + 2u)];
                    let _e1037 = (_e1020 + 3u);
                    let _e1040 = global_7.member[_e1020];
                    let _e1042 = global.member_44;
                    let _e1046 = global.member_19;
                    let _e1048 = (_e1042 + ((_e1040 >> bitcast<u32>(16u)) * _e1046));
                    phi_5335_ = 0f;
                    phi_5334_ = 0u;
                    loop {
                        let _e1053 = phi_5335_;
                        let _e1055 = phi_5334_;
                        local_29 = _e1053;
                        if (_e1055 < _e1016) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e1060 = global_7.member[(_e1037 + _e1055)];
                            let _e1063 = (2u * (_e1048 + _e1055));
                            let _e1066 = global_3.member[_e1063];
                            let _e1070 = global_3.member[(_e1063 + 1u)];
                            phi_5335_ = (_e1053 + dot(unpack4x8snorm(_e1060), bitcast<vec4<f32>>(vec4<u32>(_e1066.x, _e1066.y, _e1070.x, _e1070.y))));
                            phi_5334_ = (_e1055 + bitcast<u32>(1i));
                        }
                    }
                    phi_5337_ = 0f;
                    phi_5336_ = 0u;
                    loop {
                        let _e1083 = phi_5337_;
                        let _e1085 = phi_5336_;
                        local_30 = _e1083;
                        if (_e1085 < _e1016) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e1090 = global_7.member[((_e1037 + _e1016) + _e1085)];
                            let _e1093 = (2u * (_e1048 + _e1085));
                            let _e1096 = global_3.member[_e1093];
                            let _e1100 = global_3.member[(_e1093 + 1u)];
                            phi_5337_ = (_e1083 + dot(unpack4x8snorm(_e1090), bitcast<vec4<f32>>(vec4<u32>(_e1096.x, _e1096.y, _e1100.x, _e1100.y))));
                            phi_5336_ = (_e1085 + bitcast<u32>(1i));
                        }
                    }
                    phi_5339_ = 0f;
                    phi_5338_ = 0u;
                    loop {
                        let _e1114 = phi_5339_;
                        let _e1116 = phi_5338_;
                        local_31 = _e1114;
                        if (_e1116 < _e1016) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e1121 = global_7.member[((_e1037 + (2u * _e1016)) + _e1116)];
                            let _e1124 = (2u * (_e1048 + _e1116));
                            let _e1127 = global_3.member[_e1124];
                            let _e1131 = global_3.member[(_e1124 + 1u)];
                            phi_5339_ = (_e1114 + dot(unpack4x8snorm(_e1121), bitcast<vec4<f32>>(vec4<u32>(_e1127.x, _e1127.y, _e1131.x, _e1131.y))));
                            phi_5338_ = (_e1116 + bitcast<u32>(1i));
                        }
                    }
                    let _e1143 = local_29;
                    let _e1145 = local_30;
                    let _e1147 = local_31;
                    phi_5354_ = (select(vec3<f32>(_e1025.x, _e1025.y, unpack2x16float(_e1029).x), _e681, vec3(_e667)) + (vec3<f32>(_e1143, _e1145, _e1147) * (127f * unpack2x16float(_e1040).x)));
                }
                let _e1152 = phi_5354_;
                let _e1153 = normalize(_e870);
                let _e1158 = (_e1153.z * _e1153.z);
                let _e1159 = (_e1153.w * _e1153.w);
                let _e1163 = (_e1153.y * _e1153.z);
                let _e1164 = (_e1153.x * _e1153.w);
                let _e1167 = (_e1153.y * _e1153.w);
                let _e1168 = (_e1153.x * _e1153.z);
                let _e1173 = (_e1153.y * _e1153.y);
                let _e1177 = (_e1153.z * _e1153.w);
                let _e1178 = (_e1153.x * _e1153.y);
                let _e1192 = exp(min(_e1003, vec3<f32>(9f, 9f, 9f)));
                let _e1199 = mat3x3<f32>((vec3<f32>((1f - (2f * (_e1158 + _e1159))), (2f * (_e1163 + _e1164)), (2f * (_e1167 - _e1168))) * _e1192.x), (vec3<f32>((2f * (_e1163 - _e1164)), (1f - (2f * (_e1173 + _e1159))), (2f * (_e1177 + _e1178))) * _e1192.y), (vec3<f32>((2f * (_e1167 + _e1168)), (2f * (_e1177 - _e1178)), (1f - (2f * (_e1173 + _e1158)))) * _e1192.z));
                let _e1201 = (transpose(mat3x3<f32>(_e397, _e398, _e399)) * _e1199);
                let _e1203 = global.member_42;
                let _e1204 = (_e1203 + _e146);
                let _e1205 = transpose(_e1201);
                let _e1215 = max(_e415, sqrt(max(max(dot(_e1205[0], _e1205[0]), dot(_e1205[1], _e1205[1])), dot(_e1205[2], _e1205[2]))));
                let _e1217 = global.member_43;
                let _e1228 = (all((abs(_e354) < vec3<f32>(1000000000000000000000000000000f, 1000000000000000000000000000000f, 1000000000000000000000000000000f))) && (_e1215 <= 1000000000000000000f));
                if _e1228 {
                    let _e1230 = global.member_47;
                    let _e1234 = global.member_48;
                    phi_5355_ = ((_e354 - _e1230.xyz) / _e1234.xyz);
                } else {
                    phi_5355_ = vec3<f32>(0f, 0f, 0f);
                }
                let _e1238 = phi_5355_;
                let _e1255 = vec3<u32>(round((clamp(select(select((vec3<f32>(0.015625f, 0.015625f, 0.015625f) + (clamp(_e1238, vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 0.96875f)), (vec3<f32>(0.015625f, 0.015625f, 0.015625f) / (vec3<f32>(1f, 1f, 1f) - min(_e1238, vec3<f32>(0f, 0f, 0f)))), (_e1238 < vec3<f32>(0f, 0f, 0f))), (vec3<f32>(1f, 1f, 1f) - (vec3<f32>(0.015625f, 0.015625f, 0.015625f) / max(_e1238, vec3<f32>(1f, 1f, 1f)))), (_e1238 > vec3<f32>(1f, 1f, 1f))), vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 65535f)));
                let _e1271 = ((_e1255.z | (u32(clamp(select(0f, ceil(((8f * log2(max((_e1215 / _e1217), 0.000000000000000000000000000001f))) + 152f)), _e1228), 0f, 255f)) << bitcast<u32>(16u))) | (select(0u, _e617, _e1228) << bitcast<u32>(24u)));
                let _e1279 = vec3<f32>(_e1201[0].x, _e1201[1].x, _e1201[2].x);
                let _e1286 = vec3<f32>(_e1201[0].y, _e1201[1].y, _e1201[2].y);
                let _e1293 = vec3<f32>(_e1201[0].z, _e1201[1].z, _e1201[2].z);
                let _e1294 = length(_e1279);
                if (_e1294 > 0f) {
                    phi_5357_ = (_e1279 / vec3(_e1294));
                } else {
                    phi_5357_ = vec3<f32>(0f, 0f, 0f);
                }
                let _e1299 = phi_5357_;
                let _e1300 = dot(_e1286, _e1299);
                let _e1302 = (_e1286 - (_e1299 * _e1300));
                let _e1303 = length(_e1302);
                if (_e1303 > 0f) {
                    phi_5359_ = (_e1302 / vec3(_e1303));
                } else {
                    phi_5359_ = vec3<f32>(0f, 0f, 0f);
                }
                let _e1308 = phi_5359_;
                let _e1309 = dot(_e1293, _e1299);
                let _e1310 = dot(_e1293, _e1308);
                let _e1324 = (1023f / (_e1217 * exp2(((f32(((_e1271 >> bitcast<u32>(16u)) & 255u)) * 0.125f) - 19f))));
                let _e1342 = vec3<u32>(round((clamp(_e1152, vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 1023f)));
                let _e1345 = ((vec3<u32>(clamp((round((vec3<f32>(_e1294, _e1303, _e1310) * _e1324)) + vec3<f32>(1023f, 1023f, 1023f)), vec3<f32>(0f, 0f, 0f), vec3<f32>(2046f, 2046f, 2046f))) | (vec3<u32>(clamp((round((vec3<f32>(_e1300, _e1309, length(((_e1293 - (_e1299 * _e1309)) - (_e1308 * _e1310)))) * _e1324)) + vec3<f32>(1023f, 1023f, 1023f)), vec3<f32>(0f, 0f, 0f), vec3<f32>(2046f, 2046f, 2046f))) << bitcast<vec3<u32>>(vec3<u32>(11u, 11u, 11u)))) | (_e1342 << bitcast<vec3<u32>>(vec3<u32>(22u, 22u, 22u))));
                global_4.member[_e1204] = (_e1255.x | (_e1255.y << bitcast<u32>(16u)));
                global_4.member[(_e1204 + 1u)] = _e1271;
                let _e1353 = ((_e1203 + _e154) + (3u * _e138));
                global_4.member[_e1353] = _e1345.x;
                global_4.member[(_e1353 + 1u)] = _e1345.y;
                global_4.member[(_e1353 + 2u)] = _e1345.z;
                phi_2832_ = _e609;
                if _e609 {
                    let _e1367 = global.member_29;
                    phi_2832_ = (f32(_e617) <= _e1367);
                }
                let _e1370 = phi_2832_;
                if _e1370 {
                    let _e1372 = global_2.member_9;
                    if (_e1372 != 0u) {
                        let _e1376 = atomicAdd((&global_1.member[2u]), 1u);
                    }
                }
                let _e1377 = !(_e609);
                phi_2846_ = _e1377;
                if !(_e1377) {
                    let _e1381 = global.member_29;
                    phi_2846_ = (f32(_e617) <= _e1381);
                }
                let _e1384 = phi_2846_;
                if _e1384 {
                    phi_5374_ = 4294967295u;
                    break;
                }
                switch bitcast<i32>(0u) {
                    default: {
                        let _e1390 = global.member_2;
                        let _e1392 = global.member_3;
                        let _e1393 = clamp((_e354.xy / vec2(_e353)), _e1390, _e1392);
                        let _e1396 = global.member[0u];
                        let _e1402 = (((_e397 - (_e399 * _e1393.x)) * (_e1396 / _e353)) * _e1199);
                        let _e1405 = global.member[1u];
                        let _e1411 = (((_e398 - (_e399 * _e1393.y)) * (_e1405 / _e353)) * _e1199);
                        let _e1413 = (dot(_e1402, _e1402) + 0.3f);
                        let _e1414 = dot(_e1402, _e1411);
                        let _e1416 = (dot(_e1411, _e1411) + 0.3f);
                        let _e1418 = cross(_e1402, _e1411);
                        let _e1420 = (_e1413 + _e1416);
                        let _e1423 = (dot(_e1418, _e1418) + (0.3f * (_e1420 - 0.3f)));
                        let _e1424 = (_e1423 > 0f);
                        phi_4787_ = _e1424;
                        if _e1424 {
                            phi_4787_ = (_e1413 <= 1000000000000000000f);
                        }
                        let _e1427 = phi_4787_;
                        phi_4793_ = _e1427;
                        if _e1427 {
                            phi_4793_ = (_e1416 <= 1000000000000000000f);
                        }
                        let _e1430 = phi_4793_;
                        if !(_e1430) {
                            let _e1433 = global_2.member_9;
                            if (_e1433 != 0u) {
                                let _e1437 = atomicAdd((&global_1.member[3u]), 1u);
                            }
                            phi_5373_ = 4294967295u;
                            break;
                        }
                        let _e1440 = global.member_34;
                        let _e1443 = global.member_29;
                        let _e1451 = (sqrt(vec3<f32>(_e1413, _e1414, _e1416).xz) * sqrt((2f * log(max((max(f32(_e617), _e1440) / _e1443), 1f)))));
                        let _e1454 = all(((_e607 + _e1451) > vec2<f32>(0f, 0f)));
                        phi_4818_ = _e1454;
                        if _e1454 {
                            let _e1457 = global.member_4;
                            phi_4818_ = all(((_e607 - _e1451) < _e1457));
                        }
                        let _e1461 = phi_4818_;
                        if !(_e1461) {
                            let _e1464 = global_2.member_9;
                            if (_e1464 != 0u) {
                                let _e1468 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_5373_ = 4294967295u;
                            break;
                        }
                        let _e1470 = (0.5f * (_e1413 - _e1416));
                        let _e1474 = sqrt(((_e1470 * _e1470) + (_e1414 * _e1414)));
                        let _e1476 = ((0.5f * _e1420) + _e1474);
                        if (_e1470 >= 0f) {
                            phi_5370_ = vec2<f32>((_e1470 + _e1474), _e1414);
                        } else {
                            phi_5370_ = vec2<f32>(_e1414, (_e1474 - _e1470));
                        }
                        let _e1483 = phi_5370_;
                        let _e1484 = length(_e1483);
                        if (_e1484 > 0f) {
                            phi_5371_ = (_e1483 / vec2(_e1484));
                        } else {
                            phi_5371_ = vec2<f32>(1f, 0f);
                        }
                        let _e1489 = phi_5371_;
                        let _e1496 = global.member_5;
                        let _e1500 = global.member_10;
                        let _e1504 = vec2<u32>(clamp(round(((_e607 + vec2(_e1496)) * _e1500)), vec2<f32>(0f, 0f), vec2<f32>(1048575f, 1048575f)));
                        local = vec4<u32>(((_e1504.x | (_e1342.x << bitcast<u32>(20u))) | (_e1342.z << bitcast<u32>(30u))), (_e1504.y | (_e1342.y << bitcast<u32>(20u))), pack2x16float((_e1489 * min(sqrt(_e1476), 65504f))), ((pack2x16float(vec2<f32>(min(sqrt((_e1423 / _e1476)), 65504f), 0f)) | (_e617 << bitcast<u32>(16u))) | ((_e1342.z >> bitcast<u32>(2u)) << bitcast<u32>(24u))));
                        phi_5372_ = 0u;
                        loop {
                            let _e1533 = phi_5372_;
                            if (_e1533 < 4u) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e1536 = global.member_45;
                                let _e1541 = local[_e1533];
                                global_4.member[((4u * (_e1536 + _e138)) + _e1533)] = _e1541;
                                phi_5372_ = (_e1533 + bitcast<u32>(1i));
                            }
                        }
                        let _e1547 = global.member_9;
                        phi_5373_ = min(u32((_e605 * f32(_e1547))), _e1547);
                        break;
                    }
                }
                let _e1553 = phi_5373_;
                phi_5374_ = _e1553;
                break;
            }
        }
        let _e1555 = phi_5374_;
        phi_5375_ = _e1555;
    } else {
        phi_5375_ = 4294967295u;
    }
    let _e1557 = phi_5375_;
    switch bitcast<i32>(0u) {
        default: {
            let _e1560 = global_5[0u];
            let _e1562 = global.member_45;
            let _e1563 = (_e1562 + _e138);
            if (_e1557 != 4294967295u) {
                let _e1566 = global.member_40;
                let _e1568 = global.member_41;
                let _e1576 = atomicAdd((&global_1.member[((_e1566 + ((_e1563 / _e1568) * 256u)) + (_e1557 & 255u))]), 1u);
            }
            let _e1578 = global.member_39;
            if (_e1578 == 0u) {
                if (_e138 < (_e140 + (_e140 & 1u))) {
                    let _e1584 = global.member_28;
                    global_4.member[(_e1584 + _e1563)] = _e1557;
                }
                break;
            }
            global_6[_e1560] = _e1557;
            workgroupBarrier();
            let _e1590 = ((_e1560 & 1u) == 0u);
            if select(_e1590, _e141, _e1590) {
                let _e1593 = global.member_28;
                let _e1599 = global_6[(_e1560 + 1u)];
                global_4.member[(_e1593 + (_e1563 / 2u))] = ((_e1557 & 65535u) | (_e1599 << bitcast<u32>(16u)));
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn main(@builtin(local_invocation_id) param: vec3<u32>, @builtin(global_invocation_id) param_1: vec3<u32>) {
    global_5 = param;
    global_9 = param_1;
    function_();
}
