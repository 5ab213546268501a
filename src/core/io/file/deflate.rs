//! Deflated tensors: bytes are arranged so that similar ones are neighbours, then compressed (zlib,
//! RFC 1950, whose checksum detects damage). Expansion never exceeds the length known beforehand.

use flate2::{Compress, Compression, Decompress, FlushCompress, FlushDecompress, Status};
use serde::{Deserialize, Serialize};

/// All tensors together may be at most this many times as long as their bytes in the file. Files
/// that expand further are rejected.
pub const EXPANSION: usize = 16;
/// Bytes that any file may expand to in addition.
pub const EXPANSION_FREE: usize = 64 << 10;

/// How a tensor's bytes are arranged before they are deflated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum ByteArrangement {
    /// The first byte of every number, then the second of every number, and so on.
    Planes,
    /// [`ByteArrangement::Planes`] of differences: from each integer its predecessor in the row
    /// before is subtracted, with wrapping, and columns follow each other.
    Deltas,
}

/// How a tensor's bytes divide into numbers and rows.
#[derive(Clone, Copy, Debug)]
pub struct NumberLayout {
    /// Bytes of a number: 1, 2 or 4.
    pub width: usize,
    /// Numbers of a row.
    pub columns: usize,
}

/// A little-endian number of up to 4 bytes.
fn read(bytes: &[u8]) -> u32 {
    bytes
        .iter()
        .rev()
        .fold(0, |value, &byte| value << 8 | u32::from(byte))
}

/// Writes the low bytes of a number, little-endian.
fn put(value: u32, bytes: &mut [u8]) {
    let length = bytes.len();
    bytes.copy_from_slice(&value.to_le_bytes()[..length]);
}

/// Whether a tensor is whole rows of numbers.
fn is_whole(length: usize, kind: NumberLayout) -> bool {
    (1..=4).contains(&kind.width)
        && kind.columns > 0
        && length.is_multiple_of(kind.width * kind.columns)
}

/// Arranges bytes for compression.
fn arrange(bytes: &[u8], kind: NumberLayout, order: ByteArrangement) -> Vec<u8> {
    let width = kind.width;
    let numbers = bytes.len() / width;
    let mut out = vec![0; bytes.len()];
    let rows = numbers / kind.columns;
    for at in 0..numbers {
        let value = &bytes[at * width..][..width];
        match order {
            ByteArrangement::Planes => {
                for k in 0..width {
                    out[k * numbers + at] = value[k];
                }
            }
            ByteArrangement::Deltas => {
                let before = if at < kind.columns {
                    0
                } else {
                    read(&bytes[(at - kind.columns) * width..][..width])
                };
                let delta = read(value).wrapping_sub(before).to_le_bytes();
                let place = at % kind.columns * rows + at / kind.columns;
                for k in 0..width {
                    out[k * numbers + place] = delta[k];
                }
            }
        }
    }
    out
}

/// Undoes [`arrange`].
fn restore(arranged: &[u8], kind: NumberLayout, order: ByteArrangement) -> Vec<u8> {
    let width = kind.width;
    let numbers = arranged.len() / width;
    let mut out = vec![0; arranged.len()];
    let rows = numbers / kind.columns;
    match order {
        ByteArrangement::Planes => {
            for (k, plane) in arranged.chunks_exact(numbers.max(1)).enumerate() {
                for (at, &byte) in plane.iter().enumerate() {
                    out[at * width + k] = byte;
                }
            }
        }
        ByteArrangement::Deltas => {
            for column in 0..kind.columns {
                let mut value = 0u32;
                for row in 0..rows {
                    let place = column * rows + row;
                    let delta = (0..width).fold(0, |delta, k| {
                        delta | u32::from(arranged[k * numbers + place]) << (8 * k)
                    });
                    value = value.wrapping_add(delta);
                    put(
                        value,
                        &mut out[(row * kind.columns + column) * width..][..width],
                    );
                }
            }
        }
    }
    out
}

/// The shortest deflated form of a tensor's bytes, and their arrangement in it. None if no form is
/// shorter than the bytes.
pub fn pack(
    bytes: &[u8],
    kind: NumberLayout,
    orders: &[ByteArrangement],
) -> Option<(ByteArrangement, Vec<u8>)> {
    if !is_whole(bytes.len(), kind) {
        return None;
    }
    let forms = orders
        .iter()
        .filter_map(|&order| Some((order, deflate(&arrange(bytes, kind, order))?)));
    forms
        .min_by_key(|(_, form)| form.len())
        .filter(|(_, form)| form.len() < bytes.len())
}

/// None if the result would not be shorter.
fn deflate(bytes: &[u8]) -> Option<Vec<u8>> {
    let mut out = Vec::with_capacity(bytes.len());
    let status = Compress::new(Compression::best(), true)
        .compress_vec(bytes, &mut out, FlushCompress::Finish)
        .ok()?;
    (status == Status::StreamEnd).then_some(out)
}

