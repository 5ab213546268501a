//! Translates each compiled module below `spv` to WGSL, for `lib.rs` to include.

mod translate;

use anyhow::Context;
use std::{
    env, fs,
    path::{Path, PathBuf},
};

fn main() -> anyhow::Result<()> {
    println!("cargo::rerun-if-changed=spv");
    let out = PathBuf::from(env::var("OUT_DIR")?);
    translate_folder(Path::new("spv"), &out)
}

fn translate_folder(from: &Path, to: &Path) -> anyhow::Result<()> {
    fs::create_dir_all(to)?;
    for entry in fs::read_dir(from)? {
        let path = entry?.path();
        let Some(name) = path.file_name() else {
            continue;
        };
        let to = to.join(name);
        if path.is_dir() {
            translate_folder(&path, &to)?;
        } else if path.extension().is_some_and(|extension| extension == "spv") {
            let name = path.display().to_string();
            let spirv = fs::read(&path)?;
            // A module that was added is empty until it is compiled.
            let text = match spirv.as_slice() {
                [] => String::new(),
                spirv => translate::translate(spirv).context(name)?,
            };
            fs::write(to.with_extension("wgsl"), text)?;
        }
    }
    Ok(())
}
