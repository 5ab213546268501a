//! The device in use: its queue, its memory, its pipeline cache, and the one place where commands
//! are submitted and waited for.

use super::{
    cache::PipelineCache,
    calibration::CalibrationExtension,
    error::{During, Error, Result},
    handle::{CommandPool, Fence},
    instance::Instance,
    kept_pipelines::KeptPipelines,
    logical::{Device, DeviceFeatures},
    options::GpuOptions,
    outcome::{SortChoice, Tried},
    probe::Probe,
    recording::Recording,
    statistics::Statistics,
};
use ash::{khr, vk};
use effigy_core::frame::SortVariant;
use gpu_allocator::vulkan::{Allocator, AllocatorCreateDesc};
use std::{
    mem::ManuallyDrop,
    ops::Deref,
    path::{Path, PathBuf},
    sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError},
};

/// Results of the sort's self-test while the program runs.
#[derive(Default)]
pub(crate) struct Sorts {
    /// The choice, once it is made.
    pub chosen: OnceLock<SortChoice>,
    /// Outcomes of variants that were asked for by name.
    pub asked: Mutex<Vec<Tried<SortVariant>>>,
}

/// A Vulkan device with one queue for everything.
pub struct Gpu {
    /// The one queue, for graphics and compute. Submit through `submit`, which locks it.
    queue: vk::Queue,
    /// Index of the queue's family.
    pub(crate) queue_family: u32,
    /// Allocates device memory. Dropped before the device.
    pub(crate) allocator: ManuallyDrop<Arc<Mutex<Allocator>>>,
    /// The driver's compiled pipelines, saved to disk.
    pub(crate) cache: PipelineCache,
    /// [`GpuOptions::cache`].
    cache_folder: Option<PathBuf>,
    /// Pipelines that renderers share.
    pub(crate) kept_pipelines: KeptPipelines,
    /// Limits, features and extensions of the physical device.
    pub probe: Probe,
    /// Reads the device's and the host's clock at once. None where the driver can't.
    pub(crate) calibration: Option<CalibrationExtension>,
    /// The swapchain extension's functions. None where the device was opened without a window.
    #[cfg(feature = "window")]
    pub(crate) swapchain: Option<khr::swapchain::Device>,
    /// Results of the sort's self-test on this device.
    pub(crate) sorts: Sorts,
    /// Compiler statistics; None unless the device was opened for [`GpuOptions::statistics`].
    pub(crate) statistics: Option<Statistics>,
    /// Vulkan wants one thread at a time at a queue; renderers on one device may be on several.
    queue_lock: Mutex<()>,
    /// The logical device. The last field, so that it is dropped after all made from it.
    pub(crate) device: Arc<Device>,
}

impl Deref for Gpu {
    type Target = Device;

    fn deref(&self) -> &Device {
        &self.device
    }
}

impl Gpu {
    /// The folder in which things are kept from start to start, if any.
    pub fn cache_folder(&self) -> Option<&Path> {
        self.cache_folder.as_deref()
    }

