//! Whether memory grows: what a process holds goes in, second by second; what it gained comes out.

use super::report::{Growth, Second};
use std::{collections::HashSet, fs};

/// Until here programs and drivers set themselves up, seconds; of a short run, this share of it.
const SETTLED: (f64, f64) = (60.0, 0.4);

/// Seconds of a stretch that tells anything.
const SHORTEST: usize = 10;

/// Bytes of the process's memory that are in the machine's, where the system tells.
pub fn resident() -> Option<u64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with("VmRSS:"))?;
    line.split_whitespace().nth(1)?.parse::<u64>().ok().map(|kib| kib << 10)
}

/// What was gained, all stretches together, without the first minute (of short runs [`SETTLED`]'s share) and without as long after every step
/// of the governor that was not seen before: pictures of a new size take memory that programs and drivers keep, and take no more at the next
/// visit. Of each stretch between those, the median of its first fifth against that of its last. None where no stretch is long enough to tell.
pub fn growth(seconds: &[Second]) -> Option<Growth> {
    let settled = SETTLED.0.min(SETTLED.1 * seconds.last()?.seconds);
    let stretches: Vec<&[Second]> = stretches(seconds, settled).into_iter().filter(|stretch| stretch.len() >= SHORTEST).collect();
    let from_seconds = stretches.first()?.first()?.seconds;
    let sum = |of: fn(&Second) -> Option<u64>| stretches.iter().map(|stretch| gained(stretch, of)).sum::<Option<i64>>();
    Some(Growth {
        from_seconds,
        judged_seconds: stretches.iter().map(|stretch| stretch[stretch.len() - 1].seconds - stretch[0].seconds).sum(),
        device_bytes: sum(|second| Some(second.device_bytes)).unwrap_or(0),
        resident_bytes: sum(|second| second.resident_bytes),
    })
}

/// Parts of a run in which nothing is new: each begins so many seconds after the run did or a step was new, and ends where another is.
fn stretches(seconds: &[Second], settled: f64) -> Vec<&[Second]> {
    let (mut seen, mut stretches, mut begun, mut from) = (HashSet::from([0]), Vec::new(), None, settled);
    for (number, second) in seconds.iter().enumerate() {
        if seen.insert(second.rung) {
            // What a second says of its step is of its end: the step may have been taken anywhere in it.
            stretches.extend(begun.take().map(|begun| &seconds[begun..number]));
            from = settled.max(second.seconds + settled);
        }
        if second.seconds >= from {
            begun.get_or_insert(number);
        }
    }
    stretches.extend(begun.map(|begun| &seconds[begun..]));
    stretches
}

/// None where a median has nothing to be taken of.
fn gained(stretch: &[Second], of: fn(&Second) -> Option<u64>) -> Option<i64> {
    let fifth = (stretch.len() / 5).max(1);
    let median = |part: &[Second]| {
        let mut bytes: Vec<u64> = part.iter().filter_map(of).collect();
        bytes.sort_unstable();
        bytes.get(bytes.len() / 2).copied()
    };
    let [first, last] = [&stretch[..fifth], &stretch[stretch.len() - fifth..]].map(median);
    first.zip(last).map(|(first, last)| last as i64 - first as i64)
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
        assert!(growth(&seconds(|_| 1)[..12]).is_none());
    }

    /// A quarter of an hour in which the governor comes to two steps that are new, each worth a MiB to the driver, and goes between them.
    fn heated(leak: f64) -> Vec<Second> {
        let rung = |at: usize| if at < 400 { 0 } else { 1 + usize::from(at >= 600 && (at / 20).is_multiple_of(2)) };
        let mib = |at: usize| u64::from(at >= 405) + u64::from(at >= 645);
        let bytes = |at: usize| (mib(at) << 20) + (leak * at as f64) as u64;
        (1..=900).map(|at| Second { seconds: at as f64, rung: rung(at), resident_bytes: Some(bytes(at)), ..Second::default() }).collect()
    }

    #[test]
    fn what_a_new_step_takes_is_no_leak_and_a_leak_between_them_is() {
        let sound = growth(&heated(0.0)).unwrap();
        assert_eq!((sound.from_seconds, sound.resident_bytes, sound.device_bytes), (60.0, Some(0), 0));
        // Seconds 60 to 399, 460 to 599 and 660 to the end.
        assert_eq!(sound.judged_seconds, 339.0 + 139.0 + 240.0);
        let leaking = growth(&heated(3000.0)).unwrap().resident_bytes.unwrap();
        // 0.8 of the time that is judged, from the first fifth's middle to the last one's.
        assert!((0.79..0.81).contains(&(leaking as f64 / 3000.0 / sound.judged_seconds)), "{leaking}");
        assert!(leaking > 1 << 20, "the default bound finds three kilobytes a second in a quarter of an hour");
        // A step that leaks at every visit is found.
        let mut visits = heated(0.0);
        visits.iter_mut().for_each(|second| second.resident_bytes = Some(100_000 * (second.seconds as u64 / 20)));
        assert!(growth(&visits).unwrap().resident_bytes.unwrap() > 2 << 20);
    }

    #[test]
    fn a_run_that_is_new_all_the_time_is_not_judged() {
        let mut each = seconds(|_| 1);
        each.iter_mut().for_each(|second| second.rung = second.seconds as usize / 12);
        assert_eq!(growth(&each), None);
    }

    #[test]
    #[cfg(target_os = "linux")]
    fn this_process_has_memory() {
        assert!(resident().is_some_and(|bytes| bytes > 1 << 20));
    }
}
