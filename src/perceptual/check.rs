//! The check at the start: a known distance and a known derivative.

use crate::{
    error::PerceptualError,
    network::Network,
    planes::{Graded, Planes},
    reference,
    synthetic::{direction, picture},
    weights::Weights,
};

/// Width and height of the built-in pictures, px.
const SIZE: [usize; 2] = [32, 32];
/// How far the distance may be off, of itself, and the derivative, of what it usually is: f32 puts
/// a few numbers on the other side of 0, or makes another pixel the greatest.
const VALUE_TOLERANCE: f64 = 1e-4;
const SLOPE_TOLERANCE: f64 = 5e-3;

/// The distance of the built-in pictures, and its derivative along the built-in direction.
#[derive(Clone, Copy, Debug)]
pub struct KnownDistance {
    value: f64,
    slope: f64,
}

/// Of the published weights, found by tests/data/perceptual/make.py. None for LPIPS, whose weights
/// it was not given.
pub fn published(network: Network) -> Option<KnownDistance> {
    match network {
        Network::Alex => Some(KnownDistance {
            value: 0.342_493_751_899,
            slope: 0.047_809_810_123,
        }),
        Network::Vgg => Some(KnownDistance {
            value: 0.236_079_900_038,
            slope: -0.036_148_800_151,
        }),
        Network::LpipsAlex | Network::LpipsVgg => None,
    }
}

/// Of any weights, in f64.
pub fn worked_out(network: Network, weights: &Weights) -> KnownDistance {
    let pictures = [&picture(0, SIZE), &direction(SIZE), &picture(1, SIZE)];
    let found = reference::differential(network, weights, pictures);
    KnownDistance {
        value: found.value,
        slope: found.slope,
    }
}

/// Compares what is worked out with what is known.
pub fn compare(
    network: Network,
    known: &KnownDistance,
    graded: impl Fn(&Planes, &Planes) -> Graded,
) -> Result<(), PerceptualError> {
    let found = graded(&picture(0, SIZE), &picture(1, SIZE));
    let steps = found.gradient.data.iter().zip(direction(SIZE).data);
    let slope: f64 = steps.map(|(g, d)| f64::from(*g) * f64::from(d)).sum();
    // A derivative may be small by chance: errors are of what it is along most directions.
    let usual = (found.gradient.data.iter()).map(|&g| f64::from(g).powi(2));
    let usual = (usual.sum::<f64>() / 3.0).sqrt();
    for (what, found, expected, allowed) in [
        (
            "the distance",
            found.value,
            known.value,
            VALUE_TOLERANCE * known.value,
        ),
        ("a derivative", slope, known.slope, SLOPE_TOLERANCE * usual),
    ] {
        // NaN is wrong too.
        let right = (found - expected).abs() <= allowed;
        if !right {
            return Err(PerceptualError::Wrong {
                measure: network.title(),
                what,
                found,
                expected,
            });
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wrong_distances_and_wrong_gradients_are_seen() {
        let known = KnownDistance {
            value: 0.5,
            slope: 2.0,
        };
        // A gradient along the direction, so that its derivative is 2.
        let right = |_: &Planes, _: &Planes| {
            let mut gradient = direction(SIZE);
            let squares: f32 = gradient.data.iter().map(|n| n * n).sum();
            gradient.data.iter_mut().for_each(|n| *n *= 2.0 / squares);
            Graded {
                value: 0.5,
                gradient,
            }
        };
        let found = |change: fn(&mut Graded)| {
            compare(Network::Alex, &known, |image, target| {
                let mut graded = right(image, target);
                change(&mut graded);
                graded
            })
        };
        assert!(found(|_| {}).is_ok());
        let error = found(|graded| graded.value *= 1.001).expect_err("a wrong distance");
        assert_eq!(
            error.to_string(),
            "ST-LPIPS (alex): the distance of the built-in pictures is 0.5005, expected 0.5"
        );
        assert!(found(|graded| graded.value = f64::NAN).is_err());
        assert!(found(|graded| graded.gradient.data.rotate_left(1)).is_err());
        assert!(found(|graded| graded.gradient.data.fill(0.0)).is_err());
        assert!(found(|graded| graded.gradient.data[5] = f32::NAN).is_err());
    }
}
