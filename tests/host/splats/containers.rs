//! Files in what people hand them around in: zips, gzips, byte order marks, GLBs of any padding. Each
//! reads as it does alone, whatever reader it is for.

use super::{
    GLB, GLTF, KSPLAT_1, SOG_2, SPLAT, SPZ_2, SPZ_4, TRUTH,
    hostile::{gunzip, gzip},
};
use crate::memory;
use effigy_core::{
    avatar::Avatar,
    glam::DAffine3,
    io::{cameras, splats::Up},
};
use effigy_formats::{
    capture::Capture,
    content::Content,
    read::{self, Source},
    splats::Nothing,
};
use std::{
    io::{Cursor, Write},
    path::Path,
};
use zip::{CompressionMethod, ZipArchive, ZipWriter, write::SimpleFileOptions};

/// What a file is read as.
#[derive(Debug, PartialEq)]
enum Read {
    Avatar(Box<Avatar>),
    Motion(Box<Capture>),
}

fn read(bytes: &[u8], name: &str) -> Result<Read, String> {
    let mut beside = Nothing;
    let source = Source::new(bytes, Path::new(name), &mut beside);
    let read = if source.content().is_motion() {
        let captured = read::capture(source, &Default::default());
        captured.map(|captured| Read::Motion(captured.capture.into()))
    } else {
        let imported = read::avatar(source, &Default::default());
        imported.map(|imported| Read::Avatar(imported.avatar.into()))
    };
    read.map_err(|error| error.to_string())
}

fn zip(members: &[(&str, &[u8])]) -> Vec<u8> {
    let mut writer = ZipWriter::new(Cursor::new(Vec::new()));
    let options = SimpleFileOptions::default().compression_method(CompressionMethod::Deflated);
    for (name, bytes) in members {
        if name.ends_with('/') {
            writer.add_directory(*name, options).unwrap();
        } else {
            writer.start_file(*name, options).unwrap();
            writer.write_all(bytes).unwrap();
        }
    }
    writer.finish().unwrap().into_inner()
}

const BVH: &[u8] = include_bytes!("../../data/motion/mixamo.bvh");
const DANCE: &[u8] = include_bytes!("../../data/gltf/dance.glb");
const DANCE_GLTF: &[u8] = include_bytes!("../../data/gltf/dance.gltf");
const AMASS: &[u8] = include_bytes!("../../data/smpl/amass_h.npz");
const POSES: &[u8] = include_bytes!("../../data/webavatar/small_poses.json");
const MODEL: &[u8] = include_bytes!("../../data/webavatar/small.npz");

/// Files, and the endings that they have.
const FILES: [(&str, &[u8]); 15] = [
    ("ply", TRUTH.bytes),
    ("splat", SPLAT.bytes),
    ("spz", SPZ_2.bytes),
    ("spz", SPZ_4.bytes),
    ("ksplat", KSPLAT_1.bytes),
    ("sog", SOG_2.bytes),
    ("glb", GLB.bytes),
    ("gltf", GLTF.bytes),
    ("bvh", BVH),
    ("glb", DANCE),
    ("fbx", include_bytes!("../../data/fbx/walk.fbx")),
    ("npz", AMASS),
    ("npz", MODEL),
    ("pkl", include_bytes!("../../data/smpl/wham_output.pkl")),
    ("pt", include_bytes!("../../data/smpl/hmr4d_results.pt")),
];

