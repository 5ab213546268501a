//! The self-test and the file that remembers its choice.

use super::*;
use effigy_render::vulkan::{
    sort::choice::{choose_in, test},
    trial::{SortChoice, TrialOutcome, Tried},
};
use std::{fs, path::PathBuf};

fn file(folder: &tempfile::TempDir) -> PathBuf {
    let mut files: Vec<_> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .collect();
    assert_eq!(files.len(), 1, "one file: {files:?}");
    files.remove(0)
}

fn outcome(choice: &SortChoice, variant: SortVariant) -> &TrialOutcome {
    Tried::outcome_of(&choice.tried, variant).unwrap()
}

fn the_self_test_picks_a_variant_that_is_right_and_remembers_it() {
    let device = gpu::gpu();
    let folder = tempfile::tempdir().unwrap();
    let choice = choose_in(&device, Some(folder.path())).unwrap();
    println!("{choice:?}");
    assert!(matches!(
        outcome(&choice, choice.variant),
        TrialOutcome::Right(_)
    ));
    assert!(
        matches!(
            outcome(&choice, SortVariant::ReduceThenScan),
            TrialOutcome::Right(_)
        ),
        "reduce-then-scan is right everywhere"
    );
    let text = fs::read_to_string(file(&folder)).unwrap();
    assert_eq!(
        choose_in(&device, Some(folder.path())).unwrap(),
        choice,
        "the second time it is read, times included"
    );
    assert_eq!(fs::read_to_string(file(&folder)).unwrap(), text);
}

fn look_back_is_tested_and_refused_where_it_is_wrong() {
    let device = gpu::gpu();
    if compiles_slowly(&device) {
        not_run("OneSweep takes this device half a minute to compile");
    }
    let outcome = test(&device, SortVariant::OneSweep).unwrap();
    println!("{outcome}");
    match effigy_render::vulkan::sort::unsupported(SortVariant::OneSweep, &device) {
        Some(_) => assert!(matches!(outcome, TrialOutcome::Unsupported(_))),
        None if looks_back(&device) => {
            assert!(matches!(outcome, TrialOutcome::Right(_)), "{outcome}")
        }
        // Wrong or right by chance: what matters is that the test ends with an answer.
        None => assert!(
            matches!(outcome, TrialOutcome::Right(_) | TrialOutcome::Refused(_)),
            "{outcome}"
        ),
    }
}

fn a_damaged_or_old_file_is_ignored_and_written_again() {
    let device = gpu::gpu();
    let folder = tempfile::tempdir().unwrap();
    choose_in(&device, Some(folder.path())).unwrap();
    let path = file(&folder);
    let text = fs::read_to_string(&path).unwrap();
    let damaged = [
        text[..text.len() / 2].to_string(),
        String::new(),
        text.replace("driver_version\": ", "driver_version\": 1"),
    ];
    for text in damaged {
        fs::write(&path, &text).unwrap();
        choose_in(&device, Some(folder.path())).unwrap();
        assert_ne!(
            fs::read_to_string(&path).unwrap(),
            text,
            "not written again"
        );
        assert!(
            serde_json::from_str::<serde_json::Value>(&fs::read_to_string(&path).unwrap()).is_ok()
        );
    }
}

fn a_variant_that_ended_the_program_twice_is_not_tried_again() {
    let device = gpu::gpu();
    let folder = tempfile::tempdir().unwrap();
    choose_in(&device, Some(folder.path())).unwrap();
    let path = file(&folder);
    let mut content: serde_json::Value =
        serde_json::from_str(&fs::read_to_string(&path).unwrap()).unwrap();
    // As it would be had the program ended in the first test.
    content["tried"] = serde_json::json!([]);
    content["trying"] = serde_json::json!(["ReduceThenScan", 1]);
    fs::write(&path, content.to_string()).unwrap();
    let again = choose_in(&device, Some(folder.path())).unwrap();
    assert_ne!(
        *outcome(&again, SortVariant::ReduceThenScan),
        TrialOutcome::Unfinished,
        "the user may have ended it"
    );
    content["trying"] = serde_json::json!(["ReduceThenScan", 2]);
    fs::write(&path, content.to_string()).unwrap();
    let choice = choose_in(&device, Some(folder.path())).unwrap();
    assert_eq!(
        *outcome(&choice, SortVariant::ReduceThenScan),
        TrialOutcome::Unfinished
    );
    assert_ne!(choice.variant, SortVariant::ReduceThenScan);
    assert_eq!(
        choose_in(&device, Some(folder.path())).unwrap(),
        choice,
        "and it stays so"
    );
}

/// Who kills the program during each trial, twice, must not have killed it for good.
fn a_program_that_was_killed_in_every_trial_sorts_all_the_same() {
    let device = gpu::gpu();
    let folder = tempfile::tempdir().unwrap();
    let choice = choose_in(&device, Some(folder.path())).unwrap();
    let path = file(&folder);
    let mut content: serde_json::Value =
        serde_json::from_str(&fs::read_to_string(&path).unwrap()).unwrap();
    let unfinished = |tried: &Tried<SortVariant>| serde_json::json!([tried.variant, "Unfinished"]);
    content["tried"] = choice.tried.iter().map(unfinished).collect();
    fs::write(&path, content.to_string()).unwrap();
    let again = choose_in(&device, Some(folder.path())).unwrap();
    assert_eq!(again.variant, choice.tried[0].variant, "the safest");
    assert!(
        again
            .tried
            .iter()
            .all(|tried| tried.outcome == TrialOutcome::Unfinished)
    );
}

fn the_fastest_right_variant_wins() {
    let tried = |times: [Option<f64>; 3]| {
        let outcome =
            |ms: Option<f64>| ms.map_or(TrialOutcome::Refused("wrong".into()), TrialOutcome::Right);
        SortVariant::ALL
            .into_iter()
            .zip(times.map(outcome))
            .map(Tried::from)
            .collect::<Vec<_>>()
    };
    let pick = |times| SortChoice::fastest(&tried(times)).map(|choice| choice.variant);
    assert_eq!(
        pick([Some(1.0), Some(2.0), Some(3.0)]),
        Some(SortVariant::OneSweep)
    );
    assert_eq!(
        pick([None, Some(2.0), Some(3.0)]),
        Some(SortVariant::ReduceThenScan)
    );
    assert_eq!(
        pick([None, Some(2.0), Some(0.5)]),
        Some(SortVariant::PerThread)
    );
    assert_eq!(pick([None; 3]), None);
}

tests! {
    the_self_test_picks_a_variant_that_is_right_and_remembers_it,
    look_back_is_tested_and_refused_where_it_is_wrong,
    a_damaged_or_old_file_is_ignored_and_written_again,
    a_variant_that_ended_the_program_twice_is_not_tried_again,
    a_program_that_was_killed_in_every_trial_sorts_all_the_same,
    the_fastest_right_variant_wins: no_device,
}
