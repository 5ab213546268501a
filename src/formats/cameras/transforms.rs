//! `transforms.json`, as Blender's script for NeRF, instant-ngp and nerfstudio write it.
//!
//! `frames` have a `transform_matrix` each, camera to world by rows, the camera's own axes being x
//! right, y up, z backward as in OpenGL. What a camera sees of its image, `w`, `h`, `fl_x`, `fl_y`,
//! `cx`, `cy`, px, or `camera_angle_x`, the horizontal field of view, radians, stands in a frame or
//! once for all.

use super::opened::{OpenedCameras, distortion, distorts, not_json};
use crate::{assumption::Assumption, json::bounded};
use effigy_core::io::{
    cameras::{PlacedCamera, cameras_of},
    file::{FormatError, excerpt},
};
use glam::{DAffine3, DMat3, DVec3};
use serde::Deserialize;
use std::{fs::File, io::Read, path::Path};

/// Camera models that are a pinhole, with or without distortion.
const PINHOLES: [&str; 7] = [
    "PINHOLE",
    "SIMPLE_PINHOLE",
    "SIMPLE_RADIAL",
    "RADIAL",
    "OPENCV",
    "FULL_OPENCV",
    "PERSPECTIVE",
];
/// Sides of a picture of NeRF's synthetic scenes, px.
const SYNTHETIC: f64 = 800.0;

/// A frame's place.
#[derive(Deserialize)]
struct PosedImage {
    #[serde(default)]
    file_path: String,
    transform_matrix: Vec<[f64; 4]>,
}

#[derive(Deserialize)]
struct PosedImages {
    #[serde(deserialize_with = "bounded")]
    frames: Vec<PosedImage>,
    applied_transform: Option<Vec<[f64; 4]>>,
}

/// How a camera sees: of one frame, or of all.
#[derive(Clone, Default, Deserialize)]
struct SharedLens {
    w: Option<f64>,
    h: Option<f64>,
    fl_x: Option<f64>,
    fl_y: Option<f64>,
    cx: Option<f64>,
    cy: Option<f64>,
    camera_angle_x: Option<f64>,
    camera_angle_y: Option<f64>,
    camera_model: Option<String>,
    is_fisheye: Option<bool>,
    k1: Option<f64>,
    k2: Option<f64>,
    k3: Option<f64>,
    k4: Option<f64>,
    p1: Option<f64>,
    p2: Option<f64>,
}

#[derive(Deserialize)]
struct Lenses {
    #[serde(deserialize_with = "bounded")]
    frames: Vec<SharedLens>,
}

impl SharedLens {
    /// This one, where it says something, else `shared`.
    fn or(&self, shared: &Self) -> Self {
        Self {
            w: self.w.or(shared.w),
            h: self.h.or(shared.h),
            fl_x: self.fl_x.or(shared.fl_x),
            fl_y: self.fl_y.or(shared.fl_y),
            cx: self.cx.or(shared.cx),
            cy: self.cy.or(shared.cy),
            camera_angle_x: self.camera_angle_x.or(shared.camera_angle_x),
            camera_angle_y: self.camera_angle_y.or(shared.camera_angle_y),
            camera_model: self
                .camera_model
                .as_ref()
                .or(shared.camera_model.as_ref())
                .cloned(),
            is_fisheye: self.is_fisheye.or(shared.is_fisheye),
            k1: self.k1.or(shared.k1),
            k2: self.k2.or(shared.k2),
            k3: self.k3.or(shared.k3),
            k4: self.k4.or(shared.k4),
            p1: self.p1.or(shared.p1),
            p2: self.p2.or(shared.p2),
        }
    }

    fn distorts(&self) -> bool {
        let numbers = [self.k1, self.k2, self.k3, self.k4, self.p1, self.p2];
        distorts(numbers.iter().flatten())
    }

    /// The model's name where it is no pinhole.
    fn other_model(&self) -> Option<&str> {
        let model = self.camera_model.as_deref().unwrap_or("PINHOLE");
        if self.is_fisheye == Some(true) {
            return Some("fisheye");
        }
        (!PINHOLES.contains(&model)).then_some(model)
    }

    /// Width and height, px, as far as it says.
    fn size(&self) -> Option<[f64; 2]> {
        let around =
            |side: Option<f64>, center: Option<f64>| side.or(center.map(|c| (2.0 * c).round()));
        Some([around(self.w, self.cx)?, around(self.h, self.cy)?])
    }
}

