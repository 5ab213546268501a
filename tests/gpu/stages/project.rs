//! The `splats` stage against the reference, element by element: what is culled, and every number
//! of what is not.

use crate::common::{self, Sizes, gpu};
use effigy_core::{
    avatar::{Avatar, Filter},
    constants::FACING_FADE,
    frame::{CullReasons, Skip},
    io::pack::PackQuality,
    layout::{CenterGrids, POSITION_BITS, SORT_CULLED, compact::NodeBits},
    reference::{Culled, Gaussian, Splat},
    scene::{Camera, Posed, detail},
};
use effigy_render::vulkan::RendererOptions;
use glam::{DAffine3, DQuat, DVec2, DVec3};
use half::f16;

/// A splat as its 16 bytes say it.
struct Unpacked {
    center: DVec2,
    covariance: [f64; 3],
    opacity: f64,
    color: DVec3,
}

fn unpack(words: [u32; 4], camera: &Camera) -> Unpacked {
    let center = CenterGrids::of(camera.size).center(words);
    let half = |bits: u32| f16::from_bits(bits as u16).to_f64();
    let (axis, shorter) = (
        DVec2::new(half(words[2] & 0xffff), half(words[2] >> 16)),
        half(words[3] & 0xffff),
    );
    let across = axis.normalize().perp() * shorter;
    let blue = words[3] >> 24 << 2 | words[0] >> 30;
    let color = [
        words[0] >> POSITION_BITS & 1023,
        words[1] >> POSITION_BITS & 1023,
        blue,
    ]
    .map(|c| f64::from(c) / 1023.0);
    Unpacked {
        center,
        covariance: [
            axis.x * axis.x + across.x * across.x,
            axis.x * axis.y + across.x * across.y,
            axis.y * axis.y + across.y * across.y,
        ],
        opacity: f64::from(words[3] >> 16 & 0xff) / 255.0,
        color: DVec3::from(color),
    }
}

/// What a splat may be off by besides what its 16 bytes round, px.
#[derive(Clone, Copy)]
struct Tolerance {
    /// Its centre.
    center: f64,
    /// Its axes.
    axes: f64,
    /// Its colour, 0 to 1.
    color: f64,
    /// How much of its opacity is left of what faces away.
    fade: f64,
}

/// Rounding of a splat that the reference does not model: of the nodes' weights and displacements,
/// and of the pose cache if the splat comes from it.
fn tolerance(frame: &gpu::Frame, at: usize, expected: &Splat, cached: bool) -> Tolerance {
    let nodes = frame.avatar.gaussians.node[at << frame.level]
        .map(|node| frame.reference.nodes[usize::from(node)]);
    let apart = nodes[0]
        .distance(nodes[1])
        .max(nodes[1].distance(nodes[2]))
        .max(nodes[2].distance(nodes[0]));
    let enlarged = effigy_core::scene::avatar_bounds::enlargement(&frame.posed.joints);
    let longest = nodes
        .iter()
        .fold(0.0, |most: f64, node| most.max(node.length()));
    // What a weight may be off by, with a little for f32, and half a step of f16.
    let weight = 1e-6 + NodeBits::new(frame.avatar.nodes.len()).rounding();
    let mut offset = enlarged * (weight * apart + longest / 2048.0);
    // On the screen; nearer the border lengths seem longer.
    let slope = (expected.center - frame.camera.center) / frame.camera.focal;
    let pixels = frame.camera.focal.max_element() / expected.depth * (1.0 + slope.length());
    let axis = |k: usize| frame.reference.gaussians[at].axes.col(k).length();
    let axis = axis(0).max(axis(1)).max(axis(2)) * pixels;
    // The reference's quaternion is f16: each component is off by half a step, which turns by twice as
    // much.
    let mut axes = 3.5e-4 * axis;
    if cached {
        let [min, max] =
            effigy_core::scene::AvatarBounds::new(&frame.avatar).bounds(&frame.posed.joints);
        // Half a step of the box: however the camera stands, no side of it is longer than the
        // diagonal and its margins.
        offset += 0.87 * ((max - min).length() + 0.2 * enlarged) / 63_000.0;
        // Half of 1023 steps, each entry of the three by three; the longest axis is rounded up by a
        // third at most.
        axes += 1.4 * 0.5 / 1023.0 * 3.0 * axis;
    }
    // A little nearer is a little larger, and seen a little more from the side.
    axes += (expected.covariance[0] + expected.covariance[2]).sqrt() * offset / expected.depth
        * (1.0 + slope.length());
    let fade = match facing(frame, at, cached) {
        Some([fade, off]) if fade < 1.0 + off => off,
        _ => 0.0,
    };
    // The pose cache rounds it to ten bits once more; the reference's are f16.
    Tolerance {
        fade,
        center: offset * pixels,
        axes,
        color: if cached { 0.5 / 1023.0 } else { 0.0 } + 2.6e-4,
    }
}

