//! Tells the program which commit it is built from, so that measurements can say what they
//! measured. In: the checkout, if it is one. Out: `EFFIGY_COMMIT`, with a `+` where files differ
//! from the commit; unset without git, and in debug builds, which nobody measures.

use std::process::Command;

fn git(arguments: &[&str]) -> Option<String> {
    let output = Command::new("git")
        .args(["-C", "../.."])
        .args(arguments)
        .output()
        .ok()
        .filter(|output| output.status.success())?;
    Some(String::from_utf8(output.stdout).ok()?.trim().to_owned())
}

fn main() {
    // Naming any path at all keeps cargo from watching the whole package, large assets included.
    println!("cargo::rerun-if-changed=build.rs");
    if std::env::var("PROFILE").as_deref() != Ok("release") {
        return;
    }
    let sources = ["Cargo.toml", "Cargo.lock", "src", "shaders"];
    for path in sources {
        println!("cargo::rerun-if-changed=../../{path}");
    }
    // Every commit and checkout adds a line here.
    let log = git(&[
        "rev-parse",
        "--path-format=absolute",
        "--git-path",
        "logs/HEAD",
    ]);
    if let Some(log) = log.filter(|path| std::path::Path::new(path).exists()) {
        println!("cargo::rerun-if-changed={log}");
    }
    // A copy of the package inside somebody else's repository has none of that repository's
    // commits.
    if git(&["ls-files", "--error-unmatch", "Cargo.toml"]).is_none() {
        return;
    }
    let changed = git(&[&["status", "--porcelain", "--"], &sources[..]].concat())
        .is_some_and(|list| !list.is_empty());
    if let Some(commit) = git(&["rev-parse", "--short=12", "HEAD"]) {
        println!(
            "cargo::rustc-env=EFFIGY_COMMIT={commit}{}",
            if changed { "+" } else { "" }
        );
    }
}
