//! The kernels that don't depend on the room for pairs, and what they are bound to.

use super::arrays::{Fixed, Learned};
use super::per_view::PerView;
use super::shaders;
use super::tiles::Tiles;
use crate::parameters::Layout;
use effigy::vulkan::compute::{Buffer, Kernel, Launch, Module, Resources, Slice};
use effigy::vulkan::{Gpu, Result};
use std::sync::Arc;

/// What the host writes for each step.
pub(super) struct Inputs {
    pub joints: Buffer,
    pub inputs: Buffer,
    pub pictures: Buffer,
    pub behind: Buffer,
}

/// What is kept of every view of a step.
pub(super) struct OfViews {
    pub activations: Buffer,
    pub of_sums: Buffer,
    pub displaced: Buffer,
    pub of_nodes: Buffer,
    pub of_gaussians: Buffer,
    pub of_joints: Buffer,
    pub loss_sums: Buffer,
}

/// The kernels that don't depend on the room for pairs.
pub(super) struct Kernels {
    pub mlp: Kernel,
    pub nodes: Kernel,
    pub project: Kernel,
    pub loss: Kernel,
    pub joints_backward: Kernel,
    pub nodes_backward: Kernel,
    pub features_backward: Kernel,
    pub mlp_backward: Kernel,
    pub adam_gaussians: Kernel,
    pub adam_bases: Kernel,
    pub adam_nodes: Kernel,
    pub adam_networks: Kernel,
}

/// Makes kernels.
pub(super) struct Binder<'a> {
    pub gpu: &'a Arc<Gpu>,
    pub per_view: &'a PerView,
}

impl Binder<'_> {
    fn kernel(
        &self,
        module: &'static Module,
        storage: &[Slice],
        constants: &[u32],
    ) -> Result<Kernel> {
        let resources = Resources {
            uniform: Some(self.per_view.uniform()),
            storage,
            image: None,
        };
        Kernel::new(self.gpu, module, constants, resources, Launch::default())
    }

    pub fn project_backward(
        &self,
        inputs: &Inputs,
        of_views: &OfViews,
        fixed: &Fixed,
        tiles: &Tiles,
    ) -> Result<Kernel> {
        self.kernel(
            &shaders::PROJECT_BACKWARD,
            &[
                (&fixed.gaussians).into(),
                (&inputs.joints).into(),
                (&self.per_view.canonical).into(),
                (&self.per_view.splat_pairs).into(),
                (&tiles.records).into(),
                (&of_views.of_gaussians).into(),
                (&self.per_view.of_skinning).into(),
                (&tiles.of_splats).into(),
            ],
            &[],
        )
    }

    pub fn kernels(
        &self,
        inputs: &Inputs,
        of_views: &OfViews,
        fixed: &Fixed,
        [p, m, v]: [&Learned; 3],
        layout: &Layout,
    ) -> Result<Kernels> {
        let own = self.per_view;
        let [node_offsets, node_bases] = p.node_halves();
        Ok(Kernels {
            mlp: self.kernel(
                &shaders::MLP,
                &[
                    (&p.networks).into(),
                    (&inputs.inputs).into(),
                    (&of_views.activations).into(),
                ],
                &[],
            )?,
            nodes: self.kernel(
                &shaders::NODES,
                &[
                    node_offsets,
                    node_bases,
                    (&fixed.node_part).into(),
                    (&of_views.activations).into(),
                    (&of_views.displaced).into(),
                ],
                &[],
            )?,
            project: self.kernel(
                &shaders::PROJECT,
                &[
                    (&p.gaussians).into(),
                    (&fixed.gaussians).into(),
                    (&p.bases).into(),
                    (&fixed.rows).into(),
                    (&of_views.activations).into(),
                    (&inputs.joints).into(),
                    (&of_views.displaced).into(),
                    (&own.canonical).into(),
                    (&own.splats).into(),
                    (&own.keys).into(),
                    (&own.splat_pairs).into(),
                ],
                &[],
            )?,
            loss: self.kernel(
                &shaders::LOSS,
                &[
                    (&own.image).into(),
                    (&inputs.pictures).into(),
                    (&inputs.behind).into(),
                    (&own.asked).into(),
                    (&own.of_image).into(),
                    (&of_views.loss_sums).into(),
                ],
                &[],
            )?,
            joints_backward: self.kernel(
                &shaders::JOINTS_BACKWARD,
                &[
                    (&fixed.joint_starts).into(),
                    (&fixed.moved).into(),
                    (&own.of_skinning).into(),
                    (&of_views.of_joints).into(),
                ],
                &[],
            )?,
            nodes_backward: self.kernel(
                &shaders::NODES_BACKWARD,
                &[
                    (&fixed.node_starts).into(),
                    (&fixed.followers).into(),
                    (&of_views.of_gaussians).into(),
                    (&of_views.of_nodes).into(),
                ],
                &[],
            )?,
            features_backward: self.kernel(
                &shaders::FEATURES_BACKWARD,
                &[
                    (&of_views.of_gaussians).into(),
                    (&of_views.of_nodes).into(),
                    (&p.bases).into(),
                    (&fixed.rows).into(),
                    node_bases,
                    (&fixed.members).into(),
                    (&of_views.of_sums).into(),
                ],
                &[],
            )?,
            mlp_backward: self.kernel(
                &shaders::MLP_BACKWARD,
                &[
                    (&p.networks).into(),
                    (&of_views.activations).into(),
                    (&of_views.of_sums).into(),
                ],
                &[],
            )?,
            adam_gaussians: self.kernel(
                &shaders::ADAM_GAUSSIANS,
                &[
                    (&own.status).into(),
                    (&of_views.of_gaussians).into(),
                    (&p.gaussians).into(),
                    (&m.gaussians).into(),
                    (&v.gaussians).into(),
                ],
                &[],
            )?,
            adam_bases: self.kernel(
                &shaders::ADAM_BASES,
                &[
                    (&own.status).into(),
                    (&of_views.of_gaussians).into(),
                    (&of_views.activations).into(),
                    (&fixed.rows).into(),
                    (&p.bases).into(),
                    (&m.bases).into(),
                    (&v.bases).into(),
                ],
                &[],
            )?,
            adam_nodes: self.kernel(
                &shaders::ADAM_NODES,
                &[
                    (&own.status).into(),
                    (&of_views.of_nodes).into(),
                    (&of_views.activations).into(),
                    (&fixed.node_part).into(),
                    (&p.nodes).into(),
                    (&m.nodes).into(),
                    (&v.nodes).into(),
                ],
                &[layout.node_bases as u32],
            )?,
            adam_networks: self.kernel(
                &shaders::ADAM_NETWORKS,
                &[
                    (&own.status).into(),
                    (&inputs.inputs).into(),
                    (&of_views.activations).into(),
                    (&of_views.of_sums).into(),
                    (&p.networks).into(),
                    (&m.networks).into(),
                    (&v.networks).into(),
                ],
                &[],
            )?,
        })
    }
}
