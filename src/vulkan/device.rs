//! The device in use: its queue, its memory, its pipeline cache, and the one place where commands are submitted and waited for.

use super::{
    cache::PipelineCache,
    calibration::Calibration,
    error::{During, Error, Result},
    instance::Instance,
    probe::Probe,
    sort::{
        Variant,
        verdict::{Outcome, Verdict},
    },
    statistics::Statistics,
    timing,
};
use ash::{ext, khr, vk};
use gpu_allocator::vulkan::{Allocator, AllocatorCreateDesc};
use std::{
    mem::ManuallyDrop,
    sync::{
        Arc, Mutex, MutexGuard, OnceLock,
        atomic::{AtomicBool, Ordering},
    },
    time::Duration,
};

/// How long any wait for the device may take before it counts as hung.
const PATIENCE: Duration = Duration::from_secs(30);
/// The same where a processor plays the device: it compiles while it is waited for, and others may keep it busy.
const PATIENCE_CPU: Duration = Duration::from_secs(120);

/// What a program wants of the device it is given.
#[derive(Clone, Debug, Default)]
pub struct GpuOptions {
    /// Part of a device's name, in any case, or its number in `effigy devices`. None: the first that can serve, GPUs before CPUs.
    pub device: Option<String>,
    /// Load the validation layer, synchronisation checks included.
    pub validation: bool,
    /// Read f16 as words even where the device has 16-bit storage: to compare the two.
    pub packed_words: bool,
    /// Use no more than every Vulkan 1.1 device has, as if the device were the least of them.
    pub least: bool,
    /// Ask what the driver's compiler makes of each pipeline. Nothing ever runs on a device opened so.
    pub statistics: bool,
    /// Instance extensions of a window's surface; empty draws to pictures only.
    pub surface_extensions: Vec<*const std::ffi::c_char>,
}

impl GpuOptions {
    /// Without a window; validation as the environment variable `EFFIGY_VALIDATION` says (anything but 0 turns it on).
    pub fn headless(device: Option<String>) -> Self {
        let validation = std::env::var_os("EFFIGY_VALIDATION").is_some_and(|value| value != "0");
        Self { device, validation, ..Self::default() }
    }
}

/// A Vulkan device with one queue for everything.
pub struct Gpu {
    pub raw: ash::Device,
    pub queue: vk::Queue,
    pub queue_family: u32,
    pub allocator: ManuallyDrop<Arc<Mutex<Allocator>>>,
    pub cache: PipelineCache,
    pub probe: Probe,
    /// Whether shaders read f16 from storage buffers.
    pub half_storage: bool,
    pub labels: Option<ext::debug_utils::Device>,
    /// Reads the device's clock.
    pub(super) calibration: Option<Calibration>,
    pub swapchain: Option<khr::swapchain::Device>,
    /// How to sort here, once it is known: see [`super::sort::choice::choose`].
    pub(super) sort: OnceLock<Verdict>,
    /// How the variants did that somebody asked for by name: see [`super::sort::choice::allow`].
    pub(super) asked: Mutex<Vec<(Variant, Outcome)>>,
    /// Where the device was opened for [`GpuOptions::statistics`].
    pub(super) statistics: Option<Statistics>,
    pub instance: ManuallyDrop<Instance>,
    /// Vulkan wants one thread at a time at a queue; renderers on one device may be on several.
    turn: Mutex<()>,
    /// Set when the device did not finish in time: it may still use what it was given, so nothing of it is destroyed.
    hangs: AtomicBool,
}

impl Gpu {
    /// Opens a device.
    pub fn new(options: &GpuOptions) -> Result<Arc<Self>> {
        let instance = Instance::new(options.validation, &options.surface_extensions)?;
        let probe = choose(Probe::all(&instance)?, options.device.as_deref())?;
        let probe = if options.least { probe.least() } else { probe };
        let lacks = probe.lacks();
        let (true, Some(queue_family)) = (lacks.is_empty(), probe.queue_family) else {
            return Err(Error::Lacks { device: probe.name, lacks: lacks.join("; ") });
        };
        if options.statistics && !probe.shader_statistics {
            return Err(Error::NoStatistics { device: probe.name });
        }
        let half_storage = probe.half_storage && !options.packed_words;
        let window = !options.surface_extensions.is_empty() && probe.has(khr::swapchain::NAME);
        let raw = create_device(&instance, &probe, queue_family, [half_storage, window, options.statistics])?;
        // SAFETY: the family and the one queue were asked for at creation.
        let queue = unsafe { raw.get_device_queue(queue_family, 0) };
        let description = AllocatorCreateDesc {
            instance: instance.raw.clone(),
            device: raw.clone(),
            physical_device: probe.physical,
            debug_settings: Default::default(),
            buffer_device_address: false,
            allocation_sizes: gpu_allocator::AllocationSizes::new(4 << 20, 4 << 20),
        };
        let allocator = Allocator::new(&description).map_err(|source| {
            // SAFETY: nothing was made from the device yet.
            unsafe { raw.destroy_device(None) };
            Error::Allocation { what: "the allocator".into(), source }
        })?;
        let gpu = Arc::new(Self {
            queue,
            queue_family,
            allocator: ManuallyDrop::new(Arc::new(Mutex::new(allocator))),
            // What comes from a cache has no statistics on some drivers.
            cache: if options.statistics { PipelineCache::none() } else { PipelineCache::open(&raw, &probe) },
            statistics: options.statistics.then(|| Statistics::new(&instance.raw, &raw)),
            half_storage,
            labels: instance.debug_utils.then(|| ext::debug_utils::Device::new(&instance.raw, &raw)),
            calibration: Calibration::new(&instance, &probe, &raw),
            swapchain: window.then(|| khr::swapchain::Device::new(&instance.raw, &raw)),
            raw,
            probe,
            sort: OnceLock::new(),
            asked: Mutex::default(),
            instance: ManuallyDrop::new(instance),
            turn: Mutex::new(()),
            hangs: AtomicBool::new(false),
        });
        gpu.name(gpu.queue, "frames");
        gpu.name(gpu.cache.raw, "pipelines");
        Ok(gpu)
    }