fn what_is_packed_reads_as_it_does_alone() {
    for (ending, bytes) in FILES {
        let name = format!("scene.{ending}");
        let plain = read(bytes, &name).unwrap_or_else(|fault| panic!("{name}: {fault}"));
        let inner = format!("Living room/scan.{ending}");
        let litter = b"\0\x05\x16\x07".as_slice();
        let apple = format!("__MACOSX/Living room/._scan.{ending}");
        let zipped = zip(&[
            ("Living room/", b""),
            (&inner, bytes),
            (&apple, litter),
            ("Living room/LICENSE.txt", b"none"),
            ("Living room/thumbnail.png", b"\x89PNG"),
        ]);
        let gzipped = format!("scene.{ending}.gz");
        for (packed, name) in [
            (zipped.clone(), "scene.zip"),
            (gzip(bytes), gzipped.as_str()),
            (gzip(&zipped), "scene.zip.gz"),
            (zip(&[("all/inner.zip.gz", &gzip(&zipped))]), "scene.zip"),
        ] {
            let read = read(&packed, name).unwrap_or_else(|fault| panic!("{name}: {fault}"));
            let same = match (read, &plain) {
                (Read::Avatar(mut read), Read::Avatar(plain)) => {
                    read.name = plain.name.clone();
                    read == *plain
                }
                (read, plain) => read == *plain,
            };
            assert!(same, "{ending} in {name}");
            let is = |bytes: &[u8], name: &str| Content::of(bytes, Path::new(name));
            assert_eq!(
                is(&packed, name),
                is(bytes, &format!("a.{ending}")),
                "{name}"
            );
        }
    }
}

fn marks_before_text_are_none_of_it() {
    let ascii = "ply\nformat ascii 1.0\nelement vertex 1\n";
    let names =
        "x y z scale_0 scale_1 scale_2 rot_0 rot_1 rot_2 rot_3 opacity f_dc_0 f_dc_1 f_dc_2";
    let properties: String = names
        .split(' ')
        .map(|name| format!("property float {name}\n"))
        .collect();
    let ascii = format!("{ascii}{properties}end_header\n{}\n", "0.5 ".repeat(14));
    for (name, text) in [
        ("a.ply", ascii.as_bytes()),
        ("a.gltf", GLTF.bytes),
        ("a.bvh", BVH),
        ("a.gltf", DANCE_GLTF),
        ("a.json", POSES),
    ] {
        let plain = read(text, name).unwrap();
        let utf16 = || String::from_utf8_lossy(text).into_owned();
        let units: Vec<u16> = utf16().encode_utf16().collect();
        let little = units.iter().flat_map(|unit| unit.to_le_bytes());
        let big = units.iter().flat_map(|unit| unit.to_be_bytes());
        for marked in [
            [b"\xEF\xBB\xBF", text].concat(),
            b"\xFF\xFE".iter().copied().chain(little).collect(),
            b"\xFE\xFF".iter().copied().chain(big).collect(),
        ] {
            assert_eq!(read(&marked, name).as_ref(), Ok(&plain), "{name}");
        }
    }
    let camera = br#"[{"width":9,"height":9,"position":[0,0,0],"rotation":[[1,0,0],[0,1,0],[0,0,1]],"fx":9,"fy":9}]"#;
    let plain = cameras::parse(camera, DAffine3::IDENTITY);
    let marked = [&b"\xEF\xBB\xBF"[..], camera].concat();
    assert_eq!(cameras::parse(&marked, DAffine3::IDENTITY), plain);
    assert!(plain.is_ok());
    // The document of a SOG.
    let mut members = vec![];
    let mut archive = ZipArchive::new(Cursor::new(SOG_2.bytes)).unwrap();
    for index in 0..archive.len() {
        let mut entry = archive.by_index(index).unwrap();
        let name = entry.name().unwrap().into_owned();
        let mut bytes = vec![];
        std::io::Read::read_to_end(&mut entry, &mut bytes).unwrap();
        if name == "meta.json" {
            bytes.splice(0..0, *b"\xEF\xBB\xBF");
        }
        members.push((format!("scan/{name}"), bytes));
    }
    let members: Vec<(&str, &[u8])> = members.iter().map(|(a, b)| (&a[..], &b[..])).collect();
    assert_eq!(read(&zip(&members), "a.sog"), read(SOG_2.bytes, "a.sog"));
}

fn an_spz_without_its_gzip_is_read() {
    assert_eq!(
        read(&gunzip(SPZ_2.bytes), "a.spz"),
        read(SPZ_2.bytes, "a.spz")
    );
    let cut = read(&gunzip(SPZ_2.bytes)[..100], "a.spz").unwrap_err();
    assert!(cut.contains("the file is incomplete"), "{cut}");
}

