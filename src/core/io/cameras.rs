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

use super::{file::FormatError, text};
use crate::scene::Camera;
use glam::{DAffine3, DMat3, DVec2, DVec3};
use serde::{
    Deserialize, Serialize, Serializer,
    de::{DeserializeOwned, IgnoredAny},
};

/// Maximum number of cameras in a file.
const CAMERAS_MAX: usize = 100_000;
/// Maximum side of an image, px.
const SIDE_MAX: f64 = 65536.0;
/// Tolerance for the dot products of the rotation's rows.
const ORTHONORMAL: f64 = 1e-3;
/// Largest skew of pixels, of a focal length.
const SKEW_MAX: f64 = 1e-3;

/// A pinhole camera as a file places it in its own axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlacedCamera {
    /// Width and height of its image, px.
    pub size: [f64; 2],
    /// Focal length along x and y, px.
    pub focal: [f64; 2],
    /// Where the optical axis meets the image, px from the top left corner.
    pub center: [f64; 2],
    /// Camera to the file's axes; the camera's own are x right, y down, z forward.
    pub rotation: DMat3,
    /// Its centre in the file's axes.
    pub position: DVec3,
}

impl PlacedCamera {
    /// The first rule that it breaks: what was found, and what was expected.
    fn broken_rule(&self) -> Option<(String, String)> {
        let Self {
            size: [width, height],
            focal: [x, y],
            rotation,
            ..
        } = *self;
        let is_side = |side: f64| side.fract() == 0.0 && (1.0..=SIDE_MAX).contains(&side);
        if !(is_side(width) && is_side(height)) {
            return Some((
                format!("an image of {width} × {height} px"),
                format!("sides from 1 to {SIDE_MAX} px"),
            ));
        }
        if !(x > 0.0 && y > 0.0 && x.is_finite() && y.is_finite()) {
            return Some((
                format!("focal lengths of {x} and {y} px"),
                "finite ones above 0".into(),
            ));
        }
        let numbers = self.position.to_array().into_iter().chain(self.center);
        if !numbers.clone().all(f64::is_finite) {
            return Some((
                format!(
                    "a position and an image's centre of {:?}",
                    numbers.collect::<Vec<_>>()
                ),
                "finite numbers".into(),
            ));
        }
        let off = (rotation * rotation.transpose() - DMat3::IDENTITY)
            .to_cols_array()
            .map(f64::abs)
            .into_iter()
            .fold(0.0, f64::max);
        if !(rotation.is_finite() && off <= ORTHONORMAL && rotation.determinant() > 0.0) {
            let rows = rotation.transpose().to_cols_array_2d();
            return Some((format!("the matrix {rows:?}"), "a rotation".into()));
        }
        None
    }

    fn camera(&self, world: DAffine3) -> Camera {
        let pose = DAffine3::from_mat3_translation(self.rotation, self.position);
        Camera {
            view: (world * pose).inverse(),
            focal: DVec2::from(self.focal),
            center: DVec2::from(self.center),
            size: self.size.map(|side| side as u32),
            near: Camera::NEAR,
        }
    }
}

/// The cameras of a file. `world`: see [`parse`].
///
/// # Errors
/// When there are none or too many, or one is no pinhole with finite numbers.
pub fn cameras_of(placed: &[PlacedCamera], world: DAffine3) -> Result<Vec<Camera>, FormatError> {
    if placed.is_empty() || placed.len() > CAMERAS_MAX {
        return Err(FormatError::container(
            format!("{} cameras", placed.len()),
            format!("1 to {CAMERAS_MAX}"),
        ));
    }
    for (index, camera) in placed.iter().enumerate() {
        if let Some((found, expected)) = camera.broken_rule() {
            return Err(FormatError::container(
                format!("{found} at camera {index}"),
                expected,
            ));
        }
    }
    Ok(placed.iter().map(|camera| camera.camera(world)).collect())
}

/// An entry of the file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct CameraEntry {
    /// Only written: other programs' are numbers or names.
    #[serde(skip_deserializing)]
    id: u64,
    #[serde(skip_deserializing)]
    img_name: String,
    /// Whole, though some programs write `192.0`.
    #[serde(serialize_with = "whole")]
    width: f64,
    #[serde(serialize_with = "whole")]
    height: f64,
    position: [f64; 3],
    rotation: [[f64; 3]; 3],
    fx: f64,
    fy: f64,
}

/// Writes a number of pixels as 3DGS does.
fn whole<S: Serializer>(side: &f64, to: S) -> Result<S::Ok, S::Error> {
    to.serialize_u64(*side as u64)
}

