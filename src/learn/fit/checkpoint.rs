//! The state of a fit in a file. An interrupted fit resumes from it and ends with the same bytes.

use crate::dataset::LearnError;
use crate::fit::loss_curve::LossPoint;
use crate::train::block::RetainedRows;
use crate::train::learner::Learner;
use crate::train::network::LAYERS;
use effigy_core::io::file::replace;
use safetensors::{Dtype, SafeTensorError, SafeTensors, tensor::TensorView};
use serde::{Deserialize, Serialize};
use std::collections::HashMap;
use std::fmt::Display;
use std::io::ErrorKind;
use std::path::Path;

/// The key of [`StageProgress`] in the file's metadata.
const KEY: &str = "effigy";

/// A fit under way.
#[derive(Clone, Debug, PartialEq)]
pub struct FitState {
    /// How far it has come.
    pub progress: StageProgress,
    /// Networks and their targets.
    pub learner: Learner,
    /// The rows that are left.
    pub retained: RetainedRows,
}

/// How far a fit has come.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct StageProgress {
    /// The dataset and the options, as text: only a fit with the same fingerprint resumes.
    pub fingerprint: String,
    /// The stage under way, from 0.
    pub stage: usize,
    /// Epochs of the stage that are done.
    pub epoch: usize,
    /// The loss so far.
    pub curve: Vec<LossPoint>,
}

/// The tensors of [`Learner`], by their names in the file. Each has the numbers of all parts, part
/// after part.
#[derive(Clone, Copy, PartialEq)]
enum LearnerTensor {
    Weights,
    FirstMoment,
    SecondMoment,
    Quadratic,
    Linear,
    Energy,
    Scales,
}

impl LearnerTensor {
    const ALL: [Self; 7] = [
        Self::Weights,
        Self::FirstMoment,
        Self::SecondMoment,
        Self::Quadratic,
        Self::Linear,
        Self::Energy,
        Self::Scales,
    ];

    fn name(self) -> &'static str {
        match self {
            Self::Weights => "weights",
            Self::FirstMoment => "first",
            Self::SecondMoment => "second",
            Self::Quadratic => "form",
            Self::Linear => "pull",
            Self::Energy => "energy",
            Self::Scales => "scales",
        }
    }

    /// A part's numbers of this tensor.
    fn of_part(self, learner: &Learner, part: usize) -> &[f32] {
        let network = &learner.networks[part];
        let target = &learner.targets[part];
        match self {
            Self::Weights => &network.weights,
            Self::FirstMoment => &network.first_moment,
            Self::SecondMoment => &network.second_moment,
            Self::Quadratic => &target.quadratic,
            Self::Linear => &target.linear,
            Self::Energy => &target.energy,
            Self::Scales => &learner.scales[part..=part],
        }
    }

    /// Replaces a part's numbers of this tensor.
    fn set_part(self, learner: &mut Learner, part: usize, numbers: &[f32]) {
        let network = &mut learner.networks[part];
        let target = &mut learner.targets[part];
        let own = match self {
            Self::Weights => &mut network.weights,
            Self::FirstMoment => &mut network.first_moment,
            Self::SecondMoment => &mut network.second_moment,
            Self::Quadratic => &mut target.quadratic,
            Self::Linear => &mut target.linear,
            Self::Energy => &mut target.energy,
            Self::Scales => {
                learner.scales[part] = numbers[0];
                return;
            }
        };
        *own = numbers.to_vec();
    }

    /// How many numbers of this tensor a part has, in a fit of `frames` frames.
    fn part_len(self, learner: &Learner, part: usize, frames: usize) -> usize {
        let network = &learner.networks[part];
        let features = network.widths[LAYERS];
        match self {
            Self::Weights | Self::FirstMoment | Self::SecondMoment => network.weights.len(),
            Self::Quadratic => features * features,
            Self::Linear => features * frames,
            Self::Energy => frames,
            Self::Scales => 1,
        }
    }
}

