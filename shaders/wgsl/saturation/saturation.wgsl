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

struct Sorted_1 {
    sorted: array<u32, LENGTH_3_4>,
}

struct Bins_1 {
    bins: array<u32, LENGTH_4_4>,
}

struct Marks_1 {
    marks: array<atomic<u32>, LENGTH_6_4>,
}

@group(0) @binding(0) 
var<uniform> frame: FrameBlock;
@group(0) @binding(1) 
var<storage> unnamed: Splats_1;
var<workgroup> batch_hits: array<atomic<u32>, 128>;
@group(0) @binding(7) 
var<uniform> settings: SettingsBlock;
var<workgroup> batch_place: array<vec4<f32>, 64>;
var<workgroup> batch_shape: array<vec4<f32>, 64>;
@group(0) @binding(3) 
var<storage> unnamed_1: Sorted_1;
@group(0) @binding(4) 
var<storage> unnamed_2: Bins_1;
var<workgroup> batch_seen: array<u32, 64>;
var<private> gl_LocalInvocationIndex_1: u32;
var<workgroup> batch_open: u32;
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

fn blend_u0028_struct_u002d_Samples_u002d_f1_u005b_4_u005d_u002d_u1_u005b_4_u005d_u002d_b1_u002d_u11_u003b_struct_u002d_Seen_u002d_vf4_u002d_u11_u003b(samples_1: ptr<function, Samples>, seen: ptr<function, Seen>) {
    var s: u32;
    var light: f32;
    var behind: f32;
    var local: u32;
    var phi_970_: bool;

    s = 0u;
    loop {
        let _e13 = s;
        if (_e13 < 4u) {
            let _e15 = s;
            let _e18 = (*samples_1).light[_e15];
            light = _e18;
            let _e19 = light;
            let _e20 = light;
            let _e21 = s;
            let _e24 = (*seen).opacity[_e21];
            behind = (_e19 - (_e20 * _e24));
            let _e27 = s;
            let _e28 = light;
            let _e30 = settings.saturation;
            let _e31 = (_e28 >= _e30);
            phi_970_ = _e31;
            if _e31 {
                let _e32 = behind;
                let _e34 = settings.saturation;
                phi_970_ = (_e32 < _e34);
            }
            let _e37 = phi_970_;
            if _e37 {
                let _e39 = (*seen).word;
                local = _e39;
            } else {
                let _e40 = s;
                let _e43 = (*samples_1).word[_e40];
                local = _e43;
            }
            let _e44 = local;
            (*samples_1).word[_e27] = _e44;
            let _e47 = s;
            let _e48 = behind;
            (*samples_1).light[_e47] = _e48;
            continue;
        } else {
            break;
        }
        continuing {
            let _e51 = s;
            s = (_e51 + bitcast<u32>(1i));
        }
    }
    let _e56 = (*samples_1).light[0i];
    let _e59 = (*samples_1).light[1i];
    let _e63 = (*samples_1).light[2i];
    let _e66 = (*samples_1).light[3i];
    let _e70 = settings.saturation;
    (*samples_1).open = (max(max(_e56, _e59), max(_e63, _e66)) >= _e70);
    return;
}

fn note_seen_u0028_u1_u003b(k: ptr<function, u32>) {
    let _e3 = (*k);
    batch_seen[_e3] = 1u;
    return;
}

