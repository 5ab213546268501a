// The mirror of src/layout.rs: tests/layout.rs compares offsets. Macros in capitals come from there too.

struct Layer {
    uint input_quads;
    uint output_count;
    uint weight;
    uint bias;
};

layout(std140, set = 0, binding = 0) uniform FrameBlock {
    vec2 focal;
    vec2 center;
    vec2 derivative_min;
    vec2 derivative_max;
    vec2 size;
    float guard;
    float near;
    float key_far;
    float key_scale;
    uint key_max;
    float fixed_scale;
    vec4 position_min;
    vec4 position_step;
    vec4 clip;
    uint gaussians;
    uint nodes;
    uint parts;
    uint head_parts;
    uint basis_quads;
    uint feature_quads;
    uint node_feature;
    uint node_start;
    uint rotation_start;
    uint scale_start;
    uint color_start;
    float slope;
    uint layers;
    uint network_quads;
    uint key_start;
    float cutoff;
    float margin;
    uint surface_start;
    vec2 surface_origin;
    vec2 surface_scale;
    float hull_opacity;
    uint body_quads;
    Layer layer[MLP_LAYERS];
    vec4 network_input[2 * INPUT_QUADS];
    vec4 joint[3 * JOINTS];
} frame;
