//! The pinhole camera. World coordinates have y up; camera coordinates have x right, y down and z
//! forward, the convention of images and 3DGS.

use super::{Framing, PixelRect};
use glam::{DAffine3, DMat3, DVec2, DVec3};

/// A pinhole camera and the size of its image.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// World to camera, metres.
    pub view: DAffine3,
    /// Focal length along x and y, px.
    pub focal: DVec2,
    /// Where the optical axis meets the image, px from the top left corner.
    pub center: DVec2,
    /// Width and height, px, at least 1.
    pub size: [u32; 2],
    /// Gaussians whose centre is nearer than this are culled, metres.
    pub near: f64,
}

/// From which side a camera looks, and how wide.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Orbit {
    /// 0 looks at the avatar's front and grows towards its left, radians.
    pub yaw: f64,
    /// Positive looks down, radians.
    pub pitch: f64,
    /// Vertical field of view, radians.
    pub fov: f64,
}

impl Default for Orbit {
    /// The front, 3° from above, 35° wide.
    fn default() -> Self {
        Self {
            yaw: 0.0,
            pitch: 0.05,
            fov: 0.61,
        }
    }
}

impl Camera {
    /// Default distance of the near plane, metres.
    pub const NEAR: f64 = crate::constants::NEAR;

    /// Looks from `eye` at `target`, with the image's upper edge towards +y. `fov` is the vertical
    /// field of view, radians.
    pub fn look_at(eye: DVec3, target: DVec3, fov: f64, size: [u32; 2]) -> Self {
        let forward = (target - eye).try_normalize().unwrap_or(DVec3::NEG_Z);
        let right = forward.cross(DVec3::Y).try_normalize().unwrap_or(DVec3::X);
        let down = forward.cross(right);
        let rotation = DMat3::from_cols(right, down, forward).transpose();
        let [width, height] = size.map(f64::from);
        Self {
            view: DAffine3::from_mat3_translation(rotation, rotation * -eye),
            focal: DVec2::splat(0.5 * height / (0.5 * fov).tan()),
            center: DVec2::new(0.5 * width, 0.5 * height),
            size,
            near: Self::NEAR,
        }
    }

    /// Looks at `target` from a distance in metres. `yaw` 0 looks at the avatar's front and grows
    /// towards its left; a positive `pitch` looks down; `fov` is the vertical field of view.
    /// Angles are radians.
    pub fn orbit(
        target: DVec3,
        yaw: f64,
        pitch: f64,
        distance: f64,
        fov: f64,
        size: [u32; 2],
    ) -> Self {
        let direction = DVec3::new(
            yaw.sin() * pitch.cos(),
            pitch.sin(),
            yaw.cos() * pitch.cos(),
        );
        Self::look_at(target + distance * direction, target, fov, size)
    }

    /// The distance from the middle of a box at which all of it is in the image with a margin of
    /// 5 %, whatever the yaw. `bounds`: lower and upper corner, metres.
    pub fn framing_distance(bounds: [DVec3; 2], fov: f64, size: [u32; 2]) -> f64 {
        let [min, max] = bounds;
        let half = (max - min) / 2.0;
        let around = half.x.hypot(half.z);
        let slope = (0.5 * fov).tan();
        let aspect = f64::from(size[0]) / f64::from(size[1]);
        1.05 * (half.y / slope).max(around / (slope * aspect)) + around
    }

    /// Looks at the middle of a box from [`Self::framing_distance`]. `framing`: a box, or what
    /// [`AvatarBounds::framing`](super::AvatarBounds::framing) gives. `size`: of the image, px.
    pub fn around(framing: impl Into<Framing>, orbit: Orbit, size: [u32; 2]) -> Self {
        let framing = framing.into();
        let Orbit { yaw, pitch, fov } = orbit;
        let distance = Self::framing_distance(framing.bounds, fov, size);
        Self {
            near: framing.near,
            ..Self::orbit(framing.middle(), yaw, pitch, distance, fov, size)
        }
    }

    /// [`Self::framing_distance`] of a box in which people stand: head and feet are near a person's
    /// own axis, and nobody is as tall at the box's corners. So one person fills the image.
    pub fn standing_distance(bounds: [DVec3; 2], fov: f64, size: [u32; 2]) -> f64 {
        /// Radius of the cylinder around who stands, metres.
        const PERSON: f64 = 0.57;
        let half = (bounds[1] - bounds[0]) / 2.0;
        let around = half.x.hypot(half.z);
        let person = around.min(PERSON);
        let slope = (0.5 * fov).tan();
        let aspect = f64::from(size[0]) / f64::from(size[1]);
        // The ellipsoids around the nearest person and around all.
        let tall = (1.05 * half.y / slope).hypot(person) + around - person;
        let wide = (1.05 * around / (slope * aspect)).hypot(around);
        tall.max(wide)
    }

