//! Networks and bases, refined in turn.
//!
//! ```text
//! dataset ── block, nodes: a part's numbers over the frames ──┐
//! poses ── inputs ─→ learner: a network a part ⇄ problem: basis, solved for the networks
//!                                                             ↓
//!                                                        the avatar so far
//! ```

pub mod basis;
pub mod block;
pub mod inputs;
pub mod learner;
pub mod network;
pub mod nodes;
pub mod problem;
