// For a kernel that makes keys: it counts them for the sort's first pass, which then need not read
// them to count.
//
// The including shader defines FIRST_COUNTS, a `uint` array in a storage buffer that it may write;
// FIRST_COUNTS_AT, the word of it at which `Sort::first_counts` starts; and FIRST_COUNTS_TILE,
// `Sort::tile()`. `Sort::clear` must have zeroed the counts before. Atomic additions have no order,
// but the sums are the same in every run. Shared memory would not help: a workgroup's lowest digits
// are nearly all different.

// `index`: of the key among the sort's keys. `visible`: whether the key is not SORT_CULLED.
void count_first_digit(uint key, bool visible, uint index) {
    if (visible) {
        uint row = index / FIRST_COUNTS_TILE * SORT_DIGITS;
        atomicAdd(FIRST_COUNTS[FIRST_COUNTS_AT + row + (key & (SORT_DIGITS - 1u))], 1u);
    }
}
