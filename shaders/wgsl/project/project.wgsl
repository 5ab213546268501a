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
    member_56: array<type_12, 8>,
    member_57: array<vec4<f32>, 128>,
    member_58: array<vec4<f32>, 768>,
}

struct type_19 {
    member: array<vec2<u32>>,
}

struct type_21 {
    member: array<u32>,
}

struct type_22 {
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

struct type_26 {
    member: array<atomic<u32>>,
}

struct type_28 {
    member: array<vec2<u32>, LENGTH_3_8>,
}

struct type_30 {
    member: array<atomic<u32>, LENGTH_6_4>,
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
@group(0) @binding(3) 
var<storage> global_1: type_28;
@group(0) @binding(6) 
var<storage, read_write> global_2: type_30;
@group(0) @binding(7) 
var<uniform> global_3: type_22;
@group(0) @binding(4) 
var<storage, read_write> global_4: type_32;
var<workgroup> global_5: array<u32, 64>;
@group(0) @binding(2) 
var<storage> global_6: type_34;
@group(0) @binding(1) 
var<storage> global_7: type_36;

@compute @workgroup_size(64, 1, 1) 
fn main(@builtin(local_invocation_id) param: vec3<u32>, @builtin(global_invocation_id) param_1: vec3<u32>) {
    var phi_5032_: u32;
    var phi_5031_: bool;
    var phi_3074_: bool;
    var local: bool;
    var phi_5034_: f32;
    var phi_5035_: f32;
    var phi_5041_: f32;
    var phi_5037_: vec2<f32>;
    var phi_5036_: bool;
    var phi_5047_: bool;
    var phi_5048_: bool;
    var phi_5049_: vec4<f32>;
    var phi_5050_: vec4<f32>;
    var phi_5051_: vec4<f32>;
    var phi_5061_: vec3<f32>;
    var phi_5063_: vec4<f32>;
    var phi_5062_: u32;
    var local_1: vec4<f32>;
    var phi_5078_: vec4<f32>;
    var phi_5066_: vec3<f32>;
    var phi_5065_: u32;
    var local_2: vec3<f32>;
    var phi_5082_: vec3<f32>;
    var phi_5075_: vec3<f32>;
    var phi_5074_: u32;
    var local_3: vec3<f32>;
    var phi_5084_: vec3<f32>;
    var phi_4481_: bool;
    var phi_4487_: bool;
    var phi_5089_: f32;
    var phi_5088_: u32;
    var local_4: f32;
    var phi_4560_: bool;
    var phi_5098_: vec2<f32>;
    var phi_5099_: vec2<f32>;
    var phi_5102_: u32;
    var phi_5103_: u32;
    var phi_5104_: u32;

    let _e71 = bitcast<u32>(param_1[0u]);
    let _e73 = global.member_44;
    let _e74 = (_e71 < _e73);
    if _e74 {
        switch bitcast<i32>(0u) {
            default: {
                let _e77 = global.member_14;
                let _e79 = global.member_43;
                let _e81 = (_e71 << bitcast<u32>(_e79));
                let _e85 = (4u * (_e77 + (_e81 >> bitcast<u32>(5u))));
                let _e90 = global_7.member[(_e85 + 3u)][0u];
                phi_5032_ = (_e90 & 65535u);
                phi_5031_ = true;
                loop {
                    let _e93 = phi_5032_;
                    let _e95 = phi_5031_;
                    local = _e95;
                    phi_3074_ = _e95;
                    if _e95 {
                        phi_3074_ = (_e93 <= (_e90 >> bitcast<u32>(16u)));
                    }
                    let _e100 = phi_3074_;
                    if _e100 {
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e109 = global.member_55[(_e93 >> bitcast<u32>(7u))][((_e93 >> bitcast<u32>(5u)) & 3u)];
                        phi_5032_ = (_e93 + bitcast<u32>(1i));
                        phi_5031_ = (((_e109 >> bitcast<u32>((_e93 & 31u))) & 1u) != 0u);
                    }
                }
                let _e118 = local;
                if _e118 {
                    let _e120 = global_3.member_8;
                    if (_e120 != 0u) {
                        let _e124 = atomicAdd((&global_2.member[0u]), 1u);
                    }
                    phi_5103_ = 4294967295u;
                    break;
                }
                let _e125 = (2u * _e81);
                let _e128 = global_7.member[_e125];
                let _e132 = global_7.member[(_e125 + 1u)];
                let _e137 = global_7.member[((2u * _e77) + _e81)];
                let _e139 = global.member_15;
                let _e143 = bitcast<u32>(firstLeadingBit((max(_e139, 4096u) - 1u)));
                let _e144 = (_e143 + 1u);
                let _e145 = (15u - _e143);
                let _e159 = (vec2<u32>((32u << bitcast<u32>((2u * _e145))), (32u << bitcast<u32>(_e145))) - vec2<u32>(1u, 1u));
                let _e175 = (vec2<f32>(vec2<u32>(((((_e137.x >> bitcast<u32>(16u)) >> bitcast<u32>(((2u * _e144) - 16u))) << bitcast<u32>(5u)) | ((_e137.y >> bitcast<u32>(_e144)) & 31u)), ((_e137.y >> bitcast<u32>((_e143 + 6u))) & _e159.y))) / vec2<f32>(_e159));
                let _e179 = ((1f + (2f * _e175.x)) * 0.33333334f);
                let _e180 = (1f - _e179);
                let _e184 = (_e180 * (0.5f + (0.5f * _e175.y)));
                let _e193 = (vec3<u32>(_e137.x, (_e137.x >> bitcast<u32>(_e144)), _e137.y) & vec3(((1u << bitcast<u32>(_e144)) - 1u)));
                let _e205 = global.member_11;
                let _e208 = global.member_12;
                let _e214 = global.member_21;
                let _e215 = (2u * _e214);
                let _e219 = global_1.member[(_e215 + _e193.x)];
                let _e221 = unpack2x16float(_e219.x);
                let _e234 = global_1.member[(_e215 + _e193.y)];
                let _e236 = unpack2x16float(_e234.x);
                let _e249 = global_1.member[(_e215 + _e193.z)];
                let _e251 = unpack2x16float(_e249.x);
                let _e259 = ((((_e205.xyz + (_e208.xyz * vec3<f32>(f32((_e128.x & 65535u)), f32((_e128.x >> bitcast<u32>(16u))), f32((_e128.y & 65535u))))) + (vec3<f32>(_e221.x, _e221.y, unpack2x16float(_e219.y).x) * _e179)) + (vec3<f32>(_e236.x, _e236.y, unpack2x16float(_e234.y).x) * _e184)) + (vec3<f32>(_e251.x, _e251.y, unpack2x16float(_e249.y).x) * (_e180 - _e184)));
                let _e263 = vec4<f32>(_e259.x, _e259.y, _e259.z, 1f);
                let _e276 = (((_e128.y >> bitcast<u32>(16u)) | ((_e132.y >> bitcast<u32>(24u)) << bitcast<u32>(16u))) | ((_e137.y >> bitcast<u32>(26u)) << bitcast<u32>(24u)));
                let _e288 = global.member_32;
                let _e290 = global.member_33;
                let _e293 = (vec3(_e288) + (vec3<f32>(f32((_e276 & 1023u)), f32(((_e276 >> bitcast<u32>(10u)) & 1023u)), f32((_e276 >> bitcast<u32>(20u)))) * _e290));
                let _e302 = (vec4<u32>(_e132.x, (_e132.x >> bitcast<u32>(8u)), (_e132.x >> bitcast<u32>(16u)), (_e132.x >> bitcast<u32>(24u))) & vec4<u32>(255u, 255u, 255u, 255u));
                let _e308 = (vec3<u32>(_e132.y, (_e132.y >> bitcast<u32>(8u)), (_e132.y >> bitcast<u32>(16u))) & vec3<u32>(255u, 255u, 255u));
                let _e309 = vec3<f32>(_e308);
                let _e321 = (vec4<f32>(_e309.x, _e309.y, _e309.z, f32((((255u - _e308.x) - _e308.y) - _e308.z))) * vec4<f32>(0.003921569f, 0.003921569f, 0.003921569f, 0.003921569f));
                let _e324 = (3u * _e302.x);
                let _e327 = global.member_58[_e324];
                let _e332 = global.member_58[(_e324 + 1u)];
                let _e337 = global.member_58[(_e324 + 2u)];
                let _e341 = (3u * _e302.y);
                let _e344 = global.member_58[_e341];
                let _e350 = global.member_58[(_e341 + 1u)];
                let _e356 = global.member_58[(_e341 + 2u)];
                let _e361 = (3u * _e302.z);
                let _e364 = global.member_58[_e361];
                let _e370 = global.member_58[(_e361 + 1u)];
                let _e376 = global.member_58[(_e361 + 2u)];
                let _e381 = (3u * _e302.w);
                let _e384 = global.member_58[_e381];
                let _e386 = ((((_e327 * _e321.x) + (_e344 * _e321.y)) + (_e364 * _e321.z)) + (_e384 * _e321.w));
                let _e390 = global.member_58[(_e381 + 1u)];
                let _e392 = ((((_e332 * _e321.x) + (_e350 * _e321.y)) + (_e370 * _e321.z)) + (_e390 * _e321.w));
                let _e396 = global.member_58[(_e381 + 2u)];
                let _e398 = ((((_e337 * _e321.x) + (_e356 * _e321.y)) + (_e376 * _e321.z)) + (_e396 * _e321.w));
                let _e401 = dot(_e398, _e263);
                let _e402 = vec3<f32>(dot(_e386, _e263), dot(_e392, _e263), _e401);
                let _e412 = vec3<f32>(_e386.x, _e386.y, _e386.z);
                let _e413 = vec3<f32>(_e392.x, _e392.y, _e392.z);
                let _e414 = vec3<f32>(_e398.x, _e398.y, _e398.z);
                switch bitcast<i32>(0u) {
                    default: {
                        let _e417 = global.member_6;
                        if !((_e401 >= _e417)) {
                            let _e421 = global_3.member_8;
                            if (_e421 != 0u) {
                                let _e425 = atomicAdd((&global_2.member[0u]), 1u);
                            }
                            phi_5041_ = 0f;
                            phi_5037_ = vec2<f32>(0f, 0f);
                            phi_5036_ = false;
                            break;
                        }
                        let _e427 = global.member;
                        let _e433 = global.member_1;
                        let _e436 = global.member_7;
                        let _e439 = global.member_8;
                        let _e440 = ((_e436 - _e401) * _e439);
                        if (_e440 < 0f) {
                            phi_5035_ = (0.015625f / (1f - _e440));
                        } else {
                            if (_e440 > 1f) {
                                phi_5034_ = (1f - (0.015625f / _e440));
                            } else {
                                phi_5034_ = (0.015625f + (0.96875f * clamp(_e440, 0f, 1f)));
                            }
                            let _e449 = phi_5034_;
                            phi_5035_ = _e449;
                        }
                        let _e453 = phi_5035_;
                        phi_5041_ = _e453;
                        phi_5037_ = (((_e427 * _e402.xy) / vec2(_e401)) + _e433);
                        phi_5036_ = true;
                        break;
                    }
                }
                let _e455 = phi_5041_;
                let _e457 = phi_5037_;
                let _e459 = phi_5036_;
                let _e463 = global_7.member[_e85][1u];
                let _e464 = (_e81 & 31u);
                phi_5048_ = _e459;
                if (_e459 && !((((_e463 >> bitcast<u32>(_e464)) & 1u) != 0u))) {
                    switch bitcast<i32>(0u) {
                        default: {
                            let _e480 = global.member_50;
                            let _e485 = max((_e480.xy - _e457), (_e457 - _e480.zw));
                            if !((max(_e485.x, _e485.y) > 0f)) {
                                phi_5047_ = false;
                                break;
                            }
                            let _e499 = global.member_2;
                            let _e502 = global.member_3;
                            let _e506 = global.member;
                            let _e514 = global.member_47;
                            let _e519 = global.member_29;
                            let _e526 = global.member_45;
                            let _e531 = global.member_49;
                            let _e536 = any((_e485 > ((((((abs(_e506) / vec2(_e401)) * (vec2<f32>(1f, 1f) + max(abs(_e499), abs(_e502)))) * (sqrt(max(max(dot(_e412, _e412), dot(_e413, _e413)), dot(_e414, _e414))) * exp(min(max(max(_e293.x, _e293.y), _e293.z), 9f)))) + vec2(sqrt(_e514))) * (sqrt((2f * log(max((255f / _e519), 1f)))) * sqrt(_e526))) * (1.01f * max(_e531, 0f)))));
                            if _e536 {
                                let _e538 = global_3.member_8;
                                if (_e538 != 0u) {
                                    let _e542 = atomicAdd((&global_2.member[0u]), 1u);
                                }
                            }
                            phi_5047_ = _e536;
                            break;
                        }
                    }
                    let _e544 = phi_5047_;
                    phi_5048_ = !(_e544);
                }
                let _e547 = phi_5048_;
                if (true && !(_e547)) {
                    phi_5103_ = 4294967295u;
                    break;
                }
                let _e554 = global_7.member[((3u * _e77) + _e81)];
                let _e558 = f32((_e554.y >> bitcast<u32>(24u)));
                let _e560 = global.member_29;
                if (_e558 <= _e560) {
                    let _e563 = global_3.member_8;
                    if (_e563 != 0u) {
                        let _e567 = atomicAdd((&global_2.member[1u]), 1u);
                    }
                    phi_5103_ = 4294967295u;
                    break;
                }
                let _e581 = ((vec3<f32>(f32((_e554.x & 1023u)), f32(((_e554.x >> bitcast<u32>(10u)) & 1023u)), f32(((_e554.x >> bitcast<u32>(20u)) & 1023u))) - vec3<f32>(512f, 512f, 512f)) * vec3<f32>(0.0013888889f, 0.0013888889f, 0.0013888889f));
                let _e585 = sqrt(max((1f - dot(_e581, _e581)), 0f));
                let _e587 = (_e554.x >> bitcast<u32>(30u));
                if (_e587 == 0u) {
                    phi_5051_ = vec4<f32>(_e585, _e581.x, _e581.y, _e581.z);
                } else {
                    if (_e587 == 1u) {
                        phi_5050_ = vec4<f32>(_e581.x, _e585, _e581.y, _e581.z);
                    } else {
                        if (_e587 == 2u) {
                            phi_5049_ = vec4<f32>(_e581.x, _e581.y, _e585, _e581.z);
                        } else {
                            phi_5049_ = vec4<f32>(_e581.x, _e581.y, _e581.z, _e585);
                        }
                        let _e600 = phi_5049_;
                        phi_5050_ = _e600;
                    }
                    let _e606 = phi_5050_;
                    phi_5051_ = _e606;
                }
                let _e612 = phi_5051_;
                let _e616 = global.member_34;
                phi_5061_ = unpack4x8unorm(_e554.y).xyz;
                if (_e616 > _e81) {
                    let _e621 = global_7.member[(_e616 + _e81)];
                    let _e623 = unpack2x16float(_e621.x);
                    phi_5061_ = vec3<f32>(_e623.x, _e623.y, unpack2x16float(_e621.y).x);
                }
                let _e631 = phi_5061_;
                let _e633 = (1u << bitcast<u32>(_e464));
                let _e636 = global_7.member[_e85];
                let _e640 = global_7.member[(_e85 + 1u)];
                let _e644 = global_7.member[(_e85 + 2u)];
                phi_5078_ = _e612;
                if ((_e636.x & _e633) != 0u) {
                    let _e655 = global.member_22;
                    let _e657 = global.member_18;
                    let _e661 = (_e655 + ((_e640.y + bitcast<u32>(countOneBits((_e636.x & (_e633 - 1u))))) * (1u + (4u * _e657))));
                    let _e662 = (_e661 + 1u);
                    let _e665 = global_6.member[_e661];
                    let _e667 = global.member_40;
                    let _e671 = global.member_19;
                    let _e675 = min(_e657, (_e665 | _e657));
                    phi_5063_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_5062_ = 0u;
                    loop {
                        let _e677 = phi_5063_;
                        let _e679 = phi_5062_;
                        let _e681 = (2u * ((_e667 + ((_e665 >> bitcast<u32>(16u)) * _e671)) + _e679));
                        let _e684 = global_1.member[_e681];
                        let _e688 = global_1.member[(_e681 + 1u)];
                        let _e694 = bitcast<vec4<f32>>(vec4<u32>(_e684.x, _e684.y, _e688.x, _e688.y));
                        let _e698 = global_6.member[(_e662 + _e679)];
                        let _e705 = global_6.member[((_e662 + _e675) + _e679)];
                        let _e713 = global_6.member[((_e662 + (2u * _e675)) + _e679)];
                        let _e721 = global_6.member[((_e662 + (3u * _e675)) + _e679)];
                        let _e725 = (_e677 + vec4<f32>(dot(unpack4x8snorm(_e698), _e694), dot(unpack4x8snorm(_e705), _e694), dot(unpack4x8snorm(_e713), _e694), dot(unpack4x8snorm(_e721), _e694)));
                        let _e727 = (_e679 + bitcast<u32>(1i));
                        phi_5063_ = _e725;
                        phi_5062_ = _e727;
                        local_1 = _e725;
                        if (_e727 < _e675) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e733 = local_1;
                    let _e735 = (_e612 + (_e733 * (127f * unpack2x16float(_e665).x)));
                    phi_5078_ = select(_e612, _e735, vec4((length(_e735) >= 0.001f)));
                }
                let _e741 = phi_5078_;
                phi_5082_ = _e293;
                if ((_e636.y & _e633) != 0u) {
                    let _e752 = global.member_23;
                    let _e754 = global.member_18;
                    let _e758 = (_e752 + ((_e644.x + bitcast<u32>(countOneBits((_e636.y & (_e633 - 1u))))) * (1u + (3u * _e754))));
                    let _e759 = (_e758 + 1u);
                    let _e762 = global_6.member[_e758];
                    let _e764 = global.member_40;
                    let _e768 = global.member_19;
                    let _e772 = min(_e754, (_e762 | _e754));
                    phi_5066_ = vec3<f32>(0f, 0f, 0f);
                    phi_5065_ = 0u;
                    loop {
                        let _e774 = phi_5066_;
                        let _e776 = phi_5065_;
                        let _e778 = (2u * ((_e764 + ((_e762 >> bitcast<u32>(16u)) * _e768)) + _e776));
                        let _e781 = global_1.member[_e778];
                        let _e785 = global_1.member[(_e778 + 1u)];
                        let _e791 = bitcast<vec4<f32>>(vec4<u32>(_e781.x, _e781.y, _e785.x, _e785.y));
                        let _e795 = global_6.member[(_e759 + _e776)];
                        let _e802 = global_6.member[((_e759 + _e772) + _e776)];
                        let _e810 = global_6.member[((_e759 + (2u * _e772)) + _e776)];
                        let _e814 = (_e774 + vec3<f32>(dot(unpack4x8snorm(_e795), _e791), dot(unpack4x8snorm(_e802), _e791), dot(unpack4x8snorm(_e810), _e791)));
                        let _e816 = (_e776 + bitcast<u32>(1i));
                        phi_5066_ = _e814;
                        phi_5065_ = _e816;
                        local_2 = _e814;
                        if (_e816 < _e772) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e822 = local_2;
                    phi_5082_ = (_e293 + (_e822 * (127f * unpack2x16float(_e762).x)));
                }
                let _e826 = phi_5082_;
                phi_5084_ = _e631;
                if ((_e640.x & _e633) != 0u) {
                    let _e837 = global.member_24;
                    let _e839 = global.member_18;
                    let _e843 = (_e837 + ((_e644.y + bitcast<u32>(countOneBits((_e640.x & (_e633 - 1u))))) * (3u + (3u * _e839))));
                    let _e847 = global_6.member[(_e843 + 1u)];
                    let _e848 = unpack2x16float(_e847);
                    let _e852 = global_6.member[(_e843 + 2u)];
                    let _e861 = (_e843 + 3u);
                    let _e864 = global_6.member[_e843];
                    let _e866 = global.member_40;
                    let _e870 = global.member_19;
                    let _e874 = min(_e839, (_e864 | _e839));
                    phi_5075_ = vec3<f32>(0f, 0f, 0f);
                    phi_5074_ = 0u;
                    loop {
                        let _e876 = phi_5075_;
                        let _e878 = phi_5074_;
                        let _e880 = (2u * ((_e866 + ((_e864 >> bitcast<u32>(16u)) * _e870)) + _e878));
                        let _e883 = global_1.member[_e880];
                        let _e887 = global_1.member[(_e880 + 1u)];
                        let _e893 = bitcast<vec4<f32>>(vec4<u32>(_e883.x, _e883.y, _e887.x, _e887.y));
                        let _e897 = global_6.member[(_e861 + _e878)];
                        let _e904 = global_6.member[((_e861 + _e874) + _e878)];
                        let _e912 = global_6.member[((_e861 + (2u * _e874)) + _e878)];
                        let _e916 = (_e876 + vec3<f32>(dot(unpack4x8snorm(_e897), _e893), dot(unpack4x8snorm(_e904), _e893), dot(unpack4x8snorm(_e912), _e893)));
                        let _e918 = (_e878 + bitcast<u32>(1i));
                        phi_5075_ = _e916;
                        phi_5074_ = _e918;
                        local_3 = _e916;
                        if (_e918 < _e874) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e924 = local_3;
                    phi_5084_ = (select(vec3<f32>(_e848.x, _e848.y, unpack2x16float(_e852).x), _e631, vec3((_e616 > 0u))) + (_e924 * (127f * unpack2x16float(_e864).x)));
                }
                let _e928 = phi_5084_;
                let _e929 = normalize(_e741);
                let _e934 = (_e929.z * _e929.z);
                let _e935 = (_e929.w * _e929.w);
                let _e939 = (_e929.y * _e929.z);
                let _e940 = (_e929.x * _e929.w);
                let _e943 = (_e929.y * _e929.w);
                let _e944 = (_e929.x * _e929.z);
                let _e949 = (_e929.y * _e929.y);
                let _e953 = (_e929.z * _e929.w);
                let _e954 = (_e929.x * _e929.y);
                let _e968 = exp(min(_e826, vec3<f32>(9f, 9f, 9f)));
                let _e975 = mat3x3<f32>((vec3<f32>((1f - (2f * (_e934 + _e935))), (2f * (_e939 + _e940)), (2f * (_e943 - _e944))) * _e968.x), (vec3<f32>((2f * (_e939 - _e940)), (1f - (2f * (_e949 + _e935))), (2f * (_e953 + _e954))) * _e968.y), (vec3<f32>((2f * (_e943 + _e944)), (2f * (_e953 - _e954)), (1f - (2f * (_e949 + _e934)))) * _e968.z));
                switch bitcast<i32>(0u) {
                    default: {
                        let _e981 = global.member_2;
                        let _e983 = global.member_3;
                        let _e984 = clamp((_e402.xy / vec2(_e401)), _e981, _e983);
                        let _e987 = global.member[0u];
                        let _e993 = (((_e412 - (_e414 * _e984.x)) * (_e987 / _e401)) * _e975);
                        let _e996 = global.member[1u];
                        let _e1002 = (((_e413 - (_e414 * _e984.y)) * (_e996 / _e401)) * _e975);
                        let _e1004 = global.member_47;
                        let _e1006 = (dot(_e993, _e993) + _e1004);
                        let _e1009 = (dot(_e1002, _e1002) + _e1004);
                        let _e1011 = cross(_e993, _e1002);
                        let _e1012 = dot(_e1011, _e1011);
                        let _e1016 = (_e1012 + (_e1004 * ((_e1006 + _e1009) - _e1004)));
                        let _e1017 = (_e1016 > 0f);
                        phi_4481_ = _e1017;
                        if _e1017 {
                            phi_4481_ = (_e1006 <= 1000000000000000000f);
                        }
                        let _e1020 = phi_4481_;
                        phi_4487_ = _e1020;
                        if _e1020 {
                            phi_4487_ = (_e1009 <= 1000000000000000000f);
                        }
                        let _e1023 = phi_4487_;
                        if !(_e1023) {
                            let _e1026 = global_3.member_8;
                            if (_e1026 != 0u) {
                                let _e1030 = atomicAdd((&global_2.member[2u]), 1u);
                            }
                            phi_5102_ = 4294967295u;
                            break;
                        }
                        phi_5089_ = (1f - (_e558 * 0.003921569f));
                        phi_5088_ = 0u;
                        loop {
                            let _e1034 = phi_5089_;
                            let _e1036 = phi_5088_;
                            local_4 = _e1034;
                            if (_e1036 < 3u) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                phi_5089_ = select(_e1034, (_e1034 * _e1034), (_e1036 < _e79));
                                phi_5088_ = (_e1036 + bitcast<u32>(1i));
                            }
                        }
                        let _e1044 = local_4;
                        let _e1052 = global.member_48;
                        let _e1059 = u32(round((f32(u32(round((255f * (1f - _e1044))))) * ((1f - _e1052) + (_e1052 * sqrt((_e1012 / _e1016)))))));
                        let _e1060 = f32(_e1059);
                        if (_e1060 <= _e560) {
                            let _e1063 = global_3.member_8;
                            if (_e1063 != 0u) {
                                let _e1067 = atomicAdd((&global_2.member[1u]), 1u);
                            }
                            phi_5102_ = 4294967295u;
                            break;
                        }
                        let _e1069 = global.member_45;
                        let _e1070 = (vec3<f32>(_e1006, dot(_e993, _e1002), _e1009) * _e1069);
                        let _e1082 = global.member_49;
                        let _e1083 = ((sqrt(_e1070.xz) * sqrt((2f * log(max((_e1060 / _e560), 1f))))) * _e1082);
                        let _e1086 = global.member_50;
                        let _e1089 = all(((_e457 + _e1083) > _e1086.xy));
                        phi_4560_ = _e1089;
                        if _e1089 {
                            phi_4560_ = all(((_e457 - _e1083) < _e1086.zw));
                        }
                        let _e1095 = phi_4560_;
                        if !(_e1095) {
                            let _e1098 = global_3.member_8;
                            if (_e1098 != 0u) {
                                let _e1102 = atomicAdd((&global_2.member[0u]), 1u);
                            }
                            phi_5102_ = 4294967295u;
                            break;
                        }
                        let _e1107 = (0.5f * (_e1070.x - _e1070.z));
                        let _e1112 = sqrt(((_e1107 * _e1107) + (_e1070.y * _e1070.y)));
                        let _e1115 = ((0.5f * (_e1070.x + _e1070.z)) + _e1112);
                        if (_e1107 >= 0f) {
                            phi_5098_ = vec2<f32>((_e1107 + _e1112), _e1070.y);
                        } else {
                            phi_5098_ = vec2<f32>(_e1070.y, (_e1112 - _e1107));
                        }
                        let _e1122 = phi_5098_;
                        if (_e1112 > (0.00000001f * _e1115)) {
                            phi_5099_ = normalize(_e1122);
                        } else {
                            phi_5099_ = vec2<f32>(1f, 0f);
                        }
                        let _e1127 = phi_5099_;
                        let _e1135 = max(-(_e457), (_e457 * 0.5f));
                        let _e1140 = global.member_5;
                        let _e1141 = (max(_e1135.x, _e1135.y) / _e1140);
                        let _e1149 = ((select(0u, 1u, (_e1141 > 1f)) + select(0u, 1u, (_e1141 > 64f))) + select(0u, 1u, (_e1141 > 4096f)));
                        let _e1158 = global.member_10;
                        let _e1162 = vec2<u32>(clamp(round((((_e457 * exp2(-(f32((_e1149 * 6u))))) + vec2(_e1140)) * _e1158)), vec2<f32>(0f, 0f), vec2<f32>(1048575f, 1048575f)));
                        let _e1165 = vec3<u32>(round((clamp(_e928, vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 1023f)));
                        let _e1196 = global.member_41;
                        let _e1198 = (4u * (_e1196 + _e71));
                        global_4.member[_e1198] = ((_e1162.x | (_e1165.x << bitcast<u32>(20u))) | (_e1165.z << bitcast<u32>(30u)));
                        global_4.member[(_e1198 + 1u)] = ((_e1162.y | (_e1165.y << bitcast<u32>(20u))) | (_e1149 << bitcast<u32>(30u)));
                        global_4.member[(_e1198 + 2u)] = pack2x16float((_e1127 * min(sqrt(_e1115), 65504f)));
                        global_4.member[(_e1198 + 3u)] = ((pack2x16float(vec2<f32>(min(sqrt(((_e1016 * (_e1069 * _e1069)) / _e1115)), 65504f), 0f)) | (_e1059 << bitcast<u32>(16u))) | ((_e1165.z >> bitcast<u32>(2u)) << bitcast<u32>(24u)));
                        let _e1211 = global.member_9;
                        phi_5102_ = min(u32((_e455 * f32(_e1211))), _e1211);
                        break;
                    }
                }
                let _e1217 = phi_5102_;
                phi_5103_ = _e1217;
                break;
            }
        }
        let _e1219 = phi_5103_;
        phi_5104_ = _e1219;
    } else {
        phi_5104_ = 4294967295u;
    }
    let _e1221 = phi_5104_;
    let _e1223 = bitcast<u32>(param[0u]);
    let _e1225 = global.member_41;
    let _e1226 = (_e1225 + _e71);
    if (_e1221 != 4294967295u) {
        let _e1229 = global.member_37;
        let _e1233 = global.member_36;
        let _e1239 = atomicAdd((&global_2.member[((_e1233 + ((_e1226 / _e1229) * 256u)) + (_e1221 & 255u))]), 1u);
    }
    global_5[_e1223] = _e1221;
    workgroupBarrier();
    let _e1242 = ((_e1223 & 1u) == 0u);
    if select(_e1242, _e74, _e1242) {
        let _e1245 = global.member_28;
        let _e1252 = global_5[(_e1223 + 1u)];
        global_4.member[(_e1245 + (_e1226 >> bitcast<u32>(1u)))] = ((_e1221 & 65535u) | (_e1252 << bitcast<u32>(16u)));
    }
    return;
}
