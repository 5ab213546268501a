// Where a tile's entries of each digit go: after all entries of lower digits, and after those of
// the same digit in earlier tiles.
//
// The including shader defines THREADS, the invocations of a workgroup; OWN, the neighbouring
// digits of each; own_end, the same as a loop's end; and own_offset() and set_own_offset(), which
// read and write the offset of an invocation's k-th digit.
shared uint sums[THREADS];
// Rows that are read at a time. With 8, Mali's 64 registers don't hold a tile's entries too.
const uint SUMMED_ROWS = 4u;
// Of each BLOCK invocations.
const uint BLOCK = THREADS < 16u ? THREADS : 16u;
shared uint block_sums[THREADS / BLOCK];

// Adds the number of entries of lower digits to the offsets. `total`: entries of an invocation's
// own digits. Gives the number of entries up to and with its own. Its barriers also order the
// offsets.
uint add_lower_digits(uint thread, uint total) {
    sums[thread] = total;
    barrier();
    if (thread < THREADS / BLOCK) {
        uint sum = 0u;
        for (uint t = 0u; t < BLOCK; ++t) {
            sum += sums[thread * BLOCK + t];
        }
        block_sums[thread] = sum;
    }
    barrier();
    uint lower = 0u;
    for (uint b = 0u; b < thread / BLOCK; ++b) {
        lower += block_sums[b];
    }
    for (uint t = thread / BLOCK * BLOCK; t < thread; ++t) {
        lower += sums[t];
    }
    for (uint c = 0u; c < own_end; ++c) {
        set_own_offset(c, own_offset(c) + lower);
    }
    barrier();
    return lower + total;
}

// Sets the offsets from rows of counts, one a tile or group, from word `at` on. In the first pass
// the first row's workgroup also writes the number of visible entries.
void sum_rows(uint thread, uint at, uint row, uint rows) {
    uint total = 0u;
    for (uint c = 0u; c < own_end; ++c) {
        uint digit = thread * OWN + c;
        uint before = 0u, after = 0u;
        for (uint first = 0u; first < rows; first += SUMMED_ROWS) {
            uint found[SUMMED_ROWS];
            for (uint r = 0u; r < SUMMED_ROWS; ++r) {
                found[r] = first + r < rows ? counts[at + (first + r) * SORT_DIGITS + digit] : 0u;
            }
            for (uint r = 0u; r < SUMMED_ROWS; ++r) {
                before += first + r < row ? found[r] : 0u;
                after += first + r < row ? 0u : found[r];
            }
        }
        set_own_offset(c, before + total);
        total += before + after;
    }
    uint all = add_lower_digits(thread, total);
    if (FIRST && row == 0u && thread == THREADS - 1u) {
        control.visible_count = all;
        control.instance_count = (all + QUADS_PER_INSTANCE - 1u) / QUADS_PER_INSTANCE;
    }
}

// Sets the offsets of a tile.
void find_offsets(uint thread, uint tile, uint tiles) {
    if (!SCANNED) {
        sum_rows(thread, 0u, tile, tiles);
        return;
    }
    for (uint c = 0u; c < own_end; ++c) {
        set_own_offset(c, counts[tile * SORT_DIGITS + thread * OWN + c]);
    }
    barrier();
}
