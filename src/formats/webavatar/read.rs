//! Reading of `NAME.npz` into an avatar. Effigy's own arrays are ordered by part, so Gaussians are
//! renumbered.

use super::{
    Options,
    nodes::{self, Influence},
    skeleton,
};
use crate::{
    assumption::Assumption,
    fault::tensor,
    npz::{Array, Npz},
    smpl_joints::{BODY, SMPL_X},
};
use effigy_core::{
    avatar::{
        Activation, Avatar, Bounds, Filter, Gaussians, Inputs, Matrix, NetworkLayer, Networks,
        Nodes, Parts, Rows, limits,
    },
    io::file::FormatError,
};
use glam::DVec3;
use half::f16;

/// Numbers of an expression where the file has a padded input.
const EXPRESSION: usize = 10;
/// Numbers of a pose: the axis-angle rotations of joints 1 to 21.
const POSE: usize = 3 * (BODY - 1);
/// Width of a padded input: 63 numbers and one of padding, then 10 and six of padding.
const PADDED_INPUT: usize = 80;
/// Where the expression starts in a padded input.
const PADDED_EXPRESSION: usize = 64;

/// An avatar of another program, and what the file did not say.
#[derive(Clone, Debug)]
pub struct ForeignAvatar {
    /// The avatar.
    pub avatar: Avatar,
    /// What was assumed or derived.
    pub assumptions: Vec<Assumption>,
}

/// Reads a model. `name`: of the avatar.
///
/// # Errors
/// When an array is missing or has a wrong type, shape or number, or the archive is none.
pub fn from_bytes(
    bytes: &[u8],
    name: &str,
    options: &Options,
) -> Result<ForeignAvatar, FormatError> {
    let mut file = Npz::from_bytes(bytes)?;
    let positions = file.take("_xyz")?;
    let count = positions.dimension(0)?;
    if count == 0 || count > limits::GAUSSIANS {
        let expected = format!("1 to {} Gaussians", limits::GAUSSIANS);
        return Err(tensor("_xyz", count, expected));
    }
    positions.expect_shape(&[count, 3])?;
    let networks = read_networks(&mut file, options.activation)?;
    let order = Order::read(&mut file, count, networks.parts)?;
    let position = points(&order.pick::<3, _>(&positions.floats()?));
    let influence = read_influence(&mut file, &order)?;
    let moved = read_nodes(&mut file, &networks)?;
    check_nodes(&influence, moved.part.len())?;
    let fit = nodes::fit(&position, &influence, moved.part.len());
    let bounds = Bounds::around(position.iter().chain(&fit.position));
    let encode = |points: &[DVec3]| points.iter().map(|&p| bounds.encode(p)).collect();
    let basis = moved.basis_len;
    let unit = options.color.unit();
    let skin = read_skin(&mut file, &order)?;
    let avatar = Avatar {
        name: name.into(),
        credit: String::new(),
        filter: Filter::DEFAULT,
        gaussians: Gaussians {
            bounds,
            position: encode(&position),
            rotation: order.pick(&halves(&mut file, "_rotation", &[count, 4])?),
            log_scale: order.pick(&halves(&mut file, "_scaling", &[count, 3])?),
            color: read_colors(&mut file, &order, unit)?,
            opacity: read_opacity(&mut file, &order)?,
            joint: skin.joint,
            joint_weight: skin.weight,
            node: influence.iter().map(|near| near.node).collect(),
            facing: vec![],
        },
        skeleton: read_skeleton(&mut file)?,
        parts: Parts {
            start: order.starts.clone(),
            head: head_parts(&mut file, networks.parts)?,
        },
        rotation_rows: read_rows(&mut file, &order, "rot_idxs", "rotation_basis", basis, 1.0)?,
        scale_rows: read_rows(&mut file, &order, "scale_idxs", "scaling_basis", basis, 1.0)?,
        color_rows: read_rows(&mut file, &order, "color_idxs", "color_basis", basis, unit)?,
        nodes: Nodes {
            position: encode(&fit.position),
            part: moved.part,
            offset: moved.offset,
            basis: moved.basis,
        },
        inputs: Inputs {
            joint: (1..BODY as u8).collect(),
            expression: networks.expression,
            pose_space: None,
            expression_space: None,
        },
        networks: networks.networks,
        sh: None,
        levels: vec![],
    };
    avatar.check()?;
    let assumptions = assumptions(&avatar, options, networks.padded, fit.deviation);
    Ok(ForeignAvatar {
        avatar,
        assumptions,
    })
}

