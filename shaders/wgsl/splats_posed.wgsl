struct type_13 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_17 {
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
    member_52: array<type_13, 8>,
    member_53: array<vec4<f32>, 128>,
    member_54: array<vec4<f32>, 768>,
}

struct type_24 {
    member: array<u32>,
}

struct type_28 {
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

struct type_31 {
    member: array<vec2<u32>>,
}

struct type_43 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<uniform> global: type_17;
@group(0) @binding(6) 
var<storage, read_write> global_1: type_43;
@group(0) @binding(7) 
var<uniform> global_2: type_28;
@group(0) @binding(1) 
var<storage> global_3: type_31;
@group(0) @binding(2) 
var<storage, read_write> global_4: type_24;
var<private> global_5: vec3<u32>;
var<workgroup> global_6: array<u32, 64>;
var<private> global_7: vec3<u32>;

fn function_() {
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

    let _e102 = global_7[0u];
    let _e104 = global.member_14;
    let _e105 = (_e102 < _e104);
    if _e105 {
        switch bitcast<i32>(0u) {
            default: {
                let _e108 = global.member_42;
                let _e110 = (_e108 + (2u * _e102));
                let _e113 = global_4.member[_e110];
                let _e117 = global_4.member[(_e110 + 1u)];
                let _e119 = (_e117 >> bitcast<u32>(24u));
                let _e121 = global.member_47;
                let _e124 = global.member_48;
                let _e132 = (vec3<f32>(vec3<u32>((_e113 & 65535u), (_e113 >> bitcast<u32>(16u)), (_e117 & 65535u))) * vec3<f32>(0.000015259022f, 0.000015259022f, 0.000015259022f));
                let _e146 = (_e121.xyz + (_e124.xyz * select(select(((_e132 - vec3<f32>(0.015625f, 0.015625f, 0.015625f)) * vec3<f32>(1.032258f, 1.032258f, 1.032258f)), (vec3<f32>(1f, 1f, 1f) - (vec3<f32>(0.015625f, 0.015625f, 0.015625f) / max(_e132, vec3<f32>(0.000007629511f, 0.000007629511f, 0.000007629511f)))), (_e132 < vec3<f32>(0.015625f, 0.015625f, 0.015625f))), (vec3<f32>(0.015625f, 0.015625f, 0.015625f) / max((vec3<f32>(1f, 1f, 1f) - _e132), vec3<f32>(0.000007629511f, 0.000007629511f, 0.000007629511f))), (_e132 > vec3<f32>(0.984375f, 0.984375f, 0.984375f)))));
                let _e150 = vec4<f32>(_e146.x, _e146.y, _e146.z, 1f);
                let _e153 = global.member_49[0i];
                let _e157 = global.member_49[1i];
                let _e161 = global.member_49[2i];
                let _e162 = dot(_e161, _e150);
                let _e163 = vec3<f32>(dot(_e153, _e150), dot(_e157, _e150), _e162);
                let _e165 = global.member_43;
                let _e173 = (_e165 * exp2(((f32(((_e117 >> bitcast<u32>(16u)) & 255u)) * 0.125f) - 19f)));
                switch bitcast<i32>(0u) {
                    default: {
                        let _e176 = global.member_6;
                        if !((_e162 >= _e176)) {
                            let _e180 = global_2.member_9;
                            if (_e180 != 0u) {
                                let _e184 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_2330_ = 0f;
                            phi_2321_ = vec2<f32>(0f, 0f);
                            phi_2320_ = false;
                            break;
                        }
                        let _e186 = global.member;
                        let _e187 = _e163.xy;
                        let _e189 = vec2(_e162);
                        let _e192 = global.member_1;
                        let _e193 = (((_e186 * _e187) / _e189) + _e192);
                        let _e195 = global.member_5;
                        let _e199 = all((_e193 >= vec2(-(_e195))));
                        phi_1479_ = _e199;
                        if _e199 {
                            let _e201 = global.member_4;
                            phi_1479_ = all((_e193 <= (_e201 + vec2(_e195))));
                        }
                        let _e207 = phi_1479_;
                        if !(_e207) {
                            let _e210 = global_2.member_9;
                            if (_e210 != 0u) {
                                let _e214 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_2330_ = 0f;
                            phi_2321_ = _e193;
                            phi_2320_ = false;
                            break;
                        }
                        let _e216 = global.member_7;
                        let _e219 = global.member_8;
                        let _e220 = ((_e216 - _e162) * _e219);
                        if (_e220 < 0f) {
                            phi_2304_ = (0.015625f / (1f - _e220));
                        } else {
                            if (_e220 > 1f) {
                                phi_2303_ = (1f - (0.015625f / _e220));
                            } else {
                                phi_2303_ = (0.015625f + (0.96875f * clamp(_e220, 0f, 1f)));
                            }
                            let _e231 = phi_2303_;
                            phi_2304_ = _e231;
                        }
                        let _e233 = phi_2304_;
                        let _e234 = (_e187 / _e189);
                        let _e242 = global.member[0u];
                        let _e245 = global.member[1u];
                        let _e250 = global.member_31;
                        let _e251 = (_e250 > 0u);
                        phi_1521_ = _e251;
                        if _e251 {
                            let _e253 = global.member_34;
                            let _e256 = global.member_29;
                            switch bitcast<i32>(0u) {
                                default: {
                                    let _e266 = vec2((sqrt((2f * log(max((max(255f, _e253) / _e256), 1f)))) * ((((_e173 * length(vec3<f32>(_e234.x, _e234.y, 1f))) * max(_e242, _e245)) / _e162) + 0.5477226f)));
                                    let _e269 = global.member_32;
                                    let _e272 = global.member_33;
                                    let _e276 = vec2<u32>(clamp(((((_e193 - _e266) - _e269) * _e272) - vec2<f32>(0.5f, 0.5f)), vec2<f32>(0f, 0f), vec2<f32>(191f, 191f)));
                                    let _e282 = vec2<u32>(clamp(((((_e193 + _e266) - _e269) * _e272) + vec2<f32>(0.5f, 0.5f)), vec2<f32>(0f, 0f), vec2<f32>(191f, 191f)));
                                    let _e289 = max((_e282.x - _e276.x), (_e282.y - _e276.y));
                                    if (_e289 <= 3u) {
                                        phi_2308_ = 0u;
                                    } else {
                                        phi_2308_ = (bitcast<u32>(firstLeadingBit((_e289 - 1u))) - 1u);
                                    }
                                    let _e296 = phi_2308_;
                                    if !((_e296 < 4u)) {
                                        phi_2319_ = false;
                                        break;
                                    }
                                    let _e305 = vec2(_e296);
                                    let _e307 = (_e276 >> bitcast<vec2<u32>>(_e305));
                                    let _e309 = (_e282 >> bitcast<vec2<u32>>(_e305));
                                    phi_2313_ = 0f;
                                    phi_2311_ = _e307.y;
                                    loop {
                                        let _e312 = phi_2313_;
                                        let _e314 = phi_2311_;
                                        local_1 = _e312;
                                        if (_e314 <= _e309.y) {
                                            phi_2318_ = _e312;
                                            phi_2315_ = _e307.x;
                                            loop {
                                                let _e319 = phi_2318_;
                                                let _e321 = phi_2315_;
                                                local_2 = _e319;
                                                if (_e321 <= _e309.x) {
                                                    continue;
                                                } else {
                                                    break;
                                                }
                                                continuing {
                                                    let _e328 = (((49152u - (((36864u >> bitcast<u32>((2u * _e296))) / 3u) * 4u)) + (_e314 * (192u >> bitcast<u32>(_e296)))) + _e321);
                                                    let _e330 = (_e250 + (_e328 / 2u));
                                                    let _e336 = global_3.member[(_e330 / 2u)][(_e330 & 1u)];
                                                    phi_2318_ = max(_e319, (f32(((_e336 >> bitcast<u32>((16u * (_e328 & 1u)))) & 65535u)) * 0.000015259022f));
                                                    phi_2315_ = (_e321 + bitcast<u32>(1i));
                                                }
                                            }
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e659 = local_2;
                                            phi_2313_ = _e659;
                                            phi_2311_ = (_e314 + bitcast<u32>(1i));
                                        }
                                    }
                                    let _e350 = local_1;
                                    phi_2319_ = ((1f - _e233) > _e350);
                                    break;
                                }
                            }
                            let _e353 = phi_2319_;
                            phi_1521_ = _e353;
                        }
                        let _e355 = phi_1521_;
                        if _e355 {
                            let _e357 = global_2.member_9;
                            if (_e357 != 0u) {
                                let _e361 = atomicAdd((&global_1.member[1u]), 1u);
                            }
                            phi_2330_ = _e233;
                            phi_2321_ = _e193;
                            phi_2320_ = false;
                            break;
                        }
                        phi_2330_ = _e233;
                        phi_2321_ = _e193;
                        phi_2320_ = true;
                        break;
                    }
                }
                let _e363 = phi_2330_;
                let _e365 = phi_2321_;
                let _e367 = phi_2320_;
                if !(_e367) {
                    phi_2344_ = 4294967295u;
                    break;
                }
                let _e369 = f32(_e119);
                let _e371 = global.member_29;
                if (_e369 <= _e371) {
                    let _e374 = global_2.member_9;
                    if (_e374 != 0u) {
                        let _e378 = atomicAdd((&global_1.member[2u]), 1u);
                    }
                    phi_2344_ = 4294967295u;
                    break;
                }
                let _e382 = ((_e108 + (2u * _e104)) + (3u * _e102));
                let _e385 = global_4.member[_e382];
                let _e389 = global_4.member[(_e382 + 1u)];
                let _e393 = global_4.member[(_e382 + 2u)];
                let _e394 = vec3<u32>(_e385, _e389, _e393);
                let _e406 = vec3<f32>(_e161.x, _e161.y, _e161.z);
                let _e407 = (_e173 * 0.0009775171f);
                let _e411 = ((vec3<f32>((_e394 & vec3<u32>(2047u, 2047u, 2047u))) - vec3<f32>(1023f, 1023f, 1023f)) * _e407);
                let _e417 = ((vec3<f32>(((_e394 >> bitcast<vec3<u32>>(vec3<u32>(11u, 11u, 11u))) & vec3<u32>(2047u, 2047u, 2047u))) - vec3<f32>(1023f, 1023f, 1023f)) * _e407);
                let _e427 = mat3x3<f32>(vec3<f32>(_e411.x, _e417.x, _e417.y), vec3<f32>(0f, _e411.y, _e411.z), vec3<f32>(0f, 0f, _e417.z));
                switch bitcast<i32>(0u) {
                    default: {
                        let _e437 = global.member_2;
                        let _e439 = global.member_3;
                        let _e440 = clamp((_e163.xy / vec2(_e162)), _e437, _e439);
                        let _e443 = global.member[0u];
                        let _e449 = (((vec3<f32>(_e153.x, _e153.y, _e153.z) - (_e406 * _e440.x)) * (_e443 / _e162)) * _e427);
                        let _e452 = global.member[1u];
                        let _e458 = (((vec3<f32>(_e157.x, _e157.y, _e157.z) - (_e406 * _e440.y)) * (_e452 / _e162)) * _e427);
                        let _e460 = (dot(_e449, _e449) + 0.3f);
                        let _e461 = dot(_e449, _e458);
                        let _e463 = (dot(_e458, _e458) + 0.3f);
                        let _e465 = cross(_e449, _e458);
                        let _e467 = (_e460 + _e463);
                        let _e470 = (dot(_e465, _e465) + (0.3f * (_e467 - 0.3f)));
                        let _e471 = (_e470 > 0f);
                        phi_1930_ = _e471;
                        if _e471 {
                            phi_1930_ = (_e460 <= 1000000000000000000f);
                        }
                        let _e474 = phi_1930_;
                        phi_1936_ = _e474;
                        if _e474 {
                            phi_1936_ = (_e463 <= 1000000000000000000f);
                        }
                        let _e477 = phi_1936_;
                        if !(_e477) {
                            let _e480 = global_2.member_9;
                            if (_e480 != 0u) {
                                let _e484 = atomicAdd((&global_1.member[3u]), 1u);
                            }
                            phi_2343_ = 4294967295u;
                            break;
                        }
                        let _e486 = global.member_34;
                        let _e495 = (sqrt(vec3<f32>(_e460, _e461, _e463).xz) * sqrt((2f * log(max((max(_e369, _e486) / _e371), 1f)))));
                        let _e498 = all(((_e365 + _e495) > vec2<f32>(0f, 0f)));
                        phi_1961_ = _e498;
                        if _e498 {
                            let _e501 = global.member_4;
                            phi_1961_ = all(((_e365 - _e495) < _e501));
                        }
                        let _e505 = phi_1961_;
                        if !(_e505) {
                            let _e508 = global_2.member_9;
                            if (_e508 != 0u) {
                                let _e512 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_2343_ = 4294967295u;
                            break;
                        }
                        let _e515 = (0.5f * (_e460 - _e463));
                        let _e519 = sqrt(((_e515 * _e515) + (_e461 * _e461)));
                        let _e521 = ((0.5f * _e467) + _e519);
                        if (_e515 >= 0f) {
                            phi_2340_ = vec2<f32>((_e515 + _e519), _e461);
                        } else {
                            phi_2340_ = vec2<f32>(_e461, (_e519 - _e515));
                        }
                        let _e528 = phi_2340_;
                        let _e529 = length(_e528);
                        if (_e529 > 0f) {
                            phi_2341_ = (_e528 / vec2(_e529));
                        } else {
                            phi_2341_ = vec2<f32>(1f, 0f);
                        }
                        let _e534 = phi_2341_;
                        let _e541 = global.member_5;
                        let _e545 = global.member_10;
                        let _e549 = vec2<u32>(clamp(round(((_e365 + vec2(_e541)) * _e545)), vec2<f32>(0f, 0f), vec2<f32>(1048575f, 1048575f)));
                        let _e552 = vec3<u32>(round((clamp((vec3<f32>((_e394 >> bitcast<vec3<u32>>(vec3<u32>(22u, 22u, 22u)))) * vec3<f32>(0.0009775171f, 0.0009775171f, 0.0009775171f)), vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 1023f)));
                        local = vec4<u32>(((_e549.x | (_e552.x << bitcast<u32>(20u))) | (_e552.z << bitcast<u32>(30u))), (_e549.y | (_e552.y << bitcast<u32>(20u))), pack2x16float((_e534 * min(sqrt(_e521), 65504f))), ((pack2x16float(vec2<f32>(min(sqrt((_e470 / _e521)), 65504f), 0f)) | (_e119 << bitcast<u32>(16u))) | ((_e552.z >> bitcast<u32>(2u)) << bitcast<u32>(24u))));
                        phi_2342_ = 0u;
                        loop {
                            let _e581 = phi_2342_;
                            if (_e581 < 4u) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                let _e584 = global.member_45;
                                let _e589 = local[_e581];
                                global_4.member[((4u * (_e584 + _e102)) + _e581)] = _e589;
                                phi_2342_ = (_e581 + bitcast<u32>(1i));
                            }
                        }
                        let _e595 = global.member_9;
                        phi_2343_ = min(u32((_e363 * f32(_e595))), _e595);
                        break;
                    }
                }
                let _e601 = phi_2343_;
                phi_2344_ = _e601;
                break;
            }
        }
        let _e603 = phi_2344_;
        phi_2345_ = _e603;
    } else {
        phi_2345_ = 4294967295u;
    }
    let _e605 = phi_2345_;
    switch bitcast<i32>(0u) {
        default: {
            let _e608 = global_5[0u];
            let _e610 = global.member_45;
            let _e611 = (_e610 + _e102);
            if (_e605 != 4294967295u) {
                let _e614 = global.member_40;
                let _e616 = global.member_41;
                let _e624 = atomicAdd((&global_1.member[((_e614 + ((_e611 / _e616) * 256u)) + (_e605 & 255u))]), 1u);
            }
            let _e626 = global.member_39;
            if (_e626 == 0u) {
                if (_e102 < (_e104 + (_e104 & 1u))) {
                    let _e632 = global.member_28;
                    global_4.member[(_e632 + _e611)] = _e605;
                }
                break;
            }
            global_6[_e608] = _e605;
            workgroupBarrier();
            let _e638 = ((_e608 & 1u) == 0u);
            if select(_e638, _e105, _e638) {
                let _e641 = global.member_28;
                let _e647 = global_6[(_e608 + 1u)];
                global_4.member[(_e641 + (_e611 / 2u))] = ((_e605 & 65535u) | (_e647 << bitcast<u32>(16u)));
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn main(@builtin(local_invocation_id) param: vec3<u32>, @builtin(global_invocation_id) param_1: vec3<u32>) {
    global_5 = param;
    global_7 = param_1;
    function_();
}
