//! The body model: a mesh in its rest pose that a skeleton moves. The names are those of a SMPL-X
//! model file, which may be put here as it is:
//!
//! | array | shape | content |
//! |---|---|---|
//! | `v_template` | V, 3 | vertices, metres |
//! | `f` | F, 3 | vertices of each triangle, anticlockwise from outside |
//! | `weights` | V, J | skin weights |
//! | `kintree_table` | 2, J | each joint's parent, in the first row |
//! | `J` | J, 3 | joints, metres; or `J_regressor` |
//! | `J_regressor` | J, V | takes vertices to joints |
//! | `shapedirs` | V, 3, B | displacements by `betas` of `smpl_params.npz`; may be absent |
//! | `canonical` | J, 3 | axis-angle of the pose that Gaussians are given in; default: hips 25° outwards |
//! | `input_joints` | I | joints that networks see; default 1 to 21 |
//! | `head_joints` | H | joints whose parts see the expression; default 15 and, of SMPL-X, 22 to 24 |
//! | `joint_names` | J, W | UTF-8 bytes, padded with zeros; may be absent |
//! | `hands_meanl`, `hands_componentsl` | 45; C, 45 | the left hand at rest, and what hands of fewer numbers count; so for the right, `r`; may be absent |

use crate::{
    error::{CaptureError, content, fault, read_bytes},
    limits,
    poses::{HAND, Hands, SMPL, SMPL_X, check_joints},
};
use effigy_core::{
    avatar::{Pose, Skeleton},
    io::file::FormatError,
};
use effigy_formats::{
    npz::{Npz, NpzWriter},
    smpl,
};
use glam::{DAffine3, DMat3, DVec3};
use std::path::Path;

/// The file's name.
pub const FILE: &str = "template.npz";
/// Every array that is read.
const NAMES: [&str; 15] = [
    "v_template",
    "f",
    "weights",
    "kintree_table",
    "J",
    "J_regressor",
    "shapedirs",
    "canonical",
    "input_joints",
    "head_joints",
    "joint_names",
    "hands_meanl",
    "hands_meanr",
    "hands_componentsl",
    "hands_componentsr",
];
/// How far both hips turn outwards where the file has no canonical pose, degrees.
const HIPS: f32 = 25.0;
/// Joints of the SMPL family's body, before those of face and hands. Networks see all but the first
/// where the file does not say.
pub const BODY: usize = 22;
/// SMPL's head.
const HEAD: u8 = 15;
/// Skin weights below this are ignored.
const LEAST_WEIGHT: f32 = 1e-4;
/// Bytes of a joint's name.
const NAME: usize = 64;
/// Shapes of a SMPL-X file with 400 directions; expressions follow.
const SHAPES: usize = 300;

/// A joint that moves a vertex, and how much.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VertexInfluence {
    /// Index of the joint.
    pub joint: u8,
    /// Above 0. The weights of a vertex sum to 1.
    pub weight: f32,
}

/// The body model of a capture.
#[derive(Clone, Debug, PartialEq)]
pub struct Template {
    /// Joints, with the canonical pose.
    pub skeleton: Skeleton,
    /// Rest pose, metres.
    pub vertices: Vec<DVec3>,
    /// Vertices of each triangle, anticlockwise from outside.
    pub triangles: Vec<[u32; 3]>,
    /// Joints that move each vertex, the largest weight first.
    pub weights: Vec<Vec<VertexInfluence>>,
    /// Joints that networks see, in the order of their input.
    pub input_joints: Vec<u8>,
    /// Joints whose parts see the expression.
    pub head_joints: Vec<u8>,
    /// Length of an expression.
    pub expression: usize,
}

/// A template with what poses need of it.
pub struct BodyModel {
    pub template: Template,
    pub hands: Hands,
}

impl Template {
    /// Rest pose to posed, for each joint.
    pub fn joints(&self, pose: &Pose) -> Vec<DAffine3> {
        let rest = Skeleton {
            canonical: vec![[0.0; 3]; self.skeleton.len()],
            ..self.skeleton.clone()
        };
        rest.matrices(pose)
    }

    /// The vertices under a pose by linear blend skinning, metres.
    pub fn posed(&self, pose: &Pose) -> Vec<DVec3> {
        let joints = self.joints(pose);
        let vertex = |(vertex, influences): (&DVec3, &Vec<VertexInfluence>)| {
            let mut sum = DAffine3 {
                matrix3: DMat3::ZERO,
                translation: DVec3::ZERO,
            };
            for influence in influences {
                let matrix = &joints[usize::from(influence.joint)];
                sum.matrix3 += matrix.matrix3 * f64::from(influence.weight);
                sum.translation += matrix.translation * f64::from(influence.weight);
            }
            sum.transform_point3(*vertex)
        };
        self.vertices
            .iter()
            .zip(&self.weights)
            .map(vertex)
            .collect()
    }

