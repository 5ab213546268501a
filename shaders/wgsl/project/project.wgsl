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
    var phi_5017_: u32;
    var phi_5016_: bool;
    var phi_3064_: bool;
    var local: bool;
    var phi_5019_: f32;
    var phi_5020_: f32;
    var phi_5026_: f32;
    var phi_5022_: vec2<f32>;
    var phi_5021_: bool;
    var phi_5032_: bool;
    var phi_5033_: bool;
    var phi_5034_: vec4<f32>;
    var phi_5035_: vec4<f32>;
    var phi_5036_: vec4<f32>;
    var phi_5046_: vec3<f32>;
    var phi_5048_: vec4<f32>;
    var phi_5047_: u32;
    var local_1: vec4<f32>;
    var phi_5063_: vec4<f32>;
    var phi_5051_: vec3<f32>;
    var phi_5050_: u32;
    var local_2: vec3<f32>;
    var phi_5067_: vec3<f32>;
    var phi_5060_: vec3<f32>;
    var phi_5059_: u32;
    var local_3: vec3<f32>;
    var phi_5069_: vec3<f32>;
    var phi_4438_: bool;
    var phi_4444_: bool;
    var phi_5074_: f32;
    var phi_5073_: u32;
    var local_4: f32;
    var phi_5082_: u32;
    var phi_4522_: bool;
    var phi_5086_: vec2<f32>;
    var phi_5087_: vec2<f32>;
    var phi_5090_: u32;
    var phi_5091_: u32;
    var phi_5092_: u32;

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
                phi_5017_ = (_e90 & 65535u);
                phi_5016_ = true;
                loop {
                    let _e93 = phi_5017_;
                    let _e95 = phi_5016_;
                    local = _e95;
                    phi_3064_ = _e95;
                    if _e95 {
                        phi_3064_ = (_e93 <= (_e90 >> bitcast<u32>(16u)));
                    }
                    let _e100 = phi_3064_;
                    if _e100 {
                        continue;
                    } else {
                        break;
                    }
                    continuing {
                        let _e109 = global.member_55[(_e93 >> bitcast<u32>(7u))][((_e93 >> bitcast<u32>(5u)) & 3u)];
                        phi_5017_ = (_e93 + bitcast<u32>(1i));
                        phi_5016_ = (((_e109 >> bitcast<u32>((_e93 & 31u))) & 1u) != 0u);
                    }
                }
                let _e118 = local;
                if _e118 {
                    let _e120 = global_3.member_9;
                    if (_e120 != 0u) {
                        let _e124 = atomicAdd((&global_2.member[0u]), 1u);
                    }
                    phi_5091_ = 4294967295u;
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
                            let _e421 = global_3.member_9;
                            if (_e421 != 0u) {
                                let _e425 = atomicAdd((&global_2.member[0u]), 1u);
                            }
                            phi_5026_ = 0f;
                            phi_5022_ = vec2<f32>(0f, 0f);
                            phi_5021_ = false;
                            break;
                        }
                        let _e427 = global.member;
                        let _e433 = global.member_1;
                        let _e436 = global.member_7;
                        let _e439 = global.member_8;
                        let _e440 = ((_e436 - _e401) * _e439);
                        if (_e440 < 0f) {
                            phi_5020_ = (0.015625f / (1f - _e440));
                        } else {
                            if (_e440 > 1f) {
                                phi_5019_ = (1f - (0.015625f / _e440));
                            } else {
                                phi_5019_ = (0.015625f + (0.96875f * clamp(_e440, 0f, 1f)));
                            }
                            let _e449 = phi_5019_;
                            phi_5020_ = _e449;
                        }
                        let _e453 = phi_5020_;
                        phi_5026_ = _e453;
                        phi_5022_ = (((_e427 * _e402.xy) / vec2(_e401)) + _e433);
                        phi_5021_ = true;
                        break;
                    }
                }
                let _e455 = phi_5026_;
                let _e457 = phi_5022_;
                let _e459 = phi_5021_;
                let _e463 = global_7.member[_e85][1u];
                let _e464 = (_e81 & 31u);
                phi_5033_ = _e459;
                if (_e459 && !((((_e463 >> bitcast<u32>(_e464)) & 1u) != 0u))) {
                    switch bitcast<i32>(0u) {
                        default: {
                            let _e480 = global.member_50;
                            let _e485 = max((_e480.xy - _e457), (_e457 - _e480.zw));
                            if !((max(_e485.x, _e485.y) > 0f)) {
                                phi_5032_ = false;
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
                                let _e538 = global_3.member_9;
                                if (_e538 != 0u) {
                                    let _e542 = atomicAdd((&global_2.member[0u]), 1u);
                                }
                            }
                            phi_5032_ = _e536;
                            break;
                        }
                    }
                    let _e544 = phi_5032_;
                    phi_5033_ = !(_e544);
                }
                let _e547 = phi_5033_;
                if (true && !(_e547)) {
                    phi_5091_ = 4294967295u;
                    break;
                }
                let _e554 = global_7.member[((3u * _e77) + _e81)];
                let _e558 = f32((_e554.y >> bitcast<u32>(24u)));
                let _e560 = global.member_29;
                if (_e558 <= _e560) {
                    let _e563 = global_3.member_9;
                    if (_e563 != 0u) {
                        let _e567 = atomicAdd((&global_2.member[1u]), 1u);
                    }
                    phi_5091_ = 4294967295u;
                    break;
                }
                let _e581 = ((vec3<f32>(f32((_e554.x & 1023u)), f32(((_e554.x >> bitcast<u32>(10u)) & 1023u)), f32(((_e554.x >> bitcast<u32>(20u)) & 1023u))) - vec3<f32>(512f, 512f, 512f)) * vec3<f32>(0.0013888889f, 0.0013888889f, 0.0013888889f));
                let _e585 = sqrt(max((1f - dot(_e581, _e581)), 0f));
                let _e587 = (_e554.x >> bitcast<u32>(30u));
                if (_e587 == 0u) {
                    phi_5036_ = vec4<f32>(_e585, _e581.x, _e581.y, _e581.z);
                } else {
                    if (_e587 == 1u) {
                        phi_5035_ = vec4<f32>(_e581.x, _e585, _e581.y, _e581.z);
                    } else {
                        if (_e587 == 2u) {
                            phi_5034_ = vec4<f32>(_e581.x, _e581.y, _e585, _e581.z);
                        } else {
                            phi_5034_ = vec4<f32>(_e581.x, _e581.y, _e581.z, _e585);
                        }
                        let _e600 = phi_5034_;
                        phi_5035_ = _e600;
                    }
                    let _e606 = phi_5035_;
                    phi_5036_ = _e606;
                }
                let _e612 = phi_5036_;
                let _e616 = global.member_34;
                let _e617 = (_e616 > 0u);
                phi_5046_ = unpack4x8unorm(_e554.y).xyz;
                if _e617 {
                    let _e621 = global_7.member[(_e616 + _e81)];
                    let _e623 = unpack2x16float(_e621.x);
                    phi_5046_ = vec3<f32>(_e623.x, _e623.y, unpack2x16float(_e621.y).x);
                }
                let _e631 = phi_5046_;
                let _e633 = (1u << bitcast<u32>(_e464));
                let _e636 = global_7.member[_e85];
                let _e640 = global_7.member[(_e85 + 1u)];
                let _e644 = global_7.member[(_e85 + 2u)];
                phi_5063_ = _e612;
                if ((_e636.x & _e633) != 0u) {
                    let _e655 = global.member_22;
                    let _e657 = global.member_18;
                    let _e661 = (_e655 + ((_e640.y + bitcast<u32>(countOneBits((_e636.x & (_e633 - 1u))))) * (1u + (4u * _e657))));
                    let _e662 = (_e661 + 1u);
                    let _e665 = global_6.member[_e661];
                    let _e667 = global.member_40;
                    let _e671 = global.member_19;
                    phi_5048_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_5047_ = 0u;
                    loop {
                        let _e675 = phi_5048_;
                        let _e677 = phi_5047_;
                        let _e679 = (2u * ((_e667 + ((_e665 >> bitcast<u32>(16u)) * _e671)) + _e677));
                        let _e682 = global_1.member[_e679];
                        let _e686 = global_1.member[(_e679 + 1u)];
                        let _e692 = bitcast<vec4<f32>>(vec4<u32>(_e682.x, _e682.y, _e686.x, _e686.y));
                        let _e696 = global_6.member[(_e662 + _e677)];
                        let _e703 = global_6.member[((_e662 + _e657) + _e677)];
                        let _e711 = global_6.member[((_e662 + (2u * _e657)) + _e677)];
                        let _e719 = global_6.member[((_e662 + (3u * _e657)) + _e677)];
                        let _e723 = (_e675 + vec4<f32>(dot(unpack4x8snorm(_e696), _e692), dot(unpack4x8snorm(_e703), _e692), dot(unpack4x8snorm(_e711), _e692), dot(unpack4x8snorm(_e719), _e692)));
                        let _e725 = (_e677 + bitcast<u32>(1i));
                        phi_5048_ = _e723;
                        phi_5047_ = _e725;
                        local_1 = _e723;
                        if (_e725 < _e657) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e731 = local_1;
                    let _e733 = (_e612 + (_e731 * (127f * unpack2x16float(_e665).x)));
                    phi_5063_ = select(_e612, _e733, vec4((length(_e733) >= 0.001f)));
                }
                let _e739 = phi_5063_;
                phi_5067_ = _e293;
                if ((_e636.y & _e633) != 0u) {
                    let _e750 = global.member_23;
                    let _e752 = global.member_18;
                    let _e756 = (_e750 + ((_e644.x + bitcast<u32>(countOneBits((_e636.y & (_e633 - 1u))))) * (1u + (3u * _e752))));
                    let _e757 = (_e756 + 1u);
                    let _e760 = global_6.member[_e756];
                    let _e762 = global.member_40;
                    let _e766 = global.member_19;
                    phi_5051_ = vec3<f32>(0f, 0f, 0f);
                    phi_5050_ = 0u;
                    loop {
                        let _e770 = phi_5051_;
                        let _e772 = phi_5050_;
                        let _e774 = (2u * ((_e762 + ((_e760 >> bitcast<u32>(16u)) * _e766)) + _e772));
                        let _e777 = global_1.member[_e774];
                        let _e781 = global_1.member[(_e774 + 1u)];
                        let _e787 = bitcast<vec4<f32>>(vec4<u32>(_e777.x, _e777.y, _e781.x, _e781.y));
                        let _e791 = global_6.member[(_e757 + _e772)];
                        let _e798 = global_6.member[((_e757 + _e752) + _e772)];
                        let _e806 = global_6.member[((_e757 + (2u * _e752)) + _e772)];
                        let _e810 = (_e770 + vec3<f32>(dot(unpack4x8snorm(_e791), _e787), dot(unpack4x8snorm(_e798), _e787), dot(unpack4x8snorm(_e806), _e787)));
                        let _e812 = (_e772 + bitcast<u32>(1i));
                        phi_5051_ = _e810;
                        phi_5050_ = _e812;
                        local_2 = _e810;
                        if (_e812 < _e752) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e818 = local_2;
                    phi_5067_ = (_e293 + (_e818 * (127f * unpack2x16float(_e760).x)));
                }
                let _e822 = phi_5067_;
                phi_5069_ = _e631;
                if ((_e640.x & _e633) != 0u) {
                    let _e833 = global.member_24;
                    let _e835 = global.member_18;
                    let _e839 = (_e833 + ((_e644.y + bitcast<u32>(countOneBits((_e640.x & (_e633 - 1u))))) * (3u + (3u * _e835))));
                    let _e843 = global_6.member[(_e839 + 1u)];
                    let _e844 = unpack2x16float(_e843);
                    let _e848 = global_6.member[(_e839 + 2u)];
                    let _e856 = (_e839 + 3u);
                    let _e859 = global_6.member[_e839];
                    let _e861 = global.member_40;
                    let _e865 = global.member_19;
                    phi_5060_ = vec3<f32>(0f, 0f, 0f);
                    phi_5059_ = 0u;
                    loop {
                        let _e869 = phi_5060_;
                        let _e871 = phi_5059_;
                        let _e873 = (2u * ((_e861 + ((_e859 >> bitcast<u32>(16u)) * _e865)) + _e871));
                        let _e876 = global_1.member[_e873];
                        let _e880 = global_1.member[(_e873 + 1u)];
                        let _e886 = bitcast<vec4<f32>>(vec4<u32>(_e876.x, _e876.y, _e880.x, _e880.y));
                        let _e890 = global_6.member[(_e856 + _e871)];
                        let _e897 = global_6.member[((_e856 + _e835) + _e871)];
                        let _e905 = global_6.member[((_e856 + (2u * _e835)) + _e871)];
                        let _e909 = (_e869 + vec3<f32>(dot(unpack4x8snorm(_e890), _e886), dot(unpack4x8snorm(_e897), _e886), dot(unpack4x8snorm(_e905), _e886)));
                        let _e911 = (_e871 + bitcast<u32>(1i));
                        phi_5060_ = _e909;
                        phi_5059_ = _e911;
                        local_3 = _e909;
                        if (_e911 < _e835) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e917 = local_3;
                    phi_5069_ = (select(vec3<f32>(_e844.x, _e844.y, unpack2x16float(_e848).x), _e631, vec3(_e617)) + (_e917 * (127f * unpack2x16float(_e859).x)));
                }
                let _e921 = phi_5069_;
                let _e922 = normalize(_e739);
                let _e927 = (_e922.z * _e922.z);
                let _e928 = (_e922.w * _e922.w);
                let _e932 = (_e922.y * _e922.z);
                let _e933 = (_e922.x * _e922.w);
                let _e936 = (_e922.y * _e922.w);
                let _e937 = (_e922.x * _e922.z);
                let _e942 = (_e922.y * _e922.y);
                let _e946 = (_e922.z * _e922.w);
                let _e947 = (_e922.x * _e922.y);
                let _e961 = exp(min(_e822, vec3<f32>(9f, 9f, 9f)));
                let _e968 = mat3x3<f32>((vec3<f32>((1f - (2f * (_e927 + _e928))), (2f * (_e932 + _e933)), (2f * (_e936 - _e937))) * _e961.x), (vec3<f32>((2f * (_e932 - _e933)), (1f - (2f * (_e942 + _e928))), (2f * (_e946 + _e947))) * _e961.y), (vec3<f32>((2f * (_e936 + _e937)), (2f * (_e946 - _e947)), (1f - (2f * (_e942 + _e927)))) * _e961.z));
                switch bitcast<i32>(0u) {
                    default: {
                        let _e974 = global.member_2;
                        let _e976 = global.member_3;
                        let _e977 = clamp((_e402.xy / vec2(_e401)), _e974, _e976);
                        let _e980 = global.member[0u];
                        let _e986 = (((_e412 - (_e414 * _e977.x)) * (_e980 / _e401)) * _e968);
                        let _e989 = global.member[1u];
                        let _e995 = (((_e413 - (_e414 * _e977.y)) * (_e989 / _e401)) * _e968);
                        let _e997 = global.member_47;
                        let _e999 = (dot(_e986, _e986) + _e997);
                        let _e1002 = (dot(_e995, _e995) + _e997);
                        let _e1004 = cross(_e986, _e995);
                        let _e1005 = dot(_e1004, _e1004);
                        let _e1009 = (_e1005 + (_e997 * ((_e999 + _e1002) - _e997)));
                        let _e1010 = (_e1009 > 0f);
                        phi_4438_ = _e1010;
                        if _e1010 {
                            phi_4438_ = (_e999 <= 1000000000000000000f);
                        }
                        let _e1013 = phi_4438_;
                        phi_4444_ = _e1013;
                        if _e1013 {
                            phi_4444_ = (_e1002 <= 1000000000000000000f);
                        }
                        let _e1016 = phi_4444_;
                        if !(_e1016) {
                            let _e1019 = global_3.member_9;
                            if (_e1019 != 0u) {
                                let _e1023 = atomicAdd((&global_2.member[2u]), 1u);
                            }
                            phi_5090_ = 4294967295u;
                            break;
                        }
                        phi_5074_ = (1f - (_e558 * 0.003921569f));
                        phi_5073_ = 0u;
                        loop {
                            let _e1027 = phi_5074_;
                            let _e1029 = phi_5073_;
                            local_4 = _e1027;
                            if (_e1029 < 3u) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                phi_5074_ = select(_e1027, (_e1027 * _e1027), (_e1029 < _e79));
                                phi_5073_ = (_e1029 + bitcast<u32>(1i));
                            }
                        }
                        let _e1037 = local_4;
                        let _e1041 = u32(round((255f * (1f - _e1037))));
                        let _e1043 = global.member_48;
                        phi_5082_ = _e1041;
                        if (_e1043 > 0f) {
                            let _e1053 = u32(round((f32(_e1041) * ((1f - _e1043) + (_e1043 * sqrt((_e1005 / _e1009)))))));
                            if (f32(_e1053) <= _e560) {
                                let _e1057 = global_3.member_9;
                                if (_e1057 != 0u) {
                                    let _e1061 = atomicAdd((&global_2.member[1u]), 1u);
                                }
                                phi_5090_ = 4294967295u;
                                break;
                            }
                            phi_5082_ = _e1053;
                        }
                        let _e1063 = phi_5082_;
                        let _e1065 = global.member_45;
                        let _e1066 = (vec3<f32>(_e999, dot(_e986, _e995), _e1002) * _e1065);
                        let _e1079 = global.member_49;
                        let _e1080 = ((sqrt(_e1066.xz) * sqrt((2f * log(max((f32(_e1063) / _e560), 1f))))) * _e1079);
                        let _e1083 = global.member_50;
                        let _e1086 = all(((_e457 + _e1080) > _e1083.xy));
                        phi_4522_ = _e1086;
                        if _e1086 {
                            phi_4522_ = all(((_e457 - _e1080) < _e1083.zw));
                        }
                        let _e1092 = phi_4522_;
                        if !(_e1092) {
                            let _e1095 = global_3.member_9;
                            if (_e1095 != 0u) {
                                let _e1099 = atomicAdd((&global_2.member[0u]), 1u);
                            }
                            phi_5090_ = 4294967295u;
                            break;
                        }
                        let _e1104 = (0.5f * (_e1066.x - _e1066.z));
                        let _e1109 = sqrt(((_e1104 * _e1104) + (_e1066.y * _e1066.y)));
                        let _e1112 = ((0.5f * (_e1066.x + _e1066.z)) + _e1109);
                        if (_e1104 >= 0f) {
                            phi_5086_ = vec2<f32>((_e1104 + _e1109), _e1066.y);
                        } else {
                            phi_5086_ = vec2<f32>(_e1066.y, (_e1109 - _e1104));
                        }
                        let _e1119 = phi_5086_;
                        if (_e1109 > (0.00000001f * _e1112)) {
                            phi_5087_ = normalize(_e1119);
                        } else {
                            phi_5087_ = vec2<f32>(1f, 0f);
                        }
                        let _e1124 = phi_5087_;
                        let _e1132 = max(-(_e457), (_e457 * 0.5f));
                        let _e1137 = global.member_5;
                        let _e1138 = (max(_e1132.x, _e1132.y) / _e1137);
                        let _e1146 = ((select(0u, 1u, (_e1138 > 1f)) + select(0u, 1u, (_e1138 > 64f))) + select(0u, 1u, (_e1138 > 4096f)));
                        let _e1155 = global.member_10;
                        let _e1159 = vec2<u32>(clamp(round((((_e457 * exp2(-(f32((_e1146 * 6u))))) + vec2(_e1137)) * _e1155)), vec2<f32>(0f, 0f), vec2<f32>(1048575f, 1048575f)));
                        let _e1162 = vec3<u32>(round((clamp(_e921, vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 1023f)));
                        let _e1193 = global.member_41;
                        let _e1195 = (4u * (_e1193 + _e71));
                        global_4.member[_e1195] = ((_e1159.x | (_e1162.x << bitcast<u32>(20u))) | (_e1162.z << bitcast<u32>(30u)));
                        global_4.member[(_e1195 + 1u)] = ((_e1159.y | (_e1162.y << bitcast<u32>(20u))) | (_e1146 << bitcast<u32>(30u)));
                        global_4.member[(_e1195 + 2u)] = pack2x16float((_e1124 * min(sqrt(_e1112), 65504f)));
                        global_4.member[(_e1195 + 3u)] = ((pack2x16float(vec2<f32>(min(sqrt(((_e1009 * (_e1065 * _e1065)) / _e1112)), 65504f), 0f)) | (_e1063 << bitcast<u32>(16u))) | ((_e1162.z >> bitcast<u32>(2u)) << bitcast<u32>(24u)));
                        let _e1208 = global.member_9;
                        phi_5090_ = min(u32((_e455 * f32(_e1208))), _e1208);
                        break;
                    }
                }
                let _e1214 = phi_5090_;
                phi_5091_ = _e1214;
                break;
            }
        }
        let _e1216 = phi_5091_;
        phi_5092_ = _e1216;
    } else {
        phi_5092_ = 4294967295u;
    }
    let _e1218 = phi_5092_;
    switch bitcast<i32>(0u) {
        default: {
            let _e1221 = bitcast<u32>(param[0u]);
            let _e1223 = global.member_41;
            let _e1224 = (_e1223 + _e71);
            if (_e1218 != 4294967295u) {
                let _e1227 = global.member_37;
                let _e1231 = global.member_36;
                let _e1237 = atomicAdd((&global_2.member[((_e1231 + ((_e1224 / _e1227) * 256u)) + (_e1218 & 255u))]), 1u);
            }
            let _e1239 = global.member_35;
            if (_e1239 == 0u) {
                if (_e71 < (_e73 + (_e73 & 1u))) {
                    let _e1245 = global.member_28;
                    global_4.member[(_e1245 + _e1224)] = _e1218;
                }
                break;
            }
            global_5[_e1221] = _e1218;
            workgroupBarrier();
            let _e1251 = ((_e1221 & 1u) == 0u);
            if select(_e1251, _e74, _e1251) {
                let _e1254 = global.member_28;
                let _e1261 = global_5[(_e1221 + 1u)];
                global_4.member[(_e1254 + (_e1224 >> bitcast<u32>(1u)))] = ((_e1218 & 65535u) | (_e1261 << bitcast<u32>(16u)));
            }
            break;
        }
    }
    return;
}
