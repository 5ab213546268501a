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
    var phi_937_: vec4<f32>;
    var phi_936_: vec4<f32>;
    var phi_935_: vec4<f32>;
    var phi_934_: u32;
    var local_2: vec4<f32>;
    var local_3: vec4<f32>;
    var local_4: vec4<f32>;
    var local_5: vec4<f32>;
    var local_6: vec4<f32>;
    var local_7: vec4<f32>;
    var local_8: vec4<f32>;
    var local_9: vec4<f32>;
    var local_10: vec4<f32>;
    var phi_938_: vec3<f32>;

    switch bitcast<i32>(0u) {
        default: {
            let _e28 = bitcast<u32>(param[0u]);
            let _e30 = global.member_14;
            if (_e28 >= _e30) {
                break;
            }
            let _e32 = (2u * _e28);
            let _e36 = global_2.member[_e32];
            let _e39 = global_2.member[(_e32 + 1u)];
            local = (vec4<u32>(_e39.x, (_e39.x >> bitcast<u32>(8u)), (_e39.x >> bitcast<u32>(16u)), (_e39.x >> bitcast<u32>(24u))) & vec4<u32>(255u, 255u, 255u, 255u));
            let _e55 = (vec3<u32>(_e39.y, (_e39.y >> bitcast<u32>(8u)), (_e39.y >> bitcast<u32>(16u))) & vec3<u32>(255u, 255u, 255u));
            let _e56 = vec3<f32>(_e55);
            local_1 = (vec4<f32>(_e56.x, _e56.y, _e56.z, f32((((255u - _e55.x) - _e55.y) - _e55.z))) * vec4<f32>(0.003921569f, 0.003921569f, 0.003921569f, 0.003921569f));
            phi_937_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_936_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_935_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_934_ = 0u;
            loop {
                let _e70 = phi_937_;
                let _e72 = phi_936_;
                let _e74 = phi_935_;
                let _e76 = phi_934_;
                local_2 = _e74;
                local_3 = _e74;
                local_4 = _e74;
                local_5 = _e72;
                local_6 = _e72;
                local_7 = _e72;
                local_8 = _e70;
                local_9 = _e70;
                local_10 = _e70;
                if (_e76 < 4u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e79 = local[_e76];
                    let _e80 = (3u * _e79);
                    let _e82 = local_1[_e76];
                    let _e85 = global.member_54[_e80];
                    let _e88 = local_1[_e76];
                    let _e92 = global.member_54[(_e80 + 1u)];
                    let _e95 = local_1[_e76];
                    let _e99 = global.member_54[(_e80 + 2u)];
                    phi_937_ = (_e70 + (_e99 * _e95));
                    phi_936_ = (_e72 + (_e92 * _e88));
                    phi_935_ = (_e74 + (_e85 * _e82));
                    phi_934_ = (_e76 + bitcast<u32>(1i));
                }
            }
            let _e105 = global.member_11;
            let _e108 = global.member_12;
            let _e121 = (_e105.xyz + (_e108.xyz * vec3<f32>(f32((_e36.x & 65535u)), f32((_e36.x >> bitcast<u32>(16u))), f32((_e36.y & 65535u)))));
            let _e125 = vec4<f32>(_e121.x, _e121.y, _e121.z, 1f);
            let _e127 = local_2;
            let _e130 = local_3;
            let _e134 = local_5;
            let _e137 = local_6;
            let _e142 = local_8;
            let _e145 = local_9;
            let _e148 = (((_e130.xyz * dot(_e127, _e125)) + (_e137.xyz * dot(_e134, _e125))) + (_e145.xyz * dot(_e142, _e125)));
            let _e149 = length(_e148);
            if (_e149 > 0f) {
                phi_938_ = (_e148 / vec3(_e149));
            } else {
                phi_938_ = vec3<f32>(0f, 0f, 0f);
            }
            let _e154 = phi_938_;
            let _e161 = (vec3<f32>(-(_e154.y), _e154.z, -(_e154.x)) * 0.48860252f);
            let _e167 = global_1.member[_e28];
            let _e169 = unpack2x16float(_e167.x);
            let _e171 = unpack2x16float(_e167.y);
            let _e180 = global_1.member[(_e28 + _e30)];
            let _e182 = unpack2x16float(_e180.x);
            let _e184 = unpack2x16float(_e180.y);
            let _e193 = global_1.member[(_e28 + (2u * _e30))];
            let _e195 = unpack2x16float(_e193.x);
            let _e197 = unpack2x16float(_e193.y);
            let _e214 = clamp(((((vec4<f32>(_e169.x, _e169.y, _e171.x, _e171.y).xyz * 1f) + (vec3<f32>(_e171.y, _e182.x, _e182.y) * _e161.x)) + (vec3<f32>(_e184.x, _e184.y, _e195.x) * _e161.y)) + (vec4<f32>(_e195.x, _e195.y, _e197.x, _e197.y).yzw * _e161.z)), vec3<f32>(0f, 0f, 0f), vec3<f32>(65504f, 65504f, 65504f));
            let _e216 = global.member_38;
            global_2.member[(_e216 + _e28)] = vec2<u32>(pack2x16float(_e214.xy), pack2x16float(vec2<f32>(_e214.z, 0f)));
            break;
        }
    }
    return;
}
