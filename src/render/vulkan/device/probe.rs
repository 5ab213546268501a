//! Limits, features and extensions of a device.

use super::{
    error::{During, Result},
    instance::Instance,
};
use crate::quirks;
use ash::{ext, google, khr, vk};
use effigy_core::{
    frame::RasterMethod,
    layout::{SHARED_WORKGROUP, SORT_WORKGROUP},
};
use std::ffi::CStr;

/// The properties of a physical device.
#[derive(Clone, Debug)]
pub struct Probe {
    /// Its handle, of the instance that was probed.
    pub physical: vk::PhysicalDevice,
    /// The device's name.
    pub name: String,
    /// Discrete, integrated, virtual or CPU.
    pub kind: vk::PhysicalDeviceType,
    /// The highest Vulkan version that it supports; see [`version`].
    pub api_version: u32,
    /// The driver's name and build; empty if it does not report them.
    pub driver: String,
    /// Identifies the driver's build: results measured with one driver are not used for another.
    pub driver_uuid: [u8; 16],
    /// Changes with anything that makes old pipeline caches useless.
    pub cache_uuid: [u8; 16],
    /// PCI vendor, or a Khronos vendor number.
    pub vendor: u32,
    /// The vendor's number of the device.
    pub device: u32,
    /// The device's limits.
    pub limits: vk::PhysicalDeviceLimits,
    /// A queue family that does graphics and compute.
    pub queue_family: Option<u32>,
    /// Valid bits of that family's timestamps; 0 if it has no timestamps.
    pub timestamp_bits: u32,
    /// The driver reports statistics of compiled shaders.
    pub shader_statistics: bool,
    /// Fragments can be counted.
    pub pipeline_statistics: bool,
    /// Default subgroup size, invocations; 0 without Vulkan 1.1.
    pub subgroup_size: u32,
    /// Whether compute shaders have basic subgroup operations and ballots.
    pub subgroup_ballot: bool,
    /// Whether compute shaders also have votes, sums and shuffles.
    pub subgroup_shuffle: bool,
    /// Smallest and largest size of the subgroups that fill the sort's workgroups. None if the
    /// driver chooses the size.
    pub subgroup_sizes: Option<[u32; 2]>,
    /// The driver's version number, as it writes it.
    pub driver_version: u32,
    /// Names of the device extensions.
    pub extensions: Vec<String>,
    /// Bytes of the largest memory heap that is the device's own.
    pub device_memory: u64,
}

impl Probe {
    /// Whether the driver runs on the CPU.
    pub fn is_cpu(&self) -> bool {
        self.kind == vk::PhysicalDeviceType::CPU
    }

