struct type_15 {
    member: array<u32>,
}

struct type_20 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_24 {
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
    member_52: array<type_20, 8>,
    member_53: array<vec4<f32>, 128>,
    member_54: array<vec4<f32>, 768>,
}

var<private> global: vec3<u32>;
var<private> global_1: vec3<u32>;
@group(0) @binding(2) 
var global_2: texture_2d<f32>;
var<workgroup> global_3: array<u32, 128>;
@group(0) @binding(1) 
var<storage, read_write> global_4: type_15;
@group(0) @binding(0) 
var<uniform> global_5: type_24;

fn function_() {
    var phi_234_: f32;
    var phi_233_: u32;
    var local: f32;
    var phi_239_: u32;
    var phi_235_: u32;
    var phi_114_: bool;
    var phi_162_: bool;
    var local_1: u32;

    let _e25 = global;
    let _e26 = global_1;
    phi_234_ = 0f;
    phi_233_ = 0u;
    loop {
        let _e29 = phi_234_;
        let _e31 = phi_233_;
        local = _e29;
        if (_e31 < 4u) {
            continue;
        } else {
            break;
        }
        continuing {
            let _e39 = textureLoad(global_2, bitcast<vec2<i32>>(((vec2<u32>(2u, 2u) * _e26.xy) + vec2<u32>((_e31 % 2u), (_e31 / 2u)))), 0i);
            phi_234_ = max(_e29, _e39.x);
            phi_233_ = (_e31 + bitcast<u32>(1i));
        }
    }
    let _e47 = ((_e25.y * 16u) + _e25.x);
    let _e49 = local;
    global_3[_e47] = u32(ceil(((65535f * _e49) - 0.01f)));
    phi_239_ = 0u;
    phi_235_ = 0u;
    loop {
        let _e56 = phi_239_;
        let _e58 = phi_235_;
        if (_e58 < 4u) {
            let _e61 = (1u << bitcast<u32>(_e58));
            let _e63 = (192u >> bitcast<u32>(_e58));
            workgroupBarrier();
            let _e64 = (_e58 > 0u);
            phi_114_ = _e64;
            if _e64 {
                phi_114_ = (((_e25.x | _e25.y) & (_e61 - 1u)) == 0u);
            }
            let _e70 = phi_114_;
            if _e70 {
                let _e71 = (_e61 / 2u);
                let _e72 = global_3[_e47];
                let _e75 = global_3[(_e47 + _e71)];
                let _e78 = (_e47 + (_e71 * 16u));
                let _e80 = global_3[_e78];
                let _e83 = global_3[(_e78 + _e71)];
                global_3[_e47] = max(max(_e72, _e75), max(_e80, _e83));
            }
            workgroupBarrier();
            let _e89 = ((_e25.x & ((2u * _e61) - 1u)) == 0u);
            phi_162_ = _e89;
            if _e89 {
                phi_162_ = ((_e25.y & (_e61 - 1u)) == 0u);
            }
            let _e94 = phi_162_;
            if _e94 {
                let _e105 = global_5.member_31;
                let _e108 = global_3[_e47];
                let _e111 = global_3[(_e47 + _e61)];
                global_4.member[(_e105 + (((_e56 + ((_e26.y >> bitcast<u32>(_e58)) * _e63)) + (_e26.x >> bitcast<u32>(_e58))) / 2u))] = (_e108 | (_e111 << bitcast<u32>(16u)));
            }
            local_1 = (_e56 + (_e63 * _e63));
            continue;
        } else {
            break;
        }
        continuing {
            let _e126 = local_1;
            phi_239_ = _e126;
            phi_235_ = (_e58 + bitcast<u32>(1i));
        }
    }
    return;
}

@compute @workgroup_size(16, 8, 1) 
fn main(@builtin(local_invocation_id) param: vec3<u32>, @builtin(global_invocation_id) param_1: vec3<u32>) {
    global = param;
    global_1 = param_1;
    function_();
}
