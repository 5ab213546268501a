//! The steps of a training on a device.

use super::arrays::placed_words;
use super::block::{STRIDE, StepOptions, Updates, ViewBand, ViewBlock, WindowBlock};
use super::buffers::{Batch, HostInputs, LossSums, TrainerBuffers, groups};
use super::image_loss::{AskedPart, ImageLoss};
use super::kernels::{KernelSource, Kernels};
use super::state::TrainerState;
use super::tiles::PairStage;
use super::tiling::{BandTiling, MAX_BANDS, TileShape};
use crate::parameters::{ParameterLayout, Parameters};
use crate::topology::{CorrectiveRows, Topology};
use crate::view::TrainingView;
use bytemuck::{bytes_of, cast_slice};
use effigy_core::layout::{TRAIN_BASES_WORKGROUP, TRAIN_BASIS, TRAIN_RECORD, TRAIN_WIDTH_MAX};
use effigy_perceptual::Perceptual;
use effigy_render::vulkan::compute::{Buffer, Recording, Scope};
use effigy_render::vulkan::{Error, Gpu, Result};
use glam::{DAffine3, DVec3};
use rayon::prelude::*;
use std::ops::Range;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Initial pair capacity per Gaussian; grows on demand.
const PAIRS_PER_GAUSSIAN: u32 = 4;
/// Smallest initial pair capacity.
const MIN_PAIRS: u32 = 1024;
/// Storage buffers that the kernel with the most of them binds.
const STORAGE_BUFFERS: u32 = 11;
/// Layers that the kernels know.
const LAYERS: usize = 4;

/// The losses of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepLosses {
    /// Mean of |image − picture| over all channels of all pixels of all views, before the step.
    pub l1: f64,
    /// Mean of its square.
    pub squared: f64,
    /// Most pairs of splats and tiles that a band of a view had.
    pub pairs: u32,
    /// Views in which no Gaussian was seen.
    pub empty_views: u32,
}

/// What another loss asks of a view's image.
#[derive(Clone, Copy, Default)]
struct Asked {
    weight: f64,
    window: WindowBlock,
}

/// A training on a device: steps of Adam along the derivative of pictures' losses.
///
/// Every sum has a fixed order: on one device, equal steps give equal bits.
pub struct Trainer {
    // Kernels go before what they are bound to.
    kernels: Kernels,
    pairs: PairStage,
    image_loss: Option<ImageLoss>,
    buffers: TrainerBuffers,
    gpu: Arc<Gpu>,
    topology: Topology,
    layout: ParameterLayout,
    shape: TileShape,
    batch: Batch,
    steps: u64,
    corrective_steps: u64,
}

impl Trainer {
    /// Begins or resumes a training. `size`: of every view's image, px; `views`: of a step, at most.
    /// Tiles have the shape for the device.
    ///
    /// # Errors
    /// When the device has too little memory or too few bindings, or the avatar is not supported: the
    /// networks have 2 to 4 layers of at most [`TRAIN_WIDTH_MAX`] numbers, the last of twice
    /// [`TRAIN_BASIS`].
    pub fn new(
        gpu: &Arc<Gpu>,
        topology: &Topology,
        rows: &CorrectiveRows,
        state: &TrainerState,
        size: [u32; 2],
        views: usize,
    ) -> Result<Self> {
        Self::with_shape(gpu, topology, rows, state, size, views, TileShape::of(gpu))
    }

    /// [`Self::new`] with tiles of another shape.
    ///
    /// # Errors
    /// Those of [`Self::new`].
    pub fn with_shape(
        gpu: &Arc<Gpu>,
        topology: &Topology,
        rows: &CorrectiveRows,
        state: &TrainerState,
        size: [u32; 2],
        views: usize,
        shape: TileShape,
    ) -> Result<Self> {
        check(gpu, topology, size)?;
        let batch = Batch { size, views };
        let layout = ParameterLayout::new(topology, rows);
        let buffers = TrainerBuffers::new(gpu, topology, rows, state, batch)?;
        let tiling = BandTiling {
            side: shape.side,
            pairs: (PAIRS_PER_GAUSSIAN * layout.gaussians as u32)
                .max(MIN_PAIRS)
                .min(shape.max_pairs(gpu)),
            bands: 1,
        };
        let pairs = PairStage::new(gpu, &buffers, &layout, shape, tiling, size)?;
        let kernels = Kernels::new(&KernelSource {
            gpu,
            buffers: &buffers,
            pairs: &pairs.buffers,
            layout: &layout,
            shape,
        })?;
        Ok(Self {
            kernels,
            pairs,
            image_loss: None,
            buffers,
            gpu: gpu.clone(),
            topology: topology.clone(),
            layout,
            shape,
            batch,
            steps: state.steps,
            corrective_steps: state.corrective_steps,
        })
    }

