//! `effigy export-ply`: an avatar in one pose goes in; a 3DGS .ply of it comes out, and cameras around it.

use super::{options, source::Source};
use crate::{
    avatar::{
        Avatar,
        export::{self, Uniform},
        import::cameras,
        motion::Player,
    },
    frame::{Camera, Extent, Posed},
    measure::upright,
    reference::{features, nodes, splats},
};
use anyhow::{Context, ensure};
use std::{f64::consts::TAU, fs, path::PathBuf};

#[derive(clap::Args)]
pub struct Args {
    #[command(flatten)]
    source: Source,
    /// Seconds into the clip
    #[arg(long, value_name = "SECONDS", default_value_t = 0.0)]
    at: f64,
    /// The .ply to write
    #[arg(short, long, value_name = "FILE")]
    out: PathBuf,
    /// Make every Gaussian a ball of this standard deviation (metres) and opacity, to measure renderers on the same body: 0.003,0.9
    #[arg(long, value_name = "DEVIATION,OPACITY", value_parser = uniform)]
    uniform: Option<Uniform>,
    /// Write cameras around the avatar too, as 3DGS's cameras.json
    #[arg(long, value_name = "FILE")]
    cameras: Option<PathBuf>,
    /// Cameras to write: those that `effigy bench` uses
    #[arg(long, default_value_t = 4, value_parser = clap::value_parser!(u16).range(1..), requires = "cameras")]
    views: u16,
    /// Width and height of the cameras' pictures, px
    #[arg(long, value_parser = options::size, default_value = "2048x2048", requires = "cameras")]
    size: [u32; 2],
}

fn uniform(text: &str) -> Result<Uniform, String> {
    let parse = |(deviation, opacity): (&str, &str)| {
        let (deviation, opacity): (f64, f64) = (deviation.trim().parse().ok()?, opacity.trim().parse().ok()?);
        (deviation > 0.0 && deviation.is_finite() && (0.0..=1.0).contains(&opacity)).then_some(Uniform { deviation, opacity })
    };
    text.split_once(',').and_then(parse).ok_or_else(|| {
        format!("`{text}` is no deviation and opacity: write metres above 0 and a number from 0 to 1, for instance 0.003,0.9")
    })
}

pub fn run(args: Args) -> anyhow::Result<()> {
    let (avatar, clips) = args.source.load()?;
    let player = Player::new(clips.into_iter().next().context("there is no clip")?, &avatar.skeleton);
    ensure!(args.at.is_finite(), "{} seconds into the clip is no time: give --at a number", args.at);
    let posed = Posed::new(&avatar, &player.pose(args.at));
    let ply = posed_ply(&avatar, &posed, args.uniform)?;
    fs::write(&args.out, &ply).with_context(|| format!("{} can't be written", args.out.display()))?;
    println!("wrote {}: {} Gaussians, {:.1} MB", args.out.display(), avatar.gaussians.len(), ply.len() as f64 / 1e6);
    if avatar.harmonics.is_some() {
        tracing::warn!("the harmonics of `{}` are left out: colours are written as they are without them", avatar.name);
    }
    if let Some(path) = &args.cameras {
        let text = cameras::to_json(&views(&avatar, &posed, usize::from(args.views), args.size));
        fs::write(path, text + "\n").with_context(|| format!("{} can't be written", path.display()))?;
        println!("wrote {}: {} cameras", path.display(), args.views);
    }
    Ok(())
}

/// The file of a posed avatar.
fn posed_ply(avatar: &Avatar, posed: &Posed, uniform: Option<Uniform>) -> anyhow::Result<Vec<u8>> {
    let features = features::features(avatar, &posed.input);
    let gaussians = splats::gaussians(avatar, posed, &features, &nodes::nodes(avatar, &features));
    let bad = gaussians.iter().position(|g| !(g.mean.is_finite() && g.axes.is_finite() && g.color.is_finite()));
    ensure!(bad.is_none(), "Gaussian {} of `{}` is not finite in this pose: choose another with --at", bad.unwrap_or(0), avatar.name);
    Ok(export::to_ply(&gaussians, uniform))
}

/// Cameras that frame the avatar from all around, as the benchmark's do.
fn views(avatar: &Avatar, posed: &Posed, count: usize, size: [u32; 2]) -> Vec<Camera> {
    let bounds = upright(Extent::new(avatar).bounds(&posed.joints));
    let yaw = |view: usize| TAU * (0.05 + view as f64 / count as f64);
    (0..count).map(|view| Camera::around(bounds, yaw(view), 0.09, 35f64.to_radians(), size)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn uniform_bodies_are_read_from_two_numbers() {
        assert_eq!(uniform("0.003,0.9"), Ok(Uniform { deviation: 0.003, opacity: 0.9 }));
        for text in ["0.003", "0,0.9", "-1,0.5", "1,1.5", "nan,0.5", "inf,0.5", "a,b"] {
            assert!(uniform(text).is_err_and(|error| error.contains("0.003,0.9")), "{text}");
        }
    }
}
