//! Frames of a person who was not seen in each.

use effigy_core::io::file::FormatError;

/// Frames without the person that are filled in; longer absences end the motion.
const MAX_GAP: i64 = 15;

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
    /// Frames of the file.
    pub rows: usize,
}

/// A row of the file, and when the person was seen.
#[derive(Clone, Copy)]
struct SeenRow {
    row: usize,
    frame: i64,
}

/// Puts frames where their numbers say; of rows of one number the last. `numbers`: not falling.
pub fn timeline(numbers: &[f32], name: &str) -> Result<Timeline, FormatError> {
    let mut rows: Vec<SeenRow> = Vec::with_capacity(numbers.len());
    for (row, &number) in numbers.iter().enumerate() {
        if number.fract() != 0.0 {
            return Err(FormatError::metadata(
                name,
                number,
                "whole numbers of frames",
            ));
        }
        let frame = number as i64;
        match rows.last_mut() {
            Some(last) if last.frame == frame => last.row = row,
            Some(last) if last.frame > frame => {
                return Err(FormatError::metadata(
                    name,
                    format!("{frame} after {}", last.frame),
                    "numbers of frames that rise",
                ));
            }
            _ => rows.push(SeenRow { row, frame }),
        }
    }
    let mut longest = 0..0;
    let mut start = 0;
    for end in 1..=rows.len() {
        let ends = rows
            .get(end)
            .is_none_or(|next| next.frame.saturating_sub(rows[end - 1].frame) > MAX_GAP);
        if ends {
            if end - start > longest.len() {
                longest = start..end;
            }
            start = end;
        }
    }
    let left_out = numbers.len() - longest.len();
    let mut slots = Vec::new();
    for at in longest.clone() {
        let SeenRow { row, frame } = rows[at];
        slots.push(Slot {
            before: row,
            after: row,
            share: 0.0,
        });
        let next = rows.get(at + 1).filter(|_| at + 1 < longest.end);
        let Some(next) = next else { break };
        let missing = next.frame - frame - 1;
        for k in 1..=missing {
            slots.push(Slot {
                before: row,
                after: next.row,
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
        rows: numbers.len(),
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
        for odd in [&[2.0, 1.0][..], &[0.5], &[0.0, 10.0]] {
            assert!(timeline(odd, "frame_ids").is_err(), "{odd:?}");
        }
        let again = timeline(&[-2.0, -1.0, -1.0, 0.0], "frame_ids").expect("a timeline");
        let rows: Vec<usize> = again.slots.iter().map(|slot| slot.before).collect();
        assert_eq!(rows, [0, 2, 3]);
        let far = [0.0, 1e30];
        assert!(timeline(&far, "frame_ids").is_ok_and(|line| line.slots.len() == 1));
    }
}
