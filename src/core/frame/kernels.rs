//! The kernels of a frame as data: the modules of each, and what it does with the memory that it
//! binds. [`Pass::uses`](super::passes::Pass::uses), and with it every barrier, follows from this
//! table; a test compares it with what the compiled modules bind and access.

use super::resource::{PipelineStages, Resource};
use bitflags::bitflags;

bitflags! {
    /// How a kernel uses memory.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub struct Access: u8 {
        /// Reads it.
        const READ = 1;
        /// Writes it.
        const WRITE = 2;
    }
}

/// A kernel's use of one resource.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Binding {
    /// Its number with Vulkan. Resources that are parts of one buffer there have one number.
    pub number: u32,
    /// The resource that is bound.
    pub resource: Resource,
    /// How the kernel uses it.
    pub access: Access,
}

/// A kernel, or a shader of a draw.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct KernelSpec {
    /// Paths below `shaders` of its modules, of which a renderer runs one.
    pub modules: &'static [&'static str],
    /// The resources that it binds beside the frame's block, in the order of their numbers.
    pub bindings: &'static [Binding],
}

impl KernelSpec {
    /// The pipeline stage that its modules are for, from their extension.
    pub fn pipeline_stage(&self) -> PipelineStages {
        match self.modules[0].rsplit('.').next() {
            Some("vert") => PipelineStages::VERTEX,
            Some("frag") => PipelineStages::FRAGMENT,
            _ => PipelineStages::COMPUTE,
        }
    }
}

const fn read(number: u32, resource: Resource) -> Binding {
    bound(number, resource, Access::READ)
}

const fn write(number: u32, resource: Resource) -> Binding {
    bound(number, resource, Access::WRITE)
}

const fn update(number: u32, resource: Resource) -> Binding {
    bound(number, resource, Access::all())
}

const fn bound(number: u32, resource: Resource, access: Access) -> Binding {
    Binding {
        number,
        resource,
        access,
    }
}

/// Makes a constant of each row and [`KERNELS`] of all.
macro_rules! kernels {
    ($(
        $(#[$doc:meta])*
        $name:ident = [$($module:literal),*]
            [$($access:ident($number:literal, $resource:ident)),*];
    )*) => {
        $(
            $(#[$doc])*
            pub const $name: KernelSpec = KernelSpec {
                modules: &[$($module),*],
                bindings: &[$($access($number, Resource::$resource)),*],
            };
        )*
        /// Every kernel of a frame. Several are of one module where specialization constants decide
        /// what it does.
        pub const KERNELS: &[KernelSpec] = &[$($name),*];
    };
}

kernels! {
    /// A part's networks and nodes.
    MLP = ["mlp/mlp.comp", "mlp/mlp_bytes.comp"]
        [read(1, Networks), read(2, Nodes), read(3, NodeStarts), write(4, Pose)];
    /// Colours from spherical harmonics.
    SH = ["sh/sh.comp"]
        [read(1, Gaussians), write(1, Colors), read(2, LowHarmonics), read(3, HighHarmonics),
         read(4, Pose)];
    /// Projection of Gaussians that it skins.
    PROJECT = ["project/project.comp"]
        [read(1, Gaussians), read(1, Colors), read(2, Rows), read(3, Pose), write(4, Splats),
         update(4, Counts)];
    /// Projection of Gaussians that it skins, and stores skinned.
    PROJECT_STORE = ["project/project.comp"]
        [read(1, Gaussians), read(1, Colors), read(2, Rows), read(3, Pose), write(4, Splats),
         update(4, Counts), write(4, PoseCache)];
    /// Projection of Gaussians that were stored.
    PROJECT_CACHED = ["project/project_cached.comp"]
        [write(1, Splats), update(1, Counts), read(1, PoseCache)];
    /// Counts the digits of keys, or of what the pass before made of them. These rows are of the
    /// sort of splats; that of pairs is part of making bins.
    SORT_COUNT = ["sort/count.comp"]
        [read(1, Splats), read(1, Order), write(2, Counts), read(3, Control)];
    /// Counts the digits of each invocation's own run.
    SORT_PER_THREAD_COUNT = ["sort/per_thread_count.comp"]
        [read(1, Splats), read(1, Order), update(2, Counts), read(3, Control)];
    /// Sums the counts of groups of tiles.
    SORT_REDUCE = ["sort/reduce.comp"]
        [update(2, Counts), read(3, Control)];
    /// Sums those.
    SORT_SCAN = ["sort/scan.comp"]
        [update(2, Counts), update(3, Control)];
    /// Moves what is sorted by a digit.
    SORT_SCATTER = ["sort/scatter.comp"]
        [read(1, Splats), read(1, Order), read(2, Counts), update(3, Control), write(4, Order)];
    /// Moves what is sorted by a digit, and counts what the next pass needs.
    SORT_COUNTING_SCATTER = ["sort/per_thread_scatter.comp", "sort/onesweep.comp"]
        [read(1, Splats), read(1, Order), update(2, Counts), update(3, Control), write(4, Order)];
    /// Lists of tiles.
    BINNING = ["binning/binning.comp"]
        [read(1, Order), read(2, Splats), update(3, Control), update(4, TileLists)];
    /// Counts the pairs of splats and bins.
    BIN_COUNT = ["binning/count.comp"]
        [read(1, Order), read(2, Splats), read(3, Control), write(4, Bins)];
    /// Chooses the side of bins.
    BIN_SCAN = ["binning/scan.comp"]
        [update(1, Control), update(2, Bins)];
    /// Writes the pairs.
    BIN_PAIRS = ["binning/pairs.comp"]
        [read(1, Order), read(2, Splats), read(3, Control), update(4, Bins)];
    /// Finds each bin's first pair.
    BIN_STARTS = ["binning/starts.comp"]
        [read(1, Pairs), update(2, Bins)];
    /// The depth behind which hardly anything shows.
    SATURATION = ["saturation/saturation.comp"]
        [read(1, Splats), update(2, Control), read(3, Pairs), update(4, Bins),
         write(5, Saturation)];
    /// That depth, into the depth attachment.
    SATURATION_DEPTH = ["saturation/depth.frag"]
        [read(1, Saturation)];
    /// The corners of quads.
    QUADS = ["raster/quads.vert"]
        [read(1, Order), read(2, Splats), read(3, Control)];
    /// The corners of quads of splats that the saturation stage marked.
    QUADS_TESTED = ["raster/quads.vert"]
        [read(1, Order), read(2, Splats), read(3, Control), read(4, Bins)];
    /// Tiles by lists of tiles.
    RASTER_TILES = ["raster/cooperative_rgba8.comp", "raster/cooperative_rgba16f.comp"]
        [read(1, Splats), update(2, Control), read(3, TileLists), write(4, Image)];
    /// Tiles by lists of bins.
    RASTER_BINS = ["raster/shared_rgba8.comp", "raster/shared_rgba16f.comp"]
        [read(1, Splats), update(2, Control), read(3, Pairs), read(4, Bins), write(5, Image)];
    /// The mean of the atlas over a pixel.
    RESOLVE = ["resolve/resolve.frag"]
        [read(0, Atlas)];
}
