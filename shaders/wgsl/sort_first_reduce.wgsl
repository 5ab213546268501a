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

struct type_12 {
    member: array<u32>,
}

@group(0) @binding(7) 
var<uniform> global: type_2;
var<private> global_1: vec3<u32>;
var<private> global_2: vec3<u32>;
@group(0) @binding(2) 
var<storage, read_write> global_3: type_12;

fn function_() {
    var phi_173_: u32;
    var phi_176_: u32;
    var phi_174_: u32;
    var local: u32;

    let _e19 = global.member_4;
    let _e23 = global_1[0u];
    let _e25 = global.member_7;
    let _e27 = global.member_5;
    let _e33 = global_2[0u];
    phi_173_ = _e33;
    loop {
        let _e35 = phi_173_;
        if (_e35 < 256u) {
            phi_176_ = 0u;
            phi_174_ = (_e23 * 64u);
            loop {
                let _e39 = phi_176_;
                let _e41 = phi_174_;
                local = _e39;
                if (_e41 < min(max(((min(_e25, _e27) + 4095u) / 4096u), 1u), ((_e23 + 1u) * 64u))) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e50 = global_3.member[((_e41 * 256u) + _e35)];
                    phi_176_ = (_e39 + _e50);
                    phi_174_ = (_e41 + bitcast<u32>(1i));
                }
            }
            let _e60 = local;
            global_3.member[((((_e19 * 256u) + 784u) + (_e23 * 256u)) + _e35)] = _e60;
            continue;
        } else {
            break;
        }
        continuing {
            phi_173_ = (_e35 + 128u);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn main(@builtin(workgroup_id) param: vec3<u32>, @builtin(local_invocation_id) param_1: vec3<u32>) {
    global_1 = param;
    global_2 = param_1;
    function_();
}
