// Half quads: four f16 in eight bytes. With HALF_STORAGE the device reads f16 itself, without it two words are unpacked: same bytes.
#ifdef HALF_STORAGE
#extension GL_EXT_shader_16bit_storage : require
#define HALF_QUAD f16vec4
#define widen(quad) vec4(quad)
#else
#define HALF_QUAD uvec2
vec4 widen(uvec2 q) { return vec4(unpackHalf2x16(q.x), unpackHalf2x16(q.y)); }
#endif
