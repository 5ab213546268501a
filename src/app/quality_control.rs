//! Holds a frame rate in a window, and records a soak if one was asked for: frames go in, the
//! quality to draw at comes out.

use crate::{drift_check::DriftCheck, painter::WindowPainter, scene::ViewerScene};
use effigy_measure::{
    report::DeviceReport,
    setting::RenderSetting,
    soak::{
        Session, SoakReport, SoakSettings, SoakTask,
        faults::{self, SoakLimits},
        files,
        memory::resident_bytes,
        report, run,
    },
};
use effigy_render::vulkan::{PixelCounts, RendererOptions, Result};
use effigy_runtime::{governor::FrameQuality, ndk::Hints, thermals::Thermals};
use std::{
    path::{Path, PathBuf},
    time::Duration,
};

/// Frame rate to hold if the display's refresh rate is unknown, frames a second.
const DEFAULT_RATE: f64 = 60.0;

/// How to hold a frame rate.
#[derive(Clone, Debug, PartialEq)]
pub struct QualityControl {
    /// The promised rate, frames a second. None: the display's, also when it changes.
    pub rate: Option<f64>,
    /// Whether the governor may reduce the quality to hold it.
    pub governed: bool,
    /// Record a soak.
    pub soak: Option<SoakOptions>,
}

/// A soak in the window: when it is over, its results are written and the viewer ends. If the
/// viewer ends earlier, the results so far are written.
#[derive(Clone, Debug, PartialEq)]
pub struct SoakOptions {
    /// How long it lasts.
    pub seconds: f64,
    /// Path of the files to write, without their extensions. None: [`QualityController::result`] is
    /// asked for the report.
    pub out: Option<PathBuf>,
    /// Limits of a soak without faults.
    pub bounds: SoakLimits,
}

/// Holds a rate while a window is drawn.
pub struct QualityController {
    session: Session,
    thermals: Thermals,
    hints: Option<Hints>,
    soak: Option<SoakOptions>,
    /// The promised rate is the display's.
    follows_display: bool,
    /// Frames that the current pose was shown for.
    pose_frames: u32,
    /// When the last frame was submitted, seconds.
    last_frame: f64,
    /// The results need it, also after the device was lost.
    last_drawn: Option<DrawnWith>,
    drift: DriftReference,
    /// Number of frames whose results are reported.
    frames_reported: u64,
}

/// How frames were drawn.
struct DrawnWith {
    device: DeviceReport,
    options: RendererOptions,
    /// px.
    size: [u32; 2],
}

/// The frame that a soak compares with at its end.
enum DriftReference {
    /// It has not been drawn yet.
    Pending,
    /// It was drawn before the soak's first frame.
    Drawn(Box<DriftCheck>),
    /// The avatar has no clip, or another one is shown by now.
    Unavailable,
}

impl QualityController {
    /// `refresh_rate`: the display's, Hz, if known.
    pub fn new(options: &QualityControl, refresh_rate: Option<f64>) -> Self {
        let rate = options.rate.or(refresh_rate).unwrap_or(DEFAULT_RATE);
        let seconds = options
            .soak
            .as_ref()
            .map_or(f64::INFINITY, |soak| soak.seconds);
        let frame = Duration::from_secs_f64(1.0 / rate);
        Self {
            session: Session::new(SoakSettings {
                rate,
                governed: options.governed,
                seconds,
            }),
            thermals: Thermals::System(Box::default()),
            hints: current_thread().and_then(|thread| Hints::open(&[thread], frame)),
            soak: options.soak.clone(),
            follows_display: options.rate.is_none(),
            pose_frames: 0,
            last_frame: f64::NEG_INFINITY,
            last_drawn: None,
            drift: DriftReference::Pending,
            frames_reported: 0,
        }
    }

    /// The display's refresh rate was asked for again, Hz.
    pub fn set_refresh_rate(&mut self, rate: f64) {
        if self.follows_display && self.session.set_rate(rate) {
            tracing::info!("the display now refreshes {rate:.0} times a second: the rate to hold");
            self.update_hints();
        }
    }

    /// Tells the system how long a frame may take.
    fn update_hints(&self) {
        if let Some(hints) = &self.hints {
            let seconds = f64::from(self.quality().refreshes) / self.session.settings().rate;
            hints.set_frame(Duration::from_secs_f64(seconds));
        }
    }

