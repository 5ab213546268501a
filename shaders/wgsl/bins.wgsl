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
    margin: f32,
    surface_start: u32,
    surface_origin: vec2<f32>,
    surface_scale: vec2<f32>,
    hull_opacity: f32,
    body_quads: u32,
    log_scale_min: f32,
    log_scale_step: f32,
    lit_start: u32,
    half_keys: u32,
    count_start: u32,
    count_tile: u32,
    posed_start: u32,
    posed_unit: f32,
    feature_start: u32,
    first: u32,
    tile: f32,
    level: u32,
    drawn: u32,
    spread: f32,
    posed_min: vec4<f32>,
    posed_size: vec4<f32>,
    turn: array<vec4<f32>, 3>,
    idle: array<vec4<u32>, 8>,
    outside: array<vec4<u32>, 8>,
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
    entering: u32,
    survivors: u32,
    fragments: u32,
}

struct ControlBuffer {
    control: Control,
}

struct SettingsBlock {
    least: f32,
    hull: f32,
    cutoff: f32,
    full: f32,
    tiles: u32,
    capacity: u32,
    scanned: u32,
    entering: u32,
    nodes: u32,
    count: u32,
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

fn full_u0028_u1_u003b(chain: ptr<function, u32>) -> bool {
    var phi_238_: bool;

    let _e50 = (*chain);
    let _e51 = (_e50 == 0u);
    phi_238_ = _e51;
    if !(_e51) {
        let _e53 = (*chain);
        phi_238_ = ((_e53 & 7u) == 7u);
    }
    let _e57 = phi_238_;
    return _e57;
}

fn put_u0028_u1_u003b_u1_u003b_u1_u003b_u1_u003b(splat: ptr<function, u32>, head: ptr<function, u32>, chain_1: ptr<function, u32>, node: ptr<function, u32>) {
    var param: u32;

    let _e54 = (*chain_1);
    param = _e54;
    let _e55 = full_u0028_u1_u003b((&param));
    if _e55 {
        let _e56 = (*node);
        let _e59 = (*chain_1);
        atomicStore((&unnamed.bins[(2306330u + (8u * _e56))]), _e59);
        let _e62 = (*node);
        (*chain_1) = (8u * _e62);
    }
    let _e64 = (*chain_1);
    (*chain_1) = (_e64 + bitcast<u32>(1i));
    let _e67 = (*chain_1);
    let _e69 = (*splat);
    atomicStore((&unnamed.bins[(2306330u + _e67)]), _e69);
    let _e72 = (*head);
    let _e73 = (*chain_1);
    atomicStore((&unnamed.bins[_e72]), _e73);
    return;
}

fn bins_tile_u0028_u1_u003b_vu2_u003b(level: ptr<function, u32>, at: ptr<function, vec2<u32>>) -> u32 {
    let _e51 = (*level);
    let _e59 = (*at)[1u];
    let _e60 = (*level);
    let _e67 = (*at)[0u];
    return (((((65536u - (65536u >> bitcast<u32>((4u * _e51)))) / 15u) * 16u) + (_e59 * (256u >> bitcast<u32>((2u * _e60))))) + _e67);
}

fn head_of_u0028_u1_u003b_vu2_u003b_u1_u003b(level_1: ptr<function, u32>, at_1: ptr<function, vec2<u32>>, block: ptr<function, u32>) -> u32 {
    var param_1: u32;
    var param_2: vec2<u32>;

    let _e54 = (*level_1);
    param_1 = _e54;
    let _e55 = (*at_1);
    param_2 = _e55;
    let _e56 = bins_tile_u0028_u1_u003b_vu2_u003b((&param_1), (&param_2));
    let _e59 = (*block);
    return ((69890u + (_e56 * 32u)) + _e59);
}

fn half_box_u0028_struct_u002d_Splat_u002d_vf2_u002d_vf2_u002d_f1_u002d_vf3_u002d_u11_u003b_f1_u003b(splat_1: ptr<function, Splat>, reach: ptr<function, f32>) -> vec2<f32> {
    var steep: f32;

    let _e53 = (*splat_1).shorter;
    let _e55 = (*splat_1).axis;
    let _e57 = (*splat_1).axis;
    steep = (_e53 * inverseSqrt(dot(_e55, _e57)));
    let _e61 = (*reach);
    let _e63 = (*splat_1).axis;
    let _e65 = (*splat_1).axis;
    let _e67 = steep;
    let _e68 = steep;
    let _e71 = (*splat_1).axis;
    let _e75 = (*splat_1).axis;
    return (sqrt(((_e63 * _e65) + ((_e71.yx * (_e67 * _e68)) * _e75.yx))) * _e61);
}

fn reach_of_u0028_u1_u003b(opacity: ptr<function, u32>) -> f32 {
    let _e50 = (*opacity);
    let _e53 = frame.hull_opacity;
    let _e56 = frame.cutoff;
    return sqrt((2f * log(max((max(f32(_e50), _e53) / _e56), 1f))));
}

fn steps_of_u0028_vu4_u003b(words: ptr<function, vec4<u32>>) -> vec2<f32> {
    let _e50 = (*words);
    return vec2<f32>((_e50.xy & vec2(1048575u)));
}

fn unpack_splat_u0028_vu4_u003b(words_1: ptr<function, vec4<u32>>) -> Splat {
    var splat_2: Splat;
    var param_3: vec4<u32>;
    var blue: u32;

    let _e53 = (*words_1);
    param_3 = _e53;
    let _e54 = steps_of_u0028_vu4_u003b((&param_3));
    let _e56 = frame.fixed_scale;
    let _e60 = frame.guard;
    splat_2.center = ((_e54 / vec2(_e56)) - vec2(_e60));
    let _e65 = (*words_1)[2u];
    splat_2.axis = unpack2x16float(_e65);
    let _e69 = (*words_1)[3u];
    splat_2.shorter = unpack2x16float(_e69).x;
    let _e74 = (*words_1)[3u];
    let _e80 = (*words_1)[0u];
    blue = (((_e74 >> bitcast<u32>(24u)) << bitcast<u32>(2u)) | (_e80 >> bitcast<u32>(30u)));
    let _e85 = (*words_1)[0u];
    let _e91 = (*words_1)[1u];
    let _e96 = blue;
    splat_2.color = (vec3<f32>(f32(((_e85 >> bitcast<u32>(20u)) & 1023u)), f32(((_e91 >> bitcast<u32>(20u)) & 1023u)), f32(_e96)) / vec3(1023f));
    let _e103 = (*words_1)[3u];
    splat_2.opacity = ((_e103 >> bitcast<u32>(16u)) & 255u);
    let _e108 = splat_2;
    return _e108;
}

fn main_1() {
    var block_1: u32;
    var length_: u32;
    var end: u32;
    var whole: u32;
    var number: u32;
    var i: u32;
    var splat_3: Splat;
    var param_4: vec4<u32>;
    var reach_1: vec2<f32>;
    var param_5: u32;
    var param_6: Splat;
    var param_7: f32;
    var low: vec2<u32>;
    var high: vec2<u32>;
    var node_1: u32;
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
    var head_1: u32;
    var param_16: u32;
    var param_17: vec2<u32>;
    var param_18: u32;
    var chain_2: u32;
    var param_19: u32;
    var param_20: vec2<u32>;
    var param_21: u32;
    var param_22: u32;
    var param_23: u32;
    var param_24: u32;
    var param_25: u32;

    let _e94 = gl_GlobalInvocationID_1[0u];
    block_1 = _e94;
    let _e95 = block_1;
    if (_e95 == 0u) {
        unnamed_1.control.fragments = 0u;
    }
    let _e101 = unnamed_1.control.survivors;
    length_ = (((_e101 + 32u) - 1u) / 32u);
    let _e105 = block_1;
    let _e107 = length_;
    let _e111 = unnamed_1.control.survivors;
    end = min(((_e105 + 1u) * _e107), _e111);
    let _e114 = settings.nodes;
    let _e116 = block_1;
    let _e117 = length_;
    whole = ((_e114 + 1u) + (_e116 * (((_e117 + 7u) - 1u) / 7u)));
    let _e123 = block_1;
    let _e124 = length_;
    number = (_e123 * _e124);
    loop {
        let _e126 = number;
        let _e127 = end;
        if (_e126 < _e127) {
            let _e129 = number;
            let _e132 = unnamed_2.order[_e129];
            i = _e132;
            let _e133 = i;
            let _e136 = unnamed_3.splats[_e133];
            param_4 = _e136;
            let _e137 = unpack_splat_u0028_vu4_u003b((&param_4));
            splat_3 = _e137;
            let _e139 = splat_3.opacity;
            param_5 = _e139;
            let _e140 = reach_of_u0028_u1_u003b((&param_5));
            let _e141 = splat_3;
            param_6 = _e141;
            param_7 = _e140;
            let _e142 = half_box_u0028_struct_u002d_Splat_u002d_vf2_u002d_vf2_u002d_f1_u002d_vf3_u002d_u11_u003b_f1_u003b((&param_6), (&param_7));
            reach_1 = _e142;
            low = vec2<u32>(0u, 0u);
            high = vec2<u32>(0u, 0u);
            node_1 = 0u;
            level_2 = 0u;
            loop {
                let _e143 = level_2;
                if (_e143 < 3u) {
                    let _e146 = frame.tile;
                    let _e147 = level_2;
                    side = (_e146 * f32((1u << bitcast<u32>((2u * _e147)))));
                    let _e153 = level_2;
                    last = f32(((256u >> bitcast<u32>((2u * _e153))) - 1u));
                    let _e160 = splat_3.center;
                    let _e161 = reach_1;
                    let _e163 = side;
                    let _e166 = last;
                    low = vec2<u32>(clamp(((_e160 - _e161) / vec2(_e163)), vec2(0f), vec2(_e166)));
                    let _e172 = splat_3.center;
                    let _e173 = reach_1;
                    let _e175 = side;
                    let _e178 = last;
                    high = vec2<u32>(clamp(((_e172 + _e173) / vec2(_e175)), vec2(0f), vec2(_e178)));
                    let _e184 = high[0u];
                    let _e186 = low[0u];
                    let _e190 = high[1u];
                    let _e192 = low[1u];
                    if ((((_e184 - _e186) + 1u) * ((_e190 - _e192) + 1u)) > 16u) {
                        continue;
                    }
                    needed = 0u;
                    let _e198 = low[1u];
                    y = _e198;
                    loop {
                        let _e199 = y;
                        let _e201 = high[1u];
                        if (_e199 <= _e201) {
                            let _e204 = low[0u];
                            x = _e204;
                            loop {
                                let _e205 = x;
                                let _e207 = high[0u];
                                if (_e205 <= _e207) {
                                    let _e209 = x;
                                    let _e210 = y;
                                    let _e212 = level_2;
                                    param_8 = _e212;
                                    param_9 = vec2<u32>(_e209, _e210);
                                    let _e213 = block_1;
                                    param_10 = _e213;
                                    let _e214 = head_of_u0028_u1_u003b_vu2_u003b_u1_u003b((&param_8), (&param_9), (&param_10));
                                    let _e217 = atomicLoad((&unnamed.bins[_e214]));
                                    param_11 = _e217;
                                    let _e218 = full_u0028_u1_u003b((&param_11));
                                    let _e220 = needed;
                                    needed = (_e220 + select(0u, 1u, _e218));
                                    continue;
                                } else {
                                    break;
                                }
                                continuing {
                                    let _e222 = x;
                                    x = (_e222 + bitcast<u32>(1i));
                                }
                            }
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e225 = y;
                            y = (_e225 + bitcast<u32>(1i));
                        }
                    }
                    let _e228 = needed;
                    if (_e228 > 0u) {
                        let _e232 = needed;
                        let _e233 = atomicAdd((&unnamed.bins[0i]), _e232);
                        local = (_e233 + 1u);
                    } else {
                        local = 1u;
                    }
                    let _e235 = local;
                    node_1 = _e235;
                    let _e236 = node_1;
                    let _e237 = needed;
                    let _e240 = settings.nodes;
                    if ((_e236 + _e237) <= (_e240 + 1u)) {
                        break;
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e243 = level_2;
                    level_2 = (_e243 + bitcast<u32>(1i));
                }
            }
            let _e246 = level_2;
            if (_e246 == 3u) {
                low = vec2<u32>(0u, 0u);
                high = vec2<u32>(0u, 0u);
                let _e248 = whole;
                node_1 = _e248;
                param_12 = 3u;
                let _e249 = low;
                param_13 = _e249;
                let _e250 = block_1;
                param_14 = _e250;
                let _e251 = head_of_u0028_u1_u003b_vu2_u003b_u1_u003b((&param_12), (&param_13), (&param_14));
                let _e254 = atomicLoad((&unnamed.bins[_e251]));
                param_15 = _e254;
                let _e255 = full_u0028_u1_u003b((&param_15));
                let _e257 = whole;
                whole = (_e257 + select(0u, 1u, _e255));
            }
            let _e260 = low[1u];
            y_1 = _e260;
            loop {
                let _e261 = y_1;
                let _e263 = high[1u];
                if (_e261 <= _e263) {
                    let _e266 = low[0u];
                    x_1 = _e266;
                    loop {
                        let _e267 = x_1;
                        let _e269 = high[0u];
                        if (_e267 <= _e269) {
                            let _e271 = x_1;
                            let _e272 = y_1;
                            let _e274 = level_2;
                            param_16 = _e274;
                            param_17 = vec2<u32>(_e271, _e272);
                            let _e275 = block_1;
                            param_18 = _e275;
                            let _e276 = head_of_u0028_u1_u003b_vu2_u003b_u1_u003b((&param_16), (&param_17), (&param_18));
                            head_1 = _e276;
                            let _e277 = head_1;
                            let _e280 = atomicLoad((&unnamed.bins[_e277]));
                            chain_2 = _e280;
                            let _e281 = chain_2;
                            if (_e281 == 0u) {
                                let _e283 = x_1;
                                let _e284 = y_1;
                                let _e286 = level_2;
                                param_19 = _e286;
                                param_20 = vec2<u32>(_e283, _e284);
                                let _e287 = bins_tile_u0028_u1_u003b_vu2_u003b((&param_19), (&param_20));
                                let _e291 = block_1;
                                let _e294 = atomicOr((&unnamed.bins[(1u + _e287)]), (1u << bitcast<u32>(_e291)));
                            }
                            let _e295 = i;
                            param_21 = _e295;
                            let _e296 = head_1;
                            param_22 = _e296;
                            let _e297 = chain_2;
                            param_23 = _e297;
                            let _e298 = node_1;
                            param_24 = _e298;
                            put_u0028_u1_u003b_u1_u003b_u1_u003b_u1_u003b((&param_21), (&param_22), (&param_23), (&param_24));
                            let _e299 = chain_2;
                            param_25 = _e299;
                            let _e300 = full_u0028_u1_u003b((&param_25));
                            let _e302 = node_1;
                            node_1 = (_e302 + select(0u, 1u, _e300));
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e304 = x_1;
                            x_1 = (_e304 + bitcast<u32>(1i));
                        }
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e307 = y_1;
                    y_1 = (_e307 + bitcast<u32>(1i));
                }
            }
            continue;
        } else {
            break;
        }
        continuing {
            let _e310 = number;
            number = (_e310 + bitcast<u32>(1i));
        }
    }
    return;
}

@compute @workgroup_size(8, 1, 1) 
fn main(@builtin(global_invocation_id) gl_GlobalInvocationID: vec3<u32>) {
    gl_GlobalInvocationID_1 = gl_GlobalInvocationID;
    main_1();
}
