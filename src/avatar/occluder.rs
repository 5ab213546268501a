//! What is certain to be opaque about an avatar: its Gaussians go in, a coarse mesh of the solid body comes out, in the canonical
//! pose, with the joints and nodes that move it. Drawn into a depth buffer, it says what no one can see.
//!
//! The Gaussians are taken for a shell. Space is cut into voxels; what the outside can't be reached from is solid, where it is
//! thicker than the shell alone. Sheets with nothing behind them (a skirt, an ear) are not solid, and hide nothing.

use super::{Avatar, limits, voxels::Voxels};
use glam::{DVec3, UVec3};
use kiddo::{ImmutableKdTree, NearestNeighbour, SquaredEuclidean};
use std::num::NonZero;

/// Gaussians less opaque than this (of 255) hide nothing.
const OPAQUE: u8 = 128;
/// Neighbouring Gaussians whose optical depth is compared with the surface that they lie on.
const CROWD: usize = 12;
/// Optical depth of a shell that hides what is behind it: 1 % shows.
const HIDES: f64 = 4.6;
/// Which share of the shell may be thinner.
const THIN: f64 = 0.1;
/// A voxel's side, in median distances between neighbouring Gaussians: as small as leaves no hole in the shell.
const VOXEL: f64 = 2.2;
/// Voxels along each side of a cell of the mesh.
const CELL: u32 = 3;
/// The most voxels: with larger avatars they grow.
const VOXELS: f64 = 24e6;
/// Voxels from the outside on that count as shell, on both sides of the Gaussians' centres.
const SHELL: usize = 4;
/// Voxels by which the shell is thickened to close openings.
const CLOSE: usize = 2;
/// Voxels that the outside then regains.
const REACH: usize = 8;
/// How far from a corner the nearest Gaussian may be, in voxels: the shell's inner half and what peeling rounds.
const REACHED: f64 = 3.0;
/// How differently neighbours may move, in 255ths of a weight: more, and they are neighbours in the canonical pose only.
const TOGETHER: i32 = 220;
/// Neighbours that a vertex is put between.
const NEIGHBORS: usize = 6;

/// A corner of the mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vertex {
    /// Canonical pose, metres.
    pub position: DVec3,
    /// As a Gaussian's: four joints, weights that sum to 255, three nodes.
    pub joint: [u8; 4],
    pub joint_weight: [u8; 4],
    pub node: [u16; 3],
}

/// A closed mesh, or nothing where nothing is solid.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Occluder {
    pub vertices: Vec<Vertex>,
    /// Counter-clockwise from outside.
    pub triangles: Vec<[u32; 3]>,
}

impl Occluder {
    /// Some tenths of a second for 200,000 Gaussians.
    pub fn new(avatar: &Avatar) -> Self {
        let opaque: Vec<u32> = (0..avatar.gaussians.len() as u32).filter(|&i| avatar.gaussians.opacity[i as usize] >= OPAQUE).collect();
        let points: Vec<[f64; 3]> = opaque.iter().map(|&i| avatar.position(i as usize).to_array()).collect();
        if points.len() < 1000 {
            return Self::default();
        }
        let tree: ImmutableKdTree<f64, 3> = ImmutableKdTree::new_from_slice(&points);
        if see_through(avatar, &opaque, &points, &tree) {
            return Self::default();
        }
        let Some(grid) = Grid::around(&points, spacing(&tree, &points)) else { return Self::default() };
        let solid = grid.solid(&points);
        let (corners, triangles) = grid.surface(&solid);
        let vertices: Vec<_> = corners.iter().map(|&corner| vertex(avatar, &opaque, &points, &tree, corner, grid.side)).collect();
        // A corner with no Gaussian near it covers an opening: nothing is opaque there. A triangle between corners that move differently
        // spans a gap (between the legs, under an arm) that some pose opens.
        let whole = |corners: &[u32; 3]| {
            let [a, b, c] = corners.map(|corner| vertices[corner as usize].map(|vertex| (vertex.joint, vertex.joint_weight)));
            matches!((a, b, c), (Some(a), Some(b), Some(c)) if apart(a, b).max(apart(b, c)).max(apart(c, a)) <= TOGETHER)
        };
        let triangles = triangles.into_iter().filter(whole).collect();
        let nowhere = Vertex { position: grid.min, joint: [0; 4], joint_weight: [255, 0, 0, 0], node: [0; 3] };
        Self { vertices: vertices.into_iter().map(|vertex| vertex.unwrap_or(nowhere)).collect(), triangles }
    }
}

