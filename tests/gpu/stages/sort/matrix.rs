//! Every variant that is right on the device, at every key size, over counts and patterns.

use super::*;
use ash::vk;
use effigy_core::layout::Control;
use effigy_render::vulkan::{Recording, memory::Buffer};

/// Counts around every border of a tile, and one count for each pattern in turn where all of them
/// would take too long.
fn every_count_comes_in_the_stable_order(variant: SortVariant) {
    let device = sorting(variant);
    let tile = variant.tile() as usize;
    let borders = [
        tile - 1,
        tile,
        tile + 1,
        2 * tile - 1,
        2 * tile,
        2 * tile + 1,
        5 * tile + 77,
    ];
    for bits in BITS {
        let sorter = standalone_sort(&device, 5 * tile + 77, SortOptions::new(bits, variant));
        for count in (0..=8)
            .chain([31, 32, 33, 127, 128, 129, 1000])
            .chain(borders)
        {
            let patterns = patterns(count, bits);
            for (number, keys) in patterns.iter().enumerate() {
                if (bits == KeyBits::Sixteen && borders.contains(&count)) || number % 4 == count % 4
                {
                    check(
                        &sorter,
                        keys,
                        &format!("{}, {bits:?}, pattern {number}", variant.name()),
                    );
                }
            }
        }
    }
}

fn large_sorts_are_right_and_the_same_twice(variant: SortVariant) {
    let device = sorting(variant);
    for (count, bits) in [(200_000, KeyBits::Sixteen), (1_100_001, KeyBits::ThirtyTwo)] {
        let sorter = standalone_sort(&device, count, SortOptions::new(bits, variant));
        let mut keys = random_keys(7, count);
        keys.iter_mut()
            .step_by(5)
            .for_each(|key| *key = SORT_CULLED);
        let name = format!("{}, {bits:?}", variant.name());
        check(&sorter, &keys, &name);
        let first = sorter.sort().download(count as u32).unwrap();
        sorter.run().unwrap();
        assert_same(&sorter, &keys, &name);
        assert!(
            first == sorter.sort().download(count as u32).unwrap(),
            "{name}: the second run differs from the first"
        );
    }
}

fn the_count_is_read_on_the_device_and_never_above_the_capacity(variant: SortVariant) {
    let device = sorting(variant);
    let capacity = 3 * variant.tile() as usize;
    let sorter = standalone_sort(
        &device,
        capacity,
        SortOptions::new(KeyBits::Sixteen, variant),
    );
    let keys = random_keys(3, capacity);
    for (device_count, sorted) in [
        (0, 0),
        (1, 1),
        (capacity / 2 + 3, capacity / 2 + 3),
        (capacity, capacity),
        (capacity + 5, capacity),
    ] {
        sorter.load(&keys).unwrap();
        let control = Control {
            key_count: u32::MAX,
            ..Control::default()
        };
        sorter
            .control()
            .upload(bytemuck::bytes_of(&control))
            .unwrap();
        let on_device = Control {
            key_count: device_count as u32,
            ..control
        };
        let source = Buffer::with_data(
            &device,
            "count",
            bytemuck::bytes_of(&on_device),
            vk::BufferUsageFlags::TRANSFER_SRC,
        )
        .unwrap();
        let region = vk::BufferCopy {
            src_offset: 0,
            dst_offset: 0,
            size: size_of::<Control>() as u64,
        };
        // SAFETY: both buffers are alive and as large as the region, and the run is waited for.
        let copy = |commands: Recording| unsafe {
            device.raw.cmd_copy_buffer(
                commands.raw(),
                source.raw(),
                sorter.control().raw(),
                &[region],
            )
        };
        sorter.run_after(copy).unwrap();
        assert_same(
            &sorter,
            &keys[..sorted],
            &format!("{}, {device_count:?}", variant.name()),
        );
    }
}

fn sorts_with_a_capacity_of_zero_and_one_work(variant: SortVariant) {
    let device = running(variant);
    check(
        &standalone_sort(&device, 0, SortOptions::new(KeyBits::Sixteen, variant)),
        &[],
        variant.name(),
    );
    check(
        &standalone_sort(&device, 1, SortOptions::new(KeyBits::Sixteen, variant)),
        &[7],
        variant.name(),
    );
}

tests! {
    every_count_comes_in_the_stable_order[OneSweep],
    every_count_comes_in_the_stable_order[ReduceThenScan]: smoke,
    every_count_comes_in_the_stable_order[PerThread],
    large_sorts_are_right_and_the_same_twice[OneSweep],
    large_sorts_are_right_and_the_same_twice[ReduceThenScan],
    large_sorts_are_right_and_the_same_twice[PerThread],
    the_count_is_read_on_the_device_and_never_above_the_capacity[OneSweep],
    the_count_is_read_on_the_device_and_never_above_the_capacity[ReduceThenScan],
    the_count_is_read_on_the_device_and_never_above_the_capacity[PerThread],
    sorts_with_a_capacity_of_zero_and_one_work[OneSweep],
    sorts_with_a_capacity_of_zero_and_one_work[ReduceThenScan],
    sorts_with_a_capacity_of_zero_and_one_work[PerThread],
}
