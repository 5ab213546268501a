//! Which moments of clips are shot.

use effigy_core::avatar::Clip;

/// A frame's clip and time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClipFrame {
    /// Index of the clip that it is from.
    pub clip: usize,
    /// Into the clip.
    pub seconds: f64,
    /// Held out, to be evaluated on.
    pub held: bool,
}

/// One in so many blocks of time is held out, the middle one.
const BLOCKS: usize = 5;

/// Which moments of some clips become frames: `count` of them, evenly spaced over all clips. Every fifth block of `block` seconds of each clip is held out.
pub fn plan_frames(clips: &[Clip], count: usize, block: f64) -> Vec<ClipFrame> {
    let whole: f64 = clips.iter().map(Clip::duration).sum();
    let step = (whole / count.max(1) as f64).max(1e-9);
    let mut shots = Vec::with_capacity(count);
    let mut begun = 0.0;
    for (index, clip) in clips.iter().enumerate() {
        let end = begun + clip.duration();
        while shots.len() < count && step * (shots.len() as f64 + 0.5) <= end {
            let seconds = step * (shots.len() as f64 + 0.5) - begun;
            let held = (seconds / block.max(1e-3)) as usize % BLOCKS == BLOCKS / 2;
            shots.push(ClipFrame {
                clip: index,
                seconds,
                held,
            });
        }
        begun = end;
    }
    shots
}
