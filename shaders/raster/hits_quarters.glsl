// Which splats of a batch meet which quarter of a region. Cheap to test, for kernels that test a
// splat in several regions: `raster` cuts each bin into four.

// A bit for each splat of the batch; a row of words a quarter.
const uint HIT_ROW = RASTER_WORKGROUP / 32u;
const uint HIT_WORDS = 4u * HIT_ROW;
shared uint batch_hits[HIT_WORDS];

// Smallest |deviation|² in a rectangle. `low` and `high`: its corners as seen from the centre, px.
float nearest(Ellipse e, vec2 low, vec2 high) {
    // On the side that faces the centre, from the left or right and from above or below.
    vec2 side = clamp(vec2(0.0), low, high);
    vec2 p = vec2(side.x, clamp(-e.b * side.x / e.c, low.y, high.y));
    vec2 q = vec2(clamp(-e.b * side.y / e.a, low.x, high.x), side.y);
    return min(e.a * p.x * p.x + 2.0 * e.b * p.x * p.y + e.c * p.y * p.y,
               e.a * q.x * q.x + 2.0 * e.b * q.x * q.y + e.c * q.y * q.y);
}

// Notes what splat `k` of the batch meets; whether it meets anything.
bool note_hits(uint k, Ellipse e) {
    bool meets = false;
    // Unrolled, it takes more registers than blending.
    [[dont_unroll]] for (uint quarter = 0u; quarter < 4u; ++quarter) {
        const float side = 0.5 * float(REGION);
        vec2 low = side * vec2(quarter & 1u, quarter >> 1u) - e.center;
        vec2 high = low + side;
        // Written so that a splat is kept where a number is NaN.
        if (!(nearest(e, low + 0.5 - MARGIN, high - 0.5 + MARGIN) > e.most)) {
            atomicOr(batch_hits[quarter * HIT_ROW + (k >> 5u)], 1u << (k & 31u));
            meets = true;
        }
    }
    return meets;
}

// The splats of the batch, from 32 `word` on, that meet the quarter of an invocation.
uint hits_of(uint thread, uint word) {
    uint quarter = thread / (RASTER_WORKGROUP / 4u);
    return batch_hits[quarter * HIT_ROW + word];
}