    /// The requirement of a method that it does not meet. None if it can draw by the method.
    pub fn lacks_for(&self, method: RasterMethod) -> Option<&'static str> {
        let [width, ..] = self.limits.max_compute_work_group_size;
        let invocations = width.min(self.limits.max_compute_work_group_invocations);
        match method {
            RasterMethod::Quads if !self.draws_triangles() => {
                Some("for quads: a driver that survives drawing triangles")
            }
            RasterMethod::CooperativeTiles if quirks::compiles_shuffles_slowly(&self.driver) => {
                Some("for cooperative tiles: a driver that compiles them in less than 10 s")
            }
            RasterMethod::CooperativeTiles
                if !self.subgroup_shuffle || ![4, 8].contains(&self.subgroup_size) =>
            {
                Some("for cooperative tiles: subgroups of 4 or 8 with shuffles")
            }
            RasterMethod::SharedTiles if invocations < SHARED_WORKGROUP => {
                Some("for shared-memory tiles: workgroups of 256 invocations")
            }
            _ => None,
        }
    }

    /// Whether the driver can draw triangles without crashing.
    pub fn draws_triangles(&self) -> bool {
        quirks::draws_triangles(&self.name)
    }

    /// Probes every physical device of an instance.
    pub fn all(instance: &Instance) -> Result<Vec<Self>> {
        // SAFETY: the instance is alive.
        let devices = unsafe { instance.raw.enumerate_physical_devices() }
            .during("vkEnumeratePhysicalDevices")?;
        devices
            .into_iter()
            .map(|physical| Self::new(instance, physical))
            .collect()
    }

    fn new(instance: &Instance, physical: vk::PhysicalDevice) -> Result<Self> {
        let raw = &instance.raw;
        // SAFETY: the device comes from this instance.
        let basic = unsafe { raw.get_physical_device_properties(physical) };
        // SAFETY: the device comes from this instance.
        let extensions = unsafe { raw.enumerate_device_extension_properties(physical) }
            .during("vkEnumerateDeviceExtensionProperties")?;
        let extensions: Vec<String> = extensions
            .iter()
            .map(|e| text(e.extension_name_as_c_str()))
            .collect();
        let chained = Chained::of(instance, physical, basic.api_version, &extensions);
        // SAFETY: the device comes from this instance.
        let families = unsafe { raw.get_physical_device_queue_family_properties(physical) };
        // SAFETY: the device comes from this instance.
        let memory = unsafe { raw.get_physical_device_memory_properties(physical) };
        // SAFETY: the device comes from this instance.
        let core = unsafe { raw.get_physical_device_features(physical) };
        let wanted = vk::QueueFlags::GRAPHICS | vk::QueueFlags::COMPUTE;
        let queue_family = families
            .iter()
            .position(|family| family.queue_flags.contains(wanted));
        let own = |heap: &&vk::MemoryHeap| heap.flags.contains(vk::MemoryHeapFlags::DEVICE_LOCAL);
        use vk::SubgroupFeatureFlags as Subgroup;
        let ballot = Subgroup::BASIC | Subgroup::BALLOT;
        let shuffle = ballot | Subgroup::VOTE | Subgroup::ARITHMETIC | Subgroup::SHUFFLE;
        Ok(Self {
            physical,
            name: text(basic.device_name_as_c_str()),
            kind: basic.device_type,
            api_version: basic.api_version,
            driver: chained.driver(),
            driver_uuid: chained.id.driver_uuid,
            cache_uuid: basic.pipeline_cache_uuid,
            vendor: basic.vendor_id,
            device: basic.device_id,
            limits: basic.limits,
            queue_family: queue_family.map(|family| family as u32),
            timestamp_bits: queue_family.map_or(0, |family| families[family].timestamp_valid_bits),
            pipeline_statistics: core.pipeline_statistics_query == vk::TRUE,
            shader_statistics: chained.executables.pipeline_executable_info == vk::TRUE,
            subgroup_size: chained.subgroup.subgroup_size,
            subgroup_shuffle: chained.has_subgroup(shuffle),
            subgroup_ballot: chained.has_subgroup(ballot),
            subgroup_sizes: chained.subgroup_sizes(),
            driver_version: basic.driver_version,
            extensions,
            device_memory: memory
                .memory_heaps_as_slice()
                .iter()
                .filter(own)
                .map(|heap| heap.size)
                .max()
                .unwrap_or(0),
        })
    }

    /// The bits of a timestamp that count.
    pub fn tick_mask(&self) -> u64 {
        if self.timestamp_bits >= 64 {
            u64::MAX
        } else {
            (1 << self.timestamp_bits) - 1
        }
    }

    /// Whether it has a device extension.
    pub fn has(&self, extension: &CStr) -> bool {
        contains(&self.extensions, extension)
    }

    /// This device, reduced to what Vulkan 1.1 promises of every device.
    pub fn baseline(mut self) -> Self {
        let limits = &mut self.limits;
        limits.max_storage_buffer_range = limits.max_storage_buffer_range.min(1 << 27);
        limits.max_compute_shared_memory_size = limits.max_compute_shared_memory_size.min(16 << 10);
        limits.max_compute_work_group_invocations =
            limits.max_compute_work_group_invocations.min(128);
        limits.max_compute_work_group_size = [128, 128, 64];
        limits.max_image_dimension2_d = limits.max_image_dimension2_d.min(4096);
        limits.max_framebuffer_width = limits.max_framebuffer_width.min(4096);
        limits.max_framebuffer_height = limits.max_framebuffer_height.min(4096);
        let needed = [khr::swapchain::NAME, khr::portability_subset::NAME];
        self.extensions
            .retain(|extension| needed.iter().any(|name| name.to_str() == Ok(extension)));
        Self {
            api_version: vk::API_VERSION_1_1.min(self.api_version),
            timestamp_bits: 0,
            shader_statistics: false,
            pipeline_statistics: false,
            subgroup_ballot: false,
            subgroup_shuffle: false,
            subgroup_sizes: None,
            ..self
        }
    }

    /// Requirements that the device does not meet; empty if it can be used.
    pub fn missing_requirements(&self) -> Vec<String> {
        let mut missing = Vec::new();
        if self.api_version < vk::API_VERSION_1_1 {
            missing.push(format!(
                "it has Vulkan {}, Vulkan 1.1 is needed",
                version(self.api_version)
            ));
        }
        if self.queue_family.is_none() {
            missing.push("no queue does both graphics and compute".into());
        }
        missing
    }

    /// Whether windows report their refreshes. The times are those of the system's monotonic clock,
    /// which can be read on Android only; elsewhere no window system has the extension so far.
    pub(crate) fn has_display_timing(&self) -> bool {
        cfg!(target_os = "android") && self.has(google::display_timing::NAME)
    }

    /// The extension that reads the device's clock, under either of its names.
    pub fn clock_extension(&self) -> Option<&'static CStr> {
        let names = [
            khr::calibrated_timestamps::NAME,
            ext::calibrated_timestamps::NAME,
        ];
        names
            .into_iter()
            .find(|name| self.timestamp_bits > 0 && self.has(name))
    }

    /// Discrete before integrated before virtual before CPU.
    pub(crate) fn rank(&self) -> u32 {
        match self.kind {
            vk::PhysicalDeviceType::DISCRETE_GPU => 0,
            vk::PhysicalDeviceType::INTEGRATED_GPU => 1,
            vk::PhysicalDeviceType::VIRTUAL_GPU => 2,
            vk::PhysicalDeviceType::CPU => 3,
            _ => 4,
        }
    }
}

