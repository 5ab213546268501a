//! Which pixels of a frame show what another frame shows too, and where that was.

use super::{image_part::ImagePart, residual::ResidualMap};
use crate::flip;
use effigy_core::{
    reference::{Carried, SurfaceView, carry},
    scene::{FrameImage, PixelRect},
};

/// Coverage from which on a pixel counts as one of the surface's: the silhouette runs through
/// pixels that are half covered, and they flicker most.
const COVERED: f32 = 0.5;
/// Most that the places of what a pixel shows may differ, px: more, and it shows surfaces that
/// part.
const SPREAD: f32 = 0.5;
/// Furthest from where it started that a place may come back to from the other frame, px.
const WAY_BACK: f32 = 0.5;
/// Most that the depth of a place may differ from what its pixel shows there, metres: more, and
/// something else is before it.
const DEPTH: f32 = 0.02;

/// A frame whose surface is known.
#[derive(Clone, Copy)]
pub struct SurfaceFrame<'a> {
    /// Its Gaussians and camera.
    pub view: SurfaceView<'a>,
    /// The part of the image that shows all of them, px; not empty.
    pub rect: PixelRect,
}

/// A pixel, and what of an earlier frame it shows.
#[derive(Clone, Copy, Debug, PartialEq)]
struct CarriedPixel {
    /// Index in the part of the later frame.
    pixel: usize,
    /// Place in the image of the earlier frame, px.
    was: [f32; 2],
}

/// The way of the surface from one frame to another.
pub struct Carrying {
    /// The part of the later frame that shows the surface.
    rect: PixelRect,
    pixels: Vec<CarriedPixel>,
    /// Covered pixels of the later frame.
    covered: usize,
}

impl Carrying {
    /// Carries the surface of a frame to a later one of the same Gaussians. `samples`: rays a pixel
    /// along each axis, 1, 2, 4 or 8, more where a pixel is larger than what it shows.
    pub fn new(earlier: &SurfaceFrame, later: &SurfaceFrame, samples: u32) -> Self {
        let back = carry(&later.view, &earlier.view, later.rect, samples);
        let forth = carry(&earlier.view, &later.view, earlier.rect, samples);
        let forth = CarriedPart {
            rect: earlier.rect,
            pixels: forth,
        };
        let width = (later.rect.max.x - later.rect.min.x) as usize;
        let mut pixels = Vec::new();
        let mut covered = 0;
        for (pixel, was) in back.iter().enumerate() {
            if was.coverage < COVERED {
                continue;
            }
            covered += 1;
            let center = [
                later.rect.min.x as usize + pixel % width,
                later.rect.min.y as usize + pixel / width,
            ]
            .map(|at| at as f32 + 0.5);
            if forth.shows(was, center) {
                pixels.push(CarriedPixel { pixel, was: was.at });
            }
        }
        Self {
            rect: later.rect,
            pixels,
            covered,
        }
    }

    /// How many pixels are compared.
    pub fn compared(&self) -> usize {
        self.pixels.len()
    }

    /// Pixels of the later frame that the surface covers at least half, whether or not they are
    /// compared.
    pub fn covered(&self) -> usize {
        self.covered
    }

    /// What is left between the image of the earlier frame, carried, and that of the later one.
    /// `flip`: whether to compute FLIP too.
    ///
    /// # Panics
    /// If `later` is not of the part that this was made with.
    pub fn residual(&self, earlier: &ImagePart, later: &ImagePart, flip: bool) -> ResidualMap {
        assert_eq!(
            later.rect, self.rect,
            "the image is of the part that the surface was carried to"
        );
        let shown: Vec<[f32; 4]> = later.displayed().into_iter().map(opaque).collect();
        let mut carried = shown.clone();
        let mut differences = Vec::with_capacity(self.pixels.len());
        for own in &self.pixels {
            let was = earlier.displayed_at(own.was);
            carried[own.pixel] = opaque(was);
            let is = shown[own.pixel];
            differences.push(std::array::from_fn(|k| was[k] as f32 - is[k]));
        }
        let flip = flip.then(|| {
            let image = |pixels| FrameImage {
                size: later.image.size,
                pixels,
            };
            let map = flip::map(&image(carried), &image(shown));
            let sum: f64 = self.pixels.iter().map(|own| map[own.pixel]).sum();
            sum / self.pixels.len().max(1) as f64
        });
        ResidualMap { differences, flip }
    }
}

/// A displayed colour as an opaque pixel.
fn opaque([r, g, b]: [f64; 3]) -> [f32; 4] {
    [r as f32, g as f32, b as f32, 1.0]
}

/// What a part of a frame shows, carried to another.
struct CarriedPart {
    rect: PixelRect,
    pixels: Vec<Carried>,
}

impl CarriedPart {
    /// Whether this frame shows what a pixel of the other frame shows, in the place where it was.
    /// `center`: of that pixel, px.
    fn shows(&self, was: &Carried, center: [f32; 2]) -> bool {
        let column = was.at[0] - self.rect.min.x as f32;
        let row = was.at[1] - self.rect.min.y as f32;
        let width = self.rect.max.x - self.rect.min.x;
        let height = self.rect.max.y - self.rect.min.y;
        let inside = (0.0..width as f32).contains(&column) && (0.0..height as f32).contains(&row);
        if !inside || was.spread > SPREAD {
            return false;
        }
        let own = &self.pixels[row as usize * width as usize + column as usize];
        if own.coverage < COVERED || own.spread > SPREAD {
            return false;
        }
        // The pixel's own centre is up to half a pixel from the place.
        let beside = [column.fract() - 0.5, row.fract() - 0.5];
        let missed = [0, 1].map(|axis| own.at[axis] + beside[axis] - center[axis]);
        missed[0].hypot(missed[1]) <= WAY_BACK && (own.depth - was.depth_there).abs() <= DEPTH
    }
}
