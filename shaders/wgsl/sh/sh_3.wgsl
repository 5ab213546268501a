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
    var phi_1328_: vec4<f32>;
    var phi_1327_: vec4<f32>;
    var phi_1326_: vec4<f32>;
    var phi_1325_: u32;
    var local_2: vec4<f32>;
    var local_3: vec4<f32>;
    var local_4: vec4<f32>;
    var local_5: vec4<f32>;
    var local_6: vec4<f32>;
    var local_7: vec4<f32>;
    var local_8: vec4<f32>;
    var local_9: vec4<f32>;
    var local_10: vec4<f32>;
    var phi_1329_: vec3<f32>;

    switch bitcast<i32>(0u) {
        default: {
            let _e41 = bitcast<u32>(param[0u]);
            let _e43 = global.member_44;
            if (_e41 >= _e43) {
                break;
            }
            let _e46 = global.member_43;
            let _e48 = (_e41 << bitcast<u32>(_e46));
            let _e49 = (2u * _e48);
            let _e53 = global_3.member[_e49];
            let _e56 = global_3.member[(_e49 + 1u)];
            local = (vec4<u32>(_e56.x, (_e56.x >> bitcast<u32>(8u)), (_e56.x >> bitcast<u32>(16u)), (_e56.x >> bitcast<u32>(24u))) & vec4<u32>(255u, 255u, 255u, 255u));
            let _e72 = (vec3<u32>(_e56.y, (_e56.y >> bitcast<u32>(8u)), (_e56.y >> bitcast<u32>(16u))) & vec3<u32>(255u, 255u, 255u));
            let _e73 = vec3<f32>(_e72);
            local_1 = (vec4<f32>(_e73.x, _e73.y, _e73.z, f32((((255u - _e72.x) - _e72.y) - _e72.z))) * vec4<f32>(0.003921569f, 0.003921569f, 0.003921569f, 0.003921569f));
            phi_1328_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_1327_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_1326_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_1325_ = 0u;
            loop {
                let _e87 = phi_1328_;
                let _e89 = phi_1327_;
                let _e91 = phi_1326_;
                let _e93 = phi_1325_;
                local_2 = _e91;
                local_3 = _e91;
                local_4 = _e91;
                local_5 = _e89;
                local_6 = _e89;
                local_7 = _e89;
                local_8 = _e87;
                local_9 = _e87;
                local_10 = _e87;
                if (_e93 < 4u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e96 = local[_e93];
                    let _e97 = (3u * _e96);
                    let _e99 = local_1[_e93];
                    let _e102 = global.member_58[_e97];
                    let _e105 = local_1[_e93];
                    let _e109 = global.member_58[(_e97 + 1u)];
                    let _e112 = local_1[_e93];
                    let _e116 = global.member_58[(_e97 + 2u)];
                    phi_1328_ = (_e87 + (_e116 * _e112));
                    phi_1327_ = (_e89 + (_e109 * _e105));
                    phi_1326_ = (_e91 + (_e102 * _e99));
                    phi_1325_ = (_e93 + bitcast<u32>(1i));
                }
            }
            let _e132 = global.member_11;
            let _e135 = global.member_12;
            let _e138 = (_e132.xyz + (_e135.xyz * vec3<f32>(f32((_e53.x & 65535u)), f32((_e53.x >> bitcast<u32>(16u))), f32((_e53.y & 65535u)))));
            let _e142 = vec4<f32>(_e138.x, _e138.y, _e138.z, 1f);
            let _e144 = local_2;
            let _e147 = local_3;
            let _e151 = local_5;
            let _e154 = local_6;
            let _e159 = local_8;
            let _e162 = local_9;
            let _e165 = (((_e147.xyz * dot(_e144, _e142)) + (_e154.xyz * dot(_e151, _e142))) + (_e162.xyz * dot(_e159, _e142)));
            let _e166 = length(_e165);
            if (_e166 > 0f) {
                phi_1329_ = (_e165 / vec3(_e166));
            } else {
                phi_1329_ = vec3<f32>(0f, 0f, 0f);
            }
            let _e171 = phi_1329_;
            let _e175 = (_e171.x * _e171.x);
            let _e176 = (_e171.y * _e171.y);
            let _e177 = (_e171.z * _e171.z);
            let _e181 = (vec3<f32>(-(_e171.y), _e171.z, -(_e171.x)) * 0.48860252f);
            let _e187 = global_1.member[_e48];
            let _e189 = unpack2x16float(_e187.x);
            let _e191 = unpack2x16float(_e187.y);
            let _e198 = global.member_14;
            let _e199 = (_e48 + _e198);
            let _e202 = global_1.member[_e199];
            let _e204 = unpack2x16float(_e202.x);
            let _e206 = unpack2x16float(_e202.y);
            let _e211 = (2u * _e198);
            let _e212 = (_e48 + _e211);
            let _e215 = global_1.member[_e212];
            let _e217 = unpack2x16float(_e215.x);
            let _e219 = unpack2x16float(_e215.y);
            let _e240 = (2f * _e177);
            let _e247 = ((3u * _e198) + _e48);
            let _e250 = global_1.member[_e247];
            let _e252 = unpack2x16float(_e250.x);
            let _e254 = unpack2x16float(_e250.y);
            let _e260 = (_e247 + _e198);
            let _e263 = global_1.member[_e260];
            let _e265 = unpack2x16float(_e263.x);
            let _e267 = unpack2x16float(_e263.y);
            let _e272 = (_e247 + _e211);
            let _e275 = global_1.member[_e272];
            let _e277 = unpack2x16float(_e275.x);
            let _e279 = unpack2x16float(_e275.y);
            let _e297 = (_e175 - _e176);
            let _e309 = (((4f * _e177) - _e175) - _e176);
            let _e326 = global_2.member[_e247];
            let _e328 = unpack2x16float(_e326.x);
            let _e330 = unpack2x16float(_e326.y);
            let _e338 = global_2.member[_e260];
            let _e340 = unpack2x16float(_e338.x);
            let _e342 = unpack2x16float(_e338.y);
            let _e349 = global_2.member[_e272];
            let _e351 = unpack2x16float(_e349.x);
            let _e353 = unpack2x16float(_e349.y);
            let _e373 = global_2.member[_e48];
            let _e375 = unpack2x16float(_e373.x);
            let _e377 = unpack2x16float(_e373.y);
            let _e385 = global_2.member[_e199];
            let _e387 = unpack2x16float(_e385.x);
            let _e389 = unpack2x16float(_e385.y);
            let _e396 = global_2.member[_e212];
            let _e398 = unpack2x16float(_e396.x);
            let _e400 = unpack2x16float(_e396.y);
            let _e418 = clamp((((((((vec4<f32>(_e189.x, _e189.y, _e191.x, _e191.y).xyz * 1f) + (vec3<f32>(_e191.y, _e204.x, _e204.y) * _e181.x)) + (vec3<f32>(_e206.x, _e206.y, _e217.x) * _e181.y)) + (vec4<f32>(_e217.x, _e217.y, _e219.x, _e219.y).yzw * _e181.z)) + ((((vec4<f32>(_e252.x, _e252.y, _e254.x, _e254.y).xyz * ((1.0925485f * _e171.x) * _e171.y)) + (vec3<f32>(_e254.y, _e265.x, _e265.y) * ((-1.0925485f * _e171.y) * _e171.z))) + (vec3<f32>(_e267.x, _e267.y, _e277.x) * (0.31539157f * ((_e240 - _e175) - _e176)))) + (vec4<f32>(_e277.x, _e277.y, _e279.x, _e279.y).yzw * ((-1.0925485f * _e171.x) * _e171.z)))) + ((((vec4<f32>(_e328.x, _e328.y, _e330.x, _e330.y).xyz * ((0.37317634f * _e171.z) * (_e240 - (3f * (_e175 + _e176))))) + (vec3<f32>(_e330.y, _e340.x, _e340.y) * ((-0.4570458f * _e171.x) * _e309))) + (vec3<f32>(_e342.x, _e342.y, _e351.x) * ((1.4453057f * _e171.z) * _e297))) + (vec4<f32>(_e351.x, _e351.y, _e353.x, _e353.y).yzw * ((-0.5900436f * _e171.x) * (_e175 - (3f * _e176)))))) + ((((vec4<f32>(_e375.x, _e375.y, _e377.x, _e377.y).xyz * (0.54627424f * _e297)) + (vec3<f32>(_e377.y, _e387.x, _e387.y) * ((-0.5900436f * _e171.y) * ((3f * _e175) - _e176)))) + (vec3<f32>(_e389.x, _e389.y, _e398.x) * (((2.8906114f * _e171.x) * _e171.y) * _e171.z))) + (vec4<f32>(_e398.x, _e398.y, _e400.x, _e400.y).yzw * ((-0.4570458f * _e171.y) * _e309)))), vec3<f32>(0f, 0f, 0f), vec3<f32>(65504f, 65504f, 65504f));
            let _e420 = global.member_34;
            global_3.member[(_e420 + _e48)] = vec2<u32>(pack2x16float(_e418.xy), pack2x16float(vec2<f32>(_e418.z, 0f)));
            break;
        }
    }
    return;
}
