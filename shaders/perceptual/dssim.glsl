// The window of SSIM: a row of workgroups a channel, an invocation a pixel. Its weights beyond the
// picture do not count.
layout(local_size_x = TRAIN_WORKGROUP) in;
layout(constant_id = 0) const uint WIDTH = 1u;
layout(constant_id = 1) const uint HEIGHT = 1u;

// Of the picture, then of the target. Shape: 2 · 3 · height · width.
layout(std430, set = 0, binding = 1) readonly buffer Read { float read_maps[]; };

const int RADIUS = 5;
const uint PLANE = WIDTH * HEIGHT;
const float C1 = 0.01 * 0.01;
const float C2 = 0.03 * 0.03;

// The weight of a pixel so far away, of the middle's: a deviation of 1.5.
float weight(int x, int y) {
    return exp(-float(x * x + y * y) / 4.5);
}

bool is_inside(ivec2 at) {
    return all(greaterThanEqual(at, ivec2(0))) && at.x < int(WIDTH) && at.y < int(HEIGHT);
}
