//! `smpl_params.npz`: the pose of every frame.
//!
//! Of SMPL-X and SMPL: `global_orient` F, 3; `body_pose` F, 63 (SMPL: 69); `transl` F, 3; `betas` 1,
//! B; of SMPL-X also `jaw_pose`, `leye_pose`, `reye_pose` F, 3; `left_hand_pose`, `right_hand_pose`
//! F, 45, or fewer numbers, which count the model's components; `expression` F, E. Of any skeleton: `poses` F, J, 3 in place of all rotations. Arrays with
//! one row hold it for every frame; all but the translation and the body's pose may be absent.
//!
//! Rotations are axis-angle, radians, relative to the parent. The models add `transl` after the root
//! has turned about its joint J0: x' = R (x − J0) + J0 + transl. That is a [`Pose`] with `transl` as
//! its translation, since the root's matrix is `T(translation + rest) R`.

use crate::{
    error::{CaptureError, content, fault, read_bytes},
    limits,
};
use effigy_core::{
    avatar::{
        Pose,
        limits::{EXPRESSION, JOINTS, LENGTH},
    },
    io::file::FormatError,
};
use effigy_formats::{
    assumption::Assumption,
    npz::{Npz, NpzWriter},
};
use glam::DVec3;
use std::{ops::RangeInclusive, path::Path};

/// The file's name.
pub const FILE: &str = "smpl_params.npz";
/// Joints of SMPL-X and of SMPL.
pub const SMPL_X: usize = 55;
pub const SMPL: usize = 24;
/// Rotations beyond this are a fault, radians.
const MAX_ROTATION: f64 = 1000.0;
/// Every array that is read.
const NAMES: [&str; 12] = [
    "poses",
    "global_orient",
    "body_pose",
    "jaw_pose",
    "leye_pose",
    "reye_pose",
    "left_hand_pose",
    "right_hand_pose",
    "transl",
    "betas",
    "expression",
    "flat_hand_mean",
];
/// First joints of both hands, of SMPL-X.
pub const HANDS: [usize; 2] = [25, 40];
/// Joints of a hand.
pub const HAND: usize = 15;

/// Rows of numbers, one for every frame or one for all.
#[derive(Debug)]
struct FrameRows {
    width: usize,
    numbers: Vec<f64>,
}

/// Rotations of consecutive joints.
#[derive(Debug)]
struct JointRotations {
    first: usize,
    table: FrameRows,
    /// Which of the [`Hands`] these are components of; None: they are rotations.
    components: Option<usize>,
}

/// What a body model has for hands, the left and the right.
pub struct Hands {
    /// Rotations at rest of files without flat hands.
    pub mean: [[f64; 3 * HAND]; 2],
    /// What a hand's numbers count where they are no rotations: changes of all its rotations. Empty
    /// where the model lacks them.
    pub components: [Vec<[f64; 3 * HAND]>; 2],
}

/// The poses of a file.
#[derive(Debug)]
pub struct CapturePoses {
    parts: Vec<JointRotations>,
    translation: FrameRows,
    expression: Option<FrameRows>,
    /// The body's shape, where the file has it.
    pub betas: Vec<f64>,
    /// False: hands turn from the model's mean hand.
    pub flat_hands: bool,
    /// Number of frames.
    pub frames: usize,
    joints: usize,
}

impl FrameRows {
    fn rows(&self) -> usize {
        self.numbers.len() / self.width
    }

    fn row(&self, frame: usize) -> &[f64] {
        let at = if self.rows() == 1 { 0 } else { frame };
        &self.numbers[at * self.width..][..self.width]
    }
}

/// Whether a number is finite and no further from 0 than `most`.
fn is_within(number: f64, most: f64) -> bool {
    number.abs() <= most
}

fn metadata(name: &str, found: impl std::fmt::Display, expected: impl ToString) -> FormatError {
    FormatError::metadata(name, found, expected)
}

