//! Compiles `shaders/*` to the modules in `shaders/spv` with shaderc, and with naga from there to those in `shaders/wgsl`:
//! `cargo run --features shaderc --bin compile-shaders`.
//! With `--check` it writes nothing and fails where a module is not what its source compiles to.

mod wgsl;

use anyhow::{Context, bail};
use effigy::{
    layout,
    vulkan::shaders::{FINGERPRINTS, MODULES, fingerprint, module_fingerprint},
    webgpu,
};
use shaderc::{CompileOptions, Compiler, EnvVersion, OptimizationLevel, ResolvedInclude, ShaderKind, TargetEnv};
use std::{fs, path::Path};

/// `macros`: names and values besides those of the layout.
fn options(shaders: &Path, macros: &[(&str, &str)], level: OptimizationLevel) -> anyhow::Result<CompileOptions<'static>> {
    let mut options = CompileOptions::new()?;
    options.set_target_env(TargetEnv::Vulkan, EnvVersion::Vulkan1_1 as u32);
    options.set_optimization_level(level);
    options.set_warnings_as_errors();
    for (name, value) in layout::MACROS {
        options.add_macro_definition(name, Some(&format!("{value}u")));
    }
    macros.iter().for_each(|(name, value)| options.add_macro_definition(name, Some(value)));
    let shaders = shaders.to_path_buf();
    options.set_include_callback(move |name, _, _, _| {
        let content = fs::read_to_string(shaders.join(name)).map_err(|error| format!("{name}: {error}"))?;
        Ok(ResolvedInclude { resolved_name: name.to_string(), content })
    });
    Ok(options)
}

/// The sources and what compiles them.
struct Sources<'a> {
    compiler: Compiler,
    shaders: &'a Path,
}

impl Sources<'_> {
    /// SPIR-V.
    fn compile(&self, file: &str, macros: &[(&str, &str)], level: OptimizationLevel) -> anyhow::Result<Vec<u8>> {
        let kind = match file.rsplit('.').next() {
            Some("comp") => ShaderKind::Compute,
            Some("vert") => ShaderKind::Vertex,
            Some("frag") => ShaderKind::Fragment,
            _ => bail!("{file}: expected a name that ends in .comp, .vert or .frag"),
        };
        let source = fs::read_to_string(self.shaders.join(file)).with_context(|| file.to_string())?;
        let options = options(self.shaders, macros, level)?;
        let artifact = self.compiler.compile_into_spirv(&source, kind, file, "main", Some(&options))?;
        Ok(artifact.as_binary_u8().to_vec())
    }

    /// WGSL. What the optimiser makes of some loops is more than naga follows: those stay as they are written.
    fn translate(&self, module: &webgpu::shaders::Module) -> anyhow::Result<String> {
        let macros = [&[("WEB", "1")], module.macros].concat();
        let with = |level| wgsl::translate(&self.compile(module.file, &macros, level)?);
        with(OptimizationLevel::Performance).or_else(|_| with(OptimizationLevel::Zero)).context(module.name)
    }
}

/// What is written, or held against what is there.
struct Output {
    check: bool,
    stale: Vec<String>,
}

impl Output {
    fn file(&mut self, folder: &Path, name: &str, content: &[u8]) -> anyhow::Result<()> {
        let path = folder.join(name);
        if !self.check {
            return fs::write(&path, content).with_context(|| name.to_string());
        }
        if fs::read(path).ok().as_deref() != Some(content) {
            self.stale.push(name.to_string());
        }
        Ok(())
    }
}

fn main() -> anyhow::Result<()> {
    let mut output = Output { check: std::env::args().any(|argument| argument == "--check"), stale: Vec::new() };
    let shaders = Path::new(env!("CARGO_MANIFEST_DIR")).join("shaders");
    let sources = Sources { compiler: Compiler::new()?, shaders: &shaders };
    let [spirv, wgsl] = ["spv", "wgsl"].map(|folder| shaders.join(folder));
    let mut fingerprints = String::new();
    for module in MODULES {
        let mut compiled = Vec::new();
        for half in [false, true].into_iter().filter(|half| !half || module.has_half()) {
            let macros: &[_] = if half { &[("HALF_STORAGE", "1")] } else { &[] };
            let words = sources.compile(module.file, macros, OptimizationLevel::Performance)?;
            output.file(&spirv, &module.compiled(half), &words)?;
            compiled.push(words);
        }
        let fingerprint = module_fingerprint(fingerprint(&shaders, module.file)?, compiled.iter().map(Vec::as_slice));
        fingerprints += &format!("{} {fingerprint:016x}\n", module.file);
    }
    output.file(&spirv, FINGERPRINTS, fingerprints.as_bytes())?;
    fingerprints.clear();
    for module in webgpu::shaders::MODULES {
        let text = sources.translate(module)?;
        output.file(&wgsl, &format!("{}.wgsl", module.name), text.as_bytes())?;
        fingerprints += &format!("{} {:016x}\n", module.name, module.fingerprint(fingerprint(&shaders, module.file)?, &text));
    }
    output.file(&wgsl, webgpu::shaders::FINGERPRINTS, fingerprints.as_bytes())?;
    if !output.stale.is_empty() {
        bail!("not what their sources compile to: {}; run compile-shaders and commit the result", output.stale.join(", "));
    }
    if !output.check {
        println!("compiled {} modules, and {} for WebGPU", MODULES.len(), webgpu::shaders::MODULES.len());
    }
    Ok(())
}
