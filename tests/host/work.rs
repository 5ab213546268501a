//! How long a thread has worked.

use std::{sync::LazyLock, time::Instant};

/// Seconds that this thread has worked, where the system tells, so that other programs do not count;
/// else seconds.
pub fn seconds_of_work() -> f64 {
    static START: LazyLock<Instant> = LazyLock::new(Instant::now);
    let told = std::fs::read_to_string("/proc/thread-self/schedstat").ok();
    let nanoseconds = told.and_then(|text| text.split(' ').next()?.parse::<f64>().ok());
    nanoseconds.map_or_else(|| START.elapsed().as_secs_f64(), |told| told / 1e9)
}
