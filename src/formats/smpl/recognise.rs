//! Which program wrote a set of arrays, told by their names.

use super::{
    body::Family,
    fields::{Fields, Table},
    timeline::timeline,
    track::{Anchor, Part, Track},
};
use crate::{assumption::Assumption, smpl_joints::BODY};
use effigy_core::io::file::FormatError;
use glam::DVec3;
use std::{ops::Range, rc::Rc};

/// Numbers of a row of SMPL's rotations: 22 joints, 24 with SMPL's hands, 52 of SMPL-H, 55 of
/// SMPL-X.
const WIDTHS: [usize; 4] = [66, 72, 156, 165];
const JAW: usize = 22;
const LEFT_HAND: Range<usize> = 25..40;
const RIGHT_HAND: Range<usize> = 40..55;
/// AIST++'s frames a second, of its videos.
const AIST_RATE: f64 = 60.0;
/// Most numbers of an expression: SMPL-X has 100.
const MAX_EXPRESSION: usize = 256;

/// Every name of an array that is asked for.
pub const NAMES: [&str; 28] = [
    "poses",
    "trans",
    "mocap_frame_rate",
    "mocap_framerate",
    "smpl_poses",
    "smpl_trans",
    "smpl_scaling",
    "pose_world",
    "trans_world",
    "pose",
    "frame_ids",
    "frame_id",
    "global_orient",
    "body_pose",
    "jaw_pose",
    "leye_pose",
    "reye_pose",
    "left_hand_pose",
    "right_hand_pose",
    "transl",
    "expression",
    "flat_hand_mean",
    "pred_rotmat",
    "pred_trans",
    "frame",
    "smpl_thetas",
    "cam_trans",
    "fps",
];

/// What a file with motion has.
pub const EXPECTED: &str =
    "SMPL's parameters: poses, or body_pose and global_orient, or what ROMP, WHAM or TRAM write";

/// Whether arrays are a person's motion.
pub fn is_motion(fields: &Fields) -> bool {
    ["poses", "smpl_poses", "pose_world", "pose", "body_pose"]
        .into_iter()
        .chain(["pred_rotmat", "smpl_thetas"])
        .any(|name| fields.has(name))
}

fn need(table: Option<Table>, name: &str, fields: &Fields) -> Result<Table, FormatError> {
    table.ok_or_else(|| {
        FormatError::metadata(name, "nothing", format!("it beside {}", fields.describe()))
    })
}

/// The upward axis of a camera's axes: y points down.
fn camera(track: &mut Track, what: &str) {
    track.up = Some(DVec3::NEG_Y);
    track.assumptions.push(Assumption {
        what: "axes",
        taken: "the camera's, which is taken to be level".into(),
        because: what.into(),
    });
}

/// A track of whole rows of rotations.
fn track(poses: Table) -> Track {
    let smpl_x = poses.width == 165;
    let poses = Rc::new(poses);
    let parts = if poses.width == 156 {
        let hands = Part::axes(poses.clone(), BODY, LEFT_HAND.start..RIGHT_HAND.end);
        vec![Part::axes(poses, 0, 0..BODY), hands]
    } else {
        let joints = if smpl_x { RIGHT_HAND.end } else { BODY };
        vec![Part::axes(poses, 0, 0..joints)]
    };
    Track {
        family: if smpl_x { Family::SmplX } else { Family::Smpl },
        parts,
        translation: None,
        anchor: Anchor::Origin,
        expression: None,
        timeline: None,
        rate: None,
        up: None,
        assumptions: vec![],
    }
}

/// The motion that arrays are.
pub fn recognise(fields: &mut Fields) -> Result<Track, FormatError> {
    if fields.has("pred_rotmat") {
        return tram(fields);
    }
    if fields.has("smpl_thetas") {
        return romp(fields);
    }
    if fields.has("smpl_poses") {
        return aist(fields);
    }
    if fields.has("pose_world") || (fields.has("pose") && fields.has("trans")) {
        return wham(fields);
    }
    if fields.has("body_pose") {
        return arguments(fields);
    }
    if fields.has("poses") {
        return amass(fields);
    }
    Err(FormatError::container(fields.describe(), EXPECTED))
}

fn amass(fields: &mut Fields) -> Result<Track, FormatError> {
    let poses = fields.table("poses", &WIDTHS)?;
    let mut track = track(need(poses, "poses", fields)?);
    track.translation = fields.table("trans", &[3])?;
    for name in ["mocap_frame_rate", "mocap_framerate", "fps"] {
        track.rate = track.rate.or(fields.number(name)?);
    }
    track.up = Some(DVec3::Z);
    if !(fields.has("mocap_frame_rate") || fields.has("mocap_framerate")) && track.rate.is_none() {
        track.assumptions.push(Assumption {
            what: "up axis",
            taken: "z, as in AMASS".into(),
            because: "arrays are named as AMASS names them".into(),
        });
    }
    Ok(track)
}

