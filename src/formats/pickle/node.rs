//! What a pickle builds: values that refer to one another by place.

use crate::npz::Element;

/// Where a value is in [`Arena`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ref(u32);

/// A value. Bytes and text stay where they are in the file.
#[derive(Debug)]
pub enum Node<'a> {
    None,
    Bool(bool),
    Int(i64),
    /// An integer of more than 64 bits.
    Long,
    Float(f64),
    Text(&'a str),
    Bytes(&'a [u8]),
    /// Bytes that the file holds as text.
    Decoded(Vec<u8>),
    List(Vec<Ref>),
    Tuple(Vec<Ref>),
    Dict(Vec<DictEntry>),
    Global(Global),
    /// A type of numbers; of Python's objects where it is None.
    Element(Option<Element>),
    /// An array that has no state yet.
    Empty,
    Array(Box<ArrayNode>),
    Storage(Box<Storage<'a>>),
    /// joblib's stand-in for an array that follows in the file.
    Stand,
    /// An object whose state is not looked at.
    Inert,
}

/// A key of a dictionary and its value.
#[derive(Clone, Copy, Debug)]
pub struct DictEntry {
    pub key: Ref,
    pub value: Ref,
}

/// Numbers, or objects, in an order.
#[derive(Clone, Debug)]
pub struct ArrayNode {
    /// None: objects.
    pub element: Option<Element>,
    pub shape: Vec<usize>,
    /// Elements between neighbours of each dimension.
    pub stride: Vec<usize>,
    /// Of the first element, elements from the start of the data.
    pub start: usize,
    /// Bytes, a storage or a list of objects.
    pub data: Ref,
}

/// Memory of a PyTorch tensor.
#[derive(Debug)]
pub struct Storage<'a> {
    pub key: &'a str,
    pub element: Element,
    /// None: not found yet.
    pub bytes: Option<&'a [u8]>,
}

/// What a pickle may name. Nothing else is built, and nothing is ever called.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Global {
    /// NumPy: an empty array, filled by the state that follows.
    Reconstruct,
    /// NumPy: an array over a buffer.
    FromBuffer,
    NdArray,
    Scalar,
    DType,
    /// A dictionary of any kind.
    Dict,
    /// A list or set.
    List,
    Tuple,
    ByteArray,
    /// Text to bytes, as protocol 2 of Python 3 writes bytes.
    Encode,
    /// joblib: an array that follows in the file.
    Wrapper,
    /// PyTorch: a tensor over a storage.
    Tensor,
    Parameter,
    /// PyTorch: a file in bytes.
    Load,
    StorageType(Element),
    /// PyTorch: a module or a tensor without memory, which nothing is asked of.
    Inert,
}

/// What a file held.
pub struct Built<'a> {
    pub nodes: Arena<'a>,
    pub root: Ref,
}

/// The values of a pickle.
#[derive(Debug)]
pub struct Arena<'a> {
    nodes: Vec<Node<'a>>,
    /// Bytes of the file.
    size: usize,
}

impl<'a> Arena<'a> {
    /// None yet. `size`: bytes of the file.
    pub fn new(size: usize) -> Self {
        Self {
            nodes: vec![],
            size,
        }
    }

    pub fn size(&self) -> usize {
        self.size
    }

    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    pub fn get(&self, at: Ref) -> &Node<'a> {
        &self.nodes[at.0 as usize]
    }

    pub fn get_mut(&mut self, at: Ref) -> &mut Node<'a> {
        &mut self.nodes[at.0 as usize]
    }

    /// The values from one on.
    pub fn since_mut(&mut self, first: usize) -> impl Iterator<Item = &mut Node<'a>> {
        self.nodes.iter_mut().skip(first)
    }

    /// Adds a value. There are fewer than 2^32: a machine counts them.
    pub fn push(&mut self, node: Node<'a>) -> Ref {
        self.nodes.push(node);
        Ref(self.nodes.len() as u32 - 1)
    }

    /// The bytes that a value is.
    pub fn bytes(&self, at: Ref) -> Option<&[u8]> {
        match self.get(at) {
            Node::Bytes(bytes) => Some(bytes),
            Node::Decoded(bytes) => Some(bytes),
            Node::Storage(storage) => storage.bytes,
            _ => None,
        }
    }

    /// The text that a value is; Python 2 wrote bytes.
    pub fn text(&self, at: Ref) -> Option<&str> {
        match self.get(at) {
            Node::Text(text) => Some(text),
            Node::Bytes(bytes) => std::str::from_utf8(bytes).ok(),
            _ => None,
        }
    }

    pub fn list(&self, at: Ref) -> Option<&[Ref]> {
        match self.get(at) {
            Node::List(items) | Node::Tuple(items) => Some(items),
            _ => None,
        }
    }

    /// The sizes that a tuple or a number says; None where one is negative, or there are more than
    /// NumPy's 64.
    pub fn sizes(&self, at: Ref) -> Option<Vec<usize>> {
        let size = |node: &Node| match node {
            Node::Int(size) => usize::try_from(*size).ok(),
            _ => None,
        };
        match self.get(at) {
            node @ Node::Int(_) => Some(vec![size(node)?]),
            _ => {
                let sizes = self.list(at).filter(|sizes| sizes.len() <= 64)?;
                sizes.iter().map(|&at| size(self.get(at))).collect()
            }
        }
    }
}
