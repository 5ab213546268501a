// The picture over the background, pixel by pixel. All colours are display-referred, and so is the window's format.
#version 450
#ifdef WEB
#extension GL_EXT_samplerless_texture_functions : require
layout(set = 0, binding = 0) uniform texture2D picture;
layout(set = 0, binding = 1) uniform Background {
#else
layout(set = 0, binding = 0) uniform sampler2D picture;
layout(push_constant) uniform Background {
#endif
    vec4 background;
};
layout(location = 0) out vec4 result;

void main() {
    vec4 color = texelFetch(picture, ivec2(gl_FragCoord.xy), 0);
    result = vec4(color.rgb + (1.0 - color.a) * background.rgb, 1.0);
}