/// By how much a splat's opacity may be off: half a step where it was compensated or faces away, and
/// what errors do to that. The factor of compensation is A / √(A² + k T + k²), and A, the area of the
/// projected axes, is off by no more than 2 e √T, whose square T is, for an error e of the axes.
fn opacity_tolerance(filter: Filter, tolerance: Tolerance) -> f64 {
    let compensation = if filter.compensated {
        2.0 * tolerance.axes / filter.variance.sqrt()
    } else {
        0.0
    };
    let rounding = if filter.compensated || tolerance.fade > 0.0 {
        0.502 / 255.0
    } else {
        1e-6
    };
    rounding + compensation + tolerance.fade
}

/// The cosine between a Gaussian's axis and the direction to the camera, less that at which it
/// vanishes, in steps of what it fades over; and how far that may be off.
fn facing(frame: &gpu::Frame, at: usize, cached: bool) -> Option<[f64; 2]> {
    if frame.avatar.gaussians.facing.is_empty() {
        return None;
    }
    let gaussian = &frame.reference.gaussians[at];
    let own = gaussian.facing;
    let to_camera = (frame.camera.eye() - gaussian.mean).normalize();
    let cosine = own.axis.normalize().dot(to_camera);
    // The pose cache has 12 bits a coordinate of the octahedral map.
    let off = if cached { 1e-3 } else { 1e-4 };
    Some([(cosine - own.limit) / FACING_FADE, off / FACING_FADE])
}

/// How far a splat is from the reference's, each number as a share of what is allowed.
fn error(got: &Unpacked, expected: &Splat, step: f64, filter: Filter, tolerance: Tolerance) -> f64 {
    let [a, b, c] = expected.covariance;
    let size = a + c;
    let difference: f64 = got
        .covariance
        .iter()
        .zip([a, b, c])
        .map(|(got, expected)| (got - expected).abs())
        .fold(0.0, f64::max);
    [
        // Half a step of the fixed-point coordinate, and f32's arithmetic.
        got.center.distance(expected.center)
            / (0.75 * step + 1e-3 + 1e-6 * expected.center.length() + tolerance.center),
        // f16 axes: 2⁻¹¹ of each, doubled by squaring.
        difference / (2e-3 * size + tolerance.axes * (2.0 * size.sqrt() + tolerance.axes)),
        (got.opacity - expected.opacity).abs() / opacity_tolerance(filter, tolerance),
        // Half a step of ten bits.
        (got.color - expected.color).abs().max_element() / (0.5 / 1023.0 + tolerance.color),
    ]
    .into_iter()
    .fold(
        0.0,
        |worst, error| if error <= worst { worst } else { error },
    )
}

/// Whether the reference's decision hangs on less than the device can tell.
fn close_call(frame: &gpu::Frame, at: usize, cached: bool) -> bool {
    let by = if cached { [2e-4, 2e-1] } else { [1e-5, 2e-2] };
    if facing(frame, at, cached).is_some_and(|[fade, off]| fade.abs() < off) {
        return true;
    }
    let shifted = |sign: f64| {
        let camera = Camera {
            near: frame.camera.near + sign * by[0],
            center: frame.camera.center + sign * by[1],
            ..frame.camera
        };
        effigy_core::reference::project::project(
            &frame.reference.gaussians[at],
            &camera,
            frame.avatar.filter,
            frame.level,
        )
        .is_ok()
    };
    shifted(1.0) != shifted(-1.0)
}

