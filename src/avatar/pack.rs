//! Fewer bits: an avatar goes in, the nearest one that a packed file holds in fewer bits comes out, a step at a time. Which steps there
//! are, and in which order they are worth it, is here; how the file stores what comes out is in [`super::file`].

use super::{Avatar, file::format::LogScaleCodes};
use crate::{frame::FEATURE_MAX, layout::compact, reference::features};
use half::f16;

/// Something that takes fewer bits afterwards.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Step {
    /// Zeros in place of numbers that no picture depends on: weights of the expression outside the head, joints of weight 0.
    Unused,
    /// Quaternions of length 1 in 32 bits, their correctives divided by what they were divided by, in bytes with a step a row.
    Rotations,
    /// Log scales in 10 bits.
    LogScales,
    /// Colours in bytes, but for those that a corrective is added to.
    Colors,
    /// The other bases in bytes, with a step a row.
    Bases,
    /// Weights of the networks with 10 bits that count in place of f16's 11: it is the file that gets smaller.
    Weights,
    /// Weights of the networks in bytes, with a step a neuron; the last biases make up for what that changes in the mean.
    Networks,
}

impl Step {
    /// What it does, in a few words.
    pub fn name(self) -> &'static str {
        match self {
            Self::Unused => "zeros for what is not used",
            Self::Rotations => "quaternions in 32 bits, their basis in bytes",
            Self::LogScales => "log scales in 10 bits",
            Self::Colors => "colours in bytes",
            Self::Bases => "the other bases in bytes",
            Self::Weights => "networks in 10 bits that count",
            Self::Networks => "networks in bytes",
        }
    }
}

/// How much may be lost.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quality {
    /// Every picture stays what it is.
    Lossless,
    /// What the renderers round anyway: their pictures stay what they are.
    High,
    /// Weights of networks less exactly too.
    Medium,
    /// Networks in bytes, which take half the memory.
    Small,
}

impl Quality {
    pub const ALL: [Self; 4] = [Self::Lossless, Self::High, Self::Medium, Self::Small];

    /// The steps of it, in their order.
    pub fn steps(self) -> &'static [Step] {
        use Step::{Bases, Colors, LogScales, Networks, Rotations, Unused, Weights};
        match self {
            Self::Lossless => &[Unused],
            Self::High => &[Unused, Rotations, LogScales, Colors, Bases],
            Self::Medium => &[Unused, Rotations, LogScales, Colors, Bases, Weights],
            Self::Small => &[Unused, Rotations, LogScales, Colors, Bases, Networks],
        }
    }
}

impl Avatar {
    /// The avatar after all steps of a quality.
    pub fn packed(&self, quality: Quality) -> Self {
        quality.steps().iter().fold(self.clone(), |avatar, &step| avatar.after(step))
    }

    /// The avatar after a step. Twice is once.
    pub fn after(&self, step: Step) -> Self {
        let mut after = self.clone();
        match step {
            Step::Unused => after.zero_unused(),
            Step::Rotations => {
                after.rotation_rows.basis = compact::matrix_of(compact::rotation_rows(self));
                let unit = |q: &[f16; 4]| compact::decode_quaternion(compact::encode_quaternion(q.map(f64::from)).0).map(f16::from_f64);
                after.gaussians.rotation = self.gaussians.rotation.iter().map(unit).collect();
            }
            Step::LogScales => {
                let [codes, _] = LogScaleCodes::of(self);
                after.gaussians.log_scale.iter_mut().flatten().for_each(|s| *s = codes.decode(codes.encode(*s)));
            }
            Step::Colors => after.round_colors(),
            Step::Bases => {
                after.scale_rows.basis = compact::matrix_of(compact::rows(&self.scale_rows, self.basis_len()));
                after.color_rows.basis = compact::matrix_of(compact::rows(&self.color_rows, self.basis_len()));
                after.nodes.basis = compact::matrix_of(compact::node_rows(self));
            }
            Step::Weights => {
                let halves = after.networks.layers.iter_mut().filter(|layer| !layer.weight.is_bytes());
                halves.flat_map(|layer| layer.weight.halves_mut()).for_each(|w| *w = fewer_bits(*w));
            }
            Step::Networks if self.networks.in_bytes() => {}
            Step::Networks => {
                after.networks.layers.iter_mut().for_each(|layer| layer.weight = layer.weight.bytes(layer.input));
                after.center_features(self);
            }
        }
        after
    }

    /// [`Step::Unused`].
    fn zero_unused(&mut self) {
        let (head, pose) = (self.parts.head, 3 * self.inputs.joint.len());
        if let Some(layer) = self.networks.layers.first_mut() {
            layer.weight.zero_columns(head * layer.output, pose..layer.input, layer.input);
        }
        let g = &mut self.gaussians;
        for (joints, weights) in g.joint.iter_mut().zip(&g.joint_weight) {
            joints.iter_mut().zip(weights).filter(|(_, weight)| **weight == 0).for_each(|(joint, _)| *joint = 0);
        }
    }

    /// Gives the last layer the biases with which features are, in the mean over the training poses, what they are of another avatar. The
    /// poses are the mean and one σ along each principal component: what is left is noise around it, and no shift of whole parts.
    fn center_features(&mut self, exact: &Self) {
        let inputs = exact.inputs.typical();
        let mut shift = vec![0.0; self.parts.len() * self.networks.output()];
        for input in &inputs {
            let [now, then] = [&*self, exact].map(|avatar| features::features(avatar, input));
            shift.iter_mut().zip(then.iter().zip(now)).for_each(|(shift, (then, now))| *shift += (then - now) / inputs.len() as f64);
        }
        if let Some(last) = self.networks.layers.last_mut() {
            last.bias
                .iter_mut()
                .zip(shift)
                .for_each(|(bias, shift)| *bias = f16::from_f64((bias.to_f64() + shift).clamp(-FEATURE_MAX, FEATURE_MAX)));
        }
    }

