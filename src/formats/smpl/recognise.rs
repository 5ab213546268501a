//! Which program wrote a set of arrays, told by their names.

use super::{
    body::Family,
    fields::{Fields, Table},
    timeline::timeline,
    track::{Anchor, ChainRotations, Track},
};
use crate::{assumption::Assumption, capture::UpAxis, smpl_joints::BODY};
use effigy_core::{avatar::limits, io::file::FormatError};
use glam::DVec3;
use std::{ops::Range, rc::Rc};

/// Numbers of a row of SMPL's rotations: 22 joints, 24 with SMPL's hands, 52 of SMPL-H, 55 of
/// SMPL-X.
const WIDTHS: [usize; 4] = [66, 72, 156, 165];
/// Numbers of a row of 24 matrices.
const MATRICES: usize = 24 * 9;
const JAW: usize = 22;
const LEFT_EYE: usize = 23;
const LEFT_HAND: Range<usize> = 25..40;
const RIGHT_HAND: Range<usize> = 40..55;
/// AIST++'s frames a second, of its videos.
const AIST_RATE: f64 = 60.0;
/// Most numbers of an expression: SMPL-X has 100.
const MAX_EXPRESSION: usize = 256;

/// Names of the array of all joints' rotations, in axes that follow from the motion.
const POSES: [&str; 4] = ["poses", "fullpose", "full_pose", "thetas"];
/// The same of people before a camera.
const CAMERA_POSES: [&str; 1] = ["pose"];
const AIST_POSES: [&str; 1] = ["smpl_poses"];
const WORLD_POSES: [&str; 1] = ["pose_world"];
const ROMP_POSES: [&str; 1] = ["smpl_thetas"];
/// The same as matrices.
const POSE_MATRICES: [&str; 2] = ["pred_rotmat", "pred_thetas"];
/// The body's rotations without the root's, and the root's.
const BODY_POSE: [&str; 3] = ["body_pose", "pose_body", "poses_body"];
const ROOT: [&str; 4] = ["global_orient", "root_orient", "root_pose", "poses_root"];
/// Names of the place in metres.
const PLACE: [&str; 9] = [
    "trans",
    "transl",
    "translation",
    "smpl_trans",
    "trans_world",
    "cam_trans",
    "pred_trans",
    "global_t",
    "root_trans",
];
const JAW_POSE: [&str; 2] = ["jaw_pose", "pose_jaw"];
const LEFT_EYE_POSE: [&str; 1] = ["leye_pose"];
const RIGHT_EYE_POSE: [&str; 1] = ["reye_pose"];
/// Both eyes.
const EYE_POSES: [&str; 1] = ["pose_eye"];
const LEFT_HAND_POSE: [&str; 2] = ["left_hand_pose", "lhand_pose"];
const RIGHT_HAND_POSE: [&str; 2] = ["right_hand_pose", "rhand_pose"];
/// Both hands.
const HAND_POSES: [&str; 1] = ["pose_hand"];
const EXPRESSION: [&str; 3] = ["expression", "expressions", "expr"];
const RATE: [&str; 5] = [
    "mocap_frame_rate",
    "mocap_framerate",
    "fps",
    "frame_rate",
    "framerate",
];
/// Numbers of the frames of a video that rows are of.
const FRAMES: [&str; 3] = ["frame_ids", "frame_id", "frame"];
/// A turn of the whole posed body.
const TURN: &str = "Rh";
const SCALING: &str = "smpl_scaling";
const FLAT: &str = "flat_hand_mean";

/// Names of rotations, by one of which motion is known.
const ROTATIONS: [&[&str]; 7] = [
    &POSES,
    &CAMERA_POSES,
    &AIST_POSES,
    &WORLD_POSES,
    &ROMP_POSES,
    &POSE_MATRICES,
    &BODY_POSE,
];
/// Names of everything else.
const OTHERS: [&[&str]; 13] = [
    &ROOT,
    &PLACE,
    &JAW_POSE,
    &LEFT_EYE_POSE,
    &RIGHT_EYE_POSE,
    &EYE_POSES,
    &LEFT_HAND_POSE,
    &RIGHT_HAND_POSE,
    &HAND_POSES,
    &EXPRESSION,
    &RATE,
    &FRAMES,
    &[TURN, SCALING, FLAT],
];

/// What a file with motion has.
pub const EXPECTED: &str = "SMPL's parameters: poses, or body_pose and global_orient (HuMoR's pose_body and root_orient), \
                            or what ROMP, VIBE, WHAM or TRAM write";

/// Whether an array of this name is read.
pub fn is_asked(name: &str) -> bool {
    ROTATIONS
        .iter()
        .chain(&OTHERS)
        .any(|names| names.contains(&name))
}

/// The name of the first array of rotations.
pub fn rotations(fields: &Fields) -> Option<&'static str> {
    ROTATIONS.iter().find_map(|names| fields.find(names))
}

