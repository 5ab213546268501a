//! A verdict as a page of Markdown.

use super::{Verdict, named_bench::NamedBench, test_results::TestResults, traffic::StageTraffic};
use crate::{
    sorts::{SortRow, SortsReport},
    training::TrainingReport,
};
use effigy_measure::{
    bench::report::{CaseReport, ErrorReport, SweepReport},
    rates::RatesReport,
    soak::SoakReport,
};

/// The case whose stages are listed one by one.
const STAGE_CASE: &str = "full";
/// Reasons and failures that are listed; the JSON has all.
const MOST_LISTED: usize = 12;

impl Verdict {
    /// The verdict in tables, with the faults first.
    pub fn page(&self) -> String {
        let mut page = Page::default();
        self.heading(&mut page);
        self.step_table(&mut page);
        if let Some(tests) = &self.tests {
            test_section(&mut page, tests);
        }
        if !self.self_test.is_empty() {
            page.heading("The sort's self-test");
            page.table(&["variant", "outcome"]);
            for tried in &self.self_test {
                page.row([tried.variant.name().to_owned(), tried.outcome.to_string()]);
            }
        }
        if let Some(sorts) = &self.sorts {
            sort_section(&mut page, sorts);
        }
        if let Some(rates) = &self.rates {
            rate_section(&mut page, rates);
        }
        if !self.benches.is_empty() {
            frame_section(&mut page, &self.benches);
        }
        traffic_section(&mut page, &self.traffic);
        if let Some(training) = &self.training {
            training_section(&mut page, training);
        }
        if let Some(soak) = &self.soak {
            soak_section(&mut page, soak);
        }
        self.choice_section(&mut page);
        page.text
    }

    fn heading(&self, page: &mut Page) {
        let name = self.device.as_ref().map(|device| device.name.as_str());
        let name = name.unwrap_or("an unknown device");
        page.line(&format!("# Verdict on {name}"));
        if let Some(device) = &self.device {
            page.paragraph(&format!(
                "{}, Vulkan {}, subgroups of {}{}.",
                device.driver,
                device.vulkan,
                device.subgroup_size,
                if device.timestamps {
                    ""
                } else {
                    ", no timestamps: no times of stages"
                }
            ));
        }
        let commit = self.program.commit.as_deref().unwrap_or("unknown");
        page.paragraph(&format!(
            "Version {}, commit {commit}, {}.",
            self.program.version, self.program.date
        ));
        let faults = self.faults();
        if faults.is_empty() {
            page.paragraph("Every step passed.");
        } else {
            page.paragraph(&format!("**Not right:** {}.", faults.join("; ")));
        }
        if !self.machine.trim().is_empty() {
            page.code("text", self.machine.trim());
        }
    }

    fn step_table(&self, page: &mut Page) {
        page.heading("Steps");
        page.table(&["step", "outcome", "seconds", "limit", "note"]);
        for step in &self.steps {
            page.row([
                step.name.clone(),
                step.outcome.words().to_owned(),
                format!("{:.0}", step.seconds),
                format!("{:.0}", step.limit_seconds),
                step.note.clone(),
            ]);
        }
    }

    fn choice_section(&self, page: &mut Page) {
        let Some(devices) = &self.devices else {
            return;
        };
        page.heading("What the renderer chose");
        page.paragraph("As `effigy devices --json` says, features and limits left out here:");
        let all = devices.as_array().map_or(&[][..], Vec::as_slice);
        for device in all {
            let mut shown = serde_json::Map::new();
            for (key, value) in device.as_object().into_iter().flatten() {
                let is_limit = key.starts_with("max_") || key.ends_with("_bytes");
                if key != "optional" && !is_limit {
                    shown.insert(key.clone(), value.clone());
                }
            }
            if let Ok(text) = serde_json::to_string_pretty(&shown) {
                page.code("json", &text);
            }
        }
    }
}

fn test_section(page: &mut Page, tests: &TestResults) {
    page.heading("Tests");
    page.paragraph(&format!(
        "{} passed, {} failed, {} did not end, {} can't run on this device, with the validation \
         layer on.",
        tests.passed,
        tests.failed.len(),
        tests.unheard.len(),
        tests.not_run.len()
    ));
    for (what, names) in [("Failed", &tests.failed), ("Did not end", &tests.unheard)] {
        if !names.is_empty() {
            page.paragraph(&format!("{what}: {}.", some(names)));
        }
    }
    let mut reasons: Vec<String> = tests
        .not_run
        .iter()
        .map(|test| test.reason.clone())
        .collect();
    reasons.sort_unstable();
    reasons.dedup();
    if !reasons.is_empty() {
        page.paragraph(&format!("Why some can't run: {}.", some(&reasons)));
    }
}

/// The first of some texts, and how many are left.
fn some(texts: &[String]) -> String {
    let mut listed: Vec<String> = texts.iter().take(MOST_LISTED).cloned().collect();
    if texts.len() > MOST_LISTED {
        listed.push(format!("and {} more", texts.len() - MOST_LISTED));
    }
    listed.join("; ")
}

