//! Compiles the GLSL in `shaders` to SPIR-V with shaderc: in `shaders/spv`, and for WebGPU in
//! `src/wgsl/spv`, of which naga must be able to make WGSL:
//!
//! `cargo run --release -p effigy-shaders --features compile --bin compile-shaders [-- --check]`
//!
//! What is as new as its sources is left as it is. With `--check` everything is compiled and nothing
//! is written; the command fails if a stored module differs from what its source compiles to. The
//! renderer's modules are listed in `effigy_render::vulkan::shaders`, those for WebGPU in
//! `src/wgsl/modules.rs`, those of the training in `effigy_train::gpu::shaders`.

#[path = "../../src/wgsl/translate.rs"]
mod translate;

use anyhow::{Context, bail};
use effigy_core::layout;
use effigy_shaders::{FINGERPRINTS, WEB_MODULES, fingerprint, sources};
use shaderc::{
    CompileOptions, Compiler, EnvVersion, OptimizationLevel, ResolvedInclude, ShaderKind, TargetEnv,
};
use std::{fs, path::Path};

/// A module: what it is called, and how it is compiled.
struct Job<'a> {
    name: &'a str,
    /// Below `shaders`.
    file: &'a str,
    macros: &'a [(&'a str, &'a str)],
    /// Whether naga must be able to translate it.
    web: bool,
}

/// The folder of the sources, and the compiler.
struct Sources<'a> {
    compiler: Compiler,
    shaders: &'a Path,
}

impl Sources<'_> {
    fn options(
        &self,
        job: &Job,
        level: OptimizationLevel,
    ) -> anyhow::Result<CompileOptions<'static>> {
        let mut options = CompileOptions::new()?;
        options.set_target_env(TargetEnv::Vulkan, EnvVersion::Vulkan1_1 as u32);
        options.set_optimization_level(level);
        options.set_warnings_as_errors();
        for (name, value) in layout::MACROS {
            options.add_macro_definition(name, Some(&value.glsl()));
        }
        for (name, value) in job.macros {
            options.add_macro_definition(name, Some(value));
        }
        if job.web {
            options.add_macro_definition("WEB", Some("1"));
        }
        let shaders = self.shaders.to_path_buf();
        options.set_include_callback(move |name, _, _, _| {
            let content = fs::read_to_string(shaders.join(name))
                .map_err(|error| format!("{name}: {error}"))?;
            Ok(ResolvedInclude {
                resolved_name: name.to_string(),
                content,
            })
        });
        Ok(options)
    }

    fn compile_at(&self, job: &Job, level: OptimizationLevel) -> anyhow::Result<Vec<u8>> {
        let file = job.file;
        let kind = match file.rsplit('.').next() {
            Some("comp") => ShaderKind::Compute,
            Some("vert") => ShaderKind::Vertex,
            Some("frag") => ShaderKind::Fragment,
            _ => bail!("{file}: expected a name that ends in .comp, .vert or .frag"),
        };
        let source = fs::read_to_string(self.shaders.join(file)).context(file.to_string())?;
        let options = self.options(job, level)?;
        let artifact =
            self.compiler
                .compile_into_spirv(&source, kind, file, "main", Some(&options))?;
        let spirv = artifact.as_binary_u8().to_vec();
        if job.web {
            translate::translate(&spirv)?;
        }
        Ok(spirv)
    }

    /// naga cannot translate some loops that the optimiser has restructured: those modules are
    /// compiled without optimisation.
    fn compile(&self, job: &Job) -> anyhow::Result<Vec<u8>> {
        let best = self.compile_at(job, OptimizationLevel::Performance);
        match best {
            Err(_) if job.web => self.compile_at(job, OptimizationLevel::Zero),
            best => best,
        }
        .context(job.name.to_string())
    }
}

/// Writes modules, or compares them with those that exist.
struct Output {
    check: bool,
    compiled: usize,
    /// Modules that differ.
    stale: Vec<String>,
}

impl Output {
    /// Compiles what a folder holds.
    fn folder(&mut self, sources: &Sources, folder: &Path, jobs: &[Job]) -> anyhow::Result<()> {
        let known = fs::read_to_string(folder.join(FINGERPRINTS)).unwrap_or_default();
        let mut lines = String::new();
        for job in jobs {
            let path = folder.join(format!("{}.spv", job.name));
            let line = |spirv: &[u8]| -> anyhow::Result<String> {
                let fingerprint = fingerprint(sources.shaders, job.file, job.macros, spirv)?;
                Ok(format!("{} {fingerprint:016x}", job.name))
            };
            let stored = fs::read(&path).unwrap_or_default();
            let mut own = line(&stored)?;
            if self.check || !known.lines().any(|known| known == own) {
                let spirv = sources.compile(job)?;
                self.compiled += 1;
                own = line(&spirv)?;
                self.put(&path, &spirv)?;
            }
            lines += &own;
            lines.push('\n');
        }
        self.put(&folder.join(FINGERPRINTS), lines.as_bytes())
    }

    fn put(&mut self, path: &Path, content: &[u8]) -> anyhow::Result<()> {
        if fs::read(path).ok().as_deref() == Some(content) {
            return Ok(());
        }
        let name = path.display().to_string();
        if self.check {
            self.stale.push(name);
            return Ok(());
        }
        if let Some(parent) = path.parent() {
            fs::create_dir_all(parent)?;
        }
        fs::write(path, content).context(name)
    }
}

fn main() -> anyhow::Result<()> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let shaders = root.join("shaders");
    let compiler = Sources {
        compiler: Compiler::new()?,
        shaders: &shaders,
    };
    let mut output = Output {
        check: std::env::args().any(|argument| argument == "--check"),
        compiled: 0,
        stale: Vec::new(),
    };
    let files = sources(&shaders)?;
    let native = files.iter().map(|file| Job {
        name: file,
        file,
        macros: &[],
        web: false,
    });
    let web = WEB_MODULES.iter().map(|module| Job {
        name: module.name,
        file: module.file,
        macros: module.macros,
        web: true,
    });
    let (native, web): (Vec<Job>, Vec<Job>) = (native.collect(), web.collect());
    output.folder(&compiler, &shaders.join("spv"), &native)?;
    output.folder(&compiler, &root.join("src/wgsl/spv"), &web)?;
    if !output.stale.is_empty() {
        bail!(
            "modules differ from what their sources compile to: {}; run compile-shaders and commit the result",
            output.stale.join(", ")
        );
    }
    if !output.check {
        let all = native.len() + web.len();
        println!("compiled {} of {all} modules", output.compiled);
    }
    Ok(())
}
