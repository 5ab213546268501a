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

struct type_5 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: i32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
}

struct type_6 {
    member: type_5,
}

struct type_9 {
    member: array<u32>,
}

struct type_11 {
    member: array<u32, LENGTH_2_4>,
}

@group(0) @binding(7) 
var<uniform> global: type_3;
@group(0) @binding(3) 
var<storage> global_1: type_6;
@group(0) @binding(2) 
var<storage, read_write> global_2: type_11;

@compute @workgroup_size(128, 1, 1) 
fn main(@builtin(workgroup_id) param: vec3<u32>, @builtin(local_invocation_id) param_1: vec3<u32>) {
    var phi_179_: u32;
    var phi_182_: u32;
    var phi_180_: u32;
    var local: u32;

    let _e15 = global.member_4;
    let _e19 = bitcast<u32>(param[0u]);
    let _e22 = global_1.member.member_6;
    let _e24 = global.member_5;
    phi_179_ = bitcast<u32>(param_1[0u]);
    loop {
        let _e32 = phi_179_;
        if (_e32 < 256u) {
            phi_182_ = 0u;
            phi_180_ = (_e19 * 64u);
            loop {
                let _e36 = phi_182_;
                let _e38 = phi_180_;
                local = _e36;
                if (_e38 < min(max(((min(_e22, _e24) + 4095u) / 4096u), 1u), ((_e19 + 1u) * 64u))) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e47 = global_2.member[((_e38 * 256u) + _e32)];
                    phi_182_ = (_e36 + _e47);
                    phi_180_ = (_e38 + bitcast<u32>(1i));
                }
            }
            let _e57 = local;
            global_2.member[((((_e15 * 256u) + 784u) + (_e19 * 256u)) + _e32)] = _e57;
            continue;
        } else {
            break;
        }
        continuing {
            phi_179_ = (_e32 + 128u);
        }
    }
    return;
}
