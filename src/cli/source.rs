//! Where a command's avatar and clips come from: files that the user names, else the demo inside the program.

use crate::{
    avatar::{
        Avatar, Clip, Pose,
        import::{self, Up, cameras},
    },
    demo,
    frame::Camera,
};
use anyhow::ensure;
use std::path::{Path, PathBuf};

/// The arguments of every command that draws.
#[derive(clap::Args, Clone, Debug)]
pub struct Source {
    /// The avatar to draw: an .avatar file, or a 3DGS .ply, which stands still [default: the built-in demo]
    pub avatar: Option<PathBuf>,
    /// A clip to move it with; repeat for several [default: the built-in demo clip]
    #[arg(long, value_name = "FILE")]
    pub motion: Vec<PathBuf>,
    /// The axis that points up in a .ply [default: what the file says, else -y, as 3DGS trains]
    #[arg(long, value_enum, value_name = "AXIS", allow_hyphen_values = true)]
    pub up: Option<Up>,
    /// Whether networks see a pose as the nearest one that the avatar knows, within 2σ along each principal component of its training
    /// poses; off: as it is
    #[arg(long, value_enum, default_value_t = Project::On)]
    pub project: Project,
}

/// [`Posed::of`](crate::frame::Posed::of)'s projection as the command line has it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum Project {
    #[default]
    On,
    Off,
}

impl Source {
    /// The same for another avatar: a .ply has no use for clips, and nothing else for an axis.
    #[cfg(feature = "window")]
    pub fn of(&self, path: &Path) -> Self {
        let mut source = Self { avatar: Some(path.to_owned()), ..self.clone() };
        if import::is_ply(path) {
            source.motion.clear()
        } else {
            source.up = None
        }
        source
    }

    /// Reads the avatar and its clips, of which there is at least one: an avatar that nothing moves has one of a single pose. Clips that
    /// are given and move nothing of the avatar are an error.
    pub fn load(&self) -> anyhow::Result<(Avatar, Vec<Clip>)> {
        let turned = self.up.is_none() || self.avatar.as_deref().is_some_and(import::is_ply);
        ensure!(turned, "--up is for a .ply; what stands up in an avatar file is known: leave it out");
        let mut avatar = match &self.avatar {
            Some(path) => import::open(path, self.up)?,
            None => demo::avatar()?,
        };
        if self.project == Project::Off {
            (avatar.inputs.pose_space, avatar.inputs.expression_space) = (None, None);
        }
        let clips = if self.motion.is_empty() {
            vec![if avatar.is_static() { Clip::still(&avatar.skeleton) } else { demo::clip()? }]
        } else {
            self.motion.iter().map(|path| Clip::read(path)).collect::<Result<_, _>>()?
        };
        for clip in &clips {
            let moved = clip.map_to(&avatar.skeleton).iter().flatten().count();
            ensure!(
                moved > 0,
                "the clip `{}` moves none of the joints of `{}`: it has {}, the avatar has {}",
                clip.name,
                avatar.name,
                some(&clip.joint),
                some(&avatar.skeleton.name)
            );
            tracing::info!("the clip `{}` moves {moved} of {} joints", clip.name, avatar.skeleton.len());
        }
        Ok((avatar, clips))
    }
}

/// Reads `cameras.json` as 3DGS writes it beside a .ply, in the avatar's world.
pub fn cameras(path: &Path, avatar: &Avatar) -> anyhow::Result<Vec<Camera>> {
    let rest = Pose::rest(avatar.skeleton.len(), 0);
    let world = avatar.skeleton.matrices(&rest).first().copied().unwrap_or_default();
    Ok(cameras::read(path, world)?)
}

/// The first few of some names.
fn some(names: &[String]) -> String {
    let few: Vec<_> = names.iter().take(3).map(|name| format!("`{name}`")).collect();
    format!("{}{}", few.join(", "), if names.len() > few.len() { ", …" } else { "" })
}