/// Whether what compensation and facing leave of the opacity may round to what is too faint.
fn may_fade(frame: &gpu::Frame, at: usize, expected: &Splat, cached: bool) -> bool {
    let filter = frame.avatar.filter;
    let off = opacity_tolerance(filter, tolerance(frame, at, expected, cached));
    off > 1e-3 && expected.opacity - off <= 1.0 / 255.0
}

fn check(frame: &gpu::Frame) {
    check_all(frame, false);
}

fn check_all(frame: &gpu::Frame, cached: bool) {
    let grids = CenterGrids::of(frame.camera.size);
    for (at, expected) in frame.reference.splats.iter().enumerate() {
        let drawn = frame.gpu.keys[at] != SORT_CULLED;
        match expected {
            _ if close_call(frame, at, cached) => {}
            Ok(expected) if !drawn && may_fade(frame, at, expected, cached) => {}
            Ok(expected) => {
                assert!(drawn, "Gaussian {at} was culled, expected {expected:?}");
                // Rounding may decide which of two grids it is on.
                let step = grids.coarseness(1.001 * expected.center) / grids.steps;
                let error = error(
                    &unpack(frame.gpu.splats[at], &frame.camera),
                    expected,
                    step,
                    frame.avatar.filter,
                    tolerance(frame, at, expected, cached),
                );
                assert!(
                    error <= 1.0,
                    "Gaussian {at} is {error} times as far off as allowed from {expected:?}"
                );
            }
            Err(reason) => assert!(
                !drawn,
                "Gaussian {at} was drawn, expected it culled: {reason:?}"
            ),
        }
    }
    let visible = frame.gpu.keys[..frame.reference.splats.len()]
        .iter()
        .filter(|&&key| key != SORT_CULLED)
        .count();
    assert_eq!(
        frame.gpu.control.visible_count as usize, visible,
        "visible Gaussians"
    );
    check_reasons(frame, cached);
}

/// Every Gaussian that is not drawn is counted once, for the reference's reason but for those that
/// are too faint and whose centre is outside the image: whether they miss it may be looked at
/// before. The pose cache does not say why something has no shape.
fn check_reasons(frame: &gpu::Frame, cached: bool) {
    let counters = &frame.report.counters;
    let Some(got) = counters.reasons else { return };
    assert_eq!(
        got.outside + got.away + got.faint + got.degenerate + counters.skipped_by_detail,
        counters.culled
    );
    assert_eq!(
        (counters.gaussians - counters.skipped_by_detail) as usize,
        frame.reference.splats.len()
    );
    if cached {
        return;
    }
    let culled = frame
        .reference
        .splats
        .iter()
        .zip(&frame.reference.gaussians)
        .filter_map(|(splat, gaussian)| Some((splat.as_ref().err()?, gaussian)));
    let mut expected = CullReasons::default();
    let mut either = 0;
    for (reason, gaussian) in culled {
        let count = match reason {
            Culled::Faint => {
                either += u64::from(!is_inside(gaussian, &frame.camera));
                &mut expected.faint
            }
            Culled::Behind | Culled::Outside => &mut expected.outside,
            Culled::Away => &mut expected.away,
            Culled::Invalid => &mut expected.degenerate,
        };
        *count += 1;
    }
    let close = (0..frame.reference.splats.len())
        .filter(|&at| {
            let splat = &frame.reference.splats[at];
            let may_fade = splat.as_ref().is_ok_and(|s| may_fade(frame, at, s, false));
            may_fade || close_call(frame, at, false)
        })
        .count() as u64
        + either;
    for (got, expected) in [
        (got.outside, expected.outside),
        (got.away, expected.away),
        (got.degenerate, expected.degenerate),
        (got.faint, expected.faint),
    ] {
        assert!(
            got.abs_diff(expected) <= close,
            "{got} counted, {expected} expected, {close} hang on less than f32 can tell"
        );
    }
}

/// Whether a Gaussian's centre is in the image.
fn is_inside(gaussian: &Gaussian, camera: &Camera) -> bool {
    let at = camera.project(camera.view.transform_point3(gaussian.mean));
    at.cmpge(DVec2::ZERO).all() && at.cmple(DVec2::from(camera.size.map(f64::from))).all()
}

