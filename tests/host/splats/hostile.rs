//! What is wrong with a splat file is named; nothing in it makes the program panic or take memory
//! that the file does not justify.

use super::{FILES, File, GLB, GLTF, KSPLAT_2, SOG_1, SOG_2, SPLAT, SPZ_2, SPZ_4};
use crate::memory;
use effigy_formats::{
    content::Content,
    splats::{self, Nothing, SplatFormat},
};
use flate2::{Compression, read::GzDecoder, write::GzEncoder};
use proptest::prelude::*;
use std::{
    io::{Cursor, Read, Write},
    path::Path,
};
use zip::{CompressionMethod, ZipArchive, ZipWriter, write::SimpleFileOptions};

fn fault(bytes: &[u8], format: SplatFormat) -> String {
    match splats::read(bytes, format, &mut Nothing) {
        Ok(found) => {
            let avatar = found.splats.to_avatar("a").unwrap();
            assert!(avatar.check().is_ok());
            "none".into()
        }
        Err(error) => error.to_string(),
    }
}

/// A file in which some bytes are others.
fn with(file: &File, at: usize, bytes: &[u8]) -> String {
    let mut changed = file.bytes.to_vec();
    changed[at..][..bytes.len()].copy_from_slice(bytes);
    fault(&changed, file.format)
}

pub fn gunzip(bytes: &[u8]) -> Vec<u8> {
    let mut content = Vec::new();
    GzDecoder::new(bytes).read_to_end(&mut content).unwrap();
    content
}

pub fn gzip(content: &[u8]) -> Vec<u8> {
    let mut writer = GzEncoder::new(Vec::new(), Compression::best());
    writer.write_all(content).unwrap();
    writer.finish().unwrap()
}

/// A file of an archive.
#[derive(Clone)]
struct Member {
    name: String,
    bytes: Vec<u8>,
}

fn members(file: &File) -> Vec<Member> {
    let mut archive = ZipArchive::new(Cursor::new(file.bytes)).unwrap();
    let count = archive.len();
    let read = |index: usize| {
        let mut bytes = Vec::new();
        let mut entry = archive.by_index(index).unwrap();
        let name = entry.name().unwrap().into_owned();
        entry.read_to_end(&mut bytes).unwrap();
        Member { name, bytes }
    };
    (0..count).map(read).collect()
}

fn archive(members: &[Member], method: CompressionMethod) -> Vec<u8> {
    let mut writer = ZipWriter::new(Cursor::new(Vec::new()));
    let options = SimpleFileOptions::default().compression_method(method);
    for member in members {
        writer.start_file(member.name.clone(), options).unwrap();
        writer.write_all(&member.bytes).unwrap();
    }
    writer.finish().unwrap().into_inner()
}

/// A SOG in which one text of its document is another.
fn with_meta(file: &File, from: &str, to: &str) -> String {
    let mut members = members(file);
    let meta = members.iter_mut().find(|m| m.name == "meta.json").unwrap();
    let text = String::from_utf8(meta.bytes.clone()).unwrap();
    assert!(text.contains(from), "{from}");
    meta.bytes = text.replacen(from, to, 1).into_bytes();
    fault(&archive(&members, CompressionMethod::Stored), file.format)
}

/// A glTF in which one text is another.
fn with_text(from: &str, to: &str) -> String {
    let text = std::str::from_utf8(GLTF.bytes).unwrap();
    assert!(text.contains(from), "{from}");
    fault(text.replacen(from, to, 1).as_bytes(), GLTF.format)
}

