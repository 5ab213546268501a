//! What a device has: limits, features and extensions, and what Effigy makes of them. `effigy devices` prints it.

use super::{
    calibration::Calibration,
    error::{During, Result},
    instance::Instance,
};
use crate::{frame::options, layout::SORT_SIZE};
use ash::{ext, khr, vk};

/// A physical device, looked at.
#[derive(Clone, Debug)]
pub struct Probe {
    pub physical: vk::PhysicalDevice,
    pub name: String,
    pub kind: vk::PhysicalDeviceType,
    pub api_version: u32,
    pub driver: String,
    /// Identifies the driver's build: what was learned about one driver is not used for another.
    pub driver_uuid: [u8; 16],
    /// Changes with anything that makes old pipeline caches useless.
    pub cache_uuid: [u8; 16],
    pub vendor: u32,
    pub device: u32,
    pub limits: vk::PhysicalDeviceLimits,
    /// A family that does graphics and compute, and the bits of its timestamps.
    pub queue_family: Option<u32>,
    pub timestamp_bits: u32,
    pub half_storage: bool,
    /// The driver tells what its compiler makes of shaders.
    pub shader_statistics: bool,
    /// Fragments can be counted.
    pub pipeline_statistics: bool,
    pub subgroup_size: u32,
    /// Whether compute shaders have basic subgroup operations and ballots.
    pub subgroup_ballot: bool,
    /// Whether they have votes, sums and shuffles too.
    pub subgroup_shuffle: bool,
    /// Smallest and largest subgroup that the sort's workgroups may be made of, in full. None: the driver chooses.
    pub subgroup_sizes: Option<[u32; 2]>,
    /// The driver's version number, as it writes it.
    pub driver_version: u32,
    pub extensions: Vec<String>,
    /// Bytes of the largest memory heap that is the device's own.
    pub device_memory: u64,
}

impl Probe {
    /// Whether a processor plays the device.
    pub fn is_cpu(&self) -> bool {
        self.kind == vk::PhysicalDeviceType::CPU
    }

    /// Whether the driver survives drawing triangles.
    pub fn draws_triangles(&self) -> bool {
        options::draws_triangles(&self.name)
    }

    /// Looks at every device of an instance.
    pub fn all(instance: &Instance) -> Result<Vec<Self>> {
        // SAFETY: the instance is alive.
        let devices = unsafe { instance.raw.enumerate_physical_devices() }.during("vkEnumeratePhysicalDevices")?;
        devices.into_iter().map(|physical| Self::new(instance, physical)).collect()
    }

