//! What each command is called, and what it says when it can't.

use crate::common;
use std::process::Command;

fn lab(arguments: &str) -> (bool, String) {
    let output = Command::new(common::lab())
        .args(arguments.split_whitespace())
        .output()
        .unwrap();
    let said = [output.stdout, output.stderr].concat();
    let said = String::from_utf8_lossy(&said).into_owned();
    (output.status.success(), said)
}

fn its_help_names_every_command() {
    let (works, said) = lab("--help");
    assert!(works, "{said}");
    for command in [
        "stress",
        "bench-sort",
        "bench-device",
        "bench-train",
        "shader-stats",
        "verdict",
    ] {
        assert!(said.contains(command), "{said}");
        let (works, said) = lab(&format!("{command} --help"));
        assert!(works && said.contains("--json"), "{said}");
    }
}

fn outputs_are_checked_before_the_work() {
    let folder = tempfile::tempdir().unwrap();
    let nowhere = folder.path().join("none").join("o.json");
    for command in [
        "stress",
        "bench-sort",
        "bench-device",
        "bench-train",
        "shader-stats",
        "verdict .",
    ] {
        for out in [nowhere.to_str().unwrap(), "o.txt"] {
            let (works, said) = lab(&format!("{command} --json {out}"));
            assert!(!works && said.starts_with("error: "), "{said}");
        }
    }
}

fn what_is_not_there_is_a_sentence() {
    let (works, said) = lab("verdict no-folder");
    assert!(
        !works && said.contains("no-folder is neither a run's folder nor a survey's file"),
        "{said}"
    );
}

tests! {
    its_help_names_every_command,
    outputs_are_checked_before_the_work,
    what_is_not_there_is_a_sentence,
}
