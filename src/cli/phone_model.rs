//! `effigy phone-model`: what phones would take, from published rates and this program's counts.

use crate::{
    files,
    output::{MARKDOWN, Output},
};
use anyhow::Context;
use effigy_measure::phone_model::{Inputs, PhoneModel, replace_tables};
use std::path::PathBuf;

#[derive(clap::Args, Debug)]
pub struct Args {
    /// Folder with rates and counts: devices.csv, rates.csv, quads.json, quads-untested.json and
    /// tiles-shared.json
    #[arg(default_value = "docs/phone-model")]
    folder: PathBuf,
    /// Instructions of the shaders, as tools/shader_stats.sh writes them
    #[arg(
        long,
        value_name = "FILE",
        default_value = "docs/experiments/data/shaders.csv"
    )]
    shaders: PathBuf,
    /// Page of Markdown whose tables to replace, in place of printing them
    #[arg(long, value_name = "FILE", value_parser = MARKDOWN.parser())]
    page: Option<Output>,
}

pub fn run(args: Args) -> anyhow::Result<()> {
    let model = PhoneModel::new(Inputs::read(&args.folder, &args.shaders)?)?;
    let tables = model.tables();
    let Some(path) = &args.page else {
        print!("{tables}");
        return Ok(());
    };
    let page = replace_tables(&files::read_text(path)?, &tables)
        .with_context(|| format!("{} has no place for the tables", path.display()))?;
    path.write(page)?;
    println!("wrote {}", path.display());
    Ok(())
}
