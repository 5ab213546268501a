//! Errors of arrays.

use effigy_core::io::file::FormatError;

/// An array breaks a rule.
pub fn tensor(name: &str, found: impl ToString, expected: impl ToString) -> FormatError {
    FormatError::Tensor {
        tensor: name.into(),
        found: found.to_string(),
        expected: expected.to_string(),
    }
}
