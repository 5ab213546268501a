//! The order of a file's tensors: the neutral avatar comes before its correctives and spherical
//! harmonics, so that a page can show it while the rest is loading, and levels of detail come last.

use super::{
    container::decode_beginning, error::FormatError, header::AvatarHeader, sets::LEVEL_PREFIX,
    tensors::HeaderProgress,
};
use crate::avatar::Avatar;
use safetensors::tensor::{Metadata, TensorInfo, TensorView};
use std::collections::HashMap;

/// What can be read from the beginning of a file.
#[derive(Clone, Debug, PartialEq)]
pub enum Neutral {
    /// Nothing yet: this many first bytes of the file are needed.
    Needs(usize),
    /// The avatar without its correctives, and with colours of degree 0 alone.
    Avatar(Box<Avatar>),
}

/// The purpose of a tensor, in the order of the file.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Purpose {
    Neutral,
    Corrective,
    Level,
}

fn purpose(name: &str) -> Purpose {
    if name.starts_with(LEVEL_PREFIX) {
        Purpose::Level
    } else if name == "sh"
        || name.starts_with("mlp.")
        || name.ends_with(".basis")
        || name.ends_with(".step")
    {
        Purpose::Corrective
    } else {
        Purpose::Neutral
    }
}

/// Serializes a safetensors file in the order of [`Purpose`]. Apart from that, tensors with larger
/// number types come first, which is the order of the safetensors library.
pub fn serialize(
    mut views: Vec<(String, TensorView)>,
    text: HashMap<String, String>,
) -> Result<Vec<u8>, FormatError> {
    let failed =
        |error: &dyn std::fmt::Display| FormatError::container(error, "tensors that fit a file");
    views.sort_by(|(a, left), (b, right)| {
        purpose(a)
            .cmp(&purpose(b))
            .then(right.dtype().cmp(&left.dtype()))
            .then_with(|| a.cmp(b))
    });
    let mut end = 0;
    let infos = views.iter().map(|(name, view)| {
        let start = end;
        end += view.data().len();
        (
            name.clone(),
            TensorInfo {
                dtype: view.dtype(),
                shape: view.shape().to_vec(),
                data_offsets: (start, end),
            },
        )
    });
    let metadata = Metadata::new(Some(text), infos.collect()).map_err(|error| failed(&error))?;
    let mut header = serde_json::to_vec(&metadata).map_err(|error| failed(&error))?;
    header.resize(header.len().next_multiple_of(8), b' ');
    let mut bytes = (header.len() as u64).to_le_bytes().to_vec();
    bytes.extend(header);
    for (_, view) in &views {
        bytes.extend(view.data());
    }
    Ok(bytes)
}

/// Where in the file the last tensor of the neutral avatar ends.
fn neutral_end(metadata: &Metadata, start: usize) -> usize {
    let tensors = metadata.tensors();
    let ends = tensors
        .iter()
        .filter(|(name, _)| purpose(name) == Purpose::Neutral)
        .map(|(_, info)| info.data_offsets.1);
    start.saturating_add(ends.max().unwrap_or(0))
}

/// How many bytes of a file are needed before the neutral avatar can be drawn, as far as its first
/// bytes tell.
pub fn needs(bytes: &[u8]) -> Result<usize, FormatError> {
    Ok(match HeaderProgress::parse(bytes)? {
        HeaderProgress::Complete { metadata, start } => neutral_end(&metadata, start),
        HeaderProgress::NeedsBytes(needed) => needed,
    })
}

/// The avatar in the first bytes of a file that is `length` bytes long, with zeros for its
/// correctives and spherical harmonics, and without levels.
pub fn neutral(bytes: &[u8], length: usize) -> Result<Neutral, FormatError> {
    let (metadata, start) = match HeaderProgress::parse(bytes)? {
        HeaderProgress::Complete { metadata, start } => (metadata, start),
        HeaderProgress::NeedsBytes(needed) => return Ok(Neutral::Needs(needed)),
    };
    if start.checked_add(metadata.data_len()) != Some(length) {
        let found = format!(
            "a header of {start} bytes for {} of tensors",
            metadata.data_len()
        );
        return Err(FormatError::container(
            found,
            format!("{length} bytes, as the server says"),
        ));
    }
    let end = neutral_end(&metadata, start);
    if bytes.len() < end {
        return Ok(Neutral::Needs(end));
    }
    let avatar = decode_beginning::<AvatarHeader>(bytes, |name| purpose(name) != Purpose::Neutral)?;
    Ok(Neutral::Avatar(Box::new(avatar)))
}
