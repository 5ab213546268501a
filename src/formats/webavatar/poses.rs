//! `NAME_poses.json`: a list of frames, each with the axis-angle rotations of SMPL-X's joints and
//! what moves the body after skinning, a rotation Rh and a translation Th.

use super::skeleton::smpl_x;
use crate::{
    assumption::Assumption,
    capture::{Capture, Captured, LocalPose, UpAxis, check_size},
    json::bounded,
    smpl,
    smpl_joints::SMPL_X,
};
use effigy_core::{
    avatar::{Clip, Skeleton},
    io::file::{FormatError, excerpt},
};
use glam::{DMat3, DQuat, DVec3};
use serde::{
    Deserialize, Deserializer, Serialize,
    de::{
        DeserializeSeed, Error, IgnoredAny, MapAccess, SeqAccess, Visitor,
        value::SeqAccessDeserializer,
    },
};
use std::{borrow::Cow, fmt};

/// Frames a second where nobody says.
pub const POSES_RATE: f64 = 30.0;
/// Bytes of text that a joint's three numbers take at least, with their commas.
const LEAST_TEXT: usize = 6;
/// Numbers of the neutral expressions of frames before the first that has one.
const MAX_NEUTRAL: usize = 1 << 22;

#[derive(Serialize, Deserialize)]
struct PoseRecord {
    /// Whatever it is: frames follow one another.
    #[serde(deserialize_with = "any")]
    frame_id: usize,
    /// Axis-angle, radians; shape J, 3.
    #[serde(deserialize_with = "bounded")]
    pose: Vec<f64>,
    #[serde(rename = "Th")]
    translation: [f64; 3],
    #[serde(rename = "Rh")]
    rotation: Turn,
    #[serde(default)]
    expression: Option<Expression>,
}

/// The weights of an expression.
#[derive(Serialize, Deserialize)]
#[serde(transparent)]
struct Expression {
    #[serde(deserialize_with = "bounded")]
    weights: Vec<f32>,
}

fn any<'de, D: Deserializer<'de>>(deserializer: D) -> Result<usize, D::Error> {
    IgnoredAny::deserialize(deserializer).map(|_| 0)
}

/// A rotation, as rows of a matrix or as an axis times an angle.
#[derive(Serialize)]
#[serde(untagged)]
enum Turn {
    Matrix([[f64; 3]; 3]),
    Axis([f64; 3]),
}

/// A number, or a row of three.
enum NumberOrRow {
    Number(f64),
    Row([f64; 3]),
}

// Serde's own way to tell them apart reads whatever there is first, however long.
impl<'de> Deserialize<'de> for NumberOrRow {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Either;

        impl<'de> Visitor<'de> for Either {
            type Value = NumberOrRow;

            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("a number, or three")
            }

            fn visit_f64<E: Error>(self, number: f64) -> Result<NumberOrRow, E> {
                Ok(NumberOrRow::Number(number))
            }

            fn visit_i64<E: Error>(self, number: i64) -> Result<NumberOrRow, E> {
                Ok(NumberOrRow::Number(number as f64))
            }

            fn visit_u64<E: Error>(self, number: u64) -> Result<NumberOrRow, E> {
                Ok(NumberOrRow::Number(number as f64))
            }

            fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<NumberOrRow, A::Error> {
                <[f64; 3]>::deserialize(SeqAccessDeserializer::new(list)).map(NumberOrRow::Row)
            }
        }

        deserializer.deserialize_any(Either)
    }
}

impl<'de> Deserialize<'de> for Turn {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        match <[NumberOrRow; 3]>::deserialize(deserializer)? {
            [
                NumberOrRow::Number(x),
                NumberOrRow::Number(y),
                NumberOrRow::Number(z),
            ] => Ok(Self::Axis([x, y, z])),
            [
                NumberOrRow::Row(x),
                NumberOrRow::Row(y),
                NumberOrRow::Row(z),
            ] => Ok(Self::Matrix([x, y, z])),
            _ => Err(D::Error::custom("numbers beside rows of a rotation")),
        }
    }
}

impl Turn {
    /// None: it is no rotation.
    fn quaternion(&self) -> Option<DQuat> {
        match self {
            Self::Axis(axis) => Some(DQuat::from_scaled_axis(DVec3::from(*axis))),
            Self::Matrix(rows) => {
                let matrix = DMat3::from_cols_array_2d(rows).transpose();
                let turns = (matrix * matrix.transpose()).abs_diff_eq(DMat3::IDENTITY, 1e-3)
                    && matrix.determinant() > 0.0;
                turns.then(|| DQuat::from_mat3(&matrix).normalize())
            }
        }
    }
}

