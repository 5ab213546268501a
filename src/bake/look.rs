//! A point of a sheet in; its colour before light, the cloth's folds and seams as a height, out. Colours and patterns are ours.

use super::face::hair_color;
use super::math::{noise, rough, srgb, step};
use super::outfit::{Outfit, is_arm, is_head};
use super::print;
use super::shoe;
use super::surface::{Material, Site};
use glam::DVec3;

/// Period of the shirt's stripes, metres.
const STRIPE: f64 = 0.015;

impl Outfit {
    /// Albedo, linear.
    pub fn albedo(&self, site: &Site) -> DVec3 {
        match site.material {
            Material::Skin => self.skin(site),
            Material::Eye => self.face.eye(site),
            Material::Lash => srgb(0x1A1210),
            Material::Teeth => srgb(0xE6DED0),
            Material::Hair => hair_color() * (1.0 + 0.5 * noise(31, site.position * 90.0) + 0.25 * noise(32, site.position * 700.0)),
            Material::Shirt => self.shirt(site),
            Material::Trousers => self.trousers(site),
            Material::Belt => self.belt(site),
            Material::Shoe => self.shoe(site),
        }
    }

    fn skin(&self, site: &Site) -> DVec3 {
        let leg = site.share(|joint| matches!(joint, 4 | 5 | 7 | 8 | 10 | 11));
        if leg > 0.5 { srgb(0x2B2D33) } else { self.face.skin(site) }
    }

    /// Heather with fine stripes; on the sleeves they run around the arm.
    fn shirt(&self, site: &Site) -> DVec3 {
        let p = site.position;
        let sleeve = site.share(is_arm) > 0.5;
        let along = if sleeve { self.upper_arm(p) * 0.26 } else { p.y };
        let stripe = step(0.32, 0.22, ((along / STRIPE).rem_euclid(1.0) - 0.5).abs());
        let thread = 0.07 * noise(41, DVec3::new(p.x * 900.0, p.y * 260.0, p.z * 900.0)) + 0.05 * rough(42, p * 60.0);
        let mut color = srgb(0x2F6E78).lerp(srgb(0x3F8791), stripe) * (1.0 + thread);
        let collar = self.above_neckline(p);
        let hem = if sleeve { (super::outfit::SLEEVE - self.upper_arm(p)) * 0.28 } else { 1.0 };
        let rib = step(-0.020, -0.018, collar).max(step(0.016, 0.014, hem));
        color = color.lerp(srgb(0x1F4C56) * (1.0 + 0.8 * thread), rib);
        color *=
            1.0 - 0.4 * site.line(collar + 0.0205, 0.0012).max(site.line(hem - 0.0175, 0.0012)) - 0.3 * site.line(self.armhole(site), 0.06);
        if site.normal.z > 0.15 && !sleeve {
            let at = self.print_at(site);
            for (ink, hue) in print::emblem(at).into_iter().zip([0xF2A65A, 0xE4604E, 0xF4D58D]) {
                color = color.lerp(srgb(hue), 0.95 * ink);
            }
            color = color.lerp(srgb(0xF6EFE0), 0.97 * print::word(at));
        }
        color
    }

    /// Distance from the seam where the sleeve begins, in shares of the arm's weight.
    fn armhole(&self, site: &Site) -> f64 {
        site.share(is_arm) - 0.5
    }

    /// Denim: twill, worn thighs, side and fly seams with orange thread, pockets, a turned hem.
    fn trousers(&self, site: &Site) -> DVec3 {
        let p = site.position;
        let twill = 0.10 * noise(51, DVec3::new(p.x * 300.0, p.y * 500.0, p.z * 300.0)) + 0.08 * rough(52, p * 35.0);
        let worn = step(0.25, 0.0, (self.hip[0].y - 0.20 - p.y).abs()) * step(0.0, 0.8, site.normal.z);
        let knee = step(0.10, 0.0, (self.knee[0].y - p.y).abs()) * step(0.2, 0.9, site.normal.z);
        let mut color = srgb(0x2C3A57).lerp(srgb(0x5B7093), 0.55 * worn + 0.35 * knee) * (1.0 + twill);
        for seam in self.seams(site) {
            color *= 1.0 - 0.45 * site.line(seam, 0.0016);
            let dash = if site.footprint > 0.003 { 0.5 } else { step(0.55, 0.45, (p.y * 160.0).rem_euclid(1.0)) };
            let stitch = site.line(seam.abs() - 0.0045, 0.0009) * dash;
            color = color.lerp(srgb(0xC98B4A), 0.75 * stitch);
        }
        let hem = (super::outfit::HEM - self.lower_leg(p)) * 0.42;
        color *= 1.0 - 0.35 * site.line(hem - 0.022, 0.0013);
        color.lerp(srgb(0xC98B4A), 0.6 * site.line(hem - 0.019, 0.0009))
    }

