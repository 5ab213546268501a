//! The head: where its hair, brows, lips, iris and skin tones are.

use crate::bake::body::{BakedBody, BodyShape, Person};
use crate::bake::joints::{is_hand, is_head};
use crate::bake::outfit::palette;
use crate::bake::source::masks::SurfaceMasks;
use crate::bake::style::Style;
use crate::bake::surface::{Material, Sheet, Site};
use effigy_math::color::linear;
use effigy_math::noise::{fractal_noise, smoothstep};
use glam::{DVec2, DVec3};

/// Landmarks of the head, metres in the rest pose.
#[derive(Clone, Debug)]
pub struct Face {
    masks: SurfaceMasks,
    shape: BodyShape,
    style: &'static Style,
    /// The left eye's centre; the right one mirrors it.
    eye: DVec3,
    /// Height of the crown.
    top: f64,
    /// Where the neck begins.
    neck: DVec3,
}

impl Face {
    /// Measures a body's head.
    pub fn new(body: &BakedBody, masks: SurfaceMasks, person: Person) -> Self {
        let neck = body.joint("Neck");
        let top = body
            .obj
            .group("body")
            .iter()
            .flatten()
            .map(|corner| body.obj.positions[corner.vertex as usize].y)
            .fold(0.0, f64::max);
        let eye = body.group_center("helper-l-eye").unwrap_or(DVec3::new(
            0.03,
            top - 0.11,
            neck.z + 0.11,
        ));
        Self {
            masks,
            shape: person.shape,
            style: person.style,
            eye,
            top,
            neck,
        }
    }

    /// Coordinates relative to the nearer eye's centre: x outwards, y up, z forward.
    fn relative_to_eye(&self, p: DVec3) -> DVec3 {
        DVec3::new(p.x.abs() - self.eye.x, p.y - self.eye.y, p.z - self.eye.z)
    }

    /// The head's axis at eye height.
    fn axis(&self) -> DVec3 {
        DVec3::new(0.0, self.eye.y, self.eye.z - 0.085)
    }

    /// How much detail there is: 1 at the eyes, the nose and the mouth, 0 at the back of the head.
    pub fn detail(&self, p: DVec3) -> f64 {
        let d = (p - DVec3::new(0.0, self.eye.y - 0.028, self.eye.z + 0.01))
            / DVec3::new(0.062, 0.075, 0.06);
        smoothstep(1.5, 0.7, d.length())
    }

    /// Whether a point is deep inside the mouth, where it is never seen.
    pub fn is_inside_mouth(&self, site: &Site) -> bool {
        self.masks.mouth.at(site.uv) > 0.5 && site.position.z < self.eye.z - 0.035
    }

    /// Thickness of the hair above the skin, metres; 0 or less without hair.
    pub fn hair_thickness(&self, site: &Site) -> f64 {
        if site.share(is_head) < 0.3 || self.masks.ears.at(site.uv) > 0.3 {
            return 0.0;
        }
        let from_axis = site.position - self.axis();
        let degrees = from_axis.x.abs().atan2(from_axis.z).to_degrees();
        let ragged = 0.004 * fractal_noise(71, site.position * 160.0);
        let above_hairline = from_axis.y - self.hairline(degrees) + ragged;
        // Short at the sides of the male head only.
        let (thickest, sides) = match self.shape {
            BodyShape::Male => (0.017, smoothstep(0.0, 0.075, from_axis.y - 0.01)),
            BodyShape::Female => (0.021, smoothstep(-0.05, 0.03, from_axis.y)),
        };
        smoothstep(-0.001, 0.022, above_hairline) * (0.35 + 0.65 * sides) * thickest
    }

