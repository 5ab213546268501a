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
    var phi_320_: u32;
    var phi_322_: u32;
    var phi_323_: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e16 = bitcast<u32>(param[0u]);
            let _e18 = bitcast<u32>(param_1[0u]);
            let _e21 = global_1.member.member_6;
            let _e23 = global.member_5;
            let _e24 = min(_e21, _e23);
            if (_e18 >= max(((_e24 + 4095u) / 4096u), 1u)) {
                break;
            }
            phi_320_ = _e16;
            loop {
                let _e30 = phi_320_;
                if (_e30 < 256u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    atomicStore((&global_3[_e30]), 0u);
                    phi_320_ = (_e30 + 128u);
                }
            }
            workgroupBarrier();
            phi_322_ = ((_e18 * 4096u) + _e16);
            loop {
                let _e37 = phi_322_;
                if (_e37 < min(_e24, ((_e18 + 1u) * 4096u))) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e44 = global_2.member[_e37];
                    let _e48 = atomicAdd((&global_3[(_e44 >> bitcast<u32>(24u))]), 1u);
                    phi_322_ = (_e37 + 128u);
                }
            }
            workgroupBarrier();
            phi_323_ = _e16;
            loop {
                let _e51 = phi_323_;
                if (_e51 < 256u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e56 = atomicLoad((&global_3[_e51]));
                    global_4.member[((_e18 * 256u) + _e51)] = _e56;
                    phi_323_ = (_e51 + 128u);
                }
            }
            break;
        }
    }
    return;
}
