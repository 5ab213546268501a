//! Animations of FBX (`.fbx`, text and binary), by the library ufbx in its Rust bindings. It is
//! C: the feature `fbx` of this package builds it, and browsers and Android do without.
//!
//! Joints are FBX's bones (limb nodes) and what is animated above them; in a file without bones,
//! every node that has a child or is animated. Other nodes are part of what is below them. Scales go
//! into offsets: they are taken to be even and not to change. Curves are sampled; layers of an
//! animation, pivots and orders of rotation are the library's work.

mod expanded;

use crate::{
    assumption::Assumption,
    capture::{Capture, Captured, Rest, UpAxis, Usual, check_size, checked_rate},
    scene_tree::{Joint, Place, SceneTree},
};
use effigy_core::io::file::{FormatError, excerpt};
use glam::{DVec3, DVec4};
use ufbx::{
    AllocatorOpts, Anim, AnimStack, BakeOpts, CoordinateAxis, ElementType, ErrorType, FileFormat,
    InheritModeHandling, LoadOpts, Node, SceneRoot, Transform,
};

/// Bytes that the library may take for any file, and how many more for a byte of it with its arrays
/// unpacked: for what it needs while it reads, and for what it gives. A key has 12 bytes in such a
/// file, and 40 in what it gives.
const SMALL: usize = 24 << 20;
const WHILE_READING: usize = 2;
const GIVEN: usize = 4;
/// Most nodes above a node.
const MAX_DEPTH: u32 = 1024;
/// Frames a second: most that a file may ask for, and what is taken where it asks for none.
const MAX_RATE: f64 = 240.0;
const USUAL_RATE: f64 = 30.0;
/// Seconds of an animation at most, before the size of its file is asked.
const MAX_SECONDS: f64 = 1e6;
/// How far numbers may be from one another and still be called the same.
const SAME: f64 = 1e-9;
/// How far the bind pose may be from the nodes' before it counts as another: radians.
const SAME_TURN: f64 = 0.02;

/// What a file leaves open.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Options {
    /// Frames a second; None: the file's.
    pub rate: Option<f64>,
    /// The name of an animation, or its number from 0; None: the first that moves.
    pub animation: Option<String>,
    /// Which pose is that at rest.
    pub rest: Rest,
}

/// Reads an animation.
///
/// # Errors
/// When the bytes are no FBX that the library reads within its limits of memory, when there is no
/// such animation or none at all, or no node that can be a joint.
pub fn from_bytes(bytes: &[u8], options: &Options) -> Result<Captured, FormatError> {
    let room = Room::of(bytes);
    let scene = load(bytes, room)?;
    let mut assumptions = vec![];
    let stack = chosen(&scene, options.animation.as_deref(), &mut assumptions)?;
    let rate = rate(&scene, options.rate)?;
    let span = span(&scene, stack, room)?;
    let seconds = span.end - span.start;
    if !(0.0..=MAX_SECONDS).contains(&seconds) {
        return Err(FormatError::metadata(
            "time",
            format!("{seconds} seconds"),
            format!("0 to {MAX_SECONDS}"),
        ));
    }
    let frames = (seconds * rate + 1e-3).floor() as usize + 1;
    let times = Times {
        start: span.start,
        rate,
        frames,
    };
    let tree = tree(&scene)?;
    let kept = kept(&scene, &tree, &stack.anim, &times, bytes.len())?;
    let joints = tree.joints(&kept);
    if joints.is_empty() {
        return Err(FormatError::container(
            "no bone, and no node that moves",
            "an animated skeleton",
        ));
    }
    check_size(frames, joints.len(), bytes.len())?;
    let rest = rest(&scene, &tree, &joints, options.rest, &mut assumptions)?;
    let mut local = Vec::with_capacity(frames * joints.len());
    for frame in 0..frames {
        for joint in &joints {
            local.push(joint.pose(&placed(&scene, &stack.anim, joint.node, times.at(frame))?));
        }
    }
    let name = |joint: &Joint| match &*scene.nodes[joint.node].element.name {
        "" => format!("node {}", joint.node),
        name => name.to_owned(),
    };
    let at_rest = joints.iter().zip(&rest);
    let settings = &scene.settings;
    Ok(Captured {
        capture: Capture {
            joints: at_rest
                .map(|(joint, rest)| joint.at_rest(name(joint), rest))
                .collect(),
            rate,
            local,
            unit: Some(settings.unit_meters).filter(|unit| unit.is_finite() && *unit > 0.0),
            up: axis(settings.axes.up),
            model_rest: false,
            expression: vec![],
            expression_len: 0,
        },
        assumptions,
    })
}

/// When an animation plays, seconds.
struct Span {
    start: f64,
    end: f64,
}

