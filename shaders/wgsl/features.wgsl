struct type_6 {
    member: array<u32>,
}

struct type_13 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_17 {
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
    member_32: vec2<f32>,
    member_33: vec2<f32>,
    member_34: f32,
    member_35: u32,
    member_36: f32,
    member_37: f32,
    member_38: u32,
    member_39: u32,
    member_40: u32,
    member_41: u32,
    member_42: u32,
    member_43: f32,
    member_44: u32,
    member_45: u32,
    member_46: f32,
    member_47: vec4<f32>,
    member_48: vec4<f32>,
    member_49: array<vec4<f32>, 3>,
    member_50: array<vec4<u32>, 8>,
    member_51: array<vec4<u32>, 8>,
    member_52: array<type_13, 8>,
    member_53: array<vec4<f32>, 128>,
    member_54: array<vec4<f32>, 768>,
}

struct type_20 {
    member: array<vec2<u32>>,
}

@group(0) @binding(3) 
var<storage> global: type_6;
@group(0) @binding(0) 
var<uniform> global_1: type_17;
var<workgroup> global_2: array<f32, 256>;
@group(0) @binding(2) 
var<storage> global_3: type_6;
@group(0) @binding(4) 
var<storage, read_write> global_4: type_6;
@group(0) @binding(1) 
var<storage> global_5: type_20;

