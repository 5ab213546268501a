//! How near an avatar's pictures, or another program's, come to those of a capture, as papers on
//! avatars measure it and by region of the body.
//!
//! What is compared is the smallest box around the truth's mask. By default the avatar is drawn
//! over the truth's own background ([`Ground::Truth`]), so that light outside the mask counts as
//! error; behind the person, where nobody knows the background, lies the nearest of it, so that a
//! hole in the avatar counts too. The mask is never put on the avatar's picture.

mod ground;
mod metrics;
mod rasterise;
mod regions;
mod report;
mod view;
mod views;

pub use ground::Ground;
pub use metrics::{Means, Metrics};
pub use regions::{Region, regions_of};
pub use report::{GroupMeans, Protocol, ScoreReport, ViewScore};
pub use view::{AS_GIVEN, ScoreError, ScoredImages, ScoredView, Scorer};
pub use views::{PictureIndex, ViewChoice, choose};
