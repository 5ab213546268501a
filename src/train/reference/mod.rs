//! The loss of a step and its derivative in f64: the chain of the stages of
//! `effigy_core::reference`, each with the derivative beside it.
//!
//! Tests compare the kernels with this, and this with finite differences of the loss.

use crate::loss::LossWeights;
use crate::parameters::{BASIS, GAUSSIAN, ParameterLayout, Parameters, sigmoid};
use crate::topology::{CorrectiveRows, Topology};
use crate::view::{Shows, TrainingView};
use effigy_core::avatar::{Facing, ROW_COMPONENTS, matrix::Row};
use effigy_core::reference::basis::{combine, combine_backward};
use effigy_core::reference::mlp::{Neuron, activate, activate_backward, linear, linear_backward};
use effigy_core::reference::nodes::displacement;
use effigy_core::reference::project::{
    Canonical, CanonicalGradient, Culled, Gaussian, GaussianGradient, Splat, pose, pose_backward,
    project_backward, project_opaque, skinning,
};
use effigy_core::reference::raster::{Canvas, Cutoff, raster_backward, raster_with};
use effigy_core::reference::sort;
use glam::{DAffine3, DVec3};
use rayon::prelude::*;

/// All that a step's loss depends on, except what is learned.
#[derive(Clone, Copy)]
pub struct Problem<'a> {
    /// What stays as it is.
    pub topology: &'a Topology,
    /// Which Gaussians have correctives.
    pub rows: &'a CorrectiveRows,
    /// Where what is learned lies.
    pub layout: &'a ParameterLayout,
    /// Weights of the losses.
    pub weights: &'a LossWeights,
    /// Whether there are correctives at all.
    pub correctives: bool,
    /// How contributions under the opacity cutoff vanish.
    pub cutoff: Cutoff,
}

/// The results of all stages of a view.
pub struct Forward {
    /// The results of each layer of each part's network.
    pub activations: Vec<Vec<Vec<f64>>>,
    /// Displacements of the nodes, metres.
    pub nodes: Vec<DVec3>,
    /// Each Gaussian in canonical space.
    pub canonical: Vec<Canonical>,
    /// δr, δs and δc of each Gaussian; ten numbers.
    pub correctives: Vec<[f64; 10]>,
    /// Its skinning transform.
    pub skinning: Vec<DAffine3>,
    /// Each posed.
    pub gaussians: Vec<Gaussian>,
    /// 0 to 255, not rounded.
    pub opacity: Vec<f64>,
    /// Each in the image.
    pub splats: Vec<Result<Splat, Culled>>,
    /// Indices into `splats`, far to near.
    pub order: Vec<u32>,
    /// The image.
    pub canvas: Canvas,
}

