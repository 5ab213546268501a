//! The paper's questions, asked of one's own dataset: are the attributes of neighbouring Gaussians
//! alike enough for local bases ([`components`]); what do parts, features and retained rows gain in
//! images of held-out frames ([`sweep`]), and what do they cost in time ([`timing`]); which
//! Gaussians keep their correctives ([`retained_rows`]).

pub mod components;
pub mod regroup;
pub mod retained_rows;
pub mod sweep;
pub mod timing;
