// The mean of the texels of the atlas that a pixel covers, premultiplied.
#version 450

layout(set = 0, binding = 0) uniform sampler2D atlas;
layout(push_constant) uniform Slot {
    // From a pixel of the image, times `factor`, to the first of its texels in the atlas.
    ivec2 offset;
    // Texels of the atlas in a pixel, each way.
    int factor;
};
layout(location = 0) out vec4 result;

void main() {
    ivec2 first = ivec2(gl_FragCoord.xy) * factor + offset;
    vec4 sum = vec4(0.0);
    for (int y = 0; y < factor; ++y) {
        for (int x = 0; x < factor; ++x) {
            sum += texelFetch(atlas, first + ivec2(x, y), 0);
        }
    }
    result = sum / float(factor * factor);
}