    /// [`Step::Colors`].
    fn round_colors(&mut self) {
        let mut kept = self.color_rows.gaussian.iter().peekable();
        for (at, color) in self.gaussians.color.iter_mut().enumerate() {
            if kept.next_if(|&&row| row as usize == at).is_none() {
                *color = color.map(|c| f16::from_f64((c.to_f64().clamp(0.0, 1.0) * 255.0).round() / 255.0));
            }
        }
    }
}

/// A nearest number whose last bit is zero: of two that are as near, the one whose last bit but one is zero too.
fn fewer_bits(number: f16) -> f16 {
    let bits = number.to_bits();
    // The largest of all would become infinite.
    let up = bits & 3 == 3 && bits & 0x7fff != f16::MAX.to_bits();
    f16::from_bits(if up { bits + 1 } else { bits & !1 })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{demo, layout::pack};

    /// The buffers that the renderers make of an avatar.
    fn buffers(avatar: &Avatar) -> (Vec<[u32; 2]>, [Vec<u32>; 3]) {
        let constants = &pack::constants(avatar);
        let (places, _) = pack::node_places(avatar);
        let mut gaussians = pack::gaussians(avatar, &places);
        // Where two components are as large, either may be left out of a quaternion: the same f16 come of both.
        let quaternions = &mut gaussians[3 * avatar.gaussians.len()..][..avatar.gaussians.len()];
        let first =
            |q: [f64; 4]| q.map(|v| u32::from(f16::from_f64(v).to_bits())).into_iter().fold(0, |hash: u32, v| hash.rotate_left(9) ^ v);
        quaternions.iter_mut().for_each(|pair| pair[0] = first(compact::decode_quaternion(pair[0])));
        (gaussians, [pack::rows(avatar), pack::nodes(avatar, &places), pack::networks(avatar, constants)])
    }

    #[test]
    fn high_quality_is_what_the_renderers_keep() {
        let avatar = demo::avatar().expect("inside the program");
        let high = avatar.packed(Quality::High);
        let ((gaussians, [rows, nodes, networks]), after) = (buffers(&avatar.after(Step::Unused)), buffers(&high));
        let differ = gaussians.iter().zip(&after.0).filter(|(a, b)| a != b).count();
        assert_eq!((differ, rows == after.1[0], nodes == after.1[1], networks == after.1[2]), (0, true, true, true));
        assert!(high.packed(Quality::High) == high, "twice is not once");
        let medium = avatar.packed(Quality::Medium);
        assert!(medium.packed(Quality::Medium) == medium, "twice is not once");
        assert!(medium.color_rows == high.color_rows && medium.networks != high.networks);
        let small = avatar.packed(Quality::Small);
        assert!(small.networks.in_bytes() && small.packed(Quality::Small) == small, "twice is not once");
    }

    #[test]
    fn features_of_networks_in_bytes_are_right_in_the_mean() {
        let avatar = demo::avatar().expect("inside the program");
        let mut plain = avatar.clone();
        plain.networks.layers.iter_mut().for_each(|layer| layer.weight = layer.weight.bytes(layer.input));
        let mean = |other: &Avatar| -> f64 {
            let inputs = avatar.inputs.typical();
            assert!(inputs.len() > 20, "{} poses", inputs.len());
            let of = |avatar: &Avatar| {
                let sum = |sum: Vec<f64>, e: Vec<f64>| if sum.is_empty() { e } else { sum.iter().zip(e).map(|(a, b)| a + b).collect() };
                inputs.iter().map(|input| features::features(avatar, input)).fold(vec![], sum)
            };
            let off = of(&avatar).iter().zip(of(other)).map(|(a, b)| ((a - b) / inputs.len() as f64).powi(2)).sum::<f64>();
            off.sqrt()
        };
        let (before, after) = (mean(&plain), mean(&avatar.after(Step::Networks)));
        assert!(after < 0.2 * before, "off by {before} before, by {after} after");
    }

    #[test]
    fn weights_keep_ten_bits() {
        for value in [1.0, -1.0, 0.3, 6e-8, 0.0, 65504.0, -65504.0, 2.0 - 1.0 / 1024.0] {
            let (exact, fewer) = (f16::from_f64(value), fewer_bits(f16::from_f64(value)));
            let room = (exact.to_f64() / 1023.0).abs().max(f16::MIN_POSITIVE_SUBNORMAL.to_f64());
            assert!((fewer.to_f64() - exact.to_f64()).abs() <= room && fewer.to_bits() & 1 == 0, "{value} became {fewer}");
            assert_eq!(fewer_bits(fewer), fewer);
        }
    }

    #[test]
    fn what_is_packed_reads_back_and_is_smaller() {
        let avatar = demo::avatar().expect("inside the program");
        let mut length = avatar.to_bytes().expect("it can be written").len();
        for quality in Quality::ALL {
            let packed = avatar.packed(quality);
            let bytes = packed.to_packed_bytes().expect("it can be written");
            assert!(Avatar::from_bytes(&bytes).expect("it can be read") == packed, "{quality:?} is another");
            assert!((bytes.len() as f64) < 0.99 * length as f64, "{quality:?}: {} bytes after {length}", bytes.len());
            length = bytes.len();
            assert!(Avatar::from_bytes(&packed.to_bytes().expect("it can be written")).expect("it can be read") == packed);
        }
    }
}
