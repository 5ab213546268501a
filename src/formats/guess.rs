//! What a file seems to be that no reader takes, for errors.

/// A beginning that tells a kind of file.
struct Sign {
    /// Its first bytes.
    start: &'static [u8],
    /// With an article.
    what: &'static str,
}

const fn sign(start: &'static [u8], what: &'static str) -> Sign {
    Sign { start, what }
}

const SIGNS: [Sign; 23] = [
    sign(b"\x89PNG", "a PNG picture"),
    sign(b"\xff\xd8\xff", "a JPEG picture"),
    sign(b"GIF8", "a GIF picture"),
    sign(b"RIFF", "a RIFF file: a WebP picture, a sound or a film"),
    sign(b"\x00\x00\x00\x18ftyp", "a film (MP4)"),
    sign(b"\x00\x00\x00\x20ftyp", "a film (MP4)"),
    sign(b"\xfd7zXZ", "xz: unpack it"),
    sign(b"\x28\xb5\x2f\xfd", "zstd: unpack it"),
    sign(b"BZh", "bzip2: unpack it"),
    sign(b"7z\xbc\xaf", "a 7z archive: unpack it"),
    sign(b"Rar!", "a RAR archive: unpack it"),
    sign(b"\x89HDF", "an HDF5 file"),
    sign(b"%PDF", "a PDF"),
    sign(b"\x7fELF", "a program"),
    sign(b"MZ", "a program"),
    sign(
        b"BLENDER",
        "a Blender file: export an FBX, glTF or BVH from it",
    ),
    sign(
        b"PXR-USDC",
        "a USD file: export an FBX, glTF or BVH from it",
    ),
    sign(b"#usda", "a USD file: export an FBX, glTF or BVH from it"),
    sign(b"SQLite", "a database"),
    sign(
        b"version https://git-lfs",
        "a pointer of Git LFS: get the file with `git lfs pull`",
    ),
    sign(b"<!DOCTYPE", "a web page: the download failed"),
    sign(b"<html", "a web page: the download failed"),
    sign(b"<?xml", "XML"),
];

/// Names of SMPL's parameters in a file of each frame, as LHM and ExAvatar have it.
const FRAME: [&[u8]; 4] = [
    b"\"root_pose\"",
    b"\"body_pose\"",
    b"\"global_orient\"",
    b"\"smplx_param",
];

fn holds(start: &[u8], name: &[u8]) -> bool {
    start.windows(name.len()).any(|word| word == name)
}

/// What a file that begins so seems to be; None: nothing is known of it.
pub fn seems(start: &[u8]) -> Option<&'static str> {
    if start.is_empty() {
        return Some("an empty file");
    }
    if start.get(257..262) == Some(b"ustar") {
        return Some("a tar archive: unpack it");
    }
    let trimmed = start.trim_ascii_start();
    let known = SIGNS
        .iter()
        .find(|sign| start.starts_with(sign.start) || trimmed.starts_with(sign.start));
    if let Some(sign) = known {
        return Some(sign.what);
    }
    if trimmed.starts_with(b"{") && FRAME.iter().any(|name| holds(start, name)) {
        return Some(
            "one frame of SMPL's parameters in JSON: stack those of all frames in an .npz, with \
             the same names",
        );
    }
    let is_text = |byte: &u8| !byte.is_ascii_control() || byte.is_ascii_whitespace();
    start.iter().all(is_text).then_some("text of no known kind")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_are_named_by_their_beginning() {
        assert_eq!(seems(b"\x89PNG\r\n"), Some("a PNG picture"));
        assert_eq!(seems(b""), Some("an empty file"));
        assert_eq!(seems(b"# Effigy\n"), Some("text of no known kind"));
        let frame = seems(br#"{"root_pose": [0, 0, 0], "body_pose": [[0, 0, 0]]}"#);
        assert!(frame.is_some_and(|what| what.contains("in an .npz")));
        assert_eq!(seems(&[0, 1, 2, 3]), None);
        let pointer = seems(b"version https://git-lfs.github.com/spec/v1\n");
        assert!(pointer.is_some_and(|what| what.contains("git lfs pull")));
    }
}
