// Which tiles of the band a splat meets: those that the box around its ellipse meets. A stage's
// blocks have TRAIN_BLOCK splats, in drawing order, nearest first.
layout(constant_id = 0) const uint TILE = 8u;

struct Box {
    uvec2 low;
    uvec2 end;
};

// First column and row of tiles, and the first after them. The splat's box meets the image, but not
// every band.
Box tiles_of(vec4 center_radius) {
    vec2 last = vec2(block.image_size.zw) - 1.0;
    vec2 low = floor((center_radius.xy - center_radius.zw) / float(TILE));
    vec2 high = floor((center_radius.xy + center_radius.zw) / float(TILE));
    Box box = Box(uvec2(clamp(low, vec2(0.0), last)), uvec2(clamp(high, vec2(0.0), last)) + 1u);
    box.low.y = max(box.low.y, block.band.x);
    box.end.y = min(box.end.y, block.band.y);
    return box;
}

uint count_of(Box box) {
    return box.end.y > box.low.y ? (box.end.x - box.low.x) * (box.end.y - box.low.y) : 0u;
}
