struct type_11 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_15 {
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
    member_32: f32,
    member_33: f32,
    member_34: u32,
    member_35: u32,
    member_36: u32,
    member_37: u32,
    member_38: u32,
    member_39: f32,
    member_40: u32,
    member_41: u32,
    member_42: f32,
    member_43: u32,
    member_44: u32,
    member_45: f32,
    member_46: u32,
    member_47: f32,
    member_48: f32,
    member_49: f32,
    member_50: vec4<f32>,
    member_51: vec4<f32>,
    member_52: vec4<f32>,
    member_53: array<vec4<f32>, 3>,
    member_54: array<vec4<u32>, 8>,
    member_55: array<vec4<u32>, 8>,
    member_56: array<type_11, 8>,
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
    member_11: u32,
    member_12: u32,
    member_13: u32,
    member_14: u32,
}

struct type_24 {
    member: array<atomic<u32>>,
}

struct type_26 {
    member: array<atomic<u32>, LENGTH_6_4>,
}

struct type_28 {
    member: array<u32, LENGTH_1_4>,
}

@group(0) @binding(0) 
var<uniform> global: type_15;
@group(0) @binding(6) 
var<storage, read_write> global_1: type_26;
@group(0) @binding(7) 
var<uniform> global_2: type_20;
@group(0) @binding(1) 
var<storage, read_write> global_3: type_28;
var<workgroup> global_4: array<u32, 64>;

