//! An avatar on a canvas, with the calls that a page makes.

use crate::{
    motion::InvalidPose,
    surface::{CanvasSurface, DrawableAvatar, UploadedAvatar, js_error, js_range_error},
};
use effigy_core::{
    avatar::{Avatar, Clip},
    frame::{AvatarId, RendererOptions, report::stage_ms},
    io::{
        file::{FileContent, Neutral},
        splats,
    },
    scene::{Camera, Detail, Posed, Supersampling},
};
use effigy_render::webgpu::Error;
use glam::DVec3;
use std::sync::Arc;
use wasm_bindgen::prelude::*;

/// Largest pitch, radians: a view straight up or down has no left and right.
const PITCH_MAX: f64 = 1.55;

const NO_AVATAR: &str = "there is no avatar yet to add a clip to: load one first";

/// The camera, and the colour behind the avatar.
#[derive(Clone, Copy, PartialEq)]
struct Viewpoint {
    /// The point that the camera looks at, metres.
    target: DVec3,
    /// Around the target, radians; 0 sees the avatar's front.
    yaw: f64,
    /// Above the horizon, radians.
    pitch: f64,
    /// From the target, metres.
    distance: f64,
    /// Vertical field of view, radians.
    fov: f64,
    /// Display-referred RGB, 0 to 1.
    background: [f32; 3],
}

/// The avatar to go back to while the correctives of the one that is shown are loading.
enum Previous {
    /// The avatar that is shown is complete: there is no way back.
    Dropped,
    /// Nothing was shown.
    Empty,
    /// Another avatar.
    Avatar(Box<DrawableAvatar>),
}

/// What a page may choose of how avatars are drawn.
#[wasm_bindgen]
#[derive(Clone, Copy)]
pub struct DrawingOptions {
    supersampling: Supersampling,
    detail: Detail,
}

#[wasm_bindgen]
impl DrawingOptions {
    /// Takes the words of the command's `--supersample` and `--detail`.
    #[wasm_bindgen(constructor)]
    pub fn new(supersample: &str, detail: &str) -> Result<Self, JsValue> {
        Ok(Self {
            supersampling: supersample.parse().map_err(js_range_error)?,
            detail: detail.parse().map_err(js_range_error)?,
        })
    }
}

/// An avatar on a canvas.
#[wasm_bindgen]
pub struct AvatarCanvas {
    surface: CanvasSurface,
    drawing: DrawingOptions,
    shown: Option<DrawableAvatar>,
    previous: Previous,
    viewpoint: Viewpoint,
    /// Width and height of the frames, px.
    size: [u32; 2],
    /// The canvas has to be drawn again.
    stale: bool,
    /// The networks get each pose projected onto the training poses.
    project: bool,
}

/// How many bytes of a file's beginning are needed to draw its avatar without correctives.
/// `bytes`: those that have arrived.
#[wasm_bindgen]
pub fn neutral_needs(bytes: &[u8]) -> Result<usize, JsValue> {
    Avatar::neutral_needs(bytes).map_err(js_error)
}

/// The result of a call to draw.
#[wasm_bindgen]
pub enum Drawn {
    /// Nothing has changed.
    Nothing,
    /// A frame was drawn.
    Frame,
    /// The device is busy: call again.
    Later,
}

#[wasm_bindgen]
impl AvatarCanvas {
    /// An empty canvas.
    #[wasm_bindgen(constructor)]
    pub fn new(surface: CanvasSurface, drawing: DrawingOptions) -> Self {
        let viewpoint = Viewpoint {
            target: DVec3::Y,
            yaw: 0.35,
            pitch: 0.09,
            distance: 3.2,
            fov: 0.61,
            background: [216.0 / 255.0, 221.0 / 255.0, 227.0 / 255.0],
        };
        let size = surface.size();
        surface.configure(size);
        Self {
            surface,
            drawing,
            shown: None,
            previous: Previous::Dropped,
            viewpoint,
            size,
            stale: true,
            project: true,
        }
    }

