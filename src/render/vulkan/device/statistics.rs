//! Statistics of a driver's compiler about each pipeline: VK_KHR_pipeline_executable_properties.

use super::{
    error::{During, Result},
    logical::Device,
};
use ash::{khr, vk};
use serde::Serialize;
use std::{
    ffi::CStr,
    fmt,
    sync::{Mutex, MutexGuard, PoisonError},
};

/// The value of a statistic.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum StatisticValue {
    /// True or false, displayed as 1 or 0.
    Bool(bool),
    /// A signed integer.
    Signed(i64),
    /// An unsigned integer.
    Unsigned(u64),
    /// A floating-point number.
    Float(f64),
}

impl fmt::Display for StatisticValue {
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
    /// The driver's name for it.
    pub name: String,
    /// The driver's explanation.
    pub description: String,
    /// The value, in the unit that the description names.
    pub value: StatisticValue,
}

/// One of the programs that a driver makes of a pipeline: at least one for each stage.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Executable {
    /// File in `shaders`; the pipeline's name for a program that the driver adds.
    pub shader: String,
    /// Its specialization constants, 0 upwards.
    pub constants: String,
    /// The driver's name for it.
    pub executable: String,
    /// Lanes of a subgroup; 0 where the driver does not say.
    pub subgroup: u32,
    /// All that the driver reports of it.
    pub statistics: Vec<Statistic>,
}

/// Statistics of the pipelines that a device has made so far.
pub(crate) struct Statistics {
    loader: khr::pipeline_executable_properties::Device,
    found: Mutex<Vec<Executable>>,
}

impl Statistics {
    /// For a device that was opened with the extension.
    pub fn new(device: &Device) -> Self {
        Self {
            loader: khr::pipeline_executable_properties::Device::new(
                &device.instance.raw,
                &device.raw,
            ),
            found: Mutex::default(),
        }
    }

    /// Asks about a pipeline. `shader`: the file of a program that runs at some stages.
    ///
    /// # Safety
    /// The pipeline must be alive, of the device, and made with
    /// `vk::PipelineCreateFlags::CAPTURE_STATISTICS_KHR`.
    pub unsafe fn ask(
        &self,
        pipeline: vk::Pipeline,
        constants: &str,
        shader: impl Fn(vk::ShaderStageFlags) -> String,
    ) -> Result<()> {
        let info = vk::PipelineInfoKHR::default().pipeline(pipeline);
        // SAFETY: the caller promises that the pipeline is alive.
        let executables = unsafe { self.loader.get_pipeline_executable_properties(&info) }
            .during("vkGetPipelineExecutablePropertiesKHR")?;
        for (index, executable) in executables.iter().enumerate() {
            let info = vk::PipelineExecutableInfoKHR::default()
                .pipeline(pipeline)
                .executable_index(index as u32);
            // SAFETY: the caller promises that the pipeline is alive and was made to be asked; it
            // has such an executable.
            let statistics = unsafe { self.loader.get_pipeline_executable_statistics(&info) }
                .during("vkGetPipelineExecutableStatisticsKHR")?;
            self.found().push(Executable {
                shader: shader(executable.stages),
                constants: constants.into(),
                executable: text(executable.name_as_c_str()),
                subgroup: executable.subgroup_size,
                statistics: statistics.iter().map(statistic).collect(),
            });
        }
        Ok(())
    }

    /// Takes what was found since the last call.
    pub fn take(&self) -> Vec<Executable> {
        std::mem::take(&mut *self.found())
    }

    fn found(&self) -> MutexGuard<'_, Vec<Executable>> {
        self.found.lock().unwrap_or_else(PoisonError::into_inner)
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
            Format::BOOL32 => StatisticValue::Bool(raw.value.b32 == vk::TRUE),
            Format::INT64 => StatisticValue::Signed(raw.value.i64),
            Format::FLOAT64 => StatisticValue::Float(raw.value.f64),
            _ => StatisticValue::Unsigned(raw.value.u64),
        }
    };
    Statistic {
        name: text(raw.name_as_c_str()),
        description: text(raw.description_as_c_str()),
        value,
    }
}
