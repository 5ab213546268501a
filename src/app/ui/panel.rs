//! The panel's contents: facts about the frames go in, egui widgets and the user's actions come
//! out.

use crate::{
    action::{Action, KEYS, POINTERS},
    file_list::FileList,
    frame_times::FrameTimes,
    playback::{Playback, Repeat, SPEED},
    ui::icons::{self, Icon},
};
use effigy_core::frame::report::{STAGES, stage_ms};
use effigy_render::quirks::{OLD_LAVAPIPE, leaves_loops};
use egui::{Align, Align2, Color32, Grid, Layout, Pos2, RichText, Sense, Slider, Stroke, Ui, vec2};

/// Width of the panel, points.
const WIDTH: f32 = 264.0;
/// Colour of the bars in graph and table.
const BAR: Color32 = Color32::from_rgb(110, 180, 220);
/// Height of the graph, points.
const GRAPH: f32 = 36.0;

/// The facts that the panel shows.
pub struct PanelFacts<'a> {
    /// The avatar's name.
    pub avatar: &'a str,
    /// How long the last frames took.
    pub times: &'a FrameTimes,
    /// Frames are drawn continuously, because something moves.
    pub moving: bool,
    /// Name and GPU time, ms, of each stage of the last frame that drew the avatar.
    pub stages: &'a [(&'static str, f64)],
    /// Gaussians that the last frame drew.
    pub drawn_gaussians: u64,
    /// Samples a pixel along each axis.
    pub samples: u64,
    /// The avatar's level that is drawn; 0 is the avatar itself.
    pub level: u64,
    /// Gaussians of the avatar.
    pub gaussians: usize,
    /// Stages that the last frame skipped, because their inputs had not changed.
    pub skipped: &'a [&'static str],
    /// The device's name.
    pub device: &'a str,
    /// The driver's name and version.
    pub driver: &'a str,
    /// What frames are drawn with, and why.
    pub drawing: &'a str,
    /// Bytes of GPU memory in use.
    pub memory: u64,
    /// Which clip plays, and how.
    pub playback: &'a Playback,
    /// Avatars to choose from.
    pub file_list: &'a FileList,
    /// The device can be surveyed: the avatar has a clip, and nobody else needs the device.
    pub can_survey: bool,
    /// It is being surveyed.
    pub is_surveying: bool,
    /// What the survey does or found; empty if there was none.
    pub survey: &'a [String],
    /// There is a crash report to share.
    pub has_crash_report: bool,
    /// RenderDoc is attached.
    pub has_renderdoc: bool,
    /// Display-referred RGB, 0 to 1.
    pub background: [f32; 3],
    /// The view moves with the avatar.
    pub follow: bool,
    /// The last message: where a screenshot was saved, for example.
    pub message: Option<&'a str>,
}

/// Sets small text on a dark, translucent panel.
pub fn style(ctx: &egui::Context) {
    ctx.set_fonts(icons::fonts());
    ctx.set_theme(egui::Theme::Dark);
    ctx.all_styles_mut(|style| {
        style.spacing.item_spacing = vec2(6.0, 4.0);
        style.spacing.slider_width = 132.0;
        style.visuals.window_fill = Color32::from_gray(24);
        style.visuals.window_stroke = Stroke::new(1.0, Color32::from_white_alpha(24));
        style.visuals.window_shadow = egui::Shadow::NONE;
        style.visuals.override_text_color = Some(Color32::from_gray(225));
        for font in style.text_styles.values_mut() {
            font.size = (font.size * 0.92).round();
        }
        // Labels that can be selected would take the keyboard focus from the viewer.
        style.interaction.selectable_labels = false;
    });
}

