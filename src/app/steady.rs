//! Holds a frame rate in a window, and keeps the books of a soak where one was asked for: frames go in, the quality to draw at comes out.

use super::{painter::Painter, scene::Scene};
use crate::{
    measure::{
        android::Hints,
        bench::Setting,
        governor::Quality,
        soak::{
            Session, Settings, Task, files,
            memory::resident,
            run,
            verdict::{self, Bounds},
        },
        thermals::Thermals,
    },
    vulkan::watch::Seen,
};
use std::{
    path::{Path, PathBuf},
    time::Duration,
};

/// Where a display does not say how often it shows something new, frames a second.
const USUAL: f64 = 60.0;

/// How to hold a frame rate.
#[derive(Clone, Debug, PartialEq)]
pub struct Steady {
    /// The promised rate, frames a second. None: the display's.
    pub rate: Option<f64>,
    /// Whether the governor may give up quality for it.
    pub governed: bool,
    pub soak: Option<Soak>,
}

/// A soak in the window: when it is over, its results are written and the viewer ends.
#[derive(Clone, Debug, PartialEq)]
pub struct Soak {
    pub seconds: f64,
    /// Name of the files to write, without their endings.
    pub out: PathBuf,
    pub bounds: Bounds,
}

/// A rate that is being held.
pub(super) struct Pace {
    session: Session,
    thermals: Thermals,
    hints: Option<Hints>,
    soak: Option<Soak>,
    /// Frames that the pose was shown for.
    held: u32,
    /// When the last frame was handed over, seconds.
    last: f64,
}

impl Pace {
    /// `display`: how often it shows something new, a second, where it says so.
    pub fn new(options: &Steady, display: Option<f64>) -> Self {
        let rate = options.rate.or(display).unwrap_or(USUAL);
        let seconds = options.soak.as_ref().map_or(f64::INFINITY, |soak| soak.seconds);
        Self {
            session: Session::new(Settings { rate, governed: options.governed, seconds }),
            thermals: Thermals::System(Box::default()),
            hints: thread().and_then(|thread| Hints::open(&[thread], Duration::from_secs_f64(1.0 / rate))),
            soak: options.soak.clone(),
            held: 0,
            last: f64::NEG_INFINITY,
        }
    }

    pub fn quality(&self) -> Quality {
        self.session.quality()
    }

    /// A soak draws without a rest.
    pub fn soaks(&self) -> bool {
        self.soak.is_some()
    }

    /// When the next frame may be drawn, seconds: where the governor shows one for several refreshes, not at the very next.
    pub fn next(&self) -> Option<f64> {
        let refreshes = self.quality().refreshes;
        // Half a refresh early, so that the one that is meant is not missed.
        (refreshes > 1).then(|| self.last + (f64::from(refreshes) - 0.5) / self.session.settings().rate)
    }

    /// Whether the frame that is about to be drawn shows the pose of the one before.
    pub fn holds(&mut self) -> bool {
        let hold = self.quality().hold;
        self.held = (self.held + 1) % hold;
        hold > 1 && self.held != 0
    }

    /// Time in which nothing had to be drawn, until now, counts for nothing.
    pub fn rest(&mut self, clock: f64) {
        self.session.rest(clock);
    }

    /// A frame was handed over; `seen` is what was seen in a picture that was looked at. True where one may be looked at again.
    pub fn frame(&mut self, clock: f64, painter: &Painter, seen: Option<Seen>) -> bool {
        let report = painter.report();
        let busy_ms = (!report.stages.is_empty()).then(|| report.gpu_ms());
        if let (Some(hints), Some(host)) = (&self.hints, report.host) {
            let host = host.submitted.duration_since(host.waited);
            hints.took(busy_ms.map_or(host, |ms| host.max(Duration::from_secs_f64(ms / 1e3))));
        }
        self.last = clock;
        let event = self.session.frame(clock, busy_ms);
        seen.into_iter().for_each(|seen| self.session.seen(seen));
        self.session.counted(&report.counters);
        if event.changed {
            let (ladder, rung) = self.session.ladder();
            tracing::info!("the governor goes to step {rung}: {}", ladder[rung].name);
            if let Some(hints) = &self.hints {
                hints.set_frame(Duration::from_secs_f64(f64::from(self.quality().refreshes) / self.session.settings().rate));
            }
        }
        if event.full {
            let second = *self.session.close(&self.thermals.read(clock), (painter.gpu().memory().0, resident()));
            match self.soak {
                Some(_) => {
                    tracing::info!("soak: {:.0} s, {:.1} fps, {} dropped, step {}", second.seconds, second.fps, second.dropped, second.rung)
                }
                None => self.session.forget(),
            }
        }
        event.full && self.soaks()
    }

    /// The soak is over.
    pub fn is_over(&self) -> bool {
        self.soaks() && self.session.is_over()
    }

    /// Writes what the soak has found, and says what is wrong with it.
    ///
    /// # Errors
    /// When a file can't be written, or the promise was not held.
    pub fn conclude(&self, scene: &Scene, painter: &Painter) -> anyhow::Result<()> {
        let (Some(soak), Some(player)) = (&self.soak, scene.player()) else { return Ok(()) };
        let setting = Setting { options: *painter.options(), packed_words: false, rows: 1.0, hold: 1 };
        let task = Task {
            avatar: scene.avatar(),
            player,
            setting,
            settings: *self.session.settings(),
            bounds: soak.bounds,
            check: false,
            command: std::env::args().collect(),
        };
        let mut report = run::report(painter.gpu(), &task, &self.session, false);
        report.size = painter.size();
        report.faults = verdict::faults(&report, &soak.bounds);
        for path in files::write(&report, &soak.out)? {
            tracing::info!("soak: wrote {}", path.display());
            println!("wrote {}", path.display());
        }
        anyhow::ensure!(report.faults.is_empty(), "{}", report.faults.join("; "));
        tracing::info!("soak: {:.1} frames a second of {} promised, nothing wrong", report.fps, report.rate);
        Ok(())
    }
}

/// This thread's number, where the system tells.
fn thread() -> Option<i32> {
    Path::new("/proc/thread-self").read_link().ok()?.file_name()?.to_str()?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    #[cfg(target_os = "linux")]
    fn a_thread_knows_its_number() {
        assert!(thread().is_some_and(|thread| thread > 0));
    }

    #[test]
    fn the_displays_rate_is_held_unless_another_is_asked_for() {
        let of = |rate, display| {
            let pace = Pace::new(&Steady { rate, governed: true, soak: None }, display);
            (pace.session.settings().rate, pace.next(), pace.soaks())
        };
        assert_eq!(of(None, Some(144.0)), (144.0, None, false));
        assert_eq!(of(Some(30.0), Some(144.0)).0, 30.0);
        assert_eq!(of(None, None).0, USUAL);
    }
}
