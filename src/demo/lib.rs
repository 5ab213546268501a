//! The avatar and the clip inside the program, used whenever none is named. How they are made:
//! `src/demo/README.md`.

use effigy_core::{
    avatar::{Avatar, Clip},
    io::file::FormatError,
};

static AVATAR: &[u8] = include_bytes!("demo.avatar");
static CLIP: &[u8] = include_bytes!("demo.motion");

/// A dressed person of about 60,000 Gaussians.
pub fn avatar() -> Result<Avatar, FormatError> {
    Avatar::from_bytes(AVATAR)
}

/// Some seconds of captured motion.
pub fn clip() -> Result<Clip, FormatError> {
    Clip::from_bytes(CLIP)
}
