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
    member_52: f32,
    member_53: f32,
    member_54: vec4<f32>,
    member_55: vec4<f32>,
    member_56: vec4<f32>,
    member_57: array<vec4<f32>, 3>,
    member_58: array<vec4<u32>, 8>,
    member_59: array<vec4<u32>, 8>,
    member_60: array<type_12, 8>,
    member_61: array<vec4<f32>, 128>,
    member_62: array<vec4<f32>, 768>,
}

struct type_23 {
    member: array<vec2<u32>>,
}

struct type_30 {
    member: array<vec4<u32>>,
}

struct type_36 {
    @builtin(position) member: vec4<f32>,
    member_1: f32,
    member_2: array<f32, 1>,
    member_3: array<f32, 1>,
}

struct type_40 {
    member: array<vec2<u32>, LENGTH_2_8>,
}

struct type_42 {
    member: array<vec4<u32>, LENGTH_1_16>,
}

@group(0) @binding(0) 
var<uniform> global: type_16;
@group(0) @binding(2) 
var<storage> global_1: type_40;
@group(0) @binding(1) 
var<storage> global_2: type_42;
var<private> global_3: i32;
var<private> global_4: type_36 = type_36(vec4<f32>(0f, 0f, 0f, 1f), 1f, array<f32, 1>(), array<f32, 1>());

