//! The greatest number of each window, with stride 1, and its gradient.

use crate::maps::Maps;
use rayon::prelude::*;

/// What each window has. `window`: its side.
pub fn forward(input: &Maps, window: usize) -> Maps {
    let [width, height] = input.size;
    let size = [width + 1 - window, height + 1 - window];
    input.mapped(size, |output, input| {
        let mut greatest = vec![0.0f32; width];
        for (y, output) in output.chunks_exact_mut(size[0]).enumerate() {
            greatest.copy_from_slice(&input[y * width..][..width]);
            for row in input[(y + 1) * width..]
                .chunks_exact(width)
                .take(window - 1)
            {
                for (greatest, number) in greatest.iter_mut().zip(row) {
                    *greatest = greatest.max(*number);
                }
            }
            output.copy_from_slice(&greatest[..size[0]]);
            for across in 1..window {
                for (output, number) in output.iter_mut().zip(&greatest[across..]) {
                    *output = output.max(*number);
                }
            }
        }
    })
}

/// The gradient with respect to what was read: a window's goes to the first of its pixels, row by
/// row, that has its greatest number.
pub fn backward(gradient: &Maps, input: &Maps, output: &Maps, window: usize) -> Maps {
    let [width, height] = input.size;
    let size = output.size;
    let mut into = Maps::zeros(input.channels, input.size);
    into.data
        .par_chunks_exact_mut(width * height)
        .enumerate()
        .for_each(|(channel, into)| {
            let input = &input.data[channel * width * height..][..width * height];
            let plane = channel * size[0] * size[1];
            // What a window has left to give.
            let mut left = vec![0.0f32; size[0]];
            for y in 0..size[1] {
                let row = plane + y * size[0]..plane + (y + 1) * size[0];
                left.copy_from_slice(&gradient.data[row.clone()]);
                let greatest = &output.data[row];
                for (down, across) in (0..window).flat_map(|y| (0..window).map(move |x| (y, x))) {
                    let at = (y + down) * width + across;
                    let numbers = input[at..][..size[0]].iter().zip(greatest);
                    let into = into[at..][..size[0]].iter_mut().zip(&mut left);
                    for ((number, greatest), (into, left)) in numbers.zip(into) {
                        let is_greatest = number == greatest;
                        *into += if is_greatest { *left } else { 0.0 };
                        *left = if is_greatest { 0.0 } else { *left };
                    }
                }
            }
        });
    into
}
