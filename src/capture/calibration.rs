//! Cameras as `calibration.json` has them.

use crate::{error::content, limits};
use effigy_core::{
    avatar::limits::LENGTH,
    io::{
        file::{FormatError, excerpt},
        text,
    },
    scene::Camera,
};
use glam::{DAffine3, DMat3, DQuat, DVec2, DVec3};
use serde::{
    Deserialize, Deserializer, Serialize, Serializer,
    de::{self, MapAccess},
    ser::SerializeMap,
};
use std::{fmt, path::Path};

use crate::error::CaptureError;

/// How far `R Rᵀ` may be from the identity.
const MATRIX_SLACK: f64 = 1e-3;
/// From the middle of the upper left pixel, where files count from, to its corner, px.
const HALF_PIXEL: DVec2 = DVec2::splat(0.5);

/// A camera of a capture.
#[derive(Clone, Debug, PartialEq)]
pub struct CaptureCamera {
    /// Name in the calibration, and of the pictures' folder.
    pub name: String,
    /// The pinhole camera of the pictures without their distortion.
    pub camera: Camera,
    /// OpenCV's k1, k2, p1, p2, k3 of the pictures in the files. [`crate::Capture::picture`] takes
    /// it out.
    pub distortion: [f64; 5],
    /// Held out from training.
    pub held: bool,
}

/// A camera in the file.
#[derive(Clone, Debug, Deserialize, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct CalibrationEntry {
    #[serde(rename = "K")]
    k: Vec<f64>,
    #[serde(rename = "R")]
    r: Vec<f64>,
    #[serde(rename = "T")]
    t: Vec<f64>,
    #[serde(default)]
    dist_coeff: Vec<f64>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    img_size: Option<[u32; 2]>,
}

/// A camera's name and what the file says of it.
#[derive(Clone, Debug)]
pub struct Named {
    pub name: String,
    pub entry: CalibrationEntry,
}

/// The file, in its order: others know cameras by their places in it.
#[derive(Clone, Debug, Default)]
pub struct CaptureCalibration {
    pub cameras: Vec<Named>,
}

impl<'de> Deserialize<'de> for CaptureCalibration {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        struct Visitor;
        impl<'de> de::Visitor<'de> for Visitor {
            type Value = CaptureCalibration;

            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                write!(f, "a camera for each name")
            }

            fn visit_map<M: MapAccess<'de>>(
                self,
                mut map: M,
            ) -> Result<CaptureCalibration, M::Error> {
                let mut cameras: Vec<Named> = Vec::new();
                while let Some((name, entry)) = map.next_entry::<String, CalibrationEntry>()? {
                    if cameras.len() == limits::CAMERAS {
                        let most = limits::CAMERAS;
                        return Err(de::Error::custom(format!("more than {most} cameras")));
                    }
                    let known = cameras.iter().any(|other| other.name == name);
                    if known || !is_name(&name) {
                        let name = excerpt(&name);
                        return Err(de::Error::custom(format!(
                            "camera `{name}`, which is no name of a folder or there twice"
                        )));
                    }
                    cameras.push(Named { name, entry });
                }
                Ok(CaptureCalibration { cameras })
            }
        }
        from.deserialize_map(Visitor)
    }
}

impl Serialize for CaptureCalibration {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        let mut map = to.serialize_map(Some(self.cameras.len()))?;
        for camera in &self.cameras {
            map.serialize_entry(&camera.name, &camera.entry)?;
        }
        map.end()
    }
}

/// Whether a text names a folder beside others, and nothing outside.
fn is_name(text: &str) -> bool {
    let plain = |c: char| c.is_alphanumeric() || matches!(c, '_' | '-' | '.' | ' ');
    !text.is_empty() && text.len() <= 100 && !text.starts_with('.') && text.chars().all(plain)
}

impl CaptureCalibration {
    /// Reads the file's text. `file` is named in errors.
    pub fn parse(file: &Path, bytes: &[u8]) -> Result<Self, CaptureError> {
        let read: Self = serde_json::from_slice(&text::utf8(bytes)).map_err(|error| {
            content(
                file,
                excerpt(&error.to_string()),
                "a JSON object with K, R, T and distCoeff of each camera",
            )
        })?;
        if read.cameras.is_empty() {
            return Err(content(file, "no cameras", "at least one"));
        }
        Ok(read)
    }

