//! Masks of every kind that people have, made of one sound capture's.

use super::{FOLDER, copied};
use effigy_capture::{Capture, OmissionReason};
use image::{
    DynamicImage, GrayImage, ImageBuffer, ImageFormat, Luma, Rgb, RgbImage, Rgba, RgbaImage,
};
use std::{
    fs,
    path::{Path, PathBuf},
};

/// The person's pixels of a mask, and where they are.
struct Person {
    size: [u32; 2],
    pixels: Vec<bool>,
}

impl Person {
    fn of(mask: &Path) -> Self {
        let image = image::open(mask).unwrap().to_luma8();
        Self {
            size: image.dimensions().into(),
            pixels: image.pixels().map(|pixel| pixel.0[0] > 128).collect(),
        }
    }

    fn is(&self, x: u32, y: u32) -> bool {
        self.pixels[(y * self.size[0] + x) as usize]
    }

    /// A mask of 8 bits. `number`: of a pixel, by whether it is the person's.
    fn grey(&self, number: impl Fn(bool, u32) -> u8) -> DynamicImage {
        let [w, h] = self.size;
        GrayImage::from_fn(w, h, |x, y| Luma([number(self.is(x, y), x)])).into()
    }

    fn deep(&self, number: u16) -> DynamicImage {
        let [w, h] = self.size;
        let of = |x, y| Luma([if self.is(x, y) { number } else { 0 }]);
        ImageBuffer::<Luma<u16>, Vec<u16>>::from_fn(w, h, of).into()
    }

    fn colors(&self, color: impl Fn(bool, u32, u32) -> [u8; 3]) -> DynamicImage {
        let [w, h] = self.size;
        RgbImage::from_fn(w, h, |x, y| Rgb(color(self.is(x, y), x, y))).into()
    }

    /// `color`: under an alpha channel that is the mask.
    fn alpha(&self, color: impl Fn(u32, u32) -> [u8; 3]) -> DynamicImage {
        let [w, h] = self.size;
        let of = |x, y| {
            let [r, g, b] = color(x, y);
            Rgba([r, g, b, if self.is(x, y) { 255 } else { 0 }])
        };
        RgbaImage::from_fn(w, h, of).into()
    }
}

/// The masks of a capture's folder.
fn masks(folder: &Path) -> Vec<PathBuf> {
    let of = |camera: &str| fs::read_dir(folder.join("masks").join(camera)).unwrap();
    let all = ["cam00", "cam01"].into_iter().flat_map(of);
    let mut all: Vec<PathBuf> = all.map(|entry| entry.unwrap().path()).collect();
    all.sort();
    all
}

/// The capture with masks of another kind, by their place among all.
fn with(format: ImageFormat, kind: impl Fn(usize, &Person) -> DynamicImage) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    copied(folder.path(), str::to_owned);
    for (at, mask) in masks(folder.path()).iter().enumerate() {
        let image = kind(at, &Person::of(mask));
        fs::remove_file(mask).unwrap();
        let ending = format.extensions_str()[0];
        image
            .save_with_format(mask.with_extension(ending), format)
            .unwrap();
    }
    folder
}

/// The masks of all pictures, as they are used.
fn read(capture: &Capture) -> Vec<Vec<u8>> {
    let all = (0..capture.frames.len()).flat_map(|frame| [(0, frame), (1, frame)]);
    all.map(|(camera, frame)| capture.picture(camera, frame).unwrap().mask)
        .collect()
}

fn byte(is_person: bool) -> u8 {
    if is_person { 255 } else { 0 }
}

/// A colour photograph's: many, and dark ones among them.
fn photograph(x: u32, y: u32) -> [u8; 3] {
    [(2 * x) as u8, (3 * y) as u8, (x * y % 97) as u8]
}

