//! What is compiled from the shaders, and how to see whether it is as new as its sources.

use effigy_core::{hash, layout};
use std::{collections::BTreeSet, fs, io, path::Path};

include!("../../src/wgsl/modules.rs");

/// A module for WebGPU: its name, its source below `shaders`, and names and values of macros.
pub struct WebModule {
    /// The name.
    pub name: &'static str,
    /// The source.
    pub file: &'static str,
    /// The macros.
    pub macros: Macros,
}

macro_rules! rows {
    ($($constant:ident = $name:literal, $file:literal, $macros:expr;)*) => {
        /// Every module for WebGPU.
        pub const WEB_MODULES: &[WebModule] = &[$(WebModule {
            name: $name,
            file: $file,
            macros: $macros,
        }),*];
    };
}
web_modules!(rows);

/// File beside compiled modules with a line `name fingerprint` for each.
pub const FINGERPRINTS: &str = "fingerprints.txt";

/// Paths of the files below a folder, with `/` between their parts.
pub fn files(folder: &Path) -> io::Result<BTreeSet<String>> {
    let mut found = BTreeSet::new();
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        if path.is_dir() {
            found.extend(files(&path)?.iter().map(|file| format!("{name}/{file}")));
        } else {
            found.insert(name.into_owned());
        }
    }
    Ok(found)
}

/// Those that are compiled, not included.
pub fn sources(shaders: &Path) -> io::Result<Vec<String>> {
    let is_compiled = |file: &String| {
        let ends = [".comp", ".vert", ".frag"];
        ends.iter().any(|end| file.ends_with(end))
    };
    Ok(files(shaders)?.into_iter().filter(is_compiled).collect())
}

/// A hash (FNV-1a) of a shader's text, of every file that it includes, of the shared macros and of
/// those that it is compiled with, and of what it was compiled to. `shaders` is the folder of the
/// sources, `file` a path in it.
pub fn fingerprint(
    shaders: &Path,
    file: &str,
    macros: &[(&str, &str)],
    compiled: &[u8],
) -> io::Result<u64> {
    let mut hash = hash::EMPTY;
    let mut add = |bytes: &[u8]| hash = hash::extend(hash, bytes.iter().copied());
    for (name, value) in layout::MACROS {
        add(format!("{name}={};", value.glsl()).as_bytes());
    }
    for (name, value) in macros {
        add(format!("{name}={value};").as_bytes());
    }
    let mut queue = vec![file.to_string()];
    let mut seen = 0;
    while let Some(name) = queue.get(seen).cloned() {
        seen += 1;
        let text = fs::read_to_string(shaders.join(&name))?;
        add(text.as_bytes());
        for included in text
            .lines()
            .filter_map(|line| line.trim().strip_prefix("#include \"")?.strip_suffix('"'))
        {
            if !queue.iter().any(|known| known == included) {
                queue.push(included.to_string());
            }
        }
    }
    add(compiled);
    Ok(hash)
}
