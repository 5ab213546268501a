//! Captures of a person: what many cameras saw, and the pose of a body model in each frame.
//!
//! A capture is a folder in THuman4's layout:
//!
//! | file | content |
//! |---|---|
//! | `calibration.json` | each camera's `K` (9), `R` (9), `T` (3), `distCoeff` (5) and `imgSize` (width, height) |
//! | `images/CAMERA/00000000.png` … | pictures, PNG or JPEG, 8-bit sRGB |
//! | `masks/CAMERA/00000000.png` … | masks: how much of each pixel the person covers, more than 128 of 255 is the person; or classes, or an alpha channel, that of the picture too |
//! | `smpl_params.npz` | the pose of every frame; picture 00000012 has the pose of row 12 |
//! | `template.npz` | the body model, see [`Template`] |
//! | `missing_img_files.txt` | pictures that are known not to be there, a line each; may be absent |
//! | `split.json` | names of held-out `cameras` and numbers of held-out `frames`; may be absent |
//! | `truth.json` | of captures made here with errors: the true values, for evaluation alone |
//!
//! `K` and `R` are in rows. `R` and `T` take the world, in metres, to the camera's axes: x right, y
//! down, z forward. `K` counts pixels from the middle of the upper left one, as OpenCV does.
//!
//! [`Capture::read`] looks at every file without decoding it, decodes 16 masks to see how they are to
//! be read, and leaves out what can't be used; [`Capture::check`] decodes all of it.

mod calibration;
mod capture;
mod check;
mod decode;
mod error;
mod header;
mod layouts;
mod left_out;
mod lens;
pub mod limits;
mod look;
mod mask;
mod open;
mod picture;
mod poses;
mod split;
mod template;
mod truth;
mod units;
mod write;

pub use calibration::CaptureCamera;
pub use capture::{Capture, CaptureFrame};
pub use error::CaptureError;
pub use left_out::{MaskLook, Omission, OmissionReason, tally};
pub use open::CaptureOpenOptions;
pub use picture::Picture;
pub use template::{Template, VertexInfluence};
pub use truth::{Truth, TruthCamera};
pub use write::CaptureWriter;
