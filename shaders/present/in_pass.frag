// The image over a colour or a picture, in the render pass that draws it: pixel by pixel, where
// nothing is turned or stretched.
#version 450

layout(input_attachment_index = 0, set = 0, binding = 0) uniform subpassInput image;
// As large as the window.
layout(set = 0, binding = 1) uniform sampler2D picture;
layout(push_constant) uniform Window {
    // A colour, and 1 where the picture takes its place.
    vec4 background;
};
layout(location = 0) out vec4 result;

void main() {
    vec4 color = subpassLoad(image);
    vec3 behind = background.rgb;
    if (background.a != 0.0) {
        behind = texelFetch(picture, ivec2(gl_FragCoord.xy), 0).rgb;
    }
    result = vec4(color.rgb + (1.0 - color.a) * behind, 1.0);
}
