//! The compiled kernels of the training; docs/development.md says how they are made.

use effigy_render::vulkan::compute::Module;

/// Makes a static of each row, its name and its file, and [`MODULES`] of all.
macro_rules! modules {
    ($($constant:ident = $file:literal;)*) => {
        $(
            #[doc = concat!("`shaders/", $file, "`.")]
            pub static $constant: Module = Module::new(
                $file,
                include_bytes!(concat!("../../../shaders/spv/", $file, ".spv")),
            );
        )*
        /// Every module.
        pub static MODULES: &[&Module] = &[$(&$constant),*];
    };
}

modules! {
    MLP = "train/mlp.comp";
    NODES = "train/nodes.comp";
    PROJECT = "train/project.comp";
    TILES_COUNT = "train/tiles_count.comp";
    TILES_SCAN = "train/tiles_scan.comp";
    TILES_EMIT = "train/tiles_emit.comp";
    TILES_RANGES = "train/tiles_ranges.comp";
    RASTER = "train/raster.comp";
    LOSS = "train/loss.comp";
    RASTER_BACKWARD = "train/raster_backward.comp";
    PROJECT_BACKWARD = "train/project_backward.comp";
    JOINTS_BACKWARD = "train/joints_backward.comp";
    NODES_BACKWARD = "train/nodes_backward.comp";
    FEATURES_BACKWARD = "train/features_backward.comp";
    MLP_BACKWARD = "train/mlp_backward.comp";
    ADAM_GAUSSIANS = "train/adam_gaussians.comp";
    ADAM_BASES = "train/adam_bases.comp";
    ADAM_NODES = "train/adam_nodes.comp";
    ADAM_NETWORKS = "train/adam_networks.comp";
    CROP = "perceptual/crop.comp";
    CONVOLVE = "perceptual/convolve.comp";
    BLUR = "perceptual/blur.comp";
    BLUR_BACKWARD = "perceptual/blur_backward.comp";
    POOL = "perceptual/pool.comp";
    POOL_BACKWARD = "perceptual/pool_backward.comp";
    THIN = "perceptual/thin.comp";
    THIN_BACKWARD = "perceptual/thin_backward.comp";
    DISTANCE = "perceptual/distance.comp";
    DSSIM = "perceptual/dssim.comp";
    DSSIM_BACKWARD = "perceptual/dssim_backward.comp";
    ASKED = "perceptual/asked.comp";
}
