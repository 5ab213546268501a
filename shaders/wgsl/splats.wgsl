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
    var phi_4916_: u32;
    var phi_4920_: bool;
    var phi_4917_: bool;
    var phi_4919_: bool;
    var phi_4926_: vec4<f32>;
    var phi_4925_: vec4<f32>;
    var phi_4924_: vec4<f32>;
    var phi_4923_: u32;
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
    var phi_3118_: bool;
    var phi_4928_: f32;
    var phi_4929_: f32;
    var phi_4933_: u32;
    var phi_4938_: f32;
    var phi_4936_: u32;
    var phi_4943_: f32;
    var phi_4940_: u32;
    var local_21: f32;
    var phi_4944_: bool;
    var phi_3160_: bool;
    var phi_4955_: f32;
    var phi_4946_: vec2<f32>;
    var phi_4945_: bool;
    var phi_4965_: vec4<f32>;
    var phi_4966_: vec4<f32>;
    var phi_4967_: vec4<f32>;
    var phi_4985_: vec3<f32>;
    var phi_4987_: f32;
    var phi_4986_: u32;
    var phi_4989_: f32;
    var phi_4988_: u32;
    var phi_4991_: f32;
    var phi_4990_: u32;
    var local_22: f32;
    var local_23: f32;
    var local_24: f32;
    var phi_4993_: f32;
    var phi_4992_: u32;
    var local_25: f32;
    var phi_5029_: vec4<f32>;
    var phi_4999_: f32;
    var phi_4998_: u32;
    var phi_5001_: f32;
    var phi_5000_: u32;
    var phi_5003_: f32;
    var phi_5002_: u32;
    var local_26: f32;
    var local_27: f32;
    var local_28: f32;
    var phi_5037_: vec3<f32>;
    var phi_5022_: f32;
    var phi_5021_: u32;
    var phi_5024_: f32;
    var phi_5023_: u32;
    var phi_5026_: f32;
    var phi_5025_: u32;
    var local_29: f32;
    var local_30: f32;
    var local_31: f32;
    var phi_5041_: vec3<f32>;
    var phi_4491_: bool;
    var phi_4497_: bool;
    var phi_4522_: bool;
    var phi_5042_: vec2<f32>;
    var phi_5043_: vec2<f32>;
    var phi_5044_: u32;
    var phi_5045_: u32;
    var phi_5046_: u32;
    var phi_5047_: u32;
    var local_32: f32;

    let _e75 = bitcast<u32>(param_1[0u]);
    let _e77 = global.member_14;
    let _e78 = (_e75 < _e77);
    if _e78 {
        switch bitcast<i32>(0u) {
            default: {
                let _e82 = (4u * (_e77 + (_e75 / 32u)));
                switch bitcast<i32>(0u) {
                    default: {
                        let _e88 = global_7.member[(_e82 + 3u)][0u];
                        phi_4916_ = (_e88 & 65535u);
                        loop {
                            let _e91 = phi_4916_;
                            phi_4920_ = bool();
                            phi_4917_ = false;
                            if (_e91 <= (_e88 >> bitcast<u32>(16u))) {
                                let _e101 = global.member_51[(_e91 / 128u)][((_e91 / 32u) & 3u)];
                                if (((_e101 >> bitcast<u32>((_e91 & 31u))) & 1u) == 0u) {
                                    phi_4920_ = false;
                                    phi_4917_ = true;
                                    break;
                                }
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                phi_4916_ = (_e91 + bitcast<u32>(1i));
                            }
                        }
                        let _e110 = phi_4920_;
                        let _e112 = phi_4917_;
                        phi_4919_ = _e110;
                        if _e112 {
                            break;
                        }
                        phi_4919_ = true;
                        break;
                    }
                }
                let _e114 = phi_4919_;
                if _e114 {
                    let _e116 = global_2.member_9;
                    if (_e116 != 0u) {
                        let _e120 = atomicAdd((&global_1.member[0u]), 1u);
                    }
                    phi_5046_ = 4294967295u;
                    break;
                }
                let _e121 = (2u * _e75);
                let _e124 = global_7.member[_e121];
                let _e128 = global_7.member[(_e121 + 1u)];
                let _e133 = global_7.member[((2u * _e77) + _e75)];
                let _e144 = (vec2<f32>(f32(((_e133.y >> bitcast<u32>(16u)) & 31u)), f32(((_e133.y >> bitcast<u32>(21u)) & 31u))) * vec2<f32>(0.032258064f, 0.032258064f));
                let _e148 = ((1f + (2f * _e144.x)) * 0.33333334f);
                let _e149 = (1f - _e148);
                let _e153 = (_e149 * (0.5f + (0.5f * _e144.y)));
                let _e161 = global.member_11;
                let _e164 = global.member_12;
                let _e179 = global.member_21;
                let _e180 = (2u * _e179);
                let _e184 = global_3.member[(_e180 + (_e133.x & 65535u))];
                let _e186 = unpack2x16float(_e184.x);
                let _e198 = global_3.member[(_e180 + (_e133.x >> bitcast<u32>(16u)))];
                let _e200 = unpack2x16float(_e198.x);
                let _e212 = global_3.member[(_e180 + (_e133.y & 65535u))];
                let _e214 = unpack2x16float(_e212.x);
                let _e222 = ((((_e161.xyz + (_e164.xyz * vec3<f32>(f32((_e124.x & 65535u)), f32((_e124.x >> bitcast<u32>(16u))), f32((_e124.y & 65535u))))) + (vec3<f32>(_e186.x, _e186.y, unpack2x16float(_e184.y).x) * _e148)) + (vec3<f32>(_e200.x, _e200.y, unpack2x16float(_e198.y).x) * _e153)) + (vec3<f32>(_e214.x, _e214.y, unpack2x16float(_e212.y).x) * (_e149 - _e153)));
                let _e226 = vec4<f32>(_e222.x, _e222.y, _e222.z, 1f);
                let _e239 = (((_e124.y >> bitcast<u32>(16u)) | ((_e128.y >> bitcast<u32>(24u)) << bitcast<u32>(16u))) | ((_e133.y >> bitcast<u32>(26u)) << bitcast<u32>(24u)));
                let _e241 = global.member_36;
                let _e243 = global.member_37;
                let _e256 = (vec3(_e241) + (vec3<f32>(f32((_e239 & 1023u)), f32(((_e239 >> bitcast<u32>(10u)) & 1023u)), f32((_e239 >> bitcast<u32>(20u)))) * _e243));
                local_1 = (vec4<u32>(_e128.x, (_e128.x >> bitcast<u32>(8u)), (_e128.x >> bitcast<u32>(16u)), (_e128.x >> bitcast<u32>(24u))) & vec4<u32>(255u, 255u, 255u, 255u));
                let _e271 = (vec3<u32>(_e128.y, (_e128.y >> bitcast<u32>(8u)), (_e128.y >> bitcast<u32>(16u))) & vec3<u32>(255u, 255u, 255u));
                let _e272 = vec3<f32>(_e271);
                local_2 = (vec4<f32>(_e272.x, _e272.y, _e272.z, f32((((255u - _e271.x) - _e271.y) - _e271.z))) * vec4<f32>(0.003921569f, 0.003921569f, 0.003921569f, 0.003921569f));
                phi_4926_ = vec4<f32>(0f, 0f, 0f, 0f);
                phi_4925_ = vec4<f32>(0f, 0f, 0f, 0f);
                phi_4924_ = vec4<f32>(0f, 0f, 0f, 0f);
                phi_4923_ = 0u;
                loop {
                    let _e286 = phi_4926_;
                    let _e288 = phi_4925_;
                    let _e290 = phi_4924_;
                    let _e292 = phi_4923_;
                    local_3 = _e290;
                    local_4 = _e288;
                    local_5 = _e286;
                    local_6 = _e290;
                    local_7 = _e290;
                    local_8 = _e288;
                    local_9 = _e288;
                    local_10 = _e286;
                    local_11 = _e286;
                    local_12 = _e290;
                    local_13 = _e290;
                    local_14 = _e290;
                    local_15 = _e288;
                    local_16 = _e288;
                    local_17 = _e288;
                    local_18 = _e286;
                    local_19 = _e286;
                    local_20 = _e286;
                    if (_e292 < 4u) {
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e295 = local_1[_e292];
                        let _e296 = (3u * _e295);
                        let _e298 = local_2[_e292];
                        let _e301 = global.member_54[_e296];
                        let _e304 = local_2[_e292];
                        let _e308 = global.member_54[(_e296 + 1u)];
                        let _e311 = local_2[_e292];
                        let _e315 = global.member_54[(_e296 + 2u)];
                        phi_4926_ = (_e286 + (_e315 * _e311));
                        phi_4925_ = (_e288 + (_e308 * _e304));
                        phi_4924_ = (_e290 + (_e301 * _e298));
                        phi_4923_ = (_e292 + bitcast<u32>(1i));
                    }
                }
                let _e321 = local_3;
                let _e324 = local_4;
                let _e327 = local_5;
                let _e328 = dot(_e327, _e226);
                let _e329 = vec3<f32>(dot(_e321, _e226), dot(_e324, _e226), _e328);
                let _e331 = local_6;
                let _e332 = _e331.xyz;
                let _e334 = local_8;
                let _e335 = _e334.xyz;
                let _e337 = local_10;
                let _e338 = _e337.xyz;
                let _e340 = local_12;
                let _e343 = local_13;
                let _e346 = local_14;
                let _e349 = local_15;
                let _e352 = local_16;
                let _e355 = local_17;
                let _e358 = local_18;
                let _e361 = local_19;
                let _e364 = local_20;
                let _e368 = vec3<f32>(_e358.x, _e361.y, _e364.z);
                switch bitcast<i32>(0u) {
                    default: {
                        let _e386 = global.member_6;
                        if !((_e328 >= _e386)) {
                            let _e390 = global_2.member_9;
                            if (_e390 != 0u) {
                                let _e394 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_4955_ = 0f;
                            phi_4946_ = vec2<f32>(0f, 0f);
                            phi_4945_ = false;
                            break;
                        }
                        let _e396 = global.member;
                        let _e397 = _e329.xy;
                        let _e399 = vec2(_e328);
                        let _e402 = global.member_1;
                        let _e403 = (((_e396 * _e397) / _e399) + _e402);
                        let _e405 = global.member_5;
                        let _e409 = all((_e403 >= vec2(-(_e405))));
                        phi_3118_ = _e409;
                        if _e409 {
                            let _e411 = global.member_4;
                            phi_3118_ = all((_e403 <= (_e411 + vec2(_e405))));
                        }
                        let _e417 = phi_3118_;
                        if !(_e417) {
                            let _e420 = global_2.member_9;
                            if (_e420 != 0u) {
                                let _e424 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_4955_ = 0f;
                            phi_4946_ = _e403;
                            phi_4945_ = false;
                            break;
                        }
                        let _e426 = global.member_7;
                        let _e429 = global.member_8;
                        let _e430 = ((_e426 - _e328) * _e429);
                        if (_e430 < 0f) {
                            phi_4929_ = (0.015625f / (1f - _e430));
                        } else {
                            if (_e430 > 1f) {
                                phi_4928_ = (1f - (0.015625f / _e430));
                            } else {
                                phi_4928_ = (0.015625f + (0.96875f * clamp(_e430, 0f, 1f)));
                            }
                            let _e439 = phi_4928_;
                            phi_4929_ = _e439;
                        }
                        let _e443 = phi_4929_;
                        let _e444 = (_e397 / _e399);
                        let _e452 = global.member[0u];
                        let _e455 = global.member[1u];
                        let _e460 = global.member_31;
                        let _e461 = (_e460 > 0u);
                        phi_3160_ = _e461;
                        if _e461 {
                            let _e463 = global.member_34;
                            let _e466 = global.member_29;
                            switch bitcast<i32>(0u) {
                                default: {
                                    let _e476 = vec2((sqrt((2f * log(max((max(255f, _e463) / _e466), 1f)))) * ((((((1.2f * exp(min(max(max(_e256.x, _e256.y), _e256.z), 9f))) * sqrt(max(max(dot(_e332, _e332), dot(_e335, _e335)), dot(_e338, _e338)))) * length(vec3<f32>(_e444.x, _e444.y, 1f))) * max(_e452, _e455)) / _e328) + 0.5477226f)));
                                    let _e479 = global.member_32;
                                    let _e482 = global.member_33;
                                    let _e486 = vec2<u32>(clamp(((((_e403 - _e476) - _e479) * _e482) - vec2<f32>(0.5f, 0.5f)), vec2<f32>(0f, 0f), vec2<f32>(191f, 191f)));
                                    let _e492 = vec2<u32>(clamp(((((_e403 + _e476) - _e479) * _e482) + vec2<f32>(0.5f, 0.5f)), vec2<f32>(0f, 0f), vec2<f32>(191f, 191f)));
                                    let _e499 = max((_e492.x - _e486.x), (_e492.y - _e486.y));
                                    if (_e499 <= 3u) {
                                        phi_4933_ = 0u;
                                    } else {
                                        phi_4933_ = (bitcast<u32>(firstLeadingBit((_e499 - 1u))) - 1u);
                                    }
                                    let _e506 = phi_4933_;
                                    if !((_e506 < 4u)) {
                                        phi_4944_ = false;
                                        break;
                                    }
                                    let _e515 = vec2(_e506);
                                    let _e517 = (_e486 >> bitcast<vec2<u32>>(_e515));
                                    let _e519 = (_e492 >> bitcast<vec2<u32>>(_e515));
                                    phi_4938_ = 0f;
                                    phi_4936_ = _e517.y;
                                    loop {
                                        let _e522 = phi_4938_;
                                        let _e524 = phi_4936_;
                                        local_21 = _e522;
                                        if (_e524 <= _e519.y) {
                                            phi_4943_ = _e522;
                                            phi_4940_ = _e517.x;
                                            loop {
                                                let _e529 = phi_4943_;
                                                let _e531 = phi_4940_;
                                                local_32 = _e529;
                                                if (_e531 <= _e519.x) {
                                                    continue;
                                                } else {
                                                    break;
                                                }
                                                continuing {
                                                    let _e538 = (((49152u - (((36864u >> bitcast<u32>((2u * _e506))) / 3u) * 4u)) + (_e524 * (192u >> bitcast<u32>(_e506)))) + _e531);
                                                    let _e540 = (_e460 + (_e538 / 2u));
                                                    let _e546 = global_3.member[(_e540 / 2u)][(_e540 & 1u)];
                                                    phi_4943_ = max(_e529, (f32(((_e546 >> bitcast<u32>((16u * (_e538 & 1u)))) & 65535u)) * 0.000015259022f));
                                                    phi_4940_ = (_e531 + bitcast<u32>(1i));
                                                }
                                            }
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e1433 = local_32;
                                            phi_4938_ = _e1433;
                                            phi_4936_ = (_e524 + bitcast<u32>(1i));
                                        }
                                    }
                                    let _e560 = local_21;
                                    phi_4944_ = ((1f - _e443) > _e560);
                                    break;
                                }
                            }
                            let _e563 = phi_4944_;
                            phi_3160_ = _e563;
                        }
                        let _e565 = phi_3160_;
                        if _e565 {
                            let _e567 = global_2.member_9;
                            if (_e567 != 0u) {
                                let _e571 = atomicAdd((&global_1.member[1u]), 1u);
                            }
                            phi_4955_ = _e443;
                            phi_4946_ = _e403;
                            phi_4945_ = false;
                            break;
                        }
                        phi_4955_ = _e443;
                        phi_4946_ = _e403;
                        phi_4945_ = true;
                        break;
                    }
                }
                let _e573 = phi_4955_;
                let _e575 = phi_4946_;
                let _e577 = phi_4945_;
                if (true && !(_e577)) {
                    phi_5046_ = 4294967295u;
                    break;
                }
                let _e584 = global_7.member[((3u * _e77) + _e75)];
                let _e587 = (_e584.y >> bitcast<u32>(24u));
                let _e588 = f32(_e587);
                let _e590 = global.member_29;
                if (_e588 <= _e590) {
                    let _e593 = global_2.member_9;
                    if (_e593 != 0u) {
                        let _e597 = atomicAdd((&global_1.member[2u]), 1u);
                    }
                    phi_5046_ = 4294967295u;
                    break;
                }
                let _e611 = ((vec3<f32>(f32((_e584.x & 1023u)), f32(((_e584.x >> bitcast<u32>(10u)) & 1023u)), f32(((_e584.x >> bitcast<u32>(20u)) & 1023u))) - vec3<f32>(512f, 512f, 512f)) * vec3<f32>(0.0013888889f, 0.0013888889f, 0.0013888889f));
                let _e615 = sqrt(max((1f - dot(_e611, _e611)), 0f));
                let _e617 = (_e584.x >> bitcast<u32>(30u));
                if (_e617 == 0u) {
                    phi_4967_ = vec4<f32>(_e615, _e611.x, _e611.y, _e611.z);
                } else {
                    if (_e617 == 1u) {
                        phi_4966_ = vec4<f32>(_e611.x, _e615, _e611.y, _e611.z);
                    } else {
                        if (_e617 == 2u) {
                            phi_4965_ = vec4<f32>(_e611.x, _e611.y, _e615, _e611.z);
                        } else {
                            phi_4965_ = vec4<f32>(_e611.x, _e611.y, _e611.z, _e615);
                        }
                        let _e630 = phi_4965_;
                        phi_4966_ = _e630;
                    }
                    let _e636 = phi_4966_;
                    phi_4967_ = _e636;
                }
                let _e642 = phi_4967_;
                let _e646 = global.member_38;
                let _e647 = (_e646 > 0u);
                phi_4985_ = unpack4x8unorm(_e584.y).xyz;
                if _e647 {
                    let _e651 = global_7.member[(_e646 + _e75)];
                    let _e653 = unpack2x16float(_e651.x);
                    phi_4985_ = vec3<f32>(_e653.x, _e653.y, unpack2x16float(_e651.y).x);
                }
                let _e661 = phi_4985_;
                let _e664 = (1u << bitcast<u32>((_e75 & 31u)));
                let _e667 = global_7.member[_e82];
                let _e671 = global_7.member[(_e82 + 1u)];
                let _e675 = global_7.member[(_e82 + 2u)];
                phi_5029_ = _e642;
                if ((_e667.x & _e664) != 0u) {
                    let _e680 = global.member_22;
                    let _e688 = global.member_18;
                    let _e692 = (_e680 + ((_e671.y + bitcast<u32>(countOneBits((_e667.x & (_e664 - 1u))))) * (1u + (4u * _e688))));
                    let _e693 = (_e692 + 1u);
                    let _e696 = global_6.member[_e692];
                    let _e698 = global.member_44;
                    let _e702 = global.member_19;
                    let _e704 = (_e698 + ((_e696 >> bitcast<u32>(16u)) * _e702));
                    let _e707 = (127f * unpack2x16float(_e696).x);
                    phi_4987_ = 0f;
                    phi_4986_ = 0u;
                    loop {
                        let _e709 = phi_4987_;
                        let _e711 = phi_4986_;
                        local_22 = _e709;
                        if (_e711 < _e688) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e716 = global_6.member[(_e693 + _e711)];
                            let _e719 = (2u * (_e704 + _e711));
                            let _e722 = global_3.member[_e719];
                            let _e726 = global_3.member[(_e719 + 1u)];
                            phi_4987_ = (_e709 + dot(unpack4x8snorm(_e716), bitcast<vec4<f32>>(vec4<u32>(_e722.x, _e722.y, _e726.x, _e726.y))));
                            phi_4986_ = (_e711 + bitcast<u32>(1i));
                        }
                    }
                    phi_4989_ = 0f;
                    phi_4988_ = 0u;
                    loop {
                        let _e739 = phi_4989_;
                        let _e741 = phi_4988_;
                        local_23 = _e739;
                        if (_e741 < _e688) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e746 = global_6.member[((_e693 + _e688) + _e741)];
                            let _e749 = (2u * (_e704 + _e741));
                            let _e752 = global_3.member[_e749];
                            let _e756 = global_3.member[(_e749 + 1u)];
                            phi_4989_ = (_e739 + dot(unpack4x8snorm(_e746), bitcast<vec4<f32>>(vec4<u32>(_e752.x, _e752.y, _e756.x, _e756.y))));
                            phi_4988_ = (_e741 + bitcast<u32>(1i));
                        }
                    }
                    phi_4991_ = 0f;
                    phi_4990_ = 0u;
                    loop {
                        let _e770 = phi_4991_;
                        let _e772 = phi_4990_;
                        local_24 = _e770;
                        if (_e772 < _e688) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e777 = global_6.member[((_e693 + (2u * _e688)) + _e772)];
                            let _e780 = (2u * (_e704 + _e772));
                            let _e783 = global_3.member[_e780];
                            let _e787 = global_3.member[(_e780 + 1u)];
                            phi_4991_ = (_e770 + dot(unpack4x8snorm(_e777), bitcast<vec4<f32>>(vec4<u32>(_e783.x, _e783.y, _e787.x, _e787.y))));
                            phi_4990_ = (_e772 + bitcast<u32>(1i));
                        }
                    }
                    let _e799 = local_22;
                    let _e801 = local_23;
                    let _e803 = local_24;
                    let _e805 = (vec3<f32>(_e799, _e801, _e803) * _e707);
                    phi_4993_ = 0f;
                    phi_4992_ = 0u;
                    loop {
                        let _e809 = phi_4993_;
                        let _e811 = phi_4992_;
                        local_25 = _e809;
                        if (_e811 < _e688) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e816 = global_6.member[((_e693 + (3u * _e688)) + _e811)];
                            let _e819 = (2u * (_e704 + _e811));
                            let _e822 = global_3.member[_e819];
                            let _e826 = global_3.member[(_e819 + 1u)];
                            phi_4993_ = (_e809 + dot(unpack4x8snorm(_e816), bitcast<vec4<f32>>(vec4<u32>(_e822.x, _e822.y, _e826.x, _e826.y))));
                            phi_4992_ = (_e811 + bitcast<u32>(1i));
                        }
                    }
                    let _e838 = local_25;
                    let _e844 = (_e642 + vec4<f32>(_e805.x, _e805.y, _e805.z, (_e707 * _e838)));
                    phi_5029_ = select(_e642, _e844, vec4((length(_e844) >= 0.001f)));
                }
                let _e850 = phi_5029_;
                phi_5037_ = _e256;
                if ((_e667.y & _e664) != 0u) {
                    let _e855 = global.member_23;
                    let _e863 = global.member_18;
                    let _e867 = (_e855 + ((_e675.x + bitcast<u32>(countOneBits((_e667.y & (_e664 - 1u))))) * (1u + (3u * _e863))));
                    let _e868 = (_e867 + 1u);
                    let _e871 = global_6.member[_e867];
                    let _e873 = global.member_44;
                    let _e877 = global.member_19;
                    let _e879 = (_e873 + ((_e871 >> bitcast<u32>(16u)) * _e877));
                    phi_4999_ = 0f;
                    phi_4998_ = 0u;
                    loop {
                        let _e884 = phi_4999_;
                        let _e886 = phi_4998_;
                        local_26 = _e884;
                        if (_e886 < _e863) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e891 = global_6.member[(_e868 + _e886)];
                            let _e894 = (2u * (_e879 + _e886));
                            let _e897 = global_3.member[_e894];
                            let _e901 = global_3.member[(_e894 + 1u)];
                            phi_4999_ = (_e884 + dot(unpack4x8snorm(_e891), bitcast<vec4<f32>>(vec4<u32>(_e897.x, _e897.y, _e901.x, _e901.y))));
                            phi_4998_ = (_e886 + bitcast<u32>(1i));
                        }
                    }
                    phi_5001_ = 0f;
                    phi_5000_ = 0u;
                    loop {
                        let _e914 = phi_5001_;
                        let _e916 = phi_5000_;
                        local_27 = _e914;
                        if (_e916 < _e863) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e921 = global_6.member[((_e868 + _e863) + _e916)];
                            let _e924 = (2u * (_e879 + _e916));
                            let _e927 = global_3.member[_e924];
                            let _e931 = global_3.member[(_e924 + 1u)];
                            phi_5001_ = (_e914 + dot(unpack4x8snorm(_e921), bitcast<vec4<f32>>(vec4<u32>(_e927.x, _e927.y, _e931.x, _e931.y))));
                            phi_5000_ = (_e916 + bitcast<u32>(1i));
                        }
                    }
                    phi_5003_ = 0f;
                    phi_5002_ = 0u;
                    loop {
                        let _e945 = phi_5003_;
                        let _e947 = phi_5002_;
                        local_28 = _e945;
                        if (_e947 < _e863) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e952 = global_6.member[((_e868 + (2u * _e863)) + _e947)];
                            let _e955 = (2u * (_e879 + _e947));
                            let _e958 = global_3.member[_e955];
                            let _e962 = global_3.member[(_e955 + 1u)];
                            phi_5003_ = (_e945 + dot(unpack4x8snorm(_e952), bitcast<vec4<f32>>(vec4<u32>(_e958.x, _e958.y, _e962.x, _e962.y))));
                            phi_5002_ = (_e947 + bitcast<u32>(1i));
                        }
                    }
                    let _e974 = local_26;
                    let _e976 = local_27;
                    let _e978 = local_28;
                    phi_5037_ = (_e256 + (vec3<f32>(_e974, _e976, _e978) * (127f * unpack2x16float(_e871).x)));
                }
                let _e983 = phi_5037_;
                phi_5041_ = _e661;
                if ((_e671.x & _e664) != 0u) {
                    let _e988 = global.member_24;
                    let _e996 = global.member_18;
                    let _e1000 = (_e988 + ((_e675.y + bitcast<u32>(countOneBits((_e671.x & (_e664 - 1u))))) * (3u + (3u * _e996))));
                    let _e1004 = global_6.member[(_e1000 + 1u)];
                    let _e1005 = unpack2x16float(_e1004);
                    let _e1009 = global_6.member[(_e1000 + 2u)];
                    let _e1017 = (_e1000 + 3u);
                    let _e1020 = global_6.member[_e1000];
                    let _e1022 = global.member_44;
                    let _e1026 = global.member_19;
                    let _e1028 = (_e1022 + ((_e1020 >> bitcast<u32>(16u)) * _e1026));
                    phi_5022_ = 0f;
                    phi_5021_ = 0u;
                    loop {
                        let _e1033 = phi_5022_;
                        let _e1035 = phi_5021_;
                        local_29 = _e1033;
                        if (_e1035 < _e996) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e1040 = global_6.member[(_e1017 + _e1035)];
                            let _e1043 = (2u * (_e1028 + _e1035));
                            let _e1046 = global_3.member[_e1043];
                            let _e1050 = global_3.member[(_e1043 + 1u)];
                            phi_5022_ = (_e1033 + dot(unpack4x8snorm(_e1040), bitcast<vec4<f32>>(vec4<u32>(_e1046.x, _e1046.y, _e1050.x, _e1050.y))));
                            phi_5021_ = (_e1035 + bitcast<u32>(1i));
                        }
                    }
                    phi_5024_ = 0f;
                    phi_5023_ = 0u;
                    loop {
                        let _e1063 = phi_5024_;
                        let _e1065 = phi_5023_;
                        local_30 = _e1063;
                        if (_e1065 < _e996) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e1070 = global_6.member[((_e1017 + _e996) + _e1065)];
                            let _e1073 = (2u * (_e1028 + _e1065));
                            let _e1076 = global_3.member[_e1073];
                            let _e1080 = global_3.member[(_e1073 + 1u)];
                            phi_5024_ = (_e1063 + dot(unpack4x8snorm(_e1070), bitcast<vec4<f32>>(vec4<u32>(_e1076.x, _e1076.y, _e1080.x, _e1080.y))));
                            phi_5023_ = (_e1065 + bitcast<u32>(1i));
                        }
                    }
                    phi_5026_ = 0f;
                    phi_5025_ = 0u;
                    loop {
                        let _e1094 = phi_5026_;
                        let _e1096 = phi_5025_;
                        local_31 = _e1094;
                        if (_e1096 < _e996) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e1101 = global_6.member[((_e1017 + (2u * _e996)) + _e1096)];
                            let _e1104 = (2u * (_e1028 + _e1096));
                            let _e1107 = global_3.member[_e1104];
                            let _e1111 = global_3.member[(_e1104 + 1u)];
                            phi_5026_ = (_e1094 + dot(unpack4x8snorm(_e1101), bitcast<vec4<f32>>(vec4<u32>(_e1107.x, _e1107.y, _e1111.x, _e1111.y))));
                            phi_5025_ = (_e1096 + bitcast<u32>(1i));
                        }
                    }
                    let _e1123 = local_29;
                    let _e1125 = local_30;
                    let _e1127 = local_31;
                    phi_5041_ = (select(vec3<f32>(_e1005.x, _e1005.y, unpack2x16float(_e1009).x), _e661, vec3(_e647)) + (vec3<f32>(_e1123, _e1125, _e1127) * (127f * unpack2x16float(_e1020).x)));
                }
                let _e1132 = phi_5041_;
                let _e1133 = normalize(_e850);
                let _e1138 = (_e1133.z * _e1133.z);
                let _e1139 = (_e1133.w * _e1133.w);
                let _e1143 = (_e1133.y * _e1133.z);
                let _e1144 = (_e1133.x * _e1133.w);
                let _e1147 = (_e1133.y * _e1133.w);
                let _e1148 = (_e1133.x * _e1133.z);
                let _e1153 = (_e1133.y * _e1133.y);
                let _e1157 = (_e1133.z * _e1133.w);
                let _e1158 = (_e1133.x * _e1133.y);
                let _e1172 = exp(min(_e983, vec3<f32>(9f, 9f, 9f)));
                let _e1179 = mat3x3<f32>((vec3<f32>((1f - (2f * (_e1138 + _e1139))), (2f * (_e1143 + _e1144)), (2f * (_e1147 - _e1148))) * _e1172.x), (vec3<f32>((2f * (_e1143 - _e1144)), (1f - (2f * (_e1153 + _e1139))), (2f * (_e1157 + _e1158))) * _e1172.y), (vec3<f32>((2f * (_e1147 + _e1148)), (2f * (_e1157 - _e1158)), (1f - (2f * (_e1153 + _e1138)))) * _e1172.z));
                switch bitcast<i32>(0u) {
                    default: {
                        let _e1185 = global.member_2;
                        let _e1187 = global.member_3;
                        let _e1188 = clamp((_e329.xy / vec2(_e328)), _e1185, _e1187);
                        let _e1191 = global.member[0u];
                        let _e1197 = (((vec3<f32>(_e340.x, _e343.y, _e346.z) - (_e368 * _e1188.x)) * (_e1191 / _e328)) * _e1179);
                        let _e1200 = global.member[1u];
                        let _e1206 = (((vec3<f32>(_e349.x, _e352.y, _e355.z) - (_e368 * _e1188.y)) * (_e1200 / _e328)) * _e1179);
                        let _e1208 = (dot(_e1197, _e1197) + 0.3f);
                        let _e1209 = dot(_e1197, _e1206);
                        let _e1211 = (dot(_e1206, _e1206) + 0.3f);
                        let _e1213 = cross(_e1197, _e1206);
                        let _e1215 = (_e1208 + _e1211);
                        let _e1218 = (dot(_e1213, _e1213) + (0.3f * (_e1215 - 0.3f)));
                        let _e1219 = (_e1218 > 0f);
                        phi_4491_ = _e1219;
                        if _e1219 {
                            phi_4491_ = (_e1208 <= 1000000000000000000f);
                        }
                        let _e1222 = phi_4491_;
                        phi_4497_ = _e1222;
                        if _e1222 {
                            phi_4497_ = (_e1211 <= 1000000000000000000f);
                        }
                        let _e1225 = phi_4497_;
                        if !(_e1225) {
                            let _e1228 = global_2.member_9;
                            if (_e1228 != 0u) {
                                let _e1232 = atomicAdd((&global_1.member[3u]), 1u);
                            }
                            phi_5045_ = 4294967295u;
                            break;
                        }
                        let _e1234 = global.member_34;
                        let _e1243 = (sqrt(vec3<f32>(_e1208, _e1209, _e1211).xz) * sqrt((2f * log(max((max(_e588, _e1234) / _e590), 1f)))));
                        let _e1246 = all(((_e575 + _e1243) > vec2<f32>(0f, 0f)));
                        phi_4522_ = _e1246;
                        if _e1246 {
                            let _e1249 = global.member_4;
                            phi_4522_ = all(((_e575 - _e1243) < _e1249));
                        }
                        let _e1253 = phi_4522_;
                        if !(_e1253) {
                            let _e1256 = global_2.member_9;
                            if (_e1256 != 0u) {
                                let _e1260 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_5045_ = 4294967295u;
                            break;
                        }
                        let _e1263 = (0.5f * (_e1208 - _e1211));
                        let _e1267 = sqrt(((_e1263 * _e1263) + (_e1209 * _e1209)));
                        let _e1269 = ((0.5f * _e1215) + _e1267);
                        if (_e1263 >= 0f) {
                            phi_5042_ = vec2<f32>((_e1263 + _e1267), _e1209);
                        } else {
                            phi_5042_ = vec2<f32>(_e1209, (_e1267 - _e1263));
                        }
                        let _e1276 = phi_5042_;
                        let _e1277 = length(_e1276);
                        if (_e1277 > 0f) {
                            phi_5043_ = (_e1276 / vec2(_e1277));
                        } else {
                            phi_5043_ = vec2<f32>(1f, 0f);
                        }
                        let _e1282 = phi_5043_;
                        let _e1289 = global.member_5;
                        let _e1293 = global.member_10;
                        let _e1297 = vec2<u32>(clamp(round(((_e575 + vec2(_e1289)) * _e1293)), vec2<f32>(0f, 0f), vec2<f32>(1048575f, 1048575f)));
                        let _e1300 = vec3<u32>(round((clamp(_e1132, vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 1023f)));
                        local = vec4<u32>(((_e1297.x | (_e1300.x << bitcast<u32>(20u))) | (_e1300.z << bitcast<u32>(30u))), (_e1297.y | (_e1300.y << bitcast<u32>(20u))), pack2x16float((_e1282 * min(sqrt(_e1269), 65504f))), ((pack2x16float(vec2<f32>(min(sqrt((_e1218 / _e1269)), 65504f), 0f)) | (_e587 << bitcast<u32>(16u))) | ((_e1300.z >> bitcast<u32>(2u)) << bitcast<u32>(24u))));
                        phi_5044_ = 0u;
                        loop {
                            let _e1329 = phi_5044_;
                            if (_e1329 < 4u) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e1332 = global.member_45;
                                let _e1337 = local[_e1329];
                                global_4.member[((4u * (_e1332 + _e75)) + _e1329)] = _e1337;
                                phi_5044_ = (_e1329 + bitcast<u32>(1i));
                            }
                        }
                        let _e1343 = global.member_9;
                        phi_5045_ = min(u32((_e573 * f32(_e1343))), _e1343);
                        break;
                    }
                }
                let _e1349 = phi_5045_;
                phi_5046_ = _e1349;
                break;
            }
        }
        let _e1351 = phi_5046_;
        phi_5047_ = _e1351;
    } else {
        phi_5047_ = 4294967295u;
    }
    let _e1353 = phi_5047_;
    switch bitcast<i32>(0u) {
        default: {
            let _e1356 = bitcast<u32>(param[0u]);
            let _e1358 = global.member_45;
            let _e1359 = (_e1358 + _e75);
            if (_e1353 != 4294967295u) {
                let _e1362 = global.member_40;
                let _e1364 = global.member_41;
                let _e1372 = atomicAdd((&global_1.member[((_e1362 + ((_e1359 / _e1364) * 256u)) + (_e1353 & 255u))]), 1u);
            }
            let _e1374 = global.member_39;
            if (_e1374 == 0u) {
                if (_e75 < (_e77 + (_e77 & 1u))) {
                    let _e1380 = global.member_28;
                    global_4.member[(_e1380 + _e1359)] = _e1353;
                }
                break;
            }
            global_5[_e1356] = _e1353;
            workgroupBarrier();
            let _e1386 = ((_e1356 & 1u) == 0u);
            if select(_e1386, _e78, _e1386) {
                let _e1389 = global.member_28;
                let _e1395 = global_5[(_e1356 + 1u)];
                global_4.member[(_e1389 + (_e1359 / 2u))] = ((_e1353 & 65535u) | (_e1395 << bitcast<u32>(16u)));
            }
            break;
        }
    }
    return;
}
