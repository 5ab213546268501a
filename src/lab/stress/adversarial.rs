//! Makes harmless drafts hard, in the way of each category.

use super::{
    body::{self, BodySizes, below, vector},
    category::Category,
    draft::{Draft, placement},
};
use effigy_core::{
    avatar::{Avatar, Bounds, NetworkLayer, Pose},
    random::Random,
    reference::project::Gaussian,
    scene::Camera,
};
use glam::{DAffine3, DMat3, DQuat, DVec2, DVec3};
use half::f16;
use std::f64::consts::PI;

/// A random one of some values.
fn any<T: Copy>(random: &mut Random, values: &[T]) -> T {
    values[below(random, values.len())]
}

fn half(value: f64) -> f16 {
    f16::from_f64(value)
}

/// Makes a draft as hard as a category says. `large` allows images of 8192 × 8192 px.
pub fn apply(random: &mut Random, draft: &mut Draft, category: Category, large: bool) {
    match category {
        Category::Poses => poses(random, draft),
        Category::Solid => solid(random, draft),
        Category::Torn => torn(random, draft),
        Category::Placed => draft.placed = placement(random),
        Category::Distant => distant(random, draft),
        Category::Quaternions => quaternions(random, &mut draft.avatar),
        Category::Needles => needles(random, draft),
        Category::SubPixel => sub_pixel(random, &mut draft.avatar),
        Category::ScreenFilling => screen_filling(random, draft),
        Category::Opacity => opacities(random, &mut draft.avatar),
        Category::Colors => colors(random, &mut draft.avatar),
        Category::Overflow => overflow(random, draft),
        Category::Sizes => sizes(random, draft, large),
        Category::Views => views(random, draft),
        Category::Mixed => mixed(random, draft),
        Category::Inside | Category::NearPlane | Category::Refused => {}
    }
}

fn opacities(random: &mut Random, avatar: &mut Avatar) {
    for opacity in &mut avatar.gaussians.opacity {
        *opacity = any(random, &[0, 1, 2, 3, 254, 255]);
    }
}

fn poses(random: &mut Random, draft: &mut Draft) {
    let max_angle = any(random, &[PI, PI + 1e-9, 2.0 * PI, 30.0, 62_831.0]);
    draft.note = format!("joints turned by up to {max_angle}");
    for rotation in &mut draft.pose.rotation {
        let axis = random.direction();
        let angle = if below(random, 3) == 0 {
            max_angle
        } else {
            random.range(0.0, max_angle)
        };
        *rotation = axis * angle;
    }
    for number in &mut draft.pose.expression {
        *number = random.range(-1.0, 1.0) * 10f64.powi(below(random, 4) as i32);
    }
}

fn distant(random: &mut Random, draft: &mut Draft) {
    let distance = 10f64.powf(random.range(0.0, 2.6));
    draft.note =
        format!("{distance:.0} times as far as would show all of it, through a lens that shows it");
    // The avatar is as large in the image as from nearby.
    draft.fov = 2.0 * ((0.5 * draft.fov).tan() / distance).atan();
    draft.distance = 1.0;
}

fn quaternions(random: &mut Random, avatar: &mut Avatar) {
    let basis = avatar.nodes.basis.len() / (3 * avatar.nodes.position.len());
    let g = &mut avatar.gaussians;
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
        for number in row.iter_mut() {
            *number = half(number.to_f64() * size);
        }
        if below(random, 4) == 0 {
            // With features of 1, little or nothing remains of the quaternion.
            let remainder = any(random, &[0.0, 1e-4, 0.1]);
            row.fill(f16::ZERO);
            for (k, number) in g.rotation[i as usize].iter().enumerate() {
                row[k * basis] = half(-(1.0 - remainder) * number.to_f64());
            }
        }
    }
    // Features are then equal to the biases, which are 1, so that rows can cancel quaternions.
    if let Some(NetworkLayer { weight, bias, .. }) = avatar.networks.layers.last_mut() {
        weight.halves_mut().fill(f16::ZERO);
        bias.fill(f16::ONE);
    }
}

