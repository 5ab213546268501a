//! Makes avatars and clips from a real body (MakeHuman's, CC0) and real motion (CMU's captures).
//!
//! ```text
//! base.obj, targets, rig, weights ── body ── outfit: sheets of skin, hair, clothes
//!                                                ↓
//!                   sky_light: a sky baked in ── spacing: evenly spaced points
//!                                                ↓
//! 01_01.bvh ── clip: retargeted and cut ──── assemble: Gaussians, parts, nodes, bases, networks
//! ```
//!
//! Geometry, skin weights, expressions and motion are real. Clothes, hair and colours are ours.
//! Networks and bases are drawn from a seed, smooth over the body and of the size that learned ones
//! have.

pub mod assemble;
pub mod bases;
pub mod body;
pub mod clip;
pub mod credits;
pub mod joints;
pub mod networks;
pub mod outfit;
pub mod partition;
pub mod sky;
pub mod sky_light;
pub mod source;
pub mod spacing;
pub mod stretch;
pub mod style;
pub mod surface;

pub use assemble::BakeSizes;
pub use body::{BakedBody, BodyShape, Person};
pub use clip::{CutOptions, motion};
use effigy_core::avatar::{Avatar, Clip, Pose, Skeleton};
use glam::DVec3;
pub use source::Assets;
pub use source::text::SourceError;
pub use style::Style;

/// A dressed body without Gaussians.
pub struct Clothed {
    /// The naked body.
    pub body: BakedBody,
    /// The rules of its clothes.
    pub outfit: outfit::Outfit,
    /// Skin and garments, the innermost first.
    pub sheets: Vec<surface::Sheet>,
}

/// Reads a body and dresses it.
///
/// # Errors
/// When a source file is missing or damaged.
pub fn clothed(assets: &Assets, person: impl Into<Person>) -> Result<Clothed, SourceError> {
    let person = person.into();
    let body = BakedBody::load(assets, person.shape)?;
    let outfit = outfit::Outfit::new(&body, source::masks::SurfaceMasks::load(assets)?, person);
    Ok(Clothed {
        sheets: outfit::sheets(&outfit, &body),
        body,
        outfit,
    })
}

/// The steps that [`body()`] announces.
pub const STEPS: u64 = 4;

/// Bakes a dressed body. Networks, pruning and PCA are fitted to the clips' poses. `announce` is
/// called with each step that begins, [`STEPS`] in all.
///
/// # Errors
/// When a source file is missing or damaged, or a clip is not of the body.
pub fn body(
    assets: &Assets,
    person: impl Into<Person>,
    clips: &[Clip],
    sizes: &BakeSizes,
    announce: &dyn Fn(&'static str),
) -> Result<Avatar, SourceError> {
    announce("reading and dressing the body");
    let Clothed {
        body,
        outfit,
        sheets,
    } = clothed(assets, person)?;
    let poses = poses(clips, &body.skeleton)?;
    announce("lighting it");
    let casts_shadow =
        |sheet: usize, triangle: usize| outfit.shows(&sheets[sheet].site(triangle, [1.0 / 3.0; 3]));
    let sky = sky_light::BakedSky::new(&sheets, casts_shadow);
    announce("spacing Gaussians");
    let dots = spacing::scatter(&sheets, &outfit, sizes.gaussians, sizes.seed);
    announce("assembling the avatar");
    Ok(assemble::assemble(
        &body, &outfit, &sheets, &sky, &dots, &poses, sizes,
    ))
}

/// Every frame of the clips in a skeleton's order of joints.
fn poses(clips: &[Clip], skeleton: &Skeleton) -> Result<Vec<Pose>, SourceError> {
    let mut poses = Vec::new();
    for clip in clips {
        let map = clip.map_to(skeleton);
        if map.iter().all(Option::is_none) {
            return Err(SourceError::Content {
                file: clip.name.clone().into(),
                found: "none of the body's joints".into(),
                expected: "Hips and its like".into(),
            });
        }
        poses.extend((0..clip.frames()).map(|frame| {
            let mut pose = clip.frame(frame);
            pose.rotation = map
                .iter()
                .map(|joint| joint.map_or(DVec3::ZERO, |j| pose.rotation[j]))
                .collect();
            pose.expression.resize(body::EXPRESSIONS.len(), 0.0);
            pose
        }));
    }
    Ok(poses)
}

/// The body's skeleton alone.
///
/// # Errors
/// When a source file is missing or damaged.
pub fn skeleton(assets: &Assets, shape: BodyShape) -> Result<Skeleton, SourceError> {
    Ok(BakedBody::load(assets, shape)?.skeleton)
}
