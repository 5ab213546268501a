//! Numerical stability on the device: some cases of every category, twice, and what is refused.

use crate::common::{self, gpu};
use effigy_core::{
    avatar::Avatar,
    frame::Skip,
    reference,
    scene::{Camera, Posed},
};
use effigy_lab::stress::{self, Category, StressCase, StressSettings};
use effigy_render::vulkan::{Gpu, GpuOptions, RendererOptions};
use half::f16;
use std::ops::Range;

/// Draws some rounds of cases twice.
fn cases(seed: u64, options: GpuOptions, rounds: Range<u64>) {
    let device = gpu::open(options);
    let settings = StressSettings {
        seed,
        cases: rounds.start * Category::ROUND..rounds.end * Category::ROUND,
        large: false,
    };
    let [first, second] = [0, 1].map(|_| stress::run(&device, &settings, &mut |_, _, _| {}));
    for failure in &first.failures {
        println!(
            "case {} of seed {seed} ({}): {}",
            failure.case,
            failure.category.name(),
            failure.faults.join("; ")
        );
    }
    assert!(
        first.failures.is_empty(),
        "{} of {} cases fail, see above",
        first.failures.len(),
        first.cases
    );
    assert_eq!(
        first.cases as u64,
        Category::ROUND * (rounds.end - rounds.start)
    );
    assert_eq!(first.digest, second.digest, "two runs give different bits");
    let covered = first
        .all
        .iter()
        .filter(|case| case.covered_pixels > 0)
        .count();
    assert!(
        3 * covered > 2 * first.cases,
        "only {covered} of {} cases have anything in the picture",
        first.cases
    );
}

fn every_category_is_drawn_within_its_bounds() {
    cases(1, gpu::headless(), 0..1);
}

fn more_of_every_category_is_drawn_within_its_bounds() {
    cases(1, gpu::headless(), 1..3);
}

fn a_mean_may_leave_out_a_thin_share_of_a_texel() {
    // The left edge of a pixel that is else empty takes 9e-5 of an opaque texel.
    let [seed, number] = [61127001, 4953];
    let device = gpu::gpu();
    let case = StressCase::new(seed, number, false).for_device(&device.probe);
    assert_eq!(stress::check_case(&device, &case).faults, [""; 0]);
}

fn the_least_device_is_as_stable() {
    cases(
        2,
        GpuOptions {
            baseline: true,
            ..gpu::headless()
        },
        0..1,
    );
}

fn pipelines_that_are_kept_change_no_bit() {
    let seed = 1;
    let cases = 0..Category::ROUND;
    let fresh = Gpu::new(&gpu::headless()).unwrap();
    let mut expected = Vec::new();
    for number in cases.clone() {
        let case = StressCase::new(seed, number, false).for_device(&fresh.probe);
        expected.push(stress::check_case(&fresh, &case).digest);
    }
    // Most pipelines of a case are then those of others, which differ in sizes, keys and rasterizers.
    fresh.keep_pipelines();
    for (number, expected) in cases.zip(expected) {
        let case = StressCase::new(seed, number, false).for_device(&fresh.probe);
        let found = stress::check_case(&fresh, &case);
        assert_eq!(found.faults, [""; 0], "case {number}");
        assert_eq!(found.digest, expected, "case {number}");
    }
}

fn features_stay_finite_whatever_the_weights() {
    let device = gpu::gpu();
    let mut avatar = common::avatar(
        3,
        common::Sizes {
            gaussians: 200,
            hidden: 128,
            ..Default::default()
        },
    );
    for layer in &mut avatar.networks.layers {
        layer
            .weight
            .halves_mut()
            .iter_mut()
            .enumerate()
            .for_each(|(k, w)| *w = if k % 3 == 0 { f16::MIN } else { f16::MAX });
        layer.bias.fill(f16::MAX);
    }
    let posed = Posed::new(&avatar, &common::pose(3, &avatar));
    // Every network, even of a part that no one sees.
    let options = RendererOptions {
        skip: Skip::all() - Skip::PARTS,
        ..gpu::options([32, 32])
    };
    let frame = gpu::draw(
        &device,
        avatar,
        posed,
        Camera::orbit(glam::DVec3::Y, 0.0, 0.0, 3.0, 0.7, [32, 32]),
        options,
    );
    assert!(
        frame.reference.features.iter().all(|e| e.abs() <= 65504.0)
            && frame.reference.features.iter().any(|e| e.abs() == 65504.0)
    );
    let features: Vec<f64> = frame.gpu.features.iter().map(|&e| f64::from(e)).collect();
    gpu::assert_close("e", &features, &frame.reference.features, 0.0);
}

/// Whether in most pixels that a case covers the nearer half of its splats leaves hardly any light
/// to the others.
fn lies_behind_itself(case: &StressCase) -> bool {
    let frame = reference::ReferenceFrame::new(&case.avatar, &case.posed, &case.camera);
    let nearer = &frame.order[frame.order.len() / 2..];
    let nearer = reference::raster::raster(&frame.splats, nearer, &case.camera).to_image();
    let whole = frame.canvas.to_image();
    let covered = || (whole.pixels.iter().zip(&nearer.pixels)).filter(|(all, _)| all[3] > 0.1);
    let closed = covered().filter(|(_, near)| near[3] > 0.98).count();
    2 * closed > covered().count()
}

