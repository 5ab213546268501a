//! The avatar and the clip inside the program, used whenever none is named. How they are made: `android/assets/README.md`.

use crate::avatar::{Avatar, Clip, file::Fault};

static AVATAR: &[u8] = include_bytes!("../android/assets/demo.avatar");
static CLIP: &[u8] = include_bytes!("../android/assets/demo.motion");

/// A dressed person of about 60,000 Gaussians.
pub fn avatar() -> Result<Avatar, Fault> {
    Avatar::from_bytes(AVATAR)
}

/// Some seconds of captured motion.
pub fn clip() -> Result<Clip, Fault> {
    Clip::from_bytes(CLIP)
}
