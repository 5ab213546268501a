//! The rules that documents keep, and how models become documents and documents models.

use super::arrays::{basis, rows};
use super::coding::{self, Coded, HarmonicCodes, LogScaleCodes};
use super::deflate::ByteArrangement;
use super::document::{HeaderDocument, TensorRow};
use super::error::{FormatError, excerpt};
use super::format::{
    AVATAR, AVATAR_FORMAT, MOTION, MOTION_FORMAT, VERSION, VERSION_FACING, VERSION_FILTER,
    VERSION_PACKED, VERSION_SPLATS,
};
use super::header::{AvatarHeader, ClipHeader, HarmonicsHeader, LevelHeader};
use super::sets::{self, SetArrays};
use super::tensors::Tensors;
use crate::avatar::{Avatar, Clip, Filter, Level, LevelError, Nodes, Parts, Subspace, limits};
use std::collections::{BTreeMap, HashSet};
use std::fmt::Display;
use std::ops::RangeInclusive;

const UNITS: &str = "metre";
const UP: &str = "y";
const COLOR_SPACE: &str = "srgb";

/// Checks that a number is in a range.
fn count(field: &str, found: usize, range: RangeInclusive<usize>) -> Result<(), FormatError> {
    if range.contains(&found) {
        return Ok(());
    }
    let expected = format!("{} to {}", range.start(), range.end());
    Err(FormatError::metadata(field, found, expected))
}

/// An error about a field, unless `good`.
fn ensure(
    good: bool,
    field: &str,
    found: impl Display,
    expected: impl Display,
) -> Result<(), FormatError> {
    if good {
        Ok(())
    } else {
        Err(FormatError::metadata(field, found, expected))
    }
}

/// Checks a fixed word of the format.
fn word(field: &str, found: &str, expected: &str) -> Result<(), FormatError> {
    ensure(
        found == expected,
        field,
        format_args!("{:?}", excerpt(found)),
        format_args!("{expected:?}"),
    )
}

/// Checks that there is a joint, that there are not too many, and that no two have one name.
fn joints(names: &[String]) -> Result<(), FormatError> {
    let good = (1..=limits::JOINTS).contains(&names.len());
    ensure(
        good,
        "joints",
        format_args!("{} names", names.len()),
        format_args!("1 to {}", limits::JOINTS),
    )?;
    let mut earlier = HashSet::new();
    for name in names {
        if !earlier.insert(name.as_str()) {
            return Err(FormatError::metadata(
                "joints",
                format_args!("{:?} twice", excerpt(name)),
                "names that differ",
            ));
        }
    }
    Ok(())
}

fn check_log_scales(field: &str, codes: Option<LogScaleCodes>) -> Result<(), FormatError> {
    let Some(LogScaleCodes { min, step, bits }) = codes else {
        return Ok(());
    };
    let [[low, high], [finest, coarsest]] = LogScaleCodes::RANGE;
    let good = (low..=high).contains(&min)
        && (finest..=coarsest).contains(&step)
        && [8, 16].contains(&bits);
    ensure(
        good,
        field,
        format_args!("min {min:e}, step {step:e}, {bits} bits"),
        format_args!(
            "a min from {low} to {high}, a step from {finest} to {coarsest}, 8 or 16 bits"
        ),
    )
}

impl AvatarHeader {
    /// The document of an avatar stored in the fewest bits that hold it exactly.
    pub fn packed(avatar: &Avatar) -> Self {
        let mut packed = Self::from_model(avatar);
        packed.version = packed.version.max(VERSION_PACKED);
        packed.coded = coding::exact_codes(avatar);
        if let Some(harmonics) = &mut packed.harmonics {
            harmonics.codes = coding::exact_harmonics(avatar);
            if harmonics.codes.is_some() {
                packed.coded.retain(|&what| what != Coded::Color);
            }
        }
        if let Some(all) = coding::exact_log_scales(avatar) {
            let mut all = all.into_iter();
            packed.log_scales = all.next();
            for (level, codes) in packed.levels.iter_mut().zip(all) {
                level.log_scales = Some(codes);
            }
        }
        packed
    }

    fn check_filter(&self) -> Result<(), FormatError> {
        let Some(filter) = self.filter else {
            return Ok(());
        };
        ensure(
            self.version >= VERSION_FILTER,
            "version",
            self.version,
            format_args!("{VERSION_FILTER} or more, as there is a filter"),
        )?;
        let [least, most] = [Filter::VARIANCES.start(), Filter::VARIANCES.end()];
        ensure(
            filter.is_valid(),
            "filter",
            format_args!("a variance of {} px²", filter.variance),
            format_args!("one from {least} to {most} px²"),
        )
    }

