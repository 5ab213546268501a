//! The safetensors container: bytes go in, a checked document and its tensors come out, and the way back.

use super::format::{Document, METADATA_KEY, VERSION};
use super::{Fault, TensorInfo, clip};
use safetensors::tensor::{Metadata, TensorView};
use std::collections::HashMap;

#[cfg(target_endian = "big")]
compile_error!("the files are little-endian, and so must the host be");

/// The longest header that is parsed, bytes. The largest avatar's is a tenth of it; parsing takes a multiple of it in memory.
pub const HEADER_MAX: usize = 256 << 10;

/// An opened container: its header, and the bytes of all tensors.
pub struct Container<'a> {
    metadata: Metadata,
    data: &'a [u8],
}

impl<'a> Container<'a> {
    fn open(bytes: &'a [u8]) -> Result<Self, Fault> {
        let (length, rest) =
            bytes.split_first_chunk::<8>().ok_or_else(|| Fault::container(format!("a file of {} bytes", bytes.len()), "at least 8"))?;
        let length = usize::try_from(u64::from_le_bytes(*length)).unwrap_or(usize::MAX);
        if length > HEADER_MAX {
            return Err(Fault::container(
                format!("a header of {length} bytes"),
                format!("at most {HEADER_MAX}; this is no avatar or motion file"),
            ));
        }
        let (header, data) = rest.split_at_checked(length).ok_or_else(|| {
            Fault::container(format!("a header cut off after {} bytes", rest.len()), format!("{length}; the file is incomplete"))
        })?;
        let metadata: Metadata =
            serde_json::from_slice(header).map_err(|error| Fault::container(clip(&error.to_string()), "a safetensors header"))?;
        if metadata.data_len() != data.len() {
            let found = format!("{} bytes of tensors", data.len());
            let complete = if data.len() < metadata.data_len() { "; the file is incomplete" } else { "" };
            return Err(Fault::container(found, format!("{} as the header says{complete}", metadata.data_len())));
        }
        Ok(Self { metadata, data })
    }

    /// Our document in the header: what it says it is, and its text.
    fn tag(&self) -> Result<(Tag, &str), Fault> {
        let metadata = self.metadata.metadata().as_ref().and_then(|map| map.get(METADATA_KEY));
        let text = metadata.ok_or_else(|| Fault::metadata(METADATA_KEY, "nothing", "the document of an avatar or motion file"))?;
        Ok((parse(text)?, text))
    }

    /// The same, parsed and checked.
    fn document<D: Document>(&self) -> Result<D, Fault> {
        let (tag, text) = self.tag()?;
        if tag.format != D::FORMAT {
            return Err(Fault::metadata("format", format!("`{}`", clip(&tag.format)), format!("`{}`", D::FORMAT)));
        }
        if tag.version != VERSION {
            return Err(Fault::metadata("version", tag.version, format!("{VERSION}, the only one this program reads")));
        }
        let document: D = parse(text)?;
        document.check()?;
        Ok(document)
    }

    fn bytes(&self, name: &str) -> &'a [u8] {
        self.metadata.info(name).map_or(&[], |info| &self.data[info.data_offsets.0..info.data_offsets.1])
    }

    /// A checked tensor's numbers; nothing where the file has none of this name.
    pub fn take<T: bytemuck::Pod>(&self, name: &str) -> Vec<T> {
        bytemuck::pod_collect_to_vec(self.bytes(name))
    }

    /// Holds every tensor that the document calls for against its row in the table.
    fn check<D: Document>(&self, document: &D) -> Result<(), Fault> {
        for row in D::TENSORS {
            for k in 0..(row.count)(document) {
                let name = row.name(k);
                let fault = |found: String, expected: String| Fault::Tensor { tensor: name.clone(), found, expected };
                let (dtype, shape) = (row.dtype, (row.shape)(document, k));
                let info = self.metadata.info(&name).ok_or_else(|| fault("nothing".into(), format!("{dtype} of shape {shape:?}")))?;
                if info.dtype != dtype {
                    return Err(fault(info.dtype.to_string(), dtype.to_string()));
                }
                if info.shape != shape {
                    return Err(fault(format!("shape {}", clip(&format!("{:?}", info.shape))), format!("{shape:?}")));
                }
                (row.rule)(document, self.bytes(&name))
                    .map_err(|bad| fault(format!("{} at {:?}", bad.found, coordinates(bad.at, &shape)), bad.expected))?;
            }
        }
        Ok(())
    }
}

#[derive(serde::Deserialize)]
struct Tag {
    format: String,
    version: u64,
}

fn parse<T: serde::de::DeserializeOwned>(text: &str) -> Result<T, Fault> {
    let failed = |error: serde_json::Error| Fault::metadata(METADATA_KEY, clip(&error.to_string()), "a document as version 1 has it");
    serde_json::from_str(text).map_err(failed)
}

/// Index of an element along each axis.
fn coordinates(mut at: usize, shape: &[usize]) -> Vec<usize> {
    let mut along: Vec<usize> = shape.iter().rev().map(|&n| (at % n.max(1), at /= n.max(1)).0).collect();
    along.reverse();
    along
}

/// Whether a file says that it is of a kind.
pub fn is_of<D: Document>(bytes: &[u8]) -> Result<bool, Fault> {
    Ok(Container::open(bytes)?.tag()?.0.format == D::FORMAT)
}

/// The model in a file's bytes.
pub fn decode<D: Document>(bytes: &[u8]) -> Result<D::Model, Fault> {
    let container = Container::open(bytes)?;
    let document: D = container.document()?;
    container.check(&document)?;
    Ok(document.build(&container))
}

/// A model's file. What could not be read back as it was is refused.
pub fn encode<D: Document>(model: &D::Model) -> Result<Vec<u8>, Fault>
where
    D::Model: PartialEq,
{
    let document = D::of(model);
    document.check()?;
    let mut views = Vec::new();
    for row in D::TENSORS {
        for k in 0..(row.count)(&document) {
            let (name, shape, bytes) = (row.name(k), (row.shape)(&document, k), (row.bytes)(model, k));
            let view = TensorView::new(row.dtype, shape.clone(), bytes).map_err(|_| Fault::Tensor {
                tensor: name.clone(),
                found: format!("{} bytes", bytes.len()),
                expected: format!("{} of shape {shape:?}", row.dtype),
            })?;
            views.push((name, view));
        }
    }
    let text = serde_json::to_string(&document).expect("strings and numbers always have a JSON form");
    let metadata = HashMap::from([(METADATA_KEY.to_owned(), text)]);
    let bytes = super::order::serialize(views, metadata)?;
    if decode::<D>(&bytes)? != *model {
        return Err(Fault::container("arrays that contradict each other", "lengths and widths that agree"));
    }
    Ok(bytes)
}

/// What a model's file holds.
pub fn list<D: Document>(model: &D::Model) -> Vec<TensorInfo> {
    let document = D::of(model);
    let rows = D::TENSORS.iter().flat_map(|row| (0..(row.count)(&document)).map(move |k| (row, k)));
    rows.map(|(row, k)| TensorInfo {
        name: row.name(k),
        dtype: row.dtype.to_string(),
        shape: (row.shape)(&document, k),
        bytes: (row.bytes)(model, k).len(),
        what: row.what,
    })
    .collect()
}
