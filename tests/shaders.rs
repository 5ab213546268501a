//! The compiled modules beside the sources: are they what the sources compile to?

use effigy::vulkan::shaders::{FINGERPRINTS, MODULES, fingerprint};
use std::{fs, path::Path};

#[test]
fn no_source_was_changed_after_its_module_was_compiled() {
    let shaders = Path::new(env!("CARGO_MANIFEST_DIR")).join("shaders");
    let recorded = fs::read_to_string(shaders.join("spv").join(FINGERPRINTS)).unwrap();
    for module in MODULES {
        let now = format!("{} {:016x}", module.file, fingerprint(&shaders, module.file).unwrap());
        assert!(
            recorded.lines().any(|line| line == now),
            "{} or what it includes changed: run `cargo run --features shaderc --bin compile-shaders` and commit shaders/spv",
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
