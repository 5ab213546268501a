//! Which Gaussians a device may leave out as hidden by the occluder: those that its test takes for
//! hidden wherever around the middle of a texel it samples the mesh.

use super::splats::UncertainSplat;
use effigy_core::{
    avatar::Avatar,
    layout::{PYRAMID_LEVELS, PYRAMID_SIDE},
    occluder::{Occluder, mesh::OPAQUE_DEPTH},
    reference::occluder::{self, OccluderDrawing, PosedVertex},
    scene::{Camera, OccluderView, Posed},
};
use glam::{DVec2, DVec3};

/// How far the stretch of a vertex may be off: its limit is an f16, the rest f32.
const STRETCH: f64 = 0.99;
/// How far a depth of the pyramid may be off: steps of a 16-bit depth image, of a vertex's 16-bit
/// position, and of the rasterizer's grid.
const DEPTH: f64 = 12.0 / 65535.0;
/// How far off a texel's middle a device may seem to sample, texels: vertices lie on a grid of 1/16
/// of a texel at least, and their positions are 16-bit.
const OFFSET: f64 = 1.0 / 16.0;

/// The nearest that the pyramid may hold at each texel of its finest level; None where the mesh
/// reaches behind the camera, and anything may be.
pub struct Occluded {
    nearest: Option<Vec<f64>>,
    origin: DVec2,
    scale: DVec2,
}

/// How the occluder is seen.
pub struct OccludedInput<'a> {
    pub avatar: &'a Avatar,
    pub posed: &'a Posed,
    pub camera: &'a Camera,
    /// Displacements of the nodes, metres.
    pub nodes: &'a [DVec3],
    pub view: &'a OccluderView,
    pub depth_range: [f64; 2],
    pub margin: f64,
}

impl Occluded {
    /// Draws the avatar's mesh. None if it has none.
    pub fn new(input: &OccludedInput) -> Option<Self> {
        let mesh = Occluder::new(input.avatar);
        if mesh.triangles.is_empty() {
            return None;
        }
        let mut vertices: Vec<PosedVertex> =
            occluder::vertices(input.avatar, &mesh, input.posed, input.camera, input.nodes);
        for (posed, vertex) in vertices.iter_mut().zip(&mesh.vertices) {
            let limit = (vertex.optical_depth / OPAQUE_DEPTH).powi(2);
            posed.is_opaque |= STRETCH * posed.stretch <= limit;
        }
        let in_front = vertices
            .iter()
            .all(|vertex| vertex.position.z > 0.5 * input.camera.near);
        let origin = -input.view.texel(DVec2::ZERO);
        let scale = input.view.texel(DVec2::ONE) + origin;
        let finest = f64::from(PYRAMID_SIDE) / f64::from(effigy_core::layout::OCCLUDER_SIDE);
        Some(Self {
            nearest: in_front.then(|| nearest(input, &vertices, &mesh.triangles)),
            origin: origin * finest,
            scale: scale * finest,
        })
    }

    /// Whether a device may take a splat for hidden.
    pub fn may_hide(&self, splat: &UncertainSplat) -> bool {
        let Some(nearest) = &self.nearest else {
            return true;
        };
        let last = f64::from(PYRAMID_SIDE - 1);
        // The texels that the device surely looks at: its square, without what errors may add to
        // it.
        let spare = splat.shift.max_element() + 1e-3 * splat.occluder_radius;
        let radius = (splat.occluder_radius - spare).max(0.0);
        let place = |by: f64| {
            ((splat.center + by * radius) * self.scale - self.origin + by * 0.5)
                .clamp(DVec2::ZERO, DVec2::splat(last))
        };
        let [low, high] = [-1.0, 1.0].map(place);
        // Within rounding of a texel's edge it may be either.
        let [low, high] = [
            (low + 1e-3).as_uvec2(),
            (high - 1e-3).max(DVec2::ZERO).as_uvec2(),
        ];
        let high = high.max(low);
        // The level on which the square spans at most five texels along each side.
        let span = (high - low).max_element();
        let level = if span <= 3 { 0 } else { (span - 1).ilog2() - 1 };
        if level >= PYRAMID_LEVELS {
            return false;
        }
        let [low, high] = [
            low >> level << level,
            (high >> level << level) + (1 << level) - 1,
        ];
        let depth = 1.0 - splat.key[0] + DEPTH;
        (low.y..=high.y)
            .all(|y| (low.x..=high.x).all(|x| depth > nearest[(y * PYRAMID_SIDE + x) as usize]))
    }
}

fn nearest(input: &OccludedInput, vertices: &[PosedVertex], triangles: &[[u32; 3]]) -> Vec<f64> {
    let side = PYRAMID_SIDE as usize;
    let mut all = vec![1.0f64; side * side];
    for [x, y] in [
        [0.0, 0.0],
        [-1.0, -1.0],
        [1.0, -1.0],
        [-1.0, 1.0],
        [1.0, 1.0],
    ] {
        let drawing = OccluderDrawing {
            camera: input.camera,
            view: input.view,
            depth_range: input.depth_range,
            margin: input.margin,
            offset: OFFSET * DVec2::new(x, y),
        };
        let pyramid = occluder::pyramid(vertices, triangles, &drawing);
        for (all, depth) in all.iter_mut().zip(pyramid) {
            *all = all.min(depth);
        }
    }
    all
}
