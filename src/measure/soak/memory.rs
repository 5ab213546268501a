//! Whether memory grows: what a process holds each second goes in, what it gained comes out.

use super::report::{Growth, Second};
use std::{collections::HashSet, fs};

/// Time in which programs and drivers set themselves up, seconds; in a short run at most this share
/// of it.
pub const SETTLING_SECONDS: f64 = 60.0;
/// See [`SETTLING_SECONDS`].
pub const SETTLING_SHARE: f64 = 0.4;

/// Shorter intervals are not judged, seconds.
const MIN_INTERVAL: usize = 10;

/// Bytes of the process that are in physical memory. None if the system does not tell.
pub fn resident_bytes() -> Option<u64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with("VmRSS:"))?;
    let kib: u64 = line.split_whitespace().nth(1)?.parse().ok()?;
    Some(kib << 10)
}

/// The growth of memory, summed over steady intervals.
///
/// The first minute ([`SETTLING_SHARE`] of a short run), and as long after the governor first
/// enters a step, are excluded: drivers allocate for a new image size then, and nothing at the next
/// visit. In each interval between those, the median of the first fifth is compared with that of
/// the last. None if no interval is long enough.
pub fn growth(seconds: &[Second]) -> Option<Growth> {
    let settling = SETTLING_SECONDS.min(SETTLING_SHARE * seconds.last()?.seconds);
    let mut intervals = steady_intervals(seconds, settling);
    intervals.retain(|interval| interval.len() >= MIN_INTERVAL);
    let from_seconds = intervals.first()?.first()?.seconds;
    let length = |interval: &&[Second]| interval[interval.len() - 1].seconds - interval[0].seconds;
    let total = |bytes: fn(&Second) -> Option<u64>| {
        let gains = intervals.iter().map(|interval| gain(interval, bytes));
        gains.sum::<Option<i64>>()
    };
    Some(Growth {
        from_seconds,
        judged_seconds: intervals.iter().map(length).sum(),
        device_bytes: total(|second| Some(second.device_bytes)).unwrap_or(0),
        resident_bytes: total(|second| second.resident_bytes),
    })
}

/// The parts of a run in which nothing is new: each begins `settling` seconds after the run or a
/// new step of the governor began, and ends at the next new step.
fn steady_intervals(seconds: &[Second], settling: f64) -> Vec<&[Second]> {
    let mut visited = HashSet::from([0]);
    let mut intervals = Vec::new();
    let mut begin = None;
    let mut settled_at = settling;
    for (index, second) in seconds.iter().enumerate() {
        if visited.insert(second.rung) {
            // `rung` is the step at the second's end, so the step may have been taken anywhere in
            // this second.
            if let Some(begin) = begin.take() {
                intervals.push(&seconds[begin..index]);
            }
            settled_at = settling.max(second.seconds + settling);
        }
        if second.seconds >= settled_at {
            begin.get_or_insert(index);
        }
    }
    if let Some(begin) = begin {
        intervals.push(&seconds[begin..]);
    }
    intervals
}

/// Bytes gained over an interval. None if they are unknown at an end of it.
fn gain(interval: &[Second], bytes: fn(&Second) -> Option<u64>) -> Option<i64> {
    let median = |part: &[Second]| {
        let mut values: Vec<u64> = part.iter().filter_map(bytes).collect();
        values.sort_unstable();
        values.get(values.len() / 2).copied()
    };
    let fifth = (interval.len() / 5).max(1);
    let first = median(&interval[..fifth])?;
    let last = median(&interval[interval.len() - fifth..])?;
    Some(last as i64 - first as i64)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn seconds(resident: impl Fn(usize) -> u64) -> Vec<Second> {
        (1..=100)
            .map(|at| Second {
                seconds: at as f64,
                device_bytes: 7,
                resident_bytes: Some(resident(at)),
                ..Second::default()
            })
            .collect()
    }

    #[test]
    fn a_leak_counts_and_the_start_does_not() {
        let grown = |resident: fn(usize) -> u64| {
            growth(&seconds(resident)).and_then(|growth| growth.resident_bytes)
        };
        assert_eq!(grown(|_| 50), Some(0));
        assert_eq!(
            grown(|at| if at < 40 { 10 * at as u64 } else { 400 }),
            Some(0)
        );
        assert_eq!(
            grown(|at| 1000 * at as u64),
            Some(49_000),
            "60 seconds from the 40th on, twelve in a fifth"
        );
        // A peak is not growth.
        assert_eq!(grown(|at| if at == 95 { 1 << 30 } else { 5 }), Some(0));
        assert!(growth(&seconds(|_| 1)[..12]).is_none());
    }

    /// A quarter of an hour in which the governor enters two new steps, for each of which the
    /// driver takes a MiB, and goes back and forth between them. `leak` is in bytes a second.
    fn heated(leak: f64) -> Vec<Second> {
        let rung = |at: usize| {
            if at < 400 {
                0
            } else {
                1 + usize::from(at >= 600 && (at / 20).is_multiple_of(2))
            }
        };
        let mib = |at: usize| u64::from(at >= 405) + u64::from(at >= 645);
        let bytes = |at: usize| (mib(at) << 20) + (leak * at as f64) as u64;
        (1..=900)
            .map(|at| Second {
                seconds: at as f64,
                rung: rung(at),
                resident_bytes: Some(bytes(at)),
                ..Second::default()
            })
            .collect()
    }

    #[test]
    fn only_growth_between_new_steps_is_a_leak() {
        let sound = growth(&heated(0.0)).unwrap();
        assert_eq!(
            (sound.from_seconds, sound.resident_bytes, sound.device_bytes),
            (60.0, Some(0), 0)
        );
        // Seconds 60 to 399, 460 to 599 and 660 to the end.
        assert_eq!(sound.judged_seconds, 339.0 + 139.0 + 240.0);
        let leaking = growth(&heated(3000.0)).unwrap().resident_bytes.unwrap();
        // Medians of the first and last fifth are 0.8 of an interval apart.
        assert!(
            (0.79..0.81).contains(&(leaking as f64 / 3000.0 / sound.judged_seconds)),
            "{leaking}"
        );
        assert!(
            leaking > 1 << 20,
            "the default limit finds 3 KB a second in a quarter of an hour"
        );
        // A step that leaks at every visit is found.
        let mut visits = heated(0.0);
        for second in &mut visits {
            second.resident_bytes = Some(100_000 * (second.seconds as u64 / 20));
        }
        assert!(growth(&visits).unwrap().resident_bytes.unwrap() > 2 << 20);
    }

    #[test]
    fn a_run_of_new_steps_only_is_not_judged() {
        let mut each = seconds(|_| 1);
        for second in &mut each {
            second.rung = second.seconds as usize / 12;
        }
        assert_eq!(growth(&each), None);
    }

    #[test]
    #[cfg(target_os = "linux")]
    fn this_process_has_memory() {
        assert!(resident_bytes().is_some_and(|bytes| bytes > 1 << 20));
    }
}
