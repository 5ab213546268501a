//! The passes of a frame as data: what each does, and what it reads and writes on the device.

use super::Skinning;
use bitflags::bitflags;

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

/// Memory on the device that passes of a frame share.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Resource {
    /// Number of keys, number of visible keys, and the indirect draw.
    Control,
    /// The sort's histograms, and why Gaussians were culled.
    Counts,
    /// Features and node displacements of every avatar.
    Pose,
    /// Colours of one avatar, from its spherical harmonics.
    Colors,
    /// Skinned Gaussians that only a camera's change reuses.
    PoseCache,
    /// Projected Gaussians and their depth keys.
    Splats,
    /// Indices of splats in drawing order.
    Order,
    /// Lists of splats by tile.
    TileLists,
    /// Lists of splats by bin.
    Bins,
    /// Samples of the saturation depth.
    Saturation,
    /// The image of avatars that are drawn larger than they are shown.
    Atlas,
    /// The image that the frame makes.
    Image,
}

impl Resource {
    /// Every resource.
    pub const ALL: [Self; 12] = [
        Self::Control,
        Self::Counts,
        Self::Pose,
        Self::Colors,
        Self::PoseCache,
        Self::Splats,
        Self::Order,
        Self::TileLists,
        Self::Bins,
        Self::Saturation,
        Self::Atlas,
        Self::Image,
    ];
}

bitflags! {
    /// Where in a GPU's pipeline a pass uses memory.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub struct PipelineStages: u32 {
        /// Copies and fills.
        const TRANSFER = 1;
        /// Compute shaders.
        const COMPUTE = 2;
        /// Vertex shaders.
        const VERTEX = 4;
        /// Arguments of an indirect draw.
        const INDIRECT = 8;
        /// Blending into the image.
        const COLOR = 16;
        /// Fragment shaders.
        const FRAGMENT = 32;
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

impl ListForm {
    /// Where they are.
    fn resource(self) -> Resource {
        match self {
            Self::Tiles => Resource::TileLists,
            Self::Bins => Resource::Bins,
        }
    }
}

/// An image that a layer of avatars is drawn into.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    /// The image of avatars that are drawn larger than they are shown.
    Atlas,
    /// The image that the frame makes.
    Image,
}

impl Target {
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
        /// Keys of all avatars of a layer, padding included.
        keys: u32,
    },
    /// Clears histograms and counts of culled Gaussians.
    ClearCounts,
    /// Runs an avatar's networks up to part `parts`, and moves the nodes.
    Mlp {
        /// Index of the avatar's pose in [`PlanInput::poses`](super::PlanInput::poses).
        instance: usize,
        /// One past the last part whose network runs.
        parts: u32,
    },
    /// Works out the colours of an avatar's first `gaussians` Gaussians as the camera sees them.
    Sh {
        /// Index of the avatar's pose in [`PlanInput::poses`](super::PlanInput::poses).
        instance: usize,
        /// Which of the avatar's levels is drawn; 0 is the avatar itself.
        model: usize,
        /// How many Gaussians its level of detail draws.
        gaussians: u32,
    },
    /// Projects an avatar's first `gaussians` Gaussians.
    Project {
        /// Index of the avatar's pose in [`PlanInput::poses`](super::PlanInput::poses).
        instance: usize,
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
        target: Target,
    },
    /// Makes the lists of splats of each bin.
    Bin {
        /// The layer's image.
        target: Target,
    },
    /// Finds the depth behind which hardly anything shows, for each four pixels.
    Saturation,
    /// Blends the lists of splats, tile by tile, in a compute kernel.
    RasterTiles {
        /// Which lists it walks.
        lists: ListForm,
        /// The layer's image.
        target: Target,
    },
    /// Blends quads with the device's blender.
    RasterQuads {
        /// Whether fragments are tested against the saturation depth.
        tested: bool,
        /// The layer's image.
        target: Target,
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

    /// Every use that it makes of shared memory.
    pub fn uses(&self) -> Vec<Use> {
        use PipelineStages as Stages;
        use Resource::*;
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
            Self::SetKeyCount { .. } => vec![write(Control, Stages::TRANSFER)],
            // What was culled is counted behind the splats, in the same buffer: validation tells
            // buffers apart, not places in them.
            Self::ClearCounts => vec![
                write(Counts, Stages::TRANSFER),
                write(Splats, Stages::TRANSFER),
            ],
            Self::Mlp { .. } => vec![write(Pose, Stages::COMPUTE)],
            Self::Sh { .. } => vec![read(Pose, Stages::COMPUTE), write(Colors, Stages::COMPUTE)],
            Self::Project { skinning, .. } => {
                let cache = match skinning {
                    Skinning::Compute => None,
                    Skinning::ComputeAndStore => Some(write(PoseCache, Stages::COMPUTE)),
                    Skinning::Cached => Some(read(PoseCache, Stages::COMPUTE)),
                };
                let mut uses = vec![
                    read(Pose, Stages::COMPUTE),
                    read(Colors, Stages::COMPUTE),
                    write(Counts, Stages::COMPUTE),
                    write(Splats, Stages::COMPUTE),
                ];
                uses.extend(cache);
                uses
            }
            Self::Sort => vec![
                read(Splats, Stages::COMPUTE),
                write(Counts, Stages::COMPUTE),
                write(Control, Stages::COMPUTE),
                write(Order, Stages::COMPUTE),
            ],
            Self::ClearTileLists => vec![write(TileLists, Stages::TRANSFER)],
            Self::Binning { .. } => vec![
                read(Control, Stages::COMPUTE),
                read(Order, Stages::COMPUTE),
                read(Splats, Stages::COMPUTE),
                write(TileLists, Stages::COMPUTE),
            ],
            Self::Bin { .. } => vec![
                read(Order, Stages::COMPUTE),
                read(Splats, Stages::COMPUTE),
                write(Control, Stages::COMPUTE),
                write(Bins, Stages::COMPUTE),
            ],
            Self::Saturation => vec![
                write(Bins, Stages::COMPUTE),
                read(Splats, Stages::COMPUTE),
                write(Control, Stages::COMPUTE),
                write(Saturation, Stages::COMPUTE),
            ],
            Self::RasterTiles { lists, target } => vec![
                read(lists.resource(), Stages::COMPUTE),
                read(Splats, Stages::COMPUTE),
                write(Control, Stages::COMPUTE),
                write(target.resource(), Stages::COMPUTE),
            ],
            Self::RasterQuads { tested, target } => {
                let mut uses = vec![
                    read(Control, Stages::INDIRECT | Stages::VERTEX),
                    read(Order, Stages::VERTEX),
                    read(Splats, Stages::VERTEX),
                    write(target.resource(), Stages::COLOR),
                ];
                if tested {
                    uses.push(read(Saturation, Stages::FRAGMENT));
                    uses.push(read(Bins, Stages::VERTEX));
                }
                uses
            }
            Self::Resolve { .. } => {
                vec![read(Atlas, Stages::FRAGMENT), write(Image, Stages::COLOR)]
            }
            Self::KeepCounts | Self::ReadCounts => vec![
                read(Control, Stages::TRANSFER),
                read(Counts, Stages::TRANSFER),
                // How many blocks the lists asked for.
                read(TileLists, Stages::TRANSFER),
            ],
        }
    }
}
