//! An avatar that a renderer holds: its model, and the kernels that run on it.

use super::{
    device::Gpu, error::Result, mlp::Mlp, model::Model, project::Project, sh::SphericalHarmonics,
    shared::SharedStages,
};
use effigy_core::{
    avatar::Avatar,
    frame::{AvatarTraits, RendererOptions, Skip},
    scene::AvatarBounds,
};

/// An avatar on a device.
pub struct HeldAvatar {
    /// What plans need to know.
    pub traits: AvatarTraits,
    /// Its arrays.
    pub model: Model,
    pub mlp: Mlp,
    pub sh: Option<SphericalHarmonics>,
    pub project: Project,
}

/// What of an avatar follows from options.
pub fn traits_of(avatar: &Avatar, options: &RendererOptions) -> AvatarTraits {
    AvatarTraits::new(avatar, AvatarBounds::new(avatar).filtered(options.filter))
}

impl HeldAvatar {
    /// Compiles the kernels of an avatar, bound to the stages that all share. Its harmonics are
    /// uploaded, its model is not.
    pub fn new(
        gpu: &Gpu,
        avatar: &Avatar,
        levels: &[Avatar],
        traits: AvatarTraits,
        model: Model,
        options: &RendererOptions,
        shared: &SharedStages,
    ) -> Result<Self> {
        let SharedStages {
            blocks,
            pose,
            splats,
            ..
        } = shared;
        let caches = caches(&traits, options);
        Ok(Self {
            project: Project::new(gpu, &model, blocks, pose, splats, caches),
            mlp: Mlp::new(gpu, &model, blocks, pose),
            sh: SphericalHarmonics::new(gpu, avatar, levels, &model, blocks, pose)?,
            traits,
            model,
        })
    }

    /// Shows an avatar whose arrays, levels aside, are on the device: makes room for its levels where
    /// they have other lengths than those before, and writes these and its harmonics.
    pub fn show_anew(
        &mut self,
        gpu: &Gpu,
        avatar: &Avatar,
        levels: &[Avatar],
        traits: AvatarTraits,
        shared: &SharedStages,
    ) -> Result<()> {
        let SharedStages {
            blocks,
            pose,
            splats,
            ..
        } = shared;
        if !self.model.fits_levels(levels) {
            self.model.make_room(gpu, levels)?;
            self.project.bind(gpu, &self.model, blocks, pose, splats);
        }
        self.model.fill_levels(gpu, avatar, levels);
        if let Some(sh) = &mut self.sh {
            sh.replace(gpu, avatar, levels, &self.model, blocks, pose)?;
        }
        self.traits = traits;
        Ok(())
    }

    /// Binds it to other stages.
    pub fn rebind(&mut self, gpu: &Gpu, options: &RendererOptions, shared: &SharedStages) {
        let SharedStages {
            blocks,
            pose,
            splats,
            ..
        } = shared;
        let caches = caches(&self.traits, options);
        self.project = Project::new(gpu, &self.model, blocks, pose, splats, caches);
        self.mlp = Mlp::new(gpu, &self.model, blocks, pose);
        if let Some(sh) = &mut self.sh {
            sh.bind(gpu, &self.model, blocks, pose);
        }
    }
}

/// Whether poses are cached: colours that change with the view can't come from a cache.
fn caches(traits: &AvatarTraits, options: &RendererOptions) -> bool {
    options.skip.contains(Skip::SKINNING) && !traits.has_sh
}