/// The same GLB with its document padded and counted in other ways.
fn padded(glb: &[u8], padding: u8, is_counted: bool, length: usize) -> Vec<u8> {
    let word = |at: usize| u32::from_le_bytes(glb[at..at + 4].try_into().unwrap()) as usize;
    let document = glb[20..20 + word(12)].trim_ascii_end();
    let rest = &glb[20 + word(12)..];
    let padding = vec![padding; length];
    let counted = document.len() + if is_counted { padding.len() } else { 0 };
    let total = 20 + document.len() + padding.len() + rest.len();
    let mut bytes = b"glTF\x02\0\0\0".to_vec();
    bytes.extend((total as u32).to_le_bytes());
    bytes.extend((counted as u32).to_le_bytes());
    bytes.extend(b"JSON");
    bytes.extend([document, &padding, rest].concat());
    bytes
}

fn a_glb_may_be_padded_in_any_way() {
    for (what, glb) in [("splats", GLB.bytes), ("motion", DANCE)] {
        let plain = read(glb, "a.glb");
        assert!(plain.is_ok());
        for length in 0..4 {
            for (padding, is_counted) in [(b' ', true), (b' ', false), (0, true), (0, false)] {
                let bytes = padded(glb, padding, is_counted, length);
                let read = read(&bytes, "a.glb");
                assert_eq!(
                    read, plain,
                    "{what}: {length} of {padding}, counted {is_counted}"
                );
            }
        }
        let zeros = [glb, &[0; 64]].concat();
        assert_eq!(read(&zeros, "a.glb"), plain, "{what}");
    }
}

fn what_a_zip_has_is_named() {
    let ply = TRUTH.bytes;
    let cases: [(Vec<u8>, &str); 9] = [
        (
            zip(&[
                ("a/7000/p.ply", ply),
                ("a/30000/p.ply", ply),
                ("a/cfg_args", b"x"),
            ]),
            "found a zip of `a/7000/p.ply`, `a/30000/p.ply`, `a/cfg_args`, expected one file that is read: unpack",
        ),
        (
            zip(&[("scene.usda", b"#usda 1.0\n")]),
            "found a zip of `scene.usda`, expected another format than USD",
        ),
        (
            zip(&[("doc.kml", b"<kml/>")]),
            "found a zip of `doc.kml`, expected a file in it that is read",
        ),
        (zip(&[]), "found a zip of nothing"),
        (zip(&[("a.obj", b"v 0 0 0\n")]), "found a zip of `a.obj`"),
        (
            zip(&[("a.ply", b"ply\nno header")]),
            "a header without `end_header`",
        ),
        (gzip(b"\x89PNG\r\n"), "found a PNG picture"),
        (gzip(ply)[..4000].to_vec(), "in a gzip"),
        (
            zip(&[("a.ply", ply)])[..4000].to_vec(),
            "a zip without its end: the file is incomplete",
        ),
    ];
    for (bytes, expected) in cases {
        let found = read(&bytes, "a").unwrap_err();
        assert!(found.contains(expected), "{found}, expected {expected}");
    }
    let mut nested = zip(&[("a.ply", ply)]);
    for _ in 0..6 {
        nested = zip(&[("a.npz", &nested)]);
    }
    let found = read(&nested, "a").unwrap_err();
    assert!(found.contains("archives in archives"), "{found}");
}

/// What is unpacked is bounded by the file's size before memory is taken for it.
fn bombs_are_refused() {
    let zeros = vec![0; 80 << 20];
    for bytes in [
        zip(&[("a.ply", &zeros)]),
        gzip(&zeros),
        gzip(&gzip(&zeros)),
        zip(&[("a.ply.gz", &gzip(&zeros))]),
    ] {
        let (found, peak) = memory::peak(|| read(&bytes, "a").unwrap_err());
        assert!(found.contains("more than"), "{found}");
        assert!(peak < 4 * bytes.len() + (68 << 20), "{peak} bytes");
    }
}