@compute @workgroup_size(64, 1, 1) 
fn main(@builtin(local_invocation_id) param: vec3<u32>, @builtin(workgroup_id) param_1: vec3<u32>) {
    var local: vec3<f32>;
    var local_1: vec4<f32>;
    var phi_691_: u32;
    var phi_692_: u32;
    var phi_699_: u32;
    var phi_703_: f32;
    var phi_702_: u32;
    var phi_711_: vec4<f32>;
    var local_2: f32;
    var local_3: u32;
    var phi_693_: u32;
    var phi_694_: u32;
    var phi_696_: u32;
    var local_4: u32;
    var local_5: f32;

    switch bitcast<i32>(0u) {
        default: {
            let _e30 = bitcast<u32>(param_1[0u]);
            let _e37 = global_1.member_50[(_e30 / 128u)][((_e30 / 32u) & 3u)];
            if (((_e37 >> bitcast<u32>((_e30 & 31u))) & 1u) != 0u) {
                break;
            }
            let _e44 = global_1.member_27;
            let _e45 = (_e30 * _e44);
            let _e47 = global_1.member_17;
            let _e48 = (_e30 < _e47);
            if _e48 {
                let _e53 = global_1.member_52[0i].member;
                phi_691_ = _e53;
            } else {
                let _e55 = global_1.member_35;
                phi_691_ = _e55;
            }
            let _e57 = phi_691_;
            phi_692_ = 0u;
            loop {
                let _e59 = phi_692_;
                let _e61 = global_1.member_26;
                local_3 = _e61;
                if (_e59 < _e61) {
                    let _e65 = global_1.member_52[_e59];
                    let _e71 = ((_e59 & 1u) * 128u);
                    let _e72 = (128u - _e71);
                    phi_699_ = bitcast<u32>(param[0u]);
                    loop {
                        let _e78 = phi_699_;
                        if (_e78 < _e65.member_1) {
                            let _e85 = global_5.member[((_e45 + _e65.member_3) + (_e78 / 4u))];
                            let _e87 = unpack2x16float(_e85.x);
                            let _e89 = unpack2x16float(_e85.y);
                            local_1 = vec4<f32>(_e87.x, _e87.y, _e89.x, _e89.y);
                            let _e97 = local_1[(_e78 & 3u)];
                            let _e100 = (_e59 == 0u);
                            phi_703_ = _e97;
                            phi_702_ = 0u;
                            loop {
                                let _e103 = phi_703_;
                                let _e105 = phi_702_;
                                local_2 = _e103;
                                if (_e105 < select(_e65.member, _e57, _e100)) {
                                    if _e100 {
                                        let _e110 = global_1.member_53[(select(64u, 0u, _e48) + _e105)];
                                        phi_711_ = _e110;
                                    } else {
                                        let _e112 = (_e71 + (4u * _e105));
                                        let _e114 = global_2[_e112];
                                        let _e117 = global_2[(_e112 + 1u)];
                                        let _e120 = global_2[(_e112 + 2u)];
                                        let _e123 = global_2[(_e112 + 3u)];
                                        phi_711_ = vec4<f32>(_e114, _e117, _e120, _e123);
                                    }
                                    let _e126 = phi_711_;
                                    let _e131 = global_5.member[(((_e45 + _e65.member_2) + _e78) + (_e105 * _e65.member_1))];
                                    let _e133 = unpack2x16float(_e131.x);
                                    let _e135 = unpack2x16float(_e131.y);
                                    local_5 = (_e103 + dot(vec4<f32>(_e133.x, _e133.y, _e135.x, _e135.y), _e126));
                                    continue;
                                } else {
                                    break;
                                }
                                continuing {
                                    let _e279 = local_5;
                                    phi_703_ = _e279;
                                    phi_702_ = (_e105 + bitcast<u32>(1i));
                                }
                            }
                            let _e146 = local_2;
                            let _e147 = clamp(_e146, -65504f, 65504f);
                            if ((_e59 + 1u) == _e61) {
                                let _e149 = global_1.member_44;
                                let _e151 = global_1.member_19;
                                global_4.member[((4u * (_e149 + (_e30 * _e151))) + _e78)] = bitcast<u32>(_e147);
                                global_2[(_e72 + _e78)] = _e147;
                            } else {
                                let _e163 = global_1.member_25;
                                global_2[(_e72 + _e78)] = max(_e147, (_e163 * _e147));
                            }
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            phi_699_ = (_e78 + 64u);
                        }
                    }
                    workgroupBarrier();
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_692_ = (_e59 + bitcast<u32>(1i));
                }
            }
            let _e171 = local_3;
            let _e175 = global_1.member_20;
            let _e180 = global.member[_e30];
            phi_693_ = (_e180 + bitcast<u32>(param[0u]));
            loop {
                let _e185 = phi_693_;
                let _e189 = global.member[(_e30 + 1u)];
                if (_e185 < _e189) {
                    local = vec3<f32>(0f, 0f, 0f);
                    phi_694_ = 0u;
                    loop {
                        let _e192 = phi_694_;
                        let _e194 = global_1.member_18;
                        local_4 = _e194;
                        if (_e192 < _e194) {
                            let _e197 = ((((_e171 & 1u) * 128u) + (4u * _e175)) + (4u * _e192));
                            let _e199 = global_2[_e197];
                            let _e202 = global_2[(_e197 + 1u)];
                            let _e205 = global_2[(_e197 + 2u)];
                            let _e208 = global_2[(_e197 + 3u)];
                            phi_696_ = 0u;
                            loop {
                                let _e211 = phi_696_;
                                if (_e211 < 3u) {
                                    continue;
                                } else {
                                    break;
                                }
                                continuing {
                                    let _e216 = global_1.member_15;
                                    let _e221 = global_3.member[((((_e211 * _e194) + _e192) * _e216) + _e185)];
                                    let _e225 = local[_e211];
                                    local[_e211] = (_e225 + dot(unpack4x8snorm(_e221), vec4<f32>(_e199, _e202, _e205, _e208)));
                                    phi_696_ = (_e211 + bitcast<u32>(1i));
                                }
                            }
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            phi_694_ = (_e192 + bitcast<u32>(1i));
                        }
                    }
                    let _e232 = local_4;
                    let _e235 = global_1.member_15;
                    let _e237 = (2u * _e185);
                    let _e238 = (((3u * _e232) * _e235) + _e237);
                    let _e242 = global_3.member[(_e238 + 1u)];
                    let _e243 = unpack2x16float(_e242);
                    let _e246 = global_3.member[_e238];
                    let _e247 = unpack2x16float(_e246);
                    let _e254 = local;
                    let _e257 = clamp((vec3<f32>(_e247.x, _e247.y, _e243.x) + (_e254 * (127f * _e243.y))), vec3<f32>(-65504f, -65504f, -65504f), vec3<f32>(65504f, 65504f, 65504f));
                    local = _e257;
                    let _e259 = global_1.member_21;
                    let _e261 = ((4u * _e259) + _e237);
                    global_4.member[_e261] = pack2x16float(_e257.xy);
                    let _e268 = local[2u];
                    global_4.member[(_e261 + 1u)] = pack2x16float(vec2<f32>(_e268, 0f));
                    continue;
                } else {
                    break;
                }
                continuing {
                    phi_693_ = (_e185 + 64u);
                }
            }
            break;
        }
    }
    return;
}