    /// The file's bytes.
    pub fn encode(&self) -> Result<Vec<u8>, String> {
        let joints = self.skeleton.len();
        let points =
            |points: &mut dyn Iterator<Item = [f32; 3]>| -> Vec<f32> { points.flatten().collect() };
        let mut weights = vec![0.0f32; self.vertices.len() * joints];
        for (row, influences) in weights.chunks_exact_mut(joints).zip(&self.weights) {
            for influence in influences {
                row[usize::from(influence.joint)] = influence.weight;
            }
        }
        // As the model's own files have it: the root's parent is the largest number.
        let parents = self.skeleton.parent.iter();
        let mut tree: Vec<u32> = parents.map(|p| p.map_or(u32::MAX, u32::from)).collect();
        tree.extend(0..joints as u32);
        let mut names = vec![0; NAME * joints];
        for (row, name) in names.chunks_exact_mut(NAME).zip(&self.skeleton.name) {
            let length = name.floor_char_boundary(NAME);
            row[..length].copy_from_slice(&name.as_bytes()[..length]);
        }
        let vertices = points(&mut self.vertices.iter().map(|v| v.as_vec3().to_array()));
        let rest = points(&mut self.skeleton.rest.iter().copied());
        let canonical = points(&mut self.skeleton.canonical.iter().copied());
        let mut file = NpzWriter::new();
        let mut write = || {
            file.add("v_template", &[self.vertices.len(), 3], &vertices)?;
            file.add(
                "f",
                &[self.triangles.len(), 3],
                self.triangles.as_flattened(),
            )?;
            file.add("weights", &[self.vertices.len(), joints], &weights)?;
            file.add("kintree_table", &[2, joints], &tree)?;
            file.add("J", &[joints, 3], &rest)?;
            file.add("canonical", &[joints, 3], &canonical)?;
            file.add(
                "input_joints",
                &[self.input_joints.len()],
                &self.input_joints,
            )?;
            file.add("head_joints", &[self.head_joints.len()], &self.head_joints)?;
            file.add("joint_names", &[joints, NAME], &names)
        };
        write()
            .and_then(|()| file.finish())
            .map_err(|error| error.to_string())
    }
}

/// Reads a body model. `betas`: its shape, as far as it has directions for them. The expression's
/// length is left at 0.
pub fn read(file: &Path) -> Result<TemplateArchive, CaptureError> {
    let bytes = read_bytes(file, limits::ARCHIVE)?;
    let wanted = |name: &str| NAMES.contains(&name);
    let mut arrays = Npz::some_from_bytes(&bytes, 64 << 20, wanted).map_err(|e| fault(file, e))?;
    let tree = arrays.take("kintree_table").map_err(|e| fault(file, e))?;
    let joints = tree.dimension(1).map_err(|e| fault(file, e))?;
    check_joints(file, joints)?;
    tree.expect_shape(&[2, joints])
        .map_err(|e| fault(file, e))?;
    let tree = tree.numbers();
    let mut parent = vec![None];
    for (joint, &number) in tree[..joints].iter().enumerate().skip(1) {
        if !(number >= 0.0 && number < joint as f64 && number.fract() == 0.0) {
            return Err(content(
                file,
                format!("parent {number} of joint {joint} in `kintree_table`"),
                "a joint before it",
            ));
        }
        parent.push(Some(number as u8));
    }
    Ok(TemplateArchive { arrays, parent })
}

/// A body model's arrays, with its tree of joints.
pub struct TemplateArchive {
    arrays: Npz,
    pub parent: Vec<Option<u8>>,
}

impl TemplateArchive {
    /// The model with a shape. The expression's length is left at 0.
    pub fn model(mut self, file: &Path, betas: &[f64]) -> Result<BodyModel, CaptureError> {
        self.build(betas).map_err(|error| fault(file, error))
    }