/// An array as rows of so many numbers; None where the file lacks it.
fn table(
    arrays: &mut Npz,
    name: &str,
    widths: RangeInclusive<usize>,
) -> Result<Option<FrameRows>, FormatError> {
    if !arrays.has(name) {
        return Ok(None);
    }
    let array = arrays.take(name)?;
    let width = match array.shape() {
        // A single row may come without its dimension.
        [numbers] => *numbers,
        shape => shape.iter().skip(1).product(),
    };
    let fits = widths.contains(&width);
    let numbers = if fits { array.numbers() } else { vec![] };
    if numbers.is_empty() || numbers.len() / width > limits::FRAMES {
        let shape = array.shape();
        let most = widths.end();
        return Err(metadata(
            name,
            format!("the shape {shape:?}"),
            format!("1 to {} rows of {most} numbers", limits::FRAMES),
        ));
    }
    Ok(Some(FrameRows { width, numbers }))
}

/// An array as rows of its last dimension.
fn rows(arrays: &mut Npz, name: &str, most: usize) -> Result<Option<FrameRows>, FormatError> {
    if !arrays.has(name) {
        return Ok(None);
    }
    let array = arrays.take(name)?;
    let shape = array.shape().to_vec();
    let width = shape.last().copied().unwrap_or_default();
    let numbers = array.numbers();
    if numbers.is_empty() {
        return Ok(None);
    }
    if shape.len() > 2 || width > most || numbers.len() / width > limits::FRAMES {
        return Err(metadata(
            name,
            format!("the shape {shape:?}"),
            format!("rows of at most {most} numbers"),
        ));
    }
    Ok(Some(FrameRows { width, numbers }))
}

impl CapturePoses {
    /// The poses of a skeleton of `joints` joints in a capture's folder.
    pub fn read(folder: &Path, joints: usize) -> Result<Self, CaptureError> {
        let file = folder.join(FILE);
        let bytes = read_bytes(&file, limits::ARCHIVE)?;
        Self::parse(&bytes, joints).map_err(|error| fault(&file, error))
    }

    fn parse(bytes: &[u8], joints: usize) -> Result<Self, FormatError> {
        let wanted = |name: &str| NAMES.contains(&name);
        let mut arrays = Npz::some_from_bytes(bytes, 64 << 20, wanted)?;
        let parts = if arrays.has("poses") {
            table(&mut arrays, "poses", 3 * joints..=3 * joints)?
                .map(|table| JointRotations {
                    first: 0,
                    table,
                    components: None,
                })
                .into_iter()
                .collect()
        } else {
            smpl_parts(&mut arrays, joints)?
        };
        let Some(translation) = table(&mut arrays, "transl", 3..=3)? else {
            return Err(metadata("transl", "nothing", "the root's translations"));
        };
        // More than anyone's expression has is left out.
        let expression = rows(&mut arrays, "expression", 1000)?;
        let betas = rows(&mut arrays, "betas", 1000)?.map(|table| table.row(0).to_vec());
        let betas = betas.unwrap_or_default();
        if let Some(odd) = betas.iter().find(|beta| !is_within(**beta, 100.0)) {
            return Err(metadata("betas", odd, "numbers of a body's shape"));
        }
        let flat_hands = match arrays.has("flat_hand_mean") {
            true => arrays.take("flat_hand_mean")?.numbers().first() != Some(&0.0),
            false => true,
        };
        let tables = || {
            let parts = parts.iter().map(|part: &JointRotations| &part.table);
            parts.chain([&translation]).chain(&expression)
        };
        let frames = tables().map(FrameRows::rows).max().unwrap_or_default();
        if let Some(odd) = tables().find(|table| table.rows() != frames && table.rows() != 1) {
            return Err(FormatError::container(
                format!("arrays of {frames} and of {} frames", odd.rows()),
                "as many of each",
            ));
        }
        Ok(Self {
            parts,
            translation,
            expression,
            betas,
            flat_hands,
            frames,
            joints,
        })
    }

    /// Length of an expression.
    pub fn expression(&self) -> usize {
        self.expression
            .as_ref()
            .map_or(0, |table| table.width.min(EXPRESSION))
    }

    /// What is taken where the file's hands count components that the model lacks.
    pub fn assumptions(&self, hands: &Hands) -> Vec<Assumption> {
        let lacks = |part: &JointRotations| {
            part.components
                .is_some_and(|of| hands.components[of].is_empty())
        };
        let found = self.parts.iter().find(|part| lacks(part));
        let assumption = |part: &JointRotations| Assumption {
            what: "fingers",
            taken: "straight".into(),
            because: format!(
                "hands have {} numbers, which count components that the body model lacks: \
                 hands_componentsl and hands_componentsr",
                part.table.width
            ),
        };
        found.map(assumption).into_iter().collect()
    }

