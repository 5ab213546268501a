//! What is wrong with a checkpoint is named; nothing in it makes the program panic or take memory
//! that the file does not justify.

use super::{SMALL, options};
use crate::memory;
use effigy_formats::{
    mmlphuman::{Checkpoint, Options},
    pickle::Pickle,
};
use effigy_learn::distil::distil;
use glam::DVec3;
use std::io::{Cursor, Read, Write};
use zip::{CompressionMethod, ZipArchive, ZipWriter, write::SimpleFileOptions};

/// An entry of the file, stored.
struct Member {
    name: String,
    bytes: Vec<u8>,
}

/// The file's entries by what stands behind the first slash.
fn members() -> Vec<Member> {
    let mut archive = ZipArchive::new(Cursor::new(SMALL)).unwrap();
    let mut read = |index: usize| {
        let mut entry = archive.by_index(index).unwrap();
        let name = entry.name().unwrap().split_once('/').unwrap().1.to_owned();
        let mut bytes = Vec::new();
        entry.read_to_end(&mut bytes).unwrap();
        Member { name, bytes }
    };
    let count = ZipArchive::new(Cursor::new(SMALL)).unwrap().len();
    (0..count).map(&mut read).collect()
}

fn archive(members: &[Member]) -> Vec<u8> {
    let mut writer = ZipWriter::new(Cursor::new(Vec::new()));
    let stored = SimpleFileOptions::default().compression_method(CompressionMethod::Stored);
    for member in members {
        writer
            .start_file(format!("a/{}", member.name), stored)
            .unwrap();
        writer.write_all(&member.bytes).unwrap();
    }
    writer.finish().unwrap().into_inner()
}

/// The file with another name in place of one as long; every occurrence.
fn renamed(from: &str, to: &str) -> Vec<u8> {
    let mut members = members();
    let pickle = members
        .iter_mut()
        .find(|own| own.name == "data.pkl")
        .unwrap();
    let mut at = 0;
    // With its length before it, so that no longer name is meant.
    let key = [&(from.len() as u32).to_le_bytes()[..], from.as_bytes()].concat();
    while let Some(found) = pickle.bytes[at..]
        .windows(key.len())
        .position(|own| own == key)
    {
        let start = at + found + 4;
        pickle.bytes[start..start + to.len()].copy_from_slice(to.as_bytes());
        at = start;
    }
    assert!(at > 0, "no {from}");
    archive(&members)
}

/// The file with a number in place of the first of a storage.
fn with_number(storage: usize, number: &[u8]) -> Vec<u8> {
    let mut members = members();
    let name = format!("data/{storage}");
    let own = members.iter_mut().find(|own| own.name == name).unwrap();
    own.bytes[..number.len()].copy_from_slice(number);
    archive(&members)
}

fn fault(bytes: &[u8]) -> String {
    let read = || {
        let pickle = Pickle::from_bytes(bytes)?;
        Checkpoint::new(&pickle, &Options::default()).map(drop)
    };
    match read() {
        Ok(()) => "none".into(),
        Err(error) => error.to_string(),
    }
}

/// Storages by the order in which PyTorch met them.
const XYZ: usize = 0;
const SCALING: usize = 3;
const ROTATION: usize = 4;
const WEIGHTS: usize = 8;
const PARENTS: usize = 90;
const NODES_OF_GAUSSIANS: usize = 92;
const ANCHORS_OF_GAUSSIANS: usize = 94;
const FIRST_LAYER: usize = 100;

fn a_missing_entry_is_named() {
    assert_eq!(fault(&archive(&members())), "none");
    for name in [
        "_xyz",
        "xyz_offset",
        "dxyz_vt",
        "_scaling",
        "_rotation",
        "_opacity",
        "_sh0",
        "_shN",
        "sh_degree",
        "_weights",
        "t_joints",
        "nbr_gs",
        "nbr_gs_invdist",
        "nbr_gsft",
        "nbr_gsft_wght",
        "nbr_vtft",
        "nbr_vtft_wght",
        "encoder_feat_params",
        "dxyz_bs",
        "sh0_bs",
        "shN_bs",
        "scaling_bs",
        "rotation_bs",
        "opacity_bs",
        "is_dxyz_bs",
        "is_gsparam_bs",
        "layers.0.weight",
        "layers.0.bias",
        "layers.6.bias",
    ] {
        let other = "?".repeat(name.len());
        let found = fault(&renamed(name, &other));
        assert!(
            found.contains(name) && found.contains("nothing"),
            "{name}: {found}"
        );
    }
    // Layers end where there is no next one: the bases do not fit the third's output.
    let found = fault(&renamed("layers.6.weight", "layers.7.weight"));
    assert!(
        found.contains("rotation_bs") && found.contains("10 outputs"),
        "{found}"
    );
}