    /// Prepares the avatar of a file, given all its bytes. The one that is shown stays.
    pub fn prepare(&self, bytes: &[u8]) -> Result<UploadedAvatar, JsValue> {
        let avatar = Avatar::from_bytes(bytes).map_err(js_error)?;
        self.candidate(avatar)
    }

    /// Prepares splats, given what the library that reads them hands over. The avatar that is shown
    /// stays.
    pub fn prepare_splats(&self, columns: &[u8]) -> Result<UploadedAvatar, JsValue> {
        let avatar = splats::from_columns(columns).map_err(js_error)?;
        self.candidate(avatar)
    }

    /// Prepares the avatar of a file of `length` bytes without its correctives, given the beginning
    /// of the file. The one that is shown stays.
    pub fn prepare_neutral(&self, bytes: &[u8], length: usize) -> Result<UploadedAvatar, JsValue> {
        match Avatar::neutral(bytes, length).map_err(js_error)? {
            Neutral::Avatar(avatar) => self.candidate(*avatar),
            Neutral::Needs(needs) => Err(js_error(format!("{needs} bytes are needed"))),
        }
    }

    /// Shows a candidate in place of the current avatar. Returns false if the device was replaced
    /// since the candidate was prepared. `keep`: [`Self::revert`] brings the current avatar back,
    /// until [`Self::complete`].
    pub fn show(&mut self, candidate: UploadedAvatar, keep: bool) -> Result<bool, JsValue> {
        if !Arc::ptr_eq(&candidate.gpu, &self.surface.gpu) {
            return Ok(false);
        }
        let mut drawable = candidate.drawable;
        self.fit(&mut drawable).map_err(js_error)?;
        let previous = match self.shown.replace(drawable) {
            Some(avatar) => Previous::Avatar(Box::new(avatar)),
            None => Previous::Empty,
        };
        self.previous = if keep { previous } else { Previous::Dropped };
        self.stale = true;
        Ok(true)
    }

    /// Adds the correctives of the avatar that is shown; its levels of detail come with
    /// [`Self::add_levels`]. `bytes`: all of its file.
    pub fn complete(&mut self, bytes: &[u8]) -> Result<(), JsValue> {
        let mut avatar = Avatar::from_bytes(bytes).map_err(js_error)?;
        let Some(shown) = &mut self.shown else {
            return Ok(());
        };
        let levels = std::mem::take(&mut avatar.levels);
        match shown.renderer.replace_avatar(AvatarId::FIRST, &avatar) {
            Ok(false) => {
                return Err(js_error(
                    "the file has changed while it was loaded: load it again",
                ));
            }
            // A lost device is replaced by one with the whole avatar.
            Ok(true) | Err(Error::DeviceLost(_)) => {}
            Err(error) => return Err(js_error(error)),
        }
        shown.avatar = avatar;
        shown.levels = levels;
        self.previous = Previous::Dropped;
        self.stale = true;
        Ok(())
    }

    /// Shows the avatar from before [`Self::show`] again, if it was kept.
    pub fn revert(&mut self) -> Result<(), JsValue> {
        let previous = std::mem::replace(&mut self.previous, Previous::Dropped);
        if matches!(previous, Previous::Dropped) {
            return Ok(());
        }
        self.stale = true;
        self.shown = None;
        if let Previous::Avatar(mut drawable) = previous {
            if !Arc::ptr_eq(drawable.renderer.gpu(), &self.surface.gpu) {
                self.upload_again(&mut drawable, &self.surface)
                    .map_err(js_error)?;
            }
            self.fit(&mut drawable).map_err(js_error)?;
            self.shown = Some(*drawable);
        }
        Ok(())
    }

