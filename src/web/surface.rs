//! A canvas with a device that draws on it, and avatars that are uploaded to the device.

use crate::motion::AvatarMotion;
use effigy_core::{
    avatar::{Avatar, Level},
    frame::{AvatarId, RendererOptions},
};
use effigy_render::webgpu::{Error, Gpu, Renderer, present::Present};
use std::{pin::Pin, sync::Arc};
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::future_to_promise;
use web_sys::HtmlCanvasElement;

/// An avatar with its motion, and the stages that draw it.
pub struct DrawableAvatar {
    /// The avatar.
    pub avatar: Avatar,
    /// Its levels of detail, until the renderer has them: the first frame does not wait for them.
    pub levels: Vec<Level>,
    /// Draws it into an image.
    pub renderer: Renderer,
    /// Draws the image over a background on the canvas.
    pub present: Present,
    /// Its clips and its pose.
    pub motion: AvatarMotion,
}

impl DrawableAvatar {
    /// Draws small images from the levels of detail from now on.
    pub fn add_levels(&mut self) -> Result<(), Error> {
        self.complete_avatar();
        match self.renderer.add_levels(AvatarId::FIRST, &self.avatar) {
            Ok(_) => Ok(()),
            Err(error @ Error::DeviceLost(_)) => Err(error),
            Err(error) => {
                // It is drawn without them, also by a device that comes after this one.
                self.avatar.levels.clear();
                Err(error)
            }
        }
    }

    /// Gives the avatar the levels that the renderer has not got yet.
    pub fn complete_avatar(&mut self) {
        if !self.levels.is_empty() {
            self.avatar.levels = std::mem::take(&mut self.levels);
        }
    }
}

/// A canvas with a device that draws on it.
#[wasm_bindgen]
pub struct CanvasSurface {
    canvas: HtmlCanvasElement,
    pub(super) gpu: Arc<Gpu>,
    pub(super) surface: wgpu::Surface<'static>,
    format: wgpu::TextureFormat,
}

/// A JavaScript `Error`.
pub fn js_error(error: impl std::fmt::Display) -> JsValue {
    js_sys::Error::new(&error.to_string()).into()
}

/// A JavaScript `RangeError`.
pub fn js_range_error(error: impl std::fmt::Display) -> JsValue {
    js_sys::RangeError::new(&error.to_string()).into()
}

async fn open(canvas: HtmlCanvasElement) -> Result<CanvasSurface, Error> {
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor {
        backends: wgpu::Backends::BROWSER_WEBGPU,
        ..wgpu::InstanceDescriptor::new_without_display_handle()
    });
    let surface = instance.create_surface(wgpu::SurfaceTarget::Canvas(canvas.clone()));
    let surface = surface.map_err(|error| Error::NoDevice(error.to_string()))?;
    let gpu = Gpu::new(instance, None).await?;
    let formats = surface.get_capabilities(&gpu.adapter).formats;
    // Colours are display-referred: an sRGB format would convert them once more.
    let format = formats
        .iter()
        .copied()
        .find(|format| !format.is_srgb())
        .unwrap_or(wgpu::TextureFormat::Bgra8Unorm);
    Ok(CanvasSurface {
        canvas,
        gpu,
        surface,
        format,
    })
}

#[wasm_bindgen]
impl CanvasSurface {
    /// Opens a device for a canvas. Fails if the browser has none.
    pub async fn open(canvas: HtmlCanvasElement) -> Result<CanvasSurface, JsValue> {
        open(canvas).await.map_err(js_error)
    }

    /// A promise that resolves with the reason when the device is lost, on purpose or not.
    pub fn lost(&self) -> js_sys::Promise {
        let lost = self.gpu.lost();
        future_to_promise(async { Ok(lost.await.into()) })
    }

    /// Closes the device, and frees everything on it.
    pub fn close(&self) {
        self.gpu.close();
    }

    /// Largest width and height of a canvas on this device, px.
    pub fn max_side(&self) -> u32 {
        self.gpu.device.limits().max_texture_dimension_2d
    }
}

impl CanvasSurface {
    /// The canvas's width and height, px.
    pub fn size(&self) -> [u32; 2] {
        [self.canvas.width().max(1), self.canvas.height().max(1)]
    }

    /// Sets the size of the canvas's images, px.
    pub fn configure(&self, size: [u32; 2]) {
        let [width, height] = size;
        if let Some(config) = self
            .surface
            .get_default_config(&self.gpu.adapter, width, height)
        {
            let alpha_mode = wgpu::CompositeAlphaMode::Opaque;
            self.surface.configure(
                &self.gpu.device,
                &wgpu::SurfaceConfiguration {
                    format: self.format,
                    alpha_mode,
                    ..config
                },
            );
        }
    }

    /// A renderer with an avatar.
    pub fn renderer(&self, avatar: &Avatar, options: RendererOptions) -> Result<Renderer, Error> {
        Renderer::new(&self.gpu, avatar, options)
    }

    /// The stage that draws a renderer's image on the canvas.
    pub fn present(&self, renderer: &Renderer) -> Result<Present, Error> {
        Present::new(&self.gpu, renderer.image_view(), self.format)
    }

    /// Allocates buffers for an avatar, and creates the stages that draw it.
    pub fn candidate(
        &self,
        mut avatar: Avatar,
        options: RendererOptions,
    ) -> Result<UploadedAvatar, Error> {
        let levels = std::mem::take(&mut avatar.levels);
        let errors = self.gpu.watch();
        let allocated = self.allocate(&avatar, options);
        // Ended even if this failed: the device's error scopes are a stack.
        let errors = Box::pin(errors.end());
        let (renderer, present) = allocated?;
        let motion = AvatarMotion::new(&avatar);
        Ok(UploadedAvatar {
            gpu: self.gpu.clone(),
            drawable: DrawableAvatar {
                avatar,
                levels,
                renderer,
                present,
                motion,
            },
            allocation: Some(errors),
        })
    }

    fn allocate(
        &self,
        avatar: &Avatar,
        options: RendererOptions,
    ) -> Result<(Renderer, Present), Error> {
        let renderer = Renderer::empty(&self.gpu, avatar, options)?;
        let present = self.present(&renderer)?;
        Ok((renderer, present))
    }
}

/// An avatar that can replace the one that is shown, once it is uploaded.
#[wasm_bindgen]
pub struct UploadedAvatar {
    pub(super) gpu: Arc<Gpu>,
    pub(super) drawable: DrawableAvatar,
    /// Resolves once the device has reported whether it could allocate the buffers.
    allocation: Option<Pin<Box<dyn Future<Output = Result<(), Error>>>>>,
}

#[wasm_bindgen]
impl UploadedAvatar {
    /// Uploads the avatar. The promise resolves when all of it is on the device, and rejects if the
    /// device can't take it.
    pub fn upload(&mut self) -> Result<js_sys::Promise, JsValue> {
        let errors = self.gpu.watch();
        let written = self
            .drawable
            .renderer
            .upload(AvatarId::FIRST, &self.drawable.avatar);
        let upload = errors.end();
        written.map_err(js_error)?;
        let allocation = self.allocation.take();
        Ok(future_to_promise(async move {
            if let Some(allocation) = allocation {
                allocation.await.map_err(js_error)?;
            }
            upload.await.map_err(js_error)?;
            Ok(JsValue::UNDEFINED)
        }))
    }
}
