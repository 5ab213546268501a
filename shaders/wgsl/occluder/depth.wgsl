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
    member_50: vec4<f32>,
    member_51: vec4<f32>,
    member_52: array<vec4<f32>, 3>,
    member_53: array<vec4<u32>, 8>,
    member_54: array<vec4<u32>, 8>,
    member_55: array<type_10, 8>,
    member_56: array<vec4<f32>, 128>,
    member_57: array<vec4<f32>, 768>,
}

struct type_21 {
    member: array<vec2<u32>>,
}

struct type_27 {
    member: array<vec4<u32>>,
}

struct type_35 {
    @builtin(position) member: vec4<f32>,
    member_1: f32,
    member_2: array<f32, 1>,
    member_3: array<f32, 1>,
}

struct type_39 {
    member: array<vec2<u32>, LENGTH_2_8>,
}

struct type_41 {
    member: array<vec4<u32>, LENGTH_1_16>,
}

@group(0) @binding(0) 
var<uniform> global: type_14;
@group(0) @binding(2) 
var<storage> global_1: type_39;
@group(0) @binding(1) 
var<storage> global_2: type_41;
var<private> global_3: i32;
var<private> global_4: type_35 = type_35(vec4<f32>(0f, 0f, 0f, 1f), 1f, array<f32, 1>(), array<f32, 1>());

fn function_() {
    var local: vec4<u32>;
    var local_1: vec4<f32>;
    var phi_467_: vec3<f32>;
    var phi_466_: u32;
    var local_2: vec3<f32>;
    var local_3: vec3<f32>;
    var local_4: vec3<f32>;
    var phi_468_: f32;
    var phi_469_: f32;

    let _e40 = global_3;
    let _e41 = (2i * _e40);
    let _e44 = global_2.member[_e41];
    let _e48 = global_2.member[(_e41 + 1i)];
    let _e59 = global.member_11;
    let _e62 = global.member_12;
    let _e65 = (_e59.xyz + (_e62.xyz * vec3<f32>(f32((_e44.x & 65535u)), f32((_e44.x >> bitcast<u32>(16u))), f32(_e44.y))));
    let _e69 = vec4<f32>(_e65.x, _e65.y, _e65.z, 1f);
    let _e71 = unpack2x16unorm(_e48.z);
    let _e76 = global.member_21;
    let _e77 = (2u * _e76);
    let _e81 = global_1.member[(_e77 + (_e48.x & 65535u))];
    let _e83 = unpack2x16float(_e81.x);
    let _e97 = global_1.member[(_e77 + (_e48.x >> bitcast<u32>(16u)))];
    let _e99 = unpack2x16float(_e97.x);
    let _e114 = global_1.member[(_e77 + _e48.y)];
    let _e116 = unpack2x16float(_e114.x);
    let _e126 = (_e69.xyz + (((vec3<f32>(_e83.x, _e83.y, unpack2x16float(_e81.y).x) * _e71.x) + (vec3<f32>(_e99.x, _e99.y, unpack2x16float(_e97.y).x) * _e71.y)) + (vec3<f32>(_e116.x, _e116.y, unpack2x16float(_e114.y).x) * ((1f - _e71.x) - _e71.y))));
    let _e132 = vec4<f32>(_e126.x, _e69.y, _e69.z, _e69.w);
    let _e138 = vec4<f32>(_e132.x, _e126.y, _e132.z, _e132.w);
    let _e144 = vec4<f32>(_e138.x, _e138.y, _e126.z, _e138.w);
    local = (vec4<u32>(_e44.z, (_e44.z >> bitcast<u32>(8u)), (_e44.z >> bitcast<u32>(16u)), (_e44.z >> bitcast<u32>(24u))) & vec4<u32>(255u, 255u, 255u, 255u));
    local_1 = unpack4x8unorm(_e44.w);
    phi_467_ = vec3<f32>(0f, 0f, 0f);
    phi_466_ = 0u;
    loop {
        let _e157 = phi_467_;
        let _e159 = phi_466_;
        local_2 = _e157;
        local_3 = _e157;
        local_4 = _e157;
        if (_e159 < 4u) {
            continue;
        } else {
            break;
        }
        continuing {
            let _e162 = local[_e159];
            let _e163 = (3u * _e162);
            let _e165 = local_1[_e159];
            let _e168 = global.member_57[_e163];
            let _e173 = global.member_57[(_e163 + 1u)];
            let _e178 = global.member_57[(_e163 + 2u)];
            phi_467_ = (_e157 + (vec3<f32>(dot(_e168, _e144), dot(_e173, _e144), dot(_e178, _e144)) * _e165));
            phi_466_ = (_e159 + bitcast<u32>(1i));
        }
    }
    let _e186 = global.member;
    let _e188 = local_2;
    let _e194 = global.member_1;
    let _e196 = local_4;
    let _e201 = global.member_30;
    let _e204 = global.member_7;
    let _e207 = global.member_8;
    let _e208 = ((_e204 - (_e196.z + _e201)) * _e207);
    if (_e208 < 0f) {
        phi_469_ = (0.015625f / (1f - _e208));
    } else {
        if (_e208 > 1f) {
            phi_468_ = (1f - (0.015625f / _e208));
        } else {
            phi_468_ = (0.015625f + (0.96875f * clamp(_e208, 0f, 1f)));
        }
        let _e219 = phi_468_;
        phi_469_ = _e219;
    }
    let _e221 = phi_469_;
    let _e224 = global.member_32;
    let _e228 = global.member_33;
    let _e233 = (((((((_e186 * _e188.xy) + (_e194 * _e196.z)) - (_e224 * _e196.z)) * _e228) * 2f) * vec2<f32>(0.0052083335f, 0.0052083335f)) - vec2(_e196.z));
    global_4.member = vec4<f32>(_e233.x, _e233.y, ((1f - _e221) * _e196.z), _e196.z);
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
