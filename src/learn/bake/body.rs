//! The shaped body from the source files: vertices in metres, skeleton, skin weights, expression
//! displacements, landmarks.

use crate::bake::source::assets::Assets;
use crate::bake::source::obj::Obj;
use crate::bake::source::rig::{self, Influences, JointPlace, PointInfluence, RigBone};
use crate::bake::source::target::MorphTarget;
use crate::bake::source::text::{self, SourceError};
use crate::bake::style::Style;
use effigy_core::avatar::{Pose, Skeleton};
use glam::{DAffine3, DVec3};
use std::path::Path;

/// Decimetres, MakeHuman's unit, to metres.
const METRES: f64 = 0.1;
/// Thickness of the shoes' soles, by which the feet stand above the ground, decimetres.
const SOLE: f64 = 0.14;
/// How far outwards both hips turn in the canonical pose, degrees.
const CANONICAL_HIPS: f64 = 25.0;

/// The body's shapes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BodyShape {
    /// The average young male body.
    Male,
    /// The average young female body.
    Female,
}

impl BodyShape {
    /// The names that command lines give the shapes, in the order of [`Self::ALL`].
    pub const NAMES: [&str; 2] = ["male", "female"];
    /// Every shape.
    pub const ALL: [Self; 2] = [Self::Male, Self::Female];
}

/// A person to make: a body, and what it looks like.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Person {
    /// The body.
    pub shape: BodyShape,
    /// Skin, hair and clothes.
    pub style: &'static Style,
}

impl Person {
    /// The names that command lines give the persons, in the order of [`Self::ALL`].
    pub const NAMES: [&str; 2] = ["1", "2"];
    /// Every person: one of each body.
    pub const ALL: [Self; 2] = [
        Self {
            shape: BodyShape::Male,
            style: &Style::FIRST,
        },
        Self {
            shape: BodyShape::Female,
            style: &Style::SECOND,
        },
    ];
}

impl From<BodyShape> for Person {
    /// The first person's look on a body.
    fn from(shape: BodyShape) -> Self {
        Self {
            shape,
            style: &Style::FIRST,
        }
    }
}

/// The components of θ_e: the name of each, and the ARKit-named expression targets that it is the
/// full strength of.
pub const EXPRESSIONS: [(&str, &[&str]); 10] = [
    ("jaw open", &["jawOpen"]),
    ("smile", &["mouthSmileLeft", "mouthSmileRight"]),
    ("blink", &["eyeBlinkLeft", "eyeBlinkRight"]),
    (
        "brows up",
        &["browInnerUp", "browOuterUpLeft", "browOuterUpRight"],
    ),
    ("brows down", &["browDownLeft", "browDownRight"]),
    ("pucker", &["mouthPucker"]),
    ("frown", &["mouthFrownLeft", "mouthFrownRight"]),
    ("eyes wide", &["eyeWideLeft", "eyeWideRight"]),
    ("cheeks puffed", &["cheekPuff"]),
    ("nose wrinkled", &["noseSneerLeft", "noseSneerRight"]),
];

/// The body in its rest pose, metres, soles of its shoes at y = 0.
#[derive(Clone, Debug)]
pub struct BakedBody {
    /// Faces and groups; its positions are the shaped ones.
    pub obj: Obj,
    /// Joints in SMPL-X's order, then fingers.
    pub skeleton: Skeleton,
    /// One entry a vertex.
    pub weights: Vec<Influences>,
    /// Displacement of each vertex at full strength of each of [`EXPRESSIONS`].
    pub expressions: Vec<[DVec3; 10]>,
}

impl BakedBody {
    /// Reads and shapes the body.
    ///
    /// # Errors
    /// When a source file is missing or damaged.
    pub fn load(assets: &Assets, shape: BodyShape) -> Result<Self, SourceError> {
        let file = assets.path("base.obj");
        let mut obj = Obj::parse(&file, &text::read(&file)?)?;
        let vertices = obj.positions.len();
        let sex = match shape {
            BodyShape::Male => "male",
            BodyShape::Female => "female",
        };
        for name in [
            format!("universal-{sex}-young-averagemuscle-averageweight"),
            format!("caucasian-{sex}-young"),
        ] {
            let target = load_target(assets, &format!("targets/{name}.target.gz"), vertices)?;
            target.apply(&mut obj.positions, 1.0);
        }
        let ground = ground(&obj, &file)?;
        for p in &mut obj.positions {
            *p = METRES * (*p - DVec3::new(0.0, ground - SOLE, 0.0));
        }

        let rig_file = assets.path("rig.mixamo.json");
        let bones = rig::bones(&rig_file, &text::read(&rig_file)?, vertices)?;
        let weight_file = assets.path("weights.mixamo.json");
        let weights = rig::weights(&weight_file, &text::read(&weight_file)?, &bones, vertices)?;
        let mut expressions = vec![[DVec3::ZERO; 10]; vertices];
        for (component, (_, targets)) in EXPRESSIONS.iter().enumerate() {
            for name in *targets {
                let target = load_target(assets, &format!("faceunits/{name}.target"), vertices)?;
                for (vertex, by) in target.displacements {
                    expressions[vertex as usize][component] += METRES * by;
                }
            }
        }
        let skeleton = skeleton(&obj, &bones, &rig_file)?;
        Ok(Self {
            obj,
            skeleton,
            weights,
            expressions,
        })
    }

