struct Splat {
    center: vec2<f32>,
    axis: vec2<f32>,
    shorter: f32,
    color: vec3<f32>,
    opacity: u32,
}

struct Ready {
    center: vec2<f32>,
    reach: vec2<f32>,
    along: vec2<f32>,
    across: vec2<f32>,
    color: vec4<f32>,
    bend: f32,
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
}

struct Splats {
    splats: array<vec4<u32>>,
}

struct Bins {
    bins: array<u32>,
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

var<private> shaded: u32;
var<private> open: bool;
@group(0) @binding(0) 
var<uniform> frame: FrameBlock;
var<private> middle: vec2<f32>;
@group(0) @binding(7) 
var<uniform> settings: SettingsBlock;
var<private> pixels: array<vec4<f32>, 16>;
@group(0) @binding(1) 
var<storage> unnamed: Splats;
@group(0) @binding(3) 
var<storage> unnamed_1: Bins;
var<private> gl_LocalInvocationIndex_1: u32;
var<private> gl_WorkGroupID_1: vec3<u32>;
@group(0) @binding(4) 
var picture: texture_storage_2d<rgba16float,write>;
@group(0) @binding(2) 
var<storage, read_write> unnamed_2: ControlBuffer_1;

fn blend_u0028_struct_u002d_Ready_u002d_vf2_u002d_vf2_u002d_vf2_u002d_vf2_u002d_vf4_u002d_f11_u003b(splat: ptr<function, Ready>) {
    var from_: vec2<f32>;
    var deviation: vec2<f32>;
    var right: vec2<f32>;
    var most: f32;
    var y: u32;
    var weight: f32;
    var alpha: f32;
    var local: f32;
    var factor: f32;
    var x: u32;
    var k: u32;
    var covers: f32;
    var share: f32;
    var local_1: f32;
    var phi_319_: bool;

    let _e78 = middle;
    let _e80 = (*splat).center;
    from_ = (_e78 - _e80);
    let _e82 = open;
    phi_319_ = _e82;
    if _e82 {
        let _e83 = from_;
        let _e86 = (*splat).reach;
        phi_319_ = all((abs(_e83) < (_e86 + vec2(1.5f))));
    }
    let _e92 = phi_319_;
    if !(_e92) {
        return;
    }
    let _e94 = from_;
    from_ = (_e94 - vec2(1.5f));
    let _e97 = from_;
    let _e99 = (*splat).along;
    let _e101 = from_;
    let _e103 = (*splat).across;
    deviation = vec2<f32>(dot(_e97, _e99), dot(_e101, _e103));
    let _e108 = (*splat).along[0u];
    let _e111 = (*splat).across[0u];
    right = vec2<f32>(_e108, _e111);
    most = 0f;
    y = 0u;
    loop {
        let _e113 = y;
        if (_e113 < 4u) {
            let _e115 = deviation;
            let _e116 = deviation;
            weight = exp2(-(dot(_e115, _e116)));
            let _e120 = weight;
            if (_e120 >= 0.00000000000000001f) {
                let _e124 = (*splat).color[3u];
                let _e125 = weight;
                local = (_e124 * _e125);
            } else {
                local = 0f;
            }
            let _e127 = local;
            alpha = _e127;
            let _e128 = deviation;
            let _e130 = right;
            let _e132 = right;
            factor = exp2(min(-(dot(((_e128 * 2f) + _e130), _e132)), 60f));
            x = 0u;
            loop {
                let _e137 = x;
                if (_e137 < 4u) {
                    let _e139 = y;
                    let _e141 = x;
                    k = ((_e139 * 4u) + _e141);
                    let _e143 = alpha;
                    covers = min(_e143, 0.99f);
                    let _e145 = covers;
                    let _e147 = settings.cutoff;
                    if (_e145 >= _e147) {
                        let _e149 = covers;
                        let _e150 = k;
                        let _e153 = pixels[_e150][3u];
                        local_1 = (_e149 * _e153);
                    } else {
                        local_1 = 0f;
                    }
                    let _e155 = local_1;
                    share = _e155;
                    let _e156 = k;
                    let _e157 = k;
                    let _e159 = pixels[_e157];
                    let _e161 = share;
                    let _e163 = (*splat).color;
                    let _e166 = (_e159.xyz + (_e163.xyz * _e161));
                    let _e167 = k;
                    let _e170 = pixels[_e167][3u];
                    let _e171 = share;
                    pixels[_e156] = vec4<f32>(_e166.x, _e166.y, _e166.z, (_e170 - _e171));
                    let _e178 = most;
                    let _e179 = k;
                    let _e182 = pixels[_e179][3u];
                    most = max(_e178, _e182);
                    let _e184 = factor;
                    let _e185 = alpha;
                    alpha = (_e185 * _e184);
                    let _e188 = (*splat).bend;
                    let _e189 = factor;
                    factor = (_e189 * _e188);
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e191 = x;
                    x = (_e191 + bitcast<u32>(1i));
                }
            }
            let _e196 = (*splat).along[1u];
            let _e199 = (*splat).across[1u];
            let _e201 = deviation;
            deviation = (_e201 + vec2<f32>(_e196, _e199));
            continue;
        } else {
            break;
        }
        continuing {
            let _e203 = y;
            y = (_e203 + bitcast<u32>(1i));
        }
    }
    let _e206 = shaded;
    shaded = (_e206 + 16u);
    let _e208 = most;
    let _e210 = settings.full;
    open = (_e208 >= _e210);
    return;
}

fn half_box_u0028_struct_u002d_Splat_u002d_vf2_u002d_vf2_u002d_f1_u002d_vf3_u002d_u11_u003b_f1_u003b(splat_1: ptr<function, Splat>, reach: ptr<function, f32>) -> vec2<f32> {
    var steep: f32;

    let _e67 = (*splat_1).shorter;
    let _e69 = (*splat_1).axis;
    let _e71 = (*splat_1).axis;
    steep = (_e67 * inverseSqrt(dot(_e69, _e71)));
    let _e75 = (*reach);
    let _e77 = (*splat_1).axis;
    let _e79 = (*splat_1).axis;
    let _e81 = steep;
    let _e82 = steep;
    let _e85 = (*splat_1).axis;
    let _e89 = (*splat_1).axis;
    return (sqrt(((_e77 * _e79) + ((_e85.yx * (_e81 * _e82)) * _e89.yx))) * _e75);
}

fn reach_of_u0028_u1_u003b(opacity: ptr<function, u32>) -> f32 {
    let _e64 = (*opacity);
    let _e67 = frame.hull_opacity;
    let _e70 = frame.cutoff;
    return sqrt((2f * log(max((max(f32(_e64), _e67) / _e70), 1f))));
}

fn steps_of_u0028_vu4_u003b(words: ptr<function, vec4<u32>>) -> vec2<f32> {
    let _e64 = (*words);
    return vec2<f32>((_e64.xy & vec2(1048575u)));
}

fn unpack_splat_u0028_vu4_u003b(words_1: ptr<function, vec4<u32>>) -> Splat {
    var splat_2: Splat;
    var param: vec4<u32>;
    var blue: u32;

    let _e67 = (*words_1);
    param = _e67;
    let _e68 = steps_of_u0028_vu4_u003b((&param));
    let _e70 = frame.fixed_scale;
    let _e74 = frame.guard;
    splat_2.center = ((_e68 / vec2(_e70)) - vec2(_e74));
    let _e79 = (*words_1)[2u];
    splat_2.axis = unpack2x16float(_e79);
    let _e83 = (*words_1)[3u];
    splat_2.shorter = unpack2x16float(_e83).x;
    let _e88 = (*words_1)[3u];
    let _e94 = (*words_1)[0u];
    blue = (((_e88 >> bitcast<u32>(24u)) << bitcast<u32>(2u)) | (_e94 >> bitcast<u32>(30u)));
    let _e99 = (*words_1)[0u];
    let _e105 = (*words_1)[1u];
    let _e110 = blue;
    splat_2.color = (vec3<f32>(f32(((_e99 >> bitcast<u32>(20u)) & 1023u)), f32(((_e105 >> bitcast<u32>(20u)) & 1023u)), f32(_e110)) / vec3(1023f));
    let _e117 = (*words_1)[3u];
    splat_2.opacity = ((_e117 >> bitcast<u32>(16u)) & 255u);
    let _e122 = splat_2;
    return _e122;
}

fn ready_u0028_vu4_u003b(words_2: ptr<function, vec4<u32>>) -> Ready {
    var splat_3: Splat;
    var param_1: vec4<u32>;
    var inverse: f32;
    var r: Ready;
    var param_2: u32;
    var param_3: Splat;
    var param_4: f32;

    let _e71 = (*words_2);
    param_1 = _e71;
    let _e72 = unpack_splat_u0028_vu4_u003b((&param_1));
    splat_3 = _e72;
    let _e74 = splat_3.axis;
    let _e76 = splat_3.axis;
    inverse = (1f / dot(_e74, _e76));
    let _e80 = splat_3.center;
    r.center = _e80;
    let _e83 = splat_3.opacity;
    param_2 = _e83;
    let _e84 = reach_of_u0028_u1_u003b((&param_2));
    let _e85 = splat_3;
    param_3 = _e85;
    param_4 = _e84;
    let _e86 = half_box_u0028_struct_u002d_Splat_u002d_vf2_u002d_vf2_u002d_f1_u002d_vf3_u002d_u11_u003b_f1_u003b((&param_3), (&param_4));
    r.reach = _e86;
    let _e88 = inverse;
    let _e91 = splat_3.axis;
    r.along = (_e91 * (0.8493218f * _e88));
    let _e94 = inverse;
    let _e98 = splat_3.shorter;
    let _e102 = splat_3.axis[1u];
    let _e106 = splat_3.axis[0u];
    r.across = (vec2<f32>(-(_e102), _e106) * ((0.8493218f * sqrt(_e94)) / _e98));
    let _e111 = splat_3.color;
    let _e113 = splat_3.opacity;
    r.color = vec4<f32>(_e111.x, _e111.y, _e111.z, (f32(_e113) / 255f));
    let _e123 = r.along[0u];
    let _e126 = r.along[0u];
    let _e130 = r.across[0u];
    let _e133 = r.across[0u];
    r.bend = exp2((-2f * ((_e123 * _e126) + (_e130 * _e133))));
    let _e139 = r;
    return _e139;
}

fn step_back_u0028_u1_u003b(chain: ptr<function, u32>) -> u32 {
    var local_2: u32;

    let _e65 = (*chain);
    if ((_e65 & 7u) > 1u) {
        let _e68 = (*chain);
        local_2 = (_e68 - 1u);
    } else {
        let _e70 = (*chain);
        let _e75 = unnamed_1.bins[((540698u + _e70) - 1u)];
        local_2 = _e75;
    }
    let _e76 = local_2;
    return _e76;
}

fn key_at_u0028_u1_u003b(i: ptr<function, u32>) -> u32 {
    var word: u32;
    var local_3: u32;
    var keys: u32;
    var local_4: u32;

    let _e69 = frame.key_start;
    let _e71 = frame.half_keys;
    if (_e71 != 0u) {
        let _e73 = (*i);
        local_3 = (_e73 / 2u);
    } else {
        let _e75 = (*i);
        local_3 = _e75;
    }
    let _e76 = local_3;
    word = (_e69 + _e76);
    let _e78 = word;
    let _e80 = word;
    let _e85 = unnamed.splats[(_e78 / 4u)][(_e80 & 3u)];
    keys = _e85;
    let _e87 = frame.half_keys;
    if (_e87 != 0u) {
        let _e89 = keys;
        let _e90 = (*i);
        local_4 = ((_e89 >> bitcast<u32>((16u * (_e90 & 1u)))) & 65535u);
    } else {
        let _e96 = keys;
        local_4 = _e96;
    }
    let _e97 = local_4;
    return _e97;
}

fn nearer_u0028_u1_u003b_u1_u003b(a: ptr<function, u32>, b: ptr<function, u32>) -> bool {
    var key: u32;
    var param_5: u32;
    var than: u32;
    var param_6: u32;
    var phi_543_: bool;

    let _e69 = (*a);
    param_5 = _e69;
    let _e70 = key_at_u0028_u1_u003b((&param_5));
    key = _e70;
    let _e71 = (*b);
    param_6 = _e71;
    let _e72 = key_at_u0028_u1_u003b((&param_6));
    than = _e72;
    let _e73 = key;
    let _e74 = than;
    let _e75 = (_e73 > _e74);
    phi_543_ = _e75;
    if !(_e75) {
        let _e77 = key;
        let _e78 = than;
        let _e80 = (*a);
        let _e81 = (*b);
        phi_543_ = ((_e77 == _e78) && (_e80 > _e81));
    }
    let _e85 = phi_543_;
    return _e85;
}

fn blend_both_u0028_u1_u003b_u1_u003b(here: ptr<function, u32>, everywhere: ptr<function, u32>) {
    var near: u32;
    var local_5: u32;
    var other: u32;
    var local_6: u32;
    var wide: bool;
    var param_7: u32;
    var param_8: u32;
    var param_9: u32;
    var param_10: u32;
    var param_11: vec4<u32>;
    var param_12: Ready;
    var phi_581_: bool;
    var phi_622_: bool;
    var phi_623_: bool;

    loop {
        let _e76 = open;
        phi_581_ = _e76;
        if _e76 {
            let _e77 = (*here);
            let _e78 = (*everywhere);
            phi_581_ = ((_e77 | _e78) != 0u);
        }
        let _e82 = phi_581_;
        if _e82 {
            let _e83 = (*here);
            if (_e83 == 0u) {
                local_5 = 0u;
            } else {
                let _e85 = (*here);
                let _e89 = unnamed_1.bins[(540698u + _e85)];
                local_5 = _e89;
            }
            let _e90 = local_5;
            near = _e90;
            let _e91 = (*everywhere);
            if (_e91 == 0u) {
                local_6 = 0u;
            } else {
                let _e93 = (*everywhere);
                let _e97 = unnamed_1.bins[(540698u + _e93)];
                local_6 = _e97;
            }
            let _e98 = local_6;
            other = _e98;
            let _e99 = (*here);
            let _e100 = (_e99 == 0u);
            phi_623_ = _e100;
            if !(_e100) {
                let _e102 = (*everywhere);
                let _e103 = (_e102 != 0u);
                phi_622_ = _e103;
                if _e103 {
                    let _e104 = other;
                    param_7 = _e104;
                    let _e105 = near;
                    param_8 = _e105;
                    let _e106 = nearer_u0028_u1_u003b_u1_u003b((&param_7), (&param_8));
                    phi_622_ = _e106;
                }
                let _e108 = phi_622_;
                phi_623_ = _e108;
            }
            let _e110 = phi_623_;
            wide = _e110;
            let _e111 = wide;
            if _e111 {
                let _e112 = (*everywhere);
                param_9 = _e112;
                let _e113 = step_back_u0028_u1_u003b((&param_9));
                (*everywhere) = _e113;
            } else {
                let _e114 = (*here);
                param_10 = _e114;
                let _e115 = step_back_u0028_u1_u003b((&param_10));
                (*here) = _e115;
            }
            let _e116 = wide;
            let _e117 = other;
            let _e118 = near;
            let _e122 = unnamed.splats[select(_e118, _e117, _e116)];
            param_11 = _e122;
            let _e123 = ready_u0028_vu4_u003b((&param_11));
            param_12 = _e123;
            blend_u0028_struct_u002d_Ready_u002d_vf2_u002d_vf2_u002d_vf2_u002d_vf2_u002d_vf4_u002d_f11_u003b((&param_12));
            continue;
        } else {
            break;
        }
    }
    return;
}

fn blend_chain_u0028_u1_u003b(chain_1: ptr<function, u32>) {
    var param_13: u32;
    var param_14: u32;

    let _e66 = (*chain_1);
    param_13 = _e66;
    param_14 = 0u;
    blend_both_u0028_u1_u003b_u1_u003b((&param_13), (&param_14));
    return;
}

fn blend_tile_u0028_u1_u003b(tile: ptr<function, u32>) {
    var wide_1: u32;
    var blocks: u32;
    var block: u32;
    var here_1: u32;
    var param_15: u32;
    var param_16: u32;
    var param_17: u32;

    let _e73 = unnamed_1.bins[1i];
    wide_1 = _e73;
    let _e74 = (*tile);
    let _e78 = unnamed_1.bins[(34u + _e74)];
    let _e79 = wide_1;
    blocks = (_e78 | _e79);
    loop {
        let _e81 = blocks;
        let _e83 = open;
        if ((_e81 != 0u) && _e83) {
            let _e85 = blocks;
            block = bitcast<u32>(firstLeadingBit(_e85));
            let _e88 = block;
            let _e91 = blocks;
            blocks = (_e91 ^ (1u << bitcast<u32>(_e88)));
            let _e93 = (*tile);
            let _e96 = block;
            let _e100 = unnamed_1.bins[((16418u + (_e93 * 32u)) + _e96)];
            here_1 = _e100;
            let _e101 = wide_1;
            let _e102 = block;
            if (((_e101 >> bitcast<u32>(_e102)) & 1u) == 0u) {
                let _e107 = here_1;
                param_15 = _e107;
                blend_chain_u0028_u1_u003b((&param_15));
            } else {
                let _e108 = block;
                let _e110 = here_1;
                param_16 = _e110;
                let _e113 = unnamed_1.bins[(2u + _e108)];
                param_17 = _e113;
                blend_both_u0028_u1_u003b_u1_u003b((&param_16), (&param_17));
            }
            continue;
        } else {
            break;
        }
    }
    return;
}

fn main_1() {
    var k_1: u32;
    var lane: u32;
    var place: vec2<u32>;
    var first: vec2<u32>;
    var tile_1: vec2<u32>;
    var param_18: u32;
    var k_2: u32;
    var pixel: vec2<u32>;

    shaded = 0u;
    open = true;
    k_1 = 0u;
    loop {
        let _e71 = k_1;
        if (_e71 < 16u) {
            let _e73 = k_1;
            pixels[_e73] = vec4<f32>(0f, 0f, 0f, 1f);
            continue;
        } else {
            break;
        }
        continuing {
            let _e75 = k_1;
            k_1 = (_e75 + bitcast<u32>(1i));
        }
    }
    let _e78 = gl_LocalInvocationIndex_1;
    lane = _e78;
    let _e79 = lane;
    let _e81 = lane;
    let _e86 = lane;
    let _e90 = lane;
    place = vec2<u32>(((_e79 & 3u) | ((_e81 >> bitcast<u32>(2u)) & 4u)), (((_e86 >> bitcast<u32>(2u)) & 3u) | ((_e90 >> bitcast<u32>(3u)) & 4u)));
    let _e96 = gl_WorkGroupID_1;
    let _e100 = place;
    first = ((_e96.xy * vec2(32u)) + (vec2(4u) * _e100));
    let _e104 = first;
    middle = (vec2<f32>(_e104) + vec2(2f));
    let _e108 = first;
    let _e110 = frame.tile;
    tile_1 = (_e108 / vec2(u32(_e110)));
    let _e115 = tile_1[1u];
    let _e118 = tile_1[0u];
    param_18 = ((_e115 * 128u) + _e118);
    blend_tile_u0028_u1_u003b((&param_18));
    k_2 = 0u;
    loop {
        let _e120 = k_2;
        if (_e120 < 16u) {
            let _e122 = first;
            let _e123 = k_2;
            let _e125 = k_2;
            pixel = (_e122 + vec2<u32>((_e123 % 4u), (_e125 / 4u)));
            let _e129 = pixel;
            let _e132 = frame.size;
            if all((vec2<f32>(_e129) < _e132)) {
                let _e135 = pixel;
                let _e137 = k_2;
                let _e139 = pixels[_e137];
                let _e140 = _e139.xyz;
                let _e141 = k_2;
                let _e144 = pixels[_e141][3u];
                textureStore(picture, bitcast<vec2<i32>>(_e135), vec4<f32>(_e140.x, _e140.y, _e140.z, (1f - _e144)));
            }
            continue;
        } else {
            break;
        }
        continuing {
            let _e150 = k_2;
            k_2 = (_e150 + bitcast<u32>(1i));
        }
    }
    let _e154 = settings.count;
    let _e156 = shaded;
    if ((_e154 != 0u) && (_e156 > 0u)) {
        let _e161 = shaded;
        let _e162 = atomicAdd((&unnamed_2.control.fragments), _e161);
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn main(@builtin(local_invocation_index) gl_LocalInvocationIndex: u32, @builtin(workgroup_id) gl_WorkGroupID: vec3<u32>) {
    gl_LocalInvocationIndex_1 = gl_LocalInvocationIndex;
    gl_WorkGroupID_1 = gl_WorkGroupID;
    main_1();
}
