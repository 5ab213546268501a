//! Ctrl-C and SIGTERM for commands that end in order.

use anyhow::Context;
use effigy::vulkan::tuning::Record;
use std::{
    sync::{
        Arc, OnceLock,
        atomic::{AtomicBool, AtomicUsize, Ordering},
        mpsc::{self, RecvTimeoutError},
    },
    time::Duration,
};

/// How often it is looked whether a signal came.
const LOOKS_EVERY: Duration = Duration::from_millis(10);

/// A flag that signals set.
pub struct Interrupts {
    stop: Arc<AtomicBool>,
    /// The signal that came last; 0 before one.
    signal: Arc<AtomicUsize>,
    /// Set while the signals end the program as they do by default.
    as_usual: Arc<AtomicBool>,
    /// Set while ways to draw are timed: [`Self::excuse`] ends the program then.
    trying: Arc<AtomicBool>,
}

impl Interrupts {
    /// Ctrl-C, SIGTERM and a closed terminal set the flag from now on, which is said at once. A
    /// second Ctrl-C ends the program.
    pub fn listen() -> anyhow::Result<Self> {
        let new = Self::new(false);
        #[cfg(not(any(target_arch = "wasm32", target_os = "android")))]
        {
            use signal_hook::{
                consts::{SIGHUP, SIGINT, SIGTERM},
                flag,
            };
            flag::register_conditional_shutdown(SIGINT, 130, new.stop.clone()).context(FAILED)?;
            new.register(&[SIGINT, SIGTERM, SIGHUP])?;
        }
        new.when_stopped(|| eprintln!("stopping"));
        Ok(new)
    }

    /// Has a signal end the program with an exit code and a sentence, whatever it is at, unless there
    /// is something to save by then.
    pub fn leave_unless(
        &self,
        is_to_save: &Arc<AtomicBool>,
        code: u8,
        sentence: impl FnOnce() -> String + Send + 'static,
    ) {
        let is_to_save = is_to_save.clone();
        let trying = self.trying.clone();
        self.when_stopped(move || {
            if !is_to_save.load(Ordering::SeqCst) && !trying.load(Ordering::SeqCst) {
                eprintln!("{}", sentence());
                exit_now(code.into());
            }
        });
    }

    /// Does something when the flag is set.
    fn when_stopped(&self, act: impl FnOnce() + Send + 'static) {
        let stop = self.stop.clone();
        std::thread::spawn(move || {
            while !stop.load(Ordering::SeqCst) {
                std::thread::sleep(LOOKS_EVERY);
            }
            act();
        });
    }

    /// For commands with no end of their own: Ctrl-C and SIGTERM end the program as they do by
    /// default, but within [`Self::excuse`]. One for the whole program, since what listens to a
    /// signal listens for ever. A closed terminal is left to `nohup`.
    pub fn of_trials() -> anyhow::Result<&'static Self> {
        static OF_TRIALS: OnceLock<Interrupts> = OnceLock::new();
        if let Some(of_trials) = OF_TRIALS.get() {
            return Ok(of_trials);
        }
        let new = Self::new(true);
        #[cfg(not(any(target_arch = "wasm32", target_os = "android")))]
        new.register(&[signal_hook::consts::SIGINT, signal_hook::consts::SIGTERM])?;
        Ok(OF_TRIALS.get_or_init(|| new))
    }

    fn new(as_usual: bool) -> Self {
        Self {
            stop: Arc::default(),
            signal: Arc::default(),
            as_usual: Arc::new(as_usual.into()),
            trying: Arc::default(),
        }
    }

    #[cfg(not(any(target_arch = "wasm32", target_os = "android")))]
    fn register(&self, signals: &[i32]) -> anyhow::Result<()> {
        use signal_hook::flag;
        for &signal in signals {
            let as_usual = self.as_usual.clone();
            flag::register_conditional_default(signal, as_usual).context(FAILED)?;
            let number = self.signal.clone();
            flag::register_usize(signal, number, signal as usize).context(FAILED)?;
            flag::register(signal, self.stop.clone()).context(FAILED)?;
        }
        Ok(())
    }

    /// The flag.
    pub fn flag(&self) -> &Arc<AtomicBool> {
        &self.stop
    }

    /// Has ways to draw timed. If a signal comes meanwhile the program ends, whatever the driver is
    /// at, and the way under trial is not to blame for it.
    pub fn excuse<T>(&self, record: &Record, time: impl FnOnce(&Record) -> T) -> T {
        let _usual = AsBefore {
            before: self.as_usual.swap(false, Ordering::SeqCst),
            interrupts: self,
        };
        self.trying.store(true, Ordering::SeqCst);
        std::thread::scope(|scope| {
            // Closed when the trials end, by a panic too.
            let (_trials, ended) = mpsc::channel::<()>();
            scope.spawn(move || {
                while ended.recv_timeout(LOOKS_EVERY) == Err(RecvTimeoutError::Timeout) {
                    if self.stop.load(Ordering::SeqCst) {
                        record.withdraw();
                        self.leave();
                    }
                }
            });
            time(record)
        })
    }

    /// Ends the program as its last signal does by default: no exit handler of a driver that still
    /// compiles is run.
    fn leave(&self) {
        #[cfg(not(any(target_arch = "wasm32", target_os = "android")))]
        {
            let signal = self.signal.load(Ordering::SeqCst) as i32;
            signal_hook::low_level::emulate_default_handler(signal).ok();
            exit_now(128 + signal);
        }
    }
}

/// Ends the program without exit handlers.
fn exit_now(code: i32) {
    #[cfg(not(any(target_arch = "wasm32", target_os = "android")))]
    signal_hook::low_level::exit(code);
    #[cfg(any(target_arch = "wasm32", target_os = "android"))]
    std::process::exit(code);
}

/// Has signals do again what they did before the trials.
struct AsBefore<'a> {
    before: bool,
    interrupts: &'a Interrupts,
}

impl Drop for AsBefore<'_> {
    fn drop(&mut self) {
        let as_usual = &self.interrupts.as_usual;
        as_usual.store(self.before, Ordering::SeqCst);
        self.interrupts.trying.store(false, Ordering::SeqCst);
        // One that came as the trials ended, and that nobody would look at.
        if self.before && self.interrupts.stop.load(Ordering::SeqCst) {
            self.interrupts.leave();
        }
    }
}

#[cfg(not(any(target_arch = "wasm32", target_os = "android")))]
const FAILED: &str = "Ctrl-C can't be listened to";
