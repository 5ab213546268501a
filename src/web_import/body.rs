//! The avatar that a clip is for, as far as motion of another body needs it. The page's main
//! library writes it, `AvatarCanvas::skeleton` and `AvatarCanvas::skin`.

use bytemuck::{Pod, Zeroable};
use effigy_core::{
    avatar::{Bounds, Skeleton},
    io::file::FormatError,
};
use effigy_formats::retarget::{Girth, TrunkSkin};
use serde::Deserialize;

/// A skeleton, and where its Gaussians are.
pub struct SkinnedBody {
    /// The avatar's.
    pub skeleton: Skeleton,
    bounds: Bounds,
    position: Vec<[u16; 3]>,
    joint: Vec<[u8; 4]>,
    joint_weight: Vec<[u8; 4]>,
}

/// What the main library says of a skeleton of J joints.
#[derive(Deserialize)]
struct SkeletonDocument {
    /// Names; length J.
    joints: Vec<String>,
    /// Indices, null for the root; length J.
    parents: Vec<Option<u8>>,
    /// Positions at rest, metres; shape J, 3.
    rest: Vec<[f32; 3]>,
    /// Axis-angle rotations of the canonical pose, radians; shape J, 3.
    canonical: Vec<[f32; 3]>,
    /// Lower and upper corner of the Gaussians' box, metres.
    bounds: [[f32; 3]; 2],
}

/// A Gaussian as the main library writes it.
#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
struct SkinnedPoint {
    /// In the box.
    position: [u16; 3],
    joint: [u8; 4],
    /// Of 255.
    weight: [u8; 4],
}

impl SkinnedBody {
    /// Reads a body. `skeleton`: JSON; `skin`: 14 bytes a Gaussian, in this machine's order: three
    /// 16-bit coordinates, four joints, four weights.
    ///
    /// # Errors
    /// When they are of another version of the main library.
    pub fn new(skeleton: &str, skin: &[u8]) -> Result<Self, FormatError> {
        let other = |found: &dyn std::fmt::Display| {
            FormatError::container(found, "the skeleton of an avatar of this version of Effigy")
        };
        let document: SkeletonDocument =
            serde_json::from_str(skeleton).map_err(|error| other(&error))?;
        let count = document.joints.len();
        let lengths = [
            document.parents.len(),
            document.rest.len(),
            document.canonical.len(),
        ];
        let is_tree = |(joint, parent): (usize, &Option<u8>)| match parent {
            None => joint == 0,
            Some(parent) => usize::from(*parent) < joint,
        };
        if lengths != [count; 3] || !document.parents.iter().enumerate().all(is_tree) {
            return Err(other(&format!("{count} joints that are no tree")));
        }
        let [min, max] = document.bounds;
        let mut body = Self {
            skeleton: Skeleton {
                name: document.joints,
                parent: document.parents,
                rest: document.rest,
                canonical: document.canonical,
            },
            bounds: Bounds { min, max },
            position: vec![],
            joint: vec![],
            joint_weight: vec![],
        };
        for point in skin.chunks_exact(size_of::<SkinnedPoint>()) {
            let point: SkinnedPoint = bytemuck::pod_read_unaligned(point);
            if point.joint.iter().any(|&joint| usize::from(joint) >= count) {
                return Err(other(&"a Gaussian on a joint that is not there"));
            }
            body.position.push(point.position);
            body.joint.push(point.joint);
            body.joint_weight.push(point.weight);
        }
        Ok(body)
    }

    /// How thick the avatar is; None: it has no body.
    pub fn girth(&self) -> Option<Girth> {
        Girth::of_skin(TrunkSkin {
            skeleton: &self.skeleton,
            bounds: self.bounds,
            position: &self.position,
            joint: &self.joint,
            joint_weight: &self.joint_weight,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn skeleton(parents: &str) -> String {
        format!(
            r#"{{"joints": ["a", "b"], "parents": {parents}, "rest": [[0, 0, 0], [0, 1, 0]],
            "canonical": [[0, 0, 0], [0, 0, 0]], "bounds": [[0, 0, 0], [1, 1, 1]]}}"#
        )
    }

    #[test]
    fn what_is_no_body_is_refused() {
        let tree = skeleton("[null, 0]");
        assert!(SkinnedBody::new(&tree, &[0; 28]).is_ok_and(|body| body.position.len() == 2));
        let joint = [0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 255, 0, 0, 0];
        assert!(SkinnedBody::new(&tree, &joint).is_err());
        for odd in ["[null, 1]", "[null, null]", "[null]", "[0, 0]"] {
            assert!(SkinnedBody::new(&skeleton(odd), &[]).is_err(), "{odd}");
        }
    }
}