    fn check_harmonics(&self) -> Result<(), FormatError> {
        let Some(HarmonicsHeader { degree, codes }) = self.harmonics else {
            return Ok(());
        };
        ensure(
            self.version >= VERSION_SPLATS,
            "version",
            self.version,
            format_args!("{VERSION_SPLATS} or more, as there are harmonics"),
        )?;
        count("harmonics", degree, 1..=limits::HARMONICS)?;
        let Some(HarmonicCodes { step }) = codes else {
            return Ok(());
        };
        let [finest, coarsest] = HarmonicCodes::RANGE;
        ensure(
            (finest..=coarsest).contains(&step),
            "harmonics",
            format_args!("a step of {step:e}"),
            format_args!("one from {finest} to {coarsest}"),
        )?;
        ensure(
            !self.coded.contains(&Coded::Color),
            "coded",
            "color",
            "codes of `harmonics` alone",
        )
    }

    fn check_codes(&self) -> Result<(), FormatError> {
        let plain = self.coded.is_empty() && self.log_scales.is_none() && self.deflated.is_empty();
        ensure(
            plain || self.version >= VERSION_PACKED,
            "version",
            self.version,
            format_args!("{VERSION_PACKED} or more, as there are codes"),
        )?;
        check_log_scales("log_scales", self.log_scales)
    }

    fn check_counts(&self) -> Result<(), FormatError> {
        count("gaussians", self.gaussians, 1..=limits::GAUSSIANS)?;
        count("parts", self.parts, 1..=limits::PARTS)?;
        count("head_parts", self.head_parts, 0..=self.parts)?;
        count("nodes", self.nodes, 1..=limits::NODES)?;
        count("rotation_rows", self.rotation_rows, 0..=self.gaussians)?;
        count("scale_rows", self.scale_rows, 0..=self.gaussians)?;
        count("color_rows", self.color_rows, 0..=self.gaussians)?;
        let [min, max] = self.bounds;
        let good = (0..3).all(|k| {
            min[k] <= max[k]
                && f64::from(min[k]) >= -limits::LENGTH
                && f64::from(max[k]) <= limits::LENGTH
        });
        let expected = format!(
            "a lower and an upper corner within ±{} metres",
            limits::LENGTH
        );
        ensure(good, "bounds", format_args!("{min:?} to {max:?}"), expected)
    }

    fn check_levels(&self) -> Result<(), FormatError> {
        count("levels", self.levels.len(), 0..=limits::LEVELS)?;
        let mut before = self.gaussians;
        for (index, level) in self.levels.iter().enumerate() {
            level
                .check_after(before, self.log_scales)
                .map_err(|error| error.within(&sets::prefix(index + 1)))?;
            before = level.gaussians;
        }
        Ok(())
    }

    fn check_basis(&self) -> Result<(), FormatError> {
        count("basis", self.basis, 4..=limits::BASIS)?;
        ensure(
            self.basis.is_multiple_of(4),
            "basis",
            self.basis,
            "a multiple of 4",
        )
    }

    /// Checks what drawing relies on.
    pub fn check_drawn(&self) -> Result<(), FormatError> {
        self.check_filter()?;
        self.check_harmonics()?;
        ensure(
            !self.facing || self.version >= VERSION_FACING,
            "version",
            self.version,
            format_args!("{VERSION_FACING}, as there is a facing"),
        )?;
        self.check_counts()?;
        self.check_levels()?;
        self.check_skeleton()?;
        self.check_inputs()?;
        if self.version >= VERSION_SPLATS && self.is_without_networks() {
            return self.check_without_networks();
        }
        self.check_basis()?;
        self.check_networks()
    }

    /// Checks that nothing is there that networks would move.
    fn check_without_networks(&self) -> Result<(), FormatError> {
        count("rotation_rows", self.rotation_rows, 0..=0)?;
        count("scale_rows", self.scale_rows, 0..=0)?;
        count("color_rows", self.color_rows, 0..=0)?;
        for (index, level) in self.levels.iter().enumerate() {
            ensure(
                !level.correctives,
                "correctives",
                level.correctives,
                "false, as there are no networks",
            )
            .map_err(|error| error.within(&sets::prefix(index + 1)))?;
        }
        Ok(())
    }

    fn check_skeleton(&self) -> Result<(), FormatError> {
        joints(&self.joints)?;
        let n = self.joints.len();
        ensure(
            self.parents.len() == n,
            "parents",
            format_args!("{} entries", self.parents.len()),
            format_args!("{n}, one a joint"),
        )?;
        for (j, parent) in self.parents.iter().enumerate() {
            let (good, expected) = match parent {
                None => (j == 0, "a parent for every joint but joint 0"),
                Some(parent) => (
                    usize::from(*parent) < j,
                    "a parent that stands before its child, and null for joint 0",
                ),
            };
            let found = parent.map_or("null".to_owned(), |parent| parent.to_string());
            ensure(
                good,
                "parents",
                format_args!("{found} for joint {j}"),
                expected,
            )?;
        }
        match self.inputs.iter().find(|&&input| usize::from(input) >= n) {
            Some(input) => Err(FormatError::metadata(
                "inputs",
                format_args!("joint {input}"),
                format_args!("joints below {n}"),
            )),
            None => Ok(()),
        }
    }

