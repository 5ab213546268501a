//! The camera: a pinhole. World coordinates are y up, camera coordinates x right, y down, z forward, as pictures and 3DGS have them.

use glam::{DAffine3, DMat3, DVec2, DVec3};

/// A pinhole camera and the size of its picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// World to camera, metres.
    pub view: DAffine3,
    /// Focal length along x and y, px.
    pub focal: DVec2,
    /// Where the optical axis meets the picture, px from the top left corner.
    pub center: DVec2,
    /// Width and height, px, at least 1.
    pub size: [u32; 2],
    /// Gaussians whose centre is nearer than this are culled, metres.
    pub near: f64,
}

impl Camera {
    /// Nearest distance drawn unless told otherwise, metres.
    pub const NEAR: f64 = 0.1;

    /// Looks from `eye` at `target`, the picture's upper edge towards +y. `fov` is the vertical field of view, radians.
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

    /// Looks at `target` from `distance` away; `yaw` 0 sees the avatar's front, growing towards its left; `pitch` above 0 looks down. Radians.
    pub fn orbit(target: DVec3, yaw: f64, pitch: f64, distance: f64, fov: f64, size: [u32; 2]) -> Self {
        let direction = DVec3::new(yaw.sin() * pitch.cos(), pitch.sin(), yaw.cos() * pitch.cos());
        Self::look_at(target + distance * direction, target, fov, size)
    }

    /// How far from the middle of a box to orbit so that all of it is in the picture, whatever the yaw, with a little room.
    pub fn framing_distance([min, max]: [DVec3; 2], fov: f64, size: [u32; 2]) -> f64 {
        let half = (max - min) / 2.0;
        let around = half.x.hypot(half.z);
        let slope = (0.5 * fov).tan();
        let aspect = f64::from(size[0]) / f64::from(size[1]);
        1.05 * (half.y / slope).max(around / (slope * aspect)) + around
    }

    /// Looks at the middle of a box from where all of it is in the picture. Radians, as for [`Self::orbit`].
    pub fn around(bounds: [DVec3; 2], yaw: f64, pitch: f64, fov: f64, size: [u32; 2]) -> Self {
        Self::orbit((bounds[0] + bounds[1]) / 2.0, yaw, pitch, Self::framing_distance(bounds, fov, size), fov, size)
    }

    /// The same view in a picture of another size, stretched to it.
    pub fn stretched(&self, size: [u32; 2]) -> Self {
        let ratio = DVec2::new(f64::from(size[0]) / f64::from(self.size[0]), f64::from(size[1]) / f64::from(self.size[1]));
        Self { focal: self.focal * ratio, center: self.center * ratio, size, ..*self }
    }

    /// Where the camera is in the world.
    pub fn eye(&self) -> DVec3 {
        self.view.inverse().translation
    }

    /// Picture coordinates of a point in camera coordinates, px.
    pub fn project(&self, p: DVec3) -> DVec2 {
        self.focal * p.truncate() / p.z + self.center
    }

    /// Smallest and largest x/z and y/z at which the perspective's derivative is taken.
    pub fn derivative_limits(&self) -> [DVec2; 2] {
        let size = DVec2::new(f64::from(self.size[0]), f64::from(self.size[1]));
        let margin = super::DERIVATIVE_MARGIN * 0.5 * size / self.focal;
        [-self.center / self.focal - margin, (size - self.center) / self.focal + margin]
    }

    /// A Gaussian whose centre lies further than the picture's longer side outside the picture is culled: the splats' centres are
    /// fixed-point numbers of that range.
    pub fn guard(&self) -> f64 {
        f64::from(self.size[0].max(self.size[1]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_front_camera_sees_the_avatars_left_on_the_right() {
        let camera = Camera::orbit(DVec3::new(0.0, 1.0, 0.0), 0.0, 0.0, 3.0, 0.5, [640, 480]);
        let center = camera.project(camera.view.transform_point3(DVec3::new(0.0, 1.0, 0.0)));
        assert!(center.distance(DVec2::new(320.0, 240.0)) < 1e-9, "{center}");
        let left_and_up = camera.project(camera.view.transform_point3(DVec3::new(0.1, 1.1, 0.0)));
        assert!(left_and_up.x > 320.0 && left_and_up.y < 240.0, "{left_and_up}");
        assert!(camera.eye().distance(DVec3::new(0.0, 1.0, 3.0)) < 1e-12);
    }

    #[test]
    fn a_framed_box_is_inside_the_picture_from_every_side() {
        let bounds = [DVec3::new(-0.8, 0.0, -0.2), DVec3::new(0.9, 1.8, 0.3)];
        for size in [[640, 480], [300, 1000], [1000, 300]] {
            for yaw in 0..12 {
                let camera = Camera::around(bounds, f64::from(yaw), 0.0, 0.6, size);
                for corner in 0..8 {
                    let corner = DVec3::new(bounds[corner & 1].x, bounds[corner >> 1 & 1].y, bounds[corner >> 2].z);
                    let at = camera.project(camera.view.transform_point3(corner));
                    let inside = at.cmpge(DVec2::ZERO).all() && at.x <= f64::from(size[0]) && at.y <= f64::from(size[1]);
                    assert!(inside, "{corner} lands at {at}, outside {size:?}");
                }
            }
        }
    }
}
