//! Small pictures of files, drawn by the reference: they need no device.

use crate::options;
use anyhow::Context;
use effigy_core::{
    avatar::{Avatar, Clip, Filter, Pose, motion::Player},
    io::file::FileContent,
    reference,
    scene::{AvatarBounds, Camera, FrameImage, Framing, Orbit, Posed},
};
use effigy_formats::{
    content::Content,
    mmlphuman::Checkpoint,
    open::{self, ClipOptions, OpenOptions},
};
use effigy_learn::distil::{AnchorFeatures, Teacher, plain_inputs};
use glam::DVec3;
use image::RgbaImage;
use std::path::Path;

/// Width and height, pixels.
pub const SIZE: [u32; 2] = [384, 384];
/// Where the camera stands around the avatar, degrees: yaw and pitch.
const YAW: f64 = 20.0;
const PITCH: f64 = 5.0;
/// Vertical field of view, degrees.
const FOV: f64 = 35.0;

/// What draws pictures of files.
pub struct Thumbnails {
    /// Moves where a file is motion.
    pub moved: Avatar,
    /// How motion is read.
    pub clips: ClipOptions,
}

impl Thumbnails {
    /// A picture of a file: an avatar, or one that motion moves, half way through.
    pub fn of(&self, path: &Path) -> anyhow::Result<RgbaImage> {
        let content = open::content(path);
        if content.is_motion() {
            let opened = open::clip(path, &self.moved, &self.clips)?;
            return of_clip(&self.moved, opened.clip);
        }
        if content == Content::Checkpoint {
            return open::checkpoint(path, &Default::default(), |own| of_checkpoint(&own))?
                .with_context(|| format!("{} can't be drawn", path.display()));
        }
        if content.is_avatar() {
            let avatar = open::avatar(path, &OpenOptions::default())?.avatar;
            return of_avatar(&avatar);
        }
        match FileContent::read(path)? {
            FileContent::Avatar(avatar) => of_avatar(&avatar),
            FileContent::Clip(clip) => of_clip(&self.moved, *clip),
        }
    }

    /// A picture of the demo.
    pub fn demo(&self) -> anyhow::Result<RgbaImage> {
        of_clip(&effigy_demo::avatar()?, effigy_demo::clip()?)
    }
}

fn of_avatar(avatar: &Avatar) -> anyhow::Result<RgbaImage> {
    of_clip(avatar, Clip::still(&avatar.skeleton))
}

/// Half way through a clip.
fn of_clip(avatar: &Avatar, clip: Clip) -> anyhow::Result<RgbaImage> {
    let middle = clip.duration() / 2.0;
    let pose = Player::new(clip, &avatar.skeleton).pose(middle);
    let posed = Posed::new(avatar, &pose);
    let camera = camera(AvatarBounds::new(avatar).framing(&posed.joints));
    over_background(&reference::render(avatar, &posed, &camera))
}

/// What a checkpoint itself shows, in the pose in the middle of its training.
fn of_checkpoint(checkpoint: &Checkpoint) -> anyhow::Result<RgbaImage> {
    let poses = &checkpoint.poses;
    let rest = Pose::rest(checkpoint.skeleton.len(), 0);
    let pose = poses.get(poses.len() / 2).unwrap_or(&rest);
    let row = plain_inputs(checkpoint).unprojected(pose);
    let row: Vec<f32> = row.iter().map(|&x| x as f32).collect();
    let features = AnchorFeatures::new(&checkpoint.networks, &row, &|_| {})?;
    let teacher = Teacher { checkpoint };
    let look = teacher.look(&features, 0);
    let mut low = DVec3::INFINITY;
    let mut high = DVec3::NEG_INFINITY;
    for gaussian in teacher.posed(&look, pose, DVec3::ZERO) {
        low = low.min(gaussian.mean);
        high = high.max(gaussian.mean);
    }
    let camera = camera(Framing::person([low, high]));
    let gaussians = teacher.posed(&look, pose, camera.eye());
    over_background(&reference::render_gaussians(
        &gaussians,
        &camera,
        Filter::default(),
    ))
}

/// The camera of a picture.
fn camera(framing: Framing) -> Camera {
    let [yaw, pitch, fov] = [YAW, PITCH, FOV].map(f64::to_radians);
    Camera::around(framing, Orbit { yaw, pitch, fov }, SIZE)
}

fn over_background(image: &FrameImage) -> anyhow::Result<RgbaImage> {
    let background = options::color(options::BACKGROUND).map_err(anyhow::Error::msg)?;
    Ok(image.over(background))
}
