//! A pixel blended on intervals: how far any device's value may be from the reference's, below and
//! above, channel by channel.
//!
//! Let a splat i of opacity α and colour c lie behind transmittance T and before the colour B, all
//! as the reference has them. A device's value comes from the reference's in five steps:
//!
//! 1. Each α becomes the device's, the rearmost first: the value changes by T' (α' − α) (c − B),
//!    with T' of the device's α before it. This is exact, and so is the bound with the largest T'.
//! 2. Each colour becomes the device's: by at most the sum of T' α' δc, and T' α' sum to at most 1.
//! 3. The order becomes the device's, by swaps of neighbours. Each pair that ends up swapped is
//!    swapped once, which changes the value by T' α₁' α₂' (c₂ − c₁). Only pairs whose keys may be
//!    equal or swapped are counted, with the largest T' that splats surely before both leave.
//! 4. Splats behind a saturated pixel are left out: at most what transmittance is left. Tiles put
//!    the mean of what is before them in their place: at most as much more.
//! 5. Layers and values are rounded to the image's format; an error of a layer shows as much as
//!    what lies before it lets through.

use super::{
    rounding::{BYTE, F16, F32, Rounding},
    splats::{Alpha, UncertainSplat},
};
use effigy_core::frame::ColorFormat;

/// Error of a value rounded to 5 bits, as the saturation depth stores red and blue.
const FIVE_BITS: f64 = 0.5 / 31.0;

/// A splat at a pixel.
#[derive(Clone, Copy, Debug)]
pub struct PixelLayer {
    /// Its place among all splats, nearest first.
    pub rank: u32,
    pub alpha: Alpha,
}

/// A pixel's value, premultiplied RGBA, and how far a device's may be below and above it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PixelBound {
    pub value: [f64; 4],
    pub below: [f64; 4],
    pub above: [f64; 4],
}

impl PixelBound {
    /// Step 5: sums over so many layers, and the image's format.
    fn round(&mut self, layers: usize, rounding: &Rounding) {
        let sums = 4.0 * F32 * (layers as f64 + 4.0);
        for channel in 0..4 {
            let value = self.value[channel];
            let stored = if rounding.quads() {
                0.0
            } else {
                rounding.stored((value + self.above[channel]).min(1.0))
            };
            self.above[channel] = (self.above[channel] + sums).min(1.0 - value) + stored;
            self.below[channel] = (self.below[channel] + sums).min(value) + stored;
        }
    }
}

/// The splats of an image in the reference's order, nearest first.
pub struct OrderedSplats {
    pub splats: Vec<UncertainSplat>,
    /// The rank of the furthest splat that a device may draw in front of each.
    pub furthest: Vec<u32>,
    key_max: u32,
}

impl OrderedSplats {
    /// Sorts splats as the reference does: by depth, and larger indices before smaller ones.
    pub fn new(mut splats: Vec<UncertainSplat>, key_max: u32) -> Self {
        splats.sort_by(|a, b| {
            a.depth
                .total_cmp(&b.depth)
                .then(b.gaussian.cmp(&a.gaussian))
        });
        // The largest key of this splat and those behind it decides.
        let mut largest = vec![f64::NEG_INFINITY; splats.len() + 1];
        for at in (0..splats.len()).rev() {
            largest[at] = splats[at].key[1].max(largest[at + 1]);
        }
        let furthest = (0..splats.len())
            .map(|at| {
                let mut last = at;
                for behind in at + 1..splats.len() {
                    if splats[behind].may_pass(&splats[at], key_max) {
                        last = behind;
                    } else if largest[behind] < splats[at].key[0] - 1e-3 {
                        break;
                    }
                }
                last as u32
            })
            .collect();
        Self {
            splats,
            furthest,
            key_max,
        }
    }

    fn at(&self, layer: &PixelLayer) -> &UncertainSplat {
        &self.splats[layer.rank as usize]
    }

    /// Whether a device may draw the second of two layers in front of the first.
    fn may_swap(&self, nearer: &PixelLayer, further: &PixelLayer) -> bool {
        self.at(further).may_pass(self.at(nearer), self.key_max)
    }

