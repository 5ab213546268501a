//! Files of splats, version 4: avatars without networks, with spherical harmonics. What they round is
//! within what docs/file-format.md says, and what breaks a rule is refused.

use super::edit::Edit;
use super::{avatar_fault, tiny};
use crate::common;
use effigy_core::{
    avatar::{Avatar, Level, ShCoefficients, harmonics::functions_of},
    io::{
        file::{Neutral, tensors_of},
        pack::PackQuality,
        ply_export::to_ply,
        splats::Splats,
    },
};
use effigy_formats::splats::{self, Nothing, SplatFormat};
use half::f16;
use serde_json::{Value, json};

/// The splats of [`common::splats`] as a 3DGS `.ply`, and as read from there.
fn ply(count: usize, degree: usize) -> (Vec<u8>, Splats) {
    let bytes = to_ply(&common::splats(7, count, degree));
    let found = splats::read(&bytes, SplatFormat::Ply, &mut Nothing).unwrap();
    (bytes, found.splats)
}

/// A few kilobytes of splats of degree 2 with two levels of detail.
pub fn scan() -> Avatar {
    common::with_levels(common::splats(7, 40, 2).to_avatar("scan").unwrap())
}

fn scan_bytes() -> Vec<u8> {
    scan().to_bytes().unwrap()
}

/// What `pack` writes of [`scan`].
pub fn packed_scan_bytes() -> Vec<u8> {
    scan().packed(PackQuality::High).to_packed_bytes().unwrap()
}

fn splats_of_every_degree_read_back_the_same() {
    for degree in 0..=3 {
        let avatar = common::splats(7, 300, degree).to_avatar("scan").unwrap();
        for avatar in [common::with_levels(avatar.clone()), avatar] {
            for quality in PackQuality::ALL {
                let packed = avatar.packed(quality);
                for bytes in [packed.to_bytes(), packed.to_packed_bytes()] {
                    let bytes = bytes.unwrap();
                    assert!(
                        Avatar::from_bytes(&bytes).unwrap() == packed,
                        "degree {degree}, {quality:?}"
                    );
                    assert_eq!(Edit::open(&bytes).document["version"], json!(4));
                }
                assert!(packed.packed(quality) == packed, "twice is not once");
            }
        }
    }
}

/// Splats stay the same number by number, but for the steps that the format has.
fn a_ply_comes_back_within_the_steps() {
    const COUNT: usize = 500;
    for (quality, step) in [
        (PackQuality::Lossless, 0.0),
        (PackQuality::High, 1.0 / 256.0),
        (PackQuality::Medium, 1.0 / 64.0),
    ] {
        let (_, splats) = ply(COUNT, 3);
        let packed = splats.to_avatar("scan").unwrap().packed(quality);
        let bytes = packed.to_packed_bytes().unwrap();
        let avatar = Avatar::from_bytes(&bytes).unwrap();
        let gaussians = &avatar.gaussians;
        let grid = gaussians.bounds.step();
        let positions = splats.position.iter();
        let all: Vec<_> = positions.map(|p| p.map(f64::from)).collect();
        let mut found = vec![false; COUNT];
        let is_rounded = quality != PackQuality::Lossless;
        for k in 0..COUNT {
            let at = avatar.position(k).to_array();
            let near = |p: &[f64; 3]| (0..3).map(|i| (p[i] - at[i]).powi(2)).sum::<f64>();
            let of = (0..COUNT).min_by(|&a, &b| near(&all[a]).total_cmp(&near(&all[b])));
            let of = of.unwrap();
            found[of] = true;
            let off = |got: f64, expected: f64, most: f64, what: &str| {
                // What f16 rounds anyway.
                let most = most + expected.abs() / 2048.0 + 1e-7;
                let off = (got - expected).abs();
                assert!(
                    off <= most,
                    "{what} of {k}: {got}, not {expected}, {quality:?}"
                );
            };
            for i in 0..3 {
                off(at[i], all[of][i], 0.501 * grid[i], "position");
                let most = if is_rounded { 1.0 / 256.0 } else { 0.0 };
                let got = gaussians.log_scale[k][i].to_f64();
                off(got, splats.log_scale[of][i].into(), most, "log scale");
                let color = 0.5 + ShCoefficients::CONSTANT * f64::from(splats.color[of][i]);
                off(gaussians.color[k][i].to_f64(), color, 0.5 * step, "colour");
            }
            let opacity = 1.0 / (1.0 + (-f64::from(splats.opacity[of])).exp());
            off(
                f64::from(gaussians.opacity[k]) / 255.0,
                opacity,
                0.5 / 255.0,
                "opacity",
            );
            let q = splats.rotation[of].map(f64::from);
            let length = q.iter().map(|v| v * v).sum::<f64>().sqrt();
            let got = gaussians.rotation[k].map(f64::from);
            let dot: f64 = (0..4).map(|i| got[i] * q[i]).sum();
            for i in 0..4 {
                // Of the largest component, which follows from three of 1/1440 each.
                let most = if is_rounded { 0.0021 } else { 0.0 };
                off(got[i] * dot.signum(), q[i] / length, most, "rotation");
            }
            let sh = avatar.sh.as_ref().unwrap();
            let row = |all: usize| all * functions_of(3)..(all + 1) * functions_of(3);
            let pairs = sh.coefficients[row(k)]
                .iter()
                .zip(&splats.harmonics[row(of)]);
            for (got, expected) in pairs {
                for i in 0..3 {
                    off(
                        got[i].to_f64(),
                        expected[i].into(),
                        0.5 * step,
                        "coefficient",
                    );
                }
            }
        }
        assert!(found.iter().all(|&found| found), "two are near one");
    }
}

