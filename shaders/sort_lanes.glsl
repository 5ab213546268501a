// A tile cut into one run of neighbouring entries an invocation, each with counters of its own: nothing is atomic and nearly nothing
// waits, which is what processors that run invocations one after another want.
//
// Two digits' counters share a word, 16 bits each, which hold a tile: browsers fill shared memory with zeros, and SwiftShader compiles a
// store for every word of it.
const uint DIGIT_PAIRS = SORT_DIGITS / 2u;
shared uint next[DIGIT_PAIRS * SORT_LANES];

uint word_of(uint digit, uint lane) { return (digit >> 1u) * SORT_LANES + lane; }
uint shift_of(uint digit) { return 16u * (digit & 1u); }

void count_own_run(uint lane, uint tile, uint end) {
    for (uint pair = 0u; pair < DIGIT_PAIRS; ++pair) {
        next[pair * SORT_LANES + lane] = 0u;
    }
    uint run = TILE / SORT_LANES;
    uint from = tile * TILE + lane * run;
    for (uint at = from; at < min(end, from + run); ++at) {
        uint key = key_at(at);
        if (enters(key)) {
            uint digit = digit_of(key);
            next[word_of(digit, lane)] += 1u << shift_of(digit);
        }
    }
}
