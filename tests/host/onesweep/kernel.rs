//! `shaders/sort/onesweep.comp` line for line, in a pass after the first: it reads packed entries
//! and writes values.

use super::machine::{Invocation, Words};
use effigy_core::layout::{
    SORT_DIGITS, SORT_FALLBACKS, SORT_ONESWEEP_TILE, SORT_POLLS, SORT_STATE, SORT_WORKGROUP,
};

pub const TILE: usize = SORT_ONESWEEP_TILE as usize;
const THREADS: usize = SORT_WORKGROUP as usize;
pub const DIGITS: usize = SORT_DIGITS as usize;
const ROUNDS: usize = TILE / THREADS;
pub const COLUMNS: usize = 16;
const WORDS: usize = DIGITS / 2;
/// Invocations whose sums one of them adds up.
pub const BLOCK: usize = 16;
const COUNTED: u32 = 1 << 30;
const SUMMED: u32 = 2 << 30;
const NUMBER: u32 = COUNTED - 1;
/// The ticket and the fallbacks, the histogram, and each tile's status.
const FALLBACKS: usize = SORT_FALLBACKS as usize;
pub const HISTOGRAM: usize = SORT_STATE as usize;
pub const STATUS: usize = HISTOGRAM + DIGITS;

/// The buffers of a pass.
pub struct Pass {
    pub entry: Words,
    pub sorted: Words,
    pub counts: Words,
    /// Earlier tiles whose counts are read at a time.
    pub look: usize,
    /// Whether more subgroups than columns take turns; without, the kernel is made for few.
    pub takes_turns: bool,
}

/// The shared memory of a workgroup. Each begins as garbage.
pub struct Shared {
    pub column: Words,
    pub offset: Words,
    pub sums: Words,
    pub block_sums: Words,
    pub seats: Words,
    pub ticket: Words,
    pub waiting: Words,
}

impl Shared {
    pub fn new(mut words: impl FnMut(usize) -> Words) -> Self {
        Self {
            column: words(COLUMNS * WORDS),
            offset: words(DIGITS),
            sums: words(THREADS),
            block_sums: words(THREADS / BLOCK),
            seats: words(1),
            ticket: words(1),
            waiting: words(1),
        }
    }
}

/// One invocation's run of the kernel.
pub struct Run<'a> {
    pub own: Invocation,
    pub pass: &'a Pass,
    pub shared: &'a Shared,
}

