//! The anchors' networks, which stay in the file until one is asked for: together they are most of
//! it.

use super::fields::CheckpointFields;
use crate::{fault::tensor, pickle::Value};
use effigy_core::{avatar::Activation, io::file::FormatError};

/// Layers of a network.
const MAX_LAYERS: usize = 16;
/// Numbers that enter or leave a layer.
const MAX_WIDTH: usize = 8192;

/// A layer of one network.
#[derive(Clone, Debug, PartialEq)]
pub struct LayerWeights {
    /// Numbers that enter a neuron.
    pub input: usize,
    /// Neurons.
    pub output: usize,
    /// Shape output, input.
    pub weight: Vec<f32>,
    /// Length output.
    pub bias: Vec<f32>,
}

/// The networks of all anchors, in the file. All have the same widths.
#[derive(Clone)]
pub struct NetworkSource<'p> {
    /// The nonlinearity of the hidden layers.
    pub activation: Activation,
    /// Number of networks, K.
    pub count: usize,
    /// Numbers that enter the first layer, then those that leave each layer.
    pub widths: Vec<usize>,
    layers: Vec<StoredLayer<'p>>,
}

#[derive(Clone)]
struct StoredLayer<'p> {
    name: String,
    weight: Value<'p>,
    bias: Value<'p>,
}

impl<'p> NetworkSource<'p> {
    /// Finds the layers and checks their shapes.
    pub(super) fn read(
        fields: CheckpointFields<'p>,
        activation: Activation,
    ) -> Result<Self, FormatError> {
        let params = CheckpointFields {
            root: fields.get("encoder_feat_params")?,
        };
        let mut layers = Vec::new();
        let mut widths = Vec::new();
        let mut count = 0;
        // Every other number is an activation.
        for layer in 0..=MAX_LAYERS {
            let name = format!("layers.{}", 2 * layer);
            let (weight_name, bias_name) = (format!("{name}.weight"), format!("{name}.bias"));
            if !params.has(&weight_name) && layer > 0 {
                break;
            }
            if layer == MAX_LAYERS {
                let expected = format!("at most {MAX_LAYERS} layers");
                return Err(tensor(&weight_name, "one more layer", expected));
            }
            let known = widths.last().copied();
            let networks = (layer > 0).then_some(count);
            let shape = params.shape(&weight_name, &[networks, None, known])?;
            let (found, output, input) = (shape[0], shape[1], shape[2]);
            let fits = |size: usize| size > 0 && size <= MAX_WIDTH;
            if !(fits(output) && fits(input) && found > 0) {
                let found = format!("the shape {shape:?}");
                return Err(tensor(
                    &weight_name,
                    found,
                    format!("sizes of 1 to {MAX_WIDTH}"),
                ));
            }
            params.shape(&bias_name, &[Some(found), Some(output)])?;
            if widths.is_empty() {
                widths.push(input);
            }
            widths.push(output);
            count = found;
            layers.push(StoredLayer {
                weight: params.get(&weight_name)?,
                bias: params.get(&bias_name)?,
                name,
            });
        }
        Ok(Self {
            activation,
            count,
            widths,
            layers,
        })
    }

    /// Bytes of all weights, as stored.
    pub(super) fn bytes(&self) -> Option<u64> {
        self.layers.iter().try_fold(0u64, |sum, layer| {
            let own = layer.weight.float_bytes()?;
            Some(
                sum.saturating_add(own)
                    .saturating_add(layer.bias.float_bytes()?),
            )
        })
    }

    /// Reads the network of an anchor.
    ///
    /// # Errors
    /// When a number is not finite, or there are fewer networks.
    pub fn network(&self, anchor: usize) -> Result<Vec<LayerWeights>, FormatError> {
        let layers = self.layers.iter().zip(self.widths.windows(2));
        layers
            .map(|(layer, widths)| {
                let rows = anchor..anchor + 1;
                Ok(LayerWeights {
                    input: widths[0],
                    output: widths[1],
                    weight: layer
                        .weight
                        .rows(&format!("{}.weight", layer.name), rows.clone())?
                        .numbers,
                    bias: layer
                        .bias
                        .rows(&format!("{}.bias", layer.name), rows)?
                        .numbers,
                })
            })
            .collect()
    }
}
