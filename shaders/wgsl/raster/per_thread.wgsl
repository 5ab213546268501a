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
    key_count: u32,
    visible_count: u32,
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
var image: texture_storage_2d<rgba8unorm,write>;
var<private> gl_WorkGroupID_1: vec3<u32>;
@group(0) @binding(2) 
var<storage, read_write> unnamed_3: ControlBuffer_1;

fn store_pixel_u0028_vu2_u003b_vu2_u003b_vf4_u003b(at: ptr<function, vec2<u32>>, size: ptr<function, vec2<u32>>, pixel: ptr<function, vec4<f32>>) {
    let _e91 = (*at);
    let _e92 = (*size);
    if all((_e91 < _e92)) {
        let _e95 = (*at);
        let _e97 = (*pixel);
        let _e98 = _e97.xyz;
        let _e100 = (*pixel)[3u];
        textureStore(image, bitcast<vec2<i32>>(_e95), vec4<f32>(_e98.x, _e98.y, _e98.z, (1f - _e100)));
    }
    return;
}

fn store_row_u0028_vu2_u003b_vu2_u003b_vf4_u003b_vf4_u003b_vf4_u003b_vf4_u003b(at_1: ptr<function, vec2<u32>>, size_1: ptr<function, vec2<u32>>, a: ptr<function, vec4<f32>>, b: ptr<function, vec4<f32>>, c: ptr<function, vec4<f32>>, d: ptr<function, vec4<f32>>) {
    var param: vec2<u32>;
    var param_1: vec2<u32>;
    var param_2: vec4<f32>;
    var param_3: vec2<u32>;
    var param_4: vec2<u32>;
    var param_5: vec4<f32>;
    var param_6: vec2<u32>;
    var param_7: vec2<u32>;
    var param_8: vec4<f32>;
    var param_9: vec2<u32>;
    var param_10: vec2<u32>;
    var param_11: vec4<f32>;

    let _e106 = (*at_1);
    param = _e106;
    let _e107 = (*size_1);
    param_1 = _e107;
    let _e108 = (*a);
    param_2 = _e108;
    store_pixel_u0028_vu2_u003b_vu2_u003b_vf4_u003b((&param), (&param_1), (&param_2));
    let _e109 = (*at_1);
    param_3 = (_e109 + vec2<u32>(1u, 0u));
    let _e111 = (*size_1);
    param_4 = _e111;
    let _e112 = (*b);
    param_5 = _e112;
    store_pixel_u0028_vu2_u003b_vu2_u003b_vf4_u003b((&param_3), (&param_4), (&param_5));
    let _e113 = (*at_1);
    param_6 = (_e113 + vec2<u32>(2u, 0u));
    let _e115 = (*size_1);
    param_7 = _e115;
    let _e116 = (*c);
    param_8 = _e116;
    store_pixel_u0028_vu2_u003b_vu2_u003b_vf4_u003b((&param_6), (&param_7), (&param_8));
    let _e117 = (*at_1);
    param_9 = (_e117 + vec2<u32>(3u, 0u));
    let _e119 = (*size_1);
    param_10 = _e119;
    let _e120 = (*d);
    param_11 = _e120;
    store_pixel_u0028_vu2_u003b_vu2_u003b_vf4_u003b((&param_9), (&param_10), (&param_11));
    return;
}

fn larger_u0028_f1_u003b_f1_u003b(a_1: ptr<function, f32>, b_1: ptr<function, f32>) -> f32 {
    let _e90 = (*a_1);
    let _e91 = (*b_1);
    let _e92 = (*b_1);
    let _e93 = (*a_1);
    return select(_e90, _e91, (_e92 > _e93));
}

fn smaller_u0028_f1_u003b_f1_u003b(a_2: ptr<function, f32>, b_2: ptr<function, f32>) -> f32 {
    let _e90 = (*a_2);
    let _e91 = (*b_2);
    let _e92 = (*b_2);
    let _e93 = (*a_2);
    return select(_e90, _e91, (_e92 < _e93));
}

fn blend_pixel_u0028_vf4_u003b_struct_u002d_Row_u002d_f1_u002d_f1_u002d_f1_u002d_vf31_u003b_f1_u003b_f1_u003b(pixel_1: ptr<function, vec4<f32>>, row: ptr<function, Row>, most: ptr<function, f32>, alpha_min: ptr<function, f32>) {
    var covers: f32;
    var param_12: f32;
    var param_13: f32;
    var share: f32;
    var param_14: f32;
    var param_15: f32;

    let _e99 = (*row).alpha;
    param_12 = _e99;
    param_13 = 0.99f;
    let _e100 = smaller_u0028_f1_u003b_f1_u003b((&param_12), (&param_13));
    covers = _e100;
    let _e101 = covers;
    let _e103 = (*pixel_1)[3u];
    let _e105 = covers;
    let _e106 = (*alpha_min);
    share = select(0f, (_e101 * _e103), (_e105 >= _e106));
    let _e109 = (*pixel_1);
    let _e111 = share;
    let _e113 = (*row).color;
    let _e115 = (_e109.xyz + (_e113 * _e111));
    let _e117 = (*pixel_1)[3u];
    let _e118 = share;
    (*pixel_1) = vec4<f32>(_e115.x, _e115.y, _e115.z, (_e117 - _e118));
    let _e124 = (*most);
    param_14 = _e124;
    let _e126 = (*pixel_1)[3u];
    param_15 = _e126;
    let _e127 = larger_u0028_f1_u003b_f1_u003b((&param_14), (&param_15));
    (*most) = _e127;
    let _e129 = (*row).factor;
    let _e131 = (*row).alpha;
    (*row).alpha = (_e131 * _e129);
    let _e135 = (*row).bend;
    let _e137 = (*row).factor;
    (*row).factor = (_e137 * _e135);
    return;
}

