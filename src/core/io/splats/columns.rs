//! The avatar of splats as one run of bytes, for two libraries of one page to hand each other in
//! less time than an `.avatar` file takes. It is no file format, since both are always of one
//! version.
//!
//! The length of a document in 8 bytes, the document in JSON, then the Gaussians, an array after
//! the other in this machine's order.

use super::{
    avatar::{nodes, scene},
    functions_of,
};
use crate::{
    avatar::{Avatar, Bounds, Filter, Gaussians, ShCoefficients, limits},
    io::file::FormatError,
};
use bytemuck::{AnyBitPattern, NoUninit};
use half::f16;
use serde::{Deserialize, Serialize};

/// The properties that are not arrays.
#[derive(Serialize, Deserialize)]
struct ColumnsHeader {
    name: String,
    /// Axis-angle rotation of the canonical pose, radians.
    canonical: [f32; 3],
    /// Lower and upper corner of the box of positions, metres.
    bounds: [[f32; 3]; 2],
    gaussians: usize,
    nodes: usize,
    /// Highest degree of the spherical harmonics.
    degree: usize,
    filter: Filter,
}

/// The bytes of an avatar that [`Splats::to_avatar`](super::Splats::to_avatar) has made.
pub fn to_columns(avatar: &Avatar) -> Vec<u8> {
    let gaussians = &avatar.gaussians;
    let document = serde_json::json!(ColumnsHeader {
        name: avatar.name.clone(),
        canonical: avatar
            .skeleton
            .canonical
            .first()
            .copied()
            .unwrap_or_default(),
        bounds: [gaussians.bounds.min, gaussians.bounds.max],
        gaussians: gaussians.len(),
        nodes: avatar.nodes.len(),
        degree: avatar.sh.as_ref().map_or(0, |sh| sh.degree),
        filter: avatar.filter,
    })
    .to_string();
    let mut bytes = (document.len() as u64).to_le_bytes().to_vec();
    bytes.extend(document.as_bytes());
    bytes.extend_from_slice(bytemuck::cast_slice(&gaussians.position));
    bytes.extend_from_slice(bytemuck::cast_slice(&gaussians.rotation));
    bytes.extend_from_slice(bytemuck::cast_slice(&gaussians.log_scale));
    bytes.extend_from_slice(bytemuck::cast_slice(&gaussians.color));
    bytes.extend_from_slice(&gaussians.opacity);
    bytes.extend_from_slice(bytemuck::cast_slice(&avatar.nodes.offset));
    if avatar.nodes.len() > 1 {
        bytes.extend_from_slice(bytemuck::cast_slice(&gaussians.node));
    }
    if let Some(sh) = &avatar.sh {
        bytes.extend_from_slice(bytemuck::cast_slice(&sh.coefficients));
    }
    bytes
}

/// The avatar of [`to_columns`].
///
/// # Errors
/// When the bytes are something else. [`Avatar::check`] checks the numbers.
pub fn from_columns(bytes: &[u8]) -> Result<Avatar, FormatError> {
    let other = || FormatError::container("other bytes", "splats of this version of Effigy");
    let (length, rest) = bytes.split_first_chunk::<8>().ok_or_else(other)?;
    let length = usize::try_from(u64::from_le_bytes(*length)).map_err(|_| other())?;
    let (document, rest) = rest.split_at_checked(length).ok_or_else(other)?;
    let document: ColumnsHeader = serde_json::from_slice(document).map_err(|_| other())?;
    let count = document.gaussians;
    let allowed = (1..=limits::GAUSSIANS).contains(&count)
        && (1..=limits::NODES).contains(&document.nodes)
        && document.degree <= 3;
    if !allowed {
        return Err(other());
    }
    let [min, max] = document.bounds;
    let mut columns = ColumnReader { rest };
    let mut gaussians = Gaussians {
        bounds: Bounds { min, max },
        position: columns.take(count).ok_or_else(other)?,
        rotation: columns.take(count).ok_or_else(other)?,
        log_scale: columns.take(count).ok_or_else(other)?,
        color: columns.take(count).ok_or_else(other)?,
        opacity: columns.take(count).ok_or_else(other)?,
        ..Gaussians::of_one_joint(count)
    };
    let nodes = nodes(columns.take(document.nodes).ok_or_else(other)?);
    if nodes.len() > 1 {
        gaussians.node = columns.take(count).ok_or_else(other)?;
    }
    let functions = functions_of(document.degree);
    let coefficients: Vec<[f16; 3]> = columns.take(functions * count).ok_or_else(other)?;
    let sh = (functions > 0).then_some(ShCoefficients {
        degree: document.degree,
        coefficients,
    });
    Ok(scene(
        &document.name,
        document.canonical,
        gaussians,
        nodes,
        sh,
        document.filter,
    ))
}

/// Reads arrays that follow each other.
struct ColumnReader<'a> {
    rest: &'a [u8],
}

impl ColumnReader<'_> {
    /// The next array; None: it is cut off.
    fn take<T: NoUninit + AnyBitPattern>(&mut self, count: usize) -> Option<Vec<T>> {
        let (bytes, rest) = self.rest.split_at_checked(count * size_of::<T>())?;
        self.rest = rest;
        Some(bytemuck::pod_collect_to_vec(bytes))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::io::splats::{Splats, Up};

    fn avatar(degree: usize) -> Avatar {
        let functions = functions_of(degree);
        let splats = Splats {
            position: vec![[1.0, 2.0, 3.0], [-1.0, 0.5, 0.1], [0.0; 3]],
            rotation: vec![
                [1.0, 0.0, 0.0, 0.0],
                [0.5, 0.5, 0.1, 0.2],
                [0.0, 1.0, 0.0, 0.0],
            ],
            log_scale: vec![[-4.0; 3], [f32::NEG_INFINITY, -3.0, -2.0], [-5.0; 3]],
            opacity: vec![0.5, f32::INFINITY, -2.0],
            color: vec![[0.1, 0.2, 0.3], [1.0; 3], [0.0; 3]],
            degree,
            harmonics: (0..3 * functions).map(|k| [k as f32, 0.25, -0.5]).collect(),
            up: Up::Z,
            filter: Filter::ANTIALIASED,
        };
        splats.to_avatar("three").expect("splats that fit")
    }

    #[test]
    fn what_is_handed_over_arrives() {
        for degree in 0..=3 {
            let avatar = avatar(degree);
            assert_eq!(from_columns(&to_columns(&avatar)), Ok(avatar));
        }
    }

    #[test]
    fn what_is_cut_off_is_refused() {
        let bytes = to_columns(&avatar(2));
        for length in 0..bytes.len() {
            assert!(from_columns(&bytes[..length]).is_err(), "{length} bytes");
        }
        assert!(from_columns(&[0xFF; 64]).is_err());
    }
}