fn files_are_smaller_than_those_of_3dgs() {
    const COUNT: usize = 20_000;
    let (ply, splats) = ply(COUNT, 3);
    let avatar = splats.to_avatar("scan").unwrap();
    let spz = splats::write(splats, SplatFormat::Spz).unwrap();
    let size = |quality| avatar.packed(quality).to_packed_bytes().unwrap().len();
    let [lossless, high, medium] = [
        PackQuality::Lossless,
        PackQuality::High,
        PackQuality::Medium,
    ]
    .map(size);
    let a_splat = |bytes: usize| bytes / COUNT;
    println!(
        "bytes a Gaussian of degree 3: .ply {}, .spz {}, .avatar {}, {} and {}",
        a_splat(ply.len()),
        a_splat(spz.len()),
        a_splat(lossless),
        a_splat(high),
        a_splat(medium)
    );
    assert!(lossless < ply.len() / 2 && high < lossless * 3 / 4 && medium < high * 9 / 10);
    // One joint and no node for all take nothing.
    let bytes = avatar.to_packed_bytes().unwrap();
    let still: usize = tensors_of(&bytes)
        .unwrap()
        .iter()
        .filter(|tensor| ["joint", "joint_weight", "node"].contains(&&*tensor.name))
        .map(|tensor| tensor.stored)
        .sum();
    assert!(still < COUNT / 20, "{still} bytes");
}

/// Coefficients that no code reaches stay as they are, in f16.
fn extreme_harmonics_read_back_the_same() {
    let mut avatar = scan();
    avatar.sh.as_mut().unwrap().coefficients[3][1] = f16::MAX;
    avatar.gaussians.color[5] = [f16::MIN, f16::MAX, f16::NEG_ZERO];
    for quality in PackQuality::ALL {
        let packed = avatar.packed(quality);
        let bytes = packed.to_packed_bytes().unwrap();
        assert!(Avatar::from_bytes(&bytes).unwrap() == packed, "{quality:?}");
        let harmonics = &Edit::open(&bytes).document["harmonics"];
        assert_eq!(harmonics, &json!({ "degree": 2 }));
    }
}

