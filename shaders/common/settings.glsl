// The mirror of layout::Settings: parameters of WebGPU's shaders, since WGSL translated from SPIR-V
// cannot have specialization constants.
layout(std140, set = 0, binding = 7) uniform SettingsBlock {
    float cutoff_exponent;
    float quad_exponent;
    float cutoff;
    float saturation;
    uint sort_tiles;
    uint key_capacity;
    uint scanned;
    uint key_count;
    uint counted;
    uint unused;
    uvec2 first_region;
    uint counts_start;
    uint starts_start;
    uint pairs_start;
    uint pair_capacity;
} settings;

#define CUTOFF_EXPONENT settings.cutoff_exponent
#define QUAD_EXPONENT settings.quad_exponent
#define CUTOFF settings.cutoff
#define SATURATION settings.saturation
#define TILES settings.sort_tiles
#define CAPACITY settings.key_capacity
#define SCANNED (settings.scanned != 0u)
#define KEY_COUNT settings.key_count
#define COUNTED (settings.counted != 0u)
#define FIRST_REGION settings.first_region
#define COUNTS_START settings.counts_start
#define STARTS_START settings.starts_start
#define PAIRS_START settings.pairs_start
#define PAIR_CAPACITY settings.pair_capacity
