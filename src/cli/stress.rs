//! `effigy stress`: hard cases against the f64 reference, from a seed.

use super::render::progress;
use crate::{
    frame::Picture,
    measure::error::Error,
    measure::stress::{self, Case, FamilyReport, Outcome, Report, Settings},
    vulkan::{Gpu, GpuOptions},
};
use anyhow::{Context, ensure};
use std::path::{Path, PathBuf};

#[derive(clap::Args)]
pub struct Args {
    /// How many cases to draw
    #[arg(long, default_value_t = 2000)]
    cases: u64,
    /// Number of the first case
    #[arg(long, default_value_t = 0)]
    first: u64,
    /// What all cases are made from: the same seed gives the same cases everywhere
    #[arg(long, default_value_t = 7)]
    seed: u64,
    /// Draw one case alone and print all of it
    #[arg(long, value_name = "N", conflicts_with = "cases")]
    case: Option<u64>,
    /// Pictures of 8192 × 8192 px too, which take gigabytes and seconds
    #[arg(long)]
    large: bool,
    /// With --case: write the device's picture, the reference's and the avatar here
    #[arg(long, value_name = "FOLDER", requires = "case")]
    out: Option<PathBuf>,
    /// Write the result as JSON too
    #[arg(long, value_name = "FILE", conflicts_with = "case")]
    json: Option<PathBuf>,
    /// GPU to use: part of its name, or its number in `effigy devices` [default: the first that can serve]
    #[arg(long, value_name = "NAME")]
    device: Option<String>,
}

pub fn run(args: Args) -> anyhow::Result<()> {
    let gpu = Gpu::new(&GpuOptions::headless(args.device.clone()))?;
    if let Some(number) = args.case {
        let case = Case::new(args.seed, number, args.large).on(&gpu.probe);
        println!("{}", describe(&case));
        let outcome = stress::try_case(&gpu, &case);
        print_outcome(&outcome);
        if let Some(folder) = &args.out {
            write(&case, &outcome, folder)?;
        }
        ensure!(outcome.faults.is_empty(), "case {number} of seed {} fails: {}", args.seed, outcome.faults.join("; "));
        return Ok(());
    }
    let bar = progress(args.cases, "cases");
    let settings = Settings { seed: args.seed, cases: args.first..args.first.saturating_add(args.cases), large: args.large };
    let report = stress::run(&gpu, &settings, &mut |done, _, failed| {
        bar.set_position(done as u64);
        if failed > 0 {
            bar.set_message(format!("{failed} failed"));
        }
    });
    bar.finish_and_clear();
    print(&report, &args);
    if let Some(path) = &args.json {
        let text = serde_json::to_string_pretty(&report)?;
        std::fs::write(path, text + "\n").with_context(|| format!("{} can't be written", path.display()))?;
        println!("wrote {}", path.display());
    }
    ensure!(!report.lost, "{} was lost or hung after {} cases", report.device, report.cases);
    ensure!(report.failures.is_empty(), "{} of {} cases fail", report.failures.len(), report.cases);
    Ok(())
}

fn print(report: &Report, args: &Args) {
    println!("device   {} ({})", report.device, report.driver);
    println!(
        "{:15} {:>5} {:>6} {:>9} {:>19} {:>19} {:>19} {:>8}  hard because of",
        "family", "cases", "failed", "ill-posed", "worst dB (case)", "device dB (case)", "its most (case)", "time"
    );
    for family in &report.families {
        let FamilyReport { cases, failed, ill_posed, max_error, seconds, what, .. } = family;
        let at = |case: Option<u64>| case.map_or(String::new(), |case| format!(" ({case})"));
        let least = |psnr: Option<f64>, case| psnr.map_or("–".into(), |psnr| format!("{psnr:.2}{}", at(case)));
        let worst = least(family.worst_psnr_db, family.worst_case);
        let device = least(family.arithmetic_worst_psnr_db, family.arithmetic_worst_case);
        let max_error = format!("{max_error:.4}{}", at(family.max_error_case));
        let name = family.family.name();
        println!("{name:15} {cases:>5} {failed:>6} {ill_posed:>9} {worst:>19} {device:>19} {max_error:>19} {seconds:>6.1} s  {what}");
    }
    let slowest = report.slowest.map_or(String::new(), |(case, seconds)| format!(", the slowest {seconds:.2} s (case {case})"));
    println!("cases    {} of seed {} in {:.1} s{slowest}", report.cases, report.seed, report.seconds);
    println!("bits     {}", report.digest);
    for failure in report.failures.iter().take(20) {
        println!("FAILED   case {} ({}): {}", failure.case, failure.family.name(), failure.faults.join("; "));
        println!(
            "         replay: effigy stress --seed {} --case {}{}",
            report.seed,
            failure.case,
            if args.large { " --large" } else { "" }
        );
    }
    if report.failures.len() > 20 {
        println!("         and {} more", report.failures.len() - 20);
    }
}

