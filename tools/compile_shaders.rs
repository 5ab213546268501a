//! Compiles `shaders/*` to the modules in `shaders/spv` with shaderc: `cargo run --features shaderc --bin compile-shaders`.
//! With `--check` it writes nothing and fails where a module is not what its source compiles to.

use anyhow::{Context, bail};
use effigy::{
    layout,
    vulkan::shaders::{FINGERPRINTS, MODULES, Module, fingerprint},
};
use shaderc::{CompileOptions, Compiler, EnvVersion, OptimizationLevel, ResolvedInclude, ShaderKind, TargetEnv};
use std::{fs, path::Path};

fn options(shaders: &Path, half: bool) -> anyhow::Result<CompileOptions<'static>> {
    let mut options = CompileOptions::new()?;
    options.set_target_env(TargetEnv::Vulkan, EnvVersion::Vulkan1_1 as u32);
    options.set_optimization_level(OptimizationLevel::Performance);
    options.set_warnings_as_errors();
    for (name, value) in layout::MACROS {
        options.add_macro_definition(name, Some(&format!("{value}u")));
    }
    if half {
        options.add_macro_definition("HALF_STORAGE", None);
    }
    let shaders = shaders.to_path_buf();
    options.set_include_callback(move |name, _, _, _| {
        let content = fs::read_to_string(shaders.join(name)).map_err(|error| format!("{name}: {error}"))?;
        Ok(ResolvedInclude { resolved_name: name.to_string(), content })
    });
    Ok(options)
}

fn compile(compiler: &Compiler, shaders: &Path, module: &Module, half: bool) -> anyhow::Result<Vec<u8>> {
    let kind = match module.file.rsplit('.').next() {
        Some("comp") => ShaderKind::Compute,
        Some("vert") => ShaderKind::Vertex,
        Some("frag") => ShaderKind::Fragment,
        _ => bail!("{}: expected a name that ends in .comp, .vert or .frag", module.file),
    };
    let source = fs::read_to_string(shaders.join(module.file)).with_context(|| module.file.to_string())?;
    let artifact = compiler.compile_into_spirv(&source, kind, module.file, "main", Some(&options(shaders, half)?))?;
    Ok(artifact.as_binary_u8().to_vec())
}

fn main() -> anyhow::Result<()> {
    let check = std::env::args().any(|argument| argument == "--check");
    let shaders = Path::new(env!("CARGO_MANIFEST_DIR")).join("shaders");
    let compiled = shaders.join("spv");
    let compiler = Compiler::new()?;
    let mut fingerprints = String::new();
    let mut stale = Vec::new();
    for module in MODULES {
        for half in [false, true].into_iter().filter(|half| !half || module.has_half()) {
            let name = module.compiled(half);
            let spirv = compile(&compiler, &shaders, module, half)?;
            if check {
                if fs::read(compiled.join(&name)).ok() != Some(spirv) {
                    stale.push(name);
                }
            } else {
                fs::write(compiled.join(&name), spirv).with_context(|| name.clone())?;
            }
        }
        fingerprints += &format!("{} {:016x}\n", module.file, fingerprint(&shaders, module.file)?);
    }
    if !stale.is_empty() {
        bail!("not what their sources compile to: {}; run compile-shaders and commit the result", stale.join(", "));
    }
    if !check {
        fs::write(compiled.join(FINGERPRINTS), fingerprints)?;
        println!("compiled {} modules", MODULES.len());
    }
    Ok(())
}
