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
    var phi_204_: bool;

    let _e48 = (*chain);
    let _e49 = (_e48 == 0u);
    phi_204_ = _e49;
    if !(_e49) {
        let _e51 = (*chain);
        phi_204_ = ((_e51 & 7u) == 7u);
    }
    let _e55 = phi_204_;
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
        atomicStore((&unnamed.bins[(540698u + (8u * _e54))]), _e57);
        let _e60 = (*node);
        (*chain_1) = (8u * _e60);
    }
    let _e62 = (*chain_1);
    (*chain_1) = (_e62 + bitcast<u32>(1i));
    let _e65 = (*chain_1);
    let _e67 = (*splat);
    atomicStore((&unnamed.bins[(540698u + _e65)]), _e67);
    let _e70 = (*head);
    let _e71 = (*chain_1);
    atomicStore((&unnamed.bins[_e70]), _e71);
    return;
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
    var param_1: vec4<u32>;
    var blue: u32;

    let _e51 = (*words_1);
    param_1 = _e51;
    let _e52 = steps_of_u0028_vu4_u003b((&param_1));
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
    var block: u32;
    var length_: u32;
    var end: u32;
    var wide: u32;
    var wide_chain: u32;
    var number: u32;
    var i: u32;
    var splat_3: Splat;
    var param_2: vec4<u32>;
    var reach_1: vec2<f32>;
    var param_3: u32;
    var param_4: Splat;
    var param_5: f32;
    var low: vec2<u32>;
    var high: vec2<u32>;
    var needed: u32;
    var narrow: bool;
    var y: u32;
    var x: u32;
    var param_6: u32;
    var node_1: u32;
    var local: u32;
    var next: bool;
    var param_7: u32;
    var param_8: u32;
    var param_9: u32;
    var param_10: u32;
    var param_11: u32;
    var y_1: u32;
    var x_1: u32;
    var tile: u32;
    var head_1: u32;
    var chain_2: u32;
    var param_12: u32;
    var param_13: u32;
    var param_14: u32;
    var param_15: u32;
    var param_16: u32;
    var phi_387_: bool;
    var phi_444_: bool;

    let _e86 = gl_GlobalInvocationID_1[0u];
    block = _e86;
    let _e87 = block;
    if (_e87 == 0u) {
        unnamed_1.control.fragments = 0u;
    }
    let _e93 = unnamed_1.control.survivors;
    length_ = (((_e93 + 32u) - 1u) / 32u);
    let _e97 = block;
    let _e99 = length_;
    let _e103 = unnamed_1.control.survivors;
    end = min(((_e97 + 1u) * _e99), _e103);
    let _e106 = settings.nodes;
    let _e108 = block;
    let _e109 = length_;
    wide = ((_e106 + 1u) + (_e108 * (((_e109 + 7u) - 1u) / 7u)));
    wide_chain = 0u;
    let _e115 = block;
    let _e116 = length_;
    number = (_e115 * _e116);
    loop {
        let _e118 = number;
        let _e119 = end;
        if (_e118 < _e119) {
            let _e121 = number;
            let _e124 = unnamed_2.order[_e121];
            i = _e124;
            let _e125 = i;
            let _e128 = unnamed_3.splats[_e125];
            param_2 = _e128;
            let _e129 = unpack_splat_u0028_vu4_u003b((&param_2));
            splat_3 = _e129;
            let _e131 = splat_3.opacity;
            param_3 = _e131;
            let _e132 = reach_of_u0028_u1_u003b((&param_3));
            let _e133 = splat_3;
            param_4 = _e133;
            param_5 = _e132;
            let _e134 = half_box_u0028_struct_u002d_Splat_u002d_vf2_u002d_vf2_u002d_f1_u002d_vf3_u002d_u11_u003b_f1_u003b((&param_4), (&param_5));
            reach_1 = _e134;
            let _e136 = splat_3.center;
            let _e137 = reach_1;
            let _e140 = frame.tile;
            low = vec2<u32>(clamp(((_e136 - _e137) / vec2(_e140)), vec2(0f), vec2(127f)));
            let _e148 = splat_3.center;
            let _e149 = reach_1;
            let _e152 = frame.tile;
            high = vec2<u32>(clamp(((_e148 + _e149) / vec2(_e152)), vec2(0f), vec2(127f)));
            needed = 0u;
            let _e160 = high[0u];
            let _e162 = low[0u];
            let _e166 = high[1u];
            let _e168 = low[1u];
            narrow = ((((_e160 - _e162) + 1u) * ((_e166 - _e168) + 1u)) <= 1024u);
            let _e174 = low[1u];
            y = _e174;
            loop {
                let _e175 = narrow;
                phi_387_ = _e175;
                if _e175 {
                    let _e176 = y;
                    let _e178 = high[1u];
                    phi_387_ = (_e176 <= _e178);
                }
                let _e181 = phi_387_;
                if _e181 {
                    let _e183 = low[0u];
                    x = _e183;
                    loop {
                        let _e184 = x;
                        let _e186 = high[0u];
                        if (_e184 <= _e186) {
                            let _e188 = y;
                            let _e190 = x;
                            let _e194 = block;
                            let _e198 = atomicLoad((&unnamed.bins[((16418u + (((_e188 * 128u) + _e190) * 32u)) + _e194)]));
                            param_6 = _e198;
                            let _e199 = full_u0028_u1_u003b((&param_6));
                            let _e201 = needed;
                            needed = (_e201 + select(0u, 1u, _e199));
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e203 = x;
                            x = (_e203 + bitcast<u32>(1i));
                        }
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e206 = y;
                    y = (_e206 + bitcast<u32>(1i));
                }
            }
            let _e209 = needed;
            if (_e209 > 0u) {
                let _e213 = needed;
                let _e214 = atomicAdd((&unnamed.bins[0i]), _e213);
                local = (_e214 + 1u);
            } else {
                local = 1u;
            }
            let _e216 = local;
            node_1 = _e216;
            let _e217 = narrow;
            let _e218 = !(_e217);
            phi_444_ = _e218;
            if !(_e218) {
                let _e220 = node_1;
                let _e221 = needed;
                let _e224 = settings.nodes;
                phi_444_ = ((_e220 + _e221) > (_e224 + 1u));
            }
            let _e228 = phi_444_;
            if _e228 {
                let _e229 = wide_chain;
                param_7 = _e229;
                let _e230 = full_u0028_u1_u003b((&param_7));
                next = _e230;
                let _e231 = block;
                let _e233 = i;
                param_8 = _e233;
                param_9 = (2u + _e231);
                let _e234 = wide_chain;
                param_10 = _e234;
                let _e235 = wide;
                param_11 = _e235;
                put_u0028_u1_u003b_u1_u003b_u1_u003b_u1_u003b((&param_8), (&param_9), (&param_10), (&param_11));
                let _e236 = block;
                let _e240 = atomicLoad((&unnamed.bins[(2u + _e236)]));
                wide_chain = _e240;
                let _e241 = next;
                let _e243 = wide;
                wide = (_e243 + select(0u, 1u, _e241));
                continue;
            }
            let _e246 = low[1u];
            y_1 = _e246;
            loop {
                let _e247 = y_1;
                let _e249 = high[1u];
                if (_e247 <= _e249) {
                    let _e252 = low[0u];
                    x_1 = _e252;
                    loop {
                        let _e253 = x_1;
                        let _e255 = high[0u];
                        if (_e253 <= _e255) {
                            let _e257 = y_1;
                            let _e259 = x_1;
                            tile = ((_e257 * 128u) + _e259);
                            let _e261 = tile;
                            let _e264 = block;
                            head_1 = ((16418u + (_e261 * 32u)) + _e264);
                            let _e266 = head_1;
                            let _e269 = atomicLoad((&unnamed.bins[_e266]));
                            chain_2 = _e269;
                            let _e270 = chain_2;
                            if (_e270 == 0u) {
                                let _e272 = tile;
                                let _e276 = block;
                                let _e279 = atomicOr((&unnamed.bins[(34u + _e272)]), (1u << bitcast<u32>(_e276)));
                            }
                            let _e280 = i;
                            param_12 = _e280;
                            let _e281 = head_1;
                            param_13 = _e281;
                            let _e282 = chain_2;
                            param_14 = _e282;
                            let _e283 = node_1;
                            param_15 = _e283;
                            put_u0028_u1_u003b_u1_u003b_u1_u003b_u1_u003b((&param_12), (&param_13), (&param_14), (&param_15));
                            let _e284 = chain_2;
                            param_16 = _e284;
                            let _e285 = full_u0028_u1_u003b((&param_16));
                            let _e287 = node_1;
                            node_1 = (_e287 + select(0u, 1u, _e285));
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e289 = x_1;
                            x_1 = (_e289 + bitcast<u32>(1i));
                        }
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e292 = y_1;
                    y_1 = (_e292 + bitcast<u32>(1i));
                }
            }
            continue;
        } else {
            break;
        }
        continuing {
            let _e295 = number;
            number = (_e295 + bitcast<u32>(1i));
        }
    }
    let _e298 = wide_chain;
    if (_e298 != 0u) {
        let _e302 = block;
        let _e305 = atomicOr((&unnamed.bins[1i]), (1u << bitcast<u32>(_e302)));
    }
    return;
}

@compute @workgroup_size(8, 1, 1) 
fn main(@builtin(global_invocation_id) gl_GlobalInvocationID: vec3<u32>) {
    gl_GlobalInvocationID_1 = gl_GlobalInvocationID;
    main_1();
}