fn blend_row_u0028_vf4_u003b_vf4_u003b_vf4_u003b_vf4_u003b_struct_u002d_Footprint_u002d_vf2_u002d_vf2_u002d_vf2_u002d_f1_u002d_f1_u002d_vf31_u003b_f1_u003b_f1_u003b(a_3: ptr<function, vec4<f32>>, b_3: ptr<function, vec4<f32>>, c_1: ptr<function, vec4<f32>>, d_1: ptr<function, vec4<f32>>, splat: ptr<function, Footprint>, most_1: ptr<function, f32>, alpha_min_1: ptr<function, f32>) {
    var weight: f32;
    var row_1: Row;
    var param_16: f32;
    var param_17: f32;
    var param_18: vec4<f32>;
    var param_19: Row;
    var param_20: f32;
    var param_21: f32;
    var param_22: vec4<f32>;
    var param_23: Row;
    var param_24: f32;
    var param_25: f32;
    var param_26: vec4<f32>;
    var param_27: Row;
    var param_28: f32;
    var param_29: f32;
    var param_30: vec4<f32>;
    var param_31: Row;
    var param_32: f32;
    var param_33: f32;

    let _e116 = (*splat).deviation;
    let _e118 = (*splat).deviation;
    weight = exp2(-(dot(_e116, _e118)));
    let _e123 = (*splat).opacity;
    let _e124 = weight;
    let _e126 = weight;
    row_1.alpha = select(0f, (_e123 * _e124), (_e126 >= 0.00000000000000001f));
    let _e131 = (*splat).deviation;
    let _e134 = (*splat).right;
    let _e137 = (*splat).right;
    param_16 = -(dot(((_e131 * 2f) + _e134), _e137));
    param_17 = 60f;
    let _e140 = smaller_u0028_f1_u003b_f1_u003b((&param_16), (&param_17));
    row_1.factor = exp2(_e140);
    let _e144 = (*splat).bend;
    row_1.bend = _e144;
    let _e147 = (*splat).color;
    row_1.color = _e147;
    let _e149 = (*a_3);
    param_18 = _e149;
    let _e150 = row_1;
    param_19 = _e150;
    let _e151 = (*most_1);
    param_20 = _e151;
    let _e152 = (*alpha_min_1);
    param_21 = _e152;
    blend_pixel_u0028_vf4_u003b_struct_u002d_Row_u002d_f1_u002d_f1_u002d_f1_u002d_vf31_u003b_f1_u003b_f1_u003b((&param_18), (&param_19), (&param_20), (&param_21));
    let _e153 = param_18;
    (*a_3) = _e153;
    let _e154 = param_19;
    row_1 = _e154;
    let _e155 = param_20;
    (*most_1) = _e155;
    let _e156 = (*b_3);
    param_22 = _e156;
    let _e157 = row_1;
    param_23 = _e157;
    let _e158 = (*most_1);
    param_24 = _e158;
    let _e159 = (*alpha_min_1);
    param_25 = _e159;
    blend_pixel_u0028_vf4_u003b_struct_u002d_Row_u002d_f1_u002d_f1_u002d_f1_u002d_vf31_u003b_f1_u003b_f1_u003b((&param_22), (&param_23), (&param_24), (&param_25));
    let _e160 = param_22;
    (*b_3) = _e160;
    let _e161 = param_23;
    row_1 = _e161;
    let _e162 = param_24;
    (*most_1) = _e162;
    let _e163 = (*c_1);
    param_26 = _e163;
    let _e164 = row_1;
    param_27 = _e164;
    let _e165 = (*most_1);
    param_28 = _e165;
    let _e166 = (*alpha_min_1);
    param_29 = _e166;
    blend_pixel_u0028_vf4_u003b_struct_u002d_Row_u002d_f1_u002d_f1_u002d_f1_u002d_vf31_u003b_f1_u003b_f1_u003b((&param_26), (&param_27), (&param_28), (&param_29));
    let _e167 = param_26;
    (*c_1) = _e167;
    let _e168 = param_27;
    row_1 = _e168;
    let _e169 = param_28;
    (*most_1) = _e169;
    let _e170 = (*d_1);
    param_30 = _e170;
    let _e171 = row_1;
    param_31 = _e171;
    let _e172 = (*most_1);
    param_32 = _e172;
    let _e173 = (*alpha_min_1);
    param_33 = _e173;
    blend_pixel_u0028_vf4_u003b_struct_u002d_Row_u002d_f1_u002d_f1_u002d_f1_u002d_vf31_u003b_f1_u003b_f1_u003b((&param_30), (&param_31), (&param_32), (&param_33));
    let _e174 = param_30;
    (*d_1) = _e174;
    let _e175 = param_31;
    row_1 = _e175;
    let _e176 = param_32;
    (*most_1) = _e176;
    let _e178 = (*splat).down;
    let _e180 = (*splat).deviation;
    (*splat).deviation = (_e180 + _e178);
    return;
}

fn upper_half_u0028_u1_u003b(word: ptr<function, u32>) -> f32 {
    var shifted: u32;

    let _e90 = (*word);
    shifted = (((_e90 & 2147483647u) >> bitcast<u32>(3u)) & 268427264u);
    let _e95 = shifted;
    let _e96 = (*word);
    return (bitcast<f32>((_e95 | (_e96 & 2147483648u))) * 5192297000000000000000000000000000f);
}

fn lower_half_u0028_u1_u003b(word_1: ptr<function, u32>) -> f32 {
    let _e89 = (*word_1);
    let _e92 = (*word_1);
    return (bitcast<f32>((((_e89 & 32767u) * 8192u) | ((_e92 & 32768u) * 65536u))) * 5192297000000000000000000000000000f);
}

fn masked_u0028_u1_u003b_u1_u003b(word_2: ptr<function, u32>, mask: ptr<function, u32>) -> f32 {
    let _e90 = (*word_2);
    let _e91 = (*mask);
    return f32(bitcast<i32>((_e90 & _e91)));
}

