//! MakeHuman's `.target` files: one displaced vertex a line, in the mesh's own unit.

use crate::bake::source::text::{SourceError, TextLine};
use glam::DVec3;
use std::path::Path;

/// A shape's or an expression's displacements.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MorphTarget {
    /// Vertices and how far each moves.
    pub displacements: Vec<(u32, DVec3)>,
}

impl MorphTarget {
    /// Reads a file's text; `file` is named in errors. `vertices`: how many the mesh has.
    ///
    /// # Errors
    /// When a line is malformed, or names a vertex that is not there.
    pub fn parse(file: &Path, text: &str, vertices: usize) -> Result<Self, SourceError> {
        let mut displacements = Vec::new();
        for line in TextLine::all(file, text) {
            let mut words = line.words();
            let vertex: u32 = line.number(words.next(), "a vertex number")?;
            if vertex as usize >= vertices {
                return Err(line.error(format!("vertex {vertex}"), format!("one below {vertices}")));
            }
            displacements.push((vertex, line.point(&mut words)?.into()));
        }
        Ok(Self { displacements })
    }

    /// Adds the displacements, scaled, to a mesh's vertices.
    pub fn apply(&self, positions: &mut [DVec3], scale: f64) {
        for &(vertex, by) in &self.displacements {
            positions[vertex as usize] += scale * by;
        }
    }
}