/// The frames of a file, joined as they are read: as text they are shorter.
struct PoseRecords<'a> {
    /// Of the root joint at rest.
    root: DVec3,
    clip: &'a mut Clip,
    /// What is wrong with a frame.
    fault: Option<FormatError>,
    /// Frames that the text has room for. Nothing is reserved before there is one.
    most: usize,
}

impl PoseRecords<'_> {
    fn add(&mut self, frame: &PoseRecord) -> Result<(), FormatError> {
        let clip = &mut *self.clip;
        let at = clip.translation.len();
        if at == 0 {
            clip.rotation.reserve(self.most * clip.joint.len());
            clip.translation.reserve(self.most);
        }
        let field = |name: &str| format!("[{at}].{name}");
        let numbers = 3 * clip.joint.len();
        if frame.pose.len() != numbers {
            let found = format!("{} numbers", frame.pose.len());
            return Err(FormatError::metadata(&field("pose"), found, numbers));
        }
        let expression = frame.expression.as_ref();
        let expression = expression.map_or(&[][..], |own| &own.weights[..]);
        if clip.expression_len == 0 && !expression.is_empty() {
            // Frames without an expression have a neutral one.
            clip.expression_len = expression.len();
            clip.expression = vec![0.0; neutral(at, expression.len())?];
            return self.add(frame);
        }
        if !expression.is_empty() && expression.len() != clip.expression_len {
            let found = format!("{} numbers", expression.len());
            return Err(FormatError::metadata(
                &field("expression"),
                found,
                clip.expression_len,
            ));
        }
        let Some(turn) = frame.rotation.quaternion() else {
            return Err(FormatError::metadata(
                &field("Rh"),
                "a matrix",
                "a rotation",
            ));
        };
        let rotations = frame.pose.chunks_exact(3);
        let mut rotations: Vec<DVec3> = rotations.map(DVec3::from_slice).collect();
        let hips = turn * DQuat::from_scaled_axis(rotations[0]);
        rotations[0] = hips.to_scaled_axis();
        // Rh and Th act on the posed body: on the root joint, which is at rest where it is.
        let translation = turn * self.root + DVec3::from(frame.translation) - self.root;
        clip.rotation
            .extend(rotations.iter().map(|r| r.as_vec3().to_array()));
        clip.translation.push(translation.as_vec3().to_array());
        let start = clip.expression.len();
        clip.expression.extend(expression);
        clip.expression.resize(start + clip.expression_len, 0.0);
        Ok(())
    }
}

/// Numbers of the expressions of the frames that had none: all of a file may be one that comes late.
fn neutral(frames: usize, expression: usize) -> Result<usize, FormatError> {
    let numbers = frames * expression;
    if numbers > MAX_NEUTRAL {
        return Err(FormatError::metadata(
            &format!("[{frames}].expression"),
            format!("{expression} numbers after {frames} frames without"),
            format!("at most {MAX_NEUTRAL} in all"),
        ));
    }
    Ok(numbers)
}

impl<'de> Visitor<'de> for &mut PoseRecords<'_> {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("a list of frames")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<(), A::Error> {
        while let Some(frame) = list.next_element()? {
            if let Err(fault) = self.add(&frame) {
                self.fault = Some(fault);
                return Err(A::Error::custom("a frame"));
            }
        }
        Ok(())
    }
}

/// Keys of a list's first entry, for messages.
fn first_keys(bytes: &[u8]) -> Vec<String> {
    /// Most that are named.
    const NAMED: usize = 8;

    struct Keys(Vec<String>);

    impl<'de> Visitor<'de> for &mut Keys {
        type Value = ();

        fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
            f.write_str("a list of objects")
        }

        fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<(), A::Error> {
            while let Some(key) = map.next_key::<Cow<str>>()? {
                if self.0.len() == NAMED {
                    return Err(A::Error::custom("enough"));
                }
                self.0.push(excerpt(&key));
                map.next_value::<IgnoredAny>()?;
            }
            Ok(())
        }

        fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<(), A::Error> {
            list.next_element_seed(self)?;
            Err(A::Error::custom("enough"))
        }
    }

    impl<'de> DeserializeSeed<'de> for &mut Keys {
        type Value = ();

        fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<(), D::Error> {
            deserializer.deserialize_any(self)
        }
    }

    let mut keys = Keys(vec![]);
    let mut text = serde_json::Deserializer::from_slice(bytes);
    // What is wrong with the list is known.
    text.deserialize_any(&mut keys).ok();
    keys.0
}

