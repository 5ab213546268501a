struct type_9 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_13 {
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
    member_47: vec4<f32>,
    member_48: vec4<f32>,
    member_49: array<vec4<f32>, 3>,
    member_50: array<vec4<u32>, 8>,
    member_51: array<vec4<u32>, 8>,
    member_52: array<type_9, 8>,
    member_53: array<vec4<f32>, 128>,
    member_54: array<vec4<f32>, 768>,
}

struct type_17 {
    member: array<vec2<u32>>,
}

struct type_19 {
    member: array<vec2<u32>, LENGTH_2_8>,
}

struct type_21 {
    member: array<vec2<u32>, LENGTH_3_8>,
}

struct type_23 {
    member: array<vec2<u32>, LENGTH_1_8>,
}

@group(0) @binding(0) 
var<uniform> global: type_13;
@group(0) @binding(2) 
var<storage> global_1: type_19;
@group(0) @binding(3) 
var<storage> global_2: type_21;
@group(0) @binding(1) 
var<storage, read_write> global_3: type_23;

@compute @workgroup_size(64, 1, 1) 
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
    var local: vec4<u32>;
    var local_1: vec4<f32>;
    var phi_1315_: vec4<f32>;
    var phi_1314_: vec4<f32>;
    var phi_1313_: vec4<f32>;
    var phi_1312_: u32;
    var local_2: vec4<f32>;
    var local_3: vec4<f32>;
    var local_4: vec4<f32>;
    var local_5: vec4<f32>;
    var local_6: vec4<f32>;
    var local_7: vec4<f32>;
    var local_8: vec4<f32>;
    var local_9: vec4<f32>;
    var local_10: vec4<f32>;
    var phi_1316_: vec3<f32>;

    switch bitcast<i32>(0u) {
        default: {
            let _e41 = bitcast<u32>(param[0u]);
            let _e43 = global.member_14;
            if (_e41 >= _e43) {
                break;
            }
            let _e45 = (2u * _e41);
            let _e49 = global_3.member[_e45];
            let _e52 = global_3.member[(_e45 + 1u)];
            local = (vec4<u32>(_e52.x, (_e52.x >> bitcast<u32>(8u)), (_e52.x >> bitcast<u32>(16u)), (_e52.x >> bitcast<u32>(24u))) & vec4<u32>(255u, 255u, 255u, 255u));
            let _e68 = (vec3<u32>(_e52.y, (_e52.y >> bitcast<u32>(8u)), (_e52.y >> bitcast<u32>(16u))) & vec3<u32>(255u, 255u, 255u));
            let _e69 = vec3<f32>(_e68);
            local_1 = (vec4<f32>(_e69.x, _e69.y, _e69.z, f32((((255u - _e68.x) - _e68.y) - _e68.z))) * vec4<f32>(0.003921569f, 0.003921569f, 0.003921569f, 0.003921569f));
            phi_1315_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_1314_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_1313_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_1312_ = 0u;
            loop {
                let _e83 = phi_1315_;
                let _e85 = phi_1314_;
                let _e87 = phi_1313_;
                let _e89 = phi_1312_;
                local_2 = _e87;
                local_3 = _e87;
                local_4 = _e87;
                local_5 = _e85;
                local_6 = _e85;
                local_7 = _e85;
                local_8 = _e83;
                local_9 = _e83;
                local_10 = _e83;
                if (_e89 < 4u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e92 = local[_e89];
                    let _e93 = (3u * _e92);
                    let _e95 = local_1[_e89];
                    let _e98 = global.member_54[_e93];
                    let _e101 = local_1[_e89];
                    let _e105 = global.member_54[(_e93 + 1u)];
                    let _e108 = local_1[_e89];
                    let _e112 = global.member_54[(_e93 + 2u)];
                    phi_1315_ = (_e83 + (_e112 * _e108));
                    phi_1314_ = (_e85 + (_e105 * _e101));
                    phi_1313_ = (_e87 + (_e98 * _e95));
                    phi_1312_ = (_e89 + bitcast<u32>(1i));
                }
            }
            let _e118 = global.member_11;
            let _e121 = global.member_12;
            let _e134 = (_e118.xyz + (_e121.xyz * vec3<f32>(f32((_e49.x & 65535u)), f32((_e49.x >> bitcast<u32>(16u))), f32((_e49.y & 65535u)))));
            let _e138 = vec4<f32>(_e134.x, _e134.y, _e134.z, 1f);
            let _e140 = local_2;
            let _e143 = local_3;
            let _e147 = local_5;
            let _e150 = local_6;
            let _e155 = local_8;
            let _e158 = local_9;
            let _e161 = (((_e143.xyz * dot(_e140, _e138)) + (_e150.xyz * dot(_e147, _e138))) + (_e158.xyz * dot(_e155, _e138)));
            let _e162 = length(_e161);
            if (_e162 > 0f) {
                phi_1316_ = (_e161 / vec3(_e162));
            } else {
                phi_1316_ = vec3<f32>(0f, 0f, 0f);
            }
            let _e167 = phi_1316_;
            let _e171 = (_e167.x * _e167.x);
            let _e172 = (_e167.y * _e167.y);
            let _e173 = (_e167.z * _e167.z);
            let _e177 = (vec3<f32>(-(_e167.y), _e167.z, -(_e167.x)) * 0.48860252f);
            let _e183 = global_1.member[_e41];
            let _e185 = unpack2x16float(_e183.x);
            let _e187 = unpack2x16float(_e183.y);
            let _e193 = (_e41 + _e43);
            let _e196 = global_1.member[_e193];
            let _e198 = unpack2x16float(_e196.x);
            let _e200 = unpack2x16float(_e196.y);
            let _e205 = (2u * _e43);
            let _e206 = (_e41 + _e205);
            let _e209 = global_1.member[_e206];
            let _e211 = unpack2x16float(_e209.x);
            let _e213 = unpack2x16float(_e209.y);
            let _e234 = (2f * _e173);
            let _e241 = ((3u * _e43) + _e41);
            let _e244 = global_1.member[_e241];
            let _e246 = unpack2x16float(_e244.x);
            let _e248 = unpack2x16float(_e244.y);
            let _e254 = (_e241 + _e43);
            let _e257 = global_1.member[_e254];
            let _e259 = unpack2x16float(_e257.x);
            let _e261 = unpack2x16float(_e257.y);
            let _e266 = (_e241 + _e205);
            let _e269 = global_1.member[_e266];
            let _e271 = unpack2x16float(_e269.x);
            let _e273 = unpack2x16float(_e269.y);
            let _e291 = (_e171 - _e172);
            let _e303 = (((4f * _e173) - _e171) - _e172);
            let _e320 = global_2.member[_e241];
            let _e322 = unpack2x16float(_e320.x);
            let _e324 = unpack2x16float(_e320.y);
            let _e332 = global_2.member[_e254];
            let _e334 = unpack2x16float(_e332.x);
            let _e336 = unpack2x16float(_e332.y);
            let _e343 = global_2.member[_e266];
            let _e345 = unpack2x16float(_e343.x);
            let _e347 = unpack2x16float(_e343.y);
            let _e367 = global_2.member[_e41];
            let _e369 = unpack2x16float(_e367.x);
            let _e371 = unpack2x16float(_e367.y);
            let _e379 = global_2.member[_e193];
            let _e381 = unpack2x16float(_e379.x);
            let _e383 = unpack2x16float(_e379.y);
            let _e390 = global_2.member[_e206];
            let _e392 = unpack2x16float(_e390.x);
            let _e394 = unpack2x16float(_e390.y);
            let _e412 = clamp((((((((vec4<f32>(_e185.x, _e185.y, _e187.x, _e187.y).xyz * 1f) + (vec3<f32>(_e187.y, _e198.x, _e198.y) * _e177.x)) + (vec3<f32>(_e200.x, _e200.y, _e211.x) * _e177.y)) + (vec4<f32>(_e211.x, _e211.y, _e213.x, _e213.y).yzw * _e177.z)) + ((((vec4<f32>(_e246.x, _e246.y, _e248.x, _e248.y).xyz * ((1.0925485f * _e167.x) * _e167.y)) + (vec3<f32>(_e248.y, _e259.x, _e259.y) * ((-1.0925485f * _e167.y) * _e167.z))) + (vec3<f32>(_e261.x, _e261.y, _e271.x) * (0.31539157f * ((_e234 - _e171) - _e172)))) + (vec4<f32>(_e271.x, _e271.y, _e273.x, _e273.y).yzw * ((-1.0925485f * _e167.x) * _e167.z)))) + ((((vec4<f32>(_e322.x, _e322.y, _e324.x, _e324.y).xyz * ((0.37317634f * _e167.z) * (_e234 - (3f * (_e171 + _e172))))) + (vec3<f32>(_e324.y, _e334.x, _e334.y) * ((-0.4570458f * _e167.x) * _e303))) + (vec3<f32>(_e336.x, _e336.y, _e345.x) * ((1.4453057f * _e167.z) * _e291))) + (vec4<f32>(_e345.x, _e345.y, _e347.x, _e347.y).yzw * ((-0.5900436f * _e167.x) * (_e171 - (3f * _e172)))))) + ((((vec4<f32>(_e369.x, _e369.y, _e371.x, _e371.y).xyz * (0.54627424f * _e291)) + (vec3<f32>(_e371.y, _e381.x, _e381.y) * ((-0.5900436f * _e167.y) * ((3f * _e171) - _e172)))) + (vec3<f32>(_e383.x, _e383.y, _e392.x) * (((2.8906114f * _e167.x) * _e167.y) * _e167.z))) + (vec4<f32>(_e392.x, _e392.y, _e394.x, _e394.y).yzw * ((-0.4570458f * _e167.y) * _e303)))), vec3<f32>(0f, 0f, 0f), vec3<f32>(65504f, 65504f, 65504f));
            let _e414 = global.member_38;
            global_3.member[(_e414 + _e41)] = vec2<u32>(pack2x16float(_e412.xy), pack2x16float(vec2<f32>(_e412.z, 0f)));
            break;
        }
    }
    return;
}