/// A file is of version 4 only where something needs it.
fn what_has_networks_keeps_its_version() {
    let mut avatar = tiny();
    let version = |avatar: &Avatar| {
        let plain = Edit::open(&avatar.to_bytes().unwrap()).document;
        let packed = Edit::open(&avatar.to_packed_bytes().unwrap()).document;
        assert!(plain.get("harmonics").is_some() == avatar.sh.is_some());
        [plain["version"].clone(), packed["version"].clone()]
    };
    assert_eq!(version(&avatar), [json!(1), json!(2)]);
    let zeros = |gaussians: usize| ShCoefficients {
        degree: 1,
        coefficients: vec![[f16::ZERO; 3]; 3 * gaussians],
    };
    avatar.sh = Some(zeros(avatar.gaussians.len()));
    for level in &mut avatar.levels {
        level.sh = Some(zeros(level.gaussians.len()));
    }
    assert_eq!(version(&avatar), [json!(4), json!(4)]);
    for quality in PackQuality::ALL {
        let packed = avatar.packed(quality);
        let bytes = packed.to_packed_bytes().unwrap();
        assert!(Avatar::from_bytes(&bytes).unwrap() == packed, "{quality:?}");
    }
}

fn metadata_of_splats_that_breaks_a_rule_is_named() {
    let codes = json!({ "degree": 2, "codes": { "step": 0.001 } });
    let cases: &[(&str, Value, &str)] = &[
        (
            "/version",
            json!(3),
            "`version` found 3, expected 4 or more, as there are harmonics",
        ),
        (
            "/harmonics/degree",
            json!(0),
            "`harmonics` found 0, expected 1 to 3",
        ),
        (
            "/harmonics/degree",
            json!(4),
            "`harmonics` found 4, expected 1 to 3",
        ),
        (
            "/harmonics/degree",
            json!(u64::MAX),
            "`harmonics` found 18446744073709551615, expected 1 to 3",
        ),
        (
            "/harmonics/degree",
            json!(3),
            "in tensor `sh` found shape [8, 3, 40], expected [15, 3, 40]",
        ),
        (
            "/harmonics",
            codes,
            "`harmonics` found a step of 1e-3, expected one from 0.00390625 to 1",
        ),
        (
            "/harmonics",
            json!({ "degree": 2, "codes": { "step": 1e300 } }),
            "`harmonics` found a step of 1e300, expected one from",
        ),
        (
            "/harmonics",
            json!({ "degree": 2, "codes": { "step": 0.25 } }),
            "in tensor `color` found F16, expected U16",
        ),
        (
            "/harmonics",
            json!({ "codes": {} }),
            "`effigy` found missing field `",
        ),
        (
            "/basis",
            json!(4),
            "`widths` found 0 layers, expected 1 to 8",
        ),
        ("/widths", json!([8]), "`basis` found 0, expected 4 to 32"),
        (
            "/rotation_rows",
            json!(1),
            "`rotation_rows` found 1, expected 0 to 0",
        ),
        (
            "/color_rows",
            json!(40),
            "`color_rows` found 40, expected 0 to 0",
        ),
        (
            "/levels/0/correctives",
            json!(true),
            "`level.0.correctives` found true, expected false, as there are no networks",
        ),
        (
            "/levels/0/gaussians",
            json!(0),
            "`level.0.gaussians` found 0, expected 1 to 39",
        ),
        (
            "/levels/0/gaussians",
            json!(19),
            "in tensor `level.0.position` found shape [20, 3], expected [19, 3]",
        ),
        (
            "/pose_components",
            json!(1),
            "`pose_components` found 1, expected 0 to 0",
        ),
        ("/nodes", json!(0), "`nodes` found 0, expected 1 to 65536"),
        (
            "/expression",
            json!(65),
            "`expression` found 65, expected 0 to 64",
        ),
    ];
    for (field, value, sentence) in cases {
        let mut edit = Edit::open(&scan_bytes());
        *edit.document.pointer_mut(field).expect(field) = value.clone();
        let got = avatar_fault(&edit.bytes());
        let got = got.strip_prefix("in metadata ").unwrap_or(&got);
        assert!(got.starts_with(sentence), "{field}: {got}");
    }
    let mut edit = Edit::open(&packed_scan_bytes());
    edit.document["coded"] = json!(["color"]);
    assert_eq!(
        avatar_fault(&edit.bytes()),
        "in metadata `coded` found color, expected codes of `harmonics` alone"
    );
    // Networks are left out from version 4 on.
    let mut edit = Edit::open(
        &common::splats(7, 40, 0)
            .to_avatar("")
            .unwrap()
            .to_bytes()
            .unwrap(),
    );
    edit.document["version"] = json!(3);
    assert_eq!(
        avatar_fault(&edit.bytes()),
        "in metadata `basis` found 0, expected 4 to 32"
    );
}

