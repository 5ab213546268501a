//! Inputs that can't be drawn: each input of a good case is broken in turn, and each must be
//! rejected with an error that says what was found. The case itself must be drawn afterwards as if
//! nothing had happened.

use super::{
    adversarial::{not_drawable, not_drawable_vector},
    body::below,
    case::StressCase,
};
use effigy_core::{
    avatar::{Avatar, Filter, Level, LevelError},
    random::Random,
    scene::{Camera, FrameImage, Posed},
};
use effigy_render::vulkan::{self, Error, Gpu, Renderer, RendererOptions};
use glam::DVec2;
use half::f16;
use std::sync::Arc;

/// Breaks every input of a case, and draws the case itself before and after. Returns these two
/// images.
///
/// # Errors
/// When the device fails at anything but a broken input.
pub fn run(
    gpu: &Arc<Gpu>,
    case: &StressCase,
    faults: &mut Vec<String>,
) -> vulkan::Result<[FrameImage; 2]> {
    let random = &mut Random::new(case.number, 0x7265_6675_7365_6421);
    for (what, avatar) in bad_levels(&case.avatar) {
        expect_refusal(
            what,
            Renderer::new(gpu, &avatar, case.options).map(drop),
            faults,
        )?;
    }
    for (what, options) in bad_options(random, case.options) {
        expect_refusal(
            what,
            Renderer::new(gpu, &case.avatar, options).map(drop),
            faults,
        )?;
    }
    let mut renderer = Renderer::new(gpu, &case.avatar, case.options)?;
    renderer.draw(&case.posed, &case.camera, None)?;
    let first = renderer.read_image()?;
    for (what, posed) in bad_poses(random, case) {
        expect_refusal(what, renderer.draw(&posed, &case.camera, None), faults)?;
    }
    for (what, camera) in bad_cameras(random, case.camera) {
        expect_refusal(what, renderer.draw(&case.posed, &camera, None), faults)?;
    }
    bad_files(random, &case.avatar, faults);
    renderer.draw(&case.posed, &case.camera, None)?;
    Ok([first, renderer.read_image()?])
}

/// Adds a fault if a broken input was drawn. Fails on any error but a rejection.
fn expect_refusal(
    what: &str,
    result: vulkan::Result<()>,
    faults: &mut Vec<String>,
) -> vulkan::Result<()> {
    match result {
        Ok(()) => faults.push(format!("{what} that can't be drawn was accepted")),
        Err(Error::Unusable(_) | Error::Avatar(_) | Error::ImageSize { .. }) => {}
        Err(error) => return Err(error),
    }
    Ok(())
}

/// The avatar with one thing broken each in a level of its own Gaussians.
fn bad_levels(good: &Avatar) -> Vec<(&'static str, Avatar)> {
    let with = |break_it: &dyn Fn(&mut Level)| {
        let mut level = Level {
            gaussians: good.gaussians.clone(),
            part_start: good.parts.start.clone(),
            correctives: true,
            rotation_rows: good.rotation_rows.clone(),
            scale_rows: good.scale_rows.clone(),
            color_rows: good.color_rows.clone(),
            sh: good.sh.clone(),
            measured: vec![],
        };
        break_it(&mut level);
        Avatar {
            levels: vec![level],
            ..good.clone()
        }
    };
    let first = |level: &mut Level, value: f16| level.gaussians.log_scale[0][1] = value;
    vec![
        (
            "a level without Gaussians",
            with(&|level| level.gaussians = level.gaussians.pick(&[])),
        ),
        (
            "a level whose parts end before its Gaussians",
            with(&|level| *level.part_start.last_mut().expect("an end") -= 1),
        ),
        (
            "a level whose rows are of other Gaussians",
            with(&|level| {
                let row = level.gaussians.len() as u32;
                level.color_rows.gaussian.push(row);
            }),
        ),
        (
            "a level with a scale that is NaN",
            with(&|level| first(level, f16::NAN)),
        ),
        (
            "a level with an infinite scale",
            with(&|level| first(level, f16::INFINITY)),
        ),
        (
            "a level's error at a height that is NaN",
            with(&|level| {
                level.measured = vec![LevelError {
                    height: f64::NAN,
                    samples: 2,
                    psnr_db: 40.0,
                    color: 0.0,
                    coverage: 0.0,
                }];
            }),
        ),
    ]
}

/// Options with one number broken each.
fn bad_options(random: &mut Random, good: RendererOptions) -> Vec<(&'static str, RendererOptions)> {
    let nan = if below(random, 2) == 0 {
        f64::NAN
    } else {
        f64::NEG_INFINITY
    };
    vec![
        (
            "an opacity cutoff",
            RendererOptions {
                cutoff: nan,
                ..good
            },
        ),
        (
            "an opacity cutoff below 1/255",
            RendererOptions {
                cutoff: 0.001,
                ..good
            },
        ),
        (
            "an image of no height",
            RendererOptions {
                size: [good.size[0], 0],
                ..good
            },
        ),
        (
            "an image of 100,000 px",
            RendererOptions {
                size: [100_000, good.size[1]],
                ..good
            },
        ),
        (
            "a low-pass",
            RendererOptions {
                filter: Some(Filter {
                    variance: nan,
                    compensated: true,
                }),
                ..good
            },
        ),
        (
            "a low-pass under 0.1 px²",
            RendererOptions {
                filter: Some(Filter {
                    variance: 0.09,
                    compensated: false,
                }),
                ..good
            },
        ),
    ]
}

