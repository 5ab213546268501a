//! The graphics API that draws, as an argument.

use crate::advice::Advised;
use clap::ValueEnum;
use effigy_measure::bench::Backend;

/// [`Backend`] as an argument. Builds without WebGPU know its name too, to say what is missing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum BackendArg {
    /// The native renderer
    Vulkan,
    /// The renderer of browsers; in builds with `--features webgpu`
    Webgpu,
}

impl TryFrom<BackendArg> for Backend {
    type Error = Advised;

    fn try_from(backend: BackendArg) -> Result<Self, Advised> {
        match backend {
            BackendArg::Vulkan => Ok(Self::Vulkan),
            #[cfg(feature = "webgpu")]
            BackendArg::Webgpu => Ok(Self::WebGpu),
            #[cfg(not(feature = "webgpu"))]
            BackendArg::Webgpu => Err(Advised::new(
                "this program was built without WebGPU",
                "build it with `cargo build --release --features webgpu`",
            )),
        }
    }
}
