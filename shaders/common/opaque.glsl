// A loop's end that compilers do not know. One that they know they unroll, and llvmpipe takes ten
// seconds to compile the kernel; one that is the uniform block's alone Mesa 22's lavapipe puts into
// the kernel, which it compiles again for each frame. So it does where a branch depends on the
// block alone: none may. `any`: any number that was read from a buffer.
uint opaque_end(uint end, uint any) { return min(end, any | end); }
