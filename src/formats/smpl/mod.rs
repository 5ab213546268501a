//! Motion as parameters of the SMPL family of body models: rotations of joints, a translation, and
//! for SMPL-X an expression.
//!
//! | written by | file | arrays, with T frames |
//! |---|---|---|
//! | AMASS, SMPL-X "N" | `.npz` | `poses` T, 165; `trans` T, 3; `mocap_frame_rate`; z up |
//! | AMASS, SMPL+H | `.npz` | `poses` T, 156; `trans`; `mocap_framerate`; z up |
//! | AvatarReX, THuman4 | `smpl_params.npz` | `body_pose` T, 63; `global_orient`, `transl`, `jaw_pose` T, 3; `left_hand_pose`, `right_hand_pose` T, 45; `expression` T, 10 |
//! | AIST++ | `.pkl` | `smpl_poses` T, 72; `smpl_trans`; `smpl_scaling`; y up, 60 frames a second |
//! | GVHMR | `hmr4d_results.pt` | `smpl_params_global`: a dictionary as AvatarReX's, without hands; y up |
//! | WHAM | `wham_output.pkl` of joblib | people: `pose_world` T, 72; `trans_world`; `frame_ids`; y up |
//! | ROMP | `.npz` of an object | people or frames: `smpl_thetas`, 72; `cam_trans`; seen from the camera |
//! | 4D-Humans | `demo_*.pkl` of joblib | frames: `tid`; `smpl`: `global_orient` 1, 3, 3; `body_pose` 23, 3, 3; seen from the camera |
//! | TRAM | `hps_track_*.npy` | `pred_rotmat` T, 24, 3, 3; `pred_trans`; `frame`; seen from the camera |
//! | HuMoR, SLAHMR | `.npz` | `root_orient` T, 3; `pose_body` T, 63; `trans`; of SLAHMR with people before T |
//! | VIBE, PARE, CLIFF | `.pkl`, `.npz` | people: `pose` T, 72; `frame_ids`; `global_t`, or no place; seen from the camera |
//!
//! Others use the same names; `recognise` lists what each array may be called. Which axis points up is
//! that of most bodies, unless the format says it.
//!
//! Rotations are relative to the parent, in axes of the world at rest; axis-angle in radians but
//! where matrices are said. SMPL's two hands, 22 and 23, are left out: no other rig has them.
//! Joints have the names of Effigy's own rigs. See `body` for what stands in for the model.

mod body;
mod fields;
mod pickled;
mod recognise;
mod timeline;
mod track;

use crate::{
    capture::{CaptureJoint, Captured},
    npz::{self, Array, Npz},
    pickle::Pickle,
    zip_file::is_zip,
};
use body::Family;
use effigy_core::io::file::FormatError;
use fields::{Fields, SMALL, describe_archive};

/// What a file leaves open.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Options {
    /// Frames a second of a file that does not say, nor its format; None: 30.
    pub rate: Option<f64>,
    /// Which person of several: those who are seen longer come first.
    pub person: usize,
}

/// The joints of SMPL-X in a T-pose of an average body: metres, x to the person's left, y up, z
/// forward. They serve directions and scale.
pub fn average_joints() -> Vec<CaptureJoint> {
    body::joints(Family::SmplX, |_| true)
}

/// ROMP's arrays of objects.
const ROMP: [&str; 2] = ["results", "sequence_results"];

/// The error of an archive without poses. Body models have the same ending.
fn no_motion(bytes: &[u8], names: &[String]) -> FormatError {
    let is_body = names.iter().any(|name| name == "v_template");
    let found = if is_body {
        "SMPL's body model, which has a shape and no motion".to_owned()
    } else {
        describe_archive(bytes)
    };
    FormatError::container(found, recognise::EXPECTED)
}

/// Reads the motion of a person. Told apart by content, as the module lists.
///
/// # Errors
/// When the bytes are no archive of NumPy's, no pickle and no file of PyTorch's; when a pickle
/// names what is not built; when arrays are missing, of odd shapes or not finite; when there are
/// more frames than [`MAX_FRAMES`](crate::capture::MAX_FRAMES), or fewer people than asked for.
pub fn from_bytes(bytes: &[u8], options: &Options) -> Result<Captured, FormatError> {
    let person = options.person;
    let mut size = bytes.len();
    let track = if bytes.starts_with(b"\x93NUMPY") {
        let pickle = npz::pickle_of(bytes).ok_or_else(|| {
            let array = Array::from_npy("the array", bytes.to_vec());
            let found = match array {
                Ok(array) => format!("an array of numbers of the shape {:?}", array.shape()),
                Err(_) => "an array of something else".into(),
            };
            FormatError::container(found, "a dictionary that NumPy saved")
        })?;
        pickled::from_pickle(Pickle::from_bytes(pickle)?.root().inside(), person)?
    } else if is_zip(bytes) {
        let names = npz::names(bytes)?;
        if names.is_empty() {
            // PyTorch's zips hold no arrays of NumPy's.
            pickled::from_pickle(Pickle::from_bytes(bytes)?.root(), person)?
        } else if names.iter().any(|name| ROMP.contains(&&name[..])) {
            romp(bytes, person)?
        } else if names.iter().any(|name| recognise::is_asked(name)) {
            let arrays = Npz::some_from_bytes(bytes, SMALL, recognise::is_asked)?;
            size = size.max(arrays.bytes());
            recognise::recognise(&mut Fields::Archive { arrays, bytes })?.of_person(person)?
        } else {
            return Err(no_motion(bytes, &names));
        }
    } else if bytes.starts_with(b"\x78") {
        return Err(FormatError::container(
            "a compressed pickle",
            "one that joblib wrote without `compress`",
        ));
    } else {
        pickled::from_pickle(Pickle::from_bytes(bytes)?.root().inside(), person)?
    };
    track.into_capture(options.rate, size)
}

fn romp(bytes: &[u8], person: usize) -> Result<track::Track, FormatError> {
    let members = npz::members(bytes, SMALL, |name| ROMP.contains(&name))?;
    let pickle = |name: &str| {
        let member = members.get(name).and_then(|member| npz::pickle_of(member));
        member.map(Pickle::from_bytes).transpose()
    };
    let [results, people] = [pickle(ROMP[0])?, pickle(ROMP[1])?];
    pickled::from_romp(
        results.as_ref().map(|pickle| pickle.root().inside()),
        people.as_ref().map(|pickle| pickle.root().inside()),
        person,
    )
}
