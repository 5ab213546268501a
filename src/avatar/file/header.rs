//! The documents in the files' headers: taken from a model, checked, and made into a model with the tensors.

use super::arrays::{basis, rows};
use super::coding::{self, Coded, LogScaleCodes};
use super::container::Container;
use super::format::{
    AVATAR, AVATAR_FORMAT, AvatarHeader, ClipHeader, Document, MOTION, MOTION_FORMAT, Order, Tensor, VERSION, VERSION_PACKED,
};
use super::{Fault, clip};
use crate::avatar::{Avatar, Clip, Nodes, Parts, Subspace, limits};
use std::collections::{BTreeMap, HashSet};
use std::fmt::Display;
use std::ops::RangeInclusive;

const UNITS: &str = "metre";
const UP: &str = "y";
const COLOR_SPACE: &str = "srgb";

/// The space that an avatar has, or an empty one.
pub fn subspace(space: &Option<Subspace>) -> &Subspace {
    static NONE: Subspace = Subspace { mean: vec![], component: vec![], sigma: vec![] };
    space.as_ref().unwrap_or(&NONE)
}

/// A number of something lies in a range.
fn count(field: &str, found: usize, range: RangeInclusive<usize>) -> Result<(), Fault> {
    let expected = || format!("{} to {}", range.start(), range.end());
    if range.contains(&found) { Ok(()) } else { Err(Fault::metadata(field, found, expected())) }
}

fn ensure(good: bool, field: &str, found: impl Display, expected: impl Display) -> Result<(), Fault> {
    if good { Ok(()) } else { Err(Fault::metadata(field, found, expected)) }
}

/// A fixed word of the format.
fn word(field: &str, found: &str, expected: &str) -> Result<(), Fault> {
    ensure(found == expected, field, format_args!("{:?}", clip(found)), format_args!("{expected:?}"))
}

/// There is a joint, there are not too many, and no two have one name.
fn joints(names: &[String]) -> Result<(), Fault> {
    let good = (1..=limits::JOINTS).contains(&names.len());
    ensure(good, "joints", format_args!("{} names", names.len()), format_args!("1 to {}", limits::JOINTS))?;
    let mut seen = HashSet::new();
    match names.iter().find(|name| !seen.insert(name.as_str())) {
        Some(name) => Err(Fault::metadata("joints", format_args!("{:?} twice", clip(name)), "names that differ")),
        None => Ok(()),
    }
}

impl AvatarHeader {
    /// Length of θ_p.
    pub fn pose_len(&self) -> usize {
        3 * self.inputs.len()
    }

    /// The document of an avatar in as few bits as hold it.
    pub fn packed(avatar: &Avatar) -> Self {
        let (coded, log_scales) = coding::exact(avatar);
        Self { version: VERSION_PACKED, coded, log_scales, ..Self::of(avatar) }
    }

    /// Tensors of what is coded, 0 or 1.
    pub(super) fn coded(&self, what: Coded) -> usize {
        usize::from(self.coded.contains(&what))
    }

    pub(super) fn plain(&self, what: Coded) -> usize {
        1 - self.coded(what)
    }

    /// How many tensors there are of log scales in so many bits.
    pub(super) fn log_scales_of(&self, bits: u32) -> usize {
        usize::from(self.log_scales.is_some_and(|codes| codes.bits == bits))
    }

    pub(super) fn layers(&self) -> usize {
        self.widths.len().saturating_sub(1)
    }

    fn check_codes(&self) -> Result<(), Fault> {
        let plain = self.coded.is_empty() && self.log_scales.is_none() && self.deflated.is_empty();
        ensure(plain || self.version == VERSION_PACKED, "version", self.version, format_args!("{VERSION_PACKED}, as there are codes"))?;
        let Some(LogScaleCodes { min, step, bits }) = self.log_scales else { return Ok(()) };
        let [[least, most], [finest, coarsest]] = LogScaleCodes::RANGE;
        let good = (least..=most).contains(&min) && (finest..=coarsest).contains(&step) && [8, 16].contains(&bits);
        let expected = format!("a min from {least} to {most}, a step from {finest} to {coarsest}, 8 or 16 bits");
        ensure(good, "log_scales", format_args!("min {min:e}, step {step:e}, {bits} bits"), expected)
    }

