//! A benchmark's report on the terminal.

use effigy_measure::bench::{
    BenchCase,
    report::{
        BenchReport, CaseReport, FlickerReport, SpreadReport, SweepReport, TimingSummary,
        ViewReport,
    },
};
use effigy_measure::{
    coverage::CLOSED,
    error::VISIBLE,
    flicker::{PairReport, Residual},
};

/// Prints the device, the avatar and the settings.
pub fn print_heading(report: &BenchReport) {
    let device = &report.device;
    let avatar = &report.avatar;
    let options = &report.options;
    let api = if device.vulkan.is_empty() {
        "WebGPU".to_owned()
    } else {
        format!("Vulkan {}", device.vulkan)
    };
    println!("device   {} ({}), {api}", device.name, device.driver);
    println!(
        "avatar   {}, {} Gaussians, {:?} rows; clip {}",
        avatar.name, avatar.gaussians, avatar.rows, avatar.clip
    );
    println!(
        "image    {} × {}, {}, {}",
        report.size[0], report.size[1], options.raster, options.color
    );
    println!(
        "error    cutoff {:.1}/255, detail {}, low-pass {}",
        255.0 * options.cutoff,
        options.detail,
        options.filter
    );
    println!("skipped  {}", options.skip);
}

/// Prints what was measured of one case.
pub fn print_case(case: BenchCase, report: &CaseReport) {
    println!("\n{case}: {}, {} frames", case.about(), report.frames);
    let times = |ms: &TimingSummary| {
        format!(
            "{:9.3} ms median, {:.3} mean, {:.3} p5, {:.3} p95, {:.3} p99",
            ms.median, ms.mean, ms.p5, ms.p95, ms.p99
        )
    };
    let frame = times(&report.frame_ms);
    println!("  frame     {frame}; {:.1} fps", report.fps);
    if let Some(gpu) = &report.gpu_ms {
        println!("  GPU       {}", times(gpu));
    }
    if report.stages.iter().any(|stage| stage.ran > 0.0) {
        print_stages(report);
    }
    print_counters(report);
    if let (Some(all), Some(used)) = (report.gpu_memory_bytes, report.gpu_memory_used_bytes) {
        println!(
            "  memory    {:.1} MB of the device's, {:.1} MB in use",
            mega(all),
            mega(used)
        );
    }
    if let Some(error) = &report.error {
        let flip = error.flip.map(|flip| format!(", FLIP {flip:.4}"));
        println!(
            "  error     {}, {:.4} at most, {:.3} % of covered pixels within 4/255{}",
            decibels(error.psnr_db),
            error.max_error,
            100.0 * error.within_tolerance,
            flip.unwrap_or_default()
        );
        println!(
            "            {}, {:.4} at most over whole images",
            decibels(error.psnr_db_whole),
            error.max_error_whole
        );
        println!(
            "            worst of {} frames against the f64 reference",
            error.frames
        );
    }
    if let Some(flicker) = &report.flicker {
        print_flicker(flicker);
    }
}

fn mega(count: u64) -> f64 {
    count as f64 / 1e6
}

/// A line per stage, and one of their sums over a mean frame.
fn print_stages(report: &CaseReport) {
    println!(
        "  {:9}{:>12}{:>8}{:>11}{:>10}{:>7}{:>12}{:>12}",
        "stage", "ms", "ran", "MB", "floor", "ratio", "Mop", "floor"
    );
    let bytes = |moved: Option<u64>, floor: Option<u64>| {
        let (moved, floor) = (moved.unwrap_or_default(), floor.unwrap_or_default());
        let ratio = (floor > 0).then(|| moved as f64 / floor as f64);
        let ratio = known(ratio, 2);
        format!("{:11.2}{:10.2}{ratio:>7}", mega(moved), mega(floor))
    };
    for stage in &report.stages {
        println!(
            "  {:9}{:>12}{:>7.0}%{}{:>12}{:>12}",
            stage.name,
            known(stage.ms.map(|ms| ms.median), 3),
            100.0 * stage.ran,
            bytes(stage.bytes, stage.bytes_floor),
            known(stage.operations.map(mega), 2),
            known(stage.operations_floor.map(mega), 2),
        );
    }
    let all = bytes(report.bytes, report.bytes_floor);
    println!("  {:9}{:>20}{all}   a mean frame", "all", "");
}

