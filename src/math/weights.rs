//! Weights in bytes.

/// Weights in bytes that sum to 255, from weights that sum to 1: the largest remainders are rounded
/// up, of equal ones the first.
pub fn weight_bytes(weights: [f64; 4]) -> [u8; 4] {
    let exact = weights.map(|w| 255.0 * w);
    let mut bytes = exact.map(|w| w.floor() as u8);
    let mut order = [0, 1, 2, 3];
    order.sort_by(|&a: &usize, &b| exact[b].fract().total_cmp(&exact[a].fract()));
    let missing = 255 - bytes.iter().map(|&b| u32::from(b)).sum::<u32>();
    for at in order.into_iter().cycle().take(missing as usize) {
        bytes[at] += 1;
    }
    bytes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn they_sum_to_255() {
        for weights in [
            [1.0, 0.0, 0.0, 0.0],
            [0.25; 4],
            [0.4, 0.3, 0.2, 0.1],
            [1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0, 0.0],
        ] {
            let bytes = weight_bytes(weights);
            assert_eq!(bytes.iter().map(|&b| u32::from(b)).sum::<u32>(), 255);
            let near =
                |(&byte, weight): (&u8, f64)| (f64::from(byte) - 255.0 * weight).abs() <= 1.0;
            assert!(bytes.iter().zip(weights).all(near), "{bytes:?}");
        }
    }
}
