struct Splat {
    center: vec2<f32>,
    axis: vec2<f32>,
    shorter: f32,
    color: vec3<f32>,
    opacity: u32,
}

struct Ellipse {
    center: vec2<f32>,
    a: f32,
    b: f32,
    c: f32,
    determinant: f32,
    most: f32,
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
    var phi_860_: bool;

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
    phi_860_ = _e19;
    if _e19 {
        let _e20 = behind;
        let _e22 = settings.saturation;
        phi_860_ = (_e20 < _e22);
    }
    let _e25 = phi_860_;
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

fn place_of_u0028_u1_u003b(index: ptr<function, u32>) -> vec2<u32> {
    let _e5 = (*index);
    let _e7 = (*index);
    let _e12 = (*index);
    let _e17 = (*index);
    let _e21 = (*index);
    let _e26 = (*index);
    return vec2<u32>((((_e5 & 1u) | ((_e7 >> bitcast<u32>(1u)) & 2u)) | ((_e12 >> bitcast<u32>(2u)) & 4u)), ((((_e17 >> bitcast<u32>(1u)) & 1u) | ((_e21 >> bitcast<u32>(2u)) & 2u)) | ((_e26 >> bitcast<u32>(3u)) & 4u)));
}

fn hits_of_u0028_u1_u003b_u1_u003b(thread: ptr<function, u32>, word_2: ptr<function, u32>) -> u32 {
    var place_1: vec2<u32>;
    var param_36: u32;
    var hits: u32;
    var k_2: u32;
    var bits: u32;

    let _e14 = (*thread);
    param_36 = _e14;
    let _e15 = place_of_u0028_u1_u003b((&param_36));
    place_1 = _e15;
    hits = 0u;
    k_2 = 0u;
    loop {
        let _e16 = k_2;
        if (_e16 < 8u) {
            let _e19 = place_1[1u];
            let _e21 = (*word_2);
            let _e24 = k_2;
            let _e27 = atomicLoad((&batch_hits[(((_e19 * 16u) + (8u * _e21)) + _e24)]));
            bits = _e27;
            let _e28 = bits;
            let _e30 = place_1[0u];
            let _e34 = k_2;
            let _e37 = hits;
            hits = (_e37 | (((_e28 >> bitcast<u32>(_e30)) & 16843009u) << bitcast<u32>(_e34)));
            continue;
        } else {
            break;
        }
        continuing {
            let _e39 = k_2;
            k_2 = (_e39 + bitcast<u32>(1i));
        }
    }
    let _e42 = hits;
    return _e42;
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

fn intervals_u0028_f1_u003b_f1_u003b_f1_u003b(low: ptr<function, f32>, high: ptr<function, f32>, side: ptr<function, f32>) -> vec2<u32> {
    var first_3: f32;
    var last: f32;
    var local_3: u32;
    var local_4: u32;

    let _e15 = (*low);
    let _e18 = settings.bin_margin;
    let _e20 = (*side);
    first_3 = ((((_e15 + 0.5f) - _e18) / _e20) - 1f);
    let _e23 = (*high);
    let _e26 = settings.bin_margin;
    let _e28 = (*side);
    last = (((_e23 - 0.5f) + _e26) / _e28);
    let _e30 = first_3;
    if (_e30 > 0f) {
        let _e32 = first_3;
        local_3 = u32(ceil(min(_e32, 8f)));
    } else {
        local_3 = 0u;
    }
    let _e36 = local_3;
    let _e37 = last;
    if (_e37 < 8f) {
        let _e39 = last;
        local_4 = u32((floor(max(_e39, -1f)) + 1f));
    } else {
        local_4 = 8u;
    }
    let _e44 = local_4;
    return vec2<u32>(_e36, _e44);
}

fn note_hits_u0028_u1_u003b_struct_u002d_Ellipse_u002d_vf2_u002d_f1_u002d_f1_u002d_f1_u002d_f1_u002d_f11_u003b(k_3: ptr<function, u32>, e: ptr<function, Ellipse>) -> bool {
    var turn: f32;
    var height: f32;
    var rows: vec2<u32>;
    var param_37: f32;
    var param_38: f32;
    var param_39: f32;
    var place_2: u32;
    var meets: bool;
    var row: u32;
    var top: f32;
    var bottom: f32;
    var at_1: vec2<f32>;
    var squared: vec2<f32>;
    var reach: vec2<f32>;
    var ends: vec2<f32>;
    var met: vec2<u32>;
    var param_40: f32;
    var param_41: f32;
    var param_42: f32;
    var bits_1: u32;
    var phi_543_: bool;

    let _e40 = (*e).b;
    let _e43 = (*e).most;
    let _e45 = (*e).c;
    let _e47 = (*e).determinant;
    turn = (-(_e40) * sqrt((_e43 / (_e45 * _e47))));
    let _e53 = (*e).a;
    let _e55 = (*e).most;
    let _e58 = (*e).determinant;
    height = sqrt(((_e53 * _e55) / _e58));
    let _e63 = (*e).center[1u];
    let _e64 = height;
    let _e68 = (*e).center[1u];
    let _e69 = height;
    param_37 = (_e63 - _e64);
    param_38 = (_e68 + _e69);
    param_39 = 4f;
    let _e71 = intervals_u0028_f1_u003b_f1_u003b_f1_u003b((&param_37), (&param_38), (&param_39));
    rows = _e71;
    let _e72 = (*k_3);
    let _e76 = (*k_3);
    place_2 = (((_e72 >> bitcast<u32>(5u)) * 8u) + (_e76 & 7u));
    meets = false;
    let _e80 = rows[0u];
    row = _e80;
    loop {
        let _e81 = row;
        let _e83 = rows[1u];
        if (_e81 < _e83) {
            let _e85 = row;
            let _e90 = settings.bin_margin;
            let _e94 = (*e).center[1u];
            top = ((((4f * f32(_e85)) + 0.5f) - _e90) - _e94);
            let _e96 = top;
            let _e100 = settings.bin_margin;
            bottom = (((_e96 + 4f) - 1f) + (2f * _e100));
            let _e103 = turn;
            let _e105 = top;
            let _e106 = bottom;
            let _e108 = turn;
            let _e109 = top;
            let _e110 = bottom;
            at_1 = vec2<f32>(clamp(-(_e103), _e105, _e106), clamp(_e108, _e109, _e110));
            let _e114 = (*e).a;
            let _e116 = (*e).most;
            let _e119 = (*e).determinant;
            let _e120 = at_1;
            let _e122 = at_1;
            squared = (vec2((_e114 * _e116)) - ((_e120 * _e119) * _e122));
            let _e126 = squared;
            reach = sqrt(max(_e126, vec2(0f)));
            let _e131 = (*e).b;
            let _e133 = at_1;
            let _e136 = reach[0u];
            let _e139 = reach[1u];
            let _e143 = (*e).a;
            let _e148 = (*e).center[0u];
            ends = ((((_e133 * -(_e131)) + vec2<f32>(-(_e136), _e139)) / vec2(_e143)) + vec2(_e148));
            let _e152 = ends[0u];
            param_40 = _e152;
            let _e154 = ends[1u];
            param_41 = _e154;
            param_42 = 4f;
            let _e155 = intervals_u0028_f1_u003b_f1_u003b_f1_u003b((&param_40), (&param_41), (&param_42));
            met = _e155;
            let _e157 = met[0u];
            let _e159 = met[1u];
            let _e160 = (_e157 < _e159);
            phi_543_ = _e160;
            if _e160 {
                let _e162 = squared[0u];
                let _e164 = squared[1u];
                phi_543_ = !((max(_e162, _e164) < 0f));
            }
            let _e169 = phi_543_;
            if _e169 {
                let _e171 = met[1u];
                let _e175 = met[0u];
                bits_1 = ((1u << bitcast<u32>(_e171)) - (1u << bitcast<u32>(_e175)));
                let _e179 = row;
                let _e181 = place_2;
                let _e184 = bits_1;
                let _e185 = (*k_3);
                let _e189 = atomicOr((&batch_hits[((_e179 * 16u) + _e181)]), (_e184 << bitcast<u32>((_e185 & 24u))));
                meets = true;
            }
            continue;
        } else {
            break;
        }
        continuing {
            let _e190 = row;
            row = (_e190 + bitcast<u32>(1i));
        }
    }
    let _e193 = meets;
    return _e193;
}

fn fixed_center_u0028_vu4_u003b(words: ptr<function, vec4<u32>>) -> vec2<f32> {
    let _e2 = (*words);
    return vec2<f32>((_e2.xy & vec2(1048575u)));
}

fn unpack_splat_u0028_vu4_u003b(words_1: ptr<function, vec4<u32>>) -> Splat {
    var splat: Splat;
    var param_43: vec4<u32>;
    var blue: u32;
    var red: u32;
    var green: u32;

    let _e18 = (*words_1);
    param_43 = _e18;
    let _e19 = fixed_center_u0028_vu4_u003b((&param_43));
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

fn load_u0028_u1_u003b_u1_u003b_vf2_u003b(thread_1: ptr<function, u32>, i_1: ptr<function, u32>, corner: ptr<function, vec2<f32>>) {
    var splat_1: Splat;
    var param_44: vec4<u32>;
    var inverse: f32;
    var along: vec2<f32>;
    var across: vec2<f32>;
    var exponent_2: f32;
    var ellipse: Ellipse;
    var param_45: u32;
    var param_46: Ellipse;
    var word_4: u32;
    var param_47: u32;
    var param_48: f32;
    var param_49: vec3<f32>;
    var phi_724_: bool;

    let _e28 = (*i_1);
    let _e31 = unnamed.splats[_e28];
    param_44 = _e31;
    let _e32 = unpack_splat_u0028_vu4_u003b((&param_44));
    splat_1 = _e32;
    let _e34 = splat_1.axis;
    let _e36 = splat_1.axis;
    inverse = (1f / dot(_e34, _e36));
    let _e39 = inverse;
    let _e42 = splat_1.axis;
    along = (_e42 * (0.8493218f * _e39));
    let _e44 = inverse;
    let _e48 = splat_1.shorter;
    let _e52 = splat_1.axis[1u];
    let _e56 = splat_1.axis[0u];
    across = (vec2<f32>(-(_e52), _e56) * ((0.8493218f * sqrt(_e44)) / _e48));
    let _e60 = splat_1.opacity;
    exponent_2 = log2((f32(_e60) / 255f));
    let _e65 = splat_1.center;
    let _e66 = (*corner);
    ellipse.center = (_e65 - _e66);
    let _e70 = along[0u];
    let _e72 = along[0u];
    let _e75 = across[0u];
    let _e77 = across[0u];
    ellipse.a = ((_e70 * _e72) + (_e75 * _e77));
    let _e82 = along[0u];
    let _e84 = along[1u];
    let _e87 = across[0u];
    let _e89 = across[1u];
    ellipse.b = ((_e82 * _e84) + (_e87 * _e89));
    let _e94 = along[1u];
    let _e96 = along[1u];
    let _e99 = across[1u];
    let _e101 = across[1u];
    ellipse.c = ((_e94 * _e96) + (_e99 * _e101));
    let _e105 = along;
    let _e106 = along;
    let _e108 = across;
    let _e109 = across;
    ellipse.determinant = (dot(_e105, _e106) * dot(_e108, _e109));
    let _e113 = exponent_2;
    let _e115 = settings.cutoff_exponent;
    ellipse.most = ((_e113 - _e115) + 0.00390625f);
    let _e120 = ellipse.most;
    let _e121 = (_e120 < 0f);
    phi_724_ = _e121;
    if !(_e121) {
        let _e123 = (*thread_1);
        param_45 = _e123;
        let _e124 = ellipse;
        param_46 = _e124;
        let _e125 = note_hits_u0028_u1_u003b_struct_u002d_Ellipse_u002d_vf2_u002d_f1_u002d_f1_u002d_f1_u002d_f1_u002d_f11_u003b((&param_45), (&param_46));
        phi_724_ = !(_e125);
    }
    let _e128 = phi_724_;
    if _e128 {
        return;
    }
    let _e129 = (*i_1);
    param_47 = _e129;
    let _e130 = key_at_u0028_u1_u003b((&param_47));
    let _e133 = frame.key_max;
    param_48 = (1f - (f32(_e130) / f32(_e133)));
    let _e138 = splat_1.color;
    param_49 = _e138;
    let _e139 = saturated_word_u0028_f1_u003b_vf3_u003b((&param_48), (&param_49));
    word_4 = _e139;
    let _e140 = (*thread_1);
    let _e142 = ellipse.center;
    let _e143 = along;
    batch_place[_e140] = vec4<f32>(_e142.x, _e142.y, _e143.x, _e143.y);
    let _e150 = (*thread_1);
    let _e151 = across;
    let _e152 = exponent_2;
    let _e153 = word_4;
    batch_shape[_e150] = vec4<f32>(_e151.x, _e151.y, _e152, bitcast<f32>(_e153));
    return;
}

fn bins_of_u0028_u1_u003b(shift: ptr<function, u32>) -> vec2<u32> {
    var side_1: u32;

    let _e5 = frame.bin_side;
    let _e6 = (*shift);
    side_1 = (_e5 << bitcast<u32>(_e6));
    let _e10 = frame.size;
    let _e12 = side_1;
    let _e17 = side_1;
    return (((vec2<u32>(_e10) + vec2(_e12)) - vec2(1u)) / vec2(_e17));
}

fn blend_bin_u0028_struct_u002d_Samples_u002d_f1_u005b_4_u005d_u002d_u1_u005b_4_u005d_u002d_b1_u002d_u11_u003b_vu2_u003b_vf2_u003b(samples_2: ptr<function, Samples>, corner_1: ptr<function, vec2<u32>>, first_4: ptr<function, vec2<f32>>) {
    var thread_2: u32;
    var shift_1: u32;
    var at_2: vec2<u32>;
    var bin: u32;
    var param_50: u32;
    var end: u32;
    var from_1: u32;
    var k_4: u32;
    var i_2: u32;
    var local_5: u32;
    var param_51: u32;
    var param_52: u32;
    var param_53: vec2<f32>;
    var word_5: u32;
    var hits_1: u32;
    var param_54: u32;
    var param_55: u32;
    var k_5: u32;
    var param_56: Samples;
    var param_57: u32;
    var param_58: vec2<f32>;

    let _e43 = gl_LocalInvocationIndex_1;
    thread_2 = _e43;
    let _e46 = unnamed_1.bins[8i];
    shift_1 = _e46;
    let _e47 = (*corner_1);
    let _e49 = frame.bin_side;
    let _e50 = shift_1;
    at_2 = (_e47 / vec2((_e49 << bitcast<u32>(_e50))));
    let _e56 = at_2[1u];
    let _e57 = shift_1;
    param_50 = _e57;
    let _e58 = bins_of_u0028_u1_u003b((&param_50));
    let _e62 = at_2[0u];
    bin = ((_e56 * _e58.x) + _e62);
    let _e65 = settings.starts_start;
    let _e66 = bin;
    let _e71 = unnamed_1.bins[((_e65 + _e66) + 1u)];
    end = _e71;
    let _e73 = settings.starts_start;
    let _e74 = bin;
    let _e78 = unnamed_1.bins[(_e73 + _e74)];
    from_1 = _e78;
    loop {
        let _e79 = from_1;
        let _e80 = end;
        if (_e79 < _e80) {
            let _e82 = thread_2;
            batch_seen[_e82] = 0u;
            let _e84 = thread_2;
            k_4 = _e84;
            loop {
                let _e85 = k_4;
                if (_e85 < 128u) {
                    let _e87 = k_4;
                    atomicStore((&batch_hits[_e87]), 0u);
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e89 = k_4;
                    k_4 = (_e89 + 64u);
                }
            }
            let _e91 = thread_2;
            if (_e91 == 0u) {
                batch_open = 0u;
            }
            workgroupBarrier();
            let _e94 = (*samples_2).open;
            if _e94 {
                batch_open = 1u;
            }
            let _e95 = from_1;
            let _e96 = thread_2;
            let _e98 = end;
            if ((_e95 + _e96) < _e98) {
                let _e101 = settings.pairs_start;
                let _e102 = from_1;
                let _e103 = thread_2;
                let _e107 = unnamed_2.sorted[(_e102 + _e103)];
                let _e111 = unnamed_1.bins[(_e101 + _e107)];
                local_5 = _e111;
            } else {
                local_5 = 0u;
            }
            let _e112 = local_5;
            i_2 = _e112;
            let _e113 = from_1;
            let _e114 = thread_2;
            let _e116 = end;
            if ((_e113 + _e114) < _e116) {
                let _e118 = (*corner_1);
                let _e120 = thread_2;
                param_51 = _e120;
                let _e121 = i_2;
                param_52 = _e121;
                param_53 = vec2<f32>(_e118);
                load_u0028_u1_u003b_u1_u003b_vf2_u003b((&param_51), (&param_52), (&param_53));
            }
            workgroupBarrier();
            let _e122 = workgroupUniformLoad((&batch_open));
            if (_e122 == 0u) {
                break;
            }
            word_5 = 0u;
            loop {
                let _e124 = word_5;
                let _e127 = (*samples_2).open;
                if ((_e124 < 2u) && _e127) {
                    let _e129 = thread_2;
                    param_54 = _e129;
                    let _e130 = word_5;
                    param_55 = _e130;
                    let _e131 = hits_of_u0028_u1_u003b_u1_u003b((&param_54), (&param_55));
                    hits_1 = _e131;
                    loop {
                        let _e132 = hits_1;
                        let _e135 = (*samples_2).open;
                        if ((_e132 != 0u) && _e135) {
                            let _e137 = hits_1;
                            k_5 = bitcast<u32>(firstTrailingBit(_e137));
                            let _e140 = hits_1;
                            let _e142 = hits_1;
                            hits_1 = (_e142 & (_e140 - 1u));
                            let _e144 = word_5;
                            let _e146 = k_5;
                            batch_seen[((32u * _e144) + _e146)] = 1u;
                            let _e149 = word_5;
                            let _e151 = k_5;
                            let _e153 = (*samples_2);
                            param_56 = _e153;
                            param_57 = ((32u * _e149) + _e151);
                            let _e154 = (*first_4);
                            param_58 = _e154;
                            blend_u0028_struct_u002d_Samples_u002d_f1_u005b_4_u005d_u002d_u1_u005b_4_u005d_u002d_b1_u002d_u11_u003b_u1_u003b_vf2_u003b((&param_56), (&param_57), (&param_58));
                            let _e155 = param_56;
                            (*samples_2) = _e155;
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
                    let _e156 = word_5;
                    word_5 = (_e156 + bitcast<u32>(1i));
                }
            }
            workgroupBarrier();
            let _e159 = thread_2;
            let _e161 = batch_seen[_e159];
            if (_e161 != 0u) {
                let _e163 = i_2;
                let _e168 = i_2;
                let _e172 = atomicOr((&unnamed_3.marks[(_e163 >> bitcast<u32>(5u))]), (1u << bitcast<u32>((_e168 & 31u))));
            }
            continue;
        } else {
            break;
        }
        continuing {
            let _e173 = from_1;
            from_1 = (_e173 + 64u);
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
    var phi_1283_: bool;

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
    phi_1283_ = _e84;
    if _e84 {
        let _e86 = samples.evaluated;
        phi_1283_ = (_e86 > 0u);
    }
    let _e89 = phi_1283_;
    if _e89 {
        let _e93 = samples.evaluated;
        let _e94 = atomicAdd((&unnamed_4.control.fragments), _e93);
    }
    return;
}
