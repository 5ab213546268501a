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

struct type_12 {
    member: array<u32>,
}

@group(0) @binding(7) 
var<uniform> global: type_3;
@group(0) @binding(3) 
var<storage> global_1: type_8;
@group(0) @binding(1) 
var<storage> global_2: type_12;
var<private> global_3: vec3<u32>;
var<private> global_4: vec3<u32>;
var<workgroup> global_5: array<atomic<u32>, 256>;
@group(0) @binding(2) 
var<storage, read_write> global_6: type_12;

fn function_() {
    var phi_317_: u32;
    var phi_319_: u32;
    var phi_320_: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e22 = global_3[0u];
            let _e24 = global_4[0u];
            let _e27 = global_1.member.member_6;
            let _e29 = global.member_5;
            let _e30 = min(_e27, _e29);
            if (_e24 >= max(((_e30 + 4095u) / 4096u), 1u)) {
                break;
            }
            phi_317_ = _e22;
            loop {
                let _e36 = phi_317_;
                if (_e36 < 256u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    atomicStore((&global_5[_e36]), 0u);
                    phi_317_ = (_e36 + 128u);
                }
            }
            workgroupBarrier();
            phi_319_ = ((_e24 * 4096u) + _e22);
            loop {
                let _e43 = phi_319_;
                if (_e43 < min(_e30, ((_e24 + 1u) * 4096u))) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e50 = global_2.member[_e43];
                    let _e54 = atomicAdd((&global_5[(_e50 >> bitcast<u32>(24u))]), 1u);
                    phi_319_ = (_e43 + 128u);
                }
            }
            workgroupBarrier();
            phi_320_ = _e22;
            loop {
                let _e57 = phi_320_;
                if (_e57 < 256u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e62 = atomicLoad((&global_5[_e57]));
                    global_6.member[((_e24 * 256u) + _e57)] = _e62;
                    phi_320_ = (_e57 + 128u);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn main(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>) {
    global_3 = param;
    global_4 = param_1;
    function_();
}
