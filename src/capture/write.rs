//! Writing a capture's folder, in THuman4's layout. The calibration is written last: without it
//! there is no capture.

use crate::{
    calibration::{CaptureCalibration, CaptureCamera},
    capture::CaptureFrame,
    error::{CaptureError, unwritable},
    layouts,
    picture::{self, Picture},
    poses,
    split::{self, Split},
    template::{self, Template},
};
use effigy_core::{avatar::Pose, io::file::replace};
use image::ExtendedColorType;
use std::{
    fs, io,
    path::{Path, PathBuf},
};

/// A capture in the making. Write its pictures, then [`finish`](Self::finish) it.
pub struct CaptureWriter {
    folder: PathBuf,
    cameras: Vec<CaptureCamera>,
    /// Rotations and expression numbers of a pose.
    joints: usize,
    expression: usize,
}

impl CaptureWriter {
    /// Begins a capture. Pictures and masks of an earlier one in the folder are removed.
    ///
    /// # Errors
    /// When the folder or a file in it cannot be written.
    pub fn new(
        folder: &Path,
        cameras: &[CaptureCamera],
        template: &Template,
    ) -> Result<Self, CaptureError> {
        let layout = layouts::OWN;
        let calibration = folder.join(layout.calibration);
        if calibration.exists() {
            fs::remove_file(&calibration).map_err(|cause| unwritable(&calibration, cause))?;
        }
        for camera in cameras {
            for below in [
                (layout.pictures)(&camera.name),
                (layout.masks)(&camera.name),
            ] {
                let path = folder.join(below);
                if path.exists() {
                    fs::remove_dir_all(&path).map_err(|cause| unwritable(&path, cause))?;
                }
                fs::create_dir_all(&path).map_err(|cause| unwritable(&path, cause))?;
            }
        }
        let file = folder.join(template::FILE);
        let bytes = template
            .encode()
            .map_err(|error| unwritable(&file, io::Error::other(error)))?;
        replace(&file, &bytes)?;
        Ok(Self {
            folder: folder.into(),
            cameras: cameras.to_vec(),
            joints: template.skeleton.len(),
            expression: template.expression,
        })
    }

    /// Writes a camera's picture of a frame, by index and number, and its mask. Pictures may come
    /// in any order, from any thread.
    ///
    /// # Errors
    /// When a file cannot be written, or the picture has fewer or more pixels than its size says.
    pub fn write(&self, camera: usize, frame: u32, picture: &Picture) -> Result<(), CaptureError> {
        let layout = layouts::OWN;
        let name = &self.cameras[camera].name;
        let color = picture.color.as_flattened();
        for (below, bytes, kind) in [
            ((layout.pictures)(name), color, ExtendedColorType::Rgb8),
            (
                (layout.masks)(name),
                &picture.mask[..],
                ExtendedColorType::L8,
            ),
        ] {
            let file = self.folder.join(below).join(format!("{frame:08}.png"));
            let pixels = u64::from(picture.size[0]) * u64::from(picture.size[1]);
            let written = if bytes.len() as u64 == pixels * u64::from(kind.channel_count()) {
                picture::png(picture.size, bytes, kind).and_then(|png| fs::write(&file, png))
            } else {
                Err(io::Error::other("as many pixels as its size says"))
            };
            written.map_err(|cause| unwritable(&file, cause))?;
        }
        Ok(())
    }

    /// Writes poses, split and calibration, which makes the folder a capture. `frames`: by number,
    /// without gaps, from 0 on.
    ///
    /// # Errors
    /// When a file cannot be written.
    pub fn finish(self, frames: &[CaptureFrame]) -> Result<(), CaptureError> {
        let poses: Vec<&Pose> = frames.iter().map(|frame| &frame.pose).collect();
        let file = self.folder.join(poses::FILE);
        let bytes = poses::encode(&poses, self.joints, self.expression)
            .map_err(|error| unwritable(&file, io::Error::other(error)))?;
        replace(&file, &bytes)?;
        let file = self.folder.join(split::FILE);
        let cameras = self.cameras.iter().filter(|camera| camera.held);
        let held = Split {
            cameras: cameras.map(|camera| camera.name.clone()).collect(),
            frames: frames.iter().filter(|f| f.held).map(|f| f.number).collect(),
        };
        let text = serde_json::to_string(&held).map_err(|error| unwritable(&file, error.into()))?;
        replace(&file, text.as_bytes())?;
        let file = self.folder.join(layouts::OWN.calibration);
        replace(
            &file,
            CaptureCalibration::of(&self.cameras).text().as_bytes(),
        )?;
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Capture, OmissionReason, VertexInfluence, limits};
    use effigy_core::{avatar::Skeleton, scene::Camera};
    use glam::DVec3;

    /// Two joints, three vertices.
    fn template() -> Template {
        let influence = |joint| VertexInfluence { joint, weight: 1.0 };
        Template {
            skeleton: Skeleton {
                name: vec!["root".into(), "Überarm".into()],
                parent: vec![None, Some(0)],
                rest: vec![[0.0, 1.0, 0.0], [0.25, 1.0, 0.0]],
                canonical: vec![[0.0; 3], [0.0, 0.0, 0.5]],
            },
            vertices: vec![DVec3::ZERO, DVec3::X, DVec3::Y],
            triangles: vec![[0, 1, 2]],
            weights: vec![vec![influence(0)], vec![influence(1)], vec![influence(0)]],
            input_joints: vec![1],
            head_joints: vec![],
            expression: 1,
        }
    }

