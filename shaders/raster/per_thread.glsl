// Blending where each invocation walks its tiles' lists by itself.
//
// It is written for CPU drivers that execute a few invocations at a time, SwiftShader above all;
// GPUs have another (raster/shared.glsl). On SwiftShader each use of a uniform costs a hundred
// instructions; a shift by a constant and `min` cost as much as the arithmetic of two pixels; an
// array indexed by a variable is read invocation by invocation; and an `if` skips nothing, but
// costs a few instructions for each number that it may change. So uniforms are read once, numbers
// are unpacked by masks and products, pixels are indexed by constants, and a splat that does not
// touch the pixels is blended with opacity 0.

uint index_in_workgroup() { return gl_LocalInvocationIndex; }

float larger(float a, float b) { return mix(a, b, b > a); }
float smaller(float a, float b) { return mix(a, b, b < a); }

// The f16 in the lower or upper half of a word: its bits are moved to where f32 has them, and the
// product with 2^112 corrects the exponent.
const float HALF_SCALE = 5.192296858534828e33;

float lower_half(uint word) {
    return uintBitsToFloat((word & 0x7fffu) * 8192u | (word & 0x8000u) * 65536u) * HALF_SCALE;
}

float upper_half(uint word) {
    uint shifted = (word & 0x7fffffffu) >> 3u & 0x0fffe000u;
    return uintBitsToFloat(shifted | word & 0x80000000u) * HALF_SCALE;
}

// The bits of a mask as a number. The mask must not have the highest bit.
float masked(uint word, uint mask) { return float(int(word & mask)); }

// The uniforms that blending needs, read once.
struct Uniforms {
    float fixed_scale;
    float guard;
    float quad_opacity;
    // Of 255.
    float cutoff;
    // Of 1.
    float alpha_min;
    float saturation;
};

// A splat along a row. From a pixel to the next its opacity changes by a factor, which itself
// changes by a constant one.
struct Row {
    float alpha;
    float factor;
    float bend;
    vec3 color;
};

// Puts the splat behind a pixel and moves on to the next. `most`: the largest share of what lies
// behind that shows at a pixel so far.
void blend_pixel(inout vec4 pixel, inout Row row, inout float most, float alpha_min) {
    float covers = smaller(row.alpha, ALPHA_MAX);
    float share = mix(0.0, covers * pixel.a, covers >= alpha_min);
    pixel = vec4(pixel.rgb + share * row.color, pixel.a - share);
    most = larger(most, pixel.a);
    row.alpha *= row.factor;
    row.factor *= row.bend;
}

// A splat over the square. Deviations are in standard deviations times DEVIATION_UNIT.
struct Footprint {
    // Of the first pixel of a row.
    vec2 deviation;
    // From a pixel to the next, and from a row to the next.
    vec2 right;
    vec2 down;
    float bend;
    float opacity;
    vec3 color;
};

// Puts the splat behind a row of four pixels and moves on to the next row.
void blend_row(inout vec4 a, inout vec4 b, inout vec4 c, inout vec4 d, inout Footprint splat,
               inout float most, float alpha_min) {
    float weight = exp2(-dot(splat.deviation, splat.deviation));
    Row row;
    row.alpha = mix(0.0, splat.opacity * weight, weight >= WEIGHT_MIN);
    row.factor = exp2(smaller(-dot(2.0 * splat.deviation + splat.right, splat.right),
                              FACTOR_EXPONENT_MAX));
    row.bend = splat.bend;
    row.color = splat.color;
    blend_pixel(a, row, most, alpha_min);
    blend_pixel(b, row, most, alpha_min);
    blend_pixel(c, row, most, alpha_min);
    blend_pixel(d, row, most, alpha_min);
    splat.deviation += splat.down;
}

