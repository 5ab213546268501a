//! Files of 48 MB that are hostile, `EFFIGY_LARGE_MB` of them else 2: read or refused in under a second of work, in at
//! most 4 times the file's size and 64 MB of memory. A failure leaves the file in the system's folder
//! for temporary files, and says where.

use crate::memory;
use crate::work::seconds_of_work;
use effigy_core::glam::DAffine3;
use effigy_core::io::cameras;
use effigy_core::io::file::FormatError;
use effigy_formats::{
    read::{self, Source},
    splats::Nothing,
};
use std::io::{Cursor, Write};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use zip::{CompressionMethod, ZipWriter, write::SimpleFileOptions};

/// Bytes that reading any file may take, beside four times its size.
const SMALL: usize = 64 << 20;
/// Bytes of what a reader may say.
const LONGEST: usize = 1000;

/// How large the files are, and how long one may take.
struct Scale {
    bytes: usize,
    seconds: f64,
}

impl Scale {
    fn asked() -> Self {
        match std::env::var("EFFIGY_LARGE_MB") {
            Ok(text) => Self {
                bytes: text.parse::<usize>().expect("a number of MB") << 20,
                seconds: 1.0,
            },
            // Readers that are not optimised take some twenty times as long.
            Err(_) => Self {
                bytes: 2 << 20,
                seconds: 3.0,
            },
        }
    }
}

/// Reads a file of any kind.
fn read(bytes: &[u8]) -> Result<(), FormatError> {
    let mut beside = Nothing;
    let source = Source::new(bytes, Path::new("large"), &mut beside);
    if source.content().is_motion() {
        return read::capture(source, &Default::default()).map(drop);
    }
    read::avatar(source, &Default::default()).map(drop)
}

/// What is wrong with how a file is read.
fn fault(
    what: &str,
    bytes: &[u8],
    scale: &Scale,
    read: impl Fn(&[u8]) -> Result<(), FormatError>,
) -> Option<String> {
    let start = seconds_of_work();
    let caught = catch_unwind(AssertUnwindSafe(|| memory::peak(|| read(bytes).err())));
    let took = seconds_of_work() - start;
    let fault = match caught {
        Err(_) => "it panicked".to_owned(),
        Ok((_, peak)) if peak > 4 * bytes.len() + SMALL => {
            format!("{} bytes took {peak} of memory", bytes.len())
        }
        Ok(_) if took > scale.seconds => format!("it took {took:.2} s"),
        Ok((error, peak)) => {
            let said = error.map_or("read".into(), |error| error.to_string());
            println!("{what}: {took:.3} s, {} MB, {said:.200}", peak >> 20);
            if said.len() < LONGEST {
                return None;
            }
            format!("{} bytes of error", said.len())
        }
    };
    let file = std::env::temp_dir().join(format!("effigy-large-{}", what.replace(' ', "-")));
    std::fs::write(&file, bytes).expect("a folder for temporary files");
    Some(format!("{what}, {}: {fault}", file.display()))
}

/// A beginning, then the same over and over up to a length, then an end.
fn filled(start: &[u8], over: &[u8], end: &[u8], scale: &Scale) -> Vec<u8> {
    let room = scale.bytes.saturating_sub(start.len() + end.len());
    let times = room / over.len();
    [start, &over.repeat(times), end].concat()
}

