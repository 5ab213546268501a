//! What each family does to a harmless case.

use super::{
    body::{self, Sizes, below, vector},
    case::{Case, Draft, placement},
    family::Family,
};
use crate::{
    avatar::{Avatar, Bounds, Layer, Pose},
    bake::math::Random,
    frame::{Camera, Posed},
    reference::splats::Gaussian,
    vulkan::RendererOptions,
};
use glam::{DAffine3, DMat3, DVec2, DVec3};
use half::f16;
use std::f64::consts::PI;

/// One of some values.
fn any<T: Copy>(random: &mut Random, values: &[T]) -> T {
    values[below(random, values.len())]
}

fn half(value: f64) -> f16 {
    f16::from_f64(value)
}

/// Makes a draft as hard as its family is.
pub fn apply(random: &mut Random, draft: &mut Draft, family: Family, large: bool) {
    match family {
        Family::Poses => poses(random, draft),
        Family::Solid => solid(random, draft),
        Family::Placed => draft.placed = placement(random),
        Family::Distant => distant(random, draft),
        Family::Quaternions => quaternions(random, &mut draft.avatar),
        Family::Needles => needles(random, draft),
        Family::SubPixel => sub_pixel(random, &mut draft.avatar),
        Family::ScreenFilling => screen_filling(random, draft),
        Family::Opacity => draft.avatar.gaussians.opacity.iter_mut().for_each(|opacity| *opacity = any(random, &[0, 1, 2, 3, 254, 255])),
        Family::Colors => colors(random, &mut draft.avatar),
        Family::Overflow => overflow(random, draft),
        Family::Sizes => sizes(random, draft, large),
        Family::Views => views(random, draft),
        Family::Mixed => mixed(random, draft),
        Family::Inside | Family::NearPlane | Family::Refused => {}
    }
}

fn poses(random: &mut Random, draft: &mut Draft) {
    let reach = any(random, &[PI, PI + 1e-9, 2.0 * PI, 30.0, 62_831.0]);
    draft.note = format!("joints turned by up to {reach}");
    let angle = |random: &mut Random| if below(random, 3) == 0 { reach } else { random.range(0.0, reach) };
    draft.pose.rotation.iter_mut().for_each(|rotation| *rotation = random.direction() * angle(random));
    draft.pose.expression.iter_mut().for_each(|e| *e = random.range(-1.0, 1.0) * 10f64.powi(below(random, 4) as i32));
}

fn distant(random: &mut Random, draft: &mut Draft) {
    let distance = 10f64.powf(random.range(0.0, 2.6));
    draft.note = format!("{distance:.0} times as far as would show all of it, through a lens that shows it");
    // The same picture from further away.
    (draft.fov, draft.distance) = (2.0 * ((0.5 * draft.fov).tan() / distance).atan(), 1.0);
}

fn quaternions(random: &mut Random, avatar: &mut Avatar) {
    let (g, basis) = (&mut avatar.gaussians, avatar.nodes.basis.len() / (3 * avatar.nodes.position.len()));
    for i in 0..g.rotation.len() {
        let scale = any(random, &[1.0, 6e-8, 1e-6, 1e-3, 3e4]);
        g.rotation[i] = g.rotation[i].map(|v| half((v.to_f64() * scale).clamp(-65504.0, 65504.0)));
        if g.rotation[i].iter().all(|v| v.to_f64() == 0.0) {
            g.rotation[i][below(random, 4)] = f16::MIN_POSITIVE_SUBNORMAL;
        }
    }
    for (row, &i) in avatar.rotation_rows.gaussian.iter().enumerate() {
        let size = any(random, &[0.0, 1.0, 1e-3, 100.0]);
        let row = &mut avatar.rotation_rows.basis.halves_mut()[row * 4 * basis..][..4 * basis];
        row.iter_mut().for_each(|v| *v = half(v.to_f64() * size));
        if below(random, 4) == 0 {
            // With features of 1, what remains of the quaternion is nothing or next to it.
            let left = any(random, &[0.0, 1e-4, 0.1]);
            row.iter_mut().for_each(|v| *v = f16::ZERO);
            (0..4).for_each(|k| row[k * basis] = half(-(1.0 - left) * g.rotation[i as usize][k].to_f64()));
        }
    }
    // Features are their biases, which are 1: rows can be made to cancel quaternions.
    if let Some(Layer { weight, bias, .. }) = avatar.networks.layers.last_mut() {
        weight.halves_mut().fill(f16::ZERO);
        bias.fill(f16::ONE);
    }
}

