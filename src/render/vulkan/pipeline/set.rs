//! A descriptor set, alone in its pool.

use crate::vulkan::device::{
    error::{During, Result},
    gpu::Gpu,
    handle::{DescriptorPool, PipelineLayout, SetLayout},
    kept_pipelines::Layouts,
};
use ash::vk;
use std::sync::Arc;

/// A descriptor set, and the layout of pipelines that use it and nothing else.
pub(crate) struct Set {
    pub raw: vk::DescriptorSet,
    /// Pipelines may need them for longer than the set lives.
    pub layouts: Arc<Layouts>,
    /// The set's.
    _pool: DescriptorPool,
}

impl Set {
    /// With one descriptor a binding, of a kind, all seen by the same shader stages. `pushed`:
    /// bytes of push constants, which those stages see too.
    pub fn new(
        gpu: &Gpu,
        name: &str,
        stages: vk::ShaderStageFlags,
        bindings: &[(u32, vk::DescriptorType)],
        pushed: u32,
    ) -> Result<Self> {
        let set_layout = set_layout(gpu, name, stages, bindings)?;
        let layout = pipeline_layout(gpu, name, stages, &set_layout, pushed)?;
        let pool = pool(gpu, name, bindings)?;
        let layouts = [set_layout.raw()];
        let info = vk::DescriptorSetAllocateInfo::default()
            .descriptor_pool(pool.raw())
            .set_layouts(&layouts);
        // SAFETY: pool and layout are alive, and the pool has what one set needs; the set is new.
        let raw = unsafe {
            let sets = gpu.raw.allocate_descriptor_sets(&info);
            let set = sets.during("vkAllocateDescriptorSets")?[0];
            gpu.name(set, name);
            set
        };
        Ok(Self {
            raw,
            layouts: Arc::new(Layouts {
                pipeline: layout,
                _set: set_layout,
            }),
            _pool: pool,
        })
    }
}

fn set_layout(
    gpu: &Gpu,
    name: &str,
    stages: vk::ShaderStageFlags,
    bindings: &[(u32, vk::DescriptorType)],
) -> Result<SetLayout> {
    let bindings: Vec<_> = bindings
        .iter()
        .map(|&(binding, kind)| {
            vk::DescriptorSetLayoutBinding::default()
                .binding(binding)
                .descriptor_type(kind)
                .descriptor_count(1)
                .stage_flags(stages)
        })
        .collect();
    let info = vk::DescriptorSetLayoutCreateInfo::default().bindings(&bindings);
    // SAFETY: `info` and all it points to outlive the call; the layout is new and belongs to its
    // owner.
    unsafe {
        let raw = gpu.raw.create_descriptor_set_layout(&info, None);
        let raw = raw.during("vkCreateDescriptorSetLayout")?;
        Ok(SetLayout::new(&gpu.device, raw, name))
    }
}

fn pipeline_layout(
    gpu: &Gpu,
    name: &str,
    stages: vk::ShaderStageFlags,
    set_layout: &SetLayout,
    pushed: u32,
) -> Result<PipelineLayout> {
    let layouts = [set_layout.raw()];
    let constants = [vk::PushConstantRange {
        stage_flags: stages,
        offset: 0,
        size: pushed,
    }];
    let mut info = vk::PipelineLayoutCreateInfo::default().set_layouts(&layouts);
    if pushed > 0 {
        info = info.push_constant_ranges(&constants);
    }
    // SAFETY: `info` and all it points to outlive the call; the layout is new and belongs to its
    // owner.
    unsafe {
        let raw = gpu.raw.create_pipeline_layout(&info, None);
        let raw = raw.during("vkCreatePipelineLayout")?;
        Ok(PipelineLayout::new(&gpu.device, raw, name))
    }
}

fn pool(gpu: &Gpu, name: &str, bindings: &[(u32, vk::DescriptorType)]) -> Result<DescriptorPool> {
    let sizes: Vec<_> = bindings
        .iter()
        .map(|&(_, kind)| vk::DescriptorPoolSize {
            ty: kind,
            descriptor_count: 1,
        })
        .collect();
    let info = vk::DescriptorPoolCreateInfo::default()
        .max_sets(1)
        .pool_sizes(&sizes);
    // SAFETY: `info` and all it points to outlive the call; the pool is new and belongs to its
    // owner.
    unsafe {
        let raw = gpu.raw.create_descriptor_pool(&info, None);
        let raw = raw.during("vkCreateDescriptorPool")?;
        Ok(DescriptorPool::new(&gpu.device, raw, name))
    }
}
