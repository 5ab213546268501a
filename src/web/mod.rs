//! What JavaScript calls: an avatar on a canvas. `page/effigy.js` wraps it for pages; nothing else should need to know it.
//!
//! A [`Stage`] owns a device, a canvas and at most one avatar. Bytes go in, frames appear on the canvas; errors are sentences.

mod motion;

use crate::{
    avatar::{Avatar, Clip},
    frame::{Camera, Posed, RendererOptions},
    webgpu::{Error, Gpu, Renderer, present::Present},
};
use glam::DVec3;
use motion::Motion;
use std::sync::Arc;
use wasm_bindgen::prelude::*;
use web_sys::HtmlCanvasElement;

/// An avatar and what draws it.
struct Shown {
    avatar: Avatar,
    renderer: Renderer,
    present: Present,
    motion: Motion,
}

/// A canvas that is drawn on.
struct Screen {
    gpu: Arc<Gpu>,
    surface: wgpu::Surface<'static>,
    format: wgpu::TextureFormat,
}

/// From where, and over what.
#[derive(Clone, Copy, PartialEq)]
struct View {
    target: DVec3,
    /// Radians.
    yaw: f64,
    pitch: f64,
    /// Metres.
    distance: f64,
    /// Vertical field of view, radians.
    fov: f64,
    background: [f32; 3],
}

/// An avatar on a canvas.
#[wasm_bindgen]
pub struct Stage {
    canvas: HtmlCanvasElement,
    screen: Screen,
    shown: Option<Shown>,
    view: View,
    size: [u32; 2],
    /// What the canvas shows is not what it should.
    stale: bool,
    /// Networks see poses as the nearest ones that the avatar knows.
    project: bool,
}

/// What came of a call to draw.
#[wasm_bindgen]
pub enum Drawn {
    /// Nothing has changed.
    Nothing,
    Frame,
    /// The device has enough to do: ask again.
    Later,
}

/// An error as JavaScript has it.
fn thrown(error: impl std::fmt::Display) -> JsError {
    JsError::new(&error.to_string())
}

async fn screen(canvas: &HtmlCanvasElement) -> Result<Screen, Error> {
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor {
        backends: wgpu::Backends::BROWSER_WEBGPU,
        ..wgpu::InstanceDescriptor::new_without_display_handle()
    });
    let surface = instance.create_surface(wgpu::SurfaceTarget::Canvas(canvas.clone()));
    let surface = surface.map_err(|error| Error::NoDevice(error.to_string()))?;
    let gpu = Gpu::new(instance, None).await?;
    let formats = surface.get_capabilities(&gpu.adapter).formats;
    // Colours are display-referred: numbers that are shown as they are.
    let format = formats.iter().copied().find(|format| !format.is_srgb()).unwrap_or(wgpu::TextureFormat::Bgra8Unorm);
    Ok(Screen { gpu, surface, format })
}

impl Screen {
    fn configure(&self, [width, height]: [u32; 2]) {
        if let Some(config) = self.surface.get_default_config(&self.gpu.adapter, width, height) {
            let alpha_mode = wgpu::CompositeAlphaMode::Opaque;
            self.surface.configure(&self.gpu.device, &wgpu::SurfaceConfiguration { format: self.format, alpha_mode, ..config });
        }
    }

    fn renderer(&self, avatar: &Avatar, size: [u32; 2]) -> Result<(Renderer, Present), Error> {
        let renderer = Renderer::new(&self.gpu, avatar, RendererOptions::new(size))?;
        let present = Present::new(&self.gpu, renderer.picture_view(), self.format)?;
        Ok((renderer, present))
    }
}

#[wasm_bindgen]
impl Stage {
    /// Opens a device for a canvas of its own.
    pub async fn create(canvas: HtmlCanvasElement) -> Result<Stage, JsError> {
        let screen = screen(&canvas).await.map_err(thrown)?;
        let view = View {
            target: DVec3::Y,
            yaw: 0.35,
            pitch: 0.09,
            distance: 3.2,
            fov: 0.61,
            background: [216.0 / 255.0, 221.0 / 255.0, 227.0 / 255.0],
        };
        let size = [canvas.width().max(1), canvas.height().max(1)];
        screen.configure(size);
        Ok(Stage { canvas, screen, shown: None, view, size, stale: true, project: true })
    }

    /// Takes the bytes of an avatar file in place of the avatar there is, which stays where they are none.
    pub fn load(&mut self, bytes: &[u8]) -> Result<(), JsError> {
        let avatar = Avatar::from_bytes(bytes).map_err(thrown)?;
        let motion = Motion::new(&avatar);
        let (renderer, present) = self.screen.renderer(&avatar, self.size).map_err(thrown)?;
        self.shown = Some(Shown { avatar, renderer, present, motion });
        self.stale = true;
        Ok(())
    }

    /// Adds the bytes of a motion file to the clips; gives its number.
    pub fn add_clip(&mut self, bytes: &[u8]) -> Result<usize, JsError> {
        let clip = Clip::from_bytes(bytes).map_err(thrown)?;
        let shown = self.shown.as_mut().ok_or_else(|| JsError::new("there is no avatar yet that a clip could move: load one first"))?;
        shown.motion.add(clip, &shown.avatar).map_err(|message| JsError::new(&message))
    }

    /// Shows a clip at a time, seconds.
    pub fn seek(&mut self, clip: usize, seconds: f64) {
        if let Some(shown) = &mut self.shown {
            shown.motion.seek(clip, seconds);
        }
    }

