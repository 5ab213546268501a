//! Keeps frames in step with the display, if the system reports its refreshes.

use crate::{pacing::Pacing, painter::WindowPainter};
use effigy_core::frame::FrameReport;
use std::time::Instant;

/// The display's rhythm, and the system's reports that it is learned from.
pub struct FrameSync {
    /// When the viewer's clock was 0.
    start: Instant,
    pacing: Pacing,
}

impl FrameSync {
    /// `start`: when the viewer's clock was 0.
    pub fn new(start: Instant) -> Self {
        Self {
            start,
            pacing: Pacing::default(),
        }
    }

    /// Nothing was drawn for a while.
    pub fn rest(&mut self) {
        self.pacing.rest();
    }

    /// A frame begins at `now`, seconds, to be shown for `refreshes` of the display. Returns the
    /// time that its image is for.
    #[cfg_attr(not(target_os = "android"), expect(unused_variables))]
    pub fn begin(&mut self, now: f64, refreshes: u32, painter: &mut WindowPainter) -> f64 {
        #[cfg(target_os = "android")]
        self.receive_feedback(now, painter);
        let time = self.pacing.frame(now, refreshes);
        #[cfg(target_os = "android")]
        self.schedule(now, refreshes, painter);
        time
    }

    /// Takes what the system has reported of the display since the last frame.
    #[cfg(target_os = "android")]
    fn receive_feedback(&mut self, now: f64, painter: &WindowPainter) {
        use crate::android::vsync;
        let clock = self.start.elapsed().as_secs_f64();
        let system_clock = vsync::now();
        let seconds = |at: u64| clock - (system_clock as f64 - at as f64) / 1e9;
        if let Some(feedback) = painter.present_feedback() {
            if let Some(period) = feedback.period {
                self.pacing.set_period(period.as_secs_f64());
            }
            for &shown in &feedback.shown {
                self.pacing.image_shown(seconds(shown));
            }
        }
        if self.pacing.wants_refreshes(now) {
            if let Some(refresh) = vsync::take() {
                self.pacing.refresh(seconds(refresh));
            }
            vsync::request();
        }
    }

    /// Tells the display when to show the frame that began at `now`.
    #[cfg(target_os = "android")]
    fn schedule(&mut self, now: f64, refreshes: u32, painter: &mut WindowPainter) {
        let show_at = self.pacing.show_at(now, refreshes);
        let clock = self.start.elapsed().as_secs_f64();
        let system_clock = crate::android::vsync::now();
        let nanoseconds =
            show_at.map(|at| system_clock.saturating_add_signed(((at - clock) * 1e9) as i64));
        painter.show_at(nanoseconds);
    }

    /// When to begin the next frame, seconds. None: as soon as the display takes one.
    pub fn next_frame(&self, now: f64, refreshes: u32) -> Option<f64> {
        self.pacing.next_frame(now, refreshes)
    }

    /// Refreshes a second, if the display itself reports them.
    #[cfg(target_os = "android")]
    pub fn display_rate(&self) -> Option<f64> {
        self.pacing.rate()
    }

    /// The frame that began at `began`, seconds, was submitted. `painted`: when painting it began.
    pub fn submitted(&mut self, began: f64, painted: Instant, report: &FrameReport) {
        let Some(host) = report.host else { return };
        let preparation = painted.duration_since(self.start).as_secs_f64() - began;
        let recording = (host.submitted - host.waited).as_secs_f64();
        let device = if report.stages.is_empty() {
            (host.finished - host.submitted).as_secs_f64()
        } else {
            report.gpu_ms() / 1e3
        };
        self.pacing.took(preparation + recording + device);
    }
}
