//! Splats of the images.

use super::{
    META,
    document::{self, Extremes, Harmonics, SogDocument, codebook, wrong},
    texture::{Texture, most_bytes},
    zipped::Zipped,
};
use crate::splats::{
    beside::{Beside, missing},
    logit, plausible,
};
use effigy_core::{
    avatar::{Filter, limits},
    io::{
        file::FormatError,
        splats::{Splats, Up, functions_of},
    },
};
use std::f32::consts::FRAC_1_SQRT_2;

/// Palette entries, at most: indices have 16 bits.
const PALETTE: u64 = 1 << 16;
/// Palette entries of a row of pixels.
const PALETTE_ROW: usize = 64;
/// Pixels that an image may have beyond twice those of its splats.
const SPARE_PIXELS: u64 = 64 << 10;
/// The code of a rotation's A, less the index of its largest part.
const ROTATION_MARK: u8 = 252;

/// Reads a `.sog` that has no levels of detail.
///
/// # Errors
/// When the bytes are no zip or hold no SOG.
pub fn in_plain_archive(bytes: &[u8]) -> Result<Splats, FormatError> {
    let zip = Zipped::new(bytes)?;
    let folder = zip.folder_of(META).unwrap_or_default();
    let mut files = zip.files(&folder);
    let meta = files.file(META, document::MAX)?;
    read(&meta, &mut files)
}

/// Reads a `meta.json`, whose images `files` has.
///
/// # Errors
/// When the document or an image breaks a rule.
pub fn in_folder(meta: &[u8], files: &mut dyn Beside) -> Result<Splats, FormatError> {
    if meta.len() as u64 > document::MAX {
        return Err(missing(META, &format!("more than {} bytes", document::MAX)));
    }
    read(meta, files)
}

/// The images' files, unpacked one by one later.
struct PackedImages<'a> {
    name: &'a str,
    bytes: Vec<u8>,
}

fn read(meta: &[u8], files: &mut dyn Beside) -> Result<Splats, FormatError> {
    let document = SogDocument::parse(meta)?;
    let count = document.count()?;
    if count > limits::GAUSSIANS as u64 {
        return Err(wrong("count", count, limits::GAUSSIANS));
    }
    let most = 2 * count + SPARE_PIXELS;
    let mut total = 0;
    let mut load = |name, pixels| {
        let bytes = files.file(name, most_bytes(pixels))?;
        total += bytes.len() as u64;
        Ok::<_, FormatError>(PackedImages { name, bytes })
    };
    let [low, high] = document.means.files("means")?;
    let means = [load(low, most)?, load(high, most)?];
    let [quats] = document.quats.files("quats")?;
    let quats = load(quats, most)?;
    let [scales] = document.scales.files("scales")?;
    let scales = load(scales, most)?;
    let [sh0] = document.sh0.files("sh0")?;
    let sh0 = load(sh0, most)?;
    let palette_pixels = PALETTE * functions_of(3) as u64;
    let rest = match &document.sh_n {
        None => None,
        Some(harmonics) => {
            let [palette, labels] = harmonics.files()?;
            Some((load(palette, palette_pixels)?, load(labels, most)?))
        }
    };
    plausible::check(count, total)?;
    let decode = |packed: &PackedImages| Texture::decode(&packed.bytes, packed.name, count, most);
    let n = count as usize;
    let position = {
        let [low, high] = [decode(&means[0])?, decode(&means[1])?];
        let range = document.means.extremes::<3>("means")?;
        let pixels = low.pixels.iter().zip(&high.pixels).take(n);
        pixels
            .map(|(low, high)| position(low, high, &range))
            .collect()
    };
    let quats = decode(&quats)?;
    let rotation = quats.pixels[..n].iter().map(rotation).collect();
    let log_scale = CodeMeaning::of_scales(&document)?;
    let log_scale = decode(&scales)?.pixels[..n]
        .iter()
        .map(|&[r, g, b, _]| log_scale.three([r, g, b]))
        .collect();
    let colors = CodeMeaning::of_colors(&document)?;
    let sh0 = decode(&sh0)?;
    let mut splats = Splats {
        position,
        rotation,
        log_scale,
        opacity: sh0.pixels[..n]
            .iter()
            .map(|p| colors.opacity(p[3]))
            .collect(),
        color: sh0.pixels[..n]
            .iter()
            .map(|&[r, g, b, _]| colors.three([r, g, b]))
            .collect(),
        degree: 0,
        harmonics: vec![],
        up: Up::TRAINED,
        filter: Filter::DEFAULT,
    };
    if let (Some(harmonics), Some((palette, labels))) = (&document.sh_n, &rest) {
        let palette = Texture::decode(&palette.bytes, palette.name, 1, palette_pixels)?;
        read_harmonics(
            &mut splats,
            harmonics,
            &palette,
            &decode(labels)?.pixels[..n],
        )?;
    }
    Ok(splats)
}

