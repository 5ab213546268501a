//! Entries of a checkpoint's dictionary, with their shapes checked before memory is taken.

use crate::{fault::tensor, pickle::Value};
use effigy_core::{constants::FEATURE_MAX, io::file::FormatError};

/// The dictionary of a checkpoint.
#[derive(Clone, Copy)]
pub struct CheckpointFields<'p> {
    pub root: Value<'p>,
}

impl<'p> CheckpointFields<'p> {
    pub fn has(self, name: &str) -> bool {
        self.root.get(name).is_some()
    }

    pub fn get(self, name: &str) -> Result<Value<'p>, FormatError> {
        self.root
            .get(name)
            .ok_or_else(|| tensor(name, "nothing", "an entry of that name"))
    }

    /// A number that is 1 or True.
    pub fn flag(self, name: &str) -> Result<bool, FormatError> {
        let value = self.get(name)?;
        let number = value.number();
        let number = number.ok_or_else(|| tensor(name, value.describe(), "True or False"))?;
        Ok(number != 0.0)
    }

    /// The shape of a tensor of as many dimensions as `expected` has. None among these: any size.
    pub fn shape(self, name: &str, expected: &[Option<usize>]) -> Result<&'p [usize], FormatError> {
        let value = self.get(name)?;
        let fits = |shape: &&[usize]| {
            let mut pairs = shape.iter().zip(expected);
            shape.len() == expected.len()
                && pairs.all(|(&size, wanted)| wanted.is_none_or(|wanted| wanted == size))
        };
        value.shape().filter(fits).ok_or_else(|| {
            let sizes: Vec<String> = expected
                .iter()
                .map(|size| size.map_or("any".into(), |size| size.to_string()))
                .collect();
            let expected = format!("an array of the shape [{}]", sizes.join(", "));
            tensor(name, value.describe(), expected)
        })
    }

    /// The floats of a tensor of this shape.
    pub fn floats(self, name: &str, shape: &[usize]) -> Result<Vec<f32>, FormatError> {
        let sizes: Vec<Option<usize>> = shape.iter().copied().map(Some).collect();
        self.shape(name, &sizes)?;
        let value = self.get(name)?;
        if value.float_bytes().is_none() {
            return Err(tensor(name, "integers", "floats"));
        }
        Ok(value.numbers(name)?.numbers)
    }

    /// The floats of a tensor of this shape, none larger than an avatar's numbers may be.
    pub fn numbers(self, name: &str, shape: &[usize]) -> Result<Vec<f32>, FormatError> {
        let numbers = self.floats(name, shape)?;
        let limit = FEATURE_MAX as f32;
        match numbers.iter().position(|number| number.abs() > limit) {
            Some(at) => Err(tensor(
                name,
                format!("{} at {at}", numbers[at]),
                format!("numbers within ±{limit}"),
            )),
            None => Ok(numbers),
        }
    }

    /// Rows of W such floats, in a tensor whose sizes multiply to that.
    pub fn rows<const W: usize>(
        self,
        name: &str,
        shape: &[usize],
    ) -> Result<Vec<[f32; W]>, FormatError> {
        let numbers = self.numbers(name, shape)?;
        Ok(numbers.as_chunks::<W>().0.to_vec())
    }

    /// The integers from 0 to below `end` of a tensor of this shape.
    pub fn indices(self, name: &str, shape: &[usize], end: usize) -> Result<Vec<u32>, FormatError> {
        let sizes: Vec<Option<usize>> = shape.iter().copied().map(Some).collect();
        self.shape(name, &sizes)?;
        let numbers = self.get(name)?.numbers(name)?.numbers;
        // Whole numbers below 2^24 are exact in f32; no array here is that long.
        let good =
            |&number: &f32| number >= 0.0 && number.fract() == 0.0 && (number as usize) < end;
        match numbers.iter().position(|number| !good(number)) {
            Some(at) => Err(tensor(
                name,
                format!("{} at {at}", numbers[at]),
                format!("integers below {end}"),
            )),
            None => Ok(numbers.iter().map(|&number| number as u32).collect()),
        }
    }
}
