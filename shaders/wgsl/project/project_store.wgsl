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
    var phi_5372_: f32;
    var phi_5373_: f32;
    var phi_5379_: f32;
    var phi_5375_: vec2<f32>;
    var phi_5374_: bool;
    var phi_5385_: bool;
    var phi_5386_: bool;
    var phi_5387_: vec4<f32>;
    var phi_5388_: vec4<f32>;
    var phi_5389_: vec4<f32>;
    var phi_5399_: vec3<f32>;
    var phi_5401_: vec4<f32>;
    var phi_5400_: u32;
    var local: vec4<f32>;
    var phi_5416_: vec4<f32>;
    var phi_5404_: vec3<f32>;
    var phi_5403_: u32;
    var local_1: vec3<f32>;
    var phi_5420_: vec3<f32>;
    var phi_5413_: vec3<f32>;
    var phi_5412_: u32;
    var local_2: vec3<f32>;
    var phi_5422_: vec3<f32>;
    var phi_5423_: vec3<f32>;
    var phi_5425_: vec3<f32>;
    var phi_5427_: vec3<f32>;
    var phi_3088_: bool;
    var phi_3102_: bool;
    var phi_4766_: bool;
    var phi_4772_: bool;
    var phi_5458_: f32;
    var phi_5457_: u32;
    var local_3: f32;
    var phi_5466_: u32;
    var phi_4850_: bool;
    var phi_5470_: vec2<f32>;
    var phi_5471_: vec2<f32>;
    var phi_5474_: u32;
    var phi_5475_: u32;
    var phi_5476_: u32;

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
                            let _e395 = global_3.member_9;
                            if (_e395 != 0u) {
                                let _e399 = atomicAdd((&global_2.member[0u]), 1u);
                            }
                            phi_5379_ = 0f;
                            phi_5375_ = vec2<f32>(0f, 0f);
                            phi_5374_ = false;
                            break;
                        }
                        let _e401 = global.member;
                        let _e407 = global.member_1;
                        let _e410 = global.member_7;
                        let _e413 = global.member_8;
                        let _e414 = ((_e410 - _e374) * _e413);
                        if (_e414 < 0f) {
                            phi_5373_ = (0.015625f / (1f - _e414));
                        } else {
                            if (_e414 > 1f) {
                                phi_5372_ = (1f - (0.015625f / _e414));
                            } else {
                                phi_5372_ = (0.015625f + (0.96875f * clamp(_e414, 0f, 1f)));
                            }
                            let _e423 = phi_5372_;
                            phi_5373_ = _e423;
                        }
                        let _e427 = phi_5373_;
                        phi_5379_ = _e427;
                        phi_5375_ = (((_e401 * _e375.xy) / vec2(_e374)) + _e407);
                        phi_5374_ = true;
                        break;
                    }
                }
                let _e429 = phi_5379_;
                let _e431 = phi_5375_;
                let _e433 = phi_5374_;
                let _e437 = global_7.member[_e97][1u];
                let _e438 = (_e93 & 31u);
                phi_5386_ = _e433;
                if (_e433 && !((((_e437 >> bitcast<u32>(_e438)) & 1u) != 0u))) {
                    switch bitcast<i32>(0u) {
                        default: {
                            let _e454 = global.member_50;
                            let _e459 = max((_e454.xy - _e431), (_e431 - _e454.zw));
                            if !((max(_e459.x, _e459.y) > 0f)) {
                                phi_5385_ = false;
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
                                let _e512 = global_3.member_9;
                                if (_e512 != 0u) {
                                    let _e516 = atomicAdd((&global_2.member[0u]), 1u);
                                }
                            }
                            phi_5385_ = _e510;
                            break;
                        }
                    }
                    let _e518 = phi_5385_;
                    phi_5386_ = !(_e518);
                }
                let _e521 = phi_5386_;
                let _e526 = global_7.member[((3u * _e89) + _e93)];
                let _e529 = (_e526.y >> bitcast<u32>(24u));
                let _e543 = ((vec3<f32>(f32((_e526.x & 1023u)), f32(((_e526.x >> bitcast<u32>(10u)) & 1023u)), f32(((_e526.x >> bitcast<u32>(20u)) & 1023u))) - vec3<f32>(512f, 512f, 512f)) * vec3<f32>(0.0013888889f, 0.0013888889f, 0.0013888889f));
                let _e547 = sqrt(max((1f - dot(_e543, _e543)), 0f));
                let _e549 = (_e526.x >> bitcast<u32>(30u));
                if (_e549 == 0u) {
                    phi_5389_ = vec4<f32>(_e547, _e543.x, _e543.y, _e543.z);
                } else {
                    if (_e549 == 1u) {
                        phi_5388_ = vec4<f32>(_e543.x, _e547, _e543.y, _e543.z);
                    } else {
                        if (_e549 == 2u) {
                            phi_5387_ = vec4<f32>(_e543.x, _e543.y, _e547, _e543.z);
                        } else {
                            phi_5387_ = vec4<f32>(_e543.x, _e543.y, _e543.z, _e547);
                        }
                        let _e562 = phi_5387_;
                        phi_5388_ = _e562;
                    }
                    let _e568 = phi_5388_;
                    phi_5389_ = _e568;
                }
                let _e574 = phi_5389_;
                let _e578 = global.member_34;
                let _e579 = (_e578 > 0u);
                phi_5399_ = unpack4x8unorm(_e526.y).xyz;
                if _e579 {
                    let _e583 = global_7.member[(_e578 + _e93)];
                    let _e585 = unpack2x16float(_e583.x);
                    phi_5399_ = vec3<f32>(_e585.x, _e585.y, unpack2x16float(_e583.y).x);
                }
                let _e593 = phi_5399_;
                let _e595 = (1u << bitcast<u32>(_e438));
                let _e598 = global_7.member[_e97];
                let _e602 = global_7.member[(_e97 + 1u)];
                let _e606 = global_7.member[(_e97 + 2u)];
                phi_5416_ = _e574;
                if ((_e598.x & _e595) != 0u) {
                    let _e617 = global.member_22;
                    let _e619 = global.member_18;
                    let _e623 = (_e617 + ((_e602.y + bitcast<u32>(countOneBits((_e598.x & (_e595 - 1u))))) * (1u + (4u * _e619))));
                    let _e624 = (_e623 + 1u);
                    let _e627 = global_6.member[_e623];
                    let _e629 = global.member_40;
                    let _e633 = global.member_19;
                    phi_5401_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_5400_ = 0u;
                    loop {
                        let _e637 = phi_5401_;
                        let _e639 = phi_5400_;
                        let _e641 = (2u * ((_e629 + ((_e627 >> bitcast<u32>(16u)) * _e633)) + _e639));
                        let _e644 = global_1.member[_e641];
                        let _e648 = global_1.member[(_e641 + 1u)];
                        let _e654 = bitcast<vec4<f32>>(vec4<u32>(_e644.x, _e644.y, _e648.x, _e648.y));
                        let _e658 = global_6.member[(_e624 + _e639)];
                        let _e665 = global_6.member[((_e624 + _e619) + _e639)];
                        let _e673 = global_6.member[((_e624 + (2u * _e619)) + _e639)];
                        let _e681 = global_6.member[((_e624 + (3u * _e619)) + _e639)];
                        let _e685 = (_e637 + vec4<f32>(dot(unpack4x8snorm(_e658), _e654), dot(unpack4x8snorm(_e665), _e654), dot(unpack4x8snorm(_e673), _e654), dot(unpack4x8snorm(_e681), _e654)));
                        let _e687 = (_e639 + bitcast<u32>(1i));
                        phi_5401_ = _e685;
                        phi_5400_ = _e687;
                        local = _e685;
                        if (_e687 < _e619) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e693 = local;
                    let _e695 = (_e574 + (_e693 * (127f * unpack2x16float(_e627).x)));
                    phi_5416_ = select(_e574, _e695, vec4((length(_e695) >= 0.001f)));
                }
                let _e701 = phi_5416_;
                phi_5420_ = _e266;
                if ((_e598.y & _e595) != 0u) {
                    let _e712 = global.member_23;
                    let _e714 = global.member_18;
                    let _e718 = (_e712 + ((_e606.x + bitcast<u32>(countOneBits((_e598.y & (_e595 - 1u))))) * (1u + (3u * _e714))));
                    let _e719 = (_e718 + 1u);
                    let _e722 = global_6.member[_e718];
                    let _e724 = global.member_40;
                    let _e728 = global.member_19;
                    phi_5404_ = vec3<f32>(0f, 0f, 0f);
                    phi_5403_ = 0u;
                    loop {
                        let _e732 = phi_5404_;
                        let _e734 = phi_5403_;
                        let _e736 = (2u * ((_e724 + ((_e722 >> bitcast<u32>(16u)) * _e728)) + _e734));
                        let _e739 = global_1.member[_e736];
                        let _e743 = global_1.member[(_e736 + 1u)];
                        let _e749 = bitcast<vec4<f32>>(vec4<u32>(_e739.x, _e739.y, _e743.x, _e743.y));
                        let _e753 = global_6.member[(_e719 + _e734)];
                        let _e760 = global_6.member[((_e719 + _e714) + _e734)];
                        let _e768 = global_6.member[((_e719 + (2u * _e714)) + _e734)];
                        let _e772 = (_e732 + vec3<f32>(dot(unpack4x8snorm(_e753), _e749), dot(unpack4x8snorm(_e760), _e749), dot(unpack4x8snorm(_e768), _e749)));
                        let _e774 = (_e734 + bitcast<u32>(1i));
                        phi_5404_ = _e772;
                        phi_5403_ = _e774;
                        local_1 = _e772;
                        if (_e774 < _e714) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e780 = local_1;
                    phi_5420_ = (_e266 + (_e780 * (127f * unpack2x16float(_e722).x)));
                }
                let _e784 = phi_5420_;
                phi_5422_ = _e593;
                if ((_e602.x & _e595) != 0u) {
                    let _e795 = global.member_24;
                    let _e797 = global.member_18;
                    let _e801 = (_e795 + ((_e606.y + bitcast<u32>(countOneBits((_e602.x & (_e595 - 1u))))) * (3u + (3u * _e797))));
                    let _e805 = global_6.member[(_e801 + 1u)];
                    let _e806 = unpack2x16float(_e805);
                    let _e810 = global_6.member[(_e801 + 2u)];
                    let _e818 = (_e801 + 3u);
                    let _e821 = global_6.member[_e801];
                    let _e823 = global.member_40;
                    let _e827 = global.member_19;
                    phi_5413_ = vec3<f32>(0f, 0f, 0f);
                    phi_5412_ = 0u;
                    loop {
                        let _e831 = phi_5413_;
                        let _e833 = phi_5412_;
                        let _e835 = (2u * ((_e823 + ((_e821 >> bitcast<u32>(16u)) * _e827)) + _e833));
                        let _e838 = global_1.member[_e835];
                        let _e842 = global_1.member[(_e835 + 1u)];
                        let _e848 = bitcast<vec4<f32>>(vec4<u32>(_e838.x, _e838.y, _e842.x, _e842.y));
                        let _e852 = global_6.member[(_e818 + _e833)];
                        let _e859 = global_6.member[((_e818 + _e797) + _e833)];
                        let _e867 = global_6.member[((_e818 + (2u * _e797)) + _e833)];
                        let _e871 = (_e831 + vec3<f32>(dot(unpack4x8snorm(_e852), _e848), dot(unpack4x8snorm(_e859), _e848), dot(unpack4x8snorm(_e867), _e848)));
                        let _e873 = (_e833 + bitcast<u32>(1i));
                        phi_5413_ = _e871;
                        phi_5412_ = _e873;
                        local_2 = _e871;
                        if (_e873 < _e797) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e879 = local_2;
                    phi_5422_ = (select(vec3<f32>(_e806.x, _e806.y, unpack2x16float(_e810).x), _e593, vec3(_e579)) + (_e879 * (127f * unpack2x16float(_e821).x)));
                }
                let _e883 = phi_5422_;
                let _e884 = normalize(_e701);
                let _e889 = (_e884.z * _e884.z);
                let _e890 = (_e884.w * _e884.w);
                let _e894 = (_e884.y * _e884.z);
                let _e895 = (_e884.x * _e884.w);
                let _e898 = (_e884.y * _e884.w);
                let _e899 = (_e884.x * _e884.z);
                let _e904 = (_e884.y * _e884.y);
                let _e908 = (_e884.z * _e884.w);
                let _e909 = (_e884.x * _e884.y);
                let _e923 = exp(min(_e784, vec3<f32>(9f, 9f, 9f)));
                let _e930 = mat3x3<f32>((vec3<f32>((1f - (2f * (_e889 + _e890))), (2f * (_e894 + _e895)), (2f * (_e898 - _e899))) * _e923.x), (vec3<f32>((2f * (_e894 - _e895)), (1f - (2f * (_e904 + _e890))), (2f * (_e908 + _e909))) * _e923.y), (vec3<f32>((2f * (_e898 + _e899)), (2f * (_e908 - _e909)), (1f - (2f * (_e904 + _e889)))) * _e923.z));
                let _e932 = (transpose(mat3x3<f32>(_e385, _e386, _e387)) * _e930);
                let _e934 = global.member_38;
                let _e936 = (_e934 + (3u * _e83));
                let _e937 = transpose(_e932);
                let _e946 = sqrt(max(max(dot(_e937[0], _e937[0]), dot(_e937[1], _e937[1])), dot(_e937[2], _e937[2])));
                let _e948 = global.member_39;
                let _e959 = (all((abs(_e375) < vec3<f32>(1000000000000000000000000000000f, 1000000000000000000000000000000f, 1000000000000000000000000000000f))) && (_e946 <= 1000000000000000000f));
                if _e959 {
                    let _e961 = global.member_51;
                    let _e965 = global.member_52;
                    phi_5423_ = ((_e375 - _e961.xyz) / _e965.xyz);
                } else {
                    phi_5423_ = vec3<f32>(0f, 0f, 0f);
                }
                let _e969 = phi_5423_;
                let _e986 = vec3<u32>(round((clamp(select(select((vec3<f32>(0.015625f, 0.015625f, 0.015625f) + (clamp(_e969, vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 0.96875f)), (vec3<f32>(0.015625f, 0.015625f, 0.015625f) / (vec3<f32>(1f, 1f, 1f) - min(_e969, vec3<f32>(0f, 0f, 0f)))), (_e969 < vec3<f32>(0f, 0f, 0f))), (vec3<f32>(1f, 1f, 1f) - (vec3<f32>(0.015625f, 0.015625f, 0.015625f) / max(_e969, vec3<f32>(1f, 1f, 1f)))), (_e969 > vec3<f32>(1f, 1f, 1f))), vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 16777215f)));
                let _e988 = (_e986 >> bitcast<vec3<u32>>(vec3<u32>(8u, 8u, 8u)));
                let _e989 = (_e986 & vec3<u32>(255u, 255u, 255u));
                let _e1005 = ((_e988.z | (u32(clamp(select(0f, ceil(((8f * log2(max((_e946 / _e948), 0.000000000000000000000000000001f))) + 152f)), _e959), 0f, 255f)) << bitcast<u32>(16u))) | (select(0u, _e529, _e959) << bitcast<u32>(24u)));
                let _e1022 = vec3<f32>(_e932[0].x, _e932[1].x, _e932[2].x);
                let _e1029 = vec3<f32>(_e932[0].y, _e932[1].y, _e932[2].y);
                let _e1036 = vec3<f32>(_e932[0].z, _e932[1].z, _e932[2].z);
                let _e1037 = length(_e1022);
                if (_e1037 > 0f) {
                    phi_5425_ = (_e1022 / vec3(_e1037));
                } else {
                    phi_5425_ = vec3<f32>(0f, 0f, 0f);
                }
                let _e1042 = phi_5425_;
                let _e1043 = dot(_e1029, _e1042);
                let _e1045 = (_e1029 - (_e1042 * _e1043));
                let _e1046 = length(_e1045);
                if (_e1046 > 0f) {
                    phi_5427_ = (_e1045 / vec3(_e1046));
                } else {
                    phi_5427_ = vec3<f32>(0f, 0f, 0f);
                }
                let _e1051 = phi_5427_;
                let _e1052 = dot(_e1036, _e1042);
                let _e1053 = dot(_e1036, _e1051);
                let _e1067 = (1023f / (_e948 * exp2(((f32(((_e1005 >> bitcast<u32>(16u)) & 255u)) * 0.125f) - 19f))));
                let _e1085 = vec3<u32>(round((clamp(_e883, vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 1023f)));
                let _e1088 = ((vec3<u32>(clamp((round((vec3<f32>(_e1037, _e1046, _e1053) * _e1067)) + vec3<f32>(1023f, 1023f, 1023f)), vec3<f32>(0f, 0f, 0f), vec3<f32>(2046f, 2046f, 2046f))) | (vec3<u32>(clamp((round((vec3<f32>(_e1043, _e1052, length(((_e1036 - (_e1042 * _e1052)) - (_e1051 * _e1053)))) * _e1067)) + vec3<f32>(1023f, 1023f, 1023f)), vec3<f32>(0f, 0f, 0f), vec3<f32>(2046f, 2046f, 2046f))) << bitcast<vec3<u32>>(vec3<u32>(11u, 11u, 11u)))) | (_e1085 << bitcast<vec3<u32>>(vec3<u32>(22u, 22u, 22u))));
                global_4.member[_e936] = (_e988.x | (_e988.y << bitcast<u32>(16u)));
                global_4.member[(_e936 + 1u)] = _e1005;
                global_4.member[(_e936 + 2u)] = ((_e989.x | (_e989.y << bitcast<u32>(8u))) | (_e989.z << bitcast<u32>(16u)));
                let _e1099 = (_e934 + (3u * (_e85 + _e83)));
                global_4.member[_e1099] = _e1088.x;
                global_4.member[(_e1099 + 1u)] = _e1088.y;
                global_4.member[(_e1099 + 2u)] = _e1088.z;
                phi_3088_ = _e521;
                if _e521 {
                    let _e1113 = global.member_29;
                    phi_3088_ = (f32(_e529) <= _e1113);
                }
                let _e1116 = phi_3088_;
                if _e1116 {
                    let _e1118 = global_3.member_9;
                    if (_e1118 != 0u) {
                        let _e1122 = atomicAdd((&global_2.member[1u]), 1u);
                    }
                }
                let _e1123 = !(_e521);
                phi_3102_ = _e1123;
                if !(_e1123) {
                    let _e1127 = global.member_29;
                    phi_3102_ = (f32(_e529) <= _e1127);
                }
                let _e1130 = phi_3102_;
                if _e1130 {
                    phi_5475_ = 4294967295u;
                    break;
                }
                switch bitcast<i32>(0u) {
                    default: {
                        let _e1136 = global.member_2;
                        let _e1138 = global.member_3;
                        let _e1139 = clamp((_e375.xy / vec2(_e374)), _e1136, _e1138);
                        let _e1142 = global.member[0u];
                        let _e1148 = (((_e385 - (_e387 * _e1139.x)) * (_e1142 / _e374)) * _e930);
                        let _e1151 = global.member[1u];
                        let _e1157 = (((_e386 - (_e387 * _e1139.y)) * (_e1151 / _e374)) * _e930);
                        let _e1159 = global.member_47;
                        let _e1161 = (dot(_e1148, _e1148) + _e1159);
                        let _e1164 = (dot(_e1157, _e1157) + _e1159);
                        let _e1166 = cross(_e1148, _e1157);
                        let _e1167 = dot(_e1166, _e1166);
                        let _e1171 = (_e1167 + (_e1159 * ((_e1161 + _e1164) - _e1159)));
                        let _e1172 = (_e1171 > 0f);
                        phi_4766_ = _e1172;
                        if _e1172 {
                            phi_4766_ = (_e1161 <= 1000000000000000000f);
                        }
                        let _e1175 = phi_4766_;
                        phi_4772_ = _e1175;
                        if _e1175 {
                            phi_4772_ = (_e1164 <= 1000000000000000000f);
                        }
                        let _e1178 = phi_4772_;
                        if !(_e1178) {
                            let _e1181 = global_3.member_9;
                            if (_e1181 != 0u) {
                                let _e1185 = atomicAdd((&global_2.member[2u]), 1u);
                            }
                            phi_5474_ = 4294967295u;
                            break;
                        }
                        phi_5458_ = (1f - (f32(_e529) * 0.003921569f));
                        phi_5457_ = 0u;
                        loop {
                            let _e1190 = phi_5458_;
                            let _e1192 = phi_5457_;
                            local_3 = _e1190;
                            if (_e1192 < 3u) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                phi_5458_ = select(_e1190, (_e1190 * _e1190), (_e1192 < _e91));
                                phi_5457_ = (_e1192 + bitcast<u32>(1i));
                            }
                        }
                        let _e1200 = local_3;
                        let _e1204 = u32(round((255f * (1f - _e1200))));
                        let _e1206 = global.member_48;
                        phi_5466_ = _e1204;
                        if (_e1206 > 0f) {
                            let _e1216 = u32(round((f32(_e1204) * ((1f - _e1206) + (_e1206 * sqrt((_e1167 / _e1171)))))));
                            let _e1219 = global.member_29;
                            if (f32(_e1216) <= _e1219) {
                                let _e1222 = global_3.member_9;
                                if (_e1222 != 0u) {
                                    let _e1226 = atomicAdd((&global_2.member[1u]), 1u);
                                }
                                phi_5474_ = 4294967295u;
                                break;
                            }
                            phi_5466_ = _e1216;
                        }
                        let _e1228 = phi_5466_;
                        let _e1230 = global.member_45;
                        let _e1231 = (vec3<f32>(_e1161, dot(_e1148, _e1157), _e1164) * _e1230);
                        let _e1236 = global.member_29;
                        let _e1246 = global.member_49;
                        let _e1247 = ((sqrt(_e1231.xz) * sqrt((2f * log(max((f32(_e1228) / _e1236), 1f))))) * _e1246);
                        let _e1250 = global.member_50;
                        let _e1253 = all(((_e431 + _e1247) > _e1250.xy));
                        phi_4850_ = _e1253;
                        if _e1253 {
                            phi_4850_ = all(((_e431 - _e1247) < _e1250.zw));
                        }
                        let _e1259 = phi_4850_;
                        if !(_e1259) {
                            let _e1262 = global_3.member_9;
                            if (_e1262 != 0u) {
                                let _e1266 = atomicAdd((&global_2.member[0u]), 1u);
                            }
                            phi_5474_ = 4294967295u;
                            break;
                        }
                        let _e1270 = (0.5f * (_e1231.x - _e1231.z));
                        let _e1275 = sqrt(((_e1270 * _e1270) + (_e1231.y * _e1231.y)));
                        let _e1278 = ((0.5f * (_e1231.x + _e1231.z)) + _e1275);
                        if (_e1270 >= 0f) {
                            phi_5470_ = vec2<f32>((_e1270 + _e1275), _e1231.y);
                        } else {
                            phi_5470_ = vec2<f32>(_e1231.y, (_e1275 - _e1270));
                        }
                        let _e1285 = phi_5470_;
                        if (_e1275 > (0.00000001f * _e1278)) {
                            phi_5471_ = normalize(_e1285);
                        } else {
                            phi_5471_ = vec2<f32>(1f, 0f);
                        }
                        let _e1290 = phi_5471_;
                        let _e1298 = max(-(_e431), (_e431 * 0.5f));
                        let _e1303 = global.member_5;
                        let _e1304 = (max(_e1298.x, _e1298.y) / _e1303);
                        let _e1312 = ((select(0u, 1u, (_e1304 > 1f)) + select(0u, 1u, (_e1304 > 64f))) + select(0u, 1u, (_e1304 > 4096f)));
                        let _e1321 = global.member_10;
                        let _e1325 = vec2<u32>(clamp(round((((_e431 * exp2(-(f32((_e1312 * 6u))))) + vec2(_e1303)) * _e1321)), vec2<f32>(0f, 0f), vec2<f32>(1048575f, 1048575f)));
                        let _e1356 = global.member_41;
                        let _e1358 = (4u * (_e1356 + _e83));
                        global_4.member[_e1358] = ((_e1325.x | (_e1085.x << bitcast<u32>(20u))) | (_e1085.z << bitcast<u32>(30u)));
                        global_4.member[(_e1358 + 1u)] = ((_e1325.y | (_e1085.y << bitcast<u32>(20u))) | (_e1312 << bitcast<u32>(30u)));
                        global_4.member[(_e1358 + 2u)] = pack2x16float((_e1290 * min(sqrt(_e1278), 65504f)));
                        global_4.member[(_e1358 + 3u)] = ((pack2x16float(vec2<f32>(min(sqrt(((_e1171 * (_e1230 * _e1230)) / _e1278)), 65504f), 0f)) | (_e1228 << bitcast<u32>(16u))) | ((_e1085.z >> bitcast<u32>(2u)) << bitcast<u32>(24u)));
                        let _e1371 = global.member_9;
                        phi_5474_ = min(u32((_e429 * f32(_e1371))), _e1371);
                        break;
                    }
                }
                let _e1377 = phi_5474_;
                phi_5475_ = _e1377;
                break;
            }
        }
        let _e1379 = phi_5475_;
        phi_5476_ = _e1379;
    } else {
        phi_5476_ = 4294967295u;
    }
    let _e1381 = phi_5476_;
    switch bitcast<i32>(0u) {
        default: {
            let _e1384 = bitcast<u32>(param[0u]);
            let _e1386 = global.member_41;
            let _e1387 = (_e1386 + _e83);
            if (_e1381 != 4294967295u) {
                let _e1390 = global.member_37;
                let _e1394 = global.member_36;
                let _e1400 = atomicAdd((&global_2.member[((_e1394 + ((_e1387 / _e1390) * 256u)) + (_e1381 & 255u))]), 1u);
            }
            let _e1402 = global.member_35;
            if (_e1402 == 0u) {
                if (_e83 < (_e85 + (_e85 & 1u))) {
                    let _e1408 = global.member_28;
                    global_4.member[(_e1408 + _e1387)] = _e1381;
                }
                break;
            }
            global_5[_e1384] = _e1381;
            workgroupBarrier();
            let _e1414 = ((_e1384 & 1u) == 0u);
            if select(_e1414, _e86, _e1414) {
                let _e1417 = global.member_28;
                let _e1424 = global_5[(_e1384 + 1u)];
                global_4.member[(_e1417 + (_e1387 >> bitcast<u32>(1u)))] = ((_e1381 & 65535u) | (_e1424 << bitcast<u32>(16u)));
            }
            break;
        }
    }
    return;
}
