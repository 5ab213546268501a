struct Splat {
    center: vec2<f32>,
    axis: vec2<f32>,
    shorter: f32,
    color: vec3<f32>,
    opacity: u32,
}

struct Seen {
    deviation: vec2<f32>,
    right: vec2<f32>,
    down: vec2<f32>,
    exponent: f32,
    word: u32,
}

struct Samples {
    light: array<f32, 4>,
    word: array<u32, 4>,
    open: bool,
    evaluated: u32,
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

struct Splats {
    splats: array<vec4<u32>>,
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
    bin_margin: f32,
}

struct Bins {
    bins: array<u32>,
}

struct Sorted {
    sorted: array<u32>,
}

struct Marks {
    marks: array<atomic<u32>>,
}

struct Control {
    index_count: u32,
    instance_count: u32,
    first_index: u32,
    vertex_offset: i32,
    first_instance: u32,
    key_count: u32,
    visible_count: u32,
    fragments: atomic<u32>,
}

struct ControlBuffer {
    control: Control,
}

struct Splats_1 {
    splats: array<vec4<u32>, LENGTH_1_16>,
}

struct Bins_1 {
    bins: array<u32, LENGTH_4_4>,
}

struct Sorted_1 {
    sorted: array<u32, LENGTH_3_4>,
}

struct Marks_1 {
    marks: array<atomic<u32>, LENGTH_6_4>,
}

@group(0) @binding(0) 
var<uniform> frame: FrameBlock;
@group(0) @binding(1) 
var<storage> unnamed: Splats_1;
@group(0) @binding(7) 
var<uniform> settings: SettingsBlock;
var<workgroup> batch_hits: array<atomic<u32>, 128>;
var<workgroup> batch_place: array<vec4<f32>, 64>;
var<workgroup> batch_shape: array<vec4<f32>, 64>;
var<private> gl_LocalInvocationIndex_1: u32;
@group(0) @binding(4) 
var<storage> unnamed_1: Bins_1;
var<workgroup> batch_seen: array<u32, 64>;
var<workgroup> batch_open: u32;
@group(0) @binding(3) 
var<storage> unnamed_2: Sorted_1;
@group(0) @binding(6) 
var<storage, read_write> unnamed_3: Marks_1;
@group(0) @binding(5) 
var saturated: texture_storage_2d<r32uint,write>;
var<private> gl_WorkGroupID_1: vec3<u32>;
@group(0) @binding(2) 
var<storage, read_write> unnamed_4: ControlBuffer;

fn store_u0028_vu2_u003b_u1_u003b(at: ptr<function, vec2<u32>>, word: ptr<function, u32>) {
    let _e3 = (*at);
    let _e4 = textureDimensions(saturated);
    if all((_e3 < bitcast<vec2<u32>>(vec2<i32>(_e4)))) {
        let _e9 = (*at);
        let _e11 = (*word);
        textureStore(saturated, bitcast<vec2<i32>>(_e9), vec4(_e11));
    }
    return;
}

fn opacity_at_u0028_vf2_u003b_f1_u003b(deviation: ptr<function, vec2<f32>>, exponent: ptr<function, f32>) -> f32 {
    var power: f32;
    var local: f32;

    let _e7 = (*exponent);
    let _e8 = (*deviation);
    let _e9 = (*deviation);
    power = (_e7 - dot(_e8, _e9));
    let _e12 = power;
    let _e14 = settings.cutoff_exponent;
    if (_e12 >= _e14) {
        let _e16 = power;
        local = min(0.99f, exp2(_e16));
    } else {
        local = 0f;
    }
    let _e19 = local;
    return _e19;
}

fn blend_sample_u0028_f1_u003b_u1_u003b_vf2_u003b_f1_u003b_u1_u003b(light: ptr<function, f32>, word_1: ptr<function, u32>, deviation_1: ptr<function, vec2<f32>>, exponent_1: ptr<function, f32>, own: ptr<function, u32>) {
    var behind: f32;
    var param_12: vec2<f32>;
    var param_13: f32;
    var phi_758_: bool;

    let _e9 = (*light);
    let _e10 = (*light);
    let _e11 = (*deviation_1);
    param_12 = _e11;
    let _e12 = (*exponent_1);
    param_13 = _e12;
    let _e13 = opacity_at_u0028_vf2_u003b_f1_u003b((&param_12), (&param_13));
    behind = (_e9 - (_e10 * _e13));
    let _e16 = (*light);
    let _e18 = settings.saturation;
    let _e19 = (_e16 >= _e18);
    phi_758_ = _e19;
    if _e19 {
        let _e20 = behind;
        let _e22 = settings.saturation;
        phi_758_ = (_e20 < _e22);
    }
    let _e25 = phi_758_;
    let _e26 = (*own);
    let _e27 = (*word_1);
    (*word_1) = select(_e27, _e26, _e25);
    let _e29 = behind;
    (*light) = _e29;
    return;
}

fn see_u0028_u1_u003b_vf2_u003b(k: ptr<function, u32>, first_1: ptr<function, vec2<f32>>) -> Seen {
    var place: vec4<f32>;
    var shape: vec4<f32>;
    var from_: vec2<f32>;
    var seen: Seen;

    let _e13 = (*k);
    let _e15 = batch_place[_e13];
    place = _e15;
    let _e16 = (*k);
    let _e18 = batch_shape[_e16];
    shape = _e18;
    let _e19 = (*first_1);
    let _e20 = place;
    from_ = (_e19 - _e20.xy);
    let _e23 = from_;
    let _e24 = place;
    let _e27 = from_;
    let _e28 = shape;
    seen.deviation = vec2<f32>(dot(_e23, _e24.zw), dot(_e27, _e28.xy));
    let _e34 = place[2u];
    let _e36 = shape[0u];
    seen.right = (vec2<f32>(_e34, _e36) * 2f);
    let _e41 = place[3u];
    let _e43 = shape[1u];
    seen.down = (vec2<f32>(_e41, _e43) * 2f);
    let _e48 = shape[2u];
    seen.exponent = _e48;
    let _e51 = shape[3u];
    seen.word = bitcast<u32>(_e51);
    let _e54 = seen;
    return _e54;
}

fn blend_u0028_struct_u002d_Samples_u002d_f1_u005b_4_u005d_u002d_u1_u005b_4_u005d_u002d_b1_u002d_u11_u003b_u1_u003b_vf2_u003b(samples_1: ptr<function, Samples>, k_1: ptr<function, u32>, first_2: ptr<function, vec2<f32>>) {
    var seen_1: Seen;
    var param_14: u32;
    var param_15: vec2<f32>;
    var right: vec2<f32>;
    var param_16: f32;
    var param_17: u32;
    var param_18: vec2<f32>;
    var param_19: f32;
    var param_20: u32;
    var param_21: f32;
    var param_22: u32;
    var param_23: vec2<f32>;
    var param_24: f32;
    var param_25: u32;
    var param_26: f32;
    var param_27: u32;
    var param_28: vec2<f32>;
    var param_29: f32;
    var param_30: u32;
    var param_31: f32;
    var param_32: u32;
    var param_33: vec2<f32>;
    var param_34: f32;
    var param_35: u32;

    let _e33 = (*k_1);
    param_14 = _e33;
    let _e34 = (*first_2);
    param_15 = _e34;
    let _e35 = see_u0028_u1_u003b_vf2_u003b((&param_14), (&param_15));
    seen_1 = _e35;
    let _e37 = seen_1.deviation;
    let _e39 = seen_1.right;
    right = (_e37 + _e39);
    let _e43 = (*samples_1).light[0i];
    param_16 = _e43;
    let _e46 = (*samples_1).word[0i];
    param_17 = _e46;
    let _e48 = seen_1.deviation;
    param_18 = _e48;
    let _e50 = seen_1.exponent;
    param_19 = _e50;
    let _e52 = seen_1.word;
    param_20 = _e52;
    blend_sample_u0028_f1_u003b_u1_u003b_vf2_u003b_f1_u003b_u1_u003b((&param_16), (&param_17), (&param_18), (&param_19), (&param_20));
    let _e53 = param_16;
    (*samples_1).light[0i] = _e53;
    let _e56 = param_17;
    (*samples_1).word[0i] = _e56;
    let _e61 = (*samples_1).light[1i];
    param_21 = _e61;
    let _e64 = (*samples_1).word[1i];
    param_22 = _e64;
    let _e65 = right;
    param_23 = _e65;
    let _e67 = seen_1.exponent;
    param_24 = _e67;
    let _e69 = seen_1.word;
    param_25 = _e69;
    blend_sample_u0028_f1_u003b_u1_u003b_vf2_u003b_f1_u003b_u1_u003b((&param_21), (&param_22), (&param_23), (&param_24), (&param_25));
    let _e70 = param_21;
    (*samples_1).light[1i] = _e70;
    let _e73 = param_22;
    (*samples_1).word[1i] = _e73;
    let _e77 = seen_1.deviation;
    let _e79 = seen_1.down;
    let _e83 = (*samples_1).light[2i];
    param_26 = _e83;
    let _e86 = (*samples_1).word[2i];
    param_27 = _e86;
    param_28 = (_e77 + _e79);
    let _e88 = seen_1.exponent;
    param_29 = _e88;
    let _e90 = seen_1.word;
    param_30 = _e90;
    blend_sample_u0028_f1_u003b_u1_u003b_vf2_u003b_f1_u003b_u1_u003b((&param_26), (&param_27), (&param_28), (&param_29), (&param_30));
    let _e91 = param_26;
    (*samples_1).light[2i] = _e91;
    let _e94 = param_27;
    (*samples_1).word[2i] = _e94;
    let _e97 = right;
    let _e99 = seen_1.down;
    let _e103 = (*samples_1).light[3i];
    param_31 = _e103;
    let _e106 = (*samples_1).word[3i];
    param_32 = _e106;
    param_33 = (_e97 + _e99);
    let _e108 = seen_1.exponent;
    param_34 = _e108;
    let _e110 = seen_1.word;
    param_35 = _e110;
    blend_sample_u0028_f1_u003b_u1_u003b_vf2_u003b_f1_u003b_u1_u003b((&param_31), (&param_32), (&param_33), (&param_34), (&param_35));
    let _e111 = param_31;
    (*samples_1).light[3i] = _e111;
    let _e114 = param_32;
    (*samples_1).word[3i] = _e114;
    let _e119 = (*samples_1).light[0i];
    let _e122 = (*samples_1).light[1i];
    let _e126 = (*samples_1).light[2i];
    let _e129 = (*samples_1).light[3i];
    let _e133 = settings.saturation;
    (*samples_1).open = (max(max(_e119, _e122), max(_e126, _e129)) >= _e133);
    let _e137 = (*samples_1).evaluated;
    (*samples_1).evaluated = (_e137 + 4u);
    return;
}

fn hits_of_u0028_vu2_u003b_u1_u003b(invocation: ptr<function, vec2<u32>>, word_2: ptr<function, u32>) -> u32 {
    var hits: u32;
    var k_2: u32;
    var bits: u32;

    hits = 0u;
    k_2 = 0u;
    loop {
        let _e12 = k_2;
        if (_e12 < 8u) {
            let _e15 = (*invocation)[1u];
            let _e17 = (*word_2);
            let _e20 = k_2;
            let _e23 = atomicLoad((&batch_hits[(((_e15 * 16u) + (8u * _e17)) + _e20)]));
            bits = _e23;
            let _e24 = bits;
            let _e26 = (*invocation)[0u];
            let _e30 = k_2;
            let _e33 = hits;
            hits = (_e33 | (((_e24 >> bitcast<u32>(_e26)) & 16843009u) << bitcast<u32>(_e30)));
            continue;
        } else {
            break;
        }
        continuing {
            let _e35 = k_2;
            k_2 = (_e35 + bitcast<u32>(1i));
        }
    }
    let _e38 = hits;
    return _e38;
}

fn saturated_word_u0028_f1_u003b_vf3_u003b(depth: ptr<function, f32>, color: ptr<function, vec3<f32>>) -> u32 {
    var rgb: vec3<u32>;

    let _e13 = (*color);
    rgb = vec3<u32>(round((_e13 * vec3<f32>(31f, 63f, 31f))));
    let _e17 = (*depth);
    let _e25 = rgb[0u];
    let _e30 = rgb[1u];
    let _e35 = rgb[2u];
    return ((((min(u32(((_e17 * 65535f) + 1.5f)), 65535u) << bitcast<u32>(16u)) | (_e25 << bitcast<u32>(11u))) | (_e30 << bitcast<u32>(5u))) | _e35);
}

fn key_at_u0028_u1_u003b(i: ptr<function, u32>) -> u32 {
    var word_3: u32;
    var local_1: u32;
    var keys: u32;
    var local_2: u32;

    let _e14 = frame.key_start;
    let _e16 = frame.half_keys;
    if (_e16 != 0u) {
        let _e18 = (*i);
        local_1 = (_e18 >> bitcast<u32>(1u));
    } else {
        let _e21 = (*i);
        local_1 = _e21;
    }
    let _e22 = local_1;
    word_3 = (_e14 + _e22);
    let _e24 = word_3;
    let _e27 = word_3;
    let _e32 = unnamed.splats[(_e24 >> bitcast<u32>(2u))][(_e27 & 3u)];
    keys = _e32;
    let _e34 = frame.half_keys;
    if (_e34 != 0u) {
        let _e36 = keys;
        let _e37 = (*i);
        local_2 = ((_e36 >> bitcast<u32>((16u * (_e37 & 1u)))) & 65535u);
    } else {
        let _e43 = keys;
        local_2 = _e43;
    }
    let _e44 = local_2;
    return _e44;
}

fn fixed_center_u0028_vu4_u003b(words: ptr<function, vec4<u32>>) -> vec2<f32> {
    let _e2 = (*words);
    return vec2<f32>((_e2.xy & vec2(1048575u)));
}

fn unpack_splat_u0028_vu4_u003b(words_1: ptr<function, vec4<u32>>) -> Splat {
    var splat: Splat;
    var param_36: vec4<u32>;
    var blue: u32;
    var red: u32;
    var green: u32;

    let _e18 = (*words_1);
    param_36 = _e18;
    let _e19 = fixed_center_u0028_vu4_u003b((&param_36));
    let _e21 = frame.fixed_scale;
    let _e25 = frame.guard;
    splat.center = ((_e19 / vec2(_e21)) - vec2(_e25));
    let _e30 = (*words_1)[2u];
    splat.axis = unpack2x16float(_e30);
    let _e34 = (*words_1)[3u];
    splat.shorter = unpack2x16float(_e34).x;
    let _e39 = (*words_1)[3u];
    let _e45 = (*words_1)[0u];
    blue = (((_e39 >> bitcast<u32>(24u)) << bitcast<u32>(2u)) | (_e45 >> bitcast<u32>(30u)));
    let _e50 = (*words_1)[0u];
    red = ((_e50 >> bitcast<u32>(20u)) & 1023u);
    let _e55 = (*words_1)[1u];
    green = ((_e55 >> bitcast<u32>(20u)) & 1023u);
    let _e59 = red;
    let _e61 = green;
    let _e63 = blue;
    splat.color = (vec3<f32>(f32(_e59), f32(_e61), f32(_e63)) / vec3(1023f));
    let _e70 = (*words_1)[3u];
    splat.opacity = ((_e70 >> bitcast<u32>(16u)) & 255u);
    let _e75 = splat;
    return _e75;
}

fn load_u0028_u1_u003b_u1_u003b_vf2_u003b(thread: ptr<function, u32>, i_1: ptr<function, u32>, corner: ptr<function, vec2<f32>>) {
    var splat_1: Splat;
    var param_37: vec4<u32>;
    var inverse: f32;
    var along: vec2<f32>;
    var across: vec2<f32>;
    var exponent_2: f32;
    var center: vec2<f32>;
    var a: f32;
    var b: f32;
    var c: f32;
    var determinant_: f32;
    var most: f32;
    var turn: f32;
    var place_1: u32;
    var meets: bool;
    var row: u32;
    var top: f32;
    var bottom: f32;
    var at_1: vec2<f32>;
    var squared: vec2<f32>;
    var reach: vec2<f32>;
    var ends: vec2<f32>;
    var low: f32;
    var high: f32;
    var from_1: u32;
    var local_3: u32;
    var end: u32;
    var local_4: u32;
    var bits_1: u32;
    var word_4: u32;
    var param_38: u32;
    var param_39: f32;
    var param_40: vec3<f32>;
    var phi_561_: bool;

    let _e62 = (*i_1);
    let _e65 = unnamed.splats[_e62];
    param_37 = _e65;
    let _e66 = unpack_splat_u0028_vu4_u003b((&param_37));
    splat_1 = _e66;
    let _e68 = splat_1.axis;
    let _e70 = splat_1.axis;
    inverse = (1f / dot(_e68, _e70));
    let _e73 = inverse;
    let _e76 = splat_1.axis;
    along = (_e76 * (0.8493218f * _e73));
    let _e78 = inverse;
    let _e82 = splat_1.shorter;
    let _e86 = splat_1.axis[1u];
    let _e90 = splat_1.axis[0u];
    across = (vec2<f32>(-(_e86), _e90) * ((0.8493218f * sqrt(_e78)) / _e82));
    let _e94 = splat_1.opacity;
    exponent_2 = log2((f32(_e94) / 255f));
    let _e99 = splat_1.center;
    let _e100 = (*corner);
    center = (_e99 - _e100);
    let _e103 = along[0u];
    let _e105 = along[0u];
    let _e108 = across[0u];
    let _e110 = across[0u];
    a = ((_e103 * _e105) + (_e108 * _e110));
    let _e114 = along[0u];
    let _e116 = along[1u];
    let _e119 = across[0u];
    let _e121 = across[1u];
    b = ((_e114 * _e116) + (_e119 * _e121));
    let _e125 = along[1u];
    let _e127 = along[1u];
    let _e130 = across[1u];
    let _e132 = across[1u];
    c = ((_e125 * _e127) + (_e130 * _e132));
    let _e135 = along;
    let _e136 = along;
    let _e138 = across;
    let _e139 = across;
    determinant_ = (dot(_e135, _e136) * dot(_e138, _e139));
    let _e142 = exponent_2;
    let _e144 = settings.cutoff_exponent;
    most = ((_e142 - _e144) + 0.00390625f);
    let _e147 = most;
    if (_e147 < 0f) {
        return;
    }
    let _e149 = b;
    let _e151 = most;
    let _e152 = c;
    let _e153 = determinant_;
    turn = (-(_e149) * sqrt((_e151 / (_e152 * _e153))));
    let _e158 = (*thread);
    let _e162 = (*thread);
    place_1 = (((_e158 >> bitcast<u32>(5u)) * 8u) + (_e162 & 7u));
    meets = false;
    row = 0u;
    loop {
        let _e165 = row;
        if (_e165 < 8u) {
            let _e167 = row;
            let _e172 = settings.bin_margin;
            let _e175 = center[1u];
            top = ((((4f * f32(_e167)) + 0.5f) - _e172) - _e175);
            let _e177 = top;
            let _e181 = settings.bin_margin;
            bottom = (((_e177 + 4f) - 1f) + (2f * _e181));
            let _e184 = turn;
            let _e186 = top;
            let _e187 = bottom;
            let _e189 = turn;
            let _e190 = top;
            let _e191 = bottom;
            at_1 = vec2<f32>(clamp(-(_e184), _e186, _e187), clamp(_e189, _e190, _e191));
            let _e194 = a;
            let _e195 = most;
            let _e197 = determinant_;
            let _e198 = at_1;
            let _e200 = at_1;
            squared = (vec2((_e194 * _e195)) - ((_e198 * _e197) * _e200));
            let _e204 = squared;
            reach = sqrt(max(_e204, vec2(0f)));
            let _e208 = b;
            let _e210 = at_1;
            let _e213 = reach[0u];
            let _e216 = reach[1u];
            let _e219 = a;
            let _e223 = center[0u];
            ends = ((((_e210 * -(_e208)) + vec2<f32>(-(_e213), _e216)) / vec2(_e219)) + vec2(_e223));
            let _e227 = ends[0u];
            let _e230 = settings.bin_margin;
            low = ((((_e227 + 0.5f) - _e230) / 4f) - 1f);
            let _e235 = ends[1u];
            let _e238 = settings.bin_margin;
            high = (((_e235 - 0.5f) + _e238) / 4f);
            let _e241 = low;
            if (_e241 > 0f) {
                let _e243 = low;
                local_3 = u32(ceil(min(_e243, 8f)));
            } else {
                local_3 = 0u;
            }
            let _e247 = local_3;
            from_1 = _e247;
            let _e248 = high;
            if (_e248 < 8f) {
                let _e250 = high;
                local_4 = u32((floor(max(_e250, -1f)) + 1f));
            } else {
                local_4 = 8u;
            }
            let _e255 = local_4;
            end = _e255;
            let _e256 = from_1;
            let _e257 = end;
            let _e258 = (_e256 < _e257);
            phi_561_ = _e258;
            if _e258 {
                let _e260 = squared[0u];
                let _e262 = squared[1u];
                phi_561_ = !((max(_e260, _e262) < 0f));
            }
            let _e267 = phi_561_;
            if _e267 {
                let _e268 = end;
                let _e271 = from_1;
                bits_1 = ((1u << bitcast<u32>(_e268)) - (1u << bitcast<u32>(_e271)));
                let _e275 = row;
                let _e277 = place_1;
                let _e280 = bits_1;
                let _e281 = (*thread);
                let _e285 = atomicOr((&batch_hits[((_e275 * 16u) + _e277)]), (_e280 << bitcast<u32>((_e281 & 24u))));
                meets = true;
            }
            continue;
        } else {
            break;
        }
        continuing {
            let _e286 = row;
            row = (_e286 + bitcast<u32>(1i));
        }
    }
    let _e289 = meets;
    if !(_e289) {
        return;
    }
    let _e291 = (*i_1);
    param_38 = _e291;
    let _e292 = key_at_u0028_u1_u003b((&param_38));
    let _e295 = frame.key_max;
    param_39 = (1f - (f32(_e292) / f32(_e295)));
    let _e300 = splat_1.color;
    param_40 = _e300;
    let _e301 = saturated_word_u0028_f1_u003b_vf3_u003b((&param_39), (&param_40));
    word_4 = _e301;
    let _e302 = (*thread);
    let _e303 = center;
    let _e304 = along;
    batch_place[_e302] = vec4<f32>(_e303.x, _e303.y, _e304.x, _e304.y);
    let _e311 = (*thread);
    let _e312 = across;
    let _e313 = exponent_2;
    let _e314 = word_4;
    batch_shape[_e311] = vec4<f32>(_e312.x, _e312.y, _e313, bitcast<f32>(_e314));
    return;
}

fn bins_of_u0028_u1_u003b(shift: ptr<function, u32>) -> vec2<u32> {
    var side: u32;

    let _e5 = frame.bin_side;
    let _e6 = (*shift);
    side = (_e5 << bitcast<u32>(_e6));
    let _e10 = frame.size;
    let _e12 = side;
    let _e17 = side;
    return (((vec2<u32>(_e10) + vec2(_e12)) - vec2(1u)) / vec2(_e17));
}

fn place_of_u0028_u1_u003b(index: ptr<function, u32>) -> vec2<u32> {
    let _e5 = (*index);
    let _e7 = (*index);
    let _e12 = (*index);
    let _e17 = (*index);
    let _e21 = (*index);
    let _e26 = (*index);
    return vec2<u32>((((_e5 & 1u) | ((_e7 >> bitcast<u32>(1u)) & 2u)) | ((_e12 >> bitcast<u32>(2u)) & 4u)), ((((_e17 >> bitcast<u32>(1u)) & 1u) | ((_e21 >> bitcast<u32>(2u)) & 2u)) | ((_e26 >> bitcast<u32>(3u)) & 4u)));
}

fn blend_bin_u0028_struct_u002d_Samples_u002d_f1_u005b_4_u005d_u002d_u1_u005b_4_u005d_u002d_b1_u002d_u11_u003b_vu2_u003b_vf2_u003b(samples_2: ptr<function, Samples>, corner_1: ptr<function, vec2<u32>>, first_3: ptr<function, vec2<f32>>) {
    var thread_1: u32;
    var place_2: vec2<u32>;
    var param_41: u32;
    var shift_1: u32;
    var at_2: vec2<u32>;
    var bin: u32;
    var param_42: u32;
    var end_1: u32;
    var from_2: u32;
    var k_3: u32;
    var i_2: u32;
    var local_5: u32;
    var param_43: u32;
    var param_44: u32;
    var param_45: vec2<f32>;
    var word_5: u32;
    var hits_1: u32;
    var param_46: vec2<u32>;
    var param_47: u32;
    var k_4: u32;
    var param_48: Samples;
    var param_49: u32;
    var param_50: vec2<f32>;

    let _e45 = gl_LocalInvocationIndex_1;
    thread_1 = _e45;
    let _e46 = thread_1;
    param_41 = _e46;
    let _e47 = place_of_u0028_u1_u003b((&param_41));
    place_2 = _e47;
    let _e50 = unnamed_1.bins[8i];
    shift_1 = _e50;
    let _e51 = (*corner_1);
    let _e53 = frame.bin_side;
    let _e54 = shift_1;
    at_2 = (_e51 / vec2((_e53 << bitcast<u32>(_e54))));
    let _e60 = at_2[1u];
    let _e61 = shift_1;
    param_42 = _e61;
    let _e62 = bins_of_u0028_u1_u003b((&param_42));
    let _e66 = at_2[0u];
    bin = ((_e60 * _e62.x) + _e66);
    let _e69 = settings.starts_start;
    let _e70 = bin;
    let _e75 = unnamed_1.bins[((_e69 + _e70) + 1u)];
    end_1 = _e75;
    let _e77 = settings.starts_start;
    let _e78 = bin;
    let _e82 = unnamed_1.bins[(_e77 + _e78)];
    from_2 = _e82;
    loop {
        let _e83 = from_2;
        let _e84 = end_1;
        if (_e83 < _e84) {
            let _e86 = thread_1;
            batch_seen[_e86] = 0u;
            let _e88 = thread_1;
            k_3 = _e88;
            loop {
                let _e89 = k_3;
                if (_e89 < 128u) {
                    let _e91 = k_3;
                    atomicStore((&batch_hits[_e91]), 0u);
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e93 = k_3;
                    k_3 = (_e93 + 64u);
                }
            }
            let _e95 = thread_1;
            if (_e95 == 0u) {
                batch_open = 0u;
            }
            workgroupBarrier();
            let _e98 = (*samples_2).open;
            if _e98 {
                batch_open = 1u;
            }
            let _e99 = from_2;
            let _e100 = thread_1;
            let _e102 = end_1;
            if ((_e99 + _e100) < _e102) {
                let _e105 = settings.pairs_start;
                let _e106 = from_2;
                let _e107 = thread_1;
                let _e111 = unnamed_2.sorted[(_e106 + _e107)];
                let _e115 = unnamed_1.bins[(_e105 + _e111)];
                local_5 = _e115;
            } else {
                local_5 = 0u;
            }
            let _e116 = local_5;
            i_2 = _e116;
            let _e117 = from_2;
            let _e118 = thread_1;
            let _e120 = end_1;
            if ((_e117 + _e118) < _e120) {
                let _e122 = (*corner_1);
                let _e124 = thread_1;
                param_43 = _e124;
                let _e125 = i_2;
                param_44 = _e125;
                param_45 = vec2<f32>(_e122);
                load_u0028_u1_u003b_u1_u003b_vf2_u003b((&param_43), (&param_44), (&param_45));
            }
            workgroupBarrier();
            let _e126 = workgroupUniformLoad((&batch_open));
            if (_e126 == 0u) {
                break;
            }
            word_5 = 0u;
            loop {
                let _e128 = word_5;
                let _e131 = (*samples_2).open;
                if ((_e128 < 2u) && _e131) {
                    let _e133 = place_2;
                    param_46 = _e133;
                    let _e134 = word_5;
                    param_47 = _e134;
                    let _e135 = hits_of_u0028_vu2_u003b_u1_u003b((&param_46), (&param_47));
                    hits_1 = _e135;
                    loop {
                        let _e136 = hits_1;
                        let _e139 = (*samples_2).open;
                        if ((_e136 != 0u) && _e139) {
                            let _e141 = hits_1;
                            k_4 = bitcast<u32>(firstTrailingBit(_e141));
                            let _e144 = hits_1;
                            let _e146 = hits_1;
                            hits_1 = (_e146 & (_e144 - 1u));
                            let _e148 = word_5;
                            let _e150 = k_4;
                            batch_seen[((32u * _e148) + _e150)] = 1u;
                            let _e153 = word_5;
                            let _e155 = k_4;
                            let _e157 = (*samples_2);
                            param_48 = _e157;
                            param_49 = ((32u * _e153) + _e155);
                            let _e158 = (*first_3);
                            param_50 = _e158;
                            blend_u0028_struct_u002d_Samples_u002d_f1_u005b_4_u005d_u002d_u1_u005b_4_u005d_u002d_b1_u002d_u11_u003b_u1_u003b_vf2_u003b((&param_48), (&param_49), (&param_50));
                            let _e159 = param_48;
                            (*samples_2) = _e159;
                            continue;
                        } else {
                            break;
                        }
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e160 = word_5;
                    word_5 = (_e160 + bitcast<u32>(1i));
                }
            }
            workgroupBarrier();
            let _e163 = thread_1;
            let _e165 = batch_seen[_e163];
            if (_e165 != 0u) {
                let _e167 = i_2;
                let _e172 = i_2;
                let _e176 = atomicOr((&unnamed_3.marks[(_e167 >> bitcast<u32>(5u))]), (1u << bitcast<u32>((_e172 & 31u))));
            }
            continue;
        } else {
            break;
        }
        continuing {
            let _e177 = from_2;
            from_2 = (_e177 + 64u);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn main(@builtin(local_invocation_index) gl_LocalInvocationIndex: u32, @builtin(workgroup_id) gl_WorkGroupID: vec3<u32>) {
    var region: vec2<u32>;
    var first: vec2<u32>;
    var param: u32;
    var samples: Samples;
    var param_1: Samples;
    var param_2: vec2<u32>;
    var param_3: vec2<f32>;
    var param_4: vec2<u32>;
    var param_5: u32;
    var param_6: vec2<u32>;
    var param_7: u32;
    var param_8: vec2<u32>;
    var param_9: u32;
    var param_10: vec2<u32>;
    var param_11: u32;
    var phi_1209_: bool;

    gl_LocalInvocationIndex_1 = gl_LocalInvocationIndex;
    gl_WorkGroupID_1 = gl_WorkGroupID;
    let _e36 = settings.first_region;
    region = (_e36 + bitcast<vec3<u32>>(gl_WorkGroupID).xy);
    param = bitcast<u32>(gl_LocalInvocationIndex);
    let _e41 = place_of_u0028_u1_u003b((&param));
    first = (vec2(2u) * _e41);
    samples.open = true;
    samples.evaluated = 0u;
    samples.light = array<f32, 4>(1f, 1f, 1f, 1f);
    samples.word = array<u32, 4>(4294901760u, 4294901760u, 4294901760u, 4294901760u);
    let _e48 = region;
    let _e51 = first;
    let _e56 = samples;
    param_1 = _e56;
    param_2 = (_e48 * vec2(32u));
    param_3 = ((vec2<f32>(_e51) + vec2(0.5f)) * 2f);
    blend_bin_u0028_struct_u002d_Samples_u002d_f1_u005b_4_u005d_u002d_u1_u005b_4_u005d_u002d_b1_u002d_u11_u003b_vu2_u003b_vf2_u003b((&param_1), (&param_2), (&param_3));
    let _e57 = param_1;
    samples = _e57;
    let _e58 = region;
    let _e61 = first;
    first = (_e61 + (_e58 * vec2(16u)));
    let _e63 = first;
    param_4 = _e63;
    let _e66 = samples.word[0i];
    param_5 = _e66;
    store_u0028_vu2_u003b_u1_u003b((&param_4), (&param_5));
    let _e67 = first;
    param_6 = (_e67 + vec2<u32>(1u, 0u));
    let _e71 = samples.word[1i];
    param_7 = _e71;
    store_u0028_vu2_u003b_u1_u003b((&param_6), (&param_7));
    let _e72 = first;
    param_8 = (_e72 + vec2<u32>(0u, 1u));
    let _e76 = samples.word[2i];
    param_9 = _e76;
    store_u0028_vu2_u003b_u1_u003b((&param_8), (&param_9));
    let _e77 = first;
    param_10 = (_e77 + vec2<u32>(1u, 1u));
    let _e81 = samples.word[3i];
    param_11 = _e81;
    store_u0028_vu2_u003b_u1_u003b((&param_10), (&param_11));
    let _e83 = settings.counted;
    let _e84 = (_e83 != 0u);
    phi_1209_ = _e84;
    if _e84 {
        let _e86 = samples.evaluated;
        phi_1209_ = (_e86 > 0u);
    }
    let _e89 = phi_1209_;
    if _e89 {
        let _e93 = samples.evaluated;
        let _e94 = atomicAdd((&unnamed_4.control.fragments), _e93);
    }
    return;
}
