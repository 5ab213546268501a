//! Learns avatars from pictures: cameras, masks and poses in, an avatar out, with no teacher.
//!
//! ```text
//! view ──→ reference: the loss and its derivative in f64
//!      ──→ gpu: the same on Vulkan, and Adam ──→ parameters ──→ avatar
//! ```
//!
//! | module | what it holds |
//! |---|---|
//! | [`topology`] | what training leaves as it is |
//! | [`parameters`] | what is learned |
//! | [`view`] | a step's view: pose, camera, picture |
//! | [`loss`] | the losses' weights |
//! | [`adam`] | Adam's rates and moments |
//! | [`exposure`], [`refine`] | gains of cameras; their motion, and poses |
//! | [`perceptual`] | the perceptual loss |
//! | [`recipe`] | every weight, rate and count |
//! | [`data`] | which pictures, in which order |
//! | [`start`] | the avatar that a training begins with |
//! | [`prune`] | which basis rows stay |
//! | [`checkpoint`], [`lock`], [`mod@log`], [`watch`] | a training's folder |
//! | [`preflight`] | checks before a long training |
//! | [`session`], [`error`] | a training from start to end |
//! | [`refit`] | poses that fit an avatar as it is |
//! | [`mod@reference`] | the loss and its derivative in f64 |
//! | [`gpu`] | both on Vulkan, and the steps |

pub mod adam;
pub mod checkpoint;
pub mod data;
pub mod error;
pub mod exposure;
pub mod gpu;
pub mod lock;
pub mod log;
pub mod loss;
pub mod parameters;
pub mod perceptual;
pub mod preflight;
pub mod prune;
pub mod recipe;
pub mod reference;
pub mod refine;
pub mod refit;
pub mod session;
pub mod start;
pub mod topology;
pub mod view;
pub mod watch;