fn needles(random: &mut Random, draft: &mut Draft) {
    let long = 10f64.powf(random.range(-2.0, 0.3));
    draft.note = format!("up to {long:.3} m long and {:.1e} m thick", long * 1e-4);
    for scale in &mut draft.avatar.gaussians.log_scale {
        let thin = half((long * 1e-4).ln());
        let long = half((long * random.range(0.3, 1.0)).ln());
        let first_axis = below(random, 3);
        *scale = if below(random, 2) == 0 {
            [long, thin, thin]
        } else {
            [long, long, thin]
        };
        scale.rotate_right(first_axis);
    }
}

fn sub_pixel(random: &mut Random, avatar: &mut Avatar) {
    let size = any(random, &[1e-4, 1e-6, 1e-20, 0.0]);
    for scale in &mut avatar.gaussians.log_scale {
        let log_scale: f64 = (size * random.range(0.1, 1.0)).ln();
        *scale = [half(log_scale.max(-65504.0)); 3];
    }
}

fn screen_filling(random: &mut Random, draft: &mut Draft) {
    let sizes = BodySizes {
        gaussians: 20 + below(random, 60),
        rows: 10,
        ..draft.sizes
    };
    *draft = Draft::with_sizes(random, sizes);
    let largest: f64 = any(random, &[0.3, 3.0, 1e3, 1e6, 1e30, 1e300]);
    draft.note = format!("{} Gaussians of up to {largest:e} m", sizes.gaussians);
    for scale in &mut draft.avatar.gaussians.log_scale {
        let size = largest.ln() * random.range(0.5, 1.0);
        *scale = [half(size); 3].map(|s| {
            if below(random, 3) == 0 {
                half(s.to_f64() - 3.0)
            } else {
                s
            }
        });
    }
    for opacity in &mut draft.avatar.gaussians.opacity {
        *opacity = (*opacity / 3).max(2);
    }
}

fn colors(random: &mut Random, avatar: &mut Avatar) {
    const VALUES: [f64; 8] = [-65504.0, -3.0, 0.0, 0.5, 1.0, 1.001, 7.0, 65504.0];
    for channel in avatar.gaussians.color.iter_mut().flatten() {
        *channel = half(any(random, &VALUES));
    }
    let size = any(random, &[1.0, 1e3]);
    for number in avatar.color_rows.basis.halves_mut() {
        *number = half(number.to_f64() * size);
    }
}

fn overflow(random: &mut Random, draft: &mut Draft) {
    let sizes = draft.sizes;
    let what = any(random, &["weights", "biases", "bases", "everything"]);
    let deep = BodySizes {
        hidden_layers: below(random, 7),
        hidden_width: 4 * (1 + below(random, 32)),
        gaussians: sizes.gaussians.min(400),
        rows: 100,
        ..sizes
    };
    *draft = Draft::with_sizes(random, deep);
    draft.note = format!(
        "{what} at f16's largest, {} hidden layers of {}",
        deep.hidden_layers, deep.hidden_width
    );
    let all = what == "everything";
    let mut saturate = |values: &mut [f16], share: f64| {
        for value in values.iter_mut().filter(|_| random.uniform() < share) {
            *value = if *value < f16::ZERO {
                f16::MIN
            } else {
                f16::MAX
            };
        }
    };
    for layer in &mut draft.avatar.networks.layers {
        if all || what == "weights" {
            saturate(layer.weight.halves_mut(), 0.9);
        }
        if all || what == "biases" {
            saturate(&mut layer.bias, 0.9);
        }
    }
    if all || what == "bases" {
        saturate(draft.avatar.nodes.basis.halves_mut(), 0.01);
        saturate(draft.avatar.rotation_rows.basis.halves_mut(), 0.2);
        saturate(draft.avatar.scale_rows.basis.halves_mut(), 0.2);
        saturate(draft.avatar.color_rows.basis.halves_mut(), 0.2);
    }
    for number in &mut draft.pose.expression {
        *number *= 1e30;
    }
}