fn sort_section(page: &mut Page, sorts: &SortsReport) {
    page.heading("Sort");
    page.paragraph(&format!(
        "Millions of keys a second, the median of {}; each order is the CPU's unless it says wrong. \
         The self-test chooses `{}`. A number after a name is the subgroups' size that was asked \
         for.",
        sorts.runs, sorts.auto
    ));
    let mut names: Vec<String> = Vec::new();
    let mut keys: Vec<(u32, usize)> = Vec::new();
    for row in &sorts.rows {
        let name = row.name();
        if !names.contains(&name) {
            names.push(name);
        }
        if !keys.contains(&(row.bits, row.keys)) {
            keys.push((row.bits, row.keys));
        }
    }
    let head: Vec<&str> = ["bits", "keys"]
        .into_iter()
        .chain(names.iter().map(String::as_str))
        .collect();
    page.table(&head);
    for (bits, count) in keys {
        let cell = |name: &String| {
            let of_row =
                |row: &&SortRow| row.bits == bits && row.keys == count && row.name() == *name;
            let row = sorts.rows.iter().find(of_row);
            row.map_or("–".to_owned(), |row| match row.speed {
                Some(speed) => figure(speed.mkeys_per_s),
                None => "**wrong**".to_owned(),
            })
        };
        let first = [bits.to_string(), count.to_string()];
        page.row(first.into_iter().chain(names.iter().map(cell)));
    }
    let failures: Vec<String> = sorts
        .rows
        .iter()
        .filter_map(|row| row.failed.clone())
        .collect();
    if !failures.is_empty() {
        page.paragraph(&format!("Wrong: {}.", some(&failures)));
    }
}

fn training_section(page: &mut Page, training: &TrainingReport) {
    page.heading("Training");
    let [width, height] = training.size;
    page.paragraph(&format!(
        "{} Gaussians with all basis rows, {} views of {width} × {height} a step, ST-LPIPS (alex) on \
         windows of {} px, by what works it out; {:.0} MB.",
        training.gaussians,
        training.views,
        training.window,
        training.memory_bytes as f64 / 1e6
    ));
    page.table(&["perceptual loss", "ms a step", "steps a second", ""]);
    for row in &training.rows {
        page.row([
            row.loss.clone(),
            figure(row.ms),
            figure(row.steps_a_second),
            if row.is_chosen { "chosen" } else { "" }.to_owned(),
        ]);
    }
}

fn rate_section(page: &mut Page, rates: &RatesReport) {
    page.heading("Copies and fill rates");
    page.paragraph(
        "A copy waits for the one before; bytes count when read and when written. The smallest \
         copy's time is that of a dispatch.",
    );
    page.table(&["bytes", "by", "µs", "GB/s", ""]);
    for copy in &rates.copies {
        page.row([
            copy.bytes.to_string(),
            copy.method.clone(),
            figure(copy.us),
            figure(copy.bytes_a_second / 1e9),
            if copy.right { "" } else { "**wrong**" }.to_owned(),
        ]);
    }
    let [width, height] = rates.fill_size;
    page.paragraph(&format!(
        "Layers over {width} × {height} px. Opaque ones are tested against the depth, which rejects \
         all but the first front to back."
    ));
    page.table(&["layers", "µs", "Gpix/s"]);
    for fill in &rates.fills {
        page.row([
            fill.title(),
            figure(fill.us),
            figure(fill.fragments_a_second / 1e9),
        ]);
    }
}

fn frame_section(page: &mut Page, benches: &[NamedBench]) {
    page.heading("Frames");
    if let Some(NamedBench { report, .. }) = benches.first() {
        let avatar = match report.avatar.name.as_str() {
            "" => "An avatar without its name",
            name => name,
        };
        page.paragraph(&format!(
            "{avatar}, {} Gaussians, {} × {} px. Medians; errors over covered pixels against the f64 \
             reference, the worst of the frames compared.",
            report.avatar.gaussians, report.size[0], report.size[1]
        ));
    }
    page.table(&[
        "measured",
        "case",
        "frame ms",
        "GPU ms",
        "PSNR dB",
        "worst error",
        "fragments a pixel",
        "device MB",
    ]);
    for NamedBench { name, report } in benches {
        for case in &report.cases {
            page.row(case_row(name, case));
        }
    }
    for NamedBench { name, report } in benches {
        if let Some(sweep) = &report.sweep {
            sweep_table(page, name, sweep);
        }
    }
}

fn case_row(name: &str, case: &CaseReport) -> [String; 8] {
    let bytes = case.gpu_memory_used_bytes.map(|bytes| bytes as f64 / 1e6);
    [
        name.to_owned(),
        case.name.clone(),
        figure(case.frame_ms.median),
        known(case.gpu_ms.map(|ms| ms.median)),
        case.error.as_ref().map_or("–".to_owned(), decibels),
        known(case.error.as_ref().map(|error| error.max_error)),
        known(case.fragments_a_pixel),
        known(bytes),
    ]
}

