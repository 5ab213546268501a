// The entry point of the tile rasterizer; see tiles.glsl.
#include "raster/filled.glsl"
#include "raster/place.glsl"

void store_pixel(uvec2 at, uvec2 size, vec4 pixel, bool open) {
    if (all(lessThan(at, size))) {
        imageStore(image, ivec2(at), filled(pixel, open));
    }
}

void store_row(uvec2 at, uvec2 size, vec4 a, vec4 b, vec4 c, vec4 d, bool open) {
    store_pixel(at, size, a, open);
    store_pixel(at + uvec2(1u, 0u), size, b, open);
    store_pixel(at + uvec2(2u, 0u), size, c, open);
    store_pixel(at + uvec2(3u, 0u), size, d, open);
}

void main() {
    uint index = index_in_workgroup();
    uvec2 corner = (FIRST_REGION + gl_WorkGroupID.xy) * RASTER_REGION;
    uvec2 first = corner + SIDE * place_of(index);
    Square square;
    bool drawn = is_drawn(corner);
    square.open = drawn;
    square.fragments = 0u;
    square.middle = vec2(first) + 0.5 * float(SIDE);
    const vec4 clear = vec4(0.0, 0.0, 0.0, 1.0);
    square.pixels = vec4[](clear, clear, clear, clear, clear, clear, clear, clear,
                           clear, clear, clear, clear, clear, clear, clear, clear);
    blend_tiles(square, uvec2(square.middle / frame.tile_side));
    square.open = square.open || !drawn;
    uvec2 size = uvec2(frame.size);
    store_row(first, size,
              square.pixels[0], square.pixels[1], square.pixels[2], square.pixels[3],
              square.open);
    store_row(first + uvec2(0u, 1u), size,
              square.pixels[4], square.pixels[5], square.pixels[6], square.pixels[7],
              square.open);
    store_row(first + uvec2(0u, 2u), size,
              square.pixels[8], square.pixels[9], square.pixels[10], square.pixels[11],
              square.open);
    store_row(first + uvec2(0u, 3u), size,
              square.pixels[12], square.pixels[13], square.pixels[14], square.pixels[15],
              square.open);
    if (COUNTED && square.fragments > 0u) {
        atomicAdd(control.fragments, square.fragments);
    }
}
