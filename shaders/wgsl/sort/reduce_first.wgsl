struct type_3 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: f32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
    member_8: u32,
    member_9: u32,
    member_10: vec2<u32>,
    member_11: u32,
    member_12: u32,
    member_13: u32,
    member_14: u32,
    member_15: f32,
}

struct type_7 {
    member: array<u32>,
}

struct type_9 {
    member: array<u32, LENGTH_2_4>,
}

@group(0) @binding(7) 
var<uniform> global: type_3;
@group(0) @binding(2) 
var<storage, read_write> global_1: type_9;

@compute @workgroup_size(128, 1, 1) 
fn main(@builtin(workgroup_id) param: vec3<u32>, @builtin(local_invocation_id) param_1: vec3<u32>) {
    var phi_178_: u32;
    var phi_181_: u32;
    var phi_179_: u32;
    var local: u32;

    let _e14 = global.member_4;
    let _e18 = bitcast<u32>(param[0u]);
    let _e20 = global.member_7;
    let _e22 = global.member_5;
    phi_178_ = bitcast<u32>(param_1[0u]);
    loop {
        let _e30 = phi_178_;
        if (_e30 < 256u) {
            phi_181_ = 0u;
            phi_179_ = (_e18 * 64u);
            loop {
                let _e34 = phi_181_;
                let _e36 = phi_179_;
                local = _e34;
                if (_e36 < min(max(((min(_e20, _e22) + 4095u) / 4096u), 1u), ((_e18 + 1u) * 64u))) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e45 = global_1.member[((_e36 * 256u) + _e30)];
                    phi_181_ = (_e34 + _e45);
                    phi_179_ = (_e36 + bitcast<u32>(1i));
                }
            }
            let _e55 = local;
            global_1.member[((((_e14 * 256u) + 784u) + (_e18 * 256u)) + _e30)] = _e55;
            continue;
        } else {
            break;
        }
        continuing {
            phi_178_ = (_e30 + 128u);
        }
    }
    return;
}