/// A camera at a Gaussian or between two, with a random direction.
pub fn inside(random: &mut Random, gaussians: &[Gaussian], camera: Camera) -> Camera {
    let [a, b] = [0; 2].map(|_| gaussians[below(random, gaussians.len())].mean);
    let between = random.uniform();
    let eye = a.lerp(b, any(random, &[0.0, 0.5, between]));
    let fov = 2.0 * (0.5 * f64::from(camera.size[1]) / camera.focal.y).atan();
    Camera {
        near: camera.near * any(random, &[1.0, 0.1]),
        ..Camera::look_at(eye, eye + random.direction(), fov, camera.size)
    }
}

fn sizes(random: &mut Random, draft: &mut Draft, large: bool) {
    let small = BodySizes {
        gaussians: 20 + below(random, 200),
        rows: 10,
        ..draft.sizes
    };
    *draft = Draft::with_sizes(random, small);
    let side = random.range(0.0, 5.0).exp2() as u32;
    let long = any(random, &[1024, 4096, 8191, 8192]);
    draft.size = any(
        random,
        &[
            [1, 1],
            [1, side],
            [side, 1],
            [side, side + 1],
            [long, 1],
            [1, long],
            [long, side],
            [side, long],
        ],
    );
    if large && below(random, 8) == 0 {
        draft.size = [8192; 2];
    }
    draft.note = format!("{} × {} px", draft.size[0], draft.size[1]);
}

fn views(random: &mut Random, draft: &mut Draft) {
    let narrow = random.range(1.0, 10.0);
    let wide = random.range(120.0, 170.0);
    let degrees: f64 = any(random, &[1.0, 170.0, narrow, wide]);
    draft.note = format!("{degrees:.1}° high");
    draft.fov = degrees.to_radians();
    draft.distance = any(random, &[1.0, 0.2, 0.05]);
}

fn mixed(random: &mut Random, draft: &mut Draft) {
    let mut notes = vec![];
    for category in [
        Category::ScreenFilling,
        Category::Needles,
        Category::SubPixel,
        Category::Colors,
        Category::Opacity,
        Category::Quaternions,
    ] {
        if random.uniform() < 0.3 {
            apply(random, draft, category, false);
            notes.push(category.name());
        }
    }
    for category in [
        Category::Poses,
        Category::Placed,
        Category::Views,
        Category::Distant,
    ] {
        if random.uniform() < 0.4 {
            apply(random, draft, category, false);
            notes.push(category.name());
        }
    }
    draft.note = notes.join(", ");
}

fn solid(random: &mut Random, draft: &mut Draft) {
    let mut sizes = draft.sizes;
    sizes.gaussians = 3000 + 2 * sizes.gaussians;
    *draft = Draft {
        avatar: body::solid(random, &sizes),
        sizes,
        ..Draft::with_sizes(random, sizes)
    };
    draft.note = format!("{} Gaussians on an ellipsoid", sizes.gaussians);
}

fn torn(random: &mut Random, draft: &mut Draft) {
    draft.sizes.joints = draft.sizes.joints.max(3);
    solid(random, draft);
    let max_angle = random.range(0.5, 3.0);
    draft.note += &format!(", joints turned by up to {max_angle:.1}");
    for rotation in &mut draft.pose.rotation {
        *rotation = random.direction() * random.range(0.0, max_angle);
    }
    // Half of them are also stretched: joints pull by more than they turn, as no skeleton does.
    if below(random, 2) == 0 {
        let most = random.range(1.1, 2.5);
        let apart = random.range(0.0, 0.3);
        draft.note += &format!(", stretched by up to {most:.1} and {apart:.2} m apart");
        draft.stretched = (0..draft.sizes.joints)
            .map(|_| stretch(random, most, apart))
            .collect();
    }
}

