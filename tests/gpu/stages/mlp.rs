//! The `features` stage against the reference, element by element.

use crate::common::{self, Sizes, gpu};
use effigy_core::{
    avatar::{Activation, Pose},
    frame::Skip,
    io::pack::PackStep,
    scene::Posed,
};
use effigy_render::vulkan::RendererOptions;

fn compare() {
    let device = gpu::gpu();
    let sizes = [
        Sizes::default(),
        Sizes {
            split_features: true,
            activation: Activation::LeakyRelu,
            subspace: 8,
            ..Sizes::default()
        },
        Sizes {
            hidden: 128,
            basis: 32,
            split_features: true,
            parts: 3,
            ..Sizes::default()
        },
        Sizes {
            hidden: 4,
            basis: 4,
            expression: 0,
            parts: 1,
            joints: 1,
            ..Sizes::default()
        },
    ];
    let cases = sizes
        .map(|sizes| (sizes, false))
        .into_iter()
        .chain(sizes[1..3].iter().map(|&sizes| (sizes, true)));
    for (seed, (sizes, bytes)) in (0..).zip(cases) {
        let avatar = common::avatar(seed, sizes);
        let avatar = if bytes {
            avatar.after(PackStep::Networks)
        } else {
            avatar
        };
        assert_eq!(avatar.networks.in_bytes(), bytes);
        let options = RendererOptions {
            skip: Skip::all() - Skip::PARTS,
            ..gpu::options([64, 64])
        };
        let frame = gpu::frame_of(&device, avatar, seed, options);
        let features: Vec<f64> = frame.gpu.features.iter().map(|&e| f64::from(e)).collect();
        let scale = frame
            .reference
            .features
            .iter()
            .fold(1.0, |max: f64, e| max.max(e.abs()));
        gpu::assert_close(
            &format!("e, {sizes:?}, bytes: {bytes}"),
            &features,
            &frame.reference.features,
            1e-5 * scale,
        );
    }
}

fn every_parts_network_gives_what_the_reference_gives() {
    compare();
}

/// Joints bent far beyond what any of the training poses has them.
fn networks_see_wild_poses_as_the_nearest_known_one() {
    let device = gpu::gpu();
    let avatar = common::avatar(
        7,
        Sizes {
            subspace: 4,
            ..Sizes::default()
        },
    );
    let mut pose = common::pose(8, &avatar);
    pose.rotation
        .iter_mut()
        .skip(1)
        .for_each(|rotation| *rotation *= 6.0);
    let options = RendererOptions {
        skip: Skip::empty(),
        ..gpu::options([64, 64])
    };
    let of = |pose: &Pose, project: bool| {
        let posed = Posed::with_projection(&avatar, pose, project);
        let camera = gpu::camera(&avatar, &posed, [64, 64]);
        let frame = gpu::draw(&device, avatar.clone(), posed, camera, options);
        let features: Vec<f64> = frame.gpu.features.iter().map(|&e| f64::from(e)).collect();
        let largest = frame
            .reference
            .features
            .iter()
            .fold(1.0, |max: f64, e| max.max(e.abs()));
        gpu::assert_close(
            &format!("e, projected: {project}"),
            &features,
            &frame.reference.features,
            1e-5 * largest,
        );
        largest
    };
    let [on, off] = [true, false].map(|project| of(&pose, project));
    assert!(
        off > 1.5 * on,
        "features reach {on} with projection and {off} without"
    );
}

tests! {
    every_parts_network_gives_what_the_reference_gives: smoke,
    networks_see_wild_poses_as_the_nearest_known_one,
}
