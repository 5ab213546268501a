//! Bytes that a frame moves, counted from the sizes of what each stage reads and writes, every access to memory once.
//!
//! Blending is counted as one read and one write of the covered picture (what a tiler's memory sees); fragments that blend in cache or
//! in tile memory cost none. Caches can only make the true figure smaller, except for gathers that fetch a line for a part of it.

use crate::{
    avatar::Avatar,
    vulkan::{RendererOptions, harmonics},
};

/// Bytes of each stage for a frame in which everything changed and `drawn` Gaussians survive culling.
pub fn per_stage(avatar: &Avatar, options: &RendererOptions, drawn: u64) -> Vec<(&'static str, u64)> {
    let count = avatar.gaussians.len() as u64;
    let halves = |count: usize| 2 * count as u64;
    let networks: u64 = avatar.networks.layers.iter().map(|layer| halves(layer.weight.len() + layer.bias.len())).sum();
    let features = 4 * (avatar.parts.len() * avatar.networks.output()) as u64;
    let nodes = avatar.nodes.len() as u64;
    let rows = halves(avatar.rotation_rows.basis.len() + avatar.scale_rows.basis.len() + avatar.color_rows.basis.len());
    // Keys of the culled are read by the first pass too; a pass reads entries twice (count, scatter) and writes them once.
    let [key, entry, value] = [4, 8, 4];
    let between = u64::from(options.key_bits.passes()) - 2;
    let sort = (2 * key * count + entry * drawn) + between * 3 * entry * drawn + (2 * entry * drawn + value * drawn);
    let pixels = u64::from(options.size[0]) * u64::from(options.size[1]);
    let mut stages = vec![
        ("features", networks + features),
        ("nodes", halves(avatar.nodes.basis.len()) + 8 * nodes + features + 16 * nodes),
        ("splats", 48 * count + count + rows + features + 16 * nodes + 16 * drawn + 4 * count),
        ("sort", sort),
        ("raster", (4 + 16) * drawn + 2 * pixels * options.color.bytes() as u64),
    ];
    if avatar.harmonics.is_some() {
        // Coefficients, position and joints, and the colour to and fro.
        stages.insert(2, ("harmonics", harmonics::bytes(avatar) + (16 + 8 + 8) * count));
    }
    stages
}
