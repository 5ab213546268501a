//! Vulkan objects that are destroyed with their owner.

use super::{
    error::{During, Error, Result},
    logical::Device,
};
use ash::vk;
use std::sync::Arc;

/// A kind of object that a device makes and destroys.
pub trait Object: vk::Handle + Copy {
    /// # Safety
    /// The object must be of this device, no submitted work may use it, and nothing may use it
    /// afterwards.
    unsafe fn destroy(self, device: &ash::Device);
}

/// An object of a device, destroyed when it is dropped.
///
/// It must outlive the submitted work that uses it, which whoever submits that work promises
/// (`Gpu::submit`). On a device that hangs it is left alone.
pub struct Owned<H: Object> {
    raw: H,
    device: Arc<Device>,
}

impl<H: Object> Owned<H> {
    /// Takes an object over, and gives it the name that validation messages and GPU profilers show.
    ///
    /// # Safety
    /// The object must be alive and of this device, and nobody else may destroy it.
    pub(crate) unsafe fn new(device: &Arc<Device>, raw: H, name: &str) -> Self {
        // SAFETY: the caller promises that the object is alive and of this device.
        unsafe { device.name(raw, name) };
        Self {
            raw,
            device: device.clone(),
        }
    }

    /// The object, for as long as its owner lives.
    pub fn raw(&self) -> H {
        self.raw
    }
}

impl<H: Object> Drop for Owned<H> {
    fn drop(&mut self) {
        if !self.device.hangs() {
            // SAFETY: the object is of this device and belongs to this owner, which goes away; work
            // that used it is done, as whoever submitted it promised.
            unsafe { self.raw.destroy(&self.device.raw) };
        }
    }
}

/// A line for each kind of object: its owner, its handle, and what destroys it.
macro_rules! objects {
    ($($owner:ident = $object:ident, $destroy:ident;)*) => {$(
        impl Object for vk::$object {
            unsafe fn destroy(self, device: &ash::Device) {
                // SAFETY: the caller promises what the function asks for.
                unsafe { device.$destroy(self, None) }
            }
        }
        #[doc = concat!("A [`vk::", stringify!($object), "`], destroyed when it is dropped.")]
        pub type $owner = Owned<vk::$object>;
    )*};
}

objects! {
    BufferHandle = Buffer, destroy_buffer;
    CommandPool = CommandPool, destroy_command_pool;
    DescriptorPool = DescriptorPool, destroy_descriptor_pool;
    Fence = Fence, destroy_fence;
    Framebuffer = Framebuffer, destroy_framebuffer;
    ImageHandle = Image, destroy_image;
    ImageView = ImageView, destroy_image_view;
    Pipeline = Pipeline, destroy_pipeline;
    PipelineCacheHandle = PipelineCache, destroy_pipeline_cache;
    PipelineLayout = PipelineLayout, destroy_pipeline_layout;
    QueryPool = QueryPool, destroy_query_pool;
    RenderPass = RenderPass, destroy_render_pass;
    Sampler = Sampler, destroy_sampler;
    Semaphore = Semaphore, destroy_semaphore;
    SetLayout = DescriptorSetLayout, destroy_descriptor_set_layout;
    ShaderModule = ShaderModule, destroy_shader_module;
}

impl CommandPool {
    /// For command buffers that are recorded once.
    pub(crate) fn transient(device: &Arc<Device>, queue_family: u32, name: &str) -> Result<Self> {
        let info = vk::CommandPoolCreateInfo::default()
            .queue_family_index(queue_family)
            .flags(vk::CommandPoolCreateFlags::TRANSIENT);
        // SAFETY: `info` outlives the call; the pool is new and belongs to its owner.
        unsafe {
            let raw = device
                .raw
                .create_command_pool(&info, None)
                .during("vkCreateCommandPool")?;
            Ok(Self::new(device, raw, name))
        }
    }

    /// A primary command buffer, which goes away with the pool.
    pub(crate) fn allocate(&self, name: &str) -> Result<vk::CommandBuffer> {
        let info = vk::CommandBufferAllocateInfo::default()
            .command_pool(self.raw)
            .command_buffer_count(1);
        // SAFETY: the pool is alive, the command buffer is new.
        unsafe {
            let commands = self
                .device
                .raw
                .allocate_command_buffers(&info)
                .during("vkAllocateCommandBuffers")?[0];
            self.device.name(commands, name);
            Ok(commands)
        }
    }
}

impl Fence {
    /// Not signalled.
    pub(crate) fn unsignalled(device: &Arc<Device>, name: &str) -> Result<Self> {
        // SAFETY: the structure outlives the call; the fence is new and belongs to its owner.
        unsafe {
            let raw = device
                .raw
                .create_fence(&vk::FenceCreateInfo::default(), None)
                .during("vkCreateFence")?;
            Ok(Self::new(device, raw, name))
        }
    }

