struct Square {
    pixels: array<vec4<f32>, 16>,
    open: bool,
    shaded: u32,
    middle: vec2<f32>,
}

struct Said {
    fixed_scale: f32,
    guard: f32,
    hull_opacity: f32,
    cutoff: f32,
    least: f32,
    full: f32,
}

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
    level: u32,
    drawn: u32,
    spread: f32,
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

@group(0) @binding(5) 
var<storage> unnamed: Keys_1;
@group(0) @binding(3) 
var<storage> unnamed_1: Bins_1;
var<private> gl_LocalInvocationIndex_1: u32;
@group(0) @binding(0) 
var<uniform> frame: FrameBlock;
@group(0) @binding(7) 
var<uniform> settings: SettingsBlock;
@group(0) @binding(1) 
var<storage> unnamed_2: Splats_1;
@group(0) @binding(4) 
var picture: texture_storage_2d<rgba16float,write>;
var<private> gl_WorkGroupID_1: vec3<u32>;
@group(0) @binding(2) 
var<storage, read_write> unnamed_3: ControlBuffer_1;

fn store_u0028_vu2_u003b_vu2_u003b_vf4_u003b(at: ptr<function, vec2<u32>>, size: ptr<function, vec2<u32>>, pixel: ptr<function, vec4<f32>>) {
    let _e100 = (*at);
    let _e101 = (*size);
    if all((_e100 < _e101)) {
        let _e104 = (*at);
        let _e106 = (*pixel);
        let _e107 = _e106.xyz;
        let _e109 = (*pixel)[3u];
        textureStore(picture, bitcast<vec2<i32>>(_e104), vec4<f32>(_e107.x, _e107.y, _e107.z, (1f - _e109)));
    }
    return;
}

fn smaller_u0028_f1_u003b_f1_u003b(a: ptr<function, f32>, b: ptr<function, f32>) -> f32 {
    let _e99 = (*a);
    let _e100 = (*b);
    let _e101 = (*b);
    let _e102 = (*a);
    return select(_e99, _e100, (_e101 < _e102));
}

fn larger_u0028_f1_u003b_f1_u003b(a_1: ptr<function, f32>, b_1: ptr<function, f32>) -> f32 {
    let _e99 = (*a_1);
    let _e100 = (*b_1);
    let _e101 = (*b_1);
    let _e102 = (*a_1);
    return select(_e99, _e100, (_e101 > _e102));
}

fn upper_half_u0028_u1_u003b(word: ptr<function, u32>) -> f32 {
    let _e98 = (*word);
    let _e103 = (*word);
    return (bitcast<f32>(((((_e98 & 2147483647u) >> bitcast<u32>(3u)) & 268427264u) | (_e103 & 2147483648u))) * 5192297000000000000000000000000000f);
}

fn lower_half_u0028_u1_u003b(word_1: ptr<function, u32>) -> f32 {
    let _e98 = (*word_1);
    let _e101 = (*word_1);
    return (bitcast<f32>((((_e98 & 32767u) * 8192u) | ((_e101 & 32768u) * 65536u))) * 5192297000000000000000000000000000f);
}

fn number_u0028_u1_u003b_u1_u003b(word_2: ptr<function, u32>, mask: ptr<function, u32>) -> f32 {
    let _e99 = (*word_2);
    let _e100 = (*mask);
    return f32(bitcast<i32>((_e99 & _e100)));
}

