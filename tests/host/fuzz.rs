//! Every reader on prefixes of files and on edited files: every prefix, and `EFFIGY_FUZZ_SECONDS` of
//! edits, 100,000 at least; a few prefixes and a fraction of a second unless it is set. The files of
//! tests/data are the corpus. A failure leaves the file that caused it in the system's folder for
//! temporary files, and says where.

use crate::memory;
use crate::work::seconds_of_work;
use effigy_core::{
    avatar::Skeleton,
    glam::DAffine3,
    io::{
        cameras,
        file::{FileContent, FormatError},
    },
    random::hash,
};
use effigy_formats::{
    bvh,
    capture::Captured,
    fbx, gltf_motion,
    mmlphuman::Checkpoint,
    pickle::Pickle,
    read::{self, Source},
    retarget::{self, Girth, RetargetOptions},
    smpl,
    splats::{self, Nothing, SplatFormat},
    webavatar,
};
use std::{
    panic::{AssertUnwindSafe, catch_unwind},
    path::Path,
    sync::OnceLock,
    time::{Duration, Instant},
};

/// Seconds for each reader where nobody says: what a test may take.
const SECONDS: f64 = 0.3;
/// Bytes that reading any file may take, beside four times its size.
const SMALL: usize = 64 << 20;
/// Seconds that reading a file of the corpus's size takes at most: an optimised build takes a
/// twentieth of what a debug build takes.
const SLOWEST: f64 = 5.0;

/// A source of numbers that is the same in each run.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = hash(self.0);
        self.0
    }

    fn below(&mut self, limit: usize) -> usize {
        (self.next() % limit.max(1) as u64) as usize
    }
}

/// Numbers that readers stumble over.
const ODD: [&[u8]; 14] = [
    &[0xff; 4],
    &[0xff; 8],
    &[0; 4],
    &[0; 8],
    &[0xff, 0xff, 0xff, 0x7f],
    &[0, 0, 0, 0x80],
    &[0, 0, 0xc0, 0x7f],
    &[0, 0, 0x80, 0xff],
    b"-1",
    b"NaN",
    b"1e999",
    b"99999999999999999999",
    b"{[",
    b"\n\n",
];

/// Edits a file in one to six places.
fn edited(random: &mut Random, corpus: &[&[u8]]) -> Vec<u8> {
    let mut bytes = corpus[random.below(corpus.len())].to_vec();
    for _ in 0..=random.below(6) {
        let at = random.below(bytes.len() + 1);
        let end = (at + 1 + random.below(64)).min(bytes.len());
        match random.below(8) {
            0 | 1 => {
                if let Some(byte) = bytes.get_mut(at) {
                    *byte ^= 1 << random.below(8);
                }
            }
            2 => {
                if let Some(byte) = bytes.get_mut(at) {
                    *byte = random.next() as u8;
                }
            }
            3 => {
                let odd = ODD[random.below(ODD.len())];
                let end = (at + odd.len()).min(bytes.len());
                bytes.splice(at..end, odd.iter().copied());
            }
            4 => {
                bytes.drain(at..end);
            }
            5 => {
                let again = bytes[at..end].to_vec();
                bytes.splice(at..at, again);
            }
            6 => {
                let other = corpus[random.below(corpus.len())];
                let from = random.below(other.len());
                let piece = &other[from..(from + end - at).min(other.len())];
                bytes.splice(at..end, piece.iter().copied());
            }
            _ => {
                if random.below(8) == 0 {
                    bytes.truncate(at);
                }
            }
        }
    }
    bytes
}

/// How long to read edited files of a reader, and how many there are at least.
struct Effort {
    seconds: f64,
    edits: usize,
    /// Prefixes of a file, evenly spaced.
    prefixes: usize,
    /// Seconds that a file may take.
    slowest: f64,
}

