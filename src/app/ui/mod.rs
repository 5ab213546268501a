//! The overlay: an egui panel over the avatar. It decides which events the panel consumes, and lays
//! the panel out.

pub mod browser;
pub mod icons;
pub mod panel;

use crate::{action::Action, painter::PanelMesh};
use browser::Browser;
use egui::{Order, Pos2, Rect, TexturesDelta, ViewportId, vec2};
use panel::PanelFacts;
use std::{
    collections::HashSet,
    env,
    path::PathBuf,
    time::{Duration, Instant},
};
use winit::{
    dpi::PhysicalPosition,
    event::{ElementState, TouchPhase, WindowEvent},
    keyboard::{Key, NamedKey},
    window::Window,
};

/// How the panel responds to an event.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct EventResponse {
    /// The panel handles the event: the scene must ignore it.
    pub consumed: bool,
    /// The panel has to be drawn again.
    pub repaint: bool,
}

/// The panel, laid out for a frame.
#[derive(Default)]
pub struct OverlayFrame {
    /// Its triangles.
    pub mesh: PanelMesh,
    /// Changes of its textures.
    pub textures: TexturesDelta,
    /// When egui wants to lay it out again.
    pub repaint_after: Option<Duration>,
    /// The user's actions in the panel.
    pub actions: Vec<Action>,
    /// The file that the user has chosen to open.
    pub chosen: Option<PathBuf>,
}

/// The panel, and the pointers on it.
pub struct Overlay {
    ctx: egui::Context,
    state: egui_winit::State,
    visible: bool,
    /// The list of keys is shown.
    keys: bool,
    /// The files to open, while they are shown.
    browser: Option<Browser>,
    /// Where files were opened last.
    folder: PathBuf,
    /// The mouse is over the panel.
    over: bool,
    /// A button went down on the panel, and is still down.
    grabbed: bool,
    /// Fingers that came down on the panel.
    fingers: HashSet<u64>,
    start: Instant,
}

/// Longer waits than this count as none, seconds.
const REPAINT_MAX: u64 = 3600;

impl Overlay {
    /// A panel for a window.
    pub fn new(window: &Window, visible: bool) -> Self {
        let ctx = egui::Context::default();
        panel::style(&ctx);
        let scale = Some(window.scale_factor() as f32);
        let state =
            egui_winit::State::new(ctx.clone(), ViewportId::ROOT, window, scale, None, None);
        Self {
            ctx,
            state,
            visible,
            keys: false,
            browser: None,
            folder: env::current_dir().unwrap_or_default(),
            over: false,
            grabbed: false,
            fingers: HashSet::new(),
            start: Instant::now(),
        }
    }

    /// Whether the panel is shown.
    pub fn is_visible(&self) -> bool {
        self.visible
    }

    /// Shows the panel.
    pub fn show(&mut self) {
        self.visible = true;
    }

    /// Shows or hides the panel.
    pub fn toggle(&mut self) {
        self.visible = !self.visible;
        self.release();
    }

    /// Shows or hides the list of keys.
    pub fn toggle_keys(&mut self) {
        self.keys = !self.keys;
        self.release();
    }

    /// Shows or hides the files to open.
    pub fn toggle_browser(&mut self) {
        self.browser = match self.browser.take() {
            Some(_) => None,
            None => Some(Browser::new(self.folder.clone())),
        };
        self.release();
    }

    /// Hides the keys and the files to open. Returns whether one of them was shown.
    pub fn close_lists(&mut self) -> bool {
        let shown = std::mem::take(&mut self.keys) | self.browser.take().is_some();
        if shown {
            self.release();
        }
        shown
    }

    /// Whether anything is drawn over the avatar.
    fn is_shown(&self) -> bool {
        self.visible || self.keys || self.browser.is_some()
    }

    /// Stops following buttons and fingers that are down: their events will not come any more.
    pub fn release(&mut self) {
        self.over = false;
        self.grabbed = false;
        self.fingers.clear();
    }

    /// Whether the panel covers a position.
    fn covers(&self, window: &Window, position: PhysicalPosition<f64>) -> bool {
        let scale = f64::from(egui_winit::pixels_per_point(&self.ctx, window));
        let point = Pos2::new((position.x / scale) as f32, (position.y / scale) as f32);
        self.ctx
            .layer_id_at(point)
            .is_some_and(|layer| layer.order != Order::Background)
    }

