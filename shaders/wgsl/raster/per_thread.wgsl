struct Row {
    alpha: f32,
    factor: f32,
    bend: f32,
    color: vec3<f32>,
}

struct Footprint {
    deviation: vec2<f32>,
    right: vec2<f32>,
    down: vec2<f32>,
    bend: f32,
    opacity: f32,
    color: vec3<f32>,
}

struct Square {
    pixels: array<vec4<f32>, 16>,
    open: bool,
    fragments: u32,
    middle: vec2<f32>,
}

struct Uniforms {
    fixed_scale: f32,
    guard: f32,
    quad_opacity: f32,
    cutoff: f32,
    alpha_min: f32,
    saturation: f32,
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

fn store_pixel_u0028_vu2_u003b_vu2_u003b_vf4_u003b_b1_u003b(at: ptr<function, vec2<u32>>, size_1: ptr<function, vec2<u32>>, pixel_1: ptr<function, vec4<f32>>, open_1: ptr<function, bool>) {
    var param_32: vec4<f32>;
    var param_33: bool;

    let _e7 = (*at);
    let _e8 = (*size_1);
    if all((_e7 < _e8)) {
        let _e11 = (*at);
        let _e13 = (*pixel_1);
        param_32 = _e13;
        let _e14 = (*open_1);
        param_33 = _e14;
        let _e15 = filled_u0028_vf4_u003b_b1_u003b((&param_32), (&param_33));
        textureStore(image, bitcast<vec2<i32>>(_e11), _e15);
    }
    return;
}

fn store_row_u0028_vu2_u003b_vu2_u003b_vf4_u003b_vf4_u003b_vf4_u003b_vf4_u003b_b1_u003b(at_1: ptr<function, vec2<u32>>, size_2: ptr<function, vec2<u32>>, a: ptr<function, vec4<f32>>, b: ptr<function, vec4<f32>>, c: ptr<function, vec4<f32>>, d: ptr<function, vec4<f32>>, open_2: ptr<function, bool>) {
    var param_34: vec2<u32>;
    var param_35: vec2<u32>;
    var param_36: vec4<f32>;
    var param_37: bool;
    var param_38: vec2<u32>;
    var param_39: vec2<u32>;
    var param_40: vec4<f32>;
    var param_41: bool;
    var param_42: vec2<u32>;
    var param_43: vec2<u32>;
    var param_44: vec4<f32>;
    var param_45: bool;
    var param_46: vec2<u32>;
    var param_47: vec2<u32>;
    var param_48: vec4<f32>;
    var param_49: bool;

    let _e26 = (*at_1);
    param_34 = _e26;
    let _e27 = (*size_2);
    param_35 = _e27;
    let _e28 = (*a);
    param_36 = _e28;
    let _e29 = (*open_2);
    param_37 = _e29;
    store_pixel_u0028_vu2_u003b_vu2_u003b_vf4_u003b_b1_u003b((&param_34), (&param_35), (&param_36), (&param_37));
    let _e30 = (*at_1);
    param_38 = (_e30 + vec2<u32>(1u, 0u));
    let _e32 = (*size_2);
    param_39 = _e32;
    let _e33 = (*b);
    param_40 = _e33;
    let _e34 = (*open_2);
    param_41 = _e34;
    store_pixel_u0028_vu2_u003b_vu2_u003b_vf4_u003b_b1_u003b((&param_38), (&param_39), (&param_40), (&param_41));
    let _e35 = (*at_1);
    param_42 = (_e35 + vec2<u32>(2u, 0u));
    let _e37 = (*size_2);
    param_43 = _e37;
    let _e38 = (*c);
    param_44 = _e38;
    let _e39 = (*open_2);
    param_45 = _e39;
    store_pixel_u0028_vu2_u003b_vu2_u003b_vf4_u003b_b1_u003b((&param_42), (&param_43), (&param_44), (&param_45));
    let _e40 = (*at_1);
    param_46 = (_e40 + vec2<u32>(3u, 0u));
    let _e42 = (*size_2);
    param_47 = _e42;
    let _e43 = (*d);
    param_48 = _e43;
    let _e44 = (*open_2);
    param_49 = _e44;
    store_pixel_u0028_vu2_u003b_vu2_u003b_vf4_u003b_b1_u003b((&param_46), (&param_47), (&param_48), (&param_49));
    return;
}

fn larger_u0028_f1_u003b_f1_u003b(a_1: ptr<function, f32>, b_1: ptr<function, f32>) -> f32 {
    let _e2 = (*a_1);
    let _e3 = (*b_1);
    let _e4 = (*b_1);
    let _e5 = (*a_1);
    return select(_e2, _e3, (_e4 > _e5));
}

fn smaller_u0028_f1_u003b_f1_u003b(a_2: ptr<function, f32>, b_2: ptr<function, f32>) -> f32 {
    let _e2 = (*a_2);
    let _e3 = (*b_2);
    let _e4 = (*b_2);
    let _e5 = (*a_2);
    return select(_e2, _e3, (_e4 < _e5));
}

fn blend_pixel_u0028_vf4_u003b_struct_u002d_Row_u002d_f1_u002d_f1_u002d_f1_u002d_vf31_u003b_f1_u003b_f1_u003b(pixel_2: ptr<function, vec4<f32>>, row: ptr<function, Row>, most: ptr<function, f32>, alpha_min: ptr<function, f32>) {
    var covers: f32;
    var param_50: f32;
    var param_51: f32;
    var share: f32;
    var param_52: f32;
    var param_53: f32;

    let _e14 = (*row).alpha;
    param_50 = _e14;
    param_51 = 0.99f;
    let _e15 = smaller_u0028_f1_u003b_f1_u003b((&param_50), (&param_51));
    covers = _e15;
    let _e16 = covers;
    let _e18 = (*pixel_2)[3u];
    let _e20 = covers;
    let _e21 = (*alpha_min);
    share = select(0f, (_e16 * _e18), (_e20 >= _e21));
    let _e24 = (*pixel_2);
    let _e26 = share;
    let _e28 = (*row).color;
    let _e30 = (_e24.xyz + (_e28 * _e26));
    let _e32 = (*pixel_2)[3u];
    let _e33 = share;
    (*pixel_2) = vec4<f32>(_e30.x, _e30.y, _e30.z, (_e32 - _e33));
    let _e39 = (*most);
    param_52 = _e39;
    let _e41 = (*pixel_2)[3u];
    param_53 = _e41;
    let _e42 = larger_u0028_f1_u003b_f1_u003b((&param_52), (&param_53));
    (*most) = _e42;
    let _e44 = (*row).factor;
    let _e46 = (*row).alpha;
    (*row).alpha = (_e46 * _e44);
    let _e50 = (*row).bend;
    let _e52 = (*row).factor;
    (*row).factor = (_e52 * _e50);
    return;
}

fn blend_row_u0028_vf4_u003b_vf4_u003b_vf4_u003b_vf4_u003b_struct_u002d_Footprint_u002d_vf2_u002d_vf2_u002d_vf2_u002d_f1_u002d_f1_u002d_vf31_u003b_f1_u003b_f1_u003b(a_3: ptr<function, vec4<f32>>, b_3: ptr<function, vec4<f32>>, c_1: ptr<function, vec4<f32>>, d_1: ptr<function, vec4<f32>>, splat: ptr<function, Footprint>, most_1: ptr<function, f32>, alpha_min_1: ptr<function, f32>) {
    var weight: f32;
    var row_1: Row;
    var param_54: f32;
    var param_55: f32;
    var param_56: vec4<f32>;
    var param_57: Row;
    var param_58: f32;
    var param_59: f32;
    var param_60: vec4<f32>;
    var param_61: Row;
    var param_62: f32;
    var param_63: f32;
    var param_64: vec4<f32>;
    var param_65: Row;
    var param_66: f32;
    var param_67: f32;
    var param_68: vec4<f32>;
    var param_69: Row;
    var param_70: f32;
    var param_71: f32;

    let _e32 = (*splat).deviation;
    let _e34 = (*splat).deviation;
    weight = exp2(-(dot(_e32, _e34)));
    let _e39 = (*splat).opacity;
    let _e40 = weight;
    let _e42 = weight;
    row_1.alpha = select(0f, (_e39 * _e40), (_e42 >= 0.00000000000000000000000000000000000075f));
    let _e47 = (*splat).deviation;
    let _e50 = (*splat).right;
    let _e53 = (*splat).right;
    param_54 = -(dot(((_e47 * 2f) + _e50), _e53));
    param_55 = 60f;
    let _e56 = smaller_u0028_f1_u003b_f1_u003b((&param_54), (&param_55));
    row_1.factor = exp2(_e56);
    let _e60 = (*splat).bend;
    row_1.bend = _e60;
    let _e63 = (*splat).color;
    row_1.color = _e63;
    let _e65 = (*a_3);
    param_56 = _e65;
    let _e66 = row_1;
    param_57 = _e66;
    let _e67 = (*most_1);
    param_58 = _e67;
    let _e68 = (*alpha_min_1);
    param_59 = _e68;
    blend_pixel_u0028_vf4_u003b_struct_u002d_Row_u002d_f1_u002d_f1_u002d_f1_u002d_vf31_u003b_f1_u003b_f1_u003b((&param_56), (&param_57), (&param_58), (&param_59));
    let _e69 = param_56;
    (*a_3) = _e69;
    let _e70 = param_57;
    row_1 = _e70;
    let _e71 = param_58;
    (*most_1) = _e71;
    let _e72 = (*b_3);
    param_60 = _e72;
    let _e73 = row_1;
    param_61 = _e73;
    let _e74 = (*most_1);
    param_62 = _e74;
    let _e75 = (*alpha_min_1);
    param_63 = _e75;
    blend_pixel_u0028_vf4_u003b_struct_u002d_Row_u002d_f1_u002d_f1_u002d_f1_u002d_vf31_u003b_f1_u003b_f1_u003b((&param_60), (&param_61), (&param_62), (&param_63));
    let _e76 = param_60;
    (*b_3) = _e76;
    let _e77 = param_61;
    row_1 = _e77;
    let _e78 = param_62;
    (*most_1) = _e78;
    let _e79 = (*c_1);
    param_64 = _e79;
    let _e80 = row_1;
    param_65 = _e80;
    let _e81 = (*most_1);
    param_66 = _e81;
    let _e82 = (*alpha_min_1);
    param_67 = _e82;
    blend_pixel_u0028_vf4_u003b_struct_u002d_Row_u002d_f1_u002d_f1_u002d_f1_u002d_vf31_u003b_f1_u003b_f1_u003b((&param_64), (&param_65), (&param_66), (&param_67));
    let _e83 = param_64;
    (*c_1) = _e83;
    let _e84 = param_65;
    row_1 = _e84;
    let _e85 = param_66;
    (*most_1) = _e85;
    let _e86 = (*d_1);
    param_68 = _e86;
    let _e87 = row_1;
    param_69 = _e87;
    let _e88 = (*most_1);
    param_70 = _e88;
    let _e89 = (*alpha_min_1);
    param_71 = _e89;
    blend_pixel_u0028_vf4_u003b_struct_u002d_Row_u002d_f1_u002d_f1_u002d_f1_u002d_vf31_u003b_f1_u003b_f1_u003b((&param_68), (&param_69), (&param_70), (&param_71));
    let _e90 = param_68;
    (*d_1) = _e90;
    let _e91 = param_69;
    row_1 = _e91;
    let _e92 = param_70;
    (*most_1) = _e92;
    let _e94 = (*splat).down;
    let _e96 = (*splat).deviation;
    (*splat).deviation = (_e96 + _e94);
    return;
}

fn upper_half_u0028_u1_u003b(word: ptr<function, u32>) -> f32 {
    var shifted: u32;

    let _e7 = (*word);
    shifted = (((_e7 & 2147483647u) >> bitcast<u32>(3u)) & 268427264u);
    let _e12 = shifted;
    let _e13 = (*word);
    return (bitcast<f32>((_e12 | (_e13 & 2147483648u))) * 5192297000000000000000000000000000f);
}

fn lower_half_u0028_u1_u003b(word_1: ptr<function, u32>) -> f32 {
    let _e6 = (*word_1);
    let _e9 = (*word_1);
    return (bitcast<f32>((((_e6 & 32767u) * 8192u) | ((_e9 & 32768u) * 65536u))) * 5192297000000000000000000000000000f);
}

fn masked_u0028_u1_u003b_u1_u003b(word_2: ptr<function, u32>, mask: ptr<function, u32>) -> f32 {
    let _e2 = (*word_2);
    let _e3 = (*mask);
    return f32(bitcast<i32>((_e2 & _e3)));
}

fn blend_u0028_struct_u002d_Square_u002d_vf4_u005b_16_u005d_u002d_b1_u002d_u1_u002d_vf21_u003b_struct_u002d_Uniforms_u002d_f1_u002d_f1_u002d_f1_u002d_f1_u002d_f1_u002d_f11_u003b_vu4_u003b(square_1: ptr<function, Square>, uniforms: ptr<function, Uniforms>, words: ptr<function, vec4<u32>>) {
    var coarseness: f32;
    var param_72: u32;
    var param_73: u32;
    var from_: vec2<f32>;
    var param_74: u32;
    var param_75: u32;
    var param_76: u32;
    var param_77: u32;
    var axis: vec2<f32>;
    var param_78: u32;
    var param_79: u32;
    var shorter: f32;
    var param_80: u32;
    var opacity: f32;
    var param_81: u32;
    var param_82: u32;
    var inverse: f32;
    var radius_squared: f32;
    var param_83: f32;
    var param_84: f32;
    var param_85: f32;
    var param_86: f32;
    var box: vec2<f32>;
    var touches: bool;
    var along: vec2<f32>;
    var across: vec2<f32>;
    var splat_1: Footprint;
    var low: f32;
    var param_87: u32;
    var param_88: u32;
    var high: f32;
    var param_89: u32;
    var param_90: u32;
    var param_91: u32;
    var param_92: u32;
    var param_93: u32;
    var param_94: u32;
    var most_2: f32;
    var param_95: vec4<f32>;
    var param_96: vec4<f32>;
    var param_97: vec4<f32>;
    var param_98: vec4<f32>;
    var param_99: Footprint;
    var param_100: f32;
    var param_101: f32;
    var param_102: vec4<f32>;
    var param_103: vec4<f32>;
    var param_104: vec4<f32>;
    var param_105: vec4<f32>;
    var param_106: Footprint;
    var param_107: f32;
    var param_108: f32;
    var param_109: vec4<f32>;
    var param_110: vec4<f32>;
    var param_111: vec4<f32>;
    var param_112: vec4<f32>;
    var param_113: Footprint;
    var param_114: f32;
    var param_115: f32;
    var param_116: vec4<f32>;
    var param_117: vec4<f32>;
    var param_118: vec4<f32>;
    var param_119: vec4<f32>;
    var param_120: Footprint;
    var param_121: f32;
    var param_122: f32;
    var phi_539_: bool;

    let _e112 = (*words)[1u];
    param_72 = _e112;
    param_73 = 1073741824u;
    let _e113 = masked_u0028_u1_u003b_u1_u003b((&param_72), (&param_73));
    let _e117 = (*words)[1u];
    coarseness = ((1f + (0.000000058673322f * _e113)) * select(1f, 4096f, (bitcast<i32>(_e117) < 0i)));
    let _e123 = (*square_1).middle;
    let _e124 = coarseness;
    let _e126 = (*words)[0u];
    param_74 = _e126;
    param_75 = 1048575u;
    let _e127 = masked_u0028_u1_u003b_u1_u003b((&param_74), (&param_75));
    let _e129 = (*words)[1u];
    param_76 = _e129;
    param_77 = 1048575u;
    let _e130 = masked_u0028_u1_u003b_u1_u003b((&param_76), (&param_77));
    let _e133 = (*uniforms).fixed_scale;
    let _e137 = (*uniforms).guard;
    from_ = (_e123 - (((vec2<f32>(_e127, _e130) / vec2(_e133)) - vec2(_e137)) * _e124));
    let _e143 = (*words)[2u];
    param_78 = _e143;
    let _e144 = lower_half_u0028_u1_u003b((&param_78));
    let _e146 = (*words)[2u];
    param_79 = _e146;
    let _e147 = upper_half_u0028_u1_u003b((&param_79));
    axis = vec2<f32>(_e144, _e147);
    let _e150 = (*words)[3u];
    param_80 = _e150;
    let _e151 = lower_half_u0028_u1_u003b((&param_80));
    shorter = _e151;
    let _e153 = (*words)[3u];
    param_81 = _e153;
    param_82 = 16711680u;
    let _e154 = masked_u0028_u1_u003b_u1_u003b((&param_81), (&param_82));
    opacity = (_e154 / 65536f);
    let _e156 = axis;
    let _e157 = axis;
    inverse = (1f / dot(_e156, _e157));
    let _e160 = opacity;
    param_83 = _e160;
    let _e162 = (*uniforms).quad_opacity;
    param_84 = _e162;
    let _e163 = larger_u0028_f1_u003b_f1_u003b((&param_83), (&param_84));
    let _e165 = (*uniforms).cutoff;
    param_85 = (_e163 / _e165);
    param_86 = 1f;
    let _e167 = larger_u0028_f1_u003b_f1_u003b((&param_85), (&param_86));
    radius_squared = (2f * log(_e167));
    let _e170 = radius_squared;
    let _e171 = axis;
    let _e172 = axis;
    let _e174 = shorter;
    let _e175 = shorter;
    let _e177 = inverse;
    let _e179 = axis;
    let _e182 = axis;
    box = sqrt((((_e171 * _e172) + ((_e179.yx * ((_e174 * _e175) * _e177)) * _e182.yx)) * _e170));
    let _e189 = (*square_1).open;
    phi_539_ = _e189;
    if _e189 {
        let _e190 = from_;
        let _e192 = box;
        phi_539_ = all((abs(_e190) < (_e192 + vec2(1.5f))));
    }
    let _e198 = phi_539_;
    touches = _e198;
    let _e199 = inverse;
    let _e201 = axis;
    along = (_e201 * (0.8493218f * _e199));
    let _e203 = inverse;
    let _e206 = shorter;
    let _e209 = axis[1u];
    let _e212 = axis[0u];
    across = (vec2<f32>(-(_e209), _e212) * ((0.8493218f * sqrt(_e203)) / _e206));
    let _e216 = along[0u];
    let _e218 = across[0u];
    splat_1.right = vec2<f32>(_e216, _e218);
    let _e222 = along[1u];
    let _e224 = across[1u];
    splat_1.down = vec2<f32>(_e222, _e224);
    let _e228 = splat_1.right;
    let _e230 = splat_1.right;
    splat_1.bend = exp2((-2f * dot(_e228, _e230)));
    let _e236 = (*words)[0u];
    param_87 = _e236;
    param_88 = 1073741824u;
    let _e237 = masked_u0028_u1_u003b_u1_u003b((&param_87), (&param_88));
    let _e240 = (*words)[0u];
    low = ((_e237 / 1073741800f) + select(0f, 2f, (bitcast<i32>(_e240) < 0i)));
    let _e246 = (*words)[3u];
    param_89 = _e246;
    param_90 = 2130706432u;
    let _e247 = masked_u0028_u1_u003b_u1_u003b((&param_89), (&param_90));
    let _e250 = (*words)[3u];
    high = ((_e247 / 16777216f) + select(0f, 128f, (bitcast<i32>(_e250) < 0i)));
    let _e256 = (*words)[0u];
    param_91 = _e256;
    param_92 = 1072693248u;
    let _e257 = masked_u0028_u1_u003b_u1_u003b((&param_91), (&param_92));
    let _e260 = (*words)[1u];
    param_93 = _e260;
    param_94 = 1072693248u;
    let _e261 = masked_u0028_u1_u003b_u1_u003b((&param_93), (&param_94));
    let _e263 = high;
    let _e265 = low;
    splat_1.color = vec3<f32>((_e257 * 0.000000000932233f), (_e261 * 0.000000000932233f), (((4f * _e263) + _e265) / 1023f));
    let _e270 = opacity;
    let _e272 = touches;
    splat_1.opacity = select(0f, (_e270 / 255f), _e272);
    let _e275 = from_;
    from_ = (_e275 - vec2(1.5f));
    let _e278 = from_;
    let _e279 = along;
    let _e281 = from_;
    let _e282 = across;
    splat_1.deviation = vec2<f32>(dot(_e278, _e279), dot(_e281, _e282));
    most_2 = 0f;
    let _e288 = (*square_1).pixels[0i];
    param_95 = _e288;
    let _e291 = (*square_1).pixels[1i];
    param_96 = _e291;
    let _e294 = (*square_1).pixels[2i];
    param_97 = _e294;
    let _e297 = (*square_1).pixels[3i];
    param_98 = _e297;
    let _e298 = splat_1;
    param_99 = _e298;
    let _e299 = most_2;
    param_100 = _e299;
    let _e301 = (*uniforms).alpha_min;
    param_101 = _e301;
    blend_row_u0028_vf4_u003b_vf4_u003b_vf4_u003b_vf4_u003b_struct_u002d_Footprint_u002d_vf2_u002d_vf2_u002d_vf2_u002d_f1_u002d_f1_u002d_vf31_u003b_f1_u003b_f1_u003b((&param_95), (&param_96), (&param_97), (&param_98), (&param_99), (&param_100), (&param_101));
    let _e302 = param_95;
    (*square_1).pixels[0i] = _e302;
    let _e305 = param_96;
    (*square_1).pixels[1i] = _e305;
    let _e308 = param_97;
    (*square_1).pixels[2i] = _e308;
    let _e311 = param_98;
    (*square_1).pixels[3i] = _e311;
    let _e314 = param_99;
    splat_1 = _e314;
    let _e315 = param_100;
    most_2 = _e315;
    let _e318 = (*square_1).pixels[4i];
    param_102 = _e318;
    let _e321 = (*square_1).pixels[5i];
    param_103 = _e321;
    let _e324 = (*square_1).pixels[6i];
    param_104 = _e324;
    let _e327 = (*square_1).pixels[7i];
    param_105 = _e327;
    let _e328 = splat_1;
    param_106 = _e328;
    let _e329 = most_2;
    param_107 = _e329;
    let _e331 = (*uniforms).alpha_min;
    param_108 = _e331;
    blend_row_u0028_vf4_u003b_vf4_u003b_vf4_u003b_vf4_u003b_struct_u002d_Footprint_u002d_vf2_u002d_vf2_u002d_vf2_u002d_f1_u002d_f1_u002d_vf31_u003b_f1_u003b_f1_u003b((&param_102), (&param_103), (&param_104), (&param_105), (&param_106), (&param_107), (&param_108));
    let _e332 = param_102;
    (*square_1).pixels[4i] = _e332;
    let _e335 = param_103;
    (*square_1).pixels[5i] = _e335;
    let _e338 = param_104;
    (*square_1).pixels[6i] = _e338;
    let _e341 = param_105;
    (*square_1).pixels[7i] = _e341;
    let _e344 = param_106;
    splat_1 = _e344;
    let _e345 = param_107;
    most_2 = _e345;
    let _e348 = (*square_1).pixels[8i];
    param_109 = _e348;
    let _e351 = (*square_1).pixels[9i];
    param_110 = _e351;
    let _e354 = (*square_1).pixels[10i];
    param_111 = _e354;
    let _e357 = (*square_1).pixels[11i];
    param_112 = _e357;
    let _e358 = splat_1;
    param_113 = _e358;
    let _e359 = most_2;
    param_114 = _e359;
    let _e361 = (*uniforms).alpha_min;
    param_115 = _e361;
    blend_row_u0028_vf4_u003b_vf4_u003b_vf4_u003b_vf4_u003b_struct_u002d_Footprint_u002d_vf2_u002d_vf2_u002d_vf2_u002d_f1_u002d_f1_u002d_vf31_u003b_f1_u003b_f1_u003b((&param_109), (&param_110), (&param_111), (&param_112), (&param_113), (&param_114), (&param_115));
    let _e362 = param_109;
    (*square_1).pixels[8i] = _e362;
    let _e365 = param_110;
    (*square_1).pixels[9i] = _e365;
    let _e368 = param_111;
    (*square_1).pixels[10i] = _e368;
    let _e371 = param_112;
    (*square_1).pixels[11i] = _e371;
    let _e374 = param_113;
    splat_1 = _e374;
    let _e375 = param_114;
    most_2 = _e375;
    let _e378 = (*square_1).pixels[12i];
    param_116 = _e378;
    let _e381 = (*square_1).pixels[13i];
    param_117 = _e381;
    let _e384 = (*square_1).pixels[14i];
    param_118 = _e384;
    let _e387 = (*square_1).pixels[15i];
    param_119 = _e387;
    let _e388 = splat_1;
    param_120 = _e388;
    let _e389 = most_2;
    param_121 = _e389;
    let _e391 = (*uniforms).alpha_min;
    param_122 = _e391;
    blend_row_u0028_vf4_u003b_vf4_u003b_vf4_u003b_vf4_u003b_struct_u002d_Footprint_u002d_vf2_u002d_vf2_u002d_vf2_u002d_f1_u002d_f1_u002d_vf31_u003b_f1_u003b_f1_u003b((&param_116), (&param_117), (&param_118), (&param_119), (&param_120), (&param_121), (&param_122));
    let _e392 = param_116;
    (*square_1).pixels[12i] = _e392;
    let _e395 = param_117;
    (*square_1).pixels[13i] = _e395;
    let _e398 = param_118;
    (*square_1).pixels[14i] = _e398;
    let _e401 = param_119;
    (*square_1).pixels[15i] = _e401;
    let _e404 = param_120;
    splat_1 = _e404;
    let _e405 = param_121;
    most_2 = _e405;
    let _e406 = touches;
    let _e409 = (*square_1).fragments;
    (*square_1).fragments = (_e409 + select(0u, 16u, _e406));
    let _e412 = most_2;
    let _e414 = (*uniforms).saturation;
    (*square_1).open = (_e412 >= _e414);
    return;
}

fn key_at_u0028_u1_u003b(i: ptr<function, u32>) -> u32 {
    let _e5 = (*i);
    let _e10 = unnamed.keys[(_e5 >> bitcast<u32>(1u))];
    let _e11 = (*i);
    return ((_e10 >> bitcast<u32>((16u * (_e11 & 1u)))) & 65535u);
}

fn rest_of_u0028_u1_u003b(list: ptr<function, u32>) -> u32 {
    var local_1: u32;

    let _e6 = (*list);
    if ((_e6 & 7u) > 1u) {
        let _e9 = (*list);
        local_1 = (_e9 - 1u);
    } else {
        let _e11 = (*list);
        let _e16 = unnamed_1.bins[((2306330u + _e11) - 1u)];
        local_1 = _e16;
    }
    let _e17 = local_1;
    return _e17;
}

fn take_nearer_u0028_u1_u003b_u1_u003b_u1_u003b_u1_u003b_u1_u003b_u1_u003b(list_1: ptr<function, u32>, list_first: ptr<function, u32>, list_key: ptr<function, u32>, nearest: ptr<function, u32>, splat_2: ptr<function, u32>, key: ptr<function, u32>) {
    var ahead: bool;

    let _e10 = (*list_key);
    let _e11 = (*key);
    let _e13 = (*list_first);
    let _e14 = (*splat_2);
    let _e16 = (*list_key);
    let _e17 = (*key);
    ahead = select((_e10 > _e11), (_e13 > _e14), (_e16 == _e17));
    let _e20 = ahead;
    let _e21 = (*nearest);
    let _e24 = (*list_1);
    ahead = select(false, select(_e20, true, (_e21 == 0u)), (_e24 != 0u));
    let _e27 = (*nearest);
    let _e28 = (*list_1);
    let _e29 = ahead;
    (*nearest) = select(_e27, _e28, _e29);
    let _e31 = (*splat_2);
    let _e32 = (*list_first);
    let _e33 = ahead;
    (*splat_2) = select(_e31, _e32, _e33);
    let _e35 = (*key);
    let _e36 = (*list_key);
    let _e37 = ahead;
    (*key) = select(_e35, _e36, _e37);
    return;
}

fn read_first_u0028_u1_u003b_u1_u003b_u1_u003b(list_2: ptr<function, u32>, first_1: ptr<function, u32>, key_1: ptr<function, u32>) {
    var param_123: u32;

    let _e7 = (*list_2);
    if (_e7 != 0u) {
        let _e9 = (*list_2);
        let _e13 = unnamed_1.bins[(2306330u + _e9)];
        (*first_1) = _e13;
        let _e14 = (*first_1);
        param_123 = _e14;
        let _e15 = key_at_u0028_u1_u003b((&param_123));
        (*key_1) = _e15;
    }
    return;
}

fn tile_index_u0028_u1_u003b_vu2_u003b(level: ptr<function, u32>, at_2: ptr<function, vec2<u32>>) -> u32 {
    let _e10 = (*level);
    let _e18 = (*at_2)[1u];
    let _e19 = (*level);
    let _e26 = (*at_2)[0u];
    return (((((65536u - (65536u >> bitcast<u32>((4u * _e10)))) / 15u) * 16u) + (_e18 * (256u >> bitcast<u32>((2u * _e19))))) + _e26);
}

fn blend_tiles_u0028_struct_u002d_Square_u002d_vf4_u005b_16_u005d_u002d_b1_u002d_u1_u002d_vf21_u003b_vu2_u003b(square_2: ptr<function, Square>, at_3: ptr<function, vec2<u32>>) {
    var uniforms_1: Uniforms;
    var tiles: vec4<u32>;
    var param_124: u32;
    var param_125: vec2<u32>;
    var param_126: u32;
    var param_127: vec2<u32>;
    var param_128: u32;
    var param_129: vec2<u32>;
    var param_130: u32;
    var param_131: vec2<u32>;
    var runs: u32;
    var lists: vec4<u32>;
    var first_2: vec4<u32>;
    var keys: vec4<u32>;
    var run: u32;
    var param_132: u32;
    var param_133: u32;
    var param_134: u32;
    var param_135: u32;
    var param_136: u32;
    var param_137: u32;
    var param_138: u32;
    var param_139: u32;
    var param_140: u32;
    var param_141: u32;
    var param_142: u32;
    var param_143: u32;
    var splat_3: u32;
    var key_2: u32;
    var list_3: u32;
    var param_144: u32;
    var param_145: u32;
    var param_146: u32;
    var param_147: u32;
    var param_148: u32;
    var param_149: u32;
    var param_150: u32;
    var param_151: u32;
    var param_152: u32;
    var param_153: u32;
    var param_154: u32;
    var param_155: u32;
    var param_156: u32;
    var param_157: u32;
    var param_158: u32;
    var param_159: u32;
    var param_160: u32;
    var param_161: u32;
    var param_162: u32;
    var param_163: u32;
    var param_164: u32;
    var param_165: u32;
    var param_166: u32;
    var param_167: u32;
    var taken: vec4<bool>;
    var rest: u32;
    var param_168: u32;
    var next: u32;
    var local_2: u32;
    var next_key: u32;
    var local_3: u32;
    var param_169: u32;
    var param_170: Square;
    var param_171: Uniforms;
    var param_172: vec4<u32>;
    var phi_935_: bool;

    let _e82 = frame.fixed_scale;
    let _e84 = frame.guard;
    let _e86 = frame.quad_opacity;
    let _e88 = frame.cutoff;
    let _e90 = settings.cutoff;
    let _e92 = settings.saturation;
    uniforms_1 = Uniforms(_e82, _e84, _e86, _e88, _e90, _e92);
    param_124 = 0u;
    let _e94 = (*at_3);
    param_125 = _e94;
    let _e95 = tile_index_u0028_u1_u003b_vu2_u003b((&param_124), (&param_125));
    let _e96 = (*at_3);
    param_126 = 1u;
    param_127 = (_e96 >> bitcast<vec2<u32>>(vec2(2u)));
    let _e100 = tile_index_u0028_u1_u003b_vu2_u003b((&param_126), (&param_127));
    let _e101 = (*at_3);
    param_128 = 2u;
    param_129 = (_e101 >> bitcast<vec2<u32>>(vec2(4u)));
    let _e105 = tile_index_u0028_u1_u003b_vu2_u003b((&param_128), (&param_129));
    param_130 = 3u;
    param_131 = vec2<u32>(0u, 0u);
    let _e106 = tile_index_u0028_u1_u003b_vu2_u003b((&param_130), (&param_131));
    tiles = vec4<u32>(_e95, _e100, _e105, _e106);
    let _e109 = tiles[0u];
    let _e113 = unnamed_1.bins[(1u + _e109)];
    let _e115 = tiles[1u];
    let _e119 = unnamed_1.bins[(1u + _e115)];
    let _e122 = tiles[2u];
    let _e126 = unnamed_1.bins[(1u + _e122)];
    let _e129 = tiles[3u];
    let _e133 = unnamed_1.bins[(1u + _e129)];
    runs = (((_e113 | _e119) | _e126) | _e133);
    lists = vec4<u32>(0u, 0u, 0u, 0u);
    first_2 = vec4<u32>(0u, 0u, 0u, 0u);
    keys = vec4<u32>(0u, 0u, 0u, 0u);
    loop {
        let _e136 = (*square_2).open;
        phi_935_ = _e136;
        if _e136 {
            let _e137 = runs;
            let _e139 = lists;
            phi_935_ = ((_e137 != 0u) || any((_e139 != vec4<u32>(0u, 0u, 0u, 0u))));
        }
        let _e144 = phi_935_;
        if _e144 {
            let _e145 = lists;
            if all((_e145 == vec4<u32>(0u, 0u, 0u, 0u))) {
                let _e148 = runs;
                run = bitcast<u32>(firstLeadingBit(_e148));
                let _e151 = run;
                let _e154 = runs;
                runs = (_e154 ^ (1u << bitcast<u32>(_e151)));
                let _e157 = tiles[0u];
                let _e160 = run;
                let _e164 = unnamed_1.bins[((69890u + (_e157 * 32u)) + _e160)];
                lists[0u] = _e164;
                let _e167 = tiles[1u];
                let _e170 = run;
                let _e174 = unnamed_1.bins[((69890u + (_e167 * 32u)) + _e170)];
                lists[1u] = _e174;
                let _e177 = tiles[2u];
                let _e180 = run;
                let _e184 = unnamed_1.bins[((69890u + (_e177 * 32u)) + _e180)];
                lists[2u] = _e184;
                let _e187 = tiles[3u];
                let _e190 = run;
                let _e194 = unnamed_1.bins[((69890u + (_e187 * 32u)) + _e190)];
                lists[3u] = _e194;
                let _e197 = lists[0u];
                param_132 = _e197;
                let _e199 = first_2[0u];
                param_133 = _e199;
                let _e201 = keys[0u];
                param_134 = _e201;
                read_first_u0028_u1_u003b_u1_u003b_u1_u003b((&param_132), (&param_133), (&param_134));
                let _e202 = param_133;
                first_2[0u] = _e202;
                let _e204 = param_134;
                keys[0u] = _e204;
                let _e207 = lists[1u];
                param_135 = _e207;
                let _e209 = first_2[1u];
                param_136 = _e209;
                let _e211 = keys[1u];
                param_137 = _e211;
                read_first_u0028_u1_u003b_u1_u003b_u1_u003b((&param_135), (&param_136), (&param_137));
                let _e212 = param_136;
                first_2[1u] = _e212;
                let _e214 = param_137;
                keys[1u] = _e214;
                let _e217 = lists[2u];
                param_138 = _e217;
                let _e219 = first_2[2u];
                param_139 = _e219;
                let _e221 = keys[2u];
                param_140 = _e221;
                read_first_u0028_u1_u003b_u1_u003b_u1_u003b((&param_138), (&param_139), (&param_140));
                let _e222 = param_139;
                first_2[2u] = _e222;
                let _e224 = param_140;
                keys[2u] = _e224;
                let _e227 = lists[3u];
                param_141 = _e227;
                let _e229 = first_2[3u];
                param_142 = _e229;
                let _e231 = keys[3u];
                param_143 = _e231;
                read_first_u0028_u1_u003b_u1_u003b_u1_u003b((&param_141), (&param_142), (&param_143));
                let _e232 = param_142;
                first_2[3u] = _e232;
                let _e234 = param_143;
                keys[3u] = _e234;
            }
            splat_3 = 0u;
            key_2 = 0u;
            list_3 = 0u;
            let _e237 = lists[0u];
            param_144 = _e237;
            let _e239 = first_2[0u];
            param_145 = _e239;
            let _e241 = keys[0u];
            param_146 = _e241;
            let _e242 = list_3;
            param_147 = _e242;
            let _e243 = splat_3;
            param_148 = _e243;
            let _e244 = key_2;
            param_149 = _e244;
            take_nearer_u0028_u1_u003b_u1_u003b_u1_u003b_u1_u003b_u1_u003b_u1_u003b((&param_144), (&param_145), (&param_146), (&param_147), (&param_148), (&param_149));
            let _e245 = param_147;
            list_3 = _e245;
            let _e246 = param_148;
            splat_3 = _e246;
            let _e247 = param_149;
            key_2 = _e247;
            let _e249 = lists[1u];
            param_150 = _e249;
            let _e251 = first_2[1u];
            param_151 = _e251;
            let _e253 = keys[1u];
            param_152 = _e253;
            let _e254 = list_3;
            param_153 = _e254;
            let _e255 = splat_3;
            param_154 = _e255;
            let _e256 = key_2;
            param_155 = _e256;
            take_nearer_u0028_u1_u003b_u1_u003b_u1_u003b_u1_u003b_u1_u003b_u1_u003b((&param_150), (&param_151), (&param_152), (&param_153), (&param_154), (&param_155));
            let _e257 = param_153;
            list_3 = _e257;
            let _e258 = param_154;
            splat_3 = _e258;
            let _e259 = param_155;
            key_2 = _e259;
            let _e261 = lists[2u];
            param_156 = _e261;
            let _e263 = first_2[2u];
            param_157 = _e263;
            let _e265 = keys[2u];
            param_158 = _e265;
            let _e266 = list_3;
            param_159 = _e266;
            let _e267 = splat_3;
            param_160 = _e267;
            let _e268 = key_2;
            param_161 = _e268;
            take_nearer_u0028_u1_u003b_u1_u003b_u1_u003b_u1_u003b_u1_u003b_u1_u003b((&param_156), (&param_157), (&param_158), (&param_159), (&param_160), (&param_161));
            let _e269 = param_159;
            list_3 = _e269;
            let _e270 = param_160;
            splat_3 = _e270;
            let _e271 = param_161;
            key_2 = _e271;
            let _e273 = lists[3u];
            param_162 = _e273;
            let _e275 = first_2[3u];
            param_163 = _e275;
            let _e277 = keys[3u];
            param_164 = _e277;
            let _e278 = list_3;
            param_165 = _e278;
            let _e279 = splat_3;
            param_166 = _e279;
            let _e280 = key_2;
            param_167 = _e280;
            take_nearer_u0028_u1_u003b_u1_u003b_u1_u003b_u1_u003b_u1_u003b_u1_u003b((&param_162), (&param_163), (&param_164), (&param_165), (&param_166), (&param_167));
            let _e281 = param_165;
            list_3 = _e281;
            let _e282 = param_166;
            splat_3 = _e282;
            let _e283 = param_167;
            key_2 = _e283;
            let _e284 = lists;
            let _e285 = list_3;
            taken = (_e284 == vec4(_e285));
            let _e288 = list_3;
            param_168 = _e288;
            let _e289 = rest_of_u0028_u1_u003b((&param_168));
            rest = _e289;
            let _e290 = rest;
            if (_e290 == 0u) {
                local_2 = 0u;
            } else {
                let _e292 = rest;
                let _e296 = unnamed_1.bins[(2306330u + _e292)];
                local_2 = _e296;
            }
            let _e297 = local_2;
            next = _e297;
            let _e298 = rest;
            if (_e298 == 0u) {
                local_3 = 0u;
            } else {
                let _e300 = next;
                param_169 = _e300;
                let _e301 = key_at_u0028_u1_u003b((&param_169));
                local_3 = _e301;
            }
            let _e302 = local_3;
            next_key = _e302;
            let _e303 = lists;
            let _e304 = rest;
            let _e306 = taken;
            lists = select(_e303, vec4(_e304), _e306);
            let _e308 = first_2;
            let _e309 = next;
            let _e311 = taken;
            first_2 = select(_e308, vec4(_e309), _e311);
            let _e313 = keys;
            let _e314 = next_key;
            let _e316 = taken;
            keys = select(_e313, vec4(_e314), _e316);
            let _e318 = splat_3;
            let _e319 = (*square_2);
            param_170 = _e319;
            let _e320 = uniforms_1;
            param_171 = _e320;
            let _e323 = unnamed_2.splats[_e318];
            param_172 = _e323;
            blend_u0028_struct_u002d_Square_u002d_vf4_u005b_16_u005d_u002d_b1_u002d_u1_u002d_vf21_u003b_struct_u002d_Uniforms_u002d_f1_u002d_f1_u002d_f1_u002d_f1_u002d_f1_u002d_f11_u003b_vu4_u003b((&param_170), (&param_171), (&param_172));
            let _e324 = param_170;
            (*square_2) = _e324;
            continue;
        } else {
            break;
        }
    }
    return;
}

fn is_drawn_u0028_vu2_u003b(corner_1: ptr<function, vec2<u32>>) -> bool {
    var at_4: vec2<f32>;
    var phi_1239_: bool;
    var phi_1240_: bool;

    let _e4 = (*corner_1);
    at_4 = vec2<f32>(_e4);
    let _e7 = frame.area_reach;
    let _e8 = (_e7 < 0f);
    phi_1240_ = _e8;
    if !(_e8) {
        let _e10 = at_4;
        let _e12 = frame.area;
        let _e15 = all((_e10 >= _e12.xy));
        phi_1239_ = _e15;
        if _e15 {
            let _e16 = at_4;
            let _e18 = frame.area;
            phi_1239_ = all((_e16 < _e18.zw));
        }
        let _e23 = phi_1239_;
        phi_1240_ = _e23;
    }
    let _e25 = phi_1240_;
    return _e25;
}

fn place_of_u0028_u1_u003b(index_1: ptr<function, u32>) -> vec2<u32> {
    var bits: vec2<u32>;

    let _e7 = (*index_1);
    let _e8 = (*index_1);
    bits = vec2<u32>(_e7, (_e8 >> bitcast<u32>(1u)));
    let _e12 = bits;
    let _e15 = bits;
    let _e22 = bits;
    let _e29 = bits;
    return ((((_e12 & vec2(1u)) | ((_e15 >> bitcast<vec2<u32>>(vec2(1u))) & vec2(2u))) | ((_e22 >> bitcast<vec2<u32>>(vec2(2u))) & vec2(4u))) | ((_e29 >> bitcast<vec2<u32>>(vec2(3u))) & vec2(8u)));
}

fn index_in_workgroup_u0028_() -> u32 {
    let _e1 = gl_LocalInvocationIndex_1;
    return _e1;
}

@compute @workgroup_size(64, 1, 1) 
fn main(@builtin(local_invocation_index) gl_LocalInvocationIndex: u32, @builtin(workgroup_id) gl_WorkGroupID: vec3<u32>) {
    var index: u32;
    var corner: vec2<u32>;
    var first: vec2<u32>;
    var param: u32;
    var drawn: bool;
    var param_1: vec2<u32>;
    var square: Square;
    var param_2: Square;
    var param_3: vec2<u32>;
    var size: vec2<u32>;
    var param_4: vec2<u32>;
    var param_5: vec2<u32>;
    var param_6: vec4<f32>;
    var param_7: vec4<f32>;
    var param_8: vec4<f32>;
    var param_9: vec4<f32>;
    var param_10: bool;
    var param_11: vec2<u32>;
    var param_12: vec2<u32>;
    var param_13: vec4<f32>;
    var param_14: vec4<f32>;
    var param_15: vec4<f32>;
    var param_16: vec4<f32>;
    var param_17: bool;
    var param_18: vec2<u32>;
    var param_19: vec2<u32>;
    var param_20: vec4<f32>;
    var param_21: vec4<f32>;
    var param_22: vec4<f32>;
    var param_23: vec4<f32>;
    var param_24: bool;
    var param_25: vec2<u32>;
    var param_26: vec2<u32>;
    var param_27: vec4<f32>;
    var param_28: vec4<f32>;
    var param_29: vec4<f32>;
    var param_30: vec4<f32>;
    var param_31: bool;
    var phi_1489_: bool;

    gl_LocalInvocationIndex_1 = gl_LocalInvocationIndex;
    gl_WorkGroupID_1 = gl_WorkGroupID;
    let _e66 = index_in_workgroup_u0028_();
    index = _e66;
    let _e68 = settings.first_region;
    corner = ((_e68 + bitcast<vec3<u32>>(gl_WorkGroupID).xy) * vec2(32u));
    let _e74 = corner;
    let _e75 = index;
    param = _e75;
    let _e76 = place_of_u0028_u1_u003b((&param));
    first = (_e74 + (vec2(4u) * _e76));
    let _e80 = corner;
    param_1 = _e80;
    let _e81 = is_drawn_u0028_vu2_u003b((&param_1));
    drawn = _e81;
    let _e82 = drawn;
    square.open = _e82;
    square.fragments = 0u;
    let _e85 = first;
    square.middle = (vec2<f32>(_e85) + vec2(2f));
    square.pixels = array<vec4<f32>, 16>(vec4<f32>(0f, 0f, 0f, 1f), vec4<f32>(0f, 0f, 0f, 1f), vec4<f32>(0f, 0f, 0f, 1f), vec4<f32>(0f, 0f, 0f, 1f), vec4<f32>(0f, 0f, 0f, 1f), vec4<f32>(0f, 0f, 0f, 1f), vec4<f32>(0f, 0f, 0f, 1f), vec4<f32>(0f, 0f, 0f, 1f), vec4<f32>(0f, 0f, 0f, 1f), vec4<f32>(0f, 0f, 0f, 1f), vec4<f32>(0f, 0f, 0f, 1f), vec4<f32>(0f, 0f, 0f, 1f), vec4<f32>(0f, 0f, 0f, 1f), vec4<f32>(0f, 0f, 0f, 1f), vec4<f32>(0f, 0f, 0f, 1f), vec4<f32>(0f, 0f, 0f, 1f));
    let _e92 = square.middle;
    let _e94 = frame.tile_side;
    let _e98 = square;
    param_2 = _e98;
    param_3 = vec2<u32>((_e92 / vec2(_e94)));
    blend_tiles_u0028_struct_u002d_Square_u002d_vf4_u005b_16_u005d_u002d_b1_u002d_u1_u002d_vf21_u003b_vu2_u003b((&param_2), (&param_3));
    let _e99 = param_2;
    square = _e99;
    let _e101 = square.open;
    let _e102 = drawn;
    square.open = (_e101 || !(_e102));
    let _e107 = frame.size;
    size = vec2<u32>(_e107);
    let _e109 = first;
    param_4 = _e109;
    let _e110 = size;
    param_5 = _e110;
    let _e113 = square.pixels[0i];
    param_6 = _e113;
    let _e116 = square.pixels[1i];
    param_7 = _e116;
    let _e119 = square.pixels[2i];
    param_8 = _e119;
    let _e122 = square.pixels[3i];
    param_9 = _e122;
    let _e124 = square.open;
    param_10 = _e124;
    store_row_u0028_vu2_u003b_vu2_u003b_vf4_u003b_vf4_u003b_vf4_u003b_vf4_u003b_b1_u003b((&param_4), (&param_5), (&param_6), (&param_7), (&param_8), (&param_9), (&param_10));
    let _e125 = first;
    param_11 = (_e125 + vec2<u32>(0u, 1u));
    let _e127 = size;
    param_12 = _e127;
    let _e130 = square.pixels[4i];
    param_13 = _e130;
    let _e133 = square.pixels[5i];
    param_14 = _e133;
    let _e136 = square.pixels[6i];
    param_15 = _e136;
    let _e139 = square.pixels[7i];
    param_16 = _e139;
    let _e141 = square.open;
    param_17 = _e141;
    store_row_u0028_vu2_u003b_vu2_u003b_vf4_u003b_vf4_u003b_vf4_u003b_vf4_u003b_b1_u003b((&param_11), (&param_12), (&param_13), (&param_14), (&param_15), (&param_16), (&param_17));
    let _e142 = first;
    param_18 = (_e142 + vec2<u32>(0u, 2u));
    let _e144 = size;
    param_19 = _e144;
    let _e147 = square.pixels[8i];
    param_20 = _e147;
    let _e150 = square.pixels[9i];
    param_21 = _e150;
    let _e153 = square.pixels[10i];
    param_22 = _e153;
    let _e156 = square.pixels[11i];
    param_23 = _e156;
    let _e158 = square.open;
    param_24 = _e158;
    store_row_u0028_vu2_u003b_vu2_u003b_vf4_u003b_vf4_u003b_vf4_u003b_vf4_u003b_b1_u003b((&param_18), (&param_19), (&param_20), (&param_21), (&param_22), (&param_23), (&param_24));
    let _e159 = first;
    param_25 = (_e159 + vec2<u32>(0u, 3u));
    let _e161 = size;
    param_26 = _e161;
    let _e164 = square.pixels[12i];
    param_27 = _e164;
    let _e167 = square.pixels[13i];
    param_28 = _e167;
    let _e170 = square.pixels[14i];
    param_29 = _e170;
    let _e173 = square.pixels[15i];
    param_30 = _e173;
    let _e175 = square.open;
    param_31 = _e175;
    store_row_u0028_vu2_u003b_vu2_u003b_vf4_u003b_vf4_u003b_vf4_u003b_vf4_u003b_b1_u003b((&param_25), (&param_26), (&param_27), (&param_28), (&param_29), (&param_30), (&param_31));
    let _e177 = settings.counted;
    let _e178 = (_e177 != 0u);
    phi_1489_ = _e178;
    if _e178 {
        let _e180 = square.fragments;
        phi_1489_ = (_e180 > 0u);
    }
    let _e183 = phi_1489_;
    if _e183 {
        let _e187 = square.fragments;
        let _e188 = atomicAdd((&unnamed_3.control.fragments), _e187);
    }
    return;
}
