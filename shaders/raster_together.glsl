// Blending where a subgroup walks the chains together: it reads a node of splats at once and hands round those that meet its pixels. For
// processors whose subgroups are narrow and keep step (lavapipe's of 8): a splat is unpacked once a subgroup.
#define UNROLL [[unroll]]
#define EACH_PIXEL(does) \
    UNROLL for (uint k = 0u; k < SIDE * SIDE; ++k) { \
        does; \
    }

// The invocation's number, counting a subgroup's lanes in turn.
uint lane_of_group() { return gl_SubgroupID * gl_SubgroupSize + gl_SubgroupInvocationID; }

// A splat, ready to be put on pixels. Standard deviations are times √(½ log₂ e): the Gaussian is 2^−|deviation|².
struct Ready {
    vec2 center;
    vec2 reach;
    // From pixels to standard deviations.
    vec2 along;
    vec2 across;
    vec4 color;
    // By what the change from a pixel to the next changes.
    float bend;
};

Ready ready(uvec4 words) {
    Splat splat = unpack_splat(words);
    const float unit = 0.84932180;
    float inverse = 1.0 / dot(splat.axis, splat.axis);
    Ready r;
    r.center = splat.center;
    r.reach = half_box(splat, reach_of(splat.opacity));
    r.along = unit * inverse * splat.axis;
    r.across = unit * sqrt(inverse) / splat.shorter * vec2(-splat.axis.y, splat.axis.x);
    r.color = vec4(splat.color, float(splat.opacity) / 255.0);
    r.bend = exp2(-2.0 * (r.along.x * r.along.x + r.across.x * r.across.x));
    return r;
}

// Puts a splat behind what the pixels hold.
void blend(inout Square square, Ready splat) {
    const float half_side = 0.5 * float(SIDE - 1u);
    vec2 from = square.middle - splat.center;
    if (!(square.open && all(lessThan(abs(from), splat.reach + half_side)))) {
        return;
    }
    from -= half_side;
    vec2 deviation = vec2(dot(from, splat.along), dot(from, splat.across));
    vec2 right = vec2(splat.along.x, splat.across.x);
    float most = 0.0;
    UNROLL for (uint y = 0u; y < SIDE; ++y) {
        // From a pixel to the next the Gaussian changes by a factor, which itself changes by a constant one. The low-pass lets no
        // Gaussian fall faster than from its cutoff to 2^−56 over a row of four: what starts lower does not count.
        float weight = exp2(-dot(deviation, deviation));
        float alpha = weight >= 1e-17 ? splat.color.a * weight : 0.0;
        float factor = exp2(min(-dot(2.0 * deviation + right, right), 60.0));
        UNROLL for (uint x = 0u; x < SIDE; ++x) {
            uint k = y * SIDE + x;
            float covers = min(alpha, 0.99);
            vec4 pixel = square.pixels[k];
            float share = covers >= CUTOFF ? covers * pixel.a : 0.0;
            pixel = vec4(pixel.rgb + share * splat.color.rgb, pixel.a - share);
            square.pixels[k] = pixel;
            most = max(most, pixel.a);
            alpha *= factor;
            factor *= splat.bend;
        }
        deviation += vec2(splat.along.y, splat.across.y);
    }
    square.shaded += SIDE * SIDE;
    square.open = most >= FULL;
}

// Blends a block's chains of all levels as one: larger keys are nearer, of equal ones larger numbers.
void blend_merged(inout Square square, uvec4 chains) {
    uvec4 first = uvec4(0u);
    uvec4 keys = uvec4(0u);
    UNROLL for (uint level = 0u; level < BINS_LEVELS; ++level) {
        if (chains[level] != 0u) {
            first[level] = bins[BINS_NODES + chains[level]];
            keys[level] = key_at(first[level]);
        }
    }
    while (square.open && chains != uvec4(0u)) {
        uint take = BINS_LEVELS;
        uint splat = 0u;
        uint key = 0u;
        UNROLL for (uint level = 0u; level < BINS_LEVELS; ++level) {
            bool ahead = take == BINS_LEVELS || keys[level] > key || (keys[level] == key && first[level] > splat);
            if (chains[level] != 0u && ahead) {
                take = level;
                splat = first[level];
                key = keys[level];
            }
        }
        blend(square, ready(splats[splat]));
        UNROLL for (uint level = 0u; level < BINS_LEVELS; ++level) {
            if (level == take) {
                chains[level] = step_back(chains[level]);
                if (chains[level] != 0u) {
                    first[level] = bins[BINS_NODES + chains[level]];
                    keys[level] = key_at(first[level]);
                }
            }
        }
    }
}

// A subgroup lies in one tile: its invocations read a node together, a splat each, and hand round those that meet the subgroup's pixels.
// They stay together until all are done.
void blend_chain(inout Square square, uint chain) {
    uint lane = gl_SubgroupInvocationID;
    vec2 low = subgroupMin(square.middle);
    vec2 high = subgroupMax(square.middle);
    vec2 center = 0.5 * (low + high);
    vec2 box = 0.5 * (high - low) + 0.5 * float(SIDE - 1u);
    while (chain != 0u && subgroupAny(square.open)) {
        uint held = chain & BINS_HELD;
        uint word = lane < BINS_NODE ? bins[BINS_NODES + chain - held + lane] : 0u;
        bool mine = lane > 0u && lane <= held;
        Ready splat = ready(mine ? splats[word] : uvec4(0u));
        uint meets = subgroupBallot(mine && all(lessThan(abs(center - splat.center), splat.reach + box))).x;
        while (meets != 0u) {
            uint from = uint(findMSB(meets));
            meets ^= 1u << from;
            Ready next;
            next.center = subgroupShuffle(splat.center, from);
            next.reach = subgroupShuffle(splat.reach, from);
            next.along = subgroupShuffle(splat.along, from);
            next.across = subgroupShuffle(splat.across, from);
            next.color = subgroupShuffle(splat.color, from);
            next.bend = subgroupShuffle(splat.bend, from);
            blend(square, next);
        }
        chain = subgroupShuffle(word, 0u);
    }
}

// The tiles of all levels at a place, columns and rows of the finest.
void blend_tiles(inout Square square, uvec2 at) {
    uvec4 tiles;
    uint blocks = 0u;
    UNROLL for (uint level = 0u; level < BINS_LEVELS; ++level) {
        tiles[level] = bins_tile(level, level < BINS_WHOLE ? at >> 2u * level : uvec2(0u));
        blocks |= bins[BINS_MET + tiles[level]];
    }
    while (blocks != 0u && subgroupAny(square.open)) {
        uint block = uint(findMSB(blocks));
        blocks ^= 1u << block;
        uvec4 chains;
        uint all = 0u;
        bool one = true;
        UNROLL for (uint level = 0u; level < BINS_LEVELS; ++level) {
            chains[level] = bins[BINS_HEADS + tiles[level] * BINS_BLOCKS + block];
            one = one && (all == 0u || chains[level] == 0u);
            all |= chains[level];
        }
        if (one) {
            blend_chain(square, all);
        } else {
            blend_merged(square, chains);
        }
    }
}
