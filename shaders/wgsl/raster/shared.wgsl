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

fn hits_of_u0028_vu2_u003b_u1_u003b(invocation: ptr<function, vec2<u32>>, word: ptr<function, u32>) -> u32 {
    var hits: u32;
    var k_2: u32;
    var bits: u32;

    hits = 0u;
    k_2 = 0u;
    loop {
        let _e12 = k_2;
        if (_e12 < 8u) {
            let _e15 = (*invocation)[1u];
            let _e17 = (*word);
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

fn fixed_center_u0028_vu4_u003b(words: ptr<function, vec4<u32>>) -> vec2<f32> {
    let _e2 = (*words);
    return vec2<f32>((_e2.xy & vec2(1048575u)));
}

fn unpack_splat_u0028_vu4_u003b(words_1: ptr<function, vec4<u32>>) -> Splat {
    var splat: Splat;
    var param_39: vec4<u32>;
    var blue: u32;
    var red: u32;
    var green: u32;

    let _e18 = (*words_1);
    param_39 = _e18;
    let _e19 = fixed_center_u0028_vu4_u003b((&param_39));
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

fn load_u0028_u1_u003b_u1_u003b_vf2_u003b(thread: ptr<function, u32>, i: ptr<function, u32>, corner_1: ptr<function, vec2<f32>>) {
    var splat_1: Splat;
    var param_40: vec4<u32>;
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
    var local_2: u32;
    var end: u32;
    var local_3: u32;
    var bits_1: u32;
    var color_2: vec3<u32>;
    var word_1: u32;
    var phi_485_: bool;

    let _e62 = (*i);
    let _e65 = unnamed.splats[_e62];
    param_40 = _e65;
    let _e66 = unpack_splat_u0028_vu4_u003b((&param_40));
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
    let _e100 = (*corner_1);
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
            top = ((((2f * f32(_e167)) + 0.5f) - _e172) - _e175);
            let _e177 = top;
            let _e181 = settings.bin_margin;
            bottom = (((_e177 + 2f) - 1f) + (2f * _e181));
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
            low = ((((_e227 + 0.5f) - _e230) / 2f) - 1f);
            let _e235 = ends[1u];
            let _e238 = settings.bin_margin;
            high = (((_e235 - 0.5f) + _e238) / 2f);
            let _e241 = low;
            if (_e241 > 0f) {
                let _e243 = low;
                local_2 = u32(ceil(min(_e243, 8f)));
            } else {
                local_2 = 0u;
            }
            let _e247 = local_2;
            from_1 = _e247;
            let _e248 = high;
            if (_e248 < 8f) {
                let _e250 = high;
                local_3 = u32((floor(max(_e250, -1f)) + 1f));
            } else {
                local_3 = 8u;
            }
            let _e255 = local_3;
            end = _e255;
            let _e256 = from_1;
            let _e257 = end;
            let _e258 = (_e256 < _e257);
            phi_485_ = _e258;
            if _e258 {
                let _e260 = squared[0u];
                let _e262 = squared[1u];
                phi_485_ = !((max(_e260, _e262) < 0f));
            }
            let _e267 = phi_485_;
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
    let _e292 = splat_1.color;
    color_2 = vec3<u32>(round((_e292 * 1023f)));
    let _e297 = color_2[0u];
    let _e299 = color_2[1u];
    let _e304 = color_2[2u];
    word_1 = ((_e297 | (_e299 << bitcast<u32>(10u))) | (_e304 << bitcast<u32>(20u)));
    let _e308 = (*thread);
    let _e309 = center;
    let _e310 = along;
    batch_place[_e308] = vec4<f32>(_e309.x, _e309.y, _e310.x, _e310.y);
    let _e317 = (*thread);
    let _e318 = across;
    let _e319 = exponent_2;
    let _e320 = word_1;
    batch_shape[_e317] = vec4<f32>(_e318.x, _e318.y, _e319, bitcast<f32>(_e320));
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

fn blend_bin_u0028_struct_u002d_Samples_u002d_vf4_u005b_4_u005d_u002d_b1_u002d_u11_u003b_vu2_u003b_vf2_u003b(samples_2: ptr<function, Samples>, corner_2: ptr<function, vec2<u32>>, first_3: ptr<function, vec2<f32>>) {
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
    var i_1: u32;
    var local_4: u32;
    var param_43: u32;
    var param_44: u32;
    var param_45: vec2<f32>;
    var word_2: u32;
    var hits_1: u32;
    var param_46: vec2<u32>;
    var param_47: u32;
    var k_4: u32;
    var param_48: Samples;
    var param_49: u32;
    var param_50: vec2<f32>;

    let _e41 = gl_LocalInvocationIndex_1;
    thread_1 = _e41;
    let _e42 = thread_1;
    param_41 = _e42;
    let _e43 = place_of_u0028_u1_u003b((&param_41));
    place_2 = _e43;
    let _e46 = unnamed_1.bins[8i];
    shift_1 = _e46;
    let _e47 = (*corner_2);
    let _e49 = frame.bin_side;
    let _e50 = shift_1;
    at_2 = (_e47 / vec2((_e49 << bitcast<u32>(_e50))));
    let _e56 = at_2[1u];
    let _e57 = shift_1;
    param_42 = _e57;
    let _e58 = bins_of_u0028_u1_u003b((&param_42));
    let _e62 = at_2[0u];
    bin = ((_e56 * _e58.x) + _e62);
    let _e65 = settings.starts_start;
    let _e66 = bin;
    let _e71 = unnamed_1.bins[((_e65 + _e66) + 1u)];
    end_1 = _e71;
    let _e73 = settings.starts_start;
    let _e74 = bin;
    let _e78 = unnamed_1.bins[(_e73 + _e74)];
    from_2 = _e78;
    loop {
        let _e79 = from_2;
        let _e80 = end_1;
        if (_e79 < _e80) {
            let _e82 = thread_1;
            k_3 = _e82;
            loop {
                let _e83 = k_3;
                if (_e83 < 128u) {
                    let _e85 = k_3;
                    atomicStore((&batch_hits[_e85]), 0u);
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e87 = k_3;
                    k_3 = (_e87 + 64u);
                }
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
            let _e93 = from_2;
            let _e94 = thread_1;
            let _e96 = end_1;
            if ((_e93 + _e94) < _e96) {
                let _e99 = settings.pairs_start;
                let _e100 = from_2;
                let _e101 = thread_1;
                let _e105 = unnamed_2.sorted[(_e100 + _e101)];
                let _e109 = unnamed_1.bins[(_e99 + _e105)];
                local_4 = _e109;
            } else {
                local_4 = 0u;
            }
            let _e110 = local_4;
            i_1 = _e110;
            let _e111 = from_2;
            let _e112 = thread_1;
            let _e114 = end_1;
            if ((_e111 + _e112) < _e114) {
                let _e116 = (*corner_2);
                let _e118 = thread_1;
                param_43 = _e118;
                let _e119 = i_1;
                param_44 = _e119;
                param_45 = vec2<f32>(_e116);
                load_u0028_u1_u003b_u1_u003b_vf2_u003b((&param_43), (&param_44), (&param_45));
            }
            workgroupBarrier();
            let _e120 = workgroupUniformLoad((&batch_open));
            if (_e120 == 0u) {
                break;
            }
            word_2 = 0u;
            loop {
                let _e122 = word_2;
                let _e125 = (*samples_2).open;
                if ((_e122 < 2u) && _e125) {
                    let _e127 = place_2;
                    param_46 = _e127;
                    let _e128 = word_2;
                    param_47 = _e128;
                    let _e129 = hits_of_u0028_vu2_u003b_u1_u003b((&param_46), (&param_47));
                    hits_1 = _e129;
                    loop {
                        let _e130 = hits_1;
                        let _e133 = (*samples_2).open;
                        if ((_e130 != 0u) && _e133) {
                            let _e135 = hits_1;
                            k_4 = bitcast<u32>(firstTrailingBit(_e135));
                            let _e138 = hits_1;
                            let _e140 = hits_1;
                            hits_1 = (_e140 & (_e138 - 1u));
                            let _e142 = word_2;
                            let _e144 = k_4;
                            let _e146 = (*samples_2);
                            param_48 = _e146;
                            param_49 = ((32u * _e142) + _e144);
                            let _e147 = (*first_3);
                            param_50 = _e147;
                            blend_u0028_struct_u002d_Samples_u002d_vf4_u005b_4_u005d_u002d_b1_u002d_u11_u003b_u1_u003b_vf2_u003b((&param_48), (&param_49), (&param_50));
                            let _e148 = param_48;
                            (*samples_2) = _e148;
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
                    let _e149 = word_2;
                    word_2 = (_e149 + bitcast<u32>(1i));
                }
            }
            workgroupBarrier();
            continue;
        } else {
            break;
        }
        continuing {
            let _e152 = from_2;
            from_2 = (_e152 + 64u);
        }
    }
    return;
}

fn is_drawn_u0028_vu2_u003b(corner_3: ptr<function, vec2<u32>>) -> bool {
    var at_3: vec2<f32>;
    var phi_849_: bool;
    var phi_850_: bool;

    let _e4 = (*corner_3);
    at_3 = vec2<f32>(_e4);
    let _e7 = frame.area_reach;
    let _e8 = (_e7 < 0f);
    phi_850_ = _e8;
    if !(_e8) {
        let _e10 = at_3;
        let _e12 = frame.area;
        let _e15 = all((_e10 >= _e12.xy));
        phi_849_ = _e15;
        if _e15 {
            let _e16 = at_3;
            let _e18 = frame.area;
            phi_849_ = all((_e16 < _e18.zw));
        }
        let _e23 = phi_849_;
        phi_850_ = _e23;
    }
    let _e25 = phi_850_;
    return _e25;
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
    var phi_1187_: bool;

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
    phi_1187_ = _e99;
    if _e99 {
        let _e101 = samples.evaluated;
        phi_1187_ = (_e101 > 0u);
    }
    let _e104 = phi_1187_;
    if _e104 {
        let _e108 = samples.evaluated;
        let _e109 = atomicAdd((&unnamed_3.control.fragments), _e108);
    }
    return;
}