    /// All that is learned so far: copies everything back, and waits.
    pub fn state(&self) -> Result<TrainerState> {
        Ok(TrainerState {
            parameters: self.buffers.parameters.download()?,
            first_moments: self.buffers.first_moments.download()?,
            second_moments: self.buffers.second_moments.download()?,
            steps: self.steps,
            corrective_steps: self.corrective_steps,
        })
    }

    /// What is learned so far.
    pub fn parameters(&self) -> Result<Parameters<f32>> {
        self.buffers.parameters.download()
    }

    /// Draws Gaussians from where a topology says from now on, which is otherwise the trainer's own.
    pub fn face(&mut self, topology: &Topology) -> Result<()> {
        let words = placed_words(topology);
        self.topology = topology.clone();
        self.buffers.fixed.gaussians.upload(cast_slice(&words))
    }

    /// Steps so far.
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// Gives it a loss of parts of views that the device works out: see [`Self::step_with_parts`].
    /// `network`: None for D-SSIM; `size`: of each part, px.
    ///
    /// # Errors
    /// When the device has too little memory.
    pub fn add_image_loss(&mut self, network: Option<&Perceptual>, size: [usize; 2]) -> Result<()> {
        let new = ImageLoss::new(&self.gpu, &self.buffers, self.batch, network, size)?;
        self.image_loss = Some(new);
        Ok(())
    }

    /// Whether it has a loss of parts of views.
    pub fn has_image_loss(&self) -> bool {
        self.image_loss.is_some()
    }

    /// The loss of the part of a view of the last step, before its weight; 0 without one.
    pub fn part_loss(&mut self, view: usize) -> f64 {
        self.image_loss
            .as_mut()
            .map_or(0.0, |loss| loss.value(view))
    }

    /// A step along the derivative of the views' losses. Where the pairs of a view don't fit, their
    /// capacity grows and the step is taken again: no pair is dropped.
    ///
    /// # Panics
    /// When there are no views or more than the trainer was made for, or a view has another size or
    /// avatar.
    pub fn step(&mut self, views: &[TrainingView], options: &StepOptions) -> Result<StepLosses> {
        self.step_with_parts(views, options, &[])
    }

    /// A step with the loss of [`Self::add_image_loss`] too. `parts`: of each view the part that the
    /// loss sees, None where it sees none.
    ///
    /// # Panics
    /// Where [`Self::step`] does, or a part is not inside its view.
    pub fn step_with_parts(
        &mut self,
        views: &[TrainingView],
        options: &StepOptions,
        parts: &[Option<AskedPart>],
    ) -> Result<StepLosses> {
        self.assert_fits(views);
        loop {
            self.write(views, options, parts);
            self.gpu.run("a step", |commands| {
                Self::record_start(commands);
                self.record_views(commands, views.len(), options.joints, parts);
                self.record_update(commands, views.len());
            })?;
            if !self.grow_pairs()? {
                break;
            }
        }
        self.finish(views, options)
    }

    /// Computes the losses and derivatives of [`Self::step`], and learns nothing.
    ///
    /// # Panics
    /// Those of [`Self::step`].
    pub fn look(&mut self, views: &[TrainingView], options: &StepOptions) -> Result<StepLosses> {
        self.assert_fits(views);
        loop {
            self.write(views, options, &[]);
            self.gpu.run("a look", |commands| {
                Self::record_start(commands);
                self.record_views(commands, views.len(), options.joints, &[]);
                commands.barrier(Scope::KERNEL_WRITES, Scope::HOST_READS);
            })?;
            if !self.grow_pairs()? {
                return Ok(self.report(views));
            }
        }
    }