    fn check_counts(&self) -> Result<(), Fault> {
        count("gaussians", self.gaussians, 1..=limits::GAUSSIANS)?;
        count("parts", self.parts, 1..=limits::PARTS)?;
        count("head_parts", self.head_parts, 0..=self.parts)?;
        count("nodes", self.nodes, 1..=limits::NODES)?;
        count("basis", self.basis, 4..=limits::BASIS)?;
        ensure(self.basis.is_multiple_of(4), "basis", self.basis, "a multiple of 4")?;
        count("rotation_rows", self.rotation_rows, 0..=self.gaussians)?;
        count("scale_rows", self.scale_rows, 0..=self.gaussians)?;
        count("color_rows", self.color_rows, 0..=self.gaussians)?;
        let [min, max] = self.bounds;
        let good = (0..3).all(|k| min[k] <= max[k] && f64::from(min[k]) >= -limits::LENGTH && f64::from(max[k]) <= limits::LENGTH);
        let expected = format!("a lower and an upper corner within ±{} metres", limits::LENGTH);
        ensure(good, "bounds", format_args!("{min:?} to {max:?}"), expected)
    }

    fn check_skeleton(&self) -> Result<(), Fault> {
        joints(&self.joints)?;
        let n = self.joints.len();
        ensure(self.parents.len() == n, "parents", format_args!("{} entries", self.parents.len()), format_args!("{n}, one a joint"))?;
        for (j, parent) in self.parents.iter().enumerate() {
            let (good, expected) = match parent {
                None => (j == 0, "a parent for every joint but joint 0"),
                Some(parent) => (usize::from(*parent) < j, "a parent that stands before its child, and null for joint 0"),
            };
            let found = parent.map_or("null".to_owned(), |parent| parent.to_string());
            ensure(good, "parents", format_args!("{found} for joint {j}"), expected)?;
        }
        match self.inputs.iter().find(|&&input| usize::from(input) >= n) {
            Some(input) => Err(Fault::metadata("inputs", format_args!("joint {input}"), format_args!("joints below {n}"))),
            None => Ok(()),
        }
    }

    fn check_networks(&self) -> Result<(), Fault> {
        count("expression", self.expression, 0..=limits::EXPRESSION)?;
        let layers = self.widths.len().saturating_sub(1);
        let expected = format!("1 to {}: one width more than layers", limits::MLP_LAYERS);
        ensure((1..=limits::MLP_LAYERS).contains(&layers), "widths", format_args!("{layers} layers"), expected)?;
        let (input, output) = (self.widths[0], self.widths[self.widths.len() - 1]);
        count("widths", input, 1..=limits::MLP_INPUT)?;
        let inputs = self.pose_len() + self.expression;
        let expected = format!("{inputs}, three a joint of `inputs` and the expression's length");
        ensure(input == inputs, "widths", format_args!("{input} inputs"), expected)?;
        for &hidden in &self.widths[1..self.widths.len() - 1] {
            count("widths", hidden, 4..=limits::MLP_WIDTH)?;
            ensure(hidden.is_multiple_of(4), "widths", hidden, "multiples of 4 in the hidden layers")?;
        }
        let good = output == self.basis || output == 2 * self.basis;
        ensure(good, "widths", format_args!("{output} outputs"), format_args!("{0} or twice {0}, as `basis` says", self.basis))?;
        count("pose_components", self.pose_components.unwrap_or(0), 0..=limits::SUBSPACE.min(self.pose_len()))?;
        count("expression_components", self.expression_components.unwrap_or(0), 0..=limits::SUBSPACE.min(self.expression))
    }
}

impl Document for AvatarHeader {
    type Model = Avatar;
    const FORMAT: &'static str = AVATAR_FORMAT;
    const VERSIONS: [u64; 2] = [VERSION, VERSION_PACKED];
    const TENSORS: &'static [Tensor<Self, Avatar>] = AVATAR;

