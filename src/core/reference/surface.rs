//! Where what a pixel shows lies in another frame: the front surface, carried exactly by the motion
//! of the Gaussians that the pixel shows.
//!
//! A Gaussian shows at a pixel where it is densest along the pixel's ray ([`RayGaussian::peak`]).
//! That point moves with its Gaussian: its place along the axes, in standard deviations, stays.
//! What a pixel shows is the mean of these points by their blending weights.

use super::{
    project,
    project::Gaussian,
    raster::{Band, DrawnSplat},
    ray::RayGaussian,
    sort,
};
use crate::{
    avatar::Filter,
    each,
    scene::{Camera, PixelRect},
};
use glam::{DMat3, DVec2, DVec3};

/// Light left over at which a pixel is done: what lies behind shows less than this.
const LIGHT_MIN: f64 = 1e-3;

/// What the surface is seen in.
#[derive(Clone, Copy)]
pub struct SurfaceView<'a> {
    /// The Gaussians of a frame in the posed world; in all frames in one order.
    pub gaussians: &'a [Gaussian],
    /// The camera of the frame.
    pub camera: &'a Camera,
    /// The low-pass that it is drawn with.
    pub filter: Filter,
}

/// What a pixel shows of the surface, and where that lies in another frame. Means are by blending
/// weights; they are 0 where the pixel shows nothing.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Carried {
    /// Share of the pixel that Gaussians cover, 0 to 1.
    pub coverage: f32,
    /// Mean depth, metres.
    pub depth: f32,
    /// Mean place in the other frame, px from the top left corner of its image.
    pub at: [f32; 2],
    /// Mean depth in the other frame, metres.
    pub depth_there: f32,
    /// Root mean square distance of the places from their mean, px. It is large where one pixel
    /// shows surfaces that part, and infinite where some of them are not before the other camera.
    pub spread: f32,
}

/// Carries what each pixel of a rectangle of a frame shows to another frame; row by row from the
/// top left. `samples`: rays a pixel along each axis, 1, 2, 4 or 8. With more than one the surface
/// is that of the image drawn so many times as large, and each pixel has the mean of its rays.
///
/// # Panics
/// Where the frames have different numbers of Gaussians.
pub fn carry(from: &SurfaceView, to: &SurfaceView, rect: PixelRect, samples: u32) -> Vec<Carried> {
    assert_eq!(
        from.gaussians.len(),
        to.gaussians.len(),
        "what is carried is in both frames"
    );
    let camera = from.camera.cropped(rect);
    let camera = camera.stretched(camera.size.map(|side| samples * side));
    let surfels = surfels(from, to, &camera);
    let scale = f64::from(samples);
    let samples = samples as usize;
    let width = (rect.max.x - rect.min.x) as usize;
    let bands = Band::of(camera.size);
    let pixels: Vec<Vec<Carried>> = each::map(bands.len(), |at| {
        let band = &bands[at];
        let mut light = vec![1.0; band.pixels()];
        let mut sums = vec![CarriedSums::default(); band.pixels() / (samples * samples)];
        for surfel in &surfels {
            surfel.ellipse.each_pixel(band, |at, place, alpha| {
                let weight = alpha * light[at];
                if light[at] < LIGHT_MIN {
                    return;
                }
                light[at] *= 1.0 - alpha;
                let row = at / (width * samples) / samples;
                let column = at % (width * samples) / samples;
                let here = place / scale + rect.min.as_dvec2();
                sums[row * width + column].add(weight, here, surfel, &camera, place, to.camera);
            });
        }
        let first = band.rows.start / samples;
        let carried = |(at, sum): (usize, &CarriedSums)| {
            let pixel = DVec2::new((at % width) as f64, (first + at / width) as f64);
            sum.carried(pixel + 0.5 + rect.min.as_dvec2(), scale * scale)
        };
        sums.iter().enumerate().map(carried).collect()
    });
    pixels.concat()
}

/// A Gaussian as it is seen in one frame, with its way to another.
struct Surfel {
    ellipse: DrawnSplat,
    ray: RayGaussian,
    /// Its mean in camera coordinates, metres.
    mean: DVec3,
    /// The mean in the other frame's camera coordinates, metres.
    mean_there: DVec3,
    /// From around the mean in camera coordinates to around the mean in the other frame's.
    motion: DMat3,
}

/// The Gaussians that a frame shows, near to far. `camera`: its camera, or one that sees a part of
/// it enlarged.
fn surfels(from: &SurfaceView, to: &SurfaceView, camera: &Camera) -> Vec<Surfel> {
    let splats = project::splats(from.gaussians, camera, from.filter, 0);
    let order = sort::order(&splats);
    let near_to_far = each::map(order.len(), |at| {
        let k = order[order.len() - 1 - at] as usize;
        let own = &from.gaussians[k];
        let other = &to.gaussians[k];
        Some(Surfel {
            ellipse: DrawnSplat::new(splats[k].as_ref().ok()?, camera),
            ray: RayGaussian::new(own, camera, from.filter.into()),
            mean: camera.view.transform_point3(own.mean),
            mean_there: to.camera.view.transform_point3(other.mean),
            motion: to.camera.view.matrix3
                * moved(own.axes, other.axes)
                * camera.view.matrix3.inverse(),
        })
    });
    near_to_far.into_iter().flatten().collect()
}

/// The linear map from one posture of a Gaussian to another; none where it has no inverse.
fn moved(from: DMat3, to: DMat3) -> DMat3 {
    let motion = to * from.inverse();
    if motion.is_finite() {
        motion
    } else {
        DMat3::IDENTITY
    }
}

/// The sums that a [`Carried`] is computed from.
#[derive(Clone, Copy, Default)]
struct CarriedSums {
    weight: f64,
    /// Weight of what is not before the other camera.
    lost: f64,
    depth: f64,
    depth_there: f64,
    /// Displacement, px.
    way: DVec2,
    /// Its square.
    square: f64,
}

impl CarriedSums {
    /// Adds what a surfel shows at a place. `here`: the place in the frame's image, px; `place`:
    /// the same in the image of `camera`.
    fn add(
        &mut self,
        weight: f64,
        here: DVec2,
        surfel: &Surfel,
        camera: &Camera,
        place: DVec2,
        other: &Camera,
    ) {
        let ray = camera.ray(place);
        let depth = surfel.ray.peak(ray);
        let there = surfel.mean_there + surfel.motion * (depth * ray - surfel.mean);
        self.weight += weight;
        self.depth += weight * depth;
        if there.z < other.near {
            self.lost += weight;
            return;
        }
        let way = other.project(there) - here;
        self.depth_there += weight * there.z;
        self.way += weight * way;
        self.square += weight * way.length_squared();
    }

    /// `center`: of the pixel in the frame's image, px; `rays`: how many it has.
    fn carried(&self, center: DVec2, rays: f64) -> Carried {
        if self.weight == 0.0 {
            return Carried::default();
        }
        let way = self.way / self.weight;
        let variance = (self.square / self.weight - way.length_squared()).max(0.0);
        let spread = if self.lost > LIGHT_MIN * self.weight {
            f64::INFINITY
        } else {
            variance.sqrt()
        };
        Carried {
            coverage: (self.weight / rays) as f32,
            depth: (self.depth / self.weight) as f32,
            at: (center + way).as_vec2().to_array(),
            depth_there: (self.depth_there / self.weight) as f32,
            spread: spread as f32,
        }
    }
}
