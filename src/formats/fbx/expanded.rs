//! How many bytes an FBX file is when its arrays are unpacked: keys of animations are deflated.

/// How many times its own size a file counts as at most. Keys of real animations deflate to half or
/// a third; what claims more is let have no more memory.
const MOST: usize = 4;
/// Bytes of a binary file before its first node.
const HEADER: usize = 27;
/// The first version whose nodes have lengths of 64 bits.
const WIDE: u32 = 7500;

/// Bytes of a file with its arrays unpacked, at most [`MOST`] times as many as it has. Text, and what
/// can't be followed, counts as it is.
pub fn expanded(bytes: &[u8]) -> usize {
    let mut nodes = NodeWalk {
        bytes,
        at: HEADER,
        wide: false,
    };
    let grown = match nodes.start() {
        Some(()) => nodes.growth(),
        None => 0,
    };
    bytes
        .len()
        .saturating_add(grown)
        .min(MOST.saturating_mul(bytes.len()))
}

/// A way through a binary file. Nodes are in one another, but their properties follow each other.
struct NodeWalk<'a> {
    bytes: &'a [u8],
    at: usize,
    wide: bool,
}

impl NodeWalk<'_> {
    fn start(&mut self) -> Option<()> {
        let version = self.bytes.get(HEADER - 4..)?.first_chunk()?;
        self.wide = u32::from_le_bytes(*version) >= WIDE;
        self.bytes.starts_with(b"Kaydara FBX Binary").then_some(())
    }

    /// The next few bytes as a number.
    fn number(&mut self, size: usize) -> Option<usize> {
        let end = self.at.checked_add(size)?;
        let number = self.bytes.get(self.at..end)?;
        self.at = end;
        let number = number
            .iter()
            .rev()
            .fold(0u64, |sum, &byte| sum << 8 | u64::from(byte));
        usize::try_from(number).ok()
    }

    /// How much longer arrays are than in the file, as far as it can be followed.
    fn growth(&mut self) -> usize {
        let mut growth = 0usize;
        while let Some(count) = self.node() {
            for _ in 0..count {
                match self.property() {
                    Some(more) => growth = growth.saturating_add(more),
                    None => return growth,
                }
            }
        }
        growth
    }

    /// Goes past the head of a node, and says how many properties follow. A node of zeros ends those
    /// inside another, and has none.
    fn node(&mut self) -> Option<usize> {
        let size = if self.wide { 8 } else { 4 };
        self.number(size)?;
        let count = self.number(size)?;
        self.number(size)?;
        let name = self.number(1)?;
        self.at = self.at.checked_add(name)?;
        Some(count)
    }

    /// Goes past a property, and says how much longer it is when it is unpacked.
    fn property(&mut self) -> Option<usize> {
        let kind = self.number(1)? as u8;
        let size = match kind {
            b'C' | b'B' => 1,
            b'Y' => 2,
            b'I' | b'F' => 4,
            b'L' | b'D' => 8,
            b'S' | b'R' => self.number(4)?,
            b'b' | b'c' => return self.array(1),
            b'i' | b'f' => return self.array(4),
            b'l' | b'd' => return self.array(8),
            _ => return None,
        };
        self.at = self.at.checked_add(size)?;
        Some(0)
    }

    fn array(&mut self, element: usize) -> Option<usize> {
        let count = self.number(4)?;
        self.number(4)?;
        let stored = self.number(4)?;
        self.at = self
            .at
            .checked_add(stored)
            .filter(|&end| end <= self.bytes.len())?;
        Some(count.saturating_mul(element).saturating_sub(stored))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A binary file of one node with an array of f64.
    fn file(version: u32, count: u32, stored: &[u8]) -> Vec<u8> {
        let mut bytes = b"Kaydara FBX Binary  \0\x1a\0".to_vec();
        bytes.extend(version.to_le_bytes());
        let word = |word: u32| match version {
            0..WIDE => word.to_le_bytes().to_vec(),
            _ => u64::from(word).to_le_bytes().to_vec(),
        };
        let length = 13 + stored.len() as u32;
        for number in [0, 1, length] {
            bytes.extend(word(number));
        }
        bytes.extend(b"\x01ad");
        for number in [count, 1, stored.len() as u32] {
            bytes.extend(number.to_le_bytes());
        }
        bytes.extend(stored);
        bytes
    }

    #[test]
    fn arrays_count_as_they_unpack_up_to_a_limit() {
        for version in [7400, 7500] {
            let some = file(version, 20, &[0; 100]);
            assert_eq!(expanded(&some), some.len() + 60, "{version}");
            let bomb = file(version, u32::MAX, &[0; 100]);
            assert_eq!(expanded(&bomb), 4 * bomb.len(), "{version}");
            let mut cut = some;
            cut.truncate(80);
            assert_eq!(expanded(&cut), 80);
        }
        assert_eq!(expanded(b"; FBX 7.4.0"), 11);
        assert_eq!(expanded(b""), 0);
    }
}