impl Effort {
    /// What the environment asks for.
    fn asked() -> Self {
        match std::env::var("EFFIGY_FUZZ_SECONDS") {
            Ok(text) => Self {
                seconds: text.parse().expect("a number of seconds"),
                edits: 100_000,
                prefixes: usize::MAX,
                slowest: 1.0,
            },
            Err(_) => Self {
                seconds: SECONDS,
                edits: 1,
                prefixes: 40,
                slowest: SLOWEST,
            },
        }
    }
}

type Read<'a> = &'a dyn Fn(&[u8]) -> Result<(), FormatError>;

/// Reads a file, which must end soon, in little memory and without a panic. Whether it is refused.
fn is_refused(name: &str, what: &str, bytes: &[u8], effort: &Effort, read: Read) -> bool {
    let start = seconds_of_work();
    let caught = catch_unwind(AssertUnwindSafe(|| memory::peak(|| read(bytes).is_err())));
    let fault = match caught {
        Err(_) => "it panicked".to_owned(),
        Ok((_, peak)) if peak > 4 * bytes.len() + SMALL => format!("it took {peak} bytes"),
        Ok(_) if seconds_of_work() - start > effort.slowest => {
            format!("it took {} s", seconds_of_work() - start)
        }
        Ok((is_refused, _)) => return is_refused,
    };
    let file = std::env::temp_dir().join(format!("effigy-fuzz-{name}"));
    std::fs::write(&file, bytes).expect("a folder for temporary files");
    panic!("{name}, {what}, {}: {fault}", file.display());
}

/// Reads prefixes of the files, then edited files until the time is over.
fn fuzz(name: &str, corpus: &[&[u8]], read: Read) {
    let effort = Effort::asked();
    let mut prefixes = 0;
    for file in corpus {
        for end in (0..file.len()).step_by(file.len().div_ceil(effort.prefixes)) {
            is_refused(name, &format!("prefix {end}"), &file[..end], &effort, read);
            prefixes += 1;
        }
    }
    let end = Instant::now() + Duration::from_secs_f64(effort.seconds);
    let mut random = Random(hash(name.len() as u64));
    let mut refused = 0;
    let mut count = 0;
    while count < effort.edits || Instant::now() < end {
        let bytes = edited(&mut random, corpus);
        let what = format!("edit {count}");
        refused += usize::from(is_refused(name, &what, &bytes, &effort, read));
        count += 1;
    }
    assert!(refused > 0, "{name}: {refused} of {count}");
    println!("{name}: {prefixes} prefixes, {count} edited files, {refused} of them refused");
}

fn skeleton() -> Skeleton {
    effigy_demo::avatar().expect("the demo").skeleton
}

/// The demo's thickness, measured once.
fn girth() -> Option<Girth> {
    static GIRTH: OnceLock<Option<Girth>> = OnceLock::new();
    GIRTH
        .get_or_init(|| Girth::of(&effigy_demo::avatar().expect("the demo")))
        .clone()
}

/// Moves the demo by what a reader gives.
fn retarget(skeleton: &Skeleton, captured: &Captured) {
    // A long motion takes its time, and nothing else.
    if captured.capture.frames() <= 64 && captured.capture.duration() < 1e4 {
        let options = RetargetOptions {
            rate: Some(if captured.capture.duration() < 10.0 {
                30.0
            } else {
                0.5
            }),
            girth: girth(),
            ..RetargetOptions::default()
        };
        let _ = retarget::retarget(&captured.capture, skeleton, "edited", &options);
    }
}

fn edited_avatars_and_clips() {
    let corpus: [&[u8]; 8] = [
        include_bytes!("../data/kept/1.avatar"),
        include_bytes!("../data/kept/1.motion"),
        include_bytes!("../data/kept/2-levels.avatar"),
        include_bytes!("../data/kept/2-lossless.avatar"),
        include_bytes!("../data/kept/2-small.avatar"),
        include_bytes!("../data/kept/3-small.avatar"),
        include_bytes!("../data/kept/3.avatar"),
        include_bytes!("../data/kept/5-small.avatar"),
    ];
    fuzz("avatar", &corpus, &|bytes| {
        if let FileContent::Avatar(avatar) = FileContent::from_bytes(bytes)? {
            avatar.check()?;
        }
        Ok(())
    });
}

