//! Where the scene's nodes are.

use crate::gltf::{
    Document,
    document::{Node, Scenes},
    entry,
};
use effigy_core::{
    glam::{DAffine3, DMat4, DQuat, DVec3},
    io::file::FormatError,
};

/// A mesh in the scene's space.
pub struct PlacedMesh {
    pub mesh: u32,
    pub place: DAffine3,
}

/// The meshes of the nodes of the document's scene, or of all roots where it names none.
///
/// # Errors
/// When an index leads nowhere, or a node has two parents.
pub fn meshes(document: &Document, scenes: &Scenes) -> Result<Vec<PlacedMesh>, FormatError> {
    let count = document.nodes.len();
    let roots: Vec<u32> = match scenes.scenes.get(scenes.scene.unwrap_or_default()) {
        Some(scene) => scene.nodes.clone(),
        None => {
            let mut is_root = vec![true; count];
            for &child in document.nodes.iter().flat_map(|node| &node.children) {
                if let Some(root) = is_root.get_mut(child as usize) {
                    *root = false;
                }
            }
            let indices = (0..).zip(is_root).filter(|(_, is_root)| *is_root);
            indices.map(|(index, _)| index).collect()
        }
    };
    let mut seen = vec![false; count];
    // Nodes that are still to be visited, and where their parents are.
    let mut waiting: Vec<(u32, DAffine3)> = vec![];
    waiting.extend(roots.iter().rev().map(|&node| (node, DAffine3::IDENTITY)));
    let mut placed = vec![];
    while let Some((index, parent)) = waiting.pop() {
        let node = entry(&document.nodes, index, "node")?;
        if std::mem::replace(&mut seen[index as usize], true) {
            return Err(FormatError::container(
                format!("node {index} twice in the scene"),
                "a tree of nodes",
            ));
        }
        let place = parent * of(node)?;
        if let Some(mesh) = node.mesh {
            placed.push(PlacedMesh { mesh, place });
        }
        waiting.extend(node.children.iter().rev().map(|&child| (child, place)));
    }
    Ok(placed)
}

/// A node's own transform.
fn of(node: &Node) -> Result<DAffine3, FormatError> {
    let place = match &node.matrix {
        Some(matrix) => DAffine3::from_mat4(DMat4::from_cols_array(matrix)),
        None => DAffine3::from_scale_rotation_translation(
            node.scale.map_or(DVec3::ONE, DVec3::from),
            node.rotation
                .map_or(DQuat::IDENTITY, DQuat::from_array)
                .normalize(),
            node.translation.map_or(DVec3::ZERO, DVec3::from),
        ),
    };
    if place.is_finite() {
        return Ok(place);
    }
    Err(FormatError::container(
        "a node's transform that is not finite",
        "finite numbers",
    ))
}