fn what_may_be_missing_is_derived() {
    let truth = Pickle::from_bytes(SMALL).unwrap();
    let truth = Checkpoint::new(&truth, &Options::default()).unwrap();
    let bytes = renamed("joint_parents", "joint_parent?");
    let pickle = Pickle::from_bytes(&bytes).unwrap();
    let own = Checkpoint::new(&pickle, &Options::default()).unwrap();
    assert_eq!(own.skeleton, truth.skeleton);
    let taken = |what: &str| own.assumptions.iter().any(|own| own.what == what);
    assert!(taken("tree of joints"), "{:?}", own.assumptions);
    let bytes = renamed("xyz_vt", "xyz_vs");
    let pickle = Pickle::from_bytes(&bytes).unwrap();
    let own = Checkpoint::new(&pickle, &Options::default()).unwrap();
    let off = own.nodes.position.iter().zip(&truth.nodes.position);
    let off: Vec<f64> = off.map(|(a, b): (&DVec3, &DVec3)| a.distance(*b)).collect();
    // A Gaussian says of its nodes only how far they are in proportion, and there are few.
    let near = off.iter().filter(|&&off| off < 0.01).count();
    assert!(near > off.len() / 2, "{off:?}");
}

fn a_wrong_number_is_named() {
    let expect = |storage: usize, number: &[u8], words: [&str; 2]| {
        let found = fault(&with_number(storage, number));
        assert!(words.iter().all(|word| found.contains(word)), "{found}");
    };
    expect(XYZ, &f32::NAN.to_le_bytes(), ["_xyz", "NaN"]);
    expect(XYZ, &2e4f32.to_le_bytes(), ["_xyz", "metres"]);
    expect(WEIGHTS, &5.0f32.to_le_bytes(), ["_weights", "sum to 1"]);
    expect(
        NODES_OF_GAUSSIANS,
        &18i64.to_le_bytes(),
        ["nbr_gs", "18 at 0"],
    );
    expect(
        ANCHORS_OF_GAUSSIANS,
        &(-1i64).to_le_bytes(),
        ["nbr_gsft", "-1 at 0"],
    );
    let mut parents = (-1i64).to_le_bytes().to_vec();
    parents.extend(1i64.to_le_bytes());
    expect(PARENTS, &parents, ["joint_parents", "1 of joint 1"]);
    expect(SCALING, &1e9f32.to_le_bytes(), ["_scaling", "65504"]);
    expect(ROTATION, &[0; 16], ["_rotation", "a quaternion"]);
}

/// Poses that share one storage, which the file has once.
fn tensors_that_share_memory_are_refused() {
    let mut members = members();
    let pickle = members
        .iter_mut()
        .find(|own| own.name == "data.pkl")
        .unwrap();
    for key in 11..90 {
        let key = [&b"X\x02\0\0\0"[..], key.to_string().as_bytes()].concat();
        let at = pickle.bytes.windows(7).position(|own| own == key).unwrap();
        pickle.bytes[at + 5..at + 7].copy_from_slice(b"10");
    }
    let shared = |own: &Member| {
        let key = own
            .name
            .strip_prefix("data/")
            .and_then(|key| key.parse().ok());
        key.is_some_and(|key: usize| (11..90).contains(&key))
    };
    members.retain(|own| !shared(own));
    let bytes = archive(&members);
    let mut found = String::new();
    let used = memory::peak(|| found = fault(&bytes)).1;
    assert!(found.contains("to itself"), "{found}");
    assert!(used < 2 << 20, "{used} bytes");
}

fn distilling_names_what_it_can_not_use() {
    let refused = |bytes: &[u8]| {
        let pickle = Pickle::from_bytes(bytes).unwrap();
        let checkpoint = Checkpoint::new(&pickle, &Options::default()).unwrap();
        let fast = effigy_learn::distil::DistilOptions {
            epochs: 4,
            ..options(120)
        };
        match distil(&checkpoint, "edited", &[], &fast, &|_, _| {}) {
            Ok(_) => "none".into(),
            Err(error) => error.to_string(),
        }
    };
    let found = refused(&with_number(FIRST_LAYER, &f32::INFINITY.to_le_bytes()));
    assert!(
        found.contains("layers.0.weight") && found.contains("inf"),
        "{found}"
    );
    let found = refused(&with_number(FIRST_LAYER, &1e38f32.to_le_bytes()));
    assert!(
        found.contains("network 0") && found.contains("65504"),
        "{found}"
    );
    let found = refused(&renamed("all_poses", "all_posts"));
    assert!(
        found.contains("0 poses") && found.contains("at least 8"),
        "{found}"
    );
}

tests! {
    a_missing_entry_is_named,
    what_may_be_missing_is_derived,
    a_wrong_number_is_named,
    tensors_that_share_memory_are_refused,
    distilling_names_what_it_can_not_use,
}
