//! The naked body as a capture's body model.

use crate::bake::body::{BakedBody, EXPRESSIONS};
use crate::bake::joints::is_head;
use crate::bake::source::rig::{self, BODY};
use crate::bake::surface::{Material, Sheet};
use effigy_capture::{Template, VertexInfluence};

/// Groups of the mesh that the model has: skin and eyes.
const GROUPS: [(&str, Material); 3] = [
    ("body", Material::Skin),
    ("helper-l-eye", Material::Eye),
    ("helper-r-eye", Material::Eye),
];

/// The body without clothes and hair, in its rest pose.
pub fn template(body: &BakedBody) -> Template {
    let mut template = Template {
        skeleton: body.skeleton.clone(),
        vertices: Vec::new(),
        triangles: Vec::new(),
        weights: Vec::new(),
        input_joints: (1..BODY.len() as u8).collect(),
        head_joints: (0..body.skeleton.len() as u8)
            .filter(|&joint| is_head(joint))
            .collect(),
        expression: EXPRESSIONS.len(),
    };
    for (group, material) in GROUPS {
        let sheet = Sheet::from_group(body, group, material);
        let first = template.vertices.len() as u32;
        for triangle in &sheet.triangles {
            template.triangles.push(triangle.map(|v| v + first));
        }
        for vertex in &sheet.vertices {
            template.vertices.push(vertex.position);
            let influence = |own: &rig::PointInfluence| VertexInfluence {
                joint: own.joint,
                weight: own.weight as f32,
            };
            template
                .weights
                .push(vertex.weights.iter().map(influence).collect());
        }
    }
    template
}
