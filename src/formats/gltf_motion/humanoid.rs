//! Names that VRM gives the bones of a human.

use super::document::Document;

/// A node and the bone that it is.
pub struct Bone {
    pub name: String,
    pub node: usize,
}

/// The bones of a VRM file, by the names of VRM 1.0; none where it is no VRM.
pub fn bones(document: &Document) -> Vec<Bone> {
    let extensions = &document.extensions;
    let newer = [&extensions.animation, &extensions.vrm_1]
        .into_iter()
        .flatten();
    let mut bones = vec![];
    for humanoid in newer.filter_map(|vrm| vrm.humanoid.as_ref()) {
        bones.extend(humanoid.bones.iter().map(|(name, bone)| Bone {
            name: name.clone(),
            node: bone.node as usize,
        }));
    }
    let older = extensions
        .vrm_0
        .as_ref()
        .and_then(|vrm| vrm.humanoid.as_ref());
    if let (Some(humanoid), true) = (older, bones.is_empty()) {
        bones.extend(humanoid.bones.iter().map(|bone| Bone {
            name: renamed(&bone.bone),
            node: bone.node as usize,
        }));
    }
    bones.retain(|bone| bone.node < document.nodes.len());
    bones
}

/// VRM 1.0 names the joints of a thumb by other bones than 0.x did.
fn renamed(name: &str) -> String {
    for side in ["left", "right"] {
        match name.strip_prefix(side) {
            Some("ThumbProximal") => return format!("{side}ThumbMetacarpal"),
            Some("ThumbIntermediate") => return format!("{side}ThumbProximal"),
            _ => {}
        }
    }
    name.into()
}
