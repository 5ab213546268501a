//! How long the perceptual losses take here: milliseconds of the target's features, of the value
//! and of value and gradient, the best of some rounds, and billions of operations a second of the
//! convolutions, over time and over the processor's time of all threads. The latter tells more on a
//! machine that others use.
//!
//! ```sh
//! cargo run --release -p effigy-perceptual --example perceptual-speed -- \
//!     [alex|vgg|lpips-alex|lpips-vgg|dssim] [ROUNDS [SIDE...]]
//! ```

use effigy_perceptual::{Network, Perceptual, Planes, dssim_and_gradient};
use std::{env, fs, hint::black_box, path::Path, time::Instant};

fn main() {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let numbers: Vec<usize> = arguments.iter().filter_map(|a| a.parse().ok()).collect();
    let rounds = numbers.first().copied().unwrap_or(20);
    let sides = match numbers.get(1..) {
        Some(sides) if !sides.is_empty() => sides.to_vec(),
        _ => vec![64, 128, 256],
    };
    let networks = [
        Network::Alex,
        Network::Vgg,
        Network::LpipsAlex,
        Network::LpipsVgg,
    ];
    let asked = |name: &str| {
        let is_name = |argument: &String| argument.parse::<usize>().is_err();
        !arguments.iter().any(is_name) || arguments.iter().any(|argument| argument == name)
    };
    println!(
        "{:11}{:>6}{:>14}{:>11}{:>19}{:>10}{:>17}",
        "loss", "side", "features, ms", "value, ms", "with gradient, ms", "GFLOP/s", "a CPU second"
    );
    for network in networks {
        if !asked(network.name()) {
            continue;
        }
        measure(network, rounds, &sides);
    }
    for &side in sides.iter().filter(|_| asked("dssim")) {
        let (image, target) = (picture(side, 3), picture(side, 5));
        let graded = best(rounds, || {
            black_box(dssim_and_gradient(&image, &target));
        });
        println!("{:11}{side:>6}{:>44.1}", "dssim", 1e3 * graded);
    }
}

/// Prints how long a network's loss takes at each side, px.
fn measure(network: Network, rounds: usize, sides: &[usize]) {
    let start = Instant::now();
    let folder = env::var("EFFIGY_ASSETS").unwrap_or("target/assets".into());
    let perceptual = match Perceptual::read(network, Path::new(&folder)) {
        Ok(perceptual) => perceptual,
        Err(error) => {
            println!("random weights: {error}");
            Perceptual::random(network, 1)
        }
    };
    let read = start.elapsed().as_secs_f64();
    let start = Instant::now();
    let checked = perceptual.check();
    let check = start.elapsed().as_secs_f64();
    println!(
        "{:11}read in {:.0} ms, checked in {:.0} ms: {}",
        network.name(),
        1e3 * read,
        1e3 * check,
        checked.map_or_else(|error| error.to_string(), |()| "right".into())
    );
    for &side in sides {
        let image = picture(side, 3);
        let target = picture(side, 5);
        let features = perceptual.features(&target);
        let seen = best(rounds, || {
            black_box(perceptual.features(&target));
        });
        let value = best(rounds, || {
            black_box(perceptual.value(&image, &features));
        });
        let before = processor_seconds();
        let graded = best(rounds, || {
            black_box(perceptual.value_and_gradient(&image, &features));
        });
        let processor = (processor_seconds() - before) / rounds as f64;
        let billions = 2e-9 * network.operations([side; 2]);
        println!(
            "{:11}{side:>6}{:>14.1}{:>11.1}{:>19.1}{:>10.0}{:>17.0}",
            network.name(),
            1e3 * seen,
            1e3 * value,
            1e3 * graded,
            billions / graded,
            billions / processor
        );
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

/// Seconds that processors gave all threads; NaN where Linux doesn't say.
fn processor_seconds() -> f64 {
    let Ok(tasks) = fs::read_dir("/proc/self/task") else {
        return f64::NAN;
    };
    let nanoseconds = tasks.flatten().filter_map(|task| {
        let text = fs::read_to_string(task.path().join("schedstat")).ok()?;
        text.split_whitespace().next()?.parse::<f64>().ok()
    });
    1e-9 * nanoseconds.sum::<f64>()
}
