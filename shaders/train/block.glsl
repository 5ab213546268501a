// What every kernel of the training knows of a view. The mirror of effigy_train's ViewBlock.
layout(std140, set = 0, binding = 0) uniform ViewBlock {
    // Rows of world to camera.
    vec4 view_rows[3];
    // Focal length x, y; where the optical axis meets the image x, y; px.
    vec4 lens;
    // Smallest x/z, y/z and largest x/z, y/z of the perspective's derivative.
    vec4 slopes;
    // The near plane, metres.
    vec4 near;
    // What the camera multiplies the avatar's light by: exposure and white balance.
    vec4 gain;
    // Variance of the low-pass, px²; 1 where opacities are compensated; the slope of hidden layers
    // below 0.
    vec4 low_pass;
    // Weight of |difference| of one channel of a pixel; weight of a scale, and from which scale on,
    // metres; of what other losses ask.
    vec4 loss_weights;
    // Weights of |δr|, |δs|, |δc|.
    vec4 corrective_weights;
    // Gaussians, nodes, parts, head parts.
    uvec4 counts;
    // Width, height, columns and rows of tiles.
    uvec4 image_size;
    // Which view this is, how many there are, room for pairs, 1 where correctives are on.
    uvec4 batch;
    // The band of the image whose pairs are made: its first row of tiles, the first after it, 1
    // where it is the view's first band, 1 where it is the last.
    uvec4 band;
    // Numbers that enter each layer.
    uvec4 layer_inputs;
    // Numbers that leave each layer.
    uvec4 layer_outputs;
    // Where each layer's weights and biases begin in the networks' array, numbers.
    uvec4 layer_weights;
    uvec4 layer_biases;
    // Where each layer's results begin in a part's activations.
    uvec4 layer_results;
    // Activations of a part, numbers that enter a network, where the expression begins in them,
    // joints.
    uvec4 sizes;
    // Layers, 1 where the derivative of joints is asked for, where the scales' and the colours' bases begin, numbers.
    uvec4 network;
    // Rates of Adam: rotation, log scale, opacity, colour.
    vec4 rates_gaussian;
    // Rates of nodes' offsets, nodes' bases, networks; weight decay of networks.
    vec4 rates_other;
    // Rates of the bases of rotation, scale, colour.
    vec4 rates_bases;
    // β₁, β₂, ε.
    vec4 adam;
    // 1 / (1 − β₁ᵗ), 1 / (1 − β₂ᵗ) of what is learned from the start, and of what the correctives
    // are made of, which may begin later.
    vec4 adam_correction;
    // The part of the view that another loss sees: first column and row, width and height, px.
    uvec4 window;
} block;

#define GAUSSIANS block.counts.x
#define NODES block.counts.y
#define PARTS block.counts.z
#define HEAD_PARTS block.counts.w
#define VIEW block.batch.x
#define VIEWS block.batch.y
#define PAIR_CAPACITY block.batch.z
#define HAS_CORRECTIVES (block.batch.w != 0u)
#define ACTIVATIONS block.sizes.x
#define INPUTS block.sizes.y
#define EXPRESSION_START block.sizes.z
#define POSED_JOINTS block.sizes.w
#define LAYERS block.network.x
#define ASKS_JOINTS (block.network.y != 0u)
