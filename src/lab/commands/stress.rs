//! `effigy-lab stress`: hard cases against the f64 reference, from a seed.

use crate::stress::{
    self, BoundUse, CaseOutcome, CategoryReport, StressCase, StressReport, StressSettings,
};
use anyhow::{Context, ensure};
use effigy_cli::{
    files,
    options::DeviceArgs,
    output::{JSON, Output, OutputFolder},
    picture, progress,
};
use effigy_core::scene::FrameImage;
use effigy_measure::error::ErrorMetrics;
use effigy_render::vulkan::Gpu;
use std::{
    path::{Path, PathBuf},
    sync::Arc,
};

/// Failures that are printed, and a count of the rest.
const PRINTED_FAILURES: usize = 20;

#[derive(clap::Args, Debug)]
pub struct Args {
    /// Cases to draw
    #[arg(
        long,
        value_name = "N",
        default_value_t = 2000,
        value_parser = clap::value_parser!(u64).range(1..)
    )]
    cases: u64,
    /// Number of the first case
    #[arg(long, value_name = "N", default_value_t = 0)]
    first: u64,
    /// Seed of the random numbers
    ///
    /// A seed and a number make the same case on every machine.
    #[arg(long, value_name = "N", default_value_t = 7)]
    seed: u64,
    /// Draw the case of this number alone, and print all about it
    #[arg(long, value_name = "N", conflicts_with = "cases")]
    case: Option<u64>,
    /// Also draw images of 8192 × 8192 pixels, which take gigabytes and seconds
    #[arg(long)]
    large: bool,
    /// Folder for the device's image, the reference's and the avatar of --case
    #[arg(short, long, value_name = "DIR", requires = "case")]
    out: Option<OutputFolder>,
    /// Also write the result as JSON
    #[arg(long, value_name = "FILE", conflicts_with = "case", value_parser = JSON.parser())]
    json: Option<Output>,
    #[command(flatten)]
    device: DeviceArgs,
}

pub fn run(args: Args) -> anyhow::Result<()> {
    let gpu = Gpu::new(&args.device.gpu())?;
    match args.case {
        Some(number) => run_one(&args, &gpu, number),
        None => run_all(&args, &gpu),
    }
}

fn run_one(args: &Args, gpu: &Arc<Gpu>, number: u64) -> anyhow::Result<()> {
    let case = StressCase::new(args.seed, number, args.large).for_device(&gpu.probe);
    println!("{}", describe(&case));
    let outcome = stress::check_case(gpu, &case);
    print_outcome(&outcome);
    if let Some(folder) = &args.out {
        write_case(&case, &outcome, folder)?;
    }
    ensure!(
        outcome.faults.is_empty(),
        "case {number} of seed {} fails: {}",
        args.seed,
        outcome.faults.join("; ")
    );
    Ok(())
}

fn run_all(args: &Args, gpu: &Arc<Gpu>) -> anyhow::Result<()> {
    let end = args.first.checked_add(args.cases).with_context(|| {
        let most = u64::MAX;
        format!(
            "--first {} and --cases {}: found a sum above {most}",
            args.first, args.cases
        )
    })?;
    let bar = progress::items(args.cases, "cases");
    let settings = StressSettings {
        seed: args.seed,
        cases: args.first..end,
        large: args.large,
    };
    let report = stress::run(gpu, &settings, &mut |done, _, failed| {
        bar.set_position(done as u64);
        if failed > 0 {
            bar.set_message(format!("{failed} failed"));
        }
    });
    bar.finish_and_clear();
    print_report(&report, args.large);
    if let Some(out) = &args.json {
        out.write_json(&report)?;
        println!("wrote {}", out.display());
    }
    ensure!(
        !report.lost,
        "{} was lost or hung after {} cases",
        report.device,
        report.cases
    );
    ensure!(
        report.failures.is_empty(),
        "{} of {} cases fail",
        report.failures.len(),
        report.cases
    );
    Ok(())
}

/// Prints all categories, and the failures. `large`: the cases were drawn with `--large`.
fn print_report(report: &StressReport, large: bool) {
    println!("device   {} ({})", report.device, report.driver);
    println!(
        "{:15} {:>5} {:>6} {:>13} {:>6} {:>19} {:>19} {:>19} {:>8}  hard because of",
        "category",
        "cases",
        "failed",
        "used (case)",
        "tight",
        "worst dB (case)",
        "device dB (case)",
        "its max (case)",
        "time"
    );
    for category in &report.categories {
        print_category(category);
    }
    for rasterizer in &report.rasterizers {
        println!(
            "{:20} {:>5} cases, {} failed, {:.2} of the bound used at most",
            rasterizer.rasterizer.name(),
            rasterizer.cases,
            rasterizer.failed,
            rasterizer.largest_use
        );
    }
    let slowest = report.slowest.map_or(String::new(), |(case, seconds)| {
        format!(", the slowest {seconds:.2} s (case {case})")
    });
    println!(
        "cases    {} of seed {} in {:.1} s{slowest}",
        report.cases, report.seed, report.seconds
    );
    println!("bits     {}", report.digest);
    for failure in report.failures.iter().take(PRINTED_FAILURES) {
        println!(
            "FAILED   case {} ({}): {}",
            failure.case,
            failure.category.name(),
            failure.faults.join("; ")
        );
        println!(
            "         replay: effigy stress --seed {} --case {}{}",
            report.seed,
            failure.case,
            if large { " --large" } else { "" }
        );
    }
    let more = report.failures.len().saturating_sub(PRINTED_FAILURES);
    if more > 0 {
        println!("         and {more} more");
    }
}

