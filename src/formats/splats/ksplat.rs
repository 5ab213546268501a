//! mkkellogg's `.ksplat`: a header of 4096 bytes, headers of 1024 bytes a section, then the
//! sections. Axes are those of a 3DGS `.ply`.
//!
//! A splat has its position, standard deviations, quaternion w x y z, RGB and opacity of 255, and
//! harmonics: degree by degree all reds, greens and blues. Compression 0 has f32. Compression 1 has
//! f16, positions as 16-bit steps from the middle of a block (a bucket), whose position stands before the
//! splats; 2 has harmonics in bytes between extremes.

use super::{
    bytes::{array, f32_at, slice, u16_at, u32_at},
    logit,
};
use effigy_core::{
    avatar::Filter,
    io::{
        file::FormatError,
        splats::{Splats, Up, check_count, functions_of},
    },
};
use half::f16;

/// Bytes of the header, and of a section's.
const HEADER: u64 = 4096;
const SECTION: u64 = 1024;
/// Steps from the middle of a block to its side, where a section says nothing.
const STEPS: u32 = 32_767;
/// Extremes of harmonics in bytes, where the header says nothing.
const HARMONIC: f32 = 1.5;
/// Bytes of a bucket: its middle.
const BUCKET: u64 = 12;

/// Whether bytes begin as a `.ksplat`: a version 0.1, plausible counts and a known compression. The
/// format has no mark. `length`: of the whole file.
pub fn is_ksplat(start: &[u8], length: u64) -> bool {
    let Ok(header) = slice(start, 0, 44, "a header") else {
        return false;
    };
    let [sections, used, most, count] = [4, 8, 12, 16].map(|at| u64::from(u32_at(header, at)));
    header.starts_with(&[0, 1, 0, 0])
        && used <= sections
        && sections >= 1
        && count <= most
        && u16_at(header, 20) <= 2
        && HEADER + SECTION * sections <= length
}

/// Where a section's numbers are, and what they count in.
struct SplatSection<'a> {
    count: usize,
    compression: u16,
    degree: usize,
    /// Metres a step of compressed positions, and steps from a block's side to its middle.
    step: f32,
    middle: f32,
    /// Splats of each of the buckets that are full.
    bucket: usize,
    full: usize,
    /// Splats of each of the others, u32.
    partial: &'a [u8],
    /// Middles of the buckets.
    buckets: &'a [u8],
    rows: &'a [u8],
}

/// Bytes of a splat without harmonics, and of a harmonic, by compression.
fn widths(compression: u16) -> (u64, u64) {
    match compression {
        0 => (44, 4),
        1 => (24, 2),
        _ => (24, 1),
    }
}

/// Reads the splats.
///
/// # Errors
/// When the version is unknown, a section is cut off, or counts do not fit each other.
pub fn read(bytes: &[u8]) -> Result<Splats, FormatError> {
    let header = slice(bytes, 0, HEADER, "a header")?;
    if header[0] != 0 || header[1] == 0 {
        return Err(FormatError::container(
            format!("version {}.{}", header[0], header[1]),
            "0.1, of a .ksplat",
        ));
    }
    let compression = u16_at(header, 20);
    if compression > 2 {
        return Err(FormatError::container(
            format!("compression {compression}"),
            "0, 1 or 2",
        ));
    }
    let sections = u64::from(u32_at(header, 4));
    let heads = slice(bytes, HEADER, SECTION.saturating_mul(sections), "headers")?;
    let mut at = HEADER + SECTION * sections;
    let mut found = Vec::new();
    for head in heads.chunks_exact(SECTION as usize) {
        let section = section(bytes, head, compression, at)?;
        at = section.end;
        found.push(section.section);
    }
    let total: usize = found.iter().map(|section| section.count).sum();
    check_count(total as u64)?;
    let degree = found
        .iter()
        .map(|section| section.degree)
        .max()
        .unwrap_or_default();
    let mut splats = Splats {
        position: Vec::with_capacity(total),
        rotation: Vec::with_capacity(total),
        log_scale: Vec::with_capacity(total),
        opacity: Vec::with_capacity(total),
        color: Vec::with_capacity(total),
        degree,
        harmonics: Vec::with_capacity(functions_of(degree) * total),
        up: Up::TRAINED,
        filter: Filter::DEFAULT,
    };
    let or = |at: usize, other: f32| match f32_at(header, at) {
        0.0 => other,
        value => value,
    };
    let extremes = [or(36, -HARMONIC), or(40, HARMONIC)];
    for section in &found {
        add(&mut splats, section, extremes)?;
    }
    Ok(splats)
}

/// A section, and the byte after it.
struct Placed<'a> {
    section: SplatSection<'a>,
    end: u64,
}

