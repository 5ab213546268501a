//! Events of Chrome's trace format, which Perfetto reads. Times are nanoseconds since the trace's
//! start; the format has microseconds.

use serde_json::{Value, json};

const PROCESS: u32 = 1;
/// Number of the track of the host's frames.
pub const HOST: u32 = 1;
/// Number of the track of the device's frames.
pub const DEVICE: u32 = 2;

/// An event of a trace.
pub enum TraceEvent {
    /// The name of a track.
    TrackName { track: u32, name: String },
    /// Work that takes time.
    Slice(TraceSlice),
    /// From a frame's submission on the host to its start on the device.
    Arrow { number: u64, from: f64, to: f64 },
    /// The value of a counter from a time on.
    Counter {
        name: &'static str,
        at: f64,
        value: f64,
    },
}

/// Work on a track from one time to another.
pub struct TraceSlice {
    pub name: String,
    pub track: u32,
    pub from: f64,
    pub to: f64,
    pub args: Value,
}

/// The names of both tracks.
pub fn track_names(device: &str) -> [TraceEvent; 2] {
    let name = |track: u32, name: String| TraceEvent::TrackName { track, name };
    [
        name(HOST, "frames on the host".into()),
        name(DEVICE, format!("frames on {device}")),
    ]
}

/// Microseconds of a time in ns, to three digits. The format has no negative times.
fn microseconds(ns: f64) -> f64 {
    (ns.round() / 1e3).max(0.0)
}

impl TraceEvent {
    /// The events of the format: two for an arrow, else one.
    pub fn to_json(&self) -> Vec<Value> {
        match self {
            Self::TrackName { track, name } => vec![json!({
                "ph": "M",
                "name": "thread_name",
                "pid": PROCESS,
                "tid": track,
                "args": { "name": name },
            })],
            Self::Slice(slice) => vec![json!({
                "ph": "X",
                "name": slice.name,
                "cat": if slice.track == HOST { "host" } else { "device" },
                "pid": PROCESS,
                "tid": slice.track,
                "ts": microseconds(slice.from),
                "dur": microseconds(slice.to - slice.from),
                "args": slice.args,
            })],
            Self::Arrow { number, from, to } => {
                let end = |phase: &str, track: u32, at: f64| {
                    json!({
                        "ph": phase,
                        "name": "submit",
                        "cat": "frame",
                        "id": number,
                        "pid": PROCESS,
                        "tid": track,
                        "ts": microseconds(at),
                        "bp": "e",
                    })
                };
                vec![end("s", HOST, *from), end("f", DEVICE, *to)]
            }
            Self::Counter { name, at, value } => vec![json!({
                "ph": "C",
                "name": name,
                "pid": PROCESS,
                "ts": microseconds(*at),
                "args": { "value": value },
            })],
        }
    }
}
