//! The folder of source files in; the shaped body out: vertices in metres, skeleton, skin weights, expression displacements, landmarks.

use super::obj::Obj;
use super::rig::{self, Bone, Influences, Place};
use super::target::Target;
use super::text::{self, Error};
use crate::avatar::Skeleton;
use glam::{DAffine3, DVec3};
use std::path::{Path, PathBuf};

/// Decimetres, MakeHuman's unit, to metres.
const METRES: f64 = 0.1;
/// Room for the soles of the shoes under the feet, decimetres.
const SOLE: f64 = 0.14;
/// How far outwards both hips turn in the canonical pose, degrees.
const CANONICAL_HIPS: f64 = 25.0;

/// Which of the body's shapes to bake.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(not(target_os = "android"), derive(clap::ValueEnum))]
pub enum Shape {
    Male,
    Female,
}

/// The components of θ_e: each is the full strength of some ARKit-named expression targets.
pub const EXPRESSIONS: [(&str, &[&str]); 10] = [
    ("jaw open", &["jawOpen"]),
    ("smile", &["mouthSmileLeft", "mouthSmileRight"]),
    ("blink", &["eyeBlinkLeft", "eyeBlinkRight"]),
    ("brows up", &["browInnerUp", "browOuterUpLeft", "browOuterUpRight"]),
    ("brows down", &["browDownLeft", "browDownRight"]),
    ("pucker", &["mouthPucker"]),
    ("frown", &["mouthFrownLeft", "mouthFrownRight"]),
    ("eyes wide", &["eyeWideLeft", "eyeWideRight"]),
    ("cheeks puffed", &["cheekPuff"]),
    ("nose wrinkled", &["noseSneerLeft", "noseSneerRight"]),
];

/// Where the source files are.
#[derive(Clone, Debug)]
pub struct Assets {
    root: PathBuf,
}

impl Assets {
    /// The folder that `tools/fetch_assets.sh` fills unless told otherwise.
    pub const DEFAULT: &str = "target/assets";

    pub fn new(root: impl Into<PathBuf>) -> Self {
        Self { root: root.into() }
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.root.join(name)
    }

    fn target(&self, name: &str, vertices: usize) -> Result<Target, Error> {
        let file = self.path(name);
        Target::parse(&file, &text::read(&file)?, vertices)
    }
}

/// The body in its rest pose, metres, soles of its shoes at y = 0.
#[derive(Clone, Debug)]
pub struct Body {
    /// Faces and groups; its positions are the shaped ones.
    pub obj: Obj,
    pub skeleton: Skeleton,
    /// One entry a vertex.
    pub weights: Vec<Influences>,
    /// Displacement of each vertex at full strength of each of [`EXPRESSIONS`].
    pub expressions: Vec<[DVec3; 10]>,
}

impl Body {
    pub fn load(assets: &Assets, shape: Shape) -> Result<Self, Error> {
        let file = assets.path("base.obj");
        let mut obj = Obj::parse(&file, &text::read(&file)?)?;
        let vertices = obj.positions.len();
        let sex = if shape == Shape::Male { "male" } else { "female" };
        for name in [format!("universal-{sex}-young-averagemuscle-averageweight"), format!("caucasian-{sex}-young")] {
            assets.target(&format!("targets/{name}.target.gz"), vertices)?.apply(&mut obj.positions, 1.0);
        }
        let ground = ground(&obj, &file)?;
        obj.positions.iter_mut().for_each(|p| *p = METRES * (*p - DVec3::new(0.0, ground - SOLE, 0.0)));

        let rig_file = assets.path("rig.mixamo.json");
        let bones = rig::bones(&rig_file, &text::read(&rig_file)?, vertices)?;
        let weight_file = assets.path("weights.mixamo.json");
        let weights = rig::weights(&weight_file, &text::read(&weight_file)?, &bones, vertices)?;
        let mut expressions = vec![[DVec3::ZERO; 10]; vertices];
        for (component, (_, targets)) in EXPRESSIONS.iter().enumerate() {
            for name in *targets {
                for (vertex, by) in assets.target(&format!("faceunits/{name}.target"), vertices)?.moves {
                    expressions[vertex as usize][component] += METRES * by;
                }
            }
        }
        let skeleton = skeleton(&obj, &bones, &rig_file)?;
        Ok(Self { obj, skeleton, weights, expressions })
    }

    /// Where the rest pose puts a joint.
    pub fn joint(&self, name: &str) -> DVec3 {
        let index = self.skeleton.name.iter().position(|joint| joint == name).expect("the rig's reader insists on every body joint");
        DVec3::from(self.skeleton.rest[index].map(f64::from))
    }

    /// Mean of a group's corners, None where the mesh has no such group.
    pub fn center(&self, group: &str) -> Option<DVec3> {
        group_center(&self.obj, group)
    }

    /// Rest pose to canonical pose, one matrix a joint.
    pub fn to_canonical(&self) -> Vec<DAffine3> {
        let mut rest = self.skeleton.clone();
        rest.canonical.iter_mut().for_each(|turn| *turn = [0.0; 3]);
        let mut pose = crate::avatar::Pose::rest(rest.len(), 0);
        pose.rotation = self.skeleton.canonical.iter().map(|turn| DVec3::from(turn.map(f64::from))).collect();
        rest.matrices(&pose)
    }
}

/// The weighted mean of joint matrices: linear blend skinning.
pub fn blend(matrices: &[DAffine3], weights: &[(u8, f64)]) -> DAffine3 {
    let mut sum = DAffine3 { matrix3: glam::DMat3::ZERO, translation: DVec3::ZERO };
    for &(joint, weight) in weights {
        let matrix = &matrices[usize::from(joint)];
        sum.matrix3 += matrix.matrix3 * weight;
        sum.translation += matrix.translation * weight;
    }
    sum
}

/// The lowest point of the body's own surface, in the file's unit.
fn ground(obj: &Obj, file: &Path) -> Result<f64, Error> {
    let lowest = obj.group("body").iter().flatten().map(|corner| obj.positions[corner.vertex as usize].y).fold(f64::INFINITY, f64::min);
    if lowest.is_finite() {
        return Ok(lowest);
    }
    Err(Error::Content {
        file: file.to_path_buf(),
        found: "no faces in group \"body\"".into(),
        expected: "MakeHuman's base mesh hm08".into(),
    })
}

fn group_center(obj: &Obj, group: &str) -> Option<DVec3> {
    let mut vertices: Vec<u32> = obj.group(group).iter().flatten().map(|corner| corner.vertex).collect();
    vertices.sort_unstable();
    vertices.dedup();
    let sum: DVec3 = vertices.iter().map(|&v| obj.positions[v as usize]).sum();
    (!vertices.is_empty()).then(|| sum / vertices.len() as f64)
}

fn skeleton(obj: &Obj, bones: &[Bone], file: &Path) -> Result<Skeleton, Error> {
    let at = |bone: &Bone| match &bone.place {
        Place::Vertices(list) => Ok(list.iter().map(|&v| obj.positions[v as usize]).sum::<DVec3>() / list.len() as f64),
        Place::Group(group) => group_center(obj, group).ok_or_else(|| Error::Content {
            file: file.to_path_buf(),
            found: format!("bone {} at group \"{group}\", which the mesh lacks", bone.name),
            expected: "a group of base.obj".into(),
        }),
    };
    let rest = bones.iter().map(|bone| at(bone).map(|p| p.as_vec3().to_array())).collect::<Result<_, _>>()?;
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
