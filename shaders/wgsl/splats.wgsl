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
    var phi_4867_: u32;
    var phi_3074_: bool;
    var local: bool;
    var phi_3354_: bool;
    var phi_4869_: f32;
    var phi_4870_: f32;
    var phi_4874_: u32;
    var phi_4881_: f32;
    var phi_4880_: u32;
    var phi_4877_: u32;
    var local_1: f32;
    var phi_4886_: bool;
    var phi_3396_: bool;
    var phi_4897_: f32;
    var phi_4888_: vec2<f32>;
    var phi_4887_: bool;
    var phi_4907_: vec4<f32>;
    var phi_4908_: vec4<f32>;
    var phi_4909_: vec4<f32>;
    var phi_4927_: vec3<f32>;
    var phi_4929_: vec4<f32>;
    var phi_4928_: u32;
    var local_2: vec4<f32>;
    var phi_4944_: vec4<f32>;
    var phi_4932_: vec3<f32>;
    var phi_4931_: u32;
    var local_3: vec3<f32>;
    var phi_4948_: vec3<f32>;
    var phi_4941_: vec3<f32>;
    var phi_4940_: u32;
    var local_4: vec3<f32>;
    var phi_4950_: vec3<f32>;
    var phi_4409_: bool;
    var phi_4415_: bool;
    var phi_4440_: bool;
    var phi_4951_: vec2<f32>;
    var phi_4952_: vec2<f32>;
    var phi_4953_: u32;
    var phi_4954_: u32;
    var phi_4955_: u32;

    let _e71 = bitcast<u32>(param_1[0u]);
    let _e73 = global.member_14;
    let _e74 = (_e71 < _e73);
    if _e74 {
        switch bitcast<i32>(0u) {
            default: {
                let _e79 = (4u * (_e73 + (_e71 >> bitcast<u32>(5u))));
                let _e84 = global_7.member[(_e79 + 3u)][0u];
                phi_4867_ = (_e84 & 65535u);
                loop {
                    let _e87 = phi_4867_;
                    let _e96 = global.member_51[(_e87 >> bitcast<u32>(7u))][((_e87 >> bitcast<u32>(5u)) & 3u)];
                    let _e101 = (((_e96 >> bitcast<u32>((_e87 & 31u))) & 1u) != 0u);
                    let _e103 = (_e87 + bitcast<u32>(1i));
                    local = _e101;
                    continue;
                    continuing {
                        phi_3074_ = _e101;
                        if _e101 {
                            phi_3074_ = (_e103 <= (_e84 >> bitcast<u32>(16u)));
                        }
                        let _e108 = phi_3074_;
                        phi_4867_ = _e103;
                        break if !(_e108);
                    }
                }
                let _e111 = local;
                if _e111 {
                    let _e113 = global_2.member_9;
                    if (_e113 != 0u) {
                        let _e117 = atomicAdd((&global_1.member[0u]), 1u);
                    }
                    phi_4954_ = 4294967295u;
                    break;
                }
                let _e118 = (2u * _e71);
                let _e121 = global_7.member[_e118];
                let _e125 = global_7.member[(_e118 + 1u)];
                let _e130 = global_7.member[((2u * _e73) + _e71)];
                let _e141 = (vec2<f32>(f32(((_e130.y >> bitcast<u32>(16u)) & 31u)), f32(((_e130.y >> bitcast<u32>(21u)) & 31u))) * vec2<f32>(0.032258064f, 0.032258064f));
                let _e145 = ((1f + (2f * _e141.x)) * 0.33333334f);
                let _e146 = (1f - _e145);
                let _e150 = (_e146 * (0.5f + (0.5f * _e141.y)));
                let _e158 = global.member_11;
                let _e161 = global.member_12;
                let _e176 = global.member_21;
                let _e177 = (2u * _e176);
                let _e181 = global_3.member[(_e177 + (_e130.x & 65535u))];
                let _e183 = unpack2x16float(_e181.x);
                let _e195 = global_3.member[(_e177 + (_e130.x >> bitcast<u32>(16u)))];
                let _e197 = unpack2x16float(_e195.x);
                let _e209 = global_3.member[(_e177 + (_e130.y & 65535u))];
                let _e211 = unpack2x16float(_e209.x);
                let _e219 = ((((_e158.xyz + (_e161.xyz * vec3<f32>(f32((_e121.x & 65535u)), f32((_e121.x >> bitcast<u32>(16u))), f32((_e121.y & 65535u))))) + (vec3<f32>(_e183.x, _e183.y, unpack2x16float(_e181.y).x) * _e145)) + (vec3<f32>(_e197.x, _e197.y, unpack2x16float(_e195.y).x) * _e150)) + (vec3<f32>(_e211.x, _e211.y, unpack2x16float(_e209.y).x) * (_e146 - _e150)));
                let _e223 = vec4<f32>(_e219.x, _e219.y, _e219.z, 1f);
                let _e236 = (((_e121.y >> bitcast<u32>(16u)) | ((_e125.y >> bitcast<u32>(24u)) << bitcast<u32>(16u))) | ((_e130.y >> bitcast<u32>(26u)) << bitcast<u32>(24u)));
                let _e238 = global.member_36;
                let _e240 = global.member_37;
                let _e253 = (vec3(_e238) + (vec3<f32>(f32((_e236 & 1023u)), f32(((_e236 >> bitcast<u32>(10u)) & 1023u)), f32((_e236 >> bitcast<u32>(20u)))) * _e240));
                let _e262 = (vec4<u32>(_e125.x, (_e125.x >> bitcast<u32>(8u)), (_e125.x >> bitcast<u32>(16u)), (_e125.x >> bitcast<u32>(24u))) & vec4<u32>(255u, 255u, 255u, 255u));
                let _e268 = (vec3<u32>(_e125.y, (_e125.y >> bitcast<u32>(8u)), (_e125.y >> bitcast<u32>(16u))) & vec3<u32>(255u, 255u, 255u));
                let _e269 = vec3<f32>(_e268);
                let _e281 = (vec4<f32>(_e269.x, _e269.y, _e269.z, f32((((255u - _e268.x) - _e268.y) - _e268.z))) * vec4<f32>(0.003921569f, 0.003921569f, 0.003921569f, 0.003921569f));
                let _e283 = (3u * _e262.x);
                let _e287 = global.member_54[_e283];
                let _e292 = global.member_54[(_e283 + 1u)];
                let _e297 = global.member_54[(_e283 + 2u)];
                let _e300 = (3u * _e262.y);
                let _e304 = global.member_54[_e300];
                let _e310 = global.member_54[(_e300 + 1u)];
                let _e316 = global.member_54[(_e300 + 2u)];
                let _e320 = (3u * _e262.z);
                let _e324 = global.member_54[_e320];
                let _e330 = global.member_54[(_e320 + 1u)];
                let _e336 = global.member_54[(_e320 + 2u)];
                let _e340 = (3u * _e262.w);
                let _e344 = global.member_54[_e340];
                let _e346 = ((((_e287 * _e281.x) + (_e304 * _e281.y)) + (_e324 * _e281.z)) + (_e344 * _e281.w));
                let _e350 = global.member_54[(_e340 + 1u)];
                let _e352 = ((((_e292 * _e281.x) + (_e310 * _e281.y)) + (_e330 * _e281.z)) + (_e350 * _e281.w));
                let _e356 = global.member_54[(_e340 + 2u)];
                let _e358 = ((((_e297 * _e281.x) + (_e316 * _e281.y)) + (_e336 * _e281.z)) + (_e356 * _e281.w));
                let _e361 = dot(_e358, _e223);
                let _e362 = vec3<f32>(dot(_e346, _e223), dot(_e352, _e223), _e361);
                let _e363 = _e346.xyz;
                let _e364 = _e352.xyz;
                let _e365 = _e358.xyz;
                let _e377 = vec3<f32>(_e358.x, _e358.y, _e358.z);
                switch bitcast<i32>(0u) {
                    default: {
                        let _e395 = global.member_6;
                        if !((_e361 >= _e395)) {
                            let _e399 = global_2.member_9;
                            if (_e399 != 0u) {
                                let _e403 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_4897_ = 0f;
                            phi_4888_ = vec2<f32>(0f, 0f);
                            phi_4887_ = false;
                            break;
                        }
                        let _e405 = global.member;
                        let _e406 = _e362.xy;
                        let _e408 = vec2(_e361);
                        let _e411 = global.member_1;
                        let _e412 = (((_e405 * _e406) / _e408) + _e411);
                        let _e414 = global.member_5;
                        let _e418 = all((_e412 >= vec2(-(_e414))));
                        phi_3354_ = _e418;
                        if _e418 {
                            let _e420 = global.member_4;
                            phi_3354_ = all((_e412 <= (_e420 + vec2(_e414))));
                        }
                        let _e426 = phi_3354_;
                        if !(_e426) {
                            let _e429 = global_2.member_9;
                            if (_e429 != 0u) {
                                let _e433 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_4897_ = 0f;
                            phi_4888_ = _e412;
                            phi_4887_ = false;
                            break;
                        }
                        let _e435 = global.member_7;
                        let _e438 = global.member_8;
                        let _e439 = ((_e435 - _e361) * _e438);
                        if (_e439 < 0f) {
                            phi_4870_ = (0.015625f / (1f - _e439));
                        } else {
                            if (_e439 > 1f) {
                                phi_4869_ = (1f - (0.015625f / _e439));
                            } else {
                                phi_4869_ = (0.015625f + (0.96875f * clamp(_e439, 0f, 1f)));
                            }
                            let _e448 = phi_4869_;
                            phi_4870_ = _e448;
                        }
                        let _e452 = phi_4870_;
                        let _e453 = (_e406 / _e408);
                        let _e461 = global.member[0u];
                        let _e464 = global.member[1u];
                        let _e469 = global.member_31;
                        let _e470 = (_e469 > 0u);
                        phi_3396_ = _e470;
                        if _e470 {
                            let _e472 = global.member_34;
                            let _e475 = global.member_29;
                            switch bitcast<i32>(0u) {
                                default: {
                                    let _e485 = vec2((sqrt((2f * log(max((max(255f, _e472) / _e475), 1f)))) * ((((((1.2f * exp(min(max(max(_e253.x, _e253.y), _e253.z), 9f))) * sqrt(max(max(dot(_e363, _e363), dot(_e364, _e364)), dot(_e365, _e365)))) * length(vec3<f32>(_e453.x, _e453.y, 1f))) * max(_e461, _e464)) / _e361) + 0.5477226f)));
                                    let _e488 = global.member_32;
                                    let _e491 = global.member_33;
                                    let _e495 = vec2<u32>(clamp(((((_e412 - _e485) - _e488) * _e491) - vec2<f32>(0.5f, 0.5f)), vec2<f32>(0f, 0f), vec2<f32>(191f, 191f)));
                                    let _e501 = vec2<u32>(clamp(((((_e412 + _e485) - _e488) * _e491) + vec2<f32>(0.5f, 0.5f)), vec2<f32>(0f, 0f), vec2<f32>(191f, 191f)));
                                    let _e508 = max((_e501.x - _e495.x), (_e501.y - _e495.y));
                                    if (_e508 <= 3u) {
                                        phi_4874_ = 0u;
                                    } else {
                                        phi_4874_ = (bitcast<u32>(firstLeadingBit((_e508 - 1u))) - 1u);
                                    }
                                    let _e515 = phi_4874_;
                                    if !((_e515 < 4u)) {
                                        phi_4886_ = false;
                                        break;
                                    }
                                    let _e525 = vec2(_e515);
                                    let _e527 = (_e495 >> bitcast<vec2<u32>>(_e525));
                                    let _e529 = (_e501 >> bitcast<vec2<u32>>(_e525));
                                    let _e531 = (_e527.x & 4294967292u);
                                    phi_4881_ = 0f;
                                    phi_4880_ = _e527.y;
                                    phi_4877_ = _e531;
                                    loop {
                                        let _e534 = phi_4881_;
                                        let _e536 = phi_4880_;
                                        let _e538 = phi_4877_;
                                        let _e541 = (vec4(f32(_e538)) + vec4<f32>(0f, 1f, 2f, 3f));
                                        let _e559 = global_3.member[((_e469 >> bitcast<u32>(1u)) + ((((4u * (12288u - (12288u >> bitcast<u32>((2u * _e515))))) + (_e536 * (192u >> bitcast<u32>(_e515)))) + _e538) >> bitcast<u32>(2u)))];
                                        let _e561 = unpack2x16unorm(_e559.x);
                                        let _e563 = unpack2x16unorm(_e559.y);
                                        let _e570 = select(select(vec4<f32>(_e561.x, _e561.y, _e563.x, _e563.y), vec4<f32>(0f, 0f, 0f, 0f), (_e541 < vec4(f32(_e527.x)))), vec4<f32>(0f, 0f, 0f, 0f), (_e541 > vec4(f32(_e529.x))));
                                        let _e578 = max(_e534, max(max(_e570.x, _e570.y), max(_e570.z, _e570.w)));
                                        let _e579 = (_e538 + 4u);
                                        let _e580 = (_e579 > _e529.x);
                                        let _e583 = (_e536 + select(0u, 1u, _e580));
                                        phi_4881_ = _e578;
                                        phi_4880_ = _e583;
                                        phi_4877_ = select(_e579, _e531, _e580);
                                        local_1 = _e578;
                                        if (_e583 <= _e529.y) {
                                            continue;
                                        } else {
                                            break;
                                        }
                                    }
                                    let _e587 = local_1;
                                    phi_4886_ = ((1f - _e452) > _e587);
                                    break;
                                }
                            }
                            let _e590 = phi_4886_;
                            phi_3396_ = _e590;
                        }
                        let _e592 = phi_3396_;
                        if _e592 {
                            let _e594 = global_2.member_9;
                            if (_e594 != 0u) {
                                let _e598 = atomicAdd((&global_1.member[1u]), 1u);
                            }
                            phi_4897_ = _e452;
                            phi_4888_ = _e412;
                            phi_4887_ = false;
                            break;
                        }
                        phi_4897_ = _e452;
                        phi_4888_ = _e412;
                        phi_4887_ = true;
                        break;
                    }
                }
                let _e600 = phi_4897_;
                let _e602 = phi_4888_;
                let _e604 = phi_4887_;
                if (true && !(_e604)) {
                    phi_4954_ = 4294967295u;
                    break;
                }
                let _e611 = global_7.member[((3u * _e73) + _e71)];
                let _e614 = (_e611.y >> bitcast<u32>(24u));
                let _e615 = f32(_e614);
                let _e617 = global.member_29;
                if (_e615 <= _e617) {
                    let _e620 = global_2.member_9;
                    if (_e620 != 0u) {
                        let _e624 = atomicAdd((&global_1.member[2u]), 1u);
                    }
                    phi_4954_ = 4294967295u;
                    break;
                }
                let _e638 = ((vec3<f32>(f32((_e611.x & 1023u)), f32(((_e611.x >> bitcast<u32>(10u)) & 1023u)), f32(((_e611.x >> bitcast<u32>(20u)) & 1023u))) - vec3<f32>(512f, 512f, 512f)) * vec3<f32>(0.0013888889f, 0.0013888889f, 0.0013888889f));
                let _e642 = sqrt(max((1f - dot(_e638, _e638)), 0f));
                let _e644 = (_e611.x >> bitcast<u32>(30u));
                if (_e644 == 0u) {
                    phi_4909_ = vec4<f32>(_e642, _e638.x, _e638.y, _e638.z);
                } else {
                    if (_e644 == 1u) {
                        phi_4908_ = vec4<f32>(_e638.x, _e642, _e638.y, _e638.z);
                    } else {
                        if (_e644 == 2u) {
                            phi_4907_ = vec4<f32>(_e638.x, _e638.y, _e642, _e638.z);
                        } else {
                            phi_4907_ = vec4<f32>(_e638.x, _e638.y, _e638.z, _e642);
                        }
                        let _e657 = phi_4907_;
                        phi_4908_ = _e657;
                    }
                    let _e663 = phi_4908_;
                    phi_4909_ = _e663;
                }
                let _e669 = phi_4909_;
                let _e673 = global.member_38;
                let _e674 = (_e673 > 0u);
                phi_4927_ = unpack4x8unorm(_e611.y).xyz;
                if _e674 {
                    let _e678 = global_7.member[(_e673 + _e71)];
                    let _e680 = unpack2x16float(_e678.x);
                    phi_4927_ = vec3<f32>(_e680.x, _e680.y, unpack2x16float(_e678.y).x);
                }
                let _e688 = phi_4927_;
                let _e691 = (1u << bitcast<u32>((_e71 & 31u)));
                let _e694 = global_7.member[_e79];
                let _e698 = global_7.member[(_e79 + 1u)];
                let _e702 = global_7.member[(_e79 + 2u)];
                phi_4944_ = _e669;
                if ((_e694.x & _e691) != 0u) {
                    let _e707 = global.member_22;
                    let _e715 = global.member_18;
                    let _e719 = (_e707 + ((_e698.y + bitcast<u32>(countOneBits((_e694.x & (_e691 - 1u))))) * (1u + (4u * _e715))));
                    let _e720 = (_e719 + 1u);
                    let _e723 = global_6.member[_e719];
                    let _e725 = global.member_44;
                    let _e729 = global.member_19;
                    phi_4929_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_4928_ = 0u;
                    loop {
                        let _e733 = phi_4929_;
                        let _e735 = phi_4928_;
                        let _e737 = (2u * ((_e725 + ((_e723 >> bitcast<u32>(16u)) * _e729)) + _e735));
                        let _e740 = global_3.member[_e737];
                        let _e744 = global_3.member[(_e737 + 1u)];
                        let _e750 = bitcast<vec4<f32>>(vec4<u32>(_e740.x, _e740.y, _e744.x, _e744.y));
                        let _e754 = global_6.member[(_e720 + _e735)];
                        let _e761 = global_6.member[((_e720 + _e715) + _e735)];
                        let _e769 = global_6.member[((_e720 + (2u * _e715)) + _e735)];
                        let _e777 = global_6.member[((_e720 + (3u * _e715)) + _e735)];
                        let _e781 = (_e733 + vec4<f32>(dot(unpack4x8snorm(_e754), _e750), dot(unpack4x8snorm(_e761), _e750), dot(unpack4x8snorm(_e769), _e750), dot(unpack4x8snorm(_e777), _e750)));
                        let _e783 = (_e735 + bitcast<u32>(1i));
                        phi_4929_ = _e781;
                        phi_4928_ = _e783;
                        local_2 = _e781;
                        if (_e783 < _e715) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e789 = local_2;
                    let _e791 = (_e669 + (_e789 * (127f * unpack2x16float(_e723).x)));
                    phi_4944_ = select(_e669, _e791, vec4((length(_e791) >= 0.001f)));
                }
                let _e797 = phi_4944_;
                phi_4948_ = _e253;
                if ((_e694.y & _e691) != 0u) {
                    let _e802 = global.member_23;
                    let _e810 = global.member_18;
                    let _e814 = (_e802 + ((_e702.x + bitcast<u32>(countOneBits((_e694.y & (_e691 - 1u))))) * (1u + (3u * _e810))));
                    let _e815 = (_e814 + 1u);
                    let _e818 = global_6.member[_e814];
                    let _e820 = global.member_44;
                    let _e824 = global.member_19;
                    phi_4932_ = vec3<f32>(0f, 0f, 0f);
                    phi_4931_ = 0u;
                    loop {
                        let _e828 = phi_4932_;
                        let _e830 = phi_4931_;
                        let _e832 = (2u * ((_e820 + ((_e818 >> bitcast<u32>(16u)) * _e824)) + _e830));
                        let _e835 = global_3.member[_e832];
                        let _e839 = global_3.member[(_e832 + 1u)];
                        let _e845 = bitcast<vec4<f32>>(vec4<u32>(_e835.x, _e835.y, _e839.x, _e839.y));
                        let _e849 = global_6.member[(_e815 + _e830)];
                        let _e856 = global_6.member[((_e815 + _e810) + _e830)];
                        let _e864 = global_6.member[((_e815 + (2u * _e810)) + _e830)];
                        let _e868 = (_e828 + vec3<f32>(dot(unpack4x8snorm(_e849), _e845), dot(unpack4x8snorm(_e856), _e845), dot(unpack4x8snorm(_e864), _e845)));
                        let _e870 = (_e830 + bitcast<u32>(1i));
                        phi_4932_ = _e868;
                        phi_4931_ = _e870;
                        local_3 = _e868;
                        if (_e870 < _e810) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e876 = local_3;
                    phi_4948_ = (_e253 + (_e876 * (127f * unpack2x16float(_e818).x)));
                }
                let _e880 = phi_4948_;
                phi_4950_ = _e688;
                if ((_e698.x & _e691) != 0u) {
                    let _e885 = global.member_24;
                    let _e893 = global.member_18;
                    let _e897 = (_e885 + ((_e702.y + bitcast<u32>(countOneBits((_e698.x & (_e691 - 1u))))) * (3u + (3u * _e893))));
                    let _e901 = global_6.member[(_e897 + 1u)];
                    let _e902 = unpack2x16float(_e901);
                    let _e906 = global_6.member[(_e897 + 2u)];
                    let _e914 = (_e897 + 3u);
                    let _e917 = global_6.member[_e897];
                    let _e919 = global.member_44;
                    let _e923 = global.member_19;
                    phi_4941_ = vec3<f32>(0f, 0f, 0f);
                    phi_4940_ = 0u;
                    loop {
                        let _e927 = phi_4941_;
                        let _e929 = phi_4940_;
                        let _e931 = (2u * ((_e919 + ((_e917 >> bitcast<u32>(16u)) * _e923)) + _e929));
                        let _e934 = global_3.member[_e931];
                        let _e938 = global_3.member[(_e931 + 1u)];
                        let _e944 = bitcast<vec4<f32>>(vec4<u32>(_e934.x, _e934.y, _e938.x, _e938.y));
                        let _e948 = global_6.member[(_e914 + _e929)];
                        let _e955 = global_6.member[((_e914 + _e893) + _e929)];
                        let _e963 = global_6.member[((_e914 + (2u * _e893)) + _e929)];
                        let _e967 = (_e927 + vec3<f32>(dot(unpack4x8snorm(_e948), _e944), dot(unpack4x8snorm(_e955), _e944), dot(unpack4x8snorm(_e963), _e944)));
                        let _e969 = (_e929 + bitcast<u32>(1i));
                        phi_4941_ = _e967;
                        phi_4940_ = _e969;
                        local_4 = _e967;
                        if (_e969 < _e893) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e975 = local_4;
                    phi_4950_ = (select(vec3<f32>(_e902.x, _e902.y, unpack2x16float(_e906).x), _e688, vec3(_e674)) + (_e975 * (127f * unpack2x16float(_e917).x)));
                }
                let _e979 = phi_4950_;
                let _e980 = normalize(_e797);
                let _e985 = (_e980.z * _e980.z);
                let _e986 = (_e980.w * _e980.w);
                let _e990 = (_e980.y * _e980.z);
                let _e991 = (_e980.x * _e980.w);
                let _e994 = (_e980.y * _e980.w);
                let _e995 = (_e980.x * _e980.z);
                let _e1000 = (_e980.y * _e980.y);
                let _e1004 = (_e980.z * _e980.w);
                let _e1005 = (_e980.x * _e980.y);
                let _e1019 = exp(min(_e880, vec3<f32>(9f, 9f, 9f)));
                let _e1026 = mat3x3<f32>((vec3<f32>((1f - (2f * (_e985 + _e986))), (2f * (_e990 + _e991)), (2f * (_e994 - _e995))) * _e1019.x), (vec3<f32>((2f * (_e990 - _e991)), (1f - (2f * (_e1000 + _e986))), (2f * (_e1004 + _e1005))) * _e1019.y), (vec3<f32>((2f * (_e994 + _e995)), (2f * (_e1004 - _e1005)), (1f - (2f * (_e1000 + _e985)))) * _e1019.z));
                switch bitcast<i32>(0u) {
                    default: {
                        let _e1032 = global.member_2;
                        let _e1034 = global.member_3;
                        let _e1035 = clamp((_e362.xy / vec2(_e361)), _e1032, _e1034);
                        let _e1038 = global.member[0u];
                        let _e1044 = (((vec3<f32>(_e346.x, _e346.y, _e346.z) - (_e377 * _e1035.x)) * (_e1038 / _e361)) * _e1026);
                        let _e1047 = global.member[1u];
                        let _e1053 = (((vec3<f32>(_e352.x, _e352.y, _e352.z) - (_e377 * _e1035.y)) * (_e1047 / _e361)) * _e1026);
                        let _e1055 = (dot(_e1044, _e1044) + 0.3f);
                        let _e1056 = dot(_e1044, _e1053);
                        let _e1058 = (dot(_e1053, _e1053) + 0.3f);
                        let _e1060 = cross(_e1044, _e1053);
                        let _e1062 = (_e1055 + _e1058);
                        let _e1065 = (dot(_e1060, _e1060) + (0.3f * (_e1062 - 0.3f)));
                        let _e1066 = (_e1065 > 0f);
                        phi_4409_ = _e1066;
                        if _e1066 {
                            phi_4409_ = (_e1055 <= 1000000000000000000f);
                        }
                        let _e1069 = phi_4409_;
                        phi_4415_ = _e1069;
                        if _e1069 {
                            phi_4415_ = (_e1058 <= 1000000000000000000f);
                        }
                        let _e1072 = phi_4415_;
                        if !(_e1072) {
                            let _e1075 = global_2.member_9;
                            if (_e1075 != 0u) {
                                let _e1079 = atomicAdd((&global_1.member[3u]), 1u);
                            }
                            phi_4953_ = 4294967295u;
                            break;
                        }
                        let _e1081 = global.member_34;
                        let _e1090 = (sqrt(vec3<f32>(_e1055, _e1056, _e1058).xz) * sqrt((2f * log(max((max(_e615, _e1081) / _e617), 1f)))));
                        let _e1093 = all(((_e602 + _e1090) > vec2<f32>(0f, 0f)));
                        phi_4440_ = _e1093;
                        if _e1093 {
                            let _e1096 = global.member_4;
                            phi_4440_ = all(((_e602 - _e1090) < _e1096));
                        }
                        let _e1100 = phi_4440_;
                        if !(_e1100) {
                            let _e1103 = global_2.member_9;
                            if (_e1103 != 0u) {
                                let _e1107 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_4953_ = 4294967295u;
                            break;
                        }
                        let _e1110 = (0.5f * (_e1055 - _e1058));
                        let _e1114 = sqrt(((_e1110 * _e1110) + (_e1056 * _e1056)));
                        let _e1116 = ((0.5f * _e1062) + _e1114);
                        if (_e1110 >= 0f) {
                            phi_4951_ = vec2<f32>((_e1110 + _e1114), _e1056);
                        } else {
                            phi_4951_ = vec2<f32>(_e1056, (_e1114 - _e1110));
                        }
                        let _e1123 = phi_4951_;
                        let _e1124 = length(_e1123);
                        if (_e1124 > 0f) {
                            phi_4952_ = (_e1123 / vec2(_e1124));
                        } else {
                            phi_4952_ = vec2<f32>(1f, 0f);
                        }
                        let _e1129 = phi_4952_;
                        let _e1136 = global.member_5;
                        let _e1140 = global.member_10;
                        let _e1144 = vec2<u32>(clamp(round(((_e602 + vec2(_e1136)) * _e1140)), vec2<f32>(0f, 0f), vec2<f32>(1048575f, 1048575f)));
                        let _e1147 = vec3<u32>(round((clamp(_e979, vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 1023f)));
                        let _e1175 = global.member_45;
                        let _e1177 = (4u * (_e1175 + _e71));
                        global_4.member[_e1177] = ((_e1144.x | (_e1147.x << bitcast<u32>(20u))) | (_e1147.z << bitcast<u32>(30u)));
                        global_4.member[(_e1177 + 1u)] = (_e1144.y | (_e1147.y << bitcast<u32>(20u)));
                        global_4.member[(_e1177 + 2u)] = pack2x16float((_e1129 * min(sqrt(_e1116), 65504f)));
                        global_4.member[(_e1177 + 3u)] = ((pack2x16float(vec2<f32>(min(sqrt((_e1065 / _e1116)), 65504f), 0f)) | (_e614 << bitcast<u32>(16u))) | ((_e1147.z >> bitcast<u32>(2u)) << bitcast<u32>(24u)));
                        let _e1190 = global.member_9;
                        phi_4953_ = min(u32((_e600 * f32(_e1190))), _e1190);
                        break;
                    }
                }
                let _e1196 = phi_4953_;
                phi_4954_ = _e1196;
                break;
            }
        }
        let _e1198 = phi_4954_;
        phi_4955_ = _e1198;
    } else {
        phi_4955_ = 4294967295u;
    }
    let _e1200 = phi_4955_;
    switch bitcast<i32>(0u) {
        default: {
            let _e1203 = bitcast<u32>(param[0u]);
            let _e1205 = global.member_45;
            let _e1206 = (_e1205 + _e71);
            if (_e1200 != 4294967295u) {
                let _e1209 = global.member_40;
                let _e1211 = global.member_41;
                let _e1219 = atomicAdd((&global_1.member[((_e1209 + ((_e1206 / _e1211) * 256u)) + (_e1200 & 255u))]), 1u);
            }
            let _e1221 = global.member_39;
            if (_e1221 == 0u) {
                if (_e71 < (_e73 + (_e73 & 1u))) {
                    let _e1227 = global.member_28;
                    global_4.member[(_e1227 + _e1206)] = _e1200;
                }
                break;
            }
            global_5[_e1203] = _e1200;
            workgroupBarrier();
            let _e1233 = ((_e1203 & 1u) == 0u);
            if select(_e1233, _e74, _e1233) {
                let _e1236 = global.member_28;
                let _e1243 = global_5[(_e1203 + 1u)];
                global_4.member[(_e1236 + (_e1206 >> bitcast<u32>(1u)))] = ((_e1200 & 65535u) | (_e1243 << bitcast<u32>(16u)));
            }
            break;
        }
    }
    return;
}