    /// The largest key at which a device may find a sample saturated: what has a smaller key may be
    /// left out. 0 where that can't be. `around`: the layers at each of the pixels that the sample
    /// stands for; a splat counts by its least opacity there.
    pub fn saturated_key(&self, around: &[&[PixelLayer]], threshold: f64) -> f64 {
        let Some((first, others)) = around.split_first() else {
            return 0.0;
        };
        let least_opacity = |layer: &PixelLayer| {
            others.iter().try_fold(layer.alpha.high, |least, layers| {
                let at = layers.binary_search_by_key(&layer.rank, |l| l.rank).ok()?;
                Some(least.min(layers[at].alpha.high))
            })
        };
        let mut by_key: Vec<(f64, f64)> = first
            .iter()
            .filter_map(|layer| Some((self.at(layer).key[1], least_opacity(layer)?)))
            .collect();
        by_key.sort_by(|a, b| b.0.total_cmp(&a.0));
        let mut light = 1.0;
        for (key, opacity) in by_key {
            light *= 1.0 - opacity;
            if light < threshold * (1.0 + 1e-3) {
                return key + 1.0 / f64::from(self.key_max);
            }
        }
        0.0
    }

    /// Blends a pixel's layers, nearest first. Of what has a key below `lost_below` a device may
    /// leave out all that lies behind some depth; quads show the colour of a layer in its place.
    pub fn blend(
        &self,
        layers: &mut [PixelLayer],
        rounding: &Rounding,
        lost_below: f64,
    ) -> PixelBound {
        if rounding.quads() {
            quantize(layers, rounding);
        }
        let mut bound = PixelBound::default();
        // Back to front: what lies behind each layer.
        let mut behind = vec![[0.0; 4]; layers.len()];
        for (layer, behind) in layers.iter().zip(&mut behind).rev() {
            *behind = bound.value;
            let alpha = layer.alpha.exact;
            bound.value = over(alpha, self.color(layer), bound.value);
        }
        let reordered = self.swaps(layers, &mut bound);
        let mut light = 1.0;
        let mut weight: f64 = 0.0;
        let mut color_error: f64 = 0.0;
        let mut lost = None;
        let mut least = 1.0;
        for (layer, behind) in layers.iter().zip(&behind) {
            let splat = self.at(layer);
            if lost.is_none() && splat.key[0] < lost_below {
                lost = Some(light);
            }
            self.blend_layer(layer, *behind, light, rounding, &mut bound);
            let Alpha { low, high, .. } = layer.alpha;
            weight += light * high;
            color_error = color_error.max(splat.color_error);
            light *= 1.0 - low;
            least *= 1.0 - high;
            if least < rounding.saturated() && lost.is_none() {
                // In another order the light may fall under the threshold by less.
                lost = Some(if reordered {
                    rounding.saturated()
                } else {
                    light.min(rounding.saturated())
                });
            }
        }
        for channel in 0..3 {
            bound.above[channel] += color_error * weight.min(1.0);
            bound.below[channel] += color_error * weight.min(1.0);
        }
        // Quads are blended over such a colour also where nothing lies behind that depth.
        if rounding.quads() && lost_below > 0.0 {
            lost = lost.or(Some(light));
        }
        if let Some(lost) = lost {
            self.lose(lost, layers, rounding, &mut bound);
        }
        bound.round(layers.len(), rounding);
        bound
    }

    /// Steps 1 and 5 of a layer that `light` reaches at most. `behind`: the colour behind it.
    fn blend_layer(
        &self,
        layer: &PixelLayer,
        behind: [f64; 4],
        light: f64,
        rounding: &Rounding,
        bound: &mut PixelBound,
    ) {
        let Alpha { exact, low, high } = layer.alpha;
        let color = self.color(layer);
        for channel in 0..4 {
            let towards = color[channel] - behind[channel];
            let ends = [low - exact, high - exact].map(|by| by * towards);
            bound.above[channel] += light * ends[0].max(ends[1]).max(0.0);
            bound.below[channel] -= light * ends[0].min(ends[1]).min(0.0);
        }
        let rounded = self.rounded(layer, behind, rounding);
        for (channel, rounded) in rounded.into_iter().enumerate() {
            bound.above[channel] += light * rounded;
            bound.below[channel] += light * rounded;
        }
    }

