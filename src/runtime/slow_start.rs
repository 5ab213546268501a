//! Tells a user what a program is waiting for, if it waits long.

use std::{
    sync::mpsc::{self, RecvTimeoutError, Sender},
    thread,
    time::Duration,
};

/// How long a program may start in silence.
const SILENCE: Duration = Duration::from_secs(1);

/// Drivers compile an avatar's shaders when a frame first needs them: for seconds, on some, until
/// they have them in their caches. Drop it with the first frame.
pub struct SlowStart {
    /// Dropped with the value, which ends the wait.
    _started: Sender<()>,
}

impl SlowStart {
    /// Calls `say` on a thread of its own, unless the value is dropped within a second.
    pub fn new(say: impl FnOnce() + Send + 'static) -> Self {
        let (started, wait) = mpsc::channel();
        thread::spawn(move || {
            if wait.recv_timeout(SILENCE) == Err(RecvTimeoutError::Timeout) {
                say();
            }
        });
        Self { _started: started }
    }
}

/// The sentence for a device.
pub fn compiling(device: &str) -> String {
    format!("starting on {device}: its driver compiles shaders at a first start")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_a_long_wait_is_explained() {
        let (said, heard) = mpsc::channel();
        let fast = SlowStart::new({
            let said = said.clone();
            move || said.send("fast").unwrap()
        });
        let slow = SlowStart::new(move || said.send("slow").unwrap());
        drop(fast);
        assert_eq!(heard.recv_timeout(10 * SILENCE), Ok("slow"));
        drop(slow);
        assert_eq!(heard.recv(), Err(mpsc::RecvError));
    }
}
