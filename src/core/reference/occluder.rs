//! Stage `occluder`: where a pose takes the occluder mesh, whether the shell around it is still
//! opaque, and the finest level of the depth pyramid.

use super::nodes::displacement;
use super::project::skinning;
use crate::avatar::Avatar;
use crate::layout::{OCCLUDER_SIDE, PYRAMID_SIDE};
use crate::occluder::{Occluder, OccluderVertex, mesh::OPAQUE_DEPTH};
use crate::scene::{Camera, OccluderView, Posed};
use glam::{DAffine3, DVec2, DVec3};

/// A vertex of the mesh in a pose.
#[derive(Clone, Copy, Debug)]
pub struct PosedVertex {
    /// Camera space, metres.
    pub position: DVec3,
    /// Squared ratio of the posed triangle's area to the area under the vertex's own matrix: see
    /// [`stretch`].
    pub stretch: f64,
    /// Whether the shell around it is opaque although the pose has pulled it apart.
    pub is_opaque: bool,
}

/// The mesh's vertices in a pose. `nodes`: displacements of the avatar's nodes, metres, length N_s.
pub fn vertices(
    avatar: &Avatar,
    occluder: &Occluder,
    posed: &Posed,
    camera: &Camera,
    nodes: &[DVec3],
) -> Vec<PosedVertex> {
    let skinning_of = |vertex: &OccluderVertex| -> DAffine3 {
        camera.view * skinning(&posed.joints, vertex.joint, vertex.joint_weight)
    };
    let positions: Vec<DVec3> = occluder
        .vertices
        .iter()
        .map(|vertex| {
            let weights = avatar.node_weights_at(vertex.position, vertex.node);
            let displacement = displacement(weights, vertex.node, nodes);
            skinning_of(vertex).transform_point3(vertex.position + displacement)
        })
        .collect();
    occluder
        .vertices
        .iter()
        .zip(&positions)
        .map(|(vertex, &position)| {
            let beside = vertex.neighbor.map(|at| at as usize);
            let linear = skinning_of(vertex).matrix3;
            let stretch = stretch(
                beside.map(|at| positions[at] - position),
                beside.map(|at| linear * (occluder.vertices[at].position - vertex.position)),
            );
            PosedVertex {
                position,
                stretch,
                is_opaque: stretch <= (vertex.optical_depth / OPAQUE_DEPTH).powi(2),
            }
        })
        .collect()
}

/// Squared ratio of the posed triangle's area to the area under the vertex's own matrix: how much
/// further a pose spreads the Gaussians around a vertex than it stretches each. Their optical depth
/// falls by its root.
///
/// `edges`: two edges of the mesh as posed; `own`: as the vertex's own matrix would pose them, which
/// is how it stretches a Gaussian. NaN or infinite for edges along one line.
pub fn stretch(edges: [DVec3; 2], own: [DVec3; 2]) -> f64 {
    let area = |[a, b]: [DVec3; 2]| a.cross(b).length_squared();
    area(edges) / area(own)
}

/// 1 less the depth key of a distance along the camera's axis, metres: 0 is the nearest, 1 the
/// furthest. `range`: the depths between which the key is linear.
pub fn depth_of(distance: f64, range: [f64; 2]) -> f64 {
    const TAIL: f64 = 1.0 / 64.0;
    let at = (range[1] - distance) / (range[1] - range[0]);
    let key = if at < 0.0 {
        TAIL / (1.0 - at)
    } else if at > 1.0 {
        1.0 - TAIL / at
    } else {
        TAIL + (1.0 - 2.0 * TAIL) * at
    };
    1.0 - key
}

/// How the mesh is drawn into the occluder's depth image.
#[derive(Clone, Copy, Debug)]
pub struct OccluderDrawing<'a> {
    /// Pixels of the image are those of this camera.
    pub camera: &'a Camera,
    /// The part of the image that is covered.
    pub view: &'a OccluderView,
    /// Depths between which the key is linear, metres.
    pub depth_range: [f64; 2],
    /// How far the mesh is pushed back, metres.
    pub margin: f64,
    /// Where in a texel of the depth image it is sampled, off its middle, texels.
    pub offset: DVec2,
}

