//! `effigy inspect`: what a file contains, as text or as JSON.

mod avatar;
mod capture;
mod motion;
mod text;

use crate::source::{CaptureArgs, print_assumptions};
use anyhow::{Context, bail};
use avatar::AvatarSummary;
use capture::{CaptureSummary, ComparisonSummary};
use effigy_core::avatar::Avatar;
use effigy_core::io::file::{FileContent, tensors};
use effigy_formats::{
    open::{self, OpenOptions},
    retarget,
};
use motion::MotionSummary;
use serde::Serialize;
use std::fmt;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

#[derive(clap::Args, Debug)]
pub struct Args {
    /// Avatar or motion file, of Effigy or of any program that it reads [default: the built-in demo
    /// avatar]
    file: Option<PathBuf>,
    /// Motion capture that the motion file was made of: says how well it follows
    #[arg(long, value_name = "FILE", requires = "file")]
    against: Option<PathBuf>,
    /// Avatar that motion capture is to move [default: the built-in demo]
    #[arg(long, value_name = "FILE")]
    avatar: Option<PathBuf>,
    #[command(flatten)]
    capture: CaptureArgs,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

pub fn run(args: Args) -> anyhow::Result<()> {
    let Some(file) = &args.file else {
        let demo = effigy_demo::avatar()?;
        return print(&AvatarSummary::new(&demo, demo.tensors()), args.json);
    };
    if let Some(against) = &args.against {
        return compare(&args, file, against);
    }
    if open::is_capture(file) {
        let captured = open::capture(file, &args.capture.capture(None))?;
        print_assumptions(file, &captured.assumptions);
        let moved = args.moved()?;
        let options = retarget::RetargetOptions {
            corrections: args.capture.corrections()?,
            girth: retarget::Girth::of(&moved),
            ..Default::default()
        };
        let made = retarget::retarget(&captured.capture, &moved.skeleton, "", &options);
        let made = made.with_context(|| format!("of {}", file.display()))?;
        return print(
            &CaptureSummary::new(&captured.capture, &made.report),
            args.json,
        );
    }
    if open::is_splats(file) || open::is_foreign(file) {
        let imported = open::avatar(file, &OpenOptions::default())?;
        print_assumptions(file, &imported.assumptions);
        let avatar = imported.avatar;
        return print(&AvatarSummary::new(&avatar, avatar.tensors()), args.json);
    }
    inspect_file(file, args.json)
}

impl Args {
    /// The avatar that motion capture is to move.
    fn moved(&self) -> anyhow::Result<Avatar> {
        Ok(match &self.avatar {
            Some(path) => open::avatar(path, &OpenOptions::default())?.avatar,
            None => effigy_demo::avatar()?,
        })
    }
}

/// Says how well a clip follows a capture.
fn compare(args: &Args, file: &Path, against: &Path) -> anyhow::Result<()> {
    let FileContent::Clip(clip) = FileContent::read(file)? else {
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

fn inspect_file(file: &Path, json: bool) -> anyhow::Result<()> {
    let content = FileContent::read(file)?;
    let tensors = tensors(file)?;
    match content {
        FileContent::Avatar(avatar) => print(&AvatarSummary::new(&avatar, tensors), json),
        FileContent::Clip(clip) => print(&MotionSummary::new(&clip), json),
    }
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