fn opacity_at_u0028_vf2_u003b_f1_u003b_vf2_u003b_vf2_u003b(deviation: ptr<function, vec2<f32>>, exponent: ptr<function, f32>, right: ptr<function, vec2<f32>>, down: ptr<function, vec2<f32>>) -> f32 {
    var power: f32;
    var below: vec2<f32>;
    var above: vec2<f32>;
    var local_1: f32;

    let _e13 = (*exponent);
    let _e14 = (*deviation);
    let _e15 = (*deviation);
    power = (_e13 - dot(_e14, _e15));
    let _e18 = (*right);
    let _e19 = (*down);
    below = ((_e18 + _e19) * 0.5f);
    let _e22 = (*right);
    let _e23 = (*down);
    above = ((_e22 - _e23) * 0.5f);
    let _e26 = (*deviation);
    let _e27 = below;
    let _e31 = below;
    let _e32 = below;
    let _e35 = (*deviation);
    let _e36 = above;
    let _e40 = above;
    let _e41 = above;
    let _e45 = power;
    power = (_e45 - max(((2f * abs(dot(_e26, _e27))) + dot(_e31, _e32)), ((2f * abs(dot(_e35, _e36))) + dot(_e40, _e41))));
    let _e47 = power;
    let _e49 = settings.cutoff_exponent;
    if (_e47 >= _e49) {
        let _e51 = power;
        local_1 = min(0.99f, exp2(_e51));
    } else {
        local_1 = 0f;
    }
    let _e54 = local_1;
    return _e54;
}

fn see_u0028_u1_u003b_vf2_u003b(k_1: ptr<function, u32>, first_1: ptr<function, vec2<f32>>) -> Seen {
    var place: vec4<f32>;
    var shape: vec4<f32>;
    var from_: vec2<f32>;
    var deviation_1: vec2<f32>;
    var right_1: vec2<f32>;
    var down_1: vec2<f32>;
    var second: vec2<f32>;
    var below_1: vec2<f32>;
    var seen_1: Seen;
    var param_12: vec2<f32>;
    var param_13: f32;
    var param_14: vec2<f32>;
    var param_15: vec2<f32>;
    var param_16: vec2<f32>;
    var param_17: f32;
    var param_18: vec2<f32>;
    var param_19: vec2<f32>;
    var param_20: vec2<f32>;
    var param_21: f32;
    var param_22: vec2<f32>;
    var param_23: vec2<f32>;
    var param_24: vec2<f32>;
    var param_25: f32;
    var param_26: vec2<f32>;
    var param_27: vec2<f32>;

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
    second = (_e63 + (_e64 * 2f));
    let _e67 = down_1;
    below_1 = (_e67 * 2f);
    let _e69 = deviation_1;
    param_12 = _e69;
    let _e71 = shape[2u];
    param_13 = _e71;
    let _e72 = right_1;
    param_14 = _e72;
    let _e73 = down_1;
    param_15 = _e73;
    let _e74 = opacity_at_u0028_vf2_u003b_f1_u003b_vf2_u003b_vf2_u003b((&param_12), (&param_13), (&param_14), (&param_15));
    let _e75 = second;
    param_16 = _e75;
    let _e77 = shape[2u];
    param_17 = _e77;
    let _e78 = right_1;
    param_18 = _e78;
    let _e79 = down_1;
    param_19 = _e79;
    let _e80 = opacity_at_u0028_vf2_u003b_f1_u003b_vf2_u003b_vf2_u003b((&param_16), (&param_17), (&param_18), (&param_19));
    let _e81 = deviation_1;
    let _e82 = below_1;
    param_20 = (_e81 + _e82);
    let _e85 = shape[2u];
    param_21 = _e85;
    let _e86 = right_1;
    param_22 = _e86;
    let _e87 = down_1;
    param_23 = _e87;
    let _e88 = opacity_at_u0028_vf2_u003b_f1_u003b_vf2_u003b_vf2_u003b((&param_20), (&param_21), (&param_22), (&param_23));
    let _e89 = second;
    let _e90 = below_1;
    param_24 = (_e89 + _e90);
    let _e93 = shape[2u];
    param_25 = _e93;
    let _e94 = right_1;
    param_26 = _e94;
    let _e95 = down_1;
    param_27 = _e95;
    let _e96 = opacity_at_u0028_vf2_u003b_f1_u003b_vf2_u003b_vf2_u003b((&param_24), (&param_25), (&param_26), (&param_27));
    seen_1.opacity = vec4<f32>(_e74, _e80, _e88, _e96);
    let _e100 = shape[3u];
    seen_1.word = bitcast<u32>(_e100);
    let _e103 = seen_1;
    return _e103;
}

