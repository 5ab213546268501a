//! Evenly spaced points among many candidates, by dart throwing with a radius that is fitted to the
//! number of points asked for.

use effigy_core::random::hash;
use glam::{DVec3, IVec3};

/// A place that may be chosen.
#[derive(Clone, Copy, Debug)]
pub struct Dart {
    /// Metres.
    pub position: DVec3,
    /// Points per area, relative to the others.
    pub density: f64,
    /// Points of different layers may be as near as they like.
    pub layer: u8,
}

/// The places that were chosen.
pub struct ChosenDarts {
    /// Indices into the darts.
    pub indices: Vec<usize>,
    /// The radius at density 1, metres.
    pub base_radius: f64,
}

/// Chooses `count` of the darts, each further than its radius from every earlier one of its layer.
/// The radius is fitted so that about as many are left; missing ones are taken from those rejected.
pub fn choose(darts: &[Dart], count: usize) -> ChosenDarts {
    const ROUNDS: usize = 24;
    let positions = || darts.iter().map(|dart| dart.position);
    let low = positions().fold(DVec3::INFINITY, DVec3::min);
    let high = positions().fold(DVec3::NEG_INFINITY, DVec3::max);
    let mut radius = 0.3 * (high - low).length() / (count.max(1) as f64).sqrt();
    let mut best = ChosenDarts {
        indices: Vec::new(),
        base_radius: radius,
    };
    // A radius that leaves too many, and one that does not.
    let mut too_small = 0.0;
    let mut large_enough = f64::INFINITY;
    for _ in 0..ROUNDS {
        let indices = far_apart(darts, radius);
        let found = indices.len();
        if found <= count {
            if found > best.indices.len() {
                best = ChosenDarts {
                    indices,
                    base_radius: radius,
                };
            }
            large_enough = radius;
            if found as f64 >= 0.99 * count as f64 - 2.0 {
                break;
            }
        } else {
            too_small = radius;
        }
        // The number falls with the radius squared; else halve the interval.
        let guess = radius * (found as f64 / (0.995 * count as f64)).sqrt();
        radius = if guess > too_small && guess < large_enough {
            guess
        } else if large_enough.is_finite() {
            0.5 * (too_small + large_enough)
        } else {
            2.0 * radius
        };
    }
    if best.indices.len() < count {
        let mut taken = vec![false; darts.len()];
        for &i in &best.indices {
            taken[i] = true;
        }
        let missing = count - best.indices.len();
        let rejected = (0..darts.len()).filter(|&i| !taken[i]);
        best.indices.extend(rejected.take(missing));
    }
    best
}

/// The darts in their order, each left out if an earlier one of its layer is nearer than its
/// radius; `base` is the radius at density 1.
fn far_apart(darts: &[Dart], base: f64) -> Vec<usize> {
    let radius: Vec<f64> = darts
        .iter()
        .map(|dart| base / dart.density.sqrt())
        .collect();
    let cell = radius.iter().fold(1e-6, |m: f64, r| m.max(*r));
    let mut grid = HashGrid::new(darts.len(), cell);
    let mut chosen = Vec::new();
    for (i, dart) in darts.iter().enumerate() {
        let squared_radius = radius[i] * radius[i];
        let is_near = |other: usize| {
            darts[other].layer == dart.layer
                && darts[other].position.distance_squared(dart.position) < squared_radius
        };
        if !grid.any_near(dart, is_near) {
            grid.insert(dart, i);
            chosen.push(i);
        }
    }
    chosen
}

/// Darts by the cell that they are in: a hash table of linked lists.
struct HashGrid {
    /// Size of a cell, metres.
    cell: f64,
    /// The last dart of each bucket's list; as many as a power of two.
    head: Vec<u32>,
    /// The dart before each in its list.
    next: Vec<u32>,
}

impl HashGrid {
    const NONE: u32 = u32::MAX;

    fn new(darts: usize, cell: f64) -> Self {
        Self {
            cell,
            head: vec![Self::NONE; (darts * 2).next_power_of_two()],
            next: vec![Self::NONE; darts],
        }
    }

    fn cell_of(&self, dart: &Dart) -> IVec3 {
        (dart.position / self.cell).floor().as_ivec3()
    }

    fn bucket(&self, cell: IVec3, layer: u8) -> usize {
        let key = (cell.x as u64 & 0xF_FFFF)
            | (cell.y as u64 & 0xF_FFFF) << 20
            | (cell.z as u64 & 0xF_FFFF) << 40
            | u64::from(layer & 15) << 60;
        (hash(key) as usize) & (self.head.len() - 1)
    }

    fn insert(&mut self, dart: &Dart, index: usize) {
        let bucket = self.bucket(self.cell_of(dart), dart.layer);
        self.next[index] = self.head[bucket];
        self.head[bucket] = index as u32;
    }

    /// Whether a dart in the cells around another one's passes a test. Darts of other cells may be
    /// tested too.
    fn any_near(&self, dart: &Dart, test: impl Fn(usize) -> bool) -> bool {
        let home = self.cell_of(dart);
        for z in -1..=1 {
            for y in -1..=1 {
                for x in -1..=1 {
                    let bucket = self.bucket(home + IVec3::new(x, y, z), dart.layer);
                    let mut other = self.head[bucket];
                    while other != Self::NONE {
                        if test(other as usize) {
                            return true;
                        }
                        other = self.next[other as usize];
                    }
                }
            }
        }
        false
    }
}
