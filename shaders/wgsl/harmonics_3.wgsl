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
            let _e53 = global_3[0u];
            let _e55 = global.member_14;
            if (_e53 >= _e55) {
                break;
            }
            let _e57 = (2u * _e53);
            let _e61 = global_4.member[_e57];
            let _e64 = global_4.member[(_e57 + 1u)];
            local = (vec4<u32>(_e64.x, (_e64.x >> bitcast<u32>(8u)), (_e64.x >> bitcast<u32>(16u)), (_e64.x >> bitcast<u32>(24u))) & vec4<u32>(255u, 255u, 255u, 255u));
            let _e80 = (vec3<u32>(_e64.y, (_e64.y >> bitcast<u32>(8u)), (_e64.y >> bitcast<u32>(16u))) & vec3<u32>(255u, 255u, 255u));
            let _e81 = vec3<f32>(_e80);
            local_1 = (vec4<f32>(_e81.x, _e81.y, _e81.z, f32((((255u - _e80.x) - _e80.y) - _e80.z))) * vec4<f32>(0.003921569f, 0.003921569f, 0.003921569f, 0.003921569f));
            phi_1315_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_1314_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_1313_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_1312_ = 0u;
            loop {
                let _e95 = phi_1315_;
                let _e97 = phi_1314_;
                let _e99 = phi_1313_;
                let _e101 = phi_1312_;
                local_2 = _e99;
                local_3 = _e99;
                local_4 = _e99;
                local_5 = _e97;
                local_6 = _e97;
                local_7 = _e97;
                local_8 = _e95;
                local_9 = _e95;
                local_10 = _e95;
                if (_e101 < 4u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e104 = local[_e101];
                    let _e105 = (3u * _e104);
                    let _e107 = local_1[_e101];
                    let _e110 = global.member_54[_e105];
                    let _e113 = local_1[_e101];
                    let _e117 = global.member_54[(_e105 + 1u)];
                    let _e120 = local_1[_e101];
                    let _e124 = global.member_54[(_e105 + 2u)];
                    phi_1315_ = (_e95 + (_e124 * _e120));
                    phi_1314_ = (_e97 + (_e117 * _e113));
                    phi_1313_ = (_e99 + (_e110 * _e107));
                    phi_1312_ = (_e101 + bitcast<u32>(1i));
                }
            }
            let _e130 = global.member_11;
            let _e133 = global.member_12;
            let _e146 = (_e130.xyz + (_e133.xyz * vec3<f32>(f32((_e61.x & 65535u)), f32((_e61.x >> bitcast<u32>(16u))), f32((_e61.y & 65535u)))));
            let _e150 = vec4<f32>(_e146.x, _e146.y, _e146.z, 1f);
            let _e152 = local_2;
            let _e155 = local_3;
            let _e161 = local_5;
            let _e164 = local_6;
            let _e171 = local_8;
            let _e174 = local_9;
            let _e179 = (((_e155.xyz * dot(_e152, _e150)) + (_e164.xyz * dot(_e161, _e150))) + (_e174.xyz * dot(_e171, _e150)));
            let _e180 = length(_e179);
            if (_e180 > 0f) {
                phi_1316_ = (_e179 / vec3(_e180));
            } else {
                phi_1316_ = vec3<f32>(0f, 0f, 0f);
            }
            let _e185 = phi_1316_;
            let _e189 = (_e185.x * _e185.x);
            let _e190 = (_e185.y * _e185.y);
            let _e191 = (_e185.z * _e185.z);
            let _e195 = (vec3<f32>(-(_e185.y), _e185.z, -(_e185.x)) * 0.48860252f);
            let _e201 = global_1.member[_e53];
            let _e203 = unpack2x16float(_e201.x);
            let _e205 = unpack2x16float(_e201.y);
            let _e211 = (_e53 + _e55);
            let _e214 = global_1.member[_e211];
            let _e216 = unpack2x16float(_e214.x);
            let _e218 = unpack2x16float(_e214.y);
            let _e223 = (2u * _e55);
            let _e224 = (_e53 + _e223);
            let _e227 = global_1.member[_e224];
            let _e229 = unpack2x16float(_e227.x);
            let _e231 = unpack2x16float(_e227.y);
            let _e252 = (2f * _e191);
            let _e259 = ((3u * _e55) + _e53);
            let _e262 = global_1.member[_e259];
            let _e264 = unpack2x16float(_e262.x);
            let _e266 = unpack2x16float(_e262.y);
            let _e272 = (_e259 + _e55);
            let _e275 = global_1.member[_e272];
            let _e277 = unpack2x16float(_e275.x);
            let _e279 = unpack2x16float(_e275.y);
            let _e284 = (_e259 + _e223);
            let _e287 = global_1.member[_e284];
            let _e289 = unpack2x16float(_e287.x);
            let _e291 = unpack2x16float(_e287.y);
            let _e309 = (_e189 - _e190);
            let _e321 = (((4f * _e191) - _e189) - _e190);
            let _e338 = global_2.member[_e259];
            let _e340 = unpack2x16float(_e338.x);
            let _e342 = unpack2x16float(_e338.y);
            let _e350 = global_2.member[_e272];
            let _e352 = unpack2x16float(_e350.x);
            let _e354 = unpack2x16float(_e350.y);
            let _e361 = global_2.member[_e284];
            let _e363 = unpack2x16float(_e361.x);
            let _e365 = unpack2x16float(_e361.y);
            let _e385 = global_2.member[_e53];
            let _e387 = unpack2x16float(_e385.x);
            let _e389 = unpack2x16float(_e385.y);
            let _e397 = global_2.member[_e211];
            let _e399 = unpack2x16float(_e397.x);
            let _e401 = unpack2x16float(_e397.y);
            let _e408 = global_2.member[_e224];
            let _e410 = unpack2x16float(_e408.x);
            let _e412 = unpack2x16float(_e408.y);
            let _e430 = clamp((((((((vec4<f32>(_e203.x, _e203.y, _e205.x, _e205.y).xyz * 1f) + (vec3<f32>(_e205.y, _e216.x, _e216.y) * _e195.x)) + (vec3<f32>(_e218.x, _e218.y, _e229.x) * _e195.y)) + (vec4<f32>(_e229.x, _e229.y, _e231.x, _e231.y).yzw * _e195.z)) + ((((vec4<f32>(_e264.x, _e264.y, _e266.x, _e266.y).xyz * ((1.0925485f * _e185.x) * _e185.y)) + (vec3<f32>(_e266.y, _e277.x, _e277.y) * ((-1.0925485f * _e185.y) * _e185.z))) + (vec3<f32>(_e279.x, _e279.y, _e289.x) * (0.31539157f * ((_e252 - _e189) - _e190)))) + (vec4<f32>(_e289.x, _e289.y, _e291.x, _e291.y).yzw * ((-1.0925485f * _e185.x) * _e185.z)))) + ((((vec4<f32>(_e340.x, _e340.y, _e342.x, _e342.y).xyz * ((0.37317634f * _e185.z) * (_e252 - (3f * (_e189 + _e190))))) + (vec3<f32>(_e342.y, _e352.x, _e352.y) * ((-0.4570458f * _e185.x) * _e321))) + (vec3<f32>(_e354.x, _e354.y, _e363.x) * ((1.4453057f * _e185.z) * _e309))) + (vec4<f32>(_e363.x, _e363.y, _e365.x, _e365.y).yzw * ((-0.5900436f * _e185.x) * (_e189 - (3f * _e190)))))) + ((((vec4<f32>(_e387.x, _e387.y, _e389.x, _e389.y).xyz * (0.54627424f * _e309)) + (vec3<f32>(_e389.y, _e399.x, _e399.y) * ((-0.5900436f * _e185.y) * ((3f * _e189) - _e190)))) + (vec3<f32>(_e401.x, _e401.y, _e410.x) * (((2.8906114f * _e185.x) * _e185.y) * _e185.z))) + (vec4<f32>(_e410.x, _e410.y, _e412.x, _e412.y).yzw * ((-0.4570458f * _e185.y) * _e321)))), vec3<f32>(0f, 0f, 0f), vec3<f32>(65504f, 65504f, 65504f));
            let _e432 = global.member_38;
            global_4.member[(_e432 + _e53)] = vec2<u32>(pack2x16float(_e430.xy), pack2x16float(vec2<f32>(_e430.z, 0f)));
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
