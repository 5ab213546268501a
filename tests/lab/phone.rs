//! `tools/phone.sh` with an `adb` in the place of a phone.

use crate::common;
use effigy_measure::{report::DeviceReport, survey::SurveyReport};
use std::{fs, os::unix::fs::PermissionsExt, path::Path, process::Command};

tests! {
    a_phone_is_waited_for_and_becomes_a_page,
    a_phone_that_never_ends_keeps_what_it_has,
}

/// What the script made: whether it says that all is well, what it says, and the page.
struct Made {
    success: bool,
    said: String,
    page: String,
    asked: String,
}

/// Runs the script with a phone that has nothing first, `begun` then, and `over` at last.
fn phone(begun: &str, over: &str, minutes: &str) -> Made {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    fs::write(at("begun"), begun).unwrap();
    fs::write(at("over"), over).unwrap();
    fs::write(at("app.apk"), "an app").unwrap();
    let adb = r#"#!/bin/sh
cd "$(dirname "$0")"
echo "$*" >> asked
[ "$1" = pull ] || exit 0
pulls=$(grep -c ^pull asked)
[ "$pulls" -gt 1 ] || { echo "no such file" >&2; exit 1; }
if [ "$pulls" = 2 ]; then cp begun "$3"; else cp over "$3"; fi
"#;
    fs::write(at("adb"), adb).unwrap();
    fs::set_permissions(at("adb"), fs::Permissions::from_mode(0o755)).unwrap();
    let root = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."));
    let path = std::env::var("PATH").unwrap();
    let output = Command::new(root.join("tools/phone.sh"))
        .args([at("app.apk"), at("out")])
        .env("PATH", format!("{}:{path}", folder.path().display()))
        .env("EFFIGY_LAB", common::lab())
        .env("MINUTES", minutes)
        .output()
        .unwrap();
    let said = [output.stdout, output.stderr].concat();
    Made {
        success: output.status.success(),
        said: String::from_utf8_lossy(&said).into_owned(),
        page: fs::read_to_string(at("out/verdict.md")).unwrap_or_default(),
        asked: fs::read_to_string(at("asked")).unwrap_or_default(),
    }
}

fn report() -> SurveyReport {
    let device = DeviceReport {
        name: "Mali-G715".into(),
        driver: "v1.r44p0".into(),
        vulkan: "1.3.0".into(),
        subgroup_size: 16,
        timestamps: true,
        backend: "vulkan".into(),
    };
    SurveyReport::new("Google Pixel 8, Android 15".into(), device)
}

fn a_phone_is_waited_for_and_becomes_a_page() {
    let begun = report();
    let mut over = begun.clone();
    over.over = true;
    over.explain("the window was left");
    let made = phone(&begun.json(), &over.json(), "3");
    assert_eq!(made.asked.matches("pull ").count(), 3, "{}", made.asked);
    for asked in ["install -r ", "--ef survey 3", "rm -f /sdcard/"] {
        assert!(made.asked.contains(asked), "{}", made.asked);
    }
    for line in [
        "# Verdict on Mali-G715",
        "Google Pixel 8, Android 15",
        "| soak | **did not run** | 0 | 75 | the window was left |",
    ] {
        assert!(made.page.contains(line), "{}", made.page);
    }
    // Nothing that did not run counts as passed.
    assert!(
        !made.success && made.said.contains("soak did not run"),
        "{}",
        made.said
    );
}

fn a_phone_that_never_ends_keeps_what_it_has() {
    let begun = report().json();
    let made = phone(&begun, &begun, "0.02");
    assert!(
        !made.success && made.said.contains("not over after 4 s"),
        "{}",
        made.said
    );
    assert!(
        made.page.contains("the program ended before it was over"),
        "{}",
        made.page
    );
}
