//! The stack machine of pickles (PEP 3154, PEP 574 and the module `pickletools`, which lists every
//! opcode). It builds values of a few types and calls nothing. Opcodes that protocols 2 and later
//! never write are left out, as text in Python's own spelling.

use super::{
    globals::global,
    node::{Arena, ArrayNode, DictEntry, Global, Node, Ref, Storage},
};
use crate::npz::Element;
use effigy_core::io::file::{FormatError, excerpt};
use std::collections::BTreeMap;

/// Values that any pickle may have; larger files may have one in [`BYTES_A_VALUE`].
const MIN_VALUES: usize = 1 << 19;
const BYTES_A_VALUE: usize = 48;
/// Values that an array counts for, for the memory that it takes.
const ARRAY_VALUES: usize = 4;
/// What any pickle may push or remember; larger files may do so once in [`BYTES_A_PUSH`].
const MIN_PUSHES: usize = 1 << 21;
const BYTES_A_PUSH: usize = 16;
/// Pickles inside pickles: PyTorch's in joblib's or NumPy's, and arrays of objects.
const MAX_DEPTH: usize = 4;

/// Builds values of one file.
pub struct Machine<'a> {
    pub nodes: Arena<'a>,
    /// Where memory of tensors is; empty where it follows the pickle.
    storages: BTreeMap<String, &'a [u8]>,
    values_left: usize,
    pushes_left: usize,
    /// Bytes that may still be decoded from text.
    decoded_left: usize,
}

/// A pickle that was read.
pub struct Unpickled {
    pub root: Ref,
    /// Where it ends in its bytes.
    pub end: usize,
}

fn fault(found: impl ToString, expected: impl ToString) -> FormatError {
    FormatError::container(
        format!("{} in a pickle", found.to_string()),
        expected.to_string(),
    )
}

fn cut() -> FormatError {
    fault("an end inside a value", "a whole pickle")
}

/// The bytes of a pickle, read from the front.
struct Input<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl<'a> Input<'a> {
    fn take(&mut self, count: u64) -> Result<&'a [u8], FormatError> {
        let rest = &self.bytes[self.at..];
        let count = usize::try_from(count).map_err(|_| cut())?;
        let taken = rest.get(..count).ok_or_else(cut)?;
        self.at += count;
        Ok(taken)
    }

    /// An integer of up to eight bytes, little-endian.
    fn number(&mut self, size: u64) -> Result<u64, FormatError> {
        let bytes = self.take(size)?;
        Ok(bytes
            .iter()
            .rev()
            .fold(0, |sum, &byte| sum << 8 | u64::from(byte)))
    }

    fn counted(&mut self, size: u64) -> Result<&'a [u8], FormatError> {
        let count = self.number(size)?;
        self.take(count)
    }

    fn text(&mut self, size: u64) -> Result<&'a str, FormatError> {
        let bytes = self.counted(size)?;
        // Python writes lone surrogates, which are no UTF-8; no name that matters has one.
        Ok(std::str::from_utf8(bytes).unwrap_or("\u{fffd}"))
    }

    fn line(&mut self) -> Result<&'a str, FormatError> {
        let rest = &self.bytes[self.at..];
        let end = rest.iter().position(|&byte| byte == b'\n');
        let line = &rest[..end.ok_or_else(cut)?];
        self.at += line.len() + 1;
        std::str::from_utf8(line).map_err(|_| fault("a line that is no text", "text"))
    }
}

/// The stack and memo of one pickle.
#[derive(Default)]
struct Stack {
    stack: Vec<Ref>,
    /// Heights of the stack at each mark.
    marks: Vec<usize>,
    memo: Vec<Option<Ref>>,
    /// Places of the memo that were filled.
    filled: usize,
}

impl Stack {
    fn pop(&mut self) -> Result<Ref, FormatError> {
        let floor = self.marks.last().copied().unwrap_or_default();
        if self.stack.len() <= floor {
            return Err(fault("an empty stack", "a value to take"));
        }
        self.stack.pop().ok_or_else(cut)
    }

    fn top(&self) -> Result<Ref, FormatError> {
        let top = self.stack.last().copied();
        top.ok_or_else(|| fault("an empty stack", "a value to take"))
    }

    fn above_mark(&mut self) -> Result<Vec<Ref>, FormatError> {
        let mark = self.marks.pop();
        let mark = mark.ok_or_else(|| fault("no mark", "a mark on the stack"))?;
        Ok(self.stack.split_off(mark.min(self.stack.len())))
    }
}

