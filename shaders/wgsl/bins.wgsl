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
    var phi_237_: bool;

    let _e48 = (*chain);
    let _e49 = (_e48 == 0u);
    phi_237_ = _e49;
    if !(_e49) {
        let _e51 = (*chain);
        phi_237_ = ((_e51 & 7u) == 7u);
    }
    let _e55 = phi_237_;
    return _e55;
}

fn put_u0028_u1_u003b_u1_u003b_u1_u003b_u1_u003b(splat: ptr<function, u32>, head: ptr<function, u32>, chain_1: ptr<function, u32>, node: ptr<function, u32>) {
    var param: u32;

    let _e52 = (*chain_1);
    param = _e52;
    let _e53 = full_u0028_u1_u003b((&param));
    if _e53 {
        let _e54 = (*node);
        let _e57 = (*chain_1);
        atomicStore((&unnamed.bins[(576602u + (8u * _e54))]), _e57);
        let _e60 = (*node);
        (*chain_1) = (8u * _e60);
    }
    let _e62 = (*chain_1);
    (*chain_1) = (_e62 + bitcast<u32>(1i));
    let _e65 = (*chain_1);
    let _e67 = (*splat);
    atomicStore((&unnamed.bins[(576602u + _e65)]), _e67);
    let _e70 = (*head);
    let _e71 = (*chain_1);
    atomicStore((&unnamed.bins[_e70]), _e71);
    return;
}

fn bins_tile_u0028_u1_u003b_vu2_u003b(level: ptr<function, u32>, at: ptr<function, vec2<u32>>) -> u32 {
    let _e49 = (*level);
    let _e57 = (*at)[1u];
    let _e58 = (*level);
    let _e65 = (*at)[0u];
    return (((((16384u - (16384u >> bitcast<u32>((4u * _e49)))) / 15u) * 16u) + (_e57 * (128u >> bitcast<u32>((2u * _e58))))) + _e65);
}

fn head_of_u0028_u1_u003b_vu2_u003b_u1_u003b(level_1: ptr<function, u32>, at_1: ptr<function, vec2<u32>>, block: ptr<function, u32>) -> u32 {
    var param_1: u32;
    var param_2: vec2<u32>;

    let _e52 = (*level_1);
    param_1 = _e52;
    let _e53 = (*at_1);
    param_2 = _e53;
    let _e54 = bins_tile_u0028_u1_u003b_vu2_u003b((&param_1), (&param_2));
    let _e57 = (*block);
    return ((17474u + (_e54 * 32u)) + _e57);
}

fn half_box_u0028_struct_u002d_Splat_u002d_vf2_u002d_vf2_u002d_f1_u002d_vf3_u002d_u11_u003b_f1_u003b(splat_1: ptr<function, Splat>, reach: ptr<function, f32>) -> vec2<f32> {
    var steep: f32;

    let _e51 = (*splat_1).shorter;
    let _e53 = (*splat_1).axis;
    let _e55 = (*splat_1).axis;
    steep = (_e51 * inverseSqrt(dot(_e53, _e55)));
    let _e59 = (*reach);
    let _e61 = (*splat_1).axis;
    let _e63 = (*splat_1).axis;
    let _e65 = steep;
    let _e66 = steep;
    let _e69 = (*splat_1).axis;
    let _e73 = (*splat_1).axis;
    return (sqrt(((_e61 * _e63) + ((_e69.yx * (_e65 * _e66)) * _e73.yx))) * _e59);
}

fn reach_of_u0028_u1_u003b(opacity: ptr<function, u32>) -> f32 {
    let _e48 = (*opacity);
    let _e51 = frame.hull_opacity;
    let _e54 = frame.cutoff;
    return sqrt((2f * log(max((max(f32(_e48), _e51) / _e54), 1f))));
}

fn steps_of_u0028_vu4_u003b(words: ptr<function, vec4<u32>>) -> vec2<f32> {
    let _e48 = (*words);
    return vec2<f32>((_e48.xy & vec2(1048575u)));
}

