//! Rules for the numbers of splats.

use super::Splats;
use crate::{avatar::limits, io::file::FormatError};
use glam::Vec3;
use std::fmt;

/// A rule that a splat breaks.
#[derive(Clone, Copy, Debug)]
enum SplatFault {
    NotFinite { what: &'static str, value: f32 },
    Far(Vec3),
    NoRotation,
}

/// The value that breaks it.
impl fmt::Display for SplatFault {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::NotFinite { what, value } => write!(f, "{value} in the {what}"),
            Self::Far(position) => write!(f, "the position {position}"),
            Self::NoRotation => f.write_str("a quaternion of length 0"),
        }
    }
}

impl SplatFault {
    fn expected(self) -> String {
        match self {
            Self::NotFinite { .. } => "finite numbers".into(),
            Self::Far(_) => format!(
                "at most {} metres along each axis: scale the scene down",
                limits::LENGTH
            ),
            Self::NoRotation => "any other length".into(),
        }
    }
}

/// Splats that were left out.
pub struct SplatsLeftOut {
    /// How many.
    pub count: usize,
    /// Index of the first of them.
    pub first: usize,
    /// The fault of the first.
    pub why: String,
}

impl Splats {
    /// Checks lengths and numbers.
    ///
    /// # Errors
    /// When there are no Gaussians or more than [`limits::GAUSSIANS`], columns differ in length, a
    /// number is not finite where it must be, or a position is further than [`limits::LENGTH`] out.
    pub fn check(&self) -> Result<(), FormatError> {
        self.check_lengths()?;
        let fault = |k: usize| Some((k, self.fault(k)?));
        match (0..self.len()).find_map(fault) {
            None => Ok(()),
            Some((k, fault)) => Err(FormatError::container(
                format!("{fault} of vertex {k}"),
                fault.expected(),
            )),
        }
    }

    /// Removes the splats that break a rule of [`Self::check`]. None: each keeps them.
    ///
    /// # Errors
    /// When none is left, there are too many, or columns differ in length.
    pub fn leave_out_bad(&mut self) -> Result<Option<SplatsLeftOut>, FormatError> {
        self.check_lengths()?;
        let count = self.len();
        let good: Vec<bool> = (0..count).map(|k| self.fault(k).is_none()).collect();
        let first = good.iter().position(|good| !good);
        let Some((first, fault)) = first.and_then(|k| Some((k, self.fault(k)?))) else {
            return Ok(None);
        };
        let bad = good.iter().filter(|good| !**good).count();
        if bad == count {
            return Err(FormatError::container(
                format!("{fault} of vertex {first}, and none of {count} that can be drawn"),
                fault.expected(),
            ));
        }
        let width = super::functions_of(self.degree);
        keep(&mut self.position, &good, 1);
        keep(&mut self.rotation, &good, 1);
        keep(&mut self.log_scale, &good, 1);
        keep(&mut self.opacity, &good, 1);
        keep(&mut self.color, &good, 1);
        keep(&mut self.harmonics, &good, width);
        Ok(Some(SplatsLeftOut {
            count: bad,
            first,
            why: fault.to_string(),
        }))
    }

    fn check_lengths(&self) -> Result<(), FormatError> {
        let count = self.len();
        check_count(count as u64)?;
        let lengths = [
            self.rotation.len(),
            self.log_scale.len(),
            self.opacity.len(),
            self.color.len(),
        ];
        let harmonics = super::functions_of(self.degree) * count;
        if lengths != [count; 4] || self.harmonics.len() != harmonics || self.degree > 3 {
            return Err(FormatError::container(
                format!(
                    "columns of {lengths:?} numbers and {} harmonics of degree {}",
                    self.harmonics.len(),
                    self.degree
                ),
                format!("{count} Gaussians in each, of degree 0 to 3"),
            ));
        }
        Ok(())
    }

    /// The first rule that a splat breaks.
    fn fault(&self, k: usize) -> Option<SplatFault> {
        let position = Vec3::from(self.position[k]);
        let far = || {
            let is_far = f64::from(position.abs().max_element()) > limits::LENGTH;
            is_far.then_some(SplatFault::Far(position))
        };
        let no_rotation = || {
            let is_none = self.rotation[k].iter().all(|v| *v == 0.0);
            is_none.then_some(SplatFault::NoRotation)
        };
        // A deviation of 0 and an opacity of exactly 0 or 1 are infinite.
        let shape = || {
            let scales = self.log_scale[k].iter();
            let scale = scales.copied().find(|s| s.is_nan() || *s == f32::INFINITY);
            let opacity = Some(self.opacity[k]).filter(|opacity| opacity.is_nan());
            let fault = |what, value| SplatFault::NotFinite { what, value };
            let scale = scale.map(|value| fault("scale", value));
            scale.or(opacity.map(|value| fault("opacity", value)))
        };
        let functions = super::functions_of(self.degree);
        let harmonics = self.harmonics[functions * k..][..functions].as_flattened();
        not_finite(&self.position[k], "position")
            .or_else(far)
            .or_else(|| not_finite(&self.rotation[k], "rotation"))
            .or_else(no_rotation)
            .or_else(|| not_finite(&self.color[k], "colour"))
            .or_else(shape)
            .or_else(|| not_finite(harmonics, "harmonics"))
    }
}

/// Keeps the good of rows that have `width` entries each.
fn keep<T>(entries: &mut Vec<T>, good: &[bool], width: usize) {
    let mut at = 0;
    entries.retain(|_| {
        at += 1;
        good[(at - 1) / width]
    });
}

/// Checks a number of Gaussians.
///
/// # Errors
/// When there are no splats, or more than [`limits::GAUSSIANS`].
pub fn check_count(count: u64) -> Result<(), FormatError> {
    if count == 0 || count > limits::GAUSSIANS as u64 {
        return Err(FormatError::container(
            format!("{count} Gaussians"),
            format!("1 to {}", limits::GAUSSIANS),
        ));
    }
    Ok(())
}

/// The first NaN or infinity. `what`: the numbers' name in errors.
fn not_finite(values: &[f32], what: &'static str) -> Option<SplatFault> {
    let bad = values.iter().find(|value| !value.is_finite());
    bad.map(|&value| SplatFault::NotFinite { what, value })
}
