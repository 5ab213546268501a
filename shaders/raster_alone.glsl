// Blending where each invocation walks its chains by itself, written for devices that play lanes a few at a time on a processor,
// SwiftShader above all. There a uniform costs a hundred instructions wherever it is named, a shift by a constant and `min` as much as two
// pixels' arithmetic, an array that is asked for by a variable a walk over the lanes, and an `if` skips nothing, but costs a few
// instructions for each number that it may change. So uniforms are read once, numbers are unpacked by masks and products, pixels are
// written out and live in `main` alone, and what does not meet the pixels is put there with no opacity.

#define EACH_PIXEL(does) ROW_OF(0u, does) ROW_OF(4u, does) ROW_OF(8u, does) ROW_OF(12u, does)
#define ROW_OF(first, does) ONE(first, does) ONE(first + 1u, does) ONE(first + 2u, does) ONE(first + 3u, does)
#define ONE(number, does) \
    { \
        const uint k = number; \
        does; \
    }

uint lane_of_group() { return gl_LocalInvocationIndex; }

float larger(float a, float b) { return mix(a, b, b > a); }
float smaller(float a, float b) { return mix(a, b, b < a); }

// The f16 in the lower half of a word: its bits are moved to where f32 has them, and its exponent is that of f32 less 112.
float lower_half(uint word) {
    return uintBitsToFloat((word & 0x7fffu) * 8192u | (word & 0x8000u) * 65536u) * 5.192296858534828e33;
}

float upper_half(uint word) {
    return uintBitsToFloat((word & 0x7fffffffu) >> 3u & 0x0fffe000u | word & 0x80000000u) * 5.192296858534828e33;
}

// The bits of a mask, none of them the highest.
float number(uint word, uint mask) { return float(int(word & mask)); }

// What the uniforms say.
struct Said {
    float fixed_scale, guard, hull_opacity, cutoff, least, full;
};

// From a pixel to the next the Gaussian changes by a factor, which itself changes by a constant one. The low-pass lets no Gaussian fall
// faster than from its cutoff to 2^−56 over a row of four: what starts lower does not count.
#define PIXEL(k) \
    { \
        float covers = smaller(alpha, 0.99); \
        vec4 pixel = square.pixels[k]; \
        float share = mix(0.0, covers * pixel.a, covers >= said.least); \
        pixel = vec4(pixel.rgb + share * color, pixel.a - share); \
        square.pixels[k] = pixel; \
        most = larger(most, pixel.a); \
        alpha *= factor; \
        factor *= bend; \
    }
#define ROW(k) \
    { \
        float weight = exp2(-dot(deviation, deviation)); \
        float alpha = mix(0.0, opacity * weight, weight >= 1e-17); \
        float factor = exp2(smaller(-dot(2.0 * deviation + right, right), 60.0)); \
        PIXEL(k) PIXEL(k + 1u) PIXEL(k + 2u) PIXEL(k + 3u) \
        deviation += vec2(along.y, across.y); \
    }

