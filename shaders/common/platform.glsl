// What differs between Vulkan and WebGPU by name only. WEB is defined for WebGPU.
//
// PARAMETER declares a number that the host chooses: on Vulkan a specialization constant, on WebGPU
// a macro, either of common/settings.glsl or of the module's row in src/wgsl.rs. DERIVED is the
// qualifier of a number computed from parameters.
#ifdef WEB
#extension GL_EXT_samplerless_texture_functions : require
#include "common/settings.glsl"
#define PARAMETER(id, type, name, initial)
#define DERIVED
#define IMAGE_2D texture2D
#define UIMAGE_2D utexture2D
#define EARLY_FRAGMENT_TESTS
// WGSL has no such word and needs none.
#define COHERENT
#else
#define PARAMETER(id, type, name, initial) layout(constant_id = id) const type name = initial;
#define DERIVED const
#define IMAGE_2D sampler2D
#define UIMAGE_2D usampler2D
#define EARLY_FRAGMENT_TESTS layout(early_fragment_tests) in;
#define COHERENT coherent
// WebGPU takes it from the settings: there a barrier must not depend on a buffer that is written.
#define KEY_COUNT control.key_count
#define FIRST_REGION uvec2(0u)
#endif
