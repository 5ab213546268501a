//! What kernels know of a view: `shaders/train/block.glsl`.

use crate::adam::{Adam, Rates};
use crate::loss::LossWeights;
use crate::parameters::Layout;
use crate::topology::Topology;
use crate::view::View;
use bytemuck::{Pod, Zeroable};
use effigy_core::avatar::Activation;
use effigy_core::constants::LEAKY_SLOPE;
use std::ops::Range;

/// The mirror of `ViewBlock` in `shaders/train/block.glsl`, which says what each member is.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
#[expect(missing_docs, reason = "the shader says what each member is")]
pub struct ViewBlock {
    pub view_rows: [[f32; 4]; 3],
    pub lens: [f32; 4],
    pub slopes: [f32; 4],
    pub near: [f32; 4],
    pub gain: [f32; 4],
    pub low_pass: [f32; 4],
    pub loss_weights: [f32; 4],
    pub corrective_weights: [f32; 4],
    pub counts: [u32; 4],
    pub image_size: [u32; 4],
    pub batch: [u32; 4],
    pub band: [u32; 4],
    pub layer_inputs: [u32; 4],
    pub layer_outputs: [u32; 4],
    pub layer_weights: [u32; 4],
    pub layer_biases: [u32; 4],
    pub layer_results: [u32; 4],
    pub sizes: [u32; 4],
    pub network: [u32; 4],
    pub rates_gaussian: [f32; 4],
    pub rates_other: [f32; 4],
    pub rates_bases: [f32; 4],
    pub adam: [f32; 4],
    pub adam_correction: [f32; 4],
}

/// Bytes from one view's block to the next: a multiple of every device's alignment.
pub const STRIDE: u64 = 512;
const _: () = assert!(size_of::<ViewBlock>() as u64 <= STRIDE);

/// What a step does besides looking at its views.
#[derive(Clone, Copy, Debug)]
pub struct StepOptions {
    /// Weights of the losses.
    pub weights: LossWeights,
    /// Whether there are correctives, and whether they learn.
    pub correctives: bool,
    /// Whether the derivative of the joints' transforms is asked for.
    pub joints: bool,
    /// Rates of Adam.
    pub rates: Rates,
    /// Adam's constants.
    pub adam: Adam,
}

impl StepOptions {
    /// Pictures alone count, and nothing is learned.
    pub const LOOK: Self = Self {
        weights: LossWeights {
            l1: 1.0,
            scale: 0.0,
            scale_above: 0.0,
            correctives: [0.0; 3],
        },
        correctives: true,
        joints: false,
        rates: Rates::NONE,
        adam: Adam::DEFAULT,
    };
}

/// How the image is cut, and how much room there is for pairs.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tiling {
    /// Side of a tile, px.
    pub side: u32,
    /// Room for the pairs of a band.
    pub pairs: u32,
    /// Bands of rows of tiles, one after the other where the pairs of all don't fit; at most
    /// [`MOST_BANDS`] and as many as there are rows.
    pub bands: u32,
}

/// Bands that a view may have.
pub(super) const MOST_BANDS: u32 = 64;

impl Tiling {
    /// Columns and rows of tiles of an image.
    pub fn tiles(&self, size: [u32; 2]) -> [u32; 2] {
        size.map(|side| side.div_ceil(self.side))
    }

    /// The rows of tiles of a band of an image.
    pub fn rows(&self, size: [u32; 2], band: u32) -> Range<u32> {
        let [_, rows] = self.tiles(size);
        let first = |band: u32| (u64::from(band) * u64::from(rows) / u64::from(self.bands)) as u32;
        first(band)..first(band + 1)
    }
}

/// Which of a step's views it is, of how many, which band of it, and whether another loss asks
/// something of it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    pub view: usize,
    pub band: u32,
    pub views: usize,
    pub asked: bool,
}

/// How often the numbers that learn from the start, and those of the correctives, have been
/// updated, this step included.
#[derive(Clone, Copy, Debug)]
pub(super) struct Updates {
    pub main: u64,
    pub correctives: u64,
}

