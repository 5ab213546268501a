//! What an avatar holds, in numbers.

use super::{Spread, line, table, thousands};
use crate::avatar::file::TensorInfo;
use crate::avatar::{Activation, Avatar};
use serde::Serialize;
use std::fmt;

/// An avatar's counts, ranges and sizes. Lengths are metres.
#[derive(Serialize)]
pub struct Summary {
    kind: &'static str,
    name: String,
    credit: String,
    gaussians: usize,
    parts: usize,
    head_parts: usize,
    /// Gaussians in a part.
    part_size: Spread,
    nodes: usize,
    basis: usize,
    /// Nodes have features of their own.
    split_features: bool,
    activation: Activation,
    widths: Vec<usize>,
    rotation_rows: usize,
    scale_rows: usize,
    color_rows: usize,
    input_joints: Vec<String>,
    expression: usize,
    pose_components: Option<usize>,
    expression_components: Option<usize>,
    joints: Vec<Joint>,
    /// Along x, y, z.
    position: [Spread; 3],
    /// How finely positions are kept along x, y, z.
    position_step: [f64; 3],
    /// Standard deviations of the Gaussians along their axes.
    scale: Spread,
    /// 0 to 1.
    opacity: Spread,
    /// Red, green, blue.
    color: [Spread; 3],
    /// Highest degree of view-dependent colour; 0 where it has none.
    harmonics: usize,
    tensors: Vec<TensorInfo>,
    bytes: usize,
    /// Bytes of the file but for its header.
    stored: usize,
    /// Weights of networks in bytes.
    byte_networks: bool,
}

#[derive(Serialize)]
struct Joint {
    name: String,
    parent: Option<u8>,
}

impl Summary {
    /// `tensors`: of its file.
    pub fn new(avatar: &Avatar, tensors: Vec<TensorInfo>) -> Self {
        let (gaussians, skeleton, inputs, layers) = (&avatar.gaussians, &avatar.skeleton, &avatar.inputs, &avatar.networks.layers);
        let joint = |(name, parent): (&String, &Option<u8>)| Joint { name: name.clone(), parent: *parent };
        Self {
            kind: "avatar",
            name: avatar.name.clone(),
            credit: avatar.credit.clone(),
            gaussians: gaussians.len(),
            parts: avatar.parts.len(),
            head_parts: avatar.parts.head,
            part_size: Spread::of(avatar.parts.start.windows(2).map(|ends| f64::from(ends[1] - ends[0]))),
            nodes: avatar.nodes.len(),
            basis: avatar.basis_len(),
            split_features: avatar.node_feature_start() > 0,
            activation: avatar.networks.activation,
            widths: layers.iter().take(1).map(|layer| layer.input).chain(layers.iter().map(|layer| layer.output)).collect(),
            rotation_rows: avatar.rotation_rows.gaussian.len(),
            scale_rows: avatar.scale_rows.gaussian.len(),
            color_rows: avatar.color_rows.gaussian.len(),
            input_joints: inputs.joint.iter().map(|&j| skeleton.name[usize::from(j)].clone()).collect(),
            expression: inputs.expression,
            pose_components: inputs.pose_space.as_ref().map(|space| space.sigma.len()),
            expression_components: inputs.expression_space.as_ref().map(|space| space.sigma.len()),
            joints: skeleton.name.iter().zip(&skeleton.parent).map(joint).collect(),
            position: [0, 1, 2].map(|k| Spread::of((0..gaussians.len()).map(|i| avatar.position(i)[k]))),
            position_step: gaussians.bounds.step().to_array(),
            scale: Spread::of(gaussians.log_scale.as_flattened().iter().map(|s| s.to_f64().exp())),
            opacity: Spread::of(gaussians.opacity.iter().map(|&o| f64::from(o) / 255.0)),
            color: [0, 1, 2].map(|k| Spread::of(gaussians.color.iter().map(|c| c[k].to_f64()))),
            harmonics: avatar.harmonics.as_ref().map_or(0, |harmonics| harmonics.degree),
            bytes: tensors.iter().map(|tensor| tensor.bytes).sum(),
            stored: tensors.iter().map(|tensor| tensor.stored).sum(),
            byte_networks: avatar.networks.in_bytes(),
            tensors,
        }
    }

