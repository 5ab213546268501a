//! The `sort` stage against a stable sort on the CPU, index for index, over a matrix of counts, key patterns and key sizes.

mod common;

use ash::vk;
use common::{Random, gpu};
use effigy::{
    layout::{Control, RASTER_QUADS, SORT_DROPPED, SORT_TILE},
    vulkan::{
        Gpu,
        memory::Buffer,
        pipeline::{Slice, barrier},
        sort::{KeyBits, Sort},
    },
};
use std::sync::Arc;

/// A sort with room for `capacity` keys, and the buffers around it.
struct Bench {
    gpu: Arc<Gpu>,
    keys: Buffer,
    control: Buffer,
    sort: Sort,
    bits: KeyBits,
}

impl Bench {
    fn new(gpu: &Arc<Gpu>, capacity: u32, bits: KeyBits) -> Self {
        let storage = vk::BufferUsageFlags::STORAGE_BUFFER | vk::BufferUsageFlags::TRANSFER_SRC;
        let keys = Buffer::with_data(gpu, "keys", &vec![0; 4 * capacity.max(1) as usize], storage).unwrap();
        let control = Buffer::with_data(gpu, "control", bytemuck::bytes_of(&Control::default()), storage).unwrap();
        let sort = Sort::new(gpu, Slice::from(&keys), &control, capacity, bits).unwrap();
        Self { gpu: gpu.clone(), keys, control, sort, bits }
    }

    /// Sorts with a count that the host writes, or one that the device copies from another buffer just before.
    fn check(&self, keys: &[u32], indirect: bool) {
        self.keys.upload(bytemuck::cast_slice(keys)).unwrap();
        let control = Control { entering: keys.len() as u32, survivors: 12345, ..Control::default() };
        if indirect {
            let source = Buffer::with_data(&self.gpu, "count", bytemuck::bytes_of(&control), vk::BufferUsageFlags::TRANSFER_SRC).unwrap();
            self.control.upload(bytemuck::bytes_of(&Control { entering: u32::MAX, ..control })).unwrap();
            self.run(Some(&source));
        } else {
            self.control.upload(bytemuck::bytes_of(&control)).unwrap();
            self.run(None);
        }
        let mask = u32::MAX >> (32 - 8 * self.bits.passes());
        let mut expected: Vec<u32> = (0..keys.len() as u32).filter(|&i| keys[i as usize] != SORT_DROPPED).collect();
        expected.sort_by_key(|&i| keys[i as usize] & mask);
        let control: Control = bytemuck::pod_read_unaligned(&self.control.download(size_of::<Control>()).unwrap());
        let name = format!("{} keys, {:?}, indirect {indirect}", keys.len(), self.bits);
        assert_eq!(control.survivors as usize, expected.len(), "{name}: survivors");
        assert_eq!(control.instance_count, control.survivors.div_ceil(RASTER_QUADS), "{name}: instances");
        let order = self.sort.download(control.survivors).unwrap();
        if let Some(at) = (0..order.len()).find(|&at| order[at] != expected[at]) {
            panic!("{name}: place {at} has index {}, expected {}", order[at], expected[at]);
        }
    }

    fn run(&self, count: Option<&Buffer>) {
        let size = size_of::<Control>() as u64;
        let transfer = (vk::PipelineStageFlags::TRANSFER, vk::AccessFlags::TRANSFER_WRITE);
        let compute = (vk::PipelineStageFlags::COMPUTE_SHADER, vk::AccessFlags::SHADER_READ | vk::AccessFlags::SHADER_WRITE);
        self.gpu
            .run("a sort", |commands| {
                if let Some(count) = count {
                    // SAFETY: both buffers are alive and large enough, and `run` waits.
                    unsafe {
                        self.gpu.raw.cmd_copy_buffer(
                            commands,
                            count.raw,
                            self.control.raw,
                            &[vk::BufferCopy { src_offset: 0, dst_offset: 0, size }],
                        )
                    };
                }
                barrier(&self.gpu, commands, transfer, compute);
                self.sort.record(commands);
            })
            .unwrap();
    }
}

fn patterns(count: usize, bits: KeyBits) -> Vec<Vec<u32>> {
    let random = &mut Random(count as u64);
    let top = (u32::MAX >> (32 - 8 * bits.passes())).min(SORT_DROPPED - 1);
    let any = |random: &mut Random| (random.next() as u32) & top;
    vec![
        (0..count).map(|_| any(random).min(top)).collect(),
        vec![top; count],
        (0..count as u32).rev().map(|k| k & top).collect(),
        (0..count).map(|_| random.below(3) as u32 * (top / 3)).collect(),
        (0..count).map(|_| if random.below(3) == 0 { SORT_DROPPED } else { any(random).min(top) }).collect(),
        vec![SORT_DROPPED; count],
    ]
}

fn matrix(bits: KeyBits) {
    let Some(device) = gpu::gpu() else { return };
    let tile = SORT_TILE as usize;
    let counts =
        (0..=8).chain([31, 32, 33, 127, 128, 129, tile - 1, tile, tile + 1, 2 * tile - 1, 2 * tile, 2 * tile + 1, 5 * tile + 77, 20_000]);
    let bench = Bench::new(&device, 20_000, bits);
    for count in counts {
        for (pattern, keys) in patterns(count, bits).iter().enumerate() {
            bench.check(keys, (count + pattern) % 2 == 0);
        }
    }
    gpu::assert_valid();
}

#[test]
fn sixteen_bit_keys_come_out_in_stable_order_at_every_count() {
    matrix(KeyBits::Sixteen);
}

#[test]
fn twenty_four_bit_keys_come_out_in_stable_order_at_every_count() {
    matrix(KeyBits::TwentyFour);
}

#[test]
fn thirty_two_bit_keys_come_out_in_stable_order_at_every_count() {
    matrix(KeyBits::ThirtyTwo);
}

#[test]
fn direct_and_indirect_counts_agree() {
    let Some(device) = gpu::gpu() else { return };
    let bench = Bench::new(&device, 5000, KeyBits::ThirtyTwo);
    for keys in patterns(4321, KeyBits::ThirtyTwo) {
        bench.check(&keys, false);
        bench.check(&keys, true);
    }
    gpu::assert_valid();
}

#[test]
fn a_sort_of_no_capacity_and_one_of_200_000_keys_work() {
    let Some(device) = gpu::gpu() else { return };
    Bench::new(&device, 0, KeyBits::Sixteen).check(&[], false);
    Bench::new(&device, 1, KeyBits::Sixteen).check(&[7], true);
    let random = &mut Random(1);
    let keys: Vec<u32> = (0..200_000).map(|_| random.next() as u32 & 0xffff).collect();
    Bench::new(&device, 200_000, KeyBits::Sixteen).check(&keys, false);
    gpu::assert_valid();
}
