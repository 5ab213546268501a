struct Keys {
    keys: array<u32>,
}

struct Bins {
    bins: array<u32>,
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

struct Splats {
    splats: array<vec4<u32>>,
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

struct Control_1 {
    index_count: u32,
    instance_count: u32,
    first_index: u32,
    vertex_offset: i32,
    first_instance: u32,
    entering: u32,
    survivors: u32,
    fragments: atomic<u32>,
}

struct ControlBuffer_1 {
    control: Control_1,
}

struct Keys_1 {
    keys: array<u32, LENGTH_5_4>,
}

struct Bins_1 {
    bins: array<u32, LENGTH_3_4>,
}

struct Splats_1 {
    splats: array<vec4<u32>, LENGTH_1_16>,
}

var<private> shaded: u32;
var<private> open: bool;
@group(0) @binding(5) 
var<storage> unnamed: Keys_1;
@group(0) @binding(3) 
var<storage> unnamed_1: Bins_1;
var<private> fixed_scale: f32;
@group(0) @binding(0) 
var<uniform> frame: FrameBlock;
var<private> guard: f32;
var<private> hull_opacity: f32;
var<private> cutoff: f32;
var<private> least: f32;
@group(0) @binding(7) 
var<uniform> settings: SettingsBlock;
var<private> full: f32;
var<private> gl_LocalInvocationIndex_1: u32;
var<private> middle: vec2<f32>;
var<private> pixels: array<vec4<f32>, 16>;
@group(0) @binding(1) 
var<storage> unnamed_2: Splats_1;
var<private> gl_WorkGroupID_1: vec3<u32>;
@group(0) @binding(4) 
var picture: texture_storage_2d<rgba8unorm,write>;
@group(0) @binding(2) 
var<storage, read_write> unnamed_3: ControlBuffer_1;

fn smaller_u0028_f1_u003b_f1_u003b(a: ptr<function, f32>, b: ptr<function, f32>) -> f32 {
    let _e92 = (*a);
    let _e93 = (*b);
    let _e94 = (*b);
    let _e95 = (*a);
    return select(_e92, _e93, (_e94 < _e95));
}

fn larger_u0028_f1_u003b_f1_u003b(a_1: ptr<function, f32>, b_1: ptr<function, f32>) -> f32 {
    let _e92 = (*a_1);
    let _e93 = (*b_1);
    let _e94 = (*b_1);
    let _e95 = (*a_1);
    return select(_e92, _e93, (_e94 > _e95));
}

fn upper_half_u0028_u1_u003b(word: ptr<function, u32>) -> f32 {
    let _e91 = (*word);
    let _e96 = (*word);
    return (bitcast<f32>(((((_e91 & 2147483647u) >> bitcast<u32>(3u)) & 268427264u) | (_e96 & 2147483648u))) * 5192297000000000000000000000000000f);
}

fn lower_half_u0028_u1_u003b(word_1: ptr<function, u32>) -> f32 {
    let _e91 = (*word_1);
    let _e94 = (*word_1);
    return (bitcast<f32>((((_e91 & 32767u) * 8192u) | ((_e94 & 32768u) * 65536u))) * 5192297000000000000000000000000000f);
}

fn number_u0028_u1_u003b_u1_u003b(word_2: ptr<function, u32>, mask: ptr<function, u32>) -> f32 {
    let _e92 = (*word_2);
    let _e93 = (*mask);
    return f32(bitcast<i32>((_e92 & _e93)));
}

fn put_u0028_vu4_u003b(words: ptr<function, vec4<u32>>) {
    var from_: vec2<f32>;
    var param: u32;
    var param_1: u32;
    var param_2: u32;
    var param_3: u32;
    var axis: vec2<f32>;
    var param_4: u32;
    var param_5: u32;
    var shorter: f32;
    var param_6: u32;
    var opacity: f32;
    var param_7: u32;
    var param_8: u32;
    var inverse: f32;
    var reach: f32;
    var param_9: f32;
    var param_10: f32;
    var param_11: f32;
    var param_12: f32;
    var box: vec2<f32>;
    var along: vec2<f32>;
    var across: vec2<f32>;
    var right: vec2<f32>;
    var bend: f32;
    var low: f32;
    var param_13: u32;
    var param_14: u32;
    var high: f32;
    var param_15: u32;
    var param_16: u32;
    var color: vec3<f32>;
    var param_17: u32;
    var param_18: u32;
    var param_19: u32;
    var param_20: u32;
    var deviation: vec2<f32>;
    var most: f32;
    var weight: f32;
    var alpha: f32;
    var factor: f32;
    var param_21: f32;
    var param_22: f32;
    var covers: f32;
    var param_23: f32;
    var param_24: f32;
    var pixel: vec4<f32>;
    var share: f32;
    var param_25: f32;
    var param_26: f32;
    var covers_1: f32;
    var param_27: f32;
    var param_28: f32;
    var pixel_1: vec4<f32>;
    var share_1: f32;
    var param_29: f32;
    var param_30: f32;
    var covers_2: f32;
    var param_31: f32;
    var param_32: f32;
    var pixel_2: vec4<f32>;
    var share_2: f32;
    var param_33: f32;
    var param_34: f32;
    var covers_3: f32;
    var param_35: f32;
    var param_36: f32;
    var pixel_3: vec4<f32>;
    var share_3: f32;
    var param_37: f32;
    var param_38: f32;
    var weight_1: f32;
    var alpha_1: f32;
    var factor_1: f32;
    var param_39: f32;
    var param_40: f32;
    var covers_4: f32;
    var param_41: f32;
    var param_42: f32;
    var pixel_4: vec4<f32>;
    var share_4: f32;
    var param_43: f32;
    var param_44: f32;
    var covers_5: f32;
    var param_45: f32;
    var param_46: f32;
    var pixel_5: vec4<f32>;
    var share_5: f32;
    var param_47: f32;
    var param_48: f32;
    var covers_6: f32;
    var param_49: f32;
    var param_50: f32;
    var pixel_6: vec4<f32>;
    var share_6: f32;
    var param_51: f32;
    var param_52: f32;
    var covers_7: f32;
    var param_53: f32;
    var param_54: f32;
    var pixel_7: vec4<f32>;
    var share_7: f32;
    var param_55: f32;
    var param_56: f32;
    var weight_2: f32;
    var alpha_2: f32;
    var factor_2: f32;
    var param_57: f32;
    var param_58: f32;
    var covers_8: f32;
    var param_59: f32;
    var param_60: f32;
    var pixel_8: vec4<f32>;
    var share_8: f32;
    var param_61: f32;
    var param_62: f32;
    var covers_9: f32;
    var param_63: f32;
    var param_64: f32;
    var pixel_9: vec4<f32>;
    var share_9: f32;
    var param_65: f32;
    var param_66: f32;
    var covers_10: f32;
    var param_67: f32;
    var param_68: f32;
    var pixel_10: vec4<f32>;
    var share_10: f32;
    var param_69: f32;
    var param_70: f32;
    var covers_11: f32;
    var param_71: f32;
    var param_72: f32;
    var pixel_11: vec4<f32>;
    var share_11: f32;
    var param_73: f32;
    var param_74: f32;
    var weight_3: f32;
    var alpha_3: f32;
    var factor_3: f32;
    var param_75: f32;
    var param_76: f32;
    var covers_12: f32;
    var param_77: f32;
    var param_78: f32;
    var pixel_12: vec4<f32>;
    var share_12: f32;
    var param_79: f32;
    var param_80: f32;
    var covers_13: f32;
    var param_81: f32;
    var param_82: f32;
    var pixel_13: vec4<f32>;
    var share_13: f32;
    var param_83: f32;
    var param_84: f32;
    var covers_14: f32;
    var param_85: f32;
    var param_86: f32;
    var pixel_14: vec4<f32>;
    var share_14: f32;
    var param_87: f32;
    var param_88: f32;
    var covers_15: f32;
    var param_89: f32;
    var param_90: f32;
    var pixel_15: vec4<f32>;
    var share_15: f32;
    var param_91: f32;
    var param_92: f32;
    var phi_332_: bool;
    var phi_342_: bool;

    let _e260 = middle;
    let _e262 = (*words)[0u];
    param = _e262;
    param_1 = 1048575u;
    let _e263 = number_u0028_u1_u003b_u1_u003b((&param), (&param_1));
    let _e265 = (*words)[1u];
    param_2 = _e265;
    param_3 = 1048575u;
    let _e266 = number_u0028_u1_u003b_u1_u003b((&param_2), (&param_3));
    let _e268 = fixed_scale;
    let _e271 = guard;
    from_ = (_e260 - ((vec2<f32>(_e263, _e266) / vec2(_e268)) - vec2(_e271)));
    let _e276 = (*words)[2u];
    param_4 = _e276;
    let _e277 = lower_half_u0028_u1_u003b((&param_4));
    let _e279 = (*words)[2u];
    param_5 = _e279;
    let _e280 = upper_half_u0028_u1_u003b((&param_5));
    axis = vec2<f32>(_e277, _e280);
    let _e283 = (*words)[3u];
    param_6 = _e283;
    let _e284 = lower_half_u0028_u1_u003b((&param_6));
    shorter = _e284;
    let _e286 = (*words)[3u];
    param_7 = _e286;
    param_8 = 16711680u;
    let _e287 = number_u0028_u1_u003b_u1_u003b((&param_7), (&param_8));
    opacity = (_e287 / 65536f);
    let _e289 = axis;
    let _e290 = axis;
    inverse = (1f / dot(_e289, _e290));
    let _e293 = opacity;
    param_9 = _e293;
    let _e294 = hull_opacity;
    param_10 = _e294;
    let _e295 = larger_u0028_f1_u003b_f1_u003b((&param_9), (&param_10));
    let _e296 = cutoff;
    param_11 = (_e295 / _e296);
    param_12 = 1f;
    let _e298 = larger_u0028_f1_u003b_f1_u003b((&param_11), (&param_12));
    reach = (2f * log(_e298));
    let _e301 = reach;
    let _e302 = axis;
    let _e303 = axis;
    let _e305 = shorter;
    let _e306 = shorter;
    let _e308 = inverse;
    let _e310 = axis;
    let _e313 = axis;
    box = sqrt((((_e302 * _e303) + ((_e310.yx * ((_e305 * _e306) * _e308)) * _e313.yx)) * _e301));
    let _e319 = open;
    phi_332_ = _e319;
    if _e319 {
        let _e321 = from_[0u];
        let _e324 = box[0u];
        phi_332_ = (abs(_e321) < (_e324 + 1.5f));
    }
    let _e328 = phi_332_;
    phi_342_ = _e328;
    if _e328 {
        let _e330 = from_[1u];
        let _e333 = box[1u];
        phi_342_ = (abs(_e330) < (_e333 + 1.5f));
    }
    let _e337 = phi_342_;
    if !(_e337) {
        return;
    }
    let _e339 = inverse;
    let _e341 = axis;
    along = (_e341 * (0.8493218f * _e339));
    let _e343 = inverse;
    let _e346 = shorter;
    let _e349 = axis[1u];
    let _e352 = axis[0u];
    across = (vec2<f32>(-(_e349), _e352) * ((0.8493218f * sqrt(_e343)) / _e346));
    let _e356 = along[0u];
    let _e358 = across[0u];
    right = vec2<f32>(_e356, _e358);
    let _e360 = right;
    let _e361 = right;
    bend = exp2((-2f * dot(_e360, _e361)));
    let _e366 = (*words)[0u];
    param_13 = _e366;
    param_14 = 1073741824u;
    let _e367 = number_u0028_u1_u003b_u1_u003b((&param_13), (&param_14));
    let _e370 = (*words)[0u];
    low = ((_e367 / 1073741800f) + select(0f, 2f, (bitcast<i32>(_e370) < 0i)));
    let _e376 = (*words)[3u];
    param_15 = _e376;
    param_16 = 2130706432u;
    let _e377 = number_u0028_u1_u003b_u1_u003b((&param_15), (&param_16));
    let _e380 = (*words)[3u];
    high = ((_e377 / 16777216f) + select(0f, 128f, (bitcast<i32>(_e380) < 0i)));
    let _e386 = (*words)[0u];
    param_17 = _e386;
    param_18 = 1072693248u;
    let _e387 = number_u0028_u1_u003b_u1_u003b((&param_17), (&param_18));
    let _e390 = (*words)[1u];
    param_19 = _e390;
    param_20 = 1072693248u;
    let _e391 = number_u0028_u1_u003b_u1_u003b((&param_19), (&param_20));
    let _e393 = high;
    let _e395 = low;
    color = vec3<f32>((_e387 * 0.000000000932233f), (_e391 * 0.000000000932233f), (((4f * _e393) + _e395) / 1023f));
    let _e399 = opacity;
    opacity = (_e399 / 255f);
    let _e401 = from_;
    from_ = (_e401 - vec2(1.5f));
    let _e404 = from_;
    let _e405 = along;
    let _e407 = from_;
    let _e408 = across;
    deviation = vec2<f32>(dot(_e404, _e405), dot(_e407, _e408));
    most = 0f;
    let _e411 = deviation;
    let _e412 = deviation;
    weight = exp2(-(dot(_e411, _e412)));
    let _e416 = opacity;
    let _e417 = weight;
    let _e419 = weight;
    alpha = select(0f, (_e416 * _e417), (_e419 >= 0.00000000000000001f));
    let _e422 = deviation;
    let _e424 = right;
    let _e426 = right;
    param_21 = -(dot(((_e422 * 2f) + _e424), _e426));
    param_22 = 60f;
    let _e429 = smaller_u0028_f1_u003b_f1_u003b((&param_21), (&param_22));
    factor = exp2(_e429);
    let _e431 = alpha;
    param_23 = _e431;
    param_24 = 0.99f;
    let _e432 = smaller_u0028_f1_u003b_f1_u003b((&param_23), (&param_24));
    covers = _e432;
    let _e434 = pixels[0i];
    pixel = _e434;
    let _e435 = covers;
    let _e437 = pixel[3u];
    let _e439 = covers;
    let _e440 = least;
    share = select(0f, (_e435 * _e437), (_e439 >= _e440));
    let _e443 = pixel;
    let _e445 = share;
    let _e446 = color;
    let _e448 = (_e443.xyz + (_e446 * _e445));
    let _e450 = pixel[3u];
    let _e451 = share;
    pixel = vec4<f32>(_e448.x, _e448.y, _e448.z, (_e450 - _e451));
    let _e457 = pixel;
    pixels[0i] = _e457;
    let _e459 = most;
    param_25 = _e459;
    let _e461 = pixel[3u];
    param_26 = _e461;
    let _e462 = larger_u0028_f1_u003b_f1_u003b((&param_25), (&param_26));
    most = _e462;
    let _e463 = factor;
    let _e464 = alpha;
    alpha = (_e464 * _e463);
    let _e466 = bend;
    let _e467 = factor;
    factor = (_e467 * _e466);
    let _e469 = alpha;
    param_27 = _e469;
    param_28 = 0.99f;
    let _e470 = smaller_u0028_f1_u003b_f1_u003b((&param_27), (&param_28));
    covers_1 = _e470;
    let _e472 = pixels[1i];
    pixel_1 = _e472;
    let _e473 = covers_1;
    let _e475 = pixel_1[3u];
    let _e477 = covers_1;
    let _e478 = least;
    share_1 = select(0f, (_e473 * _e475), (_e477 >= _e478));
    let _e481 = pixel_1;
    let _e483 = share_1;
    let _e484 = color;
    let _e486 = (_e481.xyz + (_e484 * _e483));
    let _e488 = pixel_1[3u];
    let _e489 = share_1;
    pixel_1 = vec4<f32>(_e486.x, _e486.y, _e486.z, (_e488 - _e489));
    let _e495 = pixel_1;
    pixels[1i] = _e495;
    let _e497 = most;
    param_29 = _e497;
    let _e499 = pixel_1[3u];
    param_30 = _e499;
    let _e500 = larger_u0028_f1_u003b_f1_u003b((&param_29), (&param_30));
    most = _e500;
    let _e501 = factor;
    let _e502 = alpha;
    alpha = (_e502 * _e501);
    let _e504 = bend;
    let _e505 = factor;
    factor = (_e505 * _e504);
    let _e507 = alpha;
    param_31 = _e507;
    param_32 = 0.99f;
    let _e508 = smaller_u0028_f1_u003b_f1_u003b((&param_31), (&param_32));
    covers_2 = _e508;
    let _e510 = pixels[2i];
    pixel_2 = _e510;
    let _e511 = covers_2;
    let _e513 = pixel_2[3u];
    let _e515 = covers_2;
    let _e516 = least;
    share_2 = select(0f, (_e511 * _e513), (_e515 >= _e516));
    let _e519 = pixel_2;
    let _e521 = share_2;
    let _e522 = color;
    let _e524 = (_e519.xyz + (_e522 * _e521));
    let _e526 = pixel_2[3u];
    let _e527 = share_2;
    pixel_2 = vec4<f32>(_e524.x, _e524.y, _e524.z, (_e526 - _e527));
    let _e533 = pixel_2;
    pixels[2i] = _e533;
    let _e535 = most;
    param_33 = _e535;
    let _e537 = pixel_2[3u];
    param_34 = _e537;
    let _e538 = larger_u0028_f1_u003b_f1_u003b((&param_33), (&param_34));
    most = _e538;
    let _e539 = factor;
    let _e540 = alpha;
    alpha = (_e540 * _e539);
    let _e542 = bend;
    let _e543 = factor;
    factor = (_e543 * _e542);
    let _e545 = alpha;
    param_35 = _e545;
    param_36 = 0.99f;
    let _e546 = smaller_u0028_f1_u003b_f1_u003b((&param_35), (&param_36));
    covers_3 = _e546;
    let _e548 = pixels[3i];
    pixel_3 = _e548;
    let _e549 = covers_3;
    let _e551 = pixel_3[3u];
    let _e553 = covers_3;
    let _e554 = least;
    share_3 = select(0f, (_e549 * _e551), (_e553 >= _e554));
    let _e557 = pixel_3;
    let _e559 = share_3;
    let _e560 = color;
    let _e562 = (_e557.xyz + (_e560 * _e559));
    let _e564 = pixel_3[3u];
    let _e565 = share_3;
    pixel_3 = vec4<f32>(_e562.x, _e562.y, _e562.z, (_e564 - _e565));
    let _e571 = pixel_3;
    pixels[3i] = _e571;
    let _e573 = most;
    param_37 = _e573;
    let _e575 = pixel_3[3u];
    param_38 = _e575;
    let _e576 = larger_u0028_f1_u003b_f1_u003b((&param_37), (&param_38));
    most = _e576;
    let _e577 = factor;
    let _e578 = alpha;
    alpha = (_e578 * _e577);
    let _e580 = bend;
    let _e581 = factor;
    factor = (_e581 * _e580);
    let _e584 = along[1u];
    let _e586 = across[1u];
    let _e588 = deviation;
    deviation = (_e588 + vec2<f32>(_e584, _e586));
    let _e590 = deviation;
    let _e591 = deviation;
    weight_1 = exp2(-(dot(_e590, _e591)));
    let _e595 = opacity;
    let _e596 = weight_1;
    let _e598 = weight_1;
    alpha_1 = select(0f, (_e595 * _e596), (_e598 >= 0.00000000000000001f));
    let _e601 = deviation;
    let _e603 = right;
    let _e605 = right;
    param_39 = -(dot(((_e601 * 2f) + _e603), _e605));
    param_40 = 60f;
    let _e608 = smaller_u0028_f1_u003b_f1_u003b((&param_39), (&param_40));
    factor_1 = exp2(_e608);
    let _e610 = alpha_1;
    param_41 = _e610;
    param_42 = 0.99f;
    let _e611 = smaller_u0028_f1_u003b_f1_u003b((&param_41), (&param_42));
    covers_4 = _e611;
    let _e613 = pixels[4i];
    pixel_4 = _e613;
    let _e614 = covers_4;
    let _e616 = pixel_4[3u];
    let _e618 = covers_4;
    let _e619 = least;
    share_4 = select(0f, (_e614 * _e616), (_e618 >= _e619));
    let _e622 = pixel_4;
    let _e624 = share_4;
    let _e625 = color;
    let _e627 = (_e622.xyz + (_e625 * _e624));
    let _e629 = pixel_4[3u];
    let _e630 = share_4;
    pixel_4 = vec4<f32>(_e627.x, _e627.y, _e627.z, (_e629 - _e630));
    let _e636 = pixel_4;
    pixels[4i] = _e636;
    let _e638 = most;
    param_43 = _e638;
    let _e640 = pixel_4[3u];
    param_44 = _e640;
    let _e641 = larger_u0028_f1_u003b_f1_u003b((&param_43), (&param_44));
    most = _e641;
    let _e642 = factor_1;
    let _e643 = alpha_1;
    alpha_1 = (_e643 * _e642);
    let _e645 = bend;
    let _e646 = factor_1;
    factor_1 = (_e646 * _e645);
    let _e648 = alpha_1;
    param_45 = _e648;
    param_46 = 0.99f;
    let _e649 = smaller_u0028_f1_u003b_f1_u003b((&param_45), (&param_46));
    covers_5 = _e649;
    let _e651 = pixels[5i];
    pixel_5 = _e651;
    let _e652 = covers_5;
    let _e654 = pixel_5[3u];
    let _e656 = covers_5;
    let _e657 = least;
    share_5 = select(0f, (_e652 * _e654), (_e656 >= _e657));
    let _e660 = pixel_5;
    let _e662 = share_5;
    let _e663 = color;
    let _e665 = (_e660.xyz + (_e663 * _e662));
    let _e667 = pixel_5[3u];
    let _e668 = share_5;
    pixel_5 = vec4<f32>(_e665.x, _e665.y, _e665.z, (_e667 - _e668));
    let _e674 = pixel_5;
    pixels[5i] = _e674;
    let _e676 = most;
    param_47 = _e676;
    let _e678 = pixel_5[3u];
    param_48 = _e678;
    let _e679 = larger_u0028_f1_u003b_f1_u003b((&param_47), (&param_48));
    most = _e679;
    let _e680 = factor_1;
    let _e681 = alpha_1;
    alpha_1 = (_e681 * _e680);
    let _e683 = bend;
    let _e684 = factor_1;
    factor_1 = (_e684 * _e683);
    let _e686 = alpha_1;
    param_49 = _e686;
    param_50 = 0.99f;
    let _e687 = smaller_u0028_f1_u003b_f1_u003b((&param_49), (&param_50));
    covers_6 = _e687;
    let _e689 = pixels[6i];
    pixel_6 = _e689;
    let _e690 = covers_6;
    let _e692 = pixel_6[3u];
    let _e694 = covers_6;
    let _e695 = least;
    share_6 = select(0f, (_e690 * _e692), (_e694 >= _e695));
    let _e698 = pixel_6;
    let _e700 = share_6;
    let _e701 = color;
    let _e703 = (_e698.xyz + (_e701 * _e700));
    let _e705 = pixel_6[3u];
    let _e706 = share_6;
    pixel_6 = vec4<f32>(_e703.x, _e703.y, _e703.z, (_e705 - _e706));
    let _e712 = pixel_6;
    pixels[6i] = _e712;
    let _e714 = most;
    param_51 = _e714;
    let _e716 = pixel_6[3u];
    param_52 = _e716;
    let _e717 = larger_u0028_f1_u003b_f1_u003b((&param_51), (&param_52));
    most = _e717;
    let _e718 = factor_1;
    let _e719 = alpha_1;
    alpha_1 = (_e719 * _e718);
    let _e721 = bend;
    let _e722 = factor_1;
    factor_1 = (_e722 * _e721);
    let _e724 = alpha_1;
    param_53 = _e724;
    param_54 = 0.99f;
    let _e725 = smaller_u0028_f1_u003b_f1_u003b((&param_53), (&param_54));
    covers_7 = _e725;
    let _e727 = pixels[7i];
    pixel_7 = _e727;
    let _e728 = covers_7;
    let _e730 = pixel_7[3u];
    let _e732 = covers_7;
    let _e733 = least;
    share_7 = select(0f, (_e728 * _e730), (_e732 >= _e733));
    let _e736 = pixel_7;
    let _e738 = share_7;
    let _e739 = color;
    let _e741 = (_e736.xyz + (_e739 * _e738));
    let _e743 = pixel_7[3u];
    let _e744 = share_7;
    pixel_7 = vec4<f32>(_e741.x, _e741.y, _e741.z, (_e743 - _e744));
    let _e750 = pixel_7;
    pixels[7i] = _e750;
    let _e752 = most;
    param_55 = _e752;
    let _e754 = pixel_7[3u];
    param_56 = _e754;
    let _e755 = larger_u0028_f1_u003b_f1_u003b((&param_55), (&param_56));
    most = _e755;
    let _e756 = factor_1;
    let _e757 = alpha_1;
    alpha_1 = (_e757 * _e756);
    let _e759 = bend;
    let _e760 = factor_1;
    factor_1 = (_e760 * _e759);
    let _e763 = along[1u];
    let _e765 = across[1u];
    let _e767 = deviation;
    deviation = (_e767 + vec2<f32>(_e763, _e765));
    let _e769 = deviation;
    let _e770 = deviation;
    weight_2 = exp2(-(dot(_e769, _e770)));
    let _e774 = opacity;
    let _e775 = weight_2;
    let _e777 = weight_2;
    alpha_2 = select(0f, (_e774 * _e775), (_e777 >= 0.00000000000000001f));
    let _e780 = deviation;
    let _e782 = right;
    let _e784 = right;
    param_57 = -(dot(((_e780 * 2f) + _e782), _e784));
    param_58 = 60f;
    let _e787 = smaller_u0028_f1_u003b_f1_u003b((&param_57), (&param_58));
    factor_2 = exp2(_e787);
    let _e789 = alpha_2;
    param_59 = _e789;
    param_60 = 0.99f;
    let _e790 = smaller_u0028_f1_u003b_f1_u003b((&param_59), (&param_60));
    covers_8 = _e790;
    let _e792 = pixels[8i];
    pixel_8 = _e792;
    let _e793 = covers_8;
    let _e795 = pixel_8[3u];
    let _e797 = covers_8;
    let _e798 = least;
    share_8 = select(0f, (_e793 * _e795), (_e797 >= _e798));
    let _e801 = pixel_8;
    let _e803 = share_8;
    let _e804 = color;
    let _e806 = (_e801.xyz + (_e804 * _e803));
    let _e808 = pixel_8[3u];
    let _e809 = share_8;
    pixel_8 = vec4<f32>(_e806.x, _e806.y, _e806.z, (_e808 - _e809));
    let _e815 = pixel_8;
    pixels[8i] = _e815;
    let _e817 = most;
    param_61 = _e817;
    let _e819 = pixel_8[3u];
    param_62 = _e819;
    let _e820 = larger_u0028_f1_u003b_f1_u003b((&param_61), (&param_62));
    most = _e820;
    let _e821 = factor_2;
    let _e822 = alpha_2;
    alpha_2 = (_e822 * _e821);
    let _e824 = bend;
    let _e825 = factor_2;
    factor_2 = (_e825 * _e824);
    let _e827 = alpha_2;
    param_63 = _e827;
    param_64 = 0.99f;
    let _e828 = smaller_u0028_f1_u003b_f1_u003b((&param_63), (&param_64));
    covers_9 = _e828;
    let _e830 = pixels[9i];
    pixel_9 = _e830;
    let _e831 = covers_9;
    let _e833 = pixel_9[3u];
    let _e835 = covers_9;
    let _e836 = least;
    share_9 = select(0f, (_e831 * _e833), (_e835 >= _e836));
    let _e839 = pixel_9;
    let _e841 = share_9;
    let _e842 = color;
    let _e844 = (_e839.xyz + (_e842 * _e841));
    let _e846 = pixel_9[3u];
    let _e847 = share_9;
    pixel_9 = vec4<f32>(_e844.x, _e844.y, _e844.z, (_e846 - _e847));
    let _e853 = pixel_9;
    pixels[9i] = _e853;
    let _e855 = most;
    param_65 = _e855;
    let _e857 = pixel_9[3u];
    param_66 = _e857;
    let _e858 = larger_u0028_f1_u003b_f1_u003b((&param_65), (&param_66));
    most = _e858;
    let _e859 = factor_2;
    let _e860 = alpha_2;
    alpha_2 = (_e860 * _e859);
    let _e862 = bend;
    let _e863 = factor_2;
    factor_2 = (_e863 * _e862);
    let _e865 = alpha_2;
    param_67 = _e865;
    param_68 = 0.99f;
    let _e866 = smaller_u0028_f1_u003b_f1_u003b((&param_67), (&param_68));
    covers_10 = _e866;
    let _e868 = pixels[10i];
    pixel_10 = _e868;
    let _e869 = covers_10;
    let _e871 = pixel_10[3u];
    let _e873 = covers_10;
    let _e874 = least;
    share_10 = select(0f, (_e869 * _e871), (_e873 >= _e874));
    let _e877 = pixel_10;
    let _e879 = share_10;
    let _e880 = color;
    let _e882 = (_e877.xyz + (_e880 * _e879));
    let _e884 = pixel_10[3u];
    let _e885 = share_10;
    pixel_10 = vec4<f32>(_e882.x, _e882.y, _e882.z, (_e884 - _e885));
    let _e891 = pixel_10;
    pixels[10i] = _e891;
    let _e893 = most;
    param_69 = _e893;
    let _e895 = pixel_10[3u];
    param_70 = _e895;
    let _e896 = larger_u0028_f1_u003b_f1_u003b((&param_69), (&param_70));
    most = _e896;
    let _e897 = factor_2;
    let _e898 = alpha_2;
    alpha_2 = (_e898 * _e897);
    let _e900 = bend;
    let _e901 = factor_2;
    factor_2 = (_e901 * _e900);
    let _e903 = alpha_2;
    param_71 = _e903;
    param_72 = 0.99f;
    let _e904 = smaller_u0028_f1_u003b_f1_u003b((&param_71), (&param_72));
    covers_11 = _e904;
    let _e906 = pixels[11i];
    pixel_11 = _e906;
    let _e907 = covers_11;
    let _e909 = pixel_11[3u];
    let _e911 = covers_11;
    let _e912 = least;
    share_11 = select(0f, (_e907 * _e909), (_e911 >= _e912));
    let _e915 = pixel_11;
    let _e917 = share_11;
    let _e918 = color;
    let _e920 = (_e915.xyz + (_e918 * _e917));
    let _e922 = pixel_11[3u];
    let _e923 = share_11;
    pixel_11 = vec4<f32>(_e920.x, _e920.y, _e920.z, (_e922 - _e923));
    let _e929 = pixel_11;
    pixels[11i] = _e929;
    let _e931 = most;
    param_73 = _e931;
    let _e933 = pixel_11[3u];
    param_74 = _e933;
    let _e934 = larger_u0028_f1_u003b_f1_u003b((&param_73), (&param_74));
    most = _e934;
    let _e935 = factor_2;
    let _e936 = alpha_2;
    alpha_2 = (_e936 * _e935);
    let _e938 = bend;
    let _e939 = factor_2;
    factor_2 = (_e939 * _e938);
    let _e942 = along[1u];
    let _e944 = across[1u];
    let _e946 = deviation;
    deviation = (_e946 + vec2<f32>(_e942, _e944));
    let _e948 = deviation;
    let _e949 = deviation;
    weight_3 = exp2(-(dot(_e948, _e949)));
    let _e953 = opacity;
    let _e954 = weight_3;
    let _e956 = weight_3;
    alpha_3 = select(0f, (_e953 * _e954), (_e956 >= 0.00000000000000001f));
    let _e959 = deviation;
    let _e961 = right;
    let _e963 = right;
    param_75 = -(dot(((_e959 * 2f) + _e961), _e963));
    param_76 = 60f;
    let _e966 = smaller_u0028_f1_u003b_f1_u003b((&param_75), (&param_76));
    factor_3 = exp2(_e966);
    let _e968 = alpha_3;
    param_77 = _e968;
    param_78 = 0.99f;
    let _e969 = smaller_u0028_f1_u003b_f1_u003b((&param_77), (&param_78));
    covers_12 = _e969;
    let _e971 = pixels[12i];
    pixel_12 = _e971;
    let _e972 = covers_12;
    let _e974 = pixel_12[3u];
    let _e976 = covers_12;
    let _e977 = least;
    share_12 = select(0f, (_e972 * _e974), (_e976 >= _e977));
    let _e980 = pixel_12;
    let _e982 = share_12;
    let _e983 = color;
    let _e985 = (_e980.xyz + (_e983 * _e982));
    let _e987 = pixel_12[3u];
    let _e988 = share_12;
    pixel_12 = vec4<f32>(_e985.x, _e985.y, _e985.z, (_e987 - _e988));
    let _e994 = pixel_12;
    pixels[12i] = _e994;
    let _e996 = most;
    param_79 = _e996;
    let _e998 = pixel_12[3u];
    param_80 = _e998;
    let _e999 = larger_u0028_f1_u003b_f1_u003b((&param_79), (&param_80));
    most = _e999;
    let _e1000 = factor_3;
    let _e1001 = alpha_3;
    alpha_3 = (_e1001 * _e1000);
    let _e1003 = bend;
    let _e1004 = factor_3;
    factor_3 = (_e1004 * _e1003);
    let _e1006 = alpha_3;
    param_81 = _e1006;
    param_82 = 0.99f;
    let _e1007 = smaller_u0028_f1_u003b_f1_u003b((&param_81), (&param_82));
    covers_13 = _e1007;
    let _e1009 = pixels[13i];
    pixel_13 = _e1009;
    let _e1010 = covers_13;
    let _e1012 = pixel_13[3u];
    let _e1014 = covers_13;
    let _e1015 = least;
    share_13 = select(0f, (_e1010 * _e1012), (_e1014 >= _e1015));
    let _e1018 = pixel_13;
    let _e1020 = share_13;
    let _e1021 = color;
    let _e1023 = (_e1018.xyz + (_e1021 * _e1020));
    let _e1025 = pixel_13[3u];
    let _e1026 = share_13;
    pixel_13 = vec4<f32>(_e1023.x, _e1023.y, _e1023.z, (_e1025 - _e1026));
    let _e1032 = pixel_13;
    pixels[13i] = _e1032;
    let _e1034 = most;
    param_83 = _e1034;
    let _e1036 = pixel_13[3u];
    param_84 = _e1036;
    let _e1037 = larger_u0028_f1_u003b_f1_u003b((&param_83), (&param_84));
    most = _e1037;
    let _e1038 = factor_3;
    let _e1039 = alpha_3;
    alpha_3 = (_e1039 * _e1038);
    let _e1041 = bend;
    let _e1042 = factor_3;
    factor_3 = (_e1042 * _e1041);
    let _e1044 = alpha_3;
    param_85 = _e1044;
    param_86 = 0.99f;
    let _e1045 = smaller_u0028_f1_u003b_f1_u003b((&param_85), (&param_86));
    covers_14 = _e1045;
    let _e1047 = pixels[14i];
    pixel_14 = _e1047;
    let _e1048 = covers_14;
    let _e1050 = pixel_14[3u];
    let _e1052 = covers_14;
    let _e1053 = least;
    share_14 = select(0f, (_e1048 * _e1050), (_e1052 >= _e1053));
    let _e1056 = pixel_14;
    let _e1058 = share_14;
    let _e1059 = color;
    let _e1061 = (_e1056.xyz + (_e1059 * _e1058));
    let _e1063 = pixel_14[3u];
    let _e1064 = share_14;
    pixel_14 = vec4<f32>(_e1061.x, _e1061.y, _e1061.z, (_e1063 - _e1064));
    let _e1070 = pixel_14;
    pixels[14i] = _e1070;
    let _e1072 = most;
    param_87 = _e1072;
    let _e1074 = pixel_14[3u];
    param_88 = _e1074;
    let _e1075 = larger_u0028_f1_u003b_f1_u003b((&param_87), (&param_88));
    most = _e1075;
    let _e1076 = factor_3;
    let _e1077 = alpha_3;
    alpha_3 = (_e1077 * _e1076);
    let _e1079 = bend;
    let _e1080 = factor_3;
    factor_3 = (_e1080 * _e1079);
    let _e1082 = alpha_3;
    param_89 = _e1082;
    param_90 = 0.99f;
    let _e1083 = smaller_u0028_f1_u003b_f1_u003b((&param_89), (&param_90));
    covers_15 = _e1083;
    let _e1085 = pixels[15i];
    pixel_15 = _e1085;
    let _e1086 = covers_15;
    let _e1088 = pixel_15[3u];
    let _e1090 = covers_15;
    let _e1091 = least;
    share_15 = select(0f, (_e1086 * _e1088), (_e1090 >= _e1091));
    let _e1094 = pixel_15;
    let _e1096 = share_15;
    let _e1097 = color;
    let _e1099 = (_e1094.xyz + (_e1097 * _e1096));
    let _e1101 = pixel_15[3u];
    let _e1102 = share_15;
    pixel_15 = vec4<f32>(_e1099.x, _e1099.y, _e1099.z, (_e1101 - _e1102));
    let _e1108 = pixel_15;
    pixels[15i] = _e1108;
    let _e1110 = most;
    param_91 = _e1110;
    let _e1112 = pixel_15[3u];
    param_92 = _e1112;
    let _e1113 = larger_u0028_f1_u003b_f1_u003b((&param_91), (&param_92));
    most = _e1113;
    let _e1114 = factor_3;
    let _e1115 = alpha_3;
    alpha_3 = (_e1115 * _e1114);
    let _e1117 = bend;
    let _e1118 = factor_3;
    factor_3 = (_e1118 * _e1117);
    let _e1121 = along[1u];
    let _e1123 = across[1u];
    let _e1125 = deviation;
    deviation = (_e1125 + vec2<f32>(_e1121, _e1123));
    let _e1127 = shaded;
    shaded = (_e1127 + 16u);
    let _e1129 = most;
    let _e1130 = full;
    open = (_e1129 >= _e1130);
    return;
}

fn step_back_u0028_u1_u003b(chain: ptr<function, u32>) -> u32 {
    var local: u32;

    let _e92 = (*chain);
    if ((_e92 & 7u) > 1u) {
        let _e95 = (*chain);
        local = (_e95 - 1u);
    } else {
        let _e97 = (*chain);
        let _e102 = unnamed_1.bins[((576602u + _e97) - 1u)];
        local = _e102;
    }
    let _e103 = local;
    return _e103;
}

fn key_at_u0028_u1_u003b(i: ptr<function, u32>) -> u32 {
    let _e91 = (*i);
    let _e96 = unnamed.keys[(_e91 >> bitcast<u32>(1u))];
    let _e97 = (*i);
    return ((_e96 >> bitcast<u32>((16u * (_e97 & 1u)))) & 65535u);
}

fn bins_tile_u0028_u1_u003b_vu2_u003b(level: ptr<function, u32>, at: ptr<function, vec2<u32>>) -> u32 {
    let _e92 = (*level);
    let _e100 = (*at)[1u];
    let _e101 = (*level);
    let _e108 = (*at)[0u];
    return (((((16384u - (16384u >> bitcast<u32>((4u * _e92)))) / 15u) * 16u) + (_e100 * (128u >> bitcast<u32>((2u * _e101))))) + _e108);
}

fn blend_tiles_u0028_vu2_u003b(at_1: ptr<function, vec2<u32>>) {
    var tiles: vec4<u32>;
    var param_93: u32;
    var param_94: vec2<u32>;
    var param_95: u32;
    var param_96: vec2<u32>;
    var param_97: u32;
    var param_98: vec2<u32>;
    var param_99: u32;
    var param_100: vec2<u32>;
    var blocks: u32;
    var chains: vec4<u32>;
    var first: vec4<u32>;
    var keys: vec4<u32>;
    var going: bool;
    var block: u32;
    var param_101: u32;
    var param_102: u32;
    var param_103: u32;
    var param_104: u32;
    var splat: u32;
    var key: u32;
    var chain_1: u32;
    var take: vec4<bool>;
    var rest: u32;
    var param_105: u32;
    var next: u32;
    var local_1: u32;
    var after: u32;
    var local_2: u32;
    var param_106: u32;
    var param_107: vec4<u32>;
    var phi_1517_: bool;
    var phi_1531_: bool;
    var phi_1532_: bool;
    var phi_1533_: bool;
    var phi_1556_: bool;
    var phi_1570_: bool;
    var phi_1571_: bool;
    var phi_1572_: bool;
    var phi_1595_: bool;
    var phi_1609_: bool;
    var phi_1610_: bool;
    var phi_1611_: bool;
    var phi_1634_: bool;
    var phi_1648_: bool;
    var phi_1649_: bool;
    var phi_1650_: bool;
    var phi_1751_: bool;

    param_93 = 0u;
    let _e122 = (*at_1);
    param_94 = _e122;
    let _e123 = bins_tile_u0028_u1_u003b_vu2_u003b((&param_93), (&param_94));
    let _e124 = (*at_1);
    param_95 = 1u;
    param_96 = (_e124 >> bitcast<vec2<u32>>(vec2(2u)));
    let _e128 = bins_tile_u0028_u1_u003b_vu2_u003b((&param_95), (&param_96));
    let _e129 = (*at_1);
    param_97 = 2u;
    param_98 = (_e129 >> bitcast<vec2<u32>>(vec2(4u)));
    let _e133 = bins_tile_u0028_u1_u003b_vu2_u003b((&param_97), (&param_98));
    param_99 = 3u;
    param_100 = vec2<u32>(0u, 0u);
    let _e134 = bins_tile_u0028_u1_u003b_vu2_u003b((&param_99), (&param_100));
    tiles = vec4<u32>(_e123, _e128, _e133, _e134);
    let _e137 = tiles[0u];
    let _e141 = unnamed_1.bins[(1u + _e137)];
    let _e143 = tiles[1u];
    let _e147 = unnamed_1.bins[(1u + _e143)];
    let _e150 = tiles[2u];
    let _e154 = unnamed_1.bins[(1u + _e150)];
    let _e157 = tiles[3u];
    let _e161 = unnamed_1.bins[(1u + _e157)];
    blocks = (((_e141 | _e147) | _e154) | _e161);
    chains = vec4<u32>(0u, 0u, 0u, 0u);
    first = vec4<u32>(0u, 0u, 0u, 0u);
    keys = vec4<u32>(0u, 0u, 0u, 0u);
    let _e163 = blocks;
    going = (_e163 != 0u);
    loop {
        let _e165 = going;
        if _e165 {
            let _e166 = chains;
            if all((_e166 == vec4<u32>(0u, 0u, 0u, 0u))) {
                let _e169 = blocks;
                block = bitcast<u32>(firstLeadingBit(_e169));
                let _e172 = block;
                let _e175 = blocks;
                blocks = (_e175 ^ (1u << bitcast<u32>(_e172)));
                let _e178 = tiles[0u];
                let _e181 = block;
                let _e185 = unnamed_1.bins[((17474u + (_e178 * 32u)) + _e181)];
                chains[0u] = _e185;
                let _e188 = tiles[1u];
                let _e191 = block;
                let _e195 = unnamed_1.bins[((17474u + (_e188 * 32u)) + _e191)];
                chains[1u] = _e195;
                let _e198 = tiles[2u];
                let _e201 = block;
                let _e205 = unnamed_1.bins[((17474u + (_e198 * 32u)) + _e201)];
                chains[2u] = _e205;
                let _e208 = tiles[3u];
                let _e211 = block;
                let _e215 = unnamed_1.bins[((17474u + (_e208 * 32u)) + _e211)];
                chains[3u] = _e215;
                let _e218 = chains[0u];
                if (_e218 != 0u) {
                    let _e221 = chains[0u];
                    let _e225 = unnamed_1.bins[(576602u + _e221)];
                    first[0u] = _e225;
                    let _e228 = first[0u];
                    param_101 = _e228;
                    let _e229 = key_at_u0028_u1_u003b((&param_101));
                    keys[0u] = _e229;
                }
                let _e232 = chains[1u];
                if (_e232 != 0u) {
                    let _e235 = chains[1u];
                    let _e239 = unnamed_1.bins[(576602u + _e235)];
                    first[1u] = _e239;
                    let _e242 = first[1u];
                    param_102 = _e242;
                    let _e243 = key_at_u0028_u1_u003b((&param_102));
                    keys[1u] = _e243;
                }
                let _e246 = chains[2u];
                if (_e246 != 0u) {
                    let _e249 = chains[2u];
                    let _e253 = unnamed_1.bins[(576602u + _e249)];
                    first[2u] = _e253;
                    let _e256 = first[2u];
                    param_103 = _e256;
                    let _e257 = key_at_u0028_u1_u003b((&param_103));
                    keys[2u] = _e257;
                }
                let _e260 = chains[3u];
                if (_e260 != 0u) {
                    let _e263 = chains[3u];
                    let _e267 = unnamed_1.bins[(576602u + _e263)];
                    first[3u] = _e267;
                    let _e270 = first[3u];
                    param_104 = _e270;
                    let _e271 = key_at_u0028_u1_u003b((&param_104));
                    keys[3u] = _e271;
                }
            }
            splat = 0u;
            key = 0u;
            chain_1 = 0u;
            let _e274 = chains[0u];
            let _e275 = (_e274 != 0u);
            phi_1533_ = _e275;
            if _e275 {
                let _e276 = chain_1;
                let _e277 = (_e276 == 0u);
                phi_1517_ = _e277;
                if !(_e277) {
                    let _e280 = keys[0u];
                    let _e281 = key;
                    phi_1517_ = (_e280 > _e281);
                }
                let _e284 = phi_1517_;
                phi_1532_ = _e284;
                if !(_e284) {
                    let _e287 = keys[0u];
                    let _e288 = key;
                    let _e289 = (_e287 == _e288);
                    phi_1531_ = _e289;
                    if _e289 {
                        let _e291 = first[0u];
                        let _e292 = splat;
                        phi_1531_ = (_e291 > _e292);
                    }
                    let _e295 = phi_1531_;
                    phi_1532_ = _e295;
                }
                let _e297 = phi_1532_;
                phi_1533_ = _e297;
            }
            let _e299 = phi_1533_;
            if _e299 {
                let _e301 = chains[0u];
                chain_1 = _e301;
                let _e303 = first[0u];
                splat = _e303;
                let _e305 = keys[0u];
                key = _e305;
            }
            let _e307 = chains[1u];
            let _e308 = (_e307 != 0u);
            phi_1572_ = _e308;
            if _e308 {
                let _e309 = chain_1;
                let _e310 = (_e309 == 0u);
                phi_1556_ = _e310;
                if !(_e310) {
                    let _e313 = keys[1u];
                    let _e314 = key;
                    phi_1556_ = (_e313 > _e314);
                }
                let _e317 = phi_1556_;
                phi_1571_ = _e317;
                if !(_e317) {
                    let _e320 = keys[1u];
                    let _e321 = key;
                    let _e322 = (_e320 == _e321);
                    phi_1570_ = _e322;
                    if _e322 {
                        let _e324 = first[1u];
                        let _e325 = splat;
                        phi_1570_ = (_e324 > _e325);
                    }
                    let _e328 = phi_1570_;
                    phi_1571_ = _e328;
                }
                let _e330 = phi_1571_;
                phi_1572_ = _e330;
            }
            let _e332 = phi_1572_;
            if _e332 {
                let _e334 = chains[1u];
                chain_1 = _e334;
                let _e336 = first[1u];
                splat = _e336;
                let _e338 = keys[1u];
                key = _e338;
            }
            let _e340 = chains[2u];
            let _e341 = (_e340 != 0u);
            phi_1611_ = _e341;
            if _e341 {
                let _e342 = chain_1;
                let _e343 = (_e342 == 0u);
                phi_1595_ = _e343;
                if !(_e343) {
                    let _e346 = keys[2u];
                    let _e347 = key;
                    phi_1595_ = (_e346 > _e347);
                }
                let _e350 = phi_1595_;
                phi_1610_ = _e350;
                if !(_e350) {
                    let _e353 = keys[2u];
                    let _e354 = key;
                    let _e355 = (_e353 == _e354);
                    phi_1609_ = _e355;
                    if _e355 {
                        let _e357 = first[2u];
                        let _e358 = splat;
                        phi_1609_ = (_e357 > _e358);
                    }
                    let _e361 = phi_1609_;
                    phi_1610_ = _e361;
                }
                let _e363 = phi_1610_;
                phi_1611_ = _e363;
            }
            let _e365 = phi_1611_;
            if _e365 {
                let _e367 = chains[2u];
                chain_1 = _e367;
                let _e369 = first[2u];
                splat = _e369;
                let _e371 = keys[2u];
                key = _e371;
            }
            let _e373 = chains[3u];
            let _e374 = (_e373 != 0u);
            phi_1650_ = _e374;
            if _e374 {
                let _e375 = chain_1;
                let _e376 = (_e375 == 0u);
                phi_1634_ = _e376;
                if !(_e376) {
                    let _e379 = keys[3u];
                    let _e380 = key;
                    phi_1634_ = (_e379 > _e380);
                }
                let _e383 = phi_1634_;
                phi_1649_ = _e383;
                if !(_e383) {
                    let _e386 = keys[3u];
                    let _e387 = key;
                    let _e388 = (_e386 == _e387);
                    phi_1648_ = _e388;
                    if _e388 {
                        let _e390 = first[3u];
                        let _e391 = splat;
                        phi_1648_ = (_e390 > _e391);
                    }
                    let _e394 = phi_1648_;
                    phi_1649_ = _e394;
                }
                let _e396 = phi_1649_;
                phi_1650_ = _e396;
            }
            let _e398 = phi_1650_;
            if _e398 {
                let _e400 = chains[3u];
                chain_1 = _e400;
                let _e402 = first[3u];
                splat = _e402;
                let _e404 = keys[3u];
                key = _e404;
            }
            let _e405 = chains;
            let _e406 = chain_1;
            take = (_e405 == vec4(_e406));
            let _e409 = chain_1;
            param_105 = _e409;
            let _e410 = step_back_u0028_u1_u003b((&param_105));
            rest = _e410;
            let _e411 = rest;
            if (_e411 == 0u) {
                local_1 = 0u;
            } else {
                let _e413 = rest;
                let _e417 = unnamed_1.bins[(576602u + _e413)];
                local_1 = _e417;
            }
            let _e418 = local_1;
            next = _e418;
            let _e419 = rest;
            if (_e419 == 0u) {
                local_2 = 0u;
            } else {
                let _e421 = next;
                param_106 = _e421;
                let _e422 = key_at_u0028_u1_u003b((&param_106));
                local_2 = _e422;
            }
            let _e423 = local_2;
            after = _e423;
            let _e425 = take[0u];
            if _e425 {
                let _e426 = rest;
                chains[0u] = _e426;
                let _e428 = next;
                first[0u] = _e428;
                let _e430 = after;
                keys[0u] = _e430;
            }
            let _e433 = take[1u];
            if _e433 {
                let _e434 = rest;
                chains[1u] = _e434;
                let _e436 = next;
                first[1u] = _e436;
                let _e438 = after;
                keys[1u] = _e438;
            }
            let _e441 = take[2u];
            if _e441 {
                let _e442 = rest;
                chains[2u] = _e442;
                let _e444 = next;
                first[2u] = _e444;
                let _e446 = after;
                keys[2u] = _e446;
            }
            let _e449 = take[3u];
            if _e449 {
                let _e450 = rest;
                chains[3u] = _e450;
                let _e452 = next;
                first[3u] = _e452;
                let _e454 = after;
                keys[3u] = _e454;
            }
            let _e456 = splat;
            let _e459 = unnamed_2.splats[_e456];
            param_107 = _e459;
            put_u0028_vu4_u003b((&param_107));
        }
        let _e460 = open;
        phi_1751_ = _e460;
        if _e460 {
            let _e461 = blocks;
            let _e463 = chains;
            phi_1751_ = ((_e461 != 0u) || any((_e463 != vec4<u32>(0u, 0u, 0u, 0u))));
        }
        let _e468 = phi_1751_;
        going = _e468;
        continue;
        continuing {
            let _e469 = going;
            break if !(_e469);
        }
    }
    return;
}

fn begin_u0028_() -> u32 {
    let _e91 = frame.fixed_scale;
    fixed_scale = _e91;
    let _e93 = frame.guard;
    guard = _e93;
    let _e95 = frame.hull_opacity;
    hull_opacity = _e95;
    let _e97 = frame.cutoff;
    cutoff = _e97;
    let _e99 = settings.cutoff;
    least = _e99;
    let _e101 = settings.full;
    full = _e101;
    let _e102 = gl_LocalInvocationIndex_1;
    return _e102;
}

fn main_1() {
    var k: u32;
    var lane: u32;
    var place: vec2<u32>;
    var first_1: vec2<u32>;
    var param_108: vec2<u32>;
    var k_1: u32;
    var pixel_16: vec2<u32>;

    shaded = 0u;
    open = true;
    k = 0u;
    loop {
        let _e97 = k;
        if (_e97 < 16u) {
            let _e99 = k;
            pixels[_e99] = vec4<f32>(0f, 0f, 0f, 1f);
            continue;
        } else {
            break;
        }
        continuing {
            let _e101 = k;
            k = (_e101 + bitcast<u32>(1i));
        }
    }
    let _e104 = begin_u0028_();
    lane = _e104;
    let _e105 = lane;
    let _e107 = lane;
    let _e112 = lane;
    let _e117 = lane;
    let _e121 = lane;
    let _e126 = lane;
    place = vec2<u32>((((_e105 & 1u) | ((_e107 >> bitcast<u32>(1u)) & 2u)) | ((_e112 >> bitcast<u32>(2u)) & 4u)), ((((_e117 >> bitcast<u32>(1u)) & 1u) | ((_e121 >> bitcast<u32>(2u)) & 2u)) | ((_e126 >> bitcast<u32>(3u)) & 4u)));
    let _e133 = settings.first_region;
    let _e134 = gl_WorkGroupID_1;
    let _e139 = place;
    first_1 = (((_e133 + _e134.xy) * vec2(32u)) + (vec2(4u) * _e139));
    let _e143 = first_1;
    middle = (vec2<f32>(_e143) + vec2(2f));
    let _e147 = middle;
    let _e149 = frame.tile;
    param_108 = vec2<u32>((_e147 / vec2(_e149)));
    blend_tiles_u0028_vu2_u003b((&param_108));
    k_1 = 0u;
    loop {
        let _e153 = k_1;
        if (_e153 < 16u) {
            let _e155 = first_1;
            let _e156 = k_1;
            let _e158 = k_1;
            pixel_16 = (_e155 + vec2<u32>((_e156 % 4u), (_e158 / 4u)));
            let _e162 = pixel_16;
            let _e164 = frame.size;
            if all((_e162 < vec2<u32>(_e164))) {
                let _e168 = pixel_16;
                let _e170 = k_1;
                let _e172 = pixels[_e170];
                let _e173 = _e172.xyz;
                let _e174 = k_1;
                let _e177 = pixels[_e174][3u];
                textureStore(picture, bitcast<vec2<i32>>(_e168), vec4<f32>(_e173.x, _e173.y, _e173.z, (1f - _e177)));
            }
            continue;
        } else {
            break;
        }
        continuing {
            let _e183 = k_1;
            k_1 = (_e183 + bitcast<u32>(1i));
        }
    }
    let _e187 = settings.count;
    let _e189 = shaded;
    if ((_e187 != 0u) && (_e189 > 0u)) {
        let _e194 = shaded;
        let _e195 = atomicAdd((&unnamed_3.control.fragments), _e194);
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn main(@builtin(local_invocation_index) gl_LocalInvocationIndex: u32, @builtin(workgroup_id) gl_WorkGroupID: vec3<u32>) {
    gl_LocalInvocationIndex_1 = gl_LocalInvocationIndex;
    gl_WorkGroupID_1 = gl_WorkGroupID;
    main_1();
}
