//! `effigy export`: writes an avatar, and a clip that moves it, in the form of another program.

use crate::{
    output::{self, NPZ, Output},
    source::Source,
};
use effigy_formats::webavatar::{self, LeftOut};
use std::path::Path;

#[derive(clap::Args, Debug)]
pub struct Args {
    #[command(flatten)]
    source: Source,
    /// The paper's model to write, NAME.npz; the clip becomes NAME_poses.json beside it
    #[arg(long, value_name = "FILE", value_parser = NPZ.parser())]
    npz: Output,
}

pub fn run(args: Args) -> anyhow::Result<()> {
    let poses = poses_file(&args.npz);
    output::check([&poses])?;
    let (avatar, clips) = args.source.load()?;
    let (bytes, losses) = webavatar::to_bytes(&avatar)?;
    args.npz.write(&bytes)?;
    println!("{}: {:.1} MB", args.npz.display(), bytes.len() as f64 / 1e6);
    for loss in losses {
        println!("not in it: {}", in_words(loss));
    }
    let Some(clip) = clips.first() else {
        return Ok(());
    };
    poses.write(webavatar::write_poses(clip))?;
    println!(
        "{}: {} frames; at {} a second, which is not in it",
        poses.display(),
        clip.frames(),
        clip.rate
    );
    Ok(())
}

fn in_words(loss: LeftOut) -> &'static str {
    match loss {
        LeftOut::PoseSpace => "the training poses, onto which poses are projected",
        LeftOut::Credit => "the credit: who made it, and on what terms",
    }
}

/// `NAME_poses.json` beside `NAME.npz`.
fn poses_file(npz: &Path) -> Output {
    let mut name = npz.file_stem().unwrap_or_default().to_owned();
    name.push("_poses.json");
    Output::new(npz.with_file_name(name), "json")
}
