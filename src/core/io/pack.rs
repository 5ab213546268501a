//! Packing: rounds an avatar, step by step, to one that a packed file stores in fewer bits.
//! [`super::file`] defines how such files store it.

use super::file::format::{HarmonicCodes, LogScaleCodes};
use crate::avatar::{Avatar, Level};
use crate::{constants::FEATURE_MAX, layout::compact, reference::mlp};
use half::f16;

/// A step of packing, after which something takes fewer bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub enum PackStep {
    /// Zeros in place of numbers that no image depends on: weights of the expression outside the
    /// head, joints of weight 0.
    Unused,
    /// Quaternions of length 1 in 32 bits, and their correctives in bytes with a step a row.
    Rotations,
    /// Log scales in 10 bits.
    LogScales,
    /// Colours in bytes, except those that a corrective is added to, or spherical harmonics.
    Colors,
    /// Spherical harmonics, that of degree 0 among them, in 256ths.
    Harmonics,
    /// And in 64ths.
    CoarseHarmonics,
    /// The other bases in bytes, with a step a row.
    Bases,
    /// Weights of the networks with 10 significant bits instead of f16's 11: the file deflates
    /// better.
    Weights,
    /// Weights of the networks in bytes, with a step a neuron; the last layer's biases compensate
    /// the mean error.
    Networks,
}

impl PackStep {
    /// Whether an avatar has what this step rounds.
    pub fn applies_to(self, avatar: &Avatar) -> bool {
        match self {
            Self::Unused | Self::Rotations | Self::LogScales => true,
            Self::Colors => avatar.sh.is_none(),
            Self::Harmonics | Self::CoarseHarmonics => avatar.sh.is_some(),
            Self::Bases | Self::Weights | Self::Networks => !avatar.networks.layers.is_empty(),
        }
    }

    /// A short description for users.
    pub fn name(self) -> &'static str {
        match self {
            Self::Unused => "zeros for what is not used",
            Self::Rotations => "quaternions in 32 bits, their basis in bytes",
            Self::LogScales => "log scales in 10 bits",
            Self::Colors => "colours in bytes",
            Self::Harmonics => "spherical harmonics in 256ths",
            Self::CoarseHarmonics => "spherical harmonics in 64ths",
            Self::Bases => "the other bases in bytes",
            Self::Weights => "networks in 10 bits that count",
            Self::Networks => "networks in bytes",
        }
    }
}

/// How much packing may lose.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PackQuality {
    /// Images do not change.
    Lossless,
    /// Rounds only what renderers round anyway: their images do not change. And spherical harmonics
    /// to 256ths, as much as they round colours without any.
    High,
    /// Rounds the networks' weights too, and spherical harmonics to 64ths.
    Medium,
    /// Stores networks in bytes, which take half the memory.
    Small,
}

impl PackQuality {
    /// Every quality, from the largest file to the smallest.
    pub const ALL: [Self; 4] = [Self::Lossless, Self::High, Self::Medium, Self::Small];

    /// The steps, in the order to apply them.
    pub fn steps(self) -> &'static [PackStep] {
        use PackStep::{
            Bases, CoarseHarmonics, Colors, Harmonics, LogScales, Networks, Rotations, Unused,
            Weights,
        };
        match self {
            Self::Lossless => &[Unused],
            Self::High => &[Unused, Rotations, LogScales, Colors, Harmonics, Bases],
            Self::Medium => &[
                Unused,
                Rotations,
                LogScales,
                Colors,
                CoarseHarmonics,
                Bases,
                Weights,
            ],
            Self::Small => &[
                Unused,
                Rotations,
                LogScales,
                Colors,
                CoarseHarmonics,
                Bases,
                Networks,
            ],
        }
    }
}

impl Avatar {
    /// The avatar after all steps of a quality.
    pub fn packed(&self, quality: PackQuality) -> Self {
        quality
            .steps()
            .iter()
            .fold(self.clone(), |avatar, &step| avatar.after(step))
    }

    /// The avatar after a step. Applying a step twice has no further effect.
    pub fn after(&self, step: PackStep) -> Self {
        if step.applies_to(self) {
            self.rounded(step)
        } else {
            self.clone()
        }
    }

