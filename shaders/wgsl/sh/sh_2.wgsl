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
    member_56: array<type_9, 8>,
    member_57: array<vec4<f32>, 128>,
    member_58: array<vec4<f32>, 768>,
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
    var phi_1198_: vec4<f32>;
    var phi_1197_: vec4<f32>;
    var phi_1196_: vec4<f32>;
    var phi_1195_: u32;
    var local_2: vec4<f32>;
    var local_3: vec4<f32>;
    var local_4: vec4<f32>;
    var local_5: vec4<f32>;
    var local_6: vec4<f32>;
    var local_7: vec4<f32>;
    var local_8: vec4<f32>;
    var local_9: vec4<f32>;
    var local_10: vec4<f32>;
    var phi_1199_: vec3<f32>;

    switch bitcast<i32>(0u) {
        default: {
            let _e35 = bitcast<u32>(param[0u]);
            let _e37 = global.member_44;
            if (_e35 >= _e37) {
                break;
            }
            let _e40 = global.member_43;
            let _e42 = (_e35 << bitcast<u32>(_e40));
            let _e43 = (2u * _e42);
            let _e47 = global_3.member[_e43];
            let _e50 = global_3.member[(_e43 + 1u)];
            local = (vec4<u32>(_e50.x, (_e50.x >> bitcast<u32>(8u)), (_e50.x >> bitcast<u32>(16u)), (_e50.x >> bitcast<u32>(24u))) & vec4<u32>(255u, 255u, 255u, 255u));
            let _e66 = (vec3<u32>(_e50.y, (_e50.y >> bitcast<u32>(8u)), (_e50.y >> bitcast<u32>(16u))) & vec3<u32>(255u, 255u, 255u));
            let _e67 = vec3<f32>(_e66);
            local_1 = (vec4<f32>(_e67.x, _e67.y, _e67.z, f32((((255u - _e66.x) - _e66.y) - _e66.z))) * vec4<f32>(0.003921569f, 0.003921569f, 0.003921569f, 0.003921569f));
            phi_1198_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_1197_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_1196_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_1195_ = 0u;
            loop {
                let _e81 = phi_1198_;
                let _e83 = phi_1197_;
                let _e85 = phi_1196_;
                let _e87 = phi_1195_;
                local_2 = _e85;
                local_3 = _e85;
                local_4 = _e85;
                local_5 = _e83;
                local_6 = _e83;
                local_7 = _e83;
                local_8 = _e81;
                local_9 = _e81;
                local_10 = _e81;
                if (_e87 < 4u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e90 = local[_e87];
                    let _e91 = (3u * _e90);
                    let _e93 = local_1[_e87];
                    let _e96 = global.member_58[_e91];
                    let _e99 = local_1[_e87];
                    let _e103 = global.member_58[(_e91 + 1u)];
                    let _e106 = local_1[_e87];
                    let _e110 = global.member_58[(_e91 + 2u)];
                    phi_1198_ = (_e81 + (_e110 * _e106));
                    phi_1197_ = (_e83 + (_e103 * _e99));
                    phi_1196_ = (_e85 + (_e96 * _e93));
                    phi_1195_ = (_e87 + bitcast<u32>(1i));
                }
            }
            let _e126 = global.member_11;
            let _e129 = global.member_12;
            let _e132 = (_e126.xyz + (_e129.xyz * vec3<f32>(f32((_e47.x & 65535u)), f32((_e47.x >> bitcast<u32>(16u))), f32((_e47.y & 65535u)))));
            let _e136 = vec4<f32>(_e132.x, _e132.y, _e132.z, 1f);
            let _e138 = local_2;
            let _e141 = local_3;
            let _e145 = local_5;
            let _e148 = local_6;
            let _e153 = local_8;
            let _e156 = local_9;
            let _e159 = (((_e141.xyz * dot(_e138, _e136)) + (_e148.xyz * dot(_e145, _e136))) + (_e156.xyz * dot(_e153, _e136)));
            let _e160 = length(_e159);
            if (_e160 > 0f) {
                phi_1199_ = (_e159 / vec3(_e160));
            } else {
                phi_1199_ = vec3<f32>(0f, 0f, 0f);
            }
            let _e165 = phi_1199_;
            let _e169 = (_e165.x * _e165.x);
            let _e170 = (_e165.y * _e165.y);
            let _e175 = (vec3<f32>(-(_e165.y), _e165.z, -(_e165.x)) * 0.48860252f);
            let _e181 = global_1.member[_e42];
            let _e183 = unpack2x16float(_e181.x);
            let _e185 = unpack2x16float(_e181.y);
            let _e192 = global.member_14;
            let _e196 = global_1.member[(_e42 + _e192)];
            let _e198 = unpack2x16float(_e196.x);
            let _e200 = unpack2x16float(_e196.y);
            let _e205 = (2u * _e192);
            let _e209 = global_1.member[(_e42 + _e205)];
            let _e211 = unpack2x16float(_e209.x);
            let _e213 = unpack2x16float(_e209.y);
            let _e241 = ((3u * _e192) + _e42);
            let _e244 = global_1.member[_e241];
            let _e246 = unpack2x16float(_e244.x);
            let _e248 = unpack2x16float(_e244.y);
            let _e257 = global_1.member[(_e241 + _e192)];
            let _e259 = unpack2x16float(_e257.x);
            let _e261 = unpack2x16float(_e257.y);
            let _e269 = global_1.member[(_e241 + _e205)];
            let _e271 = unpack2x16float(_e269.x);
            let _e273 = unpack2x16float(_e269.y);
            let _e295 = global_2.member[_e42];
            let _e297 = unpack2x16float(_e295.x);
            let _e307 = clamp(((((((vec4<f32>(_e183.x, _e183.y, _e185.x, _e185.y).xyz * 1f) + (vec3<f32>(_e185.y, _e198.x, _e198.y) * _e175.x)) + (vec3<f32>(_e200.x, _e200.y, _e211.x) * _e175.y)) + (vec4<f32>(_e211.x, _e211.y, _e213.x, _e213.y).yzw * _e175.z)) + ((((vec4<f32>(_e246.x, _e246.y, _e248.x, _e248.y).xyz * ((1.0925485f * _e165.x) * _e165.y)) + (vec3<f32>(_e248.y, _e259.x, _e259.y) * ((-1.0925485f * _e165.y) * _e165.z))) + (vec3<f32>(_e261.x, _e261.y, _e271.x) * (0.31539157f * (((2f * (_e165.z * _e165.z)) - _e169) - _e170)))) + (vec4<f32>(_e271.x, _e271.y, _e273.x, _e273.y).yzw * ((-1.0925485f * _e165.x) * _e165.z)))) + (vec4<f32>(_e297.x, _e297.y, unpack2x16float(_e295.y).x, f32()).xyz * (0.54627424f * (_e169 - _e170)))), vec3<f32>(0f, 0f, 0f), vec3<f32>(65504f, 65504f, 65504f));
            let _e309 = global.member_34;
            global_3.member[(_e309 + _e42)] = vec2<u32>(pack2x16float(_e307.xy), pack2x16float(vec2<f32>(_e307.z, 0f)));
            break;
        }
    }
    return;
}