    /// A step with another loss of images. `image_loss` gets the index of a view and its image over
    /// its background, RGB from 0 to 1, and returns the derivative of its loss with respect to that
    /// image, which is divided by the number of views; None: it has no loss of this view. Where
    /// `stop` is set before the end nothing is learned, and None is returned.
    ///
    /// # Panics
    /// Where [`Self::step`] does, or a derivative has not the image's length.
    pub fn step_with_image_loss(
        &mut self,
        views: &[TrainingView],
        options: &StepOptions,
        stop: &AtomicBool,
        mut image_loss: impl FnMut(usize, &[[f32; 3]]) -> Option<Vec<[f32; 3]>>,
    ) -> Result<Option<StepLosses>> {
        self.assert_fits(views);
        self.write(views, options, &[]);
        for (number, view) in views.iter().enumerate() {
            // Pairs must fit before an image is used.
            loop {
                self.gpu.run("a step's image", |commands| {
                    Self::record_start(commands);
                    if number == 0 {
                        self.record_pose(commands, views.len());
                    }
                    self.record_forward(commands, number);
                    commands.barrier(Scope::KERNEL_WRITES, Scope::HOST_READS);
                })?;
                if !self.grow_pairs()? {
                    break;
                }
                self.write(views, options, &[]);
            }
            if stop.load(Ordering::Relaxed) {
                return Ok(None);
            }
            if let Some(gradient) = image_loss(number, &self.image(view)?) {
                let pixels = self.batch.pixels();
                assert_eq!(gradient.len(), pixels, "image derivative of view {number}");
                let padded: Vec<[f32; 4]> =
                    gradient.iter().map(|&[r, g, b]| [r, g, b, 0.0]).collect();
                self.buffers.view.asked.upload(cast_slice(&padded))?;
                // Its weight is in what the host worked out.
                let asked = Asked {
                    weight: 1.0,
                    ..Asked::default()
                };
                self.write_block(views, number, options, asked);
            }
            if stop.load(Ordering::Relaxed) {
                return Ok(None);
            }
            self.gpu.run("a step's derivative", |commands| {
                Self::record_start(commands);
                self.record_backward(commands, number, options.joints);
            })?;
        }
        self.gpu.run("a step's end", |commands| {
            Self::record_start(commands);
            self.record_update(commands, views.len());
        })?;
        self.finish(views, options).map(Some)
    }

    /// The images of views over their backgrounds, RGB, as training sees them.
    pub fn images(
        &mut self,
        views: &[TrainingView],
        options: &StepOptions,
    ) -> Result<Vec<Vec<[f32; 3]>>> {
        loop {
            self.write(views, options, &[]);
            let mut images = Vec::new();
            for (number, view) in views.iter().enumerate() {
                self.gpu.run("an image", |commands| {
                    Self::record_start(commands);
                    if number == 0 {
                        self.record_pose(commands, views.len());
                    }
                    self.record_forward(commands, number);
                    commands.barrier(Scope::KERNEL_WRITES, Scope::HOST_READS);
                })?;
                images.push(self.image(view)?);
            }
            if !self.grow_pairs()? {
                return Ok(images);
            }
        }
    }

    fn assert_fits(&self, views: &[TrainingView]) {
        assert!(
            (1..=self.batch.views).contains(&views.len()),
            "a step of {} views, made for 1 to {}",
            views.len(),
            self.batch.views
        );
        for (number, view) in views.iter().enumerate() {
            assert_eq!(view.camera.size, self.batch.size, "size of view {number}");
            assert_eq!(
                view.picture.size, self.batch.size,
                "picture of view {number}"
            );
            assert_eq!(view.joints.len(), self.topology.joints, "joints");
            assert_eq!(view.input.len(), self.topology.widths[0], "input");
        }
    }
}

/// Where the block of a band of a view begins, bytes.
fn offset_of(number: usize, band: u32) -> u32 {
    (number as u32 * MAX_BANDS + band) * STRIDE as u32
}

