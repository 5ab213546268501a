// Premultiplied colour and coverage of a pixel, from its colour and how much of what lies behind shows.
// One that is saturated, not `open`, is filled as if what lies behind had the mean colour of what was
// blended. Left out, it would be missing by up to a step of 8 bits, and by another in the next frame.
vec4 filled(vec4 pixel, bool open) {
    float covered = 1.0 - pixel.a;
    return open ? vec4(pixel.rgb, covered) : vec4(pixel.rgb / covered, 1.0);
}
