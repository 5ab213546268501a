//! The Pareto front. In: pairs of a cost, of which less is better, and a worth, of which more is. Out: those that no other beats.

/// Whether `a` is at least as good as `b` in both and better in one.
pub fn dominates(a: (f64, f64), b: (f64, f64)) -> bool {
    a.0 <= b.0 && a.1 >= b.1 && a != b
}

/// Which points nothing dominates, by rising cost. Equal points are all on it; points with a NaN never are.
pub fn front(points: &[(f64, f64)]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..points.len()).filter(|&at| !points[at].0.is_nan() && !points[at].1.is_nan()).collect();
    order.sort_by(|&a, &b| points[a].0.total_cmp(&points[b].0).then(points[b].1.total_cmp(&points[a].1)));
    let mut best: Option<(f64, f64)> = None;
    order.retain(|&at| {
        let on = best.is_none_or(|best| points[at].1 > best.1 || points[at] == best);
        if on {
            best = Some(points[at]);
        }
        on
    });
    order
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::{collection::vec, prelude::*};

    #[test]
    fn the_slower_and_worse_is_off_the_front() {
        let points = [(10.0, 50.0), (5.0, 40.0), (7.0, 39.0), (12.0, f64::INFINITY), (10.0, 50.0), (f64::NAN, 99.0), (5.0, 30.0)];
        assert_eq!(front(&points), [1, 0, 4, 3]);
        assert_eq!(front(&[]), [0usize; 0]);
        // 0 and −0 are one cost.
        assert_eq!(front(&[(0.0, 1.0), (-0.0, 2.0)]), [1]);
    }

    proptest! {
        /// Few different numbers, so that ties are common.
        #[test]
        fn what_is_on_it_is_dominated_by_nothing_and_what_is_off_it_by_something_on_it(points in vec((0u8..12, 0u8..12), 0..40)) {
            let points: Vec<_> = points.into_iter().map(|(cost, worth)| (f64::from(cost), f64::from(worth))).collect();
            let front = front(&points);
            for at in 0..points.len() {
                let dominated = |by: &[usize]| by.iter().any(|&other| dominates(points[other], points[at]));
                if front.contains(&at) {
                    prop_assert!(!dominated(&(0..points.len()).collect::<Vec<_>>()));
                } else {
                    prop_assert!(dominated(&front));
                }
            }
            prop_assert!(front.windows(2).all(|pair| points[pair[0]].0 <= points[pair[1]].0 && points[pair[0]].1 <= points[pair[1]].1));
        }
    }
}
