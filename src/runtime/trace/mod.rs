//! Timelines of host and device on one clock: frame reports go in, a file for Perfetto and Chrome's
//! tracer comes out.
//!
//! The device's clock is mapped to the host's by calibrated timestamps where the driver has them,
//! else by timestamps that are waited for, at the start and the end. The file says which, and how
//! large the error may be ([`align`]). The private module `event` is the format.

pub mod align;
mod event;

use align::{Clock, ClockAlignment, nanoseconds_since};
use effigy_core::{
    frame::report::{FrameReport, HostTimes},
    io::file::write_whole,
};
use effigy_render::vulkan::{ClockMoment, Gpu};
use event::{DEVICE, HOST, TraceEvent, TraceSlice};
use serde_json::json;
use std::{collections::VecDeque, io, path::Path, time::Instant};

/// The last frames, and as many counter values, are in the file.
const CAPACITY: usize = 3000;

/// Times of one frame.
struct TracedFrame {
    number: u64,
    host: HostTimes,
    /// Each stage with its first and last timestamp.
    stages: Vec<(&'static str, [u64; 2])>,
    skipped: Vec<&'static str>,
}

/// The value of a counter from a time on.
struct CounterValue {
    at: Instant,
    name: &'static str,
    value: f64,
}

/// A trace in progress.
pub struct TraceRecorder {
    start: Instant,
    first_moment: Option<ClockMoment>,
    frames: VecDeque<TracedFrame>,
    /// All frames that were added, including those dropped since.
    frame_count: u64,
    counters: VecDeque<CounterValue>,
}

impl TraceRecorder {
    /// Starts a trace of a device now.
    pub fn new(gpu: &Gpu) -> Self {
        Self {
            start: Instant::now(),
            first_moment: gpu.moment(),
            frames: VecDeque::with_capacity(CAPACITY),
            frame_count: 0,
            counters: VecDeque::with_capacity(CAPACITY),
        }
    }

    /// Adds the report of a finished frame. A report that was added last, or of a frame from before
    /// the trace, is ignored.
    pub fn add_frame(&mut self, report: &FrameReport) {
        let Some(host) = report.host else {
            return;
        };
        let last_began = self.frames.back().map(|last| last.host.began);
        if host.began < self.start || last_began == Some(host.began) {
            return;
        }
        if self.frames.len() == CAPACITY {
            self.frames.pop_front();
        }
        let names = report.stages.iter().map(|stage| stage.0);
        self.frames.push_back(TracedFrame {
            number: self.frame_count,
            host,
            stages: names.zip(report.ticks.iter().copied()).collect(),
            skipped: report.skipped.clone(),
        });
        self.frame_count += 1;
    }

    /// Sets the value of a counter from now on.
    pub fn add_counter(&mut self, name: &'static str, value: f64) {
        if self.counters.len() == CAPACITY {
            self.counters.pop_front();
        }
        let at = Instant::now();
        self.counters.push_back(CounterValue { at, name, value });
    }

    /// The file's contents: JSON in Chrome's trace format.
    pub fn to_json(&self, gpu: &Gpu) -> serde_json::Value {
        let probe = &gpu.probe;
        let clock = Clock {
            mask: probe.tick_mask(),
            period: f64::from(probe.limits.timestamp_period),
        };
        let moments = self.first_moment.zip(gpu.moment());
        let alignment =
            moments.map(|(first, last)| ClockAlignment::new(clock, self.start, first, last));
        let mut events = Vec::from(event::track_names(&probe.name));
        for frame in &self.frames {
            self.add_host_events(frame, &mut events);
            if let Some(alignment) = &alignment {
                let submitted = nanoseconds_since(self.start, frame.host.submitted);
                add_device_events(frame, alignment, submitted, &mut events);
            }
        }
        for counter in &self.counters {
            events.push(TraceEvent::Counter {
                name: counter.name,
                at: nanoseconds_since(self.start, counter.at),
                value: counter.value,
            });
        }
        let method = match alignment {
            Some(alignment) if alignment.calibrated => "calibrated timestamps",
            Some(_) => "a timestamp that was submitted alone and waited for",
            None => "none: the device has no timestamps",
        };
        json!({
            "displayTimeUnit": "ms",
            "traceEvents": events.iter().flat_map(TraceEvent::to_json).collect::<Vec<_>>(),
            "otherData": {
                "program": format!("effigy {}", env!("CARGO_PKG_VERSION")),
                "device": probe.name,
                "driver": probe.driver,
                "alignment": method,
                "alignment_within_us": alignment.map(|alignment| alignment.within / 1e3),
                "frames": self.frames.len(),
                "frames_left_out": self.frame_count - self.frames.len() as u64,
            },
        })
    }

