//! Motion in pickles: which dictionaries are people, and which frames.

use super::{
    body::Family,
    fields::{Fields, Table},
    recognise::{is_motion, recognise, rotations},
    timeline::timeline,
    track::{ChainRotations, Track, no_such_person},
};
use crate::{assumption::Assumption, capture::UpAxis, pickle::Value, smpl_joints::BODY};
use effigy_core::io::file::FormatError;
use glam::DVec3;
use std::{cmp::Reverse, collections::BTreeMap};

/// Numbers of SMPL's 24 rotations as matrices.
const MATRICES: usize = 24 * 9;
/// Numbers of SMPL's 24 rotations.
const AXES: usize = 24 * 3;

/// The motion of one of the people in a pickle, those who are seen longest first. `person`: which.
pub fn from_pickle(root: Value, person: usize) -> Result<Track, FormatError> {
    if let Some(global) = root.get("smpl_params_global") {
        let mut track = recognise(&mut Fields::Dictionary(global))?;
        track.up = UpAxis::Said(DVec3::Y);
        return Ok(track);
    }
    let first = root.values().and_then(|mut values| values.next());
    if first.is_some_and(|first| first.get("smpl").is_some()) {
        return from_tracker(root, person);
    }
    let people = motions(root);
    match &people[..] {
        [] => recognise(&mut Fields::Dictionary(root)),
        [only] => recognise(&mut Fields::Dictionary(*only))?.of_person(person),
        _ => from_people(people, person),
    }
}

/// Dictionaries in dictionaries that are looked into, and how many of each depth.
const DEPTH: usize = 3;
const LOOKED_INTO: usize = 4096;

/// The dictionaries of motion that are least deep inside one, or itself. Of several of one person,
/// that which is said to be in the world.
fn motions(root: Value) -> Vec<Value> {
    let is_motion = |value: &Value| is_motion(&Fields::Dictionary(*value));
    let mut level = vec![root];
    for _ in 0..=DEPTH {
        if level.iter().any(is_motion) {
            level.retain(is_motion);
            return level;
        }
        let inner = level.iter().flat_map(|value| {
            let keys = value.keys().into_iter().flatten();
            let values = value.values().into_iter().flatten();
            let in_world = |(key, value): &(Value, Value)| {
                let named = |key: &str| key.contains("world") || key.contains("global");
                key.text().is_some_and(named) && is_motion(value)
            };
            let entries: Vec<(Value, Value)> = keys.zip(values).take(LOOKED_INTO).collect();
            match entries.iter().find(|entry| in_world(entry)) {
                Some((_, world)) => vec![*world],
                None => entries.into_iter().map(|(_, value)| value).collect(),
            }
        });
        level = inner.take(LOOKED_INTO).collect();
    }
    vec![]
}

/// The motion in what ROMP saves of a picture or a video.
pub fn from_romp(
    results: Option<Value>,
    people: Option<Value>,
    person: usize,
) -> Result<Track, FormatError> {
    let tracked = people.filter(|people| people.values().is_some_and(|people| people.len() > 0));
    if let Some(people) = tracked {
        return from_people(people.values().into_iter().flatten().collect(), person);
    }
    let wrong = |found: String| FormatError::metadata("results", found, "smpl_thetas of frames");
    let results = results.ok_or_else(|| wrong("nothing".into()))?;
    // A picture's results are those of a single frame.
    let picture = results.get("smpl_thetas").is_some();
    let frames: Vec<Value> = if picture {
        vec![results]
    } else {
        let frames = results.values();
        frames.ok_or_else(|| wrong(results.describe()))?.collect()
    };
    let mut seen = SeenFrames::new(AXES, results);
    let mut places = vec![];
    for (number, frame) in frames.into_iter().enumerate() {
        let mut fields = Fields::Dictionary(frame);
        let Some(poses) = fields.table(&["smpl_thetas"], &[AXES])? else {
            continue;
        };
        if person >= poses.rows() {
            continue;
        }
        let start = person * AXES;
        seen.add(number, &poses.numbers[start..start + AXES])?;
        let place = fields.table(&["cam_trans"], &[3])?;
        let place = place.filter(|place| person < place.rows());
        places.extend(place.map_or([0.0; 3], |place| {
            let row = place.row(person);
            [row[0], row[1], row[2]]
        }));
    }
    let mut track = seen.track(false, person)?;
    track.translation = Some(Table {
        width: 3,
        numbers: places,
        people: 1,
    });
    track.assumptions.push(Assumption {
        what: "person",
        taken: format!("number {} of each frame", person + 1),
        because: "the file does not say who is who from frame to frame".into(),
    });
    Ok(track)
}

/// Frames in which a person was seen.
struct SeenFrames {
    width: usize,
    numbers: Vec<f32>,
    frames: Vec<f32>,
    most_numbers: usize,
}

