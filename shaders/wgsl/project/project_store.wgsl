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
    var phi_3602_: bool;
    var phi_5559_: f32;
    var phi_5560_: f32;
    var phi_5564_: u32;
    var phi_5570_: u32;
    var phi_5569_: f32;
    var phi_5567_: u32;
    var local: f32;
    var phi_5574_: bool;
    var phi_3651_: bool;
    var phi_5585_: f32;
    var phi_5576_: vec2<f32>;
    var phi_5575_: bool;
    var phi_5595_: vec4<f32>;
    var phi_5596_: vec4<f32>;
    var phi_5597_: vec4<f32>;
    var phi_5615_: vec3<f32>;
    var phi_5617_: vec4<f32>;
    var phi_5616_: u32;
    var local_1: vec4<f32>;
    var phi_5632_: vec4<f32>;
    var phi_5620_: vec3<f32>;
    var phi_5619_: u32;
    var local_2: vec3<f32>;
    var phi_5636_: vec3<f32>;
    var phi_5629_: vec3<f32>;
    var phi_5628_: u32;
    var local_3: vec3<f32>;
    var phi_5638_: vec3<f32>;
    var phi_5639_: vec3<f32>;
    var phi_5641_: vec3<f32>;
    var phi_5643_: vec3<f32>;
    var phi_3184_: bool;
    var phi_3198_: bool;
    var phi_4993_: bool;
    var phi_4999_: bool;
    var phi_5658_: f32;
    var phi_5657_: u32;
    var local_4: f32;
    var phi_5666_: u32;
    var phi_5077_: bool;
    var phi_5670_: vec2<f32>;
    var phi_5671_: vec2<f32>;
    var phi_5672_: u32;
    var phi_5673_: u32;
    var phi_5674_: u32;

    let _e82 = bitcast<u32>(param_1[0u]);
    let _e84 = global.member_48;
    let _e85 = (_e82 < _e84);
    if _e85 {
        switch bitcast<i32>(0u) {
            default: {
                let _e88 = global.member_14;
                let _e90 = global.member_47;
                let _e92 = (_e82 << bitcast<u32>(_e90));
                let _e96 = (4u * (_e88 + (_e92 >> bitcast<u32>(5u))));
                let _e97 = (2u * _e92);
                let _e100 = global_7.member[_e97];
                let _e104 = global_7.member[(_e97 + 1u)];
                let _e109 = global_7.member[((2u * _e88) + _e92)];
                let _e120 = (vec2<f32>(f32(((_e109.y >> bitcast<u32>(16u)) & 31u)), f32(((_e109.y >> bitcast<u32>(21u)) & 31u))) * vec2<f32>(0.032258064f, 0.032258064f));
                let _e124 = ((1f + (2f * _e120.x)) * 0.33333334f);
                let _e125 = (1f - _e124);
                let _e129 = (_e125 * (0.5f + (0.5f * _e120.y)));
                let _e147 = global.member_11;
                let _e150 = global.member_12;
                let _e155 = global.member_21;
                let _e156 = (2u * _e155);
                let _e160 = global_3.member[(_e156 + (_e109.x & 65535u))];
                let _e162 = unpack2x16float(_e160.x);
                let _e174 = global_3.member[(_e156 + (_e109.x >> bitcast<u32>(16u)))];
                let _e176 = unpack2x16float(_e174.x);
                let _e188 = global_3.member[(_e156 + (_e109.y & 65535u))];
                let _e190 = unpack2x16float(_e188.x);
                let _e198 = ((((_e147.xyz + (_e150.xyz * vec3<f32>(f32((_e100.x & 65535u)), f32((_e100.x >> bitcast<u32>(16u))), f32((_e100.y & 65535u))))) + (vec3<f32>(_e162.x, _e162.y, unpack2x16float(_e160.y).x) * _e124)) + (vec3<f32>(_e176.x, _e176.y, unpack2x16float(_e174.y).x) * _e129)) + (vec3<f32>(_e190.x, _e190.y, unpack2x16float(_e188.y).x) * (_e125 - _e129)));
                let _e202 = vec4<f32>(_e198.x, _e198.y, _e198.z, 1f);
                let _e215 = (((_e100.y >> bitcast<u32>(16u)) | ((_e104.y >> bitcast<u32>(24u)) << bitcast<u32>(16u))) | ((_e109.y >> bitcast<u32>(26u)) << bitcast<u32>(24u)));
                let _e227 = global.member_36;
                let _e229 = global.member_37;
                let _e232 = (vec3(_e227) + (vec3<f32>(f32((_e215 & 1023u)), f32(((_e215 >> bitcast<u32>(10u)) & 1023u)), f32((_e215 >> bitcast<u32>(20u)))) * _e229));
                let _e241 = (vec4<u32>(_e104.x, (_e104.x >> bitcast<u32>(8u)), (_e104.x >> bitcast<u32>(16u)), (_e104.x >> bitcast<u32>(24u))) & vec4<u32>(255u, 255u, 255u, 255u));
                let _e247 = (vec3<u32>(_e104.y, (_e104.y >> bitcast<u32>(8u)), (_e104.y >> bitcast<u32>(16u))) & vec3<u32>(255u, 255u, 255u));
                let _e248 = vec3<f32>(_e247);
                let _e260 = (vec4<f32>(_e248.x, _e248.y, _e248.z, f32((((255u - _e247.x) - _e247.y) - _e247.z))) * vec4<f32>(0.003921569f, 0.003921569f, 0.003921569f, 0.003921569f));
                let _e263 = (3u * _e241.x);
                let _e266 = global.member_62[_e263];
                let _e271 = global.member_62[(_e263 + 1u)];
                let _e276 = global.member_62[(_e263 + 2u)];
                let _e280 = (3u * _e241.y);
                let _e283 = global.member_62[_e280];
                let _e289 = global.member_62[(_e280 + 1u)];
                let _e295 = global.member_62[(_e280 + 2u)];
                let _e300 = (3u * _e241.z);
                let _e303 = global.member_62[_e300];
                let _e309 = global.member_62[(_e300 + 1u)];
                let _e315 = global.member_62[(_e300 + 2u)];
                let _e320 = (3u * _e241.w);
                let _e323 = global.member_62[_e320];
                let _e325 = ((((_e266 * _e260.x) + (_e283 * _e260.y)) + (_e303 * _e260.z)) + (_e323 * _e260.w));
                let _e329 = global.member_62[(_e320 + 1u)];
                let _e331 = ((((_e271 * _e260.x) + (_e289 * _e260.y)) + (_e309 * _e260.z)) + (_e329 * _e260.w));
                let _e335 = global.member_62[(_e320 + 2u)];
                let _e337 = ((((_e276 * _e260.x) + (_e295 * _e260.y)) + (_e315 * _e260.z)) + (_e335 * _e260.w));
                let _e340 = dot(_e337, _e202);
                let _e341 = vec3<f32>(dot(_e325, _e202), dot(_e331, _e202), _e340);
                let _e342 = _e325.xyz;
                let _e343 = _e331.xyz;
                let _e344 = _e337.xyz;
                let _e354 = vec3<f32>(_e325.x, _e325.y, _e325.z);
                let _e355 = vec3<f32>(_e331.x, _e331.y, _e331.z);
                let _e356 = vec3<f32>(_e337.x, _e337.y, _e337.z);
                let _e372 = ((1.2f * exp(min(max(max(_e232.x, _e232.y), _e232.z), 9f))) * sqrt(max(max(dot(_e342, _e342), dot(_e343, _e343)), dot(_e344, _e344))));
                switch bitcast<i32>(0u) {
                    default: {
                        let _e375 = global.member_6;
                        if !((_e340 >= _e375)) {
                            let _e379 = global_2.member_9;
                            if (_e379 != 0u) {
                                let _e383 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_5585_ = 0f;
                            phi_5576_ = vec2<f32>(0f, 0f);
                            phi_5575_ = false;
                            break;
                        }
                        let _e385 = global.member;
                        let _e386 = _e341.xy;
                        let _e388 = vec2(_e340);
                        let _e391 = global.member_1;
                        let _e392 = (((_e385 * _e386) / _e388) + _e391);
                        let _e394 = global.member_5;
                        let _e398 = all((_e392 >= vec2(-(_e394))));
                        phi_3602_ = _e398;
                        if _e398 {
                            let _e400 = global.member_4;
                            phi_3602_ = all((_e392 <= (_e400 + vec2(_e394))));
                        }
                        let _e406 = phi_3602_;
                        if !(_e406) {
                            let _e409 = global_2.member_9;
                            if (_e409 != 0u) {
                                let _e413 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_5585_ = 0f;
                            phi_5576_ = _e392;
                            phi_5575_ = false;
                            break;
                        }
                        let _e415 = global.member_7;
                        let _e418 = global.member_8;
                        let _e419 = ((_e415 - _e340) * _e418);
                        if (_e419 < 0f) {
                            phi_5560_ = (0.015625f / (1f - _e419));
                        } else {
                            if (_e419 > 1f) {
                                phi_5559_ = (1f - (0.015625f / _e419));
                            } else {
                                phi_5559_ = (0.015625f + (0.96875f * clamp(_e419, 0f, 1f)));
                            }
                            let _e428 = phi_5559_;
                            phi_5560_ = _e428;
                        }
                        let _e432 = phi_5560_;
                        let _e433 = (_e386 / _e388);
                        let _e441 = global.member[0u];
                        let _e444 = global.member[1u];
                        let _e449 = global.member_31;
                        let _e450 = (_e449 > 0u);
                        phi_3651_ = _e450;
                        if _e450 {
                            let _e452 = global.member_34;
                            let _e455 = global.member_29;
                            let _e462 = global.member_49;
                            let _e466 = global.member_51;
                            switch bitcast<i32>(0u) {
                                default: {
                                    let _e472 = vec2(((sqrt((2f * log(max((max(255f, _e452) / _e455), 1f)))) * sqrt(_e462)) * ((((_e372 * length(vec3<f32>(_e433.x, _e433.y, 1f))) * max(_e441, _e444)) / _e340) + sqrt(_e466))));
                                    let _e475 = global.member_32;
                                    let _e478 = global.member_33;
                                    let _e486 = vec2<u32>(clamp(((((_e392 - _e472) - _e475) * _e478) - vec2<f32>(0.5f, 0.5f)), vec2<f32>(0f, 0f), vec2<f32>(191f, 191f)));
                                    let _e488 = vec2<u32>(clamp(((((_e392 + _e472) - _e475) * _e478) + vec2<f32>(0.5f, 0.5f)), vec2<f32>(0f, 0f), vec2<f32>(191f, 191f)));
                                    let _e495 = max((_e488.x - _e486.x), (_e488.y - _e486.y));
                                    if (_e495 <= 3u) {
                                        phi_5564_ = 0u;
                                    } else {
                                        phi_5564_ = (bitcast<u32>(firstLeadingBit((_e495 - 1u))) - 1u);
                                    }
                                    let _e502 = phi_5564_;
                                    if !((_e502 < 4u)) {
                                        phi_5574_ = false;
                                        break;
                                    }
                                    let _e512 = vec2(_e502);
                                    let _e514 = (_e486 >> bitcast<vec2<u32>>(_e512));
                                    let _e516 = (_e488 >> bitcast<vec2<u32>>(_e512));
                                    let _e518 = (_e514.x & 4294967292u);
                                    phi_5570_ = _e518;
                                    phi_5569_ = 0f;
                                    phi_5567_ = _e514.y;
                                    loop {
                                        let _e521 = phi_5570_;
                                        let _e523 = phi_5569_;
                                        let _e525 = phi_5567_;
                                        local = _e523;
                                        if (_e525 <= _e516.y) {
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e530 = (vec4(f32(_e521)) + vec4<f32>(0f, 1f, 2f, 3f));
                                            let _e548 = global_3.member[((_e449 >> bitcast<u32>(1u)) + ((((4u * (12288u - (12288u >> bitcast<u32>((2u * _e502))))) + (_e525 * (192u >> bitcast<u32>(_e502)))) + _e521) >> bitcast<u32>(2u)))];
                                            let _e550 = unpack2x16unorm(_e548.x);
                                            let _e552 = unpack2x16unorm(_e548.y);
                                            let _e559 = select(select(vec4<f32>(_e550.x, _e550.y, _e552.x, _e552.y), vec4<f32>(0f, 0f, 0f, 0f), (_e530 < vec4(f32(_e514.x)))), vec4<f32>(0f, 0f, 0f, 0f), (_e530 > vec4(f32(_e516.x))));
                                            let _e568 = (_e521 + 4u);
                                            let _e569 = (_e568 > _e516.x);
                                            phi_5570_ = select(_e568, _e518, _e569);
                                            phi_5569_ = max(_e523, max(max(_e559.x, _e559.y), max(_e559.z, _e559.w)));
                                            phi_5567_ = (_e525 + select(0u, 1u, _e569));
                                        }
                                    }
                                    let _e574 = local;
                                    phi_5574_ = ((1f - _e432) > _e574);
                                    break;
                                }
                            }
                            let _e577 = phi_5574_;
                            phi_3651_ = _e577;
                        }
                        let _e579 = phi_3651_;
                        if _e579 {
                            let _e581 = global_2.member_9;
                            if (_e581 != 0u) {
                                let _e585 = atomicAdd((&global_1.member[1u]), 1u);
                            }
                            phi_5585_ = _e432;
                            phi_5576_ = _e392;
                            phi_5575_ = false;
                            break;
                        }
                        phi_5585_ = _e432;
                        phi_5576_ = _e392;
                        phi_5575_ = true;
                        break;
                    }
                }
                let _e587 = phi_5585_;
                let _e589 = phi_5576_;
                let _e591 = phi_5575_;
                let _e596 = global_7.member[((3u * _e88) + _e92)];
                let _e599 = (_e596.y >> bitcast<u32>(24u));
                let _e613 = ((vec3<f32>(f32((_e596.x & 1023u)), f32(((_e596.x >> bitcast<u32>(10u)) & 1023u)), f32(((_e596.x >> bitcast<u32>(20u)) & 1023u))) - vec3<f32>(512f, 512f, 512f)) * vec3<f32>(0.0013888889f, 0.0013888889f, 0.0013888889f));
                let _e617 = sqrt(max((1f - dot(_e613, _e613)), 0f));
                let _e619 = (_e596.x >> bitcast<u32>(30u));
                if (_e619 == 0u) {
                    phi_5597_ = vec4<f32>(_e617, _e613.x, _e613.y, _e613.z);
                } else {
                    if (_e619 == 1u) {
                        phi_5596_ = vec4<f32>(_e613.x, _e617, _e613.y, _e613.z);
                    } else {
                        if (_e619 == 2u) {
                            phi_5595_ = vec4<f32>(_e613.x, _e613.y, _e617, _e613.z);
                        } else {
                            phi_5595_ = vec4<f32>(_e613.x, _e613.y, _e613.z, _e617);
                        }
                        let _e632 = phi_5595_;
                        phi_5596_ = _e632;
                    }
                    let _e638 = phi_5596_;
                    phi_5597_ = _e638;
                }
                let _e644 = phi_5597_;
                let _e648 = global.member_38;
                let _e649 = (_e648 > 0u);
                phi_5615_ = unpack4x8unorm(_e596.y).xyz;
                if _e649 {
                    let _e653 = global_7.member[(_e648 + _e92)];
                    let _e655 = unpack2x16float(_e653.x);
                    phi_5615_ = vec3<f32>(_e655.x, _e655.y, unpack2x16float(_e653.y).x);
                }
                let _e663 = phi_5615_;
                let _e666 = (1u << bitcast<u32>((_e92 & 31u)));
                let _e669 = global_7.member[_e96];
                let _e673 = global_7.member[(_e96 + 1u)];
                let _e677 = global_7.member[(_e96 + 2u)];
                phi_5632_ = _e644;
                if ((_e669.x & _e666) != 0u) {
                    let _e688 = global.member_22;
                    let _e690 = global.member_18;
                    let _e694 = (_e688 + ((_e673.y + bitcast<u32>(countOneBits((_e669.x & (_e666 - 1u))))) * (1u + (4u * _e690))));
                    let _e695 = (_e694 + 1u);
                    let _e698 = global_6.member[_e694];
                    let _e700 = global.member_44;
                    let _e704 = global.member_19;
                    phi_5617_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_5616_ = 0u;
                    loop {
                        let _e708 = phi_5617_;
                        let _e710 = phi_5616_;
                        let _e712 = (2u * ((_e700 + ((_e698 >> bitcast<u32>(16u)) * _e704)) + _e710));
                        let _e715 = global_3.member[_e712];
                        let _e719 = global_3.member[(_e712 + 1u)];
                        let _e725 = bitcast<vec4<f32>>(vec4<u32>(_e715.x, _e715.y, _e719.x, _e719.y));
                        let _e729 = global_6.member[(_e695 + _e710)];
                        let _e736 = global_6.member[((_e695 + _e690) + _e710)];
                        let _e744 = global_6.member[((_e695 + (2u * _e690)) + _e710)];
                        let _e752 = global_6.member[((_e695 + (3u * _e690)) + _e710)];
                        let _e756 = (_e708 + vec4<f32>(dot(unpack4x8snorm(_e729), _e725), dot(unpack4x8snorm(_e736), _e725), dot(unpack4x8snorm(_e744), _e725), dot(unpack4x8snorm(_e752), _e725)));
                        let _e758 = (_e710 + bitcast<u32>(1i));
                        phi_5617_ = _e756;
                        phi_5616_ = _e758;
                        local_1 = _e756;
                        if (_e758 < _e690) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e764 = local_1;
                    let _e766 = (_e644 + (_e764 * (127f * unpack2x16float(_e698).x)));
                    phi_5632_ = select(_e644, _e766, vec4((length(_e766) >= 0.001f)));
                }
                let _e772 = phi_5632_;
                phi_5636_ = _e232;
                if ((_e669.y & _e666) != 0u) {
                    let _e783 = global.member_23;
                    let _e785 = global.member_18;
                    let _e789 = (_e783 + ((_e677.x + bitcast<u32>(countOneBits((_e669.y & (_e666 - 1u))))) * (1u + (3u * _e785))));
                    let _e790 = (_e789 + 1u);
                    let _e793 = global_6.member[_e789];
                    let _e795 = global.member_44;
                    let _e799 = global.member_19;
                    phi_5620_ = vec3<f32>(0f, 0f, 0f);
                    phi_5619_ = 0u;
                    loop {
                        let _e803 = phi_5620_;
                        let _e805 = phi_5619_;
                        let _e807 = (2u * ((_e795 + ((_e793 >> bitcast<u32>(16u)) * _e799)) + _e805));
                        let _e810 = global_3.member[_e807];
                        let _e814 = global_3.member[(_e807 + 1u)];
                        let _e820 = bitcast<vec4<f32>>(vec4<u32>(_e810.x, _e810.y, _e814.x, _e814.y));
                        let _e824 = global_6.member[(_e790 + _e805)];
                        let _e831 = global_6.member[((_e790 + _e785) + _e805)];
                        let _e839 = global_6.member[((_e790 + (2u * _e785)) + _e805)];
                        let _e843 = (_e803 + vec3<f32>(dot(unpack4x8snorm(_e824), _e820), dot(unpack4x8snorm(_e831), _e820), dot(unpack4x8snorm(_e839), _e820)));
                        let _e845 = (_e805 + bitcast<u32>(1i));
                        phi_5620_ = _e843;
                        phi_5619_ = _e845;
                        local_2 = _e843;
                        if (_e845 < _e785) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e851 = local_2;
                    phi_5636_ = (_e232 + (_e851 * (127f * unpack2x16float(_e793).x)));
                }
                let _e855 = phi_5636_;
                phi_5638_ = _e663;
                if ((_e673.x & _e666) != 0u) {
                    let _e866 = global.member_24;
                    let _e868 = global.member_18;
                    let _e872 = (_e866 + ((_e677.y + bitcast<u32>(countOneBits((_e673.x & (_e666 - 1u))))) * (3u + (3u * _e868))));
                    let _e876 = global_6.member[(_e872 + 1u)];
                    let _e877 = unpack2x16float(_e876);
                    let _e881 = global_6.member[(_e872 + 2u)];
                    let _e889 = (_e872 + 3u);
                    let _e892 = global_6.member[_e872];
                    let _e894 = global.member_44;
                    let _e898 = global.member_19;
                    phi_5629_ = vec3<f32>(0f, 0f, 0f);
                    phi_5628_ = 0u;
                    loop {
                        let _e902 = phi_5629_;
                        let _e904 = phi_5628_;
                        let _e906 = (2u * ((_e894 + ((_e892 >> bitcast<u32>(16u)) * _e898)) + _e904));
                        let _e909 = global_3.member[_e906];
                        let _e913 = global_3.member[(_e906 + 1u)];
                        let _e919 = bitcast<vec4<f32>>(vec4<u32>(_e909.x, _e909.y, _e913.x, _e913.y));
                        let _e923 = global_6.member[(_e889 + _e904)];
                        let _e930 = global_6.member[((_e889 + _e868) + _e904)];
                        let _e938 = global_6.member[((_e889 + (2u * _e868)) + _e904)];
                        let _e942 = (_e902 + vec3<f32>(dot(unpack4x8snorm(_e923), _e919), dot(unpack4x8snorm(_e930), _e919), dot(unpack4x8snorm(_e938), _e919)));
                        let _e944 = (_e904 + bitcast<u32>(1i));
                        phi_5629_ = _e942;
                        phi_5628_ = _e944;
                        local_3 = _e942;
                        if (_e944 < _e868) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e950 = local_3;
                    phi_5638_ = (select(vec3<f32>(_e877.x, _e877.y, unpack2x16float(_e881).x), _e663, vec3(_e649)) + (_e950 * (127f * unpack2x16float(_e892).x)));
                }
                let _e954 = phi_5638_;
                let _e955 = normalize(_e772);
                let _e960 = (_e955.z * _e955.z);
                let _e961 = (_e955.w * _e955.w);
                let _e965 = (_e955.y * _e955.z);
                let _e966 = (_e955.x * _e955.w);
                let _e969 = (_e955.y * _e955.w);
                let _e970 = (_e955.x * _e955.z);
                let _e975 = (_e955.y * _e955.y);
                let _e979 = (_e955.z * _e955.w);
                let _e980 = (_e955.x * _e955.y);
                let _e994 = exp(min(_e855, vec3<f32>(9f, 9f, 9f)));
                let _e1001 = mat3x3<f32>((vec3<f32>((1f - (2f * (_e960 + _e961))), (2f * (_e965 + _e966)), (2f * (_e969 - _e970))) * _e994.x), (vec3<f32>((2f * (_e965 - _e966)), (1f - (2f * (_e975 + _e961))), (2f * (_e979 + _e980))) * _e994.y), (vec3<f32>((2f * (_e969 + _e970)), (2f * (_e979 - _e980)), (1f - (2f * (_e975 + _e960)))) * _e994.z));
                let _e1003 = (transpose(mat3x3<f32>(_e354, _e355, _e356)) * _e1001);
                let _e1005 = global.member_42;
                let _e1007 = (_e1005 + (3u * _e82));
                let _e1008 = transpose(_e1003);
                let _e1018 = max(_e372, sqrt(max(max(dot(_e1008[0], _e1008[0]), dot(_e1008[1], _e1008[1])), dot(_e1008[2], _e1008[2]))));
                let _e1020 = global.member_43;
                let _e1031 = (all((abs(_e341) < vec3<f32>(1000000000000000000000000000000f, 1000000000000000000000000000000f, 1000000000000000000000000000000f))) && (_e1018 <= 1000000000000000000f));
                if _e1031 {
                    let _e1033 = global.member_55;
                    let _e1037 = global.member_56;
                    phi_5639_ = ((_e341 - _e1033.xyz) / _e1037.xyz);
                } else {
                    phi_5639_ = vec3<f32>(0f, 0f, 0f);
                }
                let _e1041 = phi_5639_;
                let _e1058 = vec3<u32>(round((clamp(select(select((vec3<f32>(0.015625f, 0.015625f, 0.015625f) + (clamp(_e1041, vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 0.96875f)), (vec3<f32>(0.015625f, 0.015625f, 0.015625f) / (vec3<f32>(1f, 1f, 1f) - min(_e1041, vec3<f32>(0f, 0f, 0f)))), (_e1041 < vec3<f32>(0f, 0f, 0f))), (vec3<f32>(1f, 1f, 1f) - (vec3<f32>(0.015625f, 0.015625f, 0.015625f) / max(_e1041, vec3<f32>(1f, 1f, 1f)))), (_e1041 > vec3<f32>(1f, 1f, 1f))), vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 16777215f)));
                let _e1060 = (_e1058 >> bitcast<vec3<u32>>(vec3<u32>(8u, 8u, 8u)));
                let _e1061 = (_e1058 & vec3<u32>(255u, 255u, 255u));
                let _e1077 = ((_e1060.z | (u32(clamp(select(0f, ceil(((8f * log2(max((_e1018 / _e1020), 0.000000000000000000000000000001f))) + 152f)), _e1031), 0f, 255f)) << bitcast<u32>(16u))) | (select(0u, _e599, _e1031) << bitcast<u32>(24u)));
                let _e1094 = vec3<f32>(_e1003[0].x, _e1003[1].x, _e1003[2].x);
                let _e1101 = vec3<f32>(_e1003[0].y, _e1003[1].y, _e1003[2].y);
                let _e1108 = vec3<f32>(_e1003[0].z, _e1003[1].z, _e1003[2].z);
                let _e1109 = length(_e1094);
                if (_e1109 > 0f) {
                    phi_5641_ = (_e1094 / vec3(_e1109));
                } else {
                    phi_5641_ = vec3<f32>(0f, 0f, 0f);
                }
                let _e1114 = phi_5641_;
                let _e1115 = dot(_e1101, _e1114);
                let _e1117 = (_e1101 - (_e1114 * _e1115));
                let _e1118 = length(_e1117);
                if (_e1118 > 0f) {
                    phi_5643_ = (_e1117 / vec3(_e1118));
                } else {
                    phi_5643_ = vec3<f32>(0f, 0f, 0f);
                }
                let _e1123 = phi_5643_;
                let _e1124 = dot(_e1108, _e1114);
                let _e1125 = dot(_e1108, _e1123);
                let _e1139 = (1023f / (_e1020 * exp2(((f32(((_e1077 >> bitcast<u32>(16u)) & 255u)) * 0.125f) - 19f))));
                let _e1157 = vec3<u32>(round((clamp(_e954, vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 1023f)));
                let _e1160 = ((vec3<u32>(clamp((round((vec3<f32>(_e1109, _e1118, _e1125) * _e1139)) + vec3<f32>(1023f, 1023f, 1023f)), vec3<f32>(0f, 0f, 0f), vec3<f32>(2046f, 2046f, 2046f))) | (vec3<u32>(clamp((round((vec3<f32>(_e1115, _e1124, length(((_e1108 - (_e1114 * _e1124)) - (_e1123 * _e1125)))) * _e1139)) + vec3<f32>(1023f, 1023f, 1023f)), vec3<f32>(0f, 0f, 0f), vec3<f32>(2046f, 2046f, 2046f))) << bitcast<vec3<u32>>(vec3<u32>(11u, 11u, 11u)))) | (_e1157 << bitcast<vec3<u32>>(vec3<u32>(22u, 22u, 22u))));
                global_4.member[_e1007] = (_e1060.x | (_e1060.y << bitcast<u32>(16u)));
                global_4.member[(_e1007 + 1u)] = _e1077;
                global_4.member[(_e1007 + 2u)] = ((_e1061.x | (_e1061.y << bitcast<u32>(8u))) | (_e1061.z << bitcast<u32>(16u)));
                let _e1171 = (_e1005 + (3u * (_e84 + _e82)));
                global_4.member[_e1171] = _e1160.x;
                global_4.member[(_e1171 + 1u)] = _e1160.y;
                global_4.member[(_e1171 + 2u)] = _e1160.z;
                phi_3184_ = _e591;
                if _e591 {
                    let _e1185 = global.member_29;
                    phi_3184_ = (f32(_e599) <= _e1185);
                }
                let _e1188 = phi_3184_;
                if _e1188 {
                    let _e1190 = global_2.member_9;
                    if (_e1190 != 0u) {
                        let _e1194 = atomicAdd((&global_1.member[2u]), 1u);
                    }
                }
                let _e1195 = !(_e591);
                phi_3198_ = _e1195;
                if !(_e1195) {
                    let _e1199 = global.member_29;
                    phi_3198_ = (f32(_e599) <= _e1199);
                }
                let _e1202 = phi_3198_;
                if _e1202 {
                    phi_5673_ = 4294967295u;
                    break;
                }
                switch bitcast<i32>(0u) {
                    default: {
                        let _e1208 = global.member_2;
                        let _e1210 = global.member_3;
                        let _e1211 = clamp((_e341.xy / vec2(_e340)), _e1208, _e1210);
                        let _e1214 = global.member[0u];
                        let _e1220 = (((_e354 - (_e356 * _e1211.x)) * (_e1214 / _e340)) * _e1001);
                        let _e1223 = global.member[1u];
                        let _e1229 = (((_e355 - (_e356 * _e1211.y)) * (_e1223 / _e340)) * _e1001);
                        let _e1231 = global.member_51;
                        let _e1233 = (dot(_e1220, _e1220) + _e1231);
                        let _e1236 = (dot(_e1229, _e1229) + _e1231);
                        let _e1238 = cross(_e1220, _e1229);
                        let _e1239 = dot(_e1238, _e1238);
                        let _e1243 = (_e1239 + (_e1231 * ((_e1233 + _e1236) - _e1231)));
                        let _e1244 = (_e1243 > 0f);
                        phi_4993_ = _e1244;
                        if _e1244 {
                            phi_4993_ = (_e1233 <= 1000000000000000000f);
                        }
                        let _e1247 = phi_4993_;
                        phi_4999_ = _e1247;
                        if _e1247 {
                            phi_4999_ = (_e1236 <= 1000000000000000000f);
                        }
                        let _e1250 = phi_4999_;
                        if !(_e1250) {
                            let _e1253 = global_2.member_9;
                            if (_e1253 != 0u) {
                                let _e1257 = atomicAdd((&global_1.member[3u]), 1u);
                            }
                            phi_5672_ = 4294967295u;
                            break;
                        }
                        phi_5658_ = (1f - (f32(_e599) * 0.003921569f));
                        phi_5657_ = 0u;
                        loop {
                            let _e1262 = phi_5658_;
                            let _e1264 = phi_5657_;
                            local_4 = _e1262;
                            if (_e1264 < _e90) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                phi_5658_ = (_e1262 * _e1262);
                                phi_5657_ = (_e1264 + bitcast<u32>(1i));
                            }
                        }
                        let _e1270 = local_4;
                        let _e1274 = u32(round((255f * (1f - _e1270))));
                        let _e1276 = global.member_52;
                        phi_5666_ = _e1274;
                        if (_e1276 > 0f) {
                            let _e1286 = u32(round((f32(_e1274) * ((1f - _e1276) + (_e1276 * sqrt((_e1239 / _e1243)))))));
                            let _e1289 = global.member_29;
                            if (f32(_e1286) <= _e1289) {
                                let _e1292 = global_2.member_9;
                                if (_e1292 != 0u) {
                                    let _e1296 = atomicAdd((&global_1.member[2u]), 1u);
                                }
                                phi_5672_ = 4294967295u;
                                break;
                            }
                            phi_5666_ = _e1286;
                        }
                        let _e1298 = phi_5666_;
                        let _e1300 = global.member_49;
                        let _e1301 = (vec3<f32>(_e1233, dot(_e1220, _e1229), _e1236) * _e1300);
                        let _e1306 = global.member_29;
                        let _e1316 = global.member_53;
                        let _e1317 = ((sqrt(_e1301.xz) * sqrt((2f * log(max((f32(_e1298) / _e1306), 1f))))) * _e1316);
                        let _e1320 = global.member_54;
                        let _e1323 = all(((_e589 + _e1317) > _e1320.xy));
                        phi_5077_ = _e1323;
                        if _e1323 {
                            phi_5077_ = all(((_e589 - _e1317) < _e1320.zw));
                        }
                        let _e1329 = phi_5077_;
                        if !(_e1329) {
                            let _e1332 = global_2.member_9;
                            if (_e1332 != 0u) {
                                let _e1336 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_5672_ = 4294967295u;
                            break;
                        }
                        let _e1340 = (0.5f * (_e1301.x - _e1301.z));
                        let _e1345 = sqrt(((_e1340 * _e1340) + (_e1301.y * _e1301.y)));
                        let _e1348 = ((0.5f * (_e1301.x + _e1301.z)) + _e1345);
                        if (_e1340 >= 0f) {
                            phi_5670_ = vec2<f32>((_e1340 + _e1345), _e1301.y);
                        } else {
                            phi_5670_ = vec2<f32>(_e1301.y, (_e1345 - _e1340));
                        }
                        let _e1355 = phi_5670_;
                        let _e1356 = length(_e1355);
                        if (_e1356 > 0f) {
                            phi_5671_ = (_e1355 / vec2(_e1356));
                        } else {
                            phi_5671_ = vec2<f32>(1f, 0f);
                        }
                        let _e1361 = phi_5671_;
                        let _e1368 = global.member_5;
                        let _e1372 = global.member_10;
                        let _e1376 = vec2<u32>(clamp(round(((_e589 + vec2(_e1368)) * _e1372)), vec2<f32>(0f, 0f), vec2<f32>(1048575f, 1048575f)));
                        let _e1404 = global.member_45;
                        let _e1406 = (4u * (_e1404 + _e82));
                        global_4.member[_e1406] = ((_e1376.x | (_e1157.x << bitcast<u32>(20u))) | (_e1157.z << bitcast<u32>(30u)));
                        global_4.member[(_e1406 + 1u)] = (_e1376.y | (_e1157.y << bitcast<u32>(20u)));
                        global_4.member[(_e1406 + 2u)] = pack2x16float((_e1361 * min(sqrt(_e1348), 65504f)));
                        global_4.member[(_e1406 + 3u)] = ((pack2x16float(vec2<f32>(min(sqrt(((_e1243 * (_e1300 * _e1300)) / _e1348)), 65504f), 0f)) | (_e1298 << bitcast<u32>(16u))) | ((_e1157.z >> bitcast<u32>(2u)) << bitcast<u32>(24u)));
                        let _e1419 = global.member_9;
                        phi_5672_ = min(u32((_e587 * f32(_e1419))), _e1419);
                        break;
                    }
                }
                let _e1425 = phi_5672_;
                phi_5673_ = _e1425;
                break;
            }
        }
        let _e1427 = phi_5673_;
        phi_5674_ = _e1427;
    } else {
        phi_5674_ = 4294967295u;
    }
    let _e1429 = phi_5674_;
    switch bitcast<i32>(0u) {
        default: {
            let _e1432 = bitcast<u32>(param[0u]);
            let _e1434 = global.member_45;
            let _e1435 = (_e1434 + _e82);
            if (_e1429 != 4294967295u) {
                let _e1438 = global.member_41;
                let _e1442 = global.member_40;
                let _e1448 = atomicAdd((&global_1.member[((_e1442 + ((_e1435 / _e1438) * 256u)) + (_e1429 & 255u))]), 1u);
            }
            let _e1450 = global.member_39;
            if (_e1450 == 0u) {
                if (_e82 < (_e84 + (_e84 & 1u))) {
                    let _e1456 = global.member_28;
                    global_4.member[(_e1456 + _e1435)] = _e1429;
                }
                break;
            }
            global_5[_e1432] = _e1429;
            workgroupBarrier();
            let _e1462 = ((_e1432 & 1u) == 0u);
            if select(_e1462, _e85, _e1462) {
                let _e1465 = global.member_28;
                let _e1472 = global_5[(_e1432 + 1u)];
                global_4.member[(_e1465 + (_e1435 >> bitcast<u32>(1u)))] = ((_e1429 & 65535u) | (_e1472 << bitcast<u32>(16u)));
            }
            break;
        }
    }
    return;
}