    fn of(avatar: &Avatar) -> Self {
        let layers = &avatar.networks.layers;
        let bounds = avatar.gaussians.bounds;
        let components = |space: &Option<Subspace>| space.as_ref().map(|space| space.sigma.len());
        let coded: Vec<Coded> = coding::matrices(avatar).collect();
        Self {
            format: AVATAR_FORMAT.into(),
            version: if coded.is_empty() { VERSION } else { VERSION_PACKED },
            name: avatar.name.clone(),
            credit: avatar.credit.clone(),
            units: UNITS.into(),
            up: UP.into(),
            color_space: COLOR_SPACE.into(),
            gaussians: avatar.gaussians.len(),
            parts: avatar.parts.start.len().saturating_sub(1),
            head_parts: avatar.parts.head,
            nodes: avatar.nodes.len(),
            basis: avatar.basis_len(),
            rotation_rows: avatar.rotation_rows.gaussian.len(),
            scale_rows: avatar.scale_rows.gaussian.len(),
            color_rows: avatar.color_rows.gaussian.len(),
            bounds: [bounds.min, bounds.max],
            activation: avatar.networks.activation,
            widths: layers.iter().take(1).map(|layer| layer.input).chain(layers.iter().map(|layer| layer.output)).collect(),
            joints: avatar.skeleton.name.clone(),
            parents: avatar.skeleton.parent.clone(),
            inputs: avatar.inputs.joint.clone(),
            expression: avatar.inputs.expression,
            pose_components: components(&avatar.inputs.pose_space),
            expression_components: components(&avatar.inputs.expression_space),
            coded,
            log_scales: None,
            deflated: BTreeMap::new(),
        }
    }

    fn deflated(&self) -> Option<&BTreeMap<String, Order>> {
        Some(&self.deflated)
    }

    fn set_deflated(&mut self, deflated: BTreeMap<String, Order>) {
        (self.version, self.deflated) = (VERSION_PACKED, deflated);
    }

    fn check(&self) -> Result<(), Fault> {
        word("units", &self.units, UNITS)?;
        word("up", &self.up, UP)?;
        word("color_space", &self.color_space, COLOR_SPACE)?;
        self.check_codes()?;
        self.check_counts()?;
        self.check_skeleton()?;
        self.check_networks()
    }

    fn build(self, tensors: &Container) -> Avatar {
        let bytes = |what| self.coded.contains(&what);
        Avatar {
            skeleton: self.skeleton(tensors),
            gaussians: self.gaussians(tensors),
            parts: Parts { start: tensors.take("part_start"), head: self.head_parts },
            networks: self.networks(tensors),
            rotation_rows: rows("rotation", bytes(Coded::RotationBasis), tensors),
            scale_rows: rows("scale", bytes(Coded::ScaleBasis), tensors),
            color_rows: rows("color", bytes(Coded::ColorBasis), tensors),
            nodes: Nodes {
                position: tensors.take("node.position"),
                part: tensors.take("node.part"),
                offset: tensors.take("node.offset"),
                basis: basis("node", bytes(Coded::NodeBasis), tensors),
            },
            inputs: self.inputs(tensors),
            harmonics: None,
            name: self.name,
            credit: self.credit,
        }
    }
}

impl Document for ClipHeader {
    type Model = Clip;
    const FORMAT: &'static str = MOTION_FORMAT;
    const VERSIONS: [u64; 2] = [VERSION; 2];
    const TENSORS: &'static [Tensor<Self, Clip>] = MOTION;

    fn of(clip: &Clip) -> Self {
        Self {
            format: MOTION_FORMAT.into(),
            version: VERSION,
            name: clip.name.clone(),
            credit: clip.credit.clone(),
            units: UNITS.into(),
            up: UP.into(),
            rate: clip.rate,
            frames: clip.frames(),
            joints: clip.joint.clone(),
            expression: clip.expression_len,
        }
    }

    fn check(&self) -> Result<(), Fault> {
        word("units", &self.units, UNITS)?;
        word("up", &self.up, UP)?;
        ensure((1e-3..=1e5).contains(&self.rate), "rate", self.rate, "0.001 to 100000 frames a second")?;
        ensure(self.frames >= 1, "frames", self.frames, "at least 1")?;
        count("expression", self.expression, 0..=limits::EXPRESSION)?;
        joints(&self.joints)
    }

    fn build(self, tensors: &Container) -> Clip {
        Clip {
            rotation: tensors.take("rotation"),
            translation: tensors.take("translation"),
            expression: tensors.take("expression"),
            name: self.name,
            credit: self.credit,
            rate: self.rate,
            joint: self.joints,
            expression_len: self.expression,
        }
    }
}
