//! Keys that the maker counted: counts at an offset in a buffer of the caller's.

use super::*;
use ash::vk;
use effigy_core::layout::{Control, SORT_DIGITS};
use effigy_render::vulkan::{
    Recording,
    memory::{Buffer, Scope, Slice},
    sort::{Sort, counts_size},
};

fn counts_of_the_callers_give_the_same_order(variant: SortVariant) {
    let device = sorting(variant);
    let count = 30_001usize;
    let mut keys = random_keys(11, count);
    keys.iter_mut()
        .step_by(7)
        .for_each(|key| *key = SORT_CULLED);
    for bits in [KeyBits::Sixteen, KeyBits::TwentyTwo] {
        let usage = vk::BufferUsageFlags::STORAGE_BUFFER
            | vk::BufferUsageFlags::TRANSFER_SRC
            | vk::BufferUsageFlags::TRANSFER_DST;
        let key_bytes = (4 * count as u64).next_multiple_of(256);
        let size = counts_size(count as u32, variant);
        // What an earlier frame may have left.
        let old = vec![0xabu8; (key_bytes + size) as usize];
        let shared = Buffer::with_data(&device, "keys and counts", &old, usage).unwrap();
        shared
            .upload(bytemuck::cast_slice(&bits.pack(&keys)))
            .unwrap();
        let control = Control {
            key_count: count as u32,
            ..Control::default()
        };
        let control =
            Buffer::with_data(&device, "control", bytemuck::bytes_of(&control), usage).unwrap();
        let key_slice = Slice::from(&shared).part(0, 4 * count as u64);
        let counts = Some(Slice::from(&shared).part(key_bytes, size));
        let options = SortOptions {
            counts,
            ..SortOptions::new(bits, variant)
        };
        // SAFETY: the buffers are dropped after all work is done.
        let sort = unsafe { Sort::new(&device, key_slice, &control, count as u32, options) };
        let sort = sort.unwrap();
        assert!(
            bits != KeyBits::Sixteen || sort.dispatches(true) <= 3 && sort.dispatches(false) <= 4,
            "{}",
            variant.name()
        );
        let mut rows = vec![0u32; sort.first_counts().size() as usize / 4];
        for (at, key) in keys
            .iter()
            .enumerate()
            .filter(|(_, key)| !bits.drops(**key))
        {
            rows[at / sort.tile() as usize * SORT_DIGITS as usize + (*key & 0xff) as usize] += 1;
        }
        let rows = Buffer::with_data(
            &device,
            "rows",
            bytemuck::cast_slice(&rows),
            vk::BufferUsageFlags::TRANSFER_SRC,
        )
        .unwrap();
        let region = vk::BufferCopy {
            src_offset: 0,
            dst_offset: key_bytes,
            size: sort.first_counts().size(),
        };
        for _ in 0..2 {
            let record = |commands: Recording| {
                sort.clear(commands);
                commands.barrier(Scope::TRANSFER_WRITES, Scope::TRANSFER_WRITES);
                // SAFETY: both buffers are alive, the region is inside both, and the run is
                // waited for.
                unsafe {
                    device
                        .raw
                        .cmd_copy_buffer(commands.raw(), rows.raw(), shared.raw(), &[region])
                };
                commands.barrier(Scope::TRANSFER_WRITES, Scope::KERNEL);
                sort.record_counted(commands);
            };
            device.run("a counted sort", record).unwrap();
            let expected = effigy_render::vulkan::sort::standalone::expected(&keys, bits);
            assert!(
                sort.download(expected.len() as u32).unwrap() == expected,
                "{}, {bits:?}",
                variant.name()
            );
        }
    }
}

tests! {
    counts_of_the_callers_give_the_same_order[OneSweep],
    counts_of_the_callers_give_the_same_order[ReduceThenScan],
    counts_of_the_callers_give_the_same_order[PerThread],
}
