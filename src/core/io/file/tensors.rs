//! The tensors of an opened file.

use super::deflate::ByteArrangement;
use super::error::{FormatError, excerpt};
use safetensors::tensor::Metadata;
use std::{collections::HashMap, ops::Range};

#[cfg(target_endian = "big")]
compile_error!("the files are little-endian, and so must the host be");

/// Maximum length of the header, bytes. The largest avatar's is a tenth of it; parsing takes a
/// multiple of it in memory.
pub const HEADER_MAX: usize = 256 << 10;

/// How much of the header the first bytes of a file hold.
pub enum HeaderProgress {
    /// All of it.
    Complete {
        metadata: Metadata,
        /// Where in the file the tensors start.
        start: usize,
    },
    /// Too little: this many first bytes of the file are needed.
    NeedsBytes(usize),
}

impl HeaderProgress {
    /// Parses the header at the beginning of a file.
    ///
    /// # Errors
    /// When the bytes are not the beginning of a safetensors file.
    pub fn parse(bytes: &[u8]) -> Result<Self, FormatError> {
        let Some(first) = bytes.first_chunk::<8>() else {
            return Ok(Self::NeedsBytes(8));
        };
        let length = usize::try_from(u64::from_le_bytes(*first)).unwrap_or(usize::MAX);
        if length > HEADER_MAX {
            return Err(FormatError::container(
                format!("a header of {length} bytes"),
                format!("at most {HEADER_MAX}; this is no avatar or motion file"),
            ));
        }
        let start = 8 + length;
        let Some(text) = bytes.get(8..start) else {
            return Ok(Self::NeedsBytes(start));
        };
        let metadata = serde_json::from_slice(text).map_err(|error| {
            FormatError::container(excerpt(&error.to_string()), "a safetensors header")
        })?;
        Ok(Self::Complete { metadata, start })
    }
}

/// The header and the tensors of a file.
pub struct Tensors<'a> {
    pub metadata: Metadata,
    /// Bytes of all tensors; of a file that is not complete yet, the first ones.
    pub data: &'a [u8],
    /// Bytes of the tensors that were deflated or are replaced by zeros.
    pub expanded: HashMap<String, Vec<u8>>,
}

impl<'a> Tensors<'a> {
    /// Opens a whole file.
    ///
    /// # Errors
    /// When the header is broken, or the tensors have another length than it says.
    pub fn open(bytes: &'a [u8]) -> Result<Self, FormatError> {
        let tensors = Self::open_beginning(bytes)?;
        let found = tensors.data.len();
        let expected = tensors.metadata.data_len();
        if expected != found {
            let incomplete = if found < expected {
                "; the file is incomplete"
            } else {
                ""
            };
            return Err(FormatError::container(
                format!("{found} bytes of tensors"),
                format!("{expected} as the header says{incomplete}"),
            ));
        }
        Ok(tensors)
    }

    /// Opens the beginning of a file, which must have all of the header.
    ///
    /// # Errors
    /// When the header is broken or not complete.
    pub fn open_beginning(bytes: &'a [u8]) -> Result<Self, FormatError> {
        match HeaderProgress::parse(bytes)? {
            HeaderProgress::Complete { metadata, start } => Ok(Self {
                metadata,
                data: &bytes[start..],
                expanded: HashMap::new(),
            }),
            HeaderProgress::NeedsBytes(needed) => Err(match bytes.len().checked_sub(8) {
                None => {
                    FormatError::container(format!("a file of {} bytes", bytes.len()), "at least 8")
                }
                Some(rest) => FormatError::container(
                    format!("a header cut off after {rest} bytes"),
                    format!("{}; the file is incomplete", needed - 8),
                ),
            }),
        }
    }

    /// Where in `data` the file has a tensor; empty if it has none of this name.
    pub fn place(&self, name: &str) -> Range<usize> {
        match self.metadata.info(name) {
            Some(info) => info.data_offsets.0..info.data_offsets.1,
            None => 0..0,
        }
    }

    /// A tensor's bytes as the file stores them.
    pub fn stored(&self, name: &str) -> &'a [u8] {
        self.data.get(self.place(name)).unwrap_or_default()
    }

    /// A tensor's bytes, expanded if they are deflated.
    pub fn bytes(&self, name: &str) -> &[u8] {
        match self.expanded.get(name) {
            Some(bytes) => bytes,
            None => self.stored(name),
        }
    }

    /// The numbers of a checked tensor; empty if the file has none of this name.
    pub fn values<T: bytemuck::Pod>(&self, name: &str) -> Vec<T> {
        bytemuck::pod_collect_to_vec(self.bytes(name))
    }
}

/// A tensor as listed for users.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct TensorInfo {
    /// Its name in the file.
    pub name: String,
    /// U8, I8, U16, U32, F16 or F32.
    pub dtype: String,
    /// Its shape, row-major.
    pub shape: Vec<usize>,
    /// Bytes of its numbers.
    pub bytes: usize,
    /// Bytes that it takes in the file.
    pub stored: usize,
    /// How its bytes are arranged; None if they are not deflated.
    pub deflated: Option<ByteArrangement>,
    /// Meaning of the numbers.
    pub what: &'static str,
}