    /// Stretches the view to an image of another size.
    pub fn stretched(&self, size: [u32; 2]) -> Self {
        let ratio = DVec2::new(
            f64::from(size[0]) / f64::from(self.size[0]),
            f64::from(size[1]) / f64::from(self.size[1]),
        );
        Self {
            focal: self.focal * ratio,
            center: self.center * ratio,
            size,
            ..*self
        }
    }

    /// Position of the camera in the world, metres.
    pub fn eye(&self) -> DVec3 {
        self.view.inverse().translation
    }

    /// Projects a point in camera coordinates into the image, px.
    pub fn project(&self, p: DVec3) -> DVec2 {
        self.focal * p.truncate() / p.z + self.center
    }

    /// The point at depth 1 that is seen at a place of the image, px, in camera coordinates.
    pub fn ray(&self, at: DVec2) -> DVec3 {
        ((at - self.center) / self.focal).extend(1.0)
    }

    /// The camera whose image is a part of this one's. `rect`: that part, not empty.
    pub fn cropped(&self, rect: PixelRect) -> Self {
        Self {
            center: self.center - rect.min.as_dvec2(),
            size: (rect.max - rect.min).into(),
            ..*self
        }
    }

    /// Smallest and largest x/z and y/z that the perspective's derivative is clamped to.
    pub fn derivative_limits(&self) -> [DVec2; 2] {
        let size = DVec2::new(f64::from(self.size[0]), f64::from(self.size[1]));
        let margin = crate::constants::DERIVATIVE_MARGIN * 0.5 * size / self.focal;
        [
            -self.center / self.focal - margin,
            (size - self.center) / self.focal + margin,
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn from_the_front_the_avatars_left_is_on_the_right() {
        let camera = Camera::orbit(DVec3::new(0.0, 1.0, 0.0), 0.0, 0.0, 3.0, 0.5, [640, 480]);
        let center = camera.project(camera.view.transform_point3(DVec3::new(0.0, 1.0, 0.0)));
        assert!(center.distance(DVec2::new(320.0, 240.0)) < 1e-9, "{center}");
        let left_and_up = camera.project(camera.view.transform_point3(DVec3::new(0.1, 1.1, 0.0)));
        assert!(
            left_and_up.x > 320.0 && left_and_up.y < 240.0,
            "{left_and_up}"
        );
        assert!(camera.eye().distance(DVec3::new(0.0, 1.0, 3.0)) < 1e-12);
    }

    /// The ellipsoid in a box of a person's size fills the image, and no point of it is outside.
    #[test]
    fn who_stands_fills_the_image() {
        let bounds = [DVec3::new(-0.4, 0.0, -0.4), DVec3::new(0.4, 1.84, 0.4)];
        let middle = (bounds[0] + bounds[1]) / 2.0;
        let around = 0.4 * 2f64.sqrt();
        for size in [[1024, 1024], [1280, 800], [300, 1000]] {
            let distance = Camera::standing_distance(bounds, 0.61, size);
            let camera = Camera::orbit(middle, 0.0, 0.0, distance, 0.61, size);
            let mut reach = DVec2::ZERO;
            for (up, turn) in (0..64).flat_map(|up| (0..64).map(move |turn| (up, turn))) {
                let (up, turn) = (f64::from(up) * 0.05 - 1.6, f64::from(turn) * 0.1);
                let out = around * up.cos();
                let point = DVec3::new(out * turn.sin(), 0.92 * up.sin(), out * turn.cos());
                let at = camera.project(camera.view.transform_point3(middle + point));
                reach = reach.max((at - camera.center).abs() / camera.center);
            }
            let furthest = reach.max_element();
            assert!((0.94..0.96).contains(&furthest), "{size:?}: {reach}");
        }
    }

    #[test]
    fn a_framed_box_is_in_the_image_from_every_side() {
        let bounds = [DVec3::new(-0.8, 0.0, -0.2), DVec3::new(0.9, 1.8, 0.3)];
        for size in [[640, 480], [300, 1000], [1000, 300]] {
            for yaw in 0..12 {
                let camera = Camera::around(
                    bounds,
                    Orbit {
                        yaw: f64::from(yaw),
                        pitch: 0.0,
                        fov: 0.6,
                    },
                    size,
                );
                for corner in 0..8 {
                    let corner = DVec3::new(
                        bounds[corner & 1].x,
                        bounds[corner >> 1 & 1].y,
                        bounds[corner >> 2].z,
                    );
                    let at = camera.project(camera.view.transform_point3(corner));
                    let inside = at.cmpge(DVec2::ZERO).all()
                        && at.x <= f64::from(size[0])
                        && at.y <= f64::from(size[1]);
                    assert!(inside, "{corner} lands at {at}, outside {size:?}");
                }
            }
        }
    }
}
