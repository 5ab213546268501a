//! Every so many rows and columns of feature maps, from the first, and the gradient: a stride after
//! a step without one.

use crate::{maps::Maps, network::Step};
use rayon::prelude::*;

/// What is kept. `step`: from a row or column that is kept to the next.
pub fn forward(input: &Maps, step: usize) -> Maps {
    let [width, height] = input.size;
    let size = input.size.map(|side| Step::Thin(step).side(side));
    let mut output = Maps::zeros(input.channels, size);
    let plane = output.plane();
    output
        .data
        .par_chunks_exact_mut(plane)
        .zip(input.data.par_chunks_exact(width * height))
        .for_each(|(output, input)| {
            let rows = input.chunks_exact(width).step_by(step);
            for (output, row) in output.chunks_exact_mut(size[0]).zip(rows) {
                for (output, number) in output.iter_mut().zip(row.iter().step_by(step)) {
                    *output = *number;
                }
            }
        });
    output
}

/// The gradient with respect to what was read: none for what was not kept. `read`: its size.
pub fn backward(gradient: &Maps, read: [usize; 2], step: usize) -> Maps {
    let [width, height] = read;
    let size = gradient.size;
    let mut into = Maps::zeros(gradient.channels, read);
    into.data
        .par_chunks_exact_mut(width * height)
        .zip(gradient.data.par_chunks_exact(size[0] * size[1]))
        .for_each(|(into, gradient)| {
            let rows = into.chunks_exact_mut(width).step_by(step);
            for (row, gradient) in rows.zip(gradient.chunks_exact(size[0])) {
                for (into, number) in row.iter_mut().step_by(step).zip(gradient) {
                    *into = *number;
                }
            }
        });
    into
}
