//! A MakeHuman `.target` in (one displaced vertex a line); displacements out, in the mesh's own unit.

use super::text::{Error, Line};
use glam::DVec3;
use std::path::Path;

/// A shape's or an expression's displacements.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Target {
    pub moves: Vec<(u32, DVec3)>,
}

impl Target {
    /// `vertices` is the length of the mesh that the target is for.
    pub fn parse(file: &Path, text: &str, vertices: usize) -> Result<Self, Error> {
        let mut moves = Vec::new();
        for line in Line::all(file, text) {
            let mut words = line.words();
            let vertex: u32 = line.number(words.next(), "a vertex number")?;
            if vertex as usize >= vertices {
                return Err(line.error(format!("vertex {vertex}"), format!("one below {vertices}")));
            }
            moves.push((vertex, line.point(&mut words)?.into()));
        }
        Ok(Self { moves })
    }

    /// Adds the displacements, scaled, to a mesh's vertices.
    pub fn apply(&self, positions: &mut [DVec3], scale: f64) {
        for &(vertex, by) in &self.moves {
            positions[vertex as usize] += scale * by;
        }
    }
}
