//! The compiled shader modules match their sources and WebGPU's limits.

use effigy_core::layout::{self, MacroValue};
use effigy_render::vulkan::shaders::{MODULES, Module};
use effigy_shaders::{FINGERPRINTS, WEB_MODULES, fingerprint, sources};
use effigy_wgsl as web;
use std::{
    collections::BTreeSet,
    fs,
    path::{Path, PathBuf},
};

const REMEDY: &str = "run `cargo run --release -p effigy-shaders --features compile --bin compile-shaders` and commit \
                      shaders/spv and src/wgsl/spv";

/// The package of what is compiled for WebGPU.
fn web_folder() -> PathBuf {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).join("src/wgsl")
}

fn shaders() -> PathBuf {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).join("shaders")
}

/// Paths below a folder, with `/` between their parts.
fn files(folder: &Path) -> BTreeSet<String> {
    effigy_shaders::files(folder).unwrap()
}

/// The modules of the renderer, and those of the training.
fn modules() -> impl Iterator<Item = &'static Module> {
    let trained = effigy_train::gpu::shaders::MODULES;
    MODULES.iter().chain(trained).copied()
}

/// Checks the record of a folder of compiled modules: names, sources and macros.
fn matches_its_sources<'a>(
    folder: &Path,
    modules: impl Iterator<Item = (&'a str, &'a str, &'a [(&'a str, &'a str)])>,
) {
    let recorded = fs::read_to_string(folder.join(FINGERPRINTS)).unwrap();
    let mut count = 0;
    for (name, file, macros) in modules {
        let spirv = fs::read(folder.join(format!("{name}.spv"))).unwrap();
        let now = fingerprint(&shaders(), file, macros, &spirv).unwrap();
        let line = format!("{name} {now:016x}");
        assert!(
            recorded.lines().any(|known| known == line),
            "{file} or a file that it includes changed after {name}.spv was written: {REMEDY}"
        );
        count += 1;
    }
    assert_eq!(recorded.lines().count(), count, "modules on record");
}

fn spirv_matches_its_sources() {
    let files = sources(&shaders()).unwrap();
    let modules = files
        .iter()
        .map(|file| (file.as_str(), file.as_str(), &[][..]));
    matches_its_sources(&shaders().join("spv"), modules);
}

fn wgsl_matches_its_sources() {
    let modules = WEB_MODULES
        .iter()
        .map(|module| (module.name, module.file, module.macros));
    matches_its_sources(&web_folder().join("spv"), modules);
}

fn compiled_files_are_those_of_the_modules() {
    let mut spirv = BTreeSet::from([FINGERPRINTS.to_string()]);
    for module in modules() {
        spirv.insert(module.compiled());
    }
    assert_eq!(files(&shaders().join("spv")), spirv);
    let modules = WEB_MODULES.iter();
    let web = modules.map(|module| format!("{}.spv", module.name));
    let web: BTreeSet<String> = web.chain([FINGERPRINTS.to_string()]).collect();
    assert_eq!(files(&web_folder().join("spv")), web);
}

fn wgsl_stays_within_the_default_limits() {
    for module in web::MODULES {
        let count = |what: &str| module.wgsl.matches(what).count();
        assert!(
            count("var<storage") <= 8,
            "{} binds {} storage buffers; 8 are guaranteed",
            module.name,
            count("var<storage")
        );
        for word in ["enable ", "subgroup", "f16,"] {
            assert!(!module.wgsl.contains(word), "{} says `{word}`", module.name);
        }
        if module.file.ends_with(".vert") {
            assert!(
                !module.wgsl.contains("read_write"),
                "{} could write; a vertex shader may not",
                module.name
            );
        }
    }
}

fn storage_images_have_the_format_that_is_replaced() {
    for module in web::MODULES {
        let images = module.wgsl.matches("texture_storage_2d<").count();
        let replaced = module.wgsl.matches(web::IMAGE_FORMAT).count();
        let raster = module.name == web::RASTER_SHARED.name;
        let samples = module.name == web::SATURATION.name;
        assert_eq!(replaced, usize::from(raster), "{}", module.name);
        assert_eq!(images, usize::from(raster || samples), "{}", module.name);
    }
}

/// Numbers that Rust shares with the shaders come from `layout::MACROS`.
fn shaders_repeat_no_shared_number() {
    // There it bounds a length, which has nothing to do with VARIANCE_MAX.
    let exception = ("project/pose_cache.glsl", "VARIANCE_MAX");
    for file in files(&shaders()) {
        let extension = file.rsplit('.').next().unwrap();
        if !["glsl", "comp", "vert", "frag"].contains(&extension) {
            continue;
        }
        let text = fs::read_to_string(shaders().join(&file)).unwrap();
        for (name, value) in layout::MACROS {
            let MacroValue::Float(number) = value else {
                continue;
            };
            let repeated = text
                .split(|c: char| !c.is_alphanumeric() && c != '.' && c != '_')
                .any(|word| word.parse::<f64>() == Ok(*number) && word.contains(['.', 'e']));
            assert!(
                !repeated || (file.as_str(), *name) == exception,
                "{file} repeats {name} = {}",
                value.glsl()
            );
        }
    }
}

tests! {
    spirv_matches_its_sources,
    wgsl_matches_its_sources,
    compiled_files_are_those_of_the_modules,
    wgsl_stays_within_the_default_limits,
    storage_images_have_the_format_that_is_replaced,
    shaders_repeat_no_shared_number,
}
