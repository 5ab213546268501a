//! Where a fit is, to a file and back: after an interruption it goes on from there and ends as it would have.

use super::block::Kept;
use super::dataset::Error;
use super::learner::Learner;
use super::network::Target;
use crate::avatar::file::replace;
use safetensors::{Dtype, SafeTensors, tensor::TensorView};
use serde::{Deserialize, Serialize};
use std::collections::HashMap;
use std::io::ErrorKind;
use std::path::Path;

const KEY: &str = "effigy";

/// A fit under way.
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    pub at: Position,
    pub learner: Learner,
    pub kept: Kept,
}

/// How far a fit has come.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Position {
    /// What is fitted to what, and how: only the same goes on.
    pub fingerprint: String,
    pub stage: usize,
    /// Epochs of the stage that are done.
    pub epoch: usize,
    pub curve: Vec<Point>,
}

/// A point of the loss curves.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Point {
    pub stage: usize,
    /// Epochs from the start of the fit.
    pub epoch: usize,
    /// Share of the training frames' spread that is not explained.
    pub training: f64,
    /// The same of the held-out frames.
    pub held: f64,
}

impl State {
    /// Writes the state; what was at `path` stays whole if that fails.
    pub fn write(&self, path: &Path) -> Result<(), Error> {
        let learner = &self.learner;
        let join = |of: &dyn Fn(usize) -> Vec<f32>| (0..learner.networks.len()).flat_map(of).collect::<Vec<f32>>();
        let steps: Vec<u32> = learner.networks.iter().map(|network| network.steps).collect();
        let numbers = [
            ("weights", join(&|p| learner.networks[p].weights.clone())),
            ("first", join(&|p| learner.networks[p].first.clone())),
            ("second", join(&|p| learner.networks[p].second.clone())),
            ("form", join(&|p| learner.targets[p].form.clone())),
            ("pull", join(&|p| learner.targets[p].pull.clone())),
            ("energy", join(&|p| learner.targets[p].energy.clone())),
            ("scales", learner.scales.clone()),
        ];
        let refused = |error: safetensors::SafeTensorError| Error::Write { file: path.into(), cause: std::io::Error::other(error) };
        let mut views =
            vec![("steps".to_owned(), TensorView::new(Dtype::U32, vec![steps.len()], bytemuck::cast_slice(&steps)).map_err(refused)?)];
        for (name, list) in &numbers {
            views.push(((*name).to_owned(), TensorView::new(Dtype::F32, vec![list.len()], bytemuck::cast_slice(list)).map_err(refused)?));
        }
        for (a, list) in self.kept.0.iter().flatten().enumerate() {
            views.push((format!("kept.{a}"), TensorView::new(Dtype::U32, vec![list.len()], bytemuck::cast_slice(list)).map_err(refused)?));
        }
        let text = serde_json::to_string(&self.at).expect("strings and numbers always have a JSON form");
        let bytes = safetensors::serialize(views, Some(HashMap::from([(KEY.to_owned(), text)]))).map_err(refused)?;
        Ok(replace(path, &bytes)?)
    }

    /// Reads the state of a fit of this fingerprint; None where there is none. `fresh` is the fit at its start.
    ///
    /// # Errors
    /// When the file is damaged, or of another fit.
    pub fn read(path: &Path, fresh: &Self) -> Result<Option<Self>, Error> {
        let bytes = match std::fs::read(path) {
            Err(cause) if cause.kind() == ErrorKind::NotFound => return Ok(None),
            other => other.map_err(|cause| Error::Read { file: path.into(), cause })?,
        };
        let wrong = |found: String, expected: &str| Error::Content {
            file: path.into(),
            found,
            expected: format!("{expected}; delete the file to begin anew"),
        };
        let damaged = |error: &dyn std::fmt::Display| wrong(error.to_string(), "a whole checkpoint");
        let (_, header) = SafeTensors::read_metadata(&bytes).map_err(|error| damaged(&error))?;
        let text = header.metadata().as_ref().and_then(|map| map.get(KEY)).ok_or_else(|| damaged(&"no position"))?;
        let at: Position = serde_json::from_str(text).map_err(|error| damaged(&error))?;
        if at.fingerprint != fresh.at.fingerprint {
            return Err(wrong("a checkpoint of another fit".into(), "one of the same dataset and options"));
        }
        let tensors = SafeTensors::deserialize(&bytes).map_err(|error| damaged(&error))?;
        let list = |name: &str| tensors.tensor(name).map(|tensor| tensor.data().to_vec()).map_err(|error| damaged(&error));
        let mut state = Self { at, ..fresh.clone() };
        let mut frames = 0;
        for name in ["weights", "first", "second", "scales", "energy", "form", "pull"] {
            let numbers: Vec<f32> = bytemuck::pod_collect_to_vec(&list(name)?);
            let parts = state.learner.networks.len();
            if name == "energy" {
                frames = numbers.len() / parts.max(1);
            }
            let lengths = |part: usize| state.learner.networks[part].sizes[4];
            let expected: usize = match name {
                "scales" => parts,
                "energy" => frames * parts,
                "form" => (0..parts).map(|p| lengths(p).pow(2)).sum(),
                "pull" => (0..parts).map(|p| lengths(p) * frames).sum(),
                _ => state.learner.networks.iter().map(|network| network.weights.len()).sum(),
            };
            if numbers.len() != expected {
                return Err(damaged(&format!("{} numbers in `{name}`", numbers.len())));
            }
            state.learner.place(name, &numbers, frames);
        }
        let steps: Vec<u32> = bytemuck::pod_collect_to_vec(&list("steps")?);
        state.learner.networks.iter_mut().zip(steps).for_each(|(network, steps)| network.steps = steps);
        let kept = |a: usize| Ok::<_, Error>(bytemuck::pod_collect_to_vec(&list(&format!("kept.{a}"))?));
        state.kept = Kept(if tensors.tensor("kept.0").is_ok() { Some([kept(0)?, kept(1)?, kept(2)?]) } else { None });
        Ok(Some(state))
    }
}

impl Learner {
    /// Takes a checkpoint's tensor, whose length is right, apart.
    fn place(&mut self, name: &str, mut numbers: &[f32], frames: usize) {
        for part in 0..self.networks.len() {
            let (network, target): (_, &mut Target) = (&mut self.networks[part], &mut self.targets[part]);
            let features = network.sizes[4];
            let (slot, length) = match name {
                "weights" => (&mut network.weights, None),
                "first" => (&mut network.first, None),
                "second" => (&mut network.second, None),
                "form" => (&mut target.form, Some(features * features)),
                "pull" => (&mut target.pull, Some(features * frames)),
                "energy" => (&mut target.energy, Some(frames)),
                _ => {
                    self.scales[part] = numbers[0];
                    numbers = &numbers[1..];
                    continue;
                }
            };
            let (own, rest) = numbers.split_at(length.unwrap_or(slot.len()));
            *slot = own.to_vec();
            numbers = rest;
        }
    }
}
