//! Keeps the viewer's frames in step with the display, where the system tells of its refreshes.

use super::viewer::Viewer;
use std::time::Instant;

impl Viewer {
    /// A frame begins: gives the time that it is a picture of.
    pub(super) fn in_step(&mut self, clock: f64) -> f64 {
        if self.resting {
            self.pacing.rest();
        }
        #[cfg(target_os = "android")]
        self.listen(clock);
        let moment = self.pacing.frame(clock, self.refreshes());
        #[cfg(target_os = "android")]
        self.tell(clock);
        moment
    }

    /// Takes in what the system has told of the display since the last frame.
    #[cfg(target_os = "android")]
    fn listen(&mut self, clock: f64) {
        use super::android::beat;
        let (here, now) = (self.clock(), beat::now());
        let seconds = |at: u64| here - (now as f64 - at as f64) / 1e9;
        let told = self.painter.as_ref().and_then(|painter| painter.told()).unwrap_or_default();
        told.period.iter().for_each(|period| self.pacing.set_period(period.as_secs_f64()));
        told.shown.iter().for_each(|&at| self.pacing.shown(seconds(at)));
        if self.pacing.wants_ticks(clock) {
            beat::take().iter().for_each(|&at| self.pacing.tick(seconds(at)));
            beat::ask();
        }
    }

    /// Tells the display when to show the frame that began.
    #[cfg(target_os = "android")]
    fn tell(&mut self, clock: f64) {
        let show = self.pacing.show(clock, self.refreshes());
        let (here, now) = (self.clock(), super::android::beat::now());
        if let Some(painter) = &mut self.painter {
            painter.show_at(show.map(|show| now.saturating_add_signed(((show - here) * 1e9) as i64)));
        }
    }

    /// Refreshes that every frame is shown for.
    pub(super) fn refreshes(&self) -> u32 {
        self.pace.as_ref().map_or(1, |pace| pace.quality().refreshes)
    }

    /// When the next frame may be begun, seconds of the viewer's clock; at once where None.
    pub(super) fn next_frame(&self) -> Option<f64> {
        let pace = self.pace.as_ref()?;
        self.pacing.begin(self.clock(), self.refreshes()).or_else(|| pace.next())
    }

    /// The frame that began at a time of the clock is drawn and handed over: `painted` is when painting it began.
    pub(super) fn stepped(&mut self, clock: f64, painted: Instant) {
        let Some(report) = self.painter.as_ref().map(|painter| painter.report()) else { return };
        let Some(host) = report.host else { return };
        let before = painted.duration_since(self.start).as_secs_f64() - clock;
        let device = if report.stages.is_empty() { (host.finished - host.submitted).as_secs_f64() } else { report.gpu_ms() / 1e3 };
        self.pacing.took(before + (host.submitted - host.waited).as_secs_f64() + device);
    }
}