    /// A frame is about to be drawn: sets the painter's quality. Before a soak's first frame it
    /// draws the one to compare with at the end.
    pub fn prepare(&mut self, painter: &mut WindowPainter, scene: &ViewerScene) -> Result<()> {
        if self.is_soaking() && matches!(self.drift, DriftReference::Pending) {
            self.drift = match DriftCheck::draw(painter, scene)? {
                Some(check) => DriftReference::Drawn(Box::new(check)),
                None => DriftReference::Unavailable,
            };
        }
        painter.set_quality(&self.quality())
    }

    /// Another avatar is shown from now on.
    pub fn avatar_changed(&mut self) {
        if matches!(self.drift, DriftReference::Drawn(_)) {
            self.drift = DriftReference::Unavailable;
        }
    }

    /// The quality to draw at.
    pub fn quality(&self) -> FrameQuality {
        self.session.quality()
    }

    /// Whether a soak is recorded: frames are then drawn continuously.
    pub fn is_soaking(&self) -> bool {
        self.soak.is_some()
    }

    /// When the next frame may begin, seconds. None: at once. A frame that is shown for several
    /// refreshes leaves time before the next one.
    pub fn next_frame(&self) -> Option<f64> {
        let refreshes = self.quality().refreshes;
        if refreshes <= 1 {
            return None;
        }
        // Half a refresh early, in order not to miss the right one.
        let wait = (f64::from(refreshes) - 0.5) / self.session.settings().rate;
        Some(self.last_frame + wait)
    }

    /// Counts a frame that is about to be drawn. Returns whether it repeats the last one's pose.
    pub fn holds_pose(&mut self) -> bool {
        let hold = self.quality().hold;
        self.pose_frames = (self.pose_frames + 1) % hold;
        hold > 1 && self.pose_frames != 0
    }

    /// Nothing had to be drawn until now: this time does not count.
    pub fn rest(&mut self, now: f64) {
        self.session.skip_idle(now);
    }

    /// A frame was submitted at `now`, seconds. `validation`: the result of an earlier frame's
    /// validation, if it is done. Returns whether to request another one.
    pub fn frame_submitted(
        &mut self,
        now: f64,
        painter: &WindowPainter,
        validation: Option<PixelCounts>,
    ) -> bool {
        let report = painter.report();
        let gpu_ms = (!report.stages.is_empty()).then(|| report.gpu_ms());
        if let Some(hints) = &self.hints
            && let Some(host) = report.host
        {
            let host_time = host.submitted.duration_since(host.waited);
            let gpu_time = gpu_ms.map(|ms| Duration::from_secs_f64(ms / 1e3));
            hints.took(gpu_time.map_or(host_time, |gpu_time| gpu_time.max(host_time)));
        }
        self.last_frame = now;
        let event = self.session.add_frame(now, gpu_ms);
        if let Some(validation) = validation {
            self.session.add_image_check(validation);
        }
        self.session.add_counters(&report.counters);
        if event.changed {
            let (ladder, rung) = self.session.ladder();
            tracing::info!("the governor goes to step {rung}: {}", ladder[rung].name);
            self.update_hints();
        }
        if event.full {
            self.close_second(now, painter);
        }
        event.full && self.is_soaking()
    }

    /// A second is full: reads what is read once a second.
    fn close_second(&mut self, now: f64, painter: &WindowPainter) {
        self.last_drawn = Some(DrawnWith {
            device: DeviceReport::from_vulkan(painter.gpu()),
            options: *painter.options(),
            size: painter.size(),
        });
        let second = *self.session.close_second(
            &self.thermals.read(now),
            painter.gpu().memory().0,
            resident_bytes(),
        );
        if self.is_soaking() {
            tracing::info!(
                "soak: {:.0} s, {:.1} fps, {} dropped, step {}",
                second.seconds,
                second.fps,
                second.dropped,
                second.rung
            );
        } else {
            self.session.clear_seconds();
        }
    }

    /// Whether a soak is over.
    pub fn is_over(&self) -> bool {
        self.is_soaking() && self.session.is_over()
    }

    /// Ends a soak: writes its results. `painter`: to draw the frame of the start again, if there
    /// is still a device.
    ///
    /// # Errors
    /// If a file can't be written, or the soak has found faults.
    pub fn conclude(
        &mut self,
        scene: &ViewerScene,
        painter: Option<&mut WindowPainter>,
    ) -> anyhow::Result<()> {
        let Some(report) = self.result(scene, painter) else {
            return Ok(());
        };
        self.write(&report)?;
        anyhow::ensure!(report.faults.is_empty(), "{}", report.faults.join("; "));
        tracing::info!(
            "soak: {:.1} frames a second of {} promised, no faults",
            report.fps,
            report.rate
        );
        Ok(())
    }

