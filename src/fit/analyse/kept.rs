//! Which Gaussians keep their correctives, as a picture: green where they do, grey where they don't; rotation, scale and colour
//! side by side.

use crate::avatar::{Avatar, Pose};
use crate::fit::evaluate::{Way, camera};
use crate::frame::{Extent, Picture, Posed};
use crate::reference;
use half::f16;

/// Three pictures, each of `size`, in one.
pub fn picture(avatar: &Avatar, pose: &Pose, yaw: f64, size: [u32; 2]) -> Picture {
    let plain = Way::Neutral.avatar(avatar);
    let posed = Posed::new(&plain, pose);
    let camera = camera(&Extent::new(&plain), &posed, yaw, size);
    let lists = [&avatar.rotation_rows.gaussian, &avatar.scale_rows.gaussian, &avatar.color_rows.gaussian];
    let pictures = lists.map(|kept| {
        let mut marked = plain.clone();
        for (k, color) in marked.gaussians.color.iter_mut().enumerate() {
            let light = 0.25 + 0.6 * color.iter().map(|c| c.to_f64()).sum::<f64>() / 3.0;
            let tint = if kept.binary_search(&(k as u32)).is_ok() { [0.25, 1.0, 0.35] } else { [0.75; 3] };
            *color = tint.map(|t| f16::from_f64(t * light));
        }
        reference::render(&marked, &posed, &camera)
    });
    beside(&pictures)
}

/// Pictures of one size in a row.
///
/// # Panics
/// When their sizes differ.
pub fn beside(pictures: &[Picture]) -> Picture {
    let [width, height] = pictures.first().map_or([0, 0], |picture| picture.size);
    assert!(pictures.iter().all(|picture| picture.size == [width, height]), "pictures of different sizes don't stand in a row");
    let row = |y: u32| pictures.iter().flat_map(move |p| p.pixels[(y * width) as usize..][..width as usize].iter().copied());
    Picture { size: [width * pictures.len() as u32, height], pixels: (0..height).flat_map(row).collect() }
}
