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
    var phi_1603_: vec4<f32>;
    var phi_1602_: vec4<f32>;
    var phi_1601_: vec4<f32>;
    var phi_1600_: u32;
    var local_2: vec4<f32>;
    var local_3: vec4<f32>;
    var local_4: vec4<f32>;
    var local_5: vec4<f32>;
    var local_6: vec4<f32>;
    var local_7: vec4<f32>;
    var local_8: vec4<f32>;
    var local_9: vec4<f32>;
    var local_10: vec4<f32>;
    var phi_1604_: vec3<f32>;

    switch bitcast<i32>(0u) {
        default: {
            let _e45 = bitcast<u32>(param[0u]);
            let _e47 = global.member_44;
            if (_e45 >= _e47) {
                break;
            }
            let _e50 = global.member_43;
            let _e52 = (_e45 << bitcast<u32>(_e50));
            let _e53 = (2u * _e52);
            let _e56 = global.member_14;
            let _e57 = (2u * _e56);
            let _e61 = global_4.member[_e53];
            let _e64 = global_4.member[(_e53 + 1u)];
            let _e67 = global_4.member[(_e57 + _e52)];
            local = (vec4<u32>(_e64.x, (_e64.x >> bitcast<u32>(8u)), (_e64.x >> bitcast<u32>(16u)), (_e64.x >> bitcast<u32>(24u))) & vec4<u32>(255u, 255u, 255u, 255u));
            let _e83 = (vec3<u32>(_e64.y, (_e64.y >> bitcast<u32>(8u)), (_e64.y >> bitcast<u32>(16u))) & vec3<u32>(255u, 255u, 255u));
            let _e84 = vec3<f32>(_e83);
            local_1 = (vec4<f32>(_e84.x, _e84.y, _e84.z, f32((((255u - _e83.x) - _e83.y) - _e83.z))) * vec4<f32>(0.003921569f, 0.003921569f, 0.003921569f, 0.003921569f));
            phi_1603_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_1602_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_1601_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_1600_ = 0u;
            loop {
                let _e98 = phi_1603_;
                let _e100 = phi_1602_;
                let _e102 = phi_1601_;
                let _e104 = phi_1600_;
                local_2 = _e102;
                local_3 = _e102;
                local_4 = _e102;
                local_5 = _e100;
                local_6 = _e100;
                local_7 = _e100;
                local_8 = _e98;
                local_9 = _e98;
                local_10 = _e98;
                if (_e104 < 4u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e107 = local[_e104];
                    let _e108 = (3u * _e107);
                    let _e110 = local_1[_e104];
                    let _e113 = global.member_58[_e108];
                    let _e116 = local_1[_e104];
                    let _e120 = global.member_58[(_e108 + 1u)];
                    let _e123 = local_1[_e104];
                    let _e127 = global.member_58[(_e108 + 2u)];
                    phi_1603_ = (_e98 + (_e127 * _e123));
                    phi_1602_ = (_e100 + (_e120 * _e116));
                    phi_1601_ = (_e102 + (_e113 * _e110));
                    phi_1600_ = (_e104 + bitcast<u32>(1i));
                }
            }
            let _e133 = global.member_15;
            let _e137 = bitcast<u32>(firstLeadingBit((max(_e133, 4096u) - 1u)));
            let _e138 = (_e137 + 1u);
            let _e139 = (15u - _e137);
            let _e153 = (vec2<u32>((32u << bitcast<u32>((2u * _e139))), (32u << bitcast<u32>(_e139))) - vec2<u32>(1u, 1u));
            let _e169 = (vec2<f32>(vec2<u32>(((((_e67.x >> bitcast<u32>(16u)) >> bitcast<u32>(((2u * _e138) - 16u))) << bitcast<u32>(5u)) | ((_e67.y >> bitcast<u32>(_e138)) & 31u)), ((_e67.y >> bitcast<u32>((_e137 + 6u))) & _e153.y))) / vec2<f32>(_e153));
            let _e173 = ((1f + (2f * _e169.x)) * 0.33333334f);
            let _e174 = (1f - _e173);
            let _e178 = (_e174 * (0.5f + (0.5f * _e169.y)));
            let _e187 = (vec3<u32>(_e67.x, (_e67.x >> bitcast<u32>(_e138)), _e67.y) & vec3(((1u << bitcast<u32>(_e138)) - 1u)));
            let _e199 = global.member_11;
            let _e202 = global.member_12;
            let _e208 = global.member_21;
            let _e209 = (2u * _e208);
            let _e213 = global_1.member[(_e209 + _e187.x)];
            let _e215 = unpack2x16float(_e213.x);
            let _e228 = global_1.member[(_e209 + _e187.y)];
            let _e230 = unpack2x16float(_e228.x);
            let _e243 = global_1.member[(_e209 + _e187.z)];
            let _e245 = unpack2x16float(_e243.x);
            let _e253 = ((((_e199.xyz + (_e202.xyz * vec3<f32>(f32((_e61.x & 65535u)), f32((_e61.x >> bitcast<u32>(16u))), f32((_e61.y & 65535u))))) + (vec3<f32>(_e215.x, _e215.y, unpack2x16float(_e213.y).x) * _e173)) + (vec3<f32>(_e230.x, _e230.y, unpack2x16float(_e228.y).x) * _e178)) + (vec3<f32>(_e245.x, _e245.y, unpack2x16float(_e243.y).x) * (_e174 - _e178)));
            let _e257 = vec4<f32>(_e253.x, _e253.y, _e253.z, 1f);
            let _e259 = local_2;
            let _e262 = local_3;
            let _e266 = local_5;
            let _e269 = local_6;
            let _e274 = local_8;
            let _e277 = local_9;
            let _e280 = (((_e262.xyz * dot(_e259, _e257)) + (_e269.xyz * dot(_e266, _e257))) + (_e277.xyz * dot(_e274, _e257)));
            let _e281 = length(_e280);
            if (_e281 > 0f) {
                phi_1604_ = (_e280 / vec3(_e281));
            } else {
                phi_1604_ = vec3<f32>(0f, 0f, 0f);
            }
            let _e286 = phi_1604_;
            let _e290 = (_e286.x * _e286.x);
            let _e291 = (_e286.y * _e286.y);
            let _e296 = (vec3<f32>(-(_e286.y), _e286.z, -(_e286.x)) * 0.48860252f);
            let _e302 = global_2.member[_e52];
            let _e304 = unpack2x16float(_e302.x);
            let _e306 = unpack2x16float(_e302.y);
            let _e315 = global_2.member[(_e52 + _e56)];
            let _e317 = unpack2x16float(_e315.x);
            let _e319 = unpack2x16float(_e315.y);
            let _e327 = global_2.member[(_e52 + _e57)];
            let _e329 = unpack2x16float(_e327.x);
            let _e331 = unpack2x16float(_e327.y);
            let _e359 = ((3u * _e56) + _e52);
            let _e362 = global_2.member[_e359];
            let _e364 = unpack2x16float(_e362.x);
            let _e366 = unpack2x16float(_e362.y);
            let _e375 = global_2.member[(_e359 + _e56)];
            let _e377 = unpack2x16float(_e375.x);
            let _e379 = unpack2x16float(_e375.y);
            let _e387 = global_2.member[(_e359 + _e57)];
            let _e389 = unpack2x16float(_e387.x);
            let _e391 = unpack2x16float(_e387.y);
            let _e413 = global_3.member[_e52];
            let _e415 = unpack2x16float(_e413.x);
            let _e425 = clamp(((((((vec4<f32>(_e304.x, _e304.y, _e306.x, _e306.y).xyz * 1f) + (vec3<f32>(_e306.y, _e317.x, _e317.y) * _e296.x)) + (vec3<f32>(_e319.x, _e319.y, _e329.x) * _e296.y)) + (vec4<f32>(_e329.x, _e329.y, _e331.x, _e331.y).yzw * _e296.z)) + ((((vec4<f32>(_e364.x, _e364.y, _e366.x, _e366.y).xyz * ((1.0925485f * _e286.x) * _e286.y)) + (vec3<f32>(_e366.y, _e377.x, _e377.y) * ((-1.0925485f * _e286.y) * _e286.z))) + (vec3<f32>(_e379.x, _e379.y, _e389.x) * (0.31539157f * (((2f * (_e286.z * _e286.z)) - _e290) - _e291)))) + (vec4<f32>(_e389.x, _e389.y, _e391.x, _e391.y).yzw * ((-1.0925485f * _e286.x) * _e286.z)))) + (vec4<f32>(_e415.x, _e415.y, unpack2x16float(_e413.y).x, f32()).xyz * (0.54627424f * (_e290 - _e291)))), vec3<f32>(0f, 0f, 0f), vec3<f32>(65504f, 65504f, 65504f));
            let _e427 = global.member_34;
            global_4.member[(_e427 + _e52)] = vec2<u32>(pack2x16float(_e425.xy), pack2x16float(vec2<f32>(_e425.z, 0f)));
            break;
        }
    }
    return;
}