/// Avatars are drawn wherever they are. Of every other seed nothing is left out as a whole, and all
/// that is left out is counted.
fn options(seed: u64, size: [u32; 2]) -> RendererOptions {
    let skip = Skip::all() - Skip::AVATARS;
    let count = seed.is_multiple_of(2);
    RendererOptions {
        count,
        skip: if count { skip - Skip::PARTS } else { skip },
        ..gpu::options(size)
    }
}

fn compare() {
    let device = gpu::gpu();
    let sizes = [
        Sizes::default(),
        Sizes {
            split_features: true,
            rows: 3000,
            basis: 32,
            ..Sizes::default()
        },
        Sizes {
            gaussians: 65,
            rows: 0,
            nodes: 1,
            parts: 1,
            joints: 1,
            ..Sizes::default()
        },
        Sizes {
            gaussians: 1,
            rows: 1,
            nodes: 1,
            parts: 1,
            ..Sizes::default()
        },
    ];
    for (seed, sizes) in (0..).zip(sizes) {
        // Every Gaussian, and every second, fourth or eighth.
        for level in [0, [1, 2, 3, 1][seed as usize]] {
            let options = RendererOptions {
                ..options(seed, [500, 300])
            };
            let options = gpu::at_level(options, level);
            let avatar = common::avatar(seed, sizes);
            let avatar = if level == 0 {
                common::faced(avatar)
            } else {
                avatar
            };
            check(&gpu::frame_of(&device, avatar, seed, options));
        }
    }
}

/// The words of a Gaussian's nodes are cut elsewhere for each of these numbers of nodes.
fn gaussians_follow_nodes_however_many_there_are() {
    let device = gpu::gpu();
    for (seed, nodes) in (0..).zip([4096, 5000, 10_000, 20_000, 40_000]) {
        let sizes = Sizes {
            gaussians: 2000,
            rows: 20,
            basis: 4,
            nodes,
            ..Sizes::default()
        };
        let frame = gpu::frame(&device, seed, sizes, options(seed, [500, 300]));
        let followed = frame.avatar.gaussians.node.iter().flatten();
        let last = usize::from(followed.max().copied().unwrap_or_default());
        let highest_bit = nodes.next_power_of_two() / 2;
        assert!(
            last >= highest_bit,
            "the last node that one follows: {last}"
        );
        check(&frame);
    }
}

/// What a packed file holds is drawn as it is: the reference's numbers are those of the file.
fn packed_avatars_land_where_the_reference_puts_them() {
    let device = gpu::gpu();
    let sizes = [
        Sizes {
            rows: 1500,
            ..Sizes::default()
        },
        Sizes {
            split_features: true,
            rows: 3000,
            basis: 8,
            ..Sizes::default()
        },
    ];
    for ((seed, sizes), quality) in (0..)
        .zip(sizes)
        .zip([PackQuality::High, PackQuality::Small])
    {
        let packed = common::avatar(seed, sizes).packed(quality);
        let read = Avatar::from_bytes(&packed.to_packed_bytes().unwrap()).unwrap();
        let held = read.compact();
        assert!(
            held.gaussians == read.gaussians,
            "{quality:?}: the device rounds what the file has rounded"
        );
        assert!(
            held.rotation_rows == read.rotation_rows && held.scale_rows == read.scale_rows,
            "{quality:?}: another row"
        );
        assert!(
            held.color_rows == read.color_rows && held.nodes == read.nodes,
            "{quality:?}: another row"
        );
        check(&gpu::frame_of(
            &device,
            read,
            seed,
            options(seed, [500, 300]),
        ));
    }
}

fn every_gaussian_lands_where_the_reference_puts_it() {
    compare();
}

/// An avatar with adversarial Gaussians: faint, opaque, needles and sheets, zero-ish and huge.
fn adversarial(seed: u64) -> Avatar {
    let mut avatar = common::avatar(seed, Sizes::default());
    let g = &mut avatar.gaussians;
    for i in 0..g.len() {
        match i % 8 {
            0 => g.opacity[i] = (i / 8 % 4) as u8,
            1 => g.opacity[i] = 255,
            2 => g.log_scale[i] = [-2.0, -11.0, -11.0].map(f16::from_f64),
            3 => g.log_scale[i] = [-2.0, -2.0, -11.0].map(f16::from_f64),
            4 => g.log_scale[i] = [-15.0; 3].map(f16::from_f64),
            5 => g.log_scale[i] = [0.5; 3].map(f16::from_f64),
            6 => g.color[i] = [-3.0, 0.5, 7.0].map(f16::from_f64),
            _ => g.rotation[i] = [1e-3, 0.0, 2e-3, 0.0].map(f16::from_f64),
        }
    }
    avatar
}

