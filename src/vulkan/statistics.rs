//! What a driver's compiler made of the shaders: VK_KHR_pipeline_executable_properties, on a device opened to be asked and not to run.
//!
//! Every pipeline tells [`Gpu::made`], which asks the driver; so [`all`] has no list of shaders to keep, only one of what can be made.

use super::{
    RendererOptions,
    device::{Gpu, GpuOptions},
    error::{During, Error, Result},
    memory::Buffer,
    present::Present,
    raster::{ColorFormat, Method},
    renderer::Renderer,
    shaders::Module,
    sort::{KeyBits, Sort, SortOptions, Variant},
};
use crate::{
    avatar::{Avatar, Harmonics},
    frame::Skip,
};
use ash::{khr, vk};
use gpu_allocator::MemoryLocation;
use half::f16;
use serde::Serialize;
use std::{
    ffi::CStr,
    fmt,
    sync::{Arc, Mutex},
};

/// A number that a driver gives.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Value {
    Bool(bool),
    Signed(i64),
    Unsigned(u64),
    Float(f64),
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Bool(value) => write!(f, "{}", u8::from(*value)),
            Self::Signed(value) => write!(f, "{value}"),
            Self::Unsigned(value) => write!(f, "{value}"),
            Self::Float(value) => write!(f, "{value}"),
        }
    }
}

/// A statistic, named and explained by the driver.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Statistic {
    pub name: String,
    pub description: String,
    pub value: Value,
}

/// One of the programs that a driver makes of a pipeline: at least one for each stage.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Executable {
    /// File in `shaders`; the pipeline's name for a program that the driver adds.
    pub shader: String,
    /// Its specialization constants, 0 upwards.
    pub constants: String,
    /// As the driver calls it.
    pub executable: String,
    /// Lanes of a subgroup; 0 where the driver does not say.
    pub subgroup: u32,
    pub statistics: Vec<Statistic>,
}

/// What was asked of a device so far.
pub(super) struct Statistics {
    loader: khr::pipeline_executable_properties::Device,
    found: Mutex<Vec<Executable>>,
}

impl Statistics {
    pub fn new(instance: &ash::Instance, device: &ash::Device) -> Self {
        Self { loader: khr::pipeline_executable_properties::Device::new(instance, device), found: Mutex::default() }
    }

    fn ask(&self, pipeline: vk::Pipeline, name: &str, modules: &[&Module], constants: &str) -> Result<()> {
        let info = vk::PipelineInfoKHR::default().pipeline(pipeline);
        // SAFETY: the pipeline is alive and was made to be asked.
        let executables =
            unsafe { self.loader.get_pipeline_executable_properties(&info) }.during("vkGetPipelineExecutablePropertiesKHR")?;
        for (index, executable) in executables.iter().enumerate() {
            let info = vk::PipelineExecutableInfoKHR::default().pipeline(pipeline).executable_index(index as u32);
            // SAFETY: as above, and there is such an executable.
            let statistics =
                unsafe { self.loader.get_pipeline_executable_statistics(&info) }.during("vkGetPipelineExecutableStatisticsKHR")?;
            // Drivers have a fragment program for pipelines without a fragment shader too.
            let module = modules.iter().find(|module| executable.stages.contains(module.stage()));
            let new = Executable {
                shader: module.map_or(name, |module| module.file).into(),
                constants: constants.into(),
                executable: text(executable.name_as_c_str()),
                subgroup: executable.subgroup_size,
                statistics: statistics.iter().map(statistic).collect(),
            };
            self.found.lock().unwrap_or_else(|poisoned| poisoned.into_inner()).push(new);
        }
        Ok(())
    }
}

fn text(name: std::result::Result<&CStr, std::ffi::FromBytesUntilNulError>) -> String {
    name.map_or(String::new(), |name| name.to_string_lossy().into_owned())
}

fn statistic(raw: &vk::PipelineExecutableStatisticKHR) -> Statistic {
    type Format = vk::PipelineExecutableStatisticFormatKHR;
    // SAFETY: the format says which of the union's numbers the driver wrote.
    let value = unsafe {
        match raw.format {
            Format::BOOL32 => Value::Bool(raw.value.b32 == vk::TRUE),
            Format::INT64 => Value::Signed(raw.value.i64),
            Format::FLOAT64 => Value::Float(raw.value.f64),
            _ => Value::Unsigned(raw.value.u64),
        }
    };
    Statistic { name: text(raw.name_as_c_str()), description: text(raw.description_as_c_str()), value }
}

