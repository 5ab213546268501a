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
    var phi_1185_: vec4<f32>;
    var phi_1184_: vec4<f32>;
    var phi_1183_: vec4<f32>;
    var phi_1182_: u32;
    var local_2: vec4<f32>;
    var local_3: vec4<f32>;
    var local_4: vec4<f32>;
    var local_5: vec4<f32>;
    var local_6: vec4<f32>;
    var local_7: vec4<f32>;
    var local_8: vec4<f32>;
    var local_9: vec4<f32>;
    var local_10: vec4<f32>;
    var phi_1186_: vec3<f32>;

    switch bitcast<i32>(0u) {
        default: {
            let _e35 = bitcast<u32>(param[0u]);
            let _e37 = global.member_14;
            if (_e35 >= _e37) {
                break;
            }
            let _e39 = (2u * _e35);
            let _e43 = global_3.member[_e39];
            let _e46 = global_3.member[(_e39 + 1u)];
            local = (vec4<u32>(_e46.x, (_e46.x >> bitcast<u32>(8u)), (_e46.x >> bitcast<u32>(16u)), (_e46.x >> bitcast<u32>(24u))) & vec4<u32>(255u, 255u, 255u, 255u));
            let _e62 = (vec3<u32>(_e46.y, (_e46.y >> bitcast<u32>(8u)), (_e46.y >> bitcast<u32>(16u))) & vec3<u32>(255u, 255u, 255u));
            let _e63 = vec3<f32>(_e62);
            local_1 = (vec4<f32>(_e63.x, _e63.y, _e63.z, f32((((255u - _e62.x) - _e62.y) - _e62.z))) * vec4<f32>(0.003921569f, 0.003921569f, 0.003921569f, 0.003921569f));
            phi_1185_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_1184_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_1183_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_1182_ = 0u;
            loop {
                let _e77 = phi_1185_;
                let _e79 = phi_1184_;
                let _e81 = phi_1183_;
                let _e83 = phi_1182_;
                local_2 = _e81;
                local_3 = _e81;
                local_4 = _e81;
                local_5 = _e79;
                local_6 = _e79;
                local_7 = _e79;
                local_8 = _e77;
                local_9 = _e77;
                local_10 = _e77;
                if (_e83 < 4u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e86 = local[_e83];
                    let _e87 = (3u * _e86);
                    let _e89 = local_1[_e83];
                    let _e92 = global.member_54[_e87];
                    let _e95 = local_1[_e83];
                    let _e99 = global.member_54[(_e87 + 1u)];
                    let _e102 = local_1[_e83];
                    let _e106 = global.member_54[(_e87 + 2u)];
                    phi_1185_ = (_e77 + (_e106 * _e102));
                    phi_1184_ = (_e79 + (_e99 * _e95));
                    phi_1183_ = (_e81 + (_e92 * _e89));
                    phi_1182_ = (_e83 + bitcast<u32>(1i));
                }
            }
            let _e112 = global.member_11;
            let _e115 = global.member_12;
            let _e128 = (_e112.xyz + (_e115.xyz * vec3<f32>(f32((_e43.x & 65535u)), f32((_e43.x >> bitcast<u32>(16u))), f32((_e43.y & 65535u)))));
            let _e132 = vec4<f32>(_e128.x, _e128.y, _e128.z, 1f);
            let _e134 = local_2;
            let _e137 = local_3;
            let _e141 = local_5;
            let _e144 = local_6;
            let _e149 = local_8;
            let _e152 = local_9;
            let _e155 = (((_e137.xyz * dot(_e134, _e132)) + (_e144.xyz * dot(_e141, _e132))) + (_e152.xyz * dot(_e149, _e132)));
            let _e156 = length(_e155);
            if (_e156 > 0f) {
                phi_1186_ = (_e155 / vec3(_e156));
            } else {
                phi_1186_ = vec3<f32>(0f, 0f, 0f);
            }
            let _e161 = phi_1186_;
            let _e165 = (_e161.x * _e161.x);
            let _e166 = (_e161.y * _e161.y);
            let _e171 = (vec3<f32>(-(_e161.y), _e161.z, -(_e161.x)) * 0.48860252f);
            let _e177 = global_1.member[_e35];
            let _e179 = unpack2x16float(_e177.x);
            let _e181 = unpack2x16float(_e177.y);
            let _e190 = global_1.member[(_e35 + _e37)];
            let _e192 = unpack2x16float(_e190.x);
            let _e194 = unpack2x16float(_e190.y);
            let _e199 = (2u * _e37);
            let _e203 = global_1.member[(_e35 + _e199)];
            let _e205 = unpack2x16float(_e203.x);
            let _e207 = unpack2x16float(_e203.y);
            let _e235 = ((3u * _e37) + _e35);
            let _e238 = global_1.member[_e235];
            let _e240 = unpack2x16float(_e238.x);
            let _e242 = unpack2x16float(_e238.y);
            let _e251 = global_1.member[(_e235 + _e37)];
            let _e253 = unpack2x16float(_e251.x);
            let _e255 = unpack2x16float(_e251.y);
            let _e263 = global_1.member[(_e235 + _e199)];
            let _e265 = unpack2x16float(_e263.x);
            let _e267 = unpack2x16float(_e263.y);
            let _e289 = global_2.member[_e35];
            let _e291 = unpack2x16float(_e289.x);
            let _e301 = clamp(((((((vec4<f32>(_e179.x, _e179.y, _e181.x, _e181.y).xyz * 1f) + (vec3<f32>(_e181.y, _e192.x, _e192.y) * _e171.x)) + (vec3<f32>(_e194.x, _e194.y, _e205.x) * _e171.y)) + (vec4<f32>(_e205.x, _e205.y, _e207.x, _e207.y).yzw * _e171.z)) + ((((vec4<f32>(_e240.x, _e240.y, _e242.x, _e242.y).xyz * ((1.0925485f * _e161.x) * _e161.y)) + (vec3<f32>(_e242.y, _e253.x, _e253.y) * ((-1.0925485f * _e161.y) * _e161.z))) + (vec3<f32>(_e255.x, _e255.y, _e265.x) * (0.31539157f * (((2f * (_e161.z * _e161.z)) - _e165) - _e166)))) + (vec4<f32>(_e265.x, _e265.y, _e267.x, _e267.y).yzw * ((-1.0925485f * _e161.x) * _e161.z)))) + (vec4<f32>(_e291.x, _e291.y, unpack2x16float(_e289.y).x, f32()).xyz * (0.54627424f * (_e165 - _e166)))), vec3<f32>(0f, 0f, 0f), vec3<f32>(65504f, 65504f, 65504f));
            let _e303 = global.member_38;
            global_3.member[(_e303 + _e35)] = vec2<u32>(pack2x16float(_e301.xy), pack2x16float(vec2<f32>(_e301.z, 0f)));
            break;
        }
    }
    return;
}
