//! Rules for the numbers of splats.

use super::Splats;
use crate::{avatar::limits, io::file::FormatError};
use glam::Vec3;

impl Splats {
    /// Checks lengths and numbers.
    ///
    /// # Errors
    /// When there are no Gaussians or more than [`limits::GAUSSIANS`], columns differ in length, a
    /// number is not finite where it must be, or a position is further than [`limits::LENGTH`] out.
    pub fn check(&self) -> Result<(), FormatError> {
        let count = self.len();
        check_count(count as u64)?;
        let functions = super::functions_of(self.degree);
        let lengths = [
            self.rotation.len(),
            self.log_scale.len(),
            self.opacity.len(),
            self.color.len(),
        ];
        if lengths != [count; 4] || self.harmonics.len() != functions * count || self.degree > 3 {
            return Err(FormatError::container(
                format!(
                    "columns of {lengths:?} numbers and {} harmonics of degree {}",
                    self.harmonics.len(),
                    self.degree
                ),
                format!("{count} Gaussians in each, of degree 0 to 3"),
            ));
        }
        for vertex in 0..count {
            finite(&self.position[vertex], "position", vertex)?;
            let at = Vec3::from(self.position[vertex]);
            if f64::from(at.abs().max_element()) > limits::LENGTH {
                return Err(FormatError::container(
                    format!("the position {at} of vertex {vertex}"),
                    format!("at most {} along each axis", limits::LENGTH),
                ));
            }
            finite(&self.rotation[vertex], "rotation", vertex)?;
            let squares = self.rotation[vertex].map(|v| f64::from(v).powi(2));
            let length = squares.iter().sum::<f64>().sqrt();
            if length <= 0.0 {
                return Err(FormatError::container(
                    format!("a quaternion of length {length} at vertex {vertex}"),
                    "any other length",
                ));
            }
            finite(&self.color[vertex], "colour", vertex)?;
            // A deviation of 0 and an opacity of exactly 0 or 1 are infinite.
            let (scale, opacity) = (self.log_scale[vertex], self.opacity[vertex]);
            if opacity.is_nan() || scale.iter().any(|s| s.is_nan() || *s == f32::INFINITY) {
                return Err(FormatError::container(
                    format!("scale {scale:?} and opacity {opacity} of vertex {vertex}"),
                    "finite numbers",
                ));
            }
            for row in &self.harmonics[functions * vertex..][..functions] {
                finite(row, "harmonics", vertex)?;
            }
        }
        Ok(())
    }
}

/// Checks a number of Gaussians.
///
/// # Errors
/// When there are none, or more than [`limits::GAUSSIANS`].
pub fn check_count(count: u64) -> Result<(), FormatError> {
    if count == 0 || count > limits::GAUSSIANS as u64 {
        return Err(FormatError::container(
            format!("{count} Gaussians"),
            format!("1 to {}", limits::GAUSSIANS),
        ));
    }
    Ok(())
}

/// Refuses NaN and infinity. `what`: the numbers' name in errors.
fn finite(values: &[f32], what: &str, vertex: usize) -> Result<(), FormatError> {
    match values.iter().find(|value| !value.is_finite()) {
        None => Ok(()),
        Some(bad) => Err(FormatError::container(
            format!("{bad} in the {what} of vertex {vertex}"),
            "finite numbers",
        )),
    }
}
