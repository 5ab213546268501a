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
    var phi_4639_: u32;
    var phi_4638_: bool;
    var phi_2845_: bool;
    var local: bool;
    var phi_3305_: bool;
    var phi_4641_: f32;
    var phi_4642_: f32;
    var phi_4650_: f32;
    var phi_4644_: vec2<f32>;
    var phi_4643_: bool;
    var phi_4654_: vec4<f32>;
    var phi_4655_: vec4<f32>;
    var phi_4656_: vec4<f32>;
    var phi_4668_: vec3<f32>;
    var phi_4670_: vec4<f32>;
    var phi_4669_: u32;
    var local_1: vec4<f32>;
    var phi_4685_: vec4<f32>;
    var phi_4673_: vec3<f32>;
    var phi_4672_: u32;
    var local_2: vec3<f32>;
    var phi_4689_: vec3<f32>;
    var phi_4682_: vec3<f32>;
    var phi_4681_: u32;
    var local_3: vec3<f32>;
    var phi_4691_: vec3<f32>;
    var phi_4123_: bool;
    var phi_4129_: bool;
    var phi_4696_: f32;
    var phi_4695_: u32;
    var local_4: f32;
    var phi_4704_: u32;
    var phi_4207_: bool;
    var phi_4708_: vec2<f32>;
    var phi_4709_: vec2<f32>;
    var phi_4710_: u32;
    var phi_4711_: u32;
    var phi_4712_: u32;

    let _e66 = bitcast<u32>(param_1[0u]);
    let _e68 = global.member_44;
    let _e69 = (_e66 < _e68);
    if _e69 {
        switch bitcast<i32>(0u) {
            default: {
                let _e72 = global.member_14;
                let _e74 = global.member_43;
                let _e76 = (_e66 << bitcast<u32>(_e74));
                let _e80 = (4u * (_e72 + (_e76 >> bitcast<u32>(5u))));
                let _e85 = global_7.member[(_e80 + 3u)][0u];
                phi_4639_ = (_e85 & 65535u);
                phi_4638_ = true;
                loop {
                    let _e88 = phi_4639_;
                    let _e90 = phi_4638_;
                    local = _e90;
                    phi_2845_ = _e90;
                    if _e90 {
                        phi_2845_ = (_e88 <= (_e85 >> bitcast<u32>(16u)));
                    }
                    let _e95 = phi_2845_;
                    if _e95 {
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e104 = global.member_55[(_e88 >> bitcast<u32>(7u))][((_e88 >> bitcast<u32>(5u)) & 3u)];
                        phi_4639_ = (_e88 + bitcast<u32>(1i));
                        phi_4638_ = (((_e104 >> bitcast<u32>((_e88 & 31u))) & 1u) != 0u);
                    }
                }
                let _e113 = local;
                if _e113 {
                    let _e115 = global_3.member_9;
                    if (_e115 != 0u) {
                        let _e119 = atomicAdd((&global_2.member[0u]), 1u);
                    }
                    phi_4711_ = 4294967295u;
                    break;
                }
                let _e120 = (2u * _e76);
                let _e123 = global_7.member[_e120];
                let _e127 = global_7.member[(_e120 + 1u)];
                let _e132 = global_7.member[((2u * _e72) + _e76)];
                let _e134 = global.member_15;
                let _e138 = bitcast<u32>(firstLeadingBit((max(_e134, 4096u) - 1u)));
                let _e139 = (_e138 + 1u);
                let _e140 = (15u - _e138);
                let _e154 = (vec2<u32>((32u << bitcast<u32>((2u * _e140))), (32u << bitcast<u32>(_e140))) - vec2<u32>(1u, 1u));
                let _e170 = (vec2<f32>(vec2<u32>(((((_e132.x >> bitcast<u32>(16u)) >> bitcast<u32>(((2u * _e139) - 16u))) << bitcast<u32>(5u)) | ((_e132.y >> bitcast<u32>(_e139)) & 31u)), ((_e132.y >> bitcast<u32>((_e138 + 6u))) & _e154.y))) / vec2<f32>(_e154));
                let _e174 = ((1f + (2f * _e170.x)) * 0.33333334f);
                let _e175 = (1f - _e174);
                let _e179 = (_e175 * (0.5f + (0.5f * _e170.y)));
                let _e188 = (vec3<u32>(_e132.x, (_e132.x >> bitcast<u32>(_e139)), _e132.y) & vec3(((1u << bitcast<u32>(_e139)) - 1u)));
                let _e200 = global.member_11;
                let _e203 = global.member_12;
                let _e209 = global.member_21;
                let _e210 = (2u * _e209);
                let _e214 = global_1.member[(_e210 + _e188.x)];
                let _e216 = unpack2x16float(_e214.x);
                let _e229 = global_1.member[(_e210 + _e188.y)];
                let _e231 = unpack2x16float(_e229.x);
                let _e244 = global_1.member[(_e210 + _e188.z)];
                let _e246 = unpack2x16float(_e244.x);
                let _e254 = ((((_e200.xyz + (_e203.xyz * vec3<f32>(f32((_e123.x & 65535u)), f32((_e123.x >> bitcast<u32>(16u))), f32((_e123.y & 65535u))))) + (vec3<f32>(_e216.x, _e216.y, unpack2x16float(_e214.y).x) * _e174)) + (vec3<f32>(_e231.x, _e231.y, unpack2x16float(_e229.y).x) * _e179)) + (vec3<f32>(_e246.x, _e246.y, unpack2x16float(_e244.y).x) * (_e175 - _e179)));
                let _e258 = vec4<f32>(_e254.x, _e254.y, _e254.z, 1f);
                let _e271 = (((_e123.y >> bitcast<u32>(16u)) | ((_e127.y >> bitcast<u32>(24u)) << bitcast<u32>(16u))) | ((_e132.y >> bitcast<u32>(26u)) << bitcast<u32>(24u)));
                let _e283 = global.member_32;
                let _e285 = global.member_33;
                let _e288 = (vec3(_e283) + (vec3<f32>(f32((_e271 & 1023u)), f32(((_e271 >> bitcast<u32>(10u)) & 1023u)), f32((_e271 >> bitcast<u32>(20u)))) * _e285));
                let _e297 = (vec4<u32>(_e127.x, (_e127.x >> bitcast<u32>(8u)), (_e127.x >> bitcast<u32>(16u)), (_e127.x >> bitcast<u32>(24u))) & vec4<u32>(255u, 255u, 255u, 255u));
                let _e303 = (vec3<u32>(_e127.y, (_e127.y >> bitcast<u32>(8u)), (_e127.y >> bitcast<u32>(16u))) & vec3<u32>(255u, 255u, 255u));
                let _e304 = vec3<f32>(_e303);
                let _e316 = (vec4<f32>(_e304.x, _e304.y, _e304.z, f32((((255u - _e303.x) - _e303.y) - _e303.z))) * vec4<f32>(0.003921569f, 0.003921569f, 0.003921569f, 0.003921569f));
                let _e319 = (3u * _e297.x);
                let _e322 = global.member_58[_e319];
                let _e327 = global.member_58[(_e319 + 1u)];
                let _e332 = global.member_58[(_e319 + 2u)];
                let _e336 = (3u * _e297.y);
                let _e339 = global.member_58[_e336];
                let _e345 = global.member_58[(_e336 + 1u)];
                let _e351 = global.member_58[(_e336 + 2u)];
                let _e356 = (3u * _e297.z);
                let _e359 = global.member_58[_e356];
                let _e365 = global.member_58[(_e356 + 1u)];
                let _e371 = global.member_58[(_e356 + 2u)];
                let _e376 = (3u * _e297.w);
                let _e379 = global.member_58[_e376];
                let _e381 = ((((_e322 * _e316.x) + (_e339 * _e316.y)) + (_e359 * _e316.z)) + (_e379 * _e316.w));
                let _e385 = global.member_58[(_e376 + 1u)];
                let _e387 = ((((_e327 * _e316.x) + (_e345 * _e316.y)) + (_e365 * _e316.z)) + (_e385 * _e316.w));
                let _e391 = global.member_58[(_e376 + 2u)];
                let _e393 = ((((_e332 * _e316.x) + (_e351 * _e316.y)) + (_e371 * _e316.z)) + (_e391 * _e316.w));
                let _e396 = dot(_e393, _e258);
                let _e397 = vec3<f32>(dot(_e381, _e258), dot(_e387, _e258), _e396);
                let _e409 = vec3<f32>(_e393.x, _e393.y, _e393.z);
                switch bitcast<i32>(0u) {
                    default: {
                        let _e412 = global.member_6;
                        if !((_e396 >= _e412)) {
                            let _e416 = global_3.member_9;
                            if (_e416 != 0u) {
                                let _e420 = atomicAdd((&global_2.member[0u]), 1u);
                            }
                            phi_4650_ = 0f;
                            phi_4644_ = vec2<f32>(0f, 0f);
                            phi_4643_ = false;
                            break;
                        }
                        let _e422 = global.member;
                        let _e428 = global.member_1;
                        let _e429 = (((_e422 * _e397.xy) / vec2(_e396)) + _e428);
                        let _e431 = global.member_5;
                        let _e435 = all((_e429 >= vec2(-(_e431))));
                        phi_3305_ = _e435;
                        if _e435 {
                            let _e437 = global.member_4;
                            phi_3305_ = all((_e429 <= (_e437 + vec2(_e431))));
                        }
                        let _e443 = phi_3305_;
                        if !(_e443) {
                            let _e446 = global_3.member_9;
                            if (_e446 != 0u) {
                                let _e450 = atomicAdd((&global_2.member[0u]), 1u);
                            }
                            phi_4650_ = 0f;
                            phi_4644_ = _e429;
                            phi_4643_ = false;
                            break;
                        }
                        let _e452 = global.member_7;
                        let _e455 = global.member_8;
                        let _e456 = ((_e452 - _e396) * _e455);
                        if (_e456 < 0f) {
                            phi_4642_ = (0.015625f / (1f - _e456));
                        } else {
                            if (_e456 > 1f) {
                                phi_4641_ = (1f - (0.015625f / _e456));
                            } else {
                                phi_4641_ = (0.015625f + (0.96875f * clamp(_e456, 0f, 1f)));
                            }
                            let _e465 = phi_4641_;
                            phi_4642_ = _e465;
                        }
                        let _e469 = phi_4642_;
                        phi_4650_ = _e469;
                        phi_4644_ = _e429;
                        phi_4643_ = true;
                        break;
                    }
                }
                let _e471 = phi_4650_;
                let _e473 = phi_4644_;
                let _e475 = phi_4643_;
                if (true && !(_e475)) {
                    phi_4711_ = 4294967295u;
                    break;
                }
                let _e482 = global_7.member[((3u * _e72) + _e76)];
                let _e486 = f32((_e482.y >> bitcast<u32>(24u)));
                let _e488 = global.member_29;
                if (_e486 <= _e488) {
                    let _e491 = global_3.member_9;
                    if (_e491 != 0u) {
                        let _e495 = atomicAdd((&global_2.member[1u]), 1u);
                    }
                    phi_4711_ = 4294967295u;
                    break;
                }
                let _e509 = ((vec3<f32>(f32((_e482.x & 1023u)), f32(((_e482.x >> bitcast<u32>(10u)) & 1023u)), f32(((_e482.x >> bitcast<u32>(20u)) & 1023u))) - vec3<f32>(512f, 512f, 512f)) * vec3<f32>(0.0013888889f, 0.0013888889f, 0.0013888889f));
                let _e513 = sqrt(max((1f - dot(_e509, _e509)), 0f));
                let _e515 = (_e482.x >> bitcast<u32>(30u));
                if (_e515 == 0u) {
                    phi_4656_ = vec4<f32>(_e513, _e509.x, _e509.y, _e509.z);
                } else {
                    if (_e515 == 1u) {
                        phi_4655_ = vec4<f32>(_e509.x, _e513, _e509.y, _e509.z);
                    } else {
                        if (_e515 == 2u) {
                            phi_4654_ = vec4<f32>(_e509.x, _e509.y, _e513, _e509.z);
                        } else {
                            phi_4654_ = vec4<f32>(_e509.x, _e509.y, _e509.z, _e513);
                        }
                        let _e528 = phi_4654_;
                        phi_4655_ = _e528;
                    }
                    let _e534 = phi_4655_;
                    phi_4656_ = _e534;
                }
                let _e540 = phi_4656_;
                let _e544 = global.member_34;
                let _e545 = (_e544 > 0u);
                phi_4668_ = unpack4x8unorm(_e482.y).xyz;
                if _e545 {
                    let _e549 = global_7.member[(_e544 + _e76)];
                    let _e551 = unpack2x16float(_e549.x);
                    phi_4668_ = vec3<f32>(_e551.x, _e551.y, unpack2x16float(_e549.y).x);
                }
                let _e559 = phi_4668_;
                let _e562 = (1u << bitcast<u32>((_e76 & 31u)));
                let _e565 = global_7.member[_e80];
                let _e569 = global_7.member[(_e80 + 1u)];
                let _e573 = global_7.member[(_e80 + 2u)];
                phi_4685_ = _e540;
                if ((_e565.x & _e562) != 0u) {
                    let _e584 = global.member_22;
                    let _e586 = global.member_18;
                    let _e590 = (_e584 + ((_e569.y + bitcast<u32>(countOneBits((_e565.x & (_e562 - 1u))))) * (1u + (4u * _e586))));
                    let _e591 = (_e590 + 1u);
                    let _e594 = global_6.member[_e590];
                    let _e596 = global.member_40;
                    let _e600 = global.member_19;
                    phi_4670_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_4669_ = 0u;
                    loop {
                        let _e604 = phi_4670_;
                        let _e606 = phi_4669_;
                        let _e608 = (2u * ((_e596 + ((_e594 >> bitcast<u32>(16u)) * _e600)) + _e606));
                        let _e611 = global_1.member[_e608];
                        let _e615 = global_1.member[(_e608 + 1u)];
                        let _e621 = bitcast<vec4<f32>>(vec4<u32>(_e611.x, _e611.y, _e615.x, _e615.y));
                        let _e625 = global_6.member[(_e591 + _e606)];
                        let _e632 = global_6.member[((_e591 + _e586) + _e606)];
                        let _e640 = global_6.member[((_e591 + (2u * _e586)) + _e606)];
                        let _e648 = global_6.member[((_e591 + (3u * _e586)) + _e606)];
                        let _e652 = (_e604 + vec4<f32>(dot(unpack4x8snorm(_e625), _e621), dot(unpack4x8snorm(_e632), _e621), dot(unpack4x8snorm(_e640), _e621), dot(unpack4x8snorm(_e648), _e621)));
                        let _e654 = (_e606 + bitcast<u32>(1i));
                        phi_4670_ = _e652;
                        phi_4669_ = _e654;
                        local_1 = _e652;
                        if (_e654 < _e586) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e660 = local_1;
                    let _e662 = (_e540 + (_e660 * (127f * unpack2x16float(_e594).x)));
                    phi_4685_ = select(_e540, _e662, vec4((length(_e662) >= 0.001f)));
                }
                let _e668 = phi_4685_;
                phi_4689_ = _e288;
                if ((_e565.y & _e562) != 0u) {
                    let _e679 = global.member_23;
                    let _e681 = global.member_18;
                    let _e685 = (_e679 + ((_e573.x + bitcast<u32>(countOneBits((_e565.y & (_e562 - 1u))))) * (1u + (3u * _e681))));
                    let _e686 = (_e685 + 1u);
                    let _e689 = global_6.member[_e685];
                    let _e691 = global.member_40;
                    let _e695 = global.member_19;
                    phi_4673_ = vec3<f32>(0f, 0f, 0f);
                    phi_4672_ = 0u;
                    loop {
                        let _e699 = phi_4673_;
                        let _e701 = phi_4672_;
                        let _e703 = (2u * ((_e691 + ((_e689 >> bitcast<u32>(16u)) * _e695)) + _e701));
                        let _e706 = global_1.member[_e703];
                        let _e710 = global_1.member[(_e703 + 1u)];
                        let _e716 = bitcast<vec4<f32>>(vec4<u32>(_e706.x, _e706.y, _e710.x, _e710.y));
                        let _e720 = global_6.member[(_e686 + _e701)];
                        let _e727 = global_6.member[((_e686 + _e681) + _e701)];
                        let _e735 = global_6.member[((_e686 + (2u * _e681)) + _e701)];
                        let _e739 = (_e699 + vec3<f32>(dot(unpack4x8snorm(_e720), _e716), dot(unpack4x8snorm(_e727), _e716), dot(unpack4x8snorm(_e735), _e716)));
                        let _e741 = (_e701 + bitcast<u32>(1i));
                        phi_4673_ = _e739;
                        phi_4672_ = _e741;
                        local_2 = _e739;
                        if (_e741 < _e681) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e747 = local_2;
                    phi_4689_ = (_e288 + (_e747 * (127f * unpack2x16float(_e689).x)));
                }
                let _e751 = phi_4689_;
                phi_4691_ = _e559;
                if ((_e569.x & _e562) != 0u) {
                    let _e762 = global.member_24;
                    let _e764 = global.member_18;
                    let _e768 = (_e762 + ((_e573.y + bitcast<u32>(countOneBits((_e569.x & (_e562 - 1u))))) * (3u + (3u * _e764))));
                    let _e772 = global_6.member[(_e768 + 1u)];
                    let _e773 = unpack2x16float(_e772);
                    let _e777 = global_6.member[(_e768 + 2u)];
                    let _e785 = (_e768 + 3u);
                    let _e788 = global_6.member[_e768];
                    let _e790 = global.member_40;
                    let _e794 = global.member_19;
                    phi_4682_ = vec3<f32>(0f, 0f, 0f);
                    phi_4681_ = 0u;
                    loop {
                        let _e798 = phi_4682_;
                        let _e800 = phi_4681_;
                        let _e802 = (2u * ((_e790 + ((_e788 >> bitcast<u32>(16u)) * _e794)) + _e800));
                        let _e805 = global_1.member[_e802];
                        let _e809 = global_1.member[(_e802 + 1u)];
                        let _e815 = bitcast<vec4<f32>>(vec4<u32>(_e805.x, _e805.y, _e809.x, _e809.y));
                        let _e819 = global_6.member[(_e785 + _e800)];
                        let _e826 = global_6.member[((_e785 + _e764) + _e800)];
                        let _e834 = global_6.member[((_e785 + (2u * _e764)) + _e800)];
                        let _e838 = (_e798 + vec3<f32>(dot(unpack4x8snorm(_e819), _e815), dot(unpack4x8snorm(_e826), _e815), dot(unpack4x8snorm(_e834), _e815)));
                        let _e840 = (_e800 + bitcast<u32>(1i));
                        phi_4682_ = _e838;
                        phi_4681_ = _e840;
                        local_3 = _e838;
                        if (_e840 < _e764) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e846 = local_3;
                    phi_4691_ = (select(vec3<f32>(_e773.x, _e773.y, unpack2x16float(_e777).x), _e559, vec3(_e545)) + (_e846 * (127f * unpack2x16float(_e788).x)));
                }
                let _e850 = phi_4691_;
                let _e851 = normalize(_e668);
                let _e856 = (_e851.z * _e851.z);
                let _e857 = (_e851.w * _e851.w);
                let _e861 = (_e851.y * _e851.z);
                let _e862 = (_e851.x * _e851.w);
                let _e865 = (_e851.y * _e851.w);
                let _e866 = (_e851.x * _e851.z);
                let _e871 = (_e851.y * _e851.y);
                let _e875 = (_e851.z * _e851.w);
                let _e876 = (_e851.x * _e851.y);
                let _e890 = exp(min(_e751, vec3<f32>(9f, 9f, 9f)));
                let _e897 = mat3x3<f32>((vec3<f32>((1f - (2f * (_e856 + _e857))), (2f * (_e861 + _e862)), (2f * (_e865 - _e866))) * _e890.x), (vec3<f32>((2f * (_e861 - _e862)), (1f - (2f * (_e871 + _e857))), (2f * (_e875 + _e876))) * _e890.y), (vec3<f32>((2f * (_e865 + _e866)), (2f * (_e875 - _e876)), (1f - (2f * (_e871 + _e856)))) * _e890.z));
                switch bitcast<i32>(0u) {
                    default: {
                        let _e903 = global.member_2;
                        let _e905 = global.member_3;
                        let _e906 = clamp((_e397.xy / vec2(_e396)), _e903, _e905);
                        let _e909 = global.member[0u];
                        let _e915 = (((vec3<f32>(_e381.x, _e381.y, _e381.z) - (_e409 * _e906.x)) * (_e909 / _e396)) * _e897);
                        let _e918 = global.member[1u];
                        let _e924 = (((vec3<f32>(_e387.x, _e387.y, _e387.z) - (_e409 * _e906.y)) * (_e918 / _e396)) * _e897);
                        let _e926 = global.member_47;
                        let _e928 = (dot(_e915, _e915) + _e926);
                        let _e931 = (dot(_e924, _e924) + _e926);
                        let _e933 = cross(_e915, _e924);
                        let _e934 = dot(_e933, _e933);
                        let _e938 = (_e934 + (_e926 * ((_e928 + _e931) - _e926)));
                        let _e939 = (_e938 > 0f);
                        phi_4123_ = _e939;
                        if _e939 {
                            phi_4123_ = (_e928 <= 1000000000000000000f);
                        }
                        let _e942 = phi_4123_;
                        phi_4129_ = _e942;
                        if _e942 {
                            phi_4129_ = (_e931 <= 1000000000000000000f);
                        }
                        let _e945 = phi_4129_;
                        if !(_e945) {
                            let _e948 = global_3.member_9;
                            if (_e948 != 0u) {
                                let _e952 = atomicAdd((&global_2.member[2u]), 1u);
                            }
                            phi_4710_ = 4294967295u;
                            break;
                        }
                        phi_4696_ = (1f - (_e486 * 0.003921569f));
                        phi_4695_ = 0u;
                        loop {
                            let _e956 = phi_4696_;
                            let _e958 = phi_4695_;
                            local_4 = _e956;
                            if (_e958 < _e74) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                phi_4696_ = (_e956 * _e956);
                                phi_4695_ = (_e958 + bitcast<u32>(1i));
                            }
                        }
                        let _e964 = local_4;
                        let _e968 = u32(round((255f * (1f - _e964))));
                        let _e970 = global.member_48;
                        phi_4704_ = _e968;
                        if (_e970 > 0f) {
                            let _e980 = u32(round((f32(_e968) * ((1f - _e970) + (_e970 * sqrt((_e934 / _e938)))))));
                            if (f32(_e980) <= _e488) {
                                let _e984 = global_3.member_9;
                                if (_e984 != 0u) {
                                    let _e988 = atomicAdd((&global_2.member[1u]), 1u);
                                }
                                phi_4710_ = 4294967295u;
                                break;
                            }
                            phi_4704_ = _e980;
                        }
                        let _e990 = phi_4704_;
                        let _e992 = global.member_45;
                        let _e993 = (vec3<f32>(_e928, dot(_e915, _e924), _e931) * _e992);
                        let _e1006 = global.member_49;
                        let _e1007 = ((sqrt(_e993.xz) * sqrt((2f * log(max((f32(_e990) / _e488), 1f))))) * _e1006);
                        let _e1010 = global.member_50;
                        let _e1013 = all(((_e473 + _e1007) > _e1010.xy));
                        phi_4207_ = _e1013;
                        if _e1013 {
                            phi_4207_ = all(((_e473 - _e1007) < _e1010.zw));
                        }
                        let _e1019 = phi_4207_;
                        if !(_e1019) {
                            let _e1022 = global_3.member_9;
                            if (_e1022 != 0u) {
                                let _e1026 = atomicAdd((&global_2.member[0u]), 1u);
                            }
                            phi_4710_ = 4294967295u;
                            break;
                        }
                        let _e1031 = (0.5f * (_e993.x - _e993.z));
                        let _e1036 = sqrt(((_e1031 * _e1031) + (_e993.y * _e993.y)));
                        let _e1039 = ((0.5f * (_e993.x + _e993.z)) + _e1036);
                        if (_e1031 >= 0f) {
                            phi_4708_ = vec2<f32>((_e1031 + _e1036), _e993.y);
                        } else {
                            phi_4708_ = vec2<f32>(_e993.y, (_e1036 - _e1031));
                        }
                        let _e1046 = phi_4708_;
                        if (_e1036 > (0.00000001f * _e1039)) {
                            phi_4709_ = normalize(_e1046);
                        } else {
                            phi_4709_ = vec2<f32>(1f, 0f);
                        }
                        let _e1051 = phi_4709_;
                        let _e1058 = global.member_5;
                        let _e1062 = global.member_10;
                        let _e1066 = vec2<u32>(clamp(round(((_e473 + vec2(_e1058)) * _e1062)), vec2<f32>(0f, 0f), vec2<f32>(1048575f, 1048575f)));
                        let _e1069 = vec3<u32>(round((clamp(_e850, vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 1023f)));
                        let _e1097 = global.member_41;
                        let _e1099 = (4u * (_e1097 + _e66));
                        global_4.member[_e1099] = ((_e1066.x | (_e1069.x << bitcast<u32>(20u))) | (_e1069.z << bitcast<u32>(30u)));
                        global_4.member[(_e1099 + 1u)] = (_e1066.y | (_e1069.y << bitcast<u32>(20u)));
                        global_4.member[(_e1099 + 2u)] = pack2x16float((_e1051 * min(sqrt(_e1039), 65504f)));
                        global_4.member[(_e1099 + 3u)] = ((pack2x16float(vec2<f32>(min(sqrt(((_e938 * (_e992 * _e992)) / _e1039)), 65504f), 0f)) | (_e990 << bitcast<u32>(16u))) | ((_e1069.z >> bitcast<u32>(2u)) << bitcast<u32>(24u)));
                        let _e1112 = global.member_9;
                        phi_4710_ = min(u32((_e471 * f32(_e1112))), _e1112);
                        break;
                    }
                }
                let _e1118 = phi_4710_;
                phi_4711_ = _e1118;
                break;
            }
        }
        let _e1120 = phi_4711_;
        phi_4712_ = _e1120;
    } else {
        phi_4712_ = 4294967295u;
    }
    let _e1122 = phi_4712_;
    switch bitcast<i32>(0u) {
        default: {
            let _e1125 = bitcast<u32>(param[0u]);
            let _e1127 = global.member_41;
            let _e1128 = (_e1127 + _e66);
            if (_e1122 != 4294967295u) {
                let _e1131 = global.member_37;
                let _e1135 = global.member_36;
                let _e1141 = atomicAdd((&global_2.member[((_e1135 + ((_e1128 / _e1131) * 256u)) + (_e1122 & 255u))]), 1u);
            }
            let _e1143 = global.member_35;
            if (_e1143 == 0u) {
                if (_e66 < (_e68 + (_e68 & 1u))) {
                    let _e1149 = global.member_28;
                    global_4.member[(_e1149 + _e1128)] = _e1122;
                }
                break;
            }
            global_5[_e1125] = _e1122;
            workgroupBarrier();
            let _e1155 = ((_e1125 & 1u) == 0u);
            if select(_e1155, _e69, _e1155) {
                let _e1158 = global.member_28;
                let _e1165 = global_5[(_e1125 + 1u)];
                global_4.member[(_e1158 + (_e1128 >> bitcast<u32>(1u)))] = ((_e1122 & 65535u) | (_e1165 << bitcast<u32>(16u)));
            }
            break;
        }
    }
    return;
}
