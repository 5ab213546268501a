//! The state of a training on disk. A new file is written beside the last one and then renamed, so
//! that a kill at any moment leaves a whole checkpoint.

use crate::exposure::Exposure;
use crate::gpu::TrainerState;
use crate::parameters::Parameters;
use crate::refine::{Items, Refinement};
use crate::topology::CorrectiveRows;
use bytemuck::Pod;
use effigy_core::avatar::FacingCode;
use effigy_core::io::file::{FileError, replace};
use effigy_core::random::hash;
use safetensors::{Dtype, SafeTensorError, SafeTensors, tensor::TensorView};
use serde::{Deserialize, Serialize};
use std::collections::HashMap;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// Checkpoints that are kept.
const KEPT: usize = 2;
/// Version of the file.
const VERSION: u32 = 4;
const META: &str = "effigy";

/// The state of a training.
#[derive(Clone, Debug, PartialEq)]
pub struct TrainingCheckpoint {
    /// What is learned, and how.
    pub state: TrainerState,
    /// Which Gaussians have correctives.
    pub rows: CorrectiveRows,
    /// Whether rows were pruned.
    pub pruned: bool,
    /// From where Gaussians are drawn; none while all are drawn from everywhere.
    pub facing: Vec<FacingCode>,
    /// How often that was found.
    pub faced: u64,
    /// Views used so far: the position in the data.
    pub place: u64,
    /// Exposure and white balance of the cameras.
    pub exposure: Exposure,
    /// Poses, cameras and bones.
    pub refinement: Refinement,
    /// Seconds that the training has taken.
    pub seconds: f64,
    /// A name of the capture's cameras, frames and pictures that it learns from.
    pub data: String,
    /// Minutes that it may take in all, where time decides.
    pub minutes: Option<f64>,
    /// The recipe's text.
    pub recipe: String,
}

/// All that is not in tensors.
#[derive(Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
struct Meta {
    version: u32,
    steps: u64,
    corrective_steps: u64,
    pruned: bool,
    faced: u64,
    place: u64,
    exposure: Exposure,
    seconds: f64,
    data: String,
    minutes: Option<f64>,
    recipe: String,
    /// Of everything else, in the order of the file.
    checksum: String,
}

/// The part of [`Meta`] that every version has.
#[derive(Deserialize)]
struct Version {
    version: u32,
}

const ARRAYS: [&str; 4] = ["gaussians", "nodes", "networks", "bases"];
const KINDS: [&str; 3] = ["parameters", "first_moments", "second_moments"];
const ROWS: [&str; 3] = ["rows.rotation", "rows.scale", "rows.color"];
const FACING: &str = "facing";
const ITEMS: [&str; 3] = ["poses", "cameras", "bones"];
const OF_ITEMS: [&str; 4] = ["values", "first_moments", "second_moments", "updates"];

impl TrainingCheckpoint {
    /// The file's name after so many steps.
    fn name(steps: u64) -> String {
        format!("checkpoint-{steps:09}.safetensors")
    }

    /// Writes it into a folder, and deletes all but the last two.
    ///
    /// # Errors
    /// When the disk is full or the folder can't be written; what was there stays.
    pub fn write(&self, folder: &Path) -> Result<PathBuf, FileError> {
        let path = folder.join(Self::name(self.state.steps));
        let failed = |cause| FileError::Write {
            file: path.clone(),
            cause,
        };
        let bytes = self.encode().map_err(failed)?;
        replace(&path, &bytes)?;
        let files = Self::files(folder).map_err(failed)?;
        // Broken files do not count as checkpoints: see `set_aside`.
        for old in files.iter().rev().skip(KEPT) {
            fs::remove_file(old).map_err(failed)?;
        }
        Ok(path)
    }

