//! Points of the head in; where its hair, brows, lips, iris and skin tones are, out.

use super::body::{Body, Shape};
use super::masks::Masks;
use super::math::{rough, srgb, step};
use super::outfit::is_head;
use super::surface::{Material, Sheet, Site};
use glam::{DVec2, DVec3};

/// Landmarks of the head, metres in the rest pose.
#[derive(Clone, Debug)]
pub struct Face {
    masks: Masks,
    shape: Shape,
    /// The left eye's centre; the right one mirrors it.
    eye: DVec3,
    /// Height of the crown.
    top: f64,
    /// Where the neck begins.
    neck: DVec3,
}

/// Colours in linear light.
fn skin() -> DVec3 {
    srgb(0xE0AC8B)
}

pub fn hair_color() -> DVec3 {
    srgb(0x3A281C)
}

impl Face {
    pub fn new(body: &Body, masks: Masks, shape: Shape) -> Self {
        let neck = body.joint("Neck");
        let top = body.obj.group("body").iter().flatten().map(|c| body.obj.positions[c.vertex as usize].y).fold(0.0, f64::max);
        let eye = body.center("helper-l-eye").unwrap_or(DVec3::new(0.03, top - 0.11, neck.z + 0.11));
        Self { masks, shape, eye, top, neck }
    }

    /// Coordinates relative to the nearer eye's centre: x outwards, y up, z forward.
    fn beside_eye(&self, p: DVec3) -> DVec3 {
        DVec3::new(p.x.abs() - self.eye.x, p.y - self.eye.y, p.z - self.eye.z)
    }

    /// The head's axis at eye height.
    fn axis(&self) -> DVec3 {
        DVec3::new(0.0, self.eye.y, self.eye.z - 0.085)
    }

    /// 1 at the eyes, the nose and the mouth, 0 at the back of the head.
    pub fn detail(&self, p: DVec3) -> f64 {
        let d = (p - DVec3::new(0.0, self.eye.y - 0.028, self.eye.z + 0.01)) / DVec3::new(0.062, 0.075, 0.06);
        step(1.5, 0.7, d.length())
    }

    /// Deep inside the mouth: never seen.
    pub fn inside(&self, site: &Site) -> bool {
        self.masks.mouth.at(site.uv) > 0.5 && site.position.z < self.eye.z - 0.035
    }

    /// Thickness of the hair above the skin, metres; 0 or less where there is none.
    pub fn hair(&self, site: &Site) -> f64 {
        if site.share(is_head) < 0.3 || self.masks.ears.at(site.uv) > 0.3 {
            return 0.0;
        }
        let from = site.position - self.axis();
        let turn = from.x.abs().atan2(from.z).to_degrees();
        let ragged = 0.004 * rough(71, site.position * 160.0);
        let above = from.y - self.hairline(turn) + ragged;
        let thick = if self.shape == Shape::Male { 0.017 } else { 0.021 };
        let sides = if self.shape == Shape::Male { step(0.0, 0.075, from.y - 0.01) } else { step(-0.05, 0.03, from.y) };
        step(-0.001, 0.022, above) * (0.35 + 0.65 * sides) * thick
    }

    /// Height of the hairline above the eyes by the angle from straight ahead, degrees.
    fn hairline(&self, turn: f64) -> f64 {
        const LINE: [(f64, f64); 9] = [
            (0.0, 0.066),
            (25.0, 0.066),
            (42.0, 0.056),
            (55.0, 0.030),
            (66.0, 0.018),
            (76.0, -0.016),
            (96.0, -0.010),
            (122.0, -0.040),
            (150.0, -0.068),
        ];
        let next = LINE.iter().position(|(angle, _)| *angle > turn).unwrap_or(LINE.len() - 1).max(1);
        let ((a, low), (b, high)) = (LINE[next - 1], LINE[next]);
        low + (high - low) * step(a, b, turn)
    }

    /// The scalp, raised by the hair's thickness.
    pub fn hair_sheet(&self, body: &Body) -> Sheet {
        let skin = Sheet::of_group(body, "body", Material::Hair);
        let mut sheet = Sheet { vertices: skin.vertices.clone(), triangles: Vec::new(), uv: Vec::new(), ..skin };
        let mut thickness = vec![0.0f64; sheet.vertices.len()];
        for (t, triangle) in skin.triangles.iter().enumerate() {
            let corners: [f64; 3] = std::array::from_fn(|k| {
                let mut at = [0.0; 3];
                at[k] = 1.0;
                self.hair(&skin.site(t, at))
            });
            if corners.iter().any(|h| *h > 0.0) {
                sheet.triangles.push(*triangle);
                sheet.uv.push(skin.uv[t]);
                (0..3).for_each(|k| thickness[triangle[k] as usize] = thickness[triangle[k] as usize].max(corners[k]));
            }
        }
        for (vertex, thickness) in sheet.vertices.iter_mut().zip(thickness) {
            vertex.position += vertex.normal * thickness.max(0.001);
        }
        sheet.find_normals();
        sheet
    }

    /// The way hair lies: away from the crown, along the head.
    pub fn hair_flow(&self, site: &Site) -> DVec3 {
        let crown = DVec3::new(0.012, self.top, self.axis().z - 0.045);
        let away = site.position - crown;
        let swirl = DVec3::Y.cross(away) * 0.35;
        let sweep = DVec3::new(0.35, 0.0, 0.0) * step(0.02, 0.08, site.position.z - self.axis().z);
        let flow = away.normalize_or(DVec3::Z) + swirl / away.length().max(1e-3) + sweep;
        flow.reject_from_normalized(site.normal).normalize_or(site.normal.any_orthonormal_vector())
    }

