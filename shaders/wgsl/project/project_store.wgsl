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
    var phi_3339_: bool;
    var phi_4994_: f32;
    var phi_4995_: f32;
    var phi_5003_: f32;
    var phi_4997_: vec2<f32>;
    var phi_4996_: bool;
    var phi_5007_: vec4<f32>;
    var phi_5008_: vec4<f32>;
    var phi_5009_: vec4<f32>;
    var phi_5021_: vec3<f32>;
    var phi_5023_: vec4<f32>;
    var phi_5022_: u32;
    var local: vec4<f32>;
    var phi_5038_: vec4<f32>;
    var phi_5026_: vec3<f32>;
    var phi_5025_: u32;
    var local_1: vec3<f32>;
    var phi_5042_: vec3<f32>;
    var phi_5035_: vec3<f32>;
    var phi_5034_: u32;
    var local_2: vec3<f32>;
    var phi_5044_: vec3<f32>;
    var phi_5045_: vec3<f32>;
    var phi_5047_: vec3<f32>;
    var phi_5049_: vec3<f32>;
    var phi_2869_: bool;
    var phi_2883_: bool;
    var phi_4451_: bool;
    var phi_4457_: bool;
    var phi_5064_: f32;
    var phi_5063_: u32;
    var local_3: f32;
    var phi_5072_: u32;
    var phi_4535_: bool;
    var phi_5076_: vec2<f32>;
    var phi_5077_: vec2<f32>;
    var phi_5078_: u32;
    var phi_5079_: u32;
    var phi_5080_: u32;

    let _e78 = bitcast<u32>(param_1[0u]);
    let _e80 = global.member_44;
    let _e81 = (_e78 < _e80);
    if _e81 {
        switch bitcast<i32>(0u) {
            default: {
                let _e84 = global.member_14;
                let _e86 = global.member_43;
                let _e88 = (_e78 << bitcast<u32>(_e86));
                let _e92 = (4u * (_e84 + (_e88 >> bitcast<u32>(5u))));
                let _e93 = (2u * _e88);
                let _e96 = global_7.member[_e93];
                let _e100 = global_7.member[(_e93 + 1u)];
                let _e105 = global_7.member[((2u * _e84) + _e88)];
                let _e107 = global.member_15;
                let _e111 = bitcast<u32>(firstLeadingBit((max(_e107, 4096u) - 1u)));
                let _e112 = (_e111 + 1u);
                let _e113 = (15u - _e111);
                let _e127 = (vec2<u32>((32u << bitcast<u32>((2u * _e113))), (32u << bitcast<u32>(_e113))) - vec2<u32>(1u, 1u));
                let _e143 = (vec2<f32>(vec2<u32>(((((_e105.x >> bitcast<u32>(16u)) >> bitcast<u32>(((2u * _e112) - 16u))) << bitcast<u32>(5u)) | ((_e105.y >> bitcast<u32>(_e112)) & 31u)), ((_e105.y >> bitcast<u32>((_e111 + 6u))) & _e127.y))) / vec2<f32>(_e127));
                let _e147 = ((1f + (2f * _e143.x)) * 0.33333334f);
                let _e148 = (1f - _e147);
                let _e152 = (_e148 * (0.5f + (0.5f * _e143.y)));
                let _e161 = (vec3<u32>(_e105.x, (_e105.x >> bitcast<u32>(_e112)), _e105.y) & vec3(((1u << bitcast<u32>(_e112)) - 1u)));
                let _e173 = global.member_11;
                let _e176 = global.member_12;
                let _e182 = global.member_21;
                let _e183 = (2u * _e182);
                let _e187 = global_1.member[(_e183 + _e161.x)];
                let _e189 = unpack2x16float(_e187.x);
                let _e202 = global_1.member[(_e183 + _e161.y)];
                let _e204 = unpack2x16float(_e202.x);
                let _e217 = global_1.member[(_e183 + _e161.z)];
                let _e219 = unpack2x16float(_e217.x);
                let _e227 = ((((_e173.xyz + (_e176.xyz * vec3<f32>(f32((_e96.x & 65535u)), f32((_e96.x >> bitcast<u32>(16u))), f32((_e96.y & 65535u))))) + (vec3<f32>(_e189.x, _e189.y, unpack2x16float(_e187.y).x) * _e147)) + (vec3<f32>(_e204.x, _e204.y, unpack2x16float(_e202.y).x) * _e152)) + (vec3<f32>(_e219.x, _e219.y, unpack2x16float(_e217.y).x) * (_e148 - _e152)));
                let _e231 = vec4<f32>(_e227.x, _e227.y, _e227.z, 1f);
                let _e244 = (((_e96.y >> bitcast<u32>(16u)) | ((_e100.y >> bitcast<u32>(24u)) << bitcast<u32>(16u))) | ((_e105.y >> bitcast<u32>(26u)) << bitcast<u32>(24u)));
                let _e256 = global.member_32;
                let _e258 = global.member_33;
                let _e261 = (vec3(_e256) + (vec3<f32>(f32((_e244 & 1023u)), f32(((_e244 >> bitcast<u32>(10u)) & 1023u)), f32((_e244 >> bitcast<u32>(20u)))) * _e258));
                let _e270 = (vec4<u32>(_e100.x, (_e100.x >> bitcast<u32>(8u)), (_e100.x >> bitcast<u32>(16u)), (_e100.x >> bitcast<u32>(24u))) & vec4<u32>(255u, 255u, 255u, 255u));
                let _e276 = (vec3<u32>(_e100.y, (_e100.y >> bitcast<u32>(8u)), (_e100.y >> bitcast<u32>(16u))) & vec3<u32>(255u, 255u, 255u));
                let _e277 = vec3<f32>(_e276);
                let _e289 = (vec4<f32>(_e277.x, _e277.y, _e277.z, f32((((255u - _e276.x) - _e276.y) - _e276.z))) * vec4<f32>(0.003921569f, 0.003921569f, 0.003921569f, 0.003921569f));
                let _e292 = (3u * _e270.x);
                let _e295 = global.member_58[_e292];
                let _e300 = global.member_58[(_e292 + 1u)];
                let _e305 = global.member_58[(_e292 + 2u)];
                let _e309 = (3u * _e270.y);
                let _e312 = global.member_58[_e309];
                let _e318 = global.member_58[(_e309 + 1u)];
                let _e324 = global.member_58[(_e309 + 2u)];
                let _e329 = (3u * _e270.z);
                let _e332 = global.member_58[_e329];
                let _e338 = global.member_58[(_e329 + 1u)];
                let _e344 = global.member_58[(_e329 + 2u)];
                let _e349 = (3u * _e270.w);
                let _e352 = global.member_58[_e349];
                let _e354 = ((((_e295 * _e289.x) + (_e312 * _e289.y)) + (_e332 * _e289.z)) + (_e352 * _e289.w));
                let _e358 = global.member_58[(_e349 + 1u)];
                let _e360 = ((((_e300 * _e289.x) + (_e318 * _e289.y)) + (_e338 * _e289.z)) + (_e358 * _e289.w));
                let _e364 = global.member_58[(_e349 + 2u)];
                let _e366 = ((((_e305 * _e289.x) + (_e324 * _e289.y)) + (_e344 * _e289.z)) + (_e364 * _e289.w));
                let _e369 = dot(_e366, _e231);
                let _e370 = vec3<f32>(dot(_e354, _e231), dot(_e360, _e231), _e369);
                let _e380 = vec3<f32>(_e354.x, _e354.y, _e354.z);
                let _e381 = vec3<f32>(_e360.x, _e360.y, _e360.z);
                let _e382 = vec3<f32>(_e366.x, _e366.y, _e366.z);
                switch bitcast<i32>(0u) {
                    default: {
                        let _e386 = global.member_6;
                        if !((_e369 >= _e386)) {
                            let _e390 = global_3.member_9;
                            if (_e390 != 0u) {
                                let _e394 = atomicAdd((&global_2.member[0u]), 1u);
                            }
                            phi_5003_ = 0f;
                            phi_4997_ = vec2<f32>(0f, 0f);
                            phi_4996_ = false;
                            break;
                        }
                        let _e396 = global.member;
                        let _e402 = global.member_1;
                        let _e403 = (((_e396 * _e370.xy) / vec2(_e369)) + _e402);
                        let _e405 = global.member_5;
                        let _e409 = all((_e403 >= vec2(-(_e405))));
                        phi_3339_ = _e409;
                        if _e409 {
                            let _e411 = global.member_4;
                            phi_3339_ = all((_e403 <= (_e411 + vec2(_e405))));
                        }
                        let _e417 = phi_3339_;
                        if !(_e417) {
                            let _e420 = global_3.member_9;
                            if (_e420 != 0u) {
                                let _e424 = atomicAdd((&global_2.member[0u]), 1u);
                            }
                            phi_5003_ = 0f;
                            phi_4997_ = _e403;
                            phi_4996_ = false;
                            break;
                        }
                        let _e426 = global.member_7;
                        let _e429 = global.member_8;
                        let _e430 = ((_e426 - _e369) * _e429);
                        if (_e430 < 0f) {
                            phi_4995_ = (0.015625f / (1f - _e430));
                        } else {
                            if (_e430 > 1f) {
                                phi_4994_ = (1f - (0.015625f / _e430));
                            } else {
                                phi_4994_ = (0.015625f + (0.96875f * clamp(_e430, 0f, 1f)));
                            }
                            let _e439 = phi_4994_;
                            phi_4995_ = _e439;
                        }
                        let _e443 = phi_4995_;
                        phi_5003_ = _e443;
                        phi_4997_ = _e403;
                        phi_4996_ = true;
                        break;
                    }
                }
                let _e445 = phi_5003_;
                let _e447 = phi_4997_;
                let _e449 = phi_4996_;
                let _e454 = global_7.member[((3u * _e84) + _e88)];
                let _e457 = (_e454.y >> bitcast<u32>(24u));
                let _e471 = ((vec3<f32>(f32((_e454.x & 1023u)), f32(((_e454.x >> bitcast<u32>(10u)) & 1023u)), f32(((_e454.x >> bitcast<u32>(20u)) & 1023u))) - vec3<f32>(512f, 512f, 512f)) * vec3<f32>(0.0013888889f, 0.0013888889f, 0.0013888889f));
                let _e475 = sqrt(max((1f - dot(_e471, _e471)), 0f));
                let _e477 = (_e454.x >> bitcast<u32>(30u));
                if (_e477 == 0u) {
                    phi_5009_ = vec4<f32>(_e475, _e471.x, _e471.y, _e471.z);
                } else {
                    if (_e477 == 1u) {
                        phi_5008_ = vec4<f32>(_e471.x, _e475, _e471.y, _e471.z);
                    } else {
                        if (_e477 == 2u) {
                            phi_5007_ = vec4<f32>(_e471.x, _e471.y, _e475, _e471.z);
                        } else {
                            phi_5007_ = vec4<f32>(_e471.x, _e471.y, _e471.z, _e475);
                        }
                        let _e490 = phi_5007_;
                        phi_5008_ = _e490;
                    }
                    let _e496 = phi_5008_;
                    phi_5009_ = _e496;
                }
                let _e502 = phi_5009_;
                let _e506 = global.member_34;
                let _e507 = (_e506 > 0u);
                phi_5021_ = unpack4x8unorm(_e454.y).xyz;
                if _e507 {
                    let _e511 = global_7.member[(_e506 + _e88)];
                    let _e513 = unpack2x16float(_e511.x);
                    phi_5021_ = vec3<f32>(_e513.x, _e513.y, unpack2x16float(_e511.y).x);
                }
                let _e521 = phi_5021_;
                let _e524 = (1u << bitcast<u32>((_e88 & 31u)));
                let _e527 = global_7.member[_e92];
                let _e531 = global_7.member[(_e92 + 1u)];
                let _e535 = global_7.member[(_e92 + 2u)];
                phi_5038_ = _e502;
                if ((_e527.x & _e524) != 0u) {
                    let _e546 = global.member_22;
                    let _e548 = global.member_18;
                    let _e552 = (_e546 + ((_e531.y + bitcast<u32>(countOneBits((_e527.x & (_e524 - 1u))))) * (1u + (4u * _e548))));
                    let _e553 = (_e552 + 1u);
                    let _e556 = global_6.member[_e552];
                    let _e558 = global.member_40;
                    let _e562 = global.member_19;
                    phi_5023_ = vec4<f32>(0f, 0f, 0f, 0f);
                    phi_5022_ = 0u;
                    loop {
                        let _e566 = phi_5023_;
                        let _e568 = phi_5022_;
                        let _e570 = (2u * ((_e558 + ((_e556 >> bitcast<u32>(16u)) * _e562)) + _e568));
                        let _e573 = global_1.member[_e570];
                        let _e577 = global_1.member[(_e570 + 1u)];
                        let _e583 = bitcast<vec4<f32>>(vec4<u32>(_e573.x, _e573.y, _e577.x, _e577.y));
                        let _e587 = global_6.member[(_e553 + _e568)];
                        let _e594 = global_6.member[((_e553 + _e548) + _e568)];
                        let _e602 = global_6.member[((_e553 + (2u * _e548)) + _e568)];
                        let _e610 = global_6.member[((_e553 + (3u * _e548)) + _e568)];
                        let _e614 = (_e566 + vec4<f32>(dot(unpack4x8snorm(_e587), _e583), dot(unpack4x8snorm(_e594), _e583), dot(unpack4x8snorm(_e602), _e583), dot(unpack4x8snorm(_e610), _e583)));
                        let _e616 = (_e568 + bitcast<u32>(1i));
                        phi_5023_ = _e614;
                        phi_5022_ = _e616;
                        local = _e614;
                        if (_e616 < _e548) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e622 = local;
                    let _e624 = (_e502 + (_e622 * (127f * unpack2x16float(_e556).x)));
                    phi_5038_ = select(_e502, _e624, vec4((length(_e624) >= 0.001f)));
                }
                let _e630 = phi_5038_;
                phi_5042_ = _e261;
                if ((_e527.y & _e524) != 0u) {
                    let _e641 = global.member_23;
                    let _e643 = global.member_18;
                    let _e647 = (_e641 + ((_e535.x + bitcast<u32>(countOneBits((_e527.y & (_e524 - 1u))))) * (1u + (3u * _e643))));
                    let _e648 = (_e647 + 1u);
                    let _e651 = global_6.member[_e647];
                    let _e653 = global.member_40;
                    let _e657 = global.member_19;
                    phi_5026_ = vec3<f32>(0f, 0f, 0f);
                    phi_5025_ = 0u;
                    loop {
                        let _e661 = phi_5026_;
                        let _e663 = phi_5025_;
                        let _e665 = (2u * ((_e653 + ((_e651 >> bitcast<u32>(16u)) * _e657)) + _e663));
                        let _e668 = global_1.member[_e665];
                        let _e672 = global_1.member[(_e665 + 1u)];
                        let _e678 = bitcast<vec4<f32>>(vec4<u32>(_e668.x, _e668.y, _e672.x, _e672.y));
                        let _e682 = global_6.member[(_e648 + _e663)];
                        let _e689 = global_6.member[((_e648 + _e643) + _e663)];
                        let _e697 = global_6.member[((_e648 + (2u * _e643)) + _e663)];
                        let _e701 = (_e661 + vec3<f32>(dot(unpack4x8snorm(_e682), _e678), dot(unpack4x8snorm(_e689), _e678), dot(unpack4x8snorm(_e697), _e678)));
                        let _e703 = (_e663 + bitcast<u32>(1i));
                        phi_5026_ = _e701;
                        phi_5025_ = _e703;
                        local_1 = _e701;
                        if (_e703 < _e643) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e709 = local_1;
                    phi_5042_ = (_e261 + (_e709 * (127f * unpack2x16float(_e651).x)));
                }
                let _e713 = phi_5042_;
                phi_5044_ = _e521;
                if ((_e531.x & _e524) != 0u) {
                    let _e724 = global.member_24;
                    let _e726 = global.member_18;
                    let _e730 = (_e724 + ((_e535.y + bitcast<u32>(countOneBits((_e531.x & (_e524 - 1u))))) * (3u + (3u * _e726))));
                    let _e734 = global_6.member[(_e730 + 1u)];
                    let _e735 = unpack2x16float(_e734);
                    let _e739 = global_6.member[(_e730 + 2u)];
                    let _e747 = (_e730 + 3u);
                    let _e750 = global_6.member[_e730];
                    let _e752 = global.member_40;
                    let _e756 = global.member_19;
                    phi_5035_ = vec3<f32>(0f, 0f, 0f);
                    phi_5034_ = 0u;
                    loop {
                        let _e760 = phi_5035_;
                        let _e762 = phi_5034_;
                        let _e764 = (2u * ((_e752 + ((_e750 >> bitcast<u32>(16u)) * _e756)) + _e762));
                        let _e767 = global_1.member[_e764];
                        let _e771 = global_1.member[(_e764 + 1u)];
                        let _e777 = bitcast<vec4<f32>>(vec4<u32>(_e767.x, _e767.y, _e771.x, _e771.y));
                        let _e781 = global_6.member[(_e747 + _e762)];
                        let _e788 = global_6.member[((_e747 + _e726) + _e762)];
                        let _e796 = global_6.member[((_e747 + (2u * _e726)) + _e762)];
                        let _e800 = (_e760 + vec3<f32>(dot(unpack4x8snorm(_e781), _e777), dot(unpack4x8snorm(_e788), _e777), dot(unpack4x8snorm(_e796), _e777)));
                        let _e802 = (_e762 + bitcast<u32>(1i));
                        phi_5035_ = _e800;
                        phi_5034_ = _e802;
                        local_2 = _e800;
                        if (_e802 < _e726) {
                            continue;
                        } else {
                            break;
                        }
                    }
                    let _e808 = local_2;
                    phi_5044_ = (select(vec3<f32>(_e735.x, _e735.y, unpack2x16float(_e739).x), _e521, vec3(_e507)) + (_e808 * (127f * unpack2x16float(_e750).x)));
                }
                let _e812 = phi_5044_;
                let _e813 = normalize(_e630);
                let _e818 = (_e813.z * _e813.z);
                let _e819 = (_e813.w * _e813.w);
                let _e823 = (_e813.y * _e813.z);
                let _e824 = (_e813.x * _e813.w);
                let _e827 = (_e813.y * _e813.w);
                let _e828 = (_e813.x * _e813.z);
                let _e833 = (_e813.y * _e813.y);
                let _e837 = (_e813.z * _e813.w);
                let _e838 = (_e813.x * _e813.y);
                let _e852 = exp(min(_e713, vec3<f32>(9f, 9f, 9f)));
                let _e859 = mat3x3<f32>((vec3<f32>((1f - (2f * (_e818 + _e819))), (2f * (_e823 + _e824)), (2f * (_e827 - _e828))) * _e852.x), (vec3<f32>((2f * (_e823 - _e824)), (1f - (2f * (_e833 + _e819))), (2f * (_e837 + _e838))) * _e852.y), (vec3<f32>((2f * (_e827 + _e828)), (2f * (_e837 - _e838)), (1f - (2f * (_e833 + _e818)))) * _e852.z));
                let _e861 = (transpose(mat3x3<f32>(_e380, _e381, _e382)) * _e859);
                let _e863 = global.member_38;
                let _e865 = (_e863 + (3u * _e78));
                let _e866 = transpose(_e861);
                let _e875 = sqrt(max(max(dot(_e866[0], _e866[0]), dot(_e866[1], _e866[1])), dot(_e866[2], _e866[2])));
                let _e877 = global.member_39;
                let _e888 = (all((abs(_e370) < vec3<f32>(1000000000000000000000000000000f, 1000000000000000000000000000000f, 1000000000000000000000000000000f))) && (_e875 <= 1000000000000000000f));
                if _e888 {
                    let _e890 = global.member_51;
                    let _e894 = global.member_52;
                    phi_5045_ = ((_e370 - _e890.xyz) / _e894.xyz);
                } else {
                    phi_5045_ = vec3<f32>(0f, 0f, 0f);
                }
                let _e898 = phi_5045_;
                let _e915 = vec3<u32>(round((clamp(select(select((vec3<f32>(0.015625f, 0.015625f, 0.015625f) + (clamp(_e898, vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 0.96875f)), (vec3<f32>(0.015625f, 0.015625f, 0.015625f) / (vec3<f32>(1f, 1f, 1f) - min(_e898, vec3<f32>(0f, 0f, 0f)))), (_e898 < vec3<f32>(0f, 0f, 0f))), (vec3<f32>(1f, 1f, 1f) - (vec3<f32>(0.015625f, 0.015625f, 0.015625f) / max(_e898, vec3<f32>(1f, 1f, 1f)))), (_e898 > vec3<f32>(1f, 1f, 1f))), vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 16777215f)));
                let _e917 = (_e915 >> bitcast<vec3<u32>>(vec3<u32>(8u, 8u, 8u)));
                let _e918 = (_e915 & vec3<u32>(255u, 255u, 255u));
                let _e934 = ((_e917.z | (u32(clamp(select(0f, ceil(((8f * log2(max((_e875 / _e877), 0.000000000000000000000000000001f))) + 152f)), _e888), 0f, 255f)) << bitcast<u32>(16u))) | (select(0u, _e457, _e888) << bitcast<u32>(24u)));
                let _e951 = vec3<f32>(_e861[0].x, _e861[1].x, _e861[2].x);
                let _e958 = vec3<f32>(_e861[0].y, _e861[1].y, _e861[2].y);
                let _e965 = vec3<f32>(_e861[0].z, _e861[1].z, _e861[2].z);
                let _e966 = length(_e951);
                if (_e966 > 0f) {
                    phi_5047_ = (_e951 / vec3(_e966));
                } else {
                    phi_5047_ = vec3<f32>(0f, 0f, 0f);
                }
                let _e971 = phi_5047_;
                let _e972 = dot(_e958, _e971);
                let _e974 = (_e958 - (_e971 * _e972));
                let _e975 = length(_e974);
                if (_e975 > 0f) {
                    phi_5049_ = (_e974 / vec3(_e975));
                } else {
                    phi_5049_ = vec3<f32>(0f, 0f, 0f);
                }
                let _e980 = phi_5049_;
                let _e981 = dot(_e965, _e971);
                let _e982 = dot(_e965, _e980);
                let _e996 = (1023f / (_e877 * exp2(((f32(((_e934 >> bitcast<u32>(16u)) & 255u)) * 0.125f) - 19f))));
                let _e1014 = vec3<u32>(round((clamp(_e812, vec3<f32>(0f, 0f, 0f), vec3<f32>(1f, 1f, 1f)) * 1023f)));
                let _e1017 = ((vec3<u32>(clamp((round((vec3<f32>(_e966, _e975, _e982) * _e996)) + vec3<f32>(1023f, 1023f, 1023f)), vec3<f32>(0f, 0f, 0f), vec3<f32>(2046f, 2046f, 2046f))) | (vec3<u32>(clamp((round((vec3<f32>(_e972, _e981, length(((_e965 - (_e971 * _e981)) - (_e980 * _e982)))) * _e996)) + vec3<f32>(1023f, 1023f, 1023f)), vec3<f32>(0f, 0f, 0f), vec3<f32>(2046f, 2046f, 2046f))) << bitcast<vec3<u32>>(vec3<u32>(11u, 11u, 11u)))) | (_e1014 << bitcast<vec3<u32>>(vec3<u32>(22u, 22u, 22u))));
                global_4.member[_e865] = (_e917.x | (_e917.y << bitcast<u32>(16u)));
                global_4.member[(_e865 + 1u)] = _e934;
                global_4.member[(_e865 + 2u)] = ((_e918.x | (_e918.y << bitcast<u32>(8u))) | (_e918.z << bitcast<u32>(16u)));
                let _e1028 = (_e863 + (3u * (_e80 + _e78)));
                global_4.member[_e1028] = _e1017.x;
                global_4.member[(_e1028 + 1u)] = _e1017.y;
                global_4.member[(_e1028 + 2u)] = _e1017.z;
                phi_2869_ = _e449;
                if _e449 {
                    let _e1042 = global.member_29;
                    phi_2869_ = (f32(_e457) <= _e1042);
                }
                let _e1045 = phi_2869_;
                if _e1045 {
                    let _e1047 = global_3.member_9;
                    if (_e1047 != 0u) {
                        let _e1051 = atomicAdd((&global_2.member[1u]), 1u);
                    }
                }
                let _e1052 = !(_e449);
                phi_2883_ = _e1052;
                if !(_e1052) {
                    let _e1056 = global.member_29;
                    phi_2883_ = (f32(_e457) <= _e1056);
                }
                let _e1059 = phi_2883_;
                if _e1059 {
                    phi_5079_ = 4294967295u;
                    break;
                }
                switch bitcast<i32>(0u) {
                    default: {
                        let _e1065 = global.member_2;
                        let _e1067 = global.member_3;
                        let _e1068 = clamp((_e370.xy / vec2(_e369)), _e1065, _e1067);
                        let _e1071 = global.member[0u];
                        let _e1077 = (((_e380 - (_e382 * _e1068.x)) * (_e1071 / _e369)) * _e859);
                        let _e1080 = global.member[1u];
                        let _e1086 = (((_e381 - (_e382 * _e1068.y)) * (_e1080 / _e369)) * _e859);
                        let _e1088 = global.member_47;
                        let _e1090 = (dot(_e1077, _e1077) + _e1088);
                        let _e1093 = (dot(_e1086, _e1086) + _e1088);
                        let _e1095 = cross(_e1077, _e1086);
                        let _e1096 = dot(_e1095, _e1095);
                        let _e1100 = (_e1096 + (_e1088 * ((_e1090 + _e1093) - _e1088)));
                        let _e1101 = (_e1100 > 0f);
                        phi_4451_ = _e1101;
                        if _e1101 {
                            phi_4451_ = (_e1090 <= 1000000000000000000f);
                        }
                        let _e1104 = phi_4451_;
                        phi_4457_ = _e1104;
                        if _e1104 {
                            phi_4457_ = (_e1093 <= 1000000000000000000f);
                        }
                        let _e1107 = phi_4457_;
                        if !(_e1107) {
                            let _e1110 = global_3.member_9;
                            if (_e1110 != 0u) {
                                let _e1114 = atomicAdd((&global_2.member[2u]), 1u);
                            }
                            phi_5078_ = 4294967295u;
                            break;
                        }
                        phi_5064_ = (1f - (f32(_e457) * 0.003921569f));
                        phi_5063_ = 0u;
                        loop {
                            let _e1119 = phi_5064_;
                            let _e1121 = phi_5063_;
                            local_3 = _e1119;
                            if (_e1121 < _e86) {
                                continue;
                            } else {
                                break;
                            }
                            continuing {
                                phi_5064_ = (_e1119 * _e1119);
                                phi_5063_ = (_e1121 + bitcast<u32>(1i));
                            }
                        }
                        let _e1127 = local_3;
                        let _e1131 = u32(round((255f * (1f - _e1127))));
                        let _e1133 = global.member_48;
                        phi_5072_ = _e1131;
                        if (_e1133 > 0f) {
                            let _e1143 = u32(round((f32(_e1131) * ((1f - _e1133) + (_e1133 * sqrt((_e1096 / _e1100)))))));
                            let _e1146 = global.member_29;
                            if (f32(_e1143) <= _e1146) {
                                let _e1149 = global_3.member_9;
                                if (_e1149 != 0u) {
                                    let _e1153 = atomicAdd((&global_2.member[1u]), 1u);
                                }
                                phi_5078_ = 4294967295u;
                                break;
                            }
                            phi_5072_ = _e1143;
                        }
                        let _e1155 = phi_5072_;
                        let _e1157 = global.member_45;
                        let _e1158 = (vec3<f32>(_e1090, dot(_e1077, _e1086), _e1093) * _e1157);
                        let _e1163 = global.member_29;
                        let _e1173 = global.member_49;
                        let _e1174 = ((sqrt(_e1158.xz) * sqrt((2f * log(max((f32(_e1155) / _e1163), 1f))))) * _e1173);
                        let _e1177 = global.member_50;
                        let _e1180 = all(((_e447 + _e1174) > _e1177.xy));
                        phi_4535_ = _e1180;
                        if _e1180 {
                            phi_4535_ = all(((_e447 - _e1174) < _e1177.zw));
                        }
                        let _e1186 = phi_4535_;
                        if !(_e1186) {
                            let _e1189 = global_3.member_9;
                            if (_e1189 != 0u) {
                                let _e1193 = atomicAdd((&global_2.member[0u]), 1u);
                            }
                            phi_5078_ = 4294967295u;
                            break;
                        }
                        let _e1197 = (0.5f * (_e1158.x - _e1158.z));
                        let _e1202 = sqrt(((_e1197 * _e1197) + (_e1158.y * _e1158.y)));
                        let _e1205 = ((0.5f * (_e1158.x + _e1158.z)) + _e1202);
                        if (_e1197 >= 0f) {
                            phi_5076_ = vec2<f32>((_e1197 + _e1202), _e1158.y);
                        } else {
                            phi_5076_ = vec2<f32>(_e1158.y, (_e1202 - _e1197));
                        }
                        let _e1212 = phi_5076_;
                        if (_e1202 > (0.00000001f * _e1205)) {
                            phi_5077_ = normalize(_e1212);
                        } else {
                            phi_5077_ = vec2<f32>(1f, 0f);
                        }
                        let _e1217 = phi_5077_;
                        let _e1224 = global.member_5;
                        let _e1228 = global.member_10;
                        let _e1232 = vec2<u32>(clamp(round(((_e447 + vec2(_e1224)) * _e1228)), vec2<f32>(0f, 0f), vec2<f32>(1048575f, 1048575f)));
                        let _e1260 = global.member_41;
                        let _e1262 = (4u * (_e1260 + _e78));
                        global_4.member[_e1262] = ((_e1232.x | (_e1014.x << bitcast<u32>(20u))) | (_e1014.z << bitcast<u32>(30u)));
                        global_4.member[(_e1262 + 1u)] = (_e1232.y | (_e1014.y << bitcast<u32>(20u)));
                        global_4.member[(_e1262 + 2u)] = pack2x16float((_e1217 * min(sqrt(_e1205), 65504f)));
                        global_4.member[(_e1262 + 3u)] = ((pack2x16float(vec2<f32>(min(sqrt(((_e1100 * (_e1157 * _e1157)) / _e1205)), 65504f), 0f)) | (_e1155 << bitcast<u32>(16u))) | ((_e1014.z >> bitcast<u32>(2u)) << bitcast<u32>(24u)));
                        let _e1275 = global.member_9;
                        phi_5078_ = min(u32((_e445 * f32(_e1275))), _e1275);
                        break;
                    }
                }
                let _e1281 = phi_5078_;
                phi_5079_ = _e1281;
                break;
            }
        }
        let _e1283 = phi_5079_;
        phi_5080_ = _e1283;
    } else {
        phi_5080_ = 4294967295u;
    }
    let _e1285 = phi_5080_;
    switch bitcast<i32>(0u) {
        default: {
            let _e1288 = bitcast<u32>(param[0u]);
            let _e1290 = global.member_41;
            let _e1291 = (_e1290 + _e78);
            if (_e1285 != 4294967295u) {
                let _e1294 = global.member_37;
                let _e1298 = global.member_36;
                let _e1304 = atomicAdd((&global_2.member[((_e1298 + ((_e1291 / _e1294) * 256u)) + (_e1285 & 255u))]), 1u);
            }
            let _e1306 = global.member_35;
            if (_e1306 == 0u) {
                if (_e78 < (_e80 + (_e80 & 1u))) {
                    let _e1312 = global.member_28;
                    global_4.member[(_e1312 + _e1291)] = _e1285;
                }
                break;
            }
            global_5[_e1288] = _e1285;
            workgroupBarrier();
            let _e1318 = ((_e1288 & 1u) == 0u);
            if select(_e1318, _e81, _e1318) {
                let _e1321 = global.member_28;
                let _e1328 = global_5[(_e1288 + 1u)];
                global_4.member[(_e1321 + (_e1291 >> bitcast<u32>(1u)))] = ((_e1285 & 65535u) | (_e1328 << bitcast<u32>(16u)));
            }
            break;
        }
    }
    return;
}
