// What differs between Vulkan and WebGPU by name only. WEB is defined for WebGPU.
//
// PARAMETER declares a number that the host chooses: on Vulkan a specialization constant, on WebGPU
// a macro, either of common/settings.glsl or of the module's row in src/wgsl.rs. DERIVED is the
// qualifier of a number computed from parameters. WORKGROUP declares how many invocations a
// workgroup has, which the host may change on Vulkan; WORKGROUP_SIZE is their number.
#ifdef WEB
#extension GL_EXT_samplerless_texture_functions : require
#include "common/settings.glsl"
#define PARAMETER(id, type, name, initial)
#define DERIVED
#define WORKGROUP(id, size) layout(local_size_x = size) in;
#define WORKGROUP_SIZE(size) size
#define IMAGE_2D texture2D
#define UIMAGE_2D utexture2D
#define EARLY_FRAGMENT_TESTS
// WGSL has no such word and needs none.
#define COHERENT
#define TILES_PER_SIDE TILES_PER_SIDE_WEB
#define TILE_COUNT TILE_COUNT_WEB
#else
#define PARAMETER(id, type, name, initial) layout(constant_id = id) const type name = initial;
#define DERIVED const
#define WORKGROUP(id, size) layout(local_size_x_id = id, local_size_x = size) in;
#define WORKGROUP_SIZE(size) gl_WorkGroupSize.x
#define IMAGE_2D sampler2D
#define UIMAGE_2D usampler2D
#define EARLY_FRAGMENT_TESTS layout(early_fragment_tests) in;
#define COHERENT coherent
#define TILES_PER_SIDE TILES_PER_SIDE_VULKAN
#define TILE_COUNT TILE_COUNT_VULKAN
// WebGPU takes it from the settings: there a barrier must not depend on a buffer that is written.
#define KEY_COUNT control.key_count
#define FIRST_REGION uvec2(0u)
#endif
