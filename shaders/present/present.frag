// The image over a colour or a picture, pixel by pixel, or stretched if the window has more pixels.
// All colours are display-referred, and so is the window's format.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "common/platform.glsl"

layout(set = 0, binding = 0) uniform IMAGE_2D image;
#ifdef WEB
layout(set = 0, binding = 1) uniform Window {
    vec4 background;
};
#else
// As large as the window as it is seen.
layout(set = 0, binding = 1) uniform IMAGE_2D picture;
layout(push_constant) uniform Window {
    // A colour, and 1 where the picture takes its place.
    vec4 background;
    // The display's pre-transform, from a point of the swapchain's image to one of the window as it
    // is seen: a matrix, columns first, and a translation, px.
    vec4 pre_transform;
    vec2 origin;
    // Width and height, px: of the drawn part of the image, in its upper left corner, and of the
    // window as it is seen.
    vec2 image_size;
    vec2 window_size;
};
#endif
layout(location = 0) out vec4 result;

#ifdef WEB
// The image has the canvas's size and orientation.
vec4 color_here() { return texelFetch(image, ivec2(gl_FragCoord.xy), 0); }

vec3 background_here() { return background.rgb; }
#else
vec2 seen_here() { return mat2(pre_transform.xy, pre_transform.zw) * gl_FragCoord.xy + origin; }

vec4 color_here() {
    vec2 seen = seen_here();
    if (image_size == window_size) {
        return texelFetch(image, ivec2(seen), 0);
    }
    // Within half a pixel of the edge the filter would mix in what is outside the drawn part.
    vec2 at = clamp(seen * image_size / window_size, vec2(0.5), image_size - 0.5);
    return textureLod(image, at / vec2(textureSize(image, 0)), 0.0);
}

vec3 background_here() {
    if (background.a == 0.0) {
        return background.rgb;
    }
    return texelFetch(picture, ivec2(seen_here()), 0).rgb;
}
#endif

void main() {
    vec4 color = color_here();
    result = vec4(color.rgb + (1.0 - color.a) * background_here(), 1.0);
}
