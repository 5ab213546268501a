//! Reading of a checkpoint.

use super::{Options, blend::Blend, fields::CheckpointFields, networks::NetworkSource};
use crate::{
    assumption::Assumption,
    fault::tensor,
    pickle::{Pickle, Value},
    smpl_joints::SMPL_X,
    webavatar::nodes::{self, Influence},
};
use effigy_core::{
    avatar::{Activation, Pose, Skeleton, limits},
    io::file::FormatError,
};
use glam::DVec3;

/// Nodes that each Gaussian interpolates; an avatar has as many.
const NODES_OF_GAUSSIAN: usize = 3;
/// Basis functions that an attribute may have.
const MAX_BASIS: usize = 256;
/// Joints that the canonical pose turns: both hips.
const HIPS: [usize; 2] = [1, 2];

/// A checkpoint. Gaussians and nodes are in the file's order; lengths are metres.
pub struct Checkpoint<'p> {
    /// Steps of training, where the file says.
    pub iteration: Option<f64>,
    /// The joints, in the rest pose and in the canonical one.
    pub skeleton: Skeleton,
    /// The neutral Gaussians.
    pub gaussians: CheckpointGaussians,
    /// Weights of the joints, shape N, J; of each Gaussian they sum to 1.
    pub skin: Vec<f32>,
    /// The nodes.
    pub nodes: CheckpointNodes,
    /// The anchors of each Gaussian.
    pub gaussian_anchors: Blend,
    /// The nodes of each Gaussian, three.
    pub gaussian_nodes: Blend,
    /// What the pose adds to the Gaussians; None where the checkpoint is from before that.
    pub bases: Option<AttributeBases>,
    /// The anchors' networks. Features of Gaussians come first, then those of nodes.
    pub networks: NetworkSource<'p>,
    /// Features of a Gaussian, B.
    pub basis: usize,
    /// Features of a node, C.
    pub node_basis: usize,
    /// The training poses, in the order of their frames' numbers.
    pub poses: Vec<Pose>,
    /// RGB a unit of the harmonics' coefficients of degree 0.
    pub color_unit: f64,
    /// What the file did not say.
    pub assumptions: Vec<Assumption>,
}

/// The neutral attributes of a checkpoint.
pub struct CheckpointGaussians {
    /// In the canonical pose, without the nodes' displacements.
    pub position: Vec<DVec3>,
    /// Quaternion w x y z, of any length.
    pub rotation: Vec<[f32; 4]>,
    /// Natural logarithm of the standard deviations, metres.
    pub log_scale: Vec<[f32; 3]>,
    /// Before the sigmoid.
    pub opacity: Vec<f32>,
    /// Coefficients of the harmonic of degree 0, RGB.
    pub color: Vec<[f32; 3]>,
    /// Coefficients of the three harmonics of degree 1, each RGB; empty where they don't count.
    pub harmonics: Vec<[f32; 9]>,
}

/// The bases of a checkpoint's attributes: what a unit of each feature adds.
pub struct AttributeBases {
    /// Shape N, B, 4.
    pub rotation: Vec<f32>,
    /// Shape N, B, 3.
    pub log_scale: Vec<f32>,
    /// Shape N, B, 3.
    pub color: Vec<f32>,
    /// Shape N, B, 9; empty where harmonics of degree 1 don't count.
    pub harmonics: Vec<f32>,
    /// Shape N, B.
    pub opacity: Vec<f32>,
}

/// The nodes of a checkpoint.
pub struct CheckpointNodes {
    /// In the canonical pose.
    pub position: Vec<DVec3>,
    /// Displacement that no pose changes.
    pub offset: Vec<[f32; 3]>,
    /// Shape S, C, 3; None where the pose does not move nodes yet.
    pub basis: Option<Vec<f32>>,
    /// The anchors of each node.
    pub anchors: Blend,
}