// Puts a splat behind what the pixels hold. Standard deviations are times √(½ log₂ e): the Gaussian is 2^−|deviation|².
void put(inout Square square, Said said, uvec4 words) {
    const float half_side = 0.5 * float(SIDE - 1u);
    const uint place = (1u << POSITION_BITS) - 1u;
    vec2 from = square.middle - (vec2(number(words.x, place), number(words.y, place)) / said.fixed_scale - said.guard);
    vec2 axis = vec2(lower_half(words.z), upper_half(words.z));
    float shorter = lower_half(words.w);
    float opacity = number(words.w, 0xffu << 16u) / 65536.0;
    float inverse = 1.0 / dot(axis, axis);
    float reach = 2.0 * log(larger(larger(opacity, said.hull_opacity) / said.cutoff, 1.0));
    vec2 box = sqrt(reach * (axis * axis + shorter * shorter * inverse * axis.yx * axis.yx)) + half_side;
    bool meets = square.open && all(lessThan(abs(from), box));
    const float unit = 0.84932180;
    vec2 along = unit * inverse * axis;
    vec2 across = unit * sqrt(inverse) / shorter * vec2(-axis.y, axis.x);
    vec2 right = vec2(along.x, across.x);
    float bend = exp2(-2.0 * dot(right, right));
    float low = number(words.x, 1u << 30u) / float(1u << 30u) + mix(0.0, 2.0, int(words.x) < 0);
    float high = number(words.w, 0x7fu << 24u) / float(1u << 24u) + mix(0.0, 128.0, int(words.w) < 0);
    const float share_of = 1.0 / (1023.0 * float(1u << POSITION_BITS));
    vec3 color = vec3(number(words.x, 1023u << POSITION_BITS) * share_of, number(words.y, 1023u << POSITION_BITS) * share_of,
                      (4.0 * high + low) / 1023.0);
    opacity = mix(0.0, opacity / 255.0, meets);
    from -= half_side;
    vec2 deviation = vec2(dot(from, along), dot(from, across));
    float most = 0.0;
    ROW(0u) ROW(4u) ROW(8u) ROW(12u)
    square.shaded += mix(0u, SIDE * SIDE, meets);
    square.open = most >= said.full;
}

#define FIRST(level) \
    if (chains.level != 0u) { \
        first.level = bins[BINS_NODES + chains.level]; \
        keys.level = key_at(first.level); \
    }
#define NEARER(level) \
    { \
        bool ahead = mix(keys.level > key, first.level > splat, keys.level == key); \
        ahead = mix(false, mix(ahead, true, chain == 0u), chains.level != 0u); \
        chain = mix(chain, chains.level, ahead); \
        splat = mix(splat, first.level, ahead); \
        key = mix(key, keys.level, ahead); \
    }

// One loop, since a loop takes as many turns as the lane that needs most, and what no lane needs is played all the same. It tests at its
// start: SwiftShader plays on with the lanes that have left, and after a loop that tests at its end finds what it made of them since.
// `at`: column and row of the finest tile.
void blend_tiles(inout Square square, uvec2 at) {
    Said said = Said(frame.fixed_scale, frame.guard, frame.hull_opacity, frame.cutoff, CUTOFF, FULL);
    uvec4 tiles = uvec4(bins_tile(0u, at), bins_tile(1u, at >> 2u), bins_tile(2u, at >> 4u), bins_tile(BINS_WHOLE, uvec2(0u)));
    uint blocks = bins[BINS_MET + tiles.x] | bins[BINS_MET + tiles.y] | bins[BINS_MET + tiles.z] | bins[BINS_MET + tiles.w];
    // Where the block's chains are at each level, the splats that come first there, and their keys.
    uvec4 chains = uvec4(0u);
    uvec4 first = uvec4(0u);
    uvec4 keys = uvec4(0u);
    while (square.open && (blocks != 0u || chains != uvec4(0u))) {
        if (chains == uvec4(0u)) {
            uint block = uint(findMSB(blocks));
            blocks ^= 1u << block;
            chains.x = bins[BINS_HEADS + tiles.x * BINS_BLOCKS + block];
            chains.y = bins[BINS_HEADS + tiles.y * BINS_BLOCKS + block];
            chains.z = bins[BINS_HEADS + tiles.z * BINS_BLOCKS + block];
            chains.w = bins[BINS_HEADS + tiles.w * BINS_BLOCKS + block];
            FIRST(x) FIRST(y) FIRST(z) FIRST(w)
        }
        uint splat = 0u;
        uint key = 0u;
        uint chain = 0u;
        NEARER(x) NEARER(y) NEARER(z) NEARER(w)
        bvec4 take = equal(chains, uvec4(chain));
        uint rest = step_back(chain);
        uint next = rest == 0u ? 0u : bins[BINS_NODES + rest];
        uint after = rest == 0u ? 0u : key_at(next);
        chains = mix(chains, uvec4(rest), take);
        first = mix(first, uvec4(next), take);
        keys = mix(keys, uvec4(after), take);
        put(square, said, splats[splat]);
    }
}
