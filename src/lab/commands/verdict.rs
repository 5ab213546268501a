//! `effigy-lab verdict`: joins what a run of `tools/gpu/run.sh` or a survey measured to one JSON and
//! one page.

use crate::verdict::Verdict;
use anyhow::{Context, ensure};
use effigy_cli::output::{JSON, MARKDOWN, Output};
use std::path::PathBuf;

#[derive(clap::Args, Debug)]
pub struct Args {
    /// Folder with the files of a run of tools/gpu/run.sh, or a survey's file, as the app makes it
    folder: PathBuf,
    /// Also write the result as JSON
    #[arg(long, value_name = "FILE", value_parser = JSON.parser())]
    json: Option<Output>,
    /// Also write the result as a page of Markdown
    #[arg(long, value_name = "FILE", value_parser = MARKDOWN.parser())]
    markdown: Option<Output>,
}

pub fn run(args: Args) -> anyhow::Result<()> {
    let verdict = Verdict::read(&args.folder, std::env::args().collect()).with_context(|| {
        format!(
            "{} is neither a run's folder nor a survey's file",
            args.folder.display()
        )
    })?;
    if let Some(out) = &args.json {
        out.write_json(&verdict)?;
    }
    match &args.markdown {
        Some(out) => out.write(verdict.page())?,
        None => print!("{}", verdict.page()),
    }
    let faults = verdict.faults();
    ensure!(faults.is_empty(), "{}", faults.join("; "));
    Ok(())
}
