//! The safetensors container: bytes go in, a checked document and its tensors come out. [`super::encode`] is the way back.

use super::deflate::{self, EXPANSION, EXPANSION_FREE, Kind};
use super::format::{Document, METADATA_KEY, Order, Tensor};
use super::{Fault, TensorInfo, clip};
use safetensors::Dtype;
use safetensors::tensor::Metadata;
use std::{collections::HashMap, ops::Range};

#[cfg(target_endian = "big")]
compile_error!("the files are little-endian, and so must the host be");

/// The longest header that is parsed, bytes. The largest avatar's is a tenth of it; parsing takes a multiple of it in memory.
pub const HEADER_MAX: usize = 256 << 10;

/// An opened container: its header, and the bytes of all tensors.
pub struct Container<'a> {
    metadata: Metadata,
    /// Of a file that is not whole yet, the beginning.
    data: &'a [u8],
    /// Names of tensors that are zeros, whatever the file has or will have.
    without: fn(&str) -> bool,
    /// Tensors that were deflated, and those that are zeros.
    expanded: HashMap<String, Vec<u8>>,
}

/// A tensor that a document calls for.
struct Called<'d, D: Document> {
    row: &'d Tensor<D, D::Model>,
    name: String,
    shape: Vec<usize>,
    /// How it is arranged, where it is deflated.
    order: Option<Order>,
}

impl<D: Document> Called<'_, D> {
    fn fault(&self, found: impl ToString, expected: impl ToString) -> Fault {
        Fault::Tensor { tensor: self.name.clone(), found: found.to_string(), expected: expected.to_string() }
    }

    /// Bytes, of which there may be none that a computer could count.
    fn bytes(&self) -> Option<usize> {
        self.shape.iter().try_fold(width(self.row.dtype), |bytes, &n| bytes.checked_mul(n))
    }

    fn kind(&self) -> Kind {
        kind(self.row.dtype, &self.shape)
    }
}

/// Bytes of a number.
pub fn width(dtype: Dtype) -> usize {
    dtype.bitsize() / 8
}

pub fn kind(dtype: Dtype, shape: &[usize]) -> Kind {
    Kind { width: width(dtype), columns: shape.iter().skip(1).product() }
}

/// All tensors that a document calls for.
fn called<D: Document>(document: &D) -> impl Iterator<Item = Called<'static, D>> {
    let rows = D::TENSORS.iter().flat_map(|row| (0..(row.count)(document)).map(move |k| (row, k)));
    rows.map(|(row, k)| {
        let name = row.name(k);
        let order = document.deflated().and_then(|deflated| deflated.get(&name)).copied();
        Called { row, shape: (row.shape)(document, k), name, order }
    })
}

/// A file's header where all of it is there, and where its tensors start; else how many bytes it takes.
pub fn header(bytes: &[u8]) -> Result<Result<(Metadata, usize), usize>, Fault> {
    let Some(first) = bytes.first_chunk::<8>() else { return Ok(Err(8)) };
    let length = usize::try_from(u64::from_le_bytes(*first)).unwrap_or(usize::MAX);
    if length > HEADER_MAX {
        let expected = format!("at most {HEADER_MAX}; this is no avatar or motion file");
        return Err(Fault::container(format!("a header of {length} bytes"), expected));
    }
    let Some(text) = bytes.get(8..8 + length) else { return Ok(Err(8 + length)) };
    let metadata = serde_json::from_slice(text);
    let metadata = metadata.map_err(|error| Fault::container(clip(&error.to_string()), "a safetensors header"))?;
    Ok(Ok((metadata, 8 + length)))
}

impl<'a> Container<'a> {
    fn open(bytes: &'a [u8]) -> Result<Self, Fault> {
        let container = Self::begin(bytes, |_| false)?;
        let (found, expected) = (container.data.len(), container.metadata.data_len());
        if expected != found {
            let complete = if found < expected { "; the file is incomplete" } else { "" };
            return Err(Fault::container(format!("{found} bytes of tensors"), format!("{expected} as the header says{complete}")));
        }
        Ok(container)
    }

    /// The beginning of a file, at least up to the last tensor that `without` does not name.
    fn begin(bytes: &'a [u8], without: fn(&str) -> bool) -> Result<Self, Fault> {
        let (metadata, start) = header(bytes)?.map_err(|needs| match bytes.len().checked_sub(8) {
            None => Fault::container(format!("a file of {} bytes", bytes.len()), "at least 8"),
            Some(rest) => {
                Fault::container(format!("a header cut off after {rest} bytes"), format!("{}; the file is incomplete", needs - 8))
            }
        })?;
        Ok(Self { metadata, data: &bytes[start..], without, expanded: HashMap::new() })
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
        let [first, last] = D::VERSIONS;
        if !(first..=last).contains(&tag.version) {
            let all = if first == last { format!("{first}, the only one") } else { format!("{first} or {last}, the only ones") };
            return Err(Fault::metadata("version", tag.version, all + " this program reads"));
        }
        let document: D = parse(text)?;
        document.check()?;
        Ok(document)
    }

