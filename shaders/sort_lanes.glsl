// A tile cut into one run of neighbouring entries an invocation, each with counters of its own: nothing is atomic and nearly nothing
// waits, which is what processors that run invocations one after another want.
//
// The counters are in storage, which on a processor is as near as shared memory: browsers fill that with zeros, and SwiftShader
// compiles a store for every word of it. And the kernel that moves finds there what the one that counts has left.

// Where an invocation's counter of a digit is: each tile has a row of them, and behind them where its digits start.
uint counter(uint digit, uint lane) { return LANES_AT + gl_WorkGroupID.x * LANE_ROW + digit * SORT_LANES + lane; }

// A loop's end that compilers can't tell: they would unroll it, and llvmpipe then takes ten seconds for a kernel. `any` is any number.
uint untold(uint end, uint any) { return min(end, any | end); }

void count_own_run(uint lane, uint tile, uint end) {
    for (uint digit = 0u; digit < SORT_DIGITS; ++digit) {
        counts[counter(digit, lane)] = 0u;
    }
    uint run = TILE / SORT_LANES;
    uint from = tile * TILE + lane * run;
    for (uint at = from; at < min(end, from + run); ++at) {
        uint key = key_at(at);
        if (enters(key)) {
            counts[counter(digit_of(key), lane)] += 1u;
        }
    }
}