fn needles(random: &mut Random, draft: &mut Draft) {
    let long = 10f64.powf(random.range(-2.0, 0.3));
    draft.note = format!("up to {long:.3} m long and {:.1e} m thick", long * 1e-4);
    for scale in &mut draft.avatar.gaussians.log_scale {
        let (long, thin) = (half((long * random.range(0.3, 1.0)).ln()), half((long * 1e-4).ln()));
        let turn = below(random, 3);
        *scale = if below(random, 2) == 0 { [long, thin, thin] } else { [long, long, thin] };
        scale.rotate_right(turn);
    }
}

fn sub_pixel(random: &mut Random, avatar: &mut Avatar) {
    let size = any(random, &[1e-4, 1e-6, 1e-20, 0.0]);
    avatar.gaussians.log_scale.iter_mut().for_each(|s| *s = [half(f64::max((size * random.range(0.1, 1.0)).ln(), -65504.0)); 3]);
}

fn screen_filling(random: &mut Random, draft: &mut Draft) {
    let sizes = Sizes { gaussians: 20 + below(random, 60), rows: 10, ..draft.sizes };
    *draft = Draft::of(random, sizes);
    let largest: f64 = any(random, &[0.3, 3.0, 1e3, 1e6, 1e30, 1e300]);
    draft.note = format!("{} Gaussians of up to {largest:e} m", sizes.gaussians);
    for scale in &mut draft.avatar.gaussians.log_scale {
        let size = largest.ln() * random.range(0.5, 1.0);
        *scale = [half(size); 3].map(|s| if below(random, 3) == 0 { half(s.to_f64() - 3.0) } else { s });
    }
    draft.avatar.gaussians.opacity.iter_mut().for_each(|o| *o = (*o / 3).max(2));
}

fn colors(random: &mut Random, avatar: &mut Avatar) {
    let color = |random: &mut Random| half(any(random, &[-65504.0, -3.0, 0.0, 0.5, 1.0, 1.001, 7.0, 65504.0]));
    avatar.gaussians.color.iter_mut().for_each(|c| *c = std::array::from_fn(|_| color(random)));
    let size = any(random, &[1.0, 1e3]);
    avatar.color_rows.basis.halves_mut().iter_mut().for_each(|v| *v = half(v.to_f64() * size));
}

fn overflow(random: &mut Random, draft: &mut Draft) {
    let (sizes, what) = (draft.sizes, any(random, &["weights", "biases", "bases", "everything"]));
    let deep = Sizes { hidden: [below(random, 7), 4 * (1 + below(random, 32))], gaussians: sizes.gaussians.min(400), rows: 100, ..sizes };
    *draft = Draft::of(random, deep);
    draft.note = format!("{what} at f16's largest, {} hidden layers of {}", deep.hidden[0], deep.hidden[1]);
    let all = what == "everything";
    let mut blow = |values: &mut [f16], share: f64| {
        for value in values.iter_mut().filter(|_| random.uniform() < share) {
            *value = if *value < f16::ZERO { f16::MIN } else { f16::MAX };
        }
    };
    for layer in &mut draft.avatar.networks.layers {
        if all || what == "weights" {
            blow(layer.weight.halves_mut(), 0.9);
        }
        if all || what == "biases" {
            blow(&mut layer.bias, 0.9);
        }
    }
    if all || what == "bases" {
        blow(draft.avatar.nodes.basis.halves_mut(), 0.01);
        blow(draft.avatar.rotation_rows.basis.halves_mut(), 0.2);
        blow(draft.avatar.scale_rows.basis.halves_mut(), 0.2);
        blow(draft.avatar.color_rows.basis.halves_mut(), 0.2);
    }
    draft.pose.expression.iter_mut().for_each(|e| *e *= 1e30);
}

/// Puts the camera at a Gaussian or between two, looking anywhere.
pub fn inside(random: &mut Random, gaussians: &[Gaussian], camera: Camera) -> Camera {
    let [a, b] = [0; 2].map(|_| gaussians[below(random, gaussians.len())].mean);
    let between = random.uniform();
    let eye = a.lerp(b, any(random, &[0.0, 0.5, between]));
    let fov = 2.0 * (0.5 * f64::from(camera.size[1]) / camera.focal.y).atan();
    Camera { near: camera.near * any(random, &[1.0, 0.1]), ..Camera::look_at(eye, eye + random.direction(), fov, camera.size) }
}

