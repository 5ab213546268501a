//! The occluder mesh: a coarse mesh of what is certain to be opaque, in the canonical pose, with
//! the joints and nodes that move it. Its depth image tells which Gaussians are hidden.
//!
//! The Gaussians are treated as a shell. Space is cut into voxels. Voxels that a flood from outside
//! does not reach are solid, if they are thicker than the shell alone. Sheets with nothing behind
//! them (a skirt, an ear) are not solid and hide nothing.

use super::voxels::Voxels;
use crate::{
    avatar::{Avatar, limits},
    each,
};
use glam::{DVec3, UVec3};
use kiddo::{ImmutableKdTree, NearestNeighbour, SquaredEuclidean};
use std::num::NonZero;

/// Gaussians less opaque than this (of 255) hide nothing.
const OPAQUE: u8 = 128;
/// Neighbouring Gaussians over which optical depth is averaged.
const DEPTH_NEIGHBORS: usize = 12;
/// Optical depth of an opaque shell: 1 % of the light passes.
pub const OPAQUE_DEPTH: f64 = 4.6;
/// Largest share of the shell that may be thinner.
const MAX_THIN: f64 = 0.1;
/// A voxel's side, in median distances between neighbouring Gaussians: the smallest that leaves no
/// holes in the shell.
const VOXEL: f64 = 2.2;
/// Voxels along each side of a cell of the mesh.
const CELL: u32 = 3;
/// Maximum number of voxels; larger avatars get larger voxels.
const MAX_VOXELS: f64 = 24e6;
/// Voxels to peel off from outside: the shell on both sides of the Gaussians' centres.
const SHELL: usize = 4;
/// Voxels by which the shell is thickened to close openings.
const CLOSE: usize = 2;
/// Voxels by which the outside is then grown back.
const REGROW: usize = 8;
/// Maximum distance of a corner to the nearest Gaussian, in voxels: the shell's inner half and the
/// rounding of peeling.
const MAX_DISTANCE: f64 = 3.0;
/// Maximum difference in skinning of neighbours, in 255ths of a weight. Points that differ more are
/// neighbours only in the canonical pose.
const MAX_SKIN_DIFFERENCE: i32 = 220;
/// Gaussians that stand for all of them, at most.
const SAMPLE: usize = 2000;
/// Gaussians that a vertex is averaged from.
const NEIGHBORS: usize = 6;

/// A corner of the mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OccluderVertex {
    /// Canonical pose, metres.
    pub position: DVec3,
    /// The four joints that move it.
    pub joint: [u8; 4],
    /// Their weights; the four sum to 255.
    pub joint_weight: [u8; 4],
    /// The three nearest nodes.
    pub node: [u16; 3],
    /// Optical depth of the shell of Gaussians around it, in the canonical pose.
    pub optical_depth: f64,
    /// Two vertices beside it, of those that move most unlike it. From where a pose takes the three
    /// follows how far it pulls the shell apart.
    pub neighbor: [u32; 2],
}

impl OccluderVertex {
    fn skin(&self) -> Skin {
        Skin {
            joints: self.joint,
            weights: self.joint_weight,
        }
    }
}

/// Skinning of a point.
#[derive(Clone, Copy)]
struct Skin {
    joints: [u8; 4],
    /// They sum to 255.
    weights: [u8; 4],
}

/// The avatar's opaque Gaussians.
struct Shell<'a> {
    avatar: &'a Avatar,
    /// Indices of the Gaussians.
    gaussians: &'a [u32],
    /// Their positions, metres.
    points: &'a [[f64; 3]],
    tree: &'a ImmutableKdTree<f64, 3>,
    /// Optical depth times σ₁ σ₂, the two longer axes, by opacity.
    depth_by_opacity: [f64; 256],
}

/// A closed mesh; empty where nothing is solid.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Occluder {
    /// The corners of the triangles.
    pub vertices: Vec<OccluderVertex>,
    /// Indices into `vertices`, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
}