impl Problem<'_> {
    /// Runs the stages for a view.
    pub fn forward(&self, p: &Parameters<f64>, view: &TrainingView) -> Forward {
        let topology = self.topology;
        let count = topology.gaussians.len();
        let activations: Vec<Vec<Vec<f64>>> = (0..topology.parts())
            .into_par_iter()
            .map(|part| self.network(p, part, &self.entered(view, part)))
            .collect();
        let nodes: Vec<DVec3> = (0..topology.nodes())
            .map(|node| self.node(p, node, &activations))
            .collect();
        let correctives: Vec<[f64; 10]> = (0..count)
            .map(|k| self.correctives(p, k, &activations))
            .collect();
        let canonical: Vec<Canonical> = (0..count)
            .map(|k| self.canonical(p, k, &nodes, &correctives[k]))
            .collect();
        let skinning: Vec<DAffine3> = topology
            .gaussians
            .iter()
            .map(|placed| skinning(&view.joints, placed.joint, placed.joint_weight))
            .collect();
        let gaussians: Vec<Gaussian> = canonical
            .iter()
            .zip(&skinning)
            .zip(&topology.gaussians)
            .map(|((canonical, g), placed)| Gaussian {
                facing: Facing::decode(placed.facing).moved(&g.matrix3),
                ..pose(canonical, g, 255)
            })
            .collect();
        let opacity: Vec<f64> = (0..count)
            .map(|k| 255.0 * sigmoid(p.gaussians[k * GAUSSIAN + 7]))
            .collect();
        let splats: Vec<Result<Splat, Culled>> = gaussians
            .iter()
            .zip(&opacity)
            .map(|(gaussian, &opacity)| {
                project_opaque(gaussian, opacity, &view.camera, topology.filter)
            })
            .collect();
        let order = sort::order(&splats);
        let canvas = raster_with(&splats, &order, &view.camera, self.cutoff);
        Forward {
            activations,
            nodes,
            canonical,
            correctives,
            skinning,
            gaussians,
            opacity,
            splats,
            order,
            canvas,
        }
    }

    /// Displacement of a node.
    fn node(&self, p: &Parameters<f64>, node: usize, activations: &[Vec<Vec<f64>>]) -> DVec3 {
        let offset = DVec3::from_slice(&p.nodes[3 * node..]);
        if !self.correctives {
            return offset;
        }
        let part = usize::from(self.topology.node_part[node]);
        let e = &features(&activations[part])[BASIS..];
        let basis = Row::Doubles(&p.nodes[self.layout.node_basis(node)]);
        offset + DVec3::from(combine::<3>(basis, e))
    }

    /// δr, δs and δc of a Gaussian.
    fn correctives(
        &self,
        p: &Parameters<f64>,
        gaussian: usize,
        activations: &[Vec<Vec<f64>>],
    ) -> [f64; 10] {
        let part = usize::from(self.topology.gaussians[gaussian].part);
        let e = &features(&activations[part])[..BASIS];
        let mut all = [0.0; 10];
        let mut at = 0;
        for (attribute, components) in ROW_COMPONENTS.into_iter().enumerate() {
            if let Some(row) = self.row(attribute, gaussian) {
                let basis = &p.bases[self.layout.row(attribute, row)];
                for (c, functions) in basis.chunks_exact(BASIS).enumerate() {
                    all[at + c] = Row::Doubles(functions).dot(e);
                }
            }
            at += components;
        }
        all
    }

    /// A Gaussian in canonical space. `delta`: its correctives.
    fn canonical(
        &self,
        p: &Parameters<f64>,
        gaussian: usize,
        nodes: &[DVec3],
        delta: &[f64; 10],
    ) -> Canonical {
        let placed = &self.topology.gaussians[gaussian];
        let own = &p.gaussians[gaussian * GAUSSIAN..][..GAUSSIAN];
        Canonical {
            position: placed.position + displacement(placed.node_weight, placed.node, nodes),
            neutral_rotation: std::array::from_fn(|c| own[c]),
            rotation_corrective: std::array::from_fn(|c| delta[c]),
            log_scale: DVec3::from_slice(&own[4..]) + DVec3::from_slice(&delta[4..]),
            color: DVec3::from_slice(&own[8..]) + DVec3::from_slice(&delta[7..]),
        }
    }

    /// The loss of some views: the mean over them.
    pub fn loss(&self, p: &Parameters<f64>, views: &[TrainingView]) -> f64 {
        let all = views.iter().map(|view| {
            let forward = self.forward(p, view);
            self.picture_loss(&forward.canvas, view) + self.other_losses(&forward)
        });
        all.sum::<f64>() / views.len() as f64
    }

    /// The derivative of [`Self::loss`] with respect to everything that is learned.
    pub fn gradient(&self, p: &Parameters<f64>, views: &[TrainingView]) -> Parameters<f64> {
        let mut total = Parameters::zeros(self.layout);
        for view in views {
            let forward = self.forward(p, view);
            let of_canvas = self.picture_loss_backward(&forward.canvas, view);
            self.backward(p, view, &forward, &of_canvas, &mut total);
        }
        for array in total.arrays_mut() {
            for number in array.iter_mut() {
                *number /= views.len() as f64;
            }
        }
        total
    }

    /// Adds the derivative of one view's losses. `of_canvas`: of the loss with respect to its image.
    pub fn backward(
        &self,
        p: &Parameters<f64>,
        view: &TrainingView,
        forward: &Forward,
        of_canvas: &[[f64; 4]],
        total: &mut Parameters<f64>,
    ) {
        let topology = self.topology;
        let of_gaussians = self.of_gaussians(view, forward, of_canvas);
        let mut of_nodes = vec![DVec3::ZERO; topology.nodes()];
        let mut of_features = vec![vec![0.0; 2 * BASIS]; topology.parts()];
        for (k, placed) in topology.gaussians.iter().enumerate() {
            let of = self.canonical_backward(k, forward, &of_gaussians[k]);
            let own = &mut total.gaussians[k * GAUSSIAN..][..GAUSSIAN];
            let mut add = |at: usize, of: &[f64]| {
                for (own, of) in own[at..].iter_mut().zip(of) {
                    *own += of;
                }
            };
            add(0, &of.rotation);
            add(4, &of.log_scale.to_array());
            let o = forward.opacity[k] / 255.0;
            add(7, &[of_gaussians[k].opacity * 255.0 * o * (1.0 - o)]);
            add(8, &of.color.to_array());
            for (&node, &weight) in placed.node.iter().zip(&placed.node_weight) {
                of_nodes[usize::from(node)] += weight * of.position;
            }
            let of_part = &mut of_features[usize::from(placed.part)];
            self.correctives_backward(p, k, forward, &of, of_part, total);
        }
        for (node, &of) in of_nodes.iter().enumerate() {
            let of_part = &mut of_features[usize::from(topology.node_part[node])];
            self.node_backward(p, node, forward, of, of_part, total);
        }
        if self.correctives {
            for (part, of_features) in of_features.iter().enumerate() {
                let activations = &forward.activations[part];
                self.network_backward(p, view, part, activations, of_features, total);
            }
        }
    }

    /// The derivative with respect to a Gaussian in canonical space, the loss of scales included.
    fn canonical_backward(
        &self,
        gaussian: usize,
        forward: &Forward,
        of_gaussian: &GaussianGradient,
    ) -> CanonicalGradient {
        let canonical = &forward.canonical[gaussian];
        let numbers = 3.0 * forward.canonical.len() as f64;
        let mut of = pose_backward(canonical, &forward.skinning[gaussian], of_gaussian);
        let scale = canonical.log_scale.exp();
        for c in 0..3 {
            if scale[c] > self.weights.scale_above {
                of.log_scale[c] += self.weights.scale * scale[c] / numbers;
            }
        }
        of
    }

    /// Adds the derivatives of a Gaussian's basis rows and, to `of_features`, of its part's
    /// features. `of`: with respect to the Gaussian in canonical space. Correctives have a loss of
    /// their own.
    fn correctives_backward(
        &self,
        p: &Parameters<f64>,
        gaussian: usize,
        forward: &Forward,
        of: &CanonicalGradient,
        of_features: &mut [f64],
        total: &mut Parameters<f64>,
    ) {
        let count = forward.canonical.len() as f64;
        let delta = &forward.correctives[gaussian];
        let mut of_delta: Vec<f64> = of.rotation.to_vec();
        of_delta.extend(of.log_scale.to_array());
        of_delta.extend(of.color.to_array());
        let part = usize::from(self.topology.gaussians[gaussian].part);
        let e = features(&forward.activations[part]);
        let mut at = 0;
        for (attribute, components) in ROW_COMPONENTS.into_iter().enumerate() {
            let weight = self.weights.correctives[attribute] / (components as f64 * count);
            if let Some(row) = self.row(attribute, gaussian) {
                let first = self.layout.row(attribute, row).start;
                for c in 0..components {
                    let of = of_delta[at + c] + weight * sign(delta[at + c]);
                    let functions = first + c * BASIS;
                    for b in 0..BASIS {
                        total.bases[functions + b] += of * e[b];
                        of_features[b] += of * p.bases[functions + b];
                    }
                }
            }
            at += components;
        }
    }

    /// Adds the derivatives of a node's offset and basis and, to `of_features`, of its part's
    /// features. `of`: with respect to its displacement.
    fn node_backward(
        &self,
        p: &Parameters<f64>,
        node: usize,
        forward: &Forward,
        of: DVec3,
        of_features: &mut [f64],
        total: &mut Parameters<f64>,
    ) {
        for c in 0..3 {
            total.nodes[3 * node + c] += of[c];
        }
        if !self.correctives {
            return;
        }
        let place = self.layout.node_basis(node);
        let part = usize::from(self.topology.node_part[node]);
        let e = &features(&forward.activations[part])[BASIS..];
        for (at, number) in total.nodes[place.clone()].iter_mut().enumerate() {
            *number += of[at / BASIS] * e[at % BASIS];
        }
        let basis = Row::Doubles(&p.nodes[place]);
        combine_backward(basis, of.to_array(), &mut of_features[BASIS..]);
    }

    /// The derivative of a loss of the image with respect to each posed Gaussian.
    fn of_gaussians(
        &self,
        view: &TrainingView,
        forward: &Forward,
        of_canvas: &[[f64; 4]],
    ) -> Vec<GaussianGradient> {
        let of_splats = raster_backward(
            &forward.splats,
            &forward.order,
            &view.camera,
            self.cutoff,
            &forward.canvas,
            of_canvas,
        );
        (0..of_splats.len())
            .map(|k| match &forward.splats[k] {
                Ok(splat) => project_backward(
                    &forward.gaussians[k],
                    forward.opacity[k],
                    &view.camera,
                    self.topology.filter,
                    splat,
                    &of_splats[k],
                ),
                Err(_) => GaussianGradient::ZERO,
            })
            .collect()
    }

    /// The derivative of a loss of the image with respect to G of each joint. The networks' inputs
    /// are held fixed.
    pub fn joints_gradient(
        &self,
        view: &TrainingView,
        forward: &Forward,
        of_canvas: &[[f64; 4]],
    ) -> Vec<DAffine3> {
        let mut joints = vec![DAffine3::ZERO; self.topology.joints];
        let of_gaussians = self.of_gaussians(view, forward, of_canvas);
        for (k, placed) in self.topology.gaussians.iter().enumerate() {
            let of = pose_backward(
                &forward.canonical[k],
                &forward.skinning[k],
                &of_gaussians[k],
            );
            for (&joint, &weight) in placed.joint.iter().zip(&placed.joint_weight) {
                let own = &mut joints[usize::from(joint)];
                let weight = f64::from(weight) / 255.0;
                own.matrix3 += of.skinning.matrix3 * weight;
                own.translation += of.skinning.translation * weight;
            }
        }
        joints
    }

    /// The row of an attribute of a Gaussian, where there are correctives.
    fn row(&self, attribute: usize, gaussian: usize) -> Option<usize> {
        let row = self.rows.row(attribute, gaussian);
        row.filter(|_| self.correctives)
    }

    /// The input of a part's network.
    fn entered(&self, view: &TrainingView, part: usize) -> Vec<f64> {
        let mut entered = view.input.clone();
        if part >= self.topology.head_parts {
            entered[self.topology.expression_start..].fill(0.0);
        }
        entered
    }

    /// A part's weights of a layer, a row a neuron.
    fn weights(&self, p: &Parameters<f64>, part: usize, layer: usize) -> Vec<f64> {
        let place = &self.layout.layers[layer];
        let own = &p.networks[place.weights + part * place.input * place.output..];
        (0..place.output)
            .flat_map(|neuron| (0..place.input).map(move |i| own[i * place.output + neuron]))
            .collect()
    }

    fn network(&self, p: &Parameters<f64>, part: usize, input: &[f64]) -> Vec<Vec<f64>> {
        let mut results: Vec<Vec<f64>> = Vec::new();
        for (l, place) in self.layout.layers.iter().enumerate() {
            let weights = self.weights(p, part, l);
            let x = results.last().map_or(input, Vec::as_slice);
            let mut y = linear(x, place.output, |k| Neuron {
                weight: Row::Doubles(&weights[k * place.input..][..place.input]),
                bias: p.networks[place.biases + part * place.output + k],
            });
            if l + 1 < self.layout.layers.len() {
                for y in &mut y {
                    *y = activate(self.topology.activation, *y);
                }
            }
            results.push(y);
        }
        results
    }

    fn network_backward(
        &self,
        p: &Parameters<f64>,
        view: &TrainingView,
        part: usize,
        activations: &[Vec<f64>],
        of_features: &[f64],
        total: &mut Parameters<f64>,
    ) {
        let input = self.entered(view, part);
        let mut of = of_features.to_vec();
        for (l, place) in self.layout.layers.iter().enumerate().rev() {
            let x = if l > 0 { &activations[l - 1] } else { &input };
            let first = place.weights + part * place.input * place.output;
            for (neuron, of) in of.iter().enumerate() {
                for (i, x) in x.iter().enumerate() {
                    total.networks[first + i * place.output + neuron] += of * x;
                }
                total.networks[place.biases + part * place.output + neuron] += of;
            }
            if l == 0 {
                break;
            }
            let weights = self.weights(p, part, l);
            of = linear_backward(&of, place.input, |k| Neuron {
                weight: Row::Doubles(&weights[k * place.input..][..place.input]),
                bias: 0.0,
            });
            for (of, &y) in of.iter_mut().zip(x) {
                *of *= activate_backward(self.topology.activation, y);
            }
        }
    }

    /// Mean of |image over background − picture|, weighted.
    fn picture_loss(&self, canvas: &Canvas, view: &TrainingView) -> f64 {
        let sum: f64 = (0..canvas.pixels.len())
            .map(|at| difference(canvas, view, at).map_or(0.0, |d| d.abs().element_sum()))
            .sum();
        self.weights.l1 * sum / (3.0 * view.whole as f64)
    }

    /// The derivative of the picture's loss with respect to the canvas.
    pub fn picture_loss_backward(&self, canvas: &Canvas, view: &TrainingView) -> Vec<[f64; 4]> {
        let weight = self.weights.l1 / (3.0 * view.whole as f64);
        (0..canvas.pixels.len())
            .map(|at| {
                let Some(difference) = difference(canvas, view, at) else {
                    return [0.0; 4];
                };
                let over = over(canvas, view, at);
                let mut of = DVec3::ZERO;
                for c in 0..3 {
                    if (0.0..=1.0).contains(&over[c]) {
                        of[c] = weight * sign(difference[c]);
                    }
                }
                let of_canvas = view.gain * of;
                let behind = view.picture.background(at);
                of_canvas.extend(-of.dot(behind)).to_array()
            })
            .collect()
    }

    /// The derivative of the picture's loss with respect to the view's gain, RGB.
    pub fn gain_gradient(&self, canvas: &Canvas, view: &TrainingView) -> DVec3 {
        let of_canvas = self.picture_loss_backward(canvas, view);
        let pairs = of_canvas.iter().zip(&canvas.pixels);
        let sum: DVec3 = pairs
            .map(|(of, pixel)| DVec3::from_slice(of) * DVec3::from_slice(pixel))
            .sum();
        sum / view.gain
    }

    /// Losses of scales and correctives.
    fn other_losses(&self, forward: &Forward) -> f64 {
        let count = forward.canonical.len() as f64;
        let scale: f64 = forward
            .canonical
            .iter()
            .flat_map(|canonical| canonical.log_scale.exp().to_array())
            .filter(|&s| s > self.weights.scale_above)
            .sum();
        let mut at = 0;
        let mut sum = self.weights.scale * scale / (3.0 * count);
        for (attribute, components) in ROW_COMPONENTS.into_iter().enumerate() {
            let own = at..at + components;
            let all: f64 = forward
                .correctives
                .iter()
                .flat_map(|delta| delta[own.clone()].iter())
                .map(|v| v.abs())
                .sum();
            sum += self.weights.correctives[attribute] * all / (components as f64 * count);
            at += components;
        }
        sum
    }
}

/// The features of a part: its last layer's results.
fn features(activations: &[Vec<f64>]) -> &[f64] {
    activations.last().map_or(&[], Vec::as_slice)
}

/// −1, 0 or 1.
fn sign(x: f64) -> f64 {
    if x == 0.0 { 0.0 } else { x.signum() }
}

/// A pixel of the image over its background.
fn over(canvas: &Canvas, view: &TrainingView, at: usize) -> DVec3 {
    let [r, g, b, coverage] = canvas.pixels[at];
    view.gain * DVec3::new(r, g, b) + (1.0 - coverage) * view.picture.background(at)
}

/// Image minus picture at a pixel; None where the picture is unknown.
fn difference(canvas: &Canvas, view: &TrainingView, at: usize) -> Option<DVec3> {
    if view.picture.shows(at) == Shows::Unknown {
        return None;
    }
    let over = over(canvas, view, at).clamp(DVec3::ZERO, DVec3::ONE);
    Some(over - view.picture.color(at))
}

#[cfg(test)]
mod tests;
