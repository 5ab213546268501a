//! The body in; what it wears out: sheets of skin, eyes, hair, shirt, trousers, belt and shoes, and the rules where each of them begins
//! and ends. Lengths are metres in the rest pose.

use super::body::{Body, Shape};
use super::face::Face;
use super::masks::Masks;
use super::math::step;
use super::shoe;
use super::surface::{Material, Sheet, Site, Vertex};
use glam::DVec3;

/// How much of the upper arm the sleeve covers.
pub const SLEEVE: f64 = 0.60;
/// How far down the lower leg, knee to ankle, the trousers reach.
pub const HEM: f64 = 0.97;
const BELT_HALF: f64 = 0.017;

/// Landmarks that the rules need.
#[derive(Clone, Debug)]
pub struct Outfit {
    pub face: Face,
    /// Left, right.
    pub shoulder: [DVec3; 2],
    pub elbow: [DVec3; 2],
    pub hip: [DVec3; 2],
    pub knee: [DVec3; 2],
    pub ankle: [DVec3; 2],
    pub neck: DVec3,
    pub chest: DVec3,
    /// Height of the belt's middle.
    pub belt: f64,
}

/// Joints of an arm beyond the collar bone, hands and fingers included.
pub fn is_arm(joint: u8) -> bool {
    joint >= 16
}

/// Joints of a foot.
pub fn is_foot(joint: u8) -> bool {
    matches!(joint, 7 | 8 | 10 | 11)
}

/// Head: joint 15.
pub fn is_head(joint: u8) -> bool {
    joint == 15
}

/// How far along a limb a point is: 0 at its first joint, 1 at its second.
fn along(p: DVec3, limb: [DVec3; 2]) -> f64 {
    let axis = limb[1] - limb[0];
    (p - limb[0]).dot(axis) / axis.length_squared()
}

impl Outfit {
    pub fn new(body: &Body, masks: Masks, shape: Shape) -> Self {
        let pair = |name: &str| [body.joint(&format!("Left{name}")), body.joint(&format!("Right{name}"))];
        let (hips, spine) = (body.joint("LeftUpLeg").y, body.joint("Spine1").y);
        Self {
            face: Face::new(body, masks, shape),
            shoulder: pair("Arm"),
            elbow: pair("ForeArm"),
            hip: pair("UpLeg"),
            knee: pair("Leg"),
            ankle: pair("Foot"),
            neck: body.joint("Neck"),
            chest: body.joint("Spine2"),
            belt: hips + 0.55 * (spine - hips),
        }
    }

    fn side(p: DVec3) -> usize {
        usize::from(p.x < 0.0)
    }

    /// Along the upper arm: 0 at the shoulder, 1 at the elbow.
    pub fn upper_arm(&self, p: DVec3) -> f64 {
        let s = Self::side(p);
        along(p, [self.shoulder[s], self.elbow[s]])
    }

    /// Along the lower leg: 0 at the knee, 1 at the ankle.
    pub fn lower_leg(&self, p: DVec3) -> f64 {
        let s = Self::side(p);
        along(p, [self.knee[s], self.ankle[s]])
    }

    /// How far a point is inside the neckline, a ring around the neck that rises towards the nape; below 0 on the shirt.
    pub fn above_neckline(&self, p: DVec3) -> f64 {
        let forward = p.z - self.neck.z;
        let plane = p.y - (self.neck.y - 0.075) + if forward > 0.0 { 0.30 } else { 0.9 } * forward;
        let ring = 0.082 - p.x.hypot(p.z - self.neck.z - 0.010);
        plane.min(ring.max(plane - 0.09))
    }

    /// How far inside the shirt a point is, metres; below 0 outside.
    fn in_shirt(&self, site: &Site) -> f64 {
        let p = site.position;
        let arm = site.share(is_arm);
        let sleeve = (SLEEVE - self.upper_arm(p)) * 0.28;
        let torso = (p.y - self.belt + 0.02).min(-self.above_neckline(p));
        if arm > 0.5 { sleeve } else { torso.min(sleeve.max(0.06 * (1.0 - 2.0 * arm))) }
    }

