//! Ctrl-C and SIGTERM for commands that end in order.

use anyhow::Context;
use effigy_render::vulkan::trial;
use std::{
    sync::{
        Arc,
        atomic::{AtomicBool, AtomicUsize, Ordering},
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
}

impl Interrupts {
    /// Ctrl-C, SIGTERM and a closed terminal set the flag from now on, which is said at once. A
    /// second Ctrl-C ends the program.
    pub fn listen() -> anyhow::Result<Self> {
        let new = Self::new();
        #[cfg(not(any(target_arch = "wasm32", target_os = "android")))]
        {
            use signal_hook::{
                consts::{SIGHUP, SIGINT, SIGTERM},
                flag,
            };
            flag::register_conditional_shutdown(SIGINT, 130, new.stop.clone()).context(FAILED)?;
            new.register(&[SIGINT, SIGTERM, SIGHUP])?;
        }
        new.when_stopped(|_| eprintln!("stopping"));
        Ok(new)
    }

    /// Has a signal end the program with an exit code and a sentence, whatever it is at, unless
    /// there is something to save by then.
    pub fn leave_unless(
        &self,
        is_to_save: &Arc<AtomicBool>,
        code: u8,
        sentence: impl FnOnce() -> String + Send + 'static,
    ) {
        let is_to_save = is_to_save.clone();
        self.when_stopped(move |_| {
            if !is_to_save.load(Ordering::SeqCst) {
                trial::withdraw();
                eprintln!("{}", sentence());
                exit_now(code.into());
            }
        });
    }

    /// For commands with no end of their own: Ctrl-C and SIGTERM end the program as they do by
    /// default, whatever a driver is at, and what is under trial then is not to blame for it. A
    /// closed terminal is left to `nohup`.
    pub fn excuse_trials() -> anyhow::Result<()> {
        let new = Self::new();
        #[cfg(not(any(target_arch = "wasm32", target_os = "android")))]
        new.register(&[signal_hook::consts::SIGINT, signal_hook::consts::SIGTERM])?;
        new.when_stopped(|signal| {
            trial::withdraw();
            leave(signal);
        });
        Ok(())
    }

    fn new() -> Self {
        Self {
            stop: Arc::default(),
            signal: Arc::default(),
        }
    }

    /// Does something with the signal when the flag is set.
    fn when_stopped(&self, act: impl FnOnce(usize) + Send + 'static) {
        let (stop, signal) = (self.stop.clone(), self.signal.clone());
        std::thread::spawn(move || {
            while !stop.load(Ordering::SeqCst) {
                std::thread::sleep(LOOKS_EVERY);
            }
            act(signal.load(Ordering::SeqCst));
        });
    }

    #[cfg(not(any(target_arch = "wasm32", target_os = "android")))]
    fn register(&self, signals: &[i32]) -> anyhow::Result<()> {
        use signal_hook::flag;
        for &signal in signals {
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
}

/// Ends the program as a signal does by default: no exit handler of a driver that still compiles is
/// run.
fn leave(signal: usize) {
    let signal = signal as i32;
    #[cfg(not(any(target_arch = "wasm32", target_os = "android")))]
    signal_hook::low_level::emulate_default_handler(signal).ok();
    exit_now(128 + signal);
}

/// Ends the program without exit handlers.
fn exit_now(code: i32) {
    #[cfg(not(any(target_arch = "wasm32", target_os = "android")))]
    signal_hook::low_level::exit(code);
    #[cfg(any(target_arch = "wasm32", target_os = "android"))]
    std::process::exit(code);
}

#[cfg(not(any(target_arch = "wasm32", target_os = "android")))]
const FAILED: &str = "Ctrl-C can't be listened to";