/// Whether arrays are a person's motion.
pub fn is_motion(fields: &Fields) -> bool {
    rotations(fields).is_some()
}

fn need(table: Option<Table>, name: &str, fields: &Fields) -> Result<Table, FormatError> {
    table.ok_or_else(|| {
        FormatError::metadata(name, "nothing", format!("it beside {}", fields.describe()))
    })
}

/// The upward axis of a camera's axes: y points down.
fn camera(track: &mut Track, what: &str) {
    track.up = UpAxis::Said(DVec3::NEG_Y);
    track.assumptions.push(Assumption {
        what: "axes",
        taken: "the camera's, which is taken to be level".into(),
        because: what.into(),
    });
}

impl Track {
    /// A motion of these rotations alone.
    pub fn of_parts(family: Family, parts: Vec<ChainRotations>) -> Self {
        Self {
            family,
            parts,
            translation: None,
            anchor: Anchor::Origin,
            expression: None,
            timeline: None,
            rate: None,
            up: UpAxis::Open,
            assumptions: vec![],
        }
    }
}

/// A track of whole rows of rotations.
fn rows(
    fields: &mut Fields,
    names: &[&'static str],
    widths: &[usize],
) -> Result<Track, FormatError> {
    if fields.has(TURN) {
        return Err(FormatError::container(
            format!(
                "{}, as EasyMocap and ZJU-MoCap write each frame",
                fields.describe()
            ),
            "the frames in one file: AMASS's poses and trans, or a list of frame_id, pose, Th and Rh",
        ));
    }
    let poses = fields.table(names, widths)?;
    let poses = need(poses, names[0], fields)?;
    let smpl_x = poses.width == 165;
    let poses = Rc::new(poses);
    let parts = if poses.width == 156 {
        let hands = ChainRotations::axes(poses.clone(), BODY, LEFT_HAND.start..RIGHT_HAND.end);
        vec![ChainRotations::axes(poses, 0, 0..BODY), hands]
    } else {
        let joints = if smpl_x { RIGHT_HAND.end } else { BODY };
        vec![ChainRotations::axes(poses, 0, 0..joints)]
    };
    let family = if smpl_x { Family::SmplX } else { Family::Smpl };
    let mut track = Track::of_parts(family, parts);
    expression(fields, &mut track)?;
    Ok(track)
}

/// The motion that arrays are.
pub fn recognise(fields: &mut Fields) -> Result<Track, FormatError> {
    let has = |names: &[&'static str]| fields.find(names).is_some();
    // In others an array of such a name may be anything.
    let seen_by_camera = [&POSE_MATRICES[..], &ROMP_POSES, &WORLD_POSES, &CAMERA_POSES]
        .into_iter()
        .any(has);
    let mut track = if has(&POSE_MATRICES) {
        matrices(fields)?
    } else if has(&ROMP_POSES) {
        let mut track = rows(fields, &ROMP_POSES, &[72])?;
        camera(&mut track, "ROMP's results are seen from the camera");
        track
    } else if has(&AIST_POSES) {
        return aist(fields);
    } else if has(&WORLD_POSES) {
        let mut track = rows(fields, &WORLD_POSES, &WIDTHS)?;
        track.translation = fields.table(&["trans_world"], &[3])?;
        track.anchor = Anchor::Hips;
        track.up = UpAxis::Said(DVec3::Y);
        track
    } else if has(&CAMERA_POSES) {
        let mut track = rows(fields, &CAMERA_POSES, &WIDTHS)?;
        camera(&mut track, "the file has no motion in the world");
        track
    } else if has(&POSES) {
        let mut track = rows(fields, &POSES, &WIDTHS)?;
        track.up = UpAxis::Usual {
            axis: DVec3::Z,
            whose: "AMASS's files",
        };
        track
    } else if has(&BODY_POSE) {
        arguments(fields)?
    } else {
        return Err(FormatError::container(fields.describe(), EXPECTED));
    };
    if track.translation.is_none() {
        track.translation = fields.table(&PLACE, &[3])?;
    }
    for name in RATE {
        track.rate = track.rate.or(fields.number(name)?);
    }
    if seen_by_camera
        && let Some(name) = fields.find(&FRAMES)
        && let Some(numbers) = fields.column(name)?
    {
        track.timeline = Some(timeline(&numbers, name)?);
    }
    Ok(track)
}

fn aist(fields: &mut Fields) -> Result<Track, FormatError> {
    let mut track = rows(fields, &AIST_POSES, &[72])?;
    track.translation = fields.table(&PLACE, &[3])?;
    let scale = fields.number(SCALING)?;
    // Others who use the names have neither its scale nor its videos.
    track.rate = match scale {
        Some(_) => Some(AIST_RATE),
        None => fields.number("fps")?,
    };
    let scale = scale.unwrap_or(1.0);
    if !(scale.is_finite() && scale > 0.0) {
        return Err(FormatError::metadata(SCALING, scale, "a number above 0"));
    }
    // The model was scaled to the cameras' unit; the body is in metres.
    for number in track
        .translation
        .iter_mut()
        .flat_map(|table| &mut table.numbers)
    {
        *number = (f64::from(*number) / scale) as f32;
    }
    track.up = UpAxis::Usual {
        axis: DVec3::Y,
        whose: "AIST++'s files",
    };
    Ok(track)
}

/// Matrices of TRAM's and HybrIK's.
fn matrices(fields: &mut Fields) -> Result<Track, FormatError> {
    let what = match fields.find(&POSE_MATRICES) {
        Some("pred_rotmat") => {
            "TRAM keeps the camera's own motion in camera.npy, which is not read"
        }
        _ => "the file has no motion in the world",
    };
    let table = fields.table(&POSE_MATRICES, &[MATRICES])?;
    let table = need(table, POSE_MATRICES[0], fields)?;
    let part = ChainRotations {
        table: table.into(),
        matrices: true,
        first: 0,
        joints: 0..BODY,
    };
    let mut track = Track::of_parts(Family::Smpl, vec![part]);
    camera(&mut track, what);
    Ok(track)
}

/// The face's expression, as much of it as a clip has.
fn expression(fields: &mut Fields, track: &mut Track) -> Result<(), FormatError> {
    track.expression = fields.rows(&EXPRESSION, MAX_EXPRESSION)?;
    let Some(table) = track
        .expression
        .take_if(|table| table.width > limits::EXPRESSION)
    else {
        return Ok(());
    };
    track.assumptions.push(Assumption {
        what: "expression",
        taken: format!("{} of {} numbers", limits::EXPRESSION, table.width),
        because: "a clip has no more".into(),
    });
    track.expression = Some(table.first(limits::EXPRESSION));
    Ok(())
}

/// Arguments of the models' code: `smpl_params.npz` of AvatarReX and THuman4, GVHMR's results, and
/// HuMoR's, which are SMPL-H's.
fn arguments(fields: &mut Fields) -> Result<Track, FormatError> {
    let smpl_x = fields.has("body_pose") || fields.find(&JAW_POSE).is_some();
    let body = fields.table(&BODY_POSE, &[63, 69])?;
    let body = need(body, BODY_POSE[0], fields)?;
    let smpl_x = smpl_x && body.width == 63;
    let root = fields.table(&ROOT, &[3])?;
    let root = need(root, ROOT[0], fields)?;
    let mut parts = vec![
        ChainRotations::axes(root, 0, 0..1),
        ChainRotations::axes(body, 0, 1..BODY),
    ];
    let face: [(&[&str], usize, Range<usize>); 4] = [
        (&JAW_POSE, 3, JAW..LEFT_EYE),
        (&LEFT_EYE_POSE, 3, LEFT_EYE..LEFT_EYE + 1),
        (&RIGHT_EYE_POSE, 3, LEFT_EYE + 1..LEFT_HAND.start),
        (&EYE_POSES, 6, LEFT_EYE..LEFT_HAND.start),
    ];
    for (names, width, joints) in face {
        let free = parts
            .last()
            .is_some_and(|part| part.joints.end <= joints.start);
        if let Some(table) = fields.table(names, &[width])?.filter(|_| free) {
            parts.push(ChainRotations::axes(table, 0, joints));
        }
    }
    let mut track = Track::of_parts(if smpl_x { Family::SmplX } else { Family::Smpl }, parts);
    hands(fields, &mut track)?;
    expression(fields, &mut track)?;
    Ok(track)
}

/// Fingers of separate arrays.
fn hands(fields: &mut Fields, track: &mut Track) -> Result<(), FormatError> {
    let both: [(&[&str], usize, Range<usize>); 3] = [
        (&LEFT_HAND_POSE, 45, LEFT_HAND),
        (&RIGHT_HAND_POSE, 45, RIGHT_HAND),
        (&HAND_POSES, 90, LEFT_HAND.start..RIGHT_HAND.end),
    ];
    let mut found = false;
    for (names, width, joints) in both {
        let Some(name) = fields.find(names) else {
            continue;
        };
        match fields.table(&[name], &[width]) {
            Ok(Some(table)) if !(found && width == 90) => {
                found = true;
                track.parts.push(ChainRotations::axes(table, 0, joints));
            }
            Ok(_) => {}
            Err(_) => track.assumptions.push(Assumption {
                what: "fingers",
                taken: "straight".into(),
                because: format!("{name} counts in the model's components, which are not here"),
            }),
        }
    }
    let flat = fields.number(FLAT)?;
    if found && flat != Some(1.0) {
        track.assumptions.push(Assumption {
            what: "fingers",
            taken: "turned from a flat hand".into(),
            because: match flat {
                Some(_) => "flat_hand_mean is False, but the model's mean hand is not here".into(),
                None => "the file does not say flat_hand_mean".into(),
            },
        });
    }
    Ok(())
}