/// Lays the panel out. The user's actions are added to `actions`.
pub fn show(ctx: &egui::Context, facts: &PanelFacts, actions: &mut Vec<Action>) {
    // Without the title bar and the window's edges.
    let height = (ctx.content_rect().height() - 72.0).max(40.0);
    let frame = egui::Frame::window(&ctx.global_style()).fill(Color32::from_black_alpha(205));
    let is_wide = ctx.content_rect().width() > 2.5 * WIDTH;
    egui::Window::new("Effigy")
        .default_pos(Pos2::new(12.0, 12.0))
        .default_open(is_wide || facts.message.is_some())
        .auto_sized()
        .frame(frame)
        .show(ctx, |ui| {
            egui::ScrollArea::vertical()
                .max_height(height)
                // Else it keeps the height of the smallest window that it was shown in.
                .min_scrolled_height(height)
                .show(ui, |ui| {
                    ui.set_width(WIDTH);
                    if facts.has_crash_report {
                        button(
                            ui,
                            "Share the crash",
                            "send the crash report to another app",
                            Action::Share,
                            actions,
                        );
                    }
                    avatar_list(ui, facts.file_list, actions);
                    clip_controls(ui, facts.playback, actions);
                    ui.separator();
                    view_controls(ui, facts, actions);
                    survey(ui, facts, actions);
                    ui.separator();
                    timing(ui, facts);
                    egui::CollapsingHeader::new("Stages")
                        .default_open(true)
                        .show(ui, |ui| stages(ui, facts));
                    egui::CollapsingHeader::new("Device")
                        .default_open(true)
                        .show(ui, |ui| device(ui, facts));
                    if let Some(message) = facts.message {
                        ui.separator();
                        ui.label(message);
                    }
                });
        });
}

/// Lays out the list of keys and gestures.
pub fn show_keys(ctx: &egui::Context) {
    egui::Window::new("Keys")
        .anchor(Align2::CENTER_CENTER, [0.0, 0.0])
        .collapsible(false)
        .resizable(false)
        .show(ctx, |ui| {
            let height = (ctx.content_rect().height() - 72.0).max(40.0);
            egui::ScrollArea::vertical()
                .max_height(height)
                .min_scrolled_height(height)
                .show(ui, keys);
        });
}

fn avatar_list(ui: &mut Ui, files: &FileList, actions: &mut Vec<Action>) {
    if files.names().len() < 2 {
        return;
    }
    let shown = files.names().nth(files.shown).unwrap_or_default();
    egui::ComboBox::from_id_salt("avatar")
        .selected_text(shown)
        .width(ui.available_width())
        .show_ui(ui, |ui| {
            for (index, name) in files.names().enumerate() {
                if ui.selectable_label(index == files.shown, name).clicked() {
                    actions.push(Action::Avatar(index));
                }
            }
        });
}

fn clip_controls(ui: &mut Ui, playback: &Playback, actions: &mut Vec<Action>) {
    let position = playback.position();
    let Some(track) = playback.tracks().get(position.clip) else {
        return;
    };
    if playback.tracks().len() > 1 {
        ui.horizontal(|ui| {
            icon_button(
                ui,
                Icon::Previous,
                "previous clip (P)",
                Action::Next(-1),
                actions,
            );
            icon_button(ui, Icon::Next, "next clip (N)", Action::Next(1), actions);
            egui::ComboBox::from_id_salt("clip")
                .selected_text(&track.name)
                .width(ui.available_width())
                .show_ui(ui, |ui| {
                    for (index, track) in playback.tracks().iter().enumerate() {
                        if ui
                            .selectable_label(index == position.clip, &track.name)
                            .clicked()
                        {
                            actions.push(Action::Choose(index));
                        }
                    }
                });
        });
    } else {
        ui.strong(&track.name);
    }
    ui.horizontal(|ui| {
        let icon = if playback.is_playing() {
            Icon::Pause
        } else {
            Icon::Play
        };
        icon_button(
            ui,
            icon,
            "play or pause (Space)",
            Action::PlayOrPause,
            actions,
        );
        let mut time = position.time;
        ui.spacing_mut().slider_width = ui.available_width() - 92.0;
        let slider = Slider::new(&mut time, 0.0..=track.duration.max(1e-6)).show_value(false);
        if ui.add_enabled(track.duration > 0.0, slider).changed() {
            actions.push(Action::Seek(time));
        }
        ui.monospace(format!("{:5.2} / {:.2} s", position.time, track.duration));
    });
    ui.horizontal(|ui| {
        for (repeat, name) in [
            (Repeat::Off, "once"),
            (Repeat::Clip, "loop"),
            (Repeat::All, "all clips"),
        ] {
            if ui
                .selectable_label(playback.repeat() == repeat, name)
                .clicked()
            {
                actions.push(Action::Repeat(repeat));
            }
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let mut speed = playback.speed();
            let drag = egui::DragValue::new(&mut speed)
                .range(SPEED[0]..=SPEED[1])
                .speed(0.01)
                .fixed_decimals(2)
                .suffix("×");
            if ui.add(drag).on_hover_text("speed").changed() {
                actions.push(Action::Speed(speed));
            }
        });
    });
}