fn each_fault_is_named() {
    let word = |value: u32| value.to_le_bytes();
    let cases = [
        (
            fault(b"", SplatFormat::Spz),
            "in the gzip, expected an .spz",
        ),
        (fault(b"NGSP", SplatFormat::Spz), "16 bytes of a header"),
        (fault(b"glTF", SplatFormat::Glb), "12 bytes of a header"),
        (fault(b"PK", SplatFormat::Sog), "a zip without its end"),
        (fault(b"{}", SplatFormat::SogMeta), "missing field `means`"),
        (
            fault(b"{}", SplatFormat::Gltf),
            "a glTF scene without splats",
        ),
        (fault(&[0; 33], SplatFormat::Splat), "32 for each splat"),
        (fault(&[], SplatFormat::Splat), "found 0 Gaussians"),
        (
            fault(&[0xff; 96], SplatFormat::Splat),
            "NaN in the position of vertex 0, and none of 3 that can be drawn",
        ),
        (
            with(&SPZ_4, 4, &word(5)),
            "found version 5 of .spz, expected 1 to 4",
        ),
        (
            with(&SPZ_4, 8, &word(u32::MAX)),
            "found 4294967295 Gaussians",
        ),
        (with(&SPZ_4, 8, &word(100_001)), "found 100001 Gaussians in"),
        (
            with(&SPZ_4, 8, &word(65)),
            "a stream of 576 bytes, expected 585",
        ),
        (with(&SPZ_4, 12, &[5]), "harmonics of degree 5"),
        (with(&SPZ_4, 13, &[24]), "24 bits after the point"),
        (with(&SPZ_4, 15, &[7]), "found 7 streams, expected 6"),
        (
            with(&SPZ_4, 16, &word(u32::MAX)),
            "a table from byte 4294967295",
        ),
        (with(&SPZ_4, 16, &word(3)), "a table at byte 3"),
        (with(&KSPLAT_2, 0, &[1]), "found version 1.1"),
        (
            with(&KSPLAT_2, 4, &word(u32::MAX)),
            "headers from byte 4096",
        ),
        (with(&KSPLAT_2, 4, &word(0)), "found 0 Gaussians"),
        (with(&KSPLAT_2, 20, &[3]), "found compression 3"),
        (
            with(&KSPLAT_2, 4096 + 4, &word(u32::MAX)),
            "bytes of splats from byte",
        ),
        (
            with(&KSPLAT_2, 4096 + 36, &word(0)),
            "splats beyond the last bucket",
        ),
        (with(&KSPLAT_2, 4096 + 40, &[9]), "harmonics of degree 9"),
        (
            with_meta(&SOG_2, "\"version\":2", "\"version\":3"),
            "in metadata `version` found 3",
        ),
        (
            with_meta(&SOG_2, "\"count\":64", "\"count\":0"),
            "found 0 Gaussians",
        ),
        (
            with_meta(&SOG_2, "\"count\":64", "\"count\":90000"),
            "pixels in `means_l.webp`",
        ),
        (
            with_meta(&SOG_2, "\"count\":64", "\"count\":100001"),
            "found 100001 Gaussians in",
        ),
        (
            with_meta(&SOG_2, "\"count\":64", "\"count\":9000000000000"),
            "in metadata `count` found 9000000000000",
        ),
        (
            with_meta(&SOG_2, "means_l.webp", "meta.json"),
            "in `meta.json`, expected a WebP image",
        ),
        (with_meta(&SOG_2, "means_l.webp", "../a"), "for `../a`"),
        (
            with_meta(&SOG_1, "\"mins\": [", "\"mins\": [0, "),
            "found 4 mins and 3 maxs",
        ),
        (with(&GLB, 4, &word(1)), "found version 1 of glTF"),
        (with(&GLB, 8, &word(u32::MAX)), "expected 4294967295 bytes"),
        (
            with(&GLB, 12, &word(u32::MAX)),
            "4294967295 bytes of a chunk",
        ),
        (
            with_text("\"mesh\": 0", "\"mesh\": 1"),
            "found mesh 1, expected one of 1",
        ),
        (
            with_text("\"children\": [1]", "\"children\": [0]"),
            "node 0 twice in the scene",
        ),
        (
            with_text("\"scale\": [2, 2, 2]", "\"scale\": [2, -2, 2]"),
            "mirrors or flattens",
        ),
        (
            with_text("\"scale\": [2, 2, 2]", "\"scale\": [2, 0, 2]"),
            "mirrors or flattens",
        ),
        (
            with_text("\"rotation\": [0,", "\"rotation\": [1e999,"),
            "can't be read",
        ),
        (
            with_text("\"kernel\": \"ellipse\"", "\"kernel\": \"box\""),
            "the kernel `box`",
        ),
        (
            with_text(":OPACITY", ":O"),
            "no attribute `KHR_gaussian_splatting:OPACITY`",
        ),
        (
            with_text("\"count\": 64", "\"count\": 65"),
            "64 VEC4 of the attribute",
        ),
        (
            with_text("\"count\": 64", "\"count\": 18446744073709551615"),
            "Gaussians",
        ),
        (
            with_text("\"byteOffset\": 0", "\"byteOffset\": 18446744073709551615"),
            "a buffer view",
        ),
        (
            with_text("\"byteStride\": 12", "\"byteStride\": 1"),
            "a stride of 1",
        ),
        (with_text("5126", "5125"), "the component type 5125"),
        (with_text("base64,", "base64,*"), "expected base64 in it"),
        (
            with_text("data:application", "scene.bin?"),
            "no files beside this one",
        ),
    ];
    for (found, expected) in cases {
        assert!(found.contains(expected), "{found}, expected {expected}");
    }
    let required = with_text(
        "extensionsUsed\": [\"KHR",
        "extensionsRequired\": [\"EXT_x\", \"KHR",
    );
    assert!(
        required.contains("the required extension `EXT_x`"),
        "{required}"
    );
}

