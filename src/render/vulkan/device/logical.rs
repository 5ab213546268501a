//! The logical device: what everything made from it keeps alive.

use super::{
    error::{During, Result},
    instance::Instance,
    probe::Probe,
};
use ash::{ext, google, khr, vk};
use std::{
    ffi::{CStr, CString},
    mem::ManuallyDrop,
    sync::{
        Arc,
        atomic::{AtomicBool, Ordering},
    },
    time::Duration,
};

/// How long any wait for the device may take before it counts as hung.
const PATIENCE: Duration = Duration::from_secs(30);
/// The limit for CPU drivers: they compile while they are waited for, and other programs may keep
/// the CPU busy.
const PATIENCE_CPU: Duration = Duration::from_secs(120);

/// Optional features that a logical device is opened with.
#[derive(Clone, Copy, Debug)]
pub(crate) struct DeviceFeatures {
    /// Swapchains.
    pub window: bool,
    /// Pipelines tell what the driver's compiler made of them.
    pub statistics: bool,
}

/// A logical device and its instance. Both are destroyed when nothing made from the device is left,
/// or left to the process's end where the device hangs: destroying it would wait for its work on
/// some drivers, for ever.
pub struct Device {
    /// The device's functions and handle.
    pub raw: ash::Device,
    /// The instance, destroyed after the device.
    pub(crate) instance: ManuallyDrop<Instance>,
    /// Names objects and labels commands, where the loader can.
    pub(crate) labels: Option<ext::debug_utils::Device>,
    /// How long a wait may take.
    patience: Duration,
    /// Set when the device did not finish in time. It may still use what it was given, so nothing
    /// of it is destroyed.
    hangs: AtomicBool,
}

impl Device {
    /// Opens the device that `probe` looked at, with one queue of a family.
    pub(crate) fn new(
        instance: Instance,
        probe: &Probe,
        queue_family: u32,
        features: DeviceFeatures,
    ) -> Result<Arc<Self>> {
        let raw = create(&instance, probe, queue_family, features)?;
        Ok(Arc::new(Self {
            labels: instance
                .debug_utils
                .then(|| ext::debug_utils::Device::new(&instance.raw, &raw)),
            patience: if probe.is_cpu() {
                PATIENCE_CPU
            } else {
                PATIENCE
            },
            raw,
            instance: ManuallyDrop::new(instance),
            hangs: AtomicBool::new(false),
        }))
    }

    /// How long a wait may take before the device counts as hung.
    pub(crate) fn patience(&self) -> Duration {
        self.patience
    }

    /// Whether it left a wait unanswered. What it may still use is then not destroyed: the
    /// process's end does that.
    pub fn hangs(&self) -> bool {
        self.hangs.load(Ordering::Relaxed)
    }

    /// Notes that it left a wait unanswered.
    pub(crate) fn note_hang(&self) {
        self.hangs.store(true, Ordering::Relaxed);
    }

    /// Gives an object the name that validation messages and GPU profilers show.
    ///
    /// # Safety
    /// The object must be alive and of this device, or null.
    pub(crate) unsafe fn name<H: vk::Handle + Copy>(&self, object: H, name: &str) {
        let Some(labels) = &self.labels else { return };
        let Ok(name) = CString::new(name) else { return };
        if object.as_raw() == 0 {
            return;
        }
        let info = vk::DebugUtilsObjectNameInfoEXT::default()
            .object_handle(object)
            .object_name(&name);
        // SAFETY: the caller promises that the object is alive and of this device. A name that
        // can't be set costs nothing.
        let _ = unsafe { labels.set_debug_utils_object_name(&info) };
    }
}

impl Drop for Device {
    fn drop(&mut self) {
        if self.hangs() {
            return;
        }
        // SAFETY: everything made from the device holds a reference to it, so nothing is left. The
        // instance is not used again.
        unsafe {
            self.raw.destroy_device(None);
            ManuallyDrop::drop(&mut self.instance);
        }
    }
}

/// Names of the device extensions that are used.
fn extensions(probe: &Probe, features: DeviceFeatures) -> Vec<&'static CStr> {
    let mut extensions = Vec::new();
    if features.window {
        extensions.push(khr::swapchain::NAME);
        if probe.has_display_timing() {
            extensions.push(google::display_timing::NAME);
        }
    }
    if probe.has(khr::portability_subset::NAME) {
        extensions.push(khr::portability_subset::NAME);
    }
    if probe.subgroup_sizes.is_some() {
        extensions.push(ext::subgroup_size_control::NAME);
    }
    extensions.extend(probe.clock_extension());
    if features.statistics {
        extensions.push(khr::pipeline_executable_properties::NAME);
    }
    extensions
}

fn create(
    instance: &Instance,
    probe: &Probe,
    queue_family: u32,
    features: DeviceFeatures,
) -> Result<ash::Device> {
    let queues = [vk::DeviceQueueCreateInfo::default()
        .queue_family_index(queue_family)
        .queue_priorities(&[1.0])];
    let extensions: Vec<_> = extensions(probe, features)
        .iter()
        .map(|name| name.as_ptr())
        .collect();
    let mut executables = vk::PhysicalDevicePipelineExecutablePropertiesFeaturesKHR::default()
        .pipeline_executable_info(true);
    let mut sizes = vk::PhysicalDeviceSubgroupSizeControlFeatures::default()
        .subgroup_size_control(true)
        .compute_full_subgroups(true);
    let core =
        vk::PhysicalDeviceFeatures::default().pipeline_statistics_query(probe.pipeline_statistics);
    let mut info = vk::DeviceCreateInfo::default()
        .queue_create_infos(&queues)
        .enabled_extension_names(&extensions)
        .enabled_features(&core);
    if features.statistics {
        info = info.push_next(&mut executables);
    }
    if probe.subgroup_sizes.is_some() {
        info = info.push_next(&mut sizes);
    }
    // SAFETY: the device comes from this instance; `info` and all it points to outlive the call.
    unsafe { instance.raw.create_device(probe.physical, &info, None) }.during("vkCreateDevice")
}