/// Whether much of the shell lets light through, by a sample: a Gaussian's optical depth, integrated over the sheet that its two longer
/// axes span, is 2π σ₁ σ₂ Li₂(o), and what some neighbours have of it lies on the disc that they take up.
fn see_through(avatar: &Avatar, opaque: &[u32], points: &[[f64; 3]], tree: &ImmutableKdTree<f64, 3>) -> bool {
    let dilogarithm = |o: f64| (1..40).map(|k| o.powi(k) / f64::from(k * k)).sum::<f64>();
    let of_opacity: [f64; 256] = std::array::from_fn(|o| dilogarithm(o as f64 / 255.0));
    let depth_times_area = |found: &NearestNeighbour<f64, u64>| {
        let gaussian = opaque[found.item as usize] as usize;
        let mut scale = avatar.gaussians.log_scale[gaussian].map(|s| s.to_f64());
        scale.sort_by(f64::total_cmp);
        std::f64::consts::TAU * (scale[1] + scale[2]).exp() * of_opacity[usize::from(avatar.gaussians.opacity[gaussian])]
    };
    let count = const { NonZero::new(CROWD).unwrap() };
    let depth = |point| {
        let near = tree.nearest_n::<SquaredEuclidean>(point, count);
        let area = std::f64::consts::PI * near.last().map_or(0.0, |found| found.distance);
        near.iter().map(depth_times_area).sum::<f64>() / area.max(f64::MIN_POSITIVE)
    };
    let sample: Vec<f64> = points.iter().step_by(points.len().div_ceil(2000)).map(depth).collect();
    sample.iter().filter(|&&depth| depth < HIDES).count() as f64 > THIN * sample.len() as f64
}

/// Median distance to the nearest neighbour, over a sample.
fn spacing(tree: &ImmutableKdTree<f64, 3>, points: &[[f64; 3]]) -> f64 {
    let step = points.len().div_ceil(2000);
    let two = const { NonZero::new(2).unwrap() };
    let nearest = |point| tree.nearest_n::<SquaredEuclidean>(point, two).last().map_or(0.0, |found| found.distance.sqrt());
    let mut distances: Vec<f64> = points.iter().step_by(step).map(nearest).collect();
    distances.sort_by(f64::total_cmp);
    distances[distances.len() / 2]
}

/// Pulls a corner of the mesh to the Gaussians around it, and gives it what moves them.
fn vertex(
    avatar: &Avatar,
    opaque: &[u32],
    points: &[[f64; 3]],
    tree: &ImmutableKdTree<f64, 3>,
    corner: DVec3,
    side: f64,
) -> Option<Vertex> {
    let count = const { NonZero::new(NEIGHBORS).unwrap() };
    let near = tree.nearest_n::<SquaredEuclidean>(&corner.to_array(), count);
    if near[0].distance.sqrt() > REACHED * side {
        return None;
    }
    let middle = near.iter().map(|found| DVec3::from(points[found.item as usize])).sum::<DVec3>() / near.len() as f64;
    let skin = |found: &NearestNeighbour<f64, u64>| {
        let gaussian = opaque[found.item as usize] as usize;
        (avatar.gaussians.joint[gaussian], avatar.gaussians.joint_weight[gaussian])
    };
    let mut weight = [0u32; limits::JOINTS];
    for found in &near {
        let (joint, joint_weight) = skin(found);
        joint.iter().zip(joint_weight).for_each(|(&joint, w)| weight[usize::from(joint)] += u32::from(w));
    }
    let (joint, joint_weight) = strongest(&weight);
    if near.iter().any(|found| apart((joint, joint_weight), skin(found)) > TOGETHER) {
        return None;
    }
    Some(Vertex { position: middle, joint, joint_weight, node: avatar.gaussians.node[opaque[near[0].item as usize] as usize] })
}

/// How differently two points move: the sum over the joints of what their weights differ by, 0 to 510.
fn apart(a: ([u8; 4], [u8; 4]), b: ([u8; 4], [u8; 4])) -> i32 {
    let mut difference = [0i32; limits::JOINTS];
    a.0.iter().zip(a.1).for_each(|(&joint, w)| difference[usize::from(joint)] += i32::from(w));
    b.0.iter().zip(b.1).for_each(|(&joint, w)| difference[usize::from(joint)] -= i32::from(w));
    difference.iter().map(|d| d.abs()).sum()
}

/// The four largest weights, scaled to a sum of 255.
fn strongest(weight: &[u32; limits::JOINTS]) -> ([u8; 4], [u8; 4]) {
    let mut order: Vec<u8> = (0..=255).collect();
    order.sort_by_key(|&joint| std::cmp::Reverse(weight[usize::from(joint)]));
    let joint = [order[0], order[1], order[2], order[3]];
    let chosen = joint.map(|joint| weight[usize::from(joint)]);
    let sum = chosen.iter().sum::<u32>().max(1);
    let mut scaled = chosen.map(|w| (w * 255 / sum) as u8);
    scaled[0] += 255 - scaled.iter().map(|&w| u32::from(w)).sum::<u32>().min(255) as u8;
    (joint, scaled)
}

/// Voxels around the avatar, with an empty border.
struct Grid {
    min: DVec3,
    /// A voxel's side, metres.
    side: f64,
    /// Voxels along each axis: a whole number of cells.
    size: UVec3,
}