fn put_u0028_struct_u002d_Square_u002d_vf4_u005b_16_u005d_u002d_b1_u002d_u1_u002d_vf21_u003b_struct_u002d_Said_u002d_f1_u002d_f1_u002d_f1_u002d_f1_u002d_f1_u002d_f11_u003b_vu4_u003b(square: ptr<function, Square>, said: ptr<function, Said>, words: ptr<function, vec4<u32>>) {
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
    var meets: bool;
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
    var pixel_1: vec4<f32>;
    var share: f32;
    var param_25: f32;
    var param_26: f32;
    var covers_1: f32;
    var param_27: f32;
    var param_28: f32;
    var pixel_2: vec4<f32>;
    var share_1: f32;
    var param_29: f32;
    var param_30: f32;
    var covers_2: f32;
    var param_31: f32;
    var param_32: f32;
    var pixel_3: vec4<f32>;
    var share_2: f32;
    var param_33: f32;
    var param_34: f32;
    var covers_3: f32;
    var param_35: f32;
    var param_36: f32;
    var pixel_4: vec4<f32>;
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
    var pixel_5: vec4<f32>;
    var share_4: f32;
    var param_43: f32;
    var param_44: f32;
    var covers_5: f32;
    var param_45: f32;
    var param_46: f32;
    var pixel_6: vec4<f32>;
    var share_5: f32;
    var param_47: f32;
    var param_48: f32;
    var covers_6: f32;
    var param_49: f32;
    var param_50: f32;
    var pixel_7: vec4<f32>;
    var share_6: f32;
    var param_51: f32;
    var param_52: f32;
    var covers_7: f32;
    var param_53: f32;
    var param_54: f32;
    var pixel_8: vec4<f32>;
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
    var pixel_9: vec4<f32>;
    var share_8: f32;
    var param_61: f32;
    var param_62: f32;
    var covers_9: f32;
    var param_63: f32;
    var param_64: f32;
    var pixel_10: vec4<f32>;
    var share_9: f32;
    var param_65: f32;
    var param_66: f32;
    var covers_10: f32;
    var param_67: f32;
    var param_68: f32;
    var pixel_11: vec4<f32>;
    var share_10: f32;
    var param_69: f32;
    var param_70: f32;
    var covers_11: f32;
    var param_71: f32;
    var param_72: f32;
    var pixel_12: vec4<f32>;
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
    var pixel_13: vec4<f32>;
    var share_12: f32;
    var param_79: f32;
    var param_80: f32;
    var covers_13: f32;
    var param_81: f32;
    var param_82: f32;
    var pixel_14: vec4<f32>;
    var share_13: f32;
    var param_83: f32;
    var param_84: f32;
    var covers_14: f32;
    var param_85: f32;
    var param_86: f32;
    var pixel_15: vec4<f32>;
    var share_14: f32;
    var param_87: f32;
    var param_88: f32;
    var covers_15: f32;
    var param_89: f32;
    var param_90: f32;
    var pixel_16: vec4<f32>;
    var share_15: f32;
    var param_91: f32;
    var param_92: f32;
    var phi_310_: bool;

    let _e271 = (*square).middle;
    let _e273 = (*words)[0u];
    param = _e273;
    param_1 = 1048575u;
    let _e274 = number_u0028_u1_u003b_u1_u003b((&param), (&param_1));
    let _e276 = (*words)[1u];
    param_2 = _e276;
    param_3 = 1048575u;
    let _e277 = number_u0028_u1_u003b_u1_u003b((&param_2), (&param_3));
    let _e280 = (*said).fixed_scale;
    let _e284 = (*said).guard;
    from_ = (_e271 - ((vec2<f32>(_e274, _e277) / vec2(_e280)) - vec2(_e284)));
    let _e289 = (*words)[2u];
    param_4 = _e289;
    let _e290 = lower_half_u0028_u1_u003b((&param_4));
    let _e292 = (*words)[2u];
    param_5 = _e292;
    let _e293 = upper_half_u0028_u1_u003b((&param_5));
    axis = vec2<f32>(_e290, _e293);
    let _e296 = (*words)[3u];
    param_6 = _e296;
    let _e297 = lower_half_u0028_u1_u003b((&param_6));
    shorter = _e297;
    let _e299 = (*words)[3u];
    param_7 = _e299;
    param_8 = 16711680u;
    let _e300 = number_u0028_u1_u003b_u1_u003b((&param_7), (&param_8));
    opacity = (_e300 / 65536f);
    let _e302 = axis;
    let _e303 = axis;
    inverse = (1f / dot(_e302, _e303));
    let _e306 = opacity;
    param_9 = _e306;
    let _e308 = (*said).hull_opacity;
    param_10 = _e308;
    let _e309 = larger_u0028_f1_u003b_f1_u003b((&param_9), (&param_10));
    let _e311 = (*said).cutoff;
    param_11 = (_e309 / _e311);
    param_12 = 1f;
    let _e313 = larger_u0028_f1_u003b_f1_u003b((&param_11), (&param_12));
    reach = (2f * log(_e313));
    let _e316 = reach;
    let _e317 = axis;
    let _e318 = axis;
    let _e320 = shorter;
    let _e321 = shorter;
    let _e323 = inverse;
    let _e325 = axis;
    let _e328 = axis;
    box = (sqrt((((_e317 * _e318) + ((_e325.yx * ((_e320 * _e321) * _e323)) * _e328.yx)) * _e316)) + vec2(1.5f));
    let _e337 = (*square).open;
    phi_310_ = _e337;
    if _e337 {
        let _e338 = from_;
        let _e340 = box;
        phi_310_ = all((abs(_e338) < _e340));
    }
    let _e344 = phi_310_;
    meets = _e344;
    let _e345 = inverse;
    let _e347 = axis;
    along = (_e347 * (0.8493218f * _e345));
    let _e349 = inverse;
    let _e352 = shorter;
    let _e355 = axis[1u];
    let _e358 = axis[0u];
    across = (vec2<f32>(-(_e355), _e358) * ((0.8493218f * sqrt(_e349)) / _e352));
    let _e362 = along[0u];
    let _e364 = across[0u];
    right = vec2<f32>(_e362, _e364);
    let _e366 = right;
    let _e367 = right;
    bend = exp2((-2f * dot(_e366, _e367)));
    let _e372 = (*words)[0u];
    param_13 = _e372;
    param_14 = 1073741824u;
    let _e373 = number_u0028_u1_u003b_u1_u003b((&param_13), (&param_14));
    let _e376 = (*words)[0u];
    low = ((_e373 / 1073741800f) + select(0f, 2f, (bitcast<i32>(_e376) < 0i)));
    let _e382 = (*words)[3u];
    param_15 = _e382;
    param_16 = 2130706432u;
    let _e383 = number_u0028_u1_u003b_u1_u003b((&param_15), (&param_16));
    let _e386 = (*words)[3u];
    high = ((_e383 / 16777216f) + select(0f, 128f, (bitcast<i32>(_e386) < 0i)));
    let _e392 = (*words)[0u];
    param_17 = _e392;
    param_18 = 1072693248u;
    let _e393 = number_u0028_u1_u003b_u1_u003b((&param_17), (&param_18));
    let _e396 = (*words)[1u];
    param_19 = _e396;
    param_20 = 1072693248u;
    let _e397 = number_u0028_u1_u003b_u1_u003b((&param_19), (&param_20));
    let _e399 = high;
    let _e401 = low;
    color = vec3<f32>((_e393 * 0.000000000932233f), (_e397 * 0.000000000932233f), (((4f * _e399) + _e401) / 1023f));
    let _e405 = opacity;
    let _e407 = meets;
    opacity = select(0f, (_e405 / 255f), _e407);
    let _e409 = from_;
    from_ = (_e409 - vec2(1.5f));
    let _e412 = from_;
    let _e413 = along;
    let _e415 = from_;
    let _e416 = across;
    deviation = vec2<f32>(dot(_e412, _e413), dot(_e415, _e416));
    most = 0f;
    let _e419 = deviation;
    let _e420 = deviation;
    weight = exp2(-(dot(_e419, _e420)));
    let _e424 = opacity;
    let _e425 = weight;
    let _e427 = weight;
    alpha = select(0f, (_e424 * _e425), (_e427 >= 0.00000000000000001f));
    let _e430 = deviation;
    let _e432 = right;
    let _e434 = right;
    param_21 = -(dot(((_e430 * 2f) + _e432), _e434));
    param_22 = 60f;
    let _e437 = smaller_u0028_f1_u003b_f1_u003b((&param_21), (&param_22));
    factor = exp2(_e437);
    let _e439 = alpha;
    param_23 = _e439;
    param_24 = 0.99f;
    let _e440 = smaller_u0028_f1_u003b_f1_u003b((&param_23), (&param_24));
    covers = _e440;
    let _e443 = (*square).pixels[0i];
    pixel_1 = _e443;
    let _e444 = covers;
    let _e446 = pixel_1[3u];
    let _e448 = covers;
    let _e450 = (*said).least;
    share = select(0f, (_e444 * _e446), (_e448 >= _e450));
    let _e453 = pixel_1;
    let _e455 = share;
    let _e456 = color;
    let _e458 = (_e453.xyz + (_e456 * _e455));
    let _e460 = pixel_1[3u];
    let _e461 = share;
    pixel_1 = vec4<f32>(_e458.x, _e458.y, _e458.z, (_e460 - _e461));
    let _e467 = pixel_1;
    (*square).pixels[0i] = _e467;
    let _e470 = most;
    param_25 = _e470;
    let _e472 = pixel_1[3u];
    param_26 = _e472;
    let _e473 = larger_u0028_f1_u003b_f1_u003b((&param_25), (&param_26));
    most = _e473;
    let _e474 = factor;
    let _e475 = alpha;
    alpha = (_e475 * _e474);
    let _e477 = bend;
    let _e478 = factor;
    factor = (_e478 * _e477);
    let _e480 = alpha;
    param_27 = _e480;
    param_28 = 0.99f;
    let _e481 = smaller_u0028_f1_u003b_f1_u003b((&param_27), (&param_28));
    covers_1 = _e481;
    let _e484 = (*square).pixels[1i];
    pixel_2 = _e484;
    let _e485 = covers_1;
    let _e487 = pixel_2[3u];
    let _e489 = covers_1;
    let _e491 = (*said).least;
    share_1 = select(0f, (_e485 * _e487), (_e489 >= _e491));
    let _e494 = pixel_2;
    let _e496 = share_1;
    let _e497 = color;
    let _e499 = (_e494.xyz + (_e497 * _e496));
    let _e501 = pixel_2[3u];
    let _e502 = share_1;
    pixel_2 = vec4<f32>(_e499.x, _e499.y, _e499.z, (_e501 - _e502));
    let _e508 = pixel_2;
    (*square).pixels[1i] = _e508;
    let _e511 = most;
    param_29 = _e511;
    let _e513 = pixel_2[3u];
    param_30 = _e513;
    let _e514 = larger_u0028_f1_u003b_f1_u003b((&param_29), (&param_30));
    most = _e514;
    let _e515 = factor;
    let _e516 = alpha;
    alpha = (_e516 * _e515);
    let _e518 = bend;
    let _e519 = factor;
    factor = (_e519 * _e518);
    let _e521 = alpha;
    param_31 = _e521;
    param_32 = 0.99f;
    let _e522 = smaller_u0028_f1_u003b_f1_u003b((&param_31), (&param_32));
    covers_2 = _e522;
    let _e525 = (*square).pixels[2i];
    pixel_3 = _e525;
    let _e526 = covers_2;
    let _e528 = pixel_3[3u];
    let _e530 = covers_2;
    let _e532 = (*said).least;
    share_2 = select(0f, (_e526 * _e528), (_e530 >= _e532));
    let _e535 = pixel_3;
    let _e537 = share_2;
    let _e538 = color;
    let _e540 = (_e535.xyz + (_e538 * _e537));
    let _e542 = pixel_3[3u];
    let _e543 = share_2;
    pixel_3 = vec4<f32>(_e540.x, _e540.y, _e540.z, (_e542 - _e543));
    let _e549 = pixel_3;
    (*square).pixels[2i] = _e549;
    let _e552 = most;
    param_33 = _e552;
    let _e554 = pixel_3[3u];
    param_34 = _e554;
    let _e555 = larger_u0028_f1_u003b_f1_u003b((&param_33), (&param_34));
    most = _e555;
    let _e556 = factor;
    let _e557 = alpha;
    alpha = (_e557 * _e556);
    let _e559 = bend;
    let _e560 = factor;
    factor = (_e560 * _e559);
    let _e562 = alpha;
    param_35 = _e562;
    param_36 = 0.99f;
    let _e563 = smaller_u0028_f1_u003b_f1_u003b((&param_35), (&param_36));
    covers_3 = _e563;
    let _e566 = (*square).pixels[3i];
    pixel_4 = _e566;
    let _e567 = covers_3;
    let _e569 = pixel_4[3u];
    let _e571 = covers_3;
    let _e573 = (*said).least;
    share_3 = select(0f, (_e567 * _e569), (_e571 >= _e573));
    let _e576 = pixel_4;
    let _e578 = share_3;
    let _e579 = color;
    let _e581 = (_e576.xyz + (_e579 * _e578));
    let _e583 = pixel_4[3u];
    let _e584 = share_3;
    pixel_4 = vec4<f32>(_e581.x, _e581.y, _e581.z, (_e583 - _e584));
    let _e590 = pixel_4;
    (*square).pixels[3i] = _e590;
    let _e593 = most;
    param_37 = _e593;
    let _e595 = pixel_4[3u];
    param_38 = _e595;
    let _e596 = larger_u0028_f1_u003b_f1_u003b((&param_37), (&param_38));
    most = _e596;
    let _e597 = factor;
    let _e598 = alpha;
    alpha = (_e598 * _e597);
    let _e600 = bend;
    let _e601 = factor;
    factor = (_e601 * _e600);
    let _e604 = along[1u];
    let _e606 = across[1u];
    let _e608 = deviation;
    deviation = (_e608 + vec2<f32>(_e604, _e606));
    let _e610 = deviation;
    let _e611 = deviation;
    weight_1 = exp2(-(dot(_e610, _e611)));
    let _e615 = opacity;
    let _e616 = weight_1;
    let _e618 = weight_1;
    alpha_1 = select(0f, (_e615 * _e616), (_e618 >= 0.00000000000000001f));
    let _e621 = deviation;
    let _e623 = right;
    let _e625 = right;
    param_39 = -(dot(((_e621 * 2f) + _e623), _e625));
    param_40 = 60f;
    let _e628 = smaller_u0028_f1_u003b_f1_u003b((&param_39), (&param_40));
    factor_1 = exp2(_e628);
    let _e630 = alpha_1;
    param_41 = _e630;
    param_42 = 0.99f;
    let _e631 = smaller_u0028_f1_u003b_f1_u003b((&param_41), (&param_42));
    covers_4 = _e631;
    let _e634 = (*square).pixels[4i];
    pixel_5 = _e634;
    let _e635 = covers_4;
    let _e637 = pixel_5[3u];
    let _e639 = covers_4;
    let _e641 = (*said).least;
    share_4 = select(0f, (_e635 * _e637), (_e639 >= _e641));
    let _e644 = pixel_5;
    let _e646 = share_4;
    let _e647 = color;
    let _e649 = (_e644.xyz + (_e647 * _e646));
    let _e651 = pixel_5[3u];
    let _e652 = share_4;
    pixel_5 = vec4<f32>(_e649.x, _e649.y, _e649.z, (_e651 - _e652));
    let _e658 = pixel_5;
    (*square).pixels[4i] = _e658;
    let _e661 = most;
    param_43 = _e661;
    let _e663 = pixel_5[3u];
    param_44 = _e663;
    let _e664 = larger_u0028_f1_u003b_f1_u003b((&param_43), (&param_44));
    most = _e664;
    let _e665 = factor_1;
    let _e666 = alpha_1;
    alpha_1 = (_e666 * _e665);
    let _e668 = bend;
    let _e669 = factor_1;
    factor_1 = (_e669 * _e668);
    let _e671 = alpha_1;
    param_45 = _e671;
    param_46 = 0.99f;
    let _e672 = smaller_u0028_f1_u003b_f1_u003b((&param_45), (&param_46));
    covers_5 = _e672;
    let _e675 = (*square).pixels[5i];
    pixel_6 = _e675;
    let _e676 = covers_5;
    let _e678 = pixel_6[3u];
    let _e680 = covers_5;
    let _e682 = (*said).least;
    share_5 = select(0f, (_e676 * _e678), (_e680 >= _e682));
    let _e685 = pixel_6;
    let _e687 = share_5;
    let _e688 = color;
    let _e690 = (_e685.xyz + (_e688 * _e687));
    let _e692 = pixel_6[3u];
    let _e693 = share_5;
    pixel_6 = vec4<f32>(_e690.x, _e690.y, _e690.z, (_e692 - _e693));
    let _e699 = pixel_6;
    (*square).pixels[5i] = _e699;
    let _e702 = most;
    param_47 = _e702;
    let _e704 = pixel_6[3u];
    param_48 = _e704;
    let _e705 = larger_u0028_f1_u003b_f1_u003b((&param_47), (&param_48));
    most = _e705;
    let _e706 = factor_1;
    let _e707 = alpha_1;
    alpha_1 = (_e707 * _e706);
    let _e709 = bend;
    let _e710 = factor_1;
    factor_1 = (_e710 * _e709);
    let _e712 = alpha_1;
    param_49 = _e712;
    param_50 = 0.99f;
    let _e713 = smaller_u0028_f1_u003b_f1_u003b((&param_49), (&param_50));
    covers_6 = _e713;
    let _e716 = (*square).pixels[6i];
    pixel_7 = _e716;
    let _e717 = covers_6;
    let _e719 = pixel_7[3u];
    let _e721 = covers_6;
    let _e723 = (*said).least;
    share_6 = select(0f, (_e717 * _e719), (_e721 >= _e723));
    let _e726 = pixel_7;
    let _e728 = share_6;
    let _e729 = color;
    let _e731 = (_e726.xyz + (_e729 * _e728));
    let _e733 = pixel_7[3u];
    let _e734 = share_6;
    pixel_7 = vec4<f32>(_e731.x, _e731.y, _e731.z, (_e733 - _e734));
    let _e740 = pixel_7;
    (*square).pixels[6i] = _e740;
    let _e743 = most;
    param_51 = _e743;
    let _e745 = pixel_7[3u];
    param_52 = _e745;
    let _e746 = larger_u0028_f1_u003b_f1_u003b((&param_51), (&param_52));
    most = _e746;
    let _e747 = factor_1;
    let _e748 = alpha_1;
    alpha_1 = (_e748 * _e747);
    let _e750 = bend;
    let _e751 = factor_1;
    factor_1 = (_e751 * _e750);
    let _e753 = alpha_1;
    param_53 = _e753;
    param_54 = 0.99f;
    let _e754 = smaller_u0028_f1_u003b_f1_u003b((&param_53), (&param_54));
    covers_7 = _e754;
    let _e757 = (*square).pixels[7i];
    pixel_8 = _e757;
    let _e758 = covers_7;
    let _e760 = pixel_8[3u];
    let _e762 = covers_7;
    let _e764 = (*said).least;
    share_7 = select(0f, (_e758 * _e760), (_e762 >= _e764));
    let _e767 = pixel_8;
    let _e769 = share_7;
    let _e770 = color;
    let _e772 = (_e767.xyz + (_e770 * _e769));
    let _e774 = pixel_8[3u];
    let _e775 = share_7;
    pixel_8 = vec4<f32>(_e772.x, _e772.y, _e772.z, (_e774 - _e775));
    let _e781 = pixel_8;
    (*square).pixels[7i] = _e781;
    let _e784 = most;
    param_55 = _e784;
    let _e786 = pixel_8[3u];
    param_56 = _e786;
    let _e787 = larger_u0028_f1_u003b_f1_u003b((&param_55), (&param_56));
    most = _e787;
    let _e788 = factor_1;
    let _e789 = alpha_1;
    alpha_1 = (_e789 * _e788);
    let _e791 = bend;
    let _e792 = factor_1;
    factor_1 = (_e792 * _e791);
    let _e795 = along[1u];
    let _e797 = across[1u];
    let _e799 = deviation;
    deviation = (_e799 + vec2<f32>(_e795, _e797));
    let _e801 = deviation;
    let _e802 = deviation;
    weight_2 = exp2(-(dot(_e801, _e802)));
    let _e806 = opacity;
    let _e807 = weight_2;
    let _e809 = weight_2;
    alpha_2 = select(0f, (_e806 * _e807), (_e809 >= 0.00000000000000001f));
    let _e812 = deviation;
    let _e814 = right;
    let _e816 = right;
    param_57 = -(dot(((_e812 * 2f) + _e814), _e816));
    param_58 = 60f;
    let _e819 = smaller_u0028_f1_u003b_f1_u003b((&param_57), (&param_58));
    factor_2 = exp2(_e819);
    let _e821 = alpha_2;
    param_59 = _e821;
    param_60 = 0.99f;
    let _e822 = smaller_u0028_f1_u003b_f1_u003b((&param_59), (&param_60));
    covers_8 = _e822;
    let _e825 = (*square).pixels[8i];
    pixel_9 = _e825;
    let _e826 = covers_8;
    let _e828 = pixel_9[3u];
    let _e830 = covers_8;
    let _e832 = (*said).least;
    share_8 = select(0f, (_e826 * _e828), (_e830 >= _e832));
    let _e835 = pixel_9;
    let _e837 = share_8;
    let _e838 = color;
    let _e840 = (_e835.xyz + (_e838 * _e837));
    let _e842 = pixel_9[3u];
    let _e843 = share_8;
    pixel_9 = vec4<f32>(_e840.x, _e840.y, _e840.z, (_e842 - _e843));
    let _e849 = pixel_9;
    (*square).pixels[8i] = _e849;
    let _e852 = most;
    param_61 = _e852;
    let _e854 = pixel_9[3u];
    param_62 = _e854;
    let _e855 = larger_u0028_f1_u003b_f1_u003b((&param_61), (&param_62));
    most = _e855;
    let _e856 = factor_2;
    let _e857 = alpha_2;
    alpha_2 = (_e857 * _e856);
    let _e859 = bend;
    let _e860 = factor_2;
    factor_2 = (_e860 * _e859);
    let _e862 = alpha_2;
    param_63 = _e862;
    param_64 = 0.99f;
    let _e863 = smaller_u0028_f1_u003b_f1_u003b((&param_63), (&param_64));
    covers_9 = _e863;
    let _e866 = (*square).pixels[9i];
    pixel_10 = _e866;
    let _e867 = covers_9;
    let _e869 = pixel_10[3u];
    let _e871 = covers_9;
    let _e873 = (*said).least;
    share_9 = select(0f, (_e867 * _e869), (_e871 >= _e873));
    let _e876 = pixel_10;
    let _e878 = share_9;
    let _e879 = color;
    let _e881 = (_e876.xyz + (_e879 * _e878));
    let _e883 = pixel_10[3u];
    let _e884 = share_9;
    pixel_10 = vec4<f32>(_e881.x, _e881.y, _e881.z, (_e883 - _e884));
    let _e890 = pixel_10;
    (*square).pixels[9i] = _e890;
    let _e893 = most;
    param_65 = _e893;
    let _e895 = pixel_10[3u];
    param_66 = _e895;
    let _e896 = larger_u0028_f1_u003b_f1_u003b((&param_65), (&param_66));
    most = _e896;
    let _e897 = factor_2;
    let _e898 = alpha_2;
    alpha_2 = (_e898 * _e897);
    let _e900 = bend;
    let _e901 = factor_2;
    factor_2 = (_e901 * _e900);
    let _e903 = alpha_2;
    param_67 = _e903;
    param_68 = 0.99f;
    let _e904 = smaller_u0028_f1_u003b_f1_u003b((&param_67), (&param_68));
    covers_10 = _e904;
    let _e907 = (*square).pixels[10i];
    pixel_11 = _e907;
    let _e908 = covers_10;
    let _e910 = pixel_11[3u];
    let _e912 = covers_10;
    let _e914 = (*said).least;
    share_10 = select(0f, (_e908 * _e910), (_e912 >= _e914));
    let _e917 = pixel_11;
    let _e919 = share_10;
    let _e920 = color;
    let _e922 = (_e917.xyz + (_e920 * _e919));
    let _e924 = pixel_11[3u];
    let _e925 = share_10;
    pixel_11 = vec4<f32>(_e922.x, _e922.y, _e922.z, (_e924 - _e925));
    let _e931 = pixel_11;
    (*square).pixels[10i] = _e931;
    let _e934 = most;
    param_69 = _e934;
    let _e936 = pixel_11[3u];
    param_70 = _e936;
    let _e937 = larger_u0028_f1_u003b_f1_u003b((&param_69), (&param_70));
    most = _e937;
    let _e938 = factor_2;
    let _e939 = alpha_2;
    alpha_2 = (_e939 * _e938);
    let _e941 = bend;
    let _e942 = factor_2;
    factor_2 = (_e942 * _e941);
    let _e944 = alpha_2;
    param_71 = _e944;
    param_72 = 0.99f;
    let _e945 = smaller_u0028_f1_u003b_f1_u003b((&param_71), (&param_72));
    covers_11 = _e945;
    let _e948 = (*square).pixels[11i];
    pixel_12 = _e948;
    let _e949 = covers_11;
    let _e951 = pixel_12[3u];
    let _e953 = covers_11;
    let _e955 = (*said).least;
    share_11 = select(0f, (_e949 * _e951), (_e953 >= _e955));
    let _e958 = pixel_12;
    let _e960 = share_11;
    let _e961 = color;
    let _e963 = (_e958.xyz + (_e961 * _e960));
    let _e965 = pixel_12[3u];
    let _e966 = share_11;
    pixel_12 = vec4<f32>(_e963.x, _e963.y, _e963.z, (_e965 - _e966));
    let _e972 = pixel_12;
    (*square).pixels[11i] = _e972;
    let _e975 = most;
    param_73 = _e975;
    let _e977 = pixel_12[3u];
    param_74 = _e977;
    let _e978 = larger_u0028_f1_u003b_f1_u003b((&param_73), (&param_74));
    most = _e978;
    let _e979 = factor_2;
    let _e980 = alpha_2;
    alpha_2 = (_e980 * _e979);
    let _e982 = bend;
    let _e983 = factor_2;
    factor_2 = (_e983 * _e982);
    let _e986 = along[1u];
    let _e988 = across[1u];
    let _e990 = deviation;
    deviation = (_e990 + vec2<f32>(_e986, _e988));
    let _e992 = deviation;
    let _e993 = deviation;
    weight_3 = exp2(-(dot(_e992, _e993)));
    let _e997 = opacity;
    let _e998 = weight_3;
    let _e1000 = weight_3;
    alpha_3 = select(0f, (_e997 * _e998), (_e1000 >= 0.00000000000000001f));
    let _e1003 = deviation;
    let _e1005 = right;
    let _e1007 = right;
    param_75 = -(dot(((_e1003 * 2f) + _e1005), _e1007));
    param_76 = 60f;
    let _e1010 = smaller_u0028_f1_u003b_f1_u003b((&param_75), (&param_76));
    factor_3 = exp2(_e1010);
    let _e1012 = alpha_3;
    param_77 = _e1012;
    param_78 = 0.99f;
    let _e1013 = smaller_u0028_f1_u003b_f1_u003b((&param_77), (&param_78));
    covers_12 = _e1013;
    let _e1016 = (*square).pixels[12i];
    pixel_13 = _e1016;
    let _e1017 = covers_12;
    let _e1019 = pixel_13[3u];
    let _e1021 = covers_12;
    let _e1023 = (*said).least;
    share_12 = select(0f, (_e1017 * _e1019), (_e1021 >= _e1023));
    let _e1026 = pixel_13;
    let _e1028 = share_12;
    let _e1029 = color;
    let _e1031 = (_e1026.xyz + (_e1029 * _e1028));
    let _e1033 = pixel_13[3u];
    let _e1034 = share_12;
    pixel_13 = vec4<f32>(_e1031.x, _e1031.y, _e1031.z, (_e1033 - _e1034));
    let _e1040 = pixel_13;
    (*square).pixels[12i] = _e1040;
    let _e1043 = most;
    param_79 = _e1043;
    let _e1045 = pixel_13[3u];
    param_80 = _e1045;
    let _e1046 = larger_u0028_f1_u003b_f1_u003b((&param_79), (&param_80));
    most = _e1046;
    let _e1047 = factor_3;
    let _e1048 = alpha_3;
    alpha_3 = (_e1048 * _e1047);
    let _e1050 = bend;
    let _e1051 = factor_3;
    factor_3 = (_e1051 * _e1050);
    let _e1053 = alpha_3;
    param_81 = _e1053;
    param_82 = 0.99f;
    let _e1054 = smaller_u0028_f1_u003b_f1_u003b((&param_81), (&param_82));
    covers_13 = _e1054;
    let _e1057 = (*square).pixels[13i];
    pixel_14 = _e1057;
    let _e1058 = covers_13;
    let _e1060 = pixel_14[3u];
    let _e1062 = covers_13;
    let _e1064 = (*said).least;
    share_13 = select(0f, (_e1058 * _e1060), (_e1062 >= _e1064));
    let _e1067 = pixel_14;
    let _e1069 = share_13;
    let _e1070 = color;
    let _e1072 = (_e1067.xyz + (_e1070 * _e1069));
    let _e1074 = pixel_14[3u];
    let _e1075 = share_13;
    pixel_14 = vec4<f32>(_e1072.x, _e1072.y, _e1072.z, (_e1074 - _e1075));
    let _e1081 = pixel_14;
    (*square).pixels[13i] = _e1081;
    let _e1084 = most;
    param_83 = _e1084;
    let _e1086 = pixel_14[3u];
    param_84 = _e1086;
    let _e1087 = larger_u0028_f1_u003b_f1_u003b((&param_83), (&param_84));
    most = _e1087;
    let _e1088 = factor_3;
    let _e1089 = alpha_3;
    alpha_3 = (_e1089 * _e1088);
    let _e1091 = bend;
    let _e1092 = factor_3;
    factor_3 = (_e1092 * _e1091);
    let _e1094 = alpha_3;
    param_85 = _e1094;
    param_86 = 0.99f;
    let _e1095 = smaller_u0028_f1_u003b_f1_u003b((&param_85), (&param_86));
    covers_14 = _e1095;
    let _e1098 = (*square).pixels[14i];
    pixel_15 = _e1098;
    let _e1099 = covers_14;
    let _e1101 = pixel_15[3u];
    let _e1103 = covers_14;
    let _e1105 = (*said).least;
    share_14 = select(0f, (_e1099 * _e1101), (_e1103 >= _e1105));
    let _e1108 = pixel_15;
    let _e1110 = share_14;
    let _e1111 = color;
    let _e1113 = (_e1108.xyz + (_e1111 * _e1110));
    let _e1115 = pixel_15[3u];
    let _e1116 = share_14;
    pixel_15 = vec4<f32>(_e1113.x, _e1113.y, _e1113.z, (_e1115 - _e1116));
    let _e1122 = pixel_15;
    (*square).pixels[14i] = _e1122;
    let _e1125 = most;
    param_87 = _e1125;
    let _e1127 = pixel_15[3u];
    param_88 = _e1127;
    let _e1128 = larger_u0028_f1_u003b_f1_u003b((&param_87), (&param_88));
    most = _e1128;
    let _e1129 = factor_3;
    let _e1130 = alpha_3;
    alpha_3 = (_e1130 * _e1129);
    let _e1132 = bend;
    let _e1133 = factor_3;
    factor_3 = (_e1133 * _e1132);
    let _e1135 = alpha_3;
    param_89 = _e1135;
    param_90 = 0.99f;
    let _e1136 = smaller_u0028_f1_u003b_f1_u003b((&param_89), (&param_90));
    covers_15 = _e1136;
    let _e1139 = (*square).pixels[15i];
    pixel_16 = _e1139;
    let _e1140 = covers_15;
    let _e1142 = pixel_16[3u];
    let _e1144 = covers_15;
    let _e1146 = (*said).least;
    share_15 = select(0f, (_e1140 * _e1142), (_e1144 >= _e1146));
    let _e1149 = pixel_16;
    let _e1151 = share_15;
    let _e1152 = color;
    let _e1154 = (_e1149.xyz + (_e1152 * _e1151));
    let _e1156 = pixel_16[3u];
    let _e1157 = share_15;
    pixel_16 = vec4<f32>(_e1154.x, _e1154.y, _e1154.z, (_e1156 - _e1157));
    let _e1163 = pixel_16;
    (*square).pixels[15i] = _e1163;
    let _e1166 = most;
    param_91 = _e1166;
    let _e1168 = pixel_16[3u];
    param_92 = _e1168;
    let _e1169 = larger_u0028_f1_u003b_f1_u003b((&param_91), (&param_92));
    most = _e1169;
    let _e1170 = factor_3;
    let _e1171 = alpha_3;
    alpha_3 = (_e1171 * _e1170);
    let _e1173 = bend;
    let _e1174 = factor_3;
    factor_3 = (_e1174 * _e1173);
    let _e1177 = along[1u];
    let _e1179 = across[1u];
    let _e1181 = deviation;
    deviation = (_e1181 + vec2<f32>(_e1177, _e1179));
    let _e1183 = meets;
    let _e1186 = (*square).shaded;
    (*square).shaded = (_e1186 + select(0u, 16u, _e1183));
    let _e1189 = most;
    let _e1191 = (*said).full;
    (*square).open = (_e1189 >= _e1191);
    return;
}