/// Scales by up to `most` along one direction and its inverse along others, around the middle of
/// the body, and moves by up to `apart`, metres.
fn stretch(random: &mut Random, most: f64, apart: f64) -> DAffine3 {
    let turn = DQuat::from_rotation_arc(DVec3::X, random.direction());
    let scale = DVec3::from_array(std::array::from_fn(|_| most.powf(random.range(-1.0, 1.0))));
    let matrix =
        DMat3::from_quat(turn) * DMat3::from_diagonal(scale) * DMat3::from_quat(turn.inverse());
    let moved = random.direction() * random.range(0.0, apart);
    DAffine3::from_translation(DVec3::Y + moved)
        * DAffine3::from_mat3(matrix)
        * DAffine3::from_translation(-DVec3::Y)
}

/// A scene of [`near_plane`].
pub struct NearPlaneScene {
    pub avatar: Avatar,
    pub pose: Pose,
    pub camera: Camera,
    /// What is special about it, in words.
    pub note: String,
}

/// Gaussians exactly on the near plane, and one step before and behind it.
///
/// Every number on the way to their depth is exact in f32: positions in steps of 2⁻¹⁴ m, one joint
/// that stays where it is, and a camera that looks along an axis. `size` is the image's, px.
pub fn near_plane(random: &mut Random, size: [u32; 2]) -> NearPlaneScene {
    const STEP: f64 = 1.0 / 16384.0;
    let sizes = BodySizes {
        gaussians: 60,
        parts: 1,
        joints: 1,
        rows: 0,
        ..BodySizes::random(random)
    };
    let mut avatar = body::avatar(random, &sizes);
    let width = (65535.0 * STEP) as f32;
    avatar.gaussians.bounds = Bounds {
        min: [-2.0; 3],
        max: [width - 2.0; 3],
    };
    avatar.nodes.offset.fill([f16::ZERO; 3]);
    avatar.nodes.basis.halves_mut().fill(f16::ZERO);
    avatar.skeleton.canonical = vec![[0.0; 3]];
    avatar.skeleton.rest = vec![[0.0; 3]];
    let near = any(random, &[0.125, 0.25, 1.0]);
    for (position, index) in avatar.gaussians.position.iter_mut().zip(0..) {
        // The camera is at z = 1 and looks along −z.
        let depth = near + STEP * f64::from(index % 3 - 1);
        let point = DVec3::new(
            random.range(-0.4, 0.4) * near,
            random.range(-0.4, 0.4) * near,
            1.0 - depth,
        );
        *position = ((point + 2.0) / STEP).round().to_array().map(|q| q as u16);
    }
    let log_scale = half((0.03 * near).ln());
    avatar.gaussians.log_scale.fill([log_scale; 3]);
    let [width, height] = size.map(f64::from);
    let view = DAffine3::from_mat3_translation(
        DMat3::from_diagonal(DVec3::new(1.0, -1.0, -1.0)),
        DVec3::Z,
    );
    NearPlaneScene {
        avatar,
        pose: Pose::rest(1, sizes.expression),
        camera: Camera {
            view,
            focal: DVec2::splat(width),
            center: DVec2::new(0.5 * width, 0.5 * height),
            size,
            near,
        },
        note: format!("a third of the Gaussians at {near} m, {STEP:.1e} m less and more"),
    }
}

/// A random number that can't be drawn.
pub fn not_drawable(random: &mut Random) -> f64 {
    any(random, &[f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300])
}

/// A vector with a number that can't be drawn.
pub fn not_drawable_vector(random: &mut Random) -> DVec3 {
    let mut vector = vector(random, 1.0);
    vector[below(random, 3)] = not_drawable(random);
    vector
}
