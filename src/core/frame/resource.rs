//! What passes of a frame share: memory on the device, and the stages of a GPU's pipeline that use
//! it.

use bitflags::bitflags;

/// Memory on the device that kernels of a frame bind.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Resource {
    /// Weights of the parts' networks.
    Networks,
    /// Offsets and bases of the position nodes.
    Nodes,
    /// Each part's first node.
    NodeStarts,
    /// Gaussians of one avatar.
    Gaussians,
    /// Basis rows of their correctives.
    Rows,
    /// The first coefficients of their spherical harmonics.
    LowHarmonics,
    /// The others.
    HighHarmonics,
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
    /// Pairs of splats and bins in the order of bins.
    Pairs,
    /// Where each bin's pairs begin, the pairs' keys, and which splats are seen.
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
    pub const ALL: [Self; 20] = [
        Self::Networks,
        Self::Nodes,
        Self::NodeStarts,
        Self::Gaussians,
        Self::Rows,
        Self::LowHarmonics,
        Self::HighHarmonics,
        Self::Control,
        Self::Counts,
        Self::Pose,
        Self::Colors,
        Self::PoseCache,
        Self::Splats,
        Self::Order,
        Self::TileLists,
        Self::Pairs,
        Self::Bins,
        Self::Saturation,
        Self::Atlas,
        Self::Image,
    ];

    /// Whether it is an image, and not a buffer or a part of one.
    pub const fn is_image(self) -> bool {
        matches!(self, Self::Saturation | Self::Atlas | Self::Image)
    }
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
