//! Whether an avatar is closed: an image goes in, how much light its silhouette lets through comes
//! out.
//!
//! A closed body covers every pixel inside its silhouette. Where Gaussians part, on stretched cloth
//! for instance, the background shines through.

use effigy_core::scene::FrameImage;

/// Coverage under which a pixel inside the silhouette counts as a hole, 0 to 1.
pub const CLOSED: f64 = 0.98;
/// Coverage of a pixel that the avatar misses: what is as empty belongs to the background, also
/// where the avatar surrounds it.
const EMPTY: f32 = 0.02;
/// Coverage of the silhouette's edge.
const EDGE: f32 = 0.5;
/// Pixels along the silhouette that are not judged: Gaussians fade out there.
const BORDER: usize = 3;

/// How much of the background shows inside a silhouette.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SilhouetteCoverage {
    /// Pixels inside.
    pub pixels: usize,
    /// Mean coverage, 0 to 1; 1 if no pixel is inside.
    pub mean: f64,
    /// Pixels whose coverage is under [`CLOSED`].
    pub holes: usize,
}

/// Measures the coverage inside the silhouette. Pixels outside are those that a path through pixels
/// less than half covered joins to an empty pixel or to the image's border. Pixels within
/// `BORDER` of those are not counted.
pub fn inside_silhouette(image: &FrameImage) -> SilhouetteCoverage {
    let mut outside = reached(image);
    for _ in 0..BORDER {
        outside = grown(&outside, image.size);
    }
    let inside = image.pixels.iter().zip(&outside);
    let coverages: Vec<f64> = inside
        .filter(|(_, outside)| !**outside)
        .map(|(pixel, _)| f64::from(pixel[3]))
        .collect();
    let pixels = coverages.len();
    SilhouetteCoverage {
        pixels,
        mean: if pixels == 0 {
            1.0
        } else {
            coverages.iter().sum::<f64>() / pixels as f64
        },
        holes: coverages.iter().filter(|&&at| at < CLOSED).count(),
    }
}

/// The pixels of the background, its edges up to half coverage included.
fn reached(image: &FrameImage) -> Vec<bool> {
    let [width, height] = image.size.map(|side| side as usize);
    let mut reached = vec![false; image.pixels.len()];
    let mut waiting = Vec::new();
    for (at, pixel) in image.pixels.iter().enumerate() {
        let column = at % width;
        let row = at / width;
        let on_border = column == 0 || row == 0 || column + 1 == width || row + 1 == height;
        if pixel[3] < EMPTY || (on_border && pixel[3] < EDGE) {
            reached[at] = true;
            waiting.push(at);
        }
    }
    while let Some(at) = waiting.pop() {
        for beside in neighbors(at, [width, height]) {
            if !reached[beside] && image.pixels[beside][3] < EDGE {
                reached[beside] = true;
                waiting.push(beside);
            }
        }
    }
    reached
}

/// A set of pixels with those beside them.
fn grown(set: &[bool], size: [u32; 2]) -> Vec<bool> {
    let size = size.map(|side| side as usize);
    let near = |at: usize| neighbors(at, size).any(|beside| set[beside]);
    (0..set.len()).map(|at| set[at] || near(at)).collect()
}

/// The pixels that share a side with one.
fn neighbors(at: usize, [width, height]: [usize; 2]) -> impl Iterator<Item = usize> {
    let column = at % width;
    let row = at / width;
    [
        (column > 0).then(|| at - 1),
        (column + 1 < width).then(|| at + 1),
        (row > 0).then(|| at - width),
        (row + 1 < height).then(|| at + width),
    ]
    .into_iter()
    .flatten()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A disc of radius 20 px in an image of 64, with a coverage.
    fn disc(coverage: impl Fn(i32, i32) -> f32) -> FrameImage {
        let mut image = FrameImage::empty([64, 64]);
        for (at, pixel) in image.pixels.iter_mut().enumerate() {
            let x = at as i32 % 64 - 32;
            let y = at as i32 / 64 - 32;
            if x * x + y * y <= 400 {
                pixel[3] = coverage(x, y);
            }
        }
        image
    }

    #[test]
    fn a_closed_disc_has_no_holes() {
        let found = inside_silhouette(&disc(|_, _| 1.0));
        assert!(found.pixels > 800 && found.pixels < 1000, "{found:?}");
        assert_eq!((found.mean, found.holes), (1.0, 0));
    }

    #[test]
    fn a_crack_is_a_hole_although_it_is_less_than_half_covered() {
        let crack = |x: i32, y: i32| if x == 0 && y.abs() < 10 { 0.3 } else { 1.0 };
        let found = inside_silhouette(&disc(crack));
        assert_eq!(found.holes, 19);
        assert!(found.mean < 1.0);
    }

    #[test]
    fn an_opening_to_the_background_is_none() {
        let opening = |x: i32, y: i32| if x.abs() < 5 && y.abs() < 5 { 0.0 } else { 1.0 };
        assert_eq!(inside_silhouette(&disc(opening)).holes, 0);
        assert_eq!(inside_silhouette(&FrameImage::empty([8, 8])).pixels, 0);
    }
}