/// Everything of test data that is one file.
const KINDS: [(&str, &[u8]); 20] = [
    ("avatar", include_bytes!("../data/kept/2-small.avatar")),
    ("plain avatar", include_bytes!("../data/kept/1.avatar")),
    ("motion", include_bytes!("../data/kept/1.motion")),
    ("bvh", include_bytes!("../data/motion/nameless.bvh")),
    ("amass", include_bytes!("../data/smpl/amass_h.npz")),
    ("pickle", include_bytes!("../data/smpl/wham_output.pkl")),
    ("torch", include_bytes!("../data/smpl/hmr4d_results.pt")),
    ("npy", include_bytes!("../data/smpl/hps_track_0.npy")),
    ("vrm", include_bytes!("../data/gltf/vrm1.vrm")),
    ("gltf", include_bytes!("../data/gltf/dance.gltf")),
    ("fbx", include_bytes!("../data/fbx/walk.fbx")),
    ("model", include_bytes!("../data/webavatar/wide.npz")),
    (
        "poses",
        include_bytes!("../data/webavatar/small_poses.json"),
    ),
    (
        "checkpoint",
        include_bytes!("../data/mmlphuman/chkpnt800000.pth"),
    ),
    ("ply", include_bytes!("../data/splats/truth.ply")),
    ("sog", include_bytes!("../data/splats/small.sog")),
    ("spz", include_bytes!("../data/splats/small-2.spz")),
    ("spz 4", include_bytes!("../data/splats/small-4.spz")),
    ("ksplat", include_bytes!("../data/splats/small-2.ksplat")),
    ("glb", include_bytes!("../data/splats/packed.glb")),
];

