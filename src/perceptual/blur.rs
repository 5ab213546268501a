//! The blur that halves feature maps, and its gradient: [1, 2, 1] / 4 across and down, with stride
//! 2, after two mirrored pixels were added to each side.

use crate::{maps::Maps, network::NetworkStep};

/// The three pixels of a line under the window of a written one, mirrored at the ends. They count
/// 1, 2 and 1.
fn under(at: usize, length: usize) -> [usize; 3] {
    let mirrored = |place: usize| {
        // Places count from two pixels before the line.
        let place = place.abs_diff(2);
        if place < length {
            place
        } else {
            2 * length - 2 - place
        }
    };
    [2 * at, 2 * at + 1, 2 * at + 2].map(mirrored)
}

/// The blurred maps. Both sides must be at least 3.
pub fn forward(input: &Maps) -> Maps {
    let [width, height] = input.size;
    let size = input.size.map(|side| NetworkStep::Blur.side(side));
    input.mapped(size, |output, input| {
        let mut line = vec![0.0f32; width];
        for (y, output) in output.chunks_exact_mut(size[0]).enumerate() {
            let [a, b, c] = under(y, height).map(|row| &input[row * width..][..width]);
            for (((line, a), b), c) in line.iter_mut().zip(a).zip(b).zip(c) {
                *line = (a + 2.0 * b + c) * (1.0 / 16.0);
            }
            for (x, output) in output.iter_mut().enumerate() {
                let [a, b, c] = under(x, width).map(|column| line[column]);
                *output = a + 2.0 * b + c;
            }
        }
    })
}

/// The gradient with respect to what was read. `read`: its size.
pub fn backward(gradient: &Maps, read: [usize; 2]) -> Maps {
    let [width, height] = read;
    let size = gradient.size;
    gradient.mapped(read, |into, gradient| {
        let mut line = vec![0.0f32; width];
        for (y, gradient) in gradient.chunks_exact(size[0]).enumerate() {
            line.fill(0.0);
            for (x, gradient) in gradient.iter().enumerate() {
                let gradient = gradient * (1.0 / 16.0);
                for (column, share) in under(x, width).into_iter().zip([1.0, 2.0, 1.0]) {
                    line[column] += share * gradient;
                }
            }
            for (row, share) in under(y, height).into_iter().zip([1.0, 2.0, 1.0]) {
                let into = &mut into[row * width..][..width];
                for (into, line) in into.iter_mut().zip(&line) {
                    *into += share * line;
                }
            }
        }
    })
}