fn section<'a>(
    bytes: &'a [u8],
    head: &[u8],
    compression: u16,
    at: u64,
) -> Result<Placed<'a>, FormatError> {
    let number = |at: usize| u64::from(u32_at(head, at));
    let [most, bucket, buckets, full, partial] = [4, 8, 12, 32, 36].map(number);
    // A file that is written whole has as many as there is place for.
    let count = most;
    let degree = usize::from(u16_at(head, 40));
    if degree > 3 {
        return Err(FormatError::container(
            format!("harmonics of degree {degree}"),
            "0 to 3",
        ));
    }
    let stored = u64::from(u16_at(head, 20));
    if buckets > 0 && compression > 0 && stored != BUCKET {
        return Err(FormatError::container(
            format!("buckets of {stored} bytes"),
            format!("{BUCKET}"),
        ));
    }
    let (own, harmonic) = widths(compression);
    let width = own + 3 * functions_of(degree) as u64 * harmonic;
    let partial_length = 4 * partial;
    let bucket_length = stored * buckets;
    let rows_at = at + partial_length + bucket_length;
    let rows = slice(bytes, rows_at, width * count, "splats")?;
    let steps = match u32_at(head, 24) {
        0 => STEPS,
        steps => steps,
    };
    Ok(Placed {
        end: rows_at + width * count,
        section: SplatSection {
            count: count as usize,
            compression,
            degree,
            step: f32_at(head, 16) / 2.0 / steps as f32,
            middle: steps as f32,
            bucket: bucket as usize,
            full: full as usize,
            partial: slice(bytes, at, partial_length, "lengths of buckets")?,
            buckets: slice(bytes, at + partial_length, bucket_length, "buckets")?,
            rows,
        },
    })
}

/// The bucket of each splat in turn.
struct Buckets<'a> {
    section: &'a SplatSection<'a>,
    index: usize,
    left: u64,
}

impl Buckets<'_> {
    /// The middle of the next splat's bucket. None: there are too few.
    fn next_middle(&mut self) -> Option<[f32; 3]> {
        while self.left == 0 {
            self.left = match self.index.checked_sub(self.section.full) {
                None => self.section.bucket as u64,
                Some(k) => u32_at(self.section.partial.get(4 * k..)?.get(..4)?, 0).into(),
            };
            self.index += 1;
        }
        self.left -= 1;
        let start = BUCKET as usize * (self.index - 1);
        let middle = self.section.buckets.get(start..)?.get(..BUCKET as usize)?;
        Some([0, 4, 8].map(|at| f32_at(middle, at)))
    }
}

fn add(splats: &mut Splats, section: &SplatSection, extremes: [f32; 2]) -> Result<(), FormatError> {
    if section.count == 0 {
        return Ok(());
    }
    let width = section.rows.len() / section.count;
    let half = |row: &[u8], k: usize| f16::from_le_bytes(array(row, 2 * k)).to_f32();
    let functions = functions_of(section.degree);
    let wanted = functions_of(splats.degree);
    let mut buckets = Buckets {
        section,
        index: 0,
        left: 0,
    };
    for row in section.rows.chunks_exact(width) {
        let packed = section.compression > 0;
        let number = |k: usize| {
            if packed {
                half(row, k)
            } else {
                f32_at(row, 4 * k)
            }
        };
        splats.position.push(if packed {
            let middle = buckets.next_middle().ok_or_else(|| {
                FormatError::container("splats beyond the last bucket", "a bucket for each")
            })?;
            std::array::from_fn(|k| {
                let steps = f32::from(u16_at(row, 2 * k)) - section.middle;
                middle[k] + section.step * steps
            })
        } else {
            [0, 1, 2].map(number)
        });
        splats.log_scale.push([3, 4, 5].map(|k| number(k).ln()));
        splats.rotation.push([6, 7, 8, 9].map(number));
        let at = if packed { 20 } else { 40 };
        let [r, g, b, opacity] = array(row, at);
        let part = |byte: u8| logit::color_of_part(f32::from(byte) / 255.0);
        splats.color.push([r, g, b].map(part));
        splats.opacity.push(logit::of_byte(opacity));
        let harmonic = |k: usize| match section.compression {
            0 => f32_at(row, 44 + 4 * k),
            1 => f16::from_le_bytes(array(row, 24 + 2 * k)).to_f32(),
            _ => extremes[0] + (extremes[1] - extremes[0]) * f32::from(row[24 + k]) / 255.0,
        };
        for degree in 1..=section.degree {
            // All reds of a degree come first, then all greens, then all blues.
            let start = 3 * functions_of(degree - 1);
            let own = 2 * degree + 1;
            let rgb = |k: usize| [0, 1, 2].map(|channel| harmonic(start + channel * own + k));
            splats.harmonics.extend((0..own).map(rgb));
        }
        // A section of a lower degree than another's.
        let short = wanted - functions;
        splats
            .harmonics
            .extend(std::iter::repeat_n([0.0; 3], short));
    }
    Ok(())
}
