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

struct type_8 {
    member: array<u32>,
}

struct type_11 {
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
}

struct type_16 {
    member: array<u32, LENGTH_2_4>,
}

@group(0) @binding(1) 
var<storage, read_write> global: type_4;
var<workgroup> global_1: array<atomic<u32>, 10>;
var<workgroup> global_2: array<atomic<u32>, 10>;
@group(0) @binding(2) 
var<storage, read_write> global_3: type_16;
@group(0) @binding(7) 
var<uniform> global_4: type_11;
var<workgroup> global_5: array<u32, 128>;

@compute @workgroup_size(128, 1, 1) 
fn main(@builtin(local_invocation_id) param: vec3<u32>) {
    var local: array<u32, 10>;
    var phi_347_: u32;
    var phi_348_: u32;
    var phi_349_: u32;
    var phi_368_: u32;
    var phi_350_: u32;
    var phi_361_: u32;
    var phi_351_: u32;
    var phi_190_: bool;
    var phi_353_: u32;
    var phi_352_: u32;
    var local_1: u32;
    var local_2: u32;
    var phi_354_: u32;
    var phi_362_: u32;
    var local_3: u32;
    var phi_357_: u32;
    var phi_356_: u32;
    var local_4: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;

    let _e24 = bitcast<u32>(param[0u]);
    let _e27 = global.member.member_6;
    let _e29 = ((_e27 + 255u) / 256u);
    phi_347_ = _e24;
    loop {
        let _e31 = phi_347_;
        if (_e31 < 10u) {
            continue;
        } else {
            break;
        }
        continuing {
            atomicStore((&global_1[_e31]), 0u);
            atomicStore((&global_2[_e31]), 0u);
            phi_347_ = (_e31 + 128u);
        }
    }
    workgroupBarrier();
    phi_348_ = 0u;
    loop {
        let _e37 = phi_348_;
        if (_e37 < 10u) {
            continue;
        } else {
            break;
        }
        continuing {
            local[_e37] = 0u;
            phi_348_ = (_e37 + bitcast<u32>(1i));
        }
    }
    phi_349_ = _e24;
    loop {
        let _e43 = phi_349_;
        if (_e43 < _e29) {
            phi_368_ = 0u;
            loop {
                let _e46 = phi_368_;
                if (_e46 < 10u) {
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e49 = local[_e46];
                    let _e51 = global_4.member_11;
                    let _e57 = global_3.member[((_e51 + (_e43 * 10u)) + _e46)];
                    let _e60 = global_4.member_14;
                    local[_e46] = min((_e49 + _e57), (_e60 + 1u));
                    phi_368_ = (_e46 + bitcast<u32>(1i));
                }
            }
            continue;
        } else {
            break;
        }
        continuing {
            phi_349_ = (_e43 + 128u);
        }
    }
    phi_350_ = 0u;
    loop {
        let _e67 = phi_350_;
        if (_e67 < 10u) {
            continue;
        } else {
            break;
        }
        continuing {
            let _e71 = local[_e67];
            let _e73 = atomicAdd((&global_1[_e67]), (_e71 & 65535u));
            let _e75 = local[_e67];
            let _e78 = atomicAdd((&global_2[_e67]), (_e75 >> bitcast<u32>(16u)));
            phi_350_ = (_e67 + bitcast<u32>(1i));
        }
    }
    workgroupBarrier();
    phi_361_ = 9u;
    phi_351_ = 10u;
    loop {
        let _e82 = phi_361_;
        let _e84 = phi_351_;
        local_1 = _e82;
        local_4 = _e82;
        local_6 = _e82;
        if (_e84 > 0u) {
            let _e86 = (_e84 - 1u);
            let _e88 = atomicLoad((&global_2[_e86]));
            let _e90 = atomicLoad((&global_1[_e86]));
            let _e93 = (_e88 + (_e90 >> bitcast<u32>(16u)));
            let _e94 = (_e93 < 65536u);
            phi_190_ = _e94;
            if _e94 {
                let _e97 = atomicLoad((&global_1[_e86]));
                let _e101 = global_4.member_14;
                phi_190_ = (((_e93 << bitcast<u32>(16u)) | (_e97 & 65535u)) <= _e101);
            }
            let _e104 = phi_190_;
            local_7 = select(_e82, _e86, _e104);
            continue;
        } else {
            break;
        }
        continuing {
            let _e189 = local_7;
            phi_361_ = _e189;
            phi_351_ = (_e84 - bitcast<u32>(1i));
        }
    }
    let _e109 = ((_e29 + 127u) / 128u);
    let _e111 = min((_e24 * _e109), _e29);
    let _e113 = min((_e111 + _e109), _e29);
    phi_353_ = 0u;
    phi_352_ = _e111;
    loop {
        let _e115 = phi_353_;
        let _e117 = phi_352_;
        local_2 = _e115;
        local_3 = _e115;
        if (_e117 < _e113) {
            continue;
        } else {
            break;
        }
        continuing {
            let _e120 = global_4.member_11;
            let _e124 = local_1;
            let _e128 = global_3.member[((_e120 + (_e117 * 10u)) + _e124)];
            phi_353_ = (_e115 + _e128);
            phi_352_ = (_e117 + bitcast<u32>(1i));
        }
    }
    let _e134 = local_2;
    global_5[_e24] = _e134;
    workgroupBarrier();
    phi_354_ = 1u;
    loop {
        let _e136 = phi_354_;
        if (_e136 < 128u) {
            if (_e24 >= _e136) {
                let _e141 = global_5[(_e24 - _e136)];
                phi_362_ = _e141;
            } else {
                phi_362_ = 0u;
            }
            let _e143 = phi_362_;
            workgroupBarrier();
            let _e144 = global_5[_e24];
            global_5[_e24] = (_e144 + _e143);
            workgroupBarrier();
            continue;
        } else {
            break;
        }
        continuing {
            phi_354_ = (_e136 * 2u);
        }
    }
    let _e147 = global_5[_e24];
    let _e149 = local_3;
    phi_357_ = (_e147 - _e149);
    phi_356_ = _e111;
    loop {
        let _e152 = phi_357_;
        let _e154 = phi_356_;
        local_5 = _e152;
        if (_e154 < _e113) {
            continue;
        } else {
            break;
        }
        continuing {
            let _e157 = global_4.member_11;
            let _e159 = (_e157 + (_e154 * 10u));
            let _e161 = local_4;
            let _e165 = global_3.member[(_e159 + _e161)];
            global_3.member[_e159] = _e152;
            phi_357_ = (_e152 + _e165);
            phi_356_ = (_e154 + bitcast<u32>(1i));
        }
    }
    if (_e24 == 127u) {
        let _e175 = local_5;
        global_3.member[5i] = _e175;
        let _e179 = local_6;
        global_3.member[8i] = _e179;
        global.member.member_7 = 0u;
    }
    return;
}
