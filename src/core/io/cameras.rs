//! `cameras.json`, which 3DGS writes beside a `.ply`: reading into cameras in the avatar's world,
//! and writing.
//!
//! An array of `{id, img_name, width, height, position, rotation, fx, fy}`: centre and
//! camera-to-world rotation by rows in the `.ply`'s axes, the camera's own being x right, y down, z
//! forward; focal lengths in px of an image of that size. The optical axis meets the image's
//! centre.
//!
//! mmlphuman's file of that name is read too: `{cam_id, w2c, K}`, world to camera in the axes of
//! its poses, and the camera matrix in px. It has no sizes of images: each is as large as its
//! optical axis meets its centre, to a pixel.

use super::{
    file::{FileError, FormatError},
    text,
};
use crate::scene::Camera;
use glam::{DAffine3, DMat3, DVec2, DVec3};
use serde::{Deserialize, Serialize, de::IgnoredAny};
use std::path::Path;

/// Maximum number of cameras in a file.
const CAMERAS_MAX: usize = 100_000;
/// Maximum side of an image, px.
const SIDE_MAX: u32 = 1 << 16;
/// Tolerance for the dot products of the rotation's rows.
const ORTHONORMAL: f64 = 1e-3;
/// Largest skew of pixels, of a focal length.
const SKEW_MAX: f64 = 1e-3;

/// An entry of the file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct CameraEntry {
    #[serde(default)]
    id: u64,
    #[serde(default)]
    img_name: String,
    width: u32,
    height: u32,
    position: [f64; 3],
    rotation: [[f64; 3]; 3],
    fx: f64,
    fy: f64,
}

impl CameraEntry {
    fn rotation(&self) -> DMat3 {
        DMat3::from_cols_array_2d(&self.rotation).transpose()
    }

    /// The first rule that the entry breaks: what was found, and what was expected.
    fn broken_rule(&self) -> Option<(String, String)> {
        let sides = [self.width, self.height];
        if !sides.iter().all(|side| (1..=SIDE_MAX).contains(side)) {
            return Some((
                format!("an image of {} × {} px", sides[0], sides[1]),
                format!("sides from 1 to {SIDE_MAX} px"),
            ));
        }
        if !(self.fx > 0.0 && self.fy > 0.0 && self.fx.is_finite() && self.fy.is_finite()) {
            return Some((
                format!("focal lengths of {} and {} px", self.fx, self.fy),
                "finite ones above 0".into(),
            ));
        }
        if !DVec3::from(self.position).is_finite() {
            return Some((
                format!("the position {:?}", self.position),
                "finite numbers".into(),
            ));
        }
        let rotation = self.rotation();
        let off = (rotation * rotation.transpose() - DMat3::IDENTITY)
            .to_cols_array()
            .map(f64::abs)
            .into_iter()
            .fold(0.0, f64::max);
        if !(rotation.is_finite() && off <= ORTHONORMAL && rotation.determinant() > 0.0) {
            return Some((
                format!("the matrix {:?}", self.rotation),
                "a rotation".into(),
            ));
        }
        None
    }

    fn camera(&self, world: DAffine3) -> Camera {
        let position = DVec3::from(self.position);
        let pose = DAffine3::from_mat3_translation(self.rotation(), position);
        Camera {
            view: (world * pose).inverse(),
            focal: DVec2::new(self.fx, self.fy),
            center: 0.5 * DVec2::new(f64::from(self.width), f64::from(self.height)),
            size: [self.width, self.height],
            near: Camera::NEAR,
        }
    }
}

/// An entry of mmlphuman's file.
#[derive(Clone, Debug, PartialEq, Deserialize)]
struct RigEntry {
    /// World to camera, by rows.
    w2c: [[f64; 4]; 4],
    /// Camera to image, px, by rows.
    #[serde(rename = "K")]
    intrinsics: [[f64; 3]; 3],
}

