//! The uniform blocks of a frame, one an avatar: posed avatars, a camera and the renderer's options go in, what the shaders read of them
//! comes out.

use super::{
    Camera, RendererOptions, Skip, detail,
    scene::{Actor, Staged},
};
use crate::layout::{BINS, Frame, POSITION_BITS};
use glam::DAffine3;

/// Writes what all avatars of a frame share into a block that holds the model's constants.
pub fn fill_shared(block: &mut Frame, options: &RendererOptions, staged: &Staged, camera: &Camera) {
    let Staged { depth, place, .. } = *staged;
    let guard = camera.guard();
    let [low, high] = camera.derivative_limits();
    block.focal = camera.focal.as_vec2().to_array();
    block.center = camera.center.as_vec2().to_array();
    block.derivative_min = low.as_vec2().to_array();
    block.derivative_max = high.as_vec2().to_array();
    block.size = camera.size.map(|side| side as f32);
    block.guard = guard as f32;
    block.near = camera.near as f32;
    block.key_far = depth[1] as f32;
    block.key_scale = (1.0 / (depth[1] - depth[0])) as f32;
    block.key_max = options.key_bits.largest();
    block.cutoff = (255.0 * options.cutoff) as f32;
    block.hull_opacity = if options.skip.contains(Skip::FAINT) { 0.0 } else { 255.0 };
    block.tile = BINS.tile(camera.size) as f32;
    block.margin = options.margin as f32;
    let hides = place.filter(|_| options.skip.contains(Skip::HIDDEN));
    block.surface_start = if hides.is_some() { 4 * options.actors as u32 * vectors(block) } else { 0 };
    hides.inspect(|place| place.write(block));
    let steps = fixed_scale(guard);
    block.fixed_scale = steps as f32;
    let [x, y] = camera.size.map(|side| 2.0 / (steps * f64::from(side)));
    block.clip = [x, y, steps * guard, steps * (2.0 * std::f64::consts::LN_2).sqrt()].map(|value| value as f32);
}

/// Writes an avatar's own.
pub fn fill_actor(block: &mut Frame, options: &RendererOptions, actor: &Actor, camera: &Camera) {
    let posed = actor.posed;
    block.feature_start = actor.number as u32 * vectors(block);
    (block.first, block.drawn, block.level) = (actor.first, actor.drawn, actor.level);
    block.spread = detail::spread(actor.level) as f32;
    block.idle = actor.networks.others().bits();
    block.outside = actor.outside.bits();
    block.node_start = block.feature_start + block.parts * block.feature_quads;
    let quads = if options.skip.contains(Skip::INPUTS) { (posed.input.len() - posed.expression).div_ceil(4) as u32 } else { u32::MAX };
    block.body_quads = block.layer[0].input_quads.min(quads);
    let expression = posed.input.len() - posed.expression;
    for (at, &value) in posed.input.iter().enumerate() {
        block.input[0][at / 4][at % 4] = value as f32;
        block.input[1][at / 4][at % 4] = if at < expression { value as f32 } else { 0.0 };
    }
    for (rows, joint) in block.joint.iter_mut().zip(&posed.joints) {
        *rows = matrix_rows(camera.view * *joint);
    }
}

/// Vectors of an avatar in the pose buffer: its features, then its nodes' displacements.
pub fn vectors(constants: &Frame) -> u32 {
    constants.parts * constants.feature_quads + constants.nodes.div_ceil(2)
}

/// Rows of the 3 by 4 matrix of an affine map.
pub fn matrix_rows(map: DAffine3) -> [[f32; 4]; 3] {
    let columns = [map.matrix3.x_axis, map.matrix3.y_axis, map.matrix3.z_axis, map.translation];
    std::array::from_fn(|row| columns.map(|column| column[row] as f32))
}

/// Steps of a splat's coordinate in a pixel: the power of two with which a picture and its guard on both sides just fit.
pub fn fixed_scale(guard: f64) -> f64 {
    (f64::from((1 << POSITION_BITS) - 1) / (3.0 * guard)).log2().floor().exp2()
}
