//! Animations of glTF 2.0 (`.glb`, `.gltf`), of VRM models (0.x and 1.0) and of VRM's own animation
//! files (`.vrma`).
//!
//! Joints are the joints of skins and what is animated above them; without skins, every node that
//! is animated; in VRM files, the bones of the human too, by VRM's names ("hips", "leftUpperArm").
//! Other nodes are part of what is below them. Scales go into offsets: they are taken to be even
//! and not to change. Weights of shapes, VRM's expressions and its gaze are left out.
//!
//! glTF is in metres with y up. Its keys stand at any time, so they are sampled.

mod curve;
mod humanoid;
mod tree;

use crate::{
    assumption::Assumption,
    capture::{Capture, Captured, LocalPose, Rest, UpAxis, Usual, check_size, checked_rate},
    gltf::{
        self, GltfFile,
        document::{Animation, Channel, Motion, Path, Sampler, Skin},
    },
    scene_tree::{Place, SceneTree},
};
use curve::{Curve, times};
use effigy_core::io::file::{FormatError, excerpt};
use glam::{DQuat, DVec3};
use std::collections::{BTreeMap, BTreeSet};
use tree::{NodeTree, bind};

/// Frames a second at most, where keys are denser.
const MAX_RATE: f64 = 60.0;
/// Frames a second where keys are sparser than [`SPARSE`].
const USUAL_RATE: f64 = 30.0;
const SPARSE: f64 = 24.0;
/// Keys of all channels, at most.
const MAX_KEYS: u64 = 50_000_000;

/// What a file leaves open.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Options {
    /// Frames a second; None: as dense as the densest keys, up to 60.
    pub rate: Option<f64>,
    /// The name of an animation, or its number from 0; None: the first.
    pub animation: Option<String>,
    /// Which pose is that at rest.
    pub rest: Rest,
}

/// Reads an animation. `beside`: gives the content of a file beside this one by its relative path,
/// for a `.gltf` whose numbers are in a `.bin`; paths lead nowhere else.
///
/// # Errors
/// When the bytes are no glTF 2.0, have no such animation or no animation at all, or when one of
/// the nodes, skins, accessors and channels that it needs breaks a rule of glTF.
pub fn from_bytes(
    bytes: &[u8],
    options: &Options,
    beside: &mut dyn FnMut(&str) -> Option<Vec<u8>>,
) -> Result<Captured, FormatError> {
    let parts = gltf::parts(bytes)?;
    let document = gltf::parse(&parts.document)?;
    let motion: Motion = gltf::parse(&parts.document)?;
    let mut beside = |name: &str, _: u64| {
        let missing = || format!("no file `{}`", excerpt(name));
        beside(name).ok_or_else(|| FormatError::container(missing(), "it beside this one"))
    };
    let source = GltfFile::read(document, parts.binary, |_| true, &mut beside)?;

    let mut assumptions = vec![];
    let animations = motion.animations.iter();
    let names: Vec<Option<&str>> = animations.map(|own| own.name.as_deref()).collect();
    let usual = Usual {
        index: 0,
        what: "the first",
    };
    let asked = options.animation.as_deref();
    let animation = &motion.animations[usual.or(asked, &names, &mut assumptions)?];
    let NodeTree { nodes, odd_scales } = NodeTree::read(&source.document)?;
    let bones = humanoid::bones(&motion.extensions, nodes.parent.len());
    let kept = kept(&nodes, &motion.skins, animation, &bones)?;
    let mut rest = nodes.place.clone();
    // VRM asks for a T-pose of the nodes.
    if options.rest == Rest::Bind && bones.is_empty() {
        let differ = bind(&source, &motion.skins, &nodes, &mut rest)?;
        if differ > 0 {
            assumptions.push(Assumption {
                what: "rest pose",
                taken: "that of the skins' bind matrices".into(),
                because: format!("{differ} joints' nodes are elsewhere"),
            });
        }
    }
    if odd_scales > 0 {
        assumptions.push(Assumption {
            what: "scale",
            taken: "even, and not mirrored".into(),
            because: format!("{odd_scales} nodes have another"),
        });
    }

    let joints = nodes.joints(&kept);
    let moves = moves(animation, &kept)?;
    let span = span(&source, &moves)?;
    let rate = rate(&span, options.rate, &mut assumptions)?;
    // A last frame that rounding moved a little beyond the end counts.
    let frames = ((span.end - span.start) * rate + 1e-3).floor() + 1.0;
    let frames = if frames < 1e9 {
        frames as usize
    } else {
        usize::MAX
    };
    check_size(frames, joints.len(), bytes.len().max(source.size()))?;
    let mut local = vec![LocalPose::new(DQuat::IDENTITY, DVec3::ZERO); frames * joints.len()];
    for (at, joint) in joints.iter().enumerate() {
        let [mut translation, mut rotation] = [None, None];
        for Move { path, sampler } in &moves[joint.node] {
            let curve = Some(Curve::read(&source, sampler, *path)?);
            match path {
                Path::Rotation => rotation = curve,
                _ => translation = curve,
            }
        }
        let still = nodes.place[joint.node];
        for frame in 0..frames {
            let time = span.start + frame as f64 / rate;
            let turned = match &rotation {
                None => Some(still.rotation),
                Some(curve) => curve.rotation(time),
            };
            let own = Place {
                translation: match &translation {
                    None => still.translation,
                    Some(curve) => curve.vector(time),
                },
                rotation: turned.ok_or_else(|| {
                    let found = format!("a rotation of length 0 of nodes[{}]", joint.node);
                    FormatError::metadata("channels", found, "quaternions")
                })?,
                scale: 1.0,
            };
            local[frame * joints.len() + at] = joint.pose(&own);
        }
    }
    let name = |node: usize| {
        let name = bones
            .get(&node)
            .or(source.document.nodes[node].name.as_ref());
        name.cloned().unwrap_or_else(|| format!("node {node}"))
    };
    let joints = joints.iter();
    let joints = joints.map(|joint| joint.at_rest(name(joint.node), &rest[joint.node]));
    Ok(Captured {
        capture: Capture {
            joints: joints.collect(),
            rate,
            local,
            unit: Some(1.0),
            up: UpAxis::Said(DVec3::Y),
            model_rest: false,
            expression: vec![],
            expression_len: 0,
        },
        assumptions,
    })
}

