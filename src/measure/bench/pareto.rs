//! The Pareto front. In: candidates with a cost, of which less is better, and a value, of which
//! more is. Out: those that no other dominates.

/// The figures of a setting that are compared.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Candidate {
    /// Less is better.
    pub cost: f64,
    /// More is better.
    pub value: f64,
}

impl Candidate {
    /// Whether it is at least as good as `other` in both and better in one.
    pub fn dominates(self, other: Self) -> bool {
        self.cost <= other.cost && self.value >= other.value && self != other
    }
}

/// The indices of the candidates that no other dominates, by rising cost. Equal ones are all among
/// them; one with a NaN never is.
pub fn front(candidates: &[Candidate]) -> Vec<usize> {
    let is_number = |&index: &usize| {
        let candidate = candidates[index];
        !candidate.cost.is_nan() && !candidate.value.is_nan()
    };
    let mut order: Vec<usize> = (0..candidates.len()).filter(is_number).collect();
    order.sort_by(|&a, &b| {
        let by_cost = candidates[a].cost.total_cmp(&candidates[b].cost);
        by_cost.then(candidates[b].value.total_cmp(&candidates[a].value))
    });
    // By rising cost a candidate is on the front if its value is higher than all before.
    let mut best: Option<Candidate> = None;
    order.retain(|&index| {
        let candidate = candidates[index];
        let on_front = best.is_none_or(|best| candidate.value > best.value || candidate == best);
        if on_front {
            best = Some(candidate);
        }
        on_front
    });
    order
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::{collection::vec, prelude::*};

    fn candidates(pairs: &[(f64, f64)]) -> Vec<Candidate> {
        let candidate = |&(cost, value): &(f64, f64)| Candidate { cost, value };
        pairs.iter().map(candidate).collect()
    }

    #[test]
    fn the_slower_and_worse_is_off_the_front() {
        let all = candidates(&[
            (10.0, 50.0),
            (5.0, 40.0),
            (7.0, 39.0),
            (12.0, f64::INFINITY),
            (10.0, 50.0),
            (f64::NAN, 99.0),
            (5.0, 30.0),
        ]);
        assert_eq!(front(&all), [1, 0, 4, 3]);
        assert_eq!(front(&[]), [0usize; 0]);
        // 0 and −0 are one cost.
        assert_eq!(front(&candidates(&[(0.0, 1.0), (-0.0, 2.0)])), [1]);
    }

    proptest! {
        /// Few different numbers, so that ties are common.
        #[test]
        fn the_front_dominates_exactly_the_rest(pairs in vec((0u8..12, 0u8..12), 0..40)) {
            let pairs: Vec<_> = pairs
                .into_iter()
                .map(|(cost, value)| (f64::from(cost), f64::from(value)))
                .collect();
            let all = candidates(&pairs);
            let front = front(&all);
            for index in 0..all.len() {
                if front.contains(&index) {
                    prop_assert!(!all.iter().any(|other| other.dominates(all[index])));
                } else {
                    prop_assert!(front.iter().any(|&other| all[other].dominates(all[index])));
                }
            }
            prop_assert!(front.is_sorted_by(|&a, &b| all[a].cost <= all[b].cost));
        }
    }
}
