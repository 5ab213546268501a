//! Reading and writing avatars and clips.

use super::{
    container,
    disk::{read_with, write_encoded},
    document::HeaderDocument,
    encode,
    error::{FileError, FormatError},
    header::{AvatarHeader, ClipHeader},
    order::{self, Neutral},
    sets,
    tensors::TensorInfo,
};
use crate::avatar::{Avatar, Clip, Gaussians, Level, ShCoefficients, limits};
use std::path::Path;

/// The content of a file of either kind.
#[derive(Clone, Debug, PartialEq)]
pub enum FileContent {
    /// An avatar.
    Avatar(Box<Avatar>),
    /// A clip of motion.
    Clip(Box<Clip>),
}

impl FileContent {
    /// Reads a file of either kind, told apart by its content.
    ///
    /// # Errors
    /// When the file cannot be opened, is neither, or breaks a rule of [`super::format`].
    pub fn read(path: &Path) -> Result<Self, FileError> {
        read_with(path, Self::from_bytes)
    }

    /// Reads the content from a file's bytes, at any alignment.
    ///
    /// # Errors
    /// When the bytes are neither, or break a rule.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, FormatError> {
        if Self::is_clip(bytes)? {
            Ok(Self::Clip(Box::new(container::decode::<ClipHeader>(
                bytes,
            )?)))
        } else {
            let avatar = container::decode::<AvatarHeader>(bytes)?;
            Ok(Self::Avatar(Box::new(avatar)))
        }
    }

    /// Whether a file's bytes say that they are a clip, not an avatar.
    ///
    /// # Errors
    /// When they are neither.
    pub fn is_clip(bytes: &[u8]) -> Result<bool, FormatError> {
        container::has_format::<ClipHeader>(bytes)
    }
}

/// Lists the tensors of a file of either kind.
///
/// # Errors
/// When the file cannot be opened, is neither, or breaks a rule.
pub fn tensors(path: &Path) -> Result<Vec<TensorInfo>, FileError> {
    read_with(path, tensors_of)
}

/// The tensors in a file's bytes, at any alignment.
///
/// # Errors
/// When the bytes are neither, or break a rule.
pub fn tensors_of(bytes: &[u8]) -> Result<Vec<TensorInfo>, FormatError> {
    if container::has_format::<ClipHeader>(bytes)? {
        container::list::<ClipHeader>(bytes)
    } else {
        container::list::<AvatarHeader>(bytes)
    }
}

/// Checks view-dependent colours of some Gaussians.
fn check_harmonics(sh: Option<&ShCoefficients>, gaussians: &Gaussians) -> Result<(), FormatError> {
    let Some(sh) = sh else {
        return Ok(());
    };
    let fault = |found, expected| {
        Err(FormatError::Tensor {
            tensor: "sh".into(),
            found,
            expected,
        })
    };
    if !(1..=limits::HARMONICS).contains(&sh.degree) {
        let found = format!("degree {}", sh.degree);
        return fault(found, format!("1 to {}", limits::HARMONICS));
    }
    let expected = gaussians.len() * sh.functions();
    if sh.coefficients.len() != expected {
        return fault(
            format!("{} coefficients", sh.coefficients.len()),
            format!("{expected}, {} a Gaussian", sh.functions()),
        );
    }
    Ok(())
}

impl Avatar {
    /// Reads an avatar file. Every rule in [`super::format`] is checked before memory is taken for
    /// the avatar.
    ///
    /// # Errors
    /// When the file cannot be opened, is not an avatar, or breaks a rule.
    pub fn read(path: &Path) -> Result<Self, FileError> {
        read_with(path, Self::from_bytes)
    }