fn function_() {
    var local: vec4<u32>;
    var local_1: vec4<f32>;
    var local_2: vec4<u32>;
    var local_3: vec4<f32>;
    var local_4: vec4<u32>;
    var local_5: vec4<f32>;
    var phi_1358_: mat3x4<f32>;
    var phi_1357_: u32;
    var local_6: mat3x4<f32>;
    var local_7: mat3x4<f32>;
    var local_8: mat3x4<f32>;
    var phi_1360_: mat3x4<f32>;
    var phi_1359_: u32;
    var local_9: mat3x4<f32>;
    var phi_1362_: mat3x4<f32>;
    var phi_1361_: u32;
    var local_10: mat3x4<f32>;
    var phi_1363_: f32;
    var phi_1364_: f32;
    var phi_1365_: f32;

    let _e44 = global_3;
    let _e46 = (2u * bitcast<u32>(_e44));
    let _e49 = global_2.member[_e46];
    let _e53 = global_2.member[(_e46 + 1u)];
    let _e65 = global.member_11;
    let _e66 = _e65.xyz;
    let _e68 = global.member_12;
    let _e69 = _e68.xyz;
    let _e71 = (_e66 + (_e69 * vec3<f32>(f32((_e49.x & 65535u)), f32((_e49.x >> bitcast<u32>(16u))), f32((_e49.y & 65535u)))));
    local_4 = (vec4<u32>(_e49.z, (_e49.z >> bitcast<u32>(8u)), (_e49.z >> bitcast<u32>(16u)), (_e49.z >> bitcast<u32>(24u))) & vec4<u32>(255u, 255u, 255u, 255u));
    local_5 = unpack4x8unorm(_e49.w);
    phi_1358_ = mat3x4<f32>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
    phi_1357_ = 0u;
    loop {
        let _e84 = phi_1358_;
        let _e86 = phi_1357_;
        local_6 = _e84;
        local_7 = _e84;
        local_8 = _e84;
        if (_e86 < 4u) {
            continue;
        } else {
            break;
        }
        continuing {
            let _e89 = local_4[_e86];
            let _e90 = (3u * _e89);
            let _e92 = local_5[_e86];
            let _e95 = global.member_62[_e90];
            let _e99 = global.member_62[(_e90 + 1u)];
            let _e103 = global.member_62[(_e90 + 2u)];
            let _e105 = (mat3x4<f32>(_e95, _e99, _e103) * _e92);
            phi_1358_ = mat3x4<f32>((_e84[0] + _e105[0]), (_e84[1] + _e105[1]), (_e84[2] + _e105[2]));
            phi_1357_ = (_e86 + bitcast<u32>(1i));
        }
    }
    let _e119 = unpack2x16unorm(_e53.z);
    let _e124 = global.member_21;
    let _e125 = (2u * _e124);
    let _e129 = global_1.member[(_e125 + (_e53.x & 65535u))];
    let _e131 = unpack2x16float(_e129.x);
    let _e145 = global_1.member[(_e125 + (_e53.x >> bitcast<u32>(16u)))];
    let _e147 = unpack2x16float(_e145.x);
    let _e162 = global_1.member[(_e125 + _e53.y)];
    let _e164 = unpack2x16float(_e162.x);
    let _e173 = (_e71 + (((vec3<f32>(_e131.x, _e131.y, unpack2x16float(_e129.y).x) * _e119.x) + (vec3<f32>(_e147.x, _e147.y, unpack2x16float(_e145.y).x) * _e119.y)) + (vec3<f32>(_e164.x, _e164.y, unpack2x16float(_e162.y).x) * ((1f - _e119.x) - _e119.y))));
    let _e179 = local_6;
    let _e180 = (vec4<f32>(_e173.x, _e173.y, _e173.z, 1f) * _e179);
    let _e185 = (2u * (_e53.w & 65535u));
    let _e188 = global_2.member[_e185];
    let _e200 = (_e66 + (_e69 * vec3<f32>(f32((_e188.x & 65535u)), f32((_e188.x >> bitcast<u32>(16u))), f32((_e188.y & 65535u)))));
    let _e201 = (_e200 - _e71);
    let _e207 = local_7;
    let _e209 = (2u * (_e53.w >> bitcast<u32>(16u)));
    let _e212 = global_2.member[_e209];
    let _e224 = (_e66 + (_e69 * vec3<f32>(f32((_e212.x & 65535u)), f32((_e212.x >> bitcast<u32>(16u))), f32((_e212.y & 65535u)))));
    let _e225 = (_e224 - _e71);
    let _e231 = local_8;
    let _e238 = global_2.member[(_e185 + 1u)];
    let _e240 = unpack2x16unorm(_e238.z);
    let _e247 = global_1.member[(_e125 + (_e238.x & 65535u))];
    let _e249 = unpack2x16float(_e247.x);
    let _e263 = global_1.member[(_e125 + (_e238.x >> bitcast<u32>(16u)))];
    let _e265 = unpack2x16float(_e263.x);
    let _e280 = global_1.member[(_e125 + _e238.y)];
    let _e282 = unpack2x16float(_e280.x);
    let _e291 = (_e200 + (((vec3<f32>(_e249.x, _e249.y, unpack2x16float(_e247.y).x) * _e240.x) + (vec3<f32>(_e265.x, _e265.y, unpack2x16float(_e263.y).x) * _e240.y)) + (vec3<f32>(_e282.x, _e282.y, unpack2x16float(_e280.y).x) * ((1f - _e240.x) - _e240.y))));
    local_2 = (vec4<u32>(_e188.z, (_e188.z >> bitcast<u32>(8u)), (_e188.z >> bitcast<u32>(16u)), (_e188.z >> bitcast<u32>(24u))) & vec4<u32>(255u, 255u, 255u, 255u));
    local_3 = unpack4x8unorm(_e188.w);
    phi_1360_ = mat3x4<f32>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
    phi_1359_ = 0u;
    loop {
        let _e308 = phi_1360_;
        let _e310 = phi_1359_;
        local_9 = _e308;
        if (_e310 < 4u) {
            continue;
        } else {
            break;
        }
        continuing {
            let _e313 = local_2[_e310];
            let _e314 = (3u * _e313);
            let _e316 = local_3[_e310];
            let _e319 = global.member_62[_e314];
            let _e323 = global.member_62[(_e314 + 1u)];
            let _e327 = global.member_62[(_e314 + 2u)];
            let _e329 = (mat3x4<f32>(_e319, _e323, _e327) * _e316);
            phi_1360_ = mat3x4<f32>((_e308[0] + _e329[0]), (_e308[1] + _e329[1]), (_e308[2] + _e329[2]));
            phi_1359_ = (_e310 + bitcast<u32>(1i));
        }
    }
    let _e343 = local_9;
    let _e349 = global_2.member[(_e209 + 1u)];
    let _e351 = unpack2x16unorm(_e349.z);
    let _e358 = global_1.member[(_e125 + (_e349.x & 65535u))];
    let _e360 = unpack2x16float(_e358.x);
    let _e374 = global_1.member[(_e125 + (_e349.x >> bitcast<u32>(16u)))];
    let _e376 = unpack2x16float(_e374.x);
    let _e391 = global_1.member[(_e125 + _e349.y)];
    let _e393 = unpack2x16float(_e391.x);
    let _e402 = (_e224 + (((vec3<f32>(_e360.x, _e360.y, unpack2x16float(_e358.y).x) * _e351.x) + (vec3<f32>(_e376.x, _e376.y, unpack2x16float(_e374.y).x) * _e351.y)) + (vec3<f32>(_e393.x, _e393.y, unpack2x16float(_e391.y).x) * ((1f - _e351.x) - _e351.y))));
    local = (vec4<u32>(_e212.z, (_e212.z >> bitcast<u32>(8u)), (_e212.z >> bitcast<u32>(16u)), (_e212.z >> bitcast<u32>(24u))) & vec4<u32>(255u, 255u, 255u, 255u));
    local_1 = unpack4x8unorm(_e212.w);
    phi_1362_ = mat3x4<f32>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f));
    phi_1361_ = 0u;
    loop {
        let _e419 = phi_1362_;
        let _e421 = phi_1361_;
        local_10 = _e419;
        if (_e421 < 4u) {
            continue;
        } else {
            break;
        }
        continuing {
            let _e424 = local[_e421];
            let _e425 = (3u * _e424);
            let _e427 = local_1[_e421];
            let _e430 = global.member_62[_e425];
            let _e434 = global.member_62[(_e425 + 1u)];
            let _e438 = global.member_62[(_e425 + 2u)];
            let _e440 = (mat3x4<f32>(_e430, _e434, _e438) * _e427);
            phi_1362_ = mat3x4<f32>((_e419[0] + _e440[0]), (_e419[1] + _e440[1]), (_e419[2] + _e440[2]));
            phi_1361_ = (_e421 + bitcast<u32>(1i));
        }
    }
    let _e454 = local_10;
    let _e457 = cross(((vec4<f32>(_e291.x, _e291.y, _e291.z, 1f) * _e343) - _e180), ((vec4<f32>(_e402.x, _e402.y, _e402.z, 1f) * _e454) - _e180));
    let _e458 = cross((vec4<f32>(_e201.x, _e201.y, _e201.z, 0f) * _e207), (vec4<f32>(_e225.x, _e225.y, _e225.z, 0f) * _e231));
    let _e464 = global.member;
    let _e468 = global.member_1;
    if ((dot(_e457, _e457) / dot(_e458, _e458)) <= unpack2x16float(_e49.y).y) {
        let _e473 = global.member_30;
        let _e476 = global.member_7;
        let _e479 = global.member_8;
        let _e480 = ((_e476 - (_e180.z + _e473)) * _e479);
        if (_e480 < 0f) {
            phi_1364_ = (0.015625f / (1f - _e480));
        } else {
            if (_e480 > 1f) {
                phi_1363_ = (1f - (0.015625f / _e480));
            } else {
                phi_1363_ = (0.015625f + (0.96875f * clamp(_e480, 0f, 1f)));
            }
            let _e491 = phi_1363_;
            phi_1364_ = _e491;
        }
        let _e493 = phi_1364_;
        phi_1365_ = (1f - _e493);
    } else {
        phi_1365_ = 1f;
    }
    let _e496 = phi_1365_;
    let _e498 = global.member_32;
    let _e502 = global.member_33;
    let _e507 = (((((((_e464 * _e180.xy) + (_e468 * _e180.z)) - (_e498 * _e180.z)) * _e502) * 2f) * vec2<f32>(0.0052083335f, 0.0052083335f)) - vec2(_e180.z));
    global_4.member = vec4<f32>(_e507.x, _e507.y, (_e496 * _e180.z), _e180.z);
    return;
}

@vertex 
fn main(@builtin(vertex_index) param: u32) -> @builtin(position) vec4<f32> {
    global_3 = i32(param);
    function_();
    let _e6 = global_4.member.y;
    global_4.member.y = -(_e6);
    let _e8 = global_4.member;
    return _e8;
}
