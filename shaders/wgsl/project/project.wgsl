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
    member_51: f32,
    member_52: f32,
    member_53: f32,
    member_54: vec4<f32>,
    member_55: vec4<f32>,
    member_56: vec4<f32>,
    member_57: array<vec4<f32>, 3>,
    member_58: array<vec4<u32>, 8>,
    member_59: array<vec4<u32>, 8>,
    member_60: array<type_12, 8>,
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
    var phi_5201_: u32;
    var phi_5200_: bool;
    var phi_3159_: bool;
    var local: bool;
    var phi_3567_: bool;
    var phi_5203_: f32;
    var phi_5204_: f32;
    var phi_5208_: u32;
    var phi_5214_: u32;
    var phi_5213_: f32;
    var phi_5211_: u32;
    var local_1: f32;
    var phi_5218_: bool;
    var phi_3616_: bool;
    var phi_5229_: f32;
    var phi_5220_: vec2<f32>;
    var phi_5219_: bool;
    var phi_5239_: vec4<f32>;
    var phi_5240_: vec4<f32>;
    var phi_5241_: vec4<f32>;
    var phi_5259_: vec3<f32>;
    var phi_5261_: vec4<f32>;
    var phi_5260_: u32;
    var local_2: vec4<f32>;
    var phi_5276_: vec4<f32>;
    var phi_5264_: vec3<f32>;
    var phi_5263_: u32;
    var local_3: vec3<f32>;
    var phi_5280_: vec3<f32>;
    var phi_5273_: vec3<f32>;
    var phi_5272_: u32;
    var local_4: vec3<f32>;
    var phi_5282_: vec3<f32>;
    var phi_4662_: bool;
    var phi_4668_: bool;
    var phi_5287_: f32;
    var phi_5286_: u32;
    var local_5: f32;
    var phi_5295_: u32;
    var phi_4746_: bool;
    var phi_5299_: vec2<f32>;
    var phi_5300_: vec2<f32>;
    var phi_5301_: u32;
    var phi_5302_: u32;
    var phi_5303_: u32;

    let _e70 = bitcast<u32>(param_1[0u]);
    let _e72 = global.member_48;
    let _e73 = (_e70 < _e72);
    if _e73 {
        switch bitcast<i32>(0u) {
            default: {
                let _e76 = global.member_14;
                let _e78 = global.member_47;
                let _e80 = (_e70 << bitcast<u32>(_e78));
                let _e84 = (4u * (_e76 + (_e80 >> bitcast<u32>(5u))));
                let _e89 = global_7.member[(_e84 + 3u)][0u];
                phi_5201_ = (_e89 & 65535u);
                phi_5200_ = true;
                loop {
                    let _e92 = phi_5201_;
                    let _e94 = phi_5200_;
                    local = _e94;
                    phi_3159_ = _e94;
                    if _e94 {
                        phi_3159_ = (_e92 <= (_e89 >> bitcast<u32>(16u)));
                    }
                    let _e99 = phi_3159_;
                    if _e99 {
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e108 = global.member_59[(_e92 >> bitcast<u32>(7u))][((_e92 >> bitcast<u32>(5u)) & 3u)];
                        phi_5201_ = (_e92 + bitcast<u32>(1i));
                        phi_5200_ = (((_e108 >> bitcast<u32>((_e92 & 31u))) & 1u) != 0u);
                    }
                }
                let _e117 = local;
                if _e117 {
                    let _e119 = global_2.member_9;
                    if (_e119 != 0u) {
                        let _e123 = atomicAdd((&global_1.member[0u]), 1u);
                    }
                    phi_5302_ = 4294967295u;
                    break;
                }
                let _e124 = (2u * _e80);
                let _e127 = global_7.member[_e124];
                let _e131 = global_7.member[(_e124 + 1u)];
                let _e136 = global_7.member[((2u * _e76) + _e80)];
                let _e147 = (vec2<f32>(f32(((_e136.y >> bitcast<u32>(16u)) & 31u)), f32(((_e136.y >> bitcast<u32>(21u)) & 31u))) * vec2<f32>(0.032258064f, 0.032258064f));
                let _e151 = ((1f + (2f * _e147.x)) * 0.33333334f);
                let _e152 = (1f - _e151);
                let _e156 = (_e152 * (0.5f + (0.5f * _e147.y)));
                let _e174 = global.member_11;
                let _e177 = global.member_12;
                let _e182 = global.member_21;
                let _e183 = (2u * _e182);
                let _e187 = global_3.member[(_e183 + (_e136.x & 65535u))];
                let _e189 = unpack2x16float(_e187.x);
                let _e201 = global_3.member[(_e183 + (_e136.x >> bitcast<u32>(16u)))];
                let _e203 = unpack2x16float(_e201.x);
                let _e215 = global_3.member[(_e183 + (_e136.y & 65535u))];
                let _e217 = unpack2x16float(_e215.x);
                let _e225 = ((((_e174.xyz + (_e177.xyz * vec3<f32>(f32((_e127.x & 65535u)), f32((_e127.x >> bitcast<u32>(16u))), f32((_e127.y & 65535u))))) + (vec3<f32>(_e189.x, _e189.y, unpack2x16float(_e187.y).x) * _e151)) + (vec3<f32>(_e203.x, _e203.y, unpack2x16float(_e201.y).x) * _e156)) + (vec3<f32>(_e217.x, _e217.y, unpack2x16float(_e215.y).x) * (_e152 - _e156)));
                let _e229 = vec4<f32>(_e225.x, _e225.y, _e225.z, 1f);
                let _e242 = (((_e127.y >> bitcast<u32>(16u)) | ((_e131.y >> bitcast<u32>(24u)) << bitcast<u32>(16u))) | ((_e136.y >> bitcast<u32>(26u)) << bitcast<u32>(24u)));
                let _e254 = global.member_36;
                let _e256 = global.member_37;
                let _e259 = (vec3(_e254) + (vec3<f32>(f32((_e242 & 1023u)), f32(((_e242 >> bitcast<u32>(10u)) & 1023u)), f32((_e242 >> bitcast<u32>(20u)))) * _e256));
                let _e268 = (vec4<u32>(_e131.x, (_e131.x >> bitcast<u32>(8u)), (_e131.x >> bitcast<u32>(16u)), (_e131.x >> bitcast<u32>(24u))) & vec4<u32>(255u, 255u, 255u, 255u));
                let _e274 = (vec3<u32>(_e131.y, (_e131.y >> bitcast<u32>(8u)), (_e131.y >> bitcast<u32>(16u))) & vec3<u32>(255u, 255u, 255u));
                let _e275 = vec3<f32>(_e274);
                let _e287 = (vec4<f32>(_e275.x, _e275.y, _e275.z, f32((((255u - _e274.x) - _e274.y) - _e274.z))) * vec4<f32>(0.003921569f, 0.003921569f, 0.003921569f, 0.003921569f));
                let _e290 = (3u * _e268.x);
                let _e293 = global.member_62[_e290];
                let _e298 = global.member_62[(_e290 + 1u)];
                let _e303 = global.member_62[(_e290 + 2u)];
                let _e307 = (3u * _e268.y);
                let _e310 = global.member_62[_e307];
                let _e316 = global.member_62[(_e307 + 1u)];
                let _e322 = global.member_62[(_e307 + 2u)];
                let _e327 = (3u * _e268.z);
                let _e330 = global.member_62[_e327];
                let _e336 = global.member_62[(_e327 + 1u)];
                let _e342 = global.member_62[(_e327 + 2u)];
                let _e347 = (3u * _e268.w);
                let _e350 = global.member_62[_e347];
                let _e352 = ((((_e293 * _e287.x) + (_e310 * _e287.y)) + (_e330 * _e287.z)) + (_e350 * _e287.w));
                let _e356 = global.member_62[(_e347 + 1u)];
                let _e358 = ((((_e298 * _e287.x) + (_e316 * _e287.y)) + (_e336 * _e287.z)) + (_e356 * _e287.w));
                let _e362 = global.member_62[(_e347 + 2u)];
                let _e364 = ((((_e303 * _e287.x) + (_e322 * _e287.y)) + (_e342 * _e287.z)) + (_e362 * _e287.w));
                let _e367 = dot(_e364, _e229);
                let _e368 = vec3<f32>(dot(_e352, _e229), dot(_e358, _e229), _e367);
                let _e369 = _e352.xyz;
                let _e370 = _e358.xyz;
                let _e371 = _e364.xyz;
                let _e383 = vec3<f32>(_e364.x, _e364.y, _e364.z);
                switch bitcast<i32>(0u) {
                    default: {
                        let _e401 = global.member_6;
                        if !((_e367 >= _e401)) {
                            let _e405 = global_2.member_9;
                            if (_e405 != 0u) {
                                let _e409 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_5229_ = 0f;
                            phi_5220_ = vec2<f32>(0f, 0f);
                            phi_5219_ = false;
                            break;
                        }
                        let _e411 = global.member;
                        let _e412 = _e368.xy;
                        let _e414 = vec2(_e367);
                        let _e417 = global.member_1;
                        let _e418 = (((_e411 * _e412) / _e414) + _e417);
                        let _e420 = global.member_5;
                        let _e424 = all((_e418 >= vec2(-(_e420))));
                        phi_3567_ = _e424;
                        if _e424 {
                            let _e426 = global.member_4;
                            phi_3567_ = all((_e418 <= (_e426 + vec2(_e420))));
                        }
                        let _e432 = phi_3567_;
                        if !(_e432) {
                            let _e435 = global_2.member_9;
                            if (_e435 != 0u) {
                                let _e439 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_5229_ = 0f;
                            phi_5220_ = _e418;
                            phi_5219_ = false;
                            break;
                        }
                        let _e441 = global.member_7;
                        let _e444 = global.member_8;
                        let _e445 = ((_e441 - _e367) * _e444);
                        if (_e445 < 0f) {
                            phi_5204_ = (0.015625f / (1f - _e445));
                        } else {
                            if (_e445 > 1f) {
                                phi_5203_ = (1f - (0.015625f / _e445));
                            } else {
                                phi_5203_ = (0.015625f + (0.96875f * clamp(_e445, 0f, 1f)));
                            }
                            let _e454 = phi_5203_;
                            phi_5204_ = _e454;
                        }
                        let _e458 = phi_5204_;
                        let _e459 = (_e412 / _e414);
                        let _e467 = global.member[0u];
                        let _e470 = global.member[1u];
                        let _e475 = global.member_31;
                        let _e476 = (_e475 > 0u);
                        phi_3616_ = _e476;
                        if _e476 {
                            let _e478 = global.member_34;
                            let _e481 = global.member_29;
                            let _e488 = global.member_49;
                            let _e492 = global.member_51;
                            switch bitcast<i32>(0u) {
                                default: {
                                    let _e498 = vec2(((sqrt((2f * log(max((max(255f, _e478) / _e481), 1f)))) * sqrt(_e488)) * ((((((1.2f * exp(min(max(max(_e259.x, _e259.y), _e259.z), 9f))) * sqrt(max(max(dot(_e369, _e369), dot(_e370, _e370)), dot(_e371, _e371)))) * length(vec3<f32>(_e459.x, _e459.y, 1f))) * max(_e467, _e470)) / _e367) + sqrt(_e492))));
                                    let _e501 = global.member_32;
                                    let _e504 = global.member_33;
                                    let _e512 = vec2<u32>(clamp(((((_e418 - _e498) - _e501) * _e504) - vec2<f32>(0.5f, 0.5f)), vec2<f32>(0f, 0f), vec2<f32>(191f, 191f)));
                                    let _e514 = vec2<u32>(clamp(((((_e418 + _e498) - _e501) * _e504) + vec2<f32>(0.5f, 0.5f)), vec2<f32>(0f, 0f), vec2<f32>(191f, 191f)));
                                    let _e521 = max((_e514.x - _e512.x), (_e514.y - _e512.y));
                                    if (_e521 <= 3u) {
                                        phi_5208_ = 0u;
                                    } else {
                                        phi_5208_ = (bitcast<u32>(firstLeadingBit((_e521 - 1u))) - 1u);
                                    }
                                    let _e528 = phi_5208_;
                                    if !((_e528 < 4u)) {
                                        phi_5218_ = false;
                                        break;
                                    }
                                    let _e538 = vec2(_e528);
                                    let _e540 = (_e512 >> bitcast<vec2<u32>>(_e538));
                                    let _e542 = (_e514 >> bitcast<vec2<u32>>(_e538));
                                    let _e544 = (_e540.x & 4294967292u);
                                    phi_5214_ = _e544;
                                    phi_5213_ = 0f;
                                    phi_5211_ = _e540.y;
                                    loop {
                                        let _e547 = phi_5214_;
                                        let _e549 = phi_5213_;
                                        let _e551 = phi_5211_;
                                        local_1 = _e549;
                                        if (_e551 <= _e542.y) {
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e556 = (vec4(f32(_e547)) + vec4<f32>(0f, 1f, 2f, 3f));
                                            let _e574 = global_3.member[((_e475 >> bitcast<u32>(1u)) + ((((4u * (12288u - (12288u >> bitcast<u32>((2u * _e528))))) + (_e551 * (192u >> bitcast<u32>(_e528)))) + _e547) >> bitcast<u32>(2u)))];
                                            let _e576 = unpack2x16unorm(_e574.x);
                                            let _e578 = unpack2x16unorm(_e574.y);
                                            let _e585 = select(select(vec4<f32>(_e576.x, _e576.y, _e578.x, _e578.y), vec4<f32>(0f, 0f, 0f, 0f), (_e556 < vec4(f32(_e540.x)))), vec4<f32>(0f, 0f, 0f, 0f), (_e556 > vec4(f32(_e542.x))));
                                            let _e594 = (_e547 + 4u);
                                            let _e595 = (_e594 > _e542.x);
                                            phi_5214_ = select(_e594, _e544, _e595);
                                            phi_5213_ = max(_e549, max(max(_e585.x, _e585.y), max(_e585.z, _e585.w)));
                                            phi_5211_ = (_e551 + select(0u, 1u, _e595));
                                        }
                                    }
                                    let _e600 = local_1;
                                    phi_5218_ = ((1f - _e458) > _e600);
                                    break;
                                }
                            }
                            let _e603 = phi_5218_;
                            phi_3616_ = _e603;
                        }
                        let _e605 = phi_3616_;
                        if _e605 {
                            let _e607 = global_2.member_9;
                            if (_e607 != 0u) {
                                let _e611 = atomicAdd((&global_1.member[1u]), 1u);
                            }
                            phi_5229_ = _e458;
                            phi_5220_ = _e418;
                            phi_5219_ = false;
                            break;
                        }
                        phi_5229_ = _e458;
                        phi_5220_ = _e418;
                        phi_5219_ = true;
                        break;
                    }
                }
                let _e613 = phi_5229_;
                let _e615 = phi_5220_;
                let _e617 = phi_5219_;
                if (true && !(_e617)) {
                    phi_5302_ = 4294967295u;
                    break;
                }
                let _e624 = global_7.member[((3u * _e76) + _e80)];
                let _e628 = f32((_e624.y >> bitcast<u32>(24u)));
                let _e630 = global.member_29;
                if (_e628 <= _e630) {
                    let _e633 = global_2.member_9;
                    if (_e633 != 0u) {
                        let _e637 = atomicAdd((&global_1.member[2u]), 1u);
                    }
                    phi_5302_ = 4294967295u;
                    break;
                }
                let _e651 = ((vec3<f32>(f32((_e624.x & 1023u)), f32(((_e624.x >> bitcast<u32>(10u)) & 1023u)), f32(((_e624.x >> bitcast<u32>(20u)) & 1023u))) - vec3<f32>(512f, 512f, 512f)) * vec3<f32>(0.0013888889f, 0.0013888889f, 0.0013888889f));
                let _e655 = sqrt(max((1f - dot(_e651, _e651)), 0f));
                let _e657 = (_e624.x >> bitcast<u32>(30u));
                if (_e657 == 0u) {
                    phi_5241_ = vec4<f32>(_e655, _e651.x, _e651.y, _e651.z);
                } else {
                    if (_e657 == 1u) {
                        phi_5240_ = vec4<f32>(_e651.x, _e655, _e651.y, _e651.z);
                    } else {
                        if (_e657 == 2u) {
                            phi_5239_ = vec4<f32>(_e651.x, _e651.y, _e655, _e651.z);
                        } else {
                            phi_5239_ = vec4<f32>(_e651.x, _e651.y, _e651.z, _e655);
                        }
                        let _e670 = phi_5239_;
                        phi_5240_ = _e670;
                    }
                    let _e676 = phi_5240_;
                    phi_5241_ = _e676;
                }
                let _e682 = phi_5241_;
                let _e686 = global.member_38;
                let _e687 = (_e686 > 0u);
                phi_5259_ = unpack4x8unorm(_e624.y).xyz;
                if _e687 {
                    let _e691 = global_7.member[(_e686 + _e80)];
                    let _e693 = unpack2x16float(_e691.x);
                    phi_5259_ = vec3<f32>(_e693.x, _e693.y, unpack2x16float(_e691.y).x);
                }
                let _e701 = phi_5259_;
                let _e704 = (1u << bitcast<u32>((_e80 & 31u)));
                let _e707 = global_7.member[_e84];
                let _e711 = global_7.member[(_e84 + 1u)];
                let _e715 = global_7.member[(_e84 + 2u)];
                phi_5276_ = _e682;
                if ((_e707.x & _e704) != 0u) {
                    let _e726 = global.member_22;
                    let _e728 = global.member_18;
                    let _e732 = (_e726 + ((_e711.y + bitcast<u32>(countOneBits((_e707.x & (_e704 - 1u))))) * (1u + (4u * _e728))));
                    let _e733 = (_e732 + 1u);
                    let _e736 = global_6.member[_e732];
                    let _e738 = global.member_44;
                    let _e742 = global.member_19;
                    phi_5261_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_5260_ = 0u;
                    loop {
                        let _e746 = phi_5261_;
                        let _e748 = phi_5260_;
                        let _e750 = (2u * ((_e738 + ((_e736 >> bitcast<u32>(16u)) * _e742)) + _e748));
                        let _e753 = global_3.member[_e750];
                        let _e757 = global_3.member[(_e750 + 1u)];
                        let _e763 = bitcast<vec4<f32>>(vec4<u32>(_e753.x, _e753.y, _e757.x, _e757.y));
                        let _e767 = global_6.member[(_e733 + _e748)];
                        let _e774 = global_6.member[((_e733 + _e728) + _e748)];
                        let _e782 = global_6.member[((_e733 + (2u * _e728)) + _e748)];
                        let _e790 = global_6.member[((_e733 + (3u * _e728)) + _e748)];
                        let _e794 = (_e746 + vec4<f32>(dot(unpack4x8snorm(_e767), _e763), dot(unpack4x8snorm(_e774), _e763), dot(unpack4x8snorm(_e782), _e763), dot(unpack4x8snorm(_e790), _e763)));
                        let _e796 = (_e748 + bitcast<u32>(1i));
                        phi_5261_ = _e794;
                        phi_5260_ = _e796;
                        local_2 = _e794;
                        if (_e796 < _e728) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e802 = local_2;
                    let _e804 = (_e682 + (_e802 * (127f * unpack2x16float(_e736).x)));
                    phi_5276_ = select(_e682, _e804, vec4((length(_e804) >= 0.001f)));
                }
                let _e810 = phi_5276_;
                phi_5280_ = _e259;
                if ((_e707.y & _e704) != 0u) {
                    let _e821 = global.member_23;
                    let _e823 = global.member_18;
                    let _e827 = (_e821 + ((_e715.x + bitcast<u32>(countOneBits((_e707.y & (_e704 - 1u))))) * (1u + (3u * _e823))));
                    let _e828 = (_e827 + 1u);
                    let _e831 = global_6.member[_e827];
                    let _e833 = global.member_44;
                    let _e837 = global.member_19;
                    phi_5264_ = vec3<f32>(0f, 0f, 0f);
                    phi_5263_ = 0u;
                    loop {
                        let _e841 = phi_5264_;
                        let _e843 = phi_5263_;
                        let _e845 = (2u * ((_e833 + ((_e831 >> bitcast<u32>(16u)) * _e837)) + _e843));
                        let _e848 = global_3.member[_e845];
                        let _e852 = global_3.member[(_e845 + 1u)];
                        let _e858 = bitcast<vec4<f32>>(vec4<u32>(_e848.x, _e848.y, _e852.x, _e852.y));
                        let _e862 = global_6.member[(_e828 + _e843)];
                        let _e869 = global_6.member[((_e828 + _e823) + _e843)];
                        let _e877 = global_6.member[((_e828 + (2u * _e823)) + _e843)];
                        let _e881 = (_e841 + vec3<f32>(dot(unpack4x8snorm(_e862), _e858), dot(unpack4x8snorm(_e869), _e858), dot(unpack4x8snorm(_e877), _e858)));
                        let _e883 = (_e843 + bitcast<u32>(1i));
                        phi_5264_ = _e881;
                        phi_5263_ = _e883;
                        local_3 = _e881;
                        if (_e883 < _e823) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e889 = local_3;
                    phi_5280_ = (_e259 + (_e889 * (127f * unpack2x16float(_e831).x)));
                }
                let _e893 = phi_5280_;
                phi_5282_ = _e701;
                if ((_e711.x & _e704) != 0u) {
                    let _e904 = global.member_24;
                    let _e906 = global.member_18;
                    let _e910 = (_e904 + ((_e715.y + bitcast<u32>(countOneBits((_e711.x & (_e704 - 1u))))) * (3u + (3u * _e906))));
                    let _e914 = global_6.member[(_e910 + 1u)];
                    let _e915 = unpack2x16float(_e914);
                    let _e919 = global_6.member[(_e910 + 2u)];
                    let _e927 = (_e910 + 3u);
                    let _e930 = global_6.member[_e910];
                    let _e932 = global.member_44;
                    let _e936 = global.member_19;
                    phi_5273_ = vec3<f32>(0f, 0f, 0f);
                    phi_5272_ = 0u;
                    loop {
                        let _e940 = phi_5273_;
                        let _e942 = phi_5272_;
                        let _e944 = (2u * ((_e932 + ((_e930 >> bitcast<u32>(16u)) * _e936)) + _e942));
                        let _e947 = global_3.member[_e944];
                        let _e951 = global_3.member[(_e944 + 1u)];
                        let _e957 = bitcast<vec4<f32>>(vec4<u32>(_e947.x, _e947.y, _e951.x, _e951.y));
                        let _e961 = global_6.member[(_e927 + _e942)];
                        let _e968 = global_6.member[((_e927 + _e906) + _e942)];
                        let _e976 = global_6.member[((_e927 + (2u * _e906)) + _e942)];
                        let _e980 = (_e940 + vec3<f32>(dot(unpack4x8snorm(_e961), _e957), dot(unpack4x8snorm(_e968), _e957), dot(unpack4x8snorm(_e976), _e957)));
                        let _e982 = (_e942 + bitcast<u32>(1i));
                        phi_5273_ = _e980;
                        phi_5272_ = _e982;
                        local_4 = _e980;
                        if (_e982 < _e906) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e988 = local_4;
                    phi_5282_ = (select(vec3<f32>(_e915.x, _e915.y, unpack2x16float(_e919).x), _e701, vec3(_e687)) + (_e988 * (127f * unpack2x16float(_e930).x)));
                }
                let _e992 = phi_5282_;
                let _e993 = normalize(_e810);
                let _e998 = (_e993.z * _e993.z);
                let _e999 = (_e993.w * _e993.w);
                let _e1003 = (_e993.y * _e993.z);
                let _e1004 = (_e993.x * _e993.w);
                let _e1007 = (_e993.y * _e993.w);
                let _e1008 = (_e993.x * _e993.z);
                let _e1013 = (_e993.y * _e993.y);
                let _e1017 = (_e993.z * _e993.w);
                let _e1018 = (_e993.x * _e993.y);
                let _e1032 = exp(min(_e893, vec3<f32>(9f, 9f, 9f)));
                let _e1039 = mat3x3<f32>((vec3<f32>((1f - (2f * (_e998 + _e999))), (2f * (_e1003 + _e1004)), (2f * (_e1007 - _e1008))) * _e1032.x), (vec3<f32>((2f * (_e1003 - _e1004)), (1f - (2f * (_e1013 + _e999))), (2f * (_e1017 + _e1018))) * _e1032.y), (vec3<f32>((2f * (_e1007 + _e1008)), (2f * (_e1017 - _e1018)), (1f - (2f * (_e1013 + _e998)))) * _e1032.z));
                switch bitcast<i32>(0u) {
                    default: {
                        let _e1045 = global.member_2;
                        let _e1047 = global.member_3;
                        let _e1048 = clamp((_e368.xy / vec2(_e367)), _e1045, _e1047);
                        let _e1051 = global.member[0u];
                        let _e1057 = (((vec3<f32>(_e352.x, _e352.y, _e352.z) - (_e383 * _e1048.x)) * (_e1051 / _e367)) * _e1039);
                        let _e1060 = global.member[1u];
                        let _e1066 = (((vec3<f32>(_e358.x, _e358.y, _e358.z) - (_e383 * _e1048.y)) * (_e1060 / _e367)) * _e1039);
                        let _e1068 = global.member_51;
                        let _e1070 = (dot(_e1057, _e1057) + _e1068);
                        let _e1073 = (dot(_e1066, _e1066) + _e1068);
                        let _e1075 = cross(_e1057, _e1066);
                        let _e1076 = dot(_e1075, _e1075);
                        let _e1080 = (_e1076 + (_e1068 * ((_e1070 + _e1073) - _e1068)));
                        let _e1081 = (_e1080 > 0f);
                        phi_4662_ = _e1081;
                        if _e1081 {
                            phi_4662_ = (_e1070 <= 1000000000000000000f);
                        }
                        let _e1084 = phi_4662_;
                        phi_4668_ = _e1084;
                        if _e1084 {
                            phi_4668_ = (_e1073 <= 1000000000000000000f);
                        }
                        let _e1087 = phi_4668_;
                        if !(_e1087) {
                            let _e1090 = global_2.member_9;
                            if (_e1090 != 0u) {
                                let _e1094 = atomicAdd((&global_1.member[3u]), 1u);
                            }
                            phi_5301_ = 4294967295u;
                            break;
                        }
                        phi_5287_ = (1f - (_e628 * 0.003921569f));
                        phi_5286_ = 0u;
                        loop {
                            let _e1098 = phi_5287_;
                            let _e1100 = phi_5286_;
                            local_5 = _e1098;
                            if (_e1100 < _e78) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                phi_5287_ = (_e1098 * _e1098);
                                phi_5286_ = (_e1100 + bitcast<u32>(1i));
                            }
                        }
                        let _e1106 = local_5;
                        let _e1110 = u32(round((255f * (1f - _e1106))));
                        let _e1112 = global.member_52;
                        phi_5295_ = _e1110;
                        if (_e1112 > 0f) {
                            let _e1122 = u32(round((f32(_e1110) * ((1f - _e1112) + (_e1112 * sqrt((_e1076 / _e1080)))))));
                            if (f32(_e1122) <= _e630) {
                                let _e1126 = global_2.member_9;
                                if (_e1126 != 0u) {
                                    let _e1130 = atomicAdd((&global_1.member[2u]), 1u);
                                }
                                phi_5301_ = 4294967295u;
                                break;
                            }
                            phi_5295_ = _e1122;
                        }
                        let _e1132 = phi_5295_;
                        let _e1134 = global.member_49;
                        let _e1135 = (vec3<f32>(_e1070, dot(_e1057, _e1066), _e1073) * _e1134);
                        let _e1148 = global.member_53;
                        let _e1149 = ((sqrt(_e1135.xz) * sqrt((2f * log(max((f32(_e1132) / _e630), 1f))))) * _e1148);
                        let _e1152 = global.member_54;
                        let _e1155 = all(((_e615 + _e1149) > _e1152.xy));
                        phi_4746_ = _e1155;
                        if _e1155 {
                            phi_4746_ = all(((_e615 - _e1149) < _e1152.zw));
                        }
                        let _e1161 = phi_4746_;
                        if !(_e1161) {
                            let _e1164 = global_2.member_9;
                            if (_e1164 != 0u) {
                                let _e1168 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_5301_ = 4294967295u;
                            break;
                        }
                        let _e1173 = (0.5f * (_e1135.x - _e1135.z));
                        let _e1178 = sqrt(((_e1173 * _e1173) + (_e1135.y * _e1135.y)));
                        let _e1181 = ((0.5f * (_e1135.x + _e1135.z)) + _e1178);
                        if (_e1173 >= 0f) {
                            phi_5299_ = vec2<f32>((_e1173 + _e1178), _e1135.y);
                        } else {
                            phi_5299_ = vec2<f32>(_e1135.y, (_e1178 - _e1173));
                        }
                        let _e1188 = phi_5299_;
                        let _e1189 = length(_e1188);
                        if (_e1189 > 0f) {
                            phi_5300_ = (_e1188 / vec2(_e1189));
                        } else {
                            phi_5300_ = vec2<f32>(1f, 0f);
                        }
                        let _e1194 = phi_5300_;
                        let _e1201 = global.member_5;
                        let _e1205 = global.member_10;
                        let _e1209 = vec2<u32>(clamp(round(((_e615 + vec2(_e1201)) * _e1205)), vec2<f32>(0f, 0f), vec2<f32>(1048575f, 1048575f)));
                        let _e1212 = vec3<u32>(round((clamp(_e992, vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 1023f)));
                        let _e1240 = global.member_45;
                        let _e1242 = (4u * (_e1240 + _e70));
                        global_4.member[_e1242] = ((_e1209.x | (_e1212.x << bitcast<u32>(20u))) | (_e1212.z << bitcast<u32>(30u)));
                        global_4.member[(_e1242 + 1u)] = (_e1209.y | (_e1212.y << bitcast<u32>(20u)));
                        global_4.member[(_e1242 + 2u)] = pack2x16float((_e1194 * min(sqrt(_e1181), 65504f)));
                        global_4.member[(_e1242 + 3u)] = ((pack2x16float(vec2<f32>(min(sqrt(((_e1080 * (_e1134 * _e1134)) / _e1181)), 65504f), 0f)) | (_e1132 << bitcast<u32>(16u))) | ((_e1212.z >> bitcast<u32>(2u)) << bitcast<u32>(24u)));
                        let _e1255 = global.member_9;
                        phi_5301_ = min(u32((_e613 * f32(_e1255))), _e1255);
                        break;
                    }
                }
                let _e1261 = phi_5301_;
                phi_5302_ = _e1261;
                break;
            }
        }
        let _e1263 = phi_5302_;
        phi_5303_ = _e1263;
    } else {
        phi_5303_ = 4294967295u;
    }
    let _e1265 = phi_5303_;
    switch bitcast<i32>(0u) {
        default: {
            let _e1268 = bitcast<u32>(param[0u]);
            let _e1270 = global.member_45;
            let _e1271 = (_e1270 + _e70);
            if (_e1265 != 4294967295u) {
                let _e1274 = global.member_41;
                let _e1278 = global.member_40;
                let _e1284 = atomicAdd((&global_1.member[((_e1278 + ((_e1271 / _e1274) * 256u)) + (_e1265 & 255u))]), 1u);
            }
            let _e1286 = global.member_39;
            if (_e1286 == 0u) {
                if (_e70 < (_e72 + (_e72 & 1u))) {
                    let _e1292 = global.member_28;
                    global_4.member[(_e1292 + _e1271)] = _e1265;
                }
                break;
            }
            global_5[_e1268] = _e1265;
            workgroupBarrier();
            let _e1298 = ((_e1268 & 1u) == 0u);
            if select(_e1298, _e73, _e1298) {
                let _e1301 = global.member_28;
                let _e1308 = global_5[(_e1268 + 1u)];
                global_4.member[(_e1301 + (_e1271 >> bitcast<u32>(1u)))] = ((_e1265 & 65535u) | (_e1308 << bitcast<u32>(16u)));
            }
            break;
        }
    }
    return;
}