fn button(ui: &mut Ui, text: &str, hint: &str, action: Action, actions: &mut Vec<Action>) {
    if ui.button(text).on_hover_text(hint).clicked() {
        actions.push(action);
    }
}

fn icon_button(ui: &mut Ui, icon: Icon, hint: &str, action: Action, actions: &mut Vec<Action>) {
    if icons::button(ui, icon).on_hover_text(hint).clicked() {
        actions.push(action);
    }
}

fn view_controls(ui: &mut Ui, facts: &PanelFacts, actions: &mut Vec<Action>) {
    ui.horizontal(|ui| {
        button(
            ui,
            "Reset view",
            "frame the avatar (R)",
            Action::ResetView,
            actions,
        );
        if cfg!(not(target_os = "android")) {
            button(ui, "Full screen", "F or F11", Action::FullScreen, actions);
        }
        button(
            ui,
            "Screenshot",
            "a PNG without this panel (S)",
            Action::Screenshot,
            actions,
        );
    });
    if facts.has_renderdoc {
        button(
            ui,
            "Capture a frame",
            "with RenderDoc, which is attached (C)",
            Action::Capture,
            actions,
        );
    }
    ui.horizontal(|ui| {
        let mut background = facts
            .background
            .map(|channel| (255.0 * channel).round() as u8);
        if ui
            .color_edit_button_srgb(&mut background)
            .on_hover_text("background (B for the next)")
            .changed()
        {
            actions.push(Action::Background(
                background.map(|channel| f32::from(channel) / 255.0),
            ));
        }
        ui.label("background");
        button(
            ui,
            "Keys",
            "all keys and gestures (?)",
            Action::Keys,
            actions,
        );
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let mut follow = facts.follow;
            if ui
                .checkbox(&mut follow, "follow")
                .on_hover_text("the view moves with the avatar")
                .changed()
            {
                actions.push(Action::Follow(follow));
            }
        });
    });
}

/// The survey's button, what it does or found, and the way to share that.
fn survey(ui: &mut Ui, facts: &PanelFacts, actions: &mut Vec<Action>) {
    let text = match facts.is_surveying {
        true => "Stop measuring",
        false if cfg!(target_os = "android") => "Measure this phone",
        false => "Measure this device",
    };
    if facts.can_survey {
        let hint =
            "three minutes, best left alone: then figures, and a file without anything personal";
        button(ui, text, hint, Action::Survey, actions);
    }
    for line in facts.survey {
        ui.label(line);
    }
    let has_result = !facts.survey.is_empty() && !facts.is_surveying;
    if has_result && cfg!(target_os = "android") {
        let hint = "send the file as text to another app";
        button(
            ui,
            "Share the measurement",
            hint,
            Action::ShareSurvey,
            actions,
        );
    }
}

