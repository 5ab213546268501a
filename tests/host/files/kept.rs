//! Files of every version are read for ever: one of each is kept in tests/data/kept, as the program
//! wrote it that brought the version. `EFFIGY_KEEP=1` writes those that are missing; none is ever
//! written again.

use super::{bare, clip_bytes, scans::scan, tiny};
use crate::common;
use effigy_core::{
    avatar::{Avatar, Clip, Filter},
    io::pack::PackQuality,
};
use std::path::{Path, PathBuf};

fn kept(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/data/kept");
    folder.join(name)
}

/// The bytes of a kept file. `write`: the file, as today's program makes it.
fn bytes(name: &str, write: impl Fn() -> Vec<u8>) -> Vec<u8> {
    let path = kept(name);
    if !path.exists() && std::env::var_os("EFFIGY_KEEP").is_some() {
        std::fs::write(&path, write()).expect("the folder of kept files");
    }
    std::fs::read(&path).expect("a file of each version is kept")
}

fn avatars_of_version_1_are_read() {
    let read = Avatar::from_bytes(&bytes("1.avatar", || bare().to_bytes().unwrap())).unwrap();
    assert_eq!(read, bare());
}

fn avatars_of_version_2_are_read() {
    let packed = |quality| bare().packed(quality);
    for (name, quality) in [
        ("2-lossless.avatar", PackQuality::Lossless),
        ("2-small.avatar", PackQuality::Small),
    ] {
        let write = || packed(quality).to_packed_bytes().unwrap();
        let read = Avatar::from_bytes(&bytes(name, write)).unwrap();
        assert_eq!(read, packed(quality), "{name}");
    }
}

fn avatars_of_version_3_are_read() {
    let filtered = |quality| {
        let avatar = Avatar {
            filter: Filter {
                variance: 0.1,
                compensated: true,
            },
            ..bare()
        };
        match quality {
            Some(quality) => avatar.packed(quality),
            None => avatar,
        }
    };
    for (name, quality) in [
        ("3.avatar", None),
        ("3-small.avatar", Some(PackQuality::Small)),
    ] {
        let avatar = filtered(quality);
        let write = || match quality {
            Some(_) => avatar.to_packed_bytes().unwrap(),
            None => avatar.to_bytes().unwrap(),
        };
        let read = Avatar::from_bytes(&bytes(name, write)).unwrap();
        assert_eq!(read, avatar, "{name}");
    }
}

fn splats_of_version_4_are_read() {
    for (name, quality) in [
        ("4.avatar", PackQuality::Lossless),
        ("4-high.avatar", PackQuality::High),
    ] {
        let avatar = scan().packed(quality);
        let write = || match quality {
            PackQuality::Lossless => avatar.to_bytes().unwrap(),
            _ => avatar.to_packed_bytes().unwrap(),
        };
        let read = Avatar::from_bytes(&bytes(name, write)).unwrap();
        assert_eq!(read, avatar, "{name}");
    }
}

fn avatars_of_version_5_are_read() {
    let faced = common::with_levels(common::faced(bare()));
    let packed = faced.packed(PackQuality::Small);
    for (name, avatar) in [("5.avatar", faced), ("5-small.avatar", packed)] {
        let write = || match name {
            "5.avatar" => avatar.to_bytes().unwrap(),
            _ => avatar.to_packed_bytes().unwrap(),
        };
        let read = Avatar::from_bytes(&bytes(name, write)).unwrap();
        assert_eq!(read, avatar, "{name}");
    }
}

fn levels_of_detail_are_read() {
    let packed = tiny().packed(PackQuality::High);
    let write = || packed.to_packed_bytes().unwrap();
    let read = Avatar::from_bytes(&bytes("2-levels.avatar", write)).unwrap();
    assert_eq!(read, packed);
}

fn motion_of_version_1_is_read() {
    let read = Clip::from_bytes(&bytes("1.motion", clip_bytes)).unwrap();
    assert_eq!(read, Clip::from_bytes(&clip_bytes()).unwrap());
}

tests! {
    avatars_of_version_1_are_read,
    avatars_of_version_2_are_read,
    avatars_of_version_3_are_read,
    splats_of_version_4_are_read,
    avatars_of_version_5_are_read,
    levels_of_detail_are_read,
    motion_of_version_1_is_read,
}