/// Device memory of a training, bytes, before the capacity for pairs grows. `size`: of every view,
/// px; `views`: of a step.
pub fn memory_bytes(
    topology: &Topology,
    rows: &CorrectiveRows,
    size: [u32; 2],
    views: usize,
) -> u64 {
    let layout = ParameterLayout::new(topology, rows);
    let pixels = size[0] as usize * size[1] as usize;
    let learned: usize = layout.lengths().iter().sum();
    let widths: usize = topology.widths[1..].iter().sum();
    let pairs = (PAIRS_PER_GAUSSIAN as usize * layout.gaussians).max(MIN_PAIRS as usize);
    // Words, by what they are of.
    let of_gaussian = 12 + 4 + 6 + 8 + 16 + 12 + 12 + 2 + 8 + 16 * views;
    let of_node = 8 * views + 2;
    let of_part = 2 * widths * views;
    let of_pixel = 12 + 2 * views;
    let of_pair = 2 + TRAIN_RECORD as usize + 3;
    let words = 3 * learned
        + of_gaussian * layout.gaussians
        + of_node * layout.nodes
        + of_part * layout.parts
        + of_pixel * pixels
        + of_pair * pairs;
    4 * words as u64
}

/// Checks that a device, an avatar and the size of its views are suitable for training.
fn check(gpu: &Gpu, topology: &Topology, size: [u32; 2]) -> Result<()> {
    let unsupported = |missing: String| Error::Unsupported {
        device: gpu.probe.name.clone(),
        missing: format!("for training: {missing}"),
    };
    let limit = gpu.probe.limits.max_per_stage_descriptor_storage_buffers;
    if limit < STORAGE_BUFFERS {
        return Err(unsupported(format!(
            "{STORAGE_BUFFERS} storage buffers in a kernel, it has {limit}"
        )));
    }
    // Workgroups of a dispatch, of the kernels that have the most of them.
    let pixels = size[0] as usize * size[1] as usize;
    let columns = topology.gaussians.len() * TRAIN_BASIS as usize;
    let most =
        u64::from(groups(pixels).max(columns.div_ceil(TRAIN_BASES_WORKGROUP as usize) as u32));
    let limit = u64::from(gpu.probe.limits.max_compute_work_group_count[0]);
    if most > limit {
        return Err(unsupported(format!(
            "{most} workgroups in a dispatch, it has {limit}: fewer Gaussians or smaller views"
        )));
    }
    let widest = topology.widths.iter().copied().max().unwrap_or(0);
    if !(2..=LAYERS).contains(&topology.layers()) || widest > TRAIN_WIDTH_MAX as usize {
        return Err(unsupported(format!(
            "networks of 2 to {LAYERS} layers of at most {TRAIN_WIDTH_MAX} numbers, found {:?}",
            topology.widths
        )));
    }
    if topology.widths[topology.layers()] != 2 * TRAIN_BASIS as usize {
        return Err(unsupported(format!(
            "networks with {} features, found {}",
            2 * TRAIN_BASIS,
            topology.widths[topology.layers()]
        )));
    }
    Ok(())
}

impl Trainer {
    /// Writes the host's inputs for some views.
    fn write(
        &mut self,
        views: &[TrainingView],
        options: &StepOptions,
        parts: &[Option<AskedPart>],
    ) {
        let mut joints: Vec<f32> = Vec::new();
        let mut inputs: Vec<f32> = Vec::new();
        for (number, view) in views.iter().enumerate() {
            joints.extend(view.joints.iter().flat_map(rows));
            inputs.extend(view.input.iter().map(|&v| v as f32));
            let asked = self.asked(view, parts.get(number).copied().flatten());
            self.write_block(views, number, options, asked);
        }
        let HostInputs {
            pictures, behind, ..
        } = &mut self.buffers.inputs;
        let bytes = 4 * self.batch.pixels();
        let places = pictures.mapped().par_chunks_mut(bytes);
        let places = places.zip(behind.mapped().par_chunks_mut(bytes));
        places.zip(views).for_each(|((pixels, behind), view)| {
            pixels.copy_from_slice(cast_slice(&view.picture.pixels));
            behind.copy_from_slice(cast_slice(&view.picture.behind));
        });
        put(&mut self.buffers.inputs.joints, cast_slice(&joints));
        put(&mut self.buffers.inputs.inputs, cast_slice(&inputs));
        self.buffers.view.status.mapped().fill(0);
    }