fn timing(ui: &mut Ui, facts: &PanelFacts) {
    ui.horizontal(|ui| {
        match facts.times.mean_ms().filter(|_| facts.moving) {
            Some(ms) => {
                ui.label(RichText::new(rate_text(ms)).strong());
                ui.monospace(format!("{ms:.2} ms"));
            }
            None => {
                ui.label("idle: nothing is drawn");
            }
        }
        if !facts.stages.is_empty() {
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                ui.monospace(format!(
                    "GPU {:.2} ms",
                    facts.stages.iter().map(|stage| stage.1).sum::<f64>()
                ));
            });
        }
    });
    graph(ui, facts.times);
}

/// One bar a frame, up to twice the mean. Bars of slow frames have another colour.
fn graph(ui: &mut Ui, times: &FrameTimes) {
    let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), GRAPH), Sense::hover());
    let painter = ui.painter_at(rect);
    painter.rect_filled(rect, 2.0, Color32::from_white_alpha(10));
    let mean = times.history_ms().sum::<f32>() / times.history_ms().len().max(1) as f32;
    let step = rect.width() / 120.0;
    for (bar, ms) in times.history_ms().rev().enumerate() {
        let part = ms / (2.0 * mean).max(1e-3);
        let color = if part > 0.75 {
            Color32::from_rgb(230, 150, 70)
        } else {
            BAR
        };
        let x = rect.right() - (bar as f32 + 0.5) * step;
        let top = rect.bottom() - part.min(1.0) * rect.height();
        painter.line_segment(
            [Pos2::new(x, rect.bottom()), Pos2::new(x, top)],
            Stroke::new(step.max(1.0) * 0.8, color),
        );
    }
}

fn stages(ui: &mut Ui, facts: &PanelFacts) {
    let longest = facts.stages.iter().map(|stage| stage.1).fold(0.0, f64::max);
    Grid::new("stages")
        .num_columns(3)
        .spacing(vec2(8.0, 2.0))
        .show(ui, |ui| {
            for name in STAGES {
                let ms = stage_ms(facts.stages, name);
                let text = match ms {
                    Some(ms) => format!("{ms:7.2} ms"),
                    None if facts.skipped.contains(&name) => "skipped".into(),
                    // A stage that this avatar does not have.
                    None => continue,
                };
                ui.label(name);
                ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                    ui.monospace(text)
                });
                let (rect, _) = ui.allocate_exact_size(vec2(96.0, 8.0), Sense::hover());
                let part = ms.map_or(0.0, |ms| ms / longest.max(1e-9)) as f32;
                ui.painter().rect_filled(
                    rect.with_max_x(rect.left() + rect.width() * part),
                    1.0,
                    BAR,
                );
                ui.end_row();
            }
        });
    ui.label(format!(
        "{} of {} Gaussians drawn",
        grouped(facts.drawn_gaussians as usize),
        grouped(facts.gaussians)
    ));
    if facts.samples > 1 {
        ui.label(detail_text(facts.samples, facts.level));
    }
}

fn device(ui: &mut Ui, facts: &PanelFacts) {
    ui.label(facts.device);
    if !facts.driver.is_empty() {
        ui.label(RichText::new(facts.driver).weak());
    }
    if leaves_loops(facts.driver) {
        ui.label(OLD_LAVAPIPE);
    }
    ui.label(RichText::new(format!("drawn with {}", facts.drawing)).weak());
    ui.label(format!(
        "{:.1} MB of GPU memory in use",
        facts.memory as f64 / 1e6
    ));
    ui.label(RichText::new(format!("avatar: {}", facts.avatar)).weak());
}

fn keys(ui: &mut Ui) {
    Grid::new("keys")
        .num_columns(2)
        .spacing(vec2(8.0, 2.0))
        .show(ui, |ui| {
            for (key, what) in POINTERS.iter().chain(&KEYS) {
                ui.label(RichText::new(*key).strong());
                ui.label(*what);
                ui.end_row();
            }
        });
}

/// Frames a second, of a frame's milliseconds.
fn rate_text(ms: f64) -> String {
    let rate = 1e3 / ms;
    let decimals = match rate {
        10.0.. => 0,
        0.1.. => 1,
        _ => 2,
    };
    format!("{rate:.decimals$} fps")
}

