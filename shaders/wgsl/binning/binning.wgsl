struct Splat {
    center: vec2<f32>,
    axis: vec2<f32>,
    shorter: f32,
    color: vec3<f32>,
    opacity: u32,
}

struct Layer {
    input_quads: u32,
    output_count: u32,
    weight: u32,
    bias: u32,
}

struct FrameBlock {
    focal: vec2<f32>,
    center: vec2<f32>,
    derivative_min: vec2<f32>,
    derivative_max: vec2<f32>,
    size: vec2<f32>,
    guard: f32,
    near: f32,
    key_far: f32,
    key_scale: f32,
    key_max: u32,
    fixed_scale: f32,
    position_min: vec4<f32>,
    position_step: vec4<f32>,
    clip: vec4<f32>,
    gaussians: u32,
    nodes: u32,
    parts: u32,
    head_parts: u32,
    basis_quads: u32,
    feature_quads: u32,
    node_feature: u32,
    node_start: u32,
    rotation_start: u32,
    scale_start: u32,
    color_start: u32,
    slope: f32,
    layers: u32,
    network_quads: u32,
    key_start: u32,
    cutoff: f32,
    quad_opacity: f32,
    body_quads: u32,
    log_scale_min: f32,
    log_scale_step: f32,
    sh_color_start: u32,
    half_keys: u32,
    count_start: u32,
    count_tile: u32,
    cache_start: u32,
    cache_unit: f32,
    feature_start: u32,
    first_splat: u32,
    tile_side: f32,
    detail_level: u32,
    drawn: u32,
    covariance_scale: f32,
    bin_side: u32,
    low_pass: f32,
    compensation: f32,
    area_reach: f32,
    area: vec4<f32>,
    cache_min: vec4<f32>,
    cache_size: vec4<f32>,
    camera_from_cache: array<vec4<f32>, 3>,
    idle_parts: array<vec4<u32>, 8>,
    culled_parts: array<vec4<u32>, 8>,
    layer: array<Layer, 8>,
    network_input: array<vec4<f32>, 128>,
    joint: array<vec4<f32>, 768>,
}

struct Control {
    index_count: u32,
    instance_count: u32,
    first_index: u32,
    vertex_offset: i32,
    first_instance: u32,
    key_count: u32,
    visible_count: u32,
    fragments: u32,
}

struct ControlBuffer {
    control: Control,
}

struct SettingsBlock {
    cutoff_exponent: f32,
    quad_exponent: f32,
    cutoff: f32,
    saturation: f32,
    sort_tiles: u32,
    key_capacity: u32,
    scanned: u32,
    key_count: u32,
    blocks: u32,
    counted: u32,
    first_region: vec2<u32>,
    counts_start: u32,
    starts_start: u32,
    pairs_start: u32,
    pair_capacity: u32,
}

struct Order {
    order: array<u32>,
}

struct Splats {
    splats: array<vec4<u32>>,
}

struct Bins {
    bins: array<atomic<u32>>,
}

struct Bins_1 {
    bins: array<atomic<u32>, LENGTH_4_4>,
}

struct Order_1 {
    order: array<u32, LENGTH_1_4>,
}

struct Splats_1 {
    splats: array<vec4<u32>, LENGTH_2_16>,
}

@group(0) @binding(0) 
var<uniform> frame: FrameBlock;
@group(0) @binding(4) 
var<storage, read_write> unnamed: Bins_1;
var<private> gl_GlobalInvocationID_1: vec3<u32>;
@group(0) @binding(3) 
var<storage, read_write> unnamed_1: ControlBuffer;
@group(0) @binding(7) 
var<uniform> settings: SettingsBlock;
@group(0) @binding(1) 
var<storage> unnamed_2: Order_1;
@group(0) @binding(2) 
var<storage> unnamed_3: Splats_1;

