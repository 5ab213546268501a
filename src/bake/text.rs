//! Text files in, numbers or an error that names the place out. Shared by the small parsers of this folder.

use std::path::{Path, PathBuf};
use std::str::FromStr;

/// Why a source file can't be used.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    #[error("cannot read {} (tools/fetch_assets.sh gets the source files; --assets names their folder)", file.display())]
    Io { file: PathBuf, source: std::io::Error },
    #[error("{}, line {line}: found {found}, expected {expected}", file.display())]
    Syntax { file: PathBuf, line: usize, found: String, expected: String },
    #[error("{}: found {found}, expected {expected}", file.display())]
    Content { file: PathBuf, found: String, expected: String },
}

/// One line of a text file, by words.
#[derive(Clone, Copy)]
pub struct Line<'a> {
    pub file: &'a Path,
    /// Counted from 1.
    pub number: usize,
    pub text: &'a str,
}

impl<'a> Line<'a> {
    /// The lines that hold anything, without comments (`#`).
    pub fn all(file: &'a Path, text: &'a str) -> impl Iterator<Item = Line<'a>> {
        let lines = text.lines().enumerate().map(move |(i, text)| Line { file, number: i + 1, text: text.trim() });
        lines.filter(|line| !line.text.is_empty() && !line.text.starts_with('#'))
    }

    pub fn words(&self) -> std::str::SplitWhitespace<'a> {
        self.text.split_whitespace()
    }

    /// An error at this line.
    pub fn error(&self, found: impl Into<String>, expected: impl Into<String>) -> Error {
        Error::Syntax { file: self.file.to_path_buf(), line: self.number, found: shorten(found.into()), expected: expected.into() }
    }

    /// A word as a number.
    pub fn number<T: FromStr>(&self, word: Option<&str>, expected: &str) -> Result<T, Error> {
        let word = word.ok_or_else(|| self.error("the end of the line", expected))?;
        word.parse().map_err(|_| self.error(format!("\"{word}\""), expected))
    }

    /// The next word as a finite number.
    pub fn real(&self, words: &mut impl Iterator<Item = &'a str>, expected: &str) -> Result<f64, Error> {
        let value: f64 = self.number(words.next(), expected)?;
        if value.is_finite() { Ok(value) } else { Err(self.error(format!("{value}"), expected)) }
    }

    /// The next three words as finite numbers.
    pub fn point(&self, words: &mut impl Iterator<Item = &'a str>) -> Result<[f64; 3], Error> {
        Ok([self.real(words, "three numbers")?, self.real(words, "three numbers")?, self.real(words, "three numbers")?])
    }
}

fn shorten(text: String) -> String {
    if text.chars().count() <= 60 { text } else { text.chars().take(57).chain("...".chars()).collect() }
}

/// A whole file as text; `.gz` is unpacked.
pub fn read(file: &Path) -> Result<String, Error> {
    /// Far above the largest file in use, 6 MB; stops a gzip bomb.
    const LIMIT: u64 = 256 << 20;
    let io = |source| Error::Io { file: file.to_path_buf(), source };
    let opened = std::fs::File::open(file).map_err(io)?;
    let mut source: Box<dyn std::io::Read> =
        if file.extension().is_some_and(|e| e == "gz") { Box::new(flate2::read::MultiGzDecoder::new(opened)) } else { Box::new(opened) };
    let mut text = String::new();
    std::io::Read::read_to_string(&mut std::io::Read::take(&mut source, LIMIT), &mut text).map_err(io)?;
    Ok(text)
}
