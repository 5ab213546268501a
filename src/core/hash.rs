//! FNV-1a: bytes in, a number that changes with them out; the same on every machine.

/// Hash of no bytes.
pub const EMPTY: u64 = 0xcbf2_9ce4_8422_2325;

/// Extends `hash` by `bytes`.
pub fn extend(hash: u64, bytes: impl IntoIterator<Item = u8>) -> u64 {
    bytes.into_iter().fold(hash, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3)
    })
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_hash_is_the_published_one() {
        assert_eq!(
            super::extend(super::EMPTY, *b"foobar"),
            0x8594_4171_f739_67e8
        );
    }
}