/// Everything that the file did not say.
fn assumptions(
    avatar: &Avatar,
    options: &Options,
    padded: bool,
    deviation: f64,
) -> Vec<Assumption> {
    let activation = match options.activation {
        Activation::LeakyRelu => "leaky ReLU, 0.01",
        Activation::Relu => "ReLU",
    };
    let unit = options.color.unit();
    let input = if padded {
        "63 of a pose, 1 of padding, 10 of an expression, 6 of padding".to_owned()
    } else {
        format!(
            "63 of a pose, {} of an expression",
            avatar.inputs.expression
        )
    };
    let features = if avatar.node_feature_start() > 0 {
        "their own half of the networks' output"
    } else {
        "those of the Gaussians"
    };
    vec![
        Assumption {
            what: "hidden layers",
            taken: activation.into(),
            because: "the file does not say; import --activation".into(),
        },
        Assumption {
            what: "colour",
            taken: format!("0.5 + {unit:.3} · _sh0"),
            because: "the file does not say; import --color-code".into(),
        },
        Assumption {
            what: "networks' input",
            taken: input,
            because: "from its width".into(),
        },
        Assumption {
            what: "features of nodes",
            taken: features.into(),
            because: "from the width of the output".into(),
        },
        Assumption {
            what: "node positions",
            taken: format!("fitted to the nodes' weights, which differ by {deviation:.4} rms"),
            because: "the file has none".into(),
        },
        Assumption {
            what: "tree of joints and canonical pose",
            taken: "SMPL-X's, hips turned outwards by 25°".into(),
            because: "the file has neither".into(),
        },
        Assumption {
            what: "training poses",
            taken: "unknown: poses are not projected onto them".into(),
            because: "the file has none; import --trained reads some".into(),
        },
    ]
}

/// Gaussians by part, in the file's order within a part.
struct Order {
    /// The file's index of each.
    old: Vec<u32>,
    /// The new index of each of the file's.
    new: Vec<u32>,
    /// Where each part starts, and where the last ends.
    starts: Vec<u32>,
}

impl Order {
    fn read(file: &mut Npz, count: usize, parts: usize) -> Result<Self, FormatError> {
        let array = file.take("gs_feat_knn")?;
        expect_column(&array, count)?;
        let part = array.integers(parts)?;
        let mut starts = vec![0u32; parts + 1];
        for &part in &part {
            starts[part as usize + 1] += 1;
        }
        for at in 0..parts {
            starts[at + 1] += starts[at];
        }
        let mut old: Vec<u32> = (0..count as u32).collect();
        old.sort_by_key(|&gaussian| part[gaussian as usize]);
        let mut new = vec![0; count];
        for (at, &gaussian) in old.iter().enumerate() {
            new[gaussian as usize] = at as u32;
        }
        Ok(Self { old, new, starts })
    }

    fn len(&self) -> usize {
        self.old.len()
    }

    /// Rows of C numbers in the new order.
    fn pick<const C: usize, T: Copy + Default>(&self, numbers: &[T]) -> Vec<[T; C]> {
        let row = |&gaussian: &u32| std::array::from_fn(|at| numbers[C * gaussian as usize + at]);
        self.old.iter().map(row).collect()
    }
}

