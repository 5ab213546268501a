//! Reading of a `.ply` into an avatar.

use super::{gaussians, header, up::Up, vertices::VertexTable};
use crate::avatar::{Activation, Avatar, Inputs, Matrix, Networks, Nodes, Parts, Rows, Skeleton};
use crate::io::file::{FileError, FormatError, read_with};
use half::f16;
use std::{fs::File, io::Read, path::Path};

/// Reads an avatar file or a 3DGS `.ply`, told apart by content. `up` is the axis of a `.ply` that
/// points up. None: the axis that a comment in the file names (written by
/// [`crate::io::ply_export`]), else [`Up::TRAINED`].
///
/// # Errors
/// When the file cannot be opened, is neither, or breaks a rule.
pub fn open(path: &Path, up: Option<Up>) -> Result<Avatar, FileError> {
    if !is_ply(path) {
        return Avatar::read(path);
    }
    let name = path.file_stem().unwrap_or_default().to_string_lossy();
    read_with(path, |bytes| from_bytes(bytes, &name, up))
}

/// Whether a file is a `.ply` by its content or its name. False if it can't be read: opening it
/// then gives the error.
pub fn is_ply(path: &Path) -> bool {
    let mut start = [0; 4];
    let read = File::open(path).and_then(|mut file| file.read_exact(&mut start));
    let named = path
        .extension()
        .is_some_and(|ending| ending.eq_ignore_ascii_case("ply"));
    named || read.is_ok() && matches!(&start, b"ply\n" | b"ply\r")
}

/// Reads an avatar from the bytes of a `.ply`. `up`: see [`open`].
///
/// # Errors
/// When a property is missing, a number is not finite, or the file ends too soon.
pub fn from_bytes(bytes: &[u8], name: &str, up: Option<Up>) -> Result<Avatar, FormatError> {
    let header = header::parse(bytes)?;
    let up = up.or(header.up).unwrap_or(Up::TRAINED);
    let (gaussians, sh) = gaussians::read(&VertexTable::new(bytes, header)?)?;
    let canonical = up
        .rotation()
        .inverse()
        .to_scaled_axis()
        .as_vec3()
        .to_array();
    Ok(Avatar {
        name: name.into(),
        credit: String::new(),
        skeleton: Skeleton {
            name: vec!["root".into()],
            parent: vec![None],
            rest: vec![[0.0; 3]],
            canonical: vec![canonical],
        },
        parts: Parts {
            start: vec![0, gaussians.len() as u32],
            head: 0,
        },
        networks: Networks {
            activation: Activation::Relu,
            layers: vec![],
        },
        rotation_rows: Rows::default(),
        scale_rows: Rows::default(),
        color_rows: Rows::default(),
        // One node that moves nothing: every Gaussian must name three.
        nodes: Nodes {
            position: vec![[0; 3]],
            part: vec![0],
            offset: vec![[f16::ZERO; 3]],
            basis: Matrix::default(),
        },
        inputs: Inputs {
            joint: vec![],
            expression: 0,
            pose_space: None,
            expression_space: None,
        },
        gaussians,
        sh,
    })
}