    /// Adds the clip of a motion file, given its bytes. Returns its index.
    pub fn add_clip(&mut self, bytes: &[u8]) -> Result<usize, JsValue> {
        let clip = Clip::from_bytes(bytes).map_err(js_error)?;
        let shown = self.shown.as_mut().ok_or_else(|| js_error(NO_AVATAR))?;
        shown.motion.add(clip, &shown.avatar).map_err(js_error)
    }

    /// Shows a clip at a time, seconds.
    pub fn seek(&mut self, clip: usize, seconds: f64) {
        if let Some(shown) = &mut self.shown {
            shown.motion.seek(clip, seconds);
        }
    }

    /// Moves to a live pose that arrives at `now`, ms. `rotation`: axis-angle, radians, three
    /// numbers a joint. `translation`: of the root, metres, three numbers. `expression`: missing
    /// numbers are 0.
    pub fn set_pose(
        &mut self,
        now: f64,
        rotation: &[f32],
        translation: &[f32],
        expression: &[f32],
    ) -> Result<(), JsValue> {
        let Some(shown) = &mut self.shown else {
            return Ok(());
        };
        shown
            .motion
            .set_pose(now, rotation, translation, expression)
            .map_err(|InvalidPose(reason)| js_range_error(reason))
    }

    /// The point that the camera looks at, metres.
    pub fn set_target(&mut self, x: f64, y: f64, z: f64) {
        self.viewpoint.target = DVec3::new(x, y, z);
    }

    /// Where the camera stands around its target: yaw and pitch in radians, the distance in metres.
    pub fn set_orbit(&mut self, yaw: f64, pitch: f64, distance: f64) {
        self.viewpoint.yaw = yaw;
        self.viewpoint.pitch = pitch;
        self.viewpoint.distance = distance;
    }

    /// Vertical field of view, radians.
    pub fn set_fov(&mut self, fov: f64) {
        self.viewpoint.fov = fov;
    }

    /// Colour behind the avatar: display-referred red, green and blue, 0 to 1.
    pub fn set_background(&mut self, red: f32, green: f32, blue: f32) {
        self.viewpoint.background = [red, green, blue];
        self.stale = true;
    }

    /// Whether the networks get each pose projected onto the training poses, or as it is.
    pub fn set_projection(&mut self, on: bool) {
        self.project = on;
    }

    /// Takes over the canvas's width and height.
    pub fn resize(&mut self) -> Result<(), JsValue> {
        let size = self.surface.size();
        if size == self.size {
            return Ok(());
        }
        if let Some(DrawableAvatar {
            renderer, present, ..
        }) = &mut self.shown
        {
            renderer.resize(size).map_err(js_error)?;
            present.set_image(&self.surface.gpu, renderer.image_view());
        }
        self.surface.configure(size);
        self.size = size;
        self.stale = true;
        Ok(())
    }

    /// Draws a frame with the next call of [`Self::draw`], even if nothing has changed.
    pub fn redraw(&mut self) {
        self.stale = true;
    }

    /// Draws a frame for `now`, ms, if anything has changed.
    pub fn draw(&mut self, now: f64) -> Result<Drawn, JsValue> {
        let Some(DrawableAvatar {
            avatar,
            renderer,
            present,
            motion,
            ..
        }) = &mut self.shown
        else {
            return Ok(Drawn::Nothing);
        };
        self.surface.gpu.check().map_err(js_error)?;
        if !renderer.ready() {
            return Ok(Drawn::Later);
        }
        let Viewpoint {
            target,
            yaw,
            pitch,
            distance,
            fov,
            background,
        } = self.viewpoint;
        let posed = Posed::with_projection(avatar, &motion.pose(now), self.project);
        let camera = Camera {
            near: renderer.bounds().framing(&posed.joints).near,
            ..Camera::orbit(
                target,
                yaw,
                pitch.clamp(-PITCH_MAX, PITCH_MAX),
                distance,
                fov,
                self.size,
            )
        };
        self.stale |= renderer.draw(&posed, &camera).map_err(js_error)?;
        if !self.stale {
            return Ok(Drawn::Nothing);
        }
        use wgpu::CurrentSurfaceTexture::{Lost, Outdated, Suboptimal, Success};
        let texture = match self.surface.surface.get_current_texture() {
            Success(texture) | Suboptimal(texture) => texture,
            Lost | Outdated => {
                self.surface.configure(self.size);
                return Ok(Drawn::Later);
            }
            _ => return Ok(Drawn::Later),
        };
        present.draw(
            &self.surface.gpu,
            &texture.texture.create_view(&Default::default()),
            background,
        );
        self.surface.gpu.queue.present(texture);
        self.stale = false;
        Ok(Drawn::Frame)
    }