impl ViewBlock {
    pub(super) fn new(
        topology: &Topology,
        layout: &Layout,
        view: &View,
        options: &StepOptions,
        tiling: Tiling,
        place: Place,
        updates: Updates,
    ) -> Self {
        let floats = |v: [f64; 4]| v.map(|v| v as f32);
        let camera = &view.camera;
        let matrix = camera.view.matrix3;
        let row = |axis: usize| {
            let row = matrix.row(axis);
            floats([row.x, row.y, row.z, camera.view.translation[axis]])
        };
        let [low, high] = camera.derivative_limits();
        let weights = &options.weights;
        let views = place.views as f64;
        let channels = 3.0 * view.whole as f64;
        let count = layout.gaussians as f64;
        let [columns, rows] = tiling.tiles(camera.size);
        let band = tiling.rows(camera.size, place.band);
        let layers = |of: &dyn Fn(usize) -> usize| {
            std::array::from_fn(|l| {
                if l < topology.layers() {
                    of(l) as u32
                } else {
                    0
                }
            })
        };
        let results: Vec<usize> = topology.widths[1..]
            .iter()
            .scan(0, |at, width| {
                let first = *at;
                *at += width;
                Some(first)
            })
            .collect();
        let rates = &options.rates;
        let adam = &options.adam;
        let [main_1, main_2] = adam.correction(updates.main);
        let [other_1, other_2] = adam.correction(updates.correctives);
        Self {
            view_rows: [row(0), row(1), row(2)],
            lens: floats([
                camera.focal.x,
                camera.focal.y,
                camera.center.x,
                camera.center.y,
            ]),
            slopes: floats([low.x, low.y, high.x, high.y]),
            near: floats([camera.near, 0.0, 0.0, 0.0]),
            gain: floats([view.gain.x, view.gain.y, view.gain.z, 0.0]),
            low_pass: floats([
                topology.filter.variance,
                f64::from(u8::from(topology.filter.compensated)),
                match topology.activation {
                    Activation::Relu => 0.0,
                    Activation::LeakyRelu => LEAKY_SLOPE,
                },
                0.0,
            ]),
            loss_weights: floats([
                weights.l1 / (channels * views),
                weights.scale / (3.0 * count * views),
                weights.scale_above,
                f64::from(u8::from(place.asked)) / views,
            ]),
            corrective_weights: floats([
                weights.correctives[0] / (4.0 * count * views),
                weights.correctives[1] / (3.0 * count * views),
                weights.correctives[2] / (3.0 * count * views),
                0.0,
            ]),
            counts: [
                layout.gaussians as u32,
                layout.nodes as u32,
                layout.parts as u32,
                topology.head_parts as u32,
            ],
            image_size: [camera.size[0], camera.size[1], columns, rows],
            batch: [
                place.view as u32,
                place.views as u32,
                tiling.pairs,
                u32::from(options.correctives),
            ],
            band: [
                band.start,
                band.end,
                u32::from(place.band == 0),
                u32::from(place.band + 1 == tiling.bands),
            ],
            layer_inputs: layers(&|l| topology.widths[l]),
            layer_outputs: layers(&|l| topology.widths[l + 1]),
            layer_weights: layers(&|l| layout.layers[l].weights),
            layer_biases: layers(&|l| layout.layers[l].biases),
            layer_results: layers(&|l| results[l]),
            sizes: [
                topology.widths[1..].iter().sum::<usize>() as u32,
                topology.widths[0] as u32,
                topology.expression_start as u32,
                topology.joints as u32,
            ],
            network: [
                topology.layers() as u32,
                u32::from(options.joints),
                layout.bases[1] as u32,
                layout.bases[2] as u32,
            ],
            rates_gaussian: floats([rates.rotation, rates.log_scale, rates.opacity, rates.color]),
            rates_other: floats([
                rates.node_offset,
                rates.node_basis,
                rates.network,
                adam.weight_decay,
            ]),
            rates_bases: floats([rates.bases[0], rates.bases[1], rates.bases[2], 0.0]),
            adam: floats([adam.beta_1, adam.beta_2, adam.epsilon, 0.0]),
            adam_correction: floats([main_1, main_2, other_1, other_2]),
        }
    }
}