/// Fails unless there are so many numbers, each in a row of its own or not.
fn expect_column(array: &Array, count: usize) -> Result<(), FormatError> {
    if array.shape() == [count, 1] {
        return Ok(());
    }
    array.expect_shape(&[count])
}

fn halves(file: &mut Npz, name: &str, shape: &[usize]) -> Result<Vec<f16>, FormatError> {
    let array = file.take(name)?;
    array.expect_shape(shape)?;
    array.halves()
}

fn points(rows: &[[f32; 3]]) -> Vec<DVec3> {
    rows.iter()
        .map(|row| DVec3::from(row.map(f64::from)))
        .collect()
}

/// The networks, and what their widths tell.
struct ReadNetworks {
    networks: Networks,
    parts: usize,
    expression: usize,
    padded: bool,
}

fn read_networks(file: &mut Npz, activation: Activation) -> Result<ReadNetworks, FormatError> {
    let number = |name: &str| {
        name.strip_prefix("layers.")?
            .strip_suffix(".weight")?
            .parse::<u32>()
            .ok()
    };
    let mut numbers: Vec<u32> = file.names().filter_map(number).collect();
    numbers.sort_unstable();
    if numbers.is_empty() || numbers.len() > limits::MLP_LAYERS {
        let expected = format!("1 to {} layers", limits::MLP_LAYERS);
        return Err(tensor("layers.0.weight", numbers.len(), expected));
    }
    let mut layers = Vec::new();
    let mut parts = None;
    for number in numbers {
        let weight = file.take(&format!("layers.{number}.weight"))?;
        let bias = file.take(&format!("layers.{number}.bias"))?;
        let [output, found, input] = [0, 1, 2].map(|at| weight.dimension(at));
        let (output, found, input) = (output?, found?, input?);
        let parts = *parts.get_or_insert(found);
        weight.expect_shape(&[output, parts, input])?;
        bias.expect_shape(&[output, parts])?;
        layers.push(NetworkLayer {
            input,
            output,
            weight: by_part(&weight.halves()?, output, parts, input).into(),
            bias: by_part(&bias.halves()?, output, parts, 1),
        });
    }
    let parts = parts.unwrap_or_default();
    let width = layers[0].input;
    let padded = width == PADDED_INPUT;
    let expression = if padded {
        EXPRESSION
    } else {
        width.checked_sub(POSE).ok_or_else(|| {
            let found = format!("{width} inputs");
            tensor("layers.0.weight", found, format!("at least {POSE}"))
        })?
    };
    if padded {
        let halves = layers[0].weight.halves().into_owned();
        layers[0].weight = halves
            .chunks_exact(width)
            .flat_map(|row| {
                let expression = &row[PADDED_EXPRESSION..][..EXPRESSION];
                row[..POSE].iter().chain(expression).copied()
            })
            .collect();
        layers[0].input = POSE + EXPRESSION;
    }
    Ok(ReadNetworks {
        networks: Networks { activation, layers },
        parts,
        expression,
        padded,
    })
}

/// From shape out, G, in to G, out, in.
fn by_part(numbers: &[f16], output: usize, parts: usize, input: usize) -> Vec<f16> {
    let mut sorted = Vec::with_capacity(numbers.len());
    for part in 0..parts {
        for neuron in 0..output {
            sorted.extend(&numbers[(neuron * parts + part) * input..][..input]);
        }
    }
    sorted
}

fn head_parts(file: &mut Npz, parts: usize) -> Result<usize, FormatError> {
    let array = file.take("num_xyz_ft_head")?;
    match array.integers(parts + 1)?[..] {
        [head] => Ok(head as usize),
        _ => Err(tensor(
            array.name(),
            format!("the shape {:?}", array.shape()),
            "one number",
        )),
    }
}