fn print_category(report: &CategoryReport) {
    let case = |case: Option<u64>| case.map_or(String::new(), |case| format!(" ({case})"));
    let decibels = |psnr: Option<f64>, number: Option<u64>| {
        psnr.map_or("–".into(), |psnr| format!("{psnr:.2}{}", case(number)))
    };
    let worst = decibels(report.worst_psnr_db, report.worst_case);
    let device = decibels(
        report.arithmetic_worst_psnr_db,
        report.arithmetic_worst_case,
    );
    let used = format!("{:.2}{}", report.largest_use, case(report.largest_use_case));
    let max_error = format!("{:.4}{}", report.max_error, case(report.max_error_case));
    println!(
        "{:15} {:>5} {:>6} {used:>13} {:>4.0} % {worst:>19} {device:>19} {max_error:>19} \
         {:>6.1} s  {}",
        report.category.name(),
        report.cases,
        report.failed,
        100.0 * report.tight,
        report.seconds,
        report.what
    );
}

/// All inputs of a case.
fn describe(case: &StressCase) -> String {
    let avatar = &case.avatar;
    let widths: Vec<usize> = avatar
        .networks
        .layers
        .iter()
        .map(|layer| layer.output)
        .collect();
    [
        format!(
            "case     {} of {}: {}; {}",
            case.number,
            case.category.name(),
            case.category.what(),
            case.note
        ),
        format!(
            "avatar   {} Gaussians, {} parts, {} nodes, {} joints",
            avatar.gaussians.len(),
            avatar.parts.len(),
            avatar.nodes.len(),
            avatar.skeleton.len()
        ),
        format!(
            "networks {} inputs, then {widths:?}, {:?}",
            avatar.inputs.len(),
            avatar.networks.activation
        ),
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

fn print_outcome(outcome: &CaseOutcome) {
    let print = |name: &str, error: &Option<ErrorMetrics>| {
        if let Some(ErrorMetrics { covered, .. }) = error {
            println!(
                "{name:8} {:.2} dB; {:.4} at most; over {} covered pixels",
                covered.psnr_db, covered.max_error, covered.pixels
            );
        }
    };
    print("error", &outcome.error);
    print("device", &outcome.arithmetic);
    println!("         error: against the reference; device: its arithmetic alone");
    print_use("bound", &outcome.used);
    print_use("cached", &outcome.used_cached);
    println!("time     {:.3} s on the device", outcome.time.as_secs_f64());
    println!("bits     {:016x}", outcome.digest);
    if outcome.faults.is_empty() {
        println!("no faults");
    }
}

fn print_use(name: &str, used: &Option<BoundUse>) {
    let Some(used) = used else {
        return;
    };
    println!(
        "{name:8} {:.3} of it used, by {} of pixel {:?}: {:.5} of {:.5}; {:.2} dB allowed; \
         {:.0} % of covered pixels are bound to within 0.05",
        used.largest,
        ["red", "green", "blue", "coverage"][used.channel],
        used.pixel,
        used.error,
        used.bound,
        used.allowed_db,
        100.0 * used.tight
    );
}

/// Writes the images of the device and of the reference, and the avatar.
fn write_case(case: &StressCase, outcome: &CaseOutcome, folder: &Path) -> anyhow::Result<()> {
    files::create_folder(folder)?;
    let path = |ending: &str| folder.join(format!("case-{}{ending}", case.number));
    let save = |image: &FrameImage, path: PathBuf| {
        picture::write(&image.over([0.5; 3]), &Output::new(path, "png"))
    };
    if let Some([device, reference]) = &outcome.images {
        save(device, path(".png"))?;
        save(reference, path("-reference.png"))?;
    }
    case.avatar.write(&path(".avatar"))?;
    println!("wrote {}", folder.display());
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stress::Category;

    #[test]
    fn a_case_is_its_seed_and_number() {
        for number in 0..2 * Category::ROUND {
            let [a, b] = [0, 1].map(|_| StressCase::new(3, number, false));
            assert_eq!(describe(&a), describe(&b));
            assert!(a.avatar == b.avatar);
        }
        assert_ne!(
            describe(&StressCase::new(3, 1, false)),
            describe(&StressCase::new(4, 1, false))
        );
    }
}
