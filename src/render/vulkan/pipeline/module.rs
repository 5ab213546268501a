//! From a shader's code to a pipeline.

use super::shaders::Module;
use crate::vulkan::device::{
    error::{During, Result},
    gpu::Gpu,
    handle::{Pipeline, ShaderModule},
};
use ash::vk;
use std::sync::Arc;

/// A shader module, which lives while its pipeline is made.
pub(crate) fn shader_module(gpu: &Arc<Gpu>, module: &Module) -> Result<ShaderModule> {
    let code: Vec<u32> = bytemuck::pod_collect_to_vec(&module.spirv());
    let info = vk::ShaderModuleCreateInfo::default().code(&code);
    // SAFETY: `info` outlives the call; the code is compiled and validated when it is committed.
    // The module is new and belongs to its owner.
    unsafe {
        let raw = gpu.raw.create_shader_module(&info, None);
        let raw = raw.during("vkCreateShaderModule")?;
        Ok(ShaderModule::new(&gpu.device, raw, module.file))
    }
}

/// Where each specialization constant is, 4 bytes each.
pub(crate) fn specialization_entries(constants: &[u32]) -> Vec<vk::SpecializationMapEntry> {
    (0..constants.len() as u32)
        .map(|id| vk::SpecializationMapEntry {
            constant_id: id,
            offset: 4 * id,
            size: 4,
        })
        .collect()
}

/// Specialization constants as people read them.
pub(crate) fn list(constants: &[u32]) -> String {
    let constants: Vec<_> = constants.iter().map(u32::to_string).collect();
    constants.join(" ")
}

/// Flags that every pipeline of a device is made with.
pub(crate) fn flags(gpu: &Gpu) -> vk::PipelineCreateFlags {
    match gpu.statistics {
        Some(_) => vk::PipelineCreateFlags::CAPTURE_STATISTICS_KHR,
        None => vk::PipelineCreateFlags::empty(),
    }
}

/// Takes over a pipeline that was just made of these modules and [`list`]ed constants, and asks
/// about it on a device that was opened for that.
///
/// # Safety
/// The pipeline must be alive, of this device and made with [`flags`], and belong to nobody else.
pub(crate) unsafe fn take_over(
    gpu: &Gpu,
    pipeline: vk::Pipeline,
    name: &str,
    modules: &[&Module],
    constants: &str,
) -> Result<Pipeline> {
    // SAFETY: the caller promises that the pipeline is alive and belongs to nobody else.
    let pipeline = unsafe { Pipeline::new(&gpu.device, pipeline, name) };
    if let Some(statistics) = &gpu.statistics {
        // Drivers have a fragment program for pipelines without a fragment shader too.
        let shader = |stages: vk::ShaderStageFlags| {
            let module = modules
                .iter()
                .find(|module| stages.contains(module.stage()));
            module.map_or(name, |module| module.file).to_string()
        };
        // SAFETY: the pipeline is alive, and the caller promises that it was made to be asked.
        unsafe { statistics.ask(pipeline.raw(), constants, shader) }?;
    }
    Ok(pipeline)
}
