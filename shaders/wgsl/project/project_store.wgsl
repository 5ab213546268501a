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
    var phi_5387_: f32;
    var phi_5388_: f32;
    var phi_5394_: f32;
    var phi_5390_: vec2<f32>;
    var phi_5389_: bool;
    var phi_5400_: bool;
    var phi_5401_: bool;
    var phi_5402_: vec4<f32>;
    var phi_5403_: vec4<f32>;
    var phi_5404_: vec4<f32>;
    var phi_5414_: vec3<f32>;
    var phi_5416_: vec4<f32>;
    var phi_5415_: u32;
    var local: vec4<f32>;
    var phi_5431_: vec4<f32>;
    var phi_5419_: vec3<f32>;
    var phi_5418_: u32;
    var local_1: vec3<f32>;
    var phi_5435_: vec3<f32>;
    var phi_5428_: vec3<f32>;
    var phi_5427_: u32;
    var local_2: vec3<f32>;
    var phi_5437_: vec3<f32>;
    var phi_5438_: vec3<f32>;
    var phi_5440_: vec3<f32>;
    var phi_5442_: vec3<f32>;
    var phi_3098_: bool;
    var phi_3112_: bool;
    var phi_4809_: bool;
    var phi_4815_: bool;
    var phi_5473_: f32;
    var phi_5472_: u32;
    var local_3: f32;
    var phi_4888_: bool;
    var phi_5482_: vec2<f32>;
    var phi_5483_: vec2<f32>;
    var phi_5486_: u32;
    var phi_5487_: u32;
    var phi_5488_: u32;

    let _e83 = bitcast<u32>(param_1[0u]);
    let _e85 = global.member_44;
    let _e86 = (_e83 < _e85);
    if _e86 {
        switch bitcast<i32>(0u) {
            default: {
                let _e89 = global.member_14;
                let _e91 = global.member_43;
                let _e93 = (_e83 << bitcast<u32>(_e91));
                let _e97 = (4u * (_e89 + (_e93 >> bitcast<u32>(5u))));
                let _e98 = (2u * _e93);
                let _e101 = global_7.member[_e98];
                let _e105 = global_7.member[(_e98 + 1u)];
                let _e110 = global_7.member[((2u * _e89) + _e93)];
                let _e112 = global.member_15;
                let _e116 = bitcast<u32>(firstLeadingBit((max(_e112, 4096u) - 1u)));
                let _e117 = (_e116 + 1u);
                let _e118 = (15u - _e116);
                let _e132 = (vec2<u32>((32u << bitcast<u32>((2u * _e118))), (32u << bitcast<u32>(_e118))) - vec2<u32>(1u, 1u));
                let _e148 = (vec2<f32>(vec2<u32>(((((_e110.x >> bitcast<u32>(16u)) >> bitcast<u32>(((2u * _e117) - 16u))) << bitcast<u32>(5u)) | ((_e110.y >> bitcast<u32>(_e117)) & 31u)), ((_e110.y >> bitcast<u32>((_e116 + 6u))) & _e132.y))) / vec2<f32>(_e132));
                let _e152 = ((1f + (2f * _e148.x)) * 0.33333334f);
                let _e153 = (1f - _e152);
                let _e157 = (_e153 * (0.5f + (0.5f * _e148.y)));
                let _e166 = (vec3<u32>(_e110.x, (_e110.x >> bitcast<u32>(_e117)), _e110.y) & vec3(((1u << bitcast<u32>(_e117)) - 1u)));
                let _e178 = global.member_11;
                let _e181 = global.member_12;
                let _e187 = global.member_21;
                let _e188 = (2u * _e187);
                let _e192 = global_1.member[(_e188 + _e166.x)];
                let _e194 = unpack2x16float(_e192.x);
                let _e207 = global_1.member[(_e188 + _e166.y)];
                let _e209 = unpack2x16float(_e207.x);
                let _e222 = global_1.member[(_e188 + _e166.z)];
                let _e224 = unpack2x16float(_e222.x);
                let _e232 = ((((_e178.xyz + (_e181.xyz * vec3<f32>(f32((_e101.x & 65535u)), f32((_e101.x >> bitcast<u32>(16u))), f32((_e101.y & 65535u))))) + (vec3<f32>(_e194.x, _e194.y, unpack2x16float(_e192.y).x) * _e152)) + (vec3<f32>(_e209.x, _e209.y, unpack2x16float(_e207.y).x) * _e157)) + (vec3<f32>(_e224.x, _e224.y, unpack2x16float(_e222.y).x) * (_e153 - _e157)));
                let _e236 = vec4<f32>(_e232.x, _e232.y, _e232.z, 1f);
                let _e249 = (((_e101.y >> bitcast<u32>(16u)) | ((_e105.y >> bitcast<u32>(24u)) << bitcast<u32>(16u))) | ((_e110.y >> bitcast<u32>(26u)) << bitcast<u32>(24u)));
                let _e261 = global.member_32;
                let _e263 = global.member_33;
                let _e266 = (vec3(_e261) + (vec3<f32>(f32((_e249 & 1023u)), f32(((_e249 >> bitcast<u32>(10u)) & 1023u)), f32((_e249 >> bitcast<u32>(20u)))) * _e263));
                let _e275 = (vec4<u32>(_e105.x, (_e105.x >> bitcast<u32>(8u)), (_e105.x >> bitcast<u32>(16u)), (_e105.x >> bitcast<u32>(24u))) & vec4<u32>(255u, 255u, 255u, 255u));
                let _e281 = (vec3<u32>(_e105.y, (_e105.y >> bitcast<u32>(8u)), (_e105.y >> bitcast<u32>(16u))) & vec3<u32>(255u, 255u, 255u));
                let _e282 = vec3<f32>(_e281);
                let _e294 = (vec4<f32>(_e282.x, _e282.y, _e282.z, f32((((255u - _e281.x) - _e281.y) - _e281.z))) * vec4<f32>(0.003921569f, 0.003921569f, 0.003921569f, 0.003921569f));
                let _e297 = (3u * _e275.x);
                let _e300 = global.member_58[_e297];
                let _e305 = global.member_58[(_e297 + 1u)];
                let _e310 = global.member_58[(_e297 + 2u)];
                let _e314 = (3u * _e275.y);
                let _e317 = global.member_58[_e314];
                let _e323 = global.member_58[(_e314 + 1u)];
                let _e329 = global.member_58[(_e314 + 2u)];
                let _e334 = (3u * _e275.z);
                let _e337 = global.member_58[_e334];
                let _e343 = global.member_58[(_e334 + 1u)];
                let _e349 = global.member_58[(_e334 + 2u)];
                let _e354 = (3u * _e275.w);
                let _e357 = global.member_58[_e354];
                let _e359 = ((((_e300 * _e294.x) + (_e317 * _e294.y)) + (_e337 * _e294.z)) + (_e357 * _e294.w));
                let _e363 = global.member_58[(_e354 + 1u)];
                let _e365 = ((((_e305 * _e294.x) + (_e323 * _e294.y)) + (_e343 * _e294.z)) + (_e363 * _e294.w));
                let _e369 = global.member_58[(_e354 + 2u)];
                let _e371 = ((((_e310 * _e294.x) + (_e329 * _e294.y)) + (_e349 * _e294.z)) + (_e369 * _e294.w));
                let _e374 = dot(_e371, _e236);
                let _e375 = vec3<f32>(dot(_e359, _e236), dot(_e365, _e236), _e374);
                let _e385 = vec3<f32>(_e359.x, _e359.y, _e359.z);
                let _e386 = vec3<f32>(_e365.x, _e365.y, _e365.z);
                let _e387 = vec3<f32>(_e371.x, _e371.y, _e371.z);
                switch bitcast<i32>(0u) {
                    default: {
                        let _e391 = global.member_6;
                        if !((_e374 >= _e391)) {
                            let _e395 = global_3.member_8;
                            if (_e395 != 0u) {
                                let _e399 = atomicAdd((&global_2.member[0u]), 1u);
                            }
                            phi_5394_ = 0f;
                            phi_5390_ = vec2<f32>(0f, 0f);
                            phi_5389_ = false;
                            break;
                        }
                        let _e401 = global.member;
                        let _e407 = global.member_1;
                        let _e410 = global.member_7;
                        let _e413 = global.member_8;
                        let _e414 = ((_e410 - _e374) * _e413);
                        if (_e414 < 0f) {
                            phi_5388_ = (0.015625f / (1f - _e414));
                        } else {
                            if (_e414 > 1f) {
                                phi_5387_ = (1f - (0.015625f / _e414));
                            } else {
                                phi_5387_ = (0.015625f + (0.96875f * clamp(_e414, 0f, 1f)));
                            }
                            let _e423 = phi_5387_;
                            phi_5388_ = _e423;
                        }
                        let _e427 = phi_5388_;
                        phi_5394_ = _e427;
                        phi_5390_ = (((_e401 * _e375.xy) / vec2(_e374)) + _e407);
                        phi_5389_ = true;
                        break;
                    }
                }
                let _e429 = phi_5394_;
                let _e431 = phi_5390_;
                let _e433 = phi_5389_;
                let _e437 = global_7.member[_e97][1u];
                let _e438 = (_e93 & 31u);
                phi_5401_ = _e433;
                if (_e433 && !((((_e437 >> bitcast<u32>(_e438)) & 1u) != 0u))) {
                    switch bitcast<i32>(0u) {
                        default: {
                            let _e454 = global.member_50;
                            let _e459 = max((_e454.xy - _e431), (_e431 - _e454.zw));
                            if !((max(_e459.x, _e459.y) > 0f)) {
                                phi_5400_ = false;
                                break;
                            }
                            let _e473 = global.member_2;
                            let _e476 = global.member_3;
                            let _e480 = global.member;
                            let _e488 = global.member_47;
                            let _e493 = global.member_29;
                            let _e500 = global.member_45;
                            let _e505 = global.member_49;
                            let _e510 = any((_e459 > ((((((abs(_e480) / vec2(_e374)) * (vec2<f32>(1f, 1f) + max(abs(_e473), abs(_e476)))) * (sqrt(max(max(dot(_e385, _e385), dot(_e386, _e386)), dot(_e387, _e387))) * exp(min(max(max(_e266.x, _e266.y), _e266.z), 9f)))) + vec2(sqrt(_e488))) * (sqrt((2f * log(max((255f / _e493), 1f)))) * sqrt(_e500))) * (1.01f * max(_e505, 0f)))));
                            if _e510 {
                                let _e512 = global_3.member_8;
                                if (_e512 != 0u) {
                                    let _e516 = atomicAdd((&global_2.member[0u]), 1u);
                                }
                            }
                            phi_5400_ = _e510;
                            break;
                        }
                    }
                    let _e518 = phi_5400_;
                    phi_5401_ = !(_e518);
                }
                let _e521 = phi_5401_;
                let _e526 = global_7.member[((3u * _e89) + _e93)];
                let _e529 = (_e526.y >> bitcast<u32>(24u));
                let _e543 = ((vec3<f32>(f32((_e526.x & 1023u)), f32(((_e526.x >> bitcast<u32>(10u)) & 1023u)), f32(((_e526.x >> bitcast<u32>(20u)) & 1023u))) - vec3<f32>(512f, 512f, 512f)) * vec3<f32>(0.0013888889f, 0.0013888889f, 0.0013888889f));
                let _e547 = sqrt(max((1f - dot(_e543, _e543)), 0f));
                let _e549 = (_e526.x >> bitcast<u32>(30u));
                if (_e549 == 0u) {
                    phi_5404_ = vec4<f32>(_e547, _e543.x, _e543.y, _e543.z);
                } else {
                    if (_e549 == 1u) {
                        phi_5403_ = vec4<f32>(_e543.x, _e547, _e543.y, _e543.z);
                    } else {
                        if (_e549 == 2u) {
                            phi_5402_ = vec4<f32>(_e543.x, _e543.y, _e547, _e543.z);
                        } else {
                            phi_5402_ = vec4<f32>(_e543.x, _e543.y, _e543.z, _e547);
                        }
                        let _e562 = phi_5402_;
                        phi_5403_ = _e562;
                    }
                    let _e568 = phi_5403_;
                    phi_5404_ = _e568;
                }
                let _e574 = phi_5404_;
                let _e578 = global.member_34;
                phi_5414_ = unpack4x8unorm(_e526.y).xyz;
                if (_e578 > _e93) {
                    let _e583 = global_7.member[(_e578 + _e93)];
                    let _e585 = unpack2x16float(_e583.x);
                    phi_5414_ = vec3<f32>(_e585.x, _e585.y, unpack2x16float(_e583.y).x);
                }
                let _e593 = phi_5414_;
                let _e595 = (1u << bitcast<u32>(_e438));
                let _e598 = global_7.member[_e97];
                let _e602 = global_7.member[(_e97 + 1u)];
                let _e606 = global_7.member[(_e97 + 2u)];
                phi_5431_ = _e574;
                if ((_e598.x & _e595) != 0u) {
                    let _e617 = global.member_22;
                    let _e619 = global.member_18;
                    let _e623 = (_e617 + ((_e602.y + bitcast<u32>(countOneBits((_e598.x & (_e595 - 1u))))) * (1u + (4u * _e619))));
                    let _e624 = (_e623 + 1u);
                    let _e627 = global_6.member[_e623];
                    let _e629 = global.member_40;
                    let _e633 = global.member_19;
                    let _e637 = min(_e619, (_e627 | _e619));
                    phi_5416_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_5415_ = 0u;
                    loop {
                        let _e639 = phi_5416_;
                        let _e641 = phi_5415_;
                        let _e643 = (2u * ((_e629 + ((_e627 >> bitcast<u32>(16u)) * _e633)) + _e641));
                        let _e646 = global_1.member[_e643];
                        let _e650 = global_1.member[(_e643 + 1u)];
                        let _e656 = bitcast<vec4<f32>>(vec4<u32>(_e646.x, _e646.y, _e650.x, _e650.y));
                        let _e660 = global_6.member[(_e624 + _e641)];
                        let _e667 = global_6.member[((_e624 + _e637) + _e641)];
                        let _e675 = global_6.member[((_e624 + (2u * _e637)) + _e641)];
                        let _e683 = global_6.member[((_e624 + (3u * _e637)) + _e641)];
                        let _e687 = (_e639 + vec4<f32>(dot(unpack4x8snorm(_e660), _e656), dot(unpack4x8snorm(_e667), _e656), dot(unpack4x8snorm(_e675), _e656), dot(unpack4x8snorm(_e683), _e656)));
                        let _e689 = (_e641 + bitcast<u32>(1i));
                        phi_5416_ = _e687;
                        phi_5415_ = _e689;
                        local = _e687;
                        if (_e689 < _e637) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e695 = local;
                    let _e697 = (_e574 + (_e695 * (127f * unpack2x16float(_e627).x)));
                    phi_5431_ = select(_e574, _e697, vec4((length(_e697) >= 0.001f)));
                }
                let _e703 = phi_5431_;
                phi_5435_ = _e266;
                if ((_e598.y & _e595) != 0u) {
                    let _e714 = global.member_23;
                    let _e716 = global.member_18;
                    let _e720 = (_e714 + ((_e606.x + bitcast<u32>(countOneBits((_e598.y & (_e595 - 1u))))) * (1u + (3u * _e716))));
                    let _e721 = (_e720 + 1u);
                    let _e724 = global_6.member[_e720];
                    let _e726 = global.member_40;
                    let _e730 = global.member_19;
                    let _e734 = min(_e716, (_e724 | _e716));
                    phi_5419_ = vec3<f32>(0f, 0f, 0f);
                    phi_5418_ = 0u;
                    loop {
                        let _e736 = phi_5419_;
                        let _e738 = phi_5418_;
                        let _e740 = (2u * ((_e726 + ((_e724 >> bitcast<u32>(16u)) * _e730)) + _e738));
                        let _e743 = global_1.member[_e740];
                        let _e747 = global_1.member[(_e740 + 1u)];
                        let _e753 = bitcast<vec4<f32>>(vec4<u32>(_e743.x, _e743.y, _e747.x, _e747.y));
                        let _e757 = global_6.member[(_e721 + _e738)];
                        let _e764 = global_6.member[((_e721 + _e734) + _e738)];
                        let _e772 = global_6.member[((_e721 + (2u * _e734)) + _e738)];
                        let _e776 = (_e736 + vec3<f32>(dot(unpack4x8snorm(_e757), _e753), dot(unpack4x8snorm(_e764), _e753), dot(unpack4x8snorm(_e772), _e753)));
                        let _e778 = (_e738 + bitcast<u32>(1i));
                        phi_5419_ = _e776;
                        phi_5418_ = _e778;
                        local_1 = _e776;
                        if (_e778 < _e734) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e784 = local_1;
                    phi_5435_ = (_e266 + (_e784 * (127f * unpack2x16float(_e724).x)));
                }
                let _e788 = phi_5435_;
                phi_5437_ = _e593;
                if ((_e602.x & _e595) != 0u) {
                    let _e799 = global.member_24;
                    let _e801 = global.member_18;
                    let _e805 = (_e799 + ((_e606.y + bitcast<u32>(countOneBits((_e602.x & (_e595 - 1u))))) * (3u + (3u * _e801))));
                    let _e809 = global_6.member[(_e805 + 1u)];
                    let _e810 = unpack2x16float(_e809);
                    let _e814 = global_6.member[(_e805 + 2u)];
                    let _e823 = (_e805 + 3u);
                    let _e826 = global_6.member[_e805];
                    let _e828 = global.member_40;
                    let _e832 = global.member_19;
                    let _e836 = min(_e801, (_e826 | _e801));
                    phi_5428_ = vec3<f32>(0f, 0f, 0f);
                    phi_5427_ = 0u;
                    loop {
                        let _e838 = phi_5428_;
                        let _e840 = phi_5427_;
                        let _e842 = (2u * ((_e828 + ((_e826 >> bitcast<u32>(16u)) * _e832)) + _e840));
                        let _e845 = global_1.member[_e842];
                        let _e849 = global_1.member[(_e842 + 1u)];
                        let _e855 = bitcast<vec4<f32>>(vec4<u32>(_e845.x, _e845.y, _e849.x, _e849.y));
                        let _e859 = global_6.member[(_e823 + _e840)];
                        let _e866 = global_6.member[((_e823 + _e836) + _e840)];
                        let _e874 = global_6.member[((_e823 + (2u * _e836)) + _e840)];
                        let _e878 = (_e838 + vec3<f32>(dot(unpack4x8snorm(_e859), _e855), dot(unpack4x8snorm(_e866), _e855), dot(unpack4x8snorm(_e874), _e855)));
                        let _e880 = (_e840 + bitcast<u32>(1i));
                        phi_5428_ = _e878;
                        phi_5427_ = _e880;
                        local_2 = _e878;
                        if (_e880 < _e836) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e886 = local_2;
                    phi_5437_ = (select(vec3<f32>(_e810.x, _e810.y, unpack2x16float(_e814).x), _e593, vec3((_e578 > 0u))) + (_e886 * (127f * unpack2x16float(_e826).x)));
                }
                let _e890 = phi_5437_;
                let _e891 = normalize(_e703);
                let _e896 = (_e891.z * _e891.z);
                let _e897 = (_e891.w * _e891.w);
                let _e901 = (_e891.y * _e891.z);
                let _e902 = (_e891.x * _e891.w);
                let _e905 = (_e891.y * _e891.w);
                let _e906 = (_e891.x * _e891.z);
                let _e911 = (_e891.y * _e891.y);
                let _e915 = (_e891.z * _e891.w);
                let _e916 = (_e891.x * _e891.y);
                let _e930 = exp(min(_e788, vec3<f32>(9f, 9f, 9f)));
                let _e937 = mat3x3<f32>((vec3<f32>((1f - (2f * (_e896 + _e897))), (2f * (_e901 + _e902)), (2f * (_e905 - _e906))) * _e930.x), (vec3<f32>((2f * (_e901 - _e902)), (1f - (2f * (_e911 + _e897))), (2f * (_e915 + _e916))) * _e930.y), (vec3<f32>((2f * (_e905 + _e906)), (2f * (_e915 - _e916)), (1f - (2f * (_e911 + _e896)))) * _e930.z));
                let _e939 = (transpose(mat3x3<f32>(_e385, _e386, _e387)) * _e937);
                let _e941 = global.member_38;
                let _e943 = (_e941 + (3u * _e83));
                let _e944 = transpose(_e939);
                let _e953 = sqrt(max(max(dot(_e944[0], _e944[0]), dot(_e944[1], _e944[1])), dot(_e944[2], _e944[2])));
                let _e955 = global.member_39;
                let _e966 = (all((abs(_e375) < vec3<f32>(1000000000000000000000000000000f, 1000000000000000000000000000000f, 1000000000000000000000000000000f))) && (_e953 <= 1000000000000000000f));
                if _e966 {
                    let _e968 = global.member_51;
                    let _e972 = global.member_52;
                    phi_5438_ = ((_e375 - _e968.xyz) / _e972.xyz);
                } else {
                    phi_5438_ = vec3<f32>(0f, 0f, 0f);
                }
                let _e976 = phi_5438_;
                let _e993 = vec3<u32>(round((clamp(select(select((vec3<f32>(0.015625f, 0.015625f, 0.015625f) + (clamp(_e976, vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 0.96875f)), (vec3<f32>(0.015625f, 0.015625f, 0.015625f) / (vec3<f32>(1f, 1f, 1f) - min(_e976, vec3<f32>(0f, 0f, 0f)))), (_e976 < vec3<f32>(0f, 0f, 0f))), (vec3<f32>(1f, 1f, 1f) - (vec3<f32>(0.015625f, 0.015625f, 0.015625f) / max(_e976, vec3<f32>(1f, 1f, 1f)))), (_e976 > vec3<f32>(1f, 1f, 1f))), vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 16777215f)));
                let _e995 = (_e993 >> bitcast<vec3<u32>>(vec3<u32>(8u, 8u, 8u)));
                let _e996 = (_e993 & vec3<u32>(255u, 255u, 255u));
                let _e1012 = ((_e995.z | (u32(clamp(select(0f, ceil(((8f * log2(max((_e953 / _e955), 0.000000000000000000000000000001f))) + 152f)), _e966), 0f, 255f)) << bitcast<u32>(16u))) | (select(0u, _e529, _e966) << bitcast<u32>(24u)));
                let _e1029 = vec3<f32>(_e939[0].x, _e939[1].x, _e939[2].x);
                let _e1036 = vec3<f32>(_e939[0].y, _e939[1].y, _e939[2].y);
                let _e1043 = vec3<f32>(_e939[0].z, _e939[1].z, _e939[2].z);
                let _e1044 = length(_e1029);
                if (_e1044 > 0f) {
                    phi_5440_ = (_e1029 / vec3(_e1044));
                } else {
                    phi_5440_ = vec3<f32>(0f, 0f, 0f);
                }
                let _e1049 = phi_5440_;
                let _e1050 = dot(_e1036, _e1049);
                let _e1052 = (_e1036 - (_e1049 * _e1050));
                let _e1053 = length(_e1052);
                if (_e1053 > 0f) {
                    phi_5442_ = (_e1052 / vec3(_e1053));
                } else {
                    phi_5442_ = vec3<f32>(0f, 0f, 0f);
                }
                let _e1058 = phi_5442_;
                let _e1059 = dot(_e1043, _e1049);
                let _e1060 = dot(_e1043, _e1058);
                let _e1074 = (1023f / (_e955 * exp2(((f32(((_e1012 >> bitcast<u32>(16u)) & 255u)) * 0.125f) - 19f))));
                let _e1092 = vec3<u32>(round((clamp(_e890, vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 1023f)));
                let _e1095 = ((vec3<u32>(clamp((round((vec3<f32>(_e1044, _e1053, _e1060) * _e1074)) + vec3<f32>(1023f, 1023f, 1023f)), vec3<f32>(0f, 0f, 0f), vec3<f32>(2046f, 2046f, 2046f))) | (vec3<u32>(clamp((round((vec3<f32>(_e1050, _e1059, length(((_e1043 - (_e1049 * _e1059)) - (_e1058 * _e1060)))) * _e1074)) + vec3<f32>(1023f, 1023f, 1023f)), vec3<f32>(0f, 0f, 0f), vec3<f32>(2046f, 2046f, 2046f))) << bitcast<vec3<u32>>(vec3<u32>(11u, 11u, 11u)))) | (_e1092 << bitcast<vec3<u32>>(vec3<u32>(22u, 22u, 22u))));
                global_4.member[_e943] = (_e995.x | (_e995.y << bitcast<u32>(16u)));
                global_4.member[(_e943 + 1u)] = _e1012;
                global_4.member[(_e943 + 2u)] = ((_e996.x | (_e996.y << bitcast<u32>(8u))) | (_e996.z << bitcast<u32>(16u)));
                let _e1106 = (_e941 + (3u * (_e85 + _e83)));
                global_4.member[_e1106] = _e1095.x;
                global_4.member[(_e1106 + 1u)] = _e1095.y;
                global_4.member[(_e1106 + 2u)] = _e1095.z;
                phi_3098_ = _e521;
                if _e521 {
                    let _e1120 = global.member_29;
                    phi_3098_ = (f32(_e529) <= _e1120);
                }
                let _e1123 = phi_3098_;
                if _e1123 {
                    let _e1125 = global_3.member_8;
                    if (_e1125 != 0u) {
                        let _e1129 = atomicAdd((&global_2.member[1u]), 1u);
                    }
                }
                let _e1130 = !(_e521);
                phi_3112_ = _e1130;
                if !(_e1130) {
                    let _e1134 = global.member_29;
                    phi_3112_ = (f32(_e529) <= _e1134);
                }
                let _e1137 = phi_3112_;
                if _e1137 {
                    phi_5487_ = 4294967295u;
                    break;
                }
                switch bitcast<i32>(0u) {
                    default: {
                        let _e1143 = global.member_2;
                        let _e1145 = global.member_3;
                        let _e1146 = clamp((_e375.xy / vec2(_e374)), _e1143, _e1145);
                        let _e1149 = global.member[0u];
                        let _e1155 = (((_e385 - (_e387 * _e1146.x)) * (_e1149 / _e374)) * _e937);
                        let _e1158 = global.member[1u];
                        let _e1164 = (((_e386 - (_e387 * _e1146.y)) * (_e1158 / _e374)) * _e937);
                        let _e1166 = global.member_47;
                        let _e1168 = (dot(_e1155, _e1155) + _e1166);
                        let _e1171 = (dot(_e1164, _e1164) + _e1166);
                        let _e1173 = cross(_e1155, _e1164);
                        let _e1174 = dot(_e1173, _e1173);
                        let _e1178 = (_e1174 + (_e1166 * ((_e1168 + _e1171) - _e1166)));
                        let _e1179 = (_e1178 > 0f);
                        phi_4809_ = _e1179;
                        if _e1179 {
                            phi_4809_ = (_e1168 <= 1000000000000000000f);
                        }
                        let _e1182 = phi_4809_;
                        phi_4815_ = _e1182;
                        if _e1182 {
                            phi_4815_ = (_e1171 <= 1000000000000000000f);
                        }
                        let _e1185 = phi_4815_;
                        if !(_e1185) {
                            let _e1188 = global_3.member_8;
                            if (_e1188 != 0u) {
                                let _e1192 = atomicAdd((&global_2.member[2u]), 1u);
                            }
                            phi_5486_ = 4294967295u;
                            break;
                        }
                        phi_5473_ = (1f - (f32(_e529) * 0.003921569f));
                        phi_5472_ = 0u;
                        loop {
                            let _e1197 = phi_5473_;
                            let _e1199 = phi_5472_;
                            local_3 = _e1197;
                            if (_e1199 < 3u) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                phi_5473_ = select(_e1197, (_e1197 * _e1197), (_e1199 < _e91));
                                phi_5472_ = (_e1199 + bitcast<u32>(1i));
                            }
                        }
                        let _e1207 = local_3;
                        let _e1215 = global.member_48;
                        let _e1222 = u32(round((f32(u32(round((255f * (1f - _e1207))))) * ((1f - _e1215) + (_e1215 * sqrt((_e1174 / _e1178)))))));
                        let _e1223 = f32(_e1222);
                        let _e1225 = global.member_29;
                        if (_e1223 <= _e1225) {
                            let _e1228 = global_3.member_8;
                            if (_e1228 != 0u) {
                                let _e1232 = atomicAdd((&global_2.member[1u]), 1u);
                            }
                            phi_5486_ = 4294967295u;
                            break;
                        }
                        let _e1234 = global.member_45;
                        let _e1235 = (vec3<f32>(_e1168, dot(_e1155, _e1164), _e1171) * _e1234);
                        let _e1247 = global.member_49;
                        let _e1248 = ((sqrt(_e1235.xz) * sqrt((2f * log(max((_e1223 / _e1225), 1f))))) * _e1247);
                        let _e1251 = global.member_50;
                        let _e1254 = all(((_e431 + _e1248) > _e1251.xy));
                        phi_4888_ = _e1254;
                        if _e1254 {
                            phi_4888_ = all(((_e431 - _e1248) < _e1251.zw));
                        }
                        let _e1260 = phi_4888_;
                        if !(_e1260) {
                            let _e1263 = global_3.member_8;
                            if (_e1263 != 0u) {
                                let _e1267 = atomicAdd((&global_2.member[0u]), 1u);
                            }
                            phi_5486_ = 4294967295u;
                            break;
                        }
                        let _e1271 = (0.5f * (_e1235.x - _e1235.z));
                        let _e1276 = sqrt(((_e1271 * _e1271) + (_e1235.y * _e1235.y)));
                        let _e1279 = ((0.5f * (_e1235.x + _e1235.z)) + _e1276);
                        if (_e1271 >= 0f) {
                            phi_5482_ = vec2<f32>((_e1271 + _e1276), _e1235.y);
                        } else {
                            phi_5482_ = vec2<f32>(_e1235.y, (_e1276 - _e1271));
                        }
                        let _e1286 = phi_5482_;
                        if (_e1276 > (0.00000001f * _e1279)) {
                            phi_5483_ = normalize(_e1286);
                        } else {
                            phi_5483_ = vec2<f32>(1f, 0f);
                        }
                        let _e1291 = phi_5483_;
                        let _e1299 = max(-(_e431), (_e431 * 0.5f));
                        let _e1304 = global.member_5;
                        let _e1305 = (max(_e1299.x, _e1299.y) / _e1304);
                        let _e1313 = ((select(0u, 1u, (_e1305 > 1f)) + select(0u, 1u, (_e1305 > 64f))) + select(0u, 1u, (_e1305 > 4096f)));
                        let _e1322 = global.member_10;
                        let _e1326 = vec2<u32>(clamp(round((((_e431 * exp2(-(f32((_e1313 * 6u))))) + vec2(_e1304)) * _e1322)), vec2<f32>(0f, 0f), vec2<f32>(1048575f, 1048575f)));
                        let _e1357 = global.member_41;
                        let _e1359 = (4u * (_e1357 + _e83));
                        global_4.member[_e1359] = ((_e1326.x | (_e1092.x << bitcast<u32>(20u))) | (_e1092.z << bitcast<u32>(30u)));
                        global_4.member[(_e1359 + 1u)] = ((_e1326.y | (_e1092.y << bitcast<u32>(20u))) | (_e1313 << bitcast<u32>(30u)));
                        global_4.member[(_e1359 + 2u)] = pack2x16float((_e1291 * min(sqrt(_e1279), 65504f)));
                        global_4.member[(_e1359 + 3u)] = ((pack2x16float(vec2<f32>(min(sqrt(((_e1178 * (_e1234 * _e1234)) / _e1279)), 65504f), 0f)) | (_e1222 << bitcast<u32>(16u))) | ((_e1092.z >> bitcast<u32>(2u)) << bitcast<u32>(24u)));
                        let _e1372 = global.member_9;
                        phi_5486_ = min(u32((_e429 * f32(_e1372))), _e1372);
                        break;
                    }
                }
                let _e1378 = phi_5486_;
                phi_5487_ = _e1378;
                break;
            }
        }
        let _e1380 = phi_5487_;
        phi_5488_ = _e1380;
    } else {
        phi_5488_ = 4294967295u;
    }
    let _e1382 = phi_5488_;
    let _e1384 = bitcast<u32>(param[0u]);
    let _e1386 = global.member_41;
    let _e1387 = (_e1386 + _e83);
    if (_e1382 != 4294967295u) {
        let _e1390 = global.member_37;
        let _e1394 = global.member_36;
        let _e1400 = atomicAdd((&global_2.member[((_e1394 + ((_e1387 / _e1390) * 256u)) + (_e1382 & 255u))]), 1u);
    }
    global_5[_e1384] = _e1382;
    workgroupBarrier();
    let _e1403 = ((_e1384 & 1u) == 0u);
    if select(_e1403, _e86, _e1403) {
        let _e1406 = global.member_28;
        let _e1413 = global_5[(_e1384 + 1u)];
        global_4.member[(_e1406 + (_e1387 >> bitcast<u32>(1u)))] = ((_e1382 & 65535u) | (_e1413 << bitcast<u32>(16u)));
    }
    return;
}
