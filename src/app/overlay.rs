//! The overlay: what is known of the frames goes in, an egui panel and the user's wishes come out.

use super::{
    action::{Action, KEYS, POINTERS},
    icons::{self, Icon},
    playback::{Playback, Repeat, SPEED},
    shelf::Shelf,
    times::FrameTimes,
};
use crate::vulkan::commands::STAGES;
use egui::{Align, Color32, Grid, Layout, Pos2, RichText, Sense, Slider, Stroke, Ui, vec2};

/// Width of the panel, points.
const WIDTH: f32 = 264.0;
/// Of the bars in graph and table.
const BAR: Color32 = Color32::from_rgb(110, 180, 220);
/// Height of the graph, points.
const GRAPH: f32 = 36.0;

/// What the panel shows.
pub struct Facts<'a> {
    pub avatar: &'a str,
    pub times: &'a FrameTimes,
    /// More frames follow without anyone's doing.
    pub moving: bool,
    /// Each stage of the last frame that drew the avatar, milliseconds on the GPU.
    pub stages: &'a [(&'static str, f64)],
    /// Gaussians drawn, and all there are.
    pub gaussians: (u64, usize),
    /// Stages that the frame could leave out, since their inputs were the same.
    pub skipped: &'a [&'static str],
    pub device: &'a str,
    pub driver: &'a str,
    /// Bytes of GPU memory in use.
    pub memory: u64,
    pub playback: &'a Playback,
    pub shelf: &'a Shelf,
    /// There is a crash to share.
    pub report: bool,
    /// RenderDoc is attached.
    pub capture: bool,
    pub background: [f32; 3],
    pub follow: bool,
    /// The last thing there was to say: where a screenshot went, for example.
    pub message: Option<&'a str>,
}

/// Small text on a dark, translucent panel.
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
        // Labels are not for copying here, and a panel that takes no focus leaves the keys to the viewer.
        style.interaction.selectable_labels = false;
    });
}

/// Lays the panel out; what the user asks for is added to `wishes`.
pub fn show(ctx: &egui::Context, facts: &Facts, wishes: &mut Vec<Action>) {
    // What the title bar and the window's edges leave.
    let height = (ctx.content_rect().height() - 72.0).max(40.0);
    let frame = egui::Frame::window(&ctx.global_style()).fill(Color32::from_black_alpha(205));
    let roomy = ctx.content_rect().width() > 2.5 * WIDTH;
    egui::Window::new("Effigy")
        .default_pos(Pos2::new(12.0, 12.0))
        .default_open(roomy || facts.message.is_some())
        .auto_sized()
        .frame(frame)
        .show(ctx, |ui| {
            egui::ScrollArea::vertical().max_height(height).show(ui, |ui| {
                ui.set_width(WIDTH);
                if facts.report {
                    button(ui, "Share the crash", "hand what was noted of it to another app", Action::Share, wishes);
                }
                avatar(ui, facts.shelf, wishes);
                clip(ui, facts.playback, wishes);
                ui.separator();
                view(ui, facts, wishes);
                ui.separator();
                timing(ui, facts);
                egui::CollapsingHeader::new("Stages").default_open(true).show(ui, |ui| stages(ui, facts));
                egui::CollapsingHeader::new("Device").default_open(true).show(ui, |ui| device(ui, facts));
                egui::CollapsingHeader::new("Keys").show(ui, keys);
                if let Some(message) = facts.message {
                    ui.separator();
                    ui.label(message);
                }
            });
        });
}

fn avatar(ui: &mut Ui, shelf: &Shelf, wishes: &mut Vec<Action>) {
    if shelf.names.len() < 2 {
        return;
    }
    let shown = shelf.names.get(shelf.shown).map_or("", |name| name);
    egui::ComboBox::from_id_salt("avatar").selected_text(shown).width(ui.available_width()).show_ui(ui, |ui| {
        for (number, name) in shelf.names.iter().enumerate() {
            if ui.selectable_label(number == shelf.shown, name).clicked() {
                wishes.push(Action::Avatar(number));
            }
        }
    });
}