    /// Writes the file.
    ///
    /// # Errors
    /// When it can't be written.
    pub fn write(&self, path: &Path, gpu: &Gpu) -> io::Result<()> {
        write_whole(path, self.to_json(gpu).to_string().as_bytes())
    }

    /// Adds a frame's slice on the host, with its waiting, recording and submission inside.
    fn add_host_events(&self, frame: &TracedFrame, events: &mut Vec<TraceEvent>) {
        let slice = |name: String, from: Instant, to: Instant, args| {
            TraceEvent::Slice(TraceSlice {
                name,
                track: HOST,
                from: nanoseconds_since(self.start, from),
                to: nanoseconds_since(self.start, to),
                args,
            })
        };
        let host = &frame.host;
        events.push(slice(
            format!("frame {}", frame.number),
            host.began,
            host.submitted,
            json!({ "skipped": frame.skipped }),
        ));
        for (name, from, to) in [
            ("wait", host.began, host.waited),
            ("record", host.waited, host.recorded),
            ("submit", host.recorded, host.submitted),
        ] {
            events.push(slice(name.into(), from, to, json!({})));
        }
    }
}

/// Adds a frame's slice on the device, its stages inside, and an arrow from its submission, ns
/// since the trace's start. Adds nothing for a frame without stages.
fn add_device_events(
    frame: &TracedFrame,
    alignment: &ClockAlignment,
    submitted: f64,
    events: &mut Vec<TraceEvent>,
) {
    let stage_times =
        |stage: &(&'static str, [u64; 2])| stage.1.map(|tick| alignment.nanoseconds(tick));
    let times: Vec<[f64; 2]> = frame.stages.iter().map(stage_times).collect();
    let ends = times.iter().map(|&[_, end]| end);
    let (Some(&[frame_start, _]), Some(frame_end)) = (times.first(), ends.reduce(f64::max)) else {
        return;
    };
    let slice = |name: String, from: f64, to: f64, args| {
        TraceEvent::Slice(TraceSlice {
            name,
            track: DEVICE,
            from,
            to,
            args,
        })
    };
    let name = format!("frame {}", frame.number);
    events.push(slice(name, frame_start, frame_end, json!({})));
    // A stage may begin before the one before has ended, but slices of one track must not overlap.
    let mut previous_end = frame_start;
    for ((name, _), &[start, end]) in frame.stages.iter().zip(&times) {
        let shown_start = start.max(previous_end).min(frame_end);
        let shown_end = end.max(shown_start);
        events.push(slice(
            (*name).into(),
            shown_start,
            shown_end,
            json!({ "overlap_us": (shown_start - start) / 1e3 }),
        ));
        previous_end = shown_end;
    }
    events.push(TraceEvent::Arrow {
        number: frame.number,
        from: submitted,
        to: frame_start.max(submitted),
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn overlapping_stages_are_shown_one_after_the_other() {
        let now = Instant::now();
        let host = HostTimes {
            began: now,
            waited: now,
            recorded: now,
            submitted: now,
            finished: now,
        };
        let frame = TracedFrame {
            number: 3,
            host,
            stages: vec![
                ("project", [100, 300]),
                ("sort", [250, 400]),
                ("raster", [390, 395]),
            ],
            skipped: vec![],
        };
        let clock = Clock {
            mask: u64::MAX,
            period: 1.0,
        };
        let moment = ClockMoment {
            host: now,
            tick: 0,
            within: Default::default(),
            calibrated: true,
        };
        let alignment = ClockAlignment::new(clock, now, moment, moment);
        let mut events = Vec::new();
        add_device_events(&frame, &alignment, 90.0, &mut events);
        let mut slices = Vec::new();
        for event in &events {
            if let TraceEvent::Slice(slice) = event {
                slices.push([slice.from, slice.to]);
            }
        }
        assert_eq!(
            slices,
            [
                [100.0, 400.0],
                [100.0, 300.0],
                [300.0, 400.0],
                [400.0, 400.0]
            ]
        );
        assert!(matches!(
            events.last(),
            Some(TraceEvent::Arrow { number: 3, .. })
        ));
    }
}
