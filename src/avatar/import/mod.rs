//! Other people's splats: a 3DGS `.ply` goes in, a static [`Avatar`] comes out, of one joint that turns the file's axes to ours;
//! [`cameras`] reads the cameras that belong to it.
//!
//! The canonical space is the file's own, so that harmonics keep their directions. Numbers become what an avatar stores: positions
//! 16-bit coordinates in the Gaussians' box, opacity 8 bits, all else f16.

pub mod cameras;
mod gaussians;
mod header;
mod rows;

use super::{
    Activation, Avatar, Inputs, Matrix, Networks, Nodes, Parts, Rows as NoRows, Skeleton,
    file::{Fault, FileError, read_with},
};
use glam::DQuat;
use half::f16;
pub use header::UP_COMMENT;
use std::{f64::consts::FRAC_PI_2, fs::File, io::Read, path::Path};

/// The axis of a file that points up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(not(target_os = "android"), derive(clap::ValueEnum))]
pub enum Up {
    #[cfg_attr(not(target_os = "android"), value(name = "y"))]
    Y,
    #[cfg_attr(not(target_os = "android"), value(name = "-y"))]
    MinusY,
    #[cfg_attr(not(target_os = "android"), value(name = "z"))]
    Z,
    #[cfg_attr(not(target_os = "android"), value(name = "-z"))]
    MinusZ,
}

impl Up {
    /// Where 3DGS puts it: its world is that of COLMAP's first camera, whose y points down.
    pub const TRAINED: Self = Self::MinusY;

    fn parse(name: &str) -> Option<Self> {
        [("y", Self::Y), ("-y", Self::MinusY), ("z", Self::Z), ("-z", Self::MinusZ)].into_iter().find(|up| up.0 == name).map(|up| up.1)
    }

    /// Turns the file's axes so that y is up, about x. A person in front of COLMAP's first camera then faces +z.
    pub fn rotation(self) -> DQuat {
        let quarters = match self {
            Self::Y => 0.0,
            Self::MinusY => 2.0,
            Self::Z => -1.0,
            Self::MinusZ => 1.0,
        };
        DQuat::from_rotation_x(quarters * FRAC_PI_2)
    }
}

/// Reads an avatar file or a 3DGS `.ply`, told apart by content. `up` is for the latter; without it the file's own word counts, which
/// [`super::export`] writes, and else [`Up::TRAINED`].
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

/// Whether a file is a `.ply`, or is named like one. False where it can't be read: who opens it says why.
pub fn is_ply(path: &Path) -> bool {
    let mut start = [0; 4];
    let read = File::open(path).and_then(|mut file| file.read_exact(&mut start));
    let named = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("ply"));
    named || read.is_ok() && matches!(&start, b"ply\n" | b"ply\r")
}

/// The same from the bytes of a `.ply`.
///
/// # Errors
/// When a property is missing, a number is not finite, or the file ends too soon.
pub fn from_bytes(bytes: &[u8], name: &str, up: Option<Up>) -> Result<Avatar, Fault> {
    let header = header::parse(bytes)?;
    let up = up.or(header.up).unwrap_or(Up::TRAINED);
    let (gaussians, harmonics) = gaussians::read(&rows::Rows::new(bytes, header)?)?;
    let canonical = up.rotation().inverse().to_scaled_axis().as_vec3().to_array();
    Ok(Avatar {
        name: name.into(),
        credit: String::new(),
        skeleton: Skeleton { name: vec!["root".into()], parent: vec![None], rest: vec![[0.0; 3]], canonical: vec![canonical] },
        parts: Parts { start: vec![0, gaussians.len() as u32], head: 0 },
        networks: Networks { activation: Activation::Relu, layers: vec![] },
        rotation_rows: NoRows::default(),
        scale_rows: NoRows::default(),
        color_rows: NoRows::default(),
        // One that moves nothing: every Gaussian names three.
        nodes: Nodes { position: vec![[0; 3]], part: vec![0], offset: vec![[f16::ZERO; 3]], basis: Matrix::default() },
        inputs: Inputs { joint: vec![], expression: 0, pose_space: None, expression_space: None },
        gaussians,
        harmonics,
    })
}