/// Poses with one number broken each: of a joint, of the root's place, of the expression, of a
/// matrix and of the network's input; and one without joints.
fn bad_poses(random: &mut Random, case: &StressCase) -> Vec<(&'static str, Posed)> {
    let mut bad = vec![];
    let mut pose = case.pose.clone();
    let joint = below(random, pose.rotation.len());
    pose.rotation[joint] = not_drawable_vector(random);
    bad.push(("a joint's angle", Posed::new(&case.avatar, &pose)));
    let mut pose = case.pose.clone();
    pose.translation = not_drawable_vector(random);
    bad.push(("a place of the root", Posed::new(&case.avatar, &pose)));
    let mut pose = case.pose.clone();
    if let Some(number) = pose.expression.first_mut() {
        *number = f64::NAN;
        bad.push(("an expression", Posed::new(&case.avatar, &pose)));
    }
    let mut posed = case.posed.clone();
    let joint = below(random, posed.joints.len());
    posed.joints[joint].translation = not_drawable_vector(random);
    bad.push(("a joint's matrix", posed));
    let mut posed = case.posed.clone();
    posed.input[0] = not_drawable(random);
    bad.push(("a network's input", posed));
    let mut posed = case.posed.clone();
    posed.joints.clear();
    bad.push(("a pose without joints", posed));
    bad
}

/// Cameras with one number broken each.
fn bad_cameras(random: &mut Random, good: Camera) -> Vec<(&'static str, Camera)> {
    let mut view = good.view;
    view.translation = not_drawable_vector(random);
    let mut rotated = good.view;
    rotated.matrix3.x_axis = not_drawable_vector(random);
    let [x, y] = good.center.to_array();
    vec![
        ("a camera's place", Camera { view, ..good }),
        (
            "a camera's direction",
            Camera {
                view: rotated,
                ..good
            },
        ),
        (
            "a focal length",
            Camera {
                focal: DVec2::new(not_drawable(random), good.focal.y),
                ..good
            },
        ),
        (
            "a focal length of 0",
            Camera {
                focal: DVec2::new(good.focal.x, 0.0),
                ..good
            },
        ),
        (
            "a principal point",
            Camera {
                center: DVec2::new(x, y * not_drawable(random)),
                ..good
            },
        ),
        (
            "a near plane",
            Camera {
                near: not_drawable(random),
                ..good
            },
        ),
        ("a near plane at 0", Camera { near: 0.0, ..good }),
        ("a near plane behind", Camera { near: -1.0, ..good }),
        (
            "an image of another size",
            Camera {
                size: [good.size[0] + 1, good.size[1]],
                ..good
            },
        ),
        (
            "an image of no size",
            Camera {
                size: [0, good.size[1]],
                ..good
            },
        ),
    ]
}

/// Puts NaN or infinity into each floating-point tensor of a file, which the reader must reject.
fn bad_files(random: &mut Random, avatar: &Avatar, faults: &mut Vec<String>) {
    let bytes = match avatar.to_bytes() {
        Ok(bytes) => bytes,
        Err(fault) => {
            return faults.push(format!("the case itself is not a valid avatar: {fault}"));
        }
    };
    // A file is the length of the header, the header, and the tensors, whose places the header
    // says.
    let header = 8 + usize::from_le_bytes(std::array::from_fn(|k| bytes[k]));
    let Ok(document) = serde_json::from_slice::<serde_json::Value>(&bytes[8..header]) else {
        return faults.push("the case's own file has no JSON in its header".into());
    };
    for tensor in avatar
        .tensors()
        .iter()
        .filter(|tensor| tensor.dtype.starts_with('F') && tensor.bytes > 0)
    {
        let Some(start) = document[&tensor.name]["data_offsets"][0].as_u64() else {
            faults.push(format!("the file does not say where `{}` is", tensor.name));
            continue;
        };
        let mut broken = bytes.clone();
        let infinite: &[u8] = if tensor.dtype == "F16" {
            &[0x00, 0x7c]
        } else {
            &[0x00, 0x00, 0x80, 0x7f]
        };
        let at =
            header + start as usize + infinite.len() * below(random, tensor.bytes / infinite.len());
        broken[at..at + infinite.len()].copy_from_slice(infinite);
        // Any bit of the fraction turns infinity into NaN.
        broken[at] |= below(random, 2) as u8;
        match Avatar::from_bytes(&broken) {
            Err(fault) if fault.to_string().contains(&format!("`{}`", tensor.name)) => {}
            Err(fault) => faults.push(format!(
                "a bad number in `{}` was rejected with: {fault}",
                tensor.name
            )),
            Ok(_) => faults.push(format!("a bad number in `{}` was accepted", tensor.name)),
        }
    }
}