fn read_influence(file: &mut Npz, order: &Order) -> Result<Vec<Influence>, FormatError> {
    let node = file.take("gs_ctrl_knn")?;
    let weight = file.take("gs_ctrl_knn_weights")?;
    for array in [&node, &weight] {
        array.expect_shape(&[order.len(), 3])?;
    }
    let nodes = order.pick::<3, u32>(&node.integers(limits::NODES)?);
    let weights = order.pick::<3, f32>(&weight.floats()?);
    let mut all = Vec::with_capacity(nodes.len());
    for (at, (node, weight)) in nodes.iter().zip(&weights).enumerate() {
        let sum: f32 = weight.iter().sum();
        if weight.iter().any(|&w| w < 0.0) || !(0.5..2.0).contains(&sum) {
            let row = order.old[at];
            return Err(tensor(
                "gs_ctrl_knn_weights",
                format!("{weight:?} at row {row}"),
                "weights from 0 that sum to 1",
            ));
        }
        all.push(Influence {
            node: node.map(|node| node as u16),
            weight: weight.map(|w| f64::from(w / sum)),
        });
    }
    Ok(all)
}

fn check_nodes(influence: &[Influence], count: usize) -> Result<(), FormatError> {
    let largest = influence.iter().flat_map(|near| near.node).max();
    match largest.filter(|&node| usize::from(node) >= count) {
        Some(node) => Err(tensor(
            "gs_ctrl_knn",
            format!("node {node}"),
            format!("one of the {count} nodes of ctrl_feat_knn"),
        )),
        None => Ok(()),
    }
}

/// What the file says of nodes.
struct ReadNodes {
    part: Vec<u16>,
    offset: Vec<[f16; 3]>,
    basis: Matrix,
    basis_len: usize,
}

fn read_nodes(file: &mut Npz, networks: &ReadNetworks) -> Result<ReadNodes, FormatError> {
    let part = file.take("ctrl_feat_knn")?;
    let count = part.dimension(0)?;
    expect_column(&part, count)?;
    if count == 0 || count > limits::NODES {
        let expected = format!("1 to {} nodes", limits::NODES);
        return Err(tensor("ctrl_feat_knn", count, expected));
    }
    let basis = file.take("ctrl_pt_basis")?;
    let basis_len = basis.dimension(2)?;
    basis.expect_shape(&[count, 3, basis_len])?;
    let output = networks.networks.output();
    if output != basis_len && output != 2 * basis_len {
        return Err(tensor(
            "ctrl_pt_basis",
            format!("{basis_len} basis functions"),
            format!("the {output} outputs of the networks, or half of them"),
        ));
    }
    let offset = halves(file, "ctrl_pt_offsets", &[count, 3])?;
    Ok(ReadNodes {
        part: part
            .integers(networks.parts)?
            .iter()
            .map(|&part| part as u16)
            .collect(),
        offset: offset.chunks_exact(3).map(|o| [o[0], o[1], o[2]]).collect(),
        basis: basis.halves()?.into(),
        basis_len,
    })
}

fn read_colors(file: &mut Npz, order: &Order, unit: f64) -> Result<Vec<[f16; 3]>, FormatError> {
    let array = file.take("_sh0")?;
    if array.shape() != [order.len(), 3] {
        array.expect_shape(&[order.len(), 1, 3])?;
    }
    let rgb = |code: f32| f16::from_f64(0.5 + unit * f64::from(code));
    let rows = order.pick::<3, f32>(&array.floats()?);
    Ok(rows.iter().map(|row| row.map(rgb)).collect())
}

fn read_opacity(file: &mut Npz, order: &Order) -> Result<Vec<u8>, FormatError> {
    let array = file.take("opacity")?;
    expect_column(&array, order.len())?;
    let opacity = array.integers(256)?;
    Ok(order
        .old
        .iter()
        .map(|&gaussian| opacity[gaussian as usize] as u8)
        .collect())
}

/// Four joints a Gaussian, and their weights.
struct WeighedJoints {
    joint: Vec<[u8; 4]>,
    weight: Vec<[u8; 4]>,
}

