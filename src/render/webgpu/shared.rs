//! The stages that all people of a frame share, and their buffers: made for a capacity, and made anew
//! where a scene needs more.

use super::{
    buffer::{STORAGE, empty},
    device::Gpu,
    error::Result,
    kernel::Blocks,
    options::check_capacity,
    owned::Buffer,
    raster::{Raster, RasterInputs},
    sort::{self, Sort, SortInputs},
    splat_buffer::SplatBuffer,
};
use effigy_core::{
    frame::{
        DEPTH_KEYS, RendererOptions,
        block::{PoseLayout, SharedSizes},
    },
    layout::{Control, SettingsBlock},
};

/// Stages and buffers that all people share.
pub struct SharedStages {
    pub splats: SplatBuffer,
    pub sort: Sort,
    pub raster: Raster,
    pub control: Buffer,
    /// Features, then node displacements, of one person after the other; then a vector of zeros.
    pub pose: Buffer,
    pub blocks: Blocks,
    pub settings: SettingsBlock,
    pub sizes: SharedSizes,
}

/// What changes with the sizes.
struct Sized {
    splats: SplatBuffer,
    sort: Sort,
    pose: Buffer,
}

impl Sized {
    fn new(
        gpu: &Gpu,
        options: &RendererOptions,
        sizes: SharedSizes,
        blocks: &Blocks,
        control: &Buffer,
    ) -> Result<Self> {
        check_capacity(gpu, sizes.capacity)?;
        let layout: PoseLayout = sizes.pose_layout();
        let pose = empty(gpu, "pose", 16 * u64::from(layout.total()), STORAGE)?;
        let splats = SplatBuffer::new(gpu, options, sizes.capacity, sizes.cache_words)?;
        let sort_inputs = SortInputs {
            bits: DEPTH_KEYS,
            keys: splats.keys(),
            counts: splats.counts(),
            control: control.into(),
            capacity: splats.capacity(),
            counted: true,
        };
        let variant = sort::variant(options);
        let sort = Sort::new(gpu, blocks.settings(), &sort_inputs, variant)?;
        Ok(Self { splats, sort, pose })
    }
}

fn raster_inputs<'a>(
    splats: &'a SplatBuffer,
    sort: &'a Sort,
    control: &'a wgpu::Buffer,
) -> RasterInputs<'a> {
    RasterInputs {
        order: sort.order(),
        splats: splats.all(),
        control,
        capacity: splats.capacity(),
    }
}

impl SharedStages {
    /// For frames of these sizes.
    pub fn new(gpu: &Gpu, options: &RendererOptions, sizes: SharedSizes) -> Result<Self> {
        let size = size_of::<Control>() as u64;
        let control = empty(gpu, "control", size, STORAGE | wgpu::BufferUsages::INDIRECT)?;
        let blocks = Blocks::new(gpu, options.instances)?;
        let Sized { splats, sort, pose } = Sized::new(gpu, options, sizes, &blocks, &control)?;
        let inputs = raster_inputs(&splats, &sort, &control);
        let raster = Raster::new(gpu, &blocks, inputs, options)?;
        let mut new = Self {
            settings: SettingsBlock::default(),
            splats,
            sort,
            raster,
            control,
            pose,
            blocks,
            sizes,
        };
        new.fill_settings(options);
        Ok(new)
    }

    /// Makes what depends on sizes anew. The image stays; avatars must be bound again. On failure
    /// nothing has changed.
    pub fn resize_buffers(
        &mut self,
        gpu: &Gpu,
        options: &RendererOptions,
        sizes: SharedSizes,
    ) -> Result<()> {
        let sized = Sized::new(gpu, options, sizes, &self.blocks, &self.control)?;
        let inputs = raster_inputs(&sized.splats, &sized.sort, &self.control);
        self.raster.rebind(gpu, &self.blocks, inputs, options)?;
        self.splats = sized.splats;
        self.sort = sized.sort;
        self.pose = sized.pose;
        self.sizes = sizes;
        self.fill_settings(options);
        Ok(())
    }

    fn fill_settings(&mut self, options: &RendererOptions) {
        self.sort.fill(&mut self.settings);
        let capacity = self.splats.capacity();
        self.raster.fill(&mut self.settings, options, capacity);
    }

    /// [`Raster::make_atlas`].
    pub fn make_atlas(&mut self, gpu: &Gpu, size: [u32; 2]) -> Result<()> {
        let inputs = raster_inputs(&self.splats, &self.sort, &self.control);
        self.raster.make_atlas(gpu, &self.blocks, inputs, size)
    }

    /// [`Raster::resize`].
    pub fn resize_image(&mut self, gpu: &Gpu, size: [u32; 2]) -> Result<()> {
        let inputs = raster_inputs(&self.splats, &self.sort, &self.control);
        self.raster.resize(gpu, &self.blocks, inputs, size)
    }
}