    /// Where the file has what is under a name.
    fn place(&self, name: &str) -> Range<usize> {
        self.metadata.info(name).map_or(0..0, |info| info.data_offsets.0..info.data_offsets.1)
    }

    fn stored(&self, name: &str) -> &'a [u8] {
        self.data.get(self.place(name)).unwrap_or_default()
    }

    fn bytes(&self, name: &str) -> &[u8] {
        self.expanded.get(name).map_or_else(|| self.stored(name), Vec::as_slice)
    }

    /// A checked tensor's numbers; nothing where the file has none of this name.
    pub fn take<T: bytemuck::Pod>(&self, name: &str) -> Vec<T> {
        bytemuck::pod_collect_to_vec(self.bytes(name))
    }

    /// Holds every tensor that the document calls for against its row in the table, and expands those that are deflated.
    fn check<D: Document>(&mut self, document: &D) -> Result<(), Fault> {
        let all: Vec<Called<D>> = called(document).collect();
        all.iter().try_for_each(|called| self.check_shape(called))?;
        self.check_expansion(&all)?;
        for called in &all {
            let length = called.bytes().unwrap_or_default();
            if (self.without)(&called.name) {
                self.expanded.insert(called.name.clone(), vec![0; length]);
            } else if let Some(order) = called.order {
                let bytes = deflate::unpack(self.stored(&called.name), length, called.kind(), order)
                    .map_err(|found| called.fault(found, format!("{} of shape {:?}, {length} bytes", called.row.dtype, called.shape)))?;
                self.expanded.insert(called.name.clone(), bytes);
            }
            (called.row.rule)(document, self.bytes(&called.name))
                .map_err(|bad| called.fault(format!("{} at {:?}", bad.found, coordinates(bad.at, &called.shape)), bad.expected))?;
        }
        Ok(())
    }

    fn check_shape<D: Document>(&self, called: &Called<D>) -> Result<(), Fault> {
        let (dtype, shape) = match called.order {
            Some(_) => (Dtype::U8, vec![self.place(&called.name).len()]),
            None => (called.row.dtype, called.shape.clone()),
        };
        let info = self.metadata.info(&called.name);
        let info = info.ok_or_else(|| called.fault("nothing", format!("{} of shape {:?}", called.row.dtype, called.shape)))?;
        if info.dtype != dtype {
            return Err(called.fault(info.dtype, dtype));
        }
        if info.shape != shape {
            return Err(called.fault(format!("shape {}", clip(&format!("{:?}", info.shape))), format!("{shape:?}")));
        }
        let end = self.place(&called.name).end;
        if end > self.data.len() && !(self.without)(&called.name) {
            return Err(called.fault(format!("{} bytes of tensors", self.data.len()), format!("{end} at least")));
        }
        Ok(())
    }

    /// What is deflated stays within [`EXPANSION`] before any of it is expanded.
    fn check_expansion<D: Document>(&self, all: &[Called<D>]) -> Result<(), Fault> {
        let expanded = || all.iter().filter(|called| called.order.is_some());
        let length = expanded().try_fold(0usize, |sum, called| sum.checked_add(called.bytes()?)).unwrap_or(usize::MAX);
        let most = EXPANSION.saturating_mul(self.metadata.data_len()).saturating_add(EXPANSION_FREE);
        match expanded().max_by_key(|called| called.bytes()) {
            Some(largest) if length > most => {
                Err(largest.fault(format!("the largest of deflated tensors of {length} bytes"), format!("{most} bytes at most in all")))
            }
            _ => Ok(()),
        }
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
    build::<D>(Container::open(bytes)?)
}

/// The same of a file's beginning, which holds at least the tensors that `without` does not name: those that it names are zeros.
pub fn decode_without<D: Document>(bytes: &[u8], without: fn(&str) -> bool) -> Result<D::Model, Fault> {
    build::<D>(Container::begin(bytes, without)?)
}

fn build<D: Document>(mut container: Container) -> Result<D::Model, Fault> {
    let document: D = container.document()?;
    container.check(&document)?;
    Ok(document.build(&container))
}

/// What a file of a kind holds, as it stores it.
pub fn list<D: Document>(bytes: &[u8]) -> Result<Vec<TensorInfo>, Fault> {
    let mut container = Container::open(bytes)?;
    let document: D = container.document()?;
    container.check(&document)?;
    Ok(called(&document).map(|called| info(&called, container.stored(&called.name).len())).collect())
}

fn info<D: Document>(called: &Called<D>, stored: usize) -> TensorInfo {
    TensorInfo {
        name: called.name.clone(),
        dtype: called.row.dtype.to_string(),
        shape: called.shape.clone(),
        bytes: called.bytes().unwrap_or_default(),
        stored,
        deflated: called.order,
        what: called.row.what,
    }
}

/// What a model's plain file holds.
pub fn list_plain<D: Document>(model: &D::Model) -> Vec<TensorInfo> {
    called(&D::of(model)).map(|called| info(&called, called.bytes().unwrap_or_default())).collect()
}
