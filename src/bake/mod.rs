//! Makes avatars and clips from a real body (MakeHuman's, CC0) and real motion (CMU's captures): source files in, an [`Avatar`] or a
//! [`Clip`] out.
//!
//! ```text
//! base.obj, targets, rig, weights ── body ── outfit: sheets of skin, hair, clothes
//!                                                ↓
//!                      light: a sky baked in ── spacing: evenly spaced points on what shows
//!                                                ↓
//! 01_01.bvh ── retarget: a clip ─────────── assemble: Gaussians, parts, nodes, bases, networks
//! ```
//!
//! Geometry, skin weights, expressions and motion are real. Clothes, hair and colours are ours; networks and bases are drawn from a
//! seed, smooth over the body and of the size that learned ones have.

pub mod assemble;
pub mod bases;
pub mod body;
pub mod bvh;
pub mod face;
pub mod light;
mod look;
pub mod masks;
pub mod math;
pub mod networks;
pub mod obj;
pub mod outfit;
pub mod partition;
pub mod pca;
pub mod print;
pub mod retarget;
pub mod rig;
pub mod shoe;
pub mod spacing;
pub mod surface;
pub mod target;
pub mod text;

use crate::avatar::{Avatar, Clip, Pose, Skeleton};
pub use assemble::Sizes;
pub use body::{Assets, Body, Shape};
use glam::DVec3;
pub use retarget::Options;
use std::path::Path;
pub use text::Error;

/// What an avatar made here owes to whom.
pub const BODY_CREDIT: &str = "Body, rig, skin weights and expressions: MakeHuman (makehumancommunity.org), released under CC0 1.0. Clothes, hair and colours: Effigy.";
/// The sentence that CMU asks for.
pub const MOTION_CREDIT: &str =
    "The data used in this project was obtained from mocap.cs.cmu.edu. The database was created with funding from NSF EIA-0196217.";

/// A dressed body with all that it was made from.
pub struct Dressed {
    pub body: Body,
    pub outfit: outfit::Outfit,
    /// Skin and garments, the innermost first.
    pub sheets: Vec<surface::Sheet>,
    /// Where on the sheets each of the avatar's Gaussians is.
    pub dots: Vec<spacing::Dot>,
    pub avatar: Avatar,
}

/// Makes the dressed body; networks, pruning and PCA are fitted to the clips' poses, and `step` hears what begins.
pub fn body(assets: &Assets, shape: Shape, clips: &[Clip], sizes: &Sizes, step: &dyn Fn(&'static str)) -> Result<Avatar, Error> {
    Ok(dressed(assets, shape, clips, sizes, step)?.avatar)
}

/// The same, with the surfaces that the avatar stands for.
pub fn dressed(assets: &Assets, shape: Shape, clips: &[Clip], sizes: &Sizes, step: &dyn Fn(&'static str)) -> Result<Dressed, Error> {
    step("reading the body");
    let body = Body::load(assets, shape)?;
    let outfit = outfit::Outfit::new(&body, masks::Masks::load(assets)?, shape);
    let poses = poses(clips, &body.skeleton)?;
    step("dressing it");
    let sheets = outfit.sheets(&body);
    step("lighting it");
    let middle = |s: usize, t: usize| outfit.shows(&sheets[s].site(t, [1.0 / 3.0; 3]));
    let sky = light::Sky::new(&sheets, middle);
    step("spacing Gaussians");
    let dots = spacing::scatter(&sheets, &outfit, sizes.gaussians, sizes.seed);
    step("assembling the avatar");
    let (avatar, order) = assemble::assemble(&body, &outfit, &sky, &dots, &poses, sizes);
    let dots = order.into_iter().map(|dot| dots[dot].clone()).collect();
    Ok(Dressed { body, outfit, sheets, dots, avatar })
}

/// Every frame of the clips in a skeleton's order of joints.
pub fn poses(clips: &[Clip], skeleton: &Skeleton) -> Result<Vec<Pose>, Error> {
    let mut poses = Vec::new();
    for clip in clips {
        let map = clip.map_to(skeleton);
        if map.iter().all(Option::is_none) {
            return Err(Error::Content {
                file: clip.name.clone().into(),
                found: "none of the body's joints".into(),
                expected: "Hips and its like".into(),
            });
        }
        poses.extend((0..clip.frames()).map(|frame| {
            let mut pose = clip.frame(frame);
            pose.rotation = map.iter().map(|joint| joint.map_or(DVec3::ZERO, |j| pose.rotation[j])).collect();
            pose.expression.resize(body::EXPRESSIONS.len(), 0.0);
            pose
        }));
    }
    Ok(poses)
}

/// The steps that [`body`] and [`dressed`] announce.
pub const STEPS: u64 = 5;

/// The skeleton alone.
pub fn skeleton(assets: &Assets, shape: Shape) -> Result<Skeleton, Error> {
    Ok(Body::load(assets, shape)?.skeleton)
}

/// Makes a clip of a skeleton from a capture.
pub fn motion(file: &Path, skeleton: &Skeleton, options: &Options) -> Result<Clip, Error> {
    let capture = bvh::Bvh::parse(file, &text::read(file)?)?;
    retarget::retarget(&capture, skeleton, options, file)
}
