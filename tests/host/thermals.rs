//! What is asked of Android's native library, played by a library that this test makes: it counts
//! what the program sends it.

use effigy_render::ndk::Sections;
use effigy_runtime::{
    ndk::{Hints, Thermal},
    thermals::System,
};
use std::{env, fs, path::PathBuf, process::Command, time::Duration};

/// Stands for libandroid.so. `HINTS`: as on a system that has hint sessions.
const LIBRARY: &str = r#"
use std::sync::atomic::{AtomicI64, Ordering::Relaxed};
static OPEN: AtomicI64 = AtomicI64::new(0);
static RECEIVED: AtomicI64 = AtomicI64::new(0);
static DEPTH: AtomicI64 = AtomicI64::new(0);
#[unsafe(no_mangle)] extern "C" fn AThermal_acquireManager() -> i64 { OPEN.fetch_add(1, Relaxed); 16 }
#[unsafe(no_mangle)] extern "C" fn AThermal_releaseManager(manager: i64) { assert_eq!(manager, 16); OPEN.fetch_sub(1, Relaxed); }
#[unsafe(no_mangle)] extern "C" fn AThermal_getThermalHeadroom(manager: i64, ahead: i32) -> f32 {
    assert_eq!(manager, 16);
    if ahead > 60 { f32::NAN } else { ahead as f32 / 20.0 }
}
#[cfg(hints)] mod hints {
    use super::*;
    #[unsafe(no_mangle)] extern "C" fn APerformanceHint_getManager() -> i64 { 32 }
    #[unsafe(no_mangle)] unsafe extern "C" fn APerformanceHint_createSession(manager: i64, threads: *const i32, count: usize, target: i64) -> i64 {
        assert_eq!((manager, count), (32, 2));
        assert_eq!(unsafe { (*threads, *threads.add(1)) }, (7, 8));
        RECEIVED.store(target, Relaxed);
        OPEN.fetch_add(1, Relaxed);
        64
    }
    #[unsafe(no_mangle)] extern "C" fn APerformanceHint_updateTargetWorkDuration(session: i64, target: i64) -> i32 { assert_eq!(session, 64); RECEIVED.store(target, Relaxed); 0 }
    #[unsafe(no_mangle)] extern "C" fn APerformanceHint_reportActualWorkDuration(session: i64, actual: i64) -> i32 { assert_eq!(session, 64); RECEIVED.store(-actual, Relaxed); 0 }
    #[unsafe(no_mangle)] extern "C" fn APerformanceHint_closeSession(_: i64) { OPEN.fetch_sub(1, Relaxed); }
}
#[unsafe(no_mangle)] extern "C" fn ATrace_isEnabled() -> bool { RECEIVED.load(Relaxed) != 99 }
#[unsafe(no_mangle)] extern "C" fn ATrace_beginSection(_: *const i8) { DEPTH.fetch_add(1, Relaxed); }
#[unsafe(no_mangle)] extern "C" fn ATrace_endSection() { DEPTH.fetch_sub(1, Relaxed); }
#[unsafe(no_mangle)] extern "C" fn open() -> i64 { OPEN.load(Relaxed) }
#[unsafe(no_mangle)] extern "C" fn received() -> i64 { RECEIVED.load(Relaxed) }
#[unsafe(no_mangle)] extern "C" fn depth() -> i64 { DEPTH.load(Relaxed) }
"#;

/// Makes the library, and gives its name.
fn library(folder: &std::path::Path, hints: bool) -> PathBuf {
    let (source, made) = (
        folder.join("android.rs"),
        folder.join(if hints { "libnew.so" } else { "libold.so" }),
    );
    fs::write(&source, LIBRARY).unwrap();
    let mut compiler = Command::new(env::var("RUSTC").unwrap_or("rustc".into()));
    compiler
        .args([
            "--edition",
            "2024",
            "--crate-type",
            "cdylib",
            "-A",
            "warnings",
            "-o",
        ])
        .arg(&made)
        .arg(&source);
    if hints {
        compiler.args(["--cfg", "hints"]);
    }
    let output = compiler.output().unwrap();
    assert!(
        output.status.success(),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
    made
}

fn headroom_hints_and_sections_reach_the_system() {
    let folder = tempfile::tempdir().unwrap();
    let path = library(folder.path(), true);
    let name = path.to_str().unwrap();
    // SAFETY: the library was made above of functions of this type.
    let played = unsafe { libloading::Library::new(&path) }.unwrap();
    let ask = |what: &str| {
        // SAFETY: as above.
        unsafe {
            (*played
                .get::<unsafe extern "C" fn() -> i64>(what.as_bytes())
                .unwrap())()
        }
    };
    let thermal = Thermal::of(name).expect("the library has it");
    assert_eq!(
        (thermal.headroom(10), thermal.headroom(100), ask("open")),
        (Some(0.5), None, 1)
    );
    let root = tempfile::tempdir().unwrap();
    let mut system = System::at(root.path(), Some(thermal));
    assert_eq!(system.read().headroom, Some(0.5));
    drop(system);
    let hints =
        Hints::of(name, &[7, 8], Duration::from_micros(8333)).expect("the library has them");
    assert_eq!((ask("open"), ask("received")), (1, 8_333_000));
    hints.set_frame(Duration::from_millis(16));
    assert_eq!(ask("received"), 16_000_000);
    hints.took(Duration::ZERO);
    assert_eq!(ask("received"), -1, "the system refuses zero");
    drop(hints);
    assert_eq!(
        ask("open"),
        0,
        "managers and sessions that were not given back"
    );
    let sections = Sections::of(name).expect("the library has them");
    assert!(sections.begin(c"frame") && ask("depth") == 1);
    sections.end();
    assert_eq!(ask("depth"), 0);
}

/// An older system, and none at all: what is missing is absent, and nothing else is.
fn what_a_system_lacks_is_absent() {
    let folder = tempfile::tempdir().unwrap();
    let path = library(folder.path(), false);
    let name = path.to_str().unwrap();
    assert!(
        Thermal::of(name).is_some() && Hints::of(name, &[7, 8], Duration::from_millis(8)).is_none()
    );
    assert!(
        Thermal::open().is_none()
            && Hints::open(&[1], Duration::from_millis(8)).is_none()
            && Sections::open().is_none()
    );
}

tests! {
    headroom_hints_and_sections_reach_the_system,
    what_a_system_lacks_is_absent,
}
