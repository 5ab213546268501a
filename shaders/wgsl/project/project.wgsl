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
    var phi_5089_: u32;
    var phi_5088_: bool;
    var phi_3104_: bool;
    var local: bool;
    var phi_3512_: bool;
    var phi_5091_: f32;
    var phi_5092_: f32;
    var phi_5096_: u32;
    var phi_5102_: u32;
    var phi_5101_: f32;
    var phi_5099_: u32;
    var local_1: f32;
    var phi_5106_: bool;
    var phi_3558_: bool;
    var phi_5117_: f32;
    var phi_5108_: vec2<f32>;
    var phi_5107_: bool;
    var phi_5127_: vec4<f32>;
    var phi_5128_: vec4<f32>;
    var phi_5129_: vec4<f32>;
    var phi_5147_: vec3<f32>;
    var phi_5149_: vec4<f32>;
    var phi_5148_: u32;
    var local_2: vec4<f32>;
    var phi_5164_: vec4<f32>;
    var phi_5152_: vec3<f32>;
    var phi_5151_: u32;
    var local_3: vec3<f32>;
    var phi_5168_: vec3<f32>;
    var phi_5161_: vec3<f32>;
    var phi_5160_: u32;
    var local_4: vec3<f32>;
    var phi_5170_: vec3<f32>;
    var phi_4588_: bool;
    var phi_4594_: bool;
    var phi_5178_: f32;
    var phi_5177_: u32;
    var local_5: f32;
    var phi_4640_: bool;
    var phi_5184_: vec2<f32>;
    var phi_5185_: vec2<f32>;
    var phi_5186_: u32;
    var phi_5187_: u32;
    var phi_5188_: u32;

    let _e72 = bitcast<u32>(param_1[0u]);
    let _e74 = global.member_48;
    let _e75 = (_e72 < _e74);
    if _e75 {
        switch bitcast<i32>(0u) {
            default: {
                let _e78 = global.member_14;
                let _e80 = global.member_47;
                let _e82 = (_e72 << bitcast<u32>(_e80));
                let _e86 = (4u * (_e78 + (_e82 >> bitcast<u32>(5u))));
                let _e91 = global_7.member[(_e86 + 3u)][0u];
                phi_5089_ = (_e91 & 65535u);
                phi_5088_ = true;
                loop {
                    let _e94 = phi_5089_;
                    let _e96 = phi_5088_;
                    local = _e96;
                    phi_3104_ = _e96;
                    if _e96 {
                        phi_3104_ = (_e94 <= (_e91 >> bitcast<u32>(16u)));
                    }
                    let _e101 = phi_3104_;
                    if _e101 {
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e110 = global.member_57[(_e94 >> bitcast<u32>(7u))][((_e94 >> bitcast<u32>(5u)) & 3u)];
                        phi_5089_ = (_e94 + bitcast<u32>(1i));
                        phi_5088_ = (((_e110 >> bitcast<u32>((_e94 & 31u))) & 1u) != 0u);
                    }
                }
                let _e119 = local;
                if _e119 {
                    let _e121 = global_2.member_9;
                    if (_e121 != 0u) {
                        let _e125 = atomicAdd((&global_1.member[0u]), 1u);
                    }
                    phi_5187_ = 4294967295u;
                    break;
                }
                let _e126 = (2u * _e82);
                let _e129 = global_7.member[_e126];
                let _e133 = global_7.member[(_e126 + 1u)];
                let _e138 = global_7.member[((2u * _e78) + _e82)];
                let _e149 = (vec2<f32>(f32(((_e138.y >> bitcast<u32>(16u)) & 31u)), f32(((_e138.y >> bitcast<u32>(21u)) & 31u))) * vec2<f32>(0.032258064f, 0.032258064f));
                let _e153 = ((1f + (2f * _e149.x)) * 0.33333334f);
                let _e154 = (1f - _e153);
                let _e158 = (_e154 * (0.5f + (0.5f * _e149.y)));
                let _e176 = global.member_11;
                let _e179 = global.member_12;
                let _e184 = global.member_21;
                let _e185 = (2u * _e184);
                let _e189 = global_3.member[(_e185 + (_e138.x & 65535u))];
                let _e191 = unpack2x16float(_e189.x);
                let _e203 = global_3.member[(_e185 + (_e138.x >> bitcast<u32>(16u)))];
                let _e205 = unpack2x16float(_e203.x);
                let _e217 = global_3.member[(_e185 + (_e138.y & 65535u))];
                let _e219 = unpack2x16float(_e217.x);
                let _e227 = ((((_e176.xyz + (_e179.xyz * vec3<f32>(f32((_e129.x & 65535u)), f32((_e129.x >> bitcast<u32>(16u))), f32((_e129.y & 65535u))))) + (vec3<f32>(_e191.x, _e191.y, unpack2x16float(_e189.y).x) * _e153)) + (vec3<f32>(_e205.x, _e205.y, unpack2x16float(_e203.y).x) * _e158)) + (vec3<f32>(_e219.x, _e219.y, unpack2x16float(_e217.y).x) * (_e154 - _e158)));
                let _e231 = vec4<f32>(_e227.x, _e227.y, _e227.z, 1f);
                let _e244 = (((_e129.y >> bitcast<u32>(16u)) | ((_e133.y >> bitcast<u32>(24u)) << bitcast<u32>(16u))) | ((_e138.y >> bitcast<u32>(26u)) << bitcast<u32>(24u)));
                let _e256 = global.member_36;
                let _e258 = global.member_37;
                let _e261 = (vec3(_e256) + (vec3<f32>(f32((_e244 & 1023u)), f32(((_e244 >> bitcast<u32>(10u)) & 1023u)), f32((_e244 >> bitcast<u32>(20u)))) * _e258));
                let _e270 = (vec4<u32>(_e133.x, (_e133.x >> bitcast<u32>(8u)), (_e133.x >> bitcast<u32>(16u)), (_e133.x >> bitcast<u32>(24u))) & vec4<u32>(255u, 255u, 255u, 255u));
                let _e276 = (vec3<u32>(_e133.y, (_e133.y >> bitcast<u32>(8u)), (_e133.y >> bitcast<u32>(16u))) & vec3<u32>(255u, 255u, 255u));
                let _e277 = vec3<f32>(_e276);
                let _e289 = (vec4<f32>(_e277.x, _e277.y, _e277.z, f32((((255u - _e276.x) - _e276.y) - _e276.z))) * vec4<f32>(0.003921569f, 0.003921569f, 0.003921569f, 0.003921569f));
                let _e292 = (3u * _e270.x);
                let _e295 = global.member_60[_e292];
                let _e300 = global.member_60[(_e292 + 1u)];
                let _e305 = global.member_60[(_e292 + 2u)];
                let _e309 = (3u * _e270.y);
                let _e312 = global.member_60[_e309];
                let _e318 = global.member_60[(_e309 + 1u)];
                let _e324 = global.member_60[(_e309 + 2u)];
                let _e329 = (3u * _e270.z);
                let _e332 = global.member_60[_e329];
                let _e338 = global.member_60[(_e329 + 1u)];
                let _e344 = global.member_60[(_e329 + 2u)];
                let _e349 = (3u * _e270.w);
                let _e352 = global.member_60[_e349];
                let _e354 = ((((_e295 * _e289.x) + (_e312 * _e289.y)) + (_e332 * _e289.z)) + (_e352 * _e289.w));
                let _e358 = global.member_60[(_e349 + 1u)];
                let _e360 = ((((_e300 * _e289.x) + (_e318 * _e289.y)) + (_e338 * _e289.z)) + (_e358 * _e289.w));
                let _e364 = global.member_60[(_e349 + 2u)];
                let _e366 = ((((_e305 * _e289.x) + (_e324 * _e289.y)) + (_e344 * _e289.z)) + (_e364 * _e289.w));
                let _e369 = dot(_e366, _e231);
                let _e370 = vec3<f32>(dot(_e354, _e231), dot(_e360, _e231), _e369);
                let _e371 = _e354.xyz;
                let _e372 = _e360.xyz;
                let _e373 = _e366.xyz;
                let _e385 = vec3<f32>(_e366.x, _e366.y, _e366.z);
                switch bitcast<i32>(0u) {
                    default: {
                        let _e403 = global.member_6;
                        if !((_e369 >= _e403)) {
                            let _e407 = global_2.member_9;
                            if (_e407 != 0u) {
                                let _e411 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_5117_ = 0f;
                            phi_5108_ = vec2<f32>(0f, 0f);
                            phi_5107_ = false;
                            break;
                        }
                        let _e413 = global.member;
                        let _e414 = _e370.xy;
                        let _e416 = vec2(_e369);
                        let _e419 = global.member_1;
                        let _e420 = (((_e413 * _e414) / _e416) + _e419);
                        let _e422 = global.member_5;
                        let _e426 = all((_e420 >= vec2(-(_e422))));
                        phi_3512_ = _e426;
                        if _e426 {
                            let _e428 = global.member_4;
                            phi_3512_ = all((_e420 <= (_e428 + vec2(_e422))));
                        }
                        let _e434 = phi_3512_;
                        if !(_e434) {
                            let _e437 = global_2.member_9;
                            if (_e437 != 0u) {
                                let _e441 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_5117_ = 0f;
                            phi_5108_ = _e420;
                            phi_5107_ = false;
                            break;
                        }
                        let _e443 = global.member_7;
                        let _e446 = global.member_8;
                        let _e447 = ((_e443 - _e369) * _e446);
                        if (_e447 < 0f) {
                            phi_5092_ = (0.015625f / (1f - _e447));
                        } else {
                            if (_e447 > 1f) {
                                phi_5091_ = (1f - (0.015625f / _e447));
                            } else {
                                phi_5091_ = (0.015625f + (0.96875f * clamp(_e447, 0f, 1f)));
                            }
                            let _e456 = phi_5091_;
                            phi_5092_ = _e456;
                        }
                        let _e460 = phi_5092_;
                        let _e461 = (_e414 / _e416);
                        let _e469 = global.member[0u];
                        let _e472 = global.member[1u];
                        let _e477 = global.member_31;
                        let _e478 = (_e477 > 0u);
                        phi_3558_ = _e478;
                        if _e478 {
                            let _e480 = global.member_34;
                            let _e483 = global.member_29;
                            let _e490 = global.member_49;
                            switch bitcast<i32>(0u) {
                                default: {
                                    let _e497 = vec2(((sqrt((2f * log(max((max(255f, _e480) / _e483), 1f)))) * sqrt(_e490)) * ((((((1.2f * exp(min(max(max(_e261.x, _e261.y), _e261.z), 9f))) * sqrt(max(max(dot(_e371, _e371), dot(_e372, _e372)), dot(_e373, _e373)))) * length(vec3<f32>(_e461.x, _e461.y, 1f))) * max(_e469, _e472)) / _e369) + 0.5477226f)));
                                    let _e500 = global.member_32;
                                    let _e503 = global.member_33;
                                    let _e511 = vec2<u32>(clamp(((((_e420 - _e497) - _e500) * _e503) - vec2<f32>(0.5f, 0.5f)), vec2<f32>(0f, 0f), vec2<f32>(191f, 191f)));
                                    let _e513 = vec2<u32>(clamp(((((_e420 + _e497) - _e500) * _e503) + vec2<f32>(0.5f, 0.5f)), vec2<f32>(0f, 0f), vec2<f32>(191f, 191f)));
                                    let _e520 = max((_e513.x - _e511.x), (_e513.y - _e511.y));
                                    if (_e520 <= 3u) {
                                        phi_5096_ = 0u;
                                    } else {
                                        phi_5096_ = (bitcast<u32>(firstLeadingBit((_e520 - 1u))) - 1u);
                                    }
                                    let _e527 = phi_5096_;
                                    if !((_e527 < 4u)) {
                                        phi_5106_ = false;
                                        break;
                                    }
                                    let _e537 = vec2(_e527);
                                    let _e539 = (_e511 >> bitcast<vec2<u32>>(_e537));
                                    let _e541 = (_e513 >> bitcast<vec2<u32>>(_e537));
                                    let _e543 = (_e539.x & 4294967292u);
                                    phi_5102_ = _e543;
                                    phi_5101_ = 0f;
                                    phi_5099_ = _e539.y;
                                    loop {
                                        let _e546 = phi_5102_;
                                        let _e548 = phi_5101_;
                                        let _e550 = phi_5099_;
                                        local_1 = _e548;
                                        if (_e550 <= _e541.y) {
                                            continue;
                                        } else {
                                            break;
                                        }
                                        continuing {
                                            let _e555 = (vec4(f32(_e546)) + vec4<f32>(0f, 1f, 2f, 3f));
                                            let _e573 = global_3.member[((_e477 >> bitcast<u32>(1u)) + ((((4u * (12288u - (12288u >> bitcast<u32>((2u * _e527))))) + (_e550 * (192u >> bitcast<u32>(_e527)))) + _e546) >> bitcast<u32>(2u)))];
                                            let _e575 = unpack2x16unorm(_e573.x);
                                            let _e577 = unpack2x16unorm(_e573.y);
                                            let _e584 = select(select(vec4<f32>(_e575.x, _e575.y, _e577.x, _e577.y), vec4<f32>(0f, 0f, 0f, 0f), (_e555 < vec4(f32(_e539.x)))), vec4<f32>(0f, 0f, 0f, 0f), (_e555 > vec4(f32(_e541.x))));
                                            let _e593 = (_e546 + 4u);
                                            let _e594 = (_e593 > _e541.x);
                                            phi_5102_ = select(_e593, _e543, _e594);
                                            phi_5101_ = max(_e548, max(max(_e584.x, _e584.y), max(_e584.z, _e584.w)));
                                            phi_5099_ = (_e550 + select(0u, 1u, _e594));
                                        }
                                    }
                                    let _e599 = local_1;
                                    phi_5106_ = ((1f - _e460) > _e599);
                                    break;
                                }
                            }
                            let _e602 = phi_5106_;
                            phi_3558_ = _e602;
                        }
                        let _e604 = phi_3558_;
                        if _e604 {
                            let _e606 = global_2.member_9;
                            if (_e606 != 0u) {
                                let _e610 = atomicAdd((&global_1.member[1u]), 1u);
                            }
                            phi_5117_ = _e460;
                            phi_5108_ = _e420;
                            phi_5107_ = false;
                            break;
                        }
                        phi_5117_ = _e460;
                        phi_5108_ = _e420;
                        phi_5107_ = true;
                        break;
                    }
                }
                let _e612 = phi_5117_;
                let _e614 = phi_5108_;
                let _e616 = phi_5107_;
                if (true && !(_e616)) {
                    phi_5187_ = 4294967295u;
                    break;
                }
                let _e623 = global_7.member[((3u * _e78) + _e82)];
                let _e627 = f32((_e623.y >> bitcast<u32>(24u)));
                let _e629 = global.member_29;
                if (_e627 <= _e629) {
                    let _e632 = global_2.member_9;
                    if (_e632 != 0u) {
                        let _e636 = atomicAdd((&global_1.member[2u]), 1u);
                    }
                    phi_5187_ = 4294967295u;
                    break;
                }
                let _e650 = ((vec3<f32>(f32((_e623.x & 1023u)), f32(((_e623.x >> bitcast<u32>(10u)) & 1023u)), f32(((_e623.x >> bitcast<u32>(20u)) & 1023u))) - vec3<f32>(512f, 512f, 512f)) * vec3<f32>(0.0013888889f, 0.0013888889f, 0.0013888889f));
                let _e654 = sqrt(max((1f - dot(_e650, _e650)), 0f));
                let _e656 = (_e623.x >> bitcast<u32>(30u));
                if (_e656 == 0u) {
                    phi_5129_ = vec4<f32>(_e654, _e650.x, _e650.y, _e650.z);
                } else {
                    if (_e656 == 1u) {
                        phi_5128_ = vec4<f32>(_e650.x, _e654, _e650.y, _e650.z);
                    } else {
                        if (_e656 == 2u) {
                            phi_5127_ = vec4<f32>(_e650.x, _e650.y, _e654, _e650.z);
                        } else {
                            phi_5127_ = vec4<f32>(_e650.x, _e650.y, _e650.z, _e654);
                        }
                        let _e669 = phi_5127_;
                        phi_5128_ = _e669;
                    }
                    let _e675 = phi_5128_;
                    phi_5129_ = _e675;
                }
                let _e681 = phi_5129_;
                let _e685 = global.member_38;
                let _e686 = (_e685 > 0u);
                phi_5147_ = unpack4x8unorm(_e623.y).xyz;
                if _e686 {
                    let _e690 = global_7.member[(_e685 + _e82)];
                    let _e692 = unpack2x16float(_e690.x);
                    phi_5147_ = vec3<f32>(_e692.x, _e692.y, unpack2x16float(_e690.y).x);
                }
                let _e700 = phi_5147_;
                let _e703 = (1u << bitcast<u32>((_e82 & 31u)));
                let _e706 = global_7.member[_e86];
                let _e710 = global_7.member[(_e86 + 1u)];
                let _e714 = global_7.member[(_e86 + 2u)];
                phi_5164_ = _e681;
                if ((_e706.x & _e703) != 0u) {
                    let _e725 = global.member_22;
                    let _e727 = global.member_18;
                    let _e731 = (_e725 + ((_e710.y + bitcast<u32>(countOneBits((_e706.x & (_e703 - 1u))))) * (1u + (4u * _e727))));
                    let _e732 = (_e731 + 1u);
                    let _e735 = global_6.member[_e731];
                    let _e737 = global.member_44;
                    let _e741 = global.member_19;
                    phi_5149_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_5148_ = 0u;
                    loop {
                        let _e745 = phi_5149_;
                        let _e747 = phi_5148_;
                        let _e749 = (2u * ((_e737 + ((_e735 >> bitcast<u32>(16u)) * _e741)) + _e747));
                        let _e752 = global_3.member[_e749];
                        let _e756 = global_3.member[(_e749 + 1u)];
                        let _e762 = bitcast<vec4<f32>>(vec4<u32>(_e752.x, _e752.y, _e756.x, _e756.y));
                        let _e766 = global_6.member[(_e732 + _e747)];
                        let _e773 = global_6.member[((_e732 + _e727) + _e747)];
                        let _e781 = global_6.member[((_e732 + (2u * _e727)) + _e747)];
                        let _e789 = global_6.member[((_e732 + (3u * _e727)) + _e747)];
                        let _e793 = (_e745 + vec4<f32>(dot(unpack4x8snorm(_e766), _e762), dot(unpack4x8snorm(_e773), _e762), dot(unpack4x8snorm(_e781), _e762), dot(unpack4x8snorm(_e789), _e762)));
                        let _e795 = (_e747 + bitcast<u32>(1i));
                        phi_5149_ = _e793;
                        phi_5148_ = _e795;
                        local_2 = _e793;
                        if (_e795 < _e727) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e801 = local_2;
                    let _e803 = (_e681 + (_e801 * (127f * unpack2x16float(_e735).x)));
                    phi_5164_ = select(_e681, _e803, vec4((length(_e803) >= 0.001f)));
                }
                let _e809 = phi_5164_;
                phi_5168_ = _e261;
                if ((_e706.y & _e703) != 0u) {
                    let _e820 = global.member_23;
                    let _e822 = global.member_18;
                    let _e826 = (_e820 + ((_e714.x + bitcast<u32>(countOneBits((_e706.y & (_e703 - 1u))))) * (1u + (3u * _e822))));
                    let _e827 = (_e826 + 1u);
                    let _e830 = global_6.member[_e826];
                    let _e832 = global.member_44;
                    let _e836 = global.member_19;
                    phi_5152_ = vec3<f32>(0f, 0f, 0f);
                    phi_5151_ = 0u;
                    loop {
                        let _e840 = phi_5152_;
                        let _e842 = phi_5151_;
                        let _e844 = (2u * ((_e832 + ((_e830 >> bitcast<u32>(16u)) * _e836)) + _e842));
                        let _e847 = global_3.member[_e844];
                        let _e851 = global_3.member[(_e844 + 1u)];
                        let _e857 = bitcast<vec4<f32>>(vec4<u32>(_e847.x, _e847.y, _e851.x, _e851.y));
                        let _e861 = global_6.member[(_e827 + _e842)];
                        let _e868 = global_6.member[((_e827 + _e822) + _e842)];
                        let _e876 = global_6.member[((_e827 + (2u * _e822)) + _e842)];
                        let _e880 = (_e840 + vec3<f32>(dot(unpack4x8snorm(_e861), _e857), dot(unpack4x8snorm(_e868), _e857), dot(unpack4x8snorm(_e876), _e857)));
                        let _e882 = (_e842 + bitcast<u32>(1i));
                        phi_5152_ = _e880;
                        phi_5151_ = _e882;
                        local_3 = _e880;
                        if (_e882 < _e822) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e888 = local_3;
                    phi_5168_ = (_e261 + (_e888 * (127f * unpack2x16float(_e830).x)));
                }
                let _e892 = phi_5168_;
                phi_5170_ = _e700;
                if ((_e710.x & _e703) != 0u) {
                    let _e903 = global.member_24;
                    let _e905 = global.member_18;
                    let _e909 = (_e903 + ((_e714.y + bitcast<u32>(countOneBits((_e710.x & (_e703 - 1u))))) * (3u + (3u * _e905))));
                    let _e913 = global_6.member[(_e909 + 1u)];
                    let _e914 = unpack2x16float(_e913);
                    let _e918 = global_6.member[(_e909 + 2u)];
                    let _e926 = (_e909 + 3u);
                    let _e929 = global_6.member[_e909];
                    let _e931 = global.member_44;
                    let _e935 = global.member_19;
                    phi_5161_ = vec3<f32>(0f, 0f, 0f);
                    phi_5160_ = 0u;
                    loop {
                        let _e939 = phi_5161_;
                        let _e941 = phi_5160_;
                        let _e943 = (2u * ((_e931 + ((_e929 >> bitcast<u32>(16u)) * _e935)) + _e941));
                        let _e946 = global_3.member[_e943];
                        let _e950 = global_3.member[(_e943 + 1u)];
                        let _e956 = bitcast<vec4<f32>>(vec4<u32>(_e946.x, _e946.y, _e950.x, _e950.y));
                        let _e960 = global_6.member[(_e926 + _e941)];
                        let _e967 = global_6.member[((_e926 + _e905) + _e941)];
                        let _e975 = global_6.member[((_e926 + (2u * _e905)) + _e941)];
                        let _e979 = (_e939 + vec3<f32>(dot(unpack4x8snorm(_e960), _e956), dot(unpack4x8snorm(_e967), _e956), dot(unpack4x8snorm(_e975), _e956)));
                        let _e981 = (_e941 + bitcast<u32>(1i));
                        phi_5161_ = _e979;
                        phi_5160_ = _e981;
                        local_4 = _e979;
                        if (_e981 < _e905) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e987 = local_4;
                    phi_5170_ = (select(vec3<f32>(_e914.x, _e914.y, unpack2x16float(_e918).x), _e700, vec3(_e686)) + (_e987 * (127f * unpack2x16float(_e929).x)));
                }
                let _e991 = phi_5170_;
                let _e992 = normalize(_e809);
                let _e997 = (_e992.z * _e992.z);
                let _e998 = (_e992.w * _e992.w);
                let _e1002 = (_e992.y * _e992.z);
                let _e1003 = (_e992.x * _e992.w);
                let _e1006 = (_e992.y * _e992.w);
                let _e1007 = (_e992.x * _e992.z);
                let _e1012 = (_e992.y * _e992.y);
                let _e1016 = (_e992.z * _e992.w);
                let _e1017 = (_e992.x * _e992.y);
                let _e1031 = exp(min(_e892, vec3<f32>(9f, 9f, 9f)));
                let _e1038 = mat3x3<f32>((vec3<f32>((1f - (2f * (_e997 + _e998))), (2f * (_e1002 + _e1003)), (2f * (_e1006 - _e1007))) * _e1031.x), (vec3<f32>((2f * (_e1002 - _e1003)), (1f - (2f * (_e1012 + _e998))), (2f * (_e1016 + _e1017))) * _e1031.y), (vec3<f32>((2f * (_e1006 + _e1007)), (2f * (_e1016 - _e1017)), (1f - (2f * (_e1012 + _e997)))) * _e1031.z));
                switch bitcast<i32>(0u) {
                    default: {
                        let _e1044 = global.member_2;
                        let _e1046 = global.member_3;
                        let _e1047 = clamp((_e370.xy / vec2(_e369)), _e1044, _e1046);
                        let _e1050 = global.member[0u];
                        let _e1056 = (((vec3<f32>(_e354.x, _e354.y, _e354.z) - (_e385 * _e1047.x)) * (_e1050 / _e369)) * _e1038);
                        let _e1059 = global.member[1u];
                        let _e1065 = (((vec3<f32>(_e360.x, _e360.y, _e360.z) - (_e385 * _e1047.y)) * (_e1059 / _e369)) * _e1038);
                        let _e1067 = (dot(_e1056, _e1056) + 0.3f);
                        let _e1070 = (dot(_e1065, _e1065) + 0.3f);
                        let _e1072 = cross(_e1056, _e1065);
                        let _e1077 = (dot(_e1072, _e1072) + (0.3f * ((_e1067 + _e1070) - 0.3f)));
                        let _e1078 = (_e1077 > 0f);
                        phi_4588_ = _e1078;
                        if _e1078 {
                            phi_4588_ = (_e1067 <= 1000000000000000000f);
                        }
                        let _e1081 = phi_4588_;
                        phi_4594_ = _e1081;
                        if _e1081 {
                            phi_4594_ = (_e1070 <= 1000000000000000000f);
                        }
                        let _e1084 = phi_4594_;
                        if !(_e1084) {
                            let _e1087 = global_2.member_9;
                            if (_e1087 != 0u) {
                                let _e1091 = atomicAdd((&global_1.member[3u]), 1u);
                            }
                            phi_5186_ = 4294967295u;
                            break;
                        }
                        let _e1093 = global.member_49;
                        let _e1094 = (vec3<f32>(_e1067, dot(_e1056, _e1065), _e1070) * _e1093);
                        phi_5178_ = (1f - (_e627 * 0.003921569f));
                        phi_5177_ = 0u;
                        loop {
                            let _e1100 = phi_5178_;
                            let _e1102 = phi_5177_;
                            local_5 = _e1100;
                            if (_e1102 < _e80) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                phi_5178_ = (_e1100 * _e1100);
                                phi_5177_ = (_e1102 + bitcast<u32>(1i));
                            }
                        }
                        let _e1108 = local_5;
                        let _e1112 = u32(round((255f * (1f - _e1108))));
                        let _e1115 = global.member_34;
                        let _e1126 = global.member_51;
                        let _e1127 = ((sqrt(_e1094.xz) * sqrt((2f * log(max((max(f32(_e1112), _e1115) / _e629), 1f))))) * _e1126);
                        let _e1130 = global.member_52;
                        let _e1133 = all(((_e614 + _e1127) > _e1130.xy));
                        phi_4640_ = _e1133;
                        if _e1133 {
                            phi_4640_ = all(((_e614 - _e1127) < _e1130.zw));
                        }
                        let _e1139 = phi_4640_;
                        if !(_e1139) {
                            let _e1142 = global_2.member_9;
                            if (_e1142 != 0u) {
                                let _e1146 = atomicAdd((&global_1.member[0u]), 1u);
                            }
                            phi_5186_ = 4294967295u;
                            break;
                        }
                        let _e1151 = (0.5f * (_e1094.x - _e1094.z));
                        let _e1156 = sqrt(((_e1151 * _e1151) + (_e1094.y * _e1094.y)));
                        let _e1159 = ((0.5f * (_e1094.x + _e1094.z)) + _e1156);
                        if (_e1151 >= 0f) {
                            phi_5184_ = vec2<f32>((_e1151 + _e1156), _e1094.y);
                        } else {
                            phi_5184_ = vec2<f32>(_e1094.y, (_e1156 - _e1151));
                        }
                        let _e1166 = phi_5184_;
                        let _e1167 = length(_e1166);
                        if (_e1167 > 0f) {
                            phi_5185_ = (_e1166 / vec2(_e1167));
                        } else {
                            phi_5185_ = vec2<f32>(1f, 0f);
                        }
                        let _e1172 = phi_5185_;
                        let _e1179 = global.member_5;
                        let _e1183 = global.member_10;
                        let _e1187 = vec2<u32>(clamp(round(((_e614 + vec2(_e1179)) * _e1183)), vec2<f32>(0f, 0f), vec2<f32>(1048575f, 1048575f)));
                        let _e1190 = vec3<u32>(round((clamp(_e991, vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 1023f)));
                        let _e1218 = global.member_45;
                        let _e1220 = (4u * (_e1218 + _e72));
                        global_4.member[_e1220] = ((_e1187.x | (_e1190.x << bitcast<u32>(20u))) | (_e1190.z << bitcast<u32>(30u)));
                        global_4.member[(_e1220 + 1u)] = (_e1187.y | (_e1190.y << bitcast<u32>(20u)));
                        global_4.member[(_e1220 + 2u)] = pack2x16float((_e1172 * min(sqrt(_e1159), 65504f)));
                        global_4.member[(_e1220 + 3u)] = ((pack2x16float(vec2<f32>(min(sqrt(((_e1077 * (_e1093 * _e1093)) / _e1159)), 65504f), 0f)) | (_e1112 << bitcast<u32>(16u))) | ((_e1190.z >> bitcast<u32>(2u)) << bitcast<u32>(24u)));
                        let _e1233 = global.member_9;
                        phi_5186_ = min(u32((_e612 * f32(_e1233))), _e1233);
                        break;
                    }
                }
                let _e1239 = phi_5186_;
                phi_5187_ = _e1239;
                break;
            }
        }
        let _e1241 = phi_5187_;
        phi_5188_ = _e1241;
    } else {
        phi_5188_ = 4294967295u;
    }
    let _e1243 = phi_5188_;
    switch bitcast<i32>(0u) {
        default: {
            let _e1246 = bitcast<u32>(param[0u]);
            let _e1248 = global.member_45;
            let _e1249 = (_e1248 + _e72);
            if (_e1243 != 4294967295u) {
                let _e1252 = global.member_41;
                let _e1256 = global.member_40;
                let _e1262 = atomicAdd((&global_1.member[((_e1256 + ((_e1249 / _e1252) * 256u)) + (_e1243 & 255u))]), 1u);
            }
            let _e1264 = global.member_39;
            if (_e1264 == 0u) {
                if (_e72 < (_e74 + (_e74 & 1u))) {
                    let _e1270 = global.member_28;
                    global_4.member[(_e1270 + _e1249)] = _e1243;
                }
                break;
            }
            global_5[_e1246] = _e1243;
            workgroupBarrier();
            let _e1276 = ((_e1246 & 1u) == 0u);
            if select(_e1276, _e75, _e1276) {
                let _e1279 = global.member_28;
                let _e1286 = global_5[(_e1246 + 1u)];
                global_4.member[(_e1279 + (_e1249 >> bitcast<u32>(1u)))] = ((_e1243 & 65535u) | (_e1286 << bitcast<u32>(16u)));
            }
            break;
        }
    }
    return;
}
