//! The kernels, and one table of what each binds.

use super::buffers::{PairBuffers, TrainerBuffers};
use super::shaders;
use super::tiling::TileShape;
use crate::parameters::ParameterLayout;
use effigy_render::vulkan::compute::{Kernel, Launch, Module, Resources, Slice};
use effigy_render::vulkan::{Gpu, Result};
use std::sync::Arc;

/// All that kernels are made from.
pub(super) struct KernelSource<'a> {
    pub gpu: &'a Arc<Gpu>,
    pub buffers: &'a TrainerBuffers,
    pub pairs: &'a PairBuffers,
    pub layout: &'a ParameterLayout,
    pub shape: TileShape,
}

/// Makes [`BoundMemory`] from rows of a name, the names of its array in shaders, and its memory.
macro_rules! bindings {
    ($($name:ident [$($array:literal),+] = $memory:expr;)*) => {
        /// What a kernel binds.
        #[derive(Clone, Copy, Debug)]
        enum BoundMemory { $($name),* }

        impl BoundMemory {
            fn slice(self, source: &KernelSource) -> Slice {
                match self { $(Self::$name => slice(source, $memory),)* }
            }

            /// Names of its array in shaders.
            #[cfg(test)]
            fn arrays(self) -> &'static [&'static str] {
                match self { $(Self::$name => &[$($array),+],)* }
            }
        }
    };
}

fn slice<'a, T: Into<Slice>>(
    source: &'a KernelSource<'a>,
    memory: impl FnOnce(&'a KernelSource<'a>) -> T,
) -> Slice {
    memory(source).into()
}

bindings! {
    Joints ["joints"] = |s| &s.buffers.inputs.joints;
    Inputs ["inputs"] = |s| &s.buffers.inputs.inputs;
    Pictures ["pictures"] = |s| &s.buffers.inputs.pictures;
    Behind ["behind"] = |s| &s.buffers.inputs.behind;

    Activations ["activations"] = |s| &s.buffers.batch.activations;
    OfSums ["of_sums"] = |s| &s.buffers.batch.of_sums;
    Displaced ["displaced"] = |s| &s.buffers.batch.displaced;
    OfNodes ["of_nodes"] = |s| &s.buffers.batch.of_nodes;
    OfGaussians ["of_gaussians"] = |s| &s.buffers.batch.of_gaussians;
    OfJoints ["of_joints"] = |s| &s.buffers.batch.of_joints;
    LossSums ["loss_sums"] = |s| &s.buffers.batch.loss_sums;

    Control ["control"] = |s| &s.buffers.view.control;
    DepthOrder ["order"] = |s| s.buffers.view.sort.order();
    Splats ["splats"] = |s| &s.buffers.view.splats;
    SplatPairs ["splat_pairs"] = |s| &s.buffers.view.splat_pairs;
    Image ["image"] = |s| &s.buffers.view.image;
    OfImage ["of_image"] = |s| &s.buffers.view.of_image;
    Status ["status"] = |s| &s.buffers.view.status;
    Canonical ["canonical"] = |s| &s.buffers.view.canonical;
    Keys ["keys"] = |s| &s.buffers.view.keys;
    Asked ["asked"] = |s| &s.buffers.view.asked;
    OfSkinning ["of_skinning"] = |s| &s.buffers.view.of_skinning;

    FixedGaussians ["fixed_words"] = |s| &s.buffers.fixed.gaussians;
    Rows ["rows"] = |s| &s.buffers.fixed.rows;
    NodePart ["node_part"] = |s| &s.buffers.fixed.node_part;
    NodeStarts ["starts"] = |s| &s.buffers.fixed.node_starts;
    NodeFollowers ["followers"] = |s| &s.buffers.fixed.followers;
    Members ["members"] = |s| &s.buffers.fixed.members;
    JointStarts ["starts"] = |s| &s.buffers.fixed.joint_starts;
    JointFollowers ["followers"] = |s| &s.buffers.fixed.moved;

    Gaussians ["learned"] = |s| &s.buffers.parameters.gaussians;
    GaussiansFirst ["first_moments"] = |s| &s.buffers.first_moments.gaussians;
    GaussiansSecond ["second_moments"] = |s| &s.buffers.second_moments.gaussians;
    Bases ["bases"] = |s| &s.buffers.parameters.bases;
    BasesFirst ["first_moments"] = |s| &s.buffers.first_moments.bases;
    BasesSecond ["second_moments"] = |s| &s.buffers.second_moments.bases;
    Nodes ["numbers"] = |s| &s.buffers.parameters.nodes;
    NodesFirst ["first_moments"] = |s| &s.buffers.first_moments.nodes;
    NodesSecond ["second_moments"] = |s| &s.buffers.second_moments.nodes;
    NodeOffsets ["offsets"] = |s| s.buffers.parameters.node_offsets();
    NodeBases ["bases", "node_bases"] = |s| s.buffers.parameters.node_bases();
    Networks ["networks"] = |s| &s.buffers.parameters.networks;
    NetworksFirst ["first_moments"] = |s| &s.buffers.first_moments.networks;
    NetworksSecond ["second_moments"] = |s| &s.buffers.second_moments.networks;

    PairControl ["pair_control"] = |s| &s.pairs.control;
    PairBlocks ["blocks"] = |s| &s.pairs.blocks;
    PairKeys ["pair_keys"] = |s| &s.pairs.keys;
    PairGaussians ["pair_gaussians"] = |s| &s.pairs.gaussians;
    PairOrder ["pair_order"] = |s| s.pairs.sort.order();
    Ranges ["ranges"] = |s| &s.pairs.ranges;
    Records ["records"] = |s| &s.pairs.records;
    OfSplats ["of_splats"] = |s| &s.pairs.of_splats;
}