fn clip(ui: &mut Ui, playback: &Playback, wishes: &mut Vec<Action>) {
    let moment = playback.moment();
    let Some(track) = playback.tracks().get(moment.clip) else { return };
    if playback.tracks().len() > 1 {
        ui.horizontal(|ui| {
            sign(ui, Icon::Previous, "previous clip (P)", Action::Next(-1), wishes);
            sign(ui, Icon::Next, "next clip (N)", Action::Next(1), wishes);
            egui::ComboBox::from_id_salt("clip").selected_text(&track.name).width(ui.available_width()).show_ui(ui, |ui| {
                for (number, track) in playback.tracks().iter().enumerate() {
                    if ui.selectable_label(number == moment.clip, &track.name).clicked() {
                        wishes.push(Action::Choose(number));
                    }
                }
            });
        });
    } else {
        ui.strong(&track.name);
    }
    ui.horizontal(|ui| {
        let icon = if playback.is_playing() { Icon::Pause } else { Icon::Play };
        sign(ui, icon, "play or pause (Space)", Action::PlayOrPause, wishes);
        let mut time = moment.time;
        ui.spacing_mut().slider_width = ui.available_width() - 92.0;
        let slider = Slider::new(&mut time, 0.0..=track.duration.max(1e-6)).show_value(false);
        if ui.add_enabled(track.duration > 0.0, slider).changed() {
            wishes.push(Action::Seek(time));
        }
        ui.monospace(format!("{:5.2} / {:.2} s", moment.time, track.duration));
    });
    ui.horizontal(|ui| {
        for (repeat, name) in [(Repeat::Off, "once"), (Repeat::Clip, "loop"), (Repeat::All, "all clips")] {
            if ui.selectable_label(playback.repeat() == repeat, name).clicked() {
                wishes.push(Action::Repeat(repeat));
            }
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let mut speed = playback.speed();
            let drag = egui::DragValue::new(&mut speed).range(SPEED[0]..=SPEED[1]).speed(0.01).fixed_decimals(2).suffix("×");
            if ui.add(drag).on_hover_text("speed").changed() {
                wishes.push(Action::Speed(speed));
            }
        });
    });
}

fn button(ui: &mut Ui, text: &str, hint: &str, action: Action, wishes: &mut Vec<Action>) {
    if ui.button(text).on_hover_text(hint).clicked() {
        wishes.push(action);
    }
}

fn sign(ui: &mut Ui, icon: Icon, hint: &str, action: Action, wishes: &mut Vec<Action>) {
    if icons::button(ui, icon).on_hover_text(hint).clicked() {
        wishes.push(action);
    }
}

fn view(ui: &mut Ui, facts: &Facts, wishes: &mut Vec<Action>) {
    ui.horizontal(|ui| {
        button(ui, "Reset view", "frame the avatar (R)", Action::ResetView, wishes);
        if cfg!(not(target_os = "android")) {
            button(ui, "Full screen", "F or F11", Action::FullScreen, wishes);
        }
        button(ui, "Screenshot", "a PNG without this panel (S)", Action::Screenshot, wishes);
    });
    if facts.capture {
        button(ui, "Capture a frame", "by RenderDoc, which is attached (C)", Action::Capture, wishes);
    }
    ui.horizontal(|ui| {
        let mut background = facts.background.map(|channel| (255.0 * channel).round() as u8);
        if ui.color_edit_button_srgb(&mut background).on_hover_text("background (B for the next)").changed() {
            wishes.push(Action::Background(background.map(|channel| f32::from(channel) / 255.0)));
        }
        ui.label("background");
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let mut follow = facts.follow;
            if ui.checkbox(&mut follow, "follow").on_hover_text("the view goes where the avatar goes").changed() {
                wishes.push(Action::Follow(follow));
            }
        });
    });
}

