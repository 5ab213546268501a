//! Opening of files: checks a document and its tensors, and decodes the model.
//! [`super::encode`] writes them.

use super::check::Bad;
use super::deflate::ByteArrangement;
use super::deflate::{self, EXPANSION, EXPANSION_FREE, NumberLayout};
use super::document::{HeaderDocument, METADATA_KEY, TensorRow};
use super::error::{FormatError, excerpt};
use super::tensors::{TensorInfo, Tensors};
use safetensors::Dtype;

/// A tensor that a document requires.
struct Required<'d, D: HeaderDocument> {
    row: &'d TensorRow<D, D::Model>,
    /// Which of the row's tensors it is.
    index: usize,
    name: String,
    shape: Vec<usize>,
    /// How its bytes are arranged; None if they are not deflated.
    order: Option<ByteArrangement>,
}

impl<D: HeaderDocument> Required<'_, D> {
    fn fault(&self, found: impl ToString, expected: impl ToString) -> FormatError {
        FormatError::Tensor {
            tensor: self.name.clone(),
            found: found.to_string(),
            expected: expected.to_string(),
        }
    }

    /// The number that breaks its rule.
    fn broken(&self, bad: Bad) -> FormatError {
        let at = coordinates(bad.at, &self.shape);
        self.fault(format!("{} at {at:?}", bad.found), bad.expected)
    }

    /// Bytes of its numbers; None if they overflow.
    fn bytes(&self) -> Option<usize> {
        self.shape
            .iter()
            .try_fold(width(self.row.dtype), |bytes, &n| bytes.checked_mul(n))
    }

    fn kind(&self) -> NumberLayout {
        kind(self.row.dtype, &self.shape)
    }

    /// Its entry in a list; `stored`: bytes that it takes in the file.
    fn info(&self, stored: usize) -> TensorInfo {
        TensorInfo {
            name: self.name.clone(),
            dtype: self.row.dtype.to_string(),
            shape: self.shape.clone(),
            bytes: self.bytes().unwrap_or_default(),
            stored,
            deflated: self.order,
            what: self.row.what,
        }
    }
}

/// Bytes of a number of a type.
pub fn width(dtype: Dtype) -> usize {
    dtype.bitsize() / 8
}

/// How a tensor's bytes divide into numbers and rows.
pub fn kind(dtype: Dtype, shape: &[usize]) -> NumberLayout {
    NumberLayout {
        width: width(dtype),
        columns: shape.iter().skip(1).product(),
    }
}

/// All tensors that a document requires.
fn required<D: HeaderDocument>(document: &D) -> impl Iterator<Item = Required<'static, D>> {
    let rows = D::TENSORS
        .iter()
        .flat_map(|row| (0..(row.count)(document)).map(move |k| (row, k)));
    rows.map(|(row, k)| {
        let name = row.name_of(k);
        let order = document
            .deflated()
            .and_then(|deflated| deflated.get(&name))
            .copied();
        Required {
            row,
            index: k,
            shape: (row.shape)(document, k),
            name,
            order,
        }
    })
}

/// A file whose tensors are checked against a document.
struct Container<'a> {
    tensors: Tensors<'a>,
    /// Names of tensors that are replaced by zeros, whether or not the file has them yet.
    zeroed: fn(&str) -> bool,
    /// Whether the document is shortened.
    shortened: bool,
}

