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
    var phi_4526_: u32;
    var phi_4525_: bool;
    var phi_2792_: bool;
    var local: bool;
    var phi_3194_: bool;
    var phi_4528_: f32;
    var phi_4529_: f32;
    var phi_4537_: f32;
    var phi_4531_: vec2<f32>;
    var phi_4530_: bool;
    var phi_4541_: vec4<f32>;
    var phi_4542_: vec4<f32>;
    var phi_4543_: vec4<f32>;
    var phi_4555_: vec3<f32>;
    var phi_4557_: vec4<f32>;
    var phi_4556_: u32;
    var local_1: vec4<f32>;
    var phi_4572_: vec4<f32>;
    var phi_4560_: vec3<f32>;
    var phi_4559_: u32;
    var local_2: vec3<f32>;
    var phi_4576_: vec3<f32>;
    var phi_4569_: vec3<f32>;
    var phi_4568_: u32;
    var local_3: vec3<f32>;
    var phi_4578_: vec3<f32>;
    var phi_4012_: bool;
    var phi_4018_: bool;
    var phi_4583_: f32;
    var phi_4582_: u32;
    var local_4: f32;
    var phi_4591_: u32;
    var phi_4096_: bool;
    var phi_4595_: vec2<f32>;
    var phi_4596_: vec2<f32>;
    var phi_4597_: u32;
    var phi_4598_: u32;
    var phi_4599_: u32;

    let _e63 = bitcast<u32>(param_1[0u]);
    let _e65 = global.member_44;
    let _e66 = (_e63 < _e65);
    if _e66 {
        switch bitcast<i32>(0u) {
            default: {
                let _e69 = global.member_14;
                let _e71 = global.member_43;
                let _e73 = (_e63 << bitcast<u32>(_e71));
                let _e77 = (4u * (_e69 + (_e73 >> bitcast<u32>(5u))));
                let _e82 = global_7.member[(_e77 + 3u)][0u];
                phi_4526_ = (_e82 & 65535u);
                phi_4525_ = true;
                loop {
                    let _e85 = phi_4526_;
                    let _e87 = phi_4525_;
                    local = _e87;
                    phi_2792_ = _e87;
                    if _e87 {
                        phi_2792_ = (_e85 <= (_e82 >> bitcast<u32>(16u)));
                    }
                    let _e92 = phi_2792_;
                    if _e92 {
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e101 = global.member_55[(_e85 >> bitcast<u32>(7u))][((_e85 >> bitcast<u32>(5u)) & 3u)];
                        phi_4526_ = (_e85 + bitcast<u32>(1i));
                        phi_4525_ = (((_e101 >> bitcast<u32>((_e85 & 31u))) & 1u) != 0u);
                    }
                }
                let _e110 = local;
                if _e110 {
                    let _e112 = global_3.member_9;
                    if (_e112 != 0u) {
                        let _e116 = atomicAdd((&global_2.member[0u]), 1u);
                    }
                    phi_4598_ = 4294967295u;
                    break;
                }
                let _e117 = (2u * _e73);
                let _e120 = global_7.member[_e117];
                let _e124 = global_7.member[(_e117 + 1u)];
                let _e129 = global_7.member[((2u * _e69) + _e73)];
                let _e140 = (vec2<f32>(f32(((_e129.y >> bitcast<u32>(16u)) & 31u)), f32(((_e129.y >> bitcast<u32>(21u)) & 31u))) * vec2<f32>(0.032258064f, 0.032258064f));
                let _e144 = ((1f + (2f * _e140.x)) * 0.33333334f);
                let _e145 = (1f - _e144);
                let _e149 = (_e145 * (0.5f + (0.5f * _e140.y)));
                let _e167 = global.member_11;
                let _e170 = global.member_12;
                let _e175 = global.member_21;
                let _e176 = (2u * _e175);
                let _e180 = global_1.member[(_e176 + (_e129.x & 65535u))];
                let _e182 = unpack2x16float(_e180.x);
                let _e194 = global_1.member[(_e176 + (_e129.x >> bitcast<u32>(16u)))];
                let _e196 = unpack2x16float(_e194.x);
                let _e208 = global_1.member[(_e176 + (_e129.y & 65535u))];
                let _e210 = unpack2x16float(_e208.x);
                let _e218 = ((((_e167.xyz + (_e170.xyz * vec3<f32>(f32((_e120.x & 65535u)), f32((_e120.x >> bitcast<u32>(16u))), f32((_e120.y & 65535u))))) + (vec3<f32>(_e182.x, _e182.y, unpack2x16float(_e180.y).x) * _e144)) + (vec3<f32>(_e196.x, _e196.y, unpack2x16float(_e194.y).x) * _e149)) + (vec3<f32>(_e210.x, _e210.y, unpack2x16float(_e208.y).x) * (_e145 - _e149)));
                let _e222 = vec4<f32>(_e218.x, _e218.y, _e218.z, 1f);
                let _e235 = (((_e120.y >> bitcast<u32>(16u)) | ((_e124.y >> bitcast<u32>(24u)) << bitcast<u32>(16u))) | ((_e129.y >> bitcast<u32>(26u)) << bitcast<u32>(24u)));
                let _e247 = global.member_32;
                let _e249 = global.member_33;
                let _e252 = (vec3(_e247) + (vec3<f32>(f32((_e235 & 1023u)), f32(((_e235 >> bitcast<u32>(10u)) & 1023u)), f32((_e235 >> bitcast<u32>(20u)))) * _e249));
                let _e261 = (vec4<u32>(_e124.x, (_e124.x >> bitcast<u32>(8u)), (_e124.x >> bitcast<u32>(16u)), (_e124.x >> bitcast<u32>(24u))) & vec4<u32>(255u, 255u, 255u, 255u));
                let _e267 = (vec3<u32>(_e124.y, (_e124.y >> bitcast<u32>(8u)), (_e124.y >> bitcast<u32>(16u))) & vec3<u32>(255u, 255u, 255u));
                let _e268 = vec3<f32>(_e267);
                let _e280 = (vec4<f32>(_e268.x, _e268.y, _e268.z, f32((((255u - _e267.x) - _e267.y) - _e267.z))) * vec4<f32>(0.003921569f, 0.003921569f, 0.003921569f, 0.003921569f));
                let _e283 = (3u * _e261.x);
                let _e286 = global.member_58[_e283];
                let _e291 = global.member_58[(_e283 + 1u)];
                let _e296 = global.member_58[(_e283 + 2u)];
                let _e300 = (3u * _e261.y);
                let _e303 = global.member_58[_e300];
                let _e309 = global.member_58[(_e300 + 1u)];
                let _e315 = global.member_58[(_e300 + 2u)];
                let _e320 = (3u * _e261.z);
                let _e323 = global.member_58[_e320];
                let _e329 = global.member_58[(_e320 + 1u)];
                let _e335 = global.member_58[(_e320 + 2u)];
                let _e340 = (3u * _e261.w);
                let _e343 = global.member_58[_e340];
                let _e345 = ((((_e286 * _e280.x) + (_e303 * _e280.y)) + (_e323 * _e280.z)) + (_e343 * _e280.w));
                let _e349 = global.member_58[(_e340 + 1u)];
                let _e351 = ((((_e291 * _e280.x) + (_e309 * _e280.y)) + (_e329 * _e280.z)) + (_e349 * _e280.w));
                let _e355 = global.member_58[(_e340 + 2u)];
                let _e357 = ((((_e296 * _e280.x) + (_e315 * _e280.y)) + (_e335 * _e280.z)) + (_e355 * _e280.w));
                let _e360 = dot(_e357, _e222);
                let _e361 = vec3<f32>(dot(_e345, _e222), dot(_e351, _e222), _e360);
                let _e373 = vec3<f32>(_e357.x, _e357.y, _e357.z);
                switch bitcast<i32>(0u) {
                    default: {
                        let _e376 = global.member_6;
                        if !((_e360 >= _e376)) {
                            let _e380 = global_3.member_9;
                            if (_e380 != 0u) {
                                let _e384 = atomicAdd((&global_2.member[0u]), 1u);
                            }
                            phi_4537_ = 0f;
                            phi_4531_ = vec2<f32>(0f, 0f);
                            phi_4530_ = false;
                            break;
                        }
                        let _e386 = global.member;
                        let _e392 = global.member_1;
                        let _e393 = (((_e386 * _e361.xy) / vec2(_e360)) + _e392);
                        let _e395 = global.member_5;
                        let _e399 = all((_e393 >= vec2(-(_e395))));
                        phi_3194_ = _e399;
                        if _e399 {
                            let _e401 = global.member_4;
                            phi_3194_ = all((_e393 <= (_e401 + vec2(_e395))));
                        }
                        let _e407 = phi_3194_;
                        if !(_e407) {
                            let _e410 = global_3.member_9;
                            if (_e410 != 0u) {
                                let _e414 = atomicAdd((&global_2.member[0u]), 1u);
                            }
                            phi_4537_ = 0f;
                            phi_4531_ = _e393;
                            phi_4530_ = false;
                            break;
                        }
                        let _e416 = global.member_7;
                        let _e419 = global.member_8;
                        let _e420 = ((_e416 - _e360) * _e419);
                        if (_e420 < 0f) {
                            phi_4529_ = (0.015625f / (1f - _e420));
                        } else {
                            if (_e420 > 1f) {
                                phi_4528_ = (1f - (0.015625f / _e420));
                            } else {
                                phi_4528_ = (0.015625f + (0.96875f * clamp(_e420, 0f, 1f)));
                            }
                            let _e429 = phi_4528_;
                            phi_4529_ = _e429;
                        }
                        let _e433 = phi_4529_;
                        phi_4537_ = _e433;
                        phi_4531_ = _e393;
                        phi_4530_ = true;
                        break;
                    }
                }
                let _e435 = phi_4537_;
                let _e437 = phi_4531_;
                let _e439 = phi_4530_;
                if (true && !(_e439)) {
                    phi_4598_ = 4294967295u;
                    break;
                }
                let _e446 = global_7.member[((3u * _e69) + _e73)];
                let _e450 = f32((_e446.y >> bitcast<u32>(24u)));
                let _e452 = global.member_29;
                if (_e450 <= _e452) {
                    let _e455 = global_3.member_9;
                    if (_e455 != 0u) {
                        let _e459 = atomicAdd((&global_2.member[1u]), 1u);
                    }
                    phi_4598_ = 4294967295u;
                    break;
                }
                let _e473 = ((vec3<f32>(f32((_e446.x & 1023u)), f32(((_e446.x >> bitcast<u32>(10u)) & 1023u)), f32(((_e446.x >> bitcast<u32>(20u)) & 1023u))) - vec3<f32>(512f, 512f, 512f)) * vec3<f32>(0.0013888889f, 0.0013888889f, 0.0013888889f));
                let _e477 = sqrt(max((1f - dot(_e473, _e473)), 0f));
                let _e479 = (_e446.x >> bitcast<u32>(30u));
                if (_e479 == 0u) {
                    phi_4543_ = vec4<f32>(_e477, _e473.x, _e473.y, _e473.z);
                } else {
                    if (_e479 == 1u) {
                        phi_4542_ = vec4<f32>(_e473.x, _e477, _e473.y, _e473.z);
                    } else {
                        if (_e479 == 2u) {
                            phi_4541_ = vec4<f32>(_e473.x, _e473.y, _e477, _e473.z);
                        } else {
                            phi_4541_ = vec4<f32>(_e473.x, _e473.y, _e473.z, _e477);
                        }
                        let _e492 = phi_4541_;
                        phi_4542_ = _e492;
                    }
                    let _e498 = phi_4542_;
                    phi_4543_ = _e498;
                }
                let _e504 = phi_4543_;
                let _e508 = global.member_34;
                let _e509 = (_e508 > 0u);
                phi_4555_ = unpack4x8unorm(_e446.y).xyz;
                if _e509 {
                    let _e513 = global_7.member[(_e508 + _e73)];
                    let _e515 = unpack2x16float(_e513.x);
                    phi_4555_ = vec3<f32>(_e515.x, _e515.y, unpack2x16float(_e513.y).x);
                }
                let _e523 = phi_4555_;
                let _e526 = (1u << bitcast<u32>((_e73 & 31u)));
                let _e529 = global_7.member[_e77];
                let _e533 = global_7.member[(_e77 + 1u)];
                let _e537 = global_7.member[(_e77 + 2u)];
                phi_4572_ = _e504;
                if ((_e529.x & _e526) != 0u) {
                    let _e548 = global.member_22;
                    let _e550 = global.member_18;
                    let _e554 = (_e548 + ((_e533.y + bitcast<u32>(countOneBits((_e529.x & (_e526 - 1u))))) * (1u + (4u * _e550))));
                    let _e555 = (_e554 + 1u);
                    let _e558 = global_6.member[_e554];
                    let _e560 = global.member_40;
                    let _e564 = global.member_19;
                    phi_4557_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_4556_ = 0u;
                    loop {
                        let _e568 = phi_4557_;
                        let _e570 = phi_4556_;
                        let _e572 = (2u * ((_e560 + ((_e558 >> bitcast<u32>(16u)) * _e564)) + _e570));
                        let _e575 = global_1.member[_e572];
                        let _e579 = global_1.member[(_e572 + 1u)];
                        let _e585 = bitcast<vec4<f32>>(vec4<u32>(_e575.x, _e575.y, _e579.x, _e579.y));
                        let _e589 = global_6.member[(_e555 + _e570)];
                        let _e596 = global_6.member[((_e555 + _e550) + _e570)];
                        let _e604 = global_6.member[((_e555 + (2u * _e550)) + _e570)];
                        let _e612 = global_6.member[((_e555 + (3u * _e550)) + _e570)];
                        let _e616 = (_e568 + vec4<f32>(dot(unpack4x8snorm(_e589), _e585), dot(unpack4x8snorm(_e596), _e585), dot(unpack4x8snorm(_e604), _e585), dot(unpack4x8snorm(_e612), _e585)));
                        let _e618 = (_e570 + bitcast<u32>(1i));
                        phi_4557_ = _e616;
                        phi_4556_ = _e618;
                        local_1 = _e616;
                        if (_e618 < _e550) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e624 = local_1;
                    let _e626 = (_e504 + (_e624 * (127f * unpack2x16float(_e558).x)));
                    phi_4572_ = select(_e504, _e626, vec4((length(_e626) >= 0.001f)));
                }
                let _e632 = phi_4572_;
                phi_4576_ = _e252;
                if ((_e529.y & _e526) != 0u) {
                    let _e643 = global.member_23;
                    let _e645 = global.member_18;
                    let _e649 = (_e643 + ((_e537.x + bitcast<u32>(countOneBits((_e529.y & (_e526 - 1u))))) * (1u + (3u * _e645))));
                    let _e650 = (_e649 + 1u);
                    let _e653 = global_6.member[_e649];
                    let _e655 = global.member_40;
                    let _e659 = global.member_19;
                    phi_4560_ = vec3<f32>(0f, 0f, 0f);
                    phi_4559_ = 0u;
                    loop {
                        let _e663 = phi_4560_;
                        let _e665 = phi_4559_;
                        let _e667 = (2u * ((_e655 + ((_e653 >> bitcast<u32>(16u)) * _e659)) + _e665));
                        let _e670 = global_1.member[_e667];
                        let _e674 = global_1.member[(_e667 + 1u)];
                        let _e680 = bitcast<vec4<f32>>(vec4<u32>(_e670.x, _e670.y, _e674.x, _e674.y));
                        let _e684 = global_6.member[(_e650 + _e665)];
                        let _e691 = global_6.member[((_e650 + _e645) + _e665)];
                        let _e699 = global_6.member[((_e650 + (2u * _e645)) + _e665)];
                        let _e703 = (_e663 + vec3<f32>(dot(unpack4x8snorm(_e684), _e680), dot(unpack4x8snorm(_e691), _e680), dot(unpack4x8snorm(_e699), _e680)));
                        let _e705 = (_e665 + bitcast<u32>(1i));
                        phi_4560_ = _e703;
                        phi_4559_ = _e705;
                        local_2 = _e703;
                        if (_e705 < _e645) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e711 = local_2;
                    phi_4576_ = (_e252 + (_e711 * (127f * unpack2x16float(_e653).x)));
                }
                let _e715 = phi_4576_;
                phi_4578_ = _e523;
                if ((_e533.x & _e526) != 0u) {
                    let _e726 = global.member_24;
                    let _e728 = global.member_18;
                    let _e732 = (_e726 + ((_e537.y + bitcast<u32>(countOneBits((_e533.x & (_e526 - 1u))))) * (3u + (3u * _e728))));
                    let _e736 = global_6.member[(_e732 + 1u)];
                    let _e737 = unpack2x16float(_e736);
                    let _e741 = global_6.member[(_e732 + 2u)];
                    let _e749 = (_e732 + 3u);
                    let _e752 = global_6.member[_e732];
                    let _e754 = global.member_40;
                    let _e758 = global.member_19;
                    phi_4569_ = vec3<f32>(0f, 0f, 0f);
                    phi_4568_ = 0u;
                    loop {
                        let _e762 = phi_4569_;
                        let _e764 = phi_4568_;
                        let _e766 = (2u * ((_e754 + ((_e752 >> bitcast<u32>(16u)) * _e758)) + _e764));
                        let _e769 = global_1.member[_e766];
                        let _e773 = global_1.member[(_e766 + 1u)];
                        let _e779 = bitcast<vec4<f32>>(vec4<u32>(_e769.x, _e769.y, _e773.x, _e773.y));
                        let _e783 = global_6.member[(_e749 + _e764)];
                        let _e790 = global_6.member[((_e749 + _e728) + _e764)];
                        let _e798 = global_6.member[((_e749 + (2u * _e728)) + _e764)];
                        let _e802 = (_e762 + vec3<f32>(dot(unpack4x8snorm(_e783), _e779), dot(unpack4x8snorm(_e790), _e779), dot(unpack4x8snorm(_e798), _e779)));
                        let _e804 = (_e764 + bitcast<u32>(1i));
                        phi_4569_ = _e802;
                        phi_4568_ = _e804;
                        local_3 = _e802;
                        if (_e804 < _e728) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e810 = local_3;
                    phi_4578_ = (select(vec3<f32>(_e737.x, _e737.y, unpack2x16float(_e741).x), _e523, vec3(_e509)) + (_e810 * (127f * unpack2x16float(_e752).x)));
                }
                let _e814 = phi_4578_;
                let _e815 = normalize(_e632);
                let _e820 = (_e815.z * _e815.z);
                let _e821 = (_e815.w * _e815.w);
                let _e825 = (_e815.y * _e815.z);
                let _e826 = (_e815.x * _e815.w);
                let _e829 = (_e815.y * _e815.w);
                let _e830 = (_e815.x * _e815.z);
                let _e835 = (_e815.y * _e815.y);
                let _e839 = (_e815.z * _e815.w);
                let _e840 = (_e815.x * _e815.y);
                let _e854 = exp(min(_e715, vec3<f32>(9f, 9f, 9f)));
                let _e861 = mat3x3<f32>((vec3<f32>((1f - (2f * (_e820 + _e821))), (2f * (_e825 + _e826)), (2f * (_e829 - _e830))) * _e854.x), (vec3<f32>((2f * (_e825 - _e826)), (1f - (2f * (_e835 + _e821))), (2f * (_e839 + _e840))) * _e854.y), (vec3<f32>((2f * (_e829 + _e830)), (2f * (_e839 - _e840)), (1f - (2f * (_e835 + _e820)))) * _e854.z));
                switch bitcast<i32>(0u) {
                    default: {
                        let _e867 = global.member_2;
                        let _e869 = global.member_3;
                        let _e870 = clamp((_e361.xy / vec2(_e360)), _e867, _e869);
                        let _e873 = global.member[0u];
                        let _e879 = (((vec3<f32>(_e345.x, _e345.y, _e345.z) - (_e373 * _e870.x)) * (_e873 / _e360)) * _e861);
                        let _e882 = global.member[1u];
                        let _e888 = (((vec3<f32>(_e351.x, _e351.y, _e351.z) - (_e373 * _e870.y)) * (_e882 / _e360)) * _e861);
                        let _e890 = global.member_47;
                        let _e892 = (dot(_e879, _e879) + _e890);
                        let _e895 = (dot(_e888, _e888) + _e890);
                        let _e897 = cross(_e879, _e888);
                        let _e898 = dot(_e897, _e897);
                        let _e902 = (_e898 + (_e890 * ((_e892 + _e895) - _e890)));
                        let _e903 = (_e902 > 0f);
                        phi_4012_ = _e903;
                        if _e903 {
                            phi_4012_ = (_e892 <= 1000000000000000000f);
                        }
                        let _e906 = phi_4012_;
                        phi_4018_ = _e906;
                        if _e906 {
                            phi_4018_ = (_e895 <= 1000000000000000000f);
                        }
                        let _e909 = phi_4018_;
                        if !(_e909) {
                            let _e912 = global_3.member_9;
                            if (_e912 != 0u) {
                                let _e916 = atomicAdd((&global_2.member[2u]), 1u);
                            }
                            phi_4597_ = 4294967295u;
                            break;
                        }
                        phi_4583_ = (1f - (_e450 * 0.003921569f));
                        phi_4582_ = 0u;
                        loop {
                            let _e920 = phi_4583_;
                            let _e922 = phi_4582_;
                            local_4 = _e920;
                            if (_e922 < _e71) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                phi_4583_ = (_e920 * _e920);
                                phi_4582_ = (_e922 + bitcast<u32>(1i));
                            }
                        }
                        let _e928 = local_4;
                        let _e932 = u32(round((255f * (1f - _e928))));
                        let _e934 = global.member_48;
                        phi_4591_ = _e932;
                        if (_e934 > 0f) {
                            let _e944 = u32(round((f32(_e932) * ((1f - _e934) + (_e934 * sqrt((_e898 / _e902)))))));
                            if (f32(_e944) <= _e452) {
                                let _e948 = global_3.member_9;
                                if (_e948 != 0u) {
                                    let _e952 = atomicAdd((&global_2.member[1u]), 1u);
                                }
                                phi_4597_ = 4294967295u;
                                break;
                            }
                            phi_4591_ = _e944;
                        }
                        let _e954 = phi_4591_;
                        let _e956 = global.member_45;
                        let _e957 = (vec3<f32>(_e892, dot(_e879, _e888), _e895) * _e956);
                        let _e970 = global.member_49;
                        let _e971 = ((sqrt(_e957.xz) * sqrt((2f * log(max((f32(_e954) / _e452), 1f))))) * _e970);
                        let _e974 = global.member_50;
                        let _e977 = all(((_e437 + _e971) > _e974.xy));
                        phi_4096_ = _e977;
                        if _e977 {
                            phi_4096_ = all(((_e437 - _e971) < _e974.zw));
                        }
                        let _e983 = phi_4096_;
                        if !(_e983) {
                            let _e986 = global_3.member_9;
                            if (_e986 != 0u) {
                                let _e990 = atomicAdd((&global_2.member[0u]), 1u);
                            }
                            phi_4597_ = 4294967295u;
                            break;
                        }
                        let _e995 = (0.5f * (_e957.x - _e957.z));
                        let _e1000 = sqrt(((_e995 * _e995) + (_e957.y * _e957.y)));
                        let _e1003 = ((0.5f * (_e957.x + _e957.z)) + _e1000);
                        if (_e995 >= 0f) {
                            phi_4595_ = vec2<f32>((_e995 + _e1000), _e957.y);
                        } else {
                            phi_4595_ = vec2<f32>(_e957.y, (_e1000 - _e995));
                        }
                        let _e1010 = phi_4595_;
                        if (_e1000 > (0.00000001f * _e1003)) {
                            phi_4596_ = normalize(_e1010);
                        } else {
                            phi_4596_ = vec2<f32>(1f, 0f);
                        }
                        let _e1015 = phi_4596_;
                        let _e1022 = global.member_5;
                        let _e1026 = global.member_10;
                        let _e1030 = vec2<u32>(clamp(round(((_e437 + vec2(_e1022)) * _e1026)), vec2<f32>(0f, 0f), vec2<f32>(1048575f, 1048575f)));
                        let _e1033 = vec3<u32>(round((clamp(_e814, vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 1023f)));
                        let _e1061 = global.member_41;
                        let _e1063 = (4u * (_e1061 + _e63));
                        global_4.member[_e1063] = ((_e1030.x | (_e1033.x << bitcast<u32>(20u))) | (_e1033.z << bitcast<u32>(30u)));
                        global_4.member[(_e1063 + 1u)] = (_e1030.y | (_e1033.y << bitcast<u32>(20u)));
                        global_4.member[(_e1063 + 2u)] = pack2x16float((_e1015 * min(sqrt(_e1003), 65504f)));
                        global_4.member[(_e1063 + 3u)] = ((pack2x16float(vec2<f32>(min(sqrt(((_e902 * (_e956 * _e956)) / _e1003)), 65504f), 0f)) | (_e954 << bitcast<u32>(16u))) | ((_e1033.z >> bitcast<u32>(2u)) << bitcast<u32>(24u)));
                        let _e1076 = global.member_9;
                        phi_4597_ = min(u32((_e435 * f32(_e1076))), _e1076);
                        break;
                    }
                }
                let _e1082 = phi_4597_;
                phi_4598_ = _e1082;
                break;
            }
        }
        let _e1084 = phi_4598_;
        phi_4599_ = _e1084;
    } else {
        phi_4599_ = 4294967295u;
    }
    let _e1086 = phi_4599_;
    switch bitcast<i32>(0u) {
        default: {
            let _e1089 = bitcast<u32>(param[0u]);
            let _e1091 = global.member_41;
            let _e1092 = (_e1091 + _e63);
            if (_e1086 != 4294967295u) {
                let _e1095 = global.member_37;
                let _e1099 = global.member_36;
                let _e1105 = atomicAdd((&global_2.member[((_e1099 + ((_e1092 / _e1095) * 256u)) + (_e1086 & 255u))]), 1u);
            }
            let _e1107 = global.member_35;
            if (_e1107 == 0u) {
                if (_e63 < (_e65 + (_e65 & 1u))) {
                    let _e1113 = global.member_28;
                    global_4.member[(_e1113 + _e1092)] = _e1086;
                }
                break;
            }
            global_5[_e1089] = _e1086;
            workgroupBarrier();
            let _e1119 = ((_e1089 & 1u) == 0u);
            if select(_e1119, _e66, _e1119) {
                let _e1122 = global.member_28;
                let _e1129 = global_5[(_e1089 + 1u)];
                global_4.member[(_e1122 + (_e1092 >> bitcast<u32>(1u)))] = ((_e1086 & 65535u) | (_e1129 << bitcast<u32>(16u)));
            }
            break;
        }
    }
    return;
}
