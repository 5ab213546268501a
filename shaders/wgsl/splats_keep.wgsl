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
    var phi_3385_: bool;
    var phi_5198_: f32;
    var phi_5199_: f32;
    var phi_5203_: u32;
    var phi_5210_: f32;
    var phi_5209_: u32;
    var phi_5206_: u32;
    var local: f32;
    var phi_5215_: bool;
    var phi_3427_: bool;
    var phi_5226_: f32;
    var phi_5217_: vec2<f32>;
    var phi_5216_: bool;
    var phi_5236_: vec4<f32>;
    var phi_5237_: vec4<f32>;
    var phi_5238_: vec4<f32>;
    var phi_5256_: vec3<f32>;
    var phi_5258_: vec4<f32>;
    var phi_5257_: u32;
    var local_1: vec4<f32>;
    var phi_5273_: vec4<f32>;
    var phi_5261_: vec3<f32>;
    var phi_5260_: u32;
    var local_2: vec3<f32>;
    var phi_5277_: vec3<f32>;
    var phi_5270_: vec3<f32>;
    var phi_5269_: u32;
    var local_3: vec3<f32>;
    var phi_5279_: vec3<f32>;
    var phi_5280_: vec3<f32>;
    var phi_5282_: vec3<f32>;
    var phi_5284_: vec3<f32>;
    var phi_3079_: bool;
    var phi_3093_: bool;
    var phi_4716_: bool;
    var phi_4722_: bool;
    var phi_4747_: bool;
    var phi_5295_: vec2<f32>;
    var phi_5296_: vec2<f32>;
    var phi_5297_: u32;
    var phi_5298_: u32;
    var phi_5299_: u32;

    let _e82 = bitcast<u32>(param_1[0u]);
    let _e84 = global.member_14;
    let _e85 = (_e82 < _e84);
    if _e85 {
        switch bitcast<i32>(0u) {
            default: {
                let _e90 = (4u * (_e84 + (_e82 >> bitcast<u32>(5u))));
                let _e91 = (2u * _e82);
                let _e94 = global_7.member[_e91];
                let _e98 = global_7.member[(_e91 + 1u)];
                let _e99 = (2u * _e84);
                let _e103 = global_7.member[(_e99 + _e82)];
                let _e114 = (vec2<f32>(f32(((_e103.y >> bitcast<u32>(16u)) & 31u)), f32(((_e103.y >> bitcast<u32>(21u)) & 31u))) * vec2<f32>(0.032258064f, 0.032258064f));
                let _e118 = ((1f + (2f * _e114.x)) * 0.33333334f);
                let _e119 = (1f - _e118);
                let _e123 = (_e119 * (0.5f + (0.5f * _e114.y)));
                let _e131 = global.member_11;
                let _e134 = global.member_12;
                let _e149 = global.member_21;
                let _e150 = (2u * _e149);
                let _e154 = global_3.member[(_e150 + (_e103.x & 65535u))];
                let _e156 = unpack2x16float(_e154.x);
                let _e168 = global_3.member[(_e150 + (_e103.x >> bitcast<u32>(16u)))];
                let _e170 = unpack2x16float(_e168.x);
                let _e182 = global_3.member[(_e150 + (_e103.y & 65535u))];
                let _e184 = unpack2x16float(_e182.x);
                let _e192 = ((((_e131.xyz + (_e134.xyz * vec3<f32>(f32((_e94.x & 65535u)), f32((_e94.x >> bitcast<u32>(16u))), f32((_e94.y & 65535u))))) + (vec3<f32>(_e156.x, _e156.y, unpack2x16float(_e154.y).x) * _e118)) + (vec3<f32>(_e170.x, _e170.y, unpack2x16float(_e168.y).x) * _e123)) + (vec3<f32>(_e184.x, _e184.y, unpack2x16float(_e182.y).x) * (_e119 - _e123)));
                let _e196 = vec4<f32>(_e192.x, _e192.y, _e192.z, 1f);
                let _e209 = (((_e94.y >> bitcast<u32>(16u)) | ((_e98.y >> bitcast<u32>(24u)) << bitcast<u32>(16u))) | ((_e103.y >> bitcast<u32>(26u)) << bitcast<u32>(24u)));
                let _e211 = global.member_36;
                let _e213 = global.member_37;
                let _e226 = (vec3(_e211) + (vec3<f32>(f32((_e209 & 1023u)), f32(((_e209 >> bitcast<u32>(10u)) & 1023u)), f32((_e209 >> bitcast<u32>(20u)))) * _e213));
                let _e235 = (vec4<u32>(_e98.x, (_e98.x >> bitcast<u32>(8u)), (_e98.x >> bitcast<u32>(16u)), (_e98.x >> bitcast<u32>(24u))) & vec4<u32>(255u, 255u, 255u, 255u));
                let _e241 = (vec3<u32>(_e98.y, (_e98.y >> bitcast<u32>(8u)), (_e98.y >> bitcast<u32>(16u))) & vec3<u32>(255u, 255u, 255u));
                let _e242 = vec3<f32>(_e241);
                let _e254 = (vec4<f32>(_e242.x, _e242.y, _e242.z, f32((((255u - _e241.x) - _e241.y) - _e241.z))) * vec4<f32>(0.003921569f, 0.003921569f, 0.003921569f, 0.003921569f));
                let _e256 = (3u * _e235.x);
                let _e260 = global.member_54[_e256];
                let _e265 = global.member_54[(_e256 + 1u)];
                let _e270 = global.member_54[(_e256 + 2u)];
                let _e273 = (3u * _e235.y);
                let _e277 = global.member_54[_e273];
                let _e283 = global.member_54[(_e273 + 1u)];
                let _e289 = global.member_54[(_e273 + 2u)];
                let _e293 = (3u * _e235.z);
                let _e297 = global.member_54[_e293];
                let _e303 = global.member_54[(_e293 + 1u)];
                let _e309 = global.member_54[(_e293 + 2u)];
                let _e313 = (3u * _e235.w);
                let _e317 = global.member_54[_e313];
                let _e319 = ((((_e260 * _e254.x) + (_e277 * _e254.y)) + (_e297 * _e254.z)) + (_e317 * _e254.w));
                let _e323 = global.member_54[(_e313 + 1u)];
                let _e325 = ((((_e265 * _e254.x) + (_e283 * _e254.y)) + (_e303 * _e254.z)) + (_e323 * _e254.w));
                let _e329 = global.member_54[(_e313 + 2u)];
                let _e331 = ((((_e270 * _e254.x) + (_e289 * _e254.y)) + (_e309 * _e254.z)) + (_e329 * _e254.w));
                let _e334 = dot(_e331, _e196);
                let _e335 = vec3<f32>(dot(_e319, _e196), dot(_e325, _e196), _e334);
                let _e336 = _e319.xyz;
                let _e337 = _e325.xyz;
                let _e338 = _e331.xyz;
                let _e348 = vec3<f32>(_e319.x, _e319.y, _e319.z);
                let _e349 = vec3<f32>(_e325.x, _e325.y, _e325.z);
                let _e350 = vec3<f32>(_e331.x, _e331.y, _e331.z);
                let _e366 = ((1.2f * exp(min(max(max(_e226.x, _e226.y), _e226.z), 9f))) * sqrt(max(max(dot(_e336, _e336), dot(_e337, _e337)), dot(_e338, _e338))));
                switch bitcast<i32>(0u) {
                    default: {
                        let _e369 = global.member_6;
                        if !((_e334 >= _e369)) {
                            let _e373 = global_2.member_9;
                            if (_e373 != 0u) {
                                let _e377 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_5226_ = 0f;
                            phi_5217_ = vec2<f32>(0f, 0f);
                            phi_5216_ = false;
                            break;
                        }
                        let _e379 = global.member;
                        let _e380 = _e335.xy;
                        let _e382 = vec2(_e334);
                        let _e385 = global.member_1;
                        let _e386 = (((_e379 * _e380) / _e382) + _e385);
                        let _e388 = global.member_5;
                        let _e392 = all((_e386 >= vec2(-(_e388))));
                        phi_3385_ = _e392;
                        if _e392 {
                            let _e394 = global.member_4;
                            phi_3385_ = all((_e386 <= (_e394 + vec2(_e388))));
                        }
                        let _e400 = phi_3385_;
                        if !(_e400) {
                            let _e403 = global_2.member_9;
                            if (_e403 != 0u) {
                                let _e407 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_5226_ = 0f;
                            phi_5217_ = _e386;
                            phi_5216_ = false;
                            break;
                        }
                        let _e409 = global.member_7;
                        let _e412 = global.member_8;
                        let _e413 = ((_e409 - _e334) * _e412);
                        if (_e413 < 0f) {
                            phi_5199_ = (0.015625f / (1f - _e413));
                        } else {
                            if (_e413 > 1f) {
                                phi_5198_ = (1f - (0.015625f / _e413));
                            } else {
                                phi_5198_ = (0.015625f + (0.96875f * clamp(_e413, 0f, 1f)));
                            }
                            let _e422 = phi_5198_;
                            phi_5199_ = _e422;
                        }
                        let _e426 = phi_5199_;
                        let _e427 = (_e380 / _e382);
                        let _e435 = global.member[0u];
                        let _e438 = global.member[1u];
                        let _e443 = global.member_31;
                        let _e444 = (_e443 > 0u);
                        phi_3427_ = _e444;
                        if _e444 {
                            let _e446 = global.member_34;
                            let _e449 = global.member_29;
                            switch bitcast<i32>(0u) {
                                default: {
                                    let _e459 = vec2((sqrt((2f * log(max((max(255f, _e446) / _e449), 1f)))) * ((((_e366 * length(vec3<f32>(_e427.x, _e427.y, 1f))) * max(_e435, _e438)) / _e334) + 0.5477226f)));
                                    let _e462 = global.member_32;
                                    let _e465 = global.member_33;
                                    let _e469 = vec2<u32>(clamp(((((_e386 - _e459) - _e462) * _e465) - vec2<f32>(0.5f, 0.5f)), vec2<f32>(0f, 0f), vec2<f32>(191f, 191f)));
                                    let _e475 = vec2<u32>(clamp(((((_e386 + _e459) - _e462) * _e465) + vec2<f32>(0.5f, 0.5f)), vec2<f32>(0f, 0f), vec2<f32>(191f, 191f)));
                                    let _e482 = max((_e475.x - _e469.x), (_e475.y - _e469.y));
                                    if (_e482 <= 3u) {
                                        phi_5203_ = 0u;
                                    } else {
                                        phi_5203_ = (bitcast<u32>(firstLeadingBit((_e482 - 1u))) - 1u);
                                    }
                                    let _e489 = phi_5203_;
                                    if !((_e489 < 4u)) {
                                        phi_5215_ = false;
                                        break;
                                    }
                                    let _e499 = vec2(_e489);
                                    let _e501 = (_e469 >> bitcast<vec2<u32>>(_e499));
                                    let _e503 = (_e475 >> bitcast<vec2<u32>>(_e499));
                                    let _e505 = (_e501.x & 4294967292u);
                                    phi_5210_ = 0f;
                                    phi_5209_ = _e501.y;
                                    phi_5206_ = _e505;
                                    loop {
                                        let _e508 = phi_5210_;
                                        let _e510 = phi_5209_;
                                        let _e512 = phi_5206_;
                                        let _e515 = (vec4(f32(_e512)) + vec4<f32>(0f, 1f, 2f, 3f));
                                        let _e533 = global_3.member[((_e443 >> bitcast<u32>(1u)) + ((((4u * (12288u - (12288u >> bitcast<u32>((2u * _e489))))) + (_e510 * (192u >> bitcast<u32>(_e489)))) + _e512) >> bitcast<u32>(2u)))];
                                        let _e535 = unpack2x16unorm(_e533.x);
                                        let _e537 = unpack2x16unorm(_e533.y);
                                        let _e544 = select(select(vec4<f32>(_e535.x, _e535.y, _e537.x, _e537.y), vec4<f32>(0f, 0f, 0f, 0f), (_e515 < vec4(f32(_e501.x)))), vec4<f32>(0f, 0f, 0f, 0f), (_e515 > vec4(f32(_e503.x))));
                                        let _e552 = max(_e508, max(max(_e544.x, _e544.y), max(_e544.z, _e544.w)));
                                        let _e553 = (_e512 + 4u);
                                        let _e554 = (_e553 > _e503.x);
                                        let _e557 = (_e510 + select(0u, 1u, _e554));
                                        phi_5210_ = _e552;
                                        phi_5209_ = _e557;
                                        phi_5206_ = select(_e553, _e505, _e554);
                                        local = _e552;
                                        if (_e557 <= _e503.y) {
                                            continue;
                                        } else {
                                            break;
                                        }
                                    }
                                    let _e561 = local;
                                    phi_5215_ = ((1f - _e426) > _e561);
                                    break;
                                }
                            }
                            let _e564 = phi_5215_;
                            phi_3427_ = _e564;
                        }
                        let _e566 = phi_3427_;
                        if _e566 {
                            let _e568 = global_2.member_9;
                            if (_e568 != 0u) {
                                let _e572 = atomicAdd((&global_1.member[1u]), 1u);
                            }
                            phi_5226_ = _e426;
                            phi_5217_ = _e386;
                            phi_5216_ = false;
                            break;
                        }
                        phi_5226_ = _e426;
                        phi_5217_ = _e386;
                        phi_5216_ = true;
                        break;
                    }
                }
                let _e574 = phi_5226_;
                let _e576 = phi_5217_;
                let _e578 = phi_5216_;
                let _e583 = global_7.member[((3u * _e84) + _e82)];
                let _e586 = (_e583.y >> bitcast<u32>(24u));
                let _e600 = ((vec3<f32>(f32((_e583.x & 1023u)), f32(((_e583.x >> bitcast<u32>(10u)) & 1023u)), f32(((_e583.x >> bitcast<u32>(20u)) & 1023u))) - vec3<f32>(512f, 512f, 512f)) * vec3<f32>(0.0013888889f, 0.0013888889f, 0.0013888889f));
                let _e604 = sqrt(max((1f - dot(_e600, _e600)), 0f));
                let _e606 = (_e583.x >> bitcast<u32>(30u));
                if (_e606 == 0u) {
                    phi_5238_ = vec4<f32>(_e604, _e600.x, _e600.y, _e600.z);
                } else {
                    if (_e606 == 1u) {
                        phi_5237_ = vec4<f32>(_e600.x, _e604, _e600.y, _e600.z);
                    } else {
                        if (_e606 == 2u) {
                            phi_5236_ = vec4<f32>(_e600.x, _e600.y, _e604, _e600.z);
                        } else {
                            phi_5236_ = vec4<f32>(_e600.x, _e600.y, _e600.z, _e604);
                        }
                        let _e619 = phi_5236_;
                        phi_5237_ = _e619;
                    }
                    let _e625 = phi_5237_;
                    phi_5238_ = _e625;
                }
                let _e631 = phi_5238_;
                let _e635 = global.member_38;
                let _e636 = (_e635 > 0u);
                phi_5256_ = unpack4x8unorm(_e583.y).xyz;
                if _e636 {
                    let _e640 = global_7.member[(_e635 + _e82)];
                    let _e642 = unpack2x16float(_e640.x);
                    phi_5256_ = vec3<f32>(_e642.x, _e642.y, unpack2x16float(_e640.y).x);
                }
                let _e650 = phi_5256_;
                let _e653 = (1u << bitcast<u32>((_e82 & 31u)));
                let _e656 = global_7.member[_e90];
                let _e660 = global_7.member[(_e90 + 1u)];
                let _e664 = global_7.member[(_e90 + 2u)];
                phi_5273_ = _e631;
                if ((_e656.x & _e653) != 0u) {
                    let _e669 = global.member_22;
                    let _e677 = global.member_18;
                    let _e681 = (_e669 + ((_e660.y + bitcast<u32>(countOneBits((_e656.x & (_e653 - 1u))))) * (1u + (4u * _e677))));
                    let _e682 = (_e681 + 1u);
                    let _e685 = global_6.member[_e681];
                    let _e687 = global.member_44;
                    let _e691 = global.member_19;
                    phi_5258_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_5257_ = 0u;
                    loop {
                        let _e695 = phi_5258_;
                        let _e697 = phi_5257_;
                        let _e699 = (2u * ((_e687 + ((_e685 >> bitcast<u32>(16u)) * _e691)) + _e697));
                        let _e702 = global_3.member[_e699];
                        let _e706 = global_3.member[(_e699 + 1u)];
                        let _e712 = bitcast<vec4<f32>>(vec4<u32>(_e702.x, _e702.y, _e706.x, _e706.y));
                        let _e716 = global_6.member[(_e682 + _e697)];
                        let _e723 = global_6.member[((_e682 + _e677) + _e697)];
                        let _e731 = global_6.member[((_e682 + (2u * _e677)) + _e697)];
                        let _e739 = global_6.member[((_e682 + (3u * _e677)) + _e697)];
                        let _e743 = (_e695 + vec4<f32>(dot(unpack4x8snorm(_e716), _e712), dot(unpack4x8snorm(_e723), _e712), dot(unpack4x8snorm(_e731), _e712), dot(unpack4x8snorm(_e739), _e712)));
                        let _e745 = (_e697 + bitcast<u32>(1i));
                        phi_5258_ = _e743;
                        phi_5257_ = _e745;
                        local_1 = _e743;
                        if (_e745 < _e677) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e751 = local_1;
                    let _e753 = (_e631 + (_e751 * (127f * unpack2x16float(_e685).x)));
                    phi_5273_ = select(_e631, _e753, vec4((length(_e753) >= 0.001f)));
                }
                let _e759 = phi_5273_;
                phi_5277_ = _e226;
                if ((_e656.y & _e653) != 0u) {
                    let _e764 = global.member_23;
                    let _e772 = global.member_18;
                    let _e776 = (_e764 + ((_e664.x + bitcast<u32>(countOneBits((_e656.y & (_e653 - 1u))))) * (1u + (3u * _e772))));
                    let _e777 = (_e776 + 1u);
                    let _e780 = global_6.member[_e776];
                    let _e782 = global.member_44;
                    let _e786 = global.member_19;
                    phi_5261_ = vec3<f32>(0f, 0f, 0f);
                    phi_5260_ = 0u;
                    loop {
                        let _e790 = phi_5261_;
                        let _e792 = phi_5260_;
                        let _e794 = (2u * ((_e782 + ((_e780 >> bitcast<u32>(16u)) * _e786)) + _e792));
                        let _e797 = global_3.member[_e794];
                        let _e801 = global_3.member[(_e794 + 1u)];
                        let _e807 = bitcast<vec4<f32>>(vec4<u32>(_e797.x, _e797.y, _e801.x, _e801.y));
                        let _e811 = global_6.member[(_e777 + _e792)];
                        let _e818 = global_6.member[((_e777 + _e772) + _e792)];
                        let _e826 = global_6.member[((_e777 + (2u * _e772)) + _e792)];
                        let _e830 = (_e790 + vec3<f32>(dot(unpack4x8snorm(_e811), _e807), dot(unpack4x8snorm(_e818), _e807), dot(unpack4x8snorm(_e826), _e807)));
                        let _e832 = (_e792 + bitcast<u32>(1i));
                        phi_5261_ = _e830;
                        phi_5260_ = _e832;
                        local_2 = _e830;
                        if (_e832 < _e772) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e838 = local_2;
                    phi_5277_ = (_e226 + (_e838 * (127f * unpack2x16float(_e780).x)));
                }
                let _e842 = phi_5277_;
                phi_5279_ = _e650;
                if ((_e660.x & _e653) != 0u) {
                    let _e847 = global.member_24;
                    let _e855 = global.member_18;
                    let _e859 = (_e847 + ((_e664.y + bitcast<u32>(countOneBits((_e660.x & (_e653 - 1u))))) * (3u + (3u * _e855))));
                    let _e863 = global_6.member[(_e859 + 1u)];
                    let _e864 = unpack2x16float(_e863);
                    let _e868 = global_6.member[(_e859 + 2u)];
                    let _e876 = (_e859 + 3u);
                    let _e879 = global_6.member[_e859];
                    let _e881 = global.member_44;
                    let _e885 = global.member_19;
                    phi_5270_ = vec3<f32>(0f, 0f, 0f);
                    phi_5269_ = 0u;
                    loop {
                        let _e889 = phi_5270_;
                        let _e891 = phi_5269_;
                        let _e893 = (2u * ((_e881 + ((_e879 >> bitcast<u32>(16u)) * _e885)) + _e891));
                        let _e896 = global_3.member[_e893];
                        let _e900 = global_3.member[(_e893 + 1u)];
                        let _e906 = bitcast<vec4<f32>>(vec4<u32>(_e896.x, _e896.y, _e900.x, _e900.y));
                        let _e910 = global_6.member[(_e876 + _e891)];
                        let _e917 = global_6.member[((_e876 + _e855) + _e891)];
                        let _e925 = global_6.member[((_e876 + (2u * _e855)) + _e891)];
                        let _e929 = (_e889 + vec3<f32>(dot(unpack4x8snorm(_e910), _e906), dot(unpack4x8snorm(_e917), _e906), dot(unpack4x8snorm(_e925), _e906)));
                        let _e931 = (_e891 + bitcast<u32>(1i));
                        phi_5270_ = _e929;
                        phi_5269_ = _e931;
                        local_3 = _e929;
                        if (_e931 < _e855) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e937 = local_3;
                    phi_5279_ = (select(vec3<f32>(_e864.x, _e864.y, unpack2x16float(_e868).x), _e650, vec3(_e636)) + (_e937 * (127f * unpack2x16float(_e879).x)));
                }
                let _e941 = phi_5279_;
                let _e942 = normalize(_e759);
                let _e947 = (_e942.z * _e942.z);
                let _e948 = (_e942.w * _e942.w);
                let _e952 = (_e942.y * _e942.z);
                let _e953 = (_e942.x * _e942.w);
                let _e956 = (_e942.y * _e942.w);
                let _e957 = (_e942.x * _e942.z);
                let _e962 = (_e942.y * _e942.y);
                let _e966 = (_e942.z * _e942.w);
                let _e967 = (_e942.x * _e942.y);
                let _e981 = exp(min(_e842, vec3<f32>(9f, 9f, 9f)));
                let _e988 = mat3x3<f32>((vec3<f32>((1f - (2f * (_e947 + _e948))), (2f * (_e952 + _e953)), (2f * (_e956 - _e957))) * _e981.x), (vec3<f32>((2f * (_e952 - _e953)), (1f - (2f * (_e962 + _e948))), (2f * (_e966 + _e967))) * _e981.y), (vec3<f32>((2f * (_e956 + _e957)), (2f * (_e966 - _e967)), (1f - (2f * (_e962 + _e947)))) * _e981.z));
                let _e990 = (transpose(mat3x3<f32>(_e348, _e349, _e350)) * _e988);
                let _e992 = global.member_42;
                let _e993 = (_e992 + _e91);
                let _e994 = transpose(_e990);
                let _e1004 = max(_e366, sqrt(max(max(dot(_e994[0], _e994[0]), dot(_e994[1], _e994[1])), dot(_e994[2], _e994[2]))));
                let _e1006 = global.member_43;
                let _e1017 = (all((abs(_e335) < vec3<f32>(1000000000000000000000000000000f, 1000000000000000000000000000000f, 1000000000000000000000000000000f))) && (_e1004 <= 1000000000000000000f));
                if _e1017 {
                    let _e1019 = global.member_47;
                    let _e1023 = global.member_48;
                    phi_5280_ = ((_e335 - _e1019.xyz) / _e1023.xyz);
                } else {
                    phi_5280_ = vec3<f32>(0f, 0f, 0f);
                }
                let _e1027 = phi_5280_;
                let _e1044 = vec3<u32>(round((clamp(select(select((vec3<f32>(0.015625f, 0.015625f, 0.015625f) + (clamp(_e1027, vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 0.96875f)), (vec3<f32>(0.015625f, 0.015625f, 0.015625f) / (vec3<f32>(1f, 1f, 1f) - min(_e1027, vec3<f32>(0f, 0f, 0f)))), (_e1027 < vec3<f32>(0f, 0f, 0f))), (vec3<f32>(1f, 1f, 1f) - (vec3<f32>(0.015625f, 0.015625f, 0.015625f) / max(_e1027, vec3<f32>(1f, 1f, 1f)))), (_e1027 > vec3<f32>(1f, 1f, 1f))), vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 65535f)));
                let _e1060 = ((_e1044.z | (u32(clamp(select(0f, ceil(((8f * log2(max((_e1004 / _e1006), 0.000000000000000000000000000001f))) + 152f)), _e1017), 0f, 255f)) << bitcast<u32>(16u))) | (select(0u, _e586, _e1017) << bitcast<u32>(24u)));
                let _e1068 = vec3<f32>(_e990[0].x, _e990[1].x, _e990[2].x);
                let _e1075 = vec3<f32>(_e990[0].y, _e990[1].y, _e990[2].y);
                let _e1082 = vec3<f32>(_e990[0].z, _e990[1].z, _e990[2].z);
                let _e1083 = length(_e1068);
                if (_e1083 > 0f) {
                    phi_5282_ = (_e1068 / vec3(_e1083));
                } else {
                    phi_5282_ = vec3<f32>(0f, 0f, 0f);
                }
                let _e1088 = phi_5282_;
                let _e1089 = dot(_e1075, _e1088);
                let _e1091 = (_e1075 - (_e1088 * _e1089));
                let _e1092 = length(_e1091);
                if (_e1092 > 0f) {
                    phi_5284_ = (_e1091 / vec3(_e1092));
                } else {
                    phi_5284_ = vec3<f32>(0f, 0f, 0f);
                }
                let _e1097 = phi_5284_;
                let _e1098 = dot(_e1082, _e1088);
                let _e1099 = dot(_e1082, _e1097);
                let _e1113 = (1023f / (_e1006 * exp2(((f32(((_e1060 >> bitcast<u32>(16u)) & 255u)) * 0.125f) - 19f))));
                let _e1131 = vec3<u32>(round((clamp(_e941, vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 1023f)));
                let _e1134 = ((vec3<u32>(clamp((round((vec3<f32>(_e1083, _e1092, _e1099) * _e1113)) + vec3<f32>(1023f, 1023f, 1023f)), vec3<f32>(0f, 0f, 0f), vec3<f32>(2046f, 2046f, 2046f))) | (vec3<u32>(clamp((round((vec3<f32>(_e1089, _e1098, length(((_e1082 - (_e1088 * _e1098)) - (_e1097 * _e1099)))) * _e1113)) + vec3<f32>(1023f, 1023f, 1023f)), vec3<f32>(0f, 0f, 0f), vec3<f32>(2046f, 2046f, 2046f))) << bitcast<vec3<u32>>(vec3<u32>(11u, 11u, 11u)))) | (_e1131 << bitcast<vec3<u32>>(vec3<u32>(22u, 22u, 22u))));
                global_4.member[_e993] = (_e1044.x | (_e1044.y << bitcast<u32>(16u)));
                global_4.member[(_e993 + 1u)] = _e1060;
                let _e1142 = ((_e992 + _e99) + (3u * _e82));
                global_4.member[_e1142] = _e1134.x;
                global_4.member[(_e1142 + 1u)] = _e1134.y;
                global_4.member[(_e1142 + 2u)] = _e1134.z;
                phi_3079_ = _e578;
                if _e578 {
                    let _e1156 = global.member_29;
                    phi_3079_ = (f32(_e586) <= _e1156);
                }
                let _e1159 = phi_3079_;
                if _e1159 {
                    let _e1161 = global_2.member_9;
                    if (_e1161 != 0u) {
                        let _e1165 = atomicAdd((&global_1.member[2u]), 1u);
                    }
                }
                let _e1166 = !(_e578);
                phi_3093_ = _e1166;
                if !(_e1166) {
                    let _e1170 = global.member_29;
                    phi_3093_ = (f32(_e586) <= _e1170);
                }
                let _e1173 = phi_3093_;
                if _e1173 {
                    phi_5298_ = 4294967295u;
                    break;
                }
                switch bitcast<i32>(0u) {
                    default: {
                        let _e1179 = global.member_2;
                        let _e1181 = global.member_3;
                        let _e1182 = clamp((_e335.xy / vec2(_e334)), _e1179, _e1181);
                        let _e1185 = global.member[0u];
                        let _e1191 = (((_e348 - (_e350 * _e1182.x)) * (_e1185 / _e334)) * _e988);
                        let _e1194 = global.member[1u];
                        let _e1200 = (((_e349 - (_e350 * _e1182.y)) * (_e1194 / _e334)) * _e988);
                        let _e1202 = (dot(_e1191, _e1191) + 0.3f);
                        let _e1203 = dot(_e1191, _e1200);
                        let _e1205 = (dot(_e1200, _e1200) + 0.3f);
                        let _e1207 = cross(_e1191, _e1200);
                        let _e1209 = (_e1202 + _e1205);
                        let _e1212 = (dot(_e1207, _e1207) + (0.3f * (_e1209 - 0.3f)));
                        let _e1213 = (_e1212 > 0f);
                        phi_4716_ = _e1213;
                        if _e1213 {
                            phi_4716_ = (_e1202 <= 1000000000000000000f);
                        }
                        let _e1216 = phi_4716_;
                        phi_4722_ = _e1216;
                        if _e1216 {
                            phi_4722_ = (_e1205 <= 1000000000000000000f);
                        }
                        let _e1219 = phi_4722_;
                        if !(_e1219) {
                            let _e1222 = global_2.member_9;
                            if (_e1222 != 0u) {
                                let _e1226 = atomicAdd((&global_1.member[3u]), 1u);
                            }
                            phi_5297_ = 4294967295u;
                            break;
                        }
                        let _e1229 = global.member_34;
                        let _e1232 = global.member_29;
                        let _e1240 = (sqrt(vec3<f32>(_e1202, _e1203, _e1205).xz) * sqrt((2f * log(max((max(f32(_e586), _e1229) / _e1232), 1f)))));
                        let _e1243 = all(((_e576 + _e1240) > vec2<f32>(0f, 0f)));
                        phi_4747_ = _e1243;
                        if _e1243 {
                            let _e1246 = global.member_4;
                            phi_4747_ = all(((_e576 - _e1240) < _e1246));
                        }
                        let _e1250 = phi_4747_;
                        if !(_e1250) {
                            let _e1253 = global_2.member_9;
                            if (_e1253 != 0u) {
                                let _e1257 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_5297_ = 4294967295u;
                            break;
                        }
                        let _e1259 = (0.5f * (_e1202 - _e1205));
                        let _e1263 = sqrt(((_e1259 * _e1259) + (_e1203 * _e1203)));
                        let _e1265 = ((0.5f * _e1209) + _e1263);
                        if (_e1259 >= 0f) {
                            phi_5295_ = vec2<f32>((_e1259 + _e1263), _e1203);
                        } else {
                            phi_5295_ = vec2<f32>(_e1203, (_e1263 - _e1259));
                        }
                        let _e1272 = phi_5295_;
                        let _e1273 = length(_e1272);
                        if (_e1273 > 0f) {
                            phi_5296_ = (_e1272 / vec2(_e1273));
                        } else {
                            phi_5296_ = vec2<f32>(1f, 0f);
                        }
                        let _e1278 = phi_5296_;
                        let _e1285 = global.member_5;
                        let _e1289 = global.member_10;
                        let _e1293 = vec2<u32>(clamp(round(((_e576 + vec2(_e1285)) * _e1289)), vec2<f32>(0f, 0f), vec2<f32>(1048575f, 1048575f)));
                        let _e1321 = global.member_45;
                        let _e1323 = (4u * (_e1321 + _e82));
                        global_4.member[_e1323] = ((_e1293.x | (_e1131.x << bitcast<u32>(20u))) | (_e1131.z << bitcast<u32>(30u)));
                        global_4.member[(_e1323 + 1u)] = (_e1293.y | (_e1131.y << bitcast<u32>(20u)));
                        global_4.member[(_e1323 + 2u)] = pack2x16float((_e1278 * min(sqrt(_e1265), 65504f)));
                        global_4.member[(_e1323 + 3u)] = ((pack2x16float(vec2<f32>(min(sqrt((_e1212 / _e1265)), 65504f), 0f)) | (_e586 << bitcast<u32>(16u))) | ((_e1131.z >> bitcast<u32>(2u)) << bitcast<u32>(24u)));
                        let _e1336 = global.member_9;
                        phi_5297_ = min(u32((_e574 * f32(_e1336))), _e1336);
                        break;
                    }
                }
                let _e1342 = phi_5297_;
                phi_5298_ = _e1342;
                break;
            }
        }
        let _e1344 = phi_5298_;
        phi_5299_ = _e1344;
    } else {
        phi_5299_ = 4294967295u;
    }
    let _e1346 = phi_5299_;
    switch bitcast<i32>(0u) {
        default: {
            let _e1349 = bitcast<u32>(param[0u]);
            let _e1351 = global.member_45;
            let _e1352 = (_e1351 + _e82);
            if (_e1346 != 4294967295u) {
                let _e1355 = global.member_40;
                let _e1357 = global.member_41;
                let _e1365 = atomicAdd((&global_1.member[((_e1355 + ((_e1352 / _e1357) * 256u)) + (_e1346 & 255u))]), 1u);
            }
            let _e1367 = global.member_39;
            if (_e1367 == 0u) {
                if (_e82 < (_e84 + (_e84 & 1u))) {
                    let _e1373 = global.member_28;
                    global_4.member[(_e1373 + _e1352)] = _e1346;
                }
                break;
            }
            global_5[_e1349] = _e1346;
            workgroupBarrier();
            let _e1379 = ((_e1349 & 1u) == 0u);
            if select(_e1379, _e85, _e1379) {
                let _e1382 = global.member_28;
                let _e1389 = global_5[(_e1349 + 1u)];
                global_4.member[(_e1382 + (_e1352 >> bitcast<u32>(1u)))] = ((_e1346 & 65535u) | (_e1389 << bitcast<u32>(16u)));
            }
            break;
        }
    }
    return;
}
