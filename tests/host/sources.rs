//! The test sources themselves: each file is compiled, and no test hides from the harness.

use std::{
    fs,
    path::{Path, PathBuf},
};

/// Rust files below a folder.
fn sources(folder: &Path) -> Vec<PathBuf> {
    let mut found = vec![];
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            found.extend(sources(&path));
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            found.push(path);
        }
    }
    found
}

fn tests() -> PathBuf {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).join("tests")
}

/// A file that no `mod` names is not compiled, and its tests never run.
fn every_file_is_a_module() {
    for path in sources(&tests()) {
        let folder = path.parent().unwrap();
        let (name, parent) = match path.file_stem().unwrap().to_str().unwrap() {
            "main" => continue,
            "mod" => (
                folder.file_name().unwrap().to_str().unwrap(),
                folder.parent().unwrap(),
            ),
            name => (name, folder),
        };
        let declared = ["main.rs", "mod.rs", "host/main.rs"].iter().any(|file| {
            fs::read_to_string(parent.join(file))
                .is_ok_and(|text| text.contains(&format!("mod {name};")))
        });
        assert!(declared, "no `mod {name};` for {}", path.display());
    }
}

/// The compiler drops functions with that attribute where the harness is our own.
fn no_test_has_the_test_attribute() {
    let attribute = ["#[", "test]"].concat();
    for path in sources(&tests()) {
        let text = fs::read_to_string(&path).unwrap();
        assert!(
            !text.contains(&attribute),
            "{}: list tests in `tests!` instead of {attribute}",
            path.display()
        );
    }
}

/// Steps of a GPU's verdict run in shells of their own, which know what they are handed alone. A
/// run tells: but it takes minutes, and one that matters a GPU.
fn the_bundle_hands_on_what_its_steps_read() {
    let script = fs::read_to_string(tests().join("../tools/gpu/run.sh")).unwrap();
    let (_, steps) = script.split_once("\nbench() {").unwrap();
    let (steps, rest) = steps.split_once("\nexport -f bench do_step").unwrap();
    let (_, settings) = rest.split_once("settings=$(declare -p ").unwrap();
    let settings: Vec<&str> = settings.split(')').next().unwrap().split(' ').collect();
    let is_name = |c: char| c.is_ascii_lowercase() || c == '_';
    let mut read = 0;
    for after in steps.split('$').skip(1) {
        let name = after.trim_start_matches('{');
        let name = name.split(|c| !is_name(c)).next().unwrap();
        if name.is_empty() || steps.contains(&format!("local {name}=")) {
            continue;
        }
        read += 1;
        assert!(
            settings.contains(&name),
            "a step reads ${name}, which it is not handed"
        );
    }
    assert!(
        read > 10,
        "only {read} variables were found in what the steps run"
    );
}

/// The README is short, and its Rust is that of the library's documentation, which is compiled.
fn the_readme_is_short_and_its_code_compiles() {
    let root = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."));
    let readme = fs::read_to_string(root.join("README.md")).unwrap();
    let lines = readme.lines().count();
    let words = readme.split_whitespace().count();
    assert!(
        lines <= 130 && words <= 1000,
        "{lines} lines, {words} words"
    );

    let documented = fs::read_to_string(root.join("src/lib.rs")).unwrap();
    let documented: Vec<&str> = documented
        .lines()
        .filter_map(|line| line.strip_prefix("//!"))
        .map(str::trim)
        .collect();
    let (_, code) = readme.split_once("```rust\n").unwrap();
    let (code, _) = code.split_once("```").unwrap();
    for line in code.lines().map(str::trim) {
        assert!(
            documented.contains(&line),
            "src/lib.rs does not show: {line}"
        );
    }
}

tests! {
    the_readme_is_short_and_its_code_compiles,
    every_file_is_a_module,
    no_test_has_the_test_attribute,
    the_bundle_hands_on_what_its_steps_read,
}
