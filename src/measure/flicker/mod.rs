//! Popping and flicker: images of two frames and the motion between them go in; how much what they
//! show changes on its way from one to the other comes out.
//!
//! The recipe is StopThePop's (Radl et al., SIGGRAPH 2024): the image of one frame is carried to
//! another, one and seven frames later, and compared with the image there, only where both show the
//! same surface. Here nothing has to be estimated: the reference knows how the surface moves
//! ([`effigy_core::reference::carry`]). An image that is right has a residual too, of what really
//! changes, of resampling and of a display's 8 bits; so the reference's own is measured by the same
//! means, and set beside.
//!
//! [`carrying`] finds the pixels of two frames that show the same, [`residual`] is what is left
//! between their images there, [`report`] the numbers of many frames.

pub mod carrying;
pub mod image_part;
pub mod report;
pub mod residual;

pub use carrying::Carrying;
pub use image_part::ImagePart;
pub use report::{FlickerReport, PairReport, Shown, SortingResidual, StepReport};
pub use residual::{Residual, ResidualMap};

/// How many frames apart images are compared: neighbours, which show popping, and frames an eighth
/// of a second apart at 60 a second, which show what comes and goes more slowly.
pub const STEPS: [usize; 2] = [1, 7];
