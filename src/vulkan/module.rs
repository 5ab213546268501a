//! Shader modules and their constants, on the way to a pipeline.

use super::{
    device::Gpu,
    error::{During, Result},
    shaders::Module,
};
use ash::vk;

/// A shader module that lives while its pipeline is made.
pub(super) struct ShaderModule<'a> {
    gpu: &'a Gpu,
    pub raw: vk::ShaderModule,
}

impl<'a> ShaderModule<'a> {
    pub fn new(gpu: &'a Gpu, module: &'static Module) -> Result<Self> {
        let code: Vec<u32> = bytemuck::pod_collect_to_vec(module.spirv(gpu.half_storage));
        let info = vk::ShaderModuleCreateInfo::default().code(&code);
        // SAFETY: `info` outlives the call; the code is compiled and validated when it is committed.
        let raw = unsafe { gpu.raw.create_shader_module(&info, None) }.during("vkCreateShaderModule")?;
        gpu.name(raw, module.file);
        Ok(Self { gpu, raw })
    }
}

impl Drop for ShaderModule<'_> {
    fn drop(&mut self) {
        // SAFETY: pipelines don't need their modules once they are made.
        unsafe { self.gpu.raw.destroy_shader_module(self.raw, None) };
    }
}

pub(super) fn specialization_entries(constants: &[u32]) -> Vec<vk::SpecializationMapEntry> {
    (0..constants.len() as u32).map(|id| vk::SpecializationMapEntry { constant_id: id, offset: 4 * id, size: 4 }).collect()
}
