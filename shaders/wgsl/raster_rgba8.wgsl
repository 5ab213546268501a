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
var<private> gl_LocalInvocationID_1: vec3<u32>;
var<private> gl_WorkGroupID_1: vec3<u32>;
@group(0) @binding(4) 
var picture: texture_storage_2d<rgba8unorm,write>;
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

    let _e77 = middle;
    let _e79 = (*splat).center;
    from_ = (_e77 - _e79);
    let _e81 = open;
    phi_319_ = _e81;
    if _e81 {
        let _e82 = from_;
        let _e85 = (*splat).reach;
        phi_319_ = all((abs(_e82) < (_e85 + vec2(1.5f))));
    }
    let _e91 = phi_319_;
    if !(_e91) {
        return;
    }
    let _e93 = from_;
    from_ = (_e93 - vec2(1.5f));
    let _e96 = from_;
    let _e98 = (*splat).along;
    let _e100 = from_;
    let _e102 = (*splat).across;
    deviation = vec2<f32>(dot(_e96, _e98), dot(_e100, _e102));
    let _e107 = (*splat).along[0u];
    let _e110 = (*splat).across[0u];
    right = vec2<f32>(_e107, _e110);
    most = 0f;
    y = 0u;
    loop {
        let _e112 = y;
        if (_e112 < 4u) {
            let _e114 = deviation;
            let _e115 = deviation;
            weight = exp2(-(dot(_e114, _e115)));
            let _e119 = weight;
            if (_e119 >= 0.00000000000000001f) {
                let _e123 = (*splat).color[3u];
                let _e124 = weight;
                local = (_e123 * _e124);
            } else {
                local = 0f;
            }
            let _e126 = local;
            alpha = _e126;
            let _e127 = deviation;
            let _e129 = right;
            let _e131 = right;
            factor = exp2(min(-(dot(((_e127 * 2f) + _e129), _e131)), 60f));
            x = 0u;
            loop {
                let _e136 = x;
                if (_e136 < 4u) {
                    let _e138 = y;
                    let _e140 = x;
                    k = ((_e138 * 4u) + _e140);
                    let _e142 = alpha;
                    covers = min(_e142, 0.99f);
                    let _e144 = covers;
                    let _e146 = settings.cutoff;
                    if (_e144 >= _e146) {
                        let _e148 = covers;
                        let _e149 = k;
                        let _e152 = pixels[_e149][3u];
                        local_1 = (_e148 * _e152);
                    } else {
                        local_1 = 0f;
                    }
                    let _e154 = local_1;
                    share = _e154;
                    let _e155 = k;
                    let _e156 = k;
                    let _e158 = pixels[_e156];
                    let _e160 = share;
                    let _e162 = (*splat).color;
                    let _e165 = (_e158.xyz + (_e162.xyz * _e160));
                    let _e166 = k;
                    let _e169 = pixels[_e166][3u];
                    let _e170 = share;
                    pixels[_e155] = vec4<f32>(_e165.x, _e165.y, _e165.z, (_e169 - _e170));
                    let _e177 = most;
                    let _e178 = k;
                    let _e181 = pixels[_e178][3u];
                    most = max(_e177, _e181);
                    let _e183 = factor;
                    let _e184 = alpha;
                    alpha = (_e184 * _e183);
                    let _e187 = (*splat).bend;
                    let _e188 = factor;
                    factor = (_e188 * _e187);
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e190 = x;
                    x = (_e190 + bitcast<u32>(1i));
                }
            }
            let _e195 = (*splat).along[1u];
            let _e198 = (*splat).across[1u];
            let _e200 = deviation;
            deviation = (_e200 + vec2<f32>(_e195, _e198));
            continue;
        } else {
            break;
        }
        continuing {
            let _e202 = y;
            y = (_e202 + bitcast<u32>(1i));
        }
    }
    let _e205 = shaded;
    shaded = (_e205 + 16u);
    let _e207 = most;
    let _e209 = settings.full;
    open = (_e207 >= _e209);
    return;
}

fn half_box_u0028_struct_u002d_Splat_u002d_vf2_u002d_vf2_u002d_f1_u002d_vf3_u002d_u11_u003b_f1_u003b(splat_1: ptr<function, Splat>, reach: ptr<function, f32>) -> vec2<f32> {
    var steep: f32;

    let _e66 = (*splat_1).shorter;
    let _e68 = (*splat_1).axis;
    let _e70 = (*splat_1).axis;
    steep = (_e66 * inverseSqrt(dot(_e68, _e70)));
    let _e74 = (*reach);
    let _e76 = (*splat_1).axis;
    let _e78 = (*splat_1).axis;
    let _e80 = steep;
    let _e81 = steep;
    let _e84 = (*splat_1).axis;
    let _e88 = (*splat_1).axis;
    return (sqrt(((_e76 * _e78) + ((_e84.yx * (_e80 * _e81)) * _e88.yx))) * _e74);
}

