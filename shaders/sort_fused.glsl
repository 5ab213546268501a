// For a kernel that makes keys and counts them for the sort, which then need not read them to count.
//
// The including shader defines SORT_FIRST_COUNTS, a `uint` array in a storage buffer that it may write; SORT_FIRST_AT, where in that
// array `Sort::first_counts` lies, in words; and SORT_FIRST_TILE, `Sort::tile()`. `Sort::clear` must have zeroed the counts before.
// Adding is in no order, but sums don't depend on it, so the counts are the same in every run. Shared memory would not help: a
// workgroup's lowest digits are nearly all different.

// `index` is where the key stands in `Sort`'s keys; `alive` is whether it is not SORT_DROPPED.
void sort_count_first(uint key, bool alive, uint index) {
    if (alive) {
        atomicAdd(SORT_FIRST_COUNTS[SORT_FIRST_AT + index / SORT_FIRST_TILE * SORT_DIGITS + (key & (SORT_DIGITS - 1u))], 1u);
    }
}