/// The node that a channel moves or turns.
fn moved(channel: &Channel) -> Option<usize> {
    let is_read = matches!(channel.target.path, Path::Translation | Path::Rotation);
    Some(channel.target.node.filter(|_| is_read)? as usize)
}

/// Nodes that become joints. `bones`: names of nodes that VRM has.
fn kept(
    tree: &SceneTree,
    skins: &[Skin],
    animation: &Animation,
    bones: &BTreeMap<usize, String>,
) -> Result<Vec<bool>, FormatError> {
    let count = tree.parent.len();
    let mark = |nodes: &mut dyn Iterator<Item = usize>, field, found| {
        let mut marked = vec![false; count];
        for node in nodes {
            let node = marked.get_mut(node);
            *node.ok_or_else(|| FormatError::metadata(field, found, "nodes"))? = true;
        }
        Ok(marked)
    };
    let mut channels = animation.channels.iter().filter_map(moved);
    let animated = mark(&mut channels, "channels", "a node that is not there")?;
    let joints = skins.iter().flat_map(|skin| &skin.joints);
    let mut joints = joints
        .map(|&joint| joint as usize)
        .chain(bones.keys().copied());
    let marked = mark(&mut joints, "skins", "a joint that is not there")?;
    if !marked.contains(&true) {
        return Ok(animated);
    }
    let above = tree.with_ancestors(&marked);
    let kept = (0..count).map(|node| marked[node] || (above[node] && animated[node]));
    Ok(kept.collect())
}

/// What moves or turns a joint.
#[derive(Clone, Copy)]
struct Move<'a> {
    path: Path,
    sampler: &'a Sampler,
}

/// What moves each node that is kept.
fn moves<'a>(animation: &'a Animation, kept: &[bool]) -> Result<Vec<Vec<Move<'a>>>, FormatError> {
    let mut moves = vec![vec![]; kept.len()];
    for channel in &animation.channels {
        let Some(node) = moved(channel).filter(|&node| kept[node]) else {
            continue;
        };
        let sampler = animation.samplers.get(channel.sampler as usize);
        let missing = || FormatError::metadata("samplers", "one that is not there", "samplers");
        moves[node].push(Move {
            path: channel.target.path,
            sampler: sampler.ok_or_else(missing)?,
        });
    }
    Ok(moves)
}

/// When keys stand.
struct KeySpan {
    start: f64,
    end: f64,
    /// The shortest time between two keys of a channel, seconds.
    shortest: Option<f64>,
}

fn span(source: &GltfFile, moves: &[Vec<Move>]) -> Result<KeySpan, FormatError> {
    let mut span = KeySpan {
        start: f64::INFINITY,
        end: f64::NEG_INFINITY,
        shortest: None,
    };
    let mut seen = BTreeSet::new();
    let mut keys = 0u64;
    for Move { sampler, .. } in moves.iter().flatten() {
        keys = keys.saturating_add(source.accessor(sampler.input)?.count);
        if keys > MAX_KEYS {
            return Err(FormatError::container(
                format!("{keys} keys"),
                format!("at most {MAX_KEYS}"),
            ));
        }
        if !seen.insert(sampler.input) {
            continue;
        }
        let times = times(source, sampler)?;
        span.start = span.start.min(times[0].into());
        span.end = span.end.max(times[times.len() - 1].into());
        for pair in times.windows(2).filter(|pair| pair[0] < pair[1]) {
            let step = f64::from(pair[1] - pair[0]);
            span.shortest = Some(span.shortest.map_or(step, |shortest| step.min(shortest)));
        }
    }
    if seen.is_empty() {
        return Err(FormatError::container(
            "an animation that moves no joint",
            "translations or rotations of joints",
        ));
    }
    Ok(span)
}

fn rate(
    span: &KeySpan,
    asked: Option<f64>,
    assumptions: &mut Vec<Assumption>,
) -> Result<f64, FormatError> {
    let dense = span
        .shortest
        .map_or(USUAL_RATE, |step| (1.0 / step).min(MAX_RATE));
    let dense = if dense < SPARSE { USUAL_RATE } else { dense };
    // Times are rounded to f32.
    let whole = dense.round();
    let near = (dense - whole).abs() < 2e-3 * whole;
    let rate = checked_rate(asked.unwrap_or(if near { whole } else { dense }))?;
    if asked.is_none() {
        assumptions.push(Assumption {
            what: "frames a second",
            taken: format!("{rate:.3}"),
            because: "keys stand at any time, and these are as dense or denser".into(),
        });
    }
    Ok(rate)
}