    /// Waits for work that was submitted with it, but not for ever. A device that does not finish
    /// in time counts as hung from then on. `what`: the work, for the error.
    pub(crate) fn wait(&self, what: &'static str) -> Result<()> {
        let patience = self.device.patience();
        // SAFETY: the fence is alive.
        let waited = unsafe {
            self.device
                .raw
                .wait_for_fences(&[self.raw], true, patience.as_nanos() as u64)
        };
        match waited {
            Err(vk::Result::TIMEOUT) => {
                self.device.note_hang();
                Err(Error::Timeout {
                    what,
                    seconds: patience.as_secs(),
                })
            }
            result => result.during("vkWaitForFences"),
        }
    }
}

impl Framebuffer {
    /// Around images of a size, px. The views must outlive it.
    pub(crate) fn around(
        device: &Arc<Device>,
        render_pass: &RenderPass,
        views: &[vk::ImageView],
        size: [u32; 2],
        name: &str,
    ) -> Result<Self> {
        let info = vk::FramebufferCreateInfo::default()
            .render_pass(render_pass.raw)
            .attachments(views)
            .width(size[0])
            .height(size[1])
            .layers(1);
        // SAFETY: `info` and all it points to outlive the call; the framebuffer is new and belongs
        // to its owner.
        unsafe {
            let raw = device
                .raw
                .create_framebuffer(&info, None)
                .during("vkCreateFramebuffer")?;
            Ok(Self::new(device, raw, name))
        }
    }
}

impl ImageView {
    /// Of all of an image's range, two-dimensional. The image must outlive it.
    pub(crate) fn with_range(
        device: &Arc<Device>,
        image: vk::Image,
        format: vk::Format,
        range: vk::ImageSubresourceRange,
        name: &str,
    ) -> Result<Self> {
        let info = vk::ImageViewCreateInfo::default()
            .image(image)
            .view_type(vk::ImageViewType::TYPE_2D)
            .format(format)
            .subresource_range(range);
        // SAFETY: `info` outlives the call; the view is new and belongs to its owner.
        unsafe {
            let raw = device
                .raw
                .create_image_view(&info, None)
                .during("vkCreateImageView")?;
            Ok(Self::new(device, raw, name))
        }
    }
}

impl QueryPool {
    fn with(device: &Arc<Device>, info: &vk::QueryPoolCreateInfo, name: &str) -> Result<Self> {
        // SAFETY: `info` outlives the call; the pool is new and belongs to its owner.
        unsafe {
            let raw = device
                .raw
                .create_query_pool(info, None)
                .during("vkCreateQueryPool")?;
            Ok(Self::new(device, raw, name))
        }
    }

    /// For so many timestamps. The device must have them.
    pub(crate) fn timestamps(device: &Arc<Device>, count: u32, name: &str) -> Result<Self> {
        let info = vk::QueryPoolCreateInfo::default()
            .query_type(vk::QueryType::TIMESTAMP)
            .query_count(count);
        Self::with(device, &info, name)
    }

    /// For counts of fragments. The device must have pipeline statistics.
    pub(crate) fn fragments(device: &Arc<Device>, counts: u32, name: &str) -> Result<Self> {
        let info = vk::QueryPoolCreateInfo::default()
            .query_type(vk::QueryType::PIPELINE_STATISTICS)
            .query_count(counts)
            .pipeline_statistics(vk::QueryPipelineStatisticFlags::FRAGMENT_SHADER_INVOCATIONS);
        Self::with(device, &info, name)
    }

    /// Results of the first queries, 64 bits each. Fails where they are not there yet.
    pub(crate) fn read(&self, results: &mut [u64]) -> std::result::Result<(), vk::Result> {
        // SAFETY: the pool is alive; queries that were never written are reported, not read.
        unsafe {
            self.device.raw.get_query_pool_results(
                self.raw,
                0,
                results,
                vk::QueryResultFlags::TYPE_64,
            )
        }
    }
}

impl Sampler {
    pub(crate) fn with(
        device: &Arc<Device>,
        info: &vk::SamplerCreateInfo,
        name: &str,
    ) -> Result<Self> {
        // SAFETY: `info` outlives the call; the sampler is new and belongs to its owner.
        unsafe {
            let raw = device
                .raw
                .create_sampler(info, None)
                .during("vkCreateSampler")?;
            Ok(Self::new(device, raw, name))
        }
    }
}

impl Semaphore {
    #[cfg(feature = "window")]
    pub(crate) fn unsignalled_binary(device: &Arc<Device>, name: &str) -> Result<Self> {
        // SAFETY: the structure outlives the call; the semaphore is new and belongs to its owner.
        unsafe {
            let raw = device
                .raw
                .create_semaphore(&vk::SemaphoreCreateInfo::default(), None)
                .during("vkCreateSemaphore")?;
            Ok(Self::new(device, raw, name))
        }
    }
}
