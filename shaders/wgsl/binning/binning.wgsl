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
    occluder_margin: f32,
    pyramid_start: u32,
    occluder_origin: vec2<f32>,
    occluder_scale: vec2<f32>,
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
    cache_min: vec4<f32>,
    cache_size: vec4<f32>,
    camera_from_cache: array<vec4<f32>, 3>,
    idle_parts: array<vec4<u32>, 8>,
    culled_parts: array<vec4<u32>, 8>,
    layer: array<Layer, 8>,
    network_input: array<vec4<f32>, 128>,
    joint: array<vec4<f32>, 768>,
}

struct Bins {
    bins: array<u32>,
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
}

struct Order {
    order: array<u32>,
}

struct Splats {
    splats: array<vec4<u32>>,
}

struct Bins_1 {
    bins: array<atomic<u32>>,
}

struct Bins_2 {
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
var<storage, read_write> unnamed: Bins_2;
var<private> gl_GlobalInvocationID_1: vec3<u32>;
@group(0) @binding(3) 
var<storage, read_write> unnamed_1: ControlBuffer;
@group(0) @binding(7) 
var<uniform> settings: SettingsBlock;
@group(0) @binding(1) 
var<storage> unnamed_2: Order_1;
@group(0) @binding(2) 
var<storage> unnamed_3: Splats_1;

fn needs_block_u0028_u1_u003b(head: ptr<function, u32>) -> bool {
    var phi_242_: bool;

    let _e49 = (*head);
    let _e50 = (_e49 == 0u);
    phi_242_ = _e50;
    if !(_e50) {
        let _e52 = (*head);
        phi_242_ = ((_e52 & 7u) == 7u);
    }
    let _e56 = phi_242_;
    return _e56;
}

fn push_u0028_u1_u003b_u1_u003b_u1_u003b_u1_u003b(splat: ptr<function, u32>, at: ptr<function, u32>, head_1: ptr<function, u32>, block: ptr<function, u32>) {
    var param: u32;

    let _e53 = (*head_1);
    param = _e53;
    let _e54 = needs_block_u0028_u1_u003b((&param));
    if _e54 {
        let _e55 = (*block);
        let _e58 = (*head_1);
        atomicStore((&unnamed.bins[(2306330u + (8u * _e55))]), _e58);
        let _e61 = (*block);
        (*head_1) = (8u * _e61);
    }
    let _e63 = (*head_1);
    (*head_1) = (_e63 + bitcast<u32>(1i));
    let _e66 = (*head_1);
    let _e68 = (*splat);
    atomicStore((&unnamed.bins[(2306330u + _e66)]), _e68);
    let _e71 = (*at);
    let _e72 = (*head_1);
    atomicStore((&unnamed.bins[_e71]), _e72);
    return;
}

fn tile_index_u0028_u1_u003b_vu2_u003b(level: ptr<function, u32>, at_1: ptr<function, vec2<u32>>) -> u32 {
    let _e50 = (*level);
    let _e58 = (*at_1)[1u];
    let _e59 = (*level);
    let _e66 = (*at_1)[0u];
    return (((((65536u - (65536u >> bitcast<u32>((4u * _e50)))) / 15u) * 16u) + (_e58 * (256u >> bitcast<u32>((2u * _e59))))) + _e66);
}

fn head_at_u0028_u1_u003b_vu2_u003b_u1_u003b(level_1: ptr<function, u32>, at_2: ptr<function, vec2<u32>>, run: ptr<function, u32>) -> u32 {
    var param_1: u32;
    var param_2: vec2<u32>;

    let _e53 = (*level_1);
    param_1 = _e53;
    let _e54 = (*at_2);
    param_2 = _e54;
    let _e55 = tile_index_u0028_u1_u003b_vu2_u003b((&param_1), (&param_2));
    let _e58 = (*run);
    return ((69890u + (_e55 * 32u)) + _e58);
}

fn half_box_u0028_struct_u002d_Splat_u002d_vf2_u002d_vf2_u002d_f1_u002d_vf3_u002d_u11_u003b_f1_u003b(splat_1: ptr<function, Splat>, radius: ptr<function, f32>) -> vec2<f32> {
    var steep: f32;

    let _e52 = (*splat_1).shorter;
    let _e54 = (*splat_1).axis;
    let _e56 = (*splat_1).axis;
    steep = (_e52 * inverseSqrt(dot(_e54, _e56)));
    let _e60 = (*radius);
    let _e62 = (*splat_1).axis;
    let _e64 = (*splat_1).axis;
    let _e66 = steep;
    let _e67 = steep;
    let _e70 = (*splat_1).axis;
    let _e74 = (*splat_1).axis;
    return (sqrt(((_e62 * _e64) + ((_e70.yx * (_e66 * _e67)) * _e74.yx))) * _e60);
}

fn radius_of_u0028_u1_u003b(opacity: ptr<function, u32>) -> f32 {
    let _e49 = (*opacity);
    let _e52 = frame.quad_opacity;
    let _e55 = frame.cutoff;
    return sqrt((2f * log(max((max(f32(_e49), _e52) / _e55), 1f))));
}

fn fixed_center_u0028_vu4_u003b(words: ptr<function, vec4<u32>>) -> vec2<f32> {
    let _e49 = (*words);
    return vec2<f32>((_e49.xy & vec2(1048575u)));
}

fn unpack_splat_u0028_vu4_u003b(words_1: ptr<function, vec4<u32>>) -> Splat {
    var splat_2: Splat;
    var param_3: vec4<u32>;
    var blue: u32;
    var red: u32;
    var green: u32;

    let _e54 = (*words_1);
    param_3 = _e54;
    let _e55 = fixed_center_u0028_vu4_u003b((&param_3));
    let _e57 = frame.fixed_scale;
    let _e61 = frame.guard;
    splat_2.center = ((_e55 / vec2(_e57)) - vec2(_e61));
    let _e66 = (*words_1)[2u];
    splat_2.axis = unpack2x16float(_e66);
    let _e70 = (*words_1)[3u];
    splat_2.shorter = unpack2x16float(_e70).x;
    let _e75 = (*words_1)[3u];
    let _e81 = (*words_1)[0u];
    blue = (((_e75 >> bitcast<u32>(24u)) << bitcast<u32>(2u)) | (_e81 >> bitcast<u32>(30u)));
    let _e86 = (*words_1)[0u];
    red = ((_e86 >> bitcast<u32>(20u)) & 1023u);
    let _e91 = (*words_1)[1u];
    green = ((_e91 >> bitcast<u32>(20u)) & 1023u);
    let _e95 = red;
    let _e97 = green;
    let _e99 = blue;
    splat_2.color = (vec3<f32>(f32(_e95), f32(_e97), f32(_e99)) / vec3(1023f));
    let _e106 = (*words_1)[3u];
    splat_2.opacity = ((_e106 >> bitcast<u32>(16u)) & 255u);
    let _e111 = splat_2;
    return _e111;
}

fn main_1() {
    var run_1: u32;
    var length_: u32;
    var end: u32;
    var image_block: u32;
    var number: u32;
    var i: u32;
    var splat_3: Splat;
    var param_4: vec4<u32>;
    var box: vec2<f32>;
    var param_5: u32;
    var param_6: Splat;
    var param_7: f32;
    var low: vec2<u32>;
    var high: vec2<u32>;
    var block_1: u32;
    var level_2: u32;
    var side: f32;
    var last: f32;
    var needed: u32;
    var y: u32;
    var x: u32;
    var param_8: u32;
    var param_9: vec2<u32>;
    var param_10: u32;
    var param_11: u32;
    var local: u32;
    var param_12: u32;
    var param_13: vec2<u32>;
    var param_14: u32;
    var param_15: u32;
    var y_1: u32;
    var x_1: u32;
    var at_3: u32;
    var param_16: u32;
    var param_17: vec2<u32>;
    var param_18: u32;
    var head_2: u32;
    var param_19: u32;
    var param_20: vec2<u32>;
    var param_21: u32;
    var param_22: u32;
    var param_23: u32;
    var param_24: u32;
    var param_25: u32;

    let _e93 = gl_GlobalInvocationID_1[0u];
    run_1 = _e93;
    let _e94 = run_1;
    if (_e94 == 0u) {
        unnamed_1.control.fragments = 0u;
    }
    let _e100 = unnamed_1.control.visible_count;
    length_ = (((_e100 + 32u) - 1u) / 32u);
    let _e104 = run_1;
    let _e106 = length_;
    let _e110 = unnamed_1.control.visible_count;
    end = min(((_e104 + 1u) * _e106), _e110);
    let _e113 = settings.blocks;
    let _e115 = run_1;
    let _e116 = length_;
    image_block = ((_e113 + 1u) + (_e115 * (((_e116 + 7u) - 1u) / 7u)));
    let _e122 = run_1;
    let _e123 = length_;
    number = (_e122 * _e123);
    loop {
        let _e125 = number;
        let _e126 = end;
        if (_e125 < _e126) {
            let _e128 = number;
            let _e131 = unnamed_2.order[_e128];
            i = _e131;
            let _e132 = i;
            let _e135 = unnamed_3.splats[_e132];
            param_4 = _e135;
            let _e136 = unpack_splat_u0028_vu4_u003b((&param_4));
            splat_3 = _e136;
            let _e138 = splat_3.opacity;
            param_5 = _e138;
            let _e139 = radius_of_u0028_u1_u003b((&param_5));
            let _e140 = splat_3;
            param_6 = _e140;
            param_7 = _e139;
            let _e141 = half_box_u0028_struct_u002d_Splat_u002d_vf2_u002d_vf2_u002d_f1_u002d_vf3_u002d_u11_u003b_f1_u003b((&param_6), (&param_7));
            box = _e141;
            low = vec2<u32>(0u, 0u);
            high = vec2<u32>(0u, 0u);
            block_1 = 0u;
            level_2 = 0u;
            loop {
                let _e142 = level_2;
                if (_e142 < 3u) {
                    let _e145 = frame.tile_side;
                    let _e146 = level_2;
                    side = (_e145 * f32((1u << bitcast<u32>((2u * _e146)))));
                    let _e152 = level_2;
                    last = f32(((256u >> bitcast<u32>((2u * _e152))) - 1u));
                    let _e159 = splat_3.center;
                    let _e160 = box;
                    let _e162 = side;
                    let _e165 = last;
                    low = vec2<u32>(clamp(((_e159 - _e160) / vec2(_e162)), vec2(0f), vec2(_e165)));
                    let _e171 = splat_3.center;
                    let _e172 = box;
                    let _e174 = side;
                    let _e177 = last;
                    high = vec2<u32>(clamp(((_e171 + _e172) / vec2(_e174)), vec2(0f), vec2(_e177)));
                    let _e183 = high[0u];
                    let _e185 = low[0u];
                    let _e189 = high[1u];
                    let _e191 = low[1u];
                    if ((((_e183 - _e185) + 1u) * ((_e189 - _e191) + 1u)) > 16u) {
                        continue;
                    }
                    needed = 0u;
                    let _e197 = low[1u];
                    y = _e197;
                    loop {
                        let _e198 = y;
                        let _e200 = high[1u];
                        if (_e198 <= _e200) {
                            let _e203 = low[0u];
                            x = _e203;
                            loop {
                                let _e204 = x;
                                let _e206 = high[0u];
                                if (_e204 <= _e206) {
                                    let _e208 = x;
                                    let _e209 = y;
                                    let _e211 = level_2;
                                    param_8 = _e211;
                                    param_9 = vec2<u32>(_e208, _e209);
                                    let _e212 = run_1;
                                    param_10 = _e212;
                                    let _e213 = head_at_u0028_u1_u003b_vu2_u003b_u1_u003b((&param_8), (&param_9), (&param_10));
                                    let _e216 = atomicLoad((&unnamed.bins[_e213]));
                                    param_11 = _e216;
                                    let _e217 = needs_block_u0028_u1_u003b((&param_11));
                                    let _e219 = needed;
                                    needed = (_e219 + select(0u, 1u, _e217));
                                    continue;
                                } else {
                                    break;
                                }
                                continuing {
                                    let _e221 = x;
                                    x = (_e221 + bitcast<u32>(1i));
                                }
                            }
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e224 = y;
                            y = (_e224 + bitcast<u32>(1i));
                        }
                    }
                    let _e227 = needed;
                    if (_e227 > 0u) {
                        let _e231 = needed;
                        let _e232 = atomicAdd((&unnamed.bins[0i]), _e231);
                        local = (_e232 + 1u);
                    } else {
                        local = 1u;
                    }
                    let _e234 = local;
                    block_1 = _e234;
                    let _e235 = block_1;
                    let _e236 = needed;
                    let _e239 = settings.blocks;
                    if ((_e235 + _e236) <= (_e239 + 1u)) {
                        break;
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e242 = level_2;
                    level_2 = (_e242 + bitcast<u32>(1i));
                }
            }
            let _e245 = level_2;
            if (_e245 == 3u) {
                low = vec2<u32>(0u, 0u);
                high = vec2<u32>(0u, 0u);
                let _e247 = image_block;
                block_1 = _e247;
                param_12 = 3u;
                let _e248 = low;
                param_13 = _e248;
                let _e249 = run_1;
                param_14 = _e249;
                let _e250 = head_at_u0028_u1_u003b_vu2_u003b_u1_u003b((&param_12), (&param_13), (&param_14));
                let _e253 = atomicLoad((&unnamed.bins[_e250]));
                param_15 = _e253;
                let _e254 = needs_block_u0028_u1_u003b((&param_15));
                let _e256 = image_block;
                image_block = (_e256 + select(0u, 1u, _e254));
            }
            let _e259 = low[1u];
            y_1 = _e259;
            loop {
                let _e260 = y_1;
                let _e262 = high[1u];
                if (_e260 <= _e262) {
                    let _e265 = low[0u];
                    x_1 = _e265;
                    loop {
                        let _e266 = x_1;
                        let _e268 = high[0u];
                        if (_e266 <= _e268) {
                            let _e270 = x_1;
                            let _e271 = y_1;
                            let _e273 = level_2;
                            param_16 = _e273;
                            param_17 = vec2<u32>(_e270, _e271);
                            let _e274 = run_1;
                            param_18 = _e274;
                            let _e275 = head_at_u0028_u1_u003b_vu2_u003b_u1_u003b((&param_16), (&param_17), (&param_18));
                            at_3 = _e275;
                            let _e276 = at_3;
                            let _e279 = atomicLoad((&unnamed.bins[_e276]));
                            head_2 = _e279;
                            let _e280 = head_2;
                            if (_e280 == 0u) {
                                let _e282 = x_1;
                                let _e283 = y_1;
                                let _e285 = level_2;
                                param_19 = _e285;
                                param_20 = vec2<u32>(_e282, _e283);
                                let _e286 = tile_index_u0028_u1_u003b_vu2_u003b((&param_19), (&param_20));
                                let _e290 = run_1;
                                let _e293 = atomicOr((&unnamed.bins[(1u + _e286)]), (1u << bitcast<u32>(_e290)));
                            }
                            let _e294 = i;
                            param_21 = _e294;
                            let _e295 = at_3;
                            param_22 = _e295;
                            let _e296 = head_2;
                            param_23 = _e296;
                            let _e297 = block_1;
                            param_24 = _e297;
                            push_u0028_u1_u003b_u1_u003b_u1_u003b_u1_u003b((&param_21), (&param_22), (&param_23), (&param_24));
                            let _e298 = head_2;
                            param_25 = _e298;
                            let _e299 = needs_block_u0028_u1_u003b((&param_25));
                            let _e301 = block_1;
                            block_1 = (_e301 + select(0u, 1u, _e299));
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e303 = x_1;
                            x_1 = (_e303 + bitcast<u32>(1i));
                        }
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e306 = y_1;
                    y_1 = (_e306 + bitcast<u32>(1i));
                }
            }
            continue;
        } else {
            break;
        }
        continuing {
            let _e309 = number;
            number = (_e309 + bitcast<u32>(1i));
        }
    }
    return;
}

@compute @workgroup_size(8, 1, 1) 
fn main(@builtin(global_invocation_id) gl_GlobalInvocationID: vec3<u32>) {
    gl_GlobalInvocationID_1 = gl_GlobalInvocationID;
    main_1();
}