impl RigEntry {
    /// The entry as 3DGS would write it.
    ///
    /// # Errors
    /// What was found, and what was expected.
    fn plain(&self) -> Result<CameraEntry, (String, String)> {
        let last = self.w2c[3];
        if last != [0.0, 0.0, 0.0, 1.0] {
            return Err((
                format!("the last row {last:?} of `w2c`"),
                "0, 0, 0, 1".into(),
            ));
        }
        let [[fx, skew, cx], [below, fy, cy], row] = self.intrinsics;
        let upright = [skew, below].iter().all(|v| v.abs() <= SKEW_MAX * fx.abs());
        if !upright || row != [0.0, 0.0, 1.0] {
            return Err((
                format!("the matrix `K` {:?}", self.intrinsics),
                "focal lengths and a centre alone".into(),
            ));
        }
        // Past the largest side and below 1 the cast is clamped, and the rule for sides is broken.
        let [width, height] = [cx, cy].map(|c| (2.0 * c).round() as u32);
        let rows = [self.w2c[0], self.w2c[1], self.w2c[2]];
        let rotation = rows.map(|[x, y, z, _]| [x, y, z]);
        let to_camera = DMat3::from_cols_array_2d(&rotation).transpose();
        let moved = DVec3::from(rows.map(|row| row[3]));
        Ok(CameraEntry {
            id: 0,
            img_name: String::new(),
            width,
            height,
            position: (-(to_camera.transpose() * moved)).to_array(),
            // The columns of one are the rows of its inverse.
            rotation: to_camera.to_cols_array_2d(),
            fx,
            fy,
        })
    }
}

/// Tells the two files apart.
#[derive(Deserialize)]
struct AnyEntry {
    w2c: Option<IgnoredAny>,
}

/// Reads cameras. `world` leads from the `.ply`'s axes to the world:
/// [`crate::avatar::Skeleton::matrices`] of the root at rest.
///
/// # Errors
/// When the file cannot be read, is not a list of cameras, or has an invalid camera.
pub fn read(path: &Path, world: DAffine3) -> Result<Vec<Camera>, FileError> {
    let bytes = std::fs::read(path).map_err(|cause| FileError::Read {
        file: path.into(),
        cause,
    })?;
    parse(&bytes, world).map_err(|fault| FileError::Content {
        file: path.into(),
        fault,
    })
}

/// Reads cameras from a file's bytes. `world`: see [`read`].
///
/// # Errors
/// When the bytes are not a list of cameras, or a camera is invalid.
pub fn parse(bytes: &[u8], world: DAffine3) -> Result<Vec<Camera>, FormatError> {
    let failed = |error: serde_json::Error| {
        FormatError::container(
            super::file::excerpt(&error.to_string()),
            "cameras as 3DGS or mmlphuman writes them",
        )
    };
    let bytes = &*text::utf8(bytes);
    let kinds: Vec<AnyEntry> = serde_json::from_slice(bytes).map_err(failed)?;
    let is_rig = kinds.first().is_some_and(|entry| entry.w2c.is_some());
    let entries: Vec<CameraEntry> = if is_rig {
        let rig: Vec<RigEntry> = serde_json::from_slice(bytes).map_err(failed)?;
        let plain = |(index, entry): (usize, &RigEntry)| {
            entry.plain().map_err(|(found, expected)| {
                FormatError::container(format!("{found} at camera {index}"), expected)
            })
        };
        rig.iter()
            .enumerate()
            .map(plain)
            .collect::<Result<_, _>>()?
    } else {
        serde_json::from_slice(bytes).map_err(failed)?
    };
    if entries.is_empty() || entries.len() > CAMERAS_MAX {
        return Err(FormatError::container(
            format!("{} cameras", entries.len()),
            format!("1 to {CAMERAS_MAX}"),
        ));
    }
    for (index, entry) in entries.iter().enumerate() {
        if let Some((found, expected)) = entry.broken_rule() {
            return Err(FormatError::container(
                format!("{found} at camera {index}"),
                expected,
            ));
        }
    }
    Ok(entries.iter().map(|entry| entry.camera(world)).collect())
}

/// Writes a file that [`parse`] reads back with the identity as `world`.
pub fn to_json(cameras: &[Camera]) -> String {
    let entry = |(id, camera): (usize, &Camera)| {
        let placed = camera.view.inverse();
        CameraEntry {
            id: id as u64,
            img_name: format!("{id:05}"),
            width: camera.size[0],
            height: camera.size[1],
            position: placed.translation.to_array(),
            rotation: placed.matrix3.transpose().to_cols_array_2d(),
            fx: camera.focal.x,
            fy: camera.focal.y,
        }
    };
    let entries: Vec<_> = cameras.iter().enumerate().map(entry).collect();
    serde_json::to_string_pretty(&entries).expect("strings and numbers always have a JSON form")
}

/// Adapts a camera to an image of another size: the vertical field of view stays, and so does the
/// shape of pixels.
pub fn scaled(camera: &Camera, size: [u32; 2]) -> Camera {
    let [width, height] = size.map(f64::from);
    let focal = camera.focal * height / f64::from(camera.size[1]);
    Camera {
        focal,
        center: 0.5 * DVec2::new(width, height),
        size,
        ..*camera
    }
}
