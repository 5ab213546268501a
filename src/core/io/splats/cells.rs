//! Where splats' positions are stored: 16-bit coordinates in one box, or, where that would be too
//! coarse, in a box that is displaced to each of several places.

use super::Splats;
use crate::{
    avatar::{Bounds, limits},
    each,
};
use glam::DVec3;
use half::f16;

/// Steps of the coordinates that a splat's width has at least in one box for all.
const STEPS_ENOUGH: f64 = 32.0;
/// Steps that it has where one box has too few.
const STEPS: f64 = 128.0;
/// Share of the splats that may be thinner than the width that steps are chosen for.
const THINNER: f64 = 0.25;
/// Up to this many sides of a cell away from the middle, displacements are exact in f16.
const EXACT: f64 = 2048.0;
/// Share of the splats that may be further out. They are placed to 1/4096 of their distance.
const FURTHER: f64 = 0.01;
/// The smallest side of a cell, metres: f16 holds a sixteenth of it.
const SMALLEST: f64 = 1.0 / (1 << 20) as f64;
/// How much larger the box is than a cell: rounding to f32 leaves nothing outside.
const LARGER: f64 = 1.0 + 1.0 / 256.0;

/// The boxes of a scene.
pub struct Cells {
    /// What coordinates are relative to, before they are displaced.
    bounds: Bounds,
    /// The middle of the box, metres.
    middle: DVec3,
    /// Side of a cell, a power of two, metres. None: nothing is displaced.
    side: Option<f64>,
}

/// The position of a splat as it is stored.
pub struct CellPosition {
    /// Displacement of the box, metres.
    pub offset: [f16; 3],
    /// Coordinates in the box.
    pub code: [u16; 3],
}

impl CellPosition {
    /// The displacement as numbers that rise with it.
    pub fn cell(&self) -> [u16; 3] {
        self.offset.map(|offset| {
            let bits = offset.to_bits();
            if bits >> 15 == 1 {
                !bits
            } else {
                bits | 1 << 15
            }
        })
    }
}

impl Cells {
    /// The boxes of splats, of which there is at least one.
    pub fn new(splats: &Splats) -> Self {
        let all = around(&splats.position);
        let width = width(splats);
        let one = Self {
            bounds: all,
            middle: DVec3::ZERO,
            side: None,
        };
        if STEPS_ENOUGH * all.step().max_element() <= width {
            return one;
        }
        let [min, max] = [all.min, all.max].map(|corner| DVec3::from(corner.map(f64::from)));
        let median = [0, 1, 2].map(|axis| nth(splats.position.iter().map(|p| p[axis].into()), 0.5));
        // A file may hold neither displacements nor corners beyond the largest length.
        let length = DVec3::splat(limits::LENGTH);
        let median = DVec3::from(median).clamp(max - length, min + length);
        let distance = |p: &[f32; 3]| (point(*p) - median).abs().max_element();
        let furthest = nth(splats.position.iter().map(distance), 1.0 - FURTHER);
        let fine = (65535.0 * width / STEPS).log2().floor();
        let wide = (furthest / EXACT).log2().ceil();
        let mut side = fine.max(wide).exp2().max(SMALLEST);
        while side < (max - min).max_element() {
            let half = DVec3::splat(0.5 * LARGER * side);
            let middle = median.clamp(half - length, length - half);
            let cells = Self {
                bounds: Bounds {
                    min: (middle - half).as_vec3().to_array(),
                    max: (middle + half).as_vec3().to_array(),
                },
                middle,
                side: Some(side),
            };
            let mut occupied = each::map(splats.len(), |k| cells.place(splats.position[k]).cell());
            occupied.sort_unstable();
            occupied.dedup();
            if occupied.len() <= limits::NODES {
                return cells;
            }
            side *= 2.0;
        }
        one
    }

    /// The box that is displaced.
    pub fn bounds(&self) -> Bounds {
        self.bounds
    }

    /// Where a splat at a position is stored.
    pub fn place(&self, position: [f32; 3]) -> CellPosition {
        let position = point(position);
        let offset = match self.side {
            None => [f16::ZERO; 3],
            Some(side) => (position - self.middle).to_array().map(|distance| {
                let cell = (distance / side).round();
                // Further out f16 can't hold multiples of the side: the nearest number is nearer.
                let offset = if cell.abs() <= EXACT {
                    cell * side
                } else {
                    distance
                };
                // A sum with 0 is never −0.
                f16::from_f64(offset.clamp(-limits::LENGTH, limits::LENGTH) + 0.0)
            }),
        };
        CellPosition {
            offset,
            code: self
                .bounds
                .encode(position - DVec3::from(offset.map(f64::from))),
        }
    }
}

