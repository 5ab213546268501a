//! A benchmark's report on the terminal.

use crate::measure::bench::{
    Case,
    report::{CaseReport, ErrorReport, Report, Spread, StageReport, SweepReport},
};

/// What is measured on what.
pub fn heading(report: &Report) {
    let (avatar, options) = (&report.avatar, &report.options);
    let through = if report.device.vulkan.is_empty() { "WebGPU".to_owned() } else { format!("Vulkan {}", report.device.vulkan) };
    println!("device   {} ({}), {through}", report.device.name, report.device.driver);
    println!("avatar   {}, {} Gaussians, {:?} rows; clip {}", avatar.name, avatar.gaussians, avatar.rows, avatar.clip);
    println!("picture  {} × {}, {}, {}, {}-bit keys", report.size[0], report.size[1], options.raster, options.color, options.key_bits);
    println!("error    cutoff {:.1}/255, margin {:.1} mm, detail {}", 255.0 * options.cutoff, 1e3 * options.margin, options.detail);
    println!("skipped  {}", options.skip);
}

/// One case.
pub fn case(case: Case, report: &CaseReport) {
    println!("\n{case}: {}, {} frames", case.about(), report.frames);
    let times = |spread: &Spread| {
        format!(
            "{:9.3} ms median, {:.3} mean, {:.3} p5, {:.3} p95, {:.3} p99",
            spread.median, spread.mean, spread.p5, spread.p95, spread.p99
        )
    };
    println!("  frame     {}; {:.1} fps", times(&report.frame_ms), report.fps);
    if let Some(gpu) = &report.gpu_ms {
        println!("  GPU       {}", times(gpu));
    }
    if report.stages.iter().any(|stage| stage.ran > 0.0) {
        println!("  {:9}{:>12}{:>8}{:>11}{:>10}{:>7}{:>12}{:>12}", "stage", "ms", "ran", "MB", "floor", "ratio", "Mop", "floor");
        report.stages.iter().for_each(stage);
        let [bytes, floor] = [report.bytes, report.bytes_floor].map(Option::unwrap_or_default);
        println!("  {:9}{:>20}{:11.2}{:10.2}{:>7}   a mean frame", "all", "", mega(bytes), mega(floor), ratio(bytes, floor));
    }
    counters(report);
    if let (Some(all), Some(used)) = (report.gpu_memory_bytes, report.gpu_memory_used_bytes) {
        println!("  memory    {:.1} MB of the device's, {:.1} MB in use", mega(all), mega(used));
    }
    report.error.iter().for_each(error);
}

fn mega(count: u64) -> f64 {
    count as f64 / 1e6
}

fn ratio(counted: u64, floor: u64) -> String {
    if floor == 0 { "–".to_owned() } else { format!("{:.2}", counted as f64 / floor as f64) }
}

fn stage(stage: &StageReport) {
    let ms = stage.ms.map_or("–".to_owned(), |ms| format!("{:.3}", ms.median));
    let [bytes, floor] = [stage.bytes, stage.bytes_floor].map(Option::unwrap_or_default);
    let operations = |count: Option<u64>| count.map_or("–".to_owned(), |count| format!("{:.2}", mega(count)));
    println!(
        "  {:9}{ms:>12}{:>7.0}%{:11.2}{:10.2}{:>7}{:>12}{:>12}",
        stage.name,
        100.0 * stage.ran,
        mega(bytes),
        mega(floor),
        ratio(bytes, floor),
        operations(stage.operations),
        operations(stage.operations_floor),
    );
}

fn counters(report: &CaseReport) {
    let count = |name: &str| report.counters.get(name).map(|count| format!("{name} {}", number(*count)));
    let some = |names: &[&str]| names.iter().filter_map(|name| count(name)).collect::<Vec<_>>().join(", ");
    println!("  Gaussians {}", some(&["gaussians", "drawn", "culled"]).replacen("gaussians", "in", 1));
    let thinned = report.counters.get("thinned").filter(|&&count| count > 0.0).map(|_| "thinned");
    let reasons = some(&[thinned.as_slice(), &["outside", "hidden", "faint", "degenerate"]].concat());
    if !reasons.is_empty() {
        println!("  culled    {reasons}");
    }
    if report.counters.get("avatars").is_some_and(|&avatars| avatars > 1.0) {
        println!("  avatars   {}", some(&["avatars", "avatars_culled"]).replacen("avatars_", "", 1).replacen("avatars", "in", 1));
    }
    let mut pixels: Vec<String> = some(&["area", "fragments"]).split_terminator('\n').map(str::to_owned).collect();
    pixels.extend(report.covered_pixels.map(|covered| format!("covered {}", number(covered))));
    pixels.extend(report.fragments_a_pixel.map(|ratio| format!("{ratio:.2} fragments a covered pixel")));
    if !pixels.is_empty() {
        println!("  pixels    {}", pixels.join(", "));
    }
    println!("  commands  {}", some(&["dispatches", "submitted"]));
}

/// A mean count: whole where it is whole.
fn number(count: f64) -> String {
    if count.fract() == 0.0 { format!("{count:.0}") } else { format!("{count:.1}") }
}

fn decibel(psnr: Option<f64>) -> String {
    psnr.map_or("no error".to_owned(), |psnr| format!("{psnr:.2} dB"))
}

fn error(error: &ErrorReport) {
    let flip = error.flip.map_or(String::new(), |flip| format!(", FLIP {flip:.4}"));
    let right = 100.0 * error.within_tolerance;
    println!("  error     {}, {:.4} at most, {right:.3} % of covered pixels within 4/255{flip}", decibel(error.psnr_db), error.max_error);
    println!("            {}, {:.4} at most over whole pictures", decibel(error.psnr_db_whole), error.max_error_whole);
    println!("            worst of {} frames against the f64 reference", error.frames);
}

/// A sweep's points, those that nothing beats with a star.
pub fn sweep(sweep: &SweepReport) {
    println!("\nsweep of the case `{}`: {} frames, {} rounds in turn; * on the Pareto front", sweep.case, sweep.frames, sweep.rounds);
    println!("  {:22}{:>11}{:>8}{:>15}{:>11}{:>11}{:>9}{:>11}", "", "frame ms", "ratio", "in rounds", "error", "at most", "right", "drawn");
    for point in &sweep.points {
        let name = format!("{} {}", point.knob, point.value);
        let drawn = point.counters.get("drawn").map_or("–".to_owned(), |&drawn| number(drawn.round()));
        let range = format!("{:.3}–{:.3}", point.time_ratio_range[0], point.time_ratio_range[1]);
        println!(
            "{} {name:22}{:11.3}{:8.3}{range:>15}{:>11}{:11.4}{:>8.3}%{drawn:>11}",
            if point.on_front { "*" } else { " " },
            point.frame_ms,
            point.time_ratio,
            decibel(point.error.psnr_db),
            point.error.max_error,
            100.0 * point.error.within_tolerance,
        );
    }
    sweep.failed.iter().for_each(|failure| println!("  not measured: {failure}"));
}