impl Grid {
    /// None where the avatar has no extent.
    fn around(points: &[[f64; 3]], spacing: f64) -> Option<Self> {
        let none = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        let (min, max) = points.iter().fold(none, |(min, max), &p| (min.min(p.into()), max.max(p.into())));
        let side = (VOXEL * spacing).max(((max - min).max(DVec3::splat(1e-6)).element_product() / VOXELS).cbrt());
        // Thin extents make the volume small and the sides many.
        let side = side.max((max - min).max_element() / 1000.0);
        if !(side > 0.0 && side.is_finite()) {
            return None;
        }
        let border = 2 * CELL;
        let size = ((max - min) / side).ceil().as_uvec3() + 2 * border;
        let size = (size + CELL - 1) / CELL * CELL;
        Some(Self { min: min - f64::from(border) * side, side, size })
    }

    /// The voxels that are solid: not reached from outside, and further from what is than the shell is thick.
    fn solid(&self, points: &[[f64; 3]]) -> Voxels {
        let mut centers = Voxels::none(self.size);
        points.iter().for_each(|&point| centers.insert(((DVec3::from(point) - self.min) / self.side).as_uvec3()));
        let shell = centers.boxed();
        // Openings (a collar, a trouser leg) would let the flood in: it is first kept from gaps up to some width, then may go a little
        // further, into the creases that it was kept from too.
        let closed = (0..CLOSE).fold(shell.clone(), |closed, _| closed.grown());
        let reached = (0..REACH).fold(closed.flooded(), |reached, _| reached.grown().without(&shell));
        // What is left is shell or inside. The shell is 3 voxels thick; peel it off from outside.
        (0..SHELL).fold(reached, |outside, _| outside.grown()).inverse()
    }

    /// How much of each cell is solid, 0 to 1.
    fn cells(&self, solid: &Voxels) -> (UVec3, Vec<f32>) {
        let cells = self.size / CELL;
        let mut share = vec![0.0; cells.element_product() as usize];
        for voxel in solid.iter() {
            let cell = voxel / CELL;
            share[((cell.z * cells.y + cell.y) * cells.x + cell.x) as usize] += 1.0 / CELL.pow(3) as f32;
        }
        (cells, share)
    }

    /// Surface nets: a corner between each eight cells of which some are more than half solid and some less, and two triangles across
    /// each pair of cells where one is and the other isn't.
    fn surface(&self, solid: &Voxels) -> (Vec<DVec3>, Vec<[u32; 3]>) {
        let (cells, share) = self.cells(solid);
        let value = |c: UVec3| share[((c.z * cells.y + c.y) * cells.x + c.x) as usize];
        let mut corner_of = vec![u32::MAX; share.len()];
        let mut corners = Vec::new();
        let corner_side = f64::from(CELL) * self.side;
        let inner = |c: UVec3| c.cmplt(cells - 1).all();
        let each = || (0..cells.z).flat_map(|z| (0..cells.y).flat_map(move |y| (0..cells.x).map(move |x| UVec3::new(x, y, z))));
        for cell in each().filter(|&cell| inner(cell)) {
            if let Some(middle) = crossing(cell, value) {
                corner_of[((cell.z * cells.y + cell.y) * cells.x + cell.x) as usize] = corners.len() as u32;
                corners.push(self.min + corner_side * (cell.as_dvec3() + 0.5 + middle));
            }
        }
        let mut triangles = Vec::new();
        for cell in each().filter(|&cell| inner(cell) && cell.cmpge(UVec3::ONE).all()) {
            for axis in 0..3 {
                let (here, there) = (value(cell) > 0.5, value(cell + UNIT[axis]) > 0.5);
                if here != there {
                    let (u, v) = (UNIT[(axis + 1) % 3], UNIT[(axis + 2) % 3]);
                    let quad = [cell - u - v, cell - v, cell, cell - u];
                    let [a, b, c, d] = quad.map(|c| corner_of[((c.z * cells.y + c.y) * cells.x + c.x) as usize]);
                    triangles.extend(if here { [[a, b, c], [a, c, d]] } else { [[a, c, b], [a, d, c]] });
                }
            }
        }
        (corners, triangles)
    }
}

const UNIT: [UVec3; 3] = [UVec3::X, UVec3::Y, UVec3::Z];

/// Where the value passes one half among the eight cells from `cell` on, as a mean over the edges; None where it doesn't. In cells.
fn crossing(cell: UVec3, value: impl Fn(UVec3) -> f32) -> Option<DVec3> {
    let at = |k: u32| UVec3::new(k & 1, k >> 1 & 1, k >> 2);
    let values: [f64; 8] = std::array::from_fn(|k| f64::from(value(cell + at(k as u32))) - 0.5);
    if values.iter().all(|&value| value > 0.0) || values.iter().all(|&value| value <= 0.0) {
        return None;
    }
    let (mut sum, mut count) = (DVec3::ZERO, 0.0);
    for k in 0..8u32 {
        for (axis, unit) in UNIT.iter().enumerate().filter(|(axis, _)| k >> axis & 1 == 0) {
            let (a, b) = (values[k as usize], values[(k | 1 << axis) as usize]);
            if (a > 0.0) != (b > 0.0) {
                sum += at(k).as_dvec3() + a / (a - b) * unit.as_dvec3();
                count += 1.0;
            }
        }
    }
    (count > 0.0).then(|| sum / count)
}
