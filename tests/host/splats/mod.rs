//! Splat formats: `tests/data/splats/make.py` had programs that know nothing of Effigy write the same
//! splats in each; every number comes back within the format's own steps.

pub mod bad_rows;
pub mod containers;
pub mod drafts;
pub mod hostile;
pub mod streamed;
pub mod written;

use effigy_core::{
    avatar::{Filter, ShCoefficients},
    io::splats::{Splats, Up, functions_of},
};
use effigy_formats::splats::{self, Nothing, SplatFormat};
use glam::{DQuat, DVec3};

macro_rules! files {
    ($($name:ident = $file:literal as $format:ident,)*) => {
        $(pub const $name: File = File {
            name: $file,
            bytes: include_bytes!(concat!("../../data/splats/", $file)),
            format: SplatFormat::$format,
        };)*
        /// Every file.
        pub const FILES: &[File] = &[$($name),*];
    };
}

/// A file of the test data.
#[derive(Clone, Copy)]
pub struct File {
    pub name: &'static str,
    pub bytes: &'static [u8],
    pub format: SplatFormat,
}

files! {
    TRUTH = "truth.ply" as Ply,
    COMPRESSED = "small.compressed.ply" as Ply,
    MANY = "many.compressed.ply" as Ply,
    SPLAT = "small.splat" as Splat,
    SPZ_1 = "small-v1.spz" as Spz,
    SPZ_2 = "small-js.spz" as Spz,
    SPZ_3_DEGREE_0 = "small-0.spz" as Spz,
    SPZ_3_DEGREE_1 = "small-1.spz" as Spz,
    SPZ_3_DEGREE_2 = "small-2.spz" as Spz,
    SPZ_4 = "small-4.spz" as Spz,
    SOG_1 = "small-v1.sog" as Sog,
    SOG_2 = "small.sog" as Sog,
    KSPLAT_0 = "small-0.ksplat" as Ksplat,
    KSPLAT_1 = "small-1.ksplat" as Ksplat,
    KSPLAT_2 = "small-2.ksplat" as Ksplat,
    GLB = "small.glb" as Glb,
    GLB_SPZ = "packed.glb" as Glb,
    GLTF = "small.gltf" as Gltf,
}

impl File {
    pub fn read(&self) -> Splats {
        match splats::read(self.bytes, self.format, &mut Nothing) {
            Ok(found) => found.splats,
            Err(fault) => panic!("{}: {fault}", self.name),
        }
    }
}

/// The largest differences of numbers.
#[derive(Clone, Copy, Debug)]
pub struct Errors {
    /// Metres along an axis.
    pub position: f64,
    /// Radians.
    pub rotation: f64,
    pub log_scale: f64,
    /// Of 1.
    pub opacity: f64,
    /// RGB, of 1.
    pub color: f64,
    /// Coefficients.
    pub harmonics: f64,
}

impl Errors {
    const NONE: Self = Self {
        position: 0.0,
        rotation: 0.0,
        log_scale: 0.0,
        opacity: 0.0,
        color: 0.0,
        harmonics: 0.0,
    };

    fn numbers(&self) -> [f64; 6] {
        [
            self.position,
            self.rotation,
            self.log_scale,
            self.opacity,
            self.color,
            self.harmonics,
        ]
    }

    /// Whether no number is above its limit.
    pub fn are_within(&self, limit: &Self) -> bool {
        let pairs = self.numbers().into_iter().zip(limit.numbers());
        pairs.into_iter().all(|(error, limit)| error <= limit)
    }
}

fn largest(a: &[f32], b: &[f32], scale: f64) -> f64 {
    let pairs = a.iter().zip(b);
    pairs.fold(0.0, |most, (a, b)| {
        f64::max(most, scale * (f64::from(*a) - f64::from(*b)).abs())
    })
}

fn opacity(logit: f32) -> f64 {
    1.0 / (1.0 + (-f64::from(logit)).exp())
}

