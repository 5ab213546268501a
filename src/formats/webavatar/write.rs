//! Writing of an avatar as `NAME.npz`.

use super::skeleton::{canonical, places};
use crate::{
    npz::NpzWriter,
    smpl_joints::{BODY, SMPL_X},
};
use effigy_core::{
    avatar::{Activation, Avatar, Matrix, NetworkLayer, ShCoefficients},
    io::file::FormatError,
};
use half::f16;

/// Numbers of an expression that the format has room for.
const EXPRESSION: usize = 10;
/// How far a joint of the canonical pose may be turned otherwise than in the format's, radians.
const CANONICAL_SLACK: f32 = 1e-3;

/// Something of an avatar that the format has no place for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LeftOut {
    /// Training poses, onto which poses are projected.
    PoseSpace,
    /// Who made it and on what terms.
    Credit,
}

/// The bytes of an avatar's `.npz`, and what is not in them. Positions are rounded to f16, by up to
/// half a millimetre.
///
/// # Errors
/// When the avatar is none that the format can hold: another skeleton or canonical pose than
/// SMPL-X's, other inputs, or hidden layers that are not leaky.
pub fn to_bytes(avatar: &Avatar) -> Result<(Vec<u8>, Vec<LeftOut>), FormatError> {
    avatar.check()?;
    let joints = SmplxJoints::new(avatar)?;
    check_networks(avatar)?;
    let bytes = write(avatar, &joints).map_err(|error| {
        FormatError::container(format!("an archive that can't be made: {error}"), "a zip")
    })?;
    let mut losses = Vec::new();
    if avatar.inputs.pose_space.is_some() || avatar.inputs.expression_space.is_some() {
        losses.push(LeftOut::PoseSpace);
    }
    if !avatar.credit.is_empty() {
        losses.push(LeftOut::Credit);
    }
    Ok((bytes, losses))
}

/// Where an avatar's joints are among SMPL-X's.
struct SmplxJoints {
    /// SMPL-X's joint of each of the avatar's.
    place: Vec<u8>,
    /// Of SMPL-X's joints, in the rest pose, metres.
    rest: Vec<[f16; 3]>,
}

impl SmplxJoints {
    fn new(avatar: &Avatar) -> Result<Self, FormatError> {
        let skeleton = &avatar.skeleton;
        let own = places(skeleton);
        let mut place = vec![None; skeleton.len()];
        for (joint, own) in own.iter().enumerate() {
            if let Some(own) = own {
                place[*own] = Some(joint as u8);
            }
        }
        let fault =
            |found: String, expected: &str| FormatError::metadata("joints", found, expected);
        let mut all = Vec::with_capacity(place.len());
        for (joint, place) in place.iter().enumerate() {
            let name = &skeleton.name[joint];
            let place =
                place.ok_or_else(|| fault(format!("`{name}`"), "joints of SMPL-X alone"))?;
            let parent = skeleton.parent[joint].map(|parent| &skeleton.name[usize::from(parent)]);
            let expected = SMPL_X[usize::from(place)]
                .parent
                .map(|parent| SMPL_X[usize::from(parent)].name);
            if parent.map(String::as_str) != expected {
                return Err(fault(format!("`{name}` under {parent:?}"), "SMPL-X's tree"));
            }
            let turn = skeleton.canonical[joint];
            let format = canonical(usize::from(place));
            if (0..3).any(|k| (turn[k] - format[k]).abs() > CANONICAL_SLACK) {
                let found = format!("`{name}` turned by {turn:?} in the canonical pose");
                return Err(fault(found, "hips turned outwards by 25° alone"));
            }
            all.push(place);
        }
        for (joint, own) in own.iter().enumerate().take(BODY) {
            if own.is_none() {
                let found = format!("no `{}`", SMPL_X[joint].name);
                return Err(fault(found, "SMPL-X's joints 0 to 21"));
            }
        }
        let mut rest: Vec<[f16; 3]> = Vec::with_capacity(SMPL_X.len());
        for (joint, own) in own.iter().enumerate() {
            // Joints that the avatar lacks move nothing: they are where their parents are.
            let parent = SMPL_X[joint].parent.map_or(0, usize::from);
            rest.push(match own {
                Some(own) => skeleton.rest[*own].map(f16::from_f32),
                None => rest[parent],
            });
        }
        Ok(Self { place: all, rest })
    }
}

fn check_networks(avatar: &Avatar) -> Result<(), FormatError> {
    let inputs = &avatar.inputs;
    let own = places(&avatar.skeleton);
    let expected: Vec<Option<usize>> = own[1..BODY].to_vec();
    let found: Vec<Option<usize>> = inputs.joint.iter().map(|&j| Some(usize::from(j))).collect();
    if found != expected || inputs.expression > EXPRESSION {
        return Err(FormatError::metadata(
            "inputs",
            format!(
                "{} joints, {} of an expression",
                found.len(),
                inputs.expression
            ),
            "SMPL-X's joints 1 to 21, in order, and at most 10",
        ));
    }
    let layers = &avatar.networks.layers;
    if layers.is_empty() || layers.len() > 1 && avatar.networks.activation == Activation::Relu {
        return Err(FormatError::metadata(
            "networks",
            format!("{} layers with ReLU", layers.len()),
            "networks with leaky ReLU",
        ));
    }
    Ok(())
}