    fn check_inputs(&self) -> Result<(), FormatError> {
        count("expression", self.expression, 0..=limits::EXPRESSION)?;
        count(
            "pose_components",
            self.pose_components.unwrap_or(0),
            0..=limits::SUBSPACE.min(self.pose_len()),
        )?;
        count(
            "expression_components",
            self.expression_components.unwrap_or(0),
            0..=limits::SUBSPACE.min(self.expression),
        )
    }

    fn check_networks(&self) -> Result<(), FormatError> {
        let layers = self.widths.len().saturating_sub(1);
        let expected = format!("1 to {}: one width more than layers", limits::MLP_LAYERS);
        ensure(
            (1..=limits::MLP_LAYERS).contains(&layers),
            "widths",
            format_args!("{layers} layers"),
            expected,
        )?;
        let input = self.widths[0];
        let output = self.widths[self.widths.len() - 1];
        count("widths", input, 1..=limits::MLP_INPUT)?;
        let inputs = self.pose_len() + self.expression;
        let expected = format!("{inputs}, three a joint of `inputs` and the expression's length");
        ensure(
            input == inputs,
            "widths",
            format_args!("{input} inputs"),
            expected,
        )?;
        for &hidden in &self.widths[1..self.widths.len() - 1] {
            count("widths", hidden, 4..=limits::MLP_WIDTH)?;
            ensure(
                hidden.is_multiple_of(4),
                "widths",
                hidden,
                "multiples of 4 in the hidden layers",
            )?;
        }
        let good = output == self.basis || output == 2 * self.basis;
        ensure(
            good,
            "widths",
            format_args!("{output} outputs"),
            format_args!("{0} or twice {0}, as `basis` says", self.basis),
        )
    }
}

impl LevelHeader {
    fn from_level(level: &Level) -> Self {
        Self {
            gaussians: level.gaussians.len(),
            correctives: level.correctives,
            rotation_rows: level.rotation_rows.gaussian.len(),
            scale_rows: level.scale_rows.gaussian.len(),
            color_rows: level.color_rows.gaussian.len(),
            log_scales: None,
            measured: level.measured.clone(),
        }
    }

    /// `before`: Gaussians of what is finer; `log_scales`: the avatar's own encoding.
    fn check_after(
        &self,
        before: usize,
        log_scales: Option<LogScaleCodes>,
    ) -> Result<(), FormatError> {
        count("gaussians", self.gaussians, 1..=before.saturating_sub(1))?;
        let rows = if self.correctives { self.gaussians } else { 0 };
        count("rotation_rows", self.rotation_rows, 0..=rows)?;
        count("scale_rows", self.scale_rows, 0..=rows)?;
        count("color_rows", self.color_rows, 0..=rows)?;
        let bits = |codes: Option<LogScaleCodes>| codes.map_or(0, |codes| codes.bits);
        ensure(
            bits(self.log_scales) == bits(log_scales),
            "log_scales",
            format_args!("{} bits", bits(self.log_scales)),
            format_args!("{}, as the avatar has", bits(log_scales)),
        )?;
        check_log_scales("log_scales", self.log_scales)?;
        check_measured(&self.measured)
    }
}

/// Checks the errors of a level: numbers in range, rising sizes.
fn check_measured(measured: &[LevelError]) -> Result<(), FormatError> {
    for error in measured {
        let &LevelError {
            height,
            samples,
            psnr_db,
            color,
            coverage,
        } = error;
        let good = height > 0.0
            && height.is_finite()
            && (1..=limits::SAMPLES).contains(&samples)
            && [psnr_db, color, coverage].iter().all(|v| v.is_finite());
        ensure(
            good,
            "measured",
            format_args!(
                "{psnr_db} dB, {color} and {coverage} at {height} px with {samples} samples"
            ),
            format_args!(
                "finite numbers, a height above 0, 1 to {} samples",
                limits::SAMPLES
            ),
        )?;
    }
    let size = |error: &LevelError| (error.height, error.samples);
    for pair in measured.windows(2) {
        ensure(
            size(&pair[0]) < size(&pair[1]),
            "measured",
            format_args!(
                "{} px with {} samples after {} px with {}",
                pair[1].height, pair[1].samples, pair[0].height, pair[0].samples
            ),
            "rising heights, and of equal heights rising samples",
        )?;
    }
    Ok(())
}

