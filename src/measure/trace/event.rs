//! Events of Chrome's trace format, which Perfetto reads. Times are nanoseconds since the trace's start; the format has microseconds.

use serde_json::{Value, json};

const PROCESS: u32 = 1;
/// Tracks.
pub const HOST: u32 = 1;
pub const DEVICE: u32 = 2;

pub enum Event {
    /// A name of a track.
    Name {
        thread: u32,
        name: String,
    },
    /// Something that takes time.
    Slice {
        name: String,
        thread: u32,
        from: f64,
        to: f64,
        args: Value,
    },
    /// From where a frame is submitted to where the device begins it.
    Arrow {
        number: u64,
        from: f64,
        to: f64,
    },
    Counter {
        name: &'static str,
        at: f64,
        value: f64,
    },
}

/// The process and its tracks.
pub fn names(device: &str) -> Vec<Event> {
    vec![
        Event::Name { thread: HOST, name: "frames on the host".into() },
        Event::Name { thread: DEVICE, name: format!("frames on {device}") },
    ]
}

impl Event {
    /// As the file has it: most are one of the format's events, an arrow is two.
    pub fn json(&self) -> Vec<Value> {
        let us = |ns: f64| (ns.round() / 1e3).max(0.0);
        match self {
            Self::Name { thread, name } => {
                vec![json!({ "ph": "M", "name": "thread_name", "pid": PROCESS, "tid": thread, "args": { "name": name } })]
            }
            Self::Slice { name, thread, from, to, args } => vec![json!({
                "ph": "X", "name": name, "cat": if *thread == HOST { "host" } else { "device" },
                "pid": PROCESS, "tid": thread, "ts": us(*from), "dur": us(to - from), "args": args,
            })],
            Self::Arrow { number, from, to } => {
                let end = |phase: &str, thread: u32, at: f64| json!({ "ph": phase, "name": "submit", "cat": "frame", "id": number, "pid": PROCESS, "tid": thread, "ts": us(at), "bp": "e" });
                vec![end("s", HOST, *from), end("f", DEVICE, *to)]
            }
            Self::Counter { name, at, value } => {
                vec![json!({ "ph": "C", "name": name, "pid": PROCESS, "ts": us(*at), "args": { "value": value } })]
            }
        }
    }
}