/// Differences between splats and the same ones in another order, found again by their places,
/// with harmonics as far as both have them.
pub fn errors(truth: &Splats, read: &Splats) -> Errors {
    assert_eq!(truth.len(), read.len());
    let mut worst = Errors::NONE;
    let mut seen = vec![false; truth.len()];
    let at = |splats: &Splats, k: usize| DVec3::from(splats.position[k].map(f64::from));
    for k in 0..read.len() {
        let of = (0..truth.len())
            .min_by(|&a, &b| {
                let distance = |i| at(truth, i).distance(at(read, k));
                distance(a).total_cmp(&distance(b))
            })
            .unwrap();
        assert!(!std::mem::replace(&mut seen[of], true), "{of} twice");
        let quaternion = |splats: &Splats, k: usize| {
            let [w, x, y, z] = splats.rotation[k].map(f64::from);
            DQuat::from_xyzw(x, y, z, w).normalize()
        };
        let [a, b] = [quaternion(truth, of), quaternion(read, k)];
        // An ellipsoid is the same after half a turn about one of its axes; programs differ in that.
        let halves = [
            DQuat::IDENTITY,
            DQuat::from_xyzw(1.0, 0.0, 0.0, 0.0),
            DQuat::from_xyzw(0.0, 1.0, 0.0, 0.0),
            DQuat::from_xyzw(0.0, 0.0, 1.0, 0.0),
        ];
        // acos would lose small angles.
        let chords = halves.map(|half| {
            let b = b * half;
            (a - if a.dot(b) < 0.0 { -b } else { b }).length()
        });
        let chord = chords.into_iter().fold(f64::INFINITY, f64::min);
        let (functions, own) = (functions_of(read.degree), functions_of(truth.degree));
        let shared = functions.min(own);
        let rest = |splats: &Splats, start: usize| -> Vec<f32> {
            splats.harmonics[start..][..shared].as_flattened().to_vec()
        };
        let new = Errors {
            position: largest(&truth.position[of], &read.position[k], 1.0),
            rotation: 4.0 * (chord / 2.0).min(1.0).asin(),
            log_scale: largest(&truth.log_scale[of], &read.log_scale[k], 1.0),
            opacity: (opacity(truth.opacity[of]) - opacity(read.opacity[k])).abs(),
            // Those beyond 0 to 1 may be clamped.
            color: largest(&truth.color[of].map(shown), &read.color[k].map(shown), 1.0),
            harmonics: largest(&rest(truth, own * of), &rest(read, functions * k), 1.0),
        };
        let pairs = worst.numbers().into_iter().zip(new.numbers());
        let [position, rotation, log_scale, opacity, color, harmonics] =
            std::array::from_fn(|k| pairs.clone().map(|(a, b)| a.max(b)).nth(k).unwrap());
        worst = Errors {
            position,
            rotation,
            log_scale,
            opacity,
            color,
            harmonics,
        };
    }
    worst
}

/// A colour of a coefficient, clamped to 0 to 1.
fn shown(coefficient: f32) -> f32 {
    (0.5 + ShCoefficients::CONSTANT as f32 * coefficient).clamp(0.0, 1.0)
}

