//! What is written comes back within the format's own steps. Other programs read it in
//! `tests/data/splats/check.py`.

use super::{Errors, TRUTH, errors};
use effigy_core::io::splats::{Splats, Up};
use effigy_formats::splats::{self, Nothing, SplatFormat};
use glam::{DQuat, DVec3};

/// Written, read again, and turned back to the axes of the truth.
fn again(truth: &Splats, format: SplatFormat) -> Splats {
    let bytes = splats::write(truth.clone(), format).unwrap();
    let found = splats::read(&bytes, format, &mut Nothing).unwrap();
    found.splats.with_up(truth.up)
}

fn every_written_format_gives_the_numbers_back() {
    let float = Errors {
        position: 1e-6,
        rotation: 1e-6,
        log_scale: 2e-6,
        opacity: 1e-6,
        color: 1e-6,
        harmonics: 1e-6,
    };
    let limits = [
        (
            SplatFormat::Ply,
            Errors {
                rotation: 1e-7,
                ..float
            },
        ),
        (SplatFormat::Glb, float),
        (
            SplatFormat::Splat,
            Errors {
                rotation: 0.02,
                opacity: 0.501 / 255.0,
                color: 0.501 / 255.0,
                ..float
            },
        ),
        (
            SplatFormat::Spz,
            Errors {
                position: 0.501 / 16_384.0,
                rotation: 4e-3,
                log_scale: 0.501 / 16.0,
                opacity: 0.501 / 255.0,
                color: 0.004,
                harmonics: 0.501 / 128.0,
            },
        ),
    ];
    for up in Up::ALL {
        let mut truth = TRUTH.read().with_up(up);
        // Sums of turned harmonics could be beyond −1 to 1.
        for value in truth.harmonics.as_flattened_mut() {
            *value *= 0.5;
        }
        // A quarter turn adds the steps of several.
        let mixed = if matches!(up, Up::Z | Up::MinusZ) {
            2.0
        } else {
            1.0
        };
        for (format, limit) in &limits {
            let read = again(&truth, *format);
            let degree = if *format == SplatFormat::Splat { 0 } else { 3 };
            assert_eq!((read.degree, read.up), (degree, up));
            let found = errors(&truth, &read);
            let limit = Errors {
                harmonics: mixed * limit.harmonics,
                ..*limit
            };
            assert!(found.are_within(&limit), "{format:?}, {up:?}: {found:?}");
        }
    }
}

/// A `.ply` of a `.ply` is the same numbers, bit by bit.
fn a_plain_ply_is_copied_exactly() {
    let truth = TRUTH.read();
    assert_eq!(again(&truth, SplatFormat::Ply), truth);
}

/// Opacities of 0 and 1 and deviations of 0 have infinite logarithms.
fn extremes_are_written_as_finite_numbers() {
    let mut truth = TRUTH.read();
    truth.opacity[0] = f32::INFINITY;
    truth.opacity[1] = f32::NEG_INFINITY;
    truth.log_scale[2] = [f32::NEG_INFINITY; 3];
    for format in [
        SplatFormat::Ply,
        SplatFormat::Spz,
        SplatFormat::Splat,
        SplatFormat::Glb,
    ] {
        let avatar = again(&truth, format).to_avatar("a").unwrap();
        let opacity = &avatar.gaussians.opacity;
        assert!(opacity.contains(&0) && opacity.contains(&255), "{format:?}");
    }
    let ply = splats::write(truth, SplatFormat::Ply).unwrap();
    let read = splats::read(&ply, SplatFormat::Ply, &mut Nothing)
        .unwrap()
        .splats;
    assert!(
        read.opacity
            .iter()
            .chain(read.log_scale.as_flattened())
            .all(|v| v.is_finite())
    );
}

/// Positions of 24 bits: those far out leave fewer bits after the point.
fn a_wide_scene_fits_into_an_spz() {
    let far = DVec3::new(9000.0, 0.0, -500.0);
    let truth = TRUTH.read().turned(DQuat::IDENTITY, 1.0, far);
    let found = errors(&truth, &again(&truth, SplatFormat::Spz));
    assert!(found.position < 2e-3, "{found:?}");
}

fn what_breaks_a_rule_is_not_written() {
    let mut truth = TRUTH.read();
    truth.position[3][1] = f32::NAN;
    let error = splats::write(truth, SplatFormat::Spz).unwrap_err();
    assert!(
        error
            .to_string()
            .contains("NaN in the position of vertex 3")
    );
    let error = splats::write(TRUTH.read(), SplatFormat::Sog).unwrap_err();
    assert!(error.to_string().contains("one of ply, spz, splat, glb"));
}

tests! {
    every_written_format_gives_the_numbers_back,
    a_plain_ply_is_copied_exactly,
    extremes_are_written_as_finite_numbers,
    a_wide_scene_fits_into_an_spz,
    what_breaks_a_rule_is_not_written,
}
