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
    member_15: f32,
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
    var phi_3228_: bool;
    var phi_4881_: f32;
    var phi_4882_: f32;
    var phi_4890_: f32;
    var phi_4884_: vec2<f32>;
    var phi_4883_: bool;
    var phi_4894_: vec4<f32>;
    var phi_4895_: vec4<f32>;
    var phi_4896_: vec4<f32>;
    var phi_4908_: vec3<f32>;
    var phi_4910_: vec4<f32>;
    var phi_4909_: u32;
    var local: vec4<f32>;
    var phi_4925_: vec4<f32>;
    var phi_4913_: vec3<f32>;
    var phi_4912_: u32;
    var local_1: vec3<f32>;
    var phi_4929_: vec3<f32>;
    var phi_4922_: vec3<f32>;
    var phi_4921_: u32;
    var local_2: vec3<f32>;
    var phi_4931_: vec3<f32>;
    var phi_4932_: vec3<f32>;
    var phi_4934_: vec3<f32>;
    var phi_4936_: vec3<f32>;
    var phi_2816_: bool;
    var phi_2830_: bool;
    var phi_4340_: bool;
    var phi_4346_: bool;
    var phi_4951_: f32;
    var phi_4950_: u32;
    var local_3: f32;
    var phi_4959_: u32;
    var phi_4424_: bool;
    var phi_4963_: vec2<f32>;
    var phi_4964_: vec2<f32>;
    var phi_4965_: u32;
    var phi_4966_: u32;
    var phi_4967_: u32;

    let _e75 = bitcast<u32>(param_1[0u]);
    let _e77 = global.member_44;
    let _e78 = (_e75 < _e77);
    if _e78 {
        switch bitcast<i32>(0u) {
            default: {
                let _e81 = global.member_14;
                let _e83 = global.member_43;
                let _e85 = (_e75 << bitcast<u32>(_e83));
                let _e89 = (4u * (_e81 + (_e85 >> bitcast<u32>(5u))));
                let _e90 = (2u * _e85);
                let _e93 = global_7.member[_e90];
                let _e97 = global_7.member[(_e90 + 1u)];
                let _e102 = global_7.member[((2u * _e81) + _e85)];
                let _e113 = (vec2<f32>(f32(((_e102.y >> bitcast<u32>(16u)) & 31u)), f32(((_e102.y >> bitcast<u32>(21u)) & 31u))) * vec2<f32>(0.032258064f, 0.032258064f));
                let _e117 = ((1f + (2f * _e113.x)) * 0.33333334f);
                let _e118 = (1f - _e117);
                let _e122 = (_e118 * (0.5f + (0.5f * _e113.y)));
                let _e140 = global.member_11;
                let _e143 = global.member_12;
                let _e148 = global.member_21;
                let _e149 = (2u * _e148);
                let _e153 = global_1.member[(_e149 + (_e102.x & 65535u))];
                let _e155 = unpack2x16float(_e153.x);
                let _e167 = global_1.member[(_e149 + (_e102.x >> bitcast<u32>(16u)))];
                let _e169 = unpack2x16float(_e167.x);
                let _e181 = global_1.member[(_e149 + (_e102.y & 65535u))];
                let _e183 = unpack2x16float(_e181.x);
                let _e191 = ((((_e140.xyz + (_e143.xyz * vec3<f32>(f32((_e93.x & 65535u)), f32((_e93.x >> bitcast<u32>(16u))), f32((_e93.y & 65535u))))) + (vec3<f32>(_e155.x, _e155.y, unpack2x16float(_e153.y).x) * _e117)) + (vec3<f32>(_e169.x, _e169.y, unpack2x16float(_e167.y).x) * _e122)) + (vec3<f32>(_e183.x, _e183.y, unpack2x16float(_e181.y).x) * (_e118 - _e122)));
                let _e195 = vec4<f32>(_e191.x, _e191.y, _e191.z, 1f);
                let _e208 = (((_e93.y >> bitcast<u32>(16u)) | ((_e97.y >> bitcast<u32>(24u)) << bitcast<u32>(16u))) | ((_e102.y >> bitcast<u32>(26u)) << bitcast<u32>(24u)));
                let _e220 = global.member_32;
                let _e222 = global.member_33;
                let _e225 = (vec3(_e220) + (vec3<f32>(f32((_e208 & 1023u)), f32(((_e208 >> bitcast<u32>(10u)) & 1023u)), f32((_e208 >> bitcast<u32>(20u)))) * _e222));
                let _e234 = (vec4<u32>(_e97.x, (_e97.x >> bitcast<u32>(8u)), (_e97.x >> bitcast<u32>(16u)), (_e97.x >> bitcast<u32>(24u))) & vec4<u32>(255u, 255u, 255u, 255u));
                let _e240 = (vec3<u32>(_e97.y, (_e97.y >> bitcast<u32>(8u)), (_e97.y >> bitcast<u32>(16u))) & vec3<u32>(255u, 255u, 255u));
                let _e241 = vec3<f32>(_e240);
                let _e253 = (vec4<f32>(_e241.x, _e241.y, _e241.z, f32((((255u - _e240.x) - _e240.y) - _e240.z))) * vec4<f32>(0.003921569f, 0.003921569f, 0.003921569f, 0.003921569f));
                let _e256 = (3u * _e234.x);
                let _e259 = global.member_58[_e256];
                let _e264 = global.member_58[(_e256 + 1u)];
                let _e269 = global.member_58[(_e256 + 2u)];
                let _e273 = (3u * _e234.y);
                let _e276 = global.member_58[_e273];
                let _e282 = global.member_58[(_e273 + 1u)];
                let _e288 = global.member_58[(_e273 + 2u)];
                let _e293 = (3u * _e234.z);
                let _e296 = global.member_58[_e293];
                let _e302 = global.member_58[(_e293 + 1u)];
                let _e308 = global.member_58[(_e293 + 2u)];
                let _e313 = (3u * _e234.w);
                let _e316 = global.member_58[_e313];
                let _e318 = ((((_e259 * _e253.x) + (_e276 * _e253.y)) + (_e296 * _e253.z)) + (_e316 * _e253.w));
                let _e322 = global.member_58[(_e313 + 1u)];
                let _e324 = ((((_e264 * _e253.x) + (_e282 * _e253.y)) + (_e302 * _e253.z)) + (_e322 * _e253.w));
                let _e328 = global.member_58[(_e313 + 2u)];
                let _e330 = ((((_e269 * _e253.x) + (_e288 * _e253.y)) + (_e308 * _e253.z)) + (_e328 * _e253.w));
                let _e333 = dot(_e330, _e195);
                let _e334 = vec3<f32>(dot(_e318, _e195), dot(_e324, _e195), _e333);
                let _e344 = vec3<f32>(_e318.x, _e318.y, _e318.z);
                let _e345 = vec3<f32>(_e324.x, _e324.y, _e324.z);
                let _e346 = vec3<f32>(_e330.x, _e330.y, _e330.z);
                switch bitcast<i32>(0u) {
                    default: {
                        let _e350 = global.member_6;
                        if !((_e333 >= _e350)) {
                            let _e354 = global_3.member_9;
                            if (_e354 != 0u) {
                                let _e358 = atomicAdd((&global_2.member[0u]), 1u);
                            }
                            phi_4890_ = 0f;
                            phi_4884_ = vec2<f32>(0f, 0f);
                            phi_4883_ = false;
                            break;
                        }
                        let _e360 = global.member;
                        let _e366 = global.member_1;
                        let _e367 = (((_e360 * _e334.xy) / vec2(_e333)) + _e366);
                        let _e369 = global.member_5;
                        let _e373 = all((_e367 >= vec2(-(_e369))));
                        phi_3228_ = _e373;
                        if _e373 {
                            let _e375 = global.member_4;
                            phi_3228_ = all((_e367 <= (_e375 + vec2(_e369))));
                        }
                        let _e381 = phi_3228_;
                        if !(_e381) {
                            let _e384 = global_3.member_9;
                            if (_e384 != 0u) {
                                let _e388 = atomicAdd((&global_2.member[0u]), 1u);
                            }
                            phi_4890_ = 0f;
                            phi_4884_ = _e367;
                            phi_4883_ = false;
                            break;
                        }
                        let _e390 = global.member_7;
                        let _e393 = global.member_8;
                        let _e394 = ((_e390 - _e333) * _e393);
                        if (_e394 < 0f) {
                            phi_4882_ = (0.015625f / (1f - _e394));
                        } else {
                            if (_e394 > 1f) {
                                phi_4881_ = (1f - (0.015625f / _e394));
                            } else {
                                phi_4881_ = (0.015625f + (0.96875f * clamp(_e394, 0f, 1f)));
                            }
                            let _e403 = phi_4881_;
                            phi_4882_ = _e403;
                        }
                        let _e407 = phi_4882_;
                        phi_4890_ = _e407;
                        phi_4884_ = _e367;
                        phi_4883_ = true;
                        break;
                    }
                }
                let _e409 = phi_4890_;
                let _e411 = phi_4884_;
                let _e413 = phi_4883_;
                let _e418 = global_7.member[((3u * _e81) + _e85)];
                let _e421 = (_e418.y >> bitcast<u32>(24u));
                let _e435 = ((vec3<f32>(f32((_e418.x & 1023u)), f32(((_e418.x >> bitcast<u32>(10u)) & 1023u)), f32(((_e418.x >> bitcast<u32>(20u)) & 1023u))) - vec3<f32>(512f, 512f, 512f)) * vec3<f32>(0.0013888889f, 0.0013888889f, 0.0013888889f));
                let _e439 = sqrt(max((1f - dot(_e435, _e435)), 0f));
                let _e441 = (_e418.x >> bitcast<u32>(30u));
                if (_e441 == 0u) {
                    phi_4896_ = vec4<f32>(_e439, _e435.x, _e435.y, _e435.z);
                } else {
                    if (_e441 == 1u) {
                        phi_4895_ = vec4<f32>(_e435.x, _e439, _e435.y, _e435.z);
                    } else {
                        if (_e441 == 2u) {
                            phi_4894_ = vec4<f32>(_e435.x, _e435.y, _e439, _e435.z);
                        } else {
                            phi_4894_ = vec4<f32>(_e435.x, _e435.y, _e435.z, _e439);
                        }
                        let _e454 = phi_4894_;
                        phi_4895_ = _e454;
                    }
                    let _e460 = phi_4895_;
                    phi_4896_ = _e460;
                }
                let _e466 = phi_4896_;
                let _e470 = global.member_34;
                let _e471 = (_e470 > 0u);
                phi_4908_ = unpack4x8unorm(_e418.y).xyz;
                if _e471 {
                    let _e475 = global_7.member[(_e470 + _e85)];
                    let _e477 = unpack2x16float(_e475.x);
                    phi_4908_ = vec3<f32>(_e477.x, _e477.y, unpack2x16float(_e475.y).x);
                }
                let _e485 = phi_4908_;
                let _e488 = (1u << bitcast<u32>((_e85 & 31u)));
                let _e491 = global_7.member[_e89];
                let _e495 = global_7.member[(_e89 + 1u)];
                let _e499 = global_7.member[(_e89 + 2u)];
                phi_4925_ = _e466;
                if ((_e491.x & _e488) != 0u) {
                    let _e510 = global.member_22;
                    let _e512 = global.member_18;
                    let _e516 = (_e510 + ((_e495.y + bitcast<u32>(countOneBits((_e491.x & (_e488 - 1u))))) * (1u + (4u * _e512))));
                    let _e517 = (_e516 + 1u);
                    let _e520 = global_6.member[_e516];
                    let _e522 = global.member_40;
                    let _e526 = global.member_19;
                    phi_4910_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_4909_ = 0u;
                    loop {
                        let _e530 = phi_4910_;
                        let _e532 = phi_4909_;
                        let _e534 = (2u * ((_e522 + ((_e520 >> bitcast<u32>(16u)) * _e526)) + _e532));
                        let _e537 = global_1.member[_e534];
                        let _e541 = global_1.member[(_e534 + 1u)];
                        let _e547 = bitcast<vec4<f32>>(vec4<u32>(_e537.x, _e537.y, _e541.x, _e541.y));
                        let _e551 = global_6.member[(_e517 + _e532)];
                        let _e558 = global_6.member[((_e517 + _e512) + _e532)];
                        let _e566 = global_6.member[((_e517 + (2u * _e512)) + _e532)];
                        let _e574 = global_6.member[((_e517 + (3u * _e512)) + _e532)];
                        let _e578 = (_e530 + vec4<f32>(dot(unpack4x8snorm(_e551), _e547), dot(unpack4x8snorm(_e558), _e547), dot(unpack4x8snorm(_e566), _e547), dot(unpack4x8snorm(_e574), _e547)));
                        let _e580 = (_e532 + bitcast<u32>(1i));
                        phi_4910_ = _e578;
                        phi_4909_ = _e580;
                        local = _e578;
                        if (_e580 < _e512) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e586 = local;
                    let _e588 = (_e466 + (_e586 * (127f * unpack2x16float(_e520).x)));
                    phi_4925_ = select(_e466, _e588, vec4((length(_e588) >= 0.001f)));
                }
                let _e594 = phi_4925_;
                phi_4929_ = _e225;
                if ((_e491.y & _e488) != 0u) {
                    let _e605 = global.member_23;
                    let _e607 = global.member_18;
                    let _e611 = (_e605 + ((_e499.x + bitcast<u32>(countOneBits((_e491.y & (_e488 - 1u))))) * (1u + (3u * _e607))));
                    let _e612 = (_e611 + 1u);
                    let _e615 = global_6.member[_e611];
                    let _e617 = global.member_40;
                    let _e621 = global.member_19;
                    phi_4913_ = vec3<f32>(0f, 0f, 0f);
                    phi_4912_ = 0u;
                    loop {
                        let _e625 = phi_4913_;
                        let _e627 = phi_4912_;
                        let _e629 = (2u * ((_e617 + ((_e615 >> bitcast<u32>(16u)) * _e621)) + _e627));
                        let _e632 = global_1.member[_e629];
                        let _e636 = global_1.member[(_e629 + 1u)];
                        let _e642 = bitcast<vec4<f32>>(vec4<u32>(_e632.x, _e632.y, _e636.x, _e636.y));
                        let _e646 = global_6.member[(_e612 + _e627)];
                        let _e653 = global_6.member[((_e612 + _e607) + _e627)];
                        let _e661 = global_6.member[((_e612 + (2u * _e607)) + _e627)];
                        let _e665 = (_e625 + vec3<f32>(dot(unpack4x8snorm(_e646), _e642), dot(unpack4x8snorm(_e653), _e642), dot(unpack4x8snorm(_e661), _e642)));
                        let _e667 = (_e627 + bitcast<u32>(1i));
                        phi_4913_ = _e665;
                        phi_4912_ = _e667;
                        local_1 = _e665;
                        if (_e667 < _e607) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e673 = local_1;
                    phi_4929_ = (_e225 + (_e673 * (127f * unpack2x16float(_e615).x)));
                }
                let _e677 = phi_4929_;
                phi_4931_ = _e485;
                if ((_e495.x & _e488) != 0u) {
                    let _e688 = global.member_24;
                    let _e690 = global.member_18;
                    let _e694 = (_e688 + ((_e499.y + bitcast<u32>(countOneBits((_e495.x & (_e488 - 1u))))) * (3u + (3u * _e690))));
                    let _e698 = global_6.member[(_e694 + 1u)];
                    let _e699 = unpack2x16float(_e698);
                    let _e703 = global_6.member[(_e694 + 2u)];
                    let _e711 = (_e694 + 3u);
                    let _e714 = global_6.member[_e694];
                    let _e716 = global.member_40;
                    let _e720 = global.member_19;
                    phi_4922_ = vec3<f32>(0f, 0f, 0f);
                    phi_4921_ = 0u;
                    loop {
                        let _e724 = phi_4922_;
                        let _e726 = phi_4921_;
                        let _e728 = (2u * ((_e716 + ((_e714 >> bitcast<u32>(16u)) * _e720)) + _e726));
                        let _e731 = global_1.member[_e728];
                        let _e735 = global_1.member[(_e728 + 1u)];
                        let _e741 = bitcast<vec4<f32>>(vec4<u32>(_e731.x, _e731.y, _e735.x, _e735.y));
                        let _e745 = global_6.member[(_e711 + _e726)];
                        let _e752 = global_6.member[((_e711 + _e690) + _e726)];
                        let _e760 = global_6.member[((_e711 + (2u * _e690)) + _e726)];
                        let _e764 = (_e724 + vec3<f32>(dot(unpack4x8snorm(_e745), _e741), dot(unpack4x8snorm(_e752), _e741), dot(unpack4x8snorm(_e760), _e741)));
                        let _e766 = (_e726 + bitcast<u32>(1i));
                        phi_4922_ = _e764;
                        phi_4921_ = _e766;
                        local_2 = _e764;
                        if (_e766 < _e690) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e772 = local_2;
                    phi_4931_ = (select(vec3<f32>(_e699.x, _e699.y, unpack2x16float(_e703).x), _e485, vec3(_e471)) + (_e772 * (127f * unpack2x16float(_e714).x)));
                }
                let _e776 = phi_4931_;
                let _e777 = normalize(_e594);
                let _e782 = (_e777.z * _e777.z);
                let _e783 = (_e777.w * _e777.w);
                let _e787 = (_e777.y * _e777.z);
                let _e788 = (_e777.x * _e777.w);
                let _e791 = (_e777.y * _e777.w);
                let _e792 = (_e777.x * _e777.z);
                let _e797 = (_e777.y * _e777.y);
                let _e801 = (_e777.z * _e777.w);
                let _e802 = (_e777.x * _e777.y);
                let _e816 = exp(min(_e677, vec3<f32>(9f, 9f, 9f)));
                let _e823 = mat3x3<f32>((vec3<f32>((1f - (2f * (_e782 + _e783))), (2f * (_e787 + _e788)), (2f * (_e791 - _e792))) * _e816.x), (vec3<f32>((2f * (_e787 - _e788)), (1f - (2f * (_e797 + _e783))), (2f * (_e801 + _e802))) * _e816.y), (vec3<f32>((2f * (_e791 + _e792)), (2f * (_e801 - _e802)), (1f - (2f * (_e797 + _e782)))) * _e816.z));
                let _e825 = (transpose(mat3x3<f32>(_e344, _e345, _e346)) * _e823);
                let _e827 = global.member_38;
                let _e829 = (_e827 + (3u * _e75));
                let _e830 = transpose(_e825);
                let _e839 = sqrt(max(max(dot(_e830[0], _e830[0]), dot(_e830[1], _e830[1])), dot(_e830[2], _e830[2])));
                let _e841 = global.member_39;
                let _e852 = (all((abs(_e334) < vec3<f32>(1000000000000000000000000000000f, 1000000000000000000000000000000f, 1000000000000000000000000000000f))) && (_e839 <= 1000000000000000000f));
                if _e852 {
                    let _e854 = global.member_51;
                    let _e858 = global.member_52;
                    phi_4932_ = ((_e334 - _e854.xyz) / _e858.xyz);
                } else {
                    phi_4932_ = vec3<f32>(0f, 0f, 0f);
                }
                let _e862 = phi_4932_;
                let _e879 = vec3<u32>(round((clamp(select(select((vec3<f32>(0.015625f, 0.015625f, 0.015625f) + (clamp(_e862, vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 0.96875f)), (vec3<f32>(0.015625f, 0.015625f, 0.015625f) / (vec3<f32>(1f, 1f, 1f) - min(_e862, vec3<f32>(0f, 0f, 0f)))), (_e862 < vec3<f32>(0f, 0f, 0f))), (vec3<f32>(1f, 1f, 1f) - (vec3<f32>(0.015625f, 0.015625f, 0.015625f) / max(_e862, vec3<f32>(1f, 1f, 1f)))), (_e862 > vec3<f32>(1f, 1f, 1f))), vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 16777215f)));
                let _e881 = (_e879 >> bitcast<vec3<u32>>(vec3<u32>(8u, 8u, 8u)));
                let _e882 = (_e879 & vec3<u32>(255u, 255u, 255u));
                let _e898 = ((_e881.z | (u32(clamp(select(0f, ceil(((8f * log2(max((_e839 / _e841), 0.000000000000000000000000000001f))) + 152f)), _e852), 0f, 255f)) << bitcast<u32>(16u))) | (select(0u, _e421, _e852) << bitcast<u32>(24u)));
                let _e915 = vec3<f32>(_e825[0].x, _e825[1].x, _e825[2].x);
                let _e922 = vec3<f32>(_e825[0].y, _e825[1].y, _e825[2].y);
                let _e929 = vec3<f32>(_e825[0].z, _e825[1].z, _e825[2].z);
                let _e930 = length(_e915);
                if (_e930 > 0f) {
                    phi_4934_ = (_e915 / vec3(_e930));
                } else {
                    phi_4934_ = vec3<f32>(0f, 0f, 0f);
                }
                let _e935 = phi_4934_;
                let _e936 = dot(_e922, _e935);
                let _e938 = (_e922 - (_e935 * _e936));
                let _e939 = length(_e938);
                if (_e939 > 0f) {
                    phi_4936_ = (_e938 / vec3(_e939));
                } else {
                    phi_4936_ = vec3<f32>(0f, 0f, 0f);
                }
                let _e944 = phi_4936_;
                let _e945 = dot(_e929, _e935);
                let _e946 = dot(_e929, _e944);
                let _e960 = (1023f / (_e841 * exp2(((f32(((_e898 >> bitcast<u32>(16u)) & 255u)) * 0.125f) - 19f))));
                let _e978 = vec3<u32>(round((clamp(_e776, vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 1023f)));
                let _e981 = ((vec3<u32>(clamp((round((vec3<f32>(_e930, _e939, _e946) * _e960)) + vec3<f32>(1023f, 1023f, 1023f)), vec3<f32>(0f, 0f, 0f), vec3<f32>(2046f, 2046f, 2046f))) | (vec3<u32>(clamp((round((vec3<f32>(_e936, _e945, length(((_e929 - (_e935 * _e945)) - (_e944 * _e946)))) * _e960)) + vec3<f32>(1023f, 1023f, 1023f)), vec3<f32>(0f, 0f, 0f), vec3<f32>(2046f, 2046f, 2046f))) << bitcast<vec3<u32>>(vec3<u32>(11u, 11u, 11u)))) | (_e978 << bitcast<vec3<u32>>(vec3<u32>(22u, 22u, 22u))));
                global_4.member[_e829] = (_e881.x | (_e881.y << bitcast<u32>(16u)));
                global_4.member[(_e829 + 1u)] = _e898;
                global_4.member[(_e829 + 2u)] = ((_e882.x | (_e882.y << bitcast<u32>(8u))) | (_e882.z << bitcast<u32>(16u)));
                let _e992 = (_e827 + (3u * (_e77 + _e75)));
                global_4.member[_e992] = _e981.x;
                global_4.member[(_e992 + 1u)] = _e981.y;
                global_4.member[(_e992 + 2u)] = _e981.z;
                phi_2816_ = _e413;
                if _e413 {
                    let _e1006 = global.member_29;
                    phi_2816_ = (f32(_e421) <= _e1006);
                }
                let _e1009 = phi_2816_;
                if _e1009 {
                    let _e1011 = global_3.member_9;
                    if (_e1011 != 0u) {
                        let _e1015 = atomicAdd((&global_2.member[1u]), 1u);
                    }
                }
                let _e1016 = !(_e413);
                phi_2830_ = _e1016;
                if !(_e1016) {
                    let _e1020 = global.member_29;
                    phi_2830_ = (f32(_e421) <= _e1020);
                }
                let _e1023 = phi_2830_;
                if _e1023 {
                    phi_4966_ = 4294967295u;
                    break;
                }
                switch bitcast<i32>(0u) {
                    default: {
                        let _e1029 = global.member_2;
                        let _e1031 = global.member_3;
                        let _e1032 = clamp((_e334.xy / vec2(_e333)), _e1029, _e1031);
                        let _e1035 = global.member[0u];
                        let _e1041 = (((_e344 - (_e346 * _e1032.x)) * (_e1035 / _e333)) * _e823);
                        let _e1044 = global.member[1u];
                        let _e1050 = (((_e345 - (_e346 * _e1032.y)) * (_e1044 / _e333)) * _e823);
                        let _e1052 = global.member_47;
                        let _e1054 = (dot(_e1041, _e1041) + _e1052);
                        let _e1057 = (dot(_e1050, _e1050) + _e1052);
                        let _e1059 = cross(_e1041, _e1050);
                        let _e1060 = dot(_e1059, _e1059);
                        let _e1064 = (_e1060 + (_e1052 * ((_e1054 + _e1057) - _e1052)));
                        let _e1065 = (_e1064 > 0f);
                        phi_4340_ = _e1065;
                        if _e1065 {
                            phi_4340_ = (_e1054 <= 1000000000000000000f);
                        }
                        let _e1068 = phi_4340_;
                        phi_4346_ = _e1068;
                        if _e1068 {
                            phi_4346_ = (_e1057 <= 1000000000000000000f);
                        }
                        let _e1071 = phi_4346_;
                        if !(_e1071) {
                            let _e1074 = global_3.member_9;
                            if (_e1074 != 0u) {
                                let _e1078 = atomicAdd((&global_2.member[2u]), 1u);
                            }
                            phi_4965_ = 4294967295u;
                            break;
                        }
                        phi_4951_ = (1f - (f32(_e421) * 0.003921569f));
                        phi_4950_ = 0u;
                        loop {
                            let _e1083 = phi_4951_;
                            let _e1085 = phi_4950_;
                            local_3 = _e1083;
                            if (_e1085 < _e83) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                phi_4951_ = (_e1083 * _e1083);
                                phi_4950_ = (_e1085 + bitcast<u32>(1i));
                            }
                        }
                        let _e1091 = local_3;
                        let _e1095 = u32(round((255f * (1f - _e1091))));
                        let _e1097 = global.member_48;
                        phi_4959_ = _e1095;
                        if (_e1097 > 0f) {
                            let _e1107 = u32(round((f32(_e1095) * ((1f - _e1097) + (_e1097 * sqrt((_e1060 / _e1064)))))));
                            let _e1110 = global.member_29;
                            if (f32(_e1107) <= _e1110) {
                                let _e1113 = global_3.member_9;
                                if (_e1113 != 0u) {
                                    let _e1117 = atomicAdd((&global_2.member[1u]), 1u);
                                }
                                phi_4965_ = 4294967295u;
                                break;
                            }
                            phi_4959_ = _e1107;
                        }
                        let _e1119 = phi_4959_;
                        let _e1121 = global.member_45;
                        let _e1122 = (vec3<f32>(_e1054, dot(_e1041, _e1050), _e1057) * _e1121);
                        let _e1127 = global.member_29;
                        let _e1137 = global.member_49;
                        let _e1138 = ((sqrt(_e1122.xz) * sqrt((2f * log(max((f32(_e1119) / _e1127), 1f))))) * _e1137);
                        let _e1141 = global.member_50;
                        let _e1144 = all(((_e411 + _e1138) > _e1141.xy));
                        phi_4424_ = _e1144;
                        if _e1144 {
                            phi_4424_ = all(((_e411 - _e1138) < _e1141.zw));
                        }
                        let _e1150 = phi_4424_;
                        if !(_e1150) {
                            let _e1153 = global_3.member_9;
                            if (_e1153 != 0u) {
                                let _e1157 = atomicAdd((&global_2.member[0u]), 1u);
                            }
                            phi_4965_ = 4294967295u;
                            break;
                        }
                        let _e1161 = (0.5f * (_e1122.x - _e1122.z));
                        let _e1166 = sqrt(((_e1161 * _e1161) + (_e1122.y * _e1122.y)));
                        let _e1169 = ((0.5f * (_e1122.x + _e1122.z)) + _e1166);
                        if (_e1161 >= 0f) {
                            phi_4963_ = vec2<f32>((_e1161 + _e1166), _e1122.y);
                        } else {
                            phi_4963_ = vec2<f32>(_e1122.y, (_e1166 - _e1161));
                        }
                        let _e1176 = phi_4963_;
                        if (_e1166 > (0.00000001f * _e1169)) {
                            phi_4964_ = normalize(_e1176);
                        } else {
                            phi_4964_ = vec2<f32>(1f, 0f);
                        }
                        let _e1181 = phi_4964_;
                        let _e1188 = global.member_5;
                        let _e1192 = global.member_10;
                        let _e1196 = vec2<u32>(clamp(round(((_e411 + vec2(_e1188)) * _e1192)), vec2<f32>(0f, 0f), vec2<f32>(1048575f, 1048575f)));
                        let _e1224 = global.member_41;
                        let _e1226 = (4u * (_e1224 + _e75));
                        global_4.member[_e1226] = ((_e1196.x | (_e978.x << bitcast<u32>(20u))) | (_e978.z << bitcast<u32>(30u)));
                        global_4.member[(_e1226 + 1u)] = (_e1196.y | (_e978.y << bitcast<u32>(20u)));
                        global_4.member[(_e1226 + 2u)] = pack2x16float((_e1181 * min(sqrt(_e1169), 65504f)));
                        global_4.member[(_e1226 + 3u)] = ((pack2x16float(vec2<f32>(min(sqrt(((_e1064 * (_e1121 * _e1121)) / _e1169)), 65504f), 0f)) | (_e1119 << bitcast<u32>(16u))) | ((_e978.z >> bitcast<u32>(2u)) << bitcast<u32>(24u)));
                        let _e1239 = global.member_9;
                        phi_4965_ = min(u32((_e409 * f32(_e1239))), _e1239);
                        break;
                    }
                }
                let _e1245 = phi_4965_;
                phi_4966_ = _e1245;
                break;
            }
        }
        let _e1247 = phi_4966_;
        phi_4967_ = _e1247;
    } else {
        phi_4967_ = 4294967295u;
    }
    let _e1249 = phi_4967_;
    switch bitcast<i32>(0u) {
        default: {
            let _e1252 = bitcast<u32>(param[0u]);
            let _e1254 = global.member_41;
            let _e1255 = (_e1254 + _e75);
            if (_e1249 != 4294967295u) {
                let _e1258 = global.member_37;
                let _e1262 = global.member_36;
                let _e1268 = atomicAdd((&global_2.member[((_e1262 + ((_e1255 / _e1258) * 256u)) + (_e1249 & 255u))]), 1u);
            }
            let _e1270 = global.member_35;
            if (_e1270 == 0u) {
                if (_e75 < (_e77 + (_e77 & 1u))) {
                    let _e1276 = global.member_28;
                    global_4.member[(_e1276 + _e1255)] = _e1249;
                }
                break;
            }
            global_5[_e1252] = _e1249;
            workgroupBarrier();
            let _e1282 = ((_e1252 & 1u) == 0u);
            if select(_e1282, _e78, _e1282) {
                let _e1285 = global.member_28;
                let _e1292 = global_5[(_e1252 + 1u)];
                global_4.member[(_e1285 + (_e1255 >> bitcast<u32>(1u)))] = ((_e1249 & 65535u) | (_e1292 << bitcast<u32>(16u)));
            }
            break;
        }
    }
    return;
}
