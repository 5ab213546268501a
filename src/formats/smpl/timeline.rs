//! Frames of a person who was not seen in each.

use effigy_core::io::file::FormatError;

/// Frames without the person that are filled in; longer absences end the motion.
const MAX_GAP: u64 = 15;

/// A frame of the motion, from those in the file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slot {
    pub before: usize,
    pub after: usize,
    /// From `before`, 0, to `after`, 1.
    pub share: f64,
}

/// The frames of the longest time that a person was seen.
#[derive(Debug, PartialEq)]
pub struct Timeline {
    pub slots: Vec<Slot>,
    /// Frames that were filled in.
    pub filled: usize,
    /// Frames of the file that are left out.
    pub left_out: usize,
}

/// Puts frames where their numbers say. `numbers`: rising.
pub fn timeline(numbers: &[f32], name: &str) -> Result<Timeline, FormatError> {
    let mut frames = Vec::with_capacity(numbers.len());
    for &number in numbers {
        let rising = frames
            .last()
            .is_none_or(|&last| f64::from(number) > last as f64);
        if number < 0.0 || number.fract() != 0.0 || !rising {
            return Err(FormatError::metadata(
                name,
                number,
                "numbers of frames that rise",
            ));
        }
        frames.push(number as u64);
    }
    let mut longest = 0..0;
    let mut start = 0;
    for end in 1..=frames.len() {
        let ends = frames
            .get(end)
            .is_none_or(|&f| f - frames[end - 1] > MAX_GAP);
        if ends {
            if end - start > longest.len() {
                longest = start..end;
            }
            start = end;
        }
    }
    let left_out = frames.len() - longest.len();
    let mut slots = Vec::new();
    for at in longest.clone() {
        slots.push(Slot {
            before: at,
            after: at,
            share: 0.0,
        });
        let next = frames.get(at + 1).filter(|_| at + 1 < longest.end);
        let missing = next.map_or(0, |next| next - frames[at] - 1);
        for k in 1..=missing {
            slots.push(Slot {
                before: at,
                after: at + 1,
                share: k as f64 / (missing + 1) as f64,
            });
        }
    }
    let filled = slots.len() - longest.len();
    // Memory follows from the file.
    if filled > longest.len() {
        return Err(FormatError::metadata(
            name,
            format!("{} frames in a time of {}", longest.len(), slots.len()),
            "a person who is seen in half of them",
        ));
    }
    Ok(Timeline {
        slots,
        filled,
        left_out,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_absences_are_filled_and_long_ones_end_the_motion() {
        let found = timeline(&[3.0, 4.0, 6.0, 100.0], "frame_ids").expect("a timeline");
        let shares: Vec<f64> = found.slots.iter().map(|slot| slot.share).collect();
        assert_eq!(shares, [0.0, 0.0, 0.5, 0.0]);
        assert_eq!((found.filled, found.left_out), (1, 1));
        for odd in [&[2.0, 1.0][..], &[0.5], &[-1.0], &[0.0, 10.0]] {
            assert!(timeline(odd, "frame_ids").is_err(), "{odd:?}");
        }
        let far = [0.0, 1e30];
        assert!(timeline(&far, "frame_ids").is_ok_and(|line| line.slots.len() == 1));
    }
}
