//! What a device manages in a second, whatever is drawn: bytes that it copies, and fragments that it
//! fills an image with. The times of the stages mean something beside these.

mod copy;
mod fill;

pub use copy::{Copy, CopyMethod};
pub use fill::{Fill, FillOrder, FillShape, Filling, MOST_LAYERS};
