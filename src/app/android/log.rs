//! The system's log: events of `tracing` go in, lines of `adb logcat -s effigy` come out.

use std::{ffi::CString, io};
use tracing::{Level, Metadata};
use tracing_subscriber::{
    filter::Targets,
    fmt::{self, MakeWriter},
    layer::SubscriberExt,
    util::SubscriberInitExt,
};
use winit::platform::android::activity::ndk_sys;

/// What lines begin with in the log.
const TAG: &std::ffi::CStr = c"effigy";

/// Sends everything that the program says to the log.
pub fn start() {
    // No one sets an app's environment; a filter that reads it would bring regular expressions along.
    let filter = Targets::new().with_default(Level::WARN).with_target("winit", Level::ERROR).with_target("effigy", Level::INFO);
    let lines = fmt::layer().with_writer(Logcat).with_ansi(false).without_time().with_level(false).with_target(false);
    // A logger that is there already stays.
    let _ = tracing_subscriber::registry().with(filter).with(lines).try_init();
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
        let Ok(line) = CString::new(line.replace('\0', " ")) else { continue };
        // SAFETY: both strings outlive the call.
        unsafe { ndk_sys::__android_log_write(priority.0 as _, TAG.as_ptr(), line.as_ptr()) };
    }
}

struct Logcat;

/// One event on its way to the log.
struct Event {
    level: Level,
    text: Vec<u8>,
}

impl io::Write for Event {
    fn write(&mut self, part: &[u8]) -> io::Result<usize> {
        self.text.extend_from_slice(part);
        Ok(part.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl Drop for Event {
    fn drop(&mut self) {
        write(self.level, &String::from_utf8_lossy(&self.text));
    }
}

impl<'a> MakeWriter<'a> for Logcat {
    type Writer = Event;

    fn make_writer(&'a self) -> Event {
        Event { level: Level::INFO, text: Vec::new() }
    }

    fn make_writer_for(&'a self, meta: &Metadata<'_>) -> Event {
        Event { level: *meta.level(), text: Vec::new() }
    }
}