impl HeaderDocument for AvatarHeader {
    type Model = Avatar;
    const FORMAT: &'static str = AVATAR_FORMAT;
    const VERSIONS: [u64; 2] = [VERSION, VERSION_FACING];
    const TENSORS: &'static [TensorRow<Self, Avatar>] = AVATAR;

    fn from_model(avatar: &Avatar) -> Self {
        let bounds = avatar.gaussians.bounds;
        let components = |space: &Option<Subspace>| space.as_ref().map(|space| space.sigma.len());
        let coded: Vec<Coded> = coding::matrices(avatar).collect();
        let filter = (avatar.filter != Filter::DEFAULT).then_some(avatar.filter);
        let harmonics = avatar.sh.as_ref().map(|sh| HarmonicsHeader {
            degree: sh.degree,
            codes: None,
        });
        let widths = avatar.networks.widths();
        let facing = SetArrays::all(avatar).any(|set| !set.gaussians.facing.is_empty());
        Self {
            format: AVATAR_FORMAT.into(),
            version: if facing {
                VERSION_FACING
            } else if harmonics.is_some() || widths.is_empty() {
                VERSION_SPLATS
            } else if filter.is_some() {
                VERSION_FILTER
            } else if !coded.is_empty() {
                VERSION_PACKED
            } else {
                VERSION
            },
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
            widths,
            joints: avatar.skeleton.name.clone(),
            parents: avatar.skeleton.parent.clone(),
            inputs: avatar.inputs.joint.clone(),
            expression: avatar.inputs.expression,
            pose_components: components(&avatar.inputs.pose_space),
            expression_components: components(&avatar.inputs.expression_space),
            coded,
            log_scales: None,
            deflated: BTreeMap::new(),
            filter,
            harmonics,
            facing,
            levels: avatar.levels.iter().map(LevelHeader::from_level).collect(),
        }
    }

    fn deflated(&self) -> Option<&BTreeMap<String, ByteArrangement>> {
        Some(&self.deflated)
    }

    fn set_deflated(&mut self, deflated: BTreeMap<String, ByteArrangement>) {
        self.version = self.version.max(VERSION_PACKED);
        self.deflated = deflated;
    }

    fn shorten(&mut self) {
        self.levels.clear();
    }

    fn check(&self) -> Result<(), FormatError> {
        word("units", &self.units, UNITS)?;
        word("up", &self.up, UP)?;
        word("color_space", &self.color_space, COLOR_SPACE)?;
        self.check_codes()?;
        self.check_drawn()
    }

    fn build(self, tensors: &Tensors) -> Avatar {
        let bytes = |what| self.coded.contains(&what);
        Avatar {
            skeleton: self.skeleton(tensors),
            gaussians: self.gaussians(0, tensors),
            parts: Parts {
                start: tensors.values("part_start"),
                head: self.head_parts,
            },
            networks: self.networks(tensors),
            rotation_rows: rows("rotation", bytes(Coded::RotationBasis), tensors),
            scale_rows: rows("scale", bytes(Coded::ScaleBasis), tensors),
            color_rows: rows("color", bytes(Coded::ColorBasis), tensors),
            nodes: Nodes {
                position: tensors.values("node.position"),
                part: tensors.values("node.part"),
                offset: tensors.values("node.offset"),
                basis: basis("node", bytes(Coded::NodeBasis), tensors),
            },
            inputs: self.inputs(tensors),
            sh: self.harmonics(0, tensors),
            filter: self.filter.unwrap_or_default(),
            levels: (1..self.sets())
                .map(|set| self.level(set, tensors))
                .collect(),
            name: self.name,
            credit: self.credit,
        }
    }
}

impl HeaderDocument for ClipHeader {
    type Model = Clip;
    const FORMAT: &'static str = MOTION_FORMAT;
    const VERSIONS: [u64; 2] = [VERSION; 2];
    const TENSORS: &'static [TensorRow<Self, Clip>] = MOTION;

    fn from_model(clip: &Clip) -> Self {
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

    fn check(&self) -> Result<(), FormatError> {
        word("units", &self.units, UNITS)?;
        word("up", &self.up, UP)?;
        ensure(
            (1e-3..=1e5).contains(&self.rate),
            "rate",
            self.rate,
            "0.001 to 100000 frames a second",
        )?;
        ensure(self.frames >= 1, "frames", self.frames, "at least 1")?;
        count("expression", self.expression, 0..=limits::EXPRESSION)?;
        joints(&self.joints)
    }

    fn build(self, tensors: &Tensors) -> Clip {
        Clip {
            rotation: tensors.values("rotation"),
            translation: tensors.values("translation"),
            expression: tensors.values("expression"),
            name: self.name,
            credit: self.credit,
            rate: self.rate,
            joint: self.joints,
            expression_len: self.expression,
        }
    }
}
