//! Which backend draws, as the command line has it.

use crate::measure::bench::Backend;
use clap::ValueEnum;

/// [`Backend`] as the command line has it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Through {
    /// The renderer written for it
    Vulkan,
    /// What browsers use; in programs built with `--features webgpu`
    Webgpu,
}

impl TryFrom<Through> for Backend {
    type Error = anyhow::Error;

    fn try_from(through: Through) -> anyhow::Result<Self> {
        match through {
            Through::Vulkan => Ok(Self::Vulkan),
            #[cfg(feature = "webgpu")]
            Through::Webgpu => Ok(Self::WebGpu),
            #[cfg(not(feature = "webgpu"))]
            Through::Webgpu => {
                anyhow::bail!("this program was built without WebGPU: build it with `cargo build --release --features webgpu`")
            }
        }
    }
}
