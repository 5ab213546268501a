//! Where to write names beside points so that they can be read. In: the points with the sizes of
//! their names, obstacles and the frame. Out: the upper left corner of each name.

/// Gap between a point and its name, px.
const GAP: i32 = 12;
/// Distances tried for a name, each [`DISTANCE_STEP`] further out, px.
const DISTANCES: i32 = 10;
const DISTANCE_STEP: i32 = 12;
/// Cost of a covered pixel, and of a step further out.
const COVERED_COST: i64 = 20;
const DISTANCE_COST: i64 = 30;

/// A rectangle in an image, px. Its right and bottom edges are outside of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rectangle {
    pub left: i32,
    pub top: i32,
    pub right: i32,
    pub bottom: i32,
}

impl Rectangle {
    /// A rectangle by its upper left corner.
    fn at(corner: (i32, i32), width: i32, height: i32) -> Self {
        Self {
            left: corner.0,
            top: corner.1,
            right: corner.0 + width,
            bottom: corner.1 + height,
        }
    }

    /// The pixels that two rectangles share.
    fn overlap(self, other: Self) -> i64 {
        let width = self.right.min(other.right) - self.left.max(other.left);
        let height = self.bottom.min(other.bottom) - self.top.max(other.top);
        i64::from(width.max(0)) * i64::from(height.max(0))
    }

    fn area(self) -> i64 {
        i64::from(self.right - self.left) * i64::from(self.bottom - self.top)
    }
}

/// A point and the size of its name, px.
#[derive(Clone, Copy, Debug)]
pub struct Label {
    pub point: (i32, i32),
    pub width: i32,
    pub height: i32,
}

impl Label {
    /// The point's mark.
    fn mark(&self) -> Rectangle {
        Rectangle::at((self.point.0 - 5, self.point.1 - 5), 11, 11)
    }

    /// The name with its upper left corner at `corner`.
    fn name_at(&self, corner: (i32, i32)) -> Rectangle {
        Rectangle::at(corner, self.width, self.height)
    }

    /// Corners of the name in eight directions from the point, the right one first.
    fn corners_around(&self, gap: i32) -> [(i32, i32); 8] {
        let left = self.point.0 - gap - self.width;
        let middle = self.point.0 - self.width / 2;
        let right = self.point.0 + gap;
        let above = self.point.1 - gap - self.height;
        let beside = self.point.1 - self.height / 2;
        let below = self.point.1 + gap;
        [
            (right, beside),
            (middle, above),
            (middle, below),
            (left, beside),
            (right, above),
            (right, below),
            (left, above),
            (left, below),
        ]
    }
}

/// Places names in the order given. Each takes the place around its point that covers the least of
/// other names, points, obstacles and the outside of the frame, and is near.
pub fn place(labels: &[Label], obstacles: &[Rectangle], frame: Rectangle) -> Vec<(i32, i32)> {
    let marks: Vec<Rectangle> = labels.iter().map(Label::mark).collect();
    let mut names: Vec<Rectangle> = Vec::with_capacity(labels.len());
    for label in labels {
        let cost = |step: i32, corner: (i32, i32)| {
            let name = label.name_at(corner);
            let outside = name.area() - name.overlap(frame);
            let others = names.iter().chain(&marks).chain(obstacles);
            let covered: i64 = others.map(|&other| name.overlap(other)).sum();
            COVERED_COST * (covered + outside) + DISTANCE_COST * i64::from(step)
        };
        let mut best_corner = (0, 0);
        let mut lowest_cost = i64::MAX;
        for step in 0..DISTANCES {
            for corner in label.corners_around(GAP + step * DISTANCE_STEP) {
                let cost = cost(step, corner);
                if cost < lowest_cost {
                    lowest_cost = cost;
                    best_corner = corner;
                }
            }
        }
        names.push(label.name_at(best_corner));
    }
    names.iter().map(|name| (name.left, name.top)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::{collection::vec, prelude::*};

    const FRAME: Rectangle = Rectangle {
        left: 0,
        top: 0,
        right: 200,
        bottom: 100,
    };

    fn label(x: i32, y: i32) -> Label {
        Label {
            point: (x, y),
            width: 40,
            height: 10,
        }
    }

    #[test]
    fn a_lone_name_stands_right_of_its_point_or_left_at_the_edge() {
        assert_eq!(place(&[label(50, 50)], &[], FRAME), [(62, 45)]);
        assert_eq!(place(&[label(190, 50)], &[], FRAME)[0].0 + 40, 190 - GAP);
    }

    #[test]
    fn a_name_keeps_clear_of_a_line_through_its_point() {
        let line = Rectangle::at((0, 49), 200, 3);
        let label = label(50, 50);
        let corner = place(&[label], &[line], FRAME)[0];
        assert_eq!(label.name_at(corner).overlap(line), 0);
    }

    proptest! {
        #[test]
        fn names_of_spaced_points_overlap_nothing(places in vec((0i32..6, 0i32..6), 1..12)) {
            let mut points: Vec<_> = places
                .into_iter()
                .map(|(x, y)| (120 + 110 * x, 60 + 60 * y))
                .collect();
            points.sort_unstable();
            points.dedup();
            let frame = Rectangle::at((0, 0), 900, 460);
            let label = |&point: &(i32, i32)| Label { point, width: 80, height: 14 };
            let labels: Vec<_> = points.iter().map(label).collect();
            let corners = place(&labels, &[], frame);
            let names: Vec<_> = corners
                .iter()
                .map(|&corner| Rectangle::at(corner, 80, 14))
                .collect();
            for (index, &name) in names.iter().enumerate() {
                for &other in &names[index + 1..] {
                    prop_assert_eq!(name.overlap(other), 0, "{:?}", names);
                }
                for &point in &points {
                    prop_assert_eq!(name.overlap(Rectangle::at(point, 1, 1)), 0, "{:?}", names);
                }
                prop_assert_eq!(name.overlap(frame), name.area());
            }
        }
    }
}