    /// Reads an avatar from a file's bytes, at any alignment.
    ///
    /// # Errors
    /// When the bytes are not an avatar or break a rule.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, FormatError> {
        container::decode::<AvatarHeader>(bytes)
    }

    /// Checks what everything that draws or evaluates an avatar relies on: arrays of lengths that
    /// agree, indices of what is there, numbers and sizes in range. It holds of every avatar that
    /// was read from a file.
    ///
    /// # Errors
    /// When it does not hold, with what was found and what is expected.
    pub fn check(&self) -> Result<(), FormatError> {
        let header = AvatarHeader::from_model(self);
        header.check_drawn()?;
        let layers = self.networks.layers.iter().zip(&header.widths);
        for (at, (layer, &width)) in layers.enumerate() {
            if layer.input != width {
                let found = format!("{} inputs of layer {at}", layer.input);
                return Err(FormatError::metadata("widths", found, width));
            }
        }
        // Their lengths first: their planes can't be told apart by another.
        check_harmonics(self.sh.as_ref(), &self.gaussians)?;
        self.check_levels(Self::check_level_harmonics)?;
        container::check_arrays(&header, self)?;
        self.check_levels(Self::check_level)
    }

    /// Checks each level.
    fn check_levels(
        &self,
        check: impl Fn(&Self, &Level) -> Result<(), FormatError>,
    ) -> Result<(), FormatError> {
        for (index, level) in self.levels.iter().enumerate() {
            check(self, level).map_err(|error| error.within(&sets::prefix(index + 1)))?;
        }
        Ok(())
    }

    /// Checks that a level has colours of the avatar's kind.
    fn check_level_harmonics(&self, level: &Level) -> Result<(), FormatError> {
        let degree = |sh: &Option<ShCoefficients>| sh.as_ref().map_or(0, |sh| sh.degree);
        let [found, expected] = [&level.sh, &self.sh].map(|sh| format!("degree {}", degree(sh)));
        if found != expected {
            return Err(FormatError::metadata("sh", found, expected));
        }
        check_harmonics(level.sh.as_ref(), &level.gaussians)
    }

    /// Checks what a file can't say of a level: that it is in the avatar's bounds, and names the
    /// one node that there is without correctives.
    fn check_level(&self, level: &Level) -> Result<(), FormatError> {
        let fault = |field: &str, [found, expected]: [String; 2]| {
            Err(FormatError::metadata(field, found, expected))
        };
        let bounds = [level.gaussians.bounds, self.gaussians.bounds];
        if bounds[0] != bounds[1] {
            let text = bounds.map(|bounds| format!("{:?} to {:?}", bounds.min, bounds.max));
            return fault("bounds", text);
        }
        let nodes = &level.gaussians.node;
        let count = level.gaussians.len();
        let named = nodes.iter().filter(|&&node| node != [0; 3]).count();
        if !level.correctives && (nodes.len() != count || named != 0) {
            let found = format!("{} entries, of which {named} are others", nodes.len());
            return fault("node", [found, format!("{count} of node 0 alone")]);
        }
        Ok(())
    }

    /// How many bytes [`Avatar::neutral`] needs from the start of an avatar's file, as far as its
    /// first bytes tell: those of the header, and once the header is there those of the neutral
    /// avatar.
    ///
    /// # Errors
    /// When the bytes are not the beginning of a file.
    pub fn neutral_needs(bytes: &[u8]) -> Result<usize, FormatError> {
        order::needs(bytes)
    }

    /// The avatar without its correctives and spherical harmonics, from the beginning of a file
    /// that is `length` bytes long: it moves with its joints alone. Its arrays have the lengths of
    /// the whole avatar's.
    ///
    /// # Errors
    /// When the bytes are not the beginning of an avatar's file, or break a rule.
    pub fn neutral(bytes: &[u8], length: usize) -> Result<Neutral, FormatError> {
        order::neutral(bytes, length)
    }

    /// Writes an avatar file; on failure a file that was at `path` is unchanged.
    ///
    /// # Errors
    /// When the avatar breaks a rule of [`super::format`], or the file cannot be written.
    pub fn write(&self, path: &Path) -> Result<(), FileError> {
        write_encoded(path, self.to_bytes())
    }

    /// The bytes that [`Avatar::write`] writes.
    ///
    /// # Errors
    /// When the avatar breaks a rule of [`super::format`].
    pub fn to_bytes(&self) -> Result<Vec<u8>, FormatError> {
        encode::encode(self, AvatarHeader::from_model(self), false)
    }

    /// The smallest file that holds this avatar without loss: codes where they are exact, and
    /// deflated tensors where that is shorter. [`crate::io::pack`] rounds an avatar so that more of
    /// it can be codes.
    ///
    /// # Errors
    /// When the avatar breaks a rule of [`super::format`].
    pub fn to_packed_bytes(&self) -> Result<Vec<u8>, FormatError> {
        encode::encode(self, AvatarHeader::packed(self), true)
    }

    /// Writes the file of [`Avatar::to_packed_bytes`]; on failure a file that was at `path` is
    /// unchanged.
    ///
    /// # Errors
    /// When the avatar breaks a rule of [`super::format`], or the file cannot be written.
    pub fn write_packed(&self, path: &Path) -> Result<(), FileError> {
        write_encoded(path, self.to_packed_bytes())
    }

    /// Lists the tensors of the file that [`Avatar::write`] writes.
    pub fn tensors(&self) -> Vec<TensorInfo> {
        container::list_plain::<AvatarHeader>(self)
    }
}