fn blend_u0028_struct_u002d_Square_u002d_vf4_u005b_16_u005d_u002d_b1_u002d_u1_u002d_vf21_u003b_struct_u002d_Uniforms_u002d_f1_u002d_f1_u002d_f1_u002d_f1_u002d_f1_u002d_f11_u003b_vu4_u003b(square: ptr<function, Square>, uniforms: ptr<function, Uniforms>, words: ptr<function, vec4<u32>>) {
    var from_: vec2<f32>;
    var param_34: u32;
    var param_35: u32;
    var param_36: u32;
    var param_37: u32;
    var axis: vec2<f32>;
    var param_38: u32;
    var param_39: u32;
    var shorter: f32;
    var param_40: u32;
    var opacity: f32;
    var param_41: u32;
    var param_42: u32;
    var inverse: f32;
    var radius_squared: f32;
    var param_43: f32;
    var param_44: f32;
    var param_45: f32;
    var param_46: f32;
    var box: vec2<f32>;
    var touches: bool;
    var along: vec2<f32>;
    var across: vec2<f32>;
    var splat_1: Footprint;
    var low: f32;
    var param_47: u32;
    var param_48: u32;
    var high: f32;
    var param_49: u32;
    var param_50: u32;
    var param_51: u32;
    var param_52: u32;
    var param_53: u32;
    var param_54: u32;
    var most_2: f32;
    var param_55: vec4<f32>;
    var param_56: vec4<f32>;
    var param_57: vec4<f32>;
    var param_58: vec4<f32>;
    var param_59: Footprint;
    var param_60: f32;
    var param_61: f32;
    var param_62: vec4<f32>;
    var param_63: vec4<f32>;
    var param_64: vec4<f32>;
    var param_65: vec4<f32>;
    var param_66: Footprint;
    var param_67: f32;
    var param_68: f32;
    var param_69: vec4<f32>;
    var param_70: vec4<f32>;
    var param_71: vec4<f32>;
    var param_72: vec4<f32>;
    var param_73: Footprint;
    var param_74: f32;
    var param_75: f32;
    var param_76: vec4<f32>;
    var param_77: vec4<f32>;
    var param_78: vec4<f32>;
    var param_79: vec4<f32>;
    var param_80: Footprint;
    var param_81: f32;
    var param_82: f32;
    var phi_509_: bool;

    let _e155 = (*square).middle;
    let _e157 = (*words)[0u];
    param_34 = _e157;
    param_35 = 1048575u;
    let _e158 = masked_u0028_u1_u003b_u1_u003b((&param_34), (&param_35));
    let _e160 = (*words)[1u];
    param_36 = _e160;
    param_37 = 1048575u;
    let _e161 = masked_u0028_u1_u003b_u1_u003b((&param_36), (&param_37));
    let _e164 = (*uniforms).fixed_scale;
    let _e168 = (*uniforms).guard;
    from_ = (_e155 - ((vec2<f32>(_e158, _e161) / vec2(_e164)) - vec2(_e168)));
    let _e173 = (*words)[2u];
    param_38 = _e173;
    let _e174 = lower_half_u0028_u1_u003b((&param_38));
    let _e176 = (*words)[2u];
    param_39 = _e176;
    let _e177 = upper_half_u0028_u1_u003b((&param_39));
    axis = vec2<f32>(_e174, _e177);
    let _e180 = (*words)[3u];
    param_40 = _e180;
    let _e181 = lower_half_u0028_u1_u003b((&param_40));
    shorter = _e181;
    let _e183 = (*words)[3u];
    param_41 = _e183;
    param_42 = 16711680u;
    let _e184 = masked_u0028_u1_u003b_u1_u003b((&param_41), (&param_42));
    opacity = (_e184 / 65536f);
    let _e186 = axis;
    let _e187 = axis;
    inverse = (1f / dot(_e186, _e187));
    let _e190 = opacity;
    param_43 = _e190;
    let _e192 = (*uniforms).quad_opacity;
    param_44 = _e192;
    let _e193 = larger_u0028_f1_u003b_f1_u003b((&param_43), (&param_44));
    let _e195 = (*uniforms).cutoff;
    param_45 = (_e193 / _e195);
    param_46 = 1f;
    let _e197 = larger_u0028_f1_u003b_f1_u003b((&param_45), (&param_46));
    radius_squared = (2f * log(_e197));
    let _e200 = radius_squared;
    let _e201 = axis;
    let _e202 = axis;
    let _e204 = shorter;
    let _e205 = shorter;
    let _e207 = inverse;
    let _e209 = axis;
    let _e212 = axis;
    box = sqrt((((_e201 * _e202) + ((_e209.yx * ((_e204 * _e205) * _e207)) * _e212.yx)) * _e200));
    let _e219 = (*square).open;
    phi_509_ = _e219;
    if _e219 {
        let _e220 = from_;
        let _e222 = box;
        phi_509_ = all((abs(_e220) < (_e222 + vec2(1.5f))));
    }
    let _e228 = phi_509_;
    touches = _e228;
    let _e229 = inverse;
    let _e231 = axis;
    along = (_e231 * (0.8493218f * _e229));
    let _e233 = inverse;
    let _e236 = shorter;
    let _e239 = axis[1u];
    let _e242 = axis[0u];
    across = (vec2<f32>(-(_e239), _e242) * ((0.8493218f * sqrt(_e233)) / _e236));
    let _e246 = along[0u];
    let _e248 = across[0u];
    splat_1.right = vec2<f32>(_e246, _e248);
    let _e252 = along[1u];
    let _e254 = across[1u];
    splat_1.down = vec2<f32>(_e252, _e254);
    let _e258 = splat_1.right;
    let _e260 = splat_1.right;
    splat_1.bend = exp2((-2f * dot(_e258, _e260)));
    let _e266 = (*words)[0u];
    param_47 = _e266;
    param_48 = 1073741824u;
    let _e267 = masked_u0028_u1_u003b_u1_u003b((&param_47), (&param_48));
    let _e270 = (*words)[0u];
    low = ((_e267 / 1073741800f) + select(0f, 2f, (bitcast<i32>(_e270) < 0i)));
    let _e276 = (*words)[3u];
    param_49 = _e276;
    param_50 = 2130706432u;
    let _e277 = masked_u0028_u1_u003b_u1_u003b((&param_49), (&param_50));
    let _e280 = (*words)[3u];
    high = ((_e277 / 16777216f) + select(0f, 128f, (bitcast<i32>(_e280) < 0i)));
    let _e286 = (*words)[0u];
    param_51 = _e286;
    param_52 = 1072693248u;
    let _e287 = masked_u0028_u1_u003b_u1_u003b((&param_51), (&param_52));
    let _e290 = (*words)[1u];
    param_53 = _e290;
    param_54 = 1072693248u;
    let _e291 = masked_u0028_u1_u003b_u1_u003b((&param_53), (&param_54));
    let _e293 = high;
    let _e295 = low;
    splat_1.color = vec3<f32>((_e287 * 0.000000000932233f), (_e291 * 0.000000000932233f), (((4f * _e293) + _e295) / 1023f));
    let _e300 = opacity;
    let _e302 = touches;
    splat_1.opacity = select(0f, (_e300 / 255f), _e302);
    let _e305 = from_;
    from_ = (_e305 - vec2(1.5f));
    let _e308 = from_;
    let _e309 = along;
    let _e311 = from_;
    let _e312 = across;
    splat_1.deviation = vec2<f32>(dot(_e308, _e309), dot(_e311, _e312));
    most_2 = 0f;
    let _e318 = (*square).pixels[0i];
    param_55 = _e318;
    let _e321 = (*square).pixels[1i];
    param_56 = _e321;
    let _e324 = (*square).pixels[2i];
    param_57 = _e324;
    let _e327 = (*square).pixels[3i];
    param_58 = _e327;
    let _e328 = splat_1;
    param_59 = _e328;
    let _e329 = most_2;
    param_60 = _e329;
    let _e331 = (*uniforms).alpha_min;
    param_61 = _e331;
    blend_row_u0028_vf4_u003b_vf4_u003b_vf4_u003b_vf4_u003b_struct_u002d_Footprint_u002d_vf2_u002d_vf2_u002d_vf2_u002d_f1_u002d_f1_u002d_vf31_u003b_f1_u003b_f1_u003b((&param_55), (&param_56), (&param_57), (&param_58), (&param_59), (&param_60), (&param_61));
    let _e332 = param_55;
    (*square).pixels[0i] = _e332;
    let _e335 = param_56;
    (*square).pixels[1i] = _e335;
    let _e338 = param_57;
    (*square).pixels[2i] = _e338;
    let _e341 = param_58;
    (*square).pixels[3i] = _e341;
    let _e344 = param_59;
    splat_1 = _e344;
    let _e345 = param_60;
    most_2 = _e345;
    let _e348 = (*square).pixels[4i];
    param_62 = _e348;
    let _e351 = (*square).pixels[5i];
    param_63 = _e351;
    let _e354 = (*square).pixels[6i];
    param_64 = _e354;
    let _e357 = (*square).pixels[7i];
    param_65 = _e357;
    let _e358 = splat_1;
    param_66 = _e358;
    let _e359 = most_2;
    param_67 = _e359;
    let _e361 = (*uniforms).alpha_min;
    param_68 = _e361;
    blend_row_u0028_vf4_u003b_vf4_u003b_vf4_u003b_vf4_u003b_struct_u002d_Footprint_u002d_vf2_u002d_vf2_u002d_vf2_u002d_f1_u002d_f1_u002d_vf31_u003b_f1_u003b_f1_u003b((&param_62), (&param_63), (&param_64), (&param_65), (&param_66), (&param_67), (&param_68));
    let _e362 = param_62;
    (*square).pixels[4i] = _e362;
    let _e365 = param_63;
    (*square).pixels[5i] = _e365;
    let _e368 = param_64;
    (*square).pixels[6i] = _e368;
    let _e371 = param_65;
    (*square).pixels[7i] = _e371;
    let _e374 = param_66;
    splat_1 = _e374;
    let _e375 = param_67;
    most_2 = _e375;
    let _e378 = (*square).pixels[8i];
    param_69 = _e378;
    let _e381 = (*square).pixels[9i];
    param_70 = _e381;
    let _e384 = (*square).pixels[10i];
    param_71 = _e384;
    let _e387 = (*square).pixels[11i];
    param_72 = _e387;
    let _e388 = splat_1;
    param_73 = _e388;
    let _e389 = most_2;
    param_74 = _e389;
    let _e391 = (*uniforms).alpha_min;
    param_75 = _e391;
    blend_row_u0028_vf4_u003b_vf4_u003b_vf4_u003b_vf4_u003b_struct_u002d_Footprint_u002d_vf2_u002d_vf2_u002d_vf2_u002d_f1_u002d_f1_u002d_vf31_u003b_f1_u003b_f1_u003b((&param_69), (&param_70), (&param_71), (&param_72), (&param_73), (&param_74), (&param_75));
    let _e392 = param_69;
    (*square).pixels[8i] = _e392;
    let _e395 = param_70;
    (*square).pixels[9i] = _e395;
    let _e398 = param_71;
    (*square).pixels[10i] = _e398;
    let _e401 = param_72;
    (*square).pixels[11i] = _e401;
    let _e404 = param_73;
    splat_1 = _e404;
    let _e405 = param_74;
    most_2 = _e405;
    let _e408 = (*square).pixels[12i];
    param_76 = _e408;
    let _e411 = (*square).pixels[13i];
    param_77 = _e411;
    let _e414 = (*square).pixels[14i];
    param_78 = _e414;
    let _e417 = (*square).pixels[15i];
    param_79 = _e417;
    let _e418 = splat_1;
    param_80 = _e418;
    let _e419 = most_2;
    param_81 = _e419;
    let _e421 = (*uniforms).alpha_min;
    param_82 = _e421;
    blend_row_u0028_vf4_u003b_vf4_u003b_vf4_u003b_vf4_u003b_struct_u002d_Footprint_u002d_vf2_u002d_vf2_u002d_vf2_u002d_f1_u002d_f1_u002d_vf31_u003b_f1_u003b_f1_u003b((&param_76), (&param_77), (&param_78), (&param_79), (&param_80), (&param_81), (&param_82));
    let _e422 = param_76;
    (*square).pixels[12i] = _e422;
    let _e425 = param_77;
    (*square).pixels[13i] = _e425;
    let _e428 = param_78;
    (*square).pixels[14i] = _e428;
    let _e431 = param_79;
    (*square).pixels[15i] = _e431;
    let _e434 = param_80;
    splat_1 = _e434;
    let _e435 = param_81;
    most_2 = _e435;
    let _e436 = touches;
    let _e439 = (*square).fragments;
    (*square).fragments = (_e439 + select(0u, 16u, _e436));
    let _e442 = most_2;
    let _e444 = (*uniforms).saturation;
    (*square).open = (_e442 >= _e444);
    return;
}

