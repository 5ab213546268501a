struct type_11 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_15 {
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
    member_52: array<type_11, 8>,
    member_53: array<vec4<f32>, 128>,
    member_54: array<vec4<f32>, 768>,
}

struct type_23 {
    member: array<vec2<u32>>,
}

@group(0) @binding(0) 
var<uniform> global: type_15;
@group(0) @binding(2) 
var<storage> global_1: type_23;
@group(0) @binding(3) 
var<storage> global_2: type_23;
var<private> global_3: vec3<u32>;
@group(0) @binding(1) 
var<storage, read_write> global_4: type_23;

fn function_() {
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
            let _e47 = global_3[0u];
            let _e49 = global.member_14;
            if (_e47 >= _e49) {
                break;
            }
            let _e51 = (2u * _e47);
            let _e55 = global_4.member[_e51];
            let _e58 = global_4.member[(_e51 + 1u)];
            local = (vec4<u32>(_e58.x, (_e58.x >> bitcast<u32>(8u)), (_e58.x >> bitcast<u32>(16u)), (_e58.x >> bitcast<u32>(24u))) & vec4<u32>(255u, 255u, 255u, 255u));
            let _e74 = (vec3<u32>(_e58.y, (_e58.y >> bitcast<u32>(8u)), (_e58.y >> bitcast<u32>(16u))) & vec3<u32>(255u, 255u, 255u));
            let _e75 = vec3<f32>(_e74);
            local_1 = (vec4<f32>(_e75.x, _e75.y, _e75.z, f32((((255u - _e74.x) - _e74.y) - _e74.z))) * vec4<f32>(0.003921569f, 0.003921569f, 0.003921569f, 0.003921569f));
            phi_1185_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_1184_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_1183_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_1182_ = 0u;
            loop {
                let _e89 = phi_1185_;
                let _e91 = phi_1184_;
                let _e93 = phi_1183_;
                let _e95 = phi_1182_;
                local_2 = _e93;
                local_3 = _e93;
                local_4 = _e93;
                local_5 = _e91;
                local_6 = _e91;
                local_7 = _e91;
                local_8 = _e89;
                local_9 = _e89;
                local_10 = _e89;
                if (_e95 < 4u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e98 = local[_e95];
                    let _e99 = (3u * _e98);
                    let _e101 = local_1[_e95];
                    let _e104 = global.member_54[_e99];
                    let _e107 = local_1[_e95];
                    let _e111 = global.member_54[(_e99 + 1u)];
                    let _e114 = local_1[_e95];
                    let _e118 = global.member_54[(_e99 + 2u)];
                    phi_1185_ = (_e89 + (_e118 * _e114));
                    phi_1184_ = (_e91 + (_e111 * _e107));
                    phi_1183_ = (_e93 + (_e104 * _e101));
                    phi_1182_ = (_e95 + bitcast<u32>(1i));
                }
            }
            let _e124 = global.member_11;
            let _e127 = global.member_12;
            let _e140 = (_e124.xyz + (_e127.xyz * vec3<f32>(f32((_e55.x & 65535u)), f32((_e55.x >> bitcast<u32>(16u))), f32((_e55.y & 65535u)))));
            let _e144 = vec4<f32>(_e140.x, _e140.y, _e140.z, 1f);
            let _e146 = local_2;
            let _e149 = local_3;
            let _e155 = local_5;
            let _e158 = local_6;
            let _e165 = local_8;
            let _e168 = local_9;
            let _e173 = (((_e149.xyz * dot(_e146, _e144)) + (_e158.xyz * dot(_e155, _e144))) + (_e168.xyz * dot(_e165, _e144)));
            let _e174 = length(_e173);
            if (_e174 > 0f) {
                phi_1186_ = (_e173 / vec3(_e174));
            } else {
                phi_1186_ = vec3<f32>(0f, 0f, 0f);
            }
            let _e179 = phi_1186_;
            let _e183 = (_e179.x * _e179.x);
            let _e184 = (_e179.y * _e179.y);
            let _e189 = (vec3<f32>(-(_e179.y), _e179.z, -(_e179.x)) * 0.48860252f);
            let _e195 = global_1.member[_e47];
            let _e197 = unpack2x16float(_e195.x);
            let _e199 = unpack2x16float(_e195.y);
            let _e208 = global_1.member[(_e47 + _e49)];
            let _e210 = unpack2x16float(_e208.x);
            let _e212 = unpack2x16float(_e208.y);
            let _e217 = (2u * _e49);
            let _e221 = global_1.member[(_e47 + _e217)];
            let _e223 = unpack2x16float(_e221.x);
            let _e225 = unpack2x16float(_e221.y);
            let _e253 = ((3u * _e49) + _e47);
            let _e256 = global_1.member[_e253];
            let _e258 = unpack2x16float(_e256.x);
            let _e260 = unpack2x16float(_e256.y);
            let _e269 = global_1.member[(_e253 + _e49)];
            let _e271 = unpack2x16float(_e269.x);
            let _e273 = unpack2x16float(_e269.y);
            let _e281 = global_1.member[(_e253 + _e217)];
            let _e283 = unpack2x16float(_e281.x);
            let _e285 = unpack2x16float(_e281.y);
            let _e307 = global_2.member[_e47];
            let _e309 = unpack2x16float(_e307.x);
            let _e319 = clamp(((((((vec4<f32>(_e197.x, _e197.y, _e199.x, _e199.y).xyz * 1f) + (vec3<f32>(_e199.y, _e210.x, _e210.y) * _e189.x)) + (vec3<f32>(_e212.x, _e212.y, _e223.x) * _e189.y)) + (vec4<f32>(_e223.x, _e223.y, _e225.x, _e225.y).yzw * _e189.z)) + ((((vec4<f32>(_e258.x, _e258.y, _e260.x, _e260.y).xyz * ((1.0925485f * _e179.x) * _e179.y)) + (vec3<f32>(_e260.y, _e271.x, _e271.y) * ((-1.0925485f * _e179.y) * _e179.z))) + (vec3<f32>(_e273.x, _e273.y, _e283.x) * (0.31539157f * (((2f * (_e179.z * _e179.z)) - _e183) - _e184)))) + (vec4<f32>(_e283.x, _e283.y, _e285.x, _e285.y).yzw * ((-1.0925485f * _e179.x) * _e179.z)))) + (vec4<f32>(_e309.x, _e309.y, unpack2x16float(_e307.y).x, f32()).xyz * (0.54627424f * (_e183 - _e184)))), vec3<f32>(0f, 0f, 0f), vec3<f32>(65504f, 65504f, 65504f));
            let _e321 = global.member_38;
            global_4.member[(_e321 + _e47)] = vec2<u32>(pack2x16float(_e319.xy), pack2x16float(vec2<f32>(_e319.z, 0f)));
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
    global_3 = param;
    function_();
}
