// Blending where a subgroup walks its tiles' lists together: it reads a block of splats at once and
// shares those that touch its pixels. For CPU drivers whose subgroups are narrow and run in step
// (lavapipe's of 8): a splat is unpacked once a subgroup.

// The invocation's index in the workgroup, subgroup by subgroup.
uint index_in_workgroup() { return gl_SubgroupID * gl_SubgroupSize + gl_SubgroupInvocationID; }

// A splat, ready to be blended. Deviations are in standard deviations times DEVIATION_UNIT.
struct Ready {
    vec2 center;
    // Half the sides of its box, px.
    vec2 box;
    // From pixels to deviations.
    vec2 along;
    vec2 across;
    vec4 color;
    // Factor by which the change from a pixel to the next changes.
    float bend;
};

Ready prepare(uvec4 words) {
    Splat splat = unpack_splat(words);
    float inverse = 1.0 / dot(splat.axis, splat.axis);
    Ready r;
    r.center = splat.center;
    r.box = half_box(splat, radius_of(splat.opacity));
    r.along = DEVIATION_UNIT * inverse * splat.axis;
    r.across = DEVIATION_UNIT * sqrt(inverse) / splat.shorter * vec2(-splat.axis.y, splat.axis.x);
    r.color = vec4(splat.color, float(splat.opacity) / 255.0);
    r.bend = exp2(-2.0 * (r.along.x * r.along.x + r.across.x * r.across.x));
    return r;
}

// Puts a splat behind the pixels.
void blend(inout Square square, Ready splat) {
    const float half_side = 0.5 * float(SIDE - 1u);
    vec2 from = square.middle - splat.center;
    if (!(square.open && all(lessThan(abs(from), splat.box + half_side)))) {
        return;
    }
    from -= half_side;
    vec2 deviation = vec2(dot(from, splat.along), dot(from, splat.across));
    vec2 right = vec2(splat.along.x, splat.across.x);
    float most = 0.0;
    [[unroll]] for (uint y = 0u; y < SIDE; ++y) {
        // From a pixel to the next the opacity changes by a factor, which itself changes by a
        // constant one.
        float weight = exp2(-dot(deviation, deviation));
        float alpha = weight >= WEIGHT_MIN ? splat.color.a * weight : 0.0;
        float factor = exp2(min(-dot(2.0 * deviation + right, right), FACTOR_EXPONENT_MAX));
        [[unroll]] for (uint x = 0u; x < SIDE; ++x) {
            uint k = y * SIDE + x;
            float covers = min(alpha, ALPHA_MAX);
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
    square.fragments += SIDE * SIDE;
    square.open = most >= SATURATION;
}

// Blends a run's lists of all levels as one: larger keys are nearer, of equal ones larger indices.
void blend_merged(inout Square square, uvec4 lists) {
    uvec4 first = uvec4(0u);
    uvec4 keys = uvec4(0u);
    [[unroll]] for (uint level = 0u; level < TILE_LEVELS; ++level) {
        if (lists[level] != 0u) {
            first[level] = bins[BLOCKS_START + lists[level]];
            keys[level] = key_at(first[level]);
        }
    }
    while (square.open && lists != uvec4(0u)) {
        uint nearest = TILE_LEVELS;
        uint splat = 0u;
        uint key = 0u;
        [[unroll]] for (uint level = 0u; level < TILE_LEVELS; ++level) {
            bool ahead = nearest == TILE_LEVELS || keys[level] > key ||
                         (keys[level] == key && first[level] > splat);
            if (lists[level] != 0u && ahead) {
                nearest = level;
                splat = first[level];
                key = keys[level];
            }
        }
        blend(square, prepare(splats[splat]));
        [[unroll]] for (uint level = 0u; level < TILE_LEVELS; ++level) {
            if (level == nearest) {
                lists[level] = rest_of(lists[level]);
                if (lists[level] != 0u) {
                    first[level] = bins[BLOCKS_START + lists[level]];
                    keys[level] = key_at(first[level]);
                }
            }
        }
    }
}

// Blends one list. A subgroup lies in one tile: its invocations read a block together, a splat
// each, and share those that touch the subgroup's pixels. They stay together until all are done.
// Narrow subgroups read a block in parts, the nearest, which are its last, first.
void blend_list(inout Square square, uint list) {
    uint lane = gl_SubgroupInvocationID;
    vec2 low = subgroupMin(square.middle);
    vec2 high = subgroupMax(square.middle);
    vec2 center = 0.5 * (low + high);
    vec2 box = 0.5 * (high - low) + 0.5 * float(SIDE - 1u);
    while (list != 0u && subgroupAny(square.open)) {
        uint count = list & SPLATS_PER_BLOCK;
        uint block = BLOCKS_START + list - count;
        for (uint end = count + 1u; end > 0u;) {
            uint first = (end - 1u) / gl_SubgroupSize * gl_SubgroupSize;
            bool reads = first + lane < end;
            uint word = reads ? bins[block + first + lane] : 0u;
            bool mine = reads && first + lane > 0u;
            Ready splat = prepare(mine ? splats[word] : uvec4(0u));
            bool touches = mine && all(lessThan(abs(center - splat.center), splat.box + box));
            uint touching = subgroupBallot(touches).x;
            while (touching != 0u) {
                uint from = uint(findMSB(touching));
                touching ^= 1u << from;
                Ready next;
                next.center = subgroupShuffle(splat.center, from);
                next.box = subgroupShuffle(splat.box, from);
                next.along = subgroupShuffle(splat.along, from);
                next.across = subgroupShuffle(splat.across, from);
                next.color = subgroupShuffle(splat.color, from);
                next.bend = subgroupShuffle(splat.bend, from);
                blend(square, next);
            }
            end = first;
            // The block's first word links to the next.
            list = subgroupShuffle(word, 0u);
        }
    }
}

// Blends the splats of the tiles of all levels at a place. `at`: column and row of the finest tile.
void blend_tiles(inout Square square, uvec2 at) {
    uvec4 tiles;
    uint runs = 0u;
    [[unroll]] for (uint level = 0u; level < TILE_LEVELS; ++level) {
        tiles[level] = tile_index(level, level < LAST_LEVEL ? at >> 2u * level : uvec2(0u));
        runs |= bins[RUNS_START + tiles[level]];
    }
    while (runs != 0u && subgroupAny(square.open)) {
        uint run = uint(findMSB(runs));
        runs ^= 1u << run;
        uvec4 lists;
        uint all = 0u;
        bool one = true;
        [[unroll]] for (uint level = 0u; level < TILE_LEVELS; ++level) {
            lists[level] = bins[HEADS_START + tiles[level] * BINNING_RUNS + run];
            one = one && (all == 0u || lists[level] == 0u);
            all |= lists[level];
        }
        if (one) {
            blend_list(square, all);
        } else {
            blend_merged(square, lists);
        }
    }
}
