// What is learned of a Gaussian, and what is not. `learned` has three vectors each: the quaternion
// as w x y z; the log scale, and the logit of the opacity; the colour. `fixed_words` has three each:
// position in canonical space (xyz) and the first two nodes (16 bits each); weights of the nodes,
// and the third node with the part in its upper half; joints, their weights (bytes), and from where
// it is drawn (project/facing.glsl).

struct Placed {
    vec3 position;
    uvec3 node;
    vec3 node_weight;
    uint part;
    uint joint;
    uint joint_weight;
    uint facing;
};

Placed placed_at(uint g) {
    uvec4 a = fixed_words[3u * g], b = fixed_words[3u * g + 1u], c = fixed_words[3u * g + 2u];
    Placed placed;
    placed.position = uintBitsToFloat(a.xyz);
    placed.node = uvec3(a.w & 0xffffu, a.w >> 16u, b.w & 0xffffu);
    placed.node_weight = uintBitsToFloat(b.xyz);
    placed.part = b.w >> 16u;
    placed.joint = c.x;
    placed.joint_weight = c.y;
    placed.facing = c.z;
    return placed;
}

// The skinning transform (model.md, step 6), as rows. `joints` has three rows each.
void skin(uint view, Placed placed, out vec4 row_x, out vec4 row_y, out vec4 row_z) {
    row_x = row_y = row_z = vec4(0.0);
    for (uint j = 0u; j < 4u; ++j) {
        float weight = float(placed.joint_weight >> (8u * j) & 0xffu) * (1.0 / 255.0);
        if (weight > 0.0) {
            uint at = 3u * (view * POSED_JOINTS + (placed.joint >> (8u * j) & 0xffu));
            row_x += weight * joints[at];
            row_y += weight * joints[at + 1u];
            row_z += weight * joints[at + 2u];
        }
    }
}

#include "common/rotation.glsl"
#include "common/footprint.glsl"
#include "project/facing.glsl"

mat3 view_matrix() {
    return transpose(mat3(block.view_rows[0].xyz, block.view_rows[1].xyz, block.view_rows[2].xyz));
}

vec3 view_offset() {
    return vec3(block.view_rows[0].w, block.view_rows[1].w, block.view_rows[2].w);
}

// How much of a Gaussian's opacity is left of what faces away. `to_camera`: from canonical space to
// the camera's; `p`: the mean there.
float view_fade(Placed placed, mat3 to_camera, vec3 p) {
    return facing_fade(to_camera * facing_axis(placed.facing), facing_limit_code(placed.facing), p);
}

// A Gaussian's footprint in this view. `to_camera`: from the space of `axes` to the camera's; `p`: the
// mean there.
Footprint view_footprint(vec3 p, mat3 to_camera, mat3 axes) {
    vec2 slope = clamp(p.xy / p.z, block.slopes.xy, block.slopes.zw);
    return footprint_of(p, block.lens.xy, slope, transpose(to_camera), axes, block.low_pass.x);
}
