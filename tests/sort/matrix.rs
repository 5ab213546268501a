//! Every variant that is right on the device, at every key size, over counts and patterns.

use super::*;
use ash::vk;
use effigy::{layout::Control, vulkan::memory::Buffer};

/// Counts around every border of a tile, and one count for each pattern in turn where all of them would take too long.
fn matrix(variant: Variant) {
    let Some(device) = gpu::gpu() else { return };
    if !variants(&device).contains(&variant) || (variant == Variant::OneSweep && !looks_back(&device)) {
        println!("skipped: {} is not for this device", variant.name());
        return;
    }
    let tile = variant.tile() as usize;
    let borders = [tile - 1, tile, tile + 1, 2 * tile - 1, 2 * tile, 2 * tile + 1, 5 * tile + 77];
    for bits in BITS {
        let bench = trial(&device, 5 * tile + 77, SortOptions::new(bits, variant));
        for count in (0..=8).chain([31, 32, 33, 127, 128, 129, 1000]).chain(borders) {
            let patterns = patterns(count, bits);
            for (number, keys) in patterns.iter().enumerate() {
                if (bits == KeyBits::Sixteen && borders.contains(&count)) || number % 4 == count % 4 {
                    check(&bench, keys, &format!("{}, {bits:?}, pattern {number}", variant.name()));
                }
            }
        }
    }
    gpu::assert_valid();
}

#[test]
fn onesweep_gives_the_stable_order_at_every_count() {
    matrix(Variant::OneSweep);
}

#[test]
fn self_scan_gives_the_stable_order_at_every_count() {
    matrix(Variant::SelfScan);
}

#[test]
fn lane_scan_gives_the_stable_order_at_every_count() {
    matrix(Variant::LaneScan);
}

#[test]
fn large_sorts_are_right_and_the_same_twice() {
    let Some(device) = gpu::gpu() else { return };
    for variant in variants(&device).into_iter().filter(|&variant| variant != Variant::OneSweep || looks_back(&device)) {
        for (count, bits) in [(200_000, KeyBits::Sixteen), (1_100_001, KeyBits::ThirtyTwo)] {
            let bench = trial(&device, count, SortOptions::new(bits, variant));
            let mut keys = random_keys(7, count);
            keys.iter_mut().step_by(5).for_each(|key| *key = SORT_DROPPED);
            let name = format!("{}, {bits:?}", variant.name());
            check(&bench, &keys, &name);
            let first = bench.sort().download(count as u32).unwrap();
            bench.run().unwrap();
            assert_same(&bench, &keys, &name);
            assert!(first == bench.sort().download(count as u32).unwrap(), "{name}: the second run differs from the first");
        }
    }
    gpu::assert_valid();
}

#[test]
fn the_count_is_read_on_the_device_and_never_above_the_capacity() {
    let Some(device) = gpu::gpu() else { return };
    for variant in variants(&device).into_iter().filter(|&variant| variant != Variant::OneSweep || looks_back(&device)) {
        let capacity = 3 * variant.tile() as usize;
        let bench = trial(&device, capacity, SortOptions::new(KeyBits::Sixteen, variant));
        let keys = random_keys(3, capacity);
        for (told, entering) in [(0, 0), (1, 1), (capacity / 2 + 3, capacity / 2 + 3), (capacity, capacity), (capacity + 5, capacity)] {
            bench.load(&keys).unwrap();
            let control = Control { entering: u32::MAX, ..Control::default() };
            bench.control().upload(bytemuck::bytes_of(&control)).unwrap();
            let told = Control { entering: told as u32, ..control };
            let source = Buffer::with_data(&device, "count", bytemuck::bytes_of(&told), vk::BufferUsageFlags::TRANSFER_SRC).unwrap();
            let region = vk::BufferCopy { src_offset: 0, dst_offset: 0, size: size_of::<Control>() as u64 };
            // SAFETY: both buffers are alive and as large as the region, and the run is waited for.
            let copy = |commands| unsafe { device.raw.cmd_copy_buffer(commands, source.raw, bench.control().raw, &[region]) };
            bench.run_after(copy).unwrap();
            assert_same(&bench, &keys[..entering], &format!("{}, {told:?}", variant.name()));
        }
    }
    gpu::assert_valid();
}

#[test]
fn sorts_without_room_and_with_room_for_one_work() {
    let Some(device) = gpu::gpu() else { return };
    for variant in variants(&device) {
        check(&trial(&device, 0, SortOptions::new(KeyBits::Sixteen, variant)), &[], variant.name());
        check(&trial(&device, 1, SortOptions::new(KeyBits::Sixteen, variant)), &[7], variant.name());
    }
    gpu::assert_valid();
}
