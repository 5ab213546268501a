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
    opacity: vec4<f32>,
    word: u32,
}

struct Samples {
    pixels: array<vec4<f32>, 4>,
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

struct SettingsBlock {
    cutoff_exponent: f32,
    quad_exponent: f32,
    cutoff: f32,
    saturation: f32,
    sort_tiles: u32,
    key_capacity: u32,
    scanned: u32,
    key_count: u32,
    counted: u32,
    unused: u32,
    first_region: vec2<u32>,
    counts_start: u32,
    starts_start: u32,
    pairs_start: u32,
    pair_capacity: u32,
}

struct Sorted {
    sorted: array<u32>,
}

struct Bins {
    bins: array<u32>,
}

struct Splats {
    splats: array<vec4<u32>>,
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

struct Sorted_1 {
    sorted: array<u32, LENGTH_3_4>,
}

struct Bins_1 {
    bins: array<u32, LENGTH_4_4>,
}

struct Splats_1 {
    splats: array<vec4<u32>, LENGTH_1_16>,
}

@group(0) @binding(0) 
var<uniform> frame: FrameBlock;
var<workgroup> batch_hits: array<atomic<u32>, 512>;
@group(0) @binding(7) 
var<uniform> settings: SettingsBlock;
var<workgroup> batch_place: array<vec4<f32>, 256>;
var<workgroup> batch_shape: array<vec4<f32>, 256>;
@group(0) @binding(3) 
var<storage> unnamed: Sorted_1;
@group(0) @binding(4) 
var<storage> unnamed_1: Bins_1;
var<private> gl_LocalInvocationIndex_1: u32;
var<workgroup> batch_open: u32;
@group(0) @binding(1) 
var<storage> unnamed_2: Splats_1;
@group(0) @binding(5) 
var image: texture_storage_2d<rgba8unorm,write>;
var<private> gl_WorkGroupID_1: vec3<u32>;
@group(0) @binding(2) 
var<storage, read_write> unnamed_3: ControlBuffer;

fn filled_u0028_vf4_u003b_b1_u003b(pixel: ptr<function, vec4<f32>>, open: ptr<function, bool>) -> vec4<f32> {
    var covered: f32;
    var local: vec4<f32>;

    let _e7 = (*pixel)[3u];
    covered = (1f - _e7);
    let _e9 = (*open);
    if _e9 {
        let _e10 = (*pixel);
        let _e11 = _e10.xyz;
        let _e12 = covered;
        local = vec4<f32>(_e11.x, _e11.y, _e11.z, _e12);
    } else {
        let _e17 = (*pixel);
        let _e19 = covered;
        let _e21 = (_e17.xyz / vec3(_e19));
        local = vec4<f32>(_e21.x, _e21.y, _e21.z, 1f);
    }
    let _e26 = local;
    return _e26;
}

fn store_u0028_vu2_u003b_vf4_u003b_b1_u003b(at: ptr<function, vec2<u32>>, pixel_1: ptr<function, vec4<f32>>, open_1: ptr<function, bool>) {
    var param_17: vec4<f32>;
    var param_18: bool;

    let _e9 = (*at);
    let _e11 = frame.size;
    if all((_e9 < vec2<u32>(_e11))) {
        let _e15 = (*pixel_1);
        param_17 = _e15;
        let _e16 = (*open_1);
        param_18 = _e16;
        let _e17 = filled_u0028_vf4_u003b_b1_u003b((&param_17), (&param_18));
        (*pixel_1) = _e17;
        let _e18 = (*at);
        let _e20 = (*pixel_1);
        let _e23 = (_e20.xyz / vec3(1023f));
        let _e25 = (*pixel_1)[3u];
        textureStore(image, bitcast<vec2<i32>>(_e18), vec4<f32>(_e23.x, _e23.y, _e23.z, _e25));
    }
    return;
}

fn blend_u0028_struct_u002d_Samples_u002d_vf4_u005b_4_u005d_u002d_b1_u002d_u11_u003b_struct_u002d_Seen_u002d_vf4_u002d_u11_u003b(samples_1: ptr<function, Samples>, seen: ptr<function, Seen>) {
    var color: vec3<f32>;
    var p: u32;
    var pixel_2: vec4<f32>;
    var share: f32;

    let _e18 = (*seen).word;
    let _e22 = (*seen).word;
    let _e28 = (*seen).word;
    color = vec3<f32>(f32((_e18 & 1023u)), f32(((_e22 >> bitcast<u32>(10u)) & 1023u)), f32((_e28 >> bitcast<u32>(20u))));
    p = 0u;
    loop {
        let _e33 = p;
        if (_e33 < 4u) {
            let _e35 = p;
            let _e38 = (*samples_1).pixels[_e35];
            pixel_2 = _e38;
            let _e39 = p;
            let _e42 = (*seen).opacity[_e39];
            let _e44 = pixel_2[3u];
            share = (_e42 * _e44);
            let _e46 = p;
            let _e47 = pixel_2;
            let _e49 = share;
            let _e50 = color;
            let _e52 = (_e47.xyz + (_e50 * _e49));
            let _e54 = pixel_2[3u];
            let _e55 = share;
            (*samples_1).pixels[_e46] = vec4<f32>(_e52.x, _e52.y, _e52.z, (_e54 - _e55));
            continue;
        } else {
            break;
        }
        continuing {
            let _e63 = p;
            p = (_e63 + bitcast<u32>(1i));
        }
    }
    let _e69 = (*samples_1).pixels[0i][3u];
    let _e73 = (*samples_1).pixels[1i][3u];
    let _e78 = (*samples_1).pixels[2i][3u];
    let _e82 = (*samples_1).pixels[3i][3u];
    let _e86 = settings.saturation;
    (*samples_1).open = (max(max(_e69, _e73), max(_e78, _e82)) >= _e86);
    return;
}

fn note_seen_u0028_u1_u003b(k: ptr<function, u32>) {
    return;
}

fn opacity_at_u0028_vf2_u003b_f1_u003b_vf2_u003b_vf2_u003b(deviation: ptr<function, vec2<f32>>, exponent: ptr<function, f32>, right: ptr<function, vec2<f32>>, down: ptr<function, vec2<f32>>) -> f32 {
    var power: f32;
    var local_1: f32;

    let _e7 = (*exponent);
    let _e8 = (*deviation);
    let _e9 = (*deviation);
    power = (_e7 - dot(_e8, _e9));
    let _e12 = power;
    let _e14 = settings.cutoff_exponent;
    if (_e12 >= _e14) {
        let _e16 = power;
        local_1 = min(0.99f, exp2(_e16));
    } else {
        local_1 = 0f;
    }
    let _e19 = local_1;
    return _e19;
}

fn see_u0028_u1_u003b_vf2_u003b(k_1: ptr<function, u32>, first_1: ptr<function, vec2<f32>>) -> Seen {
    var place: vec4<f32>;
    var shape: vec4<f32>;
    var from_: vec2<f32>;
    var deviation_1: vec2<f32>;
    var right_1: vec2<f32>;
    var down_1: vec2<f32>;
    var second: vec2<f32>;
    var below: vec2<f32>;
    var seen_1: Seen;
    var param_19: vec2<f32>;
    var param_20: f32;
    var param_21: vec2<f32>;
    var param_22: vec2<f32>;
    var param_23: vec2<f32>;
    var param_24: f32;
    var param_25: vec2<f32>;
    var param_26: vec2<f32>;
    var param_27: vec2<f32>;
    var param_28: f32;
    var param_29: vec2<f32>;
    var param_30: vec2<f32>;
    var param_31: vec2<f32>;
    var param_32: f32;
    var param_33: vec2<f32>;
    var param_34: vec2<f32>;

    let _e34 = (*k_1);
    let _e36 = batch_place[_e34];
    place = _e36;
    let _e37 = (*k_1);
    let _e39 = batch_shape[_e37];
    shape = _e39;
    let _e40 = (*first_1);
    let _e41 = place;
    from_ = (_e40 - _e41.xy);
    let _e44 = from_;
    let _e45 = place;
    let _e48 = from_;
    let _e49 = shape;
    deviation_1 = vec2<f32>(dot(_e44, _e45.zw), dot(_e48, _e49.xy));
    let _e54 = place[2u];
    let _e56 = shape[0u];
    right_1 = vec2<f32>(_e54, _e56);
    let _e59 = place[3u];
    let _e61 = shape[1u];
    down_1 = vec2<f32>(_e59, _e61);
    let _e63 = deviation_1;
    let _e64 = right_1;
    second = (_e63 + (_e64 * 1f));
    let _e67 = down_1;
    below = (_e67 * 1f);
    let _e69 = deviation_1;
    param_19 = _e69;
    let _e71 = shape[2u];
    param_20 = _e71;
    let _e72 = right_1;
    param_21 = _e72;
    let _e73 = down_1;
    param_22 = _e73;
    let _e74 = opacity_at_u0028_vf2_u003b_f1_u003b_vf2_u003b_vf2_u003b((&param_19), (&param_20), (&param_21), (&param_22));
    let _e75 = second;
    param_23 = _e75;
    let _e77 = shape[2u];
    param_24 = _e77;
    let _e78 = right_1;
    param_25 = _e78;
    let _e79 = down_1;
    param_26 = _e79;
    let _e80 = opacity_at_u0028_vf2_u003b_f1_u003b_vf2_u003b_vf2_u003b((&param_23), (&param_24), (&param_25), (&param_26));
    let _e81 = deviation_1;
    let _e82 = below;
    param_27 = (_e81 + _e82);
    let _e85 = shape[2u];
    param_28 = _e85;
    let _e86 = right_1;
    param_29 = _e86;
    let _e87 = down_1;
    param_30 = _e87;
    let _e88 = opacity_at_u0028_vf2_u003b_f1_u003b_vf2_u003b_vf2_u003b((&param_27), (&param_28), (&param_29), (&param_30));
    let _e89 = second;
    let _e90 = below;
    param_31 = (_e89 + _e90);
    let _e93 = shape[2u];
    param_32 = _e93;
    let _e94 = right_1;
    param_33 = _e94;
    let _e95 = down_1;
    param_34 = _e95;
    let _e96 = opacity_at_u0028_vf2_u003b_f1_u003b_vf2_u003b_vf2_u003b((&param_31), (&param_32), (&param_33), (&param_34));
    seen_1.opacity = vec4<f32>(_e74, _e80, _e88, _e96);
    let _e100 = shape[3u];
    seen_1.word = bitcast<u32>(_e100);
    let _e103 = seen_1;
    return _e103;
}

fn blend_hits_u0028_struct_u002d_Samples_u002d_vf4_u005b_4_u005d_u002d_b1_u002d_u11_u003b_u1_u003b_u1_u003b_vf2_u003b(samples_2: ptr<function, Samples>, hits: ptr<function, u32>, from_1: ptr<function, u32>, first_2: ptr<function, vec2<f32>>) {
    var k_2: u32;
    var both: bool;
    var l: u32;
    var local_2: u32;
    var seen_2: Seen;
    var param_35: u32;
    var param_36: vec2<f32>;
    var second_1: Seen;
    var param_37: u32;
    var param_38: vec2<f32>;
    var param_39: u32;
    var param_40: Samples;
    var param_41: Seen;
    var shows: bool;
    var param_42: u32;
    var param_43: Samples;
    var param_44: Seen;

    loop {
        let _e27 = (*hits);
        let _e30 = (*samples_2).open;
        if ((_e27 != 0u) && _e30) {
            let _e32 = (*from_1);
            let _e33 = (*hits);
            k_2 = (_e32 + bitcast<u32>(firstTrailingBit(_e33)));
            let _e37 = (*hits);
            let _e39 = (*hits);
            (*hits) = (_e39 & (_e37 - 1u));
            let _e41 = (*hits);
            both = (_e41 != 0u);
            let _e43 = both;
            if _e43 {
                let _e44 = (*from_1);
                let _e45 = (*hits);
                local_2 = (_e44 + bitcast<u32>(firstTrailingBit(_e45)));
            } else {
                let _e49 = k_2;
                local_2 = _e49;
            }
            let _e50 = local_2;
            l = _e50;
            let _e51 = (*hits);
            let _e53 = (*hits);
            (*hits) = (_e53 & (_e51 - 1u));
            let _e55 = k_2;
            param_35 = _e55;
            let _e56 = (*first_2);
            param_36 = _e56;
            let _e57 = see_u0028_u1_u003b_vf2_u003b((&param_35), (&param_36));
            seen_2 = _e57;
            let _e58 = l;
            param_37 = _e58;
            let _e59 = (*first_2);
            param_38 = _e59;
            let _e60 = see_u0028_u1_u003b_vf2_u003b((&param_37), (&param_38));
            second_1 = _e60;
            let _e61 = k_2;
            param_39 = _e61;
            note_seen_u0028_u1_u003b((&param_39));
            let _e62 = (*samples_2);
            param_40 = _e62;
            let _e63 = seen_2;
            param_41 = _e63;
            blend_u0028_struct_u002d_Samples_u002d_vf4_u005b_4_u005d_u002d_b1_u002d_u11_u003b_struct_u002d_Seen_u002d_vf4_u002d_u11_u003b((&param_40), (&param_41));
            let _e64 = param_40;
            (*samples_2) = _e64;
            let _e65 = both;
            let _e67 = (*samples_2).open;
            shows = (_e65 && _e67);
            let _e69 = shows;
            if _e69 {
                let _e70 = l;
                param_42 = _e70;
                note_seen_u0028_u1_u003b((&param_42));
            }
            let _e71 = shows;
            let _e74 = second_1.opacity;
            second_1.opacity = (_e74 * select(0f, 1f, _e71));
            let _e77 = (*samples_2);
            param_43 = _e77;
            let _e78 = second_1;
            param_44 = _e78;
            blend_u0028_struct_u002d_Samples_u002d_vf4_u005b_4_u005d_u002d_b1_u002d_u11_u003b_struct_u002d_Seen_u002d_vf4_u002d_u11_u003b((&param_43), (&param_44));
            let _e79 = param_43;
            (*samples_2) = _e79;
            let _e80 = shows;
            let _e83 = (*samples_2).evaluated;
            (*samples_2).evaluated = (_e83 + select(4u, 8u, _e80));
            continue;
        } else {
            break;
        }
    }
    return;
}

fn place_of_u0028_u1_u003b(index: ptr<function, u32>) -> vec2<u32> {
    var bits: vec2<u32>;

    let _e7 = (*index);
    let _e8 = (*index);
    bits = vec2<u32>(_e7, (_e8 >> bitcast<u32>(1u)));
    let _e12 = bits;
    let _e15 = bits;
    let _e22 = bits;
    let _e29 = bits;
    return ((((_e12 & vec2(1u)) | ((_e15 >> bitcast<vec2<u32>>(vec2(1u))) & vec2(2u))) | ((_e22 >> bitcast<vec2<u32>>(vec2(2u))) & vec2(4u))) | ((_e29 >> bitcast<vec2<u32>>(vec2(3u))) & vec2(8u)));
}

fn hits_of_u0028_u1_u003b_u1_u003b(thread: ptr<function, u32>, word: ptr<function, u32>) -> u32 {
    var place_1: vec2<u32>;
    var param_45: u32;
    var hits_1: u32;
    var k_3: u32;
    var bits_1: u32;

    let _e15 = (*thread);
    param_45 = _e15;
    let _e16 = place_of_u0028_u1_u003b((&param_45));
    place_1 = (_e16 / vec2(2u));
    hits_1 = 0u;
    k_3 = 0u;
    loop {
        let _e19 = k_3;
        if (_e19 < 8u) {
            let _e22 = place_1[1u];
            let _e24 = (*word);
            let _e27 = k_3;
            let _e30 = atomicLoad((&batch_hits[(((_e22 * 64u) + (8u * _e24)) + _e27)]));
            bits_1 = _e30;
            let _e31 = bits_1;
            let _e33 = place_1[0u];
            let _e37 = k_3;
            let _e40 = hits_1;
            hits_1 = (_e40 | (((_e31 >> bitcast<u32>(_e33)) & 16843009u) << bitcast<u32>(_e37)));
            continue;
        } else {
            break;
        }
        continuing {
            let _e42 = k_3;
            k_3 = (_e42 + bitcast<u32>(1i));
        }
    }
    let _e45 = hits_1;
    return _e45;
}

fn intervals_u0028_f1_u003b_f1_u003b_f1_u003b(low: ptr<function, f32>, high: ptr<function, f32>, side: ptr<function, f32>) -> vec2<u32> {
    var first_3: f32;
    var last: f32;
    var local_3: u32;
    var local_4: u32;

    let _e14 = (*low);
    let _e16 = (*side);
    first_3 = (((_e14 + 0.5f) / _e16) - 1f);
    let _e19 = (*high);
    let _e21 = (*side);
    last = ((_e19 - 0.5f) / _e21);
    let _e23 = first_3;
    if (_e23 > 0f) {
        let _e25 = first_3;
        local_3 = u32(ceil(min(_e25, 8f)));
    } else {
        local_3 = 0u;
    }
    let _e29 = local_3;
    let _e30 = last;
    if (_e30 < 8f) {
        let _e32 = last;
        local_4 = u32((floor(max(_e32, -1f)) + 1f));
    } else {
        local_4 = 8u;
    }
    let _e37 = local_4;
    return vec2<u32>(_e29, _e37);
}

fn note_hits_u0028_u1_u003b_struct_u002d_Ellipse_u002d_vf2_u002d_f1_u002d_f1_u002d_f1_u002d_f1_u002d_f11_u003b(k_4: ptr<function, u32>, e: ptr<function, Ellipse>) -> bool {
    var turn: f32;
    var height: f32;
    var rows: vec2<u32>;
    var param_46: f32;
    var param_47: f32;
    var param_48: f32;
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
    var param_49: f32;
    var param_50: f32;
    var param_51: f32;
    var bits_2: u32;
    var phi_514_: bool;

    let _e38 = (*e).b;
    let _e41 = (*e).most;
    let _e43 = (*e).c;
    let _e45 = (*e).determinant;
    turn = (-(_e38) * sqrt((_e41 / (_e43 * _e45))));
    let _e51 = (*e).a;
    let _e53 = (*e).most;
    let _e56 = (*e).determinant;
    height = sqrt(((_e51 * _e53) / _e56));
    let _e61 = (*e).center[1u];
    let _e62 = height;
    let _e66 = (*e).center[1u];
    let _e67 = height;
    param_46 = (_e61 - _e62);
    param_47 = (_e66 + _e67);
    param_48 = 4f;
    let _e69 = intervals_u0028_f1_u003b_f1_u003b_f1_u003b((&param_46), (&param_47), (&param_48));
    rows = _e69;
    let _e70 = (*k_4);
    let _e74 = (*k_4);
    place_2 = (((_e70 >> bitcast<u32>(5u)) * 8u) + (_e74 & 7u));
    meets = false;
    let _e78 = rows[0u];
    row = _e78;
    loop {
        let _e79 = row;
        let _e81 = rows[1u];
        if (_e79 < _e81) {
            let _e83 = row;
            let _e89 = (*e).center[1u];
            top = (((4f * f32(_e83)) + 0.5f) - _e89);
            let _e91 = top;
            bottom = ((_e91 + 4f) - 1f);
            let _e94 = turn;
            let _e96 = top;
            let _e97 = bottom;
            let _e99 = turn;
            let _e100 = top;
            let _e101 = bottom;
            at_1 = vec2<f32>(clamp(-(_e94), _e96, _e97), clamp(_e99, _e100, _e101));
            let _e105 = (*e).a;
            let _e107 = (*e).most;
            let _e110 = (*e).determinant;
            let _e111 = at_1;
            let _e113 = at_1;
            squared = (vec2((_e105 * _e107)) - ((_e111 * _e110) * _e113));
            let _e117 = squared;
            reach = sqrt(max(_e117, vec2(0f)));
            let _e122 = (*e).b;
            let _e124 = at_1;
            let _e127 = reach[0u];
            let _e130 = reach[1u];
            let _e134 = (*e).a;
            let _e139 = (*e).center[0u];
            ends = ((((_e124 * -(_e122)) + vec2<f32>(-(_e127), _e130)) / vec2(_e134)) + vec2(_e139));
            let _e143 = ends[0u];
            param_49 = _e143;
            let _e145 = ends[1u];
            param_50 = _e145;
            param_51 = 4f;
            let _e146 = intervals_u0028_f1_u003b_f1_u003b_f1_u003b((&param_49), (&param_50), (&param_51));
            met = _e146;
            let _e148 = met[0u];
            let _e150 = met[1u];
            let _e151 = (_e148 < _e150);
            phi_514_ = _e151;
            if _e151 {
                let _e153 = squared[0u];
                let _e155 = squared[1u];
                phi_514_ = !((max(_e153, _e155) < 0f));
            }
            let _e160 = phi_514_;
            if _e160 {
                let _e162 = met[1u];
                let _e166 = met[0u];
                bits_2 = ((1u << bitcast<u32>(_e162)) - (1u << bitcast<u32>(_e166)));
                let _e170 = row;
                let _e172 = place_2;
                let _e175 = bits_2;
                let _e176 = (*k_4);
                let _e180 = atomicOr((&batch_hits[((_e170 * 64u) + _e172)]), (_e175 << bitcast<u32>((_e176 & 24u))));
                meets = true;
            }
            continue;
        } else {
            break;
        }
        continuing {
            let _e181 = row;
            row = (_e181 + bitcast<u32>(1i));
        }
    }
    let _e184 = meets;
    return _e184;
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
    var splat: Splat;
    var param_52: vec4<u32>;
    var param_53: vec4<u32>;
    var blue: u32;
    var red: u32;
    var green: u32;

    let _e19 = (*words_2);
    param_52 = _e19;
    let _e20 = fixed_center_u0028_vu4_u003b((&param_52));
    let _e22 = frame.fixed_scale;
    let _e26 = frame.guard;
    let _e29 = (*words_2);
    param_53 = _e29;
    let _e30 = coarseness_of_u0028_vu4_u003b((&param_53));
    splat.center = (((_e20 / vec2(_e22)) - vec2(_e26)) * _e30);
    let _e34 = (*words_2)[2u];
    splat.axis = unpack2x16float(_e34);
    let _e38 = (*words_2)[3u];
    splat.shorter = unpack2x16float(_e38).x;
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
    splat.color = (vec3<f32>(f32(_e63), f32(_e65), f32(_e67)) / vec3(1023f));
    let _e74 = (*words_2)[3u];
    splat.opacity = ((_e74 >> bitcast<u32>(16u)) & 255u);
    let _e79 = splat;
    return _e79;
}

fn load_u0028_u1_u003b_u1_u003b_vu4_u003b_vf2_u003b(thread_1: ptr<function, u32>, i: ptr<function, u32>, packed: ptr<function, vec4<u32>>, corner_1: ptr<function, vec2<f32>>) {
    var splat_1: Splat;
    var param_54: vec4<u32>;
    var inverse: f32;
    var along: vec2<f32>;
    var across: vec2<f32>;
    var exponent_1: f32;
    var ellipse: Ellipse;
    var param_55: u32;
    var param_56: Ellipse;
    var color_1: vec3<u32>;
    var word_1: u32;
    var phi_699_: bool;

    let _e28 = (*packed);
    param_54 = _e28;
    let _e29 = unpack_splat_u0028_vu4_u003b((&param_54));
    splat_1 = _e29;
    let _e31 = splat_1.axis;
    let _e33 = splat_1.axis;
    inverse = (1f / dot(_e31, _e33));
    let _e36 = inverse;
    let _e39 = splat_1.axis;
    along = (_e39 * (0.8493218f * _e36));
    let _e41 = inverse;
    let _e45 = splat_1.shorter;
    let _e49 = splat_1.axis[1u];
    let _e53 = splat_1.axis[0u];
    across = (vec2<f32>(-(_e49), _e53) * ((0.8493218f * sqrt(_e41)) / _e45));
    let _e57 = splat_1.opacity;
    exponent_1 = log2((f32(_e57) / 255f));
    let _e62 = splat_1.center;
    let _e63 = (*corner_1);
    ellipse.center = (_e62 - _e63);
    let _e67 = along[0u];
    let _e69 = along[0u];
    let _e72 = across[0u];
    let _e74 = across[0u];
    ellipse.a = ((_e67 * _e69) + (_e72 * _e74));
    let _e79 = along[0u];
    let _e81 = along[1u];
    let _e84 = across[0u];
    let _e86 = across[1u];
    ellipse.b = ((_e79 * _e81) + (_e84 * _e86));
    let _e91 = along[1u];
    let _e93 = along[1u];
    let _e96 = across[1u];
    let _e98 = across[1u];
    ellipse.c = ((_e91 * _e93) + (_e96 * _e98));
    let _e102 = along;
    let _e103 = along;
    let _e105 = across;
    let _e106 = across;
    ellipse.determinant = (dot(_e102, _e103) * dot(_e105, _e106));
    let _e110 = exponent_1;
    let _e112 = settings.cutoff_exponent;
    ellipse.most = ((_e110 - _e112) + 0.00390625f);
    let _e117 = ellipse.most;
    let _e118 = (_e117 < 0f);
    phi_699_ = _e118;
    if !(_e118) {
        let _e120 = (*thread_1);
        param_55 = _e120;
        let _e121 = ellipse;
        param_56 = _e121;
        let _e122 = note_hits_u0028_u1_u003b_struct_u002d_Ellipse_u002d_vf2_u002d_f1_u002d_f1_u002d_f1_u002d_f1_u002d_f11_u003b((&param_55), (&param_56));
        phi_699_ = !(_e122);
    }
    let _e125 = phi_699_;
    if _e125 {
        return;
    }
    let _e127 = splat_1.color;
    color_1 = vec3<u32>(round((_e127 * 1023f)));
    let _e132 = color_1[0u];
    let _e134 = color_1[1u];
    let _e139 = color_1[2u];
    word_1 = ((_e132 | (_e134 << bitcast<u32>(10u))) | (_e139 << bitcast<u32>(20u)));
    let _e143 = (*thread_1);
    let _e145 = ellipse.center;
    let _e146 = along;
    batch_place[_e143] = vec4<f32>(_e145.x, _e145.y, _e146.x, _e146.y);
    let _e153 = (*thread_1);
    let _e154 = across;
    let _e155 = exponent_1;
    let _e156 = word_1;
    batch_shape[_e153] = vec4<f32>(_e154.x, _e154.y, _e155, bitcast<f32>(_e156));
    return;
}

fn splat_of_u0028_u1_u003b(pair: ptr<function, u32>) -> u32 {
    var local_5: u32;

    let _e6 = (*pair);
    if (_e6 != 4294967295u) {
        let _e9 = settings.pairs_start;
        let _e10 = (*pair);
        let _e14 = unnamed_1.bins[(_e9 + _e10)];
        local_5 = _e14;
    } else {
        local_5 = 0u;
    }
    let _e15 = local_5;
    return _e15;
}

fn pair_at_u0028_u1_u003b_u1_u003b(place_3: ptr<function, u32>, end: ptr<function, u32>) -> u32 {
    var local_6: u32;

    let _e5 = (*place_3);
    let _e6 = (*end);
    if (_e5 < _e6) {
        let _e8 = (*place_3);
        let _e11 = unnamed.sorted[_e8];
        local_6 = _e11;
    } else {
        local_6 = 4294967295u;
    }
    let _e12 = local_6;
    return _e12;
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

fn blend_bin_u0028_struct_u002d_Samples_u002d_vf4_u005b_4_u005d_u002d_b1_u002d_u11_u003b_vu2_u003b_vf2_u003b(samples_3: ptr<function, Samples>, corner_2: ptr<function, vec2<u32>>, first_4: ptr<function, vec2<f32>>) {
    var thread_2: u32;
    var shift_1: u32;
    var at_2: vec2<u32>;
    var bin: u32;
    var param_57: u32;
    var from_2: u32;
    var end_1: u32;
    var i_1: u32;
    var param_58: u32;
    var param_59: u32;
    var param_60: u32;
    var next: u32;
    var param_61: u32;
    var param_62: u32;
    var param_63: u32;
    var pair_1: u32;
    var param_64: u32;
    var param_65: u32;
    var k_5: u32;
    var param_66: u32;
    var param_67: u32;
    var param_68: vec4<u32>;
    var param_69: vec2<f32>;
    var param_70: u32;
    var param_71: u32;
    var param_72: u32;
    var word_2: u32;
    var param_73: u32;
    var param_74: u32;
    var param_75: Samples;
    var param_76: u32;
    var param_77: u32;
    var param_78: vec2<f32>;

    let _e52 = gl_LocalInvocationIndex_1;
    thread_2 = _e52;
    let _e55 = unnamed_1.bins[8i];
    shift_1 = _e55;
    let _e56 = (*corner_2);
    let _e58 = frame.bin_side;
    let _e59 = shift_1;
    at_2 = (_e56 / vec2((_e58 << bitcast<u32>(_e59))));
    let _e65 = at_2[1u];
    let _e66 = shift_1;
    param_57 = _e66;
    let _e67 = bins_of_u0028_u1_u003b((&param_57));
    let _e71 = at_2[0u];
    bin = ((_e65 * _e67.x) + _e71);
    let _e74 = settings.starts_start;
    let _e75 = bin;
    let _e79 = unnamed_1.bins[(_e74 + _e75)];
    from_2 = _e79;
    let _e81 = settings.starts_start;
    let _e82 = bin;
    let _e87 = unnamed_1.bins[((_e81 + _e82) + 1u)];
    end_1 = _e87;
    let _e88 = from_2;
    let _e89 = thread_2;
    param_58 = (_e88 + _e89);
    let _e91 = end_1;
    param_59 = _e91;
    let _e92 = pair_at_u0028_u1_u003b_u1_u003b((&param_58), (&param_59));
    param_60 = _e92;
    let _e93 = splat_of_u0028_u1_u003b((&param_60));
    i_1 = _e93;
    let _e94 = from_2;
    let _e96 = thread_2;
    param_61 = ((_e94 + 256u) + _e96);
    let _e98 = end_1;
    param_62 = _e98;
    let _e99 = pair_at_u0028_u1_u003b_u1_u003b((&param_61), (&param_62));
    param_63 = _e99;
    let _e100 = splat_of_u0028_u1_u003b((&param_63));
    next = _e100;
    let _e101 = from_2;
    let _e103 = thread_2;
    param_64 = ((_e101 + 512u) + _e103);
    let _e105 = end_1;
    param_65 = _e105;
    let _e106 = pair_at_u0028_u1_u003b_u1_u003b((&param_64), (&param_65));
    pair_1 = _e106;
    loop {
        let _e107 = from_2;
        let _e108 = end_1;
        if (_e107 < _e108) {
            let _e110 = thread_2;
            k_5 = _e110;
            loop {
                let _e111 = k_5;
                if (_e111 < 512u) {
                    let _e113 = k_5;
                    atomicStore((&batch_hits[_e113]), 0u);
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e115 = k_5;
                    k_5 = (_e115 + 256u);
                }
            }
            let _e117 = thread_2;
            if (_e117 == 0u) {
                batch_open = 0u;
            }
            workgroupBarrier();
            let _e120 = (*samples_3).open;
            if _e120 {
                batch_open = 1u;
            }
            let _e121 = from_2;
            let _e122 = thread_2;
            let _e124 = end_1;
            if ((_e121 + _e122) < _e124) {
                let _e126 = i_1;
                let _e127 = (*corner_2);
                let _e129 = thread_2;
                param_66 = _e129;
                let _e130 = i_1;
                param_67 = _e130;
                let _e133 = unnamed_2.splats[_e126];
                param_68 = _e133;
                param_69 = vec2<f32>(_e127);
                load_u0028_u1_u003b_u1_u003b_vu4_u003b_vf2_u003b((&param_66), (&param_67), (&param_68), (&param_69));
            }
            let _e134 = next;
            i_1 = _e134;
            let _e135 = pair_1;
            param_70 = _e135;
            let _e136 = splat_of_u0028_u1_u003b((&param_70));
            next = _e136;
            let _e137 = from_2;
            let _e139 = thread_2;
            param_71 = ((_e137 + 768u) + _e139);
            let _e141 = end_1;
            param_72 = _e141;
            let _e142 = pair_at_u0028_u1_u003b_u1_u003b((&param_71), (&param_72));
            pair_1 = _e142;
            workgroupBarrier();
            let _e143 = workgroupUniformLoad((&batch_open));
            if (_e143 == 0u) {
                break;
            }
            word_2 = 0u;
            loop {
                let _e145 = word_2;
                let _e148 = (*samples_3).open;
                if ((_e145 < 8u) && _e148) {
                    let _e150 = thread_2;
                    param_73 = _e150;
                    let _e151 = word_2;
                    param_74 = _e151;
                    let _e152 = hits_of_u0028_u1_u003b_u1_u003b((&param_73), (&param_74));
                    let _e153 = word_2;
                    let _e155 = (*samples_3);
                    param_75 = _e155;
                    param_76 = _e152;
                    param_77 = (32u * _e153);
                    let _e156 = (*first_4);
                    param_78 = _e156;
                    blend_hits_u0028_struct_u002d_Samples_u002d_vf4_u005b_4_u005d_u002d_b1_u002d_u11_u003b_u1_u003b_u1_u003b_vf2_u003b((&param_75), (&param_76), (&param_77), (&param_78));
                    let _e157 = param_75;
                    (*samples_3) = _e157;
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e158 = word_2;
                    word_2 = (_e158 + bitcast<u32>(1i));
                }
            }
            workgroupBarrier();
            continue;
        } else {
            break;
        }
        continuing {
            let _e161 = from_2;
            from_2 = (_e161 + 256u);
        }
    }
    return;
}

fn is_drawn_u0028_vu2_u003b(corner_3: ptr<function, vec2<u32>>) -> bool {
    var at_3: vec2<f32>;
    var phi_295_: bool;
    var phi_296_: bool;

    let _e4 = (*corner_3);
    at_3 = vec2<f32>(_e4);
    let _e7 = frame.area_reach;
    let _e8 = (_e7 < 0f);
    phi_296_ = _e8;
    if !(_e8) {
        let _e10 = at_3;
        let _e12 = frame.area;
        let _e15 = all((_e10 >= _e12.xy));
        phi_295_ = _e15;
        if _e15 {
            let _e16 = at_3;
            let _e18 = frame.area;
            phi_295_ = all((_e16 < _e18.zw));
        }
        let _e23 = phi_295_;
        phi_296_ = _e23;
    }
    let _e25 = phi_296_;
    return _e25;
}

@compute @workgroup_size(256, 1, 1) 
fn main(@builtin(local_invocation_index) gl_LocalInvocationIndex: u32, @builtin(workgroup_id) gl_WorkGroupID: vec3<u32>) {
    var corner: vec2<u32>;
    var first: vec2<u32>;
    var param: u32;
    var drawn: bool;
    var param_1: vec2<u32>;
    var samples: Samples;
    var param_2: Samples;
    var param_3: vec2<u32>;
    var param_4: vec2<f32>;
    var param_5: vec2<u32>;
    var param_6: vec4<f32>;
    var param_7: bool;
    var param_8: vec2<u32>;
    var param_9: vec4<f32>;
    var param_10: bool;
    var param_11: vec2<u32>;
    var param_12: vec4<f32>;
    var param_13: bool;
    var param_14: vec2<u32>;
    var param_15: vec4<f32>;
    var param_16: bool;
    var phi_1395_: bool;

    gl_LocalInvocationIndex_1 = gl_LocalInvocationIndex;
    gl_WorkGroupID_1 = gl_WorkGroupID;
    let _e38 = settings.first_region;
    corner = ((_e38 + bitcast<vec3<u32>>(gl_WorkGroupID).xy) * vec2(32u));
    param = bitcast<u32>(gl_LocalInvocationIndex);
    let _e45 = place_of_u0028_u1_u003b((&param));
    first = (vec2(2u) * _e45);
    let _e48 = corner;
    param_1 = _e48;
    let _e49 = is_drawn_u0028_vu2_u003b((&param_1));
    drawn = _e49;
    let _e50 = drawn;
    samples.open = _e50;
    samples.evaluated = 0u;
    samples.pixels = array<vec4<f32>, 4>(vec4<f32>(0f, 0f, 0f, 1f), vec4<f32>(0f, 0f, 0f, 1f), vec4<f32>(0f, 0f, 0f, 1f), vec4<f32>(0f, 0f, 0f, 1f));
    let _e54 = first;
    let _e58 = samples;
    param_2 = _e58;
    let _e59 = corner;
    param_3 = _e59;
    param_4 = (vec2<f32>(_e54) + vec2(0.5f));
    blend_bin_u0028_struct_u002d_Samples_u002d_vf4_u005b_4_u005d_u002d_b1_u002d_u11_u003b_vu2_u003b_vf2_u003b((&param_2), (&param_3), (&param_4));
    let _e60 = param_2;
    samples = _e60;
    let _e62 = samples.open;
    let _e63 = drawn;
    samples.open = (_e62 || !(_e63));
    let _e67 = corner;
    let _e68 = first;
    first = (_e68 + _e67);
    let _e70 = first;
    param_5 = _e70;
    let _e73 = samples.pixels[0i];
    param_6 = _e73;
    let _e75 = samples.open;
    param_7 = _e75;
    store_u0028_vu2_u003b_vf4_u003b_b1_u003b((&param_5), (&param_6), (&param_7));
    let _e76 = first;
    param_8 = (_e76 + vec2<u32>(1u, 0u));
    let _e80 = samples.pixels[1i];
    param_9 = _e80;
    let _e82 = samples.open;
    param_10 = _e82;
    store_u0028_vu2_u003b_vf4_u003b_b1_u003b((&param_8), (&param_9), (&param_10));
    let _e83 = first;
    param_11 = (_e83 + vec2<u32>(0u, 1u));
    let _e87 = samples.pixels[2i];
    param_12 = _e87;
    let _e89 = samples.open;
    param_13 = _e89;
    store_u0028_vu2_u003b_vf4_u003b_b1_u003b((&param_11), (&param_12), (&param_13));
    let _e90 = first;
    param_14 = (_e90 + vec2<u32>(1u, 1u));
    let _e94 = samples.pixels[3i];
    param_15 = _e94;
    let _e96 = samples.open;
    param_16 = _e96;
    store_u0028_vu2_u003b_vf4_u003b_b1_u003b((&param_14), (&param_15), (&param_16));
    let _e98 = settings.counted;
    let _e99 = (_e98 != 0u);
    phi_1395_ = _e99;
    if _e99 {
        let _e101 = samples.evaluated;
        phi_1395_ = (_e101 > 0u);
    }
    let _e104 = phi_1395_;
    if _e104 {
        let _e108 = samples.evaluated;
        let _e109 = atomicAdd((&unnamed_3.control.fragments), _e108);
    }
    return;
}