    /// Opens a device.
    pub fn new(options: &GpuOptions) -> Result<Arc<Self>> {
        let instance = Instance::new(options.validation, &options.surface_extensions)?;
        let probe = choose(Probe::all(&instance)?, options.device.as_deref())?;
        let probe = if options.baseline {
            probe.baseline()
        } else {
            probe
        };
        let missing = probe.missing_requirements();
        let Some(queue_family) = probe.queue_family.filter(|_| missing.is_empty()) else {
            return Err(Error::Unsupported {
                device: probe.name,
                missing: missing.join("; "),
            });
        };
        if options.statistics && !probe.shader_statistics {
            return Err(Error::NoStatistics { device: probe.name });
        }
        let features = DeviceFeatures {
            window: !options.surface_extensions.is_empty() && probe.has(khr::swapchain::NAME),
            statistics: options.statistics,
        };
        let device = Device::new(instance, &probe, queue_family, features)?;
        // SAFETY: the family and the one queue were asked for at creation.
        let queue = unsafe { device.raw.get_device_queue(queue_family, 0) };
        // SAFETY: the queue is of this device.
        unsafe { device.name(queue, "frames") };
        let allocator = Allocator::new(&AllocatorCreateDesc {
            instance: device.instance.raw.clone(),
            device: device.raw.clone(),
            physical_device: probe.physical,
            debug_settings: Default::default(),
            buffer_device_address: false,
            allocation_sizes: gpu_allocator::AllocationSizes::new(4 << 20, 4 << 20),
        })
        .map_err(|source| Error::Allocation {
            what: "the allocator".into(),
            reason: source.to_string(),
        })?;
        // What comes from a cache has no statistics on some drivers.
        let cache = if options.statistics {
            PipelineCache::none()
        } else {
            PipelineCache::open(&device, &probe, options.cache.as_deref())
        };
        #[cfg(feature = "window")]
        let swapchain = features
            .window
            .then(|| khr::swapchain::Device::new(&device.instance.raw, &device.raw));
        Ok(Arc::new(Self {
            queue,
            queue_family,
            allocator: ManuallyDrop::new(Arc::new(Mutex::new(allocator))),
            cache,
            cache_folder: options.cache.clone(),
            kept_pipelines: KeptPipelines::default(),
            calibration: CalibrationExtension::new(&device, &probe),
            #[cfg(feature = "window")]
            swapchain,
            sorts: Sorts::default(),
            statistics: options.statistics.then(|| Statistics::new(&device)),
            probe,
            queue_lock: Mutex::new(()),
            device,
        }))
    }

    /// Bytes that this program holds of the device's memory: what is in use, and what the allocator
    /// keeps in blocks.
    pub fn memory(&self) -> (u64, u64) {
        let report = self.lock_allocator().generate_report();
        (report.total_allocated_bytes, report.total_capacity_bytes)
    }

    /// The allocator of the device's memory, for libraries that allocate by themselves.
    ///
    /// # Safety
    /// It must be dropped, with all that was allocated from it, before the device.
    pub unsafe fn allocator(&self) -> Arc<Mutex<Allocator>> {
        Arc::clone(&self.allocator)
    }

    /// A pool of command buffers that are recorded once.
    pub fn command_pool(&self, name: &str) -> Result<CommandPool> {
        CommandPool::transient(&self.device, self.queue_family, name)
    }

