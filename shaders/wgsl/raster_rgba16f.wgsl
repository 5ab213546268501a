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

fn step_back_u0028_u1_u003b(chain: ptr<function, u32>) -> u32 {
    var local: u32;

    let _e67 = (*chain);
    if ((_e67 & 7u) > 1u) {
        let _e70 = (*chain);
        local = (_e70 - 1u);
    } else {
        let _e72 = (*chain);
        let _e77 = unnamed_1.bins[((576602u + _e72) - 1u)];
        local = _e77;
    }
    let _e78 = local;
    return _e78;
}

fn blend_u0028_struct_u002d_Ready_u002d_vf2_u002d_vf2_u002d_vf2_u002d_vf2_u002d_vf4_u002d_f11_u003b(splat: ptr<function, Ready>) {
    var from_: vec2<f32>;
    var deviation: vec2<f32>;
    var right: vec2<f32>;
    var most: f32;
    var y: u32;
    var weight: f32;
    var alpha: f32;
    var local_1: f32;
    var factor: f32;
    var x: u32;
    var k: u32;
    var covers: f32;
    var share: f32;
    var local_2: f32;
    var phi_341_: bool;

    let _e80 = middle;
    let _e82 = (*splat).center;
    from_ = (_e80 - _e82);
    let _e84 = open;
    phi_341_ = _e84;
    if _e84 {
        let _e85 = from_;
        let _e88 = (*splat).reach;
        phi_341_ = all((abs(_e85) < (_e88 + vec2(1.5f))));
    }
    let _e94 = phi_341_;
    if !(_e94) {
        return;
    }
    let _e96 = from_;
    from_ = (_e96 - vec2(1.5f));
    let _e99 = from_;
    let _e101 = (*splat).along;
    let _e103 = from_;
    let _e105 = (*splat).across;
    deviation = vec2<f32>(dot(_e99, _e101), dot(_e103, _e105));
    let _e110 = (*splat).along[0u];
    let _e113 = (*splat).across[0u];
    right = vec2<f32>(_e110, _e113);
    most = 0f;
    y = 0u;
    loop {
        let _e115 = y;
        if (_e115 < 4u) {
            let _e117 = deviation;
            let _e118 = deviation;
            weight = exp2(-(dot(_e117, _e118)));
            let _e122 = weight;
            if (_e122 >= 0.00000000000000001f) {
                let _e126 = (*splat).color[3u];
                let _e127 = weight;
                local_1 = (_e126 * _e127);
            } else {
                local_1 = 0f;
            }
            let _e129 = local_1;
            alpha = _e129;
            let _e130 = deviation;
            let _e132 = right;
            let _e134 = right;
            factor = exp2(min(-(dot(((_e130 * 2f) + _e132), _e134)), 60f));
            x = 0u;
            loop {
                let _e139 = x;
                if (_e139 < 4u) {
                    let _e141 = y;
                    let _e143 = x;
                    k = ((_e141 * 4u) + _e143);
                    let _e145 = alpha;
                    covers = min(_e145, 0.99f);
                    let _e147 = covers;
                    let _e149 = settings.cutoff;
                    if (_e147 >= _e149) {
                        let _e151 = covers;
                        let _e152 = k;
                        let _e155 = pixels[_e152][3u];
                        local_2 = (_e151 * _e155);
                    } else {
                        local_2 = 0f;
                    }
                    let _e157 = local_2;
                    share = _e157;
                    let _e158 = k;
                    let _e159 = k;
                    let _e161 = pixels[_e159];
                    let _e163 = share;
                    let _e165 = (*splat).color;
                    let _e168 = (_e161.xyz + (_e165.xyz * _e163));
                    let _e169 = k;
                    let _e172 = pixels[_e169][3u];
                    let _e173 = share;
                    pixels[_e158] = vec4<f32>(_e168.x, _e168.y, _e168.z, (_e172 - _e173));
                    let _e180 = most;
                    let _e181 = k;
                    let _e184 = pixels[_e181][3u];
                    most = max(_e180, _e184);
                    let _e186 = factor;
                    let _e187 = alpha;
                    alpha = (_e187 * _e186);
                    let _e190 = (*splat).bend;
                    let _e191 = factor;
                    factor = (_e191 * _e190);
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e193 = x;
                    x = (_e193 + bitcast<u32>(1i));
                }
            }
            let _e198 = (*splat).along[1u];
            let _e201 = (*splat).across[1u];
            let _e203 = deviation;
            deviation = (_e203 + vec2<f32>(_e198, _e201));
            continue;
        } else {
            break;
        }
        continuing {
            let _e205 = y;
            y = (_e205 + bitcast<u32>(1i));
        }
    }
    let _e208 = shaded;
    shaded = (_e208 + 16u);
    let _e210 = most;
    let _e212 = settings.full;
    open = (_e210 >= _e212);
    return;
}

