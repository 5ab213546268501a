// Half quads: four f16 in eight bytes. With HALF_STORAGE the device reads f16 from buffers; without
// it the shader unpacks two words. The bytes are the same.
#ifdef HALF_STORAGE
#extension GL_EXT_shader_16bit_storage : require
#define HALF_QUAD f16vec4
// A macro, since without f16 arithmetic no function may take an f16vec4.
#define widen(quad) vec4(quad)
#else
#define HALF_QUAD uvec2
vec4 widen(uvec2 quad) { return vec4(unpackHalf2x16(quad.x), unpackHalf2x16(quad.y)); }
#endif
