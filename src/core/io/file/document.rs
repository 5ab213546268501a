//! The kinds of files: what a document and a table of tensors must provide.

use super::check::Bad;
use super::deflate::ByteArrangement;
use super::error::FormatError;
use super::sets;
use super::tensors::Tensors;
use safetensors::Dtype;
use serde::{Serialize, de::DeserializeOwned};
use std::{borrow::Cow, collections::BTreeMap};

/// Key of the document in the header's metadata.
pub const METADATA_KEY: &str = "effigy";

/// A kind of file: the document in its header, which decides which tensors the file has.
pub trait HeaderDocument: Serialize + DeserializeOwned + 'static {
    /// The type that a file of this kind is read into.
    type Model;
    /// `format` in the document.
    const FORMAT: &'static str;
    /// First and last version that can be read.
    const VERSIONS: [u64; 2];
    /// The table of tensors.
    const TENSORS: &'static [TensorRow<Self, Self::Model>];
    /// The document of a model that is stored without further coding.
    fn from_model(model: &Self::Model) -> Self;
    /// The tensors that are deflated, and how their bytes are arranged.
    fn deflated(&self) -> Option<&BTreeMap<String, ByteArrangement>> {
        None
    }
    /// Records the tensors that are deflated.
    fn set_deflated(&mut self, _: BTreeMap<String, ByteArrangement>) {}
    /// Leaves out what no reader of a file's beginning needs.
    fn shorten(&mut self) {}
    /// Checks the document itself; the tensors' shapes follow from it.
    fn check(&self) -> Result<(), FormatError>;
    /// Builds the model from tensors that passed their checks.
    fn build(self, tensors: &Tensors) -> Self::Model;
}

/// A row of a table of tensors: one tensor, or one for each layer or set of Gaussians.
pub struct TensorRow<H, M> {
    /// Name; `#` stands for the index of a layer, and `@` at the beginning for the prefix of a set
    /// of Gaussians.
    pub name: &'static str,
    /// Type of its numbers.
    pub dtype: Dtype,
    /// How many tensors there are: 0, 1, or one for each layer or set.
    pub count: fn(&H) -> usize,
    /// Shape of the k-th tensor.
    pub shape: fn(&H, usize) -> Vec<usize>,
    /// Checks the numbers in the k-th tensor's bytes.
    pub rule: fn(&H, usize, &[u8]) -> Result<(), Bad>,
    /// The k-th tensor's bytes, from a model.
    pub bytes: for<'a> fn(&H, &'a M, usize) -> Cow<'a, [u8]>,
    /// Meaning of the numbers.
    pub what: &'static str,
}

impl<H, M> TensorRow<H, M> {
    /// Name of the k-th tensor.
    pub fn name_of(&self, k: usize) -> String {
        match self.name.strip_prefix('@') {
            Some(name) => sets::prefix(k) + name,
            None => self.name.replace('#', &k.to_string()),
        }
    }
}