    /// A frame's pose. `hands`: of the body model.
    ///
    /// # Errors
    /// When a number is not finite, or far from any pose.
    pub fn pose(&self, frame: usize, hands: &Hands) -> Result<Pose, FormatError> {
        let mut pose = Pose::rest(self.joints, 0);
        for part in &self.parts {
            let row = part.table.row(frame);
            let mut sum = [0.0; 3 * HAND];
            let numbers = match part.components {
                None => row,
                Some(of) => {
                    for (component, weight) in hands.components[of].iter().zip(row) {
                        let pairs = sum.iter_mut().zip(component);
                        pairs.for_each(|(sum, number)| *sum += weight * number);
                    }
                    &sum
                }
            };
            for (joint, turn) in numbers.as_chunks::<3>().0.iter().enumerate() {
                pose.rotation[part.first + joint] = DVec3::from(*turn);
            }
        }
        if !self.flat_hands && self.joints == SMPL_X {
            for (first, mean) in HANDS.into_iter().zip(&hands.mean) {
                for (joint, turn) in mean.as_chunks::<3>().0.iter().enumerate() {
                    pose.rotation[first + joint] += DVec3::from(*turn);
                }
            }
        }
        let row = self.translation.row(frame);
        pose.translation = DVec3::new(row[0], row[1], row[2]);
        if let Some(table) = &self.expression {
            pose.expression = table.row(frame)[..self.expression()].to_vec();
        }
        let far = |v: &DVec3, most: f64| !v.to_array().iter().all(|x| is_within(*x, most));
        if let Some(joint) = pose.rotation.iter().position(|v| far(v, MAX_ROTATION)) {
            let found = format!("{} at joint {joint}", pose.rotation[joint]);
            return Err(metadata("rotation", found, "radians"));
        }
        if far(&pose.translation, LENGTH) {
            let expected = "metres; millimetres are to be divided by 1000";
            return Err(metadata("transl", pose.translation, expected));
        }
        if let Some(odd) = pose.expression.iter().find(|e| !is_within(**e, 1e3)) {
            return Err(metadata("expression", odd, "numbers of an expression"));
        }
        Ok(pose)
    }
}

/// Rotations in SMPL's and SMPL-X's arrays.
fn smpl_parts(arrays: &mut Npz, joints: usize) -> Result<Vec<JointRotations>, FormatError> {
    struct SmplArray {
        name: &'static str,
        first: usize,
        joints: usize,
        needed: bool,
    }
    let known = |name, first, joints, needed| SmplArray {
        name,
        first,
        joints,
        needed,
    };
    let names = match joints {
        SMPL => vec![
            known("global_orient", 0, 1, true),
            known("body_pose", 1, 23, true),
        ],
        SMPL_X => vec![
            known("global_orient", 0, 1, true),
            known("body_pose", 1, 21, true),
            known("jaw_pose", 22, 1, false),
            known("leye_pose", 23, 1, false),
            known("reye_pose", 24, 1, false),
            known("left_hand_pose", HANDS[0], HAND, false),
            known("right_hand_pose", HANDS[1], HAND, false),
        ],
        _ => {
            return Err(metadata(
                "poses",
                "nothing",
                format!("frames of {joints} joints, which are not SMPL-X's {SMPL_X}"),
            ));
        }
    };
    let mut parts = Vec::new();
    for SmplArray {
        name,
        first,
        joints,
        needed,
    } in names
    {
        let hand = HANDS.iter().position(|&hand| hand == first);
        let all = 3 * joints;
        let fewest = if hand.is_some() { 1 } else { all };
        match table(arrays, name, fewest..=all)? {
            Some(table) => parts.push(JointRotations {
                first,
                components: hand.filter(|_| table.width < all),
                table,
            }),
            None if needed => {
                return Err(metadata(name, "nothing", "rotations, or an array `poses`"));
            }
            None => {}
        }
    }
    Ok(parts)
}