impl Clip {
    /// Checks every rule of [`super::format`].
    ///
    /// # Errors
    /// When one is broken; names it.
    pub fn check(&self) -> Result<(), FormatError> {
        container::check_arrays(&ClipHeader::from_model(self), self)
    }

    /// Reads a motion file. Every rule in [`super::format`] is checked before memory is taken for
    /// the clip.
    ///
    /// # Errors
    /// When the file cannot be opened, is not a motion, or breaks a rule.
    pub fn read(path: &Path) -> Result<Self, FileError> {
        read_with(path, Self::from_bytes)
    }

    /// Reads a clip from a file's bytes, at any alignment.
    ///
    /// # Errors
    /// When the bytes are not a motion or break a rule.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, FormatError> {
        container::decode::<ClipHeader>(bytes)
    }

    /// Writes a motion file; on failure a file that was at `path` is unchanged.
    ///
    /// # Errors
    /// When the clip breaks a rule of [`super::format`], or the file cannot be written.
    pub fn write(&self, path: &Path) -> Result<(), FileError> {
        write_encoded(path, self.to_bytes())
    }

    /// The bytes that [`Clip::write`] writes.
    ///
    /// # Errors
    /// When the clip breaks a rule of [`super::format`].
    pub fn to_bytes(&self) -> Result<Vec<u8>, FormatError> {
        encode::encode(self, ClipHeader::from_model(self), false)
    }

    /// Lists the tensors of the file that [`Clip::write`] writes.
    pub fn tensors(&self) -> Vec<TensorInfo> {
        container::list_plain::<ClipHeader>(self)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::avatar::{LevelError, Rows};
    use half::f16;

    /// A fault that `break_it` makes in the demo.
    fn fault(break_it: impl Fn(&mut Avatar)) -> String {
        let mut avatar = crate::demo::avatar().expect("inside the program");
        assert_eq!(avatar.check(), Ok(()));
        break_it(&mut avatar);
        match avatar.check() {
            Ok(()) => "none".into(),
            Err(fault) => fault.to_string(),
        }
    }

    #[test]
    fn check_names_what_contradicts_the_rest() {
        let node = fault(|avatar| avatar.gaussians.node[7][1] = u16::MAX);
        assert!(node.contains("`node`") && node.contains("[7, 1]"), "{node}");
        let opacity = fault(|avatar| avatar.gaussians.opacity.truncate(3));
        assert!(opacity.contains("`opacity` found 3 bytes"), "{opacity}");
        let parent = fault(|avatar| avatar.skeleton.parent[1] = Some(200));
        assert!(parent.contains("200 for joint 1"), "{parent}");
        let input = fault(|avatar| avatar.networks.layers[1].input += 4);
        assert!(input.contains("inputs of layer 1"), "{input}");
        let parts = fault(|avatar| avatar.parts.start.clear());
        assert!(parts.contains("`parts` found 0"), "{parts}");
        let color = fault(|avatar| avatar.gaussians.color[0][2] = f16::NAN);
        assert!(color.contains("`color` found NaN at [0, 2]"), "{color}");
        let sh = fault(|avatar| {
            avatar.sh = Some(crate::avatar::ShCoefficients {
                degree: 1,
                coefficients: vec![[f16::ZERO; 3]; 5],
            });
        });
        assert!(sh.contains("`sh` found 5 coefficients"), "{sh}");
    }

    /// A level of every other Gaussian.
    fn every_other(avatar: &Avatar) -> Level {
        let keep: Vec<usize> = (0..avatar.gaussians.len()).step_by(2).collect();
        Level {
            gaussians: avatar.gaussians.pick(&keep),
            part_start: avatar.parts.start.iter().map(|s| s.div_ceil(2)).collect(),
            correctives: true,
            rotation_rows: Rows::default(),
            scale_rows: Rows::default(),
            color_rows: Rows::default(),
            sh: None,
            measured: [1, 2]
                .map(|samples| LevelError {
                    height: 60.0,
                    samples,
                    psnr_db: 30.0,
                    color: 0.01,
                    coverage: 0.0,
                })
                .into(),
        }
    }

    #[test]
    fn check_refuses_levels_that_do_not_match_their_avatar() {
        let level_fault = |break_it: &dyn Fn(&mut Level)| {
            fault(|avatar| {
                let mut level = every_other(avatar);
                break_it(&mut level);
                avatar.levels = vec![level];
            })
        };
        assert_eq!(level_fault(&|_| ()), "none");
        // Without correctives there is only the node that moves nothing.
        let still = |level: &mut Level| {
            level.correctives = false;
            level.gaussians.node.fill([0; 3]);
        };
        assert_eq!(level_fault(&still), "none");
        type Break<'a> = (&'a str, &'a dyn Fn(&mut Level));
        let cases: [Break; 12] = [
            ("`level.0.gaussians` found 0", &|level| {
                level.gaussians = level.gaussians.pick(&[]);
            }),
            ("`level.0.bounds`", &|level| {
                level.gaussians.bounds.max[1] += 1.0
            }),
            ("`level.0.part_start`", &|level| level.part_start.push(9)),
            ("`level.0.part_start`", &|level| {
                level.part_start[1] = u32::MAX
            }),
            ("`level.0.sh` found degree 1", &|level| {
                level.sh = Some(crate::avatar::ShCoefficients {
                    degree: 1,
                    coefficients: vec![],
                });
            }),
            ("`level.0.log_scale` found NaN at [3, 1]", &|level| {
                level.gaussians.log_scale[3][1] = f16::NAN;
            }),
            ("`level.0.node`", &|level| {
                level.gaussians.node[0][0] = u16::MAX
            }),
            ("`level.0.joint_weight`", &|level| {
                level.gaussians.joint_weight[0] = [255; 4];
            }),
            ("`level.0.color_rows` found 1, expected 0 to 0", &|level| {
                still(level);
                level.color_rows.gaussian = vec![0];
            }),
            ("`level.0.node` found", &|level| level.correctives = false),
            ("`level.0.measured` found inf dB", &|level| {
                level.measured[1].psnr_db = f64::INFINITY;
            }),
            (
                "`level.0.measured` found 60 px with 2 samples after",
                &|level| {
                    level.measured[0].samples = 2;
                },
            ),
        ];
        for (expected, break_it) in cases {
            let found = level_fault(break_it);
            assert!(found.contains(expected), "{found}, expected {expected}");
        }
        let twice = fault(|avatar| avatar.levels = vec![every_other(avatar); 2]);
        assert!(twice.contains("`level.1.gaussians`"), "{twice}");
    }
}
