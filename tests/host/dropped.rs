//! Files that are dropped on the window: which are opened, and what for.

use crate::common::{self, Sizes};
use effigy_app::{
    dropped::{DroppedContent, OpenFiles, OpenedFile},
    file_list::LoadedAvatar,
    scene::ViewerScene,
};
use effigy_core::avatar::{Avatar, Clip};
use std::path::{Path, PathBuf};

/// Opens files by their names alone: `NAME.motion` and `NAME.avatar`. All others, and those that
/// begin with "broken", are errors.
struct ByName;

fn avatar(name: &str) -> Avatar {
    let sizes = Sizes {
        gaussians: 8,
        ..Sizes::default()
    };
    Avatar {
        name: name.into(),
        ..common::avatar(1, sizes)
    }
}

fn clip(name: &str, avatar: &Avatar) -> Clip {
    Clip {
        name: name.into(),
        ..common::clip(1, avatar, 31)
    }
}

impl OpenFiles for ByName {
    fn is_motion(&self, path: &Path) -> bool {
        path.extension().is_some_and(|ending| ending == "motion")
    }

    fn avatar(&self, path: &Path) -> anyhow::Result<OpenedFile<LoadedAvatar>> {
        let name = path.to_string_lossy();
        anyhow::ensure!(name.ends_with(".avatar"), "{name} is no avatar");
        let avatar = avatar(&name);
        Ok(OpenedFile {
            content: LoadedAvatar {
                clips: vec![clip("its own", &avatar)],
                avatar,
            },
            notes: vec![format!("{name} was read")],
        })
    }

    fn clip(&self, path: &Path, avatar: &Avatar) -> anyhow::Result<OpenedFile<Clip>> {
        let name = path.to_string_lossy();
        anyhow::ensure!(!name.starts_with("broken"), "{name} is broken");
        Ok(OpenedFile {
            content: clip(&format!("{name} for {}", avatar.name), avatar),
            notes: vec![],
        })
    }
}

fn read(files: &[&str]) -> DroppedContent {
    let files: Vec<PathBuf> = files.iter().map(PathBuf::from).collect();
    DroppedContent::read(&files, &avatar("shown"), &ByName)
}

fn names(clips: &[Clip]) -> Vec<&str> {
    clips.iter().map(|clip| clip.name.as_str()).collect()
}

fn motion_is_for_the_avatar_that_is_shown() {
    let content = read(&["a.motion", "broken.motion", "b.motion"]);
    assert!(content.avatar.is_none() && content.failed);
    let expected = ["a.motion for shown", "b.motion for shown"];
    assert_eq!(names(&content.clips), expected);
    assert_eq!(content.messages, ["broken.motion is broken"]);
}

fn motion_beside_an_avatar_is_for_that_avatar() {
    let content = read(&["a.motion", "one.avatar", "two.avatar"]);
    let new = content.avatar.expect("an avatar was dropped");
    assert_eq!(new.path, Path::new("two.avatar"));
    let expected = ["a.motion for two.avatar", "its own"];
    assert_eq!(names(&new.loaded.clips), expected);
    assert!(content.clips.is_empty() && !content.failed);
    assert_eq!(content.messages, ["two.avatar was read"]);
}

fn motion_beside_a_broken_avatar_is_for_the_one_that_is_shown() {
    let content = read(&["letter.txt", "a.motion"]);
    assert!(content.avatar.is_none());
    assert_eq!(names(&content.clips), ["a.motion for shown"]);
    assert_eq!(content.messages, ["letter.txt is no avatar"]);
}

fn clips_that_are_added_play_from_the_first_of_them() {
    const SIZE: [u32; 2] = [640, 480];
    let body = avatar("body");
    let own = clip("its own", &body);
    let new = ["b", "c"].map(|name| clip(name, &body)).to_vec();
    let mut scene = ViewerScene::new(body, vec![own], [0.5; 3], SIZE, 0.0);
    scene.act(effigy_app::action::Action::PlayOrPause, 0.25, SIZE);
    scene.add_clips(vec![], 0.5);
    assert_eq!(scene.advance(0.5, SIZE).position.clip, 0);
    assert!(!scene.is_moving(), "nothing was added");
    scene.add_clips(new, 0.5);
    let names = scene.playback().tracks().iter().map(|track| &track.name);
    assert_eq!(names.collect::<Vec<_>>(), ["its own", "b", "c"]);
    let position = scene.advance(0.75, SIZE).position;
    assert!(position.clip == 1 && (position.time - 0.25).abs() < 1e-9);
}

tests! {
    motion_is_for_the_avatar_that_is_shown,
    motion_beside_an_avatar_is_for_that_avatar,
    motion_beside_a_broken_avatar_is_for_the_one_that_is_shown,
    clips_that_are_added_play_from_the_first_of_them,
}
