//! Why a training ends early.

use crate::lock::LockError;
use crate::preflight::PreflightError;
use effigy_capture::CaptureError;
use effigy_core::io::file::FileError;
use effigy_core::layout::TRAIN_WIDTH_MAX;
use effigy_perceptual::PerceptualError;
use effigy_render::vulkan::Error as GpuError;

/// Smallest side of a view, px.
pub(crate) const LEAST_SIDE: u32 = 32;
/// Views without a visible Gaussian at the start of a training, at most.
pub(crate) const MAX_EMPTY_VIEWS: u64 = 16;

/// Why a training ended early.
#[derive(Debug, thiserror::Error)]
pub enum TrainError {
    /// The device.
    #[error(transparent)]
    Gpu(#[from] GpuError),
    /// The capture.
    #[error(transparent)]
    Capture(#[from] CaptureError),
    /// A file.
    #[error(transparent)]
    File(#[from] FileError),
    /// The folder is somebody else's.
    #[error(transparent)]
    Lock(#[from] LockError),
    /// The perceptual loss.
    #[error(transparent)]
    Perceptual(#[from] PerceptualError),
    /// The folder has a training.
    #[error("{folder}: found a training after {steps} steps")]
    Begun {
        /// The folder.
        folder: String,
        /// Its steps.
        steps: u64,
    },
    /// No checkpoint of the folder is whole.
    #[error("{file}: {fault}; no other checkpoint is whole")]
    Broken {
        /// The last one.
        file: String,
        /// What is wrong with it.
        fault: String,
    },
    /// The folder's training follows another recipe.
    #[error(
        "{folder}: its training follows another recipe, or takes another time, than what is asked for"
    )]
    OtherRecipe {
        /// The folder.
        folder: String,
    },
    /// The folder's training is of another capture.
    #[error("{folder}: its training has {found}, the capture {expected}")]
    OtherCapture {
        /// The folder.
        folder: String,
        /// What the avatar has.
        found: String,
        /// What the capture's body model has.
        expected: String,
    },
    /// No picture to learn from.
    #[error("found no picture to learn from: all are held out")]
    NothingToLearn,
    /// A view is too small for the perceptual loss, or for anything to be learned.
    #[error(
        "the body takes {} × {} px of the pictures, expected at least {LEAST_SIDE} of each: either \
         they are too small, or its poses, its size or the cameras are not theirs",
        size[0], size[1]
    )]
    SmallViews {
        /// Width and height, px.
        size: [u32; 2],
    },
    /// The body model has more inputs than networks take.
    #[error("the body model gives networks {found} numbers, at most {TRAIN_WIDTH_MAX} fit")]
    Inputs {
        /// What it gives.
        found: usize,
    },
    /// A number that is learned is NaN or infinite.
    #[error(
        "step {step} left {count} numbers that are NaN or infinite: the last checkpoint is before it"
    )]
    Spoiled {
        /// The step.
        step: u64,
        /// How many.
        count: usize,
    },
    /// There was no check before the training.
    #[error(transparent)]
    Preflight(#[from] PreflightError),
    /// The check before the training found that something moves nothing.
    #[error("the check before the training found: {}", faults.join("; "))]
    Idle {
        /// What it found and what it expected.
        faults: Vec<String>,
    },
    /// The training ended before, since the device had no memory for what was left after pruning.
    #[error("the training has ended; it goes on from its last checkpoint")]
    Ended,
    /// What loads pictures ended by itself.
    #[error("the thread that loads pictures ended")]
    LoaderEnded,
    /// No Gaussian is in the views of the first steps.
    #[error(
        "no Gaussian is in view of camera {camera} in frame {frame}, nor in the {MAX_EMPTY_VIEWS} views before"
    )]
    NothingSeen {
        /// The camera's name.
        camera: String,
        /// The frame's number.
        frame: u32,
    },
    /// A loss is NaN or infinite.
    #[error("the loss of step {step} is {loss}: the last checkpoint is before it")]
    NotFinite {
        /// The step.
        step: u64,
        /// What was found.
        loss: f64,
    },
}
