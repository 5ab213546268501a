//! MakeHuman's rig and its weights (two JSON files): joints with their parents, where each joint
//! sits on the mesh, and normalised skin weights, in SMPL-X's order of joints.

use crate::bake::source::text::SourceError;
use effigy_core::avatar::limits;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::Path;

const PREFIX: &str = "mixamorig:";

/// SMPL-X's joints 0 to 21 by the names that the mixamo rig gives them; fingers follow.
pub const BODY: [&str; 22] = [
    "Hips",
    "LeftUpLeg",
    "RightUpLeg",
    "Spine",
    "LeftLeg",
    "RightLeg",
    "Spine1",
    "LeftFoot",
    "RightFoot",
    "Spine2",
    "LeftToeBase",
    "RightToeBase",
    "Neck",
    "LeftShoulder",
    "RightShoulder",
    "Head",
    "LeftArm",
    "RightArm",
    "LeftForeArm",
    "RightForeArm",
    "LeftHand",
    "RightHand",
];

#[derive(Deserialize)]
struct RigFile {
    bones: BTreeMap<String, BoneEntry>,
}

#[derive(Deserialize)]
struct BoneEntry {
    parent: String,
    head: BoneHead,
}

#[derive(Deserialize)]
struct BoneHead {
    strategy: String,
    cube_name: Option<String>,
    vertex_indices: Option<Vec<u32>>,
}

#[derive(Deserialize)]
#[serde(rename = "WeightFile")]
struct RigWeightFile {
    weights: BTreeMap<String, Vec<(u32, f64)>>,
}

/// A joint's place on the mesh: the mean of some vertices.
#[derive(Clone, Debug, PartialEq)]
pub enum JointPlace {
    /// These vertices.
    Vertices(Vec<u32>),
    /// The vertices of this group of the mesh's faces.
    Group(String),
}

/// A joint of a rig.
#[derive(Clone, Debug, PartialEq)]
pub struct RigBone {
    /// Without the rig's prefix.
    pub name: String,
    /// An index into the bones; `None` for the hips.
    pub parent: Option<u8>,
    /// Where the joint is.
    pub place: JointPlace,
}

/// A joint that moves a point, and how much.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointInfluence {
    /// The joint's index.
    pub joint: u8,
    /// Above 0. The weights of a point sum to 1.
    pub weight: f64,
}

/// The joints that move a vertex, the largest weight first.
pub type Influences = Vec<PointInfluence>;

/// Adds to the weight of a joint.
pub fn add_weight(influences: &mut Influences, joint: u8, weight: f64) {
    match influences.iter_mut().find(|known| known.joint == joint) {
        Some(known) => known.weight += weight,
        None => influences.push(PointInfluence { joint, weight }),
    }
}

/// Sorts by weight, the largest first, and equal ones by joint.
pub fn sort_by_weight(influences: &mut Influences) {
    influences.sort_by(|a, b| b.weight.total_cmp(&a.weight).then(a.joint.cmp(&b.joint)));
}

fn content(file: &Path, found: impl Into<String>, expected: impl Into<String>) -> SourceError {
    SourceError::Content {
        file: file.to_path_buf(),
        found: found.into(),
        expected: expected.into(),
    }
}

fn json<'a, T: Deserialize<'a>>(file: &Path, text: &'a str) -> Result<T, SourceError> {
    serde_json::from_str(text).map_err(|error| SourceError::Syntax {
        file: file.to_path_buf(),
        line: error.line(),
        found: error.to_string(),
        expected: "a MakeHuman rig or weights file".into(),
    })
}