/// An archive in an archive has no more room than the outermost, whatever its reader would let one of
/// its size have.
fn bombs_in_archives_are_refused() {
    let zeros = vec![0; 80 << 20];
    let padding = &zeros[..24 << 20];
    // Of 24 MB that deflate to nothing, so that 16 times as much is in its reader's limit.
    let padded = |name: &str, own: &str| {
        let mut writer = ZipWriter::new(Cursor::new(Vec::new()));
        let stored = SimpleFileOptions::default().compression_method(CompressionMethod::Stored);
        let deflated = SimpleFileOptions::default();
        for (name, bytes, options) in [
            (own, &b"{}"[..], stored),
            ("pad.npy", padding, stored),
            (name, &zeros, deflated),
        ] {
            writer.start_file(name, options).unwrap();
            writer.write_all(bytes).unwrap();
        }
        writer.finish().unwrap().into_inner()
    };
    let motion = padded("poses.npy", "note");
    let sog = padded("means_l.webp", "meta.json");
    let model = padded("_xyz.npy", "note");
    for bytes in [
        zip(&[("a.npz", &motion)]),
        gzip(&motion),
        zip(&[("a.zip.gz", &gzip(&zip(&[("a.npz", &motion)])))]),
        gzip(&zip(&[("a.sog", &sog)])),
        gzip(&sog),
        zip(&[("a.npz", &model)]),
    ] {
        assert!(bytes.len() < 1 << 20);
        let (found, peak) = memory::peak(|| read(&bytes, "a").unwrap_err());
        assert!(found.contains("in an archive in an archive"), "{found}");
        assert!(peak < 68 << 20, "{peak} bytes");
    }
}

/// Of 3DGS' output the last training is read, and that is said.
fn of_iterations_in_a_zip_the_highest_is_read() {
    let of = |iteration: u32| format!("out/point_cloud/iteration_{iteration}/point_cloud.ply");
    let bytes = zip(&[
        ("out/input.ply", b"ply\n"),
        (&of(7000), b"ply\n"),
        (&of(30000), TRUTH.bytes),
        ("out/cameras.json", b"[]"),
    ]);
    let imported = |bytes: &[u8], up| {
        let options = read::OpenOptions {
            up,
            ..Default::default()
        };
        read::avatar(
            Source::new(bytes, Path::new("out.zip"), &mut Nothing),
            &options,
        )
        .unwrap()
    };
    let plain = imported(TRUTH.bytes, None);
    let found = imported(&bytes, None);
    assert_eq!(found.avatar, plain.avatar);
    let [ref chosen, ref rest @ ..] = found.assumptions[..] else {
        panic!("nothing is said")
    };
    assert_eq!(rest, plain.assumptions);
    let expected = format!(
        "file of the zip: `{}` (of its 3 .ply it has the highest iteration)",
        of(30000)
    );
    assert_eq!(chosen.to_string(), expected);
}

/// Which axis points up is asked where a file doesn't say it, packed or not.
fn the_axis_that_is_named_is_no_question() {
    let asks = |bytes: &[u8], up| {
        let mut beside = Nothing;
        let source = Source::new(bytes, Path::new("a"), &mut beside);
        let found = read::splats(source, up).unwrap();
        found.assumptions.iter().any(|own| own.what == Up::QUESTION)
    };
    let comment = b"ply\ncomment effigy up -z\n";
    let named = [&comment[..], TRUTH.bytes.strip_prefix(b"ply\n").unwrap()].concat();
    for (bytes, is_asked) in [
        (TRUTH.bytes, true),
        (&named, false),
        (SPLAT.bytes, true),
        (SOG_2.bytes, true),
        (KSPLAT_1.bytes, true),
        (SPZ_2.bytes, false),
        (GLB.bytes, false),
    ] {
        for packed in [bytes.to_vec(), zip(&[("a.ply", bytes)]), gzip(&gzip(bytes))] {
            assert_eq!(asks(&packed, None), is_asked);
            assert!(!asks(&packed, Some(Up::Y)));
        }
    }
}

tests! {
    bombs_in_archives_are_refused,
    of_iterations_in_a_zip_the_highest_is_read,
    the_axis_that_is_named_is_no_question,
    what_is_packed_reads_as_it_does_alone,
    marks_before_text_are_none_of_it,
    an_spz_without_its_gzip_is_read,
    a_glb_may_be_padded_in_any_way,
    what_a_zip_has_is_named,
    bombs_are_refused,
}