fn step_back_u0028_u1_u003b(chain: ptr<function, u32>) -> u32 {
    var local: u32;

    let _e99 = (*chain);
    if ((_e99 & 7u) > 1u) {
        let _e102 = (*chain);
        local = (_e102 - 1u);
    } else {
        let _e104 = (*chain);
        let _e109 = unnamed_1.bins[((2306330u + _e104) - 1u)];
        local = _e109;
    }
    let _e110 = local;
    return _e110;
}

fn key_at_u0028_u1_u003b(i: ptr<function, u32>) -> u32 {
    let _e98 = (*i);
    let _e103 = unnamed.keys[(_e98 >> bitcast<u32>(1u))];
    let _e104 = (*i);
    return ((_e103 >> bitcast<u32>((16u * (_e104 & 1u)))) & 65535u);
}

fn bins_tile_u0028_u1_u003b_vu2_u003b(level: ptr<function, u32>, at_1: ptr<function, vec2<u32>>) -> u32 {
    let _e99 = (*level);
    let _e107 = (*at_1)[1u];
    let _e108 = (*level);
    let _e115 = (*at_1)[0u];
    return (((((65536u - (65536u >> bitcast<u32>((4u * _e99)))) / 15u) * 16u) + (_e107 * (256u >> bitcast<u32>((2u * _e108))))) + _e115);
}