impl Container<'_> {
    /// Parses and checks the document in the header.
    fn document<D: HeaderDocument>(&self) -> Result<D, FormatError> {
        let (tag, text) = tag(&self.tensors)?;
        if tag.format != D::FORMAT {
            return Err(FormatError::metadata(
                "format",
                format!("`{}`", excerpt(&tag.format)),
                format!("`{}`", D::FORMAT),
            ));
        }
        let [first, last] = D::VERSIONS;
        if !(first..=last).contains(&tag.version) {
            let all = if first == last {
                format!("{first}, the only one")
            } else {
                format!("{first} to {last}, the only ones")
            };
            return Err(FormatError::metadata(
                "version",
                tag.version,
                all + " this program reads",
            ));
        }
        let document: D = parse(text)?;
        document.check()?;
        Ok(document)
    }

    /// Checks every tensor that the document requires against its row in the table, and expands
    /// those that are deflated.
    fn check<D: HeaderDocument>(&mut self, document: &D) -> Result<(), FormatError> {
        let all: Vec<Required<D>> = required(document).collect();
        for tensor in &all {
            self.check_shape(tensor)?;
        }
        self.check_expansion(&all)?;
        for tensor in &all {
            let length = tensor.bytes().unwrap_or_default();
            if (self.zeroed)(&tensor.name) {
                let zeros = vec![0; length];
                self.tensors.expanded.insert(tensor.name.clone(), zeros);
            } else if let Some(order) = tensor.order {
                let stored = self.tensors.stored(&tensor.name);
                let bytes =
                    deflate::unpack(stored, length, tensor.kind(), order).map_err(|found| {
                        let expected = format!(
                            "{} of shape {:?}, {length} bytes",
                            tensor.row.dtype, tensor.shape
                        );
                        tensor.fault(found, expected)
                    })?;
                self.tensors.expanded.insert(tensor.name.clone(), bytes);
            }
            (tensor.row.rule)(document, tensor.index, self.tensors.bytes(&tensor.name))
                .map_err(|bad| tensor.broken(bad))?;
        }
        Ok(())
    }

    /// Checks that the file has a tensor, with its type, its shape and all its bytes.
    fn check_shape<D: HeaderDocument>(&self, tensor: &Required<D>) -> Result<(), FormatError> {
        let (dtype, shape) = match tensor.order {
            Some(_) => (Dtype::U8, vec![self.tensors.place(&tensor.name).len()]),
            None => (tensor.row.dtype, tensor.shape.clone()),
        };
        let Some(info) = self.tensors.metadata.info(&tensor.name) else {
            let expected = format!("{} of shape {:?}", tensor.row.dtype, tensor.shape);
            return Err(tensor.fault("nothing", expected));
        };
        if info.dtype != dtype {
            return Err(tensor.fault(info.dtype, dtype));
        }
        if info.shape != shape {
            return Err(tensor.fault(
                format!("shape {}", excerpt(&format!("{:?}", info.shape))),
                format!("{shape:?}"),
            ));
        }
        let end = self.tensors.place(&tensor.name).end;
        if end > self.tensors.data.len() && !(self.zeroed)(&tensor.name) {
            return Err(tensor.fault(
                format!("{} bytes of tensors", self.tensors.data.len()),
                format!("{end} at least"),
            ));
        }
        Ok(())
    }

    /// Checks that deflated tensors stay within [`EXPANSION`] before any of them is expanded.
    fn check_expansion<D: HeaderDocument>(&self, all: &[Required<D>]) -> Result<(), FormatError> {
        let deflated = || all.iter().filter(|tensor| tensor.order.is_some());
        let length = deflated()
            .try_fold(0usize, |sum, tensor| sum.checked_add(tensor.bytes()?))
            .unwrap_or(usize::MAX);
        let max = EXPANSION
            .saturating_mul(self.tensors.metadata.data_len())
            .saturating_add(EXPANSION_FREE);
        match deflated().max_by_key(|tensor| tensor.bytes()) {
            Some(largest) if length > max => Err(largest.fault(
                format!("the largest of deflated tensors of {length} bytes"),
                format!("{max} bytes at most in all"),
            )),
            _ => Ok(()),
        }
    }

    /// The document and the model of a file.
    fn decode<D: HeaderDocument>(mut self) -> Result<D::Model, FormatError> {
        let mut document: D = self.document()?;
        if self.shortened {
            document.shorten();
        }
        self.check(&document)?;
        Ok(document.build(&self.tensors))
    }
}

/// The fields of a document that tell which kind of file it is.
#[derive(serde::Deserialize)]
struct Tag {
    format: String,
    version: u64,
}

