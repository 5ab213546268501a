//! The bound of a whole image, and how much of it a device's image uses.

use super::{
    features,
    pixel::{OrderedSplats, PixelBound, PixelLayer},
    rounding::{F32, Rounding},
    splats::{self, SplatInput, UncertainSplat},
};
use effigy_core::{
    avatar::{Avatar, Filter},
    constants::saturation_light,
    frame::{
        AvatarId, AvatarTraits, DEPTH_KEYS, FrameState, PlanInput, RendererOptions, Skip,
        atlas::AtlasSlot, capacity::Capacity, people::PlannedPerson, pose_cache::PoseCache,
        schedule::SATURATION_PIXELS,
    },
    reference,
    scene::{AvatarBounds, Camera, FrameImage, PartSet, PixelRect, Posed},
};
use glam::{DVec2, IVec2, UVec2};
use rayon::prelude::*;
use serde::Serialize;

/// A pixel fails if it is further from the reference than this many times its bound. The bound
/// counts errors to first order and errors of errors roughly; a hundredth is more than what that
/// leaves out where the bound is small, and nothing where it is not.
pub const SLACK: f64 = 1.01;
/// Errors no larger than this are none: the images that are compared are f32.
const NOTHING: f64 = 4.0 * f32::EPSILON as f64;
/// Roundings of f32 in a mean of up to 5 × 5 texels, and of the images that bounds are averaged in.
const AVERAGE_ROUNDINGS: f64 = 64.0;
/// A share of a texel up to this a device leaves out of a mean, px: NONE of `resolve.frag`.
const NO_SHARE: f64 = 1e-3;
/// A bound of at most this sees a fault of a tenth of a channel.
const TIGHT: f64 = 0.05;

/// A frame whose pixels are bounded.
#[derive(Clone, Copy)]
pub struct BoundScene<'a> {
    /// The avatar as the file has it.
    pub avatar: &'a Avatar,
    /// Its pose, in its place.
    pub posed: &'a Posed,
    /// Where it is seen from.
    pub camera: &'a Camera,
    /// Resolved options.
    pub options: &'a RendererOptions,
    /// The camera that filled the pose cache, if skinned Gaussians come from there.
    pub cached_by: Option<&'a Camera>,
}

impl BoundScene<'_> {
    /// The low-pass that is drawn with.
    pub fn filter(&self) -> Filter {
        self.options.filter.unwrap_or(self.avatar.filter)
    }
}

/// Every pixel's value by the reference and how far a device's may be from it.
#[derive(Clone, Debug)]
pub struct ImageBound {
    size: [u32; 2],
    pixels: Vec<PixelBound>,
}

/// How much of its bound an image uses.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct BoundUse {
    /// Largest error of any channel of any pixel, as a share of its bound.
    pub largest: f64,
    /// Column and row of that pixel.
    pub pixel: [u32; 2],
    /// Its channel, of red, green, blue and coverage.
    pub channel: usize,
    /// The error of that channel there, 0 to 1.
    pub error: f64,
    /// The bound of that error, 0 to 1.
    pub bound: f64,
    /// Lowest PSNR that the bound allows, dB, over covered pixels.
    pub allowed_db: f64,
    /// Share of covered pixels whose every channel is bound to within 0.05.
    pub tight: f64,
}

impl BoundUse {
    /// Whether every pixel is within its bound.
    pub fn holds(&self) -> bool {
        self.largest <= SLACK
    }
}

