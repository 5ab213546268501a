//! The demo avatar for unit tests: the package `effigy-demo` depends on this one.

use crate::avatar::Avatar;
use crate::io::file::FormatError;

pub fn avatar() -> Result<Avatar, FormatError> {
    Avatar::from_bytes(include_bytes!("../demo/demo.avatar"))
}