fn key_at_u0028_u1_u003b(i: ptr<function, u32>) -> u32 {
    let _e89 = (*i);
    let _e94 = unnamed.keys[(_e89 >> bitcast<u32>(1u))];
    let _e95 = (*i);
    return ((_e94 >> bitcast<u32>((16u * (_e95 & 1u)))) & 65535u);
}

fn rest_of_u0028_u1_u003b(list: ptr<function, u32>) -> u32 {
    var local: u32;

    let _e90 = (*list);
    if ((_e90 & 7u) > 1u) {
        let _e93 = (*list);
        local = (_e93 - 1u);
    } else {
        let _e95 = (*list);
        let _e100 = unnamed_1.bins[((2306330u + _e95) - 1u)];
        local = _e100;
    }
    let _e101 = local;
    return _e101;
}

fn take_nearer_u0028_u1_u003b_u1_u003b_u1_u003b_u1_u003b_u1_u003b_u1_u003b(list_1: ptr<function, u32>, list_first: ptr<function, u32>, list_key: ptr<function, u32>, nearest: ptr<function, u32>, splat_2: ptr<function, u32>, key: ptr<function, u32>) {
    var ahead: bool;

    let _e95 = (*list_key);
    let _e96 = (*key);
    let _e98 = (*list_first);
    let _e99 = (*splat_2);
    let _e101 = (*list_key);
    let _e102 = (*key);
    ahead = select((_e95 > _e96), (_e98 > _e99), (_e101 == _e102));
    let _e105 = ahead;
    let _e106 = (*nearest);
    let _e109 = (*list_1);
    ahead = select(false, select(_e105, true, (_e106 == 0u)), (_e109 != 0u));
    let _e112 = (*nearest);
    let _e113 = (*list_1);
    let _e114 = ahead;
    (*nearest) = select(_e112, _e113, _e114);
    let _e116 = (*splat_2);
    let _e117 = (*list_first);
    let _e118 = ahead;
    (*splat_2) = select(_e116, _e117, _e118);
    let _e120 = (*key);
    let _e121 = (*list_key);
    let _e122 = ahead;
    (*key) = select(_e120, _e121, _e122);
    return;
}