    /// Takes a pose that holds from `now` on, milliseconds: axis-angle rotations of the joints, radians, three numbers each; the root's
    /// translation, metres; and the expression. Between poses the motion is interpolated.
    pub fn set_pose(&mut self, now: f64, rotation: &[f32], translation: &[f32], expression: &[f32]) -> Result<(), JsError> {
        let Some(shown) = &mut self.shown else { return Ok(()) };
        shown.motion.set(now, rotation, translation, expression).map_err(|message| JsError::new(&message))
    }

    /// Looks at a point from around it: metres and radians.
    #[allow(clippy::too_many_arguments)]
    pub fn set_camera(&mut self, x: f64, y: f64, z: f64, yaw: f64, pitch: f64, distance: f64, fov: f64) {
        self.view = View { target: DVec3::new(x, y, z), yaw, pitch, distance, fov, ..self.view };
    }

    /// What lies behind the avatar: red, green and blue from 0 to 1.
    pub fn set_background(&mut self, red: f32, green: f32, blue: f32) {
        self.view.background = [red, green, blue];
        self.stale = true;
    }

    /// Whether networks see poses as the nearest ones that the avatar knows; else as they are.
    pub fn set_projection(&mut self, on: bool) {
        self.project = on;
    }

    /// Follows the canvas's width and height.
    pub fn resize(&mut self) -> Result<(), JsError> {
        let size = [self.canvas.width().max(1), self.canvas.height().max(1)];
        if size == self.size {
            return Ok(());
        }
        if let Some(Shown { renderer, present, .. }) = &mut self.shown {
            renderer.resize(size).map_err(thrown)?;
            present.set_picture(&self.screen.gpu, renderer.picture_view());
        }
        self.screen.configure(size);
        (self.size, self.stale) = (size, true);
        Ok(())
    }

    /// Draws what has changed by `now`, milliseconds, and says what came of it.
    pub fn draw(&mut self, now: f64) -> Result<Drawn, JsError> {
        let Some(Shown { avatar, renderer, present, motion }) = &mut self.shown else { return Ok(Drawn::Nothing) };
        self.screen.gpu.check().map_err(thrown)?;
        if !renderer.ready() {
            return Ok(Drawn::Later);
        }
        let View { target, yaw, pitch, distance, fov, background } = self.view;
        let camera = Camera::orbit(target, yaw, pitch.clamp(-1.55, 1.55), distance, fov, self.size);
        let posed = Posed::of(avatar, &motion.pose(now), self.project);
        self.stale |= renderer.draw(&posed, &camera).map_err(thrown)?;
        if !self.stale {
            return Ok(Drawn::Nothing);
        }
        use wgpu::CurrentSurfaceTexture::{Lost, Outdated, Suboptimal, Success};
        let texture = match self.screen.surface.get_current_texture() {
            Success(texture) | Suboptimal(texture) => texture,
            Lost | Outdated => {
                self.screen.configure(self.size);
                return Ok(Drawn::Later);
            }
            _ => return Ok(Drawn::Later),
        };
        present.draw(&self.screen.gpu, &texture.texture.create_view(&Default::default()), background);
        self.screen.gpu.queue.present(texture);
        self.stale = false;
        Ok(Drawn::Frame)
    }

    /// Whether the device is gone, and nothing is drawn before [`Self::recover`].
    pub fn is_lost(&self) -> bool {
        matches!(self.screen.gpu.check(), Err(Error::DeviceLost(_)))
    }

    /// Opens a device again and brings the avatar back.
    pub async fn recover(&mut self) -> Result<(), JsError> {
        let screen = screen(&self.canvas).await.map_err(thrown)?;
        screen.configure(self.size);
        if let Some(Shown { avatar, renderer, present, .. }) = &mut self.shown {
            (*renderer, *present) = screen.renderer(avatar, self.size).map_err(thrown)?;
        }
        (self.screen, self.stale) = (screen, true);
        Ok(())
    }

    /// Loses the device on purpose, to test what follows.
    pub fn lose(&self) {
        self.screen.gpu.device.destroy();
    }

    /// What the last finished frame took and drew, JSON; stage times are in milliseconds.
    pub fn statistics(&self) -> String {
        let Some(Shown { renderer, .. }) = &self.shown else { return "{}".into() };
        let report = renderer.report();
        let stages: serde_json::Map<_, _> = report.stages.iter().map(|&(name, ms)| (name.to_owned(), ms.into())).collect();
        let counters: serde_json::Map<_, _> = report.counters.named().map(|(name, count)| (name.to_owned(), count.into())).collect();
        let method = renderer.options().method.map_or("", |method| method.name());
        serde_json::json!({ "device": self.screen.gpu.name(), "raster": method, "stages": stages, "counters": counters }).to_string()
    }

    /// What is loaded, JSON: the avatar's name, credit, joints and size, and the clips' names and lengths.
    pub fn describe(&self) -> String {
        let Some(Shown { avatar, renderer, motion, .. }) = &self.shown else { return "{}".into() };
        let [min, max] = crate::frame::upright(renderer.extent().bounds(&Posed::new(avatar, &motion.pose(0.0)).joints));
        serde_json::json!({
            "name": avatar.name,
            "credit": avatar.credit,
            "gaussians": avatar.gaussians.len(),
            "joints": avatar.skeleton.name,
            "expression": avatar.inputs.expression,
            "bounds": [min.to_array(), max.to_array()],
            "clips": motion.clips().map(|clip| serde_json::json!({ "name": clip.name, "duration": clip.duration() })).collect::<Vec<_>>(),
        })
        .to_string()
    }
}