impl Occluder {
    /// Makes the mesh of an avatar: takes some tenths of a second for 200,000 Gaussians.
    ///
    /// # Panics
    /// Where [`Avatar::check`] finds a fault.
    pub fn new(avatar: &Avatar) -> Self {
        let opaque: Vec<u32> = (0..avatar.gaussians.len() as u32)
            .filter(|&i| avatar.gaussians.opacity[i as usize] >= OPAQUE)
            .collect();
        let points: Vec<[f64; 3]> = opaque
            .iter()
            .map(|&i| avatar.position(i as usize).to_array())
            .collect();
        if points.len() < 1000 {
            return Self::default();
        }
        let tree: ImmutableKdTree<f64, 3> = ImmutableKdTree::new_from_slice(&points);
        let shell = Shell {
            avatar,
            gaussians: &opaque,
            points: &points,
            tree: &tree,
            depth_by_opacity: std::array::from_fn(|o| depth_times_area(o as f64 / 255.0)),
        };
        if shell.is_see_through() {
            return Self::default();
        }
        let Some(grid) = Grid::around(&points, shell.spacing()) else {
            return Self::default();
        };
        let solid = grid.solid(&points);
        let (corners, triangles) = grid.surface(&solid);
        let vertices = each::map(corners.len(), |k| shell.vertex(corners[k], grid.side));
        // A corner with no Gaussian near it covers an opening: nothing is opaque there. A triangle
        // between corners that move differently spans a gap (between the legs, under an arm) that
        // some pose opens.
        let mut movement = vec![Movement::default(); vertices.len()];
        let mut opaque_triangles = Vec::new();
        for triangle in triangles {
            let [Some(a), Some(b), Some(c)] = triangle.map(|corner| &vertices[corner as usize])
            else {
                continue;
            };
            let difference = skin_difference(a.skin(), b.skin())
                .max(skin_difference(b.skin(), c.skin()))
                .max(skin_difference(c.skin(), a.skin()));
            for k in 0..3 {
                movement[triangle[k] as usize]
                    .meet(difference, [triangle[(k + 1) % 3], triangle[(k + 2) % 3]]);
            }
            if difference <= MAX_SKIN_DIFFERENCE {
                opaque_triangles.push(triangle);
            }
        }
        let unused = OccluderVertex {
            position: grid.min,
            joint: [0; 4],
            joint_weight: [255, 0, 0, 0],
            node: [0; 3],
            optical_depth: 0.0,
            neighbor: [0; 2],
        };
        Self {
            vertices: vertices
                .into_iter()
                .zip(movement)
                .map(|(vertex, movement)| OccluderVertex {
                    neighbor: movement.neighbor,
                    ..vertex.unwrap_or(unused)
                })
                .collect(),
            triangles: opaque_triangles,
        }
    }
}