/// Properties and features that Vulkan 1.0 does not report; zeros where the device does not either.
#[derive(Default)]
struct Chained {
    subgroup: vk::PhysicalDeviceSubgroupProperties<'static>,
    id: vk::PhysicalDeviceIDProperties<'static>,
    driver: vk::PhysicalDeviceDriverProperties<'static>,
    sizes: vk::PhysicalDeviceSubgroupSizeControlProperties<'static>,
    size_control: vk::PhysicalDeviceSubgroupSizeControlFeatures<'static>,
    executables: vk::PhysicalDevicePipelineExecutablePropertiesFeaturesKHR<'static>,
}

impl Chained {
    /// What a device reports, which has these extensions.
    fn of(
        instance: &Instance,
        physical: vk::PhysicalDevice,
        api_version: u32,
        extensions: &[String],
    ) -> Self {
        let mut own = Self::default();
        if api_version < vk::API_VERSION_1_1 {
            return own;
        }
        let has = |extension| contains(extensions, extension);
        let has_driver = has(khr::driver_properties::NAME) || api_version >= vk::API_VERSION_1_2;
        let has_sizes = has(ext::subgroup_size_control::NAME);
        let has_executables = has(khr::pipeline_executable_properties::NAME);
        let properties: [(bool, &mut dyn vk::ExtendsPhysicalDeviceProperties2); 4] = [
            (true, &mut own.subgroup),
            (true, &mut own.id),
            (has_driver, &mut own.driver),
            (has_sizes, &mut own.sizes),
        ];
        let features: [(bool, &mut dyn vk::ExtendsPhysicalDeviceFeatures2); 2] = [
            (has_sizes, &mut own.size_control),
            (has_executables, &mut own.executables),
        ];
        let mut all_properties = vk::PhysicalDeviceProperties2::default();
        for (_, structure) in properties.into_iter().filter(|(reported, _)| *reported) {
            all_properties = all_properties.push_next(structure);
        }
        let mut all_features = vk::PhysicalDeviceFeatures2::default();
        for (_, structure) in features.into_iter().filter(|(reported, _)| *reported) {
            all_features = all_features.push_next(structure);
        }
        // SAFETY: the device comes from this instance, and has Vulkan 1.1; the structures that are
        // chained live to the end of the function.
        unsafe {
            let raw = &instance.raw;
            raw.get_physical_device_properties2(physical, &mut all_properties);
            raw.get_physical_device_features2(physical, &mut all_features);
        }
        own
    }

    /// [`Probe::driver`].
    fn driver(&self) -> String {
        let name = text(self.driver.driver_name_as_c_str());
        let info = text(self.driver.driver_info_as_c_str());
        format!("{name} {info}").trim().to_string()
    }

    /// Whether compute shaders have subgroup operations.
    fn has_subgroup(&self, operations: vk::SubgroupFeatureFlags) -> bool {
        let subgroup = &self.subgroup;
        subgroup.supported_operations.contains(operations)
            && subgroup
                .supported_stages
                .contains(vk::ShaderStageFlags::COMPUTE)
    }

    /// [`Probe::subgroup_sizes`].
    fn subgroup_sizes(&self) -> Option<[u32; 2]> {
        let sizes = &self.sizes;
        let is_chosen = self.size_control.subgroup_size_control == vk::TRUE
            && self.size_control.compute_full_subgroups == vk::TRUE
            && sizes
                .required_subgroup_size_stages
                .contains(vk::ShaderStageFlags::COMPUTE);
        is_chosen.then(|| {
            let fewest = SORT_WORKGROUP
                .div_ceil(sizes.max_compute_workgroup_subgroups.max(1))
                .next_power_of_two();
            [
                sizes.min_subgroup_size.max(fewest),
                sizes.max_subgroup_size.min(SORT_WORKGROUP),
            ]
        })
    }
}

/// A driver's text; empty if it is not terminated.
fn text<E>(text: std::result::Result<&CStr, E>) -> String {
    text.map_or(String::new(), |s| s.to_string_lossy().into_owned())
}

fn contains(extensions: &[String], extension: &CStr) -> bool {
    extensions.iter().any(|e| extension.to_str() == Ok(e))
}

/// A Vulkan version number as people write it.
pub fn version(version: u32) -> String {
    format!(
        "{}.{}.{}",
        vk::api_version_major(version),
        vk::api_version_minor(version),
        vk::api_version_patch(version)
    )
}