fn half_box_u0028_struct_u002d_Splat_u002d_vf2_u002d_vf2_u002d_f1_u002d_vf3_u002d_u11_u003b_f1_u003b(splat_1: ptr<function, Splat>, reach: ptr<function, f32>) -> vec2<f32> {
    var steep: f32;

    let _e69 = (*splat_1).shorter;
    let _e71 = (*splat_1).axis;
    let _e73 = (*splat_1).axis;
    steep = (_e69 * inverseSqrt(dot(_e71, _e73)));
    let _e77 = (*reach);
    let _e79 = (*splat_1).axis;
    let _e81 = (*splat_1).axis;
    let _e83 = steep;
    let _e84 = steep;
    let _e87 = (*splat_1).axis;
    let _e91 = (*splat_1).axis;
    return (sqrt(((_e79 * _e81) + ((_e87.yx * (_e83 * _e84)) * _e91.yx))) * _e77);
}

fn reach_of_u0028_u1_u003b(opacity: ptr<function, u32>) -> f32 {
    let _e66 = (*opacity);
    let _e69 = frame.hull_opacity;
    let _e72 = frame.cutoff;
    return sqrt((2f * log(max((max(f32(_e66), _e69) / _e72), 1f))));
}

fn steps_of_u0028_vu4_u003b(words: ptr<function, vec4<u32>>) -> vec2<f32> {
    let _e66 = (*words);
    return vec2<f32>((_e66.xy & vec2(1048575u)));
}

fn unpack_splat_u0028_vu4_u003b(words_1: ptr<function, vec4<u32>>) -> Splat {
    var splat_2: Splat;
    var param: vec4<u32>;
    var blue: u32;

    let _e69 = (*words_1);
    param = _e69;
    let _e70 = steps_of_u0028_vu4_u003b((&param));
    let _e72 = frame.fixed_scale;
    let _e76 = frame.guard;
    splat_2.center = ((_e70 / vec2(_e72)) - vec2(_e76));
    let _e81 = (*words_1)[2u];
    splat_2.axis = unpack2x16float(_e81);
    let _e85 = (*words_1)[3u];
    splat_2.shorter = unpack2x16float(_e85).x;
    let _e90 = (*words_1)[3u];
    let _e96 = (*words_1)[0u];
    blue = (((_e90 >> bitcast<u32>(24u)) << bitcast<u32>(2u)) | (_e96 >> bitcast<u32>(30u)));
    let _e101 = (*words_1)[0u];
    let _e107 = (*words_1)[1u];
    let _e112 = blue;
    splat_2.color = (vec3<f32>(f32(((_e101 >> bitcast<u32>(20u)) & 1023u)), f32(((_e107 >> bitcast<u32>(20u)) & 1023u)), f32(_e112)) / vec3(1023f));
    let _e119 = (*words_1)[3u];
    splat_2.opacity = ((_e119 >> bitcast<u32>(16u)) & 255u);
    let _e124 = splat_2;
    return _e124;
}

