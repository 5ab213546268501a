//! Animations of glTF 2.0 (`.glb`, `.gltf`), of VRM models (0.x and 1.0) and of VRM's own animation
//! files (`.vrma`).
//!
//! Joints are the joints of skins and what is animated above them; without skins, every node that
//! is animated; in VRM files, the bones of the human too, by VRM's names ("hips", "leftUpperArm").
//! Other nodes are part of what is below them. Scales go into offsets: they are taken to be even
//! and not to change. Weights of shapes, VRM's expressions and its gaze are left out.
//!
//! glTF is in metres with y up. Its keys stand at any time, so they are sampled.

mod accessor;
mod container;
mod curve;
mod document;
mod humanoid;
mod tree;

use crate::{
    assumption::Assumption,
    capture::{Capture, Captured, LocalPose, Rest, UpAxis, check_size},
    glb,
    scene_tree::{Joint, Place},
};
use accessor::Source;
use curve::{Curve, times};
use document::{Animation, Document, Path};
use effigy_core::io::file::{FormatError, excerpt};
use glam::{DQuat, DVec3};
use tree::{Bind, Tree, bind};

/// Frames a second at most, where keys are denser.
const MAX_RATE: f64 = 60.0;
/// Frames a second where keys are sparser than [`SPARSE`].
const USUAL_RATE: f64 = 30.0;
const SPARSE: f64 = 24.0;
/// Keys of all channels, at most.
const MAX_KEYS: usize = 50_000_000;
/// Animations that an error or assumption names.
const NAMED: usize = 20;

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
    let parts = glb::parts(bytes)?;
    let document: Document = serde_json::from_slice(&parts.document)
        .map_err(|error| glb::unreadable(&parts.document, &error))?;
    let buffers = container::buffers(&document, parts.binary, beside)?;
    let held = buffers.iter().map(|buffer| buffer.len()).sum::<usize>();
    let source = Source { document, buffers };
    Reading::new(&source, options)?.captured(bytes.len().max(held))
}

/// Joints, parents before their children, and where nodes are at rest.
struct Resting {
    joints: Vec<Joint>,
    rest: Vec<Place>,
}

/// The curves of a node.
#[derive(Default)]
struct Curves {
    translation: Option<Curve>,
    rotation: Option<Curve>,
}

struct Reading<'a> {
    source: &'a Source<'a>,
    animation: &'a Animation,
    tree: Tree,
    names: Vec<Option<String>>,
    rest: Rest,
    rate: Option<f64>,
    assumptions: Vec<Assumption>,
}

/// When keys stand.
struct Span {
    start: f64,
    end: f64,
    /// The shortest time between two keys of a channel, seconds.
    shortest: Option<f64>,
}

impl<'a> Reading<'a> {
    fn new(source: &'a Source, options: &Options) -> Result<Self, FormatError> {
        let document = &source.document;
        let mut assumptions = vec![];
        let animation = chosen(document, options.animation.as_deref(), &mut assumptions)?;
        let tree = Tree::read(document)?;
        let mut names = vec![None; document.nodes.len()];
        let bones = humanoid::bones(document);
        // VRM asks for a T-pose of the nodes.
        let rest = if bones.is_empty() {
            options.rest
        } else {
            Rest::Nodes
        };
        for bone in bones {
            names[bone.node] = Some(bone.name);
        }
        Ok(Self {
            source,
            animation,
            tree,
            names,
            rest,
            rate: options.rate,
            assumptions,
        })
    }

    /// Nodes that become joints.
    fn kept(&self) -> Result<Vec<bool>, FormatError> {
        let count = self.tree.nodes.parent.len();
        let mut animated = vec![false; count];
        for channel in &self.animation.channels {
            if let (Path::Translation | Path::Rotation, Some(node)) =
                (channel.target.path, channel.target.node)
            {
                let node = animated.get_mut(node as usize);
                *node.ok_or_else(|| {
                    FormatError::metadata("channels", "a node that is not there", "nodes")
                })? = true;
            }
        }
        let mut marked: Vec<bool> = self.names.iter().map(Option::is_some).collect();
        for &joint in self
            .source
            .document
            .skins
            .iter()
            .flat_map(|skin| &skin.joints)
        {
            let joint = marked.get_mut(joint as usize);
            *joint.ok_or_else(|| {
                FormatError::metadata("skins", "a joint that is not there", "nodes")
            })? = true;
        }
        if !marked.contains(&true) {
            return Ok(animated);
        }
        let above = self.tree.nodes.with_ancestors(&marked);
        let kept = (0..count).map(|node| marked[node] || (above[node] && animated[node]));
        Ok(kept.collect())
    }

