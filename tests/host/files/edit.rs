//! A safetensors file taken apart, so that tests can break it on purpose.

use serde_json::{Value, json};

pub struct Edit {
    /// The header, but for our document.
    pub header: Value,
    /// Our document in it.
    pub document: Value,
    pub data: Vec<u8>,
}

impl Edit {
    pub fn open(bytes: &[u8]) -> Self {
        let length = u64::from_le_bytes(bytes[..8].try_into().unwrap()) as usize;
        let header: Value = serde_json::from_slice(&bytes[8..8 + length]).unwrap();
        let document =
            serde_json::from_str(header["__metadata__"]["effigy"].as_str().unwrap()).unwrap();
        Self {
            header,
            document,
            data: bytes[8 + length..].to_vec(),
        }
    }

    pub fn bytes(&self) -> Vec<u8> {
        let mut header = self.header.clone();
        header["__metadata__"]["effigy"] = json!(self.document.to_string());
        raw(header.to_string().as_bytes(), &self.data)
    }

    /// Where a tensor's bytes begin, and how many each element has.
    fn place(&self, tensor: &str) -> (usize, usize) {
        let info = &self.header[tensor];
        let offset = |k: usize| info["data_offsets"][k].as_u64().unwrap() as usize;
        let elements: u64 = info["shape"]
            .as_array()
            .unwrap()
            .iter()
            .map(|n| n.as_u64().unwrap())
            .product();
        (offset(0), (offset(1) - offset(0)) / elements as usize)
    }

    /// Overwrites a tensor from its element `at` on.
    pub fn put(&mut self, tensor: &str, at: usize, bytes: &[u8]) {
        let (start, size) = self.place(tensor);
        self.data[start + at * size..][..bytes.len()].copy_from_slice(bytes);
    }

    /// What the file has of a tensor.
    pub fn stored(&self, tensor: &str) -> Vec<u8> {
        let offset = |k: usize| self.header[tensor]["data_offsets"][k].as_u64().unwrap() as usize;
        self.data[offset(0)..offset(1)].to_vec()
    }

    /// Puts another tensor in a tensor's place.
    pub fn replace(&mut self, tensor: &str, dtype: &str, shape: &[usize], bytes: &[u8]) {
        let info = self.header.as_object_mut().unwrap().remove(tensor).unwrap();
        let [start, end] = [0, 1].map(|k| info["data_offsets"][k].as_u64().unwrap() as usize);
        self.data.drain(start..end);
        for (_, other) in self
            .header
            .as_object_mut()
            .unwrap()
            .iter_mut()
            .filter(|(name, _)| *name != "__metadata__")
        {
            for offset in other["data_offsets"].as_array_mut().unwrap() {
                let at = offset.as_u64().unwrap() as usize;
                *offset = json!(if at >= end { at - (end - start) } else { at });
            }
        }
        self.append(tensor, dtype, shape, bytes);
    }

    pub fn rename(&mut self, from: &str, to: &str) {
        let info = self.header.as_object_mut().unwrap().remove(from).unwrap();
        self.header[to] = info;
    }

    pub fn append(&mut self, name: &str, dtype: &str, shape: &[usize], bytes: &[u8]) {
        let offsets = [self.data.len(), self.data.len() + bytes.len()];
        self.header[name] = json!({ "dtype": dtype, "shape": shape, "data_offsets": offsets });
        self.data.extend(bytes);
    }
}

/// A file with any header at all.
pub fn raw(header: &[u8], data: &[u8]) -> Vec<u8> {
    [&(header.len() as u64).to_le_bytes(), header, data].concat()
}
