//! The avatar and motion files: what is written reads back the same, and whatever else is read is
//! refused in one sentence, without panic and without memory that the file does not justify.

pub mod adversarial;
mod edit;
pub mod kept;
pub mod packed;
pub mod rules;
pub mod scans;

use crate::common::{self, Sizes};
use edit::Edit;
use effigy_core::avatar::{Activation, Avatar, Clip};
use half::f16;
use serde_json::{Value, json};

/// A few kilobytes with a piece of everything.
const TINY: Sizes = Sizes {
    gaussians: 40,
    parts: 3,
    nodes: 7,
    basis: 4,
    joints: 9,
    rows: 5,
    expression: 2,
    split_features: true,
    activation: Activation::LeakyRelu,
    hidden: 8,
    subspace: 2,
};

fn tiny() -> Avatar {
    common::with_levels(bare())
}

/// Without levels of detail.
fn bare() -> Avatar {
    common::avatar(1, TINY)
}

fn tiny_bytes() -> Vec<u8> {
    tiny().to_bytes().unwrap()
}

fn clip_bytes() -> Vec<u8> {
    common::clip(1, &tiny(), 4).to_bytes().unwrap()
}

fn avatar_fault(bytes: &[u8]) -> String {
    Avatar::from_bytes(bytes)
        .expect_err("the avatar should be refused")
        .to_string()
}

fn clip_fault(bytes: &[u8]) -> String {
    Clip::from_bytes(bytes)
        .expect_err("the clip should be refused")
        .to_string()
}

fn test_avatars_have_their_three_nearest_nodes() {
    let avatar = common::avatar(3, Sizes::default());
    for gaussian in 0..avatar.gaussians.len() {
        let distance = |node: usize| {
            avatar
                .node_position(node)
                .distance(avatar.position(gaussian))
        };
        let mut all: Vec<f64> = (0..avatar.nodes.len()).map(distance).collect();
        all.sort_by(f64::total_cmp);
        let got = avatar.gaussians.node[gaussian].map(|node| distance(node.into()));
        assert_eq!(got[..], all[..3], "Gaussian {gaussian}");
    }
}

/// The smallest avatar, usual ones, and some at a limit.
fn sizes() -> [Sizes; 5] {
    [
        TINY,
        Sizes::default(),
        Sizes {
            gaussians: 1,
            parts: 1,
            nodes: 1,
            joints: 1,
            rows: 0,
            expression: 0,
            subspace: 0,
            ..TINY
        },
        Sizes {
            parts: 1024,
            gaussians: 2000,
            joints: 256,
            basis: 32,
            ..TINY
        },
        Sizes {
            nodes: 65_536,
            rows: 40,
            subspace: 64,
            ..TINY
        },
    ]
}

fn avatars_of_every_size_read_back_the_same() {
    for (seed, sizes) in sizes().into_iter().enumerate() {
        let avatar = common::with_levels(common::avatar(seed as u64, sizes));
        assert!(
            Avatar::from_bytes(&avatar.to_bytes().unwrap()).unwrap() == avatar,
            "{sizes:?}"
        );
    }
}

fn files_on_disk_read_back_the_same() {
    let folder = tempfile::tempdir().unwrap();
    let (avatar, mut clip) = (tiny(), common::clip(2, &tiny(), 30));
    clip.rate = 1.0 / 0.008_333_3;
    avatar.write(&folder.path().join("a.avatar")).unwrap();
    clip.write(&folder.path().join("a.motion")).unwrap();
    assert_eq!(
        Avatar::read(&folder.path().join("a.avatar")).unwrap(),
        avatar
    );
    assert_eq!(Clip::read(&folder.path().join("a.motion")).unwrap(), clip);
    assert_eq!(
        std::fs::read_dir(folder.path()).unwrap().count(),
        2,
        "a temporary file was left"
    );
}

fn extreme_but_finite_numbers_read_back_the_same() {
    let mut avatar = bare();
    avatar.gaussians.log_scale[3] = [f16::MAX, f16::MIN, f16::from_bits(1)];
    avatar.gaussians.rotation[0] = [f16::ZERO, f16::from_bits(1), f16::ZERO, f16::NEG_ZERO];
    avatar.gaussians.bounds.min = [0.1, 1.0e-40, -9999.999];
    avatar.gaussians.bounds.max[0] = 0.1;
    avatar.networks.layers[0].weight.halves_mut()[1] = f16::MAX;
    assert_eq!(
        Avatar::from_bytes(&avatar.to_bytes().unwrap()).unwrap(),
        avatar
    );
}

fn a_file_at_an_odd_address_reads_the_same() {
    let mut bytes = vec![0];
    bytes.extend(tiny_bytes());
    assert_eq!(Avatar::from_bytes(&bytes[1..]).unwrap(), tiny());
}

fn what_a_later_program_adds_is_ignored() {
    let mut edit = Edit::open(&tiny_bytes());
    edit.document["mood"] = json!({ "good": [1, 2] });
    edit.header["__metadata__"]["other"] = json!("something");
    edit.append("colour.of.shadow", "BF16", &[2], &[1, 2, 3, 4]);
    assert_eq!(Avatar::from_bytes(&edit.bytes()).unwrap(), tiny());
}

