//! The `features` stage against the reference, element by element.

mod common;

use common::{Sizes, gpu};
use effigy::{
    avatar::Activation,
    frame::Skip,
    vulkan::{GpuOptions, RendererOptions},
};

fn compare(options: GpuOptions) {
    let Some(device) = gpu::open(options) else { return };
    let sizes = [
        Sizes::default(),
        Sizes { split_features: true, activation: Activation::LeakyRelu, subspace: 8, ..Sizes::default() },
        Sizes { hidden: 128, basis: 32, split_features: true, parts: 3, ..Sizes::default() },
        Sizes { hidden: 4, basis: 4, expression: 0, parts: 1, joints: 1, ..Sizes::default() },
    ];
    for (seed, sizes) in (0..).zip(sizes) {
        let frame = gpu::frame(&device, seed, sizes, RendererOptions { skip: Skip::all() - Skip::PARTS, ..gpu::options([64, 64]) });
        let features: Vec<f64> = frame.gpu.features.iter().map(|&e| f64::from(e)).collect();
        let scale = frame.oracle.features.iter().fold(1.0, |max: f64, e| max.max(e.abs()));
        gpu::assert_close(&format!("e, {sizes:?}"), &features, &frame.oracle.features, 1e-5 * scale);
    }
    gpu::assert_valid();
}

#[test]
fn every_parts_network_gives_what_the_reference_gives() {
    compare(GpuOptions::headless(None));
}

#[test]
fn packed_words_give_the_same_as_halves() {
    compare(GpuOptions { packed_words: true, ..GpuOptions::headless(None) });
}
