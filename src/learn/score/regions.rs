//! Parts of the body that are measured for themselves: whole pictures can't tell a dead face.

use effigy_capture::Template;
use glam::DVec3;
use serde::Serialize;

/// A part of the body.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Region {
    /// The front of the head, without the mouth.
    Face,
    /// What the jaw moves; without such a joint, the lower front of the head.
    Mouth,
    /// Hands and wrists.
    Hands,
    /// Everything else: body, hair, clothes, and what the mask has beside the body model.
    Rest,
}

impl Region {
    /// In the order of tables.
    pub const ALL: [Self; 4] = [Self::Face, Self::Mouth, Self::Hands, Self::Rest];

    /// The name in tables and JSON.
    pub fn name(self) -> &'static str {
        match self {
            Self::Face => "face",
            Self::Mouth => "mouth",
            Self::Hands => "hands",
            Self::Rest => "rest",
        }
    }
}

/// Parts of joints' names, in small letters.
const JAW: [&str; 3] = ["jaw", "mouth", "tongue"];
const HEAD: [&str; 2] = ["head", "eye"];
const HAND: [&str; 8] = [
    "hand", "wrist", "finger", "thumb", "index", "middle", "ring", "pinky",
];
/// Where the mouth is in a head without a jaw, of its height, width and depth: from the chin, to
/// both sides of the middle, and from the back.
const MOUTH_HEIGHT: [f64; 2] = [0.10, 0.36];
const MOUTH_WIDTH: f64 = 0.22;
const MOUTH_DEPTH: f64 = 0.6;

/// The region of each vertex of a body model, from the joint that moves it most, and from its place
/// in the rest pose, which looks along +z.
pub fn regions_of(template: &Template) -> Vec<Region> {
    let named = |joint: u8, parts: &[&str]| {
        let name = template.skeleton.name[usize::from(joint)].to_lowercase();
        parts.iter().any(|part| name.contains(part))
    };
    let most: Vec<Option<u8>> = template
        .weights
        .iter()
        .map(|own| own.first().map(|influence| influence.joint))
        .collect();
    let moved_by = |vertex: usize, parts: &[&str]| most[vertex].is_some_and(|j| named(j, parts));
    let normals = normals(template);
    let has_jaw = (0..template.skeleton.len() as u8).any(|joint| named(joint, &JAW));
    let count = template.vertices.len();
    let head: Vec<usize> = (0..count).filter(|&v| moved_by(v, &HEAD)).collect();
    let corner = |pick: fn(DVec3, DVec3) -> DVec3, start: f64| {
        let corners = head.iter().map(|&v| template.vertices[v]);
        corners.fold(DVec3::splat(start), pick)
    };
    let low = corner(DVec3::min, f64::INFINITY);
    let size = corner(DVec3::max, f64::NEG_INFINITY) - low;
    let is_low_front = |vertex: usize| {
        let part = (template.vertices[vertex] - low) / size;
        (MOUTH_HEIGHT[0]..MOUTH_HEIGHT[1]).contains(&part.y)
            && (part.x - 0.5).abs() < MOUTH_WIDTH
            && part.z > MOUTH_DEPTH
    };
    (0..count)
        .map(|vertex| {
            if moved_by(vertex, &JAW) {
                Region::Mouth
            } else if moved_by(vertex, &HEAD) && normals[vertex].z > 0.0 {
                if !has_jaw && is_low_front(vertex) {
                    Region::Mouth
                } else {
                    Region::Face
                }
            } else if moved_by(vertex, &HAND) {
                Region::Hands
            } else {
                Region::Rest
            }
        })
        .collect()
}

/// Outward normals in the rest pose, as long as the triangles around are large.
fn normals(template: &Template) -> Vec<DVec3> {
    let mut normals = vec![DVec3::ZERO; template.vertices.len()];
    for triangle in &template.triangles {
        let [a, b, c] = triangle.map(|vertex| template.vertices[vertex as usize]);
        for &vertex in triangle {
            normals[vertex as usize] += (b - a).cross(c - a);
        }
    }
    normals
}

#[cfg(test)]
mod tests {
    use super::*;
    use effigy_capture::VertexInfluence;
    use effigy_core::avatar::Skeleton;

    /// A quad that looks along z, at a height, moved by a joint. `x`: its corners' from the middle.
    fn add(template: &mut Template, joint: u8, y: [f64; 2], z: f64, x: f64) {
        let first = template.vertices.len() as u32;
        for (x, y) in [(-x, y[0]), (x, y[0]), (x, y[1]), (-x, y[1])] {
            template.vertices.push(DVec3::new(x, y, z));
            template
                .weights
                .push(vec![VertexInfluence { joint, weight: 1.0 }]);
        }
        let turned = z < 0.0;
        for [a, b, c] in [[0, 1, 2], [0, 2, 3]] {
            let [b, c] = if turned { [c, b] } else { [b, c] };
            template.triangles.push([first + a, first + b, first + c]);
        }
    }

    fn template(names: &[&str]) -> Template {
        Template {
            skeleton: Skeleton {
                name: names.iter().map(|&name| name.into()).collect(),
                parent: (0..names.len())
                    .map(|j| j.checked_sub(1).map(|p| p as u8))
                    .collect(),
                rest: vec![[0.0; 3]; names.len()],
                canonical: vec![[0.0; 3]; names.len()],
            },
            vertices: vec![],
            triangles: vec![],
            weights: vec![],
            input_joints: vec![],
            head_joints: vec![],
            expression: 0,
        }
    }

    #[test]
    fn joints_names_and_sides_decide() {
        let mut body = template(&["Hips", "mixamorig:Head", "LeftHandIndex1", "jaw"]);
        add(&mut body, 0, [0.0, 1.0], 0.1, 0.2);
        add(&mut body, 1, [1.4, 1.7], 0.1, 0.1);
        add(&mut body, 1, [1.4, 1.7], -0.1, 0.1);
        add(&mut body, 2, [0.8, 0.9], 0.1, 0.1);
        add(&mut body, 3, [1.4, 1.45], 0.1, 0.05);
        let found: Vec<Region> = regions_of(&body).chunks(4).map(|quad| quad[0]).collect();
        use Region::*;
        assert_eq!(found, [Rest, Face, Rest, Hands, Mouth]);
    }

    #[test]
    fn without_a_jaw_the_mouth_is_the_lower_front_of_the_head() {
        let mut body = template(&["hips", "head"]);
        add(&mut body, 1, [1.4, 1.7], 0.1, 0.1);
        add(&mut body, 1, [1.45, 1.5], 0.11, 0.02);
        add(&mut body, 1, [1.4, 1.7], -0.1, 0.1);
        let found = regions_of(&body);
        assert_eq!(found[..4], [Region::Face; 4]);
        assert_eq!(found[4..8], [Region::Mouth; 4]);
        assert_eq!(found[8..], [Region::Rest; 4]);
    }
}