/// Expands to `length` bytes.
///
/// # Errors
/// What was found instead, in words.
pub fn unpack(
    packed: &[u8],
    length: usize,
    kind: NumberLayout,
    order: ByteArrangement,
) -> Result<Vec<u8>, String> {
    if !is_whole(length, kind) {
        return Err(format!(
            "{} deflated bytes of an empty tensor",
            packed.len()
        ));
    }
    // One byte more, to detect streams that are too long.
    let mut arranged = vec![0; length + 1];
    let mut stream = Decompress::new(true);
    let status = stream.decompress(packed, &mut arranged, FlushDecompress::Finish);
    let taken = stream.total_in();
    let made = stream.total_out();
    match status {
        Ok(_) if made > length as u64 => Err("deflated bytes that make more".into()),
        Ok(Status::StreamEnd) if made < length as u64 => {
            Err(format!("deflated bytes that make {made}"))
        }
        Ok(Status::StreamEnd) if taken < packed.len() as u64 => Err(format!(
            "{} bytes after the deflated ones",
            packed.len() as u64 - taken
        )),
        Ok(Status::StreamEnd) => Ok(restore(&arranged[..length], kind, order)),
        Ok(_) => Err(format!("deflated bytes cut off after {made}")),
        Err(_) => Err(format!("deflated bytes damaged after {made}")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ORDERS: [ByteArrangement; 2] = [ByteArrangement::Planes, ByteArrangement::Deltas];

    #[test]
    fn packed_bytes_come_back() {
        let bytes: Vec<u8> = (0..4800u32).map(|k| (k / 300 + k % 4 * 5) as u8).collect();
        for width in [1, 2, 4] {
            for columns in [1, 3, 50] {
                let kind = NumberLayout { width, columns };
                for order in ORDERS {
                    assert_eq!(
                        restore(&arrange(&bytes, kind, order), kind, order),
                        bytes,
                        "{kind:?} {order:?}"
                    );
                    let (used, packed) = pack(&bytes, kind, &[order]).expect("it is regular");
                    assert_eq!(
                        (used, unpack(&packed, bytes.len(), kind, order)),
                        (order, Ok(bytes.clone()))
                    );
                }
            }
        }
    }

    #[test]
    fn what_rises_evenly_is_nearly_nothing_as_deltas() {
        let rising: Vec<u8> = (0..3000u32)
            .flat_map(|k| (60_000 + 17 * k).to_le_bytes())
            .collect();
        let (order, packed) = pack(
            &rising,
            NumberLayout {
                width: 4,
                columns: 1,
            },
            &ORDERS,
        )
        .expect("it is regular");
        assert!(
            order == ByteArrangement::Deltas && packed.len() < 100,
            "{order:?}: {} bytes",
            packed.len()
        );
    }

    #[test]
    fn noise_and_nothing_are_left_as_they_are() {
        let mut seed = 1u32;
        let noise: Vec<u8> = std::iter::repeat_with(|| {
            (
                seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223),
                (seed >> 24) as u8,
            )
                .1
        })
        .take(999)
        .collect();
        assert_eq!(
            pack(
                &noise,
                NumberLayout {
                    width: 1,
                    columns: 3
                },
                &ORDERS
            ),
            None
        );
        assert_eq!(
            pack(
                &[],
                NumberLayout {
                    width: 1,
                    columns: 0
                },
                &ORDERS
            ),
            None
        );
        assert!(
            unpack(
                &[1],
                0,
                NumberLayout {
                    width: 4,
                    columns: 0
                },
                ByteArrangement::Deltas
            )
            .is_err()
        );
    }

    #[test]
    fn damaged_short_and_long_streams_are_told_apart() {
        let bytes = [7u8; 400];
        let kind = NumberLayout {
            width: 2,
            columns: 1,
        };
        let (order, packed) = pack(&bytes, kind, &ORDERS).expect("it is regular");
        let says = |packed: &[u8], length: usize| unpack(packed, length, kind, order).unwrap_err();
        assert_eq!(says(&packed, 402), "deflated bytes that make 400");
        assert_eq!(says(&packed, 398), "deflated bytes that make more");
        assert_eq!(
            says(&[&packed[..], &[0; 3]].concat(), 400),
            "3 bytes after the deflated ones"
        );
        assert!(
            says(&packed[..packed.len() - 6], 400).starts_with("deflated bytes cut off after ")
        );
        let mut damaged = packed.clone();
        *damaged.last_mut().expect("it is not empty") ^= 1;
        assert_eq!(says(&damaged, 400), "deflated bytes damaged after 400");
    }
}
