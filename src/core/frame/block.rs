//! The uniform blocks of a frame, one an avatar: what the shaders read of the pose, the camera and
//! the renderer's options.

use super::{
    DEPTH_KEYS, RendererOptions, Skip,
    capacity::Capacity,
    state::{AvatarInstance, Layer},
};
use crate::layout::{CenterGrids, FrameBlock, TILING, bin_side};
use crate::scene::{Camera, detail};
use bytemuck::{bytes_of, bytes_of_mut};
use glam::DAffine3;
use std::mem::offset_of;

/// Where people's features and nodes are in the pose buffer, in vectors of 4.
#[derive(Clone, Copy, Debug)]
pub struct PoseLayout {
    /// Vectors of a person: the features, then the nodes' displacements, two nodes a vector.
    pub vectors: u32,
    /// People that it holds.
    pub people: u32,
}

impl PoseLayout {
    /// Where a vector of zeros is, behind everybody's: how far nodes move that nothing moves.
    pub fn zeros(&self) -> u32 {
        self.people * self.vectors
    }

    /// Vectors of the buffer.
    pub fn total(&self) -> u32 {
        self.zeros() + 1
    }
}

/// How much the buffers hold that all people of a frame share.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SharedSizes {
    /// Of a frame.
    pub capacity: Capacity,
    /// Of a person's features and nodes: [`PoseLayout::vectors`].
    pub pose_vectors: u32,
    /// Words of a Gaussian in the pose cache.
    pub cache_words: u32,
}

impl SharedSizes {
    /// Those for people of avatars with these constants.
    pub fn new<'a>(avatars: impl Iterator<Item = &'a FrameBlock>, capacity: Capacity) -> Self {
        let mut new = Self {
            capacity,
            pose_vectors: 0,
            cache_words: 0,
        };
        for own in avatars {
            let vectors = own.parts * own.feature_quads + own.nodes.div_ceil(2);
            new.pose_vectors = new.pose_vectors.max(vectors);
            new.cache_words = new.cache_words.max(own.pose_cache_words());
        }
        new
    }

    /// Whether they suffice where `other` do.
    pub fn hold(&self, other: &Self) -> bool {
        self.capacity.holds(&other.capacity)
            && self.pose_vectors >= other.pose_vectors
            && self.cache_words >= other.cache_words
    }

    /// Those that suffice where either do.
    pub fn union(self, other: Self) -> Self {
        Self {
            capacity: self.capacity.union(other.capacity),
            pose_vectors: self.pose_vectors.max(other.pose_vectors),
            cache_words: self.cache_words.max(other.cache_words),
        }
    }

    /// Where people are in the pose buffer.
    pub fn pose_layout(&self) -> PoseLayout {
        PoseLayout {
            vectors: self.pose_vectors,
            people: self.capacity.posed as u32,
        }
    }
}

/// Writes what no frame changes of the level that an avatar is drawn from.
pub fn write_constants(block: &mut FrameBlock, constants: &FrameBlock) {
    let constant = offset_of!(FrameBlock, input);
    bytes_of_mut(block)[..constant].copy_from_slice(&bytes_of(constants)[..constant]);
}

/// Writes what all avatars of a layer share. `camera`: the frame's. `block` must hold the model's
/// constants.
pub fn write_shared(
    block: &mut FrameBlock,
    options: &RendererOptions,
    layer: &Layer,
    camera: &Camera,
) {
    let [near, far] = layer.depth_range;
    let CenterGrids { guard, steps } = CenterGrids::of(layer.size);
    let [derivative_min, derivative_max] = camera.derivative_limits();
    block.derivative_min = derivative_min.as_vec2().to_array();
    block.derivative_max = derivative_max.as_vec2().to_array();
    block.size = layer.size.map(|side| side as f32);
    block.guard = guard as f32;
    block.near = camera.near as f32;
    block.key_far = far as f32;
    block.key_scale = (1.0 / (far - near)) as f32;
    block.key_max = DEPTH_KEYS.largest();
    block.cutoff = (255.0 * options.cutoff) as f32;
    block.quad_opacity = if options.skip.contains(Skip::FAINT) {
        0.0
    } else {
        255.0
    };
    block.tile_side = TILING.tile(layer.size) as f32;
    block.bin_side = bin_side(layer.size);
    // Clip space of the quads: a splat's coordinates are in steps of 1 / `steps` px.
    block.fixed_scale = steps as f32;
    let [x, y] = layer.size.map(|side| 2.0 / (steps * f64::from(side)));
    block.clip = [
        x,
        y,
        steps * guard,
        steps * (2.0 * std::f64::consts::LN_2).sqrt(),
    ]
    .map(|value| value as f32);
}

/// Writes what belongs to one avatar of a layer. `block` must hold the model's constants.
pub fn write_instance(
    block: &mut FrameBlock,
    options: &RendererOptions,
    layer: &Layer,
    instance: &AvatarInstance,
    pose: PoseLayout,
) {
    let posed = instance.posed;
    let camera = &instance.camera;
    block.focal = camera.focal.as_vec2().to_array();
    block.center = camera.center.as_vec2().to_array();
    // In the image a splat is drawn if some of it is inside, in an atlas if all of it is.
    let area = instance.slot.unwrap_or(layer.drawn);
    let [min, max] = [area.min, area.max].map(|corner| corner.as_vec2());
    block.area = [min.x, min.y, max.x, max.y];
    block.area_reach = if instance.slot.is_some() { -1.0 } else { 1.0 };
    block.low_pass = instance.low_pass.variance as f32;
    block.compensation = instance.low_pass.compensation as f32;
    block.feature_start = instance.pose_place as u32 * pose.vectors;
    // A level that networks don't move has no features, and one node, which stays in its place.
    block.node_start = if instance.correctives {
        block.feature_start + block.parts * block.feature_quads
    } else {
        pose.zeros()
    };
    block.first_splat = instance.first_key;
    block.drawn = instance.gaussians;
    block.detail_level = instance.level;
    if !options.skip.contains(Skip::FACING) {
        block.facing_start = 0;
    }
    block.covariance_scale = detail::covariance_scale(instance.level) as f32;
    block.idle_parts = instance.networks.complement().bits();
    block.culled_parts = instance.culled_parts.bits();

    // Two inputs for the networks: the head's sees the expression, the body's has zeros there.
    let body_inputs = posed.input.len() - posed.expression;
    block.body_quads = block.layer[0].input_quads;
    if options.skip.contains(Skip::INPUTS) {
        block.body_quads = block.body_quads.min(body_inputs.div_ceil(4) as u32);
    }
    for (at, &value) in posed.input.iter().enumerate() {
        block.input[0][at / 4][at % 4] = value as f32;
        block.input[1][at / 4][at % 4] = if at < body_inputs { value as f32 } else { 0.0 };
    }
    for (rows, joint) in block.joint.iter_mut().zip(&posed.joints) {
        *rows = matrix_rows(camera.view * *joint);
    }
}

/// Rows of the 3 × 4 matrix of an affine map.
pub fn matrix_rows(map: DAffine3) -> [[f32; 4]; 3] {
    let columns = [
        map.matrix3.x_axis,
        map.matrix3.y_axis,
        map.matrix3.z_axis,
        map.translation,
    ];
    std::array::from_fn(|row| columns.map(|column| column[row] as f32))
}