fn sizes(random: &mut Random, draft: &mut Draft, large: bool) {
    let small = Sizes { gaussians: 20 + below(random, 200), rows: 10, ..draft.sizes };
    *draft = Draft::of(random, small);
    let side = random.range(0.0, 5.0).exp2() as u32;
    let long = any(random, &[1024, 4096, 8191, 8192]);
    draft.size = any(random, &[[1, 1], [1, side], [side, 1], [side, side + 1], [long, 1], [1, long], [long, side], [side, long]]);
    if large && below(random, 8) == 0 {
        draft.size = [8192; 2];
    }
    draft.note = format!("{} × {} px", draft.size[0], draft.size[1]);
}

fn views(random: &mut Random, draft: &mut Draft) {
    let (narrow, wide) = (random.range(1.0, 10.0), random.range(120.0, 170.0));
    let degrees: f64 = any(random, &[1.0, 170.0, narrow, wide]);
    draft.note = format!("{degrees:.1}° high");
    draft.fov = degrees.to_radians();
    draft.distance = any(random, &[1.0, 0.2, 0.05]);
}

fn mixed(random: &mut Random, draft: &mut Draft) {
    let mut notes = vec![];
    for family in [Family::ScreenFilling, Family::Needles, Family::SubPixel, Family::Colors, Family::Opacity, Family::Quaternions] {
        if random.uniform() < 0.3 {
            apply(random, draft, family, false);
            notes.push(family.name());
        }
    }
    for family in [Family::Poses, Family::Placed, Family::Views, Family::Distant] {
        if random.uniform() < 0.4 {
            apply(random, draft, family, false);
            notes.push(family.name());
        }
    }
    draft.note = notes.join(", ");
}

fn solid(random: &mut Random, draft: &mut Draft) {
    let mut sizes = draft.sizes;
    sizes.gaussians = 3000 + 2 * sizes.gaussians;
    *draft = Draft { avatar: body::solid(random, &sizes), sizes, ..Draft::of(random, sizes) };
    draft.note = format!("{} Gaussians on an ellipsoid", sizes.gaussians);
}

/// Gaussians exactly on the near plane, and one step before and behind it, where every number on the way to their depth is exact in
/// f32: a box of steps of 2⁻¹⁴ m, one joint that stays where it is, a camera that looks along an axis.
pub fn near_plane(random: &mut Random, number: u64, options: RendererOptions) -> Case {
    const STEP: f64 = 1.0 / 16384.0;
    let sizes = Sizes { gaussians: 60, parts: 1, joints: 1, rows: 0, ..Sizes::any(random) };
    let mut avatar = body::avatar(random, &sizes);
    let width = (65535.0 * STEP) as f32;
    avatar.gaussians.bounds = Bounds { min: [-2.0; 3], max: [width - 2.0; 3] };
    avatar.nodes.offset.iter_mut().for_each(|offset| *offset = [f16::ZERO; 3]);
    avatar.nodes.basis.halves_mut().fill(f16::ZERO);
    avatar.skeleton.canonical = vec![[0.0; 3]];
    avatar.skeleton.rest = vec![[0.0; 3]];
    let near = any(random, &[0.125, 0.25, 1.0]);
    for (position, at) in avatar.gaussians.position.iter_mut().zip(0..) {
        // The camera stands at z = 1 and looks along −z.
        let depth = near + STEP * f64::from(at % 3 - 1);
        let point = DVec3::new(random.range(-0.4, 0.4) * near, random.range(-0.4, 0.4) * near, 1.0 - depth);
        *position = ((point + 2.0) / STEP).round().to_array().map(|q| q as u16);
    }
    avatar.gaussians.log_scale.iter_mut().for_each(|s| *s = [half((0.03 * near).ln()); 3]);
    let pose = Pose::rest(1, sizes.expression);
    let [width, height] = options.size.map(f64::from);
    let view = DAffine3::from_mat3_translation(DMat3::from_diagonal(DVec3::new(1.0, -1.0, -1.0)), DVec3::Z);
    let camera = Camera { view, focal: DVec2::splat(width), center: DVec2::new(0.5 * width, 0.5 * height), size: options.size, near };
    let (placed, note) = (DAffine3::IDENTITY, format!("a third of the Gaussians at {near} m, {STEP:.1e} m less and more"));
    Case { number, family: Family::NearPlane, note, posed: Posed::new(&avatar, &pose), avatar, pose, placed, camera, options }
}

/// Any number that can't be drawn.
pub fn not_finite(random: &mut Random) -> f64 {
    any(random, &[f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300])
}

/// A place that nothing can be seen from.
pub fn nowhere(random: &mut Random) -> DVec3 {
    let mut place = vector(random, 1.0);
    place[below(random, 3)] = not_finite(random);
    place
}