    /// What a loss of a part of a view asks.
    fn asked(&self, view: &TrainingView, part: Option<AskedPart>) -> Asked {
        let (Some(part), Some(loss)) = (part, &self.image_loss) else {
            return Asked::default();
        };
        let size = loss.size.map(|side| side as u32);
        let inside = |axis: usize| part.first[axis] + size[axis] <= view.picture.size[axis];
        assert!(
            inside(0) && inside(1),
            "{part:?} of {:?}",
            view.picture.size
        );
        Asked {
            weight: part.weight,
            window: WindowBlock {
                first: part.first,
                size,
            },
        }
    }

    /// Writes the blocks of a view's bands.
    fn write_block(
        &mut self,
        views: &[TrainingView],
        number: usize,
        options: &StepOptions,
        asked: Asked,
    ) {
        let updates = Updates {
            main: self.steps + 1,
            correctives: self.corrective_steps + 1,
        };
        for band in 0..self.pairs.tiling.bands {
            let block = ViewBlock::new(
                &self.topology,
                &self.layout,
                &views[number],
                options,
                self.pairs.tiling,
                ViewBand {
                    view: number,
                    band,
                    views: views.len(),
                    image_loss: asked.weight,
                    window: asked.window,
                },
                updates,
            );
            let at = offset_of(number, band) as usize;
            let bytes = bytes_of(&block);
            self.buffers.view.blocks.mapped()[at..at + bytes.len()].copy_from_slice(bytes);
        }
    }

    /// From poses to the derivative of the Gaussians, of the first `views` views.
    fn record_views(
        &self,
        commands: Recording,
        views: usize,
        joints: bool,
        parts: &[Option<AskedPart>],
    ) {
        self.record_pose(commands, views);
        for number in 0..views {
            self.record_forward(commands, number);
            commands.barrier(Scope::KERNEL, Scope::KERNEL);
            if let (Some(Some(_)), Some(loss)) = (parts.get(number), &self.image_loss) {
                loss.record(commands, offset_of(number, 0), self.batch.pixels());
            }
            self.record_backward(commands, number, joints);
        }
    }

    /// Makes what earlier submissions wrote visible to the kernels of this one.
    fn record_start(commands: Recording) {
        commands.barrier(Scope::KERNEL_WRITES, Scope::KERNEL);
        commands.barrier(Scope::TRANSFER_WRITES, Scope::KERNEL);
    }

    /// Networks and nodes of all views.
    fn record_pose(&self, commands: Recording, views: usize) {
        let next = || commands.barrier(Scope::KERNEL, Scope::KERNEL);
        let parts = self.layout.parts as u32;
        self.kernels
            .mlp
            .dispatch_2d(commands, 0, [parts, views as u32]);
        next();
        self.kernels
            .nodes
            .dispatch_2d(commands, 0, [groups(self.layout.nodes), views as u32]);
        next();
    }

    /// A view's image, the last band first: the pairs of the first are there when the way back
    /// begins.
    fn record_forward(&self, commands: Recording, number: usize) {
        let offset = offset_of(number, 0);
        let next = || commands.barrier(Scope::KERNEL, Scope::KERNEL);
        self.kernels
            .project
            .dispatch(commands, offset, groups(self.layout.gaussians));
        next();
        self.buffers.view.sort.record(commands);
        next();
        for band in (0..self.pairs.tiling.bands).rev() {
            let offset = offset_of(number, band);
            self.pairs
                .record_pairs(commands, offset, self.batch.size, band);
            self.pairs
                .record_image(commands, offset, self.batch.size, band);
            if band > 0 {
                next();
            }
        }
    }

