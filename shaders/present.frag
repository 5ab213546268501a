// The picture over the background, pixel by pixel. All colours are display-referred, and so is the window's format.
#version 450
layout(set = 0, binding = 0) uniform sampler2D picture;
layout(push_constant) uniform Pushed {
    vec4 background;
    // From a point of the window's image to the picture's, columns first: a display may be mounted another way round.
    vec4 turn;
    vec2 origin;
};
layout(location = 0) out vec4 result;

void main() {
    vec4 color = texelFetch(picture, ivec2(mat2(turn.xy, turn.zw) * gl_FragCoord.xy + origin), 0);
    result = vec4(color.rgb + (1.0 - color.a) * background.rgb, 1.0);
}