fn ready_u0028_vu4_u003b(words_2: ptr<function, vec4<u32>>) -> Ready {
    var splat_3: Splat;
    var param_1: vec4<u32>;
    var inverse: f32;
    var r: Ready;
    var param_2: u32;
    var param_3: Splat;
    var param_4: f32;

    let _e73 = (*words_2);
    param_1 = _e73;
    let _e74 = unpack_splat_u0028_vu4_u003b((&param_1));
    splat_3 = _e74;
    let _e76 = splat_3.axis;
    let _e78 = splat_3.axis;
    inverse = (1f / dot(_e76, _e78));
    let _e82 = splat_3.center;
    r.center = _e82;
    let _e85 = splat_3.opacity;
    param_2 = _e85;
    let _e86 = reach_of_u0028_u1_u003b((&param_2));
    let _e87 = splat_3;
    param_3 = _e87;
    param_4 = _e86;
    let _e88 = half_box_u0028_struct_u002d_Splat_u002d_vf2_u002d_vf2_u002d_f1_u002d_vf3_u002d_u11_u003b_f1_u003b((&param_3), (&param_4));
    r.reach = _e88;
    let _e90 = inverse;
    let _e93 = splat_3.axis;
    r.along = (_e93 * (0.8493218f * _e90));
    let _e96 = inverse;
    let _e100 = splat_3.shorter;
    let _e104 = splat_3.axis[1u];
    let _e108 = splat_3.axis[0u];
    r.across = (vec2<f32>(-(_e104), _e108) * ((0.8493218f * sqrt(_e96)) / _e100));
    let _e113 = splat_3.color;
    let _e115 = splat_3.opacity;
    r.color = vec4<f32>(_e113.x, _e113.y, _e113.z, (f32(_e115) / 255f));
    let _e125 = r.along[0u];
    let _e128 = r.along[0u];
    let _e132 = r.across[0u];
    let _e135 = r.across[0u];
    r.bend = exp2((-2f * ((_e125 * _e128) + (_e132 * _e135))));
    let _e141 = r;
    return _e141;
}

fn key_at_u0028_u1_u003b(i: ptr<function, u32>) -> u32 {
    var word: u32;
    var local_3: u32;
    var keys: u32;
    var local_4: u32;

    let _e71 = frame.key_start;
    let _e73 = frame.half_keys;
    if (_e73 != 0u) {
        let _e75 = (*i);
        local_3 = (_e75 / 2u);
    } else {
        let _e77 = (*i);
        local_3 = _e77;
    }
    let _e78 = local_3;
    word = (_e71 + _e78);
    let _e80 = word;
    let _e82 = word;
    let _e87 = unnamed.splats[(_e80 / 4u)][(_e82 & 3u)];
    keys = _e87;
    let _e89 = frame.half_keys;
    if (_e89 != 0u) {
        let _e91 = keys;
        let _e92 = (*i);
        local_4 = ((_e91 >> bitcast<u32>((16u * (_e92 & 1u)))) & 65535u);
    } else {
        let _e98 = keys;
        local_4 = _e98;
    }
    let _e99 = local_4;
    return _e99;
}

