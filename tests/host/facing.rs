//! From where Gaussians are drawn, found by looking at them.

use crate::common::{self, Random, Sizes};
use effigy_core::{
    avatar::Avatar,
    reference::{self, Culled, ReferenceFrame},
    scene::{Camera, Posed},
};
use effigy_math::facing::face;
use effigy_measure::error;
use glam::{DQuat, DVec3};
use half::f16;
use std::f64::consts::PI;

const MIDDLE: DVec3 = DVec3::new(0.0, 0.9, 0.0);
const RADIUS: f64 = 0.25;

/// A closed ball of opaque discs, with a second layer beneath them.
fn ball() -> Avatar {
    let sizes = Sizes {
        gaussians: 2400,
        parts: 1,
        nodes: 1,
        joints: 1,
        rows: 0,
        ..Sizes::default()
    };
    let mut avatar = common::avatar(3, sizes);
    avatar.nodes.basis.halves_mut().fill(f16::ZERO);
    avatar.nodes.offset.fill([f16::ZERO; 3]);
    let gaussians = &mut avatar.gaussians;
    let count = gaussians.len() / 2;
    for k in 0..gaussians.len() {
        // A spiral from pole to pole.
        let height = 1.0 - 2.0 * ((k % count) as f64 + 0.5) / count as f64;
        let turn = PI * (1.0 + 5f64.sqrt()) * k as f64;
        let across = (1.0 - height * height).sqrt();
        let normal = DVec3::new(across * turn.cos(), height, across * turn.sin());
        let radius = if k < count { RADIUS } else { 0.8 * RADIUS };
        let q = DQuat::from_rotation_arc(DVec3::Z, normal);
        gaussians.position[k] = gaussians.bounds.encode(MIDDLE + radius * normal);
        gaussians.rotation[k] = common::f16s([q.w, q.x, q.y, q.z]);
        gaussians.log_scale[k] = common::f16s([0.022f64, 0.022, 0.002].map(f64::ln));
        gaussians.opacity[k] = 250;
    }
    avatar
}

fn what_is_behind_is_left_out_and_nothing_shows_that() {
    let avatar = ball();
    let mut views = 0;
    let mut faced = avatar.clone();
    face(&mut faced, &[], 4.0 / 255.0, &mut |done, all| {
        assert!(done <= all);
        views = done;
    });
    assert!(views > 500, "{views} views");
    let pose = common::pose(1, &avatar);
    let posed = Posed::new(&avatar, &pose);
    let random = &mut Random(9);
    for _ in 0..6 {
        let [yaw, pitch] = [random.range(-3.0, 3.0), random.range(-1.2, 1.2)];
        let target = posed.joints[0].transform_point3(MIDDLE);
        let camera = Camera::orbit(target, yaw, pitch, random.range(0.6, 3.0), 0.7, [120, 120]);
        let frame = ReferenceFrame::new(&faced, &posed, &camera);
        let whole = reference::render(&avatar, &posed, &camera);
        let away = frame
            .splats
            .iter()
            .filter(|splat| **splat == Err(Culled::Away));
        let share = away.count() as f64 / frame.splats.len() as f64;
        assert!(share > 0.3, "{share} of the ball faces away");
        let error = error::between(&frame.canvas.to_image(), &whole).covered;
        assert!(error.psnr_db > 50.0, "{error:?}");
    }
}

tests! {
    what_is_behind_is_left_out_and_nothing_shows_that,
}
