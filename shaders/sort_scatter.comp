// Third kernel of a sort pass: moves each entry to its place, keeping the order of equal digits. Needs no subgroup operations: in each
// round of SORT_SIZE entries a digit's threads mark themselves in a bit mask, and a thread's rank is the number of bits before its own.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "sort.glsl"

layout(std430, set = 0, binding = 1) readonly buffer Entries { uint entry[]; };
layout(std430, set = 0, binding = 2) readonly buffer Histograms { uint histogram[]; };
layout(std430, set = 0, binding = 3) readonly buffer ControlBuffer { Control control; };
// Keys and values in turn; after the last pass values alone.
layout(std430, set = 0, binding = 4) writeonly buffer Sorted { uint sorted[]; };
layout(constant_id = 3) const bool LAST = false;

const uint MASKS = SORT_SIZE / 32u;
shared uint mask[MASKS * SORT_DIGITS];
// Where the next entry of each digit goes.
shared uint next[SORT_DIGITS];

void main() {
    uint thread = gl_LocalInvocationID.x;
    uint tile = gl_WorkGroupID.x;
    for (uint d = thread; d < SORT_DIGITS; d += SORT_SIZE) {
        next[d] = histogram[d * gl_NumWorkGroups.x + tile];
        for (uint m = 0u; m < MASKS; ++m) {
            mask[m * SORT_DIGITS + d] = 0u;
        }
    }
    barrier();
    uint end = ENTRIES;
    for (uint round = 0u; round < SORT_ROUNDS; ++round) {
        uint at = tile * SORT_TILE + round * SORT_SIZE + thread;
        uint key = 0u, value = 0u, digit = 0u;
        bool present = at < end;
        if (present) {
            key = FIRST ? entry[at] : entry[2u * at];
            value = FIRST ? at : entry[2u * at + 1u];
            present = !FIRST || key != SORT_DROPPED;
            digit = digit_of(key);
        }
        uint own = thread / 32u;
        if (present) {
            atomicOr(mask[own * SORT_DIGITS + digit], 1u << (thread & 31u));
        }
        barrier();
        uint rank = 0u, total = 0u, place = 0u;
        if (present) {
            for (uint m = 0u; m < MASKS; ++m) {
                uint bits = mask[m * SORT_DIGITS + digit];
                total += bitCount(bits);
                if (m < own) {
                    rank += bitCount(bits);
                } else if (m == own) {
                    rank += bitCount(bits & ((1u << (thread & 31u)) - 1u));
                }
            }
            place = next[digit] + rank;
        }
        barrier();
        if (present) {
            // The first thread of a digit moves its counter on and clears its masks for the next round.
            if (rank == 0u) {
                next[digit] += total;
                for (uint m = 0u; m < MASKS; ++m) {
                    mask[m * SORT_DIGITS + digit] = 0u;
                }
            }
            if (LAST) {
                sorted[place] = value;
            } else {
                sorted[2u * place] = key;
                sorted[2u * place + 1u] = value;
            }
        }
        barrier();
    }
}
