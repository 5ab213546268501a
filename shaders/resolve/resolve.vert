// A rectangle of the image that a slot of the atlas is averaged into.
#version 450

layout(push_constant) uniform Slot {
    // First and last corner, px.
    vec4 shown;
    // Width and height of the image, px.
    vec2 size;
    // From a pixel of the image, times `factor`, to the first of its texels in the atlas.
    ivec2 offset;
    int factor;
};

void main() {
    vec2 corner = vec2(gl_VertexIndex & 1, gl_VertexIndex >> 1);
    // Two triangles: corners 0 1 2 and 2 1 3.
    if (gl_VertexIndex >= 3) {
        corner = vec2(gl_VertexIndex == 3 ? 0.0 : 1.0, gl_VertexIndex == 4 ? 0.0 : 1.0);
    }
    gl_Position = vec4(2.0 * mix(shown.xy, shown.zw, corner) / size - 1.0, 0.0, 1.0);
}
