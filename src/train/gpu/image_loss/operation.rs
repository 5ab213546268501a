//! Steps of a perceptual loss on a device, a kernel each. `effigy_perceptual` has each of them on the
//! CPU, which tests hold them against.

use super::super::buffers::groups;
use super::super::shaders;
use effigy_core::layout::TRAIN_WORKGROUP;
use effigy_render::vulkan::compute::{Kernel, Launch, Module, Recording, Resources, Scope, Slice};
use effigy_render::vulkan::{Gpu, Result};
use std::sync::Arc;

/// Feature maps in a device's memory, a plane a channel, one picture after the other.
#[derive(Clone, Copy)]
pub struct DeviceMaps {
    /// Shape: pictures · channels · height · width; f32.
    pub slice: Slice,
    /// Pictures.
    pub pictures: usize,
    /// Channels of a picture.
    pub channels: usize,
    /// Width and height.
    pub size: [usize; 2],
}

impl DeviceMaps {
    /// Numbers of a plane.
    pub fn plane(&self) -> usize {
        self.size[0] * self.size[1]
    }

    fn sides(&self) -> [u32; 2] {
        self.size.map(|side| side as u32)
    }
}

/// What a layer's distance reads and writes.
#[derive(Clone, Copy)]
pub struct DistanceMemory {
    /// Features of a picture, and of its target.
    pub maps: DeviceMaps,
    /// What each channel counts.
    pub weights: Slice,
    /// The derivative with respect to the picture's features before they were rectified.
    pub gradient: Slice,
    /// What each workgroup's pixels add to the distance.
    pub sums: Slice,
    /// Where the layer's sums begin, numbers.
    pub first: usize,
}

/// Pixels whose distance a workgroup finds; several invocations share one.
const DISTANCE_PIXELS: u32 = 16;
const _: () = assert!(TRAIN_WORKGROUP.is_multiple_of(DISTANCE_PIXELS));

/// A dispatch of a kernel. What it binds must outlive the work.
pub struct Operation {
    kernel: Kernel,
    groups: [u32; 2],
}

impl Operation {
    /// `storage`: from binding 1 on.
    pub(super) fn new(
        gpu: &Arc<Gpu>,
        module: &'static Module,
        constants: &[u32],
        storage: &[Slice],
        groups: [u32; 2],
    ) -> Result<Self> {
        let resources = Resources {
            storage,
            ..Resources::default()
        };
        Ok(Self {
            kernel: Kernel::new(gpu, module, constants, resources, Launch::default())?,
            groups,
        })
    }

    /// Records it, and that what comes next waits for it.
    pub fn record(&self, commands: Recording) {
        self.kernel.dispatch_2d(commands, 0, self.groups);
        commands.barrier(Scope::KERNEL, Scope::KERNEL);
    }

    /// A plane from each plane. `constant`: the fifth; `more`: bound from 3 on.
    fn of_planes(
        gpu: &Arc<Gpu>,
        module: &'static Module,
        [read, written]: [DeviceMaps; 2],
        constant: u32,
        more: &[Slice],
    ) -> Result<Self> {
        let [a, b] = [read.sides(), written.sides()];
        let constants = [a[0], a[1], b[0], b[1], constant];
        let mut storage = vec![read.slice, written.slice];
        storage.extend(more);
        let planes = (written.pictures * written.channels) as u32;
        let groups = [groups(written.plane()), planes];
        Self::new(gpu, module, &constants, &storage, groups)
    }

    /// [`effigy_perceptual::blur::forward`]. `rectifies`: negative numbers become 0.
    pub fn blur(
        gpu: &Arc<Gpu>,
        read: DeviceMaps,
        written: DeviceMaps,
        rectifies: bool,
    ) -> Result<Self> {
        let rectifies = u32::from(rectifies);
        Self::of_planes(gpu, &shaders::BLUR, [read, written], rectifies, &[])
    }

    /// [`effigy_perceptual::blur::backward`].
    pub fn blur_backward(
        gpu: &Arc<Gpu>,
        of_written: DeviceMaps,
        of_read: DeviceMaps,
    ) -> Result<Self> {
        let both = [of_written, of_read];
        Self::of_planes(gpu, &shaders::BLUR_BACKWARD, both, 0, &[])
    }

    /// [`effigy_perceptual::pool::forward`].
    pub fn pool(
        gpu: &Arc<Gpu>,
        read: DeviceMaps,
        written: DeviceMaps,
        window: usize,
    ) -> Result<Self> {
        Self::of_planes(gpu, &shaders::POOL, [read, written], window as u32, &[])
    }

    /// [`effigy_perceptual::pool::backward`]. `forward`: what was read and written, of the first
    /// picture at least.
    pub fn pool_backward(
        gpu: &Arc<Gpu>,
        of_written: DeviceMaps,
        of_read: DeviceMaps,
        forward: [Slice; 2],
        window: usize,
    ) -> Result<Self> {
        let both = [of_written, of_read];
        Self::of_planes(gpu, &shaders::POOL_BACKWARD, both, window as u32, &forward)
    }

    /// [`effigy_perceptual::thin::forward`].
    pub fn thin(
        gpu: &Arc<Gpu>,
        read: DeviceMaps,
        written: DeviceMaps,
        step: usize,
    ) -> Result<Self> {
        Self::of_planes(gpu, &shaders::THIN, [read, written], step as u32, &[])
    }

    /// [`effigy_perceptual::thin::backward`].
    pub fn thin_backward(
        gpu: &Arc<Gpu>,
        of_written: DeviceMaps,
        of_read: DeviceMaps,
        step: usize,
    ) -> Result<Self> {
        let both = [of_written, of_read];
        Self::of_planes(gpu, &shaders::THIN_BACKWARD, both, step as u32, &[])
    }

    /// [`effigy_perceptual::head::distance`] of a picture's rectified features from its target's.
    /// `adds`: the derivative is added to what is there.
    pub fn distance(gpu: &Arc<Gpu>, memory: DistanceMemory, adds: bool) -> Result<Self> {
        let maps = memory.maps;
        let constants = [
            maps.channels as u32,
            maps.plane() as u32,
            DISTANCE_PIXELS,
            u32::from(adds),
            memory.first as u32,
        ];
        let storage = [maps.slice, memory.weights, memory.gradient, memory.sums];
        let groups = [Self::distance_sums(maps.plane()) as u32, 1];
        Self::new(gpu, &shaders::DISTANCE, &constants, &storage, groups)
    }

    /// Sums of a layer of so many pixels.
    pub fn distance_sums(plane: usize) -> usize {
        plane.div_ceil(DISTANCE_PIXELS as usize)
    }
}
