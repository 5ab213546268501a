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
    member_51: f32,
    member_52: f32,
    member_53: f32,
    member_54: vec4<f32>,
    member_55: vec4<f32>,
    member_56: vec4<f32>,
    member_57: array<vec4<f32>, 3>,
    member_58: array<vec4<u32>, 8>,
    member_59: array<vec4<u32>, 8>,
    member_60: array<type_12, 8>,
    member_61: array<vec4<f32>, 128>,
    member_62: array<vec4<f32>, 768>,
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
    var phi_5196_: u32;
    var phi_5195_: bool;
    var phi_3157_: bool;
    var local: bool;
    var phi_3565_: bool;
    var phi_5198_: f32;
    var phi_5199_: f32;
    var phi_5203_: u32;
    var phi_5209_: u32;
    var phi_5208_: f32;
    var phi_5206_: u32;
    var local_1: f32;
    var phi_5213_: bool;
    var phi_3614_: bool;
    var phi_5224_: f32;
    var phi_5215_: vec2<f32>;
    var phi_5214_: bool;
    var phi_5234_: vec4<f32>;
    var phi_5235_: vec4<f32>;
    var phi_5236_: vec4<f32>;
    var phi_5254_: vec3<f32>;
    var phi_5256_: vec4<f32>;
    var phi_5255_: u32;
    var local_2: vec4<f32>;
    var phi_5271_: vec4<f32>;
    var phi_5259_: vec3<f32>;
    var phi_5258_: u32;
    var local_3: vec3<f32>;
    var phi_5275_: vec3<f32>;
    var phi_5268_: vec3<f32>;
    var phi_5267_: u32;
    var local_4: vec3<f32>;
    var phi_5277_: vec3<f32>;
    var phi_4660_: bool;
    var phi_4666_: bool;
    var phi_5282_: f32;
    var phi_5281_: u32;
    var local_5: f32;
    var phi_5290_: u32;
    var phi_4744_: bool;
    var phi_5294_: vec2<f32>;
    var phi_5295_: vec2<f32>;
    var phi_5296_: u32;
    var phi_5297_: u32;
    var phi_5298_: u32;

    let _e71 = bitcast<u32>(param_1[0u]);
    let _e73 = global.member_48;
    let _e74 = (_e71 < _e73);
    if _e74 {
        switch bitcast<i32>(0u) {
            default: {
                let _e77 = global.member_14;
                let _e79 = global.member_47;
                let _e81 = (_e71 << bitcast<u32>(_e79));
                let _e85 = (4u * (_e77 + (_e81 >> bitcast<u32>(5u))));
                let _e90 = global_7.member[(_e85 + 3u)][0u];
                phi_5196_ = (_e90 & 65535u);
                phi_5195_ = true;
                loop {
                    let _e93 = phi_5196_;
                    let _e95 = phi_5195_;
                    local = _e95;
                    phi_3157_ = _e95;
                    if _e95 {
                        phi_3157_ = (_e93 <= (_e90 >> bitcast<u32>(16u)));
                    }
                    let _e100 = phi_3157_;
                    if _e100 {
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e109 = global.member_59[(_e93 >> bitcast<u32>(7u))][((_e93 >> bitcast<u32>(5u)) & 3u)];
                        phi_5196_ = (_e93 + bitcast<u32>(1i));
                        phi_5195_ = (((_e109 >> bitcast<u32>((_e93 & 31u))) & 1u) != 0u);
                    }
                }
                let _e118 = local;
                if _e118 {
                    let _e120 = global_2.member_9;
                    if (_e120 != 0u) {
                        let _e124 = atomicAdd((&global_1.member[0u]), 1u);
                    }
                    phi_5297_ = 4294967295u;
                    break;
                }
                let _e125 = (2u * _e81);
                let _e128 = global_7.member[_e125];
                let _e132 = global_7.member[(_e125 + 1u)];
                let _e137 = global_7.member[((2u * _e77) + _e81)];
                let _e148 = (vec2<f32>(f32(((_e137.y >> bitcast<u32>(16u)) & 31u)), f32(((_e137.y >> bitcast<u32>(21u)) & 31u))) * vec2<f32>(0.032258064f, 0.032258064f));
                let _e152 = ((1f + (2f * _e148.x)) * 0.33333334f);
                let _e153 = (1f - _e152);
                let _e157 = (_e153 * (0.5f + (0.5f * _e148.y)));
                let _e175 = global.member_11;
                let _e178 = global.member_12;
                let _e183 = global.member_21;
                let _e184 = (2u * _e183);
                let _e188 = global_3.member[(_e184 + (_e137.x & 65535u))];
                let _e190 = unpack2x16float(_e188.x);
                let _e202 = global_3.member[(_e184 + (_e137.x >> bitcast<u32>(16u)))];
                let _e204 = unpack2x16float(_e202.x);
                let _e216 = global_3.member[(_e184 + (_e137.y & 65535u))];
                let _e218 = unpack2x16float(_e216.x);
                let _e226 = ((((_e175.xyz + (_e178.xyz * vec3<f32>(f32((_e128.x & 65535u)), f32((_e128.x >> bitcast<u32>(16u))), f32((_e128.y & 65535u))))) + (vec3<f32>(_e190.x, _e190.y, unpack2x16float(_e188.y).x) * _e152)) + (vec3<f32>(_e204.x, _e204.y, unpack2x16float(_e202.y).x) * _e157)) + (vec3<f32>(_e218.x, _e218.y, unpack2x16float(_e216.y).x) * (_e153 - _e157)));
                let _e230 = vec4<f32>(_e226.x, _e226.y, _e226.z, 1f);
                let _e243 = (((_e128.y >> bitcast<u32>(16u)) | ((_e132.y >> bitcast<u32>(24u)) << bitcast<u32>(16u))) | ((_e137.y >> bitcast<u32>(26u)) << bitcast<u32>(24u)));
                let _e255 = global.member_36;
                let _e257 = global.member_37;
                let _e260 = (vec3(_e255) + (vec3<f32>(f32((_e243 & 1023u)), f32(((_e243 >> bitcast<u32>(10u)) & 1023u)), f32((_e243 >> bitcast<u32>(20u)))) * _e257));
                let _e269 = (vec4<u32>(_e132.x, (_e132.x >> bitcast<u32>(8u)), (_e132.x >> bitcast<u32>(16u)), (_e132.x >> bitcast<u32>(24u))) & vec4<u32>(255u, 255u, 255u, 255u));
                let _e275 = (vec3<u32>(_e132.y, (_e132.y >> bitcast<u32>(8u)), (_e132.y >> bitcast<u32>(16u))) & vec3<u32>(255u, 255u, 255u));
                let _e276 = vec3<f32>(_e275);
                let _e288 = (vec4<f32>(_e276.x, _e276.y, _e276.z, f32((((255u - _e275.x) - _e275.y) - _e275.z))) * vec4<f32>(0.003921569f, 0.003921569f, 0.003921569f, 0.003921569f));
                let _e291 = (3u * _e269.x);
                let _e294 = global.member_62[_e291];
                let _e299 = global.member_62[(_e291 + 1u)];
                let _e304 = global.member_62[(_e291 + 2u)];
                let _e308 = (3u * _e269.y);
                let _e311 = global.member_62[_e308];
                let _e317 = global.member_62[(_e308 + 1u)];
                let _e323 = global.member_62[(_e308 + 2u)];
                let _e328 = (3u * _e269.z);
                let _e331 = global.member_62[_e328];
                let _e337 = global.member_62[(_e328 + 1u)];
                let _e343 = global.member_62[(_e328 + 2u)];
                let _e348 = (3u * _e269.w);
                let _e351 = global.member_62[_e348];
                let _e353 = ((((_e294 * _e288.x) + (_e311 * _e288.y)) + (_e331 * _e288.z)) + (_e351 * _e288.w));
                let _e357 = global.member_62[(_e348 + 1u)];
                let _e359 = ((((_e299 * _e288.x) + (_e317 * _e288.y)) + (_e337 * _e288.z)) + (_e357 * _e288.w));
                let _e363 = global.member_62[(_e348 + 2u)];
                let _e365 = ((((_e304 * _e288.x) + (_e323 * _e288.y)) + (_e343 * _e288.z)) + (_e363 * _e288.w));
                let _e368 = dot(_e365, _e230);
                let _e369 = vec3<f32>(dot(_e353, _e230), dot(_e359, _e230), _e368);
                let _e370 = _e353.xyz;
                let _e371 = _e359.xyz;
                let _e372 = _e365.xyz;
                let _e384 = vec3<f32>(_e365.x, _e365.y, _e365.z);
                switch bitcast<i32>(0u) {
                    default: {
                        let _e402 = global.member_6;
                        if !((_e368 >= _e402)) {
                            let _e406 = global_2.member_9;
                            if (_e406 != 0u) {
                                let _e410 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_5224_ = 0f;
                            phi_5215_ = vec2<f32>(0f, 0f);
                            phi_5214_ = false;
                            break;
                        }
                        let _e412 = global.member;
                        let _e413 = _e369.xy;
                        let _e415 = vec2(_e368);
                        let _e418 = global.member_1;
                        let _e419 = (((_e412 * _e413) / _e415) + _e418);
                        let _e421 = global.member_5;
                        let _e425 = all((_e419 >= vec2(-(_e421))));
                        phi_3565_ = _e425;
                        if _e425 {
                            let _e427 = global.member_4;
                            phi_3565_ = all((_e419 <= (_e427 + vec2(_e421))));
                        }
                        let _e433 = phi_3565_;
                        if !(_e433) {
                            let _e436 = global_2.member_9;
                            if (_e436 != 0u) {
                                let _e440 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_5224_ = 0f;
                            phi_5215_ = _e419;
                            phi_5214_ = false;
                            break;
                        }
                        let _e442 = global.member_7;
                        let _e445 = global.member_8;
                        let _e446 = ((_e442 - _e368) * _e445);
                        if (_e446 < 0f) {
                            phi_5199_ = (0.015625f / (1f - _e446));
                        } else {
                            if (_e446 > 1f) {
                                phi_5198_ = (1f - (0.015625f / _e446));
                            } else {
                                phi_5198_ = (0.015625f + (0.96875f * clamp(_e446, 0f, 1f)));
                            }
                            let _e455 = phi_5198_;
                            phi_5199_ = _e455;
                        }
                        let _e459 = phi_5199_;
                        let _e460 = (_e413 / _e415);
                        let _e468 = global.member[0u];
                        let _e471 = global.member[1u];
                        let _e476 = global.member_31;
                        let _e477 = (_e476 > 0u);
                        phi_3614_ = _e477;
                        if _e477 {
                            let _e479 = global.member_34;
                            let _e482 = global.member_29;
                            let _e489 = global.member_49;
                            let _e493 = global.member_51;
                            switch bitcast<i32>(0u) {
                                default: {
                                    let _e499 = vec2(((sqrt((2f * log(max((max(255f, _e479) / _e482), 1f)))) * sqrt(_e489)) * ((((((1.2f * exp(min(max(max(_e260.x, _e260.y), _e260.z), 9f))) * sqrt(max(max(dot(_e370, _e370), dot(_e371, _e371)), dot(_e372, _e372)))) * length(vec3<f32>(_e460.x, _e460.y, 1f))) * max(_e468, _e471)) / _e368) + sqrt(_e493))));
                                    let _e502 = global.member_32;
                                    let _e505 = global.member_33;
                                    let _e513 = vec2<u32>(clamp(((((_e419 - _e499) - _e502) * _e505) - vec2<f32>(0.5f, 0.5f)), vec2<f32>(0f, 0f), vec2<f32>(191f, 191f)));
                                    let _e515 = vec2<u32>(clamp(((((_e419 + _e499) - _e502) * _e505) + vec2<f32>(0.5f, 0.5f)), vec2<f32>(0f, 0f), vec2<f32>(191f, 191f)));
                                    let _e522 = max((_e515.x - _e513.x), (_e515.y - _e513.y));
                                    if (_e522 <= 3u) {
                                        phi_5203_ = 0u;
                                    } else {
                                        phi_5203_ = (bitcast<u32>(firstLeadingBit((_e522 - 1u))) - 1u);
                                    }
                                    let _e529 = phi_5203_;
                                    if !((_e529 < 4u)) {
                                        phi_5213_ = false;
                                        break;
                                    }
                                    let _e539 = vec2(_e529);
                                    let _e541 = (_e513 >> bitcast<vec2<u32>>(_e539));
                                    let _e543 = (_e515 >> bitcast<vec2<u32>>(_e539));
                                    let _e545 = (_e541.x & 4294967292u);
                                    phi_5209_ = _e545;
                                    phi_5208_ = 0f;
                                    phi_5206_ = _e541.y;
                                    loop {
                                        let _e548 = phi_5209_;
                                        let _e550 = phi_5208_;
                                        let _e552 = phi_5206_;
                                        local_1 = _e550;
                                        if (_e552 <= _e543.y) {
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e557 = (vec4(f32(_e548)) + vec4<f32>(0f, 1f, 2f, 3f));
                                            let _e575 = global_3.member[((_e476 >> bitcast<u32>(1u)) + ((((4u * (12288u - (12288u >> bitcast<u32>((2u * _e529))))) + (_e552 * (192u >> bitcast<u32>(_e529)))) + _e548) >> bitcast<u32>(2u)))];
                                            let _e577 = unpack2x16unorm(_e575.x);
                                            let _e579 = unpack2x16unorm(_e575.y);
                                            let _e586 = select(select(vec4<f32>(_e577.x, _e577.y, _e579.x, _e579.y), vec4<f32>(0f, 0f, 0f, 0f), (_e557 < vec4(f32(_e541.x)))), vec4<f32>(0f, 0f, 0f, 0f), (_e557 > vec4(f32(_e543.x))));
                                            let _e595 = (_e548 + 4u);
                                            let _e596 = (_e595 > _e543.x);
                                            phi_5209_ = select(_e595, _e545, _e596);
                                            phi_5208_ = max(_e550, max(max(_e586.x, _e586.y), max(_e586.z, _e586.w)));
                                            phi_5206_ = (_e552 + select(0u, 1u, _e596));
                                        }
                                    }
                                    let _e601 = local_1;
                                    phi_5213_ = ((1f - _e459) > _e601);
                                    break;
                                }
                            }
                            let _e604 = phi_5213_;
                            phi_3614_ = _e604;
                        }
                        let _e606 = phi_3614_;
                        if _e606 {
                            let _e608 = global_2.member_9;
                            if (_e608 != 0u) {
                                let _e612 = atomicAdd((&global_1.member[1u]), 1u);
                            }
                            phi_5224_ = _e459;
                            phi_5215_ = _e419;
                            phi_5214_ = false;
                            break;
                        }
                        phi_5224_ = _e459;
                        phi_5215_ = _e419;
                        phi_5214_ = true;
                        break;
                    }
                }
                let _e614 = phi_5224_;
                let _e616 = phi_5215_;
                let _e618 = phi_5214_;
                if (true && !(_e618)) {
                    phi_5297_ = 4294967295u;
                    break;
                }
                let _e625 = global_7.member[((3u * _e77) + _e81)];
                let _e629 = f32((_e625.y >> bitcast<u32>(24u)));
                let _e631 = global.member_29;
                if (_e629 <= _e631) {
                    let _e634 = global_2.member_9;
                    if (_e634 != 0u) {
                        let _e638 = atomicAdd((&global_1.member[2u]), 1u);
                    }
                    phi_5297_ = 4294967295u;
                    break;
                }
                let _e652 = ((vec3<f32>(f32((_e625.x & 1023u)), f32(((_e625.x >> bitcast<u32>(10u)) & 1023u)), f32(((_e625.x >> bitcast<u32>(20u)) & 1023u))) - vec3<f32>(512f, 512f, 512f)) * vec3<f32>(0.0013888889f, 0.0013888889f, 0.0013888889f));
                let _e656 = sqrt(max((1f - dot(_e652, _e652)), 0f));
                let _e658 = (_e625.x >> bitcast<u32>(30u));
                if (_e658 == 0u) {
                    phi_5236_ = vec4<f32>(_e656, _e652.x, _e652.y, _e652.z);
                } else {
                    if (_e658 == 1u) {
                        phi_5235_ = vec4<f32>(_e652.x, _e656, _e652.y, _e652.z);
                    } else {
                        if (_e658 == 2u) {
                            phi_5234_ = vec4<f32>(_e652.x, _e652.y, _e656, _e652.z);
                        } else {
                            phi_5234_ = vec4<f32>(_e652.x, _e652.y, _e652.z, _e656);
                        }
                        let _e671 = phi_5234_;
                        phi_5235_ = _e671;
                    }
                    let _e677 = phi_5235_;
                    phi_5236_ = _e677;
                }
                let _e683 = phi_5236_;
                let _e687 = global.member_38;
                let _e688 = (_e687 > 0u);
                phi_5254_ = unpack4x8unorm(_e625.y).xyz;
                if _e688 {
                    let _e692 = global_7.member[(_e687 + _e81)];
                    let _e694 = unpack2x16float(_e692.x);
                    phi_5254_ = vec3<f32>(_e694.x, _e694.y, unpack2x16float(_e692.y).x);
                }
                let _e702 = phi_5254_;
                let _e705 = (1u << bitcast<u32>((_e81 & 31u)));
                let _e708 = global_7.member[_e85];
                let _e712 = global_7.member[(_e85 + 1u)];
                let _e716 = global_7.member[(_e85 + 2u)];
                phi_5271_ = _e683;
                if ((_e708.x & _e705) != 0u) {
                    let _e727 = global.member_22;
                    let _e729 = global.member_18;
                    let _e733 = (_e727 + ((_e712.y + bitcast<u32>(countOneBits((_e708.x & (_e705 - 1u))))) * (1u + (4u * _e729))));
                    let _e734 = (_e733 + 1u);
                    let _e737 = global_6.member[_e733];
                    let _e739 = global.member_44;
                    let _e743 = global.member_19;
                    phi_5256_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_5255_ = 0u;
                    loop {
                        let _e747 = phi_5256_;
                        let _e749 = phi_5255_;
                        let _e751 = (2u * ((_e739 + ((_e737 >> bitcast<u32>(16u)) * _e743)) + _e749));
                        let _e754 = global_3.member[_e751];
                        let _e758 = global_3.member[(_e751 + 1u)];
                        let _e764 = bitcast<vec4<f32>>(vec4<u32>(_e754.x, _e754.y, _e758.x, _e758.y));
                        let _e768 = global_6.member[(_e734 + _e749)];
                        let _e775 = global_6.member[((_e734 + _e729) + _e749)];
                        let _e783 = global_6.member[((_e734 + (2u * _e729)) + _e749)];
                        let _e791 = global_6.member[((_e734 + (3u * _e729)) + _e749)];
                        let _e795 = (_e747 + vec4<f32>(dot(unpack4x8snorm(_e768), _e764), dot(unpack4x8snorm(_e775), _e764), dot(unpack4x8snorm(_e783), _e764), dot(unpack4x8snorm(_e791), _e764)));
                        let _e797 = (_e749 + bitcast<u32>(1i));
                        phi_5256_ = _e795;
                        phi_5255_ = _e797;
                        local_2 = _e795;
                        if (_e797 < _e729) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e803 = local_2;
                    let _e805 = (_e683 + (_e803 * (127f * unpack2x16float(_e737).x)));
                    phi_5271_ = select(_e683, _e805, vec4((length(_e805) >= 0.001f)));
                }
                let _e811 = phi_5271_;
                phi_5275_ = _e260;
                if ((_e708.y & _e705) != 0u) {
                    let _e822 = global.member_23;
                    let _e824 = global.member_18;
                    let _e828 = (_e822 + ((_e716.x + bitcast<u32>(countOneBits((_e708.y & (_e705 - 1u))))) * (1u + (3u * _e824))));
                    let _e829 = (_e828 + 1u);
                    let _e832 = global_6.member[_e828];
                    let _e834 = global.member_44;
                    let _e838 = global.member_19;
                    phi_5259_ = vec3<f32>(0f, 0f, 0f);
                    phi_5258_ = 0u;
                    loop {
                        let _e842 = phi_5259_;
                        let _e844 = phi_5258_;
                        let _e846 = (2u * ((_e834 + ((_e832 >> bitcast<u32>(16u)) * _e838)) + _e844));
                        let _e849 = global_3.member[_e846];
                        let _e853 = global_3.member[(_e846 + 1u)];
                        let _e859 = bitcast<vec4<f32>>(vec4<u32>(_e849.x, _e849.y, _e853.x, _e853.y));
                        let _e863 = global_6.member[(_e829 + _e844)];
                        let _e870 = global_6.member[((_e829 + _e824) + _e844)];
                        let _e878 = global_6.member[((_e829 + (2u * _e824)) + _e844)];
                        let _e882 = (_e842 + vec3<f32>(dot(unpack4x8snorm(_e863), _e859), dot(unpack4x8snorm(_e870), _e859), dot(unpack4x8snorm(_e878), _e859)));
                        let _e884 = (_e844 + bitcast<u32>(1i));
                        phi_5259_ = _e882;
                        phi_5258_ = _e884;
                        local_3 = _e882;
                        if (_e884 < _e824) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e890 = local_3;
                    phi_5275_ = (_e260 + (_e890 * (127f * unpack2x16float(_e832).x)));
                }
                let _e894 = phi_5275_;
                phi_5277_ = _e702;
                if ((_e712.x & _e705) != 0u) {
                    let _e905 = global.member_24;
                    let _e907 = global.member_18;
                    let _e911 = (_e905 + ((_e716.y + bitcast<u32>(countOneBits((_e712.x & (_e705 - 1u))))) * (3u + (3u * _e907))));
                    let _e915 = global_6.member[(_e911 + 1u)];
                    let _e916 = unpack2x16float(_e915);
                    let _e920 = global_6.member[(_e911 + 2u)];
                    let _e928 = (_e911 + 3u);
                    let _e931 = global_6.member[_e911];
                    let _e933 = global.member_44;
                    let _e937 = global.member_19;
                    phi_5268_ = vec3<f32>(0f, 0f, 0f);
                    phi_5267_ = 0u;
                    loop {
                        let _e941 = phi_5268_;
                        let _e943 = phi_5267_;
                        let _e945 = (2u * ((_e933 + ((_e931 >> bitcast<u32>(16u)) * _e937)) + _e943));
                        let _e948 = global_3.member[_e945];
                        let _e952 = global_3.member[(_e945 + 1u)];
                        let _e958 = bitcast<vec4<f32>>(vec4<u32>(_e948.x, _e948.y, _e952.x, _e952.y));
                        let _e962 = global_6.member[(_e928 + _e943)];
                        let _e969 = global_6.member[((_e928 + _e907) + _e943)];
                        let _e977 = global_6.member[((_e928 + (2u * _e907)) + _e943)];
                        let _e981 = (_e941 + vec3<f32>(dot(unpack4x8snorm(_e962), _e958), dot(unpack4x8snorm(_e969), _e958), dot(unpack4x8snorm(_e977), _e958)));
                        let _e983 = (_e943 + bitcast<u32>(1i));
                        phi_5268_ = _e981;
                        phi_5267_ = _e983;
                        local_4 = _e981;
                        if (_e983 < _e907) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e989 = local_4;
                    phi_5277_ = (select(vec3<f32>(_e916.x, _e916.y, unpack2x16float(_e920).x), _e702, vec3(_e688)) + (_e989 * (127f * unpack2x16float(_e931).x)));
                }
                let _e993 = phi_5277_;
                let _e994 = normalize(_e811);
                let _e999 = (_e994.z * _e994.z);
                let _e1000 = (_e994.w * _e994.w);
                let _e1004 = (_e994.y * _e994.z);
                let _e1005 = (_e994.x * _e994.w);
                let _e1008 = (_e994.y * _e994.w);
                let _e1009 = (_e994.x * _e994.z);
                let _e1014 = (_e994.y * _e994.y);
                let _e1018 = (_e994.z * _e994.w);
                let _e1019 = (_e994.x * _e994.y);
                let _e1033 = exp(min(_e894, vec3<f32>(9f, 9f, 9f)));
                let _e1040 = mat3x3<f32>((vec3<f32>((1f - (2f * (_e999 + _e1000))), (2f * (_e1004 + _e1005)), (2f * (_e1008 - _e1009))) * _e1033.x), (vec3<f32>((2f * (_e1004 - _e1005)), (1f - (2f * (_e1014 + _e1000))), (2f * (_e1018 + _e1019))) * _e1033.y), (vec3<f32>((2f * (_e1008 + _e1009)), (2f * (_e1018 - _e1019)), (1f - (2f * (_e1014 + _e999)))) * _e1033.z));
                switch bitcast<i32>(0u) {
                    default: {
                        let _e1046 = global.member_2;
                        let _e1048 = global.member_3;
                        let _e1049 = clamp((_e369.xy / vec2(_e368)), _e1046, _e1048);
                        let _e1052 = global.member[0u];
                        let _e1058 = (((vec3<f32>(_e353.x, _e353.y, _e353.z) - (_e384 * _e1049.x)) * (_e1052 / _e368)) * _e1040);
                        let _e1061 = global.member[1u];
                        let _e1067 = (((vec3<f32>(_e359.x, _e359.y, _e359.z) - (_e384 * _e1049.y)) * (_e1061 / _e368)) * _e1040);
                        let _e1069 = global.member_51;
                        let _e1071 = (dot(_e1058, _e1058) + _e1069);
                        let _e1074 = (dot(_e1067, _e1067) + _e1069);
                        let _e1076 = cross(_e1058, _e1067);
                        let _e1077 = dot(_e1076, _e1076);
                        let _e1081 = (_e1077 + (_e1069 * ((_e1071 + _e1074) - _e1069)));
                        let _e1082 = (_e1081 > 0f);
                        phi_4660_ = _e1082;
                        if _e1082 {
                            phi_4660_ = (_e1071 <= 1000000000000000000f);
                        }
                        let _e1085 = phi_4660_;
                        phi_4666_ = _e1085;
                        if _e1085 {
                            phi_4666_ = (_e1074 <= 1000000000000000000f);
                        }
                        let _e1088 = phi_4666_;
                        if !(_e1088) {
                            let _e1091 = global_2.member_9;
                            if (_e1091 != 0u) {
                                let _e1095 = atomicAdd((&global_1.member[3u]), 1u);
                            }
                            phi_5296_ = 4294967295u;
                            break;
                        }
                        phi_5282_ = (1f - (_e629 * 0.003921569f));
                        phi_5281_ = 0u;
                        loop {
                            let _e1099 = phi_5282_;
                            let _e1101 = phi_5281_;
                            local_5 = _e1099;
                            if (_e1101 < _e79) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                phi_5282_ = (_e1099 * _e1099);
                                phi_5281_ = (_e1101 + bitcast<u32>(1i));
                            }
                        }
                        let _e1107 = local_5;
                        let _e1111 = u32(round((255f * (1f - _e1107))));
                        let _e1113 = global.member_52;
                        phi_5290_ = _e1111;
                        if (_e1113 > 0f) {
                            let _e1123 = u32(round((f32(_e1111) * ((1f - _e1113) + (_e1113 * sqrt((_e1077 / _e1081)))))));
                            if (f32(_e1123) <= _e631) {
                                let _e1127 = global_2.member_9;
                                if (_e1127 != 0u) {
                                    let _e1131 = atomicAdd((&global_1.member[2u]), 1u);
                                }
                                phi_5296_ = 4294967295u;
                                break;
                            }
                            phi_5290_ = _e1123;
                        }
                        let _e1133 = phi_5290_;
                        let _e1135 = global.member_49;
                        let _e1136 = (vec3<f32>(_e1071, dot(_e1058, _e1067), _e1074) * _e1135);
                        let _e1149 = global.member_53;
                        let _e1150 = ((sqrt(_e1136.xz) * sqrt((2f * log(max((f32(_e1133) / _e631), 1f))))) * _e1149);
                        let _e1153 = global.member_54;
                        let _e1156 = all(((_e616 + _e1150) > _e1153.xy));
                        phi_4744_ = _e1156;
                        if _e1156 {
                            phi_4744_ = all(((_e616 - _e1150) < _e1153.zw));
                        }
                        let _e1162 = phi_4744_;
                        if !(_e1162) {
                            let _e1165 = global_2.member_9;
                            if (_e1165 != 0u) {
                                let _e1169 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_5296_ = 4294967295u;
                            break;
                        }
                        let _e1174 = (0.5f * (_e1136.x - _e1136.z));
                        let _e1179 = sqrt(((_e1174 * _e1174) + (_e1136.y * _e1136.y)));
                        let _e1182 = ((0.5f * (_e1136.x + _e1136.z)) + _e1179);
                        if (_e1174 >= 0f) {
                            phi_5294_ = vec2<f32>((_e1174 + _e1179), _e1136.y);
                        } else {
                            phi_5294_ = vec2<f32>(_e1136.y, (_e1179 - _e1174));
                        }
                        let _e1189 = phi_5294_;
                        if (_e1179 > (0.00000001f * _e1182)) {
                            phi_5295_ = normalize(_e1189);
                        } else {
                            phi_5295_ = vec2<f32>(1f, 0f);
                        }
                        let _e1194 = phi_5295_;
                        let _e1201 = global.member_5;
                        let _e1205 = global.member_10;
                        let _e1209 = vec2<u32>(clamp(round(((_e616 + vec2(_e1201)) * _e1205)), vec2<f32>(0f, 0f), vec2<f32>(1048575f, 1048575f)));
                        let _e1212 = vec3<u32>(round((clamp(_e993, vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 1023f)));
                        let _e1240 = global.member_45;
                        let _e1242 = (4u * (_e1240 + _e71));
                        global_4.member[_e1242] = ((_e1209.x | (_e1212.x << bitcast<u32>(20u))) | (_e1212.z << bitcast<u32>(30u)));
                        global_4.member[(_e1242 + 1u)] = (_e1209.y | (_e1212.y << bitcast<u32>(20u)));
                        global_4.member[(_e1242 + 2u)] = pack2x16float((_e1194 * min(sqrt(_e1182), 65504f)));
                        global_4.member[(_e1242 + 3u)] = ((pack2x16float(vec2<f32>(min(sqrt(((_e1081 * (_e1135 * _e1135)) / _e1182)), 65504f), 0f)) | (_e1133 << bitcast<u32>(16u))) | ((_e1212.z >> bitcast<u32>(2u)) << bitcast<u32>(24u)));
                        let _e1255 = global.member_9;
                        phi_5296_ = min(u32((_e614 * f32(_e1255))), _e1255);
                        break;
                    }
                }
                let _e1261 = phi_5296_;
                phi_5297_ = _e1261;
                break;
            }
        }
        let _e1263 = phi_5297_;
        phi_5298_ = _e1263;
    } else {
        phi_5298_ = 4294967295u;
    }
    let _e1265 = phi_5298_;
    switch bitcast<i32>(0u) {
        default: {
            let _e1268 = bitcast<u32>(param[0u]);
            let _e1270 = global.member_45;
            let _e1271 = (_e1270 + _e71);
            if (_e1265 != 4294967295u) {
                let _e1274 = global.member_41;
                let _e1278 = global.member_40;
                let _e1284 = atomicAdd((&global_1.member[((_e1278 + ((_e1271 / _e1274) * 256u)) + (_e1265 & 255u))]), 1u);
            }
            let _e1286 = global.member_39;
            if (_e1286 == 0u) {
                if (_e71 < (_e73 + (_e73 & 1u))) {
                    let _e1292 = global.member_28;
                    global_4.member[(_e1292 + _e1271)] = _e1265;
                }
                break;
            }
            global_5[_e1268] = _e1265;
            workgroupBarrier();
            let _e1298 = ((_e1268 & 1u) == 0u);
            if select(_e1298, _e74, _e1298) {
                let _e1301 = global.member_28;
                let _e1308 = global_5[(_e1268 + 1u)];
                global_4.member[(_e1301 + (_e1271 >> bitcast<u32>(1u)))] = ((_e1265 & 65535u) | (_e1308 << bitcast<u32>(16u)));
            }
            break;
        }
    }
    return;
}
