//! Encoding of models into a file's bytes.

use super::container::{decode, kind, width};
use super::deflate::ByteArrangement;
use super::deflate::{self, EXPANSION, EXPANSION_FREE};
use super::document::{HeaderDocument, METADATA_KEY};
use super::error::FormatError;
use super::order;
use safetensors::{Dtype, tensor::TensorView};
use std::{
    borrow::Cow,
    collections::{BTreeMap, HashMap},
};

/// A tensor ready to be written.
struct EncodedTensor<'m> {
    name: String,
    dtype: Dtype,
    shape: Vec<usize>,
    bytes: Cow<'m, [u8]>,
}

/// Encodes a model into a file. The document decides how numbers are stored; `deflated`: whether
/// tensors are deflated where that makes them shorter.
///
/// # Errors
/// When the document breaks a rule, or the file would not read back as the model.
pub fn encode<D: HeaderDocument>(
    model: &D::Model,
    mut document: D,
    deflated: bool,
) -> Result<Vec<u8>, FormatError>
where
    D::Model: PartialEq,
{
    document.check()?;
    let mut orders = BTreeMap::new();
    let mut stored = Vec::new();
    let mut length = 0;
    for row in D::TENSORS {
        for k in 0..(row.count)(&document) {
            let name = row.name_of(k);
            let shape = (row.shape)(&document, k);
            let bytes = (row.bytes)(&document, model, k);
            length += bytes.len();
            let fits = shape.iter().product::<usize>() * width(row.dtype) == bytes.len();
            let packed = if deflated && fits {
                deflate::pack(&bytes, kind(row.dtype, &shape), useful(row.dtype))
            } else {
                None
            };
            stored.push(match packed {
                Some((order, packed)) => {
                    orders.insert(name.clone(), order);
                    EncodedTensor {
                        name,
                        dtype: Dtype::U8,
                        shape: vec![packed.len()],
                        bytes: Cow::Owned(packed),
                    }
                }
                None => EncodedTensor {
                    name,
                    dtype: row.dtype,
                    shape,
                    bytes,
                },
            });
        }
    }
    let encoded: usize = stored.iter().map(|tensor| tensor.bytes.len()).sum();
    if length > EXPANSION * encoded + EXPANSION_FREE {
        // Readers reject files that expand further.
        return encode(model, document, false);
    }
    if deflated {
        document.set_deflated(orders);
    }
    let bytes = write(&document, &stored)?;
    if decode::<D>(&bytes)? != *model {
        return Err(FormatError::container(
            "arrays that contradict each other",
            "lengths and widths that agree",
        ));
    }
    Ok(bytes)
}

/// The arrangements that may help: differences of codes or of floating-point numbers' bits have no
/// structure.
fn useful(dtype: Dtype) -> &'static [ByteArrangement] {
    match dtype {
        Dtype::U8 | Dtype::U16 | Dtype::U32 => &[ByteArrangement::Planes, ByteArrangement::Deltas],
        _ => &[ByteArrangement::Planes],
    }
}

/// Serializes a document and its tensors.
fn write<D: HeaderDocument>(
    document: &D,
    stored: &[EncodedTensor],
) -> Result<Vec<u8>, FormatError> {
    let mut views = Vec::new();
    for tensor in stored {
        let view = TensorView::new(tensor.dtype, tensor.shape.clone(), &tensor.bytes);
        let view = view.map_err(|_| FormatError::Tensor {
            tensor: tensor.name.clone(),
            found: format!("{} bytes", tensor.bytes.len()),
            expected: format!("{} of shape {:?}", tensor.dtype, tensor.shape),
        })?;
        views.push((tensor.name.clone(), view));
    }
    let text =
        serde_json::to_string(document).expect("strings and numbers always have a JSON form");
    let metadata = HashMap::from([(METADATA_KEY.to_owned(), text)]);
    order::serialize(views, metadata)
}