    /// From a view's image to the derivative of its Gaussians.
    fn record_backward(&self, commands: Recording, number: usize, joints: bool) {
        let offset = offset_of(number, 0);
        let next = || commands.barrier(Scope::KERNEL, Scope::KERNEL);
        let pixels = self.batch.pixels();
        self.kernels.loss.dispatch(commands, offset, groups(pixels));
        next();
        for band in 0..self.pairs.tiling.bands {
            let offset = offset_of(number, band);
            if band > 0 {
                self.pairs
                    .record_pairs(commands, offset, self.batch.size, band);
            }
            self.pairs
                .record_backward(commands, offset, self.batch.size, band);
            next();
            self.pairs.kernels.project_backward.dispatch(
                commands,
                offset,
                groups(self.layout.gaussians),
            );
            next();
        }
        if joints {
            let joints = self.topology.joints as u32;
            self.kernels
                .joints_backward
                .dispatch(commands, offset, joints);
            commands.barrier(Scope::KERNEL_WRITES, Scope::HOST_READS);
        }
    }

    /// From the derivatives of the Gaussians of all views to a step.
    fn record_update(&self, commands: Recording, views: usize) {
        let next = || commands.barrier(Scope::KERNEL, Scope::KERNEL);
        let parts = self.layout.parts as u32;
        let of_parts = [parts, views as u32];
        let kernels = &self.kernels;
        let nodes = [groups(self.layout.nodes), views as u32];
        kernels.nodes_backward.dispatch_2d(commands, 0, nodes);
        next();
        kernels.features_backward.dispatch_2d(commands, 0, of_parts);
        next();
        kernels.mlp_backward.dispatch_2d(commands, 0, of_parts);
        next();
        kernels
            .adam_gaussians
            .dispatch(commands, 0, groups(self.layout.gaussians));
        let columns = self.layout.gaussians * TRAIN_BASIS as usize;
        let wide = columns.div_ceil(TRAIN_BASES_WORKGROUP as usize) as u32;
        kernels.adam_bases.dispatch(commands, 0, wide);
        let columns = groups(self.layout.nodes * TRAIN_BASIS as usize);
        kernels.adam_nodes.dispatch(commands, 0, columns);
        kernels.adam_networks.dispatch(commands, 0, parts);
        commands.barrier(Scope::KERNEL_WRITES, Scope::HOST_READS);
    }

    /// Grows the capacity for pairs where the last submission exceeded it, or cuts views into more
    /// bands where no buffer holds more. Returns whether it did.
    fn grow_pairs(&mut self) -> Result<bool> {
        let needed = self.status()[0];
        let now = self.pairs.tiling;
        if needed <= now.pairs {
            return Ok(false);
        }
        let most = self.shape.max_pairs(&self.gpu);
        let [_, rows] = now.tiles(self.batch.size);
        let with_spare = needed.saturating_add(needed / 4);
        let tiling = if with_spare <= most {
            BandTiling {
                pairs: with_spare,
                ..now
            }
        } else {
            let bands = now.bands.saturating_mul(with_spare.div_ceil(most));
            BandTiling {
                pairs: most,
                bands: bands.min(rows).min(MAX_BANDS),
                ..now
            }
        };
        if tiling.pairs == now.pairs && tiling.bands == now.bands {
            return Err(Error::Unsupported {
                device: self.gpu.probe.name.clone(),
                missing: format!(
                    "for training: {needed} pairs of splats and tiles in one of {} bands of a \
                     view, it has room for {most}: fewer Gaussians or smaller views",
                    now.bands
                ),
            });
        }
        tracing::debug!(
            "{needed} pairs of splats and tiles: room for {} in each of {} bands",
            tiling.pairs,
            tiling.bands
        );
        let shape = self.shape;
        let (gpu, buffers, layout) = (&self.gpu, &self.buffers, &self.layout);
        self.pairs = PairStage::new(gpu, buffers, layout, shape, tiling, self.batch.size)?;
        Ok(true)
    }

    fn status(&mut self) -> [u32; 4] {
        bytemuck::pod_read_unaligned(&self.buffers.view.status.mapped()[..16])
    }

    /// Counts a step, and reports its losses.
    fn finish(&mut self, views: &[TrainingView], options: &StepOptions) -> Result<StepLosses> {
        self.steps += 1;
        self.corrective_steps += u64::from(options.correctives);
        Ok(self.report(views))
    }

