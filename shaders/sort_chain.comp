// A pass of OneSweep: moves each entry to its place in one read, keeping the order of equal digits. Ranks come from subgroup ballots.
// From the second pass on, where a tile's entries go comes from the tiles before it (decoupled look-back): each tile tells its counts,
// and then the sum of its and all earlier ones. Tiles are numbered by an atomic ticket, so that the tiles before are at least under way.
// A device may stall them all the same: after SORT_POLLS looks the workgroup counts the digits of the tile that it waits for itself.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_ballot : require
#define THREADS SORT_SIZE
#include "sort.glsl"
#include "sort_entries.glsl"
#include "sort_sorted.glsl"
#include "sort_starts.glsl"

layout(local_size_x = THREADS) in;
// For tests: every STALL-th tile tells nothing. 0: none.
layout(constant_id = 7) const uint STALL = 0u;
// Whether loops over an invocation's entries have a length that compilers know: registers on a GPU, seconds of compiling on a CPU.
layout(constant_id = 8) const bool UNROLLED = true;
const uint ROUNDS = SORT_CHAIN_TILE / THREADS;
// Counters of a digit in the tile: a column for each subgroup, or for neighbouring ones where there are more, which then take turns.
const uint COLUMNS = 16u;
const uint WORDS = SORT_DIGITS / 2u;
// Two 16-bit counters a word.
shared uint column[COLUMNS * WORDS];
shared uint next[SORT_DIGITS];
shared uint seats, ticket, waiting;

const uint ABSENT = 0xffffu;
const uint COUNTED = 1u << 30u, SUMMED = 2u << 30u, NUMBER = COUNTED - 1u;

uint status_at(uint tile, uint digit) { return STATUS_AT + ((PASS & 1u) * TILES + tile) * SORT_DIGITS + digit; }

uint counter(uint at, uint digit) { return column[at * WORDS + digit / 2u] >> 16u * (digit & 1u) & 0xffffu; }

// Looks at the tiles before `walk`, which is 0 at the end. False: it has looked often enough.
bool look_back(uint digit, inout uint walk, inout uint before) {
    uint polls = 0u;
    while (walk > 0u) {
        uint word = atomicOr(counts[status_at(walk - 1u, digit)], 0u);
        if (word < COUNTED) {
            if (++polls >= SORT_POLLS) {
                return false;
            }
            continue;
        }
        polls = 0u;
        before += word & NUMBER;
        walk = word >= SUMMED ? 0u : walk - 1u;
    }
    return true;
}

// How many entries of the thread's own two digits earlier tiles have.
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
            start[d] = 0u;
        }
        if (thread == 0u) {
            waiting = 0u;
            atomicAdd(counts[STATE_AT + SORT_FALLBACKS], 1u);
        }
        barrier();
        for (uint at = (nearest - 1u) * TILE + thread; at < nearest * TILE; at += THREADS) {
            atomicAdd(start[digit_of(key_at(at))], 1u);
        }
        barrier();
        for (uint c = 0u; c < 2u; ++c) {
            if (walk[c] == nearest) {
                before[c] += start[2u * thread + c];
                walk[c] -= 1u;
            }
        }
        barrier();
    }
}

void tell(uint tile, uint digit, uint what) {
    if (STALL == 0u || tile % max(STALL, 1u) != STALL - 1u) {
        atomicExchange(counts[status_at(tile, digit)], what);
    }
}

// Fills start[] in a chained pass.
void chain(uint thread, uint tile, uvec2 total) {
    uint kind = tile == 0u ? SUMMED : COUNTED;
    tell(tile, 2u * thread, kind | total.x);
    tell(tile, 2u * thread + 1u, kind | total.y);
    uvec2 before = count_before(thread, tile);
    if (tile > 0u) {
        tell(tile, 2u * thread, SUMMED | before.x + total.x);
        tell(tile, 2u * thread + 1u, SUMMED | before.y + total.y);
    }
    uint row = AHEAD_AT + (PASS - 1u) * SORT_DIGITS + 2u * thread;
    uint first = counts[row];
    start[2u * thread] = before.x;
    start[2u * thread + 1u] = before.y + first;
    add_lower_digits(thread, first + counts[row + 1u]);
}

// The rank of an entry among those of its digit in its column so far; all lanes take part.
uint rank_of(bool present, uint digit, uint at) {
    // All invocations have a seat, 128 lanes in sum: 8 bits either way, but not for a CPU's compiler to see.
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
        atomicAdd(column[at * WORDS + digit / 2u], subgroupBallotBitCount(same) << 16u * (digit & 1u));
    }
    subgroupBarrier();
    return rank;
}

void main() {
    uint thread = gl_LocalInvocationID.x;
    if (WRITES != VALUES) {
        // For the next pass, which uses the other area.
        for (uint d = thread; d < SORT_DIGITS; d += THREADS) {
            counts[STATUS_AT + ((PASS + 1u & 1u) * TILES + gl_WorkGroupID.x) * SORT_DIGITS + d] = 0u;
        }
    }
    uint end = entries();
    uint tiles = tiles_of(end);
    if (gl_WorkGroupID.x >= tiles) {
        return;
    }
    if (thread == 0u) {
        ticket = FIRST ? gl_WorkGroupID.x : atomicAdd(counts[STATE_AT + PASS], 1u);
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
    // Each subgroup counts its lanes and takes a seat; the lanes of the seats before it say where its run of entries starts.
    uint lanes = subgroupBallotBitCount(subgroupBallot(true));
    uint lane = subgroupBallotExclusiveBitCount(subgroupBallot(true));
    uint seat = 0u;
    if (subgroupElect()) {
        seat = atomicAdd(seats, lanes << 16u | 1u);
    }
    seat = subgroupBroadcastFirst(seat);
    barrier();
    uint rounds = UNROLLED ? ROUNDS : TILE / (seats >> 16u);
    uint turns = ((seats & 0xffffu) + COLUMNS - 1u) / COLUMNS;
    uint turn = (seat & 0xffffu) % turns, at_column = (seat & 0xffffu) / turns;
    uint from = tile * TILE + (seat >> 16u) * ROUNDS + lane;
    // Two ranks a word: with a word each, Mali's 64 registers don't hold them all.
    uint key[ROUNDS], ranks[ROUNDS / 2u];
    for (uint r = 0u; r < rounds; ++r) {
        uint at = from + r * lanes;
        key[r] = at < end ? key_at(at) : 0u;
    }
    for (uint now = 0u; now < turns; ++now) {
        if (now == turn) {
            for (uint r = 0u; r < rounds; ++r) {
                uint rank = rank_of(from + r * lanes < end && enters(key[r]), digit_of(key[r]), at_column);
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
        find_starts(thread, tile, tiles);
    } else {
        chain(thread, tile, uvec2(total & 0xffffu, total >> 16u));
    }
    for (uint r = 0u; r < rounds; ++r) {
        uint rank = ranks[r / 2u] >> 16u * (r & 1u) & 0xffffu;
        if (rank != ABSENT) {
            uint digit = digit_of(key[r]);
            put(start[digit] + counter(at_column, digit) + rank, key[r], value_at(from + r * lanes, key[r]));
            if (WRITES != VALUES) {
                atomicAdd(next[key[r] >> SHIFT + 8u & DIGIT_MASK], 1u);
            }
        }
    }
    if (WRITES != VALUES) {
        barrier();
        for (uint d = thread; d < SORT_DIGITS; d += THREADS) {
            atomicAdd(counts[AHEAD_AT + PASS * SORT_DIGITS + d], next[d]);
        }
    }
}
