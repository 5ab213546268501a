//! How long the perceptual losses take here: milliseconds of the target's features, of the value
//! and of value and gradient, the best of some rounds, and billions of operations a second of the
//! convolutions.
//!
//! ```sh
//! cargo run --release -p effigy-perceptual --example perceptual-speed -- [ROUNDS] [SIDE...]
//! ```

use effigy_perceptual::{Network, Perceptual, Planes, dssim_and_gradient};
use std::{env, hint::black_box, time::Instant};

fn main() {
    let numbers: Vec<usize> = env::args().skip(1).filter_map(|a| a.parse().ok()).collect();
    let rounds = numbers.first().copied().unwrap_or(20);
    let sides = match numbers.get(1..) {
        Some(sides) if !sides.is_empty() => sides.to_vec(),
        _ => vec![64, 128, 256],
    };
    println!(
        "{:8}{:>6}{:>14}{:>11}{:>19}{:>10}",
        "loss", "side", "features, ms", "value, ms", "with gradient, ms", "GFLOP/s"
    );
    for network in [Network::Alex, Network::Vgg] {
        let perceptual = Perceptual::random(network, 1);
        for &side in &sides {
            let image = picture(side, 3);
            let target = picture(side, 5);
            let features = perceptual.features(&target);
            let seen = best(rounds, || {
                black_box(perceptual.features(&target));
            });
            let value = best(rounds, || {
                black_box(perceptual.value(&image, &features));
            });
            let graded = best(rounds, || {
                black_box(perceptual.value_and_gradient(&image, &features));
            });
            println!(
                "{:8}{side:>6}{:>14.1}{:>11.1}{:>19.1}{:>10.0}",
                network.name(),
                1e3 * seen,
                1e3 * value,
                1e3 * graded,
                2e-9 * network.operations([side; 2]) / graded
            );
        }
    }
    for &side in &sides {
        let (image, target) = (picture(side, 3), picture(side, 5));
        let graded = best(rounds, || {
            black_box(dssim_and_gradient(&image, &target));
        });
        println!("{:8}{side:>6}{:>44.1}", "dssim", 1e3 * graded);
    }
}

/// A picture with structure of all sizes.
fn picture(side: usize, seed: usize) -> Planes {
    let mut picture = Planes::black([side; 2]);
    for (i, number) in picture.data.iter_mut().enumerate() {
        let (x, y) = (i % side, i / side);
        *number = ((seed * x * x + 7 * y + x * y / 3) % 256) as f32 / 255.0;
    }
    picture
}

/// Seconds of the fastest round.
fn best(rounds: usize, mut run: impl FnMut()) -> f64 {
    let time = |_| {
        let start = Instant::now();
        run();
        start.elapsed().as_secs_f64()
    };
    (0..rounds).map(time).fold(f64::INFINITY, f64::min)
}