    /// The same for the trousers.
    fn in_trousers(&self, site: &Site) -> f64 {
        let p = site.position;
        let hand: f64 = if site.share(is_arm) > 0.3 { -1.0 } else { 1.0 };
        hand.min(self.belt - p.y).min((HEM - self.lower_leg(p)) * 0.42)
    }

    /// Whether a sheet's point is there to be seen: inside its garment, or, for skin, outside all of them.
    pub fn shows(&self, site: &Site) -> bool {
        let p = site.position;
        match site.material {
            Material::Skin => {
                let shod = site.share(is_foot) > 0.5 && p.y < shoe::COLLAR - 0.012;
                let clothed = self.in_shirt(site) > 0.012
                    || self.in_trousers(site) > 0.02
                    || (p.y - self.belt).abs() < 0.03 && site.share(is_arm) < 0.3;
                !shod && !clothed && !self.face.inside(site)
            }
            Material::Eye => site.normal.z > -0.1,
            Material::Lash | Material::Teeth => true,
            Material::Hair => self.face.hair(site) > 0.0,
            Material::Shirt => self.in_shirt(site) > 0.0,
            Material::Trousers => self.in_trousers(site) > 0.0,
            Material::Belt => (p.y - self.belt).abs() < BELT_HALF && site.share(is_arm) < 0.3,
            Material::Shoe => p.y < shoe::COLLAR + 0.25 * (self.ankle[Self::side(p)].z - p.z).clamp(-0.03, 0.05),
        }
    }

    /// How many Gaussians an area deserves, against plain cloth's 1.
    pub fn density(&self, site: &Site) -> f64 {
        match site.material {
            Material::Skin => {
                let hand = site.share(|joint| joint >= 20);
                let face = self.face.detail(site.position) * site.share(is_head);
                1.4 + 1.4 * hand + 6.0 * face
            }
            Material::Eye => 16.0,
            Material::Lash => 12.0,
            Material::Teeth => 1.0,
            Material::Hair => 2.2,
            Material::Shirt => 1.15 + 6.0 * super::print::nearness(self.print_at(site)) * step(0.0, 0.5, site.normal.z),
            Material::Trousers => 0.9,
            Material::Belt => 2.2,
            Material::Shoe => 1.7,
        }
    }

    /// Coordinates of a point of the shirt in the print: metres to the avatar's left and up from the print's centre.
    pub fn print_at(&self, site: &Site) -> glam::DVec2 {
        let p = site.position;
        glam::DVec2::new(p.x, p.y - (self.chest.y + 0.035))
    }

    /// All sheets, the innermost first.
    pub fn sheets(&self, body: &Body) -> Vec<Sheet> {
        let mut sheets = vec![Sheet::of_group(body, "body", Material::Skin)];
        for (groups, material) in [
            (&["helper-l-eye", "helper-r-eye"][..], Material::Eye),
            (&["helper-l-eyelashes-2", "helper-r-eyelashes-2"], Material::Lash),
            (&["helper-upper-teeth", "helper-lower-teeth"], Material::Teeth),
        ] {
            sheets.extend(groups.iter().map(|group| Sheet::of_group(body, group, material)));
        }
        sheets.push(self.face.hair_sheet(body));
        let mut cloth = Sheet::of_group(body, "helper-tights", Material::Shirt);
        cloth.smooth(6);
        let garment = |material: Material, by: &dyn Fn(&Vertex) -> f64| {
            let mut sheet = Sheet { material, ..cloth.clone() };
            sheet.inflate(by);
            sheet
        };
        sheets.push(garment(Material::Trousers, &|v| {
            let leg = step(-0.2, 1.0, self.lower_leg(v.position)) * step(self.knee[0].y + 0.1, self.knee[0].y - 0.1, v.position.y);
            0.010 + 0.016 * leg
        }));
        sheets.push(garment(Material::Shirt, &|v| {
            let above = v.position.y - self.belt;
            let blouse = step(0.0, 0.05, above) * step(0.22, 0.06, above);
            let sleeve = step(0.0, 0.6, self.upper_arm(v.position)) * f64::from(v.weights.iter().any(|(j, w)| is_arm(*j) && *w > 0.5));
            0.010 + 0.010 * blouse + 0.007 * sleeve
        }));
        sheets.push(garment(Material::Belt, &|_| 0.0165));
        sheets.extend(shoe::sheets(body));
        sheets
    }
}