impl SeenFrames {
    fn new(width: usize, file: Value) -> Self {
        Self {
            width,
            numbers: vec![],
            frames: vec![],
            most_numbers: file.most_numbers(),
        }
    }

    fn add(&mut self, frame: usize, row: &[f32]) -> Result<(), FormatError> {
        self.numbers.extend(row);
        self.frames.push(frame as f32);
        if self.numbers.len() <= self.most_numbers {
            return Ok(());
        }
        Err(FormatError::container(
            "more numbers of poses than the file holds",
            "each array once",
        ))
    }

    fn track(self, matrices: bool, person: usize) -> Result<Track, FormatError> {
        if self.frames.is_empty() {
            return Err(FormatError::container(
                format!("no frame with person {}", person + 1),
                "fewer people",
            ));
        }
        let table = Table {
            width: self.width,
            numbers: self.numbers,
            people: 1,
        };
        let part = ChainRotations {
            table: table.into(),
            matrices,
            first: 0,
            joints: 0..BODY,
        };
        Ok(Track {
            timeline: Some(timeline(&self.frames, "frames")?),
            up: UpAxis::Said(DVec3::NEG_Y),
            assumptions: vec![Assumption {
                what: "axes",
                taken: "the camera's, which is taken to be level".into(),
                because: "results are seen from the camera".into(),
            }],
            ..Track::of_parts(Family::Smpl, vec![part])
        })
    }
}

/// Says which of several people was taken.
fn chosen(person: usize, people: usize) -> Assumption {
    Assumption {
        what: "person",
        taken: format!("{} of {people}", person + 1),
        because: "people who are seen longer come first".into(),
    }
}

/// One of the people whose motions are these.
fn from_people(mut people: Vec<Value>, person: usize) -> Result<Track, FormatError> {
    let frames = |value: &Value| {
        let poses = rotations(&Fields::Dictionary(*value)).and_then(|name| value.get(name));
        poses.map_or(0, |poses| match poses.shape() {
            Some(shape) => shape.first().copied().unwrap_or_default(),
            None => poses.items().map_or(0, |items| items.len()),
        })
    };
    people.sort_by_key(|value| Reverse(frames(value)));
    let value = people.get(person);
    let value = value.ok_or_else(|| no_such_person(person, people.len()))?;
    let mut track = recognise(&mut Fields::Dictionary(*value))?;
    if people.len() > 1 {
        track.assumptions.push(chosen(person, people.len()));
    }
    Ok(track)
}

/// A dictionary of frames, as PHALP and 4D-Humans write: of each, a list of people's numbers and
/// one of their parameters.
fn from_tracker(root: Value, person: usize) -> Result<Track, FormatError> {
    let frames: Vec<Value> = root.values().into_iter().flatten().collect();
    let identities = |frame: &Value| -> Vec<i64> {
        let items = frame.get("tid").and_then(Value::items);
        let numbers = items.into_iter().flatten().filter_map(Value::number);
        numbers.map(|number| number as i64).collect()
    };
    let mut times: BTreeMap<i64, usize> = BTreeMap::new();
    for identity in frames.iter().flat_map(identities) {
        *times.entry(identity).or_default() += 1;
    }
    let mut people: Vec<i64> = times.keys().copied().collect();
    people.sort_by_key(|identity| Reverse(times[identity]));
    let identity = people.get(person).copied();
    let identity = identity.ok_or_else(|| no_such_person(person, people.len()))?;
    let mut seen = SeenFrames::new(MATRICES, root);
    for (number, frame) in frames.iter().enumerate() {
        let Some(at) = identities(frame)
            .iter()
            .position(|&found| found == identity)
        else {
            continue;
        };
        let smpl = frame.get("smpl").and_then(Value::items);
        let smpl = smpl.and_then(|mut items| items.nth(at));
        let smpl = smpl.ok_or_else(|| {
            FormatError::metadata("smpl", format!("none of person {identity}"), "parameters")
        })?;
        let mut row = Vec::with_capacity(MATRICES);
        for (name, count) in [("global_orient", 9), ("body_pose", MATRICES - 9)] {
            let part = smpl.get(name);
            let part = part.ok_or_else(|| FormatError::metadata(name, "nothing", "matrices"))?;
            let part = part.numbers(name)?;
            if part.numbers.len() != count {
                let found = format!("the shape {:?}", part.shape);
                return Err(FormatError::metadata(
                    name,
                    found,
                    format!("{count} numbers"),
                ));
            }
            row.extend(part.numbers);
        }
        seen.add(number, &row)?;
    }
    let mut track = seen.track(true, person)?;
    if people.len() > 1 {
        track.assumptions.push(chosen(person, people.len()));
    }
    track.assumptions.push(Assumption {
        what: "place",
        taken: "the same in each frame".into(),
        because: "the distance in the file is that of a made-up focal length".into(),
    });
    Ok(track)
}
