//! The way to a file: a model and a document that says how its numbers are stored go in, bytes come out.

use super::container::{decode, kind, width};
use super::deflate::{self, EXPANSION, EXPANSION_FREE};
use super::format::{Document, METADATA_KEY, Order};
use super::{Fault, order};
use safetensors::{Dtype, tensor::TensorView};
use std::{
    borrow::Cow,
    collections::{BTreeMap, HashMap},
};

/// A tensor as it is written.
struct Stored<'m> {
    name: String,
    dtype: Dtype,
    shape: Vec<usize>,
    bytes: Cow<'m, [u8]>,
}

/// A model's file with a document that says how its numbers are stored; `deflated`: whether tensors are, where it makes them shorter. What
/// could not be read back as it was is refused.
pub fn encode<D: Document>(model: &D::Model, mut document: D, deflated: bool) -> Result<Vec<u8>, Fault>
where
    D::Model: PartialEq,
{
    document.check()?;
    let mut orders = BTreeMap::new();
    let mut stored = Vec::new();
    let mut length = 0;
    for row in D::TENSORS {
        for k in 0..(row.count)(&document) {
            let (name, shape, bytes) = (row.name(k), (row.shape)(&document, k), (row.bytes)(&document, model, k));
            length += bytes.len();
            let fits = shape.iter().product::<usize>() * width(row.dtype) == bytes.len();
            let packed = if deflated && fits { deflate::pack(&bytes, kind(row.dtype, &shape), useful(row.dtype)) } else { None };
            stored.push(match packed {
                Some((order, packed)) => {
                    orders.insert(name.clone(), order);
                    Stored { name, dtype: Dtype::U8, shape: vec![packed.len()], bytes: Cow::Owned(packed) }
                }
                None => Stored { name, dtype: row.dtype, shape, bytes },
            });
        }
    }
    let short: usize = stored.iter().map(|tensor| tensor.bytes.len()).sum();
    if length > EXPANSION * short + EXPANSION_FREE {
        // More than a reader would trust.
        return encode(model, document, false);
    }
    if deflated {
        document.set_deflated(orders);
    }
    let bytes = write(&document, &stored)?;
    if decode::<D>(&bytes)? != *model {
        return Err(Fault::container("arrays that contradict each other", "lengths and widths that agree"));
    }
    Ok(bytes)
}

/// The orders that may be worth it: differences of floating-point numbers' bits, and of codes, tell nothing.
fn useful(dtype: Dtype) -> &'static [Order] {
    match dtype {
        Dtype::U8 | Dtype::U16 | Dtype::U32 => &[Order::Planes, Order::Deltas],
        _ => &[Order::Planes],
    }
}

fn write<D: Document>(document: &D, stored: &[Stored]) -> Result<Vec<u8>, Fault> {
    let mut views = Vec::new();
    for Stored { name, dtype, shape, bytes } in stored {
        let view = TensorView::new(*dtype, shape.clone(), bytes).map_err(|_| Fault::Tensor {
            tensor: name.clone(),
            found: format!("{} bytes", bytes.len()),
            expected: format!("{dtype} of shape {shape:?}"),
        })?;
        views.push((name.clone(), view));
    }
    let text = serde_json::to_string(document).expect("strings and numbers always have a JSON form");
    let metadata = HashMap::from([(METADATA_KEY.to_owned(), text)]);
    order::serialize(views, metadata)
}