/// Whether the pose takes some Gaussians to more than twice the distance that they have from their
/// nearest neighbour.
fn is_torn(case: &StressCase) -> bool {
    let count = case.avatar.gaussians.len();
    let posed = reference::gaussians_of(&case.avatar, &[&case.posed], &case.camera);
    let apart = |a: usize, b: usize| case.avatar.position(a).distance(case.avatar.position(b));
    let torn = (0..100).map(|at| at * count / 100).filter(|&k| {
        let others = (0..count).filter(|&other| other != k);
        let near = others.min_by(|&a, &b| apart(k, a).total_cmp(&apart(k, b)));
        near.is_some_and(|near| posed[k].mean.distance(posed[near].mean) > 2.0 * apart(k, near))
    });
    torn.count() > 5
}

/// Every category does what it says: its cases have what they are to be hard because of.
fn cases_are_as_hard_as_they_say() {
    let of = |category: Category| {
        (0..40 * Category::ROUND)
            .filter(move |&n| Category::of_case(n) == category)
            .map(|n| StressCase::new(5, n, false))
    };
    let any = |category, hard: &dyn Fn(&StressCase) -> bool| {
        assert!(of(category).any(|case| hard(&case)), "{category:?}")
    };
    any(Category::Poses, &|case| {
        case.pose
            .rotation
            .iter()
            .any(|r| r.length() > std::f64::consts::PI)
    });
    any(Category::Placed, &|case| {
        case.placed.translation.length() > 100.0
    });
    any(Category::Needles, &|case| {
        case.avatar
            .gaussians
            .log_scale
            .iter()
            .any(|s| s[0].to_f64() - s[2].to_f64() > 9.0)
    });
    any(Category::Quaternions, &|case| {
        case.avatar
            .gaussians
            .rotation
            .iter()
            .any(|q| q.iter().all(|v| v.to_f64().abs() < 1e-6))
    });
    any(Category::Opacity, &|case| {
        [0, 1, 2, 255]
            .iter()
            .all(|o| case.avatar.gaussians.opacity.contains(o))
    });
    any(Category::Colors, &|case| {
        case.avatar
            .gaussians
            .color
            .iter()
            .flatten()
            .any(|c| c.to_f64() == 65504.0)
    });
    any(Category::Overflow, &|case| {
        case.avatar
            .networks
            .layers
            .iter()
            .any(|layer| layer.weight.halves().contains(&f16::MAX))
    });
    any(Category::Sizes, &|case| {
        case.camera.size.iter().any(|&side| side > 1000) && case.camera.size.contains(&1)
    });
    any(Category::Views, &|case| {
        case.camera.focal.y < 0.1 * f64::from(case.camera.size[1])
    });
    any(Category::Solid, &|case| {
        lies_behind_itself(case) && !is_torn(case)
    });
    any(Category::Torn, &is_torn);
    let near = of(Category::NearPlane).next().unwrap();
    let stages = reference::ReferenceFrame::new(&near.avatar, &near.posed, &near.camera);
    let depth = |mean| near.camera.view.transform_point3(mean).z;
    assert!(
        stages
            .gaussians
            .iter()
            .filter(|g| depth(g.mean) == near.camera.near)
            .count()
            >= 15,
        "on the plane"
    );
    assert!(
        stages
            .gaussians
            .iter()
            .filter(|g| depth(g.mean) < near.camera.near)
            .count()
            >= 15,
        "before it"
    );
    for number in 0..2 * Category::ROUND {
        let avatar = StressCase::new(6, number, false).avatar;
        assert!(
            Avatar::from_bytes(&avatar.to_bytes().unwrap()).unwrap() == avatar,
            "case {number} is no avatar that a file could hold"
        );
    }
}

fn views_that_are_no_numbers_are_answered_with_one_sentence() {
    for arguments in [
        "--yaw nan",
        "--distance inf",
        "--pitch NaN",
        "--raise=-inf",
        "--fov nan",
    ] {
        let output = std::process::Command::new(common::program())
            .args(
                "render --reference --size 8x8"
                    .split(' ')
                    .chain(arguments.split(' ')),
            )
            .current_dir(std::env::temp_dir())
            .output()
            .unwrap();
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(
            !output.status.success() && said.starts_with("error: ") && said.lines().count() == 1,
            "{arguments}: {said}"
        );
    }
    let time = std::process::Command::new(common::program())
        .args(["render", "--reference", "--size", "8x8", "--time", "nan"])
        .current_dir(std::env::temp_dir())
        .output()
        .unwrap();
    let said = String::from_utf8_lossy(&time.stderr);
    assert!(
        time.status.code() == Some(2) && said.starts_with("error: invalid value 'nan' for '--time"),
        "{said}"
    );
}

tests! {
    every_category_is_drawn_within_its_bounds,
    more_of_every_category_is_drawn_within_its_bounds,
    a_mean_may_leave_out_a_thin_share_of_a_texel,
    the_least_device_is_as_stable,
    pipelines_that_are_kept_change_no_bit,
    features_stay_finite_whatever_the_weights,
    cases_are_as_hard_as_they_say: no_device,
    views_that_are_no_numbers_are_answered_with_one_sentence: no_device,
}