/// Neither a count nor what a file unpacks to costs more than the file allows.
fn memory_follows_from_the_file_not_from_its_word() {
    let limit = |bytes: &[u8]| 4 * bytes.len() + (64 << 20);
    let check = |bytes: &[u8], format, expected: &str| {
        let (found, peak) = memory::peak(|| fault(bytes, format));
        assert!(found.contains(expected), "{found}, expected {expected}");
        assert!(
            peak < limit(bytes),
            "{expected}: {peak} bytes of {}",
            bytes.len()
        );
    };
    // The largest file of nothing that is taken, and one that says more than it may.
    let spz = |count: u32, degree: u8, version: u32| {
        let mut content = b"NGSP".to_vec();
        content.extend(version.to_le_bytes());
        content.extend(count.to_le_bytes());
        content.extend([degree, 12, 0, 0]);
        content.resize(content.len() + (20 + 3 * 15) * count as usize, 0);
        gzip(&content)
    };
    check(&spz(100_000, 3, 3), SplatFormat::Spz, "none");
    check(
        &spz(100_001, 3, 3),
        SplatFormat::Spz,
        "found 100001 Gaussians in",
    );
    check(
        &spz(2_000_000, 0, 3),
        SplatFormat::Spz,
        "found 2000000 Gaussians in",
    );
    // More than the header says.
    let mut long = gunzip(SPZ_2.bytes);
    long.resize(256 << 20, 0);
    check(&gzip(&long), SplatFormat::Spz, "more than");
    // A zstd frame of one repeated byte, and one that wants a window of a terabyte.
    let toc = 32 + 6 * 16;
    let frame = |bytes: &[u8]| {
        let mut changed = SPZ_4.bytes[..toc].to_vec();
        changed[32..40].copy_from_slice(&(bytes.len() as u64).to_le_bytes());
        [changed, bytes.to_vec()].concat()
    };
    let window = [0x28, 0xB5, 0x2F, 0xFD, 0x00, 0xF0, 0x01, 0x00, 0x00];
    check(&frame(&window), SplatFormat::Spz, "a window of");
    let mut repeated = vec![0x28, 0xB5, 0x2F, 0xFD, 0x00, 0x50];
    for _ in 0..4096 {
        let block = 128u32 << 10;
        repeated.extend(&(block << 3 | 0b010).to_le_bytes()[..3]);
        repeated.push(7);
    }
    check(&frame(&repeated), SplatFormat::Spz, "more than 576 bytes");
    // Archives of zeros, and an image of 16 gigapixels' words.
    let mut zeros = members(&SOG_2);
    for member in &mut zeros {
        if member.name.ends_with(".webp") {
            member.bytes = vec![0; 200 << 20];
        }
    }
    let zeros = archive(&zeros, CompressionMethod::Deflated);
    check(&zeros, SplatFormat::Sog, "more than");
    let mut huge = members(&SOG_2);
    for member in huge.iter_mut().filter(|m| m.name.ends_with(".webp")) {
        // The sizes of a lossless image: 14 bits each after the signature.
        let signature = member
            .bytes
            .windows(4)
            .position(|part| part == b"VP8L")
            .unwrap()
            + 9;
        member.bytes[signature..][..4].copy_from_slice(&0x0FFF_FFFFu32.to_le_bytes());
    }
    check(
        &archive(&huge, CompressionMethod::Stored),
        SplatFormat::Sog,
        "means_l.webp",
    );
    // JSON of many small things.
    for (item, count) in [("{},", 2_000_000), ("[],", 3_000_000)] {
        let items = item.repeat(count);
        let text = format!("{{\"nodes\":[{items}{{}}]}}");
        check(text.as_bytes(), SplatFormat::Gltf, "a glTF document of");
        let text = format!("{{\"means\":[{items}0]}}");
        check(text.as_bytes(), SplatFormat::SogMeta, "meta.json");
    }
    let deep = "[".repeat(1 << 20);
    check(
        format!("{{\"nodes\":{deep}").as_bytes(),
        SplatFormat::Gltf,
        "can't be read",
    );
    // The same mesh in many nodes.
    let nodes = (0..40_000)
        .map(|_| "{\"mesh\": 0}")
        .collect::<Vec<_>>()
        .join(",");
    let roots = (0..40_000)
        .map(|k| k.to_string())
        .collect::<Vec<_>>()
        .join(",");
    let text = std::str::from_utf8(GLTF.bytes).unwrap();
    let start = text.find("\"nodes\": [{\"children\"").unwrap();
    let end = text.find("\"meshes\"").unwrap();
    let text = format!("{}\"nodes\": [{nodes}], {}", &text[..start], &text[end..]);
    let text = text.replacen("{\"nodes\": [0]}", &format!("{{\"nodes\": [{roots}]}}"), 1);
    check(text.as_bytes(), SplatFormat::Gltf, "Gaussians in");
}

