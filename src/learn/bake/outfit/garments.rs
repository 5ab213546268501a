//! The limits of each garment, the visible part of each sheet, and how many Gaussians it deserves.

use crate::bake::body::{BakedBody, Person};
use crate::bake::joints::{is_arm, is_foot, is_hand, is_head};
use crate::bake::outfit::emblem;
use crate::bake::outfit::face::Face;
use crate::bake::outfit::shoe;
use crate::bake::source::masks::SurfaceMasks;
use crate::bake::style::Style;
use crate::bake::surface::{Material, Site};
use effigy_math::noise::smoothstep;
use glam::{DVec2, DVec3};

/// Length of the upper arm that sleeves are measured with, metres.
const UPPER_ARM: f64 = 0.28;
/// Length of the lower leg that hems are measured with, metres.
const LOWER_LEG: f64 = 0.42;
/// Half of the belt's height, metres.
const BELT_HALF: f64 = 0.017;
/// The emblem's centre above the chest joint, metres.
const EMBLEM_HEIGHT: f64 = 0.035;

/// Landmarks of the body that the garments depend on.
#[derive(Clone, Debug)]
pub struct Outfit {
    /// Its cut and colours.
    pub style: &'static Style,
    /// Face and hair.
    pub face: Face,
    /// Left, right; so are the other pairs.
    pub shoulder: [DVec3; 2],
    /// Elbows.
    pub elbow: [DVec3; 2],
    /// Hip joints.
    pub hip: [DVec3; 2],
    /// Knees.
    pub knee: [DVec3; 2],
    /// Ankles.
    pub ankle: [DVec3; 2],
    /// The neck's lower joint.
    pub neck: DVec3,
    /// The spine's upper joint.
    pub chest: DVec3,
    /// Height of the belt's middle.
    pub belt: f64,
}

/// How far along a limb a point is: 0 at its first joint, 1 at its second.
fn along_limb(p: DVec3, limb: [DVec3; 2]) -> f64 {
    let axis = limb[1] - limb[0];
    (p - limb[0]).dot(axis) / axis.length_squared()
}

/// The index of a point's side in pairs: 0 left, 1 right.
pub fn side(p: DVec3) -> usize {
    usize::from(p.x < 0.0)
}

impl Outfit {
    /// Measures a body.
    pub fn new(body: &BakedBody, masks: SurfaceMasks, person: Person) -> Self {
        let pair = |name: &str| {
            [
                body.joint(&format!("Left{name}")),
                body.joint(&format!("Right{name}")),
            ]
        };
        let hips = body.joint("LeftUpLeg").y;
        let spine = body.joint("Spine1").y;
        Self {
            style: person.style,
            face: Face::new(body, masks, person),
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

    /// Along the upper arm: 0 at the shoulder, 1 at the elbow.
    pub fn upper_arm(&self, p: DVec3) -> f64 {
        let side = side(p);
        along_limb(p, [self.shoulder[side], self.elbow[side]])
    }

    /// Along the lower leg: 0 at the knee, 1 at the ankle.
    pub fn lower_leg(&self, p: DVec3) -> f64 {
        let side = side(p);
        along_limb(p, [self.knee[side], self.ankle[side]])
    }

    /// Distance from the sleeve's hem up the arm, metres; below 0 on the bare arm.
    pub fn above_sleeve_hem(&self, p: DVec3) -> f64 {
        (self.style.sleeve - self.upper_arm(p)) * UPPER_ARM
    }

    /// Distance from the trousers' hem up the leg, metres; below 0 on the ankle.
    pub fn above_trouser_hem(&self, p: DVec3) -> f64 {
        (self.style.hem - self.lower_leg(p)) * LOWER_LEG
    }

    /// How far a point is inside the neckline, metres; below 0 on the shirt. The neckline is a ring
    /// around the neck that rises towards the nape.
    pub fn above_neckline(&self, p: DVec3) -> f64 {
        let forward = p.z - self.neck.z;
        let slope = if forward > 0.0 { 0.30 } else { 0.9 };
        let plane = p.y - (self.neck.y - 0.075) + slope * forward;
        let ring = 0.082 - p.x.hypot(p.z - self.neck.z - 0.010);
        plane.min(ring.max(plane - 0.09))
    }

    /// How far inside the shirt a point is, metres; below 0 outside.
    fn inside_shirt(&self, site: &Site) -> f64 {
        let p = site.position;
        let arm = site.share(is_arm);
        let sleeve = self.above_sleeve_hem(p);
        let torso = (p.y - self.belt + 0.02).min(-self.above_neckline(p));
        if arm > 0.5 {
            sleeve
        } else {
            torso.min(sleeve.max(0.06 * (1.0 - 2.0 * arm)))
        }
    }

    /// How far inside the trousers a point is, metres; below 0 outside.
    fn inside_trousers(&self, site: &Site) -> f64 {
        let p = site.position;
        // Hands hang beside the legs.
        let hand: f64 = if site.share(is_arm) > 0.3 { -1.0 } else { 1.0 };
        hand.min(self.belt - p.y).min(self.above_trouser_hem(p))
    }

    /// Whether a sheet's point can be seen: inside its garment, or, for skin, outside all of them.
    pub fn shows(&self, site: &Site) -> bool {
        let p = site.position;
        match site.material {
            Material::Skin => {
                let shod = site.share(is_foot) > 0.5 && p.y < shoe::COLLAR - 0.012;
                let clothed = self.inside_shirt(site) > 0.012
                    || self.inside_trousers(site) > 0.02
                    || (p.y - self.belt).abs() < 0.03 && site.share(is_arm) < 0.3;
                !shod && !clothed && !self.face.is_inside_mouth(site)
            }
            Material::Eye => site.normal.z > -0.1,
            Material::Lash | Material::Teeth => true,
            Material::Hair => self.face.hair_thickness(site) > 0.0,
            Material::Shirt => self.inside_shirt(site) > 0.0,
            Material::Trousers => self.inside_trousers(site) > 0.0,
            Material::Belt => (p.y - self.belt).abs() < BELT_HALF && site.share(is_arm) < 0.3,
            Material::Shoe => {
                // The collar is higher at the heel.
                let behind_ankle = (self.ankle[side(p)].z - p.z).clamp(-0.03, 0.05);
                p.y < shoe::COLLAR + 0.25 * behind_ankle
            }
        }
    }

    /// How many Gaussians an area deserves, relative to plain cloth's 1.
    pub fn density(&self, site: &Site) -> f64 {
        match site.material {
            Material::Skin => {
                let hand = site.share(is_hand);
                let face = self.face.detail(site.position) * site.share(is_head);
                1.4 + 1.4 * hand + 6.0 * face
            }
            Material::Eye => 16.0,
            Material::Lash => 12.0,
            Material::Teeth => 1.0,
            Material::Hair => 2.2,
            Material::Shirt => {
                let front = smoothstep(0.0, 0.5, site.normal.z);
                1.15 + 6.0 * emblem::nearness(self.emblem_point(site)) * front
            }
            Material::Trousers => 0.9,
            Material::Belt => 2.2,
            Material::Shoe => 1.7,
        }
    }

    /// A point of the shirt in the emblem's coordinates, see [`emblem`].
    pub fn emblem_point(&self, site: &Site) -> DVec2 {
        let p = site.position;
        DVec2::new(p.x, p.y - (self.chest.y + EMBLEM_HEIGHT))
    }
}