impl ImageBound {
    /// The bound of a frame.
    pub fn new(scene: &BoundScene, rounding: &Rounding) -> Self {
        let BoundScene {
            avatar,
            posed,
            camera,
            options,
            ..
        } = *scene;
        let bounds = AvatarBounds::new(avatar).filtered(options.filter);
        let traits = AvatarTraits::new(avatar, bounds);
        let bounds = &traits.bounds;
        let person = PlannedPerson {
            avatar: AvatarId::FIRST,
            traits: &traits,
            posed,
        };
        let plan = FrameState::default().plan(PlanInput {
            people: &[person],
            camera,
            options,
            capacity: Capacity::unlimited(1),
            always_submit: true,
        });
        // One avatar has one layer: the image, or an atlas that is averaged into it.
        let layer = match &plan.atlas {
            Some(atlas) => &atlas.layer,
            None => &plan.image,
        };
        let instance = layer.instances.first();
        let level = instance
            .and_then(|instance| instance.model.checked_sub(1))
            .map(|level| avatar.at_level(&avatar.levels[level]));
        let avatar = level.as_ref().unwrap_or(avatar);
        let camera = instance.map_or(camera, |instance| &instance.camera);
        let (stored, _, gaussians) = reference::stored(avatar, posed);
        let features = features::features(&stored, posed);
        let nodes = features::nodes(&stored, &features);
        let cache = scene
            .cached_by
            .map(|filled_by| PoseCache::new(bounds, posed, filled_by));
        let mut splats = splats::splats(&SplatInput {
            avatar,
            stored: &stored,
            posed,
            camera,
            limits: scene.camera.derivative_limits(),
            features: &features,
            nodes: &nodes,
            gaussians: &gaussians,
            bounds,
            depth_range: layer.depth_range,
            culled_parts: instance.map_or(PartSet::EMPTY, |instance| instance.culled_parts),
            culled: instance.is_none(),
            cache,
            low_pass: instance.map_or(scene.filter().into(), |instance| instance.low_pass),
            rounding,
        });
        if let Some(slot) = plan.atlas.as_ref().and_then(|atlas| atlas.slots.first()) {
            // What is not all inside its slot is cut off.
            let [min, max] = [slot.rect().min, slot.rect().max].map(|at| at.as_dvec2());
            for splat in &mut splats {
                let inside = (splat.center - splat.reach).cmpgt(min).all()
                    && (splat.center + splat.reach).cmplt(max).all();
                splat.may_vanish |= !inside;
            }
            let whole = PixelRect::whole(layer.size);
            return Self::of_splats(splats, layer.size, rounding, whole, false).averaged(
                slot,
                scene.camera.size,
                plan.drawn_rect,
                rounding,
            );
        }
        let tested = rounding.quads()
            && rounding.skip.contains(Skip::DEPTH)
            && layer.pixels_a_gaussian >= SATURATION_PIXELS;
        Self::of_splats(splats, camera.size, rounding, plan.drawn_rect, tested)
    }

    /// The bound of an image of a size whose pixels are means over this one, an atlas with a single
    /// slot. Beyond `drawn` a device may leave the image empty.
    fn averaged(
        &self,
        slot: &AtlasSlot,
        size: [u32; 2],
        drawn: PixelRect,
        rounding: &Rounding,
    ) -> Self {
        let mean = |of: fn(&PixelBound) -> [f64; 4]| {
            let atlas = FrameImage {
                size: self.size,
                pixels: self
                    .pixels
                    .iter()
                    .map(|pixel| of(pixel).map(|v| v as f32))
                    .collect(),
            };
            atlas.resampled(slot.factor, slot.around.sides().into())
        };
        let value = mean(|pixel| pixel.value);
        let below = mean(|pixel| pixel.below);
        let above = mean(|pixel| pixel.above);
        let mut pixels = vec![PixelBound::default(); size[0] as usize * size[1] as usize];
        let shown = slot.shown(size);
        for y in shown.min.y..shown.max.y {
            for x in shown.min.x..shown.max.x {
                let at = (IVec2::new(x as i32, y as i32) - slot.around.min).as_uvec2();
                let index = at.y as usize * value.size[0] as usize + at.x as usize;
                let pixel = &mut pixels[y as usize * size[0] as usize + x as usize];
                let edges = self.edge_error(at, slot.factor);
                for (channel, edge) in edges.into_iter().enumerate() {
                    let exact = f64::from(value.pixels[index][channel]);
                    let [below, above] =
                        [&below, &above].map(|off| f64::from(off.pixels[index][channel]));
                    let rounded = rounding.stored(exact + above) + AVERAGE_ROUNDINGS * F32 + edge;
                    pixel.value[channel] = exact;
                    pixel.above[channel] = above + rounded;
                    pixel.below[channel] = if contains(drawn, [x as usize, y as usize]) {
                        below + rounded
                    } else {
                        exact
                    };
                }
            }
        }
        Self { size, pixels }
    }

