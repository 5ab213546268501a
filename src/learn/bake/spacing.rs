//! Evenly spaced points on the visible parts of the sheets, of darts that are thrown at them.

use crate::bake::outfit::Outfit;
use crate::bake::surface::{Sheet, Site};
use effigy_core::random::{Random, hash};
use effigy_math::spacing::{Dart, choose};
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
struct DartHit {
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
    fn throw(&self, budget: f64) -> Vec<DartHit> {
        let weights: f64 = self.triangles.iter().map(|triangle| triangle.weight).sum();
        let scale = budget / weights.max(1e-12);
        self.triangles
            .par_iter()
            .enumerate()
            .flat_map_iter(|(i, triangle)| self.throw_at(triangle, i as u64, scale))
            .collect()
    }

    /// Darts at one triangle, `scale` times its weight. `stream`: of the random numbers.
    fn throw_at(&self, triangle: &SheetTriangle, stream: u64, scale: f64) -> Vec<DartHit> {
        let mut random = Random::new(self.seed, stream);
        let number = (triangle.weight * scale + random.uniform()).floor() as usize;
        (0..number)
            .filter_map(|_| self.throw_one(triangle, &mut random))
            .collect()
    }

    /// One dart; `None` if the place isn't visible, or, by chance, deserves fewer points.
    fn throw_one(&self, at: &SheetTriangle, random: &mut Random) -> Option<DartHit> {
        let sheet = &self.sheets[at.sheet];
        let u = random.uniform().sqrt();
        let v = random.uniform();
        let barycentric = [1.0 - u, u * (1.0 - v), u * v];
        let site = sheet.site(at.triangle, barycentric);
        let density = self.outfit.density(&site);
        let hits = random.uniform() * at.peak < density && self.outfit.shows(&site);
        hits.then_some(DartHit {
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