fn reach_of_u0028_u1_u003b(opacity: ptr<function, u32>) -> f32 {
    let _e63 = (*opacity);
    let _e66 = frame.hull_opacity;
    let _e69 = frame.cutoff;
    return sqrt((2f * log(max((max(f32(_e63), _e66) / _e69), 1f))));
}

fn steps_of_u0028_vu4_u003b(words: ptr<function, vec4<u32>>) -> vec2<f32> {
    let _e63 = (*words);
    return vec2<f32>((_e63.xy & vec2(1048575u)));
}

fn unpack_splat_u0028_vu4_u003b(words_1: ptr<function, vec4<u32>>) -> Splat {
    var splat_2: Splat;
    var param: vec4<u32>;
    var blue: u32;

    let _e66 = (*words_1);
    param = _e66;
    let _e67 = steps_of_u0028_vu4_u003b((&param));
    let _e69 = frame.fixed_scale;
    let _e73 = frame.guard;
    splat_2.center = ((_e67 / vec2(_e69)) - vec2(_e73));
    let _e78 = (*words_1)[2u];
    splat_2.axis = unpack2x16float(_e78);
    let _e82 = (*words_1)[3u];
    splat_2.shorter = unpack2x16float(_e82).x;
    let _e87 = (*words_1)[3u];
    let _e93 = (*words_1)[0u];
    blue = (((_e87 >> bitcast<u32>(24u)) << bitcast<u32>(2u)) | (_e93 >> bitcast<u32>(30u)));
    let _e98 = (*words_1)[0u];
    let _e104 = (*words_1)[1u];
    let _e109 = blue;
    splat_2.color = (vec3<f32>(f32(((_e98 >> bitcast<u32>(20u)) & 1023u)), f32(((_e104 >> bitcast<u32>(20u)) & 1023u)), f32(_e109)) / vec3(1023f));
    let _e116 = (*words_1)[3u];
    splat_2.opacity = ((_e116 >> bitcast<u32>(16u)) & 255u);
    let _e121 = splat_2;
    return _e121;
}

fn ready_u0028_vu4_u003b(words_2: ptr<function, vec4<u32>>) -> Ready {
    var splat_3: Splat;
    var param_1: vec4<u32>;
    var inverse: f32;
    var r: Ready;
    var param_2: u32;
    var param_3: Splat;
    var param_4: f32;

    let _e70 = (*words_2);
    param_1 = _e70;
    let _e71 = unpack_splat_u0028_vu4_u003b((&param_1));
    splat_3 = _e71;
    let _e73 = splat_3.axis;
    let _e75 = splat_3.axis;
    inverse = (1f / dot(_e73, _e75));
    let _e79 = splat_3.center;
    r.center = _e79;
    let _e82 = splat_3.opacity;
    param_2 = _e82;
    let _e83 = reach_of_u0028_u1_u003b((&param_2));
    let _e84 = splat_3;
    param_3 = _e84;
    param_4 = _e83;
    let _e85 = half_box_u0028_struct_u002d_Splat_u002d_vf2_u002d_vf2_u002d_f1_u002d_vf3_u002d_u11_u003b_f1_u003b((&param_3), (&param_4));
    r.reach = _e85;
    let _e87 = inverse;
    let _e90 = splat_3.axis;
    r.along = (_e90 * (0.8493218f * _e87));
    let _e93 = inverse;
    let _e97 = splat_3.shorter;
    let _e101 = splat_3.axis[1u];
    let _e105 = splat_3.axis[0u];
    r.across = (vec2<f32>(-(_e101), _e105) * ((0.8493218f * sqrt(_e93)) / _e97));
    let _e110 = splat_3.color;
    let _e112 = splat_3.opacity;
    r.color = vec4<f32>(_e110.x, _e110.y, _e110.z, (f32(_e112) / 255f));
    let _e122 = r.along[0u];
    let _e125 = r.along[0u];
    let _e129 = r.across[0u];
    let _e132 = r.across[0u];
    r.bend = exp2((-2f * ((_e122 * _e125) + (_e129 * _e132))));
    let _e138 = r;
    return _e138;
}

