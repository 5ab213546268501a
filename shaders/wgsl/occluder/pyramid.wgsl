struct type_11 {
    member: array<u32>,
}

struct type_15 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_19 {
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
    member_50: u32,
    member_51: f32,
    member_52: f32,
    member_53: f32,
    member_54: vec4<f32>,
    member_55: vec4<f32>,
    member_56: vec4<f32>,
    member_57: array<vec4<f32>, 3>,
    member_58: array<vec4<u32>, 8>,
    member_59: array<vec4<u32>, 8>,
    member_60: array<type_15, 8>,
    member_61: array<vec4<f32>, 128>,
    member_62: array<vec4<f32>, 768>,
}

struct type_21 {
    member: array<u32, LENGTH_1_4>,
}

@group(0) @binding(2) 
var global: texture_2d<f32>;
var<workgroup> global_1: array<u32, 128>;
@group(0) @binding(1) 
var<storage, read_write> global_2: type_21;
@group(0) @binding(0) 
var<uniform> global_3: type_19;

@compute @workgroup_size(16, 8, 1) 
fn main(@builtin(local_invocation_id) param: vec3<u32>, @builtin(global_invocation_id) param_1: vec3<u32>) {
    var phi_241_: f32;
    var phi_240_: u32;
    var local: f32;
    var phi_246_: u32;
    var phi_242_: u32;
    var phi_117_: bool;
    var phi_166_: bool;
    var local_1: u32;

    let _e18 = bitcast<vec3<u32>>(param);
    let _e19 = bitcast<vec3<u32>>(param_1);
    phi_241_ = 0f;
    phi_240_ = 0u;
    loop {
        let _e22 = phi_241_;
        let _e24 = phi_240_;
        local = _e22;
        if (_e24 < 4u) {
            continue;
        } else {
            break;
        }
        continuing {
            let _e32 = textureLoad(global, bitcast<vec2<i32>>(((vec2<u32>(2u, 2u) * _e19.xy) + vec2<u32>((_e24 % 2u), (_e24 / 2u)))), 0i);
            phi_241_ = max(_e22, _e32.x);
            phi_240_ = (_e24 + bitcast<u32>(1i));
        }
    }
    let _e40 = ((_e18.y * 16u) + _e18.x);
    let _e42 = local;
    global_1[_e40] = u32(ceil(((65535f * _e42) - 0.01f)));
    phi_246_ = 0u;
    phi_242_ = 0u;
    loop {
        let _e49 = phi_246_;
        let _e51 = phi_242_;
        if (_e51 < 4u) {
            let _e54 = (1u << bitcast<u32>(_e51));
            let _e56 = (192u >> bitcast<u32>(_e51));
            workgroupBarrier();
            let _e57 = (_e51 > 0u);
            phi_117_ = _e57;
            if _e57 {
                phi_117_ = (((_e18.x | _e18.y) & (_e54 - 1u)) == 0u);
            }
            let _e63 = phi_117_;
            if _e63 {
                let _e64 = (_e54 / 2u);
                let _e66 = global_1[_e40];
                let _e69 = global_1[(_e40 + _e64)];
                let _e71 = (_e40 + (_e64 * 16u));
                let _e73 = global_1[_e71];
                let _e76 = global_1[(_e71 + _e64)];
                global_1[_e40] = max(max(_e66, _e69), max(_e73, _e76));
            }
            workgroupBarrier();
            let _e82 = ((_e18.x & ((2u * _e54) - 1u)) == 0u);
            phi_166_ = _e82;
            if _e82 {
                phi_166_ = ((_e18.y & (_e54 - 1u)) == 0u);
            }
            let _e87 = phi_166_;
            if _e87 {
                let _e98 = global_3.member_31;
                let _e101 = global_1[_e40];
                let _e104 = global_1[(_e40 + _e54)];
                global_2.member[(_e98 + (((_e49 + ((_e19.y >> bitcast<u32>(_e51)) * _e56)) + (_e19.x >> bitcast<u32>(_e51))) / 2u))] = (_e101 | (_e104 << bitcast<u32>(16u)));
            }
            local_1 = (_e49 + (_e56 * _e56));
            continue;
        } else {
            break;
        }
        continuing {
            let _e119 = local_1;
            phi_246_ = _e119;
            phi_242_ = (_e51 + bitcast<u32>(1i));
        }
    }
    return;
}
