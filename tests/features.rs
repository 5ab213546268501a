//! The `features` stage against the reference, element by element.

mod common;

use common::{Sizes, gpu};
use effigy::{
    avatar::{Activation, Pose, pack::Step},
    frame::{Posed, Skip},
    vulkan::{GpuOptions, RendererOptions},
};

fn compare(options: GpuOptions) {
    let Some(device) = gpu::open(options) else { return };
    let sizes = [
        Sizes::default(),
        Sizes { split_features: true, activation: Activation::LeakyRelu, subspace: 8, ..Sizes::default() },
        Sizes { hidden: 128, basis: 32, split_features: true, parts: 3, ..Sizes::default() },
        Sizes { hidden: 4, basis: 4, expression: 0, parts: 1, joints: 1, ..Sizes::default() },
    ];
    let cases = sizes.map(|sizes| (sizes, false)).into_iter().chain(sizes[1..3].iter().map(|&sizes| (sizes, true)));
    for (seed, (sizes, bytes)) in (0..).zip(cases) {
        let avatar = common::avatar(seed, sizes);
        let avatar = if bytes { avatar.after(Step::Networks) } else { avatar };
        assert_eq!(avatar.networks.in_bytes(), bytes);
        let options = RendererOptions { skip: Skip::all() - Skip::PARTS, ..gpu::options([64, 64]) };
        let frame = gpu::frame_of(&device, avatar, seed, options);
        let features: Vec<f64> = frame.gpu.features.iter().map(|&e| f64::from(e)).collect();
        let scale = frame.oracle.features.iter().fold(1.0, |max: f64, e| max.max(e.abs()));
        gpu::assert_close(&format!("e, {sizes:?}, bytes: {bytes}"), &features, &frame.oracle.features, 1e-5 * scale);
    }
    gpu::assert_valid();
}

#[test]
fn every_parts_network_gives_what_the_reference_gives() {
    compare(GpuOptions::headless(None));
}

#[test]
fn packed_words_give_the_same_as_halves() {
    compare(GpuOptions { packed_words: true, ..GpuOptions::headless(None) });
}

/// Joints bent far beyond what any of the training poses has them.
#[test]
fn networks_see_wild_poses_as_the_nearest_known_one() {
    let Some(device) = gpu::gpu() else { return };
    let avatar = common::avatar(7, Sizes { subspace: 4, ..Sizes::default() });
    let mut pose = common::pose(8, &avatar);
    pose.rotation.iter_mut().skip(1).for_each(|rotation| *rotation *= 6.0);
    let options = RendererOptions { skip: Skip::empty(), ..gpu::options([64, 64]) };
    let of = |pose: &Pose, project: bool| {
        let posed = Posed::of(&avatar, pose, project);
        let camera = gpu::camera(&avatar, &posed, [64, 64]);
        let frame = gpu::draw(&device, avatar.clone(), posed, camera, options);
        let features: Vec<f64> = frame.gpu.features.iter().map(|&e| f64::from(e)).collect();
        let largest = frame.oracle.features.iter().fold(1.0, |max: f64, e| max.max(e.abs()));
        gpu::assert_close(&format!("e, projected: {project}"), &features, &frame.oracle.features, 1e-5 * largest);
        largest
    };
    let [on, off] = [true, false].map(|project| of(&pose, project));
    assert!(off > 1.5 * on, "features reach {on} with projection and {off} without");
    gpu::assert_valid();
}
