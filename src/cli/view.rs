#[derive(clap::Args)]
pub struct Args {}

pub fn run(_args: Args) -> anyhow::Result<()> {
    anyhow::bail!("not built yet")
}

pub fn run_default() -> anyhow::Result<()> {
    anyhow::bail!("not built yet")
}
