//! Distortion of a lens by OpenCV's model of five numbers.

use effigy_core::scene::Camera;
use glam::DVec2;

/// Distortions whose numbers add up to less are ignored.
const NEGLIGIBLE: f64 = 1e-4;

/// Whether a lens distorts.
pub fn distorts(distortion: &[f64; 5]) -> bool {
    distortion.iter().map(|k| k.abs()).sum::<f64>() >= NEGLIGIBLE
}

/// Where a point at depth 1 appears through the lens, at depth 1. `distortion`: k1, k2, p1, p2, k3.
pub fn distort(point: DVec2, distortion: &[f64; 5]) -> DVec2 {
    let [k1, k2, p1, p2, k3] = *distortion;
    let DVec2 { x, y } = point;
    let r2 = point.length_squared();
    let radial = 1.0 + r2 * (k1 + r2 * (k2 + r2 * k3));
    DVec2::new(
        x * radial + 2.0 * p1 * x * y + p2 * (r2 + 2.0 * x * x),
        y * radial + p1 * (r2 + 2.0 * y * y) + 2.0 * p2 * x * y,
    )
}

/// Four pixels around a place and the share of each.
pub struct Bilinear {
    /// Indices into the picture's rows.
    pub pixels: [usize; 4],
    /// Sum to 1.
    pub shares: [f64; 4],
}

impl Bilinear {
    /// Around a place in a picture, px from its corner. None: outside.
    pub fn at(place: DVec2, size: [u32; 2]) -> Option<Self> {
        let [width, height] = size.map(f64::from);
        let inside = place.x >= 0.0 && place.y >= 0.0 && place.x <= width && place.y <= height;
        if !inside {
            return None;
        }
        // From the middle of the upper left pixel; at the edge its pixels are repeated.
        let from = place - 0.5;
        let low = from.floor();
        let share = from - low;
        let index = |column: f64, row: f64| {
            let column = column.clamp(0.0, width - 1.0) as usize;
            let row = row.clamp(0.0, height - 1.0) as usize;
            row * size[0] as usize + column
        };
        Some(Self {
            pixels: [
                index(low.x, low.y),
                index(low.x + 1.0, low.y),
                index(low.x, low.y + 1.0),
                index(low.x + 1.0, low.y + 1.0),
            ],
            shares: [
                (1.0 - share.x) * (1.0 - share.y),
                share.x * (1.0 - share.y),
                (1.0 - share.x) * share.y,
                share.x * share.y,
            ],
        })
    }
}

/// For each pixel without distortion, where it is in the picture as it was shot; None: outside.
pub fn undistortion<'a>(
    camera: &'a Camera,
    distortion: &'a [f64; 5],
) -> impl Iterator<Item = Option<Bilinear>> + 'a {
    let [width, height] = camera.size;
    (0..height).flat_map(move |row| {
        (0..width).map(move |column| {
            let pixel = DVec2::new(f64::from(column), f64::from(row)) + 0.5;
            let straight = camera.ray(pixel).truncate();
            let shot = distort(straight, distortion) * camera.focal + camera.center;
            Bilinear::at(shot, camera.size)
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_model_is_opencvs() {
        // cv2.projectPoints of (0.3, -0.2, 1) with these numbers, OpenCV 5.0.
        let found = distort(DVec2::new(0.3, -0.2), &[-0.3, 0.11, 0.002, -0.003, 0.05]);
        let expected = DVec2::new(0.287_720_655, -0.191_813_77);
        assert!(found.distance(expected) < 1e-12, "{found}");
    }

    #[test]
    fn small_numbers_are_no_distortion() {
        assert!(!distorts(&[5e-5, -4e-5, 0.0, 0.0, 0.0]));
        assert!(distorts(&[0.0, 0.0, 0.0, 0.0, -2e-4]));
    }

    #[test]
    fn a_place_in_a_pixels_middle_is_that_pixel() {
        let at = Bilinear::at(DVec2::new(2.5, 1.5), [4, 3]).expect("inside");
        assert_eq!((at.pixels[0], at.shares), (6, [1.0, 0.0, 0.0, 0.0]));
        assert!(Bilinear::at(DVec2::new(-0.1, 1.0), [4, 3]).is_none());
        assert!(Bilinear::at(DVec2::NAN, [4, 3]).is_none());
        let corner = Bilinear::at(DVec2::new(4.0, 3.0), [4, 3]).expect("inside");
        assert_eq!(corner.pixels, [11; 4]);
    }
}
