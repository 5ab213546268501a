struct type_2 {
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
}

struct type_7 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: i32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
}

struct type_8 {
    member: type_7,
}

struct type_15 {
    member: array<u32>,
}

@group(0) @binding(7) 
var<uniform> global: type_2;
@group(0) @binding(3) 
var<storage> global_1: type_8;
var<private> global_2: vec3<u32>;
var<private> global_3: vec3<u32>;
@group(0) @binding(2) 
var<storage, read_write> global_4: type_15;

fn function_() {
    var phi_174_: u32;
    var phi_177_: u32;
    var phi_175_: u32;
    var local: u32;

    let _e20 = global.member_4;
    let _e24 = global_2[0u];
    let _e27 = global_1.member.member_6;
    let _e29 = global.member_5;
    let _e35 = global_3[0u];
    phi_174_ = _e35;
    loop {
        let _e37 = phi_174_;
        if (_e37 < 256u) {
            phi_177_ = 0u;
            phi_175_ = (_e24 * 64u);
            loop {
                let _e41 = phi_177_;
                let _e43 = phi_175_;
                local = _e41;
                if (_e43 < min(max(((min(_e27, _e29) + 4095u) / 4096u), 1u), ((_e24 + 1u) * 64u))) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e52 = global_4.member[((_e43 * 256u) + _e37)];
                    phi_177_ = (_e41 + _e52);
                    phi_175_ = (_e43 + bitcast<u32>(1i));
                }
            }
            let _e62 = local;
            global_4.member[((((_e20 * 256u) + 784u) + (_e24 * 256u)) + _e37)] = _e62;
            continue;
        } else {
            break;
        }
        continuing {
            phi_174_ = (_e37 + 128u);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn main(@builtin(workgroup_id) param: vec3<u32>, @builtin(local_invocation_id) param_1: vec3<u32>) {
    global_2 = param;
    global_3 = param_1;
    function_();
}
