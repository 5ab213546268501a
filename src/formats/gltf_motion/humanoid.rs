//! Names that VRM gives the bones of a human.

use crate::gltf::document::Extensions;
use std::collections::BTreeMap;

/// The bones of a VRM file of so many nodes, by their nodes, with the names of VRM 1.0; none where
/// it is no VRM.
pub fn bones(extensions: &Extensions, nodes: usize) -> BTreeMap<usize, String> {
    let newer = [&extensions.animation, &extensions.vrm_1];
    let newer = newer.into_iter().flatten();
    let newer = newer.filter_map(|vrm| vrm.humanoid.as_ref());
    let mut bones: BTreeMap<usize, String> = newer
        .flat_map(|humanoid| &humanoid.human_bones)
        .map(|(name, bone)| (bone.node as usize, name.clone()))
        .collect();
    let older = extensions.vrm_0.as_ref();
    let older = older.and_then(|vrm| vrm.humanoid.as_ref());
    if let (Some(humanoid), true) = (older, bones.is_empty()) {
        let named = humanoid.human_bones.0.iter();
        bones.extend(named.map(|bone| (bone.node as usize, renamed(&bone.bone))));
    }
    bones.retain(|&node, _| node < nodes);
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
