// Kernels that make a plane of feature maps from another: a row of workgroups a plane.
layout(local_size_x = TRAIN_WORKGROUP) in;
// Width and height of planes that are read and written. Of a derivative the former are those of what
// the step wrote.
layout(constant_id = 0) const uint READ_WIDTH = 1u;
layout(constant_id = 1) const uint READ_HEIGHT = 1u;
layout(constant_id = 2) const uint WIDTH = 1u;
layout(constant_id = 3) const uint HEIGHT = 1u;

layout(std430, set = 0, binding = 1) readonly buffer Read { float read_maps[]; };
layout(std430, set = 0, binding = 2) writeonly buffer Written { float written[]; };

#define READ_PLANE (gl_WorkGroupID.y * READ_WIDTH * READ_HEIGHT)
#define PLANE (gl_WorkGroupID.y * WIDTH * HEIGHT)

float read_at(uvec2 at) {
    return read_maps[READ_PLANE + at.y * READ_WIDTH + at.x];
}
