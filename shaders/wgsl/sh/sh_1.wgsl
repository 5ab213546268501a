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
    member: array<vec2<u32>, LENGTH_1_8>,
}

@group(0) @binding(0) 
var<uniform> global: type_14;
@group(0) @binding(4) 
var<storage> global_1: type_19;
@group(0) @binding(2) 
var<storage> global_2: type_21;
@group(0) @binding(1) 
var<storage, read_write> global_3: type_23;

@compute @workgroup_size(64, 1, 1) 
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
    var local: vec4<u32>;
    var local_1: vec4<f32>;
    var phi_1355_: vec4<f32>;
    var phi_1354_: vec4<f32>;
    var phi_1353_: vec4<f32>;
    var phi_1352_: u32;
    var local_2: vec4<f32>;
    var local_3: vec4<f32>;
    var local_4: vec4<f32>;
    var local_5: vec4<f32>;
    var local_6: vec4<f32>;
    var local_7: vec4<f32>;
    var local_8: vec4<f32>;
    var local_9: vec4<f32>;
    var local_10: vec4<f32>;
    var phi_1356_: vec3<f32>;

    switch bitcast<i32>(0u) {
        default: {
            let _e39 = bitcast<u32>(param[0u]);
            let _e41 = global.member_44;
            if (_e39 >= _e41) {
                break;
            }
            let _e44 = global.member_43;
            let _e46 = (_e39 << bitcast<u32>(_e44));
            let _e47 = (2u * _e46);
            let _e50 = global.member_14;
            let _e51 = (2u * _e50);
            let _e55 = global_3.member[_e47];
            let _e58 = global_3.member[(_e47 + 1u)];
            let _e61 = global_3.member[(_e51 + _e46)];
            local = (vec4<u32>(_e58.x, (_e58.x >> bitcast<u32>(8u)), (_e58.x >> bitcast<u32>(16u)), (_e58.x >> bitcast<u32>(24u))) & vec4<u32>(255u, 255u, 255u, 255u));
            let _e77 = (vec3<u32>(_e58.y, (_e58.y >> bitcast<u32>(8u)), (_e58.y >> bitcast<u32>(16u))) & vec3<u32>(255u, 255u, 255u));
            let _e78 = vec3<f32>(_e77);
            local_1 = (vec4<f32>(_e78.x, _e78.y, _e78.z, f32((((255u - _e77.x) - _e77.y) - _e77.z))) * vec4<f32>(0.003921569f, 0.003921569f, 0.003921569f, 0.003921569f));
            phi_1355_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_1354_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_1353_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_1352_ = 0u;
            loop {
                let _e92 = phi_1355_;
                let _e94 = phi_1354_;
                let _e96 = phi_1353_;
                let _e98 = phi_1352_;
                local_2 = _e96;
                local_3 = _e96;
                local_4 = _e96;
                local_5 = _e94;
                local_6 = _e94;
                local_7 = _e94;
                local_8 = _e92;
                local_9 = _e92;
                local_10 = _e92;
                if (_e98 < 4u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e101 = local[_e98];
                    let _e102 = (3u * _e101);
                    let _e104 = local_1[_e98];
                    let _e107 = global.member_58[_e102];
                    let _e110 = local_1[_e98];
                    let _e114 = global.member_58[(_e102 + 1u)];
                    let _e117 = local_1[_e98];
                    let _e121 = global.member_58[(_e102 + 2u)];
                    phi_1355_ = (_e92 + (_e121 * _e117));
                    phi_1354_ = (_e94 + (_e114 * _e110));
                    phi_1353_ = (_e96 + (_e107 * _e104));
                    phi_1352_ = (_e98 + bitcast<u32>(1i));
                }
            }
            let _e127 = global.member_15;
            let _e131 = bitcast<u32>(firstLeadingBit((max(_e127, 4096u) - 1u)));
            let _e132 = (_e131 + 1u);
            let _e133 = (15u - _e131);
            let _e147 = (vec2<u32>((32u << bitcast<u32>((2u * _e133))), (32u << bitcast<u32>(_e133))) - vec2<u32>(1u, 1u));
            let _e163 = (vec2<f32>(vec2<u32>(((((_e61.x >> bitcast<u32>(16u)) >> bitcast<u32>(((2u * _e132) - 16u))) << bitcast<u32>(5u)) | ((_e61.y >> bitcast<u32>(_e132)) & 31u)), ((_e61.y >> bitcast<u32>((_e131 + 6u))) & _e147.y))) / vec2<f32>(_e147));
            let _e167 = ((1f + (2f * _e163.x)) * 0.33333334f);
            let _e168 = (1f - _e167);
            let _e172 = (_e168 * (0.5f + (0.5f * _e163.y)));
            let _e181 = (vec3<u32>(_e61.x, (_e61.x >> bitcast<u32>(_e132)), _e61.y) & vec3(((1u << bitcast<u32>(_e132)) - 1u)));
            let _e193 = global.member_11;
            let _e196 = global.member_12;
            let _e202 = global.member_21;
            let _e203 = (2u * _e202);
            let _e207 = global_1.member[(_e203 + _e181.x)];
            let _e209 = unpack2x16float(_e207.x);
            let _e222 = global_1.member[(_e203 + _e181.y)];
            let _e224 = unpack2x16float(_e222.x);
            let _e237 = global_1.member[(_e203 + _e181.z)];
            let _e239 = unpack2x16float(_e237.x);
            let _e247 = ((((_e193.xyz + (_e196.xyz * vec3<f32>(f32((_e55.x & 65535u)), f32((_e55.x >> bitcast<u32>(16u))), f32((_e55.y & 65535u))))) + (vec3<f32>(_e209.x, _e209.y, unpack2x16float(_e207.y).x) * _e167)) + (vec3<f32>(_e224.x, _e224.y, unpack2x16float(_e222.y).x) * _e172)) + (vec3<f32>(_e239.x, _e239.y, unpack2x16float(_e237.y).x) * (_e168 - _e172)));
            let _e251 = vec4<f32>(_e247.x, _e247.y, _e247.z, 1f);
            let _e253 = local_2;
            let _e256 = local_3;
            let _e260 = local_5;
            let _e263 = local_6;
            let _e268 = local_8;
            let _e271 = local_9;
            let _e274 = (((_e256.xyz * dot(_e253, _e251)) + (_e263.xyz * dot(_e260, _e251))) + (_e271.xyz * dot(_e268, _e251)));
            let _e275 = length(_e274);
            if (_e275 > 0f) {
                phi_1356_ = (_e274 / vec3(_e275));
            } else {
                phi_1356_ = vec3<f32>(0f, 0f, 0f);
            }
            let _e280 = phi_1356_;
            let _e287 = (vec3<f32>(-(_e280.y), _e280.z, -(_e280.x)) * 0.48860252f);
            let _e293 = global_2.member[_e46];
            let _e295 = unpack2x16float(_e293.x);
            let _e297 = unpack2x16float(_e293.y);
            let _e306 = global_2.member[(_e46 + _e50)];
            let _e308 = unpack2x16float(_e306.x);
            let _e310 = unpack2x16float(_e306.y);
            let _e318 = global_2.member[(_e46 + _e51)];
            let _e320 = unpack2x16float(_e318.x);
            let _e322 = unpack2x16float(_e318.y);
            let _e339 = clamp(((((vec4<f32>(_e295.x, _e295.y, _e297.x, _e297.y).xyz * 1f) + (vec3<f32>(_e297.y, _e308.x, _e308.y) * _e287.x)) + (vec3<f32>(_e310.x, _e310.y, _e320.x) * _e287.y)) + (vec4<f32>(_e320.x, _e320.y, _e322.x, _e322.y).yzw * _e287.z)), vec3<f32>(0f, 0f, 0f), vec3<f32>(65504f, 65504f, 65504f));
            let _e341 = global.member_34;
            global_3.member[(_e341 + _e46)] = vec2<u32>(pack2x16float(_e339.xy), pack2x16float(vec2<f32>(_e339.z, 0f)));
            break;
        }
    }
    return;
}
