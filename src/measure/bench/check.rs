//! Compares what a device draws with the f64 reference. In: scenes, and which of them to look at. Out: the worst error and how much
//! of the picture the avatar covers.

use super::{
    backend::Result,
    report::ErrorReport,
    run::{Drawer, Progress},
    scene::Scene,
};
use crate::{
    avatar::Avatar,
    frame::{ALPHA_MIN, Picture},
    measure::{error, flip},
    reference,
};
use std::collections::HashMap;

/// The reference's pictures, each made once, however many settings are compared with it.
pub struct Oracle<'a> {
    avatar: &'a Avatar,
    pictures: HashMap<usize, Picture>,
}

impl<'a> Oracle<'a> {
    /// Of an avatar with everything that it has.
    pub fn new(avatar: &'a Avatar) -> Self {
        Self { avatar, pictures: HashMap::new() }
    }

    /// The picture of the scene with this number: the truth, not what a held pose shows.
    fn picture(&mut self, number: usize, scene: &Scene) -> &Picture {
        self.pictures.entry(number).or_insert_with(|| {
            let truth: Vec<_> = scene.actors.iter().map(|actor| &actor.truth).collect();
            reference::render_scene(self.avatar, &truth, &scene.camera)
        })
    }
}

/// What the checked frames had in common.
#[derive(Clone, Copy, Debug, Default)]
pub struct Checked {
    pub error: Option<ErrorReport>,
    /// Mean number of pixels with an alpha of at least 1/255, as the device drew them.
    pub covered: Option<f64>,
}

/// Draws the scenes with these numbers once more and compares each. With `flip`, that too, which takes seconds a picture.
pub fn check(
    drawer: &mut Drawer,
    scenes: &[Scene],
    numbers: &[usize],
    oracle: &mut Oracle,
    flip: bool,
    progress: Progress,
) -> Result<Checked> {
    let mut checked = Checked::default();
    let mut covered = 0;
    for (at, &number) in numbers.iter().enumerate() {
        progress("comparing with the reference", at, numbers.len());
        // The frame before too: what a frame takes over from it is part of what is compared.
        drawer.draw(&scenes[(number + scenes.len() - 1) % scenes.len()])?;
        drawer.draw(&scenes[number])?;
        let picture = drawer.picture()?;
        covered += picture.pixels.iter().filter(|pixel| f64::from(pixel[3]) >= ALPHA_MIN).count();
        let truth = oracle.picture(number, &scenes[number]);
        let one = report(&error::between(&picture, truth), flip.then(|| flip::between(&picture, truth).covered));
        checked.error = Some(checked.error.map_or(one, |error| worse(error, one)));
    }
    checked.covered = (!numbers.is_empty()).then(|| covered as f64 / numbers.len() as f64);
    Ok(checked)
}

/// In the report's words.
pub(crate) fn report(error: &error::Error, flip: Option<f64>) -> ErrorReport {
    let finite = |db: f64| db.is_finite().then_some(db);
    ErrorReport {
        frames: 1,
        psnr_db: finite(error.covered.psnr_db),
        max_error: error.covered.max_error,
        within_tolerance: error.covered.within_tolerance,
        psnr_db_whole: finite(error.whole.psnr_db),
        max_error_whole: error.whole.max_error,
        flip,
    }
}

/// The worse of each number. A PSNR that is missing is the best there is.
fn worse(a: ErrorReport, b: ErrorReport) -> ErrorReport {
    let lower = |a: Option<f64>, b: Option<f64>| a.into_iter().chain(b).reduce(f64::min);
    ErrorReport {
        frames: a.frames + b.frames,
        psnr_db: lower(a.psnr_db, b.psnr_db),
        max_error: a.max_error.max(b.max_error),
        within_tolerance: a.within_tolerance.min(b.within_tolerance),
        psnr_db_whole: lower(a.psnr_db_whole, b.psnr_db_whole),
        max_error_whole: a.max_error_whole.max(b.max_error_whole),
        flip: a.flip.into_iter().chain(b.flip).reduce(f64::max),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_worst_frame_counts_and_a_perfect_one_does_not() {
        let perfect = ErrorReport {
            frames: 1,
            psnr_db: None,
            max_error: 0.0,
            within_tolerance: 1.0,
            psnr_db_whole: None,
            max_error_whole: 0.0,
            flip: Some(0.0),
        };
        let bad = ErrorReport { psnr_db: Some(40.0), max_error: 0.5, within_tolerance: 0.9, flip: Some(0.1), ..perfect };
        let good = ErrorReport { psnr_db: Some(60.0), max_error: 0.1, within_tolerance: 0.99, flip: Some(0.2), ..perfect };
        assert_eq!(worse(perfect, bad), ErrorReport { frames: 2, ..bad });
        assert_eq!(worse(worse(good, perfect), bad), ErrorReport { frames: 3, flip: Some(0.2), ..bad });
    }
}