    /// The file's bytes.
    fn encode(&self) -> io::Result<Vec<u8>> {
        let tensors: Vec<(String, (Dtype, &[u8]))> = names().zip(self.tensors()).collect();
        let bare = Meta {
            version: VERSION,
            steps: self.state.steps,
            corrective_steps: self.state.corrective_steps,
            pruned: self.pruned,
            faced: self.faced,
            place: self.place,
            exposure: self.exposure.clone(),
            seconds: self.seconds,
            data: self.data.clone(),
            minutes: self.minutes,
            recipe: self.recipe.clone(),
            checksum: String::new(),
        };
        let named = tensors.iter().map(|(name, (_, data))| (&name[..], *data));
        let meta = Meta {
            checksum: bare.checksum(named),
            ..bare
        };
        let text = serde_json::to_string(&meta).map_err(io::Error::other)?;
        let views = tensors
            .into_iter()
            .map(|(name, (dtype, data))| {
                let shape = vec![8 * data.len() / dtype.bitsize()];
                let view = TensorView::new(dtype, shape, data).map_err(io::Error::other)?;
                Ok((name, view))
            })
            .collect::<io::Result<Vec<_>>>()?;
        let metadata = HashMap::from([(META.to_string(), text)]);
        safetensors::serialize(views, Some(metadata)).map_err(io::Error::other)
    }

    /// The file's tensors, in the order of [`names`].
    fn tensors(&self) -> impl Iterator<Item = (Dtype, &[u8])> {
        let state = &self.state;
        let kinds = [
            &state.parameters,
            &state.first_moments,
            &state.second_moments,
        ];
        let parameters = kinds.into_iter().flat_map(Parameters::arrays);
        let items = self.refinement.items().into_iter().flat_map(|items| {
            let moments = &items.moments;
            [
                (Dtype::F64, bytemuck::cast_slice(&items.values)),
                (Dtype::F64, bytemuck::cast_slice(&moments.first)),
                (Dtype::F64, bytemuck::cast_slice(&moments.second)),
                (Dtype::U64, bytemuck::cast_slice(&moments.updates)),
            ]
        });
        parameters
            .map(|array| (Dtype::F32, bytemuck::cast_slice(array)))
            .chain(
                self.rows
                    .gaussian
                    .iter()
                    .map(|rows| (Dtype::U32, bytemuck::cast_slice(rows))),
            )
            .chain([(Dtype::U8, self.facing.as_flattened())])
            .chain(items)
    }

    /// The checkpoints of a folder, the oldest first.
    ///
    /// # Errors
    /// When the folder can't be read.
    pub fn files(folder: &Path) -> io::Result<Vec<PathBuf>> {
        let mut files = Vec::new();
        for entry in fs::read_dir(folder)? {
            let path = entry?.path();
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            if name.starts_with("checkpoint-") && name.ends_with(".safetensors") {
                files.push(path);
            }
        }
        files.sort();
        Ok(files)
    }

    /// The last whole checkpoint of a folder, and the broken ones after it.
    ///
    /// # Errors
    /// When the folder can't be read.
    pub fn last(folder: &Path) -> io::Result<FolderCheckpoints> {
        let mut broken = Vec::new();
        for path in Self::files(folder)?.into_iter().rev() {
            match Self::read(&path) {
                Ok(checkpoint) => {
                    return Ok(FolderCheckpoints {
                        checkpoint: Some(checkpoint),
                        broken,
                    });
                }
                Err(error) => broken.push(Broken { path, error }),
            }
        }
        Ok(FolderCheckpoints {
            checkpoint: None,
            broken,
        })
    }

    /// Reads one.
    ///
    /// # Errors
    /// When it is cut, changed or of another version; the text says what is wrong.
    pub fn read(path: &Path) -> Result<Self, String> {
        let bytes = fs::read(path).map_err(|error| error.to_string())?;
        let meta = Meta::read(&bytes)?;
        let tensors = CheckpointTensors(SafeTensors::deserialize(&bytes).map_err(not_whole)?);
        tensors.check(&meta)?;
        let [parameters, first_moments, second_moments] = [
            tensors.parameters(KINDS[0])?,
            tensors.parameters(KINDS[1])?,
            tensors.parameters(KINDS[2])?,
        ];
        let lengths = |numbers: &Parameters<f32>| numbers.arrays().map(<[f32]>::len);
        if [&first_moments, &second_moments].map(lengths) != [lengths(&parameters); 2] {
            return Err("moments of another number than the parameters".into());
        }
        Ok(Self {
            state: TrainerState {
                parameters,
                first_moments,
                second_moments,
                steps: meta.steps,
                corrective_steps: meta.corrective_steps,
            },
            refinement: Refinement {
                poses: tensors.items(ITEMS[0])?,
                cameras: tensors.items(ITEMS[1])?,
                bones: tensors.items(ITEMS[2])?,
            },
            rows: CorrectiveRows {
                gaussian: [
                    tensors.array(ROWS[0])?,
                    tensors.array(ROWS[1])?,
                    tensors.array(ROWS[2])?,
                ],
            },
            pruned: meta.pruned,
            facing: tensors.array(FACING)?,
            faced: meta.faced,
            place: meta.place,
            exposure: meta.exposure,
            seconds: meta.seconds,
            data: meta.data,
            minutes: meta.minutes,
            recipe: meta.recipe,
        })
    }
}

