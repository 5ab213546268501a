//! Every so many rows and columns of feature maps, from the first, and the gradient: a stride after
//! a step without one.

use crate::{maps::Maps, network::NetworkStep};

/// What is kept. `step`: from a row or column that is kept to the next.
pub fn forward(input: &Maps, step: usize) -> Maps {
    let width = input.size[0];
    let size = input.size.map(|side| NetworkStep::Thin(step).side(side));
    input.mapped(size, |output, input| {
        let rows = input.chunks_exact(width).step_by(step);
        for (output, row) in output.chunks_exact_mut(size[0]).zip(rows) {
            for (output, number) in output.iter_mut().zip(row.iter().step_by(step)) {
                *output = *number;
            }
        }
    })
}

/// The gradient with respect to what was read: none for what was not kept. `read`: its size.
pub fn backward(gradient: &Maps, read: [usize; 2], step: usize) -> Maps {
    let width = read[0];
    let size = gradient.size;
    gradient.mapped(read, |into, gradient| {
        let rows = into.chunks_exact_mut(width).step_by(step);
        for (row, gradient) in rows.zip(gradient.chunks_exact(size[0])) {
            for (into, number) in row.iter_mut().step_by(step).zip(gradient) {
                *into = *number;
            }
        }
    })
}
