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

    let _e47 = (*chain);
    let _e48 = (_e47 == 0u);
    phi_204_ = _e48;
    if !(_e48) {
        let _e50 = (*chain);
        phi_204_ = ((_e50 & 7u) == 7u);
    }
    let _e54 = phi_204_;
    return _e54;
}

fn put_u0028_u1_u003b_u1_u003b_u1_u003b_u1_u003b(splat: ptr<function, u32>, head: ptr<function, u32>, chain_1: ptr<function, u32>, node: ptr<function, u32>) {
    var param: u32;

    let _e51 = (*chain_1);
    param = _e51;
    let _e52 = full_u0028_u1_u003b((&param));
    if _e52 {
        let _e53 = (*node);
        let _e56 = (*chain_1);
        atomicStore((&unnamed.bins[(540698u + (8u * _e53))]), _e56);
        let _e59 = (*node);
        (*chain_1) = (8u * _e59);
    }
    let _e61 = (*chain_1);
    (*chain_1) = (_e61 + bitcast<u32>(1i));
    let _e64 = (*chain_1);
    let _e66 = (*splat);
    atomicStore((&unnamed.bins[(540698u + _e64)]), _e66);
    let _e69 = (*head);
    let _e70 = (*chain_1);
    atomicStore((&unnamed.bins[_e69]), _e70);
    return;
}

fn half_box_u0028_struct_u002d_Splat_u002d_vf2_u002d_vf2_u002d_f1_u002d_vf3_u002d_u11_u003b_f1_u003b(splat_1: ptr<function, Splat>, reach: ptr<function, f32>) -> vec2<f32> {
    var steep: f32;

    let _e50 = (*splat_1).shorter;
    let _e52 = (*splat_1).axis;
    let _e54 = (*splat_1).axis;
    steep = (_e50 * inverseSqrt(dot(_e52, _e54)));
    let _e58 = (*reach);
    let _e60 = (*splat_1).axis;
    let _e62 = (*splat_1).axis;
    let _e64 = steep;
    let _e65 = steep;
    let _e68 = (*splat_1).axis;
    let _e72 = (*splat_1).axis;
    return (sqrt(((_e60 * _e62) + ((_e68.yx * (_e64 * _e65)) * _e72.yx))) * _e58);
}

fn reach_of_u0028_u1_u003b(opacity: ptr<function, u32>) -> f32 {
    let _e47 = (*opacity);
    let _e50 = frame.hull_opacity;
    let _e53 = frame.cutoff;
    return sqrt((2f * log(max((max(f32(_e47), _e50) / _e53), 1f))));
}

fn steps_of_u0028_vu4_u003b(words: ptr<function, vec4<u32>>) -> vec2<f32> {
    let _e47 = (*words);
    return vec2<f32>((_e47.xy & vec2(1048575u)));
}

