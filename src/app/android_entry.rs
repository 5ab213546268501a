//! Runs the viewer in an activity. For every activity that the system creates in the process,
//! `android_main` is called on a thread of its own.

use crate::{
    android::{
        crash_report::{self, CrashReport},
        files, java, log, notice,
    },
    file_list::LoadedAvatar,
    options::ViewerOptions,
    quality_control::{QualityControl, SoakOptions},
    scene::BACKGROUND,
    window::Display,
};
use effigy_measure::soak::faults::SoakLimits;
use effigy_render::vulkan::RendererOptions;
use std::{
    path::PathBuf,
    sync::atomic::{AtomicBool, Ordering},
};
use winit::platform::android::activity::{AndroidApp, WindowManagerFlags};

/// A process can create only one event loop, so it ends with its first activity.
static STARTED: AtomicBool = AtomicBool::new(false);

#[unsafe(no_mangle)]
fn android_main(app: AndroidApp) {
    if STARTED.swap(true, Ordering::AcqRel) {
        log::write(
            tracing::Level::INFO,
            "an earlier activity used this process: it ends, and the system starts another",
        );
        end();
    }
    log::start();
    let folders: Vec<PathBuf> = app
        .external_data_path()
        .into_iter()
        .chain(app.internal_data_path())
        .collect();
    let last_crash = crash_report::install(&folders);
    if let Some(folder) = app.internal_data_path() {
        effigy_runtime::cache::set_folder(folder);
    }
    match show(&app, folders, last_crash) {
        Err(error) => notice::show(&app, &notice::explanation(&error)),
        Ok(()) if java::is_destroyed(&app) => {}
        Ok(()) => notice::show(
            &app,
            "The soak is over and has found no faults. Its results are in the app's folder.",
        ),
    }
    // The activity's destruction waits for this thread to end.
    end();
}

/// Shows the phone's avatars until the activity is destroyed.
fn show(
    app: &AndroidApp,
    folders: Vec<PathBuf>,
    last_crash: Option<CrashReport>,
) -> anyhow::Result<()> {
    java::hide_bars(app);
    let files = files::PhoneFiles::new(app, folders.first().cloned());
    let LoadedAvatar { avatar, clips } = files.first()?;
    let display = Display::of_activity(app)?;
    let first = files.opened_index();
    let message = last_crash.as_ref().map(CrashReport::summary);
    let minutes = java::soak_minutes(app);
    let out = folders
        .first()
        .map_or_else(|| "soak".into(), |folder| folder.join("soak"));
    let soak = minutes.map(|minutes| SoakOptions {
        seconds: 60.0 * minutes,
        out,
        bounds: SoakLimits::default(),
    });
    if soak.is_some() {
        // Without touches the screen would go dark before the soak is over.
        app.set_window_flags(
            WindowManagerFlags::KEEP_SCREEN_ON,
            WindowManagerFlags::empty(),
        );
    }
    let options = ViewerOptions {
        gpu: effigy_runtime::cache::headless(None),
        renderer: RendererOptions {
            count: soak.is_some(),
            ..RendererOptions::new([1; 2])
        },
        full_screen: false,
        background: BACKGROUND,
        picture: None,
        frames: None,
        rehearse: Vec::new(),
        live: false,
        file_list: files.into_list(),
        opener: None,
        first,
        folders,
        message,
        crash_report: last_crash.map(|report| report.text),
        quality_control: Some(QualityControl {
            rate: None,
            governed: true,
            soak,
        }),
        trace: None,
    };
    let shown = display.show(avatar, clips, options);
    if !java::is_destroyed(app) {
        app.set_window_flags(
            WindowManagerFlags::empty(),
            WindowManagerFlags::KEEP_SCREEN_ON,
        );
    }
    shown
}

/// Ends the process at once: the graphics driver's threads and the system's own may be running, so
/// nothing is torn down under them.
fn end() -> ! {
    log::write(
        tracing::Level::INFO,
        "the activity is over, and so is the process",
    );
    // SAFETY: it takes no pointers and does not return.
    unsafe { libc::_exit(0) }
}