    /// [`Self::after`] of a step that applies to it, or to the avatar that it is a level of.
    fn rounded(&self, step: PackStep) -> Self {
        let mut after = self.clone();
        after.levels = self
            .levels
            .iter()
            .map(|level| self.level_after(level, step))
            .collect();
        match step {
            PackStep::Unused => after.zero_unused(),
            PackStep::Rotations => {
                after.rotation_rows.basis = compact::matrix_of(compact::rotation_rows(self));
                let unit = |q: &[f16; 4]| {
                    compact::decode_quaternion(compact::encode_quaternion(q.map(f64::from)).0)
                        .map(f16::from_f64)
                };
                after.gaussians.rotation = self.gaussians.rotation.iter().map(unit).collect();
            }
            PackStep::LogScales => {
                let [codes, _] = LogScaleCodes::candidates(&self.gaussians);
                for s in after.gaussians.log_scale.iter_mut().flatten() {
                    *s = codes.decode(codes.encode(*s));
                }
            }
            PackStep::Colors if self.sh.is_some() => {}
            PackStep::Colors => after.round_colors(),
            PackStep::Harmonics => after.round_harmonics(HarmonicCodes::FINE),
            PackStep::CoarseHarmonics => after.round_harmonics(HarmonicCodes::COARSE),
            PackStep::Bases => {
                after.scale_rows.basis =
                    compact::matrix_of(compact::rows(&self.scale_rows, self.basis_len()));
                after.color_rows.basis =
                    compact::matrix_of(compact::rows(&self.color_rows, self.basis_len()));
                // As renderers balance them.
                after = after.balanced();
                let rows = compact::node_rows(&after.nodes.basis, 3 * self.basis_len());
                after.nodes.basis = compact::matrix_of(rows);
            }
            PackStep::Weights => {
                for layer in &mut after.networks.layers {
                    if layer.weight.is_bytes() {
                        continue;
                    }
                    for weight in layer.weight.halves_mut() {
                        *weight = round_to_ten_bits(*weight);
                    }
                }
            }
            PackStep::Networks if self.networks.in_bytes() => {}
            PackStep::Networks => {
                for layer in &mut after.networks.layers {
                    layer.weight = layer.weight.bytes(layer.input);
                }
                after.center_features(self);
            }
        }
        after
    }

    /// A level after a step: what happens to an avatar's Gaussians and rows happens to its.
    fn level_after(&self, level: &Level, step: PackStep) -> Level {
        if matches!(step, PackStep::Weights | PackStep::Networks) {
            return level.clone();
        }
        let after = self.at_level(level).rounded(step);
        Level {
            gaussians: after.gaussians,
            rotation_rows: after.rotation_rows,
            scale_rows: after.scale_rows,
            color_rows: after.color_rows,
            sh: after.sh,
            ..level.clone()
        }
    }

    /// [`PackStep::Unused`].
    fn zero_unused(&mut self) {
        let head = self.parts.head;
        let pose = 3 * self.inputs.joint.len();
        if let Some(layer) = self.networks.layers.first_mut() {
            layer
                .weight
                .zero_columns(head * layer.output, pose..layer.input, layer.input);
        }
        let g = &mut self.gaussians;
        for (joints, weights) in g.joint.iter_mut().zip(&g.joint_weight) {
            for (joint, &weight) in joints.iter_mut().zip(weights) {
                if weight == 0 {
                    *joint = 0;
                }
            }
        }
    }

    /// Adjusts the biases of the last layer so that the features' mean over the training poses
    /// equals that of `exact`. The poses are [`Inputs::typical`](crate::avatar::Inputs::typical).
    /// The remaining error is noise around the mean instead of a shift of whole parts.
    fn center_features(&mut self, exact: &Self) {
        let inputs = exact.inputs.typical();
        let mut shift = vec![0.0; self.parts.len() * self.networks.output()];
        for input in &inputs {
            let rounded = mlp::features(self, input);
            let exact = mlp::features(exact, input);
            for (shift, (exact, rounded)) in shift.iter_mut().zip(exact.iter().zip(rounded)) {
                *shift += (exact - rounded) / inputs.len() as f64;
            }
        }
        if let Some(last) = self.networks.layers.last_mut() {
            for (bias, shift) in last.bias.iter_mut().zip(shift) {
                *bias = f16::from_f64((bias.to_f64() + shift).clamp(-FEATURE_MAX, FEATURE_MAX));
            }
        }
    }

    /// [`PackStep::Harmonics`] or [`PackStep::CoarseHarmonics`].
    fn round_harmonics(&mut self, codes: HarmonicCodes) {
        let Some(sh) = &mut self.sh else {
            return;
        };
        let constant = self.gaussians.color.iter_mut().flatten();
        for coefficient in sh.coefficients.iter_mut().flatten().chain(constant) {
            *coefficient = codes.round(*coefficient);
        }
    }

    /// [`PackStep::Colors`].
    fn round_colors(&mut self) {
        let mut with_row = self.color_rows.gaussian.iter().peekable();
        for (at, color) in self.gaussians.color.iter_mut().enumerate() {
            if with_row.next_if(|&&row| row as usize == at).is_none() {
                *color = color
                    .map(|c| f16::from_f64((c.to_f64().clamp(0.0, 1.0) * 255.0).round() / 255.0));
            }
        }
    }
}

