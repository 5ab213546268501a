//! A canvas and a device that draws on it, and avatars that a device is asked to make room for.

use super::motion::Motion;
use crate::{
    avatar::Avatar,
    frame::RendererOptions,
    webgpu::{Error, Gpu, Renderer, present::Present},
};
use std::{pin::Pin, sync::Arc};
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::future_to_promise;
use web_sys::HtmlCanvasElement;

/// An avatar and what draws it.
pub struct Shown {
    pub avatar: Avatar,
    pub renderer: Renderer,
    pub present: Present,
    pub motion: Motion,
}

/// A canvas that is drawn on.
#[wasm_bindgen]
pub struct Screen {
    pub(super) canvas: HtmlCanvasElement,
    pub(super) gpu: Arc<Gpu>,
    pub(super) surface: wgpu::Surface<'static>,
    format: wgpu::TextureFormat,
}

/// An error as JavaScript has it.
pub fn thrown(error: impl std::fmt::Display) -> JsValue {
    js_sys::Error::new(&error.to_string()).into()
}

/// The error of an argument that is none.
pub fn out_of_range(error: impl std::fmt::Display) -> JsValue {
    js_sys::RangeError::new(&error.to_string()).into()
}

async fn opened(canvas: HtmlCanvasElement) -> Result<Screen, Error> {
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
    Ok(Screen { canvas, gpu, surface, format })
}

#[wasm_bindgen]
impl Screen {
    /// Opens a device for a canvas of its own.
    pub async fn open(canvas: HtmlCanvasElement) -> Result<Screen, JsValue> {
        opened(canvas).await.map_err(thrown)
    }

    /// A promise that is kept when the device is lost, whoever lost it: it says why.
    pub fn lost(&self) -> js_sys::Promise {
        let lost = self.gpu.lost();
        future_to_promise(async { Ok(lost.await.into()) })
    }

    /// Gives the device and all that it holds back.
    pub fn close(&self) {
        self.gpu.close();
    }

    /// Pixels that a side of a picture may have.
    pub fn longest(&self) -> u32 {
        self.gpu.device.limits().max_texture_dimension_2d
    }
}

impl Screen {
    pub fn size(&self) -> [u32; 2] {
        [self.canvas.width().max(1), self.canvas.height().max(1)]
    }

    pub fn configure(&self, [width, height]: [u32; 2]) {
        if let Some(config) = self.surface.get_default_config(&self.gpu.adapter, width, height) {
            let alpha_mode = wgpu::CompositeAlphaMode::Opaque;
            self.surface.configure(&self.gpu.device, &wgpu::SurfaceConfiguration { format: self.format, alpha_mode, ..config });
        }
    }

    pub fn renderer(&self, avatar: &Avatar, size: [u32; 2]) -> Result<(Renderer, Present), Error> {
        self.presented(Renderer::new(&self.gpu, avatar, RendererOptions::new(size))?)
    }

    fn presented(&self, renderer: Renderer) -> Result<(Renderer, Present), Error> {
        let present = Present::new(&self.gpu, renderer.picture_view(), self.format)?;
        Ok((renderer, present))
    }

    /// Makes room for an avatar, and what draws it.
    pub fn candidate(&self, avatar: Avatar) -> Result<Candidate, Error> {
        let watch = self.gpu.watch();
        let made = Renderer::empty(&self.gpu, &avatar, RendererOptions::new(self.size())).and_then(|renderer| self.presented(renderer));
        let told = Box::pin(watch.end());
        let (renderer, present) = made?;
        let motion = Motion::new(&avatar);
        Ok(Candidate { gpu: self.gpu.clone(), shown: Shown { avatar, renderer, present, motion }, told: Some(told) })
    }
}

/// An avatar that may take the place of another, once it is filled.
#[wasm_bindgen]
pub struct Candidate {
    pub(super) gpu: Arc<Gpu>,
    pub(super) shown: Shown,
    /// Ends once the device has told whether it made room.
    told: Option<Pin<Box<dyn Future<Output = Result<(), Error>>>>>,
}

#[wasm_bindgen]
impl Candidate {
    /// Fills the room with the avatar. The promise is kept when the device has made all of it, and broken when it can't.
    pub fn fill(&mut self) -> Result<js_sys::Promise, JsValue> {
        let watch = self.gpu.watch();
        let taken = self.shown.renderer.take(&self.shown.avatar);
        let filled = watch.end();
        taken.map_err(thrown)?;
        let told = self.told.take();
        Ok(future_to_promise(async move {
            if let Some(told) = told {
                told.await.map_err(thrown)?;
            }
            filled.await.map_err(thrown)?;
            Ok(JsValue::UNDEFINED)
        }))
    }
}