    fn build(&mut self, betas: &[f64]) -> Result<BodyModel, FormatError> {
        let joints = self.parent.len();
        let mut vertices = self.vertices()?;
        let count = vertices.len();
        if self.arrays.has("shapedirs") && betas.iter().any(|&beta| beta != 0.0) {
            self.shape(&mut vertices, betas)?;
        }
        let faces = self.arrays.take("f")?;
        let length = faces.dimension(0)?;
        faces.expect_shape(&[length, 3])?;
        if !(1..=limits::TRIANGLES).contains(&length) {
            return Err(FormatError::metadata(
                "f",
                format!("{length} triangles"),
                "some",
            ));
        }
        let triangles = faces.integers(count)?.as_chunks::<3>().0.to_vec();
        let rest = self.rest(&vertices)?;
        let skeleton = Skeleton {
            name: self.names()?,
            parent: self.parent.clone(),
            rest,
            canonical: self.canonical()?,
        };
        let inputs = (1..joints.min(BODY) as u8).collect();
        let head = match joints {
            SMPL_X => vec![HEAD, 22, 23, 24],
            _ if joints > usize::from(HEAD) => vec![HEAD],
            _ => vec![],
        };
        let template = Template {
            skeleton,
            weights: self.weights(count)?,
            vertices,
            triangles,
            input_joints: self.some_joints("input_joints", inputs)?,
            head_joints: self.some_joints("head_joints", head)?,
            expression: 0,
        };
        let hands = Hands {
            mean: [
                self.mean_hand("hands_meanl")?,
                self.mean_hand("hands_meanr")?,
            ],
            components: [
                self.hand_components("hands_componentsl")?,
                self.hand_components("hands_componentsr")?,
            ],
        };
        Ok(BodyModel { template, hands })
    }

    fn vertices(&mut self) -> Result<Vec<DVec3>, FormatError> {
        let array = self.arrays.take("v_template")?;
        let count = array.dimension(0)?;
        array.expect_shape(&[count, 3])?;
        if !(3..=limits::VERTICES).contains(&count) {
            let most = limits::VERTICES;
            let expected = format!("3 to {most} vertices");
            return Err(FormatError::metadata("v_template", count, expected));
        }
        let numbers = array.floats()?;
        let points: Vec<DVec3> = numbers
            .as_chunks::<3>()
            .0
            .iter()
            .map(|p| DVec3::from(p.map(f64::from)))
            .collect();
        let low = points.iter().fold(DVec3::INFINITY, |low, p| low.min(*p));
        let high = points
            .iter()
            .fold(DVec3::NEG_INFINITY, |high, p| high.max(*p));
        let extent = (high - low).max_element();
        // Centimetres and millimetres are the usual fault.
        if !(0.1..=10.0).contains(&extent) {
            return Err(FormatError::metadata(
                "v_template",
                format!("a body of {extent:.3}"),
                "0.1 to 10 metres",
            ));
        }
        Ok(points)
    }

    fn shape(&mut self, vertices: &mut [DVec3], betas: &[f64]) -> Result<(), FormatError> {
        let array = self.arrays.take("shapedirs")?;
        let directions = array.dimension(2)?;
        array.expect_shape(&[vertices.len(), 3, directions])?;
        // SMPL-X keeps expressions behind the shapes: 300 and 100, or 10 and 10.
        let shapes = match directions {
            0 => return Ok(()),
            20 => 10,
            _ => directions.min(SHAPES),
        };
        let numbers = array.floats()?;
        let rows = numbers.as_chunks::<3>().0.len();
        debug_assert_eq!(rows * 3, numbers.len());
        for (vertex, block) in vertices
            .iter_mut()
            .zip(numbers.chunks_exact(3 * directions))
        {
            let along = |axis: usize| {
                let row = &block[axis * directions..][..shapes];
                row.iter().zip(betas).map(|(&d, b)| f64::from(d) * b).sum()
            };
            *vertex += DVec3::new(along(0), along(1), along(2));
        }
        Ok(())
    }

    fn rest(&mut self, vertices: &[DVec3]) -> Result<Vec<[f32; 3]>, FormatError> {
        let joints = self.parent.len();
        if self.arrays.has("J_regressor") {
            let array = self.arrays.take("J_regressor")?;
            array.expect_shape(&[joints, vertices.len()])?;
            let numbers = array.floats()?;
            let joint = |row: &[f32]| {
                let terms = row.iter().zip(vertices).filter(|(share, _)| **share != 0.0);
                let place: DVec3 = terms.map(|(&share, v)| *v * f64::from(share)).sum();
                place.as_vec3().to_array()
            };
            return Ok(numbers.chunks_exact(vertices.len()).map(joint).collect());
        }
        let array = self.arrays.take("J")?;
        array.expect_shape(&[joints, 3])?;
        Ok(array.floats()?.as_chunks().0.to_vec())
    }

