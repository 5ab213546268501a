//! An avatar on a canvas, as a page drives it.

use super::{
    motion::Refused,
    screen::{Candidate, Screen, Shown, out_of_range, thrown},
};
use crate::{
    avatar::{Avatar, Clip, file::Neutral},
    frame::{Camera, Posed, RendererOptions},
    webgpu::Error,
};
use glam::DVec3;
use std::sync::Arc;
use wasm_bindgen::prelude::*;

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
    screen: Screen,
    shown: Option<Shown>,
    /// What was shown, if anything, before an avatar of which the correctives are still to come.
    before: Option<Option<Shown>>,
    view: View,
    size: [u32; 2],
    /// What the canvas shows is not what it should.
    stale: bool,
    /// Networks see poses as the nearest ones that the avatar knows.
    project: bool,
}

/// How many of a file's bytes are needed to draw an avatar without its correctives, as far as the first ones tell.
#[wasm_bindgen]
pub fn neutral_needs(bytes: &[u8]) -> Result<usize, JsValue> {
    Avatar::neutral_needs(bytes).map_err(thrown)
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

#[wasm_bindgen]
impl Stage {
    #[wasm_bindgen(constructor)]
    pub fn new(screen: Screen) -> Self {
        let view = View {
            target: DVec3::Y,
            yaw: 0.35,
            pitch: 0.09,
            distance: 3.2,
            fov: 0.61,
            background: [216.0 / 255.0, 221.0 / 255.0, 227.0 / 255.0],
        };
        let size = screen.size();
        screen.configure(size);
        Self { screen, shown: None, before: None, view, size, stale: true, project: true }
    }

    /// Makes room for the avatar in a file's bytes, and what will draw it. What is shown stays.
    pub fn prepare(&self, bytes: &[u8]) -> Result<Candidate, JsValue> {
        let avatar = Avatar::from_bytes(bytes).map_err(thrown)?;
        self.screen.candidate(avatar).map_err(thrown)
    }

    /// The same from the beginning of a file of `length` bytes, for an avatar without its correctives.
    pub fn prepare_neutral(&self, bytes: &[u8], length: usize) -> Result<Candidate, JsValue> {
        match Avatar::neutral(bytes, length).map_err(thrown)? {
            Neutral::Avatar(avatar) => self.screen.candidate(*avatar).map_err(thrown),
            Neutral::Needs(needs) => Err(thrown(format!("{needs} bytes are needed"))),
        }
    }

    /// Shows a candidate in place of the avatar there is; false where another device has come since it was prepared. `keep`: the avatar there
    /// is may come back, until [`Self::complete`].
    pub fn show(&mut self, candidate: Candidate, keep: bool) -> Result<bool, JsValue> {
        if !Arc::ptr_eq(&candidate.gpu, &self.screen.gpu) {
            return Ok(false);
        }
        let mut shown = candidate.shown;
        self.fit(&mut shown).map_err(thrown)?;
        let before = self.shown.replace(shown);
        self.before = keep.then_some(before);
        self.stale = true;
        Ok(true)
    }

    /// Gives the avatar that is shown its correctives: the bytes are the whole of the file that it is the beginning of.
    pub fn complete(&mut self, bytes: &[u8]) -> Result<(), JsValue> {
        let avatar = Avatar::from_bytes(bytes).map_err(thrown)?;
        let Some(shown) = &mut self.shown else { return Ok(()) };
        match shown.renderer.fill(&avatar) {
            Ok(false) => return Err(thrown("the file has changed while it was loaded: load it again")),
            // The next device will have it.
            Ok(true) | Err(Error::DeviceLost(_)) => {}
            Err(error) => return Err(thrown(error)),
        }
        shown.avatar = avatar;
        (self.before, self.stale) = (None, true);
        Ok(())
    }

    /// Shows again what was shown before.
    pub fn revert(&mut self) -> Result<(), JsValue> {
        let Some(before) = self.before.take() else { return Ok(()) };
        self.stale = true;
        self.shown = None;
        let Some(mut shown) = before else { return Ok(()) };
        if !Arc::ptr_eq(shown.renderer.gpu(), &self.screen.gpu) {
            (shown.renderer, shown.present) = self.screen.renderer(&shown.avatar, self.size).map_err(thrown)?;
        }
        self.fit(&mut shown).map_err(thrown)?;
        self.shown = Some(shown);
        Ok(())
    }

    /// Adds the bytes of a motion file to the clips; gives its number.
    pub fn add_clip(&mut self, bytes: &[u8]) -> Result<usize, JsValue> {
        let clip = Clip::from_bytes(bytes).map_err(thrown)?;
        let shown = self.shown.as_mut().ok_or_else(|| thrown("there is no avatar yet that a clip could move: load one first"))?;
        shown.motion.add(clip, &shown.avatar).map_err(thrown)
    }

    /// Shows a clip at a time, seconds.
    pub fn seek(&mut self, clip: usize, seconds: f64) {
        if let Some(shown) = &mut self.shown {
            shown.motion.seek(clip, seconds);
        }
    }

    /// Takes a pose that holds from `now` on, milliseconds: axis-angle rotations of the joints, radians, three numbers each; the root's
    /// translation, metres; and the expression. Between poses the motion is interpolated.
    pub fn set_pose(&mut self, now: f64, rotation: &[f32], translation: &[f32], expression: &[f32]) -> Result<(), JsValue> {
        let Some(shown) = &mut self.shown else { return Ok(()) };
        shown.motion.set(now, rotation, translation, expression).map_err(|Refused(why)| out_of_range(why))
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
    pub fn resize(&mut self) -> Result<(), JsValue> {
        let size = self.screen.size();
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

    /// The next call to draw gives a frame though nothing has changed.
    pub fn redraw(&mut self) {
        self.stale = true;
    }

    /// Draws what has changed by `now`, milliseconds, and says what came of it.
    pub fn draw(&mut self, now: f64) -> Result<Drawn, JsValue> {
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

    /// Whether the device is gone, and nothing is drawn before [`Self::adopt`].
    pub fn is_lost(&self) -> bool {
        matches!(self.screen.gpu.check(), Err(Error::DeviceLost(_)))
    }

    /// Goes on with another device: brings the avatar back.
    pub fn adopt(&mut self, screen: Screen) -> Result<(), JsValue> {
        screen.configure(self.size);
        if let Some(Shown { avatar, renderer, present, .. }) = &mut self.shown {
            let made = screen.renderer(avatar, self.size);
            (*renderer, *present) = made.inspect_err(|_| screen.close()).map_err(thrown)?;
        }
        (self.screen, self.stale) = (screen, true);
        Ok(())
    }

    /// Gives the device and all that it holds back: nothing is drawn before [`Self::adopt`].
    pub fn lose(&self) {
        self.screen.close();
    }

    /// What the last finished frame took and drew, JSON; stage times are in milliseconds.
    pub fn statistics(&self) -> String {
        let Some(Shown { renderer, .. }) = &self.shown else { return "{}".into() };
        let report = renderer.report();
        let stages: serde_json::Map<_, _> = report.stages.iter().map(|&(name, ms)| (name.to_owned(), ms.into())).collect();
        let counters: serde_json::Map<_, _> = report.counters.named().map(|(name, count)| (name.to_owned(), count.into())).collect();
        serde_json::json!({
            "device": self.screen.gpu.name(),
            "raster": renderer.options().method.map_or("", |method| method.name()),
            "stages": stages,
            "counters": counters,
            "options": Self::options(renderer.options()),
            "version": env!("CARGO_PKG_VERSION"),
        })
        .to_string()
    }
}

impl Stage {
    fn fit(&self, shown: &mut Shown) -> Result<(), Error> {
        if shown.renderer.options().size != self.size {
            shown.renderer.resize(self.size)?;
            shown.present.set_picture(&self.screen.gpu, shown.renderer.picture_view());
        }
        Ok(())
    }

    /// How it is drawn, as the reports of `effigy bench` have it.
    fn options(options: &RendererOptions) -> serde_json::Value {
        serde_json::json!({
            "color": format!("{:?}", options.color.unwrap_or_default()).to_lowercase(),
            "raster": options.method.map_or("", |method| method.name()),
            "key_bits": 8 * options.key_bits.passes(),
            "skip": options.skip.to_string(),
            "cutoff": options.cutoff,
            "margin": options.margin,
            "detail": options.detail.to_string(),
            "storage": "words",
            "rows": 1.0,
            "hold": 1,
        })
    }
}

#[wasm_bindgen]
impl Stage {
    /// What is loaded, JSON: the avatar's name, credit, joints and size, and the clips' names and lengths.
    pub fn describe(&self) -> String {
        let Some(Shown { avatar, renderer, motion, .. }) = &self.shown else { return "{}".into() };
        let [min, max] = crate::frame::upright(renderer.extent().bounds(&Posed::new(avatar, &motion.pose(0.0)).joints));
        serde_json::json!({
            "name": avatar.name,
            "credit": avatar.credit,
            "gaussians": avatar.gaussians.len(),
            "parts": avatar.parts.len(),
            "nodes": avatar.nodes.len(),
            "rows": [avatar.rotation_rows.gaussian.len(), avatar.scale_rows.gaussian.len(), avatar.color_rows.gaussian.len()],
            "joints": avatar.skeleton.name,
            "expression": avatar.inputs.expression,
            "bounds": [min.to_array(), max.to_array()],
            "clips": motion.clips().map(|clip| serde_json::json!({ "name": clip.name, "duration": clip.duration() })).collect::<Vec<_>>(),
        })
        .to_string()
    }
}
