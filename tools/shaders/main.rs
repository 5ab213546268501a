//! Compiles the GLSL in `shaders` to SPIR-V with shaderc: in `shaders/spv`, and for WebGPU in
//! `src/wgsl/spv`, of which naga must be able to make WGSL:
//!
//! `cargo run --release -p effigy-shaders --features compile --bin compile-shaders [-- --check]`
//!
//! With `--check` nothing is written; the command fails if a stored module differs from what its
//! source compiles to. The modules are listed in `effigy::vulkan::shaders`, `effigy_wgsl` and
//! `effigy_train::gpu::shaders`. To
//! add one, add its row there and create an empty file in its place, so that this program builds.

#[path = "../../src/wgsl/translate.rs"]
mod translate;

use anyhow::{Context, bail};
use effigy_core::layout;

use effigy::vulkan::shaders::{FINGERPRINTS, MODULES, fingerprint, module_fingerprint};
use effigy_wgsl::WgslModule;
use shaderc::{
    CompileOptions, Compiler, EnvVersion, OptimizationLevel, ResolvedInclude, ShaderKind, TargetEnv,
};
use std::{fs, path::Path};

/// Options for a source with the layout's macros and these, given as names and values.
fn options(
    shaders: &Path,
    macros: &[(&str, &str)],
    level: OptimizationLevel,
) -> anyhow::Result<CompileOptions<'static>> {
    let mut options = CompileOptions::new()?;
    options.set_target_env(TargetEnv::Vulkan, EnvVersion::Vulkan1_1 as u32);
    options.set_optimization_level(level);
    options.set_warnings_as_errors();
    for (name, value) in layout::MACROS {
        options.add_macro_definition(name, Some(&value.glsl()));
    }
    for (name, value) in macros {
        options.add_macro_definition(name, Some(value));
    }
    let shaders = shaders.to_path_buf();
    options.set_include_callback(move |name, _, _, _| {
        let content =
            fs::read_to_string(shaders.join(name)).map_err(|error| format!("{name}: {error}"))?;
        Ok(ResolvedInclude {
            resolved_name: name.to_string(),
            content,
        })
    });
    Ok(options)
}

/// The folder of the sources, and the compiler.
struct Sources<'a> {
    compiler: Compiler,
    shaders: &'a Path,
}

impl Sources<'_> {
    /// Compiles a file to SPIR-V.
    fn compile(
        &self,
        file: &str,
        macros: &[(&str, &str)],
        level: OptimizationLevel,
    ) -> anyhow::Result<Vec<u8>> {
        let kind = match file.rsplit('.').next() {
            Some("comp") => ShaderKind::Compute,
            Some("vert") => ShaderKind::Vertex,
            Some("frag") => ShaderKind::Fragment,
            _ => bail!("{file}: expected a name that ends in .comp, .vert or .frag"),
        };
        let source =
            fs::read_to_string(self.shaders.join(file)).with_context(|| file.to_string())?;
        let options = options(self.shaders, macros, level)?;
        let artifact =
            self.compiler
                .compile_into_spirv(&source, kind, file, "main", Some(&options))?;
        Ok(artifact.as_binary_u8().to_vec())
    }

    /// Compiles a module for WebGPU. naga cannot translate some loops that the optimiser has
    /// restructured: those modules are compiled without optimisation.
    fn compile_for_web(&self, module: &WgslModule) -> anyhow::Result<Vec<u8>> {
        let macros = [&[("WEB", "1")], module.macros].concat();
        let compile = |level| {
            let spirv = self.compile(module.file, &macros, level)?;
            translate::translate(&spirv)?;
            anyhow::Ok(spirv)
        };
        compile(OptimizationLevel::Performance)
            .or_else(|_| compile(OptimizationLevel::Zero))
            .context(module.name)
    }
}

/// Writes files, or compares them with those that exist.
struct Output {
    check: bool,
    /// Files that differ.
    stale: Vec<String>,
}

impl Output {
    fn file(&mut self, folder: &Path, name: &str, content: &[u8]) -> anyhow::Result<()> {
        let path = folder.join(name);
        if !self.check {
            if let Some(parent) = path.parent() {
                fs::create_dir_all(parent)?;
            }
            return fs::write(&path, content).with_context(|| name.to_string());
        }
        if fs::read(path).ok().as_deref() != Some(content) {
            self.stale.push(name.to_string());
        }
        Ok(())
    }
}

fn write_spirv(sources: &Sources, output: &mut Output) -> anyhow::Result<()> {
    let folder = sources.shaders.join("spv");
    let mut fingerprints = String::new();
    for module in MODULES.iter().chain(effigy_train::gpu::shaders::MODULES) {
        let words = sources.compile(module.file, &[], OptimizationLevel::Performance)?;
        output.file(&folder, &module.compiled(), &words)?;
        let source = fingerprint(sources.shaders, module.file)?;
        let fingerprint = module_fingerprint(source, &words);
        fingerprints += &format!("{} {fingerprint:016x}\n", module.file);
    }
    output.file(&folder, FINGERPRINTS, fingerprints.as_bytes())
}

fn write_web(sources: &Sources, output: &mut Output) -> anyhow::Result<()> {
    let folder = sources.shaders.join("../src/wgsl");
    let mut fingerprints = String::new();
    for module in effigy_wgsl::MODULES {
        let words = sources.compile_for_web(module)?;
        output.file(&folder, &module.compiled(), &words)?;
        let source = fingerprint(sources.shaders, module.file)?;
        let fingerprint =
            module_fingerprint(source, &[module.macro_text().as_bytes(), &words].concat());
        fingerprints += &format!("{} {fingerprint:016x}\n", module.name);
    }
    output.file(&folder.join("spv"), FINGERPRINTS, fingerprints.as_bytes())
}

fn main() -> anyhow::Result<()> {
    let mut output = Output {
        check: std::env::args().any(|argument| argument == "--check"),
        stale: Vec::new(),
    };
    let shaders = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shaders");
    let sources = Sources {
        compiler: Compiler::new()?,
        shaders: &shaders,
    };
    write_spirv(&sources, &mut output)?;
    write_web(&sources, &mut output)?;
    if !output.stale.is_empty() {
        bail!(
            "modules differ from what their sources compile to: {}; run compile-shaders and commit the result",
            output.stale.join(", ")
        );
    }
    if !output.check {
        println!(
            "compiled {} modules, and {} for WebGPU",
            MODULES.len(),
            effigy_wgsl::MODULES.len()
        );
    }
    Ok(())
}
