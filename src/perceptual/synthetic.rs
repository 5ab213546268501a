//! Pictures of whole numbers that any program makes alike: stripes, blocks and noise.

use crate::planes::Planes;
use effigy_core::random::hash;

/// Noise at a pixel of a channel.
fn noise(at: [usize; 3], add: u64) -> u64 {
    let [x, y, c] = at.map(|n| n as u64);
    hash(x + 1000 * y + 1_000_000 * c + add)
}

fn planes(size: [usize; 2], level: impl Fn([usize; 3]) -> f32) -> Planes {
    let mut planes = Planes::black(size);
    for (i, number) in planes.data.iter_mut().enumerate() {
        let row = i / size[0];
        *number = level([i % size[0], row % size[1], row / size[1]]);
    }
    planes
}

/// One of two pictures that differ in everything but their kind. `size`: width and height, px.
pub fn picture(kind: u64, size: [usize; 2]) -> Planes {
    let wave = |t: usize| (t % 64).abs_diff(32) * 7;
    planes(size, |at| {
        let [x, y, c] = at;
        let level = if kind == 0 {
            wave(3 * x + 5 * y + 20 * c)
        } else {
            wave(4 * x + 3 * y + 33 * c + 7) / 2 + 64 * ((x / 8 + y / 8) % 2)
        };
        (level.min(223) as u64 + noise(at, 7_000_000 * kind) % 32) as f32 / 255.0
    })
}

/// A direction in which a picture may change, each number -1 to 1.
pub fn direction(size: [usize; 2]) -> Planes {
    planes(size, |at| {
        (noise(at, 99_000_000) % 255) as f32 / 127.0 - 1.0
    })
}