fn blend_merged_u0028_vu4_u003b(chains: ptr<function, vec4<u32>>) {
    var first: vec4<u32>;
    var keys_1: vec4<u32>;
    var level: u32;
    var param_5: u32;
    var take: u32;
    var splat_4: u32;
    var key: u32;
    var level_1: u32;
    var ahead: bool;
    var param_6: vec4<u32>;
    var param_7: Ready;
    var level_2: u32;
    var param_8: u32;
    var param_9: u32;
    var phi_634_: bool;
    var phi_650_: bool;
    var phi_651_: bool;

    first = vec4<u32>(0u, 0u, 0u, 0u);
    keys_1 = vec4<u32>(0u, 0u, 0u, 0u);
    level = 0u;
    loop {
        let _e80 = level;
        if (_e80 < 4u) {
            let _e82 = level;
            let _e84 = (*chains)[_e82];
            if (_e84 != 0u) {
                let _e86 = level;
                let _e87 = level;
                let _e89 = (*chains)[_e87];
                let _e93 = unnamed_1.bins[(576602u + _e89)];
                first[_e86] = _e93;
                let _e95 = level;
                let _e96 = level;
                let _e98 = first[_e96];
                param_5 = _e98;
                let _e99 = key_at_u0028_u1_u003b((&param_5));
                keys_1[_e95] = _e99;
            }
            continue;
        } else {
            break;
        }
        continuing {
            let _e101 = level;
            level = (_e101 + bitcast<u32>(1i));
        }
    }
    loop {
        let _e104 = open;
        let _e105 = (*chains);
        if (_e104 && any((_e105 != vec4<u32>(0u, 0u, 0u, 0u)))) {
            take = 4u;
            splat_4 = 0u;
            key = 0u;
            level_1 = 0u;
            loop {
                let _e109 = level_1;
                if (_e109 < 4u) {
                    let _e111 = take;
                    let _e112 = (_e111 == 4u);
                    phi_634_ = _e112;
                    if !(_e112) {
                        let _e114 = level_1;
                        let _e116 = keys_1[_e114];
                        let _e117 = key;
                        phi_634_ = (_e116 > _e117);
                    }
                    let _e120 = phi_634_;
                    phi_651_ = _e120;
                    if !(_e120) {
                        let _e122 = level_1;
                        let _e124 = keys_1[_e122];
                        let _e125 = key;
                        let _e126 = (_e124 == _e125);
                        phi_650_ = _e126;
                        if _e126 {
                            let _e127 = level_1;
                            let _e129 = first[_e127];
                            let _e130 = splat_4;
                            phi_650_ = (_e129 > _e130);
                        }
                        let _e133 = phi_650_;
                        phi_651_ = _e133;
                    }
                    let _e135 = phi_651_;
                    ahead = _e135;
                    let _e136 = level_1;
                    let _e138 = (*chains)[_e136];
                    let _e140 = ahead;
                    if ((_e138 != 0u) && _e140) {
                        let _e142 = level_1;
                        take = _e142;
                        let _e143 = level_1;
                        let _e145 = first[_e143];
                        splat_4 = _e145;
                        let _e146 = level_1;
                        let _e148 = keys_1[_e146];
                        key = _e148;
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e149 = level_1;
                    level_1 = (_e149 + bitcast<u32>(1i));
                }
            }
            let _e152 = splat_4;
            let _e155 = unnamed.splats[_e152];
            param_6 = _e155;
            let _e156 = ready_u0028_vu4_u003b((&param_6));
            param_7 = _e156;
            blend_u0028_struct_u002d_Ready_u002d_vf2_u002d_vf2_u002d_vf2_u002d_vf2_u002d_vf4_u002d_f11_u003b((&param_7));
            level_2 = 0u;
            loop {
                let _e157 = level_2;
                if (_e157 < 4u) {
                    let _e159 = level_2;
                    let _e160 = take;
                    if (_e159 == _e160) {
                        let _e162 = level_2;
                        let _e163 = level_2;
                        let _e165 = (*chains)[_e163];
                        param_8 = _e165;
                        let _e166 = step_back_u0028_u1_u003b((&param_8));
                        (*chains)[_e162] = _e166;
                        let _e168 = level_2;
                        let _e170 = (*chains)[_e168];
                        if (_e170 != 0u) {
                            let _e172 = level_2;
                            let _e173 = level_2;
                            let _e175 = (*chains)[_e173];
                            let _e179 = unnamed_1.bins[(576602u + _e175)];
                            first[_e172] = _e179;
                            let _e181 = level_2;
                            let _e182 = level_2;
                            let _e184 = first[_e182];
                            param_9 = _e184;
                            let _e185 = key_at_u0028_u1_u003b((&param_9));
                            keys_1[_e181] = _e185;
                        }
                    }
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e187 = level_2;
                    level_2 = (_e187 + bitcast<u32>(1i));
                }
            }
            continue;
        } else {
            break;
        }
    }
    return;
}

fn blend_chain_u0028_u1_u003b(chain_1: ptr<function, u32>) {
    var splat_5: u32;
    var param_10: u32;
    var param_11: vec4<u32>;
    var param_12: Ready;

    loop {
        let _e70 = open;
        let _e71 = (*chain_1);
        if (_e70 && (_e71 != 0u)) {
            let _e74 = (*chain_1);
            let _e78 = unnamed_1.bins[(576602u + _e74)];
            splat_5 = _e78;
            let _e79 = (*chain_1);
            param_10 = _e79;
            let _e80 = step_back_u0028_u1_u003b((&param_10));
            (*chain_1) = _e80;
            let _e81 = splat_5;
            let _e84 = unnamed.splats[_e81];
            param_11 = _e84;
            let _e85 = ready_u0028_vu4_u003b((&param_11));
            param_12 = _e85;
            blend_u0028_struct_u002d_Ready_u002d_vf2_u002d_vf2_u002d_vf2_u002d_vf2_u002d_vf4_u002d_f11_u003b((&param_12));
            continue;
        } else {
            break;
        }
    }
    return;
}

fn bins_tile_u0028_u1_u003b_vu2_u003b(level_3: ptr<function, u32>, at: ptr<function, vec2<u32>>) -> u32 {
    let _e67 = (*level_3);
    let _e75 = (*at)[1u];
    let _e76 = (*level_3);
    let _e83 = (*at)[0u];
    return (((((16384u - (16384u >> bitcast<u32>((4u * _e67)))) / 15u) * 16u) + (_e75 * (128u >> bitcast<u32>((2u * _e76))))) + _e83);
}

fn blend_tiles_u0028_vu2_u003b(at_1: ptr<function, vec2<u32>>) {
    var blocks: u32;
    var level_4: u32;
    var tiles: vec4<u32>;
    var local_5: vec2<u32>;
    var param_13: u32;
    var param_14: vec2<u32>;
    var block: u32;
    var all_: u32;
    var one: bool;
    var level_5: u32;
    var chains_1: vec4<u32>;
    var param_15: u32;
    var param_16: vec4<u32>;
    var phi_836_: bool;
    var phi_837_: bool;

    blocks = 0u;
    level_4 = 0u;
    loop {
        let _e79 = level_4;
        if (_e79 < 4u) {
            let _e81 = level_4;
            let _e82 = level_4;
            if (_e82 < 3u) {
                let _e84 = (*at_1);
                let _e85 = level_4;
                local_5 = (_e84 >> bitcast<vec2<u32>>(vec2((2u * _e85))));
            } else {
                local_5 = vec2<u32>(0u, 0u);
            }
            let _e90 = level_4;
            param_13 = _e90;
            let _e91 = local_5;
            param_14 = _e91;
            let _e92 = bins_tile_u0028_u1_u003b_vu2_u003b((&param_13), (&param_14));
            tiles[_e81] = _e92;
            let _e94 = level_4;
            let _e96 = tiles[_e94];
            let _e100 = unnamed_1.bins[(1u + _e96)];
            let _e101 = blocks;
            blocks = (_e101 | _e100);
            continue;
        } else {
            break;
        }
        continuing {
            let _e103 = level_4;
            level_4 = (_e103 + bitcast<u32>(1i));
        }
    }
    loop {
        let _e106 = blocks;
        let _e108 = open;
        if ((_e106 != 0u) && _e108) {
            let _e110 = blocks;
            block = bitcast<u32>(firstLeadingBit(_e110));
            let _e113 = block;
            let _e116 = blocks;
            blocks = (_e116 ^ (1u << bitcast<u32>(_e113)));
            all_ = 0u;
            one = true;
            level_5 = 0u;
            loop {
                let _e118 = level_5;
                if (_e118 < 4u) {
                    let _e120 = level_5;
                    let _e121 = level_5;
                    let _e123 = tiles[_e121];
                    let _e126 = block;
                    let _e130 = unnamed_1.bins[((17474u + (_e123 * 32u)) + _e126)];
                    chains_1[_e120] = _e130;
                    let _e132 = one;
                    phi_837_ = _e132;
                    if _e132 {
                        let _e133 = all_;
                        let _e134 = (_e133 == 0u);
                        phi_836_ = _e134;
                        if !(_e134) {
                            let _e136 = level_5;
                            let _e138 = chains_1[_e136];
                            phi_836_ = (_e138 == 0u);
                        }
                        let _e141 = phi_836_;
                        phi_837_ = _e141;
                    }
                    let _e143 = phi_837_;
                    one = _e143;
                    let _e144 = level_5;
                    let _e146 = chains_1[_e144];
                    let _e147 = all_;
                    all_ = (_e147 | _e146);
                    continue;
                } else {
                    break;
                }
                continuing {
                    let _e149 = level_5;
                    level_5 = (_e149 + bitcast<u32>(1i));
                }
            }
            let _e152 = one;
            if _e152 {
                let _e153 = all_;
                param_15 = _e153;
                blend_chain_u0028_u1_u003b((&param_15));
            } else {
                let _e154 = chains_1;
                param_16 = _e154;
                blend_merged_u0028_vu4_u003b((&param_16));
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
    var first_1: vec2<u32>;
    var param_17: vec2<u32>;
    var k_2: u32;
    var pixel: vec2<u32>;

    shaded = 0u;
    open = true;
    k_1 = 0u;
    loop {
        let _e72 = k_1;
        if (_e72 < 16u) {
            let _e74 = k_1;
            pixels[_e74] = vec4<f32>(0f, 0f, 0f, 1f);
            continue;
        } else {
            break;
        }
        continuing {
            let _e76 = k_1;
            k_1 = (_e76 + bitcast<u32>(1i));
        }
    }
    let _e79 = gl_LocalInvocationIndex_1;
    lane = _e79;
    let _e80 = lane;
    let _e82 = lane;
    let _e87 = lane;
    let _e91 = lane;
    place = vec2<u32>(((_e80 & 3u) | ((_e82 >> bitcast<u32>(2u)) & 4u)), (((_e87 >> bitcast<u32>(2u)) & 3u) | ((_e91 >> bitcast<u32>(3u)) & 4u)));
    let _e97 = gl_WorkGroupID_1;
    let _e101 = place;
    first_1 = ((_e97.xy * vec2(32u)) + (vec2(4u) * _e101));
    let _e105 = first_1;
    middle = (vec2<f32>(_e105) + vec2(2f));
    let _e109 = middle;
    let _e111 = frame.tile;
    param_17 = vec2<u32>((_e109 / vec2(_e111)));
    blend_tiles_u0028_vu2_u003b((&param_17));
    k_2 = 0u;
    loop {
        let _e115 = k_2;
        if (_e115 < 16u) {
            let _e117 = first_1;
            let _e118 = k_2;
            let _e120 = k_2;
            pixel = (_e117 + vec2<u32>((_e118 % 4u), (_e120 / 4u)));
            let _e124 = pixel;
            let _e126 = frame.size;
            if all((_e124 < vec2<u32>(_e126))) {
                let _e130 = pixel;
                let _e132 = k_2;
                let _e134 = pixels[_e132];
                let _e135 = _e134.xyz;
                let _e136 = k_2;
                let _e139 = pixels[_e136][3u];
                textureStore(picture, bitcast<vec2<i32>>(_e130), vec4<f32>(_e135.x, _e135.y, _e135.z, (1f - _e139)));
            }
            continue;
        } else {
            break;
        }
        continuing {
            let _e145 = k_2;
            k_2 = (_e145 + bitcast<u32>(1i));
        }
    }
    let _e149 = settings.count;
    let _e151 = shaded;
    if ((_e149 != 0u) && (_e151 > 0u)) {
        let _e156 = shaded;
        let _e157 = atomicAdd((&unnamed_2.control.fragments), _e156);
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn main(@builtin(local_invocation_index) gl_LocalInvocationIndex: u32, @builtin(workgroup_id) gl_WorkGroupID: vec3<u32>) {
    gl_LocalInvocationIndex_1 = gl_LocalInvocationIndex;
    gl_WorkGroupID_1 = gl_WorkGroupID;
    main_1();
}