fn needs_block_u0028_u1_u003b(head_1: ptr<function, u32>) -> bool {
    var phi_269_: bool;

    let _e3 = (*head_1);
    let _e4 = (_e3 == 0u);
    phi_269_ = _e4;
    if !(_e4) {
        let _e6 = (*head_1);
        phi_269_ = ((_e6 & 7u) == 7u);
    }
    let _e10 = phi_269_;
    return _e10;
}

fn push_u0028_u1_u003b_u1_u003b_u1_u003b_u1_u003b(splat_1: ptr<function, u32>, at_1: ptr<function, u32>, head_2: ptr<function, u32>, block_1: ptr<function, u32>) {
    var param_22: u32;

    let _e9 = (*head_2);
    param_22 = _e9;
    let _e10 = needs_block_u0028_u1_u003b((&param_22));
    if _e10 {
        let _e11 = (*block_1);
        let _e14 = (*head_2);
        atomicStore((&unnamed.bins[(2306330u + (8u * _e11))]), _e14);
        let _e17 = (*block_1);
        (*head_2) = (8u * _e17);
    }
    let _e19 = (*head_2);
    (*head_2) = (_e19 + bitcast<u32>(1i));
    let _e22 = (*head_2);
    let _e24 = (*splat_1);
    atomicStore((&unnamed.bins[(2306330u + _e22)]), _e24);
    let _e27 = (*at_1);
    let _e28 = (*head_2);
    atomicStore((&unnamed.bins[_e27]), _e28);
    return;
}

fn tile_index_u0028_u1_u003b_vu2_u003b(level_1: ptr<function, u32>, at_2: ptr<function, vec2<u32>>) -> u32 {
    let _e10 = (*level_1);
    let _e18 = (*at_2)[1u];
    let _e19 = (*level_1);
    let _e26 = (*at_2)[0u];
    return (((((65536u - (65536u >> bitcast<u32>((4u * _e10)))) / 15u) * 16u) + (_e18 * (256u >> bitcast<u32>((2u * _e19))))) + _e26);
}

fn head_at_u0028_u1_u003b_vu2_u003b_u1_u003b(level_2: ptr<function, u32>, at_3: ptr<function, vec2<u32>>, run_1: ptr<function, u32>) -> u32 {
    var param_23: u32;
    var param_24: vec2<u32>;

    let _e7 = (*level_2);
    param_23 = _e7;
    let _e8 = (*at_3);
    param_24 = _e8;
    let _e9 = tile_index_u0028_u1_u003b_vu2_u003b((&param_23), (&param_24));
    let _e12 = (*run_1);
    return ((69890u + (_e9 * 32u)) + _e12);
}

fn half_box_u0028_struct_u002d_Splat_u002d_vf2_u002d_vf2_u002d_f1_u002d_vf3_u002d_u11_u003b_f1_u003b(splat_2: ptr<function, Splat>, radius: ptr<function, f32>) -> vec2<f32> {
    var steep: f32;

    let _e4 = (*splat_2).shorter;
    let _e6 = (*splat_2).axis;
    let _e8 = (*splat_2).axis;
    steep = (_e4 * inverseSqrt(dot(_e6, _e8)));
    let _e12 = (*radius);
    let _e14 = (*splat_2).axis;
    let _e16 = (*splat_2).axis;
    let _e18 = steep;
    let _e19 = steep;
    let _e22 = (*splat_2).axis;
    let _e26 = (*splat_2).axis;
    return (sqrt(((_e14 * _e16) + ((_e22.yx * (_e18 * _e19)) * _e26.yx))) * _e12);
}

fn visible_radius_u0028_f1_u003b(opacity: ptr<function, f32>) -> f32 {
    let _e4 = (*opacity);
    let _e6 = frame.cutoff;
    return sqrt((2f * log(max((_e4 / _e6), 1f))));
}

fn radius_of_u0028_u1_u003b(opacity_1: ptr<function, u32>) -> f32 {
    var param_25: f32;

    let _e3 = (*opacity_1);
    let _e6 = frame.quad_opacity;
    param_25 = max(f32(_e3), _e6);
    let _e8 = visible_radius_u0028_f1_u003b((&param_25));
    return _e8;
}