    /// Height of the hairline above the eyes, metres, at an angle from straight ahead, degrees.
    fn hairline(&self, degrees: f64) -> f64 {
        /// Angle and height.
        const POINTS: [(f64, f64); 9] = [
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
        let next = POINTS
            .iter()
            .position(|(angle, _)| *angle > degrees)
            .unwrap_or(POINTS.len() - 1)
            .max(1);
        let (from_angle, from_height) = POINTS[next - 1];
        let (to_angle, to_height) = POINTS[next];
        from_height + (to_height - from_height) * smoothstep(from_angle, to_angle, degrees)
    }

    /// The scalp, raised by the hair's thickness.
    pub fn hair_sheet(&self, body: &BakedBody) -> Sheet {
        const CORNERS: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let skin = Sheet::from_group(body, "body", Material::Hair);
        let mut sheet = Sheet {
            vertices: skin.vertices.clone(),
            triangles: Vec::new(),
            uv: Vec::new(),
            ..skin
        };
        let mut thickness = vec![0.0f64; sheet.vertices.len()];
        for (t, triangle) in skin.triangles.iter().enumerate() {
            let corners = CORNERS.map(|corner| self.hair_thickness(&skin.site(t, corner)));
            if corners.iter().all(|h| *h <= 0.0) {
                continue;
            }
            sheet.triangles.push(*triangle);
            sheet.uv.push(skin.uv[t]);
            for (&v, corner) in triangle.iter().zip(corners) {
                let thickness = &mut thickness[v as usize];
                *thickness = thickness.max(corner);
            }
        }
        for (vertex, thickness) in sheet.vertices.iter_mut().zip(thickness) {
            vertex.position += vertex.normal * thickness.max(0.001);
        }
        sheet.find_normals();
        sheet
    }

    /// The direction in which hair lies: away from the crown, along the head. Unit vector.
    pub fn hair_flow(&self, site: &Site) -> DVec3 {
        let crown = DVec3::new(0.012, self.top, self.axis().z - 0.045);
        let away = site.position - crown;
        let swirl = DVec3::Y.cross(away) * 0.35;
        // The fringe is swept to the avatar's left.
        let fringe = smoothstep(0.02, 0.08, site.position.z - self.axis().z);
        let sweep = DVec3::new(0.35, 0.0, 0.0) * fringe;
        let flow = away.normalize_or(DVec3::Z) + swirl / away.length().max(1e-3) + sweep;
        flow.reject_from_normalized(site.normal)
            .normalize_or(site.normal.any_orthonormal_vector())
    }

    /// Skin in linear RGB, with lips, brows, lids, nails and the scalp under the hair.
    pub fn skin(&self, site: &Site) -> DVec3 {
        let p = site.position;
        let blotches = 0.05 * fractal_noise(11, p * 22.0);
        let pores = 0.03 * fractal_noise(12, p * 180.0);
        let mut color = linear(self.style.skin) * (1.0 + blotches + pores);
        color *= DVec3::new(
            1.0,
            1.0 - 0.03 * fractal_noise(13, p * 40.0),
            1.0 - 0.04 * fractal_noise(14, p * 30.0),
        );
        color = flush(color, self.masks.nails.at(site.uv) * -0.25);
        if site.share(is_hand) > 0.5 {
            return flush(color, 0.22 + 0.25 * fractal_noise(15, p * 55.0).abs());
        }
        let head = smoothstep(0.2, 0.7, site.share(is_head));
        if head == 0.0 {
            return color;
        }
        let d = self.relative_to_eye(p);
        color = flush(color, head * self.flush_amount(p, d));
        color = flush(color, 0.5 * self.masks.ears.at(site.uv));
        color *= 1.0 - 0.16 * self.beard(p, d);
        let lids = smoothstep(0.3, 0.9, self.masks.eyelids.at(site.uv));
        color *= 1.0 - 0.22 * lids * smoothstep(-0.006, 0.004, d.y);
        let lips = smoothstep(0.25, 0.75, self.masks.lips.at(site.uv));
        let lip_color = match self.shape {
            BodyShape::Male => linear(self.style.lips[0]),
            BodyShape::Female => linear(self.style.lips[1]),
        };
        let lip_creases = 1.0 + 0.08 * fractal_noise(16, p * 300.0);
        color = color.lerp(lip_color * lip_creases, 0.85 * lips);
        let mouth = smoothstep(0.4, 0.8, self.masks.mouth.at(site.uv));
        color = color.lerp(linear(palette::MOUTH), mouth);
        let hair = linear(self.style.hair);
        color = color.lerp(hair * 0.85, 0.92 * self.brow(p, d));
        color.lerp(
            hair * 0.7,
            smoothstep(0.0, 0.004, self.hair_thickness(site)),
        )
    }

    /// How red cheeks and the nose's tip are. `d`: relative to the eye.
    fn flush_amount(&self, p: DVec3, d: DVec3) -> f64 {
        let cheek = (DVec2::new(d.x - 0.008, d.y + 0.038) / DVec2::new(0.022, 0.018)).length();
        let nose = (DVec2::new(p.x, d.y + 0.040) / DVec2::new(0.014, 0.013)).length();
        let amount = 0.42 * smoothstep(1.6, 0.2, cheek) + 0.35 * smoothstep(1.5, 0.3, nose);
        amount * smoothstep(-0.05, -0.02, d.z)
    }

    /// How much of a shaved beard's shadow there is, 0 to 1. `d`: relative to the eye.
    fn beard(&self, p: DVec3, d: DVec3) -> f64 {
        if self.shape == BodyShape::Female {
            return 0.0;
        }
        let towards_ears = (p.x.abs() - 0.03).max(0.0);
        let low = smoothstep(-0.052, -0.075, d.y - 0.35 * towards_ears)
            * smoothstep(self.neck.y - 0.01, self.neck.y + 0.03, p.y);
        let stubble = 0.75 + 0.25 * fractal_noise(17, p * 900.0);
        low * smoothstep(-0.10, -0.05, d.z) * stubble
    }

    /// How much of a brow there is, 0 to 1: an arch above each eye, thinner towards the temple,
    /// with ragged edges. `d`: relative to the eye.
    fn brow(&self, p: DVec3, d: DVec3) -> f64 {
        // Along the brow: 0 at the nose, 1 at the temple.
        let t = (d.x + 0.017) / 0.042;
        if !(-0.1..=1.1).contains(&t) || d.z < -0.02 {
            return 0.0;
        }
        let arch = 0.0205 + 0.0045 * (1.0 - ((t - 0.62) / 0.62).powi(2));
        let strand_point = DVec3::new(p.x * 420.0 + p.y * 500.0, p.y * 90.0, 0.0);
        let strand = 0.0011 * fractal_noise(18, strand_point);
        let half_height =
            (0.0046 - 0.0026 * t) * smoothstep(-0.08, 0.1, t) * smoothstep(1.05, 0.75, t);
        let from_arch = (d.y + strand - arch).abs();
        smoothstep(half_height + 0.0012, half_height - 0.0014, from_arch)
            * smoothstep(0.0, 0.0005, half_height)
    }

    /// The eyeball in linear RGB: pupil, iris, limbal ring, sclera, a catchlight.
    pub fn eye(&self, site: &Site) -> DVec3 {
        let d = self.relative_to_eye(site.position);
        if d.z < 0.0 {
            return linear(palette::EYEBALL_BACK);
        }
        let side = site.position.x.signum();
        // From the pupil's middle, millimetres; so are all radii here.
        let radius = DVec2::new(d.x + 0.0004, d.y).length() * 1e3;
        let spoke_point = DVec3::new(d.y.atan2(d.x) * 9.0, radius * 0.5, side);
        let spokes = 1.0 + 0.45 * fractal_noise(19, spoke_point);
        let iris = linear(self.style.iris_outer)
            .lerp(linear(self.style.iris_inner), smoothstep(3.9, 2.2, radius))
            * spokes;
        let rim = 0.5 * smoothstep(8.0, 12.0, radius);
        let mut color = linear(palette::SCLERA).lerp(linear(palette::SCLERA_RIM), rim);
        color = color.lerp(linear(palette::LIMBAL_RING), smoothstep(6.1, 5.5, radius));
        color = color.lerp(iris, smoothstep(5.5, 4.9, radius));
        color = color.lerp(linear(palette::PUPIL), smoothstep(2.5, 2.0, radius));
        let catchlight = DVec2::new(d.x * side - 0.0019, d.y - 0.0024).length() * 1e3;
        color.lerp(DVec3::splat(1.4), smoothstep(1.35, 0.75, catchlight))
    }
}

/// A skin colour with more blood in it; paler where `amount` is below 0.
fn flush(color: DVec3, amount: f64) -> DVec3 {
    color * DVec3::new(1.0, 1.0 - 0.32 * amount, 1.0 - 0.34 * amount)
}
