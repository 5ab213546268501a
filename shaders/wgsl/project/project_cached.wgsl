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
    var phi_1639_: bool;
    var phi_2582_: f32;
    var phi_2583_: f32;
    var phi_2587_: u32;
    var phi_2593_: u32;
    var phi_2592_: f32;
    var phi_2590_: u32;
    var local: f32;
    var phi_2597_: bool;
    var phi_1685_: bool;
    var phi_2608_: f32;
    var phi_2599_: vec2<f32>;
    var phi_2598_: bool;
    var phi_2147_: bool;
    var phi_2153_: bool;
    var phi_2625_: f32;
    var phi_2624_: u32;
    var local_1: f32;
    var phi_2191_: bool;
    var phi_2631_: vec2<f32>;
    var phi_2632_: vec2<f32>;
    var phi_2633_: u32;
    var phi_2634_: u32;
    var phi_2635_: u32;

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
                let _e105 = global.member_51;
                let _e108 = global.member_52;
                let _e111 = (vec3<f32>(((vec3<u32>((_e79 & 65535u), (_e79 >> bitcast<u32>(16u)), (_e83 & 65535u)) << bitcast<vec3<u32>>(vec3<u32>(8u, 8u, 8u))) | (vec3<u32>(_e87, (_e87 >> bitcast<u32>(8u)), (_e87 >> bitcast<u32>(16u))) & vec3<u32>(255u, 255u, 255u)))) * vec3<f32>(0.00000005960465f, 0.00000005960465f, 0.00000005960465f));
                let _e125 = (_e105.xyz + (_e108.xyz * select(select(((_e111 - vec3<f32>(0.015625f, 0.015625f, 0.015625f)) * vec3<f32>(1.032258f, 1.032258f, 1.032258f)), (vec3<f32>(1f, 1f, 1f) - (vec3<f32>(0.015625f, 0.015625f, 0.015625f) / max(_e111, vec3<f32>(0.000000029802326f, 0.000000029802326f, 0.000000029802326f)))), (_e111 < vec3<f32>(0.015625f, 0.015625f, 0.015625f))), (vec3<f32>(0.015625f, 0.015625f, 0.015625f) / max((vec3<f32>(1f, 1f, 1f) - _e111), vec3<f32>(0.000000029802326f, 0.000000029802326f, 0.000000029802326f))), (_e111 > vec3<f32>(0.984375f, 0.984375f, 0.984375f)))));
                let _e129 = vec4<f32>(_e125.x, _e125.y, _e125.z, 1f);
                let _e132 = global.member_53[0i];
                let _e136 = global.member_53[1i];
                let _e140 = global.member_53[2i];
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
                            phi_2608_ = 0f;
                            phi_2599_ = vec2<f32>(0f, 0f);
                            phi_2598_ = false;
                            break;
                        }
                        let _e165 = global.member;
                        let _e166 = _e142.xy;
                        let _e168 = vec2(_e141);
                        let _e171 = global.member_1;
                        let _e172 = (((_e165 * _e166) / _e168) + _e171);
                        let _e174 = global.member_5;
                        let _e178 = all((_e172 >= vec2(-(_e174))));
                        phi_1639_ = _e178;
                        if _e178 {
                            let _e180 = global.member_4;
                            phi_1639_ = all((_e172 <= (_e180 + vec2(_e174))));
                        }
                        let _e186 = phi_1639_;
                        if !(_e186) {
                            let _e189 = global_2.member_9;
                            if (_e189 != 0u) {
                                let _e193 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_2608_ = 0f;
                            phi_2599_ = _e172;
                            phi_2598_ = false;
                            break;
                        }
                        let _e195 = global.member_7;
                        let _e198 = global.member_8;
                        let _e199 = ((_e195 - _e141) * _e198);
                        if (_e199 < 0f) {
                            phi_2583_ = (0.015625f / (1f - _e199));
                        } else {
                            if (_e199 > 1f) {
                                phi_2582_ = (1f - (0.015625f / _e199));
                            } else {
                                phi_2582_ = (0.015625f + (0.96875f * clamp(_e199, 0f, 1f)));
                            }
                            let _e210 = phi_2582_;
                            phi_2583_ = _e210;
                        }
                        let _e212 = phi_2583_;
                        let _e213 = (_e166 / _e168);
                        let _e221 = global.member[0u];
                        let _e224 = global.member[1u];
                        let _e229 = global.member_31;
                        let _e230 = (_e229 > 0u);
                        phi_1685_ = _e230;
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
                                        phi_2587_ = 0u;
                                    } else {
                                        phi_2587_ = (bitcast<u32>(firstLeadingBit((_e272 - 1u))) - 1u);
                                    }
                                    let _e279 = phi_2587_;
                                    if !((_e279 < 4u)) {
                                        phi_2597_ = false;
                                        break;
                                    }
                                    let _e289 = vec2(_e279);
                                    let _e291 = (_e263 >> bitcast<vec2<u32>>(_e289));
                                    let _e293 = (_e265 >> bitcast<vec2<u32>>(_e289));
                                    let _e295 = (_e291.x & 4294967292u);
                                    phi_2593_ = _e295;
                                    phi_2592_ = 0f;
                                    phi_2590_ = _e291.y;
                                    loop {
                                        let _e298 = phi_2593_;
                                        let _e300 = phi_2592_;
                                        let _e302 = phi_2590_;
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
                                            phi_2593_ = select(_e345, _e295, _e346);
                                            phi_2592_ = max(_e300, max(max(_e336.x, _e336.y), max(_e336.z, _e336.w)));
                                            phi_2590_ = (_e302 + select(0u, 1u, _e346));
                                        }
                                    }
                                    let _e351 = local;
                                    phi_2597_ = ((1f - _e212) > _e351);
                                    break;
                                }
                            }
                            let _e354 = phi_2597_;
                            phi_1685_ = _e354;
                        }
                        let _e356 = phi_1685_;
                        if _e356 {
                            let _e358 = global_2.member_9;
                            if (_e358 != 0u) {
                                let _e362 = atomicAdd((&global_1.member[1u]), 1u);
                            }
                            phi_2608_ = _e212;
                            phi_2599_ = _e172;
                            phi_2598_ = false;
                            break;
                        }
                        phi_2608_ = _e212;
                        phi_2599_ = _e172;
                        phi_2598_ = true;
                        break;
                    }
                }
                let _e364 = phi_2608_;
                let _e366 = phi_2599_;
                let _e368 = phi_2598_;
                if !(_e368) {
                    phi_2634_ = 4294967295u;
                    break;
                }
                let _e370 = f32((_e83 >> bitcast<u32>(24u)));
                let _e372 = global.member_29;
                if (_e370 <= _e372) {
                    let _e375 = global_2.member_9;
                    if (_e375 != 0u) {
                        let _e379 = atomicAdd((&global_1.member[2u]), 1u);
                    }
                    phi_2634_ = 4294967295u;
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
                        phi_2147_ = _e473;
                        if _e473 {
                            phi_2147_ = (_e462 <= 1000000000000000000f);
                        }
                        let _e476 = phi_2147_;
                        phi_2153_ = _e476;
                        if _e476 {
                            phi_2153_ = (_e465 <= 1000000000000000000f);
                        }
                        let _e479 = phi_2153_;
                        if !(_e479) {
                            let _e482 = global_2.member_9;
                            if (_e482 != 0u) {
                                let _e486 = atomicAdd((&global_1.member[3u]), 1u);
                            }
                            phi_2633_ = 4294967295u;
                            break;
                        }
                        let _e488 = global.member_49;
                        let _e489 = (vec3<f32>(_e462, dot(_e451, _e460), _e465) * _e488);
                        phi_2625_ = (1f - (_e370 * 0.003921569f));
                        phi_2624_ = 0u;
                        loop {
                            let _e495 = phi_2625_;
                            let _e497 = phi_2624_;
                            let _e499 = global.member_47;
                            local_1 = _e495;
                            if (_e497 < _e499) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                phi_2625_ = (_e495 * _e495);
                                phi_2624_ = (_e497 + bitcast<u32>(1i));
                            }
                        }
                        let _e505 = local_1;
                        let _e509 = u32(round((255f * (1f - _e505))));
                        let _e512 = global.member_34;
                        let _e521 = (sqrt(_e489.xz) * sqrt((2f * log(max((max(f32(_e509), _e512) / _e372), 1f)))));
                        let _e524 = all(((_e366 + _e521) > vec2<f32>(0f, 0f)));
                        phi_2191_ = _e524;
                        if _e524 {
                            let _e527 = global.member_4;
                            phi_2191_ = all(((_e366 - _e521) < _e527));
                        }
                        let _e531 = phi_2191_;
                        if !(_e531) {
                            let _e534 = global_2.member_9;
                            if (_e534 != 0u) {
                                let _e538 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_2633_ = 4294967295u;
                            break;
                        }
                        let _e543 = (0.5f * (_e489.x - _e489.z));
                        let _e548 = sqrt(((_e543 * _e543) + (_e489.y * _e489.y)));
                        let _e551 = ((0.5f * (_e489.x + _e489.z)) + _e548);
                        if (_e543 >= 0f) {
                            phi_2631_ = vec2<f32>((_e543 + _e548), _e489.y);
                        } else {
                            phi_2631_ = vec2<f32>(_e489.y, (_e548 - _e543));
                        }
                        let _e558 = phi_2631_;
                        let _e559 = length(_e558);
                        if (_e559 > 0f) {
                            phi_2632_ = (_e558 / vec2(_e559));
                        } else {
                            phi_2632_ = vec2<f32>(1f, 0f);
                        }
                        let _e564 = phi_2632_;
                        let _e571 = global.member_5;
                        let _e575 = global.member_10;
                        let _e579 = vec2<u32>(clamp(round(((_e366 + vec2(_e571)) * _e575)), vec2<f32>(0f, 0f), vec2<f32>(1048575f, 1048575f)));
                        let _e582 = vec3<u32>(round((clamp((vec3<f32>((_e396 >> bitcast<vec3<u32>>(vec3<u32>(22u, 22u, 22u)))) * vec3<f32>(0.0009775171f, 0.0009775171f, 0.0009775171f)), vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 1023f)));
                        let _e610 = global.member_45;
                        let _e612 = (4u * (_e610 + _e68));
                        global_4.member[_e612] = ((_e579.x | (_e582.x << bitcast<u32>(20u))) | (_e582.z << bitcast<u32>(30u)));
                        global_4.member[(_e612 + 1u)] = (_e579.y | (_e582.y << bitcast<u32>(20u)));
                        global_4.member[(_e612 + 2u)] = pack2x16float((_e564 * min(sqrt(_e551), 65504f)));
                        global_4.member[(_e612 + 3u)] = ((pack2x16float(vec2<f32>(min(sqrt(((_e472 * (_e488 * _e488)) / _e551)), 65504f), 0f)) | (_e509 << bitcast<u32>(16u))) | ((_e582.z >> bitcast<u32>(2u)) << bitcast<u32>(24u)));
                        let _e625 = global.member_9;
                        phi_2633_ = min(u32((_e364 * f32(_e625))), _e625);
                        break;
                    }
                }
                let _e631 = phi_2633_;
                phi_2634_ = _e631;
                break;
            }
        }
        let _e633 = phi_2634_;
        phi_2635_ = _e633;
    } else {
        phi_2635_ = 4294967295u;
    }
    let _e635 = phi_2635_;
    switch bitcast<i32>(0u) {
        default: {
            let _e638 = bitcast<u32>(param[0u]);
            let _e640 = global.member_45;
            let _e641 = (_e640 + _e68);
            if (_e635 != 4294967295u) {
                let _e644 = global.member_41;
                let _e648 = global.member_40;
                let _e654 = atomicAdd((&global_1.member[((_e648 + ((_e641 / _e644) * 256u)) + (_e635 & 255u))]), 1u);
            }
            let _e656 = global.member_39;
            if (_e656 == 0u) {
                if (_e68 < (_e70 + (_e70 & 1u))) {
                    let _e662 = global.member_28;
                    global_4.member[(_e662 + _e641)] = _e635;
                }
                break;
            }
            global_5[_e638] = _e635;
            workgroupBarrier();
            let _e668 = ((_e638 & 1u) == 0u);
            if select(_e668, _e71, _e668) {
                let _e671 = global.member_28;
                let _e678 = global_5[(_e638 + 1u)];
                global_4.member[(_e671 + (_e641 >> bitcast<u32>(1u)))] = ((_e635 & 65535u) | (_e678 << bitcast<u32>(16u)));
            }
            break;
        }
    }
    return;
}
