//! A benchmark's report on the terminal.

use effigy_measure::bench::{
    BenchCase,
    report::{
        BenchReport, CaseReport, ErrorReport, FlickerReport, SpreadReport, StageReport,
        SweepReport, TimingSummary, ViewReport,
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
    println!(
        "  frame     {}; {:.1} fps",
        times(&report.frame_ms),
        report.fps
    );
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
        print_error(error);
    }
    if let Some(flicker) = &report.flicker {
        print_flicker(flicker);
    }
}

/// Milliseconds.
fn times(spread: &TimingSummary) -> String {
    format!(
        "{:9.3} ms median, {:.3} mean, {:.3} p5, {:.3} p95, {:.3} p99",
        spread.median, spread.mean, spread.p5, spread.p95, spread.p99
    )
}

fn mega(count: u64) -> f64 {
    count as f64 / 1e6
}

fn ratio(counted: u64, floor: u64) -> String {
    if floor == 0 {
        "–".to_owned()
    } else {
        format!("{:.2}", counted as f64 / floor as f64)
    }
}

/// A line per stage, and one of their sums over a mean frame.
fn print_stages(report: &CaseReport) {
    println!(
        "  {:9}{:>12}{:>8}{:>11}{:>10}{:>7}{:>12}{:>12}",
        "stage", "ms", "ran", "MB", "floor", "ratio", "Mop", "floor"
    );
    for stage in &report.stages {
        print_stage(stage);
    }
    let bytes = report.bytes.unwrap_or_default();
    let floor = report.bytes_floor.unwrap_or_default();
    println!(
        "  {:9}{:>20}{:11.2}{:10.2}{:>7}   a mean frame",
        "all",
        "",
        mega(bytes),
        mega(floor),
        ratio(bytes, floor)
    );
}

fn print_stage(stage: &StageReport) {
    let ms = stage
        .ms
        .map_or("–".to_owned(), |ms| format!("{:.3}", ms.median));
    let bytes = stage.bytes.unwrap_or_default();
    let floor = stage.bytes_floor.unwrap_or_default();
    let operations =
        |count: Option<u64>| count.map_or("–".to_owned(), |count| format!("{:.2}", mega(count)));
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

/// Prints the mean counters of a frame, those that were counted.
fn print_counters(report: &CaseReport) {
    let count = |name: &str| report.counters.get(name).copied();
    // Pairs of a counter and its label, as `label count, label count`.
    let list = |counters: &[(&str, &str)]| {
        let counted = counters.iter().filter_map(|(name, label)| {
            let count = count(name)?;
            Some(format!("{label} {}", number(count)))
        });
        counted.collect::<Vec<_>>().join(", ")
    };
    println!(
        "  Gaussians {}",
        list(&[
            ("gaussians", "in"),
            ("drawn", "drawn"),
            ("culled", "culled")
        ])
    );
    let mut reasons = vec![
        ("outside", "outside"),
        ("faint", "faint"),
        ("degenerate", "degenerate"),
    ];
    if count("skipped_by_detail") > Some(0.0) {
        reasons.insert(0, ("skipped_by_detail", "skipped by detail"));
    }
    let reasons = list(&reasons);
    if !reasons.is_empty() {
        println!("  culled    {reasons}");
    }
    if count("avatars") > Some(1.0) {
        println!(
            "  avatars   {}",
            list(&[("avatars", "in"), ("avatars_culled", "culled")])
        );
    }
    let mut pixels = Vec::new();
    let drawn = list(&[("damaged", "damaged"), ("fragments", "fragments")]);
    if !drawn.is_empty() {
        pixels.push(drawn);
    }
    if let Some(covered) = report.covered_pixels {
        pixels.push(format!("covered {}", number(covered)));
    }
    if let Some(ratio) = report.fragments_a_pixel {
        pixels.push(format!("{ratio:.2} fragments per covered pixel"));
    }
    if !pixels.is_empty() {
        println!("  pixels    {}", pixels.join(", "));
    }
    println!(
        "  commands  {}",
        list(&[("dispatches", "dispatches"), ("submitted", "submitted")])
    );
}

/// A mean count, without decimals if it is whole.
fn number(count: f64) -> String {
    if count.fract() == 0.0 {
        format!("{count:.0}")
    } else {
        format!("{count:.1}")
    }
}

fn decibels(psnr: Option<f64>) -> String {
    psnr.map_or("no error".to_owned(), |psnr| format!("{psnr:.2} dB"))
}

fn print_error(error: &ErrorReport) {
    let flip = error
        .flip
        .map_or(String::new(), |flip| format!(", FLIP {flip:.4}"));
    println!(
        "  error     {}, {:.4} at most, {:.3} % of covered pixels within 4/255{flip}",
        decibels(error.psnr_db),
        error.max_error,
        100.0 * error.within_tolerance
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
    let flip = residual
        .flip
        .map_or("–".to_owned(), |flip| format!("{flip:.4}"));
    println!(
        "    {name:22}{:10.3}{:10.1}{:10.1}{flip:>10}",
        255.0 * residual.mean,
        255.0 * residual.p999,
        255.0 * residual.max
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
