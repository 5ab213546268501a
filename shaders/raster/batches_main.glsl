// The walk of batches.glsl. The including shader declares `Samples`, what an invocation knows of
// its samples, with `bool open`, whether some are not saturated; and `blend(samples, seen)`, which
// puts a splat of the batch behind them.

// The pair at a place of a bin's list that ends at `end`, and a pair's splat: the first of all
// where there is none.
const uint NO_PAIR = 0xffffffffu;
uint pair_at(uint place, uint end) { return place < end ? sorted[place] : NO_PAIR; }
uint splat_of(uint pair) { return pair != NO_PAIR ? bins[PAIRS_START + pair] : 0u; }

// Notes that an invocation that was not saturated came to splat `k` of the batch.
void note_seen(uint k) {
#ifdef MARKS
    batch_seen[k] = 1u;
#endif
}

// Blends what of 32 splats of the batch meets an invocation's part, from splat `from` on. Two are
// evaluated at a time, whether or not the second shows: a GPU with few invocations at work would
// wait for each alone.
void blend_hits(inout Samples samples, uint hits, uint from, vec2 first) {
    while (hits != 0u && samples.open) {
        uint k = from + uint(findLSB(hits));
        hits &= hits - 1u;
        bool both = hits != 0u;
        uint l = both ? from + uint(findLSB(hits)) : k;
        hits &= hits - 1u;
        Seen seen = see(k, first), second = see(l, first);
        note_seen(k);
        blend(samples, seen);
        bool shows = both && samples.open;
        if (shows) {
            note_seen(l);
        }
        second.opacity *= shows ? 1.0 : 0.0;
        blend(samples, second);
        samples.evaluated += shows ? 8u : 4u;
    }
}

// Blends all splats that meet the region at `corner`, px, near to far, until all samples are
// saturated.
void blend_bin(inout Samples samples, uvec2 corner, vec2 first) {
    uint thread = gl_LocalInvocationIndex;
    uint shift = bins[BIN_SHIFT_AT];
    uvec2 at = corner / (frame.bin_side << shift);
    uint bin = at.y * bins_of(shift).x + at.x;
    uint from = bins[STARTS_START + bin], end = bins[STARTS_START + bin + 1u];
    // A splat is found by way of its pair and its index. Each is read a batch before what it leads
    // to, while the batch before is blended. The splats too would not fit Mali's 64 registers.
    uint i = splat_of(pair_at(from + thread, end));
    uint next = splat_of(pair_at(from + GROUP + thread, end));
    uint pair = pair_at(from + 2u * GROUP + thread, end);
    for (; from < end; from += GROUP) {
#ifdef MARKS
        batch_seen[thread] = 0u;
#endif
        for (uint k = thread; k < HIT_WORDS; k += GROUP) {
            batch_hits[k] = 0u;
        }
        if (thread == 0u) {
            batch_open = 0u;
        }
        barrier();
        if (samples.open) {
            batch_open = 1u;
        }
        if (from + thread < end) {
            load(thread, i, splats[i], vec2(corner));
        }
#ifdef MARKS
        uint own = i;
#endif
        i = next;
        next = splat_of(pair);
        pair = pair_at(from + 3u * GROUP + thread, end);
        barrier();
        if (batch_open == 0u) {
            break;
        }
        for (uint word = 0u; word < GROUP / 32u && samples.open; ++word) {
            blend_hits(samples, hits_of(thread, word), 32u * word, first);
        }
        barrier();
#ifdef MARKS
        if (batch_seen[thread] != 0u) {
            atomicOr(MARK_WORD(own >> 5u), 1u << (own & 31u));
        }
#endif
    }
}