    /// How far the mean over a pixel's area may be off, channel by channel, because a device rounds
    /// the area's edges, in f32, and leaves out a thin share of a texel. An edge that is off by t
    /// moves t of the area's length on that axis from the mean to a texel at the edge, or back: two
    /// values between 0 and the brightest around.
    fn edge_error(&self, pixel: UVec2, factor: f64) -> [f64; 4] {
        let [begin, end] = [pixel, pixel + 1].map(|at| factor * at.as_dvec2());
        let last = DVec2::from(self.size.map(f64::from)) - 1.0;
        let from = (begin.floor() - 1.0).max(DVec2::ZERO).as_uvec2();
        let to = end.ceil().min(last).as_uvec2();
        let mut brightest = [0.0; 4];
        for y in from.y..=to.y {
            for x in from.x..=to.x {
                let texel = &self.pixels[(y * self.size[0] + x) as usize];
                for (channel, most) in brightest.iter_mut().enumerate() {
                    *most = f64::max(*most, texel.value[channel] + texel.above[channel]);
                }
            }
        }
        // The factor, its product, and the share of a texel are rounded.
        let moved = |at: f64, share: f64| {
            let rounded = 3.0 * F32 * at.max(1.0);
            if share <= NO_SHARE + rounded {
                share + rounded
            } else {
                rounded
            }
        };
        let off = |begin: f64, end: f64| {
            moved(begin, begin.floor() + 1.0 - begin) + moved(end, end - (end.ceil() - 1.0))
        };
        let off = (off(begin.x, end.x) + off(begin.y, end.y)) / factor;
        brightest.map(|most| most * off)
    }

    /// The bound of splats. `drawn`: where they are drawn; `tested`: against the saturation depth.
    fn of_splats(
        splats: Vec<UncertainSplat>,
        size: [u32; 2],
        rounding: &Rounding,
        drawn: PixelRect,
        tested: bool,
    ) -> Self {
        let ordered = OrderedSplats::new(splats, DEPTH_KEYS.largest());
        let width = size[0] as usize;
        let mut pixels = vec![PixelBound::default(); width * size[1] as usize];
        // Two rows of pixels share a row of samples of the saturation depth.
        pixels.par_chunks_mut(2 * width).enumerate().for_each_init(
            Vec::new,
            |layers, (pair, rows)| {
                layers.resize_with(rows.len(), Vec::new);
                layers.iter_mut().for_each(Vec::clear);
                for (row, layers) in layers.chunks_mut(width).enumerate() {
                    find_layers(&ordered, 2 * pair + row, drawn, layers);
                }
                let saturated = if tested {
                    saturated_keys(&ordered, layers, width, saturation_light(rounding.cutoff))
                } else {
                    vec![0.0; width.div_ceil(2)]
                };
                for (at, (pixel, layers)) in rows.iter_mut().zip(layers).enumerate() {
                    *pixel = ordered.blend(layers, rounding, saturated[at % width / 2]);
                }
            },
        );
        Self { size, pixels }
    }

    /// The reference's image.
    pub fn reference(&self) -> FrameImage {
        FrameImage {
            size: self.size,
            pixels: self
                .pixels
                .iter()
                .map(|pixel| pixel.value.map(|v| v as f32))
                .collect(),
        }
    }

