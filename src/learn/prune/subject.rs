//! What rows are chosen by.

use effigy_core::avatar::Pose;

/// What the rows of an avatar are chosen by.
pub struct RowSubject<'a> {
    /// The poses that rows are weighed in.
    pub poses: Vec<&'a Pose>,
    /// Rotation, log scale and colour of the Gaussians that keep no corrective; each of shape N_g,
    /// width.
    pub mean: &'a [Vec<f32>; 3],
    /// Covariance of the features that each part's attributes see, over the poses, shape N_B, N_B.
    pub covariances: Vec<Vec<f64>>,
}
