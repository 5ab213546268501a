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

    let _e120 = global_9[0u];
    let _e122 = global.member_14;
    let _e123 = (_e120 < _e122);
    if _e123 {
        switch bitcast<i32>(0u) {
            default: {
                let _e127 = (4u * (_e122 + (_e120 / 32u)));
                switch bitcast<i32>(0u) {
                    default: {
                        let _e133 = global_8.member[(_e127 + 3u)][0u];
                        phi_4916_ = (_e133 & 65535u);
                        loop {
                            let _e136 = phi_4916_;
                            phi_4920_ = bool();
                            phi_4917_ = false;
                            if (_e136 <= (_e133 >> bitcast<u32>(16u))) {
                                let _e146 = global.member_51[(_e136 / 128u)][((_e136 / 32u) & 3u)];
                                if (((_e146 >> bitcast<u32>((_e136 & 31u))) & 1u) == 0u) {
                                    phi_4920_ = false;
                                    phi_4917_ = true;
                                    break;
                                }
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                phi_4916_ = (_e136 + bitcast<u32>(1i));
                            }
                        }
                        let _e155 = phi_4920_;
                        let _e157 = phi_4917_;
                        phi_4919_ = _e155;
                        if _e157 {
                            break;
                        }
                        phi_4919_ = true;
                        break;
                    }
                }
                let _e159 = phi_4919_;
                if _e159 {
                    let _e161 = global_2.member_9;
                    if (_e161 != 0u) {
                        let _e165 = atomicAdd((&global_1.member[0u]), 1u);
                    }
                    phi_5046_ = 4294967295u;
                    break;
                }
                let _e166 = (2u * _e120);
                let _e169 = global_8.member[_e166];
                let _e173 = global_8.member[(_e166 + 1u)];
                let _e178 = global_8.member[((2u * _e122) + _e120)];
                let _e189 = (vec2<f32>(f32(((_e178.y >> bitcast<u32>(16u)) & 31u)), f32(((_e178.y >> bitcast<u32>(21u)) & 31u))) * vec2<f32>(0.032258064f, 0.032258064f));
                let _e193 = ((1f + (2f * _e189.x)) * 0.33333334f);
                let _e194 = (1f - _e193);
                let _e198 = (_e194 * (0.5f + (0.5f * _e189.y)));
                let _e206 = global.member_11;
                let _e209 = global.member_12;
                let _e224 = global.member_21;
                let _e225 = (2u * _e224);
                let _e229 = global_3.member[(_e225 + (_e178.x & 65535u))];
                let _e231 = unpack2x16float(_e229.x);
                let _e243 = global_3.member[(_e225 + (_e178.x >> bitcast<u32>(16u)))];
                let _e245 = unpack2x16float(_e243.x);
                let _e257 = global_3.member[(_e225 + (_e178.y & 65535u))];
                let _e259 = unpack2x16float(_e257.x);
                let _e267 = ((((_e206.xyz + (_e209.xyz * vec3<f32>(f32((_e169.x & 65535u)), f32((_e169.x >> bitcast<u32>(16u))), f32((_e169.y & 65535u))))) + (vec3<f32>(_e231.x, _e231.y, unpack2x16float(_e229.y).x) * _e193)) + (vec3<f32>(_e245.x, _e245.y, unpack2x16float(_e243.y).x) * _e198)) + (vec3<f32>(_e259.x, _e259.y, unpack2x16float(_e257.y).x) * (_e194 - _e198)));
                let _e271 = vec4<f32>(_e267.x, _e267.y, _e267.z, 1f);
                let _e284 = (((_e169.y >> bitcast<u32>(16u)) | ((_e173.y >> bitcast<u32>(24u)) << bitcast<u32>(16u))) | ((_e178.y >> bitcast<u32>(26u)) << bitcast<u32>(24u)));
                let _e286 = global.member_36;
                let _e288 = global.member_37;
                let _e301 = (vec3(_e286) + (vec3<f32>(f32((_e284 & 1023u)), f32(((_e284 >> bitcast<u32>(10u)) & 1023u)), f32((_e284 >> bitcast<u32>(20u)))) * _e288));
                local_1 = (vec4<u32>(_e173.x, (_e173.x >> bitcast<u32>(8u)), (_e173.x >> bitcast<u32>(16u)), (_e173.x >> bitcast<u32>(24u))) & vec4<u32>(255u, 255u, 255u, 255u));
                let _e316 = (vec3<u32>(_e173.y, (_e173.y >> bitcast<u32>(8u)), (_e173.y >> bitcast<u32>(16u))) & vec3<u32>(255u, 255u, 255u));
                let _e317 = vec3<f32>(_e316);
                local_2 = (vec4<f32>(_e317.x, _e317.y, _e317.z, f32((((255u - _e316.x) - _e316.y) - _e316.z))) * vec4<f32>(0.003921569f, 0.003921569f, 0.003921569f, 0.003921569f));
                phi_4926_ = vec4<f32>(0f, 0f, 0f, 0f);
                phi_4925_ = vec4<f32>(0f, 0f, 0f, 0f);
                phi_4924_ = vec4<f32>(0f, 0f, 0f, 0f);
                phi_4923_ = 0u;
                loop {
                    let _e331 = phi_4926_;
                    let _e333 = phi_4925_;
                    let _e335 = phi_4924_;
                    let _e337 = phi_4923_;
                    local_3 = _e335;
                    local_4 = _e333;
                    local_5 = _e331;
                    local_6 = _e335;
                    local_7 = _e335;
                    local_8 = _e333;
                    local_9 = _e333;
                    local_10 = _e331;
                    local_11 = _e331;
                    local_12 = _e335;
                    local_13 = _e335;
                    local_14 = _e335;
                    local_15 = _e333;
                    local_16 = _e333;
                    local_17 = _e333;
                    local_18 = _e331;
                    local_19 = _e331;
                    local_20 = _e331;
                    if (_e337 < 4u) {
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e340 = local_1[_e337];
                        let _e341 = (3u * _e340);
                        let _e343 = local_2[_e337];
                        let _e346 = global.member_54[_e341];
                        let _e349 = local_2[_e337];
                        let _e353 = global.member_54[(_e341 + 1u)];
                        let _e356 = local_2[_e337];
                        let _e360 = global.member_54[(_e341 + 2u)];
                        phi_4926_ = (_e331 + (_e360 * _e356));
                        phi_4925_ = (_e333 + (_e353 * _e349));
                        phi_4924_ = (_e335 + (_e346 * _e343));
                        phi_4923_ = (_e337 + bitcast<u32>(1i));
                    }
                }
                let _e366 = local_3;
                let _e369 = local_4;
                let _e372 = local_5;
                let _e373 = dot(_e372, _e271);
                let _e374 = vec3<f32>(dot(_e366, _e271), dot(_e369, _e271), _e373);
                let _e376 = local_6;
                let _e379 = _e376.xyz;
                let _e381 = local_8;
                let _e384 = _e381.xyz;
                let _e386 = local_10;
                let _e389 = _e386.xyz;
                let _e391 = local_12;
                let _e394 = local_13;
                let _e397 = local_14;
                let _e400 = local_15;
                let _e403 = local_16;
                let _e406 = local_17;
                let _e409 = local_18;
                let _e412 = local_19;
                let _e415 = local_20;
                let _e419 = vec3<f32>(_e409.x, _e412.y, _e415.z);
                switch bitcast<i32>(0u) {
                    default: {
                        let _e437 = global.member_6;
                        if !((_e373 >= _e437)) {
                            let _e441 = global_2.member_9;
                            if (_e441 != 0u) {
                                let _e445 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_4955_ = 0f;
                            phi_4946_ = vec2<f32>(0f, 0f);
                            phi_4945_ = false;
                            break;
                        }
                        let _e447 = global.member;
                        let _e448 = _e374.xy;
                        let _e450 = vec2(_e373);
                        let _e453 = global.member_1;
                        let _e454 = (((_e447 * _e448) / _e450) + _e453);
                        let _e456 = global.member_5;
                        let _e460 = all((_e454 >= vec2(-(_e456))));
                        phi_3118_ = _e460;
                        if _e460 {
                            let _e462 = global.member_4;
                            phi_3118_ = all((_e454 <= (_e462 + vec2(_e456))));
                        }
                        let _e468 = phi_3118_;
                        if !(_e468) {
                            let _e471 = global_2.member_9;
                            if (_e471 != 0u) {
                                let _e475 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_4955_ = 0f;
                            phi_4946_ = _e454;
                            phi_4945_ = false;
                            break;
                        }
                        let _e477 = global.member_7;
                        let _e480 = global.member_8;
                        let _e481 = ((_e477 - _e373) * _e480);
                        if (_e481 < 0f) {
                            phi_4929_ = (0.015625f / (1f - _e481));
                        } else {
                            if (_e481 > 1f) {
                                phi_4928_ = (1f - (0.015625f / _e481));
                            } else {
                                phi_4928_ = (0.015625f + (0.96875f * clamp(_e481, 0f, 1f)));
                            }
                            let _e490 = phi_4928_;
                            phi_4929_ = _e490;
                        }
                        let _e494 = phi_4929_;
                        let _e495 = (_e448 / _e450);
                        let _e503 = global.member[0u];
                        let _e506 = global.member[1u];
                        let _e511 = global.member_31;
                        let _e512 = (_e511 > 0u);
                        phi_3160_ = _e512;
                        if _e512 {
                            let _e514 = global.member_34;
                            let _e517 = global.member_29;
                            switch bitcast<i32>(0u) {
                                default: {
                                    let _e527 = vec2((sqrt((2f * log(max((max(255f, _e514) / _e517), 1f)))) * ((((((1.2f * exp(min(max(max(_e301.x, _e301.y), _e301.z), 9f))) * sqrt(max(max(dot(_e379, _e379), dot(_e384, _e384)), dot(_e389, _e389)))) * length(vec3<f32>(_e495.x, _e495.y, 1f))) * max(_e503, _e506)) / _e373) + 0.5477226f)));
                                    let _e530 = global.member_32;
                                    let _e533 = global.member_33;
                                    let _e537 = vec2<u32>(clamp(((((_e454 - _e527) - _e530) * _e533) - vec2<f32>(0.5f, 0.5f)), vec2<f32>(0f, 0f), vec2<f32>(191f, 191f)));
                                    let _e543 = vec2<u32>(clamp(((((_e454 + _e527) - _e530) * _e533) + vec2<f32>(0.5f, 0.5f)), vec2<f32>(0f, 0f), vec2<f32>(191f, 191f)));
                                    let _e550 = max((_e543.x - _e537.x), (_e543.y - _e537.y));
                                    if (_e550 <= 3u) {
                                        phi_4933_ = 0u;
                                    } else {
                                        phi_4933_ = (bitcast<u32>(firstLeadingBit((_e550 - 1u))) - 1u);
                                    }
                                    let _e557 = phi_4933_;
                                    if !((_e557 < 4u)) {
                                        phi_4944_ = false;
                                        break;
                                    }
                                    let _e566 = vec2(_e557);
                                    let _e568 = (_e537 >> bitcast<vec2<u32>>(_e566));
                                    let _e570 = (_e543 >> bitcast<vec2<u32>>(_e566));
                                    phi_4938_ = 0f;
                                    phi_4936_ = _e568.y;
                                    loop {
                                        let _e573 = phi_4938_;
                                        let _e575 = phi_4936_;
                                        local_21 = _e573;
                                        if (_e575 <= _e570.y) {
                                            phi_4943_ = _e573;
                                            phi_4940_ = _e568.x;
                                            loop {
                                                let _e580 = phi_4943_;
                                                let _e582 = phi_4940_;
                                                local_32 = _e580;
                                                if (_e582 <= _e570.x) {
                                                    continue;
                                                } else {
                                                    break;
                                                }
                                                continuing {
                                                    let _e589 = (((49152u - (((36864u >> bitcast<u32>((2u * _e557))) / 3u) * 4u)) + (_e575 * (192u >> bitcast<u32>(_e557)))) + _e582);
                                                    let _e591 = (_e511 + (_e589 / 2u));
                                                    let _e597 = global_3.member[(_e591 / 2u)][(_e591 & 1u)];
                                                    phi_4943_ = max(_e580, (f32(((_e597 >> bitcast<u32>((16u * (_e589 & 1u)))) & 65535u)) * 0.000015259022f));
                                                    phi_4940_ = (_e582 + bitcast<u32>(1i));
                                                }
                                            }
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e1484 = local_32;
                                            phi_4938_ = _e1484;
                                            phi_4936_ = (_e575 + bitcast<u32>(1i));
                                        }
                                    }
                                    let _e611 = local_21;
                                    phi_4944_ = ((1f - _e494) > _e611);
                                    break;
                                }
                            }
                            let _e614 = phi_4944_;
                            phi_3160_ = _e614;
                        }
                        let _e616 = phi_3160_;
                        if _e616 {
                            let _e618 = global_2.member_9;
                            if (_e618 != 0u) {
                                let _e622 = atomicAdd((&global_1.member[1u]), 1u);
                            }
                            phi_4955_ = _e494;
                            phi_4946_ = _e454;
                            phi_4945_ = false;
                            break;
                        }
                        phi_4955_ = _e494;
                        phi_4946_ = _e454;
                        phi_4945_ = true;
                        break;
                    }
                }
                let _e624 = phi_4955_;
                let _e626 = phi_4946_;
                let _e628 = phi_4945_;
                if (true && !(_e628)) {
                    phi_5046_ = 4294967295u;
                    break;
                }
                let _e635 = global_8.member[((3u * _e122) + _e120)];
                let _e638 = (_e635.y >> bitcast<u32>(24u));
                let _e639 = f32(_e638);
                let _e641 = global.member_29;
                if (_e639 <= _e641) {
                    let _e644 = global_2.member_9;
                    if (_e644 != 0u) {
                        let _e648 = atomicAdd((&global_1.member[2u]), 1u);
                    }
                    phi_5046_ = 4294967295u;
                    break;
                }
                let _e662 = ((vec3<f32>(f32((_e635.x & 1023u)), f32(((_e635.x >> bitcast<u32>(10u)) & 1023u)), f32(((_e635.x >> bitcast<u32>(20u)) & 1023u))) - vec3<f32>(512f, 512f, 512f)) * vec3<f32>(0.0013888889f, 0.0013888889f, 0.0013888889f));
                let _e666 = sqrt(max((1f - dot(_e662, _e662)), 0f));
                let _e668 = (_e635.x >> bitcast<u32>(30u));
                if (_e668 == 0u) {
                    phi_4967_ = vec4<f32>(_e666, _e662.x, _e662.y, _e662.z);
                } else {
                    if (_e668 == 1u) {
                        phi_4966_ = vec4<f32>(_e662.x, _e666, _e662.y, _e662.z);
                    } else {
                        if (_e668 == 2u) {
                            phi_4965_ = vec4<f32>(_e662.x, _e662.y, _e666, _e662.z);
                        } else {
                            phi_4965_ = vec4<f32>(_e662.x, _e662.y, _e662.z, _e666);
                        }
                        let _e681 = phi_4965_;
                        phi_4966_ = _e681;
                    }
                    let _e687 = phi_4966_;
                    phi_4967_ = _e687;
                }
                let _e693 = phi_4967_;
                let _e697 = global.member_38;
                let _e698 = (_e697 > 0u);
                phi_4985_ = unpack4x8unorm(_e635.y).xyz;
                if _e698 {
                    let _e702 = global_8.member[(_e697 + _e120)];
                    let _e704 = unpack2x16float(_e702.x);
                    phi_4985_ = vec3<f32>(_e704.x, _e704.y, unpack2x16float(_e702.y).x);
                }
                let _e712 = phi_4985_;
                let _e715 = (1u << bitcast<u32>((_e120 & 31u)));
                let _e718 = global_8.member[_e127];
                let _e722 = global_8.member[(_e127 + 1u)];
                let _e726 = global_8.member[(_e127 + 2u)];
                phi_5029_ = _e693;
                if ((_e718.x & _e715) != 0u) {
                    let _e731 = global.member_22;
                    let _e739 = global.member_18;
                    let _e743 = (_e731 + ((_e722.y + bitcast<u32>(countOneBits((_e718.x & (_e715 - 1u))))) * (1u + (4u * _e739))));
                    let _e744 = (_e743 + 1u);
                    let _e747 = global_7.member[_e743];
                    let _e749 = global.member_44;
                    let _e753 = global.member_19;
                    let _e755 = (_e749 + ((_e747 >> bitcast<u32>(16u)) * _e753));
                    let _e758 = (127f * unpack2x16float(_e747).x);
                    phi_4987_ = 0f;
                    phi_4986_ = 0u;
                    loop {
                        let _e760 = phi_4987_;
                        let _e762 = phi_4986_;
                        local_22 = _e760;
                        if (_e762 < _e739) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e767 = global_7.member[(_e744 + _e762)];
                            let _e770 = (2u * (_e755 + _e762));
                            let _e773 = global_3.member[_e770];
                            let _e777 = global_3.member[(_e770 + 1u)];
                            phi_4987_ = (_e760 + dot(unpack4x8snorm(_e767), bitcast<vec4<f32>>(vec4<u32>(_e773.x, _e773.y, _e777.x, _e777.y))));
                            phi_4986_ = (_e762 + bitcast<u32>(1i));
                        }
                    }
                    phi_4989_ = 0f;
                    phi_4988_ = 0u;
                    loop {
                        let _e790 = phi_4989_;
                        let _e792 = phi_4988_;
                        local_23 = _e790;
                        if (_e792 < _e739) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e797 = global_7.member[((_e744 + _e739) + _e792)];
                            let _e800 = (2u * (_e755 + _e792));
                            let _e803 = global_3.member[_e800];
                            let _e807 = global_3.member[(_e800 + 1u)];
                            phi_4989_ = (_e790 + dot(unpack4x8snorm(_e797), bitcast<vec4<f32>>(vec4<u32>(_e803.x, _e803.y, _e807.x, _e807.y))));
                            phi_4988_ = (_e792 + bitcast<u32>(1i));
                        }
                    }
                    phi_4991_ = 0f;
                    phi_4990_ = 0u;
                    loop {
                        let _e821 = phi_4991_;
                        let _e823 = phi_4990_;
                        local_24 = _e821;
                        if (_e823 < _e739) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e828 = global_7.member[((_e744 + (2u * _e739)) + _e823)];
                            let _e831 = (2u * (_e755 + _e823));
                            let _e834 = global_3.member[_e831];
                            let _e838 = global_3.member[(_e831 + 1u)];
                            phi_4991_ = (_e821 + dot(unpack4x8snorm(_e828), bitcast<vec4<f32>>(vec4<u32>(_e834.x, _e834.y, _e838.x, _e838.y))));
                            phi_4990_ = (_e823 + bitcast<u32>(1i));
                        }
                    }
                    let _e850 = local_22;
                    let _e852 = local_23;
                    let _e854 = local_24;
                    let _e856 = (vec3<f32>(_e850, _e852, _e854) * _e758);
                    phi_4993_ = 0f;
                    phi_4992_ = 0u;
                    loop {
                        let _e860 = phi_4993_;
                        let _e862 = phi_4992_;
                        local_25 = _e860;
                        if (_e862 < _e739) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e867 = global_7.member[((_e744 + (3u * _e739)) + _e862)];
                            let _e870 = (2u * (_e755 + _e862));
                            let _e873 = global_3.member[_e870];
                            let _e877 = global_3.member[(_e870 + 1u)];
                            phi_4993_ = (_e860 + dot(unpack4x8snorm(_e867), bitcast<vec4<f32>>(vec4<u32>(_e873.x, _e873.y, _e877.x, _e877.y))));
                            phi_4992_ = (_e862 + bitcast<u32>(1i));
                        }
                    }
                    let _e889 = local_25;
                    let _e895 = (_e693 + vec4<f32>(_e856.x, _e856.y, _e856.z, (_e758 * _e889)));
                    phi_5029_ = select(_e693, _e895, vec4((length(_e895) >= 0.001f)));
                }
                let _e901 = phi_5029_;
                phi_5037_ = _e301;
                if ((_e718.y & _e715) != 0u) {
                    let _e906 = global.member_23;
                    let _e914 = global.member_18;
                    let _e918 = (_e906 + ((_e726.x + bitcast<u32>(countOneBits((_e718.y & (_e715 - 1u))))) * (1u + (3u * _e914))));
                    let _e919 = (_e918 + 1u);
                    let _e922 = global_7.member[_e918];
                    let _e924 = global.member_44;
                    let _e928 = global.member_19;
                    let _e930 = (_e924 + ((_e922 >> bitcast<u32>(16u)) * _e928));
                    phi_4999_ = 0f;
                    phi_4998_ = 0u;
                    loop {
                        let _e935 = phi_4999_;
                        let _e937 = phi_4998_;
                        local_26 = _e935;
                        if (_e937 < _e914) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e942 = global_7.member[(_e919 + _e937)];
                            let _e945 = (2u * (_e930 + _e937));
                            let _e948 = global_3.member[_e945];
                            let _e952 = global_3.member[(_e945 + 1u)];
                            phi_4999_ = (_e935 + dot(unpack4x8snorm(_e942), bitcast<vec4<f32>>(vec4<u32>(_e948.x, _e948.y, _e952.x, _e952.y))));
                            phi_4998_ = (_e937 + bitcast<u32>(1i));
                        }
                    }
                    phi_5001_ = 0f;
                    phi_5000_ = 0u;
                    loop {
                        let _e965 = phi_5001_;
                        let _e967 = phi_5000_;
                        local_27 = _e965;
                        if (_e967 < _e914) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e972 = global_7.member[((_e919 + _e914) + _e967)];
                            let _e975 = (2u * (_e930 + _e967));
                            let _e978 = global_3.member[_e975];
                            let _e982 = global_3.member[(_e975 + 1u)];
                            phi_5001_ = (_e965 + dot(unpack4x8snorm(_e972), bitcast<vec4<f32>>(vec4<u32>(_e978.x, _e978.y, _e982.x, _e982.y))));
                            phi_5000_ = (_e967 + bitcast<u32>(1i));
                        }
                    }
                    phi_5003_ = 0f;
                    phi_5002_ = 0u;
                    loop {
                        let _e996 = phi_5003_;
                        let _e998 = phi_5002_;
                        local_28 = _e996;
                        if (_e998 < _e914) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e1003 = global_7.member[((_e919 + (2u * _e914)) + _e998)];
                            let _e1006 = (2u * (_e930 + _e998));
                            let _e1009 = global_3.member[_e1006];
                            let _e1013 = global_3.member[(_e1006 + 1u)];
                            phi_5003_ = (_e996 + dot(unpack4x8snorm(_e1003), bitcast<vec4<f32>>(vec4<u32>(_e1009.x, _e1009.y, _e1013.x, _e1013.y))));
                            phi_5002_ = (_e998 + bitcast<u32>(1i));
                        }
                    }
                    let _e1025 = local_26;
                    let _e1027 = local_27;
                    let _e1029 = local_28;
                    phi_5037_ = (_e301 + (vec3<f32>(_e1025, _e1027, _e1029) * (127f * unpack2x16float(_e922).x)));
                }
                let _e1034 = phi_5037_;
                phi_5041_ = _e712;
                if ((_e722.x & _e715) != 0u) {
                    let _e1039 = global.member_24;
                    let _e1047 = global.member_18;
                    let _e1051 = (_e1039 + ((_e726.y + bitcast<u32>(countOneBits((_e722.x & (_e715 - 1u))))) * (3u + (3u * _e1047))));
                    let _e1055 = global_7.member[(_e1051 + 1u)];
                    let _e1056 = unpack2x16float(_e1055);
                    let _e1060 = global_7.member[(_e1051 + 2u)];
                    let _e1068 = (_e1051 + 3u);
                    let _e1071 = global_7.member[_e1051];
                    let _e1073 = global.member_44;
                    let _e1077 = global.member_19;
                    let _e1079 = (_e1073 + ((_e1071 >> bitcast<u32>(16u)) * _e1077));
                    phi_5022_ = 0f;
                    phi_5021_ = 0u;
                    loop {
                        let _e1084 = phi_5022_;
                        let _e1086 = phi_5021_;
                        local_29 = _e1084;
                        if (_e1086 < _e1047) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e1091 = global_7.member[(_e1068 + _e1086)];
                            let _e1094 = (2u * (_e1079 + _e1086));
                            let _e1097 = global_3.member[_e1094];
                            let _e1101 = global_3.member[(_e1094 + 1u)];
                            phi_5022_ = (_e1084 + dot(unpack4x8snorm(_e1091), bitcast<vec4<f32>>(vec4<u32>(_e1097.x, _e1097.y, _e1101.x, _e1101.y))));
                            phi_5021_ = (_e1086 + bitcast<u32>(1i));
                        }
                    }
                    phi_5024_ = 0f;
                    phi_5023_ = 0u;
                    loop {
                        let _e1114 = phi_5024_;
                        let _e1116 = phi_5023_;
                        local_30 = _e1114;
                        if (_e1116 < _e1047) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e1121 = global_7.member[((_e1068 + _e1047) + _e1116)];
                            let _e1124 = (2u * (_e1079 + _e1116));
                            let _e1127 = global_3.member[_e1124];
                            let _e1131 = global_3.member[(_e1124 + 1u)];
                            phi_5024_ = (_e1114 + dot(unpack4x8snorm(_e1121), bitcast<vec4<f32>>(vec4<u32>(_e1127.x, _e1127.y, _e1131.x, _e1131.y))));
                            phi_5023_ = (_e1116 + bitcast<u32>(1i));
                        }
                    }
                    phi_5026_ = 0f;
                    phi_5025_ = 0u;
                    loop {
                        let _e1145 = phi_5026_;
                        let _e1147 = phi_5025_;
                        local_31 = _e1145;
                        if (_e1147 < _e1047) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e1152 = global_7.member[((_e1068 + (2u * _e1047)) + _e1147)];
                            let _e1155 = (2u * (_e1079 + _e1147));
                            let _e1158 = global_3.member[_e1155];
                            let _e1162 = global_3.member[(_e1155 + 1u)];
                            phi_5026_ = (_e1145 + dot(unpack4x8snorm(_e1152), bitcast<vec4<f32>>(vec4<u32>(_e1158.x, _e1158.y, _e1162.x, _e1162.y))));
                            phi_5025_ = (_e1147 + bitcast<u32>(1i));
                        }
                    }
                    let _e1174 = local_29;
                    let _e1176 = local_30;
                    let _e1178 = local_31;
                    phi_5041_ = (select(vec3<f32>(_e1056.x, _e1056.y, unpack2x16float(_e1060).x), _e712, vec3(_e698)) + (vec3<f32>(_e1174, _e1176, _e1178) * (127f * unpack2x16float(_e1071).x)));
                }
                let _e1183 = phi_5041_;
                let _e1184 = normalize(_e901);
                let _e1189 = (_e1184.z * _e1184.z);
                let _e1190 = (_e1184.w * _e1184.w);
                let _e1194 = (_e1184.y * _e1184.z);
                let _e1195 = (_e1184.x * _e1184.w);
                let _e1198 = (_e1184.y * _e1184.w);
                let _e1199 = (_e1184.x * _e1184.z);
                let _e1204 = (_e1184.y * _e1184.y);
                let _e1208 = (_e1184.z * _e1184.w);
                let _e1209 = (_e1184.x * _e1184.y);
                let _e1223 = exp(min(_e1034, vec3<f32>(9f, 9f, 9f)));
                let _e1230 = mat3x3<f32>((vec3<f32>((1f - (2f * (_e1189 + _e1190))), (2f * (_e1194 + _e1195)), (2f * (_e1198 - _e1199))) * _e1223.x), (vec3<f32>((2f * (_e1194 - _e1195)), (1f - (2f * (_e1204 + _e1190))), (2f * (_e1208 + _e1209))) * _e1223.y), (vec3<f32>((2f * (_e1198 + _e1199)), (2f * (_e1208 - _e1209)), (1f - (2f * (_e1204 + _e1189)))) * _e1223.z));
                switch bitcast<i32>(0u) {
                    default: {
                        let _e1236 = global.member_2;
                        let _e1238 = global.member_3;
                        let _e1239 = clamp((_e374.xy / vec2(_e373)), _e1236, _e1238);
                        let _e1242 = global.member[0u];
                        let _e1248 = (((vec3<f32>(_e391.x, _e394.y, _e397.z) - (_e419 * _e1239.x)) * (_e1242 / _e373)) * _e1230);
                        let _e1251 = global.member[1u];
                        let _e1257 = (((vec3<f32>(_e400.x, _e403.y, _e406.z) - (_e419 * _e1239.y)) * (_e1251 / _e373)) * _e1230);
                        let _e1259 = (dot(_e1248, _e1248) + 0.3f);
                        let _e1260 = dot(_e1248, _e1257);
                        let _e1262 = (dot(_e1257, _e1257) + 0.3f);
                        let _e1264 = cross(_e1248, _e1257);
                        let _e1266 = (_e1259 + _e1262);
                        let _e1269 = (dot(_e1264, _e1264) + (0.3f * (_e1266 - 0.3f)));
                        let _e1270 = (_e1269 > 0f);
                        phi_4491_ = _e1270;
                        if _e1270 {
                            phi_4491_ = (_e1259 <= 1000000000000000000f);
                        }
                        let _e1273 = phi_4491_;
                        phi_4497_ = _e1273;
                        if _e1273 {
                            phi_4497_ = (_e1262 <= 1000000000000000000f);
                        }
                        let _e1276 = phi_4497_;
                        if !(_e1276) {
                            let _e1279 = global_2.member_9;
                            if (_e1279 != 0u) {
                                let _e1283 = atomicAdd((&global_1.member[3u]), 1u);
                            }
                            phi_5045_ = 4294967295u;
                            break;
                        }
                        let _e1285 = global.member_34;
                        let _e1294 = (sqrt(vec3<f32>(_e1259, _e1260, _e1262).xz) * sqrt((2f * log(max((max(_e639, _e1285) / _e641), 1f)))));
                        let _e1297 = all(((_e626 + _e1294) > vec2<f32>(0f, 0f)));
                        phi_4522_ = _e1297;
                        if _e1297 {
                            let _e1300 = global.member_4;
                            phi_4522_ = all(((_e626 - _e1294) < _e1300));
                        }
                        let _e1304 = phi_4522_;
                        if !(_e1304) {
                            let _e1307 = global_2.member_9;
                            if (_e1307 != 0u) {
                                let _e1311 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_5045_ = 4294967295u;
                            break;
                        }
                        let _e1314 = (0.5f * (_e1259 - _e1262));
                        let _e1318 = sqrt(((_e1314 * _e1314) + (_e1260 * _e1260)));
                        let _e1320 = ((0.5f * _e1266) + _e1318);
                        if (_e1314 >= 0f) {
                            phi_5042_ = vec2<f32>((_e1314 + _e1318), _e1260);
                        } else {
                            phi_5042_ = vec2<f32>(_e1260, (_e1318 - _e1314));
                        }
                        let _e1327 = phi_5042_;
                        let _e1328 = length(_e1327);
                        if (_e1328 > 0f) {
                            phi_5043_ = (_e1327 / vec2(_e1328));
                        } else {
                            phi_5043_ = vec2<f32>(1f, 0f);
                        }
                        let _e1333 = phi_5043_;
                        let _e1340 = global.member_5;
                        let _e1344 = global.member_10;
                        let _e1348 = vec2<u32>(clamp(round(((_e626 + vec2(_e1340)) * _e1344)), vec2<f32>(0f, 0f), vec2<f32>(1048575f, 1048575f)));
                        let _e1351 = vec3<u32>(round((clamp(_e1183, vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 1023f)));
                        local = vec4<u32>(((_e1348.x | (_e1351.x << bitcast<u32>(20u))) | (_e1351.z << bitcast<u32>(30u))), (_e1348.y | (_e1351.y << bitcast<u32>(20u))), pack2x16float((_e1333 * min(sqrt(_e1320), 65504f))), ((pack2x16float(vec2<f32>(min(sqrt((_e1269 / _e1320)), 65504f), 0f)) | (_e638 << bitcast<u32>(16u))) | ((_e1351.z >> bitcast<u32>(2u)) << bitcast<u32>(24u))));
                        phi_5044_ = 0u;
                        loop {
                            let _e1380 = phi_5044_;
                            if (_e1380 < 4u) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e1383 = global.member_45;
                                let _e1388 = local[_e1380];
                                global_4.member[((4u * (_e1383 + _e120)) + _e1380)] = _e1388;
                                phi_5044_ = (_e1380 + bitcast<u32>(1i));
                            }
                        }
                        let _e1394 = global.member_9;
                        phi_5045_ = min(u32((_e624 * f32(_e1394))), _e1394);
                        break;
                    }
                }
                let _e1400 = phi_5045_;
                phi_5046_ = _e1400;
                break;
            }
        }
        let _e1402 = phi_5046_;
        phi_5047_ = _e1402;
    } else {
        phi_5047_ = 4294967295u;
    }
    let _e1404 = phi_5047_;
    switch bitcast<i32>(0u) {
        default: {
            let _e1407 = global_5[0u];
            let _e1409 = global.member_45;
            let _e1410 = (_e1409 + _e120);
            if (_e1404 != 4294967295u) {
                let _e1413 = global.member_40;
                let _e1415 = global.member_41;
                let _e1423 = atomicAdd((&global_1.member[((_e1413 + ((_e1410 / _e1415) * 256u)) + (_e1404 & 255u))]), 1u);
            }
            let _e1425 = global.member_39;
            if (_e1425 == 0u) {
                if (_e120 < (_e122 + (_e122 & 1u))) {
                    let _e1431 = global.member_28;
                    global_4.member[(_e1431 + _e1410)] = _e1404;
                }
                break;
            }
            global_6[_e1407] = _e1404;
            workgroupBarrier();
            let _e1437 = ((_e1407 & 1u) == 0u);
            if select(_e1437, _e123, _e1437) {
                let _e1440 = global.member_28;
                let _e1446 = global_6[(_e1407 + 1u)];
                global_4.member[(_e1440 + (_e1410 / 2u))] = ((_e1404 & 65535u) | (_e1446 << bitcast<u32>(16u)));
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
