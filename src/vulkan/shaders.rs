//! The compiled shader modules, which live in `shaders/spv` so that a build needs no shader compiler.
//!
//! `cargo run --features shaderc --bin compile-shaders` compiles them again after a change; [`fingerprint`] is how a test notices
//! that someone forgot to.

use crate::{hash, layout};
use ash::vk;
use std::{fs, io, iter, path::Path};

/// A shader and what it compiles to.
pub struct Module {
    /// File in `shaders`.
    pub file: &'static str,
    /// SPIR-V that reads packed words.
    spirv: &'static [u8],
    /// SPIR-V that reads f16 from storage buffers, for shaders that hold half quads.
    half: Option<&'static [u8]>,
}

impl Module {
    /// SPIR-V for a device, with f16 storage buffers or without.
    pub fn spirv(&self, half_storage: bool) -> &'static [u8] {
        self.half.filter(|_| half_storage).unwrap_or(self.spirv)
    }

    /// The stage that it is for, by its file's extension.
    pub fn stage(&self) -> vk::ShaderStageFlags {
        match self.file.rsplit('.').next() {
            Some("vert") => vk::ShaderStageFlags::VERTEX,
            Some("frag") => vk::ShaderStageFlags::FRAGMENT,
            _ => vk::ShaderStageFlags::COMPUTE,
        }
    }

    /// What the source was compiled to: without f16 storage buffers and, where it differs, with them.
    pub fn compiled_modules(&self) -> impl Iterator<Item = &'static [u8]> {
        iter::once(self.spirv).chain(self.half)
    }

    pub fn has_half(&self) -> bool {
        self.half.is_some()
    }

    /// Name of the compiled file in `shaders/spv`.
    pub fn compiled(&self, half: bool) -> String {
        format!("{}{}.spv", self.file, if half { ".half" } else { "" })
    }
}

pub static FEATURES: Module = Module {
    file: "features.comp",
    spirv: include_bytes!("../../shaders/spv/features.comp.spv"),
    half: Some(include_bytes!("../../shaders/spv/features.comp.half.spv")),
};
pub static FEATURES_BYTES: Module =
    Module { file: "features_bytes.comp", spirv: include_bytes!("../../shaders/spv/features_bytes.comp.spv"), half: None };
pub static HARMONICS: Module = Module {
    file: "harmonics.comp",
    spirv: include_bytes!("../../shaders/spv/harmonics.comp.spv"),
    half: Some(include_bytes!("../../shaders/spv/harmonics.comp.half.spv")),
};
pub static SPLATS: Module = Module { file: "splats.comp", spirv: include_bytes!("../../shaders/spv/splats.comp.spv"), half: None };
pub static SPLATS_POSED: Module =
    Module { file: "splats_posed.comp", spirv: include_bytes!("../../shaders/spv/splats_posed.comp.spv"), half: None };
pub static SORT_COUNT: Module =
    Module { file: "sort_count.comp", spirv: include_bytes!("../../shaders/spv/sort_count.comp.spv"), half: None };
pub static SORT_REDUCE: Module =
    Module { file: "sort_reduce.comp", spirv: include_bytes!("../../shaders/spv/sort_reduce.comp.spv"), half: None };
pub static SORT_SCAN: Module = Module { file: "sort_scan.comp", spirv: include_bytes!("../../shaders/spv/sort_scan.comp.spv"), half: None };
pub static SORT_SCATTER: Module =
    Module { file: "sort_scatter.comp", spirv: include_bytes!("../../shaders/spv/sort_scatter.comp.spv"), half: None };
pub static SORT_LANES_COUNT: Module =
    Module { file: "sort_lanes_count.comp", spirv: include_bytes!("../../shaders/spv/sort_lanes_count.comp.spv"), half: None };
pub static SORT_LANES_SCATTER: Module =
    Module { file: "sort_lanes_scatter.comp", spirv: include_bytes!("../../shaders/spv/sort_lanes_scatter.comp.spv"), half: None };
pub static SORT_CHAIN: Module =
    Module { file: "sort_chain.comp", spirv: include_bytes!("../../shaders/spv/sort_chain.comp.spv"), half: None };
