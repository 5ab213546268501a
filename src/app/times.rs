//! How long the last frames took: for the overlay's numbers and graph.

use std::collections::VecDeque;

/// Frames that the graph shows.
const KEPT: usize = 120;
/// The numbers are means over about this long, so that they can be read, seconds.
const WINDOW: f64 = 0.5;

/// Times between the starts of successive frames, seconds.
#[derive(Clone, Debug, Default)]
pub struct FrameTimes {
    last: Option<f64>,
    seconds: VecDeque<f32>,
    /// Start of the current window, and frames in it.
    window: (f64, u32),
    mean: Option<f64>,
}

impl FrameTimes {
    /// A frame starts at this time of the clock. `continuing` is false for the first after a rest, which says nothing about speed.
    pub fn frame(&mut self, clock: f64, continuing: bool) {
        match self.last.filter(|_| continuing) {
            None => self.window = (clock, 0),
            Some(last) => {
                if self.seconds.len() == KEPT {
                    self.seconds.pop_front();
                }
                self.seconds.push_back((clock - last) as f32);
                self.window.1 += 1;
                let (start, frames) = self.window;
                if clock - start >= WINDOW || self.mean.is_none() {
                    self.mean = Some((clock - start) / f64::from(frames));
                    self.window = (clock, 0);
                }
            }
        }
        self.last = Some(clock);
    }

    /// Milliseconds from one frame to the next, a mean over half a second; None before the second frame.
    pub fn mean_ms(&self) -> Option<f64> {
        self.mean.map(|seconds| 1e3 * seconds)
    }

    /// The last frames' times, oldest first, milliseconds.
    pub fn history_ms(&self) -> impl DoubleEndedIterator<Item = f32> + ExactSizeIterator {
        self.seconds.iter().map(|seconds| 1e3 * seconds)
    }
}

/// Median and 95th percentile of some times, ms. None of none.
pub fn summary(ms: &mut [f64]) -> Option<[f64; 2]> {
    ms.sort_by(f64::total_cmp);
    let last = ms.len().checked_sub(1)?;
    Some([0.5, 0.95].map(|part| ms[(part * last as f64).round() as usize]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rest_does_not_count_as_a_slow_frame() {
        let mut times = FrameTimes::default();
        times.frame(1.0, true);
        assert_eq!(times.mean_ms(), None);
        (1..=100).for_each(|i| times.frame(1.0 + 0.01 * f64::from(i), true));
        times.frame(900.0, false);
        (1..=100).for_each(|i| times.frame(900.0 + 0.01 * f64::from(i), true));
        let mean = times.mean_ms().unwrap_or(0.0);
        assert!((mean - 10.0).abs() < 0.01, "{mean} ms instead of 10");
        assert_eq!(times.history_ms().len(), KEPT);
        assert!(times.history_ms().all(|ms| (ms - 10.0).abs() < 0.01));
    }

    #[test]
    fn a_summary_is_the_median_and_the_95th_percentile() {
        let mut ms: Vec<f64> = (0..=100).rev().map(f64::from).collect();
        assert_eq!(summary(&mut ms), Some([50.0, 95.0]));
        assert_eq!(summary(&mut []), None);
    }
}