/// The box around all positions; there is at least one.
fn around(positions: &[[f32; 3]]) -> Bounds {
    let mut bounds = Bounds {
        min: [f32::INFINITY; 3],
        max: [f32::NEG_INFINITY; 3],
    };
    for position in positions {
        for (axis, &value) in position.iter().enumerate() {
            bounds.min[axis] = bounds.min[axis].min(value);
            bounds.max[axis] = bounds.max[axis].max(value);
        }
    }
    bounds
}

/// The width that all but the thinnest splats have: the middle one of their deviations, which is
/// how far a disc reaches and how thin a needle is.
fn width(splats: &Splats) -> f64 {
    let middle = |scale: &[f32; 3]| {
        let [a, b, c] = *scale;
        f64::from(a.max(b).min(c).max(a.min(b)))
    };
    nth(splats.log_scale.iter().map(middle), THINNER).exp()
}

/// The number below which a share of some numbers lies; there is at least one.
fn nth(numbers: impl Iterator<Item = f64>, share: f64) -> f64 {
    let mut numbers: Vec<f64> = numbers.collect();
    let at = (share * (numbers.len() - 1) as f64).round() as usize;
    *numbers.select_nth_unstable_by(at, f64::total_cmp).1
}

fn point(position: [f32; 3]) -> DVec3 {
    DVec3::from(position.map(f64::from))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        avatar::{Avatar, Filter},
        io::splats::Up,
        random::Random,
    };

    /// Round splats of a width at these places.
    fn splats(position: Vec<[f32; 3]>, width: f64) -> Splats {
        let count = position.len();
        Splats {
            rotation: vec![[1.0, 0.0, 0.0, 0.0]; count],
            log_scale: vec![[width.ln() as f32; 3]; count],
            opacity: vec![2.0; count],
            color: vec![[0.5; 3]; count],
            degree: 0,
            harmonics: vec![],
            up: Up::Y,
            filter: Filter::DEFAULT,
            position,
        }
    }

    /// So many places on a sphere.
    fn sphere(count: usize, radius: f64, middle: DVec3) -> Vec<[f32; 3]> {
        let random = &mut Random::new(7, count as u64);
        let mut place = || (middle + radius * random.direction()).as_vec3().to_array();
        (0..count).map(|_| place()).collect()
    }

    /// Where each splat of the file lies in the avatar, found by its colour, and where it should.
    fn errors(mut splats: Splats) -> (Avatar, Vec<f64>) {
        // f16 tells so many apart.
        let color = |k: usize| [k % 100, k / 100 % 100, k / 10_000].map(|c| c as f32 / 100.0);
        splats.color = (0..splats.len()).map(color).collect();
        let avatar = splats.to_avatar("far").expect("splats that fit");
        assert_eq!(avatar.check(), Ok(()));
        let bytes = avatar.to_bytes().expect("an avatar");
        assert_eq!(Avatar::from_bytes(&bytes), Ok(avatar.clone()));
        let channel = |c: f16, unit: f64| ((c.to_f64() - 0.5) / unit * 100.0).round() as usize;
        let unit = crate::avatar::ShCoefficients::CONSTANT;
        let error = |k: usize| {
            let [a, b, c] = avatar.gaussians.color[k].map(|c| channel(c, unit));
            let own = splats.position[a + 100 * b + 10_000 * c];
            avatar.placed(k).distance(point(own))
        };
        let errors = (0..splats.len()).map(error).collect();
        (avatar, errors)
    }

    fn largest(errors: &[f64]) -> f64 {
        errors.iter().copied().fold(0.0, f64::max)
    }

    #[test]
    fn far_splats_cost_near_ones_no_steps() {
        let far = |radius| sphere(12, radius, DVec3::ZERO);
        let one_side = |radius| sphere(12, 0.1 * radius, DVec3::new(radius, 0.0, 0.0));
        for scale in [1e3, 1.0, 1e-3] {
            for floaters in [far(400.0), one_side(300.0)] {
                let mut position = sphere(4000, 0.5, DVec3::ZERO);
                position.extend(floaters);
                let scaled = |p: &[f32; 3]| p.map(|x| (f64::from(x) * scale) as f32);
                let position: Vec<_> = position.iter().map(scaled).collect();
                if position.iter().flatten().any(|x| x.abs() > 1e4) {
                    continue;
                }
                let (avatar, errors) = errors(splats(position, 0.008 * scale));
                assert!((2..=30).contains(&avatar.nodes.len()));
                assert!(largest(&errors) <= 0.008 * scale / STEPS, "{scale}");
            }
        }
    }

    #[test]
    fn a_room_under_a_sky_and_a_scene_off_centre_are_exact() {
        let mut position = sphere(3000, 5.0, DVec3::ZERO);
        position.extend(sphere(2000, 1000.0, DVec3::ZERO));
        let (avatar, found) = errors(splats(position, 0.01));
        assert!(avatar.nodes.len() > 100 && largest(&found) <= 0.01 / STEPS);
        let off = DVec3::new(1000.0, -40.0, 2000.0);
        let mut position = sphere(2000, 0.5, off);
        position.extend(sphere(9, 300.0, off));
        let (_, found) = errors(splats(position, 0.008));
        assert!(largest(&found) <= 0.008 / STEPS + 1e-4);
    }

    #[test]
    fn the_ends_of_what_a_file_may_hold_are_reached() {
        let end = limits::LENGTH as f32;
        let mut position = sphere(3000, 1.0, DVec3::splat(9_998.0));
        position.extend([[end; 3], [-end; 3], [0.0; 3], [end, -end, 17.0]]);
        let (_, found) = errors(splats(position, 0.01));
        // The few furthest are placed to a share of their distance.
        let furthest = 2.0 * limits::LENGTH * 3f64.sqrt();
        assert!(largest(&found) <= furthest / 2048.0);
        let mut sorted = found;
        sorted.sort_by(f64::total_cmp);
        assert!(sorted[2998] <= 0.01 / 16.0, "{}", sorted[2998]);
    }

    #[test]
    fn a_distance_that_no_step_fits_is_kept_to_a_share() {
        // A subject of a millimetre, and dust half a kilometre away.
        let mut position = sphere(4000, 5e-4, DVec3::ZERO);
        position.extend(sphere(12, 500.0, DVec3::ZERO));
        let (_, found) = errors(splats(position, 8e-6));
        let mut sorted = found;
        sorted.sort_by(f64::total_cmp);
        assert!(sorted[3999] <= 8e-6 / STEPS, "{}", sorted[3999]);
        assert!(sorted[4011] <= 500.0 / 2048.0, "{}", sorted[4011]);
    }

    #[test]
    fn one_box_stays_where_it_is_fine_enough() {
        for position in [
            vec![[1.0, 2.0, 3.0]],
            vec![[1.0, 2.0, 3.0]; 2],
            sphere(900, 2.0, DVec3::Y),
        ] {
            let (avatar, found) = errors(splats(position, 0.01));
            assert!(avatar.nodes.len() == 1 && largest(&found) <= 1e-4);
            assert_eq!(avatar.nodes, crate::avatar::Nodes::still());
        }
    }

    #[test]
    fn points_without_a_size_are_kept_too() {
        let mut position = sphere(5000, 1.0, DVec3::ZERO);
        position.push([300.0, 0.0, 0.0]);
        let points = Splats {
            log_scale: vec![[f32::NEG_INFINITY; 3]; 5001],
            ..splats(position, 1.0)
        };
        let (_, found) = errors(points);
        let near = found.iter().filter(|&&error| error <= 1e-6).count();
        assert!(near >= 5000 && largest(&found) <= 300.0 / 2048.0);
        // Nearly all in one point: no length to go by.
        let mut position = vec![[0.5; 3]; 900];
        position.push([7000.0, 1.0, 0.0]);
        let points = Splats {
            log_scale: vec![[f32::NEG_INFINITY; 3]; 901],
            ..splats(position, 1.0)
        };
        let (_, found) = errors(points);
        let near = found.iter().filter(|&&error| error <= 1e-6).count();
        assert!(near >= 900 && largest(&found) <= 4.0);
    }
}