    fn networks(&self) -> String {
        if self.widths.is_empty() {
            return "none: nothing moves inside".into();
        }
        let widths: Vec<String> = self.widths.iter().map(usize::to_string).collect();
        let activation = match self.activation {
            Activation::Relu => "ReLU",
            Activation::LeakyRelu => "leaky ReLU",
        };
        let features = if self.split_features { "nodes have features of their own" } else { "nodes share the features" };
        let weights = if self.byte_networks { "bytes" } else { "f16" };
        format!("{}, {activation}, in {weights}; {} basis functions, {features}", widths.join(" → "), self.basis)
    }

    fn inputs(&self) -> String {
        if self.widths.is_empty() {
            return "none".into();
        }
        let space = |components: Option<usize>| components.map_or_else(|| "as it is".into(), |k| format!("{k} principal components"));
        let pose = format!("rotations of {} joints ({})", self.input_joints.len(), space(self.pose_components));
        match self.expression {
            0 => pose + ", no expression",
            n => format!("{pose}, {n} of expression ({})", space(self.expression_components)),
        }
    }

    fn part_sizes(&self) -> String {
        let Spread { min, median, max } = self.part_size;
        format!("{}, of {min} to {max} Gaussians (median {median}); {} see the expression", self.parts, self.head_parts)
    }
}

/// The chain of joints from `joint` to where the skeleton branches or ends, then those that go on from there, one deeper.
fn chains(joints: &[Joint], mut joint: usize, depth: usize) -> Vec<(usize, String)> {
    let children = |j: usize| (0..joints.len()).filter(move |&child| joints[child].parent.map(usize::from) == Some(j));
    let mut chain = joints[joint].name.clone();
    while let (Some(only), None) = (children(joint).next(), children(joint).nth(1)) {
        joint = only;
        chain += &format!(" {}", joints[joint].name);
    }
    let mut found = vec![(depth, chain)];
    children(joint).for_each(|child| found.extend(chains(joints, child, depth + 1)));
    found
}

impl fmt::Display for Summary {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        line(f, "avatar", &self.name)?;
        line(f, "credit", if self.credit.is_empty() { "not stated" } else { &self.credit })?;
        line(f, "Gaussians", thousands(self.gaussians))?;
        line(f, "parts", self.part_sizes())?;
        line(f, "nodes", thousands(self.nodes))?;
        line(f, "networks", self.networks())?;
        line(f, "inputs", self.inputs())?;
        let [rotation, scale, color] = [self.rotation_rows, self.scale_rows, self.color_rows].map(thousands);
        line(f, "kept rows", format_args!("rotation {rotation}, scale {scale}, colour {color}"))?;
        for (name, Spread { min, median, max }) in ["x", "y", "z"].iter().zip(&self.position) {
            line(f, name, format_args!("{min:.3} to {max:.3} m, median {median:.3}"))?;
        }
        let [x, y, z] = self.position_step.map(|step| 1e3 * step);
        line(f, "step", format_args!("{x:.4} × {y:.4} × {z:.4} mm between neighbouring positions"))?;
        let Spread { min, median, max } = &self.scale;
        line(f, "deviation", format_args!("{:.2} to {:.2} mm, median {:.2}", min * 1e3, max * 1e3, median * 1e3))?;
        for (name, Spread { min, median, max }) in
            ["opacity", "red", "green", "blue"].iter().zip([&self.opacity].into_iter().chain(&self.color))
        {
            line(f, name, format_args!("{min:.3} to {max:.3}, median {median:.3}"))?;
        }
        match self.harmonics {
            0 => line(f, "harmonics", "none: colours are the same from every side")?,
            degree => line(f, "harmonics", format_args!("degree {degree}"))?,
        }
        line(f, "skeleton", format_args!("{} joints", self.joints.len()))?;
        for (depth, chain) in chains(&self.joints, 0, 0) {
            writeln!(f, "{:12}{:indent$}{chain}", "", "", indent = 2 * depth)?;
        }
        table(f, &self.tensors)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_chain_ends_where_the_skeleton_branches() {
        let joint = |(name, parent): (&str, Option<u8>)| Joint { name: name.into(), parent };
        let tree = [
            ("root", None),
            ("hip", Some(0)),
            ("spine", Some(0)),
            ("knee", Some(1)),
            ("neck", Some(2)),
            ("jaw", Some(4)),
            ("eye", Some(4)),
        ];
        let chains = chains(&tree.map(joint), 0, 0);
        let expected = [(0, "root"), (1, "hip knee"), (1, "spine neck"), (2, "jaw"), (2, "eye")];
        assert_eq!(chains, expected.map(|(depth, text)| (depth, text.to_owned())));
    }
}
