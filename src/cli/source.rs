//! Where a command's avatar and clips come from: files that the user names, else the demo inside the program.

use crate::{
    avatar::{Avatar, Clip},
    demo,
};
use anyhow::ensure;
use std::path::PathBuf;

/// The arguments of every command that draws.
#[derive(clap::Args, Clone, Debug)]
pub struct Source {
    /// The avatar to draw [default: the built-in demo]
    pub avatar: Option<PathBuf>,
    /// A clip to move it with; repeat for several [default: the built-in demo clip]
    #[arg(long, value_name = "FILE")]
    pub motion: Vec<PathBuf>,
}

impl Source {
    /// Reads the avatar and its clips, of which there is at least one. Clips that move nothing of the avatar are an error.
    pub fn load(&self) -> anyhow::Result<(Avatar, Vec<Clip>)> {
        let avatar = match &self.avatar {
            Some(path) => Avatar::read(path)?,
            None => demo::avatar()?,
        };
        let clips = if self.motion.is_empty() {
            vec![demo::clip()?]
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

/// The first few of some names.
fn some(names: &[String]) -> String {
    let few: Vec<_> = names.iter().take(3).map(|name| format!("`{name}`")).collect();
    format!("{}{}", few.join(", "), if names.len() > few.len() { ", …" } else { "" })
}