    /// Handles an event. Events that do not concern the panel are not passed on to egui: they would
    /// only wake it and pile up.
    pub fn event(&mut self, window: &Window, event: &WindowEvent) -> EventResponse {
        let always = matches!(
            event,
            WindowEvent::Focused(_)
                | WindowEvent::ModifiersChanged(_)
                | WindowEvent::ScaleFactorChanged { .. }
        );
        if !self.is_shown() {
            if always {
                let _ = self.state.on_window_event(window, event);
            }
            return EventResponse::default();
        }
        let open = egui::Popup::is_any_open(&self.ctx);
        let before = self.over;
        let (consumed, concerned) = match event {
            WindowEvent::CursorMoved { position, .. } => {
                self.over = self.covers(window, *position);
                (self.grabbed, self.over || before || self.grabbed || open)
            }
            WindowEvent::CursorLeft { .. } => {
                self.over = false;
                (false, before)
            }
            WindowEvent::MouseInput {
                state: ElementState::Pressed,
                ..
            } => {
                self.grabbed |= self.over;
                (self.over, self.over || open)
            }
            WindowEvent::MouseInput { .. } => {
                let grabbed = std::mem::take(&mut self.grabbed);
                (grabbed, grabbed || open)
            }
            WindowEvent::MouseWheel { .. } | WindowEvent::PinchGesture { .. } => {
                (self.over, self.over)
            }
            WindowEvent::Touch(touch) => {
                if touch.phase == TouchPhase::Started && self.covers(window, touch.location) {
                    self.fingers.insert(touch.id);
                }
                let consumed = self.fingers.contains(&touch.id);
                if matches!(touch.phase, TouchPhase::Ended | TouchPhase::Cancelled) {
                    self.fingers.remove(&touch.id);
                }
                (consumed, consumed || open)
            }
            WindowEvent::KeyboardInput { event, .. } => {
                let tab = event.logical_key == Key::Named(NamedKey::Tab);
                let consumed = tab || self.ctx.egui_wants_keyboard_input();
                (consumed, consumed)
            }
            WindowEvent::Ime(_) => (true, true),
            _ => (false, always),
        };
        let repaint = concerned && self.state.on_window_event(window, event).repaint;
        EventResponse { consumed, repaint }
    }

    /// Lays out what is shown over a frame of `size` px.
    pub fn lay_out(&mut self, window: &Window, size: [u32; 2], facts: &PanelFacts) -> OverlayFrame {
        if !self.is_shown() {
            return OverlayFrame::default();
        }
        let scale = egui_winit::pixels_per_point(&self.ctx, window);
        let input = self.state.egui_input_mut();
        input.time = Some(self.start.elapsed().as_secs_f64());
        input.screen_rect = Some(Rect::from_min_size(
            Pos2::ZERO,
            vec2(size[0] as f32, size[1] as f32) / scale,
        ));
        let input = input.take();
        let mut actions = Vec::new();
        let mut chosen = None;
        let mut output = self.ctx.run_ui(input, |ui| {
            // egui may lay out more than once. The last time counts.
            actions.clear();
            if self.visible {
                panel::show(ui.ctx(), facts, &mut actions);
            }
            if self.keys {
                panel::show_keys(ui.ctx());
            }
            if let Some(browser) = &mut self.browser {
                chosen = browser.show(ui.ctx()).or(chosen.take());
            }
        });
        if chosen.is_some()
            && let Some(browser) = self.browser.take()
        {
            self.folder = browser.folder().to_owned();
            self.release();
        }
        self.state
            .handle_platform_output(window, std::mem::take(&mut output.platform_output));
        let repaint_after = output
            .viewport_output
            .get(&ViewportId::ROOT)
            .map(|viewport| viewport.repaint_delay)
            .filter(|&delay| delay < Duration::from_secs(REPAINT_MAX));
        let pixels_per_point = output.pixels_per_point;
        let primitives = self
            .ctx
            .tessellate(std::mem::take(&mut output.shapes), pixels_per_point);
        OverlayFrame {
            mesh: PanelMesh {
                primitives,
                pixels_per_point,
            },
            textures: std::mem::take(&mut output.textures_delta),
            repaint_after,
            actions,
            chosen,
        }
    }
}