fn sweep_table(page: &mut Page, name: &str, sweep: &SweepReport) {
    page.paragraph(&format!("{name}, case {}:", sweep.case));
    page.table(&[
        "parameter",
        "value",
        "frame ms",
        "GPU ms",
        "PSNR dB",
        "worst error",
    ]);
    for point in &sweep.points {
        page.row([
            point.parameter.clone(),
            point.value.clone(),
            figure(point.frame_ms),
            known(point.gpu_ms),
            decibels(&point.error),
            figure(point.error.max_error),
        ]);
    }
    for failed in &sweep.failed {
        page.paragraph(&format!("Not drawn: {failed}."));
    }
}

fn traffic_section(page: &mut Page, traffic: &[StageTraffic]) {
    let stages: Vec<_> = traffic
        .iter()
        .filter(|row| row.case == STAGE_CASE)
        .collect();
    if stages.is_empty() {
        return;
    }
    page.heading("Stages against copies");
    page.paragraph(
        "Bytes are computed, not measured. The last two columns compare them with a copy of much \
         memory, and with one of as many bytes, which may lie in caches.",
    );
    page.table(&[
        "measured",
        "stage",
        "ms",
        "MB",
        "GB/s",
        "of memory",
        "of that size",
    ]);
    let share =
        |share: Option<f64>| share.map_or("–".to_owned(), |s| format!("{:.0} %", 100.0 * s));
    for row in stages {
        page.row([
            row.measurement.clone(),
            row.stage.clone(),
            figure(row.ms),
            figure(row.bytes as f64 / 1e6),
            figure(row.bytes_a_second / 1e9),
            share(row.of_memory),
            share(row.of_same_size),
        ]);
    }
}

fn soak_section(page: &mut Page, soak: &SoakReport) {
    page.heading("Soak");
    page.paragraph(&format!(
        "{:.0} s of {:.0}, {} × {} px: {:.1} frames a second of {} promised, {} late, {:.2} % of \
         the refreshes without a new frame, {} changes of quality.",
        soak.lasted_seconds,
        soak.planned_seconds,
        soak.size[0],
        soak.size[1],
        soak.fps,
        soak.rate,
        soak.late,
        100.0 * soak.dropped_share,
        soak.changes
    ));
    let heat = [
        soak.highest(|second| second.headroom),
        soak.highest(|second| second.celsius),
    ];
    if heat.iter().any(Option::is_some) {
        let [headroom, celsius] = heat.map(known);
        page.paragraph(&format!(
            "At most {headroom} of the heat at which it throttles, and {celsius} °C."
        ));
    }
    if let Some(drift) = &soak.drift {
        let same = if drift.same {
            "the same image to the bit"
        } else {
            "another image"
        };
        page.paragraph(&format!(
            "Against the reference {} dB before and {} dB after, {same}.",
            decibels(&drift.before),
            decibels(&drift.after)
        ));
    }
    if !soak.faults.is_empty() {
        page.paragraph(&format!("Faults: {}.", soak.faults.join("; ")));
    }
}

fn decibels(error: &ErrorReport) -> String {
    match error.psnr_db {
        Some(db) => format!("{db:.2}"),
        None if error.frames > 0 => "no error".to_owned(),
        None => "–".to_owned(),
    }
}

fn known(number: Option<f64>) -> String {
    number.map_or("–".to_owned(), figure)
}

/// A number with three digits that count.
fn figure(number: f64) -> String {
    let size = number.abs();
    let digits = match size {
        _ if size >= 100.0 || size == 0.0 => 0,
        _ if size >= 10.0 => 1,
        _ if size >= 1.0 => 2,
        _ if size >= 0.1 => 3,
        _ => 4,
    };
    format!("{number:.digits$}")
}

/// Markdown as it grows.
#[derive(Default)]
struct Page {
    text: String,
}

impl Page {
    fn line(&mut self, line: &str) {
        self.text += line;
        self.text.push('\n');
    }

    fn heading(&mut self, heading: &str) {
        self.line(&format!("\n## {heading}"));
    }

    fn paragraph(&mut self, text: &str) {
        self.line(&format!("\n{text}"));
    }

    fn code(&mut self, language: &str, text: &str) {
        self.line(&format!("\n```{language}\n{text}\n```"));
    }

    /// Begins a table.
    fn table(&mut self, head: &[&str]) {
        let rule = vec!["---"; head.len()].join("|");
        self.line(&format!("\n| {} |\n|{rule}|", head.join(" | ")));
    }

    fn row(&mut self, cells: impl IntoIterator<Item = String>) {
        let cells: Vec<String> = cells
            .into_iter()
            .map(|cell| cell.replace('|', "\\|").replace('\n', " "))
            .collect();
        self.line(&format!("| {} |", cells.join(" | ")));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_have_three_digits() {
        assert_eq!(
            [1234.5, 12.345, 1.2345, 0.12345, 0.0].map(figure),
            ["1234", "12.3", "1.23", "0.123", "0"]
        );
    }

    #[test]
    fn cells_stay_in_their_cells() {
        let mut page = Page::default();
        page.table(&["a", "b"]);
        page.row(["x|y".to_owned(), "one\ntwo".to_owned()]);
        assert_eq!(page.text, "\n| a | b |\n|---|---|\n| x\\|y | one two |\n");
    }
}