    /// Compares an image with the bound.
    ///
    /// # Panics
    /// If the sizes differ.
    pub fn used_by(&self, image: &FrameImage) -> BoundUse {
        assert_eq!(image.size, self.size, "the bound is of another image");
        let mut used = BoundUse {
            largest: 0.0,
            pixel: [0; 2],
            channel: 0,
            error: 0.0,
            bound: 0.0,
            allowed_db: f64::INFINITY,
            tight: 1.0,
        };
        let [mut squares, mut covered, mut tight] = [0.0, 0.0, 0.0];
        for (at, (bound, pixel)) in self.pixels.iter().zip(&image.pixels).enumerate() {
            let mut widest: f64 = 0.0;
            for (channel, &drawn) in pixel.iter().enumerate() {
                let difference = f64::from(drawn) - bound.value[channel];
                let allowed = if difference < 0.0 {
                    bound.below[channel]
                } else {
                    bound.above[channel]
                };
                let most = bound.below[channel].max(bound.above[channel]);
                widest = widest.max(most);
                if bound.value[3] >= effigy_core::constants::ALPHA_MIN {
                    squares += if channel < 3 { most * most } else { 0.0 };
                }
                let error = difference.abs();
                let share = if error.is_nan() {
                    f64::INFINITY
                } else if error <= NOTHING {
                    0.0
                } else {
                    error / allowed.max(f64::MIN_POSITIVE)
                };
                if share > used.largest {
                    used.largest = share;
                    used.pixel = [at as u32 % self.size[0], at as u32 / self.size[0]];
                    used.channel = channel;
                    used.error = error;
                    used.bound = allowed;
                }
            }
            if bound.value[3] >= effigy_core::constants::ALPHA_MIN {
                covered += 1.0;
                tight += if widest <= TIGHT { 1.0 } else { 0.0 };
            }
        }
        if covered > 0.0 {
            used.allowed_db = -10.0 * (squares / (3.0 * covered)).log10();
            used.tight = tight / covered;
        }
        used
    }
}

fn contains(rect: PixelRect, pixel: [usize; 2]) -> bool {
    let at = UVec2::from(pixel.map(|v| v as u32));
    rect.min.cmple(at).all() && at.cmplt(rect.max).all()
}

/// The largest key at which each sample of a row of samples may be saturated. `layers`: of each
/// pixel of the rows that the samples stand for, two or at the image's end one.
fn saturated_keys(
    ordered: &OrderedSplats,
    layers: &[Vec<PixelLayer>],
    width: usize,
    threshold: f64,
) -> Vec<f64> {
    let key = |sample: usize| {
        let around: Vec<&[PixelLayer]> = layers
            .chunks(width)
            .flat_map(|row| &row[2 * sample..(2 * sample + 2).min(width)])
            .map(Vec::as_slice)
            .collect();
        ordered.saturated_key(&around, threshold)
    };
    (0..width.div_ceil(2)).map(key).collect()
}

/// Appends the layers at each pixel of a row, nearest first. Beyond `drawn` a device may leave out
/// splats that stray. `all`: as many as the row has pixels.
fn find_layers(ordered: &OrderedSplats, row: usize, drawn: PixelRect, all: &mut [Vec<PixelLayer>]) {
    let y = row as f64 + 0.5;
    for (rank, splat) in ordered.splats.iter().enumerate() {
        if (y - splat.center.y).abs() > splat.reach.y {
            continue;
        }
        // The casts saturate.
        let from = (splat.center.x - splat.reach.x - 0.5).ceil().max(0.0) as usize;
        let end = (splat.center.x + splat.reach.x + 0.5).floor().max(0.0) as usize;
        let end = end.min(all.len());
        for (x, layers) in all[..end].iter_mut().enumerate().skip(from) {
            if let Some(mut alpha) = splat.alpha(DVec2::new(x as f64 + 0.5, y)) {
                if splat.strays && !contains(drawn, [x, row]) {
                    alpha.low = 0.0;
                }
                layers.push(PixelLayer {
                    rank: rank as u32,
                    alpha,
                });
            }
        }
    }
}