fn edited_cameras() {
    let corpus: [&[u8]; 2] = [
        br#"[{"id": 0, "img_name": "a", "width": 640, "height": 480, "position": [0, 0, -2],
            "rotation": [[0, -1, 0], [1, 0, 0], [0, 0, 1]], "fy": 500, "fx": 400}]"#,
        br#"[{"cam_id": "00", "w2c": [[0, 1, 0, 0], [-1, 0, 0, 0], [0, 0, 1, 2], [0, 0, 0, 1]],
            "K": [[400, 0, 320], [0, 500, 240], [0, 0, 1]]}]"#,
    ];
    fuzz("cameras", &corpus, &|bytes| {
        let cameras = cameras::parse(bytes, DAffine3::IDENTITY)?;
        assert!(cameras.iter().all(|camera| camera.view.is_finite()));
        Ok(())
    });
}

/// What tells the kinds apart, on all of them.
fn edited_files_of_every_kind() {
    let skeleton = skeleton();
    let corpus: [&[u8]; 14] = [
        include_bytes!("../data/kept/2-small.avatar"),
        include_bytes!("../data/kept/1.motion"),
        include_bytes!("../data/motion/nameless.bvh"),
        include_bytes!("../data/smpl/amass_h.npz"),
        include_bytes!("../data/smpl/wham_output.pkl"),
        include_bytes!("../data/gltf/vrm1.vrm"),
        include_bytes!("../data/fbx/walk.fbx"),
        include_bytes!("../data/webavatar/wide.npz"),
        include_bytes!("../data/webavatar/small_poses.json"),
        include_bytes!("../data/splats/truth.ply"),
        include_bytes!("../data/splats/small.sog"),
        include_bytes!("../data/splats/small-2.spz"),
        include_bytes!("../data/splats/small-2.ksplat"),
        include_bytes!("../data/splats/packed.glb"),
    ];
    fuzz("any", &corpus, &|bytes| {
        let name = Path::new("edited");
        let mut beside = Nothing;
        let source = Source::new(bytes, name, &mut beside);
        if source.content().is_motion() {
            let captured = read::capture(source, &Default::default())?;
            retarget(&skeleton, &captured);
            return Ok(());
        }
        read::avatar(source, &Default::default()).map(drop)
    });
}

fn edited_bvh_files() {
    let skeleton = skeleton();
    let corpus: [&[u8]; 3] = [
        include_bytes!("../data/motion/poser_wild.bvh"),
        include_bytes!("../data/motion/bandai.bvh"),
        include_bytes!("../data/motion/nameless.bvh"),
    ];
    fuzz("bvh", &corpus, &|bytes| {
        retarget(&skeleton, &bvh::from_bytes(bytes)?);
        Ok(())
    });
}

fn edited_files_of_smpl() {
    let skeleton = skeleton();
    let corpus: [&[u8]; 13] = [
        include_bytes!("../data/smpl/amass_h.npz"),
        include_bytes!("../data/smpl/amass_x.npz"),
        include_bytes!("../data/smpl/romp_frames.npz"),
        include_bytes!("../data/smpl/romp_picture.npz"),
        include_bytes!("../data/smpl/aist_5.pkl"),
        include_bytes!("../data/smpl/hps_track_0.npy"),
        include_bytes!("../data/smpl/smpl_params.npz"),
        include_bytes!("../data/smpl/romp_video.npz"),
        include_bytes!("../data/smpl/aist_2.pkl"),
        include_bytes!("../data/smpl/wham_output.pkl"),
        include_bytes!("../data/smpl/demo_gymnasts.pkl"),
        include_bytes!("../data/smpl/hmr4d_results.pt"),
        include_bytes!("../data/smpl/hmr4d_results_legacy.pt"),
    ];
    fuzz("smpl", &corpus, &|bytes| {
        retarget(&skeleton, &smpl::from_bytes(bytes, &Default::default())?);
        Ok(())
    });
}

