//! The subcommands of `effigy-lab`.

pub mod bench_device;
pub mod bench_sort;
pub mod shader_stats;
pub mod stress;
pub mod verdict;