    /// The losses of some views.
    fn report(&mut self, views: &[TrainingView]) -> StepLosses {
        let [pairs, empty_views, ..] = self.status();
        let pixels = self.batch.pixels();
        let channels = 3.0 * (pixels * views.len()) as f64;
        let mean = |sums: &[LossSums], at: usize| {
            sums.iter().map(|sum| f64::from(sum[at])).sum::<f64>() / channels
        };
        let sums = self.loss_sums(0..views.len());
        StepLosses {
            l1: mean(sums, 0),
            squared: mean(sums, 1),
            pairs,
            empty_views,
        }
    }

    /// The derivative of the last step's loss with respect to G of each joint of one of its views,
    /// where [`StepOptions::joints`] is set. The networks' inputs are held fixed.
    pub fn joints_gradient(&mut self, view: usize) -> Vec<DAffine3> {
        let joints = self.topology.joints;
        let rows: &[[f32; 4]] = cast_slice(self.buffers.batch.of_joints.mapped());
        rows[3 * joints * view..3 * joints * (view + 1)]
            .chunks_exact(3)
            .map(|rows| {
                let column = |c: usize| DVec3::from_array([0, 1, 2].map(|r| f64::from(rows[r][c])));
                DAffine3::from_cols(column(0), column(1), column(2), column(3))
            })
            .collect()
    }

    /// The derivative of the last step's loss with respect to the rotation, log scale and colour of
    /// each Gaussian, in its first view: ten numbers each. Those of correctives are the same, but
    /// for the losses of correctives themselves.
    pub fn attribute_gradients(&self) -> Result<Vec<[f32; 10]>> {
        let of_gaussians = &self.buffers.batch.of_gaussians;
        let bytes = of_gaussians.download(64 * self.layout.gaussians)?;
        let rows: Vec<[f32; 16]> = bytemuck::pod_collect_to_vec(&bytes);
        let place = |k: usize| if k < 7 { k } else { k + 1 };
        Ok(rows
            .iter()
            .map(|row| std::array::from_fn(|k| row[place(k)]))
            .collect())
    }

    /// The derivative of the last step's loss with respect to the gain of one of its views, RGB.
    pub fn gain_gradient(&mut self, view: usize) -> [f64; 3] {
        let sums = self.loss_sums(view..view + 1);
        std::array::from_fn(|c| sums.iter().map(|sum| f64::from(sum[2 + c])).sum())
    }

    /// The sums of the workgroups of some views of the last step.
    fn loss_sums(&mut self, views: Range<usize>) -> &[LossSums] {
        let size = groups(self.batch.pixels()) as usize * size_of::<LossSums>();
        let range = views.start * size..views.end * size;
        cast_slice(&self.buffers.batch.loss_sums.mapped()[range])
    }

    /// The last image over what is behind the avatar in a view.
    fn image(&self, view: &TrainingView) -> Result<Vec<[f32; 3]>> {
        let pixels = self.batch.pixels();
        let bytes = self.buffers.view.image.download(16 * pixels)?;
        let drawn: Vec<[f32; 4]> = bytemuck::pod_collect_to_vec(&bytes);
        let gain = view.gain.as_vec3().to_array();
        Ok(drawn
            .iter()
            .zip(&view.picture.behind)
            .map(|(&[r, g, b, light], behind)| {
                let behind = behind.map(|v| f32::from(v) / 255.0);
                let over = |v: f32, c: usize| (gain[c] * v + light * behind[c]).clamp(0.0, 1.0);
                [over(r, 0), over(g, 1), over(b, 2)]
            })
            .collect())
    }
}

/// Copies bytes to the start of a buffer that the host sees.
fn put(buffer: &mut Buffer, bytes: &[u8]) {
    buffer.mapped()[..bytes.len()].copy_from_slice(bytes);
}

/// The three rows of a transform.
fn rows(transform: &DAffine3) -> [f32; 12] {
    let mut all = [0.0; 12];
    for axis in 0..3 {
        let row = transform.matrix3.row(axis);
        let numbers = [row.x, row.y, row.z, transform.translation[axis]];
        for (to, from) in all[4 * axis..].iter_mut().zip(numbers) {
            *to = from as f32;
        }
    }
    all
}