    fn camera(name: &str, held: bool) -> CaptureCamera {
        let eye = DVec3::new(0.0, 1.0, 3.0);
        CaptureCamera {
            name: name.into(),
            camera: Camera::look_at(eye, DVec3::Y, 1.0, [8, 6]),
            distortion: [0.0; 5],
            held,
        }
    }

    fn frames() -> Vec<CaptureFrame> {
        let frame = |number| CaptureFrame {
            number,
            pose: Pose {
                rotation: vec![DVec3::new(0.1, 0.2, f64::from(number)), DVec3::Z],
                translation: DVec3::new(0.0, 0.5, 0.0),
                expression: vec![0.25],
            },
            held: number == 2,
        };
        (0..3).map(frame).collect()
    }

    fn picture() -> Picture {
        Picture {
            size: [8, 6],
            color: (0..48).map(|at| [at, 2 * at, 200]).collect(),
            mask: (0..48).map(|at| if at % 8 < 5 { 255 } else { 0 }).collect(),
        }
    }

    fn written() -> tempfile::TempDir {
        let folder = tempfile::tempdir().expect("a folder");
        let cameras = [camera("cam00", false), camera("cam01", true)];
        let writer = CaptureWriter::new(folder.path(), &cameras, &template()).expect("a writer");
        for camera in 0..2 {
            for frame in 0..3 {
                writer.write(camera, frame, &picture()).expect("written");
            }
        }
        writer.finish(&frames()).expect("finished");
        folder
    }

    #[test]
    fn a_capture_survives_its_files() {
        let folder = written();
        let capture = Capture::read(folder.path()).expect("a capture");
        assert_eq!(capture.frames, frames());
        assert_eq!(capture.template, template());
        assert_eq!(capture.left_out, []);
        let found: Vec<bool> = capture.cameras.iter().map(|camera| camera.held).collect();
        assert_eq!(found, [false, true]);
        assert!(capture.has(1, 2) && !capture.has(2, 0) && !capture.has(0, 3));
        assert_eq!(capture.picture(1, 2).expect("a picture"), picture());
        assert!(capture.picture(0, 3).is_err());
    }

    #[test]
    fn what_is_missing_or_odd_is_left_out() {
        let folder = written();
        let path = |name: &str| folder.path().join(name);
        fs::remove_file(path("images/cam00/00000000.png")).unwrap();
        fs::remove_file(path("masks/cam00/00000001.png")).unwrap();
        fs::write(
            path("images/cam00/00000002.png"),
            b"GIF89a and so on, long enough",
        )
        .unwrap();
        let small = picture::png([4, 6], &[9; 24], ExtendedColorType::L8).unwrap();
        fs::write(path("masks/cam01/00000000.png"), small).unwrap();
        fs::copy(
            path("images/cam01/00000001.png"),
            path("images/cam01/00000007.png"),
        )
        .unwrap();
        fs::write(path("missing_img_files.txt"), "cam01\\00000001.png\n").unwrap();
        let capture = Capture::read(folder.path()).expect("a capture");
        let found: Vec<String> = capture
            .left_out
            .iter()
            .map(|entry| format!("{:?} {}", entry.frame.unwrap(), entry.reason.kind()))
            .collect();
        let expected = [
            "1 missing",
            "2 unreadable",
            "0 missing",
            "0 of another size",
            "1 listed as missing",
            "7 without a pose",
        ];
        assert_eq!(found, expected);
        let numbers: Vec<u32> = capture.frames.iter().map(|frame| frame.number).collect();
        assert_eq!(numbers, [2]);
        assert!(capture.has(1, 0) && !capture.has(0, 0));
        assert!(matches!(
            capture.left_out[3].reason,
            OmissionReason::Size { found: [4, 6], .. }
        ));
    }

    #[test]
    fn cut_pictures_are_found_by_the_full_check() {
        let folder = written();
        let file = folder.path().join("images/cam00/00000001.png");
        let bytes = fs::read(&file).unwrap();
        fs::write(&file, &bytes[..bytes.len() / 2]).unwrap();
        let empty = picture::png([8, 6], &[0; 48], ExtendedColorType::L8).unwrap();
        fs::write(folder.path().join("masks/cam01/00000002.png"), empty).unwrap();
        let capture = Capture::read(folder.path()).expect("a capture");
        assert_eq!(capture.left_out, []);
        let found = capture.check(&|_, _| {});
        let kinds: Vec<&str> = found.iter().map(|entry| entry.reason.kind()).collect();
        assert_eq!(kinds, ["unreadable", "with an empty mask"]);
        let capture = capture.without(found).expect("a capture");
        assert_eq!((capture.pictures(), capture.left_out.len()), (4, 2));
        assert!(!capture.has(0, 1) && capture.has(1, 1));
    }

    #[test]
    fn nothing_usable_is_an_error_that_says_why() {
        let folder = written();
        fs::remove_dir_all(folder.path().join("masks")).unwrap();
        let error = Capture::read(folder.path())
            .expect_err("no masks")
            .to_string();
        assert!(
            error.contains("0 usable frames") && error.contains("6 missing"),
            "{error}"
        );
        fs::remove_file(folder.path().join("calibration.json")).unwrap();
        let error = Capture::read(folder.path())
            .expect_err("no layout")
            .to_string();
        assert!(
            error.contains("calibration_full.json (AvatarReX)"),
            "{error}"
        );
        const { assert!(limits::SIDE as u64 * limits::SIDE as u64 >= limits::PIXELS) };
    }
}
