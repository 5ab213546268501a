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
    blocks: u32,
    counted: u32,
    first_region: vec2<u32>,
    counts_start: u32,
    starts_start: u32,
    pairs_start: u32,
    pair_capacity: u32,
    bin_margin: f32,
}

struct Splats {
    splats: array<vec4<u32>>,
}

struct Bins {
    bins: array<u32>,
}

struct Sorted {
    sorted: array<u32>,
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

@group(0) @binding(0) 
var<uniform> frame: FrameBlock;
@group(0) @binding(7) 
var<uniform> settings: SettingsBlock;
var<workgroup> batch_hits: array<atomic<u32>, 8>;
@group(0) @binding(1) 
var<storage> unnamed: Splats_1;
var<workgroup> batch_place: array<vec4<f32>, 64>;
var<workgroup> batch_shape: array<vec4<f32>, 64>;
var<private> gl_LocalInvocationIndex_1: u32;
@group(0) @binding(4) 
var<storage> unnamed_1: Bins_1;
var<workgroup> batch_open: u32;
@group(0) @binding(3) 
var<storage> unnamed_2: Sorted_1;
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

fn opacity_at_u0028_vf2_u003b_f1_u003b(deviation: ptr<function, vec2<f32>>, exponent: ptr<function, f32>) -> f32 {
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

fn blend_pixel_u0028_vf4_u003b_vf2_u003b_f1_u003b_vf3_u003b(pixel_2: ptr<function, vec4<f32>>, deviation_1: ptr<function, vec2<f32>>, exponent_1: ptr<function, f32>, color: ptr<function, vec3<f32>>) {
    var share: f32;
    var param_19: vec2<f32>;
    var param_20: f32;

    let _e8 = (*deviation_1);
    param_19 = _e8;
    let _e9 = (*exponent_1);
    param_20 = _e9;
    let _e10 = opacity_at_u0028_vf2_u003b_f1_u003b((&param_19), (&param_20));
    let _e12 = (*pixel_2)[3u];
    share = (_e10 * _e12);
    let _e14 = (*pixel_2);
    let _e16 = share;
    let _e17 = (*color);
    let _e19 = (_e14.xyz + (_e17 * _e16));
    let _e21 = (*pixel_2)[3u];
    let _e22 = share;
    (*pixel_2) = vec4<f32>(_e19.x, _e19.y, _e19.z, (_e21 - _e22));
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
    seen.right = (vec2<f32>(_e34, _e36) * 1f);
    let _e41 = place[3u];
    let _e43 = shape[1u];
    seen.down = (vec2<f32>(_e41, _e43) * 1f);
    let _e48 = shape[2u];
    seen.exponent = _e48;
    let _e51 = shape[3u];
    seen.word = bitcast<u32>(_e51);
    let _e54 = seen;
    return _e54;
}

fn blend_u0028_struct_u002d_Samples_u002d_vf4_u005b_4_u005d_u002d_b1_u002d_u11_u003b_u1_u003b_vf2_u003b(samples_1: ptr<function, Samples>, k_1: ptr<function, u32>, first_2: ptr<function, vec2<f32>>) {
    var seen_1: Seen;
    var param_21: u32;
    var param_22: vec2<f32>;
    var color_1: vec3<f32>;
    var right: vec2<f32>;
    var param_23: vec4<f32>;
    var param_24: vec2<f32>;
    var param_25: f32;
    var param_26: vec3<f32>;
    var param_27: vec4<f32>;
    var param_28: vec2<f32>;
    var param_29: f32;
    var param_30: vec3<f32>;
    var param_31: vec4<f32>;
    var param_32: vec2<f32>;
    var param_33: f32;
    var param_34: vec3<f32>;
    var param_35: vec4<f32>;
    var param_36: vec2<f32>;
    var param_37: f32;
    var param_38: vec3<f32>;

    let _e34 = (*k_1);
    param_21 = _e34;
    let _e35 = (*first_2);
    param_22 = _e35;
    let _e36 = see_u0028_u1_u003b_vf2_u003b((&param_21), (&param_22));
    seen_1 = _e36;
    let _e38 = seen_1.word;
    let _e42 = seen_1.word;
    let _e48 = seen_1.word;
    color_1 = vec3<f32>(f32((_e38 & 1023u)), f32(((_e42 >> bitcast<u32>(10u)) & 1023u)), f32((_e48 >> bitcast<u32>(20u))));
    let _e54 = seen_1.deviation;
    let _e56 = seen_1.right;
    right = (_e54 + _e56);
    let _e60 = (*samples_1).pixels[0i];
    param_23 = _e60;
    let _e62 = seen_1.deviation;
    param_24 = _e62;
    let _e64 = seen_1.exponent;
    param_25 = _e64;
    let _e65 = color_1;
    param_26 = _e65;
    blend_pixel_u0028_vf4_u003b_vf2_u003b_f1_u003b_vf3_u003b((&param_23), (&param_24), (&param_25), (&param_26));
    let _e66 = param_23;
    (*samples_1).pixels[0i] = _e66;
    let _e71 = (*samples_1).pixels[1i];
    param_27 = _e71;
    let _e72 = right;
    param_28 = _e72;
    let _e74 = seen_1.exponent;
    param_29 = _e74;
    let _e75 = color_1;
    param_30 = _e75;
    blend_pixel_u0028_vf4_u003b_vf2_u003b_f1_u003b_vf3_u003b((&param_27), (&param_28), (&param_29), (&param_30));
    let _e76 = param_27;
    (*samples_1).pixels[1i] = _e76;
    let _e80 = seen_1.deviation;
    let _e82 = seen_1.down;
    let _e86 = (*samples_1).pixels[2i];
    param_31 = _e86;
    param_32 = (_e80 + _e82);
    let _e88 = seen_1.exponent;
    param_33 = _e88;
    let _e89 = color_1;
    param_34 = _e89;
    blend_pixel_u0028_vf4_u003b_vf2_u003b_f1_u003b_vf3_u003b((&param_31), (&param_32), (&param_33), (&param_34));
    let _e90 = param_31;
    (*samples_1).pixels[2i] = _e90;
    let _e93 = right;
    let _e95 = seen_1.down;
    let _e99 = (*samples_1).pixels[3i];
    param_35 = _e99;
    param_36 = (_e93 + _e95);
    let _e101 = seen_1.exponent;
    param_37 = _e101;
    let _e102 = color_1;
    param_38 = _e102;
    blend_pixel_u0028_vf4_u003b_vf2_u003b_f1_u003b_vf3_u003b((&param_35), (&param_36), (&param_37), (&param_38));
    let _e103 = param_35;
    (*samples_1).pixels[3i] = _e103;
    let _e109 = (*samples_1).pixels[0i][3u];
    let _e113 = (*samples_1).pixels[1i][3u];
    let _e118 = (*samples_1).pixels[2i][3u];
    let _e122 = (*samples_1).pixels[3i][3u];
    let _e126 = settings.saturation;
    (*samples_1).open = (max(max(_e109, _e113), max(_e118, _e122)) >= _e126);
    let _e130 = (*samples_1).evaluated;
    (*samples_1).evaluated = (_e130 + 4u);
    return;
}

fn hits_of_u0028_u1_u003b_u1_u003b(thread: ptr<function, u32>, word: ptr<function, u32>) -> u32 {
    var quarter: u32;

    let _e6 = (*thread);
    quarter = (_e6 / 16u);
    let _e8 = quarter;
    let _e10 = (*word);
    let _e13 = atomicLoad((&batch_hits[((_e8 * 2u) + _e10)]));
    return _e13;
}

fn nearest_u0028_struct_u002d_Ellipse_u002d_vf2_u002d_f1_u002d_f1_u002d_f1_u002d_f1_u002d_f11_u003b_vf2_u003b_vf2_u003b(e: ptr<function, Ellipse>, low: ptr<function, vec2<f32>>, high: ptr<function, vec2<f32>>) -> f32 {
    var side: vec2<f32>;
    var p: vec2<f32>;
    var q: vec2<f32>;

    let _e10 = (*low);
    let _e11 = (*high);
    side = clamp(vec2<f32>(0f, 0f), _e10, _e11);
    let _e14 = side[0u];
    let _e16 = (*e).b;
    let _e19 = side[0u];
    let _e22 = (*e).c;
    let _e25 = (*low)[1u];
    let _e27 = (*high)[1u];
    p = vec2<f32>(_e14, clamp(((-(_e16) * _e19) / _e22), _e25, _e27));
    let _e31 = (*e).b;
    let _e34 = side[1u];
    let _e37 = (*e).a;
    let _e40 = (*low)[0u];
    let _e42 = (*high)[0u];
    let _e45 = side[1u];
    q = vec2<f32>(clamp(((-(_e31) * _e34) / _e37), _e40, _e42), _e45);
    let _e48 = (*e).a;
    let _e50 = p[0u];
    let _e53 = p[0u];
    let _e56 = (*e).b;
    let _e59 = p[0u];
    let _e62 = p[1u];
    let _e66 = (*e).c;
    let _e68 = p[1u];
    let _e71 = p[1u];
    let _e75 = (*e).a;
    let _e77 = q[0u];
    let _e80 = q[0u];
    let _e83 = (*e).b;
    let _e86 = q[0u];
    let _e89 = q[1u];
    let _e93 = (*e).c;
    let _e95 = q[1u];
    let _e98 = q[1u];
    return min(((((_e48 * _e50) * _e53) + (((2f * _e56) * _e59) * _e62)) + ((_e66 * _e68) * _e71)), ((((_e75 * _e77) * _e80) + (((2f * _e83) * _e86) * _e89)) + ((_e93 * _e95) * _e98)));
}

fn note_hits_u0028_u1_u003b_struct_u002d_Ellipse_u002d_vf2_u002d_f1_u002d_f1_u002d_f1_u002d_f1_u002d_f11_u003b(k_2: ptr<function, u32>, e_1: ptr<function, Ellipse>) -> bool {
    var meets: bool;
    var quarter_1: u32;
    var low_1: vec2<f32>;
    var high_1: vec2<f32>;
    var param_39: Ellipse;
    var param_40: vec2<f32>;
    var param_41: vec2<f32>;

    meets = false;
    quarter_1 = 0u;
    loop {
        let _e22 = quarter_1;
        if (_e22 < 4u) {
            let _e24 = quarter_1;
            let _e27 = quarter_1;
            let _e34 = (*e_1).center;
            low_1 = ((vec2<f32>(f32((_e24 & 1u)), f32((_e27 >> bitcast<u32>(1u)))) * 8f) - _e34);
            let _e36 = low_1;
            high_1 = (_e36 + vec2(8f));
            let _e39 = low_1;
            let _e43 = settings.bin_margin;
            let _e46 = high_1;
            let _e50 = settings.bin_margin;
            let _e53 = (*e_1);
            param_39 = _e53;
            param_40 = ((_e39 + vec2(0.5f)) - vec2(_e43));
            param_41 = ((_e46 - vec2(0.5f)) + vec2(_e50));
            let _e54 = nearest_u0028_struct_u002d_Ellipse_u002d_vf2_u002d_f1_u002d_f1_u002d_f1_u002d_f1_u002d_f11_u003b_vf2_u003b_vf2_u003b((&param_39), (&param_40), (&param_41));
            let _e56 = (*e_1).most;
            if !((_e54 > _e56)) {
                let _e59 = quarter_1;
                let _e61 = (*k_2);
                let _e66 = (*k_2);
                let _e70 = atomicOr((&batch_hits[((_e59 * 2u) + (_e61 >> bitcast<u32>(5u)))]), (1u << bitcast<u32>((_e66 & 31u))));
                meets = true;
            }
            continue;
        } else {
            break;
        }
        continuing {
            let _e71 = quarter_1;
            quarter_1 = (_e71 + bitcast<u32>(1i));
        }
    }
    let _e74 = meets;
    return _e74;
}

fn fixed_center_u0028_vu4_u003b(words: ptr<function, vec4<u32>>) -> vec2<f32> {
    let _e2 = (*words);
    return vec2<f32>((_e2.xy & vec2(1048575u)));
}

fn unpack_splat_u0028_vu4_u003b(words_1: ptr<function, vec4<u32>>) -> Splat {
    var splat: Splat;
    var param_42: vec4<u32>;
    var blue: u32;
    var red: u32;
    var green: u32;

    let _e18 = (*words_1);
    param_42 = _e18;
    let _e19 = fixed_center_u0028_vu4_u003b((&param_42));
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

fn load_u0028_u1_u003b_u1_u003b_vf2_u003b(thread_1: ptr<function, u32>, i: ptr<function, u32>, corner_1: ptr<function, vec2<f32>>) {
    var splat_1: Splat;
    var param_43: vec4<u32>;
    var inverse: f32;
    var along: vec2<f32>;
    var across: vec2<f32>;
    var exponent_2: f32;
    var ellipse: Ellipse;
    var param_44: u32;
    var param_45: Ellipse;
    var color_2: vec3<u32>;
    var word_1: u32;
    var phi_594_: bool;

    let _e29 = (*i);
    let _e32 = unnamed.splats[_e29];
    param_43 = _e32;
    let _e33 = unpack_splat_u0028_vu4_u003b((&param_43));
    splat_1 = _e33;
    let _e35 = splat_1.axis;
    let _e37 = splat_1.axis;
    inverse = (1f / dot(_e35, _e37));
    let _e40 = inverse;
    let _e43 = splat_1.axis;
    along = (_e43 * (0.8493218f * _e40));
    let _e45 = inverse;
    let _e49 = splat_1.shorter;
    let _e53 = splat_1.axis[1u];
    let _e57 = splat_1.axis[0u];
    across = (vec2<f32>(-(_e53), _e57) * ((0.8493218f * sqrt(_e45)) / _e49));
    let _e61 = splat_1.opacity;
    exponent_2 = log2((f32(_e61) / 255f));
    let _e66 = splat_1.center;
    let _e67 = (*corner_1);
    ellipse.center = (_e66 - _e67);
    let _e71 = along[0u];
    let _e73 = along[0u];
    let _e76 = across[0u];
    let _e78 = across[0u];
    ellipse.a = ((_e71 * _e73) + (_e76 * _e78));
    let _e83 = along[0u];
    let _e85 = along[1u];
    let _e88 = across[0u];
    let _e90 = across[1u];
    ellipse.b = ((_e83 * _e85) + (_e88 * _e90));
    let _e95 = along[1u];
    let _e97 = along[1u];
    let _e100 = across[1u];
    let _e102 = across[1u];
    ellipse.c = ((_e95 * _e97) + (_e100 * _e102));
    let _e106 = along;
    let _e107 = along;
    let _e109 = across;
    let _e110 = across;
    ellipse.determinant = (dot(_e106, _e107) * dot(_e109, _e110));
    let _e114 = exponent_2;
    let _e116 = settings.cutoff_exponent;
    ellipse.most = ((_e114 - _e116) + 0.00390625f);
    let _e121 = ellipse.most;
    let _e122 = (_e121 < 0f);
    phi_594_ = _e122;
    if !(_e122) {
        let _e124 = (*thread_1);
        param_44 = _e124;
        let _e125 = ellipse;
        param_45 = _e125;
        let _e126 = note_hits_u0028_u1_u003b_struct_u002d_Ellipse_u002d_vf2_u002d_f1_u002d_f1_u002d_f1_u002d_f1_u002d_f11_u003b((&param_44), (&param_45));
        phi_594_ = !(_e126);
    }
    let _e129 = phi_594_;
    if _e129 {
        return;
    }
    let _e131 = splat_1.color;
    color_2 = vec3<u32>(round((_e131 * 1023f)));
    let _e136 = color_2[0u];
    let _e138 = color_2[1u];
    let _e143 = color_2[2u];
    word_1 = ((_e136 | (_e138 << bitcast<u32>(10u))) | (_e143 << bitcast<u32>(20u)));
    let _e147 = (*thread_1);
    let _e149 = ellipse.center;
    let _e150 = along;
    batch_place[_e147] = vec4<f32>(_e149.x, _e149.y, _e150.x, _e150.y);
    let _e157 = (*thread_1);
    let _e158 = across;
    let _e159 = exponent_2;
    let _e160 = word_1;
    batch_shape[_e157] = vec4<f32>(_e158.x, _e158.y, _e159, bitcast<f32>(_e160));
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

fn blend_bin_u0028_struct_u002d_Samples_u002d_vf4_u005b_4_u005d_u002d_b1_u002d_u11_u003b_vu2_u003b_vf2_u003b(samples_2: ptr<function, Samples>, corner_2: ptr<function, vec2<u32>>, first_3: ptr<function, vec2<f32>>) {
    var thread_2: u32;
    var shift_1: u32;
    var at_1: vec2<u32>;
    var bin: u32;
    var param_46: u32;
    var end: u32;
    var from_1: u32;
    var k_3: u32;
    var i_1: u32;
    var local_2: u32;
    var param_47: u32;
    var param_48: u32;
    var param_49: vec2<f32>;
    var word_2: u32;
    var hits: u32;
    var param_50: u32;
    var param_51: u32;
    var k_4: u32;
    var param_52: Samples;
    var param_53: u32;
    var param_54: vec2<f32>;

    let _e39 = gl_LocalInvocationIndex_1;
    thread_2 = _e39;
    let _e42 = unnamed_1.bins[8i];
    shift_1 = _e42;
    let _e43 = (*corner_2);
    let _e45 = frame.bin_side;
    let _e46 = shift_1;
    at_1 = (_e43 / vec2((_e45 << bitcast<u32>(_e46))));
    let _e52 = at_1[1u];
    let _e53 = shift_1;
    param_46 = _e53;
    let _e54 = bins_of_u0028_u1_u003b((&param_46));
    let _e58 = at_1[0u];
    bin = ((_e52 * _e54.x) + _e58);
    let _e61 = settings.starts_start;
    let _e62 = bin;
    let _e67 = unnamed_1.bins[((_e61 + _e62) + 1u)];
    end = _e67;
    let _e69 = settings.starts_start;
    let _e70 = bin;
    let _e74 = unnamed_1.bins[(_e69 + _e70)];
    from_1 = _e74;
    loop {
        let _e75 = from_1;
        let _e76 = end;
        if (_e75 < _e76) {
            let _e78 = thread_2;
            k_3 = _e78;
            loop {
                let _e79 = k_3;
                if (_e79 < 8u) {
                    let _e81 = k_3;
                    atomicStore((&batch_hits[_e81]), 0u);
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e83 = k_3;
                    k_3 = (_e83 + 64u);
                }
            }
            let _e85 = thread_2;
            if (_e85 == 0u) {
                batch_open = 0u;
            }
            workgroupBarrier();
            let _e88 = (*samples_2).open;
            if _e88 {
                batch_open = 1u;
            }
            let _e89 = from_1;
            let _e90 = thread_2;
            let _e92 = end;
            if ((_e89 + _e90) < _e92) {
                let _e95 = settings.pairs_start;
                let _e96 = from_1;
                let _e97 = thread_2;
                let _e101 = unnamed_2.sorted[(_e96 + _e97)];
                let _e105 = unnamed_1.bins[(_e95 + _e101)];
                local_2 = _e105;
            } else {
                local_2 = 0u;
            }
            let _e106 = local_2;
            i_1 = _e106;
            let _e107 = from_1;
            let _e108 = thread_2;
            let _e110 = end;
            if ((_e107 + _e108) < _e110) {
                let _e112 = (*corner_2);
                let _e114 = thread_2;
                param_47 = _e114;
                let _e115 = i_1;
                param_48 = _e115;
                param_49 = vec2<f32>(_e112);
                load_u0028_u1_u003b_u1_u003b_vf2_u003b((&param_47), (&param_48), (&param_49));
            }
            workgroupBarrier();
            let _e116 = workgroupUniformLoad((&batch_open));
            if (_e116 == 0u) {
                break;
            }
            word_2 = 0u;
            loop {
                let _e118 = word_2;
                let _e121 = (*samples_2).open;
                if ((_e118 < 2u) && _e121) {
                    let _e123 = thread_2;
                    param_50 = _e123;
                    let _e124 = word_2;
                    param_51 = _e124;
                    let _e125 = hits_of_u0028_u1_u003b_u1_u003b((&param_50), (&param_51));
                    hits = _e125;
                    loop {
                        let _e126 = hits;
                        let _e129 = (*samples_2).open;
                        if ((_e126 != 0u) && _e129) {
                            let _e131 = hits;
                            k_4 = bitcast<u32>(firstTrailingBit(_e131));
                            let _e134 = hits;
                            let _e136 = hits;
                            hits = (_e136 & (_e134 - 1u));
                            let _e138 = word_2;
                            let _e140 = k_4;
                            let _e142 = (*samples_2);
                            param_52 = _e142;
                            param_53 = ((32u * _e138) + _e140);
                            let _e143 = (*first_3);
                            param_54 = _e143;
                            blend_u0028_struct_u002d_Samples_u002d_vf4_u005b_4_u005d_u002d_b1_u002d_u11_u003b_u1_u003b_vf2_u003b((&param_52), (&param_53), (&param_54));
                            let _e144 = param_52;
                            (*samples_2) = _e144;
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
                    let _e145 = word_2;
                    word_2 = (_e145 + bitcast<u32>(1i));
                }
            }
            workgroupBarrier();
            continue;
        } else {
            break;
        }
        continuing {
            let _e148 = from_1;
            from_1 = (_e148 + 64u);
        }
    }
    return;
}

fn is_drawn_u0028_vu2_u003b(corner_3: ptr<function, vec2<u32>>) -> bool {
    var at_2: vec2<f32>;
    var phi_261_: bool;
    var phi_262_: bool;

    let _e4 = (*corner_3);
    at_2 = vec2<f32>(_e4);
    let _e7 = frame.area_reach;
    let _e8 = (_e7 < 0f);
    phi_262_ = _e8;
    if !(_e8) {
        let _e10 = at_2;
        let _e12 = frame.area;
        let _e15 = all((_e10 >= _e12.xy));
        phi_261_ = _e15;
        if _e15 {
            let _e16 = at_2;
            let _e18 = frame.area;
            phi_261_ = all((_e16 < _e18.zw));
        }
        let _e23 = phi_261_;
        phi_262_ = _e23;
    }
    let _e25 = phi_262_;
    return _e25;
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

@compute @workgroup_size(64, 1, 1) 
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
    var phi_1176_: bool;

    gl_LocalInvocationIndex_1 = gl_LocalInvocationIndex;
    gl_WorkGroupID_1 = gl_WorkGroupID;
    let _e38 = settings.first_region;
    corner = ((_e38 + bitcast<vec3<u32>>(gl_WorkGroupID).xy) * vec2(16u));
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
    phi_1176_ = _e99;
    if _e99 {
        let _e101 = samples.evaluated;
        phi_1176_ = (_e101 > 0u);
    }
    let _e104 = phi_1176_;
    if _e104 {
        let _e108 = samples.evaluated;
        let _e109 = atomicAdd((&unnamed_3.control.fragments), _e108);
    }
    return;
}
