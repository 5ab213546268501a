//! The contents of an avatar, in numbers.

use super::levels::LevelSummary;
use super::text::{Distribution, line, stated, table, thousands};
use effigy_core::avatar::{Activation, Avatar, Facing, FacingCode, Filter};
use effigy_core::io::file::TensorInfo;
use serde::Serialize;
use std::fmt;

/// An avatar's counts, ranges and sizes. Lengths are metres.
#[derive(Serialize)]
pub struct AvatarSummary {
    kind: &'static str,
    name: String,
    credit: String,
    gaussians: usize,
    parts: usize,
    head_parts: usize,
    /// Gaussians in a part.
    part_size: Distribution,
    nodes: usize,
    basis: usize,
    /// Whether nodes have features of their own.
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
    joints: Vec<NamedJoint>,
    /// Along x, y, z.
    position: [Distribution; 3],
    /// Distance between neighbouring stored positions along x, y, z.
    position_step: [f64; 3],
    /// Standard deviations of the Gaussians along their axes.
    scale: Distribution,
    /// 0 to 1.
    opacity: Distribution,
    /// Red, green, blue.
    color: [Distribution; 3],
    /// Highest degree of view-dependent colour; 0 where it has none.
    harmonics: usize,
    /// The low-pass that it was learned with.
    filter: Filter,
    /// Share of all directions from which a Gaussian is not drawn, in the mean; 0 without cones.
    facing: f64,
    levels: Vec<LevelSummary>,
    tensors: Vec<TensorInfo>,
    bytes: usize,
    /// Bytes of the file without its header.
    stored: usize,
    /// Whether the networks' weights are bytes, not f16.
    byte_networks: bool,
}

#[derive(Serialize)]
struct NamedJoint {
    name: String,
    parent: Option<u8>,
}

