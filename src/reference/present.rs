//! The `present` stage: a picture goes in, what a screen of another size shows of it over a background comes out.

use crate::frame::Picture;

/// RGB, row by row from the top left; `size`: width and height of the screen, px. Between the middles of pixels colours are mixed by how near
/// they are; beyond those at the edge they stay as they are.
pub fn over(picture: &Picture, size: [u32; 2], background: [f32; 3]) -> Vec<[f64; 3]> {
    let [width, height] = picture.size.map(f64::from);
    let texel = |x: f64, y: f64| {
        let at = |v: f64, side: f64| v.clamp(0.0, side - 1.0) as usize;
        picture.pixels[at(y, height) * picture.size[0] as usize + at(x, width)].map(f64::from)
    };
    let pixel = |x: u32, y: u32| {
        let (x, y) = ((f64::from(x) + 0.5) * width / f64::from(size[0]) - 0.5, (f64::from(y) + 0.5) * height / f64::from(size[1]) - 0.5);
        let (left, top) = (x.floor(), y.floor());
        let [across, down] = [x - left, y - top];
        let corners = [[left, top], [left + 1.0, top], [left, top + 1.0], [left + 1.0, top + 1.0]].map(|[x, y]| texel(x, y));
        let weights = [(1.0 - across) * (1.0 - down), across * (1.0 - down), (1.0 - across) * down, across * down];
        let mixed: [f64; 4] = std::array::from_fn(|k| corners.iter().zip(weights).map(|(corner, weight)| weight * corner[k]).sum());
        std::array::from_fn(|k| (mixed[k] + (1.0 - mixed[3]) * f64::from(background[k])).clamp(0.0, 1.0))
    };
    (0..size[1]).flat_map(|y| (0..size[0]).map(move |x| (x, y))).map(|(x, y)| pixel(x, y)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_of_the_screens_size_is_shown_as_it_is() {
        let pixels = vec![[1.0, 0.0, 0.0, 1.0], [0.0, 0.25, 0.0, 0.5], [0.0; 4], [0.0, 0.0, 1.0, 1.0]];
        let picture = Picture { size: [2, 2], pixels };
        assert_eq!(over(&picture, [2, 2], [0.5; 3]), [[1.0, 0.0, 0.0], [0.25, 0.5, 0.25], [0.5; 3], [0.0, 0.0, 1.0]]);
        let wide = over(&picture, [4, 2], [0.0; 3]);
        // A quarter of the way from the first pixel's middle to the second's.
        assert_eq!((wide[0], wide[1]), ([1.0, 0.0, 0.0], [0.75, 0.0625, 0.0]));
    }
}
