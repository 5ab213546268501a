//! Where the scene's nodes are.

use super::document::{Document, Node, entry};
use effigy_core::{
    glam::{DAffine3, DMat4, DQuat, DVec3},
    io::file::FormatError,
};

/// A mesh in the scene's space.
pub struct Placed {
    pub mesh: usize,
    pub place: DAffine3,
}

/// The meshes of the nodes of the document's scene, or of all roots where it names none.
///
/// # Errors
/// When an index leads nowhere, or a node has two parents.
pub fn meshes(document: &Document) -> Result<Vec<Placed>, FormatError> {
    let roots: Vec<usize> = match document.scenes.get(document.scene.unwrap_or_default()) {
        Some(scene) => scene.nodes.clone(),
        None => {
            let mut is_root = vec![true; document.nodes.len()];
            for &child in document.nodes.iter().flat_map(|node| &node.children) {
                if let Some(root) = is_root.get_mut(child) {
                    *root = false;
                }
            }
            let indices = (0..document.nodes.len()).filter(|&index| is_root[index]);
            indices.collect()
        }
    };
    let mut seen = vec![false; document.nodes.len()];
    let mut waiting: Vec<Waiting> = roots
        .into_iter()
        .map(|node| Waiting {
            node,
            parent: DAffine3::IDENTITY,
        })
        .collect();
    waiting.reverse();
    let mut placed = vec![];
    while let Some(Waiting {
        node: index,
        parent,
    }) = waiting.pop()
    {
        let node = entry(&document.nodes, index, "node")?;
        if std::mem::replace(&mut seen[index], true) {
            return Err(FormatError::container(
                format!("node {index} twice in the scene"),
                "a tree of nodes",
            ));
        }
        let place = parent * of(node)?;
        if let Some(mesh) = node.mesh {
            placed.push(Placed { mesh, place });
        }
        let children = node.children.iter().rev();
        waiting.extend(children.map(|&node| Waiting {
            node,
            parent: place,
        }));
    }
    Ok(placed)
}

/// A node that is still to be visited, and where its parent is.
struct Waiting {
    node: usize,
    parent: DAffine3,
}

/// A node's own transform.
fn of(node: &Node) -> Result<DAffine3, FormatError> {
    let place = match node.matrix {
        Some(matrix) => DAffine3::from_mat4(DMat4::from_cols_array(&matrix)),
        None => DAffine3::from_scale_rotation_translation(
            node.scale.map_or(DVec3::ONE, DVec3::from),
            node.rotation
                .map_or(DQuat::IDENTITY, DQuat::from_array)
                .normalize(),
            node.translation.map_or(DVec3::ZERO, DVec3::from),
        ),
    };
    if place.is_finite() {
        Ok(place)
    } else {
        Err(FormatError::container(
            "a node's transform that is not finite",
            "finite numbers",
        ))
    }
}