fn unpack_splat_u0028_vu4_u003b(words_1: ptr<function, vec4<u32>>) -> Splat {
    var splat_2: Splat;
    var param_1: vec4<u32>;
    var blue: u32;

    let _e50 = (*words_1);
    param_1 = _e50;
    let _e51 = steps_of_u0028_vu4_u003b((&param_1));
    let _e53 = frame.fixed_scale;
    let _e57 = frame.guard;
    splat_2.center = ((_e51 / vec2(_e53)) - vec2(_e57));
    let _e62 = (*words_1)[2u];
    splat_2.axis = unpack2x16float(_e62);
    let _e66 = (*words_1)[3u];
    splat_2.shorter = unpack2x16float(_e66).x;
    let _e71 = (*words_1)[3u];
    let _e77 = (*words_1)[0u];
    blue = (((_e71 >> bitcast<u32>(24u)) << bitcast<u32>(2u)) | (_e77 >> bitcast<u32>(30u)));
    let _e82 = (*words_1)[0u];
    let _e88 = (*words_1)[1u];
    let _e93 = blue;
    splat_2.color = (vec3<f32>(f32(((_e82 >> bitcast<u32>(20u)) & 1023u)), f32(((_e88 >> bitcast<u32>(20u)) & 1023u)), f32(_e93)) / vec3(1023f));
    let _e100 = (*words_1)[3u];
    splat_2.opacity = ((_e100 >> bitcast<u32>(16u)) & 255u);
    let _e105 = splat_2;
    return _e105;
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
    var phi_386_: bool;
    var phi_443_: bool;

    let _e85 = gl_GlobalInvocationID_1[0u];
    block = _e85;
    let _e86 = block;
    if (_e86 == 0u) {
        unnamed_1.control.fragments = 0u;
    }
    let _e92 = unnamed_1.control.survivors;
    length_ = (((_e92 + 32u) - 1u) / 32u);
    let _e96 = block;
    let _e98 = length_;
    let _e102 = unnamed_1.control.survivors;
    end = min(((_e96 + 1u) * _e98), _e102);
    let _e105 = settings.nodes;
    let _e107 = block;
    let _e108 = length_;
    wide = ((_e105 + 1u) + (_e107 * (((_e108 + 7u) - 1u) / 7u)));
    wide_chain = 0u;
    let _e114 = block;
    let _e115 = length_;
    number = (_e114 * _e115);
    loop {
        let _e117 = number;
        let _e118 = end;
        if (_e117 < _e118) {
            let _e120 = number;
            let _e123 = unnamed_2.order[_e120];
            i = _e123;
            let _e124 = i;
            let _e127 = unnamed_3.splats[_e124];
            param_2 = _e127;
            let _e128 = unpack_splat_u0028_vu4_u003b((&param_2));
            splat_3 = _e128;
            let _e130 = splat_3.opacity;
            param_3 = _e130;
            let _e131 = reach_of_u0028_u1_u003b((&param_3));
            let _e132 = splat_3;
            param_4 = _e132;
            param_5 = _e131;
            let _e133 = half_box_u0028_struct_u002d_Splat_u002d_vf2_u002d_vf2_u002d_f1_u002d_vf3_u002d_u11_u003b_f1_u003b((&param_4), (&param_5));
            reach_1 = _e133;
            let _e135 = splat_3.center;
            let _e136 = reach_1;
            let _e139 = frame.tile;
            low = vec2<u32>(clamp(((_e135 - _e136) / vec2(_e139)), vec2(0f), vec2(127f)));
            let _e147 = splat_3.center;
            let _e148 = reach_1;
            let _e151 = frame.tile;
            high = vec2<u32>(clamp(((_e147 + _e148) / vec2(_e151)), vec2(0f), vec2(127f)));
            needed = 0u;
            let _e159 = high[0u];
            let _e161 = low[0u];
            let _e165 = high[1u];
            let _e167 = low[1u];
            narrow = ((((_e159 - _e161) + 1u) * ((_e165 - _e167) + 1u)) <= 16u);
            let _e173 = low[1u];
            y = _e173;
            loop {
                let _e174 = narrow;
                phi_386_ = _e174;
                if _e174 {
                    let _e175 = y;
                    let _e177 = high[1u];
                    phi_386_ = (_e175 <= _e177);
                }
                let _e180 = phi_386_;
                if _e180 {
                    let _e182 = low[0u];
                    x = _e182;
                    loop {
                        let _e183 = x;
                        let _e185 = high[0u];
                        if (_e183 <= _e185) {
                            let _e187 = y;
                            let _e189 = x;
                            let _e193 = block;
                            let _e197 = atomicLoad((&unnamed.bins[((16418u + (((_e187 * 128u) + _e189) * 32u)) + _e193)]));
                            param_6 = _e197;
                            let _e198 = full_u0028_u1_u003b((&param_6));
                            let _e200 = needed;
                            needed = (_e200 + select(0u, 1u, _e198));
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e202 = x;
                            x = (_e202 + bitcast<u32>(1i));
                        }
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e205 = y;
                    y = (_e205 + bitcast<u32>(1i));
                }
            }
            let _e208 = needed;
            if (_e208 > 0u) {
                let _e212 = needed;
                let _e213 = atomicAdd((&unnamed.bins[0i]), _e212);
                local = (_e213 + 1u);
            } else {
                local = 1u;
            }
            let _e215 = local;
            node_1 = _e215;
            let _e216 = narrow;
            let _e217 = !(_e216);
            phi_443_ = _e217;
            if !(_e217) {
                let _e219 = node_1;
                let _e220 = needed;
                let _e223 = settings.nodes;
                phi_443_ = ((_e219 + _e220) > (_e223 + 1u));
            }
            let _e227 = phi_443_;
            if _e227 {
                let _e228 = wide_chain;
                param_7 = _e228;
                let _e229 = full_u0028_u1_u003b((&param_7));
                next = _e229;
                let _e230 = block;
                let _e232 = i;
                param_8 = _e232;
                param_9 = (2u + _e230);
                let _e233 = wide_chain;
                param_10 = _e233;
                let _e234 = wide;
                param_11 = _e234;
                put_u0028_u1_u003b_u1_u003b_u1_u003b_u1_u003b((&param_8), (&param_9), (&param_10), (&param_11));
                let _e235 = block;
                let _e239 = atomicLoad((&unnamed.bins[(2u + _e235)]));
                wide_chain = _e239;
                let _e240 = next;
                let _e242 = wide;
                wide = (_e242 + select(0u, 1u, _e240));
                continue;
            }
            let _e245 = low[1u];
            y_1 = _e245;
            loop {
                let _e246 = y_1;
                let _e248 = high[1u];
                if (_e246 <= _e248) {
                    let _e251 = low[0u];
                    x_1 = _e251;
                    loop {
                        let _e252 = x_1;
                        let _e254 = high[0u];
                        if (_e252 <= _e254) {
                            let _e256 = y_1;
                            let _e258 = x_1;
                            tile = ((_e256 * 128u) + _e258);
                            let _e260 = tile;
                            let _e263 = block;
                            head_1 = ((16418u + (_e260 * 32u)) + _e263);
                            let _e265 = head_1;
                            let _e268 = atomicLoad((&unnamed.bins[_e265]));
                            chain_2 = _e268;
                            let _e269 = chain_2;
                            if (_e269 == 0u) {
                                let _e271 = tile;
                                let _e275 = block;
                                let _e278 = atomicOr((&unnamed.bins[(34u + _e271)]), (1u << bitcast<u32>(_e275)));
                            }
                            let _e279 = i;
                            param_12 = _e279;
                            let _e280 = head_1;
                            param_13 = _e280;
                            let _e281 = chain_2;
                            param_14 = _e281;
                            let _e282 = node_1;
                            param_15 = _e282;
                            put_u0028_u1_u003b_u1_u003b_u1_u003b_u1_u003b((&param_12), (&param_13), (&param_14), (&param_15));
                            let _e283 = chain_2;
                            param_16 = _e283;
                            let _e284 = full_u0028_u1_u003b((&param_16));
                            let _e286 = node_1;
                            node_1 = (_e286 + select(0u, 1u, _e284));
                            continue;
                        } else {
                            break;
                        }
                        continuing {
                            let _e288 = x_1;
                            x_1 = (_e288 + bitcast<u32>(1i));
                        }
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e291 = y_1;
                    y_1 = (_e291 + bitcast<u32>(1i));
                }
            }
            continue;
        } else {
            break;
        }
        continuing {
            let _e294 = number;
            number = (_e294 + bitcast<u32>(1i));
        }
    }
    let _e297 = wide_chain;
    if (_e297 != 0u) {
        let _e301 = block;
        let _e304 = atomicOr((&unnamed.bins[1i]), (1u << bitcast<u32>(_e301)));
    }
    return;
}

@compute @workgroup_size(8, 1, 1) 
fn main(@builtin(global_invocation_id) gl_GlobalInvocationID: vec3<u32>) {
    gl_GlobalInvocationID_1 = gl_GlobalInvocationID;
    main_1();
}
