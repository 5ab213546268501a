//! The posed mesh as cameras see it: rays through every pixel.

use crate::bake::Clothed;
use crate::bake::body::blend;
use crate::bake::joints::is_head_or_chest;
use crate::bake::outfit::Outfit;
use crate::bake::surface::{Sheet, Site};
use crate::ground_truth::light::irradiance;
use crate::ground_truth::mesh::SheetMesh;
use crate::ground_truth::settled::{PosedMesh, SettledBody, turned_normal};
use crate::pictures::image::{BACKDROP, LinearImage};
use effigy_core::{
    avatar::{Pose, Skeleton},
    random::Random,
    scene::Camera,
};
use glam::{DAffine3, DMat3, DQuat, DVec2, DVec3};
use obvhs::{
    BvhBuildParams,
    cwbvh::{CwBvh, builder::build_cwbvh_from_tris},
    ray::{Ray, RayHit},
    triangle::Triangle,
};
use rayon::prelude::*;
use std::time::Duration;

/// Barycentric coordinates that tell whether all of a triangle shows, or none.
const PROBES: [[f64; 3]; 10] = {
    const T: f64 = 1.0 / 3.0;
    [
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, 0.0, 1.0],
        [T, T, T],
        [0.5, 0.5, 0.0],
        [0.0, 0.5, 0.5],
        [0.5, 0.0, 0.5],
        [0.6, 0.2, 0.2],
        [0.2, 0.6, 0.2],
        [0.2, 0.2, 0.6],
    ]
};

/// What a camera is to see.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BodyPart {
    /// The person.
    Whole,
    /// What the head, the neck and the uppermost joint of the spine move.
    HeadAndChest,
}

/// A triangle that can be seen.
#[derive(Clone, Copy, Debug)]
struct VisibleTriangle {
    /// Index into the mesh's triangles.
    triangle: u32,
    /// Index into the sheets.
    sheet: u16,
    /// Only a part of it shows: it lies across a hem.
    in_part: bool,
}

/// A dressed body before a camera, ready to be posed.
pub struct Studio {
    body: SettledBody,
    skeleton: Skeleton,
    outfit: Outfit,
    sheets: Vec<Sheet>,
    shown: Vec<VisibleTriangle>,
    /// The vertices of triangles that are shown.
    lit: Vec<u32>,
}

/// The mesh in a pose.
pub struct PosedScene<'a> {
    studio: &'a Studio,
    posed: PosedMesh,
    /// Of [`Studio::shown`], before the hips turn or move them.
    triangles: Vec<Triangle>,
    tree: CwBvh,
    /// Takes the mesh to its place in the world.
    to_world: DAffine3,
}

impl Studio {
    /// `rays`: rays traced per vertex for its light.
    pub fn new(clothed: Clothed, rays: usize) -> Self {
        let Clothed {
            body,
            outfit,
            sheets,
        } = clothed;
        let mesh = SheetMesh::new(&sheets, &outfit);
        let shown = shown(&sheets, &outfit);
        let mut lit: Vec<u32> = shown
            .iter()
            .flat_map(|shown| mesh.triangles[shown.triangle as usize])
            .collect();
        lit.sort_unstable();
        lit.dedup();
        Self {
            skeleton: body.skeleton.clone(),
            body: SettledBody::new(&body, mesh, rays),
            outfit,
            sheets,
            shown,
            lit,
        }
    }

