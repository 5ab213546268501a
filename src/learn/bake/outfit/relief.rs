//! Folds, ribs and strands as heights above the sheets.

use crate::bake::joints::is_head;
use crate::bake::outfit::garments::{Outfit, side};
use crate::bake::surface::{Material, Site};
use effigy_math::noise::{fractal_noise, smoothstep};
use glam::DVec3;

impl Outfit {
    /// Height of the relief at a point `p` near a site, metres.
    pub fn relief(&self, site: &Site, p: DVec3) -> f64 {
        match site.material {
            Material::Shirt => {
                let waist = smoothstep(self.belt + 0.22, self.belt, p.y);
                let armpit = self.shoulder[side(p)] - DVec3::new(0.0, 0.06, 0.0);
                let near_armpit = smoothstep(0.22, 0.06, p.distance(armpit));
                // Folds lie across the waist, and up and down under the arms.
                let folds = 0.0035 * waist * fractal_noise(81, p * DVec3::new(16.0, 34.0, 16.0))
                    + 0.0035 * near_armpit * fractal_noise(82, p * DVec3::new(24.0, 16.0, 24.0));
                folds + 0.0012 * fractal_noise(83, p * 18.0)
            }
            Material::Trousers => {
                let near =
                    |height: f64, distance: f64| smoothstep(distance, 0.0, (p.y - height).abs());
                let amount = 0.4 * near(self.hip[0].y - 0.05, 0.16)
                    + 0.8 * near(self.knee[0].y, 0.16)
                    + 1.2 * near(self.ankle[0].y + 0.05, 0.2);
                0.0045 * (0.25 + amount) * fractal_noise(84, p * DVec3::new(11.0, 26.0, 11.0))
            }
            Material::Hair => 0.0035 * fractal_noise(85, p * 75.0),
            Material::Skin if site.share(is_head) < 0.5 => 0.0006 * fractal_noise(86, p * 60.0),
            _ => 0.0,
        }
    }

    /// The unit normal of the surface with its relief, by central differences.
    pub fn relief_normal(&self, site: &Site) -> DVec3 {
        const STEP: f64 = 0.0015;
        let slope = DVec3::AXES.map(|axis| {
            (self.relief(site, site.position + STEP * axis)
                - self.relief(site, site.position - STEP * axis))
                / (2.0 * STEP)
        });
        let slope = DVec3::from(slope).reject_from_normalized(site.normal);
        (site.normal - slope).normalize_or(site.normal)
    }
}