impl<'a> Machine<'a> {
    /// `size`: bytes of the file, from which limits follow.
    pub fn new(size: usize, storages: BTreeMap<String, &'a [u8]>) -> Self {
        Self {
            nodes: Arena::new(size),
            storages,
            values_left: (size / BYTES_A_VALUE)
                .max(MIN_VALUES)
                .min(u32::MAX as usize),
            pushes_left: (size / BYTES_A_PUSH).max(MIN_PUSHES),
            decoded_left: 2 * size,
        }
    }

    /// Reads one pickle. `depth`: how many it is in.
    pub fn run(
        &mut self,
        bytes: &'a [u8],
        start: usize,
        depth: usize,
    ) -> Result<Unpickled, FormatError> {
        if depth >= MAX_DEPTH {
            return Err(fault(
                format!("a pickle in {MAX_DEPTH} others"),
                "fewer layers",
            ));
        }
        let mut input = Input { bytes, at: start };
        let mut frame = Stack::default();
        loop {
            let opcode = input.take(1)?[0];
            if opcode == b'.' {
                return Ok(Unpickled {
                    root: frame.pop()?,
                    end: input.at,
                });
            }
            self.step(opcode, &mut input, &mut frame, depth)?;
        }
    }

    fn add(&mut self, node: Node<'a>) -> Result<Ref, FormatError> {
        self.spend(1)?;
        Ok(self.nodes.push(node))
    }

    /// Counts values.
    fn spend(&mut self, values: usize) -> Result<(), FormatError> {
        let left = self.values_left.checked_sub(values);
        let many = || fault("more values than its size allows", "fewer");
        self.values_left = left.ok_or_else(many)?;
        Ok(())
    }

    /// Counts what is pushed or remembered.
    fn pay(&mut self, items: usize) -> Result<(), FormatError> {
        let left = self.pushes_left.checked_sub(items);
        self.pushes_left = left.ok_or_else(|| fault("more steps than its size allows", "fewer"))?;
        Ok(())
    }