fn read_first_u0028_u1_u003b_u1_u003b_u1_u003b(list_2: ptr<function, u32>, first: ptr<function, u32>, key_1: ptr<function, u32>) {
    var param_83: u32;

    let _e92 = (*list_2);
    if (_e92 != 0u) {
        let _e94 = (*list_2);
        let _e98 = unnamed_1.bins[(2306330u + _e94)];
        (*first) = _e98;
        let _e99 = (*first);
        param_83 = _e99;
        let _e100 = key_at_u0028_u1_u003b((&param_83));
        (*key_1) = _e100;
    }
    return;
}

fn tile_index_u0028_u1_u003b_vu2_u003b(level: ptr<function, u32>, at_2: ptr<function, vec2<u32>>) -> u32 {
    let _e90 = (*level);
    let _e98 = (*at_2)[1u];
    let _e99 = (*level);
    let _e106 = (*at_2)[0u];
    return (((((65536u - (65536u >> bitcast<u32>((4u * _e90)))) / 15u) * 16u) + (_e98 * (256u >> bitcast<u32>((2u * _e99))))) + _e106);
}

fn blend_tiles_u0028_struct_u002d_Square_u002d_vf4_u005b_16_u005d_u002d_b1_u002d_u1_u002d_vf21_u003b_vu2_u003b(square_1: ptr<function, Square>, at_3: ptr<function, vec2<u32>>) {
    var uniforms_1: Uniforms;
    var tiles: vec4<u32>;
    var param_84: u32;
    var param_85: vec2<u32>;
    var param_86: u32;
    var param_87: vec2<u32>;
    var param_88: u32;
    var param_89: vec2<u32>;
    var param_90: u32;
    var param_91: vec2<u32>;
    var runs: u32;
    var lists: vec4<u32>;
    var first_1: vec4<u32>;
    var keys: vec4<u32>;
    var run: u32;
    var param_92: u32;
    var param_93: u32;
    var param_94: u32;
    var param_95: u32;
    var param_96: u32;
    var param_97: u32;
    var param_98: u32;
    var param_99: u32;
    var param_100: u32;
    var param_101: u32;
    var param_102: u32;
    var param_103: u32;
    var splat_3: u32;
    var key_2: u32;
    var list_3: u32;
    var param_104: u32;
    var param_105: u32;
    var param_106: u32;
    var param_107: u32;
    var param_108: u32;
    var param_109: u32;
    var param_110: u32;
    var param_111: u32;
    var param_112: u32;
    var param_113: u32;
    var param_114: u32;
    var param_115: u32;
    var param_116: u32;
    var param_117: u32;
    var param_118: u32;
    var param_119: u32;
    var param_120: u32;
    var param_121: u32;
    var param_122: u32;
    var param_123: u32;
    var param_124: u32;
    var param_125: u32;
    var param_126: u32;
    var param_127: u32;
    var taken: vec4<bool>;
    var rest: u32;
    var param_128: u32;
    var next: u32;
    var local_1: u32;
    var next_key: u32;
    var local_2: u32;
    var param_129: u32;
    var param_130: Square;
    var param_131: Uniforms;
    var param_132: vec4<u32>;
    var phi_906_: bool;

    let _e156 = frame.fixed_scale;
    let _e158 = frame.guard;
    let _e160 = frame.quad_opacity;
    let _e162 = frame.cutoff;
    let _e164 = settings.cutoff;
    let _e166 = settings.saturation;
    uniforms_1 = Uniforms(_e156, _e158, _e160, _e162, _e164, _e166);
    param_84 = 0u;
    let _e168 = (*at_3);
    param_85 = _e168;
    let _e169 = tile_index_u0028_u1_u003b_vu2_u003b((&param_84), (&param_85));
    let _e170 = (*at_3);
    param_86 = 1u;
    param_87 = (_e170 >> bitcast<vec2<u32>>(vec2(2u)));
    let _e174 = tile_index_u0028_u1_u003b_vu2_u003b((&param_86), (&param_87));
    let _e175 = (*at_3);
    param_88 = 2u;
    param_89 = (_e175 >> bitcast<vec2<u32>>(vec2(4u)));
    let _e179 = tile_index_u0028_u1_u003b_vu2_u003b((&param_88), (&param_89));
    param_90 = 3u;
    param_91 = vec2<u32>(0u, 0u);
    let _e180 = tile_index_u0028_u1_u003b_vu2_u003b((&param_90), (&param_91));
    tiles = vec4<u32>(_e169, _e174, _e179, _e180);
    let _e183 = tiles[0u];
    let _e187 = unnamed_1.bins[(1u + _e183)];
    let _e189 = tiles[1u];
    let _e193 = unnamed_1.bins[(1u + _e189)];
    let _e196 = tiles[2u];
    let _e200 = unnamed_1.bins[(1u + _e196)];
    let _e203 = tiles[3u];
    let _e207 = unnamed_1.bins[(1u + _e203)];
    runs = (((_e187 | _e193) | _e200) | _e207);
    lists = vec4<u32>(0u, 0u, 0u, 0u);
    first_1 = vec4<u32>(0u, 0u, 0u, 0u);
    keys = vec4<u32>(0u, 0u, 0u, 0u);
    loop {
        let _e210 = (*square_1).open;
        phi_906_ = _e210;
        if _e210 {
            let _e211 = runs;
            let _e213 = lists;
            phi_906_ = ((_e211 != 0u) || any((_e213 != vec4<u32>(0u, 0u, 0u, 0u))));
        }
        let _e218 = phi_906_;
        if _e218 {
            let _e219 = lists;
            if all((_e219 == vec4<u32>(0u, 0u, 0u, 0u))) {
                let _e222 = runs;
                run = bitcast<u32>(firstLeadingBit(_e222));
                let _e225 = run;
                let _e228 = runs;
                runs = (_e228 ^ (1u << bitcast<u32>(_e225)));
                let _e231 = tiles[0u];
                let _e234 = run;
                let _e238 = unnamed_1.bins[((69890u + (_e231 * 32u)) + _e234)];
                lists[0u] = _e238;
                let _e241 = tiles[1u];
                let _e244 = run;
                let _e248 = unnamed_1.bins[((69890u + (_e241 * 32u)) + _e244)];
                lists[1u] = _e248;
                let _e251 = tiles[2u];
                let _e254 = run;
                let _e258 = unnamed_1.bins[((69890u + (_e251 * 32u)) + _e254)];
                lists[2u] = _e258;
                let _e261 = tiles[3u];
                let _e264 = run;
                let _e268 = unnamed_1.bins[((69890u + (_e261 * 32u)) + _e264)];
                lists[3u] = _e268;
                let _e271 = lists[0u];
                param_92 = _e271;
                let _e273 = first_1[0u];
                param_93 = _e273;
                let _e275 = keys[0u];
                param_94 = _e275;
                read_first_u0028_u1_u003b_u1_u003b_u1_u003b((&param_92), (&param_93), (&param_94));
                let _e276 = param_93;
                first_1[0u] = _e276;
                let _e278 = param_94;
                keys[0u] = _e278;
                let _e281 = lists[1u];
                param_95 = _e281;
                let _e283 = first_1[1u];
                param_96 = _e283;
                let _e285 = keys[1u];
                param_97 = _e285;
                read_first_u0028_u1_u003b_u1_u003b_u1_u003b((&param_95), (&param_96), (&param_97));
                let _e286 = param_96;
                first_1[1u] = _e286;
                let _e288 = param_97;
                keys[1u] = _e288;
                let _e291 = lists[2u];
                param_98 = _e291;
                let _e293 = first_1[2u];
                param_99 = _e293;
                let _e295 = keys[2u];
                param_100 = _e295;
                read_first_u0028_u1_u003b_u1_u003b_u1_u003b((&param_98), (&param_99), (&param_100));
                let _e296 = param_99;
                first_1[2u] = _e296;
                let _e298 = param_100;
                keys[2u] = _e298;
                let _e301 = lists[3u];
                param_101 = _e301;
                let _e303 = first_1[3u];
                param_102 = _e303;
                let _e305 = keys[3u];
                param_103 = _e305;
                read_first_u0028_u1_u003b_u1_u003b_u1_u003b((&param_101), (&param_102), (&param_103));
                let _e306 = param_102;
                first_1[3u] = _e306;
                let _e308 = param_103;
                keys[3u] = _e308;
            }
            splat_3 = 0u;
            key_2 = 0u;
            list_3 = 0u;
            let _e311 = lists[0u];
            param_104 = _e311;
            let _e313 = first_1[0u];
            param_105 = _e313;
            let _e315 = keys[0u];
            param_106 = _e315;
            let _e316 = list_3;
            param_107 = _e316;
            let _e317 = splat_3;
            param_108 = _e317;
            let _e318 = key_2;
            param_109 = _e318;
            take_nearer_u0028_u1_u003b_u1_u003b_u1_u003b_u1_u003b_u1_u003b_u1_u003b((&param_104), (&param_105), (&param_106), (&param_107), (&param_108), (&param_109));
            let _e319 = param_107;
            list_3 = _e319;
            let _e320 = param_108;
            splat_3 = _e320;
            let _e321 = param_109;
            key_2 = _e321;
            let _e323 = lists[1u];
            param_110 = _e323;
            let _e325 = first_1[1u];
            param_111 = _e325;
            let _e327 = keys[1u];
            param_112 = _e327;
            let _e328 = list_3;
            param_113 = _e328;
            let _e329 = splat_3;
            param_114 = _e329;
            let _e330 = key_2;
            param_115 = _e330;
            take_nearer_u0028_u1_u003b_u1_u003b_u1_u003b_u1_u003b_u1_u003b_u1_u003b((&param_110), (&param_111), (&param_112), (&param_113), (&param_114), (&param_115));
            let _e331 = param_113;
            list_3 = _e331;
            let _e332 = param_114;
            splat_3 = _e332;
            let _e333 = param_115;
            key_2 = _e333;
            let _e335 = lists[2u];
            param_116 = _e335;
            let _e337 = first_1[2u];
            param_117 = _e337;
            let _e339 = keys[2u];
            param_118 = _e339;
            let _e340 = list_3;
            param_119 = _e340;
            let _e341 = splat_3;
            param_120 = _e341;
            let _e342 = key_2;
            param_121 = _e342;
            take_nearer_u0028_u1_u003b_u1_u003b_u1_u003b_u1_u003b_u1_u003b_u1_u003b((&param_116), (&param_117), (&param_118), (&param_119), (&param_120), (&param_121));
            let _e343 = param_119;
            list_3 = _e343;
            let _e344 = param_120;
            splat_3 = _e344;
            let _e345 = param_121;
            key_2 = _e345;
            let _e347 = lists[3u];
            param_122 = _e347;
            let _e349 = first_1[3u];
            param_123 = _e349;
            let _e351 = keys[3u];
            param_124 = _e351;
            let _e352 = list_3;
            param_125 = _e352;
            let _e353 = splat_3;
            param_126 = _e353;
            let _e354 = key_2;
            param_127 = _e354;
            take_nearer_u0028_u1_u003b_u1_u003b_u1_u003b_u1_u003b_u1_u003b_u1_u003b((&param_122), (&param_123), (&param_124), (&param_125), (&param_126), (&param_127));
            let _e355 = param_125;
            list_3 = _e355;
            let _e356 = param_126;
            splat_3 = _e356;
            let _e357 = param_127;
            key_2 = _e357;
            let _e358 = lists;
            let _e359 = list_3;
            taken = (_e358 == vec4(_e359));
            let _e362 = list_3;
            param_128 = _e362;
            let _e363 = rest_of_u0028_u1_u003b((&param_128));
            rest = _e363;
            let _e364 = rest;
            if (_e364 == 0u) {
                local_1 = 0u;
            } else {
                let _e366 = rest;
                let _e370 = unnamed_1.bins[(2306330u + _e366)];
                local_1 = _e370;
            }
            let _e371 = local_1;
            next = _e371;
            let _e372 = rest;
            if (_e372 == 0u) {
                local_2 = 0u;
            } else {
                let _e374 = next;
                param_129 = _e374;
                let _e375 = key_at_u0028_u1_u003b((&param_129));
                local_2 = _e375;
            }
            let _e376 = local_2;
            next_key = _e376;
            let _e377 = lists;
            let _e378 = rest;
            let _e380 = taken;
            lists = select(_e377, vec4(_e378), _e380);
            let _e382 = first_1;
            let _e383 = next;
            let _e385 = taken;
            first_1 = select(_e382, vec4(_e383), _e385);
            let _e387 = keys;
            let _e388 = next_key;
            let _e390 = taken;
            keys = select(_e387, vec4(_e388), _e390);
            let _e392 = splat_3;
            let _e393 = (*square_1);
            param_130 = _e393;
            let _e394 = uniforms_1;
            param_131 = _e394;
            let _e397 = unnamed_2.splats[_e392];
            param_132 = _e397;
            blend_u0028_struct_u002d_Square_u002d_vf4_u005b_16_u005d_u002d_b1_u002d_u1_u002d_vf21_u003b_struct_u002d_Uniforms_u002d_f1_u002d_f1_u002d_f1_u002d_f1_u002d_f1_u002d_f11_u003b_vu4_u003b((&param_130), (&param_131), (&param_132));
            let _e398 = param_130;
            (*square_1) = _e398;
            continue;
        } else {
            break;
        }
    }
    return;
}

