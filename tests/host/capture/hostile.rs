//! Nothing in a capture's files makes the program panic, and errors name the file.

use super::copied;
use effigy_capture::{Capture, CaptureError};
use effigy_core::random::Random;
use std::{fs, path::Path};

/// Files that are damaged, one at a time.
const FILES: [&str; 6] = [
    "calibration.json",
    "smpl_params.npz",
    "template.npz",
    "split.json",
    "images/cam01/00000001.png",
    "masks/cam01/00000001.jpg",
];

fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    copied(folder.path(), |name| name.to_owned());
    let split = r#"{"cameras": ["cam01"], "frames": [2]}"#;
    fs::write(folder.path().join("split.json"), split).unwrap();
    folder
}

/// Opens and decodes all of it.
fn open(folder: &Path) -> Result<usize, CaptureError> {
    let capture = Capture::read(folder)?;
    let found = capture.check(&|_, _| {});
    Ok(found.len() + capture.left_out.len())
}

/// Every file cut short at many lengths, emptied and missing.
fn cut_files_are_errors_or_left_out() {
    let folder = folder();
    assert_eq!(open(folder.path()).unwrap(), 0);
    for name in FILES {
        let file = folder.path().join(name);
        let whole = fs::read(&file).unwrap();
        for part in 0..24 {
            fs::write(&file, &whole[..whole.len() * part / 24]).unwrap();
            match open(folder.path()) {
                Err(error) => {
                    let text = error.to_string();
                    assert!(text.contains(name), "{text}");
                }
                // Decoders forgive an end that holds nothing but a checksum or an end mark.
                Ok(found) => assert!(found > 0 || part > 20, "{name} at {part}"),
            }
        }
        fs::remove_file(&file).unwrap();
        let found = open(folder.path());
        let may_be_absent = name == "split.json";
        assert!(
            may_be_absent || found.is_err() || found.is_ok_and(|found| found > 0),
            "{name}"
        );
        fs::write(&file, &whole).unwrap();
    }
}

/// Random bytes in every file.
fn changed_bytes_never_panic() {
    let folder = folder();
    for (index, name) in FILES.into_iter().enumerate() {
        let file = folder.path().join(name);
        let whole = fs::read(&file).unwrap();
        for round in 0..40 {
            let mut random = Random::new(11, (index * 1000 + round) as u64);
            let mut bytes = whole.clone();
            for _ in 0..1 + random.bits() % 6 {
                let at = random.bits() as usize % bytes.len();
                bytes[at] = random.bits() as u8;
            }
            fs::write(&file, bytes).unwrap();
            if let Err(error) = open(folder.path()) {
                assert!(!error.to_string().is_empty());
            }
        }
        fs::write(&file, &whole).unwrap();
    }
}

/// Cameras and masks that are no good are left out by name; nothing left is an error.
fn faults_are_named() {
    let folder = folder();
    let file = folder.path().join("calibration.json");
    let text = fs::read_to_string(&file).unwrap();
    let sees_nothing = text.replacen("[0.1, -0.2, 3.2]", "[0.1, -0.2, -30.0]", 1);
    fs::write(&file, sees_nothing).unwrap();
    let capture = Capture::read(folder.path()).unwrap();
    let found = capture.check(&|_, _| {});
    assert_eq!(found.len(), 1);
    let text_of = found[0].to_string();
    assert!(
        text_of.contains("camera cam00") && text_of.contains("no joint"),
        "{text_of}"
    );
    let capture = capture.without(found).unwrap();
    assert!(!capture.has(0, 0) && capture.has(1, 0));

    let turned = text.replacen("\"R\": [", "\"R\": [7.5, ", 1);
    fs::write(&file, turned).unwrap();
    let capture = Capture::read(folder.path()).unwrap();
    assert_eq!(capture.cameras.len(), 1);
    assert!(
        capture.left_out[0].to_string().contains("cam00.R"),
        "{}",
        capture.left_out[0]
    );
    fs::write(&file, &text).unwrap();

    fs::write(
        folder.path().join("split.json"),
        r#"{"cameras": ["cam77"]}"#,
    )
    .unwrap();
    let error = Capture::read(folder.path()).unwrap_err().to_string();
    assert!(
        error.contains("cam77") && error.contains("split.json"),
        "{error}"
    );
    fs::remove_file(folder.path().join("split.json")).unwrap();

    fs::remove_dir_all(folder.path().join("images")).unwrap();
    let error = Capture::read(folder.path()).unwrap_err().to_string();
    assert!(
        error.contains("0 usable frames") && error.contains("6 missing"),
        "{error}"
    );
}

tests! {
    cut_files_are_errors_or_left_out,
    changed_bytes_never_panic,
    faults_are_named,
}