/// Reads the rig: body joints in SMPL-X's order, then the rest by name. A parent comes before its
/// children. `vertices`: how many the mesh has.
///
/// # Errors
/// When the file is malformed, lacks a body joint, or names a vertex that is not there.
pub fn bones(file: &Path, text: &str, vertices: usize) -> Result<Vec<RigBone>, SourceError> {
    let mut entries: BTreeMap<String, BoneEntry> = json::<RigFile>(file, text)?
        .bones
        .into_iter()
        .map(|(name, bone)| (name.trim_start_matches(PREFIX).to_owned(), bone))
        .collect();
    let mut order: Vec<String> = BODY.map(String::from).to_vec();
    order.extend(
        entries
            .keys()
            .filter(|name| !BODY.contains(&name.as_str()))
            .cloned(),
    );
    if order.len() > limits::JOINTS {
        return Err(content(
            file,
            format!("{} bones", order.len()),
            format!("at most {}", limits::JOINTS),
        ));
    }
    let mut bones: Vec<RigBone> = Vec::with_capacity(order.len());
    for name in order {
        let entry = entries
            .remove(&name)
            .ok_or_else(|| content(file, format!("no bone {PREFIX}{name}"), "one"))?;
        let parent = entry.parent.trim_start_matches(PREFIX);
        let parent = match bones.iter().position(|bone| bone.name == parent) {
            Some(index) => Some(index as u8),
            None if bones.is_empty() && parent.is_empty() => None,
            None => {
                return Err(content(
                    file,
                    format!("bone {name} under \"{parent}\""),
                    "a parent that stands before it",
                ));
            }
        };
        let place = place(file, &name, entry.head, vertices)?;
        bones.push(RigBone {
            name,
            parent,
            place,
        });
    }
    Ok(bones)
}

fn place(
    file: &Path,
    name: &str,
    head: BoneHead,
    vertices: usize,
) -> Result<JointPlace, SourceError> {
    match (head.strategy.as_str(), head.cube_name, head.vertex_indices) {
        ("CUBE", Some(group), _) => Ok(JointPlace::Group(group)),
        ("MEAN", _, Some(list)) if !list.is_empty() => {
            match list.iter().find(|&&v| v as usize >= vertices) {
                Some(vertex) => Err(content(
                    file,
                    format!("vertex {vertex} at bone {name}"),
                    format!("one below {vertices}"),
                )),
                None => Ok(JointPlace::Vertices(list)),
            }
        }
        (other, ..) => Err(content(
            file,
            format!("strategy \"{other}\" at bone {name}"),
            "CUBE with a cube_name, or MEAN with vertex_indices",
        )),
    }
}

/// Reads the skin weights of every vertex, scaled to a sum of 1: the file's own sums lie between
/// 0.2 and 1.5.
///
/// # Errors
/// When the file is malformed, or leaves a vertex without weight.
pub fn weights(
    file: &Path,
    text: &str,
    bones: &[RigBone],
    vertices: usize,
) -> Result<Vec<Influences>, SourceError> {
    let mut influences: Vec<Influences> = vec![Vec::new(); vertices];
    for (name, list) in json::<RigWeightFile>(file, text)?.weights {
        let short = name.trim_start_matches(PREFIX);
        let joint = bones
            .iter()
            .position(|bone| bone.name == short)
            .ok_or_else(|| content(file, format!("weights of {name}"), "a bone of the rig"))?;
        for (vertex, weight) in list {
            let own = influences.get_mut(vertex as usize).ok_or_else(|| {
                content(
                    file,
                    format!("vertex {vertex} under {name}"),
                    format!("one below {vertices}"),
                )
            })?;
            if !(0.0..=1e3).contains(&weight) {
                return Err(content(
                    file,
                    format!("weight {weight} of vertex {vertex} under {name}"),
                    "one from 0 on",
                ));
            }
            if weight > 0.0 {
                own.push(PointInfluence {
                    joint: joint as u8,
                    weight,
                });
            }
        }
    }
    for (vertex, list) in influences.iter_mut().enumerate() {
        let sum: f64 = list.iter().map(|influence| influence.weight).sum();
        if sum <= 0.0 {
            return Err(content(
                file,
                format!("no weight for vertex {vertex}"),
                "at least one",
            ));
        }
        for influence in list.iter_mut() {
            influence.weight /= sum;
        }
        sort_by_weight(list);
    }
    Ok(influences)
}
