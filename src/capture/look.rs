//! A look at some of a capture's masks: what their numbers mean, and whether the person is in them.

use crate::{
    capture::Capture,
    left_out::{MaskLook, Omission, OmissionReason},
    mask::{Mask, MaskFile, MaskSource, fault_of, nonzero},
};
use effigy_core::{io::file::FormatError, random::hash};
use effigy_formats::assumption::Assumption;
use glam::DVec2;
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

/// Masks that are looked at, at least, if there are so many: one of every camera.
const SAMPLE: usize = 16;
/// Masks that are looked at, at most, where cameras' masks don't differ in kind: so many cameras are
/// more than what takes a second.
const MOST: usize = 64;
/// Masks of a camera that are enough to tell whether all of its are inverted.
const FEW: usize = 4;
/// Cameras that a sentence names, at most.
const NAMED: usize = 6;

/// A mask's file, and whose it is.
struct OpenedMask {
    shot: MaskIndex,
    file: Result<MaskFile, FormatError>,
}

/// A mask that is looked at.
struct InspectedMask {
    shot: MaskIndex,
    mask: Result<Mask, FormatError>,
    /// Of the joints in its picture, px.
    joints: Vec<DVec2>,
}

/// A camera and a frame, by index.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct MaskIndex {
    camera: usize,
    frame: usize,
}

impl Capture {
    /// Decodes some masks, and decides by them how all are read: those of each camera in one way.
    pub(crate) fn look_at_masks(&mut self) {
        let sample = self.sample();
        let mut opened = self.opened(&sample);
        let mut numbers = numbers_of(&opened);
        if differ(&numbers) {
            let looked: BTreeSet<usize> = sample.iter().map(|shot| shot.camera).collect();
            let rest = self.spread(1, |camera| !looked.contains(&camera));
            opened.extend(self.opened(&rest));
            numbers = numbers_of(&opened);
        }
        let mut assumptions = self.alpha(&opened);
        assumptions.extend(self.numbers(&numbers));
        let is_common = !differ(&numbers);
        let common = numbers.values().any(Option::is_some) && is_common;
        for (camera, rule) in self.rules.iter_mut().enumerate() {
            let own = numbers.get(&camera).filter(|_| !is_common);
            rule.nonzero = own.map_or(common, Option::is_some);
        }
        let mut looked: Vec<InspectedMask> = opened
            .into_par_iter()
            .map(|opened| self.look(opened))
            .collect();
        assumptions.extend(self.turn_inverted(&mut looked));
        self.masks = MaskLook {
            count: looked.len(),
            faults: looked.iter().filter_map(|own| self.fault(own)).collect(),
        };
        self.assumptions.extend(assumptions);
    }

    fn opened(&self, shots: &BTreeSet<MaskIndex>) -> Vec<OpenedMask> {
        let open = |&shot: &MaskIndex| {
            let file = MaskFile::read(self.files_of(shot.camera, shot.frame)?);
            Some(OpenedMask { shot, file })
        };
        shots.par_iter().filter_map(open).collect()
    }

    fn look(&self, OpenedMask { shot, file }: OpenedMask) -> InspectedMask {
        let joints = self.body_joints(shot.frame);
        let camera = &self.cameras[shot.camera];
        InspectedMask {
            mask: file.and_then(|file| file.mask(camera, self.rules[shot.camera])),
            joints: self.in_view(shot.camera, &joints),
            shot,
        }
    }

    /// That numbers are classes, of all cameras or of some.
    fn numbers(&self, numbers: &BTreeMap<usize, Option<String>>) -> Option<Assumption> {
        let values = numbers.values().find_map(Option::as_ref)?;
        let [taken, because] = if differ(numbers) {
            let own =
                |(camera, values): (&usize, &Option<String>)| values.is_some().then_some(*camera);
            let own = self.named(numbers.iter().filter_map(own));
            [
                format!("all but 0 is the person for {own}, what is above 128 of 255 for others"),
                format!("those have {values}, and others up to white"),
            ]
        } else {
            let all = "all but 0 is the person".to_owned();
            [all, format!("they have {values}")]
        };
        Some(Assumption {
            what: "masks",
            taken,
            because,
        })
    }

    /// Turns the masks of cameras around that all have all but the person.
    fn turn_inverted(&mut self, looked: &mut Vec<InspectedMask>) -> Option<Assumption> {
        let is_all = are_inverted(looked.iter());
        let mut of_some = inverted_cameras(looked);
        if !is_all && !of_some.is_empty() {
            // One mask among sound ones may be wrong by itself.
            let mut more = self.spread(FEW, |camera| of_some.contains(&camera));
            more.retain(|shot| looked.iter().all(|own| own.shot != *shot));
            let more = self.opened(&more).into_iter();
            looked.extend(more.map(|opened| self.look(opened)));
            of_some = inverted_cameras(looked);
        }
        if of_some.is_empty() {
            return None;
        }
        for (camera, rule) in self.rules.iter_mut().enumerate() {
            rule.inverted = is_all || of_some.contains(&camera);
        }
        for own in looked.iter_mut() {
            if self.rules[own.shot.camera].inverted {
                own.invert();
            }
        }
        let [taken, because] = if is_all {
            let all = "the person is what is dark".to_owned();
            [
                all,
                format!("all {} that were looked at show it so", looked.len()),
            ]
        } else {
            let own = self.named(of_some.into_iter());
            let because = "all of theirs that were looked at show it so".to_owned();
            [format!("the person is what is dark for {own}"), because]
        };
        Some(Assumption {
            what: "masks",
            taken,
            because,
        })
    }

