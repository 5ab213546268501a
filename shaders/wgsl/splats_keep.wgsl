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
    member_47: vec4<f32>,
    member_48: vec4<f32>,
    member_49: array<vec4<f32>, 3>,
    member_50: array<vec4<u32>, 8>,
    member_51: array<vec4<u32>, 8>,
    member_52: array<type_12, 8>,
    member_53: array<vec4<f32>, 128>,
    member_54: array<vec4<f32>, 768>,
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
}

struct type_22 {
    member: array<vec2<u32>>,
}

struct type_26 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<uniform> global: type_16;
@group(0) @binding(6) 
var<storage, read_write> global_1: type_26;
@group(0) @binding(7) 
var<uniform> global_2: type_20;
@group(0) @binding(3) 
var<storage> global_3: type_22;
@group(0) @binding(4) 
var<storage, read_write> global_4: type_19;
var<workgroup> global_5: array<u32, 64>;
@group(0) @binding(2) 
var<storage> global_6: type_19;
@group(0) @binding(1) 
var<storage> global_7: type_22;

@compute @workgroup_size(64, 1, 1) 
fn main(@builtin(local_invocation_id) param: vec3<u32>, @builtin(global_invocation_id) param_1: vec3<u32>) {
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

    let _e85 = bitcast<u32>(param_1[0u]);
    let _e87 = global.member_14;
    let _e88 = (_e85 < _e87);
    if _e88 {
        switch bitcast<i32>(0u) {
            default: {
                let _e92 = (4u * (_e87 + (_e85 / 32u)));
                let _e93 = (2u * _e85);
                let _e96 = global_7.member[_e93];
                let _e100 = global_7.member[(_e93 + 1u)];
                let _e101 = (2u * _e87);
                let _e105 = global_7.member[(_e101 + _e85)];
                let _e116 = (vec2<f32>(f32(((_e105.y >> bitcast<u32>(16u)) & 31u)), f32(((_e105.y >> bitcast<u32>(21u)) & 31u))) * vec2<f32>(0.032258064f, 0.032258064f));
                let _e120 = ((1f + (2f * _e116.x)) * 0.33333334f);
                let _e121 = (1f - _e120);
                let _e125 = (_e121 * (0.5f + (0.5f * _e116.y)));
                let _e133 = global.member_11;
                let _e136 = global.member_12;
                let _e151 = global.member_21;
                let _e152 = (2u * _e151);
                let _e156 = global_3.member[(_e152 + (_e105.x & 65535u))];
                let _e158 = unpack2x16float(_e156.x);
                let _e170 = global_3.member[(_e152 + (_e105.x >> bitcast<u32>(16u)))];
                let _e172 = unpack2x16float(_e170.x);
                let _e184 = global_3.member[(_e152 + (_e105.y & 65535u))];
                let _e186 = unpack2x16float(_e184.x);
                let _e194 = ((((_e133.xyz + (_e136.xyz * vec3<f32>(f32((_e96.x & 65535u)), f32((_e96.x >> bitcast<u32>(16u))), f32((_e96.y & 65535u))))) + (vec3<f32>(_e158.x, _e158.y, unpack2x16float(_e156.y).x) * _e120)) + (vec3<f32>(_e172.x, _e172.y, unpack2x16float(_e170.y).x) * _e125)) + (vec3<f32>(_e186.x, _e186.y, unpack2x16float(_e184.y).x) * (_e121 - _e125)));
                let _e198 = vec4<f32>(_e194.x, _e194.y, _e194.z, 1f);
                let _e211 = (((_e96.y >> bitcast<u32>(16u)) | ((_e100.y >> bitcast<u32>(24u)) << bitcast<u32>(16u))) | ((_e105.y >> bitcast<u32>(26u)) << bitcast<u32>(24u)));
                let _e213 = global.member_36;
                let _e215 = global.member_37;
                let _e228 = (vec3(_e213) + (vec3<f32>(f32((_e211 & 1023u)), f32(((_e211 >> bitcast<u32>(10u)) & 1023u)), f32((_e211 >> bitcast<u32>(20u)))) * _e215));
                local_1 = (vec4<u32>(_e100.x, (_e100.x >> bitcast<u32>(8u)), (_e100.x >> bitcast<u32>(16u)), (_e100.x >> bitcast<u32>(24u))) & vec4<u32>(255u, 255u, 255u, 255u));
                let _e243 = (vec3<u32>(_e100.y, (_e100.y >> bitcast<u32>(8u)), (_e100.y >> bitcast<u32>(16u))) & vec3<u32>(255u, 255u, 255u));
                let _e244 = vec3<f32>(_e243);
                local_2 = (vec4<f32>(_e244.x, _e244.y, _e244.z, f32((((255u - _e243.x) - _e243.y) - _e243.z))) * vec4<f32>(0.003921569f, 0.003921569f, 0.003921569f, 0.003921569f));
                phi_5239_ = vec4<f32>(0f, 0f, 0f, 0f);
                phi_5238_ = vec4<f32>(0f, 0f, 0f, 0f);
                phi_5237_ = vec4<f32>(0f, 0f, 0f, 0f);
                phi_5236_ = 0u;
                loop {
                    let _e258 = phi_5239_;
                    let _e260 = phi_5238_;
                    let _e262 = phi_5237_;
                    let _e264 = phi_5236_;
                    local_3 = _e262;
                    local_4 = _e260;
                    local_5 = _e258;
                    local_6 = _e262;
                    local_7 = _e262;
                    local_8 = _e260;
                    local_9 = _e260;
                    local_10 = _e258;
                    local_11 = _e258;
                    local_12 = _e262;
                    local_13 = _e262;
                    local_14 = _e262;
                    local_15 = _e260;
                    local_16 = _e260;
                    local_17 = _e260;
                    local_18 = _e258;
                    local_19 = _e258;
                    local_20 = _e258;
                    if (_e264 < 4u) {
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e267 = local_1[_e264];
                        let _e268 = (3u * _e267);
                        let _e270 = local_2[_e264];
                        let _e273 = global.member_54[_e268];
                        let _e276 = local_2[_e264];
                        let _e280 = global.member_54[(_e268 + 1u)];
                        let _e283 = local_2[_e264];
                        let _e287 = global.member_54[(_e268 + 2u)];
                        phi_5239_ = (_e258 + (_e287 * _e283));
                        phi_5238_ = (_e260 + (_e280 * _e276));
                        phi_5237_ = (_e262 + (_e273 * _e270));
                        phi_5236_ = (_e264 + bitcast<u32>(1i));
                    }
                }
                let _e293 = local_3;
                let _e296 = local_4;
                let _e299 = local_5;
                let _e300 = dot(_e299, _e198);
                let _e301 = vec3<f32>(dot(_e293, _e198), dot(_e296, _e198), _e300);
                let _e303 = local_6;
                let _e304 = _e303.xyz;
                let _e306 = local_8;
                let _e307 = _e306.xyz;
                let _e309 = local_10;
                let _e310 = _e309.xyz;
                let _e312 = local_12;
                let _e315 = local_13;
                let _e318 = local_14;
                let _e321 = local_15;
                let _e324 = local_16;
                let _e327 = local_17;
                let _e330 = local_18;
                let _e333 = local_19;
                let _e336 = local_20;
                let _e338 = vec3<f32>(_e312.x, _e315.y, _e318.z);
                let _e339 = vec3<f32>(_e321.x, _e324.y, _e327.z);
                let _e340 = vec3<f32>(_e330.x, _e333.y, _e336.z);
                let _e356 = ((1.2f * exp(min(max(max(_e228.x, _e228.y), _e228.z), 9f))) * sqrt(max(max(dot(_e304, _e304), dot(_e307, _e307)), dot(_e310, _e310))));
                switch bitcast<i32>(0u) {
                    default: {
                        let _e359 = global.member_6;
                        if !((_e300 >= _e359)) {
                            let _e363 = global_2.member_9;
                            if (_e363 != 0u) {
                                let _e367 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_5268_ = 0f;
                            phi_5259_ = vec2<f32>(0f, 0f);
                            phi_5258_ = false;
                            break;
                        }
                        let _e369 = global.member;
                        let _e370 = _e301.xy;
                        let _e372 = vec2(_e300);
                        let _e375 = global.member_1;
                        let _e376 = (((_e369 * _e370) / _e372) + _e375);
                        let _e378 = global.member_5;
                        let _e382 = all((_e376 >= vec2(-(_e378))));
                        phi_3138_ = _e382;
                        if _e382 {
                            let _e384 = global.member_4;
                            phi_3138_ = all((_e376 <= (_e384 + vec2(_e378))));
                        }
                        let _e390 = phi_3138_;
                        if !(_e390) {
                            let _e393 = global_2.member_9;
                            if (_e393 != 0u) {
                                let _e397 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_5268_ = 0f;
                            phi_5259_ = _e376;
                            phi_5258_ = false;
                            break;
                        }
                        let _e399 = global.member_7;
                        let _e402 = global.member_8;
                        let _e403 = ((_e399 - _e300) * _e402);
                        if (_e403 < 0f) {
                            phi_5242_ = (0.015625f / (1f - _e403));
                        } else {
                            if (_e403 > 1f) {
                                phi_5241_ = (1f - (0.015625f / _e403));
                            } else {
                                phi_5241_ = (0.015625f + (0.96875f * clamp(_e403, 0f, 1f)));
                            }
                            let _e412 = phi_5241_;
                            phi_5242_ = _e412;
                        }
                        let _e416 = phi_5242_;
                        let _e417 = (_e370 / _e372);
                        let _e425 = global.member[0u];
                        let _e428 = global.member[1u];
                        let _e433 = global.member_31;
                        let _e434 = (_e433 > 0u);
                        phi_3180_ = _e434;
                        if _e434 {
                            let _e436 = global.member_34;
                            let _e439 = global.member_29;
                            switch bitcast<i32>(0u) {
                                default: {
                                    let _e449 = vec2((sqrt((2f * log(max((max(255f, _e436) / _e439), 1f)))) * ((((_e356 * length(vec3<f32>(_e417.x, _e417.y, 1f))) * max(_e425, _e428)) / _e300) + 0.5477226f)));
                                    let _e452 = global.member_32;
                                    let _e455 = global.member_33;
                                    let _e459 = vec2<u32>(clamp(((((_e376 - _e449) - _e452) * _e455) - vec2<f32>(0.5f, 0.5f)), vec2<f32>(0f, 0f), vec2<f32>(191f, 191f)));
                                    let _e465 = vec2<u32>(clamp(((((_e376 + _e449) - _e452) * _e455) + vec2<f32>(0.5f, 0.5f)), vec2<f32>(0f, 0f), vec2<f32>(191f, 191f)));
                                    let _e472 = max((_e465.x - _e459.x), (_e465.y - _e459.y));
                                    if (_e472 <= 3u) {
                                        phi_5246_ = 0u;
                                    } else {
                                        phi_5246_ = (bitcast<u32>(firstLeadingBit((_e472 - 1u))) - 1u);
                                    }
                                    let _e479 = phi_5246_;
                                    if !((_e479 < 4u)) {
                                        phi_5257_ = false;
                                        break;
                                    }
                                    let _e488 = vec2(_e479);
                                    let _e490 = (_e459 >> bitcast<vec2<u32>>(_e488));
                                    let _e492 = (_e465 >> bitcast<vec2<u32>>(_e488));
                                    phi_5251_ = 0f;
                                    phi_5249_ = _e490.y;
                                    loop {
                                        let _e495 = phi_5251_;
                                        let _e497 = phi_5249_;
                                        local_21 = _e495;
                                        if (_e497 <= _e492.y) {
                                            phi_5256_ = _e495;
                                            phi_5253_ = _e490.x;
                                            loop {
                                                let _e502 = phi_5256_;
                                                let _e504 = phi_5253_;
                                                local_32 = _e502;
                                                if (_e504 <= _e492.x) {
                                                    continue;
                                                } else {
                                                    break;
                                                }
                                                continuing {
                                                    let _e511 = (((49152u - (((36864u >> bitcast<u32>((2u * _e479))) / 3u) * 4u)) + (_e497 * (192u >> bitcast<u32>(_e479)))) + _e504);
                                                    let _e513 = (_e433 + (_e511 / 2u));
                                                    let _e519 = global_3.member[(_e513 / 2u)][(_e513 & 1u)];
                                                    phi_5256_ = max(_e502, (f32(((_e519 >> bitcast<u32>((16u * (_e511 & 1u)))) & 65535u)) * 0.000015259022f));
                                                    phi_5253_ = (_e504 + bitcast<u32>(1i));
                                                }
                                            }
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e1574 = local_32;
                                            phi_5251_ = _e1574;
                                            phi_5249_ = (_e497 + bitcast<u32>(1i));
                                        }
                                    }
                                    let _e533 = local_21;
                                    phi_5257_ = ((1f - _e416) > _e533);
                                    break;
                                }
                            }
                            let _e536 = phi_5257_;
                            phi_3180_ = _e536;
                        }
                        let _e538 = phi_3180_;
                        if _e538 {
                            let _e540 = global_2.member_9;
                            if (_e540 != 0u) {
                                let _e544 = atomicAdd((&global_1.member[1u]), 1u);
                            }
                            phi_5268_ = _e416;
                            phi_5259_ = _e376;
                            phi_5258_ = false;
                            break;
                        }
                        phi_5268_ = _e416;
                        phi_5259_ = _e376;
                        phi_5258_ = true;
                        break;
                    }
                }
                let _e546 = phi_5268_;
                let _e548 = phi_5259_;
                let _e550 = phi_5258_;
                let _e555 = global_7.member[((3u * _e87) + _e85)];
                let _e558 = (_e555.y >> bitcast<u32>(24u));
                let _e572 = ((vec3<f32>(f32((_e555.x & 1023u)), f32(((_e555.x >> bitcast<u32>(10u)) & 1023u)), f32(((_e555.x >> bitcast<u32>(20u)) & 1023u))) - vec3<f32>(512f, 512f, 512f)) * vec3<f32>(0.0013888889f, 0.0013888889f, 0.0013888889f));
                let _e576 = sqrt(max((1f - dot(_e572, _e572)), 0f));
                let _e578 = (_e555.x >> bitcast<u32>(30u));
                if (_e578 == 0u) {
                    phi_5280_ = vec4<f32>(_e576, _e572.x, _e572.y, _e572.z);
                } else {
                    if (_e578 == 1u) {
                        phi_5279_ = vec4<f32>(_e572.x, _e576, _e572.y, _e572.z);
                    } else {
                        if (_e578 == 2u) {
                            phi_5278_ = vec4<f32>(_e572.x, _e572.y, _e576, _e572.z);
                        } else {
                            phi_5278_ = vec4<f32>(_e572.x, _e572.y, _e572.z, _e576);
                        }
                        let _e591 = phi_5278_;
                        phi_5279_ = _e591;
                    }
                    let _e597 = phi_5279_;
                    phi_5280_ = _e597;
                }
                let _e603 = phi_5280_;
                let _e607 = global.member_38;
                let _e608 = (_e607 > 0u);
                phi_5298_ = unpack4x8unorm(_e555.y).xyz;
                if _e608 {
                    let _e612 = global_7.member[(_e607 + _e85)];
                    let _e614 = unpack2x16float(_e612.x);
                    phi_5298_ = vec3<f32>(_e614.x, _e614.y, unpack2x16float(_e612.y).x);
                }
                let _e622 = phi_5298_;
                let _e625 = (1u << bitcast<u32>((_e85 & 31u)));
                let _e628 = global_7.member[_e92];
                let _e632 = global_7.member[(_e92 + 1u)];
                let _e636 = global_7.member[(_e92 + 2u)];
                phi_5342_ = _e603;
                if ((_e628.x & _e625) != 0u) {
                    let _e641 = global.member_22;
                    let _e649 = global.member_18;
                    let _e653 = (_e641 + ((_e632.y + bitcast<u32>(countOneBits((_e628.x & (_e625 - 1u))))) * (1u + (4u * _e649))));
                    let _e654 = (_e653 + 1u);
                    let _e657 = global_6.member[_e653];
                    let _e659 = global.member_44;
                    let _e663 = global.member_19;
                    let _e665 = (_e659 + ((_e657 >> bitcast<u32>(16u)) * _e663));
                    let _e668 = (127f * unpack2x16float(_e657).x);
                    phi_5300_ = 0f;
                    phi_5299_ = 0u;
                    loop {
                        let _e670 = phi_5300_;
                        let _e672 = phi_5299_;
                        local_22 = _e670;
                        if (_e672 < _e649) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e677 = global_6.member[(_e654 + _e672)];
                            let _e680 = (2u * (_e665 + _e672));
                            let _e683 = global_3.member[_e680];
                            let _e687 = global_3.member[(_e680 + 1u)];
                            phi_5300_ = (_e670 + dot(unpack4x8snorm(_e677), bitcast<vec4<f32>>(vec4<u32>(_e683.x, _e683.y, _e687.x, _e687.y))));
                            phi_5299_ = (_e672 + bitcast<u32>(1i));
                        }
                    }
                    phi_5302_ = 0f;
                    phi_5301_ = 0u;
                    loop {
                        let _e700 = phi_5302_;
                        let _e702 = phi_5301_;
                        local_23 = _e700;
                        if (_e702 < _e649) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e707 = global_6.member[((_e654 + _e649) + _e702)];
                            let _e710 = (2u * (_e665 + _e702));
                            let _e713 = global_3.member[_e710];
                            let _e717 = global_3.member[(_e710 + 1u)];
                            phi_5302_ = (_e700 + dot(unpack4x8snorm(_e707), bitcast<vec4<f32>>(vec4<u32>(_e713.x, _e713.y, _e717.x, _e717.y))));
                            phi_5301_ = (_e702 + bitcast<u32>(1i));
                        }
                    }
                    phi_5304_ = 0f;
                    phi_5303_ = 0u;
                    loop {
                        let _e731 = phi_5304_;
                        let _e733 = phi_5303_;
                        local_24 = _e731;
                        if (_e733 < _e649) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e738 = global_6.member[((_e654 + (2u * _e649)) + _e733)];
                            let _e741 = (2u * (_e665 + _e733));
                            let _e744 = global_3.member[_e741];
                            let _e748 = global_3.member[(_e741 + 1u)];
                            phi_5304_ = (_e731 + dot(unpack4x8snorm(_e738), bitcast<vec4<f32>>(vec4<u32>(_e744.x, _e744.y, _e748.x, _e748.y))));
                            phi_5303_ = (_e733 + bitcast<u32>(1i));
                        }
                    }
                    let _e760 = local_22;
                    let _e762 = local_23;
                    let _e764 = local_24;
                    let _e766 = (vec3<f32>(_e760, _e762, _e764) * _e668);
                    phi_5306_ = 0f;
                    phi_5305_ = 0u;
                    loop {
                        let _e770 = phi_5306_;
                        let _e772 = phi_5305_;
                        local_25 = _e770;
                        if (_e772 < _e649) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e777 = global_6.member[((_e654 + (3u * _e649)) + _e772)];
                            let _e780 = (2u * (_e665 + _e772));
                            let _e783 = global_3.member[_e780];
                            let _e787 = global_3.member[(_e780 + 1u)];
                            phi_5306_ = (_e770 + dot(unpack4x8snorm(_e777), bitcast<vec4<f32>>(vec4<u32>(_e783.x, _e783.y, _e787.x, _e787.y))));
                            phi_5305_ = (_e772 + bitcast<u32>(1i));
                        }
                    }
                    let _e799 = local_25;
                    let _e805 = (_e603 + vec4<f32>(_e766.x, _e766.y, _e766.z, (_e668 * _e799)));
                    phi_5342_ = select(_e603, _e805, vec4((length(_e805) >= 0.001f)));
                }
                let _e811 = phi_5342_;
                phi_5350_ = _e228;
                if ((_e628.y & _e625) != 0u) {
                    let _e816 = global.member_23;
                    let _e824 = global.member_18;
                    let _e828 = (_e816 + ((_e636.x + bitcast<u32>(countOneBits((_e628.y & (_e625 - 1u))))) * (1u + (3u * _e824))));
                    let _e829 = (_e828 + 1u);
                    let _e832 = global_6.member[_e828];
                    let _e834 = global.member_44;
                    let _e838 = global.member_19;
                    let _e840 = (_e834 + ((_e832 >> bitcast<u32>(16u)) * _e838));
                    phi_5312_ = 0f;
                    phi_5311_ = 0u;
                    loop {
                        let _e845 = phi_5312_;
                        let _e847 = phi_5311_;
                        local_26 = _e845;
                        if (_e847 < _e824) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e852 = global_6.member[(_e829 + _e847)];
                            let _e855 = (2u * (_e840 + _e847));
                            let _e858 = global_3.member[_e855];
                            let _e862 = global_3.member[(_e855 + 1u)];
                            phi_5312_ = (_e845 + dot(unpack4x8snorm(_e852), bitcast<vec4<f32>>(vec4<u32>(_e858.x, _e858.y, _e862.x, _e862.y))));
                            phi_5311_ = (_e847 + bitcast<u32>(1i));
                        }
                    }
                    phi_5314_ = 0f;
                    phi_5313_ = 0u;
                    loop {
                        let _e875 = phi_5314_;
                        let _e877 = phi_5313_;
                        local_27 = _e875;
                        if (_e877 < _e824) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e882 = global_6.member[((_e829 + _e824) + _e877)];
                            let _e885 = (2u * (_e840 + _e877));
                            let _e888 = global_3.member[_e885];
                            let _e892 = global_3.member[(_e885 + 1u)];
                            phi_5314_ = (_e875 + dot(unpack4x8snorm(_e882), bitcast<vec4<f32>>(vec4<u32>(_e888.x, _e888.y, _e892.x, _e892.y))));
                            phi_5313_ = (_e877 + bitcast<u32>(1i));
                        }
                    }
                    phi_5316_ = 0f;
                    phi_5315_ = 0u;
                    loop {
                        let _e906 = phi_5316_;
                        let _e908 = phi_5315_;
                        local_28 = _e906;
                        if (_e908 < _e824) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e913 = global_6.member[((_e829 + (2u * _e824)) + _e908)];
                            let _e916 = (2u * (_e840 + _e908));
                            let _e919 = global_3.member[_e916];
                            let _e923 = global_3.member[(_e916 + 1u)];
                            phi_5316_ = (_e906 + dot(unpack4x8snorm(_e913), bitcast<vec4<f32>>(vec4<u32>(_e919.x, _e919.y, _e923.x, _e923.y))));
                            phi_5315_ = (_e908 + bitcast<u32>(1i));
                        }
                    }
                    let _e935 = local_26;
                    let _e937 = local_27;
                    let _e939 = local_28;
                    phi_5350_ = (_e228 + (vec3<f32>(_e935, _e937, _e939) * (127f * unpack2x16float(_e832).x)));
                }
                let _e944 = phi_5350_;
                phi_5354_ = _e622;
                if ((_e632.x & _e625) != 0u) {
                    let _e949 = global.member_24;
                    let _e957 = global.member_18;
                    let _e961 = (_e949 + ((_e636.y + bitcast<u32>(countOneBits((_e632.x & (_e625 - 1u))))) * (3u + (3u * _e957))));
                    let _e965 = global_6.member[(_e961 + 1u)];
                    let _e966 = unpack2x16float(_e965);
                    let _e970 = global_6.member[(_e961 + 2u)];
                    let _e978 = (_e961 + 3u);
                    let _e981 = global_6.member[_e961];
                    let _e983 = global.member_44;
                    let _e987 = global.member_19;
                    let _e989 = (_e983 + ((_e981 >> bitcast<u32>(16u)) * _e987));
                    phi_5335_ = 0f;
                    phi_5334_ = 0u;
                    loop {
                        let _e994 = phi_5335_;
                        let _e996 = phi_5334_;
                        local_29 = _e994;
                        if (_e996 < _e957) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e1001 = global_6.member[(_e978 + _e996)];
                            let _e1004 = (2u * (_e989 + _e996));
                            let _e1007 = global_3.member[_e1004];
                            let _e1011 = global_3.member[(_e1004 + 1u)];
                            phi_5335_ = (_e994 + dot(unpack4x8snorm(_e1001), bitcast<vec4<f32>>(vec4<u32>(_e1007.x, _e1007.y, _e1011.x, _e1011.y))));
                            phi_5334_ = (_e996 + bitcast<u32>(1i));
                        }
                    }
                    phi_5337_ = 0f;
                    phi_5336_ = 0u;
                    loop {
                        let _e1024 = phi_5337_;
                        let _e1026 = phi_5336_;
                        local_30 = _e1024;
                        if (_e1026 < _e957) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e1031 = global_6.member[((_e978 + _e957) + _e1026)];
                            let _e1034 = (2u * (_e989 + _e1026));
                            let _e1037 = global_3.member[_e1034];
                            let _e1041 = global_3.member[(_e1034 + 1u)];
                            phi_5337_ = (_e1024 + dot(unpack4x8snorm(_e1031), bitcast<vec4<f32>>(vec4<u32>(_e1037.x, _e1037.y, _e1041.x, _e1041.y))));
                            phi_5336_ = (_e1026 + bitcast<u32>(1i));
                        }
                    }
                    phi_5339_ = 0f;
                    phi_5338_ = 0u;
                    loop {
                        let _e1055 = phi_5339_;
                        let _e1057 = phi_5338_;
                        local_31 = _e1055;
                        if (_e1057 < _e957) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e1062 = global_6.member[((_e978 + (2u * _e957)) + _e1057)];
                            let _e1065 = (2u * (_e989 + _e1057));
                            let _e1068 = global_3.member[_e1065];
                            let _e1072 = global_3.member[(_e1065 + 1u)];
                            phi_5339_ = (_e1055 + dot(unpack4x8snorm(_e1062), bitcast<vec4<f32>>(vec4<u32>(_e1068.x, _e1068.y, _e1072.x, _e1072.y))));
                            phi_5338_ = (_e1057 + bitcast<u32>(1i));
                        }
                    }
                    let _e1084 = local_29;
                    let _e1086 = local_30;
                    let _e1088 = local_31;
                    phi_5354_ = (select(vec3<f32>(_e966.x, _e966.y, unpack2x16float(_e970).x), _e622, vec3(_e608)) + (vec3<f32>(_e1084, _e1086, _e1088) * (127f * unpack2x16float(_e981).x)));
                }
                let _e1093 = phi_5354_;
                let _e1094 = normalize(_e811);
                let _e1099 = (_e1094.z * _e1094.z);
                let _e1100 = (_e1094.w * _e1094.w);
                let _e1104 = (_e1094.y * _e1094.z);
                let _e1105 = (_e1094.x * _e1094.w);
                let _e1108 = (_e1094.y * _e1094.w);
                let _e1109 = (_e1094.x * _e1094.z);
                let _e1114 = (_e1094.y * _e1094.y);
                let _e1118 = (_e1094.z * _e1094.w);
                let _e1119 = (_e1094.x * _e1094.y);
                let _e1133 = exp(min(_e944, vec3<f32>(9f, 9f, 9f)));
                let _e1140 = mat3x3<f32>((vec3<f32>((1f - (2f * (_e1099 + _e1100))), (2f * (_e1104 + _e1105)), (2f * (_e1108 - _e1109))) * _e1133.x), (vec3<f32>((2f * (_e1104 - _e1105)), (1f - (2f * (_e1114 + _e1100))), (2f * (_e1118 + _e1119))) * _e1133.y), (vec3<f32>((2f * (_e1108 + _e1109)), (2f * (_e1118 - _e1119)), (1f - (2f * (_e1114 + _e1099)))) * _e1133.z));
                let _e1142 = (transpose(mat3x3<f32>(_e338, _e339, _e340)) * _e1140);
                let _e1144 = global.member_42;
                let _e1145 = (_e1144 + _e93);
                let _e1146 = transpose(_e1142);
                let _e1156 = max(_e356, sqrt(max(max(dot(_e1146[0], _e1146[0]), dot(_e1146[1], _e1146[1])), dot(_e1146[2], _e1146[2]))));
                let _e1158 = global.member_43;
                let _e1169 = (all((abs(_e301) < vec3<f32>(1000000000000000000000000000000f, 1000000000000000000000000000000f, 1000000000000000000000000000000f))) && (_e1156 <= 1000000000000000000f));
                if _e1169 {
                    let _e1171 = global.member_47;
                    let _e1175 = global.member_48;
                    phi_5355_ = ((_e301 - _e1171.xyz) / _e1175.xyz);
                } else {
                    phi_5355_ = vec3<f32>(0f, 0f, 0f);
                }
                let _e1179 = phi_5355_;
                let _e1196 = vec3<u32>(round((clamp(select(select((vec3<f32>(0.015625f, 0.015625f, 0.015625f) + (clamp(_e1179, vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 0.96875f)), (vec3<f32>(0.015625f, 0.015625f, 0.015625f) / (vec3<f32>(1f, 1f, 1f) - min(_e1179, vec3<f32>(0f, 0f, 0f)))), (_e1179 < vec3<f32>(0f, 0f, 0f))), (vec3<f32>(1f, 1f, 1f) - (vec3<f32>(0.015625f, 0.015625f, 0.015625f) / max(_e1179, vec3<f32>(1f, 1f, 1f)))), (_e1179 > vec3<f32>(1f, 1f, 1f))), vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 65535f)));
                let _e1212 = ((_e1196.z | (u32(clamp(select(0f, ceil(((8f * log2(max((_e1156 / _e1158), 0.000000000000000000000000000001f))) + 152f)), _e1169), 0f, 255f)) << bitcast<u32>(16u))) | (select(0u, _e558, _e1169) << bitcast<u32>(24u)));
                let _e1220 = vec3<f32>(_e1142[0].x, _e1142[1].x, _e1142[2].x);
                let _e1227 = vec3<f32>(_e1142[0].y, _e1142[1].y, _e1142[2].y);
                let _e1234 = vec3<f32>(_e1142[0].z, _e1142[1].z, _e1142[2].z);
                let _e1235 = length(_e1220);
                if (_e1235 > 0f) {
                    phi_5357_ = (_e1220 / vec3(_e1235));
                } else {
                    phi_5357_ = vec3<f32>(0f, 0f, 0f);
                }
                let _e1240 = phi_5357_;
                let _e1241 = dot(_e1227, _e1240);
                let _e1243 = (_e1227 - (_e1240 * _e1241));
                let _e1244 = length(_e1243);
                if (_e1244 > 0f) {
                    phi_5359_ = (_e1243 / vec3(_e1244));
                } else {
                    phi_5359_ = vec3<f32>(0f, 0f, 0f);
                }
                let _e1249 = phi_5359_;
                let _e1250 = dot(_e1234, _e1240);
                let _e1251 = dot(_e1234, _e1249);
                let _e1265 = (1023f / (_e1158 * exp2(((f32(((_e1212 >> bitcast<u32>(16u)) & 255u)) * 0.125f) - 19f))));
                let _e1283 = vec3<u32>(round((clamp(_e1093, vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 1023f)));
                let _e1286 = ((vec3<u32>(clamp((round((vec3<f32>(_e1235, _e1244, _e1251) * _e1265)) + vec3<f32>(1023f, 1023f, 1023f)), vec3<f32>(0f, 0f, 0f), vec3<f32>(2046f, 2046f, 2046f))) | (vec3<u32>(clamp((round((vec3<f32>(_e1241, _e1250, length(((_e1234 - (_e1240 * _e1250)) - (_e1249 * _e1251)))) * _e1265)) + vec3<f32>(1023f, 1023f, 1023f)), vec3<f32>(0f, 0f, 0f), vec3<f32>(2046f, 2046f, 2046f))) << bitcast<vec3<u32>>(vec3<u32>(11u, 11u, 11u)))) | (_e1283 << bitcast<vec3<u32>>(vec3<u32>(22u, 22u, 22u))));
                global_4.member[_e1145] = (_e1196.x | (_e1196.y << bitcast<u32>(16u)));
                global_4.member[(_e1145 + 1u)] = _e1212;
                let _e1294 = ((_e1144 + _e101) + (3u * _e85));
                global_4.member[_e1294] = _e1286.x;
                global_4.member[(_e1294 + 1u)] = _e1286.y;
                global_4.member[(_e1294 + 2u)] = _e1286.z;
                phi_2832_ = _e550;
                if _e550 {
                    let _e1308 = global.member_29;
                    phi_2832_ = (f32(_e558) <= _e1308);
                }
                let _e1311 = phi_2832_;
                if _e1311 {
                    let _e1313 = global_2.member_9;
                    if (_e1313 != 0u) {
                        let _e1317 = atomicAdd((&global_1.member[2u]), 1u);
                    }
                }
                let _e1318 = !(_e550);
                phi_2846_ = _e1318;
                if !(_e1318) {
                    let _e1322 = global.member_29;
                    phi_2846_ = (f32(_e558) <= _e1322);
                }
                let _e1325 = phi_2846_;
                if _e1325 {
                    phi_5374_ = 4294967295u;
                    break;
                }
                switch bitcast<i32>(0u) {
                    default: {
                        let _e1331 = global.member_2;
                        let _e1333 = global.member_3;
                        let _e1334 = clamp((_e301.xy / vec2(_e300)), _e1331, _e1333);
                        let _e1337 = global.member[0u];
                        let _e1343 = (((_e338 - (_e340 * _e1334.x)) * (_e1337 / _e300)) * _e1140);
                        let _e1346 = global.member[1u];
                        let _e1352 = (((_e339 - (_e340 * _e1334.y)) * (_e1346 / _e300)) * _e1140);
                        let _e1354 = (dot(_e1343, _e1343) + 0.3f);
                        let _e1355 = dot(_e1343, _e1352);
                        let _e1357 = (dot(_e1352, _e1352) + 0.3f);
                        let _e1359 = cross(_e1343, _e1352);
                        let _e1361 = (_e1354 + _e1357);
                        let _e1364 = (dot(_e1359, _e1359) + (0.3f * (_e1361 - 0.3f)));
                        let _e1365 = (_e1364 > 0f);
                        phi_4787_ = _e1365;
                        if _e1365 {
                            phi_4787_ = (_e1354 <= 1000000000000000000f);
                        }
                        let _e1368 = phi_4787_;
                        phi_4793_ = _e1368;
                        if _e1368 {
                            phi_4793_ = (_e1357 <= 1000000000000000000f);
                        }
                        let _e1371 = phi_4793_;
                        if !(_e1371) {
                            let _e1374 = global_2.member_9;
                            if (_e1374 != 0u) {
                                let _e1378 = atomicAdd((&global_1.member[3u]), 1u);
                            }
                            phi_5373_ = 4294967295u;
                            break;
                        }
                        let _e1381 = global.member_34;
                        let _e1384 = global.member_29;
                        let _e1392 = (sqrt(vec3<f32>(_e1354, _e1355, _e1357).xz) * sqrt((2f * log(max((max(f32(_e558), _e1381) / _e1384), 1f)))));
                        let _e1395 = all(((_e548 + _e1392) > vec2<f32>(0f, 0f)));
                        phi_4818_ = _e1395;
                        if _e1395 {
                            let _e1398 = global.member_4;
                            phi_4818_ = all(((_e548 - _e1392) < _e1398));
                        }
                        let _e1402 = phi_4818_;
                        if !(_e1402) {
                            let _e1405 = global_2.member_9;
                            if (_e1405 != 0u) {
                                let _e1409 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_5373_ = 4294967295u;
                            break;
                        }
                        let _e1411 = (0.5f * (_e1354 - _e1357));
                        let _e1415 = sqrt(((_e1411 * _e1411) + (_e1355 * _e1355)));
                        let _e1417 = ((0.5f * _e1361) + _e1415);
                        if (_e1411 >= 0f) {
                            phi_5370_ = vec2<f32>((_e1411 + _e1415), _e1355);
                        } else {
                            phi_5370_ = vec2<f32>(_e1355, (_e1415 - _e1411));
                        }
                        let _e1424 = phi_5370_;
                        let _e1425 = length(_e1424);
                        if (_e1425 > 0f) {
                            phi_5371_ = (_e1424 / vec2(_e1425));
                        } else {
                            phi_5371_ = vec2<f32>(1f, 0f);
                        }
                        let _e1430 = phi_5371_;
                        let _e1437 = global.member_5;
                        let _e1441 = global.member_10;
                        let _e1445 = vec2<u32>(clamp(round(((_e548 + vec2(_e1437)) * _e1441)), vec2<f32>(0f, 0f), vec2<f32>(1048575f, 1048575f)));
                        local = vec4<u32>(((_e1445.x | (_e1283.x << bitcast<u32>(20u))) | (_e1283.z << bitcast<u32>(30u))), (_e1445.y | (_e1283.y << bitcast<u32>(20u))), pack2x16float((_e1430 * min(sqrt(_e1417), 65504f))), ((pack2x16float(vec2<f32>(min(sqrt((_e1364 / _e1417)), 65504f), 0f)) | (_e558 << bitcast<u32>(16u))) | ((_e1283.z >> bitcast<u32>(2u)) << bitcast<u32>(24u))));
                        phi_5372_ = 0u;
                        loop {
                            let _e1474 = phi_5372_;
                            if (_e1474 < 4u) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e1477 = global.member_45;
                                let _e1482 = local[_e1474];
                                global_4.member[((4u * (_e1477 + _e85)) + _e1474)] = _e1482;
                                phi_5372_ = (_e1474 + bitcast<u32>(1i));
                            }
                        }
                        let _e1488 = global.member_9;
                        phi_5373_ = min(u32((_e546 * f32(_e1488))), _e1488);
                        break;
                    }
                }
                let _e1494 = phi_5373_;
                phi_5374_ = _e1494;
                break;
            }
        }
        let _e1496 = phi_5374_;
        phi_5375_ = _e1496;
    } else {
        phi_5375_ = 4294967295u;
    }
    let _e1498 = phi_5375_;
    switch bitcast<i32>(0u) {
        default: {
            let _e1501 = bitcast<u32>(param[0u]);
            let _e1503 = global.member_45;
            let _e1504 = (_e1503 + _e85);
            if (_e1498 != 4294967295u) {
                let _e1507 = global.member_40;
                let _e1509 = global.member_41;
                let _e1517 = atomicAdd((&global_1.member[((_e1507 + ((_e1504 / _e1509) * 256u)) + (_e1498 & 255u))]), 1u);
            }
            let _e1519 = global.member_39;
            if (_e1519 == 0u) {
                if (_e85 < (_e87 + (_e87 & 1u))) {
                    let _e1525 = global.member_28;
                    global_4.member[(_e1525 + _e1504)] = _e1498;
                }
                break;
            }
            global_5[_e1501] = _e1498;
            workgroupBarrier();
            let _e1531 = ((_e1501 & 1u) == 0u);
            if select(_e1531, _e88, _e1531) {
                let _e1534 = global.member_28;
                let _e1540 = global_5[(_e1501 + 1u)];
                global_4.member[(_e1534 + (_e1504 / 2u))] = ((_e1498 & 65535u) | (_e1540 << bitcast<u32>(16u)));
            }
            break;
        }
    }
    return;
}