/// Rounds to the nearest number whose last bit is zero; ties go to the one whose second-last bit is
/// zero too.
fn round_to_ten_bits(number: f16) -> f16 {
    let bits = number.to_bits();
    // The largest of all would become infinite.
    let up = bits & 3 == 3 && bits & 0x7fff != f16::MAX.to_bits();
    f16::from_bits(if up { bits + 1 } else { bits & !1 })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::constants::F16_MAX;
    use crate::layout::pack;

    /// The packed buffers of an avatar for the GPU.
    fn buffers(avatar: &Avatar) -> (Vec<[u32; 2]>, [Vec<u32>; 3]) {
        let constants = &pack::constants(avatar);
        let (places, _) = pack::node_places(avatar);
        let mut gaussians = pack::gaussians(avatar, &places);
        // If two components are equally large, either may be left out of a quaternion: both decode
        // to the same f16.
        let quaternions = &mut gaussians[3 * avatar.gaussians.len()..][..avatar.gaussians.len()];
        let hash = |q: [f64; 4]| {
            q.map(|v| u32::from(f16::from_f64(v).to_bits()))
                .into_iter()
                .fold(0, |hash: u32, v| hash.rotate_left(9) ^ v)
        };
        for pair in quaternions {
            pair[0] = hash(compact::decode_quaternion(pair[0]));
        }
        (
            gaussians,
            [
                pack::rows(avatar),
                pack::nodes(avatar, &places),
                pack::networks(avatar, constants),
            ],
        )
    }

    #[test]
    fn high_quality_rounds_only_what_renderers_round() {
        let avatar = crate::demo::avatar().expect("inside the program");
        let high = avatar.packed(PackQuality::High);
        let ((gaussians, [rows, nodes, networks]), after) =
            (buffers(&avatar.after(PackStep::Unused)), buffers(&high));
        let differ = gaussians
            .iter()
            .zip(&after.0)
            .filter(|(a, b)| a != b)
            .count();
        assert_eq!(
            (
                differ,
                rows == after.1[0],
                nodes == after.1[1],
                networks == after.1[2]
            ),
            (0, true, true, true)
        );
        assert!(high.packed(PackQuality::High) == high, "twice is not once");
        let medium = avatar.packed(PackQuality::Medium);
        assert!(
            medium.packed(PackQuality::Medium) == medium,
            "twice is not once"
        );
        assert!(medium.color_rows == high.color_rows && medium.networks != high.networks);
        let small = avatar.packed(PackQuality::Small);
        assert!(
            small.networks.in_bytes() && small.packed(PackQuality::Small) == small,
            "twice is not once"
        );
    }

    #[test]
    fn networks_in_bytes_keep_the_mean_features() {
        let avatar = crate::demo::avatar().expect("inside the program");
        let mut plain = avatar.clone();
        for layer in &mut plain.networks.layers {
            layer.weight = layer.weight.bytes(layer.input);
        }
        let mean = |other: &Avatar| -> f64 {
            let inputs = avatar.inputs.typical();
            assert!(inputs.len() > 20, "{} poses", inputs.len());
            let of = |avatar: &Avatar| {
                let sum = |sum: Vec<f64>, e: Vec<f64>| {
                    if sum.is_empty() {
                        e
                    } else {
                        sum.iter().zip(e).map(|(a, b)| a + b).collect()
                    }
                };
                inputs
                    .iter()
                    .map(|input| mlp::features(avatar, input))
                    .fold(vec![], sum)
            };
            let off = of(&avatar)
                .iter()
                .zip(of(other))
                .map(|(a, b)| ((a - b) / inputs.len() as f64).powi(2))
                .sum::<f64>();
            off.sqrt()
        };
        let before = mean(&plain);
        let after = mean(&avatar.after(PackStep::Networks));
        assert!(
            after < 0.2 * before,
            "off by {before} before, by {after} after"
        );
    }

    #[test]
    fn weights_keep_ten_bits() {
        for value in [
            1.0,
            -1.0,
            0.3,
            6e-8,
            0.0,
            F16_MAX,
            -F16_MAX,
            2.0 - 1.0 / 1024.0,
        ] {
            let exact = f16::from_f64(value);
            let fewer = round_to_ten_bits(exact);
            let tolerance = (exact.to_f64() / 1023.0)
                .abs()
                .max(f16::MIN_POSITIVE_SUBNORMAL.to_f64());
            assert!(
                (fewer.to_f64() - exact.to_f64()).abs() <= tolerance && fewer.to_bits() & 1 == 0,
                "{value} became {fewer}"
            );
            assert_eq!(round_to_ten_bits(fewer), fewer);
        }
    }

    #[test]
    fn packed_avatars_read_back_and_are_smaller() {
        let avatar = crate::demo::avatar().expect("inside the program");
        let mut length = avatar.to_bytes().expect("it can be written").len();
        for quality in PackQuality::ALL {
            let packed = avatar.packed(quality);
            let bytes = packed.to_packed_bytes().expect("it can be written");
            assert!(
                Avatar::from_bytes(&bytes).expect("it can be read") == packed,
                "{quality:?} is another"
            );
            assert!(
                (bytes.len() as f64) < 0.99 * length as f64,
                "{quality:?}: {} bytes after {length}",
                bytes.len()
            );
            length = bytes.len();
            assert!(
                Avatar::from_bytes(&packed.to_bytes().expect("it can be written"))
                    .expect("it can be read")
                    == packed
            );
        }
    }
}
