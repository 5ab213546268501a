//! The emblem on the shirt's chest: the word EFFIGY under three overlapping Gaussians.
//!
//! Points are metres to the avatar's left and up from the emblem's centre.

use effigy_math::noise::smoothstep;
use glam::DVec2;

const WORD: &str = "EFFIGY";
/// Height of a letter, metres.
const LETTER_HEIGHT: f64 = 0.026;
/// Width of a letter, as a share of its height.
const LETTER_WIDTH: f64 = 0.62;
/// From one letter to the next, metres.
const ADVANCE: f64 = 0.0235;
/// Half of a stroke's width, metres.
const STROKE: f64 = 0.0021;
/// Half of the width over which a stroke's edge fades, metres.
const STROKE_EDGE: f64 = 0.0004;
/// The word's lower edge, metres.
const BASELINE: f64 = -0.045;

/// A letter's strokes as polylines, in a box of width [`LETTER_WIDTH`] and height 1.
fn strokes(letter: char) -> &'static [&'static [(f64, f64)]] {
    match letter {
        'E' => &[
            &[(0.62, 0.0), (0.0, 0.0), (0.0, 1.0), (0.62, 1.0)],
            &[(0.0, 0.52), (0.5, 0.52)],
        ],
        'F' => &[
            &[(0.0, 0.0), (0.0, 1.0), (0.62, 1.0)],
            &[(0.0, 0.52), (0.5, 0.52)],
        ],
        'I' => &[&[(0.31, 0.0), (0.31, 1.0)]],
        'G' => &[&[
            (0.62, 0.80),
            (0.52, 0.95),
            (0.34, 1.0),
            (0.14, 0.93),
            (0.02, 0.72),
            (0.0, 0.5),
            (0.02, 0.28),
            (0.14, 0.07),
            (0.34, 0.0),
            (0.54, 0.06),
            (0.62, 0.22),
            (0.62, 0.46),
            (0.36, 0.46),
        ]],
        'Y' => &[
            &[(0.0, 1.0), (0.31, 0.5), (0.31, 0.0)],
            &[(0.62, 1.0), (0.31, 0.5)],
        ],
        _ => &[],
    }
}

/// How near to the emblem a point is: 1 on it, 0 from 2 cm outside on.
pub fn nearness(p: DVec2) -> f64 {
    const CENTER: DVec2 = DVec2::new(0.0, -0.002);
    const HALF_SIZE: DVec2 = DVec2::new(0.075, 0.048);
    let outside = (p - CENTER).abs() - HALF_SIZE;
    smoothstep(0.02, 0.0, outside.max(DVec2::ZERO).length())
}

fn distance_to_segment(p: DVec2, a: DVec2, b: DVec2) -> f64 {
    let t = ((p - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
    p.distance(a.lerp(b, t))
}

/// How much ink of the word is at a point, 0 to 1. The word reads from the avatar's right.
pub fn word_ink(p: DVec2) -> f64 {
    let width = ADVANCE * (WORD.len() as f64 - 1.0) + LETTER_WIDTH * LETTER_HEIGHT;
    let left = -0.5 * width;
    let mut distance = f64::INFINITY;
    for (i, letter) in WORD.chars().enumerate() {
        let origin = DVec2::new(left + ADVANCE * i as f64, BASELINE);
        for line in strokes(letter) {
            for ends in line.windows(2) {
                let [a, b] =
                    [ends[0], ends[1]].map(|(x, y)| origin + LETTER_HEIGHT * DVec2::new(x, y));
                distance = distance.min(distance_to_segment(p, a, b));
            }
        }
    }
    smoothstep(STROKE + STROKE_EDGE, STROKE - STROKE_EDGE, distance)
}

/// How much ink of each of the three Gaussians is at a point, 0 to 1, soft like a Gaussian.
pub fn gaussian_ink(p: DVec2) -> [f64; 3] {
    struct EmblemEllipse {
        center: DVec2,
        /// Radians, anticlockwise.
        turn: f64,
    }
    const ELLIPSES: [EmblemEllipse; 3] = [
        EmblemEllipse {
            center: DVec2::new(-0.014, 0.008),
            turn: 0.4,
        },
        EmblemEllipse {
            center: DVec2::new(0.014, 0.008),
            turn: -0.4,
        },
        EmblemEllipse {
            center: DVec2::new(0.0, 0.027),
            turn: 1.57,
        },
    ];
    /// Standard deviations along an ellipse's axes, metres.
    const SIGMA: DVec2 = DVec2::new(0.0125, 0.0085);
    ELLIPSES.map(|ellipse| {
        let d = DVec2::from_angle(-ellipse.turn).rotate(p - ellipse.center) / SIGMA;
        let squared = d.length_squared();
        (-0.5 * squared * 0.8).exp() * smoothstep(3.4, 2.9, squared)
    })
}
