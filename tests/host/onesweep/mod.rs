//! OneSweep's steps, interpreted: right on subgroups of every size and in any order of workgroups,
//! and wrong where a driver mixes barriers up. What no driver here can show: they have subgroups of
//! 4 or 8 and run one workgroup after the other.

mod kernel;
mod machine;

use effigy_core::random::Random;
use kernel::{BLOCK, COLUMNS, DIGITS, HISTOGRAM, Pass, Run, STATUS, Shared, TILE};
use machine::{Device, Words};
use std::{
    cell::Cell,
    panic::{AssertUnwindSafe, catch_unwind},
};

const WIDTHS: [usize; 6] = [4, 8, 16, 32, 64, 128];
/// Earlier tiles that are read at a time: on CPUs, on GPUs beside a CPU, and on cards.
const LOOKS: [usize; 3] = [1, 4, 8];

/// What became of a pass.
struct Sorted {
    is_right: bool,
    fallbacks: u32,
}

/// Sorts random entries.
fn sort(device: Device, entries: usize, takes_turns: bool) -> Sorted {
    let random = &mut Random::new(device.seed, entries as u64);
    // Few digits, so that many are equal, or all.
    let digits = [3, DIGITS][(random.bits() & 1) as usize];
    let mut keys: Vec<u32> = (0..entries as u32)
        .map(|value| ((random.uniform() * digits as f64) as u32) << 24 | value)
        .collect();
    let words = |numbers: &[u32]| -> Words { numbers.iter().copied().map(Cell::new).collect() };
    let tiles = entries.div_ceil(TILE);
    let pass = Pass {
        entry: words(&keys),
        sorted: words(&vec![u32::MAX; entries]),
        counts: words(&vec![0; STATUS + tiles * DIGITS]),
        look: LOOKS[device.seed as usize % LOOKS.len()],
        takes_turns,
    };
    for key in &keys {
        let count = &pass.counts[HISTOGRAM + (key >> 24) as usize];
        count.set(count.get() + 1);
    }
    let mut garbage = |count| {
        (0..count)
            .map(|_| Cell::new(random.bits() as u32))
            .collect()
    };
    let shared: Vec<Shared> = (0..tiles).map(|_| Shared::new(&mut garbage)).collect();
    let ended = device.run(tiles, |own| {
        let shared = &shared[own.group];
        let pass = &pass;
        Box::pin(Run { own, pass, shared }.main())
    });
    keys.sort_by_key(|key| key >> 24);
    let values = keys.iter().map(|key| key & 0xff_ffff);
    Sorted {
        is_right: ended && pass.sorted.iter().map(Cell::get).eq(values),
        fallbacks: pass.counts[effigy_core::layout::SORT_FALLBACKS as usize].get(),
    }
}

fn device(width: usize, seed: u64) -> Device {
    Device {
        width,
        mixes_barriers: false,
        stalls: false,
        seed,
    }
}

fn it_is_right_at_every_width_and_in_any_order() {
    for width in WIDTHS {
        for (seed, entries) in [(1, 100), (2, TILE), (3, 5000), (4, 5 * TILE)] {
            let sorted = sort(device(width, seed), entries, true);
            assert!(sorted.is_right, "{entries} entries at {width} lanes");
        }
    }
}

fn it_ends_and_is_right_where_workgroups_stall() {
    let mut fallbacks = 0;
    for width in WIDTHS {
        for number in 0..2 {
            let seed = 2 * width as u64 + number;
            let stalls = Device {
                stalls: true,
                ..device(width, seed)
            };
            let sorted = sort(stalls, 4 * TILE + 77, true);
            assert!(sorted.is_right, "seed {seed} at {width} lanes");
            fallbacks += sorted.fallbacks;
        }
    }
    assert!(fallbacks >= 6, "{fallbacks}: nothing had to be counted");
}

fn barriers_that_mix_are_wrong_only_where_columns_are_shared() {
    for width in WIDTHS {
        let mixes = Device {
            mixes_barriers: true,
            ..device(width, 5)
        };
        let right = [100, TILE, 5000].map(|entries| {
            // An entry may get a place beyond the end.
            let sorted = catch_unwind(AssertUnwindSafe(|| sort(mixes, entries, true)));
            sorted.is_ok_and(|sorted| sorted.is_right)
        });
        assert_eq!(right, [width > 4; 3], "{width} lanes");
    }
}

fn memory_for_fewer_subgroups_is_found() {
    let is_right = |width| {
        let sorted = || sort(device(width, 6), TILE, false);
        catch_unwind(AssertUnwindSafe(sorted)).is_ok_and(|sorted| sorted.is_right)
    };
    assert!(
        is_right(8) && !is_right(4),
        "32 subgroups in {COLUMNS} columns"
    );
}

fn its_constants_are_the_kernels() {
    let kernel = include_str!("../../../shaders/sort/onesweep.comp");
    let offsets = include_str!("../../../shaders/sort/offsets.glsl");
    for (source, line) in [
        (kernel, format!("const uint COLUMNS = {COLUMNS}u;")),
        (
            kernel,
            "const uint COUNTED = 1u << 30u, SUMMED = 2u << 30u, NUMBER = COUNTED - 1u;".into(),
        ),
        (
            kernel,
            "const uint ROUNDS = SORT_ONESWEEP_TILE / THREADS;".into(),
        ),
        (
            offsets,
            format!("const uint BLOCK = THREADS < {BLOCK}u ? THREADS : {BLOCK}u;"),
        ),
    ] {
        assert!(source.contains(&line), "no `{line}`");
    }
}

tests! {
    its_constants_are_the_kernels,
    it_is_right_at_every_width_and_in_any_order,
    it_ends_and_is_right_where_workgroups_stall,
    barriers_that_mix_are_wrong_only_where_columns_are_shared,
    memory_for_fewer_subgroups_is_found,
}
