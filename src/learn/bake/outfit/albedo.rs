//! Colours before light, linear RGB. Patterns are ours.

use crate::bake::joints::{is_arm, is_lower_leg};
use crate::bake::outfit::garments::{Outfit, side};
use crate::bake::outfit::{emblem, palette, shoe};
use crate::bake::surface::{Material, Site};
use effigy_math::color::linear;
use effigy_math::noise::{fractal_noise, noise, smoothstep};
use glam::{DVec2, DVec3};

/// A distance from which no seam is seen, metres.
const FAR: f64 = 1.0;

/// Distance from the middle of a period, in periods: 0 to 0.5.
fn from_middle_of_period(x: f64) -> f64 {
    (x.rem_euclid(1.0) - 0.5).abs()
}

impl Outfit {
    /// The mean over a Gaussian's footprint; `radius` in metres.
    pub fn mean_albedo(&self, site: &Site, radius: f64) -> DVec3 {
        let (u, v) = site.normal.any_orthonormal_pair();
        let mut near = site.clone();
        let mut sum = self.albedo(site) * 2.0;
        for (x, y) in [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)] {
            near.position = site.position + 0.5 * radius * (x * u + y * v);
            sum += self.albedo(&near);
        }
        sum / 6.0
    }

    /// At a site; lines finer than its footprint are blurred.
    pub fn albedo(&self, site: &Site) -> DVec3 {
        match site.material {
            Material::Skin => self.skin(site),
            Material::Eye => self.face.eye(site),
            Material::Lash => linear(palette::LASHES),
            Material::Teeth => linear(palette::TEETH),
            Material::Hair => {
                let coarse = noise(31, site.position * 90.0);
                let fine = noise(32, site.position * 700.0);
                linear(self.style.hair) * (1.0 + 0.5 * coarse + 0.25 * fine)
            }
            Material::Shirt => self.shirt(site),
            Material::Trousers => self.trousers(site),
            Material::Belt => self.belt(site),
            Material::Shoe => self.shoe(site),
        }
    }

    /// Bare skin, and socks between trousers and shoes.
    fn skin(&self, site: &Site) -> DVec3 {
        let is_sock = self.lower_leg(site.position) > self.style.socks_top;
        if site.share(is_lower_leg) > 0.5 && is_sock {
            linear(self.style.socks)
        } else {
            self.face.skin(site)
        }
    }

    /// Heather with fine stripes, which run around the arm on the sleeves, a ribbed collar and
    /// hems, and the emblem.
    fn shirt(&self, site: &Site) -> DVec3 {
        /// Length of the upper arm that stripes are measured with, metres.
        const UPPER_ARM: f64 = 0.26;
        /// Half of a line of stitches' width, metres.
        const STITCH: f64 = 0.0012;
        let p = site.position;
        let sleeve = site.share(is_arm) > 0.5;
        let across_stripes = if sleeve {
            self.upper_arm(p) * UPPER_ARM
        } else {
            p.y
        };
        let stripe = smoothstep(
            0.32,
            0.22,
            from_middle_of_period(across_stripes / self.style.stripe),
        );
        let thread = 0.07 * noise(41, DVec3::new(p.x * 900.0, p.y * 260.0, p.z * 900.0))
            + 0.05 * fractal_noise(42, p * 60.0);
        let plain = linear(self.style.shirt).lerp(linear(self.style.shirt_stripe), stripe);
        let mut color = plain * (1.0 + thread);

        let collar = self.above_neckline(p);
        let hem = if sleeve {
            self.above_sleeve_hem(p)
        } else {
            FAR
        };
        let rib = smoothstep(-0.020, -0.018, collar).max(smoothstep(0.016, 0.014, hem));
        color = color.lerp(linear(self.style.shirt_rib) * (1.0 + 0.8 * thread), rib);
        // Stitches just outside the ribs, and a soft shade where the sleeve is sewn on.
        let stitches = site
            .line(collar + 0.0205, STITCH)
            .max(site.line(hem - 0.0175, STITCH));
        let armhole = site.line(site.share(is_arm) - 0.5, 0.06);
        color *= 1.0 - 0.4 * stitches - 0.3 * armhole;

        if site.normal.z > 0.15 && !sleeve {
            let p = self.emblem_point(site);
            for (ink, hue) in emblem::gaussian_ink(p).into_iter().zip(palette::EMBLEM) {
                color = color.lerp(linear(hue), 0.95 * ink);
            }
            color = color.lerp(linear(palette::EMBLEM_WORD), 0.97 * emblem::word_ink(p));
        }
        color
    }

    /// Denim: twill, worn thighs and knees, seams with orange thread, pockets, a turned hem.
    fn trousers(&self, site: &Site) -> DVec3 {
        /// Stitches a metre.
        const STITCHES: f64 = 160.0;
        /// Distance of the thread from its seam, metres.
        const THREAD_OFFSET: f64 = 0.0045;
        /// Half of the thread's width, metres.
        const THREAD: f64 = 0.0009;
        /// Single stitches are not drawn by Gaussians larger than this, metres.
        const STITCH_FOOTPRINT: f64 = 0.003;
        let p = site.position;
        let twill = 0.10 * noise(51, DVec3::new(p.x * 300.0, p.y * 500.0, p.z * 300.0))
            + 0.08 * fractal_noise(52, p * 35.0);
        let thigh = smoothstep(0.25, 0.0, (self.hip[0].y - 0.20 - p.y).abs())
            * smoothstep(0.0, 0.8, site.normal.z);
        let knee = smoothstep(0.10, 0.0, (self.knee[0].y - p.y).abs())
            * smoothstep(0.2, 0.9, site.normal.z);
        let worn = 0.55 * thigh + 0.35 * knee;
        let mut color =
            linear(self.style.denim).lerp(linear(self.style.denim_worn), worn) * (1.0 + twill);
        let thread = linear(self.style.denim_thread);
        for seam in self.seam_distances(site) {
            color *= 1.0 - 0.45 * site.line(seam, 0.0016);
            let dash = if site.footprint > STITCH_FOOTPRINT {
                0.5
            } else {
                smoothstep(0.55, 0.45, (p.y * STITCHES).rem_euclid(1.0))
            };
            let stitch = site.line(seam.abs() - THREAD_OFFSET, THREAD) * dash;
            color = color.lerp(thread, 0.75 * stitch);
        }
        let hem = self.above_trouser_hem(p);
        color *= 1.0 - 0.35 * site.line(hem - 0.022, 0.0013);
        color.lerp(thread, 0.6 * site.line(hem - 0.019, THREAD))
    }

    /// Signed distances from the trousers' outer, inner, fly and pocket seams, metres.
    fn seam_distances(&self, site: &Site) -> [f64; 4] {
        let p = site.position;
        let hip = self.hip[side(p)];
        let ankle = self.ankle[side(p)];
        // The middle of the leg at the point's height.
        let t = ((hip.y - p.y) / (hip.y - ankle.y)).clamp(0.0, 1.0);
        let middle = hip.lerp(ankle, t);
        let outwards = (p.x - middle.x) * p.x.signum();
        let outer = if outwards > 0.0 {
            p.z - middle.z + 0.012
        } else {
            FAR
        };
        let inner = if outwards < 0.0 && p.y < hip.y - 0.09 {
            p.z - middle.z + 0.005
        } else {
            FAR
        };
        let fly = if p.y > self.hip[0].y - 0.09 && site.normal.z.abs() > 0.2 {
            p.x
        } else {
            FAR
        };
        // Front pockets are round, back pockets are boxes.
        let front = DVec2::new(p.x.abs() - 0.165, p.y - self.belt + 0.005).length() - 0.095;
        let back = (DVec2::new(p.x.abs() - 0.075, p.y - self.belt + 0.125).abs()
            - DVec2::new(0.058, 0.062))
        .max_element();
        let pocket = if site.normal.z > 0.1 {
            front
        } else if site.normal.z < -0.1 {
            back
        } else {
            FAR
        };
        [outer, inner, fly, pocket]
    }

    /// Leather with edges, and a buckle in front.
    fn belt(&self, site: &Site) -> DVec3 {
        const BUCKLE_HALF_SIZE: DVec2 = DVec2::new(0.024, 0.0155);
        let p = site.position;
        let height = p.y - self.belt;
        // Below 0 inside.
        let buckle = (DVec2::new(p.x, height).abs() - BUCKLE_HALF_SIZE).max_element();
        if site.normal.z > 0.2 && buckle < 0.0 {
            let hole = smoothstep(-0.006, -0.0075, buckle);
            return linear(palette::BUCKLE).lerp(linear(palette::BUCKLE_HOLE), hole);
        }
        let leather = linear(palette::BELT) * (1.0 + 0.15 * fractal_noise(61, p * 120.0));
        let edge = site.line(height.abs() - 0.0125, 0.0012);
        leather * (1.0 - 0.35 * edge)
    }

    /// Canvas with a rubber sole, a toe cap, a tongue and laces.
    fn shoe(&self, site: &Site) -> DVec3 {
        /// Where canvas turns into toe cap, metres before the ankle.
        const TOE_CAP: [f64; 2] = [0.158, 0.161];
        /// From one lace to the next, metres.
        const LACE: f64 = 0.0175;
        let p = site.position;
        let ankle = self.ankle[side(p)];
        let forward = p.z - ankle.z;
        let groove = site.line(p.y - shoe::SOLE + 0.009, 0.0012);
        let rubber = linear(palette::RUBBER) * (1.0 - 0.25 * groove);
        if p.y < shoe::SOLE {
            let is_underside = site.normal.y < -0.75;
            return if is_underside {
                linear(palette::SOLE)
            } else {
                rubber
            };
        }
        let weave = 0.12 * noise(65, p * 500.0);
        let mut color = linear(self.style.canvas) * (1.0 + weave);
        color = color.lerp(rubber, smoothstep(TOE_CAP[0], TOE_CAP[1], forward));
        // Feet point a little outwards.
        let from_middle = (p.x - ankle.x - 0.21 * forward * p.x.signum()).abs();
        let tongue = smoothstep(0.027, 0.024, from_middle)
            * smoothstep(0.02, 0.03, forward)
            * smoothstep(0.148, 0.145, forward);
        color = color.lerp(linear(self.style.tongue) * (1.0 + weave), tongue);
        let lace = smoothstep(0.26, 0.18, from_middle_of_period(forward / LACE))
            * tongue
            * smoothstep(0.130, 0.125, forward);
        color = color.lerp(linear(palette::LACES), lace);
        // Where the canvas meets the sole, and the seam of the heel.
        color
            * (1.0 - 0.5 * site.line(p.y - shoe::SOLE, 0.0015))
            * (1.0 - 0.3 * site.line(forward + 0.028, 0.0012))
    }
}

impl Site {
    /// How much of a line is seen at a distance from its middle, 0 to 1; `half_width` is half of
    /// its width, all in metres. Wider and fainter where the footprint is coarser.
    fn line(&self, distance: f64, half_width: f64) -> f64 {
        let blurred = half_width.max(0.5 * self.footprint);
        half_width / blurred * smoothstep(blurred * 1.5, blurred * 0.5, distance.abs())
    }
}
