// Which splats of a batch meet which part of a region. A region has 8 by 8 parts, of one invocation
// or of 2 by 2, so that each walks few splats but its own.

// Of each row of parts a byte a splat, a bit a part. Splats k, k + 8, k + 16 and k + 24 share a
// word, so that the bits of 32 splats for a part are those of 8 words, masked and shifted (hits_of).
const uint SIDE = 8u;
// Invocations per side of a part.
const uint PART = REGION / (2u * STEP * SIDE);
const uint HIT_ROW = GROUP / 4u;
const uint HIT_WORDS = SIDE * HIT_ROW;
shared uint batch_hits[HIT_WORDS];

// The first of SIDE intervals of a length whose pixels are met by what reaches from `low` to
// `high`, px, and one past the last. Written so that all are where a number is NaN.
uvec2 intervals(float low, float high, float side) {
    float first = (low + 0.5) / side - 1.0;
    float last = (high - 0.5) / side;
    return uvec2(first > 0.0 ? uint(ceil(min(first, float(SIDE)))) : 0u,
                 last < float(SIDE) ? uint(floor(max(last, -1.0)) + 1.0) : SIDE);
}

// Notes what splat `k` of the batch meets; whether it meets anything.
bool note_hits(uint k, Ellipse e) {
    const float side = float(REGION / SIDE);
    // How far below the centre the ellipse reaches furthest to the right; to the left it is above.
    float turn = -e.b * sqrt(e.most / (e.c * e.determinant));
    float height = sqrt(e.a * e.most / e.determinant);
    uvec2 rows = intervals(e.center.y - height, e.center.y + height, side);
    uint place = (k >> 5u) * 8u + (k & 7u);
    bool meets = false;
    // Unrolled, it takes more registers than blending.
    [[dont_unroll]] for (uint row = rows.x; row < rows.y; ++row) {
        // The row's pixels, seen from the centre, and where in it the ellipse is widest.
        float top = side * float(row) + 0.5 - e.center.y;
        float bottom = top + side - 1.0;
        vec2 at = vec2(clamp(-turn, top, bottom), clamp(turn, top, bottom));
        vec2 squared = e.a * e.most - e.determinant * at * at;
        vec2 reach = sqrt(max(squared, 0.0));
        vec2 ends = (-e.b * at + vec2(-reach.x, reach.y)) / e.a + e.center.x;
        uvec2 met = intervals(ends.x, ends.y, side);
        if (met.x < met.y && !(max(squared.x, squared.y) < 0.0)) {
            uint bits = (1u << met.y) - (1u << met.x);
            atomicOr(batch_hits[row * HIT_ROW + place], bits << (k & 24u));
            meets = true;
        }
    }
    return meets;
}

// The splats of the batch, from 32 `word` on, that meet the part of an invocation.
uint hits_of(uint thread, uint word) {
    uvec2 place = place_of(thread) / PART;
    uint hits = 0u;
    for (uint k = 0u; k < 8u; ++k) {
        uint bits = batch_hits[place.y * HIT_ROW + 8u * word + k];
        hits |= (bits >> place.x & 0x01010101u) << k;
    }
    return hits;
}
