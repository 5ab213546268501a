// Moves each entry to its place, keeping the order of equal digits. It needs no subgroup
// operations: in each round of SORT_WORKGROUP entries a digit's invocations mark themselves in a
// bit mask, and an invocation's rank is the number of bits before its own.
#version 450
#extension GL_GOOGLE_include_directive : require
#define THREADS SORT_WORKGROUP
#include "sort/pass.glsl"
#include "sort/entries.glsl"
#include "sort/output.glsl"
#include "sort/shared_offsets.glsl"
#include "sort/offsets.glsl"

layout(local_size_x = THREADS) in;
const uint MASKS = THREADS / 32u;
// Two sets, used in turn: one is cleared while the other is filled, which saves a barrier.
shared uint mask[2u * MASKS * SORT_DIGITS];

void main() {
    uint thread = gl_LocalInvocationID.x;
    uint tile = gl_WorkGroupID.x;
    uint end = entry_count();
    uint tiles = tiles_of(end);
    if (tile >= tiles) {
        return;
    }
    for (uint m = thread; m < 2u * MASKS * SORT_DIGITS; m += THREADS) {
        mask[m] = 0u;
    }
    find_offsets(thread, tile, tiles);
    uint own = thread / 32u;
    uint lower = (1u << (thread & 31u)) - 1u;
    uint last = min(end, (tile + 1u) * TILE);
    // Each key is read a round ahead.
    uint ahead = tile * TILE + thread < last ? key_at(tile * TILE + thread) : 0u;
    for (uint from = tile * TILE, round = 0u; from < last; from += THREADS, ++round) {
        uint at = from + thread;
        uint set = (round & 1u) * MASKS * SORT_DIGITS;
        uint key = ahead, digit = digit_of(key), rank = 0u, total = 0u;
        bool present = at < last && is_kept(key);
        if (at + THREADS < last) {
            ahead = key_at(at + THREADS);
        }
        if (present) {
            atomicOr(mask[set + own * SORT_DIGITS + digit], 1u << (thread & 31u));
        }
        barrier();
        if (present) {
            for (uint m = 0u; m < MASKS; ++m) {
                uint bits = mask[set + m * SORT_DIGITS + digit];
                total += bitCount(bits);
                rank += m < own ? bitCount(bits) : m == own ? bitCount(bits & lower) : 0u;
            }
            write_entry(offset[digit] + rank, key, value_at(at, key));
        }
        barrier();
        // A digit's first invocation advances its offset and clears its masks, before the next
        // round's barrier.
        if (present && rank == 0u) {
            offset[digit] += total;
            for (uint m = 0u; m < MASKS; ++m) {
                mask[set + m * SORT_DIGITS + digit] = 0u;
            }
        }
    }
}