impl Shell<'_> {
    fn gaussian(&self, found: &NearestNeighbour<f64, u64>) -> usize {
        self.gaussians[found.item as usize] as usize
    }

    fn skin(&self, found: &NearestNeighbour<f64, u64>) -> Skin {
        let gaussian = self.gaussian(found);
        Skin {
            joints: self.avatar.gaussians.joint[gaussian],
            weights: self.avatar.gaussians.joint_weight[gaussian],
        }
    }

    /// Whether much of the shell lets light through, by a sample.
    fn is_see_through(&self) -> bool {
        let step = self.points.len().div_ceil(SAMPLE);
        let sample = each::map(self.points.len().div_ceil(step), |k| {
            self.optical_depth(&self.points[k * step])
        });
        let thin = sample.iter().filter(|&&depth| depth < OPAQUE_DEPTH).count();
        thin as f64 > MAX_THIN * sample.len() as f64
    }

    /// Optical depth of the shell at a point, canonical pose: that of some Gaussians around it,
    /// spread over the disc that they take up.
    fn optical_depth(&self, point: &[f64; 3]) -> f64 {
        let count = const { NonZero::new(DEPTH_NEIGHBORS).unwrap() };
        let near = self.tree.nearest_n::<SquaredEuclidean>(point, count);
        let area = std::f64::consts::PI * near.last().map_or(0.0, |found| found.distance);
        let depth = |found: &NearestNeighbour<f64, u64>| {
            let gaussian = self.gaussian(found);
            let mut scale = self.avatar.gaussians.log_scale[gaussian].map(|s| s.to_f64());
            scale.sort_by(f64::total_cmp);
            let opacity = self.avatar.gaussians.opacity[gaussian];
            (scale[1] + scale[2]).exp() * self.depth_by_opacity[usize::from(opacity)]
        };
        near.iter().map(depth).sum::<f64>() / area.max(f64::MIN_POSITIVE)
    }

    /// Median distance to the nearest neighbour, over a sample, metres.
    fn spacing(&self) -> f64 {
        let step = self.points.len().div_ceil(SAMPLE);
        let two = const { NonZero::new(2).unwrap() };
        let nearest = |point| {
            self.tree
                .nearest_n::<SquaredEuclidean>(point, two)
                .last()
                .map_or(0.0, |found| found.distance.sqrt())
        };
        let mut distances: Vec<f64> = self.points.iter().step_by(step).map(nearest).collect();
        distances.sort_by(f64::total_cmp);
        distances[distances.len() / 2]
    }

    /// Pulls a corner of the mesh to the Gaussians around it, and gives it their skinning. `side`:
    /// of a voxel, metres. None where no Gaussian is near, or those near move differently.
    fn vertex(&self, corner: DVec3, side: f64) -> Option<OccluderVertex> {
        let count = const { NonZero::new(NEIGHBORS).unwrap() };
        let near = self
            .tree
            .nearest_n::<SquaredEuclidean>(&corner.to_array(), count);
        if near[0].distance.sqrt() > MAX_DISTANCE * side {
            return None;
        }
        let sum: DVec3 = near
            .iter()
            .map(|found| DVec3::from(self.points[found.item as usize]))
            .sum();
        let mut weights = [0u32; limits::JOINTS];
        for found in &near {
            let skin = self.skin(found);
            for (&joint, weight) in skin.joints.iter().zip(skin.weights) {
                weights[usize::from(joint)] += u32::from(weight);
            }
        }
        let position = sum / near.len() as f64;
        let skin = strongest(&weights);
        let moves_apart = |found: &_| skin_difference(skin, self.skin(found)) > MAX_SKIN_DIFFERENCE;
        if near.iter().any(moves_apart) {
            return None;
        }
        Some(OccluderVertex {
            position,
            joint: skin.joints,
            joint_weight: skin.weights,
            node: self.avatar.gaussians.node[self.gaussian(&near[0])],
            optical_depth: self.optical_depth(&position.to_array()),
            neighbor: [0; 2],
        })
    }
}

/// The triangle at a vertex whose corners move most unlike each other.
#[derive(Clone, Copy, Default)]
struct Movement {
    difference: Option<i32>,
    /// The triangle's other corners.
    neighbor: [u32; 2],
}

impl Movement {
    /// Takes a triangle into account. The first of those that are alike counts.
    fn meet(&mut self, difference: i32, neighbor: [u32; 2]) {
        if self.difference.is_none_or(|most| difference > most) {
            *self = Self {
                difference: Some(difference),
                neighbor,
            };
        }
    }
}

/// Optical depth of a Gaussian of an opacity, integrated over the sheet that its two longer axes
/// span, in units of their product σ₁ σ₂: 2π Li₂(o).
fn depth_times_area(opacity: f64) -> f64 {
    let dilogarithm: f64 = (1..40).map(|k| opacity.powi(k) / f64::from(k * k)).sum();
    std::f64::consts::TAU * dilogarithm
}