fn position(low: &[u8; 4], high: &[u8; 4], range: &Extremes<3>) -> [f32; 3] {
    std::array::from_fn(|k| {
        let code = u16::from_le_bytes([low[k], high[k]]);
        let logarithm = range.at(k, f32::from(code) / 65535.0);
        // In f64: of the C libraries' functions on f32 some are a step off.
        let size = f64::from(logarithm.abs()).exp_m1();
        logarithm.signum() * size as f32
    })
}

/// A quaternion; of length 0 where its mark is none, so that the splat is left out.
fn rotation(pixel: &[u8; 4]) -> [f32; 4] {
    let [parts @ .., mark] = *pixel;
    let Some(largest) = mark.checked_sub(ROTATION_MARK) else {
        return [0.0; 4];
    };
    let mut small = parts
        .map(|byte| (f32::from(byte) / 127.5 - 1.0) * FRAC_1_SQRT_2)
        .into_iter();
    let rest = 1.0 - small.clone().map(|v| v * v).sum::<f32>();
    std::array::from_fn(|k| {
        if k == usize::from(largest) {
            rest.max(0.0).sqrt()
        } else {
            small.next().unwrap_or_default()
        }
    })
}

/// What the codes of scales or colours mean.
enum CodeMeaning {
    /// Each byte's number; A is the opacity of 255.
    Codebook(Box<[f32; 256]>),
    /// From 0 to 255 between extremes; those of A are of the opacity's logit.
    Extremes(Extremes<4>),
}

impl CodeMeaning {
    fn of_scales(document: &SogDocument) -> Result<Self, FormatError> {
        if document.has_codebooks() {
            let numbers = codebook(&document.scales.codebook, "scales")?;
            return Ok(Self::Codebook(Box::new(numbers)));
        }
        let Extremes { min, max } = document.scales.extremes::<3>("scales")?;
        let four = |[a, b, c]: [f32; 3]| [a, b, c, 0.0];
        Ok(Self::Extremes(Extremes {
            min: four(min),
            max: four(max),
        }))
    }

    fn of_colors(document: &SogDocument) -> Result<Self, FormatError> {
        if document.has_codebooks() {
            let numbers = codebook(&document.sh0.codebook, "sh0")?;
            return Ok(Self::Codebook(Box::new(numbers)));
        }
        Ok(Self::Extremes(document.sh0.extremes("sh0")?))
    }

    fn three(&self, codes: [u8; 3]) -> [f32; 3] {
        match self {
            Self::Codebook(numbers) => codes.map(|code| numbers[usize::from(code)]),
            Self::Extremes(range) => {
                std::array::from_fn(|k| range.at(k, f32::from(codes[k]) / 255.0))
            }
        }
    }

    fn opacity(&self, code: u8) -> f32 {
        match self {
            Self::Codebook(_) => logit::of_byte(code),
            Self::Extremes(range) => range.at(3, f32::from(code) / 255.0),
        }
    }
}

fn read_harmonics(
    splats: &mut Splats,
    harmonics: &Harmonics,
    palette: &Texture,
    labels: &[[u8; 4]],
) -> Result<(), FormatError> {
    let degree = harmonics.degree(palette.width)?;
    let functions = functions_of(degree);
    let numbers = harmonics.numbers()?;
    let entries = palette.pixels.len() / functions;
    let entries = harmonics
        .count
        .map_or(entries, |count| entries.min(count as usize));
    let mut rows = Vec::with_capacity(functions * labels.len());
    for &[low, high, ..] in labels {
        let label = usize::from(u16::from_le_bytes([low, high]));
        if label >= entries {
            // Such a splat is left out.
            rows.extend(std::iter::repeat_n([f32::NAN; 3], functions));
            continue;
        }
        let start = label / PALETTE_ROW * palette.width + label % PALETTE_ROW * functions;
        let entry = &palette.pixels[start..][..functions];
        rows.extend(
            entry
                .iter()
                .map(|&[r, g, b, _]| [r, g, b].map(|code| numbers[usize::from(code)])),
        );
    }
    splats.degree = degree;
    splats.harmonics = rows;
    Ok(())
}
