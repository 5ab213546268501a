// Counts why Gaussians are culled, if a measurement asks for it: a word a reason, from COUNTS_AT on
// in the array COUNTS of the including shader.
PARAMETER(1, bool, COUNTED, false)
const uint OUTSIDE = 0u, AWAY = 1u, FAINT = 2u, DEGENERATE = 3u;

void count_culled(uint reason) {
    if (COUNTED) {
        atomicAdd(COUNTS[COUNTS_AT + reason], 1u);
    }
}
