// The mirror of layout::Settings: what Vulkan takes as specialization constants and WebGPU, from SPIR-V, can't.
layout(std140, set = 0, binding = 7) uniform SettingsBlock {
    float least;
    float hull;
    float cutoff;
    float full;
    uint tiles;
    uint capacity;
    uint scanned;
    uint entering;
    uint nodes;
    uint count;
    uvec2 first_region;
} settings;