    /// The file of some cameras.
    pub fn of(cameras: &[CaptureCamera]) -> Self {
        let named = |camera: &CaptureCamera| Named {
            name: camera.name.clone(),
            entry: CalibrationEntry::of(&camera.camera, camera.distortion),
        };
        Self {
            cameras: cameras.iter().map(named).collect(),
        }
    }

    /// The file's text.
    pub fn text(&self) -> String {
        // One line a camera.
        let lines: Vec<String> = self
            .cameras
            .iter()
            .map(|camera| {
                let name = serde_json::to_string(&camera.name).unwrap_or_default();
                let entry = serde_json::to_string(&camera.entry).unwrap_or_default();
                format!("  {name}: {entry}")
            })
            .collect();
        format!("{{\n{}\n}}\n", lines.join(",\n"))
    }
}

impl CalibrationEntry {
    fn of(camera: &Camera, distortion: [f64; 5]) -> Self {
        let rows = |m: DMat3| m.transpose().to_cols_array().to_vec();
        let center = camera.center - HALF_PIXEL;
        let DVec2 { x: fx, y: fy } = camera.focal;
        Self {
            k: vec![fx, 0.0, center.x, 0.0, fy, center.y, 0.0, 0.0, 1.0],
            r: rows(camera.view.matrix3),
            t: camera.view.translation.to_array().to_vec(),
            dist_coeff: distortion.to_vec(),
            img_size: Some(camera.size),
        }
    }

    /// Width and height of its pictures, px, where the file says them.
    pub fn size(&self) -> Option<[u32; 2]> {
        self.img_size
    }

    /// The camera. `size`: of its pictures, px.
    pub fn camera(&self, name: &str, size: [u32; 2]) -> Result<CaptureCamera, FormatError> {
        let field = |what: &str| format!("{name}.{what}");
        let numbers = |what: &str, numbers: &[f64], count: usize| {
            let finite = numbers.iter().all(|n| n.is_finite());
            if numbers.len() == count && finite {
                return Ok(());
            }
            let found = if finite {
                format!("{} numbers", numbers.len())
            } else {
                "NaN or infinity".into()
            };
            Err(FormatError::metadata(
                &field(what),
                found,
                format!("{count} finite numbers"),
            ))
        };
        numbers("K", &self.k, 9)?;
        numbers("R", &self.r, 9)?;
        numbers("T", &self.t, 3)?;
        let pixels = u64::from(size[0]) * u64::from(size[1]);
        let fits = size.iter().all(|side| (1..=limits::SIDE).contains(side));
        if !fits || pixels > limits::PIXELS {
            return Err(FormatError::metadata(
                &field("imgSize"),
                format!("{size:?}"),
                format!("sides of 1 to {} px", limits::SIDE),
            ));
        }
        let rows = |v: &[f64]| {
            let array: [f64; 9] = std::array::from_fn(|at| v[at]);
            DMat3::from_cols_array(&array).transpose()
        };
        let k = rows(&self.k);
        let focal = DVec2::new(k.x_axis.x, k.y_axis.y);
        let skew = k.y_axis.x.abs() > 1e-3 * focal.x.abs() || k.x_axis.y != 0.0;
        let lowest = DVec3::new(k.x_axis.z, k.y_axis.z, k.z_axis.z);
        if focal.min_element() <= 0.0 || skew || lowest.distance(DVec3::Z) > 1e-6 {
            return Err(FormatError::metadata(
                &field("K"),
                format!("{:?}", self.k),
                "[fx, 0, cx, 0, fy, cy, 0, 0, 1] with fx and fy above 0",
            ));
        }
        let r = rows(&self.r);
        let turns = (r * r.transpose()).abs_diff_eq(DMat3::IDENTITY, MATRIX_SLACK);
        if !turns || r.determinant() <= 0.0 {
            return Err(FormatError::metadata(
                &field("R"),
                format!("a matrix with determinant {:.3}", r.determinant()),
                "a rotation, from the world to the camera's axes",
            ));
        }
        let translation = DVec3::new(self.t[0], self.t[1], self.t[2]);
        if translation.abs().max_element() > LENGTH {
            return Err(FormatError::metadata(
                &field("T"),
                format!("{:?}", self.t),
                format!("metres, at most {LENGTH}; millimetres are to be divided by 1000"),
            ));
        }
        Ok(CaptureCamera {
            name: name.into(),
            camera: Camera {
                view: DAffine3::from_rotation_translation(
                    DQuat::from_mat3(&r).normalize(),
                    translation,
                ),
                focal,
                center: DVec2::new(k.z_axis.x, k.z_axis.y) + HALF_PIXEL,
                size,
                near: Camera::NEAR,
            },
            distortion: self.distortion(&field("distCoeff"))?,
            held: false,
        })
    }

