//! The `splats` stage against the reference, element by element: what is culled, and every number of what is not.

mod common;

use common::{Sizes, gpu};
use effigy::{
    avatar::Avatar,
    frame::{Camera, Posed, Reasons, Skip},
    layout::{POSITION_BITS, SORT_DROPPED},
    reference::{Culled, Gaussian, Splat},
    vulkan::{GpuOptions, RendererOptions, block::fixed_scale},
};
use glam::{DVec2, DVec3};
use half::f16;

/// A splat as its 16 bytes say it.
struct Unpacked {
    center: DVec2,
    covariance: [f64; 3],
    opacity: f64,
    color: DVec3,
}

fn unpack(words: [u32; 4], camera: &Camera) -> Unpacked {
    let mask = (1 << POSITION_BITS) - 1;
    let center = DVec2::new(f64::from(words[0] & mask), f64::from(words[1] & mask)) / fixed_scale(camera.guard()) - camera.guard();
    let half = |bits: u32| f16::from_bits(bits as u16).to_f64();
    let (axis, shorter) = (DVec2::new(half(words[2] & 0xffff), half(words[2] >> 16)), half(words[3] & 0xffff));
    let across = axis.normalize().perp() * shorter;
    let blue = words[3] >> 24 << 2 | words[0] >> 30;
    let color = [words[0] >> POSITION_BITS & 1023, words[1] >> POSITION_BITS & 1023, blue].map(|c| f64::from(c) / 1023.0);
    Unpacked {
        center,
        covariance: [axis.x * axis.x + across.x * across.x, axis.x * axis.y + across.x * across.y, axis.y * axis.y + across.y * across.y],
        opacity: f64::from(words[3] >> 16 & 0xff) / 255.0,
        color: DVec3::from(color),
    }
}

/// How far a splat may be from the reference's on account of its nodes' weights, which the device has in 31sts, px.
fn node_room(frame: &gpu::Frame, at: usize, expected: &Splat) -> f64 {
    let [a, b, c] = frame.avatar.gaussians.node[at].map(|node| frame.oracle.nodes[usize::from(node)]);
    let apart = a.distance(c) + b.distance(c);
    let enlarged = effigy::frame::extent::enlargement(&frame.posed.joints);
    // Half a step each. On the screen: nearer the border lengths seem longer.
    let slope = (expected.center - frame.camera.center) / frame.camera.focal;
    0.5 / 31.0 * apart * enlarged * frame.camera.focal.max_element() / expected.depth * (1.0 + slope.length())
}

/// How far a splat is from the reference's, each number as a share of what is allowed.
fn error(got: &Unpacked, expected: &Splat, step: f64, room: f64) -> f64 {
    let [a, b, c] = expected.covariance;
    let size = a + c;
    let difference: f64 = got.covariance.iter().zip([a, b, c]).map(|(got, expected)| (got - expected).abs()).fold(0.0, f64::max);
    [
        // Half a step of the fixed-point coordinate, and f32's arithmetic.
        got.center.distance(expected.center) / (0.75 * step + 1e-3 + room),
        // f16 axes: 2⁻¹¹ of each, doubled by squaring.
        difference / (2e-3 * size),
        (got.opacity - expected.opacity).abs() / 1e-6,
        // Half a step of ten bits.
        (got.color - expected.color).abs().max_element() / (0.5 / 1023.0 + 1e-5),
    ]
    .into_iter()
    .fold(0.0, |worst, error| if error <= worst { worst } else { error })
}

/// Whether the reference's verdict hangs on less than f32 can tell.
fn close_call(frame: &gpu::Frame, at: usize) -> bool {
    let shifted = |sign: f64| {
        let camera = Camera { near: frame.camera.near + sign * 1e-5, center: frame.camera.center + sign * 2e-2, ..frame.camera };
        effigy::reference::splats::project(&frame.oracle.gaussians[at], &camera).is_ok()
    };
    shifted(1.0) != shifted(-1.0)
}

fn check(frame: &gpu::Frame) {
    let step = 1.0 / fixed_scale(frame.camera.guard());
    for (at, expected) in frame.oracle.splats.iter().enumerate() {
        let drawn = frame.gpu.keys[at] != SORT_DROPPED;
        match expected {
            _ if close_call(frame, at) => {}
            Ok(expected) => {
                assert!(drawn, "Gaussian {at} was culled, expected {expected:?}");
                let error = error(&unpack(frame.gpu.splats[at], &frame.camera), expected, step, node_room(frame, at, expected));
                assert!(error <= 1.0, "Gaussian {at} is {error} times as far off as allowed from {expected:?}");
            }
            Err(reason) => assert!(!drawn, "Gaussian {at} was drawn, expected it culled: {reason:?}"),
        }
    }
    let survivors = frame.gpu.keys.iter().filter(|&&key| key != SORT_DROPPED).count();
    assert_eq!(frame.gpu.control.survivors as usize, survivors, "survivors");
    check_reasons(frame);
}

