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
    let _e93 = (*a);
    let _e94 = (*b);
    let _e95 = (*b);
    let _e96 = (*a);
    return select(_e93, _e94, (_e95 < _e96));
}

fn larger_u0028_f1_u003b_f1_u003b(a_1: ptr<function, f32>, b_1: ptr<function, f32>) -> f32 {
    let _e93 = (*a_1);
    let _e94 = (*b_1);
    let _e95 = (*b_1);
    let _e96 = (*a_1);
    return select(_e93, _e94, (_e95 > _e96));
}

fn upper_half_u0028_u1_u003b(word: ptr<function, u32>) -> f32 {
    let _e92 = (*word);
    let _e97 = (*word);
    return (bitcast<f32>(((((_e92 & 2147483647u) >> bitcast<u32>(3u)) & 268427264u) | (_e97 & 2147483648u))) * 5192297000000000000000000000000000f);
}

fn lower_half_u0028_u1_u003b(word_1: ptr<function, u32>) -> f32 {
    let _e92 = (*word_1);
    let _e95 = (*word_1);
    return (bitcast<f32>((((_e92 & 32767u) * 8192u) | ((_e95 & 32768u) * 65536u))) * 5192297000000000000000000000000000f);
}

fn number_u0028_u1_u003b_u1_u003b(word_2: ptr<function, u32>, mask: ptr<function, u32>) -> f32 {
    let _e93 = (*word_2);
    let _e94 = (*mask);
    return f32(bitcast<i32>((_e93 & _e94)));
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
    var phi_285_: bool;
    var phi_295_: bool;

    let _e261 = middle;
    let _e263 = (*words)[0u];
    param = _e263;
    param_1 = 1048575u;
    let _e264 = number_u0028_u1_u003b_u1_u003b((&param), (&param_1));
    let _e266 = (*words)[1u];
    param_2 = _e266;
    param_3 = 1048575u;
    let _e267 = number_u0028_u1_u003b_u1_u003b((&param_2), (&param_3));
    let _e269 = fixed_scale;
    let _e272 = guard;
    from_ = (_e261 - ((vec2<f32>(_e264, _e267) / vec2(_e269)) - vec2(_e272)));
    let _e277 = (*words)[2u];
    param_4 = _e277;
    let _e278 = lower_half_u0028_u1_u003b((&param_4));
    let _e280 = (*words)[2u];
    param_5 = _e280;
    let _e281 = upper_half_u0028_u1_u003b((&param_5));
    axis = vec2<f32>(_e278, _e281);
    let _e284 = (*words)[3u];
    param_6 = _e284;
    let _e285 = lower_half_u0028_u1_u003b((&param_6));
    shorter = _e285;
    let _e287 = (*words)[3u];
    param_7 = _e287;
    param_8 = 16711680u;
    let _e288 = number_u0028_u1_u003b_u1_u003b((&param_7), (&param_8));
    opacity = (_e288 / 65536f);
    let _e290 = axis;
    let _e291 = axis;
    inverse = (1f / dot(_e290, _e291));
    let _e294 = opacity;
    param_9 = _e294;
    let _e295 = hull_opacity;
    param_10 = _e295;
    let _e296 = larger_u0028_f1_u003b_f1_u003b((&param_9), (&param_10));
    let _e297 = cutoff;
    param_11 = (_e296 / _e297);
    param_12 = 1f;
    let _e299 = larger_u0028_f1_u003b_f1_u003b((&param_11), (&param_12));
    reach = (2f * log(_e299));
    let _e302 = reach;
    let _e303 = axis;
    let _e304 = axis;
    let _e306 = shorter;
    let _e307 = shorter;
    let _e309 = inverse;
    let _e311 = axis;
    let _e314 = axis;
    box = sqrt((((_e303 * _e304) + ((_e311.yx * ((_e306 * _e307) * _e309)) * _e314.yx)) * _e302));
    let _e320 = open;
    phi_285_ = _e320;
    if _e320 {
        let _e322 = from_[0u];
        let _e325 = box[0u];
        phi_285_ = (abs(_e322) < (_e325 + 1.5f));
    }
    let _e329 = phi_285_;
    phi_295_ = _e329;
    if _e329 {
        let _e331 = from_[1u];
        let _e334 = box[1u];
        phi_295_ = (abs(_e331) < (_e334 + 1.5f));
    }
    let _e338 = phi_295_;
    if !(_e338) {
        return;
    }
    let _e340 = inverse;
    let _e342 = axis;
    along = (_e342 * (0.8493218f * _e340));
    let _e344 = inverse;
    let _e347 = shorter;
    let _e350 = axis[1u];
    let _e353 = axis[0u];
    across = (vec2<f32>(-(_e350), _e353) * ((0.8493218f * sqrt(_e344)) / _e347));
    let _e357 = along[0u];
    let _e359 = across[0u];
    right = vec2<f32>(_e357, _e359);
    let _e361 = right;
    let _e362 = right;
    bend = exp2((-2f * dot(_e361, _e362)));
    let _e367 = (*words)[0u];
    param_13 = _e367;
    param_14 = 1073741824u;
    let _e368 = number_u0028_u1_u003b_u1_u003b((&param_13), (&param_14));
    let _e371 = (*words)[0u];
    low = ((_e368 / 1073741800f) + select(0f, 2f, (bitcast<i32>(_e371) < 0i)));
    let _e377 = (*words)[3u];
    param_15 = _e377;
    param_16 = 2130706432u;
    let _e378 = number_u0028_u1_u003b_u1_u003b((&param_15), (&param_16));
    let _e381 = (*words)[3u];
    high = ((_e378 / 16777216f) + select(0f, 128f, (bitcast<i32>(_e381) < 0i)));
    let _e387 = (*words)[0u];
    param_17 = _e387;
    param_18 = 1072693248u;
    let _e388 = number_u0028_u1_u003b_u1_u003b((&param_17), (&param_18));
    let _e391 = (*words)[1u];
    param_19 = _e391;
    param_20 = 1072693248u;
    let _e392 = number_u0028_u1_u003b_u1_u003b((&param_19), (&param_20));
    let _e394 = high;
    let _e396 = low;
    color = vec3<f32>((_e388 * 0.000000000932233f), (_e392 * 0.000000000932233f), (((4f * _e394) + _e396) / 1023f));
    let _e400 = opacity;
    opacity = (_e400 / 255f);
    let _e402 = from_;
    from_ = (_e402 - vec2(1.5f));
    let _e405 = from_;
    let _e406 = along;
    let _e408 = from_;
    let _e409 = across;
    deviation = vec2<f32>(dot(_e405, _e406), dot(_e408, _e409));
    most = 0f;
    let _e412 = deviation;
    let _e413 = deviation;
    weight = exp2(-(dot(_e412, _e413)));
    let _e417 = opacity;
    let _e418 = weight;
    let _e420 = weight;
    alpha = select(0f, (_e417 * _e418), (_e420 >= 0.00000000000000001f));
    let _e423 = deviation;
    let _e425 = right;
    let _e427 = right;
    param_21 = -(dot(((_e423 * 2f) + _e425), _e427));
    param_22 = 60f;
    let _e430 = smaller_u0028_f1_u003b_f1_u003b((&param_21), (&param_22));
    factor = exp2(_e430);
    let _e432 = alpha;
    param_23 = _e432;
    param_24 = 0.99f;
    let _e433 = smaller_u0028_f1_u003b_f1_u003b((&param_23), (&param_24));
    covers = _e433;
    let _e435 = pixels[0i];
    pixel = _e435;
    let _e436 = covers;
    let _e438 = pixel[3u];
    let _e440 = covers;
    let _e441 = least;
    share = select(0f, (_e436 * _e438), (_e440 >= _e441));
    let _e444 = pixel;
    let _e446 = share;
    let _e447 = color;
    let _e449 = (_e444.xyz + (_e447 * _e446));
    let _e451 = pixel[3u];
    let _e452 = share;
    pixel = vec4<f32>(_e449.x, _e449.y, _e449.z, (_e451 - _e452));
    let _e458 = pixel;
    pixels[0i] = _e458;
    let _e460 = most;
    param_25 = _e460;
    let _e462 = pixel[3u];
    param_26 = _e462;
    let _e463 = larger_u0028_f1_u003b_f1_u003b((&param_25), (&param_26));
    most = _e463;
    let _e464 = factor;
    let _e465 = alpha;
    alpha = (_e465 * _e464);
    let _e467 = bend;
    let _e468 = factor;
    factor = (_e468 * _e467);
    let _e470 = alpha;
    param_27 = _e470;
    param_28 = 0.99f;
    let _e471 = smaller_u0028_f1_u003b_f1_u003b((&param_27), (&param_28));
    covers_1 = _e471;
    let _e473 = pixels[1i];
    pixel_1 = _e473;
    let _e474 = covers_1;
    let _e476 = pixel_1[3u];
    let _e478 = covers_1;
    let _e479 = least;
    share_1 = select(0f, (_e474 * _e476), (_e478 >= _e479));
    let _e482 = pixel_1;
    let _e484 = share_1;
    let _e485 = color;
    let _e487 = (_e482.xyz + (_e485 * _e484));
    let _e489 = pixel_1[3u];
    let _e490 = share_1;
    pixel_1 = vec4<f32>(_e487.x, _e487.y, _e487.z, (_e489 - _e490));
    let _e496 = pixel_1;
    pixels[1i] = _e496;
    let _e498 = most;
    param_29 = _e498;
    let _e500 = pixel_1[3u];
    param_30 = _e500;
    let _e501 = larger_u0028_f1_u003b_f1_u003b((&param_29), (&param_30));
    most = _e501;
    let _e502 = factor;
    let _e503 = alpha;
    alpha = (_e503 * _e502);
    let _e505 = bend;
    let _e506 = factor;
    factor = (_e506 * _e505);
    let _e508 = alpha;
    param_31 = _e508;
    param_32 = 0.99f;
    let _e509 = smaller_u0028_f1_u003b_f1_u003b((&param_31), (&param_32));
    covers_2 = _e509;
    let _e511 = pixels[2i];
    pixel_2 = _e511;
    let _e512 = covers_2;
    let _e514 = pixel_2[3u];
    let _e516 = covers_2;
    let _e517 = least;
    share_2 = select(0f, (_e512 * _e514), (_e516 >= _e517));
    let _e520 = pixel_2;
    let _e522 = share_2;
    let _e523 = color;
    let _e525 = (_e520.xyz + (_e523 * _e522));
    let _e527 = pixel_2[3u];
    let _e528 = share_2;
    pixel_2 = vec4<f32>(_e525.x, _e525.y, _e525.z, (_e527 - _e528));
    let _e534 = pixel_2;
    pixels[2i] = _e534;
    let _e536 = most;
    param_33 = _e536;
    let _e538 = pixel_2[3u];
    param_34 = _e538;
    let _e539 = larger_u0028_f1_u003b_f1_u003b((&param_33), (&param_34));
    most = _e539;
    let _e540 = factor;
    let _e541 = alpha;
    alpha = (_e541 * _e540);
    let _e543 = bend;
    let _e544 = factor;
    factor = (_e544 * _e543);
    let _e546 = alpha;
    param_35 = _e546;
    param_36 = 0.99f;
    let _e547 = smaller_u0028_f1_u003b_f1_u003b((&param_35), (&param_36));
    covers_3 = _e547;
    let _e549 = pixels[3i];
    pixel_3 = _e549;
    let _e550 = covers_3;
    let _e552 = pixel_3[3u];
    let _e554 = covers_3;
    let _e555 = least;
    share_3 = select(0f, (_e550 * _e552), (_e554 >= _e555));
    let _e558 = pixel_3;
    let _e560 = share_3;
    let _e561 = color;
    let _e563 = (_e558.xyz + (_e561 * _e560));
    let _e565 = pixel_3[3u];
    let _e566 = share_3;
    pixel_3 = vec4<f32>(_e563.x, _e563.y, _e563.z, (_e565 - _e566));
    let _e572 = pixel_3;
    pixels[3i] = _e572;
    let _e574 = most;
    param_37 = _e574;
    let _e576 = pixel_3[3u];
    param_38 = _e576;
    let _e577 = larger_u0028_f1_u003b_f1_u003b((&param_37), (&param_38));
    most = _e577;
    let _e578 = factor;
    let _e579 = alpha;
    alpha = (_e579 * _e578);
    let _e581 = bend;
    let _e582 = factor;
    factor = (_e582 * _e581);
    let _e585 = along[1u];
    let _e587 = across[1u];
    let _e589 = deviation;
    deviation = (_e589 + vec2<f32>(_e585, _e587));
    let _e591 = deviation;
    let _e592 = deviation;
    weight_1 = exp2(-(dot(_e591, _e592)));
    let _e596 = opacity;
    let _e597 = weight_1;
    let _e599 = weight_1;
    alpha_1 = select(0f, (_e596 * _e597), (_e599 >= 0.00000000000000001f));
    let _e602 = deviation;
    let _e604 = right;
    let _e606 = right;
    param_39 = -(dot(((_e602 * 2f) + _e604), _e606));
    param_40 = 60f;
    let _e609 = smaller_u0028_f1_u003b_f1_u003b((&param_39), (&param_40));
    factor_1 = exp2(_e609);
    let _e611 = alpha_1;
    param_41 = _e611;
    param_42 = 0.99f;
    let _e612 = smaller_u0028_f1_u003b_f1_u003b((&param_41), (&param_42));
    covers_4 = _e612;
    let _e614 = pixels[4i];
    pixel_4 = _e614;
    let _e615 = covers_4;
    let _e617 = pixel_4[3u];
    let _e619 = covers_4;
    let _e620 = least;
    share_4 = select(0f, (_e615 * _e617), (_e619 >= _e620));
    let _e623 = pixel_4;
    let _e625 = share_4;
    let _e626 = color;
    let _e628 = (_e623.xyz + (_e626 * _e625));
    let _e630 = pixel_4[3u];
    let _e631 = share_4;
    pixel_4 = vec4<f32>(_e628.x, _e628.y, _e628.z, (_e630 - _e631));
    let _e637 = pixel_4;
    pixels[4i] = _e637;
    let _e639 = most;
    param_43 = _e639;
    let _e641 = pixel_4[3u];
    param_44 = _e641;
    let _e642 = larger_u0028_f1_u003b_f1_u003b((&param_43), (&param_44));
    most = _e642;
    let _e643 = factor_1;
    let _e644 = alpha_1;
    alpha_1 = (_e644 * _e643);
    let _e646 = bend;
    let _e647 = factor_1;
    factor_1 = (_e647 * _e646);
    let _e649 = alpha_1;
    param_45 = _e649;
    param_46 = 0.99f;
    let _e650 = smaller_u0028_f1_u003b_f1_u003b((&param_45), (&param_46));
    covers_5 = _e650;
    let _e652 = pixels[5i];
    pixel_5 = _e652;
    let _e653 = covers_5;
    let _e655 = pixel_5[3u];
    let _e657 = covers_5;
    let _e658 = least;
    share_5 = select(0f, (_e653 * _e655), (_e657 >= _e658));
    let _e661 = pixel_5;
    let _e663 = share_5;
    let _e664 = color;
    let _e666 = (_e661.xyz + (_e664 * _e663));
    let _e668 = pixel_5[3u];
    let _e669 = share_5;
    pixel_5 = vec4<f32>(_e666.x, _e666.y, _e666.z, (_e668 - _e669));
    let _e675 = pixel_5;
    pixels[5i] = _e675;
    let _e677 = most;
    param_47 = _e677;
    let _e679 = pixel_5[3u];
    param_48 = _e679;
    let _e680 = larger_u0028_f1_u003b_f1_u003b((&param_47), (&param_48));
    most = _e680;
    let _e681 = factor_1;
    let _e682 = alpha_1;
    alpha_1 = (_e682 * _e681);
    let _e684 = bend;
    let _e685 = factor_1;
    factor_1 = (_e685 * _e684);
    let _e687 = alpha_1;
    param_49 = _e687;
    param_50 = 0.99f;
    let _e688 = smaller_u0028_f1_u003b_f1_u003b((&param_49), (&param_50));
    covers_6 = _e688;
    let _e690 = pixels[6i];
    pixel_6 = _e690;
    let _e691 = covers_6;
    let _e693 = pixel_6[3u];
    let _e695 = covers_6;
    let _e696 = least;
    share_6 = select(0f, (_e691 * _e693), (_e695 >= _e696));
    let _e699 = pixel_6;
    let _e701 = share_6;
    let _e702 = color;
    let _e704 = (_e699.xyz + (_e702 * _e701));
    let _e706 = pixel_6[3u];
    let _e707 = share_6;
    pixel_6 = vec4<f32>(_e704.x, _e704.y, _e704.z, (_e706 - _e707));
    let _e713 = pixel_6;
    pixels[6i] = _e713;
    let _e715 = most;
    param_51 = _e715;
    let _e717 = pixel_6[3u];
    param_52 = _e717;
    let _e718 = larger_u0028_f1_u003b_f1_u003b((&param_51), (&param_52));
    most = _e718;
    let _e719 = factor_1;
    let _e720 = alpha_1;
    alpha_1 = (_e720 * _e719);
    let _e722 = bend;
    let _e723 = factor_1;
    factor_1 = (_e723 * _e722);
    let _e725 = alpha_1;
    param_53 = _e725;
    param_54 = 0.99f;
    let _e726 = smaller_u0028_f1_u003b_f1_u003b((&param_53), (&param_54));
    covers_7 = _e726;
    let _e728 = pixels[7i];
    pixel_7 = _e728;
    let _e729 = covers_7;
    let _e731 = pixel_7[3u];
    let _e733 = covers_7;
    let _e734 = least;
    share_7 = select(0f, (_e729 * _e731), (_e733 >= _e734));
    let _e737 = pixel_7;
    let _e739 = share_7;
    let _e740 = color;
    let _e742 = (_e737.xyz + (_e740 * _e739));
    let _e744 = pixel_7[3u];
    let _e745 = share_7;
    pixel_7 = vec4<f32>(_e742.x, _e742.y, _e742.z, (_e744 - _e745));
    let _e751 = pixel_7;
    pixels[7i] = _e751;
    let _e753 = most;
    param_55 = _e753;
    let _e755 = pixel_7[3u];
    param_56 = _e755;
    let _e756 = larger_u0028_f1_u003b_f1_u003b((&param_55), (&param_56));
    most = _e756;
    let _e757 = factor_1;
    let _e758 = alpha_1;
    alpha_1 = (_e758 * _e757);
    let _e760 = bend;
    let _e761 = factor_1;
    factor_1 = (_e761 * _e760);
    let _e764 = along[1u];
    let _e766 = across[1u];
    let _e768 = deviation;
    deviation = (_e768 + vec2<f32>(_e764, _e766));
    let _e770 = deviation;
    let _e771 = deviation;
    weight_2 = exp2(-(dot(_e770, _e771)));
    let _e775 = opacity;
    let _e776 = weight_2;
    let _e778 = weight_2;
    alpha_2 = select(0f, (_e775 * _e776), (_e778 >= 0.00000000000000001f));
    let _e781 = deviation;
    let _e783 = right;
    let _e785 = right;
    param_57 = -(dot(((_e781 * 2f) + _e783), _e785));
    param_58 = 60f;
    let _e788 = smaller_u0028_f1_u003b_f1_u003b((&param_57), (&param_58));
    factor_2 = exp2(_e788);
    let _e790 = alpha_2;
    param_59 = _e790;
    param_60 = 0.99f;
    let _e791 = smaller_u0028_f1_u003b_f1_u003b((&param_59), (&param_60));
    covers_8 = _e791;
    let _e793 = pixels[8i];
    pixel_8 = _e793;
    let _e794 = covers_8;
    let _e796 = pixel_8[3u];
    let _e798 = covers_8;
    let _e799 = least;
    share_8 = select(0f, (_e794 * _e796), (_e798 >= _e799));
    let _e802 = pixel_8;
    let _e804 = share_8;
    let _e805 = color;
    let _e807 = (_e802.xyz + (_e805 * _e804));
    let _e809 = pixel_8[3u];
    let _e810 = share_8;
    pixel_8 = vec4<f32>(_e807.x, _e807.y, _e807.z, (_e809 - _e810));
    let _e816 = pixel_8;
    pixels[8i] = _e816;
    let _e818 = most;
    param_61 = _e818;
    let _e820 = pixel_8[3u];
    param_62 = _e820;
    let _e821 = larger_u0028_f1_u003b_f1_u003b((&param_61), (&param_62));
    most = _e821;
    let _e822 = factor_2;
    let _e823 = alpha_2;
    alpha_2 = (_e823 * _e822);
    let _e825 = bend;
    let _e826 = factor_2;
    factor_2 = (_e826 * _e825);
    let _e828 = alpha_2;
    param_63 = _e828;
    param_64 = 0.99f;
    let _e829 = smaller_u0028_f1_u003b_f1_u003b((&param_63), (&param_64));
    covers_9 = _e829;
    let _e831 = pixels[9i];
    pixel_9 = _e831;
    let _e832 = covers_9;
    let _e834 = pixel_9[3u];
    let _e836 = covers_9;
    let _e837 = least;
    share_9 = select(0f, (_e832 * _e834), (_e836 >= _e837));
    let _e840 = pixel_9;
    let _e842 = share_9;
    let _e843 = color;
    let _e845 = (_e840.xyz + (_e843 * _e842));
    let _e847 = pixel_9[3u];
    let _e848 = share_9;
    pixel_9 = vec4<f32>(_e845.x, _e845.y, _e845.z, (_e847 - _e848));
    let _e854 = pixel_9;
    pixels[9i] = _e854;
    let _e856 = most;
    param_65 = _e856;
    let _e858 = pixel_9[3u];
    param_66 = _e858;
    let _e859 = larger_u0028_f1_u003b_f1_u003b((&param_65), (&param_66));
    most = _e859;
    let _e860 = factor_2;
    let _e861 = alpha_2;
    alpha_2 = (_e861 * _e860);
    let _e863 = bend;
    let _e864 = factor_2;
    factor_2 = (_e864 * _e863);
    let _e866 = alpha_2;
    param_67 = _e866;
    param_68 = 0.99f;
    let _e867 = smaller_u0028_f1_u003b_f1_u003b((&param_67), (&param_68));
    covers_10 = _e867;
    let _e869 = pixels[10i];
    pixel_10 = _e869;
    let _e870 = covers_10;
    let _e872 = pixel_10[3u];
    let _e874 = covers_10;
    let _e875 = least;
    share_10 = select(0f, (_e870 * _e872), (_e874 >= _e875));
    let _e878 = pixel_10;
    let _e880 = share_10;
    let _e881 = color;
    let _e883 = (_e878.xyz + (_e881 * _e880));
    let _e885 = pixel_10[3u];
    let _e886 = share_10;
    pixel_10 = vec4<f32>(_e883.x, _e883.y, _e883.z, (_e885 - _e886));
    let _e892 = pixel_10;
    pixels[10i] = _e892;
    let _e894 = most;
    param_69 = _e894;
    let _e896 = pixel_10[3u];
    param_70 = _e896;
    let _e897 = larger_u0028_f1_u003b_f1_u003b((&param_69), (&param_70));
    most = _e897;
    let _e898 = factor_2;
    let _e899 = alpha_2;
    alpha_2 = (_e899 * _e898);
    let _e901 = bend;
    let _e902 = factor_2;
    factor_2 = (_e902 * _e901);
    let _e904 = alpha_2;
    param_71 = _e904;
    param_72 = 0.99f;
    let _e905 = smaller_u0028_f1_u003b_f1_u003b((&param_71), (&param_72));
    covers_11 = _e905;
    let _e907 = pixels[11i];
    pixel_11 = _e907;
    let _e908 = covers_11;
    let _e910 = pixel_11[3u];
    let _e912 = covers_11;
    let _e913 = least;
    share_11 = select(0f, (_e908 * _e910), (_e912 >= _e913));
    let _e916 = pixel_11;
    let _e918 = share_11;
    let _e919 = color;
    let _e921 = (_e916.xyz + (_e919 * _e918));
    let _e923 = pixel_11[3u];
    let _e924 = share_11;
    pixel_11 = vec4<f32>(_e921.x, _e921.y, _e921.z, (_e923 - _e924));
    let _e930 = pixel_11;
    pixels[11i] = _e930;
    let _e932 = most;
    param_73 = _e932;
    let _e934 = pixel_11[3u];
    param_74 = _e934;
    let _e935 = larger_u0028_f1_u003b_f1_u003b((&param_73), (&param_74));
    most = _e935;
    let _e936 = factor_2;
    let _e937 = alpha_2;
    alpha_2 = (_e937 * _e936);
    let _e939 = bend;
    let _e940 = factor_2;
    factor_2 = (_e940 * _e939);
    let _e943 = along[1u];
    let _e945 = across[1u];
    let _e947 = deviation;
    deviation = (_e947 + vec2<f32>(_e943, _e945));
    let _e949 = deviation;
    let _e950 = deviation;
    weight_3 = exp2(-(dot(_e949, _e950)));
    let _e954 = opacity;
    let _e955 = weight_3;
    let _e957 = weight_3;
    alpha_3 = select(0f, (_e954 * _e955), (_e957 >= 0.00000000000000001f));
    let _e960 = deviation;
    let _e962 = right;
    let _e964 = right;
    param_75 = -(dot(((_e960 * 2f) + _e962), _e964));
    param_76 = 60f;
    let _e967 = smaller_u0028_f1_u003b_f1_u003b((&param_75), (&param_76));
    factor_3 = exp2(_e967);
    let _e969 = alpha_3;
    param_77 = _e969;
    param_78 = 0.99f;
    let _e970 = smaller_u0028_f1_u003b_f1_u003b((&param_77), (&param_78));
    covers_12 = _e970;
    let _e972 = pixels[12i];
    pixel_12 = _e972;
    let _e973 = covers_12;
    let _e975 = pixel_12[3u];
    let _e977 = covers_12;
    let _e978 = least;
    share_12 = select(0f, (_e973 * _e975), (_e977 >= _e978));
    let _e981 = pixel_12;
    let _e983 = share_12;
    let _e984 = color;
    let _e986 = (_e981.xyz + (_e984 * _e983));
    let _e988 = pixel_12[3u];
    let _e989 = share_12;
    pixel_12 = vec4<f32>(_e986.x, _e986.y, _e986.z, (_e988 - _e989));
    let _e995 = pixel_12;
    pixels[12i] = _e995;
    let _e997 = most;
    param_79 = _e997;
    let _e999 = pixel_12[3u];
    param_80 = _e999;
    let _e1000 = larger_u0028_f1_u003b_f1_u003b((&param_79), (&param_80));
    most = _e1000;
    let _e1001 = factor_3;
    let _e1002 = alpha_3;
    alpha_3 = (_e1002 * _e1001);
    let _e1004 = bend;
    let _e1005 = factor_3;
    factor_3 = (_e1005 * _e1004);
    let _e1007 = alpha_3;
    param_81 = _e1007;
    param_82 = 0.99f;
    let _e1008 = smaller_u0028_f1_u003b_f1_u003b((&param_81), (&param_82));
    covers_13 = _e1008;
    let _e1010 = pixels[13i];
    pixel_13 = _e1010;
    let _e1011 = covers_13;
    let _e1013 = pixel_13[3u];
    let _e1015 = covers_13;
    let _e1016 = least;
    share_13 = select(0f, (_e1011 * _e1013), (_e1015 >= _e1016));
    let _e1019 = pixel_13;
    let _e1021 = share_13;
    let _e1022 = color;
    let _e1024 = (_e1019.xyz + (_e1022 * _e1021));
    let _e1026 = pixel_13[3u];
    let _e1027 = share_13;
    pixel_13 = vec4<f32>(_e1024.x, _e1024.y, _e1024.z, (_e1026 - _e1027));
    let _e1033 = pixel_13;
    pixels[13i] = _e1033;
    let _e1035 = most;
    param_83 = _e1035;
    let _e1037 = pixel_13[3u];
    param_84 = _e1037;
    let _e1038 = larger_u0028_f1_u003b_f1_u003b((&param_83), (&param_84));
    most = _e1038;
    let _e1039 = factor_3;
    let _e1040 = alpha_3;
    alpha_3 = (_e1040 * _e1039);
    let _e1042 = bend;
    let _e1043 = factor_3;
    factor_3 = (_e1043 * _e1042);
    let _e1045 = alpha_3;
    param_85 = _e1045;
    param_86 = 0.99f;
    let _e1046 = smaller_u0028_f1_u003b_f1_u003b((&param_85), (&param_86));
    covers_14 = _e1046;
    let _e1048 = pixels[14i];
    pixel_14 = _e1048;
    let _e1049 = covers_14;
    let _e1051 = pixel_14[3u];
    let _e1053 = covers_14;
    let _e1054 = least;
    share_14 = select(0f, (_e1049 * _e1051), (_e1053 >= _e1054));
    let _e1057 = pixel_14;
    let _e1059 = share_14;
    let _e1060 = color;
    let _e1062 = (_e1057.xyz + (_e1060 * _e1059));
    let _e1064 = pixel_14[3u];
    let _e1065 = share_14;
    pixel_14 = vec4<f32>(_e1062.x, _e1062.y, _e1062.z, (_e1064 - _e1065));
    let _e1071 = pixel_14;
    pixels[14i] = _e1071;
    let _e1073 = most;
    param_87 = _e1073;
    let _e1075 = pixel_14[3u];
    param_88 = _e1075;
    let _e1076 = larger_u0028_f1_u003b_f1_u003b((&param_87), (&param_88));
    most = _e1076;
    let _e1077 = factor_3;
    let _e1078 = alpha_3;
    alpha_3 = (_e1078 * _e1077);
    let _e1080 = bend;
    let _e1081 = factor_3;
    factor_3 = (_e1081 * _e1080);
    let _e1083 = alpha_3;
    param_89 = _e1083;
    param_90 = 0.99f;
    let _e1084 = smaller_u0028_f1_u003b_f1_u003b((&param_89), (&param_90));
    covers_15 = _e1084;
    let _e1086 = pixels[15i];
    pixel_15 = _e1086;
    let _e1087 = covers_15;
    let _e1089 = pixel_15[3u];
    let _e1091 = covers_15;
    let _e1092 = least;
    share_15 = select(0f, (_e1087 * _e1089), (_e1091 >= _e1092));
    let _e1095 = pixel_15;
    let _e1097 = share_15;
    let _e1098 = color;
    let _e1100 = (_e1095.xyz + (_e1098 * _e1097));
    let _e1102 = pixel_15[3u];
    let _e1103 = share_15;
    pixel_15 = vec4<f32>(_e1100.x, _e1100.y, _e1100.z, (_e1102 - _e1103));
    let _e1109 = pixel_15;
    pixels[15i] = _e1109;
    let _e1111 = most;
    param_91 = _e1111;
    let _e1113 = pixel_15[3u];
    param_92 = _e1113;
    let _e1114 = larger_u0028_f1_u003b_f1_u003b((&param_91), (&param_92));
    most = _e1114;
    let _e1115 = factor_3;
    let _e1116 = alpha_3;
    alpha_3 = (_e1116 * _e1115);
    let _e1118 = bend;
    let _e1119 = factor_3;
    factor_3 = (_e1119 * _e1118);
    let _e1122 = along[1u];
    let _e1124 = across[1u];
    let _e1126 = deviation;
    deviation = (_e1126 + vec2<f32>(_e1122, _e1124));
    let _e1128 = shaded;
    shaded = (_e1128 + 16u);
    let _e1130 = most;
    let _e1131 = full;
    open = (_e1130 >= _e1131);
    return;
}