/// A specialization constant.
#[derive(Clone, Copy, Debug)]
enum Constant {
    /// Where nodes' bases begin.
    NodeBases,
    TileSide,
    TileWorkgroup,
    Batch,
    BatchBackward,
}

impl Constant {
    fn value(self, source: &KernelSource) -> u32 {
        match self {
            Self::NodeBases => source.layout.node_bases as u32,
            Self::TileSide => source.shape.side,
            Self::TileWorkgroup => source.shape.workgroup,
            Self::Batch => source.shape.batches[0],
            Self::BatchBackward => source.shape.batches[1],
        }
    }
}

impl KernelSource<'_> {
    fn kernel(
        &self,
        module: &'static Module,
        bindings: &[BoundMemory],
        constants: &[Constant],
    ) -> Result<Kernel> {
        let slices: Vec<Slice> = bindings.iter().map(|own| own.slice(self)).collect();
        let constants: Vec<u32> = constants.iter().map(|own| own.value(self)).collect();
        let resources = Resources {
            uniform: Some(self.buffers.view.uniform()),
            storage: &slices,
            image: None,
        };
        Kernel::new(self.gpu, module, &constants, resources, Launch::default())
    }
}

/// Makes a struct of kernels from rows of a field, its module, what it binds from binding 1 on, and
/// its specialization constants.
macro_rules! kernels {
    ($(#[$doc:meta])* $kernels:ident {
        $($field:ident = $module:ident [$($binding:ident),*] ($($constant:ident),*);)*
    }) => {
        $(#[$doc])*
        pub(super) struct $kernels { $(pub $field: Kernel),* }

        impl $kernels {
            pub fn new(source: &KernelSource) -> Result<Self> {
                Ok(Self {
                    $($field: source.kernel(
                        &shaders::$module,
                        &[$(BoundMemory::$binding),*],
                        &[$(Constant::$constant),*],
                    )?),*
                })
            }

            #[cfg(test)]
            fn table() -> Vec<(&'static Module, Vec<BoundMemory>)> {
                vec![$((&shaders::$module, vec![$(BoundMemory::$binding),*])),*]
            }
        }
    };
}

kernels! {
    /// The kernels that know no pairs.
    Kernels {
        mlp = MLP [Networks, Inputs, Activations] ();
        nodes = NODES [NodeOffsets, NodeBases, NodePart, Activations, Displaced] ();
        project = PROJECT [Gaussians, FixedGaussians, Bases, Rows, Activations, Joints, Displaced,
            Canonical, Splats, Keys, SplatPairs] ();
        loss = LOSS [Image, Pictures, Behind, Asked, OfImage, LossSums] ();
        joints_backward = JOINTS_BACKWARD [JointStarts, JointFollowers, OfSkinning, OfJoints] ();
        nodes_backward = NODES_BACKWARD [NodeStarts, NodeFollowers, OfGaussians, OfNodes] ();
        features_backward = FEATURES_BACKWARD [OfGaussians, OfNodes, Bases, Rows, NodeBases,
            Members, OfSums] ();
        mlp_backward = MLP_BACKWARD [Networks, Activations, OfSums] ();
        adam_gaussians = ADAM_GAUSSIANS [Status, OfGaussians, Gaussians, GaussiansFirst,
            GaussiansSecond] ();
        adam_bases = ADAM_BASES [Status, OfGaussians, Activations, Rows, Bases, BasesFirst,
            BasesSecond] ();
        adam_nodes = ADAM_NODES [Status, OfNodes, Activations, NodePart, Nodes, NodesFirst,
            NodesSecond] (NodeBases);
        adam_networks = ADAM_NETWORKS [Status, Inputs, Activations, OfSums, Networks,
            NetworksFirst, NetworksSecond] ();
    }
}

kernels! {
    /// The kernels that make or read pairs.
    PairKernels {
        count = TILES_COUNT [Control, DepthOrder, Splats, PairBlocks] (TileSide);
        scan = TILES_SCAN [Control, PairBlocks, PairControl, Status] ();
        emit = TILES_EMIT [Control, DepthOrder, Splats, PairBlocks, PairControl, PairKeys,
            PairGaussians, SplatPairs] (TileSide);
        ranges = TILES_RANGES [PairControl, PairOrder, PairKeys, Ranges] ();
        raster = RASTER [Ranges, PairOrder, PairGaussians, Splats, Image]
            (TileSide, TileWorkgroup, Batch);
        raster_backward = RASTER_BACKWARD [Ranges, PairOrder, PairGaussians, Splats, Image,
            OfImage, Records] (TileSide, TileWorkgroup, BatchBackward);
        project_backward = PROJECT_BACKWARD [FixedGaussians, Joints, Canonical, SplatPairs,
            Records, OfGaussians, OfSkinning, OfSplats] ();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;
    use std::path::Path;

    /// The arrays of a shader's storage buffers, in the order of their bindings, from 1 on.
    fn arrays(file: &str) -> Vec<String> {
        let shaders = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../shaders"));
        let source = fs::read_to_string(shaders.join(file)).unwrap();
        let lines = source
            .lines()
            .filter_map(|line| line.split_once("binding = "));
        lines
            .enumerate()
            .map(|(at, (_, line))| {
                assert!(line.starts_with(&format!("{})", at + 1)), "{file}: {line}");
                let (_, member) = line.split_once("{ ").unwrap();
                let (_, name) = member.split_once(' ').unwrap();
                name.split(['[', ';']).next().unwrap().to_string()
            })
            .collect()
    }

    #[test]
    fn kernels_bind_what_their_shaders_name() {
        let all = [Kernels::table(), PairKernels::table()].concat();
        let own = |module: &&&Module| module.file.starts_with("train/");
        assert_eq!(all.len(), shaders::MODULES.iter().filter(own).count());
        for (module, bindings) in all {
            let arrays = arrays(module.file);
            assert_eq!(arrays.len(), bindings.len(), "{}", module.file);
            for (array, binding) in arrays.iter().zip(bindings) {
                assert!(
                    binding.arrays().contains(&array.as_str()),
                    "{}: {binding:?} in place of {array}",
                    module.file
                );
            }
        }
    }
}
