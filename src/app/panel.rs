//! The overlay in its window: decides which events are the panel's, lays it out, and hands over its triangles.

use super::{
    action::Action,
    overlay::{self, Facts},
    painter::Panel,
};
use egui::{Order, Pos2, Rect, TexturesDelta, ViewportId, vec2};
use std::{
    collections::HashSet,
    time::{Duration, Instant},
};
use winit::{
    dpi::PhysicalPosition,
    event::{ElementState, TouchPhase, WindowEvent},
    keyboard::{Key, NamedKey},
    window::Window,
};

/// What an event means to the panel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Taken {
    /// It is the panel's: the scene must not answer to it.
    pub taken: bool,
    /// The panel may look different now.
    pub changed: bool,
}

/// egui and what the pointer is doing to it.
pub struct Overlay {
    ctx: egui::Context,
    state: egui_winit::State,
    pub visible: bool,
    /// The mouse is over the panel.
    over: bool,
    /// A button went down on the panel, and is still down.
    grabbed: bool,
    /// Fingers that came down on the panel.
    fingers: HashSet<u64>,
    start: Instant,
}

impl Overlay {
    pub fn new(window: &Window, visible: bool) -> Self {
        let ctx = egui::Context::default();
        overlay::style(&ctx);
        let scale = Some(window.scale_factor() as f32);
        let state = egui_winit::State::new(ctx.clone(), ViewportId::ROOT, window, scale, None, None);
        Self { ctx, state, visible, over: false, grabbed: false, fingers: HashSet::new(), start: Instant::now() }
    }

    /// Lets go of everything: the panel is hidden, or the window has lost the focus.
    pub fn release(&mut self) {
        self.over = false;
        self.grabbed = false;
        self.fingers.clear();
    }

    fn is_at(&self, window: &Window, at: PhysicalPosition<f64>) -> bool {
        let scale = f64::from(egui_winit::pixels_per_point(&self.ctx, window));
        let at = Pos2::new((at.x / scale) as f32, (at.y / scale) as f32);
        self.ctx.layer_id_at(at).is_some_and(|layer| layer.order != Order::Background)
    }

    /// Takes an event in. What is none of the panel's business is not passed on to egui, so that it neither wakes it nor piles up.
    pub fn event(&mut self, window: &Window, event: &WindowEvent) -> Taken {
        let always = matches!(event, WindowEvent::Focused(_) | WindowEvent::ModifiersChanged(_) | WindowEvent::ScaleFactorChanged { .. });
        if !self.visible {
            if always {
                let _ = self.state.on_window_event(window, event);
            }
            return Taken::default();
        }
        let open = egui::Popup::is_any_open(&self.ctx);
        let before = self.over;
        let (taken, concerned) = match event {
            WindowEvent::CursorMoved { position, .. } => {
                self.over = self.is_at(window, *position);
                (self.grabbed, self.over || before || self.grabbed || open)
            }
            WindowEvent::CursorLeft { .. } => {
                self.over = false;
                (false, before)
            }
            WindowEvent::MouseInput { state: ElementState::Pressed, .. } => {
                self.grabbed |= self.over;
                (self.over, self.over || open)
            }
            WindowEvent::MouseInput { .. } => {
                let grabbed = std::mem::take(&mut self.grabbed);
                (grabbed, grabbed || open)
            }
            WindowEvent::MouseWheel { .. } | WindowEvent::PinchGesture { .. } => (self.over, self.over),
            WindowEvent::Touch(touch) => {
                if touch.phase == TouchPhase::Started && self.is_at(window, touch.location) {
                    self.fingers.insert(touch.id);
                }
                let taken = self.fingers.contains(&touch.id);
                if matches!(touch.phase, TouchPhase::Ended | TouchPhase::Cancelled) {
                    self.fingers.remove(&touch.id);
                }
                (taken, taken || open)
            }
            WindowEvent::KeyboardInput { event, .. } => {
                let tab = event.logical_key == Key::Named(NamedKey::Tab);
                let taken = tab || self.ctx.egui_wants_keyboard_input();
                (taken, taken)
            }
            WindowEvent::Ime(_) => (true, true),
            _ => (false, always),
        };
        let changed = concerned && self.state.on_window_event(window, event).repaint;
        Taken { taken, changed }
    }

    /// Lays the panel out in a picture of `size` px; `wishes` becomes what the user asks for. Also says after how long egui wants to be
    /// asked again.
    pub fn lay_out(
        &mut self,
        (window, size): (&Window, [u32; 2]),
        facts: &Facts,
        wishes: &mut Vec<Action>,
    ) -> (Panel, TexturesDelta, Option<Duration>) {
        if !self.visible {
            return Default::default();
        }
        let scale = egui_winit::pixels_per_point(&self.ctx, window);
        let input = self.state.egui_input_mut();
        input.time = Some(self.start.elapsed().as_secs_f64());
        input.screen_rect = Some(Rect::from_min_size(Pos2::ZERO, vec2(size[0] as f32, size[1] as f32) / scale));
        let input = input.take();
        let mut output = self.ctx.run_ui(input, |ui| {
            wishes.clear();
            overlay::show(ui.ctx(), facts, wishes);
        });
        self.state.handle_platform_output(window, std::mem::take(&mut output.platform_output));
        let wait = output.viewport_output.get(&ViewportId::ROOT).map(|viewport| viewport.repaint_delay);
        let pixels_per_point = output.pixels_per_point;
        let triangles = self.ctx.tessellate(std::mem::take(&mut output.shapes), pixels_per_point);
        let delta = std::mem::take(&mut output.textures_delta);
        (Panel { triangles, pixels_per_point }, delta, wait.filter(|&wait| wait < Duration::from_secs(3600)))
    }
}
