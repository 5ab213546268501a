//! The full check of a capture: every picture is decoded, and held against the pose.

use crate::{
    capture::Capture,
    decode::colors,
    left_out::{Omission, OmissionReason},
    mask::{MaskFile, fault_of},
    template::BODY,
};
use glam::{DVec2, DVec3};
use rayon::prelude::*;
use std::sync::atomic::{AtomicUsize, Ordering};

impl Capture {
    /// Decodes every picture and mask and returns those that can't be used: cut files, masks that
    /// are empty or inverted or do not fit the pose, pictures and cameras that see nothing of the
    /// body's joints. `progress` is called with the pictures done and all there are, from any
    /// thread.
    pub fn check(&self, progress: &(dyn Fn(usize, usize) + Sync)) -> Vec<Omission> {
        let cameras = self.cameras.len();
        let all = self.pictures();
        let done = AtomicUsize::new(0);
        let mut found: Vec<Omission> = Vec::new();
        let joints: Vec<Vec<DVec3>> = (0..self.frames.len())
            .map(|frame| self.body_joints(frame))
            .collect();
        let mut blind = vec![false; cameras];
        for (camera, blind) in blind.iter_mut().enumerate() {
            let sees = |frame: &usize| !self.in_view(camera, &joints[*frame]).is_empty();
            let mut own = (0..self.frames.len()).filter(|&frame| self.has(camera, frame));
            let any = self
                .frames
                .iter()
                .enumerate()
                .any(|(at, _)| self.has(camera, at));
            *blind = any && !own.any(|frame| sees(&frame));
            if *blind {
                found.push(Omission {
                    file: self.folder.clone(),
                    camera: Some(self.cameras[camera].name.clone()),
                    frame: None,
                    reason: OmissionReason::NoBody,
                });
            }
        }
        let of_pictures: Vec<Omission> = (0..self.frames.len() * cameras)
            .into_par_iter()
            .filter_map(|at| {
                let (frame, camera) = (at / cameras, at % cameras);
                let files = self.files_of(camera, frame)?;
                let own = &self.cameras[camera];
                let colors = colors(&files.picture).and_then(|colors| colors.of(own, [0; 3]));
                let mask =
                    MaskFile::read(files).and_then(|file| file.mask(own, self.rules[camera]));
                progress(done.fetch_add(1, Ordering::Relaxed) + 1, all);
                let leave_out = |file: &std::path::Path, reason| {
                    Some(Omission {
                        file: file.into(),
                        camera: Some(own.name.clone()),
                        frame: Some(self.frames[frame].number),
                        reason,
                    })
                };
                match (colors, mask) {
                    (Err(fault), _) => leave_out(&files.picture, OmissionReason::Unreadable(fault)),
                    (_, Err(fault)) => leave_out(&files.mask, OmissionReason::Unreadable(fault)),
                    _ if blind[camera] => None,
                    (_, Ok(mask)) => {
                        let places = self.in_view(camera, &joints[frame]);
                        let reason = fault_of(&mask, &places)?;
                        leave_out(&files.mask, reason)
                    }
                }
            })
            .collect();
        found.extend(of_pictures);
        found
    }

    /// Where the joints of a frame's body are, metres: those of hands, which masks may lack, would be
    /// more than all others.
    pub(crate) fn body_joints(&self, frame: usize) -> Vec<DVec3> {
        let joints = self.template.skeleton.joints(&self.frames[frame].pose);
        let body = joints.iter().take(BODY);
        body.map(|joint| joint.translation).collect()
    }

    /// Where points are in a camera's picture, px, without those outside.
    pub(crate) fn in_view(&self, camera: usize, points: &[DVec3]) -> Vec<DVec2> {
        let camera = &self.cameras[camera].camera;
        let [width, height] = camera.size.map(f64::from);
        let mut places = Vec::new();
        for point in points {
            let seen = camera.view.transform_point3(*point);
            let place = camera.project(seen);
            let inside = place.x >= 0.0 && place.y >= 0.0 && place.x < width && place.y < height;
            if seen.z > camera.near && inside {
                places.push(place);
            }
        }
        places
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mask::Mask;

    fn fault(mask: impl Fn(f64, f64) -> bool) -> Option<OmissionReason> {
        let side = 20;
        let mask = Mask {
            size: [side; 2],
            highest: 255,
            person: (0..400)
                .map(|at| 255 * u8::from(mask(f64::from(at % side), f64::from(at / side))))
                .collect(),
        };
        let places: Vec<DVec2> = (0..6)
            .map(|k| DVec2::new(10.0, 7.0 + f64::from(k)))
            .collect();
        fault_of(&mask, &places)
    }

    #[test]
    fn masks_are_held_against_the_joints() {
        let disc = |x: f64, y: f64| (x - 10.0).hypot(y - 10.0) < 6.0;
        assert_eq!(fault(disc), None);
        assert_eq!(
            fault(|x, y| !disc(x, y)),
            Some(OmissionReason::InvertedMask)
        );
        assert_eq!(fault(|_, _| true), Some(OmissionReason::FullMask));
        assert_eq!(
            fault(|_, _| false),
            Some(OmissionReason::EmptyMask { highest: 255 })
        );
        let aside = |x: f64, y: f64| disc(x + 6.0, y);
        assert!(matches!(
            fault(aside),
            None | Some(OmissionReason::Astray { .. })
        ));
        assert!(matches!(
            fault(|x, _| x < 4.0),
            Some(OmissionReason::Astray { inside: 0, of: 6 })
        ));
    }
}
