//! A survey of the device that the window is drawn with: measured on a thread and a device of its
//! own while the window rests, then soaked in the window. What is found is kept in a file as it
//! comes, so that a program that ends without notice leaves it.

use crate::{
    message::Message,
    painter::WindowPainter,
    question::{BackgroundTrials, SharedProgress},
    scene::ViewerScene,
};
use effigy_core::io::file::write_whole;
use effigy_measure::{
    report::DeviceReport,
    soak::SoakReport,
    survey::{MINUTES, SurveyReport, SurveyTask, measure, soak_seconds},
};
use effigy_render::vulkan::{GpuOptions, question::Aside};
use std::{
    path::PathBuf,
    sync::mpsc::{self, Receiver, TryRecvError},
    thread::{self, JoinHandle},
    time::Duration,
};
use winit::event_loop::EventLoopProxy;

/// Name of the file.
const FILE: &str = "effigy-survey.json";
/// How often to look whether trials behind the window are over.
const TRIALS_CHECK: Duration = Duration::from_millis(50);

/// A survey.
pub struct Survey {
    report: SurveyReport,
    progress: SurveyProgress,
    /// How long it is to take.
    minutes: f64,
    /// The clip played when it began.
    pub was_playing: bool,
    /// Folders for its file, in order of preference.
    folders: Vec<PathBuf>,
    /// The words for the panel.
    words: Vec<String>,
    thread: Option<JoinHandle<()>>,
}

/// What a survey does now.
enum SurveyProgress {
    /// A thread measures. It ends when the receiver is dropped.
    Measuring(Receiver<Told>),
    /// The window soaks.
    Soaking,
    Over,
}

/// What the thread tells.
struct Told {
    report: SurveyReport,
    /// What it does now.
    what: String,
}

/// What a survey begins with.
pub struct SurveyStart<'a> {
    /// How the window's device was opened.
    pub options: &'a GpuOptions,
    /// The window.
    pub painter: &'a WindowPainter,
    /// What it shows.
    pub scene: &'a ViewerScene,
    /// Trials behind the window, which it waits for.
    pub trials: Option<&'a BackgroundTrials>,
    /// The survey before, whose thread it waits for.
    pub last: Option<Survey>,
    /// How long all is to take: [`MINUTES`] but in tests.
    pub minutes: f64,
    /// Folders for the file, in order of preference.
    pub folders: Vec<PathBuf>,
    /// Takes the thread's messages.
    pub proxy: EventLoopProxy<Message>,
}

impl Survey {
    /// Starts the thread. None without a clip.
    pub fn start(start: SurveyStart) -> Option<Self> {
        let SurveyStart {
            painter,
            scene,
            minutes,
            proxy,
            ..
        } = start;
        let player = scene.player()?.clone();
        let avatar = scene.avatar().clone();
        let device = DeviceReport::from_vulkan(painter.gpu());
        let report = SurveyReport::new(system(), device);
        let aside = Aside::of(painter.gpu(), start.options);
        let size = painter.size();
        let trials = start.trials.map(BackgroundTrials::watch);
        let last = start.last.and_then(|last| last.thread);
        let (sender, receiver) = mpsc::channel();
        let mut measured = report.clone();
        let work = move || {
            let mut tell = |report: &SurveyReport, what: &str| {
                let told = Told {
                    report: report.clone(),
                    what: what.to_owned(),
                };
                // If nobody is left to receive it, the thread ends.
                sender.send(told).is_ok() && proxy.send_event(Message::Survey).is_ok()
            };
            // A panic has been reported by then.
            let _ = last.map(JoinHandle::join);
            while trials.as_ref().is_some_and(SharedProgress::is_running) {
                thread::sleep(TRIALS_CHECK);
            }
            match aside.open() {
                Ok(gpu) => {
                    let task = SurveyTask {
                        avatar: &avatar,
                        player: &player,
                        size,
                        share: (minutes / MINUTES).min(1.0),
                    };
                    measure(&gpu, &task, &mut measured, &mut tell);
                }
                Err(error) => {
                    measured.explain(&error.to_string());
                    tell(&measured, "the device can't be opened again");
                }
            }
            drop(sender);
            // The end of the thread is to be seen too.
            let _ = proxy.send_event(Message::Survey);
        };
        let started = thread::Builder::new().name("survey".into()).spawn(work);
        let mut survey = Self {
            report,
            progress: SurveyProgress::Measuring(receiver),
            minutes,
            was_playing: scene.playback().is_playing(),
            folders: start.folders,
            words: Vec::new(),
            thread: None,
        };
        match started {
            Ok(thread) => {
                survey.thread = Some(thread);
                survey.say("opening the device again");
            }
            Err(error) => {
                survey.end(None, &format!("the system starts no thread: {error}"));
            }
        }
        Some(survey)
    }