fn coefficients_that_break_a_rule_are_named() {
    for (tensor, at, found) in [
        ("sh", 40, "found NaN at [0, 1, 0]"),
        ("level.0.sh", 21, "found NaN at [0, 1, 1]"),
        ("level.1.sh", 239, "found NaN at [7, 2, 9]"),
        ("level.1.color", 2, "found NaN at [0, 2]"),
        ("level.0.log_scale", 5, "found NaN at [1, 2]"),
    ] {
        let mut edit = Edit::open(&scan_bytes());
        edit.put(tensor, at, &f16::NAN.to_le_bytes());
        assert_eq!(
            avatar_fault(&edit.bytes()),
            format!("in tensor `{tensor}` {found}, expected finite numbers")
        );
    }
    let missing = |name: &str| {
        let mut edit = Edit::open(&scan_bytes());
        edit.rename(name, "elsewhere");
        avatar_fault(&edit.bytes())
    };
    assert_eq!(
        missing("level.1.sh"),
        "in tensor `level.1.sh` found nothing, expected F16 of shape [8, 3, 10]"
    );
}

/// What no file says is not written either.
fn levels_of_other_harmonics_are_not_written() {
    let break_it = |change: &dyn Fn(&mut Level)| {
        let mut avatar = scan();
        change(&mut avatar.levels[0]);
        assert!(avatar.check().is_err());
        avatar.to_bytes().unwrap_err().to_string()
    };
    let none = break_it(&|level| level.sh = None);
    assert_eq!(
        none,
        "in tensor `level.0.sh` found 0 bytes, expected F16 of shape [8, 3, 20]"
    );
    for degree in [0, 1, 99, usize::MAX] {
        let other = break_it(&|level| level.sh.as_mut().unwrap().degree = degree);
        assert!(other.starts_with("in tensor `level.0.sh` found"), "{other}");
    }
    let fewer = break_it(&|level| level.sh.as_mut().unwrap().coefficients.truncate(9));
    assert!(fewer.starts_with("in tensor `level.0.sh` found"), "{fewer}");
}

/// A page shows colours of degree 0 until it has the others.
fn harmonics_come_after_what_can_be_shown() {
    let scan = common::with_levels(common::splats(7, 3000, 2).to_avatar("scan").unwrap());
    let packed = scan.packed(PackQuality::High);
    for bytes in [scan.to_bytes(), packed.to_packed_bytes()] {
        let bytes = bytes.unwrap();
        let whole = Avatar::from_bytes(&bytes).unwrap();
        let needed = Avatar::neutral_needs(&bytes).unwrap();
        assert!(needed < bytes.len() / 2, "{needed} of {}", bytes.len());
        let first = Avatar::neutral(&bytes[..needed], bytes.len()).unwrap();
        let Neutral::Avatar(neutral) = first else {
            panic!("{needed} bytes are not enough");
        };
        assert_eq!(neutral.gaussians, whole.gaussians);
        let sh = neutral.sh.unwrap();
        assert!(sh.degree == 2 && sh.coefficients.iter().flatten().all(|&c| c == f16::ZERO));
        assert_eq!(sh.coefficients.len(), whole.sh.unwrap().coefficients.len());
    }
}

tests! {
    splats_of_every_degree_read_back_the_same,
    a_ply_comes_back_within_the_steps,
    files_are_smaller_than_those_of_3dgs,
    extreme_harmonics_read_back_the_same,
    what_has_networks_keeps_its_version,
    metadata_of_splats_that_breaks_a_rule_is_named,
    coefficients_that_break_a_rule_are_named,
    levels_of_other_harmonics_are_not_written,
    harmonics_come_after_what_can_be_shown,
}
