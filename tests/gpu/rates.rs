//! What measures a device's rates does what it says: copies are copies, and layers are blended.

use crate::common::gpu;
use effigy_render::vulkan::{
    raster::ColorFormat::{self, Rgba8, Rgba16F},
    rates::{Copy, CopyMethod, Fill, FillOrder, FillShape, Filling},
};
use half::f16;

/// Not a multiple of 16, so that the small quads do not end on pixels.
const SIZE: [u32; 2] = [72, 40];
const OPACITY: f32 = 0.25;

tests! {
    copies_are_the_same,
    layers_are_blended[Rgba8],
    layers_are_blended[Rgba16F],
    opaque_layers_are_tested_against_the_depth,
    gaussians_fill_their_ellipses,
}

fn copies_are_the_same() {
    let gpu = gpu::gpu();
    // The last is more than a row of workgroups.
    for bytes in [16, 1000, 1 << 16, (1024 << 15) + 160] {
        for method in CopyMethod::ALL {
            let copy = Copy::new(&gpu, bytes).unwrap();
            copy.load().unwrap();
            assert!(
                !copy.is_copied().unwrap(),
                "{bytes} bytes before {method:?}"
            );
            copy.time(method, 2).unwrap();
            assert!(copy.is_copied().unwrap(), "{bytes} bytes by {method:?}");
        }
    }
}

/// The pixels of an image of so many layers: red, green, blue, alpha.
fn fill(filling: Filling, layers: u32) -> Vec<[f64; 4]> {
    let fill = Fill::new(&gpu::drawing(), filling, SIZE, OPACITY).unwrap();
    fill.time(layers).unwrap();
    let bytes = fill.download().unwrap();
    match filling.format {
        Rgba8 => bytes
            .chunks_exact(4)
            .map(|pixel| std::array::from_fn(|i| f64::from(pixel[i]) / 255.0))
            .collect(),
        Rgba16F => bytes
            .chunks_exact(8)
            .map(|pixel| {
                std::array::from_fn(|i| {
                    f64::from(f16::from_le_bytes([pixel[2 * i], pixel[2 * i + 1]]))
                })
            })
            .collect(),
    }
}

/// The colour of a layer, as the shader has it.
fn color(layer: u32) -> [f64; 3] {
    [0, 2, 4].map(|shift| f64::from(layer >> shift & 3) / 4.0)
}

/// Layers put "over" each other, in this order.
fn over(layers: impl Iterator<Item = u32>) -> [f64; 4] {
    let opacity = f64::from(OPACITY);
    layers.fold([0.0; 4], |below, layer| {
        let [r, g, b] = color(layer);
        let above = [r, g, b, 1.0];
        std::array::from_fn(|i| opacity * above[i] + (1.0 - opacity) * below[i])
    })
}

fn layers_are_blended(format: ColorFormat) {
    const LAYERS: u32 = 23;
    for order in [FillOrder::BackToFront, FillOrder::FrontToBack] {
        for shape in [FillShape::Whole, FillShape::Quads] {
            let filling = Filling {
                format,
                blended: true,
                order,
                shape,
            };
            let expected = match order {
                FillOrder::BackToFront => over(0..LAYERS),
                FillOrder::FrontToBack => over((0..LAYERS).rev()),
            };
            // A layer rounds twice at most, and what it rounds fades by a quarter a layer.
            let step = match format {
                Rgba8 => 1.0 / 255.0,
                Rgba16F => 1.0 / 2048.0,
            };
            let found = fill(filling, LAYERS);
            assert_eq!(found.len(), (SIZE[0] * SIZE[1]) as usize);
            for pixel in found {
                for (found, expected) in pixel.iter().zip(expected) {
                    assert!(
                        (found - expected).abs() < 4.5 * step,
                        "{filling:?}: {pixel:?}, expected {expected:?}"
                    );
                }
            }
        }
    }
}

fn opaque_layers_are_tested_against_the_depth() {
    for (order, last) in [(FillOrder::BackToFront, 12), (FillOrder::FrontToBack, 0)] {
        let filling = Filling {
            format: Rgba8,
            blended: false,
            order,
            shape: FillShape::Whole,
        };
        let [r, g, b] = color(last);
        for pixel in fill(filling, 13) {
            let expected = [r, g, b, 1.0];
            let off = (0..4).map(|i| (pixel[i] - expected[i]).abs());
            assert!(
                off.fold(0.0, f64::max) < 0.003,
                "{order:?}: {pixel:?}, expected {expected:?}"
            );
        }
    }
}

fn gaussians_fill_their_ellipses() {
    let filling = Filling {
        format: Rgba16F,
        blended: true,
        order: FillOrder::BackToFront,
        shape: FillShape::Gaussians,
    };
    let pixels = fill(filling, 1);
    let drawn = pixels.iter().filter(|pixel| pixel[3] > 0.0).count() as f64;
    let share = drawn / pixels.len() as f64;
    // A circle in its square.
    assert!((share - 0.785).abs() < 0.05, "{share} is drawn");
    let most = pixels.iter().map(|pixel| pixel[3]).fold(0.0, f64::max);
    assert!((0.2..=0.2501).contains(&most), "{most} at a centre");
}