    /// Ends a soak, as [`Self::conclude`] does, and returns its report. None if there is no soak, or
    /// nothing new.
    pub fn result(
        &mut self,
        scene: &ViewerScene,
        painter: Option<&mut WindowPainter>,
    ) -> Option<SoakReport> {
        let drift = painter.and_then(|painter| self.compare_drift(painter));
        self.report(scene, drift)
    }

    /// Draws the frame of the start again and compares. None if that is not possible.
    fn compare_drift(&self, painter: &mut WindowPainter) -> Option<report::RedrawnFrame> {
        let DriftReference::Drawn(check) = &self.drift else {
            return None;
        };
        match check.compare(painter) {
            Ok(drift) => drift,
            Err(error) => {
                tracing::warn!("the frame of the start can't be drawn again: {error}");
                None
            }
        }
    }

    /// Writes the results of a soak so far, if there are new ones: the system may end the program
    /// without notice.
    pub fn save(&mut self, scene: &ViewerScene) {
        if let Some(report) = self.report(scene, None)
            && let Err(error) = self.write(&report)
        {
            tracing::error!("the soak's results are lost: {error:#}");
        }
    }

    /// The report of a soak so far. None if there is no soak, or nothing new.
    fn report(
        &mut self,
        scene: &ViewerScene,
        drift: Option<report::RedrawnFrame>,
    ) -> Option<SoakReport> {
        let soak = self.soak.as_ref()?;
        let player = scene.player()?;
        let drawn = self.last_drawn.as_ref()?;
        let frames = self.session.totals().frames;
        if self.frames_reported == frames {
            return None;
        }
        self.frames_reported = frames;
        let task = SoakTask {
            avatar: scene.avatar(),
            player,
            setting: RenderSetting::new(drawn.options),
            settings: *self.session.settings(),
            bounds: soak.bounds,
            check: false,
            command: std::env::args().collect(),
        };
        let mut report = run::report(drawn.device.clone(), &task, &self.session, false);
        report.size = drawn.size;
        report.redrawn = drift;
        report.faults = faults::find_faults(&report, &soak.bounds);
        if !self.session.is_over() {
            tracing::info!(
                "soak: interrupted after {:.0} s of {:.0} s",
                report.lasted_seconds,
                report.planned_seconds
            );
        }
        Some(report)
    }

    /// Writes the files of a soak, if it has any.
    fn write(&self, report: &SoakReport) -> anyhow::Result<()> {
        let Some(out) = self.soak.as_ref().and_then(|soak| soak.out.as_ref()) else {
            return Ok(());
        };
        for path in files::write_report(report, out)? {
            tracing::info!("soak: wrote {}", path.display());
            println!("wrote {}", path.display());
        }
        Ok(())
    }
}

/// The system's number of this thread, if it tells.
fn current_thread() -> Option<i32> {
    Path::new("/proc/thread-self")
        .read_link()
        .ok()?
        .file_name()?
        .to_str()?
        .parse()
        .ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn controller(rate: Option<f64>, refresh_rate: Option<f64>) -> QualityController {
        let options = QualityControl {
            rate,
            governed: true,
            soak: None,
        };
        QualityController::new(&options, refresh_rate)
    }

    fn held_rate(controller: &QualityController) -> f64 {
        controller.session.settings().rate
    }

    #[test]
    #[cfg(target_os = "linux")]
    fn a_thread_knows_its_number() {
        assert!(current_thread().is_some_and(|thread| thread > 0));
    }

    #[test]
    fn the_displays_rate_is_held_unless_another_is_asked_for() {
        let by_display = controller(None, Some(144.0));
        assert_eq!(held_rate(&by_display), 144.0);
        assert_eq!(by_display.next_frame(), None);
        assert!(!by_display.is_soaking());
        assert_eq!(held_rate(&controller(Some(30.0), Some(144.0))), 30.0);
        assert_eq!(held_rate(&controller(None, None)), DEFAULT_RATE);
    }

    #[test]
    fn only_a_rate_of_the_display_follows_the_display() {
        let mut by_display = controller(None, Some(120.0));
        by_display.set_refresh_rate(60.0);
        assert_eq!(held_rate(&by_display), 60.0);
        let mut by_user = controller(Some(30.0), Some(120.0));
        by_user.set_refresh_rate(60.0);
        assert_eq!(held_rate(&by_user), 30.0);
    }
}
