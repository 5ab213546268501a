struct type_10 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_14 {
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
    member_56: array<type_10, 8>,
    member_57: array<vec4<f32>, 128>,
    member_58: array<vec4<f32>, 768>,
}

struct type_17 {
    member: array<vec2<u32>>,
}

struct type_19 {
    member: array<vec2<u32>, LENGTH_4_8>,
}

struct type_21 {
    member: array<vec2<u32>, LENGTH_2_8>,
}

struct type_23 {
    member: array<vec2<u32>, LENGTH_3_8>,
}

struct type_25 {
    member: array<vec2<u32>, LENGTH_1_8>,
}

@group(0) @binding(0) 
var<uniform> global: type_14;
@group(0) @binding(4) 
var<storage> global_1: type_19;
@group(0) @binding(2) 
var<storage> global_2: type_21;
@group(0) @binding(3) 
var<storage> global_3: type_23;
@group(0) @binding(1) 
var<storage, read_write> global_4: type_25;

@compute @workgroup_size(64, 1, 1) 
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
    var local: vec4<u32>;
    var local_1: vec4<f32>;
    var phi_1733_: vec4<f32>;
    var phi_1732_: vec4<f32>;
    var phi_1731_: vec4<f32>;
    var phi_1730_: u32;
    var local_2: vec4<f32>;
    var local_3: vec4<f32>;
    var local_4: vec4<f32>;
    var local_5: vec4<f32>;
    var local_6: vec4<f32>;
    var local_7: vec4<f32>;
    var local_8: vec4<f32>;
    var local_9: vec4<f32>;
    var local_10: vec4<f32>;
    var phi_1734_: vec3<f32>;

    switch bitcast<i32>(0u) {
        default: {
            let _e51 = bitcast<u32>(param[0u]);
            let _e53 = global.member_44;
            if (_e51 >= _e53) {
                break;
            }
            let _e56 = global.member_43;
            let _e58 = (_e51 << bitcast<u32>(_e56));
            let _e59 = (2u * _e58);
            let _e62 = global.member_14;
            let _e63 = (2u * _e62);
            let _e67 = global_4.member[_e59];
            let _e70 = global_4.member[(_e59 + 1u)];
            let _e73 = global_4.member[(_e63 + _e58)];
            local = (vec4<u32>(_e70.x, (_e70.x >> bitcast<u32>(8u)), (_e70.x >> bitcast<u32>(16u)), (_e70.x >> bitcast<u32>(24u))) & vec4<u32>(255u, 255u, 255u, 255u));
            let _e89 = (vec3<u32>(_e70.y, (_e70.y >> bitcast<u32>(8u)), (_e70.y >> bitcast<u32>(16u))) & vec3<u32>(255u, 255u, 255u));
            let _e90 = vec3<f32>(_e89);
            local_1 = (vec4<f32>(_e90.x, _e90.y, _e90.z, f32((((255u - _e89.x) - _e89.y) - _e89.z))) * vec4<f32>(0.003921569f, 0.003921569f, 0.003921569f, 0.003921569f));
            phi_1733_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_1732_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_1731_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_1730_ = 0u;
            loop {
                let _e104 = phi_1733_;
                let _e106 = phi_1732_;
                let _e108 = phi_1731_;
                let _e110 = phi_1730_;
                local_2 = _e108;
                local_3 = _e108;
                local_4 = _e108;
                local_5 = _e106;
                local_6 = _e106;
                local_7 = _e106;
                local_8 = _e104;
                local_9 = _e104;
                local_10 = _e104;
                if (_e110 < 4u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e113 = local[_e110];
                    let _e114 = (3u * _e113);
                    let _e116 = local_1[_e110];
                    let _e119 = global.member_58[_e114];
                    let _e122 = local_1[_e110];
                    let _e126 = global.member_58[(_e114 + 1u)];
                    let _e129 = local_1[_e110];
                    let _e133 = global.member_58[(_e114 + 2u)];
                    phi_1733_ = (_e104 + (_e133 * _e129));
                    phi_1732_ = (_e106 + (_e126 * _e122));
                    phi_1731_ = (_e108 + (_e119 * _e116));
                    phi_1730_ = (_e110 + bitcast<u32>(1i));
                }
            }
            let _e139 = global.member_15;
            let _e143 = bitcast<u32>(firstLeadingBit((max(_e139, 4096u) - 1u)));
            let _e144 = (_e143 + 1u);
            let _e145 = (15u - _e143);
            let _e159 = (vec2<u32>((32u << bitcast<u32>((2u * _e145))), (32u << bitcast<u32>(_e145))) - vec2<u32>(1u, 1u));
            let _e175 = (vec2<f32>(vec2<u32>(((((_e73.x >> bitcast<u32>(16u)) >> bitcast<u32>(((2u * _e144) - 16u))) << bitcast<u32>(5u)) | ((_e73.y >> bitcast<u32>(_e144)) & 31u)), ((_e73.y >> bitcast<u32>((_e143 + 6u))) & _e159.y))) / vec2<f32>(_e159));
            let _e179 = ((1f + (2f * _e175.x)) * 0.33333334f);
            let _e180 = (1f - _e179);
            let _e184 = (_e180 * (0.5f + (0.5f * _e175.y)));
            let _e193 = (vec3<u32>(_e73.x, (_e73.x >> bitcast<u32>(_e144)), _e73.y) & vec3(((1u << bitcast<u32>(_e144)) - 1u)));
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
            let _e259 = ((((_e205.xyz + (_e208.xyz * vec3<f32>(f32((_e67.x & 65535u)), f32((_e67.x >> bitcast<u32>(16u))), f32((_e67.y & 65535u))))) + (vec3<f32>(_e221.x, _e221.y, unpack2x16float(_e219.y).x) * _e179)) + (vec3<f32>(_e236.x, _e236.y, unpack2x16float(_e234.y).x) * _e184)) + (vec3<f32>(_e251.x, _e251.y, unpack2x16float(_e249.y).x) * (_e180 - _e184)));
            let _e263 = vec4<f32>(_e259.x, _e259.y, _e259.z, 1f);
            let _e265 = local_2;
            let _e268 = local_3;
            let _e272 = local_5;
            let _e275 = local_6;
            let _e280 = local_8;
            let _e283 = local_9;
            let _e286 = (((_e268.xyz * dot(_e265, _e263)) + (_e275.xyz * dot(_e272, _e263))) + (_e283.xyz * dot(_e280, _e263)));
            let _e287 = length(_e286);
            if (_e287 > 0f) {
                phi_1734_ = (_e286 / vec3(_e287));
            } else {
                phi_1734_ = vec3<f32>(0f, 0f, 0f);
            }
            let _e292 = phi_1734_;
            let _e296 = (_e292.x * _e292.x);
            let _e297 = (_e292.y * _e292.y);
            let _e298 = (_e292.z * _e292.z);
            let _e302 = (vec3<f32>(-(_e292.y), _e292.z, -(_e292.x)) * 0.48860252f);
            let _e308 = global_2.member[_e58];
            let _e310 = unpack2x16float(_e308.x);
            let _e312 = unpack2x16float(_e308.y);
            let _e318 = (_e58 + _e62);
            let _e321 = global_2.member[_e318];
            let _e323 = unpack2x16float(_e321.x);
            let _e325 = unpack2x16float(_e321.y);
            let _e330 = (_e58 + _e63);
            let _e333 = global_2.member[_e330];
            let _e335 = unpack2x16float(_e333.x);
            let _e337 = unpack2x16float(_e333.y);
            let _e358 = (2f * _e298);
            let _e365 = ((3u * _e62) + _e58);
            let _e368 = global_2.member[_e365];
            let _e370 = unpack2x16float(_e368.x);
            let _e372 = unpack2x16float(_e368.y);
            let _e378 = (_e365 + _e62);
            let _e381 = global_2.member[_e378];
            let _e383 = unpack2x16float(_e381.x);
            let _e385 = unpack2x16float(_e381.y);
            let _e390 = (_e365 + _e63);
            let _e393 = global_2.member[_e390];
            let _e395 = unpack2x16float(_e393.x);
            let _e397 = unpack2x16float(_e393.y);
            let _e415 = (_e296 - _e297);
            let _e427 = (((4f * _e298) - _e296) - _e297);
            let _e444 = global_3.member[_e365];
            let _e446 = unpack2x16float(_e444.x);
            let _e448 = unpack2x16float(_e444.y);
            let _e456 = global_3.member[_e378];
            let _e458 = unpack2x16float(_e456.x);
            let _e460 = unpack2x16float(_e456.y);
            let _e467 = global_3.member[_e390];
            let _e469 = unpack2x16float(_e467.x);
            let _e471 = unpack2x16float(_e467.y);
            let _e491 = global_3.member[_e58];
            let _e493 = unpack2x16float(_e491.x);
            let _e495 = unpack2x16float(_e491.y);
            let _e503 = global_3.member[_e318];
            let _e505 = unpack2x16float(_e503.x);
            let _e507 = unpack2x16float(_e503.y);
            let _e514 = global_3.member[_e330];
            let _e516 = unpack2x16float(_e514.x);
            let _e518 = unpack2x16float(_e514.y);
            let _e536 = clamp((((((((vec4<f32>(_e310.x, _e310.y, _e312.x, _e312.y).xyz * 1f) + (vec3<f32>(_e312.y, _e323.x, _e323.y) * _e302.x)) + (vec3<f32>(_e325.x, _e325.y, _e335.x) * _e302.y)) + (vec4<f32>(_e335.x, _e335.y, _e337.x, _e337.y).yzw * _e302.z)) + ((((vec4<f32>(_e370.x, _e370.y, _e372.x, _e372.y).xyz * ((1.0925485f * _e292.x) * _e292.y)) + (vec3<f32>(_e372.y, _e383.x, _e383.y) * ((-1.0925485f * _e292.y) * _e292.z))) + (vec3<f32>(_e385.x, _e385.y, _e395.x) * (0.31539157f * ((_e358 - _e296) - _e297)))) + (vec4<f32>(_e395.x, _e395.y, _e397.x, _e397.y).yzw * ((-1.0925485f * _e292.x) * _e292.z)))) + ((((vec4<f32>(_e446.x, _e446.y, _e448.x, _e448.y).xyz * ((0.37317634f * _e292.z) * (_e358 - (3f * (_e296 + _e297))))) + (vec3<f32>(_e448.y, _e458.x, _e458.y) * ((-0.4570458f * _e292.x) * _e427))) + (vec3<f32>(_e460.x, _e460.y, _e469.x) * ((1.4453057f * _e292.z) * _e415))) + (vec4<f32>(_e469.x, _e469.y, _e471.x, _e471.y).yzw * ((-0.5900436f * _e292.x) * (_e296 - (3f * _e297)))))) + ((((vec4<f32>(_e493.x, _e493.y, _e495.x, _e495.y).xyz * (0.54627424f * _e415)) + (vec3<f32>(_e495.y, _e505.x, _e505.y) * ((-0.5900436f * _e292.y) * ((3f * _e296) - _e297)))) + (vec3<f32>(_e507.x, _e507.y, _e516.x) * (((2.8906114f * _e292.x) * _e292.y) * _e292.z))) + (vec4<f32>(_e516.x, _e516.y, _e518.x, _e518.y).yzw * ((-0.4570458f * _e292.y) * _e427)))), vec3<f32>(0f, 0f, 0f), vec3<f32>(65504f, 65504f, 65504f));
            let _e538 = global.member_34;
            global_4.member[(_e538 + _e58)] = vec2<u32>(pack2x16float(_e536.xy), pack2x16float(vec2<f32>(_e536.z, 0f)));
            break;
        }
    }
    return;
}
