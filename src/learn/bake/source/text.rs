//! Lines, words and numbers of text files, for the parsers of this folder.

use effigy_core::io::file::FileError;
use std::path::{Path, PathBuf};
use std::str::FromStr;

/// Why a source file can't be used.
#[derive(Debug, thiserror::Error)]
pub enum SourceError {
    /// The file is missing or cannot be read.
    #[error("cannot read {}", file.display())]
    Io {
        /// The file's path.
        file: PathBuf,
        /// The system's error.
        source: std::io::Error,
    },
    /// A line breaks the file's syntax.
    #[error("{}, line {line}: found {found}, expected {expected}", file.display())]
    Syntax {
        /// The file's path.
        file: PathBuf,
        /// Counted from 1.
        line: usize,
        /// The text or number that is there.
        found: String,
        /// The text or number that should be there.
        expected: String,
    },
    /// A motion file can't be read.
    #[error(transparent)]
    Motion(#[from] FileError),
    /// The file as a whole breaks a rule.
    #[error("{}: found {found}, expected {expected}", file.display())]
    Content {
        /// The file's path.
        file: PathBuf,
        /// The text or number that is there.
        found: String,
        /// The text or number that should be there.
        expected: String,
    },
}

/// One line of a text file.
#[derive(Clone, Copy)]
pub struct TextLine<'a> {
    /// Named in errors.
    pub file: &'a Path,
    /// Counted from 1.
    pub number: usize,
    /// Without spaces at its ends.
    pub text: &'a str,
}

impl<'a> TextLine<'a> {
    /// The lines of a text, without empty lines and comments (`#`).
    pub fn all(file: &'a Path, text: &'a str) -> impl Iterator<Item = TextLine<'a>> {
        let lines = text.lines().enumerate().map(move |(i, text)| TextLine {
            file,
            number: i + 1,
            text: text.trim(),
        });
        lines.filter(|line| !line.text.is_empty() && !line.text.starts_with('#'))
    }

    /// The line's words.
    pub fn words(&self) -> std::str::SplitWhitespace<'a> {
        self.text.split_whitespace()
    }

    /// An error at this line.
    pub fn error(&self, found: impl Into<String>, expected: impl Into<String>) -> SourceError {
        SourceError::Syntax {
            file: self.file.to_path_buf(),
            line: self.number,
            found: shorten(found.into()),
            expected: expected.into(),
        }
    }

    /// A word as a number.
    pub fn number<T: FromStr>(&self, word: Option<&str>, expected: &str) -> Result<T, SourceError> {
        let word = word.ok_or_else(|| self.error("the end of the line", expected))?;
        word.parse()
            .map_err(|_| self.error(format!("\"{word}\""), expected))
    }

    /// The next word as a finite number.
    pub fn real(
        &self,
        words: &mut impl Iterator<Item = &'a str>,
        expected: &str,
    ) -> Result<f64, SourceError> {
        let value: f64 = self.number(words.next(), expected)?;
        if value.is_finite() {
            Ok(value)
        } else {
            Err(self.error(format!("{value}"), expected))
        }
    }

    /// The next three words as finite numbers.
    pub fn point(
        &self,
        words: &mut impl Iterator<Item = &'a str>,
    ) -> Result<[f64; 3], SourceError> {
        Ok([
            self.real(words, "three numbers")?,
            self.real(words, "three numbers")?,
            self.real(words, "three numbers")?,
        ])
    }
}

fn shorten(text: String) -> String {
    if text.chars().count() <= 60 {
        text
    } else {
        text.chars().take(57).chain("...".chars()).collect()
    }
}

/// Reads a whole file as text; `.gz` is unpacked.
///
/// # Errors
/// When the file cannot be read, or is not UTF-8.
pub fn read(file: &Path) -> Result<String, SourceError> {
    /// Far above the largest file in use, 6 MB; stops a gzip bomb.
    const LIMIT: u64 = 256 << 20;
    let io = |source| SourceError::Io {
        file: file.to_path_buf(),
        source,
    };
    let opened = std::fs::File::open(file).map_err(io)?;
    let mut source: Box<dyn std::io::Read> = if file.extension().is_some_and(|e| e == "gz") {
        Box::new(flate2::read::MultiGzDecoder::new(opened))
    } else {
        Box::new(opened)
    };
    let mut text = String::new();
    std::io::Read::read_to_string(&mut std::io::Read::take(&mut source, LIMIT), &mut text)
        .map_err(io)?;
    Ok(text)
}
