//! A look at some of a capture's masks: what their numbers mean, and whether the person is in them.

use crate::{
    capture::Capture,
    left_out::{LeftOut, MaskLook, Reason},
    mask::{Mask, MaskFile, MaskRule, Place, fault_of, nonzero},
};
use effigy_core::{io::file::FormatError, random::hash};
use effigy_formats::assumption::Assumption;
use glam::DVec2;
use rayon::prelude::*;
use std::collections::BTreeSet;

/// Masks that are looked at, at most.
const SAMPLE: usize = 16;

/// A mask that is looked at.
struct Looked {
    shot: Shot,
    mask: Result<Mask, FormatError>,
    /// Of the joints in its picture, px.
    joints: Vec<DVec2>,
}

/// A camera and a frame, by index.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Shot {
    camera: usize,
    frame: usize,
}

impl Capture {
    /// Decodes some masks, and decides by them how all are read.
    pub(crate) fn look_at_masks(&mut self) {
        let sample = self.sample();
        let file = |shot: &Shot| {
            let files = self.files_of(shot.camera, shot.frame)?;
            Some((*shot, MaskFile::read(files)))
        };
        let files: Vec<_> = sample.par_iter().filter_map(file).collect();
        let read = files.iter().filter_map(|(_, file)| file.as_ref().ok());
        let places: Vec<&Place> = read.map(|file| &file.place).collect();
        let values = nonzero(places.iter().copied());
        let rule = MaskRule {
            nonzero: values.is_some(),
            inverted: false,
        };
        let mut assumptions = self.alpha(&places);
        let assume = |taken: &str, because| Assumption {
            what: "masks",
            taken: taken.into(),
            because,
        };
        let because = |values| format!("they have {values}");
        assumptions.extend(values.map(|values| assume("all but 0 is the person", because(values))));
        let look = |(shot, file): (Shot, Result<MaskFile, FormatError>)| {
            let joints = self.template.skeleton.joints(&self.frames[shot.frame].pose);
            let joints: Vec<_> = joints.iter().map(|joint| joint.translation).collect();
            Looked {
                mask: file.and_then(|file| file.mask(&self.cameras[shot.camera], rule)),
                joints: self.in_view(shot.camera, &joints),
                shot,
            }
        };
        let mut looked: Vec<Looked> = files.into_par_iter().map(look).collect();
        let inverted = are_inverted(&looked);
        if inverted {
            looked.iter_mut().for_each(Looked::invert);
            let because = format!("all {} that were looked at show it so", looked.len());
            assumptions.push(assume("the person is what is dark", because));
        }
        self.masks = MaskLook {
            count: looked.len(),
            faults: looked.iter().filter_map(|own| self.fault(own)).collect(),
        };
        self.rule = MaskRule { inverted, ..rule };
        self.assumptions.extend(assumptions);
    }

    /// That masks are in an alpha channel.
    fn alpha(&self, places: &[&Place]) -> Vec<Assumption> {
        let files = self.files.iter().flatten();
        let count = files.filter(|own| own.mask == own.picture).count();
        let [taken, because] = match count {
            0 if places.contains(&&Place::Alpha) => [
                "their alpha channel".to_owned(),
                "it is not the same everywhere".to_owned(),
            ],
            0 => return vec![],
            _ => [
                "the pictures' alpha channel".to_owned(),
                format!("{count} pictures have no mask's file"),
            ],
        };
        vec![Assumption {
            what: "masks",
            taken,
            because,
        }]
    }

    /// Some pictures: of each camera in turn, in frames at random.
    fn sample(&self) -> BTreeSet<Shot> {
        let count = self.cameras.len();
        let mut seen = vec![vec![]; count];
        for at in (0..self.files.len()).filter(|&at| self.files[at].is_some()) {
            let [camera, frame] = [at % count, at / count];
            seen[camera].push(Shot { camera, frame });
        }
        seen.retain(|shots| !shots.is_empty());
        if self.pictures() <= SAMPLE {
            return seen.into_iter().flatten().collect();
        }
        let turn = |k: usize| {
            let shots = &seen[k * seen.len().max(SAMPLE) / SAMPLE % seen.len()];
            shots[hash(k as u64) as usize % shots.len()]
        };
        (0..SAMPLE).map(turn).collect()
    }

    fn fault(&self, own: &Looked) -> Option<LeftOut> {
        let Shot { camera, frame } = own.shot;
        let reason = match &own.mask {
            Err(fault) => Reason::Unreadable(fault.clone()),
            Ok(mask) => fault_of(mask, &own.joints)?,
        };
        Some(LeftOut {
            file: self.files_of(camera, frame)?.mask.clone(),
            camera: Some(self.cameras[camera].name.clone()),
            frame: Some(self.frames[frame].number),
            reason,
        })
    }
}

impl Looked {
    fn invert(&mut self) {
        if let Ok(mask) = &mut self.mask {
            mask.person.iter_mut().for_each(|part| *part = 255 - *part);
        }
    }
}

/// Whether all masks that tell have all but the person.
fn are_inverted(looked: &[Looked]) -> bool {
    let mut found = looked.iter().filter_map(|own| {
        let mask = own.mask.as_ref().ok()?;
        match fault_of(mask, &own.joints) {
            Some(Reason::NoBody) => None,
            Some(Reason::InvertedMask) => {
                let person = mask.person.iter().map(|part| 255 - part).collect();
                let other = Mask { person, ..*mask };
                Some(fault_of(&other, &own.joints).is_none())
            }
            _ => Some(false),
        }
    });
    let first = found.next() == Some(true);
    first && found.all(|inverted| inverted)
}
