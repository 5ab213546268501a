struct type_8 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_12 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
    member_3: vec2<f32>,
    member_4: vec2<f32>,
    member_5: f32,
    member_6: f32,
    member_7: f32,
    member_8: f32,
    member_9: u32,
    member_10: f32,
    member_11: vec4<f32>,
    member_12: vec4<f32>,
    member_13: vec4<f32>,
    member_14: u32,
    member_15: u32,
    member_16: u32,
    member_17: u32,
    member_18: u32,
    member_19: u32,
    member_20: u32,
    member_21: u32,
    member_22: u32,
    member_23: u32,
    member_24: u32,
    member_25: f32,
    member_26: u32,
    member_27: u32,
    member_28: u32,
    member_29: f32,
    member_30: f32,
    member_31: u32,
    member_32: f32,
    member_33: f32,
    member_34: u32,
    member_35: u32,
    member_36: u32,
    member_37: u32,
    member_38: u32,
    member_39: f32,
    member_40: u32,
    member_41: u32,
    member_42: f32,
    member_43: u32,
    member_44: u32,
    member_45: f32,
    member_46: u32,
    member_47: f32,
    member_48: f32,
    member_49: f32,
    member_50: vec4<f32>,
    member_51: vec4<f32>,
    member_52: vec4<f32>,
    member_53: array<vec4<f32>, 3>,
    member_54: array<vec4<u32>, 8>,
    member_55: array<vec4<u32>, 8>,
    member_56: array<type_8, 8>,
    member_57: array<vec4<f32>, 128>,
    member_58: array<vec4<f32>, 768>,
}

struct type_15 {
    member: array<u32>,
}

struct type_18 {
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

struct type_20 {
    member: array<u32, LENGTH_1_4>,
}

struct type_22 {
    member: array<u32, LENGTH_3_4>,
}

struct type_24 {
    member: array<u32, LENGTH_2_4>,
}

@group(0) @binding(0) 
var<uniform> global: type_12;
@group(0) @binding(1) 
var<storage> global_1: type_20;
@group(0) @binding(3) 
var<storage> global_2: type_22;
@group(0) @binding(2) 
var<storage, read_write> global_3: type_24;
@group(0) @binding(7) 
var<uniform> global_4: type_18;

@compute @workgroup_size(128, 1, 1) 
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
    var local: array<u32, 7>;
    var phi_302_: u32;
    var phi_301_: u32;
    var phi_303_: u32;
    var phi_309_: u32;
    var phi_306_: u32;
    var phi_305_: u32;
    var phi_307_: u32;
    var phi_311_: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e19 = bitcast<u32>(param[0u]);
            let _e22 = global_3.member[8i];
            let _e24 = global.member_46;
            let _e28 = global.member_4;
            let _e30 = vec2((_e24 << bitcast<u32>(_e22)));
            let _e33 = (((vec2<u32>(_e28) + _e30) - vec2<u32>(1u, 1u)) / _e30);
            if (_e19 > (_e33.x * _e33.y)) {
                break;
            }
            let _e40 = global_3.member[6i];
            phi_302_ = _e40;
            phi_301_ = 0u;
            loop {
                let _e42 = phi_302_;
                let _e44 = phi_301_;
                local_1 = _e44;
                if (_e44 < _e42) {
                    let _e46 = (_e42 - _e44);
                    phi_303_ = 0u;
                    loop {
                        let _e48 = phi_303_;
                        if (_e48 < 7u) {
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e50 = (_e48 + 1u);
                            let _e60 = global_1.member[(_e44 + ((_e50 * (_e46 / 8u)) + ((_e50 * (_e46 % 8u)) / 8u)))];
                            let _e65 = global_2.member[(_e60 >> bitcast<u32>(1u))];
                            local[_e48] = ((_e65 >> bitcast<u32>((16u * (_e60 & 1u)))) & 65535u);
                            phi_303_ = (_e48 + bitcast<u32>(1i));
                        }
                    }
                    phi_309_ = _e42;
                    phi_306_ = _e44;
                    phi_305_ = 0u;
                    loop {
                        let _e75 = phi_309_;
                        let _e77 = phi_306_;
                        let _e79 = phi_305_;
                        local_2 = _e75;
                        local_3 = _e77;
                        if (_e79 < 7u) {
                            let _e81 = (_e79 + 1u);
                            let _e88 = (_e44 + ((_e81 * (_e46 / 8u)) + ((_e81 * (_e46 % 8u)) / 8u)));
                            let _e90 = local[_e79];
                            let _e91 = (_e90 < _e19);
                            if _e91 {
                                phi_307_ = (_e88 + 1u);
                            } else {
                                phi_307_ = _e77;
                            }
                            let _e94 = phi_307_;
                            local_5 = _e94;
                            if _e91 {
                                phi_311_ = _e75;
                            } else {
                                phi_311_ = min(_e75, _e88);
                            }
                            let _e97 = phi_311_;
                            local_4 = _e97;
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e116 = local_4;
                            phi_309_ = _e116;
                            let _e119 = local_5;
                            phi_306_ = _e119;
                            phi_305_ = (_e79 + bitcast<u32>(1i));
                        }
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e109 = local_2;
                    phi_302_ = _e109;
                    let _e112 = local_3;
                    phi_301_ = _e112;
                }
            }
            let _e101 = global_4.member_12;
            let _e106 = local_1;
            global_3.member[(_e101 + _e19)] = _e106;
            break;
        }
    }
    return;
}
