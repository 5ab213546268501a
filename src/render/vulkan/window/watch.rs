//! Checks an image now and then while frames go on: a frame's image is copied behind it, and read
//! some rows a frame, so that no frame waits for it.

use crate::vulkan::{
    commands::FRAMES_IN_FLIGHT,
    device::{error::Result, gpu::Gpu, recording::Recording},
    memory::{Buffer, copy_image},
    raster::{Raster, target::FINAL_LAYOUT},
};
use ash::vk;
use effigy_core::frame::ColorFormat;
use gpu_allocator::MemoryLocation;
use half::f16;
use std::sync::Arc;

/// An image is read in so many frames.
const STRIPS: usize = 16;

/// Counts of pixels in an image.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PixelCounts {
    /// Of an alpha above 0.
    pub covered: u64,
    /// Of which some number is NaN or infinite. Images of 8 bits can't hold one.
    pub broken: u64,
}

#[derive(Clone, Copy)]
enum State {
    Idle,
    /// Copied by a frame; so many more until that frame is done.
    Copying(usize),
    /// Number of strips read, and the counts in them.
    Reading(usize, PixelCounts),
}

/// Copies images of one renderer and reads them.
pub struct FrameValidator {
    buffer: Buffer,
    format: ColorFormat,
    pixels: usize,
    state: State,
}

impl FrameValidator {
    /// For images no larger than the one that `raster` has now.
    pub fn new(gpu: &Arc<Gpu>, raster: &Raster) -> Result<Self> {
        let [width, height] = raster.image().size;
        let format = raster.format();
        let size = (width as usize * height as usize * format.bytes()) as u64;
        let buffer = Buffer::new(
            gpu,
            "watched image",
            size,
            vk::BufferUsageFlags::TRANSFER_DST,
            MemoryLocation::GpuToCpu,
        )?;
        Ok(Self {
            buffer,
            format,
            pixels: 0,
            state: State::Idle,
        })
    }

    /// Whether it is free to look at another image.
    pub fn is_idle(&self) -> bool {
        matches!(self.state, State::Idle)
    }

    /// Copies the drawn part of the frame's image, from its upper left corner, px.
    ///
    /// # Safety
    /// It must be recorded after the frame, in its command buffer. The image must be alive until
    /// the frame is done.
    pub unsafe fn record(&mut self, commands: Recording, image: vk::Image, drawn: [u32; 2]) {
        // SAFETY: the frame leaves the image in that layout, and the caller promises that it is
        // alive; the buffer is large enough.
        unsafe { copy_image(commands, image, FINAL_LAYOUT, drawn, self.buffer.raw()) };
        self.pixels = drawn[0] as usize * drawn[1] as usize;
        self.state = State::Copying(FRAMES_IN_FLIGHT);
    }

    /// To be called after every frame that was submitted: reads on. Says what was seen once the
    /// image was read.
    pub fn step(&mut self) -> Option<PixelCounts> {
        match self.state {
            State::Idle => None,
            State::Copying(0) => {
                self.state = State::Reading(0, PixelCounts::default());
                None
            }
            State::Copying(frames) => {
                self.state = State::Copying(frames - 1);
                None
            }
            State::Reading(strip, seen) => {
                let bytes = self.format.bytes();
                let [from, to] =
                    [strip, strip + 1].map(|strip| bytes * (self.pixels * strip / STRIPS));
                let seen = sum(
                    seen,
                    count_pixels(self.format, &self.buffer.mapped()[from..to]),
                );
                let done = strip + 1 == STRIPS;
                self.state = if done {
                    State::Idle
                } else {
                    State::Reading(strip + 1, seen)
                };
                done.then_some(seen)
            }
        }
    }
}

fn sum(a: PixelCounts, b: PixelCounts) -> PixelCounts {
    PixelCounts {
        covered: a.covered + b.covered,
        broken: a.broken + b.broken,
    }
}

/// Counts in the bytes of some pixels.
fn count_pixels(format: ColorFormat, bytes: &[u8]) -> PixelCounts {
    match format {
        ColorFormat::Rgba8 => PixelCounts {
            covered: bytes.chunks_exact(4).filter(|pixel| pixel[3] > 0).count() as u64,
            broken: 0,
        },
        ColorFormat::Rgba16F => {
            let half =
                |pixel: &[u8], k: usize| f16::from_le_bytes([pixel[2 * k], pixel[2 * k + 1]]);
            let pixels = || bytes.chunks_exact(8);
            PixelCounts {
                covered: pixels().filter(|pixel| half(pixel, 3) > f16::ZERO).count() as u64,
                broken: pixels()
                    .filter(|pixel| (0..4).any(|k| !half(pixel, k).is_finite()))
                    .count() as u64,
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pixels_that_are_no_numbers_are_found() {
        let pixel = |r: f16, a: f16| [r, f16::ZERO, f16::ONE, a].map(f16::to_le_bytes).concat();
        let bytes = [
            pixel(f16::NAN, f16::ONE),
            pixel(f16::ZERO, f16::ZERO),
            pixel(f16::ONE, f16::INFINITY),
            pixel(f16::ONE, f16::ONE),
        ]
        .concat();
        assert_eq!(
            count_pixels(ColorFormat::Rgba16F, &bytes),
            PixelCounts {
                covered: 3,
                broken: 2
            }
        );
        assert_eq!(
            count_pixels(ColorFormat::Rgba8, &[9, 9, 9, 0, 0, 0, 0, 1]),
            PixelCounts {
                covered: 1,
                broken: 0
            }
        );
    }
}
