//! `effigy export-ply`: writes an avatar in one pose as a 3DGS .ply, and cameras around it.

use crate::{
    convert::posed_splats,
    options,
    output::{JSON, Output, WritePly},
    source::{Source, check_time},
};
use effigy_core::{
    avatar::Avatar,
    io::{cameras, ply_export::to_ply, splats::Uniform},
    scene::{AvatarBounds, Camera, Orbit, Posed},
};
use effigy_measure::viewpoint::{FOV, PITCH, yaw_of_view};

#[derive(clap::Args, Debug)]
pub struct Args {
    #[command(flatten)]
    source: Source,
    /// Time in the clip, seconds
    #[arg(long, alias = "at", value_name = "SECONDS", default_value_t = 0.0, value_parser = options::seconds)]
    time: f64,
    #[command(flatten)]
    out: WritePly,
    /// Make every Gaussian a ball of this standard deviation, metres above 0, and opacity, 0 to 1,
    /// to measure renderers on equal bodies: 0.003,0.9
    #[arg(long, value_name = "DEVIATION,OPACITY", value_parser = uniform)]
    uniform: Option<Uniform>,
    /// Also write cameras around the avatar, as 3DGS's cameras.json
    #[arg(long, alias = "cameras", value_name = "FILE", value_parser = JSON.parser())]
    cameras_out: Option<Output>,
    /// Views around the avatar, 1 or more
    ///
    /// They are those of `effigy bench`.
    #[arg(long, value_name = "N", default_value_t = 4, value_parser = clap::value_parser!(u16).range(1..), requires = "cameras_out")]
    views: u16,
    /// Width and height of the cameras' images, pixels
    #[arg(long, value_name = "WxH", value_parser = options::size, default_value = "2048x2048", requires = "cameras_out")]
    size: [u32; 2],
}

/// Reads `DEVIATION,OPACITY`.
fn uniform(text: &str) -> Result<Uniform, String> {
    let parse = || {
        let (deviation, opacity) = text.split_once(',')?;
        let uniform = Uniform {
            deviation: deviation.trim().parse().ok()?,
            opacity: opacity.trim().parse().ok()?,
        };
        let is_valid = uniform.deviation > 0.0
            && uniform.deviation.is_finite()
            && (0.0..=1.0).contains(&uniform.opacity);
        is_valid.then_some(uniform)
    };
    parse().ok_or_else(|| {
        format!("`{text}` is not a deviation and an opacity: write metres above 0 and a number from 0 to 1, for instance 0.003,0.9")
    })
}

pub fn run(args: Args) -> anyhow::Result<()> {
    let out = args.out.file()?;
    let (avatar, player) = args.source.load_player()?;
    check_time(&player, args.time);
    let posed = Posed::new(&avatar, &player.pose(args.time));
    let ply = to_ply(&posed_splats(&avatar, &posed, args.uniform)?);
    out.write(&ply)?;
    println!(
        "wrote {}: {} Gaussians, {:.1} MB",
        out.display(),
        avatar.gaussians.len(),
        ply.len() as f64 / 1e6
    );
    if let Some(path) = &args.cameras_out {
        let cameras = views(&avatar, &posed, usize::from(args.views), args.size);
        path.write(cameras::to_json(&cameras) + "\n")?;
        println!("wrote {}: {} cameras", path.display(), args.views);
    }
    Ok(())
}

/// `count` cameras around the avatar for images of `size` pixels, those of the benchmark.
fn views(avatar: &Avatar, posed: &Posed, count: usize, size: [u32; 2]) -> Vec<Camera> {
    let framing = AvatarBounds::new(avatar).framing(&posed.joints);
    (0..count)
        .map(|view| {
            let orbit = Orbit {
                yaw: yaw_of_view(view, count),
                pitch: PITCH,
                fov: FOV,
            };
            Camera::around(framing, orbit, size)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn uniform_is_a_deviation_and_an_opacity() {
        assert_eq!(
            uniform("0.003,0.9"),
            Ok(Uniform {
                deviation: 0.003,
                opacity: 0.9
            })
        );
        for text in [
            "0.003", "0,0.9", "-1,0.5", "1,1.5", "nan,0.5", "inf,0.5", "a,b",
        ] {
            assert!(
                uniform(text).is_err_and(|error| error.contains("0.003,0.9")),
                "{text}"
            );
        }
    }
}