    fn joints(&mut self) -> Result<Resting, FormatError> {
        let kept = self.kept()?;
        let rest = match self.rest {
            Rest::Nodes => Bind {
                place: self.tree.nodes.place.clone(),
                differ: Default::default(),
            },
            Rest::Bind => bind(self.source, &self.tree.nodes)?,
        };
        if !rest.differ.is_empty() {
            self.assumptions.push(Assumption {
                what: "rest pose",
                taken: "that of the skins' bind matrices".into(),
                because: format!("{} joints' nodes are elsewhere", rest.differ.len()),
            });
        }
        if self.tree.odd_scales > 0 {
            self.assumptions.push(Assumption {
                what: "scale",
                taken: "even, and not mirrored".into(),
                because: format!("{} nodes have another", self.tree.odd_scales),
            });
        }
        let joints = self.tree.nodes.joints(&kept);
        Ok(Resting {
            joints,
            rest: rest.place,
        })
    }

    /// The channels of joints, and when their keys stand.
    fn span(&self, index: &[Option<usize>]) -> Result<Span, FormatError> {
        let mut span = Span {
            start: f64::INFINITY,
            end: f64::NEG_INFINITY,
            shortest: None,
        };
        let mut seen = std::collections::BTreeSet::new();
        let mut keys = 0usize;
        for channel in &self.animation.channels {
            let Some(sampler) = self.sampler(channel, index)? else {
                continue;
            };
            keys = keys.saturating_add(self.source.count(sampler.input)? as usize);
            if keys > MAX_KEYS {
                return Err(FormatError::container(
                    format!("{keys} keys"),
                    format!("at most {MAX_KEYS}"),
                ));
            }
            if !seen.insert(sampler.input) {
                continue;
            }
            let times = times(self.source, sampler)?;
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

    /// The sampler of a channel that moves a joint.
    fn sampler(
        &self,
        channel: &document::Channel,
        index: &[Option<usize>],
    ) -> Result<Option<&'a document::Sampler>, FormatError> {
        let moves = matches!(channel.target.path, Path::Translation | Path::Rotation);
        let joint = channel
            .target
            .node
            .and_then(|node| index.get(node as usize)?.as_ref());
        if !moves || joint.is_none() {
            return Ok(None);
        }
        let sampler = self.animation.samplers.get(channel.sampler as usize);
        let missing = || FormatError::metadata("samplers", "one that is not there", "samplers");
        sampler.ok_or_else(missing).map(Some)
    }

    fn rate(&mut self, span: &Span) -> Result<f64, FormatError> {
        let dense = span
            .shortest
            .map_or(USUAL_RATE, |step| (1.0 / step).min(MAX_RATE));
        let dense = if dense < SPARSE { USUAL_RATE } else { dense };
        // Times are rounded to f32.
        let whole = dense.round();
        let near = (dense - whole).abs() < 2e-3 * whole;
        let rate = self.rate.unwrap_or(if near { whole } else { dense });
        if !(rate.is_finite() && rate > 0.0) {
            return Err(FormatError::container(
                format!("{rate} frames a second"),
                "a number above 0",
            ));
        }
        if self.rate.is_none() {
            self.assumptions.push(Assumption {
                what: "frames a second",
                taken: format!("{rate:.3}"),
                because: "keys stand at any time, and these are as dense or denser".into(),
            });
        }
        Ok(rate)
    }

    /// `size`: bytes of the file.
    fn captured(mut self, size: usize) -> Result<Captured, FormatError> {
        let Resting { joints, rest } = self.joints()?;
        let mut index = vec![None; self.tree.nodes.parent.len()];
        for (at, joint) in joints.iter().enumerate() {
            index[joint.node] = Some(at);
        }
        let span = self.span(&index)?;
        let rate = self.rate(&span)?;
        // A last frame that rounding moved a little beyond the end counts.
        let frames = ((span.end - span.start) * rate + 1e-3).floor() + 1.0;
        let frames = if frames < 1e9 {
            frames as usize
        } else {
            usize::MAX
        };
        check_size(frames, joints.len(), size)?;
        let mut capture = Capture {
            joints: joints
                .iter()
                .map(|joint| joint.at_rest(self.name(joint.node), &rest[joint.node]))
                .collect(),
            rate,
            local: vec![LocalPose::new(DQuat::IDENTITY, DVec3::ZERO); frames * joints.len()],
            unit: Some(1.0),
            up: UpAxis::Said(DVec3::Y),
            model_rest: false,
            expression: vec![],
            expression_len: 0,
        };
        let mut channels: Vec<Vec<&document::Channel>> = vec![vec![]; joints.len()];
        for channel in &self.animation.channels {
            let node = channel
                .target
                .node
                .and_then(|node| index.get(node as usize).copied());
            if let Some(Some(joint)) = node {
                channels[joint].push(channel);
            }
        }
        for (at, joint) in joints.iter().enumerate() {
            let mut curves = Curves::default();
            for channel in &channels[at] {
                let Some(sampler) = self.sampler(channel, &index)? else {
                    continue;
                };
                let curve = Curve::read(self.source, sampler, channel.target.path)?;
                if channel.target.path == Path::Rotation {
                    curves.rotation = Some(curve);
                } else {
                    curves.translation = Some(curve);
                }
            }
            let still = &self.tree.nodes.place[joint.node];
            for frame in 0..frames {
                let time = span.start + frame as f64 / rate;
                let moving = curves.translation.as_ref().map(|curve| curve.vector(time));
                let rotation = match &curves.rotation {
                    None => Some(still.rotation),
                    Some(curve) => curve.rotation(time),
                };
                let rotation = rotation.ok_or_else(|| {
                    FormatError::metadata(
                        "channels",
                        format!("a rotation of length 0 of nodes[{}]", joint.node),
                        "quaternions",
                    )
                })?;
                let own = Place {
                    translation: moving.unwrap_or(still.translation),
                    rotation,
                    scale: 1.0,
                };
                capture.local[frame * joints.len() + at] = joint.pose(&own);
            }
        }
        Ok(Captured {
            capture,
            assumptions: self.assumptions,
        })
    }

    fn name(&self, node: usize) -> String {
        let bone = self.names[node].as_ref();
        let name = bone.or(self.source.document.nodes[node].name.as_ref());
        name.cloned().unwrap_or_else(|| format!("node {node}"))
    }
}

/// The animation that is asked for: by name, by number, or the first.
fn chosen<'a>(
    document: &'a Document,
    asked: Option<&str>,
    assumptions: &mut Vec<Assumption>,
) -> Result<&'a Animation, FormatError> {
    let animations = &document.animations;
    let name = |at: usize| match &animations[at].name {
        Some(name) => format!("`{}`", excerpt(name)),
        None => format!("number {at}"),
    };
    let mut names: Vec<String> = (0..animations.len().min(NAMED)).map(name).collect();
    if animations.len() > NAMED {
        names.push(format!("{} more", animations.len() - NAMED));
    }
    let names = names.join(", ");
    let found = match asked {
        None => (!animations.is_empty()).then_some(0),
        Some(asked) => {
            let by_name = animations
                .iter()
                .position(|animation| animation.name.as_deref() == Some(asked));
            by_name.or_else(|| asked.parse().ok())
        }
    };
    let Some(found) = found.filter(|&found| found < animations.len()) else {
        let found = match (asked, animations.is_empty()) {
            (_, true) => "no animation".to_owned(),
            (Some(asked), false) => format!("no animation `{}`", excerpt(asked)),
            (None, false) => "nothing".to_owned(),
        };
        let expected = if animations.is_empty() {
            "at least one".to_owned()
        } else {
            format!("one of {names}")
        };
        return Err(FormatError::metadata("animations", found, expected));
    };
    if asked.is_none() && animations.len() > 1 {
        assumptions.push(Assumption {
            what: "animation",
            taken: name(found),
            because: format!("it is the first of {names}"),
        });
    }
    Ok(&animations[found])
}