fn place_of_u0028_u1_u003b(index: ptr<function, u32>) -> vec2<u32> {
    let _e89 = (*index);
    let _e91 = (*index);
    let _e96 = (*index);
    let _e101 = (*index);
    let _e105 = (*index);
    let _e110 = (*index);
    return vec2<u32>((((_e89 & 1u) | ((_e91 >> bitcast<u32>(1u)) & 2u)) | ((_e96 >> bitcast<u32>(2u)) & 4u)), ((((_e101 >> bitcast<u32>(1u)) & 1u) | ((_e105 >> bitcast<u32>(2u)) & 2u)) | ((_e110 >> bitcast<u32>(3u)) & 4u)));
}

fn index_in_workgroup_u0028_() -> u32 {
    let _e88 = gl_LocalInvocationIndex_1;
    return _e88;
}

fn main_1() {
    var index_1: u32;
    var first_2: vec2<u32>;
    var param_133: u32;
    var square_2: Square;
    var param_134: Square;
    var param_135: vec2<u32>;
    var size_2: vec2<u32>;
    var param_136: vec2<u32>;
    var param_137: vec2<u32>;
    var param_138: vec4<f32>;
    var param_139: vec4<f32>;
    var param_140: vec4<f32>;
    var param_141: vec4<f32>;
    var param_142: vec2<u32>;
    var param_143: vec2<u32>;
    var param_144: vec4<f32>;
    var param_145: vec4<f32>;
    var param_146: vec4<f32>;
    var param_147: vec4<f32>;
    var param_148: vec2<u32>;
    var param_149: vec2<u32>;
    var param_150: vec4<f32>;
    var param_151: vec4<f32>;
    var param_152: vec4<f32>;
    var param_153: vec4<f32>;
    var param_154: vec2<u32>;
    var param_155: vec2<u32>;
    var param_156: vec4<f32>;
    var param_157: vec4<f32>;
    var param_158: vec4<f32>;
    var param_159: vec4<f32>;
    var phi_1369_: bool;

    let _e119 = index_in_workgroup_u0028_();
    index_1 = _e119;
    let _e121 = settings.first_region;
    let _e122 = gl_WorkGroupID_1;
    let _e127 = index_1;
    param_133 = _e127;
    let _e128 = place_of_u0028_u1_u003b((&param_133));
    first_2 = (((_e121 + _e122.xy) * vec2(32u)) + (vec2(4u) * _e128));
    square_2.open = true;
    square_2.fragments = 0u;
    let _e134 = first_2;
    square_2.middle = (vec2<f32>(_e134) + vec2(2f));
    square_2.pixels = array<vec4<f32>, 16>(vec4<f32>(0f, 0f, 0f, 1f), vec4<f32>(0f, 0f, 0f, 1f), vec4<f32>(0f, 0f, 0f, 1f), vec4<f32>(0f, 0f, 0f, 1f), vec4<f32>(0f, 0f, 0f, 1f), vec4<f32>(0f, 0f, 0f, 1f), vec4<f32>(0f, 0f, 0f, 1f), vec4<f32>(0f, 0f, 0f, 1f), vec4<f32>(0f, 0f, 0f, 1f), vec4<f32>(0f, 0f, 0f, 1f), vec4<f32>(0f, 0f, 0f, 1f), vec4<f32>(0f, 0f, 0f, 1f), vec4<f32>(0f, 0f, 0f, 1f), vec4<f32>(0f, 0f, 0f, 1f), vec4<f32>(0f, 0f, 0f, 1f), vec4<f32>(0f, 0f, 0f, 1f));
    let _e141 = square_2.middle;
    let _e143 = frame.tile_side;
    let _e147 = square_2;
    param_134 = _e147;
    param_135 = vec2<u32>((_e141 / vec2(_e143)));
    blend_tiles_u0028_struct_u002d_Square_u002d_vf4_u005b_16_u005d_u002d_b1_u002d_u1_u002d_vf21_u003b_vu2_u003b((&param_134), (&param_135));
    let _e148 = param_134;
    square_2 = _e148;
    let _e150 = frame.size;
    size_2 = vec2<u32>(_e150);
    let _e152 = first_2;
    param_136 = _e152;
    let _e153 = size_2;
    param_137 = _e153;
    let _e156 = square_2.pixels[0i];
    param_138 = _e156;
    let _e159 = square_2.pixels[1i];
    param_139 = _e159;
    let _e162 = square_2.pixels[2i];
    param_140 = _e162;
    let _e165 = square_2.pixels[3i];
    param_141 = _e165;
    store_row_u0028_vu2_u003b_vu2_u003b_vf4_u003b_vf4_u003b_vf4_u003b_vf4_u003b((&param_136), (&param_137), (&param_138), (&param_139), (&param_140), (&param_141));
    let _e166 = first_2;
    param_142 = (_e166 + vec2<u32>(0u, 1u));
    let _e168 = size_2;
    param_143 = _e168;
    let _e171 = square_2.pixels[4i];
    param_144 = _e171;
    let _e174 = square_2.pixels[5i];
    param_145 = _e174;
    let _e177 = square_2.pixels[6i];
    param_146 = _e177;
    let _e180 = square_2.pixels[7i];
    param_147 = _e180;
    store_row_u0028_vu2_u003b_vu2_u003b_vf4_u003b_vf4_u003b_vf4_u003b_vf4_u003b((&param_142), (&param_143), (&param_144), (&param_145), (&param_146), (&param_147));
    let _e181 = first_2;
    param_148 = (_e181 + vec2<u32>(0u, 2u));
    let _e183 = size_2;
    param_149 = _e183;
    let _e186 = square_2.pixels[8i];
    param_150 = _e186;
    let _e189 = square_2.pixels[9i];
    param_151 = _e189;
    let _e192 = square_2.pixels[10i];
    param_152 = _e192;
    let _e195 = square_2.pixels[11i];
    param_153 = _e195;
    store_row_u0028_vu2_u003b_vu2_u003b_vf4_u003b_vf4_u003b_vf4_u003b_vf4_u003b((&param_148), (&param_149), (&param_150), (&param_151), (&param_152), (&param_153));
    let _e196 = first_2;
    param_154 = (_e196 + vec2<u32>(0u, 3u));
    let _e198 = size_2;
    param_155 = _e198;
    let _e201 = square_2.pixels[12i];
    param_156 = _e201;
    let _e204 = square_2.pixels[13i];
    param_157 = _e204;
    let _e207 = square_2.pixels[14i];
    param_158 = _e207;
    let _e210 = square_2.pixels[15i];
    param_159 = _e210;
    store_row_u0028_vu2_u003b_vu2_u003b_vf4_u003b_vf4_u003b_vf4_u003b_vf4_u003b((&param_154), (&param_155), (&param_156), (&param_157), (&param_158), (&param_159));
    let _e212 = settings.counted;
    let _e213 = (_e212 != 0u);
    phi_1369_ = _e213;
    if _e213 {
        let _e215 = square_2.fragments;
        phi_1369_ = (_e215 > 0u);
    }
    let _e218 = phi_1369_;
    if _e218 {
        let _e222 = square_2.fragments;
        let _e223 = atomicAdd((&unnamed_3.control.fragments), _e222);
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn main(@builtin(local_invocation_index) gl_LocalInvocationIndex: u32, @builtin(workgroup_id) gl_WorkGroupID: vec3<u32>) {
    gl_LocalInvocationIndex_1 = gl_LocalInvocationIndex;
    gl_WorkGroupID_1 = gl_WorkGroupID;
    main_1();
}
