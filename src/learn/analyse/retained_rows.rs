//! An image of which Gaussians keep their correctives: green where they do, grey where they don't;
//! rotation, scale and colour side by side.

use crate::evaluate::{Rendition, camera_at, side_by_side};
use effigy_core::avatar::{Avatar, Pose};
use effigy_core::reference;
use effigy_core::scene::{AvatarBounds, FrameImage, Posed};
use half::f16;

/// RGB that a Gaussian's brightness is multiplied by.
const RETAINED_TINT: [f64; 3] = [0.25, 1.0, 0.35];
const PRUNED_TINT: [f64; 3] = [0.75; 3];

/// Three images of `size`, in px, side by side. `yaw`: degrees around the avatar.
pub fn image(avatar: &Avatar, pose: &Pose, yaw: f64, size: [u32; 2]) -> FrameImage {
    let plain = Rendition::Neutral.apply(avatar);
    let posed = Posed::new(&plain, pose);
    let camera = camera_at(&AvatarBounds::new(&plain), &posed, yaw, size);
    let lists = [
        &avatar.rotation_rows.gaussian,
        &avatar.scale_rows.gaussian,
        &avatar.color_rows.gaussian,
    ];
    let images = lists.map(|retained| {
        let mut marked = plain.clone();
        for (k, color) in marked.gaussians.color.iter_mut().enumerate() {
            let brightness = 0.25 + 0.6 * color.iter().map(|c| c.to_f64()).sum::<f64>() / 3.0;
            let tint = if retained.binary_search(&(k as u32)).is_ok() {
                RETAINED_TINT
            } else {
                PRUNED_TINT
            };
            *color = tint.map(|t| f16::from_f64(t * brightness));
        }
        reference::render(&marked, &posed, &camera)
    });
    side_by_side(&images)
}