/// The finest level of the depth pyramid, row by row: the furthest depth of the texels under each,
/// 1 where one of them is free. All vertices must be in front of the camera.
pub fn pyramid(
    vertices: &[PosedVertex],
    triangles: &[[u32; 3]],
    drawing: &OccluderDrawing,
) -> Vec<f64> {
    let corners: Vec<DVec3> = vertices
        .iter()
        .map(|vertex| {
            let distance = vertex.position.z;
            let depth = if vertex.is_opaque {
                depth_of(distance + drawing.margin, drawing.depth_range)
            } else {
                1.0
            };
            let camera = drawing.camera;
            let pixel = camera.focal * vertex.position.truncate() / distance + camera.center;
            (drawing.view.texel(pixel) - drawing.offset).extend(depth)
        })
        .collect();
    let side = OCCLUDER_SIDE as usize;
    let mut nearest = vec![1.0; side * side];
    for triangle in triangles {
        draw(triangle.map(|k| corners[k as usize]), side, &mut nearest);
    }
    let span = (OCCLUDER_SIDE / PYRAMID_SIDE) as usize;
    let finest = PYRAMID_SIDE as usize;
    (0..finest * finest)
        .map(|at| {
            let x = at % finest * span;
            let y = at / finest * span;
            (0..span * span)
                .map(|k| nearest[(y + k / span) * side + x + k % span])
                .fold(0.0, f64::max)
        })
        .collect()
}

/// Draws a triangle that faces the camera; depth is linear across it, as it is on a device.
fn draw([a, b, c]: [DVec3; 3], side: usize, nearest: &mut [f64]) {
    let area = (b - a).truncate().perp_dot((c - a).truncate());
    // Anticlockwise from outside, with y down.
    if area >= 0.0 || area.is_nan() {
        return;
    }
    let low = a.min(b).min(c);
    let high = a.max(b).max(c);
    let range = |low: f64, high: f64| {
        let first = (low - 0.5).ceil().max(0.0) as usize;
        let end = (high + 0.5).ceil().clamp(0.0, side as f64) as usize;
        first..end
    };
    for y in range(low.y, high.y) {
        for x in range(low.x, high.x) {
            let at = DVec2::new(x as f64 + 0.5, y as f64 + 0.5);
            let share = |from: DVec3, to: DVec3| {
                (to - from).truncate().perp_dot(at - from.truncate()) / area
            };
            let shares = DVec3::new(share(b, c), share(c, a), share(a, b));
            if shares.min_element() >= 0.0 {
                let depth = shares.dot(DVec3::new(a.z, b.z, c.z));
                let texel = &mut nearest[y * side + x];
                *texel = texel.min(depth);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stretch_is_the_square_of_the_area() {
        let own = [DVec3::X, DVec3::new(0.5, 1.0, 0.0)];
        let near = |edges: [DVec3; 2], expected: f64| {
            let got = stretch(edges, own);
            assert!((got - expected).abs() < 1e-12, "{got}, expected {expected}");
        };
        near(own, 1.0);
        near(own.map(|edge| 2.0 * edge), 16.0);
        near(own.map(|edge| edge * DVec3::new(2.0, 0.5, 1.0)), 1.0);
        let along_one_line = stretch(own, [DVec3::X; 2]);
        assert!(along_one_line.is_infinite() || along_one_line.is_nan());
    }

    #[test]
    fn depth_rises_with_distance() {
        let range = [2.0, 4.0];
        let depths: Vec<f64> = [0.5, 2.0, 3.0, 4.0, 9.0]
            .map(|distance| depth_of(distance, range))
            .into();
        assert!(depths.is_sorted());
        assert_eq!(
            [depths[1], depths[2], depths[3]],
            [1.0 / 64.0, 0.5, 63.0 / 64.0]
        );
    }
}