/// What each format's codes may lose: half a step, or a whole one where its program rounds down.
fn limits() -> Vec<(File, usize, Errors)> {
    // 8 bits, of 1.
    let byte = 1.0 / 255.0;
    // f32 in arithmetic.
    let float = Errors {
        position: 1e-6,
        rotation: 1e-6,
        log_scale: 2e-6,
        opacity: 1e-6,
        color: 1e-6,
        harmonics: 1e-6,
    };
    // Steps: 1/4096 m; a sign and 9 bits up to √½; a 16th; 8 bits, of a wide range for colours;
    // 16 codes of −1 to 1.
    let spz = Errors {
        position: 0.501 / 4096.0,
        rotation: 4e-3,
        log_scale: 0.501 / 16.0,
        opacity: 0.501 * byte,
        color: 0.501 * ShCoefficients::CONSTANT / (0.15 * 255.0),
        harmonics: 9.0 / 128.0,
    };
    let spz_2 = Errors {
        rotation: 0.13,
        ..spz
    };
    // Harmonics are rounded down.
    let spz_3 = Errors {
        harmonics: 15.6 / 128.0,
        ..spz
    };
    // Chunks span all of a scene that is so small: 0.8 m and 3.5 of log scale.
    let compressed = Errors {
        position: 0.51 * 0.8 / 1023.0,
        rotation: 4e-3,
        log_scale: 0.51 * 3.5 / 1023.0,
        opacity: 0.51 * byte,
        color: 0.51 * byte,
        harmonics: 8.0 / 256.0,
    };
    // Positions within a block of 5 m; bytes are rounded down.
    let half = Errors {
        position: 0.51 * 2.5 / 32_767.0,
        rotation: 2e-3,
        log_scale: 1e-3,
        opacity: 1.01 * byte,
        color: 1.01 * byte,
        harmonics: 3e-4,
    };
    // 16 bits of the logarithms' range; 8 bits from −√½ to √½; 8 bits of each range.
    let sog_1 = Errors {
        position: 6.5e-6,
        rotation: 1.1e-2,
        log_scale: 0.51 * 3.5 / 255.0,
        opacity: 0.51 * 8.0 / 4.0 / 255.0,
        color: 0.51 * byte,
        harmonics: 0.51 * byte,
    };
    // Rounded down; numbers of codebooks, which are not evenly spaced.
    let sog_2 = Errors {
        position: 1.3e-5,
        rotation: 2.2e-2,
        log_scale: 0.01,
        opacity: 1.01 * byte,
        color: 0.002,
        harmonics: 0.004,
    };
    vec![
        (TRUTH, 3, Errors::NONE),
        (COMPRESSED, 3, compressed),
        (
            SPLAT,
            0,
            Errors {
                rotation: 0.04,
                opacity: 1.01 * byte,
                color: 1.01 * byte,
                ..float
            },
        ),
        (
            SPZ_1,
            0,
            Errors {
                position: 3e-4,
                ..spz_2
            },
        ),
        (SPZ_2, 3, spz_2),
        (SPZ_3_DEGREE_0, 0, spz),
        (SPZ_3_DEGREE_1, 1, spz_3),
        (SPZ_3_DEGREE_2, 2, spz_3),
        (SPZ_4, 3, spz),
        (SOG_1, 1, sog_1),
        (SOG_2, 3, sog_2),
        (
            KSPLAT_0,
            2,
            Errors {
                opacity: 1.01 * byte,
                color: 1.01 * byte,
                ..float
            },
        ),
        (KSPLAT_1, 2, half),
        (
            KSPLAT_2,
            2,
            Errors {
                harmonics: 1.01 / 255.0,
                ..half
            },
        ),
        (GLB, 3, float),
        (GLB_SPZ, 3, spz_2),
    ]
}

/// Splats of the truth as the program that wrote a file has turned it.
fn turned(file: &File) -> Splats {
    let truth = TRUTH.read();
    if file.name == SPZ_4.name {
        return truth.with_up(Up::Y);
    }
    if file.name == GLB.name {
        // splat-transform turns about z, not about x.
        let half_turn = DQuat::from_rotation_z(std::f64::consts::PI);
        return Splats {
            up: Up::Y,
            ..truth.turned(half_turn, 1.0, DVec3::ZERO)
        };
    }
    truth
}

