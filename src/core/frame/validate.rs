//! Validation before anything reaches the device: options, poses and cameras that can't be drawn
//! are rejected.

use super::{RendererOptions, Unusable, people::PlannedPerson};
use crate::{
    avatar::Filter,
    constants::ALPHA_MIN,
    scene::{Camera, PoseShape, Posed},
};

/// Maximum number of avatars in a scene.
const MAX_INSTANCES: usize = 1024;

fn unusable(what: &str, found: impl ToString, expected: impl ToString) -> Unusable {
    Unusable {
        what: what.into(),
        found: found.to_string(),
        expected: expected.to_string(),
    }
}

impl RendererOptions {
    /// Checks every number except the image's size, which depends on the device's limits.
    ///
    /// # Errors
    /// When a number is out of range.
    pub fn check(&self) -> Result<(), Unusable> {
        if !(ALPHA_MIN..=1.0).contains(&self.cutoff) {
            return Err(unusable(
                "the opacity cutoff",
                self.cutoff,
                "a number from 1/255 to 1",
            ));
        }
        if !(1..=MAX_INSTANCES).contains(&self.instances) {
            return Err(unusable(
                "the number of avatars in a scene",
                self.instances,
                format!("a number from 1 to {MAX_INSTANCES}"),
            ));
        }
        if let Some(filter) = self.filter
            && !filter.is_valid()
        {
            let [least, most] = [Filter::VARIANCES.start(), Filter::VARIANCES.end()];
            return Err(unusable(
                "the low-pass filter",
                format!("a variance of {} px²", filter.variance),
                format!("one from {least} to {most} px²"),
            ));
        }
        Ok(())
    }
}

/// Checks that a frame can be drawn: people, seen by `camera`, by a renderer with these options.
///
/// # Errors
/// When a number can't be drawn, the camera's image has another size than the renderer's, a pose
/// has another shape than the avatar, or there are more people than [`RendererOptions::instances`].
pub fn frame(
    people: &[PlannedPerson],
    camera: &Camera,
    options: &RendererOptions,
) -> Result<(), Unusable> {
    camera.check()?;
    if camera.size != options.size {
        let pixels = |[width, height]: [u32; 2]| format!("{width} × {height} px");
        return Err(unusable(
            "the camera's image",
            pixels(camera.size),
            format!("{}, the renderer's", pixels(options.size)),
        ));
    }
    if people.len() > options.instances {
        return Err(unusable(
            "the number of avatars",
            people.len(),
            format!(
                "at most {}, as the renderer was made for",
                options.instances
            ),
        ));
    }
    for person in people {
        person.posed.check()?;
        check_shape(person.posed, person.traits.bounds.pose_shape())?;
    }
    Ok(())
}

fn check_shape(posed: &Posed, expected: PoseShape) -> Result<(), Unusable> {
    let found = PoseShape {
        joints: posed.joints.len(),
        inputs: posed.input.len(),
        expression: posed.expression,
    };
    if found == expected {
        return Ok(());
    }
    let text = |shape: PoseShape| {
        format!(
            "{} joints and {} inputs, {} of them expression",
            shape.joints, shape.inputs, shape.expression
        )
    };
    Err(unusable(
        "the pose",
        text(found),
        format!("{}, as the avatar has them", text(expected)),
    ))
}
