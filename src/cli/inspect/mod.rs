//! `effigy inspect`: what a file contains, as text or as JSON.

mod avatar;
mod motion;
mod text;

use crate::source::print_assumptions;
use anyhow::Context;
use avatar::AvatarSummary;
use effigy_core::io::file::{FileContent, tensors};
use effigy_formats::open::{self, OpenOptions};
use motion::MotionSummary;
use serde::Serialize;
use std::fmt;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

#[derive(clap::Args, Debug)]
pub struct Args {
    /// Avatar or motion file, the paper's .npz, or splats [default: the built-in demo avatar]
    file: Option<PathBuf>,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

pub fn run(args: Args) -> anyhow::Result<()> {
    let Some(file) = &args.file else {
        let demo = effigy_demo::avatar()?;
        return print(&AvatarSummary::new(&demo, demo.tensors()), args.json);
    };
    if open::is_splats(file) || open::is_foreign(file) {
        let imported = open::avatar(file, &OpenOptions::default())?;
        print_assumptions(file, &imported.assumptions);
        let avatar = imported.avatar;
        return print(&AvatarSummary::new(&avatar, avatar.tensors()), args.json);
    }
    inspect_file(file, args.json)
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