fn parse<T: serde::de::DeserializeOwned>(text: &str) -> Result<T, FormatError> {
    let failed = |error: serde_json::Error| {
        FormatError::metadata(
            METADATA_KEY,
            excerpt(&error.to_string()),
            "a document as version 1 has it",
        )
    };
    serde_json::from_str(text).map_err(failed)
}

/// The document in the header: its kind, and its text.
fn tag<'t>(tensors: &'t Tensors) -> Result<(Tag, &'t str), FormatError> {
    let metadata = tensors.metadata.metadata().as_ref();
    let Some(text) = metadata.and_then(|map| map.get(METADATA_KEY)) else {
        return Err(FormatError::metadata(
            METADATA_KEY,
            "nothing",
            "the document of an avatar or motion file",
        ));
    };
    Ok((parse(text)?, text))
}

/// Index of an element along each axis of a shape.
fn coordinates(index: usize, shape: &[usize]) -> Vec<usize> {
    let mut coordinates = vec![0; shape.len()];
    let mut rest = index;
    for (coordinate, &side) in coordinates.iter_mut().zip(shape).rev() {
        *coordinate = rest % side.max(1);
        rest /= side.max(1);
    }
    coordinates
}

/// Whether a file says that it is of a kind.
pub fn has_format<D: HeaderDocument>(bytes: &[u8]) -> Result<bool, FormatError> {
    let tensors = Tensors::open(bytes)?;
    let (tag, _) = tag(&tensors)?;
    Ok(tag.format == D::FORMAT)
}

/// Decodes the model in a file's bytes.
pub fn decode<D: HeaderDocument>(bytes: &[u8]) -> Result<D::Model, FormatError> {
    let container = Container {
        tensors: Tensors::open(bytes)?,
        zeroed: |_| false,
        shortened: false,
    };
    container.decode::<D>()
}

/// Decodes the model in a file's beginning, with a shortened document. Tensors that `zeroed` names
/// are replaced by zeros; all others must be there.
pub fn decode_beginning<D: HeaderDocument>(
    bytes: &[u8],
    zeroed: fn(&str) -> bool,
) -> Result<D::Model, FormatError> {
    let container = Container {
        tensors: Tensors::open_beginning(bytes)?,
        zeroed,
        shortened: true,
    };
    container.decode::<D>()
}

/// Checks a model's arrays as those of its plain file would be: their lengths and their numbers.
pub fn check_arrays<D: HeaderDocument>(document: &D, model: &D::Model) -> Result<(), FormatError> {
    for row in D::TENSORS {
        for k in 0..(row.count)(document) {
            let tensor: Required<D> = Required {
                row,
                index: k,
                name: row.name_of(k),
                shape: (row.shape)(document, k),
                order: None,
            };
            let bytes = (row.bytes)(document, model, k);
            if tensor.bytes() != Some(bytes.len()) {
                let expected = format!("{} of shape {:?}", row.dtype, tensor.shape);
                return Err(tensor.fault(format!("{} bytes", bytes.len()), expected));
            }
            (row.rule)(document, k, &bytes).map_err(|bad| tensor.broken(bad))?;
        }
    }
    Ok(())
}

/// Lists the tensors of a file of a kind.
pub fn list<D: HeaderDocument>(bytes: &[u8]) -> Result<Vec<TensorInfo>, FormatError> {
    let mut container = Container {
        tensors: Tensors::open(bytes)?,
        zeroed: |_| false,
        shortened: false,
    };
    let document: D = container.document()?;
    container.check(&document)?;
    Ok(required(&document)
        .map(|tensor| tensor.info(container.tensors.stored(&tensor.name).len()))
        .collect())
}

/// Lists the tensors of a model's plain file.
pub fn list_plain<D: HeaderDocument>(model: &D::Model) -> Vec<TensorInfo> {
    required(&D::from_model(model))
        .map(|tensor| tensor.info(tensor.bytes().unwrap_or_default()))
        .collect()
}
