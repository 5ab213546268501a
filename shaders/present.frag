// The picture over the background, pixel by pixel, or stretched where the screen has more of them. All colours are display-referred, and so
// is the screen's format.
#version 450
#ifdef WEB
#extension GL_EXT_samplerless_texture_functions : require
// Of the canvas's size, and the right way up.
layout(set = 0, binding = 0) uniform texture2D image;
layout(set = 0, binding = 1) uniform Screen {
    vec4 background;
};
#else
layout(set = 0, binding = 0) uniform sampler2D image;
layout(push_constant) uniform Screen {
    vec4 background;
    // From a point of the screen's image to one of the screen as it is seen, columns first: a display may be mounted another way round.
    vec4 turn;
    vec2 origin;
    // Width and height, px: of the picture, in the image's upper left corner, and of the screen as it is seen.
    vec2 picture;
    vec2 screen;
};
#endif
layout(location = 0) out vec4 result;

vec4 color_here() {
#ifdef WEB
    return texelFetch(image, ivec2(gl_FragCoord.xy), 0);
#else
    vec2 seen = mat2(turn.xy, turn.zw) * gl_FragCoord.xy + origin;
    if (picture == screen) {
        return texelFetch(image, ivec2(seen), 0);
    }
    // Half a pixel from the picture's edge on, what is outside it would be mixed in.
    vec2 at = clamp(seen * picture / screen, vec2(0.5), picture - 0.5);
    return textureLod(image, at / vec2(textureSize(image, 0)), 0.0);
#endif
}

void main() {
    vec4 color = color_here();
    result = vec4(color.rgb + (1.0 - color.a) * background.rgb, 1.0);
}