/// Distance from the avatar's middle and field of view: from outside, from within, turned away, far
/// off, wide, and narrow.
const CAMERAS: [(f64, f64); 6] = [
    (2.5, 0.7),
    (0.05, 1.2),
    (-1.0, 0.7),
    (300.0, 0.02),
    (1.0, 2.8),
    (2.5, 0.1),
];

fn adversarial_gaussians_and_cameras_agree_too() {
    let device = gpu::gpu();
    for seed in 0..2 {
        let avatar = adversarial(seed);
        let posed = Posed::new(&avatar, &common::pose(seed, &avatar));
        let [min, max] = effigy_core::scene::AvatarBounds::new(&avatar).bounds(&posed.joints);
        let target = (min + max) / 2.0;
        for (distance, fov) in CAMERAS {
            let camera = Camera::orbit(target, 0.3, 0.1, distance, fov, [300, 200]);
            check(&gpu::draw(
                &device,
                common::faced(avatar.clone()),
                posed.clone(),
                camera,
                gpu::at_level(options(seed, [300, 200]), seed as u32),
            ));
        }
    }
}

/// Gaussians of all sizes, many of them under a pixel, with filters of the avatar and of the options.
/// The second frame of each is drawn from the pose cache.
fn filters_are_those_of_the_reference() {
    let device = gpu::gpu();
    let cases = [
        (0.1, true, 0, [300, 200]),
        (0.3, true, 2, [40, 30]),
        (10.0, false, 0, [40, 30]),
    ];
    for (seed, (variance, compensated, level, size)) in (0..).zip(cases) {
        let filter = Filter {
            variance,
            compensated,
        };
        let mut avatar = if seed % 2 == 0 {
            common::avatar(seed, Sizes::default())
        } else {
            adversarial(seed)
        };
        let mut options = gpu::at_level(options(2 * seed, size), level);
        if level == 0 {
            avatar.filter = filter;
        } else {
            options.filter = Some(filter);
        }
        let posed = Posed::new(&avatar, &common::pose(seed, &avatar));
        let camera = gpu::camera(&avatar, &posed, size);
        check(&gpu::draw(
            &device,
            avatar.clone(),
            posed.clone(),
            camera,
            options,
        ));
        let turned = |by: f64| Camera {
            view: DAffine3::from_translation(DVec3::new(by, 0.0, 0.0)) * camera.view,
            ..camera
        };
        let before = [turned(0.05), turned(0.02)];
        let frame = gpu::draw_after(&device, avatar, posed, &before, camera, options);
        assert!(frame.report.counters.cached > 0);
        check_all(&frame, true);
        let splats = frame.reference.splats.iter();
        let faded = splats
            .zip(&frame.reference.gaussians)
            .filter(|(splat, gaussian)| match splat {
                Ok(splat) => 255.0 * splat.opacity < 0.9 * f64::from(gaussian.opacity),
                Err(reason) => *reason == Culled::Faint && gaussian.opacity > 1,
            })
            .count();
        assert_eq!(faded > 10, compensated, "{faded} are fainter with {filter}");
    }
}

