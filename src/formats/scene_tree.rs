//! Nodes of a scene as joints: some are kept, the others become part of what is below them.

use crate::capture::{CaptureJoint, LocalPose};
use glam::{DQuat, DVec3, DVec4};

/// Something's place in the axes of what is above it. Scale is the same along each axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    pub translation: DVec3,
    pub rotation: DQuat,
    pub scale: f64,
}

impl Place {
    pub const IDENTITY: Self = Self {
        translation: DVec3::ZERO,
        rotation: DQuat::IDENTITY,
        scale: 1.0,
    };

    /// None: numbers that are not finite, or no rotation. `rotation`: x y z w, of any length.
    pub fn new(translation: DVec3, rotation: DVec4, scale: DVec3) -> Option<Self> {
        let rotation = DQuat::from_vec4(rotation.try_normalize()?);
        let scale = scale.element_product().abs().cbrt();
        (translation.is_finite() && scale.is_finite()).then_some(Self {
            translation,
            rotation,
            scale,
        })
    }

    /// The place of something in it, in the axes that it is in itself.
    pub fn then(&self, inner: &Self) -> Self {
        Self {
            translation: self.translation + self.rotation * (self.scale * inner.translation),
            rotation: self.rotation * inner.rotation,
            scale: self.scale * inner.scale,
        }
    }
}

/// A scene's nodes.
pub struct SceneTree {
    pub parent: Vec<Option<usize>>,
    /// Every node after its parent.
    pub order: Vec<usize>,
    /// As the nodes say.
    pub place: Vec<Place>,
}

/// A node that is kept.
pub struct Joint {
    pub node: usize,
    /// The joint above it.
    pub parent: Option<usize>,
    /// What is between them: nodes, and the scale of the world there.
    outer: Place,
}

impl Joint {
    /// What a capture has for a place in its parent node.
    pub fn pose(&self, own: &Place) -> LocalPose {
        let placed = self.outer.then(own);
        LocalPose::new(placed.rotation, placed.translation)
    }

    /// The joint of a capture. `rest`: in its parent node.
    pub fn at_rest(&self, name: String, rest: &Place) -> CaptureJoint {
        let pose = self.pose(rest);
        CaptureJoint {
            name,
            parent: self.parent,
            offset: pose.offset.as_dvec3(),
            rest: pose.rotation.as_dquat(),
        }
    }
}

impl SceneTree {
    /// Which nodes are `marked`, or above one that is.
    pub fn with_ancestors(&self, marked: &[bool]) -> Vec<bool> {
        let mut above = marked.to_vec();
        for &node in self.order.iter().rev() {
            if let Some(parent) = self.parent[node]
                && above[node]
            {
                above[parent] = true;
            }
        }
        above
    }

    /// The nodes that are kept, parents before their children.
    pub fn joints(&self, kept: &[bool]) -> Vec<Joint> {
        let mut inside = vec![Place::IDENTITY; kept.len()];
        let mut nearest = vec![None; kept.len()];
        let mut joints = vec![];
        for &node in &self.order {
            let above = self.parent[node];
            let outer = above.map_or(Place::IDENTITY, |above| inside[above]);
            let parent = above.and_then(|above| nearest[above]);
            inside[node] = outer.then(&self.place[node]);
            nearest[node] = parent;
            if kept[node] {
                nearest[node] = Some(joints.len());
                joints.push(Joint {
                    node,
                    parent,
                    outer,
                });
                // Offsets below it are in its own axes.
                inside[node] = Place {
                    scale: inside[node].scale,
                    ..Place::IDENTITY
                };
            }
        }
        joints
    }
}