// Puts a splat behind the pixels.
void blend(inout Square square, Uniforms uniforms, uvec4 words) {
    const float half_side = 0.5 * float(SIDE - 1u);
    const uint position = (1u << POSITION_BITS) - 1u;
    // coarseness_of(words); the highest bit is that of a sign.
    const float finer = float(1u << CENTER_GRID_BITS);
    float coarseness = (1.0 + (finer - 1.0) / float(1u << 30u) * masked(words.y, 1u << 30u)) *
                       mix(1.0, finer * finer, int(words.y) < 0);
    vec2 from = square.middle - coarseness * (vec2(masked(words.x, position),
                                                   masked(words.y, position)) /
                                                  uniforms.fixed_scale - uniforms.guard);
    vec2 axis = vec2(lower_half(words.z), upper_half(words.z));
    float shorter = lower_half(words.w);
    float opacity = masked(words.w, 0xffu << 16u) / 65536.0;
    float inverse = 1.0 / dot(axis, axis);
    float radius_squared =
        2.0 * log(larger(larger(opacity, uniforms.quad_opacity) / uniforms.cutoff, 1.0));
    vec2 box = sqrt(radius_squared *
                    (axis * axis + shorter * shorter * inverse * axis.yx * axis.yx));
    bool touches = square.open && all(lessThan(abs(from), box + half_side));
    vec2 along = DEVIATION_UNIT * inverse * axis;
    vec2 across = DEVIATION_UNIT * sqrt(inverse) / shorter * vec2(-axis.y, axis.x);
    Footprint splat;
    splat.right = vec2(along.x, across.x);
    splat.down = vec2(along.y, across.y);
    splat.bend = exp2(-2.0 * dot(splat.right, splat.right));
    // The highest bits of words x and w are those of a sign.
    float low = masked(words.x, 1u << 30u) / float(1u << 30u) + mix(0.0, 2.0, int(words.x) < 0);
    float high =
        masked(words.w, 0x7fu << 24u) / float(1u << 24u) + mix(0.0, 128.0, int(words.w) < 0);
    const float channel = 1.0 / (1023.0 * float(1u << POSITION_BITS));
    splat.color = vec3(masked(words.x, 1023u << POSITION_BITS) * channel,
                       masked(words.y, 1023u << POSITION_BITS) * channel,
                       (4.0 * high + low) / 1023.0);
    splat.opacity = mix(0.0, opacity / 255.0, touches);
    from -= half_side;
    splat.deviation = vec2(dot(from, along), dot(from, across));
    float most = 0.0;
    blend_row(square.pixels[0], square.pixels[1], square.pixels[2], square.pixels[3],
              splat, most, uniforms.alpha_min);
    blend_row(square.pixels[4], square.pixels[5], square.pixels[6], square.pixels[7],
              splat, most, uniforms.alpha_min);
    blend_row(square.pixels[8], square.pixels[9], square.pixels[10], square.pixels[11],
              splat, most, uniforms.alpha_min);
    blend_row(square.pixels[12], square.pixels[13], square.pixels[14], square.pixels[15],
              splat, most, uniforms.alpha_min);
    square.fragments += mix(0u, SIDE * SIDE, touches);
    square.open = most >= uniforms.saturation;
}

// Reads the first splat of a list and its key.
void read_first(uint list, inout uint first, inout uint key) {
    if (list != 0u) {
        first = bins[BLOCKS_START + list];
        key = key_at(first);
    }
}

// Takes a list if its first splat is nearer than the nearest so far: larger keys are nearer, of
// equal ones larger indices. An empty list is never taken; `nearest` is 0 if there is none yet.
void take_nearer(uint list, uint list_first, uint list_key, inout uint nearest, inout uint splat,
                 inout uint key) {
    bool ahead = mix(list_key > key, list_first > splat, list_key == key);
    ahead = mix(false, mix(ahead, true, nearest == 0u), list != 0u);
    nearest = mix(nearest, list, ahead);
    splat = mix(splat, list_first, ahead);
    key = mix(key, list_key, ahead);
}

// Blends the splats of the tiles of all levels at a place. `at`: column and row of the finest tile.
//
// It is one loop, since a loop takes as many rounds as the slowest invocation needs, and CPU
// drivers execute code that no invocation needs. It tests at its start: SwiftShader goes on
// executing invocations that have left, and after a loop that tests at its end would use what they
// wrote since.
void blend_tiles(inout Square square, uvec2 at) {
    Uniforms uniforms = Uniforms(frame.fixed_scale, frame.guard, frame.quad_opacity, frame.cutoff,
                                 CUTOFF, SATURATION);
    uvec4 tiles = uvec4(tile_index(0u, at), tile_index(1u, at >> 2u), tile_index(2u, at >> 4u),
                        tile_index(LAST_LEVEL, uvec2(0u)));
    uint runs = bins[RUNS_START + tiles.x] | bins[RUNS_START + tiles.y] |
                bins[RUNS_START + tiles.z] | bins[RUNS_START + tiles.w];
    // The run's list at each level, its first splat, and that splat's key.
    uvec4 lists = uvec4(0u);
    uvec4 first = uvec4(0u);
    uvec4 keys = uvec4(0u);
    while (square.open && (runs != 0u || lists != uvec4(0u))) {
        if (lists == uvec4(0u)) {
            uint run = uint(findMSB(runs));
            runs ^= 1u << run;
            lists.x = bins[HEADS_START + tiles.x * BINNING_RUNS + run];
            lists.y = bins[HEADS_START + tiles.y * BINNING_RUNS + run];
            lists.z = bins[HEADS_START + tiles.z * BINNING_RUNS + run];
            lists.w = bins[HEADS_START + tiles.w * BINNING_RUNS + run];
            read_first(lists.x, first.x, keys.x);
            read_first(lists.y, first.y, keys.y);
            read_first(lists.z, first.z, keys.z);
            read_first(lists.w, first.w, keys.w);
        }
        uint splat = 0u;
        uint key = 0u;
        uint list = 0u;
        take_nearer(lists.x, first.x, keys.x, list, splat, key);
        take_nearer(lists.y, first.y, keys.y, list, splat, key);
        take_nearer(lists.z, first.z, keys.z, list, splat, key);
        take_nearer(lists.w, first.w, keys.w, list, splat, key);
        bvec4 taken = equal(lists, uvec4(list));
        uint rest = rest_of(list);
        uint next = rest == 0u ? 0u : bins[BLOCKS_START + rest];
        uint next_key = rest == 0u ? 0u : key_at(next);
        lists = mix(lists, uvec4(rest), taken);
        first = mix(first, uvec4(next), taken);
        keys = mix(keys, uvec4(next_key), taken);
        blend(square, uniforms, splats[splat]);
    }
}