/// Reads cameras from a file's bytes. `path`: the file's, beside which its pictures are. `world`: see
/// [`super::read`].
///
/// # Errors
/// When the bytes are no `transforms.json`, or a camera is no pinhole or has an invalid number.
pub fn parse(bytes: &[u8], path: &Path, world: DAffine3) -> Result<OpenedCameras, FormatError> {
    let failed = |error: serde_json::Error| not_json(&error);
    let PosedImages {
        frames,
        applied_transform,
    } = serde_json::from_slice(bytes).map_err(failed)?;
    let shared: SharedLens = serde_json::from_slice(bytes).map_err(failed)?;
    let own: Lenses = serde_json::from_slice(bytes).map_err(failed)?;
    let folder = path.parent().unwrap_or(Path::new(""));
    let mut distorts = false;
    let mut guessed = false;
    let mut placed = Vec::with_capacity(frames.len());
    for (index, (frame, own)) in frames.iter().zip(&own.frames).enumerate() {
        let lens = own.or(&shared);
        distorts |= lens.distorts();
        let size = lens
            .size()
            .or_else(|| picture_size(folder, &frame.file_path));
        guessed |= size.is_none();
        let size = size.unwrap_or([SYNTHETIC; 2]);
        let camera = placed_camera(frame, &lens, size).map_err(|(found, expected)| {
            FormatError::container(format!("{found} at camera {index}"), expected)
        })?;
        placed.push(camera);
    }
    let size = guessed.then(|| Assumption {
        what: "size of the images",
        taken: format!("{SYNTHETIC} × {SYNTHETIC} px"),
        because: "neither `w` and `h` nor a PNG beside it says so; --size gives another".into(),
    });
    let axes = applied_transform
        .filter(|rows| !is_identity(rows))
        .map(|_| Assumption {
            what: "axes",
            taken: "those of its `transform_matrix`".into(),
            because:
                "its `applied_transform` has turned them away from COLMAP's, in which 3DGS trains"
                    .into(),
        });
    Ok(OpenedCameras {
        cameras: cameras_of(&placed, world)?,
        assumptions: [distortion(distorts), size, axes]
            .into_iter()
            .flatten()
            .collect(),
    })
}

/// A frame's camera, or what was found and what was expected.
fn placed_camera(
    frame: &PosedImage,
    lens: &SharedLens,
    [width, height]: [f64; 2],
) -> Result<PlacedCamera, (String, String)> {
    if let Some(model) = lens.other_model() {
        return Err((
            format!("the camera model {}", excerpt(model)),
            "a pinhole with or without distortion: undistort the pictures first".into(),
        ));
    }
    let of_angle =
        |side: f64, angle: Option<f64>| angle.map(|angle| 0.5 * side / (0.5 * angle).tan());
    let x = lens.fl_x.or(of_angle(width, lens.camera_angle_x));
    let y = lens.fl_y.or(of_angle(height, lens.camera_angle_y));
    let (Some(x), Some(y)) = (x.or(y), y.or(x)) else {
        return Err((
            "no focal length".into(),
            "`fl_x` or `camera_angle_x`".into(),
        ));
    };
    let rows = &frame.transform_matrix;
    let is_affine = match rows.get(3) {
        Some(last) => rows.len() == 4 && *last == [0.0, 0.0, 0.0, 1.0],
        None => rows.len() == 3,
    };
    if !is_affine {
        return Err((
            format!("the `transform_matrix` {}", excerpt(&format!("{rows:?}"))),
            "3 rows of 4 numbers, with 0, 0, 0, 1 below or without".into(),
        ));
    }
    let column = |k: usize| DVec3::new(rows[0][k], rows[1][k], rows[2][k]);
    Ok(PlacedCamera {
        size: [width, height],
        focal: [x, y],
        center: [
            lens.cx.unwrap_or(0.5 * width),
            lens.cy.unwrap_or(0.5 * height),
        ],
        rotation: DMat3::from_cols(column(0), -column(1), -column(2)),
        position: column(3),
    })
}

fn is_identity(rows: &[[f64; 4]]) -> bool {
    let one = |row: usize, column: usize| f64::from(u8::from(row == column));
    rows.iter()
        .enumerate()
        .all(|(r, row)| row.iter().enumerate().all(|(c, value)| *value == one(r, c)))
}

/// Width and height of a frame's picture, px, if it is a PNG beside the file. Blender's script leaves
/// the ending out.
fn picture_size(folder: &Path, file_path: &str) -> Option<[f64; 2]> {
    let mut path = folder.join(file_path);
    if path.extension().is_none() {
        path.set_extension("png");
    }
    // A pipe or a terminal would never end.
    if !path.metadata().ok()?.is_file() {
        return None;
    }
    let mut header = [0; 24];
    File::open(path).ok()?.read_exact(&mut header).ok()?;
    let [.., a, b, c, d, e, f, g, h] = header;
    let size = [[a, b, c, d], [e, f, g, h]].map(|bytes| f64::from(u32::from_be_bytes(bytes)));
    header.starts_with(b"\x89PNG\r\n\x1a\n").then_some(size)
}
