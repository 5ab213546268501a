//! Whether memory grows: what a process holds goes in, second by second; what it gained comes out.

use super::report::{Growth, Second};
use std::fs;

/// Until here programs and drivers set themselves up, seconds; of a short run, this share of it.
const SETTLED: (f64, f64) = (60.0, 0.4);

/// Bytes of the process's memory that are in the machine's, where the system tells.
pub fn resident() -> Option<u64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with("VmRSS:"))?;
    line.split_whitespace().nth(1)?.parse::<u64>().ok().map(|kib| kib << 10)
}

/// Medians of the fifth of the seconds after it has settled, and of the last fifth. None of fewer than ten seconds after that.
pub fn growth(seconds: &[Second]) -> Option<Growth> {
    let end = seconds.last()?.seconds;
    let settled = SETTLED.0.min(SETTLED.1 * end);
    let after: Vec<&Second> = seconds.iter().filter(|second| second.seconds >= settled).collect();
    let fifth = after.len() / 5;
    if fifth < 2 {
        return None;
    }
    let median = |part: &[&Second], of: fn(&Second) -> Option<u64>| {
        let mut bytes: Vec<u64> = part.iter().filter_map(|second| of(second)).collect();
        bytes.sort_unstable();
        bytes.get(bytes.len() / 2).copied()
    };
    let gained = |of: fn(&Second) -> Option<u64>| {
        let [first, last] = [&after[..fifth], &after[after.len() - fifth..]].map(|part| median(part, of));
        first.zip(last).map(|(first, last)| last as i64 - first as i64)
    };
    let device_bytes = gained(|second| Some(second.device_bytes)).unwrap_or(0);
    Some(Growth { from_seconds: settled, device_bytes, resident_bytes: gained(|second| second.resident_bytes) })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn seconds(resident: impl Fn(usize) -> u64) -> Vec<Second> {
        (1..=100)
            .map(|at| Second { seconds: at as f64, device_bytes: 7, resident_bytes: Some(resident(at)), ..Second::default() })
            .collect()
    }

    #[test]
    fn a_leak_is_seen_and_the_start_is_not() {
        let grown = |resident: fn(usize) -> u64| growth(&seconds(resident)).and_then(|growth| growth.resident_bytes);
        assert_eq!(grown(|_| 50), Some(0));
        assert_eq!(grown(|at| if at < 40 { 10 * at as u64 } else { 400 }), Some(0));
        assert_eq!(grown(|at| 1000 * at as u64), Some(49_000), "60 seconds from the 40th on, twelve in a fifth");
        // A peak is no growth.
        assert_eq!(grown(|at| if at == 95 { 1 << 30 } else { 5 }), Some(0));
        assert!(growth(&seconds(|_| 1)[..3]).is_none());
    }

    #[test]
    #[cfg(target_os = "linux")]
    fn this_process_has_memory() {
        assert!(resident().is_some_and(|bytes| bytes > 1 << 20));
    }
}
