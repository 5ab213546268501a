//! Cases that are drawn small: at any size from under a pixel to larger than the image, at a number
//! of samples a pixel, and half of them from a level of detail.

use super::body::below;
use effigy_core::{
    avatar::{Avatar, Level, LevelError, Rows},
    random::Random,
    scene::{AvatarBounds, Camera, Posed, Supersampling},
};

/// Heights up to which random levels are drawn, as shares of the avatar's in the image: far from 1,
/// so that no hysteresis decides.
const HEIGHTS: [f64; 3] = [0.3, 3.0, 1e4];
/// Most levels of a case.
const LEVELS: usize = 3;

/// What makes a case small.
pub struct Small {
    pub supersampling: Supersampling,
    pub camera: Camera,
    pub levels: Vec<Level>,
    /// The same in words.
    pub note: String,
}

impl Small {
    /// A random size of an avatar that a camera sees, and how it is drawn there.
    pub fn random(random: &mut Random, avatar: &Avatar, posed: &Posed, camera: &Camera) -> Self {
        let by_size = Supersampling::BySize;
        let any = [
            by_size,
            by_size,
            Supersampling::Times(2),
            Supersampling::Times(4),
        ];
        let supersampling = any[below(random, any.len())];
        let bounds = AvatarBounds::new(avatar);
        // A log-uniform size, most of them smaller than the image.
        let wanted = 10f64.powf(random.range(-2.0, 3.0));
        let side = bounds.longest_side(&posed.joints, camera);
        let mut camera = *camera;
        if side.is_finite() && side > 0.0 {
            let depth = bounds.depth(&posed.joints, &camera);
            let middle = 0.5 * (depth[0] + depth[1]);
            // Those around the camera have a category of their own.
            let nearest = middle - 0.9 * (depth[0] - camera.near);
            camera.view.translation.z += (middle * side / wanted).max(nearest) - middle;
        }
        let side = bounds.longest_side(&posed.joints, &camera);
        let has_levels = below(random, 2) == 0 && side.is_finite();
        let levels = if has_levels {
            levels(random, avatar, side)
        } else {
            vec![]
        };
        let note = format!(
            "; {side:.3} px at {supersampling} samples, {} levels",
            levels.len()
        );
        Self {
            supersampling,
            camera,
            levels,
            note,
        }
    }
}

/// Random levels: each some of the Gaussians, with or without correctives, said to be near up to
/// some height. `side`: of the avatar in the image, px.
fn levels(random: &mut Random, avatar: &Avatar, side: f64) -> Vec<Level> {
    let count = avatar.gaussians.len();
    let mut fewest = count;
    let mut every = 1;
    (0..1 + below(random, LEVELS))
        .filter_map(|_| {
            every += 1 + below(random, 8);
            let height = (side * HEIGHTS[below(random, HEIGHTS.len())]).clamp(1e-3, 1e5);
            let correctives = below(random, 2) == 0;
            // Each level has fewer than the one before.
            let is_coarser = count.div_ceil(every) < fewest;
            fewest = fewest.min(count.div_ceil(every));
            is_coarser.then(|| level(avatar, every, correctives, height))
        })
        .collect()
}

/// A level of every so many Gaussians, near up to a height, px.
fn level(avatar: &Avatar, every: usize, correctives: bool, height: f64) -> Level {
    let kept: Vec<usize> = (0..avatar.gaussians.len()).step_by(every).collect();
    let measured = |samples| LevelError {
        height,
        samples,
        psnr_db: 40.0,
        color: 0.0,
        coverage: 0.0,
    };
    let mut gaussians = avatar.gaussians.pick(&kept);
    if !correctives {
        gaussians.node.fill([0; 3]);
    }
    let parts = &avatar.parts.start;
    Level {
        gaussians,
        part_start: parts
            .iter()
            .map(|start| start.div_ceil(every as u32))
            .collect(),
        correctives,
        rotation_rows: rows(&avatar.rotation_rows, every, correctives),
        scale_rows: rows(&avatar.scale_rows, every, correctives),
        color_rows: rows(&avatar.color_rows, every, correctives),
        sh: avatar.sh.as_ref().map(|sh| sh.pick(&kept)),
        measured: vec![measured(2), measured(4)],
    }
}

/// The rows of every so many Gaussians, renumbered; none without correctives.
fn rows<const C: usize>(rows: &Rows<C>, every: usize, correctives: bool) -> Rows<C> {
    let kept: Vec<usize> = (0..rows.gaussian.len())
        .filter(|&row| correctives && rows.gaussian[row].is_multiple_of(every as u32))
        .collect();
    if kept.is_empty() {
        return Rows::default();
    }
    let length = rows.basis.len() / rows.gaussian.len();
    Rows {
        gaussian: kept
            .iter()
            .map(|&row| rows.gaussian[row] / every as u32)
            .collect(),
        basis: rows.basis.pick(&kept, length),
    }
}