    /// Poses the body.
    pub fn scene(&self, pose: &Pose) -> PosedScene<'_> {
        let posed = self.body.pose(pose, &self.lit);
        let triangle = |shown: &VisibleTriangle| {
            let corners = self.body.mesh.triangles[shown.triangle as usize];
            let [v0, v1, v2] = corners.map(|v| posed.settled[v as usize].as_vec3a());
            Triangle { v0, v1, v2 }
        };
        let triangles: Vec<Triangle> = self.shown.iter().map(triangle).collect();
        let tree = build_cwbvh_from_tris(
            &triangles,
            BvhBuildParams::fast_build(),
            &mut Duration::default(),
        );
        // The mesh is posed without the root's rotation and translation.
        let rest = DVec3::from(self.skeleton.rest[0].map(f64::from));
        let turn = pose.rotation.first().copied().unwrap_or_default();
        let to_world = DAffine3::from_rotation_translation(
            DQuat::from_scaled_axis(turn),
            rest + pose.translation,
        ) * DAffine3::from_translation(-rest);
        PosedScene {
            studio: self,
            posed,
            triangles,
            tree,
            to_world,
        }
    }

    /// Places that a part of the person's surface touches in a pose, metres: by linear blend
    /// skinning, some of the vertices.
    pub fn outline(&self, pose: &Pose, part: BodyPart) -> Vec<DVec3> {
        const EVERY: usize = 29;
        let mut rest = self.skeleton.clone();
        rest.canonical.fill([0.0; 3]);
        let joints = rest.matrices(pose);
        let mesh = &self.body.mesh;
        self.lit
            .iter()
            .step_by(EVERY)
            .filter(|&&v| {
                // The largest weight comes first.
                let joint = mesh.weights[v as usize].first().map(|own| own.joint);
                part == BodyPart::Whole || joint.is_some_and(is_head_or_chest)
            })
            .map(|&v| {
                let matrix = blend(&joints, &mesh.weights[v as usize]);
                matrix.transform_point3(mesh.rest[v as usize])
            })
            .collect()
    }
}

/// The triangles that can be seen.
fn shown(sheets: &[Sheet], outfit: &Outfit) -> Vec<VisibleTriangle> {
    let mut first = 0;
    let mut all = Vec::new();
    for (at, sheet) in sheets.iter().enumerate() {
        let own = (0..sheet.triangles.len()).into_par_iter().filter_map(|t| {
            let seen = PROBES
                .iter()
                .filter(|&&probe| outfit.shows(&sheet.site(t, probe)))
                .count();
            (seen > 0).then_some(VisibleTriangle {
                triangle: (first + t) as u32,
                sheet: at as u16,
                in_part: seen < PROBES.len(),
            })
        });
        all.extend(own.collect::<Vec<_>>());
        first += sheet.triangles.len();
    }
    all
}

/// Where a ray meets the mesh.
struct MeshHit {
    shown: VisibleTriangle,
    barycentric: [f64; 3],
}