    fn distortion(&self, field: &str) -> Result<[f64; 5], FormatError> {
        let given = &self.dist_coeff;
        let rest = given.iter().skip(5).all(|&k| k == 0.0);
        let finite = given.iter().all(|k| k.is_finite() && k.abs() < 1e6);
        if !rest || !finite || given.len() > 14 {
            return Err(FormatError::metadata(
                field,
                excerpt(&format!("{given:?}")),
                "k1, k2, p1, p2, k3 of OpenCV's model",
            ));
        }
        Ok(std::array::from_fn(|at| {
            given.get(at).copied().unwrap_or(0.0)
        }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown() -> CaptureCamera {
        let eye = DVec3::new(0.4, 1.2, 3.0);
        CaptureCamera {
            name: "cam00".into(),
            camera: Camera::look_at(eye, DVec3::Y, 0.5, [64, 48]),
            distortion: [0.1, 0.0, 0.0, -0.2, 0.0],
            held: false,
        }
    }

    #[test]
    fn cameras_survive_the_file() {
        let before = shown();
        let text = CaptureCalibration::of(std::slice::from_ref(&before)).text();
        let read =
            CaptureCalibration::parse(Path::new("c"), text.as_bytes()).expect("a calibration");
        let entry = &read.cameras[0].entry;
        let after = entry
            .camera("cam00", entry.size().expect("a size"))
            .expect("a camera");
        assert!(after.camera.view.abs_diff_eq(before.camera.view, 1e-12));
        assert!(after.camera.center.distance(before.camera.center) < 1e-12);
        assert_eq!(after.distortion, before.distortion);
    }

    #[test]
    fn numbers_that_are_no_camera_are_refused() {
        let with = |change: &dyn Fn(&mut CalibrationEntry)| {
            let mut entry = CalibrationEntry::of(&shown().camera, [0.0; 5]);
            change(&mut entry);
            entry
                .camera("c", [64, 48])
                .err()
                .map(|error| error.to_string())
        };
        assert_eq!(with(&|_| {}), None);
        let expect = |found: Option<String>, word: &str| {
            assert!(
                found.as_ref().is_some_and(|text| text.contains(word)),
                "{found:?}"
            );
        };
        expect(with(&|entry| entry.r[0] = 5.0), "a rotation");
        expect(
            with(&|entry| entry.r.iter_mut().for_each(|n| *n = -*n)),
            "a rotation",
        );
        expect(with(&|entry| entry.t[1] = f64::NAN), "finite");
        expect(with(&|entry| entry.t[1] = 2e5), "metres");
        expect(with(&|entry| entry.k[0] = -1.0), "fx");
        expect(with(&|entry| entry.k[1] = 9.0), "fx");
        expect(with(&|entry| entry.k.truncate(8)), "8 numbers");
        expect(with(&|entry| entry.dist_coeff = vec![1.0; 8]), "k1");
        for (text, word) in [
            ("{}", "no cameras"),
            ("[]", "JSON"),
            (r#"{"../a": {"K": [], "R": [], "T": []}}"#, "no name"),
            (
                r#"{"a": {"K": [], "R": [], "T": []}, "a": {"K": [], "R": [], "T": []}}"#,
                "twice",
            ),
            (r#"{"a": {"K": [1e999], "R": [], "T": []}}"#, "JSON"),
        ] {
            let error = CaptureCalibration::parse(Path::new("c"), text.as_bytes()).err();
            expect(error.map(|error| error.to_string()), word);
        }
    }
}
