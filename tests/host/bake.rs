//! The bake: its parsers on small good and bad inputs; and, where the source files are, a small
//! avatar and a clip of the real body.

use crate::common;
use effigy_core::avatar::{Avatar, Clip, Pose};
use effigy_learn::bake::{
    self, Assets, BakeSizes, BodyShape, CutOptions, SourceError,
    source::obj::Obj,
    source::rig::{self, PointInfluence},
    source::target::MorphTarget,
};
use glam::DVec3;
use std::path::Path;
use std::sync::OnceLock;

const FILE: &str = "some.file";

fn file() -> &'static Path {
    Path::new(FILE)
}

/// The error names the file, the line, what was found and what was expected.
fn assert_says<T: std::fmt::Debug>(result: Result<T, SourceError>, words: &[&str]) {
    let message = result.expect_err("bad input was accepted").to_string();
    for word in words.iter().chain(&[FILE]) {
        assert!(
            message.contains(word),
            "\"{message}\" does not say \"{word}\""
        );
    }
}

fn an_obj_gives_triangles_by_group() {
    let text = "# a quad\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0.5\ng a\nf 1/1 2/1 3/1 4/1\ng b\nf 1 2 3\ng a\nf 2 3 4\n";
    let obj = Obj::parse(file(), text).expect("a sound file");
    assert_eq!((obj.positions.len(), obj.uvs.len()), (4, 1));
    let vertices = |group: &str| {
        obj.group(group)
            .iter()
            .map(|t| t.map(|corner| corner.vertex))
            .collect::<Vec<_>>()
    };
    assert_eq!(vertices("a"), [[0, 1, 2], [0, 2, 3], [1, 2, 3]]);
    assert_eq!(vertices("b"), [[0, 1, 2]]);
    assert!(obj.group("c").is_empty());
}

fn a_bad_obj_is_refused_with_its_line() {
    assert_says(
        Obj::parse(file(), "v 0 0\n"),
        &["line 1", "the end of the line", "three numbers"],
    );
    assert_says(Obj::parse(file(), "v 0 0 nan\n"), &["line 1", "NaN"]);
    assert_says(
        Obj::parse(file(), "v 0 0 0\n\nf 1 1 2\n"),
        &["line 3", "vertex 2", "from 1 to 1"],
    );
    assert_says(
        Obj::parse(file(), "v 0 0 0\nf 0 1 1\n"),
        &["line 2", "vertex 0"],
    );
    assert_says(
        Obj::parse(file(), "v 0 0 0\nf 1/1 1 1\n"),
        &["texture coordinate 1", "from 1 to 0"],
    );
    assert_says(
        Obj::parse(file(), "v 0 0 0\nf 1 1\n"),
        &["2 corners", "three or more"],
    );
}

fn a_target_moves_the_vertices_it_names() {
    let target = MorphTarget::parse(file(), "# basis\n1 0 .5 -1\n", 2).expect("a sound file");
    let mut positions = vec![DVec3::ZERO, DVec3::X];
    target.apply(&mut positions, 2.0);
    assert_eq!(positions, [DVec3::ZERO, DVec3::new(1.0, 1.0, -2.0)]);
    assert_says(
        MorphTarget::parse(file(), "2 0 0 0\n", 2),
        &["line 1", "vertex 2", "below 2"],
    );
    assert_says(
        MorphTarget::parse(file(), "0 0 0 0\n1 a 0 0\n", 2),
        &["line 2", "\"a\""],
    );
}

fn rig_text(parent_of_spine: &str) -> String {
    let parent = |name: &str| match name {
        "Hips" => String::new(),
        "Spine" => parent_of_spine.to_owned(),
        _ => "mixamorig:Hips".to_owned(),
    };
    let bone = |name: &&str| {
        format!(
            r#""mixamorig:{name}": {{"parent": "{}", "head": {{"strategy": "MEAN", "vertex_indices": [0, 1]}}}}"#,
            parent(name)
        )
    };
    format!(
        r#"{{"bones": {{{}}}}}"#,
        rig::BODY.iter().map(bone).collect::<Vec<_>>().join(", ")
    )
}