/// When an animation says that it plays, or else when its keys are.
fn span(scene: &SceneRoot, stack: &AnimStack, room: Room) -> Result<Span, FormatError> {
    if stack.time_end > stack.time_begin {
        return Ok(Span {
            start: stack.time_begin,
            end: stack.time_end,
        });
    }
    let options = BakeOpts {
        temp_allocator: room.allocator(WHILE_READING),
        result_allocator: room.allocator(GIVEN),
        ..BakeOpts::default()
    };
    let baked = ufbx::bake_anim(scene, &stack.anim, options);
    let baked = baked.map_err(|error| room.refused(&error))?;
    let start = baked.key_time_min;
    Ok(Span {
        start,
        end: baked.key_time_max.max(start),
    })
}

/// When frames are.
struct Times {
    start: f64,
    rate: f64,
    frames: usize,
}

impl Times {
    fn at(&self, frame: usize) -> f64 {
        self.start + frame as f64 / self.rate
    }
}

/// How much memory a file may take.
#[derive(Clone, Copy)]
struct Room {
    /// Bytes of the file with its arrays unpacked.
    expanded: usize,
}

impl Room {
    fn of(bytes: &[u8]) -> Self {
        Self {
            expanded: expanded::expanded(bytes),
        }
    }

    /// `growth`: bytes of memory for a byte.
    fn allocator(self, growth: usize) -> AllocatorOpts {
        AllocatorOpts {
            memory_limit: SMALL.saturating_add(growth.saturating_mul(self.expanded)),
            ..AllocatorOpts::default()
        }
    }

    fn refused(self, error: &ufbx::Error) -> FormatError {
        if error.type_ == ErrorType::MemoryLimit {
            let most = WHILE_READING + GIVEN;
            return FormatError::container(
                "an FBX file that takes more memory than its size accounts for",
                format!(
                    "at most {most} bytes for each of the {} that it unpacks to: export bones and \
                     their animation alone",
                    self.expanded
                ),
            );
        }
        let said = excerpt(&error.description);
        FormatError::container(format!("what ufbx can't read: {said}"), "an FBX file")
    }
}

fn load(bytes: &[u8], room: Room) -> Result<SceneRoot, FormatError> {
    let options = LoadOpts {
        temp_allocator: room.allocator(WHILE_READING),
        result_allocator: room.allocator(GIVEN),
        ignore_geometry: true,
        ignore_embedded: true,
        file_format: FileFormat::Fbx,
        node_depth_limit: MAX_DEPTH,
        // Maya's bones that leave out their parent's scale.
        inherit_mode_handling: InheritModeHandling::Compensate,
        ..LoadOpts::default()
    };
    ufbx::load_memory(bytes, options).map_err(|error| room.refused(&error))
}

fn axis(axis: CoordinateAxis) -> UpAxis {
    UpAxis::Said(match axis {
        CoordinateAxis::PositiveX => DVec3::X,
        CoordinateAxis::NegativeX => DVec3::NEG_X,
        CoordinateAxis::PositiveY => DVec3::Y,
        CoordinateAxis::NegativeY => DVec3::NEG_Y,
        CoordinateAxis::PositiveZ => DVec3::Z,
        CoordinateAxis::NegativeZ => DVec3::NEG_Z,
        CoordinateAxis::Unknown => return UpAxis::Open,
    })
}

fn rate(scene: &SceneRoot, said: Option<f64>) -> Result<f64, FormatError> {
    let own = scene.settings.frames_per_second;
    let own = if own.is_finite() && own > 0.0 {
        own.min(MAX_RATE)
    } else {
        USUAL_RATE
    };
    checked_rate(said.unwrap_or(own))
}

/// The animation that is asked for: by name, by number, or the first that moves.
fn chosen<'a>(
    scene: &'a SceneRoot,
    asked: Option<&str>,
    assumptions: &mut Vec<Assumption>,
) -> Result<&'a AnimStack, FormatError> {
    let stacks = &scene.anim_stacks;
    let names = stacks.iter().map(|stack| Some(&*stack.element.name));
    let names: Vec<Option<&str>> = names.collect();
    // Exporters leave an empty one before that which moves.
    let moves = |stack: &AnimStack| {
        let mut layers = stack.layers.iter();
        layers.any(|layer| !layer.anim_props.is_empty())
    };
    let usual = Usual {
        index: stacks.iter().position(|stack| moves(stack)).unwrap_or(0),
        what: "the first that moves",
    };
    Ok(&stacks[usual.or(asked, &names, assumptions)?])
}

fn place(transform: &Transform) -> Option<Place> {
    let Transform {
        translation: t,
        rotation: r,
        scale: s,
    } = transform;
    Place::new(
        DVec3::new(t.x, t.y, t.z),
        DVec4::new(r.x, r.y, r.z, r.w),
        DVec3::new(s.x, s.y, s.z),
    )
}