    fn new(instance: &Instance, physical: vk::PhysicalDevice) -> Result<Self> {
        let raw = &instance.raw;
        // SAFETY: the device comes from this instance; the structures chained below live to the end of the function.
        let basic = unsafe { raw.get_physical_device_properties(physical) };
        let text = |value: std::result::Result<&std::ffi::CStr, _>| value.map_or(String::new(), |s| s.to_string_lossy().into_owned());
        // SAFETY: as above.
        let extensions = unsafe { raw.enumerate_device_extension_properties(physical) }.during("vkEnumerateDeviceExtensionProperties")?;
        let extensions: Vec<String> = extensions.iter().map(|e| text(e.extension_name_as_c_str())).collect();
        let mut subgroup = vk::PhysicalDeviceSubgroupProperties::default();
        let mut id = vk::PhysicalDeviceIDProperties::default();
        let mut driver = vk::PhysicalDeviceDriverProperties::default();
        let mut storage = vk::PhysicalDevice16BitStorageFeatures::default();
        let mut sizes = vk::PhysicalDeviceSubgroupSizeControlProperties::default();
        let mut executables = vk::PhysicalDevicePipelineExecutablePropertiesFeaturesKHR::default();
        let mut sizes_chosen = vk::PhysicalDeviceSubgroupSizeControlFeatures::default();
        let has = |name: &std::ffi::CStr| extensions.iter().any(|e| name.to_str() == Ok(e));
        if basic.api_version >= vk::API_VERSION_1_1 {
            let mut properties = vk::PhysicalDeviceProperties2::default().push_next(&mut subgroup).push_next(&mut id);
            if has(khr::driver_properties::NAME) || basic.api_version >= vk::API_VERSION_1_2 {
                properties = properties.push_next(&mut driver);
            }
            let mut features = vk::PhysicalDeviceFeatures2::default().push_next(&mut storage);
            if has(ext::subgroup_size_control::NAME) {
                properties = properties.push_next(&mut sizes);
                features = features.push_next(&mut sizes_chosen);
            }
            if has(khr::pipeline_executable_properties::NAME) {
                features = features.push_next(&mut executables);
            }
            // SAFETY: as above.
            unsafe {
                raw.get_physical_device_properties2(physical, &mut properties);
                raw.get_physical_device_features2(physical, &mut features);
            }
        }
        // SAFETY: as above.
        let (families, memory) =
            unsafe { (raw.get_physical_device_queue_family_properties(physical), raw.get_physical_device_memory_properties(physical)) };
        let wanted = vk::QueueFlags::GRAPHICS | vk::QueueFlags::COMPUTE;
        let queue_family = families.iter().position(|family| family.queue_flags.contains(wanted));
        let own = |heap: &&vk::MemoryHeap| heap.flags.contains(vk::MemoryHeapFlags::DEVICE_LOCAL);
        use vk::SubgroupFeatureFlags as Subgroup;
        let subgroup_all = Subgroup::BASIC | Subgroup::BALLOT | Subgroup::VOTE | Subgroup::ARITHMETIC | Subgroup::SHUFFLE;
        let subgroup_basics = vk::SubgroupFeatureFlags::BASIC | vk::SubgroupFeatureFlags::BALLOT;
        let sizes_chosen = sizes_chosen.subgroup_size_control == vk::TRUE
            && sizes_chosen.compute_full_subgroups == vk::TRUE
            && sizes.required_subgroup_size_stages.contains(vk::ShaderStageFlags::COMPUTE);
        Ok(Self {
            physical,
            name: text(basic.device_name_as_c_str()),
            kind: basic.device_type,
            api_version: basic.api_version,
            driver: format!("{} {}", text(driver.driver_name_as_c_str()), text(driver.driver_info_as_c_str())).trim().to_string(),
            driver_uuid: id.driver_uuid,
            cache_uuid: basic.pipeline_cache_uuid,
            vendor: basic.vendor_id,
            device: basic.device_id,
            limits: basic.limits,
            queue_family: queue_family.map(|family| family as u32),
            timestamp_bits: queue_family.map_or(0, |family| families[family].timestamp_valid_bits),
            // SAFETY: as above.
            pipeline_statistics: unsafe { raw.get_physical_device_features(physical) }.pipeline_statistics_query == vk::TRUE,
            shader_statistics: executables.pipeline_executable_info == vk::TRUE,
            half_storage: storage.storage_buffer16_bit_access == vk::TRUE,
            subgroup_size: subgroup.subgroup_size,
            subgroup_shuffle: subgroup.supported_operations.contains(subgroup_all)
                && subgroup.supported_stages.contains(vk::ShaderStageFlags::COMPUTE),
            subgroup_ballot: subgroup.supported_operations.contains(subgroup_basics)
                && subgroup.supported_stages.contains(vk::ShaderStageFlags::COMPUTE),
            subgroup_sizes: sizes_chosen.then(|| {
                let fewest = SORT_SIZE.div_ceil(sizes.max_compute_workgroup_subgroups.max(1)).next_power_of_two();
                [sizes.min_subgroup_size.max(fewest), sizes.max_subgroup_size.min(SORT_SIZE)]
            }),
            driver_version: basic.driver_version,
            extensions,
            device_memory: memory.memory_heaps_as_slice().iter().filter(own).map(|heap| heap.size).max().unwrap_or(0),
        })
    }

    /// The bits of a timestamp that count.
    pub fn tick_mask(&self) -> u64 {
        if self.timestamp_bits >= 64 { u64::MAX } else { (1 << self.timestamp_bits) - 1 }
    }

    pub fn has(&self, extension: &std::ffi::CStr) -> bool {
        self.extensions.iter().any(|e| extension.to_str() == Ok(e))
    }

