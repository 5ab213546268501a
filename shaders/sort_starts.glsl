// Where a tile's entries of each digit go: after all entries of lower digits, and after those of the same digit in earlier tiles.
// THREADS is the number of invocations; each has OWN digits next to each other. START(k) is where an invocation has the start of the
// k-th of them; shared unless said otherwise before.
const uint OWN = SORT_DIGITS / THREADS;
#ifndef START
shared uint start[SORT_DIGITS];
#define START(own) start[gl_LocalInvocationID.x * OWN + own]
#define OWN_END OWN
#endif
shared uint sums[THREADS];

// Adds to START the number of entries of lower digits, from the number that each invocation's own digits have together; gives that
// number up to and with its own. Its barriers order START too.
uint add_lower_digits(uint thread, uint total) {
    sums[thread] = total;
    barrier();
    uint lower = 0u;
    for (uint t = 0u; t < thread; ++t) {
        lower += sums[t];
    }
    for (uint c = 0u; c < OWN_END; ++c) {
        START(c) += lower;
    }
    barrier();
    return lower + total;
}

// Fills START from rows of counts, one a tile. Whoever is first notes the number of survivors.
void sum_rows(uint thread, uint at, uint row, uint rows) {
    uint total = 0u;
    for (uint c = 0u; c < OWN_END; ++c) {
        uint digit = thread * OWN + c;
        uint before = 0u, after = 0u;
        for (uint r = 0u; r < row; ++r) {
            before += counts[at + r * SORT_DIGITS + digit];
        }
        for (uint r = row; r < rows; ++r) {
            after += counts[at + r * SORT_DIGITS + digit];
        }
        START(c) = before + total;
        total += before + after;
    }
    uint all = add_lower_digits(thread, total);
    if (FIRST && row == 0u && thread == THREADS - 1u) {
        control.survivors = all;
        control.instance_count = (all + RASTER_QUADS - 1u) / RASTER_QUADS;
    }
}

// Fills START for a tile.
void find_starts(uint thread, uint tile, uint tiles) {
    if (!SCANNED) {
        sum_rows(thread, 0u, tile, tiles);
        return;
    }
    for (uint c = 0u; c < OWN_END; ++c) {
        START(c) = counts[tile * SORT_DIGITS + thread * OWN + c];
    }
    barrier();
}
