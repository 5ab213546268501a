//! D-SSIM on a device: [`effigy_perceptual::dssim_and_gradient`].

use super::super::arrays::words;
use super::super::buffers::groups;
use super::super::shaders;
use super::operation::Operation;
use super::steps::{ColorScale, LossSteps};
use effigy_render::vulkan::{Gpu, Result};
use std::sync::Arc;

/// Numbers of each of its buffers: pictures, derivatives of means, the derivative, sums.
pub(super) fn buffers(size: [usize; 2]) -> [usize; 4] {
    let plane = size[0] * size[1];
    [6 * plane, 9 * plane, 3 * plane, 3 * groups(plane) as usize]
}

/// The distance and its derivative, for pictures of a size.
pub(super) fn steps(gpu: &Arc<Gpu>, size: [usize; 2]) -> Result<LossSteps> {
    let [pictures, of_means, gradient, sum_count] = buffers(size);
    let pair = words(gpu, "pictures of D-SSIM", pictures)?;
    let of_means = words(gpu, "means' derivatives", of_means)?;
    let gradient = words(gpu, "picture's derivative", gradient)?;
    let sums = words(gpu, "distance sums", sum_count)?;
    let constants = size.map(|side| side as u32);
    let dispatch = [groups(size[0] * size[1]), 3];
    let operation =
        |module, storage: &[_]| Operation::new(gpu, module, &constants, storage, dispatch);
    let forward = [&pair, &of_means, &sums].map(Into::into);
    let backward = [&pair, &of_means, &gradient].map(Into::into);
    Ok(LossSteps {
        operations: vec![
            operation(&shaders::DSSIM, &forward)?,
            operation(&shaders::DSSIM_BACKWARD, &backward)?,
        ],
        pair: (&pair).into(),
        gradient: (&gradient).into(),
        sums,
        sum_count,
        color: ColorScale {
            factor: [1.0; 3],
            offset: [0.0; 3],
        },
        _buffers: vec![pair, of_means, gradient],
        _convolutions: vec![],
    })
}
