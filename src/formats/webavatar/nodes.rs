//! Where the nodes are, which the file does not say. It does say each Gaussian's three nearest
//! nodes and their weights, 1/d scaled to a sum of 1, so distances up to a factor a Gaussian. With
//! some sixty Gaussians a node that is more than enough.

use glam::{DMat3, DVec3};

/// Rounds of the fit, at most: in each, every node moves to where its distances fit best.
const ROUNDS: usize = 200;
/// The fit ends when no node moves further in a round, metres.
const STILL: f64 = 2e-6;
/// A node with a weight of at least this is where the Gaussian is: nodes are chosen among the
/// Gaussians' first positions.
const SAME: f64 = 0.995;
/// Least distance that weights were computed with, metres.
const NEAREST: f64 = 1e-6;

/// Three nodes of a Gaussian, and their weights.
#[derive(Clone, Copy, Debug)]
pub struct Influence {
    pub node: [u16; 3],
    /// Not negative; at least one above 0.
    pub weight: [f64; 3],
}

/// Positions of nodes, and how well they explain the weights.
pub struct NodeFit {
    /// Metres; in the middle of the Gaussians for a node that none has.
    pub position: Vec<DVec3>,
    /// Root mean square of what the weights differ by.
    pub deviation: f64,
}

/// Finds `count` nodes from the Gaussians' positions, metres.
pub fn fit(position: &[DVec3], influence: &[Influence], count: usize) -> NodeFit {
    let mut nodes = first_guess(position, influence, count);
    let known = coincident(influence, count);
    for (node, gaussian) in known.iter().enumerate() {
        if let Some(gaussian) = gaussian {
            nodes[node] = position[*gaussian];
        }
    }
    for _ in 0..ROUNDS {
        let mut steps = vec![Step::default(); count];
        for (&x, near) in position.iter().zip(influence) {
            add(&mut steps, &nodes, x, near);
        }
        let mut furthest: f64 = 0.0;
        for (node, step) in steps.iter().enumerate() {
            if known[node].is_none() {
                let moved = step.solve();
                nodes[node] += moved;
                furthest = furthest.max(moved.length());
            }
        }
        if furthest < STILL {
            break;
        }
    }
    NodeFit {
        deviation: deviation(position, influence, &nodes),
        position: nodes,
    }
}

/// The mean of a node's Gaussians, those with large weights first.
fn first_guess(position: &[DVec3], influence: &[Influence], count: usize) -> Vec<DVec3> {
    let middle = position.iter().sum::<DVec3>() / position.len().max(1) as f64;
    let mut sums = vec![(DVec3::ZERO, 0.0); count];
    for (&x, near) in position.iter().zip(influence) {
        for (&node, &weight) in near.node.iter().zip(&near.weight) {
            let (sum, share) = &mut sums[usize::from(node)];
            let square = weight * weight;
            *sum += square * x;
            *share += square;
        }
    }
    sums.into_iter()
        .map(|(sum, share)| if share > 0.0 { sum / share } else { middle })
        .collect()
}

/// The Gaussian that each node is at, where there is one.
fn coincident(influence: &[Influence], count: usize) -> Vec<Option<usize>> {
    let mut found = vec![None; count];
    let mut best = vec![SAME; count];
    for (gaussian, near) in influence.iter().enumerate() {
        for (&node, &weight) in near.node.iter().zip(&near.weight) {
            let node = usize::from(node);
            if weight > best[node] {
                best[node] = weight;
                found[node] = Some(gaussian);
            }
        }
    }
    found
}

/// The normal equations of one node's move.
#[derive(Clone, Copy, Default)]
struct Step {
    matrix: DMat3,
    side: DVec3,
    /// Sum of the squared weights, which damps moves that no distance constrains.
    total: f64,
}

impl Step {
    fn solve(self) -> DVec3 {
        if self.total <= 0.0 {
            return DVec3::ZERO;
        }
        let damped = self.matrix + DMat3::from_diagonal(DVec3::splat(0.002 * self.total));
        damped.inverse() * self.side
    }
}

/// Adds what one Gaussian asks of its nodes: distances in proportion to 1 / weight.
fn add(steps: &mut [Step], nodes: &[DVec3], x: DVec3, near: &Influence) {
    let offset = near.node.map(|node| nodes[usize::from(node)] - x);
    let distance = offset.map(|offset| offset.length().max(NEAREST));
    // The factor with which the distances that the weights ask for are nearest to those there are.
    let products: [f64; 3] = std::array::from_fn(|k| distance[k] * near.weight[k]);
    let sum: f64 = products.iter().sum();
    if sum <= 0.0 {
        return;
    }
    let factor = products.iter().map(|p| p * p).sum::<f64>() / sum;
    for k in 0..3 {
        if near.weight[k] <= 0.0 {
            continue;
        }
        let target = factor / near.weight[k];
        let direction = offset[k] / distance[k];
        let share = 1.0 / (target * target).max(NEAREST * NEAREST);
        let step = &mut steps[usize::from(near.node[k])];
        step.matrix += share * outer(direction);
        step.side += share * (target - distance[k]) * direction;
        step.total += share;
    }
}

fn outer(v: DVec3) -> DMat3 {
    DMat3::from_cols(v * v.x, v * v.y, v * v.z)
}

/// Root mean square of what weights from these nodes differ by.
fn deviation(position: &[DVec3], influence: &[Influence], nodes: &[DVec3]) -> f64 {
    let mut sum = 0.0;
    for (&x, near) in position.iter().zip(influence) {
        let inverse = near
            .node
            .map(|node| 1.0 / nodes[usize::from(node)].distance(x).max(NEAREST));
        let total: f64 = inverse.iter().sum();
        for (part, weight) in inverse.iter().zip(near.weight) {
            sum += (part / total - weight).powi(2);
        }
    }
    (sum / (3 * position.len().max(1)) as f64).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use effigy_core::random::Random;

    #[test]
    fn nodes_of_a_folded_sheet_are_found_from_rounded_weights() {
        let random = &mut Random::new(5, 0);
        let mut on_sheet = || {
            let [u, v] = [random.uniform(), random.uniform()];
            DVec3::new(0.4 * u, 0.4 * v, 0.05 * (9.0 * u).sin())
        };
        let nodes: Vec<DVec3> = (0..60).map(|_| on_sheet()).collect();
        let position: Vec<DVec3> = (0..3000).map(|_| on_sheet()).collect();
        let influence: Vec<Influence> = position
            .iter()
            .map(|&x| {
                let mut near: Vec<u16> = (0..60).collect();
                near.sort_by(|&a, &b| {
                    let distance = |node: u16| nodes[usize::from(node)].distance(x);
                    distance(a).total_cmp(&distance(b))
                });
                let node = [near[0], near[1], near[2]];
                let inverse = node.map(|node| 1.0 / nodes[usize::from(node)].distance(x));
                let weight = inverse
                    .map(|part| half::f16::from_f64(part / inverse.iter().sum::<f64>()).to_f64());
                Influence { node, weight }
            })
            .collect();
        let fit = fit(&position, &influence, 61);
        let worst = nodes
            .iter()
            .zip(&fit.position)
            .map(|(a, b)| a.distance(*b))
            .fold(0.0, f64::max);
        assert!(worst < 2e-4, "a node is {worst} m off");
        assert!(fit.deviation < 2e-3, "{}", fit.deviation);
        assert!(fit.position[60].is_finite(), "a node that no Gaussian has");
    }
}
