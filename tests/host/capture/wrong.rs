//! Captures that other programs or people have laid out a little otherwise.

use super::copied;
use effigy_capture::Capture;
use std::{fs, path::Path};

fn folder(place: impl Fn(&str) -> String) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    copied(folder.path(), place);
    folder
}

/// Rewrites the numbers of `T` in the calibration.
fn scaled(folder: &Path, scale: f64) {
    let file = folder.join("calibration.json");
    let text = fs::read_to_string(&file).unwrap();
    let mut calibration: serde_json::Value = serde_json::from_str(&text).unwrap();
    for camera in calibration.as_object_mut().unwrap().values_mut() {
        for number in camera["T"].as_array_mut().unwrap() {
            *number = (scale * number.as_f64().unwrap()).into();
        }
    }
    fs::write(&file, calibration.to_string()).unwrap();
}

fn lengths_that_are_no_metres_are_named() {
    for (scale, expected) in [
        (
            1000.0,
            "T in metres: as it seems it is in millimetres, to be divided by 1000",
        ),
        (
            100.0,
            "T in metres: as it seems it is in centimetres, to be divided by 100",
        ),
        (2000.0, "millimetres"),
        (10_000.0, "millimetres"),
    ] {
        let folder = folder(str::to_owned);
        scaled(folder.path(), scale);
        let error = Capture::read(folder.path()).unwrap_err().to_string();
        assert!(
            error.contains(expected) && error.contains("calibration.json"),
            "{error}"
        );
    }
    // A large room is none of that.
    let folder = folder(str::to_owned);
    scaled(folder.path(), 4.0);
    assert!(Capture::read(folder.path()).is_ok());
}

fn names_may_have_more_than_the_frames_number() {
    let own = Capture::read(super::FOLDER.as_ref()).unwrap();
    for name in ["00000001.png.jpg", "mask_00000001.jpg", "1-alpha.jpg"] {
        let folder = folder(|path| {
            let Some(rest) = path.strip_prefix("masks/") else {
                return path.to_owned();
            };
            let (camera, file) = rest.split_once('/').unwrap();
            let number: u32 = file.trim_end_matches(".jpg").parse().unwrap();
            let name = name.replace("00000001", &format!("{number:08}"));
            format!(
                "masks/{camera}/{}",
                name.replace("1-", &format!("{number}-"))
            )
        });
        let capture = Capture::read(folder.path()).unwrap();
        assert_eq!(
            (capture.pictures(), &capture.left_out[..]),
            (6, &[][..]),
            "{name}"
        );
        assert_eq!(capture.picture(1, 2).unwrap(), own.picture(1, 2).unwrap());
    }
    for (from, to) in [(".jpg", ".npy"), ("0000000", "frame_2_000")] {
        let folder = folder(|path| match path.starts_with("masks") {
            true => path.replace(from, to),
            false => path.to_owned(),
        });
        let error = Capture::read(folder.path()).unwrap_err().to_string();
        assert!(
            error.contains("masks/cam00/00000000.png") && error.contains(to),
            "{error}"
        );
    }
}

/// Of two files of one frame the first by name is taken, whatever order the disk has them in.
fn of_two_masks_of_a_frame_the_first_by_name_is_taken() {
    let folder = folder(str::to_owned);
    let jpeg = folder.path().join("masks/cam00/00000000.jpg");
    let empty = image::GrayImage::new(96, 80);
    empty.save(jpeg.with_extension("png")).unwrap();
    let capture = Capture::read(folder.path()).unwrap();
    assert!(capture.picture(0, 0).unwrap().mask.contains(&255));
}

/// Pictures where masks are expected and masks where pictures are.
fn swapped_folders_are_named() {
    let folder = folder(|path| match path.split_once('/') {
        Some(("images", rest)) => format!("masks/{rest}"),
        Some(("masks", rest)) => format!("images/{rest}"),
        _ => path.to_owned(),
    });
    let capture = Capture::read(folder.path()).unwrap();
    assert!(capture.masks.is_useless(), "{}", capture.masks);
    let text = capture.masks.to_string();
    assert!(text.contains("a picture in colour"), "{text}");
}

tests! {
    lengths_that_are_no_metres_are_named,
    names_may_have_more_than_the_frames_number,
    of_two_masks_of_a_frame_the_first_by_name_is_taken,
    swapped_folders_are_named,
}
