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
var<private> global_2: vec3<u32>;
@group(0) @binding(1) 
var<storage, read_write> global_3: type_23;

fn function_() {
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
            let _e40 = global_2[0u];
            let _e42 = global.member_14;
            if (_e40 >= _e42) {
                break;
            }
            let _e44 = (2u * _e40);
            let _e48 = global_3.member[_e44];
            let _e51 = global_3.member[(_e44 + 1u)];
            local = (vec4<u32>(_e51.x, (_e51.x >> bitcast<u32>(8u)), (_e51.x >> bitcast<u32>(16u)), (_e51.x >> bitcast<u32>(24u))) & vec4<u32>(255u, 255u, 255u, 255u));
            let _e67 = (vec3<u32>(_e51.y, (_e51.y >> bitcast<u32>(8u)), (_e51.y >> bitcast<u32>(16u))) & vec3<u32>(255u, 255u, 255u));
            let _e68 = vec3<f32>(_e67);
            local_1 = (vec4<f32>(_e68.x, _e68.y, _e68.z, f32((((255u - _e67.x) - _e67.y) - _e67.z))) * vec4<f32>(0.003921569f, 0.003921569f, 0.003921569f, 0.003921569f));
            phi_937_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_936_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_935_ = vec4<f32>(0f, 0f, 0f, 0f);
            phi_934_ = 0u;
            loop {
                let _e82 = phi_937_;
                let _e84 = phi_936_;
                let _e86 = phi_935_;
                let _e88 = phi_934_;
                local_2 = _e86;
                local_3 = _e86;
                local_4 = _e86;
                local_5 = _e84;
                local_6 = _e84;
                local_7 = _e84;
                local_8 = _e82;
                local_9 = _e82;
                local_10 = _e82;
                if (_e88 < 4u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e91 = local[_e88];
                    let _e92 = (3u * _e91);
                    let _e94 = local_1[_e88];
                    let _e97 = global.member_54[_e92];
                    let _e100 = local_1[_e88];
                    let _e104 = global.member_54[(_e92 + 1u)];
                    let _e107 = local_1[_e88];
                    let _e111 = global.member_54[(_e92 + 2u)];
                    phi_937_ = (_e82 + (_e111 * _e107));
                    phi_936_ = (_e84 + (_e104 * _e100));
                    phi_935_ = (_e86 + (_e97 * _e94));
                    phi_934_ = (_e88 + bitcast<u32>(1i));
                }
            }
            let _e117 = global.member_11;
            let _e120 = global.member_12;
            let _e133 = (_e117.xyz + (_e120.xyz * vec3<f32>(f32((_e48.x & 65535u)), f32((_e48.x >> bitcast<u32>(16u))), f32((_e48.y & 65535u)))));
            let _e137 = vec4<f32>(_e133.x, _e133.y, _e133.z, 1f);
            let _e139 = local_2;
            let _e142 = local_3;
            let _e148 = local_5;
            let _e151 = local_6;
            let _e158 = local_8;
            let _e161 = local_9;
            let _e166 = (((_e142.xyz * dot(_e139, _e137)) + (_e151.xyz * dot(_e148, _e137))) + (_e161.xyz * dot(_e158, _e137)));
            let _e167 = length(_e166);
            if (_e167 > 0f) {
                phi_938_ = (_e166 / vec3(_e167));
            } else {
                phi_938_ = vec3<f32>(0f, 0f, 0f);
            }
            let _e172 = phi_938_;
            let _e179 = (vec3<f32>(-(_e172.y), _e172.z, -(_e172.x)) * 0.48860252f);
            let _e185 = global_1.member[_e40];
            let _e187 = unpack2x16float(_e185.x);
            let _e189 = unpack2x16float(_e185.y);
            let _e198 = global_1.member[(_e40 + _e42)];
            let _e200 = unpack2x16float(_e198.x);
            let _e202 = unpack2x16float(_e198.y);
            let _e211 = global_1.member[(_e40 + (2u * _e42))];
            let _e213 = unpack2x16float(_e211.x);
            let _e215 = unpack2x16float(_e211.y);
            let _e232 = clamp(((((vec4<f32>(_e187.x, _e187.y, _e189.x, _e189.y).xyz * 1f) + (vec3<f32>(_e189.y, _e200.x, _e200.y) * _e179.x)) + (vec3<f32>(_e202.x, _e202.y, _e213.x) * _e179.y)) + (vec4<f32>(_e213.x, _e213.y, _e215.x, _e215.y).yzw * _e179.z)), vec3<f32>(0f, 0f, 0f), vec3<f32>(65504f, 65504f, 65504f));
            let _e234 = global.member_38;
            global_3.member[(_e234 + _e40)] = vec2<u32>(pack2x16float(_e232.xy), pack2x16float(vec2<f32>(_e232.z, 0f)));
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
    global_2 = param;
    function_();
}