fn coarseness_of_u0028_vu4_u003b(words: ptr<function, vec4<u32>>) -> f32 {
    let _e6 = (*words)[1u];
    return bitcast<f32>((((_e6 >> bitcast<u32>(30u)) * 50331648u) + bitcast<u32>(1f)));
}

fn fixed_center_u0028_vu4_u003b(words_1: ptr<function, vec4<u32>>) -> vec2<f32> {
    let _e2 = (*words_1);
    return vec2<f32>((_e2.xy & vec2(1048575u)));
}

fn unpack_splat_u0028_vu4_u003b(words_2: ptr<function, vec4<u32>>) -> Splat {
    var splat_3: Splat;
    var param_26: vec4<u32>;
    var param_27: vec4<u32>;
    var blue: u32;
    var red: u32;
    var green: u32;

    let _e19 = (*words_2);
    param_26 = _e19;
    let _e20 = fixed_center_u0028_vu4_u003b((&param_26));
    let _e22 = frame.fixed_scale;
    let _e26 = frame.guard;
    let _e29 = (*words_2);
    param_27 = _e29;
    let _e30 = coarseness_of_u0028_vu4_u003b((&param_27));
    splat_3.center = (((_e20 / vec2(_e22)) - vec2(_e26)) * _e30);
    let _e34 = (*words_2)[2u];
    splat_3.axis = unpack2x16float(_e34);
    let _e38 = (*words_2)[3u];
    splat_3.shorter = unpack2x16float(_e38).x;
    let _e43 = (*words_2)[3u];
    let _e49 = (*words_2)[0u];
    blue = (((_e43 >> bitcast<u32>(24u)) << bitcast<u32>(2u)) | (_e49 >> bitcast<u32>(30u)));
    let _e54 = (*words_2)[0u];
    red = ((_e54 >> bitcast<u32>(20u)) & 1023u);
    let _e59 = (*words_2)[1u];
    green = ((_e59 >> bitcast<u32>(20u)) & 1023u);
    let _e63 = red;
    let _e65 = green;
    let _e67 = blue;
    splat_3.color = (vec3<f32>(f32(_e63), f32(_e65), f32(_e67)) / vec3(1023f));
    let _e74 = (*words_2)[3u];
    splat_3.opacity = ((_e74 >> bitcast<u32>(16u)) & 255u);
    let _e79 = splat_3;
    return _e79;
}

