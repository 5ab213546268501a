//! The order of a file's tensors: what an avatar can be drawn with at first stands before its correctives, so that a page shows it
//! while the rest still comes.

use super::{Fault, container, format::AvatarHeader};
use crate::avatar::Avatar;
use safetensors::tensor::{Metadata, TensorInfo, TensorView};
use std::collections::HashMap;

/// What the beginning of a file is enough for.
#[derive(Clone, Debug, PartialEq)]
pub enum Neutral {
    /// So many bytes of the file are needed.
    Needs(usize),
    Avatar(Box<Avatar>),
}

/// Whether a tensor only says how an avatar departs from its neutral look.
fn is_corrective(name: &str) -> bool {
    name.starts_with("mlp.") || name.ends_with(".basis") || name.ends_with(".step")
}

/// A safetensors file whose tensors are in that order; else larger numbers come first, as they do with the library's own writer.
pub fn serialize(mut views: Vec<(String, TensorView)>, text: HashMap<String, String>) -> Result<Vec<u8>, Fault> {
    let failed = |error: &dyn std::fmt::Display| Fault::container(error, "tensors that fit a file");
    views.sort_by(|(a, left), (b, right)| {
        is_corrective(a).cmp(&is_corrective(b)).then(right.dtype().cmp(&left.dtype())).then_with(|| a.cmp(b))
    });
    let mut end = 0;
    let infos = views.iter().map(|(name, view)| {
        let start = end;
        end += view.data().len();
        (name.clone(), TensorInfo { dtype: view.dtype(), shape: view.shape().to_vec(), data_offsets: (start, end) })
    });
    let metadata = Metadata::new(Some(text), infos.collect()).map_err(|error| failed(&error))?;
    let mut header = serde_json::to_vec(&metadata).map_err(|error| failed(&error))?;
    header.resize(header.len().next_multiple_of(8), b' ');
    let mut bytes = (header.len() as u64).to_le_bytes().to_vec();
    bytes.extend(header);
    views.iter().for_each(|(_, view)| bytes.extend(view.data()));
    Ok(bytes)
}

/// Where the last tensor ends that is no corrective.
fn neutral_end(metadata: &Metadata, start: usize) -> usize {
    let tensors = metadata.tensors();
    let ends = tensors.iter().filter(|(name, _)| !is_corrective(name)).map(|(_, info)| info.data_offsets.1);
    start.saturating_add(ends.max().unwrap_or(0))
}

/// How many bytes of a file are needed before anything of it can be drawn, as far as its first bytes tell.
pub fn needs(bytes: &[u8]) -> Result<usize, Fault> {
    Ok(container::header(bytes)?.map_or_else(|needs| needs, |(metadata, start)| neutral_end(&metadata, start)))
}

/// The avatar that the first bytes of a file of `length` hold, with zeros for its correctives.
pub fn neutral(bytes: &[u8], length: usize) -> Result<Neutral, Fault> {
    let (metadata, start) = match container::header(bytes)? {
        Ok(header) => header,
        Err(needs) => return Ok(Neutral::Needs(needs)),
    };
    if start.checked_add(metadata.data_len()) != Some(length) {
        let found = format!("a header of {start} bytes for {} of tensors", metadata.data_len());
        return Err(Fault::container(found, format!("{length} bytes, as the server says")));
    }
    let end = neutral_end(&metadata, start);
    if bytes.len() < end {
        return Ok(Neutral::Needs(end));
    }
    container::decode_without::<AvatarHeader>(bytes, is_corrective).map(|avatar| Neutral::Avatar(Box::new(avatar)))
}