fn odd(node: &Node) -> FormatError {
    FormatError::metadata(
        &excerpt(&node.element.name),
        "a transform that is none",
        "finite numbers, and a rotation",
    )
}

fn tree(scene: &SceneRoot) -> Result<SceneTree, FormatError> {
    let index = |node: &Node| node.element.typed_id as usize;
    let mut tree = SceneTree {
        parent: vec![],
        order: (0..scene.nodes.len()).collect(),
        place: vec![],
    };
    for node in scene.nodes.iter() {
        tree.parent
            .push(node.parent.as_ref().map(|parent| index(parent)));
        tree.place
            .push(place(&node.local_transform).ok_or_else(|| odd(node))?);
    }
    tree.order.sort_by_key(|&node| scene.nodes[node].node_depth);
    Ok(tree)
}

/// Where a node is in its parent at a time.
fn placed(scene: &SceneRoot, anim: &Anim, node: usize, time: f64) -> Result<Place, FormatError> {
    let node = &scene.nodes[node];
    place(&node.evaluate_transform(anim, time)).ok_or_else(|| odd(node))
}

/// Nodes that become joints. `size`: bytes of the file.
fn kept(
    scene: &SceneRoot,
    tree: &SceneTree,
    anim: &Anim,
    times: &Times,
    size: usize,
) -> Result<Vec<bool>, FormatError> {
    let bones = scene
        .nodes
        .iter()
        .map(|node| node.attrib_type == ElementType::Bone);
    let bones: Vec<bool> = bones.collect();
    let has_bones = bones.contains(&true);
    let candidates = if has_bones {
        tree.with_ancestors(&bones)
    } else {
        scene.nodes.iter().map(|node| !node.is_root).collect()
    };
    let count = candidates.iter().filter(|&&candidate| candidate).count();
    if count == 0 {
        return Err(FormatError::container(
            "no node",
            "bones, or nodes that move",
        ));
    }
    check_size(times.frames, count, size)?;
    let mut kept = bones;
    for node in 0..kept.len() {
        if kept[node] || !candidates[node] {
            continue;
        }
        if !has_bones && !scene.nodes[node].children.is_empty() {
            kept[node] = true;
            continue;
        }
        for frame in 0..times.frames {
            let now = placed(scene, anim, node, times.at(frame))?;
            let still = &tree.place[node];
            let same = now.translation.distance(still.translation)
                <= SAME * (1.0 + still.translation.length())
                && now.rotation.dot(still.rotation).abs() >= 1.0 - SAME;
            if !same {
                kept[node] = true;
                break;
            }
        }
    }
    Ok(kept)
}