    /// A body joint's position in the rest pose.
    ///
    /// # Panics
    /// When the rig has no joint of that name; it has all of [`rig::BODY`].
    pub fn joint(&self, name: &str) -> DVec3 {
        let index = self
            .skeleton
            .name
            .iter()
            .position(|joint| joint == name)
            .expect("the rig's reader insists on every body joint");
        DVec3::from(self.skeleton.rest[index].map(f64::from))
    }

    /// The mean of a group's vertices; `None` if the mesh has no such group.
    pub fn group_center(&self, group: &str) -> Option<DVec3> {
        center_of_group(&self.obj, group)
    }

    /// Rest pose to canonical pose, one matrix a joint.
    pub fn to_canonical(&self) -> Vec<DAffine3> {
        let mut rest = self.skeleton.clone();
        rest.canonical.fill([0.0; 3]);
        let mut pose = Pose::rest(rest.len(), 0);
        pose.rotation = self
            .skeleton
            .canonical
            .iter()
            .map(|turn| DVec3::from(turn.map(f64::from)))
            .collect();
        rest.matrices(&pose)
    }
}

fn load_target(assets: &Assets, name: &str, vertices: usize) -> Result<MorphTarget, SourceError> {
    let file = assets.path(name);
    MorphTarget::parse(&file, &text::read(&file)?, vertices)
}

/// The weighted mean of joint matrices: linear blend skinning.
pub fn blend(matrices: &[DAffine3], influences: &[PointInfluence]) -> DAffine3 {
    let mut sum = DAffine3 {
        matrix3: glam::DMat3::ZERO,
        translation: DVec3::ZERO,
    };
    for influence in influences {
        let matrix = &matrices[usize::from(influence.joint)];
        sum.matrix3 += matrix.matrix3 * influence.weight;
        sum.translation += matrix.translation * influence.weight;
    }
    sum
}

/// The lowest point of the body's own surface, in the file's unit.
fn ground(obj: &Obj, file: &Path) -> Result<f64, SourceError> {
    let lowest = obj
        .group("body")
        .iter()
        .flatten()
        .map(|corner| obj.positions[corner.vertex as usize].y)
        .fold(f64::INFINITY, f64::min);
    if lowest.is_finite() {
        return Ok(lowest);
    }
    Err(SourceError::Content {
        file: file.to_path_buf(),
        found: "no faces in group \"body\"".into(),
        expected: "MakeHuman's base mesh hm08".into(),
    })
}

fn center_of_group(obj: &Obj, group: &str) -> Option<DVec3> {
    let mut vertices: Vec<u32> = obj
        .group(group)
        .iter()
        .flatten()
        .map(|corner| corner.vertex)
        .collect();
    vertices.sort_unstable();
    vertices.dedup();
    let sum: DVec3 = vertices.iter().map(|&v| obj.positions[v as usize]).sum();
    (!vertices.is_empty()).then(|| sum / vertices.len() as f64)
}

fn skeleton(obj: &Obj, bones: &[RigBone], file: &Path) -> Result<Skeleton, SourceError> {
    let position = |bone: &RigBone| match &bone.place {
        JointPlace::Vertices(list) => Ok(list
            .iter()
            .map(|&v| obj.positions[v as usize])
            .sum::<DVec3>()
            / list.len() as f64),
        JointPlace::Group(group) => {
            center_of_group(obj, group).ok_or_else(|| SourceError::Content {
                file: file.to_path_buf(),
                found: format!(
                    "bone {} at group \"{group}\", which the mesh lacks",
                    bone.name
                ),
                expected: "a group of base.obj".into(),
            })
        }
    };
    let rest = bones
        .iter()
        .map(|bone| position(bone).map(|p| p.as_vec3().to_array()))
        .collect::<Result<_, _>>()?;
    let mut canonical = vec![[0.0; 3]; bones.len()];
    canonical[1][2] = CANONICAL_HIPS.to_radians() as f32;
    canonical[2][2] = -CANONICAL_HIPS.to_radians() as f32;
    Ok(Skeleton {
        name: bones.iter().map(|bone| bone.name.clone()).collect(),
        parent: bones.iter().map(|bone| bone.parent).collect(),
        rest,
        canonical,
    })
}
