// The depth behind which a pixel is saturated: the furthest of the four samples around it.
#version 450

layout(set = 0, binding = 1) uniform sampler2D depths;

void main() {
    vec2 at = gl_FragCoord.xy / (2.0 * vec2(textureSize(depths, 0)));
    vec4 four = textureGather(depths, at);
    gl_FragDepth = max(max(four.x, four.y), max(four.z, four.w));
}
