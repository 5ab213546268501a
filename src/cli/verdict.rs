//! `effigy verdict`: joins what a run of `tools/gpu/run.sh` measured to one JSON and one page.

use crate::files;
use anyhow::{Context, ensure};
use effigy_measure::verdict::Verdict;
use std::path::PathBuf;

#[derive(clap::Args, Debug)]
pub struct Args {
    /// Folder with the files of a run of tools/gpu/run.sh
    folder: PathBuf,
    /// Also write the result as JSON
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Also write the result as a page of Markdown
    #[arg(long, value_name = "FILE")]
    markdown: Option<PathBuf>,
}

pub fn run(args: Args) -> anyhow::Result<()> {
    let verdict = Verdict::read(&args.folder, std::env::args().collect())
        .with_context(|| format!("{} is not a run's folder", args.folder.display()))?;
    if let Some(path) = &args.json {
        files::write_json(path, &verdict)?;
    }
    match &args.markdown {
        Some(path) => files::write(path, verdict.page())?,
        None => print!("{}", verdict.page()),
    }
    let faults = verdict.faults();
    ensure!(faults.is_empty(), "{}", faults.join("; "));
    Ok(())
}
