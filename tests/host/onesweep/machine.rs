//! A device for the kernel: workgroups of invocations that advance one access of memory at a time,
//! in random order. Accesses are sequentially consistent; one out of an array's bounds panics.

use effigy_core::{layout::SORT_WORKGROUP, random::Random};
use std::{
    cell::{Cell, RefCell},
    pin::Pin,
    rc::Rc,
    task::{Context, Poll, Waker},
};

/// An array in memory.
pub type Words = Vec<Cell<u32>>;

/// How a device runs a dispatch.
#[derive(Clone, Copy, Debug)]
pub struct Device {
    /// Invocations of a subgroup.
    pub width: usize,
    /// Lavapipe's: a subgroup's barrier waits for the workgroup, with whatever barriers others are
    /// at.
    pub mixes_barriers: bool,
    /// Whether some workgroups stop somewhere until no other can go on.
    pub stalls: bool,
    /// Decides the order of everything.
    pub seed: u64,
}

/// Where invocations wait until all that have not ended are there.
#[derive(Clone, Default)]
struct Gate {
    waiting: RefCell<Vec<usize>>,
    alive: Cell<usize>,
}

impl Gate {
    fn new(alive: usize) -> Self {
        let alive = Cell::new(alive);
        let waiting = RefCell::default();
        Self { waiting, alive }
    }

    /// Lets all go on if everyone is there. Returns whether it does.
    fn open(&self, ready: &RefCell<Vec<usize>>) -> bool {
        let mut waiting = self.waiting.borrow_mut();
        let is_full = waiting.len() == self.alive.get();
        if is_full {
            ready.borrow_mut().append(&mut waiting);
        }
        is_full
    }
}

#[derive(Clone)]
struct Subgroup {
    barrier: Gate,
    ballot: Gate,
    votes: Cell<u128>,
    /// Of the last ballot.
    result: Cell<u128>,
    first: Cell<u32>,
}

struct Workgroup {
    barrier: Gate,
    subgroups: Vec<Subgroup>,
    mixes_barriers: bool,
    /// Invocations of the device that can go on.
    ready: Rc<RefCell<Vec<usize>>>,
}

/// One invocation, as its kernel sees it.
#[derive(Clone)]
pub struct Invocation {
    workgroup: Rc<Workgroup>,
    id: usize,
    pub group: usize,
    pub thread: usize,
    subgroup: usize,
    lane: usize,
}

/// Lets others run, once.
struct Pause(bool);

impl Future for Pause {
    type Output = ();

    fn poll(mut self: Pin<&mut Self>, _: &mut Context) -> Poll<()> {
        match std::mem::replace(&mut self.0, true) {
            true => Poll::Ready(()),
            false => Poll::Pending,
        }
    }
}

impl Invocation {
    /// An atomic change of a word. Returns what it was.
    async fn change(&self, words: &Words, at: usize, change: impl Fn(u32) -> u32) -> u32 {
        self.workgroup.ready.borrow_mut().push(self.id);
        Pause(false).await;
        words[at].replace(change(words[at].get()))
    }

    pub async fn load(&self, words: &Words, at: usize) -> u32 {
        self.change(words, at, |old| old).await
    }

    pub async fn store(&self, words: &Words, at: usize, value: u32) {
        self.change(words, at, |_| value).await;
    }

    pub async fn add(&self, words: &Words, at: usize, value: u32) -> u32 {
        self.change(words, at, |old| old + value).await
    }

    pub async fn max(&self, words: &Words, at: usize, value: u32) {
        self.change(words, at, |old| old.max(value)).await;
    }

    fn own(&self) -> &Subgroup {
        &self.workgroup.subgroups[self.subgroup]
    }

    async fn wait(&self, gate: &Gate) {
        gate.waiting.borrow_mut().push(self.id);
        gate.open(&self.workgroup.ready);
        Pause(false).await;
    }

    pub async fn barrier(&self) {
        self.wait(&self.workgroup.barrier).await;
    }

