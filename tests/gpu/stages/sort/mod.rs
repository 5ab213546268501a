//! The `sort` stage against a stable sort on the CPU, index for index: every variant over a matrix
//! of counts, key patterns and key sizes; with stalled workgroups; in subgroups of every size;
//! counted by another kernel; and the self-test that chooses.

pub mod choice;
pub mod faults;
pub mod fused;
pub mod matrix;

use crate::common::{Random, gpu, harness::not_run};
use effigy_core::layout::SORT_CULLED;
use effigy_render::vulkan::{
    Gpu,
    sort::{
        KeyBits, SortOptions,
        SortVariant::{self, OneSweep, PerThread, ReduceThenScan},
        standalone::StandaloneSort,
    },
};
use std::sync::Arc;

const BITS: [KeyBits; 3] = [KeyBits::Sixteen, KeyBits::TwentyTwo, KeyBits::ThirtyTwo];

/// The device, for a variant that it can run. Ends the test on others.
fn running(variant: SortVariant) -> Arc<Gpu> {
    let device = gpu::gpu();
    if let Some(reason) = effigy_render::vulkan::sort::unsupported(variant, &device) {
        not_run(format!(
            "{} needs what is missing: {reason}",
            variant.name()
        ));
    }
    if variant == SortVariant::OneSweep && compiles_slowly(&device) {
        not_run("OneSweep takes this device half a minute to compile");
    }
    device
}

/// The device, for a variant that is right on it. Ends the test on others.
fn sorting(variant: SortVariant) -> Arc<Gpu> {
    let device = running(variant);
    if variant == SortVariant::OneSweep && !looks_back(&device) {
        not_run("OneSweep gives wrong orders with this driver, and the self-test refuses it");
    }
    device
}

/// lavapipe takes half a minute for OneSweep's kernels at 16 lanes, inside a wait that ends after
/// that.
fn compiles_slowly(gpu: &Gpu) -> bool {
    gpu.probe.kind == ash::vk::PhysicalDeviceType::CPU && gpu.probe.subgroup_size > 8
}

/// Whether a driver is known to give wrong orders with OneSweep, which the self-test is there for:
/// Mesa's lavapipe before 23, and with subgroups of 4 (SwiftShader, which has those too, is right).
fn looks_back(gpu: &Gpu) -> bool {
    let (old, narrow) = (
        gpu.probe.driver.contains("Mesa 22."),
        gpu.probe.driver.contains("llvmpipe") && gpu.probe.subgroup_size == 4,
    );
    !old && !narrow
}

/// Sorts, and fails where the order is not what it should be.
fn check(sorter: &StandaloneSort, keys: &[u32], name: &str) {
    sorter.load(keys).unwrap();
    sorter.run().unwrap();
    assert_same(sorter, keys, name);
}

fn assert_same(sorter: &StandaloneSort, keys: &[u32], name: &str) {
    if let Some(difference) = sorter.difference(keys).unwrap() {
        panic!("{name}: {difference}");
    }
}

fn standalone_sort(gpu: &Arc<Gpu>, capacity: usize, options: SortOptions) -> StandaloneSort {
    StandaloneSort::new(gpu, capacity as u32, options).unwrap()
}

/// Keys of all bits, none of them SORT_CULLED.
fn random_keys(seed: u64, count: usize) -> Vec<u32> {
    let random = &mut Random(seed);
    (0..count)
        .map(|_| (random.next() as u32).min(SORT_CULLED - 1))
        .collect()
}

/// Key patterns that sorts have failed at.
fn patterns(count: usize, bits: KeyBits) -> Vec<Vec<u32>> {
    let random = &mut Random(count as u64);
    let top = (u32::MAX >> (32 - bits.bits())).min(SORT_CULLED - 1);
    let shift = 8 * bits.passes() - 8;
    vec![
        random_keys(count as u64 + 1, count),
        vec![top; count],
        (0..count as u32).rev().map(|k| k & top).collect(),
        (0..count)
            .map(|_| random.below(3) as u32 * (top / 3))
            .collect(),
        (0..count)
            .map(|k| if k % 2 == 0 { 0 } else { top })
            .collect(),
        (0..count)
            .map(|_| (random.next() as u32 & 0xff) << shift & top)
            .collect(),
        (0..count)
            .map(|_| {
                if random.below(3) == 0 {
                    SORT_CULLED
                } else {
                    random.next() as u32 & top & !1
                }
            })
            .collect(),
        (0..count)
            .map(|k| if k % 1000 == 999 { 5 } else { SORT_CULLED })
            .collect(),
        vec![SORT_CULLED; count],
    ]
}
