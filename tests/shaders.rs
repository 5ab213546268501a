//! The compiled modules beside the sources: are they what the sources compile to?

use effigy::{
    vulkan::shaders::{FINGERPRINTS, MODULES, fingerprint, module_fingerprint},
    webgpu::shaders as web,
};
use std::{fs, path::Path};

#[test]
fn no_source_was_changed_after_its_module_was_compiled() {
    let shaders = Path::new(env!("CARGO_MANIFEST_DIR")).join("shaders");
    let recorded = fs::read_to_string(shaders.join("spv").join(FINGERPRINTS)).unwrap();
    for module in MODULES {
        let source = fingerprint(&shaders, module.file).unwrap();
        let now = format!("{} {:016x}", module.file, module_fingerprint(source, module.compiled_modules()));
        assert!(
            recorded.lines().any(|line| line == now),
            "{}, what it includes or what it compiled to changed: run `cargo run --features shaderc --bin compile-shaders` and commit shaders/spv",
            module.file
        );
    }
    assert_eq!(recorded.lines().count(), MODULES.len(), "modules on record");
}

#[test]
fn every_compiled_module_belongs_to_a_source() {
    let compiled = Path::new(env!("CARGO_MANIFEST_DIR")).join("shaders/spv");
    for entry in fs::read_dir(compiled).unwrap() {
        let name = entry.unwrap().file_name().to_string_lossy().into_owned();
        let known = MODULES.iter().any(|module| module.compiled(false) == name || (module.has_half() && module.compiled(true) == name));
        assert!(known || name == FINGERPRINTS, "shaders/spv/{name} is of no module in src/vulkan/shaders.rs");
    }
}

#[test]
fn no_source_was_changed_after_its_wgsl_was_written() {
    let shaders = Path::new(env!("CARGO_MANIFEST_DIR")).join("shaders");
    let recorded = fs::read_to_string(shaders.join("wgsl").join(web::FINGERPRINTS)).unwrap();
    for module in web::MODULES {
        let now = format!("{} {:016x}", module.name, module.fingerprint(fingerprint(&shaders, module.file).unwrap(), module.wgsl));
        assert!(
            recorded.lines().any(|line| line == now),
            "{}.wgsl, its source or what that includes changed: run `cargo run --features shaderc --bin compile-shaders`",
            module.name
        );
    }
    assert_eq!(recorded.lines().count(), web::MODULES.len(), "modules on record");
    for entry in fs::read_dir(shaders.join("wgsl")).unwrap() {
        let name = entry.unwrap().file_name().to_string_lossy().into_owned();
        let known = web::MODULES.iter().any(|module| format!("{}.wgsl", module.name) == name);
        assert!(known || name == web::FINGERPRINTS, "shaders/wgsl/{name} is of no module in src/webgpu/shaders.rs");
    }
}

#[test]
fn wgsl_needs_no_more_than_every_browser_has() {
    for module in web::MODULES {
        let count = |what: &str| module.wgsl.matches(what).count();
        assert!(count("var<storage") <= 8, "{} binds {} storage buffers; 8 are guaranteed", module.name, count("var<storage"));
        for word in ["enable ", "subgroup", "f16,", "override "] {
            assert!(!module.wgsl.contains(word), "{} says `{word}`", module.name);
        }
        if module.file.ends_with(".vert") {
            assert!(!module.wgsl.contains("read_write"), "{} could write; a vertex shader may not", module.name);
        }
    }
}
