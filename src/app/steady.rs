//! Holds a frame rate in a window, and keeps the books of a soak where one was asked for: frames go in, the quality to draw at comes out.

use super::{painter::Painter, scene::Scene, still::Still};
use crate::{
    measure::{
        android::Hints,
        bench::{self, Setting, report::Device},
        governor::Quality,
        soak::{
            Report, Session, Settings, Task, files,
            memory::resident,
            report, run,
            verdict::{self, Bounds},
        },
        thermals::Thermals,
    },
    vulkan::{RendererOptions, Result, watch::Seen},
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
    /// The promised rate, frames a second. None: the display's, whatever that is at the time.
    pub rate: Option<f64>,
    /// Whether the governor may give up quality for it.
    pub governed: bool,
    pub soak: Option<Soak>,
}

/// A soak in the window: when it is over, its results are written and the viewer ends. Where the viewer ends before, what there is is written.
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
    /// The promised rate is the display's.
    follows: bool,
    /// What it was drawn with last: the device is lost where a soak may end by that.
    drawn: Option<(Device, RendererOptions, [u32; 2])>,
    /// To compare with at the end: None where that makes no sense any more, outside None before the first frame.
    still: Option<Option<Still>>,
    /// Frames of which all is in the files.
    written: u64,
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
            follows: options.rate.is_none(),
            drawn: None,
            still: None,
            written: 0,
        }
    }

    /// How often the display shows something new, a second, has been asked again.
    pub fn display(&mut self, rate: f64) {
        if self.follows && self.session.set_rate(rate) {
            tracing::info!("the display shows {rate:.0} frames a second: that is promised from now on");
            self.hint();
        }
    }

    /// Tells the system how long a frame may take.
    fn hint(&self) {
        if let Some(hints) = &self.hints {
            hints.set_frame(Duration::from_secs_f64(f64::from(self.quality().refreshes) / self.session.settings().rate));
        }
    }

    /// A frame is about to be drawn. Before a soak's first one, draws what will be compared at its end.
    pub fn prepare(&mut self, painter: &mut Painter, scene: &Scene) -> Result<()> {
        if self.soaks() && self.still.is_none() {
            self.still = Some(Still::take(painter, scene)?);
        }
        painter.set_quality(&self.quality())
    }

    /// Another avatar is shown from now on.
    pub fn forget_still(&mut self) {
        self.still = self.still.as_ref().map(|_| None);
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
            self.hint();
        }
        if event.full {
            self.drawn = Some((bench::backend::device(painter.gpu()), *painter.options(), painter.size()));
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

    /// Ends a soak: writes what it has found, and says what is wrong with it. `painter`: where the still frame can be drawn again.
    ///
    /// # Errors
    /// When a file can't be written, or the promise was not held.
    pub fn conclude(&mut self, scene: &Scene, painter: Option<&mut Painter>) -> anyhow::Result<()> {
        let again = |still: &Still| painter.map(|painter| still.again(painter));
        let compared = self.still.as_ref().and_then(|still| again(still.as_ref()?)).transpose().unwrap_or_else(|error| {
            tracing::warn!("the frame of the start can't be drawn again: {error}");
            None
        });
        let Some(report) = self.write(scene, compared.flatten())? else { return Ok(()) };
        anyhow::ensure!(report.faults.is_empty(), "{}", report.faults.join("; "));
        tracing::info!("soak: {:.1} frames a second of {} promised, nothing wrong", report.fps, report.rate);
        Ok(())
    }

    /// Writes what a soak has found so far, where that is more than what was written before: nothing says whether the system lets us go on.
    pub fn keep(&mut self, scene: &Scene) {
        if let Err(error) = self.write(scene, None) {
            tracing::error!("the soak's results are lost: {error:#}");
        }
    }

    /// None where there is nothing to write.
    fn write(&mut self, scene: &Scene, still: Option<report::Still>) -> anyhow::Result<Option<Report>> {
        let frames = self.session.totals().frames;
        let (Some(soak), Some(player), Some((device, options, size))) = (&self.soak, scene.player(), &self.drawn) else { return Ok(None) };
        if std::mem::replace(&mut self.written, frames) == frames {
            return Ok(None);
        }
        let task = Task {
            avatar: scene.avatar(),
            player,
            setting: Setting { options: *options, packed_words: false, rows: 1.0, hold: 1 },
            settings: *self.session.settings(),
            bounds: soak.bounds,
            check: false,
            command: std::env::args().collect(),
        };
        let mut report = run::report(device.clone(), &task, &self.session, false);
        (report.size, report.still) = (*size, still);
        report.faults = verdict::faults(&report, &soak.bounds);
        if !self.session.is_over() {
            tracing::info!("soak: interrupted after {:.0} s of {:.0} s", report.lasted_seconds, report.planned_seconds);
        }
        for path in files::write(&report, &soak.out)? {
            tracing::info!("soak: wrote {}", path.display());
            println!("wrote {}", path.display());
        }
        Ok(Some(report))
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
        for (rate, followed) in [(None, 60.0), (Some(30.0), 30.0)] {
            let mut pace = Pace::new(&Steady { rate, governed: true, soak: None }, Some(120.0));
            pace.display(60.0);
            assert_eq!(pace.session.settings().rate, followed, "what the user asks for stays");
        }
    }
}