/// How differently two points move: the sum over all joints of the difference of their weights, 0
/// to 510.
fn skin_difference(a: Skin, b: Skin) -> i32 {
    // Of each joint of either, by where it is named first.
    let mut joints = [0; 8];
    let mut difference = [0i32; 8];
    let mut count = 0;
    let mut add = |joint: u8, weight: i32| {
        let named = joints[..count].iter().position(|&known| known == joint);
        let at = named.unwrap_or(count);
        joints[at] = joint;
        difference[at] += weight;
        count = count.max(at + 1);
    };
    for (&joint, weight) in a.joints.iter().zip(a.weights) {
        add(joint, i32::from(weight));
    }
    for (&joint, weight) in b.joints.iter().zip(b.weights) {
        add(joint, -i32::from(weight));
    }
    difference.iter().map(|d| d.abs()).sum()
}

/// The four largest weights, scaled to a sum of 255.
fn strongest(weight: &[u32; limits::JOINTS]) -> Skin {
    // By falling weight; of equal ones the first.
    let mut strongest = [0u8; 4];
    for k in 0..4 {
        let rest = (0..=255).filter(|joint| !strongest[..k].contains(joint));
        let best = rest.rev().max_by_key(|&joint| weight[usize::from(joint)]);
        strongest[k] = best.unwrap_or_default();
    }
    let chosen = strongest.map(|joint| weight[usize::from(joint)]);
    let sum = chosen.iter().sum::<u32>().max(1);
    let mut scaled = chosen.map(|w| (w * 255 / sum) as u8);
    scaled[0] += 255 - scaled.iter().map(|&w| u32::from(w)).sum::<u32>().min(255) as u8;
    // A joint without weight need not exist: an avatar may have fewer than four.
    let existing = |joint: u8| match weight[usize::from(joint)] {
        0 => strongest[0],
        _ => joint,
    };
    Skin {
        joints: strongest.map(existing),
        weights: scaled,
    }
}

/// The cells of a grid, along x first.
#[derive(Clone, Copy)]
struct Cells {
    /// Cells along each axis.
    size: UVec3,
}

impl Cells {
    fn count(self) -> usize {
        self.size.element_product() as usize
    }

    fn index(self, cell: UVec3) -> usize {
        ((cell.z * self.size.y + cell.y) * self.size.x + cell.x) as usize
    }

    fn iter(self) -> impl Iterator<Item = UVec3> {
        let UVec3 { x, y, .. } = self.size;
        (0..self.count() as u32)
            .map(move |index| UVec3::new(index % x, index / x % y, index / (x * y)))
    }
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
    /// A grid around points. None where they are all in one place or not finite.
    fn around(points: &[[f64; 3]], spacing: f64) -> Option<Self> {
        let mut min = DVec3::INFINITY;
        let mut max = DVec3::NEG_INFINITY;
        for &point in points {
            min = min.min(point.into());
            max = max.max(point.into());
        }
        let side = (VOXEL * spacing)
            .max(((max - min).max(DVec3::splat(1e-6)).element_product() / MAX_VOXELS).cbrt());
        // A flat box has a small volume but may have many voxels along its sides.
        let side = side.max((max - min).max_element() / 1000.0);
        if !(side > 0.0 && side.is_finite()) {
            return None;
        }
        let border = 2 * CELL;
        let size = ((max - min) / side).ceil().as_uvec3() + 2 * border;
        let size = (size + CELL - 1) / CELL * CELL;
        Some(Self {
            min: min - f64::from(border) * side,
            side,
            size,
        })
    }

    /// The solid voxels: not reached from outside, and further inside than the shell is thick.
    fn solid(&self, points: &[[f64; 3]]) -> Voxels {
        let mut centers = Voxels::none(self.size);
        for &point in points {
            centers.insert(((DVec3::from(point) - self.min) / self.side).as_uvec3());
        }
        let shell = centers.boxed();
        // Openings (a collar, a trouser leg) would let the flood in. The shell is thickened first,
        // which closes gaps up to some width; then the outside grows back into creases.
        let closed = (0..CLOSE).fold(shell.clone(), |closed, _| closed.grown());
        let reached = (0..REGROW).fold(closed.flooded(), |reached, _| {
            reached.grown().without(&shell)
        });
        // The rest is shell or inside. The shell is 3 voxels thick; peel it off from outside.
        (0..SHELL)
            .fold(reached, |outside, _| outside.grown())
            .complement()
    }