fn a_missing_file_a_folder_and_an_empty_file_are_named() {
    let folder = tempfile::tempdir().unwrap();
    let error = |name: &str| {
        Avatar::read(&folder.path().join(name))
            .unwrap_err()
            .to_string()
    };
    assert!(
        error("none.avatar").starts_with("cannot read ")
            && error("none.avatar").contains("none.avatar: "),
        "{}",
        error("none.avatar")
    );
    assert!(
        error("").ends_with("found a folder or device, expected a file"),
        "{}",
        error("")
    );
    std::fs::write(folder.path().join("empty.avatar"), "").unwrap();
    assert!(
        error("empty.avatar")
            .ends_with("empty.avatar: found a file of 0 bytes, expected at least 8"),
        "{}",
        error("empty.avatar")
    );
}

fn a_failed_write_leaves_the_old_file_and_nothing_else() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.avatar");
    tiny().write(&path).unwrap();
    let mut broken = tiny();
    broken.gaussians.opacity.pop();
    let error = broken.write(&path).unwrap_err().to_string();
    assert!(
        error.ends_with("a.avatar: in tensor `opacity` found 39 bytes, expected U8 of shape [40]"),
        "{error}"
    );
    assert_eq!(Avatar::read(&path).unwrap(), tiny());
    let inside = path.join("b.avatar");
    assert!(
        tiny()
            .write(&inside)
            .unwrap_err()
            .to_string()
            .starts_with("cannot write ")
    );
    std::fs::create_dir(folder.path().join("folder")).unwrap();
    assert!(tiny().write(&folder.path().join("folder")).is_err());
    assert_eq!(
        std::fs::read_dir(folder.path()).unwrap().count(),
        2,
        "a temporary file was left"
    );
}

fn a_file_that_two_threads_write_is_always_of_one() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("file");
    let whole = |byte: u8| vec![byte; 100_000];
    std::thread::scope(|scope| {
        for byte in [1, 2] {
            let path = &path;
            scope.spawn(move || {
                for _ in 0..40 {
                    effigy_core::io::file::write_whole(path, &whole(byte)).unwrap();
                    let read = std::fs::read(path).unwrap();
                    assert!(read == whole(1) || read == whole(2), "a mixture");
                }
            });
        }
    });
    let files = std::fs::read_dir(folder.path()).unwrap().count();
    assert_eq!(files, 1, "parts are left");
}

fn an_avatar_whose_layers_do_not_fit_is_not_written() {
    let mut avatar = tiny();
    avatar.networks.layers[1].input = 4;
    assert_eq!(
        avatar.to_bytes().unwrap_err().to_string(),
        "found arrays that contradict each other, expected lengths and widths that agree"
    );
}

/// Exit status, standard output and standard error of `effigy inspect`.
fn inspect(arguments: &[&std::ffi::OsStr]) -> (bool, String, String) {
    let output = std::process::Command::new(common::program())
        .arg("inspect")
        .args(arguments)
        .output()
        .unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (
        output.status.success(),
        text(output.stdout),
        text(output.stderr),
    )
}

fn inspect_says_what_both_kinds_of_file_hold() {
    let folder = tempfile::tempdir().unwrap();
    let (avatar, motion) = (folder.path().join("a"), folder.path().join("b"));
    tiny().write(&avatar).unwrap();
    common::clip(1, &tiny(), 4).write(&motion).unwrap();
    let json = |path: &std::path::Path| -> Value {
        let (good, out, err) = inspect(&[path.as_os_str(), "--json".as_ref()]);
        assert!(good, "{err}");
        serde_json::from_str(&out).unwrap()
    };
    let (a, m) = (json(&avatar), json(&motion));
    assert_eq!(
        (&a["kind"], &a["gaussians"], &a["joints"][8]["parent"]),
        (&json!("avatar"), &json!(40), &json!(5))
    );
    assert_eq!(
        (&m["kind"], &m["frames"], &m["duration"]),
        (&json!("motion"), &json!(4), &json!(0.1))
    );
    for tensor in tiny().tensors() {
        assert!(
            inspect(&[avatar.as_os_str()]).1.contains(&tensor.name),
            "{}",
            tensor.name
        );
    }
}

fn inspect_refuses_a_cut_file_in_one_line() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("cut.avatar");
    std::fs::write(&path, &tiny_bytes()[..6000]).unwrap();
    let (good, out, err) = inspect(&[path.as_os_str()]);
    assert!(!good && out.is_empty());
    let expected = "cut.avatar: found ";
    assert!(
        err.contains(expected)
            && err.trim_end().ends_with("the file is incomplete")
            && err.lines().count() == 1,
        "{err}"
    );
}

tests! {
    test_avatars_have_their_three_nearest_nodes,
    avatars_of_every_size_read_back_the_same,
    files_on_disk_read_back_the_same,
    extreme_but_finite_numbers_read_back_the_same,
    a_file_at_an_odd_address_reads_the_same,
    what_a_later_program_adds_is_ignored,
    a_missing_file_a_folder_and_an_empty_file_are_named,
    a_failed_write_leaves_the_old_file_and_nothing_else,
    a_file_that_two_threads_write_is_always_of_one,
    an_avatar_whose_layers_do_not_fit_is_not_written,
    inspect_says_what_both_kinds_of_file_hold,
    inspect_refuses_a_cut_file_in_one_line,
}
