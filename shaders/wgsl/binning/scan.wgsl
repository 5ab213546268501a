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

struct type_7 {
    member: array<u32>,
}

struct type_10 {
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

struct type_15 {
    member: array<u32, LENGTH_2_4>,
}

@group(0) @binding(1) 
var<storage, read_write> global: type_4;
var<workgroup> global_1: array<atomic<u32>, 10>;
@group(0) @binding(2) 
var<storage, read_write> global_2: type_15;
@group(0) @binding(7) 
var<uniform> global_3: type_10;
var<workgroup> global_4: array<u32, 128>;

@compute @workgroup_size(128, 1, 1) 
fn main(@builtin(local_invocation_id) param: vec3<u32>) {
    var local: array<u32, 10>;
    var phi_307_: u32;
    var phi_308_: u32;
    var phi_309_: u32;
    var phi_326_: u32;
    var phi_310_: u32;
    var phi_321_: u32;
    var phi_311_: u32;
    var phi_313_: u32;
    var phi_312_: u32;
    var local_1: u32;
    var local_2: u32;
    var phi_314_: u32;
    var phi_322_: u32;
    var local_3: u32;
    var phi_317_: u32;
    var phi_316_: u32;
    var local_4: u32;
    var local_5: u32;
    var local_6: u32;

    let _e21 = bitcast<u32>(param[0u]);
    let _e24 = global.member.member_6;
    let _e26 = ((_e24 + 255u) / 256u);
    phi_307_ = _e21;
    loop {
        let _e28 = phi_307_;
        if (_e28 < 10u) {
            continue;
        } else {
            break;
        }
        continuing {
            atomicStore((&global_1[_e28]), 0u);
            phi_307_ = (_e28 + 128u);
        }
    }
    workgroupBarrier();
    phi_308_ = 0u;
    loop {
        let _e33 = phi_308_;
        if (_e33 < 10u) {
            continue;
        } else {
            break;
        }
        continuing {
            local[_e33] = 0u;
            phi_308_ = (_e33 + bitcast<u32>(1i));
        }
    }
    phi_309_ = _e21;
    loop {
        let _e39 = phi_309_;
        if (_e39 < _e26) {
            phi_326_ = 0u;
            loop {
                let _e42 = phi_326_;
                if (_e42 < 10u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e45 = global_3.member_11;
                    let _e51 = global_2.member[((_e45 + (_e39 * 10u)) + _e42)];
                    let _e53 = local[_e42];
                    local[_e42] = (_e53 + _e51);
                    phi_326_ = (_e42 + bitcast<u32>(1i));
                }
            }
            continue;
        } else {
            break;
        }
        continuing {
            phi_309_ = (_e39 + 128u);
        }
    }
    phi_310_ = 0u;
    loop {
        let _e59 = phi_310_;
        if (_e59 < 10u) {
            continue;
        } else {
            break;
        }
        continuing {
            let _e63 = local[_e59];
            let _e65 = atomicAdd((&global_1[_e59]), min(_e63, 16777215u));
            phi_310_ = (_e59 + bitcast<u32>(1i));
        }
    }
    workgroupBarrier();
    phi_321_ = 9u;
    phi_311_ = 10u;
    loop {
        let _e69 = phi_321_;
        let _e71 = phi_311_;
        local_1 = _e69;
        local_4 = _e69;
        local_6 = _e69;
        if (_e71 > 0u) {
            continue;
        } else {
            break;
        }
        continuing {
            let _e73 = (_e71 - 1u);
            let _e75 = atomicLoad((&global_1[_e73]));
            let _e77 = global_3.member_14;
            phi_321_ = select(_e69, _e73, (_e75 <= _e77));
            phi_311_ = (_e71 - bitcast<u32>(1i));
        }
    }
    let _e83 = ((_e26 + 127u) / 128u);
    let _e85 = min((_e21 * _e83), _e26);
    let _e87 = min((_e85 + _e83), _e26);
    phi_313_ = 0u;
    phi_312_ = _e85;
    loop {
        let _e89 = phi_313_;
        let _e91 = phi_312_;
        local_2 = _e89;
        local_3 = _e89;
        if (_e91 < _e87) {
            continue;
        } else {
            break;
        }
        continuing {
            let _e94 = global_3.member_11;
            let _e98 = local_1;
            let _e102 = global_2.member[((_e94 + (_e91 * 10u)) + _e98)];
            phi_313_ = (_e89 + _e102);
            phi_312_ = (_e91 + bitcast<u32>(1i));
        }
    }
    let _e108 = local_2;
    global_4[_e21] = _e108;
    workgroupBarrier();
    phi_314_ = 1u;
    loop {
        let _e110 = phi_314_;
        if (_e110 < 128u) {
            if (_e21 >= _e110) {
                let _e115 = global_4[(_e21 - _e110)];
                phi_322_ = _e115;
            } else {
                phi_322_ = 0u;
            }
            let _e117 = phi_322_;
            workgroupBarrier();
            let _e118 = global_4[_e21];
            global_4[_e21] = (_e118 + _e117);
            workgroupBarrier();
            continue;
        } else {
            break;
        }
        continuing {
            phi_314_ = (_e110 * 2u);
        }
    }
    let _e121 = global_4[_e21];
    let _e123 = local_3;
    phi_317_ = (_e121 - _e123);
    phi_316_ = _e85;
    loop {
        let _e126 = phi_317_;
        let _e128 = phi_316_;
        local_5 = _e126;
        if (_e128 < _e87) {
            continue;
        } else {
            break;
        }
        continuing {
            let _e131 = global_3.member_11;
            let _e133 = (_e131 + (_e128 * 10u));
            let _e135 = local_4;
            let _e139 = global_2.member[(_e133 + _e135)];
            global_2.member[_e133] = _e126;
            phi_317_ = (_e126 + _e139);
            phi_316_ = (_e128 + bitcast<u32>(1i));
        }
    }
    if (_e21 == 127u) {
        let _e149 = local_5;
        global_2.member[5i] = _e149;
        let _e153 = local_6;
        global_2.member[8i] = _e153;
        global.member.member_7 = 0u;
    }
    return;
}