impl<'p> Checkpoint<'p> {
    /// Reads a checkpoint. The networks stay in the file.
    ///
    /// # Errors
    /// When an entry is missing or has a wrong type, shape or number, or entries show more numbers
    /// than the file has.
    pub fn new(pickle: &'p Pickle, options: &Options) -> Result<Self, FormatError> {
        let fields = CheckpointFields {
            root: pickle.root(),
        };
        let count = fields.shape("_xyz", &[None, Some(3)])?[0];
        if count == 0 || count > limits::GAUSSIANS {
            let expected = format!("1 to {} Gaussians", limits::GAUSSIANS);
            return Err(tensor("_xyz", count, expected));
        }
        let node_count = fields.shape("dxyz_vt", &[None, Some(3)])?[0];
        if node_count == 0 || node_count > limits::NODES {
            let expected = format!("1 to {} nodes", limits::NODES);
            return Err(tensor("dxyz_vt", node_count, expected));
        }
        let networks = NetworkSource::read(fields, options.activation)?;
        if networks.count > limits::PARTS {
            let expected = format!("1 to {} networks", limits::PARTS);
            return Err(tensor("layers.0.weight", networks.count, expected));
        }
        check_memory(fields, &networks)?;
        let BasisLengths { basis, node_basis } =
            basis_lengths(fields, &networks, count, node_count)?;
        let degree = fields.get("sh_degree")?.number().unwrap_or_default();
        let harmonic = degree >= 1.0;
        let tree = read_skeleton(fields, options)?;
        let mut assumptions = assumptions(&networks, options, basis, node_basis);
        assumptions.extend(tree.assumption);
        let skeleton = tree.skeleton;
        let gaussian_nodes = Blend::read(fields, "nbr_gs", "nbr_gs_invdist", count, node_count)?;
        if gaussian_nodes.width != NODES_OF_GAUSSIAN {
            let found = format!("{} nodes a Gaussian", gaussian_nodes.width);
            return Err(tensor("nbr_gs", found, NODES_OF_GAUSSIAN));
        }
        let placed: Vec<[f32; 3]> = fields.rows("_xyz", &[count, 3])?;
        let node_position = if fields.has("xyz_vt") {
            let rows: Vec<[f32; 3]> = fields.rows("xyz_vt", &[node_count, 3])?;
            rows.iter().map(|&row| point(row)).collect()
        } else {
            let fit = fitted_nodes(&placed, &gaussian_nodes, node_count);
            assumptions.push(fitted_position(&fit));
            fit.position
        };
        let anchors = networks.count;
        let gaussians_of = |index, weight| Blend::read(fields, index, weight, count, anchors);
        let node_anchors = Blend::read(fields, "nbr_vtft", "nbr_vtft_wght", node_count, anchors)?;
        Ok(Self {
            iteration: fields.root.get("iteration").and_then(Value::number),
            skin: read_skin(fields, count, skeleton.len())?,
            gaussians: read_gaussians(fields, &placed, options, harmonic)?,
            nodes: CheckpointNodes {
                position: node_position,
                offset: fields.rows("dxyz_vt", &[node_count, 3])?,
                basis: if fields.flag("is_dxyz_bs")? {
                    Some(fields.numbers("dxyz_bs", &[node_count, node_basis, 3])?)
                } else {
                    None
                },
                anchors: node_anchors,
            },
            gaussian_anchors: gaussians_of("nbr_gsft", "nbr_gsft_wght")?,
            gaussian_nodes,
            bases: if fields.flag("is_gsparam_bs")? {
                Some(read_bases(fields, count, basis, harmonic)?)
            } else {
                None
            },
            poses: read_poses(fields, skeleton.len())?,
            skeleton,
            networks,
            basis,
            node_basis,
            color_unit: options.color.unit(),
            assumptions,
        })
    }

    /// Number of Gaussians, N.
    pub fn len(&self) -> usize {
        self.gaussians.position.len()
    }

    /// Whether there are none; never so for a checkpoint that was read.
    pub fn is_empty(&self) -> bool {
        self.gaussians.position.is_empty()
    }

    /// The joints whose rotations enter the networks: from 1 on, as many as the input is wide.
    pub fn input_joints(&self) -> std::ops::RangeInclusive<usize> {
        1..=self.networks.widths[0] / 3
    }
}

fn point(row: [f32; 3]) -> DVec3 {
    DVec3::from(row.map(f64::from))
}