    /// Draws small images of the avatar from its levels of detail, in the frames from now on. It
    /// takes a share of the upload of the avatar: call it once its first frame was drawn, and after
    /// [`Self::complete`]. Without effect where there are none.
    pub fn add_levels(&mut self) -> Result<(), JsValue> {
        match &mut self.shown {
            Some(shown) => shown.add_levels().map_err(js_error),
            None => Ok(()),
        }
    }

    /// Whether the device is lost. Then nothing is drawn before [`Self::replace_device`].
    pub fn is_lost(&self) -> bool {
        matches!(self.surface.gpu.check(), Err(Error::DeviceLost(_)))
    }

    /// Draws with another device from now on, and uploads the avatar to it.
    pub fn replace_device(&mut self, surface: CanvasSurface) -> Result<(), JsValue> {
        surface.configure(self.size);
        if let Some(mut drawable) = self.shown.take() {
            let uploaded = self.upload_again(&mut drawable, &surface);
            self.shown = Some(drawable);
            if let Err(error) = uploaded {
                surface.close();
                return Err(js_error(error));
            }
        }
        self.surface = surface;
        self.stale = true;
        Ok(())
    }

    /// Closes the device, and frees everything on it. Nothing is drawn before
    /// [`Self::replace_device`].
    pub fn close_device(&self) {
        self.surface.close();
    }

    /// Durations and counts of the last finished frame, JSON; times are in milliseconds.
    pub fn statistics(&self) -> String {
        let Some(DrawableAvatar { renderer, .. }) = &self.shown else {
            return "{}".into();
        };
        let report = renderer.report();
        // Of both layers, where small avatars have one of their own.
        let stages: serde_json::Map<_, _> = report
            .stages
            .iter()
            .map(|&(name, _)| (name.to_owned(), stage_ms(&report.stages, name).into()))
            .collect();
        let counters: serde_json::Map<_, _> = report
            .counters
            .named()
            .map(|(name, count)| (name.to_owned(), count.into()))
            .collect();
        serde_json::json!({
            "device": self.surface.gpu.name(),
            "raster": renderer.options().method.map_or("", |method| method.name()),
            "stages": stages,
            "counters": counters,
            "options": Self::describe_options(renderer.options()),
            "version": env!("CARGO_PKG_VERSION"),
        })
        .to_string()
    }
}

impl AvatarCanvas {
    /// What renderers draw frames of the canvas's size with.
    fn options(&self) -> RendererOptions {
        RendererOptions {
            supersampling: self.drawing.supersampling,
            detail: self.drawing.detail,
            ..RendererOptions::new(self.size)
        }
    }

    /// Prepares an avatar. The one that is shown stays.
    fn candidate(&self, avatar: Avatar) -> Result<UploadedAvatar, JsValue> {
        let candidate = self.surface.candidate(avatar, self.options());
        candidate.map_err(js_error)
    }

    /// Uploads an avatar to another device.
    fn upload_again(
        &self,
        drawable: &mut DrawableAvatar,
        surface: &CanvasSurface,
    ) -> Result<(), Error> {
        drawable.complete_avatar();
        let renderer = surface.renderer(&drawable.avatar, self.options())?;
        drawable.present = surface.present(&renderer)?;
        drawable.renderer = renderer;
        Ok(())
    }

