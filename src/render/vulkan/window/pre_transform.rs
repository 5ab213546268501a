//! Pre-rotation: how the rendered image is turned for a display that is mounted another way round
//! than the window is seen. Phones show it at no cost when the app draws it turned, and copy every
//! frame when it does not.

use ash::vk;
use glam::{Mat2, Vec2};

/// By how many quarter turns, clockwise, the rendered image is turned into the window's images.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PreTransform(u32);

impl PreTransform {
    /// The pre-transform for a surface's current transform. None for mirrored ones, which no phone
    /// has.
    pub fn asked(transform: vk::SurfaceTransformFlagsKHR) -> Option<Self> {
        use vk::SurfaceTransformFlagsKHR as Transform;
        let known = [
            Transform::IDENTITY,
            Transform::ROTATE_90,
            Transform::ROTATE_180,
            Transform::ROTATE_270,
        ];
        known
            .iter()
            .position(|&known| known == transform)
            .map(|quarters| Self(quarters as u32))
    }

    /// The size of the window's images for a rendered image of this size, or the reverse: a quarter
    /// turn swaps the sides.
    pub fn extent(self, [width, height]: [u32; 2]) -> [u32; 2] {
        if self.0 % 2 == 1 {
            [height, width]
        } else {
            [width, height]
        }
    }

    /// Where a point of a rendered image of this size lies in the window's images, in the same
    /// unit.
    pub fn place(self, point: Vec2, size: Vec2) -> Vec2 {
        match self.0 {
            0 => point,
            1 => Vec2::new(size.y - point.y, point.x),
            2 => size - point,
            _ => Vec2::new(point.y, size.x - point.x),
        }
    }

    /// From the window's images to a rendered image of this size, px: multiply a point by the
    /// matrix, then add the vector.
    pub fn back(self, [width, height]: [u32; 2]) -> (Mat2, Vec2) {
        let w = width as f32;
        let h = height as f32;
        match self.0 {
            0 => (Mat2::IDENTITY, Vec2::ZERO),
            1 => (
                Mat2::from_cols(Vec2::new(0.0, -1.0), Vec2::new(1.0, 0.0)),
                Vec2::new(0.0, h),
            ),
            2 => (-Mat2::IDENTITY, Vec2::new(w, h)),
            _ => (
                Mat2::from_cols(Vec2::new(0.0, 1.0), Vec2::new(-1.0, 0.0)),
                Vec2::new(w, 0.0),
            ),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use vk::SurfaceTransformFlagsKHR as Transform;

    const TRANSFORMS: [Transform; 4] = [
        Transform::IDENTITY,
        Transform::ROTATE_90,
        Transform::ROTATE_180,
        Transform::ROTATE_270,
    ];

    #[test]
    fn a_quarter_takes_the_upper_left_corner_to_the_upper_right() {
        let size = Vec2::new(300.0, 200.0);
        let corners: Vec<_> = TRANSFORMS
            .iter()
            .map(|&flag| {
                PreTransform::asked(flag)
                    .unwrap_or_default()
                    .place(Vec2::ZERO, size)
            })
            .collect();
        assert_eq!(
            corners,
            [
                Vec2::ZERO,
                Vec2::new(200.0, 0.0),
                Vec2::new(300.0, 200.0),
                Vec2::new(0.0, 300.0)
            ]
        );
        assert_eq!(PreTransform::asked(Transform::HORIZONTAL_MIRROR), None);
    }

    #[test]
    fn back_inverts_place_for_every_pixel() {
        let size = [5, 3];
        for pre_transform in TRANSFORMS.map(|flag| PreTransform::asked(flag).unwrap_or_default()) {
            let [width, height] = pre_transform.extent(size);
            let (matrix, origin) = pre_transform.back(size);
            let mut seen = vec![0; 15];
            for (x, y) in (0..height).flat_map(|y| (0..width).map(move |x| (x, y))) {
                let point = Vec2::new(x as f32 + 0.5, y as f32 + 0.5);
                let from = matrix * point + origin;
                assert_eq!(
                    pre_transform.place(from, Vec2::new(5.0, 3.0)),
                    point,
                    "{pre_transform:?}"
                );
                seen[(from.y.floor() * 5.0 + from.x.floor()) as usize] += 1;
            }
            assert_eq!(seen, [1; 15], "{pre_transform:?}");
        }
    }
}
