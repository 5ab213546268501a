//! Where a command's avatar and clips come from: files that the user names, else the demo inside the program.

use crate::avatar::{Avatar, Clip};
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
    /// Reads the avatar and its clips, of which there is at least one.
    ///
    /// # Errors
    /// When a file cannot be read, is of the other kind, or is malformed.
    pub fn load(&self) -> anyhow::Result<(Avatar, Vec<Clip>)> {
        let avatar = self.avatar.as_deref().map_or_else(demo_avatar, |path| Ok(Avatar::read(path)?))?;
        let clips = match &self.motion[..] {
            [] => vec![demo_clip()?],
            paths => paths.iter().map(|path| Clip::read(path)).collect::<Result<_, _>>()?,
        };
        Ok((avatar, clips))
    }
}

/// The avatar inside the program.
pub fn demo_avatar() -> anyhow::Result<Avatar> {
    anyhow::bail!("this build has no demo avatar: name an avatar file")
}

/// The clip inside the program.
pub fn demo_clip() -> anyhow::Result<Clip> {
    anyhow::bail!("this build has no demo clip: name one with --motion")
}
