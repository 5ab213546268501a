//! Stage `present`: an image over a background, scaled to the size of a window.

use crate::scene::FrameImage;

/// Blends an image over a background and scales it to `size`, px, with bilinear filtering and
/// clamping at the edges. RGB, row by row from the top left.
pub fn over(image: &FrameImage, size: [u32; 2], background: [f32; 3]) -> Vec<[f64; 3]> {
    let [width, height] = image.size.map(f64::from);
    let texel = |x: f64, y: f64| {
        let at = |v: f64, side: f64| v.clamp(0.0, side - 1.0) as usize;
        image.pixels[at(y, height) * image.size[0] as usize + at(x, width)].map(f64::from)
    };
    let pixel = |x: u32, y: u32| {
        let x = (f64::from(x) + 0.5) * width / f64::from(size[0]) - 0.5;
        let y = (f64::from(y) + 0.5) * height / f64::from(size[1]) - 0.5;
        let left = x.floor();
        let top = y.floor();
        let across = x - left;
        let down = y - top;
        let corners = [
            [left, top],
            [left + 1.0, top],
            [left, top + 1.0],
            [left + 1.0, top + 1.0],
        ]
        .map(|[x, y]| texel(x, y));
        let weights = [
            (1.0 - across) * (1.0 - down),
            across * (1.0 - down),
            (1.0 - across) * down,
            across * down,
        ];
        let mixed: [f64; 4] = std::array::from_fn(|k| {
            corners
                .iter()
                .zip(weights)
                .map(|(corner, weight)| weight * corner[k])
                .sum()
        });
        std::array::from_fn(|k| {
            (mixed[k] + (1.0 - mixed[3]) * f64::from(background[k])).clamp(0.0, 1.0)
        })
    };
    (0..size[1])
        .flat_map(|y| (0..size[0]).map(move |x| (x, y)))
        .map(|(x, y)| pixel(x, y))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_image_of_the_windows_size_is_not_filtered() {
        let pixels = vec![
            [1.0, 0.0, 0.0, 1.0],
            [0.0, 0.25, 0.0, 0.5],
            [0.0; 4],
            [0.0, 0.0, 1.0, 1.0],
        ];
        let image = FrameImage {
            size: [2, 2],
            pixels,
        };
        assert_eq!(
            over(&image, [2, 2], [0.5; 3]),
            [
                [1.0, 0.0, 0.0],
                [0.25, 0.5, 0.25],
                [0.5; 3],
                [0.0, 0.0, 1.0]
            ]
        );
        let wide = over(&image, [4, 2], [0.0; 3]);
        // A quarter of the way from the first pixel's middle to the second's.
        assert_eq!((wide[0], wide[1]), ([1.0, 0.0, 0.0], [0.75, 0.0625, 0.0]));
    }
}
