// Why Gaussians are left out, counted where a measurement asks for it, in words of the splats' buffer (src/vulkan/splats.rs).
#ifdef WEB
#include "settings.glsl"
#define COUNTED (settings.count != 0u)
#define REASONS counts
#define COUNTS_AT 0u
#else
layout(constant_id = 1) const bool COUNTED = false;
layout(constant_id = 2) const uint COUNTS_AT = 0u;
#define REASONS words
#endif
const uint OUTSIDE = 0u, HIDDEN = 1u, FAINT = 2u, DEGENERATE = 3u;

void left_out(uint reason) {
    if (COUNTED) {
        atomicAdd(REASONS[COUNTS_AT + reason], 1u);
    }
}