    /// Counts an array, which takes more memory than other values.
    fn array(&mut self, array: ArrayNode) -> Result<Node<'a>, FormatError> {
        self.spend(ARRAY_VALUES + array.shape.len())?;
        Ok(Node::Array(Box::new(array)))
    }

    fn push(&mut self, frame: &mut Stack, at: Ref) -> Result<(), FormatError> {
        self.pay(1)?;
        frame.stack.push(at);
        Ok(())
    }

    fn push_new(&mut self, frame: &mut Stack, node: Node<'a>) -> Result<(), FormatError> {
        let at = self.add(node)?;
        self.push(frame, at)
    }

    fn step(
        &mut self,
        opcode: u8,
        input: &mut Input<'a>,
        frame: &mut Stack,
        depth: usize,
    ) -> Result<(), FormatError> {
        match opcode {
            // Protocol and frames say nothing that is needed.
            0x80 => drop(input.take(1)?),
            0x95 => drop(input.take(8)?),
            b'(' => {
                // A mark takes no more than a value would.
                self.pay(1)?;
                frame.marks.push(frame.stack.len());
            }
            b'0' => match frame.pop() {
                Ok(_) => {}
                // A mark that nothing stands on is taken instead.
                Err(error) => drop(frame.marks.pop().ok_or(error)?),
            },
            b'1' => drop(frame.above_mark()?),
            b'2' => {
                let top = frame.top()?;
                self.push(frame, top)?;
            }
            b'N' => self.push_new(frame, Node::None)?,
            0x88 => self.push_new(frame, Node::Bool(true))?,
            0x89 => self.push_new(frame, Node::Bool(false))?,
            b'J' => {
                let number = input.number(4)? as u32 as i32;
                self.push_new(frame, Node::Int(number.into()))?;
            }
            b'K' | b'M' => {
                let number = input.number(if opcode == b'K' { 1 } else { 2 })?;
                self.push_new(frame, Node::Int(number as i64))?;
            }
            0x8a | 0x8b => {
                let bytes = input.counted(if opcode == 0x8a { 1 } else { 4 })?;
                self.push_new(frame, long(bytes))?;
            }
            b'G' => {
                let number = input.number(8)?.swap_bytes();
                self.push_new(frame, Node::Float(f64::from_bits(number)))?;
            }
            b'U' | b'C' => {
                let bytes = input.counted(1)?;
                self.push_new(frame, Node::Bytes(bytes))?;
            }
            b'T' | b'B' => {
                let bytes = input.counted(4)?;
                self.push_new(frame, Node::Bytes(bytes))?;
            }
            0x8e | 0x96 => {
                let bytes = input.counted(8)?;
                self.push_new(frame, Node::Bytes(bytes))?;
            }
            0x8c | b'X' | 0x8d => {
                let text = input.text(match opcode {
                    0x8c => 1,
                    b'X' => 4,
                    _ => 8,
                })?;
                self.push_new(frame, Node::Text(text))?;
            }
            b']' | 0x8f => self.push_new(frame, Node::List(vec![]))?,
            b')' => self.push_new(frame, Node::Tuple(vec![]))?,
            b'}' => self.push_new(frame, Node::Dict(vec![]))?,
            b'l' | 0x91 => {
                let items = frame.above_mark()?;
                self.push_new(frame, Node::List(items))?;
            }
            b't' => {
                let items = frame.above_mark()?;
                self.push_new(frame, Node::Tuple(items))?;
            }
            0x85..=0x87 => {
                let count = usize::from(opcode - 0x84);
                let mut items = vec![];
                for _ in 0..count {
                    items.push(frame.pop()?);
                }
                items.reverse();
                self.push_new(frame, Node::Tuple(items))?;
            }
            b'd' => {
                let items = frame.above_mark()?;
                self.push_new(frame, Node::Dict(entries(&items)?))?;
            }
            b'a' => {
                let item = frame.pop()?;
                self.extend(frame.top()?, &[item])?;
            }
            b'e' | 0x90 => {
                let items = frame.above_mark()?;
                self.extend(frame.top()?, &items)?;
            }
            b's' => {
                let value = frame.pop()?;
                let key = frame.pop()?;
                self.set(frame.top()?, vec![DictEntry { key, value }])?;
            }
            b'u' => {
                let items = frame.above_mark()?;
                self.set(frame.top()?, entries(&items)?)?;
            }
            b'q' => {
                let place = input.number(1)?;
                self.remember(frame, place)?;
            }
            b'r' => {
                let place = input.number(4)?;
                self.remember(frame, place)?;
            }
            0x94 => self.remember(frame, frame.filled as u64)?,
            b'h' => {
                let place = input.number(1)?;
                self.recall(frame, place)?;
            }
            b'j' => {
                let place = input.number(4)?;
                self.recall(frame, place)?;
            }
            b'c' => {
                let module = input.line()?;
                let name = input.line()?;
                self.push_new(frame, Node::Global(named(module, name)?))?;
            }
            0x93 => {
                let name = frame.pop()?;
                let module = frame.pop()?;
                let (Some(module), Some(name)) = (self.nodes.text(module), self.nodes.text(name))
                else {
                    return Err(fault("a name that is no text", "a module and a name"));
                };
                let global = named(module, name)?;
                self.push_new(frame, Node::Global(global))?;
            }
            b'R' | 0x81 => {
                let arguments = frame.pop()?;
                let callee = frame.pop()?;
                let built = self.build(callee, arguments, depth)?;
                self.push(frame, built)?;
            }
            b'b' => {
                let state = frame.pop()?;
                let target = frame.top()?;
                self.fill(target, state, input, depth)?;
            }
            b'Q' => {
                let id = frame.pop()?;
                let storage = self.storage(id)?;
                self.push_new(frame, storage)?;
            }
            _ => {
                return Err(fault(
                    format!("the opcode {opcode:#04x}"),
                    "what protocols 2 to 5 write of containers, numbers, text and arrays",
                ));
            }
        }
        Ok(())
    }

    fn extend(&mut self, target: Ref, items: &[Ref]) -> Result<(), FormatError> {
        let Node::List(list) = self.nodes.get_mut(target) else {
            return Err(fault("items for something else", "a list for items"));
        };
        list.extend(items);
        Ok(())
    }

    fn set(&mut self, target: Ref, entries: Vec<DictEntry>) -> Result<(), FormatError> {
        let Node::Dict(dict) = self.nodes.get_mut(target) else {
            return Err(fault(
                "entries for something else",
                "a dictionary for entries",
            ));
        };
        dict.extend(entries);
        Ok(())
    }

    fn remember(&mut self, frame: &mut Stack, place: u64) -> Result<(), FormatError> {
        let top = frame.top()?;
        // Writers number what they remember from 0.
        let place = usize::try_from(place).unwrap_or(usize::MAX);
        if place >= frame.memo.len() {
            self.pay((place - frame.memo.len()).saturating_add(1))?;
            frame.memo.resize(place + 1, None);
        }
        if frame.memo[place].replace(top).is_none() {
            frame.filled += 1;
        }
        Ok(())
    }

    fn recall(&mut self, frame: &mut Stack, place: u64) -> Result<(), FormatError> {
        let place = usize::try_from(place).ok();
        let known = place.and_then(|place| frame.memo.get(place).copied().flatten());
        let known = known.ok_or_else(|| fault("a place that was never filled", "a known one"))?;
        self.push(frame, known)
    }

    /// What a class or function that is known gives for its arguments.
    fn build(&mut self, callee: Ref, arguments: Ref, depth: usize) -> Result<Ref, FormatError> {
        let Node::Global(global) = *self.nodes.get(callee) else {
            return Err(fault("a call of a value", "a call of a known name"));
        };
        let arguments = self.nodes.list(arguments).unwrap_or_default().to_vec();
        let wrong = || fault(format!("odd arguments of {global:?}"), "those it takes");
        let first = arguments.first().copied();
        let built = match global {
            Global::Reconstruct => Node::Empty,
            Global::FromBuffer => {
                let &[data, element, shape, order] = &arguments[..] else {
                    return Err(wrong());
                };
                let Node::Element(element) = *self.nodes.get(element) else {
                    return Err(wrong());
                };
                let fortran = self.nodes.text(order) == Some("F");
                let shape = self.nodes.sizes(shape).ok_or_else(wrong)?;
                self.array(dense(element, shape, fortran, data))?
            }
            Global::Scalar => {
                let &[element, data] = &arguments[..] else {
                    return Err(wrong());
                };
                let Node::Element(element) = *self.nodes.get(element) else {
                    return Err(wrong());
                };
                let Some(element) = element else {
                    // Text, or a date.
                    return self.add(Node::None);
                };
                let bytes = self.nodes.bytes(data);
                let bytes = bytes.filter(|bytes| bytes.len() == element.size);
                Node::Float(element.float(bytes.ok_or_else(wrong)?))
            }
            Global::DType => {
                let text = first.and_then(|first| self.nodes.text(first));
                let text = text.ok_or_else(wrong)?;
                let element = Element::parse(text);
                // Objects are `O8`; text and others have no numbers.
                Node::Element(element)
            }
            Global::Dict => {
                let given = first.and_then(|first| self.nodes.list(first));
                let mut entries = vec![];
                for &pair in given.unwrap_or_default() {
                    let Some(&[key, value]) = self.nodes.list(pair) else {
                        return Err(wrong());
                    };
                    entries.push(DictEntry { key, value });
                }
                self.pay(entries.len())?;
                Node::Dict(entries)
            }
            Global::List | Global::Tuple => {
                let items = first.and_then(|first| self.nodes.list(first));
                let items = items.unwrap_or_default().to_vec();
                self.pay(items.len())?;
                if global == Global::List {
                    Node::List(items)
                } else {
                    Node::Tuple(items)
                }
            }
            // An array of bytes is what it was made of.
            Global::ByteArray => match first {
                Some(first) if self.nodes.bytes(first).is_some() => return Ok(first),
                _ => return Err(wrong()),
            },
            Global::Encode => {
                let text = first.and_then(|first| self.nodes.text(first));
                let text = text.ok_or_else(wrong)?;
                let left = self.decoded_left.checked_sub(text.len());
                self.decoded_left = left.ok_or_else(|| {
                    fault(
                        "more decoded text than its size allows",
                        "each text decoded once",
                    )
                })?;
                let byte = |letter: char| u8::try_from(u32::from(letter)).ok();
                let bytes: Option<Vec<u8>> = text.chars().map(byte).collect();
                Node::Decoded(bytes.ok_or_else(wrong)?)
            }
            Global::Wrapper => Node::Stand,
            Global::Inert => Node::Inert,
            Global::Tensor => {
                let &[storage, start, shape, stride, ..] = &arguments[..] else {
                    return Err(wrong());
                };
                let Node::Storage(of) = self.nodes.get(storage) else {
                    return Err(wrong());
                };
                let element = Some(of.element);
                let start = self.nodes.sizes(start);
                let start = start.and_then(|start| start.first().copied());
                let shape = self.nodes.sizes(shape).ok_or_else(wrong)?;
                let stride = self.nodes.sizes(stride).ok_or_else(wrong)?;
                if shape.len() != stride.len() {
                    return Err(wrong());
                }
                self.array(ArrayNode {
                    element,
                    shape,
                    stride,
                    start: start.ok_or_else(wrong)?,
                    data: storage,
                })?
            }
            Global::Parameter => return first.ok_or_else(wrong),
            Global::Load => {
                let Some(Node::Bytes(bytes)) = first.map(|first| self.nodes.get(first)) else {
                    return Err(wrong());
                };
                let bytes: &'a [u8] = bytes;
                return self.legacy(bytes, depth + 1);
            }
            Global::NdArray | Global::StorageType(_) => {
                return Err(fault(
                    format!("a new {global:?}"),
                    "arrays as NumPy writes them",
                ));
            }
        };
        self.add(built)
    }

    /// Gives a value its state.
    fn fill(
        &mut self,
        target: Ref,
        state: Ref,
        input: &mut Input<'a>,
        depth: usize,
    ) -> Result<(), FormatError> {
        let wrong = |of: &str| fault(format!("an odd state of {of}"), "what NumPy writes");
        match self.nodes.get(target) {
            Node::Empty | Node::Array(_) => {
                let Some(&[_, shape, element, fortran, data]) = self.nodes.list(state) else {
                    return Err(wrong("an array"));
                };
                let Node::Element(element) = *self.nodes.get(element) else {
                    return Err(wrong("an array"));
                };
                let shape = self.nodes.sizes(shape).ok_or_else(|| wrong("an array"))?;
                let fortran = matches!(self.nodes.get(fortran), Node::Bool(true) | Node::Int(1));
                let array = self.array(dense(element, shape, fortran, data))?;
                *self.nodes.get_mut(target) = array;
            }
            Node::Element(element) => {
                let Some(&[_, order, ..]) = self.nodes.list(state) else {
                    return Err(wrong("a type"));
                };
                let big_endian = self.nodes.text(order) == Some(">");
                let element = element.map(|element| Element {
                    big_endian,
                    ..element
                });
                *self.nodes.get_mut(target) = Node::Element(element);
            }
            // joblib writes the array itself behind its stand-in.
            Node::Stand => {
                let array = self.wrapped(state, input, depth)?;
                *self.nodes.get_mut(target) = self.array(array)?;
            }
            // PyTorch hangs versions on a dictionary.
            Node::Dict(_) | Node::Inert => {}
            _ => return Err(fault("a state of a value", "a state of an array")),
        }
        Ok(())
    }

    /// The array behind joblib's stand-in.
    fn wrapped(
        &mut self,
        state: Ref,
        input: &mut Input<'a>,
        depth: usize,
    ) -> Result<ArrayNode, FormatError> {
        let wrong = || fault("an odd array of joblib's", "what joblib writes");
        let Node::Dict(entries) = self.nodes.get(state) else {
            return Err(wrong());
        };
        let field = |name: &str| {
            let entry = entries
                .iter()
                .find(|entry| self.nodes.text(entry.key) == Some(name));
            entry.map(|entry| entry.value)
        };
        let shape = field("shape").and_then(|at| self.nodes.sizes(at));
        let shape = shape.ok_or_else(wrong)?;
        let element = field("dtype").map(|at| self.nodes.get(at));
        let Some(&Node::Element(element)) = element else {
            return Err(wrong());
        };
        let fortran = field("order").and_then(|at| self.nodes.text(at)) == Some("F");
        // Since 1.2 a byte says how many more bring the array to a multiple of 16.
        let aligned = field("numpy_array_alignment_bytes")
            .is_some_and(|at| !matches!(self.nodes.get(at), Node::None));
        let Some(size) = element.map(|element| element.size) else {
            let run = self.run(input.bytes, input.at, depth + 1)?;
            input.at = run.end;
            return match self.nodes.get(run.root) {
                Node::Array(array) => Ok((**array).clone()),
                _ => Err(wrong()),
            };
        };
        if aligned {
            input.counted(1)?;
        }
        let count = shape.iter().try_fold(size, |n, &size| n.checked_mul(size));
        let bytes = input.take(count.ok_or_else(wrong)? as u64)?;
        let data = self.add(Node::Bytes(bytes))?;
        Ok(dense(element, shape, fortran, data))
    }

    /// The storage of a persistent id: ('storage', class, key, device, numbers).
    fn storage(&self, id: Ref) -> Result<Node<'a>, FormatError> {
        let wrong = || fault("an odd persistent id", "one of a PyTorch storage");
        let Some(&[_, class, key, ..]) = self.nodes.list(id) else {
            return Err(wrong());
        };
        let Node::Global(Global::StorageType(element)) = *self.nodes.get(class) else {
            return Err(wrong());
        };
        let key = name(self.nodes.get(key)).ok_or_else(wrong)?;
        Ok(Node::Storage(Box::new(Storage {
            key,
            element,
            bytes: self.storages.get(key).copied(),
        })))
    }

    /// Reads what PyTorch wrote before its zips: pickles of a number, a version, the system, the
    /// object and the keys of its storages, then the storages.
    pub fn legacy(&mut self, bytes: &'a [u8], depth: usize) -> Result<Ref, FormatError> {
        let before = self.nodes.len();
        let mut at = 0;
        for _ in 0..3 {
            at = self.run(bytes, at, depth)?.end;
        }
        let object = self.run(bytes, at, depth)?;
        let keys = self.run(bytes, object.end, depth)?;
        let mut sizes = BTreeMap::new();
        for node in self.nodes.since_mut(before) {
            if let Node::Storage(storage) = node {
                sizes.insert(storage.key, storage.element.size);
            }
        }
        let mut input = Input {
            bytes,
            at: keys.end,
        };
        let mut found = BTreeMap::new();
        for &key in self.nodes.list(keys.root).unwrap_or_default() {
            let key = name(self.nodes.get(key));
            let key = key.ok_or_else(|| fault("a storage without a name", "keys of storages"))?;
            let size = sizes.get(key).copied().unwrap_or_default() as u64;
            let length = input.number(8)?.checked_mul(size);
            found.insert(key, input.take(length.ok_or_else(cut)?)?);
        }
        for node in self.nodes.since_mut(before) {
            if let Node::Storage(storage) = node
                && storage.bytes.is_none()
            {
                storage.bytes = found.get(storage.key).copied();
            }
        }
        Ok(object.root)
    }
}

