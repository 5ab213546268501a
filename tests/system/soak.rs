//! The soak on a device: what it writes, what it says when it fails, and that nothing grows.

use crate::common::{self, gpu};
use effigy_measure::soak::{SoakReport, report::Second};
use std::{
    fs,
    io::{BufRead, BufReader},
    path::Path,
    process::{Command, Output, Stdio},
};

const SMALL: &str = "--size 64x80 --late 100 --growth 1000";

/// A soak of a small avatar in a folder.
fn soak(folder: &Path, arguments: &str) -> Command {
    common::small_files(folder);
    effigy(
        folder,
        &format!("soak small.avatar --motion small.motion {arguments}"),
    )
}

fn effigy(folder: &Path, arguments: &str) -> Command {
    let mut command = Command::new(common::program());
    command
        .args(arguments.split_whitespace())
        .current_dir(folder);
    command
}

fn text(output: &Output) -> String {
    format!(
        "{}{}",
        String::from_utf8_lossy(&output.stdout),
        String::from_utf8_lossy(&output.stderr)
    )
}

fn report(folder: &Path, name: &str) -> SoakReport {
    SoakReport::read(&fs::read_to_string(folder.join(name)).unwrap()).unwrap()
}

fn a_short_soak_writes_all_its_files_and_they_compare() {
    gpu::drawing();
    let folder = tempfile::tempdir().unwrap();
    // A governor that a busy machine brings to another step would change what is compared.
    let ended = soak(
        folder.path(),
        &format!("--minutes 0.1 --fps 5 --governor off {SMALL} --out a"),
    )
    .output()
    .unwrap();
    let said = text(&ended);
    assert!(
        ended.status.success() && !said.contains("validation:"),
        "{said}"
    );
    let report = report(folder.path(), "a.json");
    assert!(
        !report.each.is_empty() && report.frames > 4 && report.faults.is_empty(),
        "{said}"
    );
    assert!(
        report.lasted_seconds >= 5.9
            && report.images > 0
            && report.broken_pixels == 0
            && report.empty_images == 0,
        "{said}"
    );
    assert_eq!(report.broken_gaussians, Some(0));
    assert!(
        report
            .each
            .iter()
            .all(|second| second.device_bytes == report.each[0].device_bytes && second.frames > 0),
        "{:?}",
        report.each
    );
    let drift = report.drift.expect("the run was not interrupted");
    assert!(
        drift.same && drift.before == drift.after && drift.after.psnr_db.is_none_or(|db| db > 40.0),
        "{drift:?}"
    );
    let csv = fs::read_to_string(folder.path().join("a.csv")).unwrap();
    assert_eq!(csv.lines().count(), 1 + report.each.len());
    assert!(
        fs::read_to_string(folder.path().join("a.svg"))
            .unwrap()
            .contains("frames a second")
    );
    assert!(image::open(folder.path().join("a.png")).is_ok());
    let compared = effigy(folder.path(), "soak --compare a.json a.json")
        .output()
        .unwrap();
    assert!(
        compared.status.success() && text(&compared).contains("dropped_share"),
        "{}",
        text(&compared)
    );
    // What it recorded can be played back to the governor; this machine may have recorded nothing.
    let replayed = soak(
        folder.path(),
        &format!("--minutes 0.02 --fps 5 --no-check {SMALL} --replay-heat a.csv --out b"),
    )
    .output()
    .unwrap();
    let hot = report.each.iter().any(|second| second.headroom.is_some());
    assert_eq!(replayed.status.success(), hot, "{}", text(&replayed));
    assert!(
        hot || text(&replayed).contains("a.csv can't be replayed: it has no reading of headroom"),
        "{}",
        text(&replayed)
    );
}

/// Runs a soak until it says something on a line, and ends it by Ctrl-C: how it ended and all that
/// it said. However busy a machine is, it gets there.
#[cfg(unix)]
fn soak_until(folder: &Path, arguments: &str, word: &str) -> (bool, String) {
    let mut child = soak(folder, &format!("--minutes 100 {arguments}"))
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut lines = BufReader::new(child.stdout.take().unwrap())
        .lines()
        .map_while(Result::ok);
    let mut said: Vec<String> = Vec::new();
    while !said.last().is_some_and(|line| line.contains(word)) {
        said.push(
            lines
                .next()
                .unwrap_or_else(|| panic!("it ended without `{word}`: {said:?}")),
        );
    }
    assert!(
        Command::new("kill")
            .args(["-INT", &child.id().to_string()])
            .status()
            .unwrap()
            .success()
    );
    said.extend(lines);
    let output = child.wait_with_output().unwrap();
    (
        output.status.success(),
        format!("{}\n{}", said.join("\n"), text(&output)),
    )
}

