// Why Gaussians are left out, counted where a measurement asks for it, in the words behind the keys (src/vulkan/splats.rs).
layout(constant_id = 0) const bool COUNTED = false;
layout(constant_id = 1) const uint COUNTS_AT = 0u;
const uint OUTSIDE = 0u, HIDDEN = 1u, FAINT = 2u, DEGENERATE = 3u;

void left_out(uint reason) {
    if (COUNTED) {
        atomicAdd(words[COUNTS_AT + reason], 1u);
    }
}