/// Where joints are at rest, in their parent nodes.
fn rest(
    scene: &SceneRoot,
    tree: &SceneTree,
    joints: &[Joint],
    rest: Rest,
    assumptions: &mut Vec<Assumption>,
) -> Result<Vec<Place>, FormatError> {
    let mut places: Vec<Place> = joints.iter().map(|joint| tree.place[joint.node]).collect();
    if rest == Rest::Nodes {
        return Ok(places);
    }
    let mut bind = std::collections::BTreeMap::new();
    for pose in scene.poses.iter().filter(|pose| pose.is_bind_pose) {
        for bone in pose.bone_poses.iter() {
            let place = place(&ufbx::matrix_to_transform(&bone.bone_to_parent));
            let node = &*bone.bone_node;
            bind.insert(
                node.element.typed_id as usize,
                place.ok_or_else(|| odd(node))?,
            );
        }
    }
    let mut differ = 0;
    for (joint, own) in joints.iter().zip(&mut places) {
        // A place in a parent that was not bound is a guess.
        let bound = tree.parent[joint.node].is_some_and(|parent| bind.contains_key(&parent));
        let Some(place) = bind.get(&joint.node).filter(|_| bound) else {
            continue;
        };
        differ += usize::from(place.rotation.angle_between(own.rotation) > SAME_TURN);
        *own = *place;
    }
    if differ > 0 {
        assumptions.push(Assumption {
            what: "rest pose",
            taken: "that of the file's bind pose".into(),
            because: format!("{differ} joints' nodes are turned otherwise"),
        });
    }
    Ok(places)
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::{DAffine3, DMat3};
    use proptest::prelude::*;
    use serde::Deserialize;
    use std::{collections::BTreeMap, time::Instant};

    /// `tests/data/fbx/make.py`, which knows nothing of Effigy, wrote it and computed where its joints
    /// are.
    const WALK: &[u8] = include_bytes!("../../tests/data/fbx/walk.fbx");
    const NAMES: [&str; 4] = ["Hips", "Spine", "Arm", "Still"];

    /// Joints in the world, by [`NAMES`].
    #[derive(Deserialize)]
    struct Joints {
        /// Rows.
        rotation: Vec<[[f64; 3]; 3]>,
        translation: Vec<[f64; 3]>,
    }

    #[derive(Deserialize)]
    struct Shown {
        frames: Vec<Joints>,
        nodes: Joints,
        bind: Joints,
    }

    fn shown() -> Shown {
        serde_json::from_str(include_str!("../../tests/data/fbx/shown.json")).expect("shown")
    }

    fn read(options: &Options) -> Captured {
        from_bytes(WALK, options).expect("an animation")
    }

    fn compare(what: &str, capture: &Capture, own: &[DAffine3], expected: &Joints) {
        let own: BTreeMap<&str, &DAffine3> = capture
            .joints
            .iter()
            .map(|joint| &*joint.name)
            .zip(own)
            .collect();
        assert_eq!(own.len(), NAMES.len(), "{what}");
        for (joint, name) in NAMES.into_iter().enumerate() {
            let rows = DMat3::from_cols_array_2d(&expected.rotation[joint]).transpose();
            let off = (own[name].matrix3 - rows).to_cols_array();
            let off = off.iter().fold(0.0, |most: f64, n| most.max(n.abs()));
            assert!(off < 2e-5, "{what}: {name} is turned {off} off");
            let off = own[name]
                .translation
                .distance(DVec3::from(expected.translation[joint]));
            assert!(off < 2e-4, "{what}: {name} is {off} cm off");
        }
    }

    #[test]
    fn joints_are_where_numpy_computes_them() {
        let captured = read(&Options::default());
        let capture = &captured.capture;
        let shown = shown();
        assert_eq!((capture.frames(), capture.rate), (shown.frames.len(), 25.0));
        assert_eq!(
            (capture.unit, capture.up),
            (Some(0.01), UpAxis::Said(DVec3::Z))
        );
        for (at, frame) in shown.frames.iter().enumerate() {
            compare(&format!("frame {at}"), capture, &capture.world(at), frame);
        }
        compare("bind", capture, &capture.rest(), &shown.bind);
        let said = captured.assumptions.iter().find(|a| a.what == "rest pose");
        assert!(said.is_some());
        let nodes = read(&Options {
            rest: Rest::Nodes,
            ..Options::default()
        });
        compare("nodes", &nodes.capture, &nodes.capture.rest(), &shown.nodes);
    }

    #[test]
    fn animations_and_rates_are_chosen() {
        let asked = |animation: &str, rate| {
            let options = Options {
                animation: Some(animation.into()),
                rate,
                ..Options::default()
            };
            from_bytes(WALK, &options)
        };
        let fault = |result: Result<Captured, FormatError>| match result {
            Ok(_) => "none".to_owned(),
            Err(error) => error.to_string(),
        };
        let first = read(&Options::default());
        assert_eq!(asked("Walk", None).map(|c| c.capture), Ok(first.capture));
        assert_eq!(asked("1", None), asked("Rest", None));
        assert!(
            fault(asked("Run", None))
                .contains("no animation `Run`, expected one of `Walk`, `Rest`")
        );
        assert_eq!(asked("Walk", Some(50.0)).map(|c| c.capture.frames()), Ok(9));
        for rate in [0.0, f64::NAN, 1e15] {
            assert_ne!(fault(asked("Walk", Some(rate))), "none", "{rate}");
        }
        let nothing = from_bytes(b"nothing", &Options::default());
        assert!(fault(nothing).contains("what ufbx can't read"));
    }

    /// Text may end anywhere after its objects and still be whole: no prefix may do harm.
    #[test]
    fn a_file_that_ends_too_soon_does_no_harm() {
        for end in 0..WALK.len() {
            let _ = from_bytes(&WALK[..end], &Options::default());
        }
    }

    #[test]
    fn a_tower_of_nodes_ends_soon() {
        let mut text = String::from("; FBX 7.4.0 project file\nFBXVersion: 7400\nObjects: {\n");
        let start = Instant::now();
        text.push_str(&"A: {".repeat(1_000_000));
        assert!(from_bytes(text.as_bytes(), &Options::default()).is_err());
        assert!(start.elapsed().as_secs_f64() < 5.0);
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(1000))]

        #[test]
        fn changed_bytes_do_no_harm(
            changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..8),
        ) {
            let mut bytes = WALK.to_vec();
            for (at, byte) in changes {
                let at = at.index(bytes.len());
                bytes[at] = byte;
            }
            if let Ok(captured) = from_bytes(&bytes, &Options::default()) {
                let capture = captured.capture;
                prop_assert_eq!(capture.local.len(), capture.frames() * capture.joints.len());
                prop_assert!(capture.local.iter().all(|pose| pose.offset.is_finite()));
            }
        }
    }
}
