//! What phones would take, without a phone: published rates of their GPUs (`rates.csv`, with a
//! source each), this program's counts of a frame (`effigy bench --json`) and the instructions that
//! Mesa's compilers for them make of the shaders (`tools/shader_stats.sh`). Where sources disagree
//! there is a range.
//!
//! [`PhoneModel::tables`] are the tables of docs/phone-model.md.

mod estimate;
mod inputs;
mod range;
mod tables;

pub use estimate::{Bound, FrameEstimate, Limit, StageEstimate};
pub use inputs::{Counted, Device, InputError, Inputs, Rate};
pub use range::Range;
pub use tables::{BEGIN, END, replace_tables};

/// A frame by each way to draw, on each device.
#[derive(Clone, Debug)]
pub struct PhoneModel {
    /// What it is made from.
    pub inputs: Inputs,
    /// By way to draw, then by device.
    pub frames: Vec<FrameEstimate>,
}

impl PhoneModel {
    /// Makes all estimates.
    ///
    /// # Errors
    /// When the inputs lack something.
    pub fn new(inputs: Inputs) -> Result<Self, InputError> {
        let mut frames = Vec::new();
        for counted in &inputs.counted {
            for device in &inputs.devices {
                frames.push(estimate::frame(&inputs, device, counted)?);
            }
        }
        Ok(Self { inputs, frames })
    }
}
