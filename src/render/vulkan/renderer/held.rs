//! An avatar that a renderer holds: its model, and the kernels that run on it.

use super::prepared::PreparedAvatar;
use crate::vulkan::{
    device::{error::Result, gpu::Gpu},
    memory::Replacement,
    passes::{
        mlp::Mlp, model::Model, project::Project, sh::SphericalHarmonics, splat_buffer::SplatBuffer,
    },
    pipeline::FrameMemory,
};
use effigy_core::frame::{AvatarTraits, RendererOptions, Skip};
use std::sync::Arc;

/// An avatar on a device.
pub(super) struct HeldAvatar {
    /// What plans need to know.
    pub traits: AvatarTraits,
    /// Its arrays.
    pub model: Model,
    /// What runs on them.
    pub kernels: AvatarKernels,
}

/// The kernels that run once a person, bound to an avatar and to the stages that all share.
pub(super) struct AvatarKernels {
    pub mlp: Mlp,
    pub sh: SphericalHarmonics,
    pub project: Project,
}

/// What of an avatar follows from options.
pub(super) fn traits_of(prepared: &PreparedAvatar, options: &RendererOptions) -> AvatarTraits {
    let bounds = prepared.bounds.clone().filtered(options.filter);
    AvatarTraits::new(prepared.avatar, bounds)
}

impl AvatarKernels {
    /// Binds an avatar to the stages that all share, whose buffers `memory` names.
    pub fn new(
        gpu: &Arc<Gpu>,
        traits: &AvatarTraits,
        model: &Model,
        options: &RendererOptions,
        memory: &FrameMemory,
        splats: &SplatBuffer,
    ) -> Result<Self> {
        // Colours that change with the view can't come from a pose cache.
        let caches = options.skip.contains(Skip::SKINNING) && !traits.has_sh;
        Ok(Self {
            mlp: Mlp::new(gpu, model, memory)?,
            sh: SphericalHarmonics::new(gpu, model, memory)?,
            project: Project::new(gpu, model, memory, splats, caches)?,
        })
    }

    /// Binds the one buffer of splats in place of the other.
    ///
    /// # Safety
    /// No submitted work may use the kernels, and the new buffer must outlive what will.
    pub unsafe fn replace(&mut self, replacement: Replacement) {
        // SAFETY: the caller promises what the function asks for.
        unsafe { self.project.replace(replacement) };
    }
}
