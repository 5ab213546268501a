//! A Wavefront OBJ in; vertices, texture coordinates and the triangles of each group out.

use super::text::{Error, Line};
use glam::{DVec2, DVec3};
use std::path::Path;

/// A corner of a face: vertex and texture coordinate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Corner {
    pub vertex: u32,
    /// None where the file gives none.
    pub uv: Option<u32>,
}

/// The triangles under one group name.
#[derive(Clone, Debug, PartialEq)]
pub struct Group {
    pub name: String,
    pub triangles: Vec<[Corner; 3]>,
}

/// A mesh as its file has it. Every index of a face is in range.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Obj {
    pub positions: Vec<DVec3>,
    pub uvs: Vec<DVec2>,
    /// One entry a name, in the order of first use.
    pub groups: Vec<Group>,
}

impl Obj {
    /// Faces with more than three corners become fans; lines other than `v`, `vt`, `g` and `f` are passed over.
    pub fn parse(file: &Path, text: &str) -> Result<Self, Error> {
        let mut obj = Self::default();
        let mut group = None;
        for line in Line::all(file, text) {
            let mut words = line.words();
            match words.next() {
                Some("v") => obj.positions.push(line.point(&mut words)?.into()),
                Some("vt") => obj
                    .uvs
                    .push(DVec2::new(line.real(&mut words, "two texture coordinates")?, line.real(&mut words, "two texture coordinates")?)),
                Some("g") => group = Some(obj.group_index(words.next().unwrap_or("default"))),
                Some("f") => {
                    let corners = words.map(|word| obj.corner(line, word)).collect::<Result<Vec<_>, _>>()?;
                    if corners.len() < 3 {
                        return Err(line.error(format!("a face of {} corners", corners.len()), "three or more"));
                    }
                    let index = *group.get_or_insert_with(|| obj.group_index("default"));
                    obj.groups[index].triangles.extend((2..corners.len()).map(|k| [corners[0], corners[k - 1], corners[k]]));
                }
                _ => {}
            }
        }
        Ok(obj)
    }

    /// The triangles of a group, none where the file has no such group.
    pub fn group(&self, name: &str) -> &[[Corner; 3]] {
        self.groups.iter().find(|group| group.name == name).map_or(&[], |group| &group.triangles)
    }

    fn group_index(&mut self, name: &str) -> usize {
        self.groups.iter().position(|group| group.name == name).unwrap_or_else(|| {
            self.groups.push(Group { name: name.to_owned(), triangles: Vec::new() });
            self.groups.len() - 1
        })
    }

    fn corner(&self, line: Line, word: &str) -> Result<Corner, Error> {
        let mut fields = word.split('/');
        let vertex = index(line, fields.next(), self.positions.len(), "vertex")?;
        let uv = match fields.next() {
            None | Some("") => None,
            field => Some(index(line, field, self.uvs.len(), "texture coordinate")?),
        };
        Ok(Corner { vertex, uv })
    }
}

/// OBJ counts from 1.
fn index(line: Line, field: Option<&str>, len: usize, what: &str) -> Result<u32, Error> {
    let expected = format!("a {what} from 1 to {len}");
    let number: u32 = line.number(field, &expected)?;
    if number >= 1 && number as usize <= len { Ok(number - 1) } else { Err(line.error(format!("{what} {number}"), expected)) }
}
