//! What training leaves as it is: where Gaussians and nodes are, what they follow, and how their
//! parts see a pose.

use effigy_core::avatar::{Activation, Avatar, FacingCode, Filter, facing};
use glam::DVec3;

/// A Gaussian's place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlacedGaussian {
    /// x₀, canonical pose, metres.
    pub position: DVec3,
    /// The three nodes that it follows.
    pub node: [u16; 3],
    /// Their weights, which sum to 1.
    pub node_weight: [f64; 3],
    /// Its part.
    pub part: u16,
    /// The four joints that move it.
    pub joint: [u8; 4],
    /// Their weights, which sum to 255.
    pub joint_weight: [u8; 4],
    /// From where it is drawn.
    pub facing: FacingCode,
}

/// A Gaussian that follows a node or a joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Follower {
    /// Its index.
    pub gaussian: u32,
    /// The node's or joint's weight.
    pub weight: f64,
}

/// Rows of basis functions: which Gaussians have correctives.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CorrectiveRows {
    /// The Gaussian of each row of rotation, scale and colour, strictly rising.
    pub gaussian: [Vec<u32>; 3],
}

impl CorrectiveRows {
    /// All of so many Gaussians, for every attribute: the first stage of the training.
    pub fn all(gaussians: usize) -> Self {
        let all: Vec<u32> = (0..gaussians as u32).collect();
        Self {
            gaussian: [all.clone(), all.clone(), all],
        }
    }

    /// Those that an avatar has.
    pub fn of(avatar: &Avatar) -> Self {
        Self {
            gaussian: [
                avatar.rotation_rows.gaussian.clone(),
                avatar.scale_rows.gaussian.clone(),
                avatar.color_rows.gaussian.clone(),
            ],
        }
    }

    /// The row of an attribute that a Gaussian has.
    pub fn row(&self, attribute: usize, gaussian: usize) -> Option<usize> {
        self.gaussian[attribute]
            .binary_search(&(gaussian as u32))
            .ok()
    }
}

/// What training leaves as it is.
#[derive(Clone, Debug)]
pub struct Topology {
    /// One a Gaussian, ordered by part.
    pub gaussians: Vec<PlacedGaussian>,
    /// Part i is Gaussians `part_start[i]..part_start[i + 1]`.
    pub part_start: Vec<u32>,
    /// Parts before this one see the expression.
    pub head_parts: usize,
    /// The part of each node.
    pub node_part: Vec<u16>,
    /// The Gaussians that follow each node.
    pub followers: Vec<Vec<Follower>>,
    /// The nodes of each part.
    pub part_nodes: Vec<Vec<u32>>,
    /// Numbers that enter the networks, then those that leave each layer.
    pub widths: Vec<usize>,
    /// Where θ_e begins in what enters.
    pub expression_start: usize,
    /// The nonlinearity of hidden layers.
    pub activation: Activation,
    /// Joints.
    pub joints: usize,
    /// The low-pass that the avatar is learned with.
    pub filter: Filter,
}

impl Topology {
    /// That of an avatar. Its networks give nodes features of their own.
    ///
    /// # Panics
    /// Where `Avatar::check` finds a fault.
    pub fn new(avatar: &Avatar) -> Self {
        let gaussians: Vec<PlacedGaussian> = (0..avatar.gaussians.len())
            .map(|k| PlacedGaussian {
                position: avatar.position(k),
                node: avatar.gaussians.node[k],
                node_weight: avatar.node_weights(k),
                part: avatar.parts.part_of(k) as u16,
                joint: avatar.gaussians.joint[k],
                joint_weight: avatar.gaussians.joint_weight[k],
                facing: avatar
                    .gaussians
                    .facing
                    .get(k)
                    .copied()
                    .unwrap_or(facing::EVERYWHERE),
            })
            .collect();
        let mut followers = vec![Vec::new(); avatar.nodes.len()];
        for (k, placed) in gaussians.iter().enumerate() {
            for (&node, &weight) in placed.node.iter().zip(&placed.node_weight) {
                followers[usize::from(node)].push(Follower {
                    gaussian: k as u32,
                    weight,
                });
            }
        }
        let mut part_nodes = vec![Vec::new(); avatar.parts.len()];
        for (node, &part) in avatar.nodes.part.iter().enumerate() {
            part_nodes[usize::from(part)].push(node as u32);
        }
        Self {
            gaussians,
            part_start: avatar.parts.start.clone(),
            head_parts: avatar.parts.head,
            node_part: avatar.nodes.part.clone(),
            followers,
            part_nodes,
            widths: avatar.networks.widths(),
            expression_start: 3 * avatar.inputs.joint.len(),
            activation: avatar.networks.activation,
            joints: avatar.skeleton.len(),
            filter: avatar.filter,
        }
    }

    /// The Gaussians that each joint moves.
    pub fn moved(&self) -> Vec<Vec<Follower>> {
        let mut all = vec![Vec::new(); self.joints];
        for (k, placed) in self.gaussians.iter().enumerate() {
            for (&joint, &weight) in placed.joint.iter().zip(&placed.joint_weight) {
                if weight > 0 {
                    all[usize::from(joint)].push(Follower {
                        gaussian: k as u32,
                        weight: f64::from(weight) / 255.0,
                    });
                }
            }
        }
        all
    }

    /// N_G.
    pub fn parts(&self) -> usize {
        self.part_start.len() - 1
    }

    /// N_s.
    pub fn nodes(&self) -> usize {
        self.node_part.len()
    }

    /// Layers of a network.
    pub fn layers(&self) -> usize {
        self.widths.len() - 1
    }
}