fn blend_tiles_u0028_struct_u002d_Square_u002d_vf4_u005b_16_u005d_u002d_b1_u002d_u1_u002d_vf21_u003b_vu2_u003b(square_1: ptr<function, Square>, at_2: ptr<function, vec2<u32>>) {
    var said_1: Said;
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
    var block: u32;
    var param_101: u32;
    var param_102: u32;
    var param_103: u32;
    var param_104: u32;
    var splat: u32;
    var key: u32;
    var chain_1: u32;
    var ahead: bool;
    var ahead_1: bool;
    var ahead_2: bool;
    var ahead_3: bool;
    var take: vec4<bool>;
    var rest: u32;
    var param_105: u32;
    var next: u32;
    var local_1: u32;
    var after: u32;
    var local_2: u32;
    var param_106: u32;
    var param_107: Square;
    var param_108: Said;
    var param_109: vec4<u32>;
    var phi_1406_: bool;

    let _e137 = frame.fixed_scale;
    let _e139 = frame.guard;
    let _e141 = frame.hull_opacity;
    let _e143 = frame.cutoff;
    let _e145 = settings.cutoff;
    let _e147 = settings.full;
    said_1 = Said(_e137, _e139, _e141, _e143, _e145, _e147);
    param_93 = 0u;
    let _e149 = (*at_2);
    param_94 = _e149;
    let _e150 = bins_tile_u0028_u1_u003b_vu2_u003b((&param_93), (&param_94));
    let _e151 = (*at_2);
    param_95 = 1u;
    param_96 = (_e151 >> bitcast<vec2<u32>>(vec2(2u)));
    let _e155 = bins_tile_u0028_u1_u003b_vu2_u003b((&param_95), (&param_96));
    let _e156 = (*at_2);
    param_97 = 2u;
    param_98 = (_e156 >> bitcast<vec2<u32>>(vec2(4u)));
    let _e160 = bins_tile_u0028_u1_u003b_vu2_u003b((&param_97), (&param_98));
    param_99 = 3u;
    param_100 = vec2<u32>(0u, 0u);
    let _e161 = bins_tile_u0028_u1_u003b_vu2_u003b((&param_99), (&param_100));
    tiles = vec4<u32>(_e150, _e155, _e160, _e161);
    let _e164 = tiles[0u];
    let _e168 = unnamed_1.bins[(1u + _e164)];
    let _e170 = tiles[1u];
    let _e174 = unnamed_1.bins[(1u + _e170)];
    let _e177 = tiles[2u];
    let _e181 = unnamed_1.bins[(1u + _e177)];
    let _e184 = tiles[3u];
    let _e188 = unnamed_1.bins[(1u + _e184)];
    blocks = (((_e168 | _e174) | _e181) | _e188);
    chains = vec4<u32>(0u, 0u, 0u, 0u);
    first = vec4<u32>(0u, 0u, 0u, 0u);
    keys = vec4<u32>(0u, 0u, 0u, 0u);
    loop {
        let _e191 = (*square_1).open;
        phi_1406_ = _e191;
        if _e191 {
            let _e192 = blocks;
            let _e194 = chains;
            phi_1406_ = ((_e192 != 0u) || any((_e194 != vec4<u32>(0u, 0u, 0u, 0u))));
        }
        let _e199 = phi_1406_;
        if _e199 {
            let _e200 = chains;
            if all((_e200 == vec4<u32>(0u, 0u, 0u, 0u))) {
                let _e203 = blocks;
                block = bitcast<u32>(firstLeadingBit(_e203));
                let _e206 = block;
                let _e209 = blocks;
                blocks = (_e209 ^ (1u << bitcast<u32>(_e206)));
                let _e212 = tiles[0u];
                let _e215 = block;
                let _e219 = unnamed_1.bins[((69890u + (_e212 * 32u)) + _e215)];
                chains[0u] = _e219;
                let _e222 = tiles[1u];
                let _e225 = block;
                let _e229 = unnamed_1.bins[((69890u + (_e222 * 32u)) + _e225)];
                chains[1u] = _e229;
                let _e232 = tiles[2u];
                let _e235 = block;
                let _e239 = unnamed_1.bins[((69890u + (_e232 * 32u)) + _e235)];
                chains[2u] = _e239;
                let _e242 = tiles[3u];
                let _e245 = block;
                let _e249 = unnamed_1.bins[((69890u + (_e242 * 32u)) + _e245)];
                chains[3u] = _e249;
                let _e252 = chains[0u];
                if (_e252 != 0u) {
                    let _e255 = chains[0u];
                    let _e259 = unnamed_1.bins[(2306330u + _e255)];
                    first[0u] = _e259;
                    let _e262 = first[0u];
                    param_101 = _e262;
                    let _e263 = key_at_u0028_u1_u003b((&param_101));
                    keys[0u] = _e263;
                }
                let _e266 = chains[1u];
                if (_e266 != 0u) {
                    let _e269 = chains[1u];
                    let _e273 = unnamed_1.bins[(2306330u + _e269)];
                    first[1u] = _e273;
                    let _e276 = first[1u];
                    param_102 = _e276;
                    let _e277 = key_at_u0028_u1_u003b((&param_102));
                    keys[1u] = _e277;
                }
                let _e280 = chains[2u];
                if (_e280 != 0u) {
                    let _e283 = chains[2u];
                    let _e287 = unnamed_1.bins[(2306330u + _e283)];
                    first[2u] = _e287;
                    let _e290 = first[2u];
                    param_103 = _e290;
                    let _e291 = key_at_u0028_u1_u003b((&param_103));
                    keys[2u] = _e291;
                }
                let _e294 = chains[3u];
                if (_e294 != 0u) {
                    let _e297 = chains[3u];
                    let _e301 = unnamed_1.bins[(2306330u + _e297)];
                    first[3u] = _e301;
                    let _e304 = first[3u];
                    param_104 = _e304;
                    let _e305 = key_at_u0028_u1_u003b((&param_104));
                    keys[3u] = _e305;
                }
            }
            splat = 0u;
            key = 0u;
            chain_1 = 0u;
            let _e308 = keys[0u];
            let _e309 = key;
            let _e312 = first[0u];
            let _e313 = splat;
            let _e316 = keys[0u];
            let _e317 = key;
            ahead = select((_e308 > _e309), (_e312 > _e313), (_e316 == _e317));
            let _e320 = ahead;
            let _e321 = chain_1;
            let _e325 = chains[0u];
            ahead = select(false, select(_e320, true, (_e321 == 0u)), (_e325 != 0u));
            let _e328 = chain_1;
            let _e330 = chains[0u];
            let _e331 = ahead;
            chain_1 = select(_e328, _e330, _e331);
            let _e333 = splat;
            let _e335 = first[0u];
            let _e336 = ahead;
            splat = select(_e333, _e335, _e336);
            let _e338 = key;
            let _e340 = keys[0u];
            let _e341 = ahead;
            key = select(_e338, _e340, _e341);
            let _e344 = keys[1u];
            let _e345 = key;
            let _e348 = first[1u];
            let _e349 = splat;
            let _e352 = keys[1u];
            let _e353 = key;
            ahead_1 = select((_e344 > _e345), (_e348 > _e349), (_e352 == _e353));
            let _e356 = ahead_1;
            let _e357 = chain_1;
            let _e361 = chains[1u];
            ahead_1 = select(false, select(_e356, true, (_e357 == 0u)), (_e361 != 0u));
            let _e364 = chain_1;
            let _e366 = chains[1u];
            let _e367 = ahead_1;
            chain_1 = select(_e364, _e366, _e367);
            let _e369 = splat;
            let _e371 = first[1u];
            let _e372 = ahead_1;
            splat = select(_e369, _e371, _e372);
            let _e374 = key;
            let _e376 = keys[1u];
            let _e377 = ahead_1;
            key = select(_e374, _e376, _e377);
            let _e380 = keys[2u];
            let _e381 = key;
            let _e384 = first[2u];
            let _e385 = splat;
            let _e388 = keys[2u];
            let _e389 = key;
            ahead_2 = select((_e380 > _e381), (_e384 > _e385), (_e388 == _e389));
            let _e392 = ahead_2;
            let _e393 = chain_1;
            let _e397 = chains[2u];
            ahead_2 = select(false, select(_e392, true, (_e393 == 0u)), (_e397 != 0u));
            let _e400 = chain_1;
            let _e402 = chains[2u];
            let _e403 = ahead_2;
            chain_1 = select(_e400, _e402, _e403);
            let _e405 = splat;
            let _e407 = first[2u];
            let _e408 = ahead_2;
            splat = select(_e405, _e407, _e408);
            let _e410 = key;
            let _e412 = keys[2u];
            let _e413 = ahead_2;
            key = select(_e410, _e412, _e413);
            let _e416 = keys[3u];
            let _e417 = key;
            let _e420 = first[3u];
            let _e421 = splat;
            let _e424 = keys[3u];
            let _e425 = key;
            ahead_3 = select((_e416 > _e417), (_e420 > _e421), (_e424 == _e425));
            let _e428 = ahead_3;
            let _e429 = chain_1;
            let _e433 = chains[3u];
            ahead_3 = select(false, select(_e428, true, (_e429 == 0u)), (_e433 != 0u));
            let _e436 = chain_1;
            let _e438 = chains[3u];
            let _e439 = ahead_3;
            chain_1 = select(_e436, _e438, _e439);
            let _e441 = splat;
            let _e443 = first[3u];
            let _e444 = ahead_3;
            splat = select(_e441, _e443, _e444);
            let _e446 = key;
            let _e448 = keys[3u];
            let _e449 = ahead_3;
            key = select(_e446, _e448, _e449);
            let _e451 = chains;
            let _e452 = chain_1;
            take = (_e451 == vec4(_e452));
            let _e455 = chain_1;
            param_105 = _e455;
            let _e456 = step_back_u0028_u1_u003b((&param_105));
            rest = _e456;
            let _e457 = rest;
            if (_e457 == 0u) {
                local_1 = 0u;
            } else {
                let _e459 = rest;
                let _e463 = unnamed_1.bins[(2306330u + _e459)];
                local_1 = _e463;
            }
            let _e464 = local_1;
            next = _e464;
            let _e465 = rest;
            if (_e465 == 0u) {
                local_2 = 0u;
            } else {
                let _e467 = next;
                param_106 = _e467;
                let _e468 = key_at_u0028_u1_u003b((&param_106));
                local_2 = _e468;
            }
            let _e469 = local_2;
            after = _e469;
            let _e470 = chains;
            let _e471 = rest;
            let _e473 = take;
            chains = select(_e470, vec4(_e471), _e473);
            let _e475 = first;
            let _e476 = next;
            let _e478 = take;
            first = select(_e475, vec4(_e476), _e478);
            let _e480 = keys;
            let _e481 = after;
            let _e483 = take;
            keys = select(_e480, vec4(_e481), _e483);
            let _e485 = splat;
            let _e486 = (*square_1);
            param_107 = _e486;
            let _e487 = said_1;
            param_108 = _e487;
            let _e490 = unnamed_2.splats[_e485];
            param_109 = _e490;
            put_u0028_struct_u002d_Square_u002d_vf4_u005b_16_u005d_u002d_b1_u002d_u1_u002d_vf21_u003b_struct_u002d_Said_u002d_f1_u002d_f1_u002d_f1_u002d_f1_u002d_f1_u002d_f11_u003b_vu4_u003b((&param_107), (&param_108), (&param_109));
            let _e491 = param_107;
            (*square_1) = _e491;
            continue;
        } else {
            break;
        }
    }
    return;
}

