// A pass of OneSweep: moves each entry to its place in one read, keeping the order of equal digits.
// Ranks come from subgroup ballots. From the second pass on, the offsets come from the tiles before
// (decoupled look-back): each tile publishes its counts, and then the sums of its and all earlier
// ones. An atomic ticket numbers the tiles, so that the earlier ones have at least started. A
// device may stall them all the same: after SORT_POLLS rounds of reads that find nothing new a
// workgroup counts the tile that it waits for itself.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_ballot : require
#define THREADS SORT_WORKGROUP
#define POLLED_COUNTS
#include "sort/pass.glsl"
#include "sort/entries.glsl"
#include "sort/output.glsl"
#include "sort/shared_offsets.glsl"
#include "sort/offsets.glsl"

layout(local_size_x = THREADS) in;
// For tests: every STALL-th tile publishes nothing. 0: none.
PARAMETER(7, uint, STALL, 0u)
// Whether loops over an invocation's entries have a length that compilers know: it saves registers
// on a GPU and costs seconds of compiling on a CPU.
PARAMETER(8, bool, UNROLLED, true)
// Earlier tiles whose counts are read at a time.
PARAMETER(10, uint, LOOK, 8u)
const uint ROUNDS = SORT_ONESWEEP_TILE / THREADS;
// Counters of a digit in the tile: a column for each subgroup. If there are more subgroups,
// neighbours share a column and take turns.
const uint COLUMNS = 16u;
const uint WORDS = SORT_DIGITS / 2u;
// Two 16-bit counters a word.
shared uint column[COLUMNS * WORDS];
// How often each digit of the next pass occurs.
shared uint next[SORT_DIGITS];
// Subgroups that have taken a seat, and above 16 bits their invocations.
shared uint seats;
shared uint ticket, waiting;

const uint ABSENT = 0xffffu;
const uint COUNTED = 1u << 30u, SUMMED = 2u << 30u, NUMBER = COUNTED - 1u;

uint status_at(uint tile, uint digit) {
    return STATUS_START + ((PASS & 1u) * TILES + tile) * SORT_DIGITS + digit;
}

uint counter(uint at, uint digit) {
    return column[at * WORDS + digit / 2u] >> 16u * (digit & 1u) & 0xffffu;
}

// Adds the counts of the tiles before `walk`, and moves it down to 0. False if it polled too often.
// It reads several tiles at a time: tiles that began together have counts and no sums yet, and a
// walk that reads one after another waits for memory once a tile. A word has both the count and
// whether it is there, so that reads that are not atomic do; atomic ones cost a GPU's caches far
// more.
bool look_back(uint digit, inout uint walk, inout uint before) {
    uint polls = 0u;
    while (walk > 0u) {
        uint words[LOOK];
        for (uint w = 0u; w < LOOK; ++w) {
            words[w] = w < walk ? counts[status_at(walk - 1u - w, digit)] : 0u;
        }
        uint from = walk;
        for (uint w = 0u; w < LOOK; ++w) {
            if (words[w] < COUNTED) {
                break;
            }
            before += words[w] & NUMBER;
            walk = words[w] >= SUMMED ? 0u : walk - 1u;
            if (walk == 0u) {
                break;
            }
        }
        polls = walk == from ? polls + 1u : 0u;
        if (polls >= SORT_POLLS) {
            return false;
        }
    }
    return true;
}

// How many entries of the invocation's own two digits earlier tiles have.
uvec2 count_before(uint thread, uint tile) {
    uvec2 walk = uvec2(tile), before = uvec2(0u);
    for (;;) {
        look_back(2u * thread, walk.x, before.x);
        look_back(2u * thread + 1u, walk.y, before.y);
        atomicMax(waiting, max(walk.x, walk.y));
        barrier();
        uint nearest = waiting;
        barrier();
        if (nearest == 0u) {
            return before;
        }
        for (uint d = thread; d < SORT_DIGITS; d += THREADS) {
            offset[d] = 0u;
        }
        if (thread == 0u) {
            waiting = 0u;
            atomicAdd(counts[STATE_START + SORT_FALLBACKS], 1u);
        }
        barrier();
        for (uint at = (nearest - 1u) * TILE + thread; at < nearest * TILE; at += THREADS) {
            atomicAdd(offset[digit_of(key_at(at))], 1u);
        }
        barrier();
        for (uint c = 0u; c < 2u; ++c) {
            if (walk[c] == nearest) {
                before[c] += offset[2u * thread + c];
                walk[c] -= 1u;
            }
        }
        barrier();
    }
}

void publish(uint tile, uint digit, uint status) {
    if (STALL == 0u || tile % max(STALL, 1u) != STALL - 1u) {
        atomicExchange(counts[status_at(tile, digit)], status);
    }
}

// Sets the offsets in a pass after the first. `total`: the tile's entries of the invocation's own
// digits.
void look_up_offsets(uint thread, uint tile, uvec2 total) {
    uint kind = tile == 0u ? SUMMED : COUNTED;
    publish(tile, 2u * thread, kind | total.x);
    publish(tile, 2u * thread + 1u, kind | total.y);
    uvec2 before = count_before(thread, tile);
    if (tile > 0u) {
        publish(tile, 2u * thread, SUMMED | before.x + total.x);
        publish(tile, 2u * thread + 1u, SUMMED | before.y + total.y);
    }
    uint row = HISTOGRAMS_START + (PASS - 1u) * SORT_DIGITS + 2u * thread;
    uint first = counts[row];
    offset[2u * thread] = before.x;
    offset[2u * thread + 1u] = before.y + first;
    add_lower_digits(thread, first + counts[row + 1u]);
}

