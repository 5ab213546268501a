//! Weights of a network: from the files of the packages `stlpips-pytorch`, `lpips` and torchvision,
//! or made for tests.

use crate::{
    convolution::Convolution,
    error::PerceptualError,
    network::{LAYERS, Network, WeightFile, WeightParts},
};
use effigy_core::{
    io::file::{FileError, FormatError},
    random::Random,
};
use effigy_formats::pickle::{Pickle, Value};
use std::{fs, io::Read, path::Path};

/// Files may be this large, bytes: torchvision's VGG16 has 553 MB.
const MAX_BYTES: u64 = 640 << 20;
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

/// Reads files of a network that lie in a folder.
pub fn read(
    network: Network,
    files: &[WeightFile],
    folder: &Path,
) -> Result<Weights, PerceptualError> {
    let mut weights = Weights {
        convolutions: Vec::new(),
        heads: [const { Vec::new() }; LAYERS],
    };
    for file in files {
        let path = folder.join(file.name);
        let unreadable = |cause| FileError::Read {
            file: path.clone(),
            cause,
        };
        let mut bytes = Vec::new();
        let opened = fs::File::open(&path).map_err(unreadable)?;
        opened
            .take(MAX_BYTES + 1)
            .read_to_end(&mut bytes)
            .map_err(unreadable)?;
        take(network, file, &bytes, &mut weights)
            .map_err(|fault| FileError::Content { file: path, fault })?;
    }
    Ok(weights)
}