/// Text of the file; Python 2 wrote bytes.
fn name<'a>(node: &Node<'a>) -> Option<&'a str> {
    match *node {
        Node::Text(text) => Some(text),
        Node::Bytes(bytes) => std::str::from_utf8(bytes).ok(),
        _ => None,
    }
}

/// An integer of any length, little-endian with a sign.
fn long(bytes: &[u8]) -> Node<'_> {
    if bytes.len() > 8 {
        return Node::Long;
    }
    let word = bytes
        .iter()
        .rev()
        .fold(0u64, |sum, &byte| sum << 8 | u64::from(byte));
    let unused = 64 - 8 * bytes.len() as u32;
    if unused == 64 {
        return Node::Int(0);
    }
    Node::Int((word << unused) as i64 >> unused)
}

fn entries(items: &[Ref]) -> Result<Vec<DictEntry>, FormatError> {
    let (pairs, []) = items.as_chunks::<2>() else {
        return Err(fault("a key without a value", "pairs"));
    };
    let entry = |&[key, value]: &[Ref; 2]| DictEntry { key, value };
    Ok(pairs.iter().map(entry).collect())
}

fn named(module: &str, name: &str) -> Result<Global, FormatError> {
    global(module, name).ok_or_else(|| {
        fault(
            format!("`{}`", excerpt(&format!("{module}.{name}"))),
            "names of NumPy's arrays, PyTorch's tensors and plain containers alone: nothing is called",
        )
    })
}

/// An array whose numbers fill its memory.
fn dense(element: Option<Element>, shape: Vec<usize>, fortran: bool, data: Ref) -> ArrayNode {
    let mut stride = vec![0; shape.len()];
    let mut step = 1usize;
    let mut give = |axis: usize| {
        stride[axis] = step;
        // What does not fit is found when numbers are asked for.
        step = step.saturating_mul(shape[axis]);
    };
    if fortran {
        (0..shape.len()).for_each(&mut give);
    } else {
        (0..shape.len()).rev().for_each(&mut give);
    }
    ArrayNode {
        element,
        shape,
        stride,
        start: 0,
        data,
    }
}
