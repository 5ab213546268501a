//! Whom a command draws: copies of one avatar, or the different people of a scene file.

use crate::source::{PoseProjection, Source};
use anyhow::{Context, ensure};
use effigy_core::{
    avatar::{Avatar, motion::Player},
    frame::{AvatarId, Person},
    io::text,
    reference,
    scene::{AvatarBounds, Posed},
};
use effigy_measure::in_rows;
use glam::{DAffine3, DQuat, DVec3};
use serde::Deserialize;
use std::{
    path::{Path, PathBuf},
    rc::Rc,
};

/// What a scene file's name ends with.
const ENDING: &str = ".scene.json";
/// The most people of a scene.
const PEOPLE_MAX: usize = 1024;
/// How far from the middle somebody may stand, metres, and how large or small they may be.
const FAR: f64 = 1000.0;
const SCALES: std::ops::RangeInclusive<f64> = 0.01..=100.0;

/// Somebody of a scene.
struct Member {
    /// Index of the avatar.
    avatar: usize,
    /// Copies share one.
    player: Rc<Player>,
    /// Where in the clip the scene begins for them, seconds.
    start: f64,
    /// Whether the clip begins again where it ends.
    repeats: bool,
    placed: DAffine3,
}

/// Avatars, and people of them.
pub struct Cast {
    /// Each avatar once.
    pub avatars: Vec<Avatar>,
    bounds: Vec<AvatarBounds>,
    members: Vec<Member>,
}

/// A scene file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct SceneFile {
    people: Vec<PersonEntry>,
}

/// A person of a scene file. Paths are relative to its folder.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct PersonEntry {
    /// Without, the built-in demo.
    avatar: Option<PathBuf>,
    /// Without, the avatar's own or the built-in demo's.
    motion: Option<PathBuf>,
    /// Where in the clip the scene begins, seconds.
    #[serde(default)]
    start: f64,
    /// Metres from the middle of the scene: x to the right, y up, z to the viewer.
    #[serde(default)]
    at: [f64; 3],
    /// Turn about the vertical axis, degrees, to the person's own left.
    #[serde(default)]
    turn: f64,
    #[serde(default = "unscaled")]
    scale: f64,
}

fn unscaled() -> f64 {
    1.0
}

impl PersonEntry {
    fn check(&self) -> anyhow::Result<()> {
        let numbers = self.at.iter().chain([&self.start, &self.turn]);
        ensure!(
            numbers.into_iter().all(|number| number.is_finite())
                && self.at.iter().all(|metres| metres.abs() <= FAR),
            "`at` is {:?}, `start` {} and `turn` {}: expected numbers, and places up to {FAR} m away",
            self.at,
            self.start,
            self.turn
        );
        ensure!(
            SCALES.contains(&self.scale),
            "`scale` is {}, expected {} to {}",
            self.scale,
            SCALES.start(),
            SCALES.end()
        );
        Ok(())
    }

    fn placed(&self) -> DAffine3 {
        let turn = DQuat::from_rotation_y(self.turn.to_radians());
        let scale = DVec3::splat(self.scale);
        DAffine3::from_scale_rotation_translation(scale, turn, self.at.into())
    }
}

impl Cast {
    /// Whom a command's arguments name: `count` copies of an avatar, or a scene's people.
    pub fn load(source: &Source, count: usize) -> anyhow::Result<Self> {
        match source.avatar.as_deref().filter(|path| is_scene(path)) {
            Some(path) => {
                ensure!(
                    source.motion.is_empty() && source.up.is_none() && count == 1,
                    "{} says who is there and what moves them: leave out --motion, --up and --count",
                    path.display()
                );
                Self::read(path, source.project)
                    .with_context(|| format!("{} is no scene that can be drawn", path.display()))
            }
            None => {
                let (avatar, player) = source.load_player()?;
                Ok(Self::copies(avatar, player, count))
            }
        }
    }

    /// Copies of an avatar in a row or several, their times spread over the clip.
    fn copies(avatar: Avatar, player: Player, count: usize) -> Self {
        let duration = player.clip().duration();
        let player = Rc::new(player);
        let member = |number: usize| Member {
            avatar: 0,
            player: player.clone(),
            start: duration * number as f64 / count as f64,
            // The first keeps the time that was asked for, even past the clip's end.
            repeats: number > 0,
            placed: in_rows(number, count),
        };
        Self {
            bounds: vec![AvatarBounds::new(&avatar)],
            avatars: vec![avatar],
            members: (0..count).map(member).collect(),
        }
    }

