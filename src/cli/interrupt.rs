//! Ctrl-C and SIGTERM for commands that end in order.

use anyhow::Context;
use effigy::vulkan::tuning::Record;
use std::{
    sync::{
        Arc,
        atomic::{AtomicBool, Ordering},
        mpsc::{self, RecvTimeoutError},
    },
    time::Duration,
};

/// How often [`Interrupts::excuse`] looks at the flag.
const LOOKS_EVERY: Duration = Duration::from_millis(50);

/// A flag that Ctrl-C, SIGTERM and a closed terminal set. A second Ctrl-C ends the program at once.
pub struct Interrupts {
    stop: Arc<AtomicBool>,
    /// Set where the signals end the program again as they do by default.
    as_usual: Arc<AtomicBool>,
}

impl Interrupts {
    /// Listens from now on.
    pub fn listen() -> anyhow::Result<Self> {
        let stop = Arc::new(AtomicBool::new(false));
        let as_usual = Arc::new(AtomicBool::new(false));
        #[cfg(not(any(target_arch = "wasm32", target_os = "android")))]
        {
            use signal_hook::{
                consts::{SIGHUP, SIGINT, SIGTERM},
                flag,
            };
            let failed = "Ctrl-C can't be listened to";
            for signal in [SIGINT, SIGTERM, SIGHUP] {
                flag::register_conditional_default(signal, as_usual.clone()).context(failed)?;
            }
            flag::register_conditional_shutdown(SIGINT, EXIT_CODE, stop.clone()).context(failed)?;
            for signal in [SIGINT, SIGTERM, SIGHUP] {
                flag::register(signal, stop.clone()).context(failed)?;
            }
        }
        Ok(Self { stop, as_usual })
    }

    /// The flag.
    pub fn flag(&self) -> &Arc<AtomicBool> {
        &self.stop
    }

    /// From now on the signals end the program as they do by default.
    pub fn end_as_usual(&self) {
        self.as_usual.store(true, Ordering::Relaxed);
    }

    /// Has ways to draw timed. If a signal comes meanwhile the program ends, whatever the driver is
    /// at, and the way under trial is not to blame for it.
    pub fn excuse<T>(&self, record: &Record, time: impl FnOnce(&Record) -> T) -> T {
        std::thread::scope(|scope| {
            // Closed when the trials end, by a panic too.
            let (ended, end) = mpsc::channel::<()>();
            scope.spawn(move || {
                while end.recv_timeout(LOOKS_EVERY) == Err(RecvTimeoutError::Timeout) {
                    if self.stop.load(Ordering::Relaxed) {
                        record.withdraw();
                        leave();
                    }
                }
            });
            let timed = time(record);
            drop(ended);
            timed
        })
    }
}

/// What a shell says of a program that Ctrl-C ended.
#[cfg(not(any(target_arch = "wasm32", target_os = "android")))]
const EXIT_CODE: i32 = 130;

/// Ends the program at once: a driver that compiles meanwhile must not run its own exit handlers.
#[cfg(not(any(target_arch = "wasm32", target_os = "android")))]
fn leave() {
    signal_hook::low_level::exit(EXIT_CODE);
}

#[cfg(any(target_arch = "wasm32", target_os = "android"))]
fn leave() {}
