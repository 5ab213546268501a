//! The `nodes` stage against the reference, element by element.

use crate::common::{self, Sizes, gpu};
use effigy_core::io::pack::PackQuality;
use effigy_render::vulkan::RendererOptions;

fn compare() {
    let device = gpu::gpu();
    let sizes = [
        Sizes::default(),
        Sizes {
            split_features: true,
            nodes: 1,
            ..Sizes::default()
        },
        Sizes {
            basis: 32,
            nodes: 129,
            ..Sizes::default()
        },
        Sizes {
            basis: 4,
            split_features: true,
            nodes: 64,
            parts: 1000,
            ..Sizes::default()
        },
    ];
    let cases = sizes
        .map(|sizes| (sizes, false))
        .into_iter()
        .chain(sizes[1..3].iter().map(|&sizes| (sizes, true)));
    for (seed, (sizes, packed)) in (0..).zip(cases) {
        let avatar = common::avatar(seed, sizes);
        let avatar = if packed {
            avatar.packed(PackQuality::Small)
        } else {
            avatar
        };
        let options = RendererOptions {
            ..gpu::options([64, 64])
        };
        let frame = gpu::frame_of(&device, avatar, seed, options);
        let nodes: Vec<f64> = frame
            .gpu
            .nodes
            .iter()
            .flat_map(|v| [v[0], v[1], v[2]])
            .map(f64::from)
            .collect();
        let reference: Vec<f64> = frame
            .reference
            .nodes
            .iter()
            .flat_map(|v| v.to_array())
            .collect();
        // A micrometre, and half a step of f16 for the largest.
        let largest = reference.iter().fold(0.0, |most: f64, v| most.max(v.abs()));
        gpu::assert_close(
            &format!("δx of the nodes, {sizes:?}"),
            &nodes,
            &reference,
            1e-6 + largest / 2048.0,
        );
    }
}

fn every_node_moves_as_in_the_reference() {
    compare();
}

tests! {
    every_node_moves_as_in_the_reference: smoke,
}