fn masks_of_every_kind_show_the_same_person() {
    use ImageFormat::Png;
    let plain = with(Png, |_, own| own.grey(|is, _| byte(is)));
    let plain = Capture::read(plain.path()).unwrap();
    assert_eq!(plain.assumptions, []);
    assert_eq!((plain.masks.count, plain.masks.faults.len()), (6, 0));
    let expected = read(&plain);
    let folders = [
        (
            "0 and 1",
            with(Png, |_, own| own.grey(|is, _| u8::from(is))),
        ),
        (
            "0 and 128",
            with(Png, |_, own| own.grey(|is, _| if is { 128 } else { 0 })),
        ),
        (
            "classes",
            with(Png, |_, own| {
                own.grey(|is, x| if is { 1 + (x / 7 % 19) as u8 } else { 0 })
            }),
        ),
        ("0 and 1 in 16 bits", with(Png, |_, own| own.deep(1))),
        (
            "classes in 16 bits",
            with(Png, |at, own| own.deep(3 + at as u16)),
        ),
        ("16 bits", with(Png, |_, own| own.deep(u16::MAX))),
        (
            "RGB",
            with(Png, |_, own| own.colors(|is, _, _| [byte(is); 3])),
        ),
        (
            "colours of classes",
            with(Png, |_, own| {
                let classes = [[128, 0, 0], [0, 85, 0], [0, 0, 85], [51, 85, 128]];
                own.colors(|is, x, _| {
                    if is {
                        classes[x as usize / 5 % 4]
                    } else {
                        [0; 3]
                    }
                })
            }),
        ),
        (
            "alpha alone",
            with(Png, |_, own| own.alpha(|_, _| [200; 3])),
        ),
        (
            "alpha of black",
            with(Png, |_, own| own.alpha(|_, _| [0; 3])),
        ),
        (
            "a cut-out person",
            with(Png, |_, own| own.alpha(photograph)),
        ),
        ("inverted", with(Png, |_, own| own.grey(|is, _| byte(!is)))),
        (
            "inverted 0 and 1",
            with(Png, |_, own| own.grey(|is, _| u8::from(!is))),
        ),
        (
            "0 and 1 of one camera",
            with(Png, |at, own| {
                own.grey(|is, _| if at < 3 { u8::from(is) } else { byte(is) })
            }),
        ),
        (
            "classes of the other camera",
            with(Png, |at, own| {
                let class = 1 + (at % 19) as u8;
                own.grey(|is, _| match (is, at < 3) {
                    (true, true) => 255,
                    (true, false) => class,
                    (false, _) => 0,
                })
            }),
        ),
        (
            "colours of one camera",
            with(Png, |at, own| match at < 3 {
                true => own.colors(|is, _, _| if is { [0, 85, 0] } else { [0; 3] }),
                false => own.grey(|is, _| byte(is)),
            }),
        ),
        (
            "alpha of one camera, 0 and 1 of the other",
            with(Png, |at, own| match at < 3 {
                true => own.alpha(photograph),
                false => own.grey(|is, _| u8::from(is)),
            }),
        ),
        (
            "inverted of one camera",
            with(Png, |at, own| own.grey(|is, _| byte(is != (at < 3)))),
        ),
        (
            "inverted of one camera, 0 and 1 of the other",
            with(Png, |at, own| {
                own.grey(|is, _| match at < 3 {
                    true => byte(!is),
                    false => u8::from(is),
                })
            }),
        ),
    ];
    for (what, folder) in folders {
        let capture = Capture::read(folder.path()).unwrap();
        assert_eq!(capture.masks.faults, [], "{what}");
        let is_said = !capture.assumptions.is_empty();
        assert_eq!(is_said, !["16 bits", "RGB"].contains(&what), "{what}");
        assert_eq!(capture.check(&|_, _| {}), [], "{what}");
        for (own, expected) in read(&capture).iter().zip(&expected) {
            let differ = own.iter().zip(expected).filter(|(a, b)| a != b).count();
            // Taking out a lens's distortion mixes other numbers outside the picture.
            assert!(differ <= 2, "{what}: {differ} pixels differ");
        }
    }
}

/// The alpha channel of pictures that have no masks beside them.
fn pictures_may_have_the_mask_themselves() {
    let folder = tempfile::tempdir().unwrap();
    copied(folder.path(), str::to_owned);
    let expected = with(ImageFormat::Png, |_, own| own.grey(|is, _| byte(is)));
    let expected = read(&Capture::read(expected.path()).unwrap());
    for mask in masks(folder.path()) {
        let picture = mask.to_str().unwrap().replace("masks", "images");
        let picture = Path::new(&picture).with_extension("png");
        let colors = image::open(&picture).unwrap().to_rgb8();
        let whole = Person::of(&mask).alpha(|x, y| colors.get_pixel(x, y).0);
        whole.save(&picture).unwrap();
    }
    fs::remove_dir_all(folder.path().join("masks")).unwrap();
    let capture = Capture::read(folder.path()).unwrap();
    assert_eq!((capture.pictures(), capture.masks.faults.len()), (6, 0));
    assert!(capture.assumptions[0].because.contains("6 pictures"));
    assert_eq!(read(&capture), expected);
    // An alpha channel that says nothing is no mask.
    let opaque = folder.path().join("images/cam00/00000000.png");
    let image = image::open(&opaque).unwrap().to_rgb8();
    DynamicImage::from(image).to_rgba8().save(&opaque).unwrap();
    let capture = Capture::read(folder.path()).unwrap();
    let fault = capture.masks.faults[0].to_string();
    assert!(
        fault.contains("same everywhere") && fault.contains("cam00"),
        "{fault}"
    );
}

