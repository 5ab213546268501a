//! Reading and checking a dataset's folder. Errors name the file and the frame that are wrong.

use crate::dataset::format::{
    AVATAR_FILE, Attribute, DatasetHeader, FORMAT, HEADER_FILE, LearnError, POSES_FILE, VERSION,
    frame_name,
};
use effigy_core::{
    avatar::{Avatar, Clip},
    io::file::map as map_file,
};
use memmap2::Mmap;
use rayon::prelude::*;
use safetensors::{Dtype, SafeTensors};
use std::fs::File;
use std::io::ErrorKind;
use std::ops::Range;
use std::path::{Path, PathBuf};

/// A frame's file and where its tensors begin.
pub struct MappedFrame {
    bytes: Mmap,
    /// In bytes, in the order of [`Attribute::ALL`].
    start: [usize; 4],
}

impl MappedFrame {
    /// The bytes of an attribute's rows.
    pub fn rows(&self, attribute: Attribute, rows: Range<usize>) -> &[u8] {
        let row_bytes = size_of::<half::f16>() * attribute.width();
        let start = self.start[attribute as usize] + row_bytes * rows.start;
        &self.bytes[start..][..row_bytes * rows.len()]
    }
}

fn content(file: PathBuf, found: impl ToString, expected: impl ToString) -> LearnError {
    LearnError::Content {
        file,
        found: found.to_string(),
        expected: expected.to_string(),
    }
}

/// Reads the header.
pub fn read_header(folder: &Path) -> Result<DatasetHeader, LearnError> {
    let file = folder.join(HEADER_FILE);
    let text = match std::fs::read_to_string(&file) {
        Ok(text) => text,
        Err(cause) if cause.kind() == ErrorKind::NotFound && folder.is_dir() => {
            return Err(content(
                file,
                "nothing",
                "the dataset's header; was its making interrupted? Make it again",
            ));
        }
        Err(cause) => return Err(LearnError::Read { file, cause }),
    };
    let header: DatasetHeader = serde_json::from_str(&text)
        .map_err(|error| content(file.clone(), error, "a dataset's header"))?;
    if header.format != FORMAT {
        return Err(content(
            file,
            format!("format \"{}\"", header.format),
            format!("\"{FORMAT}\""),
        ));
    }
    if header.version != VERSION {
        return Err(content(
            file,
            format!("version {}", header.version),
            format!("{VERSION}, the only one this program reads"),
        ));
    }
    if header.frames.is_empty() {
        return Err(content(file, "no frames", "at least one"));
    }
    Ok(header)
}

/// Checks that header, avatar and poses are of one body.
pub fn check_agreement(
    folder: &Path,
    header: &DatasetHeader,
    avatar: &Avatar,
    clip: &Clip,
) -> Result<(), LearnError> {
    let avatar_file = folder.join(AVATAR_FILE);
    let poses_file = folder.join(POSES_FILE);
    let skeleton = &avatar.skeleton;
    if avatar.gaussians.len() != header.gaussians {
        return Err(content(
            avatar_file,
            format!("{} Gaussians", avatar.gaussians.len()),
            format!("{}, as dataset.json says", header.gaussians),
        ));
    }
    let frames = header.frames.len();
    if clip.frames() != frames {
        return Err(LearnError::Frame {
            file: poses_file,
            frame: clip.frames().min(frames),
            found: format!("{} poses", clip.frames()),
            expected: format!("{frames}, as dataset.json says"),
        });
    }
    for joint in &clip.joint {
        if !skeleton.name.contains(joint) {
            return Err(content(
                poses_file,
                format!("joint \"{joint}\""),
                "joints of neutral.avatar's skeleton only",
            ));
        }
    }
    for &joint in &avatar.inputs.joint {
        let name = &skeleton.name[usize::from(joint)];
        if !clip.joint.contains(name) {
            return Err(content(
                poses_file,
                format!("no joint \"{name}\""),
                "every joint that neutral.avatar's networks see",
            ));
        }
    }
    let expected = avatar.inputs.expression;
    if clip.expression_len != expected {
        return Err(content(
            poses_file,
            format!("{} expression numbers", clip.expression_len),
            format!("{expected}, as neutral.avatar's networks see"),
        ));
    }
    Ok(())
}

/// Maps every frame's file and checks it.
pub fn map_frames(folder: &Path, header: &DatasetHeader) -> Result<Vec<MappedFrame>, LearnError> {
    (0..header.frames.len())
        .into_par_iter()
        .map(|frame| map_frame(folder, header.gaussians, frame))
        .collect()
}

fn map_frame(folder: &Path, gaussians: usize, frame: usize) -> Result<MappedFrame, LearnError> {
    let file = folder.join(frame_name(frame));
    let wrong = |found: String, expected: String| LearnError::Frame {
        file: file.clone(),
        frame,
        found,
        expected,
    };
    let unreadable = |cause: std::io::Error| LearnError::Read {
        file: file.clone(),
        cause,
    };
    let opened = match File::open(&file) {
        Ok(opened) => opened,
        Err(cause) if cause.kind() == ErrorKind::NotFound => {
            return Err(wrong(
                "nothing".into(),
                "the frame's file: dataset.json lists it".into(),
            ));
        }
        Err(cause) => return Err(unreadable(cause)),
    };
    let bytes = map_file(&opened).map_err(unreadable)?;
    let tensors = SafeTensors::deserialize(&bytes)
        .map_err(|error| wrong(error.to_string(), "a whole safetensors file".into()))?;
    let mut start = [0; 4];
    for attribute in Attribute::ALL {
        let name = attribute.name();
        let tensor = tensors
            .tensor(name)
            .map_err(|_| wrong(format!("no tensor `{name}`"), "one".into()))?;
        let shape = [gaussians, attribute.width()];
        if tensor.dtype() != Dtype::F16 || tensor.shape() != shape {
            let found = format!(
                "`{name}` of {} and shape {:?}",
                tensor.dtype(),
                tensor.shape()
            );
            return Err(wrong(
                found,
                format!("F16 and {shape:?}, as in dataset.json"),
            ));
        }
        let data = tensor.data();
        // All bits of the exponent are set in NaN and infinity.
        let is_not_finite = |half: &[u8; 2]| u16::from_le_bytes(*half) & 0x7C00 == 0x7C00;
        if let Some(at) = data.as_chunks::<2>().0.iter().position(is_not_finite) {
            let gaussian = at / attribute.width();
            return Err(wrong(
                format!("NaN or infinity in `{name}` of Gaussian {gaussian}"),
                "finite numbers".into(),
            ));
        }
        start[attribute as usize] = data.as_ptr() as usize - bytes.as_ptr() as usize;
    }
    Ok(MappedFrame { bytes, start })
}