fn step_back_u0028_u1_u003b(chain: ptr<function, u32>) -> u32 {
    var local: u32;

    let _e93 = (*chain);
    if ((_e93 & 7u) > 1u) {
        let _e96 = (*chain);
        local = (_e96 - 1u);
    } else {
        let _e98 = (*chain);
        let _e103 = unnamed_1.bins[((576602u + _e98) - 1u)];
        local = _e103;
    }
    let _e104 = local;
    return _e104;
}

fn key_at_u0028_u1_u003b(i: ptr<function, u32>) -> u32 {
    let _e92 = (*i);
    let _e97 = unnamed.keys[(_e92 >> bitcast<u32>(1u))];
    let _e98 = (*i);
    return ((_e97 >> bitcast<u32>((16u * (_e98 & 1u)))) & 65535u);
}

fn bins_tile_u0028_u1_u003b_vu2_u003b(level: ptr<function, u32>, at: ptr<function, vec2<u32>>) -> u32 {
    let _e93 = (*level);
    let _e101 = (*at)[1u];
    let _e102 = (*level);
    let _e109 = (*at)[0u];
    return (((((16384u - (16384u >> bitcast<u32>((4u * _e93)))) / 15u) * 16u) + (_e101 * (128u >> bitcast<u32>((2u * _e102))))) + _e109);
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
    var some: bool;
    var param_105: u32;
    var param_106: u32;
    var param_107: u32;
    var param_108: u32;
    var param_109: u32;
    var param_110: u32;
    var param_111: u32;
    var param_112: u32;
    var param_113: vec4<u32>;
    var phi_1512_: bool;
    var phi_1526_: bool;
    var phi_1527_: bool;
    var phi_1528_: bool;
    var phi_1549_: bool;
    var phi_1563_: bool;
    var phi_1564_: bool;
    var phi_1565_: bool;
    var phi_1586_: bool;
    var phi_1600_: bool;
    var phi_1601_: bool;
    var phi_1602_: bool;
    var phi_1623_: bool;
    var phi_1637_: bool;
    var phi_1638_: bool;
    var phi_1639_: bool;
    var phi_1655_: bool;
    var phi_1688_: bool;
    var phi_1721_: bool;
    var phi_1754_: bool;
    var phi_1797_: bool;

    param_93 = 0u;
    let _e123 = (*at_1);
    param_94 = _e123;
    let _e124 = bins_tile_u0028_u1_u003b_vu2_u003b((&param_93), (&param_94));
    let _e125 = (*at_1);
    param_95 = 1u;
    param_96 = (_e125 >> bitcast<vec2<u32>>(vec2(2u)));
    let _e129 = bins_tile_u0028_u1_u003b_vu2_u003b((&param_95), (&param_96));
    let _e130 = (*at_1);
    param_97 = 2u;
    param_98 = (_e130 >> bitcast<vec2<u32>>(vec2(4u)));
    let _e134 = bins_tile_u0028_u1_u003b_vu2_u003b((&param_97), (&param_98));
    param_99 = 3u;
    param_100 = vec2<u32>(0u, 0u);
    let _e135 = bins_tile_u0028_u1_u003b_vu2_u003b((&param_99), (&param_100));
    tiles = vec4<u32>(_e124, _e129, _e134, _e135);
    let _e138 = tiles[0u];
    let _e142 = unnamed_1.bins[(1u + _e138)];
    let _e144 = tiles[1u];
    let _e148 = unnamed_1.bins[(1u + _e144)];
    let _e151 = tiles[2u];
    let _e155 = unnamed_1.bins[(1u + _e151)];
    let _e158 = tiles[3u];
    let _e162 = unnamed_1.bins[(1u + _e158)];
    blocks = (((_e142 | _e148) | _e155) | _e162);
    chains = vec4<u32>(0u, 0u, 0u, 0u);
    first = vec4<u32>(0u, 0u, 0u, 0u);
    keys = vec4<u32>(0u, 0u, 0u, 0u);
    let _e164 = blocks;
    going = (_e164 != 0u);
    loop {
        let _e166 = going;
        if _e166 {
            let _e167 = chains;
            if all((_e167 == vec4<u32>(0u, 0u, 0u, 0u))) {
                let _e170 = blocks;
                block = bitcast<u32>(firstLeadingBit(_e170));
                let _e173 = block;
                let _e176 = blocks;
                blocks = (_e176 ^ (1u << bitcast<u32>(_e173)));
                let _e179 = tiles[0u];
                let _e182 = block;
                let _e186 = unnamed_1.bins[((17474u + (_e179 * 32u)) + _e182)];
                chains[0u] = _e186;
                let _e189 = tiles[1u];
                let _e192 = block;
                let _e196 = unnamed_1.bins[((17474u + (_e189 * 32u)) + _e192)];
                chains[1u] = _e196;
                let _e199 = tiles[2u];
                let _e202 = block;
                let _e206 = unnamed_1.bins[((17474u + (_e199 * 32u)) + _e202)];
                chains[2u] = _e206;
                let _e209 = tiles[3u];
                let _e212 = block;
                let _e216 = unnamed_1.bins[((17474u + (_e209 * 32u)) + _e212)];
                chains[3u] = _e216;
                let _e219 = chains[0u];
                if (_e219 != 0u) {
                    let _e222 = chains[0u];
                    let _e226 = unnamed_1.bins[(576602u + _e222)];
                    first[0u] = _e226;
                    let _e229 = first[0u];
                    param_101 = _e229;
                    let _e230 = key_at_u0028_u1_u003b((&param_101));
                    keys[0u] = _e230;
                }
                let _e233 = chains[1u];
                if (_e233 != 0u) {
                    let _e236 = chains[1u];
                    let _e240 = unnamed_1.bins[(576602u + _e236)];
                    first[1u] = _e240;
                    let _e243 = first[1u];
                    param_102 = _e243;
                    let _e244 = key_at_u0028_u1_u003b((&param_102));
                    keys[1u] = _e244;
                }
                let _e247 = chains[2u];
                if (_e247 != 0u) {
                    let _e250 = chains[2u];
                    let _e254 = unnamed_1.bins[(576602u + _e250)];
                    first[2u] = _e254;
                    let _e257 = first[2u];
                    param_103 = _e257;
                    let _e258 = key_at_u0028_u1_u003b((&param_103));
                    keys[2u] = _e258;
                }
                let _e261 = chains[3u];
                if (_e261 != 0u) {
                    let _e264 = chains[3u];
                    let _e268 = unnamed_1.bins[(576602u + _e264)];
                    first[3u] = _e268;
                    let _e271 = first[3u];
                    param_104 = _e271;
                    let _e272 = key_at_u0028_u1_u003b((&param_104));
                    keys[3u] = _e272;
                }
            }
            splat = 0u;
            key = 0u;
            some = false;
            let _e275 = chains[0u];
            let _e276 = (_e275 != 0u);
            phi_1528_ = _e276;
            if _e276 {
                let _e277 = some;
                let _e278 = !(_e277);
                phi_1512_ = _e278;
                if !(_e278) {
                    let _e281 = keys[0u];
                    let _e282 = key;
                    phi_1512_ = (_e281 > _e282);
                }
                let _e285 = phi_1512_;
                phi_1527_ = _e285;
                if !(_e285) {
                    let _e288 = keys[0u];
                    let _e289 = key;
                    let _e290 = (_e288 == _e289);
                    phi_1526_ = _e290;
                    if _e290 {
                        let _e292 = first[0u];
                        let _e293 = splat;
                        phi_1526_ = (_e292 > _e293);
                    }
                    let _e296 = phi_1526_;
                    phi_1527_ = _e296;
                }
                let _e298 = phi_1527_;
                phi_1528_ = _e298;
            }
            let _e300 = phi_1528_;
            if _e300 {
                let _e302 = first[0u];
                splat = _e302;
                let _e304 = keys[0u];
                key = _e304;
                some = true;
            }
            let _e306 = chains[1u];
            let _e307 = (_e306 != 0u);
            phi_1565_ = _e307;
            if _e307 {
                let _e308 = some;
                let _e309 = !(_e308);
                phi_1549_ = _e309;
                if !(_e309) {
                    let _e312 = keys[1u];
                    let _e313 = key;
                    phi_1549_ = (_e312 > _e313);
                }
                let _e316 = phi_1549_;
                phi_1564_ = _e316;
                if !(_e316) {
                    let _e319 = keys[1u];
                    let _e320 = key;
                    let _e321 = (_e319 == _e320);
                    phi_1563_ = _e321;
                    if _e321 {
                        let _e323 = first[1u];
                        let _e324 = splat;
                        phi_1563_ = (_e323 > _e324);
                    }
                    let _e327 = phi_1563_;
                    phi_1564_ = _e327;
                }
                let _e329 = phi_1564_;
                phi_1565_ = _e329;
            }
            let _e331 = phi_1565_;
            if _e331 {
                let _e333 = first[1u];
                splat = _e333;
                let _e335 = keys[1u];
                key = _e335;
                some = true;
            }
            let _e337 = chains[2u];
            let _e338 = (_e337 != 0u);
            phi_1602_ = _e338;
            if _e338 {
                let _e339 = some;
                let _e340 = !(_e339);
                phi_1586_ = _e340;
                if !(_e340) {
                    let _e343 = keys[2u];
                    let _e344 = key;
                    phi_1586_ = (_e343 > _e344);
                }
                let _e347 = phi_1586_;
                phi_1601_ = _e347;
                if !(_e347) {
                    let _e350 = keys[2u];
                    let _e351 = key;
                    let _e352 = (_e350 == _e351);
                    phi_1600_ = _e352;
                    if _e352 {
                        let _e354 = first[2u];
                        let _e355 = splat;
                        phi_1600_ = (_e354 > _e355);
                    }
                    let _e358 = phi_1600_;
                    phi_1601_ = _e358;
                }
                let _e360 = phi_1601_;
                phi_1602_ = _e360;
            }
            let _e362 = phi_1602_;
            if _e362 {
                let _e364 = first[2u];
                splat = _e364;
                let _e366 = keys[2u];
                key = _e366;
                some = true;
            }
            let _e368 = chains[3u];
            let _e369 = (_e368 != 0u);
            phi_1639_ = _e369;
            if _e369 {
                let _e370 = some;
                let _e371 = !(_e370);
                phi_1623_ = _e371;
                if !(_e371) {
                    let _e374 = keys[3u];
                    let _e375 = key;
                    phi_1623_ = (_e374 > _e375);
                }
                let _e378 = phi_1623_;
                phi_1638_ = _e378;
                if !(_e378) {
                    let _e381 = keys[3u];
                    let _e382 = key;
                    let _e383 = (_e381 == _e382);
                    phi_1637_ = _e383;
                    if _e383 {
                        let _e385 = first[3u];
                        let _e386 = splat;
                        phi_1637_ = (_e385 > _e386);
                    }
                    let _e389 = phi_1637_;
                    phi_1638_ = _e389;
                }
                let _e391 = phi_1638_;
                phi_1639_ = _e391;
            }
            let _e393 = phi_1639_;
            if _e393 {
                let _e395 = first[3u];
                splat = _e395;
                let _e397 = keys[3u];
                key = _e397;
                some = true;
            }
            let _e399 = chains[0u];
            let _e400 = (_e399 != 0u);
            phi_1655_ = _e400;
            if _e400 {
                let _e402 = first[0u];
                let _e403 = splat;
                phi_1655_ = (_e402 == _e403);
            }
            let _e406 = phi_1655_;
            if _e406 {
                let _e408 = chains[0u];
                param_105 = _e408;
                let _e409 = step_back_u0028_u1_u003b((&param_105));
                chains[0u] = _e409;
                let _e412 = chains[0u];
                if (_e412 != 0u) {
                    let _e415 = chains[0u];
                    let _e419 = unnamed_1.bins[(576602u + _e415)];
                    first[0u] = _e419;
                    let _e422 = first[0u];
                    param_106 = _e422;
                    let _e423 = key_at_u0028_u1_u003b((&param_106));
                    keys[0u] = _e423;
                }
            }
            let _e426 = chains[1u];
            let _e427 = (_e426 != 0u);
            phi_1688_ = _e427;
            if _e427 {
                let _e429 = first[1u];
                let _e430 = splat;
                phi_1688_ = (_e429 == _e430);
            }
            let _e433 = phi_1688_;
            if _e433 {
                let _e435 = chains[1u];
                param_107 = _e435;
                let _e436 = step_back_u0028_u1_u003b((&param_107));
                chains[1u] = _e436;
                let _e439 = chains[1u];
                if (_e439 != 0u) {
                    let _e442 = chains[1u];
                    let _e446 = unnamed_1.bins[(576602u + _e442)];
                    first[1u] = _e446;
                    let _e449 = first[1u];
                    param_108 = _e449;
                    let _e450 = key_at_u0028_u1_u003b((&param_108));
                    keys[1u] = _e450;
                }
            }
            let _e453 = chains[2u];
            let _e454 = (_e453 != 0u);
            phi_1721_ = _e454;
            if _e454 {
                let _e456 = first[2u];
                let _e457 = splat;
                phi_1721_ = (_e456 == _e457);
            }
            let _e460 = phi_1721_;
            if _e460 {
                let _e462 = chains[2u];
                param_109 = _e462;
                let _e463 = step_back_u0028_u1_u003b((&param_109));
                chains[2u] = _e463;
                let _e466 = chains[2u];
                if (_e466 != 0u) {
                    let _e469 = chains[2u];
                    let _e473 = unnamed_1.bins[(576602u + _e469)];
                    first[2u] = _e473;
                    let _e476 = first[2u];
                    param_110 = _e476;
                    let _e477 = key_at_u0028_u1_u003b((&param_110));
                    keys[2u] = _e477;
                }
            }
            let _e480 = chains[3u];
            let _e481 = (_e480 != 0u);
            phi_1754_ = _e481;
            if _e481 {
                let _e483 = first[3u];
                let _e484 = splat;
                phi_1754_ = (_e483 == _e484);
            }
            let _e487 = phi_1754_;
            if _e487 {
                let _e489 = chains[3u];
                param_111 = _e489;
                let _e490 = step_back_u0028_u1_u003b((&param_111));
                chains[3u] = _e490;
                let _e493 = chains[3u];
                if (_e493 != 0u) {
                    let _e496 = chains[3u];
                    let _e500 = unnamed_1.bins[(576602u + _e496)];
                    first[3u] = _e500;
                    let _e503 = first[3u];
                    param_112 = _e503;
                    let _e504 = key_at_u0028_u1_u003b((&param_112));
                    keys[3u] = _e504;
                }
            }
            let _e506 = splat;
            let _e509 = unnamed_2.splats[_e506];
            param_113 = _e509;
            put_u0028_vu4_u003b((&param_113));
        }
        let _e510 = open;
        phi_1797_ = _e510;
        if _e510 {
            let _e511 = blocks;
            let _e513 = chains;
            phi_1797_ = ((_e511 != 0u) || any((_e513 != vec4<u32>(0u, 0u, 0u, 0u))));
        }
        let _e518 = phi_1797_;
        going = _e518;
        continue;
        continuing {
            let _e519 = going;
            break if !(_e519);
        }
    }
    return;
}

