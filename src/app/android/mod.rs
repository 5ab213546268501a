//! The app on a phone: the system's activity comes in, the same viewer as on the desktop goes into its window.
//!
//! The system calls `android_main` on a thread of ours for every activity that it creates in the process.

pub(super) mod beat;
mod files;
mod java;
mod log;
mod notice;
mod panics;
mod rate;

use super::{
    Display, Options,
    scene::BACKGROUND,
    steady::{Soak, Steady},
};
use crate::{
    measure::soak::verdict::Bounds,
    vulkan::{GpuOptions, RendererOptions, cache},
};
pub(super) use java::{back, is_destroyed, rate, share};
pub(super) use rate::ask as ask_rate;
use std::{
    path::PathBuf,
    sync::atomic::{AtomicBool, Ordering},
};
use winit::platform::android::activity::{AndroidApp, WindowManagerFlags};

/// An event loop can be made once in a process, so the process ends with its activity.
static STARTED: AtomicBool = AtomicBool::new(false);

#[unsafe(no_mangle)]
fn android_main(app: AndroidApp) {
    if STARTED.swap(true, Ordering::AcqRel) {
        log::write(tracing::Level::INFO, "an earlier activity used this process: it ends, and the system starts another");
        end();
    }
    log::start();
    let folders: Vec<PathBuf> = app.external_data_path().into_iter().chain(app.internal_data_path()).collect();
    let last = panics::watch(&folders);
    if let Some(folder) = app.internal_data_path() {
        cache::set_folder(folder);
    }
    match show(&app, folders, last) {
        Err(error) => notice::show(&app, &notice::words(&error)),
        Ok(()) if java::is_destroyed(&app) => {}
        Ok(()) => notice::show(
            &app,
            "The soak is over, and nothing was wrong. Its results are in the app's folder: the README says how to get them.",
        ),
    }
    // What is left is the end of the activity: its destruction waits for this thread, and returns to a system that no longer needs us.
    end();
}

/// Shows what the phone has until the activity is destroyed.
fn show(app: &AndroidApp, folders: Vec<PathBuf>, last: Option<panics::Report>) -> anyhow::Result<()> {
    java::hide_bars(app);
    let files = files::Files::new(app, folders.first().cloned());
    let (avatar, clips) = files.first()?;
    let display = Display::of(app)?;
    let (shelf, first) = files.shelf();
    let said = last.as_ref().map(panics::Report::summary);
    let minutes = java::soak_minutes(app);
    let out = folders.first().map_or_else(|| "soak".into(), |folder| folder.join("soak"));
    let soak = minutes.map(|minutes| Soak { seconds: 60.0 * minutes, out, bounds: Bounds::default() });
    if soak.is_some() {
        // Nobody touches the screen for as long as that takes.
        app.set_window_flags(WindowManagerFlags::KEEP_SCREEN_ON, WindowManagerFlags::empty());
    }
    let options = Options {
        gpu: GpuOptions::headless(None),
        drawing: RendererOptions { count: soak.is_some(), ..RendererOptions::new([1; 2]) },
        full_screen: false,
        background: BACKGROUND,
        frames: None,
        rehearse: Vec::new(),
        shelf,
        first,
        folders,
        said,
        report: last.map(|report| report.text),
        steady: Some(Steady { rate: None, governed: true, soak }),
        trace: None,
    };
    let shown = display.show(avatar, clips, options);
    if !java::is_destroyed(app) {
        app.set_window_flags(WindowManagerFlags::empty(), WindowManagerFlags::KEEP_SCREEN_ON);
    }
    shown
}

/// Ends the process at once: the graphics driver's threads and the system's own may be running, so nothing is torn down under them.
fn end() -> ! {
    log::write(tracing::Level::INFO, "the activity is over, and so is the process");
    // SAFETY: it takes no pointers and does not return.
    unsafe { libc::_exit(0) }
}
