//! The passes of a frame as data: what each does, and what it reads and writes on the device.

use super::{
    AvatarId, Skinning,
    kernels::{self, Access, KernelSpec},
    resource::{PipelineStages, Resource},
};

/// A stage of a frame. Labels of GPU profilers, timestamps, reports and the overlay use its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Stage {
    /// The parts' networks, and the nodes that their features move.
    Mlp,
    /// View-dependent colours from spherical harmonics, for avatars that have them.
    Sh,
    /// Correctives, skinning, projection, culling and the depth key of each Gaussian.
    Project,
    /// The drawing order: far to near, stable.
    Sort,
    /// Lists of splats by tile or bin, for what walks them.
    Binning,
    /// The depth behind which nothing shows, for the quads' depth test.
    Saturation,
    /// Splats blended into an image.
    Raster,
    /// Avatars that were drawn larger than they are shown, averaged and blended into the image.
    Resolve,
    /// The image over the background, into a window.
    Present,
}

impl Stage {
    /// Every stage, in the order that a frame runs them.
    pub const ALL: [Self; 9] = [
        Self::Mlp,
        Self::Sh,
        Self::Project,
        Self::Sort,
        Self::Binning,
        Self::Saturation,
        Self::Raster,
        Self::Resolve,
        Self::Present,
    ];

    /// Whether it runs for each avatar, and not for each image that avatars are drawn into.
    pub const fn is_per_avatar(self) -> bool {
        matches!(self, Self::Mlp | Self::Sh | Self::Project)
    }

    /// Its name in reports, labels and the command line.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Mlp => "mlp",
            Self::Sh => "sh",
            Self::Project => "project",
            Self::Sort => "sort",
            Self::Binning => "binning",
            Self::Saturation => "saturation",
            Self::Raster => "raster",
            Self::Resolve => "resolve",
            Self::Present => "present",
        }
    }
}

/// One use of a resource by a pass.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Use {
    /// The resource.
    pub resource: Resource,
    /// The pipeline stages that use it.
    pub stages: PipelineStages,
    /// Whether the pass writes it; it may read it as well.
    pub writes: bool,
}

/// The form of the lists that a rasterizer walks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ListForm {
    /// Lists of tiles in four levels, which invocations write from runs of the drawing order: for
    /// CPU drivers (`shaders/common/tiles.glsl`).
    Tiles,
    /// Lists of bins, which a sort of pairs of splats and bins makes: for GPUs
    /// (`shaders/common/bins.glsl`).
    Bins,
}

/// An image that a layer of avatars is drawn into.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RenderTarget {
    /// The image of avatars that are drawn larger than they are shown.
    Atlas,
    /// The image that the frame makes.
    Image,
}

impl RenderTarget {
    /// Its memory.
    fn resource(self) -> Resource {
        match self {
            Self::Atlas => Resource::Atlas,
            Self::Image => Resource::Image,
        }
    }
}

