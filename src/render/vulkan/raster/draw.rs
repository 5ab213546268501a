//! Inputs of both raster methods.

use crate::vulkan::pipeline::FrameMemory;
use ash::vk;
use effigy_core::{
    frame::{Damage, SortVariant, passes::RenderTarget},
    scene::PixelRect,
};

/// Inputs of the stage.
#[derive(Clone, Copy)]
pub(crate) struct RasterInputs {
    /// Holds order and control, as the sort leaves them, and splats with their keys.
    pub memory: FrameMemory,
    /// The most splats that the buffers hold.
    pub capacity: u32,
    /// How pairs of splats and bins are sorted.
    pub sort: SortVariant,
}

/// The draw of a layer.
pub struct Draw<'a> {
    /// The image that it goes into.
    pub target: RenderTarget,
    /// Width and height of what is drawn, in the target's upper left corner, px.
    pub size: [u32; 2],
    /// Where in the ring of blocks the one with the image's size is, bytes.
    pub frame: u32,
    /// The control: holds the arguments of the indirect draw.
    pub control: vk::Buffer,
    /// The rectangles to clear and to draw.
    pub damage: &'a Damage,
    /// Whether to count fragments.
    pub count: bool,
}

impl Draw<'_> {
    /// The rectangle to clear.
    pub fn area(&self) -> vk::Rect2D {
        rect(self.damage.rect())
    }
}

/// A rectangle, which must not be empty, as Vulkan has it.
pub fn rect(pixels: PixelRect) -> vk::Rect2D {
    let size = pixels.max - pixels.min;
    vk::Rect2D {
        offset: vk::Offset2D {
            x: pixels.min.x as i32,
            y: pixels.min.y as i32,
        },
        extent: vk::Extent2D {
            width: size.x,
            height: size.y,
        },
    }
}