/// How a small avatar is drawn.
fn detail_text(samples: u64, level: u64) -> String {
    let drawn = format!("small: up to {samples} × {samples} samples a pixel");
    if level > 0 {
        format!("{drawn}, level {level}")
    } else {
        drawn
    }
}

/// Formats a number in groups of three digits.
fn grouped(number: usize) -> String {
    let digits = number.to_string();
    let groups: Vec<_> = digits
        .as_bytes()
        .rchunks(3)
        .rev()
        .map(String::from_utf8_lossy)
        .collect();
    groups.join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::playback::ClipTiming;

    #[test]
    fn the_panel_says_how_small_avatars_are_drawn() {
        assert_eq!(detail_text(2, 0), "small: up to 2 × 2 samples a pixel");
        assert_eq!(
            detail_text(4, 3),
            "small: up to 4 × 4 samples a pixel, level 3"
        );
    }

    #[test]
    fn slow_frames_have_a_rate_too() {
        for (ms, expected) in [
            (1.0, "1000 fps"),
            (16.7, "60 fps"),
            (812.0, "1.2 fps"),
            (2500.0, "0.4 fps"),
            (60_000.0, "0.02 fps"),
        ] {
            assert_eq!(rate_text(ms), expected);
        }
    }

    /// A window that was small for a while.
    #[test]
    fn the_panel_grows_back() {
        let ctx = egui::Context::default();
        style(&ctx);
        let playback = Playback::new(vec![]);
        let (times, files) = (FrameTimes::default(), FileList::default());
        let facts = PanelFacts {
            stages: &[("mlp", 0.5)],
            ..facts(&playback, &files, &times)
        };
        let mut height = |window: f32| {
            let mut height = 0.0;
            for _ in 0..4 {
                let input = egui::RawInput {
                    screen_rect: Some(egui::Rect::from_min_size(Pos2::ZERO, vec2(1280.0, window))),
                    ..Default::default()
                };
                let output = ctx.run_ui(input, |ui| show(ui.ctx(), &facts, &mut vec![]));
                output.drop_without_applying_deltas();
                height = ctx.globally_used_rect().height();
            }
            height
        };
        let [tall, short, again] = [900.0, 200.0, 900.0].map(&mut height);
        assert!(short <= 200.0 && tall > 300.0, "{short} {tall}");
        // It is as tall as before, and at the edge that the small window pushed it to.
        assert_eq!(again, tall - 12.0);
    }

    #[test]
    fn numbers_are_grouped_by_three_digits() {
        for (number, expected) in [
            (0, "0"),
            (999, "999"),
            (1000, "1 000"),
            (2_000_000, "2 000 000"),
        ] {
            assert_eq!(grouped(number), expected);
        }
    }

    fn facts<'a>(
        playback: &'a Playback,
        file_list: &'a FileList,
        times: &'a FrameTimes,
    ) -> PanelFacts<'a> {
        PanelFacts {
            avatar: "someone",
            times,
            moving: true,
            stages: &[("mlp", 0.5), ("sort", 1.0)],
            drawn_gaussians: 1234,
            samples: 4,
            level: 2,
            gaussians: 200_000,
            skipped: &["mlp"],
            device: "a device",
            driver: "a driver",
            drawing: "quads",
            memory: 12_000_000,
            playback,
            file_list,
            background: [0.5; 3],
            follow: true,
            message: Some("saved"),
            can_survey: true,
            is_surveying: false,
            survey: &[],
            has_crash_report: true,
            has_renderdoc: true,
        }
    }

    /// Runs the panel without a window, and clicks at every point of a grid.
    #[test]
    fn every_control_of_the_panel_has_an_action() {
        let ctx = egui::Context::default();
        style(&ctx);
        let track = |name: &str| ClipTiming {
            name: name.into(),
            duration: 2.0,
            rate: 30.0,
        };
        let mut playback = Playback::new(vec![track("walk"), track("run")]);
        playback.play(true, 0.0);
        let names = vec!["someone".into(), "else".into()];
        let files = FileList::new(names, 0, |_| anyhow::bail!("never asked for"));
        let times = FrameTimes::default();
        let facts = facts(&playback, &files, &times);
        let mut actions = Vec::new();
        let mut pass = |events: Vec<egui::Event>| {
            let screen_rect = Some(egui::Rect::from_min_size(Pos2::ZERO, vec2(1280.0, 900.0)));
            let output = ctx.run_ui(
                egui::RawInput {
                    screen_rect,
                    events,
                    ..Default::default()
                },
                |ui| show(ui.ctx(), &facts, &mut actions),
            );
            output.drop_without_applying_deltas();
        };
        for (row, column) in (5..42).flat_map(|row| (2..45).map(move |column| (row, column))) {
            let pos = Pos2::new(6.0 * column as f32, 6.0 * row as f32);
            pass(vec![egui::Event::PointerMoved(pos)]);
            for pressed in [true, false] {
                let modifiers = egui::Modifiers::NONE;
                pass(vec![egui::Event::PointerButton {
                    pos,
                    button: egui::PointerButton::Primary,
                    pressed,
                    modifiers,
                }]);
            }
        }
        let asked_for = |wanted: fn(&Action) -> bool| actions.iter().any(wanted);
        assert!(asked_for(|w| matches!(w, Action::PlayOrPause)), "play");
        assert!(asked_for(|w| matches!(w, Action::Seek(_))), "seek");
        assert!(
            asked_for(|w| matches!(w, Action::Next(1)))
                && asked_for(|w| matches!(w, Action::Next(-1))),
            "next"
        );
        assert!(
            asked_for(|w| matches!(w, Action::Repeat(Repeat::All))),
            "repeat"
        );
        assert!(asked_for(|w| matches!(w, Action::ResetView)), "reset");
        assert!(
            asked_for(|w| matches!(w, Action::FullScreen)),
            "full screen"
        );
        assert!(asked_for(|w| matches!(w, Action::Screenshot)), "screenshot");
        assert!(asked_for(|w| matches!(w, Action::Share)), "share");
        assert!(asked_for(|w| matches!(w, Action::Capture)), "capture");
        assert!(asked_for(|w| matches!(w, Action::Survey)), "survey");
        assert!(asked_for(|w| matches!(w, Action::Keys)), "keys");
        assert!(asked_for(|w| matches!(w, Action::Follow(false))), "follow");
    }

    #[test]
    fn an_old_lavapipe_is_named_with_what_to_do() {
        let playback = Playback::new(Vec::new());
        let files = FileList::default();
        let times = FrameTimes::default();
        for (driver, is_old) in [
            ("llvmpipe Mesa 22.3.6 (LLVM 15.0.6)", true),
            ("llvmpipe Mesa 25.0.7 (LLVM 15.0.6)", false),
        ] {
            let ctx = egui::Context::default();
            style(&ctx);
            let facts = PanelFacts {
                driver,
                ..facts(&playback, &files, &times)
            };
            let input = || egui::RawInput {
                screen_rect: Some(egui::Rect::from_min_size(Pos2::ZERO, vec2(1280.0, 900.0))),
                ..Default::default()
            };
            let mut says_so = false;
            // A window finds its size before it shows anything.
            for _ in 0..3 {
                let mut output = ctx.run_ui(input(), |ui| show(ui.ctx(), &facts, &mut Vec::new()));
                says_so = std::mem::take(&mut output.shapes).iter().any(|drawn| {
                    let egui::Shape::Text(text) = &drawn.shape else {
                        return false;
                    };
                    text.galley.text() == OLD_LAVAPIPE
                });
                output.drop_without_applying_deltas();
            }
            assert_eq!(says_so, is_old, "{driver}");
        }
    }
}