fn timing(ui: &mut Ui, facts: &Facts) {
    ui.horizontal(|ui| {
        match facts.times.mean_ms().filter(|_| facts.moving) {
            Some(ms) => {
                ui.label(RichText::new(format!("{:.0} fps", 1e3 / ms)).strong());
                ui.monospace(format!("{ms:.2} ms"));
            }
            None => {
                ui.label("still: nothing is drawn");
            }
        }
        if !facts.stages.is_empty() {
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                ui.monospace(format!("GPU {:.2} ms", facts.stages.iter().map(|stage| stage.1).sum::<f64>()));
            });
        }
    });
    graph(ui, facts.times);
}

/// One bar a frame, up to twice the mean; slower frames reach the top in another colour.
fn graph(ui: &mut Ui, times: &FrameTimes) {
    let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), GRAPH), Sense::hover());
    let painter = ui.painter_at(rect);
    painter.rect_filled(rect, 2.0, Color32::from_white_alpha(10));
    let mean = times.history_ms().sum::<f32>() / times.history_ms().len().max(1) as f32;
    let step = rect.width() / 120.0;
    for (place, ms) in times.history_ms().rev().enumerate() {
        let part = ms / (2.0 * mean).max(1e-3);
        let color = if part > 0.75 { Color32::from_rgb(230, 150, 70) } else { BAR };
        let x = rect.right() - (place as f32 + 0.5) * step;
        let top = rect.bottom() - part.min(1.0) * rect.height();
        painter.line_segment([Pos2::new(x, rect.bottom()), Pos2::new(x, top)], Stroke::new(step.max(1.0) * 0.8, color));
    }
}

fn stages(ui: &mut Ui, facts: &Facts) {
    let longest = facts.stages.iter().map(|stage| stage.1).fold(0.0, f64::max);
    Grid::new("stages").num_columns(3).spacing(vec2(8.0, 2.0)).show(ui, |ui| {
        for name in STAGES {
            ui.label(name);
            let ms = facts.stages.iter().find(|stage| stage.0 == name).map(|stage| stage.1);
            let text = match ms {
                Some(ms) => format!("{ms:7.2} ms"),
                None if facts.skipped.contains(&name) => "skipped".into(),
                None => "unknown".into(),
            };
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| ui.monospace(text));
            let (rect, _) = ui.allocate_exact_size(vec2(96.0, 8.0), Sense::hover());
            let part = ms.map_or(0.0, |ms| ms / longest.max(1e-9)) as f32;
            ui.painter().rect_filled(rect.with_max_x(rect.left() + rect.width() * part), 1.0, BAR);
            ui.end_row();
        }
    });
    let (drawn, all) = facts.gaussians;
    ui.label(format!("{} of {} Gaussians drawn", grouped(drawn as usize), grouped(all)));
}

fn device(ui: &mut Ui, facts: &Facts) {
    ui.label(facts.device);
    if !facts.driver.is_empty() {
        ui.label(RichText::new(facts.driver).weak());
    }
    ui.label(format!("{:.1} MB of GPU memory in use", facts.memory as f64 / 1e6));
    ui.label(RichText::new(format!("avatar: {}", facts.avatar)).weak());
}

fn keys(ui: &mut Ui) {
    Grid::new("keys").num_columns(2).spacing(vec2(8.0, 2.0)).show(ui, |ui| {
        for (key, what) in POINTERS.iter().chain(&KEYS) {
            ui.label(RichText::new(*key).strong());
            ui.label(*what);
            ui.end_row();
        }
    });
}

/// A number in groups of three digits.
fn grouped(number: usize) -> String {
    let digits = number.to_string();
    let groups: Vec<_> = digits.as_bytes().rchunks(3).rev().map(String::from_utf8_lossy).collect();
    groups.join(" ")
}

#[cfg(test)]
mod tests;
