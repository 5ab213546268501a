//! The oracle: every stage of model.md in f64, in plain Rust, written to be read against the paper's section "Local Linear
//! Blendshapes". In: an avatar, a pose worked out for it, a camera. Out: a picture, and on request what every stage made.
//!
//! It starts from the same stored numbers as the GPU, sorts by exact depth and blends in f64, so what a GPU's stage or picture differs
//! by is that GPU's arithmetic.

pub mod bins;
pub mod features;
pub mod harmonics;
pub mod nodes;
pub mod present;
pub mod raster;
pub mod sort;
pub mod splats;

use crate::avatar::{Avatar, matrix::Row};
use crate::frame::{Camera, Picture, Posed};
use crate::layout::compact::stored_node_weights;
use glam::DVec3;
use half::f16;
pub use raster::Canvas;
pub use splats::{Culled, Gaussian, Splat};

/// What every stage of one frame made.
#[derive(Clone, Debug)]
pub struct Stages {
    /// e; shape N_G, E.
    pub features: Vec<f64>,
    /// δx_s, metres; length N_s.
    pub nodes: Vec<DVec3>,
    /// The avatar in the posed world; length N_g, fewer at a level of detail.
    pub gaussians: Vec<Gaussian>,
    /// The same in the picture.
    pub splats: Vec<Result<Splat, Culled>>,
    /// Indices into `splats`, far to near.
    pub order: Vec<u32>,
    pub canvas: Canvas,
}

impl Stages {
    /// Runs one frame from the top.
    pub fn new(avatar: &Avatar, posed: &Posed, camera: &Camera) -> Self {
        Self::thinned(avatar, posed, camera, 0)
    }

    /// The same at a level of detail ([`crate::frame::detail`]): of the Gaussians every 2^`level`-th, which stands for the others.
    pub fn thinned(avatar: &Avatar, posed: &Posed, camera: &Camera, level: u32) -> Self {
        let (features, nodes, gaussians) = world(avatar, posed, camera);
        let gaussians: Vec<Gaussian> = gaussians.into_iter().step_by(1 << level).collect();
        let splats = splats::splats(&gaussians, camera, level);
        let order = sort::order(&splats);
        let canvas = raster::raster(&splats, &order, camera);
        Self { features, nodes, gaussians, splats, order, canvas }
    }
}

/// The picture of a posed avatar.
pub fn render(avatar: &Avatar, posed: &Posed, camera: &Camera) -> Picture {
    Stages::new(avatar, posed, camera).canvas.to_picture()
}

/// The picture that exact arithmetic makes of what a device holds in place of the avatar: rows, scales, rotations and weights of nodes
/// rounded as [`crate::layout::compact`] says, displacements of nodes to f16. What is left between it and a device's picture is that
/// device's arithmetic.
pub fn render_stored(avatar: &Avatar, posed: &Posed, camera: &Camera) -> Picture {
    let (stored, features, mut gaussians) = stored(avatar, posed);
    harmonics::color(&stored, posed, camera, &features, &mut gaussians);
    render_gaussians(&gaussians, camera)
}

/// The model as device memory holds it, its features in a pose, and its Gaussians, whose colours no camera has changed yet.
pub fn stored(avatar: &Avatar, posed: &Posed) -> (Avatar, Vec<f64>, Vec<Gaussian>) {
    let stored = avatar.compact();
    let features = features::features(&stored, &posed.input);
    let half = |v: f64| f16::from_f64(v).to_f64();
    let nodes: Vec<DVec3> = nodes::nodes(&stored, &features).into_iter().map(|node| DVec3::from(node.to_array().map(half))).collect();
    let gaussians = splats::weighted(&stored, posed, &features, &nodes, |k| stored_node_weights(avatar, k));
    (stored, features, gaussians)
}

/// The picture of one avatar in several poses, sorted together.
pub fn render_scene(avatar: &Avatar, actors: &[&Posed], camera: &Camera) -> Picture {
    let gaussians: Vec<Gaussian> = actors.iter().flat_map(|posed| world(avatar, posed, camera).2).collect();
    render_gaussians(&gaussians, camera)
}

/// The picture of Gaussians in the posed world.
pub fn render_gaussians(gaussians: &[Gaussian], camera: &Camera) -> Picture {
    let splats = splats::splats(gaussians, camera, 0);
    raster::raster(&splats, &sort::order(&splats), camera).to_picture()
}

/// Features, displacements of the nodes, and the avatar in the posed world, coloured as the camera sees it.
fn world(avatar: &Avatar, posed: &Posed, camera: &Camera) -> (Vec<f64>, Vec<DVec3>, Vec<Gaussian>) {
    let features = features::features(avatar, &posed.input);
    let nodes = nodes::nodes(avatar, &features);
    let mut gaussians = splats::gaussians(avatar, posed, &features, &nodes);
    harmonics::color(avatar, posed, camera, &features, &mut gaussians);
    (features, nodes, gaussians)
}

/// B · e: the weighted sum over the basis. `basis` has shape C, N_B, `e` length N_B.
fn combine<const C: usize>(basis: Row, e: &[f64]) -> [f64; C] {
    std::array::from_fn(|c| basis.piece(c * e.len(), e.len()).dot(e))
}