/// Work that a backend records as one unit, without barriers of its own between resources.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Pass {
    /// Writes the number of keys that the sort takes to the control.
    SetKeyCount {
        /// Keys of all avatars of a layer.
        keys: u32,
    },
    /// Clears histograms and counts of culled Gaussians.
    ClearCounts,
    /// Runs an avatar's networks up to part `parts`, and moves the nodes.
    Mlp {
        /// Index among [`PlanInput::people`](super::PlanInput::people).
        instance: usize,
        /// Whose networks.
        avatar: AvatarId,
        /// One past the last part whose network runs.
        parts: u32,
    },
    /// Works out the colours of an avatar's first `gaussians` Gaussians as the camera sees them.
    Sh {
        /// Index among [`PlanInput::people`](super::PlanInput::people).
        instance: usize,
        /// Whose Gaussians.
        avatar: AvatarId,
        /// Which of the avatar's levels is drawn; 0 is the avatar itself.
        model: usize,
        /// How many Gaussians its level of detail draws.
        gaussians: u32,
    },
    /// Projects an avatar's first `gaussians` Gaussians.
    Project {
        /// Index among [`PlanInput::people`](super::PlanInput::people).
        instance: usize,
        /// Whose Gaussians.
        avatar: AvatarId,
        /// Which of the avatar's levels is drawn; 0 is the avatar itself.
        model: usize,
        /// How many Gaussians its level of detail draws.
        gaussians: u32,
        /// Where skinned Gaussians come from.
        skinning: Skinning,
    },
    /// Sorts the keys of all avatars of a layer.
    Sort,
    /// Empties the tiles' lists.
    ClearTileLists,
    /// Writes each splat to the lists of the tiles that it meets.
    Binning {
        /// The layer's image.
        target: RenderTarget,
    },
    /// Makes the lists of splats of each bin.
    Bin {
        /// The layer's image.
        target: RenderTarget,
    },
    /// Finds the depth behind which hardly anything shows, for each four pixels.
    Saturation,
    /// Blends the lists of splats, tile by tile, in a compute kernel.
    RasterTiles {
        /// Which lists it walks.
        lists: ListForm,
        /// The layer's image.
        target: RenderTarget,
    },
    /// Blends quads with the device's blender.
    RasterQuads {
        /// Whether fragments are tested against the saturation depth.
        tested: bool,
        /// The layer's image.
        target: RenderTarget,
    },
    /// Averages the atlas's slots, and blends them into the image.
    Resolve {
        /// Whether nothing was drawn into the image before: then it is cleared.
        clear: bool,
    },
    /// Adds the counts of a layer to those of the frame, before another layer's replace them.
    KeepCounts,
    /// Copies the frame's counts to where the host reads them.
    ReadCounts,
}

impl Pass {
    /// The stage that it belongs to. None for what stands between stages.
    pub fn stage(&self) -> Option<Stage> {
        match self {
            Self::SetKeyCount { .. } | Self::ClearCounts | Self::KeepCounts | Self::ReadCounts => {
                None
            }
            Self::Mlp { .. } => Some(Stage::Mlp),
            Self::Sh { .. } => Some(Stage::Sh),
            Self::Project { .. } => Some(Stage::Project),
            Self::Sort => Some(Stage::Sort),
            Self::ClearTileLists | Self::Binning { .. } | Self::Bin { .. } => Some(Stage::Binning),
            Self::Saturation => Some(Stage::Saturation),
            Self::RasterTiles { .. } | Self::RasterQuads { .. } => Some(Stage::Raster),
            Self::Resolve { .. } => Some(Stage::Resolve),
        }
    }