    /// The names of some cameras, for a sentence.
    fn named(&self, cameras: impl Iterator<Item = usize>) -> String {
        let names: Vec<&str> = cameras.map(|k| self.cameras[k].name.as_str()).collect();
        match names.len().checked_sub(NAMED) {
            None | Some(0) => names.join(", "),
            Some(more) => format!("{} and {more} more", names[..NAMED].join(", ")),
        }
    }

    /// That masks are in an alpha channel.
    fn alpha(&self, opened: &[OpenedMask]) -> Vec<Assumption> {
        let read = opened.iter().filter_map(|own| own.file.as_ref().ok());
        let has_alpha = read
            .map(|file| &file.place)
            .any(|it| *it == MaskSource::Alpha);
        let files = self.files.iter().flatten();
        let count = files.filter(|own| own.mask == own.picture).count();
        let [taken, because] = match count {
            0 if has_alpha => [
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

    /// The pictures of each camera that has any.
    fn shots(&self) -> Vec<Vec<MaskIndex>> {
        let count = self.cameras.len();
        let mut seen = vec![vec![]; count];
        for at in (0..self.files.len()).filter(|&at| self.files[at].is_some()) {
            let [camera, frame] = [at % count, at / count];
            seen[camera].push(MaskIndex { camera, frame });
        }
        seen.retain(|shots| !shots.is_empty());
        seen
    }

    /// A few pictures of each of some cameras, from first to last.
    fn spread(&self, few: usize, of: impl Fn(usize) -> bool) -> BTreeSet<MaskIndex> {
        let mut seen = self.shots();
        seen.retain(|shots| of(shots[0].camera));
        let few = |shots: &Vec<MaskIndex>| {
            let at = |k| shots[k * shots.len() / few];
            (0..few).map(at).collect::<Vec<MaskIndex>>()
        };
        seen.iter().flat_map(few).collect()
    }

    /// Some pictures: of each camera in turn, in frames at random.
    fn sample(&self) -> BTreeSet<MaskIndex> {
        let seen = self.shots();
        if self.pictures() <= SAMPLE {
            return seen.into_iter().flatten().collect();
        }
        let count = seen.len().clamp(SAMPLE, MOST);
        let turn = |k: usize| {
            let shots = &seen[k * seen.len().max(count) / count % seen.len()];
            shots[hash(k as u64) as usize % shots.len()]
        };
        (0..count).map(turn).collect()
    }

    fn fault(&self, own: &InspectedMask) -> Option<Omission> {
        let MaskIndex { camera, frame } = own.shot;
        let reason = match &own.mask {
            Err(fault) => OmissionReason::Unreadable(fault.clone()),
            Ok(mask) => fault_of(mask, &own.joints)?,
        };
        Some(Omission {
            file: self.files_of(camera, frame)?.mask.clone(),
            camera: Some(self.cameras[camera].name.clone()),
            frame: Some(self.frames[frame].number),
            reason,
        })
    }
}

impl InspectedMask {
    fn invert(&mut self) {
        if let Ok(mask) = &mut self.mask {
            mask.person.iter_mut().for_each(|part| *part = 255 - *part);
        }
    }
}

/// The values of cameras' masks that are classes, see [`nonzero`]; None for a camera whose masks say
/// how much of a pixel is the person. Cameras whose masks tell neither are left out.
fn numbers_of(opened: &[OpenedMask]) -> BTreeMap<usize, Option<String>> {
    let mut places: BTreeMap<usize, Vec<&MaskSource>> = BTreeMap::new();
    for own in opened {
        if let Ok(file) = &own.file
            && file.place.tells()
        {
            places.entry(own.shot.camera).or_default().push(&file.place);
        }
    }
    let places = places.into_iter();
    places
        .map(|(camera, own)| (camera, nonzero(own.into_iter())))
        .collect()
}

/// Whether some cameras' masks are classes and others' are not.
fn differ(numbers: &BTreeMap<usize, Option<String>>) -> bool {
    let mut are_classes = numbers.values().map(Option::is_some);
    let first = are_classes.next();
    are_classes.any(|own| Some(own) != first)
}

/// The cameras whose looked at masks are inverted.
fn inverted_cameras(looked: &[InspectedMask]) -> BTreeSet<usize> {
    let mut of_cameras: BTreeMap<usize, Vec<&InspectedMask>> = BTreeMap::new();
    for own in looked {
        of_cameras.entry(own.shot.camera).or_default().push(own);
    }
    of_cameras.retain(|_, own| are_inverted(own.iter().copied()));
    of_cameras.into_keys().collect()
}

/// Whether all masks that tell have all but the person.
fn are_inverted<'a>(looked: impl Iterator<Item = &'a InspectedMask>) -> bool {
    let mut found = looked.filter_map(|own| {
        let mask = own.mask.as_ref().ok()?;
        match fault_of(mask, &own.joints) {
            Some(OmissionReason::NoBody) => None,
            Some(OmissionReason::InvertedMask) => {
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