fn unpack_splat_u0028_vu4_u003b(words_1: ptr<function, vec4<u32>>) -> Splat {
    var splat_2: Splat;
    var param_3: vec4<u32>;
    var blue: u32;

    let _e51 = (*words_1);
    param_3 = _e51;
    let _e52 = steps_of_u0028_vu4_u003b((&param_3));
    let _e54 = frame.fixed_scale;
    let _e58 = frame.guard;
    splat_2.center = ((_e52 / vec2(_e54)) - vec2(_e58));
    let _e63 = (*words_1)[2u];
    splat_2.axis = unpack2x16float(_e63);
    let _e67 = (*words_1)[3u];
    splat_2.shorter = unpack2x16float(_e67).x;
    let _e72 = (*words_1)[3u];
    let _e78 = (*words_1)[0u];
    blue = (((_e72 >> bitcast<u32>(24u)) << bitcast<u32>(2u)) | (_e78 >> bitcast<u32>(30u)));
    let _e83 = (*words_1)[0u];
    let _e89 = (*words_1)[1u];
    let _e94 = blue;
    splat_2.color = (vec3<f32>(f32(((_e83 >> bitcast<u32>(20u)) & 1023u)), f32(((_e89 >> bitcast<u32>(20u)) & 1023u)), f32(_e94)) / vec3(1023f));
    let _e101 = (*words_1)[3u];
    splat_2.opacity = ((_e101 >> bitcast<u32>(16u)) & 255u);
    let _e106 = splat_2;
    return _e106;
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

    let _e92 = gl_GlobalInvocationID_1[0u];
    block_1 = _e92;
    let _e93 = block_1;
    if (_e93 == 0u) {
        unnamed_1.control.fragments = 0u;
    }
    let _e99 = unnamed_1.control.survivors;
    length_ = (((_e99 + 32u) - 1u) / 32u);
    let _e103 = block_1;
    let _e105 = length_;
    let _e109 = unnamed_1.control.survivors;
    end = min(((_e103 + 1u) * _e105), _e109);
    let _e112 = settings.nodes;
    let _e114 = block_1;
    let _e115 = length_;
    whole = ((_e112 + 1u) + (_e114 * (((_e115 + 7u) - 1u) / 7u)));
    let _e121 = block_1;
    let _e122 = length_;
    number = (_e121 * _e122);
    loop {
        let _e124 = number;
        let _e125 = end;
        if (_e124 < _e125) {
            let _e127 = number;
            let _e130 = unnamed_2.order[_e127];
            i = _e130;
            let _e131 = i;
            let _e134 = unnamed_3.splats[_e131];
            param_4 = _e134;
            let _e135 = unpack_splat_u0028_vu4_u003b((&param_4));
            splat_3 = _e135;
            let _e137 = splat_3.opacity;
            param_5 = _e137;
            let _e138 = reach_of_u0028_u1_u003b((&param_5));
            let _e139 = splat_3;
            param_6 = _e139;
            param_7 = _e138;
            let _e140 = half_box_u0028_struct_u002d_Splat_u002d_vf2_u002d_vf2_u002d_f1_u002d_vf3_u002d_u11_u003b_f1_u003b((&param_6), (&param_7));
            reach_1 = _e140;
            low = vec2<u32>(0u, 0u);
            high = vec2<u32>(0u, 0u);
            node_1 = 0u;
            level_2 = 0u;
            loop {
                let _e141 = level_2;
                if (_e141 < 3u) {
                    let _e144 = frame.tile;
                    let _e145 = level_2;
                    side = (_e144 * f32((1u << bitcast<u32>((2u * _e145)))));
                    let _e151 = level_2;
                    last = f32(((128u >> bitcast<u32>((2u * _e151))) - 1u));
                    let _e158 = splat_3.center;
                    let _e159 = reach_1;
                    let _e161 = side;
                    let _e164 = last;
                    low = vec2<u32>(clamp(((_e158 - _e159) / vec2(_e161)), vec2(0f), vec2(_e164)));
                    let _e170 = splat_3.center;
                    let _e171 = reach_1;
                    let _e173 = side;
                    let _e176 = last;
                    high = vec2<u32>(clamp(((_e170 + _e171) / vec2(_e173)), vec2(0f), vec2(_e176)));
                    let _e182 = high[0u];
                    let _e184 = low[0u];
                    let _e188 = high[1u];
                    let _e190 = low[1u];
                    if ((((_e182 - _e184) + 1u) * ((_e188 - _e190) + 1u)) > 16u) {
                        continue;
                    }
                    needed = 0u;
                    let _e196 = low[1u];
                    y = _e196;
                    loop {
                        let _e197 = y;
                        let _e199 = high[1u];
                        if (_e197 <= _e199) {
                            let _e202 = low[0u];
                            x = _e202;
                            loop {
                                let _e203 = x;
                                let _e205 = high[0u];
                                if (_e203 <= _e205) {
                                    let _e207 = x;
                                    let _e208 = y;
                                    let _e210 = level_2;
                                    param_8 = _e210;
                                    param_9 = vec2<u32>(_e207, _e208);
                                    let _e211 = block_1;
                                    param_10 = _e211;
                                    let _e212 = head_of_u0028_u1_u003b_vu2_u003b_u1_u003b((&param_8), (&param_9), (&param_10));
                                    let _e215 = atomicLoad((&unnamed.bins[_e212]));
                                    param_11 = _e215;
                                    let _e216 = full_u0028_u1_u003b((&param_11));
                                    let _e218 = needed;
                                    needed = (_e218 + select(0u, 1u, _e216));
                                    continue;
                                } else {
                                    break;
                                }
                                continuing {
                                    let _e220 = x;
                                    x = (_e220 + bitcast<u32>(1i));
                                }
                            }
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e223 = y;
                            y = (_e223 + bitcast<u32>(1i));
                        }
                    }
                    let _e226 = needed;
                    if (_e226 > 0u) {
                        let _e230 = needed;
                        let _e231 = atomicAdd((&unnamed.bins[0i]), _e230);
                        local = (_e231 + 1u);
                    } else {
                        local = 1u;
                    }
                    let _e233 = local;
                    node_1 = _e233;
                    let _e234 = node_1;
                    let _e235 = needed;
                    let _e238 = settings.nodes;
                    if ((_e234 + _e235) <= (_e238 + 1u)) {
                        break;
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e241 = level_2;
                    level_2 = (_e241 + bitcast<u32>(1i));
                }
            }
            let _e244 = level_2;
            if (_e244 == 3u) {
                low = vec2<u32>(0u, 0u);
                high = vec2<u32>(0u, 0u);
                let _e246 = whole;
                node_1 = _e246;
                param_12 = 3u;
                let _e247 = low;
                param_13 = _e247;
                let _e248 = block_1;
                param_14 = _e248;
                let _e249 = head_of_u0028_u1_u003b_vu2_u003b_u1_u003b((&param_12), (&param_13), (&param_14));
                let _e252 = atomicLoad((&unnamed.bins[_e249]));
                param_15 = _e252;
                let _e253 = full_u0028_u1_u003b((&param_15));
                let _e255 = whole;
                whole = (_e255 + select(0u, 1u, _e253));
            }
            let _e258 = low[1u];
            y_1 = _e258;
            loop {
                let _e259 = y_1;
                let _e261 = high[1u];
                if (_e259 <= _e261) {
                    let _e264 = low[0u];
                    x_1 = _e264;
                    loop {
                        let _e265 = x_1;
                        let _e267 = high[0u];
                        if (_e265 <= _e267) {
                            let _e269 = x_1;
                            let _e270 = y_1;
                            let _e272 = level_2;
                            param_16 = _e272;
                            param_17 = vec2<u32>(_e269, _e270);
                            let _e273 = block_1;
                            param_18 = _e273;
                            let _e274 = head_of_u0028_u1_u003b_vu2_u003b_u1_u003b((&param_16), (&param_17), (&param_18));
                            head_1 = _e274;
                            let _e275 = head_1;
                            let _e278 = atomicLoad((&unnamed.bins[_e275]));
                            chain_2 = _e278;
                            let _e279 = chain_2;
                            if (_e279 == 0u) {
                                let _e281 = x_1;
                                let _e282 = y_1;
                                let _e284 = level_2;
                                param_19 = _e284;
                                param_20 = vec2<u32>(_e281, _e282);
                                let _e285 = bins_tile_u0028_u1_u003b_vu2_u003b((&param_19), (&param_20));
                                let _e289 = block_1;
                                let _e292 = atomicOr((&unnamed.bins[(1u + _e285)]), (1u << bitcast<u32>(_e289)));
                            }
                            let _e293 = i;
                            param_21 = _e293;
                            let _e294 = head_1;
                            param_22 = _e294;
                            let _e295 = chain_2;
                            param_23 = _e295;
                            let _e296 = node_1;
                            param_24 = _e296;
                            put_u0028_u1_u003b_u1_u003b_u1_u003b_u1_u003b((&param_21), (&param_22), (&param_23), (&param_24));
                            let _e297 = chain_2;
                            param_25 = _e297;
                            let _e298 = full_u0028_u1_u003b((&param_25));
                            let _e300 = node_1;
                            node_1 = (_e300 + select(0u, 1u, _e298));
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e302 = x_1;
                            x_1 = (_e302 + bitcast<u32>(1i));
                        }
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e305 = y_1;
                    y_1 = (_e305 + bitcast<u32>(1i));
                }
            }
            continue;
        } else {
            break;
        }
        continuing {
            let _e308 = number;
            number = (_e308 + bitcast<u32>(1i));
        }
    }
    return;
}

@compute @workgroup_size(8, 1, 1) 
fn main(@builtin(global_invocation_id) gl_GlobalInvocationID: vec3<u32>) {
    gl_GlobalInvocationID_1 = gl_GlobalInvocationID;
    main_1();
}
