//! What each stage would take on a device, from what bounds it: instructions, bytes, and blending.
//!
//! A stage takes at least as long as its largest lower bound, if all that it does overlaps, and at
//! most the sum of its upper bounds, if nothing does.

use super::{
    inputs::{Counted, Device, InputError, Inputs},
    range::Range,
};
use effigy_core::frame::passes::Stage;

/// Vertices of a quad, which its two triangles share.
const QUAD_VERTICES: f64 = 4.0;
/// Fewest instructions to evaluate a splat at a pixel or a sample: offset, exponent, exponential,
/// opacity and transmittance (docs/experiments/038).
const FEWEST_A_SAMPLE: f64 = 10.0;
/// Instructions more for the least opacity at a sample's four pixels: two products of two terms,
/// two multiplications with an addition, a maximum and a difference.
const LEAST_OF_FOUR: f64 = 8.0;
/// More instructions than a fragment that a kernel needs to blend four channels by itself.
const BLENDING: f64 = 8.0;
/// Splats that an invocation of the binning kernels takes.
const SPLATS_AN_INVOCATION: f64 = 2.0;

/// What keeps a stage from being faster.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Limit {
    /// The shaders' instructions.
    Instructions,
    /// Bytes to and from memory.
    Bytes,
    /// Fragments that are blended.
    Blending,
}

impl Limit {
    /// In a word.
    pub fn name(self) -> &'static str {
        match self {
            Self::Instructions => "instructions",
            Self::Bytes => "bytes",
            Self::Blending => "blending",
        }
    }
}

/// A time that one thing needs.
#[derive(Clone, Copy, Debug)]
pub struct Bound {
    /// What needs it.
    pub limit: Limit,
    /// ms.
    pub ms: Range,
}

/// A stage on a device.
#[derive(Clone, Debug)]
pub struct StageEstimate {
    /// Name of the stage.
    pub stage: String,
    /// What needs how long. Never empty.
    pub bounds: Vec<Bound>,
    /// Whether its instructions are left out, since how often its loops run was not counted.
    pub floor_only: bool,
}

impl StageEstimate {
    /// ms.
    pub fn ms(&self) -> Range {
        let lows = self.bounds.iter().map(|bound| bound.ms.low);
        Range {
            low: lows.fold(0.0, f64::max),
            high: self.bounds.iter().map(|bound| bound.ms.high).sum(),
        }
    }

    /// The largest lower bound, and the largest upper one where that is another.
    pub fn limits(&self) -> Vec<Limit> {
        let largest = |of: fn(&Bound) -> f64| {
            let bounds = self.bounds.iter();
            bounds
                .max_by(|a, b| of(a).total_cmp(&of(b)))
                .map(|b| b.limit)
        };
        let mut limits: Vec<Limit> = largest(|bound| bound.ms.low).into_iter().collect();
        limits.extend(largest(|bound| bound.ms.high));
        limits.dedup();
        limits
    }
}

/// A frame on a device.
#[derive(Clone, Debug)]
pub struct FrameEstimate {
    /// Name of the way to draw.
    pub method: &'static str,
    /// Name of the device.
    pub device: String,
    /// Its stages, in order.
    pub stages: Vec<StageEstimate>,
}

impl FrameEstimate {
    /// All stages one after the other, ms.
    pub fn ms(&self) -> Range {
        let zero = Range::default();
        self.stages
            .iter()
            .map(StageEstimate::ms)
            .fold(zero, |a, b| a + b)
    }
}

/// What a device does in a millisecond.
struct DeviceRates {
    instructions: Range,
    bytes: Range,
    blended: Range,
    /// Times that a vertex shader runs a vertex.
    vertex_runs: Range,
    /// Bytes that a vertex's outputs move.
    vertex_bytes: Range,
}

impl DeviceRates {
    fn new(inputs: &Inputs, device: &Device) -> Result<Self, InputError> {
        let rate = |name| inputs.rate(device, name);
        Ok(Self {
            instructions: rate("clock")? * rate("instructions")? * 1e6,
            bytes: rate("bandwidth")? * 1e6,
            blended: rate("blending")? * 1e6,
            vertex_runs: rate("vertex runs")?,
            vertex_bytes: inputs.amount(device, "vertex traffic")?,
        })
    }
}

