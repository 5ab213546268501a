//! Wavefront OBJ files: vertices, texture coordinates and the triangles of each group.

use crate::bake::source::text::{SourceError, TextLine};
use glam::{DVec2, DVec3};
use std::path::Path;

/// A corner of a face: vertex and texture coordinate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Corner {
    /// An index into [`Obj::positions`].
    pub vertex: u32,
    /// None where the file gives none.
    pub uv: Option<u32>,
}

/// The triangles under one group name.
#[derive(Clone, Debug, PartialEq)]
pub struct ObjGroup {
    /// The name after `g`.
    pub name: String,
    /// In the file's order.
    pub triangles: Vec<[Corner; 3]>,
}

/// A mesh as in its file. Every index of a face is in range.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Obj {
    /// In the file's unit.
    pub positions: Vec<DVec3>,
    /// Texture coordinates from the lower left corner.
    pub uvs: Vec<DVec2>,
    /// One entry a name, in the order of first use.
    pub groups: Vec<ObjGroup>,
}

impl Obj {
    /// Reads a file's text; `file` is named in errors. Faces with more than three corners become
    /// fans; lines other than `v`, `vt`, `g` and `f` are ignored.
    ///
    /// # Errors
    /// When a line is malformed, or a face names a vertex that is not there.
    pub fn parse(file: &Path, text: &str) -> Result<Self, SourceError> {
        let mut obj = Self::default();
        let mut group = None;
        for line in TextLine::all(file, text) {
            let mut words = line.words();
            match words.next() {
                Some("v") => obj.positions.push(line.point(&mut words)?.into()),
                Some("vt") => obj.uvs.push(DVec2::new(
                    line.real(&mut words, "two texture coordinates")?,
                    line.real(&mut words, "two texture coordinates")?,
                )),
                Some("g") => group = Some(obj.group_index(words.next().unwrap_or("default"))),
                Some("f") => {
                    let corners = words
                        .map(|word| obj.corner(line, word))
                        .collect::<Result<Vec<_>, _>>()?;
                    if corners.len() < 3 {
                        return Err(line.error(
                            format!("a face of {} corners", corners.len()),
                            "three or more",
                        ));
                    }
                    let index = match group {
                        Some(index) => index,
                        None => obj.group_index("default"),
                    };
                    group = Some(index);
                    for k in 2..corners.len() {
                        let triangle = [corners[0], corners[k - 1], corners[k]];
                        obj.groups[index].triangles.push(triangle);
                    }
                }
                _ => {}
            }
        }
        Ok(obj)
    }

    /// The triangles of a group; empty if the file has no such group.
    pub fn group(&self, name: &str) -> &[[Corner; 3]] {
        self.groups
            .iter()
            .find(|group| group.name == name)
            .map_or(&[], |group| &group.triangles)
    }

    /// The index of a group, which is added if it is new.
    fn group_index(&mut self, name: &str) -> usize {
        if let Some(index) = self.groups.iter().position(|group| group.name == name) {
            return index;
        }
        self.groups.push(ObjGroup {
            name: name.to_owned(),
            triangles: Vec::new(),
        });
        self.groups.len() - 1
    }

    fn corner(&self, line: TextLine, word: &str) -> Result<Corner, SourceError> {
        let mut fields = word.split('/');
        let vertex = index(line, fields.next(), self.positions.len(), "vertex")?;
        let uv = match fields.next() {
            None | Some("") => None,
            field => Some(index(line, field, self.uvs.len(), "texture coordinate")?),
        };
        Ok(Corner { vertex, uv })
    }
}

/// An index of a list of length `len`; OBJ counts from 1.
fn index(line: TextLine, field: Option<&str>, len: usize, what: &str) -> Result<u32, SourceError> {
    let expected = format!("a {what} from 1 to {len}");
    let number: u32 = line.number(field, &expected)?;
    if number >= 1 && number as usize <= len {
        Ok(number - 1)
    } else {
        Err(line.error(format!("{what} {number}"), expected))
    }
}