fn step_back_u0028_u1_u003b(chain: ptr<function, u32>) -> u32 {
    var local_2: u32;

    let _e64 = (*chain);
    if ((_e64 & 7u) > 1u) {
        let _e67 = (*chain);
        local_2 = (_e67 - 1u);
    } else {
        let _e69 = (*chain);
        let _e74 = unnamed_1.bins[((540698u + _e69) - 1u)];
        local_2 = _e74;
    }
    let _e75 = local_2;
    return _e75;
}

fn key_at_u0028_u1_u003b(i: ptr<function, u32>) -> u32 {
    var word: u32;
    var local_3: u32;
    var keys: u32;
    var local_4: u32;

    let _e68 = frame.key_start;
    let _e70 = frame.half_keys;
    if (_e70 != 0u) {
        let _e72 = (*i);
        local_3 = (_e72 / 2u);
    } else {
        let _e74 = (*i);
        local_3 = _e74;
    }
    let _e75 = local_3;
    word = (_e68 + _e75);
    let _e77 = word;
    let _e79 = word;
    let _e84 = unnamed.splats[(_e77 / 4u)][(_e79 & 3u)];
    keys = _e84;
    let _e86 = frame.half_keys;
    if (_e86 != 0u) {
        let _e88 = keys;
        let _e89 = (*i);
        local_4 = ((_e88 >> bitcast<u32>((16u * (_e89 & 1u)))) & 65535u);
    } else {
        let _e95 = keys;
        local_4 = _e95;
    }
    let _e96 = local_4;
    return _e96;
}

