//! The paper's questions put to a dataset of one's own: are the attributes of Gaussians near each other alike enough for local bases
//! ([`components`]); what do parts, features and kept rows buy in pictures of held-out frames ([`sweep`]), and what do they cost in time
//! ([`timing`]); which Gaussians keep their
//! correctives ([`kept`]).

pub mod components;
pub mod kept;
pub mod regroup;
pub mod sweep;
pub mod timing;