fn aist(fields: &mut Fields) -> Result<Track, FormatError> {
    let poses = fields.table("smpl_poses", &[72])?;
    let mut track = track(need(poses, "smpl_poses", fields)?);
    track.translation = fields.table("smpl_trans", &[3])?;
    let scale = fields.number("smpl_scaling")?.unwrap_or(1.0);
    if !(scale.is_finite() && scale > 0.0) {
        return Err(FormatError::metadata(
            "smpl_scaling",
            scale,
            "a number above 0",
        ));
    }
    // The model was scaled to the cameras' unit; the body is in metres.
    for number in track
        .translation
        .iter_mut()
        .flat_map(|table| &mut table.numbers)
    {
        *number = (f64::from(*number) / scale) as f32;
    }
    track.rate = Some(AIST_RATE);
    track.up = Some(DVec3::Y);
    Ok(track)
}

fn wham(fields: &mut Fields) -> Result<Track, FormatError> {
    let world = fields.has("pose_world");
    let [poses, places] = if world {
        ["pose_world", "trans_world"]
    } else {
        ["pose", "trans"]
    };
    let poses = fields.table(poses, &[72])?;
    let mut track = track(need(poses, "pose", fields)?);
    track.translation = fields.table(places, &[3])?;
    if world {
        track.anchor = Anchor::Hips;
        track.up = Some(DVec3::Y);
    } else {
        camera(&mut track, "the file has no motion in the world");
    }
    if let Some(ids) = fields.column("frame_ids")? {
        track.timeline = Some(timeline(&ids, "frame_ids")?);
    }
    Ok(track)
}

fn romp(fields: &mut Fields) -> Result<Track, FormatError> {
    let poses = fields.table("smpl_thetas", &[72])?;
    let mut track = track(need(poses, "smpl_thetas", fields)?);
    track.translation = fields.table("cam_trans", &[3])?;
    if let Some(ids) = fields.column("frame_id")? {
        track.timeline = Some(timeline(&ids, "frame_id")?);
    }
    camera(&mut track, "ROMP's results are seen from the camera");
    Ok(track)
}

fn tram(fields: &mut Fields) -> Result<Track, FormatError> {
    let table = fields.table("pred_rotmat", &[24 * 9])?;
    let table = need(table, "pred_rotmat", fields)?;
    let translation = fields.table("pred_trans", &[3])?;
    let part = Part {
        table: table.into(),
        matrices: true,
        first: 0,
        joints: 0..BODY,
    };
    let mut track = Track {
        family: Family::Smpl,
        parts: vec![part],
        translation,
        anchor: Anchor::Origin,
        expression: None,
        timeline: None,
        rate: None,
        up: None,
        assumptions: vec![],
    };
    if let Some(ids) = fields.column("frame")? {
        track.timeline = Some(timeline(&ids, "frame")?);
    }
    camera(
        &mut track,
        "TRAM keeps the camera's own motion in camera.npy, which is not read",
    );
    Ok(track)
}

/// Arguments of the models' code: `smpl_params.npz` of AvatarReX and THuman4, GVHMR's results.
fn arguments(fields: &mut Fields) -> Result<Track, FormatError> {
    let body = fields.table("body_pose", &[63, 69])?;
    let body = need(body, "body_pose", fields)?;
    let root = fields.table("global_orient", &[3])?;
    let root = need(root, "global_orient", fields)?;
    let smpl_x = body.width == 63;
    let mut parts = vec![Part::axes(root, 0, 0..1), Part::axes(body, 0, 1..BODY)];
    for (joint, name) in ["jaw_pose", "leye_pose", "reye_pose"].iter().enumerate() {
        if let Some(table) = fields.table(name, &[3])? {
            parts.push(Part::axes(table, 0, JAW + joint..JAW + joint + 1));
        }
    }
    let mut assumptions = vec![];
    let mut hands = false;
    for (name, joints) in [
        ("left_hand_pose", LEFT_HAND),
        ("right_hand_pose", RIGHT_HAND),
    ] {
        match fields.table(name, &[45]) {
            Ok(Some(table)) => {
                hands = true;
                parts.push(Part::axes(table, 0, joints));
            }
            Ok(None) => {}
            Err(_) => assumptions.push(Assumption {
                what: "fingers",
                taken: "straight".into(),
                because: format!("{name} counts in the model's components, which are not here"),
            }),
        }
    }
    let flat = fields.number("flat_hand_mean")?;
    if hands && flat != Some(1.0) {
        assumptions.push(Assumption {
            what: "fingers",
            taken: "turned from a flat hand".into(),
            because: match flat {
                Some(_) => "flat_hand_mean is False, but the model's mean hand is not here".into(),
                None => "the file does not say flat_hand_mean".into(),
            },
        });
    }
    let track = Track {
        family: if smpl_x { Family::SmplX } else { Family::Smpl },
        parts,
        translation: fields.table("transl", &[3])?,
        anchor: Anchor::Origin,
        expression: fields.rows("expression", MAX_EXPRESSION)?,
        timeline: None,
        rate: fields.number("fps")?,
        up: None,
        assumptions,
    };
    Ok(track)
}