    /// Step 4: a device may leave out what `lost` of the light would reach.
    fn lose(&self, lost: f64, layers: &[PixelLayer], rounding: &Rounding, bound: &mut PixelBound) {
        for channel in 0..4 {
            let most = lost * self.brightest(layers, channel);
            bound.below[channel] += most;
            // In its place tiles show more of what they have blended, and quads the colour of one
            // of the layers, in 5 bits.
            bound.above[channel] += if rounding.quads() {
                (most + lost * FIVE_BITS).min(lost)
            } else {
                most
            };
        }
    }

    fn color(&self, layer: &PixelLayer) -> [f64; 4] {
        self.at(layer).color.extend(1.0).to_array()
    }

    fn brightest(&self, layers: &[PixelLayer], channel: usize) -> f64 {
        layers
            .iter()
            .map(|layer| self.color(layer)[channel] + self.at(layer).color_error)
            .fold(0.0, f64::max)
            .min(1.0)
    }

    /// What blending a layer rounds. `behind`: what lies behind it.
    fn rounded(&self, layer: &PixelLayer, behind: [f64; 4], rounding: &Rounding) -> [f64; 4] {
        if !rounding.quads() || layer.alpha.high == 0.0 {
            return [0.0; 4];
        }
        let color = self.color(layer);
        std::array::from_fn(|channel| match rounding.color {
            // The colour, and each of the two products that are added.
            ColorFormat::Rgba8 => BYTE * (layer.alpha.high + 2.0),
            ColorFormat::Rgba16F => {
                let value = over(layer.alpha.high, color, behind)[channel];
                let most = value.max(over(layer.alpha.low, color, behind)[channel]);
                rounding.blend_roundings * rounding.stored((1.01 * most).min(1.0))
            }
        })
    }

    /// Step 3: pairs that may be swapped. Whether there are any.
    fn swaps(&self, layers: &[PixelLayer], bound: &mut PixelBound) -> bool {
        let mut any = false;
        let mut light = 1.0;
        // Layers before the current one that one behind it may pass.
        let mut open: Vec<&PixelLayer> = Vec::new();
        for (at, nearer) in layers.iter().enumerate() {
            // A channel can't be off by more: all pairs of hundreds that may be anywhere take long.
            let full = (0..3).all(|k| bound.above[k] >= 1.0 && bound.below[k] >= 1.0);
            if full {
                break;
            }
            open.retain(|layer| {
                let surely_before = self.furthest[layer.rank as usize] < nearer.rank;
                if surely_before {
                    light *= 1.0 - layer.alpha.low;
                }
                !surely_before
            });
            let furthest = self.furthest[nearer.rank as usize];
            for further in layers[at + 1..]
                .iter()
                .take_while(|layer| layer.rank <= furthest)
                .filter(|further| self.may_swap(nearer, further))
            {
                any = true;
                let [a, b] = [self.color(nearer), self.color(further)];
                let error = self.at(nearer).color_error + self.at(further).color_error;
                let share = light * nearer.alpha.high * further.alpha.high;
                for channel in 0..3 {
                    let change = b[channel] - a[channel];
                    bound.above[channel] += share * (change + error).max(0.0);
                    bound.below[channel] += share * (error - change).max(0.0);
                }
            }
            open.push(nearer);
        }
        any
    }
}

/// α c + (1 − α) B.
fn over(alpha: f64, color: [f64; 4], behind: [f64; 4]) -> [f64; 4] {
    std::array::from_fn(|channel| alpha * color[channel] + (1.0 - alpha) * behind[channel])
}

/// α as the blender sees it: rounded to the image's format.
fn quantize(layers: &mut [PixelLayer], rounding: &Rounding) {
    for layer in layers {
        let alpha = &mut layer.alpha;
        let step = match rounding.color {
            ColorFormat::Rgba8 => [BYTE; 2],
            ColorFormat::Rgba16F if rounding.blend_roundings > 1.0 => {
                [alpha.low * F16, alpha.high * F16]
            }
            ColorFormat::Rgba16F => [0.0; 2],
        };
        alpha.low = (alpha.low - step[0]).max(0.0);
        alpha.high = (alpha.high + step[1]).min(1.0);
    }
}