@compute @workgroup_size(64, 1, 1) 
fn main(@builtin(local_invocation_id) param: vec3<u32>, @builtin(global_invocation_id) param_1: vec3<u32>) {
    var phi_1375_: bool;
    var phi_2084_: f32;
    var phi_2085_: f32;
    var phi_2093_: f32;
    var phi_2087_: vec2<f32>;
    var phi_2086_: bool;
    var phi_1626_: bool;
    var phi_1632_: bool;
    var phi_2101_: f32;
    var phi_2100_: u32;
    var local: f32;
    var phi_2109_: u32;
    var phi_1710_: bool;
    var phi_2113_: vec2<f32>;
    var phi_2114_: vec2<f32>;
    var phi_2115_: u32;
    var phi_2116_: u32;
    var phi_2117_: u32;

    let _e59 = bitcast<u32>(param_1[0u]);
    let _e61 = global.member_44;
    let _e62 = (_e59 < _e61);
    if _e62 {
        switch bitcast<i32>(0u) {
            default: {
                let _e65 = global.member_38;
                let _e67 = (_e65 + (3u * _e59));
                let _e70 = global_3.member[_e67];
                let _e74 = global_3.member[(_e67 + 1u)];
                let _e78 = global_3.member[(_e67 + 2u)];
                let _e96 = global.member_51;
                let _e99 = global.member_52;
                let _e102 = (vec3<f32>(((vec3<u32>((_e70 & 65535u), (_e70 >> bitcast<u32>(16u)), (_e74 & 65535u)) << bitcast<vec3<u32>>(vec3<u32>(8u, 8u, 8u))) | (vec3<u32>(_e78, (_e78 >> bitcast<u32>(8u)), (_e78 >> bitcast<u32>(16u))) & vec3<u32>(255u, 255u, 255u)))) * vec3<f32>(0.00000005960465f, 0.00000005960465f, 0.00000005960465f));
                let _e116 = (_e96.xyz + (_e99.xyz * select(select(((_e102 - vec3<f32>(0.015625f, 0.015625f, 0.015625f)) * vec3<f32>(1.032258f, 1.032258f, 1.032258f)), (vec3<f32>(1f, 1f, 1f) - (vec3<f32>(0.015625f, 0.015625f, 0.015625f) / max(_e102, vec3<f32>(0.000000029802326f, 0.000000029802326f, 0.000000029802326f)))), (_e102 < vec3<f32>(0.015625f, 0.015625f, 0.015625f))), (vec3<f32>(0.015625f, 0.015625f, 0.015625f) / max((vec3<f32>(1f, 1f, 1f) - _e102), vec3<f32>(0.000000029802326f, 0.000000029802326f, 0.000000029802326f))), (_e102 > vec3<f32>(0.984375f, 0.984375f, 0.984375f)))));
                let _e120 = vec4<f32>(_e116.x, _e116.y, _e116.z, 1f);
                let _e123 = global.member_53[0i];
                let _e127 = global.member_53[1i];
                let _e131 = global.member_53[2i];
                let _e132 = dot(_e131, _e120);
                let _e133 = vec3<f32>(dot(_e123, _e120), dot(_e127, _e120), _e132);
                switch bitcast<i32>(0u) {
                    default: {
                        let _e136 = global.member_6;
                        if !((_e132 >= _e136)) {
                            let _e140 = global_2.member_9;
                            if (_e140 != 0u) {
                                let _e144 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_2093_ = 0f;
                            phi_2087_ = vec2<f32>(0f, 0f);
                            phi_2086_ = false;
                            break;
                        }
                        let _e146 = global.member;
                        let _e152 = global.member_1;
                        let _e153 = (((_e146 * _e133.xy) / vec2(_e132)) + _e152);
                        let _e155 = global.member_5;
                        let _e159 = all((_e153 >= vec2(-(_e155))));
                        phi_1375_ = _e159;
                        if _e159 {
                            let _e161 = global.member_4;
                            phi_1375_ = all((_e153 <= (_e161 + vec2(_e155))));
                        }
                        let _e167 = phi_1375_;
                        if !(_e167) {
                            let _e170 = global_2.member_9;
                            if (_e170 != 0u) {
                                let _e174 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_2093_ = 0f;
                            phi_2087_ = _e153;
                            phi_2086_ = false;
                            break;
                        }
                        let _e176 = global.member_7;
                        let _e179 = global.member_8;
                        let _e180 = ((_e176 - _e132) * _e179);
                        if (_e180 < 0f) {
                            phi_2085_ = (0.015625f / (1f - _e180));
                        } else {
                            if (_e180 > 1f) {
                                phi_2084_ = (1f - (0.015625f / _e180));
                            } else {
                                phi_2084_ = (0.015625f + (0.96875f * clamp(_e180, 0f, 1f)));
                            }
                            let _e191 = phi_2084_;
                            phi_2085_ = _e191;
                        }
                        let _e193 = phi_2085_;
                        phi_2093_ = _e193;
                        phi_2087_ = _e153;
                        phi_2086_ = true;
                        break;
                    }
                }
                let _e195 = phi_2093_;
                let _e197 = phi_2087_;
                let _e199 = phi_2086_;
                if !(_e199) {
                    phi_2116_ = 4294967295u;
                    break;
                }
                let _e201 = f32((_e74 >> bitcast<u32>(24u)));
                let _e203 = global.member_29;
                if (_e201 <= _e203) {
                    let _e206 = global_2.member_9;
                    if (_e206 != 0u) {
                        let _e210 = atomicAdd((&global_1.member[1u]), 1u);
                    }
                    phi_2116_ = 4294967295u;
                    break;
                }
                let _e213 = (_e65 + (3u * (_e61 + _e59)));
                let _e216 = global_3.member[_e213];
                let _e220 = global_3.member[(_e213 + 1u)];
                let _e224 = global_3.member[(_e213 + 2u)];
                let _e225 = vec3<u32>(_e216, _e220, _e224);
                let _e237 = vec3<f32>(_e131.x, _e131.y, _e131.z);
                let _e239 = global.member_39;
                let _e248 = ((_e239 * exp2(((f32(((_e74 >> bitcast<u32>(16u)) & 255u)) * 0.125f) - 19f))) * 0.0009775171f);
                let _e252 = ((vec3<f32>((_e225 & vec3<u32>(2047u, 2047u, 2047u))) - vec3<f32>(1023f, 1023f, 1023f)) * _e248);
                let _e258 = ((vec3<f32>(((_e225 >> bitcast<vec3<u32>>(vec3<u32>(11u, 11u, 11u))) & vec3<u32>(2047u, 2047u, 2047u))) - vec3<f32>(1023f, 1023f, 1023f)) * _e248);
                let _e268 = mat3x3<f32>(vec3<f32>(_e252.x, _e258.x, _e258.y), vec3<f32>(0f, _e252.y, _e252.z), vec3<f32>(0f, 0f, _e258.z));
                switch bitcast<i32>(0u) {
                    default: {
                        let _e278 = global.member_2;
                        let _e280 = global.member_3;
                        let _e281 = clamp((_e133.xy / vec2(_e132)), _e278, _e280);
                        let _e284 = global.member[0u];
                        let _e290 = (((vec3<f32>(_e123.x, _e123.y, _e123.z) - (_e237 * _e281.x)) * (_e284 / _e132)) * _e268);
                        let _e293 = global.member[1u];
                        let _e299 = (((vec3<f32>(_e127.x, _e127.y, _e127.z) - (_e237 * _e281.y)) * (_e293 / _e132)) * _e268);
                        let _e301 = global.member_47;
                        let _e303 = (dot(_e290, _e290) + _e301);
                        let _e306 = (dot(_e299, _e299) + _e301);
                        let _e308 = cross(_e290, _e299);
                        let _e309 = dot(_e308, _e308);
                        let _e313 = (_e309 + (_e301 * ((_e303 + _e306) - _e301)));
                        let _e314 = (_e313 > 0f);
                        phi_1626_ = _e314;
                        if _e314 {
                            phi_1626_ = (_e303 <= 1000000000000000000f);
                        }
                        let _e317 = phi_1626_;
                        phi_1632_ = _e317;
                        if _e317 {
                            phi_1632_ = (_e306 <= 1000000000000000000f);
                        }
                        let _e320 = phi_1632_;
                        if !(_e320) {
                            let _e323 = global_2.member_9;
                            if (_e323 != 0u) {
                                let _e327 = atomicAdd((&global_1.member[2u]), 1u);
                            }
                            phi_2115_ = 4294967295u;
                            break;
                        }
                        phi_2101_ = (1f - (_e201 * 0.003921569f));
                        phi_2100_ = 0u;
                        loop {
                            let _e331 = phi_2101_;
                            let _e333 = phi_2100_;
                            let _e335 = global.member_43;
                            local = _e331;
                            if (_e333 < _e335) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                phi_2101_ = (_e331 * _e331);
                                phi_2100_ = (_e333 + bitcast<u32>(1i));
                            }
                        }
                        let _e341 = local;
                        let _e345 = u32(round((255f * (1f - _e341))));
                        let _e347 = global.member_48;
                        phi_2109_ = _e345;
                        if (_e347 > 0f) {
                            let _e357 = u32(round((f32(_e345) * ((1f - _e347) + (_e347 * sqrt((_e309 / _e313)))))));
                            if (f32(_e357) <= _e203) {
                                let _e361 = global_2.member_9;
                                if (_e361 != 0u) {
                                    let _e365 = atomicAdd((&global_1.member[1u]), 1u);
                                }
                                phi_2115_ = 4294967295u;
                                break;
                            }
                            phi_2109_ = _e357;
                        }
                        let _e367 = phi_2109_;
                        let _e369 = global.member_45;
                        let _e370 = (vec3<f32>(_e303, dot(_e290, _e299), _e306) * _e369);
                        let _e383 = global.member_49;
                        let _e384 = ((sqrt(_e370.xz) * sqrt((2f * log(max((f32(_e367) / _e203), 1f))))) * _e383);
                        let _e387 = global.member_50;
                        let _e390 = all(((_e197 + _e384) > _e387.xy));
                        phi_1710_ = _e390;
                        if _e390 {
                            phi_1710_ = all(((_e197 - _e384) < _e387.zw));
                        }
                        let _e396 = phi_1710_;
                        if !(_e396) {
                            let _e399 = global_2.member_9;
                            if (_e399 != 0u) {
                                let _e403 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_2115_ = 4294967295u;
                            break;
                        }
                        let _e408 = (0.5f * (_e370.x - _e370.z));
                        let _e413 = sqrt(((_e408 * _e408) + (_e370.y * _e370.y)));
                        let _e416 = ((0.5f * (_e370.x + _e370.z)) + _e413);
                        if (_e408 >= 0f) {
                            phi_2113_ = vec2<f32>((_e408 + _e413), _e370.y);
                        } else {
                            phi_2113_ = vec2<f32>(_e370.y, (_e413 - _e408));
                        }
                        let _e423 = phi_2113_;
                        if (_e413 > (0.00000001f * _e416)) {
                            phi_2114_ = normalize(_e423);
                        } else {
                            phi_2114_ = vec2<f32>(1f, 0f);
                        }
                        let _e428 = phi_2114_;
                        let _e435 = global.member_5;
                        let _e439 = global.member_10;
                        let _e443 = vec2<u32>(clamp(round(((_e197 + vec2(_e435)) * _e439)), vec2<f32>(0f, 0f), vec2<f32>(1048575f, 1048575f)));
                        let _e446 = vec3<u32>(round((clamp((vec3<f32>((_e225 >> bitcast<vec3<u32>>(vec3<u32>(22u, 22u, 22u)))) * vec3<f32>(0.0009775171f, 0.0009775171f, 0.0009775171f)), vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 1023f)));
                        let _e474 = global.member_41;
                        let _e476 = (4u * (_e474 + _e59));
                        global_3.member[_e476] = ((_e443.x | (_e446.x << bitcast<u32>(20u))) | (_e446.z << bitcast<u32>(30u)));
                        global_3.member[(_e476 + 1u)] = (_e443.y | (_e446.y << bitcast<u32>(20u)));
                        global_3.member[(_e476 + 2u)] = pack2x16float((_e428 * min(sqrt(_e416), 65504f)));
                        global_3.member[(_e476 + 3u)] = ((pack2x16float(vec2<f32>(min(sqrt(((_e313 * (_e369 * _e369)) / _e416)), 65504f), 0f)) | (_e367 << bitcast<u32>(16u))) | ((_e446.z >> bitcast<u32>(2u)) << bitcast<u32>(24u)));
                        let _e489 = global.member_9;
                        phi_2115_ = min(u32((_e195 * f32(_e489))), _e489);
                        break;
                    }
                }
                let _e495 = phi_2115_;
                phi_2116_ = _e495;
                break;
            }
        }
        let _e497 = phi_2116_;
        phi_2117_ = _e497;
    } else {
        phi_2117_ = 4294967295u;
    }
    let _e499 = phi_2117_;
    switch bitcast<i32>(0u) {
        default: {
            let _e502 = bitcast<u32>(param[0u]);
            let _e504 = global.member_41;
            let _e505 = (_e504 + _e59);
            if (_e499 != 4294967295u) {
                let _e508 = global.member_37;
                let _e512 = global.member_36;
                let _e518 = atomicAdd((&global_1.member[((_e512 + ((_e505 / _e508) * 256u)) + (_e499 & 255u))]), 1u);
            }
            let _e520 = global.member_35;
            if (_e520 == 0u) {
                if (_e59 < (_e61 + (_e61 & 1u))) {
                    let _e526 = global.member_28;
                    global_3.member[(_e526 + _e505)] = _e499;
                }
                break;
            }
            global_4[_e502] = _e499;
            workgroupBarrier();
            let _e532 = ((_e502 & 1u) == 0u);
            if select(_e532, _e62, _e532) {
                let _e535 = global.member_28;
                let _e542 = global_4[(_e502 + 1u)];
                global_3.member[(_e535 + (_e505 >> bitcast<u32>(1u)))] = ((_e499 & 65535u) | (_e542 << bitcast<u32>(16u)));
            }
            break;
        }
    }
    return;
}