fn edited_gltf_files() {
    let skeleton = skeleton();
    let corpus: [&[u8]; 5] = [
        include_bytes!("../data/gltf/dance.glb"),
        include_bytes!("../data/gltf/dance.gltf"),
        include_bytes!("../data/gltf/dance.vrma"),
        include_bytes!("../data/gltf/vrm0.vrm"),
        include_bytes!("../data/gltf/vrm1.vrm"),
    ];
    fuzz("gltf", &corpus, &|bytes| {
        let read = gltf_motion::from_bytes(bytes, &Default::default(), &mut |_| None);
        retarget(&skeleton, &read?);
        Ok(())
    });
}

fn edited_fbx_files() {
    let skeleton = skeleton();
    let corpus: [&[u8]; 1] = [include_bytes!("../data/fbx/walk.fbx")];
    fuzz("fbx", &corpus, &|bytes| {
        retarget(&skeleton, &fbx::from_bytes(bytes, &Default::default())?);
        Ok(())
    });
}

fn edited_models_and_poses() {
    let corpus: [&[u8]; 2] = [
        include_bytes!("../data/webavatar/small.npz"),
        include_bytes!("../data/webavatar/wide.npz"),
    ];
    fuzz("webavatar", &corpus, &|bytes| {
        webavatar::from_bytes(bytes, "edited", &Default::default()).map(drop)
    });
    let corpus: [&[u8]; 1] = [include_bytes!("../data/mmlphuman/chkpnt800000.pth")];
    fuzz("mmlphuman", &corpus, &|bytes| {
        let pickle = Pickle::from_bytes(bytes)?;
        let checkpoint = Checkpoint::new(&pickle, &Default::default())?;
        checkpoint.networks.network(0).map(drop)
    });
    let skeleton = skeleton();
    let corpus: [&[u8]; 1] = [include_bytes!("../data/webavatar/small_poses.json")];
    fuzz("poses", &corpus, &|bytes| {
        retarget(&skeleton, &webavatar::capture_poses(bytes, None)?);
        Ok(())
    });
}

fn edited_splats() {
    let files: [(SplatFormat, &[&[u8]]); 7] = [
        (
            SplatFormat::Ply,
            &[
                include_bytes!("../data/splats/truth.ply"),
                include_bytes!("../data/splats/small.compressed.ply"),
            ],
        ),
        (
            SplatFormat::Splat,
            &[include_bytes!("../data/splats/small.splat")],
        ),
        (
            SplatFormat::Spz,
            &[
                include_bytes!("../data/splats/small-2.spz"),
                include_bytes!("../data/splats/small-4.spz"),
                include_bytes!("../data/splats/small-v1.spz"),
                include_bytes!("../data/splats/small-js.spz"),
            ],
        ),
        (
            SplatFormat::Sog,
            &[
                include_bytes!("../data/splats/small.sog"),
                include_bytes!("../data/splats/small-v1.sog"),
            ],
        ),
        (
            SplatFormat::Ksplat,
            &[
                include_bytes!("../data/splats/small-0.ksplat"),
                include_bytes!("../data/splats/small-1.ksplat"),
                include_bytes!("../data/splats/small-2.ksplat"),
            ],
        ),
        (
            SplatFormat::Glb,
            &[
                include_bytes!("../data/splats/small.glb"),
                include_bytes!("../data/splats/packed.glb"),
            ],
        ),
        (
            SplatFormat::Gltf,
            &[include_bytes!("../data/splats/small.gltf")],
        ),
    ];
    for (format, corpus) in files {
        fuzz(&format!("{format:?}"), corpus, &|bytes| {
            let found = splats::read(bytes, format, &mut Nothing)?;
            found.splats.to_avatar("edited").map(drop)
        });
    }
}

tests! {
    edited_avatars_and_clips,
    edited_cameras,
    edited_files_of_every_kind,
    edited_bvh_files,
    edited_files_of_smpl,
    edited_gltf_files,
    edited_fbx_files,
    edited_models_and_poses,
    edited_splats,
}
