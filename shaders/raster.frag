// A fragment of a splat (model.md, step 10): its colour and opacity, which the blender puts "over" what lies behind.
#version 450
layout(early_fragment_tests) in;
// Opacity under which nothing is drawn.
layout(constant_id = 0) const float CUTOFF = 1.0 / 255.0;
layout(location = 0) in vec2 offset;
layout(location = 1) flat in vec4 color;
layout(location = 0) out vec4 result;

void main() {
    float alpha = min(0.99, color.a * exp(-0.5 * dot(offset, offset)));
    if (!(alpha >= CUTOFF)) {
        discard;
    }
    result = vec4(color.rgb, alpha);
}