impl AvatarSummary {
    /// `tensors`: those of the avatar's file.
    pub fn new(avatar: &Avatar, tensors: Vec<TensorInfo>) -> Self {
        let gaussians = &avatar.gaussians;
        let skeleton = &avatar.skeleton;
        let inputs = &avatar.inputs;
        let joint = |joint: usize| NamedJoint {
            name: skeleton.name[joint].clone(),
            parent: skeleton.parent[joint],
        };
        Self {
            kind: "avatar",
            name: avatar.name.clone(),
            credit: avatar.credit.clone(),
            gaussians: gaussians.len(),
            parts: avatar.parts.len(),
            head_parts: avatar.parts.head,
            part_size: Distribution::new(
                avatar
                    .parts
                    .start
                    .windows(2)
                    .map(|ends| f64::from(ends[1] - ends[0])),
            ),
            nodes: avatar.nodes.len(),
            basis: avatar.basis_len(),
            split_features: avatar.node_feature_start() > 0,
            activation: avatar.networks.activation,
            widths: avatar.networks.widths(),
            rotation_rows: avatar.rotation_rows.gaussian.len(),
            scale_rows: avatar.scale_rows.gaussian.len(),
            color_rows: avatar.color_rows.gaussian.len(),
            input_joints: inputs
                .joint
                .iter()
                .map(|&j| skeleton.name[usize::from(j)].clone())
                .collect(),
            expression: inputs.expression,
            pose_components: inputs.pose_space.as_ref().map(|space| space.sigma.len()),
            expression_components: inputs
                .expression_space
                .as_ref()
                .map(|space| space.sigma.len()),
            joints: (0..skeleton.len()).map(joint).collect(),
            position: [0, 1, 2]
                .map(|k| Distribution::new((0..gaussians.len()).map(|i| avatar.placed(i)[k]))),
            position_step: gaussians.bounds.step().to_array(),
            scale: Distribution::new(
                gaussians
                    .log_scale
                    .as_flattened()
                    .iter()
                    .map(|s| s.to_f64().exp()),
            ),
            opacity: Distribution::new(gaussians.opacity.iter().map(|&o| f64::from(o) / 255.0)),
            color: [0, 1, 2]
                .map(|k| Distribution::new(gaussians.color.iter().map(|c| c[k].to_f64()))),
            harmonics: avatar.sh.as_ref().map_or(0, |harmonics| harmonics.degree),
            filter: avatar.filter,
            facing: not_facing(&avatar.gaussians.facing),
            levels: avatar.levels.iter().map(LevelSummary::new).collect(),
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
        let features = if self.split_features {
            "nodes have features of their own"
        } else {
            "nodes share the features"
        };
        let weights = if self.byte_networks { "bytes" } else { "f16" };
        format!(
            "{}, {activation}, in {weights}; {} basis functions, {features}",
            widths.join(" → "),
            self.basis
        )
    }

    fn inputs(&self) -> String {
        if self.widths.is_empty() {
            return "none".into();
        }
        let space = |components: Option<usize>| {
            components.map_or_else(
                || "unchanged".into(),
                |k| format!("{k} principal components"),
            )
        };
        let pose = format!(
            "rotations of {} joints ({})",
            self.input_joints.len(),
            space(self.pose_components)
        );
        match self.expression {
            0 => pose + ", no expression",
            n => format!(
                "{pose}, {n} expression coefficients ({})",
                space(self.expression_components)
            ),
        }
    }

    fn part_sizes(&self) -> String {
        let Distribution { min, median, max } = self.part_size;
        format!(
            "{}, of {min} to {max} Gaussians (median {median}); {} see the expression",
            self.parts, self.head_parts
        )
    }
}

/// What lengths are told in, so that a few digits say something of a scene of any size.
struct LengthUnit {
    name: &'static str,
    thousandth: &'static str,
    in_a_metre: f64,
}

impl LengthUnit {
    /// For numbers as large as a length, metres.
    fn of(length: f64) -> Self {
        if length == 0.0 || length >= 0.1 {
            Self {
                name: "m",
                thousandth: "mm",
                in_a_metre: 1.0,
            }
        } else if length >= 1e-4 {
            Self {
                name: "mm",
                thousandth: "µm",
                in_a_metre: 1e3,
            }
        } else {
            Self {
                name: "µm",
                thousandth: "nm",
                in_a_metre: 1e6,
            }
        }
    }
}

/// The share of all directions that cones leave out, in the mean.
fn not_facing(codes: &[FacingCode]) -> f64 {
    // A cap of the sphere is as large as it is high.
    let left_out = |code: &FacingCode| ((1.0 + Facing::decode(*code).limit) / 2.0).clamp(0.0, 1.0);
    codes.iter().map(left_out).sum::<f64>() / codes.len().max(1) as f64
}

/// Joints in a row, without a branch between them.
struct JointChain {
    /// Branches between the root and the chain.
    depth: usize,
    /// Names, separated by spaces.
    joints: String,
}

/// The chain of joints from `start` to where the skeleton branches or ends, then those that begin
/// there.
fn chains(joints: &[NamedJoint], start: usize, depth: usize) -> Vec<JointChain> {
    let children = |parent: usize| -> Vec<usize> {
        (0..joints.len())
            .filter(|&child| joints[child].parent.map(usize::from) == Some(parent))
            .collect()
    };
    let mut names = joints[start].name.clone();
    let mut next = children(start);
    while let &[only] = next.as_slice() {
        names += &format!(" {}", joints[only].name);
        next = children(only);
    }
    let mut found = vec![JointChain {
        depth,
        joints: names,
    }];
    for child in next {
        found.extend(chains(joints, child, depth + 1));
    }
    found
}

impl AvatarSummary {
    /// Where positions, sizes, opacities and colours lie.
    fn fmt_distributions(&self, f: &mut fmt::Formatter) -> fmt::Result {
        for (name, axis) in ["x", "y", "z"].iter().zip(&self.position) {
            let Distribution { min, median, max } = axis;
            let unit = LengthUnit::of(max - min);
            let [min, median, max] = [min, median, max].map(|metres| metres * unit.in_a_metre);
            line(
                f,
                name,
                format_args!("{min:.3} to {max:.3} {}, median {median:.3}", unit.name),
            )?;
        }
        let coarsest = self.position_step.into_iter().fold(0.0, f64::max);
        let unit = LengthUnit::of(1e5 * coarsest);
        let [x, y, z] = self.position_step.map(|step| 1e3 * step * unit.in_a_metre);
        line(
            f,
            "step",
            format_args!(
                "{x:.4} × {y:.4} × {z:.4} {} between neighbouring positions",
                unit.thousandth
            ),
        )?;
        let Distribution { min, median, max } = &self.scale;
        let unit = LengthUnit::of(1e3 * median);
        let [min, median, max] = [min, median, max].map(|metres| 1e3 * metres * unit.in_a_metre);
        line(
            f,
            "deviation",
            format_args!(
                "{min:.2} to {max:.2} {}, median {median:.2}",
                unit.thousandth
            ),
        )?;
        let [red, green, blue] = &self.color;
        for (name, values) in [
            ("opacity", &self.opacity),
            ("red", red),
            ("green", green),
            ("blue", blue),
        ] {
            let Distribution { min, median, max } = values;
            line(
                f,
                name,
                format_args!("{min:.3} to {max:.3}, median {median:.3}"),
            )?;
        }
        Ok(())
    }
}

impl fmt::Display for AvatarSummary {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        line(f, "avatar", &self.name)?;
        line(f, "credit", stated(&self.credit))?;
        line(f, "Gaussians", thousands(self.gaussians))?;
        line(f, "parts", self.part_sizes())?;
        line(f, "nodes", thousands(self.nodes))?;
        line(f, "networks", self.networks())?;
        line(f, "inputs", self.inputs())?;
        line(
            f,
            "basis rows",
            format_args!(
                "rotation {}, scale {}, colour {}",
                thousands(self.rotation_rows),
                thousands(self.scale_rows),
                thousands(self.color_rows)
            ),
        )?;
        self.fmt_distributions(f)?;
        match self.harmonics {
            0 => line(f, "harmonics", "none: colours do not depend on the view")?,
            degree => line(f, "harmonics", format_args!("degree {degree}"))?,
        }
        let compensated = if self.filter.compensated {
            ", opacities compensated"
        } else {
            ""
        };
        line(
            f,
            "low-pass",
            format_args!("{} px²{compensated}", self.filter.variance),
        )?;
        if self.facing > 0.0 {
            line(
                f,
                "facing",
                format_args!(
                    "not drawn from {:.0} % of all directions in the mean",
                    100.0 * self.facing
                ),
            )?;
        }
        for level in &self.levels {
            level.fmt(f)?;
        }
        line(f, "skeleton", format_args!("{} joints", self.joints.len()))?;
        for JointChain { depth, joints } in chains(&self.joints, 0, 0) {
            writeln!(f, "{:12}{:indent$}{joints}", "", "", indent = 2 * depth)?;
        }
        table(f, &self.tensors)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_chain_ends_where_the_skeleton_branches() {
        let joint = |name: &str, parent: Option<u8>| NamedJoint {
            name: name.into(),
            parent,
        };
        let skeleton = [
            joint("root", None),
            joint("hip", Some(0)),
            joint("spine", Some(0)),
            joint("knee", Some(1)),
            joint("neck", Some(2)),
            joint("jaw", Some(4)),
            joint("eye", Some(4)),
        ];
        let chains = chains(&skeleton, 0, 0);
        let found: Vec<(usize, &str)> = chains
            .iter()
            .map(|chain| (chain.depth, chain.joints.as_str()))
            .collect();
        assert_eq!(
            found,
            [
                (0, "root"),
                (1, "hip knee"),
                (1, "spine neck"),
                (2, "jaw"),
                (2, "eye"),
            ]
        );
    }
}