fn blend_hits_u0028_struct_u002d_Samples_u002d_f1_u005b_4_u005d_u002d_u1_u005b_4_u005d_u002d_b1_u002d_u11_u003b_u1_u003b_u1_u003b_vf2_u003b(samples_2: ptr<function, Samples>, hits: ptr<function, u32>, from_1: ptr<function, u32>, first_2: ptr<function, vec2<f32>>) {
    var k_2: u32;
    var both: bool;
    var l: u32;
    var local_2: u32;
    var seen_2: Seen;
    var param_28: u32;
    var param_29: vec2<f32>;
    var second_1: Seen;
    var param_30: u32;
    var param_31: vec2<f32>;
    var param_32: u32;
    var param_33: Samples;
    var param_34: Seen;
    var shows: bool;
    var param_35: u32;
    var param_36: Samples;
    var param_37: Seen;

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
            param_28 = _e55;
            let _e56 = (*first_2);
            param_29 = _e56;
            let _e57 = see_u0028_u1_u003b_vf2_u003b((&param_28), (&param_29));
            seen_2 = _e57;
            let _e58 = l;
            param_30 = _e58;
            let _e59 = (*first_2);
            param_31 = _e59;
            let _e60 = see_u0028_u1_u003b_vf2_u003b((&param_30), (&param_31));
            second_1 = _e60;
            let _e61 = k_2;
            param_32 = _e61;
            note_seen_u0028_u1_u003b((&param_32));
            let _e62 = (*samples_2);
            param_33 = _e62;
            let _e63 = seen_2;
            param_34 = _e63;
            blend_u0028_struct_u002d_Samples_u002d_f1_u005b_4_u005d_u002d_u1_u005b_4_u005d_u002d_b1_u002d_u11_u003b_struct_u002d_Seen_u002d_vf4_u002d_u11_u003b((&param_33), (&param_34));
            let _e64 = param_33;
            (*samples_2) = _e64;
            let _e65 = both;
            let _e67 = (*samples_2).open;
            shows = (_e65 && _e67);
            let _e69 = shows;
            if _e69 {
                let _e70 = l;
                param_35 = _e70;
                note_seen_u0028_u1_u003b((&param_35));
            }
            let _e71 = shows;
            let _e74 = second_1.opacity;
            second_1.opacity = (_e74 * select(0f, 1f, _e71));
            let _e77 = (*samples_2);
            param_36 = _e77;
            let _e78 = second_1;
            param_37 = _e78;
            blend_u0028_struct_u002d_Samples_u002d_f1_u005b_4_u005d_u002d_u1_u005b_4_u005d_u002d_b1_u002d_u11_u003b_struct_u002d_Seen_u002d_vf4_u002d_u11_u003b((&param_36), (&param_37));
            let _e79 = param_36;
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

fn hits_of_u0028_u1_u003b_u1_u003b(thread: ptr<function, u32>, word_1: ptr<function, u32>) -> u32 {
    var place_1: vec2<u32>;
    var param_38: u32;
    var hits_1: u32;
    var k_3: u32;
    var bits_1: u32;

    let _e14 = (*thread);
    param_38 = _e14;
    let _e15 = place_of_u0028_u1_u003b((&param_38));
    place_1 = (_e15 / vec2(1u));
    hits_1 = 0u;
    k_3 = 0u;
    loop {
        let _e18 = k_3;
        if (_e18 < 8u) {
            let _e21 = place_1[1u];
            let _e23 = (*word_1);
            let _e26 = k_3;
            let _e29 = atomicLoad((&batch_hits[(((_e21 * 16u) + (8u * _e23)) + _e26)]));
            bits_1 = _e29;
            let _e30 = bits_1;
            let _e32 = place_1[0u];
            let _e36 = k_3;
            let _e39 = hits_1;
            hits_1 = (_e39 | (((_e30 >> bitcast<u32>(_e32)) & 16843009u) << bitcast<u32>(_e36)));
            continue;
        } else {
            break;
        }
        continuing {
            let _e41 = k_3;
            k_3 = (_e41 + bitcast<u32>(1i));
        }
    }
    let _e44 = hits_1;
    return _e44;
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
    var word_2: u32;
    var local_3: u32;
    var keys: u32;
    var local_4: u32;

    let _e14 = frame.key_start;
    let _e16 = frame.half_keys;
    if (_e16 != 0u) {
        let _e18 = (*i);
        local_3 = (_e18 >> bitcast<u32>(1u));
    } else {
        let _e21 = (*i);
        local_3 = _e21;
    }
    let _e22 = local_3;
    word_2 = (_e14 + _e22);
    let _e24 = word_2;
    let _e27 = word_2;
    let _e32 = unnamed.splats[(_e24 >> bitcast<u32>(2u))][(_e27 & 3u)];
    keys = _e32;
    let _e34 = frame.half_keys;
    if (_e34 != 0u) {
        let _e36 = keys;
        let _e37 = (*i);
        local_4 = ((_e36 >> bitcast<u32>((16u * (_e37 & 1u)))) & 65535u);
    } else {
        let _e43 = keys;
        local_4 = _e43;
    }
    let _e44 = local_4;
    return _e44;
}

fn intervals_u0028_f1_u003b_f1_u003b_f1_u003b(low: ptr<function, f32>, high: ptr<function, f32>, side: ptr<function, f32>) -> vec2<u32> {
    var first_3: f32;
    var last: f32;
    var local_5: u32;
    var local_6: u32;

    let _e14 = (*low);
    let _e16 = (*side);
    first_3 = (((_e14 + 0.5f) / _e16) - 1f);
    let _e19 = (*high);
    let _e21 = (*side);
    last = ((_e19 - 0.5f) / _e21);
    let _e23 = first_3;
    if (_e23 > 0f) {
        let _e25 = first_3;
        local_5 = u32(ceil(min(_e25, 8f)));
    } else {
        local_5 = 0u;
    }
    let _e29 = local_5;
    let _e30 = last;
    if (_e30 < 8f) {
        let _e32 = last;
        local_6 = u32((floor(max(_e32, -1f)) + 1f));
    } else {
        local_6 = 8u;
    }
    let _e37 = local_6;
    return vec2<u32>(_e29, _e37);
}

fn note_hits_u0028_u1_u003b_struct_u002d_Ellipse_u002d_vf2_u002d_f1_u002d_f1_u002d_f1_u002d_f1_u002d_f11_u003b(k_4: ptr<function, u32>, e: ptr<function, Ellipse>) -> bool {
    var turn: f32;
    var height: f32;
    var rows: vec2<u32>;
    var param_39: f32;
    var param_40: f32;
    var param_41: f32;
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
    var param_42: f32;
    var param_43: f32;
    var param_44: f32;
    var bits_2: u32;
    var phi_560_: bool;

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
    param_39 = (_e61 - _e62);
    param_40 = (_e66 + _e67);
    param_41 = 4f;
    let _e69 = intervals_u0028_f1_u003b_f1_u003b_f1_u003b((&param_39), (&param_40), (&param_41));
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
            param_42 = _e143;
            let _e145 = ends[1u];
            param_43 = _e145;
            param_44 = 4f;
            let _e146 = intervals_u0028_f1_u003b_f1_u003b_f1_u003b((&param_42), (&param_43), (&param_44));
            met = _e146;
            let _e148 = met[0u];
            let _e150 = met[1u];
            let _e151 = (_e148 < _e150);
            phi_560_ = _e151;
            if _e151 {
                let _e153 = squared[0u];
                let _e155 = squared[1u];
                phi_560_ = !((max(_e153, _e155) < 0f));
            }
            let _e160 = phi_560_;
            if _e160 {
                let _e162 = met[1u];
                let _e166 = met[0u];
                bits_2 = ((1u << bitcast<u32>(_e162)) - (1u << bitcast<u32>(_e166)));
                let _e170 = row;
                let _e172 = place_2;
                let _e175 = bits_2;
                let _e176 = (*k_4);
                let _e180 = atomicOr((&batch_hits[((_e170 * 16u) + _e172)]), (_e175 << bitcast<u32>((_e176 & 24u))));
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
    var param_45: vec4<u32>;
    var param_46: vec4<u32>;
    var blue: u32;
    var red: u32;
    var green: u32;

    let _e19 = (*words_2);
    param_45 = _e19;
    let _e20 = fixed_center_u0028_vu4_u003b((&param_45));
    let _e22 = frame.fixed_scale;
    let _e26 = frame.guard;
    let _e29 = (*words_2);
    param_46 = _e29;
    let _e30 = coarseness_of_u0028_vu4_u003b((&param_46));
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

fn load_u0028_u1_u003b_u1_u003b_vu4_u003b_vf2_u003b(thread_1: ptr<function, u32>, i_1: ptr<function, u32>, packed: ptr<function, vec4<u32>>, corner: ptr<function, vec2<f32>>) {
    var splat_1: Splat;
    var param_47: vec4<u32>;
    var inverse: f32;
    var along: vec2<f32>;
    var across: vec2<f32>;
    var exponent_1: f32;
    var ellipse: Ellipse;
    var param_48: u32;
    var param_49: Ellipse;
    var word_3: u32;
    var param_50: u32;
    var param_51: f32;
    var param_52: vec3<f32>;
    var phi_743_: bool;

    let _e28 = (*packed);
    param_47 = _e28;
    let _e29 = unpack_splat_u0028_vu4_u003b((&param_47));
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
    let _e63 = (*corner);
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
    phi_743_ = _e118;
    if !(_e118) {
        let _e120 = (*thread_1);
        param_48 = _e120;
        let _e121 = ellipse;
        param_49 = _e121;
        let _e122 = note_hits_u0028_u1_u003b_struct_u002d_Ellipse_u002d_vf2_u002d_f1_u002d_f1_u002d_f1_u002d_f1_u002d_f11_u003b((&param_48), (&param_49));
        phi_743_ = !(_e122);
    }
    let _e125 = phi_743_;
    if _e125 {
        return;
    }
    let _e126 = (*i_1);
    param_50 = _e126;
    let _e127 = key_at_u0028_u1_u003b((&param_50));
    let _e130 = frame.key_max;
    param_51 = (1f - (f32(_e127) / f32(_e130)));
    let _e135 = splat_1.color;
    param_52 = _e135;
    let _e136 = saturated_word_u0028_f1_u003b_vf3_u003b((&param_51), (&param_52));
    word_3 = _e136;
    let _e137 = (*thread_1);
    let _e139 = ellipse.center;
    let _e140 = along;
    batch_place[_e137] = vec4<f32>(_e139.x, _e139.y, _e140.x, _e140.y);
    let _e147 = (*thread_1);
    let _e148 = across;
    let _e149 = exponent_1;
    let _e150 = word_3;
    batch_shape[_e147] = vec4<f32>(_e148.x, _e148.y, _e149, bitcast<f32>(_e150));
    return;
}

fn splat_of_u0028_u1_u003b(pair: ptr<function, u32>) -> u32 {
    var local_7: u32;

    let _e6 = (*pair);
    if (_e6 != 4294967295u) {
        let _e9 = settings.pairs_start;
        let _e10 = (*pair);
        let _e14 = unnamed_2.bins[(_e9 + _e10)];
        local_7 = _e14;
    } else {
        local_7 = 0u;
    }
    let _e15 = local_7;
    return _e15;
}

fn pair_at_u0028_u1_u003b_u1_u003b(place_3: ptr<function, u32>, end: ptr<function, u32>) -> u32 {
    var local_8: u32;

    let _e5 = (*place_3);
    let _e6 = (*end);
    if (_e5 < _e6) {
        let _e8 = (*place_3);
        let _e11 = unnamed_1.sorted[_e8];
        local_8 = _e11;
    } else {
        local_8 = 4294967295u;
    }
    let _e12 = local_8;
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

fn blend_bin_u0028_struct_u002d_Samples_u002d_f1_u005b_4_u005d_u002d_u1_u005b_4_u005d_u002d_b1_u002d_u11_u003b_vu2_u003b_vf2_u003b(samples_3: ptr<function, Samples>, corner_1: ptr<function, vec2<u32>>, first_4: ptr<function, vec2<f32>>) {
    var thread_2: u32;
    var shift_1: u32;
    var at_2: vec2<u32>;
    var bin: u32;
    var param_53: u32;
    var from_2: u32;
    var end_1: u32;
    var i_2: u32;
    var param_54: u32;
    var param_55: u32;
    var param_56: u32;
    var next: u32;
    var param_57: u32;
    var param_58: u32;
    var param_59: u32;
    var pair_1: u32;
    var param_60: u32;
    var param_61: u32;
    var k_5: u32;
    var param_62: u32;
    var param_63: u32;
    var param_64: vec4<u32>;
    var param_65: vec2<f32>;
    var own: u32;
    var param_66: u32;
    var param_67: u32;
    var param_68: u32;
    var word_4: u32;
    var param_69: u32;
    var param_70: u32;
    var param_71: Samples;
    var param_72: u32;
    var param_73: u32;
    var param_74: vec2<f32>;

    let _e57 = gl_LocalInvocationIndex_1;
    thread_2 = _e57;
    let _e60 = unnamed_2.bins[8i];
    shift_1 = _e60;
    let _e61 = (*corner_1);
    let _e63 = frame.bin_side;
    let _e64 = shift_1;
    at_2 = (_e61 / vec2((_e63 << bitcast<u32>(_e64))));
    let _e70 = at_2[1u];
    let _e71 = shift_1;
    param_53 = _e71;
    let _e72 = bins_of_u0028_u1_u003b((&param_53));
    let _e76 = at_2[0u];
    bin = ((_e70 * _e72.x) + _e76);
    let _e79 = settings.starts_start;
    let _e80 = bin;
    let _e84 = unnamed_2.bins[(_e79 + _e80)];
    from_2 = _e84;
    let _e86 = settings.starts_start;
    let _e87 = bin;
    let _e92 = unnamed_2.bins[((_e86 + _e87) + 1u)];
    end_1 = _e92;
    let _e93 = from_2;
    let _e94 = thread_2;
    param_54 = (_e93 + _e94);
    let _e96 = end_1;
    param_55 = _e96;
    let _e97 = pair_at_u0028_u1_u003b_u1_u003b((&param_54), (&param_55));
    param_56 = _e97;
    let _e98 = splat_of_u0028_u1_u003b((&param_56));
    i_2 = _e98;
    let _e99 = from_2;
    let _e101 = thread_2;
    param_57 = ((_e99 + 64u) + _e101);
    let _e103 = end_1;
    param_58 = _e103;
    let _e104 = pair_at_u0028_u1_u003b_u1_u003b((&param_57), (&param_58));
    param_59 = _e104;
    let _e105 = splat_of_u0028_u1_u003b((&param_59));
    next = _e105;
    let _e106 = from_2;
    let _e108 = thread_2;
    param_60 = ((_e106 + 128u) + _e108);
    let _e110 = end_1;
    param_61 = _e110;
    let _e111 = pair_at_u0028_u1_u003b_u1_u003b((&param_60), (&param_61));
    pair_1 = _e111;
    loop {
        let _e112 = from_2;
        let _e113 = end_1;
        if (_e112 < _e113) {
            let _e115 = thread_2;
            batch_seen[_e115] = 0u;
            let _e117 = thread_2;
            k_5 = _e117;
            loop {
                let _e118 = k_5;
                if (_e118 < 128u) {
                    let _e120 = k_5;
                    atomicStore((&batch_hits[_e120]), 0u);
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e122 = k_5;
                    k_5 = (_e122 + 64u);
                }
            }
            let _e124 = thread_2;
            if (_e124 == 0u) {
                batch_open = 0u;
            }
            workgroupBarrier();
            let _e127 = (*samples_3).open;
            if _e127 {
                batch_open = 1u;
            }
            let _e128 = from_2;
            let _e129 = thread_2;
            let _e131 = end_1;
            if ((_e128 + _e129) < _e131) {
                let _e133 = i_2;
                let _e134 = (*corner_1);
                let _e136 = thread_2;
                param_62 = _e136;
                let _e137 = i_2;
                param_63 = _e137;
                let _e140 = unnamed.splats[_e133];
                param_64 = _e140;
                param_65 = vec2<f32>(_e134);
                load_u0028_u1_u003b_u1_u003b_vu4_u003b_vf2_u003b((&param_62), (&param_63), (&param_64), (&param_65));
            }
            let _e141 = i_2;
            own = _e141;
            let _e142 = next;
            i_2 = _e142;
            let _e143 = pair_1;
            param_66 = _e143;
            let _e144 = splat_of_u0028_u1_u003b((&param_66));
            next = _e144;
            let _e145 = from_2;
            let _e147 = thread_2;
            param_67 = ((_e145 + 192u) + _e147);
            let _e149 = end_1;
            param_68 = _e149;
            let _e150 = pair_at_u0028_u1_u003b_u1_u003b((&param_67), (&param_68));
            pair_1 = _e150;
            workgroupBarrier();
            let _e151 = workgroupUniformLoad((&batch_open));
            if (_e151 == 0u) {
                break;
            }
            word_4 = 0u;
            loop {
                let _e153 = word_4;
                let _e156 = (*samples_3).open;
                if ((_e153 < 2u) && _e156) {
                    let _e158 = thread_2;
                    param_69 = _e158;
                    let _e159 = word_4;
                    param_70 = _e159;
                    let _e160 = hits_of_u0028_u1_u003b_u1_u003b((&param_69), (&param_70));
                    let _e161 = word_4;
                    let _e163 = (*samples_3);
                    param_71 = _e163;
                    param_72 = _e160;
                    param_73 = (32u * _e161);
                    let _e164 = (*first_4);
                    param_74 = _e164;
                    blend_hits_u0028_struct_u002d_Samples_u002d_f1_u005b_4_u005d_u002d_u1_u005b_4_u005d_u002d_b1_u002d_u11_u003b_u1_u003b_u1_u003b_vf2_u003b((&param_71), (&param_72), (&param_73), (&param_74));
                    let _e165 = param_71;
                    (*samples_3) = _e165;
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e166 = word_4;
                    word_4 = (_e166 + bitcast<u32>(1i));
                }
            }
            workgroupBarrier();
            let _e169 = thread_2;
            let _e171 = batch_seen[_e169];
            if (_e171 != 0u) {
                let _e173 = own;
                let _e178 = own;
                let _e182 = atomicOr((&unnamed_3.marks[(_e173 >> bitcast<u32>(5u))]), (1u << bitcast<u32>((_e178 & 31u))));
            }
            continue;
        } else {
            break;
        }
        continuing {
            let _e183 = from_2;
            from_2 = (_e183 + 64u);
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
    var phi_1430_: bool;

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
    phi_1430_ = _e84;
    if _e84 {
        let _e86 = samples.evaluated;
        phi_1430_ = (_e86 > 0u);
    }
    let _e89 = phi_1430_;
    if _e89 {
        let _e93 = samples.evaluated;
        let _e94 = atomicAdd((&unnamed_4.control.fragments), _e93);
    }
    return;
}