/// The names of a file's tensors, in the order of its checksum.
fn names() -> impl Iterator<Item = String> {
    let products = |kinds: [&'static str; 3], arrays: [&'static str; 4]| {
        let all = kinds.into_iter();
        all.flat_map(move |kind| arrays.map(|array| format!("{kind}.{array}")))
    };
    products(KINDS, ARRAYS)
        .chain(ROWS.map(String::from))
        .chain([FACING.into()])
        .chain(products(ITEMS, OF_ITEMS))
}

/// The tensors of a file.
struct CheckpointTensors<'a>(SafeTensors<'a>);

impl CheckpointTensors<'_> {
    fn bytes(&self, name: &str) -> Result<&[u8], String> {
        let tensor = self.0.tensor(name).map_err(|error| error.to_string())?;
        Ok(tensor.data())
    }

    fn array<T: Pod>(&self, name: &str) -> Result<Vec<T>, String> {
        Ok(bytemuck::pod_collect_to_vec(self.bytes(name)?))
    }

    /// Checks that all tensors exist and have the file's checksum.
    fn check(&self, meta: &Meta) -> Result<(), String> {
        let names: Vec<String> = names().collect();
        let named = names
            .iter()
            .map(|name| Ok((&name[..], self.bytes(name)?)))
            .collect::<Result<Vec<_>, String>>()?;
        let found = meta.checksum(named.into_iter());
        if found == meta.checksum {
            return Ok(());
        }
        Err(format!("checksum {found}, expected {}", meta.checksum))
    }

    fn parameters(&self, kind: &str) -> Result<Parameters<f32>, String> {
        let array = |name: &str| self.array(&format!("{kind}.{name}"));
        Ok(Parameters {
            gaussians: array(ARRAYS[0])?,
            nodes: array(ARRAYS[1])?,
            networks: array(ARRAYS[2])?,
            bases: array(ARRAYS[3])?,
        })
    }

    fn items(&self, kind: &str) -> Result<Items, String> {
        let doubles = |name: &str| self.array(&format!("{kind}.{name}"));
        Items::from_arrays(
            doubles(OF_ITEMS[0])?,
            doubles(OF_ITEMS[1])?,
            doubles(OF_ITEMS[2])?,
            self.array(&format!("{kind}.{}", OF_ITEMS[3]))?,
        )
        .ok_or_else(|| format!("{kind} and moments of another number"))
    }
}

fn not_whole(error: SafeTensorError) -> String {
    format!("not a whole checkpoint: {error}")
}

/// The checkpoints of a folder.
pub struct FolderCheckpoints {
    /// The last whole checkpoint.
    pub checkpoint: Option<TrainingCheckpoint>,
    /// Later ones that are not whole.
    pub broken: Vec<Broken>,
}

/// A checkpoint that is not whole.
pub struct Broken {
    /// The file.
    pub path: PathBuf,
    /// What is wrong.
    pub error: String,
}

impl Broken {
    /// Gives it another extension, so that it no longer counts as a checkpoint.
    ///
    /// # Errors
    /// When it can't be renamed.
    pub fn set_aside(&self) -> io::Result<()> {
        fs::rename(&self.path, self.path.with_extension("broken"))
    }
}

/// Deletes partly written checkpoints of processes that were killed.
pub fn remove_parts(folder: &Path) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        if name.starts_with(".checkpoint-") && name.ends_with(".part") {
            fs::remove_file(&path)?;
        }
    }
    Ok(())
}

impl Meta {
    /// The metadata of a file.
    fn read(bytes: &[u8]) -> Result<Self, String> {
        let (_, header) = SafeTensors::read_metadata(bytes).map_err(not_whole)?;
        let text = header
            .metadata()
            .as_ref()
            .and_then(|all| all.get(META))
            .ok_or("no checkpoint of a training")?;
        let Version { version } = serde_json::from_str(text).map_err(|error| error.to_string())?;
        if version != VERSION {
            return Err(format!("version {version}, expected {VERSION}"));
        }
        serde_json::from_str(text).map_err(|error| error.to_string())
    }

