//! Evenly spaced points on the visible parts of the sheets, by dart throwing with a radius that is
//! fitted to the number of points asked for.

use crate::bake::outfit::Outfit;
use crate::bake::surface::{Sheet, Site};
use effigy_core::random::{Random, hash};
use glam::{DVec3, IVec3};
use rayon::prelude::*;

/// Darts for each point wanted.
const DARTS: f64 = 9.0;
/// Darts of the first throw, which finds out how much of the sheets is hidden.
const TRIAL_DARTS: f64 = 4000.0;
const CENTER: [f64; 3] = [1.0 / 3.0; 3];

/// A chosen point.
#[derive(Clone, Debug)]
pub struct Dot {
    /// The point with all that its Gaussian inherits.
    pub site: Site,
    /// The index of the sheet that the site is on.
    pub sheet: usize,
    /// The index of the triangle in that sheet.
    pub triangle: usize,
    /// The place in that triangle.
    pub barycentric: [f64; 3],
    /// No other point of its layer is nearer, metres.
    pub radius: f64,
}

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
pub struct Chosen {
    /// Indices into the darts.
    pub indices: Vec<usize>,
    /// The radius at density 1, metres.
    pub base_radius: f64,
}

/// A triangle of one of the sheets.
#[derive(Clone, Copy)]
struct SheetTriangle {
    sheet: usize,
    triangle: usize,
    /// At least the density of any point in it.
    peak: f64,
    /// Its area times the peak density.
    weight: f64,
}

/// A dart, and where it hit.
#[derive(Clone, Copy)]
struct Hit {
    sheet: usize,
    triangle: usize,
    barycentric: [f64; 3],
    dart: Dart,
}

/// `count` points on the sheets, fewer only if too little shows. Points and their order depend on
/// the seed alone.
pub fn scatter(sheets: &[Sheet], outfit: &Outfit, count: usize, seed: u64) -> Vec<Dot> {
    let thrower = Thrower::new(sheets, outfit, seed);
    let visible = thrower.throw(TRIAL_DARTS).len().max(1) as f64 / TRIAL_DARTS;
    let mut hits = thrower.throw(DARTS * count as f64 / visible);
    shuffle(&mut hits, seed);
    let darts: Vec<Dart> = hits.iter().map(|hit| hit.dart).collect();
    let chosen = choose(&darts, count);
    let dot = |&i: &usize| {
        let hit = &hits[i];
        Dot {
            site: sheets[hit.sheet].site(hit.triangle, hit.barycentric),
            sheet: hit.sheet,
            triangle: hit.triangle,
            barycentric: hit.barycentric,
            radius: chosen.base_radius / hit.dart.density.sqrt(),
        }
    };
    chosen.indices.par_iter().map(dot).collect()
}

/// Throws darts at sheets.
struct Thrower<'a> {
    sheets: &'a [Sheet],
    outfit: &'a Outfit,
    seed: u64,
    triangles: Vec<SheetTriangle>,
}

impl<'a> Thrower<'a> {
    fn new(sheets: &'a [Sheet], outfit: &'a Outfit, seed: u64) -> Self {
        let all: Vec<(usize, usize)> = sheets
            .iter()
            .enumerate()
            .flat_map(|(s, sheet)| (0..sheet.triangles.len()).map(move |t| (s, t)))
            .collect();
        let measure = |&(sheet, triangle): &(usize, usize)| {
            let density = |b: [f64; 3]| outfit.density(&sheets[sheet].site(triangle, b));
            let corners = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(density);
            // Densities rise smoothly, so four of them with a margin bound all.
            let peak = 1.1 * corners.into_iter().fold(density(CENTER), f64::max);
            SheetTriangle {
                sheet,
                triangle,
                peak,
                weight: sheets[sheet].area(triangle) * peak,
            }
        };
        Self {
            sheets,
            outfit,
            seed,
            triangles: all.par_iter().map(measure).collect(),
        }
    }

    /// About `budget` darts, without those that hit nothing visible.
    fn throw(&self, budget: f64) -> Vec<Hit> {
        let weights: f64 = self.triangles.iter().map(|triangle| triangle.weight).sum();
        let scale = budget / weights.max(1e-12);
        self.triangles
            .par_iter()
            .enumerate()
            .flat_map_iter(|(i, triangle)| self.throw_at(triangle, i as u64, scale))
            .collect()
    }

    /// Darts at one triangle, `scale` times its weight. `stream`: of the random numbers.
    fn throw_at(&self, triangle: &SheetTriangle, stream: u64, scale: f64) -> Vec<Hit> {
        let mut random = Random::new(self.seed, stream);
        let number = (triangle.weight * scale + random.uniform()).floor() as usize;
        (0..number)
            .filter_map(|_| self.throw_one(triangle, &mut random))
            .collect()
    }

    /// One dart; `None` if the place isn't visible, or, by chance, deserves fewer points.
    fn throw_one(&self, at: &SheetTriangle, random: &mut Random) -> Option<Hit> {
        let sheet = &self.sheets[at.sheet];
        let u = random.uniform().sqrt();
        let v = random.uniform();
        let barycentric = [1.0 - u, u * (1.0 - v), u * v];
        let site = sheet.site(at.triangle, barycentric);
        let density = self.outfit.density(&site);
        let hits = random.uniform() * at.peak < density && self.outfit.shows(&site);
        hits.then_some(Hit {
            sheet: at.sheet,
            triangle: at.triangle,
            barycentric,
            dart: Dart {
                position: site.position,
                density,
                layer: sheet.material as u8,
            },
        })
    }
}

fn shuffle<T>(list: &mut [T], seed: u64) {
    for i in (1..list.len()).rev() {
        list.swap(i, (hash(seed ^ hash(i as u64)) % (i as u64 + 1)) as usize);
    }
}

/// Chooses `count` of the darts, each further than its radius from every earlier one of its layer.
/// The radius is fitted so that about as many are left; missing ones are taken from those rejected.
pub fn choose(darts: &[Dart], count: usize) -> Chosen {
    const ROUNDS: usize = 24;
    let positions = || darts.iter().map(|dart| dart.position);
    let low = positions().fold(DVec3::INFINITY, DVec3::min);
    let high = positions().fold(DVec3::NEG_INFINITY, DVec3::max);
    let mut radius = 0.3 * (high - low).length() / (count.max(1) as f64).sqrt();
    let mut best = Chosen {
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
                best = Chosen {
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
