struct type_3 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: i32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
}

struct type_4 {
    member: type_3,
}

struct type_6 {
    member: array<u32>,
}

struct type_9 {
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

struct type_14 {
    member: array<u32, LENGTH_2_4>,
}

@group(0) @binding(1) 
var<storage, read_write> global: type_4;
var<workgroup> global_1: array<atomic<u32>, 10>;
@group(0) @binding(2) 
var<storage, read_write> global_2: type_14;
@group(0) @binding(7) 
var<uniform> global_3: type_9;
var<workgroup> global_4: array<u32, 128>;

@compute @workgroup_size(128, 1, 1) 
fn main(@builtin(local_invocation_id) param: vec3<u32>) {
    var phi_279_: u32;
    var phi_280_: u32;
    var phi_298_: u32;
    var phi_296_: u32;
    var local: u32;
    var phi_291_: u32;
    var phi_281_: u32;
    var phi_283_: u32;
    var phi_282_: u32;
    var local_1: u32;
    var local_2: u32;
    var phi_284_: u32;
    var phi_292_: u32;
    var local_3: u32;
    var phi_287_: u32;
    var phi_286_: u32;
    var local_4: u32;
    var local_5: u32;
    var local_6: u32;

    let _e20 = bitcast<u32>(param[0u]);
    let _e23 = global.member.member_6;
    let _e25 = ((_e23 + 255u) / 256u);
    phi_279_ = _e20;
    loop {
        let _e27 = phi_279_;
        if (_e27 < 10u) {
            continue;
        } else {
            break;
        }
        continuing {
            atomicStore((&global_1[_e27]), 0u);
            phi_279_ = (_e27 + 128u);
        }
    }
    workgroupBarrier();
    phi_280_ = 0u;
    loop {
        let _e32 = phi_280_;
        if (_e32 < 10u) {
            phi_298_ = 0u;
            phi_296_ = _e20;
            loop {
                let _e35 = phi_298_;
                let _e37 = phi_296_;
                local = _e35;
                if (_e37 < _e25) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e40 = global_3.member_11;
                    let _e46 = global_2.member[((_e40 + (_e37 * 10u)) + _e32)];
                    phi_298_ = (_e35 + _e46);
                    phi_296_ = (_e37 + 128u);
                }
            }
            let _e51 = local;
            let _e53 = atomicAdd((&global_1[_e32]), min(_e51, 16777215u));
            continue;
        } else {
            break;
        }
        continuing {
            phi_280_ = (_e32 + bitcast<u32>(1i));
        }
    }
    workgroupBarrier();
    phi_291_ = 9u;
    phi_281_ = 10u;
    loop {
        let _e57 = phi_291_;
        let _e59 = phi_281_;
        local_1 = _e57;
        local_4 = _e57;
        local_6 = _e57;
        if (_e59 > 0u) {
            continue;
        } else {
            break;
        }
        continuing {
            let _e61 = (_e59 - 1u);
            let _e63 = atomicLoad((&global_1[_e61]));
            let _e65 = global_3.member_14;
            phi_291_ = select(_e57, _e61, (_e63 <= _e65));
            phi_281_ = (_e59 - bitcast<u32>(1i));
        }
    }
    let _e71 = ((_e25 + 127u) / 128u);
    let _e73 = min((_e20 * _e71), _e25);
    let _e75 = min((_e73 + _e71), _e25);
    phi_283_ = 0u;
    phi_282_ = _e73;
    loop {
        let _e77 = phi_283_;
        let _e79 = phi_282_;
        local_2 = _e77;
        local_3 = _e77;
        if (_e79 < _e75) {
            continue;
        } else {
            break;
        }
        continuing {
            let _e82 = global_3.member_11;
            let _e86 = local_1;
            let _e90 = global_2.member[((_e82 + (_e79 * 10u)) + _e86)];
            phi_283_ = (_e77 + _e90);
            phi_282_ = (_e79 + bitcast<u32>(1i));
        }
    }
    let _e96 = local_2;
    global_4[_e20] = _e96;
    workgroupBarrier();
    phi_284_ = 1u;
    loop {
        let _e98 = phi_284_;
        if (_e98 < 128u) {
            if (_e20 >= _e98) {
                let _e103 = global_4[(_e20 - _e98)];
                phi_292_ = _e103;
            } else {
                phi_292_ = 0u;
            }
            let _e105 = phi_292_;
            workgroupBarrier();
            let _e106 = global_4[_e20];
            global_4[_e20] = (_e106 + _e105);
            workgroupBarrier();
            continue;
        } else {
            break;
        }
        continuing {
            phi_284_ = (_e98 * 2u);
        }
    }
    let _e109 = global_4[_e20];
    let _e111 = local_3;
    phi_287_ = (_e109 - _e111);
    phi_286_ = _e73;
    loop {
        let _e114 = phi_287_;
        let _e116 = phi_286_;
        local_5 = _e114;
        if (_e116 < _e75) {
            continue;
        } else {
            break;
        }
        continuing {
            let _e119 = global_3.member_11;
            let _e121 = (_e119 + (_e116 * 10u));
            let _e123 = local_4;
            let _e127 = global_2.member[(_e121 + _e123)];
            global_2.member[_e121] = _e114;
            phi_287_ = (_e114 + _e127);
            phi_286_ = (_e116 + bitcast<u32>(1i));
        }
    }
    if (_e20 == 127u) {
        let _e137 = local_5;
        global_2.member[5i] = _e137;
        let _e141 = local_6;
        global_2.member[8i] = _e141;
        global.member.member_7 = 0u;
    }
    return;
}