/// All that decides about a case.
fn describe(case: &Case) -> String {
    let (g, avatar) = (&case.avatar.gaussians, &case.avatar);
    let widths: Vec<usize> = avatar.networks.layers.iter().map(|layer| layer.output).collect();
    [
        format!("case     {} of {}: {}; {}", case.number, case.family.name(), case.family.what(), case.note),
        format!(
            "avatar   {} Gaussians, {} parts, {} nodes, {} joints",
            g.len(),
            avatar.parts.len(),
            avatar.nodes.len(),
            avatar.skeleton.len()
        ),
        format!("networks {} inputs, then {widths:?}, {:?}", avatar.inputs.len(), avatar.networks.activation),
        format!(
            "rows     {} of rotation, {} of scale, {} of colour",
            avatar.rotation_rows.gaussian.len(),
            avatar.scale_rows.gaussian.len(),
            avatar.color_rows.gaussian.len()
        ),
        format!("pose     {:?}", case.pose),
        format!("placed   {:?}", case.placed),
        format!("camera   {:?}", case.camera),
        format!("options  {:?}", case.options),
    ]
    .join("\n")
}

fn print_outcome(outcome: &Outcome) {
    let bound = outcome.bound;
    for (what, error, least) in [("error", outcome.error, bound.model_db.min(bound.psnr_db)), ("device", outcome.arithmetic, bound.psnr_db)]
    {
        let Some(Error { covered, .. }) = error else { continue };
        let (psnr, most, pixels) = (covered.psnr_db, covered.max_error, covered.pixels);
        println!("{what:8} {psnr:.2} dB, {least:.2} is the bound; {most:.4} at most; over {pixels} covered pixels");
    }
    println!("         against the reference; the device's arithmetic alone, of which {:.4} is the bound", bound.max_error);
    if let Some(moved) = outcome.conditioned_db {
        println!("ill-posed: the reference against itself, moved by rounding, {moved:.2} dB");
    }
    println!("time     {:.3} s on the device", outcome.time.as_secs_f64());
    println!("bits     {:016x}", outcome.digest);
    if outcome.faults.is_empty() {
        println!("nothing is wrong with it");
    }
}

fn write(case: &Case, outcome: &Outcome, folder: &Path) -> anyhow::Result<()> {
    std::fs::create_dir_all(folder).with_context(|| format!("{} can't be made", folder.display()))?;
    let name = |ending: &str| folder.join(format!("case-{}{ending}", case.number));
    let save = |picture: &Picture, path: PathBuf| {
        picture.over([0.5; 3]).save(&path).with_context(|| format!("{} can't be written", path.display()))
    };
    if let Some([device, reference]) = &outcome.pictures {
        save(device, name(".png"))?;
        save(reference, name("-reference.png"))?;
    }
    case.avatar.write(&name(".avatar"))?;
    println!("wrote {}", folder.display());
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::stress::Family;

    #[test]
    fn a_case_is_its_seed_and_number() {
        for number in 0..Family::ALL.len() as u64 {
            let [a, b] = [0, 1].map(|_| Case::new(3, number, false));
            assert_eq!(describe(&a), describe(&b));
            assert!(a.avatar == b.avatar);
        }
        assert_ne!(describe(&Case::new(3, 1, false)), describe(&Case::new(4, 1, false)));
    }
}
