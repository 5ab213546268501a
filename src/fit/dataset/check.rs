//! A dataset's folder in; its header and mapped frames out, or one sentence that names the file and the frame that are wrong.

use super::{Attribute, Error, FORMAT, Header, Mapped, VERSION, frame_name};
use crate::avatar::{Avatar, Clip, file::map as map_file};
use rayon::prelude::*;
use safetensors::{Dtype, SafeTensors};
use std::fs::File;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

fn content(file: PathBuf, found: impl ToString, expected: impl ToString) -> Error {
    Error::Content { file, found: found.to_string(), expected: expected.to_string() }
}

pub fn header(folder: &Path) -> Result<Header, Error> {
    let file = folder.join("dataset.json");
    let text = match std::fs::read_to_string(&file) {
        Ok(text) => text,
        Err(cause) if cause.kind() == ErrorKind::NotFound && folder.is_dir() => {
            return Err(content(file, "nothing", "the dataset's header; was its making interrupted? Make it again"));
        }
        Err(cause) => return Err(Error::Read { file, cause }),
    };
    let header: Header = serde_json::from_str(&text).map_err(|error| content(file.clone(), error, "a dataset's header"))?;
    if header.format != FORMAT {
        return Err(content(file, format!("format \"{}\"", header.format), format!("\"{FORMAT}\"")));
    }
    if header.version != VERSION {
        return Err(content(file, format!("version {}", header.version), format!("{VERSION}, the only one this program reads")));
    }
    if header.frames.is_empty() {
        return Err(content(file, "no frames", "at least one"));
    }
    Ok(header)
}

/// Header, avatar and poses are of one body.
pub fn agree(folder: &Path, header: &Header, avatar: &Avatar, clip: &Clip) -> Result<(), Error> {
    let [neutral, poses] = ["neutral.avatar", "poses.motion"].map(|name| folder.join(name));
    if avatar.gaussians.len() != header.gaussians {
        return Err(content(
            neutral,
            format!("{} Gaussians", avatar.gaussians.len()),
            format!("{}, as dataset.json says", header.gaussians),
        ));
    }
    let frames = header.frames.len();
    if clip.frames() != frames {
        let (frame, found) = (clip.frames().min(frames), format!("{} poses", clip.frames()));
        return Err(Error::Frame { file: poses, frame, found, expected: format!("{frames}, as dataset.json says") });
    }
    if let Some(joint) = clip.joint.iter().find(|joint| !avatar.skeleton.name.contains(joint)) {
        return Err(content(poses, format!("joint \"{joint}\""), "joints of neutral.avatar's skeleton only"));
    }
    if let Some(&joint) = avatar.inputs.joint.iter().find(|&&j| !clip.joint.contains(&avatar.skeleton.name[usize::from(j)])) {
        let name = &avatar.skeleton.name[usize::from(joint)];
        return Err(content(poses, format!("no joint \"{name}\""), "every joint that neutral.avatar's networks see"));
    }
    if clip.expression_len != avatar.inputs.expression {
        let (found, expected) = (clip.expression_len, avatar.inputs.expression);
        return Err(content(poses, format!("{found} expression numbers"), format!("{expected}, as neutral.avatar's networks see")));
    }
    Ok(())
}

pub fn frames(folder: &Path, header: &Header) -> Result<Vec<Mapped>, Error> {
    (0..header.frames.len()).into_par_iter().map(|frame| map(folder, header.gaussians, frame)).collect()
}

fn map(folder: &Path, gaussians: usize, frame: usize) -> Result<Mapped, Error> {
    let file = folder.join(frame_name(frame));
    let wrong = |found: String, expected: String| Error::Frame { file: file.clone(), frame, found, expected };
    let opened = match File::open(&file) {
        Err(cause) if cause.kind() == ErrorKind::NotFound => {
            return Err(wrong("nothing".into(), "the frame's file: dataset.json lists it".into()));
        }
        other => other.map_err(|cause| Error::Read { file: file.clone(), cause })?,
    };
    let bytes = map_file(&opened).map_err(|cause| Error::Read { file: file.clone(), cause })?;
    let tensors = SafeTensors::deserialize(&bytes).map_err(|error| wrong(error.to_string(), "a whole safetensors file".into()))?;
    let mut start = [0; 4];
    for attribute in Attribute::ALL {
        let name = attribute.name();
        let tensor = tensors.tensor(name).map_err(|_| wrong(format!("no tensor `{name}`"), "one".into()))?;
        let shape = [gaussians, attribute.width()];
        if tensor.dtype() != Dtype::F16 || tensor.shape() != shape {
            let found = format!("`{name}` of {} and shape {:?}", tensor.dtype(), tensor.shape());
            return Err(wrong(found, format!("F16 and {shape:?}, as in dataset.json")));
        }
        let data = tensor.data();
        if let Some(at) = data.chunks_exact(2).position(|pair| u16::from_le_bytes([pair[0], pair[1]]) & 0x7C00 == 0x7C00) {
            let gaussian = at / attribute.width();
            return Err(wrong(format!("NaN or infinity in `{name}` of Gaussian {gaussian}"), "finite numbers".into()));
        }
        start[attribute as usize] = data.as_ptr() as usize - bytes.as_ptr() as usize;
    }
    Ok(Mapped { bytes, start })
}
