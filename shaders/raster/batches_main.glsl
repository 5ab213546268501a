// The walk of batches.glsl. The including shader declares `Samples`, what an invocation knows of
// its samples, with `bool open`, whether some are not saturated; and `blend(samples, k, first)`,
// which puts splat k of the batch behind them.

// Blends all splats that meet the region at `corner`, px, near to far, until all samples are
// saturated.
void blend_bin(inout Samples samples, uvec2 corner, vec2 first) {
    uint thread = gl_LocalInvocationIndex;
    uint shift = bins[BIN_SHIFT_AT];
    uvec2 at = corner / (frame.bin_side << shift);
    uint bin = at.y * bins_of(shift).x + at.x;
    uint end = bins[STARTS_START + bin + 1u];
    for (uint from = bins[STARTS_START + bin]; from < end; from += RASTER_WORKGROUP) {
#ifdef MARKS
        batch_seen[thread] = 0u;
#endif
        for (uint k = thread; k < HIT_WORDS; k += RASTER_WORKGROUP) {
            batch_hits[k] = 0u;
        }
        if (thread == 0u) {
            batch_open = 0u;
        }
        barrier();
        if (samples.open) {
            batch_open = 1u;
        }
        uint i = from + thread < end ? bins[PAIRS_START + sorted[from + thread]] : 0u;
        if (from + thread < end) {
            load(thread, i, vec2(corner));
        }
        barrier();
        if (batch_open == 0u) {
            break;
        }
        for (uint word = 0u; word < RASTER_WORKGROUP / 32u && samples.open; ++word) {
            uint hits = hits_of(thread, word);
            while (hits != 0u && samples.open) {
                uint k = uint(findLSB(hits));
                hits &= hits - 1u;
#ifdef MARKS
                batch_seen[32u * word + k] = 1u;
#endif
                blend(samples, 32u * word + k, first);
            }
        }
        barrier();
#ifdef MARKS
        if (batch_seen[thread] != 0u) {
            atomicOr(MARK_WORD(i >> 5u), 1u << (i & 31u));
        }
#endif
    }
}
