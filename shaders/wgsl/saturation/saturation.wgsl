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
    color: u32,
}

struct Samples {
    light: array<f32, 4>,
    key: array<u32, 4>,
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
var<workgroup> batch_hits: array<atomic<u32>, 8>;
var<workgroup> batch_place: array<vec4<f32>, 64>;
var<workgroup> batch_shape: array<vec4<f32>, 64>;
var<workgroup> batch_key: array<u32, 64>;
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
var depths: texture_storage_2d<r32float,write>;
var<private> gl_WorkGroupID_1: vec3<u32>;
@group(0) @binding(2) 
var<storage, read_write> unnamed_4: ControlBuffer;

fn depth_of_u0028_u1_u003b(key: ptr<function, u32>) -> f32 {
    let _e4 = (*key);
    let _e7 = frame.key_max;
    return min(((1f - (f32(_e4) / f32(_e7))) + 0.000015259022f), 1f);
}

fn store_u0028_vu2_u003b_u1_u003b(at: ptr<function, vec2<u32>>, key_1: ptr<function, u32>) {
    var param_12: u32;

    let _e4 = (*at);
    let _e5 = textureDimensions(depths);
    if all((_e4 < bitcast<vec2<u32>>(vec2<i32>(_e5)))) {
        let _e10 = (*at);
        let _e12 = (*key_1);
        param_12 = _e12;
        let _e13 = depth_of_u0028_u1_u003b((&param_12));
        textureStore(depths, bitcast<vec2<i32>>(_e10), vec4(_e13));
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

fn blend_sample_u0028_f1_u003b_u1_u003b_vf2_u003b_f1_u003b_u1_u003b(light: ptr<function, f32>, key_2: ptr<function, u32>, deviation_1: ptr<function, vec2<f32>>, exponent_1: ptr<function, f32>, own: ptr<function, u32>) {
    var behind: f32;
    var param_13: vec2<f32>;
    var param_14: f32;
    var phi_672_: bool;

    let _e9 = (*light);
    let _e10 = (*light);
    let _e11 = (*deviation_1);
    param_13 = _e11;
    let _e12 = (*exponent_1);
    param_14 = _e12;
    let _e13 = opacity_at_u0028_vf2_u003b_f1_u003b((&param_13), (&param_14));
    behind = (_e9 - (_e10 * _e13));
    let _e16 = (*light);
    let _e18 = settings.saturation;
    let _e19 = (_e16 >= _e18);
    phi_672_ = _e19;
    if _e19 {
        let _e20 = behind;
        let _e22 = settings.saturation;
        phi_672_ = (_e20 < _e22);
    }
    let _e25 = phi_672_;
    let _e26 = (*own);
    let _e27 = (*key_2);
    (*key_2) = select(_e27, _e26, _e25);
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
    seen.color = bitcast<u32>(_e51);
    let _e54 = seen;
    return _e54;
}

fn blend_u0028_struct_u002d_Samples_u002d_f1_u005b_4_u005d_u002d_u1_u005b_4_u005d_u002d_b1_u002d_u11_u003b_u1_u003b_vf2_u003b(samples_1: ptr<function, Samples>, k_1: ptr<function, u32>, first_2: ptr<function, vec2<f32>>) {
    var seen_1: Seen;
    var param_15: u32;
    var param_16: vec2<f32>;
    var own_1: u32;
    var right: vec2<f32>;
    var param_17: f32;
    var param_18: u32;
    var param_19: vec2<f32>;
    var param_20: f32;
    var param_21: u32;
    var param_22: f32;
    var param_23: u32;
    var param_24: vec2<f32>;
    var param_25: f32;
    var param_26: u32;
    var param_27: f32;
    var param_28: u32;
    var param_29: vec2<f32>;
    var param_30: f32;
    var param_31: u32;
    var param_32: f32;
    var param_33: u32;
    var param_34: vec2<f32>;
    var param_35: f32;
    var param_36: u32;

    let _e35 = (*k_1);
    param_15 = _e35;
    let _e36 = (*first_2);
    param_16 = _e36;
    let _e37 = see_u0028_u1_u003b_vf2_u003b((&param_15), (&param_16));
    seen_1 = _e37;
    let _e38 = (*k_1);
    let _e40 = batch_key[_e38];
    own_1 = _e40;
    let _e42 = seen_1.deviation;
    let _e44 = seen_1.right;
    right = (_e42 + _e44);
    let _e48 = (*samples_1).light[0i];
    param_17 = _e48;
    let _e51 = (*samples_1).key[0i];
    param_18 = _e51;
    let _e53 = seen_1.deviation;
    param_19 = _e53;
    let _e55 = seen_1.exponent;
    param_20 = _e55;
    let _e56 = own_1;
    param_21 = _e56;
    blend_sample_u0028_f1_u003b_u1_u003b_vf2_u003b_f1_u003b_u1_u003b((&param_17), (&param_18), (&param_19), (&param_20), (&param_21));
    let _e57 = param_17;
    (*samples_1).light[0i] = _e57;
    let _e60 = param_18;
    (*samples_1).key[0i] = _e60;
    let _e65 = (*samples_1).light[1i];
    param_22 = _e65;
    let _e68 = (*samples_1).key[1i];
    param_23 = _e68;
    let _e69 = right;
    param_24 = _e69;
    let _e71 = seen_1.exponent;
    param_25 = _e71;
    let _e72 = own_1;
    param_26 = _e72;
    blend_sample_u0028_f1_u003b_u1_u003b_vf2_u003b_f1_u003b_u1_u003b((&param_22), (&param_23), (&param_24), (&param_25), (&param_26));
    let _e73 = param_22;
    (*samples_1).light[1i] = _e73;
    let _e76 = param_23;
    (*samples_1).key[1i] = _e76;
    let _e80 = seen_1.deviation;
    let _e82 = seen_1.down;
    let _e86 = (*samples_1).light[2i];
    param_27 = _e86;
    let _e89 = (*samples_1).key[2i];
    param_28 = _e89;
    param_29 = (_e80 + _e82);
    let _e91 = seen_1.exponent;
    param_30 = _e91;
    let _e92 = own_1;
    param_31 = _e92;
    blend_sample_u0028_f1_u003b_u1_u003b_vf2_u003b_f1_u003b_u1_u003b((&param_27), (&param_28), (&param_29), (&param_30), (&param_31));
    let _e93 = param_27;
    (*samples_1).light[2i] = _e93;
    let _e96 = param_28;
    (*samples_1).key[2i] = _e96;
    let _e99 = right;
    let _e101 = seen_1.down;
    let _e105 = (*samples_1).light[3i];
    param_32 = _e105;
    let _e108 = (*samples_1).key[3i];
    param_33 = _e108;
    param_34 = (_e99 + _e101);
    let _e110 = seen_1.exponent;
    param_35 = _e110;
    let _e111 = own_1;
    param_36 = _e111;
    blend_sample_u0028_f1_u003b_u1_u003b_vf2_u003b_f1_u003b_u1_u003b((&param_32), (&param_33), (&param_34), (&param_35), (&param_36));
    let _e112 = param_32;
    (*samples_1).light[3i] = _e112;
    let _e115 = param_33;
    (*samples_1).key[3i] = _e115;
    let _e120 = (*samples_1).light[0i];
    let _e123 = (*samples_1).light[1i];
    let _e127 = (*samples_1).light[2i];
    let _e130 = (*samples_1).light[3i];
    let _e134 = settings.saturation;
    (*samples_1).open = (max(max(_e120, _e123), max(_e127, _e130)) >= _e134);
    let _e138 = (*samples_1).evaluated;
    (*samples_1).evaluated = (_e138 + 4u);
    return;
}

fn key_at_u0028_u1_u003b(i: ptr<function, u32>) -> u32 {
    var word: u32;
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
    word = (_e14 + _e22);
    let _e24 = word;
    let _e27 = word;
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

fn nearest_u0028_f1_u003b_f1_u003b_f1_u003b_vf2_u003b_vf2_u003b(a: ptr<function, f32>, b: ptr<function, f32>, c: ptr<function, f32>, low: ptr<function, vec2<f32>>, high: ptr<function, vec2<f32>>) -> f32 {
    var side: vec2<f32>;
    var p: vec2<f32>;
    var q: vec2<f32>;

    let _e12 = (*low);
    let _e13 = (*high);
    side = clamp(vec2<f32>(0f, 0f), _e12, _e13);
    let _e16 = side[0u];
    let _e17 = (*b);
    let _e20 = side[0u];
    let _e22 = (*c);
    let _e25 = (*low)[1u];
    let _e27 = (*high)[1u];
    p = vec2<f32>(_e16, clamp(((-(_e17) * _e20) / _e22), _e25, _e27));
    let _e30 = (*b);
    let _e33 = side[1u];
    let _e35 = (*a);
    let _e38 = (*low)[0u];
    let _e40 = (*high)[0u];
    let _e43 = side[1u];
    q = vec2<f32>(clamp(((-(_e30) * _e33) / _e35), _e38, _e40), _e43);
    let _e45 = (*a);
    let _e47 = p[0u];
    let _e50 = p[0u];
    let _e52 = (*b);
    let _e55 = p[0u];
    let _e58 = p[1u];
    let _e61 = (*c);
    let _e63 = p[1u];
    let _e66 = p[1u];
    let _e69 = (*a);
    let _e71 = q[0u];
    let _e74 = q[0u];
    let _e76 = (*b);
    let _e79 = q[0u];
    let _e82 = q[1u];
    let _e85 = (*c);
    let _e87 = q[1u];
    let _e90 = q[1u];
    return min(((((_e45 * _e47) * _e50) + (((2f * _e52) * _e55) * _e58)) + ((_e61 * _e63) * _e66)), ((((_e69 * _e71) * _e74) + (((2f * _e76) * _e79) * _e82)) + ((_e85 * _e87) * _e90)));
}

fn fixed_center_u0028_vu4_u003b(words: ptr<function, vec4<u32>>) -> vec2<f32> {
    let _e2 = (*words);
    return vec2<f32>((_e2.xy & vec2(1048575u)));
}

fn unpack_splat_u0028_vu4_u003b(words_1: ptr<function, vec4<u32>>) -> Splat {
    var splat: Splat;
    var param_37: vec4<u32>;
    var blue: u32;
    var red: u32;
    var green: u32;

    let _e18 = (*words_1);
    param_37 = _e18;
    let _e19 = fixed_center_u0028_vu4_u003b((&param_37));
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
    var param_38: vec4<u32>;
    var inverse: f32;
    var along: vec2<f32>;
    var across: vec2<f32>;
    var exponent_2: f32;
    var center: vec2<f32>;
    var a_1: f32;
    var b_1: f32;
    var c_1: f32;
    var meets: bool;
    var quarter: u32;
    var low_1: vec2<f32>;
    var high_1: vec2<f32>;
    var param_39: f32;
    var param_40: f32;
    var param_41: f32;
    var param_42: vec2<f32>;
    var param_43: vec2<f32>;
    var color: vec3<u32>;
    var param_44: u32;

    let _e48 = (*i_1);
    let _e51 = unnamed.splats[_e48];
    param_38 = _e51;
    let _e52 = unpack_splat_u0028_vu4_u003b((&param_38));
    splat_1 = _e52;
    let _e54 = splat_1.axis;
    let _e56 = splat_1.axis;
    inverse = (1f / dot(_e54, _e56));
    let _e59 = inverse;
    let _e62 = splat_1.axis;
    along = (_e62 * (0.8493218f * _e59));
    let _e64 = inverse;
    let _e68 = splat_1.shorter;
    let _e72 = splat_1.axis[1u];
    let _e76 = splat_1.axis[0u];
    across = (vec2<f32>(-(_e72), _e76) * ((0.8493218f * sqrt(_e64)) / _e68));
    let _e80 = splat_1.opacity;
    exponent_2 = log2((f32(_e80) / 255f));
    let _e85 = splat_1.center;
    let _e86 = (*corner);
    center = (_e85 - _e86);
    let _e89 = along[0u];
    let _e91 = along[0u];
    let _e94 = across[0u];
    let _e96 = across[0u];
    a_1 = ((_e89 * _e91) + (_e94 * _e96));
    let _e100 = along[0u];
    let _e102 = along[1u];
    let _e105 = across[0u];
    let _e107 = across[1u];
    b_1 = ((_e100 * _e102) + (_e105 * _e107));
    let _e111 = along[1u];
    let _e113 = along[1u];
    let _e116 = across[1u];
    let _e118 = across[1u];
    c_1 = ((_e111 * _e113) + (_e116 * _e118));
    meets = false;
    quarter = 0u;
    loop {
        let _e121 = quarter;
        if (_e121 < 4u) {
            let _e123 = quarter;
            let _e126 = quarter;
            let _e132 = center;
            low_1 = ((vec2<f32>(f32((_e123 & 1u)), f32((_e126 >> bitcast<u32>(1u)))) * 16f) - _e132);
            let _e134 = low_1;
            high_1 = (_e134 + vec2(16f));
            let _e138 = settings.bin_margin;
            let _e140 = low_1;
            low_1 = (_e140 + vec2((0.5f - _e138)));
            let _e144 = settings.bin_margin;
            let _e146 = high_1;
            high_1 = (_e146 - vec2((0.5f - _e144)));
            let _e149 = a_1;
            param_39 = _e149;
            let _e150 = b_1;
            param_40 = _e150;
            let _e151 = c_1;
            param_41 = _e151;
            let _e152 = low_1;
            param_42 = _e152;
            let _e153 = high_1;
            param_43 = _e153;
            let _e154 = nearest_u0028_f1_u003b_f1_u003b_f1_u003b_vf2_u003b_vf2_u003b((&param_39), (&param_40), (&param_41), (&param_42), (&param_43));
            let _e155 = exponent_2;
            let _e157 = settings.cutoff_exponent;
            if !((_e154 > ((_e155 - _e157) + 0.00390625f))) {
                let _e162 = quarter;
                let _e164 = (*thread);
                let _e169 = (*thread);
                let _e173 = atomicOr((&batch_hits[((_e162 * 2u) + (_e164 >> bitcast<u32>(5u)))]), (1u << bitcast<u32>((_e169 & 31u))));
                meets = true;
            }
            continue;
        } else {
            break;
        }
        continuing {
            let _e174 = quarter;
            quarter = (_e174 + bitcast<u32>(1i));
        }
    }
    let _e177 = meets;
    if !(_e177) {
        return;
    }
    let _e180 = splat_1.color;
    color = vec3<u32>(round((_e180 * 1023f)));
    let _e184 = (*thread);
    let _e185 = center;
    let _e186 = along;
    batch_place[_e184] = vec4<f32>(_e185.x, _e185.y, _e186.x, _e186.y);
    let _e193 = (*thread);
    let _e194 = across;
    let _e195 = exponent_2;
    let _e197 = color[0u];
    let _e199 = color[1u];
    let _e204 = color[2u];
    batch_shape[_e193] = vec4<f32>(_e194.x, _e194.y, _e195, bitcast<f32>(((_e197 | (_e199 << bitcast<u32>(10u))) | (_e204 << bitcast<u32>(20u)))));
    let _e213 = (*thread);
    let _e214 = (*i_1);
    param_44 = _e214;
    let _e215 = key_at_u0028_u1_u003b((&param_44));
    batch_key[_e213] = _e215;
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

fn blend_bin_u0028_struct_u002d_Samples_u002d_f1_u005b_4_u005d_u002d_u1_u005b_4_u005d_u002d_b1_u002d_u11_u003b_vu2_u003b_vf2_u003b(samples_2: ptr<function, Samples>, corner_1: ptr<function, vec2<u32>>, first_3: ptr<function, vec2<f32>>) {
    var thread_1: u32;
    var quarter_1: u32;
    var shift_1: u32;
    var at_1: vec2<u32>;
    var bin: u32;
    var param_45: u32;
    var end: u32;
    var from_1: u32;
    var i_2: u32;
    var local_3: u32;
    var param_46: u32;
    var param_47: u32;
    var param_48: vec2<f32>;
    var word_1: u32;
    var hits: u32;
    var k_2: u32;
    var param_49: Samples;
    var param_50: u32;
    var param_51: vec2<f32>;

    let _e42 = gl_LocalInvocationIndex_1;
    thread_1 = _e42;
    let _e43 = thread_1;
    quarter_1 = (_e43 / 16u);
    let _e47 = unnamed_1.bins[8i];
    shift_1 = _e47;
    let _e48 = (*corner_1);
    let _e50 = frame.bin_side;
    let _e51 = shift_1;
    at_1 = (_e48 / vec2((_e50 << bitcast<u32>(_e51))));
    let _e57 = at_1[1u];
    let _e58 = shift_1;
    param_45 = _e58;
    let _e59 = bins_of_u0028_u1_u003b((&param_45));
    let _e63 = at_1[0u];
    bin = ((_e57 * _e59.x) + _e63);
    let _e66 = settings.starts_start;
    let _e67 = bin;
    let _e72 = unnamed_1.bins[((_e66 + _e67) + 1u)];
    end = _e72;
    let _e74 = settings.starts_start;
    let _e75 = bin;
    let _e79 = unnamed_1.bins[(_e74 + _e75)];
    from_1 = _e79;
    loop {
        let _e80 = from_1;
        let _e81 = end;
        if (_e80 < _e81) {
            let _e83 = thread_1;
            batch_seen[_e83] = 0u;
            let _e85 = thread_1;
            if (_e85 < 8u) {
                let _e87 = thread_1;
                atomicStore((&batch_hits[_e87]), 0u);
            }
            let _e89 = thread_1;
            if (_e89 == 0u) {
                batch_open = 0u;
            }
            workgroupBarrier();
            let _e92 = (*samples_2).open;
            if _e92 {
                batch_open = 1u;
            }
            let _e93 = from_1;
            let _e94 = thread_1;
            let _e96 = end;
            if ((_e93 + _e94) < _e96) {
                let _e99 = settings.pairs_start;
                let _e100 = from_1;
                let _e101 = thread_1;
                let _e105 = unnamed_2.sorted[(_e100 + _e101)];
                let _e109 = unnamed_1.bins[(_e99 + _e105)];
                local_3 = _e109;
            } else {
                local_3 = 0u;
            }
            let _e110 = local_3;
            i_2 = _e110;
            let _e111 = from_1;
            let _e112 = thread_1;
            let _e114 = end;
            if ((_e111 + _e112) < _e114) {
                let _e116 = (*corner_1);
                let _e118 = thread_1;
                param_46 = _e118;
                let _e119 = i_2;
                param_47 = _e119;
                param_48 = vec2<f32>(_e116);
                load_u0028_u1_u003b_u1_u003b_vf2_u003b((&param_46), (&param_47), (&param_48));
            }
            workgroupBarrier();
            let _e120 = workgroupUniformLoad((&batch_open));
            if (_e120 == 0u) {
                break;
            }
            word_1 = 0u;
            loop {
                let _e122 = word_1;
                if (_e122 < 2u) {
                    let _e124 = quarter_1;
                    let _e126 = word_1;
                    let _e129 = atomicLoad((&batch_hits[((_e124 * 2u) + _e126)]));
                    hits = _e129;
                    loop {
                        let _e130 = hits;
                        let _e133 = (*samples_2).open;
                        if ((_e130 != 0u) && _e133) {
                            let _e135 = hits;
                            k_2 = bitcast<u32>(firstTrailingBit(_e135));
                            let _e138 = hits;
                            let _e140 = hits;
                            hits = (_e140 & (_e138 - 1u));
                            let _e142 = word_1;
                            let _e144 = k_2;
                            batch_seen[((32u * _e142) + _e144)] = 1u;
                            let _e147 = word_1;
                            let _e149 = k_2;
                            let _e151 = (*samples_2);
                            param_49 = _e151;
                            param_50 = ((32u * _e147) + _e149);
                            let _e152 = (*first_3);
                            param_51 = _e152;
                            blend_u0028_struct_u002d_Samples_u002d_f1_u005b_4_u005d_u002d_u1_u005b_4_u005d_u002d_b1_u002d_u11_u003b_u1_u003b_vf2_u003b((&param_49), (&param_50), (&param_51));
                            let _e153 = param_49;
                            (*samples_2) = _e153;
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
                    let _e154 = word_1;
                    word_1 = (_e154 + bitcast<u32>(1i));
                }
            }
            workgroupBarrier();
            let _e157 = thread_1;
            let _e159 = batch_seen[_e157];
            if (_e159 != 0u) {
                let _e161 = i_2;
                let _e166 = i_2;
                let _e170 = atomicOr((&unnamed_3.marks[(_e161 >> bitcast<u32>(5u))]), (1u << bitcast<u32>((_e166 & 31u))));
            }
            continue;
        } else {
            break;
        }
        continuing {
            let _e171 = from_1;
            from_1 = (_e171 + 64u);
        }
    }
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
    var phi_1124_: bool;

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
    samples.key = array<u32, 4>(0u, 0u, 0u, 0u);
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
    let _e66 = samples.key[0i];
    param_5 = _e66;
    store_u0028_vu2_u003b_u1_u003b((&param_4), (&param_5));
    let _e67 = first;
    param_6 = (_e67 + vec2<u32>(1u, 0u));
    let _e71 = samples.key[1i];
    param_7 = _e71;
    store_u0028_vu2_u003b_u1_u003b((&param_6), (&param_7));
    let _e72 = first;
    param_8 = (_e72 + vec2<u32>(0u, 1u));
    let _e76 = samples.key[2i];
    param_9 = _e76;
    store_u0028_vu2_u003b_u1_u003b((&param_8), (&param_9));
    let _e77 = first;
    param_10 = (_e77 + vec2<u32>(1u, 1u));
    let _e81 = samples.key[3i];
    param_11 = _e81;
    store_u0028_vu2_u003b_u1_u003b((&param_10), (&param_11));
    let _e83 = settings.counted;
    let _e84 = (_e83 != 0u);
    phi_1124_ = _e84;
    if _e84 {
        let _e86 = samples.evaluated;
        phi_1124_ = (_e86 > 0u);
    }
    let _e89 = phi_1124_;
    if _e89 {
        let _e93 = samples.evaluated;
        let _e94 = atomicAdd((&unnamed_4.control.fragments), _e93);
    }
    return;
}
