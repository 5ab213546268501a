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

struct type_8 {
    member: array<u32>,
}

struct type_13 {
    member: array<u32, LENGTH_1_4>,
}

struct type_15 {
    member: array<u32, LENGTH_2_4>,
}

@group(0) @binding(7) 
var<uniform> global: type_3;
@group(0) @binding(3) 
var<storage> global_1: type_6;
@group(0) @binding(1) 
var<storage> global_2: type_13;
var<workgroup> global_3: array<atomic<u32>, 256>;
@group(0) @binding(2) 
var<storage, read_write> global_4: type_15;

@compute @workgroup_size(128, 1, 1) 
fn main(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>) {
    var phi_335_: u32;
    var phi_337_: u32;
    var phi_338_: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e17 = bitcast<u32>(param[0u]);
            let _e19 = bitcast<u32>(param_1[0u]);
            let _e22 = global_1.member.member_6;
            let _e24 = global.member_5;
            let _e25 = min(_e22, _e24);
            if (_e19 >= max(((_e25 + 4095u) / 4096u), 1u)) {
                break;
            }
            phi_335_ = _e17;
            loop {
                let _e31 = phi_335_;
                if (_e31 < 256u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    atomicStore((&global_3[_e31]), 0u);
                    phi_335_ = (_e31 + 128u);
                }
            }
            workgroupBarrier();
            phi_337_ = ((_e19 * 4096u) + _e17);
            loop {
                let _e38 = phi_337_;
                if (_e38 < min(_e25, ((_e19 + 1u) * 4096u))) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e45 = global_2.member[_e38];
                    let _e50 = atomicAdd((&global_3[((_e45 >> bitcast<u32>(24u)) & 255u)]), 1u);
                    phi_337_ = (_e38 + 128u);
                }
            }
            workgroupBarrier();
            phi_338_ = _e17;
            loop {
                let _e53 = phi_338_;
                if (_e53 < 256u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e58 = atomicLoad((&global_3[_e53]));
                    global_4.member[((_e19 * 256u) + _e53)] = _e58;
                    phi_338_ = (_e53 + 128u);
                }
            }
            break;
        }
    }
    return;
}