/// Fails where entries show more memory than the file has: tensors may share it, or repeat it.
fn check_memory(fields: CheckpointFields, networks: &NetworkSource) -> Result<(), FormatError> {
    let entries = fields.root.values().into_iter().flatten();
    let poses = fields.root.get("all_poses").and_then(Value::values);
    let tensors = entries.chain(poses.into_iter().flatten());
    let shown = tensors.filter_map(Value::float_bytes);
    let all = shown.fold(networks.bytes().unwrap_or(u64::MAX), u64::saturating_add);
    let held = fields.root.file_bytes();
    if all > held {
        return Err(FormatError::container(
            format!("tensors of {all} bytes in a file of {held}"),
            "memory that each tensor has to itself",
        ));
    }
    Ok(())
}

/// Basis functions of Gaussians and of nodes.
struct BasisLengths {
    basis: usize,
    node_basis: usize,
}

/// B and C: from the shapes of the bases, which must be the networks' outputs together.
fn basis_lengths(
    fields: CheckpointFields,
    networks: &NetworkSource,
    count: usize,
    nodes: usize,
) -> Result<BasisLengths, FormatError> {
    let basis = fields.shape("rotation_bs", &[Some(count), None, Some(4)])?[1];
    let node_basis = fields.shape("dxyz_bs", &[Some(nodes), None, Some(3)])?[1];
    let output = networks.widths.last().copied().unwrap_or_default();
    if basis == 0 || basis > MAX_BASIS || basis + node_basis != output {
        let found = format!("{basis} functions, {node_basis} of dxyz_bs");
        let expected = format!("as many together as the networks' {output} outputs");
        return Err(tensor("rotation_bs", found, expected));
    }
    let said = fields.root.get("num_basis").and_then(Value::number);
    if said.is_some_and(|said| said != basis as f64) {
        let found = said.unwrap_or_default();
        return Err(tensor(
            "num_basis",
            found,
            format!("{basis}, as rotation_bs has"),
        ));
    }
    Ok(BasisLengths { basis, node_basis })
}

fn read_gaussians(
    fields: CheckpointFields,
    placed: &[[f32; 3]],
    options: &Options,
    harmonic: bool,
) -> Result<CheckpointGaussians, FormatError> {
    let count = placed.len();
    let offset: Vec<[f32; 3]> = fields.rows("xyz_offset", &[count, 3])?;
    let moved = placed.iter().zip(&offset).map(|(&placed, &offset)| {
        let offset = point(offset).to_array().map(f64::tanh);
        point(placed) + options.reach * DVec3::from(offset)
    });
    let position: Vec<DVec3> = moved.collect();
    let far = |p: &DVec3| p.abs().max_element() > limits::LENGTH;
    if let Some(at) = position.iter().position(far) {
        let expected = format!("metres, within ±{}", limits::LENGTH);
        return Err(tensor(
            "_xyz",
            format!("{} at row {at}", position[at]),
            expected,
        ));
    }
    let rotation: Vec<[f32; 4]> = fields.rows("_rotation", &[count, 4])?;
    let short = |q: &[f32; 4]| q.iter().all(|part| part.abs() < 1e-12);
    if let Some(at) = rotation.iter().position(short) {
        return Err(tensor(
            "_rotation",
            format!("{:?} at row {at}", rotation[at]),
            "a quaternion",
        ));
    }
    Ok(CheckpointGaussians {
        position,
        rotation,
        log_scale: fields.rows("_scaling", &[count, 3])?,
        opacity: column(fields, "_opacity", &[count])?,
        color: fields.rows("_sh0", &[count, 1, 3])?,
        harmonics: if harmonic {
            fields.rows("_shN", &[count, 3, 3])?
        } else {
            vec![]
        },
    })
}

/// Floats of this shape, or of this shape with a last dimension of 1.
fn column(fields: CheckpointFields, name: &str, shape: &[usize]) -> Result<Vec<f32>, FormatError> {
    let columns = [shape, &[1]].concat();
    let found = fields.get(name)?.shape();
    let shape = if found == Some(&columns[..]) {
        &columns
    } else {
        shape
    };
    fields.numbers(name, shape)
}

fn read_bases(
    fields: CheckpointFields,
    count: usize,
    basis: usize,
    harmonic: bool,
) -> Result<AttributeBases, FormatError> {
    Ok(AttributeBases {
        rotation: fields.numbers("rotation_bs", &[count, basis, 4])?,
        log_scale: fields.numbers("scaling_bs", &[count, basis, 3])?,
        color: fields.numbers("sh0_bs", &[count, basis, 1, 3])?,
        harmonics: if harmonic {
            fields.numbers("shN_bs", &[count, basis, 3, 3])?
        } else {
            vec![]
        },
        opacity: column(fields, "opacity_bs", &[count, basis])?,
    })
}