    /// Bytes that this program holds of the device's memory: what is in use, and what the allocator keeps in blocks.
    pub fn memory(&self) -> (u64, u64) {
        let allocator = self.allocator.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
        let report = allocator.generate_report();
        (report.total_allocated_bytes, report.total_capacity_bytes)
    }

    /// Writes what the driver has compiled to disk, where something is new: a program that is killed has no later chance.
    pub fn save_pipelines(&self) {
        self.cache.save(&self.raw);
    }

    /// Whether it left a wait unanswered. What it may still use is then not destroyed: the process's end does that.
    pub(crate) fn hangs(&self) -> bool {
        self.hangs.load(Ordering::Relaxed)
    }

    /// Destroys what no submitted work uses. Where the device hangs it is left as it is.
    pub(super) fn destroy(&self, destroy: impl FnOnce(&ash::Device)) {
        if !self.hangs() {
            destroy(&self.raw);
        }
    }

    /// Waits for a fence, but not for ever.
    pub fn wait(&self, fence: vk::Fence, what: &'static str) -> Result<()> {
        let patience = if self.probe.is_cpu() { PATIENCE_CPU } else { PATIENCE };
        // SAFETY: the fence is alive and of this device.
        match unsafe { self.raw.wait_for_fences(&[fence], true, patience.as_nanos() as u64) } {
            Err(vk::Result::TIMEOUT) => {
                self.hangs.store(true, Ordering::Relaxed);
                Err(Error::Timeout { what, seconds: patience.as_secs() })
            }
            result => result.during("vkWaitForFences"),
        }
    }

    /// Waits its turn at the queue, for as long as the guard lives.
    fn at_queue(&self) -> MutexGuard<'_, ()> {
        self.turn.lock().unwrap_or_else(|poisoned| poisoned.into_inner())
    }

    /// Submits work and says when it is done through a fence.
    pub fn submit(&self, work: &[vk::SubmitInfo], fence: vk::Fence) -> Result<()> {
        if self.statistics.is_some() {
            return Err(Error::AskedOnly { device: self.probe.name.clone() });
        }
        let _turn = self.at_queue();
        // SAFETY: callers pass recorded commands and free fences and semaphores of this device.
        unsafe { self.raw.queue_submit(self.queue, work, fence) }.during("vkQueueSubmit")
    }

    /// Hands an image to a window. True where it no longer fits the window well.
    pub fn present(&self, loader: &khr::swapchain::Device, info: &vk::PresentInfoKHR) -> std::result::Result<bool, vk::Result> {
        let _turn = self.at_queue();
        // SAFETY: callers pass an acquired image and a semaphore that submitted work signals.
        unsafe { loader.queue_present(self.queue, info) }
    }

    /// Waits until the queue has done all its work, but not for ever.
    pub fn idle(&self) -> Result<()> {
        // SAFETY: the fence is made, used and destroyed here; a device that timed out keeps it.
        unsafe {
            let fence = self.raw.create_fence(&vk::FenceCreateInfo::default(), None).during("vkCreateFence")?;
            self.name(fence, "idle");
            let outcome = self.submit(&[], fence).and_then(|()| self.wait(fence, "all submitted work"));
            if !self.hangs() {
                self.raw.destroy_fence(fence, None);
            }
            outcome
        }
    }

    /// Records commands, runs them and waits: for set-up and read-back, never in a frame. Leaves it all out on a device that was opened
    /// for [`GpuOptions::statistics`], since pipelines don't depend on what is in buffers.
    pub fn run(&self, what: &'static str, record: impl FnOnce(vk::CommandBuffer)) -> Result<()> {
        if self.statistics.is_some() {
            return Ok(());
        }
        let device = &self.raw;
        let info = vk::CommandPoolCreateInfo::default().queue_family_index(self.queue_family).flags(vk::CommandPoolCreateFlags::TRANSIENT);
        // SAFETY: pool, buffer and fence are made, used and destroyed here; a device that timed out keeps them.
        unsafe {
            let pool = device.create_command_pool(&info, None).during("vkCreateCommandPool")?;
            self.name(pool, what);
            let fence = device.create_fence(&vk::FenceCreateInfo::default(), None).during("vkCreateFence");
            fence.iter().for_each(|&fence| self.name(fence, what));
            let outcome = fence.and_then(|fence| {
                let allocate = vk::CommandBufferAllocateInfo::default().command_pool(pool).command_buffer_count(1);
                let submitted = device.allocate_command_buffers(&allocate).during("vkAllocateCommandBuffers").and_then(|commands| {
                    self.name(commands[0], what);
                    let begin = vk::CommandBufferBeginInfo::default().flags(vk::CommandBufferUsageFlags::ONE_TIME_SUBMIT);
                    device.begin_command_buffer(commands[0], &begin).during("vkBeginCommandBuffer")?;
                    record(commands[0]);
                    device.end_command_buffer(commands[0]).during("vkEndCommandBuffer")?;
                    let submit = vk::SubmitInfo::default().command_buffers(&commands);
                    self.submit(&[submit], fence)?;
                    self.wait(fence, what)
                });
                if !matches!(submitted, Err(Error::Timeout { .. })) {
                    device.destroy_fence(fence, None);
                }
                submitted
            });
            if !matches!(outcome, Err(Error::Timeout { .. })) {
                device.destroy_command_pool(pool, None);
            }
            outcome
        }
    }
}