/// The file of some poses, each with `joints` rotations and `expression` numbers; row k is frame k.
pub fn encode(poses: &[&Pose], joints: usize, expression: usize) -> Result<Vec<u8>, String> {
    let mut rotations = Vec::with_capacity(3 * joints * poses.len());
    let mut expressions = Vec::with_capacity(expression * poses.len());
    for pose in poses {
        for joint in 0..joints {
            let turn = pose.rotation.get(joint).copied().unwrap_or_default();
            rotations.extend(turn.to_array());
        }
        let number = |k: usize| pose.expression.get(k).copied().unwrap_or_default();
        expressions.extend((0..expression).map(number));
    }
    let translations: Vec<f64> = poses
        .iter()
        .flat_map(|pose| pose.translation.to_array())
        .collect();
    let frames = poses.len();
    let mut file = NpzWriter::new();
    let added = file
        .add("poses", &[frames, joints, 3], &rotations)
        .and_then(|()| file.add("transl", &[frames, 3], &translations))
        .and_then(|()| file.add("expression", &[frames, expression], &expressions));
    added
        .and_then(|()| file.finish())
        .map_err(|error| error.to_string())
}

/// Fails unless a skeleton has a number of joints that any avatar may have.
pub fn check_joints(file: &Path, joints: usize) -> Result<(), CaptureError> {
    if (1..=JOINTS).contains(&joints) {
        return Ok(());
    }
    let found = format!("{joints} joints");
    Err(content(file, found, format!("1 to {JOINTS}")))
}

#[cfg(test)]
mod tests {
    use super::*;
    use effigy_core::avatar::Skeleton;
    use glam::{DMat3, DQuat};

    fn file(arrays: &[(&str, &[usize], &[f64])]) -> Vec<u8> {
        let mut file = NpzWriter::new();
        for (name, shape, numbers) in arrays {
            file.add(name, shape, numbers).expect("added");
        }
        file.finish().expect("an archive")
    }

    fn hands(mean: [[f64; 3 * HAND]; 2]) -> Hands {
        Hands {
            mean,
            components: [vec![], vec![]],
        }
    }

    /// The ten arrays for two frames, all numbers different.
    fn smpl_x() -> Vec<u8> {
        let wave = |count: usize, phase: f64| -> Vec<f64> {
            (0..count)
                .map(|at| 0.5 * (phase + at as f64).sin())
                .collect()
        };
        file(&[
            ("global_orient", &[2, 3], &wave(6, 0.1)),
            ("body_pose", &[2, 63], &wave(126, 0.2)),
            ("jaw_pose", &[2, 3], &wave(6, 0.3)),
            ("leye_pose", &[2, 3], &wave(6, 0.4)),
            ("reye_pose", &[2, 3], &wave(6, 0.5)),
            ("left_hand_pose", &[2, 45], &wave(90, 0.6)),
            ("right_hand_pose", &[2, 45], &wave(90, 0.7)),
            ("expression", &[2, 10], &wave(20, 0.8)),
            ("transl", &[2, 3], &wave(6, 0.9)),
            ("betas", &[1, 10], &wave(10, 1.0)),
        ])
    }

    #[test]
    fn smpl_xs_arrays_take_their_joints() {
        let poses = CapturePoses::parse(&smpl_x(), SMPL_X).expect("poses");
        assert_eq!(
            (poses.frames, poses.expression(), poses.betas.len()),
            (2, 10, 10)
        );
        let pose = poses.pose(1, &hands([[0.0; 45]; 2])).expect("a pose");
        let of = |at: usize, phase: f64| 0.5 * (phase + at as f64).sin();
        assert_eq!(pose.rotation[0].x, of(3, 0.1));
        assert_eq!(pose.rotation[21].z, of(125, 0.2));
        assert_eq!(pose.rotation[22].y, of(4, 0.3));
        assert_eq!(pose.rotation[24].x, of(3, 0.5));
        assert_eq!(pose.rotation[25].x, of(45, 0.6));
        assert_eq!(pose.rotation[54].z, of(89, 0.7));
    }

    #[test]
    fn the_root_turns_about_its_joint_before_transl_is_added() {
        let poses = CapturePoses::parse(&smpl_x(), SMPL_X).expect("poses");
        let pose = poses.pose(0, &hands([[0.0; 45]; 2])).expect("a pose");
        let rest = DVec3::new(0.01, -0.35, 0.02);
        let skeleton = Skeleton {
            name: vec!["root".into()],
            parent: vec![None],
            rest: vec![rest.as_vec3().to_array()],
            canonical: vec![[0.0; 3]],
        };
        let rest = DVec3::from(skeleton.rest[0].map(f64::from));
        let matrix = skeleton.matrices(&pose)[0];
        let turn = DMat3::from_quat(DQuat::from_scaled_axis(pose.rotation[0]));
        let point = DVec3::new(0.3, 1.1, -0.2);
        let expected = turn * (point - rest) + rest + pose.translation;
        assert!(matrix.transform_point3(point).distance(expected) < 1e-12);
    }