fn read_skin(
    fields: CheckpointFields,
    count: usize,
    joints: usize,
) -> Result<Vec<f32>, FormatError> {
    let mut skin = fields.numbers("_weights", &[count, joints])?;
    for (row, weights) in skin.chunks_exact_mut(joints).enumerate() {
        // Interpolation rounds: a weight may be slightly below 0.
        let sum: f32 = weights.iter().sum();
        if !(0.5..2.0).contains(&sum) || weights.iter().any(|&w| w < -0.01) {
            let found = format!("weights that sum to {sum} at row {row}");
            return Err(tensor("_weights", found, "weights from 0 that sum to 1"));
        }
    }
    skin.shrink_to_fit();
    Ok(skin)
}

/// A skeleton, and what was assumed of it.
struct FoundTree {
    skeleton: Skeleton,
    assumption: Option<Assumption>,
}

fn read_skeleton(fields: CheckpointFields, options: &Options) -> Result<FoundTree, FormatError> {
    let joints = fields.shape("t_joints", &[None, Some(3)])?[0];
    if joints == 0 || joints > limits::JOINTS {
        let expected = format!("1 to {} joints", limits::JOINTS);
        return Err(tensor("t_joints", joints, expected));
    }
    let own = SMPL_X.iter().map(|joint| joint.parent);
    let (parent, assumption) = if fields.has("joint_parents") {
        (read_parents(fields, joints)?, None)
    } else if joints <= SMPL_X.len() {
        let assumption = Assumption {
            what: "tree of joints",
            taken: "SMPL-X's".into(),
            because: "the file has no joint_parents".into(),
        };
        (own.clone().take(joints).collect(), Some(assumption))
    } else {
        return Err(tensor(
            "joint_parents",
            "nothing",
            format!("{joints} parents"),
        ));
    };
    // Names of SMPL-X's joints as far as the tree is its own.
    let same = parent
        .iter()
        .zip(own)
        .take_while(|(a, b)| **a == *b)
        .count();
    let name = |joint: usize| match SMPL_X.get(joint).filter(|_| joint < same) {
        Some(joint) => joint.name.to_owned(),
        None => format!("joint {joint}"),
    };
    let hips = options.hips.to_radians() as f32;
    let canonical = |joint: usize| match joint {
        joint if joint == HIPS[0] => [0.0, 0.0, hips],
        joint if joint == HIPS[1] => [0.0, 0.0, -hips],
        _ => [0.0; 3],
    };
    let inputs = fields_input_joints(fields)?;
    if inputs >= joints {
        let found = format!("{joints} joints");
        return Err(tensor(
            "t_joints",
            found,
            format!("more than the {inputs} of the networks"),
        ));
    }
    Ok(FoundTree {
        skeleton: Skeleton {
            name: (0..joints).map(name).collect(),
            parent,
            rest: fields.rows("t_joints", &[joints, 3])?,
            canonical: (0..joints).map(canonical).collect(),
        },
        assumption,
    })
}

/// Joints whose rotations enter the networks.
fn fields_input_joints(fields: CheckpointFields) -> Result<usize, FormatError> {
    let params = CheckpointFields {
        root: fields.get("encoder_feat_params")?,
    };
    let name = "layers.0.weight";
    let width = params.shape(name, &[None, None, None])?[2];
    if width == 0 || !width.is_multiple_of(3) || width > limits::MLP_INPUT {
        let expected = format!("three for each joint, at most {}", limits::MLP_INPUT);
        return Err(tensor(name, format!("{width} inputs"), expected));
    }
    Ok(width / 3)
}