/// Gaussians so small that the low-pass is all there is of them: what is left of the difference
/// between their axes has squares that f32 can't hold, and must not change how long the axes are.
fn gaussians_of_no_size_are_as_large_as_the_low_pass() {
    let mut avatar = common::avatar(2, Sizes::default());
    avatar.gaussians.log_scale.fill([f16::from_f64(-16.0); 3]);
    let posed = Posed::new(&avatar, &common::pose(2, &avatar));
    let low_pass = avatar.filter.variance;
    let size = [300, 200];
    for distance in [100.0, 300.0, 1000.0, 3000.0] {
        let camera = Camera::orbit(DVec3::Y, 0.3, 0.1, distance, 0.7, size);
        let frame = gpu::draw(
            &gpu::gpu(),
            avatar.clone(),
            posed.clone(),
            camera,
            options(0, size),
        );
        let drawn =
            (0..frame.reference.splats.len()).filter(|&at| frame.gpu.keys[at] != SORT_CULLED);
        let drawn: Vec<usize> = drawn.collect();
        assert!(drawn.len() > 1000, "{} are drawn", drawn.len());
        for at in drawn {
            let [a, b, c] = unpack(frame.gpu.splats[at], &frame.camera).covariance;
            let off = (a - low_pass).abs().max(b.abs()).max((c - low_pass).abs());
            // Twice a step of f16 of each length, which is 2⁻¹⁰ of it.
            assert!(
                off <= 0.004 * low_pass,
                "Gaussian {at} has [{a}, {b}, {c}] for {low_pass} px² at {distance} m"
            );
        }
    }
}

/// The third frame of a still body draws from the pose cache that the second wrote.
fn splats_from_the_pose_cache_agree_with_the_reference() {
    let device = gpu::gpu();
    let avatars = [
        (common::faced(common::avatar(1, Sizes::default())), 1.0),
        (adversarial(1), 1.0),
        (common::faced(adversarial(0)), 1e-3),
        (adversarial(0), 500.0),
    ];
    for ((avatar, scale), level) in avatars.into_iter().zip([0, 0, 1, 2]) {
        let mut posed = Posed::new(&avatar, &common::pose(3, &avatar));
        let placed = DAffine3::from_scale_rotation_translation(
            DVec3::splat(scale),
            DQuat::from_rotation_x(1.0),
            DVec3::new(40.0, -7.0, 90.0) * scale,
        );
        posed
            .joints
            .iter_mut()
            .for_each(|joint| *joint = placed * *joint);
        let [min, max] = effigy_core::scene::AvatarBounds::new(&avatar).bounds(&posed.joints);
        let camera = |yaw, distance| {
            let camera = Camera::orbit(
                (min + max) / 2.0,
                yaw,
                0.1,
                distance * scale,
                0.7,
                [300, 200],
            );
            Camera {
                near: camera.near * scale,
                ..camera
            }
        };
        for distance in [2.5, 0.4] {
            let before = [camera(0.3, 3.0), camera(0.8, 3.0)];
            let frame = gpu::draw_after(
                &device,
                avatar.clone(),
                posed.clone(),
                &before,
                camera(2.0, distance),
                gpu::at_level(options(0, [300, 200]), level),
            );
            assert_eq!(
                frame.report.counters.cached,
                u64::from(detail::gaussian_count(avatar.gaussians.len() as u32, level))
            );
            check_all(&frame, true);
        }
    }
}

fn each_reason_to_cull_occurs_in_the_adversarial_frames() {
    let avatar = common::faced(adversarial(0));
    let posed = Posed::new(&avatar, &common::pose(0, &avatar));
    let [min, max] = effigy_core::scene::AvatarBounds::new(&avatar).bounds(&posed.joints);
    let seen = CAMERAS.map(|(distance, fov)| {
        let camera = Camera::orbit((min + max) / 2.0, 0.3, 0.1, distance, fov, [300, 200]);
        effigy_core::reference::ReferenceFrame::new(&avatar, &posed, &camera).splats
    });
    for reason in [Culled::Behind, Culled::Away, Culled::Faint, Culled::Outside] {
        assert!(
            seen.iter()
                .flatten()
                .any(|splat| splat.as_ref().err() == Some(&reason)),
            "no Gaussian is {reason:?}"
        );
    }
}

tests! {
    packed_avatars_land_where_the_reference_puts_them,
    every_gaussian_lands_where_the_reference_puts_it: smoke,
    gaussians_follow_nodes_however_many_there_are,
    adversarial_gaussians_and_cameras_agree_too,
    splats_from_the_pose_cache_agree_with_the_reference,
    gaussians_of_no_size_are_as_large_as_the_low_pass,
    filters_are_those_of_the_reference,
    each_reason_to_cull_occurs_in_the_adversarial_frames: no_device,
}