    #[test]
    fn one_row_serves_every_frame_and_hands_may_turn_from_a_mean() {
        let bytes = file(&[
            ("global_orient", &[3], &[0.1, 0.2, 0.3]),
            ("body_pose", &[2, 63], &[0.0; 126]),
            ("left_hand_pose", &[1, 45], &[0.25; 45]),
            ("transl", &[1, 3], &[1.0, 2.0, 3.0]),
            ("flat_hand_mean", &[], &[0.0]),
        ]);
        let poses = CapturePoses::parse(&bytes, SMPL_X).expect("poses");
        let pose = poses
            .pose(1, &hands([[0.5; 45], [0.125; 45]]))
            .expect("a pose");
        assert_eq!(pose.rotation[0], DVec3::new(0.1, 0.2, 0.3));
        assert_eq!(pose.rotation[30], DVec3::splat(0.75));
        assert_eq!(pose.rotation[54], DVec3::splat(0.125));
    }

    #[test]
    fn hands_may_count_the_models_components() {
        let bytes = file(&[
            ("global_orient", &[1, 3], &[0.0; 3]),
            ("body_pose", &[1, 63], &[0.0; 63]),
            ("left_hand_pose", &[2, 2], &[0.0, 0.0, 2.0, -1.0]),
            ("right_hand_pose", &[1, 1], &[3.0]),
            ("transl", &[2, 3], &[0.0; 6]),
            ("flat_hand_mean", &[], &[0.0]),
        ]);
        let poses = CapturePoses::parse(&bytes, SMPL_X).expect("poses");
        let row = |of: fn(usize) -> f64| std::array::from_fn(of);
        let model = Hands {
            mean: [[0.5; 45]; 2],
            components: [
                vec![row(|at| at as f64), [0.25; 45], [9.0; 45]],
                vec![[1.0; 45]],
            ],
        };
        assert_eq!(poses.assumptions(&model), []);
        let pose = poses.pose(1, &model).expect("a pose");
        // Twice 3, 4, 5 less a quarter, from the mean.
        assert_eq!(pose.rotation[26], DVec3::new(6.25, 8.25, 10.25));
        assert_eq!(pose.rotation[54], DVec3::splat(3.5));
        let bare = hands([[0.5; 45]; 2]);
        assert!(poses.assumptions(&bare)[0].because.contains("2 numbers"));
        assert_eq!(
            poses.pose(1, &bare).expect("a pose").rotation[26],
            DVec3::splat(0.5)
        );
    }

    #[test]
    fn faults_name_the_array() {
        let parse = |arrays: &[(&str, &[usize], &[f64])], joints| {
            CapturePoses::parse(&file(arrays), joints)
        };
        let error = |arrays: &[(&str, &[usize], &[f64])], joints| {
            parse(arrays, joints).expect_err("a fault").to_string()
        };
        let transl = ("transl", &[2, 3][..], &[0.0; 6][..]);
        assert!(error(&[transl], 7).contains("frames of 7 joints"));
        assert!(error(&[transl], SMPL_X).contains("global_orient"));
        assert!(error(&[("poses", &[2, 7, 3], &[0.0; 42])], 7).contains("transl"));
        let long = ("left_hand_pose", &[2, 46][..], &[0.0; 92][..]);
        let root = ("global_orient", &[2, 3][..], &[0.0; 6][..]);
        let body = ("body_pose", &[2, 63][..], &[0.0; 126][..]);
        assert!(error(&[root, body, long, transl], SMPL_X).contains("rows of 45"));
        assert!(error(&[("poses", &[3, 1, 3], &[0.0; 9]), transl], 1).contains("3 and of 2"));
        let odd = [0.0, f64::NAN, 0.0, 0.0, 0.0, 1e9];
        let poses = parse(&[("poses", &[2, 1, 3], &odd), transl], 1).expect("poses");
        for (frame, word) in [(0, "NaN"), (1, "1000000000")] {
            let error = poses
                .pose(frame, &hands([[0.0; 45]; 2]))
                .expect_err("no pose")
                .to_string();
            assert!(error.contains(word), "{error}");
        }
    }
}
