//! Sheets and a density in; evenly spaced points on what shows of them, out: dart throwing, whose radius is fitted to the number asked for.

use super::math::{Random, hash};
use super::outfit::Outfit;
use super::surface::{Sheet, Site};
use glam::DVec3;
use rayon::prelude::*;

/// Darts for each point wanted.
const DARTS: f64 = 9.0;

/// A point and how far from it no other of its layer is, metres.
#[derive(Clone, Debug)]
pub struct Dot {
    pub site: Site,
    /// Where on which sheet the site is.
    pub sheet: usize,
    pub triangle: usize,
    pub barycentric: [f64; 3],
    pub radius: f64,
}

/// A place where a point may come to lie.
#[derive(Clone, Copy, Debug)]
pub struct Dart {
    pub position: DVec3,
    /// Points a unit of area, against the others.
    pub density: f64,
    /// Points of different layers take no notice of each other.
    pub layer: u8,
}

/// `count` points on the sheets, fewer only where there is too little to see. Points and their order depend on the seed alone.
pub fn scatter(sheets: &[Sheet], outfit: &Outfit, count: usize, seed: u64) -> Vec<Dot> {
    const CENTER: [f64; 3] = [1.0 / 3.0; 3];
    let triangles: Vec<(usize, usize)> =
        sheets.iter().enumerate().flat_map(|(s, sheet)| (0..sheet.triangles.len()).map(move |t| (s, t))).collect();
    // The most that any of a triangle's points deserves: densities rise smoothly, so four of them with a margin say it.
    let peak = |(s, t): (usize, usize)| {
        let at = |b: [f64; 3]| outfit.density(&sheets[s].site(t, b));
        let corners = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(at);
        1.1 * corners.into_iter().fold(at(CENTER), f64::max)
    };
    let whole: Vec<f64> = triangles.par_iter().map(|&(s, t)| sheets[s].area(t) * peak((s, t))).collect();
    let seen = |place: u64, (s, t): (usize, usize), budget: f64| {
        let mut random = Random::new(seed, place);
        let most = peak((s, t));
        let number = (budget + random.uniform()).floor() as usize;
        (0..number).filter_map(|_| pick(&sheets[s], t, most, outfit, &mut random)).map(|(b, dart)| ((s, t, b), dart)).collect::<Vec<_>>()
    };
    let throw = |budget: f64| -> Vec<_> {
        let scale = budget / whole.iter().sum::<f64>().max(1e-12);
        let each = |(i, triangle): (usize, &(usize, usize))| seen(i as u64, *triangle, whole[i] * scale);
        triangles.par_iter().enumerate().flat_map_iter(each).collect()
    };
    // Much of the sheets is hidden: a first, thin throw says how much.
    let sight = throw(4000.0).len().max(1) as f64 / 4000.0;
    let mut darts = throw(DARTS * count as f64 / sight);
    shuffle(&mut darts, seed);
    let places: Vec<Dart> = darts.iter().map(|(_, dart)| *dart).collect();
    let (chosen, base) = choose(&places, count);
    let dot = |&i: &usize| {
        let ((s, t, b), dart) = darts[i];
        Dot { site: sheets[s].site(t, b), sheet: s, triangle: t, barycentric: b, radius: base / dart.density.sqrt() }
    };
    chosen.par_iter().map(dot).collect()
}

fn pick(sheet: &Sheet, triangle: usize, most: f64, outfit: &Outfit, random: &mut Random) -> Option<([f64; 3], Dart)> {
    let (u, v) = (random.uniform().sqrt(), random.uniform());
    let barycentric = [1.0 - u, u * (1.0 - v), u * v];
    let site = sheet.site(triangle, barycentric);
    let density = outfit.density(&site);
    let kept = random.uniform() * most < density && outfit.shows(&site);
    kept.then_some((barycentric, Dart { position: site.position, density, layer: sheet.material as u8 }))
}

fn shuffle<T>(list: &mut [T], seed: u64) {
    for i in (1..list.len()).rev() {
        list.swap(i, (hash(seed ^ hash(i as u64)) % (i as u64 + 1)) as usize);
    }
}

/// `count` of the darts, each further than its radius from every earlier one of its layer; the radius at density 1 is fitted, and
/// returned. Never more than fit, for the last ones kept fill the gaps; what is missing is taken from those turned away.
pub fn choose(darts: &[Dart], count: usize) -> (Vec<usize>, f64) {
    let spread = darts.iter().fold([DVec3::INFINITY, DVec3::NEG_INFINITY], |[a, b], d| [a.min(d.position), b.max(d.position)]);
    let mut radius = 0.3 * (spread[1] - spread[0]).length() / (count.max(1) as f64).sqrt();
    let (mut best, mut best_radius) = (Vec::new(), radius);
    let (mut low, mut high) = (0.0, f64::INFINITY);
    for _ in 0..24 {
        let chosen = apart(darts, radius);
        let found = chosen.len();
        if found <= count {
            if found > best.len() {
                (best, best_radius) = (chosen, radius);
            }
            high = radius;
            if found as f64 >= 0.99 * count as f64 - 2.0 {
                break;
            }
        } else {
            low = radius;
        }
        let guess = radius * (found as f64 / (0.995 * count as f64)).sqrt();
        radius = if guess > low && guess < high {
            guess
        } else if high.is_finite() {
            0.5 * (low + high)
        } else {
            2.0 * radius
        };
    }
    if best.len() < count {
        let mut taken = vec![false; darts.len()];
        best.iter().for_each(|&i| taken[i] = true);
        let missing = count - best.len();
        best.extend((0..darts.len()).filter(|i| !taken[*i]).take(missing));
    }
    (best, best_radius)
}

/// Darts in turn, each kept if no kept one of its layer is nearer than its radius. Cells of the largest radius hold linked lists.
fn apart(darts: &[Dart], base: f64) -> Vec<usize> {
    const NONE: u32 = u32::MAX;
    let radius: Vec<f64> = darts.iter().map(|dart| base / dart.density.sqrt()).collect();
    let cell = radius.iter().fold(1e-6, |m: f64, r| m.max(*r));
    let slots = (darts.len() * 2).next_power_of_two();
    let slot = |c: glam::IVec3, layer: u8| {
        let key = (c.x as u64 & 0xF_FFFF) | (c.y as u64 & 0xF_FFFF) << 20 | (c.z as u64 & 0xF_FFFF) << 40 | u64::from(layer & 15) << 60;
        (hash(key) as usize) & (slots - 1)
    };
    let mut head = vec![NONE; slots];
    let mut next = vec![NONE; darts.len()];
    let mut kept = Vec::new();
    for (i, dart) in darts.iter().enumerate() {
        let home = (dart.position / cell).floor().as_ivec3();
        let reach = radius[i] * radius[i];
        let free = (-1..=1).all(|z| {
            (-1..=1).all(|y| {
                (-1..=1).all(|x| {
                    let mut other = head[slot(home + glam::IVec3::new(x, y, z), dart.layer)];
                    while other != NONE {
                        let found = &darts[other as usize];
                        if found.layer == dart.layer && found.position.distance_squared(dart.position) < reach {
                            return false;
                        }
                        other = next[other as usize];
                    }
                    true
                })
            })
        });
        if free {
            let at = slot(home, dart.layer);
            next[i] = head[at];
            head[at] = i as u32;
            kept.push(i);
        }
    }
    kept
}