fn read_uniforms_u0028_() {
    let _e92 = frame.fixed_scale;
    fixed_scale = _e92;
    let _e94 = frame.guard;
    guard = _e94;
    let _e96 = frame.hull_opacity;
    hull_opacity = _e96;
    let _e98 = frame.cutoff;
    cutoff = _e98;
    let _e100 = settings.cutoff;
    least = _e100;
    let _e102 = settings.full;
    full = _e102;
    return;
}

fn main_1() {
    var k: u32;
    var lane: u32;
    var place: vec2<u32>;
    var first_1: vec2<u32>;
    var param_114: vec2<u32>;
    var k_1: u32;
    var pixel_16: vec2<u32>;

    shaded = 0u;
    open = true;
    k = 0u;
    loop {
        let _e98 = k;
        if (_e98 < 16u) {
            let _e100 = k;
            pixels[_e100] = vec4<f32>(0f, 0f, 0f, 1f);
            continue;
        } else {
            break;
        }
        continuing {
            let _e102 = k;
            k = (_e102 + bitcast<u32>(1i));
        }
    }
    let _e105 = gl_LocalInvocationIndex_1;
    lane = _e105;
    let _e106 = lane;
    let _e108 = lane;
    let _e113 = lane;
    let _e118 = lane;
    let _e122 = lane;
    let _e127 = lane;
    place = vec2<u32>((((_e106 & 1u) | ((_e108 >> bitcast<u32>(1u)) & 2u)) | ((_e113 >> bitcast<u32>(2u)) & 4u)), ((((_e118 >> bitcast<u32>(1u)) & 1u) | ((_e122 >> bitcast<u32>(2u)) & 2u)) | ((_e127 >> bitcast<u32>(3u)) & 4u)));
    read_uniforms_u0028_();
    let _e133 = gl_WorkGroupID_1;
    let _e137 = place;
    first_1 = ((_e133.xy * vec2(32u)) + (vec2(4u) * _e137));
    let _e141 = first_1;
    middle = (vec2<f32>(_e141) + vec2(2f));
    let _e145 = middle;
    let _e147 = frame.tile;
    param_114 = vec2<u32>((_e145 / vec2(_e147)));
    blend_tiles_u0028_vu2_u003b((&param_114));
    k_1 = 0u;
    loop {
        let _e151 = k_1;
        if (_e151 < 16u) {
            let _e153 = first_1;
            let _e154 = k_1;
            let _e156 = k_1;
            pixel_16 = (_e153 + vec2<u32>((_e154 % 4u), (_e156 / 4u)));
            let _e160 = pixel_16;
            let _e162 = frame.size;
            if all((_e160 < vec2<u32>(_e162))) {
                let _e166 = pixel_16;
                let _e168 = k_1;
                let _e170 = pixels[_e168];
                let _e171 = _e170.xyz;
                let _e172 = k_1;
                let _e175 = pixels[_e172][3u];
                textureStore(picture, bitcast<vec2<i32>>(_e166), vec4<f32>(_e171.x, _e171.y, _e171.z, (1f - _e175)));
            }
            continue;
        } else {
            break;
        }
        continuing {
            let _e181 = k_1;
            k_1 = (_e181 + bitcast<u32>(1i));
        }
    }
    let _e185 = settings.count;
    let _e187 = shaded;
    if ((_e185 != 0u) && (_e187 > 0u)) {
        let _e192 = shaded;
        let _e193 = atomicAdd((&unnamed_3.control.fragments), _e192);
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn main(@builtin(local_invocation_index) gl_LocalInvocationIndex: u32, @builtin(workgroup_id) gl_WorkGroupID: vec3<u32>) {
    gl_LocalInvocationIndex_1 = gl_LocalInvocationIndex;
    gl_WorkGroupID_1 = gl_WorkGroupID;
    main_1();
}
