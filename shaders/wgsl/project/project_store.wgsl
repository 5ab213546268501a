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
    var phi_3600_: bool;
    var phi_5554_: f32;
    var phi_5555_: f32;
    var phi_5559_: u32;
    var phi_5565_: u32;
    var phi_5564_: f32;
    var phi_5562_: u32;
    var local: f32;
    var phi_5569_: bool;
    var phi_3649_: bool;
    var phi_5580_: f32;
    var phi_5571_: vec2<f32>;
    var phi_5570_: bool;
    var phi_5590_: vec4<f32>;
    var phi_5591_: vec4<f32>;
    var phi_5592_: vec4<f32>;
    var phi_5610_: vec3<f32>;
    var phi_5612_: vec4<f32>;
    var phi_5611_: u32;
    var local_1: vec4<f32>;
    var phi_5627_: vec4<f32>;
    var phi_5615_: vec3<f32>;
    var phi_5614_: u32;
    var local_2: vec3<f32>;
    var phi_5631_: vec3<f32>;
    var phi_5624_: vec3<f32>;
    var phi_5623_: u32;
    var local_3: vec3<f32>;
    var phi_5633_: vec3<f32>;
    var phi_5634_: vec3<f32>;
    var phi_5636_: vec3<f32>;
    var phi_5638_: vec3<f32>;
    var phi_3182_: bool;
    var phi_3196_: bool;
    var phi_4991_: bool;
    var phi_4997_: bool;
    var phi_5653_: f32;
    var phi_5652_: u32;
    var local_4: f32;
    var phi_5661_: u32;
    var phi_5075_: bool;
    var phi_5665_: vec2<f32>;
    var phi_5666_: vec2<f32>;
    var phi_5667_: u32;
    var phi_5668_: u32;
    var phi_5669_: u32;

    let _e83 = bitcast<u32>(param_1[0u]);
    let _e85 = global.member_48;
    let _e86 = (_e83 < _e85);
    if _e86 {
        switch bitcast<i32>(0u) {
            default: {
                let _e89 = global.member_14;
                let _e91 = global.member_47;
                let _e93 = (_e83 << bitcast<u32>(_e91));
                let _e97 = (4u * (_e89 + (_e93 >> bitcast<u32>(5u))));
                let _e98 = (2u * _e93);
                let _e101 = global_7.member[_e98];
                let _e105 = global_7.member[(_e98 + 1u)];
                let _e110 = global_7.member[((2u * _e89) + _e93)];
                let _e121 = (vec2<f32>(f32(((_e110.y >> bitcast<u32>(16u)) & 31u)), f32(((_e110.y >> bitcast<u32>(21u)) & 31u))) * vec2<f32>(0.032258064f, 0.032258064f));
                let _e125 = ((1f + (2f * _e121.x)) * 0.33333334f);
                let _e126 = (1f - _e125);
                let _e130 = (_e126 * (0.5f + (0.5f * _e121.y)));
                let _e148 = global.member_11;
                let _e151 = global.member_12;
                let _e156 = global.member_21;
                let _e157 = (2u * _e156);
                let _e161 = global_3.member[(_e157 + (_e110.x & 65535u))];
                let _e163 = unpack2x16float(_e161.x);
                let _e175 = global_3.member[(_e157 + (_e110.x >> bitcast<u32>(16u)))];
                let _e177 = unpack2x16float(_e175.x);
                let _e189 = global_3.member[(_e157 + (_e110.y & 65535u))];
                let _e191 = unpack2x16float(_e189.x);
                let _e199 = ((((_e148.xyz + (_e151.xyz * vec3<f32>(f32((_e101.x & 65535u)), f32((_e101.x >> bitcast<u32>(16u))), f32((_e101.y & 65535u))))) + (vec3<f32>(_e163.x, _e163.y, unpack2x16float(_e161.y).x) * _e125)) + (vec3<f32>(_e177.x, _e177.y, unpack2x16float(_e175.y).x) * _e130)) + (vec3<f32>(_e191.x, _e191.y, unpack2x16float(_e189.y).x) * (_e126 - _e130)));
                let _e203 = vec4<f32>(_e199.x, _e199.y, _e199.z, 1f);
                let _e216 = (((_e101.y >> bitcast<u32>(16u)) | ((_e105.y >> bitcast<u32>(24u)) << bitcast<u32>(16u))) | ((_e110.y >> bitcast<u32>(26u)) << bitcast<u32>(24u)));
                let _e228 = global.member_36;
                let _e230 = global.member_37;
                let _e233 = (vec3(_e228) + (vec3<f32>(f32((_e216 & 1023u)), f32(((_e216 >> bitcast<u32>(10u)) & 1023u)), f32((_e216 >> bitcast<u32>(20u)))) * _e230));
                let _e242 = (vec4<u32>(_e105.x, (_e105.x >> bitcast<u32>(8u)), (_e105.x >> bitcast<u32>(16u)), (_e105.x >> bitcast<u32>(24u))) & vec4<u32>(255u, 255u, 255u, 255u));
                let _e248 = (vec3<u32>(_e105.y, (_e105.y >> bitcast<u32>(8u)), (_e105.y >> bitcast<u32>(16u))) & vec3<u32>(255u, 255u, 255u));
                let _e249 = vec3<f32>(_e248);
                let _e261 = (vec4<f32>(_e249.x, _e249.y, _e249.z, f32((((255u - _e248.x) - _e248.y) - _e248.z))) * vec4<f32>(0.003921569f, 0.003921569f, 0.003921569f, 0.003921569f));
                let _e264 = (3u * _e242.x);
                let _e267 = global.member_62[_e264];
                let _e272 = global.member_62[(_e264 + 1u)];
                let _e277 = global.member_62[(_e264 + 2u)];
                let _e281 = (3u * _e242.y);
                let _e284 = global.member_62[_e281];
                let _e290 = global.member_62[(_e281 + 1u)];
                let _e296 = global.member_62[(_e281 + 2u)];
                let _e301 = (3u * _e242.z);
                let _e304 = global.member_62[_e301];
                let _e310 = global.member_62[(_e301 + 1u)];
                let _e316 = global.member_62[(_e301 + 2u)];
                let _e321 = (3u * _e242.w);
                let _e324 = global.member_62[_e321];
                let _e326 = ((((_e267 * _e261.x) + (_e284 * _e261.y)) + (_e304 * _e261.z)) + (_e324 * _e261.w));
                let _e330 = global.member_62[(_e321 + 1u)];
                let _e332 = ((((_e272 * _e261.x) + (_e290 * _e261.y)) + (_e310 * _e261.z)) + (_e330 * _e261.w));
                let _e336 = global.member_62[(_e321 + 2u)];
                let _e338 = ((((_e277 * _e261.x) + (_e296 * _e261.y)) + (_e316 * _e261.z)) + (_e336 * _e261.w));
                let _e341 = dot(_e338, _e203);
                let _e342 = vec3<f32>(dot(_e326, _e203), dot(_e332, _e203), _e341);
                let _e343 = _e326.xyz;
                let _e344 = _e332.xyz;
                let _e345 = _e338.xyz;
                let _e355 = vec3<f32>(_e326.x, _e326.y, _e326.z);
                let _e356 = vec3<f32>(_e332.x, _e332.y, _e332.z);
                let _e357 = vec3<f32>(_e338.x, _e338.y, _e338.z);
                let _e373 = ((1.2f * exp(min(max(max(_e233.x, _e233.y), _e233.z), 9f))) * sqrt(max(max(dot(_e343, _e343), dot(_e344, _e344)), dot(_e345, _e345))));
                switch bitcast<i32>(0u) {
                    default: {
                        let _e376 = global.member_6;
                        if !((_e341 >= _e376)) {
                            let _e380 = global_2.member_9;
                            if (_e380 != 0u) {
                                let _e384 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_5580_ = 0f;
                            phi_5571_ = vec2<f32>(0f, 0f);
                            phi_5570_ = false;
                            break;
                        }
                        let _e386 = global.member;
                        let _e387 = _e342.xy;
                        let _e389 = vec2(_e341);
                        let _e392 = global.member_1;
                        let _e393 = (((_e386 * _e387) / _e389) + _e392);
                        let _e395 = global.member_5;
                        let _e399 = all((_e393 >= vec2(-(_e395))));
                        phi_3600_ = _e399;
                        if _e399 {
                            let _e401 = global.member_4;
                            phi_3600_ = all((_e393 <= (_e401 + vec2(_e395))));
                        }
                        let _e407 = phi_3600_;
                        if !(_e407) {
                            let _e410 = global_2.member_9;
                            if (_e410 != 0u) {
                                let _e414 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_5580_ = 0f;
                            phi_5571_ = _e393;
                            phi_5570_ = false;
                            break;
                        }
                        let _e416 = global.member_7;
                        let _e419 = global.member_8;
                        let _e420 = ((_e416 - _e341) * _e419);
                        if (_e420 < 0f) {
                            phi_5555_ = (0.015625f / (1f - _e420));
                        } else {
                            if (_e420 > 1f) {
                                phi_5554_ = (1f - (0.015625f / _e420));
                            } else {
                                phi_5554_ = (0.015625f + (0.96875f * clamp(_e420, 0f, 1f)));
                            }
                            let _e429 = phi_5554_;
                            phi_5555_ = _e429;
                        }
                        let _e433 = phi_5555_;
                        let _e434 = (_e387 / _e389);
                        let _e442 = global.member[0u];
                        let _e445 = global.member[1u];
                        let _e450 = global.member_31;
                        let _e451 = (_e450 > 0u);
                        phi_3649_ = _e451;
                        if _e451 {
                            let _e453 = global.member_34;
                            let _e456 = global.member_29;
                            let _e463 = global.member_49;
                            let _e467 = global.member_51;
                            switch bitcast<i32>(0u) {
                                default: {
                                    let _e473 = vec2(((sqrt((2f * log(max((max(255f, _e453) / _e456), 1f)))) * sqrt(_e463)) * ((((_e373 * length(vec3<f32>(_e434.x, _e434.y, 1f))) * max(_e442, _e445)) / _e341) + sqrt(_e467))));
                                    let _e476 = global.member_32;
                                    let _e479 = global.member_33;
                                    let _e487 = vec2<u32>(clamp(((((_e393 - _e473) - _e476) * _e479) - vec2<f32>(0.5f, 0.5f)), vec2<f32>(0f, 0f), vec2<f32>(191f, 191f)));
                                    let _e489 = vec2<u32>(clamp(((((_e393 + _e473) - _e476) * _e479) + vec2<f32>(0.5f, 0.5f)), vec2<f32>(0f, 0f), vec2<f32>(191f, 191f)));
                                    let _e496 = max((_e489.x - _e487.x), (_e489.y - _e487.y));
                                    if (_e496 <= 3u) {
                                        phi_5559_ = 0u;
                                    } else {
                                        phi_5559_ = (bitcast<u32>(firstLeadingBit((_e496 - 1u))) - 1u);
                                    }
                                    let _e503 = phi_5559_;
                                    if !((_e503 < 4u)) {
                                        phi_5569_ = false;
                                        break;
                                    }
                                    let _e513 = vec2(_e503);
                                    let _e515 = (_e487 >> bitcast<vec2<u32>>(_e513));
                                    let _e517 = (_e489 >> bitcast<vec2<u32>>(_e513));
                                    let _e519 = (_e515.x & 4294967292u);
                                    phi_5565_ = _e519;
                                    phi_5564_ = 0f;
                                    phi_5562_ = _e515.y;
                                    loop {
                                        let _e522 = phi_5565_;
                                        let _e524 = phi_5564_;
                                        let _e526 = phi_5562_;
                                        local = _e524;
                                        if (_e526 <= _e517.y) {
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e531 = (vec4(f32(_e522)) + vec4<f32>(0f, 1f, 2f, 3f));
                                            let _e549 = global_3.member[((_e450 >> bitcast<u32>(1u)) + ((((4u * (12288u - (12288u >> bitcast<u32>((2u * _e503))))) + (_e526 * (192u >> bitcast<u32>(_e503)))) + _e522) >> bitcast<u32>(2u)))];
                                            let _e551 = unpack2x16unorm(_e549.x);
                                            let _e553 = unpack2x16unorm(_e549.y);
                                            let _e560 = select(select(vec4<f32>(_e551.x, _e551.y, _e553.x, _e553.y), vec4<f32>(0f, 0f, 0f, 0f), (_e531 < vec4(f32(_e515.x)))), vec4<f32>(0f, 0f, 0f, 0f), (_e531 > vec4(f32(_e517.x))));
                                            let _e569 = (_e522 + 4u);
                                            let _e570 = (_e569 > _e517.x);
                                            phi_5565_ = select(_e569, _e519, _e570);
                                            phi_5564_ = max(_e524, max(max(_e560.x, _e560.y), max(_e560.z, _e560.w)));
                                            phi_5562_ = (_e526 + select(0u, 1u, _e570));
                                        }
                                    }
                                    let _e575 = local;
                                    phi_5569_ = ((1f - _e433) > _e575);
                                    break;
                                }
                            }
                            let _e578 = phi_5569_;
                            phi_3649_ = _e578;
                        }
                        let _e580 = phi_3649_;
                        if _e580 {
                            let _e582 = global_2.member_9;
                            if (_e582 != 0u) {
                                let _e586 = atomicAdd((&global_1.member[1u]), 1u);
                            }
                            phi_5580_ = _e433;
                            phi_5571_ = _e393;
                            phi_5570_ = false;
                            break;
                        }
                        phi_5580_ = _e433;
                        phi_5571_ = _e393;
                        phi_5570_ = true;
                        break;
                    }
                }
                let _e588 = phi_5580_;
                let _e590 = phi_5571_;
                let _e592 = phi_5570_;
                let _e597 = global_7.member[((3u * _e89) + _e93)];
                let _e600 = (_e597.y >> bitcast<u32>(24u));
                let _e614 = ((vec3<f32>(f32((_e597.x & 1023u)), f32(((_e597.x >> bitcast<u32>(10u)) & 1023u)), f32(((_e597.x >> bitcast<u32>(20u)) & 1023u))) - vec3<f32>(512f, 512f, 512f)) * vec3<f32>(0.0013888889f, 0.0013888889f, 0.0013888889f));
                let _e618 = sqrt(max((1f - dot(_e614, _e614)), 0f));
                let _e620 = (_e597.x >> bitcast<u32>(30u));
                if (_e620 == 0u) {
                    phi_5592_ = vec4<f32>(_e618, _e614.x, _e614.y, _e614.z);
                } else {
                    if (_e620 == 1u) {
                        phi_5591_ = vec4<f32>(_e614.x, _e618, _e614.y, _e614.z);
                    } else {
                        if (_e620 == 2u) {
                            phi_5590_ = vec4<f32>(_e614.x, _e614.y, _e618, _e614.z);
                        } else {
                            phi_5590_ = vec4<f32>(_e614.x, _e614.y, _e614.z, _e618);
                        }
                        let _e633 = phi_5590_;
                        phi_5591_ = _e633;
                    }
                    let _e639 = phi_5591_;
                    phi_5592_ = _e639;
                }
                let _e645 = phi_5592_;
                let _e649 = global.member_38;
                let _e650 = (_e649 > 0u);
                phi_5610_ = unpack4x8unorm(_e597.y).xyz;
                if _e650 {
                    let _e654 = global_7.member[(_e649 + _e93)];
                    let _e656 = unpack2x16float(_e654.x);
                    phi_5610_ = vec3<f32>(_e656.x, _e656.y, unpack2x16float(_e654.y).x);
                }
                let _e664 = phi_5610_;
                let _e667 = (1u << bitcast<u32>((_e93 & 31u)));
                let _e670 = global_7.member[_e97];
                let _e674 = global_7.member[(_e97 + 1u)];
                let _e678 = global_7.member[(_e97 + 2u)];
                phi_5627_ = _e645;
                if ((_e670.x & _e667) != 0u) {
                    let _e689 = global.member_22;
                    let _e691 = global.member_18;
                    let _e695 = (_e689 + ((_e674.y + bitcast<u32>(countOneBits((_e670.x & (_e667 - 1u))))) * (1u + (4u * _e691))));
                    let _e696 = (_e695 + 1u);
                    let _e699 = global_6.member[_e695];
                    let _e701 = global.member_44;
                    let _e705 = global.member_19;
                    phi_5612_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_5611_ = 0u;
                    loop {
                        let _e709 = phi_5612_;
                        let _e711 = phi_5611_;
                        let _e713 = (2u * ((_e701 + ((_e699 >> bitcast<u32>(16u)) * _e705)) + _e711));
                        let _e716 = global_3.member[_e713];
                        let _e720 = global_3.member[(_e713 + 1u)];
                        let _e726 = bitcast<vec4<f32>>(vec4<u32>(_e716.x, _e716.y, _e720.x, _e720.y));
                        let _e730 = global_6.member[(_e696 + _e711)];
                        let _e737 = global_6.member[((_e696 + _e691) + _e711)];
                        let _e745 = global_6.member[((_e696 + (2u * _e691)) + _e711)];
                        let _e753 = global_6.member[((_e696 + (3u * _e691)) + _e711)];
                        let _e757 = (_e709 + vec4<f32>(dot(unpack4x8snorm(_e730), _e726), dot(unpack4x8snorm(_e737), _e726), dot(unpack4x8snorm(_e745), _e726), dot(unpack4x8snorm(_e753), _e726)));
                        let _e759 = (_e711 + bitcast<u32>(1i));
                        phi_5612_ = _e757;
                        phi_5611_ = _e759;
                        local_1 = _e757;
                        if (_e759 < _e691) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e765 = local_1;
                    let _e767 = (_e645 + (_e765 * (127f * unpack2x16float(_e699).x)));
                    phi_5627_ = select(_e645, _e767, vec4((length(_e767) >= 0.001f)));
                }
                let _e773 = phi_5627_;
                phi_5631_ = _e233;
                if ((_e670.y & _e667) != 0u) {
                    let _e784 = global.member_23;
                    let _e786 = global.member_18;
                    let _e790 = (_e784 + ((_e678.x + bitcast<u32>(countOneBits((_e670.y & (_e667 - 1u))))) * (1u + (3u * _e786))));
                    let _e791 = (_e790 + 1u);
                    let _e794 = global_6.member[_e790];
                    let _e796 = global.member_44;
                    let _e800 = global.member_19;
                    phi_5615_ = vec3<f32>(0f, 0f, 0f);
                    phi_5614_ = 0u;
                    loop {
                        let _e804 = phi_5615_;
                        let _e806 = phi_5614_;
                        let _e808 = (2u * ((_e796 + ((_e794 >> bitcast<u32>(16u)) * _e800)) + _e806));
                        let _e811 = global_3.member[_e808];
                        let _e815 = global_3.member[(_e808 + 1u)];
                        let _e821 = bitcast<vec4<f32>>(vec4<u32>(_e811.x, _e811.y, _e815.x, _e815.y));
                        let _e825 = global_6.member[(_e791 + _e806)];
                        let _e832 = global_6.member[((_e791 + _e786) + _e806)];
                        let _e840 = global_6.member[((_e791 + (2u * _e786)) + _e806)];
                        let _e844 = (_e804 + vec3<f32>(dot(unpack4x8snorm(_e825), _e821), dot(unpack4x8snorm(_e832), _e821), dot(unpack4x8snorm(_e840), _e821)));
                        let _e846 = (_e806 + bitcast<u32>(1i));
                        phi_5615_ = _e844;
                        phi_5614_ = _e846;
                        local_2 = _e844;
                        if (_e846 < _e786) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e852 = local_2;
                    phi_5631_ = (_e233 + (_e852 * (127f * unpack2x16float(_e794).x)));
                }
                let _e856 = phi_5631_;
                phi_5633_ = _e664;
                if ((_e674.x & _e667) != 0u) {
                    let _e867 = global.member_24;
                    let _e869 = global.member_18;
                    let _e873 = (_e867 + ((_e678.y + bitcast<u32>(countOneBits((_e674.x & (_e667 - 1u))))) * (3u + (3u * _e869))));
                    let _e877 = global_6.member[(_e873 + 1u)];
                    let _e878 = unpack2x16float(_e877);
                    let _e882 = global_6.member[(_e873 + 2u)];
                    let _e890 = (_e873 + 3u);
                    let _e893 = global_6.member[_e873];
                    let _e895 = global.member_44;
                    let _e899 = global.member_19;
                    phi_5624_ = vec3<f32>(0f, 0f, 0f);
                    phi_5623_ = 0u;
                    loop {
                        let _e903 = phi_5624_;
                        let _e905 = phi_5623_;
                        let _e907 = (2u * ((_e895 + ((_e893 >> bitcast<u32>(16u)) * _e899)) + _e905));
                        let _e910 = global_3.member[_e907];
                        let _e914 = global_3.member[(_e907 + 1u)];
                        let _e920 = bitcast<vec4<f32>>(vec4<u32>(_e910.x, _e910.y, _e914.x, _e914.y));
                        let _e924 = global_6.member[(_e890 + _e905)];
                        let _e931 = global_6.member[((_e890 + _e869) + _e905)];
                        let _e939 = global_6.member[((_e890 + (2u * _e869)) + _e905)];
                        let _e943 = (_e903 + vec3<f32>(dot(unpack4x8snorm(_e924), _e920), dot(unpack4x8snorm(_e931), _e920), dot(unpack4x8snorm(_e939), _e920)));
                        let _e945 = (_e905 + bitcast<u32>(1i));
                        phi_5624_ = _e943;
                        phi_5623_ = _e945;
                        local_3 = _e943;
                        if (_e945 < _e869) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e951 = local_3;
                    phi_5633_ = (select(vec3<f32>(_e878.x, _e878.y, unpack2x16float(_e882).x), _e664, vec3(_e650)) + (_e951 * (127f * unpack2x16float(_e893).x)));
                }
                let _e955 = phi_5633_;
                let _e956 = normalize(_e773);
                let _e961 = (_e956.z * _e956.z);
                let _e962 = (_e956.w * _e956.w);
                let _e966 = (_e956.y * _e956.z);
                let _e967 = (_e956.x * _e956.w);
                let _e970 = (_e956.y * _e956.w);
                let _e971 = (_e956.x * _e956.z);
                let _e976 = (_e956.y * _e956.y);
                let _e980 = (_e956.z * _e956.w);
                let _e981 = (_e956.x * _e956.y);
                let _e995 = exp(min(_e856, vec3<f32>(9f, 9f, 9f)));
                let _e1002 = mat3x3<f32>((vec3<f32>((1f - (2f * (_e961 + _e962))), (2f * (_e966 + _e967)), (2f * (_e970 - _e971))) * _e995.x), (vec3<f32>((2f * (_e966 - _e967)), (1f - (2f * (_e976 + _e962))), (2f * (_e980 + _e981))) * _e995.y), (vec3<f32>((2f * (_e970 + _e971)), (2f * (_e980 - _e981)), (1f - (2f * (_e976 + _e961)))) * _e995.z));
                let _e1004 = (transpose(mat3x3<f32>(_e355, _e356, _e357)) * _e1002);
                let _e1006 = global.member_42;
                let _e1008 = (_e1006 + (3u * _e83));
                let _e1009 = transpose(_e1004);
                let _e1019 = max(_e373, sqrt(max(max(dot(_e1009[0], _e1009[0]), dot(_e1009[1], _e1009[1])), dot(_e1009[2], _e1009[2]))));
                let _e1021 = global.member_43;
                let _e1032 = (all((abs(_e342) < vec3<f32>(1000000000000000000000000000000f, 1000000000000000000000000000000f, 1000000000000000000000000000000f))) && (_e1019 <= 1000000000000000000f));
                if _e1032 {
                    let _e1034 = global.member_55;
                    let _e1038 = global.member_56;
                    phi_5634_ = ((_e342 - _e1034.xyz) / _e1038.xyz);
                } else {
                    phi_5634_ = vec3<f32>(0f, 0f, 0f);
                }
                let _e1042 = phi_5634_;
                let _e1059 = vec3<u32>(round((clamp(select(select((vec3<f32>(0.015625f, 0.015625f, 0.015625f) + (clamp(_e1042, vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 0.96875f)), (vec3<f32>(0.015625f, 0.015625f, 0.015625f) / (vec3<f32>(1f, 1f, 1f) - min(_e1042, vec3<f32>(0f, 0f, 0f)))), (_e1042 < vec3<f32>(0f, 0f, 0f))), (vec3<f32>(1f, 1f, 1f) - (vec3<f32>(0.015625f, 0.015625f, 0.015625f) / max(_e1042, vec3<f32>(1f, 1f, 1f)))), (_e1042 > vec3<f32>(1f, 1f, 1f))), vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 16777215f)));
                let _e1061 = (_e1059 >> bitcast<vec3<u32>>(vec3<u32>(8u, 8u, 8u)));
                let _e1062 = (_e1059 & vec3<u32>(255u, 255u, 255u));
                let _e1078 = ((_e1061.z | (u32(clamp(select(0f, ceil(((8f * log2(max((_e1019 / _e1021), 0.000000000000000000000000000001f))) + 152f)), _e1032), 0f, 255f)) << bitcast<u32>(16u))) | (select(0u, _e600, _e1032) << bitcast<u32>(24u)));
                let _e1095 = vec3<f32>(_e1004[0].x, _e1004[1].x, _e1004[2].x);
                let _e1102 = vec3<f32>(_e1004[0].y, _e1004[1].y, _e1004[2].y);
                let _e1109 = vec3<f32>(_e1004[0].z, _e1004[1].z, _e1004[2].z);
                let _e1110 = length(_e1095);
                if (_e1110 > 0f) {
                    phi_5636_ = (_e1095 / vec3(_e1110));
                } else {
                    phi_5636_ = vec3<f32>(0f, 0f, 0f);
                }
                let _e1115 = phi_5636_;
                let _e1116 = dot(_e1102, _e1115);
                let _e1118 = (_e1102 - (_e1115 * _e1116));
                let _e1119 = length(_e1118);
                if (_e1119 > 0f) {
                    phi_5638_ = (_e1118 / vec3(_e1119));
                } else {
                    phi_5638_ = vec3<f32>(0f, 0f, 0f);
                }
                let _e1124 = phi_5638_;
                let _e1125 = dot(_e1109, _e1115);
                let _e1126 = dot(_e1109, _e1124);
                let _e1140 = (1023f / (_e1021 * exp2(((f32(((_e1078 >> bitcast<u32>(16u)) & 255u)) * 0.125f) - 19f))));
                let _e1158 = vec3<u32>(round((clamp(_e955, vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 1023f)));
                let _e1161 = ((vec3<u32>(clamp((round((vec3<f32>(_e1110, _e1119, _e1126) * _e1140)) + vec3<f32>(1023f, 1023f, 1023f)), vec3<f32>(0f, 0f, 0f), vec3<f32>(2046f, 2046f, 2046f))) | (vec3<u32>(clamp((round((vec3<f32>(_e1116, _e1125, length(((_e1109 - (_e1115 * _e1125)) - (_e1124 * _e1126)))) * _e1140)) + vec3<f32>(1023f, 1023f, 1023f)), vec3<f32>(0f, 0f, 0f), vec3<f32>(2046f, 2046f, 2046f))) << bitcast<vec3<u32>>(vec3<u32>(11u, 11u, 11u)))) | (_e1158 << bitcast<vec3<u32>>(vec3<u32>(22u, 22u, 22u))));
                global_4.member[_e1008] = (_e1061.x | (_e1061.y << bitcast<u32>(16u)));
                global_4.member[(_e1008 + 1u)] = _e1078;
                global_4.member[(_e1008 + 2u)] = ((_e1062.x | (_e1062.y << bitcast<u32>(8u))) | (_e1062.z << bitcast<u32>(16u)));
                let _e1172 = (_e1006 + (3u * (_e85 + _e83)));
                global_4.member[_e1172] = _e1161.x;
                global_4.member[(_e1172 + 1u)] = _e1161.y;
                global_4.member[(_e1172 + 2u)] = _e1161.z;
                phi_3182_ = _e592;
                if _e592 {
                    let _e1186 = global.member_29;
                    phi_3182_ = (f32(_e600) <= _e1186);
                }
                let _e1189 = phi_3182_;
                if _e1189 {
                    let _e1191 = global_2.member_9;
                    if (_e1191 != 0u) {
                        let _e1195 = atomicAdd((&global_1.member[2u]), 1u);
                    }
                }
                let _e1196 = !(_e592);
                phi_3196_ = _e1196;
                if !(_e1196) {
                    let _e1200 = global.member_29;
                    phi_3196_ = (f32(_e600) <= _e1200);
                }
                let _e1203 = phi_3196_;
                if _e1203 {
                    phi_5668_ = 4294967295u;
                    break;
                }
                switch bitcast<i32>(0u) {
                    default: {
                        let _e1209 = global.member_2;
                        let _e1211 = global.member_3;
                        let _e1212 = clamp((_e342.xy / vec2(_e341)), _e1209, _e1211);
                        let _e1215 = global.member[0u];
                        let _e1221 = (((_e355 - (_e357 * _e1212.x)) * (_e1215 / _e341)) * _e1002);
                        let _e1224 = global.member[1u];
                        let _e1230 = (((_e356 - (_e357 * _e1212.y)) * (_e1224 / _e341)) * _e1002);
                        let _e1232 = global.member_51;
                        let _e1234 = (dot(_e1221, _e1221) + _e1232);
                        let _e1237 = (dot(_e1230, _e1230) + _e1232);
                        let _e1239 = cross(_e1221, _e1230);
                        let _e1240 = dot(_e1239, _e1239);
                        let _e1244 = (_e1240 + (_e1232 * ((_e1234 + _e1237) - _e1232)));
                        let _e1245 = (_e1244 > 0f);
                        phi_4991_ = _e1245;
                        if _e1245 {
                            phi_4991_ = (_e1234 <= 1000000000000000000f);
                        }
                        let _e1248 = phi_4991_;
                        phi_4997_ = _e1248;
                        if _e1248 {
                            phi_4997_ = (_e1237 <= 1000000000000000000f);
                        }
                        let _e1251 = phi_4997_;
                        if !(_e1251) {
                            let _e1254 = global_2.member_9;
                            if (_e1254 != 0u) {
                                let _e1258 = atomicAdd((&global_1.member[3u]), 1u);
                            }
                            phi_5667_ = 4294967295u;
                            break;
                        }
                        phi_5653_ = (1f - (f32(_e600) * 0.003921569f));
                        phi_5652_ = 0u;
                        loop {
                            let _e1263 = phi_5653_;
                            let _e1265 = phi_5652_;
                            local_4 = _e1263;
                            if (_e1265 < _e91) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                phi_5653_ = (_e1263 * _e1263);
                                phi_5652_ = (_e1265 + bitcast<u32>(1i));
                            }
                        }
                        let _e1271 = local_4;
                        let _e1275 = u32(round((255f * (1f - _e1271))));
                        let _e1277 = global.member_52;
                        phi_5661_ = _e1275;
                        if (_e1277 > 0f) {
                            let _e1287 = u32(round((f32(_e1275) * ((1f - _e1277) + (_e1277 * sqrt((_e1240 / _e1244)))))));
                            let _e1290 = global.member_29;
                            if (f32(_e1287) <= _e1290) {
                                let _e1293 = global_2.member_9;
                                if (_e1293 != 0u) {
                                    let _e1297 = atomicAdd((&global_1.member[2u]), 1u);
                                }
                                phi_5667_ = 4294967295u;
                                break;
                            }
                            phi_5661_ = _e1287;
                        }
                        let _e1299 = phi_5661_;
                        let _e1301 = global.member_49;
                        let _e1302 = (vec3<f32>(_e1234, dot(_e1221, _e1230), _e1237) * _e1301);
                        let _e1307 = global.member_29;
                        let _e1317 = global.member_53;
                        let _e1318 = ((sqrt(_e1302.xz) * sqrt((2f * log(max((f32(_e1299) / _e1307), 1f))))) * _e1317);
                        let _e1321 = global.member_54;
                        let _e1324 = all(((_e590 + _e1318) > _e1321.xy));
                        phi_5075_ = _e1324;
                        if _e1324 {
                            phi_5075_ = all(((_e590 - _e1318) < _e1321.zw));
                        }
                        let _e1330 = phi_5075_;
                        if !(_e1330) {
                            let _e1333 = global_2.member_9;
                            if (_e1333 != 0u) {
                                let _e1337 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_5667_ = 4294967295u;
                            break;
                        }
                        let _e1341 = (0.5f * (_e1302.x - _e1302.z));
                        let _e1346 = sqrt(((_e1341 * _e1341) + (_e1302.y * _e1302.y)));
                        let _e1349 = ((0.5f * (_e1302.x + _e1302.z)) + _e1346);
                        if (_e1341 >= 0f) {
                            phi_5665_ = vec2<f32>((_e1341 + _e1346), _e1302.y);
                        } else {
                            phi_5665_ = vec2<f32>(_e1302.y, (_e1346 - _e1341));
                        }
                        let _e1356 = phi_5665_;
                        if (_e1346 > (0.00000001f * _e1349)) {
                            phi_5666_ = normalize(_e1356);
                        } else {
                            phi_5666_ = vec2<f32>(1f, 0f);
                        }
                        let _e1361 = phi_5666_;
                        let _e1368 = global.member_5;
                        let _e1372 = global.member_10;
                        let _e1376 = vec2<u32>(clamp(round(((_e590 + vec2(_e1368)) * _e1372)), vec2<f32>(0f, 0f), vec2<f32>(1048575f, 1048575f)));
                        let _e1404 = global.member_45;
                        let _e1406 = (4u * (_e1404 + _e83));
                        global_4.member[_e1406] = ((_e1376.x | (_e1158.x << bitcast<u32>(20u))) | (_e1158.z << bitcast<u32>(30u)));
                        global_4.member[(_e1406 + 1u)] = (_e1376.y | (_e1158.y << bitcast<u32>(20u)));
                        global_4.member[(_e1406 + 2u)] = pack2x16float((_e1361 * min(sqrt(_e1349), 65504f)));
                        global_4.member[(_e1406 + 3u)] = ((pack2x16float(vec2<f32>(min(sqrt(((_e1244 * (_e1301 * _e1301)) / _e1349)), 65504f), 0f)) | (_e1299 << bitcast<u32>(16u))) | ((_e1158.z >> bitcast<u32>(2u)) << bitcast<u32>(24u)));
                        let _e1419 = global.member_9;
                        phi_5667_ = min(u32((_e588 * f32(_e1419))), _e1419);
                        break;
                    }
                }
                let _e1425 = phi_5667_;
                phi_5668_ = _e1425;
                break;
            }
        }
        let _e1427 = phi_5668_;
        phi_5669_ = _e1427;
    } else {
        phi_5669_ = 4294967295u;
    }
    let _e1429 = phi_5669_;
    switch bitcast<i32>(0u) {
        default: {
            let _e1432 = bitcast<u32>(param[0u]);
            let _e1434 = global.member_45;
            let _e1435 = (_e1434 + _e83);
            if (_e1429 != 4294967295u) {
                let _e1438 = global.member_41;
                let _e1442 = global.member_40;
                let _e1448 = atomicAdd((&global_1.member[((_e1442 + ((_e1435 / _e1438) * 256u)) + (_e1429 & 255u))]), 1u);
            }
            let _e1450 = global.member_39;
            if (_e1450 == 0u) {
                if (_e83 < (_e85 + (_e85 & 1u))) {
                    let _e1456 = global.member_28;
                    global_4.member[(_e1456 + _e1435)] = _e1429;
                }
                break;
            }
            global_5[_e1432] = _e1429;
            workgroupBarrier();
            let _e1462 = ((_e1432 & 1u) == 0u);
            if select(_e1462, _e86, _e1462) {
                let _e1465 = global.member_28;
                let _e1472 = global_5[(_e1432 + 1u)];
                global_4.member[(_e1465 + (_e1435 >> bitcast<u32>(1u)))] = ((_e1429 & 65535u) | (_e1472 << bitcast<u32>(16u)));
            }
            break;
        }
    }
    return;
}
