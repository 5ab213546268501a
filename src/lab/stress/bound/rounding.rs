//! What a renderer rounds, by its options and its device.

use effigy_core::{
    constants::ALPHA_MIN,
    frame::{ColorFormat, RasterMethod, RendererOptions, Skip},
};
use effigy_render::vulkan::probe::Probe;

/// Relative error of an f32 operation: Vulkan lets a device round up or down.
pub const F32: f64 = f32::EPSILON as f64;
/// Relative error of a number that `packHalf2x16` writes, which may round up or down.
pub const F16: f64 = 1.0 / 1024.0;
/// The smallest positive normal f16: a device may take smaller numbers for 0.
pub const F16_NORMAL: f64 = 1.0 / 16384.0;
/// Steps of a splat's colour and of the pose cache's, 10 bits (`common/splat.glsl`).
pub const COLOR_STEPS: f64 = 1023.0;
/// Steps of a quad's colour (`raster/quads.vert`).
const QUAD_COLOR_STEPS: f64 = 2048.0;
/// Half a step of an 8-bit image. Vulkan lets the conversion be off by a little more than that; the
/// share is Direct3D's, which drivers keep to.
pub const BYTE: f64 = 0.6 / 255.0;
/// Relative error of α by the kernel that steps from pixel to pixel (`raster/cooperative.glsl`): an
/// exponential of down to 2⁻¹²⁰, whose argument and value are off by up to
/// (3 + 2 · 120) ulp each, enters a row's last pixel once; its factor and bend, of 2^±60 and as far
/// off as that, three times.
const STEPPED: f64 = 2.0 * (243.0 + 6.0 * 123.0) * F32;
/// Relative error of α by the kernels that evaluate each pixel: a logarithm (2⁻²¹) and an
/// exponential of up to 2⁻¹⁶ (3 + 2 · 16 ulp), whose argument is off as much.
const EVALUATED: f64 = (8.0 + 70.0) * F32;

/// What a renderer rounds beside the numbers of the avatar and the camera.
#[derive(Clone, Copy, Debug)]
pub struct Rounding {
    /// How splats are rasterized.
    pub method: RasterMethod,
    /// Format of the image.
    pub color: ColorFormat,
    /// Work that is skipped.
    pub skip: Skip,
    /// Opacity under which nothing is drawn.
    pub cutoff: f64,
    /// Half a step of the grid that corners of triangles lie on, px.
    pub snap: f64,
    /// How often the blender rounds a layer of an image in f16: once where it computes in f32 and
    /// converts the sum, as CPU drivers do; Vulkan promises no more than the format's own
    /// precision, which is three roundings.
    pub blend_roundings: f64,
    /// Relative error of numbers between the shaders of quads that are declared `mediump`. CPU
    /// drivers have f32 there.
    pub varying: f64,
    /// Whether positions are exact in f32 from the model to the depth.
    pub exact_positions: bool,
}

impl Rounding {
    /// Of resolved options on a device.
    pub fn new(options: &RendererOptions, probe: &Probe) -> Self {
        let cpu = probe.is_cpu();
        Self {
            snap: 0.5 * (-f64::from(probe.limits.sub_pixel_precision_bits)).exp2(),
            blend_roundings: if cpu { 1.0 } else { 3.0 },
            varying: if cpu { 0.0 } else { F16 },
            ..Self::of_options(options)
        }
    }

    /// Of options on a device that computes in f32 and has a grid of 1/256 px.
    pub fn of_options(options: &RendererOptions) -> Self {
        let method = options.method.unwrap_or(RasterMethod::SharedTiles);
        Self {
            method,
            color: RendererOptions {
                method: Some(method),
                ..*options
            }
            .color(),
            skip: options.skip,
            cutoff: options.cutoff.max(ALPHA_MIN),
            snap: 1.0 / 512.0,
            blend_roundings: 1.0,
            varying: 0.0,
            exact_positions: false,
        }
    }

    /// Whether quads draw.
    pub fn quads(&self) -> bool {
        self.method == RasterMethod::Quads
    }

    /// Error of a splat's colour by its formats.
    pub fn color_step(&self) -> f64 {
        let quads = if self.quads() {
            0.5 / QUAD_COLOR_STEPS
        } else {
            0.0
        };
        0.5 / COLOR_STEPS + quads
    }

    /// Relative error of a splat's opacity: quads have its logarithm in f16.
    pub fn opacity(&self, opacity: f64) -> f64 {
        if !self.quads() {
            return 4.0 * F32;
        }
        let exponent = opacity.log2().abs();
        half_ulp(exponent) * std::f64::consts::LN_2
    }

    /// Relative error of α where it is computed.
    pub fn alpha(&self) -> f64 {
        match self.method {
            RasterMethod::CooperativeTiles => STEPPED,
            _ => EVALUATED,
        }
    }

    /// Error of a value of the image when it is stored in its format.
    pub fn stored(&self, value: f64) -> f64 {
        match self.color {
            ColorFormat::Rgba8 => BYTE,
            ColorFormat::Rgba16F => half_ulp(value),
        }
    }

    /// Transmittance under which tiles stop; 0 if they don't.
    pub fn saturated(&self) -> f64 {
        if self.quads() || !self.skip.contains(Skip::SATURATED) {
            0.0
        } else {
            self.cutoff * (1.0 + 1e-4)
        }
    }
}

/// The step from an f16 to the next above it. `value`: at most f16's largest.
pub fn half_ulp(value: f64) -> f64 {
    if value <= 0.0 {
        return 0.0;
    }
    let bits = |exponent: i32| f64::from_bits(((exponent + 1023) as u64) << 52);
    let exponent = (value.to_bits() >> 52) as i32 - 1023;
    bits(exponent.max(-14) - 10)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_of_halves_are_those_between_neighbours() {
        for bits in (0..0x7bff).step_by(7) {
            let [value, next] = [bits, bits + 1].map(|bits| half::f16::from_bits(bits).to_f64());
            let step = next - value;
            // A zero has no error: it is stored as it is.
            assert_eq!(
                half_ulp(value),
                if bits == 0 { 0.0 } else { step },
                "{value}"
            );
            assert_eq!(half_ulp(0.5 * (value + next)), step, "after {value}");
        }
    }
}
