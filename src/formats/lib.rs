//! Avatars of other programs. A reader gives what Effigy draws, an
//! [`Avatar`](effigy_core::avatar::Avatar), and says what it had to assume; a writer gives files
//! that those programs read.
//!
//! Readers hold against hostile input: an archive may not unpack to more than [`npz::MAX_GROWTH`]
//! times its size, and every count is checked before memory is taken for it.

pub mod assumption;
pub mod capture;
mod fault;
pub mod npz;
pub mod open;
pub mod splats;
pub mod webavatar;
