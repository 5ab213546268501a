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
    member: array<vec2<u32>, LENGTH_1_8>,
}

@group(0) @binding(0) 
var<uniform> global: type_13;
@group(0) @binding(2) 
var<storage> global_1: type_19;
@group(0) @binding(1) 
var<storage, read_write> global_2: type_21;

@compute @workgroup_size(64, 1, 1) 
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
    var local: vec4<u32>;
    var local_1: vec4<f32>;
    var phi_950_: vec4<f32>;
    var phi_949_: vec4<f32>;
    var phi_948_: vec4<f32>;
    var phi_947_: u32;
    var local_2: vec4<f32>;
    var local_3: vec4<f32>;
    var local_4: vec4<f32>;
    var local_5: vec4<f32>;
    var local_6: vec4<f32>;
    var local_7: vec4<f32>;
    var local_8: vec4<f32>;
    var local_9: vec4<f32>;
    var local_10: vec4<f32>;
    var phi_951_: vec3<f32>;

    switch bitcast<i32>(0u) {
        default: {
            let _e28 = bitcast<u32>(param[0u]);
            let _e30 = global.member_44;
            if (_e28 >= _e30) {
                break;
            }
            let _e33 = global.member_43;
            let _e35 = (_e28 << bitcast<u32>(_e33));
            let _e36 = (2u * _e35);
            let _e40 = global_2.member[_e36];
            let _e43 = global_2.member[(_e36 + 1u)];
            local = (vec4<u32>(_e43.x, (_e43.x >> bitcast<u32>(8u)), (_e43.x >> bitcast<u32>(16u)), (_e43.x >> bitcast<u32>(24u))) & vec4<u32>(255u, 255u, 255u, 255u));
            let _e59 = (vec3<u32>(_e43.y, (_e43.y >> bitcast<u32>(8u)), (_e43.y >> bitcast<u32>(16u))) & vec3<u32>(255u, 255u, 255u));
            let _e60 = vec3<f32>(_e59);
            local_1 = (vec4<f32>(_e60.x, _e60.y, _e60.z, f32((((255u - _e59.x) - _e59.y) - _e59.z))) * vec4<f32>(0.003921569f, 0.003921569f, 0.003921569f, 0.003921569f));
            phi_950_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_949_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_948_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_947_ = 0u;
            loop {
                let _e74 = phi_950_;
                let _e76 = phi_949_;
                let _e78 = phi_948_;
                let _e80 = phi_947_;
                local_2 = _e78;
                local_3 = _e78;
                local_4 = _e78;
                local_5 = _e76;
                local_6 = _e76;
                local_7 = _e76;
                local_8 = _e74;
                local_9 = _e74;
                local_10 = _e74;
                if (_e80 < 4u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e83 = local[_e80];
                    let _e84 = (3u * _e83);
                    let _e86 = local_1[_e80];
                    let _e89 = global.member_58[_e84];
                    let _e92 = local_1[_e80];
                    let _e96 = global.member_58[(_e84 + 1u)];
                    let _e99 = local_1[_e80];
                    let _e103 = global.member_58[(_e84 + 2u)];
                    phi_950_ = (_e74 + (_e103 * _e99));
                    phi_949_ = (_e76 + (_e96 * _e92));
                    phi_948_ = (_e78 + (_e89 * _e86));
                    phi_947_ = (_e80 + bitcast<u32>(1i));
                }
            }
            let _e119 = global.member_11;
            let _e122 = global.member_12;
            let _e125 = (_e119.xyz + (_e122.xyz * vec3<f32>(f32((_e40.x & 65535u)), f32((_e40.x >> bitcast<u32>(16u))), f32((_e40.y & 65535u)))));
            let _e129 = vec4<f32>(_e125.x, _e125.y, _e125.z, 1f);
            let _e131 = local_2;
            let _e134 = local_3;
            let _e138 = local_5;
            let _e141 = local_6;
            let _e146 = local_8;
            let _e149 = local_9;
            let _e152 = (((_e134.xyz * dot(_e131, _e129)) + (_e141.xyz * dot(_e138, _e129))) + (_e149.xyz * dot(_e146, _e129)));
            let _e153 = length(_e152);
            if (_e153 > 0f) {
                phi_951_ = (_e152 / vec3(_e153));
            } else {
                phi_951_ = vec3<f32>(0f, 0f, 0f);
            }
            let _e158 = phi_951_;
            let _e165 = (vec3<f32>(-(_e158.y), _e158.z, -(_e158.x)) * 0.48860252f);
            let _e171 = global_1.member[_e35];
            let _e173 = unpack2x16float(_e171.x);
            let _e175 = unpack2x16float(_e171.y);
            let _e182 = global.member_14;
            let _e186 = global_1.member[(_e35 + _e182)];
            let _e188 = unpack2x16float(_e186.x);
            let _e190 = unpack2x16float(_e186.y);
            let _e199 = global_1.member[(_e35 + (2u * _e182))];
            let _e201 = unpack2x16float(_e199.x);
            let _e203 = unpack2x16float(_e199.y);
            let _e220 = clamp(((((vec4<f32>(_e173.x, _e173.y, _e175.x, _e175.y).xyz * 1f) + (vec3<f32>(_e175.y, _e188.x, _e188.y) * _e165.x)) + (vec3<f32>(_e190.x, _e190.y, _e201.x) * _e165.y)) + (vec4<f32>(_e201.x, _e201.y, _e203.x, _e203.y).yzw * _e165.z)), vec3<f32>(0f, 0f, 0f), vec3<f32>(65504f, 65504f, 65504f));
            let _e222 = global.member_34;
            global_2.member[(_e222 + _e35)] = vec2<u32>(pack2x16float(_e220.xy), pack2x16float(vec2<f32>(_e220.z, 0f)));
            break;
        }
    }
    return;
}
