//! Weights of a network: from the file of the package `stlpips-pytorch`, or made for tests.

use crate::{
    convolution::Convolution,
    error::PerceptualError,
    network::{LAYERS, Network},
};
use effigy_core::{
    io::file::{FileError, FormatError},
    random::Random,
};
use effigy_formats::pickle::{Pickle, Value};
use std::{fs, io::Read, path::Path};

/// Files may be this large, bytes: VGG's has 59 MB.
const MAX_BYTES: u64 = 128 << 20;
/// How far the sum of all magnitudes may be from what it should be, of itself.
const SUM_TOLERANCE: f64 = 1e-6;
/// Streams of random numbers of the heads follow on those of convolutions.
const HEAD_STREAMS: u64 = 1000;

/// All weights of a network.
#[derive(Clone, Debug)]
pub struct Weights {
    /// In the order of [`Network::convolutions`].
    pub convolutions: Vec<Convolution>,
    /// What a channel's squared difference counts in each layer.
    pub heads: [Vec<f32>; LAYERS],
}

/// The sum of the magnitudes of all numbers of the published file.
fn expected_sum(network: Network) -> f64 {
    match network {
        Network::Alex => 31_828.961_92,
        Network::Vgg => 283_299.600_4,
    }
}

/// Reads the published file of a network.
pub fn read(network: Network, path: &Path) -> Result<Weights, PerceptualError> {
    let unreadable = |cause| FileError::Read {
        file: path.to_owned(),
        cause,
    };
    let file = fs::File::open(path).map_err(unreadable)?;
    let mut bytes = Vec::new();
    file.take(MAX_BYTES + 1)
        .read_to_end(&mut bytes)
        .map_err(unreadable)?;
    let weights = from_bytes(network, &bytes).map_err(|fault| FileError::Content {
        file: path.to_owned(),
        fault,
    })?;
    Ok(weights)
}

/// Reads the bytes of a file.
pub fn from_bytes(network: Network, bytes: &[u8]) -> Result<Weights, FormatError> {
    if bytes.len() as u64 > MAX_BYTES {
        return Err(FormatError::container(
            format!("more than {MAX_BYTES} bytes"),
            format!("{} of stlpips-pytorch 0.0.2", network.file_name()),
        ));
    }
    let pickle = Pickle::from_bytes(bytes)?;
    let mut reader = Reader {
        root: pickle.root(),
        sum: 0.0,
    };
    // The shift and scale of colours are the same in all versions: they are constants here.
    for (name, expected) in [("shift", crate::head::SHIFT), ("scale", crate::head::SCALE)] {
        let name = format!("scaling_layer.{name}");
        let found = reader.numbers(&name, &[1, 3, 1, 1])?;
        if found
            .iter()
            .zip(&expected)
            .any(|(a, b)| (a - b).abs() > 1e-6)
        {
            return Err(tensor(&name, format!("{found:?}"), format!("{expected:?}")));
        }
    }
    let mut convolutions = Vec::new();
    for shape in network.convolutions() {
        let sides = [shape.to, shape.from, shape.window, shape.window];
        let weight = reader.numbers(&format!("{}.weight", shape.name), &sides)?;
        let bias = reader.numbers(&format!("{}.bias", shape.name), &[shape.to])?;
        convolutions.push(Convolution::new(shape, weight, bias));
    }
    let widths = network.widths();
    let mut heads = [const { Vec::new() }; LAYERS];
    for (layer, head) in heads.iter_mut().enumerate() {
        let name = format!("lin{layer}.model.1.weight");
        *head = reader.numbers(&name, &[1, widths[layer], 1, 1])?;
    }
    reader.blurs()?;
    let expected = expected_sum(network);
    if (reader.sum - expected).abs() > SUM_TOLERANCE * expected {
        return Err(FormatError::container(
            format!("weights whose magnitudes add up to {}", reader.sum),
            format!(
                "{expected}, as in {} of stlpips-pytorch 0.0.2",
                network.file_name()
            ),
        ));
    }
    Ok(Weights {
        convolutions,
        heads,
    })
}

fn tensor(name: &str, found: impl ToString, expected: impl ToString) -> FormatError {
    FormatError::Tensor {
        tensor: name.to_owned(),
        found: found.to_string(),
        expected: expected.to_string(),
    }
}

/// The tensors of a file, and the magnitudes of those that were read.
struct Reader<'p> {
    root: Value<'p>,
    sum: f64,
}

impl Reader<'_> {
    fn numbers(&mut self, name: &str, shape: &[usize]) -> Result<Vec<f32>, FormatError> {
        let value = self.root.get(name);
        let value = value.ok_or_else(|| {
            tensor(
                name,
                format!("nothing in {}", self.root.describe()),
                format!("{shape:?}"),
            )
        })?;
        // Looked at before memory is taken.
        if value.shape() != Some(shape) {
            return Err(tensor(
                name,
                value.describe(),
                format!("the shape {shape:?}"),
            ));
        }
        let numbers = value.numbers(name)?.numbers;
        self.sum += numbers.iter().map(|&n| f64::from(n.abs())).sum::<f64>();
        Ok(numbers)
    }

    /// Every blur must be the one that is written down here.
    fn blurs(&mut self) -> Result<(), FormatError> {
        let names: Vec<String> = self
            .root
            .keys()
            .into_iter()
            .flatten()
            .filter_map(|key| key.text())
            .filter(|name| name.ends_with(".filt"))
            .map(str::to_owned)
            .collect();
        for name in names {
            let channels = self.root.get(&name).and_then(|value| value.shape());
            let channels = channels.and_then(|shape| shape.first().copied());
            let filter = self.numbers(&name, &[channels.unwrap_or_default(), 1, 3, 3])?;
            let expected = [1.0, 2.0, 1.0, 2.0, 4.0, 2.0, 1.0, 2.0, 1.0].map(|n: f32| n / 16.0);
            if let Some(wrong) = filter.chunks(9).find(|nine| *nine != expected) {
                return Err(tensor(&name, format!("{wrong:?}"), format!("{expected:?}")));
            }
        }
        Ok(())
    }
}

/// Weights that are the same for a seed on every machine: a stream of random numbers for each
/// tensor.
pub fn random(network: Network, seed: u64) -> Weights {
    let mut convolutions = Vec::new();
    for (index, shape) in network.convolutions().enumerate() {
        let index = index as u64;
        let mut numbers = Random::new(seed, 2 * index);
        // The variance of what comes out is then that of what goes in.
        let reach = (6.0 / shape.fan() as f64).sqrt();
        let count = shape.to * shape.fan();
        let weight = (0..count).map(|_| ((2.0 * numbers.uniform() - 1.0) * reach) as f32);
        let mut numbers = Random::new(seed, 2 * index + 1);
        let bias = (0..shape.to).map(|_| (0.2 * numbers.uniform() - 0.1) as f32);
        convolutions.push(Convolution::new(shape, weight.collect(), bias.collect()));
    }
    let mut layer = 0;
    let heads = network.widths().map(|width| {
        let mut numbers = Random::new(seed, HEAD_STREAMS + layer);
        layer += 1;
        (0..width).map(|_| numbers.uniform() as f32).collect()
    });
    Weights {
        convolutions,
        heads,
    }
}