pub static RASTER_VERTEX: Module = Module { file: "raster.vert", spirv: include_bytes!("../../shaders/spv/raster.vert.spv"), half: None };
pub static RASTER_FRAGMENT: Module = Module { file: "raster.frag", spirv: include_bytes!("../../shaders/spv/raster.frag.spv"), half: None };
pub static BINS: Module = Module { file: "bins.comp", spirv: include_bytes!("../../shaders/spv/bins.comp.spv"), half: None };
pub static RASTER_RGBA8: Module =
    Module { file: "raster_rgba8.comp", spirv: include_bytes!("../../shaders/spv/raster_rgba8.comp.spv"), half: None };
pub static RASTER_RGBA16F: Module =
    Module { file: "raster_rgba16f.comp", spirv: include_bytes!("../../shaders/spv/raster_rgba16f.comp.spv"), half: None };
pub static RASTER_TOGETHER_RGBA8: Module =
    Module { file: "raster_together_rgba8.comp", spirv: include_bytes!("../../shaders/spv/raster_together_rgba8.comp.spv"), half: None };
pub static RASTER_TOGETHER_RGBA16F: Module = Module {
    file: "raster_together_rgba16f.comp",
    spirv: include_bytes!("../../shaders/spv/raster_together_rgba16f.comp.spv"),
    half: None,
};
pub static PRESENT_VERTEX: Module =
    Module { file: "present.vert", spirv: include_bytes!("../../shaders/spv/present.vert.spv"), half: None };
pub static PRESENT_FRAGMENT: Module =
    Module { file: "present.frag", spirv: include_bytes!("../../shaders/spv/present.frag.spv"), half: None };

pub static SURFACE: Module = Module { file: "surface.comp", spirv: include_bytes!("../../shaders/spv/surface.comp.spv"), half: None };
pub static SURFACE_VERTEX: Module =
    Module { file: "surface.vert", spirv: include_bytes!("../../shaders/spv/surface.vert.spv"), half: None };

/// Every module, for the compiler and the tests.
pub static MODULES: &[&Module] = &[
    &FEATURES,
    &FEATURES_BYTES,
    &SURFACE,
    &SURFACE_VERTEX,
    &HARMONICS,
    &SPLATS,
    &SPLATS_POSED,
    &SORT_COUNT,
    &SORT_REDUCE,
    &SORT_SCAN,
    &SORT_SCATTER,
    &SORT_LANES_COUNT,
    &SORT_LANES_SCATTER,
    &SORT_CHAIN,
    &RASTER_VERTEX,
    &RASTER_FRAGMENT,
    &BINS,
    &RASTER_RGBA8,
    &RASTER_RGBA16F,
    &RASTER_TOGETHER_RGBA8,
    &RASTER_TOGETHER_RGBA16F,
    &PRESENT_VERTEX,
    &PRESENT_FRAGMENT,
];

/// Changes with any kernel of the sort: what one build of it did says nothing of another.
pub fn sort_hash() -> u64 {
    let kernels = MODULES.iter().filter(|module| module.file.starts_with("sort_"));
    hash::add(hash::EMPTY, kernels.flat_map(|module| module.spirv).copied())
}

/// File in `shaders/spv` with a line `name fingerprint` for each module.
pub const FINGERPRINTS: &str = "fingerprints.txt";

/// Changes with the source, whose own [`fingerprint`] is given, and with what it was compiled to, with f16 buffers or without.
pub fn module_fingerprint<'a>(source: u64, compiled: impl IntoIterator<Item = &'a [u8]>) -> u64 {
    hash::add(hash::EMPTY, source.to_le_bytes().into_iter().chain(compiled.into_iter().flatten().copied()))
}

/// A number that changes with the text of a shader, of any file it includes, and with the constants it is compiled with (FNV-1a).
pub fn fingerprint(shaders: &Path, file: &str) -> io::Result<u64> {
    let mut hash = hash::EMPTY;
    let mut add = |text: &str| hash = hash::add(hash, text.bytes());
    layout::MACROS.iter().for_each(|(name, value)| add(&format!("{name}={value};")));
    let mut queue = vec![file.to_string()];
    let mut seen = 0;
    while let Some(name) = queue.get(seen).cloned() {
        seen += 1;
        let text = fs::read_to_string(shaders.join(&name))?;
        add(&text);
        for included in text.lines().filter_map(|line| line.trim().strip_prefix("#include \"")?.strip_suffix('"')) {
            if !queue.iter().any(|known| known == included) {
                queue.push(included.to_string());
            }
        }
    }
    Ok(hash)
}