    fn weights(&mut self, count: usize) -> Result<Vec<Vec<VertexInfluence>>, FormatError> {
        let joints = self.parent.len();
        let array = self.arrays.take("weights")?;
        array.expect_shape(&[count, joints])?;
        let numbers = array.floats()?;
        let mut all = Vec::with_capacity(count);
        for (vertex, row) in numbers.chunks_exact(joints).enumerate() {
            let mut own: Vec<VertexInfluence> = row
                .iter()
                .enumerate()
                .filter(|&(_, &weight)| weight >= LEAST_WEIGHT)
                .map(|(joint, &weight)| VertexInfluence {
                    joint: joint as u8,
                    weight,
                })
                .collect();
            let sum: f32 = own.iter().map(|influence| influence.weight).sum();
            if !(0.5..=1.5).contains(&sum) {
                return Err(FormatError::metadata(
                    "weights",
                    format!("a sum of {sum} at vertex {vertex}"),
                    "1",
                ));
            }
            for influence in &mut own {
                influence.weight /= sum;
            }
            own.sort_by(|a, b| b.weight.total_cmp(&a.weight).then(a.joint.cmp(&b.joint)));
            all.push(own);
        }
        Ok(all)
    }

    fn canonical(&mut self) -> Result<Vec<[f32; 3]>, FormatError> {
        let joints = self.parent.len();
        if !self.arrays.has("canonical") {
            let mut turns = vec![[0.0; 3]; joints];
            if joints >= SMPL {
                turns[1][2] = HIPS.to_radians();
                turns[2][2] = -HIPS.to_radians();
            }
            return Ok(turns);
        }
        let array = self.arrays.take("canonical")?;
        array.expect_shape(&[joints, 3])?;
        Ok(array.floats()?.as_chunks().0.to_vec())
    }

    fn names(&mut self) -> Result<Vec<String>, FormatError> {
        let joints = self.parent.len();
        if !self.arrays.has("joint_names") {
            let known = smpl::average_joints();
            let name = |at: usize| match joints {
                SMPL_X => known[at].name.clone(),
                SMPL if at < BODY => known[at].name.clone(),
                _ => format!("joint {at}"),
            };
            return Ok((0..joints).map(name).collect());
        }
        let array = self.arrays.take("joint_names")?;
        let width = array.dimension(1)?;
        array.expect_shape(&[joints, width])?;
        let bytes: Vec<u8> = array
            .integers(256)?
            .iter()
            .map(|&byte| byte as u8)
            .collect();
        let names: Vec<String> = bytes
            .chunks_exact(width.max(1))
            .map(|row| {
                String::from_utf8_lossy(row)
                    .trim_end_matches('\0')
                    .to_owned()
            })
            .collect();
        let twice = (1..names.len()).find(|&at| names[..at].contains(&names[at]));
        if names.len() != joints || names.iter().any(String::is_empty) || twice.is_some() {
            let found = match twice {
                Some(at) => format!("`{}` twice", names[at]),
                None => "an empty name".into(),
            };
            return Err(FormatError::metadata(
                "joint_names",
                found,
                "a name a joint",
            ));
        }
        Ok(names)
    }

    fn some_joints(&mut self, name: &str, default: Vec<u8>) -> Result<Vec<u8>, FormatError> {
        if !self.arrays.has(name) {
            return Ok(default);
        }
        let array = self.arrays.take(name)?;
        let mut joints: Vec<u8> = Vec::new();
        for joint in array.integers(self.parent.len())? {
            let joint = joint as u8;
            if joints.contains(&joint) {
                return Err(FormatError::metadata(
                    name,
                    format!("{joint} twice"),
                    "each once",
                ));
            }
            joints.push(joint);
        }
        Ok(joints)
    }

    fn mean_hand(&mut self, name: &str) -> Result<[f64; 3 * HAND], FormatError> {
        if self.parent.len() != SMPL_X || !self.arrays.has(name) {
            return Ok([0.0; 3 * HAND]);
        }
        let array = self.arrays.take(name)?;
        array.expect_shape(&[3 * HAND])?;
        let numbers = array.floats()?;
        Ok(std::array::from_fn(|at| f64::from(numbers[at])))
    }

    fn hand_components(&mut self, name: &str) -> Result<Vec<[f64; 3 * HAND]>, FormatError> {
        if self.parent.len() != SMPL_X || !self.arrays.has(name) {
            return Ok(vec![]);
        }
        let array = self.arrays.take(name)?;
        let count = array.dimension(0)?;
        array.expect_shape(&[count, 3 * HAND])?;
        let numbers = array.floats()?;
        let rows = numbers.as_chunks::<{ 3 * HAND }>().0;
        Ok(rows.iter().map(|row| row.map(f64::from)).collect())
    }
}