impl CameraEntry {
    fn placed(&self) -> PlacedCamera {
        PlacedCamera {
            size: [self.width, self.height],
            focal: [self.fx, self.fy],
            center: [0.5 * self.width, 0.5 * self.height],
            rotation: DMat3::from_cols_array_2d(&self.rotation).transpose(),
            position: DVec3::from(self.position),
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
    /// # Errors
    /// What was found, and what was expected.
    fn placed(&self) -> Result<PlacedCamera, (String, String)> {
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
        let size = [cx, cy].map(|c| (2.0 * c).round());
        let rows = [self.w2c[0], self.w2c[1], self.w2c[2]];
        let rotation = rows.map(|[x, y, z, _]| [x, y, z]);
        let to_camera = DMat3::from_cols_array_2d(&rotation).transpose();
        let moved = DVec3::from(rows.map(|row| row[3]));
        Ok(PlacedCamera {
            size,
            focal: [fx, fy],
            center: size.map(|side| 0.5 * side),
            rotation: to_camera.transpose(),
            position: -(to_camera.transpose() * moved),
        })
    }
}

/// Tells the two files apart.
#[derive(Deserialize)]
struct AnyEntry {
    w2c: Option<IgnoredAny>,
}

/// The list of a file, which may stand in an object's `cameras`.
fn list<T: DeserializeOwned>(bytes: &[u8]) -> Result<Vec<T>, FormatError> {
    #[derive(Deserialize)]
    struct Around<T> {
        cameras: Vec<T>,
    }
    let bytes = &*text::utf8(bytes);
    let read = if bytes.trim_ascii_start().starts_with(b"{") {
        serde_json::from_slice(bytes).map(|around: Around<T>| around.cameras)
    } else {
        serde_json::from_slice(bytes)
    };
    read.map_err(|error| {
        FormatError::container(
            super::file::excerpt(&error.to_string()),
            "cameras as 3DGS or mmlphuman writes them",
        )
    })
}

/// Reads cameras from a file's bytes. `world` leads from the file's axes, which are those of the
/// `.ply` beside it, to the world: [`crate::avatar::Skeleton::matrices`] of the root at rest.
///
/// # Errors
/// When the bytes are not a list of cameras, or a camera is invalid.
pub fn parse(bytes: &[u8], world: DAffine3) -> Result<Vec<Camera>, FormatError> {
    let kinds: Vec<AnyEntry> = list(bytes)?;
    let placed = if kinds.first().is_some_and(|entry| entry.w2c.is_some()) {
        let placed = |(index, entry): (usize, &RigEntry)| {
            entry.placed().map_err(|(found, expected)| {
                FormatError::container(format!("{found} at camera {index}"), expected)
            })
        };
        let rig: Vec<RigEntry> = list(bytes)?;
        rig.iter()
            .enumerate()
            .map(placed)
            .collect::<Result<_, _>>()?
    } else {
        let entries: Vec<CameraEntry> = list(bytes)?;
        entries.iter().map(CameraEntry::placed).collect::<Vec<_>>()
    };
    cameras_of(&placed, world)
}

/// Writes a file that [`parse`] reads back with the identity as `world`.
pub fn to_json(cameras: &[Camera]) -> String {
    let entry = |(id, camera): (usize, &Camera)| {
        let placed = camera.view.inverse();
        CameraEntry {
            id: id as u64,
            img_name: format!("{id:05}"),
            width: camera.size[0].into(),
            height: camera.size[1].into(),
            position: placed.translation.to_array(),
            rotation: placed.matrix3.transpose().to_cols_array_2d(),
            fx: camera.focal.x,
            fy: camera.focal.y,
        }
    };
    let entries: Vec<_> = cameras.iter().enumerate().map(entry).collect();
    serde_json::to_string_pretty(&entries).expect("strings and numbers always have a JSON form")
}

/// Adapts a camera to an image of another size: the vertical field of view stays, and so do the shape
/// of pixels and how far the optical axis is from the image's centre.
pub fn scaled(camera: &Camera, size: [u32; 2]) -> Camera {
    let middle = |size: [u32; 2]| 0.5 * DVec2::new(size[0].into(), size[1].into());
    let ratio = f64::from(size[1]) / f64::from(camera.size[1]);
    Camera {
        focal: camera.focal * ratio,
        center: middle(size) + (camera.center - middle(camera.size)) * ratio,
        size,
        ..*camera
    }
}