/// Reads a clip for an avatar of SMPL-X's skeleton. `rate`: frames a second, which the file does
/// not say.
///
/// # Errors
/// When it is not such a list, is empty, or a frame has other lengths than the rest.
pub fn read_poses(
    bytes: &[u8],
    name: &str,
    skeleton: &Skeleton,
    rate: f64,
) -> Result<Clip, FormatError> {
    let rest = skeleton.rest.first();
    let joints = SMPL_X.len();
    let most = bytes.len() / (LEAST_TEXT * joints) + 1;
    let mut clip = Clip {
        name: name.into(),
        credit: String::new(),
        rate,
        joint: SMPL_X.iter().map(|joint| joint.name.into()).collect(),
        rotation: vec![],
        translation: vec![],
        expression: vec![],
        expression_len: 0,
    };
    let mut frames = PoseRecords {
        root: rest.map_or(DVec3::ZERO, |rest| DVec3::from(rest.map(f64::from))),
        clip: &mut clip,
        most,
        fault: None,
    };
    let mut text = serde_json::Deserializer::from_slice(bytes);
    let read = text.deserialize_seq(&mut frames);
    if let Some(fault) = frames.fault {
        return Err(fault);
    }
    read.and_then(|()| text.end()).map_err(|error| {
        let found = match first_keys(bytes) {
            keys if keys.is_empty() => error.to_string(),
            keys => format!("a list of {}: {error}", keys.join(", ")),
        };
        let expected = "a list of frames: frame_id, pose of 165 numbers, Th and Rh of 3; of EasyMocap, \
                        which writes a list of people a frame, one person's frames in such a list";
        FormatError::container(found, expected)
    })?;
    if clip.translation.is_empty() {
        return Err(FormatError::container("no pose", "at least one"));
    }
    // The same rules as for a clip of Effigy's own.
    clip.check()?;
    Ok(clip)
}

/// Reads poses for avatars of other skeletons, with an average body for the rest pose. `rate`:
/// frames a second; None: 30.
///
/// # Errors
/// Those of [`read_poses`].
pub fn capture_poses(bytes: &[u8], rate: Option<f64>) -> Result<Captured, FormatError> {
    let mut assumptions = vec![Assumption {
        what: "rest pose",
        taken: "a T-pose of an average body".into(),
        because: "poses are beside a model that has the skeleton".into(),
    }];
    if rate.is_none() {
        assumptions.push(Assumption {
            what: "frames a second",
            taken: POSES_RATE.to_string(),
            because: "the file does not say".into(),
        });
    }
    let joints = smpl::average_joints();
    let mut rest: Vec<DVec3> = vec![];
    for joint in &joints {
        let parent = joint.parent.map_or(DVec3::ZERO, |parent| rest[parent]);
        rest.push(parent + joint.offset);
    }
    let rest = rest.iter().map(|place| place.as_vec3().to_array());
    let skeleton = smpl_x(rest.collect());
    let clip = read_poses(bytes, "", &skeleton, rate.unwrap_or(POSES_RATE))?;
    // The clip is there as well.
    check_size(clip.frames(), 3 * joints.len() / 2, bytes.len())?;
    let local = clip.rotation.iter().enumerate().map(|(at, axis)| {
        let joint = at % joints.len();
        let moved = clip.translation[at / joints.len()].map(f64::from);
        let moved = if joint == 0 {
            DVec3::from(moved)
        } else {
            DVec3::ZERO
        };
        LocalPose::new(
            DQuat::from_scaled_axis(DVec3::from(axis.map(f64::from))),
            joints[joint].offset + moved,
        )
    });
    let local = local.collect();
    Ok(Captured {
        capture: Capture {
            joints,
            rate: clip.rate,
            local,
            unit: Some(1.0),
            up: UpAxis::Open,
            model_rest: true,
            expression: clip.expression,
            expression_len: clip.expression_len,
        },
        assumptions,
    })
}

