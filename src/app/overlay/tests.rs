//! Runs the panel headless.

use super::*;
use crate::app::playback::Track;

#[test]
fn numbers_are_grouped_by_three_digits() {
    for (number, expected) in [(0, "0"), (999, "999"), (1000, "1 000"), (2_000_000, "2 000 000")] {
        assert_eq!(grouped(number), expected);
    }
}

/// Runs the panel headless, clicking at each place of a grid, and gathers what it asks for.
#[test]
fn every_control_of_the_panel_asks_for_something() {
    let ctx = egui::Context::default();
    style(&ctx);
    let track = |name: &str| Track { name: name.into(), duration: 2.0, rate: 30.0 };
    let mut playback = Playback::new(vec![track("walk"), track("run")]);
    playback.play(true, 0.0);
    let facts = Facts {
        avatar: "someone",
        times: &FrameTimes::default(),
        moving: true,
        stages: &[("features", 0.5), ("sort", 1.0)],
        gaussians: (1234, 200_000),
        skipped: &["features"],
        device: "a device",
        driver: "a driver",
        memory: 12_000_000,
        playback: &playback,
        shelf: &Shelf::new(vec!["someone".into(), "else".into()], 0, |_| anyhow::bail!("never asked for")),
        background: [0.5; 3],
        follow: true,
        message: Some("saved"),
        report: true,
        capture: true,
    };
    let mut wishes = Vec::new();
    let mut pass = |events: Vec<egui::Event>| {
        let screen_rect = Some(egui::Rect::from_min_size(Pos2::ZERO, vec2(1280.0, 900.0)));
        let output = ctx.run_ui(egui::RawInput { screen_rect, events, ..Default::default() }, |ui| show(ui.ctx(), &facts, &mut wishes));
        output.drop_without_applying_deltas();
    };
    for (row, column) in (5..42).flat_map(|row| (2..45).map(move |column| (row, column))) {
        let pos = Pos2::new(6.0 * column as f32, 6.0 * row as f32);
        pass(vec![egui::Event::PointerMoved(pos)]);
        for pressed in [true, false] {
            let modifiers = egui::Modifiers::NONE;
            pass(vec![egui::Event::PointerButton { pos, button: egui::PointerButton::Primary, pressed, modifiers }]);
        }
    }
    let wants = |wanted: fn(&Action) -> bool| wishes.iter().any(wanted);
    assert!(wants(|w| matches!(w, Action::PlayOrPause)), "play");
    assert!(wants(|w| matches!(w, Action::Seek(_))), "seek");
    assert!(wants(|w| matches!(w, Action::Next(1))) && wants(|w| matches!(w, Action::Next(-1))), "next");
    assert!(wants(|w| matches!(w, Action::Repeat(Repeat::All))), "repeat");
    assert!(wants(|w| matches!(w, Action::ResetView)), "reset");
    assert!(wants(|w| matches!(w, Action::FullScreen)), "full screen");
    assert!(wants(|w| matches!(w, Action::Screenshot)), "screenshot");
    assert!(wants(|w| matches!(w, Action::Share)), "share");
    assert!(wants(|w| matches!(w, Action::Capture)), "capture");
    assert!(wants(|w| matches!(w, Action::Follow(false))), "follow");
}