// The rank of an entry among those of its digit in its column so far. All invocations of the
// subgroup must call it.
uint rank_of(bool present, uint digit, uint at) {
    // All 128 invocations have a seat, so this is 8 either way; a CPU's compiler must not know.
    uint digit_bits = UNROLLED ? 8u : seats >> 20u;
    uvec4 same = subgroupBallot(present);
    for (uint b = 0u; b < digit_bits; ++b) {
        bool bit = (digit >> b & 1u) != 0u;
        uvec4 set = subgroupBallot(bit);
        same &= bit ? set : ~set;
    }
    uint rank = present ? counter(at, digit) + subgroupBallotExclusiveBitCount(same) : ABSENT;
    subgroupBarrier();
    if (present && subgroupBallotExclusiveBitCount(same) == 0u) {
        uint count = subgroupBallotBitCount(same) << 16u * (digit & 1u);
        atomicAdd(column[at * WORDS + digit / 2u], count);
    }
    subgroupBarrier();
    return rank;
}

void main() {
    uint thread = gl_LocalInvocationID.x;
    if (WRITES != VALUES) {
        // For the next pass, which uses the other area.
        uint row = STATUS_START + ((PASS + 1u & 1u) * TILES + gl_WorkGroupID.x) * SORT_DIGITS;
        for (uint d = thread; d < SORT_DIGITS; d += THREADS) {
            counts[row + d] = 0u;
        }
    }
    uint end = entry_count();
    uint tiles = tiles_of(end);
    if (gl_WorkGroupID.x >= tiles) {
        return;
    }
    if (thread == 0u) {
        ticket = FIRST ? gl_WorkGroupID.x : atomicAdd(counts[STATE_START + PASS], 1u);
        seats = 0u;
        waiting = 0u;
    }
    for (uint w = thread; w < COLUMNS * WORDS; w += THREADS) {
        column[w] = 0u;
    }
    for (uint d = thread; d < SORT_DIGITS; d += THREADS) {
        next[d] = 0u;
    }
    barrier();
    uint tile = ticket;
    // Each subgroup counts its invocations and takes a seat. Its run of entries starts after those
    // of the invocations in earlier seats.
    uint width = subgroupBallotBitCount(subgroupBallot(true));
    uint lane = subgroupBallotExclusiveBitCount(subgroupBallot(true));
    uint seat = 0u;
    if (subgroupElect()) {
        seat = atomicAdd(seats, width << 16u | 1u);
    }
    seat = subgroupBroadcastFirst(seat);
    barrier();
    uint rounds = UNROLLED ? ROUNDS : TILE / (seats >> 16u);
    // Subgroups that share a column, which of them this one is, and the column.
    uint sharers = ((seats & 0xffffu) + COLUMNS - 1u) / COLUMNS;
    uint own_round = (seat & 0xffffu) % sharers, own_column = (seat & 0xffffu) / sharers;
    uint from = tile * TILE + (seat >> 16u) * ROUNDS + lane;
    // Two ranks a word: with a word each, Mali's 64 registers don't hold them all.
    uint key[ROUNDS], ranks[ROUNDS / 2u];
    for (uint r = 0u; r < rounds; ++r) {
        uint at = from + r * width;
        key[r] = at < end ? key_at(at) : 0u;
    }
    for (uint sharer = 0u; sharer < sharers; ++sharer) {
        if (sharer == own_round) {
            for (uint r = 0u; r < rounds; ++r) {
                bool present = from + r * width < end && is_kept(key[r]);
                uint rank = rank_of(present, digit_of(key[r]), own_column);
                ranks[r / 2u] = (r & 1u) == 0u ? rank : ranks[r / 2u] | rank << 16u;
            }
        }
        barrier();
    }
    // Each column's counts become the counts of the columns before it.
    uint total = 0u;
    for (uint c = 0u; c < COLUMNS; ++c) {
        uint count = column[c * WORDS + thread];
        column[c * WORDS + thread] = total;
        total += count;
    }
    if (FIRST) {
        find_offsets(thread, tile, tiles);
    } else {
        look_up_offsets(thread, tile, uvec2(total & 0xffffu, total >> 16u));
    }
    for (uint r = 0u; r < rounds; ++r) {
        uint rank = ranks[r / 2u] >> 16u * (r & 1u) & 0xffffu;
        if (rank != ABSENT) {
            uint digit = digit_of(key[r]);
            uint place = offset[digit] + counter(own_column, digit) + rank;
            write_entry(place, key[r], value_at(from + r * width, key[r]));
            if (WRITES != VALUES) {
                atomicAdd(next[later_bits(key[r]) & DIGIT_MASK], 1u);
            }
        }
    }
    if (WRITES != VALUES) {
        barrier();
        for (uint d = thread; d < SORT_DIGITS; d += THREADS) {
            atomicAdd(counts[HISTOGRAMS_START + PASS * SORT_DIGITS + d], next[d]);
        }
    }
}