impl Drop for Gpu {
    fn drop(&mut self) {
        if self.hangs() {
            // Destroying a device waits for its work on some drivers, for ever: the process's end does it.
            return;
        }
        self.cache.save(&self.raw);
        // SAFETY: everything made from the device holds a reference to it, so nothing but these is left.
        unsafe {
            self.cache.destroy(&self.raw);
            ManuallyDrop::drop(&mut self.allocator);
            self.raw.destroy_device(None);
            ManuallyDrop::drop(&mut self.instance);
        }
    }
}

fn choose(mut probes: Vec<Probe>, wanted: Option<&str>) -> Result<Probe> {
    let Some(wanted) = wanted else {
        probes.sort_by_key(|probe| (!probe.lacks().is_empty(), probe.rank()));
        return probes.into_iter().next().ok_or(Error::NoDevice);
    };
    let by_number = wanted.parse().ok().filter(|&number: &usize| number < probes.len());
    let by_name = || probes.iter().position(|probe| probe.name.to_lowercase().contains(&wanted.to_lowercase()));
    match by_number.or_else(by_name) {
        Some(found) => Ok(probes.swap_remove(found)),
        None => {
            let found: Vec<_> = probes.iter().map(|probe| format!("`{}`", probe.name)).collect();
            Err(if found.is_empty() { Error::NoDevice } else { Error::NoSuchDevice { wanted: wanted.into(), found: found.join(", ") } })
        }
    }
}

fn create_device(
    instance: &Instance,
    probe: &Probe,
    queue_family: u32,
    [half_storage, window, statistics]: [bool; 3],
) -> Result<ash::Device> {
    let queues = [vk::DeviceQueueCreateInfo::default().queue_family_index(queue_family).queue_priorities(&[1.0])];
    let mut extensions = Vec::new();
    if window {
        extensions.extend(timing::extensions(probe));
    }
    extensions.extend(probe.has(khr::portability_subset::NAME).then(|| khr::portability_subset::NAME.as_ptr()));
    if probe.subgroup_sizes.is_some() {
        extensions.push(ext::subgroup_size_control::NAME.as_ptr());
    }
    extensions.extend(Calibration::extension(probe).map(std::ffi::CStr::as_ptr));
    if statistics {
        extensions.push(khr::pipeline_executable_properties::NAME.as_ptr());
    }
    let mut executables = vk::PhysicalDevicePipelineExecutablePropertiesFeaturesKHR::default().pipeline_executable_info(true);
    let mut sizes = vk::PhysicalDeviceSubgroupSizeControlFeatures::default().subgroup_size_control(true).compute_full_subgroups(true);
    let mut storage = vk::PhysicalDevice16BitStorageFeatures::default().storage_buffer16_bit_access(half_storage);
    let features = vk::PhysicalDeviceFeatures::default().pipeline_statistics_query(probe.pipeline_statistics);
    let mut info =
        vk::DeviceCreateInfo::default().queue_create_infos(&queues).enabled_extension_names(&extensions).enabled_features(&features);
    if half_storage {
        info = info.push_next(&mut storage);
    }
    if statistics {
        info = info.push_next(&mut executables);
    }
    if probe.subgroup_sizes.is_some() {
        info = info.push_next(&mut sizes);
    }
    // SAFETY: the device comes from this instance; `info` and all it points to outlive the call.
    unsafe { instance.raw.create_device(probe.physical, &info, None) }.during("vkCreateDevice")
}