/// A number with so many decimals, or a dash.
fn known(number: Option<f64>, decimals: usize) -> String {
    number.map_or("–".to_owned(), |number| format!("{number:.decimals$}"))
}

/// Prints the mean counters of a frame, those that were counted.
fn print_counters(report: &CaseReport) {
    let count = |name: &str| report.counters.get(name).copied();
    // Counters with their labels, as `label count, label count`.
    let list = |counters: &[(&str, &str)]| {
        let counted = counters.iter().filter_map(|(name, label)| {
            let count = number(count(name)?);
            Some(format!("{label} {count}"))
        });
        counted.collect::<Vec<_>>().join(", ")
    };
    let print = |title: &str, listed: String| {
        if !listed.is_empty() {
            println!("  {title:9} {listed}");
        }
    };
    let gaussians = [
        ("gaussians", "in"),
        ("drawn", "drawn"),
        ("culled", "culled"),
    ];
    print("Gaussians", list(&gaussians));
    let reasons = [
        ("skipped_by_detail", "skipped by detail"),
        ("outside", "outside"),
        ("away", "away"),
        ("faint", "faint"),
        ("degenerate", "degenerate"),
    ];
    let has_skipped = count("skipped_by_detail") > Some(0.0);
    print("culled", list(&reasons[usize::from(!has_skipped)..]));
    if count("avatars") > Some(1.0) {
        print(
            "avatars",
            list(&[("avatars", "in"), ("avatars_culled", "culled")]),
        );
    }
    let drawn = list(&[("damaged", "damaged"), ("fragments", "fragments")]);
    let covered = report
        .covered_pixels
        .map(|own| format!("covered {}", number(own)));
    let ratio = report.fragments_a_pixel;
    let ratio = ratio.map(|own| format!("{own:.2} fragments per covered pixel"));
    let drawn = (!drawn.is_empty()).then_some(drawn);
    let pixels: Vec<String> = [drawn, covered, ratio].into_iter().flatten().collect();
    print("pixels", pixels.join(", "));
    let commands = [("dispatches", "dispatches"), ("submitted", "submitted")];
    print("commands", list(&commands));
}

/// A mean count, without decimals if it is whole.
fn number(count: f64) -> String {
    let decimals = usize::from(count.fract() != 0.0);
    format!("{count:.decimals$}")
}

fn decibels(psnr: Option<f64>) -> String {
    psnr.map_or("no error".to_owned(), |psnr| format!("{psnr:.2} dB"))
}

/// Prints what changes from frame to frame, in 255ths, and what each switch changes.
fn print_flicker(flicker: &FlickerReport) {
    println!(
        "  {:24}{:>10}{:>10}{:>10}{:>10}   changes in /255, FLIP",
        "flicker", "mean", "99.9 %", "worst", "FLIP"
    );
    for step in &flicker.steps {
        println!(
            "  {} pairs {} apart, {:.1} % of the covered pixels",
            step.pairs,
            frames(step.step),
            100.0 * step.compared
        );
        print_residual("drawn", &step.drawn);
        print_residual("reference", &step.reference);
        print_residual("added", &step.added);
        if let Some(sorting) = &step.sorting {
            print_residual("sorted per pixel", &sorting.per_pixel);
            print_residual("added by centres", &sorting.added);
        }
        println!(
            "    {:+.1} % to the mean of the reference",
            100.0 * step.excess()
        );
    }
    for pair in flicker.pairs.iter().filter(|pair| pair.switches()) {
        print_switch(pair);
    }
    if let Some(sorting) = &flicker.sorting {
        println!(
            "  sorting   by centres against each pixel's own order, both the reference's: {}, {:.4} \
             at most",
            decibels(sorting.psnr_db),
            sorting.max_error
        );
    }
}

fn print_residual(name: &str, residual: &Residual) {
    println!(
        "    {name:22}{:10.3}{:10.1}{:10.1}{:>10}",
        255.0 * residual.mean,
        255.0 * residual.p999,
        255.0 * residual.max,
        known(residual.flip, 4)
    );
}

