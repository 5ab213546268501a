//! A small picture of an avatar, drawn by the reference: it needs no device.

use crate::options;
use anyhow::Context;
use effigy_core::{
    avatar::{Avatar, Pose},
    reference,
    scene::{AvatarBounds, Camera, Posed, upright},
};
use std::path::Path;

/// Width and height, pixels.
const SIZE: [u32; 2] = [384, 384];
/// Where the camera stands around the avatar, degrees: yaw and pitch.
const YAW: f64 = 20.0;
const PITCH: f64 = 5.0;
/// Vertical field of view, degrees.
const FOV: f64 = 35.0;

/// Draws a pose and writes it as a PNG.
pub fn write(avatar: &Avatar, pose: &Pose, out: &Path) -> anyhow::Result<()> {
    let posed = Posed::new(avatar, pose);
    let bounds = upright(AvatarBounds::new(avatar).bounds(&posed.joints));
    let [yaw, pitch, fov] = [YAW, PITCH, FOV].map(f64::to_radians);
    let camera = Camera::around(bounds, yaw, pitch, fov, SIZE);
    let image = reference::render_scene(avatar, &[&posed], &camera);
    let background = options::color(options::BACKGROUND).map_err(anyhow::Error::msg)?;
    image
        .over(background)
        .save_with_format(out, image::ImageFormat::Png)
        .with_context(|| format!("{} can't be written", out.display()))
}