    pub async fn subgroup_barrier(&self) {
        let mixes = self.workgroup.mixes_barriers;
        let own = &self.own().barrier;
        self.wait(if mixes { &self.workgroup.barrier } else { own })
            .await;
    }

    pub async fn ballot(&self, vote: bool) -> u128 {
        let own = self.own();
        own.votes
            .set(own.votes.get() | u128::from(vote) << self.lane);
        own.ballot.waiting.borrow_mut().push(self.id);
        if own.ballot.open(&self.workgroup.ready) {
            own.result.set(own.votes.take());
        }
        Pause(false).await;
        own.result.get()
    }

    pub fn exclusive_count(&self, ballot: u128) -> u32 {
        (ballot & ((1 << self.lane) - 1)).count_ones()
    }

    pub fn elect(&self) -> bool {
        self.lane == 0
    }

    pub async fn broadcast_first(&self, value: u32) -> u32 {
        if self.elect() {
            self.own().first.set(value);
        }
        self.ballot(true).await;
        self.own().first.get()
    }

    /// Nobody waits for it any more.
    fn end(&self) {
        let own = self.own();
        for gate in [&self.workgroup.barrier, &own.barrier, &own.ballot] {
            gate.alive.set(gate.alive.get() - 1);
            gate.open(&self.workgroup.ready);
        }
    }
}

impl Device {
    /// Runs a kernel in so many workgroups. Returns whether all invocations ended.
    pub fn run<'a>(
        self,
        groups: usize,
        kernel: impl Fn(Invocation) -> Pin<Box<dyn Future<Output = ()> + 'a>>,
    ) -> bool {
        let random = &mut Random::new(self.seed, 0);
        let mut below = |limit: usize| (random.uniform() * limit as f64) as usize;
        let size = SORT_WORKGROUP as usize;
        let ready = Rc::new(RefCell::new((0..groups * size).collect::<Vec<_>>()));
        let subgroup = Subgroup {
            barrier: Gate::new(self.width),
            ballot: Gate::new(self.width),
            votes: Cell::new(0),
            result: Cell::new(0),
            first: Cell::new(0),
        };
        let mut running = Vec::new();
        // Steps after which a workgroup stalls.
        let mut stall = Vec::new();
        for group in 0..groups {
            let workgroup = Rc::new(Workgroup {
                barrier: Gate::new(size),
                subgroups: vec![subgroup.clone(); size / self.width],
                mixes_barriers: self.mixes_barriers,
                ready: ready.clone(),
            });
            // Nothing says which invocations make a subgroup.
            let mut places: Vec<usize> = (0..size).collect();
            (0..size).for_each(|at| places.swap(at, below(size)));
            for (thread, place) in places.into_iter().enumerate() {
                let invocation = Invocation {
                    workgroup: workgroup.clone(),
                    id: group * size + thread,
                    group,
                    thread,
                    subgroup: place / self.width,
                    lane: place % self.width,
                };
                running.push(Some((invocation.clone(), kernel(invocation))));
            }
            let stalls = self.stalls && below(2) == 0;
            stall.push(if stalls { below(50_000) } else { usize::MAX });
        }
        let mut stalled = Vec::new();
        loop {
            if ready.borrow().is_empty() {
                // All stalled ones go on, to their end.
                stall.fill(usize::MAX);
                ready.borrow_mut().append(&mut stalled);
            }
            let count = ready.borrow().len();
            if count == 0 {
                return running.iter().all(Option::is_none);
            }
            let id = ready.borrow_mut().swap_remove(below(count));
            if stall[id / size] == 0 {
                stalled.push(id);
                continue;
            }
            stall[id / size] -= 1;
            let (invocation, future) = running[id].as_mut().expect("it can go on");
            let polled = future
                .as_mut()
                .poll(&mut Context::from_waker(Waker::noop()));
            if polled.is_ready() {
                invocation.end();
                running[id] = None;
            }
        }
    }
}
