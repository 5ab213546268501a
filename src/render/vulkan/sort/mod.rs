//! The `sort` stage: a stable radix sort of 32-bit keys, 8 bits a pass, lowest first. Keys go in,
//! the order comes out.
//!
//! A module of its own, for any Vulkan 1.1 program. It reads keys and a [`Control`], and writes the
//! indices of the keys in order and the control's `visible_count` and `instance_count`. Keys equal
//! to [`SORT_CULLED`] are left out, which is how culled Gaussians disappear. How many keys enter is
//! read from the control on the device.
//!
//! | variant | how it knows where a tile's entries go | needs |
//! |---|---|---|
//! | [`SortVariant::OneSweep`] | decoupled look-back, bounded; ranks by ballots | subgroup ballots |
//! | [`SortVariant::ReduceThenScan`] | each tile sums the histograms before it; ranks by bit masks in shared memory | nothing |
//! | [`SortVariant::PerThread`] | as reduce-then-scan; a run of keys and counters of its own for each invocation, for CPU drivers without wide groups | nothing |
//!
//! All give the same order on any device that does what Vulkan says, at any subgroup size, and none
//! can hang: see `choice`, which finds out what a device really does.
//!
//! **Storage**, for capacity n: two buffers that passes write in turn, of which one ends up with
//! the order, 8n bytes (keys of 16 or 22 bits) or 16n (32), more where an index leaves too few bits
//! of a word ([`KeyBits::packs_before`]): 12n with 22 bits above 2¹⁸ keys; and the counts,
//! [`counts_size`], which the caller may provide inside a buffer of its own, so that a kernel that
//! makes keys can count them too without one more binding (`shaders/sort/first_counts.glsl`). Every
//! kernel binds at most 4 storage buffers and shares at most 16 KB.
//!
//! **Barriers**: before [`Sort::record`], make keys and control visible to shader reads of compute,
//! and let earlier readers of order and control finish. [`Sort::record`] counts by itself and needs
//! nothing cleared. Otherwise: [`Sort::clear`] (a transfer), a barrier from transfer writes to
//! compute reads and writes, the kernel that makes keys and counts, a barrier,
//! [`Sort::record_counted`]. What either wrote, by compute, is visible to nothing until the
//! caller's barrier.

pub mod choice;
mod options;
mod passes;
mod stage;
pub mod standalone;

pub use effigy_core::frame::{KeyBits, SortVariant};
#[cfg(doc)]
use effigy_core::layout::Control;
#[cfg(doc)]
use effigy_core::layout::SORT_CULLED;
pub use options::{SortOptions, counts_size, unsupported};
pub use stage::Sort;