/// A frame's wrong mask says nothing of its camera's others.
fn one_inverted_mask_turns_no_others() {
    let folder = with(ImageFormat::Png, |at, own| {
        own.grey(|is, _| byte(is != (at == 1)))
    });
    let capture = Capture::read(folder.path()).unwrap();
    assert_eq!(capture.assumptions, []);
    let [ref fault] = capture.masks.faults[..] else {
        panic!("{:?}", capture.masks)
    };
    assert!(
        matches!(fault.reason, OmissionReason::InvertedMask),
        "{fault}"
    );
}

/// Of more cameras than masks are looked at, too, each is looked at.
fn every_camera_is_looked_at() {
    const CAMERAS: usize = 21;
    let folder = tempfile::tempdir().unwrap();
    copied(folder.path(), str::to_owned);
    let calibration = folder.path().join("calibration.json");
    let text = fs::read_to_string(&calibration).unwrap();
    let mut cameras: serde_json::Map<String, serde_json::Value> =
        serde_json::from_str(&text).unwrap();
    for number in 2..CAMERAS {
        let name = format!("cam{number:02}");
        copied(folder.path(), |file| file.replace("cam01", &name));
        cameras.insert(name, cameras["cam01"].clone());
    }
    let text = serde_json::to_string(&cameras).unwrap();
    for number in 2..CAMERAS {
        fs::write(&calibration, &text).unwrap();
        let own = folder.path().join(format!("masks/cam{number:02}"));
        let files = fs::read_dir(&own).unwrap();
        let files: Vec<PathBuf> = files.map(|entry| entry.unwrap().path()).collect();
        for mask in &files {
            let image = Person::of(mask).grey(|is, _| u8::from(is));
            fs::remove_file(mask).unwrap();
            image.save(mask.with_extension("png")).unwrap();
        }
        let capture = Capture::read(folder.path()).unwrap();
        let said = capture.assumptions[0].to_string();
        assert!(
            said.contains(&format!("cam{number:02}")),
            "{number}: {said}"
        );
        fs::remove_dir_all(&own).unwrap();
        let name = format!("masks/cam{number:02}");
        copied(folder.path(), |file| file.replace("masks/cam01", &name));
    }
}

/// Masks that leave open who the person is are named, with what was found.
fn masks_that_show_nobody_are_named() {
    use ImageFormat::{Jpeg, Png};
    let cases = [
        (
            "an empty mask",
            true,
            with(Png, |_, own| own.grey(|_, _| 0)),
        ),
        (
            "a mask that is full",
            true,
            with(Png, |_, own| own.grey(|_, _| 255)),
        ),
        (
            "numbers up to 1 of 255",
            true,
            with(Png, |_, own| own.grey(|_, _| 1)),
        ),
        (
            "numbers up to",
            true,
            with(Png, |_, own| {
                own.grey(|is, x| if is { 60 + (x % 41) as u8 } else { 0 })
            }),
        ),
        (
            "of 255 in the mask",
            true,
            with(Jpeg, |_, own| own.grey(|is, _| 14 * u8::from(is))),
        ),
        (
            "a picture in colour",
            true,
            with(Png, |_, own| own.colors(|_, x, y| photograph(x, y))),
        ),
        (
            "a picture in colour",
            true,
            with(Jpeg, |_, own| own.colors(|_, x, y| photograph(x, y))),
        ),
        (
            "an empty mask",
            false,
            with(Png, |at, own| own.grey(|is, _| byte(is && at % 2 > 0))),
        ),
        (
            "numbers up to 1 of 255",
            false,
            with(Png, |at, own| {
                own.grey(|is, _| if at == 3 { u8::from(is) } else { byte(is) })
            }),
        ),
    ];
    for (expected, is_useless, folder) in cases {
        let capture = Capture::read(folder.path()).unwrap();
        let text = capture.masks.to_string();
        assert!(text.contains(expected), "{text}");
        assert_eq!(capture.masks.is_useless(), is_useless, "{text}");
    }
}

/// A JPEG's noise around 0 and 255 is no class.
fn noise_around_black_and_white_changes_nothing() {
    let capture = Capture::read(FOLDER.as_ref()).unwrap();
    assert_eq!(
        (&capture.assumptions[..], capture.masks.count),
        (&[][..], 6)
    );
    assert_eq!(capture.masks.faults, []);
    // Noise alone, where the person is out of the picture, is nobody.
    let folder = with(ImageFormat::Png, |at, own| {
        own.grey(|is, x| if at == 0 { (x % 3) as u8 } else { byte(is) })
    });
    let capture = Capture::read(folder.path()).unwrap();
    assert!(read(&capture)[0].iter().all(|&part| part == 0));
    let found = &capture.masks.faults[0].reason;
    assert_eq!(*found, OmissionReason::EmptyMask { highest: 2 });
}

tests! {
    masks_of_every_kind_show_the_same_person,
    pictures_may_have_the_mask_themselves,
    one_inverted_mask_turns_no_others,
    every_camera_is_looked_at,
    masks_that_show_nobody_are_named,
    noise_around_black_and_white_changes_nothing,
}
