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
    member: array<vec2<u32>, LENGTH_1_8>,
}

struct type_32 {
    member: array<u32, LENGTH_2_4>,
}

@group(0) @binding(0) 
var<uniform> global: type_16;
@group(0) @binding(6) 
var<storage, read_write> global_1: type_28;
@group(0) @binding(7) 
var<uniform> global_2: type_20;
@group(0) @binding(1) 
var<storage> global_3: type_30;
@group(0) @binding(2) 
var<storage, read_write> global_4: type_32;
var<workgroup> global_5: array<u32, 64>;

@compute @workgroup_size(64, 1, 1) 
fn main(@builtin(local_invocation_id) param: vec3<u32>, @builtin(global_invocation_id) param_1: vec3<u32>) {
    var phi_1535_: bool;
    var phi_2421_: f32;
    var phi_2422_: f32;
    var phi_2426_: u32;
    var phi_2433_: f32;
    var phi_2432_: u32;
    var phi_2429_: u32;
    var local: f32;
    var phi_2438_: bool;
    var phi_1577_: bool;
    var phi_2449_: f32;
    var phi_2440_: vec2<f32>;
    var phi_2439_: bool;
    var phi_2031_: bool;
    var phi_2037_: bool;
    var phi_2062_: bool;
    var phi_2459_: vec2<f32>;
    var phi_2460_: vec2<f32>;
    var phi_2461_: u32;
    var phi_2462_: u32;
    var phi_2463_: u32;

    let _e64 = bitcast<u32>(param_1[0u]);
    let _e66 = global.member_14;
    let _e67 = (_e64 < _e66);
    if _e67 {
        switch bitcast<i32>(0u) {
            default: {
                let _e70 = global.member_42;
                let _e72 = (_e70 + (2u * _e64));
                let _e75 = global_4.member[_e72];
                let _e79 = global_4.member[(_e72 + 1u)];
                let _e81 = (_e79 >> bitcast<u32>(24u));
                let _e83 = global.member_47;
                let _e86 = global.member_48;
                let _e94 = (vec3<f32>(vec3<u32>((_e75 & 65535u), (_e75 >> bitcast<u32>(16u)), (_e79 & 65535u))) * vec3<f32>(0.000015259022f, 0.000015259022f, 0.000015259022f));
                let _e108 = (_e83.xyz + (_e86.xyz * select(select(((_e94 - vec3<f32>(0.015625f, 0.015625f, 0.015625f)) * vec3<f32>(1.032258f, 1.032258f, 1.032258f)), (vec3<f32>(1f, 1f, 1f) - (vec3<f32>(0.015625f, 0.015625f, 0.015625f) / max(_e94, vec3<f32>(0.000007629511f, 0.000007629511f, 0.000007629511f)))), (_e94 < vec3<f32>(0.015625f, 0.015625f, 0.015625f))), (vec3<f32>(0.015625f, 0.015625f, 0.015625f) / max((vec3<f32>(1f, 1f, 1f) - _e94), vec3<f32>(0.000007629511f, 0.000007629511f, 0.000007629511f))), (_e94 > vec3<f32>(0.984375f, 0.984375f, 0.984375f)))));
                let _e112 = vec4<f32>(_e108.x, _e108.y, _e108.z, 1f);
                let _e115 = global.member_49[0i];
                let _e119 = global.member_49[1i];
                let _e123 = global.member_49[2i];
                let _e124 = dot(_e123, _e112);
                let _e125 = vec3<f32>(dot(_e115, _e112), dot(_e119, _e112), _e124);
                let _e127 = global.member_43;
                let _e135 = (_e127 * exp2(((f32(((_e79 >> bitcast<u32>(16u)) & 255u)) * 0.125f) - 19f)));
                switch bitcast<i32>(0u) {
                    default: {
                        let _e138 = global.member_6;
                        if !((_e124 >= _e138)) {
                            let _e142 = global_2.member_9;
                            if (_e142 != 0u) {
                                let _e146 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_2449_ = 0f;
                            phi_2440_ = vec2<f32>(0f, 0f);
                            phi_2439_ = false;
                            break;
                        }
                        let _e148 = global.member;
                        let _e149 = _e125.xy;
                        let _e151 = vec2(_e124);
                        let _e154 = global.member_1;
                        let _e155 = (((_e148 * _e149) / _e151) + _e154);
                        let _e157 = global.member_5;
                        let _e161 = all((_e155 >= vec2(-(_e157))));
                        phi_1535_ = _e161;
                        if _e161 {
                            let _e163 = global.member_4;
                            phi_1535_ = all((_e155 <= (_e163 + vec2(_e157))));
                        }
                        let _e169 = phi_1535_;
                        if !(_e169) {
                            let _e172 = global_2.member_9;
                            if (_e172 != 0u) {
                                let _e176 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_2449_ = 0f;
                            phi_2440_ = _e155;
                            phi_2439_ = false;
                            break;
                        }
                        let _e178 = global.member_7;
                        let _e181 = global.member_8;
                        let _e182 = ((_e178 - _e124) * _e181);
                        if (_e182 < 0f) {
                            phi_2422_ = (0.015625f / (1f - _e182));
                        } else {
                            if (_e182 > 1f) {
                                phi_2421_ = (1f - (0.015625f / _e182));
                            } else {
                                phi_2421_ = (0.015625f + (0.96875f * clamp(_e182, 0f, 1f)));
                            }
                            let _e193 = phi_2421_;
                            phi_2422_ = _e193;
                        }
                        let _e195 = phi_2422_;
                        let _e196 = (_e149 / _e151);
                        let _e204 = global.member[0u];
                        let _e207 = global.member[1u];
                        let _e212 = global.member_31;
                        let _e213 = (_e212 > 0u);
                        phi_1577_ = _e213;
                        if _e213 {
                            let _e215 = global.member_34;
                            let _e218 = global.member_29;
                            switch bitcast<i32>(0u) {
                                default: {
                                    let _e228 = vec2((sqrt((2f * log(max((max(255f, _e215) / _e218), 1f)))) * ((((_e135 * length(vec3<f32>(_e196.x, _e196.y, 1f))) * max(_e204, _e207)) / _e124) + 0.5477226f)));
                                    let _e231 = global.member_32;
                                    let _e234 = global.member_33;
                                    let _e238 = vec2<u32>(clamp(((((_e155 - _e228) - _e231) * _e234) - vec2<f32>(0.5f, 0.5f)), vec2<f32>(0f, 0f), vec2<f32>(191f, 191f)));
                                    let _e244 = vec2<u32>(clamp(((((_e155 + _e228) - _e231) * _e234) + vec2<f32>(0.5f, 0.5f)), vec2<f32>(0f, 0f), vec2<f32>(191f, 191f)));
                                    let _e251 = max((_e244.x - _e238.x), (_e244.y - _e238.y));
                                    if (_e251 <= 3u) {
                                        phi_2426_ = 0u;
                                    } else {
                                        phi_2426_ = (bitcast<u32>(firstLeadingBit((_e251 - 1u))) - 1u);
                                    }
                                    let _e258 = phi_2426_;
                                    if !((_e258 < 4u)) {
                                        phi_2438_ = false;
                                        break;
                                    }
                                    let _e268 = vec2(_e258);
                                    let _e270 = (_e238 >> bitcast<vec2<u32>>(_e268));
                                    let _e272 = (_e244 >> bitcast<vec2<u32>>(_e268));
                                    let _e274 = (_e270.x & 4294967292u);
                                    phi_2433_ = 0f;
                                    phi_2432_ = _e270.y;
                                    phi_2429_ = _e274;
                                    loop {
                                        let _e277 = phi_2433_;
                                        let _e279 = phi_2432_;
                                        let _e281 = phi_2429_;
                                        let _e284 = (vec4(f32(_e281)) + vec4<f32>(0f, 1f, 2f, 3f));
                                        let _e302 = global_3.member[((_e212 >> bitcast<u32>(1u)) + ((((4u * (12288u - (12288u >> bitcast<u32>((2u * _e258))))) + (_e279 * (192u >> bitcast<u32>(_e258)))) + _e281) >> bitcast<u32>(2u)))];
                                        let _e304 = unpack2x16unorm(_e302.x);
                                        let _e306 = unpack2x16unorm(_e302.y);
                                        let _e313 = select(select(vec4<f32>(_e304.x, _e304.y, _e306.x, _e306.y), vec4<f32>(0f, 0f, 0f, 0f), (_e284 < vec4(f32(_e270.x)))), vec4<f32>(0f, 0f, 0f, 0f), (_e284 > vec4(f32(_e272.x))));
                                        let _e321 = max(_e277, max(max(_e313.x, _e313.y), max(_e313.z, _e313.w)));
                                        let _e322 = (_e281 + 4u);
                                        let _e323 = (_e322 > _e272.x);
                                        let _e326 = (_e279 + select(0u, 1u, _e323));
                                        phi_2433_ = _e321;
                                        phi_2432_ = _e326;
                                        phi_2429_ = select(_e322, _e274, _e323);
                                        local = _e321;
                                        if (_e326 <= _e272.y) {
                                            continue;
                                        } else {
                                            break;
                                        }
                                    }
                                    let _e330 = local;
                                    phi_2438_ = ((1f - _e195) > _e330);
                                    break;
                                }
                            }
                            let _e333 = phi_2438_;
                            phi_1577_ = _e333;
                        }
                        let _e335 = phi_1577_;
                        if _e335 {
                            let _e337 = global_2.member_9;
                            if (_e337 != 0u) {
                                let _e341 = atomicAdd((&global_1.member[1u]), 1u);
                            }
                            phi_2449_ = _e195;
                            phi_2440_ = _e155;
                            phi_2439_ = false;
                            break;
                        }
                        phi_2449_ = _e195;
                        phi_2440_ = _e155;
                        phi_2439_ = true;
                        break;
                    }
                }
                let _e343 = phi_2449_;
                let _e345 = phi_2440_;
                let _e347 = phi_2439_;
                if !(_e347) {
                    phi_2462_ = 4294967295u;
                    break;
                }
                let _e349 = f32(_e81);
                let _e351 = global.member_29;
                if (_e349 <= _e351) {
                    let _e354 = global_2.member_9;
                    if (_e354 != 0u) {
                        let _e358 = atomicAdd((&global_1.member[2u]), 1u);
                    }
                    phi_2462_ = 4294967295u;
                    break;
                }
                let _e362 = ((_e70 + (2u * _e66)) + (3u * _e64));
                let _e365 = global_4.member[_e362];
                let _e369 = global_4.member[(_e362 + 1u)];
                let _e373 = global_4.member[(_e362 + 2u)];
                let _e374 = vec3<u32>(_e365, _e369, _e373);
                let _e386 = vec3<f32>(_e123.x, _e123.y, _e123.z);
                let _e387 = (_e135 * 0.0009775171f);
                let _e391 = ((vec3<f32>((_e374 & vec3<u32>(2047u, 2047u, 2047u))) - vec3<f32>(1023f, 1023f, 1023f)) * _e387);
                let _e397 = ((vec3<f32>(((_e374 >> bitcast<vec3<u32>>(vec3<u32>(11u, 11u, 11u))) & vec3<u32>(2047u, 2047u, 2047u))) - vec3<f32>(1023f, 1023f, 1023f)) * _e387);
                let _e407 = mat3x3<f32>(vec3<f32>(_e391.x, _e397.x, _e397.y), vec3<f32>(0f, _e391.y, _e391.z), vec3<f32>(0f, 0f, _e397.z));
                switch bitcast<i32>(0u) {
                    default: {
                        let _e417 = global.member_2;
                        let _e419 = global.member_3;
                        let _e420 = clamp((_e125.xy / vec2(_e124)), _e417, _e419);
                        let _e423 = global.member[0u];
                        let _e429 = (((vec3<f32>(_e115.x, _e115.y, _e115.z) - (_e386 * _e420.x)) * (_e423 / _e124)) * _e407);
                        let _e432 = global.member[1u];
                        let _e438 = (((vec3<f32>(_e119.x, _e119.y, _e119.z) - (_e386 * _e420.y)) * (_e432 / _e124)) * _e407);
                        let _e440 = (dot(_e429, _e429) + 0.3f);
                        let _e441 = dot(_e429, _e438);
                        let _e443 = (dot(_e438, _e438) + 0.3f);
                        let _e445 = cross(_e429, _e438);
                        let _e447 = (_e440 + _e443);
                        let _e450 = (dot(_e445, _e445) + (0.3f * (_e447 - 0.3f)));
                        let _e451 = (_e450 > 0f);
                        phi_2031_ = _e451;
                        if _e451 {
                            phi_2031_ = (_e440 <= 1000000000000000000f);
                        }
                        let _e454 = phi_2031_;
                        phi_2037_ = _e454;
                        if _e454 {
                            phi_2037_ = (_e443 <= 1000000000000000000f);
                        }
                        let _e457 = phi_2037_;
                        if !(_e457) {
                            let _e460 = global_2.member_9;
                            if (_e460 != 0u) {
                                let _e464 = atomicAdd((&global_1.member[3u]), 1u);
                            }
                            phi_2461_ = 4294967295u;
                            break;
                        }
                        let _e466 = global.member_34;
                        let _e475 = (sqrt(vec3<f32>(_e440, _e441, _e443).xz) * sqrt((2f * log(max((max(_e349, _e466) / _e351), 1f)))));
                        let _e478 = all(((_e345 + _e475) > vec2<f32>(0f, 0f)));
                        phi_2062_ = _e478;
                        if _e478 {
                            let _e481 = global.member_4;
                            phi_2062_ = all(((_e345 - _e475) < _e481));
                        }
                        let _e485 = phi_2062_;
                        if !(_e485) {
                            let _e488 = global_2.member_9;
                            if (_e488 != 0u) {
                                let _e492 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_2461_ = 4294967295u;
                            break;
                        }
                        let _e495 = (0.5f * (_e440 - _e443));
                        let _e499 = sqrt(((_e495 * _e495) + (_e441 * _e441)));
                        let _e501 = ((0.5f * _e447) + _e499);
                        if (_e495 >= 0f) {
                            phi_2459_ = vec2<f32>((_e495 + _e499), _e441);
                        } else {
                            phi_2459_ = vec2<f32>(_e441, (_e499 - _e495));
                        }
                        let _e508 = phi_2459_;
                        let _e509 = length(_e508);
                        if (_e509 > 0f) {
                            phi_2460_ = (_e508 / vec2(_e509));
                        } else {
                            phi_2460_ = vec2<f32>(1f, 0f);
                        }
                        let _e514 = phi_2460_;
                        let _e521 = global.member_5;
                        let _e525 = global.member_10;
                        let _e529 = vec2<u32>(clamp(round(((_e345 + vec2(_e521)) * _e525)), vec2<f32>(0f, 0f), vec2<f32>(1048575f, 1048575f)));
                        let _e532 = vec3<u32>(round((clamp((vec3<f32>((_e374 >> bitcast<vec3<u32>>(vec3<u32>(22u, 22u, 22u)))) * vec3<f32>(0.0009775171f, 0.0009775171f, 0.0009775171f)), vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 1023f)));
                        let _e560 = global.member_45;
                        let _e562 = (4u * (_e560 + _e64));
                        global_4.member[_e562] = ((_e529.x | (_e532.x << bitcast<u32>(20u))) | (_e532.z << bitcast<u32>(30u)));
                        global_4.member[(_e562 + 1u)] = (_e529.y | (_e532.y << bitcast<u32>(20u)));
                        global_4.member[(_e562 + 2u)] = pack2x16float((_e514 * min(sqrt(_e501), 65504f)));
                        global_4.member[(_e562 + 3u)] = ((pack2x16float(vec2<f32>(min(sqrt((_e450 / _e501)), 65504f), 0f)) | (_e81 << bitcast<u32>(16u))) | ((_e532.z >> bitcast<u32>(2u)) << bitcast<u32>(24u)));
                        let _e575 = global.member_9;
                        phi_2461_ = min(u32((_e343 * f32(_e575))), _e575);
                        break;
                    }
                }
                let _e581 = phi_2461_;
                phi_2462_ = _e581;
                break;
            }
        }
        let _e583 = phi_2462_;
        phi_2463_ = _e583;
    } else {
        phi_2463_ = 4294967295u;
    }
    let _e585 = phi_2463_;
    switch bitcast<i32>(0u) {
        default: {
            let _e588 = bitcast<u32>(param[0u]);
            let _e590 = global.member_45;
            let _e591 = (_e590 + _e64);
            if (_e585 != 4294967295u) {
                let _e594 = global.member_40;
                let _e596 = global.member_41;
                let _e604 = atomicAdd((&global_1.member[((_e594 + ((_e591 / _e596) * 256u)) + (_e585 & 255u))]), 1u);
            }
            let _e606 = global.member_39;
            if (_e606 == 0u) {
                if (_e64 < (_e66 + (_e66 & 1u))) {
                    let _e612 = global.member_28;
                    global_4.member[(_e612 + _e591)] = _e585;
                }
                break;
            }
            global_5[_e588] = _e585;
            workgroupBarrier();
            let _e618 = ((_e588 & 1u) == 0u);
            if select(_e618, _e67, _e618) {
                let _e621 = global.member_28;
                let _e628 = global_5[(_e588 + 1u)];
                global_4.member[(_e621 + (_e591 >> bitcast<u32>(1u)))] = ((_e585 & 65535u) | (_e628 << bitcast<u32>(16u)));
            }
            break;
        }
    }
    return;
}