impl Gpu {
    /// Flags that every pipeline is made with.
    pub(super) fn pipeline_flags(&self) -> vk::PipelineCreateFlags {
        match self.statistics {
            Some(_) => vk::PipelineCreateFlags::CAPTURE_STATISTICS_KHR,
            None => vk::PipelineCreateFlags::empty(),
        }
    }

    /// Names a pipeline that was just made of these modules, and asks about it on a device that was opened for that.
    pub(super) fn made(&self, pipeline: vk::Pipeline, name: &str, modules: &[&Module], constants: &str) -> Result<vk::Pipeline> {
        self.name(pipeline, name);
        let asked = self.statistics.as_ref().map_or(Ok(()), |statistics| statistics.ask(pipeline, name, modules, constants));
        asked.map(|()| pipeline).inspect_err(|_| {
            // SAFETY: nobody else knows of the pipeline yet.
            unsafe { self.raw.destroy_pipeline(pipeline, None) }
        })
    }
}

/// What a device's driver makes of every pipeline that a [`Renderer`], a [`Sort`] or a window can ask for. Nothing runs on the device.
///
/// # Errors
/// Where the driver does not tell ([`Error::NoStatistics`]), or can't make a pipeline.
pub fn all(options: &GpuOptions, avatar: &Avatar) -> Result<(Arc<Gpu>, Vec<Executable>)> {
    let gpu = Gpu::new(&GpuOptions { statistics: true, ..options.clone() })?;
    let Some(statistics) = &gpu.statistics else { return Err(Error::NoStatistics { device: gpu.probe.name.clone() }) };
    renderers(&gpu, avatar)?;
    sorts(&gpu)?;
    Present::new(&gpu, vk::Format::B8G8R8A8_UNORM)?;
    let found = std::mem::take(&mut *statistics.found.lock().unwrap_or_else(|poisoned| poisoned.into_inner()));
    Ok((gpu, found))
}

/// A renderer for every choice that leads to pipelines of its own.
fn renderers(gpu: &Arc<Gpu>, avatar: &Avatar) -> Result<()> {
    let any = Variant::ALL.into_iter().find(|variant| variant.lacks(gpu).is_none());
    let options = RendererOptions { sort: any, ..RendererOptions::new([64, 64]) };
    for color in [ColorFormat::Rgba8, ColorFormat::Rgba16F] {
        for skip in [options.skip, Skip::all(), Skip::empty()] {
            Renderer::new(gpu, avatar, RendererOptions { color: Some(color), skip, method: Some(Method::Hulls), ..options })?;
        }
        Renderer::new(gpu, avatar, RendererOptions { color: Some(color), method: Some(Method::Tiles), ..options })?;
    }
    for degree in 1..=3 {
        let functions = (degree + 1) * (degree + 1) - 1;
        let coefficients = vec![[f16::ZERO; 3]; functions * avatar.gaussians.len()];
        let avatar = Avatar { harmonics: Some(Harmonics { degree, coefficients }), ..avatar.clone() };
        Renderer::new(gpu, &avatar, options)?;
    }
    Ok(())
}

/// Every variant at every number of bits, of keys so few that each scatter sums the histograms itself, and so many that kernels do.
fn sorts(gpu: &Arc<Gpu>) -> Result<()> {
    const COUNTS: [u32; 2] = [200_000, 1 << 21];
    let storage = |size| Buffer::new(gpu, "keys", size, vk::BufferUsageFlags::STORAGE_BUFFER, MemoryLocation::GpuOnly);
    let control = storage(size_of::<crate::layout::Control>() as u64)?;
    for count in COUNTS {
        let keys = storage(4 * u64::from(count))?;
        for variant in Variant::ALL.into_iter().filter(|variant| variant.lacks(gpu).is_none()) {
            for bits in [KeyBits::Sixteen, KeyBits::TwentyFour, KeyBits::ThirtyTwo] {
                Sort::new(gpu, (&keys).into(), &control, count, SortOptions::new(bits, variant))?;
            }
        }
    }
    Ok(())
}
