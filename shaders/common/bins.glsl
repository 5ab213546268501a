// Bins: squares of the image, each with the list of splats that meet it, nearest first. The
// kernels of `binning` write them; `saturation` and the shared-memory kernel of `raster` read them.
//
// A pair is a splat and a bin that its box meets. Pairs are written in the drawing order, nearest
// first, with the bin as their key, and sorted by it; the sort is stable, so a bin's pairs stay in
// the drawing order. The side of a bin is the smallest of BIN_SIDES powers of two with which the
// pairs fit; with the largest the image is one bin. So memory is bounded and no splat is lost.
//
//   words 0 to 7   a Control: the pairs that the sort takes and leaves
//   BIN_SHIFT_AT   how often the finest side is doubled
//   COUNTS_START   pairs of each block of BIN_BLOCK splats, for each side; then, for the side that
//                  is used, where the block's pairs begin
//   STARTS_START   where each bin's pairs begin in the sorted order; one more ends the last
//   PAIRS_START    the splat of each pair
//   KEYS_START     the bin of each pair, two a word
//   MARKS_START    a bit for each splat that some region met before it was saturated
//
// On WebGPU keys and marks have buffers of their own, `pair_keys` and `marks`, which the including
// shader declares: there a kernel can't write one part of a buffer and bind another to be read,
// and a barrier must not depend on a buffer that is written.
PARAMETER(3, uint, COUNTS_START, 0u)
PARAMETER(4, uint, STARTS_START, 0u)
PARAMETER(5, uint, PAIRS_START, 0u)
PARAMETER(6, uint, KEYS_START, 0u)
PARAMETER(7, uint, MARKS_START, 0u)
// Pairs for which there is capacity.
PARAMETER(8, uint, PAIR_CAPACITY, 1u)

#ifdef WEB
#define PAIR_KEY_WORD(word) pair_keys[word]
#define MARK_WORD(word) marks[word]
#else
#define PAIR_KEY_WORD(word) bins[KEYS_START + (word)]
#define MARK_WORD(word) bins[MARKS_START + (word)]
#endif

// Members of the Control: key_count and visible_count.
const uint PAIR_COUNT_AT = 5u;
const uint SORTED_COUNT_AT = 6u;
const uint BIN_SHIFT_AT = 8u;

// Columns and rows of bins, `shift` times doubled.
uvec2 bins_of(uint shift) {
    uint side = frame.bin_side << shift;
    return (uvec2(frame.size) + side - 1u) / side;
}
