//! The subcommands of `effigy-lab`.

pub mod bench_device;
pub mod bench_sort;
pub mod bench_train;
pub mod shader_stats;
pub mod stress;
pub mod verdict;
