//! The largest captures that are read.

/// Cameras of a capture.
pub const CAMERAS: usize = 1024;
/// Frames of a capture.
pub const FRAMES: usize = 1_000_000;
/// Pixels along a picture's side.
pub const SIDE: u32 = 16_384;
/// Pixels of a picture.
pub const PIXELS: u64 = 64 << 20;
/// Vertices of a body model.
pub const VERTICES: usize = 1_000_000;
/// Triangles of a body model.
pub const TRIANGLES: usize = 2_000_000;
/// Bytes of a text or JSON file.
pub const TEXT: u64 = 64 << 20;
/// Bytes of an archive of arrays.
pub const ARCHIVE: u64 = 2 << 30;
/// Bytes of a picture's or a mask's file.
pub const IMAGE: u64 = 256 << 20;
/// Above this, of 255, a mask's pixel is the person.
pub const THRESHOLD: u8 = 128;
