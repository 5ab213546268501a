//! The contents of mmlphuman's checkpoint, in numbers.

use super::text::{line, thousands};
use effigy_formats::mmlphuman::Checkpoint;
use serde::Serialize;
use std::fmt;

/// A checkpoint's counts.
#[derive(Serialize)]
pub struct CheckpointSummary {
    kind: &'static str,
    /// Steps of training, where the file says.
    iteration: Option<f64>,
    gaussians: usize,
    /// Networks, one an anchor.
    networks: usize,
    /// Numbers that enter a network, then those that leave each layer.
    widths: Vec<usize>,
    nodes: usize,
    /// Basis functions of Gaussians, and of nodes.
    basis: [usize; 2],
    /// Whether the pose changes Gaussians, and moves nodes.
    follows_pose: [bool; 2],
    joints: usize,
    /// Training poses.
    poses: usize,
    /// Degree of the spherical harmonics that count.
    harmonics: usize,
}

impl CheckpointSummary {
    pub fn new(checkpoint: &Checkpoint) -> Self {
        Self {
            kind: "checkpoint of mmlphuman",
            iteration: checkpoint.iteration,
            gaussians: checkpoint.len(),
            networks: checkpoint.networks.count,
            widths: checkpoint.networks.widths.clone(),
            nodes: checkpoint.nodes.position.len(),
            basis: [checkpoint.basis, checkpoint.node_basis],
            follows_pose: [checkpoint.bases.is_some(), checkpoint.nodes.basis.is_some()],
            joints: checkpoint.skeleton.len(),
            poses: checkpoint.poses.len(),
            harmonics: usize::from(!checkpoint.gaussians.harmonics.is_empty()),
        }
    }

    /// In a line.
    pub fn brief(&self) -> String {
        format!(
            "{} Gaussians, {} networks, {} nodes, {} training poses",
            thousands(self.gaussians),
            self.networks,
            thousands(self.nodes),
            thousands(self.poses)
        )
    }
}

impl fmt::Display for CheckpointSummary {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        line(
            f,
            "checkpoint",
            "of mmlphuman's training; `effigy import` makes an avatar of it",
        )?;
        if let Some(iteration) = self.iteration {
            line(f, "iteration", format_args!("{iteration:.0}"))?;
        }
        line(f, "Gaussians", thousands(self.gaussians))?;
        let widths: Vec<String> = self.widths.iter().map(usize::to_string).collect();
        line(
            f,
            "networks",
            format_args!("{}, {} wide", self.networks, widths.join("-")),
        )?;
        line(f, "nodes", thousands(self.nodes))?;
        let follows = |yes: bool| if yes { "" } else { ", not in use yet" };
        line(
            f,
            "basis",
            format_args!(
                "{} of Gaussians{}, {} of nodes{}",
                self.basis[0],
                follows(self.follows_pose[0]),
                self.basis[1],
                follows(self.follows_pose[1])
            ),
        )?;
        line(f, "joints", self.joints)?;
        line(
            f,
            "poses",
            format_args!("{} of training", thousands(self.poses)),
        )?;
        line(f, "harmonics", format_args!("degree {}", self.harmonics))
    }
}
