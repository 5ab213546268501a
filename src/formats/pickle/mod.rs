//! Python's pickles, read without Python: what `pickle.dump`, `joblib.dump`, `numpy.save` and
//! `torch.save` (a zip since 1.6, pickles in a row before) write.
//!
//! A pickle is a program. This machine runs it on values of a few types only: containers, numbers,
//! text, NumPy's arrays and PyTorch's tensors. It calls nothing; a name that is not known is an
//! error that says which. Arrays stay in the file until they are asked for. How many values a
//! pickle may build and how many steps it may take follow from its size.

mod globals;
mod machine;
mod node;
mod torch;
mod value;

pub use torch::pickle_of;
pub use value::{Numbers, Value};

use crate::zip_file::is_zip;
use effigy_core::io::file::FormatError;
use machine::Machine;
use node::Built;
use std::collections::BTreeMap;

/// What a pickle holds.
pub struct Pickle<'a> {
    built: Built<'a>,
}

impl<'a> Pickle<'a> {
    /// Reads a pickle, or a file of PyTorch's.
    ///
    /// # Errors
    /// When the bytes are neither, name anything but the types above, or need more memory than
    /// their size allows.
    pub fn from_bytes(bytes: &'a [u8]) -> Result<Self, FormatError> {
        if is_zip(bytes) {
            return Ok(Self {
                built: torch::from_zip(bytes)?,
            });
        }
        let mut machine = Machine::new(bytes.len(), BTreeMap::new());
        let root = if torch::is_legacy(bytes) {
            machine.legacy(bytes, 0)?
        } else {
            machine.run(bytes, 0, 0)?.root
        };
        let nodes = machine.nodes;
        Ok(Self {
            built: Built { nodes, root },
        })
    }

    /// The value that was saved.
    pub fn root(&self) -> Value<'_> {
        Value::new(&self.built.nodes, self.built.root)
    }
}

/// Whether bytes begin as a pickle of protocol 2 or later does.
pub fn is_pickle(bytes: &[u8]) -> bool {
    matches!(bytes, [0x80, 2..=5, ..])
}