/// Fails with everything that is wrong.
fn check(faults: Vec<Option<String>>) {
    let faults: Vec<String> = faults.into_iter().flatten().collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

fn files_with_much_behind_them() {
    let scale = Scale::asked();
    let mut faults = vec![];
    for (name, bytes) in KINDS {
        for (what, over) in [
            ("zeros", &[0][..]),
            ("itself", bytes),
            ("spaces", b" "),
            ("ff", &[0xff]),
        ] {
            let file = filled(bytes, over, b"", &scale);
            faults.push(fault(&format!("{name} and {what}"), &file, &scale, read));
        }
        // In the middle, where the beginning announces something else.
        let middle = bytes.len() / 2;
        let file = filled(&bytes[..middle], &bytes[..middle], &bytes[middle..], &scale);
        faults.push(fault(&format!("{name} inside itself"), &file, &scale, read));
    }
    check(faults);
}

fn texts_that_go_on_and_on() {
    let scale = Scale::asked();
    let joint = b"JOINT a\n{\nOFFSET 0 0 0\nCHANNELS 3 Zrotation Xrotation Yrotation\n";
    let root = b"HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n";
    let leaf = b"JOINT a\n{\nOFFSET 0 0 0\nCHANNELS 3 Zrotation Xrotation Yrotation\nEnd Site\n{\nOFFSET 0 0 1\n}\n}\n";
    let frames = [
        &root[..],
        b"End Site\n{\nOFFSET 0 0 1\n}\n}\nMOTION\nFrames: 9000000\nFrame Time: 0.01\n",
    ]
    .concat();
    let gltf = br#"{"asset":{"version":"2.0"},"#;
    let of_gltf = |list: &str| [&gltf[..], format!("\"{list}\":[{{}}").as_bytes()].concat();
    let pose = |rest: &str| {
        let zeros = vec!["0"; 165].join(",");
        format!(r#",{{"frame_id":0,"pose":[{zeros}],"Th":[0,0,0],"Rh":[0,0,0]{rest}}}"#)
    };
    let poses = |over: &str| {
        filled(
            &[b"[", &over.as_bytes()[1..]].concat(),
            over.as_bytes(),
            b"]",
            &scale,
        )
    };
    let texts: [(&str, Vec<u8>); 36] = [
        ("poses", poses(&pose(""))),
        ("poses with expressions", poses(&pose(r#","expression":[0,0,0,0,0,0,0,0,0,0]"#))),
        ("bvh nested", filled(root, joint, b"", &scale)),
        ("bvh of leaves", filled(root, leaf, b"}\nMOTION\nFrames: 1\nFrame Time: 0.1\n", &scale)),
        ("bvh of numbers", filled(&frames, b"0 1 2 3 4 5\n", b"", &scale)),
        ("bvh of short numbers", filled(&frames, b"0 ", b"", &scale)),
        ("bvh of one number", filled(&frames, b"1", b"", &scale)),
        ("bvh of words", filled(root, b"a ", b"", &scale)),
        ("bvh of names", filled(b"HIERARCHY\nROOT ", b"a", b"", &scale)),
        ("brackets", filled(b"[", b"[", b"", &scale)),
        ("pairs of brackets", filled(b"[[]", b",[]", b"]", &scale)),
        ("braces", filled(b"{\"a\":", b"{\"a\":", b"", &scale)),
        ("empty poses", filled(b"[{}", b",{}", b"]", &scale)),
        ("poses without numbers", filled(br#"[{"frame_id":0,"pose":[],"Th":[],"Rh":[]}"#, br#",{"frame_id":0,"pose":[],"Th":[],"Rh":[]}"#, b"]", &scale)),
        ("poses of numbers", filled(br#"[{"frame_id":0,"pose":[0"#, b",0", b"]}]", &scale)),
        (
            "poses of a long turn",
            filled(br#"[{"frame_id":0,"pose":[],"Th":[0,0,0],"Rh":[0"#, b",0", b"]", &scale),
        ),
        (
            "poses of long rows",
            filled(br#"[{"frame_id":0,"pose":[],"Th":[0,0,0],"Rh":[[0"#, b",0", b"]", &scale),
        ),
        (
            "poses of a long name",
            filled(br#"[{"frame_id":[0"#, b",0", b"]", &scale),
        ),
        (
            "poses of expressions",
            filled(br#"[{"frame_id":0,"pose":[],"Th":[0,0,0],"Rh":[0,0,0],"expression":[0"#, b",0", b"]", &scale),
        ),
        ("a string", filled(b"[\"", b"a", b"\"]", &scale)),
        ("escapes", filled(b"[\"", b"\\u0041", b"\"]", &scale)),
        ("gltf nodes", filled(&of_gltf("nodes"), b",{}", b"]}", &scale)),
        ("gltf accessors", filled(&of_gltf("accessors"), b",{}", b"]}", &scale)),
        ("gltf buffers", filled(&of_gltf("buffers"), b",{}", b"]}", &scale)),
        ("gltf views", filled(&of_gltf("bufferViews"), b",{\"buffer\":0,\"byteLength\":1}", b"]}", &scale)),
        ("gltf animations", filled(&of_gltf("animations"), b",{\"channels\":[],\"samplers\":[]}", b"]}", &scale)),
        ("gltf of splats", filled(&of_gltf("KHR_gaussian_splatting"), b",{}", b"]}", &scale)),
        ("gltf children", filled(&[&gltf[..], br#""nodes":[{"children":[0"#].concat(), b",0", b"]}]}", &scale)),
        ("gltf extras", filled(&[&gltf[..], br#""extras":[0"#].concat(), b",0", b"]}", &scale)),
        ("ply of properties", filled(b"ply\nformat ascii 1.0\nelement vertex 1\n", b"property float x\n", b"end_header\n", &scale)),
        ("ply of comments", filled(b"ply\nformat ascii 1.0\n", b"comment\n", b"end_header\n", &scale)),
        ("ply of elements", filled(b"ply\nformat ascii 1.0\n", b"element a 0\n", b"end_header\n", &scale)),
        ("ply of one line", filled(b"ply\nformat ascii 1.0\ncomment ", b"a", b"", &scale)),
        ("ply of numbers", filled(b"ply\nformat ascii 1.0\nelement vertex 9000000\nproperty float x\nproperty float y\nproperty float z\nend_header\n", b"0 1 2\n", b"", &scale)),
        ("newlines", filled(b"", b"\n", b"", &scale)),
        ("zeros", filled(b"", &[0], b"", &scale)),
    ];
    let mut faults: Vec<_> = texts
        .iter()
        .map(|(what, bytes)| fault(what, bytes, &scale, read))
        .collect();
    let camera = br#",{"width":9,"height":9,"position":[0,0,0],"rotation":[[1,0,0],[0,1,0],[0,0,1]],"fx":9,"fy":9}"#;
    for (what, over) in [
        ("cameras of nothing", &b",{}"[..]),
        ("cameras of lists", b",[]"),
        ("cameras", camera),
    ] {
        let bytes = filled(&[b"[", &camera[1..]].concat(), over, b"]", &scale);
        let read = |bytes: &[u8]| cameras::parse(bytes, DAffine3::IDENTITY).map(drop);
        faults.push(fault(what, &bytes, &scale, read));
    }
    check(faults);
}

fn pickles_of_every_instruction() {
    let mut scale = Scale::asked();
    // There are a thousand of them.
    scale.bytes /= 8;
    let start = b"\x80\x04";
    let mut faults = vec![];
    for code in 0..=255u8 {
        // Arguments of a byte, of four, and of eight, all small.
        for argument in [&[][..], &[1], &[1, 0, 0, 0], &[1, 0, 0, 0, 0, 0, 0, 0]] {
            let over = [&[code][..], argument].concat();
            let bytes = filled(start, &over, b".", &scale);
            faults.push(fault(&format!("pickle of {over:?}"), &bytes, &scale, read));
        }
    }
    for (what, over) in [
        ("lists in lists", &b"](l"[..]),
        ("dictionaries", b"}(d"),
        ("twins", b"N2"),
        ("tuples of three", b"NNN\x87"),
        ("remembered", b"Nq\x01h\x01"),
        ("remembered twins", b"(h\x00h\x00t\x94"),
        ("names", b"ccollections\nOrderedDict\n"),
        ("made", b"ccollections\nOrderedDict\n)R"),
        ("strings", b"\x8c\x01a\x94"),
        ("numbers", b"K\x01"),
    ] {
        let bytes = filled(start, over, b".", &scale);
        faults.push(fault(&format!("pickle of {what}"), &bytes, &scale, read));
    }
    check(faults);
}

/// An archive of members with names of numbers and an ending.
fn archive(members: usize, ending: &str, content: &[u8], method: CompressionMethod) -> Vec<u8> {
    let mut writer = ZipWriter::new(Cursor::new(Vec::new()));
    let options = SimpleFileOptions::default().compression_method(method);
    for member in 0..members {
        let name = format!("{member}{ending}");
        writer.start_file(name, options).expect("memory");
        writer.write_all(content).expect("memory");
    }
    writer.finish().expect("memory").into_inner()
}

fn archives_of_many_and_of_much() {
    let scale = Scale::asked();
    // What a member takes of the file without content: its own record and the directory's.
    let many = scale.bytes / 130;
    let inner = archive(1, ".npy", &vec![0; 6 << 20], CompressionMethod::Deflated);
    let stored = CompressionMethod::Stored;
    let deflated = CompressionMethod::Deflated;
    let zeros = vec![0; 16 * scale.bytes];
    let files = [
        ("many arrays", archive(many, ".npy", b"", stored)),
        ("many pictures", archive(many, ".webp", b"", stored)),
        ("many of torch", archive(many, "/data.pkl", b"", stored)),
        (
            "nested",
            archive(
                (scale.bytes / inner.len()).min(9_999),
                ".npz",
                &inner,
                stored,
            ),
        ),
        ("a bomb", archive(1, ".npy", &zeros, deflated)),
        ("forty bombs", archive(40, ".npy", &zeros, deflated)),
    ];
    let faults = files
        .iter()
        .map(|(what, bytes)| fault(what, bytes, &scale, read));
    check(faults.collect());
}

tests! {
    archives_of_many_and_of_much,
    files_with_much_behind_them,
    pickles_of_every_instruction,
    texts_that_go_on_and_on,
}
