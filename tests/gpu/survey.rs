//! A survey measures what it plans, and ends where nobody hears of it.

use crate::common::{self, Sizes, gpu};
use effigy_core::{avatar::motion::Player, frame::RasterMethod};
use effigy_measure::{
    report::DeviceReport,
    steps::StepOutcome::{NotRun, Passed},
    survey::{SurveyReport, SurveyTask, measure},
};

tests! {
    all_but_the_soak_is_measured_and_named_by_nothing_of_the_user,
    a_survey_that_nobody_hears_of_ends,
}

/// A short survey that goes on for as long as `tell` says.
fn survey(tell: &mut dyn FnMut(&SurveyReport, &str) -> bool) -> SurveyReport {
    let gpu = gpu::drawing();
    let mut avatar = common::avatar(1, Sizes::default());
    avatar.name = "Alice".into();
    let mut clip = common::clip(1, &avatar, 30);
    clip.name = "Alice waves".into();
    let player = Player::new(clip, &avatar.skeleton);
    let task = SurveyTask {
        avatar: &avatar,
        player: &player,
        size: [96, 128],
        share: 0.02,
    };
    let mut report = SurveyReport::new("a system".into(), DeviceReport::from_vulkan(&gpu));
    measure(&gpu, &task, &mut report, tell);
    report
}

fn all_but_the_soak_is_measured_and_named_by_nothing_of_the_user() {
    let mut told = Vec::new();
    let report = survey(&mut |_, what| {
        told.push(what.to_owned());
        true
    });
    let outcomes: Vec<_> = report.steps.iter().map(|step| step.outcome).collect();
    assert_eq!(outcomes, [Passed, Passed, Passed, NotRun], "{report:?}");
    assert!(!report.sorts.is_empty() && told.len() > 20, "{told:?}");
    let rates = report.rates.as_ref().unwrap();
    assert!(rates.memory_bandwidth() > Some(1e6) && !rates.fills.is_empty());
    // SwiftShader has no way but quads.
    let drawn = report.frames.iter();
    let drawn: Vec<_> = drawn.map(|bench| bench.options.raster.as_str()).collect();
    assert!(drawn.contains(&RasterMethod::Quads.name()), "{drawn:?}");
    for bench in &report.frames {
        let names: Vec<_> = bench.cases.iter().map(|case| case.name.as_str()).collect();
        assert_eq!(names, ["full", "camera"]);
        for case in &bench.cases {
            let error = case.error.unwrap();
            assert!(
                error.psnr_db > Some(40.0),
                "{}: {error:?}",
                bench.options.raster
            );
            assert!(case.frame_ms.median > 0.0 && case.gpu_memory_used_bytes > Some(0));
        }
    }
    let text = report.json();
    assert!(!text.contains("Alice"), "{text}");
    assert!(
        !text.contains(std::env::args().next().unwrap().as_str()),
        "{text}"
    );
    assert_eq!(report.program.date.len(), 10);
    // An intent that is shared holds half a megabyte.
    assert!(text.len() < 50_000, "{} bytes", text.len());
    assert_eq!(SurveyReport::read(&text).unwrap(), report);
}

fn a_survey_that_nobody_hears_of_ends() {
    let mut calls = 0;
    let report = survey(&mut |_, _| {
        calls += 1;
        calls < 4
    });
    assert_eq!(calls, 4);
    assert!(report.steps.iter().all(|step| step.outcome == NotRun));
    assert!(report.rates.is_some_and(|rates| rates.fills.is_empty()));
}