    /// Signed distances from the trousers' seams, metres.
    fn seams(&self, site: &Site) -> [f64; 4] {
        let p = site.position;
        let side = usize::from(p.x < 0.0);
        let t = ((self.hip[side].y - p.y) / (self.hip[side].y - self.ankle[side].y)).clamp(0.0, 1.0);
        let middle = self.hip[side].lerp(self.ankle[side], t);
        let outer = if (p.x - middle.x) * p.x.signum() > 0.0 { p.z - middle.z + 0.012 } else { 1.0 };
        let inner = if (p.x - middle.x) * p.x.signum() < 0.0 && p.y < self.hip[side].y - 0.09 { p.z - middle.z + 0.005 } else { 1.0 };
        let fly = if p.y > self.hip[0].y - 0.09 && site.normal.z.abs() > 0.2 { p.x } else { 1.0 };
        let front = glam::DVec2::new(p.x.abs() - 0.165, p.y - self.belt + 0.005).length() - 0.095;
        let back = {
            let d = glam::DVec2::new(p.x.abs() - 0.075, p.y - self.belt + 0.125).abs() - glam::DVec2::new(0.058, 0.062);
            d.max_element()
        };
        let pocket = if site.normal.z > 0.1 {
            front
        } else if site.normal.z < -0.1 {
            back
        } else {
            1.0
        };
        [outer, inner, fly, pocket]
    }

    fn belt(&self, site: &Site) -> DVec3 {
        let p = site.position;
        let buckle = (glam::DVec2::new(p.x, p.y - self.belt).abs() - glam::DVec2::new(0.024, 0.0155)).max_element();
        let leather = srgb(0x4A2E1D) * (1.0 + 0.15 * rough(61, p * 120.0));
        let edge = site.line((p.y - self.belt).abs() - 0.0125, 0.0012);
        if site.normal.z > 0.2 && buckle < 0.0 {
            return srgb(0xB9B2A2).lerp(srgb(0x3A2417), step(-0.006, -0.0075, buckle));
        }
        leather * (1.0 - 0.35 * edge)
    }

    /// Canvas with a rubber sole, a toe cap and laces.
    fn shoe(&self, site: &Site) -> DVec3 {
        let p = site.position;
        let ankle = self.ankle[usize::from(p.x < 0.0)];
        let forward = p.z - ankle.z;
        let rubber = srgb(0xEDEAE2) * (1.0 - 0.25 * site.line(p.y - shoe::SOLE + 0.009, 0.0012));
        if p.y < shoe::SOLE {
            return if site.normal.y < -0.75 { srgb(0x4A4640) } else { rubber };
        }
        let weave = 0.12 * noise(65, p * 500.0);
        let mut color = srgb(0x8C3B34) * (1.0 + weave);
        color = color.lerp(rubber, step(0.158, 0.161, forward));
        let middle = (p.x - ankle.x - 0.21 * forward * p.x.signum()).abs();
        let tongue = step(0.027, 0.024, middle) * step(0.02, 0.03, forward) * step(0.148, 0.145, forward);
        color = color.lerp(srgb(0x74302B) * (1.0 + weave), tongue);
        let lace = step(0.26, 0.18, ((forward / 0.0175).rem_euclid(1.0) - 0.5).abs()) * tongue * step(0.130, 0.125, forward);
        color = color.lerp(srgb(0xF4F1EA), lace);
        color * (1.0 - 0.5 * site.line(p.y - shoe::SOLE, 0.0015)) * (1.0 - 0.3 * site.line(forward + 0.028, 0.0012))
    }

    /// Height of folds, ribs and strands above the sheet, metres.
    pub fn relief(&self, site: &Site, p: DVec3) -> f64 {
        match site.material {
            Material::Shirt => {
                let waist = step(self.belt + 0.22, self.belt, p.y);
                let pits = step(0.22, 0.06, p.distance(self.shoulder[usize::from(p.x < 0.0)] - DVec3::new(0.0, 0.06, 0.0)));
                let folds = 0.0035 * waist * rough(81, p * DVec3::new(16.0, 34.0, 16.0))
                    + 0.0035 * pits * rough(82, p * DVec3::new(24.0, 16.0, 24.0));
                folds + 0.0012 * rough(83, p * 18.0)
            }
            Material::Trousers => {
                let bend = |at: f64, reach: f64| step(reach, 0.0, (p.y - at).abs());
                let amount =
                    0.4 * bend(self.hip[0].y - 0.05, 0.16) + 0.8 * bend(self.knee[0].y, 0.16) + 1.2 * bend(self.ankle[0].y + 0.05, 0.2);
                0.0045 * (0.25 + amount) * rough(84, p * DVec3::new(11.0, 26.0, 11.0))
            }
            Material::Hair => 0.0035 * rough(85, p * 75.0),
            Material::Skin if site.share(is_head) < 0.5 => 0.0006 * rough(86, p * 60.0),
            _ => 0.0,
        }
    }

    /// The normal of the surface with its relief.
    pub fn relief_normal(&self, site: &Site) -> DVec3 {
        const H: f64 = 0.0015;
        let slope =
            DVec3::AXES.map(|axis| (self.relief(site, site.position + H * axis) - self.relief(site, site.position - H * axis)) / (2.0 * H));
        let slope = DVec3::from(slope).reject_from_normalized(site.normal);
        (site.normal - slope).normalize_or(site.normal)
    }
}

impl Site {
    /// How much of a line of half the width `width` is seen at a distance from it: wider and fainter where the footprint is coarser.
    fn line(&self, distance: f64, width: f64) -> f64 {
        let blurred = width.max(0.5 * self.footprint);
        width / blurred * step(blurred * 1.5, blurred * 0.5, distance.abs())
    }
}