fn lane_of_group_u0028_() -> u32 {
    let _e97 = gl_LocalInvocationIndex_1;
    return _e97;
}

fn main_1() {
    var lane: u32;
    var place: vec2<u32>;
    var first_1: vec2<u32>;
    var square_2: Square;
    var param_110: Square;
    var param_111: vec2<u32>;
    var size_1: vec2<u32>;
    var param_112: vec2<u32>;
    var param_113: vec2<u32>;
    var param_114: vec4<f32>;
    var param_115: vec2<u32>;
    var param_116: vec2<u32>;
    var param_117: vec4<f32>;
    var param_118: vec2<u32>;
    var param_119: vec2<u32>;
    var param_120: vec4<f32>;
    var param_121: vec2<u32>;
    var param_122: vec2<u32>;
    var param_123: vec4<f32>;
    var param_124: vec2<u32>;
    var param_125: vec2<u32>;
    var param_126: vec4<f32>;
    var param_127: vec2<u32>;
    var param_128: vec2<u32>;
    var param_129: vec4<f32>;
    var param_130: vec2<u32>;
    var param_131: vec2<u32>;
    var param_132: vec4<f32>;
    var param_133: vec2<u32>;
    var param_134: vec2<u32>;
    var param_135: vec4<f32>;
    var param_136: vec2<u32>;
    var param_137: vec2<u32>;
    var param_138: vec4<f32>;
    var param_139: vec2<u32>;
    var param_140: vec2<u32>;
    var param_141: vec4<f32>;
    var param_142: vec2<u32>;
    var param_143: vec2<u32>;
    var param_144: vec4<f32>;
    var param_145: vec2<u32>;
    var param_146: vec2<u32>;
    var param_147: vec4<f32>;
    var param_148: vec2<u32>;
    var param_149: vec2<u32>;
    var param_150: vec4<f32>;
    var param_151: vec2<u32>;
    var param_152: vec2<u32>;
    var param_153: vec4<f32>;
    var param_154: vec2<u32>;
    var param_155: vec2<u32>;
    var param_156: vec4<f32>;
    var param_157: vec2<u32>;
    var param_158: vec2<u32>;
    var param_159: vec4<f32>;
    var phi_2012_: bool;

    let _e152 = lane_of_group_u0028_();
    lane = _e152;
    let _e153 = lane;
    let _e155 = lane;
    let _e160 = lane;
    let _e165 = lane;
    let _e169 = lane;
    let _e174 = lane;
    place = vec2<u32>((((_e153 & 1u) | ((_e155 >> bitcast<u32>(1u)) & 2u)) | ((_e160 >> bitcast<u32>(2u)) & 4u)), ((((_e165 >> bitcast<u32>(1u)) & 1u) | ((_e169 >> bitcast<u32>(2u)) & 2u)) | ((_e174 >> bitcast<u32>(3u)) & 4u)));
    let _e181 = settings.first_region;
    let _e182 = gl_WorkGroupID_1;
    let _e187 = place;
    first_1 = (((_e181 + _e182.xy) * vec2(32u)) + (vec2(4u) * _e187));
    square_2.open = true;
    square_2.shaded = 0u;
    let _e193 = first_1;
    square_2.middle = (vec2<f32>(_e193) + vec2(2f));
    square_2.pixels[0i] = vec4<f32>(0f, 0f, 0f, 1f);
    square_2.pixels[1i] = vec4<f32>(0f, 0f, 0f, 1f);
    square_2.pixels[2i] = vec4<f32>(0f, 0f, 0f, 1f);
    square_2.pixels[3i] = vec4<f32>(0f, 0f, 0f, 1f);
    square_2.pixels[4i] = vec4<f32>(0f, 0f, 0f, 1f);
    square_2.pixels[5i] = vec4<f32>(0f, 0f, 0f, 1f);
    square_2.pixels[6i] = vec4<f32>(0f, 0f, 0f, 1f);
    square_2.pixels[7i] = vec4<f32>(0f, 0f, 0f, 1f);
    square_2.pixels[8i] = vec4<f32>(0f, 0f, 0f, 1f);
    square_2.pixels[9i] = vec4<f32>(0f, 0f, 0f, 1f);
    square_2.pixels[10i] = vec4<f32>(0f, 0f, 0f, 1f);
    square_2.pixels[11i] = vec4<f32>(0f, 0f, 0f, 1f);
    square_2.pixels[12i] = vec4<f32>(0f, 0f, 0f, 1f);
    square_2.pixels[13i] = vec4<f32>(0f, 0f, 0f, 1f);
    square_2.pixels[14i] = vec4<f32>(0f, 0f, 0f, 1f);
    square_2.pixels[15i] = vec4<f32>(0f, 0f, 0f, 1f);
    let _e231 = square_2.middle;
    let _e233 = frame.tile;
    let _e237 = square_2;
    param_110 = _e237;
    param_111 = vec2<u32>((_e231 / vec2(_e233)));
    blend_tiles_u0028_struct_u002d_Square_u002d_vf4_u005b_16_u005d_u002d_b1_u002d_u1_u002d_vf21_u003b_vu2_u003b((&param_110), (&param_111));
    let _e238 = param_110;
    square_2 = _e238;
    let _e240 = frame.size;
    size_1 = vec2<u32>(_e240);
    let _e242 = first_1;
    param_112 = (_e242 + vec2<u32>(0u, 0u));
    let _e244 = size_1;
    param_113 = _e244;
    let _e247 = square_2.pixels[0i];
    param_114 = _e247;
    store_u0028_vu2_u003b_vu2_u003b_vf4_u003b((&param_112), (&param_113), (&param_114));
    let _e248 = first_1;
    param_115 = (_e248 + vec2<u32>(1u, 0u));
    let _e250 = size_1;
    param_116 = _e250;
    let _e253 = square_2.pixels[1i];
    param_117 = _e253;
    store_u0028_vu2_u003b_vu2_u003b_vf4_u003b((&param_115), (&param_116), (&param_117));
    let _e254 = first_1;
    param_118 = (_e254 + vec2<u32>(2u, 0u));
    let _e256 = size_1;
    param_119 = _e256;
    let _e259 = square_2.pixels[2i];
    param_120 = _e259;
    store_u0028_vu2_u003b_vu2_u003b_vf4_u003b((&param_118), (&param_119), (&param_120));
    let _e260 = first_1;
    param_121 = (_e260 + vec2<u32>(3u, 0u));
    let _e262 = size_1;
    param_122 = _e262;
    let _e265 = square_2.pixels[3i];
    param_123 = _e265;
    store_u0028_vu2_u003b_vu2_u003b_vf4_u003b((&param_121), (&param_122), (&param_123));
    let _e266 = first_1;
    param_124 = (_e266 + vec2<u32>(0u, 1u));
    let _e268 = size_1;
    param_125 = _e268;
    let _e271 = square_2.pixels[4i];
    param_126 = _e271;
    store_u0028_vu2_u003b_vu2_u003b_vf4_u003b((&param_124), (&param_125), (&param_126));
    let _e272 = first_1;
    param_127 = (_e272 + vec2<u32>(1u, 1u));
    let _e274 = size_1;
    param_128 = _e274;
    let _e277 = square_2.pixels[5i];
    param_129 = _e277;
    store_u0028_vu2_u003b_vu2_u003b_vf4_u003b((&param_127), (&param_128), (&param_129));
    let _e278 = first_1;
    param_130 = (_e278 + vec2<u32>(2u, 1u));
    let _e280 = size_1;
    param_131 = _e280;
    let _e283 = square_2.pixels[6i];
    param_132 = _e283;
    store_u0028_vu2_u003b_vu2_u003b_vf4_u003b((&param_130), (&param_131), (&param_132));
    let _e284 = first_1;
    param_133 = (_e284 + vec2<u32>(3u, 1u));
    let _e286 = size_1;
    param_134 = _e286;
    let _e289 = square_2.pixels[7i];
    param_135 = _e289;
    store_u0028_vu2_u003b_vu2_u003b_vf4_u003b((&param_133), (&param_134), (&param_135));
    let _e290 = first_1;
    param_136 = (_e290 + vec2<u32>(0u, 2u));
    let _e292 = size_1;
    param_137 = _e292;
    let _e295 = square_2.pixels[8i];
    param_138 = _e295;
    store_u0028_vu2_u003b_vu2_u003b_vf4_u003b((&param_136), (&param_137), (&param_138));
    let _e296 = first_1;
    param_139 = (_e296 + vec2<u32>(1u, 2u));
    let _e298 = size_1;
    param_140 = _e298;
    let _e301 = square_2.pixels[9i];
    param_141 = _e301;
    store_u0028_vu2_u003b_vu2_u003b_vf4_u003b((&param_139), (&param_140), (&param_141));
    let _e302 = first_1;
    param_142 = (_e302 + vec2<u32>(2u, 2u));
    let _e304 = size_1;
    param_143 = _e304;
    let _e307 = square_2.pixels[10i];
    param_144 = _e307;
    store_u0028_vu2_u003b_vu2_u003b_vf4_u003b((&param_142), (&param_143), (&param_144));
    let _e308 = first_1;
    param_145 = (_e308 + vec2<u32>(3u, 2u));
    let _e310 = size_1;
    param_146 = _e310;
    let _e313 = square_2.pixels[11i];
    param_147 = _e313;
    store_u0028_vu2_u003b_vu2_u003b_vf4_u003b((&param_145), (&param_146), (&param_147));
    let _e314 = first_1;
    param_148 = (_e314 + vec2<u32>(0u, 3u));
    let _e316 = size_1;
    param_149 = _e316;
    let _e319 = square_2.pixels[12i];
    param_150 = _e319;
    store_u0028_vu2_u003b_vu2_u003b_vf4_u003b((&param_148), (&param_149), (&param_150));
    let _e320 = first_1;
    param_151 = (_e320 + vec2<u32>(1u, 3u));
    let _e322 = size_1;
    param_152 = _e322;
    let _e325 = square_2.pixels[13i];
    param_153 = _e325;
    store_u0028_vu2_u003b_vu2_u003b_vf4_u003b((&param_151), (&param_152), (&param_153));
    let _e326 = first_1;
    param_154 = (_e326 + vec2<u32>(2u, 3u));
    let _e328 = size_1;
    param_155 = _e328;
    let _e331 = square_2.pixels[14i];
    param_156 = _e331;
    store_u0028_vu2_u003b_vu2_u003b_vf4_u003b((&param_154), (&param_155), (&param_156));
    let _e332 = first_1;
    param_157 = (_e332 + vec2<u32>(3u, 3u));
    let _e334 = size_1;
    param_158 = _e334;
    let _e337 = square_2.pixels[15i];
    param_159 = _e337;
    store_u0028_vu2_u003b_vu2_u003b_vf4_u003b((&param_157), (&param_158), (&param_159));
    let _e339 = settings.count;
    let _e340 = (_e339 != 0u);
    phi_2012_ = _e340;
    if _e340 {
        let _e342 = square_2.shaded;
        phi_2012_ = (_e342 > 0u);
    }
    let _e345 = phi_2012_;
    if _e345 {
        let _e349 = square_2.shaded;
        let _e350 = atomicAdd((&unnamed_3.control.fragments), _e349);
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn main(@builtin(local_invocation_index) gl_LocalInvocationIndex: u32, @builtin(workgroup_id) gl_WorkGroupID: vec3<u32>) {
    gl_LocalInvocationIndex_1 = gl_LocalInvocationIndex;
    gl_WorkGroupID_1 = gl_WorkGroupID;
    main_1();
}
