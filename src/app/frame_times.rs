//! How long the last frames took: for the panel's numbers and graph.

use std::collections::VecDeque;

/// Frames that the graph shows.
const HISTORY: usize = 120;
/// The panel's numbers are means over this many seconds, so that they stand still long enough to
/// be read.
const WINDOW: f64 = 0.5;

/// Times between the starts of successive frames, seconds.
#[derive(Clone, Debug, Default)]
pub struct FrameTimes {
    last: Option<f64>,
    history: VecDeque<f32>,
    window: MeanWindow,
    mean: Option<f64>,
}

/// The frames that the next mean is taken over.
#[derive(Clone, Copy, Debug, Default)]
struct MeanWindow {
    /// On the viewer's clock, seconds.
    start: f64,
    frames: u32,
}

impl FrameTimes {
    /// A frame starts at this time, seconds. `continuing` is false for the first one after a
    /// pause, which says nothing about speed.
    pub fn frame(&mut self, now: f64, continuing: bool) {
        match self.last.filter(|_| continuing) {
            None => self.start_window(now),
            Some(last) => {
                if self.history.len() == HISTORY {
                    self.history.pop_front();
                }
                self.history.push_back((now - last) as f32);
                self.window.frames += 1;
                let seconds = now - self.window.start;
                if seconds >= WINDOW || self.mean.is_none() {
                    self.mean = Some(seconds / f64::from(self.window.frames));
                    self.start_window(now);
                }
            }
        }
        self.last = Some(now);
    }

    fn start_window(&mut self, now: f64) {
        self.window = MeanWindow {
            start: now,
            frames: 0,
        };
    }

    /// Milliseconds from one frame to the next, a mean over half a second. None before the second
    /// frame.
    pub fn mean_ms(&self) -> Option<f64> {
        self.mean.map(|seconds| 1e3 * seconds)
    }

    /// The last frames' times, oldest first, milliseconds.
    pub fn history_ms(&self) -> impl DoubleEndedIterator<Item = f32> + ExactSizeIterator {
        self.history.iter().map(|seconds| 1e3 * seconds)
    }
}

/// Median and 95th percentile of some times, milliseconds. None if there are no times.
pub fn median_and_p95(ms: &mut [f64]) -> Option<[f64; 2]> {
    ms.sort_by(f64::total_cmp);
    let last = ms.len().checked_sub(1)?;
    Some([0.5, 0.95].map(|share| ms[(share * last as f64).round() as usize]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pause_does_not_count_as_a_slow_frame() {
        let mut times = FrameTimes::default();
        times.frame(1.0, true);
        assert_eq!(times.mean_ms(), None);
        for frame in 1..=100 {
            times.frame(1.0 + 0.01 * f64::from(frame), true);
        }
        times.frame(900.0, false);
        for frame in 1..=100 {
            times.frame(900.0 + 0.01 * f64::from(frame), true);
        }
        let mean = times.mean_ms().unwrap_or(0.0);
        assert!((mean - 10.0).abs() < 0.01, "{mean} ms instead of 10");
        assert_eq!(times.history_ms().len(), HISTORY);
        assert!(times.history_ms().all(|ms| (ms - 10.0).abs() < 0.01));
    }

    #[test]
    fn median_and_p95_are_percentiles() {
        let mut ms: Vec<f64> = (0..=100).rev().map(f64::from).collect();
        assert_eq!(median_and_p95(&mut ms), Some([50.0, 95.0]));
        assert_eq!(median_and_p95(&mut []), None);
    }
}
