//! A point of the chest in; how much printing ink is there, out: the word EFFIGY under three Gaussians, one over another.

use glam::DVec2;

/// Height of a letter, metres.
const HEIGHT: f64 = 0.026;
const ADVANCE: f64 = 0.0235;
/// Half of a stroke's width.
const STROKE: f64 = 0.0021;
/// Where the word's lower edge is, below the print's centre.
const BASE: f64 = -0.045;

/// Strokes of a letter in a box of width 0.62 and height 1: polylines.
fn strokes(letter: char) -> &'static [&'static [(f64, f64)]] {
    match letter {
        'E' => &[&[(0.62, 0.0), (0.0, 0.0), (0.0, 1.0), (0.62, 1.0)], &[(0.0, 0.52), (0.5, 0.52)]],
        'F' => &[&[(0.0, 0.0), (0.0, 1.0), (0.62, 1.0)], &[(0.0, 0.52), (0.5, 0.52)]],
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
        'Y' => &[&[(0.0, 1.0), (0.31, 0.5), (0.31, 0.0)], &[(0.62, 1.0), (0.31, 0.5)]],
        _ => &[],
    }
}

/// How near to the print a point is: 1 on it, 0 a little way off.
pub fn nearness(p: DVec2) -> f64 {
    let off = (p - DVec2::new(0.0, -0.002)).abs() - DVec2::new(0.075, 0.048);
    super::math::step(0.02, 0.0, off.max(DVec2::ZERO).length())
}

fn to_segment(p: DVec2, a: DVec2, b: DVec2) -> f64 {
    let t = ((p - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
    p.distance(a.lerp(b, t))
}

/// Ink of the word, 0 to 1; `p` is metres to the avatar's left and up from the print's centre. The word reads from the avatar's right.
pub fn word(p: DVec2) -> f64 {
    const WORD: &str = "EFFIGY";
    let width = ADVANCE * (WORD.len() as f64 - 1.0) + 0.62 * HEIGHT;
    let start = -0.5 * width;
    let distance = WORD.chars().enumerate().flat_map(|(i, letter)| {
        let origin = DVec2::new(start + ADVANCE * i as f64, BASE);
        strokes(letter).iter().flat_map(move |line| line.windows(2)).map(move |ends| {
            let [a, b] = [ends[0], ends[1]].map(|(x, y)| origin + HEIGHT * DVec2::new(x, y));
            to_segment(p, a, b)
        })
    });
    super::math::step(STROKE + 0.0004, STROKE - 0.0004, distance.fold(f64::INFINITY, f64::min))
}

/// The emblem: ink of each of three ellipses, soft as Gaussians are.
pub fn emblem(p: DVec2) -> [f64; 3] {
    [(-0.014, 0.008, 0.4), (0.014, 0.008, -0.4), (0.0, 0.027, 1.57)].map(|(x, y, turn)| {
        let d = DVec2::from_angle(-turn).rotate(p - DVec2::new(x, y)) / DVec2::new(0.0125, 0.0085);
        (-0.5 * d.length_squared() * 0.8).exp() * super::math::step(3.4, 2.9, d.length_squared())
    })
}