fn nearer_u0028_u1_u003b_u1_u003b(a: ptr<function, u32>, b: ptr<function, u32>) -> bool {
    var key: u32;
    var param_5: u32;
    var than: u32;
    var param_6: u32;
    var phi_543_: bool;

    let _e68 = (*a);
    param_5 = _e68;
    let _e69 = key_at_u0028_u1_u003b((&param_5));
    key = _e69;
    let _e70 = (*b);
    param_6 = _e70;
    let _e71 = key_at_u0028_u1_u003b((&param_6));
    than = _e71;
    let _e72 = key;
    let _e73 = than;
    let _e74 = (_e72 > _e73);
    phi_543_ = _e74;
    if !(_e74) {
        let _e76 = key;
        let _e77 = than;
        let _e79 = (*a);
        let _e80 = (*b);
        phi_543_ = ((_e76 == _e77) && (_e79 > _e80));
    }
    let _e84 = phi_543_;
    return _e84;
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
        let _e75 = open;
        phi_581_ = _e75;
        if _e75 {
            let _e76 = (*here);
            let _e77 = (*everywhere);
            phi_581_ = ((_e76 | _e77) != 0u);
        }
        let _e81 = phi_581_;
        if _e81 {
            let _e82 = (*here);
            if (_e82 == 0u) {
                local_5 = 0u;
            } else {
                let _e84 = (*here);
                let _e88 = unnamed_1.bins[(540698u + _e84)];
                local_5 = _e88;
            }
            let _e89 = local_5;
            near = _e89;
            let _e90 = (*everywhere);
            if (_e90 == 0u) {
                local_6 = 0u;
            } else {
                let _e92 = (*everywhere);
                let _e96 = unnamed_1.bins[(540698u + _e92)];
                local_6 = _e96;
            }
            let _e97 = local_6;
            other = _e97;
            let _e98 = (*here);
            let _e99 = (_e98 == 0u);
            phi_623_ = _e99;
            if !(_e99) {
                let _e101 = (*everywhere);
                let _e102 = (_e101 != 0u);
                phi_622_ = _e102;
                if _e102 {
                    let _e103 = other;
                    param_7 = _e103;
                    let _e104 = near;
                    param_8 = _e104;
                    let _e105 = nearer_u0028_u1_u003b_u1_u003b((&param_7), (&param_8));
                    phi_622_ = _e105;
                }
                let _e107 = phi_622_;
                phi_623_ = _e107;
            }
            let _e109 = phi_623_;
            wide = _e109;
            let _e110 = wide;
            if _e110 {
                let _e111 = (*everywhere);
                param_9 = _e111;
                let _e112 = step_back_u0028_u1_u003b((&param_9));
                (*everywhere) = _e112;
            } else {
                let _e113 = (*here);
                param_10 = _e113;
                let _e114 = step_back_u0028_u1_u003b((&param_10));
                (*here) = _e114;
            }
            let _e115 = wide;
            let _e116 = other;
            let _e117 = near;
            let _e121 = unnamed.splats[select(_e117, _e116, _e115)];
            param_11 = _e121;
            let _e122 = ready_u0028_vu4_u003b((&param_11));
            param_12 = _e122;
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

    let _e65 = (*chain_1);
    param_13 = _e65;
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

    let _e72 = unnamed_1.bins[1i];
    wide_1 = _e72;
    let _e73 = (*tile);
    let _e77 = unnamed_1.bins[(34u + _e73)];
    let _e78 = wide_1;
    blocks = (_e77 | _e78);
    loop {
        let _e80 = blocks;
        let _e82 = open;
        if ((_e80 != 0u) && _e82) {
            let _e84 = blocks;
            block = bitcast<u32>(firstLeadingBit(_e84));
            let _e87 = block;
            let _e90 = blocks;
            blocks = (_e90 ^ (1u << bitcast<u32>(_e87)));
            let _e92 = (*tile);
            let _e95 = block;
            let _e99 = unnamed_1.bins[((16418u + (_e92 * 32u)) + _e95)];
            here_1 = _e99;
            let _e100 = wide_1;
            let _e101 = block;
            if (((_e100 >> bitcast<u32>(_e101)) & 1u) == 0u) {
                let _e106 = here_1;
                param_15 = _e106;
                blend_chain_u0028_u1_u003b((&param_15));
            } else {
                let _e107 = block;
                let _e109 = here_1;
                param_16 = _e109;
                let _e112 = unnamed_1.bins[(2u + _e107)];
                param_17 = _e112;
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
        let _e69 = k_1;
        if (_e69 < 16u) {
            let _e71 = k_1;
            pixels[_e71] = vec4<f32>(0f, 0f, 0f, 1f);
            continue;
        } else {
            break;
        }
        continuing {
            let _e73 = k_1;
            k_1 = (_e73 + bitcast<u32>(1i));
        }
    }
    let _e76 = gl_LocalInvocationID_1;
    place = _e76.xy;
    let _e79 = place[0u];
    let _e81 = place[1u];
    let _e86 = place[1u];
    place = vec2<u32>((_e79 + (4u * (_e81 / 8u))), (_e86 % 8u));
    let _e89 = gl_WorkGroupID_1;
    let _e93 = place;
    first = ((_e89.xy * vec2(32u)) + (vec2(4u) * _e93));
    let _e97 = first;
    middle = (vec2<f32>(_e97) + vec2(2f));
    let _e101 = first;
    let _e103 = frame.tile;
    tile_1 = (_e101 / vec2(u32(_e103)));
    let _e108 = tile_1[1u];
    let _e111 = tile_1[0u];
    param_18 = ((_e108 * 128u) + _e111);
    blend_tile_u0028_u1_u003b((&param_18));
    k_2 = 0u;
    loop {
        let _e113 = k_2;
        if (_e113 < 16u) {
            let _e115 = first;
            let _e116 = k_2;
            let _e118 = k_2;
            pixel = (_e115 + vec2<u32>((_e116 % 4u), (_e118 / 4u)));
            let _e122 = pixel;
            let _e125 = frame.size;
            if all((vec2<f32>(_e122) < _e125)) {
                let _e128 = pixel;
                let _e130 = k_2;
                let _e132 = pixels[_e130];
                let _e133 = _e132.xyz;
                let _e134 = k_2;
                let _e137 = pixels[_e134][3u];
                textureStore(picture, bitcast<vec2<i32>>(_e128), vec4<f32>(_e133.x, _e133.y, _e133.z, (1f - _e137)));
            }
            continue;
        } else {
            break;
        }
        continuing {
            let _e143 = k_2;
            k_2 = (_e143 + bitcast<u32>(1i));
        }
    }
    let _e147 = settings.count;
    let _e149 = shaded;
    if ((_e147 != 0u) && (_e149 > 0u)) {
        let _e154 = shaded;
        let _e155 = atomicAdd((&unnamed_2.control.fragments), _e154);
    }
    return;
}

@compute @workgroup_size(4, 16, 1) 
fn main(@builtin(local_invocation_id) gl_LocalInvocationID: vec3<u32>, @builtin(workgroup_id) gl_WorkGroupID: vec3<u32>) {
    gl_LocalInvocationID_1 = gl_LocalInvocationID;
    gl_WorkGroupID_1 = gl_WorkGroupID;
    main_1();
}