    /// A hash of everything but itself and of named bytes, as text.
    fn checksum<'a>(&self, named: impl Iterator<Item = (&'a str, &'a [u8])>) -> String {
        let all = checksum(named);
        let bare = Self {
            checksum: String::new(),
            ..self.clone()
        };
        let text = serde_json::to_string(&bare).unwrap_or_default();
        checksum([(META, text.as_bytes()), (META, all.as_bytes())].into_iter())
    }
}

/// A hash of named bytes, as text.
fn checksum<'a>(named: impl Iterator<Item = (&'a str, &'a [u8])>) -> String {
    let mut sum = 0u64;
    for (name, bytes) in named {
        for chunk in name.as_bytes().chunks(8).chain(bytes.chunks(8)) {
            let mut word = [0; 8];
            word[..chunk.len()].copy_from_slice(chunk);
            sum = hash(sum ^ u64::from_le_bytes(word));
        }
    }
    format!("{sum:016x}")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn checkpoint(steps: u64) -> TrainingCheckpoint {
        let numbers = |scale: f32| Parameters {
            gaussians: (0..24).map(|k| scale * k as f32).collect(),
            nodes: vec![scale; 5],
            networks: vec![-scale; 7],
            bases: vec![],
        };
        TrainingCheckpoint {
            state: TrainerState {
                parameters: numbers(1.0),
                first_moments: numbers(0.5),
                second_moments: numbers(f32::MIN_POSITIVE),
                steps,
                corrective_steps: 3,
            },
            rows: CorrectiveRows {
                gaussian: [vec![0, 1], vec![], vec![1]],
            },
            pruned: true,
            facing: vec![[1, 2, 3], [4, 5, 6]],
            faced: 2,
            place: 77,
            exposure: Exposure::new(2),
            refinement: Refinement {
                poses: Items::from_arrays(vec![0.1; 12], vec![0.2; 12], vec![0.3; 12], vec![4, 5])
                    .unwrap(),
                cameras: Items::from_arrays(vec![], vec![], vec![], vec![]).unwrap(),
                bones: Items::from_arrays(vec![0.4; 3], vec![0.5; 3], vec![0.6; 3], vec![9])
                    .unwrap(),
            },
            seconds: 1.25,
            data: "of two cameras".into(),
            minutes: Some(0.1),
            recipe: "seed = 1".into(),
        }
    }

    #[test]
    fn it_is_read_as_it_was_written_and_two_are_kept() {
        let folder = tempfile::tempdir().unwrap();
        for steps in [1, 20, 300] {
            checkpoint(steps).write(folder.path()).unwrap();
        }
        let files = TrainingCheckpoint::files(folder.path()).unwrap();
        assert_eq!(files.len(), KEPT);
        let found = TrainingCheckpoint::last(folder.path()).unwrap();
        assert_eq!(found.checkpoint, Some(checkpoint(300)));
        assert!(found.broken.is_empty());
    }

    #[test]
    fn a_broken_one_gives_way_to_the_one_before() {
        let folder = tempfile::tempdir().unwrap();
        checkpoint(1).write(folder.path()).unwrap();
        let last = checkpoint(2).write(folder.path()).unwrap();
        let whole = fs::read(&last).unwrap();
        for length in (0..whole.len()).step_by(97) {
            fs::write(&last, &whole[..length]).unwrap();
            let found = TrainingCheckpoint::last(folder.path()).unwrap();
            assert_eq!(found.checkpoint, Some(checkpoint(1)), "cut at {length}");
            assert_eq!(found.broken.len(), 1);
        }
        let mut changed = whole.clone();
        let at = whole.len() - 9;
        changed[at] ^= 1;
        fs::write(&last, &changed).unwrap();
        let found = TrainingCheckpoint::last(folder.path()).unwrap();
        assert!(found.broken[0].error.contains("checksum"));
        found.broken[0].set_aside().unwrap();
        let kept = checkpoint(3).write(folder.path()).unwrap();
        assert!(kept.exists());
        assert_eq!(TrainingCheckpoint::files(folder.path()).unwrap().len(), 2);
    }
}
