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
    /// The driver's name and build; empty where it does not report them.
    pub driver: String,
    /// Identifies the driver's build: what was learned about one driver is not used for another.
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
    /// Valid bits of that family's timestamps; 0 where it has none.
    pub timestamp_bits: u32,
    /// The driver tells what its compiler makes of shaders.
    pub shader_statistics: bool,
    /// Fragments can be counted.
    pub pipeline_statistics: bool,
    /// Default subgroup size, invocations; 0 without Vulkan 1.1.
    pub subgroup_size: u32,
    /// Whether compute shaders have basic subgroup operations and ballots.
    pub subgroup_ballot: bool,
    /// Whether they have votes, sums and shuffles too.
    pub subgroup_shuffle: bool,
    /// Smallest and largest subgroup that the sort's workgroups may be made of, in full. None: the
    /// driver chooses.
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

    /// What it lacks to draw by a method. None: it can.
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
        let text = |value: std::result::Result<&CStr, _>| {
            value.map_or(String::new(), |s| s.to_string_lossy().into_owned())
        };
        // SAFETY: the device comes from this instance.
        let extensions = unsafe { raw.enumerate_device_extension_properties(physical) }
            .during("vkEnumerateDeviceExtensionProperties")?;
        let extensions: Vec<String> = extensions
            .iter()
            .map(|e| text(e.extension_name_as_c_str()))
            .collect();
        let mut subgroup = vk::PhysicalDeviceSubgroupProperties::default();
        let mut id = vk::PhysicalDeviceIDProperties::default();
        let mut driver = vk::PhysicalDeviceDriverProperties::default();
        let mut sizes = vk::PhysicalDeviceSubgroupSizeControlProperties::default();
        let mut executables = vk::PhysicalDevicePipelineExecutablePropertiesFeaturesKHR::default();
        let mut sizes_chosen = vk::PhysicalDeviceSubgroupSizeControlFeatures::default();
        let has = |name: &CStr| extensions.iter().any(|e| name.to_str() == Ok(e));
        if basic.api_version >= vk::API_VERSION_1_1 {
            let mut properties = vk::PhysicalDeviceProperties2::default()
                .push_next(&mut subgroup)
                .push_next(&mut id);
            if has(khr::driver_properties::NAME) || basic.api_version >= vk::API_VERSION_1_2 {
                properties = properties.push_next(&mut driver);
            }
            let mut features = vk::PhysicalDeviceFeatures2::default();
            if has(ext::subgroup_size_control::NAME) {
                properties = properties.push_next(&mut sizes);
                features = features.push_next(&mut sizes_chosen);
            }
            if has(khr::pipeline_executable_properties::NAME) {
                features = features.push_next(&mut executables);
            }
            // SAFETY: the device comes from this instance, and has Vulkan 1.1; the structures that
            // are chained live to the end of the function.
            unsafe {
                raw.get_physical_device_properties2(physical, &mut properties);
                raw.get_physical_device_features2(physical, &mut features);
            }
        }
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
        let subgroup_all = Subgroup::BASIC
            | Subgroup::BALLOT
            | Subgroup::VOTE
            | Subgroup::ARITHMETIC
            | Subgroup::SHUFFLE;
        let subgroup_basics = vk::SubgroupFeatureFlags::BASIC | vk::SubgroupFeatureFlags::BALLOT;
        let sizes_chosen = sizes_chosen.subgroup_size_control == vk::TRUE
            && sizes_chosen.compute_full_subgroups == vk::TRUE
            && sizes
                .required_subgroup_size_stages
                .contains(vk::ShaderStageFlags::COMPUTE);
        Ok(Self {
            physical,
            name: text(basic.device_name_as_c_str()),
            kind: basic.device_type,
            api_version: basic.api_version,
            driver: format!(
                "{} {}",
                text(driver.driver_name_as_c_str()),
                text(driver.driver_info_as_c_str())
            )
            .trim()
            .to_string(),
            driver_uuid: id.driver_uuid,
            cache_uuid: basic.pipeline_cache_uuid,
            vendor: basic.vendor_id,
            device: basic.device_id,
            limits: basic.limits,
            queue_family: queue_family.map(|family| family as u32),
            timestamp_bits: queue_family.map_or(0, |family| families[family].timestamp_valid_bits),
            pipeline_statistics: core.pipeline_statistics_query == vk::TRUE,
            shader_statistics: executables.pipeline_executable_info == vk::TRUE,
            subgroup_size: subgroup.subgroup_size,
            subgroup_shuffle: subgroup.supported_operations.contains(subgroup_all)
                && subgroup
                    .supported_stages
                    .contains(vk::ShaderStageFlags::COMPUTE),
            subgroup_ballot: subgroup.supported_operations.contains(subgroup_basics)
                && subgroup
                    .supported_stages
                    .contains(vk::ShaderStageFlags::COMPUTE),
            subgroup_sizes: sizes_chosen.then(|| {
                let fewest = SORT_WORKGROUP
                    .div_ceil(sizes.max_compute_workgroup_subgroups.max(1))
                    .next_power_of_two();
                [
                    sizes.min_subgroup_size.max(fewest),
                    sizes.max_subgroup_size.min(SORT_WORKGROUP),
                ]
            }),
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
        self.extensions.iter().any(|e| extension.to_str() == Ok(e))
    }

    /// This device with nothing that Vulkan 1.1 does not promise of every device.
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

    /// Requirements that the device does not meet; empty where it can serve.
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

    /// Whether windows tell of their refreshes. Their times are those of the system's monotonic
    /// clock, which can be read on Android only; no windows elsewhere have it so far.
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

/// A Vulkan version number as people write it.
pub fn version(version: u32) -> String {
    format!(
        "{}.{}.{}",
        vk::api_version_major(version),
        vk::api_version_minor(version),
        vk::api_version_patch(version)
    )
}
