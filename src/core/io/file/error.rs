//! Errors of reading and writing files.

use std::fmt::{self, Display, Write};
use std::io;
use std::path::PathBuf;

/// Why a file was not read or written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum FileError {
    /// It can't be opened or read.
    #[error("cannot read {}: {cause}", .file.display())]
    Read {
        /// The file.
        file: PathBuf,
        /// The system's error.
        cause: io::Error,
    },
    /// It can't be written.
    #[error("cannot write {}: {cause}", .file.display())]
    Write {
        /// The file.
        file: PathBuf,
        /// The system's error.
        cause: io::Error,
    },
    /// Its content breaks a rule of the format.
    #[error("{}: {fault}", .file.display())]
    Content {
        /// The file.
        file: PathBuf,
        /// The rule.
        fault: FormatError,
    },
}

/// Which rule of the format a file's content breaks, in one sentence.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum FormatError {
    /// The container: the header or its length.
    #[error("found {}, expected {expected}", cut(.found))]
    Container {
        /// The value found.
        found: String,
        /// The value that the format requires.
        expected: String,
    },
    /// A field of the document in the header.
    #[error("in metadata `{}` found {}, expected {expected}", cut(.field), cut(.found))]
    Metadata {
        /// Name of the field.
        field: String,
        /// The value found.
        found: String,
        /// The value that the format requires.
        expected: String,
    },
    /// The type, shape or numbers of a tensor.
    #[error("in tensor `{}` found {}, expected {expected}", cut(.tensor), cut(.found))]
    Tensor {
        /// Name of the tensor.
        tensor: String,
        /// The value found.
        found: String,
        /// The value that the format requires.
        expected: String,
    },
}

impl FormatError {
    /// A field of the document has a wrong value.
    pub fn metadata(field: &str, found: impl Display, expected: impl ToString) -> Self {
        Self::Metadata {
            field: field.into(),
            found: Beginning::of(found),
            expected: expected.to_string(),
        }
    }

    /// This error, said of a model that is stored under names that begin with `prefix`.
    pub fn within(self, prefix: &str) -> Self {
        match self {
            Self::Container { .. } => self,
            Self::Metadata {
                field,
                found,
                expected,
            } => Self::Metadata {
                field: prefix.to_owned() + &field,
                found,
                expected,
            },
            Self::Tensor {
                tensor,
                found,
                expected,
            } => Self::Tensor {
                tensor: prefix.to_owned() + &tensor,
                found,
                expected,
            },
        }
    }

    /// The container is not as its format says.
    pub fn container(found: impl Display, expected: impl ToString) -> Self {
        Self::Container {
            found: Beginning::of(found),
            expected: expected.to_string(),
        }
    }
}

/// Collects the beginning of what is written to it. What a parser found may be a file's only text.
#[derive(Default)]
struct Beginning(String);

impl Beginning {
    /// More than any message has.
    const BYTES: usize = 2000;

    fn of(found: impl Display) -> String {
        let mut beginning = Self::default();
        // An error says that the rest is left out.
        write!(beginning, "{found}").ok();
        beginning.0
    }
}

impl Write for Beginning {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        let room = Self::BYTES.saturating_sub(self.0.len());
        let end = text.floor_char_boundary(room);
        self.0.push_str(&text[..end]);
        if end < text.len() {
            return Err(fmt::Error);
        }
        Ok(())
    }
}

/// A part of a message, which may have names of a file in it, megabytes long.
fn cut(text: &str) -> String {
    beginning(text, 300)
}

/// The beginning of a text from a file, on one line, for messages.
pub fn excerpt(text: &str) -> String {
    beginning(text, 100)
}

/// At most so many characters, none of which a terminal would obey.
fn beginning(text: &str, characters: usize) -> String {
    let line: String = text
        .chars()
        .take(characters)
        .map(|c| if c.is_control() { ' ' } else { c })
        .collect();
    if line.len() < text.len() {
        line + "…"
    } else {
        line
    }
}
