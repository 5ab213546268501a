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
@group(0) @binding(1) 
var<storage> global_3: type_22;
@group(0) @binding(2) 
var<storage, read_write> global_4: type_19;
var<workgroup> global_5: array<u32, 64>;

@compute @workgroup_size(64, 1, 1) 
fn main(@builtin(local_invocation_id) param: vec3<u32>, @builtin(global_invocation_id) param_1: vec3<u32>) {
    var local: vec4<u32>;
    var phi_1479_: bool;
    var phi_2303_: f32;
    var phi_2304_: f32;
    var phi_2308_: u32;
    var phi_2313_: f32;
    var phi_2311_: u32;
    var phi_2318_: f32;
    var phi_2315_: u32;
    var local_1: f32;
    var phi_2319_: bool;
    var phi_1521_: bool;
    var phi_2330_: f32;
    var phi_2321_: vec2<f32>;
    var phi_2320_: bool;
    var phi_1930_: bool;
    var phi_1936_: bool;
    var phi_1961_: bool;
    var phi_2340_: vec2<f32>;
    var phi_2341_: vec2<f32>;
    var phi_2342_: u32;
    var phi_2343_: u32;
    var phi_2344_: u32;
    var phi_2345_: u32;
    var local_2: f32;

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
                            phi_2330_ = 0f;
                            phi_2321_ = vec2<f32>(0f, 0f);
                            phi_2320_ = false;
                            break;
                        }
                        let _e148 = global.member;
                        let _e149 = _e125.xy;
                        let _e151 = vec2(_e124);
                        let _e154 = global.member_1;
                        let _e155 = (((_e148 * _e149) / _e151) + _e154);
                        let _e157 = global.member_5;
                        let _e161 = all((_e155 >= vec2(-(_e157))));
                        phi_1479_ = _e161;
                        if _e161 {
                            let _e163 = global.member_4;
                            phi_1479_ = all((_e155 <= (_e163 + vec2(_e157))));
                        }
                        let _e169 = phi_1479_;
                        if !(_e169) {
                            let _e172 = global_2.member_9;
                            if (_e172 != 0u) {
                                let _e176 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_2330_ = 0f;
                            phi_2321_ = _e155;
                            phi_2320_ = false;
                            break;
                        }
                        let _e178 = global.member_7;
                        let _e181 = global.member_8;
                        let _e182 = ((_e178 - _e124) * _e181);
                        if (_e182 < 0f) {
                            phi_2304_ = (0.015625f / (1f - _e182));
                        } else {
                            if (_e182 > 1f) {
                                phi_2303_ = (1f - (0.015625f / _e182));
                            } else {
                                phi_2303_ = (0.015625f + (0.96875f * clamp(_e182, 0f, 1f)));
                            }
                            let _e193 = phi_2303_;
                            phi_2304_ = _e193;
                        }
                        let _e195 = phi_2304_;
                        let _e196 = (_e149 / _e151);
                        let _e204 = global.member[0u];
                        let _e207 = global.member[1u];
                        let _e212 = global.member_31;
                        let _e213 = (_e212 > 0u);
                        phi_1521_ = _e213;
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
                                        phi_2308_ = 0u;
                                    } else {
                                        phi_2308_ = (bitcast<u32>(firstLeadingBit((_e251 - 1u))) - 1u);
                                    }
                                    let _e258 = phi_2308_;
                                    if !((_e258 < 4u)) {
                                        phi_2319_ = false;
                                        break;
                                    }
                                    let _e267 = vec2(_e258);
                                    let _e269 = (_e238 >> bitcast<vec2<u32>>(_e267));
                                    let _e271 = (_e244 >> bitcast<vec2<u32>>(_e267));
                                    phi_2313_ = 0f;
                                    phi_2311_ = _e269.y;
                                    loop {
                                        let _e274 = phi_2313_;
                                        let _e276 = phi_2311_;
                                        local_1 = _e274;
                                        if (_e276 <= _e271.y) {
                                            phi_2318_ = _e274;
                                            phi_2315_ = _e269.x;
                                            loop {
                                                let _e281 = phi_2318_;
                                                let _e283 = phi_2315_;
                                                local_2 = _e281;
                                                if (_e283 <= _e271.x) {
                                                    continue;
                                                } else {
                                                    break;
                                                }
                                                continuing {
                                                    let _e290 = (((49152u - (((36864u >> bitcast<u32>((2u * _e258))) / 3u) * 4u)) + (_e276 * (192u >> bitcast<u32>(_e258)))) + _e283);
                                                    let _e292 = (_e212 + (_e290 / 2u));
                                                    let _e298 = global_3.member[(_e292 / 2u)][(_e292 & 1u)];
                                                    phi_2318_ = max(_e281, (f32(((_e298 >> bitcast<u32>((16u * (_e290 & 1u)))) & 65535u)) * 0.000015259022f));
                                                    phi_2315_ = (_e283 + bitcast<u32>(1i));
                                                }
                                            }
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e621 = local_2;
                                            phi_2313_ = _e621;
                                            phi_2311_ = (_e276 + bitcast<u32>(1i));
                                        }
                                    }
                                    let _e312 = local_1;
                                    phi_2319_ = ((1f - _e195) > _e312);
                                    break;
                                }
                            }
                            let _e315 = phi_2319_;
                            phi_1521_ = _e315;
                        }
                        let _e317 = phi_1521_;
                        if _e317 {
                            let _e319 = global_2.member_9;
                            if (_e319 != 0u) {
                                let _e323 = atomicAdd((&global_1.member[1u]), 1u);
                            }
                            phi_2330_ = _e195;
                            phi_2321_ = _e155;
                            phi_2320_ = false;
                            break;
                        }
                        phi_2330_ = _e195;
                        phi_2321_ = _e155;
                        phi_2320_ = true;
                        break;
                    }
                }
                let _e325 = phi_2330_;
                let _e327 = phi_2321_;
                let _e329 = phi_2320_;
                if !(_e329) {
                    phi_2344_ = 4294967295u;
                    break;
                }
                let _e331 = f32(_e81);
                let _e333 = global.member_29;
                if (_e331 <= _e333) {
                    let _e336 = global_2.member_9;
                    if (_e336 != 0u) {
                        let _e340 = atomicAdd((&global_1.member[2u]), 1u);
                    }
                    phi_2344_ = 4294967295u;
                    break;
                }
                let _e344 = ((_e70 + (2u * _e66)) + (3u * _e64));
                let _e347 = global_4.member[_e344];
                let _e351 = global_4.member[(_e344 + 1u)];
                let _e355 = global_4.member[(_e344 + 2u)];
                let _e356 = vec3<u32>(_e347, _e351, _e355);
                let _e368 = vec3<f32>(_e123.x, _e123.y, _e123.z);
                let _e369 = (_e135 * 0.0009775171f);
                let _e373 = ((vec3<f32>((_e356 & vec3<u32>(2047u, 2047u, 2047u))) - vec3<f32>(1023f, 1023f, 1023f)) * _e369);
                let _e379 = ((vec3<f32>(((_e356 >> bitcast<vec3<u32>>(vec3<u32>(11u, 11u, 11u))) & vec3<u32>(2047u, 2047u, 2047u))) - vec3<f32>(1023f, 1023f, 1023f)) * _e369);
                let _e389 = mat3x3<f32>(vec3<f32>(_e373.x, _e379.x, _e379.y), vec3<f32>(0f, _e373.y, _e373.z), vec3<f32>(0f, 0f, _e379.z));
                switch bitcast<i32>(0u) {
                    default: {
                        let _e399 = global.member_2;
                        let _e401 = global.member_3;
                        let _e402 = clamp((_e125.xy / vec2(_e124)), _e399, _e401);
                        let _e405 = global.member[0u];
                        let _e411 = (((vec3<f32>(_e115.x, _e115.y, _e115.z) - (_e368 * _e402.x)) * (_e405 / _e124)) * _e389);
                        let _e414 = global.member[1u];
                        let _e420 = (((vec3<f32>(_e119.x, _e119.y, _e119.z) - (_e368 * _e402.y)) * (_e414 / _e124)) * _e389);
                        let _e422 = (dot(_e411, _e411) + 0.3f);
                        let _e423 = dot(_e411, _e420);
                        let _e425 = (dot(_e420, _e420) + 0.3f);
                        let _e427 = cross(_e411, _e420);
                        let _e429 = (_e422 + _e425);
                        let _e432 = (dot(_e427, _e427) + (0.3f * (_e429 - 0.3f)));
                        let _e433 = (_e432 > 0f);
                        phi_1930_ = _e433;
                        if _e433 {
                            phi_1930_ = (_e422 <= 1000000000000000000f);
                        }
                        let _e436 = phi_1930_;
                        phi_1936_ = _e436;
                        if _e436 {
                            phi_1936_ = (_e425 <= 1000000000000000000f);
                        }
                        let _e439 = phi_1936_;
                        if !(_e439) {
                            let _e442 = global_2.member_9;
                            if (_e442 != 0u) {
                                let _e446 = atomicAdd((&global_1.member[3u]), 1u);
                            }
                            phi_2343_ = 4294967295u;
                            break;
                        }
                        let _e448 = global.member_34;
                        let _e457 = (sqrt(vec3<f32>(_e422, _e423, _e425).xz) * sqrt((2f * log(max((max(_e331, _e448) / _e333), 1f)))));
                        let _e460 = all(((_e327 + _e457) > vec2<f32>(0f, 0f)));
                        phi_1961_ = _e460;
                        if _e460 {
                            let _e463 = global.member_4;
                            phi_1961_ = all(((_e327 - _e457) < _e463));
                        }
                        let _e467 = phi_1961_;
                        if !(_e467) {
                            let _e470 = global_2.member_9;
                            if (_e470 != 0u) {
                                let _e474 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_2343_ = 4294967295u;
                            break;
                        }
                        let _e477 = (0.5f * (_e422 - _e425));
                        let _e481 = sqrt(((_e477 * _e477) + (_e423 * _e423)));
                        let _e483 = ((0.5f * _e429) + _e481);
                        if (_e477 >= 0f) {
                            phi_2340_ = vec2<f32>((_e477 + _e481), _e423);
                        } else {
                            phi_2340_ = vec2<f32>(_e423, (_e481 - _e477));
                        }
                        let _e490 = phi_2340_;
                        let _e491 = length(_e490);
                        if (_e491 > 0f) {
                            phi_2341_ = (_e490 / vec2(_e491));
                        } else {
                            phi_2341_ = vec2<f32>(1f, 0f);
                        }
                        let _e496 = phi_2341_;
                        let _e503 = global.member_5;
                        let _e507 = global.member_10;
                        let _e511 = vec2<u32>(clamp(round(((_e327 + vec2(_e503)) * _e507)), vec2<f32>(0f, 0f), vec2<f32>(1048575f, 1048575f)));
                        let _e514 = vec3<u32>(round((clamp((vec3<f32>((_e356 >> bitcast<vec3<u32>>(vec3<u32>(22u, 22u, 22u)))) * vec3<f32>(0.0009775171f, 0.0009775171f, 0.0009775171f)), vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 1023f)));
                        local = vec4<u32>(((_e511.x | (_e514.x << bitcast<u32>(20u))) | (_e514.z << bitcast<u32>(30u))), (_e511.y | (_e514.y << bitcast<u32>(20u))), pack2x16float((_e496 * min(sqrt(_e483), 65504f))), ((pack2x16float(vec2<f32>(min(sqrt((_e432 / _e483)), 65504f), 0f)) | (_e81 << bitcast<u32>(16u))) | ((_e514.z >> bitcast<u32>(2u)) << bitcast<u32>(24u))));
                        phi_2342_ = 0u;
                        loop {
                            let _e543 = phi_2342_;
                            if (_e543 < 4u) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e546 = global.member_45;
                                let _e551 = local[_e543];
                                global_4.member[((4u * (_e546 + _e64)) + _e543)] = _e551;
                                phi_2342_ = (_e543 + bitcast<u32>(1i));
                            }
                        }
                        let _e557 = global.member_9;
                        phi_2343_ = min(u32((_e325 * f32(_e557))), _e557);
                        break;
                    }
                }
                let _e563 = phi_2343_;
                phi_2344_ = _e563;
                break;
            }
        }
        let _e565 = phi_2344_;
        phi_2345_ = _e565;
    } else {
        phi_2345_ = 4294967295u;
    }
    let _e567 = phi_2345_;
    switch bitcast<i32>(0u) {
        default: {
            let _e570 = bitcast<u32>(param[0u]);
            let _e572 = global.member_45;
            let _e573 = (_e572 + _e64);
            if (_e567 != 4294967295u) {
                let _e576 = global.member_40;
                let _e578 = global.member_41;
                let _e586 = atomicAdd((&global_1.member[((_e576 + ((_e573 / _e578) * 256u)) + (_e567 & 255u))]), 1u);
            }
            let _e588 = global.member_39;
            if (_e588 == 0u) {
                if (_e64 < (_e66 + (_e66 & 1u))) {
                    let _e594 = global.member_28;
                    global_4.member[(_e594 + _e573)] = _e567;
                }
                break;
            }
            global_5[_e570] = _e567;
            workgroupBarrier();
            let _e600 = ((_e570 & 1u) == 0u);
            if select(_e600, _e67, _e600) {
                let _e603 = global.member_28;
                let _e609 = global_5[(_e570 + 1u)];
                global_4.member[(_e603 + (_e573 / 2u))] = ((_e567 & 65535u) | (_e609 << bitcast<u32>(16u)));
            }
            break;
        }
    }
    return;
}