    /// The allocator, for as long as the guard lives. A thread that panicked with it left it as
    /// good as before.
    pub(crate) fn lock_allocator(&self) -> MutexGuard<'_, Allocator> {
        self.allocator
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
    }

    /// From now on keeps every compute pipeline for as long as the device is open, and shares it
    /// between renderers. For programs that make many renderers one after the other: a pipeline
    /// takes some 0.1 to 1 MB of the host's memory.
    pub fn keep_pipelines(&self) {
        self.kept_pipelines.keep();
    }

    /// Writes what the driver has compiled to disk, where something is new: a program that is
    /// killed has no later chance.
    pub fn save_pipelines(&self) {
        self.cache.save();
    }

    /// The one queue, for libraries that submit by themselves.
    ///
    /// # Safety
    /// While it is used, no other thread may submit to this device: nothing locks it. What is
    /// submitted must end while all that it uses is alive.
    pub unsafe fn queue(&self) -> vk::Queue {
        self.queue
    }

    /// The queue, for as long as the guard lives.
    fn lock_queue(&self) -> MutexGuard<'_, ()> {
        self.queue_lock
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
    }

    /// Submits work, whose end a fence tells.
    ///
    /// # Errors
    /// When the device fails, or was opened for [`GpuOptions::statistics`].
    ///
    /// # Safety
    /// The command buffers must be recorded, the fence unsignalled, and it and the semaphores free
    /// and of this device. Everything that the work uses must stay alive until the fence is
    /// signalled, or for ever where it never is.
    pub(crate) unsafe fn submit(&self, work: &[vk::SubmitInfo], fence: &Fence) -> Result<()> {
        if self.statistics.is_some() {
            return Err(Error::AskedOnly {
                device: self.probe.name.clone(),
            });
        }
        let _queue = self.lock_queue();
        // SAFETY: the caller promises that commands, fence and semaphores are ready and stay alive.
        unsafe { self.raw.queue_submit(self.queue, work, fence.raw()) }.during("vkQueueSubmit")
    }

    /// Hands images to their windows. True where one no longer fits its window well.
    ///
    /// # Safety
    /// The images must be acquired, and submitted work must signal the semaphores; all of them, and
    /// the swapchains, must be alive and of this device.
    #[cfg(feature = "window")]
    pub(crate) unsafe fn present(
        &self,
        loader: &khr::swapchain::Device,
        info: &vk::PresentInfoKHR,
    ) -> std::result::Result<bool, vk::Result> {
        let _queue = self.lock_queue();
        // SAFETY: the caller promises that images and semaphores are ready.
        unsafe { loader.queue_present(self.queue, info) }
    }

    /// Waits until the queue has done all its work, but not for ever.
    pub fn idle(&self) -> Result<()> {
        let fence = Fence::unsignalled(&self.device, "idle")?;
        // SAFETY: the fence is new; if the wait for it fails because the device hangs, it is left
        // alone.
        unsafe { self.submit(&[], &fence) }?;
        fence.wait("all submitted work")
    }

    /// Records commands, runs them and waits: for set-up and read-back, never in a frame. Leaves it
    /// all out on a device that was opened for [`GpuOptions::statistics`], since pipelines don't
    /// depend on what is in buffers.
    pub fn run(&self, what: &'static str, record: impl FnOnce(Recording)) -> Result<()> {
        if self.statistics.is_some() {
            return Ok(());
        }
        let pool = self.command_pool(what)?;
        let fence = Fence::unsignalled(&self.device, what)?;
        let commands = pool.allocate(what)?;
        let begin = vk::CommandBufferBeginInfo::default()
            .flags(vk::CommandBufferUsageFlags::ONE_TIME_SUBMIT);
        // SAFETY: the command buffer is new.
        unsafe { self.raw.begin_command_buffer(commands, &begin) }
            .during("vkBeginCommandBuffer")?;
        // SAFETY: the command buffer is recording until the end of the call.
        record(unsafe { Recording::new(self, commands) });
        // SAFETY: the command buffer is recording.
        unsafe { self.raw.end_command_buffer(commands) }.during("vkEndCommandBuffer")?;
        let buffers = [commands];
        let work = vk::SubmitInfo::default().command_buffers(&buffers);
        // SAFETY: the commands are recorded and the fence is new; what they use lives until the
        // wait below is over, or is left alone where the device hangs.
        unsafe { self.submit(&[work], &fence) }?;
        fence.wait(what)
    }
}

impl Drop for Gpu {
    fn drop(&mut self) {
        if self.hangs() {
            return;
        }
        self.cache.save();
        // SAFETY: everything that holds memory holds a reference to this, so the allocator is not
        // used again.
        unsafe { ManuallyDrop::drop(&mut self.allocator) };
    }
}

fn choose(mut probes: Vec<Probe>, wanted: Option<&str>) -> Result<Probe> {
    let Some(wanted) = wanted else {
        probes.sort_by_key(|probe| (!probe.missing_requirements().is_empty(), probe.rank()));
        return probes.into_iter().next().ok_or(Error::NoDevice);
    };
    let by_number = wanted
        .parse()
        .ok()
        .filter(|&number: &usize| number < probes.len());
    // A name may be the beginning of another's.
    let by_name = || probes.iter().position(|probe| probe.name == wanted);
    let by_part = || {
        probes
            .iter()
            .position(|probe| probe.name.to_lowercase().contains(&wanted.to_lowercase()))
    };
    if let Some(found) = by_number.or_else(by_name).or_else(by_part) {
        return Ok(probes.swap_remove(found));
    }
    if probes.is_empty() {
        return Err(Error::NoDevice);
    }
    let found: Vec<_> = probes
        .iter()
        .map(|probe| format!("`{}`", probe.name))
        .collect();
    Err(Error::NoSuchDevice {
        wanted: wanted.into(),
        found: found.join(", "),
    })
}
