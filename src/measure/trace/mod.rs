//! Timelines of host and device on one clock: frames' reports go in, a file that Perfetto and Chrome's tracer show comes out.
//!
//! The device's clock is put on the host's by calibrated timestamps where the driver has them, else by timestamps that are waited for, at the
//! start and the end; the file says which, and how far off it may be ([`align`]). [`event`] is the format.

pub mod align;
mod event;

use crate::{
    frame::report::{FrameReport, HostTimes},
    vulkan::{Gpu, calibration::Moment},
};
use align::{Alignment, Clock, since};
use event::{DEVICE, Event, HOST};
use serde_json::json;
use std::{collections::VecDeque, fs, io, path::Path, time::Instant};

/// Frames that are kept: the last ones. As many counters.
const KEPT: usize = 3000;

/// A frame's times.
struct Frame {
    number: u64,
    host: HostTimes,
    stages: Vec<(&'static str, [u64; 2])>,
    skipped: Vec<&'static str>,
}

/// A trace under way.
pub struct Trace {
    start: Instant,
    first: Option<Moment>,
    frames: VecDeque<Frame>,
    seen: u64,
    counters: VecDeque<(Instant, &'static str, f64)>,
}

impl Trace {
    pub fn new(gpu: &Gpu) -> Self {
        let (frames, counters) = (VecDeque::with_capacity(KEPT), VecDeque::with_capacity(KEPT));
        Self { start: Instant::now(), first: gpu.moment(), frames, seen: 0, counters }
    }

    /// Takes in the report of the last finished frame, unless it has it already.
    pub fn frame(&mut self, report: &FrameReport) {
        let Some(host) = report.host.filter(|host| host.began >= self.start) else { return };
        if self.frames.back().is_some_and(|last| last.host.began == host.began) {
            return;
        }
        if self.frames.len() == KEPT {
            self.frames.pop_front();
        }
        let stages = report.stages.iter().map(|stage| stage.0).zip(report.ticks.iter().copied()).collect();
        self.frames.push_back(Frame { number: self.seen, host, stages, skipped: report.skipped.clone() });
        self.seen += 1;
    }

    /// A number that changes now and then.
    pub fn counter(&mut self, name: &'static str, value: f64) {
        if self.counters.len() == KEPT {
            self.counters.pop_front();
        }
        self.counters.push_back((Instant::now(), name, value));
    }

    /// The file: Chrome's trace format, JSON.
    pub fn json(&self, gpu: &Gpu) -> serde_json::Value {
        let probe = &gpu.probe;
        let clock = Clock { mask: probe.tick_mask(), period: f64::from(probe.limits.timestamp_period) };
        let moments = self.first.zip(gpu.moment());
        let alignment = moments.map(|(first, last)| Alignment::new(clock, self.start, [first, last]));
        let mut events = event::names(&probe.name);
        for frame in &self.frames {
            self.host(frame, &mut events);
            alignment.inspect(|alignment| device(frame, alignment, since(self.start, frame.host.submitted), &mut events));
        }
        for &(at, name, value) in &self.counters {
            events.push(Event::Counter { name, at: since(self.start, at), value });
        }
        let (method, within) = match alignment {
            Some(alignment) if alignment.calibrated => ("calibrated timestamps", Some(alignment.within)),
            Some(alignment) => ("a timestamp that was submitted alone and waited for", Some(alignment.within)),
            None => ("none: the device has no timestamps", None),
        };
        json!({
            "displayTimeUnit": "ms",
            "traceEvents": events.iter().flat_map(Event::json).collect::<Vec<_>>(),
            "otherData": {
                "program": format!("effigy {}", env!("CARGO_PKG_VERSION")),
                "device": probe.name,
                "driver": probe.driver,
                "alignment": method,
                "alignment_within_us": within.map(|ns| ns / 1e3),
                "frames": self.frames.len(),
                "frames_left_out": self.seen - self.frames.len() as u64,
            },
        })
    }

    /// Writes the file.
    ///
    /// # Errors
    /// When it can't be written.
    pub fn write(&self, path: &Path, gpu: &Gpu) -> io::Result<()> {
        fs::write(path, self.json(gpu).to_string())
    }

    fn host(&self, frame: &Frame, events: &mut Vec<Event>) {
        let HostTimes { began, waited, recorded, submitted, .. } = frame.host;
        let slice = |name: String, from: Instant, to: Instant, args| {
            let [from, to] = [from, to].map(|at| since(self.start, at));
            Event::Slice { name, thread: HOST, from, to, args }
        };
        events.push(slice(format!("frame {}", frame.number), began, submitted, json!({ "skipped": frame.skipped })));
        let parts = [("wait", began, waited), ("record", waited, recorded), ("submit", recorded, submitted)];
        events.extend(parts.map(|(name, from, to)| slice(name.into(), from, to, json!({}))));
    }
}

/// A frame on the device, the stages in it, and an arrow from where it was submitted.
fn device(frame: &Frame, alignment: &Alignment, submitted: f64, events: &mut Vec<Event>) {
    let times: Vec<[f64; 2]> = frame.stages.iter().map(|(_, ticks)| ticks.map(|tick| alignment.of(tick))).collect();
    let (Some(first), Some(last)) = (times.first(), times.iter().map(|times| times[1]).reduce(f64::max)) else { return };
    let (from, number) = (first[0], frame.number);
    let slice = |name: String, from: f64, to: f64, args| Event::Slice { name, thread: DEVICE, from, to, args };
    events.push(slice(format!("frame {number}"), from, last, json!({})));
    // A stage may begin before the one before has ended; slices of one track may not overlap.
    let mut free = from;
    for ((name, _), [began, ended]) in frame.stages.iter().zip(&times) {
        let shown = began.max(free).min(last);
        let to = ended.max(shown);
        events.push(slice((*name).into(), shown, to, json!({ "overlap_us": (shown - began) / 1e3 })));
        free = to;
    }
    events.push(Event::Arrow { number, from: submitted, to: from.max(submitted) });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stages_that_overlap_are_shown_one_after_the_other() {
        let now = Instant::now();
        let host = HostTimes { began: now, waited: now, recorded: now, submitted: now, finished: now };
        let stages = vec![("splats", [100, 300]), ("sort", [250, 400]), ("raster", [390, 395])];
        let frame = Frame { number: 3, host, stages, skipped: vec![] };
        let clock = Clock { mask: u64::MAX, period: 1.0 };
        let moment = Moment { host: now, tick: 0, within: Default::default(), calibrated: true };
        let alignment = Alignment::new(clock, now, [moment; 2]);
        let mut events = Vec::new();
        device(&frame, &alignment, 90.0, &mut events);
        let slices: Vec<[f64; 2]> =
            events.iter().filter_map(|event| if let Event::Slice { from, to, .. } = event { Some([*from, *to]) } else { None }).collect();
        assert_eq!(slices, [[100.0, 400.0], [100.0, 300.0], [300.0, 400.0], [400.0, 400.0]]);
        assert!(matches!(events.last(), Some(Event::Arrow { number: 3, .. })));
    }
}