/// Writes the frames of a clip that moves an avatar, as [`read_poses`] reads them. Joints that the
/// clip lacks stay at rest.
pub fn write_poses(clip: &Clip) -> String {
    let place = |name: &str| clip.joint.iter().position(|joint| joint == name);
    let places: Vec<Option<usize>> = SMPL_X.iter().map(|joint| place(joint.name)).collect();
    let frame = |at: usize| {
        let pose = clip.frame(at);
        let rotation = |place: &Option<usize>| place.map_or(DVec3::ZERO, |k| pose.rotation[k]);
        PoseRecord {
            frame_id: at,
            pose: places
                .iter()
                .flat_map(|place| rotation(place).to_array())
                .collect(),
            translation: pose.translation.to_array(),
            rotation: Turn::Matrix(DMat3::IDENTITY.to_cols_array_2d()),
            expression: (clip.expression_len > 0).then(|| Expression {
                weights: pose.expression.iter().map(|&e| e as f32).collect(),
            }),
        }
    };
    let frames: Vec<PoseRecord> = (0..clip.frames()).map(frame).collect();
    serde_json::to_string(&frames).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn skeleton() -> Skeleton {
        smpl_x((0..55).map(|k| [0.1, 0.9 + 0.01 * k as f32, 0.0]).collect())
    }

    #[test]
    fn the_global_turn_moves_every_joint_as_one() {
        let mut pose = vec![0.0; 165];
        pose[1] = 0.4;
        pose[3 * 18] = 0.7;
        let text = serde_json::json!([{
            "frame_id": 3, "pose": pose, "Th": [0.5, -0.2, 3.0],
            "Rh": [[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]], "expression": null,
        }]);
        let skeleton = skeleton();
        let clip = read_poses(text.to_string().as_bytes(), "a", &skeleton, 30.0).expect("poses");
        let turned = skeleton.joints(&clip.frame(0));
        let mut still = clip.frame(0);
        still.rotation[0] = DVec3::new(0.0, 0.4, 0.0);
        still.translation = DVec3::ZERO;
        for (turned, still) in turned.iter().zip(skeleton.joints(&still)) {
            let x = still.translation;
            let expected = DVec3::new(x.z, x.y, -x.x) + DVec3::new(0.5, -0.2, 3.0);
            assert!(turned.translation.distance(expected) < 1e-6);
        }
    }

    #[test]
    fn a_clip_that_was_written_is_read_again() {
        let clip = effigy_demo::clip().expect("the demo's clip");
        let text = write_poses(&clip);
        let read = read_poses(text.as_bytes(), "a", &skeleton(), clip.rate).expect("poses");
        assert_eq!(read.frames(), clip.frames());
        let map = clip.map_to(&skeleton());
        let frame = clip.frames() / 2;
        let [a, b] = [clip.frame(frame), read.frame(frame)];
        assert!(a.translation.distance(b.translation) < 1e-6);
        for (own, place) in b.rotation.iter().zip(map) {
            let expected = place.map_or(DVec3::ZERO, |place| a.rotation[place]);
            assert!(own.distance(expected) < 1e-6, "{own} {expected}");
        }
    }

    #[test]
    fn a_capture_of_poses_moves_as_their_clip_does() {
        let clip = effigy_demo::clip().expect("the demo's clip");
        let text = write_poses(&clip);
        let captured = capture_poses(text.as_bytes(), None).expect("a capture");
        let capture = captured.capture;
        assert_eq!((capture.frames(), capture.rate), (clip.frames(), 30.0));
        assert_eq!(captured.assumptions.len(), 2);
        let rest: Vec<[f32; 3]> = capture
            .rest()
            .iter()
            .map(|joint| joint.translation.as_vec3().to_array())
            .collect();
        let skeleton = smpl_x(rest);
        let read = read_poses(text.as_bytes(), "a", &skeleton, 30.0).expect("poses");
        let frame = clip.frames() / 2;
        let expected = skeleton.joints(&read.frame(frame));
        for (own, expected) in capture.world(frame).iter().zip(expected) {
            assert!(own.translation.distance(expected.translation) < 1e-5);
        }
    }

    #[test]
    fn faults_name_the_frame_and_field() {
        let fault = |text: &str| {
            let error = read_poses(text.as_bytes(), "a", &skeleton(), 30.0);
            error.map_or_else(|error| error.to_string(), |_| "none".into())
        };
        assert!(fault("[]").contains("no pose"));
        let short = r#"[{"frame_id":0,"pose":[1.0],"Th":[0,0,0],"Rh":[0,0,0]}]"#;
        assert!(
            fault(short).contains("`[0].pose` found 1 numbers"),
            "{}",
            fault(short)
        );
        let zeros = vec!["0"; 165].join(",");
        let flat = format!(
            r#"[{{"frame_id":0,"pose":[{zeros}],"Th":[0,0,0],"Rh":[[0,0,0],[0,0,0],[0,0,0]]}}]"#
        );
        assert!(fault(&flat).contains("`[0].Rh`"), "{}", fault(&flat));
        let easy = r#"[{"id":0,"Rh":[[0,0,0]],"Th":[[0,0,3]],"poses":[[0,0,0]]}]"#;
        let said = fault(easy);
        assert!(said.contains("a list of id, Rh, Th, poses"), "{said}");
        assert!(said.contains("EasyMocap"), "{said}");
    }
}
