//! Effigy's shaders in WGSL: GLSL below `shaders`, compiled to SPIR-V with [`WgslModule::macros`], which
//! is stored in `spv`, and translated by naga when this package is built.
//!
//! `cargo run --release -p effigy-shaders --features compile --bin compile-shaders` compiles them. A
//! test fails if a module is older than its source.

/// A shader for WebGPU.
pub struct WgslModule {
    /// Path of what it is compiled to below `spv`, without its extension.
    pub name: &'static str,
    /// Path of its source below `shaders`.
    pub file: &'static str,
    /// Names and values that stand for Vulkan's specialization constants, but for those that
    /// WebGPU chooses too when it makes a pipeline.
    pub macros: Macros,
    /// The text; a caller must put the constants of [`Self::lengths`] in front of it.
    pub wgsl: &'static str,
}

/// Makes a static of each row (its name, its source and its macros) and [`MODULES`] of all.
macro_rules! modules {
    ($($constant:ident = $name:literal, $file:literal, $macros:expr;)*) => {
        $(
            #[doc = concat!("`shaders/", $file, "` in WGSL.")]
            pub static $constant: WgslModule = WgslModule {
                name: $name,
                file: $file,
                macros: $macros,
                wgsl: include_str!(concat!(env!("OUT_DIR"), "/", $name, ".wgsl")),
            };
        )*
        /// Every module.
        pub static MODULES: &[&WgslModule] = &[$(&$constant),*];
    };
}

/// Macros of a module: names and values.
type Macros = &'static [(&'static str, &'static str)];

/// The sort's first pass.
const FIRST_PASS: Macros = &[("FIRST", "true"), ("TILE", "SORT_TILE")];
/// The passes after it.
const LATER_PASS: Macros = &[("FIRST", "false"), ("TILE", "SORT_TILE")];
/// Any pass.
const ANY_PASS: Macros = &[("TILE", "SORT_TILE")];

modules! {
    MLP = "mlp/mlp", "mlp/mlp.comp", &[];
    MLP_BYTES = "mlp/mlp_bytes", "mlp/mlp_bytes.comp", &[];
    SH_1 = "sh/sh_1", "sh/sh.comp", &[("DEGREE", "1u")];
    SH_2 = "sh/sh_2", "sh/sh.comp", &[("DEGREE", "2u")];
    SH_3 = "sh/sh_3", "sh/sh.comp", &[("DEGREE", "3u")];
    PROJECT = "project/project", "project/project.comp", &[("STORE", "false")];
    PROJECT_STORE = "project/project_store", "project/project.comp", &[("STORE", "true")];
    PROJECT_CACHED = "project/project_cached", "project/project_cached.comp", &[];
    SORT_COUNT = "sort/count", "sort/count.comp", ANY_PASS;
    SORT_REDUCE = "sort/reduce", "sort/reduce.comp", ANY_PASS;
    SORT_SCAN_FIRST = "sort/scan_first", "sort/scan.comp", FIRST_PASS;
    SORT_SCAN_LATER = "sort/scan_later", "sort/scan.comp", LATER_PASS;
    SORT_SCATTER_FIRST = "sort/scatter_first", "sort/scatter.comp", FIRST_PASS;
    SORT_SCATTER_LATER = "sort/scatter_later", "sort/scatter.comp", LATER_PASS;
    SORT_PER_THREAD_COUNT = "sort/per_thread_count", "sort/per_thread_count.comp", LATER_PASS;
    SORT_PER_THREAD_SCATTER_FIRST =
        "sort/per_thread_scatter_first", "sort/per_thread_scatter.comp", FIRST_PASS;
    SORT_PER_THREAD_SCATTER_LATER =
        "sort/per_thread_scatter_later", "sort/per_thread_scatter.comp", LATER_PASS;
    BINNING_COUNT = "binning/count", "binning/count.comp", &[];
    BINNING_SCAN = "binning/scan", "binning/scan.comp", &[];
    BINNING_PAIRS = "binning/pairs", "binning/pairs.comp", &[];
    BINNING_STARTS = "binning/starts", "binning/starts.comp", &[];
    SATURATION = "saturation/saturation", "saturation/saturation.comp", &[];
    SATURATION_DEPTH = "saturation/depth", "saturation/depth.frag", &[];
    QUADS_VERTEX = "raster/quads_vertex", "raster/quads.vert", &[("DEPTH", "false")];
    QUADS_TESTED_VERTEX = "raster/quads_tested_vertex", "raster/quads.vert", &[("DEPTH", "true")];
    QUADS_FRAGMENT = "raster/quads_fragment", "raster/quads.frag", &[];
    RASTER_SHARED = "raster/shared", "raster/shared_rgba8.comp", &[];
    RESOLVE_FRAGMENT = "resolve/resolve", "resolve/resolve.frag", &[];
    PRESENT_VERTEX = "present/present_vertex", "present/present.vert", &[];
    PRESENT_FRAGMENT = "present/present_fragment", "present/present.frag", &[];
}

/// The format of storage images in the modules' text. For an image of another format, replace it by
/// that format's name.
pub const IMAGE_FORMAT: &str = "rgba8unorm";

impl WgslModule {
    /// WGSL constants with the lengths of the storage buffers' arrays, from the buffers' bindings
    /// and bytes.
    pub fn lengths(&self, buffers: impl Iterator<Item = (u32, u64)>) -> String {
        let constant = |(binding, bytes): (u32, u64)| {
            [4, 8, 16].into_iter().find_map(|stride| {
                let name = format!("LENGTH_{binding}_{stride}");
                self.wgsl
                    .contains(&name)
                    .then(|| format!("const {name}: u32 = {}u;\n", bytes / stride))
            })
        };
        buffers.filter_map(constant).collect()
    }

    /// Its macros in one text, for a fingerprint.
    pub fn macro_text(&self) -> String {
        let macros = self.macros.iter();
        macros
            .map(|(name, value)| format!("{name}={value};"))
            .collect()
    }

    /// Path of what it is compiled to, below the folder of this package.
    pub fn compiled(&self) -> String {
        format!("spv/{}.spv", self.name)
    }
}
