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
    member_52: vec4<f32>,
    member_53: vec4<f32>,
    member_54: vec4<f32>,
    member_55: array<vec4<f32>, 3>,
    member_56: array<vec4<u32>, 8>,
    member_57: array<vec4<u32>, 8>,
    member_58: array<type_12, 8>,
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
    var phi_3547_: bool;
    var phi_5447_: f32;
    var phi_5448_: f32;
    var phi_5452_: u32;
    var phi_5458_: u32;
    var phi_5457_: f32;
    var phi_5455_: u32;
    var local: f32;
    var phi_5462_: bool;
    var phi_3593_: bool;
    var phi_5473_: f32;
    var phi_5464_: vec2<f32>;
    var phi_5463_: bool;
    var phi_5483_: vec4<f32>;
    var phi_5484_: vec4<f32>;
    var phi_5485_: vec4<f32>;
    var phi_5503_: vec3<f32>;
    var phi_5505_: vec4<f32>;
    var phi_5504_: u32;
    var local_1: vec4<f32>;
    var phi_5520_: vec4<f32>;
    var phi_5508_: vec3<f32>;
    var phi_5507_: u32;
    var local_2: vec3<f32>;
    var phi_5524_: vec3<f32>;
    var phi_5517_: vec3<f32>;
    var phi_5516_: u32;
    var local_3: vec3<f32>;
    var phi_5526_: vec3<f32>;
    var phi_5527_: vec3<f32>;
    var phi_5529_: vec3<f32>;
    var phi_5531_: vec3<f32>;
    var phi_3129_: bool;
    var phi_3143_: bool;
    var phi_4919_: bool;
    var phi_4925_: bool;
    var phi_5549_: f32;
    var phi_5548_: u32;
    var local_4: f32;
    var phi_4971_: bool;
    var phi_5555_: vec2<f32>;
    var phi_5556_: vec2<f32>;
    var phi_5557_: u32;
    var phi_5558_: u32;
    var phi_5559_: u32;

    let _e84 = bitcast<u32>(param_1[0u]);
    let _e86 = global.member_48;
    let _e87 = (_e84 < _e86);
    if _e87 {
        switch bitcast<i32>(0u) {
            default: {
                let _e90 = global.member_14;
                let _e92 = global.member_47;
                let _e94 = (_e84 << bitcast<u32>(_e92));
                let _e98 = (4u * (_e90 + (_e94 >> bitcast<u32>(5u))));
                let _e99 = (2u * _e94);
                let _e102 = global_7.member[_e99];
                let _e106 = global_7.member[(_e99 + 1u)];
                let _e111 = global_7.member[((2u * _e90) + _e94)];
                let _e122 = (vec2<f32>(f32(((_e111.y >> bitcast<u32>(16u)) & 31u)), f32(((_e111.y >> bitcast<u32>(21u)) & 31u))) * vec2<f32>(0.032258064f, 0.032258064f));
                let _e126 = ((1f + (2f * _e122.x)) * 0.33333334f);
                let _e127 = (1f - _e126);
                let _e131 = (_e127 * (0.5f + (0.5f * _e122.y)));
                let _e149 = global.member_11;
                let _e152 = global.member_12;
                let _e157 = global.member_21;
                let _e158 = (2u * _e157);
                let _e162 = global_3.member[(_e158 + (_e111.x & 65535u))];
                let _e164 = unpack2x16float(_e162.x);
                let _e176 = global_3.member[(_e158 + (_e111.x >> bitcast<u32>(16u)))];
                let _e178 = unpack2x16float(_e176.x);
                let _e190 = global_3.member[(_e158 + (_e111.y & 65535u))];
                let _e192 = unpack2x16float(_e190.x);
                let _e200 = ((((_e149.xyz + (_e152.xyz * vec3<f32>(f32((_e102.x & 65535u)), f32((_e102.x >> bitcast<u32>(16u))), f32((_e102.y & 65535u))))) + (vec3<f32>(_e164.x, _e164.y, unpack2x16float(_e162.y).x) * _e126)) + (vec3<f32>(_e178.x, _e178.y, unpack2x16float(_e176.y).x) * _e131)) + (vec3<f32>(_e192.x, _e192.y, unpack2x16float(_e190.y).x) * (_e127 - _e131)));
                let _e204 = vec4<f32>(_e200.x, _e200.y, _e200.z, 1f);
                let _e217 = (((_e102.y >> bitcast<u32>(16u)) | ((_e106.y >> bitcast<u32>(24u)) << bitcast<u32>(16u))) | ((_e111.y >> bitcast<u32>(26u)) << bitcast<u32>(24u)));
                let _e229 = global.member_36;
                let _e231 = global.member_37;
                let _e234 = (vec3(_e229) + (vec3<f32>(f32((_e217 & 1023u)), f32(((_e217 >> bitcast<u32>(10u)) & 1023u)), f32((_e217 >> bitcast<u32>(20u)))) * _e231));
                let _e243 = (vec4<u32>(_e106.x, (_e106.x >> bitcast<u32>(8u)), (_e106.x >> bitcast<u32>(16u)), (_e106.x >> bitcast<u32>(24u))) & vec4<u32>(255u, 255u, 255u, 255u));
                let _e249 = (vec3<u32>(_e106.y, (_e106.y >> bitcast<u32>(8u)), (_e106.y >> bitcast<u32>(16u))) & vec3<u32>(255u, 255u, 255u));
                let _e250 = vec3<f32>(_e249);
                let _e262 = (vec4<f32>(_e250.x, _e250.y, _e250.z, f32((((255u - _e249.x) - _e249.y) - _e249.z))) * vec4<f32>(0.003921569f, 0.003921569f, 0.003921569f, 0.003921569f));
                let _e265 = (3u * _e243.x);
                let _e268 = global.member_60[_e265];
                let _e273 = global.member_60[(_e265 + 1u)];
                let _e278 = global.member_60[(_e265 + 2u)];
                let _e282 = (3u * _e243.y);
                let _e285 = global.member_60[_e282];
                let _e291 = global.member_60[(_e282 + 1u)];
                let _e297 = global.member_60[(_e282 + 2u)];
                let _e302 = (3u * _e243.z);
                let _e305 = global.member_60[_e302];
                let _e311 = global.member_60[(_e302 + 1u)];
                let _e317 = global.member_60[(_e302 + 2u)];
                let _e322 = (3u * _e243.w);
                let _e325 = global.member_60[_e322];
                let _e327 = ((((_e268 * _e262.x) + (_e285 * _e262.y)) + (_e305 * _e262.z)) + (_e325 * _e262.w));
                let _e331 = global.member_60[(_e322 + 1u)];
                let _e333 = ((((_e273 * _e262.x) + (_e291 * _e262.y)) + (_e311 * _e262.z)) + (_e331 * _e262.w));
                let _e337 = global.member_60[(_e322 + 2u)];
                let _e339 = ((((_e278 * _e262.x) + (_e297 * _e262.y)) + (_e317 * _e262.z)) + (_e337 * _e262.w));
                let _e342 = dot(_e339, _e204);
                let _e343 = vec3<f32>(dot(_e327, _e204), dot(_e333, _e204), _e342);
                let _e344 = _e327.xyz;
                let _e345 = _e333.xyz;
                let _e346 = _e339.xyz;
                let _e356 = vec3<f32>(_e327.x, _e327.y, _e327.z);
                let _e357 = vec3<f32>(_e333.x, _e333.y, _e333.z);
                let _e358 = vec3<f32>(_e339.x, _e339.y, _e339.z);
                let _e374 = ((1.2f * exp(min(max(max(_e234.x, _e234.y), _e234.z), 9f))) * sqrt(max(max(dot(_e344, _e344), dot(_e345, _e345)), dot(_e346, _e346))));
                switch bitcast<i32>(0u) {
                    default: {
                        let _e377 = global.member_6;
                        if !((_e342 >= _e377)) {
                            let _e381 = global_2.member_9;
                            if (_e381 != 0u) {
                                let _e385 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_5473_ = 0f;
                            phi_5464_ = vec2<f32>(0f, 0f);
                            phi_5463_ = false;
                            break;
                        }
                        let _e387 = global.member;
                        let _e388 = _e343.xy;
                        let _e390 = vec2(_e342);
                        let _e393 = global.member_1;
                        let _e394 = (((_e387 * _e388) / _e390) + _e393);
                        let _e396 = global.member_5;
                        let _e400 = all((_e394 >= vec2(-(_e396))));
                        phi_3547_ = _e400;
                        if _e400 {
                            let _e402 = global.member_4;
                            phi_3547_ = all((_e394 <= (_e402 + vec2(_e396))));
                        }
                        let _e408 = phi_3547_;
                        if !(_e408) {
                            let _e411 = global_2.member_9;
                            if (_e411 != 0u) {
                                let _e415 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_5473_ = 0f;
                            phi_5464_ = _e394;
                            phi_5463_ = false;
                            break;
                        }
                        let _e417 = global.member_7;
                        let _e420 = global.member_8;
                        let _e421 = ((_e417 - _e342) * _e420);
                        if (_e421 < 0f) {
                            phi_5448_ = (0.015625f / (1f - _e421));
                        } else {
                            if (_e421 > 1f) {
                                phi_5447_ = (1f - (0.015625f / _e421));
                            } else {
                                phi_5447_ = (0.015625f + (0.96875f * clamp(_e421, 0f, 1f)));
                            }
                            let _e430 = phi_5447_;
                            phi_5448_ = _e430;
                        }
                        let _e434 = phi_5448_;
                        let _e435 = (_e388 / _e390);
                        let _e443 = global.member[0u];
                        let _e446 = global.member[1u];
                        let _e451 = global.member_31;
                        let _e452 = (_e451 > 0u);
                        phi_3593_ = _e452;
                        if _e452 {
                            let _e454 = global.member_34;
                            let _e457 = global.member_29;
                            let _e464 = global.member_49;
                            switch bitcast<i32>(0u) {
                                default: {
                                    let _e471 = vec2(((sqrt((2f * log(max((max(255f, _e454) / _e457), 1f)))) * sqrt(_e464)) * ((((_e374 * length(vec3<f32>(_e435.x, _e435.y, 1f))) * max(_e443, _e446)) / _e342) + 0.5477226f)));
                                    let _e474 = global.member_32;
                                    let _e477 = global.member_33;
                                    let _e485 = vec2<u32>(clamp(((((_e394 - _e471) - _e474) * _e477) - vec2<f32>(0.5f, 0.5f)), vec2<f32>(0f, 0f), vec2<f32>(191f, 191f)));
                                    let _e487 = vec2<u32>(clamp(((((_e394 + _e471) - _e474) * _e477) + vec2<f32>(0.5f, 0.5f)), vec2<f32>(0f, 0f), vec2<f32>(191f, 191f)));
                                    let _e494 = max((_e487.x - _e485.x), (_e487.y - _e485.y));
                                    if (_e494 <= 3u) {
                                        phi_5452_ = 0u;
                                    } else {
                                        phi_5452_ = (bitcast<u32>(firstLeadingBit((_e494 - 1u))) - 1u);
                                    }
                                    let _e501 = phi_5452_;
                                    if !((_e501 < 4u)) {
                                        phi_5462_ = false;
                                        break;
                                    }
                                    let _e511 = vec2(_e501);
                                    let _e513 = (_e485 >> bitcast<vec2<u32>>(_e511));
                                    let _e515 = (_e487 >> bitcast<vec2<u32>>(_e511));
                                    let _e517 = (_e513.x & 4294967292u);
                                    phi_5458_ = _e517;
                                    phi_5457_ = 0f;
                                    phi_5455_ = _e513.y;
                                    loop {
                                        let _e520 = phi_5458_;
                                        let _e522 = phi_5457_;
                                        let _e524 = phi_5455_;
                                        local = _e522;
                                        if (_e524 <= _e515.y) {
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e529 = (vec4(f32(_e520)) + vec4<f32>(0f, 1f, 2f, 3f));
                                            let _e547 = global_3.member[((_e451 >> bitcast<u32>(1u)) + ((((4u * (12288u - (12288u >> bitcast<u32>((2u * _e501))))) + (_e524 * (192u >> bitcast<u32>(_e501)))) + _e520) >> bitcast<u32>(2u)))];
                                            let _e549 = unpack2x16unorm(_e547.x);
                                            let _e551 = unpack2x16unorm(_e547.y);
                                            let _e558 = select(select(vec4<f32>(_e549.x, _e549.y, _e551.x, _e551.y), vec4<f32>(0f, 0f, 0f, 0f), (_e529 < vec4(f32(_e513.x)))), vec4<f32>(0f, 0f, 0f, 0f), (_e529 > vec4(f32(_e515.x))));
                                            let _e567 = (_e520 + 4u);
                                            let _e568 = (_e567 > _e515.x);
                                            phi_5458_ = select(_e567, _e517, _e568);
                                            phi_5457_ = max(_e522, max(max(_e558.x, _e558.y), max(_e558.z, _e558.w)));
                                            phi_5455_ = (_e524 + select(0u, 1u, _e568));
                                        }
                                    }
                                    let _e573 = local;
                                    phi_5462_ = ((1f - _e434) > _e573);
                                    break;
                                }
                            }
                            let _e576 = phi_5462_;
                            phi_3593_ = _e576;
                        }
                        let _e578 = phi_3593_;
                        if _e578 {
                            let _e580 = global_2.member_9;
                            if (_e580 != 0u) {
                                let _e584 = atomicAdd((&global_1.member[1u]), 1u);
                            }
                            phi_5473_ = _e434;
                            phi_5464_ = _e394;
                            phi_5463_ = false;
                            break;
                        }
                        phi_5473_ = _e434;
                        phi_5464_ = _e394;
                        phi_5463_ = true;
                        break;
                    }
                }
                let _e586 = phi_5473_;
                let _e588 = phi_5464_;
                let _e590 = phi_5463_;
                let _e591 = (3u * _e90);
                let _e595 = global_7.member[(_e591 + _e94)];
                let _e598 = (_e595.y >> bitcast<u32>(24u));
                let _e612 = ((vec3<f32>(f32((_e595.x & 1023u)), f32(((_e595.x >> bitcast<u32>(10u)) & 1023u)), f32(((_e595.x >> bitcast<u32>(20u)) & 1023u))) - vec3<f32>(512f, 512f, 512f)) * vec3<f32>(0.0013888889f, 0.0013888889f, 0.0013888889f));
                let _e616 = sqrt(max((1f - dot(_e612, _e612)), 0f));
                let _e618 = (_e595.x >> bitcast<u32>(30u));
                if (_e618 == 0u) {
                    phi_5485_ = vec4<f32>(_e616, _e612.x, _e612.y, _e612.z);
                } else {
                    if (_e618 == 1u) {
                        phi_5484_ = vec4<f32>(_e612.x, _e616, _e612.y, _e612.z);
                    } else {
                        if (_e618 == 2u) {
                            phi_5483_ = vec4<f32>(_e612.x, _e612.y, _e616, _e612.z);
                        } else {
                            phi_5483_ = vec4<f32>(_e612.x, _e612.y, _e612.z, _e616);
                        }
                        let _e631 = phi_5483_;
                        phi_5484_ = _e631;
                    }
                    let _e637 = phi_5484_;
                    phi_5485_ = _e637;
                }
                let _e643 = phi_5485_;
                let _e647 = global.member_38;
                let _e648 = (_e647 > 0u);
                phi_5503_ = unpack4x8unorm(_e595.y).xyz;
                if _e648 {
                    let _e652 = global_7.member[(_e647 + _e94)];
                    let _e654 = unpack2x16float(_e652.x);
                    phi_5503_ = vec3<f32>(_e654.x, _e654.y, unpack2x16float(_e652.y).x);
                }
                let _e662 = phi_5503_;
                let _e665 = (1u << bitcast<u32>((_e94 & 31u)));
                let _e668 = global_7.member[_e98];
                let _e672 = global_7.member[(_e98 + 1u)];
                let _e676 = global_7.member[(_e98 + 2u)];
                phi_5520_ = _e643;
                if ((_e668.x & _e665) != 0u) {
                    let _e687 = global.member_22;
                    let _e689 = global.member_18;
                    let _e693 = (_e687 + ((_e672.y + bitcast<u32>(countOneBits((_e668.x & (_e665 - 1u))))) * (1u + (4u * _e689))));
                    let _e694 = (_e693 + 1u);
                    let _e697 = global_6.member[_e693];
                    let _e699 = global.member_44;
                    let _e703 = global.member_19;
                    phi_5505_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_5504_ = 0u;
                    loop {
                        let _e707 = phi_5505_;
                        let _e709 = phi_5504_;
                        let _e711 = (2u * ((_e699 + ((_e697 >> bitcast<u32>(16u)) * _e703)) + _e709));
                        let _e714 = global_3.member[_e711];
                        let _e718 = global_3.member[(_e711 + 1u)];
                        let _e724 = bitcast<vec4<f32>>(vec4<u32>(_e714.x, _e714.y, _e718.x, _e718.y));
                        let _e728 = global_6.member[(_e694 + _e709)];
                        let _e735 = global_6.member[((_e694 + _e689) + _e709)];
                        let _e743 = global_6.member[((_e694 + (2u * _e689)) + _e709)];
                        let _e751 = global_6.member[((_e694 + (3u * _e689)) + _e709)];
                        let _e755 = (_e707 + vec4<f32>(dot(unpack4x8snorm(_e728), _e724), dot(unpack4x8snorm(_e735), _e724), dot(unpack4x8snorm(_e743), _e724), dot(unpack4x8snorm(_e751), _e724)));
                        let _e757 = (_e709 + bitcast<u32>(1i));
                        phi_5505_ = _e755;
                        phi_5504_ = _e757;
                        local_1 = _e755;
                        if (_e757 < _e689) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e763 = local_1;
                    let _e765 = (_e643 + (_e763 * (127f * unpack2x16float(_e697).x)));
                    phi_5520_ = select(_e643, _e765, vec4((length(_e765) >= 0.001f)));
                }
                let _e771 = phi_5520_;
                phi_5524_ = _e234;
                if ((_e668.y & _e665) != 0u) {
                    let _e782 = global.member_23;
                    let _e784 = global.member_18;
                    let _e788 = (_e782 + ((_e676.x + bitcast<u32>(countOneBits((_e668.y & (_e665 - 1u))))) * (1u + (3u * _e784))));
                    let _e789 = (_e788 + 1u);
                    let _e792 = global_6.member[_e788];
                    let _e794 = global.member_44;
                    let _e798 = global.member_19;
                    phi_5508_ = vec3<f32>(0f, 0f, 0f);
                    phi_5507_ = 0u;
                    loop {
                        let _e802 = phi_5508_;
                        let _e804 = phi_5507_;
                        let _e806 = (2u * ((_e794 + ((_e792 >> bitcast<u32>(16u)) * _e798)) + _e804));
                        let _e809 = global_3.member[_e806];
                        let _e813 = global_3.member[(_e806 + 1u)];
                        let _e819 = bitcast<vec4<f32>>(vec4<u32>(_e809.x, _e809.y, _e813.x, _e813.y));
                        let _e823 = global_6.member[(_e789 + _e804)];
                        let _e830 = global_6.member[((_e789 + _e784) + _e804)];
                        let _e838 = global_6.member[((_e789 + (2u * _e784)) + _e804)];
                        let _e842 = (_e802 + vec3<f32>(dot(unpack4x8snorm(_e823), _e819), dot(unpack4x8snorm(_e830), _e819), dot(unpack4x8snorm(_e838), _e819)));
                        let _e844 = (_e804 + bitcast<u32>(1i));
                        phi_5508_ = _e842;
                        phi_5507_ = _e844;
                        local_2 = _e842;
                        if (_e844 < _e784) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e850 = local_2;
                    phi_5524_ = (_e234 + (_e850 * (127f * unpack2x16float(_e792).x)));
                }
                let _e854 = phi_5524_;
                phi_5526_ = _e662;
                if ((_e672.x & _e665) != 0u) {
                    let _e865 = global.member_24;
                    let _e867 = global.member_18;
                    let _e871 = (_e865 + ((_e676.y + bitcast<u32>(countOneBits((_e672.x & (_e665 - 1u))))) * (3u + (3u * _e867))));
                    let _e875 = global_6.member[(_e871 + 1u)];
                    let _e876 = unpack2x16float(_e875);
                    let _e880 = global_6.member[(_e871 + 2u)];
                    let _e888 = (_e871 + 3u);
                    let _e891 = global_6.member[_e871];
                    let _e893 = global.member_44;
                    let _e897 = global.member_19;
                    phi_5517_ = vec3<f32>(0f, 0f, 0f);
                    phi_5516_ = 0u;
                    loop {
                        let _e901 = phi_5517_;
                        let _e903 = phi_5516_;
                        let _e905 = (2u * ((_e893 + ((_e891 >> bitcast<u32>(16u)) * _e897)) + _e903));
                        let _e908 = global_3.member[_e905];
                        let _e912 = global_3.member[(_e905 + 1u)];
                        let _e918 = bitcast<vec4<f32>>(vec4<u32>(_e908.x, _e908.y, _e912.x, _e912.y));
                        let _e922 = global_6.member[(_e888 + _e903)];
                        let _e929 = global_6.member[((_e888 + _e867) + _e903)];
                        let _e937 = global_6.member[((_e888 + (2u * _e867)) + _e903)];
                        let _e941 = (_e901 + vec3<f32>(dot(unpack4x8snorm(_e922), _e918), dot(unpack4x8snorm(_e929), _e918), dot(unpack4x8snorm(_e937), _e918)));
                        let _e943 = (_e903 + bitcast<u32>(1i));
                        phi_5517_ = _e941;
                        phi_5516_ = _e943;
                        local_3 = _e941;
                        if (_e943 < _e867) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e949 = local_3;
                    phi_5526_ = (select(vec3<f32>(_e876.x, _e876.y, unpack2x16float(_e880).x), _e662, vec3(_e648)) + (_e949 * (127f * unpack2x16float(_e891).x)));
                }
                let _e953 = phi_5526_;
                let _e954 = normalize(_e771);
                let _e959 = (_e954.z * _e954.z);
                let _e960 = (_e954.w * _e954.w);
                let _e964 = (_e954.y * _e954.z);
                let _e965 = (_e954.x * _e954.w);
                let _e968 = (_e954.y * _e954.w);
                let _e969 = (_e954.x * _e954.z);
                let _e974 = (_e954.y * _e954.y);
                let _e978 = (_e954.z * _e954.w);
                let _e979 = (_e954.x * _e954.y);
                let _e993 = exp(min(_e854, vec3<f32>(9f, 9f, 9f)));
                let _e1000 = mat3x3<f32>((vec3<f32>((1f - (2f * (_e959 + _e960))), (2f * (_e964 + _e965)), (2f * (_e968 - _e969))) * _e993.x), (vec3<f32>((2f * (_e964 - _e965)), (1f - (2f * (_e974 + _e960))), (2f * (_e978 + _e979))) * _e993.y), (vec3<f32>((2f * (_e968 + _e969)), (2f * (_e978 - _e979)), (1f - (2f * (_e974 + _e959)))) * _e993.z));
                let _e1002 = (transpose(mat3x3<f32>(_e356, _e357, _e358)) * _e1000);
                let _e1004 = global.member_42;
                let _e1005 = (3u * _e84);
                let _e1006 = (_e1004 + _e1005);
                let _e1007 = transpose(_e1002);
                let _e1017 = max(_e374, sqrt(max(max(dot(_e1007[0], _e1007[0]), dot(_e1007[1], _e1007[1])), dot(_e1007[2], _e1007[2]))));
                let _e1019 = global.member_43;
                let _e1030 = (all((abs(_e343) < vec3<f32>(1000000000000000000000000000000f, 1000000000000000000000000000000f, 1000000000000000000000000000000f))) && (_e1017 <= 1000000000000000000f));
                if _e1030 {
                    let _e1032 = global.member_53;
                    let _e1036 = global.member_54;
                    phi_5527_ = ((_e343 - _e1032.xyz) / _e1036.xyz);
                } else {
                    phi_5527_ = vec3<f32>(0f, 0f, 0f);
                }
                let _e1040 = phi_5527_;
                let _e1057 = vec3<u32>(round((clamp(select(select((vec3<f32>(0.015625f, 0.015625f, 0.015625f) + (clamp(_e1040, vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 0.96875f)), (vec3<f32>(0.015625f, 0.015625f, 0.015625f) / (vec3<f32>(1f, 1f, 1f) - min(_e1040, vec3<f32>(0f, 0f, 0f)))), (_e1040 < vec3<f32>(0f, 0f, 0f))), (vec3<f32>(1f, 1f, 1f) - (vec3<f32>(0.015625f, 0.015625f, 0.015625f) / max(_e1040, vec3<f32>(1f, 1f, 1f)))), (_e1040 > vec3<f32>(1f, 1f, 1f))), vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 16777215f)));
                let _e1059 = (_e1057 >> bitcast<vec3<u32>>(vec3<u32>(8u, 8u, 8u)));
                let _e1060 = (_e1057 & vec3<u32>(255u, 255u, 255u));
                let _e1076 = ((_e1059.z | (u32(clamp(select(0f, ceil(((8f * log2(max((_e1017 / _e1019), 0.000000000000000000000000000001f))) + 152f)), _e1030), 0f, 255f)) << bitcast<u32>(16u))) | (select(0u, _e598, _e1030) << bitcast<u32>(24u)));
                let _e1093 = vec3<f32>(_e1002[0].x, _e1002[1].x, _e1002[2].x);
                let _e1100 = vec3<f32>(_e1002[0].y, _e1002[1].y, _e1002[2].y);
                let _e1107 = vec3<f32>(_e1002[0].z, _e1002[1].z, _e1002[2].z);
                let _e1108 = length(_e1093);
                if (_e1108 > 0f) {
                    phi_5529_ = (_e1093 / vec3(_e1108));
                } else {
                    phi_5529_ = vec3<f32>(0f, 0f, 0f);
                }
                let _e1113 = phi_5529_;
                let _e1114 = dot(_e1100, _e1113);
                let _e1116 = (_e1100 - (_e1113 * _e1114));
                let _e1117 = length(_e1116);
                if (_e1117 > 0f) {
                    phi_5531_ = (_e1116 / vec3(_e1117));
                } else {
                    phi_5531_ = vec3<f32>(0f, 0f, 0f);
                }
                let _e1122 = phi_5531_;
                let _e1123 = dot(_e1107, _e1113);
                let _e1124 = dot(_e1107, _e1122);
                let _e1138 = (1023f / (_e1019 * exp2(((f32(((_e1076 >> bitcast<u32>(16u)) & 255u)) * 0.125f) - 19f))));
                let _e1156 = vec3<u32>(round((clamp(_e953, vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 1023f)));
                let _e1159 = ((vec3<u32>(clamp((round((vec3<f32>(_e1108, _e1117, _e1124) * _e1138)) + vec3<f32>(1023f, 1023f, 1023f)), vec3<f32>(0f, 0f, 0f), vec3<f32>(2046f, 2046f, 2046f))) | (vec3<u32>(clamp((round((vec3<f32>(_e1114, _e1123, length(((_e1107 - (_e1113 * _e1123)) - (_e1122 * _e1124)))) * _e1138)) + vec3<f32>(1023f, 1023f, 1023f)), vec3<f32>(0f, 0f, 0f), vec3<f32>(2046f, 2046f, 2046f))) << bitcast<vec3<u32>>(vec3<u32>(11u, 11u, 11u)))) | (_e1156 << bitcast<vec3<u32>>(vec3<u32>(22u, 22u, 22u))));
                global_4.member[_e1006] = (_e1059.x | (_e1059.y << bitcast<u32>(16u)));
                global_4.member[(_e1006 + 1u)] = _e1076;
                global_4.member[(_e1006 + 2u)] = ((_e1060.x | (_e1060.y << bitcast<u32>(8u))) | (_e1060.z << bitcast<u32>(16u)));
                let _e1169 = ((_e1004 + _e591) + _e1005);
                global_4.member[_e1169] = _e1159.x;
                global_4.member[(_e1169 + 1u)] = _e1159.y;
                global_4.member[(_e1169 + 2u)] = _e1159.z;
                phi_3129_ = _e590;
                if _e590 {
                    let _e1183 = global.member_29;
                    phi_3129_ = (f32(_e598) <= _e1183);
                }
                let _e1186 = phi_3129_;
                if _e1186 {
                    let _e1188 = global_2.member_9;
                    if (_e1188 != 0u) {
                        let _e1192 = atomicAdd((&global_1.member[2u]), 1u);
                    }
                }
                let _e1193 = !(_e590);
                phi_3143_ = _e1193;
                if !(_e1193) {
                    let _e1197 = global.member_29;
                    phi_3143_ = (f32(_e598) <= _e1197);
                }
                let _e1200 = phi_3143_;
                if _e1200 {
                    phi_5558_ = 4294967295u;
                    break;
                }
                switch bitcast<i32>(0u) {
                    default: {
                        let _e1206 = global.member_2;
                        let _e1208 = global.member_3;
                        let _e1209 = clamp((_e343.xy / vec2(_e342)), _e1206, _e1208);
                        let _e1212 = global.member[0u];
                        let _e1218 = (((_e356 - (_e358 * _e1209.x)) * (_e1212 / _e342)) * _e1000);
                        let _e1221 = global.member[1u];
                        let _e1227 = (((_e357 - (_e358 * _e1209.y)) * (_e1221 / _e342)) * _e1000);
                        let _e1229 = (dot(_e1218, _e1218) + 0.3f);
                        let _e1232 = (dot(_e1227, _e1227) + 0.3f);
                        let _e1234 = cross(_e1218, _e1227);
                        let _e1239 = (dot(_e1234, _e1234) + (0.3f * ((_e1229 + _e1232) - 0.3f)));
                        let _e1240 = (_e1239 > 0f);
                        phi_4919_ = _e1240;
                        if _e1240 {
                            phi_4919_ = (_e1229 <= 1000000000000000000f);
                        }
                        let _e1243 = phi_4919_;
                        phi_4925_ = _e1243;
                        if _e1243 {
                            phi_4925_ = (_e1232 <= 1000000000000000000f);
                        }
                        let _e1246 = phi_4925_;
                        if !(_e1246) {
                            let _e1249 = global_2.member_9;
                            if (_e1249 != 0u) {
                                let _e1253 = atomicAdd((&global_1.member[3u]), 1u);
                            }
                            phi_5557_ = 4294967295u;
                            break;
                        }
                        let _e1255 = global.member_49;
                        let _e1256 = (vec3<f32>(_e1229, dot(_e1218, _e1227), _e1232) * _e1255);
                        phi_5549_ = (1f - (f32(_e598) * 0.003921569f));
                        phi_5548_ = 0u;
                        loop {
                            let _e1263 = phi_5549_;
                            let _e1265 = phi_5548_;
                            local_4 = _e1263;
                            if (_e1265 < _e92) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                phi_5549_ = (_e1263 * _e1263);
                                phi_5548_ = (_e1265 + bitcast<u32>(1i));
                            }
                        }
                        let _e1271 = local_4;
                        let _e1275 = u32(round((255f * (1f - _e1271))));
                        let _e1278 = global.member_34;
                        let _e1281 = global.member_29;
                        let _e1291 = global.member_51;
                        let _e1292 = ((sqrt(_e1256.xz) * sqrt((2f * log(max((max(f32(_e1275), _e1278) / _e1281), 1f))))) * _e1291);
                        let _e1295 = global.member_52;
                        let _e1298 = all(((_e588 + _e1292) > _e1295.xy));
                        phi_4971_ = _e1298;
                        if _e1298 {
                            phi_4971_ = all(((_e588 - _e1292) < _e1295.zw));
                        }
                        let _e1304 = phi_4971_;
                        if !(_e1304) {
                            let _e1307 = global_2.member_9;
                            if (_e1307 != 0u) {
                                let _e1311 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_5557_ = 4294967295u;
                            break;
                        }
                        let _e1315 = (0.5f * (_e1256.x - _e1256.z));
                        let _e1320 = sqrt(((_e1315 * _e1315) + (_e1256.y * _e1256.y)));
                        let _e1323 = ((0.5f * (_e1256.x + _e1256.z)) + _e1320);
                        if (_e1315 >= 0f) {
                            phi_5555_ = vec2<f32>((_e1315 + _e1320), _e1256.y);
                        } else {
                            phi_5555_ = vec2<f32>(_e1256.y, (_e1320 - _e1315));
                        }
                        let _e1330 = phi_5555_;
                        let _e1331 = length(_e1330);
                        if (_e1331 > 0f) {
                            phi_5556_ = (_e1330 / vec2(_e1331));
                        } else {
                            phi_5556_ = vec2<f32>(1f, 0f);
                        }
                        let _e1336 = phi_5556_;
                        let _e1343 = global.member_5;
                        let _e1347 = global.member_10;
                        let _e1351 = vec2<u32>(clamp(round(((_e588 + vec2(_e1343)) * _e1347)), vec2<f32>(0f, 0f), vec2<f32>(1048575f, 1048575f)));
                        let _e1379 = global.member_45;
                        let _e1381 = (4u * (_e1379 + _e84));
                        global_4.member[_e1381] = ((_e1351.x | (_e1156.x << bitcast<u32>(20u))) | (_e1156.z << bitcast<u32>(30u)));
                        global_4.member[(_e1381 + 1u)] = (_e1351.y | (_e1156.y << bitcast<u32>(20u)));
                        global_4.member[(_e1381 + 2u)] = pack2x16float((_e1336 * min(sqrt(_e1323), 65504f)));
                        global_4.member[(_e1381 + 3u)] = ((pack2x16float(vec2<f32>(min(sqrt(((_e1239 * (_e1255 * _e1255)) / _e1323)), 65504f), 0f)) | (_e1275 << bitcast<u32>(16u))) | ((_e1156.z >> bitcast<u32>(2u)) << bitcast<u32>(24u)));
                        let _e1394 = global.member_9;
                        phi_5557_ = min(u32((_e586 * f32(_e1394))), _e1394);
                        break;
                    }
                }
                let _e1400 = phi_5557_;
                phi_5558_ = _e1400;
                break;
            }
        }
        let _e1402 = phi_5558_;
        phi_5559_ = _e1402;
    } else {
        phi_5559_ = 4294967295u;
    }
    let _e1404 = phi_5559_;
    switch bitcast<i32>(0u) {
        default: {
            let _e1407 = bitcast<u32>(param[0u]);
            let _e1409 = global.member_45;
            let _e1410 = (_e1409 + _e84);
            if (_e1404 != 4294967295u) {
                let _e1413 = global.member_41;
                let _e1417 = global.member_40;
                let _e1423 = atomicAdd((&global_1.member[((_e1417 + ((_e1410 / _e1413) * 256u)) + (_e1404 & 255u))]), 1u);
            }
            let _e1425 = global.member_39;
            if (_e1425 == 0u) {
                if (_e84 < (_e86 + (_e86 & 1u))) {
                    let _e1431 = global.member_28;
                    global_4.member[(_e1431 + _e1410)] = _e1404;
                }
                break;
            }
            global_5[_e1407] = _e1404;
            workgroupBarrier();
            let _e1437 = ((_e1407 & 1u) == 0u);
            if select(_e1437, _e87, _e1437) {
                let _e1440 = global.member_28;
                let _e1447 = global_5[(_e1407 + 1u)];
                global_4.member[(_e1440 + (_e1410 >> bitcast<u32>(1u)))] = ((_e1404 & 65535u) | (_e1447 << bitcast<u32>(16u)));
            }
            break;
        }
    }
    return;
}
