//! What a renderer refuses before it asks anything of the device: options, poses and cameras that can't be drawn go in, an error that
//! says what was found comes out.

use super::{ALPHA_MIN, Camera, Extent, Posed, RendererOptions, Unusable};

/// Avatars that a renderer may be made for: their Gaussians are then fewer than a sort takes.
const ACTORS: usize = 256;

fn unusable(what: &str, found: impl ToString, expected: impl ToString) -> Unusable {
    Unusable { what: what.into(), found: found.to_string(), expected: expected.to_string() }
}

impl RendererOptions {
    /// Whether the numbers are ones that a renderer can be made with; the picture's size is the device's to judge.
    pub fn check(&self) -> Result<(), Unusable> {
        if !(ALPHA_MIN..=1.0).contains(&self.cutoff) {
            return Err(unusable("the opacity cutoff", self.cutoff, "a number from 1/255 to 1"));
        }
        if !(1..=ACTORS).contains(&self.actors) {
            return Err(unusable("the number of avatars in a scene", self.actors, format!("a number from 1 to {ACTORS}")));
        }
        if !(self.margin >= 0.0 && self.margin.is_finite()) {
            return Err(unusable("the margin behind the depth surface", self.margin, "a number from 0 up"));
        }
        Ok(())
    }
}

/// Whether a frame can be drawn of these poses of the avatar whose extent this is.
pub fn frame(poses: &[&Posed], camera: &Camera, extent: &Extent, options: &RendererOptions) -> Result<(), Unusable> {
    camera.check()?;
    if camera.size != options.size {
        let [found, expected] = [camera.size, options.size].map(|[width, height]| format!("{width} × {height} px"));
        return Err(unusable("the camera's picture", found, format!("{expected}, the renderer's")));
    }
    if poses.len() > options.actors {
        return Err(unusable("the number of avatars", poses.len(), format!("at most {}, as the renderer was made for", options.actors)));
    }
    poses.iter().try_for_each(|posed| pose(posed, extent))
}

fn pose(posed: &Posed, extent: &Extent) -> Result<(), Unusable> {
    posed.check()?;
    let shape = |[joints, inputs, expression]: [usize; 3]| format!("{joints} joints and {inputs} inputs, {expression} of them expression");
    let found = [posed.joints.len(), posed.input.len(), posed.expression];
    if found != extent.pose_shape() {
        return Err(unusable("the pose", shape(found), format!("{}, as the avatar has them", shape(extent.pose_shape()))));
    }
    Ok(())
}