    /// The grid of cells, and the solid share of each, 0 to 1.
    fn cells(&self, solid: &Voxels) -> (Cells, Vec<f32>) {
        let cells = Cells {
            size: self.size / CELL,
        };
        let mut share = vec![0.0; cells.count()];
        for voxel in solid.iter() {
            share[cells.index(voxel / CELL)] += 1.0 / CELL.pow(3) as f32;
        }
        (cells, share)
    }

    /// Surface nets: a corner between each eight cells of which some are more than half solid and
    /// some are not, and two triangles between each two neighbouring cells that differ so.
    fn surface(&self, solid: &Voxels) -> (Vec<DVec3>, Vec<[u32; 3]>) {
        let (cells, share) = self.cells(solid);
        let value = |cell: UVec3| share[cells.index(cell)];
        let mut corner_of = vec![u32::MAX; share.len()];
        let mut corners = Vec::new();
        let corner_side = f64::from(CELL) * self.side;
        let has_upper_neighbors = |cell: UVec3| cell.cmplt(cells.size - 1).all();
        for cell in cells.iter().filter(|&cell| has_upper_neighbors(cell)) {
            if let Some(middle) = crossing(cell, value) {
                corner_of[cells.index(cell)] = corners.len() as u32;
                corners.push(self.min + corner_side * (cell.as_dvec3() + 0.5 + middle));
            }
        }
        let mut triangles = Vec::new();
        let has_all_neighbors =
            |cell: UVec3| has_upper_neighbors(cell) && cell.cmpge(UVec3::ONE).all();
        for cell in cells.iter().filter(|&cell| has_all_neighbors(cell)) {
            for axis in 0..3 {
                let here = value(cell) > 0.5;
                let there = value(cell + UNIT[axis]) > 0.5;
                if here != there {
                    let u = UNIT[(axis + 1) % 3];
                    let v = UNIT[(axis + 2) % 3];
                    let quad = [cell - u - v, cell - v, cell, cell - u];
                    let [a, b, c, d] = quad.map(|cell| corner_of[cells.index(cell)]);
                    triangles.extend(if here {
                        [[a, b, c], [a, c, d]]
                    } else {
                        [[a, c, b], [a, d, c]]
                    });
                }
            }
        }
        (corners, triangles)
    }
}

const UNIT: [UVec3; 3] = [UVec3::X, UVec3::Y, UVec3::Z];

/// Where the value crosses one half among the eight cells from `cell` on: the mean over the crossed
/// edges, in cells. None where it does not.
fn crossing(cell: UVec3, value: impl Fn(UVec3) -> f32) -> Option<DVec3> {
    let at = |k: u32| UVec3::new(k & 1, k >> 1 & 1, k >> 2);
    let values: [f64; 8] = std::array::from_fn(|k| f64::from(value(cell + at(k as u32))) - 0.5);
    if values.iter().all(|&value| value > 0.0) || values.iter().all(|&value| value <= 0.0) {
        return None;
    }
    let mut sum = DVec3::ZERO;
    let mut count = 0.0;
    for k in 0..8u32 {
        for (axis, unit) in UNIT.iter().enumerate() {
            if k >> axis & 1 != 0 {
                continue;
            }
            let a = values[k as usize];
            let b = values[(k | 1 << axis) as usize];
            if (a > 0.0) != (b > 0.0) {
                sum += at(k).as_dvec3() + a / (a - b) * unit.as_dvec3();
                count += 1.0;
            }
        }
    }
    (count > 0.0).then(|| sum / count)
}
