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
    member_52: vec4<f32>,
    member_53: vec4<f32>,
    member_54: vec4<f32>,
    member_55: array<vec4<f32>, 3>,
    member_56: array<vec4<u32>, 8>,
    member_57: array<vec4<u32>, 8>,
    member_58: array<type_11, 8>,
    member_59: array<vec4<f32>, 128>,
    member_60: array<vec4<f32>, 768>,
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
    member: array<vec2<u32>, LENGTH_1_8>,
}

struct type_32 {
    member: array<u32, LENGTH_2_4>,
}

@group(0) @binding(0) 
var<uniform> global: type_15;
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
    var phi_1650_: bool;
    var phi_2602_: f32;
    var phi_2603_: f32;
    var phi_2607_: u32;
    var phi_2613_: u32;
    var phi_2612_: f32;
    var phi_2610_: u32;
    var local: f32;
    var phi_2617_: bool;
    var phi_1696_: bool;
    var phi_2628_: f32;
    var phi_2619_: vec2<f32>;
    var phi_2618_: bool;
    var phi_2159_: bool;
    var phi_2165_: bool;
    var phi_2645_: f32;
    var phi_2644_: u32;
    var local_1: f32;
    var phi_2211_: bool;
    var phi_2651_: vec2<f32>;
    var phi_2652_: vec2<f32>;
    var phi_2653_: u32;
    var phi_2654_: u32;
    var phi_2655_: u32;

    let _e68 = bitcast<u32>(param_1[0u]);
    let _e70 = global.member_48;
    let _e71 = (_e68 < _e70);
    if _e71 {
        switch bitcast<i32>(0u) {
            default: {
                let _e74 = global.member_42;
                let _e75 = (3u * _e68);
                let _e76 = (_e74 + _e75);
                let _e79 = global_4.member[_e76];
                let _e83 = global_4.member[(_e76 + 1u)];
                let _e87 = global_4.member[(_e76 + 2u)];
                let _e105 = global.member_53;
                let _e108 = global.member_54;
                let _e111 = (vec3<f32>(((vec3<u32>((_e79 & 65535u), (_e79 >> bitcast<u32>(16u)), (_e83 & 65535u)) << bitcast<vec3<u32>>(vec3<u32>(8u, 8u, 8u))) | (vec3<u32>(_e87, (_e87 >> bitcast<u32>(8u)), (_e87 >> bitcast<u32>(16u))) & vec3<u32>(255u, 255u, 255u)))) * vec3<f32>(0.00000005960465f, 0.00000005960465f, 0.00000005960465f));
                let _e125 = (_e105.xyz + (_e108.xyz * select(select(((_e111 - vec3<f32>(0.015625f, 0.015625f, 0.015625f)) * vec3<f32>(1.032258f, 1.032258f, 1.032258f)), (vec3<f32>(1f, 1f, 1f) - (vec3<f32>(0.015625f, 0.015625f, 0.015625f) / max(_e111, vec3<f32>(0.000000029802326f, 0.000000029802326f, 0.000000029802326f)))), (_e111 < vec3<f32>(0.015625f, 0.015625f, 0.015625f))), (vec3<f32>(0.015625f, 0.015625f, 0.015625f) / max((vec3<f32>(1f, 1f, 1f) - _e111), vec3<f32>(0.000000029802326f, 0.000000029802326f, 0.000000029802326f))), (_e111 > vec3<f32>(0.984375f, 0.984375f, 0.984375f)))));
                let _e129 = vec4<f32>(_e125.x, _e125.y, _e125.z, 1f);
                let _e132 = global.member_55[0i];
                let _e136 = global.member_55[1i];
                let _e140 = global.member_55[2i];
                let _e141 = dot(_e140, _e129);
                let _e142 = vec3<f32>(dot(_e132, _e129), dot(_e136, _e129), _e141);
                let _e144 = global.member_43;
                let _e152 = (_e144 * exp2(((f32(((_e83 >> bitcast<u32>(16u)) & 255u)) * 0.125f) - 19f)));
                switch bitcast<i32>(0u) {
                    default: {
                        let _e155 = global.member_6;
                        if !((_e141 >= _e155)) {
                            let _e159 = global_2.member_9;
                            if (_e159 != 0u) {
                                let _e163 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_2628_ = 0f;
                            phi_2619_ = vec2<f32>(0f, 0f);
                            phi_2618_ = false;
                            break;
                        }
                        let _e165 = global.member;
                        let _e166 = _e142.xy;
                        let _e168 = vec2(_e141);
                        let _e171 = global.member_1;
                        let _e172 = (((_e165 * _e166) / _e168) + _e171);
                        let _e174 = global.member_5;
                        let _e178 = all((_e172 >= vec2(-(_e174))));
                        phi_1650_ = _e178;
                        if _e178 {
                            let _e180 = global.member_4;
                            phi_1650_ = all((_e172 <= (_e180 + vec2(_e174))));
                        }
                        let _e186 = phi_1650_;
                        if !(_e186) {
                            let _e189 = global_2.member_9;
                            if (_e189 != 0u) {
                                let _e193 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_2628_ = 0f;
                            phi_2619_ = _e172;
                            phi_2618_ = false;
                            break;
                        }
                        let _e195 = global.member_7;
                        let _e198 = global.member_8;
                        let _e199 = ((_e195 - _e141) * _e198);
                        if (_e199 < 0f) {
                            phi_2603_ = (0.015625f / (1f - _e199));
                        } else {
                            if (_e199 > 1f) {
                                phi_2602_ = (1f - (0.015625f / _e199));
                            } else {
                                phi_2602_ = (0.015625f + (0.96875f * clamp(_e199, 0f, 1f)));
                            }
                            let _e210 = phi_2602_;
                            phi_2603_ = _e210;
                        }
                        let _e212 = phi_2603_;
                        let _e213 = (_e166 / _e168);
                        let _e221 = global.member[0u];
                        let _e224 = global.member[1u];
                        let _e229 = global.member_31;
                        let _e230 = (_e229 > 0u);
                        phi_1696_ = _e230;
                        if _e230 {
                            let _e232 = global.member_34;
                            let _e235 = global.member_29;
                            let _e242 = global.member_49;
                            switch bitcast<i32>(0u) {
                                default: {
                                    let _e249 = vec2(((sqrt((2f * log(max((max(255f, _e232) / _e235), 1f)))) * sqrt(_e242)) * ((((_e152 * length(vec3<f32>(_e213.x, _e213.y, 1f))) * max(_e221, _e224)) / _e141) + 0.5477226f)));
                                    let _e252 = global.member_32;
                                    let _e255 = global.member_33;
                                    let _e263 = vec2<u32>(clamp(((((_e172 - _e249) - _e252) * _e255) - vec2<f32>(0.5f, 0.5f)), vec2<f32>(0f, 0f), vec2<f32>(191f, 191f)));
                                    let _e265 = vec2<u32>(clamp(((((_e172 + _e249) - _e252) * _e255) + vec2<f32>(0.5f, 0.5f)), vec2<f32>(0f, 0f), vec2<f32>(191f, 191f)));
                                    let _e272 = max((_e265.x - _e263.x), (_e265.y - _e263.y));
                                    if (_e272 <= 3u) {
                                        phi_2607_ = 0u;
                                    } else {
                                        phi_2607_ = (bitcast<u32>(firstLeadingBit((_e272 - 1u))) - 1u);
                                    }
                                    let _e279 = phi_2607_;
                                    if !((_e279 < 4u)) {
                                        phi_2617_ = false;
                                        break;
                                    }
                                    let _e289 = vec2(_e279);
                                    let _e291 = (_e263 >> bitcast<vec2<u32>>(_e289));
                                    let _e293 = (_e265 >> bitcast<vec2<u32>>(_e289));
                                    let _e295 = (_e291.x & 4294967292u);
                                    phi_2613_ = _e295;
                                    phi_2612_ = 0f;
                                    phi_2610_ = _e291.y;
                                    loop {
                                        let _e298 = phi_2613_;
                                        let _e300 = phi_2612_;
                                        let _e302 = phi_2610_;
                                        local = _e300;
                                        if (_e302 <= _e293.y) {
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e307 = (vec4(f32(_e298)) + vec4<f32>(0f, 1f, 2f, 3f));
                                            let _e325 = global_3.member[((_e229 >> bitcast<u32>(1u)) + ((((4u * (12288u - (12288u >> bitcast<u32>((2u * _e279))))) + (_e302 * (192u >> bitcast<u32>(_e279)))) + _e298) >> bitcast<u32>(2u)))];
                                            let _e327 = unpack2x16unorm(_e325.x);
                                            let _e329 = unpack2x16unorm(_e325.y);
                                            let _e336 = select(select(vec4<f32>(_e327.x, _e327.y, _e329.x, _e329.y), vec4<f32>(0f, 0f, 0f, 0f), (_e307 < vec4(f32(_e291.x)))), vec4<f32>(0f, 0f, 0f, 0f), (_e307 > vec4(f32(_e293.x))));
                                            let _e345 = (_e298 + 4u);
                                            let _e346 = (_e345 > _e293.x);
                                            phi_2613_ = select(_e345, _e295, _e346);
                                            phi_2612_ = max(_e300, max(max(_e336.x, _e336.y), max(_e336.z, _e336.w)));
                                            phi_2610_ = (_e302 + select(0u, 1u, _e346));
                                        }
                                    }
                                    let _e351 = local;
                                    phi_2617_ = ((1f - _e212) > _e351);
                                    break;
                                }
                            }
                            let _e354 = phi_2617_;
                            phi_1696_ = _e354;
                        }
                        let _e356 = phi_1696_;
                        if _e356 {
                            let _e358 = global_2.member_9;
                            if (_e358 != 0u) {
                                let _e362 = atomicAdd((&global_1.member[1u]), 1u);
                            }
                            phi_2628_ = _e212;
                            phi_2619_ = _e172;
                            phi_2618_ = false;
                            break;
                        }
                        phi_2628_ = _e212;
                        phi_2619_ = _e172;
                        phi_2618_ = true;
                        break;
                    }
                }
                let _e364 = phi_2628_;
                let _e366 = phi_2619_;
                let _e368 = phi_2618_;
                if !(_e368) {
                    phi_2654_ = 4294967295u;
                    break;
                }
                let _e370 = f32((_e83 >> bitcast<u32>(24u)));
                let _e372 = global.member_29;
                if (_e370 <= _e372) {
                    let _e375 = global_2.member_9;
                    if (_e375 != 0u) {
                        let _e379 = atomicAdd((&global_1.member[2u]), 1u);
                    }
                    phi_2654_ = 4294967295u;
                    break;
                }
                let _e381 = global.member_14;
                let _e384 = ((_e74 + (3u * _e381)) + _e75);
                let _e387 = global_4.member[_e384];
                let _e391 = global_4.member[(_e384 + 1u)];
                let _e395 = global_4.member[(_e384 + 2u)];
                let _e396 = vec3<u32>(_e387, _e391, _e395);
                let _e408 = vec3<f32>(_e140.x, _e140.y, _e140.z);
                let _e409 = (_e152 * 0.0009775171f);
                let _e413 = ((vec3<f32>((_e396 & vec3<u32>(2047u, 2047u, 2047u))) - vec3<f32>(1023f, 1023f, 1023f)) * _e409);
                let _e419 = ((vec3<f32>(((_e396 >> bitcast<vec3<u32>>(vec3<u32>(11u, 11u, 11u))) & vec3<u32>(2047u, 2047u, 2047u))) - vec3<f32>(1023f, 1023f, 1023f)) * _e409);
                let _e429 = mat3x3<f32>(vec3<f32>(_e413.x, _e419.x, _e419.y), vec3<f32>(0f, _e413.y, _e413.z), vec3<f32>(0f, 0f, _e419.z));
                switch bitcast<i32>(0u) {
                    default: {
                        let _e439 = global.member_2;
                        let _e441 = global.member_3;
                        let _e442 = clamp((_e142.xy / vec2(_e141)), _e439, _e441);
                        let _e445 = global.member[0u];
                        let _e451 = (((vec3<f32>(_e132.x, _e132.y, _e132.z) - (_e408 * _e442.x)) * (_e445 / _e141)) * _e429);
                        let _e454 = global.member[1u];
                        let _e460 = (((vec3<f32>(_e136.x, _e136.y, _e136.z) - (_e408 * _e442.y)) * (_e454 / _e141)) * _e429);
                        let _e462 = (dot(_e451, _e451) + 0.3f);
                        let _e465 = (dot(_e460, _e460) + 0.3f);
                        let _e467 = cross(_e451, _e460);
                        let _e472 = (dot(_e467, _e467) + (0.3f * ((_e462 + _e465) - 0.3f)));
                        let _e473 = (_e472 > 0f);
                        phi_2159_ = _e473;
                        if _e473 {
                            phi_2159_ = (_e462 <= 1000000000000000000f);
                        }
                        let _e476 = phi_2159_;
                        phi_2165_ = _e476;
                        if _e476 {
                            phi_2165_ = (_e465 <= 1000000000000000000f);
                        }
                        let _e479 = phi_2165_;
                        if !(_e479) {
                            let _e482 = global_2.member_9;
                            if (_e482 != 0u) {
                                let _e486 = atomicAdd((&global_1.member[3u]), 1u);
                            }
                            phi_2653_ = 4294967295u;
                            break;
                        }
                        let _e488 = global.member_49;
                        let _e489 = (vec3<f32>(_e462, dot(_e451, _e460), _e465) * _e488);
                        phi_2645_ = (1f - (_e370 * 0.003921569f));
                        phi_2644_ = 0u;
                        loop {
                            let _e495 = phi_2645_;
                            let _e497 = phi_2644_;
                            let _e499 = global.member_47;
                            local_1 = _e495;
                            if (_e497 < _e499) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                phi_2645_ = (_e495 * _e495);
                                phi_2644_ = (_e497 + bitcast<u32>(1i));
                            }
                        }
                        let _e505 = local_1;
                        let _e509 = u32(round((255f * (1f - _e505))));
                        let _e512 = global.member_34;
                        let _e523 = global.member_51;
                        let _e524 = ((sqrt(_e489.xz) * sqrt((2f * log(max((max(f32(_e509), _e512) / _e372), 1f))))) * _e523);
                        let _e527 = global.member_52;
                        let _e530 = all(((_e366 + _e524) > _e527.xy));
                        phi_2211_ = _e530;
                        if _e530 {
                            phi_2211_ = all(((_e366 - _e524) < _e527.zw));
                        }
                        let _e536 = phi_2211_;
                        if !(_e536) {
                            let _e539 = global_2.member_9;
                            if (_e539 != 0u) {
                                let _e543 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_2653_ = 4294967295u;
                            break;
                        }
                        let _e548 = (0.5f * (_e489.x - _e489.z));
                        let _e553 = sqrt(((_e548 * _e548) + (_e489.y * _e489.y)));
                        let _e556 = ((0.5f * (_e489.x + _e489.z)) + _e553);
                        if (_e548 >= 0f) {
                            phi_2651_ = vec2<f32>((_e548 + _e553), _e489.y);
                        } else {
                            phi_2651_ = vec2<f32>(_e489.y, (_e553 - _e548));
                        }
                        let _e563 = phi_2651_;
                        let _e564 = length(_e563);
                        if (_e564 > 0f) {
                            phi_2652_ = (_e563 / vec2(_e564));
                        } else {
                            phi_2652_ = vec2<f32>(1f, 0f);
                        }
                        let _e569 = phi_2652_;
                        let _e576 = global.member_5;
                        let _e580 = global.member_10;
                        let _e584 = vec2<u32>(clamp(round(((_e366 + vec2(_e576)) * _e580)), vec2<f32>(0f, 0f), vec2<f32>(1048575f, 1048575f)));
                        let _e587 = vec3<u32>(round((clamp((vec3<f32>((_e396 >> bitcast<vec3<u32>>(vec3<u32>(22u, 22u, 22u)))) * vec3<f32>(0.0009775171f, 0.0009775171f, 0.0009775171f)), vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 1023f)));
                        let _e615 = global.member_45;
                        let _e617 = (4u * (_e615 + _e68));
                        global_4.member[_e617] = ((_e584.x | (_e587.x << bitcast<u32>(20u))) | (_e587.z << bitcast<u32>(30u)));
                        global_4.member[(_e617 + 1u)] = (_e584.y | (_e587.y << bitcast<u32>(20u)));
                        global_4.member[(_e617 + 2u)] = pack2x16float((_e569 * min(sqrt(_e556), 65504f)));
                        global_4.member[(_e617 + 3u)] = ((pack2x16float(vec2<f32>(min(sqrt(((_e472 * (_e488 * _e488)) / _e556)), 65504f), 0f)) | (_e509 << bitcast<u32>(16u))) | ((_e587.z >> bitcast<u32>(2u)) << bitcast<u32>(24u)));
                        let _e630 = global.member_9;
                        phi_2653_ = min(u32((_e364 * f32(_e630))), _e630);
                        break;
                    }
                }
                let _e636 = phi_2653_;
                phi_2654_ = _e636;
                break;
            }
        }
        let _e638 = phi_2654_;
        phi_2655_ = _e638;
    } else {
        phi_2655_ = 4294967295u;
    }
    let _e640 = phi_2655_;
    switch bitcast<i32>(0u) {
        default: {
            let _e643 = bitcast<u32>(param[0u]);
            let _e645 = global.member_45;
            let _e646 = (_e645 + _e68);
            if (_e640 != 4294967295u) {
                let _e649 = global.member_41;
                let _e653 = global.member_40;
                let _e659 = atomicAdd((&global_1.member[((_e653 + ((_e646 / _e649) * 256u)) + (_e640 & 255u))]), 1u);
            }
            let _e661 = global.member_39;
            if (_e661 == 0u) {
                if (_e68 < (_e70 + (_e70 & 1u))) {
                    let _e667 = global.member_28;
                    global_4.member[(_e667 + _e646)] = _e640;
                }
                break;
            }
            global_5[_e643] = _e640;
            workgroupBarrier();
            let _e673 = ((_e643 & 1u) == 0u);
            if select(_e673, _e71, _e673) {
                let _e676 = global.member_28;
                let _e683 = global_5[(_e643 + 1u)];
                global_4.member[(_e676 + (_e646 >> bitcast<u32>(1u)))] = ((_e640 & 65535u) | (_e683 << bitcast<u32>(16u)));
            }
            break;
        }
    }
    return;
}