impl PosedScene<'_> {
    /// The picture that a camera takes. `side`: a pixel's colour is the mean of as many squared
    /// samples, jittered by `seed`.
    pub fn picture(&self, camera: &Camera, side: u32, seed: u64) -> LinearImage {
        let mut image = LinearImage::empty(camera.size);
        let view = camera.view * self.to_world;
        let Some([low, high]) = self.extent(camera, view) else {
            return image;
        };
        let to_mesh = view.inverse();
        let width = camera.size[0] as usize;
        let count = f64::from(side * side);
        // How large a sample is at depth 1, metres.
        let footprint = 0.5 / (camera.focal.x * f64::from(side));
        let rows = image
            .light
            .chunks_mut(width)
            .zip(image.coverage.chunks_mut(width));
        for (y, (light, coverage)) in rows.enumerate() {
            if (y as u32) < low[1] || (y as u32) >= high[1] {
                continue;
            }
            for x in low[0]..high[0] {
                let mut random = Random::new(seed, (y as u64) << 32 | u64::from(x));
                let mut sum = DVec3::ZERO;
                let mut met = 0.0;
                for sample in 0..side * side {
                    let cell = DVec2::new(f64::from(sample % side), f64::from(sample / side));
                    let jitter = DVec2::new(random.uniform(), random.uniform());
                    let at = DVec2::new(f64::from(x), y as f64) + (cell + jitter) / f64::from(side);
                    let ray = camera.ray(at);
                    let along = to_mesh.transform_vector3(ray);
                    if let Some(light) = self.sample(to_mesh.translation, along, footprint) {
                        sum += light;
                        met += 1.0;
                    }
                }
                light[x as usize] = (sum + BACKDROP * (count - met)) / count;
                coverage[x as usize] = (met / count) as f32;
            }
        }
        image
    }

    /// The rectangle of pixels that the mesh is in, from and to; None: out of view.
    fn extent(&self, camera: &Camera, view: DAffine3) -> Option<[[u32; 2]; 2]> {
        let size = DVec2::from(camera.size.map(f64::from));
        let mut low = DVec2::INFINITY;
        let mut high = DVec2::NEG_INFINITY;
        for &v in &self.studio.lit {
            let seen = view.transform_point3(self.posed.settled[v as usize]);
            if seen.z < camera.near {
                // Behind the camera: anything may be in view.
                return Some([[0, 0], camera.size]);
            }
            let place = camera.project(seen);
            low = low.min(place);
            high = high.max(place);
        }
        let low = (low.floor() - 1.0).max(DVec2::ZERO).min(size);
        let high = (high.ceil() + 1.0).max(DVec2::ZERO).min(size);
        let pixels = |at: DVec2| [at.x as u32, at.y as u32];
        (low.cmplt(high).all()).then_some([pixels(low), pixels(high)])
    }

    /// Light along a ray, linear RGB; None: it meets nothing. `along`: as long as at depth 1;
    /// `footprint`: a sample's size there, metres.
    fn sample(&self, from: DVec3, along: DVec3, footprint: f64) -> Option<DVec3> {
        let length = along.length();
        let ray = Ray::new(
            from.as_vec3a(),
            (along / length).as_vec3a(),
            0.0,
            f32::INFINITY,
        );
        let mut hit = RayHit::none();
        self.tree.ray_traverse(ray, &mut hit, |ray, id| {
            let index = self.tree.primitive_indices[id] as usize;
            let distance = self.triangles[index].intersect(ray);
            if distance < ray.tmax && self.studio.shown[index].in_part {
                let hit = self.hit(index, from, along, f64::from(distance) / length);
                let site = self.site(&hit, 0.0);
                if !self.studio.outfit.shows(&site) {
                    return f32::INFINITY;
                }
            }
            distance
        });
        if hit.t == f32::INFINITY {
            return None;
        }
        let index = self.tree.primitive_indices[hit.primitive_id as usize] as usize;
        let depth = f64::from(hit.t) / length;
        let hit = self.hit(index, from, along, depth);
        Some(self.shade(&hit, along / length, footprint * depth))
    }

    fn hit(&self, index: usize, from: DVec3, along: DVec3, depth: f64) -> MeshHit {
        let shown = self.studio.shown[index];
        let corners = self.studio.body.mesh.triangles[shown.triangle as usize];
        let [a, b, c] = corners.map(|v| self.posed.settled[v as usize]);
        let p = from + depth * along;
        let normal = (b - a).cross(c - a);
        let area = normal.length_squared().max(1e-30);
        let u = (c - b).cross(p - b).dot(normal) / area;
        let v = (a - c).cross(p - c).dot(normal) / area;
        let u = u.clamp(0.0, 1.0);
        let v = v.clamp(0.0, 1.0 - u);
        MeshHit {
            shown,
            barycentric: [u, v, 1.0 - u - v],
        }
    }

    /// The place in the rest pose that a ray has met.
    fn site(&self, hit: &MeshHit, footprint: f64) -> Site {
        let at = usize::from(hit.shown.sheet);
        let first = self.studio.body.mesh.sheets[at].first_triangle;
        let triangle = hit.shown.triangle as usize - first;
        Site {
            footprint,
            ..self.studio.sheets[at].site(triangle, hit.barycentric)
        }
    }

    /// The light that leaves the surface against a ray's direction, linear RGB.
    fn shade(&self, hit: &MeshHit, along: DVec3, footprint: f64) -> DVec3 {
        let outfit = &self.studio.outfit;
        let mut site = self.site(hit, footprint);
        let rest = match site.material.light_normal() {
            Some(normal) => normal,
            None => outfit.relief_normal(&site),
        };
        let lift = outfit.relief(&site, site.position);
        site.position += lift * site.normal;
        let corners = self.studio.body.mesh.triangles[hit.shown.triangle as usize];
        let posed = &self.posed;
        let mean = |matrices: &[DMat3]| {
            let term = |k: usize| matrices[corners[k] as usize] * hit.barycentric[k];
            term(0) + term(1) + term(2)
        };
        let deformation = mean(&posed.gradients) * mean(&posed.skinned.turns);
        let mut normal = turned_normal(deformation, rest);
        let [a, b, c] = corners.map(|v| posed.settled[v as usize]);
        if (b - a).cross(c - a).dot(along) > 0.0 {
            // The inside of cloth.
            normal = -normal;
        }
        let light =
            |k: usize| irradiance(&posed.light[corners[k] as usize], normal) * hit.barycentric[k];
        let light: DVec3 = (0..3).map(light).sum();
        outfit.albedo(&site) * site.material.scatter(light)
    }
}
