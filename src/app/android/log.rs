//! Writes `tracing`'s events to the system's log: `adb logcat -s effigy` shows them.

use std::{ffi::CString, io};
use tracing::{Level, Metadata};
use tracing_subscriber::{
    filter::Targets,
    fmt::{self, MakeWriter},
    layer::SubscriberExt,
    util::SubscriberInitExt,
};
use winit::platform::android::activity::ndk_sys;

/// Tag of the lines in the log.
const TAG: &std::ffi::CStr = c"effigy";

/// Writes the program's events to the log from now on.
pub fn start() {
    // A filter from the environment would need regular expressions, and no one sets an app's
    // environment.
    let filter = Targets::new()
        .with_default(Level::WARN)
        .with_target("winit", Level::ERROR)
        .with_target("effigy", Level::INFO);
    let lines = fmt::layer()
        .with_writer(Logcat)
        .with_ansi(false)
        .without_time()
        .with_level(false)
        .with_target(false);
    // Fails if there is a logger already: that one stays.
    let _ = tracing_subscriber::registry()
        .with(filter)
        .with(lines)
        .try_init();
}

/// Writes text to the log, a line at a time.
pub fn write(level: Level, text: &str) {
    let priority = match level {
        Level::ERROR => ndk_sys::android_LogPriority::ANDROID_LOG_ERROR,
        Level::WARN => ndk_sys::android_LogPriority::ANDROID_LOG_WARN,
        Level::INFO => ndk_sys::android_LogPriority::ANDROID_LOG_INFO,
        _ => ndk_sys::android_LogPriority::ANDROID_LOG_DEBUG,
    };
    for line in text.lines() {
        let Ok(line) = CString::new(line.replace('\0', " ")) else {
            continue;
        };
        // SAFETY: both strings outlive the call.
        unsafe { ndk_sys::__android_log_write(priority.0 as _, TAG.as_ptr(), line.as_ptr()) };
    }
}

struct Logcat;

/// Collects the text of one event, and writes it when dropped.
struct LogLine {
    level: Level,
    text: Vec<u8>,
}

impl io::Write for LogLine {
    fn write(&mut self, part: &[u8]) -> io::Result<usize> {
        self.text.extend_from_slice(part);
        Ok(part.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl Drop for LogLine {
    fn drop(&mut self) {
        write(self.level, &String::from_utf8_lossy(&self.text));
    }
}

impl<'a> MakeWriter<'a> for Logcat {
    type Writer = LogLine;

    fn make_writer(&'a self) -> LogLine {
        LogLine {
            level: Level::INFO,
            text: Vec::new(),
        }
    }

    fn make_writer_for(&'a self, meta: &Metadata<'_>) -> LogLine {
        LogLine {
            level: *meta.level(),
            text: Vec::new(),
        }
    }
}
