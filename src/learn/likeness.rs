//! What avatars are compared by: a camera that has all of them in its image, and what they are without
//! correctives.

use effigy_core::avatar::{Avatar, Rows};
use effigy_core::scene::{AvatarBounds, Camera, Orbit, Posed};
use half::f16;

/// Vertical field of view, degrees.
const FOV: f64 = 35.0;

/// A camera that has all of a posed avatar in its image. `yaw`: degrees around the avatar; `pitch`:
/// radians above the horizon.
pub fn camera_at(
    bounds: &AvatarBounds,
    posed: &Posed,
    yaw: f64,
    pitch: f64,
    size: [u32; 2],
) -> Camera {
    let orbit = Orbit {
        yaw: yaw.to_radians(),
        pitch,
        fov: FOV.to_radians(),
    };
    Camera::around(bounds.framing(&posed.joints), orbit, size)
}

/// An avatar of neutral attributes, whatever the pose.
pub fn neutral(avatar: &Avatar) -> Avatar {
    let mut avatar = avatar.clone();
    avatar.rotation_rows = Rows::default();
    avatar.scale_rows = Rows::default();
    avatar.color_rows = Rows::default();
    avatar.nodes.basis.halves_mut().fill(f16::ZERO);
    avatar
}
