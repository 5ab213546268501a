//! `effigy inspect`: what a file contains, as text or as JSON.

mod avatar;
mod capture;
mod checkpoint;
mod folder;
mod levels;
mod motion;
mod pictures;
mod sheet;
mod splats;
mod text;

use crate::{
    files::print_assumptions,
    output::{IMAGE, Output},
    picture,
    source::{CaptureArgs, avatar_to_move, open_clip},
    thumbnail::Thumbnails,
};
use anyhow::{Context, bail, ensure};
use avatar::AvatarSummary;
use capture::{CaptureSummary, ComparisonSummary};
use checkpoint::CheckpointSummary;
use effigy_core::avatar::Avatar;
use effigy_core::io::file::{FileContent, FileError, tensors};
use effigy_formats::{
    content::Content,
    open::{self, OpenOptions},
    retarget,
};
use folder::FolderSummary;
use motion::MotionSummary;
use pictures::PicturesSummary;
use serde::Serialize;
use splats::SplatsSummary;
use std::fmt;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

pub use levels::LevelSummary;

#[derive(clap::Args, Debug)]
pub struct Args {
    /// Avatar or motion file, of Effigy or of any program that it reads, a folder of them, or a
    /// capture of pictures [default: the built-in demo avatar]
    file: Option<PathBuf>,
    /// Motion capture that the motion file was made of: says how well it follows
    #[arg(long, value_name = "FILE", requires = "file")]
    against: Option<PathBuf>,
    /// Body model: an .npz with the arrays of SMPL-X [default: template.npz in the capture]
    #[arg(long, value_name = "FILE", requires = "file")]
    template: Option<PathBuf>,
    /// Avatar that motion of another body is to move [default: the built-in demo; of `bake motion`
    /// the assets' body]
    #[arg(long, value_name = "FILE")]
    avatar: Option<PathBuf>,
    #[command(flatten)]
    capture: CaptureArgs,
    /// Write a picture of it too: the avatar, or one that the motion moves, half way through; of a
    /// folder one of each file, in the list's order, eight a row
    #[arg(long, value_name = "FILE", value_parser = IMAGE.parser())]
    png: Option<Output>,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

pub fn run(args: Args) -> anyhow::Result<()> {
    let Some(file) = &args.file else {
        let demo = effigy_demo::avatar()?;
        if let Some(out) = &args.png {
            picture::write(&args.thumbnails()?.demo()?, out)?;
        }
        return print(&AvatarSummary::new(&demo, demo.tensors()), args.json);
    };
    if file.is_dir() {
        ensure!(
            args.against.is_none(),
            "--against is for a file, not for a folder"
        );
        let capture = PicturesSummary::new(file, args.template.as_deref());
        if let Ok(Some(capture)) = &capture {
            ensure!(args.png.is_none(), "--png draws no capture of pictures");
            return print(capture, args.json);
        }
        let summary = FolderSummary::new(file)?;
        if let Err(error) = capture {
            // A folder of other files may have a calibration among them.
            if summary.paths().next().is_none() {
                return Err(error);
            }
            eprintln!("no capture of pictures: {error:#}");
        }
        if let Some(out) = &args.png {
            let files: Vec<&Path> = summary.paths().collect();
            sheet::write(&args.thumbnails()?, &files, out)?;
        }
        return print(&summary, args.json);
    }
    if let Some(against) = &args.against {
        return compare(&args, file, against);
    }
    summarise(&args, file)?;
    if let Some(out) = &args.png {
        picture::write(&args.thumbnails()?.of(file)?, out)?;
    }
    Ok(())
}

/// Says what a file contains.
fn summarise(args: &Args, file: &Path) -> anyhow::Result<()> {
    let content = open::content(file);
    if content.is_motion() {
        return inspect_capture(args, file);
    }
    if content == Content::Checkpoint {
        let summary = open::checkpoint(file, &Default::default(), |checkpoint| {
            print_assumptions(file, &checkpoint.assumptions);
            CheckpointSummary::new(&checkpoint)
        })?;
        return print(&summary, args.json);
    }
    if matches!(content, Content::Splats(_)) {
        let found = open::splats(file, None)?;
        print_assumptions(file, &found.assumptions);
        return print(&SplatsSummary::new(file, &found.splats), args.json);
    }
    if content.is_avatar() {
        let imported = open::avatar(file, &OpenOptions::default())?;
        print_assumptions(file, &imported.assumptions);
        let avatar = imported.avatar;
        return print(&AvatarSummary::new(&avatar, avatar.tensors()), args.json);
    }
    inspect_own(args, file)
}

fn inspect_capture(args: &Args, file: &Path) -> anyhow::Result<()> {
    let options = args.capture.clip_options(None)?;
    let opened = open_clip(file, &args.moved()?, &options)?;
    let (Some(capture), Some(report)) = (&opened.capture, &opened.report) else {
        // The poses of an avatar like this one are its clip as they are.
        return print(&MotionSummary::new(&opened.clip), args.json);
    };
    print(&CaptureSummary::new(capture, report), args.json)
}

/// A file of Effigy's own.
fn inspect_own(args: &Args, file: &Path) -> anyhow::Result<()> {
    let content = read_own(file)?;
    let tensors = tensors(file)?;
    match content {
        FileContent::Avatar(avatar) => print(&AvatarSummary::new(&avatar, tensors), args.json),
        FileContent::Clip(clip) => print(&MotionSummary::new(&clip), args.json),
    }
}

impl Args {
    /// What draws small pictures of files.
    fn thumbnails(&self) -> anyhow::Result<Thumbnails> {
        Ok(Thumbnails {
            moved: self.moved()?,
            clips: self.capture.clip_options(None)?,
        })
    }

    /// The avatar that motion of another body is to move.
    fn moved(&self) -> anyhow::Result<Avatar> {
        avatar_to_move(self.avatar.as_deref())
    }
}

/// Reads a file of Effigy's own; an error says what another file seems to be.
fn read_own(file: &Path) -> Result<FileContent, FileError> {
    FileContent::read(file).map_err(|error| open::unknown(file, error))
}

/// Says how well a clip follows a capture.
fn compare(args: &Args, file: &Path, against: &Path) -> anyhow::Result<()> {
    let FileContent::Clip(clip) = read_own(file)? else {
        bail!("{} is an avatar: --against is for motion", file.display());
    };
    let captured = open::capture(against, &args.capture.capture(None))?;
    print_assumptions(against, &captured.assumptions);
    let corrections = args.capture.corrections()?;
    let report = retarget::compare(
        &clip,
        &captured.capture,
        &args.moved()?.skeleton,
        &corrections,
    )
    .with_context(|| format!("of {}", against.display()))?;
    print(&ComparisonSummary::new(&report), args.json)
}

fn print(summary: &(impl Serialize + fmt::Display), json: bool) -> anyhow::Result<()> {
    // Names come from the file: a terminal would obey control characters in them.
    let plain = |c: char| if c.is_control() && c != '\n' { ' ' } else { c };
    let text = if json {
        serde_json::to_string_pretty(summary)?
    } else {
        summary.to_string().chars().map(plain).collect()
    };
    match writeln!(io::stdout().lock(), "{}", text.trim_end()) {
        // A reader such as `head` closes the pipe when it has enough.
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
        outcome => outcome.context("cannot print"),
    }
}
