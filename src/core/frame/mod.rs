//! A frame, whatever draws it: options, what has to run again and what is skipped, the uniform
//! block, and what a finished frame reports.

pub mod atlas;
pub mod block;
pub mod capacity;
pub mod changes;
pub mod check;
pub mod counters;
pub mod damage;
pub mod kernels;
pub mod keys;
pub mod options;
pub mod passes;
pub mod people;
pub mod pose_cache;
pub mod report;
pub mod resource;

pub mod schedule;
pub mod skip;
pub mod state;
pub mod validate;

pub use changes::{AvatarChanges, ChangeTracker, Skinning};
pub use check::Unusable;
pub use counters::{Counters, CullReasons};
pub use damage::Damage;
pub use keys::{DEPTH_KEYS, EntryForm, KeyBits};
pub use options::{ColorFormat, RasterMethod, RendererOptions, SortVariant};
pub use passes::Stage;
pub use people::{AvatarId, AvatarTraits, ByAvatar, Person};
pub use report::FrameReport;
pub use schedule::FrameSchedule;
pub use skip::Skip;
pub use state::{AvatarInstance, FramePlan, FrameState, Layer, PlanInput, StageDispatches};
