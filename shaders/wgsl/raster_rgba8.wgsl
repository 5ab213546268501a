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
}

struct Keys {
    keys: array<u32>,
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
var<private> middle: vec2<f32>;
var<private> pixels: array<vec4<f32>, 16>;
@group(0) @binding(5) 
var<storage> unnamed: Keys_1;
@group(0) @binding(3) 
var<storage> unnamed_1: Bins_1;
@group(0) @binding(1) 
var<storage> unnamed_2: Splats_1;
var<private> gl_LocalInvocationIndex_1: u32;
var<private> gl_WorkGroupID_1: vec3<u32>;
@group(0) @binding(4) 
var picture: texture_storage_2d<rgba8unorm,write>;
@group(0) @binding(2) 
var<storage, read_write> unnamed_3: ControlBuffer_1;

fn smaller_u0028_f1_u003b_f1_u003b(a: ptr<function, f32>, b: ptr<function, f32>) -> f32 {
    let _e90 = (*a);
    let _e91 = (*b);
    let _e92 = (*b);
    let _e93 = (*a);
    return select(_e90, _e91, (_e92 < _e93));
}

fn larger_u0028_f1_u003b_f1_u003b(a_1: ptr<function, f32>, b_1: ptr<function, f32>) -> f32 {
    let _e90 = (*a_1);
    let _e91 = (*b_1);
    let _e92 = (*b_1);
    let _e93 = (*a_1);
    return select(_e90, _e91, (_e92 > _e93));
}

fn upper_half_u0028_u1_u003b(word: ptr<function, u32>) -> f32 {
    let _e89 = (*word);
    let _e94 = (*word);
    return (bitcast<f32>(((((_e89 & 2147483647u) >> bitcast<u32>(3u)) & 268427264u) | (_e94 & 2147483648u))) * 5192297000000000000000000000000000f);
}

fn lower_half_u0028_u1_u003b(word_1: ptr<function, u32>) -> f32 {
    let _e89 = (*word_1);
    let _e92 = (*word_1);
    return (bitcast<f32>((((_e89 & 32767u) * 8192u) | ((_e92 & 32768u) * 65536u))) * 5192297000000000000000000000000000f);
}

fn number_u0028_u1_u003b_u1_u003b(word_2: ptr<function, u32>, mask: ptr<function, u32>) -> f32 {
    let _e90 = (*word_2);
    let _e91 = (*mask);
    return f32(bitcast<i32>((_e90 & _e91)));
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
    var phi_261_: bool;
    var phi_271_: bool;

    let _e258 = middle;
    let _e260 = (*words)[0u];
    param = _e260;
    param_1 = 1048575u;
    let _e261 = number_u0028_u1_u003b_u1_u003b((&param), (&param_1));
    let _e263 = (*words)[1u];
    param_2 = _e263;
    param_3 = 1048575u;
    let _e264 = number_u0028_u1_u003b_u1_u003b((&param_2), (&param_3));
    let _e266 = fixed_scale;
    let _e269 = guard;
    from_ = (_e258 - ((vec2<f32>(_e261, _e264) / vec2(_e266)) - vec2(_e269)));
    let _e274 = (*words)[2u];
    param_4 = _e274;
    let _e275 = lower_half_u0028_u1_u003b((&param_4));
    let _e277 = (*words)[2u];
    param_5 = _e277;
    let _e278 = upper_half_u0028_u1_u003b((&param_5));
    axis = vec2<f32>(_e275, _e278);
    let _e281 = (*words)[3u];
    param_6 = _e281;
    let _e282 = lower_half_u0028_u1_u003b((&param_6));
    shorter = _e282;
    let _e284 = (*words)[3u];
    param_7 = _e284;
    param_8 = 16711680u;
    let _e285 = number_u0028_u1_u003b_u1_u003b((&param_7), (&param_8));
    opacity = (_e285 / 65536f);
    let _e287 = axis;
    let _e288 = axis;
    inverse = (1f / dot(_e287, _e288));
    let _e291 = opacity;
    param_9 = _e291;
    let _e292 = hull_opacity;
    param_10 = _e292;
    let _e293 = larger_u0028_f1_u003b_f1_u003b((&param_9), (&param_10));
    let _e294 = cutoff;
    param_11 = (_e293 / _e294);
    param_12 = 1f;
    let _e296 = larger_u0028_f1_u003b_f1_u003b((&param_11), (&param_12));
    reach = (2f * log(_e296));
    let _e299 = reach;
    let _e300 = axis;
    let _e301 = axis;
    let _e303 = shorter;
    let _e304 = shorter;
    let _e306 = inverse;
    let _e308 = axis;
    let _e311 = axis;
    box = sqrt((((_e300 * _e301) + ((_e308.yx * ((_e303 * _e304) * _e306)) * _e311.yx)) * _e299));
    let _e317 = open;
    phi_261_ = _e317;
    if _e317 {
        let _e319 = from_[0u];
        let _e322 = box[0u];
        phi_261_ = (abs(_e319) < (_e322 + 1.5f));
    }
    let _e326 = phi_261_;
    phi_271_ = _e326;
    if _e326 {
        let _e328 = from_[1u];
        let _e331 = box[1u];
        phi_271_ = (abs(_e328) < (_e331 + 1.5f));
    }
    let _e335 = phi_271_;
    if !(_e335) {
        return;
    }
    let _e337 = inverse;
    let _e339 = axis;
    along = (_e339 * (0.8493218f * _e337));
    let _e341 = inverse;
    let _e344 = shorter;
    let _e347 = axis[1u];
    let _e350 = axis[0u];
    across = (vec2<f32>(-(_e347), _e350) * ((0.8493218f * sqrt(_e341)) / _e344));
    let _e354 = along[0u];
    let _e356 = across[0u];
    right = vec2<f32>(_e354, _e356);
    let _e358 = right;
    let _e359 = right;
    bend = exp2((-2f * dot(_e358, _e359)));
    let _e364 = (*words)[0u];
    param_13 = _e364;
    param_14 = 1073741824u;
    let _e365 = number_u0028_u1_u003b_u1_u003b((&param_13), (&param_14));
    let _e368 = (*words)[0u];
    low = ((_e365 / 1073741800f) + select(0f, 2f, (bitcast<i32>(_e368) < 0i)));
    let _e374 = (*words)[3u];
    param_15 = _e374;
    param_16 = 2130706432u;
    let _e375 = number_u0028_u1_u003b_u1_u003b((&param_15), (&param_16));
    let _e378 = (*words)[3u];
    high = ((_e375 / 16777216f) + select(0f, 128f, (bitcast<i32>(_e378) < 0i)));
    let _e384 = (*words)[0u];
    param_17 = _e384;
    param_18 = 1072693248u;
    let _e385 = number_u0028_u1_u003b_u1_u003b((&param_17), (&param_18));
    let _e388 = (*words)[1u];
    param_19 = _e388;
    param_20 = 1072693248u;
    let _e389 = number_u0028_u1_u003b_u1_u003b((&param_19), (&param_20));
    let _e391 = high;
    let _e393 = low;
    color = vec3<f32>((_e385 * 0.000000000932233f), (_e389 * 0.000000000932233f), (((4f * _e391) + _e393) / 1023f));
    let _e397 = opacity;
    opacity = (_e397 / 255f);
    let _e399 = from_;
    from_ = (_e399 - vec2(1.5f));
    let _e402 = from_;
    let _e403 = along;
    let _e405 = from_;
    let _e406 = across;
    deviation = vec2<f32>(dot(_e402, _e403), dot(_e405, _e406));
    most = 0f;
    let _e409 = deviation;
    let _e410 = deviation;
    weight = exp2(-(dot(_e409, _e410)));
    let _e414 = opacity;
    let _e415 = weight;
    let _e417 = weight;
    alpha = select(0f, (_e414 * _e415), (_e417 >= 0.00000000000000001f));
    let _e420 = deviation;
    let _e422 = right;
    let _e424 = right;
    param_21 = -(dot(((_e420 * 2f) + _e422), _e424));
    param_22 = 60f;
    let _e427 = smaller_u0028_f1_u003b_f1_u003b((&param_21), (&param_22));
    factor = exp2(_e427);
    let _e429 = alpha;
    param_23 = _e429;
    param_24 = 0.99f;
    let _e430 = smaller_u0028_f1_u003b_f1_u003b((&param_23), (&param_24));
    covers = _e430;
    let _e432 = pixels[0i];
    pixel = _e432;
    let _e433 = covers;
    let _e435 = pixel[3u];
    let _e437 = covers;
    let _e438 = least;
    share = select(0f, (_e433 * _e435), (_e437 >= _e438));
    let _e441 = pixel;
    let _e443 = share;
    let _e444 = color;
    let _e446 = (_e441.xyz + (_e444 * _e443));
    let _e448 = pixel[3u];
    let _e449 = share;
    pixel = vec4<f32>(_e446.x, _e446.y, _e446.z, (_e448 - _e449));
    let _e455 = pixel;
    pixels[0i] = _e455;
    let _e457 = most;
    param_25 = _e457;
    let _e459 = pixel[3u];
    param_26 = _e459;
    let _e460 = larger_u0028_f1_u003b_f1_u003b((&param_25), (&param_26));
    most = _e460;
    let _e461 = factor;
    let _e462 = alpha;
    alpha = (_e462 * _e461);
    let _e464 = bend;
    let _e465 = factor;
    factor = (_e465 * _e464);
    let _e467 = alpha;
    param_27 = _e467;
    param_28 = 0.99f;
    let _e468 = smaller_u0028_f1_u003b_f1_u003b((&param_27), (&param_28));
    covers_1 = _e468;
    let _e470 = pixels[1i];
    pixel_1 = _e470;
    let _e471 = covers_1;
    let _e473 = pixel_1[3u];
    let _e475 = covers_1;
    let _e476 = least;
    share_1 = select(0f, (_e471 * _e473), (_e475 >= _e476));
    let _e479 = pixel_1;
    let _e481 = share_1;
    let _e482 = color;
    let _e484 = (_e479.xyz + (_e482 * _e481));
    let _e486 = pixel_1[3u];
    let _e487 = share_1;
    pixel_1 = vec4<f32>(_e484.x, _e484.y, _e484.z, (_e486 - _e487));
    let _e493 = pixel_1;
    pixels[1i] = _e493;
    let _e495 = most;
    param_29 = _e495;
    let _e497 = pixel_1[3u];
    param_30 = _e497;
    let _e498 = larger_u0028_f1_u003b_f1_u003b((&param_29), (&param_30));
    most = _e498;
    let _e499 = factor;
    let _e500 = alpha;
    alpha = (_e500 * _e499);
    let _e502 = bend;
    let _e503 = factor;
    factor = (_e503 * _e502);
    let _e505 = alpha;
    param_31 = _e505;
    param_32 = 0.99f;
    let _e506 = smaller_u0028_f1_u003b_f1_u003b((&param_31), (&param_32));
    covers_2 = _e506;
    let _e508 = pixels[2i];
    pixel_2 = _e508;
    let _e509 = covers_2;
    let _e511 = pixel_2[3u];
    let _e513 = covers_2;
    let _e514 = least;
    share_2 = select(0f, (_e509 * _e511), (_e513 >= _e514));
    let _e517 = pixel_2;
    let _e519 = share_2;
    let _e520 = color;
    let _e522 = (_e517.xyz + (_e520 * _e519));
    let _e524 = pixel_2[3u];
    let _e525 = share_2;
    pixel_2 = vec4<f32>(_e522.x, _e522.y, _e522.z, (_e524 - _e525));
    let _e531 = pixel_2;
    pixels[2i] = _e531;
    let _e533 = most;
    param_33 = _e533;
    let _e535 = pixel_2[3u];
    param_34 = _e535;
    let _e536 = larger_u0028_f1_u003b_f1_u003b((&param_33), (&param_34));
    most = _e536;
    let _e537 = factor;
    let _e538 = alpha;
    alpha = (_e538 * _e537);
    let _e540 = bend;
    let _e541 = factor;
    factor = (_e541 * _e540);
    let _e543 = alpha;
    param_35 = _e543;
    param_36 = 0.99f;
    let _e544 = smaller_u0028_f1_u003b_f1_u003b((&param_35), (&param_36));
    covers_3 = _e544;
    let _e546 = pixels[3i];
    pixel_3 = _e546;
    let _e547 = covers_3;
    let _e549 = pixel_3[3u];
    let _e551 = covers_3;
    let _e552 = least;
    share_3 = select(0f, (_e547 * _e549), (_e551 >= _e552));
    let _e555 = pixel_3;
    let _e557 = share_3;
    let _e558 = color;
    let _e560 = (_e555.xyz + (_e558 * _e557));
    let _e562 = pixel_3[3u];
    let _e563 = share_3;
    pixel_3 = vec4<f32>(_e560.x, _e560.y, _e560.z, (_e562 - _e563));
    let _e569 = pixel_3;
    pixels[3i] = _e569;
    let _e571 = most;
    param_37 = _e571;
    let _e573 = pixel_3[3u];
    param_38 = _e573;
    let _e574 = larger_u0028_f1_u003b_f1_u003b((&param_37), (&param_38));
    most = _e574;
    let _e575 = factor;
    let _e576 = alpha;
    alpha = (_e576 * _e575);
    let _e578 = bend;
    let _e579 = factor;
    factor = (_e579 * _e578);
    let _e582 = along[1u];
    let _e584 = across[1u];
    let _e586 = deviation;
    deviation = (_e586 + vec2<f32>(_e582, _e584));
    let _e588 = deviation;
    let _e589 = deviation;
    weight_1 = exp2(-(dot(_e588, _e589)));
    let _e593 = opacity;
    let _e594 = weight_1;
    let _e596 = weight_1;
    alpha_1 = select(0f, (_e593 * _e594), (_e596 >= 0.00000000000000001f));
    let _e599 = deviation;
    let _e601 = right;
    let _e603 = right;
    param_39 = -(dot(((_e599 * 2f) + _e601), _e603));
    param_40 = 60f;
    let _e606 = smaller_u0028_f1_u003b_f1_u003b((&param_39), (&param_40));
    factor_1 = exp2(_e606);
    let _e608 = alpha_1;
    param_41 = _e608;
    param_42 = 0.99f;
    let _e609 = smaller_u0028_f1_u003b_f1_u003b((&param_41), (&param_42));
    covers_4 = _e609;
    let _e611 = pixels[4i];
    pixel_4 = _e611;
    let _e612 = covers_4;
    let _e614 = pixel_4[3u];
    let _e616 = covers_4;
    let _e617 = least;
    share_4 = select(0f, (_e612 * _e614), (_e616 >= _e617));
    let _e620 = pixel_4;
    let _e622 = share_4;
    let _e623 = color;
    let _e625 = (_e620.xyz + (_e623 * _e622));
    let _e627 = pixel_4[3u];
    let _e628 = share_4;
    pixel_4 = vec4<f32>(_e625.x, _e625.y, _e625.z, (_e627 - _e628));
    let _e634 = pixel_4;
    pixels[4i] = _e634;
    let _e636 = most;
    param_43 = _e636;
    let _e638 = pixel_4[3u];
    param_44 = _e638;
    let _e639 = larger_u0028_f1_u003b_f1_u003b((&param_43), (&param_44));
    most = _e639;
    let _e640 = factor_1;
    let _e641 = alpha_1;
    alpha_1 = (_e641 * _e640);
    let _e643 = bend;
    let _e644 = factor_1;
    factor_1 = (_e644 * _e643);
    let _e646 = alpha_1;
    param_45 = _e646;
    param_46 = 0.99f;
    let _e647 = smaller_u0028_f1_u003b_f1_u003b((&param_45), (&param_46));
    covers_5 = _e647;
    let _e649 = pixels[5i];
    pixel_5 = _e649;
    let _e650 = covers_5;
    let _e652 = pixel_5[3u];
    let _e654 = covers_5;
    let _e655 = least;
    share_5 = select(0f, (_e650 * _e652), (_e654 >= _e655));
    let _e658 = pixel_5;
    let _e660 = share_5;
    let _e661 = color;
    let _e663 = (_e658.xyz + (_e661 * _e660));
    let _e665 = pixel_5[3u];
    let _e666 = share_5;
    pixel_5 = vec4<f32>(_e663.x, _e663.y, _e663.z, (_e665 - _e666));
    let _e672 = pixel_5;
    pixels[5i] = _e672;
    let _e674 = most;
    param_47 = _e674;
    let _e676 = pixel_5[3u];
    param_48 = _e676;
    let _e677 = larger_u0028_f1_u003b_f1_u003b((&param_47), (&param_48));
    most = _e677;
    let _e678 = factor_1;
    let _e679 = alpha_1;
    alpha_1 = (_e679 * _e678);
    let _e681 = bend;
    let _e682 = factor_1;
    factor_1 = (_e682 * _e681);
    let _e684 = alpha_1;
    param_49 = _e684;
    param_50 = 0.99f;
    let _e685 = smaller_u0028_f1_u003b_f1_u003b((&param_49), (&param_50));
    covers_6 = _e685;
    let _e687 = pixels[6i];
    pixel_6 = _e687;
    let _e688 = covers_6;
    let _e690 = pixel_6[3u];
    let _e692 = covers_6;
    let _e693 = least;
    share_6 = select(0f, (_e688 * _e690), (_e692 >= _e693));
    let _e696 = pixel_6;
    let _e698 = share_6;
    let _e699 = color;
    let _e701 = (_e696.xyz + (_e699 * _e698));
    let _e703 = pixel_6[3u];
    let _e704 = share_6;
    pixel_6 = vec4<f32>(_e701.x, _e701.y, _e701.z, (_e703 - _e704));
    let _e710 = pixel_6;
    pixels[6i] = _e710;
    let _e712 = most;
    param_51 = _e712;
    let _e714 = pixel_6[3u];
    param_52 = _e714;
    let _e715 = larger_u0028_f1_u003b_f1_u003b((&param_51), (&param_52));
    most = _e715;
    let _e716 = factor_1;
    let _e717 = alpha_1;
    alpha_1 = (_e717 * _e716);
    let _e719 = bend;
    let _e720 = factor_1;
    factor_1 = (_e720 * _e719);
    let _e722 = alpha_1;
    param_53 = _e722;
    param_54 = 0.99f;
    let _e723 = smaller_u0028_f1_u003b_f1_u003b((&param_53), (&param_54));
    covers_7 = _e723;
    let _e725 = pixels[7i];
    pixel_7 = _e725;
    let _e726 = covers_7;
    let _e728 = pixel_7[3u];
    let _e730 = covers_7;
    let _e731 = least;
    share_7 = select(0f, (_e726 * _e728), (_e730 >= _e731));
    let _e734 = pixel_7;
    let _e736 = share_7;
    let _e737 = color;
    let _e739 = (_e734.xyz + (_e737 * _e736));
    let _e741 = pixel_7[3u];
    let _e742 = share_7;
    pixel_7 = vec4<f32>(_e739.x, _e739.y, _e739.z, (_e741 - _e742));
    let _e748 = pixel_7;
    pixels[7i] = _e748;
    let _e750 = most;
    param_55 = _e750;
    let _e752 = pixel_7[3u];
    param_56 = _e752;
    let _e753 = larger_u0028_f1_u003b_f1_u003b((&param_55), (&param_56));
    most = _e753;
    let _e754 = factor_1;
    let _e755 = alpha_1;
    alpha_1 = (_e755 * _e754);
    let _e757 = bend;
    let _e758 = factor_1;
    factor_1 = (_e758 * _e757);
    let _e761 = along[1u];
    let _e763 = across[1u];
    let _e765 = deviation;
    deviation = (_e765 + vec2<f32>(_e761, _e763));
    let _e767 = deviation;
    let _e768 = deviation;
    weight_2 = exp2(-(dot(_e767, _e768)));
    let _e772 = opacity;
    let _e773 = weight_2;
    let _e775 = weight_2;
    alpha_2 = select(0f, (_e772 * _e773), (_e775 >= 0.00000000000000001f));
    let _e778 = deviation;
    let _e780 = right;
    let _e782 = right;
    param_57 = -(dot(((_e778 * 2f) + _e780), _e782));
    param_58 = 60f;
    let _e785 = smaller_u0028_f1_u003b_f1_u003b((&param_57), (&param_58));
    factor_2 = exp2(_e785);
    let _e787 = alpha_2;
    param_59 = _e787;
    param_60 = 0.99f;
    let _e788 = smaller_u0028_f1_u003b_f1_u003b((&param_59), (&param_60));
    covers_8 = _e788;
    let _e790 = pixels[8i];
    pixel_8 = _e790;
    let _e791 = covers_8;
    let _e793 = pixel_8[3u];
    let _e795 = covers_8;
    let _e796 = least;
    share_8 = select(0f, (_e791 * _e793), (_e795 >= _e796));
    let _e799 = pixel_8;
    let _e801 = share_8;
    let _e802 = color;
    let _e804 = (_e799.xyz + (_e802 * _e801));
    let _e806 = pixel_8[3u];
    let _e807 = share_8;
    pixel_8 = vec4<f32>(_e804.x, _e804.y, _e804.z, (_e806 - _e807));
    let _e813 = pixel_8;
    pixels[8i] = _e813;
    let _e815 = most;
    param_61 = _e815;
    let _e817 = pixel_8[3u];
    param_62 = _e817;
    let _e818 = larger_u0028_f1_u003b_f1_u003b((&param_61), (&param_62));
    most = _e818;
    let _e819 = factor_2;
    let _e820 = alpha_2;
    alpha_2 = (_e820 * _e819);
    let _e822 = bend;
    let _e823 = factor_2;
    factor_2 = (_e823 * _e822);
    let _e825 = alpha_2;
    param_63 = _e825;
    param_64 = 0.99f;
    let _e826 = smaller_u0028_f1_u003b_f1_u003b((&param_63), (&param_64));
    covers_9 = _e826;
    let _e828 = pixels[9i];
    pixel_9 = _e828;
    let _e829 = covers_9;
    let _e831 = pixel_9[3u];
    let _e833 = covers_9;
    let _e834 = least;
    share_9 = select(0f, (_e829 * _e831), (_e833 >= _e834));
    let _e837 = pixel_9;
    let _e839 = share_9;
    let _e840 = color;
    let _e842 = (_e837.xyz + (_e840 * _e839));
    let _e844 = pixel_9[3u];
    let _e845 = share_9;
    pixel_9 = vec4<f32>(_e842.x, _e842.y, _e842.z, (_e844 - _e845));
    let _e851 = pixel_9;
    pixels[9i] = _e851;
    let _e853 = most;
    param_65 = _e853;
    let _e855 = pixel_9[3u];
    param_66 = _e855;
    let _e856 = larger_u0028_f1_u003b_f1_u003b((&param_65), (&param_66));
    most = _e856;
    let _e857 = factor_2;
    let _e858 = alpha_2;
    alpha_2 = (_e858 * _e857);
    let _e860 = bend;
    let _e861 = factor_2;
    factor_2 = (_e861 * _e860);
    let _e863 = alpha_2;
    param_67 = _e863;
    param_68 = 0.99f;
    let _e864 = smaller_u0028_f1_u003b_f1_u003b((&param_67), (&param_68));
    covers_10 = _e864;
    let _e866 = pixels[10i];
    pixel_10 = _e866;
    let _e867 = covers_10;
    let _e869 = pixel_10[3u];
    let _e871 = covers_10;
    let _e872 = least;
    share_10 = select(0f, (_e867 * _e869), (_e871 >= _e872));
    let _e875 = pixel_10;
    let _e877 = share_10;
    let _e878 = color;
    let _e880 = (_e875.xyz + (_e878 * _e877));
    let _e882 = pixel_10[3u];
    let _e883 = share_10;
    pixel_10 = vec4<f32>(_e880.x, _e880.y, _e880.z, (_e882 - _e883));
    let _e889 = pixel_10;
    pixels[10i] = _e889;
    let _e891 = most;
    param_69 = _e891;
    let _e893 = pixel_10[3u];
    param_70 = _e893;
    let _e894 = larger_u0028_f1_u003b_f1_u003b((&param_69), (&param_70));
    most = _e894;
    let _e895 = factor_2;
    let _e896 = alpha_2;
    alpha_2 = (_e896 * _e895);
    let _e898 = bend;
    let _e899 = factor_2;
    factor_2 = (_e899 * _e898);
    let _e901 = alpha_2;
    param_71 = _e901;
    param_72 = 0.99f;
    let _e902 = smaller_u0028_f1_u003b_f1_u003b((&param_71), (&param_72));
    covers_11 = _e902;
    let _e904 = pixels[11i];
    pixel_11 = _e904;
    let _e905 = covers_11;
    let _e907 = pixel_11[3u];
    let _e909 = covers_11;
    let _e910 = least;
    share_11 = select(0f, (_e905 * _e907), (_e909 >= _e910));
    let _e913 = pixel_11;
    let _e915 = share_11;
    let _e916 = color;
    let _e918 = (_e913.xyz + (_e916 * _e915));
    let _e920 = pixel_11[3u];
    let _e921 = share_11;
    pixel_11 = vec4<f32>(_e918.x, _e918.y, _e918.z, (_e920 - _e921));
    let _e927 = pixel_11;
    pixels[11i] = _e927;
    let _e929 = most;
    param_73 = _e929;
    let _e931 = pixel_11[3u];
    param_74 = _e931;
    let _e932 = larger_u0028_f1_u003b_f1_u003b((&param_73), (&param_74));
    most = _e932;
    let _e933 = factor_2;
    let _e934 = alpha_2;
    alpha_2 = (_e934 * _e933);
    let _e936 = bend;
    let _e937 = factor_2;
    factor_2 = (_e937 * _e936);
    let _e940 = along[1u];
    let _e942 = across[1u];
    let _e944 = deviation;
    deviation = (_e944 + vec2<f32>(_e940, _e942));
    let _e946 = deviation;
    let _e947 = deviation;
    weight_3 = exp2(-(dot(_e946, _e947)));
    let _e951 = opacity;
    let _e952 = weight_3;
    let _e954 = weight_3;
    alpha_3 = select(0f, (_e951 * _e952), (_e954 >= 0.00000000000000001f));
    let _e957 = deviation;
    let _e959 = right;
    let _e961 = right;
    param_75 = -(dot(((_e957 * 2f) + _e959), _e961));
    param_76 = 60f;
    let _e964 = smaller_u0028_f1_u003b_f1_u003b((&param_75), (&param_76));
    factor_3 = exp2(_e964);
    let _e966 = alpha_3;
    param_77 = _e966;
    param_78 = 0.99f;
    let _e967 = smaller_u0028_f1_u003b_f1_u003b((&param_77), (&param_78));
    covers_12 = _e967;
    let _e969 = pixels[12i];
    pixel_12 = _e969;
    let _e970 = covers_12;
    let _e972 = pixel_12[3u];
    let _e974 = covers_12;
    let _e975 = least;
    share_12 = select(0f, (_e970 * _e972), (_e974 >= _e975));
    let _e978 = pixel_12;
    let _e980 = share_12;
    let _e981 = color;
    let _e983 = (_e978.xyz + (_e981 * _e980));
    let _e985 = pixel_12[3u];
    let _e986 = share_12;
    pixel_12 = vec4<f32>(_e983.x, _e983.y, _e983.z, (_e985 - _e986));
    let _e992 = pixel_12;
    pixels[12i] = _e992;
    let _e994 = most;
    param_79 = _e994;
    let _e996 = pixel_12[3u];
    param_80 = _e996;
    let _e997 = larger_u0028_f1_u003b_f1_u003b((&param_79), (&param_80));
    most = _e997;
    let _e998 = factor_3;
    let _e999 = alpha_3;
    alpha_3 = (_e999 * _e998);
    let _e1001 = bend;
    let _e1002 = factor_3;
    factor_3 = (_e1002 * _e1001);
    let _e1004 = alpha_3;
    param_81 = _e1004;
    param_82 = 0.99f;
    let _e1005 = smaller_u0028_f1_u003b_f1_u003b((&param_81), (&param_82));
    covers_13 = _e1005;
    let _e1007 = pixels[13i];
    pixel_13 = _e1007;
    let _e1008 = covers_13;
    let _e1010 = pixel_13[3u];
    let _e1012 = covers_13;
    let _e1013 = least;
    share_13 = select(0f, (_e1008 * _e1010), (_e1012 >= _e1013));
    let _e1016 = pixel_13;
    let _e1018 = share_13;
    let _e1019 = color;
    let _e1021 = (_e1016.xyz + (_e1019 * _e1018));
    let _e1023 = pixel_13[3u];
    let _e1024 = share_13;
    pixel_13 = vec4<f32>(_e1021.x, _e1021.y, _e1021.z, (_e1023 - _e1024));
    let _e1030 = pixel_13;
    pixels[13i] = _e1030;
    let _e1032 = most;
    param_83 = _e1032;
    let _e1034 = pixel_13[3u];
    param_84 = _e1034;
    let _e1035 = larger_u0028_f1_u003b_f1_u003b((&param_83), (&param_84));
    most = _e1035;
    let _e1036 = factor_3;
    let _e1037 = alpha_3;
    alpha_3 = (_e1037 * _e1036);
    let _e1039 = bend;
    let _e1040 = factor_3;
    factor_3 = (_e1040 * _e1039);
    let _e1042 = alpha_3;
    param_85 = _e1042;
    param_86 = 0.99f;
    let _e1043 = smaller_u0028_f1_u003b_f1_u003b((&param_85), (&param_86));
    covers_14 = _e1043;
    let _e1045 = pixels[14i];
    pixel_14 = _e1045;
    let _e1046 = covers_14;
    let _e1048 = pixel_14[3u];
    let _e1050 = covers_14;
    let _e1051 = least;
    share_14 = select(0f, (_e1046 * _e1048), (_e1050 >= _e1051));
    let _e1054 = pixel_14;
    let _e1056 = share_14;
    let _e1057 = color;
    let _e1059 = (_e1054.xyz + (_e1057 * _e1056));
    let _e1061 = pixel_14[3u];
    let _e1062 = share_14;
    pixel_14 = vec4<f32>(_e1059.x, _e1059.y, _e1059.z, (_e1061 - _e1062));
    let _e1068 = pixel_14;
    pixels[14i] = _e1068;
    let _e1070 = most;
    param_87 = _e1070;
    let _e1072 = pixel_14[3u];
    param_88 = _e1072;
    let _e1073 = larger_u0028_f1_u003b_f1_u003b((&param_87), (&param_88));
    most = _e1073;
    let _e1074 = factor_3;
    let _e1075 = alpha_3;
    alpha_3 = (_e1075 * _e1074);
    let _e1077 = bend;
    let _e1078 = factor_3;
    factor_3 = (_e1078 * _e1077);
    let _e1080 = alpha_3;
    param_89 = _e1080;
    param_90 = 0.99f;
    let _e1081 = smaller_u0028_f1_u003b_f1_u003b((&param_89), (&param_90));
    covers_15 = _e1081;
    let _e1083 = pixels[15i];
    pixel_15 = _e1083;
    let _e1084 = covers_15;
    let _e1086 = pixel_15[3u];
    let _e1088 = covers_15;
    let _e1089 = least;
    share_15 = select(0f, (_e1084 * _e1086), (_e1088 >= _e1089));
    let _e1092 = pixel_15;
    let _e1094 = share_15;
    let _e1095 = color;
    let _e1097 = (_e1092.xyz + (_e1095 * _e1094));
    let _e1099 = pixel_15[3u];
    let _e1100 = share_15;
    pixel_15 = vec4<f32>(_e1097.x, _e1097.y, _e1097.z, (_e1099 - _e1100));
    let _e1106 = pixel_15;
    pixels[15i] = _e1106;
    let _e1108 = most;
    param_91 = _e1108;
    let _e1110 = pixel_15[3u];
    param_92 = _e1110;
    let _e1111 = larger_u0028_f1_u003b_f1_u003b((&param_91), (&param_92));
    most = _e1111;
    let _e1112 = factor_3;
    let _e1113 = alpha_3;
    alpha_3 = (_e1113 * _e1112);
    let _e1115 = bend;
    let _e1116 = factor_3;
    factor_3 = (_e1116 * _e1115);
    let _e1119 = along[1u];
    let _e1121 = across[1u];
    let _e1123 = deviation;
    deviation = (_e1123 + vec2<f32>(_e1119, _e1121));
    let _e1125 = shaded;
    shaded = (_e1125 + 16u);
    let _e1127 = most;
    let _e1128 = full;
    open = (_e1127 >= _e1128);
    return;
}

fn step_back_u0028_u1_u003b(chain: ptr<function, u32>) -> u32 {
    var local: u32;

    let _e90 = (*chain);
    if ((_e90 & 7u) > 1u) {
        let _e93 = (*chain);
        local = (_e93 - 1u);
    } else {
        let _e95 = (*chain);
        let _e100 = unnamed_1.bins[((540698u + _e95) - 1u)];
        local = _e100;
    }
    let _e101 = local;
    return _e101;
}

fn key_at_u0028_u1_u003b(i: ptr<function, u32>) -> u32 {
    let _e89 = (*i);
    let _e94 = unnamed.keys[(_e89 >> bitcast<u32>(1u))];
    let _e95 = (*i);
    return ((_e94 >> bitcast<u32>((16u * (_e95 & 1u)))) & 65535u);
}

fn nearer_u0028_u1_u003b_u1_u003b(a_2: ptr<function, u32>, b_2: ptr<function, u32>) -> bool {
    var key: u32;
    var param_93: u32;
    var than: u32;
    var param_94: u32;
    var phi_1292_: bool;

    let _e94 = (*a_2);
    param_93 = _e94;
    let _e95 = key_at_u0028_u1_u003b((&param_93));
    key = _e95;
    let _e96 = (*b_2);
    param_94 = _e96;
    let _e97 = key_at_u0028_u1_u003b((&param_94));
    than = _e97;
    let _e98 = key;
    let _e99 = than;
    let _e100 = (_e98 > _e99);
    phi_1292_ = _e100;
    if !(_e100) {
        let _e102 = key;
        let _e103 = than;
        let _e105 = (*a_2);
        let _e106 = (*b_2);
        phi_1292_ = ((_e102 == _e103) && (_e105 > _e106));
    }
    let _e110 = phi_1292_;
    return _e110;
}

fn blend_tile_u0028_u1_u003b(tile: ptr<function, u32>) {
    var wide: u32;
    var blocks: u32;
    var here: u32;
    var everywhere: u32;
    var going: bool;
    var block: u32;
    var local_1: u32;
    var near: u32;
    var local_2: u32;
    var other: u32;
    var local_3: u32;
    var wider: bool;
    var param_95: u32;
    var param_96: u32;
    var rest: u32;
    var param_97: u32;
    var param_98: vec4<u32>;
    var phi_1418_: bool;
    var phi_1419_: bool;
    var phi_1457_: bool;

    let _e108 = unnamed_1.bins[1i];
    wide = _e108;
    let _e109 = (*tile);
    let _e113 = unnamed_1.bins[(34u + _e109)];
    let _e114 = wide;
    blocks = (_e113 | _e114);
    here = 0u;
    everywhere = 0u;
    let _e116 = blocks;
    going = (_e116 != 0u);
    loop {
        let _e118 = going;
        if _e118 {
            let _e119 = here;
            let _e120 = everywhere;
            if ((_e119 | _e120) == 0u) {
                let _e123 = blocks;
                block = bitcast<u32>(firstLeadingBit(_e123));
                let _e126 = block;
                let _e129 = blocks;
                blocks = (_e129 ^ (1u << bitcast<u32>(_e126)));
                let _e131 = (*tile);
                let _e134 = block;
                let _e138 = unnamed_1.bins[((16418u + (_e131 * 32u)) + _e134)];
                here = _e138;
                let _e139 = wide;
                let _e140 = block;
                if (((_e139 >> bitcast<u32>(_e140)) & 1u) == 0u) {
                    local_1 = 0u;
                } else {
                    let _e145 = block;
                    let _e149 = unnamed_1.bins[(2u + _e145)];
                    local_1 = _e149;
                }
                let _e150 = local_1;
                everywhere = _e150;
            }
            let _e151 = here;
            if (_e151 == 0u) {
                local_2 = 0u;
            } else {
                let _e153 = here;
                let _e157 = unnamed_1.bins[(540698u + _e153)];
                local_2 = _e157;
            }
            let _e158 = local_2;
            near = _e158;
            let _e159 = everywhere;
            if (_e159 == 0u) {
                local_3 = 0u;
            } else {
                let _e161 = everywhere;
                let _e165 = unnamed_1.bins[(540698u + _e161)];
                local_3 = _e165;
            }
            let _e166 = local_3;
            other = _e166;
            let _e167 = here;
            let _e168 = (_e167 == 0u);
            phi_1419_ = _e168;
            if !(_e168) {
                let _e170 = everywhere;
                let _e171 = (_e170 != 0u);
                phi_1418_ = _e171;
                if _e171 {
                    let _e172 = other;
                    param_95 = _e172;
                    let _e173 = near;
                    param_96 = _e173;
                    let _e174 = nearer_u0028_u1_u003b_u1_u003b((&param_95), (&param_96));
                    phi_1418_ = _e174;
                }
                let _e176 = phi_1418_;
                phi_1419_ = _e176;
            }
            let _e178 = phi_1419_;
            wider = _e178;
            let _e179 = wider;
            let _e180 = everywhere;
            let _e181 = here;
            param_97 = select(_e181, _e180, _e179);
            let _e183 = step_back_u0028_u1_u003b((&param_97));
            rest = _e183;
            let _e184 = wider;
            let _e185 = here;
            let _e186 = rest;
            here = select(_e186, _e185, _e184);
            let _e188 = wider;
            let _e189 = rest;
            let _e190 = everywhere;
            everywhere = select(_e190, _e189, _e188);
            let _e192 = wider;
            let _e193 = other;
            let _e194 = near;
            let _e198 = unnamed_2.splats[select(_e194, _e193, _e192)];
            param_98 = _e198;
            put_u0028_vu4_u003b((&param_98));
        }
        let _e199 = open;
        phi_1457_ = _e199;
        if _e199 {
            let _e200 = blocks;
            let _e201 = here;
            let _e203 = everywhere;
            phi_1457_ = (((_e200 | _e201) | _e203) != 0u);
        }
        let _e207 = phi_1457_;
        going = _e207;
        continue;
        continuing {
            let _e208 = going;
            break if !(_e208);
        }
    }
    return;
}

fn read_uniforms_u0028_() {
    let _e89 = frame.fixed_scale;
    fixed_scale = _e89;
    let _e91 = frame.guard;
    guard = _e91;
    let _e93 = frame.hull_opacity;
    hull_opacity = _e93;
    let _e95 = frame.cutoff;
    cutoff = _e95;
    let _e97 = settings.cutoff;
    least = _e97;
    let _e99 = settings.full;
    full = _e99;
    return;
}

fn main_1() {
    var k: u32;
    var lane: u32;
    var place: vec2<u32>;
    var first: vec2<u32>;
    var tile_1: vec2<u32>;
    var param_99: u32;
    var k_1: u32;
    var pixel_16: vec2<u32>;

    shaded = 0u;
    open = true;
    k = 0u;
    loop {
        let _e96 = k;
        if (_e96 < 16u) {
            let _e98 = k;
            pixels[_e98] = vec4<f32>(0f, 0f, 0f, 1f);
            continue;
        } else {
            break;
        }
        continuing {
            let _e100 = k;
            k = (_e100 + bitcast<u32>(1i));
        }
    }
    let _e103 = gl_LocalInvocationIndex_1;
    lane = _e103;
    let _e104 = lane;
    let _e106 = lane;
    let _e111 = lane;
    let _e116 = lane;
    let _e120 = lane;
    let _e125 = lane;
    place = vec2<u32>((((_e104 & 1u) | ((_e106 >> bitcast<u32>(1u)) & 2u)) | ((_e111 >> bitcast<u32>(2u)) & 4u)), ((((_e116 >> bitcast<u32>(1u)) & 1u) | ((_e120 >> bitcast<u32>(2u)) & 2u)) | ((_e125 >> bitcast<u32>(3u)) & 4u)));
    read_uniforms_u0028_();
    let _e131 = gl_WorkGroupID_1;
    let _e135 = place;
    first = ((_e131.xy * vec2(32u)) + (vec2(4u) * _e135));
    let _e139 = first;
    middle = (vec2<f32>(_e139) + vec2(2f));
    let _e143 = first;
    let _e145 = frame.tile;
    tile_1 = (_e143 / vec2(u32(_e145)));
    let _e150 = tile_1[1u];
    let _e153 = tile_1[0u];
    param_99 = ((_e150 * 128u) + _e153);
    blend_tile_u0028_u1_u003b((&param_99));
    k_1 = 0u;
    loop {
        let _e155 = k_1;
        if (_e155 < 16u) {
            let _e157 = first;
            let _e158 = k_1;
            let _e160 = k_1;
            pixel_16 = (_e157 + vec2<u32>((_e158 % 4u), (_e160 / 4u)));
            let _e164 = pixel_16;
            let _e167 = frame.size;
            if all((vec2<f32>(_e164) < _e167)) {
                let _e170 = pixel_16;
                let _e172 = k_1;
                let _e174 = pixels[_e172];
                let _e175 = _e174.xyz;
                let _e176 = k_1;
                let _e179 = pixels[_e176][3u];
                textureStore(picture, bitcast<vec2<i32>>(_e170), vec4<f32>(_e175.x, _e175.y, _e175.z, (1f - _e179)));
            }
            continue;
        } else {
            break;
        }
        continuing {
            let _e185 = k_1;
            k_1 = (_e185 + bitcast<u32>(1i));
        }
    }
    let _e189 = settings.count;
    let _e191 = shaded;
    if ((_e189 != 0u) && (_e191 > 0u)) {
        let _e196 = shaded;
        let _e197 = atomicAdd((&unnamed_3.control.fragments), _e196);
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn main(@builtin(local_invocation_index) gl_LocalInvocationIndex: u32, @builtin(workgroup_id) gl_WorkGroupID: vec3<u32>) {
    gl_LocalInvocationIndex_1 = gl_LocalInvocationIndex;
    gl_WorkGroupID_1 = gl_WorkGroupID;
    main_1();
}
