// Where a tile's entries of each digit go: after all entries of lower digits, and after those of the same digit in earlier tiles.
// THREADS is the number of invocations; each has OWN digits next to each other.
const uint OWN = SORT_DIGITS / THREADS;
shared uint start[SORT_DIGITS];
shared uint sums[THREADS];

// Adds to start[] the number of entries of lower digits, from the number that each invocation's own digits have together; gives that
// number up to and with its own. Its barriers order start[] too.
uint add_lower_digits(uint thread, uint total) {
    sums[thread] = total;
    barrier();
    uint lower = 0u;
    for (uint t = 0u; t < thread; ++t) {
        lower += sums[t];
    }
    for (uint c = 0u; c < OWN; ++c) {
        start[thread * OWN + c] += lower;
    }
    barrier();
    return lower + total;
}

// Fills start[] from rows of counts, one a tile. Whoever is first notes the number of survivors.
void sum_rows(uint thread, uint at, uint row, uint rows) {
    uint total = 0u;
    for (uint c = 0u; c < OWN; ++c) {
        uint digit = thread * OWN + c;
        uint before = 0u, after = 0u;
        for (uint r = 0u; r < row; ++r) {
            before += counts[at + r * SORT_DIGITS + digit];
        }
        for (uint r = row; r < rows; ++r) {
            after += counts[at + r * SORT_DIGITS + digit];
        }
        start[digit] = before + total;
        total += before + after;
    }
    uint all = add_lower_digits(thread, total);
    if (FIRST && row == 0u && thread == THREADS - 1u) {
        control.survivors = all;
        control.instance_count = (all + RASTER_QUADS - 1u) / RASTER_QUADS;
    }
}

// Fills start[] for a tile.
void find_starts(uint thread, uint tile, uint tiles) {
    if (!SCANNED) {
        sum_rows(thread, 0u, tile, tiles);
        return;
    }
    for (uint d = thread; d < SORT_DIGITS; d += THREADS) {
        start[d] = counts[tile * SORT_DIGITS + d];
    }
    barrier();
}