fn a_rig_gives_joints_in_smplx_order_and_weights_that_sum_to_one() {
    let bones = rig::bones(file(), &rig_text("mixamorig:Hips"), 2).expect("a sound rig");
    assert_eq!(
        (
            bones[0].name.as_str(),
            bones[15].name.as_str(),
            bones[3].parent
        ),
        ("Hips", "Head", Some(0))
    );
    let text =
        r#"{"weights": {"mixamorig:Hips": [[0, 0.3], [1, 1]], "mixamorig:Spine": [[0, 0.9]]}}"#;
    let weights = rig::weights(file(), text, &bones, 2).expect("sound weights");
    assert_eq!(
        weights[0]
            .iter()
            .map(|influence| influence.joint)
            .collect::<Vec<_>>(),
        [3, 0]
    );
    assert!(
        (weights[0][0].weight - 0.75).abs() < 1e-12
            && weights[1]
                == [PointInfluence {
                    joint: 0,
                    weight: 1.0
                }],
        "{weights:?}"
    );
}

fn a_bad_rig_is_refused() {
    assert_says(rig::bones(file(), "{", 2), &["line 1"]);
    assert_says(
        rig::bones(file(), r#"{"bones": {}}"#, 2),
        &["no bone mixamorig:Hips"],
    );
    assert_says(
        rig::bones(file(), &rig_text("mixamorig:Head"), 2),
        &["bone Spine under \"Head\"", "before it"],
    );
    assert_says(
        rig::bones(file(), &rig_text("mixamorig:Hips"), 1),
        &["vertex 1 at bone Hips", "below 1"],
    );
    let bones = rig::bones(file(), &rig_text("mixamorig:Hips"), 2).expect("a sound rig");
    let weights = |list: &str| {
        rig::weights(
            file(),
            &format!(r#"{{"weights": {{"mixamorig:Hips": {list}}}}}"#),
            &bones,
            2,
        )
    };
    assert_says(weights("[[0, 1]]"), &["no weight for vertex 1"]);
    assert_says(weights("[[0, 1], [1, -1]]"), &["weight -1"]);
    assert_says(weights("[[7, 1]]"), &["vertex 7", "below 2"]);
}

fn cut_files_never_panic() {
    let rig = rig_text("mixamorig:Hips");
    for end in 0..rig.len() {
        assert!(
            rig::bones(file(), &rig[..end], 2).is_err(),
            "a rig cut after {end} bytes was accepted"
        );
    }
}

fn quantised_weights_sum_to_255() {
    let cases: [&[(u8, f64)]; 4] = [
        &[(3, 1.0)],
        &[(1, 0.5), (2, 0.5)],
        &[(1, 0.4), (2, 0.3), (3, 0.15), (4, 0.1), (5, 0.05)],
        &[(0, 1.0 / 3.0); 3],
    ];
    for case in cases {
        let weights: Vec<PointInfluence> = case
            .iter()
            .map(|&(joint, weight)| PointInfluence { joint, weight })
            .collect();
        let bake::assemble::QuantisedWeights {
            joint: joints,
            weight: bytes,
        } = bake::assemble::quantise(&weights);
        assert_eq!(
            bytes.iter().map(|&b| u32::from(b)).sum::<u32>(),
            255,
            "{weights:?} became {joints:?} {bytes:?}"
        );
        assert!(
            bytes
                .iter()
                .zip(&weights)
                .all(|(b, influence)| (f64::from(*b) / 255.0 - influence.weight).abs() < 0.06),
            "{weights:?} became {bytes:?}"
        );
    }
}

struct Baked {
    avatar: Avatar,
    clip: Clip,
}

/// A small bake of the real body, made once a process.
fn baked() -> &'static Baked {
    static BAKED: OnceLock<Baked> = OnceLock::new();
    let assets = Assets::new(common::assets());
    BAKED.get_or_init(|| make(&assets))
}

fn make(assets: &Assets) -> Baked {
    let skeleton = bake::skeleton(assets, BodyShape::Male).expect("the assets are whole");
    let options = CutOptions {
        rate: 30.0,
        from: 1.0,
        to: Some(12.0),
        in_place: false,
        start: None,
        fade: 0.0,
        credit: String::new(),
    };
    let clip =
        bake::motion(&assets.path("01_01.bvh"), &skeleton, &options).expect("the capture is whole");
    let sizes = BakeSizes {
        gaussians: 5000,
        parts: 32,
        nodes: 400,
        rows: 500,
        seed: 7,
    };
    let avatar = bake::body(
        assets,
        BodyShape::Male,
        std::slice::from_ref(&clip),
        &sizes,
        &|_| (),
    )
    .expect("the assets are whole");
    Baked { avatar, clip }
}

fn a_baked_avatar_passes_its_files_checks_and_has_the_sizes_asked_for() {
    let Baked { avatar, .. } = baked();
    assert_eq!(
        (
            avatar.gaussians.len(),
            avatar.parts.len(),
            avatar.nodes.len()
        ),
        (5000, 32, 400)
    );
    assert_eq!(
        (
            avatar.rotation_rows.gaussian.len(),
            avatar.scale_rows.gaussian.len(),
            avatar.color_rows.gaussian.len()
        ),
        (500, 500, 500)
    );
    assert_eq!(
        (
            avatar.inputs.joint.len(),
            avatar.inputs.expression,
            avatar.skeleton.len()
        ),
        (21, 10, 52)
    );
    let bytes = avatar
        .to_bytes()
        .expect("the file's own rules hold: weights, order, ranges, no NaN");
    assert_eq!(
        &Avatar::from_bytes(&bytes).expect("what was written can be read"),
        avatar
    );
}

fn head_parts_come_first() {
    let Baked { avatar, .. } = baked();
    let head = avatar
        .skeleton
        .name
        .iter()
        .position(|name| name == "Head")
        .expect("the body has a head") as u8;
    for part in 0..avatar.parts.len() {
        let own = avatar.parts.start[part] as usize..avatar.parts.start[part + 1] as usize;
        let (mut of_head, count) = (0, own.len());
        own.for_each(|i| of_head += usize::from(avatar.gaussians.joint[i][0] == head));
        assert!(
            part < avatar.parts.head || 2 * of_head <= count,
            "part {part}, no head part, has {of_head} of {count} Gaussians on the head"
        );
    }
    assert!(
        (1..avatar.parts.len()).contains(&avatar.parts.head),
        "{} head parts",
        avatar.parts.head
    );
}

fn the_clip_keeps_bone_lengths_and_feet_near_the_ground() {
    let Baked { avatar, clip } = baked();
    let rest = |j: usize| DVec3::from(avatar.skeleton.rest[j].map(f64::from));
    let mut lowest = f64::INFINITY;
    for frame in 0..clip.frames() {
        let joints = avatar.skeleton.joints(&clip.frame(frame));
        for (j, parent) in avatar.skeleton.parent.iter().enumerate() {
            let Some(parent) = parent.map(usize::from) else {
                continue;
            };
            let (got, expected) = (
                joints[j].translation.distance(joints[parent].translation),
                rest(j).distance(rest(parent)),
            );
            assert!(
                (got - expected).abs() < 1e-6,
                "frame {frame}, bone {j}: {got} m, expected {expected}"
            );
        }
        lowest = joints
            .iter()
            .map(|joint| joint.translation.y)
            .fold(lowest, f64::min);
    }
    assert!(
        (-0.05..0.1).contains(&lowest),
        "the lowest joint is at {lowest} m, expected between -0.05 and 0.1"
    );
}

fn the_clip_stands_upright_with_the_head_above_the_hips_above_the_feet() {
    let Baked { avatar, clip } = baked();
    let joints = avatar.skeleton.joints(&clip.frame(0));
    let [hips, head, left, right] = [0, 15, 7, 8].map(|j| joints[j].translation.y);
    assert!(
        head > hips + 0.4 && hips > left + 0.6 && hips > right + 0.6,
        "head {head}, hips {hips}, ankles {left} {right} m"
    );
}

fn components_are_orthonormal_and_rebuild_the_clips_poses() {
    let Baked { avatar, clip } = baked();
    let space = avatar
        .inputs
        .pose_space
        .as_ref()
        .expect("a bake has a pose space");
    assert_eq!((space.mean.len(), space.sigma.len()), (63, 20));
    let row = |k: usize| &space.component[63 * k..63 * (k + 1)];
    for (a, b) in (0..20).flat_map(|a| (0..=a).map(move |b| (a, b))) {
        let dot: f64 = row(a)
            .iter()
            .zip(row(b))
            .map(|(x, y)| f64::from(*x) * f64::from(*y))
            .sum();
        assert!(
            (dot - f64::from(u8::from(a == b))).abs() < 1e-5,
            "components {a} and {b}: {dot}"
        );
    }
    let (mut lost, mut whole) = (0.0, 0.0);
    for frame in (0..clip.frames()).step_by(5) {
        let theta: Vec<f64> = clip.frame(frame).rotation[1..=21]
            .iter()
            .flat_map(|r| r.to_array())
            .collect();
        let mut rest: Vec<f64> = theta
            .iter()
            .zip(&space.mean)
            .map(|(t, &m)| t - f64::from(m))
            .collect();
        whole += rest.iter().map(|x| x * x).sum::<f64>();
        for k in 0..20 {
            let along: f64 = rest
                .iter()
                .zip(row(k))
                .map(|(x, &c)| x * f64::from(c))
                .sum();
            rest.iter_mut()
                .zip(row(k))
                .for_each(|(x, &c)| *x -= along * f64::from(c));
        }
        lost += rest.iter().map(|x| x * x).sum::<f64>();
    }
    assert!(lost < 0.02 * whole, "20 components lose {lost} of {whole}");
}

fn features_are_about_one_and_an_expression_reaches_the_face_unchanged() {
    let Baked { avatar, clip } = baked();
    let features =
        |pose: &Pose| effigy_core::reference::mlp::features(avatar, &avatar.inputs.from_pose(pose));
    let (mut sum, mut count) = (0.0, 0.0);
    for frame in (0..clip.frames()).step_by(10) {
        let all = features(&clip.frame(frame));
        let body = &all[avatar.parts.head * avatar.networks.output()..];
        sum += body.iter().map(|e| e * e).sum::<f64>();
        count += body.len() as f64;
    }
    let size = (sum / count).sqrt();
    assert!(
        (0.7..1.3).contains(&size),
        "features are {size} on average, expected about 1"
    );
    let mut pose = clip.frame(0);
    pose.expression = (0..10).map(|k| 0.1 * f64::from(k)).collect();
    let start = avatar.node_feature_start();
    for (k, got) in features(&pose)[start..start + 10].iter().enumerate() {
        assert!(
            (got - pose.expression[k]).abs() < 5e-3,
            "expression {k}: {got}, expected {}",
            pose.expression[k]
        );
    }
}

fn the_same_seed_gives_the_same_avatar_on_one_thread_as_on_many() {
    let Baked { avatar, .. } = baked();
    let assets = Assets::new(common::assets());
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(1)
        .build()
        .expect("one thread can be had");
    let again = pool.install(|| make(&assets));
    assert!(&again.avatar == avatar, "two bakes from one seed differ");
}

tests! {
    an_obj_gives_triangles_by_group,
    a_bad_obj_is_refused_with_its_line,
    a_target_moves_the_vertices_it_names,
    a_rig_gives_joints_in_smplx_order_and_weights_that_sum_to_one,
    a_bad_rig_is_refused,
    cut_files_never_panic,
    quantised_weights_sum_to_255,
    a_baked_avatar_passes_its_files_checks_and_has_the_sizes_asked_for,
    head_parts_come_first,
    the_clip_keeps_bone_lengths_and_feet_near_the_ground,
    the_clip_stands_upright_with_the_head_above_the_hips_above_the_feet,
    components_are_orthonormal_and_rebuild_the_clips_poses,
    features_are_about_one_and_an_expression_reaches_the_face_unchanged,
    the_same_seed_gives_the_same_avatar_on_one_thread_as_on_many,
}