    /// The same device with nothing that Vulkan 1.1 does not promise of every device.
    pub fn least(mut self) -> Self {
        let limits = &mut self.limits;
        limits.max_storage_buffer_range = limits.max_storage_buffer_range.min(1 << 27);
        limits.max_compute_shared_memory_size = limits.max_compute_shared_memory_size.min(16 << 10);
        limits.max_compute_work_group_invocations = limits.max_compute_work_group_invocations.min(128);
        limits.max_compute_work_group_size = [128, 128, 64];
        limits.max_image_dimension2_d = limits.max_image_dimension2_d.min(4096);
        limits.max_framebuffer_width = limits.max_framebuffer_width.min(4096);
        limits.max_framebuffer_height = limits.max_framebuffer_height.min(4096);
        let needed = [khr::swapchain::NAME, khr::portability_subset::NAME];
        self.extensions.retain(|extension| needed.iter().any(|name| name.to_str() == Ok(extension)));
        Self {
            api_version: vk::API_VERSION_1_1.min(self.api_version),
            timestamp_bits: 0,
            half_storage: false,
            shader_statistics: false,
            pipeline_statistics: false,
            subgroup_ballot: false,
            subgroup_shuffle: false,
            subgroup_sizes: None,
            ..self
        }
    }

    /// What the device would need and does not have; empty where it can serve.
    pub fn lacks(&self) -> Vec<String> {
        let mut lacks = Vec::new();
        if self.api_version < vk::API_VERSION_1_1 {
            lacks.push(format!("it has Vulkan {}, Vulkan 1.1 is needed", version(self.api_version)));
        }
        if self.queue_family.is_none() {
            lacks.push("no queue does both graphics and compute".into());
        }
        lacks
    }

    /// What Effigy would use of what is optional, as name, whether it is there, and what that decides.
    pub fn optional(&self) -> Vec<(&'static str, bool, String)> {
        let choose = |has: bool, yes: &str, no: &str| if has { yes.to_string() } else { no.to_string() };
        let timestamps = self.timestamp_bits > 0;
        vec![
            ("16-bit storage", self.half_storage, choose(self.half_storage, "f16 storage buffers", "f16 unpacked from words, same bytes")),
            ("timestamps", timestamps, choose(timestamps, "times of each stage", "times of whole frames only")),
            ("subgroup ballots", self.subgroup_ballot, self.subgroups()),
            ("triangles", self.draws_triangles(), choose(self.draws_triangles(), "hulls, windows, depth surfaces", options::NO_TRIANGLES)),
            ("swapchain", self.has(khr::swapchain::NAME), choose(self.has(khr::swapchain::NAME), "windows", "pictures only")),
            (
                "shader statistics",
                self.shader_statistics,
                choose(self.shader_statistics, "`effigy devices --shader-stats` prints them", "no way to see what became of shaders"),
            ),
            (
                "calibrated clock",
                Calibration::extension(self).is_some(),
                choose(
                    Calibration::extension(self).is_some(),
                    "`--trace` aligns both clocks by it",
                    "`--trace` aligns both clocks by timestamps that it waits for",
                ),
            ),
            (
                "performance query",
                self.has(khr::performance_query::NAME),
                choose(
                    self.has(khr::performance_query::NAME),
                    "profilers may read its counters; nothing here does",
                    "profilers have counters of their own or none",
                ),
            ),
            (
                "memory budget",
                self.has(ext::memory_budget::NAME),
                choose(self.has(ext::memory_budget::NAME), "reported by the driver", "own count only"),
            ),
        ]
    }

    fn subgroups(&self) -> String {
        let use_ = if self.subgroup_ballot { "OneSweep may sort" } else { "sorts without" };
        match self.subgroup_sizes {
            Some([low, high]) => format!("{use_} (subgroups of {}; {low} to {high} on request)", self.subgroup_size),
            None => format!("{use_} (subgroups of {})", self.subgroup_size),
        }
    }

    /// Discrete before integrated before virtual before CPU.
    pub(super) fn rank(&self) -> u32 {
        match self.kind {
            vk::PhysicalDeviceType::DISCRETE_GPU => 0,
            vk::PhysicalDeviceType::INTEGRATED_GPU => 1,
            vk::PhysicalDeviceType::VIRTUAL_GPU => 2,
            vk::PhysicalDeviceType::CPU => 3,
            _ => 4,
        }
    }
}

/// A Vulkan version number as people write it.
pub fn version(version: u32) -> String {
    format!("{}.{}.{}", vk::api_version_major(version), vk::api_version_minor(version), vk::api_version_patch(version))
}
