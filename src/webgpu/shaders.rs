//! The shaders in WGSL, which live in `shaders/wgsl`: GLSL sources compiled to SPIR-V with [`Module::macros`], and that rewritten by naga.
//!
//! `cargo run --features shaderc --bin compile-shaders` writes them; [`Module::fingerprint`] is how a test notices that someone forgot to.

use crate::hash;

/// A shader for WebGPU.
pub struct Module {
    /// Name of the file in `shaders/wgsl`, without its ending.
    pub name: &'static str,
    /// File in `shaders` that it comes from.
    pub file: &'static str,
    /// What Vulkan has as specialization constants.
    pub macros: &'static [(&'static str, &'static str)],
    /// Without the constants of [`Self::lengths`].
    pub wgsl: &'static str,
}

/// A module of each line: its name, its source, and its macros.
macro_rules! modules {
    ($($(#[$about:meta])* $constant:ident = $name:literal, $file:literal $(, $macro:ident = $value:literal)*;)*) => {
        $($(#[$about])* pub static $constant: Module = Module {
            name: $name,
            file: $file,
            macros: &[$((stringify!($macro), $value)),*],
            wgsl: include_str!(concat!("../../shaders/wgsl/", $name, ".wgsl")),
        };)*
        /// Every module, for the compiler and the tests.
        pub static MODULES: &[&Module] = &[$(&$constant),*];
    };
}

modules! {
    FEATURES = "features", "features.comp";
    FEATURES_BYTES = "features_bytes", "features_bytes.comp";
    HARMONICS_1 = "harmonics_1", "harmonics.comp", DEGREE = "1u";
    HARMONICS_2 = "harmonics_2", "harmonics.comp", DEGREE = "2u";
    HARMONICS_3 = "harmonics_3", "harmonics.comp", DEGREE = "3u";
    SURFACE_VERTEX = "surface_vertex", "surface.vert";
    SURFACE = "surface", "surface.comp";
    SPLATS = "splats", "splats.comp", KEEP = "false";
    SPLATS_KEEP = "splats_keep", "splats.comp", KEEP = "true";
    SPLATS_POSED = "splats_posed", "splats_posed.comp";
    SORT_FIRST = "sort_first", "sort_scatter.comp", PASS = "0u", READS = "HALVES", WRITES = "PACKED", TILE = "SORT_TILE";
    SORT_LANES_FIRST = "sort_lanes_first", "sort_lanes_scatter.comp", PASS = "0u", READS = "HALVES", WRITES = "PACKED", TILE = "SORT_TILE";
    SORT_LANES_LAST_COUNT = "sort_lanes_last_count", "sort_lanes_count.comp", PASS = "1u", READS = "PACKED", WRITES = "VALUES", TILE = "SORT_TILE";
    SORT_LANES_LAST = "sort_lanes_last", "sort_lanes_scatter.comp", PASS = "1u", READS = "PACKED", WRITES = "VALUES", TILE = "SORT_TILE";
    SORT_FIRST_REDUCE = "sort_first_reduce", "sort_reduce.comp", PASS = "0u", READS = "HALVES", WRITES = "PACKED", TILE = "SORT_TILE";
    SORT_FIRST_SCAN = "sort_first_scan", "sort_scan.comp", PASS = "0u", READS = "HALVES", WRITES = "PACKED", TILE = "SORT_TILE";
    SORT_LAST_COUNT = "sort_last_count", "sort_count.comp", PASS = "1u", READS = "PACKED", WRITES = "VALUES", TILE = "SORT_TILE";
    SORT_LAST_REDUCE = "sort_last_reduce", "sort_reduce.comp", PASS = "1u", READS = "PACKED", WRITES = "VALUES", TILE = "SORT_TILE";
    SORT_LAST_SCAN = "sort_last_scan", "sort_scan.comp", PASS = "1u", READS = "PACKED", WRITES = "VALUES", TILE = "SORT_TILE";
    SORT_LAST = "sort_last", "sort_scatter.comp", PASS = "1u", READS = "PACKED", WRITES = "VALUES", TILE = "SORT_TILE";
    RASTER_VERTEX = "raster_vertex", "raster.vert", DEPTH = "false";
    RASTER_FRAGMENT = "raster_fragment", "raster.frag";
    BINS = "bins", "bins.comp";
    RASTER_RGBA8 = "raster_rgba8", "raster_rgba8.comp";
    RASTER_RGBA16F = "raster_rgba16f", "raster_rgba16f.comp";
    PRESENT_VERTEX = "present_vertex", "present.vert";
    PRESENT_FRAGMENT = "present_fragment", "present.frag";
}

/// File in `shaders/wgsl` with a line `name fingerprint` for each module.
pub const FINGERPRINTS: &str = "fingerprints.txt";

impl Module {
    /// The constants that say how many elements the arrays of storage buffers have, from the buffers' bindings and bytes.
    pub fn lengths(&self, buffers: impl Iterator<Item = (u32, u64)>) -> String {
        let constant = |(binding, bytes): (u32, u64)| {
            [4, 8, 16].into_iter().find_map(|stride| {
                let name = format!("LENGTH_{binding}_{stride}");
                self.wgsl.contains(&name).then(|| format!("const {name}: u32 = {}u;\n", bytes / stride))
            })
        };
        buffers.filter_map(constant).collect()
    }

    /// Changes with the source, whose own fingerprint is given, with the macros, and with the text that came of them.
    pub fn fingerprint(&self, source: u64, wgsl: &str) -> u64 {
        let macros = self.macros.iter().map(|(name, value)| format!("{name}={value};")).collect::<String>();
        let bytes = source.to_le_bytes().into_iter().chain(macros.bytes()).chain(wgsl.bytes());
        hash::add(hash::EMPTY, bytes)
    }
}