impl Run<'_> {
    async fn counter(&self, at: usize, digit: usize) -> u32 {
        let word = self.own.load(&self.shared.column, at * WORDS + digit / 2);
        word.await >> (16 * (digit & 1)) & 0xffff
    }

    async fn look_back(&self, digit: usize, walk: &mut usize, before: &mut u32) {
        let mut polls = 0;
        while *walk > 0 {
            let mut words = vec![0; self.pass.look];
            for (w, word) in words.iter_mut().enumerate() {
                if w < *walk {
                    let at = STATUS + (*walk - 1 - w) * DIGITS + digit;
                    *word = self.own.load(&self.pass.counts, at).await;
                }
            }
            let from = *walk;
            for word in words {
                if word < COUNTED {
                    break;
                }
                *before += word & NUMBER;
                *walk = if word >= SUMMED { 0 } else { *walk - 1 };
                if *walk == 0 {
                    break;
                }
            }
            polls = if *walk == from { polls + 1 } else { 0 };
            if polls >= SORT_POLLS {
                return;
            }
        }
    }

    async fn count_before(&self, tile: usize) -> [u32; 2] {
        let Self { own, pass, shared } = self;
        let (mut walk, mut before) = ([tile; 2], [0; 2]);
        loop {
            for c in 0..2 {
                self.look_back(2 * own.thread + c, &mut walk[c], &mut before[c])
                    .await;
            }
            own.max(&shared.waiting, 0, walk[0].max(walk[1]) as u32)
                .await;
            own.barrier().await;
            let nearest = own.load(&shared.waiting, 0).await as usize;
            own.barrier().await;
            if nearest == 0 {
                return before;
            }
            for d in (own.thread..DIGITS).step_by(THREADS) {
                own.store(&shared.offset, d, 0).await;
            }
            if own.thread == 0 {
                own.store(&shared.waiting, 0, 0).await;
                own.add(&pass.counts, FALLBACKS, 1).await;
            }
            own.barrier().await;
            for at in ((nearest - 1) * TILE + own.thread..nearest * TILE).step_by(THREADS) {
                let key = own.load(&pass.entry, at).await;
                own.add(&shared.offset, key as usize >> 24, 1).await;
            }
            own.barrier().await;
            for c in 0..2 {
                if walk[c] == nearest {
                    before[c] += own.load(&shared.offset, 2 * own.thread + c).await;
                    walk[c] -= 1;
                }
            }
            own.barrier().await;
        }
    }

    async fn publish(&self, tile: usize, kind: u32, numbers: [u32; 2]) {
        for (c, number) in numbers.into_iter().enumerate() {
            let at = STATUS + tile * DIGITS + 2 * self.own.thread + c;
            self.own.store(&self.pass.counts, at, kind | number).await;
        }
    }

    async fn look_up_offsets(&self, tile: usize, total: [u32; 2]) {
        let Self { own, pass, shared } = self;
        let kind = if tile == 0 { SUMMED } else { COUNTED };
        self.publish(tile, kind, total).await;
        let before = self.count_before(tile).await;
        if tile > 0 {
            self.publish(tile, SUMMED, [0, 1].map(|c| before[c] + total[c]))
                .await;
        }
        let digit = 2 * own.thread;
        let first = own.load(&pass.counts, HISTOGRAM + digit).await;
        let second = own.load(&pass.counts, HISTOGRAM + digit + 1).await;
        own.store(&shared.offset, digit, before[0]).await;
        own.store(&shared.offset, digit + 1, before[1] + first)
            .await;
        // add_lower_digits() of sort/offsets.glsl
        own.store(&shared.sums, own.thread, first + second).await;
        own.barrier().await;
        if own.thread < THREADS / BLOCK {
            let mut sum = 0;
            for t in 0..BLOCK {
                sum += own.load(&shared.sums, own.thread * BLOCK + t).await;
            }
            own.store(&shared.block_sums, own.thread, sum).await;
        }
        own.barrier().await;
        let mut lower = 0;
        for b in 0..own.thread / BLOCK {
            lower += own.load(&shared.block_sums, b).await;
        }
        for t in own.thread / BLOCK * BLOCK..own.thread {
            lower += own.load(&shared.sums, t).await;
        }
        own.add(&shared.offset, digit, lower).await;
        own.add(&shared.offset, digit + 1, lower).await;
        own.barrier().await;
    }

    async fn rank_of(&self, present: bool, digit: usize, at: usize) -> Option<u32> {
        let own = &self.own;
        let mut same = own.ballot(present).await;
        for b in 0..8 {
            let bit = digit >> b & 1 != 0;
            let set = own.ballot(bit).await;
            same &= if bit { set } else { !set };
        }
        let mut rank = None;
        if present {
            rank = Some(self.counter(at, digit).await + own.exclusive_count(same));
        }
        own.subgroup_barrier().await;
        if present && own.exclusive_count(same) == 0 {
            let count = same.count_ones() << (16 * (digit & 1));
            own.add(&self.shared.column, at * WORDS + digit / 2, count)
                .await;
        }
        own.subgroup_barrier().await;
        rank
    }

    pub async fn main(self) {
        let Self { own, pass, shared } = &self;
        let end = pass.entry.len();
        if own.thread == 0 {
            let ticket = own.add(&pass.counts, 0, 1).await;
            own.store(&shared.ticket, 0, ticket).await;
            own.store(&shared.seats, 0, 0).await;
            own.store(&shared.waiting, 0, 0).await;
        }
        for w in (own.thread..COLUMNS * WORDS).step_by(THREADS) {
            own.store(&shared.column, w, 0).await;
        }
        own.barrier().await;
        let tile = own.load(&shared.ticket, 0).await as usize;
        let all = own.ballot(true).await;
        let width = all.count_ones() as usize;
        let lane = own.exclusive_count(all) as usize;
        let mut seat = 0;
        if own.elect() {
            seat = own.add(&shared.seats, 0, (width as u32) << 16 | 1).await;
        }
        let seat = own.broadcast_first(seat).await;
        own.barrier().await;
        let subgroups = (own.load(&shared.seats, 0).await & 0xffff) as usize;
        let turns = subgroups.div_ceil(COLUMNS);
        let sharers = if pass.takes_turns { turns } else { 1 };
        let place = seat as usize & 0xffff;
        let (own_round, own_column) = (place % sharers, place / sharers);
        let from = tile * TILE + (seat >> 16) as usize * ROUNDS + lane;
        let mut key = [0; ROUNDS];
        let mut ranks = [None; ROUNDS];
        for (r, key) in key.iter_mut().enumerate() {
            if from + r * width < end {
                *key = own.load(&pass.entry, from + r * width).await;
            }
        }
        for sharer in 0..sharers {
            if sharer == own_round {
                for r in 0..ROUNDS {
                    let present = from + r * width < end;
                    ranks[r] = self
                        .rank_of(present, key[r] as usize >> 24, own_column)
                        .await;
                }
            }
            own.barrier().await;
        }
        let mut total = 0;
        for c in 0..COLUMNS {
            let count = own.load(&shared.column, c * WORDS + own.thread).await;
            own.store(&shared.column, c * WORDS + own.thread, total)
                .await;
            total += count;
        }
        self.look_up_offsets(tile, [total & 0xffff, total >> 16])
            .await;
        for r in 0..ROUNDS {
            if let Some(rank) = ranks[r] {
                let digit = key[r] as usize >> 24;
                let offset = own.load(&shared.offset, digit).await;
                let place = offset + self.counter(own_column, digit).await + rank;
                own.store(&pass.sorted, place as usize, key[r] & 0xff_ffff)
                    .await;
            }
        }
    }
}
