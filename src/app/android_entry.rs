//! Runs the viewer in an activity. For every activity that the system creates in the process,
//! `android_main` is called on a thread of its own.

use crate::{
    android::{
        ScreenOn,
        crash_report::{self, CrashReport},
        files, java, log, notice,
    },
    file_list::LoadedAvatar,
    options::ViewerOptions,
    quality_control::{QualityControl, SoakOptions},
    scene::BACKGROUND,
    window::Display,
};
use effigy_measure::{soak::faults::SoakLimits, survey};
use effigy_render::vulkan::RendererOptions;
use std::{
    path::PathBuf,
    sync::atomic::{AtomicBool, Ordering},
};
use winit::platform::android::activity::AndroidApp;

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
    if let Some(commit) = option_env!("EFFIGY_COMMIT") {
        effigy_measure::set_commit(commit);
    }
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
    let minutes = java::minutes(app, "soak", 20.0);
    let survey = java::minutes(app, "survey", survey::MINUTES as f32).filter(|_| minutes.is_none());
    let out = folders
        .first()
        .map_or_else(|| "soak".into(), |folder| folder.join("soak"));
    let measures = survey.map(|_| "measuring this phone: leave it alone until it is over".into());
    let message = last_crash.as_ref().map(CrashReport::summary).or(measures);
    let soak = minutes.map(|minutes| SoakOptions {
        seconds: 60.0 * minutes,
        out: Some(out),
        bounds: SoakLimits::default(),
    });
    let _screen_on = soak.is_some().then(|| ScreenOn::new(app));
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
        survey,
        crash_report: last_crash.map(|report| report.text),
        quality_control: Some(QualityControl {
            rate: None,
            governed: true,
            soak,
        }),
        trace: None,
    };
    display.show(avatar, clips, options)
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
