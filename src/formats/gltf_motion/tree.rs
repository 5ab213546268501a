//! The tree of a file's nodes, and where its joints are at rest.

use super::curve::rows;
use crate::{
    gltf::{
        Document, GltfFile,
        document::{Shape, Skin},
    },
    scene_tree::{Place, SceneTree},
};
use effigy_core::io::file::FormatError;
use glam::{DMat4, DVec3, DVec4};
use std::collections::{BTreeMap, BTreeSet};

/// How far the bind pose may be from the nodes' before it counts as another: radians, and a share
/// of a bone's length.
const SAME_TURN: f64 = 0.02;
const SAME_PLACE: f64 = 0.02;

/// None: the matrix has no inverse, or numbers that are not finite.
fn from_matrix(matrix: DMat4) -> Option<Place> {
    let whole = matrix.is_finite() && matrix.determinant().abs() > 1e-30;
    let (scale, rotation, translation) = whole.then_some(matrix)?.to_scale_rotation_translation();
    Place::new(translation, rotation.into(), scale)
}

fn differ(a: &Place, b: &Place) -> bool {
    let length = a.translation.length().max(b.translation.length());
    a.rotation.angle_between(b.rotation) > SAME_TURN
        || a.translation.distance(b.translation) > SAME_PLACE * length + 1e-6
}

/// The nodes of a file.
pub struct NodeTree {
    pub nodes: SceneTree,
    /// Nodes whose scale differs from axis to axis or mirrors.
    pub odd_scales: usize,
}

impl NodeTree {
    pub fn read(document: &Document) -> Result<Self, FormatError> {
        let count = document.nodes.len();
        let mut odd_scales = 0;
        let mut tree = SceneTree {
            parent: vec![None; count],
            order: Vec::with_capacity(count),
            place: Vec::with_capacity(count),
        };
        for (at, node) in document.nodes.iter().enumerate() {
            let fault = |found: &str, expected: &str| {
                FormatError::metadata(&format!("nodes[{at}]"), found, expected)
            };
            for &child in &node.children {
                let parent = tree.parent.get_mut(child as usize);
                match parent {
                    Some(parent) if parent.is_none() => *parent = Some(at),
                    _ => {
                        return Err(fault(
                            &format!("a child {child}"),
                            "children that are nodes, each of one parent",
                        ));
                    }
                }
            }
            let place = match &node.matrix {
                Some(matrix) => from_matrix(DMat4::from_cols_array(matrix)),
                None => {
                    let rotation = node.rotation.map_or(DVec4::W, DVec4::from);
                    let scale = DVec3::from(node.scale.unwrap_or([1.0; 3]));
                    let even = scale.max_element() - scale.min_element()
                        <= 1e-3 * scale.abs().max_element();
                    odd_scales += usize::from(!even || scale.min_element() < 0.0);
                    let translation = DVec3::from(node.translation.unwrap_or_default());
                    Place::new(translation, rotation, scale)
                }
            };
            let place = place.filter(|place| place.scale < 1e9);
            tree.place.push(place.ok_or_else(|| {
                fault("a transform that is none", "finite numbers, and a rotation")
            })?);
        }
        let roots = (0..count).filter(|&node| tree.parent[node].is_none());
        let mut open: Vec<usize> = roots.collect();
        open.reverse();
        while let Some(node) = open.pop() {
            tree.order.push(node);
            let children = document.nodes[node].children.iter().rev();
            open.extend(children.map(|&child| child as usize));
        }
        if tree.order.len() < count {
            return Err(FormatError::metadata(
                "nodes",
                "a node that is its own ancestor",
                "trees",
            ));
        }
        Ok(Self {
            nodes: tree,
            odd_scales,
        })
    }
}

/// Moves nodes to where they are when their skin is as it was made: each joint whose parent is a
/// joint of the same skin, by the skin's inverse bind matrices. Gives how many nodes say otherwise.
pub fn bind(
    source: &GltfFile,
    skins: &[Skin],
    tree: &SceneTree,
    rest: &mut [Place],
) -> Result<usize, FormatError> {
    let mut elsewhere = BTreeSet::new();
    for skin in skins {
        let Some(accessor) = skin.inverse_bind_matrices else {
            continue;
        };
        let matrices = rows::<16>(source, accessor, Shape::Mat4, skin.joints.len() as u64)?;
        let mut inverse = BTreeMap::new();
        for (&joint, matrix) in skin.joints.iter().zip(matrices) {
            let matrix = DMat4::from_cols_array(&matrix.map(f64::from));
            inverse.insert(joint as usize, matrix);
        }
        for (&joint, own) in &inverse {
            let parent = tree.parent.get(joint).copied().flatten();
            let Some(outer) = parent.and_then(|parent| inverse.get(&parent)) else {
                continue;
            };
            // Matrices take the mesh to the joint, so the parent's takes the joint's inverse to it.
            let place = from_matrix(*own).and_then(|_| from_matrix(outer * own.inverse()));
            let Some(place) = place else {
                return Err(FormatError::metadata(
                    &format!("accessors[{accessor}]"),
                    "a matrix without an inverse",
                    "inverse bind matrices",
                ));
            };
            if differ(&place, &tree.place[joint]) {
                elsewhere.insert(joint);
            }
            rest[joint] = place;
        }
    }
    Ok(elsewhere.len())
}