/// A rate that no one can hold: the governor goes to its last step, and the program says so and
/// fails.
#[cfg(unix)]
fn a_rate_out_of_reach_is_reported() {
    gpu::drawing();
    let folder = tempfile::tempdir().unwrap();
    let cases = [
        ("on", "display 500 Hz", "the governor is at its last step"),
        ("off", " fps, ", "the governor is off"),
    ];
    for (switch, until, expected) in cases {
        let arguments = format!(
            "--fps 1000 --size 256x320 --growth 1000 --no-check --governor {switch} --out {switch}"
        );
        let (success, said) = soak_until(folder.path(), &arguments, until);
        assert!(!success && said.contains(expected), "{said}");
        let report = report(folder.path(), &format!("{switch}.json"));
        assert_eq!(
            (
                report.lowest_rung == report.ladder.len() - 1,
                report.faults.len()
            ),
            (switch == "on", 1),
            "{:?}",
            report.faults
        );
    }
}

/// Simulated heat throttles this device as it would a phone, and the governor answers: 20 minutes
/// of the phone's in 15 seconds. How much of that is heat and how much other work of this machine
/// is not told apart here: `tests/host/governor.rs` has the same without a device.
fn simulated_heat_slows_frames_and_the_governor_gives_way() {
    gpu::drawing();
    let folder = tempfile::tempdir().unwrap();
    let arguments = format!("--minutes 0.25 --fps 10 {SMALL} --no-check --simulate-heat --out hot");
    // The phone learns from the first frames what this device takes: where it was far busier then
    // than later, the phone has little to do.
    let mut seen = Vec::new();
    for _ in 0..3 {
        let ended = soak(folder.path(), &arguments).output().unwrap();
        assert!(ended.status.success(), "{}", text(&ended));
        let report = report(folder.path(), "hot.json");
        let of = |read: fn(&Second) -> Option<f64>| {
            report
                .each
                .iter()
                .map(|second| read(second).unwrap())
                .collect::<Vec<f64>>()
        };
        let (headroom, clocks) = (of(|second| second.headroom), of(|second| second.clock));
        assert!(
            report.simulated_heat && clocks.iter().all(|clock| (0.3..=1.0).contains(clock)),
            "{clocks:?}"
        );
        assert!(
            headroom
                .iter()
                .all(|headroom| (-0.5..2.0).contains(headroom)),
            "{headroom:?}"
        );
        if clocks.iter().any(|&clock| clock < 1.0)
            && headroom.last() > headroom.first()
            && report.changes > 0
            && report.lowest_rung > 0
        {
            return;
        }
        seen.push((report.changes, clocks, headroom));
    }
    panic!(
        "three times it was not throttled, or the governor did nothing; its steps, clocks and headroom used: {seen:?}"
    );
}

/// Ctrl-C ends a soak, which still writes what it has.
#[cfg(unix)]
fn an_interrupted_soak_keeps_its_results() {
    gpu::drawing();
    let folder = tempfile::tempdir().unwrap();
    let (success, said) = soak_until(
        folder.path(),
        &format!("--fps 5 --governor off {SMALL}"),
        " fps, ",
    );
    assert!(
        success && said.starts_with("soaking ") && said.contains("interrupted after"),
        "{said}"
    );
    let report = report(folder.path(), "effigy-soak.json");
    assert!(report.frames > 0 && report.drift.is_none() && report.lasted_seconds < 6000.0);
}

tests! {
    a_short_soak_writes_all_its_files_and_they_compare,
    #[cfg(unix)]
    a_rate_out_of_reach_is_reported,
    simulated_heat_slows_frames_and_the_governor_gives_way,
    #[cfg(unix)]
    an_interrupted_soak_keeps_its_results,
}