/// Every Gaussian that is not drawn is counted once, for the reference's reason but for those that are too faint: whether their centres
/// are anywhere near the picture is looked at before.
fn check_reasons(frame: &gpu::Frame) {
    let counters = &frame.report.counters;
    let Some(got) = counters.reasons else { return };
    assert_eq!(got.outside + got.hidden + got.faint + got.degenerate, counters.culled);
    let culled =
        frame.oracle.splats.iter().zip(&frame.oracle.gaussians).filter_map(|(splat, gaussian)| Some((splat.as_ref().err()?, gaussian)));
    let mut expected = Reasons::default();
    for (reason, gaussian) in culled {
        let count = match reason {
            Culled::Faint if near_the_picture(gaussian, &frame.camera) => &mut expected.faint,
            Culled::Behind | Culled::Guard | Culled::Outside | Culled::Faint => &mut expected.outside,
            Culled::Invalid => &mut expected.degenerate,
        };
        *count += 1;
    }
    let close = (0..frame.oracle.splats.len()).filter(|&at| close_call(frame, at)).count() as u64;
    for (got, expected) in [(got.outside, expected.outside), (got.degenerate, expected.degenerate), (got.faint, expected.faint)] {
        assert!(got.abs_diff(expected) <= close, "{got} counted, {expected} expected, {close} hang on less than f32 can tell");
    }
    assert_eq!(got.hidden, 0);
}

fn near_the_picture(gaussian: &Gaussian, camera: &Camera) -> bool {
    let at = camera.project(camera.view.transform_point3(gaussian.mean));
    let size = DVec2::from(camera.size.map(f64::from));
    (at + camera.guard()).min_element() >= 0.0 && (size + camera.guard() - at).min_element() >= 0.0
}

/// Avatars are drawn wherever they are. Of every other seed nothing is left out as a whole, and all that is left out is counted.
fn options(seed: u64, size: [u32; 2]) -> RendererOptions {
    let skip = Skip::all() - Skip::AVATARS - Skip::HIDDEN;
    let count = seed.is_multiple_of(2);
    RendererOptions { count, skip: if count { skip - Skip::PARTS } else { skip }, ..gpu::options(size) }
}

fn compare(device: GpuOptions) {
    let Some(device) = gpu::open(device) else { return };
    let sizes = [
        Sizes::default(),
        Sizes { split_features: true, rows: 3000, basis: 32, ..Sizes::default() },
        Sizes { gaussians: 65, rows: 0, nodes: 1, parts: 1, joints: 1, ..Sizes::default() },
        Sizes { gaussians: 1, rows: 1, nodes: 1, parts: 1, ..Sizes::default() },
    ];
    for (seed, sizes) in (0..).zip(sizes) {
        check(&gpu::frame(&device, seed, sizes, options(seed, [500, 300])));
    }
    gpu::assert_valid();
}

#[test]
fn every_gaussian_lands_where_the_reference_puts_it() {
    compare(GpuOptions::headless(None));
}

#[test]
fn packed_words_give_the_same_as_halves() {
    compare(GpuOptions { packed_words: true, ..GpuOptions::headless(None) });
}

/// An avatar with hostile Gaussians: faint, opaque, needles and sheets, zero-ish and huge.
fn hostile(seed: u64) -> Avatar {
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

/// Distance from the avatar's middle and field of view: from outside, from within, turned away, far off, wide, and narrow.
const CAMERAS: [(f64, f64); 6] = [(2.5, 0.7), (0.05, 1.2), (-1.0, 0.7), (300.0, 0.02), (1.0, 2.8), (2.5, 0.1)];

#[test]
fn hostile_gaussians_and_cameras_agree_too() {
    let Some(device) = gpu::gpu() else { return };
    for seed in 0..2 {
        let avatar = hostile(seed);
        let posed = Posed::new(&avatar, &common::pose(seed, &avatar));
        let [min, max] = effigy::frame::Extent::new(&avatar).bounds(&posed.joints);
        let target = (min + max) / 2.0;
        for (distance, fov) in CAMERAS {
            let camera = Camera::orbit(target, 0.3, 0.1, distance, fov, [300, 200]);
            check(&gpu::draw(&device, avatar.clone(), posed.clone(), camera, options(seed, [300, 200])));
        }
    }
    gpu::assert_valid();
}

#[test]
fn each_reason_to_cull_occurs_in_the_hostile_frames() {
    let avatar = hostile(0);
    let posed = Posed::new(&avatar, &common::pose(0, &avatar));
    let [min, max] = effigy::frame::Extent::new(&avatar).bounds(&posed.joints);
    let seen = CAMERAS.map(|(distance, fov)| {
        let camera = Camera::orbit((min + max) / 2.0, 0.3, 0.1, distance, fov, [300, 200]);
        effigy::reference::Stages::new(&avatar, &posed, &camera).splats
    });
    for reason in [Culled::Behind, Culled::Faint, Culled::Guard, Culled::Outside] {
        assert!(seen.iter().flatten().any(|splat| splat.as_ref().err() == Some(&reason)), "no Gaussian is {reason:?}");
    }
}
