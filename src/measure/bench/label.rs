//! Where to write names beside points so that they can be read. In: the points, the size of each name, what else is in the way
//! and the picture. Out: the upper
//! left corner of each name.

/// Room between a point and its name, px.
const GAP: i32 = 12;

/// A rectangle in a picture: left, top, right, bottom; px.
pub type Rectangle = [i32; 4];

/// How many pixels two rectangles share.
fn shared(a: Rectangle, b: Rectangle) -> i64 {
    let along = |low: usize, high: usize| i64::from((a[high].min(b[high]) - a[low].max(b[low])).max(0));
    along(0, 2) * along(1, 3)
}

fn area(a: Rectangle) -> i64 {
    i64::from(a[2] - a[0]) * i64::from(a[3] - a[1])
}

/// Places names in the order given: each takes the nearest place around its point, with the least of other names, points,
/// obstacles and the outside under it.
pub fn place(points: &[(i32, i32)], sizes: &[(i32, i32)], obstacles: &[Rectangle], frame: Rectangle) -> Vec<(i32, i32)> {
    let marks: Vec<Rectangle> = points.iter().map(|&(x, y)| [x - 5, y - 5, x + 6, y + 6]).collect();
    let mut placed: Vec<Rectangle> = Vec::with_capacity(points.len());
    for (&(x, y), &(width, height)) in points.iter().zip(sizes) {
        let candidates = (0..10).flat_map(|step| around((x, y), (width, height), GAP + step * 12).map(move |corner| (step, corner)));
        let cost = |&(step, (left, top)): &(i32, (i32, i32))| {
            let name = [left, top, left + width, top + height];
            let outside = area(name) - shared(name, frame);
            let covered: i64 = placed.iter().chain(&marks).chain(obstacles).map(|&other| shared(name, other)).sum();
            20 * (covered + outside) + 30 * i64::from(step)
        };
        let (left, top) = candidates.min_by_key(cost).map_or((x + GAP, y - height / 2), |(_, corner)| corner);
        placed.push([left, top, left + width, top + height]);
    }
    placed.iter().map(|name| (name[0], name[1])).collect()
}

/// Upper left corners of names of a size in eight directions from a point, the right one first.
fn around((x, y): (i32, i32), (width, height): (i32, i32), gap: i32) -> [(i32, i32); 8] {
    let (left, middle, right) = (x - gap - width, x - width / 2, x + gap);
    let (above, beside, below) = (y - gap - height, y - height / 2, y + gap);
    [(right, beside), (middle, above), (middle, below), (left, beside), (right, above), (right, below), (left, above), (left, below)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::{collection::vec, prelude::*};

    #[test]
    fn a_lone_name_stands_right_of_its_point_and_at_the_edge_left_of_it() {
        let frame = [0, 0, 200, 100];
        assert_eq!(place(&[(50, 50)], &[(40, 10)], &[], frame), [(62, 45)]);
        assert_eq!(place(&[(190, 50)], &[(40, 10)], &[], frame)[0].0 + 40, 190 - GAP);
    }

    #[test]
    fn a_name_keeps_clear_of_a_line_through_its_point() {
        let line = [0, 49, 200, 52];
        let [(left, top)] = place(&[(50, 50)], &[(40, 10)], &[line], [0, 0, 200, 100])[..] else { panic!("one name, one place") };
        assert_eq!(shared([left, top, left + 40, top + 10], line), 0);
    }

    proptest! {
        #[test]
        fn names_of_points_that_leave_room_touch_neither_each_other_nor_a_point(places in vec((0i32..6, 0i32..6), 1..12)) {
            let mut points: Vec<_> = places.into_iter().map(|(x, y)| (120 + 110 * x, 60 + 60 * y)).collect();
            points.sort_unstable();
            points.dedup();
            let sizes = vec![(80, 14); points.len()];
            let corners = place(&points, &sizes, &[], [0, 0, 900, 460]);
            let names: Vec<Rectangle> = corners.iter().map(|&(x, y)| [x, y, x + 80, y + 14]).collect();
            for (at, &name) in names.iter().enumerate() {
                prop_assert!(names[at + 1..].iter().all(|&other| shared(name, other) == 0), "{names:?}");
                prop_assert!(points.iter().all(|&(x, y)| shared(name, [x, y, x + 1, y + 1]) == 0), "{names:?}");
                prop_assert_eq!(shared(name, [0, 0, 900, 460]), area(name));
            }
        }
    }
}
