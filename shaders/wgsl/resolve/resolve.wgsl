struct type_6 {
    member: vec2<i32>,
    member_1: vec2<i32>,
    member_2: f32,
}

var<private> global: vec4<f32>;
@group(0) @binding(1) 
var<uniform> global_1: type_6;
@group(0) @binding(0) 
var global_2: texture_2d<f32>;
var<private> global_3: vec4<f32>;

fn function_() {
    var phi_156_: f32;
    var phi_155_: vec4<f32>;
    var phi_154_: f32;
    var phi_160_: f32;
    var phi_159_: vec4<f32>;
    var phi_157_: f32;
    var phi_164_: f32;
    var phi_163_: vec4<f32>;
    var local: f32;
    var local_1: f32;
    var local_2: f32;
    var local_3: f32;
    var local_4: vec4<f32>;
    var local_5: f32;
    var local_6: vec4<f32>;
    var local_7: f32;
    var local_8: f32;
    var local_9: vec4<f32>;
    var local_10: f32;

    let _e12 = global;
    let _e16 = global_1.member;
    let _e18 = vec2<f32>((vec2<i32>(_e12.xy) - _e16));
    let _e20 = global_1.member_2;
    let _e21 = (_e18 * _e20);
    let _e23 = ((_e18 + vec2<f32>(1f, 1f)) * _e20);
    phi_156_ = 0f;
    phi_155_ = vec4<f32>(0f, 0f, 0f, 0f);
    phi_154_ = floor(_e21.y);
    loop {
        let _e27 = phi_156_;
        let _e29 = phi_155_;
        let _e31 = phi_154_;
        local = _e27;
        local_1 = _e27;
        local_2 = _e27;
        local_3 = _e27;
        local_4 = _e29;
        if (_e31 < _e23.y) {
            let _e34 = (_e31 + 1f);
            let _e37 = (min(_e23.y, _e34) - max(_e21.y, _e31));
            local_7 = _e34;
            phi_160_ = _e27;
            phi_159_ = _e29;
            phi_157_ = floor(_e21.x);
            loop {
                let _e41 = phi_160_;
                let _e43 = phi_159_;
                let _e45 = phi_157_;
                local_5 = _e41;
                local_6 = _e43;
                if (_e45 < _e23.x) {
                    let _e48 = (_e45 + 1f);
                    let _e51 = (min(_e23.x, _e48) - max(_e21.x, _e45));
                    local_10 = _e48;
                    phi_164_ = _e41;
                    phi_163_ = _e43;
                    if (min(_e37, _e51) > 0.001f) {
                        let _e54 = (_e37 * _e51);
                        let _e56 = global_1.member_1;
                        let _e61 = textureLoad(global_2, (_e56 + vec2<i32>(i32(_e45), i32(_e31))), 0i);
                        phi_164_ = (_e41 + _e54);
                        phi_163_ = (_e43 + (_e61 * _e54));
                    }
                    let _e66 = phi_164_;
                    let _e68 = phi_163_;
                    local_8 = _e66;
                    local_9 = _e68;
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e92 = local_8;
                    phi_160_ = _e92;
                    let _e95 = local_9;
                    phi_159_ = _e95;
                    let _e98 = local_10;
                    phi_157_ = _e98;
                }
            }
            continue;
        } else {
            break;
        }
        continuing {
            let _e83 = local_5;
            phi_156_ = _e83;
            let _e86 = local_6;
            phi_155_ = _e86;
            let _e89 = local_7;
            phi_154_ = _e89;
        }
    }
    let _e70 = local;
    let _e72 = local_1;
    let _e74 = local_2;
    let _e76 = local_3;
    let _e79 = local_4;
    global_3 = (_e79 / vec4<f32>(_e70, _e72, _e74, _e76));
    return;
}

@fragment 
fn main(@builtin(position) param: vec4<f32>) -> @location(0) vec4<f32> {
    global = param;
    function_();
    let _e3 = global_3;
    return _e3;
}