fn a_file_that_ends_too_soon_is_refused_wherever_it_ends() {
    for file in FILES {
        for end in 0..file.bytes.len() {
            // Whole splats are a whole file.
            if file.format == SplatFormat::Splat && end > 0 && end % 32 == 0 {
                continue;
            }
            // Large files at every byte would take minutes.
            if end > 600 && end + 64 < file.bytes.len() && end % 31 != 0 {
                continue;
            }
            let found = fault(&file.bytes[..end], file.format);
            assert_ne!(found, "none", "{} at {end}", file.name);
        }
    }
}

fn letters_are_no_splats() {
    let mesh = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    assert_eq!(mesh.len(), 32);
    assert_eq!(SplatFormat::of(mesh, 32), None);
}

/// Nothing stands before the first splat of a `.splat`: its x may begin as text of another kind does.
fn a_first_byte_that_other_files_begin_with_tells_nothing() {
    for first in *b"[{<#g" {
        let mut bytes = SPLAT.bytes.to_vec();
        bytes[0] = first;
        let content = Content::of(&bytes, Path::new("download"));
        assert_eq!(content, Content::Splats(SplatFormat::Splat), "{first}");
    }
}

/// Bytes of one format read as another.
fn no_reader_panics_over_another_format() {
    for file in FILES {
        for other in FILES.iter().filter(|other| other.format != file.format) {
            // One reader has both.
            if [file, other]
                .iter()
                .all(|f| matches!(f.format, SplatFormat::Glb | SplatFormat::Gltf))
            {
                continue;
            }
            let found = fault(file.bytes, other.format);
            let any = other.format == SplatFormat::Splat && file.bytes.len() % 32 == 0;
            assert!(
                found != "none" || any,
                "{} as {:?}",
                file.name,
                other.format
            );
        }
    }
}

type Changes = Vec<(prop::sample::Index, u8)>;

fn changes() -> impl Strategy<Value = Changes> {
    prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..6)
}

fn changed(bytes: &[u8], changes: Changes, end: usize) -> Vec<u8> {
    let mut bytes = bytes.to_vec();
    let end = end.min(bytes.len());
    for (at, byte) in changes {
        bytes[at.index(end)] = byte;
    }
    bytes
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    fn changed_bytes_never_panic(
        file in any::<prop::sample::Index>(), changes in changes(), in_header in any::<bool>(),
    ) {
        let file = file.get(FILES);
        let end = if in_header { 256 } else { usize::MAX };
        let _ = fault(&changed(file.bytes, changes, end), file.format);
    }

    /// Changes inside, which checksums would hide from the reader.
    fn changed_contents_never_panic(
        changes in changes(), member in any::<prop::sample::Index>(), which in 0..3, in_header in any::<bool>(),
    ) {
        let end = if in_header { 32 } else { usize::MAX };
        if which == 0 {
            let content = changed(&gunzip(SPZ_2.bytes), changes, end);
            let _ = fault(&gzip(&content), SplatFormat::Spz);
        } else {
            let file = if which == 1 { SOG_1 } else { SOG_2 };
            let mut members = members(&file);
            let member = member.get_mut(&mut members);
            member.bytes = changed(&member.bytes, changes, usize::MAX);
            let _ = fault(&archive(&members, CompressionMethod::Stored), SplatFormat::Sog);
        }
    }

    fn noise_never_panics(bytes in prop::collection::vec(any::<u8>(), 0..600), file in any::<prop::sample::Index>()) {
        let file = file.get(FILES);
        let _ = fault(&bytes, file.format);
        let start = [&file.bytes[..file.bytes.len().min(64)], &bytes].concat();
        let _ = fault(&start, file.format);
        let _ = SplatFormat::of(&start, 9000);
    }
}

tests! {
    each_fault_is_named,
    memory_follows_from_the_file_not_from_its_word,
    a_file_that_ends_too_soon_is_refused_wherever_it_ends,
    letters_are_no_splats,
    a_first_byte_that_other_files_begin_with_tells_nothing,
    no_reader_panics_over_another_format,
    changed_bytes_never_panic,
    changed_contents_never_panic,
    noise_never_panics,
}
