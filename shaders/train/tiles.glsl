// Which tiles a splat meets: those that the box around its ellipse meets. A stage's blocks have
// TRAIN_BLOCK splats, in drawing order, nearest first.
layout(constant_id = 0) const uint TILE = 8u;

struct Box {
    uvec2 low;
    uvec2 high;
};

// First and last column and row of tiles. The splat's box meets the image.
Box tiles_of(vec4 center_radius) {
    vec2 last = vec2(block.image_size.zw) - 1.0;
    vec2 low = floor((center_radius.xy - center_radius.zw) / float(TILE));
    vec2 high = floor((center_radius.xy + center_radius.zw) / float(TILE));
    return Box(uvec2(clamp(low, vec2(0.0), last)), uvec2(clamp(high, vec2(0.0), last)));
}

uint count_of(Box box) {
    uvec2 sides = box.high - box.low + 1u;
    return sides.x * sides.y;
}