fn read_parents(fields: CheckpointFields, joints: usize) -> Result<Vec<Option<u8>>, FormatError> {
    fields.shape("joint_parents", &[Some(joints)])?;
    let numbers = fields
        .get("joint_parents")?
        .numbers("joint_parents")?
        .numbers;
    let parent = |(joint, &parent): (usize, &f32)| {
        let is_before = parent >= 0.0 && parent.fract() == 0.0 && (parent as usize) < joint;
        match joint {
            // SMPL-X's file has -1 there, or the largest 32-bit integer.
            0 => Ok(None),
            _ if is_before => Ok(Some(parent as u8)),
            _ => {
                let found = format!("{parent} of joint {joint}");
                Err(tensor("joint_parents", found, "a joint before it"))
            }
        }
    };
    numbers.iter().enumerate().map(parent).collect()
}

/// A pose with the number of its frame.
struct NumberedPose {
    frame: i64,
    pose: Pose,
}

fn read_poses(fields: CheckpointFields, joints: usize) -> Result<Vec<Pose>, FormatError> {
    let Some(all) = fields.root.get("all_poses") else {
        return Ok(vec![]);
    };
    let (Some(keys), Some(values)) = (all.keys(), all.values()) else {
        return Err(tensor("all_poses", all.describe(), "a dictionary of poses"));
    };
    let mut poses = Vec::new();
    for (key, value) in keys.zip(values) {
        let frame = match key.text() {
            Some(text) => text.parse().ok(),
            None => key.number().map(|number| number as i64),
        };
        let fault = || tensor("all_poses", key.describe(), "the number of a frame");
        let frame = frame.ok_or_else(fault)?;
        let numbers = value.numbers("all_poses")?.numbers;
        if numbers.len() != 3 * joints {
            let found = format!("{} numbers in frame {frame}", numbers.len());
            return Err(tensor(
                "all_poses",
                found,
                format!("{}, three a joint", 3 * joints),
            ));
        }
        let rotation = numbers.as_chunks::<3>().0.iter().map(|&axis| point(axis));
        poses.push(NumberedPose {
            frame,
            pose: Pose {
                rotation: rotation.collect(),
                ..Pose::rest(0, 0)
            },
        });
    }
    poses.sort_by_key(|pose| pose.frame);
    Ok(poses.into_iter().map(|numbered| numbered.pose).collect())
}

fn fitted_position(fit: &nodes::NodeFit) -> Assumption {
    Assumption {
        what: "node positions",
        taken: format!(
            "fitted to the nodes' weights, which differ by {:.4} rms",
            fit.deviation
        ),
        because: "the file has no xyz_vt".into(),
    }
}

fn fitted_nodes(placed: &[[f32; 3]], near: &Blend, count: usize) -> nodes::NodeFit {
    let position: Vec<DVec3> = placed.iter().map(|&row| point(row)).collect();
    let influence = |row: usize| {
        let own = row * NODES_OF_GAUSSIAN;
        Influence {
            node: std::array::from_fn(|k| near.index[own + k] as u16),
            weight: std::array::from_fn(|k| f64::from(near.weight[own + k])),
        }
    };
    let influence: Vec<Influence> = (0..placed.len()).map(influence).collect();
    nodes::fit(&position, &influence, count)
}

/// What the training code says and the file does not.
fn assumptions(
    networks: &NetworkSource,
    options: &Options,
    basis: usize,
    node_basis: usize,
) -> Vec<Assumption> {
    let code = |option: &str| format!("a constant of the training code; import {option}");
    let activation = match options.activation {
        Activation::LeakyRelu => "leaky ReLU, 0.01",
        Activation::Relu => "ReLU",
    };
    vec![
        Assumption {
            what: "hidden layers",
            taken: activation.into(),
            because: code("--activation"),
        },
        Assumption {
            what: "colour",
            taken: format!("0.5 + {:.3} · _sh0", options.color.unit()),
            because: code("--color-code"),
        },
        Assumption {
            what: "free offset",
            taken: format!("{} m · tanh(xyz_offset)", options.reach),
            because: code("--reach"),
        },
        Assumption {
            what: "canonical pose",
            taken: format!("hips turned outwards by {}°", options.hips),
            because: code("--hips"),
        },
        Assumption {
            what: "networks' input",
            taken: format!("rotations of joints 1 to {}", networks.widths[0] / 3),
            because: "from its width".into(),
        },
        Assumption {
            what: "networks' output",
            taken: format!("{basis} features of Gaussians, then {node_basis} of nodes"),
            because: "from the bases' shapes".into(),
        },
    ]
}
