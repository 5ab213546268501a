//! Files to read: vertices from a seed, changed as a test likes, written in any encoding.

use crate::common::Random;
use effigy_core::{avatar::Avatar, io::ply};

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Encoding {
    Ascii,
    Little,
    Big,
}

/// Names and numbers of a file's vertices.
#[derive(Clone)]
pub struct Table {
    pub names: Vec<String>,
    pub rows: Vec<Vec<f32>>,
}

impl Table {
    /// Gaussians from a seed, with harmonics of a degree, in 3DGS's order.
    pub fn new(seed: u64, count: usize, degree: usize) -> Self {
        let random = &mut Random(seed);
        let fixed = |names: &str| names.split(' ').map(str::to_owned).collect::<Vec<_>>();
        let rest = 3 * ((degree + 1).pow(2) - 1);
        let mut names = fixed("x y z nx ny nz f_dc_0 f_dc_1 f_dc_2");
        names.extend((0..rest).map(|k| format!("f_rest_{k}")));
        names.extend(fixed(
            "opacity scale_0 scale_1 scale_2 rot_0 rot_1 rot_2 rot_3",
        ));
        let mut row = || {
            let mut row = random.vector(1.0).to_array().to_vec();
            row.extend([0.0; 3]);
            row.extend(
                (0..3 + rest).map(|k| random.range(-1.0, 1.0) * if k < 3 { 1.5 } else { 0.3 }),
            );
            row.push(random.range(-3.0, 5.0));
            row.extend((0..3).map(|_| random.range(-5.0, -3.0)));
            row.extend((0..4).map(|_| random.range(-2.0, 2.0)));
            row.into_iter().map(|v| v as f32).collect()
        };
        Self {
            rows: (0..count).map(|_| row()).collect(),
            names,
        }
    }

    pub fn column(&self, name: &str) -> usize {
        self.names.iter().position(|known| known == name).unwrap()
    }

    pub fn set(mut self, row: usize, name: &str, value: f32) -> Self {
        let column = self.column(name);
        self.rows[row][column] = value;
        self
    }

    pub fn without(mut self, name: &str) -> Self {
        let column = self.column(name);
        self.names.remove(column);
        self.rows.iter_mut().for_each(|row| {
            row.remove(column);
        });
        self
    }

    /// The same with its properties in another order.
    pub fn shuffled(mut self) -> Self {
        let turn = self.names.len() / 3;
        self.names.rotate_left(turn);
        self.names.swap(0, 5);
        for row in &mut self.rows {
            row.rotate_left(turn);
            row.swap(0, 5);
        }
        self
    }

    pub fn header(&self, encoding: Encoding, count: usize) -> String {
        let format = match encoding {
            Encoding::Ascii => "ascii",
            Encoding::Little => "binary_little_endian",
            Encoding::Big => "binary_big_endian",
        };
        let properties: String = self
            .names
            .iter()
            .map(|name| format!("property float {name}\n"))
            .collect();
        format!("ply\nformat {format} 1.0\nelement vertex {count}\n{properties}end_header\n")
    }

    pub fn bytes(&self, encoding: Encoding) -> Vec<u8> {
        let mut bytes = self.header(encoding, self.rows.len()).into_bytes();
        for row in &self.rows {
            match encoding {
                Encoding::Ascii => {
                    let words: Vec<String> = row.iter().map(f32::to_string).collect();
                    bytes.extend(format!("{}\n", words.join(" ")).into_bytes());
                }
                Encoding::Little => bytes.extend(row.iter().flat_map(|v| v.to_le_bytes())),
                Encoding::Big => bytes.extend(row.iter().flat_map(|v| v.to_be_bytes())),
            }
        }
        bytes
    }

    pub fn read(&self, encoding: Encoding) -> Result<Avatar, String> {
        read(&self.bytes(encoding))
    }
}

pub fn read(bytes: &[u8]) -> Result<Avatar, String> {
    ply::from_bytes(bytes, "test", None).map_err(|fault| fault.to_string())
}