fn every_format_gives_the_numbers_that_another_program_wrote() {
    let mut faults = vec![];
    for (file, degree, limit) in limits() {
        let read = file.read();
        assert_eq!(read.degree, degree, "{}", file.name);
        let found = errors(&turned(&file), &read);
        println!("{}: {found:?}", file.name);
        if !found.are_within(&limit) {
            faults.push(format!("{}: {found:?}, at most {limit:?}", file.name));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// Chunks of 256 vertices, of which the last is not full.
fn chunks_of_a_compressed_ply_follow_each_other() {
    let read = MANY.read();
    let truth = TRUTH.read();
    let mut copies = truth.clone();
    copies.degree = 0;
    copies.harmonics.clear();
    let one = copies.clone();
    for k in 1..5 {
        let moved = one.position.iter().map(|&[x, y, z]| [x + k as f32, y, z]);
        copies.position.extend(moved);
        copies.rotation.extend(&one.rotation);
        copies.log_scale.extend(&one.log_scale);
        copies.opacity.extend(&one.opacity);
        copies.color.extend(&one.color);
    }
    let found = errors(&copies, &read);
    // A chunk spans up to 4.8 m.
    let limit = Errors {
        position: 0.51 * 4.8 / 1023.0,
        rotation: 4e-3,
        log_scale: 0.51 * 3.5 / 1023.0,
        opacity: 0.002,
        color: 0.002,
        harmonics: 0.0,
    };
    assert!(found.are_within(&limit), "{found:?}");
}

/// Nodes that turn, scale and move; attributes as integers.
fn nodes_of_a_gltf_place_their_splats() {
    let quarter = DQuat::from_rotation_y(std::f64::consts::FRAC_PI_2);
    let truth = TRUTH.read().turned(quarter, 2.0, DVec3::new(1.0, 2.0, 3.0));
    let read = GLTF.read();
    assert_eq!((read.degree, read.up), (0, Up::Y));
    let found = errors(&truth, &read);
    let limit = Errors {
        position: 1e-6,
        rotation: 1e-4,
        log_scale: 2e-6,
        opacity: 0.51 / 65_535.0,
        color: 1e-6,
        harmonics: 0.0,
    };
    assert!(found.are_within(&limit), "{found:?}");
}

fn each_format_has_its_axis_that_points_up() {
    for file in FILES {
        let up = match file.format {
            SplatFormat::Spz | SplatFormat::Glb | SplatFormat::Gltf => Up::Y,
            _ => Up::TRAINED,
        };
        assert_eq!(file.read().up, up, "{}", file.name);
    }
}

/// Names say nothing: content does.
fn files_are_told_apart_by_content() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.avatar");
    for file in FILES {
        std::fs::write(&path, file.bytes).unwrap();
        assert!(effigy_formats::open::is_splats(&path), "{}", file.name);
        let opened = effigy_formats::open::avatar(&path, &Default::default()).unwrap();
        assert_eq!(opened.avatar.gaussians.len(), file.read().len());
        assert!(opened.avatar.is_static() && opened.avatar.check().is_ok());
    }
    std::fs::write(&path, super::webavatar::SMALL).unwrap();
    assert!(!effigy_formats::open::is_splats(&path) && effigy_formats::open::is_foreign(&path));
    let own = effigy_demo::avatar().unwrap();
    own.write(&path).unwrap();
    assert!(!effigy_formats::open::is_splats(&path));
}

/// A SOG whose files lie in a folder.
fn an_unpacked_sog_is_read_by_its_document() {
    let folder = tempfile::tempdir().unwrap();
    for file in [SOG_1, SOG_2] {
        let mut archive = zip::ZipArchive::new(std::io::Cursor::new(file.bytes)).unwrap();
        archive.extract(folder.path()).unwrap();
        let found = effigy_formats::open::splats(&folder.path().join("meta.json"), None).unwrap();
        assert_eq!(found.splats, file.read());
    }
    std::fs::remove_file(folder.path().join("quats.webp")).unwrap();
    let error = effigy_formats::open::splats(&folder.path().join("meta.json"), None).unwrap_err();
    assert!(error.to_string().contains("for `quats.webp`"), "{error}");
}

/// What can't be taken as it stands is said.
fn what_is_left_out_is_an_assumption() {
    // Degree 4: 24 functions a splat, where degree 3 has 15.
    let content = hostile::gunzip(SPZ_2.bytes);
    let count = SPZ_2.read().len();
    let (before, harmonics) = content.split_at(content.len() - 45 * count);
    let mut longer = before.to_vec();
    longer[12] = 4;
    for row in harmonics.chunks_exact(45) {
        longer.extend(row);
        longer.extend([255; 27]);
    }
    let bytes = hostile::gzip(&longer);
    let found = splats::read(&bytes, SplatFormat::Spz, &mut Nothing).unwrap();
    assert_eq!(found.splats, SPZ_2.read());
    assert_eq!(found.assumptions.len(), 1);
    assert!(found.assumptions[0].because.contains("degree 4"));

    let text = std::str::from_utf8(GLTF.bytes).unwrap();
    let linear = text.replace("srgb_rec709_display", "lin_rec709_display");
    let found = splats::read(linear.as_bytes(), SplatFormat::Gltf, &mut Nothing).unwrap();
    assert_eq!(found.splats, GLTF.read());
    assert!(found.assumptions[0].because.contains("lin_rec709_display"));
}

/// The user's word on the axis goes before the file's, and harmonics follow.
fn the_axis_can_be_said() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a");
    std::fs::write(&path, SPZ_4.bytes).unwrap();
    for up in Up::ALL {
        let found = effigy_formats::open::splats(&path, Some(up)).unwrap();
        assert_eq!(found.splats, Splats { up, ..SPZ_4.read() });
    }
}

/// The flag of an `.spz` is the low-pass of other programs; other formats have none.
fn compensated_opacities_are_a_flag_of_an_spz() {
    let mut bytes = SPZ_4.bytes.to_vec();
    bytes[14] |= 1;
    let found = splats::read(&bytes, SplatFormat::Spz, &mut Nothing).unwrap();
    let expected = Splats {
        filter: Filter::ANTIALIASED,
        ..SPZ_4.read()
    };
    assert_eq!(found.splats, expected);
    assert_eq!(SPZ_4.read().filter, Filter::DEFAULT);
    assert_eq!(
        found.splats.to_avatar("fine").unwrap().filter,
        Filter::ANTIALIASED
    );
    for (format, filter) in [
        (SplatFormat::Spz, Filter::ANTIALIASED),
        (SplatFormat::Ply, Filter::DEFAULT),
    ] {
        let written = splats::write(expected.clone(), format).unwrap();
        let again = splats::read(&written, format, &mut Nothing).unwrap();
        assert_eq!(again.splats.filter, filter, "{format:?}");
    }
}

/// A glTF whose numbers lie in a file beside it.
fn a_gltf_finds_its_buffers_beside_it() {
    let word = |at: usize| u32::from_le_bytes(GLB.bytes[at..at + 4].try_into().unwrap()) as usize;
    let length = word(12);
    let text = std::str::from_utf8(&GLB.bytes[20..20 + length]).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let buffers = "\"buffers\":[{";
    assert!(text.contains(buffers), "{text}");
    let text = text.replacen(buffers, "\"buffers\":[{\"uri\":\"the%20scene.bin\",", 1);
    let path = folder.path().join("scene.gltf");
    std::fs::write(&path, text).unwrap();
    let error = effigy_formats::open::splats(&path, None).unwrap_err();
    assert!(error.to_string().contains("for `the scene.bin`"), "{error}");
    let binary = &GLB.bytes[28 + length..];
    std::fs::write(folder.path().join("the scene.bin"), binary).unwrap();
    let found = effigy_formats::open::splats(&path, None).unwrap();
    assert_eq!(found.splats, GLB.read());
    std::fs::write(folder.path().join("the scene.bin"), &binary[..99]).unwrap();
    let error = effigy_formats::open::splats(&path, None).unwrap_err();
    assert!(
        error.to_string().contains("found 99 bytes of buffer 0"),
        "{error}"
    );
}

tests! {
    every_format_gives_the_numbers_that_another_program_wrote,
    chunks_of_a_compressed_ply_follow_each_other,
    nodes_of_a_gltf_place_their_splats,
    each_format_has_its_axis_that_points_up,
    files_are_told_apart_by_content,
    an_unpacked_sog_is_read_by_its_document,
    a_gltf_finds_its_buffers_beside_it,
    what_is_left_out_is_an_assumption,
    the_axis_can_be_said,
    compensated_opacities_are_a_flag_of_an_spz,
}