/// Takes what a file has of a network's weights from its bytes.
fn take(
    network: Network,
    file: &WeightFile,
    bytes: &[u8],
    weights: &mut Weights,
) -> Result<(), FormatError> {
    if bytes.len() as u64 > MAX_BYTES {
        return Err(FormatError::container(
            format!("more than {MAX_BYTES} bytes"),
            format!("{} {}", file.name, file.origin),
        ));
    }
    let pickle = Pickle::from_bytes(bytes)?;
    let mut reader = Reader {
        root: pickle.root(),
        sum: 0.0,
    };
    // The shift and scale of colours are the same in all versions: they are constants here.
    let colors = [("shift", crate::head::SHIFT), ("scale", crate::head::SCALE)];
    for (name, expected) in colors.iter().filter(|_| file.parts == WeightParts::All) {
        let name = format!("scaling_layer.{name}");
        let found = reader.numbers(&name, &[1, 3, 1, 1])?;
        if found
            .iter()
            .zip(expected)
            .any(|(a, b)| (a - b).abs() > 1e-6)
        {
            return Err(tensor(&name, format!("{found:?}"), format!("{expected:?}")));
        }
    }
    if file.parts != WeightParts::Heads {
        for shape in network.convolutions() {
            let sides = [shape.to, shape.from, shape.window, shape.window];
            let weight = reader.numbers(&format!("{}.weight", shape.name), &sides)?;
            let bias = reader.numbers(&format!("{}.bias", shape.name), &[shape.to])?;
            let convolution = Convolution::new(shape, weight, bias);
            weights.convolutions.push(convolution);
        }
    }
    if file.parts != WeightParts::Trunk {
        let widths = network.widths();
        for (layer, head) in weights.heads.iter_mut().enumerate() {
            let name = format!("lin{layer}.model.1.weight");
            *head = reader.numbers(&name, &[1, widths[layer], 1, 1])?;
        }
    }
    reader.blurs()?;
    if let Some(expected) = file.sum
        && (reader.sum - expected).abs() > SUM_TOLERANCE * expected
    {
        return Err(FormatError::container(
            format!("weights whose magnitudes add up to {}", reader.sum),
            format!("{expected}, as in {} {}", file.name, file.origin),
        ));
    }
    Ok(())
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Perceptual;

    /// A tensor of a file.
    struct Tensor<'a> {
        name: String,
        shape: Vec<usize>,
        numbers: &'a [f32],
    }

    /// Appends text as a pickle has it.
    fn push_text(bytes: &mut Vec<u8>, text: &str) {
        bytes.push(b'X');
        bytes.extend((text.len() as u32).to_le_bytes());
        bytes.extend(text.as_bytes());
    }

    /// Appends a tuple of integers.
    fn push_sizes(bytes: &mut Vec<u8>, sizes: &[usize]) {
        bytes.push(b'(');
        for &size in sizes {
            bytes.push(b'J');
            bytes.extend((size as u32).to_le_bytes());
        }
        bytes.push(b't');
    }

    /// A file as PyTorch 0.1 wrote it: pickles in a row, the memory of tensors behind them.
    fn saved(tensors: &[Tensor]) -> Vec<u8> {
        let mut bytes = b"\x80\x02\x8a\x0al\xfc\x9cF\xf9 j\xa8P\x19.".to_vec();
        bytes.extend(b"\x80\x02M\xe9\x03.\x80\x02}.\x80\x02}");
        for (key, tensor) in tensors.iter().enumerate() {
            push_text(&mut bytes, &tensor.name);
            bytes.extend(b"ctorch._utils\n_rebuild_tensor\n((");
            push_text(&mut bytes, "storage");
            bytes.extend(b"ctorch\nFloatStorage\n");
            push_text(&mut bytes, &key.to_string());
            push_text(&mut bytes, "cpu");
            bytes.push(b'J');
            bytes.extend((tensor.numbers.len() as u32).to_le_bytes());
            bytes.extend(b"NtQK\0");
            push_sizes(&mut bytes, &tensor.shape);
            let stride = |axis: usize| tensor.shape[axis + 1..].iter().product();
            let strides: Vec<usize> = (0..tensor.shape.len()).map(stride).collect();
            push_sizes(&mut bytes, &strides);
            bytes.extend(b"tRs");
        }
        bytes.extend(b".\x80\x02]");
        for key in 0..tensors.len() {
            push_text(&mut bytes, &key.to_string());
            bytes.push(b'a');
        }
        bytes.push(b'.');
        for tensor in tensors {
            bytes.extend((tensor.numbers.len() as u64).to_le_bytes());
            bytes.extend(
                tensor
                    .numbers
                    .iter()
                    .flat_map(|number| number.to_le_bytes()),
            );
        }
        bytes
    }

    /// What torchvision's file has of some weights, and something that is not needed.
    fn trunk(weights: &Weights) -> Vec<u8> {
        let mut tensors = vec![Tensor {
            name: "classifier.6.bias".into(),
            shape: vec![2],
            numbers: &[f32::NAN; 2],
        }];
        for convolution in &weights.convolutions {
            let shape = convolution.shape;
            tensors.push(Tensor {
                name: format!("{}.weight", shape.name),
                shape: vec![shape.to, shape.from, shape.window, shape.window],
                numbers: &convolution.weight,
            });
            tensors.push(Tensor {
                name: format!("{}.bias", shape.name),
                shape: vec![shape.to],
                numbers: &convolution.bias,
            });
        }
        saved(&tensors)
    }

    /// What the file of the package `lpips` has of some weights.
    fn heads(weights: &Weights) -> Vec<u8> {
        let heads = weights.heads.iter().enumerate();
        let tensors: Vec<Tensor> = heads
            .map(|(layer, head)| Tensor {
                name: format!("lin{layer}.model.1.weight"),
                shape: vec![1, head.len(), 1, 1],
                numbers: head,
            })
            .collect();
        saved(&tensors)
    }

    #[test]
    fn files_of_lpips_are_read_and_others_named() {
        let network = Network::LpipsAlex;
        let folder = tempfile::tempdir().expect("a folder");
        let made = random(network, 9);
        let [of_heads, of_trunk] = [0, 1].map(|at| network.files()[at]);
        let write = |file: WeightFile, bytes: &[u8]| {
            fs::write(folder.path().join(file.name), bytes).expect("a file can be written");
        };
        let error = |result: Result<Weights, PerceptualError>| {
            result.expect_err("another file").to_string()
        };
        let asked = || Perceptual::read(network, folder.path()).map(|_| made.clone());
        let missing = error(asked());
        assert!(missing.contains("lpips_alex.pth"), "{missing}");
        assert!(missing.contains("tools/fetch_perceptual.sh"), "{missing}");
        write(of_heads, &heads(&made));
        let missing = error(asked());
        assert!(missing.starts_with("LPIPS (alex)"), "{missing}");
        assert!(
            missing.contains("models/alexnet-owt-7be5be79.pth"),
            "{missing}"
        );
        write(of_trunk, &trunk(&made));
        // Heads whose sum is another one, as those of version 0.0.
        let other = error(asked());
        assert!(other.contains("lpips_alex.pth"), "{other}");
        assert!(other.contains("expected 105.275"), "{other}");

        let unsummed = [
            WeightFile {
                sum: None,
                ..of_heads
            },
            of_trunk,
        ];
        let read_again = || read(network, &unsummed, folder.path());
        let found = read_again().expect("what was written");
        let pairs = found.convolutions.iter().zip(&made.convolutions);
        assert_eq!(found.convolutions.len(), made.convolutions.len());
        for (found, made) in pairs {
            assert!(found.weight == made.weight && found.bias == made.bias);
        }
        assert_eq!(found.heads, made.heads);

        let mut spoiled = made.clone();
        spoiled.convolutions[2].bias[7] = f32::NAN;
        write(of_trunk, &trunk(&spoiled));
        let spoiled = error(read_again());
        assert!(spoiled.contains("features.6.bias"), "{spoiled}");
        assert!(spoiled.contains("NaN at 7"), "{spoiled}");
        let bytes = trunk(&made);
        write(of_trunk, &bytes[..bytes.len() - 1]);
        let cut = error(read_again());
        assert!(cut.contains("alexnet-owt-7be5be79.pth"), "{cut}");
        write(of_trunk, &trunk(&random(Network::LpipsVgg, 9)));
        let vgg = error(read_again());
        assert!(vgg.contains("features.0.weight"), "{vgg}");
        assert!(vgg.contains("[64, 3, 11, 11]"), "{vgg}");
    }
}
