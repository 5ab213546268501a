//! OneSweep with workgroups that never tell their counts, and in subgroups of every size.

use super::*;
use effigy_core::layout::SORT_ONESWEEP_TILE;

fn stalled_workgroups_are_counted_by_those_that_wait_for_them() {
    let device = sorting(SortVariant::OneSweep);
    let tiles = 9;
    let count = tiles * SORT_ONESWEEP_TILE as usize - 100;
    for (bits, stall) in [(KeyBits::Sixteen, 1), (KeyBits::ThirtyTwo, 3)] {
        let sorter = standalone_sort(
            &device,
            count,
            SortOptions {
                stall,
                ..SortOptions::new(bits, SortVariant::OneSweep)
            },
        );
        for (number, keys) in patterns(count, bits).iter().enumerate().skip(2).take(2) {
            check(
                &sorter,
                keys,
                &format!("every {stall}. tile stalled, {bits:?}, pattern {number}"),
            );
            let fallbacks = sorter.sort().fallbacks().unwrap().unwrap();
            // Each tile that stalls makes the next one count it, in every pass but the first; with
            // all stalled, each counts all before.
            let waited_for = if stall == 1 {
                tiles * (tiles - 1) / 2
            } else {
                (tiles - 1) / stall as usize
            };
            let min_fallbacks = waited_for as u32 * (bits.passes() - 1);
            assert!(
                fallbacks >= min_fallbacks,
                "{fallbacks} fallbacks with every {stall}. tile stalled, expected at least {min_fallbacks}"
            );
        }
    }
}

fn subgroups_of_every_size_give_the_same_order() {
    let device = sorting(SortVariant::OneSweep);
    let Some([low, high]) = device.probe.subgroup_sizes else {
        not_run(format!(
            "the device's subgroups have {} lanes and no other number",
            device.probe.subgroup_size
        ));
    };
    let count = 5 * SORT_ONESWEEP_TILE as usize + 3;
    for size in (0..8)
        .map(|shift| 1 << shift)
        .filter(|size| (low..=high).contains(size))
    {
        for bits in [KeyBits::Sixteen, KeyBits::ThirtyTwo] {
            let sorter = standalone_sort(
                &device,
                count,
                SortOptions {
                    subgroup: Some(size),
                    ..SortOptions::new(bits, SortVariant::OneSweep)
                },
            );
            for keys in patterns(count, bits) {
                check(&sorter, &keys, &format!("subgroups of {size}, {bits:?}"));
            }
        }
    }
}

tests! {
    stalled_workgroups_are_counted_by_those_that_wait_for_them,
    subgroups_of_every_size_give_the_same_order,
}
