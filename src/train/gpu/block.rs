//! What kernels know of a view: `shaders/train/block.glsl`.

use super::tiling::BandTiling;
use crate::adam::{Adam, Rates};
use crate::loss::LossWeights;
use crate::parameters::ParameterLayout;
use crate::topology::Topology;
use crate::view::TrainingView;
use bytemuck::{Pod, Zeroable};
use effigy_core::avatar::Activation;
use effigy_core::constants::LEAKY_SLOPE;

/// Makes structs of the members of the shader's block.
macro_rules! blocks {
    ($($(#[$meta:meta])* $name:ident { $($field:ident: $type:ty,)* })*) => {
        $(
            $(#[$meta])*
            #[repr(C)]
            #[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
            pub struct $name { $(pub $field: $type,)* }
        )*
    };
}

blocks! {
    /// The mirror of `ViewBlock` in `shaders/train/block.glsl`, which says what each member is.
    #[expect(missing_docs, reason = "the shader says what each member is")]
    ViewBlock {
        camera: CameraBlock,
        low_pass: LowPassBlock,
        losses: LossBlock,
        counts: CountBlock,
        image: ImageBlock,
        networks: NetworkBlock,
        update: UpdateBlock,
        window: WindowBlock,
    }

    /// From `view_rows` to `gain`.
    CameraBlock {
        view_rows: [[f32; 4]; 3],
        focal: [f32; 2],
        center: [f32; 2],
        slope_min: [f32; 2],
        slope_max: [f32; 2],
        near: f32,
        spare_near: [f32; 3],
        gain: [f32; 3],
        spare_gain: f32,
    }

    /// `low_pass`.
    LowPassBlock {
        variance: f32,
        is_compensated: f32,
        hidden_slope: f32,
        spare: f32,
    }

    /// `loss_weights` and `corrective_weights`.
    LossBlock {
        l1: f32,
        scale: f32,
        scale_above: f32,
        image_loss: f32,
        correctives: [f32; 3],
        spare: f32,
    }

    /// `counts`.
    CountBlock {
        gaussians: u32,
        nodes: u32,
        parts: u32,
        head_parts: u32,
    }

    /// From `image_size` to `band`.
    ImageBlock {
        size: [u32; 2],
        tiles: [u32; 2],
        view: u32,
        views: u32,
        pair_capacity: u32,
        has_correctives: u32,
        first_row: u32,
        end_row: u32,
        is_first_band: u32,
        is_last_band: u32,
    }

    /// From `layer_inputs` to `network`.
    NetworkBlock {
        layer_inputs: [u32; 4],
        layer_outputs: [u32; 4],
        layer_weights: [u32; 4],
        layer_biases: [u32; 4],
        layer_results: [u32; 4],
        activations: u32,
        inputs: u32,
        expression_start: u32,
        joints: u32,
        layers: u32,
        asks_joints: u32,
        scale_bases: u32,
        color_bases: u32,
    }

    /// From `rates_gaussian` to `adam_correction`.
    UpdateBlock {
        rotation: f32,
        log_scale: f32,
        opacity: f32,
        color: f32,
        node_offset: f32,
        node_basis: f32,
        network: f32,
        weight_decay: f32,
        bases: [f32; 3],
        spare_bases: f32,
        beta_1: f32,
        beta_2: f32,
        epsilon: f32,
        spare_adam: f32,
        main_correction: [f32; 2],
        corrective_correction: [f32; 2],
    }

    /// `window`.
    WindowBlock {
        first: [u32; 2],
        size: [u32; 2],
    }
}

/// Bytes from one view's block to the next: a multiple of every device's alignment.
pub const STRIDE: u64 = 512;
const _: () = assert!(size_of::<ViewBlock>() as u64 <= STRIDE);

/// What a step computes and learns, apart from its views.
#[derive(Clone, Copy, Debug)]
pub struct StepOptions {
    /// Weights of the losses.
    pub weights: LossWeights,
    /// Whether there are correctives, and whether they learn.
    pub correctives: bool,
    /// Whether to compute the derivative with respect to the joints' transforms.
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

/// A band of a view of a step.
#[derive(Clone, Copy, Debug)]
pub(super) struct ViewBand {
    /// Index of the view.
    pub view: usize,
    /// Index of the band.
    pub band: u32,
    /// Views of the step.
    pub views: usize,
    /// The weight of the derivative of the view's image that another loss adds.
    pub image_loss: f64,
    /// The part of the view that the loss sees, where a kernel works it out.
    pub window: WindowBlock,
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
        layout: &ParameterLayout,
        view: &TrainingView,
        options: &StepOptions,
        tiling: BandTiling,
        band: ViewBand,
        updates: Updates,
    ) -> Self {
        Self {
            camera: CameraBlock::new(view),
            low_pass: LowPassBlock::new(topology),
            losses: LossBlock::new(&options.weights, layout.gaussians, view, band),
            counts: CountBlock {
                gaussians: layout.gaussians as u32,
                nodes: layout.nodes as u32,
                parts: layout.parts as u32,
                head_parts: topology.head_parts as u32,
            },
            image: ImageBlock {
                has_correctives: u32::from(options.correctives),
                ..ImageBlock::new(view.camera.size, tiling, band)
            },
            networks: NetworkBlock {
                asks_joints: u32::from(options.joints),
                ..NetworkBlock::new(topology, layout)
            },
            update: UpdateBlock::new(&options.rates, &options.adam, updates),
            window: band.window,
        }
    }
}

fn floats<const N: usize>(numbers: impl Into<[f64; N]>) -> [f32; N] {
    numbers.into().map(|number| number as f32)
}

impl CameraBlock {
    fn new(view: &TrainingView) -> Self {
        let camera = &view.camera;
        let matrix = camera.view.matrix3;
        let row = |axis: usize| {
            let row = matrix.row(axis);
            floats([row.x, row.y, row.z, camera.view.translation[axis]])
        };
        let [slope_min, slope_max] = camera.derivative_limits();
        Self {
            view_rows: [row(0), row(1), row(2)],
            focal: floats(camera.focal),
            center: floats(camera.center),
            slope_min: floats(slope_min),
            slope_max: floats(slope_max),
            near: camera.near as f32,
            gain: floats(view.gain),
            ..Self::default()
        }
    }
}

impl LowPassBlock {
    fn new(topology: &Topology) -> Self {
        Self {
            variance: topology.filter.variance as f32,
            is_compensated: f32::from(u8::from(topology.filter.compensated)),
            hidden_slope: match topology.activation {
                Activation::Relu => 0.0,
                Activation::LeakyRelu => LEAKY_SLOPE as f32,
            },
            spare: 0.0,
        }
    }
}

impl LossBlock {
    fn new(weights: &LossWeights, gaussians: usize, view: &TrainingView, band: ViewBand) -> Self {
        let views = band.views as f64;
        let channels = 3.0 * view.whole as f64;
        let count = gaussians as f64;
        Self {
            l1: (weights.l1 / (channels * views)) as f32,
            scale: (weights.scale / (3.0 * count * views)) as f32,
            scale_above: weights.scale_above as f32,
            image_loss: (band.image_loss / views) as f32,
            correctives: floats([
                weights.correctives[0] / (4.0 * count * views),
                weights.correctives[1] / (3.0 * count * views),
                weights.correctives[2] / (3.0 * count * views),
            ]),
            spare: 0.0,
        }
    }
}

impl ImageBlock {
    fn new(size: [u32; 2], tiling: BandTiling, band: ViewBand) -> Self {
        let rows = tiling.rows(size, band.band);
        Self {
            size,
            tiles: tiling.tiles(size),
            view: band.view as u32,
            views: band.views as u32,
            pair_capacity: tiling.pairs,
            has_correctives: 0,
            first_row: rows.start,
            end_row: rows.end,
            is_first_band: u32::from(band.band == 0),
            is_last_band: u32::from(band.band + 1 == tiling.bands),
        }
    }
}

impl NetworkBlock {
    fn new(topology: &Topology, layout: &ParameterLayout) -> Self {
        let mut block = Self {
            inputs: topology.widths[0] as u32,
            expression_start: topology.expression_start as u32,
            joints: topology.joints as u32,
            layers: topology.layers() as u32,
            scale_bases: layout.bases[1] as u32,
            color_bases: layout.bases[2] as u32,
            ..Self::default()
        };
        for (at, layer) in layout.layers.iter().enumerate() {
            block.layer_inputs[at] = layer.input as u32;
            block.layer_outputs[at] = layer.output as u32;
            block.layer_weights[at] = layer.weights as u32;
            block.layer_biases[at] = layer.biases as u32;
            block.layer_results[at] = block.activations;
            block.activations += layer.output as u32;
        }
        block
    }
}

impl UpdateBlock {
    fn new(rates: &Rates, adam: &Adam, updates: Updates) -> Self {
        Self {
            rotation: rates.rotation as f32,
            log_scale: rates.log_scale as f32,
            opacity: rates.opacity as f32,
            color: rates.color as f32,
            node_offset: rates.node_offset as f32,
            node_basis: rates.node_basis as f32,
            network: rates.network as f32,
            weight_decay: adam.weight_decay as f32,
            bases: floats(rates.bases),
            beta_1: adam.beta_1 as f32,
            beta_2: adam.beta_2 as f32,
            epsilon: adam.epsilon as f32,
            main_correction: floats(adam.correction(updates.main)),
            corrective_correction: floats(adam.correction(updates.correctives)),
            ..Self::default()
        }
    }
}
