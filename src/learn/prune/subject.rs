//! What rows are chosen by.

use effigy_core::avatar::{Avatar, Pose};

/// What the rows of an avatar are chosen by.
pub struct RowSubject<'a> {
    /// The avatar's body, which bounds the images.
    pub body: &'a Avatar,
    /// The training poses.
    pub poses: Vec<&'a Pose>,
    /// Rotation, log scale and colour of the Gaussians that keep no corrective; each of shape N_g,
    /// width.
    pub mean: &'a [Vec<f32>; 3],
    /// Covariance of each part's features over the training poses, shape N_B, N_B.
    pub covariances: Vec<Vec<f64>>,
}
