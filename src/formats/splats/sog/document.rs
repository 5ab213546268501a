//! `meta.json`.

use effigy_core::io::{file::FormatError, splats::functions_of, text};
use serde::Deserialize;

/// Longest document, bytes: codebooks take 15 KB.
pub const MAX: u64 = 1 << 20;
/// Functions of each degree above 0 by the width of version 1's palette, pixels.
const PALETTE_ROW: usize = 64;

/// The document, of either version.
#[derive(Deserialize)]
pub struct SogDocument {
    #[serde(default)]
    pub version: Option<u32>,
    #[serde(default)]
    count: Option<u64>,
    pub means: CodedImages,
    pub scales: CodedImages,
    pub quats: CodedImages,
    pub sh0: CodedImages,
    #[serde(rename = "shN")]
    pub sh_n: Option<Harmonics>,
}

/// Images of some numbers, and what their codes mean.
#[derive(Deserialize)]
pub struct CodedImages {
    #[serde(default)]
    shape: Vec<u64>,
    #[serde(default)]
    mins: Vec<f32>,
    #[serde(default)]
    maxs: Vec<f32>,
    #[serde(default)]
    pub codebook: Vec<Option<f32>>,
    pub files: Vec<String>,
}

/// The palette of harmonics.
#[derive(Deserialize)]
pub struct Harmonics {
    #[serde(default)]
    pub count: Option<u64>,
    #[serde(default)]
    pub bands: Option<u32>,
    #[serde(default)]
    pub codebook: Vec<Option<f32>>,
    #[serde(default)]
    pub mins: Option<f32>,
    #[serde(default)]
    pub maxs: Option<f32>,
    pub files: Vec<String>,
}

/// The smallest and largest of N numbers.
pub struct Extremes<const N: usize> {
    pub min: [f32; N],
    pub max: [f32; N],
}

impl<const N: usize> Extremes<N> {
    /// A number, from 0 to 1 between the extremes.
    pub fn at(&self, k: usize, part: f32) -> f32 {
        self.min[k] + (self.max[k] - self.min[k]) * part
    }
}

impl SogDocument {
    pub fn parse(bytes: &[u8]) -> Result<Self, FormatError> {
        let document: Self = serde_json::from_slice(&text::utf8(bytes)).map_err(|error| {
            FormatError::container(
                format!("a meta.json that can't be read: {error}"),
                "that of a SOG",
            )
        })?;
        match document.version {
            None | Some(1 | 2) => Ok(document),
            Some(other) => Err(wrong("version", other, "1 or 2")),
        }
    }

    /// Whether colours and scales are codes of codebooks.
    pub fn has_codebooks(&self) -> bool {
        self.version == Some(2)
    }

    /// Number of splats.
    pub fn count(&self) -> Result<u64, FormatError> {
        let count = self.count.or(self.means.shape.first().copied());
        count.ok_or_else(|| wrong("count", "nothing", "the number of splats"))
    }
}

impl CodedImages {
    /// The smallest and largest numbers.
    pub fn extremes<const N: usize>(&self, name: &str) -> Result<Extremes<N>, FormatError> {
        let ends = [&self.mins, &self.maxs].map(|ends| <[f32; N]>::try_from(ends.as_slice()).ok());
        match ends {
            [Some(min), Some(max)] => Ok(Extremes { min, max }),
            _ => Err(wrong(
                name,
                format!("{} mins and {} maxs", self.mins.len(), self.maxs.len()),
                format!("{N} of each"),
            )),
        }
    }

    /// The names of its N images.
    pub fn files<const N: usize>(&self, name: &str) -> Result<[&str; N], FormatError> {
        files(&self.files, name)
    }
}

impl Harmonics {
    /// The names of palette and indices.
    pub fn files(&self) -> Result<[&str; 2], FormatError> {
        files(&self.files, "shN")
    }

    /// The degree, for a palette of a width in pixels.
    pub fn degree(&self, width: usize) -> Result<usize, FormatError> {
        let by_width = (1..=3).find(|&degree| PALETTE_ROW * functions_of(degree) == width);
        let degree = by_width.filter(|&degree| self.bands.is_none_or(|b| b as usize == degree));
        degree.ok_or_else(|| {
            wrong(
                "shN",
                format!("{:?} bands in a palette {width} pixels wide", self.bands),
                "192, 512 or 960 pixels for 1, 2 or 3",
            )
        })
    }

    /// What a code means.
    pub fn numbers(&self) -> Result<[f32; 256], FormatError> {
        if let (true, Some(min), Some(max)) = (self.codebook.is_empty(), self.mins, self.maxs) {
            return Ok(std::array::from_fn(|code| {
                min + (max - min) * code as f32 / 255.0
            }));
        }
        codebook(&self.codebook, "shN")
    }
}

/// A codebook of one number for each byte. The first may be null, as splat-transform wrote it at
/// first: it follows from the others, which are evenly spaced where it stands.
pub fn codebook(numbers: &[Option<f32>], name: &str) -> Result<[f32; 256], FormatError> {
    let mut book = [0.0; 256];
    if numbers.len() != book.len() {
        let found = format!("a codebook of {}", numbers.len());
        return Err(wrong(name, found, "256 numbers"));
    }
    for (code, number) in numbers.iter().enumerate().skip(1) {
        let null = || wrong(name, format!("null at {code} of the codebook"), "a number");
        book[code] = number.ok_or_else(null)?;
    }
    book[0] = numbers[0].unwrap_or(book[1] - (book[255] - book[1]) / 255.0);
    Ok(book)
}

fn files<'a, const N: usize>(names: &'a [String], of: &str) -> Result<[&'a str; N], FormatError> {
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    names
        .as_slice()
        .try_into()
        .map_err(|_| wrong(of, format!("{} files", names.len()), format!("{N}")))
}

/// A field of the document breaks a rule.
pub fn wrong(field: &str, found: impl ToString, expected: impl ToString) -> FormatError {
    FormatError::Metadata {
        field: field.into(),
        found: found.to_string(),
        expected: expected.to_string(),
    }
}
