//! A survey in plain words, for whoever measured.

use super::SurveyReport;
use crate::{
    bench::{
        BenchCase,
        report::{BenchReport, CaseReport},
    },
    soak::SoakReport,
    steps::StepOutcome,
};
use effigy_render::vulkan::{raster::ColorFormat, trial::TrialOutcome};

impl SurveyReport {
    /// The figures that matter, a sentence each, with what is missing first.
    pub fn words(&self) -> Vec<String> {
        let mut words = Vec::new();
        if self.over && !self.is_complete() {
            words.push("This survey is incomplete.".to_owned());
            let steps = self.steps.iter();
            for step in steps.filter(|step| step.outcome != StepOutcome::Passed) {
                words.push(format!("{}: {}", step.name, step.note));
            }
        }
        if let Some(rates) = &self.rates {
            if let Some(bytes) = rates.memory_bandwidth() {
                let giga = bytes / 1e9;
                words.push(format!("Memory moves {giga:.1} GB a second."));
            }
            let blended = ColorFormat::Rgba16F.name();
            let mut fills = rates.fills.iter();
            if let Some(fill) =
                fills.find(|fill| fill.color == blended && fill.shape == "gaussians")
            {
                let giga = fill.fragments_a_second / 1e9;
                words.push(format!(
                    "Gaussians are blended at {giga:.2} billion pixels a second."
                ));
            }
        }
        for sort in &self.sorts {
            let name = sort.variant.name();
            words.push(match &sort.outcome {
                TrialOutcome::Right(ms) => format!("The sort {name} is right, in {ms:.2} ms."),
                other => format!("The sort {name}: {other}."),
            });
        }
        for report in &self.frames {
            words.extend(report.cases.iter().map(|case| frame(report, case)));
        }
        words.extend(self.soak.iter().map(soak));
        words
    }
}

fn frame(report: &BenchReport, case: &CaseReport) -> String {
    let time = match &case.gpu_ms {
        Some(gpu) => format!("{:.2} ms of GPU time", gpu.median),
        None => format!("{:.2} ms", case.frame_ms.median),
    };
    let error = match case.error.as_ref().map(|error| error.psnr_db) {
        Some(Some(db)) => format!(", {db:.1} dB from the reference"),
        Some(None) => ", no error".to_owned(),
        None => String::new(),
    };
    let moves = if case.name == BenchCase::Camera.name() {
        "only the camera moves"
    } else {
        "all moves"
    };
    let memory = case.gpu_memory_used_bytes.unwrap_or_default() as f64 / 1e6;
    format!(
        "{}, {moves}: {time} a frame of {} × {} px{error}, {memory:.0} MB.",
        report.options.raster, report.size[0], report.size[1],
    )
}

fn soak(soak: &SoakReport) -> String {
    let mut heat = String::new();
    if let Some(headroom) = soak.highest(|second| second.headroom) {
        heat += &format!(
            ", up to {:.0} % of the heat at which it throttles",
            100.0 * headroom
        );
    }
    if let Some(celsius) = soak.highest(|second| second.celsius) {
        heat += &format!(", up to {celsius:.0} °C");
    }
    format!(
        "In motion for {:.0} s: {:.1} frames a second of {:.0}, {} changes of quality{heat}.",
        soak.lasted_seconds, soak.fps, soak.rate, soak.changes
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        report::tests::{MEASURED, part},
        soak::faults::tests::report,
        steps::StepOutcome,
    };

    fn survey() -> SurveyReport {
        SurveyReport::new("a phone".into(), part("device"))
    }

    #[test]
    fn what_is_missing_comes_first_and_why() {
        let mut survey = survey();
        assert!(survey.words().is_empty(), "it goes on");
        survey.end_step(
            "rates",
            StepOutcome::TimedOut,
            60.0,
            "the rest was left out".into(),
        );
        survey.explain("the window was left");
        survey.over = true;
        let expected = [
            "This survey is incomplete.",
            "rates: the rest was left out",
            "sorts: the window was left",
            "frames: the window was left",
            "soak: the window was left",
        ];
        assert_eq!(survey.words(), expected);
    }

    #[test]
    fn a_complete_survey_has_its_figures_in_words() {
        let mut survey = survey();
        for name in ["rates", "sorts", "frames"] {
            survey.end_step(name, StepOutcome::Passed, 1.0, String::new());
        }
        survey.frames = vec![BenchReport::read(MEASURED).expect("a report")];
        let mut soak = report();
        soak.planned_seconds = soak.lasted_seconds;
        soak.avatar.name = "Alice".into();
        for second in &mut soak.each {
            second.headroom = Some(0.62);
            second.celsius = Some(38.4);
        }
        survey.add_soak(soak);
        survey.over = true;
        assert!(survey.is_complete());
        assert!(!survey.json().contains("Alice"));
        let words = survey.words().join("\n");
        for part in [
            "all moves: ",
            " dB from the reference",
            "up to 62 % of the heat",
            "up to 38 °C",
        ] {
            assert!(words.contains(part), "{words}");
        }
    }

    #[test]
    fn a_soak_that_ends_early_does_not_pass() {
        let mut survey = survey();
        let mut soak = report();
        soak.planned_seconds = soak.lasted_seconds + 1.0;
        survey.add_soak(soak);
        survey.explain("it was stopped");
        let step = survey.steps.last().expect("four steps");
        assert_eq!(step.outcome, StepOutcome::NotRun);
        assert_eq!(step.note, "it was stopped");
        assert!(survey.soak.is_some());
    }
}