    fn read(path: &Path, project: PoseProjection) -> anyhow::Result<Self> {
        let bytes = std::fs::read(path)?;
        let file: SceneFile = serde_json::from_slice(&text::utf8(&bytes))?;
        let people = file.people;
        ensure!(
            (1..=PEOPLE_MAX).contains(&people.len()),
            "it has {} people, expected 1 to {PEOPLE_MAX}",
            people.len()
        );
        let folder = path.parent().unwrap_or(Path::new(""));
        let mut cast = Self {
            avatars: vec![],
            bounds: vec![],
            members: vec![],
        };
        let mut files: Vec<Option<PathBuf>> = vec![];
        for (number, person) in people.iter().enumerate() {
            let member = cast
                .member(person, folder, project, &mut files)
                .with_context(|| format!("person {number}"))?;
            cast.members.push(member);
        }
        Ok(cast)
    }

    /// Reads a person, and their avatar if it is the first of it. `files`: of the avatars so far.
    fn member(
        &mut self,
        person: &PersonEntry,
        folder: &Path,
        project: PoseProjection,
        files: &mut Vec<Option<PathBuf>>,
    ) -> anyhow::Result<Member> {
        person.check()?;
        let avatar = person.avatar.as_ref().map(|path| folder.join(path));
        if let Some(path) = &avatar {
            ensure!(
                !is_scene(path),
                "{} is a scene: a person has an avatar",
                path.display()
            );
        }
        let source = Source {
            motion: person.motion.iter().map(|path| folder.join(path)).collect(),
            avatar: avatar.clone(),
            project,
            ..Source::default()
        };
        let known = files.iter().position(|file| *file == avatar);
        let (at, player) = match known {
            Some(at) => (at, source.players(&self.avatars[at])?.into_iter().next()),
            None => {
                let (read, player) = source.load_player()?;
                self.bounds.push(AvatarBounds::new(&read));
                self.avatars.push(read);
                files.push(avatar);
                (files.len() - 1, Some(player))
            }
        };
        Ok(Member {
            avatar: at,
            player: player.context("there is no clip")?.into(),
            start: person.start,
            repeats: true,
            placed: person.placed(),
        })
    }

    /// The first person's clip, which has the scene's rate and length.
    pub fn player(&self) -> &Player {
        &self.members[0].player
    }

    /// How many people there are.
    pub fn len(&self) -> usize {
        self.members.len()
    }

    /// The one avatar that moves, if there is nobody else.
    pub fn is_one_person(&self) -> bool {
        self.members.len() == 1 && !self.is_static()
    }

    /// Whether nobody moves.
    pub fn is_static(&self) -> bool {
        self.avatars.iter().all(Avatar::is_static)
    }

    /// Everybody at a time of the scene, seconds.
    pub fn posed(&self, seconds: f64) -> Vec<Posed> {
        let posed = |member: &Member| {
            let duration = member.player.clip().duration();
            let mut time = seconds + member.start;
            if member.repeats && duration > 0.0 {
                time = time.rem_euclid(duration);
            }
            let pose = member.player.pose(time);
            Posed::new(&self.avatars[member.avatar], &pose).placed(member.placed)
        };
        self.members.iter().map(posed).collect()
    }

    /// Everybody with their avatar and its bounds, as the reference draws them.
    pub fn reference<'a>(&'a self, posed: &'a [Posed]) -> Vec<reference::Person<'a>> {
        let members = self.members.iter().zip(posed);
        let person = members.map(|(member, posed)| reference::Person {
            avatar: &self.avatars[member.avatar],
            posed,
        });
        person.collect()
    }

    /// The bounds of everybody's avatar.
    pub fn bounds(&self) -> impl Iterator<Item = &AvatarBounds> {
        self.members.iter().map(|own| &self.bounds[own.avatar])
    }

    /// Everybody as a renderer draws them that holds the avatars by these names.
    pub fn people<'a>(&self, posed: &'a [Posed], ids: &[AvatarId]) -> Vec<Person<'a>> {
        let members = self.members.iter().zip(posed);
        let person = members.map(|(member, posed)| Person {
            avatar: ids[member.avatar],
            posed,
        });
        person.collect()
    }
}

/// Whether a path names a scene.
pub fn is_scene(path: &Path) -> bool {
    let name = path.file_name().map(|name| name.to_string_lossy());
    name.is_some_and(|name| name.to_lowercase().ends_with(ENDING))
}