/// Prints what a switch between two frames changes.
fn print_switch(pair: &PairReport) {
    let [from, to] = pair.shown;
    let side = pair
        .side
        .map_or("near".to_owned(), |side| format!("{side:.0} px"));
    println!(
        "  switch, frames {} to {}, {side}: {:.2} × {} to {:.2} × {} Gaussians; mean {:.3}, the reference's \
         {:.3}, added {:.3}, {:.1} at most",
        pair.from,
        pair.to,
        from.samples,
        number(f64::from(from.gaussians)),
        to.samples,
        number(f64::from(to.gaussians)),
        255.0 * pair.drawn.mean,
        255.0 * pair.reference.mean,
        255.0 * pair.added.mean,
        255.0 * pair.added.max,
    );
}

/// A number of frames in words.
fn frames(count: usize) -> String {
    if count == 1 {
        "1 frame".to_owned()
    } else {
        format!("{count} frames")
    }
}

/// Prints the error over poses and views.
pub fn print_spread(spread: &SpreadReport) {
    println!(
        "\nspread: {} views of {} × {} against nothing skipped",
        spread.views, spread.size[0], spread.size[1]
    );
    println!(
        "  error     {} mean, {} median, {:.4} at most",
        decibels(spread.mean_db),
        decibels(spread.median_db),
        spread.max_error
    );
    println!("  worst     {}", view(&spread.worst));
    if spread.most_visible != spread.worst {
        println!("            {}", view(&spread.most_visible));
    }
    if let Some(least) = &spread.least_covered {
        println!(
            "  coverage  {:.4} in the silhouette that lets most through, {} pixels under {CLOSED}: {}",
            least.coverage,
            least.holes,
            place(least)
        );
    }
}

fn view(view: &ViewReport) -> String {
    format!(
        "{}, {:.4} at most, {} pixels off by more than {VISIBLE}: {}",
        decibels(view.psnr_db),
        view.max_error,
        view.visible,
        place(view)
    )
}

/// When and from where a view is seen.
fn place(view: &ViewReport) -> String {
    let [x, y, z] = view.eye;
    format!(
        "{} at {:.2} s, view {} from ({x:.2}, {y:.2}, {z:.2})",
        view.clip, view.seconds, view.view
    )
}

/// Prints a sweep's points, with a star where no other is both faster and closer to the reference.
pub fn print_sweep(sweep: &SweepReport) {
    println!(
        "\nsweep of the case `{}`: {} frames, {} rounds in turn; * on the Pareto front",
        sweep.case, sweep.frames, sweep.rounds
    );
    println!(
        "  {:22}{:>11}{:>8}{:>15}{:>11}{:>11}{:>9}{:>11}",
        "", "frame ms", "ratio", "in rounds", "error", "at most", "right", "drawn"
    );
    for point in &sweep.points {
        let name = format!("{} {}", point.parameter, point.value);
        let drawn = point
            .counters
            .get("drawn")
            .map_or("–".to_owned(), |&drawn| number(drawn.round()));
        let range = format!(
            "{:.3}–{:.3}",
            point.time_ratio_range[0], point.time_ratio_range[1]
        );
        println!(
            "{} {name:22}{:11.3}{:8.3}{range:>15}{:>11}{:11.4}{:>8.3}%{drawn:>11}",
            if point.on_front { "*" } else { " " },
            point.frame_ms,
            point.time_ratio,
            decibels(point.error.psnr_db),
            point.error.max_error,
            100.0 * point.error.within_tolerance,
        );
    }
    if sweep.points.iter().any(|point| point.flicker.is_some()) {
        print_sweep_flicker(sweep);
    }
    for failure in &sweep.failed {
        println!("  not measured: {failure}");
    }
}

/// Prints the flicker of a sweep's points: mean changes in 255ths, over each distance between
/// frames.
fn print_sweep_flicker(sweep: &SweepReport) {
    println!("\n  flicker, in /255: mean and added mean, 99.9 % and worst of what is added, FLIP");
    for point in &sweep.points {
        let name = format!("{} {}", point.parameter, point.value);
        let steps = point.flicker.iter().flat_map(|flicker| &flicker.steps);
        for step in steps {
            println!(
                "  {name:22}{:>9}{:9.3} {:>+8.2} %{:9.3}{:9.1}{:9.1}{:>9.4}",
                frames(step.step),
                255.0 * step.drawn.mean,
                100.0 * step.excess(),
                255.0 * step.added.mean,
                255.0 * step.added.p999,
                255.0 * step.added.max,
                step.drawn.flip.unwrap_or_default(),
            );
        }
    }
}