fn read_skin(file: &mut Npz, order: &Order) -> Result<WeighedJoints, FormatError> {
    let joint = file.take("weights_idx")?;
    let weight = file.take("weights_val")?;
    for array in [&joint, &weight] {
        array.expect_shape(&[order.len(), 4])?;
    }
    let joints = order.pick::<4, u32>(&joint.integers(SMPL_X.len())?);
    let weights = order.pick::<4, u32>(&weight.integers(256)?);
    let mut rounded = Vec::with_capacity(weights.len());
    for (at, weights) in weights.iter().enumerate() {
        let found = || format!("{weights:?} at row {}", order.old[at]);
        let whole =
            with_sum(*weights).ok_or_else(|| tensor("weights_val", found(), "a weight above 0"))?;
        rounded.push(whole);
    }
    Ok(WeighedJoints {
        joint: joints.iter().map(|row| row.map(|j| j as u8)).collect(),
        weight: rounded,
    })
}

/// Weights scaled to a sum of 255: each was rounded by itself. None: all are 0.
fn with_sum(weights: [u32; 4]) -> Option<[u8; 4]> {
    let sum: u32 = weights.iter().sum();
    if sum == 0 {
        return None;
    }
    let mut scaled = weights.map(|w| (255 * w + sum / 2) / sum);
    let largest = (0..4).max_by_key(|&at| scaled[at])?;
    let others: u32 = (0..4)
        .filter(|&at| at != largest)
        .map(|at| scaled[at])
        .sum();
    scaled[largest] = 255u32.checked_sub(others)?;
    Some(scaled.map(|w| w as u8))
}

fn read_skeleton(file: &mut Npz) -> Result<effigy_core::avatar::Skeleton, FormatError> {
    let array = file.take("t_joints")?;
    array.expect_shape(&[SMPL_X.len(), 3])?;
    let numbers = array.floats()?;
    let rest = numbers.chunks_exact(3).map(|j| [j[0], j[1], j[2]]);
    Ok(skeleton::smpl_x(rest.collect()))
}

/// Reads the rows of one attribute. `unit`: what the avatar's numbers are a unit of the file's.
fn read_rows<const C: usize>(
    file: &mut Npz,
    order: &Order,
    index: &str,
    basis: &str,
    basis_len: usize,
    unit: f64,
) -> Result<Rows<C>, FormatError> {
    let index = file.take(index)?;
    let rows = index.dimension(0)?;
    index.expect_shape(&[rows])?;
    let array: Array = file.take(basis)?;
    array.expect_shape(&[rows, C, basis_len])?;
    let mut places: Vec<RowTarget> = index
        .integers(order.len())?
        .iter()
        .enumerate()
        .map(|(row, &gaussian)| RowTarget {
            gaussian: order.new[gaussian as usize],
            row,
        })
        .collect();
    places.sort_by_key(|place| place.gaussian);
    if let Some(twice) = places
        .windows(2)
        .find(|pair| pair[0].gaussian == pair[1].gaussian)
    {
        let gaussian = order.old[twice[0].gaussian as usize];
        return Err(tensor(
            index.name(),
            format!("Gaussian {gaussian} twice"),
            "each Gaussian once at most",
        ));
    }
    let length = C * basis_len;
    let numbers = array.halves()?;
    let scaled = |number: f16| {
        if unit == 1.0 {
            number
        } else {
            f16::from_f64(unit * number.to_f64())
        }
    };
    let halves = places
        .iter()
        .flat_map(|place| &numbers[place.row * length..][..length])
        .map(|&number| scaled(number))
        .collect();
    Ok(Rows {
        gaussian: places.iter().map(|place| place.gaussian).collect(),
        basis: halves,
    })
}

/// Where a row of the file goes.
struct RowTarget {
    /// The new index of its Gaussian.
    gaussian: u32,
    /// Its index in the file.
    row: usize,
}
