//! From where each Gaussian of an avatar is drawn: a cone of the directions from which it shows.
//!
//! ```text
//! poses ──→ views: from around and from near ──→ seen: directions in which one shows ──→ cone
//! ```

mod cone;
mod seen;
mod views;

use cone::cone;
use effigy_core::avatar::{Avatar, Facing, FacingCode, Pose, facing};
use glam::Vec3;
use kiddo::{ImmutableKdTree, SquaredEuclidean};
use rayon::prelude::*;
use seen::directions;
use std::num::NonZero;
pub use views::GIVEN_POSES;
use views::views;

/// Neighbours that say from where a Gaussian is drawn that no view shows: it may lie just beneath
/// them, or in a gap that no view looked into.
const NEIGHBOURS: NonZero<usize> = NonZero::new(6).expect("not 0");

/// Gives each Gaussian of an avatar, its levels' too, a cone that leaves out where it never shows:
/// in some of the given poses, in random ones of those that the avatar was trained for, and in
/// wilder ones. Cones that it has are ignored. `shown`: the share of a pixel from which on a Gaussian
/// shows; what is less of several may then be missing from one. `progress` is called with the
/// number of views done and of all.
///
/// # Panics
/// Where [`Avatar::check`] finds a fault.
pub fn face(
    avatar: &mut Avatar,
    poses: &[Pose],
    shown: f64,
    progress: &mut dyn FnMut(usize, usize),
) {
    let views = views(avatar, poses);
    let all = views.len() * (1 + avatar.levels.len());
    let mut before = 0;
    let mut codes = |drawn: &Avatar| {
        let seen = directions(drawn, &views, shown, &mut |done| {
            progress(before + done, all)
        });
        before += views.len();
        codes_of(drawn, &seen)
    };
    avatar.gaussians.facing = codes(avatar);
    for at in 0..avatar.levels.len() {
        avatar.levels[at].gaussians.facing = codes(&avatar.at_level(&avatar.levels[at]));
    }
}

/// The cones of Gaussians that show in these directions.
fn codes_of(avatar: &Avatar, seen: &[Vec<Vec3>]) -> Vec<FacingCode> {
    let shown: Vec<usize> = (0..seen.len()).filter(|&k| !seen[k].is_empty()).collect();
    let points: Vec<[f64; 3]> = shown.iter().map(|&k| avatar.position(k).into()).collect();
    let tree: ImmutableKdTree<f64, 3> = ImmutableKdTree::new_from_slice(&points);
    let code = |k: usize| {
        let cone = if seen[k].is_empty() {
            let near = tree.nearest_n::<SquaredEuclidean>(&avatar.position(k).into(), NEIGHBOURS);
            let of = |at: u64| seen[shown[at as usize]].iter().copied();
            let directions: Vec<Vec3> = near.iter().flat_map(|near| of(near.item)).collect();
            cone(&directions)
        } else {
            cone(&seen[k])
        };
        cone.map_or(facing::NOWHERE, Facing::encode)
    };
    (0..seen.len()).into_par_iter().map(code).collect()
}
