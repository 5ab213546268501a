//! The compiled shader modules. They are stored in `shaders/spv`, so that a build needs no shader
//! compiler.
//!
//! After a change to a shader run `cargo run --release -p effigy-shaders --features compile --bin
//! compile-shaders`. A test fails if a module is older than its source.

use ash::vk;
use effigy_core::hash;
use std::{borrow::Cow, sync::LazyLock};

/// A shader and what it compiles to.
pub struct Module {
    /// Path of the source below `shaders`, such as `sort/count.comp`.
    pub file: &'static str,
    /// What it compiles to.
    spirv: &'static [u8],
}

impl Module {
    /// A shader of another package. `file`: below `shaders`.
    pub const fn new(file: &'static str, spirv: &'static [u8]) -> Self {
        Self { file, spirv }
    }

    /// What it compiles to. In a debug build, the file in the folder that `EFFIGY_SHADERS` names, if
    /// there is one: a changed shader is tried without building what includes it.
    pub fn spirv(&self) -> Cow<'static, [u8]> {
        if cfg!(debug_assertions)
            && let Some(folder) = std::env::var_os("EFFIGY_SHADERS")
            && let Ok(spirv) = std::fs::read(std::path::Path::new(&folder).join(self.compiled()))
        {
            return spirv.into();
        }
        self.spirv.into()
    }

    /// The pipeline stage that the module is for, from the file's extension.
    pub fn stage(&self) -> vk::ShaderStageFlags {
        match self.file.rsplit('.').next() {
            Some("vert") => vk::ShaderStageFlags::VERTEX,
            Some("frag") => vk::ShaderStageFlags::FRAGMENT,
            _ => vk::ShaderStageFlags::COMPUTE,
        }
    }

    /// Path of the compiled file below `shaders/spv`.
    pub fn compiled(&self) -> String {
        format!("{}.spv", self.file)
    }
}

/// Makes a static of each row (its name and its file) and [`MODULES`] of all.
macro_rules! modules {
    ($($constant:ident = $file:literal;)*) => {
        $(
            #[doc = concat!("`shaders/", $file, "`.")]
            pub static $constant: Module = Module {
                file: $file,
                spirv: include_bytes!(concat!("../../../../shaders/spv/", $file, ".spv")),
            };
        )*
        /// Every module.
        pub static MODULES: &[&Module] = &[$(&$constant),*];
    };
}

modules! {
    MLP = "mlp/mlp.comp";
    MLP_BYTES = "mlp/mlp_bytes.comp";
    SH = "sh/sh.comp";
    PROJECT = "project/project.comp";
    PROJECT_CACHED = "project/project_cached.comp";
    SORT_COUNT = "sort/count.comp";
    SORT_REDUCE = "sort/reduce.comp";
    SORT_SCAN = "sort/scan.comp";
    SORT_SCATTER = "sort/scatter.comp";
    SORT_PER_THREAD_COUNT = "sort/per_thread_count.comp";
    SORT_PER_THREAD_SCATTER = "sort/per_thread_scatter.comp";
    SORT_ONESWEEP = "sort/onesweep.comp";
    BINNING = "binning/binning.comp";
    BINNING_COUNT = "binning/count.comp";
    BINNING_SCAN = "binning/scan.comp";
    BINNING_PAIRS = "binning/pairs.comp";
    BINNING_STARTS = "binning/starts.comp";
    SATURATION = "saturation/saturation.comp";
    SATURATION_DEPTH = "saturation/depth.frag";
    QUADS_VERTEX = "raster/quads.vert";
    QUADS_FRAGMENT = "raster/quads.frag";
    RASTER_COOPERATIVE_RGBA8 = "raster/cooperative_rgba8.comp";
    RASTER_COOPERATIVE_RGBA16F = "raster/cooperative_rgba16f.comp";
    RASTER_SHARED_RGBA8 = "raster/shared_rgba8.comp";
    RASTER_SHARED_RGBA16F = "raster/shared_rgba16f.comp";
    RESOLVE_FRAGMENT = "resolve/resolve.frag";
    RATES_COPY = "rates/copy.comp";
    RATES_FILL_VERTEX = "rates/fill.vert";
    RATES_FILL_FRAGMENT = "rates/fill.frag";
    PRESENT_VERTEX = "present/present.vert";
    PRESENT_FRAGMENT = "present/present.frag";
    PRESENT_IN_PASS = "present/in_pass.frag";
}

/// A hash of the sort's modules: what was found of them holds only for those that ran.
pub(crate) fn sort_hash() -> u64 {
    static HASH: LazyLock<u64> =
        LazyLock::new(|| hash_of(|module| module.file.starts_with("sort/")));
    *HASH
}

/// A hash of all modules. It takes a millisecond and more, so it is worked out once.
pub(crate) fn all_hash() -> u64 {
    static HASH: LazyLock<u64> = LazyLock::new(|| hash_of(|_| true));
    *HASH
}

fn hash_of(is_meant: impl Fn(&Module) -> bool) -> u64 {
    let modules = MODULES.iter().filter(|module| is_meant(module));
    modules.fold(hash::EMPTY, |hash, module| {
        hash::extend(hash, module.spirv().iter().copied())
    })
}
