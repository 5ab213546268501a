// The offsets of a tile's digits in shared memory (see sort/offsets.glsl). The including shader
// defines THREADS, the invocations of a workgroup, each of which has OWN neighbouring digits.
const uint OWN = SORT_DIGITS / THREADS;
const uint own_end = OWN;
shared uint offset[SORT_DIGITS];

uint own_offset(uint own) { return offset[gl_LocalInvocationID.x * OWN + own]; }
void set_own_offset(uint own, uint value) { offset[gl_LocalInvocationID.x * OWN + own] = value; }