    /// Gives a renderer the size of the canvas.
    fn fit(&self, drawable: &mut DrawableAvatar) -> Result<(), Error> {
        if drawable.renderer.options().size != self.size {
            drawable.renderer.resize(self.size)?;
            drawable
                .present
                .set_image(&self.surface.gpu, drawable.renderer.image_view());
        }
        Ok(())
    }

    /// Options, in the form of the reports of `effigy bench`.
    fn describe_options(options: &RendererOptions) -> serde_json::Value {
        serde_json::json!({
            "color": format!("{:?}", options.color()).to_lowercase(),
            "raster": options.method.map_or("", |method| method.name()),
            "skip": options.skip.to_string(),
            "cutoff": options.cutoff,
            "detail": options.detail.to_string(),
            "supersample": options.supersampling.to_string(),
            "rows": 1.0,
            "hold": 1,
        })
    }
}

#[wasm_bindgen]
impl AvatarCanvas {
    /// The avatar and its clips, JSON: names, credit, joints, counts, bounds and durations.
    pub fn describe(&self) -> String {
        let Some(DrawableAvatar {
            avatar,
            renderer,
            motion,
            ..
        }) = &self.shown
        else {
            return "{}".into();
        };
        let joints = Posed::new(avatar, &motion.pose(0.0)).joints;
        let [min, max] = renderer.bounds().framing(&joints).bounds;
        let rows = [
            avatar.rotation_rows.gaussian.len(),
            avatar.scale_rows.gaussian.len(),
            avatar.color_rows.gaussian.len(),
        ];
        let clips: Vec<_> = motion
            .clips()
            .map(|clip| serde_json::json!({ "name": clip.name, "duration": clip.duration() }))
            .collect();
        serde_json::json!({
            "name": avatar.name,
            "credit": avatar.credit,
            "gaussians": avatar.gaussians.len(),
            "parts": avatar.parts.len(),
            "nodes": avatar.nodes.len(),
            "rows": rows,
            "joints": avatar.skeleton.name,
            "expression": avatar.inputs.expression,
            "bounds": [min.to_array(), max.to_array()],
            "stands": !avatar.is_static(),
            "clips": clips,
        })
        .to_string()
    }

    /// The skeleton of the avatar that is shown and the box of its Gaussians, JSON, for the library
    /// that reads motion of other bodies.
    pub fn skeleton(&self) -> Result<String, JsValue> {
        let Some(DrawableAvatar { avatar, .. }) = &self.shown else {
            return Err(js_error(NO_AVATAR));
        };
        let skeleton = &avatar.skeleton;
        let bounds = avatar.gaussians.bounds;
        let document = serde_json::json!({
            "joints": skeleton.name,
            "parents": skeleton.parent,
            "rest": skeleton.rest,
            "canonical": skeleton.canonical,
            "bounds": [bounds.min, bounds.max],
        });
        Ok(document.to_string())
    }

    /// The Gaussians of the avatar that is shown as far as its joints move them, 14 bytes each: three
    /// 16-bit coordinates in their box, four joints, and four weights of 255.
    pub fn skin(&self) -> Vec<u8> {
        let Some(DrawableAvatar { avatar, .. }) = &self.shown else {
            return vec![];
        };
        let gaussians = &avatar.gaussians;
        let joints = gaussians.joint.iter().zip(&gaussians.joint_weight);
        let points = gaussians.position.iter().zip(joints);
        let mut skin = Vec::with_capacity(14 * gaussians.len());
        for (position, (joint, weight)) in points {
            skin.extend(position.iter().flat_map(|number| number.to_ne_bytes()));
            skin.extend(joint);
            skin.extend(weight);
        }
        skin
    }
}

/// Whether the bytes of a file of Effigy's own are a clip, not an avatar.
#[wasm_bindgen]
pub fn is_motion(bytes: &[u8]) -> Result<bool, JsValue> {
    FileContent::is_clip(bytes).map_err(js_error)
}