    /// Skin in linear light, with lips, brows, lids, nails and the scalp under the hair.
    pub fn skin(&self, site: &Site) -> DVec3 {
        let p = site.position;
        let mut color = skin() * (1.0 + 0.05 * rough(11, p * 22.0) + 0.03 * rough(12, p * 180.0));
        color *= DVec3::new(1.0, 1.0 - 0.03 * rough(13, p * 40.0), 1.0 - 0.04 * rough(14, p * 30.0));
        let flush = |color: DVec3, amount: f64| color * DVec3::new(1.0, 1.0 - 0.32 * amount, 1.0 - 0.34 * amount);
        color = flush(color, self.masks.nails.at(site.uv) * -0.25);
        if site.share(|joint| joint >= 20) > 0.5 {
            return flush(color, 0.22 + 0.25 * rough(15, p * 55.0).abs());
        }
        let head = step(0.2, 0.7, site.share(is_head));
        if head == 0.0 {
            return color;
        }
        let d = self.beside_eye(p);
        color = flush(color, head * self.flush(p, d));
        color = flush(color, 0.5 * self.masks.ears.at(site.uv));
        color *= 1.0 - 0.16 * self.beard(p, d);
        color *= 1.0 - 0.22 * step(0.3, 0.9, self.masks.eyelids.at(site.uv)) * step(-0.006, 0.004, d.y);
        let lips = step(0.25, 0.75, self.masks.lips.at(site.uv));
        color = color
            .lerp(srgb(if self.shape == Shape::Male { 0xB9756A } else { 0xB85D5A }) * (1.0 + 0.08 * rough(16, p * 300.0)), 0.85 * lips);
        color = color.lerp(srgb(0x5A2020), step(0.4, 0.8, self.masks.mouth.at(site.uv)));
        color = color.lerp(hair_color() * 0.85, 0.92 * self.brow(p, d));
        color.lerp(hair_color() * 0.7, step(0.0, 0.004, self.hair(site)))
    }

    /// Cheeks, nose tip.
    fn flush(&self, p: DVec3, d: DVec3) -> f64 {
        let cheek = (DVec2::new(d.x - 0.008, d.y + 0.038) / DVec2::new(0.022, 0.018)).length();
        let nose = (DVec2::new(p.x, d.y + 0.040) / DVec2::new(0.014, 0.013)).length();
        (0.42 * step(1.6, 0.2, cheek) + 0.35 * step(1.5, 0.3, nose)) * step(-0.05, -0.02, d.z)
    }

    fn beard(&self, p: DVec3, d: DVec3) -> f64 {
        if self.shape == Shape::Female {
            return 0.0;
        }
        let low = step(-0.052, -0.075, d.y - 0.35 * (p.x.abs() - 0.03).max(0.0)) * step(self.neck.y - 0.01, self.neck.y + 0.03, p.y);
        low * step(-0.10, -0.05, d.z) * (0.75 + 0.25 * rough(17, p * 900.0))
    }

    /// An arch above each eye, thinner towards the temple, with ragged edges.
    fn brow(&self, p: DVec3, d: DVec3) -> f64 {
        let t = (d.x + 0.017) / 0.042;
        if !(-0.1..=1.1).contains(&t) || d.z < -0.02 {
            return 0.0;
        }
        let arch = 0.0205 + 0.0045 * (1.0 - ((t - 0.62) / 0.62).powi(2));
        let strand = 0.0011 * rough(18, DVec3::new(p.x * 420.0 + p.y * 500.0, p.y * 90.0, 0.0));
        let half = (0.0046 - 0.0026 * t) * step(-0.08, 0.1, t) * step(1.05, 0.75, t);
        step(half + 0.0012, half - 0.0014, (d.y + strand - arch).abs()) * step(0.0, 0.0005, half)
    }

    /// The eyeball in linear light: pupil, iris, limbal ring, sclera, a catchlight.
    pub fn eye(&self, site: &Site) -> DVec3 {
        let d = self.beside_eye(site.position);
        let side = site.position.x.signum();
        let radius = DVec2::new(d.x + 0.0004, d.y).length() * 1e3;
        if d.z < 0.0 {
            return srgb(0xE8DCD4);
        }
        let spoke = rough(19, DVec3::new(d.y.atan2(d.x) * 9.0, radius * 0.5, side));
        let iris = srgb(0x5B7F8C).lerp(srgb(0x8A7A4E), step(3.9, 2.2, radius)) * (1.0 + 0.45 * spoke);
        let mut color = srgb(0xF1ECE6).lerp(srgb(0xD9A79A), 0.5 * step(8.0, 12.0, radius));
        color = color.lerp(srgb(0x24333A), step(6.1, 5.5, radius));
        color = color.lerp(iris, step(5.5, 4.9, radius));
        color = color.lerp(srgb(0x050505), step(2.5, 2.0, radius));
        let glint = DVec2::new(d.x * side - 0.0019, d.y - 0.0024).length() * 1e3;
        color.lerp(DVec3::splat(1.4), step(1.35, 0.75, glint))
    }
}