    /// Whether it is measuring or soaking.
    pub fn is_running(&self) -> bool {
        !matches!(self.progress, SurveyProgress::Over)
    }

    /// Whether a thread draws on the device beside the window.
    pub fn is_measuring(&self) -> bool {
        matches!(self.progress, SurveyProgress::Measuring(_))
    }

    /// Whether the window soaks for it.
    pub fn is_soaking(&self) -> bool {
        matches!(self.progress, SurveyProgress::Soaking)
    }

    /// What is done now, or what was found.
    pub fn words(&self) -> &[String] {
        &self.words
    }

    /// The whole report as JSON, to share.
    #[cfg(target_os = "android")]
    pub fn json(&self) -> String {
        self.report.json()
    }

    /// Takes what the thread has told. When it has ended, returns how long the window is to soak,
    /// seconds; the result goes to [`Self::end`].
    pub fn receive(&mut self) -> Option<f64> {
        let SurveyProgress::Measuring(receiver) = &self.progress else {
            return None;
        };
        let mut latest = None;
        let ended = loop {
            match receiver.try_recv() {
                Ok(told) => latest = Some(told),
                Err(error) => break error == TryRecvError::Disconnected,
            }
        };
        if let Some(Told { report, what }) = latest {
            self.report = report;
            self.say(&what);
            self.save();
        }
        if !ended {
            return None;
        }
        self.progress = SurveyProgress::Soaking;
        let seconds = soak_seconds(self.minutes);
        self.say(&format!("soak: {seconds:.0} s in motion"));
        Some(seconds)
    }

    /// Ends it, with the soak as long as it lasted. `why`: it ends before its time. Returns where
    /// the file is, or why there is none.
    pub fn end(&mut self, soak: Option<SoakReport>, why: &str) -> String {
        self.progress = SurveyProgress::Over;
        if let Some(soak) = soak {
            self.report.add_soak(soak);
        }
        self.report.explain(why);
        self.report.over = true;
        self.words = self.report.words();
        let ended = if self.report.is_complete() {
            "complete"
        } else {
            "incomplete"
        };
        let saved = self.save();
        tracing::info!("survey: {ended}; {saved}");
        saved
    }

    /// Waits for the thread of a survey that has ended. The process may not end before it, but where
    /// it ends at once, as on Android.
    pub fn wait(self) {
        if !cfg!(target_os = "android")
            && let Some(thread) = self.thread
        {
            let _ = thread.join();
        }
    }

    fn say(&mut self, what: &str) {
        tracing::info!("survey: {what}");
        self.words = vec![what.to_owned()];
    }

    /// Writes the file as it is by now. Returns where, or why it can't be written.
    fn save(&self) -> String {
        let mut refused = "there is no folder for the survey's file".to_owned();
        for folder in &self.folders {
            let path = folder.join(FILE);
            match write_whole(&path, self.report.json().as_bytes()) {
                Ok(()) => return format!("wrote {}", path.display()),
                Err(error) => refused = format!("{}: {error}", path.display()),
            }
        }
        refused
    }
}

/// The machine and its system in words.
fn system() -> String {
    #[cfg(target_os = "android")]
    return crate::android::system();
    #[cfg(not(target_os = "android"))]
    format!("{} on {}", std::env::consts::OS, std::env::consts::ARCH)
}