/// The frame of a way to draw on a device.
pub(super) fn frame(
    inputs: &Inputs,
    device: &Device,
    counted: &Counted,
) -> Result<FrameEstimate, InputError> {
    let rates = DeviceRates::new(inputs, device)?;
    let work = Work {
        inputs,
        device,
        counted,
        rates: &rates,
    };
    let mut stages = Vec::new();
    for stage in counted.stages() {
        let bytes = stage.bytes.unwrap_or_default() as f64;
        let mut bounds = Vec::new();
        let mut add = |limit, ms| bounds.push(Bound { limit, ms });
        let bytes = Range::exactly(bytes) + work.vertex_bytes(&stage.name)?;
        add(Limit::Bytes, bytes / rates.bytes);
        let operations = stage.operations.map(|count| count as f64);
        let instructions = work.instructions(&stage.name, operations)?;
        if let Some(instructions) = instructions {
            add(Limit::Instructions, instructions / rates.instructions);
        }
        if stage.name == Stage::Raster.name() && work.draws_quads() {
            let fragments = Range::exactly(counted.counter("fragments")?);
            add(Limit::Blending, fragments / rates.blended);
        }
        stages.push(StageEstimate {
            stage: stage.name.clone(),
            floor_only: instructions.is_none(),
            bounds,
        });
    }
    Ok(FrameEstimate {
        method: counted.name,
        device: device.device.clone(),
        stages,
    })
}

/// The instructions of the stages.
struct Work<'a> {
    inputs: &'a Inputs,
    device: &'a Device,
    counted: &'a Counted,
    rates: &'a DeviceRates,
}

/// Names of programs as the two makers' drivers have them.
const COMPUTE: [&str; 2] = ["CS", "COMPUTE"];
const FRAGMENT: [&str; 2] = ["FS", "FRAGMENT"];
const VERTEX: [&str; 2] = ["VS", "VARYING"];
const POSITION: [&str; 2] = ["Binning VS", "POSITION"];

impl Work<'_> {
    fn draws_quads(&self) -> bool {
        self.counted.report.options.raster == "quads"
    }

    fn kernel(&self, shader: &str) -> Result<f64, InputError> {
        self.inputs.instructions(self.device, shader, &COMPUTE)
    }

    fn fragment(&self) -> Result<f64, InputError> {
        self.inputs
            .instructions(self.device, "raster/quads.frag", &FRAGMENT)
    }

    fn vertices(&self) -> Result<f64, InputError> {
        Ok(QUAD_VERTICES * self.counted.counter("drawn")?)
    }

    /// Bytes of the outputs of a stage's vertices.
    fn vertex_bytes(&self, stage: &str) -> Result<Range, InputError> {
        if stage != Stage::Raster.name() || !self.draws_quads() {
            return Ok(Range::default());
        }
        Ok(self.rates.vertex_bytes * self.vertices()?)
    }

    /// Instructions of all invocations of a stage. None where loops of unknown length have most of
    /// them. `operations`: computed ones, where there are any.
    fn instructions(
        &self,
        stage: &str,
        operations: Option<f64>,
    ) -> Result<Option<Range>, InputError> {
        let drawn = self.counted.counter("drawn")?;
        let found = match stage {
            // A multiplication and an addition are one instruction, or two.
            "mlp" => operations.map(|count| Range {
                low: count / 2.0,
                high: count,
            }),
            // Those that are culled leave early.
            "project" => {
                let each = self.kernel("project/project.comp")?;
                Some(Range {
                    low: each * drawn,
                    high: each * self.counted.counter("gaussians")?,
                })
            }
            "binning" => {
                let each =
                    self.kernel("binning/count.comp")? + self.kernel("binning/pairs.comp")?;
                Some(Range {
                    low: each * drawn / SPLATS_AN_INVOCATION,
                    high: each * drawn,
                })
            }
            "saturation" => {
                let samples = self.counted.counter("samples")?;
                Some(Range {
                    low: (FEWEST_A_SAMPLE + LEAST_OF_FOUR) * samples,
                    high: (self.fragment()? + LEAST_OF_FOUR) * samples,
                })
            }
            "raster" if self.draws_quads() => Some(self.quads()?),
            "raster" => {
                let pixels = self.counted.counter("fragments")?;
                Some(Range {
                    low: (FEWEST_A_SAMPLE + BLENDING / 2.0) * pixels,
                    high: (self.fragment()? + BLENDING) * pixels,
                })
            }
            _ => None,
        };
        Ok(found)
    }

    /// Vertices for their positions and again for their outputs, and fragments.
    fn quads(&self) -> Result<Range, InputError> {
        let vertex = "raster/quads.vert";
        let count = |programs| self.inputs.instructions(self.device, vertex, programs);
        let (position, output) = (count(&POSITION)?, count(&VERTEX)?);
        // The first run is for the position; where there is but one, its outputs follow in it.
        let again = self.rates.vertex_runs;
        let outputs = Range {
            low: (again.low - 1.0).max(1.0),
            high: (again.high - 1.0).max(1.0),
        };
        let each = Range::exactly(position) + outputs * output;
        let fragments = self.fragment()? * self.counted.counter("fragments")?;
        Ok(each * self.vertices()? + Range::exactly(fragments))
    }
}
