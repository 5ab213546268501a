//! An avatar as a device holds it, packed on the host by all of its cores. That needs no device: it
//! can go on while one is opened.

use super::{FrameBlock, pack};
use crate::{avatar::Avatar, each};

/// A set of Gaussians: an avatar's own, or those of a level.
#[derive(Clone)]
pub struct PackedSet {
    /// In the canonical pose; see [`pack::gaussians`].
    pub gaussians: Vec<[u32; 2]>,
    /// Basis rows of their correctives; see [`pack::rows`].
    pub rows: Vec<u32>,
    /// The uniform block with all that no frame changes.
    pub constants: Box<FrameBlock>,
}

impl PackedSet {
    fn new(avatar: &Avatar, node_places: &[u16]) -> Self {
        Self {
            gaussians: pack::gaussians(avatar, node_places),
            rows: pack::rows(avatar),
            constants: Box::new(pack::constants(avatar)),
        }
    }
}

/// A model, packed.
#[derive(Clone)]
pub struct PackedModel {
    /// Weights and biases; see [`pack::networks`].
    pub networks: Vec<u32>,
    /// Position nodes; see [`pack::nodes`].
    pub nodes: Vec<u32>,
    /// Each part's first node, and their number.
    pub node_starts: Vec<u32>,
    /// Where each of the avatar's nodes is among the packed ones, which are in the order of their
    /// parts.
    pub node_places: Vec<u16>,
    /// The Gaussians of the avatar, then those of its levels, the finest first.
    pub sets: Vec<PackedSet>,
}

impl PackedModel {
    /// Packs an avatar.
    ///
    /// # Panics
    /// Where [`Avatar::check`] finds a fault.
    pub fn new(avatar: &Avatar) -> Self {
        let (node_places, node_starts) = pack::node_places(avatar);
        let sets = || {
            let own = PackedSet::new(avatar, &node_places);
            let levels = avatar.levels.iter().map(|level| {
                let places: &[u16] = if level.correctives {
                    &node_places
                } else {
                    &[0]
                };
                PackedSet::new(&avatar.at_level(level), places)
            });
            std::iter::once(own).chain(levels).collect::<Vec<_>>()
        };
        let networks = || {
            let networks = pack::networks(avatar, &pack::constants(avatar));
            (networks, pack::nodes(avatar, &node_places))
        };
        let (sets, (networks, nodes)) = each::join(sets, networks);
        Self {
            networks,
            nodes,
            node_starts,
            node_places,
            sets,
        }
    }
}
