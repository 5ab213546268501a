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
    var phi_3508_: bool;
    var phi_5377_: f32;
    var phi_5378_: f32;
    var phi_5382_: u32;
    var phi_5388_: u32;
    var phi_5387_: f32;
    var phi_5385_: u32;
    var local: f32;
    var phi_5392_: bool;
    var phi_3554_: bool;
    var phi_5403_: f32;
    var phi_5394_: vec2<f32>;
    var phi_5393_: bool;
    var phi_5413_: vec4<f32>;
    var phi_5414_: vec4<f32>;
    var phi_5415_: vec4<f32>;
    var phi_5433_: vec3<f32>;
    var phi_5435_: vec4<f32>;
    var phi_5434_: u32;
    var local_1: vec4<f32>;
    var phi_5450_: vec4<f32>;
    var phi_5438_: vec3<f32>;
    var phi_5437_: u32;
    var local_2: vec3<f32>;
    var phi_5454_: vec3<f32>;
    var phi_5447_: vec3<f32>;
    var phi_5446_: u32;
    var local_3: vec3<f32>;
    var phi_5456_: vec3<f32>;
    var phi_5457_: vec3<f32>;
    var phi_5459_: vec3<f32>;
    var phi_5461_: vec3<f32>;
    var phi_3090_: bool;
    var phi_3104_: bool;
    var phi_4861_: bool;
    var phi_4867_: bool;
    var phi_5479_: f32;
    var phi_5478_: u32;
    var local_4: f32;
    var phi_4905_: bool;
    var phi_5485_: vec2<f32>;
    var phi_5486_: vec2<f32>;
    var phi_5487_: u32;
    var phi_5488_: u32;
    var phi_5489_: u32;

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
                let _e106 = (2u * _e89);
                let _e110 = global_7.member[(_e106 + _e93)];
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
                let _e267 = global.member_58[_e264];
                let _e272 = global.member_58[(_e264 + 1u)];
                let _e277 = global.member_58[(_e264 + 2u)];
                let _e281 = (3u * _e242.y);
                let _e284 = global.member_58[_e281];
                let _e290 = global.member_58[(_e281 + 1u)];
                let _e296 = global.member_58[(_e281 + 2u)];
                let _e301 = (3u * _e242.z);
                let _e304 = global.member_58[_e301];
                let _e310 = global.member_58[(_e301 + 1u)];
                let _e316 = global.member_58[(_e301 + 2u)];
                let _e321 = (3u * _e242.w);
                let _e324 = global.member_58[_e321];
                let _e326 = ((((_e267 * _e261.x) + (_e284 * _e261.y)) + (_e304 * _e261.z)) + (_e324 * _e261.w));
                let _e330 = global.member_58[(_e321 + 1u)];
                let _e332 = ((((_e272 * _e261.x) + (_e290 * _e261.y)) + (_e310 * _e261.z)) + (_e330 * _e261.w));
                let _e336 = global.member_58[(_e321 + 2u)];
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
                            phi_5403_ = 0f;
                            phi_5394_ = vec2<f32>(0f, 0f);
                            phi_5393_ = false;
                            break;
                        }
                        let _e386 = global.member;
                        let _e387 = _e342.xy;
                        let _e389 = vec2(_e341);
                        let _e392 = global.member_1;
                        let _e393 = (((_e386 * _e387) / _e389) + _e392);
                        let _e395 = global.member_5;
                        let _e399 = all((_e393 >= vec2(-(_e395))));
                        phi_3508_ = _e399;
                        if _e399 {
                            let _e401 = global.member_4;
                            phi_3508_ = all((_e393 <= (_e401 + vec2(_e395))));
                        }
                        let _e407 = phi_3508_;
                        if !(_e407) {
                            let _e410 = global_2.member_9;
                            if (_e410 != 0u) {
                                let _e414 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_5403_ = 0f;
                            phi_5394_ = _e393;
                            phi_5393_ = false;
                            break;
                        }
                        let _e416 = global.member_7;
                        let _e419 = global.member_8;
                        let _e420 = ((_e416 - _e341) * _e419);
                        if (_e420 < 0f) {
                            phi_5378_ = (0.015625f / (1f - _e420));
                        } else {
                            if (_e420 > 1f) {
                                phi_5377_ = (1f - (0.015625f / _e420));
                            } else {
                                phi_5377_ = (0.015625f + (0.96875f * clamp(_e420, 0f, 1f)));
                            }
                            let _e429 = phi_5377_;
                            phi_5378_ = _e429;
                        }
                        let _e433 = phi_5378_;
                        let _e434 = (_e387 / _e389);
                        let _e442 = global.member[0u];
                        let _e445 = global.member[1u];
                        let _e450 = global.member_31;
                        let _e451 = (_e450 > 0u);
                        phi_3554_ = _e451;
                        if _e451 {
                            let _e453 = global.member_34;
                            let _e456 = global.member_29;
                            let _e463 = global.member_49;
                            switch bitcast<i32>(0u) {
                                default: {
                                    let _e470 = vec2(((sqrt((2f * log(max((max(255f, _e453) / _e456), 1f)))) * sqrt(_e463)) * ((((_e373 * length(vec3<f32>(_e434.x, _e434.y, 1f))) * max(_e442, _e445)) / _e341) + 0.5477226f)));
                                    let _e473 = global.member_32;
                                    let _e476 = global.member_33;
                                    let _e484 = vec2<u32>(clamp(((((_e393 - _e470) - _e473) * _e476) - vec2<f32>(0.5f, 0.5f)), vec2<f32>(0f, 0f), vec2<f32>(191f, 191f)));
                                    let _e486 = vec2<u32>(clamp(((((_e393 + _e470) - _e473) * _e476) + vec2<f32>(0.5f, 0.5f)), vec2<f32>(0f, 0f), vec2<f32>(191f, 191f)));
                                    let _e493 = max((_e486.x - _e484.x), (_e486.y - _e484.y));
                                    if (_e493 <= 3u) {
                                        phi_5382_ = 0u;
                                    } else {
                                        phi_5382_ = (bitcast<u32>(firstLeadingBit((_e493 - 1u))) - 1u);
                                    }
                                    let _e500 = phi_5382_;
                                    if !((_e500 < 4u)) {
                                        phi_5392_ = false;
                                        break;
                                    }
                                    let _e510 = vec2(_e500);
                                    let _e512 = (_e484 >> bitcast<vec2<u32>>(_e510));
                                    let _e514 = (_e486 >> bitcast<vec2<u32>>(_e510));
                                    let _e516 = (_e512.x & 4294967292u);
                                    phi_5388_ = _e516;
                                    phi_5387_ = 0f;
                                    phi_5385_ = _e512.y;
                                    loop {
                                        let _e519 = phi_5388_;
                                        let _e521 = phi_5387_;
                                        let _e523 = phi_5385_;
                                        local = _e521;
                                        if (_e523 <= _e514.y) {
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e528 = (vec4(f32(_e519)) + vec4<f32>(0f, 1f, 2f, 3f));
                                            let _e546 = global_3.member[((_e450 >> bitcast<u32>(1u)) + ((((4u * (12288u - (12288u >> bitcast<u32>((2u * _e500))))) + (_e523 * (192u >> bitcast<u32>(_e500)))) + _e519) >> bitcast<u32>(2u)))];
                                            let _e548 = unpack2x16unorm(_e546.x);
                                            let _e550 = unpack2x16unorm(_e546.y);
                                            let _e557 = select(select(vec4<f32>(_e548.x, _e548.y, _e550.x, _e550.y), vec4<f32>(0f, 0f, 0f, 0f), (_e528 < vec4(f32(_e512.x)))), vec4<f32>(0f, 0f, 0f, 0f), (_e528 > vec4(f32(_e514.x))));
                                            let _e566 = (_e519 + 4u);
                                            let _e567 = (_e566 > _e514.x);
                                            phi_5388_ = select(_e566, _e516, _e567);
                                            phi_5387_ = max(_e521, max(max(_e557.x, _e557.y), max(_e557.z, _e557.w)));
                                            phi_5385_ = (_e523 + select(0u, 1u, _e567));
                                        }
                                    }
                                    let _e572 = local;
                                    phi_5392_ = ((1f - _e433) > _e572);
                                    break;
                                }
                            }
                            let _e575 = phi_5392_;
                            phi_3554_ = _e575;
                        }
                        let _e577 = phi_3554_;
                        if _e577 {
                            let _e579 = global_2.member_9;
                            if (_e579 != 0u) {
                                let _e583 = atomicAdd((&global_1.member[1u]), 1u);
                            }
                            phi_5403_ = _e433;
                            phi_5394_ = _e393;
                            phi_5393_ = false;
                            break;
                        }
                        phi_5403_ = _e433;
                        phi_5394_ = _e393;
                        phi_5393_ = true;
                        break;
                    }
                }
                let _e585 = phi_5403_;
                let _e587 = phi_5394_;
                let _e589 = phi_5393_;
                let _e594 = global_7.member[((3u * _e89) + _e93)];
                let _e597 = (_e594.y >> bitcast<u32>(24u));
                let _e611 = ((vec3<f32>(f32((_e594.x & 1023u)), f32(((_e594.x >> bitcast<u32>(10u)) & 1023u)), f32(((_e594.x >> bitcast<u32>(20u)) & 1023u))) - vec3<f32>(512f, 512f, 512f)) * vec3<f32>(0.0013888889f, 0.0013888889f, 0.0013888889f));
                let _e615 = sqrt(max((1f - dot(_e611, _e611)), 0f));
                let _e617 = (_e594.x >> bitcast<u32>(30u));
                if (_e617 == 0u) {
                    phi_5415_ = vec4<f32>(_e615, _e611.x, _e611.y, _e611.z);
                } else {
                    if (_e617 == 1u) {
                        phi_5414_ = vec4<f32>(_e611.x, _e615, _e611.y, _e611.z);
                    } else {
                        if (_e617 == 2u) {
                            phi_5413_ = vec4<f32>(_e611.x, _e611.y, _e615, _e611.z);
                        } else {
                            phi_5413_ = vec4<f32>(_e611.x, _e611.y, _e611.z, _e615);
                        }
                        let _e630 = phi_5413_;
                        phi_5414_ = _e630;
                    }
                    let _e636 = phi_5414_;
                    phi_5415_ = _e636;
                }
                let _e642 = phi_5415_;
                let _e646 = global.member_38;
                let _e647 = (_e646 > 0u);
                phi_5433_ = unpack4x8unorm(_e594.y).xyz;
                if _e647 {
                    let _e651 = global_7.member[(_e646 + _e93)];
                    let _e653 = unpack2x16float(_e651.x);
                    phi_5433_ = vec3<f32>(_e653.x, _e653.y, unpack2x16float(_e651.y).x);
                }
                let _e661 = phi_5433_;
                let _e664 = (1u << bitcast<u32>((_e93 & 31u)));
                let _e667 = global_7.member[_e97];
                let _e671 = global_7.member[(_e97 + 1u)];
                let _e675 = global_7.member[(_e97 + 2u)];
                phi_5450_ = _e642;
                if ((_e667.x & _e664) != 0u) {
                    let _e686 = global.member_22;
                    let _e688 = global.member_18;
                    let _e692 = (_e686 + ((_e671.y + bitcast<u32>(countOneBits((_e667.x & (_e664 - 1u))))) * (1u + (4u * _e688))));
                    let _e693 = (_e692 + 1u);
                    let _e696 = global_6.member[_e692];
                    let _e698 = global.member_44;
                    let _e702 = global.member_19;
                    phi_5435_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_5434_ = 0u;
                    loop {
                        let _e706 = phi_5435_;
                        let _e708 = phi_5434_;
                        let _e710 = (2u * ((_e698 + ((_e696 >> bitcast<u32>(16u)) * _e702)) + _e708));
                        let _e713 = global_3.member[_e710];
                        let _e717 = global_3.member[(_e710 + 1u)];
                        let _e723 = bitcast<vec4<f32>>(vec4<u32>(_e713.x, _e713.y, _e717.x, _e717.y));
                        let _e727 = global_6.member[(_e693 + _e708)];
                        let _e734 = global_6.member[((_e693 + _e688) + _e708)];
                        let _e742 = global_6.member[((_e693 + (2u * _e688)) + _e708)];
                        let _e750 = global_6.member[((_e693 + (3u * _e688)) + _e708)];
                        let _e754 = (_e706 + vec4<f32>(dot(unpack4x8snorm(_e727), _e723), dot(unpack4x8snorm(_e734), _e723), dot(unpack4x8snorm(_e742), _e723), dot(unpack4x8snorm(_e750), _e723)));
                        let _e756 = (_e708 + bitcast<u32>(1i));
                        phi_5435_ = _e754;
                        phi_5434_ = _e756;
                        local_1 = _e754;
                        if (_e756 < _e688) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e762 = local_1;
                    let _e764 = (_e642 + (_e762 * (127f * unpack2x16float(_e696).x)));
                    phi_5450_ = select(_e642, _e764, vec4((length(_e764) >= 0.001f)));
                }
                let _e770 = phi_5450_;
                phi_5454_ = _e233;
                if ((_e667.y & _e664) != 0u) {
                    let _e781 = global.member_23;
                    let _e783 = global.member_18;
                    let _e787 = (_e781 + ((_e675.x + bitcast<u32>(countOneBits((_e667.y & (_e664 - 1u))))) * (1u + (3u * _e783))));
                    let _e788 = (_e787 + 1u);
                    let _e791 = global_6.member[_e787];
                    let _e793 = global.member_44;
                    let _e797 = global.member_19;
                    phi_5438_ = vec3<f32>(0f, 0f, 0f);
                    phi_5437_ = 0u;
                    loop {
                        let _e801 = phi_5438_;
                        let _e803 = phi_5437_;
                        let _e805 = (2u * ((_e793 + ((_e791 >> bitcast<u32>(16u)) * _e797)) + _e803));
                        let _e808 = global_3.member[_e805];
                        let _e812 = global_3.member[(_e805 + 1u)];
                        let _e818 = bitcast<vec4<f32>>(vec4<u32>(_e808.x, _e808.y, _e812.x, _e812.y));
                        let _e822 = global_6.member[(_e788 + _e803)];
                        let _e829 = global_6.member[((_e788 + _e783) + _e803)];
                        let _e837 = global_6.member[((_e788 + (2u * _e783)) + _e803)];
                        let _e841 = (_e801 + vec3<f32>(dot(unpack4x8snorm(_e822), _e818), dot(unpack4x8snorm(_e829), _e818), dot(unpack4x8snorm(_e837), _e818)));
                        let _e843 = (_e803 + bitcast<u32>(1i));
                        phi_5438_ = _e841;
                        phi_5437_ = _e843;
                        local_2 = _e841;
                        if (_e843 < _e783) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e849 = local_2;
                    phi_5454_ = (_e233 + (_e849 * (127f * unpack2x16float(_e791).x)));
                }
                let _e853 = phi_5454_;
                phi_5456_ = _e661;
                if ((_e671.x & _e664) != 0u) {
                    let _e864 = global.member_24;
                    let _e866 = global.member_18;
                    let _e870 = (_e864 + ((_e675.y + bitcast<u32>(countOneBits((_e671.x & (_e664 - 1u))))) * (3u + (3u * _e866))));
                    let _e874 = global_6.member[(_e870 + 1u)];
                    let _e875 = unpack2x16float(_e874);
                    let _e879 = global_6.member[(_e870 + 2u)];
                    let _e887 = (_e870 + 3u);
                    let _e890 = global_6.member[_e870];
                    let _e892 = global.member_44;
                    let _e896 = global.member_19;
                    phi_5447_ = vec3<f32>(0f, 0f, 0f);
                    phi_5446_ = 0u;
                    loop {
                        let _e900 = phi_5447_;
                        let _e902 = phi_5446_;
                        let _e904 = (2u * ((_e892 + ((_e890 >> bitcast<u32>(16u)) * _e896)) + _e902));
                        let _e907 = global_3.member[_e904];
                        let _e911 = global_3.member[(_e904 + 1u)];
                        let _e917 = bitcast<vec4<f32>>(vec4<u32>(_e907.x, _e907.y, _e911.x, _e911.y));
                        let _e921 = global_6.member[(_e887 + _e902)];
                        let _e928 = global_6.member[((_e887 + _e866) + _e902)];
                        let _e936 = global_6.member[((_e887 + (2u * _e866)) + _e902)];
                        let _e940 = (_e900 + vec3<f32>(dot(unpack4x8snorm(_e921), _e917), dot(unpack4x8snorm(_e928), _e917), dot(unpack4x8snorm(_e936), _e917)));
                        let _e942 = (_e902 + bitcast<u32>(1i));
                        phi_5447_ = _e940;
                        phi_5446_ = _e942;
                        local_3 = _e940;
                        if (_e942 < _e866) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e948 = local_3;
                    phi_5456_ = (select(vec3<f32>(_e875.x, _e875.y, unpack2x16float(_e879).x), _e661, vec3(_e647)) + (_e948 * (127f * unpack2x16float(_e890).x)));
                }
                let _e952 = phi_5456_;
                let _e953 = normalize(_e770);
                let _e958 = (_e953.z * _e953.z);
                let _e959 = (_e953.w * _e953.w);
                let _e963 = (_e953.y * _e953.z);
                let _e964 = (_e953.x * _e953.w);
                let _e967 = (_e953.y * _e953.w);
                let _e968 = (_e953.x * _e953.z);
                let _e973 = (_e953.y * _e953.y);
                let _e977 = (_e953.z * _e953.w);
                let _e978 = (_e953.x * _e953.y);
                let _e992 = exp(min(_e853, vec3<f32>(9f, 9f, 9f)));
                let _e999 = mat3x3<f32>((vec3<f32>((1f - (2f * (_e958 + _e959))), (2f * (_e963 + _e964)), (2f * (_e967 - _e968))) * _e992.x), (vec3<f32>((2f * (_e963 - _e964)), (1f - (2f * (_e973 + _e959))), (2f * (_e977 + _e978))) * _e992.y), (vec3<f32>((2f * (_e967 + _e968)), (2f * (_e977 - _e978)), (1f - (2f * (_e973 + _e958)))) * _e992.z));
                let _e1001 = (transpose(mat3x3<f32>(_e355, _e356, _e357)) * _e999);
                let _e1003 = global.member_42;
                let _e1005 = (_e1003 + (2u * _e83));
                let _e1006 = transpose(_e1001);
                let _e1016 = max(_e373, sqrt(max(max(dot(_e1006[0], _e1006[0]), dot(_e1006[1], _e1006[1])), dot(_e1006[2], _e1006[2]))));
                let _e1018 = global.member_43;
                let _e1029 = (all((abs(_e342) < vec3<f32>(1000000000000000000000000000000f, 1000000000000000000000000000000f, 1000000000000000000000000000000f))) && (_e1016 <= 1000000000000000000f));
                if _e1029 {
                    let _e1031 = global.member_51;
                    let _e1035 = global.member_52;
                    phi_5457_ = ((_e342 - _e1031.xyz) / _e1035.xyz);
                } else {
                    phi_5457_ = vec3<f32>(0f, 0f, 0f);
                }
                let _e1039 = phi_5457_;
                let _e1056 = vec3<u32>(round((clamp(select(select((vec3<f32>(0.015625f, 0.015625f, 0.015625f) + (clamp(_e1039, vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 0.96875f)), (vec3<f32>(0.015625f, 0.015625f, 0.015625f) / (vec3<f32>(1f, 1f, 1f) - min(_e1039, vec3<f32>(0f, 0f, 0f)))), (_e1039 < vec3<f32>(0f, 0f, 0f))), (vec3<f32>(1f, 1f, 1f) - (vec3<f32>(0.015625f, 0.015625f, 0.015625f) / max(_e1039, vec3<f32>(1f, 1f, 1f)))), (_e1039 > vec3<f32>(1f, 1f, 1f))), vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 65535f)));
                let _e1072 = ((_e1056.z | (u32(clamp(select(0f, ceil(((8f * log2(max((_e1016 / _e1018), 0.000000000000000000000000000001f))) + 152f)), _e1029), 0f, 255f)) << bitcast<u32>(16u))) | (select(0u, _e597, _e1029) << bitcast<u32>(24u)));
                let _e1080 = vec3<f32>(_e1001[0].x, _e1001[1].x, _e1001[2].x);
                let _e1087 = vec3<f32>(_e1001[0].y, _e1001[1].y, _e1001[2].y);
                let _e1094 = vec3<f32>(_e1001[0].z, _e1001[1].z, _e1001[2].z);
                let _e1095 = length(_e1080);
                if (_e1095 > 0f) {
                    phi_5459_ = (_e1080 / vec3(_e1095));
                } else {
                    phi_5459_ = vec3<f32>(0f, 0f, 0f);
                }
                let _e1100 = phi_5459_;
                let _e1101 = dot(_e1087, _e1100);
                let _e1103 = (_e1087 - (_e1100 * _e1101));
                let _e1104 = length(_e1103);
                if (_e1104 > 0f) {
                    phi_5461_ = (_e1103 / vec3(_e1104));
                } else {
                    phi_5461_ = vec3<f32>(0f, 0f, 0f);
                }
                let _e1109 = phi_5461_;
                let _e1110 = dot(_e1094, _e1100);
                let _e1111 = dot(_e1094, _e1109);
                let _e1125 = (1023f / (_e1018 * exp2(((f32(((_e1072 >> bitcast<u32>(16u)) & 255u)) * 0.125f) - 19f))));
                let _e1143 = vec3<u32>(round((clamp(_e952, vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 1023f)));
                let _e1146 = ((vec3<u32>(clamp((round((vec3<f32>(_e1095, _e1104, _e1111) * _e1125)) + vec3<f32>(1023f, 1023f, 1023f)), vec3<f32>(0f, 0f, 0f), vec3<f32>(2046f, 2046f, 2046f))) | (vec3<u32>(clamp((round((vec3<f32>(_e1101, _e1110, length(((_e1094 - (_e1100 * _e1110)) - (_e1109 * _e1111)))) * _e1125)) + vec3<f32>(1023f, 1023f, 1023f)), vec3<f32>(0f, 0f, 0f), vec3<f32>(2046f, 2046f, 2046f))) << bitcast<vec3<u32>>(vec3<u32>(11u, 11u, 11u)))) | (_e1143 << bitcast<vec3<u32>>(vec3<u32>(22u, 22u, 22u))));
                global_4.member[_e1005] = (_e1056.x | (_e1056.y << bitcast<u32>(16u)));
                global_4.member[(_e1005 + 1u)] = _e1072;
                let _e1154 = ((_e1003 + _e106) + (3u * _e83));
                global_4.member[_e1154] = _e1146.x;
                global_4.member[(_e1154 + 1u)] = _e1146.y;
                global_4.member[(_e1154 + 2u)] = _e1146.z;
                phi_3090_ = _e589;
                if _e589 {
                    let _e1168 = global.member_29;
                    phi_3090_ = (f32(_e597) <= _e1168);
                }
                let _e1171 = phi_3090_;
                if _e1171 {
                    let _e1173 = global_2.member_9;
                    if (_e1173 != 0u) {
                        let _e1177 = atomicAdd((&global_1.member[2u]), 1u);
                    }
                }
                let _e1178 = !(_e589);
                phi_3104_ = _e1178;
                if !(_e1178) {
                    let _e1182 = global.member_29;
                    phi_3104_ = (f32(_e597) <= _e1182);
                }
                let _e1185 = phi_3104_;
                if _e1185 {
                    phi_5488_ = 4294967295u;
                    break;
                }
                switch bitcast<i32>(0u) {
                    default: {
                        let _e1191 = global.member_2;
                        let _e1193 = global.member_3;
                        let _e1194 = clamp((_e342.xy / vec2(_e341)), _e1191, _e1193);
                        let _e1197 = global.member[0u];
                        let _e1203 = (((_e355 - (_e357 * _e1194.x)) * (_e1197 / _e341)) * _e999);
                        let _e1206 = global.member[1u];
                        let _e1212 = (((_e356 - (_e357 * _e1194.y)) * (_e1206 / _e341)) * _e999);
                        let _e1214 = (dot(_e1203, _e1203) + 0.3f);
                        let _e1217 = (dot(_e1212, _e1212) + 0.3f);
                        let _e1219 = cross(_e1203, _e1212);
                        let _e1224 = (dot(_e1219, _e1219) + (0.3f * ((_e1214 + _e1217) - 0.3f)));
                        let _e1225 = (_e1224 > 0f);
                        phi_4861_ = _e1225;
                        if _e1225 {
                            phi_4861_ = (_e1214 <= 1000000000000000000f);
                        }
                        let _e1228 = phi_4861_;
                        phi_4867_ = _e1228;
                        if _e1228 {
                            phi_4867_ = (_e1217 <= 1000000000000000000f);
                        }
                        let _e1231 = phi_4867_;
                        if !(_e1231) {
                            let _e1234 = global_2.member_9;
                            if (_e1234 != 0u) {
                                let _e1238 = atomicAdd((&global_1.member[3u]), 1u);
                            }
                            phi_5487_ = 4294967295u;
                            break;
                        }
                        let _e1240 = global.member_49;
                        let _e1241 = (vec3<f32>(_e1214, dot(_e1203, _e1212), _e1217) * _e1240);
                        phi_5479_ = (1f - (f32(_e597) * 0.003921569f));
                        phi_5478_ = 0u;
                        loop {
                            let _e1248 = phi_5479_;
                            let _e1250 = phi_5478_;
                            local_4 = _e1248;
                            if (_e1250 < _e91) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                phi_5479_ = (_e1248 * _e1248);
                                phi_5478_ = (_e1250 + bitcast<u32>(1i));
                            }
                        }
                        let _e1256 = local_4;
                        let _e1260 = u32(round((255f * (1f - _e1256))));
                        let _e1263 = global.member_34;
                        let _e1266 = global.member_29;
                        let _e1274 = (sqrt(_e1241.xz) * sqrt((2f * log(max((max(f32(_e1260), _e1263) / _e1266), 1f)))));
                        let _e1277 = all(((_e587 + _e1274) > vec2<f32>(0f, 0f)));
                        phi_4905_ = _e1277;
                        if _e1277 {
                            let _e1280 = global.member_4;
                            phi_4905_ = all(((_e587 - _e1274) < _e1280));
                        }
                        let _e1284 = phi_4905_;
                        if !(_e1284) {
                            let _e1287 = global_2.member_9;
                            if (_e1287 != 0u) {
                                let _e1291 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_5487_ = 4294967295u;
                            break;
                        }
                        let _e1295 = (0.5f * (_e1241.x - _e1241.z));
                        let _e1300 = sqrt(((_e1295 * _e1295) + (_e1241.y * _e1241.y)));
                        let _e1303 = ((0.5f * (_e1241.x + _e1241.z)) + _e1300);
                        if (_e1295 >= 0f) {
                            phi_5485_ = vec2<f32>((_e1295 + _e1300), _e1241.y);
                        } else {
                            phi_5485_ = vec2<f32>(_e1241.y, (_e1300 - _e1295));
                        }
                        let _e1310 = phi_5485_;
                        let _e1311 = length(_e1310);
                        if (_e1311 > 0f) {
                            phi_5486_ = (_e1310 / vec2(_e1311));
                        } else {
                            phi_5486_ = vec2<f32>(1f, 0f);
                        }
                        let _e1316 = phi_5486_;
                        let _e1323 = global.member_5;
                        let _e1327 = global.member_10;
                        let _e1331 = vec2<u32>(clamp(round(((_e587 + vec2(_e1323)) * _e1327)), vec2<f32>(0f, 0f), vec2<f32>(1048575f, 1048575f)));
                        let _e1359 = global.member_45;
                        let _e1361 = (4u * (_e1359 + _e83));
                        global_4.member[_e1361] = ((_e1331.x | (_e1143.x << bitcast<u32>(20u))) | (_e1143.z << bitcast<u32>(30u)));
                        global_4.member[(_e1361 + 1u)] = (_e1331.y | (_e1143.y << bitcast<u32>(20u)));
                        global_4.member[(_e1361 + 2u)] = pack2x16float((_e1316 * min(sqrt(_e1303), 65504f)));
                        global_4.member[(_e1361 + 3u)] = ((pack2x16float(vec2<f32>(min(sqrt(((_e1224 * (_e1240 * _e1240)) / _e1303)), 65504f), 0f)) | (_e1260 << bitcast<u32>(16u))) | ((_e1143.z >> bitcast<u32>(2u)) << bitcast<u32>(24u)));
                        let _e1374 = global.member_9;
                        phi_5487_ = min(u32((_e585 * f32(_e1374))), _e1374);
                        break;
                    }
                }
                let _e1380 = phi_5487_;
                phi_5488_ = _e1380;
                break;
            }
        }
        let _e1382 = phi_5488_;
        phi_5489_ = _e1382;
    } else {
        phi_5489_ = 4294967295u;
    }
    let _e1384 = phi_5489_;
    switch bitcast<i32>(0u) {
        default: {
            let _e1387 = bitcast<u32>(param[0u]);
            let _e1389 = global.member_45;
            let _e1390 = (_e1389 + _e83);
            if (_e1384 != 4294967295u) {
                let _e1393 = global.member_41;
                let _e1397 = global.member_40;
                let _e1403 = atomicAdd((&global_1.member[((_e1397 + ((_e1390 / _e1393) * 256u)) + (_e1384 & 255u))]), 1u);
            }
            let _e1405 = global.member_39;
            if (_e1405 == 0u) {
                if (_e83 < (_e85 + (_e85 & 1u))) {
                    let _e1411 = global.member_28;
                    global_4.member[(_e1411 + _e1390)] = _e1384;
                }
                break;
            }
            global_5[_e1387] = _e1384;
            workgroupBarrier();
            let _e1417 = ((_e1387 & 1u) == 0u);
            if select(_e1417, _e86, _e1417) {
                let _e1420 = global.member_28;
                let _e1427 = global_5[(_e1387 + 1u)];
                global_4.member[(_e1420 + (_e1390 >> bitcast<u32>(1u)))] = ((_e1384 & 65535u) | (_e1427 << bitcast<u32>(16u)));
            }
            break;
        }
    }
    return;
}
