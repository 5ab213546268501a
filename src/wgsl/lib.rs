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

include!("modules.rs");
web_modules!(modules);

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
}
