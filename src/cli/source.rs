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
    pub fn load(&self) -> anyhow::Result<(Avatar, Vec<Clip>)> {
        anyhow::bail!("not built yet")
    }
}