impl FitState {
    /// Writes the state. If that fails, the file that was at `path` stays whole.
    ///
    /// # Errors
    /// When the file cannot be written.
    pub fn write(&self, path: &Path) -> Result<(), LearnError> {
        let refused = |error: SafeTensorError| LearnError::Write {
            file: path.into(),
            cause: std::io::Error::other(error),
        };
        let learner = &self.learner;
        let parts = learner.networks.len();
        let steps: Vec<u32> = learner
            .networks
            .iter()
            .map(|network| network.steps)
            .collect();
        let joined = LearnerTensor::ALL.map(|tensor| {
            (0..parts)
                .flat_map(|part| tensor.of_part(learner, part).iter().copied())
                .collect::<Vec<f32>>()
        });

        let view = |dtype: Dtype, length: usize, bytes| {
            TensorView::new(dtype, vec![length], bytes).map_err(refused)
        };
        let mut views = vec![(
            "steps".to_owned(),
            view(Dtype::U32, steps.len(), bytemuck::cast_slice(&steps))?,
        )];
        for (tensor, numbers) in LearnerTensor::ALL.iter().zip(&joined) {
            let bytes = bytemuck::cast_slice(numbers);
            views.push((
                tensor.name().to_owned(),
                view(Dtype::F32, numbers.len(), bytes)?,
            ));
        }
        if let RetainedRows::Listed(lists) = &self.retained {
            for (a, list) in lists.iter().enumerate() {
                let bytes = bytemuck::cast_slice(list);
                views.push((format!("kept.{a}"), view(Dtype::U32, list.len(), bytes)?));
            }
        }
        let text = serde_json::to_string(&self.progress)
            .expect("strings and numbers always have a JSON form");
        let metadata = HashMap::from([(KEY.to_owned(), text)]);
        let bytes = safetensors::serialize(views, Some(metadata)).map_err(refused)?;
        Ok(replace(path, &bytes)?)
    }

    /// Reads the state of a fit; `None` if there is no file. `fresh` is the fit at its start.
    ///
    /// # Errors
    /// When the file is damaged, or is of another fit.
    pub fn read(path: &Path, fresh: &Self) -> Result<Option<Self>, LearnError> {
        let bytes = match std::fs::read(path) {
            Ok(bytes) => bytes,
            Err(cause) if cause.kind() == ErrorKind::NotFound => return Ok(None),
            Err(cause) => {
                return Err(LearnError::Read {
                    file: path.into(),
                    cause,
                });
            }
        };
        let damaged =
            |found: &dyn Display| wrong_content(path, found.to_string(), "a whole checkpoint");
        let (_, header) = SafeTensors::read_metadata(&bytes).map_err(|error| damaged(&error))?;
        let text = header
            .metadata()
            .as_ref()
            .and_then(|map| map.get(KEY))
            .ok_or_else(|| damaged(&"no position"))?;
        let progress: StageProgress =
            serde_json::from_str(text).map_err(|error| damaged(&error))?;
        if progress.fingerprint != fresh.progress.fingerprint {
            return Err(wrong_content(
                path,
                "a checkpoint of another fit".into(),
                "one of the same dataset and options",
            ));
        }
        let mut state = Self {
            progress,
            ..fresh.clone()
        };
        let tensors = SafeTensors::deserialize(&bytes).map_err(|error| damaged(&error))?;
        state
            .read_tensors(&tensors)
            .map_err(|found| damaged(&found))?;
        Ok(Some(state))
    }

    /// Replaces the learner and the retained rows by the file's. The error says which tensor is
    /// wrong.
    fn read_tensors(&mut self, tensors: &SafeTensors) -> Result<(), String> {
        let learner = &mut self.learner;
        let parts = learner.networks.len();
        let energies = read_numbers::<f32>(tensors, LearnerTensor::Energy.name())?.len();
        let frames = energies / parts.max(1);
        for tensor in LearnerTensor::ALL {
            let numbers: Vec<f32> = read_numbers(tensors, tensor.name())?;
            let expected: usize = (0..parts)
                .map(|part| tensor.part_len(learner, part, frames))
                .sum();
            if numbers.len() != expected {
                return Err(format!("{} numbers in `{}`", numbers.len(), tensor.name()));
            }
            let mut rest = &numbers[..];
            for part in 0..parts {
                let (own, others) = rest.split_at(tensor.part_len(learner, part, frames));
                tensor.set_part(learner, part, own);
                rest = others;
            }
        }
        let steps: Vec<u32> = read_numbers(tensors, "steps")?;
        for (network, steps) in learner.networks.iter_mut().zip(steps) {
            network.steps = steps;
        }
        self.retained = if tensors.tensor("kept.0").is_ok() {
            RetainedRows::Listed([
                read_numbers(tensors, "kept.0")?,
                read_numbers(tensors, "kept.1")?,
                read_numbers(tensors, "kept.2")?,
            ])
        } else {
            RetainedRows::All
        };
        Ok(())
    }
}

/// A tensor's numbers.
fn read_numbers<T: bytemuck::Pod>(tensors: &SafeTensors, name: &str) -> Result<Vec<T>, String> {
    let tensor = tensors.tensor(name).map_err(|error| error.to_string())?;
    Ok(bytemuck::pod_collect_to_vec(tensor.data()))
}

fn wrong_content(path: &Path, found: String, expected: &str) -> LearnError {
    LearnError::Content {
        file: path.into(),
        found,
        expected: format!("{expected}; delete the file to begin anew"),
    }
}