    /// The kernels and shaders that it runs; of several that do the same, all.
    fn kernels(&self) -> Vec<&'static KernelSpec> {
        match *self {
            Self::Mlp { .. } => vec![&kernels::MLP],
            Self::Sh { .. } => vec![&kernels::SH],
            Self::Project { skinning, .. } => vec![match skinning {
                Skinning::Compute => &kernels::PROJECT,
                Skinning::ComputeAndStore => &kernels::PROJECT_STORE,
                Skinning::Cached => &kernels::PROJECT_CACHED,
            }],
            Self::Sort => vec![
                &kernels::SORT_COUNT,
                &kernels::SORT_PER_THREAD_COUNT,
                &kernels::SORT_REDUCE,
                &kernels::SORT_SCAN,
                &kernels::SORT_SCATTER,
                &kernels::SORT_COUNTING_SCATTER,
            ],
            Self::Binning { .. } => vec![&kernels::BINNING],
            // The sort between them has keys, counts and a control of its own, all of them bins.
            Self::Bin { .. } => vec![
                &kernels::BIN_COUNT,
                &kernels::BIN_SCAN,
                &kernels::BIN_PAIRS,
                &kernels::BIN_STARTS,
            ],
            Self::Saturation => vec![&kernels::SATURATION],
            Self::RasterTiles { lists, .. } => vec![match lists {
                ListForm::Tiles => &kernels::RASTER_TILES,
                ListForm::Bins => &kernels::RASTER_BINS,
            }],
            Self::RasterQuads { tested: false, .. } => vec![&kernels::QUADS],
            Self::RasterQuads { tested: true, .. } => {
                vec![&kernels::QUADS_TESTED, &kernels::SATURATION_DEPTH]
            }
            Self::Resolve { .. } => vec![&kernels::RESOLVE],
            Self::SetKeyCount { .. }
            | Self::ClearCounts
            | Self::ClearTileLists
            | Self::KeepCounts
            | Self::ReadCounts => Vec::new(),
        }
    }

    /// Every use that it makes of memory: its kernels', and those of copies, fills and draws.
    pub fn uses(&self) -> Vec<Use> {
        use PipelineStages as Stages;
        use Resource::*;
        let target = match *self {
            Self::RasterTiles { target, .. } | Self::RasterQuads { target, .. } => target,
            _ => RenderTarget::Image,
        };
        let mut uses = Vec::new();
        for kernel in self.kernels() {
            uses.extend(kernel.bindings.iter().map(|binding| Use {
                resource: match binding.resource {
                    Image => target.resource(),
                    other => other,
                },
                stages: kernel.pipeline_stage(),
                writes: binding.access.contains(Access::WRITE),
            }));
        }
        let read = |resource, stages| Use {
            resource,
            stages,
            writes: false,
        };
        let write = |resource, stages| Use {
            resource,
            stages,
            writes: true,
        };
        match *self {
            Self::SetKeyCount { .. } => uses.push(write(Control, Stages::TRANSFER)),
            // What was culled is counted behind the splats, in the same buffer: validation tells
            // buffers apart, not places in them.
            Self::ClearCounts => {
                uses.extend([Counts, Splats].map(|resource| write(resource, Stages::TRANSFER)))
            }
            Self::Bin { .. } => uses.push(write(Pairs, Stages::COMPUTE)),
            Self::ClearTileLists => uses.push(write(TileLists, Stages::TRANSFER)),
            Self::RasterQuads { .. } => uses.extend([
                read(Control, Stages::INDIRECT),
                write(target.resource(), Stages::COLOR),
            ]),
            Self::Resolve { .. } => uses.push(write(Image, Stages::COLOR)),
            // Of the lists, how many blocks they asked for.
            Self::KeepCounts | Self::ReadCounts => {
                uses.extend(
                    [Control, Counts, TileLists].map(|resource| read(resource, Stages::TRANSFER)),
                );
            }
            _ => {}
        }
        uses
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::frame::kernels::KERNELS;

    #[test]
    fn every_kernel_is_of_a_pass() {
        let target = RenderTarget::Image;
        let project = |skinning| Pass::Project {
            instance: 0,
            avatar: AvatarId::FIRST,
            model: 0,
            gaussians: 1,
            skinning,
        };
        let passes = [
            Pass::Mlp {
                instance: 0,
                avatar: AvatarId::FIRST,
                parts: 1,
            },
            Pass::Sh {
                instance: 0,
                avatar: AvatarId::FIRST,
                model: 0,
                gaussians: 1,
            },
            project(Skinning::Compute),
            project(Skinning::ComputeAndStore),
            project(Skinning::Cached),
            Pass::Sort,
            Pass::Binning { target },
            Pass::Bin { target },
            Pass::Saturation,
            Pass::Resolve { clear: true },
        ];
        let lists = [ListForm::Tiles, ListForm::Bins];
        let tiles = lists.map(|lists| Pass::RasterTiles { lists, target });
        let quads = [false, true].map(|tested| Pass::RasterQuads { tested, target });
        let all = passes.iter().chain(&tiles).chain(&quads);
        let run: Vec<_> = all.flat_map(Pass::kernels).collect();
        for kernel in KERNELS {
            assert!(run.contains(&kernel), "{kernel:?} is of no pass");
        }
    }
}
