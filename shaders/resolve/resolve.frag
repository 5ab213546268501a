// The mean of the texels of the atlas that a pixel covers, premultiplied.
#version 450

layout(set = 0, binding = 0) uniform sampler2D atlas;
layout(push_constant) uniform Slot {
    vec4 shown;
    vec2 size;
    ivec2 offset;
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
