// A tile cut into one run of neighbouring entries an invocation, each with counters of its own: nothing is atomic and nearly nothing
// waits, which is what processors that run invocations one after another want.
shared uint next[SORT_DIGITS * SORT_LANES];

void count_own_run(uint lane, uint tile, uint end) {
    for (uint d = 0u; d < SORT_DIGITS; ++d) {
        next[d * SORT_LANES + lane] = 0u;
    }
    uint run = TILE / SORT_LANES;
    uint from = tile * TILE + lane * run;
    for (uint at = from; at < min(end, from + run); ++at) {
        uint key = key_at(at);
        if (enters(key)) {
            next[digit_of(key) * SORT_LANES + lane] += 1u;
        }
    }
}
