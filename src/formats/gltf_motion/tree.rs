//! Nodes of a scene as joints: which are kept, and where they are at rest.

use super::{
    accessor::Source,
    document::{Document, Shape},
};
use effigy_core::io::file::FormatError;
use glam::{DMat4, DQuat, DVec3, DVec4};

/// How far the bind pose may be from the nodes' before it counts as another: radians, and a share
/// of a bone's length.
const SAME_TURN: f64 = 0.02;
const SAME_PLACE: f64 = 0.02;

/// A node's place relative to its parent. Scale is the same along each axis.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    pub translation: DVec3,
    pub rotation: DQuat,
    pub scale: f64,
}

impl Place {
    /// Where something is, in the axes that `self` is in; a scale of the outside is kept.
    pub fn then(&self, inner: &Self) -> Self {
        Self {
            translation: self.translation + self.rotation * (self.scale * inner.translation),
            rotation: self.rotation * inner.rotation,
            scale: self.scale * inner.scale,
        }
    }

    /// None: the matrix has no inverse, or numbers that are not finite.
    fn from_matrix(matrix: DMat4) -> Option<Self> {
        let determinant = matrix.determinant();
        let whole = matrix.is_finite() && determinant.abs() > 1e-30;
        let (scale, rotation, translation) =
            whole.then_some(matrix)?.to_scale_rotation_translation();
        let scale = (scale.x * scale.y * scale.z).abs().cbrt();
        let place = Self {
            translation,
            rotation,
            scale,
        };
        (rotation.is_finite() && scale.is_finite()).then_some(place)
    }

    fn differs(&self, other: &Self) -> bool {
        let length = self.translation.length().max(other.translation.length());
        self.rotation.angle_between(other.rotation) > SAME_TURN
            || self.translation.distance(other.translation) > SAME_PLACE * length + 1e-6
    }
}

/// The nodes of a file.
pub struct Tree {
    pub parent: Vec<Option<usize>>,
    /// Every node after its parent.
    pub order: Vec<usize>,
    /// As the nodes say.
    pub place: Vec<Place>,
    /// Nodes whose scale differs from axis to axis or mirrors.
    pub odd_scales: usize,
}

impl Tree {
    pub fn read(document: &Document) -> Result<Self, FormatError> {
        let count = document.nodes.len();
        let mut tree = Self {
            parent: vec![None; count],
            order: Vec::with_capacity(count),
            place: Vec::with_capacity(count),
            odd_scales: 0,
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
                Some(matrix) => Place::from_matrix(DMat4::from_cols_array(matrix)),
                None => {
                    let rotation = node.rotation.map_or(DVec4::W, DVec4::from);
                    let scale = DVec3::from(node.scale.unwrap_or([1.0; 3]));
                    let even = scale.max_element() - scale.min_element()
                        <= 1e-3 * scale.abs().max_element();
                    tree.odd_scales += usize::from(!even || scale.min_element() < 0.0);
                    rotation.try_normalize().map(|rotation| Place {
                        translation: DVec3::from(node.translation.unwrap_or_default()),
                        rotation: DQuat::from_vec4(rotation),
                        scale: scale.element_product().abs().cbrt(),
                    })
                }
            };
            let whole = place.filter(|place| {
                place.translation.is_finite() && place.scale.is_finite() && place.scale < 1e9
            });
            tree.place.push(whole.ok_or_else(|| {
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
        Ok(tree)
    }

    /// Nodes from one up to its root, itself first.
    pub fn upward(&self, node: usize) -> impl Iterator<Item = usize> {
        std::iter::successors(Some(node), |&node| self.parent[node])
    }

    /// Which nodes are `marked`, or between two that are.
    pub fn with_ancestors(&self, marked: &[bool]) -> Vec<bool> {
        let mut above = marked.to_vec();
        for &node in self.order.iter().rev() {
            if let Some(parent) = self.parent[node]
                && above[node]
            {
                above[parent] = true;
            }
        }
        above
    }
}

/// Where nodes are when their skin is as it was made.
pub struct Bind {
    pub place: Vec<Place>,
    /// Joints whose nodes say otherwise.
    pub differ: usize,
}

/// The pose of the skins' inverse bind matrices: of each joint whose parent is a joint of the same
/// skin. Other nodes are where they say.
pub fn bind(source: &Source, tree: &Tree) -> Result<Bind, FormatError> {
    let mut bind = Bind {
        place: tree.place.clone(),
        differ: 0,
    };
    for skin in &source.document.skins {
        let Some(accessor) = skin.inverse_bind else {
            continue;
        };
        let numbers = source.numbers(accessor, Shape::Mat4, skin.joints.len() as u64)?;
        let mut inverse = std::collections::BTreeMap::new();
        for (&joint, matrix) in skin.joints.iter().zip(numbers.as_chunks::<16>().0) {
            let matrix = DMat4::from_cols_array(&matrix.map(f64::from));
            inverse.insert(joint as usize, matrix);
        }
        for (&joint, own) in &inverse {
            let parent = tree.parent.get(joint).copied().flatten();
            let Some(outer) = parent.and_then(|parent| inverse.get(&parent)) else {
                continue;
            };
            // Matrices take the mesh to the joint, so the parent's takes the joint's inverse to it.
            let place =
                Place::from_matrix(*own).and_then(|_| Place::from_matrix(outer * own.inverse()));
            let Some(place) = place else {
                return Err(FormatError::metadata(
                    &format!("accessors[{accessor}]"),
                    "a matrix without an inverse",
                    "inverse bind matrices",
                ));
            };
            bind.differ += usize::from(place.differs(&tree.place[joint]));
            bind.place[joint] = place;
        }
    }
    Ok(bind)
}