@compute @workgroup_size(8, 1, 1) 
fn main(@builtin(global_invocation_id) gl_GlobalInvocationID: vec3<u32>) {
    var run: u32;
    var length_: u32;
    var end: u32;
    var image_block: u32;
    var number: u32;
    var i: u32;
    var splat: Splat;
    var param: vec4<u32>;
    var box: vec2<f32>;
    var param_1: u32;
    var param_2: Splat;
    var param_3: f32;
    var low: vec2<u32>;
    var high: vec2<u32>;
    var block: u32;
    var level: u32;
    var side: f32;
    var last: f32;
    var needed: u32;
    var y: u32;
    var x: u32;
    var param_4: u32;
    var param_5: vec2<u32>;
    var param_6: u32;
    var param_7: u32;
    var local: u32;
    var param_8: u32;
    var param_9: vec2<u32>;
    var param_10: u32;
    var param_11: u32;
    var y_1: u32;
    var x_1: u32;
    var at: u32;
    var param_12: u32;
    var param_13: vec2<u32>;
    var param_14: u32;
    var head: u32;
    var param_15: u32;
    var param_16: vec2<u32>;
    var param_17: u32;
    var param_18: u32;
    var param_19: u32;
    var param_20: u32;
    var param_21: u32;

    gl_GlobalInvocationID_1 = gl_GlobalInvocationID;
    run = bitcast<u32>(gl_GlobalInvocationID[0u]);
    let _e65 = run;
    if (_e65 == 0u) {
        unnamed_1.control.fragments = 0u;
    }
    let _e71 = unnamed_1.control.visible_count;
    length_ = (((_e71 + 32u) - 1u) / 32u);
    let _e75 = run;
    let _e77 = length_;
    let _e81 = unnamed_1.control.visible_count;
    end = min(((_e75 + 1u) * _e77), _e81);
    let _e84 = settings.blocks;
    let _e86 = run;
    let _e87 = length_;
    image_block = ((_e84 + 1u) + (_e86 * (((_e87 + 7u) - 1u) / 7u)));
    let _e93 = run;
    let _e94 = length_;
    number = (_e93 * _e94);
    loop {
        let _e96 = number;
        let _e97 = end;
        if (_e96 < _e97) {
            let _e99 = number;
            let _e102 = unnamed_2.order[_e99];
            i = _e102;
            let _e103 = i;
            let _e106 = unnamed_3.splats[_e103];
            param = _e106;
            let _e107 = unpack_splat_u0028_vu4_u003b((&param));
            splat = _e107;
            let _e109 = splat.opacity;
            param_1 = _e109;
            let _e110 = radius_of_u0028_u1_u003b((&param_1));
            let _e111 = splat;
            param_2 = _e111;
            param_3 = _e110;
            let _e112 = half_box_u0028_struct_u002d_Splat_u002d_vf2_u002d_vf2_u002d_f1_u002d_vf3_u002d_u11_u003b_f1_u003b((&param_2), (&param_3));
            box = _e112;
            low = vec2<u32>(0u, 0u);
            high = vec2<u32>(0u, 0u);
            block = 0u;
            level = 0u;
            loop {
                let _e113 = level;
                if (_e113 < 3u) {
                    let _e116 = frame.tile_side;
                    let _e117 = level;
                    side = (_e116 * f32((1u << bitcast<u32>((2u * _e117)))));
                    let _e123 = level;
                    last = f32(((256u >> bitcast<u32>((2u * _e123))) - 1u));
                    let _e130 = splat.center;
                    let _e131 = box;
                    let _e133 = side;
                    let _e136 = last;
                    low = vec2<u32>(clamp(((_e130 - _e131) / vec2(_e133)), vec2(0f), vec2(_e136)));
                    let _e142 = splat.center;
                    let _e143 = box;
                    let _e145 = side;
                    let _e148 = last;
                    high = vec2<u32>(clamp(((_e142 + _e143) / vec2(_e145)), vec2(0f), vec2(_e148)));
                    let _e154 = high[0u];
                    let _e156 = low[0u];
                    let _e160 = high[1u];
                    let _e162 = low[1u];
                    if ((((_e154 - _e156) + 1u) * ((_e160 - _e162) + 1u)) > 16u) {
                        continue;
                    }
                    needed = 0u;
                    let _e168 = low[1u];
                    y = _e168;
                    loop {
                        let _e169 = y;
                        let _e171 = high[1u];
                        if (_e169 <= _e171) {
                            let _e174 = low[0u];
                            x = _e174;
                            loop {
                                let _e175 = x;
                                let _e177 = high[0u];
                                if (_e175 <= _e177) {
                                    let _e179 = x;
                                    let _e180 = y;
                                    let _e182 = level;
                                    param_4 = _e182;
                                    param_5 = vec2<u32>(_e179, _e180);
                                    let _e183 = run;
                                    param_6 = _e183;
                                    let _e184 = head_at_u0028_u1_u003b_vu2_u003b_u1_u003b((&param_4), (&param_5), (&param_6));
                                    let _e187 = atomicLoad((&unnamed.bins[_e184]));
                                    param_7 = _e187;
                                    let _e188 = needs_block_u0028_u1_u003b((&param_7));
                                    let _e190 = needed;
                                    needed = (_e190 + select(0u, 1u, _e188));
                                    continue;
                                } else {
                                    break;
                                }
                                continuing {
                                    let _e192 = x;
                                    x = (_e192 + bitcast<u32>(1i));
                                }
                            }
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e195 = y;
                            y = (_e195 + bitcast<u32>(1i));
                        }
                    }
                    let _e198 = needed;
                    if (_e198 > 0u) {
                        let _e202 = needed;
                        let _e203 = atomicAdd((&unnamed.bins[0i]), _e202);
                        local = (_e203 + 1u);
                    } else {
                        local = 1u;
                    }
                    let _e205 = local;
                    block = _e205;
                    let _e206 = block;
                    let _e207 = needed;
                    let _e210 = settings.blocks;
                    if ((_e206 + _e207) <= (_e210 + 1u)) {
                        break;
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e213 = level;
                    level = (_e213 + bitcast<u32>(1i));
                }
            }
            let _e216 = level;
            if (_e216 == 3u) {
                low = vec2<u32>(0u, 0u);
                high = vec2<u32>(0u, 0u);
                let _e218 = image_block;
                block = _e218;
                param_8 = 3u;
                let _e219 = low;
                param_9 = _e219;
                let _e220 = run;
                param_10 = _e220;
                let _e221 = head_at_u0028_u1_u003b_vu2_u003b_u1_u003b((&param_8), (&param_9), (&param_10));
                let _e224 = atomicLoad((&unnamed.bins[_e221]));
                param_11 = _e224;
                let _e225 = needs_block_u0028_u1_u003b((&param_11));
                let _e227 = image_block;
                image_block = (_e227 + select(0u, 1u, _e225));
            }
            let _e230 = low[1u];
            y_1 = _e230;
            loop {
                let _e231 = y_1;
                let _e233 = high[1u];
                if (_e231 <= _e233) {
                    let _e236 = low[0u];
                    x_1 = _e236;
                    loop {
                        let _e237 = x_1;
                        let _e239 = high[0u];
                        if (_e237 <= _e239) {
                            let _e241 = x_1;
                            let _e242 = y_1;
                            let _e244 = level;
                            param_12 = _e244;
                            param_13 = vec2<u32>(_e241, _e242);
                            let _e245 = run;
                            param_14 = _e245;
                            let _e246 = head_at_u0028_u1_u003b_vu2_u003b_u1_u003b((&param_12), (&param_13), (&param_14));
                            at = _e246;
                            let _e247 = at;
                            let _e250 = atomicLoad((&unnamed.bins[_e247]));
                            head = _e250;
                            let _e251 = head;
                            if (_e251 == 0u) {
                                let _e253 = x_1;
                                let _e254 = y_1;
                                let _e256 = level;
                                param_15 = _e256;
                                param_16 = vec2<u32>(_e253, _e254);
                                let _e257 = tile_index_u0028_u1_u003b_vu2_u003b((&param_15), (&param_16));
                                let _e261 = run;
                                let _e264 = atomicOr((&unnamed.bins[(1u + _e257)]), (1u << bitcast<u32>(_e261)));
                            }
                            let _e265 = i;
                            param_17 = _e265;
                            let _e266 = at;
                            param_18 = _e266;
                            let _e267 = head;
                            param_19 = _e267;
                            let _e268 = block;
                            param_20 = _e268;
                            push_u0028_u1_u003b_u1_u003b_u1_u003b_u1_u003b((&param_17), (&param_18), (&param_19), (&param_20));
                            let _e269 = head;
                            param_21 = _e269;
                            let _e270 = needs_block_u0028_u1_u003b((&param_21));
                            let _e272 = block;
                            block = (_e272 + select(0u, 1u, _e270));
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e274 = x_1;
                            x_1 = (_e274 + bitcast<u32>(1i));
                        }
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e277 = y_1;
                    y_1 = (_e277 + bitcast<u32>(1i));
                }
            }
            continue;
        } else {
            break;
        }
        continuing {
            let _e280 = number;
            number = (_e280 + bitcast<u32>(1i));
        }
    }
    return;
}