fn write(avatar: &Avatar, joints: &SmplxJoints) -> Result<Vec<u8>, zip::result::ZipError> {
    let own = &avatar.gaussians;
    let (count, parts, nodes) = (own.len(), avatar.parts.len(), avatar.nodes.len());
    let basis = avatar.basis_len();
    let mut file = NpzWriter::new();
    let unit = ShCoefficients::CONSTANT;
    let position: Vec<f16> = (0..count)
        .flat_map(|gaussian| avatar.position(gaussian).to_array())
        .map(f16::from_f64)
        .collect();
    file.add("_xyz", &[count, 3], &position)?;
    file.add("_rotation", &[count, 4], own.rotation.as_flattened())?;
    file.add("_scaling", &[count, 3], own.log_scale.as_flattened())?;
    let code = |color: &f16| f16::from_f64((color.to_f64() - 0.5) / unit);
    let colors: Vec<f16> = own.color.as_flattened().iter().map(code).collect();
    file.add("_sh0", &[count, 1, 3], &colors)?;
    file.add("opacity", &[count], &own.opacity)?;
    let joint: Vec<u8> = own
        .joint
        .as_flattened()
        .iter()
        .map(|&joint| joints.place[usize::from(joint)])
        .collect();
    file.add("weights_idx", &[count, 4], &joint)?;
    file.add("weights_val", &[count, 4], own.joint_weight.as_flattened())?;
    file.add("t_joints", &[SMPL_X.len(), 3], joints.rest.as_flattened())?;
    file.add("num_xyz_ft_head", &[], &[avatar.parts.head as u32])?;
    for (at, layer) in layers(avatar).iter().enumerate() {
        let name = format!("layers.{}", 2 * at);
        let weight = by_neuron(&layer.weight.halves(), layer.output, parts, layer.input);
        let shape = [layer.output, parts, layer.input];
        file.add(&format!("{name}.weight"), &shape, &weight)?;
        let bias = by_neuron(&layer.bias, layer.output, parts, 1);
        file.add(&format!("{name}.bias"), &[layer.output, parts], &bias)?;
    }
    let part: Vec<u16> = (0..parts)
        .flat_map(|part| {
            let size = avatar.parts.start[part + 1] - avatar.parts.start[part];
            std::iter::repeat_n(part as u16, size as usize)
        })
        .collect();
    file.add("gs_feat_knn", &[count], &part)?;
    let rows = |matrix: &Matrix| matrix.halves().into_owned();
    let rotation = &avatar.rotation_rows;
    file.add("rot_idxs", &[rotation.gaussian.len()], &rotation.gaussian)?;
    let shape = [rotation.gaussian.len(), 4, basis];
    file.add("rotation_basis", &shape, &rows(&rotation.basis))?;
    let scale = &avatar.scale_rows;
    file.add("scale_idxs", &[scale.gaussian.len()], &scale.gaussian)?;
    let shape = [scale.gaussian.len(), 3, basis];
    file.add("scaling_basis", &shape, &rows(&scale.basis))?;
    let color = &avatar.color_rows;
    file.add("color_idxs", &[color.gaussian.len()], &color.gaussian)?;
    let codes: Vec<f16> = rows(&color.basis)
        .iter()
        .map(|number| f16::from_f64(number.to_f64() / unit))
        .collect();
    file.add("color_basis", &[color.gaussian.len(), 3, basis], &codes)?;
    file.add("ctrl_feat_knn", &[nodes], &avatar.nodes.part)?;
    file.add(
        "ctrl_pt_offsets",
        &[nodes, 3],
        avatar.nodes.offset.as_flattened(),
    )?;
    file.add(
        "ctrl_pt_basis",
        &[nodes, 3, basis],
        &rows(&avatar.nodes.basis),
    )?;
    file.add("gs_ctrl_knn", &[count, 3], own.node.as_flattened())?;
    let weights: Vec<f16> = (0..count)
        .flat_map(|gaussian| avatar.node_weights(gaussian))
        .map(f16::from_f64)
        .collect();
    file.add("gs_ctrl_knn_weights", &[count, 3], &weights)?;
    file.finish()
}

/// The layers with an input of 73 numbers, and features of their own for nodes, as the viewer
/// reads them.
fn layers(avatar: &Avatar) -> Vec<NetworkLayer> {
    let mut layers = avatar.networks.layers.clone();
    let parts = avatar.parts.len();
    if let Some(first) = layers.first_mut() {
        let width = first.input + EXPRESSION - avatar.inputs.expression;
        let mut padded = Vec::with_capacity(parts * first.output * width);
        for row in first.weight.halves().chunks_exact(first.input) {
            padded.extend(row);
            padded.resize(padded.len() + width - first.input, f16::ZERO);
        }
        first.weight = padded.into();
        first.input = width;
    }
    if avatar.node_feature_start() == 0
        && let Some(last) = layers.last_mut()
    {
        let twice = |numbers: &[f16], length: usize| {
            let part = |part: &[f16]| [part, part].concat();
            numbers
                .chunks_exact(length)
                .flat_map(part)
                .collect::<Vec<f16>>()
        };
        last.weight = twice(&last.weight.halves(), last.output * last.input).into();
        last.bias = twice(&last.bias, last.output);
        last.output *= 2;
    }
    layers
}

/// From shape G, out, in to out, G, in.
fn by_neuron(numbers: &[f16], output: usize, parts: usize, input: usize) -> Vec<f16> {
    let mut sorted = Vec::with_capacity(numbers.len());
    for neuron in 0..output {
        for part in 0..parts {
            sorted.extend(&numbers[(part * output + neuron) * input..][..input]);
        }
    }
    sorted
}
