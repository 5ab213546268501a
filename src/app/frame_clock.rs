//! Decides when frames are drawn: whether one is needed, and when the next may begin.

use crate::{
    frame_sync::FrameSync,
    frame_times::{FrameTimes, median_and_p95},
    painter::WindowPainter,
    scene::FrameContent,
};
use effigy_core::frame::FrameReport;
use std::time::{Duration, Instant};

/// The viewer's clock, the frames drawn by it, and the reasons to draw another one. Times are
/// seconds on this clock, which starts at 0.
pub struct FrameClock {
    start: Instant,
    sync: FrameSync,
    times: FrameTimes,
    /// The content of the last frame. None: it must be drawn again.
    shown: Option<FrameContent>,
    /// Something other than the content has changed: the panel, or what the system shows of the
    /// window.
    dirty: bool,
    /// The last chance to draw was not used, since nothing had changed.
    resting: bool,
    /// When the panel wants to be drawn again.
    panel_wake: Option<Instant>,
    /// Quit after this many frames.
    frame_limit: Option<u32>,
    frames: u32,
    /// How long each frame took, if there is a limit.
    durations_ms: Vec<f64>,
}

/// A frame that was drawn and submitted.
pub struct DrawnFrame {
    /// Its content.
    pub content: FrameContent,
    /// When it began, seconds.
    pub began: f64,
    /// When painting began.
    pub painted: Instant,
    /// When the panel wants to be drawn again, after `painted`.
    pub repaint_after: Option<Duration>,
}

impl FrameClock {
    /// The clock starts now. `frame_limit`: quit after this many frames.
    pub fn new(frame_limit: Option<u32>) -> Self {
        let start = Instant::now();
        let capacity = frame_limit.unwrap_or(0).min(1 << 20) as usize;
        Self {
            start,
            sync: FrameSync::new(start),
            times: FrameTimes::default(),
            shown: None,
            dirty: true,
            resting: true,
            panel_wake: None,
            frame_limit,
            frames: 0,
            durations_ms: Vec::with_capacity(capacity),
        }
    }

    /// Seconds since the viewer was created.
    pub fn now(&self) -> f64 {
        self.start.elapsed().as_secs_f64()
    }

    /// A time of this clock for the event loop.
    pub fn instant(&self, seconds: f64) -> Instant {
        self.start + Duration::from_secs_f64(seconds.max(0.0))
    }

    /// A frame has to be drawn.
    pub fn invalidate(&mut self) {
        self.dirty = true;
    }

    /// A frame has to be drawn, whatever was shown before: the device or the scene is new.
    pub fn invalidate_all(&mut self) {
        self.shown = None;
        self.dirty = true;
    }

    /// Whether something other than the content has changed since the last frame.
    pub fn is_dirty(&self) -> bool {
        self.dirty
    }

    /// Whether a frame of this content is on the screen, and nothing else has changed.
    pub fn shows(&self, content: &FrameContent) -> bool {
        self.shown.as_ref() == Some(content) && !self.dirty
    }

    /// No frame is drawn until something changes.
    pub fn rest(&mut self) {
        self.resting = true;
    }

    /// Whether the last chance to draw was not used.
    pub fn is_resting(&self) -> bool {
        self.resting
    }

    /// The number of frames drawn.
    pub fn frames(&self) -> u32 {
        self.frames
    }

    /// Whether frames are counted, and drawn even if nothing changes.
    pub fn has_limit(&self) -> bool {
        self.frame_limit.is_some()
    }

    /// Whether all the frames that were asked for are drawn.
    pub fn has_reached_limit(&self) -> bool {
        self.frame_limit.is_some_and(|limit| self.frames >= limit)
    }

    /// How long the last frames took.
    pub fn times(&self) -> &FrameTimes {
        &self.times
    }

    /// The display's rhythm.
    pub fn sync(&self) -> &FrameSync {
        &self.sync
    }

    /// When the panel wants to be drawn again.
    pub fn panel_wake(&self) -> Option<Instant> {
        self.panel_wake
    }

    /// Makes a frame necessary if the panel wants to be drawn again by now.
    pub fn check_panel_wake(&mut self) {
        if self.panel_wake.is_some_and(|wake| wake <= Instant::now()) {
            self.panel_wake = None;
            self.dirty = true;
        }
    }

    /// A frame may begin at `now`, to be shown for `refreshes` of the display. Returns the time
    /// that its image is for.
    pub fn frame_time(&mut self, now: f64, refreshes: u32, painter: &mut WindowPainter) -> f64 {
        if self.resting {
            self.sync.rest();
        }
        self.sync.begin(now, refreshes, painter)
    }

    /// A frame that began at `now` will be drawn.
    pub fn begin_frame(&mut self, now: f64) {
        self.times.frame(now, !self.resting);
    }

    /// A frame was submitted. `report`: the painter's.
    pub fn end_frame(&mut self, frame: &DrawnFrame, report: &FrameReport) {
        self.frames += 1;
        self.sync.submitted(frame.began, frame.painted, report);
        if self.frame_limit.is_some() {
            self.durations_ms.push(1e3 * (self.now() - frame.began));
        }
        self.panel_wake = frame.repaint_after.map(|wait| frame.painted + wait);
        self.shown = Some(frame.content);
        self.dirty = false;
        self.resting = false;
    }

    /// Median and 95th percentile of the frames' durations, ms. None if they were not measured.
    pub fn durations_ms(&mut self) -> Option<[f64; 2]> {
        median_and_p95(&mut self.durations_ms)
    }
}
